//! The command line as its users meet it: arguments and files in, text and exit code out.

mod command;

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use command::{Folder, sieben};

const ADD: &str = "L MW 0\nL MW 2\n+I\nT MW 4\n";
/// The verbs whose help has examples.
const VERBS: [&str; 16] = [
    "run",
    "check",
    "exec",
    "bench",
    "test",
    "trace",
    "step",
    "explain",
    "fmt",
    "convert",
    "symbols",
    "tags",
    "refs",
    "structure",
    "assignments",
    "new",
];
const LAMP: &str = "A I 0.0\nL S5T#50MS\nSD T 1\nA T 1\n= Q 0.0\nA I 0.0\nCU C 1\n";

/// A choice behind an index that is looked at takes a value that is read between both: optimized code once left that out.
#[test]
fn optimized_code_chooses_what_the_interpreter_chooses() {
    let program = "PROGRAM Main\nVAR k, n : INT; c : ARRAY[0..99] OF BOOL; v : ARRAY[0..9] OF INT; s, r, x : REAL; done : BOOL; END_VAR\n\
         c[80] := TRUE; v[1] := 2; x := 1.0;\n\
         s := (-2.0 / INT_TO_REAL(MAX(n, v[k + 1]))) / SEL(c[80], 100.0, x);\n\
         IF NOT done THEN done := TRUE; r := s; END_IF;\nEND_PROGRAM\n";
    let folder = Folder::with(&[("choice.st", program)]);
    for engine in ["interpreter", "quick", "jit"] {
        let few = ["--show", "r", "--warmup-scans", "2", "--reps", "1", "--min-ms", "1", "--dialect", "iec"];
        let arguments: Vec<&str> = ["bench", "choice.st", "--engine", engine].into_iter().chain(few).collect();
        folder.run(&arguments).code(0).stdout("r = -1.0e+000");
    }
}

#[test]
fn help_names_every_verb_with_an_example() {
    let folder = Folder::new();
    for arguments in [&["--help"][..], &["help"], &["-h"]] {
        let run = folder.run(arguments).code(0);
        for verb in VERBS.iter().chain(&["demo"]) {
            assert!(run.stdout.contains(&format!("\n  {verb} ")), "{verb}");
        }
    }
    for verb in VERBS {
        folder.run(&[verb, "--help"]).code(0).stdout("Example").stdout(&format!("sieben {verb}"));
    }
}

#[test]
fn bench_prints_what_its_contract_says() {
    let folder = Folder::with(&[("count.awl", "L MW 0\nL 1\n+I\nT MW 0\n"), ("stop.awl", "OPN DB 77\n")]);
    let few = ["--reps", "2", "--min-ms", "1", "--warmup-scans", "7", "--show", "MW0", "--json"];
    for (engine, native) in [("interpreter", false), ("jit", true), ("auto", true)] {
        let arguments: Vec<&str> = ["bench", "count.awl", "--engine", engine].into_iter().chain(few).collect();
        let run = folder.run(&arguments).code(0);
        let json: serde_json::Value = serde_json::from_str(&run.stdout).expect("one JSON object");
        assert_eq!(json["values"]["MW0"], "16#0007", "the value after exactly the scans of the warm-up");
        assert_eq!(json["ns_per_scan"].as_array().map(Vec::len), Some(2));
        assert!(
            ["compile_s", "ns_per_statement", "cold_ns_per_scan"].iter().all(|key| json[key].as_f64().is_some_and(|value| value > 0.0))
        );
        assert_eq!(json["code_bytes"].as_u64().is_some_and(|bytes| bytes > 0), native, "{engine}");
    }
    let many = folder.run(&["bench", "count.awl", "--instances", "50", "--reps", "1", "--min-ms", "1", "--json"]).code(0).json();
    assert_eq!(many["instances"]["count"], 50);
    assert!(many["instances"]["scans_per_second"].as_f64().is_some_and(|scans| scans > 0.0));
    folder.run(&["bench", "stop.awl", "--min-ms", "1"]).code(4).stderr("16#");
}

#[test]
fn wrong_arguments_are_answered_with_what_is_valid() {
    let folder = Folder::with(&[("add.awl", ADD)]);
    for (arguments, expected) in [
        (&["chek"][..], "similar subcommand exists: 'check'"),
        (&["add.awl"], "Did you mean `sieben run add.awl`?"),
        (&["exec"], "required arguments were not provided"),
        (&["exec", "add.awl", "--scan", "3"], "similar argument exists: '--scans'"),
        (&["exec", "add.awl", "--scans", "0"], "invalid value '0'"),
        (&["exec", "add.awl", "--scans", "3", "--for", "1s"], "cannot be used with"),
        (&["exec", "add.awl", "--for", "10"], "`10` is not a duration; write a number with its unit"),
        (&["exec", "add.awl", "--cycle", "0", "--for", "1s"], "P7009"),
        (&["exec", "add.awl", "--scan-at", "20ms,10ms"], "time does not run backwards"),
        (&["exec", "add.awl", "--engine", "fast"], "possible values: auto, interpreter, jit"),
        (&["exec", "add.awl", "--cpu", "315-3PN/DP"], "did you mean `315-2PN/DP`?"),
        (&["exec", "add.awl", "--cpu", "1500"], "known are `315-2PN/DP`, `317-2PN/DP`, `319-3PN/DP`, `416-3` or `417-4`"),
        (&["exec", "add.awl", "--mnemonics", "fr"], "possible values: auto, en, de"),
        (&["exec", "add.awl", "--set", "MW0"], "`MW0` gives no value"),
        (&["exec", "add.awl", "--set", "MW0=1.5"], "P7004"),
        (&["exec", "add.awl", "--set", "MW0=70000"], "`70000` does not fit into `MW0`, which has 16 bits"),
        (&["exec", "add.awl", "--set", "I0.0=2"], "write 0 or 1"),
        (&["exec", "add.awl", "--set", "I0.8=1"], "`I0.8` has a bit number above 7"),
        (&["exec", "add.awl", "--show", "DB1.DBX0.12"], "has a bit number above 7"),
        (&["exec", "add.awl", "--show", "STW.XYZ"], "the status word has no bit `XYZ`"),
        (&["exec", "add.awl", "--set", "STW=111"], "nine characters"),
        (&["exec", "add.awl", "--set", "T1.q=1"], "`T1.q` can only be read"),
        (&["exec", "add.awl", "--set", "MW9999=1"], "cannot read `MW9999`: the address lies outside"),
        (&["exec", "add.awl", "--show", "DB7.DBW0"], "the data block is not loaded"),
        (&["exec", "add.awl", "--show", "DB7.speed"], "the program has no `DB 7`"),
        (&["exec", "add.awl", "--show", "FC1"], "`FC 1` is a block, which has no value"),
        (&["exec", "add.awl", "--show", "Motro"], "nothing is called `Motro`"),
        (&["exec", "add.awl", "--at", "5ms", "ACCU1=1"], "a register can only be set for the first scan"),
        (&["exec", "add.awl", "--at", "soon", "I0.0=1"], "P7005"),
        (&["run", "add.awl", "--speed", "fast"], "is no speed"),
        (&["explain", "P2002x"], "Did you mean `P200"),
        (&["explain", "SPBX"], "Did you mean `SPB"),
        (&["convert", "add.awl"], "--mnemonics"),
        (&["new", "a b"], "P7008"),
        (&["new", "-x"], ""),
        (&["new", ".."], "P7008"),
    ] {
        folder.run(arguments).code(2).stderr(expected);
    }
}

#[test]
fn a_run_that_shows_nothing_says_how_to_show_something() {
    let folder = Folder::with(&[("add.awl", ADD)]);
    folder.run(&["exec", "add.awl"]).code(0).stderr("`--show MW0,Q0.0` prints values");
    assert_eq!(folder.run(&["exec", "add.awl", "--show", "MW4"]).code(0).stderr, "");
    folder.run(&["exec", "add.awl", "--set", "MW0=1", "--show", "stw.vke, STW.BIE"]).code(0).stdout("stw.vke = ");
}

