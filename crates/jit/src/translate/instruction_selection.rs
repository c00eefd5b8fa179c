//! Instruction selection: operations of the IR as instructions of Cranelift. This list is the only place where an operation has a second
//! meaning: each line is compared with its row in the table of operations over a grid of values.

use cranelift_codegen::ir::condcodes::{CondCode, FloatCC, IntCC};
use cranelift_codegen::ir::immediates::Ieee32;
use cranelift_codegen::ir::types::{F32, I16, I32, I64};
use cranelift_codegen::ir::{InstBuilder, InstructionData, MemFlagsData, Opcode, Value, ValueDef};
use cranelift_frontend::FunctionBuilder;
use sieben_engine::ir::Op;
use sieben_engine::machine::CALLS_SHIFT;
use sieben_model::address::Width;

use super::division_by_constants::factor_f32;
use super::memory::LOCAL_OF_CALLER;
use super::{Translator, value::Val};

impl Translator<'_> {
    /// The operation as machine code, if it has such a form. Arguments that are all constants were folded before.
    #[rustfmt::skip] // A table.
    pub(super) fn inline(&mut self, op: Op, args: &[Val]) -> Option<Val> {
        let a = args[0];
        let b = args.get(1).copied().unwrap_or(Val::Const(0));
        let c = args.get(2).copied().unwrap_or(Val::Const(0));
        let d = args.get(3).copied().unwrap_or(Val::Const(0));
        Some(match op {
            // Bits.
            Op::Not => self.not(a),
            Op::And => self.and(a, b),
            Op::AndNot | Op::ResetBit => self.and_not(a, b),
            Op::Or | Op::SetBit => self.or(a, b),
            Op::Xor => self.xor(a, b),
            Op::ScanAnd => self.choose_bit(d, |to| { let first = to.and(a, b); to.or(first, c) }, |_| b),
            Op::ScanAndNot => self.choose_bit(d, |to| { let first = to.and_not(a, b); to.or(first, c) }, |to| to.not(b)),
            Op::ScanOr => { let kept = self.and(a, c); self.or(kept, b) }
            Op::ScanOrNot => { let bit = self.not(b); let kept = self.and(a, c); self.or(kept, bit) }
            Op::ScanXor => { let kept = self.and(a, c); self.xor(kept, b) }
            Op::ScanXorNot => { let bit = self.not(b); let kept = self.and(a, c); self.xor(kept, bit) }
            Op::OrBegin => { let either = self.or(a, b); self.and(either, c) }

            // Choice.
            Op::Select => self.choose(a, b, c),
            Op::Gate => self.choose(b, a, Val::Const(0)),
            Op::IsNonzero => self.compare(IntCC::NotEqual, a, Val::Const(0)),
            Op::Equal => self.compare(IntCC::Equal, a, b),
            Op::Below => self.compare(IntCC::UnsignedLessThan, a, b),

            // Nesting and MCR stack.
            Op::NestingEntry => {
                let [rlo, or, fc, br] = [a, b, c, d].map(|bit| self.flag(bit));
                let or = self.b.ins().ishl_imm_u(or, 1);
                let fc = self.b.ins().ishl_imm_u(fc, 2);
                let br = self.b.ins().ishl_imm_u(br, 3);
                let low = self.b.ins().bor(rlo, or);
                let high = self.b.ins().bor(fc, br);
                let all = self.b.ins().bor(low, high);
                Val::Int(self.b.ins().bor_imm_u(all, 0x80))
            }
            Op::NestingPush => {
                let function = c.constant()? & 0xFF;
                let stack = self.word(a);
                let stack = self.b.ins().ishl_imm_u(stack, 8);
                let entry = self.word(b);
                let entry = self.b.ins().band_imm_u(entry, 0xFF);
                let entry = self.b.ins().bor_imm_u(entry, (function << 4 & 0xFF) as i64);
                Val::Word(self.b.ins().bor(stack, entry))
            }
            Op::NestingHasRoom => { let stack = self.word(a); let top = self.b.ins().ushr_imm_u(stack, 48); self.compare(IntCC::Equal, Val::Word(top), Val::Const(0)) }
            Op::NestingPop => { let stack = self.word(a); Val::Word(self.b.ins().ushr_imm_u(stack, 8)) }
            Op::NestingBr => { let stack = self.int(a); Val::Bit { value: self.b.ins().ushr_imm_u(stack, 3), clean: false } }
            Op::NestingOr => { let stack = self.int(a); let bits = self.b.ins().band_imm_u(stack, 0x66); self.compare(IntCC::Equal, Val::Int(bits), Val::Const(6)) }
            Op::NestingRlo => self.nesting_rlo(a, b),
            Op::McrHasRoom => { let stack = self.word(a); self.compare(IntCC::UnsignedLessThan, Val::Word(stack), Val::Const(0x100)) }
            Op::McrIsOpen => { let stack = self.word(a); self.compare(IntCC::UnsignedGreaterThan, Val::Word(stack), Val::Const(1)) }
            Op::McrPop => {
                let (stack, one) = (self.word(a), self.b.ins().iconst(I64, 1));
                let stack = self.b.ins().ushr_imm_u(stack, 1);
                Val::Word(self.b.ins().umax(stack, one))
            }
            Op::McrPush => {
                let stack = self.word(a);
                let stack = self.b.ins().ishl_imm_u(stack, 1);
                let rlo = self.word_of_bit(b);
                Val::Word(self.b.ins().bor(stack, rlo))
            }
            Op::McrOn => {
                let stack = self.word(b);
                let above = self.b.ins().iadd_imm_u(stack, 1);
                let zero = self.b.ins().band(stack, above);
                let all = self.compare(IntCC::Equal, Val::Word(zero), Val::Const(0));
                let inactive = self.not(a);
                self.or(inactive, all)
            }

            // Integers.
            Op::MergeLow16 => self.merge(a, b, 0xFFFF),
            Op::MergeLow8 => self.merge(a, b, 0xFF),
            Op::Low16 => Val::Int(self.low_bits(a, Width::Word)),
            Op::Low8 => Val::Int(self.low_bits(a, Width::Byte)),
            Op::Extend16 => Val::Int(self.i16(a)),
            Op::AddI16Wide => { let (a, b) = (self.i16(a), self.i16(b)); Val::Int(self.b.ins().iadd(a, b)) }
            Op::SubI16Wide => { let (a, b) = (self.i16(a), self.i16(b)); Val::Int(self.b.ins().isub(a, b)) }
            Op::MulI16Wide => { let (a, b) = (self.i16(a), self.i16(b)); Val::Int(self.b.ins().imul(a, b)) }
            Op::NegI16Wide => { let a = self.i16(a); Val::Int(self.b.ins().ineg(a)) }
            Op::DivI16Wide => {
                let (a, b) = (self.i16(a), self.i16(b));
                let (zero, divisor) = self.divisor(b);
                let quotient = self.b.ins().sdiv(a, divisor);
                let none = self.b.ins().iconst(I32, 0);
                Val::Int(self.b.ins().select(zero, none, quotient))
            }
            Op::DivI16Pair => {
                let (a, b, old) = (self.i16(a), self.i16(b), self.int(c));
                let (zero, divisor) = self.divisor(b);
                let quotient = self.b.ins().sdiv(a, divisor);
                let rest = self.b.ins().srem(a, divisor);
                let rest = self.b.ins().ishl_imm_u(rest, 16);
                let quotient = self.b.ins().band_imm_u(quotient, 0xFFFF);
                let pair = self.b.ins().bor(rest, quotient);
                Val::Int(self.b.ins().select(zero, old, pair))
            }
            Op::OverflowsI16 => { let exact = self.int(a); let low = self.i16(a); self.compare(IntCC::NotEqual, Val::Int(exact), Val::Int(low)) }
            Op::PositiveI16 => { let a = self.i16(a); self.compare(IntCC::SignedGreaterThan, Val::Int(a), Val::Const(0)) }
            Op::NegativeI16 => { let a = self.i16(a); self.compare(IntCC::SignedLessThan, Val::Int(a), Val::Const(0)) }
            Op::AddU32 => { let (a, b) = (self.int(a), self.int(b)); Val::Int(self.b.ins().iadd(a, b)) }
            Op::SubU32 => { let (a, b) = (self.int(a), self.int(b)); Val::Int(self.b.ins().isub(a, b)) }
            Op::AddI32Wide => { let (a, b) = (self.i64(a), self.i64(b)); Val::Word(self.b.ins().iadd(a, b)) }
            Op::SubI32Wide => { let (a, b) = (self.i64(a), self.i64(b)); Val::Word(self.b.ins().isub(a, b)) }
            Op::MulI32Wide => { let (a, b) = (self.i64(a), self.i64(b)); Val::Word(self.b.ins().imul(a, b)) }
            Op::NegI32Wide => { let a = self.i64(a); Val::Word(self.b.ins().ineg(a)) }
            Op::DivI32Wide | Op::RemI32Wide => {
                let (a, b) = (self.i64(a), self.i64(b));
                let (zero, divisor) = self.divisor(b);
                let result = if op == Op::DivI32Wide { self.b.ins().sdiv(a, divisor) } else { self.b.ins().srem(a, divisor) };
                let none = self.b.ins().iconst(I64, 0);
                Val::Word(self.b.ins().select(zero, none, result))
            }
            Op::Low32 => self.low_32(a),
            Op::OverflowsI32 => { let exact = self.word(a); let low = self.i64(a); self.compare(IntCC::NotEqual, Val::Word(exact), Val::Word(low)) }
            Op::PositiveI32 => { let a = self.int(a); self.compare(IntCC::SignedGreaterThan, Val::Int(a), Val::Const(0)) }
            Op::NegativeI32 => { let a = self.int(a); self.compare(IntCC::SignedLessThan, Val::Int(a), Val::Const(0)) }
            Op::PositiveI64 => { let a = self.word(a); self.compare(IntCC::SignedGreaterThan, Val::Word(a), Val::Const(0)) }
            Op::NegativeI64 => { let a = self.word(a); self.compare(IntCC::SignedLessThan, Val::Word(a), Val::Const(0)) }
            Op::Decrement16 => { let a = self.int(a); let less = self.b.ins().iadd_imm_s(a, -1); Val::Int(self.b.ins().band_imm_u(less, 0xFFFF)) }

            // Comparison.
            Op::EqI16 => self.compare_i16(IntCC::Equal, a, b),
            Op::NeI16 => self.compare_i16(IntCC::NotEqual, a, b),
            Op::LtI16 => self.compare_i16(IntCC::SignedLessThan, a, b),
            Op::LeI16 => self.compare_i16(IntCC::SignedLessThanOrEqual, a, b),
            Op::GtI16 => self.compare_i16(IntCC::SignedGreaterThan, a, b),
            Op::GeI16 => self.compare_i16(IntCC::SignedGreaterThanOrEqual, a, b),
            Op::EqI32 => self.compare_i32(IntCC::Equal, a, b),
            Op::NeI32 => self.compare_i32(IntCC::NotEqual, a, b),
            Op::LtI32 => self.compare_i32(IntCC::SignedLessThan, a, b),
            Op::LeI32 => self.compare_i32(IntCC::SignedLessThanOrEqual, a, b),
            Op::GtI32 => self.compare_i32(IntCC::SignedGreaterThan, a, b),
            Op::GeI32 => self.compare_i32(IntCC::SignedGreaterThanOrEqual, a, b),
            Op::EqF32 => self.compare_f32(FloatCC::Equal, a, b),
            Op::NeF32 => self.compare_f32(FloatCC::OrderedNotEqual, a, b),
            Op::LtF32 => self.compare_f32(FloatCC::LessThan, a, b),
            Op::LeF32 => self.compare_f32(FloatCC::LessThanOrEqual, a, b),
            Op::GtF32 => self.compare_f32(FloatCC::GreaterThan, a, b),
            Op::GeF32 => self.compare_f32(FloatCC::GreaterThanOrEqual, a, b),
            Op::UnorderedF32 => self.compare_f32(FloatCC::Unordered, a, b),

            // REAL.
            Op::AddF32 => { let (a, b) = (self.f32(a), self.f32(b)); let result = self.b.ins().fadd(a, b); self.quiet(result) }
            Op::SubF32 => { let (a, b) = (self.f32(a), self.f32(b)); let result = self.b.ins().fsub(a, b); self.quiet(result) }
            Op::MulF32 => { let (a, b) = (self.f32(a), self.f32(b)); let result = self.b.ins().fmul(a, b); self.quiet(result) }
            Op::DivF32 if let Some(factor) = factor_f32(b) => self.compute_now(Op::MulF32, &[a, factor]),
            Op::DivF32 => { let (a, b) = (self.f32(a), self.f32(b)); let result = self.b.ins().fdiv(a, b); self.quiet(result) }
            Op::SqrF32 => { let a = self.f32(a); let result = self.b.ins().fmul(a, a); self.quiet(result) }
            // Through f64 and rounded, the root is the same: f64 has more than twice the digits.
            Op::MinF32 => { let (x, y) = (self.f32(a), self.f32(b)); let real = self.extreme_real(FloatCC::LessThan, [x, y], (y, x), is_f32(b)); self.quiet(real) }
            Op::MaxF32 => { let (x, y) = (self.f32(a), self.f32(b)); let real = self.extreme_real(FloatCC::GreaterThan, [y, x], (x, y), is_f32(a)); self.quiet(real) }
            Op::SqrtF32 => { let a = self.f32(a); let result = self.b.ins().sqrt(a); self.quiet(result) }
            // A denormal value counts as 0, and no number as greater and less.
            Op::RealCc1 => { let a = self.f32(a); let least = self.b.ins().f32const(f32::MIN_POSITIVE); self.float_flag(FloatCC::UnorderedOrGreaterThanOrEqual, a, least) }
            Op::RealCc0 => { let a = self.f32(a); let least = self.b.ins().f32const(-f32::MIN_POSITIVE); self.float_flag(FloatCC::UnorderedOrLessThanOrEqual, a, least) }
            Op::RealOverflow => {
                let a = self.int(a);
                let magnitude = self.b.ins().band_imm_u(a, 0x7FFF_FFFF);
                let infinite = self.compare(IntCC::UnsignedGreaterThanOrEqual, Val::Int(magnitude), Val::Const(0x7F80_0000));
                let less = self.b.ins().iadd_imm_s(magnitude, -1);
                let denormal = self.compare(IntCC::UnsignedLessThan, Val::Int(less), Val::Const(0x007F_FFFF));
                self.or(infinite, denormal)
            }
            Op::NegF32 => { let bits = self.int(a); let bits = self.b.ins().bxor_imm_u(bits, 0x8000_0000); self.with_real(a, bits, |b, real| b.ins().fneg(real)) }
            Op::AbsF32 => { let bits = self.int(a); let bits = self.b.ins().band_imm_u(bits, 0x7FFF_FFFF); self.with_real(a, bits, |b, real| b.ins().fabs(real)) }
            Op::I32ToF32 => { let a = self.int(a); let real = self.b.ins().fcvt_from_sint(F32, a); self.bits_f32(real) }
            Op::Swap16 => {
                let a = self.int(a);
                let low = self.b.ins().ireduce(I16, a);
                let swapped = self.b.ins().bswap(low);
                let swapped = self.b.ins().uextend(I32, swapped);
                let high = self.b.ins().band_imm_u(a, 0xFFFF_0000);
                Val::Int(self.b.ins().bor(high, swapped))
            }
            Op::Swap32 => { let a = self.int(a); Val::Int(self.b.ins().bswap(a)) }

            // Word logic, and shifts by a constant that move something.
            Op::AndU32 => self.and_u32(a, b),
            Op::OrU32 => { let most = self.most_bits(a).max(self.most_bits(b)); let (a, b) = (self.int(a), self.int(b)); let result = self.b.ins().bor(a, b); self.know_bits(result, most) }
            Op::XorU32 => { let most = self.most_bits(a).max(self.most_bits(b)); let (a, b) = (self.int(a), self.int(b)); let result = self.b.ins().bxor(a, b); self.know_bits(result, most) }
            Op::Shl16 if let Some(n) = count(b, 15) => { let a = self.int(a); let moved = self.b.ins().ishl_imm_u(a, n); Val::Int(self.b.ins().band_imm_u(moved, 0xFFFF)) }
            Op::Shr16 if let Some(n) = count(b, 15) => { let low = self.low_bits(a, Width::Word); let most = self.most_bits(Val::Int(low)); let moved = self.b.ins().ushr_imm_u(low, n); self.know_bits(moved, most.saturating_sub(n as u32)) }
            Op::Sar16 if let Some(n) = count(b, 15) => { let a = self.i16(a); let moved = self.b.ins().sshr_imm_u(a, n); Val::Int(self.b.ins().band_imm_u(moved, 0xFFFF)) }
            Op::Shl32 if let Some(n) = count(b, 31) => { let a = self.int(a); Val::Int(self.b.ins().ishl_imm_u(a, n)) }
            Op::Shr32 if let Some(n) = count(b, 31) => { let a = self.int(a); Val::Int(self.b.ins().ushr_imm_u(a, n)) }
            Op::Sar32 if let Some(n) = count(b, 31) => { let a = self.int(a); Val::Int(self.b.ins().sshr_imm_u(a, n)) }
            Op::Rol32 if let Some(n) = count(b, 255) => { let a = self.int(a); Val::Int(self.b.ins().rotl_imm_u(a, n % 32)) }
            Op::Ror32 if let Some(n) = count(b, 255) => { let a = self.int(a); Val::Int(self.b.ins().rotr_imm_u(a, n % 32)) }
            Op::LowestBit => { let value = self.int(a); Val::Bit { value, clean: false } }
            Op::HighestBit => { let a = self.int(a); Val::Bit { value: self.b.ins().ushr_imm_u(a, 31), clean: true } }
            Op::BitOf if let Some(bit) = b.constant() => self.named_bit(a, (bit & 63) as u8),

            // Pointers and status.
            Op::PassOnPointer => {
                let pointer = self.int(a);
                if self.leads_elsewhere(pointer) {
                    return Some(Val::Int(pointer));
                }
                let calls = self.b.ins().ushr_imm_u(pointer, i64::from(CALLS_SHIFT));
                let calls = self.b.ins().iadd_imm_s(calls, -LOCAL_OF_CALLER);
                let has_room = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, calls, 0x1F);
                let farther = self.b.ins().iadd_imm_u(pointer, 1 << CALLS_SHIFT);
                Val::Int(self.b.ins().select(has_room, farther, pointer))
            }
            Op::AddPointer => {
                let (register, offset) = (self.int(a), self.i16(b));
                let sum = self.b.ins().iadd(register, offset);
                let low = self.b.ins().band_imm_u(sum, 0x00FF_FFFF);
                let high = self.b.ins().band_imm_u(register, 0xFF00_0000);
                Val::Int(self.b.ins().bor(high, low))
            }
            Op::Pack4 => {
                let [b0, b1, b2, b3] = [a, b, c, d].map(|bit| self.flag(bit));
                let b1 = self.b.ins().ishl_imm_u(b1, 1);
                let b2 = self.b.ins().ishl_imm_u(b2, 2);
                let b3 = self.b.ins().ishl_imm_u(b3, 3);
                let low = self.b.ins().bor(b0, b1);
                let high = self.b.ins().bor(b2, b3);
                Val::Int(self.b.ins().bor(low, high))
            }
            Op::Join => { let n = count(c, 31)?; let (low, high) = (self.int(a), self.int(b)); let high = self.b.ins().ishl_imm_u(high, n); Val::Int(self.b.ins().bor(low, high)) }
            _ => return self.inline_sized(op, a, b, c),
        })
    }

    pub(super) fn not(&mut self, a: Val) -> Val {
        match self.force(a) {
            Val::Const(a) => Val::Const(!a & 1),
            // What is around the bit may iteration, too: there is an instruction for `and not`.
            Val::At { value, at } => Val::At { value: self.b.ins().bnot(value), at },
            a if let Some((condition, x, y)) = self.comparison(a) => {
                let opposite = self.b.ins().icmp(condition.complement(), x, y);
                Val::Bit { value: self.b.ins().uextend(I32, opposite), clean: true }
            }
            a if self.is_clean(a) => {
                let (a, one) = (self.bit(a), self.constant(1));
                Val::Bit { value: self.b.ins().bxor(a, one), clean: true }
            }
            a => {
                let a = self.bit(a);
                Val::Bit { value: self.b.ins().bnot(a), clean: false }
            }
        }
    }

    pub(super) fn and(&mut self, a: Val, b: Val) -> Val {
        match (self.force(a), self.force(b)) {
            (Val::Const(bit), other) | (other, Val::Const(bit)) => {
                if bit & 1 != 0 {
                    self.as_bit(other)
                } else {
                    Val::Const(0)
                }
            }
            (a, b) => {
                let clean = self.is_clean(a) || self.is_clean(b);
                let (a, b, at) = self.aligned(a, b);
                let alone = self.is_alone(a, at) || self.is_alone(b, at);
                let value = self.b.ins().band(a, b);
                self.note_alone(value, at, alone);
                Self::bit_value(value, at, clean)
            }
        }
    }

    fn and_not(&mut self, a: Val, b: Val) -> Val {
        match (self.force(a), self.force(b)) {
            (a, Val::Const(bit)) => {
                if bit & 1 != 0 {
                    Val::Const(0)
                } else {
                    self.as_bit(a)
                }
            }
            (Val::Const(bit), b) => {
                if bit & 1 != 0 {
                    self.not(b)
                } else {
                    Val::Const(0)
                }
            }
            (a, b) => {
                let clean = self.is_clean(a);
                let (a, b, at) = self.aligned(a, b);
                let alone = self.is_alone(a, at);
                let value = self.b.ins().band_not(a, b);
                self.note_alone(value, at, alone);
                Self::bit_value(value, at, clean)
            }
        }
    }

    pub(super) fn or(&mut self, a: Val, b: Val) -> Val {
        match (self.force(a), self.force(b)) {
            (Val::Const(bit), other) | (other, Val::Const(bit)) => {
                if bit & 1 != 0 {
                    Val::Const(1)
                } else {
                    self.as_bit(other)
                }
            }
            (a, b) => {
                let clean = self.is_clean(a) && self.is_clean(b);
                let (a, b, at) = self.aligned(a, b);
                let alone = self.is_alone(a, at) && self.is_alone(b, at);
                let value = self.b.ins().bor(a, b);
                self.note_alone(value, at, alone);
                Self::bit_value(value, at, clean)
            }
        }
    }

    pub(super) fn xor(&mut self, a: Val, b: Val) -> Val {
        match (self.force(a), self.force(b)) {
            (Val::Const(bit), other) | (other, Val::Const(bit)) => {
                if bit & 1 != 0 {
                    self.not(other)
                } else {
                    self.as_bit(other)
                }
            }
            (a, b) => {
                let clean = self.is_clean(a) && self.is_clean(b);
                let (a, b, at) = self.aligned(a, b);
                let alone = self.is_alone(a, at) && self.is_alone(b, at);
                let value = self.b.ins().bxor(a, b);
                self.note_alone(value, at, alone);
                Self::bit_value(value, at, clean)
            }
        }
    }

    fn is_clean(&self, value: Val) -> bool {
        matches!(value, Val::Const(_) | Val::Bit { clean: true, .. })
    }

    /// Bit 0 of a value.
    fn as_bit(&mut self, value: Val) -> Val {
        match value {
            Val::Const(value) => Val::Const(value & 1),
            Val::Bit { .. } | Val::At { .. } => value,
            _ => Val::Bit { value: self.bit(value), clean: false },
        }
    }

    pub(super) fn word_of_bit(&mut self, value: Val) -> Value {
        let flag = self.flag(value);
        self.b.ins().uextend(I64, flag)
    }

    /// One of two bits; where the condition is known, the other one is not written.
    pub(super) fn choose_bit(&mut self, condition: Val, a: impl FnOnce(&mut Self) -> Val, b: impl FnOnce(&mut Self) -> Val) -> Val {
        match self.force(condition) {
            Val::Const(condition) => {
                let chosen = if condition & 1 != 0 { a(self) } else { b(self) };
                let chosen = self.force(chosen);
                self.as_bit(chosen)
            }
            condition => {
                let (a, b) = (a(self), b(self));
                let (condition, a, b) = (self.flag(condition), self.bit(a), self.bit(b));
                Val::Bit { value: self.b.ins().select(condition, a, b), clean: false }
            }
        }
    }

    fn choose(&mut self, condition: Val, a: Val, b: Val) -> Val {
        if let Val::Const(condition) = self.force(condition) {
            return if condition & 1 != 0 { a } else { b };
        }
        let condition = self.flag(condition);
        let (a, b) = (self.force(a), self.force(b));
        if let (Val::Const(a), Val::Const(0)) = (a, b)
            && u32::try_from(a).is_ok_and(u32::is_power_of_two)
        {
            let result = self.b.ins().ishl_imm_u(condition, i64::from(a.trailing_zeros()));
            return self.know_bits(result, a.trailing_zeros() + 1);
        }
        if let (Val::Int(a), Val::Const(0)) = (a, b)
            && self.most_bits(Val::Int(a)) == 1
        {
            let result = self.b.ins().band(condition, a);
            return self.know_bits(result, 1);
        }
        if self.is_32_bits(a) && self.is_32_bits(b) {
            let most = self.most_bits(a).max(self.most_bits(b));
            let (a, b) = (self.int(a), self.int(b));
            let result = self.b.ins().select(condition, a, b);
            return self.know_bits(result, most);
        }
        let (a, b) = (self.word(a), self.word(b));
        Val::Word(self.b.ins().select(condition, a, b))
    }

    pub(super) fn is_32_bits(&self, value: Val) -> bool {
        match value {
            Val::Const(value) => u32::try_from(value).is_ok(),
            Val::Int(_) | Val::Bit { .. } | Val::At { .. } | Val::Real { .. } => true,
            Val::Word(_) | Val::Lreal { .. } | Val::Lazy(_) => false,
        }
    }

    /// A comparison of whole values, unsigned unless both are of the same form.
    pub(super) fn compare(&mut self, condition: IntCC, a: Val, b: Val) -> Val {
        let (a, b) = (self.force(a), self.force(b));
        let result = if let Some(result) = self.compares_rest(condition, a, b) {
            result
        } else if self.is_32_bits(a) && self.is_32_bits(b) {
            let a = self.int(a);
            match b {
                Val::Const(b) => self.b.ins().icmp_imm_u(condition, a, b as i64),
                _ => {
                    let b = self.int(b);
                    self.b.ins().icmp(condition, a, b)
                }
            }
        } else {
            let (a, b) = (self.word(a), self.word(b));
            self.b.ins().icmp(condition, a, b)
        };
        Val::Bit { value: self.b.ins().uextend(I32, result), clean: true }
    }

    fn compare_i16(&mut self, condition: IntCC, a: Val, b: Val) -> Val {
        let result = self.compares_rest(condition, a, b).unwrap_or_else(|| {
            let (a, b) = (self.i16(a), self.i16(b));
            self.b.ins().icmp(condition, a, b)
        });
        Val::Bit { value: self.b.ins().uextend(I32, result), clean: true }
    }

    fn compare_i32(&mut self, condition: IntCC, a: Val, b: Val) -> Val {
        let result = self.compares_rest(condition, a, b).unwrap_or_else(|| {
            let (a, b) = (self.int(a), self.int(b));
            self.b.ins().icmp(condition, a, b)
        });
        Val::Bit { value: self.b.ins().uextend(I32, result), clean: true }
    }

    fn compare_f32(&mut self, condition: FloatCC, a: Val, b: Val) -> Val {
        let (a, b) = (self.f32(a), self.f32(b));
        self.float_flag(condition, a, b)
    }

    pub(super) fn float_flag(&mut self, condition: FloatCC, a: Value, b: Value) -> Val {
        let result = self.b.ins().fcmp(condition, a, b);
        Val::Bit { value: self.b.ins().uextend(I32, result), clean: true }
    }

    /// The low word with its sign, in 32 bits.
    pub(super) fn i16(&mut self, value: Val) -> Value {
        if let Val::Const(value) = value {
            return self.b.ins().iconst(I32, i64::from(value as i16 as i32 as u32));
        }
        let value = self.int(value);
        if self.range_of(Val::Int(value)).is_some_and(|(_, most)| most <= 0x7FFF) {
            return value;
        }
        if self.is_product(value) {
            let turned = self.b.ins().rotl_imm_u(value, 16);
            return self.b.ins().sshr_imm_u(turned, 16);
        }
        let dfg = &self.b.func.dfg;
        let read = match dfg.value_def(dfg.resolve_aliases(value)) {
            ValueDef::Result(inst, 0) => match dfg.insts[inst] {
                // What has just been read.
                InstructionData::Unary { opcode: Opcode::Uextend, arg } if dfg.value_type(arg) == I16 => Some(arg),
                _ => None,
            },
            _ => None,
        };
        let low = read.unwrap_or_else(|| self.b.ins().ireduce(I16, value));
        self.b.ins().sextend(I32, low)
    }

    /// The low 32 bits with their sign, in 64 bits.
    pub(super) fn i64(&mut self, value: Val) -> Value {
        if let Val::Const(value) = value {
            return self.b.ins().iconst(I64, i64::from(value as i32));
        }
        let value = self.int(value);
        self.b.ins().sextend(I64, value)
    }

    pub(super) fn f32(&mut self, value: Val) -> Value {
        let value = match self.force(value) {
            Val::Real { real, .. } => return real,
            Val::Const(bits) => return self.b.ins().f32const(Ieee32::with_bits(bits as u32)),
            value => self.int(value),
        };
        self.b.ins().bitcast(F32, MemFlagsData::new(), value)
    }

    /// A result; what is no number becomes the one NaN that the project shows.
    pub(super) fn quiet(&mut self, real: Value) -> Val {
        let none = self.b.ins().fcmp(FloatCC::Unordered, real, real);
        let bits = self.b.ins().bitcast(I32, MemFlagsData::new(), real);
        let nan = self.b.ins().iconst(I32, i64::from(f32::NAN.to_bits()));
        Val::Real { real, bits: self.b.ins().select(none, nan, bits) }
    }

    /// Bits that were made of those of a value, and the REAL that is made of it in the same way, if it is one: nothing waits for the bits
    /// then.
    fn with_real(&mut self, of: Val, bits: Value, make: impl FnOnce(&mut FunctionBuilder<'_>, Value) -> Value) -> Val {
        match of {
            Val::Real { real, .. } => Val::Real { real: make(&mut self.b, real), bits },
            _ => Val::Int(bits),
        }
    }

    /// The first of two reals where it is less or greater than the second one, the second one otherwise; where a third one is no number, a
    /// fourth one, unless it is known to be one.
    pub(super) fn extreme_real(
        &mut self,
        condition: FloatCC,
        [a, b]: [Value; 2],
        (third, fourth): (Value, Value),
        is_number: bool,
    ) -> Value {
        let first = self.is_extreme(condition, [a, b]);
        let extreme = self.b.ins().select(first, a, b);
        if is_number {
            return extreme;
        }
        // Hardly ever, so that a jump costs less than a choice.
        let none = self.b.ins().fcmp(FloatCC::Unordered, third, third);
        self.b.ins().select(none, fourth, extreme)
    }

    /// Whether the first of two reals is less or greater, in the form that becomes one instruction with the choice behind it.
    pub(super) fn is_extreme(&mut self, condition: FloatCC, [a, b]: [Value; 2]) -> Value {
        match condition {
            FloatCC::GreaterThan => self.b.ins().fcmp(FloatCC::LessThan, b, a),
            condition => self.b.ins().fcmp(condition, a, b),
        }
    }

    fn merge(&mut self, high: Val, low: Val, mask: u32) -> Val {
        let low = match low {
            Val::Const(low) => Val::Const(low & u64::from(mask)),
            low => {
                let low = self.int(low);
                let fits = self.narrow.get(&low).is_some_and(|&bits| bits < 32 && u64::from(mask) >= (1 << bits) - 1);
                Val::Int(if fits { low } else { self.b.ins().band_imm_u(low, i64::from(mask)) })
            }
        };
        let no_high = match high {
            Val::Const(high) => high as u32 & !mask == 0,
            Val::Int(high) => self.narrow.get(&high).is_some_and(|&bits| bits < 32 && u64::from(mask) >= (1 << bits) - 1),
            _ => false,
        };
        if no_high {
            return low;
        }
        let (high, low) = (self.int(high), self.int(low));
        let high = self.b.ins().band_imm_u(high, i64::from(!mask));
        Val::Int(self.b.ins().bor(high, low))
    }

    /// How many low bits of 32 may be 1.
    pub(super) fn most_bits(&self, value: Val) -> u32 {
        match value {
            Val::Const(value) => 32 - (value as u32).leading_zeros(),
            Val::Int(value) => self.narrow.get(&value).copied().unwrap_or(32),
            _ => 32,
        }
    }

    /// How many low bits of a value may be 1; 64 where that is not known to be less.
    pub(super) fn bits_used(&self, value: Val) -> u32 {
        let bits = |most: u64| 64 - most.leading_zeros();
        match value {
            Val::Const(value) => bits(value),
            Val::Int(number) => {
                let ranged = self.range_of(value).map(|(_, most)| bits(most.into()));
                let masked = match self.definition(number) {
                    Some((_, InstructionData::Binary { opcode: Opcode::Band, args: [_, mask] })) => {
                        self.iconst(mask).map(|mask| bits(mask.into()))
                    }
                    _ => None,
                };
                ranged.into_iter().chain(masked).fold(self.most_bits(value), u32::min)
            }
            _ => 64,
        }
    }

    /// A result in 32 bits of which no more low bits than these may be 1.
    pub(super) fn know_bits(&mut self, result: Value, most: u32) -> Val {
        if self.options.optimize && most <= 16 {
            self.narrow.insert(result, most);
        }
        Val::Int(result)
    }

    fn and_u32(&mut self, a: Val, b: Val) -> Val {
        let most = self.most_bits(a).min(self.most_bits(b));
        let (a, b) = (self.int(a), self.int(b));
        let result = self.b.ins().band(a, b);
        self.know_bits(result, most)
    }

    /// The low half of 64 bits; of a sum it is the sum of the low halves.
    fn low_32(&mut self, value: Val) -> Val {
        let Val::Word(word) = self.force(value) else { return Val::Int(self.int(value)) };
        let low = |this: &Self, value: Value| match this.definition(value) {
            Some((_, InstructionData::Unary { opcode: Opcode::Sextend, arg })) if this.b.func.dfg.value_type(arg) == I32 => Some(Ok(arg)),
            Some((_, InstructionData::UnaryImm { opcode: Opcode::Iconst, imm })) => Some(Err(imm.bits() as u32)),
            _ => None,
        };
        if let Some((_, InstructionData::Binary { opcode: opcode @ (Opcode::Iadd | Opcode::Isub | Opcode::Imul), args })) =
            self.definition(word)
            && let [Some(a), Some(b)] = args.map(|arg| low(self, arg))
        {
            let [a, b] = [a, b].map(|half| half.unwrap_or_else(|constant| self.constant(constant)));
            return Val::Int(match opcode {
                Opcode::Iadd => self.b.ins().iadd(a, b),
                Opcode::Isub => self.b.ins().isub(a, b),
                _ => self.b.ins().imul(a, b),
            });
        }
        Val::Int(self.int(value))
    }

    /// Whether a divisor is 0, and a divisor that never is.
    pub(super) fn divisor(&mut self, divisor: Value) -> (Value, Value) {
        let zero = self.b.ins().icmp_imm_s(IntCC::Equal, divisor, 0);
        let ty = self.b.func.dfg.value_type(divisor);
        let one = self.b.ins().iconst(ty, 1);
        (zero, self.b.ins().select(zero, one, divisor))
    }

    /// RLO behind a closing bracket, from the newest entry of the nesting stack.
    fn nesting_rlo(&mut self, stack: Val, inner: Val) -> Val {
        let stack = self.int(stack);
        let mut field = |from: i64| Val::Bit { value: if from == 0 { stack } else { self.b.ins().ushr_imm_u(stack, from) }, clean: false };
        let [saved, or, fc, inverted, is_or, is_xor] = [0, 1, 2, 4, 5, 6].map(&mut field);
        let bit = self.xor(inner, inverted);
        let saved_and_bit = self.and(saved, bit);
        let both = self.or(saved_and_bit, or);
        let after_and = self.choose_bit(fc, |_| both, |_| bit);
        let kept = self.and(saved, fc);
        let after_or = self.or(kept, bit);
        let after_xor = self.xor(kept, bit);
        let other = self.choose_bit(is_or, |_| after_or, |_| after_and);
        self.choose_bit(is_xor, |_| after_xor, |_| other)
    }
}

/// A constant shift count up to this.
pub(super) fn count(value: Val, most: u64) -> Option<i64> {
    let count = value.constant()? & 0xFF;
    (count <= most).then_some(count as i64)
}

/// Whether a REAL is known to be a number.
fn is_f32(value: Val) -> bool {
    value.constant().is_some_and(|bits| !f32::from_bits(bits as u32).is_nan())
}
