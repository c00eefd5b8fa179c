//! Coverage of tests: behind each line of a program stands how often it ran, and how often its decisions went each way.

mod command;

use std::collections::BTreeMap;

use command::Folder;

/// What lcov says of a line: how often it ran, and the ways of each of its decisions.
type Line = (u64, Vec<Vec<u64>>);

/// The lines of a tracefile, by source. A decision that was not reached has ways that were gone 0 times.
fn lcov(text: &str) -> BTreeMap<String, BTreeMap<usize, Line>> {
    let mut all: BTreeMap<String, BTreeMap<usize, Line>> = BTreeMap::new();
    let mut file = String::new();
    let number = |text: &str| if text == "-" { 0 } else { text.parse::<u64>().expect("a number") };
    for line in text.lines() {
        let (kind, rest) = line.split_once(':').unwrap_or((line, ""));
        let values: Vec<&str> = rest.split(',').collect();
        match kind {
            "SF" => file = rest.to_owned(),
            "DA" => all.entry(file.clone()).or_default().entry(number(values[0]) as usize).or_default().0 = number(values[1]),
            "BRDA" => {
                let decisions = &mut all.entry(file.clone()).or_default().entry(number(values[0]) as usize).or_default().1;
                decisions.resize((number(values[1]) as usize + 1).max(decisions.len()), Vec::new());
                decisions[number(values[1]) as usize].push(number(values[3]));
            }
            _ => {}
        }
    }
    all
}

/// What stands behind `//=` of each line: `3` ran three times, `3 [2 1]` with a decision that went one way twice and the other once.
fn wanted(source: &str) -> BTreeMap<usize, Line> {
    let noted = (1..).zip(source.lines()).filter_map(|(number, line)| Some((number, line.split_once("//=")?.1)));
    noted
        .map(|(number, note)| {
            let (ran, rest) = note.trim().split_once(' ').unwrap_or((note.trim(), ""));
            let numbers = |text: &str| text.split_whitespace().map(|word| word.parse().expect("a number")).collect();
            let decisions = rest.split('[').skip(1).map(|part| numbers(part.trim_end().trim_end_matches(']'))).collect();
            (number, (ran.parse().expect("a number"), decisions))
        })
        .collect()
}

/// Runs the tests of a program and compares what was counted with what stands beside its lines.
#[track_caller]
fn counts(name: &str, program: &str, tests: &str, more: &[&str]) -> Folder {
    let folder = Folder::with(&[(name, program), ("a.test.st", tests)]);
    folder.run(&[&["test", "--coverage", "lcov.info"], more].concat()).code(0);
    let counted = lcov(&String::from_utf8(folder.read("lcov.info")).expect("lcov is UTF-8"));
    let (seen, wanted) = (&counted[name], wanted(program));
    let line = |number: usize| program.lines().nth(number - 1).unwrap_or_default();
    for number in seen.keys().chain(wanted.keys()) {
        assert_eq!(seen.get(number), wanted.get(number), "{name}:{number}: {}", line(*number));
    }
    folder
}

/// The same statements for `iec`, `codesys` and `tia`, but for what only one of them has.
const ST: &str = "\
FUNCTION_BLOCK Line
VAR_INPUT
  go : BOOL;
  n : INT;
END_VAR
VAR_OUTPUT
  q : BOOL;
  sum : INT;
END_VAR
VAR
  i : INT;
  inner : Inner;
END_VAR
  IF go AND n > 3 THEN                      //= 3 [2 1]
    q := TRUE;                              //= 1
  ELSIF n = 2 THEN                          //= 2 [1 1]
    q := FALSE;                             //= 1
  ELSE
    sum := 7;                               //= 1
  END_IF;
  sum := 0;                                 //= 3
  FOR i := 1 TO n DO                        //= 3 [1 2]
    sum := sum + i;                         //= 6
    IF sum > 100 THEN                       //= 6 [6 0]
      EXIT;                                 //= 0
    END_IF;
  END_FOR;
  FOR i := 1 TO 2 DO                        //= 3
    IF i = 2 THEN EXIT; END_IF;             //= 6 [3 3]
  END_FOR;
  WHILE sum > 50 DO                         //= 3 [3 0]
    sum := sum - 10;                        //= 0
  END_WHILE;
  WHILE sum > 5 DO                          //= 8 [3 5]
    sum := sum - 1;                         //= 5
  END_WHILE;
  REPEAT                                    //= 10
    sum := sum + 1;                         //= 10
  UNTIL
    sum > 5                                 //= 10 [7 3]
  END_REPEAT;
  CASE n OF                                 //= 3 [1 1 0 1]
    1, 2: q := TRUE;                        //= 1
    3..5:
      q := FALSE;                           //= 1
    7: q := TRUE;                           //= 0
  END_CASE;
  CASE n OF                                 //= 3 [1 2]
    0: ;
  ELSE
    q := go;                                //= 2
  END_CASE;
  IF TRUE THEN                              //= 3
    sum := sum + 1;                         //= 3
  END_IF;
  inner(EN := go,                           //= 3 [2 1]
        x := n);
  IF go THEN                                //= 3 [2 1]
    RETURN;                                 //= 1
  END_IF;
  q := NOT q;                               //= 2
