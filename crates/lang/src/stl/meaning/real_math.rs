//! REAL maths (IEEE 754, single, nearest even). Any result that is no number is 16#7FC0_0000.

use sieben_engine::ir::{Op, Var};
use sieben_engine::machine::Register;

use super::accumulators::{ACCU1, ACCU2, leave};
use super::integer_math::set_overflow;
use crate::stl::lower::Lowering;

/// `+R`, `-R`, `*R`, `/R`.
pub(crate) fn binary(l: &mut Lowering<'_>, op: Op) {
    let result = l.b.compute(op, &[ACCU2, ACCU1]);
    let overflow = match op {
        Op::MulF32 | Op::DivF32 => {
            let quotient = l.b.constant(u64::from(op == Op::DivF32));
            l.b.compute(Op::RealProductOverflow, &[result, ACCU2, ACCU1, quotient])
        }
        _ => l.b.compute(Op::RealOverflow, &[result]),
    };
    l.b.copy(Register::Accu1, result);
    status(l, result, overflow);
    leave(l);
}

/// `SQR`, `SQRT`, `EXP`, `LN` and the trigonometric functions.
pub(crate) fn function(l: &mut Lowering<'_>, op: Op) {
    let result = l.b.compute(op, &[ACCU1]);
    let overflow = match op {
        Op::SqrF32 => {
            let product = l.b.constant(0);
            l.b.compute(Op::RealProductOverflow, &[result, ACCU1, ACCU1, product])
        }
        Op::ExpF32 => l.b.compute(Op::RealExpOverflow, &[result, ACCU1]),
        _ => l.b.compute(Op::RealOverflow, &[result]),
    };
    l.b.copy(Register::Accu1, result);
    status(l, result, overflow);
}

/// `ABS`, `NEGR`: bit 31 alone, no status bit.
pub(crate) fn sign(l: &mut Lowering<'_>, op: Op) {
    l.b.compute_into(Register::Accu1, op, &[ACCU1]);
}

fn status(l: &mut Lowering<'_>, result: Var, overflow: Var) {
    l.b.compute_into(Register::Cc1, Op::RealCc1, &[result]);
    l.b.compute_into(Register::Cc0, Op::RealCc0, &[result]);
    set_overflow(l, overflow);
}
