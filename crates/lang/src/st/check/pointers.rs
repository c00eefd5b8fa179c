//! Pointers of codesys as numbers: sums, differences, comparisons with 0 and with each other.

use sieben_engine::ir::Op;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::Checker;
use super::memory::{number, two};
use super::operators::convert;
use super::typed::{Target, Through, Typed};
use super::types::{Class, Kind};
use crate::st::ast::BinaryOperator;
use crate::st::standard::build::compute;
use crate::st::standard::operators::Operation;
use crate::st::tree::{Scalar, Value, ValueKind};

/// Bits from one byte to the next in a pointer.
const BYTE: i64 = 8;

impl Checker<'_> {
    /// 0 beside a reference is NULL.
    pub(super) fn zero_as_null(&self, a: Typed, b: &Typed) -> Typed {
        let beside = matches!(b, Typed::Scalar { data_type: DataType::Reference(_), .. });
        match a {
            Typed::Integer { value: 0, .. } if beside && self.dialect.has_pointers() => Typed::Null,
            other => other,
        }
    }

    /// `p + 4`, `p - 4`, in bytes, and `p - q`; `None` if this is none of them.
    pub(super) fn pointer_sum(&self, operator: BinaryOperator, (a, left): (&Typed, Span), (b, right): (&Typed, Span)) -> Option<Typed> {
        if !self.dialect.has_pointers() {
            return None;
        }
        let span = left.to(right);
        let shifted = |operation: Operation, pointer: Value, bytes: Value, data_type: &DataType| {
            let bits = two(Operation::Multiply, bytes, number(BYTE, Scalar::I64, span), span);
            let sum = two(operation, Value { scalar: Scalar::I64, ..pointer }, bits, span);
            Typed::Scalar { value: Value { scalar: Scalar::U64, ..sum }, data_type: data_type.clone() }
        };
        match (operator, a, b) {
            (BinaryOperator::Subtract, Typed::Scalar { value: x, data_type: p }, Typed::Scalar { value: y, data_type: q })
                if is_pointer(p) && is_pointer(q) =>
            {
                let [x, y] = side_by_side((x, p), (y, q)).map(|value| Value { scalar: Scalar::I64, ..value });
                let bits = two(Operation::Subtract, x, y, span);
                let bytes = two(Operation::Divide, bits, number(BYTE, Scalar::I64, span), span);
                Some(Typed::Scalar { value: convert(bytes, Scalar::I32), data_type: DataType::DoubleInt })
            }
            (BinaryOperator::Add | BinaryOperator::Subtract, Typed::Scalar { value, data_type }, other) if is_pointer(data_type) => {
                let bytes = as_bytes(other, right)?;
                let operation = if operator == BinaryOperator::Add { Operation::Add } else { Operation::Subtract };
                Some(shifted(operation, value.clone(), bytes, data_type))
            }
            (BinaryOperator::Add, other, Typed::Scalar { value, data_type }) if is_pointer(data_type) => {
                let bytes = as_bytes(other, left)?;
                Some(shifted(Operation::Add, value.clone(), bytes, data_type))
            }
            _ => None,
        }
    }

    /// Pointers in one order or another, whatever they point to.
    pub(super) fn pointers_compared(&self, operator: BinaryOperator, a: &Typed, b: &Typed, span: Span) -> Option<Value> {
        let (Typed::Scalar { value: x, data_type: p }, Typed::Scalar { value: y, data_type: q }) = (a, b) else { return None };
        if !is_pointer(p) || !is_pointer(q) || !self.dialect.has_pointers() {
            return None;
        }
        let [x, y] = side_by_side((x, p), (y, q));
        // The number of a data block is above all bytes: in one of them the one that comes first is less.
        Some(match operator {
            BinaryOperator::Equal => compute(Op::Equal, vec![x, y], Scalar::Bool, span),
            BinaryOperator::NotEqual => compute(Op::Differ, vec![x, y], Scalar::Bool, span),
            BinaryOperator::Less => two(Operation::Less, x, y, span),
            BinaryOperator::LessEqual => two(Operation::LessEqual, x, y, span),
            BinaryOperator::Greater => two(Operation::Greater, x, y, span),
            BinaryOperator::GreaterEqual => two(Operation::GreaterEqual, x, y, span),
            _ => return None,
        })
    }
}

