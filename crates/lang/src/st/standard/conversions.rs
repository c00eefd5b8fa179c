//! Conversions: `X_TO_Y`, `TO_Y`, rounding, BCD.

use sieben_engine::ir::Op;
use sieben_model::types::{DataType, STRING_LENGTH_MAX};

use super::build::{compute, constant, converted, fail_if};
use super::call::{Answer, Call, built};
use super::generic::{is_integer, named, scalar_of, type_of};
use super::operators::{Beyond, Rounding, is_real, is_signed};
use super::{Building, GivenKind, Meaning, Refusal, Resolved, library};
use crate::st::dialect::{Calendar, Construct, Dialect, Judgement};
use crate::st::tree::{Scalar, Value};

/// Nanoseconds of a day, of a second and of a millisecond.
const DAY: u64 = 86_400_000_000_000;
const SECOND: u64 = 1_000_000_000;
const MILLISECOND: u64 = 1_000_000;

/// How REALs become integers, by column: iec, codesys, scl, tia.
const ROUNDING: [Rounding; 4] = [Rounding::HalfEven, Rounding::HalfAway, Rounding::HalfEven, Rounding::HalfEven];
const BEYOND: [Beyond; 4] = [Beyond::Nearest, Beyond::LowBits, Beyond::LowBits, Beyond::LowBits];
/// Whether a bit string and a REAL of one width exchange their bits.
const REAL_BY_BITS: [bool; 4] = [true, false, true, true];
/// Whether a number is TRUE if it is not 0; else its lowest bit says it.
const NONZERO_IS_TRUE: [bool; 4] = [true, true, false, false];

/// The conversions of S7-SCL between elementary types; those of strings, dates and S5TIME are blocks.
const SCL: &[(&str, &[&str])] = &[
    ("BOOL", &["BYTE", "WORD", "DWORD"]),
    ("BYTE", &["BOOL", "CHAR", "WORD", "DWORD"]),
    ("CHAR", &["BYTE", "INT"]),
    ("DATE", &["DINT"]),
    ("DINT", &["DATE", "DWORD", "INT", "REAL", "TIME", "TOD"]),
    ("DWORD", &["BOOL", "BYTE", "DINT", "REAL", "WORD"]),
    ("INT", &["CHAR", "DINT", "REAL", "WORD"]),
    ("REAL", &["DINT", "DWORD", "INT"]),
    ("S5TIME", &["TIME"]),
    ("TIME", &["DINT", "S5TIME"]),
    ("TOD", &["DINT"]),
    ("WORD", &["BOOL", "BYTE", "INT", "DWORD"]),
];

pub(super) fn resolve(call: &Call<'_>) -> Answer {
    rounding(call).or_else(|| bcd(call)).or_else(|| by_name(call))
}

/// ROUND, TRUNC, CEIL, FLOOR, also with the type of the result: `TRUNC_INT`, `REAL_TRUNC_INT`.
fn rounding(call: &Call<'_>) -> Answer {
    let modes = [("ROUND", Rounding::HalfEven), ("TRUNC", Rounding::Zero), ("CEIL", Rounding::Up), ("FLOOR", Rounding::Down)];
    let column = call.dialect.column();
    for (word, rounding) in modes {
        // Only TRUNC is part of all dialects.
        let exists = word == "TRUNC" || [false, false, true, true][column];
        let plain = call.name.strip_prefix("LREAL_").or_else(|| call.name.strip_prefix("REAL_")).filter(|rest| rest.starts_with("TRUNC_"));
        let Some(rest) = plain.unwrap_or(call.name).strip_prefix(word) else { continue };
        let to = match rest.strip_prefix('_') {
            None if rest.is_empty() => DataType::DoubleInt,
            Some(word) => named(word, call.dialect).filter(is_integer)?,
            None => return None,
        };
        return exists.then(|| {
            let given = call.bind(&["IN"])?;
            let from = call.real(&given)?;
            let (scalar, beyond) = (call.scalar(&to), BEYOND[column]);
            built(vec![("IN", from)], to, move |mut args, at| converted(args.remove(0), scalar, rounding, beyond, at))
        });
    }
    None
}

