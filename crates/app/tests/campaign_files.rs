//! Results of campaigns as files: the same bytes however they came about, and nothing is lost or counted twice.
#![cfg(feature = "parquet")]

mod command;

use std::fs::{self, File};
use std::process::{Command, Stdio};
use std::time::Instant;

use command::{DEADLINE, Folder, sieben};
use serde_json::Value as Json;

/// Counts up to a limit that is drawn; a scenario fails if it is reached.
const COUNTING: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n L MW 12;\n +I;\n T MW 10;\n L MW 10;\n L MW 14;\n >I;\n = Q 4.0;\n A I 0.0;\n = Q 4.1;\n\
                        END_ORGANIZATION_BLOCK\n";
const DRAWN: &str = "[campaign]\nname = \"counting\"\nfor = \"500ms\"\nseed = 3\nsamples = 40\n[sweep]\n\"MW 12\" = { values = [1, 2, 5] }\n\
                     [draw]\n\"MW 14\" = { uniform = [25, 300] }\n\"MB 20\" = { choice = [1, 2], unit = \"pieces\" }\n\"I 0.0\" = { walk = { every = \"50ms\", chance = 0.3 } }\n\
                     [[never]]\nname = \"over\"\nexpr = \"Q4.0\"\n[[measure]]\nname = \"third\"\nof = \"mean\"\nexpr = \"INT_TO_REAL(WORD_TO_INT(MW10)) / 3.0\"\nunit = \"m\"\n";

fn folder() -> Folder {
    Folder::with(&[("main.awl", COUNTING), ("c.toml", DRAWN)])
}

fn run<'a>(out: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    ["campaign", "run", "c.toml", "--quiet", "--out", out].into_iter().chain(more.iter().copied()).collect()
}

/// Ends the process at a scenario, as if it were killed.
fn aborted(folder: &Folder, at: &str, more: &[&str]) {
    let output = sieben(folder.path(), &run("r.parquet", more)).env("SIEBEN_CAMPAIGN_ABORT", at).output().expect("it starts");
    assert_eq!(output.status.code(), None, "a signal ended it: {output:?}");
}

fn ranges(folder: &Folder) -> Vec<std::path::PathBuf> {
    let entries = fs::read_dir(folder.path().join("r.parquet.part")).expect("the ledger is there");
    let mut all: Vec<_> = entries
        .map(|entry| entry.expect("it can be read").path())
        .filter(|path| path.extension().is_some_and(|end| end == "arrow"))
        .collect();
    all.sort();
    all
}

#[test]
fn the_result_has_the_same_bytes_however_it_was_run() {
    let folder = folder();
    folder.run(&run("a.parquet", &["--workers", "1", "--engine", "interpreter"])).code(1);
    let whole = folder.read("a.parquet");
    for (out, more) in [
        ("b.parquet", &["--workers", "3"][..]),
        ("c.parquet", &["--range", "7"]),
        ("d.parquet", &["--range", "1", "--engine", "jit"]),
        ("e.parquet", &["--engine", "quick"]),
    ] {
        folder.run(&run(out, more)).code(1);
        assert!(folder.read(out) == whole, "{more:?}");
    }
    folder.run(&run("f.parquet", &["--seed", "4"])).code(1);
    assert!(folder.read("f.parquet") != whole, "another seed");
    assert!(!folder.path().join("a.parquet.part").exists(), "the ledger is gone");
}

#[test]
fn a_run_that_was_killed_goes_on_and_loses_and_doubles_nothing() {
    let folder = folder();
    let whole = folder.run(&run("whole.parquet", &["--json"])).code(1).json();
    aborted(&folder, "30", &["--range", "4"]);
    folder.run(&run("r.parquet", &[])).code(2).stderr("[P7175]").stderr("`r.parquet.part` is what a run left that did not end");
    for at in ["60", "61", "100"] {
        aborted(&folder, at, &["--range", "3", "--resume"]);
    }
    let before = ranges(&folder).len();
    assert!(before > 20, "{before}");
    // A file that was cut off, one with another bit, and one that was just being written.
    let all = ranges(&folder);
    let bytes = fs::read(&all[2]).expect("it is there");
    fs::write(&all[2], &bytes[..bytes.len() / 2]).expect("it can be written");
    let mut bytes = fs::read(&all[5]).expect("it is there");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&all[5], &bytes).expect("it can be written");
    fs::write(folder.path().join("r.parquet.part/.half.arrow.7.tmp"), b"half").expect("it can be written");
    let resumed =
        folder.run(&run("r.parquet", &["--resume", "--json"])).code(1).stderr("2 of the files in `r.parquet.part` were not whole").json();
    assert!(folder.read("r.parquet") == folder.read("whole.parquet"), "the same bytes");
    assert!(resumed["resumed"].as_u64().is_some_and(|resumed| (60..120).contains(&resumed)), "{resumed}");
    for key in ["scenarios", "run", "pass", "fail", "result_hash", "campaign", "first_failure", "measures", "properties"] {
        assert_eq!(resumed[key], whole[key], "{key}");
    }
    // Once more there is nothing to do, and it says the same.
    let again = folder.run(&run("r.parquet", &["--resume", "--json"])).code(1).json();
    assert_eq!(
        (&again["resumed"], &again["first_failure"], &again["result_hash"]),
        (&120.into(), &whole["first_failure"], &whole["result_hash"])
    );
}

