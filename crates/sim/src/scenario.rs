//! Scenarios: what happens to a CPU and what is expected of it, one line each.
//!
//! The language of executable pages, recordings and `*.scenario` files:
//!
//! ```text
//! cpu 416-3                            the CPU type (default: that of the caller)
//! cycle 10ms                           distance of two scans (default 10ms)
//! plant oven gain=181.3 seed=7         parameters of a simulated plant, instead of those of the project
//! modules 0..63                        only these peripheral bytes have a module (default: all); `modules none`
//! set I 0.0=1 MW10=16#0102 ACCU1=5     before the next scan
//! force I 0.0=1 Q 4.0=0                from the next scan on, until
//! unforce I 0.0 | unforce              ends the forcing of one name, or of all
//! scan | scan 3 | scan until 400ms | scan at 410ms
//! at 310ms I 0.0=0                     at that time: an input for all that runs from then on, anything else for the next scan
//! at 310ms interrupt OB 40             at that time, as if a module had raised it; also with EVENT= ID= INFO1= INFO2=
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
//! start cold                           the first start, instead of a warm restart
//! start with I 0.1=1 PIW 256=100       inputs that are there before the CPU starts
//! clock DT#2026-11-22-09:30:00         the time of day at time 0 (default: 1994-01-01)
//! always Q 0.0=1 MW 4=7                from the next scan on, behind every scan, until another `always` of that name; `=?` ends it
//! expect Q 0.0=1 T 1=70 STW.RLO=1
//! expect Q 4.0=1 within 20ms           scans until it is so
//! expect stop 16#2522                  the first cause, or the event of the STOP
//! expect mode RUN
//! table I 0.0 I 0.1 -> Q 0.0           rows of values follow: each a fresh CPU, `set`, one scan, `expect`
//! property never "short circuit" K1 AND K2   from the first scan on; `always`, `finally`, `response "it starts" within 2s Start -> Running`
//! allow within 20ms                    a value of `always` may come so much earlier or later; `allow tolerance 2%`, `allow ignore Lamp`
//! known-gap "why"                      the scenario is expected to fail
//! recorded 0123456789ABCDEF "main.awl" what [`recorder`] has written: of which program, and with how many scans it ends;
//! end 1000                             without this line it was cut off, and ends with its last whole scan
//! // a comment
//! ```
//! Scan k begins at k times the cycle, the first at 0. A table row begins with the `set` lines above it.

mod allowed;
pub mod changing;
mod held;
pub mod made;
mod parse;
pub mod property;
pub mod recorder;
pub mod rules;
mod run;
mod spelling;
mod text;

use std::cell::RefCell;
use std::fmt;
use std::ops::Range;
use std::time::Duration;

use sieben_cpu::{Cpu, CyclicInterrupt, DateAndTime, ImageErrors, Interrupt, OperatingMode, Restart, RetentiveAreas};
use sieben_engine::Tracer;
use sieben_model::cpu_type::CpuType;
use sieben_model::symbols::SymbolTable;

pub use allowed::Allowed;
pub use held::{Difference, Holding};
use parse::{assignments, byte_range, cyclic, date_and_time, duration, expect, interrupt, name_list, plant, retain, scan, without_comment};
use property::PropertyLine;
pub use rules::Rules;
use run::Run;

use crate::names::Setting;
use crate::wrap::Fault;

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
pub enum Happened<'a> {
    /// A CPU is about to begin at time 0: that of the scenario, or that of a row of a table.
    Began {
        /// The CPU before its start.
        cpu: &'a mut Cpu,
    },
    /// Something that no module did: the line of a scenario that does the same; for what happens to a plant, what it is.
    Did(Deed<'a>),
    /// A scan is about to begin.
    Due {
        /// The CPU before the scan.
        cpu: &'a mut Cpu,
        /// When it begins, in microseconds.
        time_us: u64,
    },
    /// A scan ended.
    Scan {
        /// The CPU behind the scan.
        cpu: &'a mut Cpu,
        /// When the scan began, in microseconds.
        time_us: u64,
        /// What is expected behind it.
        held: Holding<'a>,
    },
    /// A value is not what a line says that it always is; told once for each name.
    Differs(&'a Difference),
    /// Something did not come true, or could not be done.
    Failed(&'a ScenarioError),
}

/// Something that a scenario does to a CPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deed<'a> {
    /// The line that does it.
    Line(&'a str),
    /// It happens to a simulated plant: a fault, or the end of one.
    Plant,
    /// A module fails or answers again: the line.
    Module(&'a str),
    /// Power off and on.
    PowerFailure,
}

/// Someone who looks on while a scenario runs.
pub trait Onlooker {
    /// Something happens.
    fn see(&mut self, happened: Happened<'_>);
    /// Whether the run may go on; asked before every scan.
    fn may_go_on(&mut self) -> bool {
        true
    }
    /// Who is told of every statement.
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        None
    }
}

/// Someone who only looks.
pub type Watch<'a> = dyn FnMut(Happened<'_>) + 'a;

impl Onlooker for &mut Watch<'_> {
    fn see(&mut self, happened: Happened<'_>) {
        self(happened);
    }
}

/// A scenario, read and ready to run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scenario {
    /// The CPU type that it asks for.
    pub cpu: Option<&'static CpuType>,
    /// Peripheral bytes that have a module; `None` = all.
    pub modules: Option<Range<u32>>,
    /// Why it is expected to fail, if it is.
    pub known_gap: Option<String>,
    /// What it was recorded of, if it is a recording.
    pub recorded: Option<Recorded>,
    cycle_us: u64,
    min_cycle_us: u64,
    image_errors: ImageErrors,
    cyclic: Vec<(u16, CyclicInterrupt)>,
    retain: Option<RetentiveAreas>,
    start: Option<Restart>,
    start_with: Assignments,
    clock: Option<DateAndTime>,
    plants: Vec<PlantLine>,
    properties: Vec<PropertyLine>,
    allowed: Allowed,
    lines: Vec<Line>,
}

