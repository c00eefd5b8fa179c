//! Boxes: functions, operators and function blocks with what is wired to their pins.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::lower::{Lowering, Tall, Value, has_effects};
use crate::network::boxes::PowerPins;
use crate::network::model::{NamedBox, Place};
use crate::network::operand::Operand;
use crate::st::ast::{Argument, DiagramBox, Direction, Expression, ExpressionKind, GoesOn, Name, StatementKind, UnaryOperator};

impl Lowering<'_, '_> {
    /// A box with the line from the left; what goes on from it.
    pub(super) fn named(&mut self, one: &NamedBox, value: Value, feeds: bool, place: Place) -> Value {
        self.a_box(one, value, place, if feeds { Goes::Line } else { Goes::Nowhere })
    }

    fn a_box(&mut self, one: &NamedBox, mut power: Value, place: Place, goes: Goes) -> Value {
        let span = self.span(place);
        if one.inputs.iter().any(|input| has_effects(&input.line)) {
            self.settle(&mut power);
        }
        let mut values: Vec<(Option<Name>, bool, Value)> = Vec::with_capacity(one.inputs.len());
        for input in &one.inputs {
            if has_effects(&input.line) {
                values.iter_mut().for_each(|(_, _, value)| self.settle(value));
            }
            let value = self.pin(&input.line);
            values.push((input.name.as_ref().map(|name| self.name(name, span)), input.negated, value));
        }
        let inputs = values.into_iter().map(|(name, negated, value)| {
            let value = value.map(|value| value.expression);
            let value = value.map(|value| if negated { negation(value) } else { value });
            let place = value.as_ref().map_or(span, |value| value.span);
            let whole = name.as_ref().map_or(place, |name| name.span.to(place));
            Argument { name, direction: Direction::Assigned, value, span: whole }
        });
        let inputs: Vec<Argument> = inputs.collect();
        let output = |this: &mut Self, (name, target): &(Option<Operand>, Operand)| {
            let name = name.as_ref().map(|name| this.name(name, span));
            let target = this.operand(target, place);
            let whole = name.as_ref().map_or(target.span, |name| name.span.to(target.span));
            Argument { name, direction: Direction::Delivered, value: Some(target), span: whole }
        };
        let outputs: Vec<Argument> = one.outputs.iter().map(|written| output(self, written)).collect();
        let of = self.name_of_box(&one.name, place);
        let instance = one.instance.as_ref().map(|instance| self.operand(instance, place));
        if let Some(instance) = one.instance.as_ref().filter(|_| !one.inputs.is_empty() || power.is_some()) {
            self.calls_once(&one.name, instance, span);
        }
        let (power_pin, flow) = (one.power.as_ref().map(|pin| self.name(pin, span)), one.flow.as_ref().map(|pin| self.name(pin, span)));
        let goes_on = match goes {
            Goes::Nowhere => GoesOn::Nothing,
            Goes::Line => GoesOn::Line(self.wire()),
            Goes::Value => GoesOn::Value(self.wire()),
        };
        let power = power.map(|power| power.expression);
        let written = DiagramBox { network: self.number, of, instance, power, power_pin, inputs, outputs, flow, goes_on };
        self.put(StatementKind::Box(Box::new(written)), span);
        goes_on.wire().map(|wire| Tall::flat(Expression { kind: ExpressionKind::Wire(wire), span }))
    }

    /// What a box is called: a word, also that of an operator such as AND, or a path.
    fn name_of_box(&mut self, name: &Operand, place: Place) -> Expression {
        let is_word = name.text.chars().all(|sign| sign.is_alphanumeric() || sign == '_');
        if !is_word {
            return self.operand(name, place);
        }
        let name = self.name(name, self.span(place));
        let span = name.span;
        Expression { kind: ExpressionKind::Name(name), span }
    }

    /// Warns where a second box calls the same instance. In another network only timers, counters, edges and flip-flops: they keep what
    /// the first call left.
    fn calls_once(&mut self, name: &Operand, instance: &Operand, span: Span) {
        let place = self.span_of(instance, span);
        // An index may lead to another element each time.
        let is_one = !instance.split('[').skip(1).any(|index| index.chars().any(char::is_alphabetic));
        let first = *self.called.entry(instance.text.to_uppercase()).or_insert((place, self.number));
        let elsewhere = first.1 != self.number && is_one && PowerPins::of(name).is_some();
        if first.0 == place || first.1 != self.number && !elsewhere {
            return;
        }
        let where_first = if elsewhere { format!(", first in {}", first.1) } else { String::new() };
        let message = format!("{}: `{instance}` is called twice{where_first}", self.number);
        let help = match elsewhere {
            true => "Declare an instance for each box, or read the outputs of the first one.",
            false => "Declare an instance for each box, or draw one of them in a network of its own.",
        };
        let mut diagnostic = Diagnostic::new(Problem::P2443, place, message).help(help);
        diagnostic.related.push((first.0, "first called here".to_owned()));
        self.diagnostics.push(diagnostic);
    }

    /// What is wired to a pin: a value of any type if one element makes it, else a line.
    fn pin(&mut self, line: &crate::network::model::Line) -> Value {
        use crate::network::model::Kind;
        if let [only] = line.as_slice()
            && let Kind::Contact { operand, negated } = &only.kind
        {
            // A variable or a constant of any type.
            return Some(self.wired(operand, *negated, only.place));
        }
        if let Some((last, before)) = line.split_last()
            && let Kind::Named(one) = &last.kind
        {
            let power = self.line(&before.to_vec(), None, true);
            return self.a_box(one, power, last.place, Goes::Value);
        }
        self.line(line, None, true)
    }
}

/// Where what a box delivers goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Goes {
    Nowhere,
    Line,
    Value,
}

fn negation(value: Expression) -> Expression {
    let span = value.span;
    Expression { kind: ExpressionKind::Unary(UnaryOperator::Not, Box::new(value)), span }
}