END_FUNCTION_BLOCK
FUNCTION_BLOCK Inner
VAR_INPUT
  x : INT;
END_VAR
VAR
  y : INT;
END_VAR
  y := x;                                   //= 1
END_FUNCTION_BLOCK
";

const ST_TESTS: &str =
    "TEST 'a'\n  VAR l : Line; END_VAR\n  l(go := TRUE, n := 4);\n  l(go := FALSE, n := 2);\n  l(go := FALSE, n := 0);\nEND_TEST\n";

#[test]
fn decisions_of_structured_text_are_counted_in_each_dialect() {
    counts("line.st", ST, ST_TESTS, &[]);
    counts("line.st", ST, ST_TESTS, &["--dialect", "codesys"]);
    let tia = ST
        .replace("FUNCTION_BLOCK Line", "FUNCTION_BLOCK \"Line\"")
        .replace("FUNCTION_BLOCK Inner", "FUNCTION_BLOCK \"Inner\"")
        .replace(": Inner", ": \"Inner\"")
        .replace("END_VAR\n  ", "END_VAR\nBEGIN\n  ");
    counts("line.scl", &tia, ST_TESTS, &["--dialect", "tia"]);
}

#[test]
fn what_one_dialect_has_is_counted_too() {
    let codesys = "\
FUNCTION F : INT
VAR_INPUT
  a : BOOL;
  b : BOOL;
END_VAR
VAR
  q : BOOL;
  last : INT := 3;
  i : INT;
END_VAR
  q S= a;                                   //= 3 [1 2]
  q R= b;                                   //= 3 [2 1]
  IF a AND_THEN b OR_ELSE q THEN            //= 3 [1 2]
    F := 1;                                 //= 2
  END_IF;
  FOR i := 1 TO last DO                     //= 3 [0 3]
    last := 2;                              //= 9
  END_FOR;
END_FUNCTION
";
    let tests = "TEST 'a'\n  F(TRUE, TRUE);\n  F(FALSE, FALSE);\n  F(TRUE, FALSE);\nEND_TEST\n";
    counts("f.st", codesys, tests, &["--dialect", "codesys"]);
    let classic = "\
FUNCTION FC 7 : INT
VAR_INPUT
  n : INT;
END_VAR
VAR_TEMP
  i : INT;
END_VAR
BEGIN
  FC7 := 0;                                 //= 2
  FOR i := n TO 1 BY -1 DO                  //= 2 [1 1]
    CONTINUE;                               //= 3
  END_FOR;
  IF NOT (n = 0) THEN                       //= 2 [1 1]
    FC7 := 1;                               //= 1
  END_IF;
END_FUNCTION
";
    counts("f.scl", classic, "TEST 'a'\n  FC7(3);\n  FC7(0);\nEND_TEST\n", &["--dialect", "scl"]);
}

