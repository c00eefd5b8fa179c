//! `sieben fleet FILE`: very many controllers at once, coupled by links.

use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use sieben_jit::StatusBits;
use sieben_model::problems::Problem;
use sieben_workspace::Speed;
use sieben_workspace::duration::{self, micros};
use sieben_workspace::fleet::{self, Fleet};

use super::spec_file::{Around, SpecFile};
use crate::arguments::ProgramArguments;
use crate::campaign::said;
use crate::duration::duration_argument;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::fleet::said::Run;
use crate::fleet::{Orders, run as run_fleet};
use crate::{files, output, paths, terminal};

/// Run very many controllers at once, coupled by links.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben fleet line.toml                           10 s of all its controllers, as fast as it goes\n  \
  sieben fleet line.toml --for 1h --json           an hour, and the result as JSON\n  \
  sieben fleet line.toml --speed 1x --for 1d       in real time, until Ctrl-C\n  \
  sieben fleet line.toml --metrics fleet.txt       the numbers of each controller\n  \
  sieben fleet line.toml --record 'station[42]' -  what goes into one of them\n\n\
What comes of it does not depend on threads, engine or speed: what a controller sends arrives at\n\
the time that its link says. One that goes to STOP is a row of the result, and the others go on.\n\n\
Exit codes: 0 ok, 2 usage, 3 does not compile, 130 Ctrl+C.")]
pub(crate) struct Arguments {
    /// The file of the fleet
    #[arg(value_name = "FILE")]
    file: PathBuf,
    #[arg(hide = true)]
    more: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// End after so much time of the controllers
    #[arg(long = "for", value_name = "DURATION", value_parser = duration_argument, default_value = "10s")]
    length: Duration,
    /// max as fast as it goes, 1x in real time, 10x ten times as fast
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true, value_parser = Speed::parse, default_value = "max")]
    speed: Speed,
    /// Threads [default: one for each processor]
    #[arg(long, value_name = "N")]
    threads: Option<NonZero<usize>>,
    /// Another seed of the plants than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Write the numbers of each controller to this file, as OpenMetrics
    #[arg(long, value_name = "FILE")]
    metrics: Option<PathBuf>,
    /// Write what goes into a controller and what comes out to this file, as a scenario (`-` prints it)
    #[arg(long, value_names = ["NAME", "SCENARIO"], num_args = 2)]
    record: Vec<String>,
    /// Which engine runs the programs
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
}

/// Runs a fleet.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    if arguments.file == Path::new("top") && !arguments.file.exists() {
        let message = "`fleet top` is not there yet: `--metrics FILE` has the numbers of all controllers";
        return Err(Failure::usage(Problem::P7173, message));
    }
    if let Some(more) = arguments.more.first() {
        let message = format!("a fleet has one file, and here is a second one: `{}`", more.display());
        return Err(Failure::usage(Problem::P7001, message));
    }
    let recorded = arguments.record.get(1).map(PathBuf::from);
    let written: Vec<&PathBuf> = arguments.metrics.iter().chain(&recorded).collect();
    paths::spare_sources(written.iter().copied())?;
    if written.contains(&&arguments.file) {
        let message = format!("`{}` is the file of the fleet, and results do not replace it", arguments.file.display());
        return Err(Failure::usage(Problem::P6013, message).help("give the file another name"));
    }
    let interrupted = terminal::interrupted();
    let (fleet, name) = match open(arguments)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let record = arguments.record.first().map(|name| fleet.by_name(name).ok_or_else(|| missing(&fleet, name))).transpose()?;
    if let Some(number) = record {
        fleet.record(number);
    }
    let factor = match arguments.speed {
        Speed::Factor(factor) => Some(factor),
        Speed::Max => None,
    };
    let threads = terminal::threads(arguments.threads);
    let for_us = micros(arguments.length);
    let orders = Orders { windows: fleet.windows(for_us, factor.is_some()), threads, factor, cancelled: &interrupted };
    if factor.is_some() && !arguments.json {
        let controllers = said::several(fleet.len() as u64, "controller");
        let cycle = duration::show(Duration::from_micros(fleet.cycle_us));
        output::message(&format!("Running `{name}`: {controllers}, cycle {cycle}; Ctrl-C ends.\n"));
    }
    let ran = run_fleet(&fleet, &orders);
    let summary = fleet.summary();
    if let Some(path) = &arguments.metrics {
        files::write_whole(path, fleet::metrics(&summary).as_bytes())?;
    }
    if let (Some(path), Some(recording)) = (&recorded, record.and_then(|number| fleet.recording(number))) {
        match recording {
            // What is printed is the recording.
            Ok(text) if path.as_os_str() == "-" => {
                output::print_data(&text)?;
                return Ok(ended(ran.interrupted));
            }
            Ok(text) => files::write_whole(path, text.as_bytes())?,
            Err(trouble) => return Err(Failure::usage(Problem::P6291, trouble)),
        }
    }
    let file = arguments.file.display().to_string();
    let threads = threads.get().min(fleet.len().max(1));
    let run = Run { fleet: &fleet, name: &name, file: &file, summary: &summary, threads, for_us, ran };
    match arguments.json {
        true => output::print_json(&run.json(), false)?,
        false => output::print(&run.text())?,
    }
    Ok(ended(ran.interrupted))
}

fn ended(interrupted: bool) -> Exit {
    if interrupted { Exit::Interrupted } else { Exit::Success }
}

fn missing(fleet: &Fleet, name: &str) -> Failure {
    let last = fleet.len().saturating_sub(1);
    let message = format!("the fleet has no controller `{name}`: the first is `{}`, the last `{}`", fleet.name_of(0), fleet.name_of(last));
    Failure::usage(Problem::P7174, message)
}

/// Reads a fleet and compiles its programs; otherwise its findings are printed.
fn open(arguments: &Arguments) -> Result<Result<(Fleet, String), Exit>, Failure> {
    let path = &arguments.file;
    let read = SpecFile::read(path, Problem::P7170, arguments.json)?;
    let (spec, diagnostics) = fleet::parse(read.text(), read.file());
    let Some(mut spec) = spec else {
        read.tell(diagnostics);
        return Ok(Err(Exit::DoesNotCompile));
    };
    spec.seed = arguments.seed.unwrap_or(spec.seed);
    let name = spec.name.clone().unwrap_or_else(|| read.stem());
    let around = Around::of(path, &arguments.program);
    let factory = arguments.engine.settled().factory(StatusBits::Needed);
    match fleet::open(spec, &around, arguments.program.overrides()?, &factory) {
        Ok(fleet) => {
            read.tell(diagnostics);
            Ok(Ok((fleet, name)))
        }
        Err(failed) => read.tell_failed(diagnostics, failed).map(Err),
    }
}
