//! `sieben run [PATH]`: runs a project, in real time or as fast as it goes.

mod around;

use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use clap::Args;
use serde_json::json;
use sieben_cpu::{Cpu, DateAndTime, OperatingMode, Settings, StopRequest, TimeSource};
use sieben_jit::StatusBits;
use sieben_model::problems::Problem;
use sieben_workbench::Projects;
use sieben_workspace::control::{CurrentFacts, Facts, watched};
use sieben_workspace::controller;
use sieben_workspace::duration;
use sieben_workspace::exchange::Next;
use sieben_workspace::failed::{self, Failed};
use sieben_workspace::gate::Clock;
use sieben_workspace::observed::Observer;
use sieben_workspace::project::{Build, Overrides};
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, Gate, Pace, Plant, Speed};

use crate::arguments::{DiagnosticsArgument, FaultArguments, ProgramArguments, StrictArgument};
use crate::chosen::{self, Change, Choice, Chosen, Prepare};
use crate::control::Server;
use crate::duration::{cycle_argument, duration_argument};
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::page::Answers;
use crate::palette::Palette;
use crate::retain::{RetainArguments, Retention, RunTime};
use crate::screen::{self, Direct, Screen};
use crate::servers::{Always, Prepared, PreparedPage, ServerArguments, Servers, Usually};
use crate::watch::{Losses, Watch};
use crate::{output, terminal, watch};

use around::{Around, Say};

/// Exit code after a second Ctrl-C: what shells report for SIGINT.
const INTERRUPTED: i32 = 130;
/// Entries of the diagnostic buffer that are printed after a STOP: cause, consequence and how the run began.
const ENTRIES_SHOWN: usize = 4;
/// STOP by the mode switch: the event that Ctrl-C causes.
const STOP_BY_SWITCH: u16 = 0x4303;
/// STOP by a request at the control socket.
const STOP_FROM_OUTSIDE: u16 = 0x4304;

/// Run a project.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben run                            the project in this folder, on a screen, until q\n  \
  sieben run pump --plain               one line for each change\n  \
  sieben run pump --for 10s             ten seconds, then exit 0\n  \
  sieben run pump --speed max --for 1h  an hour of virtual time, at full speed\n  \
  sieben run pump --restart cold        with all values as the program declares them\n  \
  sieben run pump --watch               changed sources take over while it runs\n  \
  sieben run pump --s7                  S7 clients of this computer reach it at 127.0.0.1:1102\n\n\
On a terminal the run has a screen: inputs to switch, outputs, the program, faults; ? shows its keys.\n\
With a server the run stays up while the CPU is in STOP, except with --for.\n\
Ctrl-C stops cleanly; a second Ctrl-C stops at once. Retentive data of a project survives both, and a kill.\n\
Exit codes: 0 ok, 1 a statement failed (--strict), 2 usage, 3 does not compile, 4 the CPU went to STOP.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: RunArguments,
}

/// What `run` and `serve` take.
#[derive(Args)]
pub(crate) struct RunArguments {
    /// Source files, symbol tables, or a project folder [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Time from one scan to the next; 0 runs free [default: the project's, else 10ms]
    #[arg(long, value_name = "DURATION", allow_hyphen_values = true, value_parser = cycle_argument)]
    cycle: Option<Duration>,
    /// 1x is real time, 10x ten times as fast, max as fast as it goes in virtual time
    #[arg(long, value_name = "FACTOR", default_value = "1x", allow_hyphen_values = true, value_parser = Speed::parse)]
    speed: Speed,
    /// Stop after this time of the CPU's clock
    #[arg(long = "for", value_name = "DURATION", id = "duration", allow_hyphen_values = true, value_parser = duration_argument)]
    duration: Option<Duration>,
    #[command(flatten)]
    servers: ServerArguments,
    #[command(flatten)]
    retain: RetainArguments,
    #[command(flatten)]
    faults: FaultArguments,
    /// Which engine runs the program
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Look for changed sources, and let them take over between two scans with the data kept
    #[arg(long)]
    watch: bool,
    /// With --watch: do not ask when values of data blocks cannot be kept
    #[arg(long, requires = "watch")]
    accept_losses: bool,
    #[command(flatten)]
    strict: StrictArgument,
    #[command(flatten)]
    diagnostics: DiagnosticsArgument,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
    /// No screen: print one line for each change
    #[arg(long, conflicts_with = "json")]
    plain: bool,
}

