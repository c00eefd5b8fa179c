//! Bit logic: scans, nesting, assignments, edges.

use sieben_engine::fault::Abort;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Inst, OnFault, Op, Var};
use sieben_engine::machine::Register;
use sieben_model::literal::Value;

use super::WRONG_OPERAND;
use crate::stl::lower::Lowering;
use crate::stl::operands::{Operand, StatusScan};

const RLO: Var = Var(Register::Rlo as u8);
const STA: Var = Var(Register::Sta as u8);
const OR: Var = Var(Register::Or as u8);
const FC: Var = Var(Register::Fc as u8);
const BR: Var = Var(Register::Br as u8);
const NESTING: Var = Var(Register::Nesting as u8);

/// `A`, `AN`, `O`, `ON`, `X`, `XN`: the scanned bit goes to STA, its combination to the RLO.
pub(crate) fn scan(l: &mut Lowering<'_>, operand: &Operand, op: Op) {
    status_bit(l, operand);
    if op.arity() == 4 {
        l.b.compute_into(RLO, op, &[RLO, STA, OR, FC]);
        l.b.compute_into(OR, Op::And, &[OR, FC]);
    } else {
        l.b.compute_into(RLO, op, &[RLO, STA, FC]);
        l.b.set(OR, 0);
    }
    l.b.set(FC, 1);
}

