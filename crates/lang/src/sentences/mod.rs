//! Sentences about what a program did, in English and German: the table of them, what is filled in, and what a statement could see.

pub(crate) mod memory;
pub mod table;
pub(crate) mod text;

use std::collections::BTreeMap;

use sieben_engine::{Machine, Program, StatementEvent};
use sieben_model::block::BlockId;
pub use sieben_model::language::Language;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources, Span};
use sieben_model::symbols::SymbolTable;

/// A variable that a statement names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// As it is written: `list[i]`.
    pub name: String,
    /// The plain number or truth value that it holds after the statement; `None` for what is no single value.
    pub value: Option<String>,
    /// The block that the statement calls with it as its instance.
    pub instance_of: Option<BlockId>,
}

/// One executed statement, with the machine around it.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// Which statement, and the registers before and after it.
    pub event: &'a StatementEvent,
    /// The machine before it, if it was kept. Without it a sentence about a timer or a counter says how it stands, not whether it was
    /// started, and an address that the statement itself may have changed is not named.
    pub before: Option<&'a Machine>,
    /// The machine as the tracer gets it: behind the statement.
    pub after: &'a Machine,
    /// The event of the fault (16#25xx, 16#294x, 16#357x) that this statement caused, if the CPU went to STOP for it. A fault that
    /// called OB 121 or OB 122 shows in the machine.
    pub fault: Option<u16>,
}

/// What a sentence takes its names from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surroundings<'a> {
    pub(crate) program: &'a Program,
    /// Names of blocks, for display.
    pub(crate) block_names: &'a BTreeMap<BlockId, String>,
    /// The mnemonic language of each file.
    pub(crate) mnemonics: &'a BTreeMap<FileId, Mnemonics>,
    pub(crate) sources: &'a Sources,
    pub(crate) symbols: &'a SymbolTable,
}

impl<'a> Surroundings<'a> {
    /// The text of a span, empty if the sources do not have it.
    pub(crate) fn slice(&self, span: Span) -> &'a str {
        if (span.file.0 as usize) < self.sources.iter().len() { self.sources.slice(span) } else { "" }
    }
}
