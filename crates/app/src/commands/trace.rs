//! `sieben trace FILE…`: records chosen values, one sample per scan, and draws or writes them.

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::{Args, ValueEnum};
use serde_json::{Map, Value, json};
use sieben_cpu::{Cpu, OperatingMode, Restart, StopCause};
use sieben_jit::StatusBits;
use sieben_model::problems::Problem;
use sieben_sim::scenario::{Happened, Scenario, ScenarioError};
use sieben_sim::timing_diagram::{self, Mark, Options, SVG_WIDTH, TEXT_WIDTH, WIDTHS};
use sieben_sim::trace::recorder::BEFORE_MAX;
use sieben_sim::trace::trigger::TriggerError;
use sieben_sim::trace::{Keep, Moment, Recorder, Store, Trace, TraceError, Trigger, csv, vcd};
use sieben_workspace::Refusal;
use sieben_workspace::controller;
use sieben_workspace::duration;
use sieben_workspace::failed::{Failed, Heard};
use sieben_workspace::finding::{Finding, Texts};
use sieben_workspace::names;
use sieben_workspace::project::Build;
use sieben_workspace::tracing::channels;
use sieben_workspace::tracing::scenario::{origin, rack, without_plant};

use crate::arguments::{FaultArguments, ProgramArguments};
use crate::duration::duration_argument;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::paths::{self, is_scenario};
use crate::schedule::ScheduleArguments;
use crate::tracing::file::{Disk, Spill};
use crate::tracing::output::{unreadable, unwritable, write};
use crate::tracing::scenario;
use crate::{language, output, report};

/// Record values over many scans and draw them as a timing diagram.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben trace lamp.awl --at 50ms I0.0=1 --for 1s              inputs and outputs, as a diagram\n  \
  sieben trace plant --channels Start,Motor,T1,DB1.speed --for 10s --svg motor.svg\n  \
  sieben trace plant dosing.scenario --vcd dosing.vcd          for GTKWave\n  \
  sieben trace plant --trigger 'Motor falls' --before 50 --after 20 --scans 100000\n  \
  sieben trace plant --for 1h --record hour.trace              keep it,\n  \
  sieben trace --from hour.trace --window 10min..11min         and look at it later\n\n\
Time is virtual, as with `sieben exec`: scan k begins at k x cycle. A sample is taken behind\n\
every scan; a value holds until the scan that changed it, and nothing is drawn between.\n\
Without --channels these are the inputs and outputs that the program uses. A scenario\n\
(FILE.scenario) brings its own inputs, times and expectations.\n\n\
Exit codes: 0 ok, 1 an expectation failed or the trigger did not come, 2 usage,\n\
3 does not compile, 4 the CPU went to STOP.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, a project folder, a scenario
    #[arg(required_unless_present = "from", value_name = "FILE")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Record these: addresses, symbols, T 1, T1.q, C 1, DB1.name, variables, registers [default: inputs and outputs]
    #[arg(long, value_name = "NAME,…", conflicts_with = "from")]
    channels: Vec<String>,
    #[command(flatten)]
    schedule: ScheduleArguments,
    #[command(flatten)]
    faults: FaultArguments,
    /// Run this scenario (also FILE.scenario among the files)
    #[arg(long, value_name = "FILE", conflicts_with = "from")]
    scenario: Option<PathBuf>,
    /// Keep only what is around this: `I0.0 rises`, `I0.0 falls`, `I0.0 changes`, `MW10 > 5`, `scan 500`
    #[arg(long, value_name = "CONDITION", conflicts_with = "from")]
    trigger: Option<String>,
    /// Scans to keep before the trigger [default: 50]
    #[arg(long, value_name = "N", requires = "trigger", value_parser = clap::value_parser!(u64).range(..=BEFORE_MAX))]
    before: Option<u64>,
    /// Scans to keep behind the trigger [default: 50]
    #[arg(long, value_name = "N", requires = "trigger")]
    after: Option<u64>,
    /// Keep only the last scans
    #[arg(long, value_name = "N", conflicts_with_all = ["trigger", "from"], value_parser = clap::value_parser!(u64).range(1..=BEFORE_MAX))]
    last: Option<u64>,
    /// Write the diagram to this file as SVG
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Write a Value Change Dump for GTKWave and other viewers (`-` prints it)
    #[arg(long, value_name = "FILE")]
    vcd: Option<PathBuf>,
    /// Write a table of the values (`-` prints it)
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Which scans get a row in the table
    #[arg(long, value_name = "WHICH", default_value = "all")]
    csv_every: CsvRows,
    /// Write the recording to this file, to be drawn later with --from
    #[arg(long, value_name = "FILE", conflicts_with = "from")]
    record: Option<PathBuf>,
    /// Draw this recording; with FILE, refuse one of another program
    #[arg(long, value_name = "RECORDING")]
    from: Option<PathBuf>,
    /// Show only this part: two times or two numbers of scans
    #[arg(long, value_name = "FROM..TO", value_parser = window_argument)]
    window: Option<Window>,
    /// Write out all values at this time
    #[arg(long, value_name = "T", value_parser = duration_argument)]
    cursor: Vec<Duration>,
    /// Draw text with the characters of ASCII only
    #[arg(long)]
    ascii: bool,
    /// Width in characters, or in pixels of the SVG [default: that of the terminal, 960]
    #[arg(long, value_name = "N", value_parser = width_argument)]
    width: Option<usize>,
    /// Which engine runs the program
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Print one JSON object per scan that changed something, and one about the trace
    #[arg(long)]
    json: bool,
}

