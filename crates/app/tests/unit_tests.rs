//! Unit tests in `*.test.st` files, as their users write and run them, on both engines.

mod command;

use command::{Folder, Run};

/// A program of STL: a motor that an FB holds, a function, an S5 timer.
const PROGRAM: &str = "\
FUNCTION_BLOCK FB 10
VAR_INPUT
  start : BOOL;
  stop : BOOL;
END_VAR
VAR_OUTPUT
  motor : BOOL;
END_VAR
VAR
  n : INT;
END_VAR
BEGIN
      A #start;
      S #motor;
      A #stop;
      R #motor;
      L #n;
      + 1;
      T #n;
END_FUNCTION_BLOCK
DATA_BLOCK DB 10
FB 10
BEGIN
END_DATA_BLOCK
FUNCTION FC 5 : INT
VAR_INPUT
  a : INT;
END_VAR
BEGIN
      L #a;
      L 2;
      *I;
      T #RET_VAL;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
      CALL FB 10, DB 10 (start := I 0.0, stop := I 0.1);
      A DB10.DBX 2.0;
      = Q 0.0;
      A I 0.2;
      L S5T#2S;
      SD T 1;
      A T 1;
      = Q 0.1;
      CALL FC 5 (a := MW 10, RET_VAL := MW 12);
      A I 0.7;
      JCN go;
      L DBW 400;
go:   NOP 0;
END_ORGANIZATION_BLOCK
";

const TABLE: &str = "symbol,address,type,comment\nDouble,FC 5,FC 5,\nMotor data,DB 10,FB 10,\nStart button,I 0.0,BOOL,\n";

fn folder(tests: &str) -> Folder {
    Folder::with(&[("motor.awl", PROGRAM), ("symbols.csv", TABLE), ("motor.test.st", tests)])
}

/// Runs the tests on both engines, which have to say the same.
fn run(tests: &str) -> Run {
    let folder = folder(tests);
    let one = folder.run(&["test", "--engine", "interpreter"]);
    let other = folder.run(&["test", "--engine", "jit"]);
    assert_eq!((&one.stdout, one.code), (&other.stdout, other.code), "{}{}", one.stderr, other.stderr);
    one
}

