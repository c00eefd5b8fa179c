//! Comparisons: ACCU 2 with ACCU 1. No accumulator moves down, even with four.

use sieben_engine::ir::Op;
use sieben_engine::machine::Register;

use super::accumulators::{ACCU1, ACCU2};
use super::bit_logic::status_scan;
use super::integer_math::set_overflow;
use crate::stl::lower::Lowering;
use crate::stl::operands::StatusScan;

/// Comparison of integers: CC 1 = greater, CC 0 = less, OV = 0, OS stays.
pub(crate) fn integer(l: &mut Lowering<'_>, op: Op, greater: Op, less: Op) {
    l.b.compute_into(Register::Cc1, greater, &[ACCU2, ACCU1]);
    l.b.compute_into(Register::Cc0, less, &[ACCU2, ACCU1]);
    l.b.set(Register::Ov, 0);
    result(l, op);
}

/// Comparison of REAL numbers: if either is no number, CC 1 = CC 0 = OV = OS = 1 and the RLO is 0, also for `<>R`.
pub(crate) fn real(l: &mut Lowering<'_>, op: Op) {
    if l.cpu.compares_real_by_difference {
        return real_by_difference(l, op);
    }
    let unordered = l.b.compute(Op::UnorderedF32, &[ACCU2, ACCU1]);
    let greater = l.b.compute(Op::GtF32, &[ACCU2, ACCU1]);
    let less = l.b.compute(Op::LtF32, &[ACCU2, ACCU1]);
    l.b.compute_into(Register::Cc1, Op::Or, &[greater, unordered]);
    l.b.compute_into(Register::Cc0, Op::Or, &[less, unordered]);
    set_overflow(l, unordered);
    result(l, op);
}

/// The same by the condition codes of ACCU 2 minus ACCU 1, as awlsim does it.
fn real_by_difference(l: &mut Lowering<'_>, op: Op) {
    let difference = l.b.compute(Op::SubF32, &[ACCU2, ACCU1]);
    let unordered = l.b.compute(Op::UnorderedF32, &[difference, difference]);
    l.b.compute_into(Register::Cc1, Op::RealCc1, &[difference]);
    l.b.compute_into(Register::Cc0, Op::RealCc0, &[difference]);
    set_overflow(l, unordered);
    let scan = match op {
        Op::EqF32 => StatusScan::Zero,
        Op::NeF32 => StatusScan::NonZero,
        Op::GtF32 => StatusScan::Positive,
        Op::LtF32 => StatusScan::Negative,
        Op::GeF32 => StatusScan::NotNegative,
        Op::LeF32 => StatusScan::NotPositive,
        _ => unreachable!("the rows of REAL comparisons have these six operations"),
    };
    let holds = status_scan(l, scan);
    l.b.copy(Register::Rlo, holds);
    string_goes_on(l);
}

fn result(l: &mut Lowering<'_>, op: Op) {
    l.b.compute_into(Register::Rlo, op, &[ACCU2, ACCU1]);
    string_goes_on(l);
}

/// The comparison is the first scan of a logic string.
fn string_goes_on(l: &mut Lowering<'_>) {
    l.b.copy(Register::Sta, Register::Rlo);
    l.b.set(Register::Or, 0);
    l.b.set(Register::Fc, 1);
}
