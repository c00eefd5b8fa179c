//! Runs that are written down: whoever runs the recording has the same run again, on every engine, and a program that does something else is found.

mod command;
#[allow(dead_code)] // Recordings need one way to a CPU.
mod program;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use command::{Folder, sieben};
use program::{ENGINES, Load, compile};
use proptest::prelude::*;
use sieben_cpu::{Cpu, Interrupt, IoModule, OperatingMode, Rack, Settings};
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::symbols::SymbolTable;
use sieben_sim::names::Name;
use sieben_sim::scenario::recorder::{Recorder, Subject};
use sieben_sim::scenario::{Happened, Onlooker, Rules, Scenario};

/// OB 1, OB 35 and OB 40 read inputs in every way there is, also between two scans, and write outputs by name, by pointer and directly.
const PROGRAM: &str = "\
ORGANIZATION_BLOCK OB 100\nBEGIN\n L PIW 260\n T QW 10\nEND_ORGANIZATION_BLOCK\n\
ORGANIZATION_BLOCK OB 35\nBEGIN\n L MW 20\n L PIW 256\n +I\n T MW 20\n T PQW 256\nEND_ORGANIZATION_BLOCK\n\
ORGANIZATION_BLOCK OB 40\nBEGIN\n L MW 22\n L 1\n +I\n T MW 22\n T QW 12\nEND_ORGANIZATION_BLOCK\n\
ORGANIZATION_BLOCK OB 1\nBEGIN\n A I 0.0\n L S5T#50MS\n SD T 1\n A T 1\n = Q 0.0\n A I 0.1\n CU C 1\n L C 1\n T QW 2\n L IW 2\n L MD 4\n +D\n T MD 4\n T QD 4\n \
L PIW 256\n T MW 24\n L ID 4\n T QD 16\n L IB 1\n T LB 0\n LAR1 P#Q 30.0\n L IB 1\n T B [AR1,P#0.0]\nEND_ORGANIZATION_BLOCK\n";

/// A module that says something else as time passes, and raises interrupts.
#[derive(Clone)]
struct Noise {
    now_us: u64,
    state: u64,
    alarms: bool,
}

impl Noise {
    fn next(&mut self) {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    }
}

impl IoModule for Noise {
    fn name(&self) -> &str {
        "noise"
    }
    fn inputs(&self) -> std::ops::Range<u32> {
        250..270
    }
    fn outputs(&self) -> std::ops::Range<u32> {
        0..0
    }
    fn read(&self, offset: u32, into: &mut [u8]) {
        for (index, byte) in (offset..).zip(into) {
            *byte = (self.state >> (index % 56)) as u8;
        }
    }
    fn write(&mut self, _: u32, _: &[u8]) {}
    fn advance(&mut self, dt_us: u64) {
        // It changes every 3 ms, between any two scans and interrupts.
        for _ in 0..(self.now_us + dt_us) / 3_000 - self.now_us / 3_000 {
            self.next();
        }
        self.now_us += dt_us;
    }
    fn alarms(&mut self) -> Vec<Interrupt> {
        let alarm = self.alarms && self.state.is_multiple_of(7) && self.state >> 33 & 1 == 0;
        self.alarms |= !self.state.is_multiple_of(7);
        if alarm {
            self.alarms = false;
        }
        alarm.then(|| Interrupt::usual(40)).flatten().into_iter().collect()
    }
}

fn fresh(load: Load, noise: Option<u64>) -> Cpu {
    let cpu_type = &CpuType::ALL[0];
    let compiled = compile(PROGRAM, Mnemonics::English, cpu_type).expect("the program compiles");
    let rack = match noise {
        Some(state) => Rack::with_background(cpu_type, vec![Box::new(Noise { now_us: 0, state, alarms: true })]).expect("it fits"),
        None => Rack::simulated(cpu_type),
    };
    Cpu::load(cpu_type, Arc::new(compiled.program), load, rack, Settings::default())
}

/// Notes what a CPU is behind every scan.
struct Noted {
    recorder: Recorder,
    states: Vec<String>,
    failed: Vec<String>,
}