/// Parameters of a simulated plant, instead of those of the project.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlantLine {
    /// The module, as the project calls it.
    pub module: String,
    /// What its random numbers begin with.
    pub seed: Option<u64>,
    /// Parameters with their values.
    pub parameters: Vec<(String, f64)>,
}

/// What a recording says of itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Recorded {
    /// [`crate::trace::identity`] of the sources.
    pub program: u64,
    /// What the program is called.
    pub title: String,
    /// Whether it has no end: what was written before is there.
    pub cut_off: bool,
    /// How many scans it says that it has.
    end: Option<(usize, u64)>,
}

#[derive(Clone, Debug, PartialEq)]
struct Line {
    number: usize,
    command: Command,
}

/// Values that go to names.
pub type Assignments = Vec<Assignment>;

/// A value that goes to a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// The name as it was written.
    name: String,
    /// The value as it was written.
    value: String,
    /// What both mean; a scenario that is only read does not know the program yet.
    meant: Option<Setting>,
}

impl Assignment {
    fn written(name: String, value: String) -> Self {
        Self { name, value, meant: None }
    }
}

impl From<Setting> for Assignment {
    fn from(setting: Setting) -> Self {
        Self { name: setting.name.text().to_owned(), value: setting.text.clone(), meant: Some(setting) }
    }
}

#[derive(Clone, Debug, PartialEq)]
enum Command {
    Set(Assignments),
    Force(Assignments),
    Unforce(Option<String>),
    Scan(u64),
    ScanUntil(u64),
    ScanAt(u64),
    At(u64, Assignments),
    InterruptAt(u64, Interrupt),
    Always(Assignments),
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
const WORDS: &str = "`cpu`, `cycle`, `min-cycle`, `cyclic`, `image-errors`, `modules`, `module`, `plant`, `property`, `allow`, `fault`, `mend`, `retain`, `set`, `force`, `unforce`, `scan`, `at`, `start`, `clock`, `interrupt`, `restart`, `power`, `expect`, `always`, `table` or `known-gap`";

impl Scenario {
    /// Reads a scenario, with or without a byte order mark.
    ///
    /// # Errors
    /// All lines that are not understood.
    pub fn parse(text: &str) -> Result<Self, Vec<ScenarioError>> {
        let text = text.trim_start_matches('\u{FEFF}');
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
        scenario.end(text, &mut errors);
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
        if let Some(property) = scenario.properties.first().filter(|_| scenario.has_tables()) {
            let message = "a property is held against one run; the rows of a table are runs of their own".to_owned();
            errors.push(ScenarioError { line: property.line, message });
        }
        if errors.is_empty() { Ok(scenario) } else { Err(errors) }
    }

    /// Whether it expects anything at all.
    pub fn expects(&self) -> bool {
        !self.properties.is_empty()
            || self.lines.iter().any(|line| {
                let command = &line.command;
                matches!(
                    command,
                    Command::Expect(..) | Command::Always(_) | Command::ExpectStop(_) | Command::ExpectMode(_) | Command::Table { .. }
                )
            })
    }

    /// A run without expectations: so many scans at a cycle, or at these times; what is set before the first, and what at a time.
    pub fn plain(times: Times, set: Assignments, at: Vec<(u64, Assignments)>) -> Self {
        let (cycle_us, scans) = match times {
            Times::Cyclic { cycle_us, scans } => (cycle_us.max(1), vec![Command::Scan(scans)]),
            Times::At(times) => (CYCLE_US, times.into_iter().map(Command::ScanAt).collect()),
        };
        let set = (!set.is_empty()).then_some(Command::Set(set));
        let at = at.into_iter().map(|(time, values)| Command::At(time, values));
        let commands = set.into_iter().chain(at).chain(scans);
        Self { cycle_us, lines: commands.map(|command| Line { number: 0, command }).collect(), ..Self::default() }
    }

