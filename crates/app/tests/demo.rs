//! `sieben demo` without a terminal, as scripts and pipes see it.

mod command;

use std::process::{Command, Stdio};

use command::{Folder, sieben};

/// A demo with a control socket of its own.
fn demo(folder: &Folder, arguments: &[&str]) -> Command {
    let mut command = sieben(folder.path(), &["demo"]);
    command.args(arguments).env("XDG_RUNTIME_DIR", folder.path());
    command
}

#[test]
fn without_a_terminal_each_change_is_a_line() {
    let output = demo(&Folder::new(), &["--for", "16s", "--speed", "max"]).output().expect("sieben runs");
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
    let folder = Folder::new();
    let mut child = demo(&folder, &["--speed", "max"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("sieben runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("sieben ends");
    assert!(output.status.success());
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn a_speed_that_is_none_is_refused() {
    let output = demo(&Folder::new(), &["--speed", "fast"]).output().expect("sieben runs");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn the_clock_of_the_computer_changes_nothing_about_what_happens() {
    let lines = |speed: &str| {
        let folder = Folder::new();
        let output = demo(&folder, &["--for", "16s", "--speed", speed]).output().expect("sieben runs");
        assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let virtual_time = lines("max");
    for speed in ["100x", "9999x"] {
        assert_eq!(lines(speed), virtual_time, "{speed}");
    }
}
