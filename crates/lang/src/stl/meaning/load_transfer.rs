//! Load and transfer.

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Inst, OnFault, Op, Var};
use sieben_engine::machine::Register;

use super::WRONG_OPERAND;
use super::accumulators::ACCU1;
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// Status bits that `L STW` and `T STW` move on every CPU, with their bit numbers.
const MOVED_ALWAYS: [(Register, u8); 6] =
    [(Register::Rlo, 1), (Register::Os, 4), (Register::Ov, 5), (Register::Cc0, 6), (Register::Cc1, 7), (Register::Br, 8)];
/// Status bits that only an S7-400 moves.
const MOVED_BY_400: [(Register, u8); 3] = [(Register::Fc, 0), (Register::Sta, 2), (Register::Or, 3)];

/// A new value in ACCU 1, the old one in ACCU 2.
pub(crate) fn into_accumulator(l: &mut Lowering<'_>, value: Var) {
    l.b.copy(Register::Accu2, ACCU1);
    l.b.copy(Register::Accu1, value);
}

/// `L`.
pub(crate) fn load(l: &mut Lowering<'_>, operand: &Operand) {
    match operand {
        Operand::Memory(access) => {
            let place = l.place(&access.location);
            // The pointer of an indirect access may be ACCU-free only: a failed load still moves ACCU 1 to ACCU 2.
            l.b.copy(Register::Accu2, ACCU1);
            l.b.push(Inst::Load { dst: ACCU1, place, width: access.width, on_fault: OnFault::DeliverZero });
        }
        Operand::Constant(value) => {
            let bits = value.accumulator().unwrap_or_else(|| unreachable!("{WRONG_OPERAND}"));
            l.b.copy(Register::Accu2, ACCU1);
            l.b.set(Register::Accu1, u64::from(bits));
        }
        Operand::ParameterAddress(index) => {
            let pointer = l.b.temporary();
            l.b.push(Inst::Parameter { dst: pointer, index: *index });
            into_accumulator(l, pointer);
        }
        Operand::Timer(number) => {
            let number = l.number(number);
            let value = l.b.intrinsic(Intrinsic::TimerValue, &[number]);
            into_accumulator(l, value);
        }
        Operand::Counter(number) => {
            let number = l.number(number);
            let value = l.b.intrinsic(Intrinsic::CounterValue, &[number]);
            into_accumulator(l, value);
        }
        Operand::Register(register) => into_accumulator_from(l, *register),
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

/// `L __ACCU 2`: the register as it was before ACCU 1 went to ACCU 2.
fn into_accumulator_from(l: &mut Lowering<'_>, register: Register) {
    let value = l.b.compute(Op::Copy, &[register.into()]);
    into_accumulator(l, value);
}

/// `LC`.
pub(crate) fn load_bcd(l: &mut Lowering<'_>, operand: &Operand) {
    let (number, intrinsic) = match operand {
        Operand::Timer(number) => (number, Intrinsic::TimerBcd),
        Operand::Counter(number) => (number, Intrinsic::CounterBcd),
        _ => unreachable!("{WRONG_OPERAND}"),
    };
    let number = l.number(number);
    let value = l.b.intrinsic(intrinsic, &[number]);
    into_accumulator(l, value);
}

/// `T`: in a switched-off MCR zone 0 is transferred.
pub(crate) fn transfer(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Memory(access) = operand else { unreachable!("{WRONG_OPERAND}") };
    let place = l.place(&access.location);
    let value = match l.mcr_on() {
        Some(on) => l.b.compute(Op::Gate, &[ACCU1, on]),
        None => ACCU1,
    };
    l.b.store(place, access.width, value);
}

/// `L STW`.
pub(crate) fn load_status_word(l: &mut Lowering<'_>) {
    let word = status_word(l);
    into_accumulator(l, word);
}

/// The status word as `L STW` delivers it.
pub(crate) fn status_word(l: &mut Lowering<'_>) -> Var {
    let zero = l.b.constant(0);
    let bit = |register: Register, whole: bool| if whole { register.into() } else { zero };
    let whole = l.cpu.status_word_whole;
    let low = [bit(Register::Fc, whole), Register::Rlo.into(), bit(Register::Sta, whole), bit(Register::Or, whole)];
    let low = l.b.compute(Op::Pack4, &low);
    let high = l.b.compute(Op::Pack4, &[Register::Os.into(), Register::Ov.into(), Register::Cc0.into(), Register::Cc1.into()]);
    let four = l.b.constant(4);
    let eight = l.b.constant(8);
    let word = l.b.compute(Op::Join, &[low, high, four]);
    l.b.compute(Op::Join, &[word, Register::Br.into(), eight])
}

/// `T STW`.
pub(crate) fn transfer_status_word(l: &mut Lowering<'_>) {
    let rest: &[_] = if l.cpu.status_word_whole { &MOVED_BY_400 } else { &[] };
    for &(register, bit) in MOVED_ALWAYS.iter().chain(rest) {
        let bit = l.b.constant(u64::from(bit));
        l.b.compute_into(register, Op::BitOf, &[ACCU1, bit]);
    }
}
