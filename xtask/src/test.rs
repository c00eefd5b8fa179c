//! `cargo xtask test`: builds everything and runs all tests.

use std::process::Command;

/// Runs the tests with nextest where it is installed, else with `cargo test`.
pub fn run(arguments: &[String]) -> Result<(), String> {
    let nextest = Command::new(cargo()).args(["nextest", "--version"]).output().is_ok_and(|output| output.status.success());
    if nextest {
        cargo_run(&["nextest", "run", "--workspace", "--no-fail-fast"], arguments)?;
        // nextest does not run the examples in doc comments.
        if arguments.is_empty() { cargo_run(&["test", "--quiet", "--workspace", "--doc"], &[]) } else { Ok(()) }
    } else {
        cargo_run(&["test", "--workspace", "--no-fail-fast"], arguments)
    }
}

fn cargo_run(command: &[&str], arguments: &[String]) -> Result<(), String> {
    println!("cargo {}", command.iter().copied().chain(arguments.iter().map(String::as_str)).collect::<Vec<_>>().join(" "));
    let status = Command::new(cargo()).args(command).args(arguments).status().map_err(|error| format!("cannot start cargo: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("cargo {} failed", command[0])) }
}

/// The cargo that started us, so that the toolchain stays the same.
fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}
