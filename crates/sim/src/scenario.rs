//! Scenarios: what happens to a CPU and what is expected of it, one line each.
//!
//! The language of executable pages, recordings and `*.scenario` files:
//!
//! ```text
//! cpu 416-3                            the CPU type (default: that of the caller)
//! cycle 10ms                           distance of two scans (default 10ms)
//! modules 0..63                        only these peripheral bytes have a module (default: all); `modules none`
//! set I 0.0=1 MW10=16#0102 ACCU1=5     before the next scan
//! force I 0.0=1 Q 4.0=0                from the next scan on, until
//! unforce I 0.0 | unforce              ends the forcing of one name, or of all
//! scan | scan 3 | scan until 400ms | scan at 410ms
//! at 310ms I 0.0=0                     when a scan begins at that time or later
//! cyclic OB 35 50ms phase 10ms         interval and phase offset of a cyclic interrupt, from the start
//! image-errors every | coming          OB 85 when a module does not answer the process image (default: off)
//! module 4 fails | module 4 answers    the module that has byte 4, from now on
//! fault tank.level stuck=50            a signal of a plant fails from now on, or `@10s..20s`
//! mend tank.level | mend tank          its faults are gone
//! min-cycle 50ms                       the least cycle time, from the start
//! interrupt OB 40                      before the next scan; with EVENT= ID= INFO1= INFO2= for its start information
//! interrupt OB 40 at safe point 17     in the next scan: its 17th backward jump or block entry
//! restart warm | restart hot | restart cold
//! power failure                        power off and on: a fresh CPU takes back the retentive data, modules begin anew
//! retain m=0..31,40 t=1 c=             retentive bytes of M, timers and counters, from the start (default: those of the CPU)
//! expect Q 0.0=1 T 1=70 STW.RLO=1
//! expect Q 4.0=1 within 20ms           scans until it is so
//! expect stop 16#2522                  the first cause, or the event of the STOP
//! expect mode RUN
//! table I 0.0 I 0.1 -> Q 0.0           rows of values follow: each a fresh CPU, `set`, one scan, `expect`
//! known-gap "why"                      the scenario is expected to fail
//! // a comment
//! ```
//! Scan k begins at k times the cycle, the first at 0. A table row begins with the `set` lines above it.

use std::cell::RefCell;
use std::fmt;
use std::ops::Range;
use std::time::Duration;

use sieben_cpu::retain::{Adoption, Numbers};
use sieben_cpu::{Cpu, CyclicInterrupt, ImageErrors, Interrupt, OperatingMode, Restart, RetentiveAreas};
use sieben_model::cpu_type::CpuType;
use sieben_model::symbols::SymbolTable;

use crate::duration;
use crate::names::{self, Name};
use crate::wrap::{self, Fault};

/// A line that is not understood, or an expectation that did not come true.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScenarioError {
    /// The line of the scenario, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for ScenarioError {}

/// What happens while a scenario runs.
#[derive(Clone, Copy)]
pub enum Happened<'a> {
    /// A CPU is about to begin at time 0: that of the scenario, or that of a row of a table.
    Began,
    /// A scan ended.
    Scan {
        /// The CPU behind the scan.
        cpu: &'a Cpu,
        /// When the scan began, in microseconds.
        time_us: u64,
    },
    /// Something did not come true, or could not be done.
    Failed(&'a ScenarioError),
}

/// Someone who looks on while a scenario runs.
pub type Watch<'a> = dyn FnMut(Happened<'_>) + 'a;

/// A scenario, read and ready to run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scenario {
    /// The CPU type that it asks for.
    pub cpu: Option<&'static CpuType>,
    /// Peripheral bytes that have a module; `None` = all.
    pub modules: Option<Range<u32>>,
    /// Why it is expected to fail, if it is.
    pub known_gap: Option<String>,
    cycle_us: u64,
    min_cycle_us: u64,
    image_errors: ImageErrors,
    cyclic: Vec<(u16, CyclicInterrupt)>,
    retain: Option<RetentiveAreas>,
    lines: Vec<Line>,
}

#[derive(Clone, Debug, PartialEq)]
struct Line {
    number: usize,
    command: Command,
}

type Assignments = Vec<(String, String)>;

