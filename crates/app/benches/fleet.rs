//! What a fleet comes to: `cargo bench -p sieben-app --bench fleet [-- CONTROLLERS]`.
//!
//! So many controllers with a program of 1,000 statements each, in a chain of links and without any, on one thread and on two. A figure is the
//! real time that `sieben fleet --json` says, without compiling.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value as Json;

/// Controllers of the fleet.
const CONTROLLERS: u64 = 10_000;
/// Scans of each.
const SCANS: u64 = 100;
/// How often the kinds are measured, in turns.
const ROUNDS: usize = 3;

/// 1,000 statements: networks of bits with set and reset, and a little arithmetic.
fn program() -> String {
    let mut text = String::from("ORGANIZATION_BLOCK OB 1\nBEGIN\n L IB 0;\n L MB 201;\n +I;\n T QB 0;\n");
    for network in 0..100 {
        let (byte, bit, word, number) = (network / 8, network % 8, 200 + network * 2, network + 1);
        let (edge, set) = (100 + byte, 1 + byte);
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "NETWORK\n A I {byte}.{bit};\n AN M {edge}.{bit};\n O M {edge}.{bit};\n = M {edge}.{bit};\n A M {edge}.{bit};\n S Q {set}.{bit};\n\
             L MW {word};\n L {number};\n +I;\n T MW {word};\n"
        );
    }
    text + "END_ORGANIZATION_BLOCK\n"
}

fn spec(controllers: u64, link: bool) -> String {
    let mut text =
        format!("[fleet]\ncycle = \"10ms\"\n[[controller]]\nname = \"station\"\ncount = {controllers}\nprogram = \"main.awl\"\n");
    if link {
        text.push_str("[[link]]\nfrom = \"station[i].QB 0\"\nto = \"station[i+1].IB 0\"\nlatency = \"10ms\"\n");
    }
    text
}

/// The result of one run.
fn run(folder: &Path, file: &str, threads: u32) -> Json {
    let (threads, time) = (threads.to_string(), format!("{}ms", SCANS * 10));
    let arguments = ["fleet", file, "--json", "--threads", &threads, "--for", &time];
    let output = Command::new(env!("CARGO_BIN_EXE_sieben")).args(arguments).current_dir(folder).output().expect("the binary starts");
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)))
}

fn main() {
    let controllers = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(CONTROLLERS);
    let folder = std::env::temp_dir().join(format!("sieben-bench-fleet-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("the folder for temporary files is writable");
    fs::write(folder.join("main.awl"), program()).expect("the folder is writable");
    let kinds = [
        ("a chain of links, one thread", "chain.toml", 1),
        ("a chain of links, two threads", "chain.toml", 2),
        ("no links, one thread", "free.toml", 1),
        ("no links, two threads", "free.toml", 2),
    ];
    fs::write(folder.join("chain.toml"), spec(controllers, true)).expect("the folder is writable");
    fs::write(folder.join("free.toml"), spec(controllers, false)).expect("the folder is writable");
    let mut times = vec![Vec::new(); kinds.len()];
    let (mut hashes, mut bytes) = (vec![Json::Null; kinds.len()], Json::Null);
    for _ in 0..ROUNDS {
        for (index, (_, file, threads)) in kinds.iter().enumerate() {
            let result = run(&folder, file, *threads);
            assert_eq!(result["scans"], controllers * SCANS, "{}", result["stopped"]);
            times[index].push(result["seconds"].as_f64().expect("a number"));
            (hashes[index], bytes) = (result["state_hash"].clone(), result["bytes_per_instance"].clone());
        }
    }
    assert!(hashes[0] == hashes[1] && hashes[2] == hashes[3], "threads decide nothing: {hashes:?}");
    let scans = (controllers * SCANS) as f64;
    println!(
        "{controllers} controllers of {bytes} bytes, {SCANS} scans each, the median of {ROUNDS}\n\n| kind | seconds | scans/s | a controller |\n|---|---|---|---|"
    );
    for (index, (name, ..)) in kinds.iter().enumerate() {
        times[index].sort_unstable_by(f64::total_cmp);
        let seconds = times[index][times[index].len() / 2];
        println!("| {name} | {seconds:.2} | {:.0} | {:.0} Hz |", scans / seconds, SCANS as f64 / seconds);
    }
    let _ = fs::remove_dir_all(&folder);
}
