//! Time-delay interrupts: OB 20 to OB 23, started by SFC 32.

use crate::start_information::StartInformation;

/// A delay that runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Delay {
    /// CPU clock at its end, in microseconds.
    due_us: u64,
    sign: u16,
    dtime_ms: u32,
}

/// The delays of the four blocks.
#[derive(Clone, Debug, Default)]
pub(crate) struct Delays {
    slots: [Option<Delay>; 4],
    /// The next one and when it ends.
    next: Option<(u64, u16)>,
}

impl Delays {
    pub(crate) const FIRST: u16 = 20;

    fn slot(&mut self, number: u16) -> Option<&mut Option<Delay>> {
        self.slots.get_mut(usize::from(number.checked_sub(Self::FIRST)?))
    }

    /// Starts the delay of OB `number`, again if it runs.
    pub(crate) fn start(&mut self, number: u16, clock_us: u64, dtime_ms: u32, sign: u16) {
        if let Some(slot) = self.slot(number) {
            let due_us = clock_us.saturating_add(u64::from(dtime_ms) * 1000);
            *slot = Some(Delay { due_us, sign, dtime_ms });
        }
        self.find_next();
    }

    /// Ends the delay of OB `number`; `false` if it did not run.
    pub(crate) fn cancel(&mut self, number: u16) -> bool {
        let ran = self.slot(number).is_some_and(|slot| slot.take().is_some());
        self.find_next();
        ran
    }

    /// Whether that of OB `number` runs.
    pub(crate) fn runs(&self, number: u16) -> bool {
        number.checked_sub(Self::FIRST).and_then(|index| self.slots.get(usize::from(index))).is_some_and(Option::is_some)
    }

    /// The next one and when it ends, by the CPU clock in microseconds.
    pub(crate) fn next(&self) -> Option<(u64, u16)> {
        self.next
    }

    fn find_next(&mut self) {
        self.next = (Self::FIRST..).zip(&self.slots).filter_map(|(number, slot)| Some((slot.as_ref()?.due_us, number))).min();
    }

    /// It ends.
    pub(crate) fn fire(&mut self, number: u16) -> StartInformation {
        let delay = self.slot(number).and_then(Option::take);
        self.find_next();
        let (sign, dtime_ms) = delay.map_or((0, 0), |delay| (delay.sign, delay.dtime_ms));
        StartInformation::delay_interrupt(number, sign, dtime_ms)
    }
}
