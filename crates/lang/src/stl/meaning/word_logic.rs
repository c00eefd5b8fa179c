//! Word logic.

use sieben_engine::ir::Op;
use sieben_engine::machine::Register;

use super::WRONG_OPERAND;
use super::accumulators::{ACCU1, ACCU2};
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// `AW` … `XOD`: CC 1 tells whether the result is not 0. No accumulator moves down, even with four.
pub(crate) fn combine(l: &mut Lowering<'_>, operand: &Operand, op: Op, low_word: bool) {
    let other = match operand {
        Operand::None => ACCU2,
        Operand::Constant(value) => {
            let bits = value.accumulator().unwrap_or_else(|| unreachable!("{WRONG_OPERAND}"));
            l.b.constant(u64::from(bits))
        }
        _ => unreachable!("{WRONG_OPERAND}"),
    };
    let result = l.b.compute(op, &[ACCU1, other]);
    let result = if low_word {
        let low = l.b.compute(Op::Low16, &[result]);
        l.b.compute_into(Register::Accu1, Op::MergeLow16, &[ACCU1, low]);
        low
    } else {
        l.b.copy(Register::Accu1, result);
        result
    };
    l.b.compute_into(Register::Cc1, Op::IsNonzero, &[result]);
    l.b.set(Register::Cc0, 0);
    l.b.set(Register::Ov, 0);
}
