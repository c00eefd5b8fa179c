//! Reasons of calculations, conversions, shifts, word logic and comparisons.

use sieben_model::extension::Relation;
use sieben_model::literal::Value;

use super::telling::Telling;
use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words, real};
use crate::stl::operands::Operand;
use crate::stl::why::{Number, Sign, Why};

/// The sentences of a statement that works on the accumulators; none if it does not.
pub(super) fn clauses(telling: &Telling<'_>, why: Why) -> Vec<Clause> {
    let (before, after) = (telling.before(), telling.after());
    let constant = constant(telling);
    match why {
        Why::SwapBytes(kind) => {
            vec![Clause::new(S::SwapBytes).with("before", hex(kind, before.accu1)).with("accu1", hex(Number::Double, after.accu1))]
        }
        Why::Step(sign) => {
            vec![calculation(S::Step, sign, [(before.accu1 & 0xFF).to_string(), constant.to_string()], (after.accu1 & 0xFF).to_string())]
        }
        Why::AddConstant(kind) => {
            let numbers = [number(kind, before.accu1), constant.to_string()];
            vec![calculation(S::AddConstant, Sign::Add, numbers, number(kind, after.accu1))]
        }
        Why::Arithmetic(Number::Real, sign) => {
            let numbers = [real(before.accu2), real(before.accu1)];
            vec![calculation(S::Calculate, sign, numbers, real(after.accu1)), real_status(telling)]
        }
        Why::Arithmetic(kind, sign) => integers(telling, kind, sign),
        Why::Negate(Number::Real) => vec![unary(S::Negate, real(before.accu1), real(after.accu1))],
        Why::Negate(kind) => {
            let exact = -signed(kind, before.accu1);
            let mut clauses = vec![unary(S::Negate, number(kind, before.accu1), exact.to_string())];
            clauses.push(integer_status(telling, kind, kind));
            clauses
        }
        Why::Invert(kind) => vec![unary(S::Invert, hex(kind, before.accu1), hex(kind, after.accu1))],
        Why::Absolute => vec![unary(S::Function, real(before.accu1), real(after.accu1)).with("function", "ABS")],
        Why::Function(name) => {
            vec![unary(S::Function, real(before.accu1), real(after.accu1)).with("function", name), real_status(telling)]
        }
        Why::FromBcd(kind) => vec![unary(S::FromBcd, bcd(kind, before.accu1), number(kind, after.accu1))],
        Why::ToBcd(kind) => {
            let digits = if kind == Number::Int { 3 } else { 7 };
            match after.ov {
                1 => vec![Clause::new(S::ToBcdTooLarge).with("a", number(kind, before.accu1)).with("digits", digits)],
                _ => vec![unary(S::ToBcd, number(kind, before.accu1), bcd(kind, after.accu1))],
            }
        }
        Why::Widen => {
            vec![Clause::new(S::Widen).with("a", number(Number::Int, before.accu1)).with("accu1", hex(Number::Double, after.accu1))]
        }
        Why::ToReal => vec![unary(S::ToReal, number(Number::Double, before.accu1), real(after.accu1))],
        Why::Round(rounding) => match after.ov {
            1 => vec![Clause::new(S::RoundTooLarge).with("a", real(before.accu1))],
            _ => {
                let clause = unary(S::Round, real(before.accu1), number(Number::Double, after.accu1));
                vec![clause.with("rounding", rounding.words())]
            }
        },
        Why::Shift(kind, way) => shift(telling, S::Shift, kind).map(|clause| clause.with("way", way.words())).into(),
        Why::ShiftSigned(kind) => shift(telling, S::ShiftSigned, kind).into(),
        Why::Rotate(way) => shift(telling, S::Rotate, Number::Double).map(|clause| clause.with("way", way.words())).into(),
        Why::RotateThrough(way) => {
            let clause = unary(S::RotateThrough, hex(Number::Double, before.accu1), hex(Number::Double, after.accu1));
            vec![clause.with("way", way.words())]
        }
        Why::WordLogic(joint, kind) => {
            let other = match telling.operand() {
                Operand::Constant(value) => u64::from(value.accumulator().unwrap_or(0)),
                _ => before.accu2,
            };
            let sentence = if after.cc1 == 1 { S::WordLogicSome } else { S::WordLogicNone };
            let clause = unary(sentence, hex(kind, before.accu1), hex(kind, after.accu1));
            vec![clause.with("b", hex(kind, other)).with("joint", joint.words())]
        }
        Why::Compare(kind, relation) => vec![compare(telling, kind, relation)],
        _ => Vec::new(),
    }
}

