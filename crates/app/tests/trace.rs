//! `sieben trace` as its users meet it: files, triggers, scenarios, recordings, and what goes wrong with them.

mod command;

use command::Folder;

const LAMP: &str = "A I 0.0\nL S5T#50MS\nSD T 1\nA T 1\n= Q 0.0\n";

#[test]
fn a_trace_without_channels_draws_the_inputs_and_outputs_by_their_symbols() {
    let symbols = "symbol,address,type,comment\nStart,I 0.0,BOOL,\nMotor.1,Q 0.0,BOOL,\n";
    let folder = Folder::with(&[("lamp.awl", LAMP), ("symbols.csv", symbols)]);
    let run = folder.run(&["trace", "lamp.awl", "symbols.csv", "--set", "Start=1", "--scans", "20"]).code(0);
    assert!(run.stdout.contains("\nStart\n") && run.stdout.contains("\"Motor.1\""), "{}", run.stdout);
    let german = Folder::with(&[("lampe.awl", "U E 0.0\n= A 4.1\n")]);
    german.run(&["trace", "lampe.awl", "--ascii"]).code(0).stdout("E 0.0").stdout("A 4.1");
    let drawn = Folder::with(&[("lamp.lad", "I 0.0 S_ODT[T 1](TV := S5T#50MS) -> = Q 0.0\n"), ("symbols.csv", symbols)]);
    let drawn = drawn.run(&["trace", "lamp.lad", "symbols.csv", "--set", "Start=1", "--scans", "20"]).code(0);
    assert_eq!(drawn.stdout, run.stdout, "the timing diagram of a ladder diagram is that of its statement list");
    let st = Folder::with(&[("main.st", "PROGRAM main\nVAR level AT %IW4 : INT; full : BOOL; END_VAR\nfull := level > 5;\nEND_PROGRAM\n")]);
    st.run(&["trace", "main.st", "--set", "level=7"]).code(0).stdout("level").stdout("7");
    st.run(&["trace", "main.st", "--channels", "full,level", "--at", "20ms", "level=7", "--scans", "5", "--csv", "-"])
        .code(0)
        .stdout("time_ms,scan,full,level\r\n0,0,0,0\r\n10,1,0,0\r\n20,2,1,7\r\n");
}

#[test]
fn the_files_of_a_trace_hold_it() {
    let folder = Folder::with(&[("lamp.awl", LAMP)]);
    let files = ["--svg", "a.svg", "--vcd", "a.vcd", "--csv", "a.csv", "--csv-every", "changes", "--record", "a.trace"];
    let arguments = [&["trace", "lamp.awl", "--at", "20ms", "I0.0=1", "--channels", "I0.0,T1,Q0.0"], &files[..]].concat();
    folder.run(&arguments).code(0).stderr("100 scans of 3 channels: `a.vcd`, `a.csv`, `a.svg`, `a.trace`");
    let text = |name: &str| String::from_utf8(folder.read(name)).expect("text");
    assert_eq!(
        text("a.csv"),
        "time_ms,scan,I0.0,T1,Q0.0\r\n0,0,0,0,0\r\n20,2,1,5,0\r\n30,3,1,4,0\r\n40,4,1,3,0\r\n50,5,1,2,0\r\n60,6,1,1,0\r\n70,7,1,0,1\r\n"
    );
    assert!(
        text("a.vcd").contains("$var wire 1 ! I0.0 $end")
            && text("a.vcd").ends_with("#70000\nb00000000000000000000000000000000 \"\n1#\n#990000\n")
    );
    assert!(text("a.svg").contains("<title>Q0.0 = 1, 70 ms to 1 s</title>"), "{}", text("a.svg"));

    let drawn = folder.run(&["trace", "lamp.awl", "--at", "20ms", "I0.0=1", "--channels", "I0.0,T1,Q0.0"]).code(0).stdout;
    assert_eq!(folder.run(&["trace", "--from", "a.trace"]).code(0).stdout, drawn);
    assert_eq!(folder.run(&["trace", "--from", "a.trace", "lamp.awl"]).code(0).stdout, drawn);
    folder.write("lamp.awl", LAMP.replace("50MS", "60MS").as_bytes());
    folder.run(&["trace", "--from", "a.trace", "lamp.awl"]).code(2).stderr("P6264");

    let lines = folder.run(&["trace", "--from", "a.trace", "--json"]).code(0).lines();
    assert_eq!(lines[1], serde_json::json!({ "scan": 2, "time_ms": 20, "values": { "I0.0": 1, "T1": 5 } }));
    assert_eq!(lines.last().expect("a line")["trace"]["channels"][1]["changes"], 6);

    let recording = folder.read("a.trace");
    folder.write("cut.trace", &recording[..recording.len() - 3]);
    folder.run(&["trace", "--from", "cut.trace"]).code(0).stderr("P6263").stdout("Q0.0");
    let mut damaged = recording.clone();
    damaged[40] ^= 1;
    folder.write("damaged.trace", &damaged);
    folder.run(&["trace", "--from", "damaged.trace"]).code(2).stderr("P6262").stderr("checksum");
    folder.run(&["trace", "--from", "missing.trace"]).code(2).stderr("P6001");
    folder.run(&["trace", "--from", "."]).code(2).stderr("P6006");
}

