//! STRING: assignment, comparison, length.

use sieben_engine::ir::{Inst, TextAction, Var};
use sieben_model::address::Width;

use super::Lowering;
use super::pointers::at;
use crate::st::tree::{Place, Text};

/// Characters that a STRING may have.
const CHARACTERS_MAX: usize = 254;

impl Lowering<'_> {
    /// A text as a place with room for so many characters; 0 = as its first byte says.
    pub(super) fn text(&mut self, text: &Text) -> (Place, u8) {
        match text {
            Text::Place { place, capacity } => (place.clone(), *capacity),
            Text::Constant(characters) => {
                let characters = &characters[..characters.len().min(CHARACTERS_MAX)];
                let length = characters.len() as u8;
                let place = self.hidden_bytes(2 + u32::from(length));
                let bytes: Vec<u8> = [length, length].into_iter().chain(characters.iter().copied()).collect();
                self.store_bytes(place.offset, &bytes);
                // An empty text has room for no character; 0 would mean the same here.
                (place, length)
            }
            Text::Character(value) => {
                let value = self.value(value);
                let place = self.hidden_bytes(4);
                self.store(&at(&place, 16), Width::Byte, value);
                self.release(value);
                let head = self.constant(0x0101);
                self.store_local(place.offset, Width::Word, head);
                (place, 1)
            }
            Text::Call { call, capacity } => {
                self.call(call);
                (self.text_result(*capacity), *capacity)
            }
        }
    }

    /// Where the last call left its result.
    fn text_result(&mut self, capacity: u8) -> Place {
        match self.result.take() {
            Some(position) => self.local(position),
            None => self.empty_text(capacity),
        }
    }

    /// A place in the local data.
    pub(super) fn local(&self, position: u32) -> Place {
        use crate::st::tree::Base;
        Place { base: Base::Area(sieben_model::address::Area::Local), offset: position, indexes: Vec::new(), span: self.span }
    }

    /// An empty text in hidden local data.
    pub(super) fn empty_text(&mut self, capacity: u8) -> Place {
        let place = self.hidden_bytes(2 + u32::from(capacity));
        let head = self.constant(u64::from(capacity) << 8);
        self.store_local(place.offset, Width::Word, head);
        place
    }

    /// `target := source`, cut to the room there.
    pub(super) fn assign_text(&mut self, target: &Place, capacity: u8, source: &Text) {
        if let Text::Call { call, capacity: most } = source {
            if self.call_into(call, Some((target, capacity))) {
                return;
            }
            let place = self.text_result(*most);
            return self.copy_text(target, capacity, &place, *most);
        }
        let (place, from_max) = self.text(source);
        self.copy_text(target, capacity, &place, from_max);
    }

    fn copy_text(&mut self, target: &Place, capacity: u8, place: &Place, from_max: u8) {
        let [place, target] = self.settle([place, target]);
        let cut = self.text_instruction(TextAction::Assign, (&target, capacity), (&place, from_max), None);
        self.release(cut);
    }

    /// −1, 0 or 1.
    pub(super) fn compare_texts(&mut self, a: &Text, b: &Text) -> Var {
        let mut first = self.text(a);
        if self.text_breaks(b) {
            first.0 = self.freeze(&first.0);
        }
        let second = self.text(b);
        let [a, b] = self.settle([&first.0, &second.0]);
        self.text_instruction(TextAction::Compare, (&a, first.1), (&b, second.1), None)
    }

    /// The number of characters.
    pub(super) fn text_length(&mut self, text: &Text) -> Var {
        let (place, max) = self.text(text);
        self.text_instruction(TextAction::Length, (&place, max), (&place, max), None)
    }

    /// The result of a text instruction. The piece stays.
    pub(super) fn text_instruction(
        &mut self,
        action: TextAction,
        (to, to_max): (&Place, u8),
        (from, from_max): (&Place, u8),
        piece: Option<[Var; 2]>,
    ) -> Var {
        let bytes = |max: u8| 2 + if max == 0 { u32::from(u8::MAX) } else { u32::from(max) };
        let from = self.locate_bytes(from, bytes(from_max), false);
        let to = if action == TextAction::Length {
            super::places::Located { pointer: None, gate: None, block: super::places::Block::Any, ..from }
        } else {
            self.locate_bytes(to, bytes(to_max), action.writes())
        };
        let dst = self.temporary();
        self.push(Inst::Text { action, dst, to: to.address, to_max, from: from.address, from_max, piece: piece.unwrap_or_default() });
        self.release_pointer(&from);
        self.release_pointer(&to);
        dst
    }
}
