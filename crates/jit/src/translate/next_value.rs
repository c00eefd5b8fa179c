//! Whether a FOR loop goes on: the next value is compared with the last one as it would be in a wider type, where it cannot turn over.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I16, I32, I64};
use cranelift_codegen::ir::{InstBuilder, InstructionData, Opcode, Value};

use super::Translator;
use super::value::Val;

impl Translator<'_> {
    /// "A sum is not beyond a limit, and it has not turned over", as one comparison of the sum as it would be in 64 bits.
    pub(super) fn compares_next(&mut self, compared: Val, lost: Val) -> Option<Val> {
        let (IntCC::NotEqual, exact, _) = self.comparison(lost)? else { return None };
        let (condition, sum, limit) = self.comparison(compared)?;
        let [value, by] = self.binary(exact, Opcode::Iadd)?;
        let (ty, I64) = (self.type_of(sum), self.type_of(exact)) else { return None };
        let (sum, bits) = match self.definition(sum) {
            Some((_, InstructionData::Unary { opcode: Opcode::Sextend, arg })) if self.type_of(arg) == I16 => (arg, 16),
            _ if ty == I32 => (sum, 32),
            _ => return None,
        };
        let [narrow_value, narrow_by] = self.binary(sum, Opcode::Iadd)?;
        let step = self.signed_constant(by)?;
        // Only a sum that turns over in the direction of the step is beyond all limits.
        let is_beyond = match condition {
            IntCC::SignedLessThanOrEqual => step > 0,
            IntCC::SignedGreaterThanOrEqual => step < 0,
            _ => false,
        };
        let low = |step: i64| step as u64 & ((1 << bits) - 1);
        let is_same = self.whole(value, bits) == self.whole(narrow_value, bits)
            && self.signed_constant(narrow_by).is_some_and(|narrow| low(narrow) == low(step));
        if !is_beyond || !is_same {
            return None;
        }
        let limit = self.b.ins().sextend(I64, limit);
        let stays = self.b.ins().icmp(condition, exact, limit);
        Some(Val::Bit { value: self.b.ins().uextend(I32, stays), clean: true })
    }

    /// The comparison whose result a bit is.
    pub(super) fn comparison(&self, bit: Val) -> Option<(IntCC, Value, Value)> {
        let Val::Bit { value, clean: true } = bit else { return None };
        let (_, InstructionData::Unary { opcode: Opcode::Uextend, arg }) = self.definition(value)? else { return None };
        match self.definition(arg)? {
            (_, InstructionData::IntCompare { cond, args: [a, b], .. }) => Some((cond, a, b)),
            _ => None,
        }
    }

    fn binary(&self, value: Value, wanted: Opcode) -> Option<[Value; 2]> {
        match self.definition(value)? {
            (_, InstructionData::Binary { opcode, args }) if opcode == wanted => Some(args),
            _ => None,
        }
    }

    fn type_of(&self, value: Value) -> cranelift_codegen::ir::Type {
        self.b.func.dfg.value_type(value)
    }

    /// A constant with its sign.
    fn signed_constant(&self, value: Value) -> Option<i64> {
        let number = match self.definition(value)? {
            (_, InstructionData::UnaryImm { opcode: Opcode::Iconst, imm }) => imm.bits(),
            (_, InstructionData::Unary { opcode: Opcode::Ireduce | Opcode::Sextend, arg }) => self.signed_constant(arg)?,
            _ => return None,
        };
        let unused = 64 - self.type_of(value).bits();
        Some(number << unused >> unused)
    }

    /// The value whose low bits another one shows, with so many of them.
    fn whole(&self, value: Value, bits: u32) -> Value {
        match self.definition(value) {
            Some((_, InstructionData::Unary { opcode: Opcode::Sextend | Opcode::Uextend | Opcode::Ireduce, arg }))
                if self.type_of(arg).bits() >= bits && self.type_of(value).bits() >= bits =>
            {
                self.whole(arg, bits)
            }
            _ => self.b.func.dfg.resolve_aliases(value),
        }
    }
}