/// Runs the project.
pub(crate) fn run(arguments: Arguments) -> Result<Exit, Failure> {
    run_as(Verb::Run, arguments.common)
}

/// Which verb runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verb {
    /// `sieben run`.
    Run,
    /// `sieben serve`.
    Serve,
}

/// Runs the project for one of the verbs.
pub(crate) fn run_as(verb: Verb, mut arguments: RunArguments) -> Result<Exit, Failure> {
    arguments.servers.give_back(&mut arguments.paths)?;
    let arguments = &arguments;
    let overrides = match arguments.strict.is_strict() {
        true => arguments.strict.overrides(arguments.program.overrides()?),
        false => arguments.program.overrides_at_speed()?,
    };
    let stamps = if arguments.watch { watch::stamps(&arguments.paths) } else { watch::Stamps::new() };
    let mut build = match super::or_report(arguments.program.load(&arguments.paths)?.compile(overrides, false), arguments.json) {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let always = if verb == Verb::Serve { Always::Yes } else { Always::No };
    let prepared = match arguments.servers.config(&build.project, always)? {
        Some(config) => Some(Prepared::new(&arguments.servers, config, &build.project)?),
        None => None,
    };
    let of_page = build.project.settings.servers.page.as_ref();
    let usually = if always == Always::Yes && of_page.is_some() { Usually::With } else { Usually::Without };
    let prepared_page = arguments.servers.prepare_page(of_page, build.project.home.as_deref(), usually)?;
    let project = &build.project.settings;
    let cycle = cycle_of(&build, arguments.cycle);
    if arguments.speed == Speed::Max && cycle.is_zero() {
        return Err(Failure::usage(Problem::P7009, "with `--speed max` time is virtual, and a cycle of 0 would never pass any")
            .help("give `--cycle 10ms`"));
    }
    let source = if arguments.speed == Speed::Factor(1.0) { TimeSource::Real } else { TimeSource::Virtual };
    let mut cpu = controller::load(&build, arguments.engine.factory(StatusBits::Needed), settings(&build, source));
    arguments.faults.inject(&mut cpu)?;
    let time = if arguments.speed == Speed::Max { RunTime::Virtual } else { RunTime::Real };
    let choice = arguments.retain.choice(&build.project, time, arguments.json);
    if choice.is_none() {
        arguments.retain.adopt_only(&mut cpu, arguments.json)?;
    }
    let retention = choice.map(|choice| Retention::open(&choice, &mut cpu)).transpose()?;
    let cycle_us = duration::micros(cycle);
    let clock = real_clock();
    let facts = Arc::new(CurrentFacts::new(Facts::of(&build, cpu.program())));
    let pace = Pace::new(arguments.speed, cycle_us, arguments.duration.map_or(u64::MAX, duration::micros), clock());
    let request = cpu.stop_request();
    let mut plant = Plant::new(cpu, pace);
    // With an end of its own a run is an experiment, whose STOP is its result.
    let stays = (prepared.is_some() || prepared_page.is_some()) && arguments.duration.is_none();
    if stays {
        plant.stay_in_stop();
    }
    // Who reaches the run before its first scan waits for the start.
    plant.switch_on(arguments.retain.restart);
    let gate = Arc::new(Gate::new(plant, clock));
    let ending = Arc::new(Ending { request, gate: Arc::clone(&gate), presses: AtomicUsize::new(0) });
    watch_for_interrupt(&ending)?;
    let shown = Shown::of(verb, arguments);
    if !arguments.json {
        let name = project.name.as_deref().map_or_else(String::new, |name| format!(" `{name}`"));
        let end = arguments.duration.map_or_else(|| "Ctrl-C stops".to_owned(), |end| format!("for {}", duration::show(end)));
        let pace = if cycle.is_zero() { "free running".to_owned() } else { format!("cycle {}", duration::show(cycle)) };
        output::message(&format!("Running{name} on a CPU {}, {pace}; {end}.\n", build.cpu.name));
    }
    let watch = match arguments.watch {
        true => Some(Watch::start(
            stamps,
            &arguments.paths,
            (&arguments.program, overrides),
            arguments.engine,
            &build,
            match shown {
                _ if arguments.accept_losses => Losses::Accepted,
                Shown::Screen => Losses::Refused,
                Shown::Changes | Shown::Messages => Losses::Asked,
            },
        )?),
        false => None,
    };
    let desk = Arc::new(Desk::default());
    let server = Server::start((&arguments.paths, build.project.home.as_deref()), &gate, &desk, &facts);
    if let Err(why) = &server
        && !arguments.json
    {
        output::message(&why.to_string());
    }
    let mut servers = prepared.map(|prepared| prepared.start(build.cpu, &gate, arguments.engine)).transpose()?;
    let stays_with = verb == Verb::Serve || arguments.watch || arguments.duration.is_some();
    let example = chosen::example_of(&build.project).filter(|_| !stays_with);
    let choice = match example {
        Some(example) => Choice::Examples(example),
        None => Choice::Alone(project.name.clone().unwrap_or_else(|| "Sieben".to_owned())),
    };
    let prepare = prepare(arguments.engine, overrides, source, arguments.cycle);
    let chosen = Arc::new(Chosen::new(choice, build.project.home.as_deref(), &gate, prepare));
    let start_page = |page: PreparedPage| {
        let projects = Arc::clone(&chosen) as Arc<dyn Projects>;
        page.start((&gate, &desk, &facts), servers.as_ref(), Box::new(Answers::default()), projects)
    };
    let page = prepared_page.map(start_page).transpose()?;
    let metrics = arguments.servers.start_metrics(&gate, servers.as_ref())?;
    if let Some(servers) = &servers {
        servers.introduce(&facts, &gate);
        match arguments.json {
            false => output::message(&servers.text()),
            // A program that waits for the server reads this line.
            true if verb == Verb::Serve => {
                let mut listening = servers.json();
                if let Some(page) = &page {
                    listening["page"] = page.address().to_string().into();
                }
                output::print_json(&json!({ "listening": listening }), false)?;
            }
            true => {}
        }
    }
    if let Some(page) = page.as_ref().filter(|_| !arguments.json) {
        match shown {
            Shown::Screen => drop(gate.enter(|plant| desk.observed.note(plant, page.text().trim_end()))),
            _ => output::message(&page.text()),
        }
    }
    if let Some(metrics) = &metrics
        && !arguments.json
    {
        output::message(&format!("Metrics are at http://{}/metrics.\n", metrics.address()));
    }
    let quiet = arguments.json;
    let changes = (shown == Shown::Changes).then(|| Observer::new(watched(&facts.facts())));
    let asks = (shown == Shown::Screen).then(|| Direct::new(&gate, &desk, &facts));
    let (failed, say) = (None, Say { desk: &desk, shown });
    let mut around = Around {
        retention,
        watch,
        build: &mut build,
        facts: &facts,
        chosen: &chosen,
        quiet,
        told_stop: !stays,
        stays,
        failed,
        say,
        changes,
        ending: &ending,
        is_broken: false,
    };
    let drawn = drive(&mut around, &desk, asks);
    let Around { mut retention, watch, failed, .. } = around;
    drawn.map_err(|error| terminal::broken(&error))?;
    drop(metrics);
    drop(page);
    if let Some(lost) = servers.as_mut().and_then(Servers::end) {
        output::message(&lost);
    }
    gate.close();
    drop(server);
    gate.finish(|plant| {
        if let Some(retention) = &mut retention {
            retention.close(&mut plant.cpu);
        }
        let count = plant.cpu.failed_statements().count;
        let failed = failed.map(|first| first.in_all(count)).or_else(|| Failed::of(&build, &plant.cpu));
        let time_us = plant.pace.time_us(gate.now_us()).min(plant.pace.end_us);
        let outcome = Outcome { scans: plant.scans, time_us, interrupted: ending.is_wanted(), stays };
        report(arguments, &build, &plant.cpu, &outcome, failed.as_ref(), retention.as_ref(), watch.as_ref())
    })
}

/// Makes the CPU of an example as this run has it.
fn prepare(engine: EngineArgument, overrides: Overrides, source: TimeSource, cycle: Option<Duration>) -> Prepare {
    Box::new(move |example| {
        let build = chosen::build(example, overrides)?;
        let settings = settings(&build, source);
        let cpu = controller::load(&build, engine.factory(StatusBits::Needed), settings);
        let facts = Facts::of(&build, cpu.program());
        let cycle_us = duration::micros(cycle_of(&build, cycle));
        Ok(Change { example, build, next: Next { cpu, facts, cycle_us } })
    })
}

/// What the CPU of a run is set to.
fn settings(build: &Build, time: TimeSource) -> Settings {
    Settings { time, date_and_time: if time == TimeSource::Real { now() } else { DateAndTime::DEFAULT }, ..controller::settings(build) }
}

/// From one scan to the next: as the command line says, else as the project does.
fn cycle_of(build: &Build, named: Option<Duration>) -> Duration {
    let project = &build.project.settings;
    named.or(project.cycle).unwrap_or(Duration::from_millis(10)).max(project.min_cycle.unwrap_or_default())
}

/// The clock of this computer from now on, in microseconds.
fn real_clock() -> Clock {
    let begin = Instant::now();
    Box::new(move || begin.elapsed().as_micros() as u64)
}

/// The time of day of this computer, UTC.
pub(crate) fn now() -> DateAndTime {
    let since_1970 = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    DateAndTime::from_ms_since_1970(since_1970.as_millis() as u64)
}

/// Scans until the run is over; meanwhile a screen asks, if there is one.
fn drive(around: &mut Around<'_>, desk: &Desk, asks: Option<Direct>) -> io::Result<()> {
    let ending = around.ending;
    let has_ended = AtomicBool::new(false);
    let is_over = || has_ended.load(Ordering::Relaxed);
    let is_over = &is_over;
    thread::scope(|scope| {
        let screen = asks.map(|asks| {
            // It is enough that one thread replays: with a control socket there is one already.
            let _ = thread::Builder::new().name("status".to_owned()).spawn_scoped(scope, || desk.replay(is_over));
            thread::Builder::new().name("screen".to_owned()).spawn_scoped(scope, move || show(asks, desk, ending, is_over))
        });
        Driver::new(&ending.gate, desk, around).go_on();
        has_ended.store(true, Ordering::Relaxed);
        match screen {
            // A panic of the thread was reported where it happened.
            Some(screen) => screen.and_then(|screen| screen.join().unwrap_or(Ok(()))),
            None => Ok(()),
        }
    })
}

/// How a run is ended from outside: Ctrl-C, a signal, the key of the screen.
struct Ending {
    request: StopRequest,
    gate: Arc<Gate>,
    /// How often it was asked for.
    presses: AtomicUsize,
}

impl Ending {
    /// Asks the CPU for STOP at its next safe point and ends the run; how often that was asked for before.
    fn end(&self) -> usize {
        let before = self.presses.fetch_add(1, Ordering::SeqCst);
        self.request.stop();
        self.gate.wake();
        before
    }

    /// Whether it was asked for.
    fn is_wanted(&self) -> bool {
        self.presses.load(Ordering::Relaxed) > 0
    }
}

/// From now on Ctrl-C ends the run; a second one ends the process.
fn watch_for_interrupt(ending: &Arc<Ending>) -> Result<(), Failure> {
    let ending = Arc::clone(ending);
    ctrlc::set_handler(move || {
        if ending.end() > 0 {
            terminal::give_back();
            std::process::exit(INTERRUPTED);
        }
    })
    .map_err(|error| Failure::usage(Problem::P7001, format!("Ctrl-C cannot be watched: {error}")))
}

/// What is seen of a run while it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shown {
    /// The screen.
    Screen,
    /// One line for each change, and messages.
    Changes,
    /// Messages only.
    Messages,
}

