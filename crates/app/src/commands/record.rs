//! `sieben record [PATH]… -o FILE`: runs a program and writes down what went in and what came out, as a scenario.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::Args;
use serde_json::json;
use sieben_cpu::{Cpu, Loaded, OperatingMode, Restart, Settings, StopCause};
use sieben_jit::StatusBits;
use sieben_model::problems::Problem;
use sieben_sim::scenario::recorder::{Recorder, Subject};
use sieben_sim::scenario::{Happened, Onlooker, Rules, Scenario, ScenarioError};
use sieben_sim::trace::CHANNELS_MAX;
use sieben_workspace::Speed;
use sieben_workspace::controller;
use sieben_workspace::duration;
use sieben_workspace::failed::Heard;
use sieben_workspace::names;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;
use sieben_workspace::tracing::channels;
use sieben_workspace::tracing::scenario::{origin, rack};

use super::run::now;
use crate::arguments::{FaultArguments, ProgramArguments};
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::paths::{self, is_scenario, shown};
use crate::retain::restart_argument;
use crate::schedule::ScheduleArguments;
use crate::tracing::scenario;
use crate::{files, language, output, terminal};

/// Text that waits at most before it is written.
const WAITING_MAX: usize = 64 << 10;
/// Scans that wait at most: a recording without a change is written, too.
const SCANS_MAX: u64 = 100_000;
/// At a pace, what was recorded waits no longer than this; a process that is killed loses no more.
const WAIT_MAX: Duration = Duration::from_secs(1);
/// Longest sleep without a look at Ctrl-C.
const NAP: Duration = Duration::from_millis(50);

/// Write down what goes into a program and what comes out of it, to hold another program against it.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben record old -o plant.scenario                       the project with its plants, until Ctrl-C\n  \
  sieben record old -o plant.scenario --speed max --for 1h  an hour of virtual time, at full speed\n  \
  sieben record old story.scenario -o plant.scenario        what the program does in a scenario\n  \
  sieben record old.awl --at 1s I0.0=1 --for 5s -o -        print it\n  \
  sieben test new --tests plant.scenario                    does the new program do the same?\n\n\
The recording is a scenario: inputs with their times, interrupts, the times of the scans, and behind\n\
every scan the outputs. `sieben test` and `sieben trace` run it again, on the same program scan by\n\
scan the same, and without the plants: it has the values of their sensors. Time is virtual: scan k\n\
begins at k x cycle; at 1x it is waited for.\n\
Ctrl-C ends the recording between two scans. A killed process leaves all but its last second.\n\n\
Exit codes: 0 ok, 1 an expectation of the scenario failed, 2 usage, 3 does not compile, 4 the CPU\n\
went to STOP.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, a project folder, a scenario to run [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Write the recording to this file (`-` prints it)
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    program: ProgramArguments,
    #[command(flatten)]
    schedule: ScheduleArguments,
    /// 1x is real time, 10x ten times as fast, max as fast as it goes [default: 1x, max for a scenario]
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true, value_parser = Speed::parse)]
    speed: Option<Speed>,
    /// How the CPU starts: warm or cold; retentive data of other runs is not there
    #[arg(long, value_name = "KIND", default_value = "warm", value_parser = restart_argument)]
    restart: Restart,
    /// Record these instead of the outputs that the program uses
    #[arg(long, value_name = "NAME,…")]
    channels: Vec<String>,
    /// Record these too: bit memory, timers, fields of data blocks
    #[arg(long, value_name = "NAME,…")]
    watch: Vec<String>,
    #[command(flatten)]
    faults: FaultArguments,
    /// Which engine runs the program
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
}