impl Onlooker for Noted {
    fn see(&mut self, happened: Happened<'_>) {
        if let Happened::Scan { cpu, time_us, .. } = &happened {
            let machine = cpu.machine();
            let hash = machine.memory.arena.iter().fold(0_u64, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3));
            self.states.push(format!("{time_us} {:?} {hash:016x} {:?} {:?}", cpu.mode(), machine.timers[1], machine.counters[1]));
        }
        if let Happened::Failed(error) = &happened {
            self.failed.push(error.to_string());
        }
        self.recorder.see(happened);
    }
}

/// Runs a scenario and records it: the recording, and what the CPU was behind every scan.
fn record(scenario: &Scenario, load: Load, noise: Option<u64>, rules: &Rules) -> (String, Vec<String>, Vec<String>) {
    let cpu = fresh(load, noise);
    let names = |names: &[&str]| -> Vec<Name> {
        names.iter().map(|name| Name::parse(name, &SymbolTable::default(), cpu.program()).expect("a name")).collect()
    };
    let subject = Subject {
        title: "a test".to_owned(),
        inputs: names(&["IW 2", "PIW 256", "I 0.0"]),
        outputs: names(&["Q 0.0", "QW 2", "QD 4", "PQW 256"]),
        plants: noise.is_some(),
        ..Subject::default()
    };
    let mut noted = Noted { recorder: Recorder::new(subject, scenario), states: Vec::new(), failed: Vec::new() };
    scenario.run_with(&SymbolTable::default(), rules, &mut || fresh(load, noise), &mut noted);
    assert_eq!(noted.recorder.trouble(), None);
    (noted.recorder.finish(), noted.states, noted.failed)
}

/// The recording of a scenario with a noisy module is replayed without it, on every engine: all memory is the same behind every scan.
fn comes_again(text: &str, noise: u64) {
    let scenario = Scenario::parse(text).expect("a scenario");
    let (_, first) = ENGINES[0];
    let (recording, states, failed) = record(&scenario, first, Some(noise), &Rules::default());
    assert_eq!(failed, Vec::<String>::new(), "{text}");
    let replayed = Scenario::parse(&recording).unwrap_or_else(|errors| panic!("{recording}\n{errors:?}"));
    for (engine, load) in ENGINES {
        let (again, other_states, failed) = record(&replayed, *load, None, &Rules::default());
        assert_eq!(failed, Vec::<String>::new(), "{engine}: {recording}");
        assert!(states == other_states, "{engine}: {text}\n{recording}\n{states:#?}\n{other_states:#?}");
        assert_eq!(again, recording, "{engine}: the recording of a recording is the same");
    }
}

#[test]
fn a_recording_comes_again_on_every_engine() {
    comes_again("cyclic OB 35 7ms\nscan 60", 1);
    comes_again(
        "cycle 4ms\ncyclic OB 35 10ms phase 3ms\nat 13ms I 0.0=1\nset MW 20=7\nscan 20\nset I 0.1=1 MD 4=1000\nscan\nscan at 200ms\nscan 3",
        2,
    );
    comes_again(
        "scan 3\ninterrupt OB 40 INFO2=16#12345678\nscan 2\nforce Q 0.0=1 I 0.0=1\nscan 10\nunforce I 0.0\nunforce\nscan\nrestart cold\nscan 2",
        3,
    );
    comes_again(
        "start cold\nclock DT#2026-11-22-09:30:00\nmin-cycle 12ms\nimage-errors every\nscan 5\ninterrupt OB 40 at safe point 1\nscan",
        4,
    );
}

/// Something that happens in a random scenario.
fn line() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => (1_u32..8).prop_map(|scans| format!("scan {scans}")),
        2 => (0_u32..4, any::<bool>()).prop_map(|(bit, value)| format!("set I 0.{bit}={}", u8::from(value))),
        1 => any::<u8>().prop_map(|value| format!("set IB 1={value} IW 2={}", u16::from(value) * 77)),
        1 => any::<u16>().prop_map(|value| format!("set MW 20=16#{value:04X}")),
        1 => Just("interrupt OB 40".to_owned()),
        1 => any::<bool>().prop_map(|value| format!("force Q 0.0={}", u8::from(value))),
        1 => Just("restart warm".to_owned()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_run_comes_again(lines in prop::collection::vec(line(), 1..12), cycle in 1_u32..30, interval in 3_u32..50, noise in any::<u64>()) {
        comes_again(&format!("cycle {cycle}ms\ncyclic OB 35 {interval}ms\n{}\nscan 2", lines.join("\n")), noise);
    }
}

