//! The statements of all blocks of ST: checked, lowered, and the organization blocks that run the programs.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::Arc;

use sieben_engine::CodeBlock;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::interface::Interface;
use sieben_model::problems::Problem;
use sieben_model::testing::{Signal, TestPlan, WordCall};

use super::ast;
use super::constructors::Beginning;
use super::environment::{Environment, starting};
use super::items::Code;
use super::programs::Generated;
use super::{Located, organization_blocks};
use crate::coverage::Countable;
use crate::declarations::interface::{lay_out, too_much_local_data};
use crate::st::check::{Block, Checked, check};
use crate::st::dialect::{Construct, Judgement};
use crate::st::lower::{Known, lower, lower_counted};
use crate::st::tree::{Body, TypedBlock};

/// The organization block of a warm restart.
const WARM_RESTART: u16 = 100;
/// The organization block of a cold restart.
const COLD_RESTART: u16 = 102;

/// What became of the statements.
#[derive(Default)]
pub(crate) struct Bodies {
    /// What no source writes, lowered.
    pub(crate) code: BTreeMap<BlockId, CodeBlock>,
    pub(crate) made: BTreeMap<BlockId, TypedBlock>,
    pub(crate) calls: BTreeMap<BlockId, BTreeSet<BlockId>>,
    pub(crate) intervals: BTreeMap<u16, u16>,
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// The tests, if one of the files holds some.
    pub(crate) tests: TestPlan,
    /// A block could not be compiled.
    pub(crate) failed: bool,
}

/// A block of ST whose statements were checked.
#[derive(Default)]
pub(crate) struct CheckedStatements {
    /// Its statements, if all of them were understood.
    pub(crate) typed: Option<TypedBlock>,
    pub(crate) diagnostics: Vec<Diagnostic>,
    pub(crate) told: Told,
}

/// What a block of ST tells besides its statements.
#[derive(Clone, Debug, Default)]
pub(crate) struct Told {
    /// The blocks that it calls; `None` if it has no statements.
    calls: Option<BTreeSet<BlockId>>,
    /// The words of tests in it, and what they write, by the first byte of their place.
    words: BTreeMap<u32, WordCall>,
    writes: BTreeMap<u32, Signal>,
    /// It could not be compiled.
    failed: bool,
}

impl Bodies {
    /// Takes in what a block tells.
    pub(crate) fn add(&mut self, id: BlockId, is_test: bool, told: &Told) {
        self.failed |= told.failed;
        self.tests.words.extend(told.words.iter().map(|(&place, word)| (place, word.clone())));
        self.tests.writes.extend(told.writes.iter().map(|(&place, signal)| (place, signal.clone())));
        if let Some(calls) = &told.calls {
            self.calls.insert(id, calls.clone());
            if is_test {
                self.tests.blocks.insert(id);
            }
        }
    }
}

