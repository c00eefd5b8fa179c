//! Values as everyone outside of a CPU sees them: what a value is, and its bits or bytes.

mod shown;

use crate::format::{Figure, Fit, Format};
use crate::literal;
use crate::registers::StatusWord;
use crate::types::DataType;

pub use shown::{Shown, text_of};

/// What a value is, which says how it is shown and counted.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// One bit.
    Bit,
    /// 8, 16, 32 or 64 bits without a type, shown in hex.
    Bits(u32),
    /// So many bytes without a type.
    Bytes(u32),
    /// A whole number that is never negative: timers, counters, numbers and lengths of data blocks.
    Number,
    /// What a timer has left, with its base: the word of S5TIME. To programs it is the count, to people the time.
    TimeLeft,
    /// A value of a data type.
    Typed(DataType),
    /// The status word.
    Status,
    /// Bits or bytes of a kind that a user wants to see in a format.
    Formatted(Format, Box<Kind>),
    /// Characters that stand for themselves: what a recording keeps of strings and of values of enumerations.
    Text,
}

/// The bits or bytes of a value.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Content {
    /// At most 64 bits, right-justified.
    Bits(u64),
    /// Bytes in the order of the S7.
    Bytes(Box<[u8]>),
}

impl Content {
    /// The bits; `None` if it is bytes.
    pub fn bits(&self) -> Option<u64> {
        match self {
            Self::Bits(bits) => Some(*bits),
            Self::Bytes(_) => None,
        }
    }
}

/// A value with what it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// What it is.
    pub kind: Kind,
    /// Its bits or bytes.
    pub content: Content,
}

impl Value {
    /// A value of at most 64 bits.
    pub fn bits(kind: Kind, bits: u64) -> Self {
        Self { kind, content: Content::Bits(bits) }
    }

    /// Bytes without a type.
    pub fn bytes(bytes: impl Into<Box<[u8]>>) -> Self {
        let bytes = bytes.into();
        Self { kind: Kind::Bytes(u32::try_from(bytes.len()).unwrap_or(u32::MAX)), content: Content::Bytes(bytes) }
    }

    /// The value, ready to be shown.
    pub fn shown(&self) -> Shown {
        self.kind.show(&self.content)
    }
}

/// How a recording calls DATE and DT of 64 bits.
const SHORT_DATES: [(&str, DataType); 2] = [("DATE_64", DataType::LongDate), ("DT_64", DataType::LongDateAndTime)];

impl Kind {
    /// The kind of a data type: bits without a sign or name of their own are bits.
    pub fn of_type(data_type: &DataType) -> Self {
        match data_type.base() {
            _ if data_type.is_enumeration() || data_type.stands_in_bytes() || names_a_number(data_type) => Self::Typed(data_type.clone()),
            // LDATE and LDT where DATE and DT have 64 bits as well.
            _ if data_type.counts_nanoseconds() => Self::Typed(data_type.clone()),
            DataType::Bool => Self::Bit,
            DataType::Byte => Self::Bits(8),
            DataType::Word => Self::Bits(16),
            DataType::DoubleWord => Self::Bits(32),
            other if other.word().is_some() && matches!(other.bits(), 1..=64) => Self::Typed(other.clone()),
            other => Self::Bits(u32::try_from(other.bits()).unwrap_or(64).min(64)),
        }
    }

    /// How a recording keeps it: what is no number of at most 64 bits as characters.
    #[must_use]
    pub fn recorded(self) -> Self {
        if self.is_recorded_as_text() { Self::Text } else { self }
    }

    /// Whether a recording keeps characters of it.
    pub fn is_recorded_as_text(&self) -> bool {
        match self {
            Self::Bytes(_) | Self::Text => true,
            Self::Formatted(_, of) => of.is_recorded_as_text(),
            Self::Typed(data_type) => data_type.is_enumeration() || data_type.stands_in_bytes() || names_a_number(data_type),
            _ => false,
        }
    }

    /// The word of its data type: `BOOL`, `WORD`, `STRING[20]`; `None` for what has none of its own.
    pub fn type_word(&self) -> Option<String> {
        Some(match self.plain() {
            Self::Bit => "BOOL".to_owned(),
            Self::Bits(8) => "BYTE".to_owned(),
            Self::Bits(16) => "WORD".to_owned(),
            Self::Bits(32) => "DWORD".to_owned(),
            Self::Bits(64) => "LWORD".to_owned(),
            Self::Typed(DataType::LongDate) => "DATE".to_owned(),
            Self::Typed(DataType::LongDateAndTime) => "DATE_AND_TIME".to_owned(),
            Self::Typed(data_type) => data_type.to_string(),
            _ => return None,
        })
    }

