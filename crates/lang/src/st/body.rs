//! What others ask about a checked block of ST.

use sieben_engine::CodeBlock;
use sieben_model::address::Area;
use sieben_model::block::BlockId;

use super::reason::{named, sentence};
use super::references::references_of;
use super::tree::TypedBlock;
use crate::coverage::Countable;
use crate::references::{Around, Reference};
use crate::sentences::table::Sentence;
use crate::sentences::{Language, Moment, Named, Surroundings};

impl TypedBlock {
    pub(crate) fn references(&self, id: BlockId, around: Around<'_>) -> Vec<Reference> {
        references_of(id, self, around)
    }

    /// ST has no networks.
    pub(crate) fn networks(&self) -> Vec<u32> {
        Vec::new()
    }

    pub(crate) fn network(&self, _: u32) -> Option<u32> {
        None
    }

    /// Every step has the place of a statement.
    pub(crate) fn is_written(&self, _: u32) -> bool {
        true
    }

    /// The target of an assignment, the variable of FOR, or the whole statement.
    pub(crate) fn value_in<'t>(&self, text: &'t str) -> Option<&'t str> {
        let Some((target, _)) = text.split_once(":=") else { return Some(text) };
        let target = target.trim();
        let of_for = target.split_once(char::is_whitespace).filter(|(word, _)| word.eq_ignore_ascii_case("FOR"));
        Some(of_for.map_or(target, |(_, name)| name))
    }

    pub(crate) fn has_bare_names(&self) -> bool {
        true
    }

    pub(crate) fn is_called_by_name(&self) -> bool {
        true
    }

    /// ST has no RLO.
    pub(crate) fn stores_if_rlo(&self) -> Vec<u32> {
        Vec::new()
    }

    /// ST names variables; those that have an address have it from their declaration.
    pub(crate) fn named_bits(&self) -> Vec<(Area, u32)> {
        Vec::new()
    }

    /// The assertions of ST are words of test files.
    pub(crate) fn has_assertion(&self) -> bool {
        false
    }

    /// Each outcome of a decision is a statement of the IR that only the lowering knows.
    pub(crate) fn countable(&self, _: &CodeBlock) -> Option<Countable> {
        None
    }

    pub(crate) fn why(&self, around: Surroundings<'_>, moment: &Moment<'_>, language: Language) -> String {
        sentence(around, self, moment, language)
    }

    pub(crate) fn named(&self, around: Surroundings<'_>, moment: &Moment<'_>, language: Language) -> Vec<Named> {
        named(around, self, moment, language)
    }

    /// RLO, accumulators and what else an instruction works on never show in ST.
    pub(crate) fn works_on_registers(&self) -> bool {
        false
    }

    /// A sentence of ST is chosen by the steps around the statement too.
    pub(crate) fn forms(&self, _: Surroundings<'_>, _: &Moment<'_>) -> Vec<Sentence> {
        Vec::new()
    }
}
