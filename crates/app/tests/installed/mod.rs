//! Programs of other people that tests talk with, as `cargo xtask clients` installs them.
#![allow(clippy::print_stdout)] // A test that is skipped says so.
#![allow(dead_code)] // Not every test file uses all of it.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Far more than any client takes, also on a busy machine.
const DEADLINE: Duration = Duration::from_secs(180);

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the crate lies in the project")
}

/// Whether a client, or a tool of the system, is installed; notes that its test is skipped if not.
pub(crate) fn is_there(client: &str, is_tool: bool) -> bool {
    let there = match is_tool {
        true => Command::new(client).arg("--version").output().is_ok_and(|output| output.status.success()),
        false => root().join("target/clients").join(client).join("installed").is_file(),
    };
    if !there {
        let line = format!("skipped: {client} is not installed (`cargo xtask clients`)");
        assert!(std::env::var_os("SIEBEN_NO_SKIP").is_none_or(|value| value != "1"), "{line}");
        let folder = root().join("target/skipped");
        fs::create_dir_all(&folder).and_then(|()| fs::write(folder.join(client), format!("{line}\n"))).expect("target/ is writable");
        println!("{line}");
    }
    there
}

/// Runs a command to its end, which must come in time.
pub(crate) fn finished(command: &mut Command) -> Output {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the client starts");
    let (mut stdout, mut stderr) = (child.stdout.take().expect("a pipe"), child.stderr.take().expect("a pipe"));
    let read = |pipe: &mut dyn Read| {
        let mut bytes = Vec::new();
        pipe.read_to_end(&mut bytes).expect("a pipe can be read");
        bytes
    };
    let begun = Instant::now();
    std::thread::scope(|scope| {
        let (out, err) = (scope.spawn(move || read(&mut stdout)), scope.spawn(move || read(&mut stderr)));
        let status = loop {
            if let Some(status) = child.try_wait().expect("the client is ours") {
                break status;
            }
            if begun.elapsed() > DEADLINE {
                let _ = child.kill();
            }
            std::thread::sleep(Duration::from_millis(20));
        };
        Output { status, stdout: out.join().expect("no panic"), stderr: err.join().expect("no panic") }
    })
}
