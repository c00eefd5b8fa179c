//! `cargo xtask test`: builds everything and runs all tests.

use std::fs;
use std::process::Command;

use crate::{clients, programs, vscode, web};

/// Runs the tests with nextest where it is installed, else with `cargo test`. With `--all` what they can use of other people's programs is installed
/// first, and campaigns of examples run whole. The page and the extension for VS Code are tested after the rest. Says at the end what was skipped.
pub fn run(arguments: &[String]) -> Result<(), String> {
    let (all, arguments): (Vec<_>, Vec<_>) = arguments.iter().cloned().partition(|argument| argument == "--all");
    if !all.is_empty() {
        clients::run()?;
    }
    // What an earlier run skipped.
    let _ = fs::remove_dir_all(programs::skipped());
    let mut outcome = run_tests(&arguments, !all.is_empty());
    // A choice of tests is one of the Rust tests.
    if !all.is_empty() && arguments.is_empty() {
        let of_page = web::tests(&[]);
        let of_extension = vscode::tests(&[]);
        outcome = outcome.and(of_page).and(of_extension);
    }
    for line in lines_of_skipped() {
        println!("{line}");
    }
    outcome
}

/// What tells the tests to run all of it where a part is enough otherwise.
const WHOLE: &str = "SIEBEN_WHOLE";

fn run_tests(arguments: &[String], is_whole: bool) -> Result<(), String> {
    let cargo_run = |command: &[&str], arguments: &[String]| cargo_run(command, arguments, is_whole);
    let nextest = Command::new(cargo()).args(["nextest", "--version"]).output().is_ok_and(|output| output.status.success());
    if nextest {
        cargo_run(&["nextest", "run", "--workspace", "--no-fail-fast"], arguments)?;
        // nextest does not run the examples in doc comments.
        if arguments.is_empty() { cargo_run(&["test", "--quiet", "--workspace", "--doc"], &[]) } else { Ok(()) }
    } else {
        cargo_run(&["test", "--workspace", "--no-fail-fast"], arguments)
    }
}

fn lines_of_skipped() -> Vec<String> {
    let entries = fs::read_dir(programs::skipped()).into_iter().flatten().flatten();
    let mut lines: Vec<String> = entries
        .filter_map(|entry| fs::read_to_string(entry.path()).ok())
        .flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>())
        .collect();
    lines.sort();
    lines.dedup();
    lines
}

fn cargo_run(command: &[&str], arguments: &[String], is_whole: bool) -> Result<(), String> {
    println!("cargo {}", command.iter().copied().chain(arguments.iter().map(String::as_str)).collect::<Vec<_>>().join(" "));
    let whole = is_whole.then_some((WHOLE, "1"));
    let status =
        Command::new(cargo()).args(command).args(arguments).envs(whole).status().map_err(|error| format!("cannot start cargo: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("cargo {} failed", command[0])) }
}

/// The cargo that started us, so that the toolchain stays the same.
pub(crate) fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}