#[derive(Clone, Debug, PartialEq)]
enum Command {
    Set(Assignments),
    Force(Assignments),
    Unforce(Option<String>),
    Scan(u32),
    ScanUntil(u64),
    ScanAt(u64),
    At(u64, Assignments),
    Interrupt(Interrupt, Option<u64>),
    Restart(Restart),
    Module(u32, bool),
    Fault(Fault),
    Mend(String),
    PowerFailure,
    Expect(Assignments, Option<u64>),
    ExpectStop(u16),
    ExpectMode(OperatingMode),
    Table { inputs: Vec<String>, outputs: Vec<String>, rows: Vec<(usize, Vec<String>)> },
}

/// The cycle of a scenario that does not say.
const CYCLE_US: u64 = 10_000;
/// Most scans that one line may ask for; a slip of the pen shall not run for hours.
const SCANS_MAX: u64 = 1_000_000;

/// The words a line can begin with.
const WORDS: &str = "`cpu`, `cycle`, `min-cycle`, `cyclic`, `image-errors`, `modules`, `module`, `fault`, `mend`, `retain`, `set`, `force`, `unforce`, `scan`, `at`, `interrupt`, `restart`, `power`, `expect`, `table` or `known-gap`";

impl Scenario {
    /// Reads a scenario.
    ///
    /// # Errors
    /// All lines that are not understood.
    pub fn parse(text: &str) -> Result<Self, Vec<ScenarioError>> {
        let mut scenario = Self { cycle_us: CYCLE_US, ..Self::default() };
        let mut errors = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let number = index + 1;
            let line = without_comment(line).trim();
            if line.is_empty() {
                continue;
            }
            if let Err(message) = scenario.line(number, line) {
                errors.push(ScenarioError { line: number, message });
            }
        }
        for line in &scenario.lines {
            if let Command::Table { rows, .. } = &line.command
                && rows.is_empty()
            {
                errors.push(ScenarioError {
                    line: line.number,
                    message: "the table has no row; write one row of values per line".to_owned(),
                });
            }
        }
        if errors.is_empty() { Ok(scenario) } else { Err(errors) }
    }

    /// Whether it expects anything at all.
    pub fn expects(&self) -> bool {
        self.lines.iter().any(|line| {
            matches!(line.command, Command::Expect(..) | Command::ExpectStop(_) | Command::ExpectMode(_) | Command::Table { .. })
        })
    }

    /// The distance of two scans, in microseconds.
    pub fn cycle_us(&self) -> u64 {
        self.cycle_us.max(self.min_cycle_us)
    }

    fn line(&mut self, number: usize, line: &str) -> Result<(), String> {
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let rest = rest.trim();
        let command = match word {
            "cpu" => {
                self.cpu = Some(CpuType::by_name(rest).ok_or_else(|| {
                    let names: Vec<&str> = CpuType::ALL.iter().map(|cpu| cpu.name).collect();
                    format!("no CPU type is called `{rest}`; there are {}", names.join(", "))
                })?);
                return Ok(());
            }
            "cycle" => {
                self.cycle_us = duration(rest)?;
                if self.cycle_us == 0 {
                    return Err("a cycle lasts more than 0".to_owned());
                }
                return Ok(());
            }
            "cyclic" => {
                self.cyclic.push(cyclic(rest)?);
                return Ok(());
            }
            "image-errors" => {
                self.image_errors = ImageErrors::from_name(rest)
                    .ok_or_else(|| format!("`image-errors {rest}` is not understood; write `off`, `every` or `coming`"))?;
                return Ok(());
            }
            "min-cycle" => {
                self.min_cycle_us = duration(rest)?;
                return Ok(());
            }
            "retain" => {
                self.retain = Some(retain(rest)?);
                return Ok(());
            }
            "modules" => {
                self.modules = Some(byte_range(rest)?);
                return Ok(());
            }
            "known-gap" => {
                let why = rest.trim_matches('"').trim();
                if why.is_empty() {
                    return Err("say why: `known-gap \"the reason\"`".to_owned());
                }
                self.known_gap = Some(why.to_owned());
                return Ok(());
            }
            "set" => Command::Set(assignments(rest)?),
            "force" => Command::Force(assignments(rest)?),
            "unforce" => Command::Unforce((!rest.is_empty()).then(|| rest.to_owned())),
            "scan" => scan(rest)?,
            "at" => {
                let (time, values) =
                    rest.split_once(char::is_whitespace).ok_or("write a time and what changes then: `at 310ms I 0.0=0`")?;
                Command::At(duration(time)?, assignments(values)?)
            }
            "interrupt" => interrupt(rest)?,
            "restart" => Command::Restart(match rest.to_ascii_lowercase().as_str() {
                "warm" => Restart::Warm,
                "hot" => Restart::Hot,
                "cold" => Restart::Cold,
                _ => return Err(format!("`{rest}` is no kind of restart; write `warm`, `hot` or `cold`")),
            }),
            "module" => match rest.split_whitespace().collect::<Vec<_>>().as_slice() {
                [byte, what @ ("fails" | "answers")] if byte.parse::<u32>().is_ok() => {
                    Command::Module(byte.parse().unwrap_or_default(), *what == "answers")
                }
                _ => return Err(format!("`module {rest}` is not understood; write `module 4 fails` or `module 4 answers`")),
            },
            "fault" => Command::Fault(Fault::parse(rest)?),
            "mend" if rest.is_empty() => {
                return Err("write what is mended: `mend tank.level`, or `mend tank` for all its signals".to_owned());
            }
            "mend" => Command::Mend(rest.to_owned()),
            "power" if rest.eq_ignore_ascii_case("failure") => Command::PowerFailure,
            "power" => return Err(format!("`power {rest}` is not understood; write `power failure`")),
            "expect" => expect(rest)?,
            "table" => {
                let (inputs, outputs) =
                    rest.split_once("->").ok_or("write the inputs, `->` and the outputs: `table I 0.0 I 0.1 -> Q 0.0`")?;
                let (inputs, outputs) = (name_list(inputs), name_list(outputs));
                if inputs.is_empty() || outputs.is_empty() {
                    return Err("a table has at least one input and one output".to_owned());
                }
                Command::Table { inputs, outputs, rows: Vec::new() }
            }
            _ => return self.table_row(number, line, word),
        };
        self.lines.push(Line { number, command });
        Ok(())
    }

    fn table_row(&mut self, number: usize, line: &str, word: &str) -> Result<(), String> {
        let Some(Line { command: Command::Table { inputs, outputs, rows }, .. }) = self.lines.last_mut() else {
            return Err(format!("`{word}` begins no line; write {WORDS}"));
        };
        let values: Vec<String> = line.split_whitespace().filter(|&word| !matches!(word, "->" | "|")).map(str::to_owned).collect();
        let wanted = inputs.len() + outputs.len();
        if values.len() != wanted {
            return Err(format!("the row has {} values, the table has {wanted} columns", values.len()));
        }
        rows.push((number, values));
        Ok(())
    }

    /// Sets up a CPU in STOP.
    fn prepare(&self, mut cpu: Cpu) -> Cpu {
        for &(number, setting) in &self.cyclic {
            cpu.set_cyclic_interrupt(number, setting);
        }
        cpu.set_image_errors(self.image_errors);
        cpu.set_min_cycle(Duration::from_micros(self.min_cycle_us));
        if let Some(areas) = &self.retain {
            cpu.set_retentive_areas(areas.clone());
        }
        cpu
    }

    /// Runs the scenario. `fresh` makes a CPU in STOP with the program loaded.
    /// What did not come true is returned; a [`Self::known_gap`] is the caller's to judge.
    pub fn run(&self, symbols: &SymbolTable, fresh: &mut dyn FnMut() -> Cpu) -> Vec<ScenarioError> {
        self.run_watched(symbols, fresh, &mut |_| {})
    }

    /// As [`Self::run`], with someone who looks on.
    pub fn run_watched(&self, symbols: &SymbolTable, fresh: &mut dyn FnMut() -> Cpu, watch: &mut Watch<'_>) -> Vec<ScenarioError> {
        // The CPU of the scenario stays while rows of a table have theirs.
        let watch = RefCell::new(watch);
        let watch: &dyn Fn(Happened<'_>) = &|happened| watch.borrow_mut()(happened);
        let mut failures = Vec::new();
        let mut run: Option<Run<'_>> = None;
        for (index, line) in self.lines.iter().enumerate() {
            if let Command::Table { inputs, outputs, rows } = &line.command {
                for (number, values) in rows {
                    let mut row = Run::start(self.prepare(fresh()), symbols, self.cycle_us(), watch);
                    row.line = *number;
                    for above in &self.lines[..index] {
                        if let Command::Set(assignments) = &above.command {
                            row.set(assignments);
                        }
                    }
                    let (given, expected) = values.split_at(inputs.len());
                    let pairs = |names: &[String], values: &[String]| names.iter().cloned().zip(values.iter().cloned()).collect::<Vec<_>>();
                    row.set(&pairs(inputs, given));
                    row.scan();
                    row.expect(&pairs(outputs, expected), None);
                    row.finish();
                    failures.append(&mut row.failures);
                }
                continue;
            }
            let run = run.get_or_insert_with(|| Run::start(self.prepare(fresh()), symbols, self.cycle_us(), watch));
            run.line = line.number;
            match line.command {
                Command::PowerFailure => run.power_failure(self.prepare(fresh())),
                _ => run.command(&line.command),
            }
        }
        if let Some(mut run) = run {
            run.finish();
            failures.append(&mut run.failures);
        }
        failures.sort_by_key(|failure| failure.line);
        failures
    }
}

