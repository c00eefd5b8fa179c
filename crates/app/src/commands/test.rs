//! `sieben test [PATH…]`: runs unit tests, scenarios, and programs that check themselves.

use std::io::IsTerminal;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use sieben_model::language::Language;
use sieben_model::problems::Problem;
use sieben_sim::scenario::Rules;
use sieben_workspace::coverage::{Collector, Coverage};
use sieben_workspace::testing::{Case, Conditions, Verdict, report, shuffle};

use crate::arguments::{DiagnosticsArgument, ProgramArguments, StrictArgument};
use crate::duration::{cycle_argument, duration_argument};
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::testing::computer::Computer;
use crate::testing::discovery::Discovered;
use crate::testing::rules::RuleArguments;
use crate::testing::{self, coverage_pages, discovery};
use crate::{files, language, output, paths, watch};

/// Run unit tests (*.test.st), scenarios, and programs that check themselves.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben test                            all tests of the project in this folder\n  \
  sieben test motor.test.st              those of one file, with the program around it\n  \
  sieben test --list                     their names\n  \
  sieben test --coverage lcov.info       and which lines of the program they run\n  \
  sieben test --coverage-html coverage   the same as pages for a browser\n  \
  sieben test timers.awl                 a program that checks itself\n  \
  sieben test checks                     every test and program in a folder\n  \
  sieben test ue1.awl                    the tests in ue1.test.st beside it\n  \
  sieben test checks --filter shift      those with `shift` in their name\n  \
  sieben test src --tests checks/*.awl   tests of the blocks of a project\n  \
  sieben test new --tests old.scenario   does it what was recorded of another program?\n  \
  sieben test checks --junit result.xml  for a build server\n\n\
A unit test stands in a file *.test.st, or any source that begins with TEST, SETUP or TEARDOWN:\n\
TEST 'the motor starts' … END_TEST, with ASSERT_EQ(a, b), SCAN(n), ADVANCE_TIME(T#5s) and others.\n\
In a folder with several programs ue1.test.st, ue1_test.st and test_ue1.st test ue1.awl.\n\
A program has passed when it calls SFC 46, and failed when one of its assertions\n\
(`__ASSERT== MW 10, 5`) is false, when the CPU goes to STOP, or when it does not end.\n\
A program in a folder that has neither is no test.\n\
A scenario (*.scenario) with an expectation is a test, too; one of `sieben record` holds the\n\
program against every scan of the recording.\n\
Time is virtual, and the extension words need no `--extended`.\n\n\
Exit codes: 0 all passed, 1 one failed or there is no test, 2 usage, 3 one does not compile.")]
pub(crate) struct Arguments {
    /// Sources, projects of awlsim, symbol tables, or folders [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Test files, whatever their names: each is run with the program that PATH is; blocks of one that checks itself take the place of those with the same number
    #[arg(long, value_name = "FILE", num_args = 1..)]
    tests: Vec<PathBuf>,
    #[command(flatten)]
    rules: RuleArguments,
    /// Only tests with this text in their name
    #[arg(long, value_name = "TEXT")]
    filter: Option<String>,
    /// Time from one scan to the next [default: the project's, else 10ms]
    #[arg(long, value_name = "DURATION", allow_hyphen_values = true, value_parser = cycle_argument)]
    cycle: Option<Duration>,
    /// Virtual time in which a test has to end [default: 60s, 100 days for a unit test]
    #[arg(long, value_name = "DURATION", allow_hyphen_values = true, value_parser = duration_argument)]
    limit: Option<Duration>,
    /// Scans in which a test has to end [default: as many as --limit allows]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    scans: Option<u64>,
    /// Real time after which a test is given up
    #[arg(long, value_name = "DURATION", default_value = "60s", allow_hyphen_values = true, value_parser = duration_argument)]
    timeout: Duration,
    /// Run so many tests at once [default: one per processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    #[command(flatten)]
    strict: StrictArgument,
    #[command(flatten)]
    diagnostics: DiagnosticsArgument,
    /// Which engine runs the programs
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    engine: EngineArgument,
    /// Print the results as one JSON object
    #[arg(long)]
    json: bool,
    /// Print the results in the Test Anything Protocol
    #[arg(long, conflicts_with = "json")]
    tap: bool,
    /// Count which lines of the programs the tests run, and which way decisions go; write that to this file for lcov. The tests run in the interpreter
    #[arg(long, value_name = "FILE")]
    coverage: Option<PathBuf>,
    /// The same as pages for a browser, written into this folder; index.html is the first
    #[arg(long, value_name = "FOLDER")]
    coverage_html: Option<PathBuf>,
    /// Write the timing diagram of every unit test that fails into this folder, as SVG
    #[arg(long, value_name = "FOLDER")]
    svg: Option<PathBuf>,
    /// Run the tests in an order made from this number, which is printed [default: in the order of the files]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Only print the names of the tests
    #[arg(long, conflicts_with_all = ["watch", "junit"])]
    list: bool,
    /// Run the tests again when a file changes, until Ctrl+C
    #[arg(long, conflicts_with_all = ["json", "tap", "junit"])]
    watch: bool,
    /// Write the results to this file as JUnit XML, too
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
}

impl Arguments {
    /// The language of what is wrong with a program.
    fn language(&self) -> Language {
        if self.json || self.tap || self.junit.is_some() { language::for_programs() } else { language::spoken() }
    }
}

/// Runs the tests.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    paths::spare_sources([&arguments.junit, &arguments.coverage].into_iter().flatten())?;
    if !arguments.watch {
        return once(arguments);
    }
    let folder = PathBuf::from(".");
    let watched: Vec<PathBuf> = match arguments.paths.is_empty() && arguments.tests.is_empty() {
        true => vec![folder],
        false => arguments.paths.iter().chain(&arguments.tests).cloned().collect(),
    };
    loop {
        let stamps = watch::stamps(&watched);
        // What is wrong may be mended while we look.
        if let Err(failure) = once(arguments) {
            output::message(&format!("{}\n", failure.refusal.message));
        }
        output::message("Waiting for a change; Ctrl+C ends.\n");
        watch::wait_for_change(&watched, &stamps);
    }
}

/// Runs the tests once.
fn once(arguments: &Arguments) -> Result<Exit, Failure> {
    let mut conditions = Conditions {
        outside: Arc::new(Computer::new(arguments.engine, arguments.svg.clone(), arguments.language())),
        overrides: arguments.strict.overrides(arguments.program.overrides()?),
        diagnostics: arguments.diagnostics.wanted(),
        encoding: arguments.program.encoding(),
        cycle: arguments.cycle,
        limit: arguments.limit,
        scans: arguments.scans,
        timeout: arguments.timeout,
        coverage: (arguments.coverage.is_some() || arguments.coverage_html.is_some()).then(Arc::default),
        rules: Rules::default(),
    };
    let Discovered { mut cases, folders } = discovery::cases(&arguments.paths, &arguments.tests, &conditions)?;
    let all_programs: Vec<&str> = folders.iter().flat_map(|folder| &folder.programs).map(|program| program.name.as_str()).collect();
    let scenarios: Vec<PathBuf> = cases.iter().filter_map(|case| case.scenario.clone()).collect();
    conditions.rules = arguments.rules.rules(&scenarios)?;
    if let Some(filter) = &arguments.filter {
        let all = cases.len();
        cases.retain(|case| case.name.contains(filter.as_str()));
        if cases.is_empty() && all > 0 {
            return Err(Failure::usage(Problem::P7020, {
                let tests = if all == 1 { "the one test has no".to_owned() } else { format!("none of {all} tests has") };
                format!("{tests} `{filter}` in its name")
            }));
        }
    }
    if cases.is_empty() {
        return Err(discovery::nothing());
    }
    if arguments.list {
        // Programs that do not check themselves are no tests.
        cases.retain(|case| case.perhaps.as_ref().is_none_or(|program| discovery::checks_itself(program, &conditions)));
        list(arguments, &cases)?;
        return Ok(Exit::Success);
    }
    if !arguments.json && !arguments.tap {
        folders.iter().try_for_each(|folder| output::print(&format!("{}\n", folder.sentence())))?;
    }
    if let Some(seed) = arguments.seed {
        shuffle(&mut cases, seed);
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
    let mut written = arguments.junit.as_ref().map_or(Ok(()), |path| files::write_whole(path, report::junit(&finished, took).as_bytes()));
    let covered = conditions.coverage.as_deref().map(Collector::coverage);
    let mut pages = None;
    if let Some(coverage) = &covered {
        if let Some(path) = &arguments.coverage {
            written = written.and(files::write_whole(path, coverage.lcov().as_bytes()));
        }
        if let Some(folder) = &arguments.coverage_html {
            let html = coverage_pages::write(coverage, folder, &report::count(&finished));
            written = written.and(html.map(|index| pages = Some(paths::shown(&index))));
        }
    }
    match (arguments.json, arguments.tap) {
        (true, _) => {
            let mut json = report::to_json(&finished, took);
            json["seed"] = arguments.seed.into();
            if !folders.is_empty() {
                json["programs"] = all_programs.clone().into();
            }
            let of = |share: fn(&Coverage) -> usize| covered.as_ref().map(share).into();
            json["lines_covered"] = of(|coverage| coverage.lines().hit);
            json["lines"] = of(|coverage| coverage.lines().all);
            json["decisions_covered"] = of(|coverage| coverage.decisions().hit);
            json["decisions"] = of(|coverage| coverage.decisions().all);
            json["coverage"] = covered.as_ref().map(Coverage::to_json).into();
            output::print_json(&json, true)?;
        }
        (_, true) => output::print(&report::tap(&finished))?,
        _ if finished.is_empty() => output::print(&no_tests(programs))?,
        _ => {
            output::print(&report::text(&finished))?;
            if !folders.is_empty() && arguments.filter.is_none() {
                output::print(&report::programs(&finished, &all_programs))?;
            }
            if let Some(seed) = arguments.seed {
                output::print(&format!("order: --seed {seed}\n"))?;
            }
            if let Some(coverage) = &covered {
                output::print(&coverage.summary())?;
            }
            if let Some(index) = &pages {
                output::print(&format!("pages for a browser: {index}\n"))?;
            }
        }
    }
    written?;
    if !arguments.json
        && let Some(line) = report::failed_statements(&finished)
    {
        output::message(&format!("{line}\n"));
    }
    Ok(if finished.is_empty() { Exit::CheckFailed } else { testing::exit(report::worst(&finished)) })
}

/// The names of the tests.
fn list(arguments: &Arguments, cases: &[Case]) -> Result<(), Failure> {
    let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    match arguments.json {
        true => {
            let place = |case: &Case| serde_json::json!({ "name": case.name, "test_file": case.file, "line": case.line });
            let places: Vec<_> = cases.iter().map(place).collect();
            output::print_json(&serde_json::json!({ "tests": names, "places": places }), true)
        }
        false => output::print(&names.iter().map(|name| format!("{name}\n")).collect::<String>()),
    }
}

/// What is said when no program checks itself.
fn no_tests(programs: usize) -> String {
    let looked = if programs == 1 { "The program has".to_owned() } else { format!("{programs} programs have") };
    format!(
        "No tests found. {looked} neither an assertion (`__ASSERT== MW 10, 5`) nor an end (`CALL SFC 46`),\n\
         and there is no test file: `*.test.st`, a source that begins with `TEST`, or one that `--tests` names.\n"
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
