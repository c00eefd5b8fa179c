//! Why a statement of Structured Text did what it did: what was read, and what came of it.

mod failed;
mod named;
mod values;

use sieben_engine::ir::{self, Inst};
use sieben_engine::machine::Register;
use sieben_model::address::Area;
use sieben_model::source::Span;

use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words, one_line};
use crate::sentences::{Language, Moment, Surroundings};
use crate::st::tree::{Argument, Call, Callee, For, Statement, StatementKind, TypedBlock, Value};
pub(crate) use named::named;
use values::{Values, format_scalar};

/// Values that a sentence shows.
const SHOWN: usize = 6;

/// A part of a body that a step of the code comes from.
#[derive(Clone, Copy)]
enum Part<'t> {
    Statement(&'t Statement),
    /// The condition of IF, ELSIF or WHILE.
    Condition(&'t Value),
    /// The condition behind UNTIL.
    Until(&'t Value),
    /// The variable of FOR, one step on.
    Next(&'t For),
}

/// The sentence of a step of Structured Text.
pub(crate) fn sentence(around: Surroundings<'_>, block: &TypedBlock, moment: &Moment<'_>, language: Language) -> String {
    let place = moment.event.place;
    let Some(code) = around.program.code.get(&place.block) else { return String::new() };
    let index = place.statement as usize;
    let Some(&span) = code.spans.get(index) else { return String::new() };
    let text = one_line(around.slice(span));
    let step = || Clause::new(S::StStep).with("text", text.clone());
    let part = find(&block.body.statements, span);
    let insts = code.code.statement(index);
    let values = Values::new(around, moment, code);
    // A statement that takes several steps is over with the last one; before it nothing can be said of the whole.
    // What a block sets before its first statement belongs to no statement, though it has the place of one.
    let entry = (0..code.spans.len())
        .take_while(|&at| code.spans[at] == code.spans[0] && code.spans.get(at + 1) == Some(&span) && prepares(code.code.statement(at)))
        .take_while(|&at| part.is_none_or(|part| !writes(part, code.code.statement(at), &values)))
        .count();
    let first = index == entry || index > 0 && code.spans.get(index - 1) != Some(&span);
    let behind = (index + 1..code.spans.len()).take_while(|&at| code.spans[at] == span);
    let last = behind.clone().all(|at| leaves(code.code.statement(at)));
    // Behind the last statement the block tells its caller how it went, and ends.
    let ends = last && index + 1 + behind.count() == code.spans.len() && leaves(insts) && sets_br(insts);
    let stores = insts.iter().any(|inst| matches!(inst, Inst::Store { .. }));
    let branches = insts.iter().any(|inst| matches!(inst, Inst::Branch { .. } | Inst::JumpTable { .. }));
    let calls = insts.iter().find_map(|inst| match inst {
        Inst::Call { callee: ir::Callee::Block(block), .. } => Some(*block),
        _ => None,
    });
    let clause = match (part, calls) {
        _ if index < entry => Clause::new(S::StPrepare),
        (Some(_), None) if ends => Clause::new(S::StEnd),
        (None, _) if insts.iter().all(|inst| matches!(inst, Inst::Return)) => Clause::new(S::StEnd),
        (None, None) => Clause::new(S::StPrepare),
        (None, Some(block)) => Clause::new(S::StCall).with("block", values.block_name(block)),
        (Some(Part::Statement(Statement { kind: StatementKind::Call(call), .. })), Some(_)) => called(call, &values),
        // The step is over where the called block begins; what it delivers is used when it has ended.
        (Some(_), Some(block)) => Clause::new(S::StCallInside).with("block", values.block_name(block)).with("text", text.clone()),
        (Some(Part::Statement(Statement { kind: StatementKind::Return, .. })), None) => Clause::new(S::StReturn),
        (Some(part @ Part::Statement(Statement { kind: StatementKind::Case { .. }, .. })), None) if first && branches => {
            explain(part, &values, &text, first).unwrap_or_else(step)
        }
        (Some(part @ Part::Next(_)), None) if stores => explain(part, &values, &text, first).unwrap_or_else(step),
        (Some(part), None)
            if writes(part, insts, &values) || last && (!is_assignment(part) || stores) && (!is_decision(part) || branches) =>
        {
            explain(part, &values, &text, first).unwrap_or_else(step)
        }
        (Some(_), None) if insts.iter().all(|inst| matches!(inst, Inst::Return)) => Clause::new(S::StEnd),
        (Some(Part::Statement(Statement { kind: StatementKind::While { .. } | StatementKind::Repeat { .. }, .. })), None) => {
            Clause::new(S::StLoop)
        }
        _ => step(),
    };
    clause.render(language, &|_| None)
}

fn is_assignment(part: Part<'_>) -> bool {
    matches!(part, Part::Statement(Statement { kind: StatementKind::Assign { .. }, .. }))
}

/// Whether a step certainly writes the target of an assignment: one at a constant address.
fn writes(part: Part<'_>, insts: &[Inst], values: &Values<'_>) -> bool {
    let Part::Statement(Statement { kind: StatementKind::Assign { target, .. }, .. }) = part else { return false };
    let at = values.constant_place(target);
    insts.iter().any(|inst| matches!(inst, Inst::Store { place, .. } if Some(*place) == at))
}

fn is_decision(part: Part<'_>) -> bool {
    match part {
        Part::Condition(_) | Part::Until(_) => true,
        Part::Next(_) => false,
        Part::Statement(statement) => {
            matches!(statement.kind, StatementKind::If { .. } | StatementKind::While { .. } | StatementKind::Case { .. })
        }
    }
}

/// The part of a body with this place, the innermost one.
fn find(statements: &[Statement], span: Span) -> Option<Part<'_>> {
    statements.iter().find_map(|statement| {
        let inside = || statement.kind.bodies().into_iter().find_map(|body| find(body, span));
        let own = match &statement.kind {
            StatementKind::If { branches, .. } => {
                let condition = branches.iter().map(|(condition, _)| condition).find(|condition| condition.span == span);
                return condition.map(Part::Condition).or_else(inside).or_else(|| whole(statement, span));
            }
            StatementKind::For(one) if one.variable.span == span => Some(Part::Next(one)),
            StatementKind::While { condition, .. } if condition.span == span => Some(Part::Condition(condition)),
            StatementKind::Repeat { until, .. } if until.span == span => Some(Part::Until(until)),
            _ => None,
        };
        inside().or(own).or_else(|| whole(statement, span))
    })
}

/// The statement itself, if it has this place.
fn whole(statement: &Statement, span: Span) -> Option<Part<'_>> {
    (statement.span == span && !matches!(statement.kind, StatementKind::Block(_))).then_some(Part::Statement(statement))
}

/// What can be said of a part; `whole` tells that the step is the only one of it, so that what it read is what lies there now.
fn explain(part: Part<'_>, values: &Values<'_>, text: &str, whole: bool) -> Option<Clause> {
    let value = match part {
        Part::Condition(value) | Part::Until(value) => Some(value),
        Part::Next(_) => None,
        Part::Statement(statement) => match &statement.kind {
            StatementKind::Assign { value, .. } => Some(value),
            StatementKind::If { branches, .. } => branches.first().map(|(condition, _)| condition),
            StatementKind::While { condition, .. } => Some(condition),
            StatementKind::Case { selector, .. } => Some(selector),
            _ => None,
        },
    };
    let failed = value.filter(|_| whole && values.has_before()).and_then(|value| failed::of_value(value, values));
    match failed {
        Some(failed) if failed.ends => Some(failed.clause),
        Some(failed) => {
            let rest = came_of(part, values, text, whole)?.words(&|_| None);
            Some(Clause::new(S::StFailed).with("reason", failed.clause.words(&|_| None)).with("rest", rest))
        }
        None => came_of(part, values, text, whole),
    }
}

/// What came of a part in which nothing fails, or in spite of that.
fn came_of(part: Part<'_>, values: &Values<'_>, text: &str, whole: bool) -> Option<Clause> {
    let statement = match part {
        Part::Condition(condition) => return Some(decision(condition, values, [S::StTrue, S::StFalse], whole)),
        Part::Until(condition) => return Some(decision(condition, values, [S::StUntilTrue, S::StUntilFalse], whole)),
        Part::Next(for_loop) => return counts(for_loop, values),
        Part::Statement(statement) => statement,
    };
    if let StatementKind::Copy { target, .. } | StatementKind::AssignString { target, .. } = &statement.kind
        && let Some(failed) = failed::of_target(target, values).filter(|_| values.has_before())
    {
        return Some(failed.clause);
    }
    let named = |span: Span| one_line(values.slice(span));
    Some(match &statement.kind {
        StatementKind::Assign { target, value } => {
            if let Some(failed) = failed::of_target(target, values).filter(|_| values.has_before()) {
                return Some(failed.clause);
            }
            let name = named(target.span);
            let Some(bits) = values.read_behind(target, value.scalar) else {
                return Some(Clause::new(S::StAssignPart).with("target", name).with("text", named(value.span)));
            };
            let read = if whole { values.read_by(value, Some(target)) } else { Vec::new() };
            let clause = match read.is_empty() {
                true => Clause::new(S::StAssignConstant),
                false => Clause::new(S::StAssign).with("values", join(&read)),
            };
            clause.with("target", name).with("value", format_scalar(value.scalar, bits))
        }
        StatementKind::If { branches, .. } => decision(&branches.first()?.0, values, [S::StTrue, S::StFalse], whole),
        StatementKind::While { condition, .. } => decision(condition, values, [S::StTrue, S::StFalse], whole),
        StatementKind::Case { selector, .. } => {
            let clause = Clause::new(S::StCase);
            match values.compute(selector) {
                Some(bits) if whole => {
                    let shown = format_scalar(selector.scalar, bits).0;
                    clause.with("values", Words(shown.map(|value| format!("{} = {value}", named(selector.span)))))
                }
                _ => clause.with("values", format!("`{}`", named(selector.span))),
            }
        }
        StatementKind::For(for_loop) => return counts(for_loop, values),
        StatementKind::Call(call) => called(call, values),
        StatementKind::Return => Clause::new(S::StReturn),
        StatementKind::Exit { .. } => Clause::new(S::StExit),
        StatementKind::Continue { .. } => Clause::new(S::StContinue),
        StatementKind::Goto(_) => Clause::new(S::StGoto),
        _ => Clause::new(S::StStep).with("text", text.to_owned()),
    })
}

/// What the variable of FOR has come to.
fn counts(for_loop: &For, values: &Values<'_>) -> Option<Clause> {
    let bits = values.read_behind(&for_loop.variable, for_loop.scalar)?;
    let name = one_line(values.slice(for_loop.variable.span));
    Some(Clause::new(S::StFor).with("target", name).with("value", format_scalar(for_loop.scalar, bits)))
}

/// Whether a step does nothing but set and copy values of the local data.
fn prepares(insts: &[Inst]) -> bool {
    let local = |place: &ir::Place| matches!(place, ir::Place::Fixed { area: Area::Local, .. });
    insts.iter().all(|inst| match inst {
        Inst::Store { place, .. } => local(place),
        Inst::Constant { .. } | Inst::Parameter { .. } | Inst::Load { .. } => true,
        _ => false,
    })
}

/// Whether a step does nothing but leave: it jumps, or tells the caller how the block went, and ends.
fn leaves(insts: &[Inst]) -> bool {
    let br = ir::Var::from(Register::Br);
    insts.iter().all(|inst| match inst {
        Inst::Jump { .. } | Inst::Return | Inst::Load { place: ir::Place::Fixed { area: Area::Local, .. }, .. } => true,
        Inst::Constant { dst, .. } | Inst::Compute { dst, .. } => *dst == br,
        _ => false,
    })
}

/// Whether a step sets BR, the ENO of the block.
fn sets_br(insts: &[Inst]) -> bool {
    let br = ir::Var::from(Register::Br);
    insts.iter().any(|inst| matches!(inst, Inst::Constant { dst, .. } | Inst::Compute { dst, .. } if *dst == br))
}

/// A condition, and which way it leads.
fn decision(condition: &Value, values: &Values<'_>, [holds, fails]: [S; 2], whole: bool) -> Clause {
    let text = one_line(values.slice(condition.span));
    let read = if whole { values.read_by(condition, None) } else { Vec::new() };
    let outcome = if whole { values.compute(condition) } else { None };
    let clause = match outcome {
        Some(bits) if !read.is_empty() => Clause::new(if bits & 1 == 1 { holds } else { fails }).with("values", join(&read)),
        _ => {
            let shown = if read.is_empty() { Words::from("") } else { Words(join(&read).0.map(|values| format!(": {values}"))) };
            Clause::new(S::StCondition).with("values", shown)
        }
    };
    clause.with("text", text)
}

fn called(call: &Call, values: &Values<'_>) -> Clause {
    let block = match &call.callee {
        Callee::Function(block) | Callee::Method { block, .. } => values.block_name(*block),
        Callee::Instance { block, instance, .. } => {
            let of = values.block_name(*block);
            match one_line(values.slice(instance.span)) {
                name if name.is_empty() || name == of => of,
                name => format!("{name} ({of})"),
            }
        }
    };
    let given = call.arguments.iter().filter_map(|argument| match argument {
        Argument::Value { value, .. } => {
            let text = one_line(values.slice(value.span));
            let bits = values.compute(value)?;
            let shown = format_scalar(value.scalar, bits);
            // A constant says itself what it is.
            Some(if shown.0[0] == text { Words::from(text) } else { Words(shown.0.map(|shown| format!("{text} = {shown}"))) })
        }
        _ => None,
    });
    let given: Vec<Words> = given.collect();
    match given.is_empty() || !values.has_before() {
        true => Clause::new(S::StCall).with("block", block),
        false => Clause::new(S::StCallWith).with("block", block).with("values", list(&given, ", ", ", ")),
    }
}

/// `a is TRUE, b is FALSE`.
fn join(read: &[(String, Words)]) -> Words {
    let said: Vec<Words> =
        read.iter().map(|(name, value)| Words([format!("{name} is {}", value.0[0]), format!("{name} ist {}", value.0[1])])).collect();
    list(&said, ", ", ", ")
}

fn list(parts: &[Words], english: &str, german: &str) -> Words {
    let shown = &parts[..parts.len().min(SHOWN)];
    let more = if parts.len() > SHOWN { ", …" } else { "" };
    let joined =
        |language: usize, separator: &str| shown.iter().map(|words| words.0[language].as_str()).collect::<Vec<_>>().join(separator) + more;
    Words([joined(0, english), joined(1, german)])
}
