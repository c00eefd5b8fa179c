//! Selection and comparison by name.

use sieben_engine::ir::Op;
use sieben_model::types::DataType;

use super::build::{after, compute, constant, fail_if, operation, shared};
use super::call::{Answer, Call, built, built_list};
use super::generic::{Group, is_text};
use super::operators::Operation;
use super::{Building, Given, GivenKind, Meaning, Parameter, Provided, Refusal, Resolved, library};
use crate::st::tree::{Scalar, Value, ValueKind};

/// Whether SEL and MUX compute only what they choose, by column: iec, codesys, scl, tia.
const LAZY: [bool; 4] = [false, true, false, false];

/// Texts that a function takes at most: each result between two of them needs 256 bytes of local data.
const TEXTS_MAX: usize = 32;

/// What MUX gives for a number without an input.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Otherwise {
    /// 0, and ENO is FALSE.
    Zero,
    /// The last input.
    Last,
}

pub(super) fn resolve(call: &Call<'_>) -> Answer {
    let functions = call.dialect.switches().operators_as_functions;
    let ordered = |operation| functions.then(|| neighbours(call, operation));
    match call.name {
        "SEL" => Some(sel(call)),
        "MAX" => Some(extreme(call, Operation::Maximum)),
        "MIN" => Some(extreme(call, Operation::Minimum)),
        "LIMIT" => Some(limit(call)),
        "MUX" => Some(mux(call)),
        "GT" => ordered(Operation::Greater),
        "GE" => ordered(Operation::GreaterEqual),
        "EQ" => ordered(Operation::Equal),
        "LE" => ordered(Operation::LessEqual),
        "LT" => ordered(Operation::Less),
        "NE" => functions.then(|| {
            let given = call.bind(&["IN1", "IN2"])?;
            if given.iter().any(|given| is_text(given)) {
                return texts(call, &given, Meaning::CompareTexts(Operation::NotEqual));
            }
            let data_type = call.common(&given, Group::Elementary)?;
            built(vec![("IN1", data_type.clone()), ("IN2", data_type)], DataType::Bool, |args, at| operation(Operation::NotEqual, args, at))
        }),
        _ => None,
    }
}

/// Two texts.
fn texts(call: &Call<'_>, given: &[&Given<'_>], meaning: Meaning) -> Result<Resolved, Refusal> {
    if let Some(wrong) =
        given.iter().find(|given| !is_text(given) && !matches!(given.kind, super::GivenKind::Typed(DataType::Char | DataType::WideChar)))
    {
        return Err(call.wrong(wrong, "a STRING"));
    }
    let result =
        if matches!(meaning, Meaning::CompareTexts(_)) { DataType::Bool } else { DataType::String(sieben_model::types::STRING_LENGTH_MAX) };
    Ok(Resolved { parameters: Vec::new(), result, meaning })
}

fn sel(call: &Call<'_>) -> Result<Resolved, Refusal> {
    let given = call.bind(&["G", "IN0", "IN1"])?;
    if is_text(given[1]) || is_text(given[2]) {
        return text_block(call, "SEL", &["G", "IN0", "IN1"]);
    }
    let data_type = chosen(call, &given[1..])?;
    let scalar = call.scalar(&data_type);
    let lazy = LAZY[call.dialect.column()];
    built(vec![("G", DataType::Bool), ("IN0", data_type.clone()), ("IN1", data_type.clone())], data_type, move |mut args, at| {
        let (second, first, condition) = (args.remove(2), args.remove(1), args.remove(0));
        choose(condition, second, first, scalar, lazy, at)
    })
}

/// The type of what is chosen from: an enumeration if all are of it.
fn chosen(call: &Call<'_>, given: &[&Given<'_>]) -> Result<DataType, Refusal> {
    let common = call.common(given, Group::Elementary)?;
    match &given[0].kind {
        GivenKind::Typed(own @ DataType::Enumeration(_)) if given.iter().all(|one| one.kind == given[0].kind) => Ok(own.clone()),
        _ => Ok(common),
    }
}

/// One of two values, of which the other one is computed too unless it is `lazy`.
fn choose(condition: Value, a: Value, b: Value, scalar: Scalar, lazy: bool, at: &Building<'_>) -> Value {
    let constant = [&condition, &a, &b].iter().all(|value| matches!(value.kind, ValueKind::Constant(_)));
    if !lazy || constant {
        return compute(Op::Select, vec![condition, a, b], scalar, at.span);
    }
    let kind = ValueKind::Choose { condition: Box::new(condition), a: Box::new(a), b: Box::new(b) };
    Value { kind, scalar, span: at.span }
}

