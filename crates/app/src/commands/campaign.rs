//! `sieben campaign …`: very many scenarios of a program, each from its number.

use std::io::IsTerminal;
use std::num::NonZero;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::{Args, Subcommand};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::json;
use sieben_campaign::parse::parse;
use sieben_campaign::row::Verdict;
use sieben_campaign::tally::Tally;
use sieben_jit::StatusBits;
use sieben_model::problems::Problem;
use sieben_workspace::campaign::{self, Campaign, Failed, Files};
use sieben_workspace::finding::{self, Finding, Texts};
use sieben_workspace::project::Project;
use sieben_workspace::refusal::Refusal;

use crate::arguments::ProgramArguments;
use crate::campaign::said::{self, Run};
use crate::campaign::{Ended, Orders};
use crate::duration::duration_argument;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::{files, output, project, report};

/// Run a program through very many scenarios: every combination of its inputs, drawn values, faults.
#[derive(Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Print how many scenarios a campaign has, and the columns of its result; nothing runs
    List(ListArguments),
    /// Run the scenarios of a campaign
    Run(RunArguments),
    /// Print one scenario of a campaign as a *.scenario file
    Show(ShowArguments),
}

/// Print how many scenarios a campaign has.
#[derive(Args)]
struct ListArguments {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    #[command(flatten)]
    program: ProgramArguments,
    /// Another seed than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Print it as one JSON object
    #[arg(long)]
    json: bool,
}

/// Run the scenarios of a campaign.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben campaign run oven.toml                    all of it, on all processors\n  \
  sieben campaign run oven.toml --only 0..999      the first thousand\n  \
  sieben campaign run oven.toml --stop-on first    the failure with the least number\n  \
  sieben campaign run oven.toml --json             lines of progress, then the result\n\n\
What comes of it does not depend on threads, engine or machine: a scenario is a function of\n\
the program, the file, the seed and its number.\n\n\
Exit codes: 0 all held, 1 a property broke or what has to come sometimes never came, 2 usage,\n\
3 does not compile, 5 the time is used up, 130 Ctrl+C.")]
struct RunArguments {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    #[command(flatten)]
    program: ProgramArguments,
    /// Threads [default: one for each processor]
    #[arg(long, value_name = "N")]
    workers: Option<NonZero<usize>>,
    /// Another seed than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Only these scenarios, both of them too
    #[arg(long, value_name = "A..B", value_parser = numbers)]
    only: Option<(u64, u64)>,
    /// Scenarios that a thread takes at once [default: as many as take a quarter of a second]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    range: Option<u64>,
    /// End after the first failure, or after so many; it is always the one with the least number
    #[arg(long, value_name = "first|never|N", default_value = "never", value_parser = failures)]
    stop_on: Failures,
    /// End after so much real time
    #[arg(long, value_name = "DURATION", value_parser = duration_argument)]
    budget: Option<Duration>,
    /// Which engine runs the program
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Print lines of progress and the result as JSON
    #[arg(long)]
    json: bool,
    /// Print no progress
    #[arg(long)]
    quiet: bool,
}

/// Print one scenario of a campaign.
#[derive(Args)]
struct ShowArguments {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// The number of the scenario, from 0
    #[arg(value_name = "N")]
    number: u64,
    #[command(flatten)]
    program: ProgramArguments,
    /// Another seed than that of the file
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// After how many failures a run ends.
#[derive(Clone, Copy, Debug)]
struct Failures(Option<u64>);

fn failures(text: &str) -> Result<Failures, String> {
    match text {
        "never" => Ok(Failures(None)),
        "first" => Ok(Failures(Some(1))),
        text => {
            let count = text.parse().ok().filter(|&count| count > 0);
            count.map(|count| Failures(Some(count))).ok_or_else(|| "write `first`, `never`, or a number from 1".to_owned())
        }
    }
}

fn numbers(text: &str) -> Result<(u64, u64), String> {
    let range = text.split_once("..").and_then(|(from, to)| Some((from.parse().ok()?, to.parse().ok()?)));
    range.filter(|(from, to)| from <= to).ok_or_else(|| "write the first and the last number: `0..999`".to_owned())
}

/// A campaign that was read, with what it is called.
struct Opened {
    campaign: Campaign,
    name: String,
}

/// Does what is asked for.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    match &arguments.verb {
        Verb::List(arguments) => list(arguments),
        Verb::Run(arguments) => run_scenarios(arguments),
        Verb::Show(arguments) => show(arguments),
    }
}

/// The files around that of a campaign.
struct Around<'a> {
    folder: PathBuf,
    program: &'a ProgramArguments,
}

impl Files for Around<'_> {
    fn project(&self, path: &str) -> Result<Project, Refusal> {
        let at = if path == "." { self.folder.clone() } else { self.folder.join(path) };
        project::load(&[at], self.program.encoding()).map_err(|failure| failure.refusal)
    }

    fn text(&self, path: &str) -> Result<String, Refusal> {
        let bytes = files::read(&self.folder.join(path)).map_err(|failure| failure.refusal)?;
        String::from_utf8(bytes).map_err(|_| Refusal::new(Problem::P7163, format!("`{path}` is not UTF-8 text")))
    }
}

