//! STRING and WSTRING: assignment, comparison, length.

use sieben_engine::fault::lost;
use sieben_engine::ir::{Inst, TextAction, TextRoom, Var};
use sieben_model::address::Width;

use super::Lowering;
use super::pointers::at;
use crate::st::tree::{Place, Text};

/// Characters that a STRING may have.
const CHARACTERS_MAX: usize = 254;
/// Characters that a WSTRING may have.
const WIDE_CHARACTERS_MAX: usize = 16_382;

/// The room of a text of so many characters. An empty text has room for no character; 0 would mean the same here.
fn exactly(characters: usize, wide: bool) -> TextRoom {
    TextRoom { characters_max: characters as u16, wide }
}

impl Lowering<'_> {
    /// A text as a place, and what it has room for.
    pub(super) fn text(&mut self, text: &Text) -> (Place, TextRoom) {
        match text {
            Text::Place { place, room } => (place.clone(), *room),
            Text::Constant(characters) => {
                let characters = &characters[..characters.len().min(CHARACTERS_MAX)];
                let length = characters.len() as u8;
                let bytes: Vec<u8> = [length, length].into_iter().chain(characters.iter().copied()).collect();
                (self.literal_text(&bytes), exactly(characters.len(), false))
            }
            Text::WideConstant(characters) => {
                let characters = &characters[..characters.len().min(WIDE_CHARACTERS_MAX)];
                let length = characters.len() as u16;
                let bytes: Vec<u8> = [length, length].iter().chain(characters).flat_map(|word| word.to_be_bytes()).collect();
                (self.literal_text(&bytes), exactly(characters.len(), true))
            }
            Text::Character(value) => {
                let room = exactly(1, text.is_wide());
                let value = self.value(value);
                let place = self.hidden_bytes(room.bytes().next_multiple_of(2) + 2);
                let (behind, width, head, whole) = match room.wide {
                    false => (16, Width::Byte, 0x0101, Width::Word),
                    true => (32, Width::Word, 0x0001_0001, Width::DoubleWord),
                };
                self.store(&at(&place, behind), width, value);
                self.release(value);
                let head = self.constant(head);
                self.store_local(place.offset, whole, head);
                (place, room)
            }
            Text::Call { call, room } => {
                self.call(call);
                (self.text_result(*room), *room)
            }
            Text::After(statements, text) => {
                self.part();
                self.inner_statements(statements);
                self.text(text)
            }
            Text::Converted(inner) => {
                let (from, from_room) = self.text(inner);
                // The result of a function stays where it is while the copy is made; a variable may move with its index.
                let from = self.freeze(&from);
                let room = match text.room() {
                    room if room.is_unknown() => exactly(CHARACTERS_MAX, room.wide),
                    room => room,
                };
                let place = self.hidden_bytes(room.bytes());
                let missing = self.text_instruction(TextAction::Assign, (&place, room), (&from, from_room), None);
                if !room.wide {
                    self.lost_if(missing, lost::CHARACTER, missing);
                }
                self.release(missing);
                (place, room)
            }
        }
    }

    /// The bytes of a literal in hidden local data.
    fn literal_text(&mut self, bytes: &[u8]) -> Place {
        let place = self.hidden_bytes(bytes.len() as u32);
        self.store_bytes(place.offset, bytes);
        place
    }

    /// Where the last call left its result.
    fn text_result(&mut self, room: TextRoom) -> Place {
        match self.result.take() {
            Some(position) => self.local(position),
            None => self.empty_text(room),
        }
    }

    /// A place in the local data.
    pub(super) fn local(&self, position: u32) -> Place {
        use crate::st::tree::Base;
        Place { base: Base::Area(sieben_model::address::Area::Local), offset: position, indexes: Vec::new(), span: self.span }
    }

    /// An empty text in hidden local data.
    pub(super) fn empty_text(&mut self, room: TextRoom) -> Place {
        let place = self.hidden_bytes(room.head() + u32::from(room.characters_max) * room.unit());
        let (shift, width) = if room.wide { (16, Width::DoubleWord) } else { (8, Width::Word) };
        let head = self.constant(u64::from(room.characters_max) << shift);
        self.store_local(place.offset, width, head);
        place
    }

    /// `target := source`, cut to the room there.
    pub(super) fn assign_text(&mut self, target: &Place, room: TextRoom, source: &Text) {
        if let Text::Call { call, room: most } = source {
            if self.call_into(call, Some((target, room))) {
                return;
            }
            let place = self.text_result(*most);
            return self.copy_text(target, room, &place, *most);
        }
        let (place, from_room) = self.text(source);
        self.copy_text(target, room, &place, from_room);
    }

    pub(super) fn copy_text(&mut self, target: &Place, room: TextRoom, place: &Place, from_room: TextRoom) {
        let [place, target] = self.settle([place, target]);
        let cut = self.text_instruction(TextAction::Assign, (&target, room), (&place, from_room), None);
        self.release(cut);
    }

    /// −1, 0 or 1.
    pub(super) fn compare_texts(&mut self, a: &Text, b: &Text) -> Var {
        let mut first = if self.text_changes(b) { self.kept_text(a) } else { self.text(a) };
        if self.text_breaks(b) {
            first.0 = self.freeze(&first.0);
        }
        let second = self.text(b);
        let [a, b] = self.settle([&first.0, &second.0]);
        self.text_instruction(TextAction::Compare, (&a, first.1), (&b, second.1), None)
    }

    /// The number of characters.
    pub(super) fn text_length(&mut self, text: &Text) -> Var {
        let (place, room) = self.text(text);
        self.text_instruction(TextAction::Length, (&place, room), (&place, room), None)
    }

    /// The result of a text instruction. The piece stays.
    pub(super) fn text_instruction(
        &mut self,
        action: TextAction,
        (to, to_room): (&Place, TextRoom),
        (from, from_room): (&Place, TextRoom),
        piece: Option<[Var; 2]>,
    ) -> Var {
        let from = self.locate_bytes(from, from_room.bytes(), false);
        let to = if action == TextAction::Length {
            super::places::Located { pointer: None, gate: None, block: super::places::Block::Any, ..from }
        } else {
            self.locate_bytes(to, to_room.bytes(), action.writes())
        };
        let dst = self.temporary();
        self.push(Inst::Text { action, dst, to: to.address, to_room, from: from.address, from_room, piece: piece.unwrap_or_default() });
        self.release_pointer(&from);
        self.release_pointer(&to);
        dst
    }
}