/// The number of a constant operand, or 0.
fn constant(telling: &Telling<'_>) -> i64 {
    match telling.operand() {
        Operand::Constant(Value::Int(number)) => i64::from(*number),
        Operand::Constant(Value::DoubleInt(number)) => i64::from(*number),
        _ => 0,
    }
}

fn signed(kind: Number, bits: u64) -> i64 {
    match kind {
        Number::Int => i64::from(bits as u16 as i16),
        _ => i64::from(bits as u32 as i32),
    }
}

fn unary(sentence: S, a: String, result: String) -> Clause {
    Clause::new(sentence).with("a", a).with("result", result)
}

fn calculation(sentence: S, sign: Sign, [a, b]: [String; 2], result: String) -> Clause {
    // A sign before the second number would read as another operation.
    let b = if b.starts_with('-') { format!("({b})") } else { b };
    unary(sentence, a, result).with("b", b).with("sign", sign.sign())
}

/// A BCD number with its sign.
fn bcd(kind: Number, bits: u64) -> String {
    let (digits, sign) = if kind == Number::Int { (3, bits >> 15 & 1) } else { (7, bits >> 31 & 1) };
    let number = bits & ((1 << (digits * 4)) - 1);
    format!("{}{number:0width$X}", if sign == 1 { "-" } else { "" }, width = digits as usize)
}

fn integers(telling: &Telling<'_>, kind: Number, sign: Sign) -> Vec<Clause> {
    let (before, after) = (telling.before(), telling.after());
    let (a, b) = (signed(kind, before.accu2), signed(kind, before.accu1));
    if matches!(sign, Sign::Divide | Sign::Modulo) && b == 0 {
        return vec![Clause::new(S::DivideByZero).with("a", a.to_string())];
    }
    let exact = match sign {
        Sign::Add => a + b,
        Sign::Subtract => a - b,
        Sign::Multiply => a * b,
        Sign::Divide => a / b,
        Sign::Modulo => a % b,
    };
    let numbers = [a.to_string(), b.to_string()];
    let first = match (kind, sign, after.ov) {
        (Number::Int, Sign::Divide, 0) => {
            let remainder = number(Number::Int, after.accu1 >> 16);
            calculation(S::DivideInt, sign, numbers, exact.to_string()).with("remainder", remainder)
        }
        _ => calculation(S::Calculate, sign, numbers, exact.to_string()),
    };
    vec![first, integer_status(telling, kind, if sign == Sign::Multiply { Number::Double } else { kind })]
}

/// What CC 1, CC 0 and OV say of the result of integers; ACCU 1 is shown as `shown`: the product of two 16-bit integers has 32 bits.
fn integer_status(telling: &Telling<'_>, kind: Number, shown: Number) -> Clause {
    let after = telling.after();
    if after.ov == 1 {
        let bits = if kind == Number::Int { 16 } else { 32 };
        return Clause::new(S::TooLarge).with("bits", bits).with("value", number(shown, after.accu1));
    }
    Clause::new(sign_of(after.cc1, after.cc0))
}

fn sign_of(cc1: u64, cc0: u64) -> S {
    match (cc1, cc0) {
        (1, _) => S::Positive,
        (_, 1) => S::Negative,
        _ => S::Zero,
    }
}