impl Shown {
    fn of(verb: Verb, arguments: &RunArguments) -> Self {
        match verb {
            Verb::Serve => Self::Messages,
            Verb::Run if arguments.json => Self::Messages,
            Verb::Run if arguments.plain || terminal::is_without_screen() => Self::Changes,
            Verb::Run if terminal::has_screen() => Self::Screen,
            Verb::Run => Self::Messages,
        }
    }
}

/// The screen, until the user leaves or the run is over; with it the run ends.
fn show(mut asks: Direct, desk: &Desk, ending: &Ending, is_over: &(dyn Fn() -> bool + Sync)) -> io::Result<()> {
    let note = |text: &str| {
        // A run that is over has no use for it.
        let _ = ending.gate.enter(|plant| desk.observed.note(plant, text));
    };
    let left = screen::show(&mut asks, &mut Screen::spoken(), Palette::wanted(), &screen::Around { is_over, note: &note });
    if !is_over() {
        ending.end();
    }
    left.map(drop)
}

/// How a run ended.
struct Outcome {
    scans: u64,
    time_us: u64,
    interrupted: bool,
    /// A STOP did not end it, and was said when it came.
    stays: bool,
}

/// `, cycle 10.02 ms (min 9.98 ms, max 10.40 ms)`; nothing before the second scan, when no cycle is complete.
fn cycle_text(cpu: &Cpu) -> String {
    let times = cpu.cycle_times();
    if times.max == 0 {
        return String::new();
    }
    let show = |us| duration::show(Duration::from_micros(us));
    format!(", cycle {} (min {}, max {})", show(times.last), show(times.min), show(times.max))
}