    /// The word for it in the head of a recording; [`Self::from_word`] reads it.
    pub fn word(&self) -> String {
        match self {
            Self::Bit => "bit".to_owned(),
            Self::Bits(width) => format!("bits {width}"),
            Self::Number => "number".to_owned(),
            Self::TimeLeft => "timer".to_owned(),
            Self::Typed(data_type) => {
                // DATE and DT of 64 bits are not what LDATE and LDT are.
                let short = SHORT_DATES.iter().find(|(_, of)| of == data_type).map(|&(word, _)| word);
                format!("type {}", short.or(data_type.word()).or(data_type.base().word()).unwrap_or("WORD"))
            }
            Self::Status => "status".to_owned(),
            Self::Formatted(format, of) => format!("format {format} {}", of.word()),
            Self::Bytes(_) | Self::Text => "text".to_owned(),
        }
    }

    /// Reads what [`Self::word`] writes; `None` for everything else.
    pub fn from_word(word: &str) -> Option<Self> {
        match word {
            "bit" => Some(Self::Bit),
            "number" => Some(Self::Number),
            "timer" => Some(Self::TimeLeft),
            "status" => Some(Self::Status),
            "text" => Some(Self::Text),
            _ => match word.split_once(' ')? {
                ("bits", width) => width.parse().ok().filter(|width| matches!(width, 8 | 16 | 32 | 64)).map(Self::Bits),
                ("format", rest) => {
                    let (format, of) = rest.split_once(' ')?;
                    // A format of a format would nest as deep as a file likes.
                    let of = Self::from_word(of).filter(|of| !matches!(of, Self::Formatted(..)))?;
                    Format::from_name(format).map(|format| Self::Formatted(format, Box::new(of)))
                }
                ("type", word) if SHORT_DATES.iter().any(|(short, _)| *short == word) => {
                    SHORT_DATES.iter().find(|(short, _)| *short == word).map(|(_, data_type)| Self::Typed(data_type.clone()))
                }
                ("type", word) => DataType::from_any_word(word)
                    .map(|data_type| data_type.of_nanoseconds(word))
                    .filter(|data_type| matches!(data_type.bits(), 1..=64))
                    .map(Self::Typed),
                _ => None,
            },
        }
    }

    /// The number of bits; 0 for characters and bytes.
    pub fn width(&self) -> u32 {
        match self {
            Self::Bit => 1,
            Self::Bits(width) => *width,
            Self::Number => 32,
            Self::TimeLeft => 16,
            Self::Typed(data_type) if data_type.stands_in_bytes() => 0,
            Self::Typed(data_type) => data_type.bits().min(64) as u32,
            Self::Status => 9,
            Self::Formatted(_, of) => of.width(),
            Self::Bytes(_) | Self::Text => 0,
        }
    }

    /// What it is without the format that a user wants to see it in.
    #[must_use]
    pub fn plain(&self) -> &Self {
        match self {
            Self::Formatted(_, of) => of.plain(),
            plain => plain,
        }
    }