/// A recording that was cut anywhere is read as far as its scans are whole, and comes true.
#[test]
fn a_recording_that_is_cut_anywhere_is_whole_up_to_there() {
    let scenario = Scenario::parse("cyclic OB 35 7ms\nat 13ms I 0.0=1\nscan 12").expect("a scenario");
    let (recording, ..) = record(&scenario, ENGINES[0].1, Some(5), &Rules::default());
    let head = recording.find("\ncycle").expect("a head");
    let mut scans = 0;
    for end in head..recording.len() {
        let part = Scenario::parse(&recording[..end]).unwrap_or_else(|errors| panic!("{}\n{errors:?}", &recording[..end]));
        assert_eq!(part.recorded.as_ref().map(|recorded| recorded.cut_off), Some(true), "{end}");
        if end % 60 == 0 {
            let (_, states, failed) = record(&part, ENGINES[0].1, None, &Rules::default());
            assert_eq!(failed, Vec::<String>::new(), "{}", &recording[..end]);
            assert!(states.len() >= scans, "a longer part has no fewer scans");
            scans = states.len();
        }
    }
    let missing: String = recording.split_inclusive('\n').filter(|line| *line != "scan\n").collect();
    let errors = Scenario::parse(&missing).expect_err("scans are missing");
    assert!(errors[0].message.contains("says that it ends after 12 scans"), "{errors:?}");
}

/// One who does not look.
struct Nobody;

