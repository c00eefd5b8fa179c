//! A campaign on workers through a real NATS server: the same bytes as on threads, also where workers are killed.
#![cfg(feature = "nats")]

mod command;
mod installed;

use std::io::Read as _;
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use command::{Folder, sieben, until};

const COUNTING: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n L MW 12;\n +I;\n T MW 10;\n L MW 10;\n L MW 14;\n >I;\n = Q 4.0;\nEND_ORGANIZATION_BLOCK\n";
const DRAWN: &str = "[campaign]\nname = \"counting\"\nprogram = \"plant\"\nfor = \"5s\"\nseed = 3\nsamples = 60\n[sweep]\n\"MW 12\" = { values = [1, 2] }\n\
                     [draw]\n\"MW 14\" = { uniform = [250, 3000] }\n[[never]]\nname = \"over\"\nexpr = \"Q4.0\"\n\
                     [[measure]]\nname = \"third\"\nof = \"mean\"\nexpr = \"INT_TO_REAL(WORD_TO_INT(MW10)) / 3.0\"\n";

/// A server or worker that ends with the test.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn server(folder: &Folder) -> (Process, String) {
    let port = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr()).expect("a free port").port();
    let store = folder.path().join("store");
    folder.write(
        "nats.conf",
        format!("listen: \"127.0.0.1:{port}\"\njetstream {{ store_dir: \"{}\", max_file: 256MB, max_mem: 64MB }}\n", store.display())
            .as_bytes(),
    );
    let mut command = Command::new("nats-server");
    command.arg("-c").arg(folder.path().join("nats.conf")).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let process = Process(command.spawn().expect("it starts"));
    until("the server greets", || {
        let mut stream = TcpStream::connect(("127.0.0.1", port)).ok()?;
        stream.set_read_timeout(Some(Duration::from_secs(1))).ok()?;
        let mut start = [0; 4];
        stream.read_exact(&mut start).ok().filter(|()| &start == b"INFO")
    });
    (process, format!("nats://127.0.0.1:{port}"))
}

/// A worker in a folder of its own, which has nothing of the campaign.
fn worker(elsewhere: &Folder, url: &str, abort: Option<&str>) -> Process {
    let mut command = sieben(elsewhere.path(), &["worker", "--nats", url, "--threads", "1"]);
    if let Some(at) = abort {
        command.env("SIEBEN_CAMPAIGN_ABORT", at);
    }
    Process(command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("it starts"))
}

#[test]
fn workers_come_to_the_same_bytes_as_threads_also_where_one_is_killed() {
    if !installed::is_there("nats-server", true) {
        return;
    }
    let folder = Folder::with(&[("plant/main.awl", COUNTING), ("c.toml", DRAWN)]);
    let elsewhere = Folder::new();
    folder.run(&["campaign", "run", "c.toml", "--quiet", "--out", "here.parquet"]).code(1);
    let (_server, url) = server(&elsewhere);
    folder.run(&["worker", "--nats", &url, "--ready"]).code(0);
    let _first = worker(&elsewhere, &url, None);
    let mut doomed = worker(&elsewhere, &url, Some("70"));
    let arguments = ["campaign", "run", "c.toml", "--json", "--nats", &url, "--range", "4", "--out", "there.parquet"];
    let result = folder.run(&arguments).code(1).lines().pop().expect("a result");
    assert_eq!((&result["run"], &result["scenarios"]), (&120.into(), &120.into()));
    assert!(folder.read("there.parquet") == folder.read("here.parquet"), "the same bytes");
    // It may have been the other one that took that range.
    let _ = doomed.0.kill();
    // On threads of the run alone.
    folder.run(&["campaign", "run", "c.toml", "--quiet", "--nats", &url, "--workers", "2", "--out", "both.parquet"]).code(1);
    assert!(folder.read("both.parquet") == folder.read("here.parquet"), "the same bytes");
    // What was left of a run on threads goes on here.
    let aborted = sieben(folder.path(), &["campaign", "run", "c.toml", "--quiet", "--range", "3", "--out", "r.parquet"])
        .env("SIEBEN_CAMPAIGN_ABORT", "50")
        .output();
    assert_eq!(aborted.expect("it starts").status.code(), None);
    let resumed =
        folder.run(&["campaign", "run", "c.toml", "--json", "--quiet", "--nats", &url, "--resume", "--out", "r.parquet"]).code(1).json();
    assert!(resumed["resumed"].as_u64().is_some_and(|resumed| resumed > 0), "{resumed}");
    assert!(folder.read("r.parquet") == folder.read("here.parquet"), "the same bytes");
}

