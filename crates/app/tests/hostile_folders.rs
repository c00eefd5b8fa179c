//! Folders that come from strangers: what Sieben writes in them by its own choice stays in them, and nothing in them holds it up.
#![cfg(target_os = "linux")]

mod command;

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use command::{Folder, Run, sieben};
use rustix::fs::{CWD, FileType, Mode, mknodat};

/// A command that has not ended by then never will.
const DEADLINE: Duration = Duration::from_secs(60);
const COUNT: &str = "DATA_BLOCK DB 1\nSTRUCT\n n : DINT ;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
    ORGANIZATION_BLOCK OB 1\nBEGIN\nL DB1.DBD 0; L L#1; +D; T DB1.DBD 0; T MD 0;\nEND_ORGANIZATION_BLOCK\n";
const RUN: [&str; 5] = ["run", "--for", "30ms", "--cycle", "5ms"];
/// What lies outside the project, and must stay as it is.
const OUTSIDE: &str = "the data of somebody else";

fn project() -> Folder {
    let folder = Folder::with(&[("p/sieben.toml", ""), ("p/main.awl", COUNT), ("outside.txt", OUTSIDE)]);
    fs::create_dir(folder.path().join("elsewhere")).expect("the folder is writable");
    folder
}

fn inside(folder: &Folder) -> PathBuf {
    folder.path().join("p")
}

fn kept(folder: &Folder, name: &str) -> PathBuf {
    fs::create_dir_all(folder.path().join("p/.sieben")).expect("the folder is writable");
    folder.path().join("p/.sieben").join(name)
}

fn pipe(path: &Path) {
    mknodat(CWD, path, FileType::Fifo, Mode::from_raw_mode(0o644), 0).expect("pipes can be made");
}

