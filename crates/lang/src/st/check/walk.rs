//! Every expression and every statement of a list of statements, from outside to inside.

use crate::st::ast::{CaseLabel, Expression, ExpressionKind, Position, Statement, StatementKind};

/// Shows every expression to `see`, also those inside others.
pub(crate) fn expressions(statements: &[Statement], see: &mut dyn FnMut(&Expression)) {
    for statement in statements {
        match &statement.kind {
            StatementKind::Assign { targets, value, .. } => {
                targets.iter().for_each(|target| expression(target, see));
                expression(value, see);
            }
            StatementKind::Expression(inner) => expression(inner, see),
            StatementKind::If { branches, otherwise } => {
                for branch in branches {
                    expression(&branch.condition, see);
                    expressions(&branch.body, see);
                }
                expressions(otherwise.as_deref().unwrap_or_default(), see);
            }
            StatementKind::Case { selector, arms, otherwise } => {
                expression(selector, see);
                for arm in arms {
                    for label in &arm.labels {
                        match label {
                            CaseLabel::Value(value) => expression(value, see),
                            CaseLabel::Range(low, high) => [low, high].into_iter().for_each(|value| expression(value, see)),
                        }
                    }
                    expressions(&arm.body, see);
                }
                expressions(otherwise.as_deref().unwrap_or_default(), see);
            }
            StatementKind::For(one) => {
                [&one.variable, &one.from, &one.to].into_iter().chain(&one.by).for_each(|value| expression(value, see));
                expressions(&one.body, see);
            }
            StatementKind::While { condition, body } => {
                expression(condition, see);
                expressions(body, see);
            }
            StatementKind::Repeat { body, until } => {
                expressions(body, see);
                expression(until, see);
            }
            StatementKind::Region { body, .. } => expressions(body, see),
            StatementKind::Try { body, exception, catch, finally } => {
                exception.iter().for_each(|value| expression(value, see));
                [body, catch, finally].into_iter().for_each(|body| expressions(body, see));
            }
            StatementKind::Wire(_, value) => expression(value, see),
            StatementKind::Box(one) => one.expressions().for_each(|value| expression(value, see)),
            StatementKind::Empty
            | StatementKind::Exit
            | StatementKind::Continue
            | StatementKind::Return
            | StatementKind::Goto(_)
            | StatementKind::Label(_)
            | StatementKind::Missing => {}
        }
    }
}

/// Shows every statement to `see`, also those inside others.
pub(crate) fn statements(list: &[Statement], see: &mut dyn FnMut(&Statement)) {
    for statement in list {
        see(statement);
        match &statement.kind {
            StatementKind::If { branches, otherwise } => {
                branches.iter().for_each(|branch| statements(&branch.body, see));
                statements(otherwise.as_deref().unwrap_or_default(), see);
            }
            StatementKind::Case { arms, otherwise, .. } => {
                arms.iter().for_each(|arm| statements(&arm.body, see));
                statements(otherwise.as_deref().unwrap_or_default(), see);
            }
            StatementKind::For(one) => statements(&one.body, see),
            StatementKind::While { body, .. } | StatementKind::Repeat { body, .. } | StatementKind::Region { body, .. } => {
                statements(body, see)
            }
            StatementKind::Try { body, catch, finally, .. } => {
                [body, catch, finally].into_iter().for_each(|body| statements(body, see));
            }
            StatementKind::Empty
            | StatementKind::Assign { .. }
            | StatementKind::Expression(_)
            | StatementKind::Exit
            | StatementKind::Continue
            | StatementKind::Return
            | StatementKind::Goto(_)
            | StatementKind::Label(_)
            | StatementKind::Wire(..)
            | StatementKind::Box(_)
            | StatementKind::Missing => {}
        }
    }
}

/// Shows an expression and those inside it.
pub(super) fn expression(outer: &Expression, see: &mut dyn FnMut(&Expression)) {
    see(outer);
    match &outer.kind {
        ExpressionKind::Member(inner, _)
        | ExpressionKind::Dereference(inner)
        | ExpressionKind::Slice(inner, _)
        | ExpressionKind::Unary(_, inner)
        | ExpressionKind::Parenthesized(inner) => expression(inner, see),
        ExpressionKind::Contact(contact) => expression(&contact.operand, see),
        ExpressionKind::Index(inner, indexes) => {
            expression(inner, see);
            indexes.iter().for_each(|index| expression(index, see));
        }
        ExpressionKind::Binary(_, _, left, right) | ExpressionKind::Assign(left, right) => {
            expression(left, see);
            expression(right, see);
        }
        ExpressionKind::Call(call) => {
            expression(&call.callee, see);
            call.arguments.iter().filter_map(|argument| argument.value.as_ref()).for_each(|value| expression(value, see));
        }
        ExpressionKind::Address(address) => position(&address.position, see),
        ExpressionKind::DataAddress(address) => {
            expression(&address.block, see);
            position(&address.position, see);
        }
        ExpressionKind::Literal(_)
        | ExpressionKind::Name(_)
        | ExpressionKind::Global(_)
        | ExpressionKind::EnumValue { .. }
        | ExpressionKind::This
        | ExpressionKind::Super
        | ExpressionKind::Wire(_)
        | ExpressionKind::Missing => {}
    }
}

fn position(position: &Position, see: &mut dyn FnMut(&Expression)) {
    if let Position::Computed(indexes) = position {
        indexes.iter().for_each(|index| expression(index, see));
    }
}
