//! Retentive data as those who run the CPU meet it: handed out between two scans, taken back before the start, lost or deleted.

use super::Cpu;
use crate::communication::Requester;
use crate::interrupts::{Coming, Interrupt};
use crate::mode::OperatingMode;
use crate::retain::{self, Adoption, Refusal, Restored, RetainImage, RetentiveAreas};
use crate::start_information::StartInformation;

/// Memory reset started by a programming device, and automatically; and done.
const MEMORY_RESET: u16 = 0x4307;
const MEMORY_RESET_AUTOMATIC: u16 = 0x4309;
const MEMORY_RESET_DONE: u16 = 0x430E;
/// Power on with the data that was kept.
const POWER_ON: u16 = 0x4300;
/// Backup voltage, among the events of the power supply.
const BACKUP_VOLTAGE: u8 = 0x22;

/// Why there is no retentive data where there was some.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DataLoss {
    /// It cannot be read.
    Damaged,
    /// It belongs to a program with other data blocks.
    OtherProgram,
}

impl DataLoss {
    /// How the entry of the diagnostic buffer says it: its data ID.
    fn data_id(self) -> u16 {
        match self {
            Self::Damaged => 1,
            Self::OtherProgram => 2,
        }
    }
}

impl Cpu {
    /// The retentive data, if it has changed since it was last handed out; between two scans only.
    ///
    /// In HOLD, and after a STOP from outside in the middle of a scan, there is none until a scan or startup is whole again.
    /// What the statements before an error or SFC 46 wrote counts, as the STOP that they led to does.
    pub fn retain_image(&mut self) -> Option<&RetainImage> {
        if self.torn || self.pause.is_some() || matches!(self.mode, OperatingMode::Hold | OperatingMode::Startup) {
            return None;
        }
        self.keeper.image(&self.machine, &self.system, &self.settings.retain, &self.declarations, self.cycle.number)
    }

    /// Sets what is retentive beside the data blocks.
    pub fn set_retentive_areas(&mut self, areas: RetentiveAreas) {
        self.settings.retain = areas;
        self.keeper.forget();
    }

    /// Takes retentive data back, as at power on: all else begins anew, and the restart that follows clears what it clears.
    /// The CPU goes to STOP first.
    ///
    /// # Errors
    /// The image is damaged or belongs to another program. Then no data changes, and the diagnostic buffer has an entry.
    pub fn restore(&mut self, image: &RetainImage, adoption: Adoption) -> Result<Restored, Refusal> {
        self.stop();
        let judged = retain::judge(image, adoption, &self.machine, &self.declarations);
        match judged {
            Ok(judged) => {
                self.clear_work_memory();
                self.interrupted = None;
                self.warm_demanded = true;
                let restored = judged.put(&mut self.machine, &mut self.system, &self.settings.retain);
                self.torn = false;
                self.keeper.forget();
                self.log(StartInformation { event: POWER_ON, ..StartInformation::default() }, None);
                Ok(restored)
            }
            Err(refusal) => {
                self.retentive_data_lost(match refusal {
                    Refusal::Damaged => DataLoss::Damaged,
                    Refusal::OtherProgram { .. } => DataLoss::OtherProgram,
                });
                Err(refusal)
            }
        }
    }

    /// Notes that there was retentive data and that it cannot be used: the CPU has its initial values, as after a memory reset.
    pub fn retentive_data_lost(&mut self, loss: DataLoss) {
        for event in [MEMORY_RESET_AUTOMATIC, MEMORY_RESET_DONE] {
            self.log(StartInformation { event, data_id: loss.data_id(), ..StartInformation::default() }, None);
        }
    }

    /// Retentive data cannot be kept from now on: no backup voltage, OB 81. The CPU goes on also without it.
    pub fn backup_failed(&mut self) {
        self.raise(Interrupt::power_supply(Coming::Coming, BACKUP_VOLTAGE, 0));
    }

    /// Retentive data is kept again: OB 81.
    pub fn backup_works(&mut self) {
        self.raise(Interrupt::power_supply(Coming::Going, BACKUP_VOLTAGE, 0));
    }

    /// Memory reset (MRES): STOP, then all memory as if the program had just been loaded.
    /// The diagnostic buffer, the clock and the run-time meters stay.
    pub fn memory_reset(&mut self) {
        self.stop();
        self.reset_memory(Requester::default());
    }

    pub(super) fn reset_memory(&mut self, by: Requester) {
        let (data_id, info_2) = by.fields(0);
        self.log(StartInformation { event: MEMORY_RESET, data_id, info_2, ..StartInformation::default() }, None);
        self.clear_work_memory();
        self.rack.clear_outputs();
        self.interrupted = None;
        self.warm_demanded = true;
        self.torn = false;
        self.log(StartInformation { event: MEMORY_RESET_DONE, ..StartInformation::default() }, None);
    }
}
