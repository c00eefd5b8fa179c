//! The CPU's time of day and its clock memory byte.

use sieben_model::literal;

/// A point in time as the CPU keeps it: milliseconds since 1990-01-01 00:00.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DateAndTime(u64);

/// Days that DATE_AND_TIME can tell apart, those of 1990 to 2089; then it begins again.
const CENTURY_DAYS: u64 = 100 * 365 + 25;
const DAY_MS: u64 = 86_400_000;

impl DateAndTime {
    /// 1994-01-01 00:00, where a CPU without a battery begins and where virtual time begins.
    pub const DEFAULT: Self = Self(4 * 365 * DAY_MS + DAY_MS);

    /// A point in time by its milliseconds since 1990-01-01 00:00.
    pub const fn from_ms_since_1990(ms: u64) -> Self {
        Self(ms)
    }

    /// Later by this many microseconds.
    #[must_use]
    pub const fn plus_us(self, us: u64) -> Self {
        Self(self.0.saturating_add(us / 1000))
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
        assert_eq!(DateAndTime::DEFAULT.display(), "1994-01-01 00:00:00.000");
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
