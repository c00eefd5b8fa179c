//! `cargo xtask soak`: what takes longer than a test may, and proves more.

pub mod kill;
mod long_run;

use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::programs::{self, Build};
use crate::{fuzz, web, workspace};

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<(), String> {
    let options = read_options(arguments)?;
    match options.name.as_str() {
        "kill" => kill_runs(&options),
        "run" => {
            let folder = std::env::temp_dir().join(format!("sieben-soak-run-{}", std::process::id()));
            long_run::run(&programs::sieben(options.binary.as_ref(), Build::Debug)?, &folder, options.time)
        }
        "page" => web::soak(options.binary, options.time),
        "fuzz" => fuzz_rounds(options.time),
        "programs" => many_programs(options.times),
        unknown => Err(format!("`{unknown}` is no soak: kill, run, page, fuzz or programs")),
    }
}

struct Options {
    name: String,
    count: u32,
    time: Duration,
    times: u32,
    binary: Option<PathBuf>,
}

fn read_options(arguments: &[String]) -> Result<Options, String> {
    let (name, rest) = arguments.split_first().ok_or("say what: `cargo xtask soak kill`")?;
    let mut options = Options { name: name.clone(), count: 1000, time: Duration::from_secs(3600), times: 10, binary: None };
    let mut words = rest.iter();
    while let Some(word) = words.next() {
        let mut value = |what: &str| words.next().cloned().ok_or(format!("`{word}` is followed by {what}"));
        match word.as_str() {
            "--count" => {
                let text = value("a number")?;
                options.count = text.parse().map_err(|_| format!("`{text}` is not a number"))?;
            }
            "--minutes" => {
                let text = value("a number")?;
                let minutes: u32 = text.parse().map_err(|_| format!("`{text}` is not a number"))?;
                options.time = Duration::from_secs(60) * minutes;
            }
            "--times" => {
                let text = value("a number")?;
                options.times = text.parse().map_err(|_| format!("`{text}` is not a number"))?;
            }
            "--binary" => options.binary = Some(value("a file")?.into()),
            unknown => return Err(format!("`{unknown}` is no option of soak: --count, --minutes, --times or --binary")),
        }
    }
    Ok(options)
}

fn kill_runs(options: &Options) -> Result<(), String> {
    let binary = programs::sieben(options.binary.as_ref(), Build::Debug)?;
    let began = Instant::now();
    // Both ways: once with a thread that syncs, once with a sync in every scan.
    for (sync, kills) in [("1s", options.count - options.count / 4), ("0ms", options.count / 4)] {
        let folder = std::env::temp_dir().join(format!("sieben-soak-kill-{}", std::process::id()));
        let outcome = kill::run(&binary, &folder, kills, sync, |outcome| {
            if outcome.kills.is_multiple_of(100) {
                println!("soak kill: {} kills, {} scans, {:.0} s", outcome.kills, outcome.scans, began.elapsed().as_secs_f64());
            }
        })?;
        println!(
            "soak kill: sync {sync}: {} kills ({} before the first scan), {} scans; every run began with one whole scan's data\n  \
             of {} runs that were looked at before the kill, {} lost the scan that was running, none lost more",
            outcome.kills, outcome.early, outcome.scans, outcome.looked_at, outcome.scans_lost
        );
    }
    Ok(())
}

/// Seconds of one round over all fuzz targets.
const ROUND_SECONDS: u64 = 300;

/// Runs all fuzz targets, round after round, each with other inputs.
fn fuzz_rounds(time: Duration) -> Result<(), String> {
    let began = Instant::now();
    // Rounds of a later soak shall have other inputs than those of this one.
    let first = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(1, |since| since.as_secs());
    for round in 0.. {
        let left = time.saturating_sub(began.elapsed()).as_secs();
        if left == 0 {
            break;
        }
        let seconds = left.min(ROUND_SECONDS).to_string();
        fuzz::run(&["--seconds".to_owned(), seconds, "--seed".to_owned(), (first + round).to_string()])?;
    }
    Ok(())
}

/// Tests of many programs that make more of them when `SIEBEN_TIMES` says so.
const MANY_PROGRAMS: &[&[&str]] = &[
    &["-p", "sieben-jit", "--test", "programs"],
    &["-p", "sieben-app", "--test", "chosen_methods", "--test", "handed_values", "--test", "st_lost_tokens", "--test", "lsp"],
];

/// Runs so many times as many programs as the tests do.
fn many_programs(times: u32) -> Result<(), String> {
    for test in MANY_PROGRAMS {
        let mut command = Command::new(env!("CARGO"));
        command.arg("test").args(*test).env("SIEBEN_TIMES", times.to_string()).current_dir(workspace::root());
        let status = command.status().map_err(|error| format!("cannot start cargo: {error}"))?;
        if !status.success() {
            return Err("soak programs: a test failed, and says above for which program".to_owned());
        }
    }
    Ok(())
}
