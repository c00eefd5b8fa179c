//! Texts behind pointers of which nothing is known when the code is made: in a data block that the pointer names, in local data of the
//! caller, in I, Q and M. Where they lie is found without a branch; one comparison tells whether all that they say they have room for is
//! there, and Rust code is asked where it is not.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::{Place, TextRoom};
use sieben_model::address::Area;

use super::memory::{Address, Bit, data};
use super::promote::Base;
use super::text_order::WORD;
use super::texts::{NUMBER_SHIFT, Whole};
use super::value::Val;
use super::{TRUSTED, Translator};
use crate::run::Run;

/// Bytes that a STRING may have: they are there to be read, also where its area ends before.
const MOST_BYTES: u32 = TextRoom::narrow(u8::MAX).bytes();
/// The same with those that are read behind its last character.
const READ_BYTES: u32 = MOST_BYTES + WORD;

/// Where a text was found.
#[derive(Clone, Copy)]
pub(super) struct Found {
    /// Whether all bytes that a STRING may have are in the arena.
    in_arena: Value,
    /// How many of its area there are from where it begins, with a sign.
    left: Value,
}

impl Translator<'_> {
    /// A text that may lie anywhere, with what tells whether it is there.
    pub(super) fn text_anywhere(&mut self, place: Place, room: TextRoom, write: bool) -> Option<Whole> {
        let quick = !self.options.optimize && !self.options.exact;
        let asks = write && self.options.asks_before_writing;
        let size = i64::try_from(self.layout.size).ok()?;
        if quick || asks || room.wide || self.cold.is_some() || size < i64::from(READ_BYTES) {
            return None;
        }
        let (start, length, bits, touched) = match place {
            Place::Crossing { pointer, offset: 0 } => {
                let pointer = self.get(pointer);
                let pointer = self.force(pointer);
                if pointer.constant().is_some() {
                    return None;
                }
                let pointer = self.word(pointer);
                let bits = self.b.ins().ireduce(I32, pointer);
                let (start, length) = self.area_of_pointer(pointer, bits);
                (start, length, bits, None)
            }
            Place::Indirect { area: area @ (Area::SharedData | Area::InstanceData), pointer, offset } => {
                let (base, length) = self.open_block(area, write)?;
                let touched = match (base, length) {
                    (Val::Const(base), Val::Const(length)) => Some((Base::Arena, base as i64..(base + length) as i64)),
                    _ => None,
                };
                let [base, length] = [base, length].map(|value| self.word(value));
                let pointer = self.get(pointer);
                let bits = self.int(pointer);
                (base, length, self.b.ins().iadd_imm_u(bits, i64::from(offset)), touched)
            }
            _ => return None,
        };
        let position = self.b.ins().band_imm_u(bits, 0x00FF_FFFF);
        // A pointer that is not to the beginning of a byte becomes a large number here.
        let byte = self.b.ins().rotr_imm_u(position, 3);
        let byte = self.b.ins().uextend(I64, byte);
        let left = self.b.ins().isub(length, byte);
        let first = self.b.ins().iadd(start, byte);
        let in_arena = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, first, size - i64::from(READ_BYTES));
        let zero = self.b.ins().iconst(I64, 0);
        let first = self.b.ins().select(in_arena, first, zero);
        let base = self.b.ins().iadd(self.arena, first);
        let address = Address { base, offset: 0, bit: Bit::Number(0) };
        let there = if room.is_unknown() { MOST_BYTES } else { room.bytes() };
        Some(Whole { address, touched, there, room, most: None, empty: false, found: Some(Found { in_arena, left }) })
    }

    /// A text that may lie anywhere, with what it says that there is room for, and whether all of that is there. Nothing waits any more.
    pub(super) fn found_text(&mut self, text: Whole, Found { in_arena, left }: Found) -> (Whole, Value) {
        let head = i64::from(text.room.head());
        let (text, bytes) = match text.room.is_unknown() {
            true => {
                let most = self.b.ins().uload8(I32, data(), text.address.base, 0);
                let room = TextRoom { characters_max: u8::MAX.into(), ..text.room };
                let bytes = self.b.ins().uextend(I64, most);
                (Whole { room, most: Some(most), ..text }, self.b.ins().iadd_imm_u(bytes, head))
            }
            false => {
                let bytes = self.b.ins().iconst(I64, i64::from(text.room.bytes()));
                (text, bytes)
            }
        };
        let fits = self.b.ins().icmp(IntCC::SignedGreaterThanOrEqual, left, bytes);
        (text, self.b.ins().band(in_arena, fits))
    }

    /// First byte and number of bytes of the area to which a pointer leads; none where Rust code has to look.
    pub(super) fn area_of_pointer(&mut self, pointer: Value, bits: Value) -> (Value, Value) {
        let code = self.b.ins().ushr_imm_u(bits, 24);
        let (start, length) = self.area_by_code(bits);
        // Behind the last data block stands one that is not loaded, under 0 one without bytes.
        let number = self.b.ins().ushr_imm_u(pointer, i64::from(NUMBER_SHIFT));
        let number = self.b.ins().band_imm_u(number, 0xFFFF);
        let last = self.load_run(offset_of!(Run<'_, '_>, open_last));
        let is_loaded = self.b.ins().icmp(IntCC::UnsignedLessThan, number, last);
        let number = self.b.ins().select(is_loaded, number, last);
        let number = self.b.ins().ishl_imm_u(number, 3);
        let table = self.load_run(offset_of!(Run<'_, '_>, open_table));
        let entry = self.b.ins().iadd(table, number);
        let [block, block_length] = [0, 4].map(|offset| self.b.ins().uload32(TRUSTED, entry, offset));
        let in_block = self.b.ins().icmp_imm_u(IntCC::Equal, code, i64::from(Area::SharedData.pointer_code()));
        let start = self.b.ins().select(in_block, block, start);
        let length = self.b.ins().select(in_block, block_length, length);
        self.or_of_caller(bits, (start, length))
    }
}
