//! Timers.

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::machine::{Register, TimerKind};

use super::WRONG_OPERAND;
use super::accumulators::ACCU1;
use crate::stl::lower::Lowering;
use crate::stl::operands::{NumberOperand, Operand};

/// The number of a timer or counter operand.
pub(crate) fn number(operand: &Operand) -> &NumberOperand {
    match operand {
        Operand::Timer(number) | Operand::Counter(number) => number,
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

/// `SP`, `SE`, `SD`, `SS`, `SF`.
pub(crate) fn start(l: &mut Lowering<'_>, operand: &Operand, kind: TimerKind) {
    let number = l.number(number(operand));
    l.b.intrinsic(Intrinsic::TimerStart(kind), &[number, Register::Rlo.into(), ACCU1]);
    end_of_string(l);
}

/// Everything that a timer or counter does with its number and the RLO alone.
pub(crate) fn with_rlo(l: &mut Lowering<'_>, operand: &Operand, intrinsic: Intrinsic) {
    let number = l.number(number(operand));
    l.b.intrinsic(intrinsic, &[number, Register::Rlo.into()]);
    end_of_string(l);
}

/// Behind a timer or counter instruction the next scan begins a new logic string; RLO and STA stay.
pub(crate) fn end_of_string(l: &mut Lowering<'_>) {
    l.b.set(Register::Or, 0);
    l.b.set(Register::Fc, 0);
}
