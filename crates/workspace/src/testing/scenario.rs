//! Scenarios as tests: a program is held against what a scenario expects, or against what another program did when it was recorded.

use std::collections::VecDeque;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use sieben_campaign::spec::Spec;
use sieben_cpu::{Cpu, DiagnosticBuffer, Loaded};
use sieben_engine::{Interpreter, Tracer};
use sieben_model::address::Operand;
use sieben_model::cpu_type::CpuType;
use sieben_model::problems::Problem;
use sieben_model::testing::Signal;
use sieben_sim::names::{Kind, Name, Sample};
use sieben_sim::runner::{Watcher, Writers};
use sieben_sim::scenario::{Difference, Happened, Onlooker, Scenario, ScenarioError};
use sieben_sim::timing_diagram::{Mark, Options};
use sieben_sim::trace::{Channel, Keep, Memory, Moment, Origin, Recorder, Trace};

use super::properties::{self, Holding};
use super::{After, Conditions, Outcome, Stopwatch, Verdict, Wrong, drawing};
use crate::campaign::watching::{Watched, Watching};
use crate::controller;
use crate::coverage::{Counting, Looking, looking};
use crate::duration;
use crate::failed::{self, Heard};
use crate::last_change;
use crate::places::Places;
use crate::project::{Build, Overrides, Project};
use crate::refusal::Refusal;
use crate::tracing::scenario::{cut_off, origin, rack, without_plant};

/// Scans before a difference that its diagram shows, and behind it.
const BEFORE: u64 = 30;
const BEHIND: u64 = 10;
/// Names of the scenario whose values are drawn beside it.
const LANES_MAX: usize = 8;
/// Names that are looked at for that: they are kept scan by scan.
const NAMES_MAX: usize = 500;
/// Names that differ, too, and are told.
const OTHERS_MAX: usize = 8;
/// Names that the program does not have and that are told.
const MISSING_MAX: usize = 10;

/// Holds a program against a scenario; `file` is what the scenario is called. `stopwatch` runs since their files were read.
pub fn run(project: Project, scenario: Scenario, file: &str, stopwatch: Stopwatch, conditions: &Conditions) -> Outcome {
    let nothing_ran = Outcome::nothing_ran;
    let overrides =
        Overrides { cpu: conditions.overrides.cpu.or(scenario.cpu), counted: conditions.coverage.is_some(), ..conditions.overrides };
    let spec = properties::spec(&scenario);
    let compiled = match spec.properties.is_empty() {
        true => conditions.compile(project, overrides).map(|build| (build.cpu, build, None)),
        false => properties::compile(&project, &spec, (&scenario, file), overrides, conditions)
            .map(|Watched { build, watching, cpu }| (cpu, build, Some(watching))),
    };
    let (cpu, build, watching) = match compiled {
        Ok(compiled) => compiled,
        Err(verdict) => return nothing_ran(verdict),
    };
    if let Some(refusal) = missing(&build, &scenario, file, conditions).or_else(|| without_plant(&build, file, &scenario)) {
        return nothing_ran(Verdict::Unreadable(refusal));
    }
    let looking = looking(&build.compiled);
    let test = Test { build: Arc::new(build), cpu, spec, watching, looking, scenario, file: file.to_owned(), stopwatch, conditions };
    test.run()
}

/// The names of a scenario that the program does not have.
fn missing(build: &Build, scenario: &Scenario, file: &str, conditions: &Conditions) -> Option<Refusal> {
    let (symbols, program) = (&build.project.symbols, &build.compiled.program);
    let here = |name: &str| Name::parse(conditions.rules.name(name), symbols, program);
    let missing: Vec<(usize, &str)> = scenario
        .names()
        .into_iter()
        .filter(|(_, name)| !conditions.rules.is_ignored(name) && !scenario.allowed().ignores(name) && here(name).is_err())
        .collect();
    let (first, _) = *missing.first()?;
    let written = |name: &str| match conditions.rules.name(name) {
        new if new == name => format!("`{}`", name.trim_matches('"')),
        new => format!("`{}`, which `--map` calls `{new}`", name.trim_matches('"')),
    };
    let names: Vec<String> = missing.iter().take(MISSING_MAX).map(|(_, name)| written(name)).collect();
    let more = if missing.len() > MISSING_MAX { format!(" and {} more", missing.len() - MISSING_MAX) } else { String::new() };
    let message = format!("{}:{first}: the program does not have {}{more}", file, names.join(", "));
    Some(Refusal::new(Problem::P6292, message))
}