#[test]
fn the_failures_with_the_least_numbers_end_a_run_also_where_ranges_come_in_any_order() {
    if !installed::is_there("nats-server", true) {
        return;
    }
    let folder = Folder::with(&[("plant/main.awl", COUNTING), ("c.toml", DRAWN)]);
    let elsewhere = Folder::new();
    let (_server, url) = server(&elsewhere);
    let (_one, _other) = (worker(&elsewhere, &url, None), worker(&elsewhere, &url, None));
    for (failures, range) in [("first", "7"), ("3", "1"), ("20", "50")] {
        let run = |out: &str, more: &[&str]| {
            let of = ["campaign", "run", "c.toml", "--json", "--quiet", "--stop-on", failures, "--out", out];
            folder.run(&of.iter().chain(more).copied().collect::<Vec<_>>()).code(1).json()
        };
        let (here, there) = (run("here.parquet", &[]), run("there.parquet", &["--nats", &url, "--range", range]));
        assert_eq!((&there["run"], &there["fail"]), (&here["run"], &here["fail"]), "{failures}");
        assert!(here["run"].as_u64() < here["scenarios"].as_u64(), "{here}");
        assert!(folder.read("there.parquet") == folder.read("here.parquet"), "{failures}: the same bytes");
        ["here.parquet", "there.parquet"].iter().for_each(|name| std::fs::remove_file(folder.path().join(name)).expect("it is there"));
    }
    // What an earlier run left counts in its place.
    folder.run(&["campaign", "run", "c.toml", "--quiet", "--stop-on", "9", "--out", "here.parquet"]).code(1);
    let aborted = sieben(folder.path(), &["campaign", "run", "c.toml", "--quiet", "--range", "2", "--out", "r.parquet"])
        .env("SIEBEN_CAMPAIGN_ABORT", "12")
        .output();
    assert_eq!(aborted.expect("it starts").status.code(), None);
    let more = ["--resume", "--stop-on", "9", "--nats", &url, "--range", "5", "--out", "r.parquet"];
    folder.run(&["campaign", "run", "c.toml", "--quiet"].into_iter().chain(more).collect::<Vec<_>>()).code(1);
    assert!(folder.read("r.parquet") == folder.read("here.parquet"), "the same bytes");
}

#[test]
fn what_cannot_be_is_said_in_a_sentence() {
    let folder = Folder::with(&[("plant/main.awl", COUNTING), ("c.toml", DRAWN)]);
    let nats = |more: &[&str]| {
        let arguments: Vec<&str> = ["campaign", "run", "c.toml", "--quiet"].iter().chain(more).copied().collect();
        folder.run(&arguments).code(2)
    };
    nats(&["--nats"]).stderr("there is no address of a NATS server");
    nats(&["--lock", "outputs.lock"]).stderr("`--lock` is not there yet");
    nats(&["--nats", "nats://127.0.0.1:1", "--cpu", "416-3"]).stderr("workers know of the program what its files say");
    nats(&["--nats", "nats://anna:secret@127.0.0.1:1"]).stderr("[P7165]");
    let refused = folder.run(&["worker", "--nats", "nats://anna:secret@127.0.0.1:1", "--ready"]).code(2).stderr("[P7165]");
    assert!(!refused.stderr.contains("secret"), "{}", refused.stderr);
    folder.run(&["worker"]).code(2).stderr("SIEBEN_NATS");
}