/// A CPU on its way through a scenario.
struct Run<'a> {
    cpu: Cpu,
    symbols: &'a SymbolTable,
    cycle_us: u64,
    /// When the last scan began.
    last_us: Option<u64>,
    /// When the next scan begins.
    next_us: u64,
    /// Changes to come, with the line that orders them.
    changes: Vec<(u64, usize, Assignments)>,
    /// The line that is carried out.
    line: usize,
    stop_expected: bool,
    failures: Vec<ScenarioError>,
    watch: &'a dyn Fn(Happened<'_>),
}

impl<'a> Run<'a> {
    fn start(mut cpu: Cpu, symbols: &'a SymbolTable, cycle_us: u64, watch: &'a dyn Fn(Happened<'_>)) -> Self {
        watch(Happened::Began);
        cpu.restart(Restart::Warm);
        let failures = Vec::new();
        Self { cpu, symbols, cycle_us, last_us: None, next_us: 0, changes: Vec::new(), line: 1, stop_expected: false, failures, watch }
    }

    fn fail(&mut self, message: impl Into<String>) {
        let error = ScenarioError { line: self.line, message: message.into() };
        (self.watch)(Happened::Failed(&error));
        self.failures.push(error);
    }

    fn command(&mut self, command: &Command) {
        match command {
            Command::Set(assignments) => self.set(assignments),
            Command::Force(assignments) => self.force(assignments),
            Command::Unforce(None) => self.cpu.unforce_all(),
            Command::Unforce(Some(name)) => {
                let done = Name::parse(name, self.symbols, self.cpu.program()).and_then(|name| name.unforce(&mut self.cpu));
                done.unwrap_or_else(|error| self.fail(error.to_string()));
            }
            Command::Scan(count) => (0..*count).for_each(|_| self.scan()),
            Command::ScanUntil(end) => {
                if self.reachable(*end) {
                    while self.next_us <= *end {
                        self.scan();
                    }
                }
            }
            Command::ScanAt(time) => match self.last_us {
                Some(last) if *time < last => self.fail(format!("the last scan was already at {}", spell_us(last))),
                _ => {
                    self.next_us = *time;
                    self.scan();
                }
            },
            Command::At(time, assignments) => match self.last_us {
                Some(last) if *time <= last => {
                    self.fail(format!("the last scan was already at {}; write `at` before the scan that shall see it", spell_us(last)));
                }
                _ => self.changes.push((*time, self.line, assignments.clone())),
            },
            Command::Interrupt(interrupt, None) => self.cpu.raise(*interrupt),
            Command::Interrupt(interrupt, Some(point)) => self.cpu.raise_at_safe_point(*point, *interrupt),
            Command::Module(byte, answers) => {
                if !self.cpu.rack_mut().set_answering(*byte, *answers) {
                    self.fail(format!("no module has the byte {byte}"));
                }
            }
            Command::Fault(fault) => wrap::inject(self.cpu.rack_mut(), fault).unwrap_or_else(|message| self.fail(message)),
            Command::Mend(name) => wrap::mend(self.cpu.rack_mut(), name).unwrap_or_else(|message| self.fail(message)),
            Command::Restart(restart) => {
                self.cpu.restart(*restart);
                self.stop_expected = false;
            }
            Command::Expect(assignments, within) => self.expect(assignments, *within),
            Command::ExpectStop(event) => self.expect_stop(*event),
            Command::ExpectMode(mode) => {
                self.stop_expected |= *mode == OperatingMode::Stop;
                if self.cpu.mode() != *mode {
                    let got = self.cpu.mode();
                    self.fail(format!("expected the mode {mode}, got {got}{}", self.why_stopped()));
                }
            }
            // These need more than one CPU.
            Command::PowerFailure | Command::Table { .. } => {}
        }
    }

    /// The retentive data of the CPU goes to a fresh one, which starts at the time that it is.
    fn power_failure(&mut self, mut fresh: Cpu) {
        let Some(image) = self.cpu.retain_image().cloned() else {
            return self.fail("a scan is not at its end, and only whole scans are kept");
        };
        if let Err(refusal) = fresh.restore(&image, Adoption::SameProgram) {
            return self.fail(format!("the retentive data is not taken back: {refusal}"));
        }
        let now_us = self.last_us.unwrap_or(0);
        fresh.restart_with(Restart::Warm, &mut || now_us, None);
        self.cpu = fresh;
        self.stop_expected = false;
    }

    fn set(&mut self, assignments: &Assignments) {
        for (name, value) in assignments {
            let done = Name::parse(name, self.symbols, self.cpu.program()).and_then(|name| name.write(&mut self.cpu, value));
            if let Err(error) = done {
                self.fail(error.to_string());
            }
        }
    }

    fn force(&mut self, assignments: &Assignments) {
        for (name, value) in assignments {
            let done = Name::parse(name, self.symbols, self.cpu.program()).and_then(|name| name.force(&mut self.cpu, value));
            if let Err(error) = done {
                self.fail(error.to_string());
            }
        }
    }

    /// Whether a time can be reached with a bearable number of scans; says so if not.
    fn reachable(&mut self, end: u64) -> bool {
        let bearable = end.saturating_sub(self.next_us) / self.cycle_us <= SCANS_MAX && end < u64::MAX;
        if !bearable {
            self.fail(format!("that is more than {SCANS_MAX} scans; choose a longer cycle"));
        }
        bearable
    }

    fn scan(&mut self) {
        let now = self.next_us;
        let line = self.line;
        self.changes.sort_by_key(|change| change.0);
        let due = self.changes.iter().take_while(|change| change.0 <= now).count();
        for (_, line, assignments) in self.changes.drain(..due).collect::<Vec<_>>() {
            self.line = line;
            self.set(&assignments);
        }
        self.line = line;
        let report = self.cpu.scan(now);
        (self.watch)(Happened::Scan { cpu: &self.cpu, time_us: now });
        if report.events_missed > 0 {
            let passed = report.safe_points;
            self.fail(format!("the scan passed only {passed} safe points (backward jumps and block entries); the interrupt never came"));
        }
        self.last_us = Some(now);
        self.next_us = now.saturating_add(self.cycle_us);
    }

    fn expect(&mut self, assignments: &Assignments, within: Option<u64>) {
        let deadline = self.last_us.unwrap_or(self.next_us).saturating_add(within.unwrap_or(0));
        if within.is_some() && !self.reachable(deadline) {
            return;
        }
        loop {
            let wrong: Vec<String> = assignments.iter().filter_map(|(name, value)| self.differs(name, value)).collect();
            if wrong.is_empty() {
                return self.check_stop();
            }
            if within.is_none() || self.next_us > deadline {
                let when =
                    self.last_us.map_or_else(|| "before the first scan".to_owned(), |last| format!("after the scan at {}", spell_us(last)));
                self.fail(format!("{} {when}{}", wrong.join(", "), self.why_stopped()));
                self.stop_expected = true;
                return;
            }
            self.scan();
        }
    }

    /// How a value differs from the expected one.
    fn differs(&self, name: &str, expected: &str) -> Option<String> {
        let compared = Name::parse(name, self.symbols, self.cpu.program()).and_then(|parsed| match parsed.holds(&self.cpu, expected)? {
            true => Ok(None),
            false => Ok(Some(format!("expected {name} = {expected}, got {}", parsed.read(&self.cpu)?))),
        });
        compared.unwrap_or_else(|error| Some(error.to_string()))
    }

    fn expect_stop(&mut self, event: u16) {
        self.stop_expected = true;
        match self.cpu.stop_cause() {
            Some(cause) if cause.first_event == event || cause.event == event => {}
            Some(cause) => {
                let got = cause.first_event;
                self.fail(format!("expected STOP with 16#{event:04X}, got 16#{got:04X}{}", self.why_stopped()));
            }
            None => self.fail(format!("expected STOP with 16#{event:04X}, but the CPU is in {}", self.cpu.mode())),
        }
    }

    /// A STOP that no line expects is a failure.
    fn check_stop(&mut self) {
        if self.cpu.mode() == OperatingMode::Stop && !self.stop_expected {
            self.stop_expected = true;
            self.fail(self.why_stopped().trim_start_matches("; ").to_owned());
        }
    }

    fn why_stopped(&self) -> String {
        match self.cpu.stop_cause() {
            Some(cause) if self.cpu.mode() == OperatingMode::Stop => {
                format!("; the CPU is in STOP, event 16#{:04X}: {}", cause.first_event, cause.text)
            }
            _ => String::new(),
        }
    }

    fn finish(&mut self) {
        self.check_stop();
        for (time, line, _) in std::mem::take(&mut self.changes) {
            self.line = line;
            self.fail(format!("no scan came at {} or later", spell_us(time)));
        }
    }
}

/// Cuts a comment: a line that begins with `//`, or the rest behind ` //`.
fn without_comment(line: &str) -> &str {
    if line.trim_start().starts_with("//") {
        return "";
    }
    line.split_once(" //").map_or(line, |(before, _)| before)
}

fn assignments(text: &str) -> Result<Assignments, String> {
    let out = names::assignments(text).map_err(|error| error.to_string())?;
    if out.is_empty() { Err("write at least one `NAME=VALUE`".to_owned()) } else { Ok(out) }
}

fn scan(rest: &str) -> Result<Command, String> {
    let mut words = rest.split_whitespace();
    let command = match (words.next(), words.next()) {
        (None, _) => Command::Scan(1),
        (Some("until"), Some(time)) => Command::ScanUntil(duration(time)?),
        (Some("at"), Some(time)) => Command::ScanAt(duration(time)?),
        (Some(count), None) if !matches!(count, "until" | "at") => {
            let count = count.parse().ok().filter(|&count| u64::from(count) <= SCANS_MAX);
            Command::Scan(count.ok_or_else(|| format!("`{rest}` is no number of scans up to {SCANS_MAX}"))?)
        }
        _ => return Err(format!("`scan {rest}` is not understood; write `scan`, `scan 3`, `scan until 400ms` or `scan at 400ms`")),
    };
    match words.next() {
        Some(word) => Err(format!("`{word}` does not belong here")),
        None => Ok(command),
    }
}

/// `OB 40`, `OB 82 EVENT=16#3842 INFO1=4`, `OB 40 at safe point 17`.
fn interrupt(rest: &str) -> Result<Command, String> {
    let not_understood = || format!("`interrupt {rest}` is not understood; write `interrupt OB 40` or `interrupt OB 40 at safe point 17`");
    let (what, point) = match rest.split_once(" at ") {
        None => (rest, None),
        Some((what, behind)) => {
            let words: Vec<String> = behind.split_whitespace().map(str::to_ascii_lowercase).collect();
            let point = match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
                ["safe", "point", point] => point.parse::<u64>().ok().filter(|&point| point > 0),
                _ => None,
            };
            (what, Some(point.ok_or_else(not_understood)?))
        }
    };
    let (number, fields) = block_number(what).ok_or_else(not_understood)?;
    let usual = Interrupt::usual(number).ok_or_else(|| {
        format!("no event starts OB {number}; write one of OB 10 to 17, 20 to 23, 30 to 38, 40 to 47, 55 to 57, 60 or 80 to 87")
    })?;
    let mut info = usual.start_information();
    for field in fields.split_whitespace() {
        let wrong = || {
            format!(
                "`{field}` is no part of the start information; write `EVENT=`, `ID=`, `INFO1=` or `INFO2=` and a number such as 16#3942"
            )
        };
        let (name, value) = field.split_once('=').ok_or_else(wrong)?;
        let value = match value.strip_prefix("16#") {
            Some(digits) => u32::from_str_radix(&digits.replace('_', ""), 16),
            None => value.parse(),
        };
        let value = value.map_err(|_| wrong())?;
        let word = u16::try_from(value);
        match name.to_ascii_uppercase().as_str() {
            "EVENT" => info.event = word.map_err(|_| wrong())?,
            "ID" => info.data_id = word.map_err(|_| wrong())?,
            "INFO1" => info.info_1 = word.map_err(|_| wrong())?,
            "INFO2" => info.info_2 = value,
            _ => return Err(wrong()),
        }
    }
    let interrupt = Interrupt::event(number, info.event, info.data_id, info.info_1, info.info_2);
    interrupt.map(|interrupt| Command::Interrupt(interrupt, point)).ok_or_else(not_understood)
}

