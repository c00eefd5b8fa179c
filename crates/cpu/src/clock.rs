//! The CPU's time of day, where its time comes from, and its clock memory byte.

use std::fmt;

use sieben_model::literal;

/// Where time comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TimeSource {
    /// The clock stands still inside a scan and the watchdog counts safe points: every run is the same.
    #[default]
    Virtual,
    /// The clock is asked inside a scan too, for the watchdog, for timers and for times of day.
    Real,
}

/// A point in time as the CPU keeps it: milliseconds since 1990-01-01 00:00.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DateAndTime(u64);

/// Days that DATE_AND_TIME can tell apart, those of 1990 to 2089; then it begins again.
const CENTURY_DAYS: u64 = 100 * 365 + 25;
const DAY_MS: u64 = 86_400_000;
/// Twenty years, five of them leap years.
const MS_FROM_1970_TO_1990: u64 = (20 * 365 + 5) * DAY_MS;

impl DateAndTime {
    /// 1994-01-01 00:00, where a CPU without a battery begins and where virtual time begins.
    pub const DEFAULT: Self = Self(4 * 365 * DAY_MS + DAY_MS);

    /// A point in time by its milliseconds since 1970-01-01 00:00, as computers count; what lies before 1990 is its beginning.
    pub const fn from_ms_since_1970(ms: u64) -> Self {
        Self(ms.saturating_sub(MS_FROM_1970_TO_1990))
    }

    /// A point in time by its milliseconds since 1990-01-01 00:00.
    pub const fn from_ms_since_1990(ms: u64) -> Self {
        Self(ms)
    }

    /// Whether DATE_AND_TIME has it: 1990 to 2089.
    pub const fn is_date_and_time(self) -> bool {
        self.0 < CENTURY_DAYS * DAY_MS
    }

    /// Milliseconds since 1990-01-01 00:00.
    pub const fn ms(self) -> u64 {
        self.0
    }

    /// Year and month (1 to 12) of the calendar, 1990 to 2089.
    pub(crate) fn year_month(self) -> (u16, u16) {
        let [year, month, ..] = self.to_bcd().map(from_bcd_digits);
        (if year >= 90 { 1900 + year } else { 2000 + year }, month)
    }

    /// Day of the month, 1 to 31.
    pub(crate) fn day(self) -> u8 {
        from_bcd_digits(self.to_bcd()[2]) as u8
    }

    /// Later by this many microseconds.
    #[must_use]
    pub const fn plus_us(self, us: u64) -> Self {
        Self(self.0.saturating_add(us / 1000))
    }

    /// Earlier by this many microseconds; before 1990 comes 2089.
    #[must_use]
    pub(crate) const fn minus_us(self, us: u64) -> Self {
        let century = CENTURY_DAYS * DAY_MS;
        Self((self.0 % century + century - us / 1000 % century) % century)
    }

    /// A point in time from the eight bytes of DATE_AND_TIME; the weekday is not looked at.
    pub(crate) fn from_bcd(bytes: [u8; 8]) -> Result<Self, NoDateAndTime> {
        let bcd = |byte: u8| (byte >> 4 <= 9 && byte & 0xF <= 9).then(|| (byte >> 4) * 10 + (byte & 0xF));
        let [year, month, day, hour, minute, second, centi, milli] = bytes;
        let [Some(year), Some(month), Some(day)] = [year, month, day].map(bcd) else { return Err(NoDateAndTime::Date) };
        let year = (if year >= 90 { 1900 } else { 2000 }) + u16::from(year);
        let days = literal::days_to_date(year, month, day).ok_or(NoDateAndTime::Date)?;
        let time = [hour, minute, second, centi, milli >> 4].map(bcd);
        match time {
            [Some(hour @ ..=23), Some(minute @ ..=59), Some(second @ ..=59), Some(centi), Some(milli)] => {
                let [hour, minute, second, centi, milli] = [hour, minute, second, centi, milli].map(u64::from);
                Ok(Self(u64::from(days) * DAY_MS + ((hour * 60 + minute) * 60 + second) * 1000 + centi * 10 + milli))
            }
            _ => Err(NoDateAndTime::Time),
        }
    }

    /// A point in time from the eight bytes of DATE_AND_TIME; `None` if they are none.
    pub fn from_bytes(bytes: [u8; 8]) -> Option<Self> {
        Self::from_bcd(bytes).ok()
    }

    /// The eight bytes of DATE_AND_TIME: BCD year, month, day, hour, minute, second, milliseconds and weekday (1 = Sunday).
    pub fn to_bcd(self) -> [u8; 8] {
        let days = self.0 / DAY_MS % CENTURY_DAYS;
        literal::date_and_time_bytes(days as u16, (self.0 % DAY_MS) as u32)
    }

    /// The point in time as `1994-01-01 00:00:00.000`.
    pub fn display(self) -> String {
        let [year, month, day, hour, minute, second, centi, milli] = self.to_bcd();
        let century = if year >= 0x90 { "19" } else { "20" };
        format!("{century}{year:02x}-{month:02x}-{day:02x} {hour:02x}:{minute:02x}:{second:02x}.{centi:02x}{:x}", milli >> 4)
    }
}

/// The bytes of DATE_AND_TIME, one point in time after the other: most of them differ from the one before in their milliseconds only.
#[derive(Clone, Debug)]
pub(crate) struct BcdClock {
    /// Since 1990-01-01 00:00.
    second: u64,
    /// Its beginning.
    bytes: [u8; 8],
}

