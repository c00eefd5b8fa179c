//! Clients that others wrote, each a separate program, against a run with a server: what they offer works, or is refused as a CPU would.
//!
//! `cargo xtask clients` installs them below `target/clients/`. Without its client a test is skipped and says so in `target/skipped/`; with `SIEBEN_NO_SKIP=1`
//! that is a failure. The scripts in `tests/clients/` say what they want and what they got.
#![cfg(unix)]

mod command;
mod installed;

use std::fs;
use std::io::{BufRead, BufReader};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use command::{Folder, sieben};
use installed::{finished, is_there, root};
use serde_json::Value;

/// Settings of a server whose CPU is stopped only with the password.
const PROTECTED: &str = "\n[servers.s7]\nprotection = 3\npassword = \"secret\"\n";

fn scripts() -> PathBuf {
    root().join("crates/app/tests/clients")
}

/// How a client is run.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Runs {
    Python,
    Node,
    Built,
    /// A tool of the system.
    Tool,
}

/// The program that runs the script of a client, with the script.
fn script_of(client: &str, runs: Runs) -> Command {
    let installed = root().join("target/clients").join(client);
    match runs {
        Runs::Python => {
            let mut command = Command::new(installed.join("bin/python"));
            command.arg(scripts().join(format!("{client}.py")));
            command
        }
        Runs::Node => {
            let mut command = Command::new("node");
            command.arg(scripts().join(format!("{client}.js"))).env("NODE_PATH", installed.join("node_modules"));
            command
        }
        Runs::Built => Command::new(installed.join("target/debug/client")),
        Runs::Tool => Command::new(client),
    }
}

/// A run with a server, in a folder with the plant that all scripts talk with; it ends with the value.
struct Served {
    folder: Folder,
    child: Child,
    address: SocketAddr,
}

impl Served {
    fn new(servers: &str) -> Self {
        let folder = Folder::new();
        for entry in fs::read_dir(scripts().join("plant")).expect("the plant is there") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().expect("a file has a name").to_string_lossy().into_owned();
            let settings = if name == "sieben.toml" { servers } else { "" };
            folder.write(&name, &[fs::read(&path).expect("a file of the plant"), settings.as_bytes().to_vec()].concat());
        }
        let runtime = folder.path().join("runtime");
        fs::create_dir_all(&runtime).expect("the folder is writable");
        let mut command = sieben(folder.path(), &["serve", ".", "--json", "--s7", "127.0.0.1:0"]);
        command.env("XDG_RUNTIME_DIR", runtime).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child = command.spawn().expect("the binary starts");
        let mut line = String::new();
        BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut line).expect("UTF-8");
        let listening: Value = serde_json::from_str(&line).unwrap_or_else(|error| panic!("{error}: {line}"));
        let address = listening["listening"]["s7"].as_str().and_then(|address| address.parse().ok()).expect("an address");
        Self { folder, child, address }
    }

    fn port(&self) -> String {
        self.address.port().to_string()
    }

    /// Ends the run as a service manager does, so that all files are written.
    fn end(&mut self) {
        let pid = self.child.id().to_string();
        assert!(Command::new("kill").args(["-TERM", &pid]).status().expect("kill exists").success());
        assert_eq!(self.child.wait().expect("the binary ends").code(), Some(0));
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Runs the script of a client in one mode: every check holds, and it came to its end.
fn all_checks_hold(client: &str, runs: Runs, mode: &str, served: &Served) {
    let output = finished(script_of(client, runs).args([&served.port(), mode]));
    let text = String::from_utf8_lossy(&output.stdout);
    let said = format!("{client} {mode}: {:?}\n{text}\n{}", output.status, String::from_utf8_lossy(&output.stderr));
    let checks: Vec<Value> =
        text.lines().map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error} in {line}: {said}"))).collect();
    let wrong: Vec<&Value> = checks.iter().filter(|check| check["ok"] != true).collect();
    assert!(wrong.is_empty(), "{wrong:#?}\n{said}");
    assert!(output.status.success() && checks.last().is_some_and(|check| check["check"] == "end"), "{said}");
}

/// Runs the script of a client in each of these modes: without protection, and with a password.
fn client(client: &str, runs: Runs, modes: &[&str]) {
    if !is_there(client, runs == Runs::Tool) {
        return;
    }
    for mode in modes {
        let served = Served::new(if *mode == "protected" { PROTECTED } else { "" });
        all_checks_hold(client, runs, mode, &served);
    }
}

#[test]
fn python_snap7_takes_it_for_a_cpu() {
    client("python-snap7", Runs::Python, &["all", "protected"]);
}

#[test]
fn the_native_snap7_takes_it_for_a_cpu() {
    client("native-snap7", Runs::Python, &["all", "protected"]);
}

#[test]
fn pys7_takes_it_for_a_cpu() {
    client("pys7", Runs::Python, &["all"]);
}

#[test]
fn nodes7_takes_it_for_a_cpu() {
    client("nodes7", Runs::Node, &["all"]);
}

#[test]
fn nodes7_of_st_one_takes_it_for_a_cpu() {
    client("st-one-nodes7", Runs::Node, &["all"]);
}