fn extreme(call: &Call<'_>, function: Operation) -> Result<Resolved, Refusal> {
    let bound = call.bind_list(&[], "IN", 1, 2)?;
    let given: Vec<_> = bound.iter().map(|(_, given)| *given).collect();
    if given.iter().any(|given| is_text(given)) {
        let block = if function == Operation::Maximum { "MAX" } else { "MIN" };
        return folded(call, block, &bound);
    }
    let data_type = call.common(&given, Group::Elementary)?;
    let names = bound.into_iter().map(|(name, _)| name).collect();
    built_list(names, &data_type, data_type.clone(), move |args, at| {
        let mut args = args.into_iter();
        let first = args.next().unwrap_or_else(|| constant(0, Scalar::I16, at.span));
        args.fold(first, |found, next| operation(function, vec![found, next], at))
    })
}

/// MIN(MAX(IN, MN), MX).
fn limit(call: &Call<'_>) -> Result<Resolved, Refusal> {
    let given = call.bind(&["MN", "IN", "MX"])?;
    if given.iter().any(|given| is_text(given)) {
        return text_block(call, "LIMIT", &["MN", "IN", "MX"]);
    }
    let data_type = call.common(&given, Group::Elementary)?;
    let parameters = ["MN", "IN", "MX"].map(|name| (name, data_type.clone())).to_vec();
    built(parameters, data_type, |mut args, at| {
        let (most, value, least) = (args.remove(2), args.remove(1), args.remove(0));
        // The operands stay in the order in which they are written.
        let value = operation(Operation::Maximum, vec![least, value], at);
        operation(Operation::Minimum, vec![value, most], at)
    })
}

fn mux(call: &Call<'_>) -> Result<Resolved, Refusal> {
    // What a number without an input gives, by column: iec, codesys, scl, tia.
    let otherwise = [Otherwise::Zero, Otherwise::Last, Otherwise::Zero, Otherwise::Zero][call.dialect.column()];
    let has_else = [false, false, true, true][call.dialect.column()];
    let named_else = call.arguments.iter().position(|given| has_else && given.name.is_some_and(|name| name.eq_ignore_ascii_case("INELSE")));
    let without: Vec<Given<'_>> =
        call.arguments.iter().enumerate().filter(|(index, _)| Some(*index) != named_else).map(|(_, given)| given.clone()).collect();
    let inner = Call { name: call.name, dialect: call.dialect, arguments: &without };
    let bound = inner.bind_list(&["K"], "IN", 0, if named_else.is_some() { 1 } else { 2 })?;
    let places = call.own(bound[0].1, Group::Integers, &DataType::Int)?;
    let mut given: Vec<_> = bound[1..].iter().map(|(_, given)| *given).collect();
    given.extend(named_else.map(|index| &call.arguments[index]));
    if given.iter().any(|given| is_text(given)) {
        let mut parameters = vec![Parameter { name: "K".to_owned(), data_type: places }];
        let string = DataType::String(sieben_model::types::STRING_LENGTH_MAX);
        parameters.extend(bound[1..].iter().map(|(name, _)| Parameter { name: name.clone(), data_type: string.clone() }));
        if named_else.is_some() {
            parameters.push(Parameter { name: "INELSE".to_owned(), data_type: string.clone() });
        }
        let block = string_block(call, "SEL")?;
        let meaning = Meaning::Choose { block, inputs: bound.len() - 1, last: otherwise == Otherwise::Last };
        return Ok(Resolved { parameters, result: string, meaning });
    }
    let data_type = chosen(&inner, &given)?;
    let scalar = call.scalar(&data_type);
    let lazy = LAZY[call.dialect.column()];
    let mut parameters = vec![Parameter { name: "K".to_owned(), data_type: places }];
    parameters.extend(bound[1..].iter().map(|(name, _)| Parameter { name: name.clone(), data_type: data_type.clone() }));
    if named_else.is_some() {
        parameters.push(Parameter { name: "INELSE".to_owned(), data_type: data_type.clone() });
    }
    let has_else = named_else.is_some();
    let build = move |mut args: Vec<Value>, at: &mut Building<'_>| {
        let mut before = Vec::new();
        let number = shared(args.remove(0), &mut before, at);
        let fallback = match otherwise {
            _ if has_else => args.pop(),
            Otherwise::Last => args.last().cloned(),
            Otherwise::Zero => None,
        };
        let inputs = args.len() as u64;
        let missing = fallback.is_none();
        let mut value = fallback.unwrap_or_else(|| constant(0, scalar, at.span));
        for (index, input) in args.into_iter().enumerate().rev() {
            if otherwise == Otherwise::Last && !has_else && index as u64 + 1 == inputs {
                continue;
            }
            let this = constant(index as u64, number.scalar, at.span);
            let condition = compute(Op::Equal, vec![number.clone(), this], Scalar::Bool, at.span);
            value = choose(condition, input, value, scalar, lazy, at);
        }
        if missing && at.checked {
            // A negative number, zero-extended, is above all inputs too.
            let within = compute(Op::Below, vec![number, constant(inputs, Scalar::U64, at.span)], Scalar::U64, at.span);
            value = fail_if(value, Op::DivisorIsZero, vec![within], at);
        }
        after(before, value)
    };
    Ok(Resolved { parameters, result: data_type, meaning: Meaning::Build(Box::new(build)) })
}

