//! `sieben step` as its users call it: what the page about it does not show.

mod command;

use command::{Folder, Run};

const COUNTER: &str = "FUNCTION FC 1 : VOID\nBEGIN\nL MW 10\n+ 1\nT MW 10\nEND_FUNCTION\n\
    ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0\n= Q 4.0\nNETWORK\nUC FC 1\nL MW 10\nL 3\n>=I\nS M 0.0\nEND_ORGANIZATION_BLOCK\n";

fn step(source: &str, commands: &str, arguments: &[&str]) -> (Folder, Run) {
    let folder = Folder::with(&[("main.awl", source), ("steps.txt", commands)]);
    let run = folder.run(&[&["step", "main.awl", "--commands", "steps.txt"], arguments].concat());
    (folder, run)
}

/// The value of a key in every object that was printed; text keeps its quotes.
fn values<'a>(run: &'a Run, key: &str) -> Vec<&'a str> {
    let key = format!("\"{key}\":");
    let value = |line: &'a str| {
        let rest = &line[line.find(&key)? + key.len()..];
        Some(&rest[..rest.find([',', '}'])?])
    };
    run.stdout.lines().filter_map(value).collect()
}

#[test]
fn every_step_forwards_has_its_step_back() {
    for (on, back) in [("step 7", "back 7"), ("over 4", "back 4"), ("scan", "back scan"), ("run 40", "goto 5")] {
        let (_folder, run) = step(COUNTER, &format!("step 5\n{on}\n{back}\n"), &["--json"]);
        let positions = values(&run, "position");
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        assert_eq!(positions.len(), 3, "{}", run.stdout);
        match on {
            // A scan's beginning lies before the five statements.
            "scan" => assert_eq!(positions[2], "0"),
            "over 4" => assert!(positions[1].parse::<u64>().expect("a number") > 8),
            _ => assert_eq!(positions[2], "5"),
        }
    }
}

#[test]
fn a_breakpoint_with_a_condition_and_a_count_waits_for_both() {
    let commands = "break FC1:2 if MW10 > 1 every 2\nrun\nprint MW10\nrun\nprint MW10\nrun back\nprint MW10\n";
    let (_folder, run) = step(COUNTER, commands, &[]);
    // With MW 10 at 2, 3, 4, 5 it happens; every second time is 3 and 5. Backwards every time counts.
    let printed: Vec<&str> = run.stdout.lines().filter(|line| line.contains("MW10 =")).collect();
    assert_eq!(printed, ["  MW10 = 16#0003 (3)", "  MW10 = 16#0005 (5)", "  MW10 = 16#0004 (4)"], "{}", run.stdout);
}

#[test]
fn the_last_change_is_found_wherever_it_comes_from() {
    let commands = "scan 2\nset I0.0=1\nset MW 20=7\nscan 2\nwho Q4.0\nwho I0.0\nwho MW20\nwho MW 22\n";
    let (_folder, run) = step(COUNTER, commands, &[]);
    assert!(run.stdout.contains("by main.awl:11: = Q 4.0 (OB 1)"), "{}", run.stdout);
    assert_eq!(run.stdout.matches("by no statement").count(), 2, "{}", run.stdout);
    assert!(run.stdout.contains("nothing has changed `MW 22` since the beginning"), "{}", run.stdout);
}

