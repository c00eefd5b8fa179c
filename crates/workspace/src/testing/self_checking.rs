//! A program that checks itself: it has passed when it reaches `CALL SFC 46`, and failed when an assertion is false.

use std::sync::Arc;
use std::time::Duration;

use sieben_cpu::diagnostic_buffer::place_text;
use sieben_cpu::{Cpu, OperatingMode, Restart, StopCause};
use sieben_engine::Tracer;
use sieben_ide::cross_reference::CrossReference;
use sieben_ide::target::Target;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::source::FileId;

use super::{After, Conditions, Outcome, Stopwatch, Verdict, Wrong};
use crate::controller;
use crate::coverage::{Counting, looking};
use crate::duration;
use crate::finding;
use crate::project::{Build, Overrides, Project};
use crate::schedule;

/// Virtual time in which such a program has to end if nothing is said.
const LIMIT: Duration = Duration::from_secs(60);
/// STOP by the program: the end of a program that checks itself.
const STOP_BY_PROGRAM: u16 = 0x457F;

/// Whether the blocks of the first source, which is a test, take the place of those of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FirstSource {
    /// It is a test, and its blocks do.
    Replaces,
    /// It is one of the program.
    Belongs,
}

/// Runs a program until it ends; one that is not `named` as a test must have words to check itself. `stopwatch` runs since its files were read.
pub fn run(project: Project, first: FirstSource, named: bool, stopwatch: &Stopwatch, conditions: &Conditions) -> Outcome {
    let nothing_ran = Outcome::nothing_ran;
    // A program that checks itself cannot do without the words for it.
    let replacing = first == FirstSource::Replaces;
    let overrides = Overrides { extended: true, replacing, counted: conditions.coverage.is_some(), ..conditions.overrides };
    let build = match conditions.compile(project, overrides) {
        Ok(build) => build,
        Err(verdict) => return nothing_ran(verdict),
    };
    if !named && !checks_itself(&build) {
        return nothing_ran(Verdict::NoTest);
    }
    let mut cpu = Cpu::new(conditions.loaded(build.cpu, &build), controller::rack(&build), controller::settings(&build));
    let cycle = schedule::going_cycle(conditions.cycle, &build.project.settings);
    let limit = conditions.limit.unwrap_or(LIMIT);
    let time_limit = conditions.outside.stop_after(cpu.stop_request(), conditions.timeout.saturating_sub(stopwatch.elapsed()));
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
        if stopwatch.elapsed() >= conditions.timeout {
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
        collector.add(&Arc::new(build), replacing.then_some(FileId(0)), counting.counts);
    }
    outcome
}

fn tracer<'a>(counting: &'a mut Option<Counting<'_>>) -> Option<&'a mut dyn Tracer> {
    counting.as_mut().map(|counting| counting as &mut dyn Tracer)
}

/// Whether a program checks itself; one that does not compile says so when it is run.
pub fn is_test(project: Project, conditions: &Conditions) -> bool {
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