/// Whether each neighbouring pair is in this order.
fn neighbours(call: &Call<'_>, function: Operation) -> Result<Resolved, Refusal> {
    let bound = call.bind_list(&[], "IN", 1, 2)?;
    let given: Vec<_> = bound.iter().map(|(_, given)| *given).collect();
    if given.iter().any(|given| is_text(given)) {
        if given.len() > TEXTS_MAX {
            let message = format!("`{}` takes at most {TEXTS_MAX} texts, not {}", call.name, given.len());
            return Err(call.refuse(sieben_model::problems::Problem::P3009, Some(TEXTS_MAX), message, "compare a part of them first"));
        }
        let string = DataType::String(sieben_model::types::STRING_LENGTH_MAX);
        let parameters = bound.iter().map(|(name, _)| Parameter { name: name.clone(), data_type: string.clone() }).collect();
        return Ok(Resolved { parameters, ..texts(call, &given, Meaning::CompareTexts(function))? });
    }
    let data_type = call.common(&given, Group::Elementary)?;
    let names = bound.into_iter().map(|(name, _)| name).collect();
    built_list(names, &data_type, DataType::Bool, move |args, at| {
        let mut before = Vec::new();
        let last = args.len() - 1;
        let args: Vec<Value> = args
            .into_iter()
            .enumerate()
            .map(|(index, value)| if index == 0 || index == last { value } else { shared(value, &mut before, at) })
            .collect();
        let pairs = args.windows(2).map(|pair| operation(function, pair.to_vec(), at)).collect::<Vec<_>>();
        let all = pairs.into_iter().reduce(|all, next| compute(Op::And, vec![all, next], Scalar::Bool, at.span));
        after(before, all.unwrap_or_else(|| constant(1, Scalar::Bool, at.span)))
    })
}

/// CONCAT of more than two texts; `None` for two of them, and where it takes no more.
pub(super) fn concat(call: &Call<'_>) -> Answer {
    let many = [true, false, false, true][call.dialect.column()] && call.name == "CONCAT" && call.arguments.len() > 2;
    many.then(|| {
        let bound = call.bind_list(&[], "IN", 1, 2)?;
        folded(call, "CONCAT", &bound)
    })
}

/// A function of two or more texts, which is a block of the library for two.
fn folded(call: &Call<'_>, block: &'static str, bound: &[(String, &Given<'_>)]) -> Result<Resolved, Refusal> {
    let given: Vec<&Given<'_>> = bound.iter().map(|(_, given)| *given).collect();
    if given.len() > TEXTS_MAX {
        let message = format!("`{}` takes at most {TEXTS_MAX} texts, not {}", call.name, given.len());
        return Err(call.refuse(sieben_model::problems::Problem::P3009, Some(TEXTS_MAX), message, "call it for a part of them first"));
    }
    let folded = texts(call, &given, Meaning::Fold(string_block(call, block)?))?;
    let string = DataType::String(sieben_model::types::STRING_LENGTH_MAX);
    let parameters = bound.iter().map(|(name, _)| Parameter { name: name.clone(), data_type: string.clone() }).collect();
    Ok(Resolved { parameters, ..folded })
}

/// A function of texts, which is a block of the library.
fn text_block(call: &Call<'_>, name: &'static str, names: &[&str]) -> Result<Resolved, Refusal> {
    call.bind(names)?;
    let block = string_block(call, name)?;
    let parameters = names
        .iter()
        .map(|name| Parameter {
            name: (*name).to_owned(),
            data_type: if *name == "G" { DataType::Bool } else { DataType::String(sieben_model::types::STRING_LENGTH_MAX) },
        })
        .collect();
    Ok(Resolved { parameters, result: DataType::String(sieben_model::types::STRING_LENGTH_MAX), meaning: Meaning::Block(block) })
}

/// CONCAT, or MAX, MIN, LIMIT and SEL of the texts that the call has.
fn string_block(call: &Call<'_>, name: &'static str) -> Result<Provided, Refusal> {
    let wide = call.arguments.iter().any(|given| matches!(given.kind, super::GivenKind::Typed(DataType::WideString(_))));
    let block = match name {
        "CONCAT" => name.to_owned(),
        _ => format!("{name}_{}", if wide { "WSTRING" } else { "STRING" }),
    };
    library::function(&block, call.dialect).ok_or_else(|| {
        let message = format!("`{}` takes no STRING", call.name);
        call.refuse(sieben_model::problems::Problem::P4011, None, message, "compare and assign the texts with IF")
    })
}
