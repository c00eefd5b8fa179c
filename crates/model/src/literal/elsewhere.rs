//! How values of the types that an S7-300/400 does not have are shown and read: LINT, LREAL, LTIME, enumerations.

use super::spell_duration;
use crate::types::DataType;

/// Nanoseconds of a day.
const DAY_NS: u64 = 86_400_000_000_000;
/// The units of an LTIME in nanoseconds.
const UNITS: [(&str, u64); 7] =
    [("D", DAY_NS), ("H", 3_600_000_000_000), ("M", 60_000_000_000), ("S", 1_000_000_000), ("MS", 1_000_000), ("US", 1_000), ("NS", 1)];

/// Whether a value of the type is shown and read by this file.
pub fn is_elsewhere(data_type: &DataType) -> bool {
    match data_type {
        DataType::Enumeration(_) => true,
        DataType::Subrange(subrange) => is_elsewhere(&subrange.base),
        other => {
            other.is_long()
                || matches!(
                    other,
                    DataType::SmallInt
                        | DataType::UnsignedSmallInt
                        | DataType::UnsignedInt
                        | DataType::UnsignedDoubleInt
                        | DataType::WideChar
                )
        }
    }
}

/// The low bits as a signed number of that width.
fn signed(bits: u64, width: u64) -> i64 {
    match width {
        1..=63 => (bits << (64 - width)) as i64 >> (64 - width),
        _ => bits as i64,
    }
}

/// Raw bits as a value of one of these types; `None` for any other type.
pub fn format_as(data_type: &DataType, bits: u64) -> Option<String> {
    Some(match data_type {
        DataType::Enumeration(enumeration) => {
            let value = number_of(&enumeration.base, bits);
            let name = enumeration.values.iter().find(|&&(_, number)| i128::from(number) == value);
            name.map_or_else(|| value.to_string(), |(name, _)| name.clone())
        }
        DataType::Subrange(subrange) => super::format_as(&subrange.base, bits),
        DataType::SmallInt
        | DataType::LongInt
        | DataType::UnsignedSmallInt
        | DataType::UnsignedInt
        | DataType::UnsignedDoubleInt
        | DataType::UnsignedLongInt => number_of(data_type, bits).to_string(),
        DataType::LongWord | DataType::Reference(_) => {
            let hex = |shift: u32| bits >> shift & 0xFFFF;
            format!("16#{:04X}_{:04X}_{:04X}_{:04X}", hex(48), hex(32), hex(16), hex(0))
        }
        DataType::LongReal => spell_long_real(f64::from_bits(bits)),
        DataType::LongTime => {
            let value = bits as i64;
            let sign = if value < 0 { "-" } else { "" };
            match value {
                0 => "LT#0S".to_owned(),
                _ => format!("LT#{sign}{}", spell_duration(value.unsigned_abs(), &UNITS)),
            }
        }
        DataType::LongDate => format!("LD#{}", spell_date(bits / DAY_NS)),
        DataType::LongTimeOfDay => format!("LTOD#{}", spell_time_of_day(bits)),
        DataType::LongDateAndTime => format!("LDT#{}-{}", spell_date(bits / DAY_NS), spell_time_of_day(bits % DAY_NS)),
        DataType::WideChar => match char::from_u32(bits as u32 & 0xFFFF) {
            Some(character) if !character.is_control() => format!("WCHAR#'{character}'"),
            _ => format!("WCHAR#16#{:04X}", bits as u16),
        },
        _ => return None,
    })
}

/// The bits of an integer type as a number.
fn number_of(data_type: &DataType, bits: u64) -> i128 {
    let width = data_type.bits();
    match data_type.base() {
        DataType::SmallInt | DataType::Int | DataType::DoubleInt | DataType::LongInt => i128::from(signed(bits, width)),
        _ if width < 64 => i128::from(bits & ((1 << width) - 1)),
        _ => i128::from(bits),
    }
}

fn spell_long_real(value: f64) -> String {
    if value.is_nan() {
        return "NaN".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "+INF" } else { "-INF" }.to_owned();
    }
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let point = if mantissa.contains('.') { "" } else { ".0" };
    let (sign, digits) = exponent.strip_prefix('-').map_or(('+', exponent), |digits| ('-', digits));
    format!("{mantissa}{point}e{sign}{digits:0>3}")
}

fn spell_time_of_day(nanoseconds: u64) -> String {
    let seconds = nanoseconds / 1_000_000_000;
    format!("{:02}:{:02}:{:02}.{:09}", seconds / 3_600, seconds / 60 % 60, seconds % 60, nanoseconds % 1_000_000_000)
}

/// The date of a day counted from 1970-01-01.
fn spell_date(days: u64) -> String {
    let (year, month, day) = date_of_days(days);
    format!("{year}-{month:02}-{day:02}")
}

/// Days from 1970-01-01 to a date of the calendar; `None` before 1970, after 9999, and for days that do not exist.
pub fn days_of_date(year: u32, month: u32, day: u32) -> Option<u64> {
    if !(1970..=9999).contains(&year) || !(1..=12).contains(&month) || day < 1 || day > super::calendar::days_of_month(year, month) {
        return None;
    }
    // Days from 0000-03-01, with years that begin in March.
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    let days = 365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day - 1;
    Some(u64::from(days - DAYS_TO_1970))
}

