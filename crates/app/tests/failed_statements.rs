//! Statements that fail while the program goes on: nothing of them is silent, whichever verb runs the program and whichever engine.

mod command;

use command::Folder;

/// Each row: the dialect, the declarations, a statement, and what the report says of it; nothing where it may pass.
const ROWS: &[(&str, &str, &str, &str)] = &[
    ("iec", "a : ARRAY[1..4] OF INT; k : INT := 7;", "a[k] := 5", "index 7 is outside its array"),
    ("iec", "a : ARRAY[1..4] OF INT; k : INT := 7; r : INT;", "r := a[k]", "index 7 is outside its array"),
    ("iec", "z : INT; r : INT;", "r := 10 / z", "division by 0"),
    ("iec", "z : INT; r : INT;", "r := 10 MOD z", "division by 0"),
    ("iec", "z : INT; r : INT;", "r := DIV(10, z)", "division by 0"),
    ("iec", "z : UDINT; r : UDINT;", "r := 10 / z", "division by 0"),
    ("iec", "z : LINT; r : LINT;", "r := 10 / z", "division by 0"),
    ("iec", "z : INT := -1; r : INT := -32768;", "r := r / z", "a quotient that does not fit its type"),
    ("iec", "r : INT := 32767;", "r := r + 1", "overflow: the result does not fit its type"),
    ("iec", "r : UINT; s : UINT := 1;", "r := r - s", "overflow: the result does not fit its type"),
    ("iec", "r : DINT := 100000;", "r := r * r", "overflow: the result does not fit its type"),
    ("iec", "r : INT := -32768;", "r := -r", "overflow: the result does not fit its type"),
    ("iec", "q : INT := 300; r : SINT;", "r := INT_TO_SINT(q)", "none that fits its type"),
    ("iec", "q : INT := -1; r : UINT;", "r := INT_TO_UINT(q)", "none that fits its type"),
    ("iec", "q : REAL := 1.0E9; r : INT;", "r := REAL_TO_INT(q)", "none that fits its type"),
    ("iec", "q : REAL; r : REAL;", "r := 1.0 / q", "the result is infinite or no number"),
    ("iec", "q : REAL := -1.0; r : REAL;", "r := SQRT(q)", "the result is infinite or no number"),
    ("iec", "i : INT; s : INT; r : INT;", "FOR i := 1 TO 3 BY s DO r := 1; END_FOR", "a FOR with a step of 0 is left out"),
    ("iec", "r : INT(0..10); k : INT := 12;", "r := k", "none that fits its type"),
    ("iec", "q : INT := 32766; r : INT;", "r := q + 1", ""),
    ("iec", "q : REAL := 3.0; r : REAL;", "r := q / 3.0", ""),
    // Where the block looks at ENO, it handles what is lost itself.
    ("iec", "z : INT; r : INT; ok : BOOL;", "r := 10 / z; ok := ENO", ""),
    ("codesys", "z : INT; r : INT;", "r := 10 / z", "division by 0"),
    ("codesys", "z : INT; r : INT;", "IF z <> 0 AND_THEN 10 / z > 1 THEN r := 1; END_IF", ""),
    ("codesys", "r : INT := 32767;", "r := r + 1", ""),
    ("codesys", "q : INT := 300; r : SINT;", "r := INT_TO_SINT(q)", ""),
    ("scl", "z : INT; r : INT;", "r := 10 / z", "division by 0"),
    ("tia", "z : INT; r : INT;", "r := 10 MOD z", "division by 0"),
    ("tia", "r : INT := 32767;", "r := r + 1", ""),
];

/// A program with a declaration and a statement.
fn program(dialect: &str, declared: &str, statement: &str) -> String {
    match dialect {
        "scl" | "tia" => format!(
            "FUNCTION_BLOCK FB1\nVAR {} END_VAR\nBEGIN\n{statement};\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB1 FB1\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB1\nBEGIN\nFB1.DB1();\nEND_ORGANIZATION_BLOCK\n",
            declared.replace("; ", ";\n")
        ),
        _ => format!("PROGRAM Main\nVAR {declared} END_VAR\n{statement};\nEND_PROGRAM\n"),
    }
}

