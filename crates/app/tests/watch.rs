//! `run --watch` and `check --against`, as their users call them.
#![cfg(unix)]

mod command;

use std::io::{BufRead, BufReader};
use std::process::{Child, ChildStderr, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use command::{Folder, sieben};

/// Far more than a change takes, also on a busy machine.
const DEADLINE: Duration = Duration::from_secs(60);

/// A program that counts in DB 1, in steps of its own.
fn counting(fields: &str, step: u32) -> String {
    format!(
        "DATA_BLOCK DB 1\nSTRUCT\n {fields}\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n\
         ORGANIZATION_BLOCK OB 1\nBEGIN\nL DB1.n; L {step}; +I; T DB1.n; T MW 10;\nEND_ORGANIZATION_BLOCK\n"
    )
}

/// A run whose messages are read while it goes on.
struct Running {
    child: Child,
    lines: Receiver<String>,
    seen: Vec<String>,
}

impl Running {
    fn start(folder: &Folder, arguments: &[&str]) -> Self {
        let mut child = sieben(folder.path(), arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the binary starts");
        let stderr: ChildStderr = child.stderr.take().expect("stderr is a pipe");
        let (sender, lines) = channel();
        std::thread::spawn(move || BufReader::new(stderr).lines().map_while(Result::ok).try_for_each(|line| sender.send(line)));
        Self { child, lines, seen: Vec::new() }
    }

    /// Waits for a message that contains this.
    #[track_caller]
    fn until(&mut self, part: &str) {
        loop {
            let Ok(line) = self.lines.recv_timeout(DEADLINE) else { panic!("no message contains `{part}`:\n{}", self.seen.join("\n")) };
            let found = line.contains(part);
            self.seen.push(line);
            if found {
                return;
            }
        }
    }

    /// Ends the run as Ctrl-C does; what it printed as its result.
    fn stop(self) -> String {
        let killed = Command::new("kill").args(["-INT", &self.child.id().to_string()]).status().expect("kill exists");
        assert!(killed.success());
        let output = self.child.wait_with_output().expect("the binary ends");
        assert_eq!(output.status.code(), Some(0), "{}", self.seen.join("\n"));
        String::from_utf8(output.stdout).expect("UTF-8 on stdout")
    }
}

#[test]
fn changed_sources_take_over_while_the_program_runs() {
    for (speed, engine) in [("1x", "auto"), ("max", "jit"), ("20x", "interpreter")] {
        let folder = Folder::with(&[("count.awl", &counting("n : INT;", 1))]);
        let mut run = Running::start(&folder, &["run", ".", "--watch", "--speed", speed, "--engine", engine]);
        run.until("Running");
        folder.write("count.awl", counting("more : DINT; n : INT;", 0).as_bytes());
        run.until("The sources have changed: OB 1 changed, DB 1 changed.");
        run.until("Taken over; all values are kept.");
        // What does not compile changes nothing, and can be mended.
        folder.write("count.awl", b"ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW;\nEND_ORGANIZATION_BLOCK\n");
        run.until("the program that runs goes on unchanged");
        folder.write("extra.awl", b"FUNCTION FC 9 : VOID\nBEGIN\nEND_FUNCTION\n");
        folder.write("count.awl", counting("more : DINT; n : INT;", 2).as_bytes());
        run.until("OB 1 changed, FC 9 added");
        run.until("Taken over");
        // Here is nobody who could be asked.
        folder.write("count.awl", counting("n : DINT;", 2).replace("+I", "+D").as_bytes());
        run.until("DB1.more (DINT): it is not in the new sources");
        run.until("DB1.n (INT → DINT): its type changes, so it begins with its initial value");
        run.until("Not taken over: values would be lost.");
        assert!(run.stop().starts_with("RUN: stopped by Ctrl-C"));
    }
}

#[test]
fn losses_can_be_accepted_beforehand() {
    let folder = Folder::with(&[("count.awl", &counting("n : INT;", 1))]);
    let mut run = Running::start(&folder, &["run", "count.awl", "--watch", "--accept-losses"]);
    run.until("Running");
    folder.write("count.awl", counting("n : DINT;", 2).replace("+I", "+D").as_bytes());
    run.until("DB1.n (INT → DINT)");
    run.until("Taken over; all other values are kept.");
    // A STOP after a change shows the line of the new sources.
    folder.write("count.awl", b"ORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0;\nL 5;\nCALL SFC 46;\nEND_ORGANIZATION_BLOCK\n");
    run.until("count.awl:5:");
    let output = run.child.wait_with_output().expect("the binary ends");
    assert_eq!(output.status.code(), Some(4));
}

#[test]
fn a_run_in_json_counts_the_changes() {
    let folder = Folder::with(&[("count.awl", &counting("n : INT;", 1))]);
    let run = Running::start(&folder, &["run", ".", "--watch", "--json", "--for", "3s"]);
    let output = run.child.wait_with_output().expect("the binary ends");
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((&result["mode"], &result["online_changes"]), (&"RUN".into(), &0.into()));
}

#[test]
fn check_lists_what_a_change_would_do() {
    let folder = Folder::with(&[("old.awl", &counting("n : INT; gone : WORD;", 1)), ("new.awl", &counting("n : INT;", 2))]);
    let text =
        "OB 1 changed, DB 1 changed.\nWhat cannot be kept:\n  DB1.gone (WORD): it is not in the new sources\nAll other values are kept.\n";
    assert_eq!(folder.run(&["check", "new.awl", "--against", "old.awl"]).code(0).stdout, text);
    let json = folder.run(&["check", "new.awl", "--against", "old.awl", "--json"]).code(0).json();
    assert_eq!(json["online_change"]["losses"][0]["name"], "gone");
    assert_eq!(json["online_change"]["blocks"][0], serde_json::json!({ "block": "OB 1", "change": "changed" }));
    assert_eq!(json["diagnostics"], serde_json::json!([]));
    assert_eq!(folder.run(&["check", "new.awl", "--against", "new.awl"]).code(0).stdout, "No block is different.\nAll values are kept.\n");
    folder.write("broken.awl", b"L MW\n");
    folder.run(&["check", "new.awl", "--against", "broken.awl"]).code(3).stderr("broken.awl");
    folder.run(&["check", "broken.awl", "--against", "new.awl"]).code(3).stderr("broken.awl");
    folder.run(&["check", "new.awl", "--against", "nowhere"]).code(2).stderr("P6001");
    folder.run(&["run", "new.awl", "--accept-losses"]).code(2);
}
