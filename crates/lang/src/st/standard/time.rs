//! Times and dates by name, and the clock.

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::Op;
use sieben_model::types::DataType;

use super::build::{compute, constant, converted, fail_if, operation};
use super::call::{Answer, Call, built};
use super::generic::{Group, named};
use super::operators::{Beyond, Operation, Rounding, is_real, is_signed};
use super::{Building, Refusal, Resolved};
use crate::st::dialect::{Calendar, Dialect};
use crate::st::tree::{Scalar, Value, ValueKind};

/// Milliseconds and nanoseconds of a day.
const DAY_IN_MILLISECONDS: u64 = 86_400_000;
const DAY_IN_NANOSECONDS: u64 = DAY_IN_MILLISECONDS * 1_000_000;

/// What is added or subtracted: name, first type, second type, result.
const SUMS: &[(&str, Operation, &str, &str, &str)] = &[
    ("ADD_TIME", Operation::Add, "TIME", "TIME", "TIME"),
    ("ADD_TOD_TIME", Operation::Add, "TOD", "TIME", "TOD"),
    ("ADD_DT_TIME", Operation::Add, "DT", "TIME", "DT"),
    ("SUB_TIME", Operation::Subtract, "TIME", "TIME", "TIME"),
    ("SUB_DATE_DATE", Operation::Subtract, "DATE", "DATE", "TIME"),
    ("SUB_TOD_TIME", Operation::Subtract, "TOD", "TIME", "TOD"),
    ("SUB_TOD_TOD", Operation::Subtract, "TOD", "TOD", "TIME"),
    ("SUB_DT_TIME", Operation::Subtract, "DT", "TIME", "DT"),
    ("SUB_DT_DT", Operation::Subtract, "DT", "DT", "TIME"),
    ("ADD_LTIME", Operation::Add, "LTIME", "LTIME", "LTIME"),
    ("ADD_LTOD_LTIME", Operation::Add, "LTOD", "LTIME", "LTOD"),
    ("ADD_LDT_LTIME", Operation::Add, "LDT", "LTIME", "LDT"),
    ("SUB_LTIME", Operation::Subtract, "LTIME", "LTIME", "LTIME"),
    ("SUB_LDATE_LDATE", Operation::Subtract, "LDATE", "LDATE", "LTIME"),
    ("SUB_LTOD_LTIME", Operation::Subtract, "LTOD", "LTIME", "LTOD"),
    ("SUB_LTOD_LTOD", Operation::Subtract, "LTOD", "LTOD", "LTIME"),
    ("SUB_LDT_LTIME", Operation::Subtract, "LDT", "LTIME", "LDT"),
    ("SUB_LDT_LDT", Operation::Subtract, "LDT", "LDT", "LTIME"),
];

pub(super) fn resolve(call: &Call<'_>) -> Answer {
    match call.name {
        "SCAN_CLOCK" => return Some(clock(call, DataType::Time)),
        // By column: iec, codesys, scl, tia.
        "TIME" if [false, true, false, false][call.dialect.column()] => return Some(clock(call, DataType::Time)),
        _ => {}
    }
    if call.dialect.switches().calendar != Calendar::Long {
        return None;
    }
    if let Some(&(_, operation, first, second, result)) = SUMS.iter().find(|(name, ..)| *name == call.name) {
        return Some(sum(call, operation, [first, second, result]));
    }
    match call.name {
        "MUL_TIME" | "MULTIME" => Some(scaled(call, Operation::Multiply, DataType::Time)),
        "DIV_TIME" | "DIVTIME" => Some(scaled(call, Operation::Divide, DataType::Time)),
        "MUL_LTIME" => Some(scaled(call, Operation::Multiply, DataType::LongTime)),
        "DIV_LTIME" => Some(scaled(call, Operation::Divide, DataType::LongTime)),
        "CONCAT_DATE_TOD" => Some(joined(call, DataType::TimeOfDay)),
        "CONCAT_DATE_LTOD" => Some(joined(call, DataType::LongTimeOfDay)),
        "DAY_OF_WEEK" => Some((|| {
            call.bind(&["IN"])?;
            built(vec![("IN", DataType::LongDate)], DataType::Int, |mut args, at| {
                let days =
                    compute(Op::DivU64, vec![args.remove(0), constant(DAY_IN_NANOSECONDS, Scalar::U64, at.span)], Scalar::U64, at.span);
                // 1970-01-01 was a Thursday.
                let days = compute(Op::AddU64, vec![days, constant(4, Scalar::U64, at.span)], Scalar::U64, at.span);
                compute(Op::RemU64, vec![days, constant(7, Scalar::U64, at.span)], Scalar::I16, at.span)
            })
        })()),
        _ => None,
    }
}

/// The clock at the start of the scan; it begins anew after 2^32 ms.
fn clock(call: &Call<'_>, data_type: DataType) -> Result<Resolved, Refusal> {
    call.bind(&[])?;
    let scalar = call.scalar(&data_type);
    built(Vec::new(), data_type, move |_, at| {
        let kind = ValueKind::Intrinsic { intrinsic: Intrinsic::Clock, args: Vec::new() };
        Value { kind, scalar, span: at.span }
    })
}