#[test]
fn bad_files_are_refused_with_a_code() {
    let folder =
        Folder::with(&[("add.awl", ADD), ("empty.awl", ""), ("blank.awl", " \r\n\t\n"), ("folder/x.txt", ""), ("plant.csv", "a,b\n")]);
    folder.write("binary.awl", b"\x70\x70\x01\x00\x00\x08\x00\x01");
    fs::File::create(folder.path().join("huge.awl")).and_then(|file| file.set_len(65 << 20)).expect("a sparse file");
    for (arguments, code, expected) in [
        (&["check", "ad.awl"][..], 2, "[P6001] Error: there is no file or folder `ad.awl`\n  Help: Did you mean `add.awl`?"),
        (&["check", "nowhere/x.awl"], 2, "P6001"),
        (&["check", "huge.awl"], 2, "[P1104] Error: `huge.awl` is larger than 64 MiB"),
        (&["check", "binary.awl"], 3, "[P1101] Error"),
        (&["check", "empty.awl"], 3, "[P6005] Error: `empty.awl` is empty"),
        (&["check", "blank.awl"], 3, "[P6005] Error: `blank.awl` is empty"),
        (&["check", "folder"], 3, "[P6005] Error: there is no STL source in `folder`"),
        (&["check", "add.awl", "blank.awl"], 0, "[P6004] Warning: `blank.awl` is empty"),
        (&["check", "blank.awl", "empty.awl"], 3, "[P6005] Error: all sources are empty"),
        (&["exec", "ad.awl"], 2, "P6001"),
        (&["exec", "binary.awl"], 3, "P1101"),
        (&["exec", "empty.awl"], 3, "P6005"),
        (&["run", "huge.awl"], 2, "P1104"),
        (&["symbols", "folder"], 2, "[P6006] Error: `folder` is a folder"),
        (&["symbols", "plant.csv"], 1, "P6104"),
        (&["symbols", "binary.awl"], 2, "P1101"),
        (&["fmt", "binary.awl"], 3, "P1101"),
        (&["fmt", "ad.awl"], 2, "P6001"),
    ] {
        folder.run(arguments).code(code).stderr(expected);
    }
}

#[test]
fn exec_sets_and_shows_every_kind_of_name() {
    let folder = Folder::with(&[
        ("add.awl", ADD),
        ("symbols.csv", "symbol,address,type\nSum,MW 4,INT\nRaw,MW 4,WORD\nStart,I 0.0,BOOL\nScale,MD 20,REAL\n"),
    ]);
    let shown = "MW 4,mw4,Sum,raw,\"Start\",E0.0,ACCU1,ACCU 2,AR1,STW,STW.RLO,stw.cc1,T 1,C 1,Z1,T1.q,MB4,M 5.0,MD 4,Scale,PIW 0,PQW0";
    let run = folder.run(&[
        "exec",
        "add.awl",
        "symbols.csv",
        "--json",
        "--show",
        shown,
        "--set",
        "MW0=2",
        "--set",
        "MW2=W#16#0003",
        "--set",
        "Start=TRUE",
        "--set",
        "Scale=2",
        "--set",
        "AR1=P#10.0",
        "--set",
        "IB 1=16#A5",
    ]);
    let run = run.code(0);
    let lines = run.lines();
    assert_eq!(lines.len(), 1);
    assert_eq!(
        run.stdout.trim_end(),
        "{\"scan\":0,\"time_ms\":0,\"values\":{\"MW 4\":\"16#0005\",\"mw4\":\"16#0005\",\"Sum\":5,\"raw\":\"16#0005\",\"\\\"Start\\\"\":1,\
         \"E0.0\":1,\"ACCU1\":\"16#0000_0005\",\"ACCU 2\":\"16#0000_0002\",\"AR1\":\"16#0000_0050\",\"STW\":\"110000000\",\"STW.RLO\":0,\
         \"stw.cc1\":1,\"T 1\":0,\"C 1\":0,\"Z1\":0,\"T1.q\":0,\"MB4\":\"16#00\",\"M 5.0\":1,\"MD 4\":\"16#0005_0000\",\"Scale\":2.0,\
         \"PIW 0\":\"16#01A5\",\"PQW0\":\"16#0000\"},\"mode\":\"RUN\"}"
    );
}

#[test]
fn registers_are_preset_for_the_first_scan_only() {
    let folder = Folder::with(&[("r.awl", "NOP 0\n"), ("both.awl", "+I\n")]);
    let run = folder.run(&[
        "exec",
        "r.awl",
        "--set",
        "ACCU1=-1",
        "--set",
        "STW=000000110",
        "--show",
        "ACCU1,STW",
        "--json",
        "--scans",
        "2",
        "--every",
    ]);
    let lines = run.code(0).lines();
    assert_eq!(lines[0]["values"], serde_json::json!({"ACCU1": "16#0000_FFFF", "STW": "000000110"}));
    assert_eq!(lines[1]["values"], serde_json::json!({"ACCU1": "16#0000_0000", "STW": "100000000"}));
    let run = folder.run(&[
        "exec",
        "both.awl",
        "--cpu",
        "416-3",
        "--set",
        "ACCU1=2",
        "--set",
        "ACCU2=3",
        "--set",
        "ACCU3=7",
        "--show",
        "ACCU1,ACCU2,ACCU3",
    ]);
    assert_eq!(run.code(0).stdout, "ACCU1 = 16#0000_0005\nACCU2 = 16#0000_0007\nACCU3 = 16#0000_0000\n");
}

#[test]
fn time_is_virtual_and_inputs_change_when_they_are_told() {
    let folder = Folder::with(&[("lamp.awl", LAMP)]);
    let run =
        folder.run(&["exec", "lamp.awl", "--at", "25ms", "I0.0=1", "--for", "100ms", "--show", "Q0.0,T 1,C 1,T1.q", "--every", "--json"]);
    let lines = run.code(0).lines();
    assert_eq!(lines.len(), 10);
    let column = |name: &str| lines.iter().map(|line| line["values"][name].as_u64().expect("a number")).collect::<Vec<_>>();
    assert_eq!(
        lines.iter().map(|line| line["time_ms"].as_u64().expect("a number")).collect::<Vec<_>>(),
        [0, 10, 20, 30, 40, 50, 60, 70, 80, 90]
    );
    assert_eq!(column("Q0.0"), [0, 0, 0, 0, 0, 0, 0, 0, 1, 1]);
    assert_eq!(column("T 1"), [0, 0, 0, 5, 4, 3, 2, 1, 0, 0]);
    assert_eq!(column("C 1"), [0, 0, 0, 1, 1, 1, 1, 1, 1, 1]);
    assert_eq!(column("T1.q"), column("Q0.0"));
    let run = folder.run(&["exec", "lamp.awl", "--scan-at", "0ms,1.5ms,1s", "--every", "--json"]).code(0);
    assert_eq!(run.lines().iter().map(|line| line["time_ms"].to_string()).collect::<Vec<_>>(), ["0", "1.5", "1000"]);
}

#[test]
fn a_stop_names_its_first_cause_and_place() {
    let folder = Folder::with(&[("stop.awl", "NOP 0\nL W [AR1, P#0.0]\n")]);
    let run = folder.run(&["exec", "stop.awl", "--set", "AR1=DW#16#83000014", "--scans", "3", "--json"]).code(4);
    let lines = run.lines();
    assert_eq!(lines.len(), 1);
    assert_eq!(lines[0]["mode"], "STOP");
    assert_eq!(lines[0]["stop"]["event"], "16#2528");
    assert_eq!(lines[0]["stop"]["block"], "OB 1");
    assert_eq!(lines[0]["stop"]["statement"], 2);
    assert!(lines[0]["stop"]["text"].as_str().is_some_and(|text| !text.is_empty()));
    folder.write("stop2.awl", b"OPN DB 99\nL DBW 0\n");
    folder.run(&["run", "stop2.awl", "--for", "1s"]).code(4).stderr("Diagnostic buffer").stderr("stop2.awl:1").stdout("STOP");
}

