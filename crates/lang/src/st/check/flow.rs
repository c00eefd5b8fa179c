//! EN and ENO of functions that are no blocks: their statement is done if EN is TRUE, and ENO tells whether it went well.

use sieben_engine::ir::Op;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::calls::{Called, after, is_flow};
use super::typed::{Target, Typed};
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
        let Some(Flow { enable, eno, plain }) = Flow::of(self, call)? else { return Some(None) };
        let plain = Expression { kind: ExpressionKind::Call(Box::new(plain)), span: value.span };
        let Some(done) = inner(self, &plain) else { return Some(None) };
        let body = vec![Statement { kind: done, span }];
        Some(Some(self.around(enable, eno, body, Vec::new(), span)))
    }

    /// The value of `F(EN := a, …, ENO => b)` inside a larger expression: with EN FALSE it is 0, as that of a block is; `None` if the call
    /// has neither.
    pub(super) fn value_with_flow(&mut self, call: &ast::Call, span: Span) -> Option<Typed> {
        if !of_function(call) {
            return None;
        }
        let flow = Flow::of(self, call)?;
        let Some(Flow { enable, eno, plain }) = flow else { return Some(Typed::Poison) };
        let typed = self.expression(&Expression { kind: ExpressionKind::Call(Box::new(plain)), span });
        if typed == Typed::Poison {
            return Some(typed);
        }
        if matches!(typed, Typed::Text(_) | Typed::Aggregate(_) | Typed::Delivered(..) | Typed::Moment(_) | Typed::Structured(..)) {
            let what = self.what(&typed);
            self.report(Problem::P6218, span, format!("EN and ENO inside an expression are for numbers and BOOL, not for {what}")).help =
                Some("Give the result to a variable in a statement of its own: `x := F(EN := a, …, ENO => b);`.".to_owned());
            return Some(Typed::Poison);
        }
        let Some((value, data_type)) = self.scalar(typed, span) else { return Some(Typed::Poison) };
        let scalar = value.scalar;
        let (keep, load) = self.kept(value);
        let StatementKind::Assign { target, .. } = &keep.kind else { return Some(Typed::Poison) };
        let zero = Value { kind: ValueKind::Constant(0), scalar, span };
        let nothing = Statement { kind: StatementKind::Assign { target: target.clone(), value: zero }, span };
        let whole = self.around(enable, eno, vec![keep], vec![nothing], span);
        Some(Typed::Scalar { value: after(vec![Statement { kind: whole, span }], load), data_type })
    }

    /// Statements that are done if EN is TRUE, else the others, and what ENO tells of them.
    pub(super) fn around(
        &mut self,
        enable: Option<Value>,
        eno: Option<Target>,
        mut body: Vec<Statement>,
        mut otherwise: Vec<Statement>,
        span: Span,
    ) -> StatementKind {
        let bit = |kind| Value { kind, scalar: Scalar::Bool, span };
        let statement = |kind| Statement { kind, span };
        if let Some(eno) = eno {
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
        match enable {
            Some(enable) => StatementKind::If { branches: vec![(enable, body)], otherwise },
            None => StatementKind::Block(body),
        }
    }
}

/// EN and ENO of a call, and the call without them.
struct Flow {
    enable: Option<Value>,
    eno: Option<Target>,
    plain: ast::Call,
}

impl Flow {
    /// `None` within if one of them is not understood, which is reported.
    fn of(checker: &mut Checker<'_>, call: &ast::Call) -> Option<Option<Self>> {
        let first = call.arguments.iter().find(|argument| is_flow(argument))?;
        if !checker.judge(Construct::EnEno, first.span) {
            return Some(None);
        }
        let (flow, arguments): (Vec<_>, Vec<_>) = call.arguments.iter().cloned().partition(is_flow);
        let given = |word: &str| {
            let found = flow.iter().find(|argument| argument.name.as_ref().is_some_and(|name| name.is(word)));
            found.and_then(|argument| argument.value.as_ref())
        };
        let enable = match given("EN") {
            Some(enable) => match checker.condition(enable) {
                Some(enable) => Some(enable),
                None => return Some(None),
            },
            None => None,
        };
        let eno = match given("ENO") {
            Some(written) => {
                let Some(eno) = checker.target(written) else { return Some(None) };
                if eno.data_type != DataType::Bool {
                    let message = format!("ENO is BOOL, and `{}` is {}", eno.name, checker.words(&eno.data_type));
                    checker.report(Problem::P4011, written.span, message);
                    return Some(None);
                }
                Some(eno)
            }
            None => None,
        };
        Some(Some(Self { enable, eno, plain: ast::Call { callee: call.callee.clone(), arguments } }))
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