/// Numbers in decimal digits of four bits.
fn bcd(call: &Call<'_>) -> Answer {
    use DataType as T;
    // The name, the types, the digits and whether there is a sign; by dialect.
    let s7 = |signed_word: &str| match signed_word {
        "WORD_BCD_TO_INT" | "BCD16_TO_INT" => Some((T::Word, T::Int, true)),
        "INT_TO_BCD_WORD" | "INT_TO_BCD16" => Some((T::Int, T::Word, false)),
        "DWORD_BCD_TO_DINT" | "BCD32_TO_DINT" => Some((T::DoubleWord, T::DoubleInt, true)),
        "DINT_TO_BCD_DWORD" | "DINT_TO_BCD32" => Some((T::DoubleInt, T::DoubleWord, false)),
        _ => None,
    };
    let (from, to, decodes) = match call.dialect {
        Dialect::Scl | Dialect::Tia => {
            let (from, to, decodes) = s7(call.name)?;
            return Some(s7_bcd(call, from, to, decodes));
        }
        Dialect::Iec => {
            if let Some((bits, number)) = call.name.split_once("_BCD_TO_") {
                (Some(named(bits, call.dialect)?), Some(named(number, call.dialect)?), true)
            } else if let Some((number, bits)) = call.name.split_once("_TO_BCD_") {
                (Some(named(number, call.dialect)?), Some(named(bits, call.dialect)?), false)
            } else if call.name == "IS_VALID_BCD" {
                return Some(is_valid_bcd(call));
            } else if let Some(number) = call.name.strip_suffix("_TO_BCD") {
                // As many bits as the number has.
                let number = named(number, call.dialect).filter(is_integer)?;
                let bits = match number.bits() {
                    8 => T::Byte,
                    16 => T::Word,
                    32 => T::DoubleWord,
                    _ => T::LongWord,
                };
                (Some(number), Some(bits), false)
            } else if let Some(number) = call.name.strip_prefix("BCD_TO_") {
                (None, Some(named(number, call.dialect)?), true)
            } else {
                (None, Some(named(call.name.strip_prefix("TO_BCD_")?, call.dialect)?), false)
            }
        }
        _ => match call.name {
            "BCD_TO_INT" => (Some(T::Byte), Some(T::Int), true),
            "BCD_TO_BYTE" => (Some(T::Byte), Some(T::Byte), true),
            "BCD_TO_WORD" => (Some(T::Word), Some(T::Word), true),
            "BCD_TO_DWORD" => (Some(T::DoubleWord), Some(T::DoubleWord), true),
            "INT_TO_BCD" => (Some(T::Int), Some(T::Byte), false),
            "BYTE_TO_BCD" => (Some(T::Byte), Some(T::Byte), false),
            "WORD_TO_BCD" => (Some(T::Word), Some(T::Word), false),
            "DWORD_TO_BCD" => (Some(T::DoubleWord), Some(T::DoubleWord), false),
            _ => return None,
        },
    };
    Some((|| {
        let given = call.bind(&["IN"])?;
        let from = match from {
            Some(from) => from,
            None => type_of(given[0]).ok_or_else(|| call.wrong(given[0], "a number"))?,
        };
        let to = to.unwrap_or(DataType::UnsignedInt);
        let (Some(source), Some(target)) = (scalar_of(&from, call.dialect), scalar_of(&to, call.dialect)) else {
            return Err(call.wrong(given[0], "a bit string or an integer"));
        };
        let codesys = call.dialect.base() == Dialect::Codesys;
        built(vec![("IN", from)], to, move |mut args, at| {
            let value = args.remove(0);
            if decodes {
                let digits = constant(u64::from(source.bits() / 4), Scalar::U8, at.span);
                let valid = compute(Op::IsBcd, vec![value.clone(), digits.clone()], Scalar::Bool, at.span);
                let number = compute(Op::BcdDecode, vec![value, digits], Scalar::U64, at.span);
                let wrong = constant(if codesys { u64::MAX } else { 0 }, Scalar::U64, at.span);
                let number = compute(Op::Select, vec![valid.clone(), number, wrong], Scalar::U64, at.span);
                let number = fail_if(number, Op::DivisorIsZero, vec![valid], at);
                return converted(
                    number,
                    target,
                    Rounding::Zero,
                    Beyond::LowBits,
                    &Building { checked: at.checked && !codesys, ..reborrow(at) },
                );
            }
            let most = 10_u64.checked_pow(target.bits() / 4).map_or(u64::MAX, |limit| limit - 1);
            let wide = converted(value, Scalar::U64, Rounding::Zero, Beyond::LowBits, at);
            let wide = fail_if(wide, Op::GtU64, vec![constant(most, Scalar::U64, at.span)], at);
            let digits = compute(Op::BcdEncode, vec![wide], Scalar::U64, at.span);
            converted(digits, target, Rounding::Zero, Beyond::LowBits, &Building { checked: false, ..reborrow(at) })
        })
    })())
}