#[test]
fn what_was_left_of_something_else_is_refused_and_says_what_changed() {
    let folder = folder();
    aborted(&folder, "30", &["--range", "4"]);
    let refused = |more: &[&str], what: &str| {
        let arguments: Vec<&str> = ["--resume"].iter().chain(more).copied().collect();
        folder.run(&run("r.parquet", &arguments)).code(2).stderr("[P7176]").stderr(what);
    };
    refused(&["--seed", "4"], "what changed: the seed (3 there, 4 here)");
    refused(&["--only", "0..9"], "has scenarios that are not asked for here");
    folder.write("c.toml", DRAWN.replace("40", "41").as_bytes());
    refused(&[], "what changed: the file of the campaign");
    folder.write("main.awl", COUNTING.replace(">I", ">=I").as_bytes());
    refused(&[], "what changed: the program, the file of the campaign");
    folder.write("c.toml", DRAWN.as_bytes());
    folder.write("main.awl", COUNTING.as_bytes());
    let lock = File::open(folder.path().join("r.parquet.part/lock")).expect("it is there");
    lock.lock().expect("no run has it");
    folder.run(&run("r.parquet", &["--resume"])).code(2).stderr("[P7177]").stderr("another run is writing `r.parquet.part`");
    drop(lock);
    folder.run(&run("r.parquet", &["--resume"])).code(1);
    folder
        .run(&run("r.parquet", &["--resume", "--seed", "4"]))
        .code(2)
        .stderr("`r.parquet` is of another campaign; what changed: the seed");
    folder.run(&run("r.parquet", &["--resume", "--only", "0..9"])).code(2).stderr("`r.parquet` has other scenarios");
    folder.write("x.parquet", b"PAR1 no, it is not");
    folder.run(&run("x.parquet", &["--resume"])).code(2).stderr("[P7178]");
}

#[test]
fn parts_are_merged_to_the_bytes_of_the_whole() {
    let folder = folder();
    folder.run(&run("whole.parquet", &[])).code(1);
    let parts = [("p0.parquet", "0..49"), ("p1.parquet", "50..50"), ("p2.parquet", "51..119")];
    for (out, only) in parts {
        folder.run(&["campaign", "run", "c.toml", "--quiet", "--out", out, "--only", only]).code(1);
    }
    let merge = |files: &[&str], code| {
        let arguments: Vec<&str> = ["campaign", "merge"].iter().chain(files).chain(&["-o", "m.parquet"]).copied().collect();
        folder.run(&arguments).code(code)
    };
    let merged = merge(&["p2.parquet", "p0.parquet", "p1.parquet"], 1);
    assert!(folder.read("m.parquet") == folder.read("whole.parquet"), "the same bytes");
    assert!(merged.stdout.starts_with("m.parquet: 120 scenarios, ") && !merged.stderr.contains("missing"), "{}", merged.stdout);
    merge(&["p0.parquet", "p2.parquet"], 1).stderr("missing: scenarios 50..50");
    let summary = merge(&["p0.parquet", "p2.parquet", "--json"], 1).json();
    assert_eq!(summary["ranges"], serde_json::json!([[0, 49], [51, 119]]));
    // What was merged is a part like any other.
    fs::rename(folder.path().join("m.parquet"), folder.path().join("two.parquet")).expect("it can be moved");
    merge(&["p1.parquet", "two.parquet"], 1);
    assert!(folder.read("m.parquet") == folder.read("whole.parquet"), "the same bytes");
    merge(&["p0.parquet", "whole.parquet"], 2).stderr("are in another of the files, too");
    folder.run(&run("other.parquet", &["--seed", "9", "--only", "50..50"])).code(0);
    merge(&["p0.parquet", "other.parquet"], 2).stderr("what differs: the seed (9 there, 3 here)");
    folder.write("no.parquet", b"no");
    merge(&["p0.parquet", "no.parquet"], 2).stderr("[P7178]");
    merge(&["p0.parquet", "missing.parquet"], 2).stderr("there is no file or folder `missing.parquet`");
    folder.run(&["campaign", "merge", "-o", "m.parquet"]).code(2);
}

#[test]
fn only_failures_are_kept_where_the_file_says_so() {
    let folder = folder();
    folder.run(&run("all.parquet", &[])).code(1);
    folder.write("c.toml", DRAWN.replace("samples = 40", "samples = 40\nkeep = \"failures\"").as_bytes());
    let few = folder.run(&run("few.parquet", &["--json"])).code(1).json();
    let summary = folder.run(&["campaign", "merge", "few.parquet", "-o", "m.parquet", "--json"]).code(1).json();
    assert_eq!((&summary["keep"], &summary["fail"], &summary["pass"]), (&"failures".into(), &few["fail"], &few["pass"]));
    assert!(folder.read("m.parquet") == folder.read("few.parquet"));
    assert!(folder.read("few.parquet").len() < folder.read("all.parquet").len());
}

