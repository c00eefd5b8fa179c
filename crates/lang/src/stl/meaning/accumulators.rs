//! Accumulator operations.

use sieben_engine::ir::{Op, Var};
use sieben_engine::machine::Register;
use sieben_model::literal::Value;

use super::WRONG_OPERAND;
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// ACCU 1.
pub(crate) const ACCU1: Var = Var(Register::Accu1 as u8);
/// ACCU 2.
pub(crate) const ACCU2: Var = Var(Register::Accu2 as u8);

/// `TAK`.
pub(crate) fn swap(l: &mut Lowering<'_>) {
    let old = l.b.compute(Op::Copy, &[ACCU1]);
    l.b.copy(Register::Accu1, ACCU2);
    l.b.copy(Register::Accu2, old);
}

/// `PUSH`.
pub(crate) fn push(l: &mut Lowering<'_>) {
    if l.four_accumulators() {
        enter(l);
    }
    l.b.copy(Register::Accu2, ACCU1);
}

/// `POP`.
pub(crate) fn pop(l: &mut Lowering<'_>) {
    l.b.copy(Register::Accu1, ACCU2);
    leave(l);
}

/// `ENT`; nothing on a CPU with two accumulators, for which the check reports it.
pub(crate) fn enter(l: &mut Lowering<'_>) {
    if l.four_accumulators() {
        l.b.copy(Register::Accu4, Register::Accu3);
        l.b.copy(Register::Accu3, Register::Accu2);
    }
}

/// `LEAVE`, and what stands behind an operation on two accumulators: a CPU with four moves ACCU 3 and 4 down.
pub(crate) fn leave(l: &mut Lowering<'_>) {
    if l.four_accumulators() {
        l.b.copy(Register::Accu2, Register::Accu3);
        l.b.copy(Register::Accu3, Register::Accu4);
    }
}

/// `INC` and `DEC`: the low byte alone, no carry, no status bit.
pub(crate) fn increment(l: &mut Lowering<'_>, operand: &Operand, op: Op) {
    let Operand::Constant(Value::Int(count)) = operand else { unreachable!("{WRONG_OPERAND}") };
    let count = l.b.constant(u64::from(*count as u8));
    let sum = l.b.compute(op, &[ACCU1, count]);
    l.b.compute_into(Register::Accu1, Op::MergeLow8, &[ACCU1, sum]);
}
