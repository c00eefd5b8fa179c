//! Dates and times of day: the calendar, and how they are written.

use super::{LiteralErrorKind, Parsed, Value, from_bcd, parse_decimal, parse_fraction};

/// Milliseconds of a day.
pub(super) const DAY_MS: u32 = 86_400_000;
/// 2168-12-31, the last DATE.
pub(super) const DATE_MAX: u16 = 0xFF62;

const DATE_RANGE: &str = "D#1990-01-01 to D#2168-12-31";
pub(super) const TOD_RANGE: &str = "TOD#0:0:0.000 to TOD#23:59:59.999";
const DT_RANGE: &str = "DT#1990-01-01-0:0:0.000 to DT#2089-12-31-23:59:59.999";

fn is_leap_year(year: u32) -> bool {
    (year.is_multiple_of(4) && !year.is_multiple_of(100)) || year.is_multiple_of(400)
}

pub(super) fn days_of_month(year: u32, month: u32) -> u32 {
    match month {
        2 if is_leap_year(year) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

fn days_of_year(year: u32) -> u32 {
    if is_leap_year(year) { 366 } else { 365 }
}

/// Days from 1990-01-01 to a valid date not before it.
fn days_since_1990(year: u32, month: u32, day: u32) -> u32 {
    (1990..year).map(days_of_year).sum::<u32>() + (1..month).map(|month| days_of_month(year, month)).sum::<u32>() + day - 1
}

/// Days from 1990-01-01 to a date; `None` if there is no such day from then on.
pub fn days_to_date(year: u16, month: u8, day: u8) -> Option<u32> {
    let (year, month, day) = (u32::from(year), u32::from(month), u32::from(day));
    let exists = year >= 1990 && (1..=12).contains(&month) && day >= 1 && day <= days_of_month(year, month);
    exists.then(|| days_since_1990(year, month, day))
}

/// Days from the 1st of March of the year 0 to 1990-01-01.
const DAYS_BEFORE_1990: u32 = 726_773;
const DAYS_OF_400_YEARS: u32 = 146_097;

/// Year, month and day of a DATE, for every 16-bit number of days.
pub(crate) fn calendar_date(days: u16) -> (u32, u32, u32) {
    // Counted from the 1st of March of the year 0: the day that some years have is the last one of such a year, and the months before the
    // last are all in the same rhythm of 153 days in five months.
    let days = u32::from(days) + DAYS_BEFORE_1990;
    let of_400_years = days % DAYS_OF_400_YEARS;
    let year = (of_400_years - of_400_years / 1_460 + of_400_years / 36_524 - of_400_years / 146_096) / 365;
    let of_year = of_400_years - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (month, next_year) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    (days / DAYS_OF_400_YEARS * 400 + year + next_year, month, day)
}

/// Year, month and day of `1994-3-15`; a year of two digits counts as in DATE_AND_TIME.
fn parse_calendar(text: &str, last_year: u32, range: &'static str) -> Result<(u32, u32, u32), LiteralErrorKind> {
    use LiteralErrorKind::{Malformed, NoSuchDate, OutOfRange};
    let valid = Malformed("a date is year-month-day, such as D#2024-02-29");
    let parts: Vec<&str> = text.split('-').collect();
    let [year_text, month, day] = parts[..] else { return Err(valid) };
    let number = |text: &str| parse_decimal(text).map(|number| u32::try_from(number).unwrap_or(u32::MAX));
    let (Some(mut year), Some(month), Some(day)) = (number(year_text), number(month), number(day)) else { return Err(valid) };
    if year_text.len() == 2 {
        year += if year >= 90 { 1900 } else { 2000 };
    }
    if !(1990..=last_year).contains(&year) {
        return Err(OutOfRange(range));
    }
    if !(1..=12).contains(&month) || day == 0 || day > days_of_month(year, month) {
        return Err(NoSuchDate);
    }
    Ok((year, month, day))
}

pub(super) fn parse_date(text: &str) -> Result<u16, LiteralErrorKind> {
    let (year, month, day) = parse_calendar(text, 2168, DATE_RANGE)?;
    u16::try_from(days_since_1990(year, month, day)).map_err(|_| LiteralErrorKind::OutOfRange(DATE_RANGE))
}

pub(super) fn parse_time_of_day(text: &str, range: &'static str) -> Result<u32, LiteralErrorKind> {
    use LiteralErrorKind::{Malformed, OutOfRange};
    let valid = Malformed("a time of day is hours:minutes:seconds.milliseconds, such as TOD#01:10:3.300");
    let parts: Vec<&str> = text.split(':').collect();
    let [hours, minutes, seconds] = parts[..] else { return Err(valid) };
    let (seconds, fraction) = seconds.split_once('.').map_or((seconds, None), |(seconds, fraction)| (seconds, Some(fraction)));
    let milliseconds = fraction.map_or(Some(0), |fraction| parse_fraction(fraction, 1_000)).ok_or(valid.clone())?;
    let (Some(hours), Some(minutes), Some(seconds)) = (parse_decimal(hours), parse_decimal(minutes), parse_decimal(seconds)) else {
        return Err(valid);
    };
    if hours > 23 || minutes > 59 || seconds > 59 {
        return Err(OutOfRange(range));
    }
    Ok((((hours * 60 + minutes) * 60 + seconds) * 1_000 + milliseconds) as u32)
}

pub(super) fn parse_date_and_time(text: &str) -> Parsed {
    let valid = LiteralErrorKind::Malformed(
        "a date and time is year-month-day-hours:minutes:seconds.milliseconds, such as DT#2024-02-29-12:30:00.000",
    );
    let (date, time) = text.rsplit_once('-').ok_or(valid)?;
    let (year, month, day) = parse_calendar(date, 2089, DT_RANGE)?;
    let milliseconds = parse_time_of_day(time, DT_RANGE)?;
    Ok(Value::DateAndTime(date_and_time_bytes(days_since_1990(year, month, day) as u16, milliseconds)))
}

/// The eight BCD bytes of a DATE_AND_TIME; years repeat after 2089, as the two digits of the format do.
pub fn date_and_time_bytes(days: u16, milliseconds_of_day: u32) -> [u8; 8] {
    let (year, month, day) = calendar_date(days);
    let digits = |number: u32| (number / 10 % 10 * 16 + number % 10) as u8;
    let milliseconds = milliseconds_of_day % DAY_MS;
    let (seconds, part) = (milliseconds / 1_000, milliseconds % 1_000);
    // 1990-01-01 was a Monday; the week begins with Sunday = 1.
    let weekday = (u32::from(days) + 1) % 7 + 1;
    [
        digits(year),
        digits(month),
        digits(day),
        digits(seconds / 3_600),
        digits(seconds / 60 % 60),
        digits(seconds % 60),
        digits(part / 10),
        ((part % 10) << 4 | weekday) as u8,
    ]
}

/// Days since 1990 and milliseconds of the day of a DATE_AND_TIME, if its bytes are a valid date; the weekday does not count.
pub(super) fn date_and_time_parts(bytes: &[u8; 8]) -> Option<(u16, u32)> {
    let number = |byte: u8| from_bcd(u32::from(byte));
    let year = number(bytes[0])?;
    let year = year + if year >= 90 { 1900 } else { 2000 };
    let (month, day) = (number(bytes[1])?, number(bytes[2])?);
    let (hours, minutes, seconds) = (number(bytes[3])?, number(bytes[4])?, number(bytes[5])?);
    let milliseconds = number(bytes[6])? * 10 + number(bytes[7] >> 4)?;
    if !(1..=12).contains(&month) || day == 0 || day > days_of_month(year, month) || hours > 23 || minutes > 59 || seconds > 59 {
        return None;
    }
    let days = u16::try_from(days_since_1990(year, month, day)).ok()?;
    Some((days, ((hours * 60 + minutes) * 60 + seconds) * 1_000 + milliseconds))
}

pub(super) fn spell_time_of_day(milliseconds: u32) -> String {
    let seconds = milliseconds / 1_000;
    format!("{:02}:{:02}:{:02}.{:03}", seconds / 3_600, seconds / 60 % 60, seconds % 60, milliseconds % 1_000)
}