/// Records.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    paths::spare_sources([&arguments.output])?;
    let mut overrides = arguments.program.overrides()?;
    let (scenarios, paths): (Vec<PathBuf>, Vec<PathBuf>) = arguments.paths.iter().cloned().partition(|path| is_scenario(path));
    let given = match scenario::only(&scenarios, &arguments.schedule)? {
        Ok(given) => given,
        Err(exit) => return Ok(exit),
    };
    if let Some((path, _)) = &given
        && path.canonicalize().is_ok_and(|path| arguments.output.canonicalize().is_ok_and(|output| output == path))
    {
        let message = format!("`{}` is the scenario that is run, and its recording does not replace it", path.display());
        return Err(Failure::usage(Problem::P6013, message).help("give the recording another name"));
    }
    if let Some((path, scenario)) = &given
        && scenario.has_tables()
    {
        let message = format!("`{}` has a table, each row of which is a run of its own, and a recording is one run", path.display());
        return Err(Failure::usage(Problem::P6291, message));
    }
    let named_cpu = overrides.cpu.map(|cpu| cpu.name);
    overrides.cpu = overrides.cpu.or(given.as_ref().and_then(|(_, scenario)| scenario.cpu));
    let build = match super::or_report(arguments.program.load(&paths)?.compile(overrides, false), arguments.json) {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let speed = arguments.speed.unwrap_or(if given.is_some() { Speed::Max } else { Speed::Factor(1.0) });
    let settings = controller::settings(&build);
    let loaded = controller::loaded(&build, arguments.engine.factory(StatusBits::All));
    let mut cpu = Cpu::new(loaded.clone(), controller::rack(&build), settings.clone());
    arguments.faults.inject(&mut cpu)?;
    let (path, scenario) = match given {
        Some((path, scenario)) => (Some(path), scenario),
        None => {
            let plain = arguments.schedule.scenario(&build.project.settings, &build.project.symbols, &cpu)?;
            // In real time the time of day is that of the computer, as with `run`.
            let clock = (speed == Speed::Factor(1.0)).then(now);
            let start = (arguments.restart != Restart::Warm).then_some(arguments.restart);
            (None, plain.starting(start, clock).with_settings(settings.min_cycle, settings.image_errors))
        }
    };
    let subject = subject(arguments, &build, &cpu, &scenario, named_cpu.filter(|_| scenario.cpu.is_none()))?;
    let live = Live::new(arguments, Recorder::new(subject, &scenario), speed)?;
    if !arguments.json {
        announce(arguments, &build, &scenario, path.is_some());
    }
    record(arguments, &build, &scenario, path.map(PathBuf::as_path), &loaded, &settings, live)
}

fn announce(arguments: &Arguments, build: &Build, scenario: &Scenario, of_scenario: bool) {
    let name = build.project.settings.name.as_deref().map_or_else(String::new, |name| format!(" `{name}`"));
    let end = if of_scenario || arguments.schedule.has_end() { "" } else { "; Ctrl-C ends" };
    let cycle = duration::show(Duration::from_micros(scenario.cycle_us()));
    output::message(&format!("Recording{name} on a CPU {}, cycle {cycle}{end}.\n", build.cpu.name));
}

fn subject(
    arguments: &Arguments,
    build: &Build,
    cpu: &Cpu,
    scenario: &Scenario,
    named_cpu: Option<&'static str>,
) -> Result<Subject, Failure> {
    let (inputs, mut outputs) = channels::signals(build, cpu);
    let symbols = &build.project.symbols;
    if !arguments.channels.is_empty() {
        outputs = names::resolve_lists(&arguments.channels, symbols, cpu)?;
    }
    for name in names::resolve_lists(&arguments.watch, symbols, cpu)? {
        if !outputs.iter().any(|known| known.text() == name.text()) {
            outputs.push(name);
        }
    }
    if outputs.len() > CHANNELS_MAX {
        let message = format!("{} outputs are too many; a recording has at most {CHANNELS_MAX}", outputs.len());
        return Err(Failure::usage(Problem::P7032, message));
    }
    let origin = origin(build);
    Ok(Subject {
        program: origin.program,
        title: build.project.settings.name.clone().unwrap_or(origin.title),
        cpu: named_cpu,
        inputs,
        outputs,
        chosen: !arguments.channels.is_empty(),
        plants: !build.project.settings.modules.is_empty() && scenario.modules.is_none() && scenario.recorded.is_none(),
        mnemonics: Places::new(build).mnemonics,
    })
}