/// `OB 40 …` or `OB40 …`: the number, and what stands behind it.
fn block_number(text: &str) -> Option<(u16, &str)> {
    let behind = text.trim_start().get(2..).filter(|_| text.trim_start().get(..2).is_some_and(|ob| ob.eq_ignore_ascii_case("ob")))?;
    let behind = behind.trim_start();
    let end = behind.find(|c: char| !c.is_ascii_digit()).unwrap_or(behind.len());
    Some((behind[..end].parse().ok()?, &behind[end..]))
}

/// Reads `m=0..31,40 t=1 c=`; what is not named stays as the CPU has it.
fn retain(rest: &str) -> Result<RetentiveAreas, String> {
    let mut areas = RetentiveAreas::default();
    for word in rest.split_whitespace() {
        let (name, text) = word.split_once('=').unwrap_or((word, "?"));
        let numbers = match name.to_ascii_lowercase().as_str() {
            "m" => &mut areas.bit_memory,
            "t" => &mut areas.timers,
            "c" => &mut areas.counters,
            _ => return Err(format!("`{word}` is not understood; write `retain m=0..31 t=0..3 c=0..7`")),
        };
        *numbers = Numbers::parse(text)?;
    }
    Ok(areas)
}

/// `OB 35 50ms`, `OB 35 50ms phase 10ms`.
fn cyclic(rest: &str) -> Result<(u16, CyclicInterrupt), String> {
    let not_understood = || format!("`cyclic {rest}` is not understood; write `cyclic OB 35 50ms` or `cyclic OB 35 50ms phase 10ms`");
    let (number, behind) = block_number(rest).ok_or_else(not_understood)?;
    if CyclicInterrupt::usual(number).is_none() {
        return Err(format!("OB {number} is no cyclic interrupt; these are OB 30 to OB 38"));
    }
    let ms = |text: &str, least: u64| {
        let us = duration(text)?;
        let ms = u16::try_from(us / 1000).ok().filter(|&ms| us % 1000 == 0 && u64::from(ms) >= least && ms <= CyclicInterrupt::MS_MAX);
        ms.ok_or_else(|| format!("`{text}` is no time of a cyclic interrupt; write {least}ms to 60s, in whole milliseconds"))
    };
    let (interval_ms, phase_ms) = match behind.split_whitespace().collect::<Vec<_>>().as_slice() {
        [interval] => (ms(interval, 1)?, 0),
        [interval, "phase", phase] => (ms(interval, 1)?, ms(phase, 0)?),
        _ => return Err(not_understood()),
    };
    Ok((number, CyclicInterrupt { interval_ms, phase_ms }))
}