#[test]
fn every_kind_of_failure_is_told_on_every_engine() {
    let mut wrong = Vec::new();
    for &(dialect, declared, statement, expected) in ROWS {
        let folder = Folder::with(&[("main.st", &program(dialect, declared, statement))]);
        let of = |engine: &str| {
            let run = folder.run(&["exec", "main.st", "--dialect", dialect, "--engine", engine, "--scans", "3", "--json", "--every"]);
            run.lines().last().map_or_else(|| run.stderr.clone().into(), |last| last["failed_statements"].clone())
        };
        let [interpreted, compiled] = ["interpreter", "jit"].map(of);
        let said = interpreted["first"]["text"].as_str().unwrap_or_default();
        if interpreted != compiled || !said.ends_with(expected) || interpreted.is_null() != expected.is_empty() {
            wrong.push(format!("{dialect}: {declared} {statement}: {interpreted} / {compiled}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

const FAILS: &str = "PROGRAM Main\nVAR a : ARRAY[1..4] OF INT; k : INT := 7; END_VAR\n  a[k] := 5;\nEND_PROGRAM\n";
const LINE: &str = "in scan 0: main.st:3:3 in `Main`, `a[k] := 5`: index 7 is outside its array";

#[test]
fn every_verb_says_it_in_one_line_and_strict_makes_it_a_failure() {
    let folder = Folder::with(&[("main.st", FAILS), ("good.st", "PROGRAM Main\nVAR n : INT; END_VAR\n  n := 1;\nEND_PROGRAM\n")]);
    let times = format!("Statements failed 3 times, first {LINE}");
    folder.run(&["exec", "main.st", "--scans", "3"]).code(0).stderr(&times);
    folder.run(&["exec", "main.st", "--scans", "3", "--strict"]).code(1).stderr(&times);
    folder.run(&["exec", "main.st"]).code(0).stderr(&format!("A statement failed once, {LINE}"));
    folder.run(&["exec", "good.st", "--strict"]).code(0);
    let run = ["run", "main.st", "--speed", "max", "--for", "30ms"];
    folder.run(&run).code(0).stderr(&times);
    folder.run(&[&run[..], &["--strict"]].concat()).code(1).stderr(&times);
    let json = folder.run(&[&run[..], &["--json"]].concat()).code(0).json();
    assert_eq!((json["failed_statements"]["count"].as_u64(), json["failed_statements"]["first"]["line"].as_u64()), (Some(3), Some(3)));
    folder.run(&["trace", "main.st", "--channels", "QB0", "--scans", "3"]).stderr(&times);
    folder.run(&["record", "main.st", "-o", "run.scenario", "--scans", "3", "--channels", "QB0"]).stderr(&times);
}

#[test]
fn a_test_has_a_note_and_strict_lets_it_fail() {
    let folder = Folder::with(&[
        ("main.st", FAILS),
        ("main.test.st", "TEST 'two scans'\n  SCAN(2);\nEND_TEST\nTEST 'none'\n  ASSERT_TRUE(TRUE);\nEND_TEST\n"),
        ("steps.scenario", "scan 3\nexpect MB 0=0\n"),
    ]);
    let note = format!("        note: Statements failed 2 times, first {LINE}\n");
    folder
        .run(&["test"])
        .code(0)
        .stdout(&note)
        .stdout("note: Statements failed 3 times")
        .stderr("Statements failed 5 times")
        .stderr("(in 2 tests of 3)");
    let json = folder.run(&["test", "--json"]).code(0).json();
    assert_eq!(json["tests"][0]["failed_statements"]["count"].as_u64(), Some(2), "{json}");
    folder
        .run(&["test", "--strict"])
        .code(1)
        .stdout("FAIL  main.test.st: two scans\n        Statements failed 2 times")
        .stdout("1 passed, 2 failed");
}

#[test]
fn an_error_that_ob_121_answers_is_told_too_and_one_that_stops_the_cpu_only_once() {
    let failing = "      L MW 10\n      T DBW 100\n";
    let with = |more: &str| {
        format!("{more}ORGANIZATION_BLOCK OB 1\nBEGIN\n{failing}END_ORGANIZATION_BLOCK\nDATA_BLOCK DB 1\nSTRUCT a : INT; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n").replace("L MW 10", "OPN DB 1\n      L MW 10")
    };
    let folder =
        Folder::with(&[("answered.awl", &with("ORGANIZATION_BLOCK OB 121\nBEGIN\nEND_ORGANIZATION_BLOCK\n")), ("stops.awl", &with(""))]);
    folder
        .run(&["exec", "answered.awl", "--scans", "2", "--diagnostics"])
        .code(0)
        .stderr("Statements failed 2 times, first in scan 0: answered.awl:")
        .stdout("Diagnostic buffer, newest first:\n")
        .stdout("16#2523  area length error when writing: DB word at byte 100");
    let stopped = folder.run(&["exec", "stops.awl", "--strict"]).code(4);
    assert!(!stopped.stderr.contains("failed once"), "{}", stopped.stderr);
}

#[test]
fn the_diagnostic_buffer_is_seen_without_a_stop() {
    let folder = Folder::with(&[("main.st", FAILS), ("main.test.st", "TEST 'one'\n  SCAN();\nEND_TEST\n")]);
    let entry = "16#2523  area length error when writing: index 7 is outside its array (in `Main`)  main.st:3";
    folder.run(&["exec", "main.st", "--diagnostics"]).stdout(entry).stdout("16#4302  mode change from STARTUP to RUN");
    folder.run(&["run", "main.st", "--speed", "max", "--for", "10ms", "--diagnostics"]).stdout(entry);
    folder.run(&["test", "--diagnostics"]).stdout("        diagnostic buffer, newest first:\n").stdout(entry);
    let steps = |extra: &[&str], commands: &str| {
        folder.write("steps.txt", commands.as_bytes());
        folder.run(&[&["step", "main.st", "--commands", "steps.txt"], extra].concat())
    };
    let shows = "scan\ndiagnostics\n";
    steps(&[], shows).stdout(entry).stdout("statements that failed while the program went on: 1; scan 0: main.st:3:3");
    steps(&["--lang", "de"], shows).stdout("Diagnosepuffer, der neueste Eintrag zuerst:");
    let text = steps(&["--json"], shows).stdout;
    assert!(text.contains("\"diagnostic_buffer\"") && text.contains("\"count\":1"), "{text}");
    // To go back takes it back.
    steps(&[], "scan\nback scan\ndiagnostics\n").stdout("no statement has failed");
}

#[test]
fn a_step_that_writes_nothing_says_so() {
    let rows = [
        (
            "a : ARRAY[1..4] OF INT; k : INT := 7;",
            "a[k] := 5",
            "index 7 of `a[k]` is outside its array (1 to 4), so nothing is written",
            "Index 7 von `a[k]` liegt außerhalb des Feldes (1 bis 4), also wird nichts geschrieben",
        ),
        (
            "a : ARRAY[1..4] OF INT; k : INT := 7; r : INT;",
            "r := a[k] + 1",
            "index 7 of `a[k]` is outside its array (1 to 4), so 0 is read: ",
            "also wird 0 gelesen: ",
        ),
        (
            "z : INT; r : INT;",
            "r := 10 / z",
            "`10 / z` divides by 0: z is 0, so r becomes 0",
            "`10 / z` teilt durch 0: z ist 0, also wird r 0",
        ),
        (
            "r : INT := 32767; q : INT;",
            "q := r + 1",
            "the result of `r + 1` does not fit its type: r is 32767, so q becomes -32768",
            "das Ergebnis von `r + 1` passt nicht in seinen Typ",
        ),
        ("q : REAL; r : REAL;", "r := 1.0 / q", "the result of `1.0 / q` is infinite or no number", "ist unendlich oder keine Zahl"),
        ("z : INT; r : INT;", "IF 10 / z > 1 THEN r := 1; END_IF", "`10 / z` divides by 0: z is 0: `10 / z > 1` is FALSE", "teilt durch 0"),
    ];
    for (declared, statement, english, german) in rows {
        let folder = Folder::with(&[("main.st", &program("iec", declared, statement)), ("steps.txt", "step 8\n")]);
        for (language, expected) in [("en", english), ("de", german)] {
            folder.run(&["step", "main.st", "--commands", "steps.txt", "--lang", language]).stdout(expected);
        }
    }
    let folder = Folder::with(&[
        ("main.st", &program("scl", "a : ARRAY[1..4] OF INT; k : INT := 7; r : INT;", "r := a[k]")),
        ("steps.txt", "step 8\n"),
    ]);
    folder
        .run(&["step", "main.st", "--dialect", "scl", "--commands", "steps.txt"])
        .stdout("index 7 of `a[k]` is outside its array (1 to 4), so the statement is left out");
}

#[test]
fn long_labels_run_and_are_an_error_where_nothing_is_let_pass() {
    let folder = Folder::with(&[
        ("jump.awl", "      SET\n      JC    forward\n      L     1\n      T     MW 0\nforward: L 2\n      T     MW 2\n"),
        ("jump.scenario", "scan\nexpect MW 2=2\n"),
    ]);
    folder.run(&["check", "jump.awl"]).code(0).stderr("[P2006] Warning");
    folder.run(&["exec", "jump.awl", "--show", "MW0,MW2"]).code(0).stdout("MW0 = 16#0000\nMW2 = 16#0002");
    for verb in ["check", "exec", "test", "run"] {
        let run = folder.run(&[verb, "jump.awl", "--strict"]).code(3);
        let text = format!("{}{}", run.stdout, run.stderr);
        assert!(text.contains("[P2006] Error"), "{verb}: {text}");
    }
}

#[test]
fn an_assertion_shows_what_differs() {
    let rows = [
        ("ASSERT_EQ(0.1 + 0.2, 0.3)", "`0.1 + 0.2` is 0.30000000000000004 (LREAL), not 0.3"),
        ("ASSERT_EQ(2 + 2, 5)", "`2 + 2` is 4 (LINT), not 5"),
        ("ASSERT_NEQ(2 + 2, 4)", "`2 + 2` is 4 (LINT), the same as 4"),
        ("ASSERT_GT(1.0 / 3.0, 0.5)", "`1.0 / 3.0` is 0.3333333333333333 (LREAL), which is not > 0.5"),
        ("ASSERT_NEAR(0.1 + 0.2, 0.4, 0.01)", "`0.1 + 0.2` is 0.30000000000000004 (LREAL), which is not near 0.4 (± 0.01)"),
    ];
    for (assertion, expected) in rows {
        let folder = Folder::with(&[
            ("main.st", "PROGRAM Main\nVAR n : INT; END_VAR\n  n := 1;\nEND_PROGRAM\n"),
            ("main.test.st", &format!("TEST 'it'\n  {assertion};\nEND_TEST\n")),
        ]);
        folder.run(&["test"]).code(1).stdout(expected);
    }
}

#[test]
fn an_online_change_lists_blocks_with_new_variables_and_initial_values_that_wait() {
    let program = |more: &str, initial: u32| {
        format!(
            "FUNCTION_BLOCK FB 1\nVAR a : INT;{more} END_VAR\nBEGIN\n      L #a\nEND_FUNCTION_BLOCK\n\
             DATA_BLOCK DB 2\nSTRUCT x : INT := {initial}; y : INT := 1; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n\
             ORGANIZATION_BLOCK OB 1\nBEGIN\n      L DB2.DBW 0\nEND_ORGANIZATION_BLOCK\n"
        )
    };
    let folder = Folder::with(&[("old.awl", &program("", 5)), ("new.awl", &program(" b : INT;", 6))]);
    folder
        .run(&["check", "new.awl", "--against", "old.awl"])
        .code(0)
        .stdout("FB 1 changed")
        .stdout("New initial values come with a cold restart: DB2.x.\n");
    let wider = program("", 7).replace("y : INT", "z : INT; y : INT");
    let folder = Folder::with(&[("old.awl", &program("", 5)), ("new.awl", &wider)]);
    folder
        .run(&["check", "new.awl", "--against", "old.awl"])
        .code(0)
        .stdout("DB 2 changed")
        .stdout("New initial values come with a cold restart: DB2.x.\n");
}
