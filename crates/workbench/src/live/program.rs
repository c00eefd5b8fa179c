//! The program that runs, as pages need it: blocks by their words, and the lines of their statements.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use sieben_engine::FaultPlace;
use sieben_model::block::BlockId;
use sieben_workspace::control::Facts;

/// A program with what was looked up in it.
pub struct Known {
    /// Which program of the run it is.
    pub version: u64,
    /// What is known of it.
    pub facts: Arc<Facts>,
    lines: Mutex<BTreeMap<BlockId, Arc<[u32]>>>,
}

impl Known {
    /// The program with this version.
    pub fn new(version: u64, facts: Arc<Facts>) -> Self {
        Self { version, facts, lines: Mutex::default() }
    }

    /// A word for this program, another one for each that takes over.
    pub fn hash(&self) -> String {
        format!("{:x}", self.version)
    }

    /// The line of each statement of a block; 0 for one that the compiler made.
    pub fn lines(&self, block: BlockId) -> Arc<[u32]> {
        let mut known = self.lines.lock().unwrap_or_else(PoisonError::into_inner);
        let lines = known.entry(block).or_insert_with(|| {
            let count = self.facts.program.code.get(&block).map_or(0, |code| code.spans.len());
            let mut places = self.facts.places();
            let mut line = |statement| places.of(FaultPlace { block, statement }).line.map_or(0, |(_, line)| line);
            (0..u32::try_from(count).unwrap_or(u32::MAX)).map(&mut line).collect()
        });
        Arc::clone(lines)
    }
}