#[test]
fn variables_of_data_blocks_have_their_types() {
    let source = "DATA_BLOCK DB 1\nSTRUCT\n  speed : INT := -5;\n  ratio : REAL := 1.5;\n  on : BOOL := TRUE;\n  list : ARRAY [1..3] OF INT := 1, 2, 3;\n  name : STRING [8] := 'abc';\n  motor : STRUCT t : TIME := T#1S; w : WORD := W#16#00FF; END_STRUCT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nL DB1.DBW 0\nT MW 0\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("db.awl", source), ("s.csv", "symbol,address,type\nData,DB 1,DB 1\n")]);
    let run = folder.run(&[
        "exec",
        "db.awl",
        "s.csv",
        "--json",
        "--set",
        "DB1.list[2]=7",
        "--show",
        "DB1.speed,DB1.ratio,DB1.on,DB1.list[2],DB1.name,DB1.motor.t,DB1.motor.w,\"Data\".speed,Data.list[3],Data.DBW 0,DB1.DBW0,MW0",
    ]);
    assert_eq!(
        run.code(0).lines()[0]["values"],
        serde_json::json!({
            "DB1.speed": -5, "DB1.ratio": 1.5, "DB1.on": 1, "DB1.list[2]": 7, "DB1.name": "'abc'", "DB1.motor.t": "T#1S", "DB1.motor.w": "16#00FF",
            "\"Data\".speed": -5, "Data.list[3]": 3, "Data.DBW 0": "16#FFFB", "DB1.DBW0": "16#FFFB", "MW0": "16#FFFB",
        })
    );
    for (name, expected) in [
        ("DB1.sped", "its fields begin with speed, ratio"),
        ("DB1.list[4]", "`DB 1` has no `list[4]`"),
        ("DB1.list", "no single value"),
        ("DB1.motor", "no single value"),
    ] {
        folder.run(&["exec", "db.awl", "--show", name]).code(2).stderr(expected);
    }
}

#[test]
fn a_new_project_has_the_language_that_is_wanted_and_tests_that_pass() {
    let folder = Folder::new();
    for language in ["stl", "st", "scl", "lad", "fbd"] {
        folder.run(&["new", language, "--language", language]).code(0).stdout("src/main.");
        folder.run(&["check", language]).code(0).stdout("no errors, no warnings.");
        folder.run(&["fmt", "--check", language]).code(0);
        for engine in ["interpreter", "auto"] {
            let run = folder.run(&[
                "exec",
                language,
                "--engine",
                engine,
                "--set",
                "Stop=1",
                "--set",
                "Start=1",
                "--for",
                "5s",
                "--show",
                "Motor,Lamp",
            ]);
            assert_eq!(run.code(0).stdout, "Motor = 1\nLamp  = 1\n");
        }
        folder
            .run(&["test", language])
            .code(0)
            .stdout("tests/motor.test.st: the lamp comes on after two seconds")
            .stdout("3 passed, 0 failed");
        assert_eq!(folder.run(&["test", language, "--json"]).code(0).json()["passed"], 3);
    }
}

#[test]
fn reference_data_shows_st_beside_stl() {
    let folder = Folder::with(&[
        (
            "main.st",
            "VAR_GLOBAL g : INT; a : ARRAY[0..9] OF INT; out AT %QW4 : INT; END_VAR\n\
             FUNCTION Twice : INT VAR_INPUT v : INT; END_VAR Twice := v * 2; END_FUNCTION\n\
             PROGRAM Main VAR i : INT; t : TON; END_VAR\n\
             FOR i := 0 TO 9 DO a[i] := Twice(v := g); END_FOR;\n\
             t(IN := %I0.0, PT := T#1S);\n\
             IF t.Q THEN out := a[3]; END_IF;\n\
             END_PROGRAM\n",
        ),
        ("more.awl", "FUNCTION FC 5 : VOID\nBEGIN\nL MW 2\nT QW 4\nEND_FUNCTION\n"),
    ]);
    let files = |verb: &'static str| [verb, "main.st", "more.awl"];
    let refs = folder.run(&files("refs"));
    let refs = refs.code(0).stdout("DB16000.DBW 0").stdout("Globals.g").stdout("P#DB16000.DBX 2.0 BYTE 20").stdout("main.st:4");
    let refs = refs.stdout("I 0.0").stdout("more.awl:4");
    assert!(refs.stdout.contains("FC 7999"), "{}", refs.stdout);
    folder.run(&["refs", "main.st", "more.awl", "out"]).code(0).stdout("main.st:6").stdout("more.awl:4");
    folder.run(&["refs", "main.st", "g"]).code(0).stdout("Globals.g");
    folder.run(&["refs", "main.st", "Twice"]).code(0).stdout("call");
    folder.run(&["refs", "main.st", "--local"]).code(0).stdout("#t.Q").stdout("#v");
    folder.run(&files("structure")).code(0).stdout("    FC 7999").stdout("#t").stdout("library").stdout("x FC 5");
    folder.run(&files("assignments")).code(0).stdout("IB 0").stdout("QB 4").stdout("MB 2");
}

#[test]
fn a_new_project_checks_runs_and_is_not_overwritten() {
    let folder = Folder::new();
    folder.run(&["new", "pump"]).code(0).stdout("sieben check pump");
    folder.run(&["check", "pump"]).code(0).stdout("1 block in 1 source, no errors, no warnings.");
    folder.run(&["check", "pump/sieben.toml"]).code(0);
    let run = folder.run(&[
        "exec",
        "pump",
        "--set",
        "Stop=1",
        "--set",
        "Start=1",
        "--at",
        "1s",
        "Start=0",
        "--for",
        "5s",
        "--show",
        "Motor,Lamp",
    ]);
    assert_eq!(run.code(0).stdout, "Motor = 1\nLamp  = 1\n");
    folder.run(&["run", "pump", "--for", "100ms"]).code(0).stdout("RUN: ran for 100 ms");
    folder.run(&["run", "pump", "--speed", "max", "--for", "1h", "--cycle", "1s", "--json"]).code(0).stdout("\"scans\":3600");
    folder.run(&["symbols", "pump/symbols.csv"]).code(0).stdout("Technological name").stdout("K1");
    folder.run(&["fmt", "--check", "pump"]).code(0);
    folder.run(&["new", "pump"]).code(2).stderr("P6014");
    assert!(folder.read("pump/README.md").starts_with(b"# pump\n"));
}

#[test]
fn a_project_file_is_checked_key_by_key() {
    let toml = "[project]\nsuorces = [\"src/*.awl\"]\nsources = [\"../x.awl\", \"src/mian.awl\", \"src/*.awl\"]\n[cpu]\ntype = \"315\"\nretain = { m = \"0..4095\" }\n";
    let folder = Folder::with(&[("sieben.toml", toml), ("src/main.awl", ADD)]);
    let run = folder.run(&["check", "--json"]).code(3);
    let list = run.json();
    let codes: Vec<&str> = list.as_array().expect("a list").iter().filter_map(|item| item["code"].as_str()).collect();
    assert_eq!(codes, ["P6008", "P6010", "P6011", "P6009", "P6030"]);
    assert_eq!(list[0]["file"], "sieben.toml");
    assert_eq!((&list[0]["line"], &list[0]["column"], &list[0]["end_column"]), (&2.into(), &1.into(), &8.into()));
    assert_eq!(list[0]["fix"]["replacement"], "sources");
    folder.run(&["check"]).code(3).stderr("P6008").stderr("sieben explain P6").stderr("3 errors, 2 warnings");
}