#[test]
fn a_run_ends_when_its_time_is_used_up_or_it_is_told_to_and_says_how_it_goes_on() {
    let folder = folder();
    folder.write("c.toml", DRAWN.replace("500ms", "20s").as_bytes());
    folder
        .run(&run("r.parquet", &["--budget", "50ms", "--workers", "1"]))
        .code(5)
        .stderr("`sieben campaign run c.toml --quiet --out r.parquet --budget 50ms --workers 1 --resume` goes on with it");
    let mut child = sieben(folder.path(), &run("r.parquet", &["--resume", "--range", "1"]))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let begun = Instant::now();
    let before = ranges(&folder).len();
    while ranges(&folder).len() < before + 3 {
        assert!(begun.elapsed() < DEADLINE, "nothing comes");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    let code = child.wait().expect("it ends").code();
    assert!(matches!(code, Some(130)), "{code:?}");
    assert!(folder.path().join("r.parquet.part").exists() && !folder.path().join("r.parquet").exists());
    let result = folder.run(&run("r.parquet", &["--resume", "--json"])).code(1).json();
    assert_eq!((&result["run"], &result["duplicates"]), (&120.into(), &0.into()));
    assert!(result["resumed"].as_u64().is_some_and(|resumed| resumed > 0));
}

#[test]
fn the_failure_with_the_least_number_ends_a_run_also_one_that_goes_on() {
    let folder = folder();
    let whole = folder.run(&["campaign", "run", "c.toml", "--quiet", "--json"]).code(1).json();
    let first = whole["first_failure"]["scenario"].as_u64().expect("it fails");
    for more in [&["--workers", "3"][..], &["--range", "50"], &["--workers", "1"]] {
        let arguments: Vec<&str> = more.iter().copied().chain(["--stop-on", "first", "--json"]).collect();
        let result = folder.run(&run("s.parquet", &arguments)).code(1).json();
        assert_eq!((&result["first_failure"], &result["run"]), (&whole["first_failure"], &(first + 1).into()), "{more:?}");
    }
    let one = folder.read("s.parquet");
    aborted(&folder, "80", &["--range", "5"]);
    let result = folder.run(&run("r.parquet", &["--resume", "--stop-on", "first", "--json"])).code(1).json();
    assert_eq!((&result["first_failure"], &result["run"]), (&whole["first_failure"], &(first + 1).into()));
    assert!(folder.read("r.parquet") == one, "the same bytes");
}

#[test]
fn where_nothing_can_be_written_the_ledger_stays_whole() {
    let folder = folder();
    folder.run(&run(".", &[])).code(2).stderr("[P6013]");
    folder.run(&run("missing/r.parquet", &[])).code(1);
    folder.run(&run("whole.parquet", &[])).code(1);
    // A file may have 2 KiB: as on a disk that is full, no range can be written whole.
    let script = format!("ulimit -f 2; exec {} campaign run c.toml --quiet --out r.parquet", env!("CARGO_BIN_EXE_sieben"));
    let output = Command::new("sh").args(["-c", &script]).current_dir(folder.path()).output().expect("there is a shell");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && told.contains("[P6013]") && told.contains("cannot be written"), "{output:?}");
    folder.run(&run("r.parquet", &["--resume"])).code(1);
    assert!(folder.read("r.parquet") == folder.read("whole.parquet"), "the same bytes");
}

#[test]
fn the_summary_has_all_that_the_scenarios_came_to() {
    let folder = folder();
    let result = folder.run(&run("r.parquet", &["--json"])).code(1).json();
    let summary = folder.run(&["campaign", "merge", "r.parquet", "-o", "m.parquet", "--json"]).code(1).json();
    let (of, measure) = (&summary["measures"][0], &result["measures"][0]);
    for key in ["name", "of", "unit", "count", "min", "min_scenario", "max", "max_scenario", "mean"] {
        assert_eq!(of[key], measure[key], "{key}");
    }
    let counts = of["histogram"]["counts"].as_array().expect("there are buckets");
    assert!(counts.len() > 10 && counts.len() <= 64, "{}", counts.len());
    assert_eq!(counts.iter().filter_map(|pair| pair[1].as_u64()).sum::<u64>(), 120);
    assert_eq!(summary["properties"][0]["broken"], result["fail"]);
    let how: Json = serde_json::from_slice(&folder.read("r.parquet.run.json")).expect("it is JSON");
    assert!(how["seconds"].as_f64().is_some_and(|seconds| seconds > 0.0) && how["workers"].as_u64().is_some_and(|workers| workers > 0));
}
