//! String instructions: runtime functions do them, without a slow path where both strings are proven to be in bounds.

use std::ops::Range;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, Value};
use sieben_engine::ir::{Inst, Place, TextAction, TextRoom, Var};
use sieben_model::address::{Area, Width};

use super::memory::{Address, Bit, data, moved};
use super::range_analysis::StringPlace;
use super::scalar_promotion::Base;
use super::symbols::Symbol;
use super::value::Val;
use super::{Continuation, Translator};
use crate::runtime_calls::{RuntimeCall, text_kind};

/// Bits of a pointer before the number of a data block.
pub(super) const NUMBER_SHIFT: u32 = 32;

/// A text that is known to lie inside its area, and to be accessible there.
#[derive(Clone)]
pub(super) struct InBoundsString {
    pub(super) address: Address,
    /// The bytes that it may lie in; `None` = any.
    pub(super) touched: Option<(Base, Range<i64>)>,
    /// How many of them are sure to be there, from where it begins.
    pub(super) there: u32,
    /// No more characters than these count.
    pub(super) room: TextRoom,
    /// How many there is room for, if only the text itself says so.
    pub(super) most: Option<Value>,
    /// Whether it is known to be empty.
    pub(super) empty: bool,
}

impl InBoundsString {
    /// How many characters are sure to be there.
    pub(super) fn characters_there(&self) -> u32 {
        ((self.there - self.room.head()) / self.room.unit()).min(self.room.characters_max.into())
    }

    /// What the instruction says that there is room for.
    fn said(&self) -> TextRoom {
        if self.most.is_some() { self.room.unknown() } else { self.room }
    }
}

