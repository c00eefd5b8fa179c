//! Types of the values in the accumulators, followed through a block: a REAL instruction on an integer and its like.

use sieben_model::address::Width;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::flow;
use super::pins::Wired;
use crate::stl::instructions::Instruction as I;
use crate::stl::lower::Statement;
use crate::stl::operands::Operand;

/// What is sure about the type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Nothing: bytes and words may hold anything.
    Any,
    /// 16 bits; the upper half of the accumulator is no extension of the sign.
    Int,
    /// 32 bits.
    DoubleInt,
    Real,
}

/// A value in an accumulator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Held {
    kind: Kind,
    /// The constant that was loaded.
    constant: Option<i64>,
    /// The statement that brought it.
    from: usize,
}

const NOTHING: Held = Held { kind: Kind::Any, constant: None, from: 0 };

type Accumulators = [Held; 4];

/// What is known of the operands of the statements.
pub(super) struct Operands {
    /// The declared type of each.
    pub(super) types: Vec<Option<DataType>>,
    /// The pin of a diagram that each is wired to.
    pub(super) wired: Vec<Option<Wired>>,
}

/// Reports instructions that take the value in an accumulator for one of another type.
pub(super) fn check(statements: &[Statement], operands: &Operands, four: bool, diagnostics: &mut Vec<Diagnostic>) {
    let Operands { types, wired } = operands;
    let step = |index: usize, held: &Accumulators| after(index, &statements[index], types[index].as_ref(), *held, four);
    let states = flow::states(statements, [NOTHING; 4], step, join);
    for (index, (statement, state)) in statements.iter().zip(states).enumerate() {
        let Some(held) = state else { continue };
        let Some(Wrong { message, holds, from }) = wrong(statement, types[index].as_ref(), &held) else { continue };
        // In a diagram pins have names, and accumulators are not seen.
        let pin = wired[index].map(|pin| pin.gives(holds)).or_else(|| Some(wired.get(from).copied()??.holds(holds)));
        let diagnostic = Diagnostic::new(Problem::P4022, statement.span(), pin.clone().unwrap_or(message));
        diagnostics.push(match statements.get(from) {
            Some(from) if pin.is_none() => diagnostic.related(from.span(), "loaded here"),
            _ => diagnostic,
        });
    }
}

fn join(known: &mut Accumulators, more: &Accumulators) -> bool {
    let before = *known;
    for (known, more) in known.iter_mut().zip(more) {
        if known.kind != more.kind || known.constant != more.constant {
            *known = if known.kind == more.kind { Held { constant: None, ..*known } } else { NOTHING };
        }
    }
    before != *known
}

/// What a statement calculates with, and whether with two accumulators; `None` if its name does not say.
fn operands(instruction: I) -> Option<(Kind, bool)> {
    let name = instruction.english();
    match name {
        "ABS" | "NEGR" | "SQR" | "SQRT" | "EXP" | "LN" | "SIN" | "COS" | "TAN" | "ASIN" | "ACOS" | "ATAN" => Some((Kind::Real, false)),
        "RND" | "RND+" | "RND-" | "TRUNC" => Some((Kind::Real, false)),
        "NEGI" | "ITD" | "ITB" => Some((Kind::Int, false)),
        "NEGD" | "DTR" | "DTB" => Some((Kind::DoubleInt, false)),
        "MOD" => Some((Kind::DoubleInt, true)),
        _ => {
            let (sign, letter) = name.split_at_checked(name.len().saturating_sub(1))?;
            let kind = match letter {
                "I" => Kind::Int,
                "D" => Kind::DoubleInt,
                "R" => Kind::Real,
                _ => return None,
            };
            matches!(sign, "+" | "-" | "*" | "/" | "==" | "<>" | ">" | "<" | ">=" | "<=").then_some((kind, true))
        }
    }
}

/// What is wrong with a statement.
struct Wrong {
    message: String,
    /// What the accumulator holds.
    holds: &'static str,
    /// The statement that the value comes from.
    from: usize,
}