#[cfg(unix)]
#[test]
fn a_project_reads_no_link_that_leads_out_of_it() {
    use std::os::unix::fs::symlink;
    let folder = Folder::with(&[("secret.awl", "SECRET"), ("p/src/main.awl", "L 1\n")]);
    let link = |target: &str, name: &str| symlink(target, folder.path().join(name)).expect("a link");
    link("main.awl", "p/src/same.awl");
    link("..", "p/src/round");
    folder.run(&["check", "p"]).code(0);
    link("../../secret.awl", "p/src/out.awl");
    for toml in ["", "[project]\nsources = [\"src/*.awl\"]\n"] {
        folder.write("p/sieben.toml", toml.as_bytes());
        let run = folder.run(&["check", "p"]).code(3).stderr("P6010").stderr("out.awl` is a link to a file outside");
        assert!(!run.stderr.contains("SECRET"));
    }
}

#[test]
fn a_read_only_file_stays_as_it_is() {
    let folder = Folder::with(&[("main.awl", "L 1\n")]);
    let path = folder.path().join("main.awl");
    let mut permissions = std::fs::metadata(&path).expect("the file").permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&path, permissions).expect("a read-only file");
    folder.run(&["fmt", "--write", "main.awl"]).code(2).stderr("P6013").stderr("read-only");
    assert_eq!(folder.read("main.awl"), b"L 1\n");
}

#[test]
fn words_of_other_languages_are_answered_with_those_of_stl() {
    let folder = Folder::with(&[("en.awl", "A I 0.0\nTON T 1\nIF\n"), ("de.awl", "U E 0.0\nADD\nJMPC m1\n= A 0.0\n")]);
    folder.run(&["check", "en.awl"]).code(3).stderr("n STL this is `SD`").stderr("looks like Structured Text");
    folder.run(&["check", "de.awl"]).code(3).stderr("n STL this is `+I` or `+D` or `+R`").stderr("n STL this is `SPB`");
}

#[test]
fn diagnostics_have_places_and_a_count() {
    let folder = Folder::with(&[("bad.awl", "A I 0.0\r\nFOO M 1.0\r\n= Q 0.0\r\n")]);
    let run = folder.run(&["check", "bad.awl", "--json"]).code(3);
    let list = run.json();
    assert_eq!(list[0]["file"], "bad.awl");
    assert_eq!(list[0]["line"], 2);
    assert_eq!(list[0]["column"], 1);
    assert_eq!(list[0]["severity"], "error");
    assert!(list[0]["message"].as_str().is_some_and(|text| text.contains("FOO")));
    folder.run(&["check", "bad.awl"]).code(3).stderr("bad.awl:2:1").stderr("1 error. `sieben explain").stderr("FOO M 1.0");
    folder.run(&["exec", "bad.awl", "--show", "Q0.0"]).code(3);
}

#[test]
fn code_pages_and_line_ends_survive_every_rewriting() {
    let folder = Folder::new();
    // "// Ventil öffnen" in code page 1252, with the line ends of DOS.
    let german = b"      U     E 0.0; // Ventil \xF6ffnen\r\n      =     A 4.0;\r\n";
    folder.write("ventil.awl", german);
    folder.run(&["convert", "ventil.awl", "--mnemonics", "en", "--write"]).code(0);
    let english = folder.read("ventil.awl");
    assert!(english.windows(11).any(|bytes| bytes == b"Ventil \xF6ffn"), "{english:?}");
    assert!(english.windows(5).any(|bytes| bytes == b"Q 4.0"));
    assert_eq!(english.iter().filter(|&&byte| byte == b'\n').count(), 2);
    assert_eq!(english.iter().filter(|&&byte| byte == b'\r').count(), 2);
    folder.run(&["convert", "ventil.awl", "--mnemonics", "de", "--write"]).code(0);
    assert_eq!(folder.read("ventil.awl"), german);
    folder.run(&["fmt", "ventil.awl", "--write"]).code(0);
    let formatted = folder.read("ventil.awl");
    assert!(formatted.contains(&0xF6) && formatted.ends_with(b"\r\n"));
    folder.run(&["fmt", "ventil.awl", "--check"]).code(0);
    folder.run(&["fmt", "ventil.awl", "--write", "--utf8"]).code(0);
    assert!(String::from_utf8(folder.read("ventil.awl")).is_ok_and(|text| text.contains("öffnen")));
}

#[test]
fn the_code_page_is_the_users_choice_where_the_guess_is_wrong() {
    let folder = Folder::new();
    // `ů` of code page 1250 is `ù` in 1252.
    folder.write("s.sdf", b"\"Pr\xf9chod\",\"I 0.0\",\"BOOL\",\"\"\r\n");
    folder.write("main.awl", b"A \"Pr\xf9chod\"\r\n= Q 0.0 // Pr\xf9chod\r\n");
    folder.run(&["symbols", "s.sdf", "--encoding", "cp1252", "--csv"]).code(0).stdout("Prùchod");
    folder.run(&["symbols", "s.sdf", "--encoding", "cp1250", "--csv"]).code(0).stdout("Průchod");
    folder.run(&["check", ".", "--encoding", "windows-1250"]).code(0);
    folder.run(&["convert", "--mnemonics", "de", "main.awl", "--encoding", "1250", "--utf8"]).code(0).stdout("U \"Průchod\"");
    folder.run(&["convert", "--mnemonics", "de", "main.awl", "--encoding", "1250", "-o", "de.awl"]).code(0);
    assert_eq!(folder.read("de.awl"), b"U \"Pr\xf9chod\"\r\n= A 0.0 // Pr\xf9chod\r\n");
    folder.run(&["check", "main.awl", "--encoding", "latin"]).code(2).stderr("is no encoding of source files; there are utf-8");
}

#[test]
fn symbol_tables_change_their_format() {
    let folder = Folder::with(&[("s.csv", "symbol,address,type,comment,number,unit,tag,remark\nStart,I 0.0,BOOL,Größe,1,-,S1,x\n")]);
    folder.run(&["symbols", "s.csv", "--to", "sdf", "-o", "s.sdf"]).code(0);
    let sdf = folder.read("s.sdf");
    assert!(sdf.windows(5).any(|bytes| bytes == b"Gr\xF6\xDFe"));
    folder.run(&["symbols", "s.sdf", "--to", "csv"]).code(0).stdout("Start,I").stdout("Größe");
    folder.run(&["symbols", "s.csv", "--csv"]).code(0).stdout("No.,Address,Unit,Technological name,Description,Remark");
    folder.run(&["symbols", "s.csv", "--json"]).code(0).stdout("\"technological_name\": \"S1\"");
    folder.write("other.csv", b"symbol,address\nSTART,I 0.1\n");
    folder.write("main.awl", b"A \"Start\"\n= Q 0.0\n");
    folder
        .run(&["check", "main.awl", "s.csv", "other.csv"])
        .code(3)
        .stderr("`START` is `I 0.1` in `other.csv` and `I 0.0` in another symbol table");
    folder.run(&["check", "main.awl", "s.csv", "s.sdf"]).code(0);
    for (name, begin) in [("x.sdf", "\"Start"), ("x.ASC", "126,Start"), ("x.csv", "symbol,"), ("x.html", "<!"), ("x.txt", "No.")] {
        folder.run(&["symbols", "s.csv", "-o", name]).code(0);
        assert!(folder.read(name).starts_with(begin.as_bytes()), "{name}");
    }
    folder.run(&["symbols", "s.csv", "--to", "asc", "-o", "/nowhere/x.asc"]).code(2).stderr("P6013");
}

