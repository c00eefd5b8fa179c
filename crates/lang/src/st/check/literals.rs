//! Constants as written → values of a type.

use sieben_model::address::Area;
use sieben_model::literal::Value as Pointer;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::types::{Class, Kind, bounds};
use crate::st::ast::{DateAndTimeForm, LiteralKind};
use crate::st::dialect::{Calendar, Construct, Dialect};
use crate::st::tree::{Base, Place};

/// Days from 1970-01-01 to 1990-01-01, where DATE of the S7 begins.
const DAYS_TO_1990: u32 = 7305;
/// The last day of a DATE of the S7, 2168-12-31, in days since 1990-01-01.
const S7_DAYS_MAX: u32 = 65378;
const NANOSECONDS_OF_MILLISECOND: i64 = 1_000_000;
const NANOSECONDS_OF_DAY: i64 = 86_400_000 * NANOSECONDS_OF_MILLISECOND;

/// Why a constant cannot be a value of a type.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Misfit {
    /// It is of another type.
    Type,
    /// It is outside the range, which is told in words.
    Range(String),
}

/// The bits of a constant as a value of this kind, with what the dialect has to say about the way it is written.
pub(crate) fn bits(literal: &LiteralKind, kind: Kind, dialect: Dialect) -> Result<(u64, Option<Construct>), Misfit> {
    let plain = |bits: u64| Ok((bits, None));
    match (literal, kind.class) {
        (LiteralKind::Bool(value), Class::Bits) if kind.bits == 1 => plain(u64::from(*value)),
        (LiteralKind::Integer { value, radix }, Class::Bits | Class::Signed | Class::Unsigned) => {
            let number = integer(*value, *radix, kind, dialect)?;
            let construct = match kind {
                Kind::BOOL => Some(Construct::NumberToBool),
                Kind { class: Class::Bits, .. } if *radix == 10 => Some(Construct::DecimalToBitString),
                _ => None,
            };
            Ok((number, construct))
        }
        (LiteralKind::Integer { value, .. }, Class::Real) => plain(real_bits(*value as f64, *value as f32, kind)),
        (LiteralKind::Real { value, single }, Class::Real) => {
            if kind.bits == 32 && single.is_infinite() && value.is_finite() {
                return Err(Misfit::Range("-3.402823E38 to 3.402823E38".to_owned()));
            }
            plain(real_bits(*value, *single, kind))
        }
        (LiteralKind::Duration { nanoseconds, .. }, Class::Duration) => duration(*nanoseconds, kind, dialect).map(|bits| (bits, None)),
        (LiteralKind::S5Time(word) | LiteralKind::Counter(word), Class::S5Time | Class::Bits) if kind.bits == 16 => plain(u64::from(*word)),
        (LiteralKind::Date { days, .. }, Class::Date) => {
            if kind.bits == 64 {
                return plain(u64::from(*days).wrapping_mul(NANOSECONDS_OF_DAY as u64));
            }
            let range = || Misfit::Range("1990-01-01 to 2168-12-31".to_owned());
            let day = days.checked_sub(DAYS_TO_1990).filter(|&day| day <= S7_DAYS_MAX).ok_or_else(range)?;
            plain(u64::from(day))
        }
        (LiteralKind::TimeOfDay { nanoseconds, .. }, Class::TimeOfDay) => match kind.bits {
            64 => plain(*nanoseconds),
            _ => plain(nanoseconds / NANOSECONDS_OF_MILLISECOND as u64),
        },
        (LiteralKind::DateAndTime { nanoseconds, .. }, Class::DateAndTime) => plain(*nanoseconds as u64),
        (LiteralKind::Characters(text), Class::Character) => match (text.as_slice(), kind.bits) {
            ([byte], 8 | 16) => plain(u64::from(*byte)),
            _ => Err(Misfit::Type),
        },
        (LiteralKind::WideCharacters(text), Class::Character) => match (text.as_slice(), kind.bits) {
            ([unit], 16) => plain(u64::from(*unit)),
            _ => Err(Misfit::Type),
        },
        (LiteralKind::Integer { value: 0, .. }, Class::Reference) => plain(0),
        (LiteralKind::Null, Class::Reference) => plain(0),
        (LiteralKind::Integer { value, .. }, Class::Character) if (0..1 << kind.bits).contains(value) => plain(*value as u64),
        _ => Err(Misfit::Type),
    }
}

/// The bits of a whole number.
fn integer(value: i128, radix: u8, kind: Kind, dialect: Dialect) -> Result<u64, Misfit> {
    let scalar = kind.scalar(dialect);
    let (low, high) = bounds(scalar);
    // 16#FFFF is the bit pattern of -1 where the numbers of a controller are bit patterns.
    let pattern = radix != 10 && kind.class == Class::Signed && dialect.switches().numbered_blocks && value >= 0 && value >> kind.bits == 0;
    if !(low..=high).contains(&value) && !pattern {
        return Err(Misfit::Range(format!("{low} to {high}")));
    }
    Ok(value as u64 & mask(kind.bits))
}

