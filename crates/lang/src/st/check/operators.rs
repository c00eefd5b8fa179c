//! Operators and conversions as operations on values; constants are computed at once.

use sieben_engine::ir::Op;

use crate::st::ast::BinaryOperator;
use crate::st::standard::operators::{Beyond, Operation as Named, Rounding, convert as steps, failed_op, op_for};
use crate::st::tree::{Scalar, Value, ValueKind};

/// An operation, and the question whether it failed, if it can.
pub(crate) type Operation = (Op, Option<Op>);

/// What an operator does.
fn named(operator: BinaryOperator) -> Option<Named> {
    Some(match operator {
        BinaryOperator::Power => Named::Power,
        BinaryOperator::Multiply => Named::Multiply,
        BinaryOperator::Divide | BinaryOperator::IntegerDivide => Named::Divide,
        BinaryOperator::Modulo => Named::Modulo,
        BinaryOperator::Add => Named::Add,
        BinaryOperator::Subtract => Named::Subtract,
        BinaryOperator::Less => Named::Less,
        BinaryOperator::LessEqual => Named::LessEqual,
        BinaryOperator::Greater => Named::Greater,
        BinaryOperator::GreaterEqual => Named::GreaterEqual,
        BinaryOperator::Equal => Named::Equal,
        BinaryOperator::NotEqual => Named::NotEqual,
        BinaryOperator::And => Named::And,
        BinaryOperator::Xor => Named::Xor,
        BinaryOperator::Or => Named::Or,
        BinaryOperator::AndThen | BinaryOperator::OrElse => return None,
    })
}

/// An operator between two values of one scalar.
pub(crate) fn binary(operator: BinaryOperator, scalar: Scalar) -> Option<Operation> {
    let operation = named(operator)?;
    Some((op_for(operation, scalar)?, failed_op(operation, scalar)))
}

/// The unary `-`.
pub(crate) fn negation(scalar: Scalar) -> Option<Operation> {
    Some((op_for(Named::Negate, scalar)?, failed_op(Named::Negate, scalar)))
}

/// NOT.
pub(crate) fn inversion(scalar: Scalar) -> Option<Op> {
    op_for(Named::Not, scalar)
}

/// A value as another scalar: extended by its sign or with zeros, cut to the low bits, a whole number as REAL or LREAL.
/// REAL to whole numbers rounds to the nearest even one.
pub(crate) fn convert(value: Value, to: Scalar) -> Value {
    let from = value.scalar;
    let span = value.span;
    let ops = steps(from, to, Rounding::HalfEven, Beyond::Nearest);
    // On the way REALs are LREALs and whole numbers have 64 bits.
    let between = if matches!(from, Scalar::F32 | Scalar::F64) { Scalar::F64 } else { Scalar::I64 };
    let last = ops.len();
    let steps = ops.into_iter().enumerate();
    let mut value = steps.fold(value, |value, (index, op)| compute(op, vec![value], if index + 1 == last { to } else { between }));
    if last == 0 && from != to {
        // The bits stay, and only their meaning changes. What is read or returned keeps the width that it has.
        value = match value.kind {
            ValueKind::Constant(_) | ValueKind::Compute { .. } | ValueKind::Checked { .. } => Value { scalar: to, ..value },
            _ if from.bits() == to.bits() => Value { scalar: to, ..value },
            _ => compute(Op::Copy, vec![value], to),
        };
    }
    value.span = span;
    value
}

/// An operation on values; on constants its result.
pub(crate) fn compute(op: Op, args: Vec<Value>, scalar: Scalar) -> Value {
    let span = args.iter().map(|value| value.span).reduce(|a, b| a.to(b)).unwrap_or_default();
    let kind = match constants(&args) {
        Some(words) => ValueKind::Constant(op.eval(words)),
        None => ValueKind::Compute { op, args },
    };
    Value { kind, scalar, span }
}

/// The same with a question whether it failed, which clears ENO or OK of the block.
pub(crate) fn checked((op, failed): Operation, args: Vec<Value>, scalar: Scalar) -> Value {
    match (failed, constants(&args)) {
        (Some(failed), Some(words)) if failed.eval(words) & 1 == 0 => compute(op, args, scalar),
        (Some(failed), _) => {
            let span = args.iter().map(|value| value.span).reduce(|a, b| a.to(b)).unwrap_or_default();
            Value { kind: ValueKind::Checked { op, failed, args }, scalar, span }
        }
        (None, _) => compute(op, args, scalar),
    }
}

/// The words of arguments that are all constants.
fn constants(args: &[Value]) -> Option<[u64; 4]> {
    let mut words = [0; 4];
    for (word, value) in words.iter_mut().zip(args) {
        let ValueKind::Constant(bits) = value.kind else { return None };
        *word = bits;
    }
    Some(words)
}
