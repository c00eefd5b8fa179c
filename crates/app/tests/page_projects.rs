//! Pages that change to another example, and the watch tables of a project: real processes, real sockets.
#![cfg(unix)]

mod command;
mod pages;

use std::fs;
use std::os::unix::fs::symlink;
use std::process::Stdio;

use command::{Folder, sieben, until};
use pages::{Page, Serving};
use serde_json::{Value, json};

/// A copy of an example.
fn example(name: &str) -> Folder {
    let folder = Folder::new();
    let from = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    for entry in fs::read_dir(from).expect("the example").flatten() {
        let name = entry.file_name().into_string().expect("UTF-8");
        folder.write(&name, &fs::read(entry.path()).expect("a file"));
    }
    folder
}

fn run(folder: &Folder, arguments: &[&str]) -> Serving {
    let all: Vec<&str> = arguments.iter().chain(&["--page", "127.0.0.1:0"]).copied().collect();
    let mut command = sieben(folder.path(), &all);
    command.env("XDG_RUNTIME_DIR", folder.path());
    Serving::of(command)
}

/// The names of the examples that a project may change to.
fn examples(listed: &Value) -> Vec<&str> {
    listed["examples"].as_array().expect("a list").iter().map(|one| one["name"].as_str().expect("a name")).collect()
}

/// Messages up to the `welcome` of another project: none of them is a scan that was sent after `program`.
fn moved(page: &mut Page) -> (Value, Value) {
    let program = page.until("another program", |message| message["t"] == "program");
    let welcome = page.next().expect("a welcome");
    assert_eq!(welcome["t"], "welcome", "{welcome}");
    (program, welcome)
}