fn expect(rest: &str) -> Result<Command, String> {
    let (word, behind) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
    match word {
        "stop" => {
            let digits = behind.trim().strip_prefix("16#").unwrap_or(behind.trim());
            let event = u16::from_str_radix(digits, 16).map_err(|_| format!("`{}` is no event such as 16#2522", behind.trim()))?;
            return Ok(Command::ExpectStop(event));
        }
        "mode" => {
            let modes = [OperatingMode::Stop, OperatingMode::Startup, OperatingMode::Run, OperatingMode::Hold];
            let mode = modes.into_iter().find(|mode| mode.to_string().eq_ignore_ascii_case(behind.trim()));
            return mode
                .map(Command::ExpectMode)
                .ok_or_else(|| format!("`{}` is no mode; write RUN, STOP, STARTUP or HOLD", behind.trim()));
        }
        _ => {}
    }
    let (values, within) = match rest.rsplit_once(" within ") {
        Some((values, time)) => (values, Some(duration(time.trim())?)),
        None => (rest, None),
    };
    Ok(Command::Expect(assignments(values)?, within))
}

/// Splits `I 0.0 MW10 "a name" DB1.x` into names: a word that begins with a digit belongs to the one before it.
fn name_list(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let (mut quoted, mut start) = (false, None);
    let mut words = Vec::new();
    for (at, c) in text.char_indices() {
        quoted ^= c == '"';
        match (c.is_whitespace() && !quoted, start) {
            (true, Some(begin)) => {
                words.push(&text[begin..at]);
                start = None;
            }
            (false, None) => start = Some(at),
            _ => {}
        }
    }
    words.extend(start.map(|begin| &text[begin..]));
    for word in words {
        match out.last_mut() {
            Some(before) if word.starts_with(|c: char| c.is_ascii_digit()) => {
                before.push(' ');
                before.push_str(word);
            }
            _ => out.push(word.to_owned()),
        }
    }
    out
}