impl BcdClock {
    /// As [`DateAndTime::to_bcd`].
    pub(crate) fn show(&mut self, time: DateAndTime) -> [u8; 8] {
        let (second, ms) = (time.0 / 1000, (time.0 % 1000) as u32);
        if second != self.second {
            *self = Self { second, bytes: DateAndTime(second * 1000).to_bcd() };
        }
        let mut bytes = self.bytes;
        bytes[6] = (ms / 100 * 16 + ms / 10 % 10) as u8;
        bytes[7] |= (ms % 10 * 16) as u8;
        bytes
    }
}

impl Default for BcdClock {
    fn default() -> Self {
        Self { second: 0, bytes: DateAndTime(0).to_bcd() }
    }
}

fn from_bcd_digits(byte: u8) -> u16 {
    u16::from(byte >> 4) * 10 + u16::from(byte & 0xF)
}

/// What is wrong with the bytes of a DATE_AND_TIME.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoDateAndTime {
    /// There is no such day.
    Date,
    /// There is no such time.
    Time,
}

/// Why the clock is not set from outside: it shows 1990 to 2089. Nothing has changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClockRefused;

impl fmt::Display for ClockRefused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the clock of a CPU shows times from 1990-01-01 to 2089-12-31")
    }
}

impl std::error::Error for ClockRefused {}

impl Default for DateAndTime {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Half periods of the clock memory bits 0 to 7, in microseconds: 10, 5, 2.5, 2, 1.25, 1, 0.625 and 0.5 Hz.
const HALF_PERIODS_US: [u64; 8] = [50_000, 100_000, 200_000, 250_000, 400_000, 500_000, 800_000, 1_000_000];

/// The clock memory byte when the CPU clock shows `clock_us`; every bit begins with its 0 half.
pub fn clock_memory(clock_us: u64) -> u8 {
    HALF_PERIODS_US.iter().enumerate().fold(0, |byte, (bit, half)| byte | ((clock_us / half % 2) as u8) << bit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn date_and_time_is_bcd_with_the_weekday_last() {
        let cases: &[(u64, [u8; 8])] = &[
            (0, [0x90, 1, 1, 0, 0, 0, 0, 0x02]),
            (DateAndTime::DEFAULT.0, [0x94, 1, 1, 0, 0, 0, 0, 0x07]),
            (DateAndTime::DEFAULT.0 + 3_723_045, [0x94, 1, 1, 0x01, 0x02, 0x03, 0x04, 0x57]),
            // 2000-02-29 was a Tuesday.
            ((10 * 365 + 2 + 31 + 28) * DAY_MS, [0x00, 2, 0x29, 0, 0, 0, 0, 0x03]),
        ];
        for &(ms, bytes) in cases {
            assert_eq!(DateAndTime::from_ms_since_1990(ms).to_bcd(), bytes, "{ms} ms");
        }
        let mut clock = BcdClock::default();
        let steps = (0..500_000_u64).map(|step| DateAndTime(step * step * 7 % (CENTURY_DAYS * DAY_MS))).chain((0..3_000).map(DateAndTime));
        for time in steps {
            assert_eq!(clock.show(time), time.to_bcd(), "{}", time.display());
        }
        assert_eq!(DateAndTime::DEFAULT.display(), "1994-01-01 00:00:00.000");
    }

    #[test]
    fn date_and_time_is_read_from_bcd() {
        for ms in [0, 4 * 365 * DAY_MS + 5, DateAndTime::DEFAULT.0 + 3_723_045, 3711 * DAY_MS - 1, CENTURY_DAYS * DAY_MS - 1] {
            let point = DateAndTime(ms);
            assert_eq!(DateAndTime::from_bcd(point.to_bcd()), Ok(point), "{}", point.display());
        }
        let date = |bytes: [u8; 3]| DateAndTime::from_bcd([bytes[0], bytes[1], bytes[2], 0, 0, 0, 0, 0]).err();
        for bytes in [[0x94, 0, 1], [0x94, 0x13, 1], [0x94, 2, 0x29], [0x94, 2, 0], [0x9A, 1, 1], [0x94, 0x4, 0x31]] {
            assert_eq!(date(bytes), Some(NoDateAndTime::Date), "{bytes:x?}");
        }
        assert_eq!(date([0x96, 2, 0x29]), None);
        for bytes in [[0x24, 0, 0, 0, 0], [0, 0x60, 0, 0, 0], [0, 0, 0x60, 0, 0], [0, 0, 0, 0xA0, 0], [0, 0, 0, 0, 0xA0]] {
            let [hour, minute, second, centi, milli] = bytes;
            let read = DateAndTime::from_bcd([0x94, 1, 1, hour, minute, second, centi, milli]);
            assert_eq!(read, Err(NoDateAndTime::Time), "{bytes:x?}");
        }
    }

    #[test]
    fn date_and_time_begins_again_after_2089() {
        let _ = DateAndTime::from_ms_since_1990(u64::MAX).to_bcd();
        assert_eq!(DateAndTime::from_ms_since_1990(CENTURY_DAYS * DAY_MS - 1).to_bcd()[..3], [0x89, 0x12, 0x31]);
        assert_eq!(DateAndTime::from_ms_since_1990(CENTURY_DAYS * DAY_MS).to_bcd()[..3], [0x90, 1, 1]);
    }

    #[test]
    fn clock_memory_bits_have_their_periods() {
        for (bit, period_ms) in [100, 200, 400, 500, 800, 1000, 1600, 2000].into_iter().enumerate() {
            let at = |ms: u64| clock_memory(ms * 1000) >> bit & 1;
            assert_eq!([at(0), at(period_ms / 2 - 1), at(period_ms / 2), at(period_ms - 1), at(period_ms)], [0, 0, 1, 1, 0], "bit {bit}");
        }
    }
}
