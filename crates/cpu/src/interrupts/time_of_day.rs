//! Time-of-day interrupts: OB 10 to OB 17, set by SFC 28 and activated by SFC 30.

use sieben_model::cpu_type::CpuType;

use crate::clock::DateAndTime;
use crate::start_information::StartInformation;

const MINUTE_MS: u64 = 60_000;
const DAY_MS: u64 = 24 * 60 * MINUTE_MS;

/// How often a time-of-day interrupt comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Period {
    Once,
    Minute,
    Hour,
    Day,
    Week,
    Month,
    Year,
    MonthEnd,
}

/// The codes of the parameter PERIOD and of the start information.
const PERIODS: [(u16, Period); 8] = [
    (0x0000, Period::Once),
    (0x0201, Period::Minute),
    (0x0401, Period::Hour),
    (0x1001, Period::Day),
    (0x1201, Period::Week),
    (0x1401, Period::Month),
    (0x1801, Period::Year),
    (0x2001, Period::MonthEnd),
];

impl Period {
    pub(crate) fn from_code(code: u16) -> Option<Self> {
        PERIODS.iter().find(|row| row.0 == code).map(|row| row.1)
    }

    fn code(self) -> u16 {
        PERIODS.iter().find(|row| row.1 == self).map_or(0, |row| row.0)
    }

    /// The first time at or after `from`, in milliseconds since 1990; `None` if it has passed for good.
    fn first(self, start_ms: u64, from_ms: u64) -> Option<u64> {
        let every = |step: u64| {
            let behind = from_ms.saturating_sub(start_ms).div_ceil(step);
            Some(start_ms + behind * step)
        };
        match self {
            Self::Once => (start_ms >= from_ms).then_some(start_ms),
            Self::Minute => every(MINUTE_MS),
            Self::Hour => every(60 * MINUTE_MS),
            Self::Day => every(DAY_MS),
            Self::Week => every(7 * DAY_MS),
            Self::Month | Self::Year | Self::MonthEnd => self.first_by_calendar(start_ms, from_ms),
        }
    }

    /// The same for periods whose length differs. Months without the day of the start are left out.
    fn first_by_calendar(self, start_ms: u64, from_ms: u64) -> Option<u64> {
        let begin = DateAndTime::from_ms_since_1990(start_ms.max(from_ms)).year_month();
        let start = DateAndTime::from_ms_since_1990(start_ms);
        let (_, month_of_start) = start.year_month();
        // From 29 February to the next one it is eight years at most.
        (0..=8 * 12).map(|ahead| (begin.0 + (begin.1 - 1 + ahead) / 12, (begin.1 - 1 + ahead) % 12 + 1)).find_map(|(year, month)| {
            let day = match self {
                Self::Year if month != month_of_start => return None,
                Self::MonthEnd => last_day(year, month),
                _ => start.day(),
            };
            let days = sieben_model::literal::days_to_date(year, month as u8, day)?;
            let at = u64::from(days) * DAY_MS + start_ms % DAY_MS;
            (at >= from_ms.max(start_ms)).then_some(at)
        })
    }
}

fn last_day(year: u16, month: u16) -> u8 {
    (28..=31).rev().find(|&day| sieben_model::literal::days_to_date(year, month as u8, day).is_some()).unwrap_or(28)
}

/// A time-of-day interrupt that is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Set {
    start_ms: u64,
    period: Period,
    /// Its next time, while it is active.
    next_ms: Option<u64>,
}

/// Why a time-of-day interrupt cannot be activated or cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// No start is set.
    NotSet,
    /// The start has passed.
    Past,
}

/// All eight.
#[derive(Clone, Debug, Default)]
pub(crate) struct TimesOfDay {
    slots: [Option<Set>; 8],
    /// The next one and its time.
    next: Option<(u64, u16)>,
}

impl TimesOfDay {
    pub(crate) const FIRST: u16 = 10;

    fn slot(&mut self, number: u16) -> Option<&mut Option<Set>> {
        self.slots.get_mut(usize::from(number.checked_sub(Self::FIRST)?))
    }

    /// Sets start and period of OB `number`. Seconds and below count as 0. It is not active yet, whatever it was.
    pub(crate) fn set(&mut self, number: u16, start: DateAndTime, period: Period, now: DateAndTime) -> Result<(), Refusal> {
        let start_ms = start.ms() / MINUTE_MS * MINUTE_MS;
        if period == Period::Once && start_ms < now.ms() {
            return Err(Refusal::Past);
        }
        if let Some(slot) = self.slot(number) {
            *slot = Some(Set { start_ms, period, next_ms: None });
        }
        self.find_next();
        Ok(())
    }

    /// Activates OB `number`: it comes at its next time from now on.
    pub(crate) fn activate(&mut self, number: u16, now: DateAndTime) -> Result<(), Refusal> {
        let set = self.slot(number).and_then(Option::as_mut).ok_or(Refusal::NotSet)?;
        set.next_ms = Some(set.period.first(set.start_ms, now.ms()).ok_or(Refusal::Past)?);
        self.find_next();
        Ok(())
    }

