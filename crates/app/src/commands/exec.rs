//! `sieben exec FILE…`: a few scans in virtual time, then values.

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use serde_json::{Value, json};
use sieben_cpu::{Cpu, OperatingMode, Restart};
use sieben_engine::Tracer;
use sieben_jit::StatusBits;
use sieben_model::problems::Problem;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;

use crate::arguments::{EngineArgument, ProgramArguments, duration_argument};
use crate::failure::{Exit, Failure};
use crate::local_check::LocalCheck;
use crate::names::{self, Assignment};
use crate::report::Finding;
use crate::{controller, duration, output, project};

/// Run a few scans in virtual time and print values.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben exec add.awl --set MW0=2 --set MW2=3 --show MW4\n  \
  sieben exec lamp.awl --set I0.0=1 --scans 3 --every --show Q0.0,T1\n  \
  sieben exec delay.awl --at 100ms I0.0=1 --for 3s --show Q0.0 --json\n  \
  sieben exec plant --set Start=1 --show Motor,DB1.speed\n\n\
Time is virtual: scan k begins at k x cycle, the first at 0. A file of bare\n\
statements is the body of OB 1. A register gets what `L` would load\n\
(`ACCU1=-1` is 16#0000_FFFF), an address or variable the number in its own\n\
width. STW is nine characters: BR CC1 CC0 OV OS OR STA RLO /FC.\n\n\
Exit codes: 0 ok, 1 --check-temp found something, 2 usage, 3 does not compile, 4 the CPU went to STOP.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, or a project folder
    #[arg(required = true, value_name = "FILE")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Set before the first scan: an address, a symbol, DB1.name, ACCU1 to ACCU4, AR1, AR2 or STW
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Set at a time, seen by the next scan
    #[arg(long, value_names = ["T", "NAME=VALUE"], num_args = 2)]
    at: Vec<String>,
    /// Run so many scans [default: 1]
    #[arg(long, value_name = "N", conflicts_with_all = ["duration", "scan_at"], value_parser = clap::value_parser!(u64).range(1..))]
    scans: Option<u64>,
    /// Run all scans that begin before this time
    #[arg(long = "for", value_name = "DURATION", id = "duration", conflicts_with = "scan_at", allow_hyphen_values = true, value_parser = duration_argument)]
    duration: Option<Duration>,
    /// Time from one scan to the next [default: the project's, else 10ms]
    #[arg(long, value_name = "DURATION", conflicts_with = "scan_at", allow_hyphen_values = true, value_parser = duration_argument)]
    cycle: Option<Duration>,
    /// Scan exactly at these times instead of every cycle
    #[arg(long, value_name = "T1,T2,…", value_delimiter = ',', allow_hyphen_values = true, value_parser = duration_argument)]
    scan_at: Vec<Duration>,
    /// Print these: as --set, and T 1, C 1, T1.q (status bit), STW.RLO
    #[arg(long, value_name = "NAME,…")]
    show: Vec<String>,
    /// Print after each scan, not only after the last
    #[arg(long)]
    every: bool,
    /// Which engine runs the program
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Watch the local data: report every temporary variable that is read before it is written (exit code 1)
    #[arg(long)]
    check_temp: bool,
    /// Print one JSON object per printed scan
    #[arg(long)]
    json: bool,
}

/// When a scan begins, by its number.
enum Schedule {
    Cyclic { cycle: Duration, scans: u64 },
    At(Vec<Duration>),
}

impl Schedule {
    fn len(&self) -> u64 {
        match self {
            Self::Cyclic { scans, .. } => *scans,
            Self::At(times) => times.len() as u64,
        }
    }
    /// Microseconds at the beginning of a scan.
    fn begin_us(&self, scan: u64) -> u64 {
        let us = match self {
            Self::Cyclic { cycle, .. } => cycle.as_micros().saturating_mul(u128::from(scan)),
            Self::At(times) => times[scan as usize].as_micros(),
        };
        u64::try_from(us).unwrap_or(u64::MAX)
    }
}

