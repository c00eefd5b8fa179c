//! `sieben fleet`: what very many controllers come to, and that nothing but the file and the programs decides it.

mod command;

use std::io::{BufRead, BufReader};
use std::process::Stdio;

use command::{Folder, sieben};
use serde_json::Value as Json;

/// Passes its input on with 1 more, counts its scans.
const STATION: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L IB 0;\n L 1;\n +I;\n T QB 0;\n L MW 10;\n L 1;\n +I;\n T MW 10;\n T QW 2;\nEND_ORGANIZATION_BLOCK\n";
/// In STOP from its third scan on.
const BROKEN: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 10;\n L 1;\n +I;\n T MW 10;\n L 3;\n <I;\n JC end;\n L P#M 65535.0;\n T MD 20;\n L MB [MD 20];\nend: NOP 0;\nEND_ORGANIZATION_BLOCK\n";
const LINE: &str = "[fleet]\nname = \"line\"\ncycle = \"10ms\"\n[[controller]]\nname = \"station\"\ncount = 40\nprogram = \"station.awl\"\n\
                    [[controller]]\nname = \"master\"\nprogram = \"broken.awl\"\n\
                    [[link]]\nfrom = \"station[i].QB 0\"\nto = \"station[i+1].IB 0\"\nlatency = \"10ms\"\n\
                    [[link]]\nfrom = \"station[39].QW 2\"\nto = \"master.MW 30\"\nlatency = \"35ms\"\n";

fn line() -> Folder {
    Folder::with(&[("station.awl", STATION), ("broken.awl", BROKEN), ("line.toml", LINE)])
}

/// The result without what time it took.
fn timeless(mut result: Json) -> Json {
    for key in ["seconds", "threads", "longest_scan", "late_us", "bytes_per_instance"] {
        result[key] = Json::Null;
    }
    result
}

#[test]
fn threads_engines_and_speed_decide_nothing() {
    let folder = line();
    let of = |more: &[&str]| {
        let arguments: Vec<&str> = ["fleet", "line.toml", "--for", "300ms", "--json"].into_iter().chain(more.iter().copied()).collect();
        timeless(folder.run(&arguments).code(0).json())
    };
    let one = of(&["--threads", "1", "--engine", "interpreter"]);
    for more in
        [["--threads", "2", "--engine", "interpreter"], ["--threads", "16", "--engine", "jit"], ["--threads", "3", "--engine", "quick"]]
    {
        assert_eq!(of(&more), one, "{more:?}");
    }
    assert_eq!(of(&["--speed", "1x"]), one);
    assert_eq!((&one["instances"], &one["scans"], &one["interrupted"]), (&41.into(), &(40 * 30 + 3).into(), &false.into()));
    assert_eq!(one["state_hash"].as_str().map(str::len), Some(16));
    let result = folder.run(&["fleet", "line.toml", "--for", "300ms", "--json"]).code(0).json();
    assert!(result["bytes_per_instance"].as_u64().is_some_and(|bytes| bytes <= 32 * 1024), "{}", result["bytes_per_instance"]);
    // Station k adds 1 to what the one before it sent 10 ms earlier; from scan k on it has all of the chain.
    for (station, output) in [(0, "0100001e"), (7, "0800001e"), (29, "1e00001e"), (39, "1e00001e")] {
        assert_eq!(one["outputs"][format!("station[{station}]")], output, "{station}");
    }
}

#[test]
fn a_stop_is_a_row_and_not_the_end() {
    let folder = line();
    let run = folder.run(&["fleet", "line.toml", "--for", "1s", "--metrics", "numbers.txt"]).code(0);
    let run = run.stdout("line: 41 controllers, 4003 scans in ").stdout("1 controller in STOP:\n  master  in scan 2 at 20 ms: ");
    run.stdout("`sieben fleet line.toml --record 'master' FILE.scenario`");
    let numbers = String::from_utf8(folder.read("numbers.txt")).expect("text");
    for line in ["sieben_fleet_scans_total{controller=\"station\",index=\"39\"} 100", "sieben_fleet_stopped{controller=\"master\"} 1"] {
        assert!(numbers.lines().any(|written| written == line), "{line}\n{numbers}");
    }
    let result = folder.run(&["fleet", "line.toml", "--for", "1s", "--json"]).code(0).json();
    assert_eq!(
        (&result["stopped"][0]["controller"], &result["stopped"][0]["scan"]),
        (&"master".into(), &2.into()),
        "{}",
        result["stopped"]
    );
    assert!(result["stopped"][0]["text"].as_str().is_some_and(|text| text.contains("OB 1")), "{}", result["stopped"]);
}

