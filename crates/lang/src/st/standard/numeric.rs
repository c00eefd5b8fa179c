//! Arithmetic by name, and functions of numbers.

use sieben_engine::ir::Op;
use sieben_model::types::DataType;

use super::build::{after, compute, constant, converted, fail_if, operation, shared};
use super::call::{Answer, Call, built, built_list};
use super::generic::{Group, scalar_of};
use super::operators::{Beyond, Operation, Rounding, is_real, op_for};
use super::{Building, Refusal, Resolved};
use crate::st::dialect::{Construct, Dialect, Judgement};
use crate::st::tree::{Scalar, Statement, Value};

/// Functions of one REAL, with the operation and the dialects by column: iec, codesys, scl, tia.
const REAL_FUNCTIONS: &[(&str, Operation, [bool; 4])] = &[
    ("SQRT", Operation::SquareRoot, [true; 4]),
    ("LN", Operation::NaturalLogarithm, [true; 4]),
    ("LOG", Operation::Logarithm, [true, true, true, false]),
    ("EXP", Operation::Exponential, [true; 4]),
    ("EXPD", Operation::TenToThe, [false, false, true, false]),
    ("SIN", Operation::Sine, [true; 4]),
    ("COS", Operation::Cosine, [true; 4]),
    ("TAN", Operation::Tangent, [true; 4]),
    ("ASIN", Operation::ArcSine, [true; 4]),
    ("ACOS", Operation::ArcCosine, [true; 4]),
    ("ATAN", Operation::ArcTangent, [true; 4]),
];

/// What a function of LREALs computes, and the names of its inputs, where a dialect has it and LREAL too.
pub(super) fn real_operation(name: &str, dialect: Dialect) -> Option<(Op, &'static [&'static str])> {
    let column = dialect.column();
    match name {
        "ATAN2" => return (column == Dialect::Iec.column()).then_some((Op::Atan2F64, &["Y", "X"])),
        "EXPT" => return matches!(dialect.base(), Dialect::Iec | Dialect::Codesys).then_some((Op::PowF64, &["IN1", "IN2"])),
        _ => {}
    }
    let &(_, operation, dialects) = REAL_FUNCTIONS.iter().find(|(one, ..)| *one == name)?;
    let has_long = dialect.judge(Construct::LongTypes) != Judgement::Reject;
    (dialects[column] && has_long).then_some((op_for(operation, Scalar::F64)?, &["IN"]))
}

