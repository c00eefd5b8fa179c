//! The organization blocks of a CONFIGURATION: which task runs which programs, and what their parameters are tied to.
//!
//! They are written as statements of Structured Text, `p1(in := x, out => y);`, and checked like those of any block.

use std::collections::BTreeMap;

use sieben_model::block::BlockId;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::bodies::Bodies;
use super::environment::{BlockNames, Environment};
use super::instances::{REMEMBERED, single_tasks};
use super::items::joined;
use super::programs::Generated;
use super::{Declared, ast};
use crate::scope::key;
use crate::st::ast::{Argument, AssignOperator, BinaryOperator, Expression, ExpressionKind, LiteralKind, Name, StatementKind};
use crate::st::check::names::{Entity, Role, Variable};
use crate::st::check::{Block, check};
use crate::st::dialect::Dialect;
use crate::st::tree::Base;

/// Cyclic interrupts with the one that every CPU type has first.
const CYCLIC: [u16; 9] = [35, 34, 33, 32, 36, 37, 38, 31, 30];
/// The longest interval of a cyclic interrupt, in milliseconds.
const INTERVAL_MAX: i64 = 60_000;
/// Nanoseconds of a millisecond.
const MILLISECOND: i64 = 1_000_000;
/// The PRIORITY of what has none: behind all others.
const LOWEST: u64 = u64::MAX;

/// What starts the programs of a task.
struct Start<'a> {
    task: &'a ast::Task,
    /// In milliseconds; 0 = each cycle, or only the edge.
    interval: i64,
    /// Where the task stands among those with SINGLE.
    single: Option<usize>,
    priority: u64,
}

/// The statements of one organization block while they are collected.
#[derive(Default)]
struct Statements {
    interval_ms: Option<u16>,
    /// For OB 1: what tasks with SINGLE run, by priority.
    events: Vec<(u64, ast::Statement)>,
    others: Vec<ast::Statement>,
}

impl<'a> Environment<'a> {
    /// Whether a CONFIGURATION says what runs.
    pub(super) fn is_configured(&self) -> bool {
        let resources = self.items.configurations.iter().flat_map(|(configuration, _)| &configuration.resources);
        resources.into_iter().any(|resource| !resource.programs.is_empty())
    }

    /// The organization blocks of all tasks.
    pub(super) fn configured(&self, exists: &dyn Fn(BlockId) -> bool, bodies: &mut Bodies) -> BTreeMap<BlockId, Generated> {
        let mut blocks: BTreeMap<BlockId, Statements> = BTreeMap::new();
        let mut cyclic: Vec<(i64, u16)> = Vec::new();
        let mut dialect = Dialect::default();
        let before = bodies.diagnostics.len();
        for &(configuration, written_in) in &self.items.configurations {
            dialect = written_in;
            for resource in &configuration.resources {
                let starts = self.starts(resource, &mut bodies.diagnostics);
                for instance in &resource.programs {
                    let wanted = key(&joined(&instance.program));
                    if !self.items.programs.iter().any(|program| key(&program.of) == wanted) {
                        let message = format!("there is no PROGRAM `{}`", joined(&instance.program));
                        bodies.diagnostics.push(Diagnostic::new(Problem::P3008, instance.program.span, message).elsewhere());
                        continue;
                    }
                    let program = name(&instance.name.text, instance.name.span);
                    let mut calls = vec![(instance.task.as_ref(), call(program.clone(), instance.arguments.clone(), instance.span))];
                    for (block, task) in &instance.bound {
                        let inside =
                            Expression { kind: ExpressionKind::Member(Box::new(program.clone()), block.clone()), span: block.span };
                        calls.push((Some(task), call(inside, Vec::new(), block.span)));
                    }
                    for (task, call) in calls {
                        let start = match task {
                            None => None,
                            Some(task) => match starts.iter().find(|start| start.task.name.is(&task.text)) {
                                Some(start) => Some(start),
                                None => {
                                    let message = format!("there is no task `{}` in this resource", task.text);
                                    bodies.diagnostics.push(Diagnostic::new(Problem::P3001, task.span, message));
                                    continue;
                                }
                            },
                        };
                        place(start, call, &mut blocks, &mut cyclic, exists, &mut bodies.diagnostics);
                    }
                }
            }
        }
        bodies.failed |= bodies.diagnostics[before..].iter().any(|diagnostic| diagnostic.severity() == Severity::Error);
        let declared = self.task_names();
        let singles: Vec<&ast::Task> = single_tasks(self.items).collect();
        if let Some(first) = singles.first() {
            // The edges are looked for in the cycle, also when a cyclic interrupt runs the rest.
            blocks.entry(BlockId::ob(1)).or_default();
            if exists(BlockId::ob(1)) {
                bodies.diagnostics.push(exists_already(BlockId::ob(1), first.span));
            }
        }
        let mut generated = BTreeMap::new();
        for (id, mut statements) in blocks {
            if exists(id) {
                continue;
            }
            let mut body = Vec::new();
            if id == BlockId::ob(1) {
                singles.iter().enumerate().for_each(|(index, task)| body.extend(edge(index, task)));
            }
            statements.events.sort_by_key(|(priority, _)| *priority);
            body.extend(statements.events.into_iter().map(|(_, statement)| statement));
            body.append(&mut statements.others);
            if let Some(checked) = self.organization_block(id, dialect, &body, &declared, bodies) {
                generated.insert(id, Generated { body: checked, interval_ms: statements.interval_ms });
            }
        }
        generated
    }