#[test]
fn explain_knows_instructions_problems_and_cpu_types() {
    let folder = Folder::new();
    for (word, expected) in [
        ("SPB", "JC (English), SPB (German)"),
        ("jc", "Jumps if the RLO is 1"),
        ("A(", "Opens a bracket"),
        ("+I", "16-bit"),
        ("-I", "16-bit"),
        ("SE", "Careful"),
        ("p6001", "P6001 (error): a file that cannot be read"),
        ("416-3", "accumulators          4"),
        ("cpu", "417-4"),
        ("sfc46", "SFC 46 \"STP\""),
        ("stp", "no parameters"),
        ("blkmov", "  OUT     DSTBLK          ANY\n"),
        ("sfc6", "  OUT     TOP_SI          STRUCT\n"),
        ("ton", "  IN      PT              TIME\n"),
        ("16#4562", "OB 121 is not loaded"),
        ("problems", "P2001"),
        ("rlo", "RLO, a bit of the status word"),
        ("BIE", "BR, a bit of the status word"),
        ("ob121", "OB 121, an organization block"),
        ("OB 35", "  priority    12\n  not loaded  OB 85 is called, when it is to start\n  interval    100 ms"),
        ("OB 82", "  not loaded  STOP with 16#456A"),
        ("ob", "OB 40 to 47   hardware interrupt"),
        ("system", "SFC 20   BLKMOV     Copies an area of memory"),
        ("SFC 12", "it needs a CPU with a DP master"),
        ("FB 41", "FB 41 \"CONT_C\", a block of the library"),
        ("instructions", "SPBN"),
    ] {
        folder.run(&["explain", word]).code(0).stdout(expected);
    }
    folder.run(&["explain", "OB 9"]).code(2).stderr("nothing is known about `OB 9`");
    folder.run(&["explain", "315"]).code(2).stderr("id you mean `315-2PN/DP`?");
}

