//! Elements of ARRAY[*], LOWER_BOUND and UPPER_BOUND, and the bounds that a call gives.

use sieben_engine::ir::Op;
use sieben_model::interface::{Interface, Variable};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::memory::two;
use super::names::Entity;
use super::operators::convert;
use super::places::{Reached, element_step};
use super::typed::{Target, Through, Typed};
use crate::st::ast::{self, Expression};
use crate::st::open_arrays::{End, bound_name, is_open};
use crate::st::standard::build::compute;
use crate::st::standard::operators::Operation;
use crate::st::tree::{Argument, Bounds, Index, Place, Scalar, Statement, Value, ValueKind};

/// Bits that any array has at most: an index below this many elements is in range where its bounds were looked at.
const ARRAY_BITS_MAX: u32 = 1 << 20;

/// What an index is above that is out of its range.
const OUTSIDE: i64 = 0x4000_0000;

impl Checker<'_> {
    /// A bound of an array as I32; `None` if the array is not open.
    pub(super) fn bound(&self, target: &Target, dimension: usize, end: End, span: Span) -> Option<Value> {
        let DataType::Array { bounds, .. } = &target.data_type else { return None };
        if !is_open(&target.data_type) {
            let &(low, high) = bounds.get(dimension - 1)?;
            let bound = if end == End::Low { low } else { high };
            return Some(number(i64::from(bound), Scalar::I32, span));
        }
        let Some(Entity::Variable(variable)) = self.names.local(&bound_name(&target.name, dimension, end)) else { return None };
        let place = Place { base: variable.base, offset: variable.offset, indexes: Vec::new(), span };
        Some(Value { kind: ValueKind::Load(place), scalar: Scalar::I32, span })
    }

    /// An element of an open array: one index from 0 over all dimensions.
    pub(super) fn open_element(&mut self, mut target: Target, indexes: &[&Expression], span: Span) -> Option<Target> {
        let DataType::Array { element, bounds } = target.data_type.clone() else { return None };
        let step = element_step(&element);
        let mut before: Vec<Statement> = Vec::new();
        let mut flat: Option<Value> = None;
        let mut limits: Vec<(Value, Value)> = Vec::new();
        let mut sound = indexes.len() == bounds.len();
        let check = self.bounds_check();
        for (position, index) in indexes.iter().enumerate() {
            let Some((value, _)) = self.index_value(index) else {
                sound = false;
                continue;
            };
            let dimension = position + 1;
            let [low, high] = [self.bound(&target, dimension, End::Low, span)?, self.bound(&target, dimension, End::High, span)?];
            let [low, high, value] = [low, high, value].map(|value| convert(value, Scalar::I64));
            let (keep, value) = self.kept(value);
            before.push(keep);
            let value = match check {
                Bounds::Clamp => {
                    let least = two(Operation::Maximum, value, low.clone(), span);
                    two(Operation::Minimum, least, high.clone(), span)
                }
                _ => {
                    let above = two(Operation::GreaterEqual, value.clone(), low.clone(), span);
                    let below = two(Operation::LessEqual, value.clone(), high.clone(), span);
                    let both = compute(Op::And, vec![above, below], Scalar::Bool, span);
                    limits.push((both, value.clone()));
                    value
                }
            };
            let from_low = two(Operation::Subtract, value, low.clone(), span);
            flat = Some(match flat {
                None => from_low,
                Some(flat) => {
                    let length = two(Operation::Subtract, high, low, span);
                    let mut count = two(Operation::Add, length, number(1, Scalar::I64, span), span);
                    if dimension == bounds.len() && !element.word_aligned() {
                        // Rows of BOOL, BYTE and CHAR are padded to words.
                        let elements = i64::from(16 / step);
                        count = two(Operation::Add, count, number(elements - 1, Scalar::I64, span), span);
                        count = two(Operation::Divide, count, number(elements, Scalar::I64, span), span);
                        count = two(Operation::Multiply, count, number(elements, Scalar::I64, span), span);
                    }
                    two(Operation::Add, two(Operation::Multiply, flat, count, span), from_low, span)
                }
            });
        }
        if !sound {
            return None;
        }
        let flat = flat?;
        // An index that is out of its range becomes one that is out of every range and has the same low word: messages show that.
        let index = limits.into_iter().rev().fold(flat, |flat, (inside, value)| {
            let low = compute(Op::AndU64, vec![value, number(0xFFFF, Scalar::I64, span)], Scalar::I64, span);
            let outside = compute(Op::OrU64, vec![low, number(OUTSIDE, Scalar::I64, span)], Scalar::I64, span);
            let kind = ValueKind::Choose { condition: Box::new(inside), a: Box::new(flat), b: Box::new(outside) };
            Value { kind, scalar: Scalar::I64, span }
        });
        let check = if check == Bounds::Clamp { Bounds::None } else { check };
        let count = u64::from(ARRAY_BITS_MAX / step.max(1)).max(1);
        let value = super::calls::after(before, index);
        target.place.indexes.push(Index { value, low: 0, count, step, check });
        target.place.span = span;
        Some(Target { data_type: *element, through: Through::Part, name: format!("{}[…]", target.name), ..target })
    }

    /// LOWER_BOUND and UPPER_BOUND.
    pub(super) fn bound_function(&mut self, end: End, call: &ast::Call, span: Span) -> Typed {
        let given: Vec<&Expression> = call.arguments.iter().filter_map(|argument| argument.value.as_ref()).collect();
        let name = if end == End::Low { "LOWER_BOUND" } else { "UPPER_BOUND" };
        let (array, dimension) = match given.as_slice() {
            [array] => (*array, None),
            [array, dimension] => (*array, Some(*dimension)),
            _ => {
                self.look_at(&call.arguments);
                let help = format!("Write `{name}(a, 1)`.");
                self.report(Problem::P6219, span, format!("`{name}` takes an array and the number of a dimension")).help = Some(help);
                return Typed::Poison;
            }
        };
        let target = match self.reach(array) {
            Reached::Target(target) if matches!(target.data_type, DataType::Array { .. }) => target,
            Reached::Target(target) => {
                self.report(
                    Problem::P4011,
                    array.span,
                    format!("`{name}` takes an array, and `{}` is {}", target.name, self.words(&target.data_type)),
                );
                return Typed::Poison;
            }
            Reached::Other(Typed::Poison) => return Typed::Poison,
            Reached::Other(other) => {
                let what = self.what(&other);
                self.report(Problem::P4011, array.span, format!("`{name}` takes an array, not {what}"));
                return Typed::Poison;
            }
        };
        let DataType::Array { bounds, .. } = &target.data_type else { return Typed::Poison };
        let dimensions = bounds.len();
        let number = match dimension {
            None => Some(1),
            Some(dimension) => match self.expression(dimension) {
                Typed::Integer { value, .. } => usize::try_from(value).ok(),
                Typed::Scalar { value: Value { kind: ValueKind::Constant(bits), .. }, .. } => usize::try_from(bits).ok(),
                Typed::Poison => return Typed::Poison,
                typed => return self.bound_by_number(&target, typed, dimension.span, end, span),
            },
        };
        match number.filter(|number| (1..=dimensions).contains(number)).and_then(|number| self.bound(&target, number, end, span)) {
            Some(value) => Typed::Scalar { value, data_type: DataType::DoubleInt },
            None => {
                let place = dimension.map_or(span, |dimension| dimension.span);
                self.report(Problem::P4005, place, format!("`{}` has the dimensions 1 to {dimensions}", target.name));
                Typed::Poison
            }
        }
    }

    /// A bound of the dimension that a variable says; 0 for a number that no dimension has.
    fn bound_by_number(&mut self, target: &Target, dimension: Typed, place: Span, end: End, span: Span) -> Typed {
        let DataType::Array { bounds, .. } = &target.data_type else { return Typed::Poison };
        let count = bounds.len();
        let Some((value, data_type)) = self.scalar(dimension, place) else { return Typed::Poison };
        if !super::types::Kind::of(&data_type).is_some_and(super::types::Kind::is_integer) {
            let message = format!("the number of a dimension is an integer, not {}", self.words(&data_type));
            self.report(Problem::P6200, place, message);
            return Typed::Poison;
        }
        let (keep, value) = self.kept(convert(value, Scalar::I64));
        let mut found = number(0, Scalar::I32, span);
        for dimension in (1..=count).rev() {
            let Some(bound) = self.bound(target, dimension, end, span) else { return Typed::Poison };
            let is = two(Operation::Equal, value.clone(), number(dimension as i64, Scalar::I64, span), span);
            found = compute(Op::Select, vec![is, bound, found], Scalar::I32, span);
        }
        Typed::Scalar { value: super::calls::after(vec![keep], found), data_type: DataType::DoubleInt }
    }

    /// The bounds of an actual parameter for ARRAY[*]; `None` if it does not fit, which the caller reports.
    pub(super) fn bounds_of(&self, formal: &Variable, target: &Target, interface: &Interface) -> Option<Vec<Argument>> {
        let (DataType::Array { bounds, element }, DataType::Array { bounds: own, element: own_element }) =
            (&formal.data_type, &target.data_type)
        else {
            return None;
        };
        if bounds.len() != own.len() || !super::expressions::same_type(element, own_element) {
            return None;
        }
        let span = target.place.span;
        let mut arguments = Vec::new();
        for dimension in 1..=bounds.len() {
            for end in End::BOTH {
                let parameter = interface.variable(&bound_name(&formal.name, dimension, end))?.offset;
                arguments.push(Argument::Value { parameter, value: self.bound(target, dimension, end, span)? });
            }
        }
        Some(arguments)
    }

    /// Whether a variable may be used as a whole; an open array may not, which is reported.
    pub(super) fn is_whole(&mut self, target: &Target) -> bool {
        if !is_open(&target.data_type) {
            return true;
        }
        let message = format!("`{}` is {}: how long it is, only its caller knows", target.name, self.words(&target.data_type));
        let help = "Use its elements, from LOWER_BOUND to UPPER_BOUND, or give it to another ARRAY[*].";
        self.report(Problem::P6312, target.place.span, message).help = Some(help.to_owned());
        false
    }
}

fn number(value: i64, scalar: Scalar, span: Span) -> Value {
    let bits = if scalar == Scalar::I32 { u64::from(value as u32) } else { value as u64 };
    Value { kind: ValueKind::Constant(bits), scalar, span }
}