/// Reads a campaign and compiles its programs; otherwise its findings are printed.
fn open(
    path: &Path,
    program: &ProgramArguments,
    seed: Option<u64>,
    engine: EngineArgument,
    json: bool,
) -> Result<Result<Opened, Exit>, Failure> {
    let bytes = files::read(path)?;
    let mut texts = Texts::default();
    let text = String::from_utf8(bytes).map_err(|_| Failure::usage(Problem::P7156, format!("`{}` is not UTF-8 text", path.display())))?;
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(&text);
    let file = texts.documents.add(path.display().to_string(), text);
    let (spec, diagnostics) = parse(text, file);
    let mut findings: Vec<Finding> = diagnostics.into_iter().map(Finding::document).collect();
    let told = |findings: &mut Vec<Finding>, texts: &Texts| {
        finding::sort(findings);
        report::print(findings, texts, json);
    };
    let Some(mut spec) = spec.filter(|_| !finding::has_errors(&findings)) else {
        told(&mut findings, &texts);
        return Ok(Err(Exit::DoesNotCompile));
    };
    spec.seed = seed.unwrap_or(spec.seed);
    let name = spec.name.clone().unwrap_or_else(|| path.file_stem().unwrap_or_default().to_string_lossy().into_owned());
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).map_or_else(|| PathBuf::from("."), Path::to_path_buf);
    let around = Around { folder, program };
    let factory = engine.settled().factory(StatusBits::Needed);
    match campaign::open(spec, text, &around, program.overrides()?, &factory) {
        Ok(campaign) => {
            findings.extend(campaign.warnings.iter().cloned().map(Finding::document));
            if !findings.is_empty() {
                told(&mut findings, &texts);
            }
            Ok(Ok(Opened { campaign, name }))
        }
        Err(Failed::Spec(wrong)) => {
            findings.extend(wrong.into_iter().map(Finding::document));
            told(&mut findings, &texts);
            Ok(Err(Exit::DoesNotCompile))
        }
        Err(Failed::Program(build)) => {
            report::print(&build.findings, &build.project.texts, json);
            Ok(Err(Exit::DoesNotCompile))
        }
        Err(Failed::Refused(refusal)) => Err(refusal.into()),
    }
}

fn list(arguments: &ListArguments) -> Result<Exit, Failure> {
    let opened = match open(&arguments.spec, &arguments.program, arguments.seed, EngineArgument::Interpreter, arguments.json)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let campaign = &opened.campaign;
    let subject = &campaign.programs[0];
    let columns = said::columns(&campaign.spec);
    let guess = guessed(campaign);
    if arguments.json {
        let object = json!({
            "campaign": campaign.identity.campaign,
            "program": campaign.identity.program,
            "name": opened.name,
            "seed": campaign.spec.seed,
            "scenarios": campaign.scenarios(),
            "scans": subject.scans(),
            "cycle_us": subject.cycle_us(),
            "columns": columns.iter().map(|(name, _)| name).collect::<Vec<_>>(),
            "seconds": guess.as_secs_f64(),
        });
        output::print_json(&object, true)?;
        return Ok(Exit::Success);
    }
    let mut text = format!(
        "{}: {} of up to {} at a cycle of {}\n",
        opened.name,
        said::scenarios(campaign.scenarios()),
        said::several(subject.scans(), "scan"),
        sieben_workspace::duration::show(Duration::from_micros(subject.cycle_us()))
    );
    let width = columns.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    text.extend(columns.iter().map(|(name, said)| format!("  {name:width$}  {said}\n")));
    text.push_str(&format!("about {} of one processor, in the interpreter\n", about(guess)));
    output::print(&text)?;
    Ok(Exit::Success)
}

/// The first scenario is looked at for so long.
const LOOK: Duration = Duration::from_secs(2);

/// How long all scenarios take on one processor, by the first one.
fn guessed(campaign: &Campaign) -> Duration {
    let begun = Instant::now();
    let run = campaign.run(0, &|| begun.elapsed() < LOOK);
    let each = begun.elapsed().as_secs_f64();
    // Of one that takes long a part was run.
    let part = run.map_or_else(|scans| campaign.programs[0].scans() as f64 / scans.max(1) as f64, |_| 1.0);
    let all = each * part * campaign.scenarios() as f64;
    // What takes longer than there is a number for takes that long.
    Duration::try_from_secs_f64(all).unwrap_or(Duration::MAX)
}

/// A time that is only guessed.
fn about(time: Duration) -> String {
    match time.as_secs_f64() {
        seconds if seconds < 1.0 => "a second".to_owned(),
        seconds if seconds < 120.0 => format!("{seconds:.0} s"),
        seconds if seconds < 7200.0 => format!("{:.0} min", seconds / 60.0),
        seconds if seconds < 172_800.0 => format!("{:.0} h", seconds / 3600.0),
        seconds if seconds < 3e10 => format!("{:.0} days", seconds / 86_400.0),
        _ => "more than a thousand years".to_owned(),
    }
}