fn record(
    arguments: &Arguments,
    build: &Build,
    scenario: &Scenario,
    path: Option<&Path>,
    loaded: &Loaded,
    settings: &Settings,
    mut live: Live,
) -> Result<Exit, Failure> {
    let mut fresh = || {
        let mut cpu = Cpu::new(loaded.clone(), rack(build, scenario), settings.clone());
        // They were taken by another CPU before; a scenario with other modules has none that could fail.
        let _ = arguments.faults.inject(&mut cpu);
        cpu
    };
    let mut rules = Rules::default();
    // Who records a recording again wants to know what this program does, not what another one did.
    rules.expects_nothing = scenario.recorded.is_some();
    scenario.run_with(&build.project.symbols, &rules, &mut fresh, &mut live);
    let Live { recorder, mut file, failure, mut failures, stop, interrupted, heard, .. } = live;
    let failed = heard.failed(build);
    let (scans, time, outputs) = (recorder.scans(), Duration::from_micros(recorder.time_us()), recorder.outputs());
    let trouble = recorder.trouble().map(str::to_owned);
    if let Some(failure) = failure {
        return Err(failure);
    }
    file.put(&recorder.finish(), scans)?;
    // Without a scenario nobody expects anything, and a STOP is told below.
    if rules.expects_nothing || path.is_none() {
        failures.clear();
    }
    if let Some(trouble) = trouble {
        return Err(Failure::usage(Problem::P6291, format!("after {}: {trouble}", in_scans(scans))));
    }
    let place = path.map(shown).unwrap_or_default();
    // The JSON object has them.
    for error in failures.iter().filter(|_| !arguments.json) {
        let message = format!("{place}:{}: {}", error.line, error.message);
        output::styled(&Failure::usage(Problem::P6261, message).render(output::colour(), language::spoken()));
    }
    let interrupted = interrupted.load(Ordering::Relaxed);
    if arguments.json {
        let failures: Vec<_> = failures.iter().map(|error| json!({ "line": error.line, "message": error.message })).collect();
        let mut object = json!({
            "file": arguments.output, "scans": scans, "time_ms": duration::milliseconds(duration::micros(time)), "outputs": outputs,
            "interrupted": interrupted, "failures": failures,
        });
        if let Some(cause) = &stop {
            object["stop"] = controller::stop_json(cause);
        }
        if let Some(failed) = &failed {
            object["failed_statements"] = failed.json();
        }
        // What was printed is the recording.
        if arguments.output.as_os_str() != "-" {
            output::print_json(&object, false)?;
        }
    } else {
        let how = if interrupted { ", ended by Ctrl-C" } else { "" };
        let of = if outputs == 1 { "1 output".to_owned() } else { format!("{outputs} outputs") };
        let place = if arguments.output.as_os_str() == "-" { String::new() } else { format!(": `{}`", shown(&arguments.output)) };
        output::message(&format!("{} ({}) with {of}{how}{place}\n", in_scans(scans), duration::show(time)));
        if let Some(failed) = &failed {
            output::message(&format!("{}\n", failed.line()));
        }
        if let Some(cause) = &stop {
            output::message(&controller::stop_text(build, cause));
        }
    }
    Ok(match (failures.is_empty(), &stop) {
        (false, _) => Exit::CheckFailed,
        // A scenario that ran through a STOP to its end knew of it.
        (true, Some(_)) if path.is_none() => Exit::Stopped,
        (true, _) => Exit::Success,
    })
}

fn in_scans(scans: u64) -> String {
    if scans == 1 { "1 scan".to_owned() } else { format!("{scans} scans") }
}

/// Where the recording goes.
enum Written {
    /// A file, with its path, the bytes that whole scans have, and those scans.
    File { path: PathBuf, file: File, bytes: u64, scans: u64 },
    /// Standard output.
    Printed,
}

impl Written {
    fn create(path: &Path) -> Result<Self, Failure> {
        if path.as_os_str() == "-" {
            return Ok(Self::Printed);
        }
        if path.is_dir() {
            return Err(Failure::usage(Problem::P6013, format!("`{}` is a folder, so no file can be written there", path.display())));
        }
        let file = File::create(path).map_err(|error| files::unwritable(path, &error))?;
        Ok(Self::File { path: path.to_path_buf(), file, bytes: 0, scans: 0 })
    }