/// A scenario with the program that is held against it.
struct Test<'a> {
    build: Arc<Build>,
    /// The CPU type, with room for the properties.
    cpu: &'static CpuType,
    /// The properties, and where their values lie.
    spec: Spec,
    watching: Option<Watching>,
    /// What coverage looks at.
    looking: Looking,
    scenario: Scenario,
    /// What it is called.
    file: String,
    /// When its real time began, which all of its runs share.
    stopwatch: Stopwatch,
    conditions: &'a Conditions,
}

/// The first run: what is wrong.
struct Judge<'a> {
    diagnostics: bool,
    stopwatch: Stopwatch,
    timeout: Duration,
    late: bool,
    scans: u64,
    time_us: u64,
    failures: Vec<ScenarioError>,
    differences: Vec<Difference>,
    counting: Option<Counting<'a>>,
    holding: Option<Holding<'a>>,
    heard: Heard,
    buffer: Option<DiagnosticBuffer>,
}

impl Onlooker for Judge<'_> {
    fn see(&mut self, happened: Happened<'_>) {
        match happened {
            Happened::Scan { cpu, time_us, .. } => {
                let moment = Moment { scan: self.scans, time_us };
                self.scans += 1;
                self.time_us = time_us;
                self.heard.hear(cpu);
                self.failures.extend(self.holding.as_mut().and_then(|holding| holding.scanned(cpu, moment)));
                if self.diagnostics && self.buffer.as_ref() != Some(cpu.diagnostic_buffer()) {
                    self.buffer = Some(cpu.diagnostic_buffer().clone());
                }
            }
            Happened::Failed(error) => self.failures.push(error.clone()),
            Happened::Differs(difference) => self.differences.push(difference.clone()),
            _ => {}
        }
    }
    fn may_go_on(&mut self) -> bool {
        self.late = self.late || self.stopwatch.elapsed() >= self.timeout;
        !self.late
    }
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        self.counting.as_mut().map(|counting| counting as &mut dyn Tracer)
    }
}