    /// Checks the statements of an organization block.
    fn organization_block(
        &self,
        id: BlockId,
        dialect: Dialect,
        body: &[ast::Statement],
        declared: &Declared,
        bodies: &mut Bodies,
    ) -> Option<crate::st::tree::Body> {
        let end = body.last().map(|statement| statement.span).unwrap_or_default();
        let block = Block { id, dialect, body, labels: &[], actions: &[], result: None, end };
        let names = BlockNames::outside(self, declared, id, dialect);
        let mut checked = check(&block, &names);
        bodies.diagnostics.append(&mut checked.diagnostics);
        bodies.calls.insert(id, checked.called);
        bodies.failed |= checked.body.is_none();
        checked.body
    }

    /// What the statements call what tasks remember.
    fn task_names(&self) -> Declared {
        let mut declared = Declared::default();
        let Some(number) = self.items.tasks else { return declared };
        for (index, task) in single_tasks(self.items).enumerate() {
            for (position, word) in REMEMBERED.iter().enumerate() {
                let variable = Variable {
                    name: format!("{}__{word}", task.name.text),
                    role: Role::Global,
                    data_type: DataType::Bool,
                    base: Base::DataBlock(number),
                    offset: (index * REMEMBERED.len() + position) as u32,
                    span: task.span,
                };
                declared.names.insert(key(&remembered(index, position)), Entity::Variable(variable));
            }
        }
        declared
    }

    /// What starts the tasks of a resource.
    fn starts(&self, resource: &'a ast::Resource, diagnostics: &mut Vec<Diagnostic>) -> Vec<Start<'a>> {
        let start = |task: &'a ast::Task| {
            for argument in &task.arguments {
                let known = ["SINGLE", "INTERVAL", "PRIORITY"];
                if let Some(name) = argument.name.as_ref().filter(|name| !known.iter().any(|known| name.is(known))) {
                    let message = format!("a task has no parameter `{}`; it has {}", name.text, known.join(", "));
                    diagnostics.push(Diagnostic::new(Problem::P6130, argument.span, message));
                }
            }
            Start {
                task,
                interval: interval(task, diagnostics),
                single: single_tasks(self.items).position(|one| std::ptr::eq(one, task)),
                priority: priority(task, diagnostics),
            }
        };
        resource.tasks.iter().map(start).collect()
    }
}

/// Puts a call into the organization block of its task.
fn place(
    start: Option<&Start<'_>>,
    call: ast::Statement,
    blocks: &mut BTreeMap<BlockId, Statements>,
    cyclic: &mut Vec<(i64, u16)>,
    exists: &dyn Fn(BlockId) -> bool,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let span = call.span;
    let main = BlockId::ob(1);
    if let Some((single, start)) = start.and_then(|start| Some((start.single?, start))) {
        let edge = name(&remembered(single, 2), start.task.span);
        blocks.entry(main).or_default().events.push((start.priority, only_if(edge, call.clone())));
    }
    let id = match start.map_or(0, |start| start.interval) {
        0 => main,
        interval => match cyclic.iter().find(|(known, _)| *known == interval) {
            Some(&(_, number)) => BlockId::ob(number),
            None => {
                let free = |number: u16| !exists(BlockId::ob(number)) && !cyclic.iter().any(|&(_, taken)| taken == number);
                let Some(number) = CYCLIC.into_iter().find(|&number| free(number)) else {
                    let message = "there are more tasks with an interval than cyclic interrupts (OB 30 to OB 38)";
                    diagnostics.push(Diagnostic::new(Problem::P6130, span, message));
                    return;
                };
                cyclic.push((interval, number));
                BlockId::ob(number)
            }
        },
    };
    if exists(id) {
        diagnostics.push(exists_already(id, span));
        return;
    }
    let statements = blocks.entry(id).or_default();
    match start {
        Some(Start { single: Some(_), interval: 0, .. }) => {}
        // While SINGLE is 1, only its edge counts.
        Some(Start { single: Some(single), interval, task, .. }) => {
            statements.interval_ms = u16::try_from(*interval).ok();
            let rests = Expression {
                kind: ExpressionKind::Unary(ast::UnaryOperator::Not, Box::new(name(&remembered(*single, 0), task.span))),
                span: task.span,
            };
            statements.others.push(only_if(rests, call));
        }
        other => {
            statements.interval_ms = other.and_then(|start| u16::try_from(start.interval).ok()).filter(|&interval| interval > 0);
            statements.others.push(call);
        }
    }
}

