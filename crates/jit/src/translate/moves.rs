//! Copies of structures whose ends are known only when the program runs: behind VAR_IN_OUT, references, and indexes of which too little is
//! known. Where both ends lie is found as that of texts behind such pointers is; one comparison tells whether all bytes are there, and
//! Rust code is asked where they are not.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I8X16, I16, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Type, Value};
use sieben_engine::access;
use sieben_engine::ir::Place;
use sieben_model::address::{Area, Width};

use super::memory::{Address, Bit, data, moved};
use super::value::Val;
use super::{After, Translator};
use crate::ask::Question;

/// Longer moves are left to Rust code, which takes little time for each byte.
pub(super) const MOVED_BYTES_MAX: u32 = 256;

/// An end of a copy, and whether it is there, if that has to be looked at.
type End = (Address, Option<Value>);

impl Translator<'_> {
    /// Moves bytes whose places are looked for; whether it could be written.
    pub(super) fn move_anywhere(&mut self, index: u32, (from, to, bytes): (Place, Place, u32)) -> bool {
        let quick = !self.options.optimize && !self.options.exact;
        if quick || self.cold.is_some() || bytes > MOVED_BYTES_MAX {
            return false;
        }
        let Some((target, to_is_there)) = self.end_of_move(to, bytes, true) else { return false };
        let Some((source, from_is_there)) = self.end_of_move(from, bytes, false) else { return false };
        self.forget_what_was_asked();
        let looks = [to_is_there, from_is_there].into_iter().flatten().reduce(|a, b| self.b.ins().band(a, b));
        let Some(are_there) = looks else {
            self.copy_touching_anything((source, target), bytes);
            return true;
        };
        let [fast, go_on, slow] = [self.b.create_block(), self.b.create_block(), self.cold_block()];
        self.b.ins().brif(are_there, fast, &[], slow, &[]);
        self.b.switch_to_block(fast);
        self.b.seal_block(fast);
        self.copy_touching_anything((source, target), bytes);
        self.b.ins().jump(go_on, &[]);
        self.b.switch_to_block(slow);
        self.b.seal_block(slow);
        let before = self.cold.replace(slow);
        let pointers = [self.pointer(from), self.pointer(to)];
        self.store_open_blocks();
        let site = self.site(index);
        let failed = self.ask(Question::TryMove, &[self.link, site, pointers[0], pointers[1]]);
        self.go_on_behind_question((failed, site), (go_on, &[]), After::NextStatement, before);
        true
    }

    /// Copies bytes that may be those of any variable.
    fn copy_touching_anything(&mut self, (from, to): (Address, Address), bytes: u32) {
        self.store_promoted_memory();
        let pieces = self.pieces(from, bytes);
        self.write_pieces(to, &pieces);
        self.take_promoted_memory();
    }

    /// Reads bytes that are there, as few pieces as possible.
    pub(super) fn pieces(&mut self, from: Address, bytes: u32) -> Vec<Value> {
        self.pieces_by(from, bytes, |_, _, _| None)
    }

    /// The same where everything that writes local data says so: what is known there is not read.
    pub(super) fn known_pieces(&mut self, from: Address, bytes: u32) -> Vec<Value> {
        self.pieces_by(from, bytes, Self::constant_piece)
    }

    fn pieces_by(&mut self, from: Address, bytes: u32, known: impl Fn(&mut Self, Address, Type) -> Option<Value>) -> Vec<Value> {
        let mut pieces = Vec::new();
        let mut at = 0;
        while at < bytes as i32 {
            let left = bytes as i32 - at;
            let ty = [(16, I8X16), (8, I64), (4, I32), (2, I16)].into_iter().find(|&(size, _)| size <= left).map_or(I8, |(_, ty)| ty);
            let address = Address { offset: from.offset + at, ..from };
            let piece = known(self, address, ty).unwrap_or_else(|| self.b.ins().load(ty, data(), address.base, address.offset));
            pieces.push(piece);
            at += ty.bytes() as i32;
        }
        pieces
    }

    /// What is known to be in local data: to read it would wait for the stores of its parts.
    fn constant_piece(&mut self, Address { base, offset, .. }: Address, ty: Type) -> Option<Value> {
        if base != self.local || !self.options.optimize || self.cold.is_some() {
            return None;
        }
        let bytes = self.constant_bytes(offset, ty.bytes())?;
        if ty.is_vector() {
            let constant = self.b.func.dfg.constants.insert(bytes.into());
            return Some(self.b.ins().vconst(ty, constant));
        }
        Some(self.constant_of_bytes(&bytes, ty))
    }

    /// What a load of these bytes gives.
    pub(super) fn constant_of_bytes(&mut self, bytes: &[u8], ty: Type) -> Value {
        let number = bytes.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte));
        self.b.ins().iconst(ty, number as i64)
    }

    /// Writes pieces one behind the other.
    pub(super) fn write_pieces(&mut self, to: Address, pieces: &[Value]) {
        let mut at = to.offset;
        for &piece in pieces {
            self.b.ins().store(data(), piece, to.base, at);
            at += self.b.func.dfg.value_type(piece).bytes() as i32;
        }
    }

    fn end_of_move(&mut self, place: Place, bytes: u32, write: bool) -> Option<End> {
        match place {
            Place::Fixed { area, position } => self.end_in_area(area, Val::Const(0), position, bytes, write),
            Place::Indirect { area, pointer, offset } => {
                let pointer = self.get(pointer);
                let pointer = self.force(pointer);
                self.end_in_area(area, pointer, offset, bytes, write)
            }
            Place::Crossing { pointer, offset } => {
                let pointer = self.get(pointer);
                let pointer = self.force(pointer);
                match pointer.constant() {
                    // No number of a data block: the area is one that is known.
                    Some(constant) if constant >> 32 == 0 => match access::pointed_area(constant, write).ok()? {
                        Area::CallerLocal => self.end_in_caller(moved(constant, offset), bytes),
                        area => self.end_in_area(area, pointer, offset, bytes, write),
                    },
                    _ if write && self.options.asks_before_writing => None,
                    _ => {
                        let pointer = self.word(pointer);
                        let bits = self.b.ins().ireduce(I32, pointer);
                        let (start, length) = self.area_of_pointer(pointer, bits);
                        let base = self.b.ins().iadd(self.arena, start);
                        Some(self.end_at((base, 0, Val::Word(length)), bits, offset, bytes))
                    }
                }
            }
        }
    }

    /// Bytes of the local data of a caller that is in this function.
    fn end_in_caller(&mut self, position: u32, bytes: u32) -> Option<End> {
        let last = position.checked_add(8 * bytes.checked_sub(1)?)?;
        let (end, _) = self.way_to_caller(last, Width::Byte)?;
        let (offset, _) = self.way_to_caller(position, Width::Byte)?;
        let whole = position.is_multiple_of(8) && i64::from(end) - i64::from(offset) == i64::from(bytes) - 1;
        whole.then_some((Address { base: self.local, offset, bit: Bit::Number(0) }, None))
    }

    fn end_in_area(&mut self, area: Area, pointer: Val, offset: u32, bytes: u32, write: bool) -> Option<End> {
        if let Some(pointer) = pointer.constant() {
            let position = moved(pointer, offset);
            if !position.is_multiple_of(8) {
                return None;
            }
            if let Some((base, start, length)) = self.known_area(area, write) {
                let is_there = u64::from(position / 8) + u64::from(bytes) <= length;
                let offset = i32::try_from(i64::from(start) + i64::from(position / 8)).ok()?;
                return is_there.then_some((Address { base, offset, bit: Bit::Number(0) }, None));
            }
        }
        let area = match self.known_area(area, write) {
            Some((base, start, length)) => (base, start, Val::Const(length)),
            None => {
                let (base, length) = self.open_block(area, write)?;
                let base = self.word(base);
                (self.b.ins().iadd(self.arena, base), 0, length)
            }
        };
        let bits = self.int(pointer);
        Some(self.end_at(area, bits, offset, bytes))
    }

    /// Bytes behind a computed position in an area.
    fn end_at(&mut self, (base, start, length): (Value, i32, Val), pointer: Value, offset: u32, bytes: u32) -> End {
        let pointer = if offset == 0 { pointer } else { self.b.ins().iadd_imm_u(pointer, i64::from(offset)) };
        let position = self.b.ins().band_imm_u(pointer, 0x00FF_FFFF);
        // A pointer that is not to the beginning of a byte becomes a large number here.
        let byte = self.b.ins().rotr_imm_u(position, 3);
        let byte = self.b.ins().uextend(I64, byte);
        let end = self.b.ins().iadd_imm_u(byte, i64::from(bytes));
        let length = self.word(length);
        let is_there = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, end, length);
        let base = self.b.ins().iadd(base, byte);
        (Address { base, offset: start, bit: Bit::Number(0) }, Some(is_there))
    }
}
