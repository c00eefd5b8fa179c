//! Runs the IR at once: the engine that defines what code means.

mod local_data;
mod prepare;
mod run;
mod stores;

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::block::BlockId;

use crate::host::{Context, Engine, Entry, Exit};
use crate::machine::{Frame, Layout};
use crate::program::Program;

pub use prepare::weight;

/// A loaded program, ready to be interpreted; shared by any number of CPUs of the same layout.
#[derive(Debug)]
pub struct Interpreter {
    blocks: Vec<prepare::Block>,
    index: HashMap<BlockId, u32>,
}

impl Interpreter {
    /// Prepares all blocks of a program for a layout.
    pub fn load(program: &Program, layout: &Layout) -> Arc<dyn Engine> {
        Arc::new(Self::new(program, layout))
    }

    /// The same, for an engine that has an interpreter beside it.
    pub fn new(program: &Program, layout: &Layout) -> Self {
        let index: HashMap<BlockId, u32> = program.code.keys().enumerate().map(|(index, &id)| (id, index as u32)).collect();
        let find = |id: BlockId| index.get(&id).copied();
        let blocks = program.code.iter().map(|(&id, block)| prepare::prepare(id, block, layout, &find)).collect();
        Self { blocks, index }
    }

    /// The index of a block in the frames of this program: blocks are counted in the order of their numbers.
    pub fn code(&self, block: BlockId) -> Option<u32> {
        self.index.get(&block).copied()
    }

    /// The `resume` of a frame that goes on at this statement.
    pub fn resume_at(&self, code: u32, statement: u32) -> u32 {
        let block = &self.blocks[code as usize];
        match block.statements.get(statement as usize).copied() {
            Some(0) => Frame::ENTERED,
            Some(step) => step,
            None => block.steps.len() as u32 - 1,
        }
    }

    /// The statement at which a frame with this `resume` goes on.
    pub fn statement_at(&self, code: u32, resume: u32) -> u32 {
        self.blocks[code as usize].statement_of(if resume == Frame::ENTERED { 0 } else { resume as usize })
    }

    /// The `resume` of a frame that goes on behind this instruction of the IR: a call, or a load that delivered 0.
    ///
    /// # Panics
    /// If it is neither.
    pub fn resume_behind(&self, code: u32, instruction: u32) -> u32 {
        let block = &self.blocks[code as usize];
        let found = block.behind.binary_search_by_key(&instruction, |&(at, _)| at).expect("a call or a load that may deliver 0");
        block.behind[found].1
    }
}

impl Engine for Interpreter {
    fn run(&self, context: &mut Context<'_>, entry: &Entry) -> Exit {
        self.start(context, entry)
    }
    fn resume(&self, context: &mut Context<'_>) -> Exit {
        self.resume(context)
    }
    fn go_on(&self, context: &mut Context<'_>) -> Exit {
        self.go_on(context)
    }
    fn has_block(&self, block: BlockId) -> bool {
        self.index.contains_key(&block)
    }
}
