//! `sieben demo` without a terminal, as scripts and pipes see it.

use std::process::{Command, Stdio};

fn demo(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sieben"));
    command.arg("demo").args(arguments).stdin(Stdio::null());
    command
}

#[test]
fn without_a_terminal_each_change_is_a_line() {
    let output = demo(&["--for", "16s", "--speed", "max"]).output().expect("sieben runs");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(output.status.success(), "{text}");
    for line in [
        "4    Q 0.0           Y1                  Dosing valve          1 opens",
        "scan 300 (3.00 s): the demo presses START",
        "scan 301 (3.01 s): Q 0.0 0→1 (Dosing valve)",
        "scan 301 (3.01 s): C 0 0→25 (Litres left)",
        "1,600 scans in 16.00 s of the plant, 25.0 litres through the valve.",
    ] {
        assert!(text.lines().any(|written| written == line), "`{line}` is missing in\n{text}");
    }
    assert!(text.contains(": Q 0.0 1→0 (Dosing valve)\n"), "{text}");
}

#[test]
fn a_reader_that_goes_away_ends_the_demo_quietly() {
    let mut child = demo(&["--speed", "max"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("sieben runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("sieben ends");
    assert!(output.status.success());
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn a_speed_that_is_none_is_refused() {
    let output = demo(&["--speed", "fast"]).output().expect("sieben runs");
    assert_eq!(output.status.code(), Some(2));
}
