//! Items: what has a value in a CPU, as everyone outside names it.

mod reading;

use crate::address::{Area, Operand, Width};
use crate::block::BlockId;
use crate::format::{Fit, Format, FormatError};
use crate::registers::{Register, STATUS_BITS};
use crate::types::DataType;
use crate::value::{Content, Kind};

pub use reading::ValueError;

/// Something that has a value in a CPU.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Where it is.
    pub place: Place,
    /// What its value is.
    pub kind: Kind,
}

/// Where a value is.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// An address, the remaining value of a timer, the count of a counter.
    Operand(Operand),
    /// The status bit of a timer.
    TimerStatus(u16),
    /// Bytes of an area or of a data block, one after the other.
    Bytes(Bytes),
    /// A variable of a block, while it runs.
    Local(Local),
    /// A register of 32 bits, or one status bit.
    Register(Register),
    /// All nine status bits.
    Status,
    /// Nowhere: a constant of the source, with its value.
    Constant(Content),
}

/// Bytes of an area or of a data block, one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bytes {
    /// The data block, if they lie in one.
    pub db: Option<u16>,
    /// The area; [`Area::SharedData`] for those in a data block.
    pub area: Area,
    /// The first byte.
    pub byte: u32,
    /// How many.
    pub length: u32,
}

/// A variable of a block, or a part of it: where it lies depends on who called the block.
#[derive(Clone, Debug, PartialEq)]
pub struct Local {
    /// The block.
    pub block: BlockId,
    /// Where it begins.
    pub start: Start,
    /// Its type.
    pub data_type: DataType,
}

/// Where a variable of a block begins. Positions are in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// In the local data.
    Temp(u32),
    /// In the instance.
    Instance(u32),
    /// Where a POINTER in the instance leads.
    InstancePointer {
        /// Where the POINTER is.
        position: u32,
        /// How far after its target.
        offset: u32,
    },
    /// Where the pointer leads that the caller gave.
    Parameter {
        /// The parameter.
        index: u16,
        /// How far after its target.
        offset: u32,
    },
    /// Where a POINTER leads that the caller gave a pointer to.
    ParameterPointer {
        /// The parameter.
        index: u16,
        /// How far after its target.
        offset: u32,
    },
    /// The number of a timer, counter or block that the caller gave.
    Number(u16),
}

impl Start {
    /// So many bits further on.
    #[must_use]
    pub fn moved(mut self, by: u32) -> Self {
        match &mut self {
            Self::Temp(at) | Self::Instance(at) => *at = at.saturating_add(by),
            Self::InstancePointer { offset, .. } | Self::Parameter { offset, .. } | Self::ParameterPointer { offset, .. } => {
                *offset = offset.saturating_add(by);
            }
            Self::Number(_) => {}
        }
        self
    }
}

impl Local {
    /// How it is accessed, if it is a single value of at most 64 bits.
    pub fn width(&self) -> Option<Width> {
        if self.data_type.stands_in_bytes() { None } else { Width::of_bits(self.data_type.bits()) }
    }

    /// Whether each instance has its own.
    pub fn is_in_instance(&self) -> bool {
        matches!(self.start, Start::Instance(_))
    }
}

impl Item {
    /// What lies at an address, as bits; the value of a timer or counter.
    pub fn operand(operand: Operand) -> Self {
        let kind = match operand.width() {
            _ if matches!(operand, Operand::Timer(_) | Operand::Counter(_)) => Kind::Number,
            Some(Width::Bit) => Kind::Bit,
            width => Kind::Bits(width.map_or(16, Width::bits)),
        };
        Self { place: Place::Operand(operand), kind }
    }

    /// What lies at an address, with a type if that says more than the width.
    pub fn typed(operand: Operand, data_type: Option<&DataType>) -> Self {
        let plain = Self::operand(operand);
        match (data_type.map(Kind::of_type), &plain.kind) {
            (Some(kind @ Kind::Typed(_)), Kind::Bits(_)) => Self { kind, ..plain },
            _ => plain,
        }
    }

    /// Bytes of an area.
    pub fn area(area: Area, byte: u32, length: u32) -> Self {
        Self { place: Place::Bytes(Bytes { db: None, area, byte, length }), kind: Kind::Bytes(length) }
    }

