//! Why a statement did what it did, in one sentence: from its statement event, in English or German.
//!
//! Which kind of reason an instruction has is a column of the instruction table; the sentences are a table of their own. What is
//! said is read from the registers before and after the statement and from the machine; only the exact result of an integer calculation,
//! which a register may be too short for, is calculated once more.

pub mod examples;

use std::collections::BTreeMap;

use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Sources};
use sieben_model::symbols::SymbolTable;

use crate::compiled::Compiled;
use crate::sentences::Surroundings;
use crate::sentences::table::Sentence;
use crate::sentences::text::one_line;
pub use crate::sentences::{Language, Moment, Named};

/// Says why statements of a program did what they did.
#[derive(Clone, Copy, Debug)]
pub struct Reasons<'a> {
    compiled: &'a Compiled,
    around: Surroundings<'a>,
}

impl<'a> Reasons<'a> {
    /// For a program, its sources (see [`Compiled::add_library_sources`]) and the symbols it was compiled with.
    pub fn new(compiled: &'a Compiled, sources: &'a Sources, symbols: &'a SymbolTable) -> Self {
        let Compiled { program, block_names, mnemonics, .. } = compiled;
        Self { compiled, around: Surroundings { program, block_names, mnemonics, sources, symbols } }
    }

    /// The same with addresses spelled in these mnemonics instead of those of each file.
    #[must_use]
    pub fn spelled(self, mnemonics: &'a BTreeMap<FileId, Mnemonics>) -> Self {
        Self { around: Surroundings { mnemonics, ..self.around }, ..self }
    }

    /// The reason without the statement before it, beginning in lower case and without a full stop; empty if the program has no such
    /// statement.
    pub fn sentence(&self, moment: &Moment<'_>, language: Language) -> String {
        let body = self.compiled.bodies.get(&moment.event.place.block);
        body.map_or_else(String::new, |body| body.why(self.around, moment, language))
    }

    /// The variables that a statement names, with what they hold after it; none in STL, whose statements work on registers.
    pub fn named(&self, moment: &Moment<'_>, language: Language) -> Vec<Named> {
        let body = self.compiled.bodies.get(&moment.event.place.block);
        body.map_or_else(Vec::new, |body| body.named(self.around, moment, language))
    }

    /// Which sentences the reason of a statement is made of, as [`Why::forms`](crate::stl::why::Why::forms) lists them; a fault has one of its own. Only STL tells.
    pub fn forms(&self, moment: &Moment<'_>) -> Vec<Sentence> {
        let body = self.compiled.bodies.get(&moment.event.place.block);
        body.map_or_else(Vec::new, |body| body.forms(self.around, moment))
    }

    /// The text of a statement as it is written, in one line: `A I 0.1`; empty if the sources do not have it.
    pub fn statement(&self, place: sieben_engine::FaultPlace) -> String {
        let spans = self.compiled.program.code.get(&place.block).map_or(&[][..], |block| &block.spans);
        spans.get(place.statement as usize).map_or_else(String::new, |&span| one_line(self.around.slice(span)))
    }
}
