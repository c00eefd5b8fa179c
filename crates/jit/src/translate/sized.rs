//! Instruction selection for operations on numbers of every size: a second part of the list of `instruction_selection.rs`, under the same
//! comparison.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::immediates::Ieee64;
use cranelift_codegen::ir::types::{F32, F64, I8, I16, I32, I64};
use cranelift_codegen::ir::{InstBuilder, InstructionData, MemFlagsData, Opcode, Type, Value, ValueDef};
use sieben_engine::ir::Op;

use super::division_by_constants::factor_f64;
use super::instruction_selection::count;
use super::{Translator, value::Val};

/// How many operations behind a product are followed.
const PRODUCT_DEPTH_MAX: u32 = 6;

/// What is computed with two numbers of one size.
#[derive(Clone, Copy)]
enum BinaryOp {
    Add,
    Subtract,
    Multiply,
}

/// Bits of a number, and how it counts.
#[derive(Clone, Copy)]
enum Size {
    Signed(u32),
    Unsigned(u32),
}

impl Translator<'_> {
    /// The operation as machine code, if it has such a form.
    #[rustfmt::skip] // A table.
    pub(super) fn inline_sized(&mut self, op: Op, a: Val, b: Val, c: Val) -> Option<Val> {
        use Size::{Signed, Unsigned};
        Some(match op {
            Op::AddU8 => self.wrapped(BinaryOp::Add, 8, a, b),
            Op::AddU16 => self.wrapped(BinaryOp::Add, 16, a, b),
            Op::AddU64 => self.wrapped(BinaryOp::Add, 64, a, b),
            Op::SubU8 => self.wrapped(BinaryOp::Subtract, 8, a, b),
            Op::SubU16 => self.wrapped(BinaryOp::Subtract, 16, a, b),
            Op::SubU64 => self.wrapped(BinaryOp::Subtract, 64, a, b),
            Op::MulU8 => self.wrapped(BinaryOp::Multiply, 8, a, b),
            Op::MulU16 => self.wrapped(BinaryOp::Multiply, 16, a, b),
            Op::MulU32 => self.wrapped(BinaryOp::Multiply, 32, a, b),
            Op::MulU64 => self.wrapped(BinaryOp::Multiply, 64, a, b),
            Op::NegI8 => self.wrapped(BinaryOp::Subtract, 8, Val::Const(0), a),
            Op::NegI16 => self.wrapped(BinaryOp::Subtract, 16, Val::Const(0), a),
            Op::NegI32 => self.wrapped(BinaryOp::Subtract, 32, Val::Const(0), a),
            Op::NegI64 => self.wrapped(BinaryOp::Subtract, 64, Val::Const(0), a),
            Op::AbsI8 => self.magnitude(8, a),
            Op::AbsI16 => self.magnitude(16, a),
            Op::AbsI32 => self.magnitude(32, a),
            Op::AbsI64 => self.magnitude(64, a),
            Op::DivI8 => self.quotient(Signed(8), a, b),
            Op::DivI16 => self.quotient(Signed(16), a, b),
            Op::DivI32 => self.quotient(Signed(32), a, b),
            Op::DivI64 => self.quotient(Signed(64), a, b),
            Op::DivU64 => self.quotient(Unsigned(64), a, b),
            Op::RemI8 => self.rest(Signed(8), a, b),
            Op::RemI16 => self.rest(Signed(16), a, b),
            Op::RemI32 => self.rest(Signed(32), a, b),
            Op::RemI64 => self.rest(Signed(64), a, b),
            Op::RemU64 => self.rest(Unsigned(64), a, b),
            Op::MinI8 => self.extreme(Signed(8), IntCC::SignedLessThan, a, b),
            Op::MinI16 => self.extreme(Signed(16), IntCC::SignedLessThan, a, b),
            Op::MinI32 => self.extreme(Signed(32), IntCC::SignedLessThan, a, b),
            Op::MinI64 => self.extreme(Signed(64), IntCC::SignedLessThan, a, b),
            Op::MaxI8 => self.extreme(Signed(8), IntCC::SignedGreaterThan, a, b),
            Op::MaxI16 => self.extreme(Signed(16), IntCC::SignedGreaterThan, a, b),
            Op::MaxI32 => self.extreme(Signed(32), IntCC::SignedGreaterThan, a, b),
            Op::MaxI64 if b == Val::Const(0) && self.bits_used(a) < 64 => a,
            Op::MaxI64 => self.extreme(Signed(64), IntCC::SignedGreaterThan, a, b),
            Op::MinU64 => self.extreme(Unsigned(64), IntCC::UnsignedLessThan, a, b),
            Op::MaxU64 => self.extreme(Unsigned(64), IntCC::UnsignedGreaterThan, a, b),

            // Comparison.
            Op::Differ => self.compare(IntCC::NotEqual, a, b),
            Op::LeU64 => self.compare(IntCC::UnsignedLessThanOrEqual, a, b),
            Op::GtU64 => self.compare(IntCC::UnsignedGreaterThan, a, b),
            Op::GeU64 => self.compare(IntCC::UnsignedGreaterThanOrEqual, a, b),
            Op::LtI8 => self.compare_signed(IntCC::SignedLessThan, 8, a, b),
            Op::LeI8 => self.compare_signed(IntCC::SignedLessThanOrEqual, 8, a, b),
            Op::GtI8 => self.compare_signed(IntCC::SignedGreaterThan, 8, a, b),
            Op::GeI8 => self.compare_signed(IntCC::SignedGreaterThanOrEqual, 8, a, b),
            Op::LtI64 => self.compare_signed(IntCC::SignedLessThan, 64, a, b),
            Op::LeI64 => self.compare_signed(IntCC::SignedLessThanOrEqual, 64, a, b),
            Op::GtI64 => self.compare_signed(IntCC::SignedGreaterThan, 64, a, b),
            Op::GeI64 => self.compare_signed(IntCC::SignedGreaterThanOrEqual, 64, a, b),

            // What was lost. With 64 bits it is computed where it is asked for, which is rare.
            Op::AddOverflowsI8 => self.lost(BinaryOp::Add, Signed(8), a, b),
            Op::AddOverflowsI16 => self.lost(BinaryOp::Add, Signed(16), a, b),
            Op::AddOverflowsI32 => self.lost(BinaryOp::Add, Signed(32), a, b),
            Op::AddOverflowsU8 => self.lost(BinaryOp::Add, Unsigned(8), a, b),
            Op::AddOverflowsU16 => self.lost(BinaryOp::Add, Unsigned(16), a, b),
            Op::AddOverflowsU32 => self.lost(BinaryOp::Add, Unsigned(32), a, b),
            Op::SubOverflowsI8 => self.lost(BinaryOp::Subtract, Signed(8), a, b),
            Op::SubOverflowsI16 => self.lost(BinaryOp::Subtract, Signed(16), a, b),
            Op::SubOverflowsI32 => self.lost(BinaryOp::Subtract, Signed(32), a, b),
            Op::SubOverflowsU8 => self.lost(BinaryOp::Subtract, Unsigned(8), a, b),
            Op::SubOverflowsU16 => self.lost(BinaryOp::Subtract, Unsigned(16), a, b),
            Op::SubOverflowsU32 => self.lost(BinaryOp::Subtract, Unsigned(32), a, b),
            Op::MulOverflowsI8 => self.lost(BinaryOp::Multiply, Signed(8), a, b),
            Op::MulOverflowsI16 => self.lost(BinaryOp::Multiply, Signed(16), a, b),
            Op::MulOverflowsI32 => self.lost(BinaryOp::Multiply, Signed(32), a, b),
            Op::MulOverflowsU8 => self.lost(BinaryOp::Multiply, Unsigned(8), a, b),
            Op::MulOverflowsU16 => self.lost(BinaryOp::Multiply, Unsigned(16), a, b),
            Op::MulOverflowsU32 => self.lost(BinaryOp::Multiply, Unsigned(32), a, b),
            Op::AddOverflowsI64 => { let (a, b) = (self.word(a), self.word(b)); let sum = self.b.ins().iadd(a, b); self.both_differ([a, sum], [b, sum]) }
            Op::SubOverflowsI64 => { let (a, b) = (self.word(a), self.word(b)); let rest = self.b.ins().isub(a, b); self.both_differ([a, b], [a, rest]) }
            Op::AddOverflowsU64 => { let (a, b) = (self.word(a), self.word(b)); let sum = self.b.ins().iadd(a, b); self.compare(IntCC::UnsignedLessThan, Val::Word(sum), Val::Word(a)) }
            Op::SubOverflowsU64 => { let (a, b) = (self.word(a), self.word(b)); self.compare(IntCC::UnsignedLessThan, Val::Word(a), Val::Word(b)) }
            Op::MulOverflowsU64 => { let (a, b) = (self.word(a), self.word(b)); let high = self.b.ins().umulhi(a, b); self.compare(IntCC::NotEqual, Val::Word(high), Val::Const(0)) }
            Op::MulOverflowsI64 => {
                let (a, b) = (self.word(a), self.word(b));
                let (high, low) = (self.b.ins().smulhi(a, b), self.b.ins().imul(a, b));
                let sign = self.b.ins().sshr_imm_u(low, 63);
                self.compare(IntCC::NotEqual, Val::Word(high), Val::Word(sign))
            }
            Op::DivFailsI8 => self.no_quotient(8, a, b),
            Op::DivFailsI16 => self.no_quotient(16, a, b),
            Op::DivFailsI32 => self.no_quotient(32, a, b),
            Op::DivFailsI64 => self.no_quotient(64, a, b),
            Op::NegOverflowsI8 => self.is_least(8, a),
            Op::NegOverflowsI16 => self.is_least(16, a),
            Op::NegOverflowsI32 => self.is_least(32, a),
            Op::NegOverflowsI64 => self.is_least(64, a),
            Op::DivisorIsZero => self.compare(IntCC::Equal, b, Val::Const(0)),
            Op::OutsideI64 => {
                let (value, least, most) = (self.word(a), self.word(b), self.word(c));
                let below = self.b.ins().icmp(IntCC::SignedLessThan, value, least);
                let above = self.b.ins().icmp(IntCC::SignedGreaterThan, value, most);
                let either = self.b.ins().bor(below, above);
                Val::Bit { value: self.b.ins().uextend(I32, either), clean: true }
            }
            Op::OutsideF64 => {
                let (value, least, most) = (self.f64(a), self.f64(b), self.f64(c));
                let below = self.float_flag(FloatCC::UnorderedOrLessThan, value, least);
                let above = self.float_flag(FloatCC::UnorderedOrGreaterThan, value, most);
                self.or(below, above)
            }

            // Bit strings.
            Op::AndU64 | Op::OrU64 | Op::XorU64 => self.bits_of_both(op, a, b),
            Op::NotU8 => self.inverted(a, 0xFF),
            Op::NotU16 => self.inverted(a, 0xFFFF),
            Op::NotU32 => self.inverted(a, 0xFFFF_FFFF),
            Op::NotU64 => { let a = self.word(a); Val::Word(self.b.ins().bnot(a)) }
            Op::Shl8 if let Some(n) = count(b, 7) => { let a = self.int(a); let moved = self.b.ins().ishl_imm_u(a, n); self.cut(8, moved) }
            Op::Shr8 if let Some(n) = count(b, 7) => { let a = self.int(a); let low = self.b.ins().band_imm_u(a, 0xFF); Val::Int(self.b.ins().ushr_imm_u(low, n)) }
            Op::Sar8 if let Some(n) = count(b, 7) => { let a = self.signed(8, a); let moved = self.b.ins().sshr_imm_u(a, n); self.cut(8, moved) }
            Op::Shl64 if let Some(n) = count(b, 63) => { let a = self.word(a); Val::Word(self.b.ins().ishl_imm_u(a, n)) }
            Op::Shr64 if let Some(n) = count(b, 63) => { let a = self.word(a); Val::Word(self.b.ins().ushr_imm_u(a, n)) }
            Op::Sar64 if let Some(n) = count(b, 63) => { let a = self.word(a); Val::Word(self.b.ins().sshr_imm_u(a, n)) }
            Op::Rol64 if let Some(n) = count(b, 255) => { let a = self.word(a); Val::Word(self.b.ins().rotl_imm_u(a, n % 64)) }
            Op::Ror64 if let Some(n) = count(b, 255) => { let a = self.word(a); Val::Word(self.b.ins().rotr_imm_u(a, n % 64)) }
            Op::Swap64 => { let a = self.word(a); Val::Word(self.b.ins().bswap(a)) }

            // REAL and LREAL.
            Op::DifferF32 => { let (a, b) = (self.f32(a), self.f32(b)); self.float_flag(FloatCC::NotEqual, a, b) }
            Op::AddF64 => { let (a, b) = (self.f64(a), self.f64(b)); let result = self.b.ins().fadd(a, b); self.quiet_f64(result) }
            Op::SubF64 => { let (a, b) = (self.f64(a), self.f64(b)); let result = self.b.ins().fsub(a, b); self.quiet_f64(result) }
            Op::MulF64 => { let (a, b) = (self.f64(a), self.f64(b)); let result = self.b.ins().fmul(a, b); self.quiet_f64(result) }
            Op::DivF64 if let Some(factor) = factor_f64(b) => self.compute_now(Op::MulF64, &[a, factor]),
            Op::DivF64 => { let (a, b) = (self.f64(a), self.f64(b)); let result = self.b.ins().fdiv(a, b); self.quiet_f64(result) }
            Op::SqrtF64 => { let a = self.f64(a); let result = self.b.ins().sqrt(a); self.quiet_f64(result) }
            Op::NegF64 => { let a = self.word(a); let sign = self.b.ins().iconst(I64, i64::MIN); Val::Word(self.b.ins().bxor(a, sign)) }
            Op::AbsF64 => { let a = self.word(a); let rest = self.b.ins().iconst(I64, i64::MAX); Val::Word(self.b.ins().band(a, rest)) }
            Op::EqF64 => self.compare_f64(FloatCC::Equal, a, b),
            Op::DifferF64 => self.compare_f64(FloatCC::NotEqual, a, b),
            Op::LtF64 => self.compare_f64(FloatCC::LessThan, a, b),
            Op::LeF64 => self.compare_f64(FloatCC::LessThanOrEqual, a, b),
            Op::GtF64 => self.compare_f64(FloatCC::GreaterThan, a, b),
            Op::GeF64 => self.compare_f64(FloatCC::GreaterThanOrEqual, a, b),

            Op::MinF64 => { let (x, y) = (self.f64(a), self.f64(b)); let real = self.extreme_real(FloatCC::LessThan, [x, y], (y, x), is_f64(b)); self.quiet_f64(real) }
            Op::MaxF64 => { let (x, y) = (self.f64(a), self.f64(b)); let real = self.extreme_real(FloatCC::GreaterThan, [y, x], (x, y), is_f64(a)); self.quiet_f64(real) }
            Op::RoundF32 => { let a = self.f32(a); let real = self.b.ins().nearest(a); self.quiet(real) }
            Op::CeilF32 => { let a = self.f32(a); let real = self.b.ins().ceil(a); self.quiet(real) }
            Op::FloorF32 => { let a = self.f32(a); let real = self.b.ins().floor(a); self.quiet(real) }
            Op::TruncF32 => { let a = self.f32(a); let real = self.b.ins().trunc(a); self.quiet(real) }
            Op::RoundF64 => { let a = self.f64(a); let real = self.b.ins().nearest(a); self.quiet_f64(real) }
            Op::CeilF64 => { let a = self.f64(a); let real = self.b.ins().ceil(a); self.quiet_f64(real) }
            Op::FloorF64 => { let a = self.f64(a); let real = self.b.ins().floor(a); self.quiet_f64(real) }
            Op::TruncF64 => { let a = self.f64(a); let real = self.b.ins().trunc(a); self.quiet_f64(real) }
            Op::OverflowsF32 => { let a = self.int(a); let magnitude = self.b.ins().band_imm_u(a, 0x7FFF_FFFF); self.compare(IntCC::UnsignedGreaterThanOrEqual, Val::Int(magnitude), Val::Const(0x7F80_0000)) }
            Op::OverflowsF64 => {
                let (a, rest) = (self.word(a), self.b.ins().iconst(I64, i64::MAX));
                let magnitude = self.b.ins().band(a, rest);
                self.compare(IntCC::UnsignedGreaterThanOrEqual, Val::Word(magnitude), Val::Const(f64::INFINITY.to_bits()))
            }
            Op::OverflowsF32I32 => {
                let (a, least, most) = (self.f32(a), self.b.ins().f32const(-2_147_483_648.0), self.b.ins().f32const(2_147_483_648.0));
                let below = self.float_flag(FloatCC::UnorderedOrLessThan, a, least);
                let above = self.float_flag(FloatCC::UnorderedOrGreaterThanOrEqual, a, most);
                self.or(below, above)
            }

            // Conversion.
            Op::U64ToF32 => { let a = self.word(a); let real = self.b.ins().fcvt_from_uint(F32, a); self.bits_f32(real) }
            Op::U64ToF64 => { let a = self.word(a); let real = self.b.ins().fcvt_from_uint(F64, a); self.bits_f64(real) }
            Op::ExtendI8I16 => { let a = self.signed(8, a); self.cut(16, a) }
            Op::ExtendI8I32 => Val::Int(self.signed(8, a)),
            Op::ExtendI8I64 if self.bits_used(a) < 8 => a,
            Op::ExtendI16I64 if self.bits_used(a) < 16 => a,
            Op::ExtendI32I64 if self.bits_used(a) < 32 => a,
            Op::ExtendI8I64 => { let a = self.signed(8, a); Val::Word(self.b.ins().sextend(I64, a)) }
            Op::ExtendI16I64 => { let a = self.i16(a); Val::Word(self.b.ins().sextend(I64, a)) }
            Op::ExtendI32I64 => Val::Word(self.i64(a)),
            Op::I32ToF64 => { let a = self.int(a); let real = self.b.ins().fcvt_from_sint(F64, a); self.bits_f64(real) }
            Op::I64ToF64 => { let a = self.word(a); let real = self.b.ins().fcvt_from_sint(F64, a); self.bits_f64(real) }
            Op::I64ToF32 => { let a = self.word(a); let real = self.b.ins().fcvt_from_sint(F32, a); self.bits_f32(real) }
            Op::F32ToF64 => { let a = self.f32(a); let real = self.b.ins().fpromote(F64, a); self.quiet_f64(real) }
            Op::F64ToF32 => { let a = self.f64(a); let real = self.b.ins().fdemote(F32, a); self.quiet(real) }
            Op::F64ToI32 => { let a = self.f64(a); let a = self.to_be_cut(a); Val::Int(self.b.ins().fcvt_to_sint_sat(I32, a)) }
            Op::F64ToI64 => { let a = self.f64(a); let a = self.to_be_cut(a); Val::Word(self.b.ins().fcvt_to_sint_sat(I64, a)) }
            Op::F64ToU32 => { let a = self.f64(a); Val::Int(self.b.ins().fcvt_to_uint_sat(I32, a)) }
            Op::F64ToU64 => { let a = self.f64(a); Val::Word(self.b.ins().fcvt_to_uint_sat(I64, a)) }
            Op::F64ToI16 => { let a = self.f64(a); self.limited(a, -0x8000, 0x7FFF) }
            Op::F64ToI8 => { let a = self.f64(a); self.limited(a, -0x80, 0x7F) }
            Op::F64ToU16 => { let a = self.f64(a); self.limited(a, 0, 0xFFFF) }
            Op::F64ToU8 => { let a = self.f64(a); self.limited(a, 0, 0xFF) }
            _ => return self.inline_shift(op, a, b, c),
        })
    }

    /// A number with its sign: in 32 bits, those of 64 in 64.
    pub(super) fn signed(&mut self, bits: u32, value: Val) -> Value {
        match bits {
            8 => {
                let value = self.int(value);
                let low = self.b.ins().ireduce(I8, value);
                self.b.ins().sextend(I32, low)
            }
            16 => self.i16(value),
            32 => self.int(value),
            _ => self.word(value),
        }
    }

    /// A number without sign: in 32 bits, those of 64 in 64.
    pub(super) fn unsigned(&mut self, bits: u32, value: Val) -> Value {
        let value = if bits == 64 { return self.word(value) } else { self.int(value) };
        match bits {
            8 => self.b.ins().band_imm_u(value, 0xFF),
            16 => self.b.ins().band_imm_u(value, 0xFFFF),
            _ => value,
        }
    }

    /// The lowest bits of a result.
    pub(super) fn cut(&mut self, bits: u32, value: Value) -> Val {
        match bits {
            8 => Val::Int(self.b.ins().band_imm_u(value, 0xFF)),
            16 => Val::Int(self.b.ins().band_imm_u(value, 0xFFFF)),
            32 => Val::Int(value),
            _ => Val::Word(value),
        }
    }

    fn two(&mut self, two: BinaryOp, a: Value, b: Value) -> Value {
        match two {
            BinaryOp::Add => self.b.ins().iadd(a, b),
            BinaryOp::Subtract => self.b.ins().isub(a, b),
            BinaryOp::Multiply => self.b.ins().imul(a, b),
        }
    }

    /// The low 16 bits of a number.
    fn low_word(&mut self, value: Value) -> Value {
        if self.is_product(value) {
            let turned = self.b.ins().rotl_imm_u(value, 16);
            let low = self.b.ins().ushr_imm_u(turned, 16);
            return self.b.ins().ireduce(I16, low);
        }
        self.b.ins().ireduce(I16, value)
    }

    /// Whether a number of 32 bits is made of a product with a constant, in a loop whose iterations are written one after the other. Cut to
    /// 16 bits it would be multiplied in a register whose upper half has to be known: that of another variable, which the iteration before
    /// has to end with.
    pub(super) fn is_product(&self, value: Value) -> bool {
        self.in_iterations && self.has_product(value, PRODUCT_DEPTH_MAX)
    }

    fn has_product(&self, value: Value, depth: u32) -> bool {
        let dfg = &self.b.func.dfg;
        let ValueDef::Result(inst, 0) = dfg.value_def(dfg.resolve_aliases(value)) else { return false };
        let has = |value: Value| depth > 0 && self.has_product(value, depth - 1);
        match dfg.insts[inst] {
            InstructionData::Binary { opcode: Opcode::Imul, args: [a, b] } => {
                let factor = self.iconst(b).or_else(|| self.iconst(a));
                factor.is_some_and(|factor| !factor.is_power_of_two()) || has(a) || has(b)
            }
            InstructionData::Binary { opcode: Opcode::Iadd | Opcode::Isub | Opcode::Band | Opcode::Bor | Opcode::Bxor, args: [a, b] } => {
                has(a) || has(b)
            }
            InstructionData::Unary { opcode: Opcode::Ineg | Opcode::Bnot | Opcode::Uextend | Opcode::Sextend | Opcode::Ireduce, arg } => {
                has(arg)
            }
            _ => false,
        }
    }

    fn wrapped(&mut self, two: BinaryOp, bits: u32, a: Val, b: Val) -> Val {
        if let (16, Some(result)) = (bits, self.within_16_bits(two, a, b)) {
            return result;
        }
        if bits == 16 {
            // In 16 bits a chain of operations cuts nothing off in between.
            let [a, b] = [a, b].map(|value| {
                let value = self.int(value);
                self.low_word(value)
            });
            let result = self.two(two, a, b);
            let result = self.b.ins().uextend(I32, result);
            self.narrow.insert(result, 16);
            return Val::Int(result);
        }
        let (a, b) = if bits == 64 { (self.word(a), self.word(b)) } else { (self.int(a), self.int(b)) };
        let result = self.two(two, a, b);
        self.cut(bits, result)
    }

    /// The same of numbers of 16 bits whose ranges say that nothing is cut off: nothing need be put together behind it.
    fn within_16_bits(&mut self, two: BinaryOp, a: Val, b: Val) -> Option<Val> {
        let ((a_least, a_most), (b_least, b_most)) = (self.range_of(a)?, self.range_of(b)?);
        if !self.options.optimize || a_most.max(b_most) > 0xFFFF {
            return None;
        }
        let (two, b, least, most) = match two {
            BinaryOp::Add if a_most + b_most <= 0xFFFF => (two, b, a_least + b_least, a_most + b_most),
            // A constant below 0.
            BinaryOp::Add if b_least == b_most && a_least + b_least > 0xFFFF => {
                let less = 0x1_0000 - b_least;
                (BinaryOp::Subtract, Val::Const(u64::from(less)), a_least - less, a_most - less)
            }
            BinaryOp::Subtract if a_least >= b_most => (two, b, a_least - b_most, a_most - b_least),
            BinaryOp::Multiply if a_most.checked_mul(b_most)? <= 0xFFFF => (two, b, a_least * b_least, a_most * b_most),
            BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply => return None,
        };
        let (a, b) = (self.int(a), self.int(b));
        let result = self.two(two, a, b);
        self.narrow.insert(result, 16);
        self.bounds.insert(result, (least, most));
        Some(Val::Int(result))
    }

    /// Whether a result with at most 32 bits, computed exactly in 64, is not the one that is kept.
    fn lost(&mut self, two: BinaryOp, size: Size, a: Val, b: Val) -> Val {
        let (Size::Signed(bits) | Size::Unsigned(bits)) = size;
        let wide = |translator: &mut Self, value: Val| match size {
            Size::Signed(bits) => {
                let value = translator.signed(bits, value);
                translator.b.ins().sextend(I64, value)
            }
            Size::Unsigned(bits) => {
                let value = translator.unsigned(bits, value);
                translator.b.ins().uextend(I64, value)
            }
        };
        let (a, b) = (wide(self, a), wide(self, b));
        let exact = self.two(two, a, b);
        let low = self.b.ins().ireduce(I32, exact);
        debug_assert!(bits < 64);
        let kept = wide(self, Val::Int(low));
        let differ = self.b.ins().icmp(IntCC::NotEqual, exact, kept);
        Val::Bit { value: self.b.ins().uextend(I32, differ), clean: true }
    }

    fn magnitude(&mut self, bits: u32, a: Val) -> Val {
        let a = self.signed(bits, a);
        let negated = self.b.ins().ineg(a);
        let negative = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, a, 0);
        let result = self.b.ins().select(negative, negated, a);
        self.cut(bits, result)
    }

    /// Operands of a division that the machine cannot refuse: where it would, the divisor is 1. Also whether the divisor was 0.
    fn division(&mut self, size: Size, a: Val, b: Val) -> (Value, Value, Value) {
        let (a, b) = match size {
            Size::Signed(bits) => (self.signed(bits, a), self.signed(bits, b)),
            Size::Unsigned(bits) => (self.unsigned(bits, a), self.unsigned(bits, b)),
        };
        let (zero, divisor) = self.divisor(b);
        (a, divisor, zero)
    }

    fn quotient(&mut self, size: Size, a: Val, b: Val) -> Val {
        let (Size::Signed(bits) | Size::Unsigned(bits)) = size;
        if let (Size::Unsigned(64), true) = (size, self.is_32_bits(a) && self.is_32_bits(b)) {
            return self.quotient(Size::Unsigned(32), a, b);
        }
        if let (Size::Signed(16 | 32), Some(divisor)) = (size, b.constant()) {
            let (a, range) = self.in_range(bits, a);
            if let Some(quotient) = self.quotient_by(a, divisor_of(divisor, bits), range) {
                return self.cut(bits, quotient);
            }
        }
        if let (Size::Signed(32), Some(divisor @ 4..=0x7FFF_FFFF)) = (size, b.constant())
            && divisor.is_power_of_two()
        {
            return Val::Int(self.shifted_quotient(a, divisor));
        }
        if let Size::Signed(32 | 64) = size {
            return self.quotient_of_any(bits, a, b);
        }
        let (a, b, zero) = self.division(size, a, b);
        let result = match size {
            Size::Unsigned(_) => self.b.ins().udiv(a, b),
            Size::Signed(_) => self.b.ins().sdiv(a, b),
        };
        self.zero_if(zero, bits, result)
    }

    /// A quotient by a number that may be 0 or −1. By 0 it is 0, and the least number by −1, which has none for the machine, is itself:
    /// both are what multiplication gives.
    fn quotient_of_any(&mut self, bits: u32, a: Val, b: Val) -> Val {
        let (a, b) = (self.signed(bits, a), self.signed(bits, b));
        let (special, divisor) = self.divides(b);
        let quotient = self.b.ins().sdiv(a, divisor);
        let product = self.b.ins().imul(a, b);
        let result = self.b.ins().select(special, product, quotient);
        self.cut(bits, result)
    }

    /// A DINT divided by a power of two, towards 0.
    fn shifted_quotient(&mut self, a: Val, divisor: u64) -> Value {
        let a = self.int(a);
        let raised = self.b.ins().iadd_imm_s(a, divisor as i64 - 1);
        let negative = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, a, 0);
        let raised = self.b.ins().select(negative, raised, a);
        self.b.ins().sshr_imm_u(raised, i64::from(divisor.trailing_zeros()))
    }

    fn rest(&mut self, size: Size, a: Val, b: Val) -> Val {
        let rest = self.computed_rest(size, a, b);
        if let (Size::Signed(bits @ (16 | 32)), Some(divisor)) = (size, b.constant()) {
            let (of, _) = self.in_range(bits, a);
            self.note_rest(rest, of, divisor_of(divisor, bits));
        }
        rest
    }

    fn computed_rest(&mut self, size: Size, a: Val, b: Val) -> Val {
        let (Size::Signed(bits) | Size::Unsigned(bits)) = size;
        if let (Size::Unsigned(64), true) = (size, self.is_32_bits(a) && self.is_32_bits(b)) {
            return self.computed_rest(Size::Unsigned(32), a, b);
        }
        if let (Size::Signed(16 | 32), Some(divisor)) = (size, b.constant()) {
            let (a, range) = self.in_range(bits, a);
            if let Some(rest) = self.rest_by(a, divisor_of(divisor, bits), range) {
                return self.cut(bits, rest);
            }
        }
        if let Size::Signed(32 | 64) = size {
            // By 0 nothing remains, as by 1 and by −1.
            let (a, b) = (self.signed(bits, a), self.signed(bits, b));
            let (_, divisor) = self.divides(b);
            let rest = self.b.ins().srem(a, divisor);
            return self.cut(bits, rest);
        }
        let (a, b, zero) = self.division(size, a, b);
        let result = match size {
            Size::Unsigned(_) => self.b.ins().urem(a, b),
            Size::Signed(_) => self.b.ins().srem(a, b),
        };
        self.zero_if(zero, bits, result)
    }

    /// Whether a divisor is 0 or −1, and a divisor that never is.
    fn divides(&mut self, divisor: Value) -> (Value, Value) {
        let above = self.b.ins().iadd_imm_s(divisor, 1);
        let special = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, above, 1);
        let ty = self.b.func.dfg.value_type(divisor);
        let one = self.b.ins().iconst(ty, 1);
        (special, self.b.ins().select(special, one, divisor))
    }

    fn zero_if(&mut self, condition: Value, bits: u32, result: Value) -> Val {
        let ty: Type = self.b.func.dfg.value_type(result);
        let none = self.b.ins().iconst(ty, 0);
        let result = self.b.ins().select(condition, none, result);
        self.cut(bits, result)
    }

    fn no_quotient(&mut self, bits: u32, a: Val, b: Val) -> Val {
        let least = self.is_least(bits, a);
        let b = self.signed(bits, b);
        let zero = self.b.ins().icmp_imm_s(IntCC::Equal, b, 0);
        let zero = Val::Bit { value: self.b.ins().uextend(I32, zero), clean: true };
        let minus = self.b.ins().icmp_imm_s(IntCC::Equal, b, -1);
        let minus = Val::Bit { value: self.b.ins().uextend(I32, minus), clean: true };
        let too_great = self.and(least, minus);
        self.or(zero, too_great)
    }

    fn is_least(&mut self, bits: u32, a: Val) -> Val {
        let a = self.unsigned(bits, a);
        let ty = self.b.func.dfg.value_type(a);
        let least = self.b.ins().iconst(ty, if bits == 64 { i64::MIN } else { 1 << (bits - 1) });
        let least = self.b.ins().icmp(IntCC::Equal, a, least);
        Val::Bit { value: self.b.ins().uextend(I32, least), clean: true }
    }

    /// The operand for which the comparison with the other one holds.
    fn extreme(&mut self, size: Size, condition: IntCC, a: Val, b: Val) -> Val {
        let (bits, a, b) = match size {
            Size::Signed(bits) => (bits, self.signed(bits, a), self.signed(bits, b)),
            Size::Unsigned(_) if self.is_32_bits(a) && self.is_32_bits(b) => (32, self.int(a), self.int(b)),
            Size::Unsigned(bits) => (bits, self.unsigned(bits, a), self.unsigned(bits, b)),
        };
        let first = self.b.ins().icmp(condition, a, b);
        let result = self.b.ins().select(first, a, b);
        self.cut(bits, result)
    }

    fn compare_signed(&mut self, condition: IntCC, bits: u32, a: Val, b: Val) -> Val {
        let (a, b) = (self.signed(bits, a), self.signed(bits, b));
        let result = self.b.ins().icmp(condition, a, b);
        Val::Bit { value: self.b.ins().uextend(I32, result), clean: true }
    }

    fn bits_of_both(&mut self, op: Op, a: Val, b: Val) -> Val {
        let (a, b) = (self.force(a), self.force(b));
        let narrow = self.is_32_bits(a) && self.is_32_bits(b);
        let [most, other] = [a, b].map(|value| self.most_bits(value));
        let most = if op == Op::AndU64 { most.min(other) } else { most.max(other) };
        let (a, b) = if narrow { (self.int(a), self.int(b)) } else { (self.word(a), self.word(b)) };
        let result = match op {
            Op::AndU64 => self.b.ins().band(a, b),
            Op::OrU64 => self.b.ins().bor(a, b),
            _ => self.b.ins().bxor(a, b),
        };
        if narrow { self.know_bits(result, most) } else { Val::Word(result) }
    }

    fn inverted(&mut self, a: Val, mask: i64) -> Val {
        let a = self.int(a);
        let low = self.b.ins().band_imm_u(a, mask);
        Val::Int(self.b.ins().bxor_imm_u(low, mask))
    }

    pub(super) fn f64(&mut self, value: Val) -> Value {
        let value = match self.force(value) {
            Val::Lreal { real, .. } => return real,
            Val::Const(bits) => return self.b.ins().f64const(Ieee64::with_bits(bits)),
            value => self.word(value),
        };
        self.b.ins().bitcast(F64, MemFlagsData::new(), value)
    }

    fn bits_f64(&mut self, real: Value) -> Val {
        Val::Lreal { real, bits: self.b.ins().bitcast(I64, MemFlagsData::new(), real) }
    }

    pub(super) fn bits_f32(&mut self, real: Value) -> Val {
        Val::Real { real, bits: self.b.ins().bitcast(I32, MemFlagsData::new(), real) }
    }

    /// Whether the numbers of both pairs have different signs.
    fn both_differ(&mut self, one: [Value; 2], other: [Value; 2]) -> Val {
        let [one, other] = [one, other].map(|[a, b]| self.b.ins().bxor(a, b));
        let both = self.b.ins().band(one, other);
        let both = self.b.ins().ushr_imm_u(both, 63);
        Val::Bit { value: self.b.ins().ireduce(I32, both), clean: true }
    }

    /// The one NaN that the project shows.
    pub(super) fn quiet_f64(&mut self, real: Value) -> Val {
        let none = self.b.ins().fcmp(FloatCC::Unordered, real, real);
        let bits = self.b.ins().bitcast(I64, MemFlagsData::new(), real);
        let nan = self.b.ins().iconst(I64, f64::NAN.to_bits() as i64);
        Val::Lreal { real, bits: self.b.ins().select(none, nan, bits) }
    }

    /// A REAL or LREAL of which only what lies before its point counts: what has cut it before, or made it longer, is not needed.
    fn to_be_cut(&self, mut real: Value) -> Value {
        let dfg = &self.b.func.dfg;
        let mut wanted = [Opcode::Trunc, Opcode::Fpromote, Opcode::Trunc].into_iter();
        while let ValueDef::Result(inst, 0) = dfg.value_def(dfg.resolve_aliases(real))
            && let InstructionData::Unary { opcode, arg } = dfg.insts[inst]
            && wanted.any(|wanted| wanted == opcode)
        {
            real = arg;
        }
        real
    }

    fn compare_f64(&mut self, condition: FloatCC, a: Val, b: Val) -> Val {
        let (a, b) = (self.f64(a), self.f64(b));
        self.float_flag(condition, a, b)
    }

    /// An LREAL cut to an integer of at most 16 bits.
    fn limited(&mut self, real: Value, least: i64, most: i64) -> Val {
        let value = self.b.ins().fcvt_to_sint_sat(I32, real);
        let least_value = self.b.ins().iconst(I32, least & 0xFFFF_FFFF);
        let most_value = self.b.ins().iconst(I32, most);
        let above = self.b.ins().icmp(IntCC::SignedGreaterThan, value, least_value);
        let value = self.b.ins().select(above, value, least_value);
        let below = self.b.ins().icmp(IntCC::SignedLessThan, value, most_value);
        let value = self.b.ins().select(below, value, most_value);
        self.cut(if most <= 0xFF { 8 } else { 16 }, value)
    }
}

/// Whether an LREAL is known to be a number.
fn is_f64(value: Val) -> bool {
    value.constant().is_some_and(|bits| !f64::from_bits(bits).is_nan())
}

/// A constant divisor without sign: negative ones are greater than all that have one.
fn divisor_of(divisor: u64, bits: u32) -> u32 {
    if bits == 16 { i32::from(divisor as u16 as i16) as u32 } else { divisor as u32 }
}