impl Onlooker for Nobody {
    fn see(&mut self, _: Happened<'_>) {}
}

#[test]
fn values_are_compared_by_the_rules() {
    let run = |text: &str, change: &dyn Fn(&mut Rules)| {
        let mut rules = Rules::default();
        change(&mut rules);
        let scenario = Scenario::parse(text).expect("a scenario");
        scenario.run_with(&SymbolTable::default(), &rules, &mut || fresh(ENGINES[0].1, None), &mut Nobody).len()
    };
    let late = |scans: u64| move |rules: &mut Rules| rules.within = scans;
    // Q 0.0 follows T 1 in scan 6, behind I 0.0 in scan 1.
    let from = |scan: u64| format!("at 10ms I 0.0=1\nalways Q 0.0=0\nscan {scan}\nalways Q 0.0=1\nscan {}", 20 - scan);
    assert_eq!(run(&from(6), &|_| {}), 0);
    assert_eq!([5, 7].map(|scan| run(&from(scan), &|_| {})), [1, 1]);
    assert_eq!([5, 7].map(|scan| run(&from(scan), &late(1))), [0, 0]);
    assert_eq!([4, 8].map(|scan| run(&from(scan), &late(1))), [1, 1]);
    // A pulse that does not come is missed, however far a value may be off in time.
    let pulse = "always Q 0.0=0\nscan 10\nalways Q 0.0=1\nscan\nalways Q 0.0=0\nscan 10";
    assert_eq!(run(pulse, &late(3)), 1);
    let number = |value: i32| format!("set IW 2=100\nalways QD 4={value}\nscan");
    assert_eq!(run(&number(100), &|_| {}), 0);
    assert_eq!(run(&number(103), &|_| {}), 1);
    let tolerance = |text: &'static str, name: Option<&'static str>| {
        move |rules: &mut Rules| rules.tolerate(name, sieben_sim::scenario::rules::Tolerance::parse(text).expect("a tolerance"))
    };
    assert_eq!(run(&number(103), &tolerance("3", Some("qd4"))), 0);
    assert_eq!(run(&number(104), &tolerance("3%", None)), 1);
    assert_eq!(run(&number(103), &tolerance("3%", None)), 0);
    assert_eq!(run(&number(104), &|rules| rules.ignore("QD4")), 0);
    assert_eq!(run("at 10ms Start=1\nalways Q 0.0=0\nscan 6\nalways Q 0.0=1\nscan", &|rules| rules.rename("start", "I 0.0")), 0);
    // What always is ends where it says so, and is not asked of a CPU in STOP.
    assert_eq!(run("at 10ms I 0.0=1\nalways Q 0.0=0\nscan 6\nalways Q 0.0=?\nscan 5", &|_| {}), 0);
}

#[test]
fn an_input_comes_at_its_time_and_not_before() {
    let scenario = Scenario::parse("cyclic OB 35 6ms\nat 8ms PIW 256=5\nscan at 10ms\nexpect MW 20=0\nscan at 13ms\nexpect MW 20=5")
        .expect("a scenario");
    for (engine, load) in ENGINES {
        let failed = scenario.run(&SymbolTable::default(), &mut || fresh(*load, None));
        assert_eq!(failed, [], "{engine}");
    }
}

#[test]
fn what_cannot_be_had_again_is_refused() {
    /// Answers every question otherwise.
    struct Fickle(std::sync::atomic::AtomicU8);
    impl IoModule for Fickle {
        fn name(&self) -> &str {
            "fickle"
        }
        fn inputs(&self) -> std::ops::Range<u32> {
            256..258
        }
        fn outputs(&self) -> std::ops::Range<u32> {
            0..0
        }
        fn read(&self, _: u32, into: &mut [u8]) {
            into.fill(self.0.fetch_add(1, std::sync::atomic::Ordering::Relaxed));
        }
        fn write(&mut self, _: u32, _: &[u8]) {}
    }
    let cpu_type = &CpuType::ALL[0];
    let compiled = compile(PROGRAM, Mnemonics::English, cpu_type).expect("the program compiles");
    let program = Arc::new(compiled.program);
    let mut fickle = || {
        let rack = Rack::with_background(cpu_type, vec![Box::new(Fickle(0.into()))]).expect("it fits");
        Cpu::load(cpu_type, Arc::clone(&program), ENGINES[0].1, rack, Settings::default())
    };
    let scenario = Scenario::parse("scan 5").expect("a scenario");
    let mut recorder = Recorder::new(Subject { plants: true, ..Subject::default() }, &scenario);
    scenario.run_watched(&SymbolTable::default(), &mut fickle, &mut |happened| recorder.see(happened));
    assert!(recorder.trouble().is_some_and(|trouble| trouble.contains("two values at")), "{:?}", recorder.trouble());
    for (line, word) in [("power failure", "begin anew"), ("module 256 fails", "module 256 fails")] {
        let scenario = Scenario::parse(&format!("scan\n{line}\nscan")).expect("a scenario");
        let mut recorder = Recorder::new(Subject { plants: true, ..Subject::default() }, &scenario);
        scenario.run_watched(&SymbolTable::default(), &mut || fresh(ENGINES[0].1, Some(1)), &mut |happened| recorder.see(happened));
        assert!(recorder.trouble().is_some_and(|trouble| trouble.contains(word)), "{line}: {:?}", recorder.trouble());
    }
}

#[test]
fn a_stop_and_a_power_failure_are_in_the_recording() {
    let text = "retain m=0..31 t= c=\nset M 8.0=1\nscan 2\npower failure\nset I 0.0=1\nscan 9";
    let scenario = Scenario::parse(text).expect("a scenario");
    let (recording, states, _) = record(&scenario, ENGINES[0].1, None, &Rules::default());
    assert!(recording.contains("\npower failure\n") && recording.contains("\nset M 8.0=1\n"), "{recording}");
    let (again, other_states, failed) = record(&Scenario::parse(&recording).expect("a recording"), ENGINES[1].1, None, &Rules::default());
    assert_eq!((failed, other_states, again), (Vec::new(), states, recording));
    let folder = Folder::with(&[(
        "main.awl",
        "      A     I 0.0\n      JCN   on\n      CALL  SFC 46\non:   NOP   0\n      AN    I 0.0\n      =     Q 0.0\n",
    )]);
    folder
        .run(&["record", "main.awl", "--at", "30ms", "I 0.0=1", "--for", "1s", "--speed", "max", "-o", "stop.scenario"])
        .code(4)
        .stderr("4 scans");
    assert!(String::from_utf8_lossy(&folder.read("stop.scenario")).contains("scan\nexpect stop 16#457F\nend 4\n"));
    folder.run(&["test", "main.awl", "stop.scenario"]).code(0);
    folder.write("mended.awl", b"      AN    I 0.0\n      =     Q 0.0\n");
    folder.run(&["test", "mended.awl", "stop.scenario"]).code(1).stdout("`Q 0.0` should be 1 after scan 3 at 30 ms, and is 0");
    folder.write("worse.awl", b"      CALL  SFC 46\n");
    folder.run(&["test", "worse.awl", "stop.scenario"]).code(1).stdout("the CPU is in STOP, event 16#457F").stdout("after scan 0 at 0 ms");
    assert_eq!(OperatingMode::Stop.to_string(), "STOP");
}

fn examples() -> Vec<(String, PathBuf)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let entries = fs::read_dir(folder).expect("the folder of the examples").map(|entry| entry.expect("an entry").path());
    let mut examples: Vec<(String, PathBuf)> = entries
        .filter(|path| path.join("sieben.toml").is_file())
        .map(|path| (path.file_name().expect("a name").to_string_lossy().into_owned(), path))
        .collect();
    examples.sort();
    examples
}