/// As [`Run::of`], but a command that hangs fails the test and not the whole suite.
fn run(folder: &Path, arguments: &[&str]) -> Run {
    let mut child = sieben(folder, arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the binary starts");
    let begin = Instant::now();
    while child.try_wait().expect("a status").is_none() {
        if begin.elapsed() > DEADLINE {
            let _ = child.kill();
            panic!("sieben {} does not end", arguments.join(" "));
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    let output = child.wait_with_output().expect("what it said");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Run { arguments: arguments.join(" "), stdout: text(output.stdout), stderr: text(output.stderr), code: output.status.code() }
}

/// The names of all files that a run reads or writes in the folder for the data of a project.
const NAMES: [&str; 7] =
    ["retain.bin", "retain.bin.new", "retain.bin.lock", "retain.bin.synced", "retain.bin.synced.new", "retain.bin.old", ".gitignore"];

#[test]
fn no_link_leads_retentive_data_out_of_the_project() {
    for name in NAMES {
        for target in ["outside.txt", "not there.txt"] {
            let folder = project();
            let link = kept(&folder, name);
            symlink(folder.path().join(target), &link).expect("links can be made");
            run(&inside(&folder), &RUN).code(2).stderr("P8033").stderr(&format!(".sieben/{name}`: it is a symbolic link"));
            assert!(link.is_symlink(), "{name}: it is left as it is");
            assert_eq!(folder.read("outside.txt"), OUTSIDE.as_bytes(), "{name}");
            assert!(!folder.path().join("not there.txt").exists(), "{name}: nothing is made outside");
            run(&inside(&folder), &[&RUN[..], &["--no-retain"]].concat()).code(0);
        }
        let folder = project();
        fs::hard_link(folder.path().join("outside.txt"), kept(&folder, name)).expect("links can be made");
        run(&inside(&folder), &RUN).code(2).stderr("P8033").stderr("it has other names (hard links)");
        assert_eq!(folder.read("outside.txt"), OUTSIDE.as_bytes(), "{name}");
    }
}

#[test]
fn a_pipe_or_a_folder_in_the_place_of_data_does_not_hold_a_run_up() {
    for name in NAMES {
        let folder = project();
        pipe(&kept(&folder, name));
        run(&inside(&folder), &RUN).code(2).stderr("P8033").stderr("it is a pipe, a device or a socket");
        let folder = project();
        fs::create_dir(kept(&folder, name)).expect("the folder is writable");
        run(&inside(&folder), &RUN).code(2).stderr("P8033").stderr("it is a folder");
    }
    let folder = project();
    for special in ["/dev/null", "/dev/full", "pipe"] {
        if special == "pipe" {
            pipe(&folder.path().join("pipe"));
        }
        let arguments = ["run", "p/main.awl", "--speed", "max", "--for", "1s", "--retain", special];
        run(folder.path(), &arguments).code(2).stderr("P8033").stderr("it is a pipe, a device or a socket");
    }
}

#[test]
fn the_folder_for_the_data_is_a_folder_of_the_project() {
    let folder = project();
    symlink("../elsewhere", inside(&folder).join(".sieben")).expect("links can be made");
    run(&inside(&folder), &RUN).code(2).stderr("P8033").stderr("`.sieben`: it is a symbolic link");
    assert_eq!(fs::read_dir(folder.path().join("elsewhere")).expect("the folder").count(), 0, "nothing is made outside");
    // Whoever wants the data on another disk says so.
    let arguments = ["run", "p", "--for", "30ms", "--retain", "elsewhere/data.bin"];
    run(folder.path(), &arguments).code(0);
    run(folder.path(), &arguments).code(0).stderr("is restored");
    let folder = project();
    folder.write("p/.sieben", b"a file");
    run(&inside(&folder), &RUN).code(2).stderr("P8033").stderr("`.sieben`: it is a file and no folder");
}

/// A run that goes on until it is killed.
struct Running(Child);

impl Running {
    fn start(folder: &Folder, arguments: &[&str]) -> Self {
        let said = fs::File::create(folder.path().join("said.txt")).expect("the folder is writable");
        let mut command = sieben(&inside(folder), &[&["run", "--for", "120s", "--cycle", "5ms"], arguments].concat());
        Self(command.stdout(Stdio::null()).stderr(said).spawn().expect("the binary starts"))
    }
    /// Ends it as Ctrl-C does.
    fn end(mut self) -> ExitStatus {
        let pid = rustix::process::Pid::from_child(&self.0);
        rustix::process::kill_process(pid, rustix::process::Signal::INT).expect("it runs");
        let (sender, receiver) = mpsc::channel();
        std::thread::scope(|scope| {
            scope.spawn(|| sender.send(self.0.wait()));
            receiver.recv_timeout(DEADLINE).expect("Ctrl-C ends it").expect("a status")
        })
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[track_caller]
fn wait_until(what: &str, mut done: impl FnMut() -> bool) {
    let begin = Instant::now();
    while !done() {
        assert!(begin.elapsed() < DEADLINE, "{what}");
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn data_that_is_removed_under_a_run_is_made_again() {
    for sync in ["1s", "0ms"] {
        let folder = project();
        folder.write("p/sieben.toml", format!("[cpu]\nretain = {{ sync = \"{sync}\" }}\n").as_bytes());
        let name = if sync == "1s" { "retain.bin" } else { "retain.bin.synced" };
        let running = Running::start(&folder, &[]);
        wait_until("the run keeps its data", || kept(&folder, name).exists() && kept(&folder, "retain.bin.synced").exists());
        // As `git clean -dfx` does.
        fs::remove_dir_all(inside(&folder).join(".sieben")).expect("it can be removed");
        let said = || String::from_utf8_lossy(&folder.read("said.txt")).into_owned();
        wait_until("the run says so", || said().contains("P8034"));
        assert!(said().contains(&format!(".sieben/{name}` was removed or replaced while the CPU was running")), "{}", said());
        wait_until("all is there again", || ["retain.bin.lock", ".gitignore", name].iter().all(|name| kept(&folder, name).exists()));
        run(&inside(&folder), &RUN).code(2).stderr("P6031");
        assert!(running.end().success());
        run(&inside(&folder), &RUN).code(0).stderr("is restored");
    }
}

#[test]
fn a_second_run_does_not_get_in_by_removing_the_lock() {
    let folder = project();
    let first = Running::start(&folder, &[]);
    wait_until("the run keeps its data", || kept(&folder, "retain.bin").exists() && kept(&folder, "retain.bin.synced").exists());
    fs::remove_file(kept(&folder, "retain.bin.lock")).expect("it can be removed");
    run(&inside(&folder), &RUN).code(2).stderr("P6031");
    fs::write(kept(&folder, "another"), "").expect("the folder is writable");
    fs::rename(kept(&folder, "another"), kept(&folder, "retain.bin.lock")).expect("it can be replaced");
    run(&inside(&folder), &RUN).code(2).stderr("P6031");
    // A hard link gives the data no second owner.
    fs::hard_link(kept(&folder, "retain.bin"), inside(&folder).join("copy.bin")).expect("links can be made");
    run(&inside(&folder), &[&RUN[..], &["--retain", "copy.bin"]].concat()).code(2).stderr("P8033");
    fs::remove_file(inside(&folder).join("copy.bin")).expect("it can be removed");
    // With everything gone the second run begins anew, and the first one does not write over what it keeps.
    fs::remove_dir_all(inside(&folder).join(".sieben")).expect("it can be removed");
    let second = sieben(&inside(&folder), &["run", "--for", "120s"]).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
    let second = Running(second.expect("the binary starts"));
    let said = || String::from_utf8_lossy(&folder.read("said.txt")).into_owned();
    wait_until("one of them keeps its data", || kept(&folder, "retain.bin").exists());
    // Which one was first to take the lock is open; the other one says that it does not keep.
    drop(first);
    drop(second);
    run(&inside(&folder), &RUN).code(0).stderr("is restored");
    assert!(!said().contains("panic"), "{}", said());
}

/// Calls the binary with a limit on the size of files, as a disk that is full is for everyone, also for root.
fn with_file_blocks(folder: &Path, blocks: u32, arguments: &[&str]) -> Run {
    let script = format!("ulimit -f {blocks}; exec \"$0\" \"$@\"");
    let output = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_sieben")])
        .args(arguments)
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .env("LC_ALL", "C")
        .stdin(Stdio::null())
        .output()
        .expect("a shell");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Run { arguments: arguments.join(" "), stdout: text(output.stdout), stderr: text(output.stderr), code: output.status.code() }
}

#[test]
fn a_full_disk_leaves_nothing_that_counts_as_data() {
    for blocks in [0, 1, 16] {
        let folder = project();
        let full = with_file_blocks(&inside(&folder), blocks, &RUN).code(0).stderr("P8030").stdout("RUN: ran for 30 ms");
        assert_eq!(full.stderr.matches("P8030]").count(), 1, "it is said once\n{}", full.stderr);
        let left: Vec<_> = fs::read_dir(kept(&folder, "."))
            .expect("the folder")
            .map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"))
            .filter(|name| name != "retain.bin.lock" && (blocks == 0 || name != ".gitignore"))
            .collect();
        assert_eq!(left, [""; 0], "{blocks} blocks");
        let next = run(&inside(&folder), &RUN).code(0);
        assert!(!next.stderr.contains("P803"), "{}", next.stderr);
        run(&inside(&folder), &RUN).code(0).stderr("is restored");
        assert_eq!(folder.read("p/.sieben/.gitignore"), b"*\n");
    }
    // What was there before a disk was full stays.
    let folder = project();
    run(&inside(&folder), &RUN).code(0);
    let before = folder.read("p/.sieben/retain.bin");
    with_file_blocks(&inside(&folder), 1, &RUN).code(0).stderr("P8030").stderr("is restored");
    assert_eq!(folder.read("p/.sieben/retain.bin"), before);
}

#[test]
fn empty_files_are_no_data() {
    let folder = project();
    for name in ["retain.bin", "retain.bin.synced"] {
        fs::write(kept(&folder, name), "").expect("the folder is writable");
    }
    run(&inside(&folder), &RUN).code(0).stderr("P8031").stderr("the retentive data is empty");
    run(&inside(&folder), &RUN).code(0).stderr("is restored");
}

/// A file of retentive data with another number in every record of it, and right checksums.
fn renumbered(mut bytes: Vec<u8>, sequence: u64) -> Vec<u8> {
    let number = |bytes: &[u8]| bytes.iter().fold(0, |number: usize, &byte| number << 8 | usize::from(byte));
    let capacity = number(&bytes[16..24]);
    for slot in [4096, 4096 + capacity] {
        let length = number(&bytes[slot + 24..slot + 28]);
        if length == 0 {
            continue;
        }
        bytes[slot..slot + 8].copy_from_slice(&sequence.to_be_bytes());
        let mut hasher = crc32fast::Hasher::new();
        hasher.update(&bytes[slot..slot + 28]);
        hasher.update(&bytes[slot + 32..slot + 32 + length]);
        bytes[slot + 28..slot + 32].copy_from_slice(&hasher.finalize().to_be_bytes());
    }
    bytes
}

/// As `COUNT`; the startup stops the CPU when the runs before have counted to more than 18.
const LIMITED: &str =
    "ORGANIZATION_BLOCK OB 100\nBEGIN\nL DB1.DBD 0; L L#18; >D; JCN ok; CALL SFC 46; ok: NOP 0;\nEND_ORGANIZATION_BLOCK\n";

#[test]
fn a_forged_number_does_not_end_the_keeping() {
    const FIVE_SCANS: [&str; 7] = ["run", "main.awl", "--speed", "max", "--for", "50ms", "--retain"];
    for sequence in [3, u64::MAX, u64::MAX - 1, 1 << 63, (1 << 56) + 1, 1 << 56] {
        for names in [["data.bin", "data.bin.synced"].as_slice(), &["data.bin"], &["data.bin.synced"]] {
            let folder = Folder::with(&[("main.awl", &format!("{COUNT}{LIMITED}"))]);
            let runs = [&FIVE_SCANS[..], &["data.bin"]].concat();
            run(folder.path(), &runs).code(0);
            for name in names {
                folder.write(name, &renumbered(folder.read(name), sequence));
            }
            for already in [5, 10, 15] {
                let run = run(folder.path(), &runs);
                assert_eq!(run.code, Some(0), "{sequence} in {names:?}, {already} scans: {}", run.stderr);
                run.stderr("is restored");
            }
            let run = run(folder.path(), &runs);
            assert_eq!(run.code, Some(4), "{sequence} in {names:?}: 20 scans are kept, not {}", run.stderr);
        }
    }
}

#[test]
fn pages_of_coverage_are_not_written_through_links() {
    let test = "TEST 't'\nSCAN(1);\nASSERT_TRUE(TRUE);\nEND_TEST\n";
    for name in ["index.html", "main.awl.html"] {
        let folder = Folder::with(&[("main.awl", COUNT), ("main.test.st", test), ("outside.txt", OUTSIDE)]);
        fs::create_dir(folder.path().join("pages")).expect("the folder is writable");
        symlink("../not there.txt", folder.path().join("pages").join(name)).expect("links can be made");
        run(folder.path(), &["test", ".", "--coverage-html", "pages"]).code(2).stderr("P6300").stderr("it is a symbolic link");
        assert!(!folder.path().join("not there.txt").exists());
        fs::remove_file(folder.path().join("pages").join(name)).expect("it can be removed");
        pipe(&folder.path().join("pages").join(name));
        run(folder.path(), &["test", ".", "--coverage-html", "pages"]).code(2).stderr("P6300").stderr("it is a pipe");
    }
}

#[test]
fn a_diagram_of_a_failed_test_is_not_written_through_a_link() {
    let test = "VAR n : INT; END_VAR\nTEST 't'\nSCAN(1);\nSCAN(1);\nASSERT_EQ(n, 5);\nEND_TEST\n";
    let folder = Folder::with(&[("main.awl", COUNT), ("main.test.st", test), ("outside.txt", OUTSIDE)]);
    fs::create_dir(folder.path().join("d")).expect("the folder is writable");
    symlink("../outside.txt", folder.path().join("d/t.svg")).expect("links can be made");
    run(folder.path(), &["test", ".", "--svg", "d"]).code(1);
    assert_eq!(folder.read("outside.txt"), OUTSIDE.as_bytes());
}

#[test]
fn a_full_disk_leaves_no_half_of_a_project() {
    for example in [&["--example", "elevator"][..], &[]] {
        let folder = Folder::new();
        let full = with_file_blocks(folder.path(), 1, &[&["new", "deep/er/pump"], example].concat());
        full.code(2).stderr("P6013").stderr("cannot be written");
        assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 0, "nothing stays");
        // A folder that was there before stays, and is empty again.
        fs::create_dir(folder.path().join("pump")).expect("the folder is writable");
        with_file_blocks(folder.path(), 1, &[&["new", "pump"], example].concat()).code(2);
        assert_eq!(fs::read_dir(folder.path().join("pump")).expect("the folder").count(), 0);
        run(folder.path(), &[&["new", "pump"], example].concat()).code(0);
        run(folder.path(), &["check", "pump"]).code(0);
    }
}

/// What a terminal would obey, or what would turn a line around.
const HOSTILE: &str = "\u{1B}]0;owned\u{7}\u{1B}[2J\u{9B}31m\u{202E}";

#[track_caller]
fn shows_nothing_hidden(run: &Run) {
    for text in [&run.stdout, &run.stderr] {
        let hidden = text.chars().find(|c| c.is_control() && !"\n\t".contains(*c) || ('\u{202A}'..='\u{202E}').contains(c));
        assert_eq!(hidden, None, "sieben {}\n{}", run.arguments, text.escape_debug());
    }
}

#[test]
fn no_text_of_others_commands_the_terminal() {
    let file = format!("evil{}.awl", HOSTILE.replace('/', ""));
    let source = format!(
        "ORGANIZATION_BLOCK OB 1\nTITLE = {HOSTILE}\nBEGIN\nNETWORK\nTITLE = {HOSTILE}\nA \"x{HOSTILE}y\"; // {HOSTILE}\n= Q 4.0; // {HOSTILE}\nEND_ORGANIZATION_BLOCK\n"
    );
    let symbols = format!("symbol,address,type,comment\nx{HOSTILE}y,I 0.0,BOOL,{HOSTILE}\n");
    let toml = format!("[project]\nname = \"{}\"\n", HOSTILE.chars().map(|c| format!("\\u{:04X}", u32::from(c))).collect::<String>());
    let good = Folder::with(&[(&file, &source), ("symbols.csv", &symbols)]);
    good.write("p/sieben.toml", toml.as_bytes());
    good.write("p/main.awl", COUNT.as_bytes());
    let bad = Folder::with(&[(&file, &source.replace("= Q 4.0", "= Q {HOSTILE}"))]);
    let st = format!("PROGRAM P\nVAR a : INT; END_VAR\n(* {HOSTILE} *) a := 'x{HOSTILE}';\nx{HOSTILE} := 1;\nEND_PROGRAM\n");
    bad.write(&format!("e{HOSTILE}.st"), st.as_bytes());
    let x = format!("x{HOSTILE}y");
    for (folder, arguments) in [
        (&good, &["check", "."][..]),
        (&good, &["check", &file, "symbols.csv"]),
        (&good, &["check", ".", "--json"]),
        (&bad, &["check", "."]),
        (&bad, &["check", ".", "--json"]),
        (&good, &["run", "p", "--speed", "max", "--for", "1s"]),
        (&good, &["exec", ".", "--show", &x]),
        (&good, &["exec", ".", "--show", &x, "--json"]),
        (&good, &["exec", ".", "--show", HOSTILE]),
        (&good, &["symbols", "symbols.csv"]),
        (&good, &["symbols", "symbols.csv", "--json"]),
        (&good, &["refs", "."]),
        (&good, &["refs", ".", "--json"]),
        (&good, &["refs", ".", "--html"]),
        (&good, &["structure", "."]),
        (&good, &["assignments", "."]),
        (&good, &["trace", ".", "--scans", "3"]),
        (&good, &["trace", ".", "--scans", "3", "--svg", "-"]),
        (&good, &["step", ".", "--commands", "/dev/null"]),
        (&good, &["explain", HOSTILE]),
        (&good, &["check", HOSTILE]),
        (&good, &["check", &format!("--{HOSTILE}")]),
        (&good, &[HOSTILE]),
    ] {
        let run = run(folder.path(), arguments);
        assert_ne!(run.code, Some(70), "{}{}", run.stdout, run.stderr);
        shows_nothing_hidden(&run);
    }
    // It is shown, and at its place: the mark below a line stands below what it means.
    let shown = run(bad.path(), &["check", "."]);
    assert!(shown.stderr.contains("␛]0;owned␇␛[2J<U+009B>31m<U+202E>"), "{}", shown.stderr);
    // What goes into a file stays what it is.
    let escapes = "\u{9B}31m\u{202E}\u{85}";
    let folder = Folder::with(&[("main.awl", &format!("{COUNT}// {escapes}\n"))]);
    let formatted = run(folder.path(), &["fmt", "main.awl"]).code(0);
    assert!(formatted.stdout.contains(&format!("// {escapes}")), "{}", formatted.stdout.escape_debug());
}

#[test]
fn an_output_that_cannot_be_written_is_an_error() {
    let folder = Folder::with(&[("main.awl", COUNT)]);
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["help"],
        &["run", "--help"],
        &["completions", "bash"],
        &["explain", "L"],
        &["check", "main.awl"],
        &["exec", "main.awl", "--show", "MW0"],
        &["exec", "main.awl", "--show", "MW0", "--json"],
        &["fmt", "main.awl"],
        &["convert", "main.awl", "--mnemonics", "de"],
        &["refs", "main.awl"],
        &["structure", "main.awl", "--json"],
        &["assignments", "main.awl", "--html"],
        &["test", "main.awl"],
        &["trace", "main.awl", "--channels", "MW0"],
        &["record", "main.awl", "--watch", "MW0", "-o", "-", "--speed", "max", "--for", "1s"],
        &["step", "main.awl", "--commands", "/dev/null"],
        &["run", "main.awl", "--speed", "max", "--for", "1s"],
        &["new", "pump"],
    ] {
        let full = fs::File::options().write(true).open("/dev/full").expect("Linux has it");
        let output = sieben(folder.path(), arguments).stdout(full).output().expect("the binary starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains("the output cannot be written"), "{arguments:?}: {said}");
    }
}

#[test]
fn a_day_of_interrupts_in_one_scan_ends_with_the_time_of_a_test() {
    let program = format!("{COUNT}ORGANIZATION_BLOCK OB 35\nBEGIN\nL MD 4; L 1; +D; T MD 4;\nEND_ORGANIZATION_BLOCK\n");
    let toml = "[cyclic.35]\ninterval = \"1ms\"\n";
    let test = "TEST 't'\nSCAN(30);\nASSERT_TRUE(TRUE);\nEND_TEST\n";
    let folder = Folder::with(&[("main.awl", &program), ("main.test.st", test), ("sieben.toml", toml)]);
    let begin = Instant::now();
    run(folder.path(), &["test", ".", "--cycle", "24h", "--timeout", "1s"]).code(1).stdout("the test took too long and was given up");
    assert!(begin.elapsed() < Duration::from_secs(20), "{:?}", begin.elapsed());
    for verb in ["exec", "test", "trace", "step", "run", "record"] {
        run(folder.path(), &[verb, ".", "--cycle", "87599h"]).code(2).stderr("longer than 24 hours, the longest cycle");
    }
    run(folder.path(), &["exec", ".", "--scan-at", "0ms,87599h"]).code(2).stderr("P7009");
    folder.write("s.scenario", b"cycle 87599h\nscan\n");
    run(folder.path(), &["test", "main.awl", "s.scenario"]).code(2).stdout("longer than 24 hours");
}
