//! Counters.

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::machine::Register;

use super::accumulators::ACCU1;
use super::timers;
pub(crate) use super::timers::with_rlo;
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// `S C n`.
pub(crate) fn set(l: &mut Lowering<'_>, operand: &Operand) {
    let number = l.number(timers::number(operand));
    l.b.intrinsic(Intrinsic::CounterSet, &[number, Register::Rlo.into(), ACCU1]);
    timers::end_of_string(l);
}