#[test]
fn every_problem_and_every_instruction_can_be_explained() {
    let folder = Folder::new();
    let list = folder.run(&["explain", "problems"]).code(0).stdout;
    assert_eq!(list.lines().count(), sieben_model::problems::Problem::ALL.len());
    for row in sieben_lang::stl::instructions::Instruction::ALL.iter().step_by(7) {
        folder.run(&["explain", row.german()]).code(0).stdout(row.doc());
    }
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let folder = Folder::with(&[("add.awl", ADD)]);
    let mut child = sieben(folder.path(), &["exec", "add.awl", "--scans", "100000", "--every", "--show", "MW4"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the binary ends");
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported() {
    let folder = Folder::with(&[("add.awl", ADD)]);
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has /dev/full");
    let output = sieben(folder.path(), &["exec", "add.awl", "--show", "MW4"]).stdout(full).output().expect("the binary starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("P6013"));
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_a_run_cleanly() {
    let folder = Folder::with(&[("add.awl", ADD), ("loop.awl", "M001: NOP 0\nJU M001\n")]);
    for speed in ["1x", "2x", "max"] {
        let mut child = sieben(folder.path(), &["run", "add.awl", "--speed", speed])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the binary starts");
        // The first line says that Ctrl-C is watched.
        let mut stderr = BufReader::new(child.stderr.take().expect("stderr is a pipe"));
        let mut line = String::new();
        stderr.read_line(&mut line).expect("UTF-8 on stderr");
        assert!(line.starts_with("Running on a CPU 315-2PN/DP, cycle 10 ms; Ctrl-C stops."), "{line}");
        let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill exists");
        assert!(killed.success());
        let output = child.wait_with_output().expect("the binary ends");
        assert_eq!(output.status.code(), Some(0), "{speed}");
        assert!(String::from_utf8_lossy(&output.stdout).contains("stopped by Ctrl-C"), "{speed}");
    }
    folder.run(&["run", "loop.awl", "--speed", "max", "--for", "1s"]).code(4).stdout("STOP");
}

const REFERENCES: &str = "\
FUNCTION FC 1 : VOID
BEGIN
L MW 10
T MW [MD 20]
END_FUNCTION
FUNCTION FC 2 : VOID
BEGIN
UC FC 1
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
A \"Start <1>\"
S M 10.3
CC FC 1
CALL SFC 46
END_ORGANIZATION_BLOCK
";

#[test]
fn reference_data_is_printed_as_text_json_and_a_page() {
    let table = "symbol,address,type,comment\nStart <1>,I 0.0,BOOL,a & b\nSpare,M 90.0,BOOL,\n";
    let folder = Folder::with(&[("main.awl", REFERENCES), ("symbols.csv", table)]);
    for arguments in [&["refs"][..], &["refs", "--unused"], &["structure"], &["assignments"]] {
        let run = folder.run(arguments).code(0);
        assert_eq!(run.stderr, "", "warnings are no matter of {arguments:?}");
        let html = folder.run(&[arguments, &["--html"]].concat()).code(0).stdout("<!DOCTYPE html>").stdout("</html>").stdout;
        assert_eq!(html.matches("<tr>").count(), html.matches("</tr>").count());
        assert!(!html.contains("http") && !html.contains("<script") && !html.contains("Start <1>"), "{html}");
        assert!(!folder.run(&[arguments, &["--json"]].concat()).code(0).json().is_null());
    }
    folder.run(&["refs"]).stdout("I 0.0         Start <1>  R     OB 1").stdout("MW [MD 20] *             W     FC 1");
    folder.run(&["refs", "--html", "-o", "refs.html"]).code(0);
    assert!(String::from_utf8(folder.read("refs.html")).expect("a page is UTF-8").contains("<td>Start &lt;1&gt;</td>"));
    let json = folder.run(&["refs", "MW10", "--overlaps", "--json"]).code(0).json();
    assert_eq!(json[0]["overlaps"], serde_json::json!(["M 10.3"]));
    assert_eq!((&json[1]["address"], &json[1]["references"][0]["type"]), (&"M 10.3".into(), &"W".into()));
    let json = folder.run(&["structure", "--json"]).code(0).json();
    assert_eq!((&json["not_called"], &json["blocks"]["OB 1"]["path_depth"]), (&serde_json::json!(["FC 2"]), &2.into()));
    folder.run(&["symbols", "symbols.csv", "--html"]).code(0).stdout("<title>Assignment table</title>").stdout("a &amp; b");
}

#[test]
fn a_chain_of_calls_of_any_length_is_printed() {
    let mut program = String::from("ORGANIZATION_BLOCK OB 1\nBEGIN\nUC FC 1\nEND_ORGANIZATION_BLOCK\n");
    for number in 1..=3000 {
        program.push_str(&format!("FUNCTION FC {number} : VOID\nBEGIN\nUC FC {}\nEND_FUNCTION\n", number % 3000 + 1));
    }
    let folder = Folder::with(&[("chain.awl", &program)]);
    let run = folder.run(&["structure", "chain.awl"]).code(0).stdout("(3000) FC 3000").stdout("recursion");
    assert!(run.stdout.lines().all(|line| line.chars().count() < 200));
}

#[test]
fn references_are_asked_for_by_address_symbol_and_variable() {
    let program = "\
DATA_BLOCK DB 5
STRUCT
 level : INT;
END_STRUCT
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP
 info : ARRAY [0..19] OF BYTE;
 help : INT;
END_VAR
BEGIN
U E 0.0
L \"Data\".level
T #help
END_ORGANIZATION_BLOCK
";
    let folder = Folder::with(&[
        ("main.awl", program),
        ("symbols.csv", "symbol,address,type\nStart,E 0.0,BOOL\nData,DB 5,DB 5\nSpare,M 1.0,BOOL\n"),
    ]);
    for (name, address) in [
        ("e0.0", "E 0.0"),
        ("I 0.0", "E 0.0"),
        ("%I0.0", "E 0.0"),
        ("start", "E 0.0"),
        ("\"Start\"", "E 0.0"),
        ("DB5", "DB5.DBW 0"),
        ("Data", "DB5.DBW 0"),
        ("DB5.DBW0", "DB5.DBW 0"),
        ("data.level", "DB5.DBW 0"),
        ("\"Data\".level", "DB5.DBW 0"),
        ("#help", "#help"),
        ("help", "#help"),
    ] {
        let json = folder.run(&["refs", ".", name, "--json"]).code(0).json();
        assert_eq!(json.as_array().map(Vec::len), Some(1), "{name}");
        assert_eq!(json[0]["address"], address, "{name}");
    }
    folder.run(&["refs", "MW 100"]).code(0).stdout("MW 100 is not used in this program.");
    folder.run(&["refs", "Spare"]).code(0).stdout("Spare is not used in this program.");
    folder.run(&["refs", "man.awl"]).code(2).stderr("neither a file nor an address, symbol or variable");
    folder.run(&["refs", ".", " "]).code(2).stderr("P7003");
    folder.run(&["refs", "--unused", "Start"]).code(2).stderr("P7001");
    folder.write("bad.awl", b"A \"Strat\"\n");
    folder.run(&["refs", "bad.awl"]).code(3).stderr("P3020");
}

#[test]
fn names_may_be_longer_than_any_column() {
    let long = "b".repeat(70_000);
    let symbols = format!("Symbol,Address,Type,Comment\n{long},M 1.1,BOOL,{long}\n");
    let folder = Folder::with(&[("one.awl", "SET;\n= M 1.1;\n"), ("symbols.csv", &symbols)]);
    let shown = format!("\"{long}\",M1.1");
    folder.run(&["exec", "one.awl", "symbols.csv", "--show", &shown]).code(0).stdout("bbb\" = 1");
    folder.run(&["symbols", "symbols.csv"]).code(0).stdout("M 1.1");
    folder.run(&["refs", "one.awl", "symbols.csv", "--overlaps"]).code(0).stdout("M 1.1");
}

#[test]
fn check_fix_mends_what_can_mean_only_one_thing() {
    // Windows line ends, an umlaut of code page 1252, a word of the other language, misprints and a label that is too long.
    let folder = Folder::with(&[]);
    folder.write("old.awl", b"O I 0.0;\r\nU I 0.1; // gr\xFCn\r\nA I 0,2;\r\nJC weiter;\r\n= Q 0.1;\r\nweiter: NOP 0;\r\n");
    let run = folder.run(&["check", "--fix", "old.awl"]).code(0);
    assert!(run.stdout.contains("old.awl:2:1: wrote `A` for `U`"), "{}", run.stdout);
    assert!(run.stdout.contains("old.awl:3:6: wrote `.` for `,`"), "{}", run.stdout);
    assert_eq!(folder.read("old.awl"), b"O I 0.0;\r\nA I 0.1; // gr\xFCn\r\nA I 0.2;\r\nJC weit;\r\n= Q 0.1;\r\nweit: NOP 0;\r\n");
    folder.run(&["check", "--fix", "old.awl"]).code(0).stdout("no errors");

    // What is left is reported; a guess is not applied.
    folder.write("names.awl", b"FUNCTION FC 1 : VOID\nVAR_TEMP\n level : INT;\nEND_VAR\nBEGIN\nL #levle;\nL 1,5;\nEND_FUNCTION\n");
    folder.run(&["check", "--fix", "names.awl"]).code(3).stdout("wrote `.` for `,`").stderr("P3001");
    assert!(folder.read("names.awl").starts_with(b"FUNCTION FC 1 : VOID\nVAR_TEMP\n level : INT;\nEND_VAR\nBEGIN\nL #levle;\nL 1.5;\n"));

    // A file with bytes that its encoding does not have stays as it is.
    folder.write("broken.awl", b"\xEF\xBB\xBFA I 0,2; // \xFF\n");
    folder.run(&["check", "--fix", "broken.awl"]).code(2).stderr("P1102");
    assert_eq!(folder.read("broken.awl"), b"\xEF\xBB\xBFA I 0,2; // \xFF\n");

    // A negative time is a wrong time, not an unknown flag.
    folder.run(&["exec", "old.awl", "--for", "-1s"]).code(2).stderr("`-1s` is not a duration");
    folder.run(&["run", "old.awl", "--speed", "-1x"]).code(2).stderr("`-1x` is no speed");
    // JSON stays JSON when there is nothing to check.
    let run = folder.run(&["check", "--json", "nowhere.awl"]).code(2);
    let list: serde_json::Value = serde_json::from_str(&run.stdout).expect("a list");
    assert_eq!((&list[0]["code"], &list[0]["severity"]), (&"P6001".into(), &"error".into()), "{list}");

    // An encoding that nobody could guess.
    let utf16 = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    folder.write("wide.awl", &utf16("A I 0,2; // \u{fc}\r\n"));
    folder.run(&["check", "--fix", "wide.awl", "--encoding", "utf-16le"]).code(0).stdout("wrote `.` for `,`");
    assert_eq!(
        folder.read("wide.awl")[..].strip_prefix(b"\xFF\xFE".as_slice()).unwrap_or(&folder.read("wide.awl")),
        utf16("A I 0.2; // \u{fc}\r\n")
    );
}

#[test]
fn files_of_twincat_are_checked_run_and_fixed_where_they_lie() {
    let pou = |name: &str, declaration: &str, body: &str, members: &str| {
        format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<TcPlcObject Version=\"1.1.0.1\">\r\n  <POU Name=\"{name}\">\r\n    <Declaration><![CDATA[{declaration}]]></Declaration>\r\n    \
             <Implementation>\r\n      <ST><![CDATA[{body}]]></ST>\r\n    </Implementation>\r\n{members}  </POU>\r\n</TcPlcObject>\r\n"
        )
    };
    let method = "    <Method Name=\"Twice\">\r\n      <Declaration><![CDATA[METHOD Twice : INT]]></Declaration>\r\n      <Implementation>\r\n        \
        <ST><![CDATA[Twice := 2 * n;]]></ST>\r\n      </Implementation>\r\n    </Method>\r\n    <Action Name=\"Clear\">\r\n      <Implementation>\r\n        \
        <ST><![CDATA[n := 0;]]></ST>\r\n      </Implementation>\r\n    </Action>\r\n";
    let folder = Folder::with(&[]);
    folder.write("FB_Pump.TcPOU", pou("FB_Pump", "FUNCTION_BLOCK FB_Pump\r\nVAR n : INT; END_VAR", "n := n + 1;", method).as_bytes());
    let main = |sign: &str| pou("MAIN", "PROGRAM MAIN\r\nVAR p : FB_Pump; t : INT; END_VAR", &format!("p();\r\nt {sign} p.Twice();"), "");
    folder.write("MAIN.TcPOU", main("=:").as_bytes());
    folder.run(&["check", "."]).code(3).stderr("MAIN.TcPOU:8:3");
    folder.run(&["check", "--fix", "."]).code(0).stdout("MAIN.TcPOU:8:3: wrote `:=` for `=:`");
    assert_eq!(folder.read("MAIN.TcPOU"), main(":=").as_bytes());
    folder.run(&["exec", ".", "--scans", "3", "--show", "MAIN.t"]).code(0).stdout("= 6");
    folder.run(&["fmt", "--write", "."]).code(3).stderr("P6080");
    assert_eq!(folder.read("MAIN.TcPOU"), main(":=").as_bytes());
}

#[test]
fn an_error_in_a_judged_dialect_names_the_one_that_takes_the_program() {
    let folder = Folder::with(&[]);
    let source = "PROGRAM Main\nVAR n : INT; END_VAR\nIF n = 3 THEN\n  n := 4;\nEND_IF\nEND_PROGRAM\n";
    folder.write("main.st", source.as_bytes());
    folder.run(&["check", "main.st"]).code(3).stderr("P6053").stderr("`--dialect codesys` takes it.");
    let chosen = folder.run(&["check", "main.st", "--dialect", "iec"]).code(3);
    assert!(!chosen.stderr.contains("takes it"), "{}", chosen.stderr);
    folder.write("main.st", source.replace("n := 4", "n := m").as_bytes());
    let wrong = folder.run(&["check", "main.st"]).code(3);
    assert!(!wrong.stderr.contains("takes it"), "{}", wrong.stderr);
}

#[test]
fn exec_check_temp_names_what_was_read_without_a_value() {
    let program = "\
FUNCTION FC 1 : VOID
VAR_INPUT
 in : INT;
END_VAR
VAR_OUTPUT
 out : INT;
END_VAR
BEGIN
L #in; T MW 0;
A I 0.0; JCN end; L 5; T #out;
end: NOP 0;
END_FUNCTION
DATA_BLOCK DB 1
STRUCT
 value : INT;
END_STRUCT;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP
 info : ARRAY[1..20] OF BYTE;
 given : INT;
 copied : ARRAY[1..2] OF INT;
 bits : BYTE;
END_VAR
BEGIN
L #info[4]; L LD 16;
CALL FC 1 (in := #given, out := DB1.value);
CALL SFC 20 (SRCBLK := P#M 0.0 INT 2, RET_VAL := MW 10, DSTBLK := #copied);
L #copied[2]; T MW 12;
LAR1 P##copied; L 7; T W [AR1,P#0.0]; L #copied[1]; T MW 14;
SET; = L 26.3; A L 26.3; = M 20.0; A L 26.4; = M 20.1;
END_ORGANIZATION_BLOCK
";
    let folder = Folder::with(&[("main.awl", program)]);
    let run = folder.run(&["exec", "main.awl", "--check-temp", "--scans", "2"]).code(1);
    for part in [
        "`#given` of `OB 1` was read 2 times before it was written",
        "main.awl:9:1",
        "a parameter of a block that `OB 1` has called was read 2 times before it was written",
        "main.awl:28:1",
        "`#bits` of `OB 1` was read 2 times before it was written",
        "3 warnings",
    ] {
        assert!(run.stderr.contains(part), "{part}\n{}", run.stderr);
    }
    let json = folder.run(&["exec", "main.awl", "--check-temp", "--set", "I0.0=1", "--json"]).code(1);
    assert_eq!(json.stderr.matches("P4024").count(), 2, "{}", json.stderr);
    folder.run(&["exec", "main.awl", "--scans", "2"]).code(0);
}

#[test]
fn diagnostics_have_four_forms() {
    let folder = Folder::with(&[("a,b.awl", "A I 0.0\nA I O.1\nL xyz\n"), ("ok.awl", "A I 0.0\n= Q 0.0\n")]);
    let concise = folder.run(&["check", "a,b.awl", "--output-format", "concise"]).code(3);
    let lines: Vec<&str> = concise.stdout.lines().collect();
    assert!(lines.len() == 2 && lines[0].starts_with("a,b.awl:2:5: error[P1005]: "), "{}", concise.stdout);
    let github = folder.run(&["check", "a,b.awl", "--output-format", "github"]).code(3);
    assert!(
        github.stdout.starts_with("::error file=a%2Cb.awl,line=2,col=5,title=P1005%3A a character that only looks like the right one::"),
        "{}",
        github.stdout
    );
    assert_eq!(github.stdout.lines().count(), 2);
    let json = folder.run(&["check", "a,b.awl", "--output-format", "json"]).code(3);
    assert_eq!(json.stdout, folder.run(&["check", "a,b.awl", "--json"]).code(3).stdout);
    folder.run(&["check", "a,b.awl", "--output-format", "text"]).code(3).stderr("[P1005] Error: ");
    for form in ["concise", "github"] {
        let clean = folder.run(&["check", "ok.awl", "--output-format", form]).code(0).stderr("no errors, no warnings");
        assert_eq!(clean.stdout, "");
        let missing = folder.run(&["check", "nowhere.awl", "--output-format", form]).code(2).stdout("P6001");
        assert_eq!(missing.stderr, "");
        folder.run(&["check", "ok.awl", "--against", "ok.awl", "--output-format", form]).code(2).stdout("P7001");
    }
    folder.run(&["check", "ok.awl", "--json", "--output-format", "concise"]).code(2).stdout("cannot be used with");
    folder.run(&["check", "ok.awl", "--fix", "--output-format", "json"]).code(2).stdout("P7001");
    folder.run(&["check", "ok.awl", "--output-format", "xml"]).code(2).stderr("possible values: text, json, concise, github");
}

#[test]
fn without_a_terminal_the_bare_binary_prints_its_help() {
    let folder = Folder::new();
    let bare = folder.run(&[]).code(0).stdout("Usage: sieben").stdout("Without a command Sieben starts the demo plant");
    assert_eq!((bare.stderr.as_str(), &bare.stdout), ("", &folder.run(&["--help"]).stdout));
}

/// Where a new project says where something is, it is there.
#[test]
fn a_new_project_names_no_address() {
    let folder = Folder::new();
    let examples =
        ["car-park", "conveyor", "decade-switches", "dosing", "elevator", "heater", "packing", "star-delta", "tank", "traffic-light"];
    let languages = ["stl", "st", "scl"].map(|language| ("--language", language));
    for (index, (option, value)) in examples.map(|example| ("--example", example)).into_iter().chain(languages).enumerate() {
        let name = format!("project{index}");
        folder.run(&["new", &name, option, value]).code(0);
        let mut folders = vec![folder.path().join(&name)];
        while let Some(inner) = folders.pop() {
            for entry in fs::read_dir(inner).expect("a folder") {
                let path = entry.expect("an entry").path();
                if path.is_dir() {
                    folders.push(path);
                    continue;
                }
                let text = fs::read_to_string(&path).expect("text");
                assert!(!text.contains("://"), "{}", path.display());
            }
        }
    }
}

/// A project with a file of diagrams, and a statement list some of whose networks are diagrams.
const DRAWN: &[(&str, &str)] = &[
    ("sieben.toml", "[project]\nname = \"drawn\"\nsources = [\"*.lad\", \"*.awl\"]\nsymbols = [\"symbols.csv\"]\n"),
    ("symbols.csv", "symbol,address,type,comment\nStart,I 0.0,BOOL,\nStop,I 0.1,BOOL,\nPump,Q 4.0,BOOL,\n"),
    (
        "main.lad",
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nTITLE = Pump\n    OR\n        NO  \"Start\"\n    OR\n        NO  \"Pump\"\n    END\n    NC    \"Stop\"\n\
         \x20   COIL  \"Pump\"\nNETWORK FBD\n    CALL FC 1\n        go := \"Pump\"\n        count => MW 10\nEND_ORGANIZATION_BLOCK\n",
    ),
    (
        "count.awl",
        "FUNCTION FC 1 : VOID\nVAR_INPUT\n  go : BOOL;\nEND_VAR\nVAR_OUTPUT\n  count : INT;\nEND_VAR\nBEGIN\nNETWORK LAD\n    NO  #go\n    P   M 0.0\n\
         \x20   ADD_I MW 20, 1 => MW 20\nNETWORK\n      L     MW 20;\n      T     #count;\nNETWORK FBD\n    XOR\n        NO  I 0.2\n    XOR\n        NO  I 0.3\n    END\n\
         \x20   COIL  Q 4.1\nEND_FUNCTION\n",
    ),
];

#[test]
fn a_project_with_diagrams_is_checked_run_and_listed() {
    let folder = Folder::with(DRAWN);
    folder.run(&["check"]).code(0).stdout("2 blocks in 2 sources, no errors, no warnings.");
    let show = ["--show", "Pump,MW10,Q4.1"];
    let run = folder.run(&[&["exec", ".", "--set", "Start=1", "--set", "I0.3=1", "--scans", "3"], &show[..]].concat()).code(0);
    assert_eq!(run.stdout, "Pump = 1\nMW10 = 16#0001\nQ4.1 = 1\n");

    // References have the place and the words of the element.
    let refs = folder.run(&["refs", "--json"]).code(0).json();
    let all: Vec<String> = refs
        .as_array()
        .expect("a list")
        .iter()
        .flat_map(|address| address["references"].as_array().expect("a list"))
        .map(|one| {
            format!(
                "{}:{} {} {}",
                one["file"].as_str().unwrap_or_default(),
                one["line"],
                one["type"].as_str().unwrap_or_default(),
                one["text"].as_str().unwrap_or_default()
            )
        })
        .collect();
    for wanted in [
        "main.lad:6 R NO \"Start\"",
        "main.lad:10 R NC \"Stop\"",
        "main.lad:11 W COIL \"Pump\"",
        "main.lad:13 call CALL FC 1",
        "count.awl:11 RW P M 0.0",
        "count.awl:18 R NO I 0.2",
        "count.awl:22 W COIL Q 4.1",
    ] {
        assert!(all.iter().any(|one| one.starts_with(wanted)), "{wanted}: {all:#?}");
    }

    // What is wrong is said at its element, once.
    let whole = DRAWN[2].1;
    for (wrong, wanted) in [
        (whole.replace("NC    \"Stop\"", "NC    \"Stopp\""), ("P3020", 10, 11)),
        (whole.replace("    COIL  ", "    COLL  "), ("P2401", 11, 5)),
        (whole.replace("    END\n", ""), ("P2404", 5, 5)),
        (whole.replace("    COIL  \"Pump\"\n", ""), ("P2404", 10, 5)),
        (whole.replace("go := \"Pump\"", "go := MW 2"), ("P4011", 14, 15)),
    ] {
        folder.write("main.lad", wrong.as_bytes());
        let found = folder.run(&["check", "--json"]).code(3).json();
        let place = |one: &serde_json::Value, key: &str| one[key].as_u64().expect("a number");
        let found: Vec<(&str, u64, u64)> = found
            .as_array()
            .expect("a list")
            .iter()
            .map(|one| (one["code"].as_str().expect("a code"), place(one, "line"), place(one, "column")))
            .collect();
        assert_eq!(found, [wanted], "{wrong}");
    }
}

#[test]
fn diagrams_are_formatted_and_change_their_mnemonics() {
    let folder = Folder::with(DRAWN);
    // Order of the lines, comments and the byte order mark stay; tabs, CR LF and ragged columns do not matter.
    folder.write("main.lad", "\u{feff}NETWORK\r\n\tNO I 0.0// a\r\n\t// b\r\n\tCOIL   Q 4.0\r\n".as_bytes());
    folder.run(&["fmt", "--check", "main.lad"]).code(1);
    folder.run(&["fmt", "--write", "main.lad"]).code(0);
    let wanted = "\u{feff}NETWORK\r\n    NO  I 0.0  // a\r\n    // b\r\n    COIL  Q 4.0\r\n";
    assert_eq!(String::from_utf8(folder.read("main.lad")).expect("UTF-8"), wanted);
    folder.run(&["fmt", "--check", "main.lad"]).code(0);

    folder.run(&["convert", "--mnemonics", "de", "--write", "main.lad", "count.awl"]).code(0);
    assert_eq!(String::from_utf8(folder.read("main.lad")).expect("UTF-8"), wanted.replace("I 0.0", "E 0.0").replace("Q 4.0", "A 4.0"));
    let german = String::from_utf8(folder.read("count.awl")).expect("UTF-8");
    assert!(german.contains("NO  E 0.2") && german.contains("COIL  A 4.1") && german.contains("ADD_I MW 20, 1 => MW 20"), "{german}");
    folder.run(&["exec", "main.lad", "--mnemonics", "de", "--set", "E0.0=1", "--show", "A4.0"]).code(0).stdout("A4.0 = 1");
    folder.run(&["convert", "--mnemonics", "en", "--write", "main.lad", "count.awl"]).code(0);
    assert_eq!(String::from_utf8(folder.read("main.lad")).expect("UTF-8"), wanted);
    assert_eq!(String::from_utf8(folder.read("count.awl")).expect("UTF-8"), DRAWN[3].1);
}

/// The folder of a program with a label that is missing.
fn jump_to_nowhere() -> Folder {
    Folder::with(&[("lamp.awl", "      A     I 0.0\n      JC    end\n      =     Q 4.0\n")])
}

#[test]
fn german_is_chosen_by_an_option_or_by_the_environment() {
    let folder = jump_to_nowhere();
    let german = "[P3004] Fehler: ein Sprung zu einer Marke, die es nicht gibt: there is no label `end`";
    for arguments in [["check", "lamp.awl", "--lang", "de"], ["--lang", "de", "check", "lamp.awl"]] {
        folder.run(&arguments).code(3).stderr(german).stderr("Hilfe: Die Marke vor eine Anweisung").stderr("1 Fehler. `sieben explain");
    }
    let with = |variables: &[(&str, &str)], arguments: &[&str]| {
        let mut command = sieben(folder.path(), arguments);
        command.env_remove("LC_ALL").env_remove("LC_MESSAGES").env_remove("LANG").envs(variables.iter().copied());
        let output = command.output().expect("the binary starts");
        [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8")).concat()
    };
    let check = ["check", "lamp.awl"];
    assert!(with(&[("LANG", "de_AT.UTF-8")], &check).contains(german));
    assert!(with(&[("LC_MESSAGES", "de_DE"), ("LANG", "C")], &check).contains(german));
    let english = with(&[], &check);
    assert!(english.contains("[P3004] Error: there is no label `end`") && english.contains("Help: Write the label"), "{english}");
    assert_eq!(with(&[("LC_ALL", "C"), ("LANG", "de_DE")], &check), english);
    assert_eq!(with(&[("LANG", "de_DE")], &["check", "lamp.awl", "--lang", "en"]), english);
}

#[test]
fn what_programs_read_stays_english() {
    let folder = jump_to_nowhere();
    for arguments in
        [&["check", "lamp.awl", "--json"][..], &["check", "lamp.awl", "--output-format", "concise"], &["test", "lamp.awl", "--tap"]]
    {
        let of = |locale: &str| sieben(folder.path(), arguments).env("LC_ALL", locale).output().expect("the binary starts").stdout;
        assert_eq!(of("de_DE.UTF-8"), of("C"), "{arguments:?}");
    }
}

#[test]
fn help_and_explanations_are_german() {
    let folder = jump_to_nowhere();
    let run = |arguments: &[&str]| folder.run(arguments);
    run(&["run", "--help", "--lang", "de"]).code(0).stdout("Aufruf: sieben run [OPTIONEN] [PFAD]...").stdout("Exitcodes: 0 in Ordnung");
    run(&["--lang=de", "help", "exec"]).code(0).stdout("Optionen:");
    let title = "P3004 (Fehler): ein Sprung zu einer Marke, die es nicht gibt";
    for arguments in [&["explain", "P3004", "--lang", "de"][..], &["explain", "--lang=de", "P3004"], &["--lang", "de", "explain", "P3004"]]
    {
        run(arguments).code(0).stdout(title).stdout("Die Seite dazu ist englisch:");
    }
    run(&["explain", "problems", "--lang", "de"]).code(0).stdout("P3004  ein Sprung zu einer Marke, die es nicht gibt\n");
    run(&["check", "nowhere.awl", "--lang", "de"]).code(2).stderr("[P6001] Fehler: eine Datei, die nicht gelesen werden kann: ");
    run(&["check", "--lang", "nl"]).code(2).stderr("`nl` is no language of Sieben; there are en and de");
}

#[test]
fn headings_of_tables_are_german_and_their_json_is_not() {
    let folder = Folder::with(&[("lamp.awl", "      A     I 0.0\n      =     Q 4.0\n")]);
    let verbs = [
        ("refs", "Adresse  Symbol", "Querverweisliste"),
        ("structure", "Baustein  Symbol  Aufruf", "Programmstruktur"),
        ("assignments", "Eingänge", "Belegungsplan"),
    ];
    for (verb, heading, title) in verbs {
        folder.run(&[verb, "lamp.awl", "--lang", "de"]).code(0).stdout(heading);
        folder.run(&[verb, "lamp.awl", "--html", "--lang", "de"]).code(0).stdout("<html lang=\"de\">").stdout(title);
        let json = |language| folder.run(&[verb, "lamp.awl", "--json", "--lang", language]).code(0).stdout;
        assert_eq!(json("de"), json("en"));
    }
}
