//! `sieben test [PATH…]`: runs programs that check themselves.

use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use sieben_model::problems::Problem;

use crate::arguments::{EngineArgument, ProgramArguments, duration_argument};
use crate::failure::{Exit, Failure};
use crate::testing::{self, Conditions, Verdict, discovery, report};
use crate::{files, output};

/// Run programs that check themselves.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben test timers.awl                 one program\n  \
  sieben test checks                     every program in a folder\n  \
  sieben test checks --filter shift      those with `shift` in their name\n  \
  sieben test src --tests checks/*.awl   tests of the blocks of a project\n  \
  sieben test checks --junit result.xml  for a build server\n\n\
A program has passed when it calls SFC 46, and failed when one of its assertions\n\
(`__ASSERT== MW 10, 5`) is false, when the CPU goes to STOP, or when it does not end.\n\
A program in a folder that has neither is no test.\n\
Time is virtual, and the extension words need no `--extended`.\n\n\
Exit codes: 0 all passed, 1 one failed, 2 usage, 3 one does not compile.")]
pub(crate) struct Arguments {
    /// Sources, projects of awlsim, symbol tables, or folders [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Test files: each is run with the program that PATH is, and its blocks take the place of those with the same number
    #[arg(long, value_name = "FILE", num_args = 1..)]
    tests: Vec<PathBuf>,
    /// Only tests with this text in their name
    #[arg(long, value_name = "TEXT")]
    filter: Option<String>,
    /// Time from one scan to the next [default: the project's, else 10ms]
    #[arg(long, value_name = "DURATION", allow_hyphen_values = true, value_parser = duration_argument)]
    cycle: Option<Duration>,
    /// Virtual time in which a test has to end
    #[arg(long, value_name = "DURATION", default_value = "60s", allow_hyphen_values = true, value_parser = duration_argument)]
    limit: Duration,
    /// Scans in which a test has to end [default: as many as --limit allows]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    scans: Option<u64>,
    /// Real time after which a test is given up
    #[arg(long, value_name = "DURATION", default_value = "60s", allow_hyphen_values = true, value_parser = duration_argument)]
    timeout: Duration,
    /// Run so many tests at once [default: one per processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Which engine runs the programs
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Print the results as one JSON object
    #[arg(long)]
    json: bool,
    /// Print the results in the Test Anything Protocol
    #[arg(long, conflicts_with = "json")]
    tap: bool,
    /// Write the results to this file as JUnit XML, too
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
}

/// Runs the tests.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let conditions = Conditions {
        overrides: arguments.program.overrides()?,
        encoding: arguments.program.encoding(),
        engine: arguments.engine,
        cycle: arguments.cycle,
        limit: arguments.limit,
        scans: arguments.scans,
        timeout: arguments.timeout,
    };
    let mut cases = discovery::cases(&arguments.paths, &arguments.tests)?;
    if let Some(filter) = &arguments.filter {
        let all = cases.len();
        cases.retain(|case| case.name.contains(filter.as_str()));
        if cases.is_empty() && all > 0 {
            return Err(Failure::usage(Problem::P7020, format!("none of {all} tests has `{filter}` in its name")));
        }
    }
    if cases.is_empty() {
        return Err(Failure::usage(Problem::P7020, "there is no program to test"));
    }
    let threads = arguments.jobs.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);
    let begun = Instant::now();
    let bar = bar(cases.len());
    let mut finished = testing::run_all(&cases, &conditions, threads, &|done| {
        if let Some(bar) = &bar {
            bar.set_position(done as u64);
        }
    });
    if let Some(bar) = &bar {
        bar.finish_and_clear();
    }
    let took = begun.elapsed();
    let programs = finished.len();
    finished.retain(|test| !matches!(test.outcome.verdict, Verdict::NoTest));
    // A file that cannot be written does not keep the results from the screen.
    let written = arguments.junit.as_ref().map_or(Ok(()), |path| files::write_whole(path, report::junit(&finished, took).as_bytes()));
    match (arguments.json, arguments.tap) {
        (true, _) => output::print_json(&report::to_json(&finished, took), true)?,
        (_, true) => output::print(&report::tap(&finished))?,
        _ if finished.is_empty() => output::print(&no_tests(programs))?,
        _ => output::print(&report::text(&finished))?,
    }
    written?;
    Ok(report::exit(&finished))
}

/// What is said when no program checks itself.
fn no_tests(programs: usize) -> String {
    let looked = if programs == 1 { "The program has".to_owned() } else { format!("{programs} programs have") };
    format!(
        "No tests found. {looked} neither an assertion (`__ASSERT== MW 10, 5`) nor an end (`CALL SFC 46`);\n\
         name test files in `[project] tests` of sieben.toml or with `--tests`.\n"
    )
}

/// A bar while the tests run, if someone looks.
fn bar(tests: usize) -> Option<ProgressBar> {
    std::io::stderr().is_terminal().then(|| {
        let bar = ProgressBar::with_draw_target(Some(tests as u64), ProgressDrawTarget::stderr());
        bar.set_style(ProgressStyle::with_template("{bar:30} {pos}/{len} tests").unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar
    })
}
