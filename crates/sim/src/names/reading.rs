//! What a value is, apart from the CPU it came from: raw bits with the kind that says how they are shown and counted.

use std::fmt;

use sieben_cpu::Cpu;
use sieben_engine::machine::{Register, StatusWord};
use sieben_model::address::Operand;
use sieben_model::literal;
use sieben_model::types::DataType;

use super::{Name, NameError, Shown, Target, is_one_number, is_status, operand_width, shown};

/// Longest text that a [`Sample`] keeps, in bytes; the rest is cut, so that a recording of long strings stays small.
pub const TEXT_BYTES_MAX: usize = 4096;

/// How the bits of a value are shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// One bit.
    Bit,
    /// 8, 16, 32 or 64 bits without a type, shown in hex.
    Bits(u32),
    /// A whole number that is never negative: timers, counters, numbers and lengths of data blocks.
    Number,
    /// Bits with an elementary type of at most 64 bits.
    Typed(DataType),
    /// The status word.
    Status,
    /// Text that stands for itself: strings, values of enumerations.
    Text,
}

/// A value at one moment.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub enum Sample {
    /// There was none: the data block was not loaded.
    #[default]
    Absent,
    /// The bits, right-justified.
    Bits(u64),
    /// Text, of at most [`TEXT_BYTES_MAX`] bytes.
    Text(Box<str>),
}

impl Sample {
    /// A text, cut where it is too long.
    pub fn text(text: &str) -> Self {
        if text.len() <= TEXT_BYTES_MAX {
            return Self::Text(text.into());
        }
        let end = (0..=TEXT_BYTES_MAX - '…'.len_utf8()).rev().find(|&end| text.is_char_boundary(end)).unwrap_or(0);
        Self::Text(format!("{}…", &text[..end]).into())
    }
}

impl Kind {
    /// The kind of a type of at most 64 bits.
    fn of_type(data_type: &DataType) -> Self {
        if is_enumeration(data_type) {
            return Self::Text;
        }
        match data_type.base() {
            DataType::Bool => Self::Bit,
            DataType::Byte => Self::Bits(8),
            DataType::Word => Self::Bits(16),
            DataType::DoubleWord => Self::Bits(32),
            other if other.word().is_some() && matches!(other.bits(), 1..=64) => Self::Typed(other.clone()),
            other => Self::Bits(u32::try_from(other.bits()).unwrap_or(64).min(64)),
        }
    }

    /// The word for it in the head of a recording; [`Self::from_word`] reads it.
    pub fn word(&self) -> String {
        match self {
            Self::Bit => "bit".to_owned(),
            Self::Bits(width) => format!("bits {width}"),
            Self::Number => "number".to_owned(),
            Self::Typed(data_type) => format!("type {}", data_type.word().unwrap_or("WORD")),
            Self::Status => "status".to_owned(),
            Self::Text => "text".to_owned(),
        }
    }

    /// Reads what [`Self::word`] writes; `None` for everything else.
    pub fn from_word(word: &str) -> Option<Self> {
        match word {
            "bit" => Some(Self::Bit),
            "number" => Some(Self::Number),
            "status" => Some(Self::Status),
            "text" => Some(Self::Text),
            _ => match word.split_once(' ')? {
                ("bits", width) => width.parse().ok().filter(|width| matches!(width, 8 | 16 | 32 | 64)).map(Self::Bits),
                ("type", word) => DataType::from_any_word(word).filter(|data_type| matches!(data_type.bits(), 1..=64)).map(Self::Typed),
                _ => None,
            },
        }
    }

    /// The number of bits; 0 for text.
    pub fn width(&self) -> u32 {
        match self {
            Self::Bit => 1,
            Self::Bits(width) => *width,
            Self::Number => 32,
            Self::Typed(data_type) => data_type.bits() as u32,
            Self::Status => 9,
            Self::Text => 0,
        }
    }

    /// Bits as they are shown.
    pub(crate) fn shown(&self, bits: u64) -> Shown {
        match self {
            Self::Bit => Shown::Bit(bits != 0),
            Self::Bits(width) => Shown::Hex { bits, digits: (*width / 4) as usize },
            Self::Number => Shown::Number(i64::try_from(bits).unwrap_or(i64::MAX)),
            Self::Typed(data_type) => shown(bits, data_type.bits() as u32, Some(data_type)),
            Self::Status => Shown::Status(StatusWord(bits as u16)),
            Self::Text => Shown::Text(String::new()),
        }
    }

    /// A value as it is shown; `None` if there is none.
    pub fn show(&self, value: &Sample) -> Option<Shown> {
        match value {
            Sample::Absent => None,
            Sample::Bits(bits) => Some(self.shown(*bits)),
            Sample::Text(text) => Some(Shown::Text(text.to_string())),
        }
    }

    /// A value as text; `-` if there is none.
    pub fn display<'a>(&'a self, value: &'a Sample) -> Displayed<'a> {
        Displayed { kind: self, value }
    }