impl Checker<'_> {
    /// Says of a 0 that is written through a pointer, in a block that counts through the characters of a text, that it ends no text.
    pub(super) fn end_of_text(&mut self, target: &Target, value: &Typed, span: Span) {
        let character = matches!(
            target.data_type,
            DataType::Byte | DataType::Char | DataType::SmallInt | DataType::UnsignedSmallInt | DataType::WideChar
        );
        if self.counts_characters && character && target.through == Through::Reference && matches!(value, Typed::Integer { value: 0, .. }) {
            self.counts_characters = false;
            self.report(Problem::P6328, span, "a 0 behind the characters does not end a text here: its length stands in front of them");
        }
    }
}

/// Whether a type is POINTER TO something.
pub(super) fn is_pointer(data_type: &DataType) -> bool {
    matches!(data_type, DataType::Reference(reference) if reference.kind == ReferenceKind::Pointer)
}

/// Two pointers for one operation: where only one of them is to texts, both as addresses of bytes.
fn side_by_side((x, p): (&Value, &DataType), (y, q): (&Value, &DataType)) -> [Value; 2] {
    let (x, y) = (x.clone(), y.clone());
    if lengths(p) == lengths(q) { [x, y] } else { [seen_as(x, lengths(p)), seen_as(y, lengths(q))] }
}

/// A pointer to something as a pointer to something else: the address of a text is that of its first character for all but POINTER TO STRING.
/// A structure is where the text is that it begins with, lengths and all.
pub(super) fn pointer_as(value: Value, from: &DataType, wanted: &DataType) -> Value {
    if is_to_structure(from) || is_to_structure(wanted) { value } else { seen_as(value, lengths(from) - lengths(wanted)) }
}

/// Whether a pointer is one to variables of several types.
fn is_to_structure(pointer: &DataType) -> bool {
    let DataType::Reference(reference) = pointer else { return false };
    matches!(reference.target, DataType::Struct(_) | DataType::Instance { .. })
}

/// Whether a pointer to texts becomes one to something else.
pub(super) fn leaves_text(from: &DataType, wanted: &DataType) -> bool {
    lengths(from) > lengths(wanted)
}

/// A pointer so many bits further on, or NULL.
fn seen_as(mut value: Value, bits: i64) -> Value {
    match &mut value.kind {
        _ if bits == 0 => value,
        ValueKind::AddressOf(place) if bits > 0 => {
            place.offset += u32::try_from(bits).expect("the lengths of a text are few bits");
            value
        }
        _ => {
            let (scalar, span) = (value.scalar, value.span);
            let null = Value { kind: ValueKind::Constant(0), scalar, span };
            let points = convert(compute(Op::Differ, vec![value.clone(), null], Scalar::Bool, span), Scalar::I64);
            let distance = two(Operation::Multiply, points, number(bits, Scalar::I64, span), span);
            let sum = two(Operation::Add, Value { scalar: Scalar::I64, ..value }, distance, span);
            Value { scalar, ..sum }
        }
    }
}

/// Bits with the lengths of a text, in front of its characters, where a pointer is one to texts.
fn lengths(pointer: &DataType) -> i64 {
    let DataType::Reference(reference) = pointer else { return 0 };
    let target = match &reference.target {
        DataType::Array { element, .. } => element,
        other => other,
    };
    match target {
        DataType::String(_) => 16,
        DataType::WideString(_) => 32,
        _ => 0,
    }
}

/// Whether a type is as wide as an address.
pub(super) fn is_address(data_type: &DataType) -> bool {
    matches!(data_type, DataType::LongWord | DataType::UnsignedLongInt)
}

/// A whole number as I64.
fn as_bytes(typed: &Typed, span: Span) -> Option<Value> {
    match typed {
        Typed::Integer { value, .. } => Some(number(i64::try_from(*value).ok()?, Scalar::I64, span)),
        Typed::Scalar { value, data_type } => {
            let kind = Kind::of(data_type)?;
            let whole = kind.is_integer() || kind.class == Class::Bits && kind.bits > 1;
            whole.then(|| convert(value.clone(), Scalar::I64))
        }
        _ => None,
    }
}
