//! Bit strings: AND to NOT by name, shifts and rotations.

use sieben_engine::ir::Op;
use sieben_model::types::DataType;

use super::build::{compute, constant, converted, fail_if, operation};
use super::call::{Answer, Call, built, built_list};
use super::generic::Group;
use super::operators::{Beyond, Operation, Rounding, is_signed};
use super::{Building, GivenKind, Refusal, Resolved};
use crate::st::dialect::Dialect;
use crate::st::tree::{Scalar, Value};

/// What a negative number of places does, and whether integers have bits, by column: iec, codesys, scl, tia.
const NEGATIVE_IS_HUGE: [bool; 4] = [false, true, false, false];
const INTEGERS_HAVE_BITS: [bool; 4] = [false, true, false, true];

pub(super) fn resolve(call: &Call<'_>) -> Answer {
    let switches = call.dialect.switches();
    let group = if INTEGERS_HAVE_BITS[call.dialect.column()] { Group::BitsAndIntegers } else { Group::Bits };
    let logic = |operation| switches.operators_as_functions.then(|| fold(call, operation, group));
    match call.name {
        "AND" => logic(Operation::And),
        "OR" => logic(Operation::Or),
        "XOR" => logic(Operation::Xor),
        "NOT" => switches.operators_as_functions.then(|| {
            let given = call.bind(&["IN"])?;
            let data_type = call.common(&given, group)?;
            built(vec![("IN", data_type.clone())], data_type, |args, at| operation(Operation::Not, args, at))
        }),
        "SHL" => Some(shift(call, Operation::ShiftLeft, group)),
        "SHR" => Some(shift(call, Operation::ShiftRight, group)),
        "ROL" => Some(shift(call, Operation::RotateLeft, group)),
        "ROR" => Some(shift(call, Operation::RotateRight, group)),
        _ => None,
    }
}

fn fold(call: &Call<'_>, function: Operation, group: Group) -> Result<Resolved, Refusal> {
    let bound = call.bind_list(&[], "IN", 1, 2)?;
    let given: Vec<_> = bound.iter().map(|(_, given)| *given).collect();
    let data_type = call.common(&given, group)?;
    let names = bound.into_iter().map(|(name, _)| name).collect();
    built_list(names, &data_type, data_type.clone(), move |args, at| {
        let mut args = args.into_iter();
        let first = args.next().unwrap_or_else(|| constant(0, Scalar::Bool, at.span));
        args.fold(first, |sum, next| operation(function, vec![sum, next], at))
    })
}

/// The type of the operand, not that of the target, says how many bits there are.
fn shift(call: &Call<'_>, function: Operation, group: Group) -> Result<Resolved, Refusal> {
    let given = call.bind(&["IN", "N"])?;
    let data_type = match given[0].kind {
        // Nothing says how wide the result is to be: codesys computes in 32 bits at least.
        GivenKind::Integer { value, .. } if call.dialect.switches().integer_bits_min > 8 => match u32::try_from(value) {
            Ok(value) if i32::try_from(value).is_err() => DataType::DoubleWord,
            _ => call.own(given[0], group, &DataType::DoubleInt)?,
        },
        _ => call.own(given[0], group, &DataType::Int)?,
    };
    let places = call.own(given[1], Group::Integers, &DataType::Int)?;
    let dialect = call.dialect;
    built(vec![("IN", data_type.clone()), ("N", places)], data_type, move |mut args, at| {
        let places = args.remove(1);
        let value = args.remove(0);
        let count = count(places, matches!(function, Operation::RotateLeft | Operation::RotateRight), dialect, at);
        if value.scalar != Scalar::Bool {
            let scalar = value.scalar;
            let op = super::operators::op_for(function, scalar).unwrap_or(Op::Copy);
            return compute(op, vec![value, count], scalar, at.span);
        }
        // One bit: a rotation keeps it, a shift by any number of places pushes it out.
        match function {
            Operation::RotateLeft | Operation::RotateRight => value,
            _ => {
                let stays = compute(Op::Equal, vec![count, constant(0, Scalar::U8, at.span)], Scalar::Bool, at.span);
                compute(Op::And, vec![value, stays], Scalar::Bool, at.span)
            }
        }
    })
}

/// The number of places, 0 to 255.
fn count(places: Value, rotates: bool, dialect: Dialect, at: &mut Building<'_>) -> Value {
    let signed = is_signed(places.scalar);
    let mut places = places;
    if signed && !NEGATIVE_IS_HUGE[dialect.column()] {
        let zero = constant(0, Scalar::I64, at.span);
        let wide = converted(places, Scalar::I64, Rounding::Zero, Beyond::LowBits, at);
        let wide = fail_if(wide, Op::NegativeI64, Vec::new(), at);
        places = compute(Op::MaxI64, vec![wide, zero], Scalar::U64, at.span);
    }
    if rotates {
        // 64 is a multiple of every width.
        return compute(Op::RemU64, vec![places, constant(64, Scalar::U64, at.span)], Scalar::U8, at.span);
    }
    compute(Op::ShiftCount, vec![places], Scalar::U8, at.span)
}