fn wrong(statement: &Statement, declared: Option<&DataType>, held: &Accumulators) -> Option<Wrong> {
    let word = statement.instruction.english();
    let first = |holds, message: String| Some(Wrong { message, holds, from: held[0].from });
    if let Some((wanted, two)) = operands(statement.instruction) {
        let used = if two { &held[..2] } else { &held[..1] };
        for (index, value) in used.iter().enumerate() {
            if let Some(what) = misfit(wanted, value, two.then(|| &held[1 - index])) {
                let works = match wanted {
                    Kind::Int => "16-bit integers",
                    Kind::DoubleInt => "32-bit integers",
                    _ => "REAL numbers",
                };
                let message = format!("`{word}` works with {works}, but ACCU {} holds {what}", index + 1);
                return Some(Wrong { message, holds: what, from: value.from });
            }
        }
    }
    match (statement.instruction, declared.map(kind)) {
        (I::Transfer, Some(Kind::Real)) if held[0].kind == Kind::Int || held[0].kind == Kind::DoubleInt => {
            let zero = held[0].constant == Some(0);
            if zero { None } else { first("an integer", "the variable is a REAL, but ACCU 1 holds an integer".to_owned()) }
        }
        (I::Transfer, Some(Kind::Int | Kind::DoubleInt)) if held[0].kind == Kind::Real && held[0].constant != Some(0) => {
            first("a REAL", "the variable is an integer, but ACCU 1 holds a REAL".to_owned())
        }
        (I::AddIntConstant | I::AddDoubleConstant, _) if held[0].kind == Kind::Real => {
            first("a REAL", format!("`{word}` adds an integer, but ACCU 1 holds a REAL"))
        }
        _ => None,
    }
}

/// What a value is, if it cannot be what is wanted. The bits of 0 are the same in every type.
fn misfit(wanted: Kind, value: &Held, other: Option<&Held>) -> Option<&'static str> {
    if value.constant == Some(0) {
        return None;
    }
    match (wanted, value.kind) {
        (Kind::Real, Kind::Int) => Some("a 16-bit integer"),
        (Kind::Real, Kind::DoubleInt) => Some("a 32-bit integer"),
        (Kind::Int | Kind::DoubleInt, Kind::Real) => Some("a REAL"),
        // Only the low word counts: right for a number that fits it.
        (Kind::Int, Kind::DoubleInt) if value.constant.is_some_and(|number| i16::try_from(number).is_err()) => {
            Some("a number that needs 32 bits")
        }
        // `L -1` fills the upper word with zeros.
        (Kind::DoubleInt, Kind::Int) if value.constant.is_some_and(|number| number < 0) => {
            Some("a negative 16-bit constant, whose upper half is 0 (write it with `L#`)")
        }
        (Kind::DoubleInt, Kind::Int) if value.constant.is_none() && other.is_none_or(|other| other.kind == Kind::DoubleInt) => {
            Some("a 16-bit integer, whose upper half is no extension of its sign (`ITD` makes it one)")
        }
        _ => None,
    }
}

fn kind(data_type: &DataType) -> Kind {
    match data_type.base() {
        DataType::Int => Kind::Int,
        DataType::DoubleInt | DataType::Time => Kind::DoubleInt,
        DataType::Real => Kind::Real,
        _ => Kind::Any,
    }
}

fn constant(value: &Value, from: usize) -> Held {
    let (kind, constant) = match value {
        Value::Int(number) => (Kind::Int, Some(i64::from(*number))),
        Value::DoubleInt(number) => (Kind::DoubleInt, Some(i64::from(*number))),
        Value::Time(number) => (Kind::DoubleInt, Some(i64::from(*number))),
        Value::Real(number) => (Kind::Real, (number.to_bits() == 0).then_some(0)),
        _ => (Kind::Any, None),
    };
    Held { kind, constant, from }
}

