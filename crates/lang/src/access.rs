//! What a statement works on once its names are resolved: where it lies, and what is done with it.

use sieben_model::address::{Area, Width};
use sieben_model::interface::Section;

/// A memory access.
#[derive(Clone, Debug, PartialEq)]
pub struct Access {
    /// How much.
    pub width: Width,
    /// Where.
    pub location: Location,
}

/// Where an access goes; positions in bits (byte × 8 + bit).
#[derive(Clone, Debug, PartialEq)]
pub enum Location {
    /// `I 0.0`, `MW 10`, `DBX 2.5`, `PIW 256`, `#temp` (then in L).
    Fixed {
        /// Which area.
        area: Area,
        /// The position.
        position: u32,
    },
    /// `DB10.DBW 2`, `"DB".field`: opens the block in the DB register, then accesses it.
    InDataBlock {
        /// Its number.
        db: u16,
        /// The position.
        position: u32,
    },
    /// `DI10.DIW 2`: the same with the DI register.
    InInstanceBlock {
        /// Its number.
        db: u16,
        /// The position.
        position: u32,
    },
    /// `MW [MD 4]`: the pointer lies in a double word of M, L, DB or DI.
    MemoryIndirect {
        /// The area that is accessed.
        area: Area,
        /// Where the pointer lies.
        pointer: Box<Location>,
    },
    /// `MW [AR1,P#2.0]`, or with the area in the register: `W [AR1,P#2.0]` (then `area` is `None`).
    RegisterIndirect {
        /// The area, if it is written.
        area: Option<Area>,
        /// AR1 or AR2.
        register: AddressRegister,
        /// The offset of the statement, in bits.
        offset: u32,
    },
    /// A parameter of a function, elementary or the start of a complex one: through the pointer that the caller gave.
    Parameter {
        /// Its index.
        index: u16,
        /// Inside a complex parameter: the position of the element.
        offset: u32,
        /// Whether the caller gave a pointer to a POINTER in its local data (complex types) instead of to the value.
        complex: bool,
    },
    /// A complex IN_OUT parameter of a function block: through the POINTER at `position` of the instance.
    InstancePointer {
        /// Where the POINTER lies in the instance.
        position: u32,
        /// The position of the element inside the complex value.
        offset: u32,
    },
    /// A parameter or static variable of a function block: `DIX[AR2,P#position]`.
    Instance {
        /// The position in the instance.
        position: u32,
    },
}

/// AR1 or AR2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AddressRegister {
    /// Address register 1.
    Ar1,
    /// Address register 2.
    Ar2,
}

/// The number of a timer, counter or block.
#[derive(Clone, Debug, PartialEq)]
pub enum NumberOperand {
    /// `T 5`.
    Fixed(u16),
    /// `T [MW 10]`: the number lies in a word of M, L, DB or DI; also a TIMER, COUNTER or BLOCK parameter of an FB.
    Indirect(Box<Location>),
    /// A TIMER, COUNTER or BLOCK parameter of a function: the caller passes the number itself.
    Parameter(u16),
}

/// What a statement does with its operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Direction {
    /// Reads it.
    Read,
    /// Writes it. What the old value was makes no difference to anything but itself.
    Write,
    /// Reads it and writes it.
    ReadWrite,
}

impl Direction {
    /// What a caller lets the called block do with an actual parameter of this section.
    pub fn of_parameter(section: Section) -> Self {
        match section {
            Section::Input => Self::Read,
            Section::Output | Section::Return => Self::Write,
            Section::InOut | Section::Static | Section::Temp => Self::ReadWrite,
        }
    }
}
