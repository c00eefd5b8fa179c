//! Scalar promotion of the lengths of strings that a loop appends to: a register holds them from iteration to iteration, besides memory,
//! which has them as well. An iteration that loads the length which the one before stored would wait for memory each time.
//!
//! Every path to the loop header says what the length is there: an available value, or what memory has.

use cranelift_frontend::Variable;
use sieben_engine::ir::{Inst, TextAction, TextRoom};
use sieben_model::address::Width;

use super::Translator;
use super::load_elimination::Characters;
use super::memory::{Address, Bit};
use super::natural_loops::NaturalLoop;
use super::scalar_promotion::Base;
use super::strings::InBoundsString;
use crate::passes::Pass;

/// Lengths that a loop keeps at most.
const KEPT_MAX: usize = 2;

/// The length of a text that a loop keeps in a register.
#[derive(Clone, Copy, Debug)]
pub(super) struct PromotedLength {
    /// In how many blocks around it the block of the loop lies; its first and last statement.
    level: usize,
    first: u32,
    last: u32,
    /// Where the text begins, and its room.
    base: Base,
    offset: i32,
    room: TextRoom,
    variable: Variable,
}

impl Translator<'_> {
    /// Keeps the lengths of texts that a loop grows, before it.
    pub(super) fn keep_lengths_in(&mut self, it: &NaturalLoop) {
        let level = self.outer.len();
        let is_innermost = !self.loops.iter().any(|other| other.first != it.first && it.contains(other.first));
        let code = &self.native().code;
        let calls = |statement: u32| code.statement(statement as usize).iter().any(|inst| matches!(inst, Inst::Call { .. }));
        let is_calm = it.asks_for_texts && is_innermost && !(it.first..=it.last).any(calls);
        if !self.options.does(Pass::StringLengths) || !is_calm || self.iteration_of(it.first).is_some() {
            return;
        }
        for (base, offset, room) in self.grown_texts(it) {
            let variable = self.b.declare_var(cranelift_codegen::ir::types::I32);
            let kept = PromotedLength { level, first: it.first, last: it.last, base, offset, room, variable };
            self.kept_lengths.push(kept);
            self.tell_length(kept);
        }
    }

    /// Texts that begin at a known place, and behind which a loop puts something.
    fn grown_texts(&self, it: &NaturalLoop) -> Vec<(Base, i32, TextRoom)> {
        let code = &self.native().code;
        let mut found = Vec::new();
        for statement in it.first..=it.last {
            for (index, inst) in (code.statements[statement as usize]..).zip(code.statement(statement as usize)) {
                let Inst::Text { action: TextAction::Append, to, to_room, .. } = *inst else { continue };
                if to_room.is_unknown() || to_room.wide {
                    continue;
                }
                let place = match self.ranges.text(index, true) {
                    Some(known) if known.bytes.1.end - known.bytes.1.start == i64::from(to_room.bytes()) => {
                        Some((known.bytes.0, known.bytes.1.start))
                    }
                    Some(_) => None,
                    None => self.constant_address(to, Width::Byte).map(|(base, offset)| (base, i64::from(offset))),
                };
                let Some((base @ (Base::Arena | Base::Local), offset)) = place else { continue };
                let Ok(offset) = i32::try_from(offset) else { continue };
                if !found.contains(&(base, offset, to_room)) && found.len() < KEPT_MAX {
                    found.push((base, offset, to_room));
                }
            }
        }
        found
    }

    /// What begins at the head of a loop knows the lengths that it keeps.
    pub(super) fn know_kept_lengths(&mut self, first: u32) {
        for kept in self.kept_lengths_of(|it| it.first == first) {
            let length = self.b.use_var(kept.variable);
            let text = self.text_of(kept);
            self.remember_characters(&text, Characters::some(length));
        }
    }

    /// On a way to the head of a loop: what the lengths are that it keeps.
    pub(super) fn tell_kept_lengths(&mut self, first: u32) {
        self.kept_lengths_of(|it| it.first == first).into_iter().for_each(|kept| self.tell_length(kept));
    }

    /// Takes them from memory again, where somebody may have changed it.
    pub(super) fn take_kept_lengths(&mut self) {
        let statement = self.statement;
        for kept in self.kept_lengths_of(|it| (it.first..=it.last).contains(&statement)) {
            let text = self.text_of(kept);
            let length = self.length_in_memory(&text);
            self.b.def_var(kept.variable, length);
        }
    }

    fn kept_lengths_of(&self, is_it: impl Fn(&PromotedLength) -> bool) -> Vec<PromotedLength> {
        let level = self.outer.len();
        self.kept_lengths.iter().copied().filter(|kept| kept.level == level && is_it(kept)).collect()
    }

    fn tell_length(&mut self, kept: PromotedLength) {
        let text = self.text_of(kept);
        // What is known here is not noted: the head of the loop has other ways to it.
        let length = match self.known_characters(&text) {
            Some(Characters { length, .. }) => length,
            None => self.length_in_memory(&text),
        };
        self.b.def_var(kept.variable, length);
    }

    fn text_of(&mut self, PromotedLength { base, offset, room, .. }: PromotedLength) -> InBoundsString {
        let address = Address { base: self.address_of_base(base), offset, bit: Bit::Number(0) };
        InBoundsString { address, touched: None, there: room.bytes(), room, most: None, empty: false }
    }
}
