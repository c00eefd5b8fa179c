//! Unit tests: a test file with the program that it tests, compiled once, and each of its tests on a CPU of its own.

use std::sync::Arc;
use std::time::Duration;

use sieben_cpu::{Cpu, Loaded, Settings};
use sieben_engine::{Interpreter, Tracer};
use sieben_model::address::Operand;
use sieben_model::cpu_type::CpuType;
use sieben_model::source::Span;
use sieben_model::testing::{Signal, Test};
use sieben_sim::names::Name;
use sieben_sim::runner::{self, Limits, Watcher, Writers};
use sieben_sim::timing_diagram;
use sieben_sim::trace::{Keep, Memory, Origin, Recorder, Trace};

use super::{After, Case, Conditions, Outcome, Stopwatch, Verdict, Wrong, drawing};
use crate::controller;
use crate::coverage::{Counting, Looking, looking};
use crate::duration;
use crate::last_change;
use crate::project::{Build, Overrides, Project};
use crate::refusal::Refusal;
use crate::schedule;

/// Scans that the diagram of a failed test shows.
const TRAIL: u64 = 40;
/// Variables that it shows.
const LANES_MAX: usize = 16;
/// Scans in which a test has to end if nothing is said.
const SCANS: u64 = 10_000_000;
/// Virtual time in which a test has to end if nothing is said: as long as a TIME can be, four times.
const TIME: Duration = Duration::from_secs(100 * 24 * 3600);

/// A test file, ready to run.
struct Ready {
    build: Arc<Build>,
    /// What its statements look at, if that is counted.
    looking: Looking,
    loaded: Loaded,
    settings: Settings,
    cpu: &'static CpuType,
    cycle: Duration,
}

/// The tests of a file, which is called so, with the program that it tests, and is the last source of the project. If it cannot be read or
/// does not compile, one case says so.
pub fn cases(name: &str, project: Result<Project, Refusal>, conditions: &Conditions) -> Vec<Case> {
    match project.map_err(Verdict::Unreadable).and_then(|project| compile(project, conditions)) {
        Err(verdict) => {
            let verdict = std::sync::Mutex::new(Some(verdict));
            let run = move |_: &Conditions| {
                let told = verdict.lock().unwrap_or_else(std::sync::PoisonError::into_inner).take();
                Outcome::nothing_ran(told.unwrap_or(Verdict::NoTest))
            };
            vec![Case { file: Some(name.to_owned()), ..Case::new(name.to_owned(), Box::new(run)) }]
        }
        Ok(ready) => {
            let ready = Arc::new(ready);
            let tests = ready.build.compiled.tests.tests.clone();
            let texts = &ready.build.project.texts.program;
            let text = tests.first().map_or("", |test| texts.file(test.span.file).text.as_str());
            let ends: Vec<usize> = text.match_indices('\n').map(|(end, _)| end).collect();
            let case = |test: Test| {
                let ready = Arc::clone(&ready);
                let full = format!("{name}: {}", test.name);
                let line = ends.partition_point(|&end| end < test.span.start as usize) + 1;
                let run = move |conditions: &Conditions| run(&ready, &test, conditions);
                Case { file: Some(name.to_owned()), line: Some(line), ..Case::new(full, Box::new(run)) }
            };
            tests.into_iter().map(case).collect()
        }
    }
}

fn compile(project: Project, conditions: &Conditions) -> Result<Ready, Verdict> {
    let overrides = Overrides { tests: true, counted: conditions.coverage.is_some(), ..conditions.overrides };
    let build = conditions.compile(project, overrides)?;
    let cpu = controller::with_room(build.cpu);
    let loaded = conditions.loaded(cpu, &build);
    let settings = controller::settings(&build);
    let cycle = schedule::going_cycle(conditions.cycle, &build.project.settings);
    let looking = looking(&build.compiled);
    Ok(Ready { build: Arc::new(build), looking, loaded, settings, cpu, cycle })
}

/// Gives a test up when its real time is over, and counts its statements.
struct Deadline<'a> {
    stopwatch: Stopwatch,
    timeout: Duration,
    counting: Option<Counting<'a>>,
}

