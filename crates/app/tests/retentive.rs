//! Retentive data as users meet it: run, end or kill, run again.

#[allow(unreachable_pub)] // The same file is a module of xtask.
#[path = "../../../xtask/src/soak/kill.rs"]
mod kill;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A project that counts its scans in DB 1 and MD 0, in a folder of its own.
struct Project(PathBuf);

const COUNT: &str = "DATA_BLOCK DB 1\nSTRUCT\n n : DINT ;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
    ORGANIZATION_BLOCK OB 1\nBEGIN\nL DB1.DBD 0; L L#1; +D; T DB1.DBD 0; T MD 0;\nEND_ORGANIZATION_BLOCK\n";

/// What came of a run.
struct Run {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

impl Project {
    fn new(toml: &str) -> Self {
        static NUMBER: AtomicUsize = AtomicUsize::new(0);
        let name = format!("sieben-retentive-{}-{}", std::process::id(), NUMBER.fetch_add(1, Ordering::Relaxed));
        let project = Self(std::env::temp_dir().join(name));
        fs::create_dir_all(&project.0).expect("the folder for temporary files is writable");
        project.write("sieben.toml", toml);
        project.write("main.awl", COUNT);
        project
    }
    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("the folder is writable");
    }
    fn path(&self, name: &str) -> PathBuf {
        self.0.join(".sieben").join(name)
    }
    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sieben"));
        command.arg("run").args(arguments).current_dir(&self.0).env("NO_COLOR", "1").env("LC_ALL", "C").stdin(Stdio::null());
        command
    }
    fn run(&self, arguments: &[&str]) -> Run {
        let output = self.command(&[arguments, &["--for", "30ms", "--cycle", "5ms"]].concat()).output().expect("the binary starts");
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        Run { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }
}