    /// Writes a piece that ends with a whole scan. If there is no room for all of it, none of it stays.
    fn put(&mut self, text: &str, scans_then: u64) -> Result<(), Failure> {
        match self {
            Self::Printed => output::print_data(text),
            Self::File { path, file, bytes, scans } => {
                if let Err(error) = file.write_all(text.as_bytes()) {
                    // What is left of the piece is left out by whoever reads it, too.
                    let _ = file.set_len(*bytes);
                    let kept =
                        if *scans == 0 { "no scan is in it".to_owned() } else { format!("the {} before are in it", in_scans(*scans)) };
                    let message = format!("`{}` cannot be written: {error}; {kept}", path.display());
                    return Err(Failure::usage(Problem::P6290, message));
                }
                *bytes += text.len() as u64;
                *scans = scans_then;
                Ok(())
            }
        }
    }
}

/// The run as it is recorded, at its pace.
struct Live {
    recorder: Recorder,
    file: Written,
    /// Real seconds of a second of the CPU; `None` does not wait.
    factor: Option<f64>,
    /// When the CPU began, later by what it was late.
    begun: Instant,
    written: Instant,
    scans: u64,
    interrupted: Arc<AtomicBool>,
    failure: Option<Failure>,
    failures: Vec<ScenarioError>,
    stop: Option<StopCause>,
    /// A STOP ends the run.
    ends_with_stop: bool,
    /// Statements that failed while the program went on.
    heard: Heard,
}

impl Live {
    fn new(arguments: &Arguments, recorder: Recorder, speed: Speed) -> Result<Self, Failure> {
        let factor = match speed {
            Speed::Factor(factor) => Some(factor),
            Speed::Max => None,
        };
        Ok(Self {
            recorder,
            file: Written::create(&arguments.output)?,
            factor,
            begun: Instant::now(),
            written: Instant::now(),
            scans: 0,
            interrupted: terminal::interrupted(),
            failure: None,
            failures: Vec::new(),
            stop: None,
            ends_with_stop: !arguments.paths.iter().any(|path| is_scenario(path)),
            heard: Heard::default(),
        })
    }

    /// Waits until a scan is due. One that is late begins at once, and the others as much later: nothing is made up for.
    fn wait(&mut self, time_us: u64) {
        let Some(factor) = self.factor else { return };
        let due = self.begun + Duration::from_secs_f64(time_us as f64 / 1e6 / factor);
        loop {
            let now = Instant::now();
            match due.checked_duration_since(now) {
                Some(left) if !left.is_zero() && !self.interrupted.load(Ordering::Relaxed) => std::thread::sleep(left.min(NAP)),
                Some(_) => return,
                None => {
                    self.begun += now - due;
                    return;
                }
            }
        }
    }

    fn write(&mut self) {
        let text = self.recorder.take();
        self.scans = self.recorder.scans();
        self.written = Instant::now();
        if let Err(failure) = self.file.put(&text, self.scans) {
            self.failure = Some(failure);
        }
    }
}

impl Onlooker for Live {
    fn see(&mut self, happened: Happened<'_>) {
        match &happened {
            Happened::Due { time_us, .. } => self.wait(*time_us),
            Happened::Failed(error) => self.failures.push((*error).clone()),
            Happened::Scan { cpu, .. } => {
                self.heard.hear(cpu);
                self.stop = cpu.stop_cause().filter(|_| cpu.mode() == OperatingMode::Stop).cloned();
            }
            _ => {}
        }
        let scanned = matches!(happened, Happened::Scan { .. });
        self.recorder.see(happened);
        let due = match self.factor {
            Some(_) => self.written.elapsed() >= WAIT_MAX,
            None => self.recorder.scans() - self.scans >= SCANS_MAX,
        };
        if scanned && self.failure.is_none() && (due || self.recorder.waiting() >= WAITING_MAX) {
            self.write();
        }
    }

    fn may_go_on(&mut self) -> bool {
        let stopped = self.ends_with_stop && self.stop.is_some();
        self.failure.is_none() && self.recorder.trouble().is_none() && !stopped && !self.interrupted.load(Ordering::Relaxed)
    }
}
