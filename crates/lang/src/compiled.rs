//! What comes of the sources of a project.

use std::collections::BTreeMap;

use sieben_engine::Program;
use sieben_model::block::BlockId;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::testing::TestPlan;

use crate::body::Bodies;
use crate::coverage::Countable;
use crate::library::Linked;
use crate::references::{Around, Reference};
use crate::st::standard::LinkedSource;

/// What came of it. With an error among the diagnostics the program holds what could be compiled and must not be run.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// The program.
    pub program: Program,
    /// All diagnostics, in the order of files and places.
    pub diagnostics: Vec<Diagnostic>,
    /// The mnemonic language of each file.
    pub mnemonics: BTreeMap<FileId, Mnemonics>,
    /// The statements of every code block of the program with all names resolved, for reference data, reasons and editors.
    pub bodies: Bodies,
    /// Symbols of blocks and their comments, for display: `FC 1` → `Dosing`.
    pub block_names: BTreeMap<BlockId, String>,
    /// The blocks of the library that belong to the program because something there names them.
    pub library: Vec<Linked>,
    /// Sources of ST of the library that belong to the program because something there needs them.
    pub st_library: Vec<LinkedSource>,
    /// How often the cyclic interrupts are called that run the tasks of a CONFIGURATION: organization block and milliseconds.
    pub intervals: BTreeMap<u16, u16>,
    /// The tests of the test file among the sources.
    pub tests: TestPlan,
    /// What can be counted in the blocks of the user, if the options ask for it.
    pub countable: BTreeMap<BlockId, Countable>,
}

impl Compiled {
    /// Whether an error is among the diagnostics, so that the program must not be run.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error)
    }

    /// Whether a block comes from the library.
    pub fn is_of_library(&self, block: BlockId) -> bool {
        self.library.iter().any(|linked| linked.id == block) || self.st_library.iter().any(|linked| linked.blocks.contains(&block))
    }

    /// What the statements of a block refer to, one after another; nothing if the program has no such block.
    pub fn references(&self, block: BlockId) -> Vec<Reference> {
        let interface = |block: BlockId| self.bodies.get(&block).map(|body| body.interface());
        let around = Around { interface: &interface, data: &self.program.data };
        self.bodies.get(&block).map_or_else(Vec::new, |body| body.references(block, around))
    }

    /// Whether a file is one of the user's.
    pub(crate) fn is_of_user(&self, file: FileId) -> bool {
        !self.library.iter().any(|linked| linked.file == file) && !self.st_library.iter().any(|linked| linked.file == file)
    }

    /// Adds the sources of the linked library blocks to those that were compiled, so that every place of the program can be shown.
    pub fn add_library_sources(&self, sources: &mut Sources) {
        for linked in &self.st_library {
            if sources.iter().len() == linked.file.0 as usize {
                sources.add(linked.source.path, linked.source.text);
            }
        }
        for linked in &self.library {
            if sources.iter().len() == linked.file.0 as usize {
                sources.add(linked.block.path, linked.block.text);
            }
        }
    }
}
