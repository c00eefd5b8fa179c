//! EN and ENO of functions that are no blocks: their statement is done if EN is TRUE, and ENO tells whether it went well.

use sieben_engine::ir::Op;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::calls::{Called, is_flow};
use crate::st::ast::{self, Expression, ExpressionKind};
use crate::st::dialect::Construct;
use crate::st::standard;
use crate::st::tree::{Scalar, Statement, StatementKind, Value, ValueKind};

impl Checker<'_> {
    /// A statement around `x := F(EN := a, …, ENO => b)` or `F(EN := a, …)`; `None` if the call has neither, or a block is called.
    /// `inner` makes the statement of the call without them.
    pub(super) fn with_flow(
        &mut self,
        value: &Expression,
        span: Span,
        inner: impl FnOnce(&mut Self, &Expression) -> Option<StatementKind>,
    ) -> Option<Option<StatementKind>> {
        let ExpressionKind::Call(call) = &value.kind else { return None };
        if !of_function(call) || !matches!(self.quietly(|checker| checker.called(&call.callee)), Called::Standard(_)) {
            return None;
        }
        let flow = call.arguments.iter().find(|argument| is_flow(argument))?;
        if !self.judge(Construct::EnEno, flow.span) {
            return Some(None);
        }
        let (flow, arguments): (Vec<_>, Vec<_>) = call.arguments.iter().cloned().partition(is_flow);
        let given = |word: &str| {
            let found = flow.iter().find(|argument| argument.name.as_ref().is_some_and(|name| name.is(word)));
            found.and_then(|argument| argument.value.as_ref())
        };
        let enable = match given("EN") {
            Some(enable) => match self.condition(enable) {
                Some(enable) => Some(enable),
                None => return Some(None),
            },
            None => None,
        };
        let plain = ast::Call { callee: call.callee.clone(), arguments };
        let plain = Expression { kind: ExpressionKind::Call(Box::new(plain)), span: value.span };
        let Some(done) = inner(self, &plain) else { return Some(None) };
        let bit = |kind| Value { kind, scalar: Scalar::Bool, span };
        let statement = |kind| Statement { kind, span };
        let (mut body, mut otherwise) = (vec![statement(done)], Vec::new());
        if let Some(written) = given("ENO") {
            let Some(eno) = self.target(written) else { return Some(None) };
            if eno.data_type != DataType::Bool {
                let message = format!("ENO is BOOL, and `{}` is {}", eno.name, self.words(&eno.data_type));
                self.report(Problem::P4011, written.span, message);
                return Some(None);
            }
            // What went wrong before counts for the block all the same.
            let (keep, before) = self.kept(bit(ValueKind::Ok));
            let both = ValueKind::Compute { op: Op::And, args: vec![before, bit(ValueKind::Ok)] };
            let tells = |value| statement(StatementKind::Assign { target: eno.place.clone(), value });
            otherwise.push(tells(bit(ValueKind::Constant(0))));
            body.insert(0, keep);
            body.insert(1, statement(StatementKind::SetOk(bit(ValueKind::Constant(1)))));
            body.push(tells(bit(ValueKind::Ok)));
            body.push(statement(StatementKind::SetOk(bit(both))));
        }
        Some(Some(match enable {
            Some(enable) => StatementKind::If { branches: vec![(enable, body)], otherwise },
            None => StatementKind::Block(body),
        }))
    }
}

/// Whether a call gives EN or ENO to a standard function, by its name.
fn of_function(call: &ast::Call) -> bool {
    let ExpressionKind::Name(name) = &call.callee.kind else { return false };
    name.quoting != ast::Quoting::Global && call.arguments.iter().any(is_flow) && standard::catalogue::page(&name.text).is_some()
}

/// Whether an expression asks whether a standard function went well.
pub(super) fn asks_eno(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Call(call) => {
            of_function(call) && call.arguments.iter().any(|one| one.name.as_ref().is_some_and(|name| name.is("ENO")))
        }
        _ => false,
    }
}
