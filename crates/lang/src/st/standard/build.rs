//! Values composed of operations.

use sieben_engine::ir::Op;
use sieben_model::address::Area;
use sieben_model::source::Span;

use super::Building;
use super::operators::{
    Beyond, Operation, Rounding, compares, convert, failed_op, fails_of_division, is_real, lost_real, may_divide_wrong, op_for, range_check,
};
use crate::st::tree::{Base, Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// A constant of a kind, by its bits.
pub(crate) fn constant(bits: u64, scalar: Scalar, span: Span) -> Value {
    Value { kind: ValueKind::Constant(bits), scalar, span }
}

/// An operation; of constants its result.
pub(crate) fn compute(op: Op, args: Vec<Value>, scalar: Scalar, span: Span) -> Value {
    let kind = match words(&args) {
        Some(words) => ValueKind::Constant(op.eval(words)),
        None => ValueKind::Compute { op, args },
    };
    Value { kind, scalar, span }
}

/// The value itself, which clears ENO or OK if `failed` of it and the operands is true.
pub(crate) fn fail_if(value: Value, failed: Op, operands: Vec<Value>, at: &Building<'_>) -> Value {
    if !at.checked {
        return value;
    }
    let scalar = value.scalar;
    let mut args = vec![value];
    args.extend(operands);
    if words(&args).is_some_and(|words| failed.eval(words) & 1 == 0) {
        return args.swap_remove(0);
    }
    Value { kind: ValueKind::Checked { op: Op::Copy, failed, args }, scalar, span: at.span }
}

/// An operation of the table on operands of one kind.
pub(crate) fn operation(operation: Operation, args: Vec<Value>, at: &Building<'_>) -> Value {
    let operand = args[0].scalar;
    let scalar = if compares(operation) { Scalar::Bool } else { operand };
    let Some(op) = op_for(operation, operand) else {
        unreachable!("{operation:?} takes no {operand:?}: the function was resolved for it");
    };
    if let Some(failed) = failed_op(operation, operand)
        && (at.checked || at.quotients && fails_of_division(failed) && may_divide_wrong(failed, &args[1]))
        && words(&args).is_none_or(|words| failed.eval(words) & 1 != 0)
    {
        return Value { kind: ValueKind::Checked { op, failed, args }, scalar, span: at.span };
    }
    let value = compute(op, args, scalar, at.span);
    match lost_real(scalar) {
        Some(lost) if op.arity() <= 2 && !matches!(op, Op::Copy | Op::NegF32 | Op::NegF64 | Op::AbsF32 | Op::AbsF64) => {
            fail_if(value, lost, Vec::new(), at)
        }
        _ => value,
    }
}

/// A value of another kind.
pub(crate) fn converted(value: Value, to: Scalar, rounding: Rounding, beyond: Beyond, at: &Building<'_>) -> Value {
    let from = value.scalar;
    let mut value = value;
    if at.checked
        && let Some(check) = range_check(from, to, rounding)
        && words(std::slice::from_ref(&value)).is_none_or(|word| {
            let mut args = [check.steps.iter().fold(word[0], |word, op| op.eval([word, 0, 0, 0])), 0, 0, 0];
            args[1..=check.operands.len()].copy_from_slice(&check.operands);
            check.failed.eval(args) & 1 != 0
        })
    {
        let between = if is_real(from) || is_real(to) { Scalar::F64 } else { Scalar::I64 };
        if is_real(to) {
            let narrow = steps(value, &check.steps, to, to, at.span);
            return fail_if(narrow, check.failed, Vec::new(), at);
        }
        let operands = check.operands.iter().map(|&bits| constant(bits, between, at.span)).collect();
        let wide = if check.steps.is_empty() { value } else { steps(value, &check.steps, between, between, at.span) };
        let scalar = wide.scalar;
        value = fail_if(wide, check.failed, operands, at);
        value.scalar = scalar;
    }
    let list = convert(value.scalar, to, rounding, beyond);
    steps(value, &list, Scalar::I64, to, at.span)
}

/// Operations with one operand, one after the other; all but the last one give values of the kind `between`.
fn steps(value: Value, list: &[Op], between: Scalar, to: Scalar, span: Span) -> Value {
    let mut value = value;
    if list.is_empty() && value.scalar.bits() != to.bits() {
        // The bits in front are 0, and not in memory.
        value = compute(Op::Copy, vec![value], to, span);
    }
    for (index, &op) in list.iter().enumerate() {
        let scalar = match op {
            _ if index + 1 == list.len() => to,
            Op::F32ToF64 | Op::RoundF64 | Op::RoundAwayF64 | Op::CeilF64 | Op::FloorF64 | Op::TruncF64 => Scalar::F64,
            _ => between,
        };
        value = compute(op, vec![value], scalar, span);
    }
    value.scalar = to;
    value
}

/// Whether a value can be computed twice: nothing is called, and nothing is long.
fn is_simple(value: &Value) -> bool {
    match &value.kind {
        ValueKind::Constant(_) => true,
        // Reading an input of the periphery twice may give two values.
        ValueKind::Load(place) => {
            place.indexes.is_empty() && matches!(&place.base, Base::Area(Area::BitMemory | Area::Local) | Base::Instance)
        }
        _ => false,
    }
}

/// Makes a value one that can be used more than once; what has to happen before goes to `before`.
pub(crate) fn shared(value: Value, before: &mut Vec<Statement>, at: &mut Building<'_>) -> Value {
    if is_simple(&value) {
        return value;
    }
    let (scalar, span) = (value.scalar, value.span);
    let place: Place = (at.temporary)(scalar);
    before.push(Statement { kind: StatementKind::Assign { target: place.clone(), value }, span });
    Value { kind: ValueKind::Load(place), scalar, span }
}

/// A value with what has to happen before it.
pub(crate) fn after(before: Vec<Statement>, value: Value) -> Value {
    if before.is_empty() {
        return value;
    }
    let (scalar, span) = (value.scalar, value.span);
    Value { kind: ValueKind::After(before, Box::new(value)), scalar, span }
}

/// The words of arguments that are all constants.
fn words(args: &[Value]) -> Option<[u64; 4]> {
    let mut words = [0; 4];
    for (word, value) in words.iter_mut().zip(args) {
        let ValueKind::Constant(bits) = value.kind else { return None };
        *word = bits;
    }
    Some(words)
}
