//! What a NATS server costs a campaign: `cargo bench -p sieben-app --bench campaign_nats [-- SAMPLES]`.
//!
//! The same scenarios run on one thread, and on one thread of a worker that gets them over a server of this computer, in alternation.
//! What counts is processor time: of the run alone, and of worker and server. It needs `nats-server`.
#![allow(clippy::print_stdout)] // A measurement prints its figures.
#![cfg(target_os = "linux")]

use std::fs;
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Scenarios of 1,000 scans.
const SAMPLES: u64 = 40_000;
/// How often each is measured.
const ROUNDS: usize = 3;
/// Scenarios of a range, a quarter of a second of work and more.
const RANGES: [u64; 2] = [1_000, 4_000];

fn program() -> String {
    let statements = "A I 0.0;\n AN M 0.1;\n = M 0.1;\n L MW 20;\n L 3;\n +I;\n T MW 20;\n";
    format!("ORGANIZATION_BLOCK OB 1\nBEGIN\n{}END_ORGANIZATION_BLOCK\n", statements.repeat(14))
}

fn spec(samples: u64) -> String {
    format!(
        "[campaign]\nname = \"bench\"\nprogram = \"main.awl\"\nfor = \"10s\"\nsamples = {samples}\nseed = 1\nkeep = \"failures\"\n\
         [draw]\n\"MW 20\" = {{ uniform = [0, 100] }}\n[[never]]\nname = \"never\"\nexpr = \"M0.1 AND NOT M0.1\"\n"
    )
}

fn sieben(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sieben"));
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    command
}

/// Seconds that a process has computed so far.
fn computed(process: &Child) -> f64 {
    let stat = fs::read_to_string(format!("/proc/{}/stat", process.id())).expect("the process is there");
    // The name of the process may have spaces; user and system time are the 12th and 13th word after it, in hundredths.
    let times = stat.rsplit(") ").next().unwrap_or_default().split(' ').skip(11).take(2);
    times.map(|word| word.parse::<f64>().expect("a number") / 100.0).sum()
}

/// Runs a process to its end; the seconds that it computed, looked at until it ended.
fn to_the_end(mut command: Command) -> f64 {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::inherit()).spawn().expect("the binary starts");
    let mut seconds = 0.0;
    while child.try_wait().expect("it is a child").is_none() {
        seconds = computed(&child);
        sleep(Duration::from_millis(5));
    }
    let Output { status, stdout, .. } = child.wait_with_output().expect("it ended");
    assert!(status.success(), "{}", String::from_utf8_lossy(&stdout));
    seconds
}

fn main() {
    let samples = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(SAMPLES);
    let folder = std::env::temp_dir().join(format!("sieben-bench-nats-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("the folder for temporary files is writable");
    let port = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr()).expect("a free port").port();
    let server = format!("listen: \"127.0.0.1:{port}\"\njetstream {{ store_dir: \"{}\" }}\n", folder.join("store").display());
    for (name, text) in [("main.awl", program()), ("bench.toml", spec(samples)), ("nats.conf", server)] {
        fs::write(folder.join(name), text).expect("the folder is writable");
    }
    let url = format!("nats://127.0.0.1:{port}");
    let mut command = Command::new("nats-server");
    command.arg("-c").arg(folder.join("nats.conf")).stdout(Stdio::null()).stderr(Stdio::null());
    let mut server = command.spawn().expect("nats-server is installed");
    let begun = Instant::now();
    while TcpStream::connect(("127.0.0.1", port)).is_err() {
        assert!(begun.elapsed() < Duration::from_secs(10), "the server does not answer");
        sleep(Duration::from_millis(20));
    }
    println!("{samples} scenarios of 1,000 scans, processor time in seconds, the median of {ROUNDS}\n");
    println!(
        "| scenarios of a range | one thread | worker | server | run | worker and server beside one thread |\n|---|---|---|---|---|---|"
    );
    for range in RANGES {
        let range = range.to_string();
        let run = ["campaign", "run", "bench.toml", "--quiet", "--range", &range];
        let mut rounds: Vec<[f64; 4]> = Vec::new();
        for _ in 0..ROUNDS {
            let alone = to_the_end(sieben(&folder, &[&run[..], &["--workers", "1"]].concat()));
            let before = computed(&server);
            let mut worker =
                sieben(&folder, &["worker", "--nats", &url, "--threads", "1"]).stderr(Stdio::null()).spawn().expect("the binary starts");
            let run = to_the_end(sieben(&folder, &[&run[..], &["--nats", &url]].concat()));
            rounds.push([alone, computed(&worker), computed(&server) - before, run]);
            let _ = worker.kill();
            let _ = worker.wait();
        }
        let median = |of: &dyn Fn(&[f64; 4]) -> f64| {
            let mut all: Vec<f64> = rounds.iter().map(of).collect();
            all.sort_unstable_by(f64::total_cmp);
            all[all.len() / 2]
        };
        let more = median(&|[alone, worker, server, _]| ((worker + server) / alone - 1.0) * 100.0);
        let [alone, worker, server, run] = [0, 1, 2, 3].map(|index| median(&|round| round[index]));
        println!("| {range} | {alone:.2} | {worker:.2} | {server:.2} | {run:.2} | {more:+.1} % |");
    }
    let _ = server.kill();
    let _ = server.wait();
    let _ = fs::remove_dir_all(&folder);
}