fn sum(call: &Call<'_>, function: Operation, words: [&str; 3]) -> Result<Resolved, Refusal> {
    call.bind(&["IN1", "IN2"])?;
    let types = words.map(|word| named(word, call.dialect).unwrap_or(DataType::Time));
    let [first, second, result] = types.clone();
    let (dialect, scalars) = (call.dialect, types.clone().map(|data_type| call.scalar(&data_type)));
    built(vec![("IN1", first), ("IN2", second)], result, move |mut args, at| {
        let (second, first) = (args.remove(1), args.remove(0));
        total(function, first, second, &types, scalars, dialect, at)
    })
}

/// A sum or difference; TIME counts milliseconds where dates count nanoseconds.
fn total(
    function: Operation,
    first: Value,
    second: Value,
    types: &[DataType; 3],
    scalars: [Scalar; 3],
    dialect: Dialect,
    at: &mut Building<'_>,
) -> Value {
    let date = |data_type: &DataType| matches!(data_type, DataType::LongDate | DataType::LongDateAndTime);
    if types[0] == types[2] && scalars[0] == scalars[1] && !matches!(types[0], DataType::LongTimeOfDay) {
        return operation(function, vec![first, second], at);
    }
    let wide = |value: Value, data_type: &DataType, at: &mut Building<'_>| {
        let signed = is_signed(value.scalar);
        let value = converted(value, if signed { Scalar::I64 } else { Scalar::U64 }, Rounding::Zero, Beyond::LowBits, at);
        let factor = if *data_type == DataType::Time && date(&types[0]) { 1_000_000 } else { 1 };
        let value = if factor == 1 {
            value
        } else {
            compute(Op::MulU64, vec![value, constant(factor, Scalar::I64, at.span)], Scalar::I64, at.span)
        };
        Value { scalar: Scalar::I64, ..value }
    };
    let (first, second) = (wide(first, &types[0], at), wide(second, &types[1], at));
    let mut value = operation(function, vec![first, second], at);
    if date(&types[0]) && types[2] == DataType::Time {
        value = compute(Op::DivI64, vec![value, constant(1_000_000, Scalar::I64, at.span)], Scalar::I64, at.span);
    }
    let day = match types[2] {
        DataType::TimeOfDay => Some(DAY_IN_MILLISECONDS),
        DataType::LongTimeOfDay => Some(DAY_IN_NANOSECONDS),
        _ => None,
    };
    // CODESYS does not bring a time of day back into one day.
    if let Some(day) = day.filter(|_| dialect != Dialect::Codesys) {
        let most = [0, day - 1].map(|limit| constant(limit, Scalar::I64, at.span)).to_vec();
        value = fail_if(value, Op::OutsideI64, most, at);
        let day = constant(day, Scalar::I64, at.span);
        let rest = compute(Op::RemI64, vec![value, day.clone()], Scalar::I64, at.span);
        let above = compute(Op::AddU64, vec![rest, day.clone()], Scalar::I64, at.span);
        value = compute(Op::RemI64, vec![above, day], Scalar::I64, at.span);
    }
    let target = scalars[2];
    if target.bits() == 64 { Value { scalar: target, ..value } } else { converted(value, target, Rounding::Zero, Beyond::LowBits, at) }
}

/// A duration times a number, or divided by one; by a REAL rounded to the nearest unit.
fn scaled(call: &Call<'_>, function: Operation, data_type: DataType) -> Result<Resolved, Refusal> {
    let given = call.bind(&["IN1", "IN2"])?;
    let number = call.own(given[1], Group::Numbers, &DataType::Int)?;
    let scalar = call.scalar(&data_type);
    built(vec![("IN1", data_type.clone()), ("IN2", number)], data_type, move |mut args, at| {
        let (number, time) = (args.remove(1), args.remove(0));
        let between = if is_real(number.scalar) { Scalar::F64 } else { Scalar::I64 };
        let time = converted(time, between, Rounding::Zero, Beyond::LowBits, at);
        let number = converted(number, between, Rounding::Zero, Beyond::LowBits, at);
        let value = operation(function, vec![time, number], at);
        converted(value, scalar, Rounding::HalfEven, Beyond::Nearest, at)
    })
}

/// A date and a time of day as one point in time.
fn joined(call: &Call<'_>, clock: DataType) -> Result<Resolved, Refusal> {
    call.bind(&["IN1", "IN2"])?;
    let factor = if clock == DataType::TimeOfDay { 1_000_000 } else { 1 };
    built(vec![("IN1", DataType::LongDate), ("IN2", clock)], DataType::LongDateAndTime, move |mut args, at| {
        let (clock, date) = (args.remove(1), args.remove(0));
        let clock = converted(clock, Scalar::U64, Rounding::Zero, Beyond::LowBits, at);
        let clock = compute(Op::MulU64, vec![clock, constant(factor, Scalar::U64, at.span)], Scalar::U64, at.span);
        compute(Op::AddU64, vec![date, clock], Scalar::U64, at.span)
    })
}