/// Which scans get a row in the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum CsvRows {
    // Every scan.
    All,
    // Those that changed something.
    Changes,
}

/// A part of a trace, as a user says it.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Window {
    Scans(RangeInclusive<u64>),
    Times(RangeInclusive<u64>),
}

fn window_argument(text: &str) -> Result<Window, String> {
    let wanted = || format!("`{text}` is no part of a trace; write two times `1s..2s` or two numbers of scans `100..200`");
    let (from, to) = text.split_once("..").ok_or_else(wanted)?;
    let window = match (from.trim().parse(), to.trim().parse()) {
        (Ok(from), Ok(to)) => Window::Scans(from..=to),
        _ => {
            let us = |text: &str| duration_argument(text).map(|duration| duration.as_micros() as u64);
            Window::Times(us(from)?..=us(to)?)
        }
    };
    match &window {
        Window::Scans(range) | Window::Times(range) if range.is_empty() => Err(format!("`{text}` ends before it begins")),
        _ => Ok(window),
    }
}

fn width_argument(text: &str) -> Result<usize, String> {
    let (least, most) = WIDTHS.into_inner();
    text.parse().ok().filter(|width| WIDTHS.contains(width)).ok_or_else(|| format!("write a number from {least} to {most}"))
}

/// How a recorded run ended.
#[derive(Default)]
struct Outcome {
    /// Expectations that did not come true, each with the last scan before.
    failures: Vec<(ScenarioError, Option<Moment>)>,
    /// The file of the scenario.
    scenario: PathBuf,
    /// Why the CPU is in STOP, if nobody expected it to be.
    stop: Option<StopCause>,
    /// The trigger did not come.
    untriggered: bool,
    scans: u64,
    /// Statements that failed while the program went on.
    heard: Heard,
    failed: Option<Failed>,
}

