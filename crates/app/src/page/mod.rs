//! What the page asks of a program as a whole: blocks, diagrams, reference data.

pub(crate) mod assignments;
mod blocks;
mod flow;
mod references;
pub(crate) mod structure;

use std::sync::Arc;

use serde_json::Value;
use sieben_engine::machine::Registers;
use sieben_ide::assignment_list::AssignmentList;
use sieben_ide::call_structure::CallStructure;
use sieben_ide::cross_reference::CrossReference;
use sieben_lang::reason::Language;
use sieben_lang::stl::instructions::Instruction;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_workbench::{Reference, View};
use sieben_workspace::Refusal;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

/// The places of a program, with addresses as all that a page is sent has them: the page itself writes them in the mnemonics that its user wants.
fn places(build: &Build) -> Places<'_> {
    let mut places = Places::new(build);
    places.mnemonics = Mnemonics::English;
    places
}

/// Answers from what the command line prints too.
#[derive(Default)]
pub(crate) struct Answers {
    diagrams: flow::Known,
}

impl Reference for Answers {
    fn blocks(&self, build: &Build) -> Value {
        blocks::list(build)
    }

    fn block(&self, build: &Build, block: BlockId, shown: (View, Option<Mnemonics>)) -> Result<Value, Refusal> {
        blocks::block(build, block, shown)
    }

    fn symbols(&self, build: &Build) -> Value {
        references::symbols(build)
    }

    fn refs(&self, build: &Build, name: Option<&str>) -> Result<Value, Refusal> {
        references::of(build, name)
    }

    fn assignments(&self, build: &Build) -> Value {
        assignments::json(&places(build), &AssignmentList::new(&CrossReference::new(&build.compiled)))
    }

    fn structure(&self, build: &Build) -> Value {
        structure::json(build, &places(build), &CallStructure::new(&build.compiled))
    }

    fn flow(&self, build: &Arc<Build>, of: (BlockId, u32, View), after: &mut dyn Iterator<Item = (u32, Registers)>) -> Value {
        self.diagrams.flow(build, of, after)
    }

    fn explain(&self, word: &str, _: Language) -> Option<String> {
        let word: String = word.split_whitespace().collect::<String>().to_ascii_uppercase();
        let row = Instruction::ALL.iter().find(|row| row.english() == word || row.german() == word)?;
        Some(row.doc().to_owned())
    }
}
