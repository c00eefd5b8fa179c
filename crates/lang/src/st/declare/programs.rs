//! Organization blocks that call the programs of a project.

use std::collections::BTreeMap;

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::ast;
use super::items::{Items, Program};
use crate::scope::key;
use crate::st::ast::{ExpressionKind, LiteralKind};
use crate::st::tree::{Base, Body, Call, Callee, Place, Statement, StatementKind};

/// An organization block that no source writes.
#[derive(Clone, Debug)]
pub(crate) struct Generated {
    pub(crate) body: Body,
    /// How often it is called, in milliseconds; `None` for OB 1.
    pub(crate) interval_ms: Option<u16>,
}

/// Cyclic interrupts with the one that every CPU type has first.
const CYCLIC: [u16; 9] = [35, 34, 33, 32, 36, 37, 38, 31, 30];
/// The longest interval of a cyclic interrupt, in milliseconds.
const INTERVAL_MAX: i64 = 60_000;
/// Nanoseconds of a millisecond.
const MILLISECOND: i64 = 1_000_000;

/// The organization blocks that run the programs: with a CONFIGURATION those of its tasks, else OB 1 unless a source writes it.
pub(crate) fn organization_blocks(
    items: &Items<'_>,
    exists: &dyn Fn(BlockId) -> bool,
    diagnostics: &mut Vec<Diagnostic>,
) -> BTreeMap<BlockId, Generated> {
    let mut generated = BTreeMap::new();
    if items.programs.is_empty() {
        return generated;
    }
    if items.configurations.iter().any(|(configuration, _)| configuration.resources.iter().any(|resource| !resource.programs.is_empty())) {
        configured(items, exists, &mut generated, diagnostics);
        return generated;
    }
    let main = BlockId::ob(1);
    if exists(main) {
        for program in items.programs.iter().filter(|program| program.implicit) {
            let message = "these statements stand outside any block, and `OB 1` exists already";
            diagnostics.push(Diagnostic::new(Problem::P3002, program.span, message));
        }
        return generated;
    }
    // Of several programs of CODESYS only PLC_PRG runs by itself.
    let default = items.programs.iter().find(|program| key(&program.name) == "plc_prg");
    for program in &items.programs {
        if default.is_none_or(|default| default.block == program.block) {
            add(&mut generated, main, program, None);
        }
    }
    generated
}

/// Lets an organization block call a program.
fn add(generated: &mut BTreeMap<BlockId, Generated>, block: BlockId, program: &Program, interval_ms: Option<u16>) {
    let span = program.span;
    let instance = Place { base: Base::DataBlock(program.instance), offset: 0, indexes: Vec::new(), span };
    let callee = Callee::Instance { block: program.block, instance, dispatch: None };
    let call = Call { callee, arguments: Vec::new(), enable: None, result: DataType::Void, clears_ok: false, written_out: None, span };
    let one = generated.entry(block).or_insert_with(|| Generated { body: Body::default(), interval_ms });
    one.body.statements.push(Statement { kind: StatementKind::Call(call), span });
}

fn configured(
    items: &Items<'_>,
    exists: &dyn Fn(BlockId) -> bool,
    generated: &mut BTreeMap<BlockId, Generated>,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let mut called: Vec<BlockId> = Vec::new();
    let mut cyclic: Vec<(i64, u16)> = Vec::new();
    let resources = items.configurations.iter().flat_map(|(configuration, _)| &configuration.resources);
    for resource in resources {
        for instance in &resource.programs {
            let words: Vec<&str> = instance.program.names.iter().map(|name| name.text.as_str()).collect();
            let wanted = key(&words.join("."));
            let Some(program) = items.programs.iter().find(|program| key(&program.name) == wanted) else {
                let message = format!("there is no PROGRAM `{}`", words.join("."));
                diagnostics.push(Diagnostic::new(Problem::P3008, instance.program.span, message));
                continue;
            };
            if called.contains(&program.block) || !instance.arguments.is_empty() || !instance.bound.is_empty() {
                let what = if called.contains(&program.block) { "a second instance of a PROGRAM" } else { "a PROGRAM with parameters" };
                diagnostics.push(Diagnostic::new(Problem::P6199, instance.span, format!("{what} cannot be compiled yet")));
                continue;
            }
            called.push(program.block);
            let interval = match &instance.task {
                None => 0,
                Some(name) => match resource.tasks.iter().find(|task| task.name.is(&name.text)) {
                    Some(task) => interval(task, diagnostics),
                    None => {
                        diagnostics.push(Diagnostic::new(Problem::P3001, name.span, format!("there is no task `{}`", name.text)));
                        0
                    }
                },
            };
            let block = match interval {
                0 => BlockId::ob(1),
                interval => match cyclic.iter().find(|(known, _)| *known == interval) {
                    Some(&(_, number)) => BlockId::ob(number),
                    None => match CYCLIC
                        .iter()
                        .find(|&&number| !exists(BlockId::ob(number)) && !cyclic.iter().any(|&(_, taken)| taken == number))
                    {
                        Some(&number) => {
                            cyclic.push((interval, number));
                            BlockId::ob(number)
                        }
                        None => {
                            let message = "there are more tasks with an interval than cyclic interrupts (OB 30 to OB 38)";
                            diagnostics.push(Diagnostic::new(Problem::P6130, instance.span, message));
                            continue;
                        }
                    },
                },
            };
            if exists(block) {
                let message = format!("`{block}` exists already; it cannot also run the programs of the CONFIGURATION");
                diagnostics.push(Diagnostic::new(Problem::P3002, instance.span, message));
                continue;
            }
            add(generated, block, program, u16::try_from(interval).ok().filter(|&interval| interval > 0));
        }
    }
}

/// The interval of a task in milliseconds; 0 if it has none.
fn interval(task: &ast::Task, diagnostics: &mut Vec<Diagnostic>) -> i64 {
    let mut interval = 0;
    for argument in &task.arguments {
        let (Some(name), Some(value)) = (&argument.name, &argument.value) else { continue };
        if name.is("SINGLE") {
            diagnostics.push(Diagnostic::new(Problem::P6199, argument.span, "a task with SINGLE cannot be compiled yet"));
        } else if name.is("INTERVAL") {
            match &value.kind {
                ExpressionKind::Literal(ast::Literal { kind: LiteralKind::Duration { nanoseconds, .. }, .. })
                    if nanoseconds % MILLISECOND == 0 && (0..=INTERVAL_MAX).contains(&(nanoseconds / MILLISECOND)) =>
                {
                    interval = nanoseconds / MILLISECOND;
                }
                _ => {
                    let message = "the INTERVAL of a task is 0 to 60 s, in whole milliseconds: `INTERVAL := T#100ms`";
                    diagnostics.push(Diagnostic::new(Problem::P6130, value.span, message));
                }
            }
        }
    }
    interval
}