/// The lowest `bits` bits.
pub(crate) fn mask(bits: u32) -> u64 {
    1_u64.checked_shl(bits).map_or(u64::MAX, |bit| bit - 1)
}

fn real_bits(value: f64, single: f32, kind: Kind) -> u64 {
    if kind.bits == 32 { u64::from(single.to_bits()) } else { value.to_bits() }
}

fn duration(nanoseconds: i64, kind: Kind, dialect: Dialect) -> Result<u64, Misfit> {
    let signed = dialect.switches().time_signed;
    if kind.bits == 64 {
        return Ok(nanoseconds as u64);
    }
    if !signed && nanoseconds < 0 {
        return Err(Misfit::Range("0 ms and more: TIME has no sign here".to_owned()));
    }
    let milliseconds = nanoseconds / NANOSECONDS_OF_MILLISECOND;
    match signed {
        true => i32::try_from(milliseconds).map(|value| u64::from(value as u32)).ok(),
        false => u32::try_from(milliseconds).map(u64::from).ok(),
    }
    .ok_or_else(|| Misfit::Range(if signed { "-24d20h31m23s648ms to 24d20h31m23s647ms" } else { "0 ms to 49d17h2m47s295ms" }.to_owned()))
}

/// The type that a constant says by itself; `None` for a number without prefix, a text, NULL.
pub(crate) fn natural(literal: &LiteralKind, dialect: Dialect) -> Option<DataType> {
    let s7 = dialect.switches().calendar == Calendar::S7;
    Some(match literal {
        LiteralKind::Bool(_) => DataType::Bool,
        LiteralKind::Duration { long, .. } => {
            if *long {
                DataType::LongTime
            } else {
                DataType::Time
            }
        }
        LiteralKind::S5Time(_) => DataType::S5Time,
        LiteralKind::Date { long, .. } => {
            if *long || !s7 {
                DataType::LongDate
            } else {
                DataType::Date
            }
        }
        LiteralKind::TimeOfDay { long, .. } => {
            if *long {
                DataType::LongTimeOfDay
            } else {
                DataType::TimeOfDay
            }
        }
        LiteralKind::DateAndTime { form: DateAndTimeForm::Short, .. } if s7 => DataType::DateAndTime,
        LiteralKind::DateAndTime { .. } => DataType::LongDateAndTime,
        LiteralKind::Counter(_) => DataType::Word,
        LiteralKind::Pointer(Pointer::Any(_)) => DataType::Any,
        LiteralKind::Pointer(_) => DataType::Pointer,
        LiteralKind::Integer { .. }
        | LiteralKind::Real { .. }
        | LiteralKind::Characters(_)
        | LiteralKind::WideCharacters(_)
        | LiteralKind::Null => return None,
    })
}

/// The type of a whole number that nothing else gives one.
pub(crate) fn integer_kind(value: i128) -> Kind {
    let fits = |kind: &Kind| {
        let (low, high) = bounds(kind.scalar(Dialect::Iec));
        (low..=high).contains(&value)
    };
    [Kind::INT, Kind::DINT, Kind::LINT].into_iter().find(fits).unwrap_or(Kind { class: Class::Unsigned, bits: 64 })
}

/// The eight bytes of a point in time in the form of the S7, in nanoseconds since 1970; `None` outside 1990 to 2089.
pub(crate) fn date_and_time(nanoseconds: i64) -> Option<[u8; 8]> {
    let (days, rest) = (nanoseconds.div_euclid(NANOSECONDS_OF_DAY), nanoseconds.rem_euclid(NANOSECONDS_OF_DAY));
    let (year, month, day) = civil(days);
    if !(1990..2090).contains(&year) {
        return None;
    }
    let milliseconds = rest / NANOSECONDS_OF_MILLISECOND;
    let bcd = |value: i64| (value / 10 % 10 * 16 + value % 10) as u8;
    // 1970-01-01 was a Thursday; 1 is Sunday.
    let weekday = (days + 4).rem_euclid(7) + 1;
    Some([
        bcd(year % 100),
        bcd(month),
        bcd(day),
        bcd(milliseconds / 3_600_000),
        bcd(milliseconds / 60_000 % 60),
        bcd(milliseconds / 1000 % 60),
        bcd(milliseconds % 1000 / 10),
        (milliseconds % 10 * 16 + weekday) as u8,
    ])
}

/// Year, month and day of a day since 1970-01-01.
fn civil(days: i64) -> (i64, i64, i64) {
    // Years that begin in March, in eras of 400 years.
    let shifted = days + 719_468;
    let era = shifted.div_euclid(146_097);
    let day_of_era = shifted.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let month = if month_from_march < 10 { month_from_march + 3 } else { month_from_march - 9 };
    (year_of_era + era * 400 + i64::from(month <= 2), month, day_of_year - (153 * month_from_march + 2) / 5 + 1)
}