    /// The first start of the CPU.
    pub fn start(&self) -> Restart {
        self.start.unwrap_or(Restart::Warm)
    }

    /// Sets the first start of the CPU, and its time of day at time 0.
    #[must_use]
    pub fn starting(self, start: Option<Restart>, clock: Option<DateAndTime>) -> Self {
        Self { start: start.or(self.start), clock: clock.or(self.clock), ..self }
    }

    /// Sets the least cycle time and what happens when the process image cannot be exchanged.
    #[must_use]
    pub fn with_settings(self, min_cycle: Duration, image_errors: ImageErrors) -> Self {
        Self { min_cycle_us: u64::try_from(min_cycle.as_micros()).unwrap_or(u64::MAX), image_errors, ..self }
    }

    /// What has to hold of its run; whoever runs it compiles the expressions.
    pub fn properties(&self) -> &[PropertyLine] {
        &self.properties
    }

    /// By how much a run may differ from what it says that always is.
    pub fn allowed(&self) -> &Allowed {
        &self.allowed
    }

    /// Parameters of simulated plants that it has instead of those of the project.
    pub fn plants(&self) -> &[PlantLine] {
        &self.plants
    }

    /// Whether it has rows that are a run of their own each.
    pub fn has_tables(&self) -> bool {
        self.lines.iter().any(|line| matches!(line.command, Command::Table { .. }))
    }

    /// Every name of something in the program, with the line where it stands first.
    pub fn names(&self) -> Vec<(usize, &str)> {
        let mut seen = std::collections::HashSet::new();
        let mut names: Vec<(usize, &str)> = self.start_with.iter().map(|one| (1, one.name.as_str())).collect();
        for line in &self.lines {
            match &line.command {
                Command::Set(values)
                | Command::Force(values)
                | Command::At(_, values)
                | Command::Always(values)
                | Command::Expect(values, _) => {
                    names.extend(values.iter().map(|one| (line.number, one.name.as_str())));
                }
                Command::Table { inputs, outputs, .. } => {
                    names.extend(inputs.iter().chain(outputs).map(|name| (line.number, name.as_str())));
                }
                _ => {}
            }
        }
        names.retain(|(_, name)| seen.insert(*name));
        names
    }

    /// What is to be held against a recording that has no end, or another than it says.
    fn end(&mut self, text: &str, errors: &mut Vec<ScenarioError>) {
        let Some(recorded) = &mut self.recorded else { return };
        let scans = |line: &Line| match line.command {
            Command::Scan(count) => count,
            Command::ScanAt(_) => 1,
            _ => 0,
        };
        // The last line may be half a line, also that of the end.
        let half = (!text.ends_with('\n')).then(|| text.lines().count());
        match recorded.end.filter(|(line, _)| Some(*line) != half) {
            Some((line, end)) => {
                let found: u64 = self.lines.iter().map(scans).sum();
                if found != end {
                    let message = format!(
                        "the recording says that it ends after {end} scans, but has {found}: lines are missing or were added; \
                         record again, or take the lines `recorded` and `end` away to use what is left as a scenario"
                    );
                    errors.push(ScenarioError { line, message });
                }
            }
            None => {
                recorded.cut_off = true;
                if let Some(last) = half {
                    errors.retain(|error| error.line != last);
                    self.lines.retain(|line| line.number != last);
                }
                let whole = self.lines.iter().rposition(|line| scans(line) > 0).map_or(0, |last| last + 1);
                self.lines.truncate(whole);
            }
        }
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
                self.cycle_us = crate::duration::parse_cycle(rest)?.as_micros() as u64;
                if self.cycle_us == 0 {
                    return Err("a cycle lasts more than 0".to_owned());
                }
                return Ok(());
            }
            "plant" => {
                self.plants.push(plant(rest)?);
                return Ok(());
            }
            "property" => {
                self.properties.push(PropertyLine::parse(number, rest)?);
                return Ok(());
            }
            "allow" => return self.allowed.line(rest),
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
            "recorded" => {
                let (program, title) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
                let wanted = || format!("`recorded {rest}` is not understood; only `sieben record` writes this line");
                let program = u64::from_str_radix(program, 16).map_err(|_| wanted())?;
                self.recorded = Some(Recorded { program, title: title.trim().trim_matches('"').to_owned(), ..Recorded::default() });
                return Ok(());
            }
            "end" => {
                let scans = rest.parse().map_err(|_| "`end` is followed by the number of scans of a recording".to_owned())?;
                let recorded = self.recorded.as_mut().ok_or("only a recording has an `end`")?;
                recorded.end = Some((number, scans));
                return Ok(());
            }
            "start" => {
                match (rest, rest.split_once(char::is_whitespace)) {
                    (_, Some(("with", values))) => self.start_with.extend(assignments(values)?),
                    (word, _) => self.start = Some(kind_of_restart(word)?),
                }
                return Ok(());
            }
            "clock" => {
                self.clock = Some(date_and_time(rest)?);
                return Ok(());
            }
            "always" => Command::Always(assignments(rest)?),
            "set" => Command::Set(assignments(rest)?),
            "force" => Command::Force(assignments(rest)?),
            "unforce" => Command::Unforce((!rest.is_empty()).then(|| rest.to_owned())),
            "scan" => scan(rest)?,
            "at" => {
                let (time, values) =
                    rest.split_once(char::is_whitespace).ok_or("write a time and what changes then: `at 310ms I 0.0=0`")?;
                let time = duration(time)?;
                match values.trim_start().strip_prefix("interrupt ") {
                    Some(what) => match interrupt(what)? {
                        Command::Interrupt(interrupt, None) => Command::InterruptAt(time, interrupt),
                        _ => return Err("an interrupt comes at a time or at a safe point, not at both".to_owned()),
                    },
                    None => Command::At(time, assignments(values)?),
                }
            }
            "interrupt" => interrupt(rest)?,
            "restart" => Command::Restart(kind_of_restart(rest)?),
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
        if let Some(clock) = self.clock {
            cpu.set_start_of_clock(clock);
        }
        cpu
    }

