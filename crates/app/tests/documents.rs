//! What documents show is what happens: commands print what the page says, and the page of a problem produces it.
//!
//! A fence with a name (`stl add.awl`) is a file; a `console` fence runs its `$ sieben …` lines beside the files of the page.
//! `UPDATE_DOCUMENTS=1 cargo test --test documents` writes the printed lines into the pages.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use sieben_model::problems::Problem;

/// A fence of a page, by its lines.
struct Fence<'a> {
    language: &'a str,
    name: &'a str,
    /// Index of the first line of the code.
    first: usize,
    lines: Vec<&'a str>,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the crate lies in the project")
}

fn fences<'a>(lines: &[&'a str]) -> Vec<Fence<'a>> {
    let mut fences = Vec::new();
    let mut open: Option<Fence<'a>> = None;
    for (index, &line) in lines.iter().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(words)) => {
                let mut words = words.split_whitespace();
                let (language, name) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
                open = Some(Fence { language, name, first: index + 1, lines: Vec::new() });
            }
            (Some(_), Some(_)) => fences.extend(open.take()),
            (Some(fence), None) => fence.lines.push(line),
            (None, None) => {}
        }
    }
    fences
}

/// Whether a fence shows a program: STL, a diagram, ST of IEC 61131-3, SCL, or a test file.
fn is_source(language: &str) -> bool {
    matches!(language, "stl" | "lad" | "fbd" | "st" | "scl" | "test")
}

/// The file that an example without a name is written to: its end says the language.
fn example_of(language: &str) -> String {
    let ending = match language {
        "stl" => "awl",
        "test" => "test.st",
        other => other,
    };
    format!("example.{ending}")
}

/// What looks at an example: test files are run; what cannot be drawn is said when it is to be drawn.
fn verb_of(language: &str, code: &str) -> &'static str {
    match language {
        "test" => "test --json",
        _ if code.starts_with("P9") => "convert --to lad",
        _ => "check --json",
    }
}

/// Pages that people read, each with its path from the root.
fn pages() -> Vec<(String, String)> {
    fn collect(folder: &Path, pages: &mut Vec<PathBuf>) {
        let mut entries: Vec<PathBuf> =
            fs::read_dir(folder).expect("docs is a folder").map(|entry| entry.expect("docs can be read").path()).collect();
        entries.sort();
        for path in entries {
            if path.is_dir() {
                collect(&path, pages);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                pages.push(path);
            }
        }
    }
    let root = root();
    let mut paths = vec![root.join("README.md")];
    collect(&root.join("docs"), &mut paths);
    let name = |path: &Path| path.strip_prefix(&root).expect("a page lies in the project").to_string_lossy().replace('\\', "/");
    paths.iter().map(|path| (name(path), fs::read_to_string(path).expect("a page is UTF-8").replace("\r\n", "\n"))).collect()
}