impl Translator<'_> {
    pub(super) fn text(&mut self, index: u32, inst: &Inst) {
        let Inst::Text { action, dst, to, from, piece, .. } = *inst else { return };
        if let Some(result) = self.text_inside(index, inst) {
            return self.set(dst, result);
        }
        let pointers = [self.pointer(from), self.pointer(to)];
        let piece = self.piece(action, piece);
        self.store_open_blocks();
        let site = self.site(index);
        let failed = self.ask(RuntimeCall::TryText, &[self.link, site, pointers[0], pointers[1], piece]);
        self.unless_failed(failed, RuntimeCall::Failed, &[self.link, site], Continuation::NextStatement);
        self.words.forget_all();
        let result = self.result();
        self.set(dst, Val::Word(result));
    }

    /// The result of an instruction whose texts are known to lie inside their areas.
    fn text_inside(&mut self, index: u32, inst: &Inst) -> Option<Val> {
        let Inst::Text { action, dst, to, to_room, from, from_room, piece } = *inst else { return None };
        let [to, from] = [(to, to_room), (from, from_room)];
        let target = match action {
            TextAction::Length => None,
            _ => Some(self.whole_text(index, (to, true), action.writes())?),
        };
        let source = match &target {
            Some(target) if action.takes_number() => target.clone(),
            _ => self.whole_text(index, (from, false), false)?,
        };
        let lengths = self.bytes.numbers.take_lengths();
        self.settle_bytes();
        self.bytes.numbers.keep_lengths(lengths);
        for text in [Some(&source), target.as_ref()].into_iter().flatten() {
            match &text.touched {
                Some(touched) => self.store_promoted_in(touched),
                None => self.store_promoted(),
            }
        }
        let word = self.piece(action, piece);
        let [source, target] = [Some(source), target].map(|text| text.map(|text| self.with_most(text)));
        let checks: Vec<Value> = [&source, &target].into_iter().flatten().filter_map(|text| text.1).collect();
        let (source, target) = (source?.0, target.map(|text| text.0));
        let inside = checks.into_iter().reduce(|a, b| self.b.ins().band(a, b));
        let slow = inside.map(|inside| {
            let (fast, slow) = (self.b.create_block(), self.cold_block());
            self.b.ins().brif(inside, fast, &[], slow, &[]);
            self.b.switch_to_block(fast);
            self.b.seal_block(fast);
            slow
        });
        let mut characters = None;
        let result = match &target {
            None => self.text_length(&source),
            Some(target) => match self.text_written_out((action, target, &source, piece), (index, dst, word)) {
                Some(written) => {
                    characters = written.characters;
                    written.result
                }
                None => self.call_for_texts(action, target, &source, word),
            },
        };
        let is_known = slow.is_none();
        let result = match slow {
            Some(slow) => self.or_asked((index, inst), slow, (result, word)),
            None => result,
        };
        if let Some(target) = target.filter(|_| action.writes()) {
            let Address { base, .. } = target.address;
            let is_text = action != TextAction::Number && !target.room.wide && target.most.is_none();
            let says = base == self.local && is_text;
            self.forget_text(&target);
            if let Some(characters) = characters.filter(|_| is_known) {
                self.remember_characters(&target, characters);
            }
            if says {
                // It says so now.
                self.remember_word(target.address, Width::Byte, Val::Const(target.room.characters_max.into()));
            }
        }
        Some(Val::Int(result))
    }

    /// Forgets what was known of the bytes of a text that was written.
    fn forget_text(&mut self, text: &InBoundsString) {
        match &text.touched {
            Some(touched) => {
                self.take_promoted_in(touched);
                self.forget_words_in(touched);
                self.settle_touched(touched, true);
            }
            None => {
                self.take_promoted();
                self.forget_memory();
            }
        }
    }

    /// The result that was found, or that of Rust code where a text may be longer than its area.
    fn or_asked(&mut self, (index, inst): (u32, &Inst), slow: Block, (result, piece): (Value, Value)) -> Value {
        let Inst::Text { to, from, .. } = *inst else { return result };
        let go_on = self.b.create_block();
        let delivered = self.b.append_block_param(go_on, I32);
        self.b.ins().jump(go_on, &[BlockArg::Value(result)]);
        self.b.switch_to_block(slow);
        self.b.seal_block(slow);
        let before = self.cold.replace(slow);
        let pointers = [self.pointer(from), self.pointer(to)];
        self.store_open_blocks();
        let site = self.site(index);
        let failed = self.ask(RuntimeCall::TryText, &[self.link, site, pointers[0], pointers[1], piece]);
        let value = self.result();
        let value = self.b.ins().ireduce(I32, value);
        self.go_on_behind_question((failed, site), (go_on, &[BlockArg::Value(value)]), Continuation::NextStatement, before);
        delivered
    }

    /// A text with what it says itself that there is room for, and whether so many characters are there, if that has to be looked at.
    fn with_most(&mut self, text: InBoundsString) -> (InBoundsString, Option<Value>) {
        if !text.room.is_unknown() {
            return (text, None);
        }
        let Address { base, offset, .. } = text.address;
        // Both lengths of a literal.
        let lengths = (base == self.local).then(|| self.constant_bytes(offset, 2)).flatten();
        if let Some(&[most, _]) = lengths.as_deref()
            && most > 0
            && u32::from(most) + text.room.head() <= text.there
            && let Some((base, bytes)) = text.touched.clone()
        {
            let room = TextRoom::narrow(most);
            let end = if bytes.end - bytes.start == text.there.into() { bytes.start + i64::from(room.bytes()) } else { bytes.end };
            return (InBoundsString { room, touched: Some((base, bytes.start..end)), ..text }, None);
        }
        let empty = lengths.is_some_and(|lengths| lengths == [0, 0]);
        let most = self.b.ins().uload8(I32, data(), base, offset);
        let there = i64::from(text.there - text.room.head());
        let inside = (there < u8::MAX.into() && !empty).then(|| self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, most, there));
        let room = TextRoom { characters_max: there.clamp(1, u8::MAX.into()) as u16, ..text.room };
        (InBoundsString { room, most: Some(most), empty, ..text }, inside)
    }

    /// The result of a call of Rust code.
    pub(super) fn call_for_texts(&mut self, action: TextAction, to: &InBoundsString, from: &InBoundsString, piece: Value) -> Value {
        let kind = self.b.ins().iconst(I64, text_kind(action, to.said(), from.said()) as i64);
        let [from, to] = [from.address, to.address].map(|address| self.arena_byte(address));
        let function = self.functions.get(self.module, Symbol::Question(RuntimeCall::Text));
        let result = self.call(function, &[self.run, kind, from, to, piece]);
        self.b.ins().ireduce(I32, result)
    }

    /// A text that is known to lie inside its area.
    fn whole_text(&mut self, index: u32, ((place, room), is_to): ((Place, TextRoom), bool), write: bool) -> Option<InBoundsString> {
        if let Some(known) = self.known_text((place, room), write) {
            let there = room.bytes();
            return Some(InBoundsString { address: known.1, touched: Some(touched(known, room)), there, room, most: None, empty: false });
        }
        let StringPlace { bytes: touched, there, block, room: said } = self.ranges.text(index, is_to)?;
        let begins = touched.1.end - touched.1.start == i64::from(there);
        let address = match place {
            Place::Fixed { .. } | Place::Indirect { .. } if !room.is_unknown() => self.span(place, room.bytes(), write)?,
            // Where it begins is known then.
            _ if begins => {
                Address { base: self.address_of_base(touched.0), offset: i32::try_from(touched.1.start).ok()?, bit: Bit::Number(0) }
            }
            Place::Crossing { pointer, offset } => {
                let block = block?;
                let area = (self.arena, i32::try_from(block.start).ok()?, block.len() as u64);
                let pointer = self.get(pointer);
                let pointer = self.force(pointer);
                self.address_inside(area, pointer, offset, (Width::Byte, there))
            }
            _ => return None,
        };
        Some(InBoundsString { address, touched: Some(touched), there, room: said, most: None, empty: false })
    }

    /// The piece in one word.
    fn piece(&mut self, action: TextAction, piece: [Var; 2]) -> Value {
        if !action.takes_piece() {
            return self.b.ins().iconst(I64, 0);
        }
        let [first, count] = piece.map(|var| self.get(var));
        if action.takes_number() {
            return self.word(first);
        }
        let (first, count) = (self.force(first), self.force(count));
        if let (Val::Const(first), Val::Const(count)) = (first, count) {
            return self.b.ins().iconst(I64, (first & 0xFFFF_FFFF | count << 32) as i64);
        }
        let [first, count] = [first, count].map(|value| {
            let value = self.int(value);
            self.b.ins().uextend(I64, value)
        });
        let count = self.b.ins().ishl_imm_u(count, 32);
        self.b.ins().bor(first, count)
    }

    /// The arena byte of an address.
    pub(super) fn arena_byte(&mut self, Address { base, offset, .. }: Address) -> Value {
        if base == self.arena {
            return self.b.ins().iconst(I64, i64::from(offset));
        }
        let start = self.b.ins().isub(base, self.arena);
        self.b.ins().iadd_imm_s(start, i64::from(offset))
    }

    /// Where a text lies whose address and greatest length are known, if all of it is inside its area and may be accessed.
    fn known_text(&mut self, (place, room): (Place, TextRoom), write: bool) -> Option<(Base, Address)> {
        if room.is_unknown() {
            return None;
        }
        let (area, position) = match place {
            Place::Fixed { area, position } => (area, position),
            Place::Indirect { area, pointer, offset } => {
                if offset % 8 == 0
                    && let Some((base, offset)) = self.instance_bytes(place, room.bytes(), write)
                {
                    return Some((base, Address { base: self.address_of_base(base), offset, bit: Bit::Number(0) }));
                }
                let pointer = self.get(pointer);
                (area, moved(self.force(pointer).constant()?, offset))
            }
            Place::Crossing { pointer, offset } => {
                let pointer = self.get(pointer);
                let pointer = self.force(pointer).constant()?;
                let area = sieben_engine::access::pointed_area(pointer, write).ok()?;
                let number = (pointer >> NUMBER_SHIFT & 0xFFFF) as u16;
                if number != 0 && area == Area::SharedData {
                    return self.text_in_block(number, moved(pointer, offset), room, write);
                }
                (area, moved(pointer, offset))
            }
        };
        if !position.is_multiple_of(8) || matches!(area, Area::CallerLocal | Area::PeripheralInput | Area::PeripheralOutput) {
            return None;
        }
        let (base, start, length) = self.known_area(area, write)?;
        inside(start.into(), length, position, room).map(|offset| {
            let kind = if base == self.local { Base::Local } else { Base::Arena };
            (kind, Address { base, offset, bit: Bit::Number(0) })
        })
    }

    /// The same in a data block that a pointer names.
    fn text_in_block(&mut self, number: u16, position: u32, room: TextRoom, write: bool) -> Option<(Base, Address)> {
        if !position.is_multiple_of(8) || write && self.layout.read_only.contains(&number) {
            return None;
        }
        let range = self.layout.data_blocks.get(&number)?;
        let offset = inside(i64::try_from(range.start).ok()?, range.len() as u64, position, room)?;
        self.pinned.insert(number);
        Some((Base::Arena, Address { base: self.arena, offset, bit: Bit::Number(0) }))
    }
}

/// Where a text begins behind a base, if all of it lies in an area that begins at a byte behind it and has so many.
fn inside(start: i64, length: u64, position: u32, room: TextRoom) -> Option<i32> {
    let byte = u64::from(position / 8);
    let end = byte + u64::from(room.bytes());
    i32::try_from(start + byte as i64).ok().filter(|_| end <= length)
}

/// The bytes that a text instruction may touch.
fn touched((base, address): (Base, Address), room: TextRoom) -> (Base, Range<i64>) {
    let start = i64::from(address.offset);
    (base, start..start + i64::from(room.bytes()))
}
