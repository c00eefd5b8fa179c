//! Shifts of numbers without a type, and choices between such numbers: they take the type of where they stand.

use sieben_model::types::DataType;

use super::Checker;
use super::calls::Called;
use super::typed::Typed;
use super::types::{Class, Kind};
use crate::st::ast::{self, BinaryOperator, Direction, Expression, ExpressionKind, Literal, LiteralKind, Name, Quoting, UnaryOperator};
use crate::st::dialect::{Construct, Judgement};
use crate::st::standard::operators::limits;

/// Functions of bits whose result has the type of their operand.
const OF_BITS: [&str; 5] = ["SHL", "SHR", "ROL", "ROR", "SWAP"];
/// Functions whose result is one of their inputs, and the input that says which one.
const CHOICES: [(&str, Option<&str>); 5] = [("SEL", Some("G")), ("MUX", Some("K")), ("MAX", None), ("MIN", None), ("LIMIT", None)];

/// What functions do with numbers without a type.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Family {
    Shifts,
    /// Only an LREAL has more digits than such numbers have by themselves.
    Choices,
}

impl Checker<'_> {
    /// An expression of shifted or chosen numbers without a type, written with a type; `None` for anything else.
    pub(super) fn untyped_as(&mut self, expression: &Expression, wanted: &DataType) -> Option<Expression> {
        let kind = Kind::of(wanted.base())?;
        if kind.is_integer()
            && let Some(typed) = self.truncated_to(expression, wanted.base())
        {
            return Some(typed);
        }
        if let Some(typed) = self.day_as(expression, kind, wanted.base()) {
            return Some(typed);
        }
        let bits = kind.is_integer() || kind.class == Class::Bits && kind.bits > 1;
        if !bits && kind != Kind::LREAL {
            return None;
        }
        if kind.class == Class::Bits || self.bits_of_integers(kind) {
            let mut typed = expression.clone();
            if self.inverts_numbers(expression, kind) {
                write_type(&mut typed, wanted.base().word());
                return Some(typed);
            }
        }
        let whole = bits && self.chooses_whole_numbers(expression, kind);
        let family = if bits && !whole { Family::Shifts } else { Family::Choices };
        if self.family(expression)? != family {
            return None;
        }
        let mut typed = expression.clone();
        self.give_type(&mut typed, wanted.base()).then_some(typed)
    }

    /// DAY_OF_WEEK as the integer of where it stands: every one has seven numbers.
    fn day_as(&mut self, expression: &Expression, kind: Kind, wanted: &DataType) -> Option<Expression> {
        let inner = match &expression.kind {
            ExpressionKind::Parenthesized(inner) => inner,
            _ => expression,
        };
        let ExpressionKind::Call(call) = &inner.kind else { return None };
        let named = matches!(&call.callee.kind, ExpressionKind::Name(name) if name.is("DAY_OF_WEEK") && name.quoting == Quoting::Bare);
        let implicit = super::types::implicit(Kind::INT, kind, self.dialect) == super::types::Implicit::Yes;
        if !named || !kind.is_integer() || implicit || !matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_))
        {
            return None;
        }
        let text = format!("INT_TO_{}", wanted.word()?);
        let (value, span) = (Some(expression.clone()), expression.span);
        let argument = ast::Argument { name: None, direction: Direction::Assigned, value, span };
        let callee = Expression { kind: ExpressionKind::Name(Name { text, span: call.callee.span, ..Name::default() }), span };
        let call = ast::Call { callee, arguments: vec![argument] };
        Some(Expression { kind: ExpressionKind::Call(Box::new(call)), span })
    }

    /// TRUNC with the integer type of where it stands, in the dialect where it has no type of its own.
    fn truncated_to(&mut self, expression: &Expression, wanted: &DataType) -> Option<Expression> {
        if !self.truncates(expression) {
            return None;
        }
        fn write(expression: &mut Expression, word: &str) {
            match &mut expression.kind {
                ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(_, inner) => write(inner, word),
                ExpressionKind::Call(call) => {
                    if let ExpressionKind::Name(name) = &mut call.callee.kind {
                        name.text = format!("TRUNC_{word}");
                    }
                }
                _ => {}
            }
        }
        let mut typed = expression.clone();
        write(&mut typed, wanted.word()?);
        Some(typed)
    }

    /// Whether an expression is a call of the standard function TRUNC, and its type is that of where it stands.
    pub(super) fn truncates(&mut self, expression: &Expression) -> bool {
        if !self.dialect.switches().trunc_takes_type {
            return false;
        }
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(UnaryOperator::Minus | UnaryOperator::Plus, inner) => {
                self.truncates(inner)
            }
            ExpressionKind::Call(call) => {
                let named = matches!(&call.callee.kind, ExpressionKind::Name(name) if name.is("TRUNC") && name.quoting == Quoting::Bare);
                named && matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_))
            }
            _ => false,
        }
    }

    /// `LIMIT(0, 5, 7)`: whole numbers only, which all fit a type.
    fn chooses_whole_numbers(&self, expression: &Expression, kind: Kind) -> bool {
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) => self.chooses_whole_numbers(inner, kind),
            ExpressionKind::Call(call) => {
                let (least, most) = limits(kind.scalar(self.dialect));
                let of = chosen(call).unwrap_or_default();
                let mut values = of.iter().filter_map(|&index| call.arguments[index].value.as_ref());
                let fits = |value: &Expression| match number_of(value) {
                    Some((number, radix)) => (least..=most).contains(&number) && self.takes_notation(kind, radix),
                    None => self.chooses_whole_numbers(value, kind) || kind.class == Class::Bits && self.inverts_numbers(value, kind),
                };
                !of.is_empty() && values.all(fits)
            }
            _ => false,
        }
    }

    /// Whether a number in this notation is one of a kind, without a word about it.
    fn takes_notation(&self, kind: Kind, radix: u8) -> bool {
        kind.class != Class::Bits || radix != 10 || self.dialect.judge(Construct::DecimalToBitString) == Judgement::Accept
    }

    /// `NOT 16#F0`, `NOT (16#F0 OR 1)`: numbers only, which all fit a type of bits.
    fn inverts_numbers(&self, expression: &Expression, kind: Kind) -> bool {
        let (least, most) = limits(kind.scalar(self.dialect));
        are_inverted(expression, &|number, radix| (least..=most).contains(&number) && self.takes_notation(kind, radix))
    }

    /// Two operands, one of which is made of shifted or chosen numbers without a type.
    pub(super) fn beside_untyped(&mut self, left: &Expression, right: &Expression) -> Option<(Typed, Typed)> {
        let takes_type = |checker: &mut Self, operand: &Expression| {
            are_inverted(operand, &|_, _| true) || checker.family(operand).is_some() || checker.truncates(operand)
        };
        match (takes_type(self, left), takes_type(self, right)) {
            (true, false) => {
                let b = self.expression(right);
                Some((self.untyped_beside(left, &b), b))
            }
            (false, true) => {
                let a = self.expression(left);
                let b = self.untyped_beside(right, &a);
                Some((a, b))
            }
            _ => None,
        }
    }

    fn untyped_beside(&mut self, expression: &Expression, other: &Typed) -> Typed {
        match other {
            Typed::Scalar { data_type, .. } => self.expression_for(expression, &data_type.clone()),
            _ => self.expression(expression),
        }
    }

    /// What an expression does with the numbers without a type that it is made of.
    fn family(&mut self, expression: &Expression) -> Option<Family> {
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(_, inner) => self.family(inner),
            ExpressionKind::Binary(operator, _, a, b) if keeps_type(*operator) => match (self.family(a), self.family(b)) {
                (Some(x), Some(y)) => (x == y).then_some(x),
                (Some(x), None) => is_number(b, x).then_some(x),
                (None, Some(y)) => is_number(a, y).then_some(y),
                (None, None) => None,
            },
            ExpressionKind::Call(call) => {
                let family = match (shifted(call), chosen(call)) {
                    (Some((_, number)), _) => is_number(number, Family::Shifts).then_some(Family::Shifts),
                    (None, Some(of)) => {
                        let mut values = of.iter().filter_map(|&index| call.arguments[index].value.as_ref());
                        values
                            .all(|value| {
                                let number = is_number(value, Family::Choices) || are_inverted(value, &|_, _| true);
                                number || self.family(value) == Some(Family::Choices)
                            })
                            .then_some(Family::Choices)
                    }
                    (None, None) => None,
                }?;
                matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_)).then_some(family)
            }
            _ => None,
        }
    }

    /// Writes the type to the numbers that are shifted or chosen; `false` if one of them does not fit it.
    fn give_type(&self, expression: &mut Expression, wanted: &DataType) -> bool {
        match &mut expression.kind {
            ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(_, inner) => self.give_type(inner, wanted),
            ExpressionKind::Binary(_, _, a, b) => self.give_type(a, wanted) && self.give_type(b, wanted),
            ExpressionKind::Call(call) => {
                if let Some(of) = chosen(call) {
                    let prefix = wanted.word();
                    write_type_of(call, &of, prefix);
                    return true;
                }
                let Some((rotates, number)) = shifted(call) else { return false };
                let Some((value, radix)) = number_of(number) else { return false };
                // The ring is as long as the number needs, as CODESYS has it; the result may go into a wider variable.
                let ring = [DataType::Byte, DataType::Word, DataType::DoubleWord, DataType::LongWord];
                let smallest = ring.into_iter().find(|ring| value >= 0 && value >> ring.bits() == 0);
                let data_type = match smallest {
                    Some(ring) if rotates && self.dialect.has_pointers() => ring,
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

/// The arguments of a call of a choice that are chosen from.
fn chosen(call: &ast::Call) -> Option<Vec<usize>> {
    let ExpressionKind::Name(Name { text, quoting: Quoting::Bare, .. }) = &call.callee.kind else { return None };
    let (_, selector) = CHOICES.iter().find(|(name, _)| name.eq_ignore_ascii_case(text))?;
    let selects = |index: usize, argument: &ast::Argument| match (&argument.name, selector) {
        (Some(name), Some(selector)) => name.is(selector),
        (None, Some(_)) => index == 0,
        (_, None) => false,
    };
    let of = call.arguments.iter().enumerate().filter(|&(index, argument)| !selects(index, argument)).map(|(index, _)| index);
    Some(of.collect())
}

/// Writes a type to the arguments that are chosen from.
fn write_type_of(call: &mut ast::Call, of: &[usize], prefix: Option<&'static str>) {
    for &index in of {
        if let Some(value) = &mut call.arguments[index].value {
            write_type(value, prefix);
        }
    }
}

/// Writes a type to the numbers of a chosen value.
fn write_type(value: &mut Expression, prefix: Option<&'static str>) {
    match &mut value.kind {
        ExpressionKind::Literal(literal) => literal.prefix = prefix,
        ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(_, inner) => write_type(inner, prefix),
        ExpressionKind::Binary(_, _, a, b) => [a, b].into_iter().for_each(|operand| write_type(operand, prefix)),
        ExpressionKind::Call(call) => {
            let of = chosen(call).unwrap_or_default();
            write_type_of(call, &of, prefix);
        }
        _ => {}
    }
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

/// Whether an expression is `NOT` of numbers, and of nothing else, that are all taken.
fn are_inverted(expression: &Expression, takes: &dyn Fn(i128, u8) -> bool) -> bool {
    fn all(expression: &Expression, takes: &dyn Fn(i128, u8) -> bool, inverts: &mut bool) -> bool {
        match &expression.kind {
            ExpressionKind::Parenthesized(inner) => all(inner, takes, inverts),
            ExpressionKind::Unary(UnaryOperator::Not, inner) => {
                *inverts = true;
                all(inner, takes, inverts)
            }
            ExpressionKind::Binary(BinaryOperator::And | BinaryOperator::Or | BinaryOperator::Xor, _, a, b) => {
                all(a, takes, inverts) && all(b, takes, inverts)
            }
            _ => number_of(expression).is_some_and(|(number, radix)| takes(number, radix)),
        }
    }
    let mut inverts = false;
    all(expression, takes, &mut inverts) && inverts
}

/// Whether an expression is a number without a type that a family works on.
fn is_number(expression: &Expression, family: Family) -> bool {
    match &expression.kind {
        ExpressionKind::Literal(Literal { kind: LiteralKind::Real { .. }, prefix: None }) => family == Family::Choices,
        ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary(UnaryOperator::Minus, inner) => is_number(inner, family),
        ExpressionKind::Binary(operator, _, a, b) if family == Family::Choices && keeps_type(*operator) => {
            is_number(a, family) && is_number(b, family)
        }
        _ => number_of(expression).is_some(),
    }
}

/// Operators whose result has the type of their operands.
fn keeps_type(operator: BinaryOperator) -> bool {
    use BinaryOperator as B;
    matches!(operator, B::Add | B::Subtract | B::Multiply | B::Divide | B::IntegerDivide | B::Modulo | B::And | B::Or | B::Xor)
}
