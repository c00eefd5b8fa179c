//! Integer maths. CC 1, CC 0, OV and OS exist once per number type.

use sieben_engine::ir::{Op, Var};
use sieben_engine::machine::Register;
use sieben_model::literal::Value;

use super::WRONG_OPERAND;
use super::accumulators::{ACCU1, ACCU2, leave};
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// `+ 5`: low word, no status bit.
pub(crate) fn add_constant16(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Constant(Value::Int(value)) = operand else { unreachable!("{WRONG_OPERAND}") };
    let value = l.b.constant(u64::from(*value as u16));
    let sum = l.b.compute(Op::AddU32, &[ACCU1, value]);
    l.b.compute_into(Register::Accu1, Op::MergeLow16, &[ACCU1, sum]);
}

/// `+ L#5`: no status bit.
pub(crate) fn add_constant32(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Constant(Value::DoubleInt(value)) = operand else { unreachable!("{WRONG_OPERAND}") };
    let value = l.b.constant(u64::from(*value as u32));
    l.b.compute_into(Register::Accu1, Op::AddU32, &[ACCU1, value]);
}

/// `+I`, `-I`: CC from the result as it wraps.
pub(crate) fn add16(l: &mut Lowering<'_>, op: Op) {
    let result = l.b.compute(op, &[ACCU2, ACCU1]);
    l.b.compute_into(Register::Accu1, Op::MergeLow16, &[ACCU1, result]);
    status16_wrapped(l, result);
    leave(l);
}

/// `*I`: the whole product in ACCU 1, CC from it, OV if it leaves 16 bits.
pub(crate) fn multiply16(l: &mut Lowering<'_>) {
    let product = l.b.compute(Op::MulI16Wide, &[ACCU2, ACCU1]);
    l.b.copy(Register::Accu1, product);
    l.b.compute_into(Register::Cc1, Op::PositiveI32, &[product]);
    l.b.compute_into(Register::Cc0, Op::NegativeI32, &[product]);
    let overflow = l.b.compute(Op::OverflowsI16, &[product]);
    set_overflow(l, overflow);
    leave(l);
}

/// `/I`: CC from the exact quotient; by 0 CC 1 = CC 0 = OV = 1 and ACCU 1 stays.
pub(crate) fn divide16(l: &mut Lowering<'_>) {
    let divisor = l.b.compute(Op::Low16, &[ACCU1]);
    let quotient = l.b.compute(Op::DivI16Wide, &[ACCU2, ACCU1]);
    let overflow = l.b.compute(Op::OverflowsI16, &[quotient]);
    l.b.compute_into(Register::Accu1, Op::DivI16Pair, &[ACCU2, ACCU1, ACCU1]);
    l.b.compute_into(Register::Cc1, Op::PositiveI32, &[quotient]);
    l.b.compute_into(Register::Cc0, Op::NegativeI32, &[quotient]);
    division_status(l, divisor, overflow);
    leave(l);
}

/// `+D`, `-D`: CC from the result as it wraps.
pub(crate) fn add32(l: &mut Lowering<'_>, op: Op) {
    let result = l.b.compute(op, &[ACCU2, ACCU1]);
    l.b.compute_into(Register::Accu1, Op::Low32, &[result]);
    status32_wrapped(l, result);
    leave(l);
}

/// `*D`: CC from the sign of the exact product.
pub(crate) fn multiply32(l: &mut Lowering<'_>) {
    let product = l.b.compute(Op::MulI32Wide, &[ACCU2, ACCU1]);
    l.b.compute_into(Register::Accu1, Op::Low32, &[product]);
    status32_exact(l, product);
    let overflow = l.b.compute(Op::OverflowsI32, &[product]);
    set_overflow(l, overflow);
    leave(l);
}

/// `/D`, `MOD`.
pub(crate) fn divide32(l: &mut Lowering<'_>, op: Op) {
    let divisor = l.b.compute(Op::Low32, &[ACCU1]);
    let result = l.b.compute(op, &[ACCU2, ACCU1]);
    let overflow = l.b.compute(Op::OverflowsI32, &[result]);
    let low = l.b.compute(Op::Low32, &[result]);
    let divides = l.b.compute(Op::IsNonzero, &[divisor]);
    l.b.compute_into(Register::Accu1, Op::Select, &[divides, low, ACCU1]);
    status32_exact(l, result);
    division_status(l, divisor, overflow);
    leave(l);
}

/// CC 1, CC 0, OV, OS from a 16-bit result that wraps.
pub(crate) fn status16_wrapped(l: &mut Lowering<'_>, wide: Var) {
    l.b.compute_into(Register::Cc1, Op::PositiveI16, &[wide]);
    l.b.compute_into(Register::Cc0, Op::NegativeI16, &[wide]);
    let overflow = l.b.compute(Op::OverflowsI16, &[wide]);
    set_overflow(l, overflow);
}

/// CC 1, CC 0, OV, OS from a 32-bit result that wraps.
pub(crate) fn status32_wrapped(l: &mut Lowering<'_>, wide: Var) {
    l.b.compute_into(Register::Cc1, Op::PositiveI32, &[wide]);
    l.b.compute_into(Register::Cc0, Op::NegativeI32, &[wide]);
    let overflow = l.b.compute(Op::OverflowsI32, &[wide]);
    set_overflow(l, overflow);
}

/// CC 1, CC 0 from the sign of an exact result.
fn status32_exact(l: &mut Lowering<'_>, wide: Var) {
    l.b.compute_into(Register::Cc1, Op::PositiveI64, &[wide]);
    l.b.compute_into(Register::Cc0, Op::NegativeI64, &[wide]);
}

/// OV, and OS if it is 1.
pub(crate) fn set_overflow(l: &mut Lowering<'_>, overflow: Var) {
    l.b.copy(Register::Ov, overflow);
    l.b.compute_into(Register::Os, Op::Or, &[Register::Os.into(), overflow]);
}

/// A division by 0 sets CC 1, CC 0 and OV; the quotient has given CC 1 and CC 0 otherwise.
fn division_status(l: &mut Lowering<'_>, divisor: Var, overflow: Var) {
    let zero = l.b.constant(0);
    let by_zero = l.b.compute(Op::Equal, &[divisor, zero]);
    l.b.compute_into(Register::Cc1, Op::Or, &[Register::Cc1.into(), by_zero]);
    l.b.compute_into(Register::Cc0, Op::Or, &[Register::Cc0.into(), by_zero]);
    let overflow = l.b.compute(Op::Or, &[overflow, by_zero]);
    set_overflow(l, overflow);
}