impl Test<'_> {
    fn go(&self, loaded: &Loaded, onlooker: &mut dyn Onlooker) {
        let settings = controller::settings(&self.build);
        let mut limit = None;
        let mut fresh = || {
            let cpu = Cpu::new(loaded.clone(), rack(&self.build, &self.scenario), settings.clone());
            limit = Some(
                self.conditions.outside.stop_after(cpu.stop_request(), self.conditions.timeout.saturating_sub(self.stopwatch.elapsed())),
            );
            cpu
        };
        self.scenario.run_with(&self.build.project.symbols, &self.conditions.rules, &mut fresh, onlooker);
    }

    fn run(&self) -> Outcome {
        let mut judge = Judge {
            diagnostics: self.conditions.diagnostics,
            holding: self.watching.as_ref().map(|watching| Holding::new(&self.scenario, &self.spec, watching)),
            heard: Heard::default(),
            buffer: None,
            stopwatch: self.stopwatch.clone(),
            timeout: self.conditions.timeout,
            late: false,
            scans: 0,
            time_us: 0,
            failures: Vec::new(),
            differences: Vec::new(),
            counting: self.conditions.coverage.is_some().then(|| Counting::new(&self.looking)),
        };
        self.go(&self.conditions.loaded(self.cpu, &self.build), &mut judge);
        judge.failures.extend(judge.holding.as_mut().and_then(Holding::ended));
        if let Some((collector, counting)) = self.conditions.coverage.as_ref().zip(judge.counting.take()) {
            collector.add(&self.build, None, counting.counts);
        }
        // The failures come in the order of time, and so does the first of them.
        let verdict = match (judge.failures.first(), judge.late) {
            (None, true) => Verdict::Failed(Box::new(Wrong {
                message: format!("took longer than {} ({} scans)", duration::show(self.conditions.timeout), judge.scans),
                lines: vec!["`--timeout` gives it longer".to_owned()],
                ..Wrong::default()
            })),
            (first, _) => match (&self.scenario.known_gap, first) {
                (Some(why), None) => Verdict::Failed(Box::new(Wrong {
                    message: format!("the scenario holds, though it is written down as a known gap: {why}"),
                    ..Wrong::default()
                })),
                (Some(_), Some(_)) | (None, None) => Verdict::Passed,
                (None, Some(first)) => Verdict::Failed(Box::new(self.wrong(first, &judge))),
            },
        };
        // A report of a failure says it itself.
        let warning = cut_off(&self.file, &self.scenario).filter(|_| matches!(verdict, Verdict::Passed));
        let entries = judge.buffer.iter().flat_map(|buffer| buffer.entries());
        let diagnostics = entries.map(|entry| failed::entry_text(&self.build, entry)).collect();
        let after = After { failed: judge.heard.failed(&self.build), diagnostics };
        Outcome { warning, ..Outcome::new(verdict, judge.scans, Duration::from_micros(judge.time_us), after, self.conditions) }
    }

    fn wrong(&self, first: &ScenarioError, judge: &Judge<'_>) -> Wrong {
        let mut wrong = Wrong { message: first.message.clone(), place: Some((self.file.clone(), first.line)), ..Wrong::default() };
        let of_another = self.scenario.recorded.as_ref().filter(|recorded| recorded.program != origin(&self.build).program);
        if let Some(recorded) = of_another {
            wrong.lines.push(format!("recorded with `{}`", recorded.title));
        }
        wrong.lines.extend(cut_off(&self.file, &self.scenario));
        let others: Vec<&Difference> = judge.differences.iter().skip(1).collect();
        if let Some(difference) = judge.differences.first().filter(|difference| difference.line == first.line) {
            let kind = difference.place.recorded();
            let show = |sample: &Sample| sample.readable(&kind);
            wrong.values = Some((show(&difference.expected), show(&difference.actual)));
            let word = word(&kind);
            wrong.types = Some((word.clone(), word));
            wrong.moment = Some(difference.moment);
            wrong.lines.push(self.place(difference));
            wrong.lines.extend(self.again(difference));
        }
        for other in others.iter().take(OTHERS_MAX) {
            wrong.lines.push(format!("`{}` differs, too: first after {}", other.name.trim_matches('"'), other.moment));
        }
        // What differs is told above; the rest, such as a STOP, is not.
        let told = |error: &&ScenarioError| {
            judge.differences.iter().any(|difference| difference.line == error.line && error.message.starts_with('`'))
        };
        for error in judge.failures.iter().skip(1).filter(|error| !told(error)).take(OTHERS_MAX) {
            wrong.lines.push(error.to_string());
        }
        if others.len() > OTHERS_MAX {
            wrong.lines.push(format!("{} more differ", others.len() - OTHERS_MAX));
        }
        wrong
    }

    /// What it is that differs, in this program.
    fn place(&self, difference: &Difference) -> String {
        let mnemonics = Places::new(&self.build).mnemonics;
        let address = difference.place.operand().map(|operand| operand.spell(mnemonics));
        let word = Some(word(&difference.place.recorded())).filter(|word| !word.is_empty());
        let what: Vec<String> = word.into_iter().chain(address).collect();
        format!("`{}`: {}", difference.place.text().trim_matches('"'), what.join(" at "))
    }

    /// Runs it once more up to a difference, in the interpreter: who wrote the value, and what was around it.
    fn again(&self, difference: &Difference) -> Vec<String> {
        let code = Arc::new(self.build.compiled.program.clone());
        let loaded = Loaded::new(self.cpu, code, Interpreter::load);
        let mut looking = Again::new(self, difference);
        self.go(&loaded, &mut looking);
        // What a run that was given up did not see, it cannot tell.
        if self.stopwatch.elapsed() >= self.conditions.timeout {
            return Vec::new();
        }
        let mut lines = Vec::new();
        if let Some(Operand::Address(address) | Operand::InDataBlock { address, .. }) = difference.place.operand() {
            let name = difference.place.text().trim_matches('"');
            lines.push(last_change::sentence(&self.build, name, address.area, looking.written));
        }
        let diagram = looking.diagram().map(|(trail, mark)| {
            let options = Options { marks: vec![mark], ..Options::text() };
            let stem = Path::new(&self.file).file_stem();
            let name = stem.map_or_else(|| "scenario".to_owned(), |name| name.to_string_lossy().into_owned());
            drawing::lines(&trail, &name, &options, self.conditions)
        });
        lines.extend(diagram.unwrap_or_default());
        lines
    }
}

/// The word of a type, for a report.
fn word(kind: &Kind) -> String {
    match kind.plain() {
        Kind::Bit => "BOOL".to_owned(),
        Kind::Bits(8) => "BYTE".to_owned(),
        Kind::Bits(16) => "WORD".to_owned(),
        Kind::Bits(32) => "DWORD".to_owned(),
        Kind::Typed(data_type) => data_type.word().unwrap_or_default().to_owned(),
        _ => String::new(),
    }
}

/// The second run.
struct Again<'a> {
    difference: &'a Difference,
    /// What the scenario speaks of.
    names: Vec<Name>,
    /// Their values behind the scans around the difference, those of the name that differs first: expected and actual.
    rows: VecDeque<(Moment, Vec<Sample>)>,
    scan: u64,
    writers: Option<Writers>,
    written: Option<sieben_sim::runner::Written>,
    signal: Option<Signal>,
    stopwatch: Stopwatch,
    timeout: Duration,
}