#[test]
fn a_scenario_is_traced_and_its_expectations_are_looked_at() {
    let good = "at 20ms I 0.0=1\nscan until 200ms\nexpect Q 0.0=1\n";
    let bad = "cycle 20ms\nat 20ms I 0.0=1\nscan 3\nexpect Q 0.0=1\nscan 10\nexpect Q 0.0=1\n";
    let files = [("lamp.awl", LAMP), ("good.scenario", good), ("bad.scenario", bad), ("empty.scenario", "set I 0.0=1\n")];
    let folder = Folder::with(&files);
    folder.run(&["trace", "lamp.awl", "good.scenario"]).code(0).stdout("Q 0.0");
    folder.run(&["trace", "lamp.awl", "--scenario", "good.scenario"]).code(0);
    let run = folder.run(&["trace", "lamp.awl", "bad.scenario"]).code(1).stderr("P6261").stderr("bad.scenario:4: expected Q 0.0 = 1");
    assert!(
        run.stdout.contains("▼ line 4: expected Q 0.0 = 1, got 0 after the scan at 40ms") && !run.stderr.contains(":6:"),
        "{}",
        run.stdout
    );
    // The diagram is shown beside files, too.
    folder.run(&["trace", "lamp.awl", "bad.scenario", "--svg", "bad.svg"]).code(1).stdout("▼ line 4");
    let lines = folder.run(&["trace", "lamp.awl", "bad.scenario", "--json"]).code(1).lines();
    assert_eq!(lines.last().expect("a line")["trace"]["failures"][0]["time_ms"], 40);
    folder.run(&["trace", "lamp.awl", "empty.scenario"]).code(2).stderr("P7032").stderr("no scan");
    folder.run(&["trace", "lamp.awl", "good.scenario", "--scans", "3"]).code(2).stderr("P7001");
    folder.run(&["trace", "lamp.awl", "good.scenario", "bad.scenario"]).code(2).stderr("one scenario at a time");
    // A line that no scan follows, and a name that the program does not have.
    folder.write("gap.scenario", b"scan 3\nat 1s I 0.0=1\nset NoSuch=1\n");
    let run = folder.run(&["trace", "lamp.awl", "gap.scenario"]).code(1).stderr("gap.scenario:2: no scan came at 1000ms");
    assert!(run.stderr.contains("gap.scenario:3: nothing is called `NoSuch`"), "{}", run.stderr);
}

#[test]
fn rows_of_a_table_stand_one_behind_the_other() {
    let folder =
        Folder::with(&[("and.awl", "A I 0.0\nA I 0.1\n= Q 0.0\n"), ("and.scenario", "table I 0.0 I 0.1 -> Q 0.0\n0 0 0\n0 1 0\n1 1 1\n")]);
    folder
        .run(&["trace", "and.awl", "and.scenario", "--csv", "-"])
        .code(0)
        .stdout("time_ms,scan,I 0.0,I 0.1,Q 0.0\r\n0,0,0,0,0\r\n10,1,0,1,0\r\n20,2,1,1,1\r\n");
}