/// Says how it went.
fn report(
    arguments: &RunArguments,
    build: &Build,
    cpu: &Cpu,
    outcome: &Outcome,
    failed: Option<&Failed>,
    retention: Option<&Retention>,
    watch: Option<&Watch>,
) -> Result<Exit, Failure> {
    // A STOP that was asked for before Ctrl-C ended the run is no failure of the program.
    let stopped = cpu
        .stop_cause()
        .filter(|_| cpu.mode() == OperatingMode::Stop)
        .filter(|cause| !(outcome.interrupted && (outcome.stays || matches!(cause.event, STOP_BY_SWITCH | STOP_FROM_OUTSIDE))));
    // Ctrl-C itself sends the CPU to STOP: what counts is what it did before.
    let stopped_before = cpu.stop_cause().is_some_and(|cause| cause.event != STOP_BY_SWITCH);
    let mode =
        if stopped.is_some() || stopped_before && cpu.mode() == OperatingMode::Stop { OperatingMode::Stop } else { OperatingMode::Run };
    if arguments.json {
        let times = cpu.cycle_times();
        let ms = |us: u64| us as f64 / 1000.0;
        let mut object = json!({
            "mode": mode.to_string(), "scans": outcome.scans, "time_ms": ms(outcome.time_us), "interrupted": outcome.interrupted,
            "cycle_ms": { "last": ms(times.last), "min": ms(times.min), "max": ms(times.max) },
        });
        if let Some(retention) = retention {
            object["retain"] = retention.json();
        }
        if let Some(watch) = watch {
            object["online_changes"] = watch.changes.into();
        }
        if let Some(cause) = stopped {
            object["stop"] = controller::stop_json(cause);
        }
        if let Some(failed) = failed {
            object["failed_statements"] = failed.json();
        }
        if arguments.diagnostics.wanted() {
            object["diagnostic_buffer"] = failed::buffer_json(build, cpu);
        }
        output::print_json(&object, false)?;
    } else {
        let time = duration::show(Duration::from_micros(outcome.time_us));
        let how = if outcome.interrupted { "stopped by Ctrl-C after" } else { "ran for" };
        let scans = if outcome.scans == 1 { "1 scan".to_owned() } else { format!("{} scans", outcome.scans) };
        output::print(&format!("{mode}: {how} {time}, {scans}{}\n", cycle_text(cpu)))?;
        if let Some(failed) = failed {
            output::message(&format!("{}\n", failed.line()));
        }
    }
    match stopped {
        Some(_) if arguments.json => Ok(Exit::Stopped),
        Some(cause) => {
            output::message(&controller::stop_text(build, cause));
            let most = if arguments.diagnostics.wanted() { usize::MAX } else { ENTRIES_SHOWN };
            output::message(&failed::buffer_text(build, cpu, most));
            Ok(Exit::Stopped)
        }
        None => {
            if arguments.diagnostics.wanted() && !arguments.json {
                output::print(&failed::buffer_text(build, cpu, usize::MAX))?;
            }
            Ok(if arguments.strict.is_strict() && failed.is_some() { Exit::CheckFailed } else { Exit::Success })
        }
    }
}
