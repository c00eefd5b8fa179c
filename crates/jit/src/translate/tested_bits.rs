//! Comparisons that tell one bit of a number, as `(word AND 16#0010) <> 0` does: the bit stays where it is until somebody needs it elsewhere.

use cranelift_codegen::ir::{InstructionData, Opcode};

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
}