/// What CC 1, CC 0 and OV say of a REAL result.
fn real_status(telling: &Telling<'_>) -> Clause {
    let after = telling.after();
    let result = f32::from_bits(after.accu1 as u32);
    Clause::new(match after.ov {
        1 if result.is_nan() => S::RealNone,
        1 if result.is_infinite() => S::RealInfinite,
        1 => S::RealTiny,
        _ => sign_of(after.cc1, after.cc0),
    })
}

/// The one or two clauses of a shift.
fn shift(telling: &Telling<'_>, sentence: S, kind: Number) -> [Clause; 1] {
    let (before, after) = (telling.before(), telling.after());
    let count = match telling.operand() {
        Operand::None => before.accu2 & 0xFF,
        _ => constant(telling).unsigned_abs(),
    };
    [match count {
        0 => Clause::new(S::ShiftNothing),
        _ => unary(sentence, hex(kind, before.accu1), hex(kind, after.accu1)).with("count", count),
    }]
}

/// A relation in words, and the words if it does not hold.
fn relation_words(relation: Relation) -> [[&'static str; 2]; 2] {
    match relation {
        Relation::Equal | Relation::EqualReal => [["is equal to", "ist gleich"], ["is not equal to", "ist nicht gleich"]],
        Relation::NotEqual => [["differs from", "ist verschieden von"], ["does not differ from", "ist nicht verschieden von"]],
        Relation::Less => [["is less than", "ist kleiner als"], ["is not less than", "ist nicht kleiner als"]],
        Relation::Greater => [["is greater than", "ist größer als"], ["is not greater than", "ist nicht größer als"]],
        Relation::LessEqual => {
            [["is less than or equal to", "ist kleiner oder gleich"], ["is not less than or equal to", "ist nicht kleiner oder gleich"]]
        }
        Relation::GreaterEqual => {
            [["is greater than or equal to", "ist größer oder gleich"], ["is not greater than or equal to", "ist nicht größer oder gleich"]]
        }
    }
}

fn compare(telling: &Telling<'_>, kind: Number, relation: Relation) -> Clause {
    let (before, after) = (telling.before(), telling.after());
    let [a, b] = [before.accu2, before.accu1];
    let order = match kind {
        Number::Real => f32::from_bits(a as u32).partial_cmp(&f32::from_bits(b as u32)),
        _ => Some(signed(kind, a).cmp(&signed(kind, b))),
    };
    let holds = order.map(|order| match relation {
        Relation::Equal | Relation::EqualReal => order.is_eq(),
        Relation::NotEqual => order.is_ne(),
        Relation::Less => order.is_lt(),
        Relation::Greater => order.is_gt(),
        Relation::LessEqual => order.is_le(),
        Relation::GreaterEqual => order.is_ge(),
    });
    let sentence = match holds {
        // A CPU that compares by the difference may come to something else than the two numbers do.
        Some(holds) if u64::from(holds) != after.rlo => S::CompareDifference,
        Some(true) => S::CompareTrue,
        Some(false) => S::CompareFalse,
        None if after.rlo == 0 && after.ov == 1 => S::CompareNone,
        None => S::CompareDifference,
    };
    let [relation, relation_not] = relation_words(relation).map(Words::from);
    let clause = Clause::new(sentence).with("a", number(kind, a)).with("b", number(kind, b));
    clause.with("relation", relation).with("relation_not", relation_not)
}

/// A number of an accumulator in its usual notation.
fn number(kind: Number, bits: u64) -> String {
    match kind {
        Number::Int => (bits as u16 as i16).to_string(),
        Number::Double => (bits as u32 as i32).to_string(),
        Number::Real => real(bits),
    }
}

/// The bits of a word or double word.
fn hex(kind: Number, bits: u64) -> String {
    match kind {
        Number::Int => format!("16#{:04X}", bits as u16),
        _ => format!("16#{:08X}", bits as u32),
    }
}
