//! `sieben step FILE…`: one statement at a time, forwards and back.

use std::io::{BufRead, IsTerminal, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use clap::Args;
use sieben_cpu::{Cpu, OperatingMode};
use sieben_engine::Interpreter;
use sieben_model::problems::Problem;
use sieben_sim::history::{History, Plan};
use sieben_sim::names::Name;
use sieben_workspace::controller;
use sieben_workspace::duration;
use sieben_workspace::project::Build;
use sieben_workspace::schedule;
use sieben_workspace::session::commands::{Answer, LINE_MAX, carry_out};
use sieben_workspace::session::recording::Unusable;
use sieben_workspace::session::{Session, recording, table};

use crate::arguments::{FaultArguments, ProgramArguments};
use crate::duration::cycle_argument;
use crate::failure::{Exit, Failure};
use crate::schedule::ChangeArguments;
use crate::stepping::words::refused;
use crate::{files, language, output, paths, stepping, terminal};

/// Step through a program, one statement at a time, forwards and back.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben step lamp.awl --set I0.0=1             the screen, with keys for every step\n  \
  sieben step lamp.awl --commands steps.txt     commands from a file\n  \
  printf 'watch MW10\\nrun\\nwho MW10' | sieben step plant --commands - --json\n\n\
Commands, one line each:\n  step 3, into, over, out, network, block, scan 2   on\n  back 3, back over, back scan, run back            the same steps back\n  \
  break FC1:4, break MW10 > 5, watch MW10, run, to OB1:5\n  print MW10, who Q4.0, set I0.0=1, help, quit\n\n\
Time is virtual, as with `exec`. The columns are the registers after the\n\
statement of the row, in ST and SCL the variables that it names;\n\
below it stands why, and what it changed.\n\n\
Exit codes: 0 ok, 2 usage or a wrong command, 3 does not compile, 4 the CPU is in STOP.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables, or a project folder
    #[arg(required = true, value_name = "FILE")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    #[command(flatten)]
    change: ChangeArguments,
    #[command(flatten)]
    faults: FaultArguments,
    /// There are so many scans [default: as many as are wanted]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    scans: Option<u64>,
    /// Time from one scan to the next [default: the project's, else 10ms]
    #[arg(long, value_name = "DURATION", allow_hyphen_values = true, value_parser = cycle_argument)]
    cycle: Option<Duration>,
    /// Read commands from a file, `-` = standard input
    #[arg(long, value_name = "FILE")]
    commands: Option<PathBuf>,
    /// Keep what came from outside in a file, to be replayed
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Begin with a run that was recorded, at its end
    #[arg(long, value_name = "FILE", conflicts_with_all = ["set", "at"])]
    replay: Option<PathBuf>,
    /// Print one JSON object per command
    #[arg(long)]
    json: bool,
}

/// Reads and carries out commands.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    paths::spare_sources(&arguments.record)?;
    let overrides = arguments.program.overrides()?;
    let project = arguments.program.load(&arguments.paths)?;
    let cycle = schedule::cycle(arguments.cycle, &project.settings);
    let mut build = match super::or_report(project.compile(overrides, false), arguments.json) {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let mut cpu = controller::load(&build, Interpreter::load, controller::settings(&build));
    arguments.faults.inject(&mut cpu)?;
    arguments.faults.note(&mut build.project.settings.modules);
    let timed = arguments.change.timed(&build.project.symbols, &cpu)?.into_iter();
    let timed = timed.map(|(time, setting)| (duration::micros(time), setting));
    let plan = Plan::new(duration::micros(cycle), arguments.scans, timed.collect());
    let build = Arc::new(build);
    let mut session = match &arguments.replay {
        Some(path) => replay(path, build, cpu, plan)?,
        None => Session::new(build, cpu, plan),
    };
    session.language = if arguments.json { language::for_programs() } else { language::spoken() };
    let exit = if arguments.commands.is_none() && !arguments.json && terminal::has_screen() {
        on_screen(&mut session)?
    } else {
        let input = open(arguments)?;
        read_commands(arguments, &mut session, input)?
    };
    if let Some(path) = &arguments.record {
        match recording::write(&session) {
            Some(text) => files::write_whole(path, text.as_bytes())?,
            None => {
                let message = "the run cannot be recorded: its beginning is no longer kept";
                return Err(Failure::usage(Problem::P7044, message).help("record shorter runs: `--scans` says how long"));
            }
        }
    }
    Ok(exit)
}

/// The microscope with keys, until the user leaves it.
fn on_screen(session: &mut Session) -> Result<Exit, Failure> {
    let interrupted = terminal::interrupted();
    stepping::run(session, output::colour(), &interrupted).map_err(|error| terminal::broken(&error))?;
    Ok(Exit::Success)
}

