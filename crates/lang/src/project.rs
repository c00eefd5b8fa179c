//! Compiles the sources of a project into a program.

use std::collections::BTreeMap;

use sieben_engine::Program;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Interface;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

/// A system function or system function block of the CPU, as data.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemBlock {
    /// `SFC 46`.
    pub block: BlockId,
    /// `STP`.
    pub name: &'static str,
    /// Its parameters.
    pub interface: Interface,
}

/// How to compile.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The CPU type; `None` = the default.
    pub cpu: Option<&'static CpuType>,
    /// The mnemonic language; `None` = judged over each whole file.
    pub mnemonics: Option<Mnemonics>,
    /// Report only what one file alone can tell.
    pub syntax_only: bool,
    /// The system blocks of the CPU.
    pub system_blocks: Vec<SystemBlock>,
}

/// What came of it. With an error among the diagnostics the program holds what could be compiled and must not be run.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// The program.
    pub program: Program,
    /// All diagnostics, in the order of files and places.
    pub diagnostics: Vec<Diagnostic>,
    /// The mnemonic language of each file.
    pub mnemonics: BTreeMap<FileId, Mnemonics>,
    /// Symbols of blocks and their comments, for display: `FC 1` → `Dosing`.
    pub block_names: BTreeMap<BlockId, String>,
}

/// Compiles all sources of a project, in any order of blocks.
pub fn compile(sources: &Sources, symbols: &SymbolTable, options: &Options) -> Compiled {
    let _ = (sources, symbols, options);
    Compiled::default()
}