#[test]
fn blocks_of_every_language_are_called_and_the_cpu_scans() {
    run(r#"
FUNCTION_BLOCK Late
VAR_INPUT
  go : BOOL;
END_VAR
VAR_OUTPUT
  q : BOOL;
END_VAR
VAR
  t : TON;
END_VAR
  t(IN := go, PT := T#10m);
  q := t.Q;
END_FUNCTION_BLOCK

VAR
  count : INT;
END_VAR

SETUP
  VAR one : INT := 1; END_VAR
  count := 4 + one;
END_SETUP

TEST 'what the file declares is fresh'
  ASSERT_EQ(count, 5);
  count := 7;
END_TEST

TEST "and fresh again"
  ASSERT_EQ(count, 5, "the count");
END_TEST

TEST 'ten minutes of a timer'
  VAR late : Late; END_VAR
  late(go := TRUE);
  ADVANCE_TIME(T#9m59s);
  late(go := TRUE);
  ASSERT_FALSE(late.q);
  ADVANCE_TIME(1000000000);
  late();
  ASSERT_TRUE(late.q, 'after ten minutes');
END_TEST

TEST 'inputs stay, OB 1 runs'
  %I0.0 := TRUE;
  ASSERT_TRUE(%I0.0);
  SCAN(2);
  ASSERT_TRUE(%Q0.0);
  ASSERT_TRUE("Start button");
  ASSERT_EQ(DB10.n, 2);
  ASSERT_EQ("Motor data".n, %DB10.DBW4);
  %E0.0 := FALSE;
  E0.1 := TRUE;
  SCAN();
  ASSERT_FALSE(%A0.0);
END_TEST

TEST 'an S5 timer'
  %I0.2 := TRUE;
  SCAN(1);
  ADVANCE_TIME(T#1980ms);
  SCAN(1);
  ASSERT_FALSE(%Q0.1);
  SCAN(1);
  ASSERT_TRUE(%Q0.1);
END_TEST

TEST 'calls by number, symbol, with an instance or a data block'
  VAR motor : FB10; x : INT; END_VAR
  x := FC5(21);
  ASSERT_EQ(x, 42);
  ASSERT_EQ("Double"(21), 42);
  motor(start := TRUE);
  ASSERT_TRUE(motor.motor);
  FB10.DB10(start := TRUE);
  ASSERT_TRUE(DB10.motor);
  ASSERT_EQ(%MW12, 0);
END_TEST

TEST 'assertions of every kind'
  VAR s : STRING; r : REAL := 0.1; t : TIME := T#5s; END_VAR
  s := 'abc';
  ASSERT_EQ(s, 'abc');
  ASSERT_NEQ(s, 'abd');
  ASSERT_LT(s, 'b');
  ASSERT_GT(3, 2);
  ASSERT_GE(3, 3);
  ASSERT_LE(3, 3);
  ASSERT_LT(-3, 3);
  ASSERT_NEAR(r * 3.0, 0.3);
  ASSERT_NEAR(r, 0.2, 0.11, 'wide');
  ASSERT_NEAR(t, T#5100ms, T#100ms);
END_TEST

TEST 'a peripheral input stays'
  %PIW256 := 1234;
  SCAN(1);
  ASSERT_EQ(%PIW256, 1234);
END_TEST

TEST 'stop and start'
  %MW110 := 4;
  STOP();
  START();
  ASSERT_EQ(%MW110, 0, 'not retentive');
  %MW10 := 5;
  SCAN(1);
  ASSERT_EQ(%MW12, 10);
  %MW10 := -3;
  SCAN(1);
  ASSERT_EQ(%MW12, -6);
  %MD20 := 1.5;
  ASSERT_EQ(%MD20, 1.5);
  %MD24 := T#3s;
  ASSERT_EQ(%MD24, 3000);
END_TEST

TEST 'a stop that is expected'
  %I0.7 := TRUE;
  SCAN(5);
  EXPECT_STOP(16#4562);
END_TEST

TEST 'nothing yet' END_TEST TEST "nor here" END_TEST

TEST 'its own stop may be expected, too'
  STOP();
  EXPECT_STOP(16#4303);
END_TEST
"#)
    .code(0)
    .stdout("ok    motor.test.st: ten minutes of a timer  (0 scans, 10 min 0 s of virtual time)")
    .stdout("13 passed, 0 failed");
}

#[test]
fn a_failing_test_shows_line_values_types_and_message() {
    let seen = run("TEST 'doubles'\n  ASSERT_EQ(FC5(21), 41, 'not yet');\nEND_TEST\n\
         TEST 'texts'\n  VAR s : STRING; END_VAR\n  s := 'hello';\n  ASSERT_EQ(s, 'hallo');\nEND_TEST\n\
         TEST 'near'\n  ASSERT_NEAR(1.5, 1.0, 0.25);\nEND_TEST\n\
         TEST 'no stop'\n  EXPECT_STOP('any');\nEND_TEST\n\
         TEST 'one stop is not two'\n  STOP();\n  EXPECT_STOP('any');\n  EXPECT_STOP('any');\nEND_TEST\n\
         TEST 'another stop'\n  %I0.7 := TRUE;\n  SCAN(5);\n  EXPECT_STOP(16#4303);\nEND_TEST\n\
         TEST 'nobody expects it'\n  %I0.7 := TRUE;\n  SCAN(5);\nEND_TEST\n\
         TEST 'division'\n  VAR a : ARRAY[1..3] OF INT; i : INT := 2; END_VAR\n  a[i] := 5;\n  ASSERT_EQ(a[2], 6);\nEND_TEST\n")
    .code(1);
    for wanted in [
        "FAIL  motor.test.st: doubles\n        motor.test.st:2: `FC5(21)` is 42 (INT), not 41\n        ASSERT_EQ(FC5(21), 41, 'not yet');\n        message: not yet\n",
        "motor.test.st:7: `s` is 'hello' (STRING), not `'hallo'`",
        "motor.test.st:10: `1.5` is 1.5, which is not near 1.0 (± 0.25)",
        "motor.test.st:13: the CPU has not gone to STOP: it is in RUN",
        "motor.test.st:18: the CPU has not gone to STOP again: it is still in the STOP that was expected before",
        "motor.test.st:23: the CPU went to STOP with event 16#4562",
        "FAIL  motor.test.st: nobody expects it\n",
        "L DBW 400",
        "motor.test.st:32: `a[2]` is 5 (INT), not 6",
        "0 passed, 8 failed\n",
    ] {
        assert!(seen.stdout.contains(wanted), "wanted: {wanted}\n{}", seen.stdout);
    }
    // A block of ST has a number that nobody gave it.
    let block = "FUNCTION_BLOCK Mixer\nVAR p : POINTER TO INT; END_VAR\np^ := 1;\nEND_FUNCTION_BLOCK\n";
    run(&format!("{block}TEST 'nowhere'\n  VAR m : Mixer; END_VAR\n  m();\nEND_TEST\n")).code(1).stdout("area code 16#00 (in `Mixer`)");
    let folder = folder("TEST 'doubles'\n  ASSERT_EQ(FC5(21), %MW0, 'not yet');\nEND_TEST\n");
    let json = folder.run(&["test", "--json"]).code(1).json();
    let test = &json["tests"][0];
    let of = |key: &str| test[key].as_str().unwrap_or_default().to_owned();
    let seen = ["name", "test_file", "verdict", "file", "left", "left_type", "right", "right_type", "said"].map(of);
    assert_eq!(seen, ["motor.test.st: doubles", "motor.test.st", "failed", "motor.test.st", "42", "INT", "0", "INT", "not yet"]);
    let listed = folder.run(&["test", "--list", "--json"]).code(0).json();
    assert_eq!(listed["places"], serde_json::json!([{ "name": "motor.test.st: doubles", "test_file": "motor.test.st", "line": 1 }]));
}

#[test]
fn mocks_replace_calls_and_count_them() {
    run("FUNCTION Amount : INT\nVAR_INPUT x : INT; END_VAR\n  Amount := FC5(x) + 1;\nEND_FUNCTION\n\
         FUNCTION_BLOCK Line\nVAR_INPUT on : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nVAR m : FB10; END_VAR\n\
         \x20 m(start := on);\n  q := m.motor;\nEND_FUNCTION_BLOCK\n\
         TEST 'a function'\n  MOCK_FUNCTION FC5 RETURNS 7;\n  ASSERT_EQ(Amount(100), 8);\n  ASSERT_EQ(FC5(3), 7);\n\
         \x20 SCAN(1);\n  ASSERT_EQ(%MW12, 7);\n  MOCK_VERIFY_CALL_COUNT(FC5, 3);\n  MOCK_VERIFY_CALLED(FC5);\nEND_TEST\n\
         TEST 'not mocked here'\n  ASSERT_EQ(Amount(100), 201);\nEND_TEST\n\
         TEST 'an instance'\n  VAR l : Line; other : Line; END_VAR\n  MOCK l.m;\n  l(on := TRUE);\n  ASSERT_FALSE(l.q);\n\
         \x20 l.m.motor := TRUE;\n  l(on := FALSE);\n  ASSERT_TRUE(l.q);\n  MOCK_VERIFY_CALL_COUNT(l.m, 2);\n\
         \x20 other(on := TRUE);\n  ASSERT_TRUE(other.q);\nEND_TEST\n\
         TEST 'a data block'\n  MOCK DB10;\n  %I0.0 := TRUE;\n  SCAN(3);\n  ASSERT_FALSE(%Q0.0);\n  ASSERT_EQ(DB10.n, 0);\n\
         \x20 MOCK_VERIFY_CALL_COUNT(DB10, 3);\nEND_TEST\n\
         TEST 'a timer'\n  VAR t : TON; END_VAR\n  MOCK t;\n  t(IN := TRUE, PT := T#1s);\n  ADVANCE_TIME(T#2s);\n  t();\n  ASSERT_FALSE(t.Q);\n\
         \x20 MOCK_VERIFY_CALLED(t, 'the timer');\nEND_TEST\n")
    .code(0)
    .stdout("5 passed, 0 failed");
    run("TEST 'never'\n  MOCK_FUNCTION FC5 RETURNS 1;\n  MOCK_VERIFY_CALLED(FC5);\nEND_TEST\n\
         TEST 'once'\n  MOCK_FUNCTION FC5 RETURNS 1;\n  SCAN(1);\n  MOCK_VERIFY_CALL_COUNT(FC5, 2);\nEND_TEST\n\
         TEST 'not at all'\n  SCAN(1);\n  MOCK_VERIFY_CALLED(FC5);\nEND_TEST\n")
    .code(1)
    .stdout("`FC5` was not called")
    .stdout("`FC5` was called once, not 2 times")
    .stdout("`FC5` is not mocked: write `MOCK_FUNCTION FC5 RETURNS 0;` before it");
}

#[test]
fn a_test_that_does_not_end_is_given_up() {
    let folder = folder(
        "TEST 'a loop'\n  WHILE TRUE DO\n    %MW0 := 1;\n  END_WHILE;\nEND_TEST\n\
         TEST 'scans'\n  WHILE TRUE DO\n    SCAN(1);\n  END_WHILE;\nEND_TEST\n\
         TEST 'time'\n  WHILE TRUE DO\n    ADVANCE_TIME(T#1h);\n  END_WHILE;\nEND_TEST\n",
    );
    folder
        .run(&["test", "--timeout", "3s", "--scans", "50"])
        .code(1)
        .stdout("the test took too long and was given up")
        .stdout("the test did not end within 50 scans")
        .stdout("the test did not end within 8640000 s of the CPU's time")
        .stdout("0 passed, 3 failed");
    folder.run(&["test", "--filter", "time", "--limit", "90m"]).code(1).stdout("within 5400 s").stdout("0 passed, 1 failed");
}

#[test]
fn what_is_wrong_in_a_test_file_is_told_once() {
    for (tests, code, wanted) in [
        ("TEST 'a'\n  ASSERT_EQ(cuont, 5);\nEND_TEST\nVAR\n  count : INT;\nEND_VAR\n", "P3001", "`cuont` is not declared"),
        ("TEST 'a'\n  ASSERT_EG(1, 1);\nEND_TEST\n", "P3008", "write `ASSERT_GE`"),
        ("TEST 'a'\n  ASSERT_EQ(1, 'abc');\nEND_TEST\n", "P6200", "a text is wanted"),
        ("TEST 'a'\n  ASSERT_TRUE(1);\n", "P2011", "TEST has no `END_TEST`"),
        ("TEST 'a'\n  ASSERT_TRUE(TRUE);\nTEST 'b'\n  ASSERT_TRUE(TRUE);\nEND_TEST\n", "P2011", "TEST has no `END_TEST`"),
        ("TEST\n  ASSERT_TRUE(TRUE);\nEND_TEST\n", "P2300", "this TEST has no name"),
        ("TEST motor\n  ASSERT_TRUE(TRUE);\nEND_TEST\n", "P2300", "stands in quotes"),
        ("TEST 'a'\n  ;\nEND_TEST\nTEST 'a'\n  ;\nEND_TEST\n", "P2301", "two tests with the name `a`"),
        ("SETUP\n  ;\nEND_SETUP\n", "P2302", "has no TEST"),
        ("%MW0 := 1;\nTEST 'a'\n  ;\nEND_TEST\n", "P2303", "stands inside `TEST`"),
        ("TEST 'a'\n  IF SCAN(1) THEN ; END_IF;\nEND_TEST\n", "P2305", "it has no value"),
        ("TEST 'a'\n  ASSERT_NEAR(TRUE, 1.0);\nEND_TEST\n", "P2305", "compares numbers"),
        ("TEST 'a'\n  ADVANCE_TIME(TRUE);\nEND_TEST\n", "P2305", "takes a duration"),
        ("TEST 'a'\n  EXPECT_STOP('soon');\nEND_TEST\n", "P2305", "`soon` is no event"),
        ("TEST 'a'\n  MOCK FC5;\nEND_TEST\n", "P2306", "MOCK_FUNCTION FC5 RETURNS 0;"),
        ("TEST 'a'\n  MOCK_FUNCTION DB10 RETURNS 1;\nEND_TEST\n", "P2306", "is an instance"),
        ("TEST 'a'\n  MOCK nobody;\nEND_TEST\n", "P3001", "`nobody` is not declared"),
    ] {
        let seen = folder(tests).run(&["test"]).code(3);
        assert!(seen.stdout.contains(code) && seen.stdout.contains(wanted), "{tests}\nwanted {code} {wanted}\n{}", seen.stdout);
        assert!(seen.stdout.contains("1 error"), "{tests}\n{}", seen.stdout);
    }
    let outside = Folder::with(&[("a.st", "PROGRAM P\nVAR x : INT; END_VAR\n  x := 1;\n  ASSERT_EQ(x, 1);\nEND_PROGRAM\n")]);
    outside.run(&["check", "a.st"]).code(3).stderr("P2304");
    folder("TEST 'a'\n  ;\nEND_TEST\n").run(&["check", "motor.test.st"]).code(3).stderr("P6240");
    folder("TEST 'a'\n  ;\nEND_TEST\n").run(&["check"]).code(0);
}

#[test]
fn a_missing_token_gives_few_messages() {
    let text = "VAR\n  n : INT;\nEND_VAR\nSETUP\n  n := 1;\nEND_SETUP\nTEST 'a'\n  VAR x : INT; END_VAR\n  x := n;\n  ASSERT_EQ(x, 1);\nEND_TEST\n\
                TEST 'b'\n  SCAN(1);\n  MOCK_FUNCTION FC5 RETURNS 3;\nEND_TEST\n";
    let words: Vec<&str> = text.split_inclusive([' ', '\n', '(', ')', ';']).collect();
    let folder = folder(text);
    folder.run(&["test"]).code(0);
    for left_out in 0..words.len() {
        let shorter: String = words.iter().enumerate().filter(|(index, _)| *index != left_out).map(|(_, word)| *word).collect();
        folder.write("motor.test.st", shorter.as_bytes());
        let seen = folder.run(&["test"]);
        let errors = seen.stdout.matches("Error:").count();
        assert!(errors <= 3, "without `{}`: {errors} errors\n{}", words[left_out], seen.stdout);
    }
}

#[test]
fn a_failing_test_shows_the_trail_and_who_wrote_last() {
    let tests = "TEST 'the motor'\n  %I0.0 := TRUE;\n  SCAN(3);\n  %I0.1 := TRUE;\n  SCAN(2);\n  ASSERT_TRUE(%Q0.0);\nEND_TEST\n";
    let folder = folder(tests);
    let seen = folder.run(&["test", "--svg", "diagrams"]).code(1);
    for wanted in [
        "`%Q0.0` was changed last by motor.awl:39 `= Q 0.0` (OB 1, statement 3), in scan 3 at 30 ms",
        "%Q0.0",
        "%I0.1",
        "timing diagram: diagrams/the-motor.svg",
    ] {
        assert!(seen.stdout.contains(wanted), "wanted: {wanted}\n{}", seen.stdout);
    }
    assert!(folder.read("diagrams/the-motor.svg").starts_with(b"<svg"));
}

#[test]
fn coverage_counts_the_lines_that_tests_run() {
    let folder =
        folder("TEST 'a'\n  ASSERT_EQ(FC5(2), 4);\n  ASSERT_EQ(FC5(3), 6);\nEND_TEST\nTEST 'b'\n  ASSERT_EQ(FC5(2), 4);\nEND_TEST\n");
    folder.run(&["test", "--coverage", "lcov.info"]).code(0).stdout("4 of 24 lines with statements were run");
    let lcov = String::from_utf8(folder.read("lcov.info")).expect("lcov is UTF-8");
    assert!(lcov.contains("SF:motor.awl\n") && lcov.contains("DA:31,3\n") && lcov.contains("DA:13,0\n"), "{lcov}");
    assert!(!lcov.contains("motor.test.st"), "{lcov}");
}

#[test]
fn coverage_tells_decisions_that_were_seen_one_way_only() {
    let folder = Folder::with(&[
        ("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nA I 0.0\n= Q 0.0\nA I 0.1\nS M 0.0\nEND_ORGANIZATION_BLOCK\n"),
        ("main.test.st", "TEST 'a'\n  SCAN(1);\n  %I0.0 := TRUE;\n  SCAN(2);\nEND_TEST\n"),
    ]);
    let run = folder.run(&["test", "--coverage", "lcov.info"]);
    run.code(0).stdout("1 of 2 decisions have gone every way (50 %)");
    let lcov = String::from_utf8(folder.read("lcov.info")).expect("lcov is UTF-8");
    assert!(lcov.contains("BRDA:4,0,0,1\nBRDA:4,0,1,2\nBRDA:6,0,0,3\nBRDA:6,0,1,0\nBRF:4\nBRH:3\n"), "{lcov}");
}

#[test]
fn tests_are_listed_filtered_and_shuffled() {
    let tests: String = ["one", "two", "three", "four"].map(|name| format!("TEST '{name}'\n  SCAN(1);\nEND_TEST\n")).concat();
    let folder = folder(&tests);
    let listed = folder.run(&["test", "--list"]).code(0);
    assert_eq!(listed.stdout, "motor.test.st: one\nmotor.test.st: two\nmotor.test.st: three\nmotor.test.st: four\n");
    folder.run(&["test", "--filter", "th"]).code(0).stdout("1 passed");
    let order = |seed: &str| folder.run(&["test", "--seed", seed]).code(0).stdout("order: --seed").stdout;
    assert_eq!(order("7"), order("7"));
    assert!((1..10).any(|seed| !order(&seed.to_string()).starts_with("ok    motor.test.st: one")));
    folder.run(&["test", "--tap"]).code(0).stdout("1..4\nok 1 - motor.test.st: one\n");
    folder.run(&["test", "--junit", "result.xml"]).code(0);
    assert!(String::from_utf8_lossy(&folder.read("result.xml")).contains("classname=\"motor.test.st\""));
}

#[test]
fn variables_of_a_program_of_structured_text_are_seen() {
    let folder = Folder::with(&[
        ("main.st", "PROGRAM Main\nVAR\n  count : INT;\nEND_VAR\n  count := count + 1;\nEND_PROGRAM\n"),
        (
            "main.test.st",
            "TEST 'it counts'\n  SCAN(3);\n  ASSERT_EQ(Main.count, 3);\n  Main.count := 10;\n  SCAN();\n  ASSERT_EQ(Main.count, 11);\nEND_TEST\n",
        ),
        ("sieben.toml", "[project]\nname = \"counter\"\n[cpu]\ncycle = \"100ms\"\n"),
    ]);
    folder.run(&["test"]).code(0).stdout("ok    main.test.st: it counts  (4 scans, 300 ms of virtual time)").stdout("1 passed, 0 failed");
    folder.run(&["check"]).code(0);
}

#[test]
fn what_setup_declares_is_there_for_each_test_and_fresh() {
    let program = "FUNCTION_BLOCK Pump\nVAR_INPUT on : BOOL; END_VAR\nVAR_OUTPUT n : INT; END_VAR\n  IF on THEN n := n + 1; END_IF;\nEND_FUNCTION_BLOCK\nPROGRAM Main\nVAR p : Pump; END_VAR\n  p(on := TRUE);\nEND_PROGRAM\n";
    let tests = "SETUP\n  VAR pump : Pump; count : INT := 3; END_VAR\n  pump(on := TRUE);\n  count := count + 1;\nEND_SETUP\nTEARDOWN\n  count := 0;\nEND_TEARDOWN\n\
         TEST 'one'\n  ASSERT_EQ(count, 4);\n  pump();\n  ASSERT_EQ(pump.n, 2);\nEND_TEST\n\
         TEST 'its own goes before'\n  VAR count : INT; END_VAR\n  ASSERT_EQ(count, 0);\n  ASSERT_EQ(pump.n, 1);\nEND_TEST\n";
    let folder = Folder::with(&[("main.st", program), ("main.test.st", tests)]);
    folder.run(&["test"]).code(0).stdout("2 passed, 0 failed");
    folder.write("main.test.st", b"TEST 'named'\n  SCAN(2);\n  ASSERT_EQ(Main.p.n, 7);\nEND_TEST\n");
    folder.run(&["test"]).code(1).stdout("`Main.p.n` was changed last by main.st:4 `n := n + 1` (in `Pump`), in scan 1 at 10 ms");
}

#[test]
fn a_file_with_too_many_tests_is_told_once() {
    let tests: String = (0..5_001).map(|number| format!("TEST 't{number}' END_TEST\n")).collect();
    let seen = folder(&tests).run(&["test"]).code(3).stdout("a test file has at most 5000 tests");
    assert!(seen.stdout.contains("1 error"), "{}", seen.stdout);
}

#[test]
fn an_input_that_a_test_writes_is_held_even_at_the_value_it_had() {
    let folder = Folder::with(&[
        ("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nA I 0.1\n= Q 4.1\nSET\n= Q 0.0\nEND_ORGANIZATION_BLOCK\n"),
        (
            "main.test.st",
            "TEST 'the tank fills'\n  SCAN(6000);\n  ASSERT_TRUE(%Q4.1);\nEND_TEST\n\
             TEST 'a switch that never closes'\n  %I0.1 := FALSE;\n  SCAN(6000);\n  ASSERT_FALSE(%Q4.1);\n  ASSERT_TRUE(%I0.0, 'others are free');\nEND_TEST\n\
             TEST 'all of a byte'\n  %IB0 := 0;\n  SCAN(6000);\n  ASSERT_EQ(%IB0, 0);\n  ASSERT_GT(%IW2, 20000, 'others are free');\nEND_TEST\n",
        ),
        ("sieben.toml", "[project]\nname = \"tank\"\n[[module]]\nkind = \"tank\"\nlevel = 20\n"),
    ]);
    for engine in ["interpreter", "jit"] {
        folder.run(&["test", "--engine", engine]).code(0).stdout("3 passed, 0 failed");
    }
}

/// The second run, which looks for who wrote a value, gets the time that the first one left.
#[test]
fn a_timeout_holds_for_all_that_is_done_for_a_test() {
    let slow = "VAR i : INT; x : DINT; END_VAR\nFOR i := 1 TO 20000 DO\n  x := x + 1;\nEND_FOR;\n";
    let folder = Folder::with(&[
        ("slow.st", slow),
        ("slow.test.st", "TEST 'never'\nWHILE NOT %Q0.0 DO SCAN(1); END_WHILE;\nASSERT_TRUE(%Q0.0);\nEND_TEST\n"),
        ("slow.scenario", "expect Q 0.0=1 within 9000s\n"),
        ("never.awl", "L 1\n"),
    ]);
    let long = ["--timeout", "2s", "--scans", "1000000000000", "--limit", "10000h", "--json"];
    for test in [&["slow.st", "slow.test.st"][..], &["slow.st", "slow.scenario"], &["never.awl"]] {
        let arguments: Vec<&str> = ["test"].into_iter().chain(test.iter().copied()).chain(long).collect();
        let json = folder.run(&arguments).code(1).json();
        let took = json["tests"][0]["duration_s"].as_f64().expect("a number");
        assert!((2.0..3.5).contains(&took), "{test:?}: {took} s");
        assert!(!json["tests"][0]["more"].to_string().contains('─'), "{json:#}");
    }
}
