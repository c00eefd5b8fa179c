//! Runs the IR at once: the engine that defines what code means.

mod access;
mod prepare;
mod run;

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::block::BlockId;

use crate::host::{Context, Engine, Entry, Exit};
use crate::machine::Layout;
use crate::program::Program;

/// A loaded program, ready to be interpreted; shared by any number of CPUs of the same layout.
#[derive(Debug)]
pub struct Interpreter {
    blocks: Vec<prepare::Block>,
    index: HashMap<BlockId, u32>,
}

impl Interpreter {
    /// Prepares all blocks of a program for a layout.
    pub fn load(program: &Program, layout: &Layout) -> Arc<dyn Engine> {
        let index: HashMap<BlockId, u32> = program.code.keys().enumerate().map(|(index, &id)| (id, index as u32)).collect();
        let find = |id: BlockId| index.get(&id).copied();
        let blocks = program.code.iter().map(|(&id, block)| prepare::prepare(id, block, layout, &find)).collect();
        Arc::new(Self { blocks, index })
    }
}

impl Engine for Interpreter {
    fn run(&self, context: &mut Context<'_>, entry: &Entry) -> Exit {
        self.start(context, entry)
    }
    fn resume(&self, context: &mut Context<'_>) -> Exit {
        self.resume(context)
    }
    fn has_block(&self, block: BlockId) -> bool {
        self.index.contains_key(&block)
    }
}
