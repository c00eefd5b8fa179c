//! `sieben campaign run`: the scenarios of a campaign on threads.

use std::ffi::OsString;
use std::num::NonZero;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::Args;
#[cfg(feature = "parquet")]
use serde_json::json;
use sieben_model::problems::Problem;

use super::opened::{Opened, open, wanted};
use super::progress::Progress;
use crate::arguments::ProgramArguments;
use crate::campaign::collected::{Collected, Collector};
use crate::campaign::failing::{self, Small};
#[cfg(feature = "parquet")]
use crate::campaign::files::{Kept, Start, Wanted};
use crate::campaign::said::Run;
use crate::campaign::{Ended, Orders};
use crate::duration::duration_argument;
use crate::engines::EngineArgument;
use crate::failure::{Exit, Failure};
use crate::{output, terminal};

/// Run the scenarios of a campaign.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben campaign run oven.toml                    all of it, on all processors\n  \
  sieben campaign run oven.toml --only 0..999      the first thousand\n  \
  sieben campaign run oven.toml --stop-on first    the failure with the least number\n  \
  sieben campaign run oven.toml --out r.parquet    a row of each scenario, kept as it comes\n  \
  sieben campaign run oven.toml --json             lines of progress, then the result\n\n\
What comes of it does not depend on threads, engine or machine: a scenario is a function of\n\
the program, the file, the seed and its number.\n\n\
Exit codes: 0 all held, 1 a property broke or what has to come sometimes never came, 2 usage,\n\
3 does not compile, 5 the time is used up, 70 a fault of ours, 130 Ctrl+C (`--resume` goes on after 5 and 130).")]
pub(super) struct Arguments {
    /// The file of the campaign
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    #[command(flatten)]
    program: ProgramArguments,
    /// Threads of this computer [default: one for each processor, with `--nats` none]
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
    /// Keep what comes of it in this Parquet file; while it runs, in the folder FILE.part
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Go on with what an earlier run left in FILE.part; without it, begin
    #[arg(long, requires = "out")]
    resume: bool,
    /// The combinations of outputs that can be reached, as a file for reviews
    #[arg(long, value_name = "FILE", hide = true)]
    lock: Option<PathBuf>,
    #[command(flatten)]
    #[cfg(feature = "nats")]
    server: crate::campaign::farmed::ServerArguments,
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

/// Runs them.
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    if arguments.lock.is_some() {
        let told = "`--lock` is not there yet: it needs all states that can be reached, and `[exhaustive]` goes from the first scan alone";
        return Err(Failure::usage(Problem::P7001, told)
            .help("leave `--lock` out; `[[never]]` and `[[always]]` say which outputs may come together"));
    }
    let opened = match open(&arguments.spec, &arguments.program, arguments.seed, arguments.engine, arguments.json)? {
        Ok(opened) => opened,
        Err(exit) => return Ok(exit),
    };
    let numbers = wanted(&opened.campaign, arguments.only)?;
    let cancelled = terminal::interrupted();
    let orders = Orders {
        workers: terminal::threads(arguments.workers),
        range: arguments.range,
        stop_after: arguments.stop_on.0,
        budget: arguments.budget,
        checked: arguments.engine != EngineArgument::Interpreter,
        abort: crate::campaign::abort(),
        cancelled: &cancelled,
    };
    let mut running =
        Running { cancelled: &cancelled, arguments, opened: &opened, asked: numbers.end - numbers.start, begun: Instant::now() };
    match &arguments.out {
        None => {
            let mut collector = Collector::new(&opened.campaign, numbers, Vec::new(), None);
            let ended = running.scenarios(&orders, &mut collector, Vec::new())?;
            let collected = collector.into_collected();
            running.end(&collected, ended, &running.failures(&collected, ended))
        }
        Some(out) => running.kept(out, numbers, &orders),
    }
}

/// A run under way.
struct Running<'a> {
    cancelled: &'a AtomicBool,
    arguments: &'a Arguments,
    opened: &'a Opened,
    asked: u64,
    begun: Instant,
}

