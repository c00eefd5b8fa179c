//! How values are written for people.

use std::fmt;

use crate::bcd;
use crate::format::{Formatted, spell_long_real, spell_real};
use crate::literal::{self, Value as Constant};
use crate::registers::StatusWord;
use crate::types::DataType;

/// A value, ready to be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Shown {
    /// A bit.
    Bit(bool),
    /// Bits without a type, shown in hex with so many digits.
    Hex {
        /// The bits, right-justified.
        bits: u64,
        /// 2, 4, 8 or 16.
        digits: usize,
    },
    /// A number: timers, counters, INT and DINT.
    Number(i64),
    /// What a timer has left, as the word of S5TIME.
    TimeLeft(u16),
    /// A REAL.
    Real(f32),
    /// An LREAL.
    LongReal(f64),
    /// The status word.
    Status(StatusWord),
    /// A constant in the notation of its type.
    Text(String),
    /// What programs get in one notation and people in another: a DATE or DT of 64 bits as `LD#…` and `D#…`, a POINTER as bytes and as `P#…`.
    Twofold {
        /// To programs.
        plain: String,
        /// To people.
        readable: String,
    },
    /// The characters of a WSTRING.
    Wide(String),
    /// A value in the format that a user asked for.
    Formatted(Box<Formatted>),
}

impl Shown {
    /// As people read it, beside the bits also the number that they are: `16#FFFE (-2)`, `10.0`, `"…"` for a WSTRING.
    pub fn readable(&self) -> String {
        match self {
            Self::Hex { bits, digits } => {
                let number = match digits {
                    4 => i64::from(*bits as u16 as i16),
                    8 => i64::from(*bits as u32 as i32),
                    _ => *bits as i64,
                };
                format!("{self} ({number})")
            }
            Self::TimeLeft(word) => literal::format_as(&DataType::S5Time, u64::from(*word)),
            Self::Real(value) => spell_real(*value),
            Self::LongReal(value) => spell_long_real(*value),
            Self::Twofold { readable, .. } => readable.clone(),
            Self::Wide(text) => literal::spell_wide(text),
            shown => shown.to_string(),
        }
    }
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bit(bit) => write!(f, "{}", u8::from(*bit)),
            Self::Hex { bits, digits } if *digits > 4 => {
                let hex = format!("{bits:0digits$X}");
                let groups: Vec<&str> = hex.as_bytes().chunks(4).filter_map(|group| std::str::from_utf8(group).ok()).collect();
                write!(f, "16#{}", groups.join("_"))
            }
            Self::Hex { bits, digits } => write!(f, "16#{bits:0digits$X}"),
            Self::Number(number) => write!(f, "{number}"),
            Self::TimeLeft(word) => write!(f, "{}", bcd::decode(u32::from(*word), 3)),
            Self::Real(value) => f.write_str(&literal::format_as(&DataType::Real, u64::from(value.to_bits()))),
            Self::LongReal(value) => f.write_str(&literal::format_as(&DataType::LongReal, value.to_bits())),
            Self::Status(word) => write!(f, "{word}"),
            Self::Text(text) | Self::Twofold { plain: text, .. } => f.write_str(text),
            Self::Wide(text) => write!(f, "'{text}'"),
            Self::Formatted(formatted) => f.write_str(&formatted.text),
        }
    }
}

impl Shown {
    /// Bits by their type if that says more than their width.
    pub(super) fn of_bits(bits: u64, width: u32, data_type: Option<&DataType>) -> Self {
        match data_type.map(DataType::base) {
            _ if width == 1 => Self::Bit(bits != 0),
            Some(DataType::LongReal) => Self::LongReal(f64::from_bits(bits)),
            Some(DataType::LongDate | DataType::LongDateAndTime) if data_type.is_some_and(|of| !of.counts_nanoseconds()) => {
                let plain = literal::format_as(data_type.unwrap_or(&DataType::Word), bits);
                Self::Twofold { readable: plain.trim_start_matches('L').to_owned(), plain }
            }
            Some(_) if data_type.is_some_and(literal::elsewhere::is_elsewhere) => {
                let text = literal::format_as(data_type.unwrap_or(&DataType::Word), bits);
                // Integers of up to 32 bits are numbers to every reader of JSON, those of 64 bits are not.
                text.parse().ok().filter(|_| width <= 32).map_or(Self::Text(text), Self::Number)
            }
            Some(DataType::DateAndTime) => Self::Text(literal::format_as(&DataType::DateAndTime, bits)),
            Some(DataType::Int) => Self::Number(i64::from(bits as u16 as i16)),
            Some(DataType::DoubleInt) => Self::Number(i64::from(bits as u32 as i32)),
            Some(DataType::Real) => Self::Real(f32::from_bits(bits as u32)),
            Some(DataType::Char | DataType::Date | DataType::TimeOfDay | DataType::Time | DataType::S5Time) => {
                Self::Text(literal::format_as(data_type.unwrap_or(&DataType::Word), bits))
            }
            _ => Self::Hex { bits, digits: (width / 4) as usize },
        }
    }
}

/// Bytes of a type that is no number, as people read them; the characters of a WSTRING by themselves.
pub fn text_of(bytes: &[u8], data_type: &DataType) -> String {
    match data_type {
        DataType::String(_) => {
            let count = usize::from(bytes.get(1).copied().unwrap_or(0));
            Constant::Characters(bytes.iter().skip(2).take(count).copied().collect()).spell()
        }
        DataType::WideString(_) => {
            let word = |at: usize| bytes.get(at..at + 2).map_or(0, |pair| u16::from_be_bytes([pair[0], pair[1]]));
            let units: Vec<u16> = (0..usize::from(word(2))).map(|index| word(4 + 2 * index)).collect();
            String::from_utf16_lossy(&units)
        }
        DataType::Any => <[u8; 10]>::try_from(bytes).map(|bytes| Constant::Any(bytes).spell()).unwrap_or_default(),
        _ => hex_of(bytes),
    }
}

/// Bytes as two hex digits each.
pub(super) fn hex_of(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ")
}
