//! What others ask of the CPU as a whole: its mode, its clock, its blocks and its status lists.

use std::sync::Arc;

use sieben_engine::Tracer;
use sieben_model::block::BlockId;
use sieben_model::program::DataBlock;

use super::Cpu;
use crate::clock::{ClockRefused, DateAndTime};
use crate::communication::{Communication, Requester};
use crate::data_block_replacement::{self, ReplaceRefused};
use crate::interrupts::Again;
use crate::loaded_blocks::LoadedBlocks;
use crate::mode::{NotInStop, OperatingMode, Restart, StartRefused};
use crate::start_information::StartInformation;
use crate::system_status_list::SystemStatus;

/// The clock was set, so that a time-of-day interrupt is skipped.
const TIMES_SKIPPED: u16 = 0x3505;

impl Cpu {
    /// Starts the CPU at a request from outside, as [`Self::restart_with`] does, but only in STOP.
    ///
    /// # Errors
    /// It is not in STOP.
    pub fn start_with(
        &mut self,
        restart: Restart,
        by: Requester,
        clock: &mut dyn FnMut() -> u64,
        tracer: Option<&mut dyn Tracer>,
    ) -> Result<OperatingMode, StartRefused> {
        match self.mode {
            OperatingMode::Startup | OperatingMode::Run => return Err(StartRefused::Running),
            OperatingMode::Hold => return Err(StartRefused::Held),
            OperatingMode::Stop => {}
        }
        self.advance(clock());
        let stop_event = self.cause.as_ref().map_or(0, |cause| cause.event);
        let request = StartInformation::startup(self.kind_of_start(restart), stop_event, self.cpu_type.has_ob88);
        let (data_id, info_2) = by.fields(request.info_2);
        self.log(StartInformation { data_id, info_2, ..request }, None);
        Ok(self.restart_with(restart, clock, tracer))
    }

    pub(super) fn start_by(&mut self, restart: Restart, by: Requester) -> Result<OperatingMode, StartRefused> {
        let now = self.now_us;
        self.start_with(restart, by, &mut || now, None)
    }

    pub(super) fn memory_reset_by(&mut self, by: Requester) -> Result<(), NotInStop> {
        if self.mode != OperatingMode::Stop {
            return Err(NotInStop(self.mode));
        }
        self.reset_memory(by);
        Ok(())
    }

    pub(super) fn set_date_and_time(&mut self, wanted: DateAndTime) -> Result<(), ClockRefused> {
        if !wanted.is_date_and_time() {
            return Err(ClockRefused);
        }
        self.settings.date_and_time = wanted.minus_us(self.now_us);
        // In STOP no interrupt comes, and the end of HOLD looks at the clock itself.
        if matches!(self.mode, OperatingMode::Startup | OperatingMode::Run) {
            self.interrupts.clock_set(TIMES_SKIPPED, &self.now(), Again::of(self.cpu_type), &self.class);
        }
        Ok(())
    }

    pub(super) fn loaded_blocks(&self) -> LoadedBlocks<'_> {
        LoadedBlocks {
            cpu_type: self.cpu_type,
            program: &self.program,
            machine: &self.machine,
            non_retain: &self.system.non_retain,
            times: &self.load_times,
        }
    }

    /// What the status lists are made from at this moment; SFC 51 reads the same.
    pub fn system_status(&self) -> SystemStatus<'_> {
        let (now, state) = (self.machine.clock_us, &self.system);
        SystemStatus {
            cpu_type: self.cpu_type,
            program: &self.program,
            rack: &self.rack,
            diagnostics: &self.diagnostics,
            mode: self.mode,
            startup: state.startup,
            started: &state.started,
            time: self.date_and_time(),
            clock_status: state.clock.word(),
            meters: state.meter_hours(now),
            meters_running: state.meters_running(),
            communication: &self.communication,
            forces: self.forced.forces(),
        }
    }

    /// What servers have told.
    pub fn communication(&self) -> &Communication {
        &self.communication
    }

    pub(super) fn replace_values(&mut self, block: &DataBlock) -> Result<(), ReplaceRefused> {
        let number = block.number;
        if !matches!(self.mode, OperatingMode::Run | OperatingMode::Stop) || !self.machine.frames.is_empty() {
            return Err(ReplaceRefused::Running);
        }
        let there = self.machine.memory.data_block(u64::from(number));
        let program = Arc::clone(&self.program);
        let old = program.data.get(&number).ok_or(match there {
            Some(_) => ReplaceRefused::Created(number),
            None => ReplaceRefused::NotLoaded(number),
        })?;
        data_block_replacement::judge(old, block)?;
        // One that is UNLINKED is in the load memory only.
        if let Some(entry) = there {
            let start = entry.base as usize;
            let length = block.image.len().min(entry.length as usize);
            self.machine.memory.arena[start..start + length].copy_from_slice(&block.image[..length]);
        }
        if block.image == old.image {
            self.system.load_memory.remove(&number);
        } else {
            self.system.load_memory.insert(number, block.image.clone());
        }
        self.load_times.later(BlockId::db(number), self.date_and_time());
        Ok(())
    }

    pub(super) fn values_of(&self, number: u16) -> Option<Vec<u8>> {
        if let Some(entry) = self.machine.memory.data_block(u64::from(number)) {
            let start = entry.base as usize;
            return self.machine.memory.arena.get(start..start.checked_add(entry.length as usize)?).map(<[u8]>::to_vec);
        }
        let unlinked = self.program.data.get(&number)?;
        Some(self.system.load_memory.get(&number).unwrap_or(&unlinked.image).clone())
    }

    pub(super) fn delete_created(&mut self, number: u16) -> bool {
        let there = !self.program.data.contains_key(&number) && self.machine.memory.data_block(u64::from(number)).is_some();
        if !there || !matches!(self.mode, OperatingMode::Run | OperatingMode::Stop) || !self.machine.frames.is_empty() {
            return false;
        }
        // As after an online change: what is suspended between two scans may have it open.
        (self.paused, self.background_began) = (None, false);
        self.warm_demanded |= self.interrupted.take().is_some();
        self.machine.memory.data_blocks[usize::from(number)] = None;
        self.system.non_retain.remove(&number);
        self.load_times.forget(BlockId::db(number));
        true
    }

    pub(super) fn ram_to_rom(&mut self) -> usize {
        let program = Arc::clone(&self.program);
        let mut changed = 0;
        for (&number, block) in &program.data {
            // One that is UNLINKED has no values but those of the load memory.
            if self.machine.memory.data_block(u64::from(number)).is_none() {
                continue;
            }
            let Some(values) = self.values_of(number) else { continue };
            if *self.system.load_memory.get(&number).unwrap_or(&block.image) == values {
                continue;
            }
            changed += 1;
            if values == block.image {
                self.system.load_memory.remove(&number);
            } else {
                self.system.load_memory.insert(number, values);
            }
        }
        changed
    }
}