    /// What the bits mean: the data type that a format stands for.
    pub fn meaning(&self) -> std::borrow::Cow<'_, Self> {
        use std::borrow::Cow;
        match self {
            // The remaining value of a timer is a plain number in every format but that of a time.
            Self::Formatted(format, of) if **of != Self::Number || *format == Format::S5Time => {
                let plain = || Cow::Borrowed(self.plain());
                format.data_type(of.width()).map_or_else(plain, |data_type| Cow::Owned(Self::Typed(data_type)))
            }
            Self::Formatted(..) => Cow::Borrowed(self.plain()),
            plain => Cow::Borrowed(plain),
        }
    }

    /// What it is to the table of formats.
    pub fn fits(&self) -> Vec<Fit> {
        match self {
            Self::Bit => vec![Fit::Bit],
            Self::Bits(width) => vec![Fit::Width(*width)],
            Self::Number | Self::TimeLeft => vec![Fit::Number],
            Self::Status => vec![Fit::Status],
            Self::Bytes(1) => vec![Fit::Bytes, Fit::Width(8)],
            Self::Bytes(2) => vec![Fit::Bytes, Fit::Width(16)],
            Self::Bytes(4) => vec![Fit::Bytes, Fit::Width(32)],
            Self::Bytes(8) => vec![Fit::Bytes, Fit::Width(64)],
            Self::Bytes(6) => vec![Fit::Bytes, Fit::Pointer],
            Self::Bytes(10) => vec![Fit::Bytes, Fit::Any],
            Self::Bytes(_) => vec![Fit::Bytes],
            Self::Typed(DataType::Pointer) => vec![Fit::Pointer],
            Self::Typed(DataType::Any) => vec![Fit::Any],
            Self::Typed(DataType::String(_) | DataType::WideString(_)) => vec![Fit::Characters],
            Self::Typed(data_type) if names_a_number(data_type) => vec![Fit::Number],
            Self::Typed(data_type) if data_type.stands_in_bytes() => vec![Fit::Bytes],
            Self::Typed(data_type) => vec![Fit::Width(data_type.bits().min(64) as u32)],
            Self::Formatted(_, of) => of.fits(),
            Self::Text => Vec::new(),
        }
    }

    /// Whether the value is a whole number that may be negative.
    pub fn is_signed(&self) -> bool {
        if let Self::Formatted(..) = self {
            let meaning = self.meaning();
            return matches!(*meaning, Self::Typed(_)) && meaning.is_signed();
        }
        let Self::Typed(data_type) = self else { return false };
        matches!(
            data_type.base(),
            DataType::Int | DataType::DoubleInt | DataType::SmallInt | DataType::LongInt | DataType::Time | DataType::LongTime
        )
    }

    /// Bits as a number on a scale: TIME and S5TIME in milliseconds, LTIME in nanoseconds, DATE in days. `None` for what has no scale.
    pub fn number(&self, bits: u64) -> Option<f64> {
        match self {
            Self::Formatted(format, of) => match format.show(of, &Content::Bits(bits)).figure {
                Some(Figure::Whole(number)) => Some(number as f64),
                Some(_) => self.meaning().number(bits),
                None if matches!(format, Format::Bcd | Format::Counter) => None,
                None => match &*self.meaning() {
                    Self::Formatted(..) => None,
                    meaning => meaning.number(bits),
                },
            },
            Self::Bit | Self::Number => Some(bits as f64),
            Self::Bits(width) if *width <= 32 => Some(bits as f64),
            Self::Typed(DataType::Real) => Some(f64::from(f32::from_bits(bits as u32))).filter(|number| number.is_finite()),
            Self::Typed(DataType::LongReal) => Some(f64::from_bits(bits)).filter(|number| number.is_finite()),
            Self::TimeLeft | Self::Typed(DataType::S5Time) => literal::s5time_milliseconds(bits as u16).map(|ms| ms as f64),
            Self::Typed(DataType::Char | DataType::WideChar | DataType::DateAndTime) => None,
            Self::Typed(data_type) if *data_type.base() == DataType::LongDateAndTime => None,
            Self::Typed(_) if self.is_signed() => Some(self.signed(bits) as f64),
            Self::Typed(DataType::LongWord) => None,
            Self::Typed(_) => Some(bits as f64),
            Self::Bits(_) | Self::Bytes(_) | Self::Status | Self::Text => None,
        }
    }

    /// As [`Self::number`]; words and double words without a type have a sign, as `>I` and `>D` see them.
    pub fn scale(&self, bits: u64) -> Option<f64> {
        match self {
            Self::Bits(16 | 32) => Some(self.signed(bits) as f64),
            Self::Formatted(Format::Bin | Format::Hex, of) => of.scale(bits),
            _ => self.number(bits),
        }
    }

    /// The bits as a signed number of their width.
    pub fn signed(&self, bits: u64) -> i64 {
        match self.width() {
            width @ 1..=63 => (bits << (64 - width)) as i64 >> (64 - width),
            _ => bits as i64,
        }
    }

    /// How two values compare: as REAL if they are, words and double words with their sign, as `>I` and `>D` do, all else without.
    /// `None` if one of them is no number.
    pub fn compare(&self, left: u64, right: u64) -> Option<std::cmp::Ordering> {
        match self {
            Self::TimeLeft | Self::Formatted(Format::Bcd | Format::Counter, _) => self.number(left)?.partial_cmp(&self.number(right)?),
            Self::Formatted(..) => self.meaning().compare(left, right),
            Self::Typed(DataType::Real) => f32::from_bits(left as u32).partial_cmp(&f32::from_bits(right as u32)),
            Self::Typed(DataType::LongReal) => f64::from_bits(left).partial_cmp(&f64::from_bits(right)),
            Self::Bits(16 | 32) => Some(self.signed(left).cmp(&self.signed(right))),
            Self::Typed(_) if self.is_signed() => Some(self.signed(left).cmp(&self.signed(right))),
            _ => Some(left.cmp(&right)),
        }
    }

    /// Content as it is shown.
    pub fn show(&self, content: &Content) -> Shown {
        match (self, content) {
            (Self::Formatted(format, of), content) => Shown::Formatted(Box::new(format.show(of, content))),
            (Self::Typed(data_type @ DataType::WideString(_)), Content::Bytes(bytes)) => Shown::Wide(text_of(bytes, data_type)),
            (Self::Typed(data_type @ DataType::Pointer), Content::Bytes(bytes)) => {
                Shown::Twofold { plain: text_of(bytes, data_type), readable: Format::Pointer.show(self, content).text }
            }
            (Self::Typed(data_type), Content::Bytes(bytes)) => Shown::Text(text_of(bytes, data_type)),
            (_, Content::Bytes(bytes)) => Shown::Text(shown::hex_of(bytes)),
            (Self::Typed(data_type), Content::Bits(bits)) => match number_letters(data_type) {
                Some(letters) => Shown::Text(format!("{letters} {bits}")),
                None => Shown::of_bits(*bits, self.width(), Some(data_type)),
            },
            (Self::Bit, Content::Bits(bits)) => Shown::Bit(*bits != 0),
            (Self::Bits(width), Content::Bits(bits)) => Shown::Hex { bits: *bits, digits: (*width / 4) as usize },
            (Self::TimeLeft, Content::Bits(bits)) => Shown::TimeLeft(*bits as u16),
            (Self::Number, Content::Bits(bits)) => Shown::Number(i64::try_from(*bits).unwrap_or(i64::MAX)),
            (Self::Status, Content::Bits(bits)) => Shown::Status(StatusWord(*bits as u16)),
            (Self::Bytes(_) | Self::Text, Content::Bits(_)) => Shown::Text(String::new()),
        }
    }
}