    /// Forgets what was set for OB `number`.
    pub(crate) fn cancel(&mut self, number: u16) -> Result<(), Refusal> {
        let forgotten = self.slot(number).and_then(Option::take).map(|_| ()).ok_or(Refusal::NotSet);
        self.find_next();
        forgotten
    }

    /// Whether OB `number` is active and will come.
    pub(crate) fn is_active(&self, number: u16) -> bool {
        let set = number.checked_sub(Self::FIRST).and_then(|index| self.slots.get(usize::from(index)).copied().flatten());
        set.is_some_and(|set| set.next_ms.is_some())
    }

    /// The next one and its time, in milliseconds since 1990.
    pub(crate) fn next(&self) -> Option<(u64, u16)> {
        self.next
    }

    fn find_next(&mut self) {
        self.next = (Self::FIRST..).zip(&self.slots).filter_map(|(number, set)| Some((set.as_ref()?.next_ms?, number))).min();
    }

    /// It comes; times up to now that were missed come no more.
    pub(crate) fn fire(&mut self, number: u16, now: DateAndTime) -> StartInformation {
        let Some(Some(set)) = self.slot(number) else { return StartInformation::default() };
        let after = set.next_ms.unwrap_or_default().max(now.ms()) + 1;
        set.next_ms = if set.period == Period::Once { None } else { set.period.first(set.start_ms, after) };
        let code = set.period.code();
        self.find_next();
        StartInformation::time_of_day_interrupt(number, code)
    }

    /// The clock jumps, or time passed without the CPU. Returns one bit for each active interrupt whose time was skipped.
    /// `again`: set back, those that have come already come again (S7-300), or wait for times that have not been yet (S7-400).
    pub(crate) fn clock_set(&mut self, now: DateAndTime, again: Again) -> u16 {
        let mut skipped = 0;
        for (index, set) in self.slots.iter_mut().enumerate() {
            let Some(set) = set else { continue };
            let Some(next) = set.next_ms else { continue };
            if next < now.ms() {
                skipped |= 1 << index;
                set.next_ms = set.period.first(set.start_ms, now.ms());
            } else if again == Again::Yes && set.period != Period::Once {
                set.next_ms = set.period.first(set.start_ms, now.ms());
            }
        }
        self.find_next();
        skipped
    }
}

/// Whether a time-of-day interrupt comes again when the clock was set back behind its time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Again {
    Yes,
    No,
}

impl Again {
    /// On an S7-300 it does, on an S7-400 not.
    pub(crate) fn of(cpu_type: &CpuType) -> Self {
        // The families differ in more than OB 88, but nothing else tells them apart.
        if cpu_type.has_ob88 { Self::No } else { Self::Yes }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(year: u8, month: u8, day: u8, hour: u8, minute: u8) -> u64 {
        let bytes = [year, month, day, hour, minute, 0, 0, 0];
        DateAndTime::from_bcd(bytes).expect("a date").ms()
    }

    #[test]
    fn every_period_has_its_next_time() {
        let start = at(0x94, 1, 0x15, 0x10, 0x30);
        for (period, expected) in [
            (Period::Minute, at(0x94, 3, 1, 0x00, 0x01)),
            (Period::Hour, at(0x94, 3, 1, 0x00, 0x30)),
            (Period::Day, at(0x94, 3, 1, 0x10, 0x30)),
            // 15 January and 1 March were a Saturday and a Tuesday.
            (Period::Week, at(0x94, 3, 5, 0x10, 0x30)),
            (Period::Month, at(0x94, 3, 0x15, 0x10, 0x30)),
            (Period::Year, at(0x95, 1, 0x15, 0x10, 0x30)),
            (Period::MonthEnd, at(0x94, 3, 0x31, 0x10, 0x30)),
        ] {
            assert_eq!(period.first(start, at(0x94, 3, 1, 0, 0) + 1), Some(expected), "{period:?}");
            assert_eq!(period.first(start, expected), Some(expected), "{period:?}");
            assert!(period.first(start, 0) >= Some(start), "{period:?}");
        }
        assert_eq!(Period::Once.first(start, start + 1), None);
    }

    #[test]
    fn days_that_a_month_lacks_are_left_out() {
        assert_eq!(Period::MonthEnd.first(at(0x94, 1, 5, 0, 0), at(0x96, 2, 1, 0, 0)), Some(at(0x96, 2, 0x29, 0, 0)));
        let leap = at(0x96, 2, 0x29, 0x12, 0);
        assert_eq!(Period::Year.first(leap, leap + 1), Some(at(0, 2, 0x29, 0x12, 0)));
        assert_eq!(Period::Month.first(at(0x94, 1, 0x31, 0, 0), at(0x94, 2, 1, 0, 0)), Some(at(0x94, 3, 0x31, 0, 0)));
    }
}
