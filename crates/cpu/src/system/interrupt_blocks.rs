//! What SFC 28 to SFC 34 have in common: which organization block they mean, and their answers.

use std::ops::RangeInclusive;

use sieben_model::address::Width;

use crate::interrupts::{Delays, Refusal, TimesOfDay};

use super::Call;
use super::parameters::Answer;

/// OB_NR is no organization block of this kind that the CPU has.
pub(super) const BAD_BLOCK: u16 = 0x8090;
/// Nothing is set or started for it.
pub(super) const NOT_SET: u16 = 0x80A0;
/// Its start has passed.
pub(super) const PAST: u16 = 0x80A1;

/// Time-of-day interrupts.
pub(super) const TIMES_OF_DAY: RangeInclusive<u16> = TimesOfDay::FIRST..=TimesOfDay::FIRST + 7;
/// Time-delay interrupts.
pub(super) const DELAYS: RangeInclusive<u16> = Delays::FIRST..=Delays::FIRST + 3;

/// The interrupt is rejected when it comes (SFC 39).
const STATUS_LOCKED: u32 = 1 << 1;
/// The interrupt is active, or its delay runs.
const STATUS_ACTIVE: u32 = 1 << 2;
/// The organization block is loaded.
const STATUS_LOADED: u32 = 1 << 4;

impl From<Refusal> for u16 {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::NotSet => NOT_SET,
            Refusal::Past => PAST,
        }
    }
}

impl Call<'_, '_> {
    /// The organization block that parameter 0 names: of one kind, and one that the CPU type has.
    pub(super) fn interrupt_block(&mut self, kind: RangeInclusive<u16>) -> Result<u16, u16> {
        let number = self.input(0, Width::Word)? as u16;
        if kind.contains(&number) && self.host.cpu_type.has_organization_block(number) { Ok(number) } else { Err(BAD_BLOCK) }
    }

    /// Writes STATUS, which stands behind RET_VAL.
    pub(super) fn interrupt_status(&mut self, number: u16, active: bool) -> Answer {
        let interrupts = &self.host.interrupts;
        let bits =
            [(interrupts.is_locked(number), STATUS_LOCKED), (active, STATUS_ACTIVE), (interrupts.is_available(number), STATUS_LOADED)];
        let status = bits.iter().filter(|bit| bit.0).map(|bit| bit.1).sum();
        self.output(2, Width::Word, status)?;
        Ok(0)
    }
}
