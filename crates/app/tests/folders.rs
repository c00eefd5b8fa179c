//! Folders as people have them: one program or several, tests beside programs, whatever their files are called.

mod command;

use command::Folder;
use serde_json::json;

const LAMP: &str = "A I 0.0\n= Q 0.0\n";
const MOTOR: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1\nA I 0.1\n= Q 0.1\nEND_ORGANIZATION_BLOCK\n";
const BLOCKS: &str = "FUNCTION FC 1 : VOID\nBEGIN\nSET\n= M 0.0\nEND_FUNCTION\n";
const LAMP_TEST: &str = "TEST 'the lamp'\n%I0.0 := TRUE;\nSCAN(1);\nASSERT_TRUE(%Q0.0);\nEND_TEST\n";
const MOTOR_TEST: &str = "TEST 'the motor'\n%I0.1 := TRUE;\nSCAN(1);\nASSERT_TRUE(%Q0.1);\nASSERT_TRUE(%M0.0);\nEND_TEST\n";

fn two() -> Folder {
    Folder::with(&[
        ("lamp.awl", LAMP),
        ("lamp.test.st", LAMP_TEST),
        ("motor.awl", MOTOR),
        ("motor_test.st", MOTOR_TEST),
        ("blocks.awl", BLOCKS),
    ])
}

/// Names and contents of files.
type Files<'a> = &'a [(&'a str, &'a str)];

/// The names of the programs that `check` sees in a folder of these files; one program has no list.
fn programs(files: Files<'_>) -> Vec<String> {
    let json = Folder::with(files).run(&["check", ".", "--json"]).json();
    let names = json["programs"].as_array().cloned().unwrap_or_default();
    names.iter().map(|program| program["name"].as_str().expect("a name").to_owned()).collect()
}

