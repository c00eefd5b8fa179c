//! How a project is compiled.

use sieben_model::cpu_type::CpuType;
use sieben_model::interface::SystemBlock;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;

use crate::library::Selection;
use crate::scope::LostResults;
use crate::st::dialect::Dialect;
use crate::stl::check;

/// How to compile.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The CPU type; `None` = the default.
    pub cpu: Option<&'static CpuType>,
    /// The mnemonic language; `None` = judged over each whole file.
    pub mnemonics: Option<Mnemonics>,
    /// Report only what one file alone can tell.
    pub syntax_only: bool,
    /// A source, the first one, whose blocks take the place of those that others have with the same number: a test.
    pub replacing: Option<FileId>,
    /// Whether extension words may be used.
    pub extended: bool,
    /// The system blocks of the CPU.
    pub system_blocks: Vec<SystemBlock>,
    /// Which reads of temporary variables that may not be written are reported.
    pub temporaries: check::TemporaryReads,
    /// What the program may take from the library.
    pub library: Selection,
    /// The dialect of all sources of ST; `None` = judged over each whole file.
    pub dialect: Option<Dialect>,
    /// Whether test files among the sources are compiled; else it is reported that they are no part of a program.
    pub tests: bool,
    /// Whether it is known of each statement and each decision how to count it ([`Compiled::countable`]): for the coverage of tests.
    pub counted: bool,
    /// Which lost results the code of Structured Text tells the Host of, as far as its dialect does not call them right.
    pub tells_lost: LostResults,
}