    /// Runs the scenario. `fresh` makes a CPU in STOP with the program loaded.
    /// What did not come true is returned; a [`Self::known_gap`] is the caller's to judge.
    pub fn run(&self, symbols: &SymbolTable, fresh: &mut dyn FnMut() -> Cpu) -> Vec<ScenarioError> {
        self.run_watched(symbols, fresh, &mut |_| {})
    }

    /// As [`Self::run`], with someone who looks on.
    pub fn run_watched(&self, symbols: &SymbolTable, fresh: &mut dyn FnMut() -> Cpu, mut watch: &mut Watch<'_>) -> Vec<ScenarioError> {
        self.run_with(symbols, &Rules::default(), fresh, &mut watch)
    }

    /// As [`Self::run`], by these rules, with someone who looks on, may end the run and watch statements.
    pub fn run_with(
        &self,
        symbols: &SymbolTable,
        rules: &Rules,
        fresh: &mut dyn FnMut() -> Cpu,
        onlooker: &mut dyn Onlooker,
    ) -> Vec<ScenarioError> {
        let rules = &self.allowed.added_to(rules, self.cycle_us());
        // The CPU of the scenario stays while rows of a table have theirs.
        let onlooker = RefCell::new(onlooker);
        let mut failures = Vec::new();
        let mut run: Option<Run<'_, '_>> = None;
        let start = |cpu: Cpu| Run::start(self.prepare(cpu), self, symbols, rules, &onlooker);
        for (index, line) in self.lines.iter().enumerate() {
            if let Command::Table { inputs, outputs, rows } = &line.command {
                for (number, values) in rows {
                    let mut row = start(fresh());
                    row.line = *number;
                    for above in &self.lines[..index] {
                        if let Command::Set(assignments) = &above.command {
                            row.set(assignments);
                        }
                    }
                    let (given, expected) = values.split_at(inputs.len());
                    let pairs = |names: &[String], values: &[String]| {
                        names
                            .iter()
                            .cloned()
                            .zip(values.iter().cloned())
                            .map(|(name, value)| Assignment::written(name, value))
                            .collect::<Vec<_>>()
                    };
                    row.set(&pairs(inputs, given));
                    row.scan();
                    row.expect(&pairs(outputs, expected), None);
                    row.finish();
                    failures.append(&mut row.failures);
                }
                continue;
            }
            let run = run.get_or_insert_with(|| start(fresh()));
            run.line = line.number;
            match line.command {
                Command::PowerFailure => run.power_failure(self.prepare(fresh())),
                _ => run.command(&line.command),
            }
            if run.is_given_up() {
                break;
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

fn kind_of_restart(word: &str) -> Result<Restart, String> {
    Restart::from_word(word).ok_or_else(|| format!("`{word}` is no kind of restart; write `warm`, `hot` or `cold`"))
}

/// When the scans of a run begin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Times {
    /// So many at multiples of a cycle, in microseconds.
    Cyclic {
        /// From one scan to the next.
        cycle_us: u64,
        /// How many.
        scans: u64,
    },
    /// At these times, in microseconds.
    At(Vec<u64>),
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