impl Environment<'_> {
    /// What stands outside of all blocks, when the statements of all blocks are checked: the organization blocks that run the programs
    /// and the tests, and what is wrong between blocks.
    pub(crate) fn finish(&self, cpu: &CpuType, exists: &dyn Fn(BlockId) -> bool, bodies: &mut Bodies) {
        self.recursion(bodies);
        let wrong = self.object_rules();
        bodies.failed |= !wrong.is_empty();
        bodies.diagnostics.extend(wrong);
        let mut generated = match self.is_configured() {
            true => self.configured(exists, bodies),
            false => organization_blocks(self.items, &bodies.calls, exists, &mut bodies.diagnostics),
        };
        let beginning = self.beginning(bodies);
        self.restarts(cpu, exists, &beginning, &mut generated, &mut bodies.diagnostics);
        for (id, generated) in generated {
            let Some(block) = lay_out(id, Vec::new()) else { continue };
            let calls = generated.body.statements.iter().filter_map(|statement| match &statement.kind {
                crate::st::tree::StatementKind::Call(call) => Some(call.callee.block()),
                _ => None,
            });
            let mut calls: BTreeSet<BlockId> = calls.collect();
            if [WARM_RESTART, COLD_RESTART].contains(&id.number) {
                calls.extend(&beginning.called);
            }
            bodies.calls.entry(id).or_insert(calls);
            let known = Known { interface: &|block| self.interface_of(block), is_stl: &|_| false };
            bodies.code.insert(id, lower(id, &block.interface, &generated.body, &known));
            bodies.made.insert(id, TypedBlock { interface: block.interface, body: generated.body });
            bodies.intervals.extend(generated.interval_ms.map(|interval| (id.number, interval)));
        }
        self.tests(bodies);
    }

    /// The organization blocks of a restart write the initial values of variables with an address.
    fn restarts(
        &self,
        cpu: &CpuType,
        exists: &dyn Fn(BlockId) -> bool,
        beginning: &Beginning,
        generated: &mut BTreeMap<BlockId, Generated>,
        diagnostics: &mut Vec<Diagnostic>,
    ) {
        for (restart, keeps) in [(WARM_RESTART, true), (COLD_RESTART, false)] {
            let id = BlockId::ob(restart);
            let mut written = self.located.iter().filter(|one| !(keeps && one.retain)).peekable();
            let begins = (!beginning.body.statements.is_empty()).then_some(beginning.span);
            let Some(first) = written.peek().map(|one| one.variable.span).or(begins) else { continue };
            if !cpu.has_organization_block(restart) {
                continue;
            }
            if exists(id) {
                let (message, help) = match written.peek() {
                    Some(_) => (
                        format!("`{id}` exists already; it cannot also write initial values of variables with an address"),
                        "Assign the values there, and leave the initial values away.",
                    ),
                    None => (
                        format!("`{id}` exists already; it cannot also call FB_Init and set references"),
                        "Leave the organization block away.",
                    ),
                };
                diagnostics.push(Diagnostic::new(Problem::P3002, first, message).help(help));
                continue;
            }
            let one = generated.entry(id).or_insert_with(|| Generated { body: Body::default(), interval_ms: None });
            for Located { variable, initial, .. } in written {
                one.body.statements.extend(starting(variable, initial, variable.span));
            }
            one.body.statements.extend(beginning.body.statements.iter().cloned());
            one.body.local_size = one.body.local_size.max(beginning.body.local_size);
        }
    }

    /// Says which functions call themselves, directly or through others: one message for each circle.
    fn recursion(&self, bodies: &mut Bodies) {
        let mut told = BTreeSet::new();
        for (&id, &code) in &self.items.code {
            if id.kind != BlockKind::Function || told.contains(&id) {
                continue;
            }
            let Some(circle) = circle(id, &bodies.calls) else { continue };
            told.extend(circle.iter().copied());
            let row = Construct::Recursion.row();
            let title = code.dialect.title();
            let (problem, message) = match code.dialect.judge(Construct::Recursion) {
                Judgement::Accept => continue,
                Judgement::Note => (Problem::P6051, format!("{} is not usual in {title}", row.title)),
                Judgement::Reject => (Problem::P6050, format!("{title} does not have {}", row.title)),
            };
            let shown = |id: &BlockId| self.items.names.get(id).cloned().unwrap_or_else(|| id.to_string());
            let path: Vec<String> = circle.iter().chain([&id]).map(|id| format!("`{}`", shown(id))).collect();
            let help = format!(
                "{} calls {}: write a loop, or mind that each call takes local data and a level of nesting.",
                path[0],
                path[1..].join(" calls ")
            );
            bodies.failed |= problem == Problem::P6050;
            bodies.diagnostics.push(Diagnostic::new(problem, code.block.name.span, message).help(help));
        }
    }

    pub(super) fn interface_of(&self, block: BlockId) -> Option<Arc<Interface>> {
        self.ask(block);
        self.interfaces.get(&block).map(|found| Arc::clone(&found.interface))
    }

    /// Checks the statements of a block.
    pub(crate) fn check_block(&self, id: BlockId, code: Code<'_>, cpu: &CpuType) -> CheckedStatements {
        let mut done = CheckedStatements::default();
        let (Some(names), Some(interface)) = (self.names(id, code.dialect), self.interface_of(id)) else {
            done.told.failed = true;
            return done;
        };
        let loadable = code.dialect != code.dialect.base() || !code.dialect.switches().local_data_limited;
        done.diagnostics.extend(too_much_local_data(|| names.shown(), &interface, cpu, code.block.name.span, loadable));
        if !matches!(id.kind, BlockKind::Function | BlockKind::FunctionBlock | BlockKind::OrganizationBlock) {
            return done;
        }
        // Nothing calls it: what is called is the method of the block that the instance is of.
        if code.block.kind == ast::BlockKind::Interface || code.block.member.is_some() && code.block.modifiers.is_abstract {
            return done;
        }
        let block = Block {
            id,
            dialect: code.dialect,
            body: &code.block.body,
            labels: &code.block.labels,
            actions: &code.block.actions,
            result: names.result(),
            end: code.block.end,
        };
        let mut checked = check(&block, &names);
        let sound = !checked.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error);
        self.words(id, &mut checked);
        let Checked { body, mut diagnostics, called, words, writes } = checked;
        done.diagnostics.append(&mut diagnostics);
        let whole = sound && self.declared(id).is_some_and(|declared| !declared.broken);
        done.typed = body.filter(|_| whole).map(|body| TypedBlock { interface, body });
        done.told = Told { calls: Some(called), words, writes, failed: done.typed.is_none() };
        done
    }

    /// The code of a block, and what can be counted in it, if that is asked for.
    pub(crate) fn lower_block(&self, id: BlockId, code: Code<'_>, typed: &TypedBlock, counted: bool) -> (CodeBlock, Option<Countable>) {
        let place = code.block.name.span;
        let mut statements = self.names(id, code.dialect).map(|names| names.starting_statements(place)).unwrap_or_default();
        let with_starting;
        let body = if statements.is_empty() {
            &typed.body
        } else {
            statements.extend(typed.body.statements.iter().cloned());
            with_starting = Body { statements, ..typed.body.clone() };
            &with_starting
        };
        let is_stl = |block: BlockId| {
            block.kind == BlockKind::FunctionBlock && !self.items.code.contains_key(&block) && !self.links.contains_key(&block)
        };
        let known = Known { interface: &|block| self.interface_of(block), is_stl: &is_stl };
        if !counted {
            return (lower(id, &typed.interface, body, &known), None);
        }
        let (lowered, mut countable) = lower_counted(id, &typed.interface, body, &known);
        // What gives variables their initial values is no statement of the source.
        countable.statements.retain(|(span, _)| *span != place);
        (lowered, Some(countable))
    }
}

/// The shortest way from a block through its calls back to it, without its end; `None` if there is none.
fn circle(start: BlockId, calls: &BTreeMap<BlockId, BTreeSet<BlockId>>) -> Option<Vec<BlockId>> {
    let mut before = BTreeMap::new();
    let mut queue = VecDeque::from([start]);
    while let Some(caller) = queue.pop_front() {
        for &called in calls.get(&caller).into_iter().flatten() {
            if called == start {
                let mut path = vec![caller];
                while let Some(&earlier) = before.get(path.last()?) {
                    path.push(earlier);
                }
                path.reverse();
                return Some(path);
            }
            before.entry(called).or_insert_with(|| {
                queue.push_back(called);
                caller
            });
        }
    }
    None
}
