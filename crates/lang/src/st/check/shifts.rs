//! Shifts of numbers without a type: they take that of where they stand.

use sieben_model::types::DataType;

use super::Checker;
use super::calls::Called;
use super::typed::Typed;
use super::types::{Class, Kind};
use crate::st::ast::{self, BinaryOperator, Direction, Expression, ExpressionKind, Literal, LiteralKind, Name, Quoting, UnaryOperator};
use crate::st::standard::operators::limits;

/// Functions of bits whose result has the type of their operand.
const OF_BITS: [&str; 5] = ["SHL", "SHR", "ROL", "ROR", "SWAP"];

impl Checker<'_> {
    /// An expression of shifted numbers without a type, written with a type; `None` for anything else.
    pub(super) fn shifted_as(&mut self, expression: &Expression, wanted: &DataType) -> Option<Expression> {
        let kind = Kind::of(wanted.base())?;
        if !(kind.is_integer() || kind.class == Class::Bits && kind.bits > 1) || !self.shifts_numbers(expression) {
            return None;
        }
        let mut typed = expression.clone();
        self.give_type(&mut typed, wanted.base()).then_some(typed)
    }

    /// Two operands, one of which is made of shifted numbers without a type.
    pub(super) fn beside_shift(&mut self, left: &Expression, right: &Expression) -> Option<(Typed, Typed)> {
        match (self.shifts_numbers(left), self.shifts_numbers(right)) {
            (true, false) => {
                let b = self.expression(right);
                Some((self.shifted_beside(left, &b), b))
            }
            (false, true) => {
                let a = self.expression(left);
                let b = self.shifted_beside(right, &a);
                Some((a, b))
            }
            _ => None,
        }
    }

    fn shifted_beside(&mut self, expression: &Expression, other: &Typed) -> Typed {
        match other {
            Typed::Scalar { data_type, .. } => self.expression_for(expression, &data_type.clone()),
            _ => self.expression(expression),
        }
    }

    /// Whether an expression is made of numbers without a type and shifts at least one of them.
    fn shifts_numbers(&mut self, expression: &Expression) -> bool {
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(_, inner) => self.shifts_numbers(inner),
            ExpressionKind::Binary(operator, _, a, b) if keeps_type(*operator) => {
                let (x, y) = (self.shifts_numbers(a), self.shifts_numbers(b));
                x && (y || is_number(b)) || y && is_number(a)
            }
            ExpressionKind::Call(call) => {
                shifted(call).is_some_and(|(_, number)| is_number(number))
                    && matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_))
            }
            _ => false,
        }
    }

    /// Writes the type to the numbers that are shifted; `false` if one of them does not fit it.
    fn give_type(&self, expression: &mut Expression, wanted: &DataType) -> bool {
        match &mut expression.kind {
            ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(_, inner) => self.give_type(inner, wanted),
            ExpressionKind::Binary(_, _, a, b) => self.give_type(a, wanted) && self.give_type(b, wanted),
            ExpressionKind::Call(call) => {
                let Some((rotates, number)) = shifted(call) else { return false };
                let Some((value, radix)) = number_of(number) else { return false };
                // The ring is as long as the number needs, as CODESYS has it; the result may go into a wider variable.
                let ring = [DataType::Byte, DataType::Word, DataType::DoubleWord, DataType::LongWord];
                let smallest = ring.into_iter().find(|ring| value >= 0 && value >> ring.bits() == 0);
                let data_type = match smallest {
                    Some(ring) if rotates && self.counts_with_pointers() => ring,
                    _ => wanted.clone(),
                };
                let fits = Kind::of(&data_type).is_some_and(|kind| {
                    let (least, most) = limits(kind.scalar(self.dialect));
                    (least..=most).contains(&value)
                });
                let (Some(prefix), true) = (data_type.word(), fits) else { return false };
                let literal = Literal { kind: LiteralKind::Integer { value, radix }, prefix: Some(prefix) };
                let place = argument_of(&call.arguments).and_then(|index| call.arguments[index].value.as_mut());
                place.is_some_and(|place| {
                    place.kind = ExpressionKind::Literal(literal);
                    true
                })
            }
            _ => true,
        }
    }
}

/// Whether a rotation, and the operand, of a call of a function of bits.
fn shifted(call: &ast::Call) -> Option<(bool, &Expression)> {
    let ExpressionKind::Name(Name { text, quoting, .. }) = &call.callee.kind else { return None };
    let name = OF_BITS.iter().find(|name| name.eq_ignore_ascii_case(text)).filter(|_| *quoting == Quoting::Bare)?;
    let operand = call.arguments[argument_of(&call.arguments)?].value.as_ref()?;
    Some((name.starts_with("RO"), operand))
}

/// The argument that is IN.
fn argument_of(arguments: &[ast::Argument]) -> Option<usize> {
    let named = |argument: &ast::Argument| argument.name.as_ref().is_some_and(|name| name.is("IN"));
    let first = arguments.first().is_some_and(|argument| argument.name.is_none() && argument.direction == Direction::Assigned);
    arguments.iter().position(named).or(first.then_some(0))
}

/// The number that an expression is.
fn number_of(expression: &Expression) -> Option<(i128, u8)> {
    match &expression.kind {
        ExpressionKind::Literal(Literal { kind: LiteralKind::Integer { value, radix }, prefix: None }) => Some((*value, *radix)),
        ExpressionKind::Parenthesized(inner) => number_of(inner),
        ExpressionKind::Unary(UnaryOperator::Minus, inner) => number_of(inner).map(|(value, radix)| (-value, radix)),
        _ => None,
    }
}

fn is_number(expression: &Expression) -> bool {
    number_of(expression).is_some()
}

/// Operators whose result has the type of their operands.
fn keeps_type(operator: BinaryOperator) -> bool {
    use BinaryOperator as B;
    matches!(operator, B::Add | B::Subtract | B::Multiply | B::Divide | B::IntegerDivide | B::Modulo | B::And | B::Or | B::Xor)
}