impl Running<'_> {
    /// Runs what the collector does not have; `digests` tells the bytes of what an earlier run left.
    fn scenarios(
        &mut self,
        orders: &Orders<'_>,
        collector: &mut Collector<'_>,
        digests: Vec<(Range<u64>, String)>,
    ) -> Result<Ended, Failure> {
        #[cfg(feature = "nats")]
        if self.arguments.server.is_asked_for() {
            return self.farmed(orders, collector, digests);
        }
        // Only a queue brings what is there already.
        drop(digests);
        let mut progress = Progress::new(self.asked, self.arguments.json, self.arguments.quiet);
        let ended = crate::campaign::run(&self.opened.campaign, orders, collector, &mut |collected| progress.tell(collected));
        progress.end();
        ended
    }

    /// Runs it on whatever workers a queue has, and on threads here if they are asked for.
    #[cfg(feature = "nats")]
    fn farmed(&mut self, orders: &Orders<'_>, collector: &mut Collector<'_>, digests: Vec<(Range<u64>, String)>) -> Result<Ended, Failure> {
        use sieben_campaign::identity::MEANING;
        use sieben_farm::{Options, WorkerOrders};

        use crate::campaign::farmed::{self, Working};
        use crate::campaign::said;

        let Self { arguments, opened, .. } = self;
        if arguments.program.says_more() {
            let told = "workers know of the program what its files say, and not what this command line adds";
            return Err(Failure::usage(Problem::P7001, told).help("write CPU type, mnemonics and dialect into `sieben.toml`"));
        }
        let server = arguments.server.server()?;
        let farmed = farmed::Orders {
            server: server.clone(),
            range: arguments.range,
            stop_after: orders.stop_after,
            budget: orders.budget,
            cancelled: orders.cancelled,
        };
        let mut progress = Progress::new(self.asked, arguments.json, arguments.quiet);
        let (done, quiet, campaign) = (AtomicBool::new(false), arguments.quiet || arguments.json, &opened.campaign);
        let mut none = true;
        let mut alive = |workers: &sieben_farm::Workers| {
            if std::mem::replace(&mut none, workers.alive == 0) != none && !quiet {
                let told = match workers.alive {
                    0 => "no worker is there any more: start some by `sieben worker --nats URL`".to_owned(),
                    count => format!("{} of {}", said::several(count as u64, "worker"), said::several(workers.threads, "thread")),
                };
                output::message(&format!("{told}\n"));
            }
        };
        if !quiet && arguments.workers.is_none() {
            output::message("waiting for workers: start some by `sieben worker --nats URL`\n");
        }
        let (ended, finished) = std::thread::scope(|scope| {
            if let Some(threads) = arguments.workers {
                let identity = campaign.identity.campaign.clone();
                let here = WorkerOrders { threads, campaign: Some(identity), idle_exit: None, meaning: MEANING, name: said::computer() };
                let (server, done, engine, abort) = (&server, &done, arguments.engine, orders.abort);
                scope.spawn(move || {
                    let open = move |offer: &sieben_farm::Offer| Working::open(offer, engine, abort);
                    // The run says itself what is wrong with the server.
                    let _ = sieben_farm::work(server, &Options::default(), &here, &open, &|| done.load(Ordering::Relaxed), &mut |_| {});
                });
            }
            let came =
                farmed::run(campaign, &opened.text, &farmed, collector, digests, &mut |collected| progress.tell(collected), &mut alive);
            done.store(true, Ordering::Relaxed);
            came
        })?;
        progress.end();
        if let Some(alarm) = finished.alarms.first() {
            let (from, last) = (alarm.range.start, alarm.range.end - 1);
            let told = format!("scenarios {from} to {last} came twice with different results; the second came from `{}`", alarm.worker);
            let help = "remove that worker, or report it: a scenario must come to the same on every machine";
            return Err(Failure { exit: Exit::Internal, ..Failure::usage(Problem::P7169, told).help(help) });
        }
        Ok(ended)
    }

    #[cfg(feature = "parquet")]
    fn kept(&mut self, out: &std::path::Path, numbers: Range<u64>, orders: &Orders<'_>) -> Result<Exit, Failure> {
        let campaign = &self.opened.campaign;
        let wanted =
            Wanted { result: out, resume: self.arguments.resume, numbers: numbers.clone(), counts_failures: orders.stop_after.is_some() };
        let (mut kept, left) = match Kept::open(&wanted, campaign)? {
            Start::Whole(collected) => return self.end(&collected, Ended::Whole, &self.failures(&collected, Ended::Whole)),
            Start::Run(kept, left) => (kept, left),
        };
        let digests = kept.digests();
        let mut collector = Collector::new(campaign, numbers, left, Some(kept.store()));
        let ended = self.scenarios(orders, &mut collector, digests)?;
        let collected = collector.into_collected();
        let failures = self.failures(&collected, ended);
        if matches!(ended, Ended::Whole | Ended::Failures) {
            let how = json!({
                "failures": failures.iter().map(|(small, path)| small.json(path.as_deref())).collect::<Vec<_>>(),
                "version": env!("CARGO_PKG_VERSION"), "seconds": self.begun.elapsed().as_secs_f64(), "workers": orders.workers,
                "resumed": collected.resumed, "duplicates": collected.duplicates,
            });
            kept.finish(campaign, &self.opened.name, &self.opened.text, &collected, &how)?;
        }
        self.end(&collected, ended, &failures)
    }

    #[cfg(not(feature = "parquet"))]
    fn kept(&mut self, _: &std::path::Path, _: Range<u64>, _: &Orders<'_>) -> Result<Exit, Failure> {
        Err(super::without_files())
    }

    /// Makes what failed small, and writes it down.
    fn failures(&self, collected: &Collected, ended: Ended) -> Vec<(Small, Option<PathBuf>)> {
        if ended == Ended::Cancelled {
            return Vec::new();
        }
        let Opened { campaign, name, folder, .. } = self.opened;
        let all = failing::all(campaign, collected, &|| self.cancelled.load(Ordering::Relaxed));
        let paths = failing::write(&all, folder, name, campaign.spec.seed).unwrap_or_else(|failure| {
            // The result is there; a folder that may not be written to does not take it away.
            output::message(&format!("{}\n", failure.refusal.message));
            Vec::new()
        });
        let paths = paths.into_iter().map(Some).chain(std::iter::repeat(None));
        all.into_iter().zip(paths).collect()
    }

    /// Says what came of it.
    fn end(&self, collected: &Collected, ended: Ended, failures: &[(Small, Option<PathBuf>)]) -> Result<Exit, Failure> {
        let Self { arguments, opened, asked, begun, .. } = self;
        let (campaign, tally) = (&opened.campaign, &collected.tally);
        let file = arguments.spec.display().to_string();
        if let Ended::Differs(number) = ended {
            let told = format!("scenario {number} comes to something else in the interpreter than in machine code");
            let help = format!("this is our mistake; please report it with `sieben campaign show {file} {number}` and the program");
            return Err(Failure { exit: Exit::Internal, ..Failure::usage(Problem::P7179, told).help(help) });
        }
        let written: Vec<(u64, PathBuf)> = failures.iter().filter_map(|(small, path)| Some((small.number, path.clone()?))).collect();
        let run = Run { written: &written, campaign, name: &opened.name, file: &file, asked: *asked, collected, took: begun.elapsed() };
        match arguments.json {
            true => output::print_json(&run.json(), false)?,
            false => output::print(&run.text())?,
        }
        let goes_on = matches!(ended, Ended::Cancelled | Ended::Budget);
        if goes_on && arguments.out.is_some() {
            output::message(&format!("`{}` goes on with it\n", resuming(std::env::args_os().collect())));
        }
        Ok(match ended {
            Ended::Cancelled => Exit::Interrupted,
            Ended::Budget => Exit::BudgetUsedUp,
            Ended::Differs(_) => Exit::Internal,
            Ended::Whole | Ended::Failures => {
                // What did not come in a part may come in another one.
                let missing = arguments.only.is_none() && ended == Ended::Whole && tally.never_came(&campaign.spec).next().is_some();
                if tally.failures() == 0 && !missing { Exit::Success } else { Exit::CheckFailed }
            }
        })
    }
}

/// The command that goes on with what this one left.
fn resuming(arguments: Vec<OsString>) -> String {
    let mut words: Vec<String> = std::iter::once("sieben".to_owned())
        .chain(arguments.iter().skip(1).map(|argument| argument.to_string_lossy().into_owned()))
        .map(|word| {
            if word.contains(|c: char| c.is_whitespace() || "'\"$`\\*?;&|<>()".contains(c)) {
                format!("'{}'", word.replace('\'', "'\\''"))
            } else {
                word
            }
        })
        .collect();
    if !words.iter().any(|word| word == "--resume") {
        words.push("--resume".to_owned());
    }
    words.join(" ")
}