pub(super) fn resolve(call: &Call<'_>) -> Answer {
    let column = call.dialect.column();
    if let Some(&(_, operation, dialects)) = REAL_FUNCTIONS.iter().find(|(name, ..)| *name == call.name) {
        return dialects[column].then(|| real_function(call, operation));
    }
    // By column: iec, codesys, scl, tia.
    let dialects = match call.name {
        "ADD" | "MUL" | "SUB" | "DIV" | "MOD" | "MOVE" => [true, true, false, false],
        "EXPT" => [true, true, false, false],
        "ABS" => [true; 4],
        "SQR" => [false, false, true, true],
        "FRAC" | "NEG" => [false, false, false, true],
        "ATAN2" => [true, false, false, false],
        "IS_VALID" => [true, false, false, false],
        "NORM_X" | "SCALE_X" => [false, false, false, true],
        "SWAP" => [false, false, false, true],
        "TO_BIG_ENDIAN" | "FROM_BIG_ENDIAN" | "TO_LITTLE_ENDIAN" | "FROM_LITTLE_ENDIAN" => [true, false, false, false],
        _ => return None,
    };
    dialects[column].then(|| match call.name {
        "ADD" => fold(call, Operation::Add, Group::Magnitudes),
        "MUL" => fold(call, Operation::Multiply, Group::Numbers),
        "SUB" => two(call, Operation::Subtract, Group::Magnitudes),
        "DIV" => two(call, Operation::Divide, Group::Numbers),
        "MOD" => two(call, Operation::Modulo, Group::Integers),
        "EXPT" => power(call),
        "MOVE" => one(call, Group::Elementary, |value, _| value),
        "ABS" => one(call, Group::Numbers, |value, at| operation(Operation::Absolute, vec![value], at)),
        "NEG" => one(call, Group::Numbers, |value, at| operation(Operation::Negate, vec![value], at)),
        "SQR" => real(call, |value, at| {
            let mut before = Vec::new();
            let value = shared(value, &mut before, at);
            after(before, operation(Operation::Multiply, vec![value.clone(), value], at))
        }),
        "FRAC" => real(call, |value, at| {
            let mut before = Vec::new();
            let value = shared(value, &mut before, at);
            let scalar = value.scalar;
            let wide = converted(value.clone(), Scalar::F64, Rounding::Zero, Beyond::Nearest, at);
            let whole = compute(Op::TruncF64, vec![wide], Scalar::F64, at.span);
            let whole = converted(whole, scalar, Rounding::Zero, Beyond::Nearest, at);
            after(before, operation(Operation::Subtract, vec![value, whole], at))
        }),
        "NORM_X" => norm_x(call),
        "SCALE_X" => scale_x(call),
        "SWAP" => one(call, Group::Bits, swapped),
        // The memory of the CPU has the highest byte first.
        "TO_BIG_ENDIAN" | "FROM_BIG_ENDIAN" => one(call, Group::Elementary, |value, _| value),
        "TO_LITTLE_ENDIAN" | "FROM_LITTLE_ENDIAN" => one(call, Group::Elementary, swapped),
        "ATAN2" => {
            let given = call.bind(&["Y", "X"])?;
            let data_type = call.real(&given)?;
            built(vec![("Y", data_type.clone()), ("X", data_type.clone())], data_type, |args, at| {
                operation(Operation::ArcTangent2, args, at)
            })
        }
        _ => {
            let given = call.bind(&["IN"])?;
            let data_type = call.real(&given)?;
            built(vec![("IN", data_type)], DataType::Bool, |mut args, at| {
                let value = args.remove(0);
                let lost = if value.scalar == Scalar::F32 { Op::OverflowsF32 } else { Op::OverflowsF64 };
                let lost = compute(lost, vec![value], Scalar::Bool, at.span);
                compute(Op::Not, vec![lost], Scalar::Bool, at.span)
            })
        }
    })
}

/// A function of one REAL that has no result for some of them: that is no number, or infinite.
fn real_function(call: &Call<'_>, function: Operation) -> Result<Resolved, Refusal> {
    real(call, move |value, at| operation(function, vec![value], at))
}

fn real(call: &Call<'_>, build: impl Fn(Value, &mut Building<'_>) -> Value + 'static) -> Result<Resolved, Refusal> {
    let given = call.bind(&["IN"])?;
    let data_type = call.real(&given)?;
    built(vec![("IN", data_type.clone())], data_type, move |mut args, at| build(args.remove(0), at))
}

fn one(call: &Call<'_>, group: Group, build: impl Fn(Value, &mut Building<'_>) -> Value + 'static) -> Result<Resolved, Refusal> {
    let given = call.bind(&["IN"])?;
    let data_type = call.common(&given, group)?;
    built(vec![("IN", data_type.clone())], data_type, move |mut args, at| build(args.remove(0), at))
}

/// The bytes in the other order.
fn swapped(value: Value, at: &mut Building<'_>) -> Value {
    let scalar = value.scalar;
    let op = match scalar.bits() {
        16 => Op::Swap16,
        32 => Op::Swap32,
        64 => Op::Swap64,
        _ => return value,
    };
    compute(op, vec![value], scalar, at.span)
}

/// Two inputs of one type.
fn two(call: &Call<'_>, function: Operation, group: Group) -> Result<Resolved, Refusal> {
    let given = call.bind(&["IN1", "IN2"])?;
    let data_type = call.common(&given, group)?;
    built(vec![("IN1", data_type.clone()), ("IN2", data_type.clone())], data_type, move |args, at| operation(function, args, at))
}

/// Two or more inputs of one type, from left to right.
fn fold(call: &Call<'_>, function: Operation, group: Group) -> Result<Resolved, Refusal> {
    let bound = call.bind_list(&[], "IN", 1, 2)?;
    let given: Vec<_> = bound.iter().map(|(_, given)| *given).collect();
    let data_type = call.common(&given, group)?;
    let names = bound.into_iter().map(|(name, _)| name).collect();
    built_list(names, &data_type, data_type.clone(), move |args, at| {
        let mut args = args.into_iter();
        let first = args.next().unwrap_or_else(|| constant(0, Scalar::I16, at.span));
        args.fold(first, |sum, next| operation(function, vec![sum, next], at))
    })
}

