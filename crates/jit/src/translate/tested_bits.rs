//! Bits that are taken out of numbers, as by `(word AND 16#0010) <> 0`, and put into them, as by `BOOL_TO_DINT(x) * 16`: they stay where
//! they are until somebody needs them elsewhere, and go there at once.

use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{InstBuilder, InstructionData, Opcode};

use super::Translator;
use super::value::Val;

impl Translator<'_> {
    /// The bit that is 1 where two values differ, or where they are the same, if one of them has but one bit that may be 1 and the other one
    /// says which value of it is meant.
    pub(super) fn tested_bit(&mut self, differ: bool, a: Val, b: Val) -> Option<Val> {
        let (Val::Int(bits), Val::Const(other)) = (self.force(a), self.force(b)) else { return None };
        let (_, InstructionData::Binary { opcode: Opcode::Band, args: [number, mask] }) = self.definition(bits)? else { return None };
        let mask = self.iconst(mask).filter(|mask| mask.is_power_of_two())?;
        if other != 0 && other != u64::from(mask) {
            return None;
        }
        let bit = Self::bit_value(number, mask.trailing_zeros() as u8, false);
        Some(if differ == (other == 0) { bit } else { self.not(bit) })
    }

    /// A bit of a number, by its own number below 64.
    pub(super) fn named_bit(&mut self, number: Val, bit: u8) -> Val {
        if bit < 32 {
            return Self::bit_value(self.int(number), bit, false);
        }
        let number = self.word(number);
        let moved = self.b.ins().ushr_imm_u(number, i64::from(bit));
        Val::Bit { value: self.b.ins().ireduce(I32, moved), clean: false }
    }

    /// A bit times a power of two: the bit at its place in a number of so many bits, the others 0.
    pub(super) fn weighted_bit(&mut self, bits: u32, a: Val, b: Val) -> Option<Val> {
        let (bit, weight) = match (self.force(a), self.force(b)) {
            (bit @ (Val::Bit { .. } | Val::At { .. }), Val::Const(weight))
            | (Val::Const(weight), bit @ (Val::Bit { .. } | Val::At { .. })) => (bit, weight),
            _ => return None,
        };
        if !weight.is_power_of_two() || weight >> bits.min(32) != 0 {
            return None;
        }
        let number = self.bit_at(bit, weight.trailing_zeros() as u8);
        if bits == 16 {
            self.narrow.insert(number, 16);
        }
        Some(Val::Int(number))
    }
}