fn exists_already(id: BlockId, span: Span) -> Diagnostic {
    let message = format!("`{id}` exists already; it cannot also run the programs of the CONFIGURATION");
    Diagnostic::new(Problem::P3002, span, message)
        .help("Leave the organization block away, or the CONFIGURATION, and call the programs there.")
}

/// `now := single; edge := now AND NOT was; was := now;`.
fn edge(index: usize, task: &ast::Task) -> Vec<ast::Statement> {
    let span = task.span;
    let Some(single) = task.argument("SINGLE") else { return Vec::new() };
    let [now, was, edge] = [0, 1, 2].map(|position| name(&remembered(index, position), span));
    let rested = Expression { kind: ExpressionKind::Unary(ast::UnaryOperator::Not, Box::new(was.clone())), span };
    let rises = ExpressionKind::Binary(BinaryOperator::And, span, Box::new(now.clone()), Box::new(rested));
    vec![assign(now.clone(), single.clone(), span), assign(edge, Expression { kind: rises, span }, span), assign(was, now, span)]
}

/// The name of what a task remembers in the statements; no source can write it.
fn remembered(task: usize, position: usize) -> String {
    format!("{task} {}", REMEMBERED[position])
}

fn name(text: &str, span: Span) -> Expression {
    Expression { kind: ExpressionKind::Name(Name { text: text.to_owned(), span, ..Name::default() }), span }
}

fn assign(target: Expression, value: Expression, span: Span) -> ast::Statement {
    ast::Statement { kind: StatementKind::Assign { targets: vec![target], operator: AssignOperator::Becomes, value }, span }
}

fn call(callee: Expression, arguments: Vec<Argument>, span: Span) -> ast::Statement {
    let call = ExpressionKind::Call(Box::new(ast::Call { callee, arguments }));
    ast::Statement { kind: StatementKind::Expression(Expression { kind: call, span }), span }
}

fn only_if(condition: Expression, statement: ast::Statement) -> ast::Statement {
    let span = statement.span;
    ast::Statement { kind: StatementKind::If { branches: vec![ast::Branch { condition, body: vec![statement] }], otherwise: None }, span }
}

/// The interval of a task in milliseconds; 0 if it has none.
fn interval(task: &ast::Task, diagnostics: &mut Vec<Diagnostic>) -> i64 {
    let Some(value) = task.argument("INTERVAL") else { return 0 };
    match &value.kind {
        ExpressionKind::Literal(ast::Literal { kind: LiteralKind::Duration { nanoseconds, .. }, .. })
            if nanoseconds % MILLISECOND == 0 && (0..=INTERVAL_MAX).contains(&(nanoseconds / MILLISECOND)) =>
        {
            nanoseconds / MILLISECOND
        }
        _ => {
            let message = "the INTERVAL of a task is 0 to 60 s, in whole milliseconds: `INTERVAL := T#100ms`";
            diagnostics.push(Diagnostic::new(Problem::P6130, value.span, message));
            0
        }
    }
}

/// The priority of a task; 0 comes first.
fn priority(task: &ast::Task, diagnostics: &mut Vec<Diagnostic>) -> u64 {
    let Some(value) = task.argument("PRIORITY") else { return LOWEST };
    let number = match &value.kind {
        ExpressionKind::Literal(ast::Literal { kind: LiteralKind::Integer { value, .. }, .. }) => u64::try_from(*value).ok(),
        _ => None,
    };
    number.unwrap_or_else(|| {
        let message = "the PRIORITY of a task is a number, 0 or more; 0 comes first: `PRIORITY := 1`";
        diagnostics.push(Diagnostic::new(Problem::P6130, value.span, message));
        LOWEST
    })
}