/// The first input to the power of the second one.
fn power(call: &Call<'_>) -> Result<Resolved, Refusal> {
    let given = call.bind(&["IN1", "IN2"])?;
    let base = call.real(&given[..1])?;
    let exponent = call.common(&given[1..], Group::Numbers)?;
    let wide = scalar_of(&exponent, call.dialect) == Some(Scalar::F64) || base == DataType::LongReal;
    let exponent_type = match scalar_of(&exponent, call.dialect) {
        Some(scalar) if is_real(scalar) => base.clone(),
        _ => exponent,
    };
    let base = if wide && exponent_type == base { DataType::LongReal } else { base };
    let exponent_type = if base == DataType::LongReal && exponent_type == DataType::Real { DataType::LongReal } else { exponent_type };
    built(vec![("IN1", base.clone()), ("IN2", exponent_type)], base, |mut args, at| {
        let exponent = args.remove(1);
        let base = args.remove(0);
        let scalar = base.scalar;
        let exponent = converted(exponent, scalar, Rounding::HalfEven, Beyond::Nearest, at);
        let op = if scalar == Scalar::F32 { Op::PowF32 } else { Op::PowF64 };
        let lost = if scalar == Scalar::F32 { Op::OverflowsF32 } else { Op::OverflowsF64 };
        fail_if(compute(op, vec![base, exponent], scalar, at.span), lost, Vec::new(), at)
    })
}

/// (VALUE − MIN) / (MAX − MIN) as REAL, of LREAL as LREAL.
fn norm_x(call: &Call<'_>) -> Result<Resolved, Refusal> {
    let given = call.bind(&["MIN", "VALUE", "MAX"])?;
    let data_type = call.common(&given, Group::Numbers)?;
    let result = if call.scalar(&data_type) == Scalar::F64 { DataType::LongReal } else { DataType::Real };
    let scalar = call.scalar(&result);
    let parameters = ["MIN", "VALUE", "MAX"].map(|name| (name, data_type.clone())).to_vec();
    built(parameters, result, move |args, at| {
        let mut before = Vec::new();
        let [least, value, most] = wide(args, &mut before, at);
        let part = operation(Operation::Subtract, vec![value, least.clone()], at);
        let whole = operation(Operation::Subtract, vec![most.clone(), least.clone()], at);
        let value = operation(Operation::Divide, vec![part, whole], at);
        let value = converted(value, scalar, Rounding::HalfEven, Beyond::Nearest, at);
        after(before, in_order(value, least, most, at))
    })
}

/// VALUE · (MAX − MIN) + MIN in the type of MIN and MAX, rounded.
fn scale_x(call: &Call<'_>) -> Result<Resolved, Refusal> {
    let given = call.bind(&["MIN", "VALUE", "MAX"])?;
    let data_type = call.common(&[given[0], given[2]], Group::Numbers)?;
    let value_type = call.real(&[given[1]])?;
    let scalar = call.scalar(&data_type);
    built(vec![("MIN", data_type.clone()), ("VALUE", value_type), ("MAX", data_type.clone())], data_type, move |args, at| {
        let mut before = Vec::new();
        let [least, value, most] = wide(args, &mut before, at);
        let whole = operation(Operation::Subtract, vec![most.clone(), least.clone()], at);
        let part = operation(Operation::Multiply, vec![value, whole], at);
        let value = operation(Operation::Add, vec![part, least.clone()], at);
        let value = converted(value, scalar, Rounding::HalfEven, Beyond::Nearest, at);
        after(before, in_order(value, least, most, at))
    })
}

/// Three numbers as LREAL, each computed once.
fn wide(args: Vec<Value>, before: &mut Vec<Statement>, at: &mut Building<'_>) -> [Value; 3] {
    let mut args = args.into_iter();
    std::array::from_fn(|_| {
        let value = args.next().unwrap_or_else(|| constant(0, Scalar::F64, at.span));
        let value = converted(value, Scalar::F64, Rounding::HalfEven, Beyond::Nearest, at);
        shared(value, before, at)
    })
}

/// The value; ENO is FALSE if MIN is not below MAX.
fn in_order(value: Value, least: Value, most: Value, at: &Building<'_>) -> Value {
    if !at.checked {
        return value;
    }
    let ordered = operation(Operation::Less, vec![least, most], at);
    fail_if(value, Op::DivisorIsZero, vec![ordered], at)
}