#[test]
fn two_files_that_make_ob_1_are_two_programs_and_everything_else_is_one() {
    let block = "FUNCTION_BLOCK FB 1\nBEGIN\nEND_FUNCTION_BLOCK\n";
    let main = "PROGRAM Main\nVAR x : INT; END_VAR\nx := x + 1;\nEND_PROGRAM\n";
    let other = "PROGRAM Other\nVAR x : INT; END_VAR\nx := x + 1;\nEND_PROGRAM\n";
    let loose = "VAR x : INT; END_VAR\nx := x + 1;\n";
    let scl = "ORGANIZATION_BLOCK OB1\nVAR_TEMP\n  i : ARRAY[0..19] OF BYTE;\nEND_VAR\nBEGIN\n  ;\nEND_ORGANIZATION_BLOCK\n";
    let tia = "ORGANIZATION_BLOCK \"Main\"\nBEGIN\nEND_ORGANIZATION_BLOCK\n";
    let named = "ORGANIZATION_BLOCK \"Cycle\"\nBEGIN\nEND_ORGANIZATION_BLOCK\n";
    let startup = "ORGANIZATION_BLOCK OB 100\nBEGIN\nEND_ORGANIZATION_BLOCK\n";
    let table = "symbol,address,type,comment\nCycle,OB 1,OB 1,\n";
    let cases: &[(Files<'_>, &[&str])] = &[
        (&[("a.awl", LAMP)], &[]),
        (&[("a.awl", LAMP), ("b.awl", block)], &[]),
        (&[("a.awl", LAMP), ("b.awl", startup)], &[]),
        (&[("a.awl", LAMP), ("b.awl", LAMP)], &["a.awl", "b.awl"]),
        (&[("a.awl", LAMP), ("b.scl", scl)], &["a.awl", "b.scl"]),
        (&[("a.scl", scl), ("b.scl", tia)], &["a.scl", "b.scl"]),
        (&[("a.st", loose), ("b.st", loose)], &["a.st", "b.st"]),
        (&[("a.awl", LAMP), ("b.awl", named), ("symbols.csv", table)], &["a.awl", "b.awl"]),
        // PROGRAMs share a project, unless they have one name.
        (&[("a.st", main), ("b.st", other)], &[]),
        (&[("a.st", main), ("b.st", other), ("c.awl", LAMP)], &[]),
        (&[("a.st", main), ("b.st", main)], &["a.st", "b.st"]),
        (&[("a.awl", LAMP), ("b.awl", LAMP), ("c.st", main)], &["a.awl", "b.awl", "c.st"]),
        // Folders below.
        (&[("ue1/main.awl", LAMP), ("ue2/main.awl", LAMP)], &["ue1/main.awl", "ue2/main.awl"]),
        (&[("src/a.awl", LAMP), ("lib/b.awl", block)], &[]),
        (&[("a.awl", LAMP), ("pump/sieben.toml", "[project]\nname = \"p\"\n"), ("pump/main.awl", LAMP)], &["a.awl", "pump"]),
        (&[("one/sieben.toml", ""), ("one/main.awl", LAMP), ("two/sieben.toml", ""), ("two/main.awl", LAMP)], &["one", "two"]),
        (&[("one/sieben.toml", ""), ("one/main.awl", LAMP)], &[]),
        // A project says itself what belongs to it.
        (&[("sieben.toml", "[project]\nsources = [\"a.awl\"]\n"), ("a.awl", LAMP), ("b.awl", LAMP)], &[]),
    ];
    for (files, expected) in cases {
        assert_eq!(programs(files), *expected, "{files:?}");
    }
}

#[test]
fn a_shared_file_belongs_to_the_programs_of_its_folder() {
    let folder = Folder::with(&[
        ("lib/all.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n"),
        ("symbols.csv", "symbol,address,type,comment\nLamp,Q 0.0,BOOL,\n"),
        ("ue1/main.awl", "UC FC 1\nUC FC 2\nA I 0.0\n= \"Lamp\"\n"),
        ("ue1/own.awl", "FUNCTION FC 2 : VOID\nBEGIN\nEND_FUNCTION\n"),
        ("ue2/main.awl", "UC FC 1\nUC FC 2\n= \"Lamp\"\n"),
        ("ue2/own.awl", "FUNCTION FC 2 : VOID\nBEGIN\nCLR\nEND_FUNCTION\n"),
        ("ue2/any.test.st", "TEST 'the only program of its folder'\nSCAN(1);\nASSERT_FALSE(\"Lamp\");\nEND_TEST\n"),
    ]);
    folder
        .run(&["check"])
        .code(0)
        .stdout("2 programs: `ue1/main.awl` and `ue2/main.awl`; `symbols.csv` and `lib/all.awl` belong to all of them.\n")
        .stdout("2 programs in 5 sources, no errors, no warnings.\n");
    let files = &folder.run(&["check", "--json"]).json()["programs"][0]["files"];
    assert_eq!(*files, json!(["lib/all.awl", "ue1/main.awl", "ue1/own.awl"]));
    folder
        .run(&["test"])
        .code(0)
        .stdout("ok    ue2/any.test.st: the only")
        .stdout("2 programs: 1 passed, 1 without a test (ue1/main.awl)\n");
}

#[test]
fn what_is_wrong_with_a_shared_file_is_said_once() {
    let folder = Folder::with(&[
        ("a.awl", "CALL FC 1\n"),
        ("b.awl", "CALL FC 1\nL nothing\n"),
        ("db.awl", "DATA_BLOCK DB 1\nSTRUCT\n x : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"),
        ("blocks.awl", "FUNCTION FC 1 : VOID\nBEGIN\nL 1\nXYZ\nEND_FUNCTION\n"),
        ("a.test.st", "TEST 'a'\nSCAN(1);\nEND_TEST\n"),
        ("b.test.st", "TEST 'b'\nSCAN(1);\nEND_TEST\n"),
    ]);
    let check = folder.run(&["check"]).code(3).stderr("2 errors. ").stderr("2 of 2 programs have errors: `a.awl`, `b.awl`.\n");
    assert_eq!(check.stderr.matches("`XYZ`").count(), 1, "{}", check.stderr);
    let json = folder.run(&["check", "--output-format", "json"]).code(3).json();
    let diagnostics = json["diagnostics"].as_array().expect("a list");
    let seen: Vec<_> = diagnostics.iter().map(|one| (one["file"].clone(), one["programs"].clone())).collect();
    assert_eq!(seen, [(json!("b.awl"), json!(["b.awl"])), (json!("blocks.awl"), json!(["a.awl", "b.awl"]))]);
    assert_eq!(json["programs"][1], json!({ "name": "b.awl", "files": ["b.awl", "blocks.awl", "db.awl"], "errors": 2, "warnings": 0 }));
    let test = folder.run(&["test"]).code(3).stdout("FAIL  a.test.st: does not compile\n").stdout("and 1 message from above\n");
    assert_eq!(test.stdout.matches("`XYZ`").count(), 1, "{}", test.stdout);
    // In one of the programs only: then the message says in which.
    folder.write("blocks.awl", b"FUNCTION FC 1 : VOID\nBEGIN\nCALL FC 2\nEND_FUNCTION\n");
    folder.write("b.awl", b"CALL FC 1\nBE\nFUNCTION FC 2 : VOID\nBEGIN\nEND_FUNCTION\n");
    folder.run(&["check"]).code(3).stderr("(in `a.awl`)").stderr("1 of 2 programs has errors: `a.awl`.\n");
    folder.run(&["check", "--output-format", "concise"]).code(3).stdout("blocks.awl:3:6: error[P").stdout(" (in `a.awl`)\n");
}

#[test]
fn a_fix_in_a_shared_file_is_applied_once() {
    let folder = Folder::with(&[
        ("a.awl", "CALL FC 1\n"),
        ("b.awl", "CALL FC 1\n"),
        ("c.awl", "FUNCTION FC 1 : VOID\nBEGIN\nA I O.1\n= M 0.1\nEND_FUNCTION\n"),
    ]);
    let run = folder.run(&["check", "--fix"]).code(0).stdout("c.awl:3:5: wrote").stdout("no errors, no warnings");
    assert_eq!(run.stdout.matches("wrote").count(), 1, "{}", run.stdout);
}

#[test]
fn verbs_that_need_one_program_say_which_there_are() {
    let folder = two();
    let verbs: &[&[&str]] = &[
        &["run", "."],
        &["exec", "."],
        &["step", "."],
        &["trace", "."],
        &["record", ".", "-o", "x.scenario"],
        &["bench", "."],
        &["refs", "."],
        &["structure", "."],
        &["assignments", "."],
        &["check", ".", "--against", "lamp.awl"],
        &["check", "lamp.awl", "--against", "."],
    ];
    for verb in verbs {
        folder
            .run(verb)
            .code(2)
            .stderr("[P6072] Error: `.` holds 2 programs: `lamp.awl` and `motor.awl`\n")
            .stderr("  Help: Name one of them instead of the folder: `lamp.awl blocks.awl`; ");
    }
    folder.run(&["exec", "motor.awl", "blocks.awl", "--set", "I0.1=1", "--show", "Q0.1"]).code(0).stdout("Q0.1 = 1");
}

#[test]
fn what_looks_at_each_file_alone_takes_the_whole_folder() {
    let folder = two();
    folder.run(&["check", "--syntax-only"]).code(0).stdout("3 sources, no errors, no warnings.\n");
    folder.run(&["fmt", "--check", "."]).code(1).stdout("lamp.awl would be formatted\n").stdout("motor.awl would be formatted\n");
    assert_eq!(folder.read("lamp.awl"), LAMP.as_bytes(), "nothing is written");
    folder.run(&["fmt", "--write", "."]).code(0).stdout("lamp.awl formatted\n");
    folder.run(&["fmt", "--check", "."]).code(0);
    folder.run(&["convert", "--mnemonics", "de", "--write", "."]).code(0).stdout("motor.awl converted\n");
    folder.run(&["test"]).code(0).stdout("2 passed, 0 failed");
}

#[test]
fn tests_belong_to_the_program_that_they_are_called_like() {
    let folder = two();
    folder
        .run(&["test", "."])
        .code(0)
        .stdout("2 programs: `lamp.awl` and `motor.awl`; `blocks.awl` belongs to all of them.\n")
        .stdout("ok    lamp.test.st: the lamp  (1 scan)")
        .stdout("ok    motor_test.st: the motor  (1 scan)")
        .stdout("2 passed, 0 failed\n2 programs: 2 passed\n");
    for one in ["motor.awl", "./motor.awl", "motor_test.st"] {
        let run = folder.run(&["test", one]).code(0).stdout("motor_test.st: the motor").stdout("1 passed, 0 failed");
        assert!(!run.stdout.contains("lamp"), "{}", run.stdout);
    }
    let json = folder.run(&["test", "--json"]).code(0).json();
    assert_eq!(json["programs"], json!(["lamp.awl", "motor.awl"]));
    let of: Vec<_> = json["tests"].as_array().expect("a list").iter().map(|test| (&test["program"], &test["test_file"])).collect();
    assert_eq!(of, [(&json!("lamp.awl"), &json!("lamp.test.st")), (&json!("motor.awl"), &json!("motor_test.st"))]);
    folder.run(&["test", "--tap"]).code(0).stdout("TAP version 14\n1..2\nok 1 - lamp.test.st: the lamp\n");
    folder.run(&["test", "--list"]).code(0).stdout("lamp.test.st: the lamp\nmotor_test.st: the motor\n");
    // Two programs of one name both have to pass.
    folder.write("lamp.st", b"VAR i AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; END_VAR\nq := NOT i;\n");
    folder.run(&["test"]).code(1).stdout("ok    lamp.test.st: the lamp (lamp.awl)").stdout("FAIL  lamp.test.st: the lamp (lamp.st)");
    folder.run(&["test", "lamp.awl"]).code(0).stdout("1 passed, 0 failed");
    folder.run(&["test", "lamp.st"]).code(1).stdout("0 passed, 1 failed");
    // Tests of what belongs to all of them.
    folder.write("blocks.test.st", b"TEST 'the block'\nFC1();\nASSERT_TRUE(%M0.0);\nEND_TEST\n");
    folder.run(&["test", "--filter", "block"]).code(0).stdout("ok    blocks.test.st: the block");
    folder.run(&["test", "blocks.awl"]).code(0).stdout("ok    blocks.test.st: the block");
}

#[test]
fn a_test_that_belongs_to_no_program_is_no_silence() {
    let folder = two();
    folder.write("lamps.test.st", LAMP_TEST.as_bytes());
    let help =
        "all it like the program that it tests: `lamp.test.st` for `lamp.awl`; or name both: `sieben test lamp.awl --tests lamps.test.st`";
    folder.run(&["check"]).code(0).stderr("[P6073] Warning: `lamps.test.st` belongs to none of the 2 programs here").stderr(help);
    folder
        .run(&["test"])
        .code(2)
        .stdout("FAIL  lamps.test.st: `lamps.test.st` belongs to none")
        .stdout(help)
        .stdout("2 passed, 0 failed, 1 could not run");
    folder.run(&["test", "lamps.test.st"]).code(2).stderr("P6073");
    folder.run(&["test", "lamp.awl", "--tests", "lamps.test.st"]).code(0).stdout("1 passed, 0 failed");
}

#[test]
fn a_test_file_needs_no_certain_name() {
    let program = ("lamp.awl", LAMP);
    for name in ["lamp.test.st", "test_lamp.st", "lamp_test.st", "checks.st", "checks/all.st"] {
        let folder = Folder::with(&[program, (name, LAMP_TEST)]);
        folder.run(&["test"]).code(0).stdout("the lamp").stdout("1 passed, 0 failed");
        folder.run(&["check"]).code(0).stdout("1 block in 1 source, no errors");
        let project = Folder::with(&[("sieben.toml", "[project]\nname = \"p\"\n"), program, (name, LAMP_TEST)]);
        project.run(&["test"]).code(0).stdout("the lamp").stdout("1 passed, 0 failed");
    }
    for name in ["suite.txt", "suite", "suite.scl", "suite.st"] {
        let folder = Folder::with(&[
            program,
            (name, LAMP_TEST),
            ("second.txt", "SETUP\n%I0.0 := TRUE;\nEND_SETUP\nTEST 'again'\nSCAN(1);\nASSERT_TRUE(%Q0.0);\nEND_TEST\n"),
        ]);
        folder
            .run(&["test", "lamp.awl", "--tests", name, "second.txt"])
            .code(0)
            .stdout(&format!("ok    {name}: the lamp"))
            .stdout("2 passed, 0 failed");
        folder.run(&["test", "lamp.awl", name]).code(0).stdout("1 passed, 0 failed");
    }
    // A program may be called like a test.
    let folder = Folder::with(&[("test_lamp.st", "PROGRAM Main\nVAR test : BOOL; END_VAR\ntest := TRUE;\nEND_PROGRAM\n")]);
    folder.run(&["check"]).code(0).stdout("in 1 source, no errors");
}

#[test]
fn a_name_of_several_lines_begins_no_line() {
    let folder = two();
    std::fs::write(folder.path().join("x\n::error::y.awl"), "A I 0.0\n= Q 4.0\n").expect("it can be written");
    for arguments in [&["check", ".", "--output-format", "github"][..], &["check", "."], &["test", "."], &["run", "."]] {
        let run = folder.run(arguments);
        assert!(run.stdout.contains("x␊::error::y.awl") || run.stderr.contains("x␊::error::y.awl"), "{}{}", run.stdout, run.stderr);
        assert!(!run.stdout.contains("\n::error::y") && !run.stderr.contains("\n::error::y"), "{}{}", run.stdout, run.stderr);
    }
}

#[test]
fn a_run_without_a_test_fails() {
    let folder = two();
    for test in ["lamp.test.st", "motor_test.st"] {
        std::fs::remove_file(folder.path().join(test)).expect("it is there");
    }
    folder.run(&["test"]).code(1).stdout("No tests found. 2 programs have neither an assertion").stdout("there is no test file");
    assert_eq!(folder.run(&["test", "--json"]).code(1).json()["tests"], json!([]));
    folder.write("lamp.test.st", b"SETUP\n%I0.0 := TRUE;\nEND_SETUP\n");
    folder.run(&["test"]).code(3).stdout("[P2302] Error: this test file has no TEST");
}

#[test]
fn a_folder_with_too_much_for_all_its_programs_is_refused() {
    let folder = Folder::new();
    for number in 0..6 {
        folder.write(&format!("ue{number}.awl"), LAMP.as_bytes());
    }
    let large = std::fs::File::create(folder.path().join("large.awl")).expect("a file can be written");
    large.set_len(50 << 20).expect("a file has a length");
    for verb in ["check", "test"] {
        folder
            .run(&[verb, "."])
            .code(2)
            .stderr("[P6075] Error: `.` holds 6 programs and 1 file that belongs to several of them: 300 MiB to read\n");
    }
    folder.run(&["check", "ue0.awl"]).code(0);
}

/// A link that leads out of the folder is no part of any program, and is not passed over in silence.
#[cfg(unix)]
#[test]
fn a_link_out_of_a_folder_with_several_programs_is_reported() {
    let outside = Folder::with(&[("fc.awl", BLOCKS)]);
    let folder = two();
    std::os::unix::fs::symlink(outside.path().join("fc.awl"), folder.path().join("other.awl")).expect("a link can be made");
    folder.run(&["check"]).code(3).stderr("[P6010] Error: `other.awl` is a link to a file outside the project folder");
}