/// Records and draws.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    paths::spare_sources([&arguments.svg, &arguments.vcd, &arguments.csv, &arguments.record].into_iter().flatten())?;
    let mut overrides = arguments.program.overrides()?;
    let (mut scenarios, paths): (Vec<PathBuf>, Vec<PathBuf>) = arguments.paths.iter().cloned().partition(|path| is_scenario(path));
    scenarios.extend(arguments.scenario.clone());
    if let Some(from) = &arguments.from {
        return draw(arguments, from, &paths);
    }
    let scenario = match scenario::only(&scenarios, &arguments.schedule)? {
        Ok(scenario) => scenario,
        Err(exit) => return Ok(exit),
    };
    let project = arguments.program.load(&paths)?;
    let schedule = arguments.schedule.schedule(&project.settings, SCANS_USUAL)?;
    overrides.cpu = overrides.cpu.or(scenario.as_ref().and_then(|(_, scenario)| scenario.cpu));
    let build = match super::or_report(project.compile(overrides, false), arguments.json) {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    if let Some((path, scenario)) = &scenario
        && let Some(refusal) = without_plant(&build, &path.display().to_string(), scenario)
    {
        return Err(refusal.into());
    }
    let loaded = controller::loaded(&build, arguments.engine.factory(StatusBits::All));
    let mut cpu = Cpu::new(loaded.clone(), controller::rack(&build), controller::settings(&build));
    arguments.faults.inject(&mut cpu)?;
    let recorder = recorder(arguments, &build, &cpu)?;
    let (trace, outcome) = match &scenario {
        Some((path, scenario)) => {
            let mut fresh = || {
                let mut cpu = Cpu::new(loaded.clone(), rack(&build, scenario), controller::settings(&build));
                // They were taken by the CPU above; a scenario with other modules has none that could fail.
                let _ = arguments.faults.inject(&mut cpu);
                cpu
            };
            let (trace, outcome) = follow(scenario, &build, recorder, &mut fresh)?;
            (trace, Outcome { scenario: (*path).clone(), ..outcome })
        }
        None => {
            let mut changes = arguments.schedule.changes(&build.project.symbols, &cpu)?;
            let mut recorder = recorder;
            let mut outcome = Outcome::default();
            cpu.restart(Restart::Warm);
            changes.begin(&mut cpu)?;
            for scan in 0..schedule.scans() {
                let now_us = schedule.begin_us(scan);
                changes.apply(&mut cpu, now_us)?;
                cpu.scan(now_us);
                outcome.heard.hear(&cpu);
                recorder.scan(&cpu, scan, now_us).map_err(|error| unwritable(&error))?;
                outcome.scans += 1;
                if cpu.mode() == OperatingMode::Stop || recorder.is_complete() {
                    break;
                }
            }
            outcome.stop = cpu.stop_cause().filter(|_| cpu.mode() == OperatingMode::Stop).cloned();
            outcome.untriggered = !recorder.was_triggered();
            (recorder.finish().map_err(|error| unwritable(&error))?, outcome)
        }
    };
    let outcome = Outcome { failed: outcome.heard.failed(&build), ..outcome };
    show(arguments, &trace, &outcome)?;
    told(arguments, &build, &outcome)
}

/// Scans that are run when nobody says how many.
const SCANS_USUAL: u64 = 100;
/// Scans around a trigger when nobody says how many.
const AROUND_USUAL: u64 = 50;

fn recorder(arguments: &Arguments, build: &Build, cpu: &Cpu) -> Result<Recorder, Failure> {
    let channels = channels::chosen(&arguments.channels, build, cpu)?;
    let keep = match (&arguments.trigger, arguments.last) {
        (Some(text), _) => {
            let trigger = trigger(text, build, cpu)?;
            let usual = |scans: Option<u64>| scans.unwrap_or(AROUND_USUAL);
            Keep::Around(trigger, usual(arguments.before), usual(arguments.after))
        }
        (None, Some(scans)) => Keep::Last(scans),
        (None, None) => Keep::All,
    };
    let store: Box<dyn Store> = match &arguments.record {
        Some(path) => Box::new(Disk::create(path)?),
        None => Box::new(Spill::default()),
    };
    Recorder::new(channels, keep, origin(build), store).map_err(|error| unwritable(&error))
}

fn trigger(text: &str, build: &Build, cpu: &Cpu) -> Result<Trigger, Failure> {
    let symbols = &build.project.symbols;
    let trigger = Trigger::parse(text, symbols, cpu.program()).map_err(|error| match error {
        TriggerError::Form(message) => Refusal::new(Problem::P7030, message),
        // Says it again with the nearest symbol.
        TriggerError::Name(name, error) => match names::resolve(&name, symbols, cpu) {
            Err(refusal) => refusal,
            Ok(_) => Refusal::new(Problem::P7003, error.to_string()),
        },
        TriggerError::Value(error) => Refusal::new(Problem::P7004, error.to_string()),
    })?;
    if let Some(name) = trigger.name() {
        names::resolve(name.text(), symbols, cpu)?;
    }
    Ok(trigger)
}