/// The run of a recording, at its end.
fn replay(path: &Path, build: Arc<Build>, cpu: Cpu, plan: Plan) -> Result<Session, Failure> {
    let shown = path.display();
    let unreadable = |error: std::io::Error| Failure::usage(Problem::P6001, format!("`{shown}` cannot be read: {error}"));
    let mut text = String::new();
    let mut file = std::fs::File::open(path).map_err(unreadable)?.take(recording::BYTES_MAX + 1);
    file.read_to_string(&mut text).map_err(unreadable)?;
    if text.len() as u64 > recording::BYTES_MAX {
        return Err(Failure::usage(Problem::P7044, format!("`{shown}` has more than {} bytes", recording::BYTES_MAX)));
    }
    let symbols = &build.project.symbols;
    let name = |name: &str| Name::parse(name, symbols, cpu.program()).map_err(|error| error.to_string());
    let recording = recording::read(&text, &build, name).map_err(|unusable| match unusable {
        Unusable::OtherProgram => Failure::usage(Problem::P7043, format!("`{shown}` is the recording of another program")),
        Unusable::Line(line, why) => Failure::usage(Problem::P7044, format!("`{shown}`, line {line}: {why}")),
    })?;
    let mut history = History::recorded(cpu, plan, recording.actions);
    if !history.play(recording.end) {
        let came = history.position().statements;
        return Err(Failure::usage(Problem::P7044, format!("`{shown}`: the run ends after {came} statements, not {}", recording.end)));
    }
    Ok(Session::with_history(build, history))
}

fn open(arguments: &Arguments) -> Result<Box<dyn BufRead>, Failure> {
    let Some(path) = arguments.commands.as_ref().filter(|path| path.as_os_str() != "-") else {
        return Ok(Box::new(std::io::stdin().lock()));
    };
    let file = std::fs::File::open(path)
        .map_err(|error| Failure::usage(Problem::P6001, format!("`{}` cannot be read: {error}", path.display())))?;
    Ok(Box::new(std::io::BufReader::new(file)))
}

fn read_commands(arguments: &Arguments, session: &mut Session, mut input: Box<dyn BufRead>) -> Result<Exit, Failure> {
    let prompts = arguments.commands.is_none() && std::io::stdin().is_terminal() && !arguments.json;
    let mut wrong = false;
    if !arguments.json {
        output::print(table::head(session))?;
    }
    loop {
        if prompts {
            output::message("> ");
        }
        let Some(line) = next_line(&mut *input)? else { break };
        let command = line.trim().to_owned();
        if !arguments.json && !prompts && !command.is_empty() {
            output::print(&format!("> {command}\n"))?;
        }
        let mut rows = String::new();
        let outcome = carry_out(session, &line, &mut |session| rows.push_str(&table::row(session)));
        if !arguments.json {
            output::print(&rows)?;
        }
        match outcome {
            Ok(Answer::Quit) => break,
            Ok(Answer::Nothing) => {}
            Ok(answer) if arguments.json => output::print_json(&table::answer_json(session, &command, &answer), false)?,
            Ok(answer) => output::print(&table::answer(session, &answer))?,
            Err(refusal) => {
                wrong = true;
                if arguments.json {
                    output::print_json(&table::refusal_json(&command, &refusal), false)?;
                } else {
                    output::styled(&refused(&refusal, output::colour(), session.language));
                }
            }
        }
    }
    Ok(match session.cpu().mode() {
        _ if wrong => Exit::Usage,
        OperatingMode::Stop if session.history().position().actions > 0 => Exit::Stopped,
        _ => Exit::Success,
    })
}

/// The next line, at most a little longer than a command may be; the rest of a longer one is dropped, not kept.
fn next_line(input: &mut dyn BufRead) -> Result<Option<String>, Failure> {
    let mut bytes = Vec::new();
    let failed = |error: std::io::Error| Failure::usage(Problem::P6001, format!("the commands cannot be read: {error}"));
    let count = Read::take(&mut *input, LINE_MAX as u64 + 2).read_until(b'\n', &mut bytes).map_err(failed)?;
    if count == 0 {
        return Ok(None);
    }
    while bytes.last() != Some(&b'\n') {
        let buffer = input.fill_buf().map_err(failed)?;
        if buffer.is_empty() {
            break;
        }
        let end = buffer.iter().position(|&byte| byte == b'\n');
        let used = end.map_or(buffer.len(), |end| end + 1);
        input.consume(used);
        if end.is_some() {
            break;
        }
    }
    Ok(Some(String::from_utf8_lossy(&bytes).into_owned()))
}
