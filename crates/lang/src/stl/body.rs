//! What others ask about a checked block of STL.

use sieben_engine::CodeBlock;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use super::counting;
use super::extension::Extension;
use super::lower::ResolvedBlock;
use super::operands::{Location, Operand};
use super::reason::Telling;
use super::references::references_of;
use super::why::Why;
use crate::coverage::Countable;
use crate::references::{Around, Reference};
use crate::sentences::table::Sentence;
use crate::sentences::{Language, Moment, Surroundings};

impl ResolvedBlock {
    pub(crate) fn references(&self, _: BlockId, _: Around<'_>) -> Vec<Reference> {
        references_of(self)
    }

    pub(crate) fn networks(&self) -> Vec<u32> {
        self.statements.iter().map(|statement| statement.origin.network()).collect()
    }

    pub(crate) fn network(&self, statement: u32) -> Option<u32> {
        self.statements.get(statement as usize).or(self.statements.last()).map(|statement| statement.origin.network())
    }

    pub(crate) fn is_written(&self, statement: u32) -> bool {
        (statement as usize) < self.statements.len()
    }

    /// What stands after the instruction.
    pub(crate) fn value_in<'t>(&self, text: &'t str) -> Option<&'t str> {
        text.split_once(' ').map(|(_, operand)| operand.trim())
    }

    pub(crate) fn stated(&self, statement: u32) -> Option<&str> {
        self.statements.get(statement as usize)?.stated.as_deref()
    }

    pub(crate) fn has_bare_names(&self) -> bool {
        false
    }

    pub(crate) fn works_on_registers(&self) -> bool {
        true
    }

    pub(crate) fn is_called_by_name(&self) -> bool {
        false
    }

    pub(crate) fn stores_if_rlo(&self) -> Vec<u32> {
        let statements = (0_u32..).zip(&self.statements);
        statements.filter(|(_, one)| matches!(one.instruction.why(), Why::Set | Why::Reset)).map(|(number, _)| number).collect()
    }

    pub(crate) fn named_bits(&self) -> Vec<(Area, u32)> {
        let bits = self.statements.iter().filter_map(|statement| match &statement.operand {
            Operand::Memory(access) => match (access.width, &access.location) {
                (Width::Bit, Location::Fixed { area, position }) => Some((*area, *position)),
                _ => None,
            },
            _ => None,
        });
        bits.collect()
    }

    pub(crate) fn has_assertion(&self) -> bool {
        let is_assertion = |operand: &Operand| match operand {
            Operand::Extension(extension) => matches!(**extension, Extension::Assert { .. }),
            _ => false,
        };
        self.statements.iter().any(|statement| is_assertion(&statement.operand))
    }

    pub(crate) fn countable(&self, code: &CodeBlock) -> Option<Countable> {
        Some(counting::countable(self, code))
    }

    pub(crate) fn why(&self, around: Surroundings<'_>, moment: &Moment<'_>, language: Language) -> String {
        Telling::new(around, self, *moment).sentence(language)
    }

    pub(crate) fn forms(&self, around: Surroundings<'_>, moment: &Moment<'_>) -> Vec<Sentence> {
        Telling::new(around, self, *moment).forms()
    }
}