/// Whether each four bits are a digit.
fn is_valid_bcd(call: &Call<'_>) -> Result<Resolved, Refusal> {
    let given = call.bind(&["IN"])?;
    let data_type = call.own(given[0], super::generic::Group::Bits, &DataType::Word)?;
    built(vec![("IN", data_type)], DataType::Bool, |mut args, at| {
        let value = args.remove(0);
        let digits = constant(u64::from(value.scalar.bits().div_ceil(4)), Scalar::U8, at.span);
        compute(Op::IsBcd, vec![value, digits], Scalar::Bool, at.span)
    })
}

/// The same surroundings for a moment.
fn reborrow<'a>(at: &'a mut Building<'_>) -> Building<'a> {
    Building { span: at.span, checked: at.checked, quotients: at.quotients, temporary: &mut *at.temporary }
}

/// BCD with a sign, as the instructions BTI, BTD, ITB and DTB.
fn s7_bcd(call: &Call<'_>, from: DataType, to: DataType, decodes: bool) -> Result<Resolved, Refusal> {
    call.bind(&["IN"])?;
    let long = matches!(from, DataType::DoubleWord | DataType::DoubleInt);
    let scalar = call.scalar(&to);
    built(vec![("IN", from)], to, move |mut args, at| {
        let value = args.remove(0);
        let (op, failed) = match (decodes, long) {
            (true, false) => (Op::BcdToI16, Op::IsBcd16),
            (true, true) => (Op::BcdToI32, Op::IsBcd32),
            (false, false) => (Op::I16ToBcd, Op::OverflowsBcd16),
            (false, true) => (Op::I32ToBcd, Op::OverflowsBcd32),
        };
        if decodes {
            let valid = compute(failed, vec![value.clone()], Scalar::Bool, at.span);
            return fail_if(compute(op, vec![value], scalar, at.span), Op::DivisorIsZero, vec![valid], at);
        }
        let value = fail_if(value, failed, Vec::new(), at);
        compute(op, vec![value], scalar, at.span)
    })
}