/// Runs a scenario and records it. Rows of a table begin at time 0 each; here one stands a cycle behind the other.
fn follow(scenario: &Scenario, build: &Build, mut recorder: Recorder, fresh: &mut dyn FnMut() -> Cpu) -> Result<(Trace, Outcome), Failure> {
    let mut outcome = Outcome::default();
    let (mut begin_us, mut last): (u64, Option<Moment>) = (0, None);
    let mut failed: Option<TraceError> = None;
    scenario.run_watched(&build.project.symbols, fresh, &mut |happened| match happened {
        Happened::Began { .. } => {
            if let Some(last) = last {
                begin_us = last.time_us.saturating_add(scenario.cycle_us());
            }
        }
        Happened::Scan { cpu, time_us, .. } => {
            let moment = Moment { scan: outcome.scans, time_us: begin_us.saturating_add(time_us) };
            outcome.scans += 1;
            outcome.heard.hear(cpu);
            last = Some(moment);
            if failed.is_none() {
                failed = recorder.scan(cpu, moment.scan, moment.time_us).err();
            }
        }
        Happened::Failed(error) => outcome.failures.push((error.clone(), last)),
        Happened::Did(_) | Happened::Due { .. } | Happened::Differs(_) => {}
    });
    if let Some(error) = failed {
        return Err(unwritable(&error));
    }
    outcome.untriggered = !recorder.was_triggered();
    Ok((recorder.finish().map_err(|error| unwritable(&error))?, outcome))
}

/// Draws a recording.
fn draw(arguments: &Arguments, from: &Path, paths: &[PathBuf]) -> Result<Exit, Failure> {
    if !arguments.schedule.is_empty() || arguments.paths.iter().any(|path| is_scenario(path)) {
        return Err(Failure::usage(Problem::P7001, "`--from` draws what was recorded, and runs nothing"));
    }
    let trace = Trace::open(Box::new(Disk::open(from)?)).map_err(|error| {
        let failure = unreadable(&error);
        Failure::usage(failure.refusal.problem, format!("`{}`: {}", from.display(), failure.refusal.message))
    })?;
    if !paths.is_empty() {
        let build = match super::or_report(arguments.program.load(paths)?.compile(arguments.program.overrides()?, false), arguments.json) {
            Ok(build) => build,
            Err(exit) => return Ok(exit),
        };
        let (was, is) = (trace.origin(), origin(&build));
        if was.program != is.program {
            let message = format!("`{}` was recorded with another program than `{}`: `{}`", from.display(), is.title, was.title);
            return Err(Failure::usage(Problem::P6264, message));
        }
    }
    if !trace.is_whole() {
        let message = format!("`{}` was cut off: {} scans are whole", from.display(), trace.summary().scans);
        report::print(&[Finding::file(Problem::P6263, from.to_string_lossy(), message)], &Texts::default(), false);
    }
    show(arguments, &trace, &Outcome::default())?;
    Ok(Exit::Success)
}

/// Writes what was asked for; without anything asked for, prints the diagram.
fn show(arguments: &Arguments, trace: &Trace, outcome: &Outcome) -> Result<(), Failure> {
    if trace.summary().scans == 0 {
        return Err(Failure::usage(Problem::P7032, "no scan was recorded").help("a scenario needs at least one line with `scan`"));
    }
    let range = window(arguments, trace)?.unwrap_or_else(|| trace.all());
    let rows = if arguments.csv_every == CsvRows::All { csv::Rows::All } else { csv::Rows::Changes };
    let mut written = Vec::new();
    let options = |width: usize| options(arguments, trace, outcome, width);
    if let Some(path) = &arguments.vcd {
        write(path, trace, &|trace, out| vcd::write(trace, &range, out))?;
        written.push(path);
    }
    if let Some(path) = &arguments.csv {
        write(path, trace, &|trace, out| csv::write(trace, &range, rows, out))?;
        written.push(path);
    }
    if let Some(path) = &arguments.svg {
        let options = options(arguments.width.unwrap_or(SVG_WIDTH))?;
        write(path, trace, &|trace, out| Ok(out.write_str(&timing_diagram::svg(trace, &options)?)?))?;
        written.push(path);
    }
    if arguments.json {
        return print_json(trace, &range, outcome);
    }
    written.extend(&arguments.record);
    // Somebody who wrote files and sees a failure wants to see where.
    if written.is_empty() || !outcome.failures.is_empty() && !written.iter().any(|path| path.as_os_str() == "-") {
        let options = options(arguments.width.unwrap_or_else(terminal_width))?;
        output::print(&timing_diagram::text(trace, &options).map_err(|error| unreadable(&error))?)?;
    }
    if !written.is_empty() {
        let files: Vec<String> =
            written.iter().filter(|path| path.as_os_str() != "-").map(|path| format!("`{}`", path.display())).collect();
        let (scans, channels) = (trace.summary().scans, trace.channels().len());
        if !files.is_empty() {
            output::message(&format!("{scans} scans of {channels} channels: {}\n", files.join(", ")));
        }
    }
    Ok(())
}

