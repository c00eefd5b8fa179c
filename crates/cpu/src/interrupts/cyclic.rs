//! Cyclic interrupts: OB 30 to OB 38.

use crate::start_information::StartInformation;

/// How often a cyclic interrupt comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CyclicInterrupt {
    /// Distance of two starts in milliseconds, 1 to 60,000.
    pub interval_ms: u16,
    /// How much later than a multiple of the interval, in milliseconds, 0 to 60,000.
    pub phase_ms: u16,
}

impl CyclicInterrupt {
    /// The number of the first cyclic organization block.
    pub const FIRST: u16 = 30;
    /// The number of the last one.
    pub const LAST: u16 = 38;
    /// What an interval or phase offset can be at most, in milliseconds.
    pub const MS_MAX: u16 = 60_000;

    /// What OB `number` has without a configuration: 5 s for OB 30 … 100 ms for OB 35 … 10 ms for OB 38. `None` for any other block.
    pub fn usual(number: u16) -> Option<Self> {
        let interval_ms = [5000, 2000, 1000, 500, 200, 100, 50, 20, 10];
        let index = number.checked_sub(Self::FIRST)?;
        interval_ms.get(usize::from(index)).map(|&interval_ms| Self { interval_ms, phase_ms: 0 })
    }

    /// Interval and phase offset in microseconds, brought into their ranges.
    fn us(self) -> (u64, u64) {
        let interval = self.interval_ms.clamp(1, Self::MS_MAX);
        (u64::from(interval) * 1000, u64::from(self.phase_ms.min(Self::MS_MAX)) * 1000)
    }
}

/// One cyclic interrupt in RUN.
#[derive(Clone, Copy, Debug)]
struct Clockwork {
    number: u16,
    setting: CyclicInterrupt,
    /// CPU clock of the next start, in microseconds.
    next_us: u64,
}

/// All that run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cyclic {
    clockworks: Vec<Clockwork>,
    /// The next one and when it comes.
    next: Option<(u64, u16)>,
}

impl Cyclic {
    /// The CPU changes to RUN: all start to count.
    pub(crate) fn start(&mut self, settings: impl Iterator<Item = (u16, CyclicInterrupt)>, clock_us: u64) {
        self.clockworks = settings
            .map(|(number, setting)| {
                let (interval, phase) = setting.us();
                Clockwork { number, setting, next_us: clock_us.saturating_add(interval + phase) }
            })
            .collect();
        self.find_next();
    }

    /// The program changed in RUN: those that stay keep their time, new ones start to count.
    pub(crate) fn change(&mut self, settings: impl Iterator<Item = (u16, CyclicInterrupt)>, clock_us: u64) {
        let old = std::mem::take(&mut self.clockworks);
        self.start(settings, clock_us);
        for one in &mut self.clockworks {
            if let Some(before) = old.iter().find(|before| before.number == one.number && before.setting == one.setting) {
                one.next_us = before.next_us;
            }
        }
        self.find_next();
    }

    /// The next one and when it comes, by the CPU clock in microseconds.
    pub(crate) fn next(&self) -> Option<(u64, u16)> {
        self.next
    }

    fn find_next(&mut self) {
        self.next = self.clockworks.iter().map(|one| (one.next_us, one.number)).min();
    }

    /// It comes. If it came while it still ran or nothing could run, all starts up to `missed_until_us` are one.
    pub(crate) fn fire(&mut self, number: u16, missed_until_us: Option<u64>) -> StartInformation {
        let Some(one) = self.clockworks.iter_mut().find(|one| one.number == number) else { return StartInformation::default() };
        let (interval, _) = one.setting.us();
        let behind = missed_until_us.map_or(0, |now| now.saturating_sub(one.next_us) / interval);
        one.next_us = one.next_us.saturating_add(interval.saturating_mul(behind + 1));
        let setting = one.setting;
        self.find_next();
        StartInformation::cyclic_interrupt(number, setting.phase_ms, setting.interval_ms)
    }
}