/// `X_TO_Y`, and `TO_Y` where the dialect has it.
fn by_name(call: &Call<'_>) -> Answer {
    // CODESYS has two names for what takes any type.
    let any = if call.dialect == Dialect::Codesys { call.name.strip_prefix("ANY_TO_") } else { None };
    let (from, to) = match any.or_else(|| call.name.strip_prefix("TO_")) {
        Some(to) => (None, to),
        None => {
            let (from, to) = call.name.split_once("_TO_")?;
            (Some(from), to)
        }
    };
    let dialect = call.dialect;
    let column = dialect.column();
    if from.is_none() && ![true, true, false, false][column] {
        return None;
    }
    let text = |word: &str| word == "STRING";
    let to_word = to;
    let target = named(to, dialect)?;
    if let Some(from) = from {
        named(from, dialect)?;
    }
    if dialect == Dialect::Scl && !text(to) && !from.is_some_and(text) {
        let listed = SCL.iter().find(|(word, _)| Some(*word) == from).is_some_and(|(_, targets)| targets.contains(&to));
        if !listed {
            return None;
        }
    }
    let rejects = |construct| dialect.judge(construct) == Judgement::Reject;
    if rejects(Construct::LongTypes) && DataType::from_word(to).is_none() || rejects(Construct::S5Time) && call.name.contains("S5TIME") {
        return None;
    }
    Some((|| {
        let given = call.bind(&["IN"])?;
        let source = match from {
            Some(word) => named(word, dialect).unwrap_or(DataType::Int),
            None => type_of(given[0]).ok_or_else(|| call.wrong(given[0], "a value"))?,
        };
        // DATE and DT count seconds as numbers, LDATE and LDT nanoseconds; where no name tells it, the type of the value does.
        let long = matches!(&given[0].kind, GivenKind::Typed(data_type) if data_type.counts_nanoseconds());
        let source_word = match (from, &source) {
            (Some(word), _) => word.to_owned(),
            (None, DataType::LongDate | DataType::LongDateAndTime) if !long => "DT".to_owned(),
            (None, source) => source.base().word().unwrap_or("INT").to_owned(),
        };
        if text(to) || matches!(source, DataType::String(_)) {
            return of_text(call, &source, &target, from.map(|word| word.starts_with('L')).or(long.then_some(true)));
        }
        // Dates of the S7 and LDT count from other days: blocks of the library.
        let by_library = dialect.switches().calendar == Calendar::S7
            && matches!(
                (&source, &target),
                (DataType::LongDateAndTime, DataType::Date | DataType::DateAndTime) | (DataType::DateAndTime, DataType::LongDateAndTime)
            );
        if let Some(block) = library::function(call.name, dialect).filter(|_| by_library) {
            return Ok(Resolved { parameters: Vec::new(), result: target, meaning: Meaning::Block(block) });
        }
        let none = || call.wrong(given[0], "a type that can be converted");
        let (Some(a), Some(b)) = (scalar_of(&source, dialect), scalar_of(&target, dialect)) else {
            let block = match (&source, &target) {
                (DataType::DateAndTime, DataType::Date) => "DT_DATE",
                (DataType::DateAndTime, DataType::TimeOfDay) => "DT_TOD",
                _ => return Err(none()),
            };
            return library::function(block, dialect)
                .map(|block| Resolved { parameters: Vec::new(), result: target.clone(), meaning: Meaning::Block(block) })
                .ok_or_else(none);
        };
        let by_block = match (&source, &target) {
            (DataType::S5Time, DataType::Time) => Some("S5TI_TIM"),
            (DataType::Time, DataType::S5Time) => Some("TIM_S5TI"),
            _ => None,
        };
        if let Some(block) = by_block.and_then(|name| library::function(name, dialect)) {
            return Ok(Resolved { parameters: Vec::new(), result: target.clone(), meaning: Meaning::Block(block) });
        }
        let units = match (unit(&source), unit(&target)) {
            (Some(from), Some(to)) => (from, to),
            (Some(from), None) => (from, counted(&source, &source_word)),
            (None, Some(to)) => (counted(&target, to_word), to),
            (None, None) => (1, 1),
        };
        let day_of = clock_of(&source, &target);
        let kinds = Kinds { source: source.clone(), target: target.clone(), a, b, dialect };
        built(vec![("IN", source)], target, move |mut args, at| {
            let mut value = args.remove(0);
            if let Some(rest) = day_of {
                let day = constant(DAY, Scalar::U64, at.span);
                let clock = compute(Op::RemU64, vec![value.clone(), day], Scalar::U64, at.span);
                value = if rest { clock } else { compute(Op::SubU64, vec![value, clock], Scalar::U64, at.span) };
            }
            if units.0 == units.1 { kinds.convert(value, at) } else { scaled(value, units, &kinds, at) }
        })
    })())
}

