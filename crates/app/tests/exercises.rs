//! The folder of exercises: many programs with their tests, checked by one command and tested by another.

mod command;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use command::{Folder, Run};

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// The names of the files in the folder of exercises.
fn files() -> Vec<String> {
    let entries = fs::read_dir(examples().join("exercises")).expect("the folder of exercises");
    entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect()
}

fn programs() -> BTreeSet<String> {
    let is_program = |name: &&String| name.starts_with("ue") && !name.contains("test");
    files().iter().filter(is_program).map(|name| format!("exercises/{name}")).collect()
}

#[test]
fn exercises_are_checked_by_one_command() {
    let programs = programs();
    let count = programs.len();
    assert!(count >= 30, "{count} exercises");
    let text = Run::of(&examples(), &["check", "exercises"]).code(0).stdout(&format!("{count} programs: `exercises/ue01.awl`, "));
    assert_eq!(text.stderr, "");
    text.stdout("`exercises/blocks.awl` and `exercises/blocks.scl` belong to all of them.\n")
        .stdout(&format!("{count} programs in {} sources, no errors, no warnings.\n", count + 2));
    let json = Run::of(&examples(), &["check", "exercises", "--json"]).code(0).json();
    let named: BTreeSet<String> =
        json["programs"].as_array().expect("a list").iter().map(|program| program["name"].as_str().expect("a name").to_owned()).collect();
    assert_eq!((named, &json["diagnostics"]), (programs, &serde_json::json!([])));
}

#[test]
fn exercises_are_tested_by_one_command_on_each_engine() {
    let count = programs().len();
    let tests =
        |name: &String| fs::read_to_string(examples().join("exercises").join(name)).expect("a test file").matches("END_TEST\n").count();
    let all: usize = files().iter().filter(|name| name.contains("test")).map(tests).sum();
    for engine in ["interpreter", "jit"] {
        let seen = Run::of(&examples(), &["test", "exercises", "--engine", engine]).code(0);
        seen.stdout(&format!("\n{all} passed, 0 failed\n{count} programs: {count} passed\n")).stdout("ok    exercises/blocks.test.st: ");
    }
}

/// An exercise that is wrong fails alone, and the summary names it.
#[test]
fn the_summary_names_what_is_wrong() {
    let count = programs().len();
    let folder = Folder::new();
    for name in files() {
        folder.write(&format!("all/{name}"), &fs::read(examples().join("exercises").join(&name)).expect("a file"));
    }
    folder.write("all/ue01.awl", b"U E 0.0\n= A 4.1\n");
    folder.write("all/ue02.awl", b"O I 0.0\nO I 0.1\n= Q 4.1\nL nothing\n");
    fs::remove_file(folder.path().join("all/ue03.test.st")).expect("it is there");
    let check = folder.run(&["check", "all"]).code(3).stderr(&format!("1 of {count} programs has errors: `all/ue02.awl`.\n"));
    assert_eq!(check.stderr.matches("[P").count(), 1, "{}", check.stderr);
    let passed = count - 3;
    folder
        .run(&["test", "all"])
        .code(3)
        .stdout("FAIL  all/ue01.test.st: one button is not enough\n")
        .stdout(&format!("{count} programs: {passed} passed, 2 failed (all/ue01.awl, all/ue02.awl), 1 without a test (all/ue03.awl)\n"));
}

/// What a student does with one of them.
#[test]
fn each_exercise_is_a_program_by_itself() {
    for program in programs() {
        Run::of(&examples(), &["test", &program]).code(0).stdout("passed, 0 failed\n");
        let shared = ["exercises/symbols.csv", "exercises/blocks.awl", "exercises/blocks.scl"];
        let arguments: Vec<&str> = ["exec", program.as_str()].into_iter().chain(shared).chain(["--show", "MW0"]).collect();
        Run::of(&examples(), &arguments).code(0).stdout("MW0");
    }
}