/// The scanned bit in STA.
fn status_bit(l: &mut Lowering<'_>, operand: &Operand) {
    match operand {
        Operand::Memory(access) => {
            let place = l.place(&access.location);
            l.b.push(Inst::Load { dst: STA, place, width: access.width, on_fault: OnFault::SkipStatement });
        }
        Operand::Timer(number) => {
            let number = l.number(number);
            let status = l.b.intrinsic(Intrinsic::TimerStatus, &[number]);
            l.b.copy(STA, status);
        }
        Operand::Counter(number) => {
            let number = l.number(number);
            let status = l.b.intrinsic(Intrinsic::CounterStatus, &[number]);
            l.b.copy(STA, status);
        }
        Operand::Status(scan) => {
            let bit = status_scan(l, *scan);
            l.b.copy(STA, bit);
        }
        Operand::Register(register) => l.b.copy(STA, *register),
        Operand::Constant(Value::Bool(bit)) => l.b.set(STA, u64::from(*bit)),
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

/// Whether the status word satisfies a scan.
pub(crate) fn status_scan(l: &mut Lowering<'_>, scan: StatusScan) -> Var {
    let (cc1, cc0) = (Register::Cc1.into(), Register::Cc0.into());
    match scan {
        StatusScan::Zero => {
            let any = l.b.compute(Op::Or, &[cc1, cc0]);
            l.b.compute(Op::Not, &[any])
        }
        StatusScan::NonZero => l.b.compute(Op::Xor, &[cc1, cc0]),
        StatusScan::Positive => l.b.compute(Op::AndNot, &[cc1, cc0]),
        StatusScan::Negative => l.b.compute(Op::AndNot, &[cc0, cc1]),
        StatusScan::NotNegative => l.b.compute(Op::Not, &[cc0]),
        StatusScan::NotPositive => l.b.compute(Op::Not, &[cc1]),
        StatusScan::Unordered => l.b.compute(Op::And, &[cc1, cc0]),
        StatusScan::Overflow => Register::Ov.into(),
        StatusScan::StoredOverflow => Register::Os.into(),
        StatusScan::BinaryResult => BR,
    }
}

/// `O` without operand. /FC stays 1 only if the RLO is 1: then the following ANDs cannot change the result.
pub(crate) fn or_separator(l: &mut Lowering<'_>) {
    l.b.compute_into(OR, Op::OrBegin, &[RLO, OR, FC]);
    l.b.compute_into(FC, Op::And, &[RLO, FC]);
    l.b.set(STA, 1);
}

/// `A(` and its like; the function is 0 A, 1 AN, 2 O, 3 ON, 4 X, 5 XN.
pub(crate) fn open_bracket(l: &mut Lowering<'_>, function: u64) {
    let room = l.b.compute(Op::NestingHasRoom, &[NESTING]);
    l.b.push(Inst::RequireStack { condition: room, abort: Abort::NestingStack });
    let entry = l.b.compute(Op::NestingEntry, &[RLO, OR, FC, BR]);
    let function = l.b.constant(function);
    l.b.compute_into(NESTING, Op::NestingPush, &[NESTING, entry, function]);
    l.b.set(OR, 0);
    l.b.set(STA, 1);
    l.b.set(FC, 0);
}

/// `)`. BR becomes the one saved by the opening bracket, as the instruction lists have it (docs/decisions/002).
pub(crate) fn close_bracket(l: &mut Lowering<'_>) {
    let open = l.b.compute(Op::IsNonzero, &[NESTING]);
    l.b.push(Inst::RequireStack { condition: open, abort: Abort::NestingStack });
    l.b.compute_into(RLO, Op::NestingRlo, &[NESTING, RLO]);
    l.b.compute_into(OR, Op::NestingOr, &[NESTING]);
    l.b.compute_into(BR, Op::NestingBr, &[NESTING]);
    l.b.compute_into(NESTING, Op::NestingPop, &[NESTING]);
    l.b.set(STA, 1);
    l.b.set(FC, 1);
}

/// `=`.
pub(crate) fn assign(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Memory(access) = operand else { unreachable!("{WRONG_OPERAND}") };
    let place = l.place(&access.location);
    let value = match l.mcr_on() {
        Some(on) => l.b.compute(Op::And, &[RLO, on]),
        None => RLO,
    };
    l.b.store(place, access.width, value);
    l.b.copy(STA, value);
    end_of_string(l);
}

/// `S` and `R`. STA is the bit as it is afterwards, written or not.
pub(crate) fn set_reset(l: &mut Lowering<'_>, operand: &Operand, op: Op) {
    let Operand::Memory(access) = operand else { unreachable!("{WRONG_OPERAND}") };
    let place = l.place(&access.location);
    let condition = match l.mcr_on() {
        Some(on) => l.b.compute(Op::And, &[RLO, on]),
        None => RLO,
    };
    let old = l.b.load(place, access.width, OnFault::SkipWrite);
    let new = l.b.compute(op, &[old, condition]);
    l.b.store(place, access.width, new);
    l.b.copy(STA, new);
    end_of_string(l);
}

/// Behind `=`, `S` and `R` the next scan begins a new logic string.
fn end_of_string(l: &mut Lowering<'_>) {
    l.b.set(OR, 0);
    l.b.set(FC, 0);
}

/// `FP` and `FN`: STA is the RLO before; the MCR has no effect.
pub(crate) fn edge(l: &mut Lowering<'_>, operand: &Operand, positive: bool) {
    let Operand::Memory(access) = operand else { unreachable!("{WRONG_OPERAND}") };
    let place = l.place(&access.location);
    let old = l.b.load(place, access.width, OnFault::SkipWrite);
    l.b.store(place, access.width, RLO);
    l.b.copy(STA, RLO);
    if positive {
        l.b.compute_into(RLO, Op::AndNot, &[RLO, old]);
    } else {
        l.b.compute_into(RLO, Op::AndNot, &[old, RLO]);
    }
    l.b.set(OR, 0);
    l.b.set(FC, 1);
}

/// `NOT`.
pub(crate) fn not(l: &mut Lowering<'_>) {
    l.b.compute_into(RLO, Op::Not, &[RLO]);
    l.b.set(STA, 1);
}

/// `SET` and `CLR`.
pub(crate) fn constant_rlo(l: &mut Lowering<'_>, rlo: u64) {
    l.b.set(RLO, rlo);
    l.b.set(STA, rlo);
    end_of_string(l);
}