/// The types of a conversion.
struct Kinds {
    source: DataType,
    target: DataType,
    a: Scalar,
    b: Scalar,
    dialect: Dialect,
}

impl Kinds {
    fn convert(&self, value: Value, at: &mut Building<'_>) -> Value {
        let column = self.dialect.column();
        let bits = |data_type: &DataType| {
            matches!(
                data_type,
                DataType::Bool
                    | DataType::Byte
                    | DataType::Word
                    | DataType::DoubleWord
                    | DataType::LongWord
                    | DataType::Char
                    | DataType::WideChar
            )
        };
        let (from_bits, to_bits) = (bits(&self.source), bits(&self.target));
        if REAL_BY_BITS[column] && (from_bits || to_bits) && (is_real(self.a) || is_real(self.b)) && self.a.bits() == self.b.bits() {
            return Value { scalar: self.b, ..value };
        }
        if self.b == Scalar::Bool {
            let nonzero = NONZERO_IS_TRUE[column] || is_real(self.a);
            return match self.a {
                Scalar::Bool => value,
                Scalar::F32 => compute(Op::DifferF32, vec![value, constant(0, Scalar::F32, at.span)], Scalar::Bool, at.span),
                Scalar::F64 => compute(Op::DifferF64, vec![value, constant(0, Scalar::F64, at.span)], Scalar::Bool, at.span),
                _ if nonzero => compute(Op::IsNonzero, vec![value], Scalar::Bool, at.span),
                _ => compute(Op::LowestBit, vec![value], Scalar::Bool, at.span),
            };
        }
        // Bit strings are cut and filled without an error; so is everything in CODESYS.
        let checked = at.checked && !from_bits && !to_bits && self.dialect.base() != Dialect::Codesys;
        let at = &mut Building { checked, ..reborrow(at) };
        converted(value, self.b, ROUNDING[column], BEYOND[column], at)
    }
}

/// Nanoseconds that 1 of a time or date means; `None` for numbers, and for DATE of the S7, which counts days.
fn unit(data_type: &DataType) -> Option<u64> {
    use DataType as T;
    match data_type {
        T::Time | T::TimeOfDay => Some(MILLISECOND),
        T::LongTime | T::LongTimeOfDay | T::LongDate | T::LongDateAndTime => Some(1),
        _ => None,
    }
}

/// Nanoseconds that 1 of a number means that becomes a time or date, or comes of it: DATE and DT are seconds as numbers, although they are
/// nanoseconds inside, as LDATE and LDT are everywhere.
fn counted(data_type: &DataType, word: &str) -> u64 {
    match data_type {
        DataType::LongDate | DataType::LongDateAndTime if !word.starts_with('L') => SECOND,
        _ => unit(data_type).unwrap_or(1),
    }
}

/// A value in units of the first number of nanoseconds as one of the second.
fn scaled(value: Value, (from, to): (u64, u64), kinds: &Kinds, at: &mut Building<'_>) -> Value {
    let signed = is_signed(kinds.a) || is_real(kinds.a);
    let wide = if signed { Scalar::I64 } else { Scalar::U64 };
    let value = converted(value, wide, Rounding::HalfEven, Beyond::Nearest, at);
    let value = if from > to {
        compute(Op::MulU64, vec![value, constant(from / to, wide, at.span)], wide, at.span)
    } else if to > from {
        let op = if signed { Op::DivI64 } else { Op::DivU64 };
        compute(op, vec![value, constant(to / from, wide, at.span)], wide, at.span)
    } else {
        value
    };
    if kinds.b == Scalar::Bool && NONZERO_IS_TRUE[kinds.dialect.column()] {
        return compute(Op::IsNonzero, vec![value], Scalar::Bool, at.span);
    }
    converted(value, kinds.b, Rounding::HalfEven, Beyond::LowBits, at)
}

