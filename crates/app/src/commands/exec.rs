//! `sieben exec FILE…`: a few scans in virtual time, then values.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};
use sieben_cpu::{Cpu, OperatingMode, Restart};
use sieben_engine::{FaultPlace, LocalAccess, Machine, StatementEvent, Tracer};
use sieben_jit::StatusBits;
use sieben_model::address::Operand;
use sieben_model::mnemonics::Mnemonics;
use sieben_sim::names::Name;
use sieben_sim::trace::Moment;
use sieben_workspace::controller;
use sieben_workspace::duration;
use sieben_workspace::failed::{self, Failed};
use sieben_workspace::finding::Finding;
use sieben_workspace::local_check::LocalCheck;
use sieben_workspace::names;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

use crate::arguments::{DiagnosticsArgument, FaultArguments, ProgramArguments, StrictArgument};
use crate::diagrams::{Diagrams, Form, LastMoment};
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::output;
use crate::report;
use crate::schedule::ScheduleArguments;

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
Exit codes: 0 ok, 1 --check-temp found something or a statement failed (--strict), 2 usage, 3 does not compile, 4 the CPU went to STOP.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, or a project folder
    #[arg(required = true, value_name = "FILE")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    #[command(flatten)]
    schedule: ScheduleArguments,
    #[command(flatten)]
    faults: FaultArguments,
    /// Print these: as --set, and T 1, C 1, T1.q (status bit), STW.RLO; in a format with MD20:REAL
    #[arg(long, value_name = "NAME,…")]
    show: Vec<String>,
    /// Print all names that have a value: symbols, variables, fields of data blocks
    #[arg(long)]
    show_all: bool,
    /// List all names that --show knows, with what they are, and run nothing
    #[arg(long, conflicts_with_all = ["show", "show_all"])]
    list_names: bool,
    /// Print after each scan, not only after the last
    #[arg(long)]
    every: bool,
    /// Which engine runs the program
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Watch the local data: report every temporary variable that is read before it is written (exit code 1)
    #[arg(long)]
    check_temp: bool,
    /// Draw a network with its power flow and values at the end of the last scan; the ending says SVG or text
    #[arg(long, value_name = "FILE.svg", requires = "network")]
    status: Option<PathBuf>,
    /// The network that --status draws: `FC1/2`, `Dosing/3`
    #[arg(long, value_name = "BLOCK/N", requires = "status")]
    network: Option<String>,
    /// Draw --status as this
    #[arg(long = "as", value_name = "FORM", default_value = "lad", requires = "status")]
    form: Form,
    #[command(flatten)]
    strict: StrictArgument,
    #[command(flatten)]
    diagnostics: DiagnosticsArgument,
    /// Print one JSON object per printed scan
    #[arg(long)]
    json: bool,
}

/// Runs the scans and prints the values.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let overrides = arguments.strict.overrides(arguments.program.overrides()?);
    let project = arguments.program.load(&arguments.paths)?;
    let schedule = arguments.schedule.schedule(&project.settings, 1)?;
    let build = match super::or_report(project.compile(overrides, false), arguments.json) {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let mut cpu = controller::load(&build, arguments.engine.factory(StatusBits::All), controller::settings(&build));
    arguments.faults.inject(&mut cpu)?;
    let symbols = &build.project.symbols;
    let mut shown: Vec<Asked> = names::resolve_lists(&arguments.show, symbols, &cpu)?.into_iter().map(Asked::by_name).collect();
    if arguments.list_names || arguments.show_all {
        let all = names::all(symbols, &cpu);
        if arguments.list_names {
            return list(&all, Places::new(&build).mnemonics, arguments.json).map(|()| Exit::Success);
        }
        shown.extend(all.into_iter().map(|name| Asked { name, how: How::Readable }));
    }
    let mut changes = arguments.schedule.changes(symbols, &cpu)?;

    let places = Places::new(&build);
    let diagrams = arguments.network.is_some().then(|| Diagrams::new(&build, &places));
    let mut moment = match (&diagrams, &arguments.status, &arguments.network) {
        (Some(diagrams), Some(file), Some(network)) => Some(LastMoment::new(diagrams, network, arguments.form, file)?),
        _ => None,
    };

    let mut check = arguments.check_temp.then(LocalCheck::default);
    // A watched run is interpreted, whatever the engine.
    cpu.restart_with(Restart::Warm, &mut || 0, check.as_mut().map(|check| check as &mut dyn Tracer));
    changes.begin(&mut cpu)?;
    let count = schedule.scans();
    for scan in 0..count {
        let now_us = schedule.begin_us(scan);
        changes.apply(&mut cpu, now_us)?;
        if let Some(moment) = &mut moment {
            moment.begin();
        }
        let mut tracer = Both { check: check.as_mut(), moment: moment.as_mut() };
        let is_traced = tracer.is_wanted();
        cpu.scan_with(&mut || now_us, is_traced.then_some(&mut tracer as &mut dyn Tracer));
        let stopped = cpu.mode() == OperatingMode::Stop;
        let is_last = stopped || scan + 1 == count;
        // A network that is drawn says what there is to say.
        if arguments.every || is_last && (arguments.status.is_none() || arguments.json || !shown.is_empty()) {
            print_scan(arguments, &build, &cpu, &shown, Moment { scan, time_us: now_us })?;
        }
        if stopped {
            break;
        }
    }
    if let Some(moment) = &moment {
        moment.write(&cpu)?;
    }
    let findings: Vec<Finding> = check.iter().flat_map(|check| check.findings(&build)).map(Finding::program).collect();
    if !findings.is_empty() {
        report::print(&findings, &build.project.texts, arguments.json);
    }
    let failed = Failed::of(&build, &cpu);
    if !arguments.json {
        if let Some(failed) = &failed {
            output::message(&format!("{}\n", failed.line()));
        }
        if arguments.diagnostics.wanted() {
            output::print(&failed::buffer_text(&build, &cpu, usize::MAX))?;
        }
    }
    match cpu.stop_cause() {
        Some(cause) if cpu.mode() == OperatingMode::Stop => {
            if !arguments.json {
                output::message(&controller::stop_text(&build, cause));
            }
            Ok(Exit::Stopped)
        }
        _ if !findings.is_empty() || arguments.strict.is_strict() && failed.is_some() => Ok(Exit::CheckFailed),
        _ => {
            if shown.is_empty() && !arguments.json && arguments.status.is_none() && !arguments.check_temp && !arguments.diagnostics.wanted()
            {
                output::message("Nothing was asked for: `--show MW0,Q0.0` prints values.\n");
            }
            Ok(Exit::Success)
        }
    }
}