impl Drop for Project {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

impl Run {
    #[track_caller]
    fn says(self, code: i32, parts: &[&str]) -> Self {
        assert_eq!(self.code, Some(code), "{}{}", self.stdout, self.stderr);
        for part in parts {
            assert!(self.stderr.contains(part), "wanted `{part}`, got\n{}", self.stderr);
        }
        self
    }
    #[track_caller]
    fn does_not_say(self, part: &str) -> Self {
        assert!(!self.stderr.contains(part), "{}", self.stderr);
        self
    }
}

#[test]
fn the_next_run_goes_on_with_the_data_of_the_last_one() {
    for sync in ["1s", "0ms"] {
        let project = Project::new(&format!("[cpu]\nretain = {{ m = \"0..3\", c = \"\", sync = \"{sync}\" }}\n"));
        project.run(&[]).says(0, &[]).does_not_say("Retentive data");
        project.run(&[]).says(0, &["Retentive data of ", " is restored: 4 bytes of M, DB 1 (`.sieben/retain.bin`)."]);
        assert_eq!(fs::read_to_string(project.path(".gitignore")).expect("the folder of the data"), "*\n");
        let json: serde_json::Value = serde_json::from_str(&project.run(&["--json"]).says(0, &[]).stdout).expect("one object");
        assert!(json["retain"]["restored_scan"].is_u64(), "{json}");
        project.run(&["--no-retain"]).says(0, &[]).does_not_say("Retentive data");
        project.run(&["--speed", "max"]).says(0, &[]).does_not_say("Retentive data");
        project.run(&["--restart", "cold"]).says(0, &["Retentive data"]);
        project.run(&["--reset"]).says(0, &[]).does_not_say("Retentive data");
        project.run(&["main.awl"]).says(0, &[]).does_not_say("Retentive data");
        project.run(&["--restart", "hot"]).says(2, &["write `warm` or `cold`"]);
    }
}

#[test]
fn a_lone_file_keeps_data_where_it_is_told_to() {
    let project = Project::new("");
    for expected in ["", "Retentive data of scan "] {
        project.run(&["main.awl", "--retain", "data.bin", "--speed", "max"]).says(0, &[expected]);
    }
    assert!(!project.path("retain.bin").exists());
    project.run(&["main.awl", "--retain", "main.awl"]).says(2, &["P6032", "`main.awl` is no file of retentive data"]);
    project
        .run(&["main.awl", "--adopt", "nothing.bin", "--retain", "data.bin"])
        .says(2, &["P6032", "there is no retentive data in `nothing.bin`"]);
    assert_eq!(fs::read_to_string(project.0.join("main.awl")).expect("the source"), COUNT);
}

#[test]
fn data_is_adopted_by_a_run_that_keeps_nothing() {
    let project = Project::new("");
    project.run(&["main.awl", "--retain", "data.bin", "--speed", "max"]).says(0, &[]);
    let kept = fs::read(project.0.join("data.bin")).expect("the data");
    for arguments in [["main.awl", "--adopt", "data.bin"].as_slice(), &["--speed", "max", "--adopt", "data.bin"]] {
        project.run(arguments).says(0, &["is restored: 16 bytes of M, 8 counters, DB 1 (`data.bin`)"]);
    }
    assert_eq!(fs::read(project.0.join("data.bin")).expect("the data"), kept, "nothing is written to it");
    project.run(&["main.awl", "--adopt", "nothing.bin"]).says(2, &["P6032", "there is no retentive data in `nothing.bin`"]);
    project.run(&["main.awl", "--adopt", "main.awl"]).says(2, &["P6032", "`main.awl` is no file of retentive data"]);
}

#[test]
fn a_file_that_was_cut_is_damaged_and_set_aside() {
    let project = Project::new("");
    let arguments = ["main.awl", "--retain", "data.bin", "--speed", "max"];
    project.run(&arguments).says(0, &[]);
    let whole = fs::read(project.0.join("data.bin")).expect("the data");
    for length in [28, 100, 4096, 4100] {
        fs::remove_file(project.0.join("data.bin.synced")).expect("the other file");
        fs::write(project.0.join("data.bin"), &whole[..length]).expect("the folder is writable");
        project.run(&arguments).says(0, &["P8031", "the retentive data is damaged", "`data.bin.old`"]);
        assert_eq!(fs::read(project.0.join("data.bin.old")).expect("what was there"), &whole[..length]);
    }
}

#[cfg(unix)]
#[test]
fn a_link_to_a_file_of_data_stays_a_link() {
    let project = Project::new("");
    fs::create_dir(project.0.join("elsewhere")).expect("the folder is writable");
    std::os::unix::fs::symlink("elsewhere/data.bin", project.0.join("link.bin")).expect("links can be made");
    for said in ["", "is restored"] {
        project.run(&["main.awl", "--retain", "link.bin", "--speed", "max"]).says(0, &[said]);
    }
    assert!(project.0.join("link.bin").is_symlink());
    project.run(&["main.awl", "--retain", "elsewhere/data.bin", "--speed", "max"]).says(0, &["is restored"]);
}

#[test]
fn data_of_a_changed_program_is_set_aside_and_can_be_adopted() {
    let project = Project::new("[project]\nname = \"count\"\n");
    project.run(&[]).says(0, &[]);
    project.write("main.awl", &COUNT.replace("BEGIN\nL DB1", "BEGIN\nNOP 0; L DB1"));
    project.run(&[]).says(0, &["is restored", "DB 1"]);
    project.write("main.awl", &COUNT.replace("n : DINT ;", "n : DINT ;\n m : INT ;"));
    project.run(&[]).says(0, &["P8032", "other data blocks (DB 1)", "Run with `--adopt .sieben/retain.bin.old`"]);
    project.run(&[]).says(0, &["is restored"]).does_not_say("P8032");
    project
        .run(&["--adopt", ".sieben/retain.bin.old"])
        .says(0, &["P8032", "DB 1 could not be taken over", "16 bytes of M, 8 counters; DB 1 with initial"]);
    project.write("main.awl", COUNT);
    project.run(&["--adopt", ".sieben/retain.bin.old"]).says(0, &["is restored: 16 bytes of M, 8 counters, DB 1"]).does_not_say("P8032");
}

#[test]
fn damaged_data_is_said_to_be_damaged() {
    let project = Project::new("");
    project.run(&[]).says(0, &[]);
    let damage = |name: &str, ranges: &[std::ops::Range<usize>]| {
        let mut bytes = fs::read(project.path(name)).expect("the file is there");
        for range in ranges {
            for byte in &mut bytes[range.clone()] {
                *byte ^= 0x55;
            }
        }
        fs::write(project.path(name), bytes).expect("the file is writable");
    };
    let slots = [4100..4200, 90_000..95_000];
    damage("retain.bin", &slots);
    project.run(&[]).says(0, &["is restored"]).does_not_say("P8031");
    damage("retain.bin", &slots);
    damage("retain.bin.synced", &slots);
    let before = fs::read(project.path("retain.bin")).expect("the file is there");
    project.run(&[]).says(0, &["P8031", "retain.bin.old"]).does_not_say("is restored");
    assert_eq!(fs::read(project.path("retain.bin.old")).ok(), Some(before), "nothing is thrown away");
    fs::write(project.path("retain.bin"), "something else").expect("the file is writable");
    project.run(&[]).says(0, &["is restored", "a write that was cut short is left out"]);
    for name in ["retain.bin", "retain.bin.synced"] {
        fs::write(project.path(name), "").expect("the file is writable");
    }
    project.run(&[]).says(0, &["P8031", "the retentive data is empty"]).does_not_say("is restored");
    fs::remove_file(project.path("retain.bin")).expect("the file is there");
    fs::create_dir(project.path("retain.bin")).expect("the folder is writable");
    project.run(&[]).says(2, &["P8033", "`.sieben/retain.bin`: it is a folder"]);
}

#[test]
fn two_runs_do_not_share_their_data() {
    let project = Project::new("");
    let mut first = project.command(&["--for", "60s"]).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the binary starts");
    let deadline = std::time::Instant::now() + std::time::Duration::from_secs(20);
    while !project.path("retain.bin").exists() {
        assert!(std::time::Instant::now() < deadline, "the first run begins");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let second = project.run(&[]);
    let other = project.run(&["--retain", "other.bin"]);
    first.kill().and_then(|()| first.wait()).expect("the run can be killed");
    second.says(2, &["P6031", "another run uses the retentive data"]);
    other.says(0, &[]);
    project.run(&[]).says(0, &["is restored"]);
}

#[cfg(target_os = "linux")]
#[test]
fn twenty_kills_lose_at_most_the_running_scan() {
    for (sync, kills) in [("1s", 16), ("0ms", 4)] {
        let folder = std::env::temp_dir().join(format!("sieben-kill-{}-{sync}", std::process::id()));
        let outcome = kill::run(Path::new(env!("CARGO_BIN_EXE_sieben")), &folder, kills, sync, |_| {});
        let outcome = outcome.unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(outcome.kills, kills);
        assert!(outcome.scans > 0 && outcome.looked_at > 0, "{outcome:?}");
    }
}
