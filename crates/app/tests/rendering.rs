//! `sieben render` and `sieben exec --status`: networks as pictures, and what is said where there is none.

mod command;

use std::path::Path;
use std::process::Command;

use command::{Folder, sieben};

const PUMP: &str = "\
FUNCTION FC 1 : VOID
TITLE = Pump
BEGIN
NETWORK
TITLE = <Start> & stop
      A(    ;
      O     I 0.0;
      O     Q 4.0;
      )     ;
      AN    I 0.1;
      =     Q 4.0;
NETWORK
      A     I 0.2;
      JNB   _001;
      L     MW 10;
      T     MW 12;
_001: NOP   0;
NETWORK
      A     I 0.3;
      =     Q 4.1;
      A     I 0.4;
      =     Q 4.2;
END_FUNCTION

ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      A     I 0.7;
      JNB   _001;
      CALL  FC 1;
_001: NOP   0;
END_ORGANIZATION_BLOCK
";

const SYMBOLS: &str = "symbol,address,type,comment\nStart,I 0.0,BOOL,the green button\nPump,Q 4.0,BOOL,\nFilling,FC 1,FC 1,\n";

fn pump() -> Folder {
    Folder::with(&[("pump.awl", PUMP), ("symbols.csv", SYMBOLS)])
}

#[test]
fn a_network_that_stays_stl_says_which_statement_is_in_the_way() {
    let shown = pump().run(&["render", ".", "--block", "Filling", "--network", "3"]);
    assert_eq!(shown.code, Some(0), "{}", shown.stderr);
    let wanted = "\
FC 1 (Filling): Pump

Network 3
      A     I 0.3;
      =     Q 4.1;
      A     I 0.4;
      =     Q 4.2;
Stays STL: `A I 0.4` (line 21), R-TWO: a second string of logic begins here, and one network of a diagram holds one; split into 2 networks here
";
    assert_eq!(shown.stdout, wanted);
}