impl Watcher for Deadline<'_> {
    fn may_go_on(&mut self) -> bool {
        self.stopwatch.elapsed() < self.timeout
    }
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        self.counting.as_mut().map(|counting| counting as &mut dyn Tracer)
    }
}

/// The second run of a test that failed: who changed the variables of the assertion.
struct Again {
    deadline: Deadline<'static>,
    writers: Writers,
    /// The values of the variables behind the last scans.
    trail: Option<Recorder>,
    scans: u64,
}

impl Watcher for Again {
    fn may_go_on(&mut self) -> bool {
        self.deadline.may_go_on()
    }
    fn before_restart(&mut self) {
        self.writers.before_restart();
    }
    fn restarted(&mut self, cpu: &Cpu) {
        self.writers.restarted(cpu);
    }
    fn before_scan(&mut self, cpu: &Cpu) {
        self.writers.before_scan(cpu);
    }
    fn scanned(&mut self, cpu: &Cpu) {
        if let Some(trail) = &mut self.trail
            && trail.scan(cpu, self.scans, cpu.now_us()).is_err()
        {
            self.trail = None;
        }
        self.scans += 1;
    }
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        self.writers.tracer()
    }
}

fn run(ready: &Ready, test: &Test, conditions: &Conditions) -> Outcome {
    let limits = Limits {
        cycle_us: duration::micros(ready.cycle),
        time_us: duration::micros(conditions.limit.unwrap_or(TIME)),
        scans: conditions.scans.unwrap_or(SCANS),
    };
    let mut cpu = Cpu::new(ready.loaded.clone(), controller::rack(&ready.build), ready.settings.clone());
    let counting = conditions.coverage.is_some().then(|| Counting::new(&ready.looking));
    let mut watcher = Deadline { stopwatch: Stopwatch::start(&conditions.outside), timeout: conditions.timeout, counting };
    let build = &ready.build;
    let limit = conditions.outside.stop_after(cpu.stop_request(), conditions.timeout);
    let mut report = runner::run(test, &build.compiled.tests, &build.project.texts.program, &mut cpu, limits, &mut watcher);
    if let Some(wrong) = report.wrong.as_mut().filter(|wrong| !wrong.endless && limit.has_ended_it()) {
        // The STOP was ours.
        *wrong = runner::Wrong {
            message: "the test took too long and was given up".to_owned(),
            span: wrong.span,
            endless: true,
            ..Default::default()
        };
    }
    let simulated = Duration::from_micros(report.time_us);
    let verdict = match report.wrong {
        None => Verdict::Passed,
        Some(wrong) => {
            let mut told = failed(build, test, &wrong, conditions);
            // A test that has used up its time gets no second run.
            let left = conditions.timeout.saturating_sub(watcher.stopwatch.elapsed());
            if !left.is_zero() {
                told.lines.extend(again(ready, test, &wrong, limits, conditions, left));
            }
            Verdict::Failed(Box::new(told))
        }
    };
    if let Some((collector, counting)) = conditions.coverage.as_ref().zip(watcher.counting) {
        collector.add(build, None, counting.counts);
    }
    Outcome::new(verdict, report.scans, simulated, After::of(build, &cpu, conditions), conditions)
}

/// Runs a test that failed once more, in the interpreter, and says which statements wrote what its assertion reads; and draws the last
/// scans.
fn again(ready: &Ready, test: &Test, wrong: &runner::Wrong, limits: Limits, conditions: &Conditions, timeout: Duration) -> Vec<String> {
    let signals = signals(ready, test, wrong);
    if signals.is_empty() {
        return Vec::new();
    }
    let build = &ready.build;
    let code = Arc::new(build.compiled.program.clone());
    let loaded = Loaded::new(ready.cpu, code, Interpreter::load);
    let mut cpu = Cpu::new(loaded, controller::rack(&ready.build), ready.settings.clone());
    let deadline = Deadline { stopwatch: Stopwatch::start(&conditions.outside), timeout, counting: None };
    let names = signals.iter().map(name).collect();
    let trail = Recorder::new(names, Keep::Last(TRAIL), Origin::default(), Box::new(Memory::default())).ok();
    let _limit = conditions.outside.stop_after(cpu.stop_request(), timeout);
    let mut watcher = Again { deadline, writers: Writers::new(&wrong.signals, &cpu), trail, scans: 0 };
    let sources = &build.project.texts.program;
    let again = runner::run(test, &build.compiled.tests, sources, &mut cpu, limits, &mut watcher);
    // A test that fails elsewhere the second time has nothing to say about the first.
    if again.wrong.as_ref().is_none_or(|again| again.span != wrong.span) {
        return Vec::new();
    }
    let each = wrong.signals.iter().zip(watcher.writers.written());
    let mut lines: Vec<String> =
        each.map(|(signal, written)| last_change::sentence(build, &signal.name, signal.address.area, written)).collect();
    lines.extend(watcher.trail.and_then(|trail| trail.finish().ok()).map_or_else(Vec::new, |trail| diagram(&trail, test, conditions)));
    lines
}