/// What stands before the number of a timer, counter or block that a caller gave.
fn number_letters(data_type: &DataType) -> Option<&'static str> {
    Some(match data_type {
        DataType::Timer => "T",
        DataType::Counter => "C",
        DataType::BlockFunction => "FC",
        DataType::BlockFunctionBlock => "FB",
        DataType::BlockData => "DB",
        DataType::BlockSystemData => "SDB",
        _ => return None,
    })
}

/// Whether a parameter of the type holds the number of a timer, counter or block.
pub(crate) fn names_a_number(data_type: &DataType) -> bool {
    number_letters(data_type).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_of_64_bits_are_kept_and_shown_as_their_sources_call_them() {
        let bits = 19_782 * 86_400_000_000_000;
        for (data_type, word, plain, readable) in [
            (DataType::LongDate, "DATE", "LD#2024-02-29", "D#2024-02-29"),
            (DataType::LongDate.of_nanoseconds("LDATE"), "LDATE", "LD#2024-02-29", "LD#2024-02-29"),
            (DataType::LongDateAndTime, "DATE_AND_TIME", "LDT#2024-02-29-00:00:00.000000000", "DT#2024-02-29-00:00:00.000000000"),
            (
                DataType::LongDateAndTime.of_nanoseconds("LDT"),
                "LDT",
                "LDT#2024-02-29-00:00:00.000000000",
                "LDT#2024-02-29-00:00:00.000000000",
            ),
        ] {
            let kind = Kind::of_type(&data_type);
            let shown = kind.show(&Content::Bits(bits));
            assert_eq!((shown.to_string().as_str(), shown.readable().as_str()), (plain, readable), "{data_type}");
            assert_eq!(kind.type_word().as_deref(), Some(word));
            // What a recording says of it is the same kind again.
            assert_eq!(Kind::from_word(&kind.word()), Some(kind), "{data_type}");
        }
    }
}