#[test]
fn of_a_value_that_stays_the_statement_that_wrote_it_last_is_told() {
    let (_folder, run) = step(COUNTER, "scan 2\nwho Q4.0\nwho Q4.1\nprint MW10\n", &[]);
    assert!(
        run.stdout.contains("nothing has changed `Q4.0` since the beginning\n  main.awl:11: = Q 4.0 (OB 1) wrote it last,"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains(" in scan 1: the RLO is 0, so Q 4.0 becomes 0"), "{}", run.stdout);
    assert!(run.stdout.contains("nothing has changed `Q4.1` since the beginning\n>"), "{}", run.stdout);
    assert!(run.stdout.contains("MW10 = 16#0002 (2)"), "the run stands where it stood: {}", run.stdout);
    let (_folder, run) = step(COUNTER, "scan 2\nwho Q4.0\n", &["--json", "--lang", "de"]);
    assert!(run.stdout.contains("\"who\":null,\"written\":{\"name\":\"Q4.0\""), "{}", run.stdout);
    assert!(run.stdout.contains("das VKE ist 0"), "{}", run.stdout);
    let (_folder, run) = step(COUNTER, "scan\n", &["--lang", "de"]);
    assert!(run.stdout.contains("Ende des Bausteins"), "{}", run.stdout);
}

#[test]
fn scans_have_the_numbers_that_exec_gives_them() {
    let (folder, run) = step(COUNTER, "where\nstep\nscan\nstep\nwho MW10\n", &["--json"]);
    assert_eq!(values(&run, "scan")[..4], ["null", "0", "0", "1"], "{}", run.stdout);
    assert!(run.stdout.contains("\"scan\":0,\"before\":\"16#0000 (0)\""), "{}", run.stdout);
    let exec = folder.run(&["exec", "main.awl", "--scans", "2", "--every", "--json", "--show", "MW10"]);
    assert_eq!(values(&exec, "scan"), ["0", "1"], "{}", exec.stdout);
}

#[test]
fn a_loop_without_an_end_can_be_stepped_and_left() {
    let source = "ORGANIZATION_BLOCK OB 1\nBEGIN\nL 0\nnext: + 1\nT MW 4\nJU next\nEND_ORGANIZATION_BLOCK\n";
    let commands = "step 10\nrun\nback 999999\nback over\nscan\ngoto 1\n";
    let (_folder, run) = step(source, commands, &["--json"]);
    assert_eq!(values(&run, "position"), ["10", "1000010", "11", "10", "1000010", "1"], "{}", run.stdout);
    assert_eq!(values(&run, "halt"), ["\"reached\"", "\"limit\"", "\"reached\"", "\"reached\"", "\"limit\"", "\"reached\""]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}

#[test]
fn a_command_with_a_number_beyond_all_measure_ends_and_says_so() {
    let empty = "FUNCTION FC 1 : VOID\nBEGIN\nL 1\nEND_FUNCTION\n";
    for (source, commands, halts) in [
        (COUNTER, "over 1000000000000\nback over 1000000000000\n", ["\"limit\"", "\"beginning\""]),
        (COUNTER, "step 1000000000000\nback 1000000000000\n", ["\"limit\"", "\"beginning\""]),
        // Nothing runs in the cycle: scans without a statement.
        (empty, "network 1000000000000\nscan 1000000000000\n", ["\"limit\"", "\"limit\""]),
    ] {
        let (_folder, run) = step(source, commands, &["--json"]);
        assert_eq!(values(&run, "halt"), halts, "{commands}{}", run.stdout);
    }
}

#[test]
fn a_stop_is_told_and_can_be_gone_back_from() {
    let source = "ORGANIZATION_BLOCK OB 1\nBEGIN\nL 7\nT MW 0\nOPN DB [MW 0]\nT MW 2\nEND_ORGANIZATION_BLOCK\n";
    let (_folder, run) = step(source, "run\nback 2\nprint MW0\nrun\n", &[]);
    assert_eq!(run.code, Some(4), "{}", run.stderr);
    assert_eq!(run.stdout.matches("went to STOP").count(), 2, "{}", run.stdout);
    assert!(run.stdout.contains("MW0 = 16#0000 (0)"), "{}", run.stdout);
}

#[test]
fn what_is_no_command_changes_nothing_and_is_told() {
    let wrong = [
        ("stpe", "P7040"),
        ("step x", "P7040"),
        ("step 0", "P7040"),
        ("back -1", "P7040"),
        ("goto", "P7040"),
        ("goto x", "P7040"),
        ("quit now", "P7040"),
        ("delete 9", "P7040"),
        ("break FC9:1", "P7041"),
        ("break FC1:99", "P7041"),
        ("to main.awl:999", "P7041"),
        ("break FC1:0", "P7041"),
        ("break FC1:2 if MW10", "P7042"),
        ("break MW10 > x", "P7042"),
        ("break I0.9 = 1", "P7042"),
        ("print MW99999", "P7003"),
        ("who nobody", "P7003"),
        ("set MW10", "P7003"),
        ("set MW10=99999999", "P7004"),
    ];
    let commands: String = wrong.iter().map(|(command, _)| format!("{command}\n")).collect();
    let (_folder, run) = step(COUNTER, &format!("step 2\n{commands}where\n"), &["--json"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    let codes: Vec<String> = values(&run, "code").iter().map(|code| code.trim_matches('"').to_owned()).collect();
    assert_eq!(codes, wrong.map(|(_, code)| code.to_owned()), "{}", run.stdout);
    assert_eq!(values(&run, "position"), ["2", "2"]);
}

#[test]
fn a_line_without_a_statement_means_the_next_one() {
    let (_folder, run) = step(COUNTER, "break main.awl:9\nrun\n", &[]);
    assert!(run.stdout.contains("no statement stands there; pauses before main.awl:10: A I 0.0"), "{}", run.stdout);
    assert!(run.stdout.contains("next: main.awl:10: A I 0.0"), "{}", run.stdout);
}

#[test]
fn a_recording_is_the_same_run_and_belongs_to_its_program() {
    let commands = "scan 3\ngoto 20\nset I0.0=1\nscan 2\nstep 3\n";
    let (folder, run) = step(COUNTER, commands, &["--record", "run.rec", "--json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let last = run.stdout.lines().last().expect("a line").to_owned();
    folder.write("where.txt", b"where\n");
    let again = folder.run(&["step", "main.awl", "--replay", "run.rec", "--commands", "where.txt", "--json"]);
    let same = |text: &str| text[text.find("\"position\"").expect("a position")..text.find("\"halt\"").expect("a halt")].to_owned();
    assert_eq!(same(&again.stdout), same(&last), "{}", again.stderr);
    folder.write("main.awl", COUNTER.replace("+ 1", "+ 2").as_bytes());
    let other = folder.run(&["step", "main.awl", "--replay", "run.rec", "--commands", "where.txt"]);
    assert!(other.code == Some(2) && other.stderr.contains("P7043"), "{}", other.stderr);
}

#[test]
fn a_damaged_recording_is_told() {
    let (folder, _) = step(COUNTER, "scan 3\nset MW 4=1\nscan\n", &["--record", "run.rec"]);
    let sound = String::from_utf8(folder.read("run.rec")).expect("a recording is text");
    let damages = [
        sound.replace("end ", "end 1"),
        sound.replace("end ", "ende "),
        sound.replace("set MW 4", "set MW 999999"),
        sound.replace("restart warm", "restart soon"),
        sound.replace("scan 0", "scan"),
        sound.replace(" 3\n", " 99999999999\n"),
        sound.lines().take(3).map(|line| format!("{line}\n")).collect(),
        String::new(),
    ];
    for damage in damages {
        assert_ne!(damage, sound);
        folder.write("bad.rec", damage.as_bytes());
        let run = folder.run(&["step", "main.awl", "--replay", "bad.rec", "--commands", "steps.txt"]);
        assert!(run.code == Some(2) && run.stderr.contains("P7044"), "{damage}{}", run.stderr);
    }
}

#[test]
fn a_value_that_a_call_delivers_is_the_work_of_the_calling_statement() {
    let source = "FUNCTION Twice : INT\nVAR_INPUT a : INT; END_VAR\nTwice := a * 2;\nEND_FUNCTION\n\
        PROGRAM Main\nVAR n : INT := 1; END_VAR\nn := Twice(n);\nEND_PROGRAM\n";
    let folder = Folder::with(&[("main.st", source), ("steps.txt", "scan 3\nwho n\n")]);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt"]);
    assert!(run.stdout.contains("n: 4 -> 8") && run.stdout.contains("by main.st:7: n := Twice(n)"), "{}{}", run.stdout, run.stderr);
}

#[test]
fn plants_of_the_project_run_and_fail_and_a_recording_knows_how() {
    let folder = Folder::with(&[
        ("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nSET\n= Q 0.0\nL IW 2\nT MW 10\nA I 0.1\n= Q 4.1\nEND_ORGANIZATION_BLOCK\n"),
        ("sieben.toml", "[project]\nname = \"tank\"\n[[module]]\nkind = \"tank\"\nname = \"tank\"\nlevel = 20\nwaves = 0\n"),
        ("steps.txt", "scan 6000\nprint Q4.1\nprint MW10\n"),
        ("nothing.txt", "print Q4.1\n"),
    ]);
    let step = |arguments: &[&str]| folder.run(&[&["step", ".", "--commands", "steps.txt"], arguments].concat());
    step(&[]).code(0).stdout("Q4.1 = 1");
    let fault = ["--fault", "tank.high stuck=0"];
    step(&[&fault[..], &["--record", "run.txt"]].concat()).code(0).stdout("Q4.1 = 0");
    let replay = ["step", ".", "--commands", "nothing.txt", "--replay", "run.txt"];
    folder.run(&[&replay[..], &fault].concat()).code(0).stdout("Q4.1 = 0");
    folder.run(&replay).code(2).stderr("P7043");
    step(&["--fault", "tank.hihg stuck=0"]).code(2).stderr("P6272");
}

/// Every kind of variable that a block can have.
const VARIABLES: &str = "FUNCTION_BLOCK FB 5\nVAR_INPUT\n raw : INT;\nEND_VAR\nVAR_IN_OUT\n s : STRUCT k : INT; END_STRUCT;\nEND_VAR\n\
    VAR\n count : INT;\n list : ARRAY[1..3] OF INT;\nEND_VAR\nVAR_TEMP\n i : INT;\n r : REAL;\nEND_VAR\nBEGIN\n\
    L #raw\nT #i\nL #count\n+ 1\nT #count\nL #raw\nT #list[2]\nL 1.5\nT #r\nL 9\nT #s.k\nEND_FUNCTION_BLOCK\n\
    DATA_BLOCK DB 7 FB 5\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 8 FB 5\nBEGIN\nEND_DATA_BLOCK\n\
    DATA_BLOCK DB 3\nSTRUCT\n p : STRUCT k : INT; END_STRUCT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n\
    FUNCTION FC 1 : INT\nVAR_INPUT\n a : INT;\n q : TIMER;\nEND_VAR\nVAR_IN_OUT\n x : INT;\nEND_VAR\nBEGIN\n\
    L #a\nL #x\n+I\nT #x\nT #RET_VAL\nA #q\n= M 5.0\nEND_FUNCTION\n\
    ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY[1..20] OF BYTE;\n r : INT;\nEND_VAR\nBEGIN\n\
    CALL FB 5, DB 7 (raw := 17, s := DB3.p);\nCALL FB 5, DB 8 (raw := 18, s := DB3.p);\n\
    CALL FC 1 (a := 3, q := T 2, x := MW 30, RET_VAL := #r);\nEND_ORGANIZATION_BLOCK\n";

#[test]
fn every_variable_of_a_block_has_its_name_and_its_value() {
    let commands = "to FB5:11\nstep\nprint #raw, #i, #count, #list[2], #r, #s.k\nlocals\nto FC1:6\nlocals\nset #x=77\nprint MW30\nback out\nprint FC 1.#a\n";
    let (_folder, run) = step(VARIABLES, commands, &[]);
    assert!(run.stdout.contains("  #raw = 17\n  #i = 17\n  #count = 1\n  #list[2] = 17\n  #r = 1.5\n  #s.k = 9\n"), "{}", run.stdout);
    for line in [
        "variables of FB 5",
        "    IN      #raw      INT   17",
        "    IN_OUT  #s.k      INT   9",
        "    STAT    #list[2]  INT   17",
        "    TEMP    #r        REAL  1.5",
        "    IN      #q        TIMER  T 2",
        "    IN_OUT  #x        INT    3",
        "    RETURN  #RET_VAL  INT    3",
        "  MW30 = 16#004D (77)",
        "  FC 1.#a = no value here: FC 1 is not the block that runs",
    ] {
        assert!(run.stdout.contains(line), "`{line}` is missing in\n{}", run.stdout);
    }
}

#[test]
fn a_variable_of_an_instance_is_watched_in_this_instance_alone() {
    let commands = "step 2\nwatch #count\nrun\nrun\nwho #count\nbreak FC1:2 if #a = 3\nrun\nprint #a\n";
    let (_folder, run) = step(VARIABLES, commands, &[]);
    assert_eq!(run.stdout.matches("breakpoint 1: #count: 0 -> 1").count(), 1, "{}", run.stdout);
    // The next change of it is a scan later: the other instance is none of it.
    assert!(run.stdout.contains("breakpoint 1: #count: 1 -> 2"), "{}", run.stdout);
    assert!(run.stdout.contains("  #a = 3\n"), "{}", run.stdout);
    let (_folder, elsewhere) = step(VARIABLES, "step\nwatch FB5.#count\nwatch FB 5.#nope\nprint #raw2\n", &[]);
    assert_eq!(elsewhere.code, Some(2));
    for message in ["`FB 5` has no `#nope`; its variables begin with `#raw`", "`FB 5` has no `#raw2`", "Did you mean `#raw`?"] {
        assert!(elsewhere.stderr.contains(message), "{}", elsewhere.stderr);
    }
    let (_folder, before) = step(VARIABLES, "watch FB5.#count\nprint #raw\n", &[]);
    assert!(before.stderr.contains("`FB5.#count` lies in an instance, and `FB 5` is not the block that runs"), "{}", before.stderr);
    assert!(before.stderr.contains("`#raw` is a variable of a block, and here is none"), "{}", before.stderr);
}

#[test]
fn a_variable_that_was_set_is_set_again_by_a_recording() {
    let folder =
        Folder::with(&[("main.awl", VARIABLES), ("steps.txt", "to FB5:2\nset #raw=5\nset LW 0=6\nto FB5:8\nprint #list[2], #i\n")]);
    let run = folder.run(&["step", "main.awl", "--commands", "steps.txt", "--record", "run.rec"]);
    assert!(run.stdout.ends_with("  #list[2] = 5\n  #i = 17\n"), "{}", run.stdout);
    folder.write("steps.txt", b"print #list[2], #i\n");
    let again = folder.run(&["step", "main.awl", "--commands", "steps.txt", "--replay", "run.rec"]);
    assert!(again.stdout.ends_with("  #list[2] = 5\n  #i = 17\n"), "{}{}", again.stdout, again.stderr);
}

#[test]
fn variables_of_structured_text_are_called_as_they_are_written() {
    let source = "FUNCTION Scale : INT\nVAR_INPUT raw : INT; END_VAR\nVAR_OUTPUT over : BOOL; END_VAR\nVAR t : INT; END_VAR\n\
        t := raw * 30 + raw;\nIF t > 100 THEN t := 100; over := TRUE; END_IF;\nScale := t;\nEND_FUNCTION\n\
        PROGRAM Main\nVAR x : INT := 5; y : INT; o : BOOL; END_VAR\ny := Scale(raw := x, over => o);\nEND_PROGRAM\n";
    let folder = Folder::with(&[
        ("main.st", source),
        ("steps.txt", "break t > 100\nto Scale:1\nbreak t > 100\nrun\nprint raw, t, over, #t\nlocals\n"),
    ]);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt"]);
    assert!(run.stdout.contains("  raw = 5\n  t = 155\n  over = 0\n  #t = 155\n"), "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("t: 0 -> 155"), "{}", run.stdout);
}

#[test]
fn a_write_of_the_same_value_is_found_there_and_back() {
    let source = "ORGANIZATION_BLOCK OB 1\nBEGIN\nA I 0.0\n= Q 4.0\nS Q 4.1\nLAR1 P#M 20.0\nL 0\nT W[AR1,P#0.0]\nT MB 31\n\
        CALL SFC 20 (SRCBLK := P#M 0.0 BYTE 4, RET_VAL := MW 90, DSTBLK := P#M 50.0 BYTE 4);\nL S5T#1S\nAN I 0.0\nSE T 1\n\
        T PQW 8\nEND_ORGANIZATION_BLOCK\n";
    for (name, place, back) in [
        ("Q4.0", "= Q 4.0", "0 -> 0"),
        ("M21.3", "T W[AR1,P#0.0]", "0 -> 0"),
        ("MW30", "T MB 31", "16#0000 (0) -> 16#0000 (0)"),
        ("MB53", "CALL SFC 20 (", "16#00 (0) -> 16#00 (0)"),
    ] {
        let commands = format!("break write {name}\nscan\nrun back\ngoto 0\nrun\nwho {name}\n");
        let (_folder, run) = step(source, &commands, &[]);
        assert_eq!(run.stdout.matches(&format!("breakpoint 1: write {name}: {back}")).count(), 2, "{name}\n{}", run.stdout);
        assert!(
            run.stdout.contains(&format!(": {place}")) && run.stdout.contains("wrote it last, after statement"),
            "{name}\n{}",
            run.stdout
        );
    }
    // `S` with an RLO of 0 writes nothing, nor does a byte beside the four that are copied.
    for name in ["Q4.1", "MB54", "MB49"] {
        let (_folder, run) = step(source, &format!("break write {name}\nrun 40\nwho {name}\n"), &[]);
        assert!(!run.stdout.contains("breakpoint 1: write"), "{name}\n{}", run.stdout);
        assert!(!run.stdout.contains("wrote it last"), "{name}\n{}", run.stdout);
    }
    // A timer is written by what starts it, not by running on; an input by the process image.
    let (_folder, timer) = step(source, "break write T1\nrun\nrun\n", &[]);
    assert_eq!(timer.stdout.matches("SE T 1\n").count(), 2, "{}", timer.stdout);
    let (_folder, input) = step(source, "break write I0.0\nrun\nset I0.0=1\nrun\nwho I0.0\n", &[]);
    assert_eq!(input.stdout.matches("breakpoint 1: write I0.0").count(), 2, "{}", input.stdout);
    assert!(input.stdout.contains("by no statement: the process image of the inputs was read"), "{}", input.stdout);
    let (_folder, output) = step(source, "break write QW8\nrun\nbreak write RLO\n", &["--json"]);
    assert!(!output.stdout.contains("no breakpoints") && output.stdout.contains("is a register"), "{}", output.stdout);
}

#[test]
fn in_german_every_answer_is_german() {
    let commands = "step 2\nbreak write Q4.0\nwatch MW10\nrun\nrun\nbreakpoints\nlocals\nwho MW10\nwho Q4.0\nwalk\nto FC1:9\nbreak MW10\n\
        delete 7\nset I0.0=1\nscan 2\nback scan\nhelp\n";
    let (_folder, run) = step(COUNTER, commands, &["--lang", "de"]);
    for english in
        ["breakpoint", "next:", " by ", "nothing", "statement", "pauses", "is set", "no command", "there are", "Error", "Help", "variables"]
    {
        let all = format!("{}{}", run.stdout, run.stderr);
        // The commands themselves are the same words in every language.
        let found = all.lines().find(|line| {
            !line.starts_with('>') && !line.contains("  breakpoints") && !line.contains("`breakpoints`") && line.contains(english)
        });
        assert_eq!(found, None, "{english}");
    }
    assert!(
        run.stdout.contains("Haltepunkt 2: MW10: 16#0000 (0) -> 16#0001 (1)") && run.stderr.contains("Fehler: `walk` ist kein Befehl"),
        "{}{}",
        run.stdout,
        run.stderr
    );
}

#[test]
fn reasons_of_structured_text_read_as_the_program_does() {
    let source = "FUNCTION Scale : INT\nVAR_INPUT raw : INT; gain : INT; END_VAR\nScale := raw * gain;\nEND_FUNCTION\n\
        PROGRAM Main\nVAR a : BOOL; x : INT := 5; y : INT; i : INT; k : INT; END_VAR\na := NOT a;\ny := Scale(raw := x, gain := 20);\n\
        FOR i := 1 TO 2 DO\n y := y + i;\nEND_FOR;\nWHILE y > 102 DO\n y := y - 1;\nEND_WHILE;\n\
        CASE y OF\n 1: k := 1;\n 102: k := 2;\nELSE\n k := 3;\nEND_CASE;\nEND_PROGRAM\n";
    let folder = Folder::with(&[("main.st", source), ("steps.txt", "step 30\n")]);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt"]);
    for reason in [
        "a is FALSE, so a becomes TRUE",
        "raw is 5, gain is 20, so Scale becomes 100",
        "the loop counts with i, which is 1",
        "y is 100, i is 1, so y becomes 101",
        "the loop counts with i, which is 2",
        "i: 1 -> 2",
        "y is 103: `y > 102` is TRUE, so what follows it runs",
        "the selector y = 102 chooses the branch",
        "k becomes 2",
    ] {
        assert!(run.stdout.contains(reason), "`{reason}` is missing in\n{}{}", run.stdout, run.stderr);
    }
    // The first turn of a loop shows its condition, as every other does.
    assert_eq!(run.stdout.lines().filter(|line| line.contains("  y > 102  ")).count(), 2, "{}", run.stdout);
}

/// The rows of a run: position, statement and what stands after it, without the padding.
fn rows(run: &Run) -> Vec<String> {
    let row = |line: &str| {
        let mut words = line.split_whitespace();
        let position: u64 = words.next()?.parse().ok()?;
        let rest: Vec<&str> = words.skip(2).collect();
        Some(format!("{position} {}", rest.join(" ")))
    };
    run.stdout.lines().filter_map(row).collect()
}

const BLINK: &str = "PROGRAM Main\nVAR wait : TON; list : ARRAY[1..3] OF TIME; name : STRING[8]; i : INT := 2; on : BOOL; r : REAL; END_VAR\n\
    list[i] := T#1s500ms;\nname := 'lamp';\nr := 2.5 * 4.0;\nwait(IN := NOT on, PT := list[i]);\nIF wait.Q THEN on := TRUE; END_IF;\nEND_PROGRAM\n";

#[test]
fn after_a_line_of_structured_text_stand_the_variables_that_it_names() {
    let folder = Folder::with(&[("main.st", BLINK), ("steps.txt", "step 6\n")]);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt"]).code(0);
    let expected = [
        "1 Main",
        "2 list[i] := T#1s500ms // list[i] = T#1S500MS, i = 2",
        "3 name := 'lamp' // name = 'lamp'",
        "4 r := 2.5 * 4.0 // r = 10.0",
    ];
    let rows = rows(&run);
    assert_eq!(rows[..4], expected, "{}", run.stdout);
    // The call of the library is one step, and its outputs are those after it.
    assert!(
        rows[4].ends_with("wait(IN := NOT on, PT := list[i]) // wait.Q = FALSE, wait.ET = T#0MS, on = FALSE, list[i] = T#1S500MS, i = 2"),
        "{rows:?}"
    );
    assert!(rows[5].ends_with("wait.Q // wait.Q = FALSE"), "{rows:?}");
    // What it changed is called as the program calls it, and no register of the compiler is among it.
    assert!(run.stdout.contains("wait.IN: 0 -> 1; wait.M: 0 -> 1; wait.PT: T#0MS -> T#1S500MS"), "{}", run.stdout);
    assert!(!run.stdout.contains("RLO") && !run.stdout.contains("AR2"), "{}", run.stdout);
    // An element whose index the statement changes is not the one that was read.
    let source = "PROGRAM Main\nVAR list : ARRAY[0..3] OF INT := [1, 2, 3, 3]; i : INT; END_VAR\ni := list[i];\nlist[i + 1] := list[i] * 10;\nEND_PROGRAM\n";
    let indexed = Folder::with(&[("main.st", source), ("steps.txt", "step 3\n")]);
    let other = indexed.run(&["step", "main.st", "--commands", "steps.txt"]).code(0);
    assert!(other.stdout.contains("  // i = 1\n"), "{}", other.stdout);
    assert!(other.stdout.contains("  // list[i + 1] = 20, list[i] = 2, i = 1\n"), "{}", other.stdout);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt", "--json"]).code(0);
    assert!(run.stdout.contains("\"line_values\":{\"wait.Q\":\"FALSE\"}"), "{}", run.stdout);
}

#[test]
fn a_step_goes_over_the_library_there_and_back_and_into_it_on_request() {
    let commands = "step 5\nback\nstep\nback 2\nstep 2\nback\ninto\nstack\nout\nback\ninto 2\nback into\n";
    let folder = Folder::with(&[("main.st", BLINK), ("steps.txt", commands)]);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt", "--json"]).code(0);
    let positions: Vec<u64> = values(&run, "position").iter().map(|text| text.parse().expect("a number")).collect();
    let (call, after) = (4, positions[0]);
    assert!(after > call + 1, "{positions:?}");
    assert_eq!(positions, [after, call, after, 3, after, call, call + 1, call + 1, after, call, call + 2, call + 1], "{}", run.stdout);
    assert!(run.stdout.contains(r#""text":"OB 1\nMain\nTON\n""#), "{}", run.stdout);
    // The end of a scan ends a step, also where a block of the library is the last thing that happens.
    let end = Folder::with(&[
        ("main.st", "PROGRAM Main\nVAR t : TON; END_VAR\nt(IN := TRUE, PT := T#1s);\nEND_PROGRAM\n"),
        ("steps.txt", "step 100\n"),
    ]);
    let run = end.run(&["step", "main.st", "--commands", "steps.txt", "--scans", "2", "--json"]).code(0);
    assert_eq!(values(&run, "halt"), ["\"no more scans\""], "{}", run.stdout);
}

#[test]
fn rows_of_another_language_get_the_head_of_their_columns() {
    let source = "FUNCTION FC 1 : VOID\nVAR_INPUT\n n : INT;\nEND_VAR\nBEGIN\nL #n\nT MW 10\nEND_FUNCTION\n";
    let program = "ORGANIZATION_BLOCK OB1\nVAR_TEMP\n x : INT;\nEND_VAR\nBEGIN\n x := 7;\n FC1(n := x);\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("a.awl", source), ("b.scl", program), ("steps.txt", "step 6\n")]);
    let run = folder.run(&["step", "a.awl", "b.scl", "--commands", "steps.txt"]).code(0);
    let heads: Vec<&str> = run.stdout.lines().filter(|line| line.contains("  pos  ")).map(|line| &line[31..36]).collect();
    assert_eq!(heads, ["  sta", "  RLO", "  sta"], "{}", run.stdout);
}

#[test]
fn between_two_scans_the_variables_that_the_program_keeps_are_shown() {
    let folder = Folder::with(&[("main.st", BLINK), ("steps.txt", "scan\nlocals\nprint on, list[2], wait.PT\n")]);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt"]).code(0);
    for line in ["  variables of Main\n", "    STAT    i           INT        2\n", "  list[2] = T#1S500MS\n", "  wait.PT = T#1S500MS\n"] {
        assert!(run.stdout.contains(line), "`{line}` is missing in\n{}", run.stdout);
    }
    let json = folder.run(&["step", "main.st", "--commands", "steps.txt", "--json"]).code(0);
    assert!(json.stdout.contains("\"locals\":null") && json.stdout.contains("\"kept\":[{\"block\":"), "{}", json.stdout);
    // Of STL the instances are known by their data blocks.
    let source = "FUNCTION_BLOCK FB 5\nVAR\n n : INT := 3;\nEND_VAR\nBEGIN\nL #n\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 6\nFB 5\nBEGIN\nEND_DATA_BLOCK\n\
        ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FB 5, DB 6;\nEND_ORGANIZATION_BLOCK\n";
    let (_folder, run) = step(source, "scan\nlocals\n", &[]);
    assert!(run.stdout.contains("  variables of FB 5, DB 6\n    STAT    DB6.n  INT  3\n"), "{}", run.stdout);
    let (_folder, none) = step(COUNTER, "scan\nlocals\n", &[]);
    assert!(none.stdout.contains("the program keeps no variables between two scans"), "{}", none.stdout);
}

#[test]
fn an_element_of_a_diagram_is_paused_at_and_named_like_a_statement() {
    let source = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n    OR\n        NO  I 0.0\n    OR\n        NO  Q 4.0\n    END\n    NC    I 0.1\n    COIL  Q 4.0\n\
                  NETWORK STL\n      A     Q 4.0;\n      =     Q 4.1;\nNETWORK FBD\n    MOVE 7 => MW 2\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[
        ("main.lad", source),
        ("steps.txt", "set I0.0=1\nbreak main.lad:10\nrun\nstep\nscan\nwho Q4.0\nwho MW2\nwho Q4.1\n"),
    ]);
    let run = folder.run(&["step", "main.lad", "--commands", "steps.txt"]).code(0);
    assert!(run.stdout.contains("breakpoint 1: main.lad:10\n  next: main.lad:10: = Q 4.0"), "{}", run.stdout);
    for (name, place) in [("Q4.0", "main.lad:10: = Q 4.0"), ("MW2", "main.lad:15: T MW 2"), ("Q4.1", "main.lad:13: = Q 4.1")] {
        assert!(run.stdout.lines().any(|line| line.contains(&format!("{name}: ")) && line.contains(place)), "{name}: {}", run.stdout);
    }
    let run = folder.run(&["step", "main.lad", "--commands", "steps.txt", "--json"]).code(0);
    assert!(run.stdout.contains("\"file\":\"main.lad\",\"line\":10,\"text\":\"= Q 4.0\""), "{}", run.stdout);
}

#[test]
fn constants_are_shown_by_their_names_and_cannot_be_set() {
    let source = "VAR_GLOBAL CONSTANT LIMIT : INT := 7; END_VAR\n\
        FUNCTION_BLOCK Lane\nVAR CONSTANT PLACES : INT := 50; END_VAR\nVAR n : INT; END_VAR\nn := n + PLACES;\nEND_FUNCTION_BLOCK\n\
        PROGRAM Main\nVAR CONSTANT DAY : DATE := D#2024-02-29; NAME : STRING[4] := 'abc'; FAST : BOOL := TRUE; RATE : REAL := 2.5; END_VAR\n\
        VAR lane1 : Lane; d : DATE; ld : LDATE := LD#2024-02-29; END_VAR\nd := DAY;\nlane1();\nIF d > D#2024-01-01 THEN d := d; END_IF;\nEND_PROGRAM\n";
    let commands = "print ld, DAY, NAME, FAST, RATE, LIMIT, Main.DAY, Lane.PLACES, DAY:BIN\nto Lane:1\nprint PLACES, #PLACES\nset PLACES=5\nstep\nscan\n";
    let folder = Folder::with(&[("main.st", source), ("steps.txt", commands)]);
    let run = folder.run(&["step", "main.st", "--commands", "steps.txt"]).code(2);
    for line in [
        "  ld = LD#2024-02-29\n  DAY = D#2024-02-29\n  NAME = 'abc'\n  FAST = 1\n  RATE = 2.5\n  LIMIT = 7\n  Main.DAY = D#2024-02-29\n  Lane.PLACES = 50\n",
        "  PLACES = 50\n  #PLACES = 50\n",
        "// n = 50\n",
    ] {
        assert!(run.stdout.contains(line), "`{line}` is missing in\n{}{}", run.stdout, run.stderr);
    }
    assert!(run.stderr.contains("[P7113] Error: `PLACES=5`: `PLACES` is a constant"), "{}", run.stderr);
    // What a block calls its own means nothing elsewhere, and programs get the notation of 64 bits as before.
    let shown = folder.run(&["exec", "main.st", "--scans", "1", "--show", "LIMIT,d,Main.NAME:HEX"]).code(0);
    assert!(shown.stdout.starts_with("LIMIT         = 7\nd             = LD#2024-02-29\n"), "{}", shown.stdout);
    let unknown = folder.run(&["exec", "main.st", "--scans", "1", "--show", "PLACES"]).code(2);
    assert!(unknown.stderr.contains("P7003"), "{}", unknown.stderr);
    let scl = "FUNCTION FC1 : VOID\nCONST\n DEPTH := 12;\nEND_CONST\nVAR_TEMP\n x : INT;\nEND_VAR\nBEGIN\n x := DEPTH;\nEND_FUNCTION\n\
        ORGANIZATION_BLOCK OB1\nBEGIN\n FC1();\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("main.scl", scl), ("steps.txt", "to FC1:1\nprint DEPTH, FC1.DEPTH\n")]);
    let run = folder.run(&["step", "main.scl", "--commands", "steps.txt"]).code(0);
    assert!(run.stdout.ends_with("  DEPTH = 12\n  FC1.DEPTH = 12\n"), "{}{}", run.stdout, run.stderr);
}

#[test]
fn a_pointer_is_shown_as_it_is_written() {
    let source = "FUNCTION FC 1 : VOID\nVAR_INPUT\n p : POINTER;\n a : ANY;\nEND_VAR\nBEGIN\nNOP 0\nEND_FUNCTION\n\
        ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 (p := P#M 10.0, a := P#DB5.DBX 10.0 BYTE 20);\nEND_ORGANIZATION_BLOCK\n";
    let (folder, run) = step(source, "to FC1:1\nlocals\nprint #p\n", &[]);
    assert!(
        run.stdout.contains("  #p  POINTER  P#M 10.0\n") && run.stdout.contains("  #a  ANY      P#DB5.DBX 10.0 BYTE 20\n"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.ends_with("  #p = P#M 10.0\n"), "{}", run.stdout);
    let json = folder.run(&["step", "main.awl", "--commands", "steps.txt", "--json"]);
    assert!(json.stdout.contains("\"values\":{\"#p\":\"00 00 83 00 00 50\"}"), "{}", json.stdout);
}

#[test]
fn a_rotation_can_be_followed_bit_by_bit() {
    // RLD goes around in the accumulator, RRDA through CC 1.
    let source = "ORGANIZATION_BLOCK OB 1\nBEGIN\nL DW#16#5F64AA5D\nRLD 4\nRRDA\nEND_ORGANIZATION_BLOCK\n";
    let commands = "show ACCU1:BIN\nstep\nstep\nstep\n";
    let (_folder, run) = step(source, commands, &[]);
    let bits: Vec<&str> = run.stdout.lines().filter_map(|line| line.trim().strip_prefix("ACCU1:BIN = 2#")).collect();
    let expected = [
        "0000_0000_0000_0000_0000_0000_0000_0000",
        "0101_1111_0110_0100_1010_1010_0101_1101",
        "1111_0110_0100_1010_1010_0101_1101_0101",
        "1111_1011_0010_0101_0101_0010_1110_1010",
    ];
    assert_eq!(bits, expected, "{}", run.stdout);
    assert_eq!(run.stdout.matches("31   27   23   19   15   11   7    3").count(), 4, "{}", run.stdout);
}