/// The accumulators behind a statement.
fn after(index: usize, statement: &Statement, declared: Option<&DataType>, held: Accumulators, four: bool) -> Accumulators {
    let [one, two, three, fourth] = held;
    let of = |kind| Held { kind, constant: None, from: index };
    // Arithmetic with two operands closes the gap on a CPU with four accumulators.
    let result = |kind| if four { [of(kind), three, fourth, fourth] } else { [of(kind), two, three, fourth] };
    match statement.instruction {
        I::Load => {
            let loaded = match &statement.operand {
                Operand::Constant(value) => constant(value, index),
                Operand::Memory(access) => {
                    let kind = declared.map_or(Kind::Any, kind);
                    // A byte of something larger is no number of its type.
                    let fits = matches!((kind, access.width), (Kind::Int, Width::Word) | (Kind::DoubleInt | Kind::Real, Width::DoubleWord));
                    if fits { of(kind) } else { NOTHING }
                }
                _ => NOTHING,
            };
            [loaded, one, three, fourth]
        }
        I::LoadStatusWord | I::LoadDataBlockInfo | I::LoadBcd | I::TransferAr1 | I::TransferAr2 => [NOTHING, one, three, fourth],
        I::Swap => [two, one, three, fourth],
        I::Push if four => [one, one, two, three],
        I::Push => [one, one, three, fourth],
        I::Pop if four => [two, three, fourth, fourth],
        I::Pop => [two, two, three, fourth],
        I::Enter if four => [one, two, two, three],
        I::Leave if four => [one, three, fourth, fourth],
        I::AddInt | I::SubtractInt | I::DivideInt => result(Kind::Int),
        // The product has 32 bits.
        I::MultiplyInt => result(Kind::Any),
        I::AddDouble | I::SubtractDouble | I::MultiplyDouble | I::DivideDouble | I::Modulo => result(Kind::DoubleInt),
        I::AddReal | I::SubtractReal | I::MultiplyReal | I::DivideReal => result(Kind::Real),
        I::NegateInt => [of(Kind::Int), two, three, fourth],
        I::IntToDouble | I::NegateDouble | I::Round | I::RoundUp | I::RoundDown | I::Truncate | I::BcdToDouble => {
            [of(Kind::DoubleInt), two, three, fourth]
        }
        I::BcdToInt => [of(Kind::Int), two, three, fourth],
        I::DoubleToReal => [of(Kind::Real), two, three, fourth],
        I::AddIntConstant | I::AddDoubleConstant => [Held { constant: None, ..one }, two, three, fourth],
        instruction if operands(instruction) == Some((Kind::Real, false)) => [of(Kind::Real), two, three, fourth],
        // `__FEATURE` loads, and may change the number of accumulators.
        I::Call | I::CallUnconditional | I::CallConditional | I::Extension => [NOTHING; 4],
        instruction if changes_accu1(instruction) => [NOTHING, two, three, fourth],
        _ => held,
    }
}

/// Whether an instruction may change ACCU 1, of those that have no rule of their own.
fn changes_accu1(instruction: I) -> bool {
    match operands(instruction) {
        // Comparisons keep the accumulators.
        Some((_, two)) => !two,
        None => matches!(
            instruction,
            I::SwapBytesWord
                | I::SwapBytesDouble
                | I::Increment
                | I::Decrement
                | I::InvertInt
                | I::InvertDouble
                | I::ShiftSignedInt
                | I::ShiftSignedDouble
                | I::ShiftLeftWord
                | I::ShiftRightWord
                | I::ShiftLeftDouble
                | I::ShiftRightDouble
                | I::RotateLeft
                | I::RotateRight
                | I::RotateLeftThroughCc
                | I::RotateRightThroughCc
                | I::AndWord
                | I::OrWord
                | I::XorWord
                | I::AndDouble
                | I::OrDouble
                | I::XorDouble
                | I::Loop
        ),
    }
}