#[test]
fn decisions_of_stl_are_counted_in_both_mnemonics() {
    let german = "\
ORGANIZATION_BLOCK OB 100
BEGIN
      SET;                                  //= 1
      S     M 9.0;                          //= 1 [0 1]
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
      U     E 0.0;                          //= 3
      =     A 0.0;                          //= 3 [1 2]
      SPB   m1;                             //= 3 [1 2]
      L     1;                              //= 1
      T     MW 2;                           //= 1
m1:   L     MW 10;                          //= 3
      L     5;                              //= 3
      >I;                                   //= 3
      SPBN  m2;                             //= 3 [3 0]
      SET; S M 1.0;                         //= 0 [0 0]
m2:   L     MB 20;                          //= 3
      SPL   ende;                           //= 3 [1 2 0]
      SPA   a0;                             //= 1
      SPA   a1;                             //= 2
ende: SPA   weg;                            //= 0
a0:   L 1; SPA weg;                         //= 1
a1:   L 2;                                  //= 2
weg:  L     3;                              //= 3
next: T     MB 30;                          //= 9
      L     MB 30;                          //= 9
      LOOP  next;                           //= 9 [3 6]
      L     MW 10;                          //= 3
      L     0;                              //= 3
      -I;                                   //= 3
      SPZ   null;                           //= 3 [0 3]
      NOP 0;                                //= 0
null: SPO   null;                           //= 3 [3 0]
      U     E 0.0;                          //= 3
      SAVE;                                 //= 3
      SPBIN ohne;                           //= 3 [2 1]
      NOP 0;                                //= 2
ohne: U     E 0.0;                          //= 3
      FP    M 5.0;                          //= 3 [1 2]
      L     S5T#2S;                         //= 3
      SE    T 1;                            //= 3 [2 1]
      U     E 0.0;                          //= 3
      CC    FC 1;                           //= 3 [1 2]
      U     E 0.0;                          //= 3
      ZV    Z 1;                            //= 3 [1 2]
      R     T 1;                            //= 3 [1 2]
      BEB;                                  //= 3 [1 2]
      NOP 0;                                //= 1
END_ORGANIZATION_BLOCK
FUNCTION FC 1 : VOID
BEGIN
      L     5;                              //= 2
      T     MW 40;                          //= 2
END_FUNCTION
";
    let tests = "TEST 'a'\n  SCAN(1);\n  %E0.0 := TRUE;\n  %MB20 := 1;\n  SCAN(2);\nEND_TEST\n";
    let folder = counts("main.awl", german, tests, &["--mnemonics", "de"]);
    folder.write("main.awl", german.as_bytes());
    folder.run(&["convert", "--mnemonics", "en", "--write", "main.awl"]).code(0);
    let english = String::from_utf8(folder.read("main.awl")).expect("UTF-8");
    assert!(english.contains("JNBI"), "{english}");
    counts("main.awl", &english, tests, &[]);
}

#[test]
fn a_block_that_is_mocked_is_counted_by_its_own_statements() {
    let program = "\
FUNCTION FC 5 : INT
BEGIN
      A     I 0.0;                          //= 1
      JC    one;                            //= 1 [1 0]
      L     1;                              //= 1
      T     #RET_VAL;                       //= 1
one:  NOP 0;                                //= 1
END_FUNCTION
";
    let tests = "TEST 'a'\n  FC5();\n  MOCK_FUNCTION FC5 RETURNS 7;\n  FC5();\nEND_TEST\n";
    counts("main.awl", program, tests, &[]);
}

#[test]
fn programs_that_check_themselves_are_counted_without_the_test() {
    let main = "FUNCTION FC 5 : VOID\nBEGIN\nSET\n= M 0.0\nBEC\nNOP 0\nEND_FUNCTION\n";
    let check = "CALL FC 5\n__ASSERT== M 0.0, 1\nCALL SFC 46\n";
    let folder = Folder::with(&[("src/main.awl", main), ("checks/five.awl", check)]);
    folder
        .run(&["test", "src", "--tests", "checks/five.awl", "--coverage", "lcov.info"])
        .code(0)
        .stdout("3 of 4 lines with statements were run (75 %)");
    let counted = lcov(&String::from_utf8(folder.read("lcov.info")).expect("lcov is UTF-8"));
    assert_eq!(counted.keys().collect::<Vec<_>>(), ["src/main.awl"]);
    assert_eq!(counted["src/main.awl"][&5], (1, vec![vec![0, 1]]));
}

#[test]
fn the_summary_tells_each_source_and_the_lines_that_were_not_run() {
    let folder = Folder::with(&[("line.st", ST), ("a.test.st", ST_TESTS)]);
    let seen = folder.run(&["test", "--coverage", "lcov.info", "--junit", "result.xml"]).code(0);
    assert!(
        seen.stdout.ends_with(
            "coverage  lines            decisions       lines not run\n\
             line.st   29 of 32 (90 %)  9 of 12 (75 %)  25, 32, 46\n\
             29 of 32 lines with statements were run (90 %)\n\
             9 of 12 decisions have gone every way (75 %)\n"
        ),
        "{}",
        seen.stdout
    );
    let json = folder.run(&["test", "--json", "--coverage", "lcov.info"]).code(0).json();
    assert_eq!(json["coverage"][0]["lines_not_run"], serde_json::json!([[25, 25], [32, 32], [46, 46]]));
    assert_eq!(json["decisions_covered"], 9);
}