/// Where a pointer constant points, and to what: a POINTER to a bit, an ANY to as many elements as it says.
pub(crate) fn pointed(pointer: &Pointer, span: Span) -> Option<(Place, DataType)> {
    let place = |base, offset| Place { base, offset, indexes: Vec::new(), span };
    let base = |db: u16, code: u8| {
        Some(match code {
            0x84 | 0x85 if db > 0 => Base::DataBlock(db),
            code => {
                Base::Area([Area::Input, Area::Output, Area::BitMemory, Area::Local].into_iter().find(|area| area.pointer_code() == code)?)
            }
        })
    };
    match *pointer {
        Pointer::Pointer(word) => Some((place(base(0, (word >> 24) as u8)?, word & 0x00FF_FFFF), DataType::Bool)),
        Pointer::DataPointer { db, pointer } => Some((place(base(db, (pointer >> 24) as u8)?, pointer & 0x00FF_FFFF), DataType::Bool)),
        Pointer::Any([_, code, high, low, db_high, db_low, area, a, b, c]) => {
            let element = match code {
                0x01 => DataType::Bool,
                0x02 => DataType::Byte,
                0x03 => DataType::Char,
                0x04 => DataType::Word,
                0x05 => DataType::Int,
                0x06 => DataType::DoubleWord,
                0x07 => DataType::DoubleInt,
                0x08 => DataType::Real,
                0x0B => DataType::Time,
                0x0C => DataType::S5Time,
                0x0E => DataType::DateAndTime,
                _ => return None,
            };
            let count = i32::from(u16::from_be_bytes([high, low]));
            let data_type = match count {
                0 => return None,
                1 => element,
                count => DataType::Array { bounds: vec![(1, count)], element: Box::new(element) },
            };
            Some((place(base(u16::from_be_bytes([db_high, db_low]), area)?, u32::from_be_bytes([0, a, b, c])), data_type))
        }
        _ => None,
    }
}

/// The code of the type and the count of an ANY that is written as a constant.
pub(crate) fn written_any(pointer: &Pointer) -> Option<(u8, u32)> {
    match *pointer {
        Pointer::Any([_, code, high, low, ..]) => Some((code, u32::from(u16::from_be_bytes([high, low])))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: i128) -> LiteralKind {
        LiteralKind::Integer { value, radix: 10 }
    }

    #[test]
    fn a_number_takes_the_type_of_its_place() {
        assert_eq!(bits(&number(-5), Kind::INT, Dialect::Iec), Ok((0xFFFB, None)));
        assert_eq!(bits(&number(5), Kind::REAL, Dialect::Iec), Ok((u64::from(5.0_f32.to_bits()), None)));
        assert_eq!(bits(&number(1), Kind::BOOL, Dialect::Iec), Ok((1, Some(Construct::NumberToBool))));
        assert!(matches!(bits(&number(32768), Kind::INT, Dialect::Iec), Err(Misfit::Range(_))));
        assert_eq!(bits(&number(5), Kind::TIME, Dialect::Iec), Err(Misfit::Type));
        let pattern = LiteralKind::Integer { value: 0xFFFF, radix: 16 };
        assert_eq!(bits(&pattern, Kind::INT, Dialect::Scl), Ok((0xFFFF, None)));
        assert!(bits(&pattern, Kind::INT, Dialect::Iec).is_err());
    }

    #[test]
    fn a_duration_without_sign_is_not_negative() {
        let literal = LiteralKind::Duration { nanoseconds: -5_000_000_000, long: false };
        assert_eq!(bits(&literal, Kind::TIME, Dialect::Iec), Ok((u64::from(-5000_i32 as u32), None)));
        assert!(bits(&literal, Kind::TIME, Dialect::Codesys).is_err());
    }

    #[test]
    fn a_point_in_time_has_its_digits() {
        // 2024-02-29-12:34:56.789 was a Thursday.
        let nanoseconds = 1_709_210_096_789_000_000;
        assert_eq!(date_and_time(nanoseconds), Some([0x24, 0x02, 0x29, 0x12, 0x34, 0x56, 0x78, 0x95]));
        assert_eq!(date_and_time(0), None);
    }

    #[test]
    fn a_date_of_the_controller_counts_from_1990() {
        let kind = Kind { class: Class::Date, bits: 16 };
        assert_eq!(bits(&LiteralKind::Date { days: DAYS_TO_1990 + 1, long: false }, kind, Dialect::Scl), Ok((1, None)));
        assert!(bits(&LiteralKind::Date { days: DAYS_TO_1990 - 1, long: false }, kind, Dialect::Scl).is_err());
    }
}