/// The plants of the examples are recorded, and the recordings are replayed without them.
#[test]
fn the_story_of_every_example_is_recorded_and_replayed_on_both_engines() {
    let folder = Folder::new();
    for (name, example) in examples() {
        let example = example.to_str().expect("a path in UTF-8");
        let story = format!("{example}/{name}.scenario");
        let file = format!("{name}.scenario");
        folder.run(&["record", example, &story, "-o", &file, "--watch", "MD 0,MD 4"]).code(0);
        for engine in ["interpreter", "jit"] {
            folder.run(&["test", example, "--tests", &file, "--engine", engine]).code(0).stdout("1 passed, 0 failed");
        }
    }
}

/// A killed process leaves whole scans, which are a test.
#[test]
fn a_process_that_is_killed_leaves_whole_scans() {
    let folder = Folder::with(&[("main.awl", "      AN    M 0.0\n      =     M 0.0\n      =     Q 0.0\n")]);
    let mut child = sieben(folder.path(), &["record", "main.awl", "-o", "killed.scenario", "--cycle", "1ms", "--speed", "10x"])
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("the binary starts");
    let deadline = Instant::now() + Duration::from_secs(30);
    let path = folder.path().join("killed.scenario");
    while fs::metadata(&path).map_or(0, |metadata| metadata.len()) == 0 {
        assert!(Instant::now() < deadline, "nothing is written");
        std::thread::yield_now();
    }
    child.kill().expect("the child can be ended");
    child.wait().expect("the child can be asked");
    let text = String::from_utf8(folder.read("killed.scenario")).expect("text");
    assert!(!text.contains("\nend ") && text.matches("\nscan").count() > 100, "{text}");
    folder.run(&["test", "main.awl", "--tests", "killed.scenario"]).code(0).stdout("1 passed").stderr("P6263");
    folder.run(&["trace", "main.awl", "killed.scenario", "--last", "10"]).code(0).stderr("P6263");
    folder.write("other.awl", b"      SET\n      =     Q 0.0\n");
    folder.run(&["test", "other.awl", "--tests", "killed.scenario"]).code(1).stdout("was cut off").stdout("recorded with `main.awl`");
}

#[test]
fn a_full_disk_is_told() {
    let folder = Folder::with(&[("main.awl", "      A     I 0.0\n      =     Q 0.0\n")]);
    if Path::new("/dev/full").exists() {
        folder.run(&["record", "main.awl", "-o", "/dev/full", "--for", "1s", "--speed", "max"]).code(2).stderr("P6290");
    }
    folder.run(&["record", "main.awl", "-o", ".", "--for", "1s", "--speed", "max"]).code(2).stderr("is a folder");
}