    /// Bytes of a data block.
    pub fn data(db: u16, byte: u32, length: u32) -> Self {
        Self { place: Place::Bytes(Bytes { db: Some(db), area: Area::SharedData, byte, length }), kind: Kind::Bytes(length) }
    }

    /// A field of a data block: `position` is its first bit.
    pub fn field(db: u16, position: u32, data_type: &DataType) -> Self {
        let byte = position / 8;
        match Width::of_bits(data_type.bits()).filter(|width| width.bits() <= 32 && !data_type.stands_in_bytes()) {
            Some(width) => {
                let address = crate::address::Address { area: Area::SharedData, width, byte, bit: (position % 8) as u8 };
                Self::typed(Operand::InDataBlock { db, address }, Some(data_type))
            }
            None => {
                let length = u32::try_from(data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
                Self { kind: Kind::of_type(data_type), ..Self::data(db, byte, length) }
            }
        }
    }

    /// A register, or a status bit.
    pub fn register(register: Register) -> Self {
        let kind = match register {
            _ if STATUS_BITS.contains(&register) => Kind::Bit,
            Register::DbNumber | Register::DbLength | Register::DiNumber | Register::DiLength => Kind::Number,
            _ => Kind::Bits(32),
        };
        Self { place: Place::Register(register), kind }
    }

    /// A constant of the source.
    pub fn constant(data_type: &DataType, content: Content) -> Self {
        Self { place: Place::Constant(content), kind: Kind::of_type(data_type) }
    }

    /// The status word.
    pub fn status() -> Self {
        Self { place: Place::Status, kind: Kind::Status }
    }

    /// The status bit of a timer.
    pub fn timer_status(number: u16) -> Self {
        Self { place: Place::TimerStatus(number), kind: Kind::Bit }
    }

    /// A variable of a block.
    pub fn local(local: Local) -> Self {
        Self { kind: Kind::of_type(&local.data_type), place: Place::Local(local) }
    }

    /// The address, timer or counter that it is, if it is a single one.
    pub fn as_operand(&self) -> Option<&Operand> {
        match &self.place {
            Place::Operand(operand) => Some(operand),
            _ => None,
        }
    }

    /// The item in a format. Of a register a format of 16 bits shows the low word.
    ///
    /// # Errors
    /// The format does not show such values; the error says which do.
    pub fn in_format(self, format: Format) -> Result<Self, FormatError> {
        let fits = self.fits();
        match fits.first() {
            Some(&is) if !format.fits(&fits) => Err(FormatError::Unfit { format, is, fitting: Format::fitting(&fits).collect() }),
            _ => Ok(Self { kind: Kind::Formatted(format, Box::new(self.kind.plain().clone())), ..self }),
        }
    }

    /// What it is to the table of formats.
    fn fits(&self) -> Vec<Fit> {
        match &self.place {
            Place::Operand(Operand::Timer(_)) => vec![Fit::Timer, Fit::Number],
            Place::Operand(Operand::Counter(_)) => vec![Fit::Counter, Fit::Number],
            Place::Register(_) if *self.kind.plain() == Kind::Bits(32) => vec![Fit::Width(32), Fit::Width(16)],
            _ => self.kind.fits(),
        }
    }

    /// The item as people read it: the remaining value of a timer as a time.
    #[must_use]
    pub fn readable(self) -> Self {
        match (&self.place, &self.kind) {
            (Place::Operand(Operand::Timer(_)), Kind::Number) => Self { kind: Kind::TimeLeft, ..self },
            _ => self,
        }
    }

    /// Whether its value is the time that a timer has left, and not the count of its base.
    pub fn is_time_of_timer(&self) -> bool {
        matches!(self.place, Place::Operand(Operand::Timer(_)))
            && matches!(*self.kind.meaning(), Kind::TimeLeft | Kind::Typed(DataType::S5Time))
    }

    /// The number of bits of its place that a value can have; 0 for bytes.
    pub fn width(&self) -> u32 {
        match &self.place {
            Place::Operand(operand) => operand.width().map_or(16, Width::bits),
            Place::Register(_) if *self.kind.plain() == Kind::Number => 32,
            _ => self.kind.width(),
        }
    }
}