/// Columns of the terminal, or the usual number where there is none.
fn terminal_width() -> usize {
    use std::io::IsTerminal;
    let columns =
        std::io::stdout().is_terminal().then(crossterm::terminal::size).and_then(Result::ok).map(|(columns, _)| usize::from(columns));
    columns.map_or(TEXT_WIDTH, |columns| columns.clamp(*WIDTHS.start(), *WIDTHS.end()))
}

fn options(arguments: &Arguments, trace: &Trace, outcome: &Outcome, width: usize) -> Result<Options, Failure> {
    let (first, last) = (trace.summary().first, trace.summary().last);
    let cursors_us: Vec<u64> = arguments.cursor.iter().map(|time| time.as_micros() as u64).collect();
    if let Some(cursor) = cursors_us.iter().find(|&&cursor| !(first.time_us..=last.time_us).contains(&cursor)) {
        let message = format!(
            "the trace goes from {} to {} and has no {}",
            milliseconds(first.time_us),
            milliseconds(last.time_us),
            milliseconds(*cursor)
        );
        return Err(Failure::usage(Problem::P7033, message));
    }
    let failed = outcome
        .failures
        .iter()
        .filter_map(|(error, moment)| Some(Mark { moment: (*moment)?, label: format!("line {}: {}", error.line, error.message) }));
    let stopped = outcome.stop.iter().map(|cause| Mark { moment: last, label: format!("STOP: {}", cause.text) });
    let marks: Vec<Mark> = failed.chain(stopped).take(MARKS_MAX).collect();
    let window = match window(arguments, trace)? {
        None if trace.summary().scans > AROUND_FAILURE * 2 && !outcome.failures.is_empty() => {
            let scans = || outcome.failures.iter().filter_map(|(_, moment)| moment.map(|moment| moment.scan));
            let (begin, end) = (scans().min().unwrap_or(first.scan), scans().max().unwrap_or(last.scan));
            let (begin, end) =
                (begin.saturating_sub(AROUND_FAILURE).max(first.scan), end.saturating_add(AROUND_FAILURE / 4).min(last.scan));
            (begin <= end).then_some(begin..=end)
        }
        window => window,
    };
    Ok(Options { width, ascii: arguments.ascii, window, marks, cursors_us })
}

/// Scans that are shown before a failed expectation.
const AROUND_FAILURE: u64 = 60;
/// Most moments that are pointed at: each takes a line.
const MARKS_MAX: usize = 10;

/// The scans that the user wants to see.
fn window(arguments: &Arguments, trace: &Trace) -> Result<Option<RangeInclusive<u64>>, Failure> {
    let Some(window) = &arguments.window else { return Ok(None) };
    let (first, last) = (trace.summary().first, trace.summary().last);
    let missing = |what: String| Failure::usage(Problem::P7033, what);
    match window {
        Window::Scans(scans) => {
            let part = first.scan.max(*scans.start())..=last.scan.min(*scans.end());
            let message =
                || format!("the trace has the scans {} to {}, and none of {} to {}", first.scan, last.scan, scans.start(), scans.end());
            if part.is_empty() { Err(missing(message())) } else { Ok(Some(part)) }
        }
        Window::Times(times) => {
            let mut part: Option<(u64, u64)> = None;
            let seen = trace.visit(&trace.all(), &mut |scans| {
                for moment in scans.moments().filter(|moment| times.contains(&moment.time_us)) {
                    part = Some((part.map_or(moment.scan, |(first, _)| first), moment.scan));
                }
                Ok(())
            });
            seen.map_err(|error| unreadable(&error))?;
            let (from, to) = (milliseconds(*times.start()), milliseconds(*times.end()));
            let message = || {
                let (first, last) = (milliseconds(first.time_us), milliseconds(last.time_us));
                format!("the trace goes from {first} to {last}, and has no scan from {from} to {to}")
            };
            part.map(|(first, last)| Some(first..=last)).ok_or_else(|| missing(message()))
        }
    }
}

