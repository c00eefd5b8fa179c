//! What a campaign costs beside its scans: `cargo bench -p sieben-app --bench campaign [-- SAMPLES]`.
//!
//! The same scans with the same properties run in one scenario, in one loop, and as many scenarios of 1,000 and of 100 scans each, in
//! alternation. A figure is the real time that `sieben campaign run --json` says, without compiling; that of the loop is the time of the
//! scans that one of [`LONGER`] times the length has more, because a scenario is looked at for a second in the interpreter, too.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value as Json;

/// Scenarios of 1,000 scans.
const SAMPLES: u64 = 10_000;
/// How much longer the second loop is.
const LONGER: u64 = 5;
/// How often the kinds are measured, in alternation.
const ROUNDS: usize = 3;

/// 100 statements: networks of bits with set and reset, and a little arithmetic.
fn program() -> String {
    let mut text = String::from("ORGANIZATION_BLOCK OB 1\nBEGIN\n");
    for network in 0..10 {
        let (byte, bit) = (network / 8, network % 8);
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "NETWORK\n A I {byte}.{bit};\n AN M 10.{bit};\n O M 11.{bit};\n = M 11.{bit};\n A M 11.{bit};\n S Q {byte}.{bit};\n L MW 20;\n L {};\n +I;\n T MW 20;\n",
            network + 1
        );
    }
    text + "END_ORGANIZATION_BLOCK\n"
}

fn spec(scans: u64, samples: u64) -> String {
    format!(
        "[campaign]\nname = \"bench\"\nprogram = \"main.awl\"\nfor = \"{}ms\"\nsamples = {samples}\nseed = 1\n[draw]\n\"MW 20\" = {{ uniform = [0, 100] }}\n\
         \"I 0.0\" = {{ choice = [true, false] }}\n[[never]]\nname = \"never\"\nexpr = \"Q0.0 AND NOT Q0.0\"\n\
         [[measure]]\nname = \"most\"\nof = \"max\"\nexpr = \"WORD_TO_INT(MW20)\"\n",
        scans * 10
    )
}

/// Seconds of one run.
fn run(folder: &Path, file: &str, workers: u32) -> f64 {
    let workers = workers.to_string();
    let arguments = ["campaign", "run", file, "--json", "--quiet", "--workers", &workers];
    let output = Command::new(env!("CARGO_BIN_EXE_sieben")).args(arguments).current_dir(folder).output().expect("the binary starts");
    let result: Json =
        serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)));
    assert_eq!(result["pass"], result["scenarios"], "{result}");
    result["seconds"].as_f64().expect("a number")
}

fn main() {
    let samples = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(SAMPLES);
    let folder = std::env::temp_dir().join(format!("sieben-bench-campaign-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("the folder for temporary files is writable");
    fs::write(folder.join("main.awl"), program()).expect("the folder is writable");
    let kinds = [
        ("one scenario with all scans", spec(1_000 * samples, 1), 1),
        ("one scenario with LONGER times as many", spec(1_000 * samples * LONGER, 1), 1),
        ("scenarios of 1,000 scans, one thread", spec(1_000, samples), 1),
        ("scenarios of 1,000 scans, two threads", spec(1_000, samples), 2),
        ("scenarios of 100 scans, ten times as many, one thread", spec(100, samples * 10), 1),
    ];
    for (index, (_, spec, _)) in kinds.iter().enumerate() {
        fs::write(folder.join(format!("{index}.toml")), spec).expect("the folder is writable");
    }
    let mut times = vec![Vec::new(); kinds.len()];
    for _ in 0..ROUNDS {
        for (index, (_, _, workers)) in kinds.iter().enumerate() {
            times[index].push(run(&folder, &format!("{index}.toml"), *workers));
        }
    }
    let scans = (1_000 * samples) as f64;
    println!("{scans} scans in each row, the median of {ROUNDS}\n\n| kind | seconds | a scan | beside the first row |\n|---|---|---|---|");
    let medians: Vec<f64> = times
        .iter_mut()
        .map(|times| {
            times.sort_unstable_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect();
    let one_loop = (medians[1] - medians[0]) / (LONGER - 1) as f64;
    let rows = std::iter::once(("the same scans in one loop, one thread", one_loop));
    for (name, seconds) in rows.chain(kinds[2..].iter().map(|kind| kind.0).zip(medians[2..].iter().copied())) {
        println!("| {name} | {seconds:.2} | {:.0} ns | {:+.1} % |", seconds / scans * 1e9, (seconds / one_loop - 1.0) * 100.0);
    }
    let _ = fs::remove_dir_all(&folder);
}