    /// Whether the value is a whole number that may be negative.
    pub fn is_signed(&self) -> bool {
        let Self::Typed(data_type) = self else { return false };
        matches!(
            data_type,
            DataType::Int | DataType::DoubleInt | DataType::SmallInt | DataType::LongInt | DataType::Time | DataType::LongTime
        )
    }

    /// The value as a number on a scale: TIME and S5TIME in milliseconds, LTIME in nanoseconds, DATE in days. `None` for what has no scale.
    pub fn number(&self, value: &Sample) -> Option<f64> {
        let Sample::Bits(bits) = value else { return None };
        match self {
            Self::Bit | Self::Number => Some(*bits as f64),
            Self::Bits(width) if *width <= 32 => Some(*bits as f64),
            Self::Typed(DataType::Real) => Some(f64::from(f32::from_bits(*bits as u32))).filter(|number| number.is_finite()),
            Self::Typed(DataType::LongReal) => Some(f64::from_bits(*bits)).filter(|number| number.is_finite()),
            Self::Typed(DataType::S5Time) => literal::s5time_milliseconds(*bits as u16).map(|ms| ms as f64),
            Self::Typed(DataType::Char | DataType::WideChar | DataType::DateAndTime | DataType::LongDateAndTime) => None,
            Self::Typed(_) if self.is_signed() => Some(self.signed(*bits) as f64),
            Self::Typed(DataType::LongWord) => None,
            Self::Typed(_) => Some(*bits as f64),
            Self::Bits(_) | Self::Status | Self::Text => None,
        }
    }

    /// As [`Self::number`]; words and double words without a type have a sign, as `>I` and `>D` see them.
    pub(crate) fn scale(&self, value: &Sample) -> Option<f64> {
        match (self, value) {
            (Self::Bits(16 | 32), Sample::Bits(bits)) => Some(self.signed(*bits) as f64),
            _ => self.number(value),
        }
    }

    /// The bits as a signed number of their width.
    pub(crate) fn signed(&self, bits: u64) -> i64 {
        match self.width() {
            width @ 1..=63 => (bits << (64 - width)) as i64 >> (64 - width),
            _ => bits as i64,
        }
    }
}

/// Whether values of the type have names.
fn is_enumeration(data_type: &DataType) -> bool {
    match data_type {
        DataType::Enumeration(_) => true,
        DataType::Subrange(subrange) => is_enumeration(&subrange.base),
        _ => false,
    }
}

/// A value ready to be written.
#[derive(Clone, Copy, Debug)]
pub struct Displayed<'a> {
    kind: &'a Kind,
    value: &'a Sample,
}

impl fmt::Display for Displayed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.value {
            Sample::Absent => f.write_str("-"),
            Sample::Bits(bits) => self.kind.shown(*bits).fmt(f),
            Sample::Text(text) => f.write_str(text),
        }
    }
}

impl Name {
    /// What its value is.
    pub fn kind(&self) -> Kind {
        match &self.target {
            Target::TimerStatus(_) => Kind::Bit,
            Target::Status => Kind::Status,
            Target::Register(register) if is_status(*register) => Kind::Bit,
            Target::Register(Register::DbNumber | Register::DbLength | Register::DiNumber | Register::DiLength) => Kind::Number,
            Target::Register(_) => Kind::Bits(32),
            Target::Operand(Operand::Timer(_) | Operand::Counter(_), _) => Kind::Number,
            Target::Operand(operand, data_type) => match (operand_width(operand), data_type) {
                (1, _) => Kind::Bit,
                (_, Some(data_type)) => Kind::of_type(data_type),
                (width, None) => Kind::Bits(width),
            },
            Target::Field { data_type, .. } if is_one_number(data_type) => Kind::of_type(data_type),
            Target::Field { .. } => Kind::Text,
            Target::Local(local) => match (local.width(), &local.data_type) {
                (None, _) | (_, DataType::Timer | DataType::Counter) => Kind::Text,
                (_, DataType::BlockFunction | DataType::BlockFunctionBlock | DataType::BlockData | DataType::BlockSystemData) => Kind::Text,
                (Some(_), data_type) => Kind::of_type(data_type),
            },
        }
    }

    /// The value in a CPU, to be kept beside the [`Self::kind`].
    ///
    /// # Errors
    /// The CPU has nothing of that name.
    pub fn sample(&self, cpu: &Cpu) -> Result<Sample, NameError> {
        match &self.target {
            Target::Field { data_type, .. } if !is_one_number(data_type) => self.read(cpu).map(|shown| Sample::text(&shown.to_string())),
            Target::Local(_) if self.kind() == Kind::Text => self.read(cpu).map(|shown| Sample::text(&shown.to_string())),
            Target::Operand(_, Some(data_type)) | Target::Field { data_type, .. } if is_enumeration(data_type) => {
                self.read(cpu).map(|shown| Sample::text(&shown.to_string()))
            }
            _ => self.bits(cpu).map(Sample::Bits),
        }
    }
}