fn milliseconds(us: u64) -> String {
    format!("{} ms", duration::milliseconds(us))
}

/// One object per scan that changed something, with the values that it changed, and one about the trace.
fn print_json(trace: &Trace, range: &RangeInclusive<u64>, outcome: &Outcome) -> Result<(), Failure> {
    let time = |moment: Moment| duration::milliseconds(moment.time_us);
    write(Path::new("-"), trace, &|trace, out| {
        trace.visit(range, &mut |scans| {
            if scans.changed.is_empty() {
                return Ok(());
            }
            let values: Map<String, Value> = scans
                .changed
                .iter()
                .map(|&index| {
                    let channel = &trace.channels()[index];
                    (channel.name.clone(), scans.values[index].shown(&channel.kind).map_or(Value::Null, |shown| names::shown_json(&shown)))
                })
                .collect();
            let line = json!({ "scan": scans.first.scan, "time_ms": time(scans.first), "values": values });
            Ok(writeln!(out, "{line}")?)
        })
    })?;
    let summary = trace.summary();
    let channels: Vec<Value> = trace
        .channels()
        .iter()
        .zip(&summary.changes)
        .map(|(channel, changes)| json!({ "name": channel.name, "kind": channel.kind.word(), "changes": changes }))
        .collect();
    let failures: Vec<Value> = outcome
        .failures
        .iter()
        .map(|(error, moment)| {
            json!({ "line": error.line, "message": error.message, "scan": moment.map(|moment| moment.scan), "time_ms": moment.map(time) })
        })
        .collect();
    let trigger = trace.trigger().map(|moment| json!({ "scan": moment.scan, "time_ms": time(moment) }));
    let mut object = json!({
        "program": trace.origin().title, "cpu": trace.origin().cpu, "scans": summary.scans,
        "first": { "scan": summary.first.scan, "time_ms": time(summary.first) },
        "last": { "scan": summary.last.scan, "time_ms": time(summary.last) },
        "trigger": trigger, "whole": trace.is_whole(), "channels": channels, "failures": failures,
    });
    if let Some(cause) = &outcome.stop {
        object["stop"] = controller::stop_json(cause);
    }
    if let Some(failed) = &outcome.failed {
        object["failed_statements"] = failed.json();
    }
    output::print_json(&json!({ "trace": object }), false)
}

/// Says what went wrong, and finds the exit code.
fn told(arguments: &Arguments, build: &Build, outcome: &Outcome) -> Result<Exit, Failure> {
    // The JSON object has them.
    for (error, _) in outcome.failures.iter().filter(|_| !arguments.json) {
        let message = format!("{}:{}: {}", outcome.scenario.display(), error.line, error.message);
        output::styled(&Failure::usage(Problem::P6261, message).render(output::colour(), language::spoken()));
    }
    if let Some(failed) = outcome.failed.as_ref().filter(|_| !arguments.json) {
        output::message(&format!("{}\n", failed.line()));
    }
    if let Some(cause) = &outcome.stop {
        if !arguments.json {
            output::message(&controller::stop_text(build, cause));
        }
        return Ok(Exit::Stopped);
    }
    if outcome.untriggered {
        let (trigger, scans) = (arguments.trigger.as_deref().unwrap_or_default(), outcome.scans);
        let message = format!("`{trigger}` did not come in {scans} scans; shown are the last of them");
        return Err(Failure { exit: Exit::CheckFailed, refusal: Refusal::new(Problem::P7031, message) });
    }
    Ok(if outcome.failures.is_empty() { Exit::Success } else { Exit::CheckFailed })
}
