//! What is asked of a program as a whole, and of its blocks.

use std::sync::Arc;

use serde_json::Value as Json;
use sieben_engine::machine::Registers;
use sieben_lang::reason::Language;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_workspace::Refusal;
use sieben_workspace::project::Build;

/// How the networks of a block are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum View {
    /// Statements.
    Stl,
    /// Ladder.
    Lad,
    /// Function block diagrams.
    Fbd,
}

impl View {
    /// All of them with their words.
    pub const ALL: [(&'static str, Self); 3] = [("stl", Self::Stl), ("lad", Self::Lad), ("fbd", Self::Fbd)];
}

/// Answers questions about a program. What does it stands above this crate, as it is what the command line prints too.
pub trait Reference: Send + Sync {
    /// The blocks with code, in the order of a tree of calls.
    fn blocks(&self, build: &Build) -> Json;
    /// A block with its networks, in a view, and in mnemonics that need not be those of its source.
    ///
    /// # Errors
    /// It has none.
    fn block(&self, build: &Build, block: BlockId, shown: (View, Option<Mnemonics>)) -> Result<Json, Refusal>;
    /// The symbols with their places of use.
    fn symbols(&self, build: &Build) -> Json;
    /// Where a name is used; of all names without one.
    ///
    /// # Errors
    /// Nothing is called that.
    fn refs(&self, build: &Build, name: Option<&str>) -> Result<Json, Refusal>;
    /// Which addresses are used.
    fn assignments(&self, build: &Build) -> Json;
    /// Which block calls which.
    fn structure(&self, build: &Build) -> Json;
    /// What each line of a network carries, and the values of its elements: `[line or element, flow, value]`. `after` are the registers after each
    /// statement of the block that was executed, by its number.
    fn flow(&self, build: &Arc<Build>, of: (BlockId, u32, View), after: &mut dyn Iterator<Item = (u32, Registers)>) -> Json;
    /// What an instruction does, in a sentence or two; `None` if there is no such instruction.
    fn explain(&self, word: &str, language: Language) -> Option<String>;
}