/// `0..63` or `none`: bytes, the last one included.
fn byte_range(text: &str) -> Result<Range<u32>, String> {
    if text == "none" {
        return Ok(0..0);
    }
    let parse = |text: &str| text.trim().parse::<u32>().ok().filter(|&byte| byte < 65_536);
    match text.split_once("..").map(|(first, last)| (parse(first), parse(last))) {
        Some((Some(first), Some(last))) if first <= last => Ok(first..last + 1),
        _ => Err(format!("`{text}` are no bytes; write `0..63` or `none`")),
    }
}

/// A duration in microseconds.
fn duration(text: &str) -> Result<u64, String> {
    // Ten years of microseconds fit.
    duration::parse(text).map(|duration| duration.as_micros() as u64)
}

fn spell_us(us: u64) -> String {
    if us.is_multiple_of(1000) { format!("{}ms", us / 1000) } else { format!("{us}us") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_is_read() {
        let text = "cpu 416-3\ncycle 20ms\nmodules 0..3\nset I 0.0=1 MW10 = 16#0102 ACCU1=5 // a comment\n\n// another\nscan\nscan 3\nscan until 1.5s\n\
                    scan at 1510ms\nat 1s500ms I 0.0=0\ninterrupt OB 40 at safe point 17\nrestart cold\nexpect Q 0.0=1 T 1=70 STW.RLO=1\n\
                    expect Q 4.0=1 within 20ms\nexpect stop 16#2522\nexpect mode run\ntable I 0.0 \"my name\" MW10 -> Q 0.0 STW\n0 1 2 0 000000000\n1 1 5 | 1 000000110\nscan\nknown-gap \"later\"";
        let scenario = Scenario::parse(text).expect("a scenario");
        assert_eq!(scenario.cpu.map(|cpu| cpu.name), Some("416-3"));
        assert_eq!((scenario.cycle_us(), scenario.modules.clone(), scenario.known_gap.as_deref()), (20_000, Some(0..4), Some("later")));
        assert!(scenario.expects());
        assert_eq!(scenario.lines.len(), 14);
        let Command::Table { inputs, outputs, rows } = &scenario.lines[12].command else { panic!("a table") };
        assert_eq!(
            (inputs.as_slice(), outputs.as_slice()),
            (["I 0.0", "\"my name\"", "MW10"].map(str::to_owned).as_slice(), ["Q 0.0", "STW"].map(str::to_owned).as_slice())
        );
        assert_eq!((rows.len(), rows[1].0), (2, 20));
    }

    #[test]
    fn a_line_that_is_not_understood_is_named() {
        for (text, word) in [
            ("scna", "begins no line"),
            ("cpu 999", "no CPU type"),
            ("cycle 0ms", "more than 0"),
            ("cycle soon", "not a duration"),
            ("set", "NAME=VALUE"),
            ("set I 0.0", "NAME=VALUE"),
            ("set I 0.0=", "NAME=VALUE"),
            ("scan many", "no number"),
            ("scan until", "not understood"),
            ("scan 99999999", "no number"),
            ("at 10ms", "a time and what"),
            ("expect stop soon", "no event"),
            ("expect mode fast", "no mode"),
            ("table I 0.0", "->"),
            ("table I 0.0 -> Q 0.0", "no row"),
            ("table I 0.0 -> Q 0.0\n1", "1 values"),
            ("known-gap", "why"),
            ("interrupt", "safe point"),
            ("interrupt OB 40 at safe point 0", "safe point"),
            ("interrupt OB 1", "no event starts"),
            ("interrupt OB 82 EVENTS=1", "start information"),
            ("interrupt OB 82 EVENT=16#39420", "start information"),
            ("image-errors some", "not understood"),
            ("module 4 burns", "not understood"),
            ("cyclic OB 1 5ms", "no cyclic"),
            ("cyclic OB 35 0ms", "1ms to 60s"),
            ("cyclic OB 35", "not understood"),
            ("restart", "kind of restart"),
            ("power off", "power failure"),
            ("fault tank.level", "write the plant"),
            ("mend", "what is mended"),
            ("retain q=1", "retain m="),
            ("retain m", "no range"),
            ("retain m=5..1", "backwards"),
            ("modules 5", "no bytes"),
            ("scan until 9999999h", "ten years"),
        ] {
            let errors = Scenario::parse(text).expect_err(text);
            assert!(errors.iter().any(|error| error.message.contains(word)), "{text}: {errors:?}");
        }
    }
}