/// A fresh folder with the files of a page.
fn folder_of(page: &str, fences: &[Fence<'_>]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("documents").join(page.replace(['/', '.'], "-"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the folder of the test can be made");
    for fence in fences.iter().filter(|fence| !fence.name.is_empty()) {
        let path = folder.join(fence.name);
        fs::create_dir_all(path.parent().expect("a file lies in a folder")).expect("the folder of the test can be made");
        fs::write(path, fence.lines.join("\n") + "\n").expect("a file of the test can be written");
    }
    folder
}

/// Words of a command; double quotes hold blanks together.
fn words(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quoted = false;
    for c in command.trim().chars() {
        match c {
            '"' => quoted = !quoted,
            ' ' if !quoted => words.push(String::new()),
            c => words.last_mut().expect("there is a word").push(c),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Commands in documents take milliseconds; one that takes so long hangs.
const DEADLINE: Duration = Duration::from_secs(20);

/// What a command prints, errors behind the rest, and its exit code if it is not 0.
fn run(folder: &Path, command: &str) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_sieben"))
        .args(words(command))
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .env("LC_ALL", "C")
        .env("COLUMNS", "100")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary can be started");
    let (mut stdout, mut stderr) = (child.stdout.take().expect("stdout is piped"), child.stderr.take().expect("stderr is piped"));
    let stdout = thread::spawn(move || read_all(&mut stdout));
    let stderr = thread::spawn(move || read_all(&mut stderr));
    let started = Instant::now();
    let status = loop {
        match child.try_wait().expect("the child can be asked") {
            Some(status) => break status.code(),
            None if started.elapsed() > DEADLINE => {
                child.kill().expect("the child can be ended");
                child.wait().expect("the child can be asked");
                break None;
            }
            None => thread::sleep(Duration::from_millis(2)),
        }
    };
    let mut text = stdout.join().expect("stdout is read") + &stderr.join().expect("stderr is read");
    text.truncate(text.trim_end().len());
    match status {
        Some(0) => text,
        Some(code) => format!("{text}\n[exit code {code}]"),
        None => format!("{text}\n[did not end]"),
    }
}

fn read_all(pipe: &mut impl Read) -> String {
    let mut bytes = Vec::new();
    // What was printed before the pipe broke still counts.
    let _ = pipe.read_to_end(&mut bytes);
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The lines that a `console` fence should have.
fn replay(folder: &Path, fence: &Fence<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    for line in &fence.lines {
        let Some(command) = line.strip_prefix("$ ") else { continue };
        lines.push((*line).to_owned());
        if let Some(arguments) = command.strip_prefix("sieben") {
            // A blank at the end of a line would not survive an editor.
            lines.extend(run(folder, arguments).lines().map(|line| line.trim_end().to_owned()));
        }
    }
    lines
}

#[test]
fn commands_in_documents_print_what_the_page_says() {
    let update = std::env::var_os("UPDATE_DOCUMENTS").is_some();
    let mut failures = Vec::new();
    for (name, text) in pages() {
        let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
        let borrowed: Vec<&str> = text.split('\n').collect();
        let fences = fences(&borrowed);
        if !fences.iter().any(|fence| fence.language == "console") {
            continue;
        }
        let folder = folder_of(&name, &fences);
        // From the last to the first, so that the lines before keep their numbers; the files are independent of the order.
        for fence in fences.iter().filter(|fence| fence.language == "console").rev() {
            let printed = replay(&folder, fence);
            if printed != fence.lines {
                failures.push(format!(
                    "{name}:{}: the page says\n{}\nbut the commands print\n{}\n",
                    fence.first,
                    fence.lines.join("\n"),
                    printed.join("\n")
                ));
                lines.splice(fence.first..fence.first + fence.lines.len(), printed);
            }
        }
        if update && lines != borrowed {
            fs::write(root().join(&name), lines.join("\n")).expect("a page can be written");
        }
    }
    assert!(update || failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_page_of_a_problem_produces_it() {
    let mut failures = Vec::new();
    let mut shown = 0;
    for (name, text) in pages() {
        let Some(code) = name.strip_prefix("docs/problems/").and_then(|name| name.strip_suffix(".md")) else { continue };
        assert!(Problem::from_code(code).is_some(), "{name} is the page of no problem");
        let lines: Vec<&str> = text.split('\n').collect();
        let fences = fences(&lines);
        let Some(first) = fences.first() else { continue };
        shown += 1;
        let folder = folder_of(&format!("{name}-shown"), &fences);
        let printed: String = if fences.iter().any(|fence| fence.language == "console") {
            fences.iter().filter(|fence| fence.language == "console").flat_map(|fence| replay(&folder, fence)).collect()
        } else {
            let files: Vec<&str> = fences.iter().map(|fence| fence.name).filter(|name| !name.is_empty()).collect();
            let example = example_of(first.language);
            if files.is_empty() {
                fs::write(folder.join(&example), first.lines.join("\n") + "\n").expect("a file of the test can be written");
            }
            let what = if files.contains(&"sieben.toml") {
                ".".to_owned()
            } else if files.is_empty() {
                example
            } else {
                files.join(" ")
            };
            run(&folder, &format!("{} {what}", verb_of(first.language, code)))
        };
        if !printed.contains(code) {
            failures.push(format!("{name}: its example does not produce {code}, but\n{printed}\n"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(shown > 0, "no page of a problem shows an example");
}

#[test]
fn the_mended_example_of_a_problem_compiles_without_it() {
    let mut failures = Vec::new();
    for (name, text) in pages() {
        let Some(code) = name.strip_prefix("docs/problems/").and_then(|name| name.strip_suffix(".md")) else { continue };
        let lines: Vec<&str> = text.split('\n').collect();
        let sources: Vec<Fence<'_>> =
            fences(&lines).into_iter().filter(|fence| is_source(fence.language) && fence.name.is_empty()).collect();
        let mended = match sources.as_slice() {
            [] => continue,
            [_, mended] => mended,
            _ => {
                failures.push(format!("{name}: shows the mended source behind the wrong one, and no others"));
                continue;
            }
        };
        let folder = folder_of(&format!("{name}-mended"), &[]);
        let example = example_of(mended.language);
        fs::write(folder.join(&example), mended.lines.join("\n") + "\n").expect("a file of the test can be written");
        let printed = run(&folder, &format!("{} {example}", verb_of(mended.language, code)));
        if printed.contains(code) || printed.contains("[exit code") {
            failures.push(format!("{name}:{}: the mended source still has a problem\n{printed}\n", mended.first));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn programs_in_documents_compile() {
    let mut failures = Vec::new();
    for (name, text) in pages().iter().filter(|(name, _)| !name.starts_with("docs/problems/")) {
        let lines: Vec<&str> = text.split('\n').collect();
        for fence in fences(&lines).iter().filter(|fence| fence.language == "stl" && fence.name.is_empty()) {
            let folder = folder_of(&format!("{name}-{}", fence.first), &[]);
            fs::write(folder.join("example.awl"), fence.lines.join("\n") + "\n").expect("a file of the test can be written");
            let printed = run(&folder, "check example.awl");
            if printed.contains("[exit code") {
                failures.push(format!("{name}:{}: does not compile\n{printed}\n", fence.first));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