#[test]
fn node_snap7_takes_it_for_a_cpu() {
    client("node-snap7", Runs::Node, &["all", "protected"]);
}

#[test]
fn rust7_takes_it_for_a_cpu() {
    client("rust7", Runs::Built, &["all"]);
}

#[test]
fn nmap_shows_every_field() {
    if !is_there("nmap", true) {
        return;
    }
    let served = Served::new("");
    let output = finished(Command::new("nmap").args(["-n", "-Pn", "--script", "+s7-info", "-p", &served.port(), "127.0.0.1"]));
    let text = String::from_utf8_lossy(&output.stdout);
    let fields: Vec<&str> =
        text.lines().filter_map(|line| line.strip_prefix('|')).map(|line| line.trim_start_matches('_').trim()).collect();
    assert_eq!(
        fields,
        [
            "s7-info:",
            "Module: 6ES7 315-2EH14-0AB0",
            "Basic Hardware: 6ES7 315-2EH14-0AB0",
            "Version: 3.2.6",
            "System Name: plant",
            "Module Type: CPU 315-2 PN/DP",
            "Serial Number: 0",
            "Plant Identification: plant",
            "Copyright: Soft PLC",
        ],
        "{text}"
    );
}

/// Frames of a capture that a filter takes, one line each.
fn dissected(capture: &Path, filter: &str) -> Vec<String> {
    let output = finished(Command::new("tshark").arg("-r").arg(capture).args([
        "-Y",
        filter,
        "-T",
        "fields",
        "-e",
        "frame.number",
        "-e",
        "_ws.col.Info",
    ]));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect()
}

#[test]
fn a_dissector_takes_every_telegram_of_a_capture() {
    let (client, runs) = ("native-snap7", Runs::Python);
    if !is_there("tshark", true) || !is_there(client, runs == Runs::Tool) {
        return;
    }
    let mut served = Served::new("\n[servers.s7]\npcap = \"frames.pcapng\"\n");
    all_checks_hold(client, runs, "all", &served);
    served.end();
    let capture = served.folder.path().join("frames.pcapng");
    let lines = dissected(&capture, "s7comm");
    // What the script does is there, in both directions.
    for words in [
        "Read Var",
        "Write Var",
        "Setup communication",
        "Start upload",
        "End upload",
        "Request download",
        "Download block",
        "Download ended",
        "PI-Service",
        "PLC Stop",
        "Read SZL",
        "List blocks of type",
        "Get block info",
        "Set clock",
    ] {
        assert!(lines.iter().any(|line| line.contains(words)), "no telegram with {words}: {lines:#?}");
    }
    assert_eq!(dissected(&capture, "_ws.malformed"), Vec::<String>::new());
    // Nothing but S7 goes over the connections.
    let other = dissected(
        &capture,
        "tcp.len > 0 && !s7comm && !cotp.type == 0x0e && !cotp.type == 0x0d && !cotp.type == 0x08 && !cotp.type == 0x0c",
    );
    assert_eq!(other, Vec::<String>::new());
}

/// A fence of a page that names a file.
fn files_of(page: &str) -> Vec<(String, String)> {
    let (mut files, mut open) = (Vec::new(), None::<(String, String)>);
    for line in page.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(words)) => open = Some((words.split_whitespace().nth(1).unwrap_or_default().to_owned(), String::new())),
            (Some(_), Some(_)) => files.extend(open.take().filter(|(name, _)| !name.is_empty())),
            (Some((_, text)), None) => *text = format!("{text}{line}\n"),
            (None, None) => {}
        }
    }
    files
}

#[test]
fn the_page_about_a_virtual_s7_in_ci_does_what_it_says() {
    let (client, runs) = ("python-snap7", Runs::Python);
    if !is_there(client, runs == Runs::Tool) {
        return;
    }
    let page = fs::read_to_string(root().join("docs/how-to/virtual-s7-in-ci.md")).expect("the page is there");
    let files = files_of(&page);
    let folder = Folder::with(&files.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect::<Vec<_>>());
    let workflow = files.iter().find(|(name, _)| name.ends_with(".yml")).map(|(_, text)| text.as_str()).expect("the page has a workflow");
    let commands: Vec<&str> = workflow.lines().filter_map(|line| line.trim().strip_prefix("- run: ")).collect();
    // What installs programs is done by `cargo xtask clients`; here they are on the path.
    let (installs, does): (Vec<&str>, Vec<&str>) = commands.into_iter().partition(|command| command.contains(" install "));
    assert!(installs.len() == 2 && does.len() >= 3, "{workflow}");
    let programs = [
        Path::new(env!("CARGO_BIN_EXE_sieben")).parent().expect("it lies in a folder").to_path_buf(),
        root().join("target/clients").join(client).join("bin"),
    ];
    let path = std::env::join_paths(programs.into_iter().chain(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default())))
        .expect("folders");
    let runtime = folder.path().join("runtime");
    fs::create_dir_all(&runtime).expect("the folder is writable");
    for command in does {
        let output = finished(
            Command::new("sh").args(["-c", command]).current_dir(folder.path()).env("PATH", &path).env("XDG_RUNTIME_DIR", &runtime),
        );
        let said = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(output.status.success(), "{command}\n{said}");
    }
}