#[test]
fn a_page_has_titles_symbols_and_where_they_are_used() {
    let folder = pump();
    let run = folder.run(&["render", ".", "--block", "FC1", "-o", "pump.html"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let page = String::from_utf8(folder.read("pump.html")).unwrap();
    for wanted in [
        "<h1>FC 1 &quot;Filling&quot;: Pump</h1>",
        "<h2>Network 1: &lt;Start&gt; &amp; stop</h2>",
        "data-element=\"contact-7\"",
        "<td>I 0.0</td><td>Start</td><td>BOOL</td><td>the green button</td><td>FC\u{a0}1/1\u{a0}R</td>",
        "<td>Q 4.0</td><td>Pump</td>",
        "size:A4",
        "<p class=\"reason\">Stays STL:",
    ] {
        assert!(page.contains(wanted), "{wanted} in {page}");
    }
    assert!(!page.contains("<script") && !page.contains(" style="), "{page}");
}

#[test]
fn a_picture_has_all_networks_under_one_another() {
    let folder = pump();
    let run = folder.run(&["render", ".", "-o", "all.svg", "--as", "fbd"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let picture = String::from_utf8(folder.read("all.svg")).unwrap();
    assert_eq!(picture.matches("<svg").count(), 5, "one around four networks: {picture}");
    assert_eq!(picture.matches("<style>").count(), 1);
    assert!(picture.contains("Stays STL:"), "{picture}");
}

#[test]
fn json_has_an_object_for_each_network() {
    let run = pump().run(&["render", ".", "--json"]);
    let objects: Vec<serde_json::Value> = run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let short: Vec<(&str, u64, &str)> =
        objects.iter().map(|one| (one["block"].as_str().unwrap(), one["network"].as_u64().unwrap(), one["as"].as_str().unwrap())).collect();
    assert_eq!(short, [("OB 1", 1, "lad"), ("FC 1", 1, "lad"), ("FC 1", 2, "lad"), ("FC 1", 3, "stl")]);
    assert!(objects[3]["reason"].as_str().unwrap().starts_with("Stays STL:"));
    assert_eq!(objects[1]["title"], "<Start> & stop");
}

#[test]
fn what_is_not_there_is_answered_with_what_is() {
    let folder = pump();
    for (arguments, wanted) in [
        (&["render", ".", "--block", "FC 9"][..], &["[P7003]", "FC 1", "OB 1"][..]),
        (&["render", ".", "--block", "FC1", "--network", "4"], &["[P7082]", "FC 1 has no network 4; it has networks 1 to 3"]),
        (&["render", ".", "-o", "x.pdf"], &["[P7081]", "`.svg`, `.html` and `.txt`"]),
        (&["render", ".", "-o", "x"], &["[P7081]", "has no ending"]),
        (&["render", ".", "-o", "nowhere/x.svg"], &["[P6013]", "cannot be written"]),
        (&["render", ".", "-o", "pump.awl"], &["[P7081]"]),
        (&["exec", ".", "--status", "x.svg", "--network", "FC1"], &["[P7082]", "`FC1/2`"]),
        (&["exec", ".", "--status", "x.svg", "--network", "FC1/9"], &["[P7082]", "1 to 3"]),
        (&["exec", ".", "--status", "x.svg", "--network", "FC1/3"], &["[P7083]", "Stays STL"]),
    ] {
        let run = folder.run(arguments);
        assert_eq!(run.code, Some(2), "{arguments:?}: {}{}", run.stdout, run.stderr);
        for wanted in wanted {
            assert!(run.stderr.contains(wanted), "{arguments:?}: {wanted} in {}", run.stderr);
        }
    }
    assert!(!folder.path().join("x.svg").exists());
}

#[test]
fn the_status_is_that_of_the_last_scan() {
    let folder = pump();
    let status = |more: &[&str]| {
        let mut arguments = vec!["exec", ".", "--status", "-", "--network"];
        arguments.extend(more);
        let run = folder.run(&arguments);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        run.stdout
    };
    let held = "\
│ I 0.0   I 0.1   Q 4.0
├══┤ ├══┬══┤/├═════( )══┤
│   0   ║   0       1
│ Q 4.0 ║
├══┤ ├══┘
    1
";
    // The contact of the button carries nothing; its branch does, and the pump holds itself.
    let held = held.replacen("├══┤ ├══┬", "├══┤ ├┄┄┬", 1);
    assert_eq!(status(&["FC1/1", "--set", "I0.7=1", "--at", "0ms", "I0.0=1", "--at", "20ms", "I0.0=0", "--scans", "4"]), held);
    let skipped = "\
│ I 0.0   I 0.1   Q 4.0
├··┤ ├··┬··┤/├·····( )··┤
│   –   ·   –       –
│ Q 4.0 ·
├··┤ ├··┘
    –
";
    assert_eq!(status(&["FC1/1"]), skipped);
    // Called in the first scan, not in the last one.
    assert_eq!(status(&["FC1/1", "--at", "0ms", "I0.7=1", "--at", "10ms", "I0.7=0", "--scans", "3"]), skipped);
}

/// A zone of the master control relay that is off, and SAVE in a branch.
const TAPPED: &str = "\
NETWORK LAD
    MCRA
NETWORK LAD
    NO    I 0.7
    MCR<
NETWORK LAD
    NO    I 0.0
    BRANCH
        COIL  Q 4.0
    BRANCH
        NO    I 0.1
        MID   M 0.0
        NO    I 0.1
        COIL  Q 4.1
    END
NETWORK LAD
    MCR>
NETWORK LAD
    NO    I 0.0
    BRANCH
        NO    I 0.6
        SAVE
    BRANCH
        NO    I 0.1
        COIL  Q 5.0
    BRANCH
        NO    I 0.1
        COIL  Q 5.1
    END
";

#[test]
fn lines_after_a_tap_carry_what_is_read_there() {
    let folder = Folder::with(&[("main.lad", TAPPED)]);
    let status = |network: &str| {
        let run = folder.run(&["exec", ".", "--set", "I0.0=1", "--set", "I0.1=1", "--status", "-", "--network", network]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        run.stdout
    };
    let off = "\
│ I 0.0                           Q 4.0
├══┤ ├══┬┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄( )┄┄┤
    1   ║                           0
        ║ I 0.1   M 0.0   I 0.1   Q 4.1
        └┄┄┤ ├┄┄┄┄┄(#)┄┄┄┄┄┤ ├┄┄┄┄┄( )┄┄┤
            1       0       1       0
";
    assert_eq!(status("OB1/3"), off);
    let saved = "\
│ I 0.0   I 0.6
├══┤ ├══┬══┤ ├┄┄┄┄┄(SAVE)┄┄┤
    1   ║   0
        ║ I 0.1    Q 5.0
        ├┄┄┤ ├┄┄┄┄┄┄( )┄┄┄┄┤
        ║   1        0
        ║ I 0.1    Q 5.1
        └══┤ ├══════( )════┤
            1        1
";
    assert_eq!(status("OB1/5"), saved);
}

#[test]
fn the_picture_in_the_documentation_is_what_the_tool_draws() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/how-to");
    let page = std::fs::read_to_string(root.join("diagrams.md")).unwrap();
    let source = page.split("```stl pump.awl\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let folder = Folder::with(&[("pump.awl", source)]);
    let run = folder.run(&["exec", "pump.awl", "--set", "I0.0=1", "--set", "MW10=7", "--status", "power-flow.svg", "--network", "FC1/2"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let drawn = String::from_utf8(folder.read("power-flow.svg")).unwrap();
    let stored = std::fs::read_to_string(root.join("diagrams/power-flow.svg")).unwrap_or_default();
    assert!(drawn == stored, "docs/how-to/diagrams/power-flow.svg is stale; it is now\n{drawn}");
}

#[test]
fn git_compares_the_diagrams() {
    let folder = Folder::with(&[("pump.awl", PUMP), (".gitattributes", "*.awl diff=sieben\n")]);
    let binary = sieben(folder.path(), &[]).get_program().to_string_lossy().into_owned();
    let git = |arguments: &[&str]| {
        let run = Command::new("git")
            .args(["-c", "user.name=x", "-c", "user.email=x@example.org"])
            .args(arguments)
            .current_dir(folder.path())
            .env("NO_COLOR", "1")
            .env("GIT_CONFIG_GLOBAL", "/dev/null")
            .env("GIT_CONFIG_NOSYSTEM", "1")
            .output()
            .expect("git is there");
        assert!(run.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&run.stderr));
        String::from_utf8_lossy(&run.stdout).into_owned()
    };
    git(&["init", "-q"]);
    git(&["config", "diff.sieben.textconv", &format!("'{binary}' render --as lad --or-source")]);
    git(&["add", "."]);
    git(&["commit", "-q", "-m", "one"]);
    folder.write("pump.awl", PUMP.replacen("AN    I 0.1", "A     I 0.1", 1).as_bytes());
    let diff = git(&["diff"]);
    assert!(diff.contains("-├──┤ ├──┬──┤/├─────( )──┤\n+├──┤ ├──┬──┤ ├─────( )──┤"), "{diff}");
    // What does not compile is compared as it is.
    folder.write("pump.awl", PUMP.replacen("AN    I 0.1", "AN    \"Unknown\"", 1).as_bytes());
    let diff = git(&["diff"]);
    assert!(diff.contains("+      AN    \"Unknown\";"), "{diff}");
}

const BODY: &str = "\
FUNCTION_BLOCK Pump
  VAR_INPUT
    start, stop : BOOL;
  END_VAR
  VAR_OUTPUT
    running, warning : BOOL;
  END_VAR
  VAR
    late : TON;
  END_VAR
  LD
  NETWORK
  TITLE = Runs for too long
      NO    start
      NC    stop
      TON late
          PT := T#10m
      COIL  warning
END_FUNCTION_BLOCK
";

#[test]
fn a_body_of_structured_text_that_is_a_diagram_is_drawn() {
    let folder = Folder::with(&[("pump.st", BODY)]);
    let run = folder.run(&["render", "pump.st", "--block", "Pump"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let wanted = "\
Pump

Network 1: Runs for too long
│                       late
│ start   stop         ┌─TON─┐    warning
├──┤ ├─────┤/├─────────┤IN  Q├──────( )───┤
                  T#10m┤PT   │
                       └─────┘
";
    assert_eq!(run.stdout, wanted);
    let run = folder.run(&["render", "pump.st", "-o", "pump.svg", "--as", "fbd"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let picture = String::from_utf8(folder.read("pump.svg")).unwrap();
    for wanted in ["data-element=\"contact-14\"", "data-element=\"contact-15\"", "data-element=\"box-16\"", "data-element=\"coil-18\""] {
        assert!(picture.contains(wanted), "{wanted} in {picture}");
    }
    let run = folder.run(&["exec", "pump.st", "--status", "x.svg", "--network", "Pump/1"]);
    assert!(run.code == Some(2) && run.stderr.contains("[P7083]"), "{}", run.stderr);
}

const MEMBERS: &str = "\
FUNCTION_BLOCK Pump
  VAR_INPUT
    a, b : INT;
  END_VAR
  VAR_OUTPUT
    c : INT;
    run : BOOL;
  END_VAR
  METHOD PUBLIC Go : BOOL
    VAR_INPUT x : BOOL; END_VAR
    LD
    NETWORK
        NO    x
        COIL  Go
  END_METHOD
  LD
  NETWORK
      NO run
      ADD a, b => c
  NETWORK
      GT c, b
      COIL run
END_FUNCTION_BLOCK

PROGRAM Main
  VAR
    pump : Pump;
  END_VAR
  LD
  NETWORK
      Pump pump
          a := 5
END_PROGRAM
";

#[test]
fn programs_and_methods_are_drawn_under_their_own_names_with_all_pins() {
    let folder = Folder::with(&[("pump.st", MEMBERS)]);
    let run = folder.run(&["render", "pump.st"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let wanted = "\
Pump.Go

Network 1
│   x      Go
├──┤ ├─────( )──┤

Pump

Network 1
│  run     ┌──ADD──┐
├──┤ ├─────┤EN  ENO├
          a┤IN1 OUT├ c
          b┤IN2    │
           └───────┘

Network 2
│  ┌──GT───┐     run
├──┤EN  OUT├─────( )──┤
  c┤IN1    │
  b┤IN2    │
   └───────┘

Main

Network 1
│    pump
│  ┌─Pump─┐
├──┤EN ENO├
  5┤a     │
   └──────┘
";
    assert_eq!(run.stdout, wanted);
    let json = folder.run(&["render", "pump.st", "--json"]).stdout;
    let blocks: Vec<serde_json::Value> =
        json.lines().map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap()["block"].take()).collect();
    assert_eq!(blocks, ["Pump.Go", "Pump", "Pump", "Main"]);
    let run = folder.run(&["render", "pump.st", "--block", "pump.go", "--network", "2"]);
    assert_eq!(run.code, Some(2), "{}", run.stdout);
    assert!(run.stderr.contains("[P7082] Error: Pump.Go has no network 2; it has one, network 1"), "{}", run.stderr);
    let run = folder.run(&["render", "pump.st", "--block", "Tank"]);
    assert!(run.stderr.contains("It has OB 1, Pump.Go, Pump, Main"), "{}", run.stderr);
}