#[test]
fn a_page_of_an_example_changes_to_another_and_everybody_stays() {
    let folder = example("dosing");
    let serving = run(&folder, &["run", ".", "--plain"]);
    let here = folder.path().canonicalize().expect("a folder").display().to_string();
    assert_eq!(serving.json("GET", "/api/v1/project", "")["path"], here);
    let (mut page, mut other) = (serving.page(""), serving.page(""));
    let first = page.next().expect("a welcome");
    assert_eq!(first["project"], "dosing");
    assert_eq!(first["examples"].as_array().expect("a list").len(), 10, "{first}");
    for page in [&mut page, &mut other] {
        page.say(&json!({ "t": "sub", "id": "r", "what": "rows", "block": "OB1", "from": 0, "to": 20 }));
        page.say(&json!({ "t": "sub", "id": "t", "what": "tags", "names": ["LITRES"] }));
    }
    for page in [&mut page, &mut other] {
        page.until("values of dosing", |message| message["s"]["t"].get("LITRES").is_some_and(|value| !value.is_null()));
        page.until("many scans", |message| message["n"].as_u64() > Some(100));
    }
    serving.json("POST", "/api/v1/forces", r#"{"name":"I 0.0","value":"1","reason":"a test"}"#);
    serving.json("PATCH", "/api/v1/tags", r#"{"M 50.0":true}"#);
    assert!(folder.path().join(".sieben").exists(), "retentive data is kept");

    let listed = serving.json("POST", "/api/v1/project", r#"{"example":"star-delta"}"#);
    assert_eq!((listed["name"].as_str(), &listed["path"]), (Some("star-delta"), &Value::Null));
    for page in [&mut page, &mut other] {
        let (program, welcome) = moved(page);
        assert_eq!((program["project"].as_str(), welcome["project"].as_str()), (Some("star-delta"), Some("star-delta")));
        assert_eq!(program["hash"], welcome["program"]);
        assert_eq!(welcome["role"], "program");
        assert_ne!(welcome["program"], first["program"]);
        let scan = page.until("a scan", |message| message["t"] == "scan");
        assert_eq!(scan["s"], json!({}), "the subscriptions have ended: {scan}");
        assert!(scan["n"].as_u64() < Some(100) && scan["oldest"].as_u64() < Some(2), "{scan}");
        page.say(&json!({ "t": "sub", "id": "r", "what": "rows", "block": "FB20", "from": 0, "to": 20 }));
        let rows = page.until("rows of FB 20", |message| message["s"]["r"].is_array());
        assert!(rows["same"] == true && rows["s"]["r"].as_array().expect("rows").len() > 10, "{rows}");
    }
    let oldest = page.until("a scan", |message| message["t"] == "scan")["oldest"].as_u64().expect("a scan");
    page.say(&json!({ "t": "at", "scan": oldest }));
    let past = page.until("the oldest scan", |message| message["live"] == false);
    assert_eq!(past["n"].as_u64(), Some(oldest));

    let state = serving.json("GET", "/api/v1/state", "");
    assert_eq!((state["project"].as_str(), state["run"].as_u64(), state["mode"].as_str()), (Some("star-delta"), Some(1), Some("RUN")));
    assert_eq!(serving.json("GET", "/api/v1/forces", ""), json!([]));
    assert_eq!(serving.json("GET", "/api/v1/tags?names=M50.0", "")["items"][0]["value"], json!(0), "the memory is another one");
    let entries = serving.json("GET", "/api/v1/diagnostics", "");
    assert!(entries["newest"].as_u64() < Some(6), "{entries}");
    assert!(serving.json("GET", "/api/v1/blocks", "").as_array().expect("blocks").iter().any(|block| block["block"] == "FB20"));
    let (_, _, metrics) = serving.ask("GET", "/metrics", "", "");
    let scans = metrics.lines().find_map(|line| line.strip_prefix("sieben_scans_total ")).and_then(|count| count.parse::<f64>().ok());
    assert!(scans.is_some_and(|scans| scans < 2_000.0), "{metrics}");
    let log = fs::read_to_string(folder.path().join(".sieben/audit.log")).expect("a log");
    assert!(log.contains(r#""what":"project","object":"star-delta","result":"ok""#), "{log}");

    // And back; and once more to the same one, which starts from the beginning.
    for name in ["dosing", "dosing", "traffic-light"] {
        let listed = serving.json("POST", "/api/v1/project", &json!({ "example": name }).to_string());
        assert_eq!(listed["name"], name);
        assert_eq!(examples(&listed).len(), 10);
        assert_eq!(moved(&mut other).1["project"], name);
    }
    let (status, _, refused) = serving.ask("POST", "/api/v1/project", "", r#"{"example":"pump"}"#);
    assert!(status == 409 && refused.contains("P7145") && refused.contains("star-delta"), "{refused}");
}

#[test]
fn all_examples_run_where_the_page_changes_to_them() {
    let folder = Folder::new();
    let serving = run(&folder, &["demo", "--speed", "10x"]);
    let listed = serving.json("GET", "/api/v1/project", "");
    assert_eq!((listed["name"].as_str(), &listed["path"]), (Some("dosing"), &Value::Null));
    for name in examples(&listed) {
        serving.json("POST", "/api/v1/project", &json!({ "example": name }).to_string());
        let state = until("it scans", || Some(serving.json("GET", "/api/v1/state", "")).filter(|state| state["scans"].as_u64() > Some(5)));
        assert_eq!((state["project"].as_str(), state["mode"].as_str(), state["speed"].as_str()), (Some(name), Some("RUN"), Some("10x")));
        // Each has a watch table, all of whose rows have values.
        let tables = serving.json("GET", "/api/v1/watch", "");
        assert_eq!(tables, json!([format!("{name}.watch")]));
        let rows = serving.json("GET", &format!("/api/v1/watch/{name}.watch"), "");
        let rows = rows.as_array().expect("rows");
        assert!(rows.len() > 5);
        let names: Vec<Value> = rows
            .iter()
            .map(|row| json!(format!("{},{}", row["name"].as_str().expect("a name"), row["format"].as_str().expect("a format"))))
            .collect();
        let mut page = serving.page("");
        page.say(&json!({ "t": "sub", "id": "t", "what": "tags", "names": names }));
        let message = page.until("its values", |message| message["s"]["t"].is_object());
        let values = message["s"]["t"].as_object().expect("values");
        assert!(values.len() == rows.len() && values.values().all(|value| !value.is_null()), "{name}: {message}");
    }
}

#[test]
fn a_page_of_any_other_project_shows_that_alone() {
    let changed = example("dosing");
    let source = fs::read_to_string(changed.path().join("dosing.awl")).expect("a source");
    changed.write("dosing.awl", format!("{source}\n// mine\n").as_bytes());
    for (folder, arguments) in [
        (&changed, ["run", ".", "--plain"].as_slice()),
        (&example("dosing"), &["serve", "."]),
        (&example("dosing"), &["run", ".", "--plain", "--watch"]),
        (&example("dosing"), &["run", ".", "--plain", "--for", "1h"]),
        (&Folder::new(), &["demo", "--for", "1h"]),
    ] {
        let serving = run(folder, arguments);
        let listed = serving.json("GET", "/api/v1/project", "");
        assert_eq!(examples(&listed), [""; 0], "{arguments:?}");
        let (status, _, refused) = serving.ask("POST", "/api/v1/project", "", r#"{"example":"tank"}"#);
        assert!(status == 409 && refused.contains("P7145"), "{arguments:?}: {refused}");
        let welcome = serving.page("").next().expect("a welcome");
        assert_eq!(welcome["examples"], json!([]), "{arguments:?}");
    }
}

/// The text of the notes among what changed, from the newest on.
fn notes(serving: &Serving) -> Vec<String> {
    let mut page = serving.page("");
    page.say(&json!({ "t": "sub", "id": "c", "what": "changes" }));
    let message = page.until("what changed", |message| message["s"]["c"].is_array());
    message["s"]["c"].as_array().expect("a list").iter().filter_map(|one| Some(one["note"].as_str()?.to_owned())).collect()
}

#[test]
fn the_demo_leaves_a_user_of_a_page_alone_and_a_run_of_its_example_does_not_play() {
    let scans = |serving: &Serving| serving.json("GET", "/api/v1/state", "")["scans"].as_u64().expect("scans");
    let presses = |serving: &Serving| notes(serving).iter().filter(|note| note.contains("presses START")).count();
    for touch in [
        ("PATCH", "/api/v1/tags", r#"{"M 90.0":true}"#),
        ("POST", "/api/v1/press", r#"{"items":["I 0.5"],"ms":100}"#),
        ("POST", "/api/v1/forces", r#"{"name":"I 0.5","value":"1","reason":"a test"}"#),
    ] {
        // So slowly that there is time for a touch before the demo plays.
        let demo = run(&Folder::new(), &["demo", "--speed", "0.05x"]);
        demo.json(touch.0, touch.1, touch.2);
        let touched = scans(&demo);
        assert!(touched < 250, "the machine is too slow for this test: {touched}");
        demo.json("POST", "/api/v1/time", r#"{"speed":50}"#);
        until("twelve seconds of the plant", || (scans(&demo) > 1_200).then_some(()));
        demo.json("POST", "/api/v1/time", r#"{"pause":true}"#);
        if scans(&demo) < 1_950 {
            assert_eq!(presses(&demo), 0, "{touch:?}");
        }
        demo.json("POST", "/api/v1/time", r#"{"go":true}"#);
        until("it plays again", || (presses(&demo) > 0).then_some(()));
    }
    let still = run(&example("dosing"), &["run", ".", "--plain", "--speed", "50x"]);
    until("ten seconds of the plant", || (scans(&still) > 1_000).then_some(()));
    assert_eq!(presses(&still), 0);
}

#[test]
fn watch_tables_are_files_of_the_project_and_nothing_else() {
    let folder = example("tank");
    let long: String = (0..10_000).map(|number| format!("M {}.{},BOOL,row {number}\n", number / 8 % 256, number % 8)).collect();
    folder.write("long.watch", format!("name,format,comment\n{long}").as_bytes());
    folder.write("bad.watch", b"name,format\nMW 10,DEC\nMW 12,DECIMAL\n");
    folder.write("huge.watch", &vec![b'x'; 1024 * 1024 + 1]);
    folder.write("secret.txt", b"name\nA\n");
    folder.write("inner/inner.watch", b"name\nA\n");
    symlink(folder.path().join("secret.txt"), folder.path().join("link.watch")).expect("a link");
    let serving = run(&folder, &["serve", "."]);
    assert_eq!(serving.json("GET", "/api/v1/watch", ""), json!(["bad.watch", "huge.watch", "long.watch", "tank.watch"]));
    let rows = serving.json("GET", "/api/v1/watch/long.watch", "");
    assert_eq!(rows.as_array().expect("rows").len(), 10_000);
    assert_eq!(rows[9], json!({ "name": "M 1.1", "format": "BOOL", "comment": "row 9" }));
    let (status, _, refused) = serving.ask("GET", "/api/v1/watch/bad.watch", "", "");
    assert!(status == 422 && refused.contains("P7146") && refused.contains("`bad.watch`, line 3: `DECIMAL`"), "{refused}");
    let (status, _, refused) = serving.ask("GET", "/api/v1/watch/huge.watch", "", "");
    assert!(status == 422 && refused.contains("1048576 bytes"), "{refused}");
    for name in [
        "link.watch",
        "secret.txt",
        "none.watch",
        "..%2Ftank.watch",
        "inner%2Finner.watch",
        "%2Fetc%2Fpasswd",
        "..",
        ".watch",
        "a%00.watch",
    ] {
        let (status, _, refused) = serving.ask("GET", &format!("/api/v1/watch/{name}"), "", "");
        assert!(status == 404 && refused.contains("P7147"), "{name}: {status} {refused}");
    }
    // A file that comes while it runs is there at once.
    folder.write("new.watch", b"name\nLevel\n");
    assert_eq!(serving.json("GET", "/api/v1/watch/new.watch", "")[0]["name"], "Level");
}

#[test]
fn a_second_run_says_which_port_it_has() {
    let (one, other) = (example("dosing"), example("tank"));
    let begin = |folder: &Folder, name: &str| {
        let mut command = sieben(folder.path(), &["run", ".", "--plain", "--page"]);
        command.stdin(Stdio::null());
        let serving = Serving::of(command);
        assert_eq!(serving.json("GET", "/api/v1/project", "")["name"], name);
        serving
    };
    let (first, second) = (begin(&one, "dosing"), begin(&other, "tank"));
    assert!(first.page.port() != second.page.port() && second.page.port() > 7_300);
}