/// Runs the scans and prints the values.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let overrides = arguments.program.overrides()?;
    let project = arguments.program.load(&arguments.paths)?;
    let schedule = schedule(arguments, project.settings.cycle, project.settings.min_cycle.unwrap_or_default())?;
    let build = match project.compile(overrides, false).or_report(arguments.json) {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let mut cpu = controller::load(&build, arguments.engine, StatusBits::All, controller::settings(&build));
    let symbols = &build.project.symbols;
    let shown = names::resolve_lists(&arguments.show, symbols, &cpu)?;
    let set = arguments.set.iter().map(|text| Assignment::parse(text, symbols, &cpu)).collect::<Result<Vec<_>, _>>()?;
    let mut at = timed(&arguments.at, symbols, &cpu)?.into_iter().peekable();

    let mut check = arguments.check_temp.then(LocalCheck::default);
    // A watched run is interpreted, whatever the engine.
    cpu.restart_with(Restart::Warm, &mut || 0, check.as_mut().map(|check| check as &mut dyn Tracer));
    set.iter().try_for_each(|assignment| assignment.apply(&mut cpu))?;
    let count = schedule.len();
    for scan in 0..count {
        let now_us = schedule.begin_us(scan);
        while let Some((_, assignment)) = at.next_if(|(time, _)| time.as_micros() <= u128::from(now_us)) {
            assignment.apply(&mut cpu)?;
        }
        cpu.scan_with(&mut || now_us, check.as_mut().map(|check| check as &mut dyn Tracer));
        let stopped = cpu.mode() == OperatingMode::Stop;
        if arguments.every || stopped || scan + 1 == count {
            print_scan(arguments, &cpu, &shown, scan, now_us)?;
        }
        if stopped {
            break;
        }
    }
    let findings: Vec<Finding> = check.iter().flat_map(|check| check.findings(&build)).map(Finding::program).collect();
    if !findings.is_empty() {
        project::print_findings(&findings, &build.project.texts, arguments.json);
    }
    match cpu.stop_cause() {
        Some(cause) if cpu.mode() == OperatingMode::Stop => {
            if !arguments.json {
                output::message(&controller::stop_text(&build, cause));
            }
            Ok(Exit::Stopped)
        }
        _ if !findings.is_empty() => Ok(Exit::CheckFailed),
        _ => {
            if shown.is_empty() && !arguments.json && !arguments.check_temp {
                output::message("Nothing was asked for: `--show MW0,Q0.0` prints values.\n");
            }
            Ok(Exit::Success)
        }
    }
}

fn schedule(arguments: &Arguments, project_cycle: Option<Duration>, min_cycle: Duration) -> Result<Schedule, Failure> {
    if !arguments.scan_at.is_empty() {
        if let Some(pair) = arguments.scan_at.windows(2).find(|pair| pair[1] < pair[0]) {
            let (late, early) = (duration::show(pair[0]), duration::show(pair[1]));
            return Err(Failure::usage(
                Problem::P7009,
                format!("time does not run backwards: {early} stands behind {late} in `--scan-at`"),
            ));
        }
        return Ok(Schedule::At(arguments.scan_at.clone()));
    }
    let project_cycle = project_cycle.filter(|cycle| !cycle.is_zero());
    let cycle = arguments.cycle.or(project_cycle).unwrap_or(Duration::from_millis(10)).max(min_cycle);
    let scans = match arguments.duration {
        None => arguments.scans.unwrap_or(1),
        Some(_) if cycle.is_zero() => {
            return Err(Failure::usage(Problem::P7009, "with a cycle of 0 virtual time stands still, and `--for` never ends"));
        }
        Some(duration) => u64::try_from(duration.as_micros().div_ceil(cycle.as_micros())).unwrap_or(u64::MAX).max(1),
    };
    Ok(Schedule::Cyclic { cycle, scans })
}

/// The changes of `--at` in the order of their times; those of the same time as they were written.
fn timed(words: &[String], symbols: &SymbolTable, cpu: &Cpu) -> Result<Vec<(Duration, Assignment)>, Failure> {
    let mut timed = Vec::new();
    for pair in words.chunks_exact(2) {
        let time = sieben_sim::duration::parse(&pair[0]).map_err(|message| Failure::usage(Problem::P7005, message))?;
        let assignment = Assignment::parse(&pair[1], symbols, cpu)?;
        if assignment.name.is_register() {
            return Err(
                Failure::usage(Problem::P7003, format!("`{}`: a register can only be set for the first scan", pair[1])).help("use `--set`")
            );
        }
        timed.push((time, assignment));
    }
    timed.sort_by_key(|(time, _)| *time);
    Ok(timed)
}

/// Longest name whose column is lined up.
const WIDTH_MAX: usize = 160;

fn print_scan(arguments: &Arguments, cpu: &Cpu, shown: &[Name], scan: u64, now_us: u64) -> Result<(), Failure> {
    if arguments.json {
        return output::print_json(&scan_json(cpu, shown, scan, now_us), false);
    }
    let mut text = String::new();
    if arguments.every || shown.is_empty() {
        text.push_str(&format!("scan {scan} at {} ms: {}\n", milliseconds(now_us), cpu.mode()));
    }
    let indent = if arguments.every { "  " } else { "" };
    let width = shown.iter().map(|name| name.text().chars().count()).max().unwrap_or(0).min(WIDTH_MAX);
    for name in shown {
        text.push_str(&format!("{indent}{:<width$} = {}\n", name.text(), names::text(name, cpu)));
    }
    output::print(&text)
}

fn scan_json(cpu: &Cpu, shown: &[Name], scan: u64, now_us: u64) -> Value {
    let values: serde_json::Map<String, Value> = shown.iter().map(|name| (name.text().to_owned(), names::to_json(name, cpu))).collect();
    let mut object = json!({ "scan": scan, "time_ms": milliseconds(now_us), "values": values, "mode": cpu.mode().to_string() });
    if let Some(cause) = cpu.stop_cause().filter(|_| cpu.mode() == OperatingMode::Stop) {
        object["stop"] = controller::stop_json(cause);
    }
    object
}

/// Whole milliseconds as an integer, others with their fraction.
fn milliseconds(us: u64) -> Value {
    if us.is_multiple_of(1000) { json!(us / 1000) } else { json!(us as f64 / 1000.0) }
}
