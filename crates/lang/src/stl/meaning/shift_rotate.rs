//! Shift and rotate. A count of 0 changes nothing, no status bit either.

use sieben_engine::ir::{Inst, Op, Var};
use sieben_engine::machine::Register;
use sieben_model::literal::Value;

use super::WRONG_OPERAND;
use super::accumulators::{ACCU1, ACCU2};
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// The count: a constant, or the low byte of ACCU 2; `None` for a constant 0.
fn count(l: &mut Lowering<'_>, operand: &Operand) -> Option<Var> {
    match operand {
        Operand::Constant(Value::Int(0)) => None,
        Operand::Constant(Value::Int(count)) => Some(l.b.constant(u64::from(*count as u8))),
        Operand::None => {
            let count = l.b.compute(Op::Low8, &[ACCU2]);
            let zero = l.b.constant(0);
            let nothing = l.b.compute(Op::Equal, &[count, zero]);
            let to = l.b.next();
            l.b.push(Inst::Branch { condition: nothing, to });
            Some(count)
        }
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

/// CC 1 is the bit moved out last; CC 0 and OV are 0; OS stays.
fn status(l: &mut Lowering<'_>, out: Var) {
    l.b.copy(Register::Cc1, out);
    l.b.set(Register::Cc0, 0);
    l.b.set(Register::Ov, 0);
}

/// `SSI`, `SSD`, `SLW`, `SRW`, `SLD`, `SRD`.
pub(crate) fn shift(l: &mut Lowering<'_>, operand: &Operand, op: Op, out: Op, low_word: bool) {
    let Some(count) = count(l, operand) else { return };
    let out = l.b.compute(out, &[ACCU1, count]);
    let result = l.b.compute(op, &[ACCU1, count]);
    if low_word {
        l.b.compute_into(Register::Accu1, Op::MergeLow16, &[ACCU1, result]);
    } else {
        l.b.copy(Register::Accu1, result);
    }
    status(l, out);
}

/// `RLD`, `RRD`: CC 1 is the bit that came round last.
pub(crate) fn rotate(l: &mut Lowering<'_>, operand: &Operand, op: Op, out: Op) {
    let Some(count) = count(l, operand) else { return };
    l.b.compute_into(Register::Accu1, op, &[ACCU1, count]);
    let out = l.b.compute(out, &[ACCU1]);
    status(l, out);
}

/// `RLDA`, `RRDA`: a ring of 33 bits.
pub(crate) fn rotate_through_cc1(l: &mut Lowering<'_>, op: Op, out: Op) {
    let out = l.b.compute(out, &[ACCU1]);
    l.b.compute_into(Register::Accu1, op, &[ACCU1, Register::Cc1.into()]);
    status(l, out);
}