/// A slip in the name of a result must not cost the program.
#[test]
fn results_do_not_replace_sources() {
    let source = "      A     I 0.0\n      =     Q 0.0\n";
    let folder = Folder::with(&[("main.awl", source), ("story.scenario", "scan 5\n")]);
    for command in [
        &["record", "main.awl", "-o", "main.awl", "--for", "1s", "--speed", "max"][..],
        &["trace", "main.awl", "--scans", "5", "--record", "main.awl"],
        &["trace", "main.awl", "--scans", "5", "--csv", "main.awl"],
        &["step", "main.awl", "--scans", "5", "--commands", "story.scenario", "--record", "main.awl"],
        &["test", "main.awl", "--tests", "story.scenario", "--junit", "main.awl"],
        &["record", "main.awl", "story.scenario", "-o", "./story.scenario"],
    ] {
        folder.run(command).code(2).stderr("P6013").stderr("replace it");
    }
    assert_eq!(fs::read_to_string(folder.0.join("main.awl")).expect("the source is there"), source);
    assert_eq!(fs::read_to_string(folder.0.join("story.scenario")).expect("the scenario is there"), "scan 5\n");
}

/// The report has all that a machine wants, too.
#[test]
fn a_difference_is_told_to_machines() {
    let folder =
        Folder::with(&[("old.awl", "      A     I 0.0\n      =     Q 0.0\n"), ("new.awl", "      AN    I 0.0\n      =     Q 0.0\n")]);
    folder.run(&["record", "old.awl", "--at", "25ms", "I0.0=1", "--scans", "10", "--speed", "max", "-o", "a.scenario", "--json"]).code(0);
    let json = folder.run(&["test", "new.awl", "--tests", "a.scenario", "--json"]).code(1).json();
    let test = &json["tests"][0];
    assert_eq!((test["at_scan"].as_u64(), test["at_ms"].as_u64()), (Some(0), Some(0)), "{json:#}");
    assert_eq!((test["left"].as_str(), test["right"].as_str(), test["left_type"].as_str()), (Some("0"), Some("1"), Some("BOOL")));
    assert!(test["more"].to_string().contains("new.awl:2"), "{json:#}");
    folder.run(&["test", "new.awl", "--tests", "a.scenario", "--ignore", "Q 0.0"]).code(0);
    folder.run(&["test", "new.awl", "--tests", "a.scenario", "--ignore", "Q 0.1"]).code(2).stderr("P7050");
    folder.run(&["test", "new.awl", "--tests", "a.scenario", "--junit", "a.xml"]).code(1);
    assert!(String::from_utf8_lossy(&folder.read("a.xml")).contains("failures=\"1\""));
}

/// What a name with a format was recorded as is the same value when it is read again, also where the format has no notation for it.
#[test]
fn values_in_formats_come_back_from_a_recording() {
    let source = "      L     W#16#0A00\n      T     MW    0\n      L     1.0e+001\n      T     MD    4\n      A     I     0.0\n      L     S5T#5S\n      SE    T     1\n";
    let symbols = "\"Symbol\",\"Address\",\"Type\",\"Comment\"\n\"lamp:INT\",\"Q 4.0\",\"BOOL\",\"\"\n";
    let folder = Folder::with(&[("main.awl", source), ("symbols.csv", symbols)]);
    let names = "MW0:S5TIME,MW0:BCD,MW0:BIN,MW0:DEC,MD4:REAL,MD4:CHAR,MD4:POINTER,T1:S5TIME,\"lamp:INT\"";
    let record = ["record", "main.awl", "symbols.csv", "--at", "25ms", "I0.0=1", "--scans", "10", "--speed", "max", "--watch", names, "-o"];
    folder.run(&[&record[..], &["a.scenario"]].concat()).code(0);
    let recorded = String::from_utf8_lossy(&folder.read("a.scenario")).into_owned();
    for line in ["MD4:REAL=10.0", "MW0:S5TIME=16#0A00", "T1:S5TIME=S5T#4S990MS", "\"lamp:INT\"=0"] {
        assert!(recorded.contains(line), "`{line}` is missing in\n{recorded}");
    }
    folder.run(&["test", "main.awl", "symbols.csv", "--tests", "a.scenario"]).code(0);
    fs::write(folder.0.join("b.scenario"), recorded.replace("MD4:REAL=10.0", "MD4:REAL=10.5")).expect("a file of the test");
    folder.run(&["test", "main.awl", "symbols.csv", "--tests", "b.scenario"]).code(1).stdout("`MD4:REAL` should be 10.5");
}