#[test]
fn pages_show_what_is_missing_in_words() {
    let program = "\u{FEFF}ORGANIZATION_BLOCK OB 1\nTITLE = <b>Förderband & Co</b>\nBEGIN\n      U E 0.0;\n      SPB  weg;\n      L 1;\n      T MW 2;\nweg:  NOP 0;\n      = A 0.0;\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("bänder/a&b.awl", program), ("a.test.st", "TEST 'a'\n  %E0.0 := TRUE;\n  SCAN(2);\nEND_TEST\n")]);
    // As STEP 7 writes it: one byte for each character.
    let latin = "FUNCTION FC 1 : VOID\nTITLE = Größe\nBEGIN\nNOP 0;\nEND_FUNCTION\n";
    folder.write("bänder/latin.awl", &latin.chars().map(|character| character as u8).collect::<Vec<u8>>());
    let seen = folder.run(&["test", "--coverage-html", "out/pages", "--mnemonics", "de"]).code(0);
    assert!(seen.stdout.contains("pages for a browser: out/pages/index.html"), "{}", seen.stdout);
    let page = |name: &str| String::from_utf8(folder.read(&format!("out/pages/{name}"))).expect("UTF-8");
    let index = page("index.html");
    assert!(index.contains("bänder/a&amp;b.awl</a>"), "{index}");
    let source = page("b-nder-a-b.awl.html");
    for wanted in [
        "TITLE = &lt;b&gt;Förderband &amp; Co&lt;/b&gt;",
        "<code>SPB weg</code> – RLO 0: never, RLO 1: 2 times",
        "<tr id=\"L6\" class=\"missed\" data-gap>",
        "<td class=\"count\">never<span class=\"links\"><a href=\"#L5\" title=\"previous place\"",
        "<a href=\"#L5\">3 places to look at ↓</a>",
        "prefers-color-scheme: dark",
    ] {
        assert!(source.contains(wanted), "wanted: {wanted}\n{source}");
    }
    assert!(page("b-nder-latin.awl.html").contains("TITLE = Größe"));
    assert!(!index.contains("http") && !source.contains("http"), "pages need nothing but themselves");
}

#[test]
fn pages_overwrite_only_pages() {
    let folder = Folder::with(&[
        ("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNOP 0\nEND_ORGANIZATION_BLOCK\n"),
        ("a.test.st", "TEST 'a'\n  SCAN(1);\nEND_TEST\n"),
        ("file", "mine"),
        ("site/index.html", "mine"),
    ]);
    let refused = |target: &str, words: &str| {
        let seen = folder.run(&["test", "--coverage-html", target]).code(2).stdout("1 passed").stderr("[P6300]").stderr(words);
        assert!(!seen.stdout.contains("pages for a browser"), "{}", seen.stdout);
    };
    refused("file", "`file` is a file");
    refused("site", "`site/index.html` is there already, and no page of coverage");
    assert_eq!(folder.read("site/index.html"), b"mine");
    folder.run(&["test", "--coverage-html", "file/below"]).code(2).stderr("`file/below` cannot be written");
    for _ in 0..2 {
        folder.run(&["test", "--coverage-html", "pages"]).code(0).stdout("pages for a browser: pages/index.html");
    }
}

#[test]
fn elements_of_a_diagram_are_counted_where_they_stand() {
    let body = "
    OR                                      //= 3
        NO  I 0.0                           //= 3
    OR
        NO  I 0.1                           //= 3
    END
    NC     I 0.2                            //= 3
    COIL   Q 0.0                            //= 3 [1 2]
    ADD_I  MW 2, 1 => MW 2                  //= 3 [1 2]
NETWORK STL
      L     MW 2;                           //= 3
      T     MW 4;                           //= 3
NETWORK FBD
    CMP  >I MW 2, 5                         //= 3
    JMP  weg                                //= 3 [3 0]
NETWORK LAD
    MOVE 1 => MW 10                         //= 3
NETWORK LAD
    LABEL weg:
    NO   M 9.0                              //= 3
    SET  M 9.1                              //= 3 [3 0]
END_ORGANIZATION_BLOCK
";
    let body = body.replace("    ADD_I", "NETWORK LAD\n    NO     Q 0.0                            //= 3\n    ADD_I");
    let tests = "TEST 'a'\n  SCAN(1);\n  %I0.1 := TRUE;\n  SCAN(2);\nEND_TEST\n";
    for name in ["main.lad", "main.awl"] {
        counts(name, &format!("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK LAD{body}"), tests, &[]);
    }
}
