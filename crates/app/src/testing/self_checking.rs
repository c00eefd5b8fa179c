//! A program that checks itself: it has passed when it reaches `CALL SFC 46`, and failed when an assertion is false.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use sieben_cpu::diagnostic_buffer::place_text;
use sieben_cpu::{Cpu, OperatingMode, Restart, StopCause};
use sieben_engine::Tracer;
use sieben_jit::StatusBits;
use sieben_model::source::FileId;

use sieben_ide::cross_reference::CrossReference;
use sieben_ide::target::Target;
use sieben_model::block::{BlockId, BlockKind};
use sieben_workspace::controller;
use sieben_workspace::coverage::{Counting, looking};
use sieben_workspace::duration;
use sieben_workspace::finding;
use sieben_workspace::project::{Build, Overrides};
use sieben_workspace::schedule;

use super::time_limit::TimeLimit;
use super::{After, Conditions, Outcome, Verdict, Wrong};
use crate::engines::EngineArgument;
use crate::project;
use crate::report;

/// Virtual time in which such a program has to end if nothing is said.
const LIMIT: Duration = Duration::from_secs(60);
/// STOP by the program: the end of a program that checks itself.
const STOP_BY_PROGRAM: u16 = 0x457F;

/// Runs a program until it ends; one that is not `named` as a test must have words to check itself. The blocks of `test`, if there is one, take the place of those of the program.
pub(crate) fn run(paths: &[PathBuf], test: Option<&PathBuf>, named: bool, conditions: &Conditions) -> Outcome {
    let begun = Instant::now();
    let nothing_ran = Outcome::nothing_ran;
    let mut all: Vec<PathBuf> = test.into_iter().cloned().collect();
    all.extend(paths.iter().cloned());
    let project = match project::load(&all, conditions.encoding) {
        Ok(project) => project,
        Err(failure) => return nothing_ran(Verdict::Unreadable(failure.refusal)),
    };
    // A program that checks itself cannot do without the words for it.
    let overrides = Overrides { extended: true, replacing: test.is_some(), counted: conditions.coverage.is_some(), ..conditions.overrides };
    let build = project.compile(overrides, false);
    if finding::has_errors(&build.findings) {
        return nothing_ran(Verdict::DoesNotCompile(report::parts(&build.findings, &build.project.texts)));
    }
    if !named && !checks_itself(&build) {
        return nothing_ran(Verdict::NoTest);
    }
    // Who counts statements needs the interpreter.
    let engine = if conditions.coverage.is_some() { EngineArgument::Interpreter } else { conditions.engine };
    let mut cpu = controller::load(&build, engine.factory(StatusBits::All), controller::settings(&build));
    let cycle = schedule::going_cycle(conditions.cycle, &build.project.settings);
    let limit = conditions.limit.unwrap_or(LIMIT);
    let time_limit = TimeLimit::start(&cpu, conditions.timeout.saturating_sub(begun.elapsed()));
    let looking = looking(&build.compiled);
    let mut counting = conditions.coverage.is_some().then(|| Counting::new(&looking));
    cpu.restart_with(Restart::Warm, &mut || 0, tracer(&mut counting));
    let (mut scans, mut now) = (0, Duration::ZERO);
    let give_up = loop {
        if cpu.mode() == OperatingMode::Stop && !time_limit.has_ended_it() {
            break None;
        }
        if now >= limit {
            break Some(format!("{} of virtual time", duration::show(limit)));
        }
        if conditions.scans.is_some_and(|most| scans >= most) {
            break Some(format!("{scans} scans"));
        }
        if begun.elapsed() >= conditions.timeout {
            break Some(format!("{} ({scans} scans)", duration::show(conditions.timeout)));
        }
        let at = duration::micros(now);
        cpu.scan_with(&mut || at, tracer(&mut counting));
        scans += 1;
        now = now.saturating_add(cycle);
    };
    let simulated = cycle.saturating_mul(u32::try_from(scans.saturating_sub(1)).unwrap_or(u32::MAX));
    let verdict = match give_up {
        Some(after) => Verdict::Failed(Box::new(Wrong {
            message: format!("did not end within {after}; a program that checks itself ends with `CALL SFC 46`"),
            ..Wrong::default()
        })),
        None => cpu.stop_cause().map_or(Verdict::Passed, |cause| verdict(&build, &cpu, cause)),
    };
    let outcome = Outcome::new(verdict, scans, simulated, After::of(&build, &cpu, conditions), conditions);
    if let Some((collector, counting)) = conditions.coverage.as_ref().zip(counting) {
        // The first file is the test, if there is one.
        collector.add(&Arc::new(build), test.map(|_| FileId(0)), counting.counts);
    }
    outcome
}

fn tracer<'a>(counting: &'a mut Option<Counting<'_>>) -> Option<&'a mut dyn Tracer> {
    counting.as_mut().map(|counting| counting as &mut dyn Tracer)
}

/// Whether a program checks itself; one that cannot be read or compiled says so when it is run.
pub(crate) fn is_test(paths: &[PathBuf], conditions: &Conditions) -> bool {
    let Ok(project) = project::load(paths, conditions.encoding) else { return true };
    let build = project.compile(Overrides { extended: true, ..conditions.overrides }, false);
    finding::has_errors(&build.findings) || checks_itself(&build)
}

/// Whether a program has an assertion or an end: nothing else makes it a test.
fn checks_itself(build: &Build) -> bool {
    let stp = Target::Block(BlockId::new(BlockKind::SystemFunction, 46));
    build.compiled.bodies.values().any(|body| body.has_assertion())
        || CrossReference::new(&build.compiled).references.iter().any(|reference| reference.target == stp)
}

/// What the STOP of the CPU means.
fn verdict(build: &Build, cpu: &Cpu, cause: &StopCause) -> Verdict {
    if cause.event == STOP_BY_PROGRAM && cause.first_event == STOP_BY_PROGRAM {
        return Verdict::Passed;
    }
    let failed = cpu.failed_assertion();
    let line = controller::stop_line(build, cause);
    Verdict::Failed(Box::new(Wrong {
        message: failed
            .map_or_else(|| format!("the CPU went to STOP: {}", controller::named(build, &cause.text, cause.place)), ToString::to_string),
        place: line.as_ref().map(|line| (line.file.clone(), line.number)),
        statement: line.map(|line| line.statement),
        block: cause.place.map(place_text),
        values: failed.map(|failed| (failed.left.to_string(), failed.right.to_string())),
        ..Wrong::default()
    }))
}