impl<'a> Again<'a> {
    fn new(test: &Test<'_>, difference: &'a Difference) -> Self {
        let (symbols, program, rules) = (&test.build.project.symbols, &test.build.compiled.program, &test.conditions.rules);
        let all = test.scenario.names();
        let names = all.iter().filter(|(_, name)| *name != difference.name).take(NAMES_MAX);
        let names = names.filter_map(|(_, name)| Name::parse(rules.name(name), symbols, program).ok()).collect();
        let signal = last_change::signal(&difference.place);
        let (stopwatch, timeout) = (test.stopwatch.clone(), test.conditions.timeout);
        Self { difference, names, rows: VecDeque::new(), scan: 0, writers: None, written: None, signal, stopwatch, timeout }
    }

    /// The lanes of the name that differs, and of those that changed last before it.
    fn diagram(&self) -> Option<(Trace, Mark)> {
        let Difference { name, moment, .. } = self.difference;
        let name = name.trim_matches('"');
        let until = self.rows.iter().filter(|(at, _)| at.scan <= moment.scan);
        let changed = |lane: usize| {
            let rows: Vec<&(Moment, Vec<Sample>)> = until.clone().collect();
            rows.windows(2).rev().find(|pair| pair[0].1[lane] != pair[1].1[lane]).map(|pair| pair[1].0.scan)
        };
        let mut lanes: Vec<(usize, u64)> = (2..self.names.len() + 2).filter_map(|lane| Some((lane, changed(lane)?))).collect();
        lanes.sort_by_key(|&(_, scan)| std::cmp::Reverse(scan));
        lanes.truncate(LANES_MAX);
        lanes.sort_by_key(|&(lane, _)| lane);
        let kind = self.difference.place.recorded();
        let mut channels = vec![
            Channel { name: format!("{name} expected"), kind: kind.clone() },
            Channel { name: format!("{name} actual"), kind: kind.clone() },
        ];
        channels.extend(lanes.iter().map(|&(lane, _)| {
            let name = &self.names[lane - 2];
            Channel { name: name.text().trim_matches('"').to_owned(), kind: name.recorded() }
        }));
        let mut recorder = Recorder::of_channels(channels, Keep::All, Origin::default(), Box::new(Memory::default())).ok()?;
        for (at, values) in &self.rows {
            let chosen: Vec<Sample> =
                [0, 1].into_iter().chain(lanes.iter().map(|&(lane, _)| lane)).map(|lane| values[lane].clone()).collect();
            recorder.put(*at, &chosen).ok()?;
        }
        let show = |sample: &Sample| sample.readable(&kind);
        let label = format!("{name} should be {}, is {}", show(&self.difference.expected), show(&self.difference.actual));
        Some((recorder.finish().ok()?, Mark { moment: *moment, label }))
    }

    /// Whether statements are looked at in the scan that comes.
    fn looks_closely(&self) -> bool {
        self.scan <= self.difference.moment.scan && self.difference.since.is_none_or(|since| since == self.scan)
    }
}

impl Onlooker for Again<'_> {
    fn see(&mut self, happened: Happened<'_>) {
        match happened {
            Happened::Began { cpu } => self.writers = self.signal.as_ref().map(|signal| Writers::new(std::slice::from_ref(signal), cpu)),
            Happened::Due { cpu, .. } => {
                if let Some(writers) = &mut self.writers {
                    writers.before_scan(cpu);
                }
            }
            Happened::Scan { cpu, time_us, held } => {
                let moment = Moment { scan: self.scan, time_us };
                self.scan += 1;
                let place = self.difference.moment.scan;
                if moment.scan + BEFORE >= place && moment.scan <= place.saturating_add(BEHIND) {
                    let expected = held.expected(&self.difference.name).cloned();
                    let expected = expected.unwrap_or_else(|| self.difference.expected.clone());
                    let sample = |name: &Name| name.sample(cpu).unwrap_or_default();
                    let here = [expected, sample(&self.difference.place)];
                    self.rows.push_back((moment, here.into_iter().chain(self.names.iter().map(sample)).collect()));
                }
                if moment.scan == place {
                    self.written = self.writers.as_ref().and_then(|writers| writers.written().next().flatten());
                }
            }
            _ => {}
        }
    }
    fn may_go_on(&mut self) -> bool {
        self.scan <= self.difference.moment.scan.saturating_add(BEHIND) && self.stopwatch.elapsed() < self.timeout
    }
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        let closely = self.looks_closely();
        self.writers.as_mut().filter(|_| closely).map(|writers| writers as &mut dyn Tracer)
    }
}
