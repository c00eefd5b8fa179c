//! Runs the IR at once.

use std::sync::Arc;

use sieben_model::block::BlockId;

use crate::host::{Context, Engine, Entry, Exit};
use crate::machine::Layout;
use crate::program::Program;

/// A loaded program, ready to be interpreted; shared by any number of CPUs of the same layout.
#[derive(Debug)]
pub struct Interpreter {
    program: Arc<Program>,
}

impl Interpreter {
    /// Prepares all blocks of a program.
    pub fn load(program: Arc<Program>, layout: &Layout) -> Self {
        let _ = layout;
        Self { program }
    }
}

impl Engine for Interpreter {
    fn run(&self, _context: &mut Context<'_>, _entry: &Entry) -> Exit {
        Exit::Finished
    }
    fn resume(&self, _context: &mut Context<'_>) -> Exit {
        Exit::Finished
    }
    fn has_block(&self, block: BlockId) -> bool {
        self.program.code.contains_key(&block)
    }
}