/// Whether a conversion takes the time of day (`true`) or the date (`false`) out of a point in time.
fn clock_of(source: &DataType, target: &DataType) -> Option<bool> {
    match (source, target) {
        (DataType::LongDateAndTime, DataType::TimeOfDay | DataType::LongTimeOfDay) => Some(true),
        (DataType::LongDateAndTime, DataType::LongDate) => Some(false),
        _ => None,
    }
}

/// A conversion to or from STRING, which is a block.
///
/// `long`: whether the name of the function tells a type with L, whose text has nanoseconds where the other one has milliseconds. Where the
/// name tells no type, DT and LDT are one: the text is a DT with all its digits.
fn of_text(call: &Call<'_>, source: &DataType, target: &DataType, long: Option<bool>) -> Result<Resolved, Refusal> {
    let dialect = call.dialect;
    let s7 = matches!(dialect, Dialect::Scl | Dialect::Tia);
    let class = |data_type: &DataType| {
        let scalar = scalar_of(data_type, dialect);
        match data_type.base() {
            DataType::Bool => Some("BOOL"),
            DataType::Char => Some("CHAR"),
            DataType::Real => Some("REAL"),
            DataType::LongReal => Some("LREAL"),
            DataType::Byte | DataType::Word | DataType::DoubleWord | DataType::LongWord
                if matches!(dialect, Dialect::Iec | Dialect::Tia) =>
            {
                Some("LWORD")
            }
            DataType::Byte | DataType::Word | DataType::DoubleWord | DataType::LongWord if dialect == Dialect::Codesys => Some("ULINT"),
            DataType::Time => Some("TIME"),
            DataType::TimeOfDay => Some("TOD"),
            DataType::LongTime => Some("LTIME"),
            DataType::LongTimeOfDay => Some("LTOD"),
            DataType::LongDate if long == Some(true) => Some("LDATE"),
            DataType::LongDateAndTime if long == Some(true) => Some("LDT"),
            DataType::LongDateAndTime if long.is_none() && matches!(target, DataType::String(_)) => Some("MOMENT"),
            DataType::LongDate => Some("DATE"),
            DataType::LongDateAndTime => Some("DT"),
            other if is_integer(other) => Some(if scalar.is_some_and(is_signed) { "LINT" } else { "ULINT" }),
            _ => None,
        }
    };
    let other = if matches!(target, DataType::String(_)) { source } else { target };
    let name: Option<String> = match (source, target) {
        (DataType::SmallInt | DataType::Int, DataType::String(_)) if s7 => Some("I_STRNG".to_owned()),
        (DataType::LongInt, DataType::String(_)) if s7 => Some("TIA_LINT_TO_STRING".to_owned()),
        (DataType::DoubleInt, DataType::String(_)) if s7 => Some("DI_STRNG".to_owned()),
        (DataType::Real, DataType::String(_)) if s7 => Some("R_STRNG".to_owned()),
        (DataType::String(_), DataType::Int) if s7 => Some("STRNG_I".to_owned()),
        (DataType::String(_), DataType::DoubleInt) if s7 => Some("STRNG_DI".to_owned()),
        // STRNG_R takes only texts of fourteen characters, as R_STRNG writes them.
        (DataType::String(_), DataType::Real) if dialect == Dialect::Scl => Some("STRNG_R".to_owned()),
        (_, DataType::String(_)) => class(other).map(|class| format!("{class}_TO_STRING")),
        _ if unit(target).is_some() => class(target).map(|class| format!("STRING_TO_{class}")),
        _ => target.word().map(|word| format!("STRING_TO_{word}")),
    };
    let Some(block) = name.and_then(|name| library::function(&name, dialect)) else {
        return Err(call.wrong(&call.arguments[0], "a type that has a form as text"));
    };
    let result = if matches!(target, DataType::String(_)) { DataType::String(STRING_LENGTH_MAX) } else { target.clone() };
    Ok(Resolved { parameters: Vec::new(), result, meaning: Meaning::Block(block) })
}
