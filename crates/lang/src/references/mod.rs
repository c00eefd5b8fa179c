//! What the statements of a block refer to, as plain data that is the same for every language.

pub mod target;
pub(crate) mod variables;

use std::collections::BTreeMap;
use std::fmt;

use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Interface;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::program::DataBlock;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use crate::access::Direction;
use target::{Extent, Target};

/// What a statement does with its target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Usage {
    /// It reads or writes it.
    Access(Direction),
    /// It calls the block.
    Call(CallKind),
    /// It opens the data block.
    Open,
    /// The data block or variable is the instance of a call.
    Instance,
    /// It takes the address or number; what happens through it does not show here.
    Address,
}

impl Usage {
    /// The word in the type column: `R`, `W`, `RW` as in STEP 7.
    pub fn word(self) -> &'static str {
        match self {
            Self::Access(Direction::Read) => "R",
            Self::Access(Direction::Write) => "W",
            Self::Access(Direction::ReadWrite) => "RW",
            Self::Call(_) => "call",
            Self::Open => "open",
            Self::Instance => "inst",
            Self::Address => "P#",
        }
    }
}

/// One place where a target is used.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// What is used.
    pub target: Target,
    /// In which block.
    pub block: BlockId,
    /// Its network, from 1; 0 in a block of ST, which has none.
    pub network: u32,
    /// The statement of the block, from 1.
    pub statement: usize,
    /// The place: the statement, or the argument of a call.
    pub span: Span,
    /// The instruction; `None` in ST.
    pub instruction: Option<InstructionWord>,
    /// How it is used.
    pub usage: Usage,
    /// The parameter of the called block that it is given to.
    pub parameter: Option<String>,
}

/// The word of an instruction in both mnemonic languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InstructionWord {
    /// International.
    pub english: &'static str,
    /// SIMATIC.
    pub german: &'static str,
}

impl InstructionWord {
    /// The word in a mnemonic language.
    pub fn mnemonic(self, mnemonics: Mnemonics) -> &'static str {
        match mnemonics {
            Mnemonics::English => self.english,
            Mnemonics::German => self.german,
        }
    }
}

/// How a block is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CallKind {
    /// `CALL`, or a call in ST.
    Call,
    /// `UC`.
    Unconditional,
    /// `CC`.
    Conditional,
}

impl CallKind {
    /// The instruction word, the same in both mnemonic languages.
    pub fn word(self) -> &'static str {
        match self {
            Self::Call => "CALL",
            Self::Unconditional => "UC",
            Self::Conditional => "CC",
        }
    }
}

/// What the references of a block are named by that lies outside of it.
#[derive(Clone, Copy)]
pub struct Around<'a> {
    /// The interface of another block of the program.
    pub interface: &'a dyn Fn(BlockId) -> Option<&'a Interface>,
    /// The data blocks of the program.
    pub data: &'a BTreeMap<u16, DataBlock>,
}

impl fmt::Debug for Around<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Around").field("data", &self.data).finish_non_exhaustive()
    }
}

/// The width of what is accessed through a pointer.
pub(crate) fn width(extent: Extent) -> Width {
    match extent {
        Extent::Width(width) => width,
        Extent::Bits(_) | Extent::Unknown => Width::Byte,
    }
}

/// The kind of block that a parameter of this type takes the number of.
pub(crate) fn block_kind(data_type: &DataType) -> BlockKind {
    match data_type {
        DataType::BlockFunction => BlockKind::Function,
        DataType::BlockFunctionBlock => BlockKind::FunctionBlock,
        _ => BlockKind::DataBlock,
    }
}
