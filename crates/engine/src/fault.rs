//! What can go wrong while a program runs, with the codes of the real CPU.

use sieben_model::address::Width;
use sieben_model::block::BlockId;

/// The statement that caused something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// The block.
    pub block: BlockId,
    /// The statement, counted from 0 in the block.
    pub statement: u32,
}

/// Added to the code of a programming error that is only told: the Host writes it down, calls no organization block and stops nothing,
/// and the statement goes on with its next instruction, whatever the Host answers.
pub const NOTED: u8 = 0x80;

/// What a statement of Structured Text lost without an error of the CPU: its code, always with [`NOTED`]. No CPU has these numbers.
pub mod lost {
    /// A division by 0 (FLT_REG is 0), or a quotient beyond its type.
    pub const QUOTIENT: u8 = 0x01;
    /// The result of an integer operation does not fit its type.
    pub const OVERFLOW: u8 = 0x02;
    /// The result of a computation with REAL or LREAL is infinite or no number.
    pub const NO_NUMBER: u8 = 0x03;
    /// A value does not fit the type that it becomes, or the function has no result for it.
    pub const CONVERSION: u8 = 0x04;
    /// A FOR with a step of 0 is left out.
    pub const STEP: u8 = 0x05;
    /// A character does not exist in the STRING that the text becomes.
    pub const CHARACTER: u8 = 0x06;
    /// The greatest of them.
    pub const LAST: u8 = CHARACTER;
}

/// A synchronous error of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Programming error, OB 121.
    Programming {
        /// OB121_SW_FLT: 16#21 BCD, 22/23 area length, 24/25 area code, 26/27 timer/counter number, 28/29 alignment,
        /// 30/31 write protection, 32..35 block number, 3A/3C/3E/3D/3F block not loaded.
        code: u8,
        /// OB121_FLT_REG: byte address, illegal area code, number, or 0 for ACCU 1.
        register: u16,
        /// OB121_RESERVED_1: access (bits 7 to 4) and area (bits 3 to 0) of an area length or alignment error.
        access: u8,
    },
    /// I/O access error, OB 122.
    IoAccess {
        /// Write (16#43) or read (16#42).
        write: bool,
        /// Width of the access.
        width: Width,
        /// Byte address.
        byte: u32,
    },
    /// The block cannot go on: OB 88 or STOP.
    Abort(Abort),
}

/// Errors that end the processing of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Abort {
    /// More than seven open brackets, or a closing one too many.
    NestingStack,
    /// More than eight MCR zones, or a closing one too many.
    McrStack,
    /// Too many nested calls.
    BlockStack,
    /// The local data of the priority class do not suffice.
    LocalData,
}

impl Fault {
    /// The event ID of the error itself: 16#25xx, 16#2942/2943, 16#357x.
    pub fn event(&self) -> u16 {
        match self {
            Self::Programming { code, .. } => 0x2500 | u16::from(*code & !NOTED),
            Self::IoAccess { write: false, .. } => 0x2942,
            Self::IoAccess { write: true, .. } => 0x2943,
            Self::Abort(Abort::NestingStack) => 0x3571,
            Self::Abort(Abort::McrStack) => 0x3572,
            Self::Abort(Abort::BlockStack) => 0x3575,
            Self::Abort(Abort::LocalData) => 0x3576,
        }
    }
    /// Whether it is only told ([`NOTED`]).
    pub fn is_noted(&self) -> bool {
        matches!(self, Self::Programming { code, .. } if code & NOTED != 0)
    }
    /// What a statement of Structured Text lost, if that is all: a code of [`lost`].
    pub fn lost(&self) -> Option<u8> {
        match self {
            Self::Programming { code, .. } if code & NOTED != 0 => Some(code & !NOTED).filter(|&code| code <= lost::LAST),
            _ => None,
        }
    }
    /// A programming error with FLT_REG.
    pub(crate) fn programming(code: u8, register: u16) -> Self {
        Self::Programming { code, register, access: 0 }
    }
}