#[test]
fn what_goes_into_one_of_them_is_a_scenario_of_its_program() {
    let folder = line();
    folder.run(&["fleet", "line.toml", "--for", "200ms", "--record", "station[3]", "three.scenario"]).code(0);
    let recording = String::from_utf8(folder.read("three.scenario")).expect("text");
    assert!(recording.contains("IB 0=3") || recording.contains("IB 0=16#03") || recording.contains("I 0.0=1"), "{recording}");
    folder.run(&["test", "station.awl", "--tests", "three.scenario"]).code(0);
    let other = STATION.replace(" L 1;\n +I;\n T QB 0;", " T QB 0;");
    folder.write("other.awl", other.as_bytes());
    folder.run(&["test", "other.awl", "--tests", "three.scenario"]).code(1);
    // One that is told something in its memory, and goes to STOP.
    let printed = folder.run(&["fleet", "line.toml", "--for", "100ms", "--record", "master", "-"]).code(0).stdout;
    folder.write("master.scenario", printed.as_bytes());
    folder.run(&["test", "broken.awl", "--tests", "master.scenario"]).code(0);
    let run = folder.run(&["fleet", "line.toml", "--record", "station[40]", "x.scenario"]).code(2);
    run.stderr("P7174").stderr("the fleet has no controller `station[40]`: the first is `station[0]`, the last `master`");
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let folder = line();
    let told = |text: &str, code: i32, parts: &[&str]| {
        folder.write("wrong.toml", text.as_bytes());
        let run = folder.run(&["fleet", "wrong.toml"]).code(code);
        let all = format!("{}{}", run.stdout, run.stderr);
        for part in parts {
            assert!(all.contains(part), "{part}\n{all}");
        }
    };
    told(&LINE.replace("QB 0", "QW 0"), 3, &["P7172", "wrong.toml:13:20", "`QW 0` has 16 bits and `IB 0` has 8 bits"]);
    told(&LINE.replace("\"10ms\"\n[[link", "\"100us\"\n[[link"), 3, &["P7171", "a link takes at least 1 ms"]);
    told(
        &LINE.replace("latency = \"35ms\"", "kind = \"s7\"\nlatency = \"35ms\""),
        3,
        &["P7173", "links of the kind `s7` are not there yet"],
    );
    told(&LINE.replace("broken.awl", "nothing.awl"), 2, &["nothing.awl"]);
    told("[fleet", 3, &["P7170", "the file is not valid TOML"]);
    folder.write("bad.awl", b"ORGANIZATION_BLOCK OB 1\nBEGIN\n L NONSENSE;\nEND_ORGANIZATION_BLOCK\n");
    told(&LINE.replace("broken.awl", "bad.awl"), 3, &["bad.awl:3:"]);
    folder.run(&["fleet", "top"]).code(2).stderr("P7173").stderr("`fleet top` is not there yet");
    folder.run(&["fleet", "top", "line.toml"]).code(2).stderr("`fleet top` is not there yet");
    folder.run(&["fleet", "line.toml", "wrong.toml"]).code(2).stderr("a fleet has one file");
    folder.run(&["fleet", "line.toml", "--metrics", "station.awl"]).code(2).stderr("P6013");
    folder.run(&["fleet", "line.toml", "--metrics", "line.toml"]).code(2).stderr("P6013");
    folder.write("wrong.toml", b"\xff\xfe");
    folder.run(&["fleet", "wrong.toml"]).code(2).stderr("P7170");
    folder.run(&["fleet", "missing.toml"]).code(2);
    folder.run(&["fleet", "line.toml", "--threads", "0"]).code(2);
}

#[test]
fn ctrl_c_ends_a_fleet_with_what_it_has_come_to() {
    let folder = line();
    let mut fleet = sieben(folder.path(), &["fleet", "line.toml", "--speed", "1x", "--for", "1h"]);
    let mut fleet = fleet.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the binary starts");
    let mut said = String::new();
    BufReader::new(fleet.stderr.take().expect("it is piped")).read_line(&mut said).expect("it says that it runs");
    assert_eq!(said, "Running `line`: 41 controllers, cycle 10 ms; Ctrl-C ends.\n");
    let process = rustix::process::Pid::from_raw(fleet.id() as i32).expect("a process");
    rustix::process::kill_process(process, rustix::process::Signal::INT).expect("it runs");
    let output = fleet.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(130));
    let said = String::from_utf8(output.stdout).expect("text");
    assert!(said.contains("line: 41 controllers, ") && said.contains("ended by Ctrl-C before 1 h 0 min"), "{said}");
}

/// A controller takes less than 40 KiB of the computer's memory: what is counted, and what the allocator adds.
#[cfg(target_os = "linux")]
#[test]
fn two_thousand_controllers_take_as_much_memory_as_is_said() {
    let folder = line();
    let peak = |count: u32| {
        let text = format!("[[controller]]\nname = \"a\"\ncount = {count}\nprogram = \"station.awl\"\n");
        folder.write("many.toml", text.as_bytes());
        let mut fleet =
            sieben(folder.path(), &["fleet", "many.toml", "--speed", "1x", "--for", "1h", "--threads", "1", "--engine", "interpreter"]);
        let mut fleet = fleet.stdout(Stdio::null()).spawn().expect("the binary starts");
        let resident = || {
            let status = std::fs::read_to_string(format!("/proc/{}/status", fleet.id())).unwrap_or_default();
            let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap_or_default();
            line.trim().trim_end_matches(" kB").parse::<u64>().unwrap_or(0)
        };
        // Until it does not grow any more.
        let mut last = 0;
        for _ in 0..60 {
            std::thread::sleep(std::time::Duration::from_millis(500));
            let now = resident();
            if now == last && now > 10_000 {
                break;
            }
            last = now;
        }
        fleet.kill().expect("it runs");
        fleet.wait().expect("it ends");
        last
    };
    let each = peak(2001).saturating_sub(peak(1)) as f64 / 2000.0;
    assert!(each > 5.0 && each <= 40.0, "{each} KiB");
}