/// What a diagram of a failed test shows: what its assertion reads, then what else the words of the test name.
fn signals(ready: &Ready, test: &Test, wrong: &runner::Wrong) -> Vec<Signal> {
    let plan = &ready.build.compiled.tests;
    let behind = plan.tests.iter().map(|test| test.span.start).filter(|&start| start > test.span.start).min().unwrap_or(u32::MAX);
    let of_test = plan.words.range(test.span.start..behind).flat_map(|(_, call)| &call.signals);
    let written = plan.writes.range(test.span.start..behind).map(|(_, signal)| signal);
    let mut all: Vec<Signal> = Vec::new();
    for signal in wrong.signals.iter().chain(written).chain(of_test) {
        let known = all.iter().any(|known| (known.data_block, known.address) == (signal.data_block, signal.address));
        if !known && all.len() < LANES_MAX {
            all.push(signal.clone());
        }
    }
    all
}

/// The channel of a variable.
fn name(signal: &Signal) -> Name {
    let operand = match signal.data_block {
        Some(db) => Operand::InDataBlock { db, address: signal.address },
        None => Operand::Address(signal.address),
    };
    Name::at(signal.name.clone(), operand, Some(&signal.data_type))
}

/// The trail as text, and for a file if the user wants one.
fn diagram(trail: &Trace, test: &Test, conditions: &Conditions) -> Vec<String> {
    drawing::lines(trail, &test.name, &timing_diagram::Options::text(), conditions)
}

/// What a report shows of a test that failed.
fn failed(build: &Build, test: &Test, wrong: &runner::Wrong, conditions: &Conditions) -> Wrong {
    let sources = &build.project.texts.program;
    let in_program = wrong.place.and_then(|place| Some((place, controller::span_at(build, place)?)));
    let span = wrong.span.or(in_program.map(|(_, span)| span)).unwrap_or(test.span);
    let (line, _) = sources.line_column(span);
    let mut lines = Vec::new();
    if wrong.endless {
        lines.push(format!("a test has {} of real time (--timeout)", duration::show(conditions.timeout)));
    }
    // The statement that stopped the CPU, beside the word of the test.
    if let Some((place, at)) = in_program.filter(|(_, at)| *at != span) {
        let (line, _) = sources.line_column(at);
        lines.push(format!(
            "{}:{line}:  {}  // {}",
            sources.file(at.file).name,
            sources.slice(at).trim(),
            controller::place_text(build, place)
        ));
    }
    let value = |index: usize| wrong.values.get(index).map(|value| (value.value.clone(), value.data_type.clone()));
    Wrong {
        message: controller::named(build, &wrong.message, wrong.place),
        place: Some((sources.file(span.file).name.clone(), line)),
        statement: Some(source_line(build, span)),
        block: None,
        values: value(0).zip(value(1)).map(|((left, _), (right, _))| (left, right)),
        types: value(0).zip(value(1)).map(|((_, left), (_, right))| (left, right)),
        said: wrong.said.clone(),
        lines,
        ..Wrong::default()
    }
}

/// The line that a place begins in.
fn source_line(build: &Build, span: Span) -> String {
    let text = &build.project.texts.program.file(span.file).text;
    let start = span.start as usize;
    let begin = text.get(..start).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    let end = text.get(start..).and_then(|behind| behind.find('\n')).map_or(text.len(), |at| start + at);
    text.get(begin..end).unwrap_or_default().trim().to_owned()
}
