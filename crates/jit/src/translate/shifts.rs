//! Instruction selection for shifts and rotations by variable counts, and for operations on single bits of a number: a third part of the
//! list of `instruction_selection.rs`, under the same comparison.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I16, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;

use super::{Translator, value::Val};

/// Where bits go.
#[derive(Clone, Copy)]
enum ShiftDirection {
    Left,
    Right,
    /// To the right, with the sign behind them.
    Signed,
}

impl Translator<'_> {
    /// The operation as machine code, if it has such a form.
    #[rustfmt::skip] // A table.
    pub(super) fn inline_shift(&mut self, op: Op, a: Val, b: Val, c: Val) -> Option<Val> {
        Some(match op {
            Op::Shl8 => self.shifted_by(ShiftDirection::Left, 8, a, b),
            Op::Shr8 => self.shifted_by(ShiftDirection::Right, 8, a, b),
            Op::Sar8 => self.shifted_by(ShiftDirection::Signed, 8, a, b),
            Op::Shl16 => self.shifted_by(ShiftDirection::Left, 16, a, b),
            Op::Shr16 => self.shifted_by(ShiftDirection::Right, 16, a, b),
            Op::Sar16 => self.shifted_by(ShiftDirection::Signed, 16, a, b),
            Op::Shl32 => self.shifted_by(ShiftDirection::Left, 32, a, b),
            Op::Shr32 => self.shifted_by(ShiftDirection::Right, 32, a, b),
            Op::Sar32 => self.shifted_by(ShiftDirection::Signed, 32, a, b),
            Op::Shl64 => self.shifted_64(ShiftDirection::Left, a, b),
            Op::Shr64 => self.shifted_64(ShiftDirection::Right, a, b),
            Op::Sar64 => self.shifted_64(ShiftDirection::Signed, a, b),
            Op::Shl16Out => self.shifted_out(ShiftDirection::Left, 16, a, b),
            Op::Shr16Out => self.shifted_out(ShiftDirection::Right, 16, a, b),
            Op::Sar16Out => self.shifted_out(ShiftDirection::Signed, 16, a, b),
            Op::Shl32Out => self.shifted_out(ShiftDirection::Left, 32, a, b),
            Op::Shr32Out => self.shifted_out(ShiftDirection::Right, 32, a, b),
            Op::Sar32Out => self.shifted_out(ShiftDirection::Signed, 32, a, b),
            Op::Rol8 => self.rotated(ShiftDirection::Left, 8, a, b),
            Op::Ror8 => self.rotated(ShiftDirection::Right, 8, a, b),
            Op::Rol16 => self.rotated(ShiftDirection::Left, 16, a, b),
            Op::Ror16 => self.rotated(ShiftDirection::Right, 16, a, b),
            Op::Rol32 => self.rotated(ShiftDirection::Left, 32, a, b),
            Op::Ror32 => self.rotated(ShiftDirection::Right, 32, a, b),
            Op::Rol64 => self.rotated(ShiftDirection::Left, 64, a, b),
            Op::Ror64 => self.rotated(ShiftDirection::Right, 64, a, b),
            Op::Rol33 => { let (a, carry) = (self.int(a), self.flag(b)); let moved = self.b.ins().ishl_imm_u(a, 1); Val::Int(self.b.ins().bor(moved, carry)) }
            Op::Ror33 => {
                let (a, carry) = (self.int(a), self.flag(b));
                let (moved, first) = (self.b.ins().ushr_imm_u(a, 1), self.b.ins().ishl_imm_u(carry, 31));
                Val::Int(self.b.ins().bor(moved, first))
            }
            Op::ShiftCount if self.bits_used(a) <= 8 => a,
            Op::ShiftCount => {
                let count = self.word(a);
                let most = self.b.ins().iconst(I64, 255);
                let count = self.b.ins().umin(count, most);
                Val::Int(self.b.ins().ireduce(I32, count))
            }
            Op::BitOf => {
                let (a, at) = (self.word(a), self.word(b));
                let moved = self.b.ins().ushr(a, at);
                Val::Bit { value: self.b.ins().ireduce(I32, moved), clean: false }
            }
            Op::WithBit => {
                let (a, at, value) = (self.word(a), self.word(b), self.word_of_bit(c));
                let there = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, at, 64);
                let there = self.b.ins().uextend(I64, there);
                let (mask, value) = (self.b.ins().ishl(there, at), self.b.ins().ishl(value, at));
                let (others, new) = (self.b.ins().band_not(a, mask), self.b.ins().band(value, mask));
                Val::Word(self.b.ins().bor(others, new))
            }
            Op::CountOnes => { let a = self.word(a); let ones = self.b.ins().popcnt(a); Val::Int(self.b.ins().ireduce(I32, ones)) }
            Op::LowestOne => { let a = self.word(a); let zeros = self.b.ins().ctz(a); Val::Int(self.b.ins().ireduce(I32, zeros)) }
            _ => return self.inline_decimal(op, a),
        })
    }

    /// A count of eight bits, at most 63, in 64.
    fn count_to_63(&mut self, count: Val) -> Value {
        let is_small = self.bits_used(count) <= 6;
        let count = self.count_of_8_bits(count);
        if is_small {
            return count;
        }
        let most = self.b.ins().iconst(I64, 63);
        self.b.ins().umin(count, most)
    }

    fn count_of_8_bits(&mut self, count: Val) -> Value {
        let is_small = self.bits_used(count) <= 8;
        let count = self.int(count);
        let count = if is_small { count } else { self.b.ins().band_imm_u(count, 0xFF) };
        self.b.ins().uextend(I64, count)
    }

    /// A number of at most 32 bits in 64: all of its bits can be shifted away by 63 or less.
    fn in_64_bits(&mut self, to: ShiftDirection, bits: u32, a: Val) -> Value {
        match to {
            ShiftDirection::Left | ShiftDirection::Right => {
                let a = self.unsigned(bits, a);
                self.b.ins().uextend(I64, a)
            }
            ShiftDirection::Signed => {
                let a = self.signed(bits, a);
                self.b.ins().sextend(I64, a)
            }
        }
    }

    fn moved_by(&mut self, to: ShiftDirection, a: Value, count: Value) -> Value {
        match to {
            ShiftDirection::Left => self.b.ins().ishl(a, count),
            ShiftDirection::Right => self.b.ins().ushr(a, count),
            ShiftDirection::Signed => self.b.ins().sshr(a, count),
        }
    }

    fn shifted_by(&mut self, to: ShiftDirection, bits: u32, a: Val, count: Val) -> Val {
        if bits == 32 && self.bits_used(count) <= 5 {
            let (a, count) = (self.int(a), self.int(count));
            return Val::Int(self.moved_by(to, a, count));
        }
        let (a, count) = (self.in_64_bits(to, bits, a), self.count_to_63(count));
        let moved = self.moved_by(to, a, count);
        let low = self.b.ins().ireduce(I32, moved);
        self.cut(bits, low)
    }

    fn shifted_64(&mut self, to: ShiftDirection, a: Val, count: Val) -> Val {
        let a = self.word(a);
        if matches!(to, ShiftDirection::Signed) {
            let count = self.count_to_63(count);
            return Val::Word(self.b.ins().sshr(a, count));
        }
        let count = self.count_of_8_bits(count);
        let moved = self.moved_by(to, a, count);
        let all = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, count, 63);
        let none = self.b.ins().iconst(I64, 0);
        Val::Word(self.b.ins().select(all, none, moved))
    }

    /// The bit that was shifted out last; 0 if none was.
    fn shifted_out(&mut self, to: ShiftDirection, bits: u32, a: Val, count: Val) -> Val {
        let (a, count) = (self.in_64_bits(to, bits, a), self.count_to_63(count));
        let last = if matches!(to, ShiftDirection::Left) {
            let moved = self.moved_by(to, a, count);
            self.b.ins().ushr_imm_u(moved, i64::from(bits))
        } else {
            let above = self.b.ins().ishl_imm_u(a, 1);
            self.moved_by(to, above, count)
        };
        Val::Bit { value: self.b.ins().ireduce(I32, last), clean: false }
    }

    fn rotated(&mut self, to: ShiftDirection, bits: u32, a: Val, count: Val) -> Val {
        let (a, count) = (if bits == 64 { self.word(a) } else { self.int(a) }, self.int(count));
        let ty = match bits {
            8 => Some(I8),
            16 => Some(I16),
            _ => None,
        };
        let a = ty.map_or(a, |ty| self.b.ins().ireduce(ty, a));
        // Counts are taken modulo the size.
        let moved = if matches!(to, ShiftDirection::Left) { self.b.ins().rotl(a, count) } else { self.b.ins().rotr(a, count) };
        match bits {
            64 => Val::Word(moved),
            32 => Val::Int(moved),
            _ => Val::Int(self.b.ins().uextend(I32, moved)),
        }
    }
}
