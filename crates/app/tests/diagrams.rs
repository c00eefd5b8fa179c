//! Networks in another form, as users ask for it: `convert --to`.

mod command;

use command::Folder;
use serde_json::Value;

/// A block with a network of each answer: exact, equivalent, none, and one that is a diagram already.
const SOURCE: &str = "\
FUNCTION FC 1 : VOID
VAR_TEMP
  t : BOOL;
END_VAR
BEGIN
NETWORK
TITLE = Pump
// self-holding
      A(    ;
      O     I 0.0;                      // the button
      O     Q 4.0;
      )     ;
      AN    I 0.1;
      =     Q 4.0;
NETWORK
TITLE = Copy
      L     MW 10;
      T     MW 12;
NETWORK
      L     MW 10;
      LAR1  ;
NETWORK LAD
    NO    I 0.2
    COIL  Q 4.1  // lamp
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  FC 1;
      NOP   0;
END_ORGANIZATION_BLOCK
";

#[test]
fn what_can_be_drawn_is_drawn_and_everything_else_keeps_its_bytes() {
    let folder = Folder::with(&[("main.awl", SOURCE)]);
    let run = folder.run(&["convert", "main.awl", "--to", "lad"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let drawn = SOURCE.replace(
        "NETWORK\nTITLE = Pump\n// self-holding\n      A(    ;\n      O     I 0.0;                      // the button\n      O     Q 4.0;\n      )     ;\n      AN    I 0.1;\n      =     Q 4.0;\n",
        "NETWORK LAD\nTITLE = Pump\n// self-holding\n    OR\n        NO  I 0.0  // the button\n    OR\n        NO  Q 4.0\n    END\n    NC    I 0.1\n    COIL  Q 4.0\n",
    );
    let drawn = drawn.replace("NETWORK\n      CALL  FC 1;\n      NOP   0;\n", "NETWORK LAD\n    CALL FC 1\n");
    assert_eq!(run.stdout, drawn);
    assert!(run.stderr.contains("FC 1, network 2 stays") && run.stderr.contains("`--rewrite` draws it (W1)"), "{}", run.stderr);
    assert!(run.stderr.contains("FC 1, network 3 stays as written, R-OPCODE"), "{}", run.stderr);
    assert!(run.stderr.contains("2 networks stay as written."), "{}", run.stderr);
    folder.write("main.lad.awl", drawn.as_bytes());
    assert_eq!(folder.run(&["convert", "main.lad.awl", "--to", "lad"]).stdout, drawn, "what is drawn stays");
}

#[test]
fn rewriting_draws_what_means_the_same() {
    let folder = Folder::with(&[("main.awl", SOURCE)]);
    let run = folder.run(&["convert", "main.awl", "--to", "fbd", "--rewrite", "--block", "FC 1"]);
    assert!(run.stdout.contains("NETWORK FBD\nTITLE = Copy\n    MOVE MW 10 => MW 12\n"), "{}", run.stdout);
    assert!(run.stdout.contains("NETWORK FBD\n    NO    I 0.2\n    COIL  Q 4.1  // lamp\n"), "{}", run.stdout);
    assert!(run.stdout.contains("CALL  FC 1;"), "the other block is not asked for: {}", run.stdout);
    assert!(run.stderr.contains("1 network stays as written."), "{}", run.stderr);
}

#[test]
fn a_diagram_becomes_the_statements_it_stands_for_and_is_drawn_the_same_again() {
    let diagram = "NETWORK\nTITLE = A\n    NO  I 0.0  // a\n    ADD_I MW 0, 1 => MW 0  // b\n    S_ODT T 5\n        TV := S5T#2S\n        R:\n            NO  I 0.7\n    COIL  Q 4.0\n    // the end\n";
    let folder = Folder::with(&[("main.lad", diagram)]);
    let stl = folder.run(&["convert", "main.lad", "--to", "stl", "-o", "main.awl"]);
    assert_eq!((stl.code, stl.stderr.as_str()), (Some(0), ""));
    let text = String::from_utf8(folder.read("main.awl")).expect("it is UTF-8");
    for part in ["NETWORK STL\nTITLE = A\n", "// a", "// b", "// the end", "JNB   _001;", "_001: A     BR;", "SD    T 5;"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let again = folder.run(&["convert", "main.awl", "--to", "lad"]);
    assert_eq!(again.stdout.replace("NETWORK LAD", "NETWORK"), diagram.replace("    // the end", "      // the end"), "{}", again.stderr);
    let line = folder.run(&["convert", "main.lad", "--to", "fbd", "--form", "b"]);
    assert!(line.stdout.contains("S_ODT[T 5]"), "{}", line.stdout);
    folder.write("line.fbd", line.stdout.replace("NETWORK FBD", "NETWORK").as_bytes());
    let check = folder.run(&["check", "line.fbd"]);
    assert_eq!(check.code, Some(0), "{}{}", line.stdout, check.stderr);
}

#[test]
fn json_has_an_object_for_each_network() {
    let folder = Folder::with(&[("main.awl", SOURCE)]);
    let run = folder.run(&["convert", "main.awl", "--to", "lad", "--json"]);
    let all: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|error| panic!("{error}: {}", run.stdout));
    let row = |index: usize| &all[index];
    assert_eq!((&row(0)["answer"], &row(0)["block"], &row(0)["network"]), (&"exact".into(), &"FC 1".into(), &1.into()));
    assert_eq!(
        row(0)["text"],
        "    OR\n        NO  I 0.0  // the button\n    OR\n        NO  Q 4.0\n    END\n    NC    I 0.1\n    COIL  Q 4.0\n"
    );
    assert_eq!((&row(1)["answer"], &row(1)["codes"]), (&"equivalent".into(), &serde_json::json!(["W1"])));
    assert_eq!((&row(2)["answer"], &row(2)["reason"], &row(2)["statement"]), (&"no".into(), &"R-OPCODE".into(), &2.into()));
    assert_eq!(row(3)["answer"], "exact");
    assert_eq!(all.as_array().map(Vec::len), Some(5));
}

#[test]
fn files_are_replaced_with_their_encoding_and_line_ends() {
    let folder = Folder::new();
    let source = "NETWORK\r\nTITLE = \u{d6}ffnen\r\n      U     E 0.0;\r\n      =     A 4.0;\r\n";
    let bytes: Vec<u8> = source.chars().map(|sign| sign as u8).collect();
    folder.write("main.awl", &bytes);
    let run = folder.run(&["convert", "main.awl", "--to", "lad", "--write"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let expected = "NETWORK LAD\r\nTITLE = \u{d6}ffnen\r\n    NO    E 0.0\r\n    COIL  A 4.0\r\n";
    assert_eq!(folder.read("main.awl"), expected.chars().map(|sign| sign as u8).collect::<Vec<_>>());
}

#[test]
fn what_cannot_be_done_is_said() {
    let folder =
        Folder::with(&[("main.awl", SOURCE), ("wrong.awl", "A I 0.0;\nFOO;\n"), ("xor.awl", "A I 0.0;\nX I 0.1;\nA I 0.2;\n= Q 4.0;\n")]);
    let unknown = folder.run(&["convert", "main.awl", "--to", "lad", "--block", "FB 7"]);
    assert_eq!(unknown.code, Some(2));
    assert!(unknown.stderr.contains("there is no block `FB 7`") && unknown.stderr.contains("FC 1"), "{}", unknown.stderr);
    let wrong = folder.run(&["convert", "wrong.awl", "--to", "lad"]);
    assert_eq!((wrong.code, wrong.stdout.as_str()), (Some(3), ""));
    let two = folder.run(&["convert", "main.awl", "--to", "lad", "--mnemonics", "de"]);
    assert_eq!(two.code, Some(2));
    let none = folder.run(&["convert", "main.awl"]);
    assert_eq!(none.code, Some(2));
    let form = folder.run(&["convert", "main.awl", "--mnemonics", "de", "--form", "b"]);
    assert_eq!(form.code, Some(2));
}

#[test]
fn what_convert_writes_compiles_whatever_the_size() {
    let chain = format!("NETWORK\n{}      =     Q 4.0;\n", "      A     I 0.0;\n      O     I 0.1;\n".repeat(4000));
    let wide = format!("NETWORK\n{}      =     Q 4.0;\n", "      A     I 0.0;\n".repeat(9000));
    let deep = format!("NETWORK\n{}      =     Q 4.0;\n", "      A     I 0.0;\n      O     I 0.1;\n".repeat(5));
    let folder = Folder::with(&[("chain.awl", &chain), ("wide.awl", &wide), ("deep.awl", &deep)]);
    for (name, code) in [("chain.awl", "R-DEPTH"), ("wide.awl", "R-SIZE"), ("deep.awl", "")] {
        let run = folder.run(&["convert", name, "--to", "lad", "--rewrite", "--write"]);
        assert_eq!(run.code, Some(0), "{name}: {}", run.stderr);
        assert!(run.stderr.contains(code), "{name}: {}", run.stderr);
        assert_eq!(folder.run(&["check", name]).code, Some(0), "{name}");
        assert_eq!(folder.run(&["render", name]).code, Some(0), "{name}");
    }
    assert!(String::from_utf8_lossy(&folder.read("deep.awl")).contains("NETWORK LAD"));
}

#[test]
fn empty_networks_mixed_line_ends_and_labels_in_use_are_kept() {
    let source = "\
FUNCTION FC 1 : VOID
BEGIN
NETWORK
TITLE = Nothing yet
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK LAD\r
    NO  I 0.0\r
    MOVE 1 => MW 0\r
NETWORK
      A     I 0.1;
      JNB   _001;
      L     2;
      T     MW 2;
_001: NOP   0;
END_ORGANIZATION_BLOCK
";
    let folder = Folder::with(&[("main.awl", source)]);
    let stl = folder.run(&["convert", "main.awl", "--to", "stl"]);
    let network = "NETWORK\r\n      A     I 0.0;\r\n      JNB   _002;\r\n      L     1;\r\n      T     MW 0;\r\n_002: NOP   0;\r\n";
    assert!(stl.stdout.contains(network), "{:?}", stl.stdout);
    assert!(stl.stdout.contains("TITLE = Nothing yet\nEND_FUNCTION\n"), "{:?}", stl.stdout);
    folder.write("stl.awl", stl.stdout.as_bytes());
    assert_eq!(folder.run(&["check", "stl.awl"]).code, Some(0), "{}", stl.stdout);
    let lad = folder.run(&["convert", "main.awl", "--to", "lad", "--json"]);
    let all: Value = serde_json::from_str(&lad.stdout).unwrap_or_else(|error| panic!("{error}: {}", lad.stdout));
    assert_eq!((&all[0]["block"], &all[0]["answer"]), (&"FC 1".into(), &"exact".into()));
}

#[test]
fn a_file_of_one_line_networks_becomes_every_form() {
    let source = "I 0.0 -> = Q 4.0\nI 0.1 /I 0.2 -> = Q 4.1\n\nI 0.3 -> S M 0.0\n";
    let all: [&[&str]; 5] = [&["lad"], &["fbd"], &["stl"], &["lad", "--form", "b"], &["fbd", "--form", "b"]];
    for options in all {
        let folder = Folder::with(&[("x.lad", source)]);
        let run = folder.run(&[&["convert", "x.lad", "--write", "--to"], options].concat());
        assert_eq!(run.code, Some(0), "{options:?}: {}", run.stderr);
        let check = folder.run(&["check", "x.lad"]);
        assert_eq!(check.code, Some(0), "{options:?}: {}{}", check.stderr, String::from_utf8_lossy(&folder.read("x.lad")));
        let show = ["exec", "x.lad", "--set", "I0.1=1", "--set", "I0.3=1", "--show", "Q4.0,Q4.1,M0.0"];
        assert_eq!(
            folder.run(&show).stdout,
            "Q4.0 = 0\nQ4.1 = 1\nM0.0 = 1\n",
            "{options:?}: {}",
            String::from_utf8_lossy(&folder.read("x.lad"))
        );
    }
}

/// Programs in which a rewrite of a network could be seen from outside of it; what is set, and what is shown.
const SEEN_FROM_OUTSIDE: &[(&str, &[&str], &str)] = &[
    ("NETWORK\nA I 0.0; SAVE;\nNETWORK\nO I 0.1; = Q 4.0;\n", &["I0.0=1"], "Q4.0"),
    ("NETWORK\nA I 0.0; SAVE;\nNETWORK\nX I 0.1; X I 0.2; = Q 4.0;\n", &["I0.0=1"], "Q4.0"),
    ("NETWORK\nA I 0.0; SAVE;\nNETWORK\nO I 0.1; O I 0.2; A I 0.3; = Q 4.0;\n", &["I0.0=1", "I0.3=1"], "Q4.0"),
    ("NETWORK\nA I 0.0; SAVE;\nNETWORK\nA I 0.2; AN(; A I 0.1; A I 0.3; ); = Q 4.0;\n", &["I0.2=1"], "Q4.0"),
    ("NETWORK\nA I 0.0; SAVE; O I 0.1; = Q 4.0;\n", &["I0.0=1"], "Q4.0"),
    ("NETWORK\nA I 0.0;\nNETWORK\nO I 0.1; = Q 4.0;\n", &["I0.0=1"], "Q4.0"),
    (
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.0; = L 0.0;\nNETWORK\nA I 0.1; = L 5.0; A L 5.0; AN I 0.3; = Q 4.0; A L 5.0; BLD 102; = Q 4.1;\nNETWORK\nA L 0.0; = Q 4.2;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1;\nEND_ORGANIZATION_BLOCK\n",
        &["I0.0=1"],
        "Q4.2",
    ),
    (
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.2; = L 6.0; A L 6.0; AN M 1.2; = M 100.3; A L 6.0; BLD 102; = M 100.5;\nNETWORK\nA I 0.4; A L 6.0; = M 100.4;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1;\nEND_ORGANIZATION_BLOCK\n",
        &["I0.2=1", "I0.4=1"],
        "M100.4",
    ),
    (
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nAN I 0.0; SAVE;\nNETWORK\nA I 0.1; = Q 0.0;\nNETWORK\nL MW 10; T MW 12; T MW 14;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1;\nA BR; = M 60.1;\nEND_ORGANIZATION_BLOCK\n",
        &["I0.0=1"],
        "M60.1",
    ),
    (
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.2; JNB m1; L MW 10; L 1; +I; T MW 12; AN OV; SAVE; CLR; m1: A BR; A I 0.3; = M 100.3;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1;\nA BR; = M 30.0;\nEND_ORGANIZATION_BLOCK\n",
        &["I0.2=1", "MW10=32767"],
        "M30.0",
    ),
    (
        "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.2; JNB m1; L MW 10; L 1; +I; T MW 12; AN OV; SAVE; CLR; m1: A BR;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1;\nA BR; = M 30.0;\nEND_ORGANIZATION_BLOCK\n",
        &["I0.2=1", "MW10=32767"],
        "M30.0",
    ),
    ("NETWORK\nL MW 10; T MW 12; SET; SAVE; CLR; A BR;\nNETWORK\nO I 0.0; = Q 4.0;\n", &["I0.0=0"], "Q4.0"),
];

#[test]
fn no_rewrite_can_be_seen_from_outside() {
    for (source, set, show) in SEEN_FROM_OUTSIDE {
        let folder = Folder::with(&[("main.awl", source)]);
        for to in ["lad", "fbd"] {
            let drawn = folder.run(&["convert", "main.awl", "--to", to, "--rewrite"]);
            assert_eq!(drawn.code, Some(0), "{}", drawn.stderr);
            folder.write("drawn.awl", drawn.stdout.as_bytes());
            let result = |name: &str| {
                let mut arguments = vec!["exec", name, "--show", show];
                set.iter().for_each(|value| arguments.extend(["--set", value]));
                folder.run(&arguments).stdout
            };
            assert_eq!(result("drawn.awl"), result("main.awl"), "{source}\n{}", drawn.stdout);
        }
    }
}

#[test]
fn a_label_that_looks_like_an_address_stays_a_label() {
    let folder =
        Folder::with(&[("x.lad", "NETWORK\n    NO  I 0.0\n    JMP  m1\nNETWORK\n    LABEL m1:\n    NO  I 0.1\n    COIL  Q 4.0\n")]);
    let stl = folder.run(&["convert", "x.lad", "--to", "stl"]);
    assert!(stl.stdout.contains("JC    m1;"), "{}", stl.stdout);
}

#[test]
fn a_file_with_another_ending_holds_the_same_program() {
    let bare = "      A     I 0.6;\n      =     Q 4.6;\n";
    let line = "I 0.0 -> = Q 4.0\n\nI 0.3 -> S M 0.0\n";
    let form_a = "OR\n    NO  I 0.0\nOR\n    NO  I 0.1\nEND\nCOIL  Q 4.0\n";
    let mixed = "FUNCTION FC 1 : VOID\nBEGIN\n      A     I 0.7;\n      =     Q 0.7;\nNETWORK\n      L     MW 10;\n      LAR1  ;\nNETWORK FBD\n    I 0.1 -> = Q 4.1\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      CALL  FC 1;\nEND_ORGANIZATION_BLOCK\n";
    let shown = |folder: &Folder, name: &str| {
        let run = folder.run(&["convert", name, "--to", "stl"]);
        assert_eq!(run.code, Some(0), "{name}: {}{}", run.stderr, String::from_utf8_lossy(&folder.read(name)));
        let lines = run.stdout.lines().map(|line| line.split_whitespace().collect::<String>());
        lines.filter(|line| !line.is_empty() && !line.starts_with("NETWORK")).collect::<Vec<_>>().join("\n")
    };
    for (name, source) in [("x.awl", SOURCE), ("x.awl", bare), ("x.awl", mixed), ("x.lad", line), ("x.fbd", line), ("x.lad", form_a)] {
        let folder = Folder::with(&[(name, source)]);
        let before = shown(&folder, name);
        for other in ["y.awl", "y.lad", "y.fbd"] {
            for to in ["lad", "stl"] {
                for block in [None, Some("OB 1")] {
                    let mut arguments = vec!["convert", name, "--to", to, "-o", other];
                    arguments.extend(block.iter().flat_map(|block| ["--block", block]));
                    let run = folder.run(&arguments);
                    assert_eq!(run.code, Some(0), "{arguments:?}: {}", run.stderr);
                    let written = String::from_utf8_lossy(&folder.read(other)).into_owned();
                    assert_eq!(shown(&folder, other), before, "{arguments:?}\n{written}");
                }
            }
        }
    }
    let folder = Folder::with(&[("x.awl", mixed), ("x.lad", "I 0.0 -> = Q 4.0\n")]);
    let german = folder.run(&["convert", "--mnemonics", "de", "x.awl", "-o", "y.lad"]);
    assert_eq!(german.code, Some(0), "{}", german.stderr);
    let written = String::from_utf8(folder.read("y.lad")).expect("it is UTF-8");
    assert!(written.contains("BEGIN\nNETWORK STL\n      U     E 0.7;"), "{written}");
    let structured = folder.run(&["convert", "x.lad", "--to", "fbd", "-o", "y.scl"]);
    assert_eq!(structured.code, Some(2));
    assert!(structured.stderr.contains("would be read as Structured Text"), "{}", structured.stderr);
}

#[test]
fn comments_after_networks_on_one_line_are_kept() {
    let source = "// first\nI 0.0 -> = Q 4.0 // lamp\nI 0.1 -> = Q 4.1\nORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\n    I 0.2 // in\n    -> = Q 4.2 // out\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("x.lad", source)]);
    assert_eq!(folder.run(&["check", "x.lad"]).code, Some(0));
    let formatted = folder.run(&["fmt", "x.lad"]);
    assert_eq!(formatted.code, Some(0), "{}", formatted.stderr);
    folder.write("y.lad", &folder.read("x.lad"));
    for (to, form) in [("lad", "a"), ("fbd", "a"), ("fbd", "b"), ("stl", "a")] {
        let run = folder.run(&["convert", "y.lad", "--to", to, "--form", form]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        for comment in ["// first", "// lamp", "// in", "// out"] {
            assert_eq!(run.stdout.matches(comment).count(), 1, "{to} {form} {comment}: {}", run.stdout);
        }
    }
}

#[test]
fn statements_in_a_file_of_diagrams_are_named() {
    for source in ["A I 0.0;\n= Q 4.0;\n", "NETWORK\nm1: L MW 0; // a\nT MW 2;\n", "NETWORK LAD\nA(  ;\nO I 0.0;\n) ;\n= Q 4.0;\n"] {
        let folder = Folder::with(&[("x.lad", source)]);
        let run = folder.run(&["check", "x.lad"]);
        assert_eq!(run.code, Some(3), "{source}");
        assert!(run.stderr.contains("statements of STL stand here") && run.stderr.contains("NETWORK STL"), "{}", run.stderr);
        assert!(run.stderr.contains("1 error."), "{}", run.stderr);
    }
}

#[test]
fn comments_of_pins_stay_at_their_pins() {
    let source = "\
NETWORK LAD
    NO  I 0.0  // start
    S_ODT T 5  // delay
        TV := S5T#2S  // two seconds
        // resets
        R:  // at R
            NO  I 0.7  // stop
        BI => MW 20  // rest
    COIL  Q 4.0  // lamp
NETWORK LAD
    NO  I 0.1
    CALL SFC 64
        RET_VAL => MD 0  // time
    ADD_I
        IN1 := MW 0  // summand
        IN2 := 1
        OUT => MW 2  // result
NETWORK LAD
    NO  I 0.2
    S_CU C 1
        S:
            NO  I 0.3  // set
        // preset
        PV := C#5
        CV => MW 30  // count
";
    let folder = Folder::with(&[("x.awl", source)]);
    let fbd = folder.run(&["convert", "x.awl", "--to", "fbd"]);
    assert_eq!(fbd.stdout, source.replace("NETWORK LAD", "NETWORK FBD"), "{}", fbd.stderr);
    folder.write("y.awl", fbd.stdout.as_bytes());
    assert_eq!(folder.run(&["convert", "y.awl", "--to", "lad"]).stdout, source);
    let stl = folder.run(&["convert", "x.awl", "--to", "stl"]).stdout;
    let comments: Vec<&str> = source.lines().filter_map(|line| line.split_once("// ").map(|(_, comment)| comment)).collect();
    for comment in &comments {
        assert_eq!(stl.matches(&format!("// {comment}")).count(), 1, "{comment}: {stl}");
    }
    assert!(stl.contains("CALL  SFC 64 ("), "{stl}");
}

#[test]
fn a_second_use_of_an_edge_memory_or_a_counter_is_told_with_the_first() {
    let block = |second: &str| {
        format!(
            "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK LAD\n    NO I 0.0\n    P M 1.0\n    S_CU C 1\n    COIL Q 4.0\nNETWORK LAD\n    NO I 0.1\n{second}\n    COIL Q 4.1\nEND_ORGANIZATION_BLOCK\n"
        )
    };
    let said = |second: &str| Folder::with(&[("main.awl", &block(second))]).run(&["check", "main.awl"]).stderr;
    for second in ["    N M1.0", "    POS I 0.2, M 1.0", "    OR\n        POS I 0.2, M 1.0\n    OR\n        NO I 0.3\n    END"] {
        let said = said(second);
        assert!(
            said.contains("[P2443]") && said.contains("LAD network 2: a second edge keeps its line in `M1.0`, first used in network 1"),
            "{said}"
        );
    }
    let again = said("    S_CU C 1");
    assert!(again.contains("LAD network 2: a second box S_CU counts with `C1`, first used in network 1"), "{again}");
    // The other direction has an edge of its own.
    for second in ["    S_CD C 1", "    P M 1.1", "    NO M 1.0"] {
        assert!(!said(second).contains("P2443"), "{}", said(second));
    }
}