/// A value that is printed.
struct Asked {
    name: Name,
    how: How,
}

/// How a value is printed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum How {
    /// As scenarios write it, so that scripts can compare it.
    Plain,
    /// As people read it.
    Readable,
}

impl Asked {
    fn by_name(name: Name) -> Self {
        Self { name, how: How::Plain }
    }
}

/// Prints names with what they are.
fn list(all: &[Name], mnemonics: Mnemonics, json: bool) -> Result<(), Failure> {
    let address = |name: &Name| name.operand().map(|operand| operand.spell(mnemonics));
    let what = |name: &Name| match name.operand() {
        Some(Operand::Timer(_)) => "TIMER".to_owned(),
        Some(Operand::Counter(_)) => "COUNTER".to_owned(),
        _ => name.kind().type_word().unwrap_or_default(),
    };
    if json {
        let one = |name: &Name| json!({ "name": name.text(), "address": address(name), "type": what(name) });
        return output::print_json(&json!({ "names": all.iter().map(one).collect::<Vec<_>>() }), false);
    }
    if all.is_empty() {
        output::message("The program has no symbols, variables or data blocks; addresses such as `MW10` can be shown all the same.\n");
    }
    let rows: Vec<[String; 3]> = all.iter().map(|name| [name.text().to_owned(), what(name), address(name).unwrap_or_default()]).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0).min(WIDTH_MAX);
    let (names, types) = (width(0), width(1));
    let line = |[name, what, address]: &[String; 3]| format!("{name:<names$}  {what:<types$}  {address}").trim_end().to_owned() + "\n";
    output::print(&rows.iter().map(line).collect::<String>())
}

/// The two that may watch a run.
struct Both<'a, 'd> {
    check: Option<&'a mut LocalCheck>,
    moment: Option<&'a mut LastMoment<'d>>,
}

impl Both<'_, '_> {
    /// Whether one of them does.
    fn is_wanted(&self) -> bool {
        self.check.is_some() || self.moment.is_some()
    }
}

impl Tracer for Both<'_, '_> {
    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        if let Some(check) = &mut self.check {
            check.statement(machine, event);
        }
        if let Some(moment) = &mut self.moment {
            moment.note(event);
        }
    }

    fn local_data(&mut self, machine: &Machine, place: FaultPlace, access: LocalAccess) {
        if let Some(check) = &mut self.check {
            check.local_data(machine, place, access);
        }
    }
}

/// Longest name whose column is lined up.
const WIDTH_MAX: usize = 160;

fn print_scan(arguments: &Arguments, build: &Build, cpu: &Cpu, shown: &[Asked], moment: Moment) -> Result<(), Failure> {
    if arguments.json {
        let mut object = scan_json(cpu, shown, moment);
        if let Some(failed) = Failed::of(build, cpu) {
            object["failed_statements"] = failed.json();
        }
        if arguments.diagnostics.wanted() {
            object["diagnostic_buffer"] = failed::buffer_json(build, cpu);
        }
        return output::print_json(&object, false);
    }
    let mut text = String::new();
    if arguments.every || shown.is_empty() {
        text.push_str(&format!("{moment}: {}\n", cpu.mode()));
    }
    let indent = if arguments.every { "  " } else { "" };
    let width = shown.iter().map(|asked| asked.name.text().chars().count()).max().unwrap_or(0).min(WIDTH_MAX);
    for Asked { name, how } in shown {
        let value = match how {
            How::Plain => names::text(name, cpu),
            How::Readable => names::readable(name, cpu),
        };
        text.push_str(&format!("{indent}{:<width$} = {value}\n", name.text()));
        for line in names::details(name, cpu) {
            text.push_str(&format!("{indent}{:<width$}   {line}\n", ""));
        }
    }
    output::print(&text)
}

fn scan_json(cpu: &Cpu, shown: &[Asked], Moment { scan, time_us }: Moment) -> Value {
    let values: serde_json::Map<String, Value> =
        shown.iter().map(|asked| (asked.name.text().to_owned(), names::to_json(&asked.name, cpu))).collect();
    let mut object = json!({ "scan": scan, "time_ms": duration::milliseconds(time_us), "values": values, "mode": cpu.mode().to_string() });
    if let Some(cause) = cpu.stop_cause().filter(|_| cpu.mode() == OperatingMode::Stop) {
        object["stop"] = controller::stop_json(cause);
    }
    object
}