#[test]
fn a_trigger_keeps_what_is_around_it_or_says_that_it_did_not_come() {
    let folder = Folder::with(&[("lamp.awl", LAMP)]);
    let around = ["trace", "lamp.awl", "--at", "500ms", "I0.0=1", "--trigger", "Q0.0 rises", "--before", "2", "--after", "1", "--csv", "-"];
    folder.run(&around).code(0).stdout("time_ms,scan,I 0.0,Q 0.0\r\n530,53,1,0\r\n540,54,1,0\r\n550,55,1,1\r\n560,56,1,1\r\n");
    folder.run(&["trace", "lamp.awl", "--trigger", "Q0.0 rises"]).code(1).stderr("P7031");
    folder
        .run(&["trace", "lamp.awl", "--last", "2", "--csv", "-"])
        .code(0)
        .stdout("time_ms,scan,I 0.0,Q 0.0\r\n980,98,0,0\r\n990,99,0,0\r\n");
    for (trigger, code) in
        [("Q0.0 jumps", "P7030"), ("MW0 rises", "P7030"), ("MW0 > x", "P7004"), ("NoSuch > 1", "P7003"), ("DB9.DBW0 > 1", "P7003")]
    {
        folder.run(&["trace", "lamp.awl", "--trigger", trigger]).code(2).stderr(code);
    }
}

#[test]
fn what_cannot_be_recorded_or_shown_is_said() {
    let symbols = "symbol,address,type,comment\nConveyor,I 0.0,BOOL,\n";
    let folder = Folder::with(&[
        ("lamp.awl", LAMP),
        ("symbols.csv", symbols),
        ("stop.awl", "A I 0.0\n= Q 0.0\nL MW 10\nL 3\n>=I\nJC end\nL MW 10\nL 1\n+I\nT MW 10\nBEU\nend: CALL SFC 46\n"),
    ]);
    folder
        .run(&["trace", "lamp.awl", "symbols.csv", "--channels", "Conveyer"])
        .code(2)
        .stderr("P7003")
        .stderr("Did you mean the symbol `Conveyor`?");
    folder.run(&["trace", "lamp.awl", "--channels", ","]).code(2).stderr("P7032");
    folder.run(&["trace", "lamp.awl", "--window", "5s..6s"]).code(2).stderr("P7033");
    folder.run(&["trace", "lamp.awl", "--window", "6s..5s"]).code(2).stderr("ends before it begins");
    folder.run(&["trace", "lamp.awl", "--cursor", "5s"]).code(2).stderr("P7033");
    folder.run(&["trace", "lamp.awl", "--width", "3"]).code(2).stderr("40 to 4000");
    folder.run(&["trace", "lamp.awl", "--svg", "no/such/folder.svg"]).code(2).stderr("P6013");
    folder.run(&["trace", "lamp.awl", "--record", "."]).code(2).stderr("P6013");
    folder.run(&["trace"]).code(2);
    folder.run(&["trace", "--from", "x", "--scans", "5"]).code(2).stderr("runs nothing");
    folder.run(&["trace", "stop.awl"]).code(4).stdout("STOP: STOP by the program (SFC 46 STP)").stderr("stop.awl:12");
}

#[test]
fn a_diagram_of_two_hundred_channels_and_of_many_scans_stays_small() {
    let program: String = (0..200).map(|index| format!("A I {}.{}\n= Q {}.{}\n", index / 8, index % 8, index / 8, index % 8)).collect();
    let folder = Folder::with(&[("wide.awl", &program), ("count.awl", "L MW 10\nL 1\n+I\nT MW 10\nA M 11.0\n= Q 0.0\n")]);
    let channels: Vec<String> = (0..200).map(|index| format!("Q{}.{}", index / 8, index % 8)).collect();
    folder.run(&["trace", "wide.awl", "--channels", &channels.join(","), "--set", "ID0=-1", "--svg", "wide.svg"]).code(0);
    let svg = String::from_utf8(folder.read("wide.svg")).expect("text");
    assert_eq!(svg.matches("<title>Q0.0</title>").count(), 1);
    assert_eq!(svg.matches("class=\"step\"").count(), 200);
    folder.run(&["trace", "count.awl", "--channels", "MW10,Q0.0", "--scans", "50000", "--svg", "count.svg"]).code(0);
    assert!(folder.read("count.svg").len() < 300_000);
    let run = folder.run(&["trace", "count.awl", "--channels", "MW10,Q0.0", "--scans", "50000"]).code(0);
    assert!(run.stdout.len() < 4000 && run.stdout.contains('▒'), "{}", run.stdout);
}