/// Days from 0000-03-01 to 1970-01-01.
const DAYS_TO_1970: u32 = 719_468;

/// Year, month and day of a day counted from 1970-01-01.
pub fn date_of_days(days: u64) -> (u64, u64, u64) {
    let days = days + u64::from(DAYS_TO_1970);
    let era = days / 146_097;
    let day_of_era = days % 146_097;
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let year = era * 400 + year_of_era;
    if month < 10 { (year, month + 3, day) } else { (year + 1, month - 9, day) }
}

/// The bits of a value that a user wrote for a variable of one of these types; `None` if it is read like one of any other type.
pub fn parse_as(data_type: &DataType, text: &str) -> Option<u64> {
    match data_type {
        DataType::Enumeration(enumeration) => {
            let name = text.rsplit(['#', '.']).next().unwrap_or(text);
            let number = enumeration.value(name)?;
            let bits = number as u64;
            let width = data_type.bits();
            Some(if width < 64 { bits & ((1 << width) - 1) } else { bits })
        }
        DataType::Subrange(subrange) => parse_as(&subrange.base, text),
        DataType::LongReal => match text.to_ascii_uppercase().as_str() {
            "+INF" | "INF" => Some(f64::INFINITY.to_bits()),
            "-INF" => Some(f64::NEG_INFINITY.to_bits()),
            "NAN" => Some(f64::NAN.to_bits()),
            _ => text.parse::<f64>().ok().map(f64::to_bits),
        },
        DataType::UnsignedLongInt | DataType::LongWord => {
            let digits = text.strip_prefix("16#").map(|digits| digits.replace('_', ""));
            digits.map_or_else(|| text.parse().ok(), |digits| u64::from_str_radix(&digits, 16).ok())
        }
        DataType::LongTime => {
            let upper = text.to_ascii_uppercase();
            let duration = upper.strip_prefix("LT#").or_else(|| upper.strip_prefix("LTIME#")).or_else(|| upper.strip_prefix("T#"))?;
            let (negative, digits) = duration.strip_prefix('-').map_or((false, duration), |digits| (true, digits));
            let nanoseconds = parse_duration(digits)?;
            Some(if negative { nanoseconds.wrapping_neg() } else { nanoseconds })
        }
        _ => None,
    }
}

/// `1S500MS` in nanoseconds; `None` if it is no duration or longer than 292 years.
fn parse_duration(text: &str) -> Option<u64> {
    let mut rest = text;
    let mut total = 0_u64;
    while !rest.is_empty() {
        let (number, behind) = rest.split_at(rest.find(|c: char| !c.is_ascii_digit())?);
        let (unit, behind) = behind.split_at(behind.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(behind.len()));
        let &(_, factor) = UNITS.iter().find(|&&(name, _)| name == unit)?;
        total = total.checked_add(number.parse::<u64>().ok()?.checked_mul(factor)?)?;
        rest = behind.strip_prefix('_').unwrap_or(behind);
    }
    (!text.is_empty() && i64::try_from(total).is_ok()).then_some(total)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::types::Enumeration;

    #[test]
    fn values_are_shown_and_read_back() {
        let colour = Enumeration {
            name: None,
            base: DataType::Int,
            values: vec![("Red".into(), -1), ("Green".into(), 7)],
            initial: -1,
            index: Default::default(),
            named: false,
        };
        let colour = DataType::Enumeration(Arc::new(colour));
        for (data_type, bits, text) in [
            (DataType::LongInt, u64::MAX, "-1"),
            (DataType::SmallInt, 0x80, "-128"),
            (DataType::UnsignedInt, 0xFFFF, "65535"),
            (DataType::LongReal, 1.5_f64.to_bits(), "1.5e+000"),
            (DataType::LongReal, f64::NEG_INFINITY.to_bits(), "-INF"),
            (DataType::LongTime, 1_500_000_000, "LT#1S500MS"),
            (DataType::LongTime, (-1_i64) as u64, "LT#-1NS"),
            (DataType::LongDate, 19_782 * DAY_NS, "LD#2024-02-29"),
            (DataType::LongDateAndTime, 19_782 * DAY_NS + 1, "LDT#2024-02-29-00:00:00.000000001"),
            (DataType::LongTimeOfDay, 3_600_000_000_000, "LTOD#01:00:00.000000000"),
            (DataType::WideChar, 0x20AC, "WCHAR#'€'"),
            (colour.clone(), 0xFFFF, "Red"),
            (colour.clone(), 3, "3"),
        ] {
            assert_eq!(format_as(&data_type, bits).as_deref(), Some(text));
            if let Some(read) = parse_as(&data_type, text) {
                assert_eq!(read, bits, "{text}");
            }
        }
        assert_eq!(parse_as(&colour, "Colour#GREEN"), Some(7));
        assert_eq!(format_as(&DataType::Int, 5), None);
    }

    #[test]
    fn the_calendar_counts_from_1970() {
        assert_eq!(days_of_date(1970, 1, 1), Some(0));
        assert_eq!(days_of_date(2024, 2, 29), Some(19_782));
        assert_eq!(days_of_date(2023, 2, 29), None);
        for days in (0..110_000).step_by(7) {
            let (year, month, day) = date_of_days(days);
            assert_eq!(days_of_date(year as u32, month as u32, day as u32), Some(days));
        }
    }
}