fn run_scenarios(arguments: &RunArguments) -> Result<Exit, Failure> {
    let opened = match open(&arguments.spec, &arguments.program, arguments.seed, arguments.engine, arguments.json)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let campaign = &opened.campaign;
    let numbers = wanted(campaign, arguments.only)?;
    let cancelled = Arc::new(AtomicBool::new(false));
    let cancel = Arc::clone(&cancelled);
    // Without the handler Ctrl+C ends the process, which loses nothing but its result.
    let _ = ctrlc::set_handler(move || cancel.store(true, Ordering::Relaxed));
    let orders = Orders {
        workers: arguments.workers.or_else(|| std::thread::available_parallelism().ok()).unwrap_or(NonZero::<usize>::MIN),
        range: arguments.range,
        stop_after: arguments.stop_on.0,
        budget: arguments.budget,
        cancelled: &cancelled,
        numbers: numbers.clone(),
    };
    let asked = numbers.end - numbers.start;
    let begun = Instant::now();
    let mut progress = Progress::new(asked, arguments);
    let (tally, ended) = crate::campaign::run(campaign, &orders, &mut |tally| progress.tell(tally));
    progress.end();
    let file = arguments.spec.display().to_string();
    let run = Run { campaign, name: &opened.name, file: &file, asked, tally: &tally, took: begun.elapsed() };
    match arguments.json {
        true => output::print_json(&run.json(), false)?,
        false => output::print(&run.text())?,
    }
    Ok(match ended {
        Ended::Cancelled => Exit::Interrupted,
        Ended::Budget => Exit::BudgetUsedUp,
        Ended::Whole | Ended::Failures => {
            // What did not come in a part may come in another one.
            let missing = arguments.only.is_none() && ended == Ended::Whole && tally.never_came(&campaign.spec).next().is_some();
            if tally.of(Verdict::Pass) == tally.run() && !missing { Exit::Success } else { Exit::CheckFailed }
        }
    })
}

/// The numbers that are asked for.
fn wanted(campaign: &Campaign, only: Option<(u64, u64)>) -> Result<Range<u64>, Failure> {
    let all = campaign.scenarios();
    match only {
        None => Ok(0..all),
        Some((from, to)) if to < all => Ok(from..to + 1),
        Some((from, to)) => {
            let which = if from == to { format!("there is no scenario {from}") } else { format!("`--only {from}..{to}`") };
            let message = format!("{which}: the campaign has {}, 0 to {}", said::scenarios(all), all.saturating_sub(1));
            Err(Failure::usage(Problem::P7001, message))
        }
    }
}

fn show(arguments: &ShowArguments) -> Result<Exit, Failure> {
    let opened = match open(&arguments.spec, &arguments.program, arguments.seed, EngineArgument::Interpreter, false)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let campaign = &opened.campaign;
    wanted(campaign, Some((arguments.number, arguments.number)))?;
    let scenario = campaign.scenario(arguments.number).map_err(|message| Failure::usage(Problem::P7162, message))?;
    let text = format!("// Scenario {} of the campaign `{}`, seed {}.\n{scenario}", arguments.number, opened.name, campaign.spec.seed);
    match &arguments.output {
        Some(path) => files::write_whole(path, text.as_bytes())?,
        None => output::print_data(&text)?,
    }
    Ok(Exit::Success)
}

/// A bar where a terminal is, lines of JSON where they are asked for, else a line a second.
struct Progress {
    of: u64,
    bar: Option<ProgressBar>,
    json: bool,
    quiet: bool,
    told: Instant,
}

impl Progress {
    fn new(of: u64, arguments: &RunArguments) -> Self {
        let bar = (std::io::stderr().is_terminal() && !arguments.quiet && !arguments.json).then(|| {
            let bar = ProgressBar::with_draw_target(Some(of), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{bar:30} {pos}/{len} scenarios, {per_sec}, {eta} left{msg}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar
        });
        Self { of, bar, json: arguments.json, quiet: arguments.quiet, told: Instant::now() }
    }

    fn tell(&mut self, tally: &Tally) {
        let failed = tally.run() - tally.of(Verdict::Pass);
        if let Some(bar) = &self.bar {
            bar.set_position(tally.run());
            bar.set_message(if failed > 0 { format!(", {failed} did not pass") } else { String::new() });
            return;
        }
        if self.quiet || self.told.elapsed() < Duration::from_secs(1) {
            return;
        }
        self.told = Instant::now();
        if self.json {
            // Who does not listen any more is told by the result.
            let _ = output::print_json(&json!({ "progress": { "done": tally.run(), "of": self.of, "failed": failed } }), false);
        } else {
            output::message(&format!("{} of {}, {failed} did not pass\n", tally.run(), said::scenarios(self.of)));
        }
    }

    fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
