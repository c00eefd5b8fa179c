//! The page server of a run: real processes, real sockets.
#![cfg(unix)]

mod command;
mod pages;

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::process::Command;

use command::{Folder, until};
use pages::{Page, Serving};
use serde_json::{Value, json};

const PROJECT: &str = "[project]\nname = \"pump\"\n\n[[module]]\nkind = \"tank\"\ninput = 256\noutput = 256\n";
const PROGRAM: &str = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nTITLE = Counts scans\nL MW 10;\nL 1;\n+I;\nT MW 10;\nNETWORK\nTITLE = Follows\nA M 50.0;\n= M 60.0;\n\
                       NETWORK\nL MW 20;\nT MW 30;\nEND_ORGANIZATION_BLOCK\n";

fn project() -> Folder {
    Folder::with(&[("sieben.toml", PROJECT), ("main.awl", PROGRAM)])
}

/// Rows and values that most tests look at.
fn subscribe(page: &mut Page) {
    page.say(&json!({ "t": "sub", "id": "rows", "what": "rows", "block": "OB1", "from": 0, "to": 20, "reason": 3 }));
    page.say(&json!({ "t": "sub", "id": "tags", "what": "tags", "names": ["MW 10,INT", "M 60.0", "MW 10", "nothing"] }));
}

/// A value that is shown as a number.
fn count(value: &Value) -> Option<u64> {
    value.as_str()?.parse().ok()
}

fn has_both(message: &Value) -> bool {
    message["s"]["rows"].is_array() && message["s"]["tags"].is_object()
}

#[test]
fn all_values_of_a_message_belong_to_one_scan() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let mut page = serving.page("");
    let welcome = page.next().expect("a welcome");
    assert_eq!(
        (welcome["t"].as_str(), welcome["project"].as_str(), welcome["role"].as_str()),
        (Some("welcome"), Some("pump"), Some("program"))
    );
    subscribe(&mut page);
    let (mut row, mut tags, mut offset) = (Value::Null, json!({}), None);
    let mut compared = 0;
    while compared < 30 {
        let message = page.until("the next scan", |message| message["t"] == "scan");
        assert_eq!(message["same"], true, "{message}");
        match &message["s"]["rows"] {
            Value::Array(rows) => row = rows[3].clone(),
            changed => row = changed.get("3").unwrap_or(&row).clone(),
        }
        for (name, value) in message["s"]["tags"].as_object().into_iter().flatten() {
            tags[name] = value.clone();
        }
        let (Some(counted), Some(row_count), Some(scan)) = (count(&tags["MW 10,INT"]), row[3].as_u64(), message["n"].as_u64()) else {
            continue;
        };
        assert_eq!((row[0].as_u64(), row[1].as_u64(), row_count), (Some(8), Some(1), counted), "{message}");
        assert!(row[5].as_str().is_some_and(|reason| reason.ends_with('.')), "{message}");
        assert_eq!(*offset.get_or_insert(counted.wrapping_sub(scan)), counted.wrapping_sub(scan), "{message}");
        compared += 1;
    }
    assert!(tags["MW 10"].as_str().is_some_and(|text| text.starts_with("16#")), "{tags}");
    assert_eq!(tags["nothing"], Value::Null);
}

#[test]
fn a_diagram_shows_what_its_lines_carry() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let drawn = serving.json("GET", "/api/v1/blocks/OB1?view=lad", "");
    let picture = drawn["networks"][1]["svg"].as_str().expect("a picture");
    let mut page = serving.page("");
    page.say(&json!({ "t": "sub", "id": "f", "what": "flow", "block": "OB1", "view": "lad", "networks": [1, 2] }));
    let first = page.until("the flow", |message| message["s"]["f"].is_object());
    assert_eq!(first["s"]["f"]["1"], json!([]), "a network that stays STL");
    let marks = |message: &Value| message["s"]["f"]["2"].as_array().cloned().unwrap_or_default();
    for mark in marks(&first) {
        let id = mark[0].as_str().expect("a name");
        assert!(picture.contains(&format!("data-net=\"{id}\"")) || picture.contains(&format!("data-element=\"{id}\"")), "{id} is drawn");
    }
    assert!(marks(&first).contains(&json!(["contact-11", "0", "0"])), "{first}");
    serving.json("PATCH", "/api/v1/tags", r#"{"M 50.0":true}"#);
    let then = page.until("another flow", |message| !marks(message).is_empty());
    assert!(marks(&then).contains(&json!(["contact-11", "1", "1"])), "{then}");
}

#[test]
fn the_past_is_shown_as_it_was_and_who_wrote_it() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let mut page = serving.page("");
    subscribe(&mut page);
    let far = page.until("some scans", |message| has_both(message) || message["n"].as_u64() > Some(60));
    let newest = page.until("more scans", |message| message["n"].as_u64() > Some(80))["n"].as_u64().expect("a scan");
    assert!(far["oldest"].as_u64() <= Some(1), "{far}");
    page.say(&json!({ "t": "at", "scan": newest - 50 }));
    let past = page.until("the past", |message| message["live"] == false);
    assert_eq!(past["n"].as_u64(), Some(newest - 50));
    assert_eq!(count(&past["s"]["tags"]["MW 10,INT"]), Some(newest - 50), "{past}");
    assert_eq!(past["s"]["rows"][3][3].as_u64(), Some(newest - 50), "{past}");
    page.say(&json!({ "t": "at", "step": "scan", "n": -3 }));
    let step = page.until("the step", |message| message["n"].as_u64() == Some(newest - 53));
    assert_eq!(count(&step["s"]["tags"]["MW 10,INT"]), Some(newest - 53));
    page.say(&json!({ "t": "history", "id": "h", "from": newest - 9, "to": newest, "channels": ["MW 10", "M 60.0"], "points": 100 }));
    let history = page.until("the history", |message| message["t"] == "history");
    let expected: Vec<Value> = (newest - 9..=newest).map(|scan| json!([scan, scan as f64])).collect();
    assert_eq!(history["channels"]["MW 10"], json!(expected), "{history}");
    assert_eq!(history["channels"]["M 60.0"], json!([[newest - 9, 0.0]]));
    let times = history["times"].as_array().expect("scans with their times");
    let is_of = |time: Option<&Value>, scan: u64| {
        time.is_some_and(|time| time[0].as_u64() == Some(scan) && time[1].as_u64() >= Some((scan - 1) * 10_000))
    };
    assert!(is_of(times.first(), newest - 9) && is_of(times.last(), newest), "{history}");
    page.say(&json!({ "t": "who", "id": "w", "name": "MW 10", "scan": newest - 20 }));
    let who = page.until("who wrote it", |message| message["t"] == "who");
    assert_eq!((who["block"].as_str(), who["line"].as_u64(), who["scan"].as_u64()), (Some("OB1"), Some(8), Some(newest - 20)), "{who}");
    page.say(&json!({ "t": "at", "scan": "live" }));
    let live = page.until("the present", |message| message["live"] == true && has_both(message));
    assert!(live["n"].as_u64() >= Some(newest), "{live}");
    let (status, _, table) = serving.ask("GET", "/api/v1/trace?from=2&to=4&channels=MW10,M60.0&format=csv", "", "");
    assert_eq!(status, 200, "{table}");
    let rows: Vec<&str> = table.lines().filter_map(|line| line.split_once(',').map(|(_, rest)| rest)).collect();
    assert_eq!(rows, ["scan,MW10,M60.0", "2,16#0002,0", "3,16#0003,0", "4,16#0004,0"], "{table}");
}

#[test]
fn a_reset_without_effect_wrote_nothing() {
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\nSET;\nS M 1.0;\nCLR;\nR M 1.0;\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("main.awl", program)]);
    let serving = Serving::usual(&folder);
    let mut page = serving.page("");
    let scan = page.until("a scan", |message| message["n"].as_u64() > Some(2))["n"].clone();
    page.say(&json!({ "t": "who", "id": "w", "name": "M 1.0", "scan": scan }));
    assert_eq!(page.until("who wrote it", |message| message["t"] == "who")["line"], 4);
}

/// Two instances of a function block, each with its own constant; OB 1 leaves a statement out as long as M 50.0 is 1.
const INSTANCES: &str = "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  step : INT;\nEND_VAR\nVAR\n  sum : INT;\nEND_VAR\nBEGIN\nL #sum;\nL #step;\n+I;\nT #sum;\n\
                         END_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 2\nFB 1\nBEGIN\nEND_DATA_BLOCK\n\
                         ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FB 1, DB 1 (step := 1);\nCALL FB 1, DB 2 (step := 100);\nNETWORK\nA I 0.0;\n\
                         = M 0.0;\nNETWORK\nL MW 10;\nL 1;\n+I;\nT MW 10;\nEND_ORGANIZATION_BLOCK\n";

fn with_instances() -> Folder {
    Folder::with(&[("sieben.toml", "[project]\nname = \"two\"\n"), ("main.awl", INSTANCES)])
}

/// Serves in both engines, each in a folder of its own: nothing retentive is left over.
fn in_both_engines(folder: impl Fn() -> Folder, check: impl Fn(&Serving)) {
    for engine in ["jit", "interpreter"] {
        check(&Serving::new(&folder(), &["--page", "127.0.0.1:0", "--engine", engine]));
    }
}

#[test]
fn a_page_that_comes_while_time_stands_still_sees_the_last_scan() {
    in_both_engines(project, |serving| {
        until("a scan", || (serving.json("GET", "/api/v1/state", "")["scans"] != 0).then_some(()));
        assert_eq!(serving.json("GET", "/api/v1/stacks", ""), Value::Null, "it runs");
        serving.json("POST", "/api/v1/time", r#"{"pause":true}"#);
        let scans = serving.json("GET", "/api/v1/state", "")["scans"].as_u64();
        let mut page = serving.page("");
        subscribe(&mut page);
        page.say(&json!({ "t": "sub", "id": "f", "what": "flow", "block": "OB1", "view": "lad", "networks": [2] }));
        let mut seen = json!({});
        let all = |seen: &Value| seen["rows"].is_array() && seen["tags"].is_object() && seen["f"]["2"].is_array();
        while !all(&seen) {
            let message = page.until("what stands", |message| message["t"] == "scan");
            assert_eq!((message["n"].as_u64(), &message["paused"]), (scans, &json!(true)), "{message}");
            message["s"].as_object().into_iter().flatten().for_each(|(id, part)| seen[id] = part.clone());
        }
        assert_eq!((seen["rows"][3][1].as_u64(), seen["rows"][3][3].as_u64()), (Some(1), scans), "{seen}");
        assert!(seen["rows"][3][5].as_str().is_some_and(|reason| reason.ends_with('.')), "{seen}");
        assert_eq!(seen["f"]["2"].as_array().map(|marks| marks.is_empty()), Some(false), "{seen}");
        // Another row is chosen, and its reason comes too.
        page.say(&json!({ "t": "sub", "id": "rows", "what": "rows", "block": "OB1", "from": 0, "to": 20, "reason": 0 }));
        let other =
            page.until("another reason", |message| message["s"]["rows"][0][5].is_string() || message["s"]["rows"]["0"][5].is_string());
        assert_eq!(other["n"].as_u64(), scans);
    });
}

#[test]
fn an_instance_has_its_own_values() {
    in_both_engines(with_instances, |serving| {
        let block = serving.json("GET", "/api/v1/blocks/FB1", "");
        assert_eq!(block["instances"], json!(["DB1", "DB2"]));
        let mut page = serving.page("");
        for (id, instance) in [("one", "DB1"), ("two", "DB 2"), ("none", "DB 99")] {
            page.say(
                &json!({ "t": "sub", "id": id, "what": "rows", "block": "FB1", "instance": instance, "from": 0, "to": 3, "reason": 1 }),
            );
        }
        page.say(&json!({ "t": "sub", "id": "any", "what": "rows", "block": "FB1", "from": 0, "to": 3 }));
        let is_whole = |message: &Value| ["one", "two", "any"].iter().all(|id| message["s"][id].is_array());
        // Each comes whole once, maybe in a message of its own, and from then on what changes.
        let mut first = json!({ "s": {} });
        page.until("the rows", |message| {
            for (id, rows) in message["s"].as_object().into_iter().flatten() {
                match rows.as_object() {
                    Some(changed) => {
                        changed.iter().for_each(|(row, now)| first["s"][id][row.parse::<usize>().expect("a row")] = now.clone())
                    }
                    None => first["s"][id] = rows.clone(),
                }
            }
            is_whole(&first) && first["s"]["one"][1][1] == 1
        });
        let step = |message: &Value, id: &str| message["s"][id][1][3].as_u64();
        assert_eq!([step(&first, "one"), step(&first, "two"), step(&first, "any")], [Some(1), Some(100), Some(100)], "{first}");
        assert_ne!(first["s"]["one"][1][5], first["s"]["two"][1][5], "each has a reason of its own");
        let newest = page.until("some scans", |message| message["n"].as_u64() > Some(20))["n"].as_u64().expect("a scan");
        page.say(&json!({ "t": "at", "scan": newest - 10 }));
        let past = page.until("the past", |message| message["live"] == false && is_whole(message));
        assert_eq!([step(&past, "one"), step(&past, "two")], [Some(1), Some(100)], "{past}");
        assert_eq!(past["s"]["one"][3][3].as_u64(), Some(newest - 10), "{past}");
    });
}

#[test]
fn statements_and_networks_are_stepped_through_and_back() {
    in_both_engines(with_instances, |serving| {
        until("a scan", || (serving.json("GET", "/api/v1/state", "")["scans"] != 0).then_some(()));
        serving.json("POST", "/api/v1/time", r#"{"pause":true}"#);
        let scans = serving.json("GET", "/api/v1/state", "")["scans"].as_u64().expect("a number");
        let mut page = serving.page("");
        page.say(&json!({ "t": "sub", "id": "rows", "what": "rows", "block": "OB1", "from": 0, "to": 20, "reason": 7 }));
        page.say(&json!({ "t": "sub", "id": "tags", "what": "tags", "names": ["MW 10,DEC", "DB1.DBW 2,DEC"] }));
        let begin = page.until("the rows", has_both);
        let step = |page: &mut Page, unit: &str, n: i64| {
            page.say(&json!({ "t": "at", "step": unit, "n": n }));
            page.until("the step", has_both)
        };
        let index = |message: &Value| message["pos"]["index"].as_u64();
        let first = step(&mut page, "statement", 1);
        assert_eq!((first["n"].as_u64(), first["live"].as_bool(), index(&first)), (Some(scans + 1), Some(false), Some(0)), "{first}");
        assert_eq!(first["pos"]["block"], "OB1");
        // The call has come back: one instance is a scan ahead of OB 1.
        assert_eq!(
            (count(&first["s"]["tags"]["DB1.DBW 2,DEC"]), count(&first["s"]["tags"]["MW 10,DEC"])),
            (Some(scans + 1), Some(scans)),
            "{first}"
        );
        let executed =
            |message: &Value| message["s"]["rows"].as_array().into_iter().flatten().map(|row| row[1].as_u64()).collect::<Vec<_>>();
        assert_eq!((executed(&first)[0], executed(&first)[7]), (Some(1), Some(2)), "{first}");
        let back = step(&mut page, "statement", -1);
        assert_eq!((back["n"].as_u64(), back.get("pos"), &back["s"]), (Some(scans), None, &begin["s"]), "the very same is there again");
        assert_eq!(step(&mut page, "statement", 1)["s"], first["s"], "and again");
        let network = step(&mut page, "network", 1);
        assert_eq!(
            network["pos"]["line"].as_u64().zip(index(&network)),
            network["pos"]["line"].as_u64().map(|line| (line, 1)),
            "{network}"
        );
        let second = step(&mut page, "network", 1);
        assert_eq!(index(&second), Some(3), "{second}");
        assert!(second["pos"]["reason"].as_str().is_some_and(|reason| reason.ends_with('.')), "{second}");
        assert_eq!(step(&mut page, "network", -1)["pos"], network["pos"]);
        let mut last = step(&mut page, "network", 2);
        while last.get("pos").is_some() {
            assert!(index(&last) < Some(8), "what no statement says is no step: {last}");
            last = step(&mut page, "statement", 1);
        }
        assert_eq!((last["n"].as_u64(), count(&last["s"]["tags"]["MW 10,DEC"])), (Some(scans + 1), Some(scans + 1)), "{last}");
        assert!(!executed(&last).contains(&Some(2)), "nothing is to come at the end: {last}");
        page.say(&json!({ "t": "at", "step": "scan", "n": 1 }));
        let scan = page.until("the next scan", |message| message["n"].as_u64() == Some(scans + 2));
        assert_eq!(scan["live"], true, "{scan}");
        assert_eq!(serving.json("GET", "/api/v1/state", "")["scans"].as_u64(), Some(scans + 2), "the CPU has run two scans for that");
    });
}

#[test]
fn statements_and_reasons_are_shown_in_the_mnemonics_that_are_asked_for() {
    let folder = with_instances();
    let serving = Serving::usual(&folder);
    let shown = |more: &str| -> Vec<(String, String)> {
        let block = serving.json("GET", &format!("/api/v1/blocks/OB1?view=stl{more}"), "");
        let statements = block["networks"].as_array().into_iter().flatten().flat_map(|network| network["statements"].as_array()).flatten();
        statements
            .map(|one| (one["op"].as_str().unwrap_or_default().to_owned(), one["operand"].as_str().unwrap_or_default().to_owned()))
            .collect()
    };
    let has = |list: &[(String, String)], op: &str, operand: &str| list.iter().any(|one| one.0 == op && one.1 == operand);
    assert!(has(&shown(""), "A", "I 0.0") && has(&shown("&mnemonics=en"), "A", "I 0.0"), "{:?}", shown(""));
    assert!(has(&shown("&mnemonics=de"), "U", "E 0.0"), "{:?}", shown("&mnemonics=de"));
    assert_eq!(serving.ask("GET", "/api/v1/blocks/OB1?mnemonics=fr", "", "").0, 400);
    let reason = |mnemonics: &str| {
        let mut page = serving.page("");
        page.say(&json!({ "t": "hello", "v": 1, "lang": "en", "mnemonics": mnemonics }));
        page.say(&json!({ "t": "sub", "id": "rows", "what": "rows", "block": "OB1", "from": 2, "to": 2, "reason": 2 }));
        let message = page.until("a reason", |message| message["s"]["rows"][0][5].is_string());
        message["s"]["rows"][0][5].as_str().map(str::to_owned).unwrap_or_default()
    };
    assert!(reason("en").contains("I 0.0") && reason("de").contains("E 0.0"), "{} {}", reason("en"), reason("de"));
    assert!(fs::read_to_string(folder.path().join("main.awl")).is_ok_and(|text| text == INSTANCES), "the file stays as it is");
}

#[test]
fn entries_of_the_diagnostic_buffer_say_in_which_scan_they_came() {
    let text = "ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 10;\nL 1;\n+I;\nT MW 10;\nL 20;\n<I;\nBEC;\nOPN DB [MW 10];\nEND_ORGANIZATION_BLOCK\n";
    in_both_engines(
        || Folder::with(&[("main.awl", text)]),
        |serving| {
            // Before it starts it is in STOP, too.
            let state = until("the CPU stops", || {
                Some(serving.json("GET", "/api/v1/state", "")).filter(|state| state["mode"] == "STOP" && state["scans"] != 0)
            });
            let scans = state["scans"].as_u64();
            let mut page = serving.page("");
            page.say(&json!({ "t": "sub", "id": "d", "what": "diag" }));
            let list = page.until("the buffer", |message| message["s"]["d"].is_array())["s"]["d"].clone();
            let cause = list.as_array().and_then(|list| list.iter().find(|entry| entry["place"].is_object())).expect("a cause");
            assert_eq!((cause["n"].as_u64(), cause["place"]["line"].as_u64()), (scans, Some(10)), "{list}");
            page.say(&json!({ "t": "sub", "id": "rows", "what": "rows", "block": "OB1", "from": 0, "to": 20 }));
            let rows = page.until("the rows", |message| message["s"]["rows"].is_array());
            assert_eq!((rows["n"].as_u64(), rows["s"]["rows"][3][3].as_u64()), (scans, Some(20)), "{rows}");
            let stacks = serving.json("GET", "/api/v1/stacks", "");
            assert_eq!(
                (stacks["n"].as_u64(), stacks["place"]["line"].as_u64(), stacks["i"]["accu1"].as_str()),
                (scans, Some(10), Some("16#00000014"))
            );
            assert_eq!((stacks["b"][0]["block"].as_str(), stacks["source"][2]["failed"].as_bool()), (Some("OB1"), Some(true)), "{stacks}");
            let info = serving.json("GET", "/api/v1/info", "");
            assert_eq!((info["work_memory"].as_u64(), info["load_memory"].as_u64()), (Some(384 << 10), Some(8 << 20)), "{info}");
            assert!(info["clock"].is_string() && info["work_used"].is_u64(), "{info}");
        },
    );
}

#[test]
fn a_change_says_who_made_it() {
    let text = "DATA_BLOCK DB 1\nSTRUCT\n a : BOOL;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA M 50.0;\nR M 60.0;\n\
                NETWORK\nA M 50.0;\n= M 60.0;\nNETWORK\nAN M 50.0;\nS M 50.1;\nR M 50.1;\nEND_ORGANIZATION_BLOCK\n";
    in_both_engines(
        || Folder::with(&[("main.awl", text)]),
        |serving| {
            let mut page = serving.page("");
            page.say(&json!({ "t": "sub", "id": "c", "what": "changes" }));
            page.until("the beginning", |message| message["s"]["c"].is_array());
            // Values are compared from the scan after the subscription on.
            page.say(&json!({ "t": "sub", "id": "r", "what": "rows", "block": "OB1", "from": 0, "to": 8 }));
            page.until("some scans", |message| message["s"]["r"].is_array());
            serving.json("PATCH", "/api/v1/tags", r#"{"M 50.0":true}"#);
            let mut seen: Vec<Value> = Vec::new();
            while !["M 50.0", "M 60.0"].iter().all(|&address| seen.iter().any(|change| change["address"] == address)) {
                let message = page.until("changes", |message| message["s"]["c"]["add"].is_array());
                seen.extend(message["s"]["c"]["add"].as_array().into_iter().flatten().cloned());
            }
            let of = |address: &str| seen.iter().find(|change| change["address"] == address).cloned().unwrap_or_default();
            assert_eq!(of("M 60.0")["by"], json!({ "block": "OB1", "network": 2, "line": 14 }), "{seen:?}");
            assert!(of("M 50.0")["peer"].as_str().is_some_and(|peer| peer.starts_with("page 127.0.0.1:")), "{seen:?}");
            assert_eq!(of("M 50.0").get("by"), None);
        },
    );
}

#[test]
fn before_the_start_and_past_the_end_there_is_a_clean_answer() {
    let serving = Serving::usual(&project());
    let mut page = serving.page("");
    subscribe(&mut page);
    page.until("some scans", |message| message["n"].as_u64() > Some(5));
    page.say(&json!({ "t": "at", "step": "scan", "n": i64::MIN }));
    let first = page.until("the start", |message| message["live"] == false);
    assert_eq!(first["n"], 0, "{first}");
    page.say(&json!({ "t": "at", "step": "statement", "n": -3 }));
    assert_eq!(page.until("a refusal", |message| message["t"] == "event")["code"], "P7139");
    page.say(&json!({ "t": "at", "scan": u64::MAX }));
    let newest = page.until("the newest", |message| message["live"] == true);
    assert!(newest["n"].as_u64() > Some(5), "{newest}");
    page.say(&json!({ "t": "history", "id": "h", "from": u64::MAX - 1, "to": u64::MAX, "channels": ["MW 10"], "points": u64::MAX }));
    let history = page.until("an answer", |message| message["t"] == "history");
    assert_eq!(history["channels"]["MW 10"], json!([]), "{history}");
    page.say(&json!({ "t": "history", "id": "h", "from": 9, "to": 0, "channels": ["MW 10", "nothing"], "points": 1 }));
    assert_eq!(page.until("an answer", |message| message["t"] == "history")["channels"], json!({ "MW 10": [], "nothing": [] }));
    page.say(&json!({ "t": "who", "id": "w", "name": "MW 10", "scan": 0 }));
    assert_eq!(page.until("who", |message| message["t"] == "who").get("line"), None);
    for path in ["from=-1&to=3", "from=NaN&to=3", "from=1&to=1e9", "to=3"] {
        let (status, _, text) = serving.ask("GET", &format!("/api/v1/trace?{path}&channels=MW10"), "", "");
        assert!(status == 400 && text.contains("P7131"), "{path}: {status} {text}");
    }
    let (status, _, text) = serving.ask("GET", "/api/v1/trace?from=900000000&to=18446744073709551615&channels=MW10", "", "");
    assert!(text.contains("P7139"), "{status} {text}");
}

#[test]
fn what_is_done_over_http_is_done_and_noted() {
    let folder = project();
    let serving = Serving::usual(&folder);
    assert_eq!(serving.json("PATCH", "/api/v1/tags", r#"{"M 50.0":true,"MW 20":"W#16#1234"}"#)["done"], 2);
    until("the program follows", || {
        (serving.json("GET", "/api/v1/tags?names=MW30,M60.0", "")["items"][0]["value"] == "16#1234").then_some(())
    });
    assert_eq!(
        serving.json("POST", "/api/v1/forces", r#"{"name":"I 0.1","value":"1","reason":"the sensor is exchanged"}"#)[0]["reason"],
        "the sensor is exchanged"
    );
    assert_eq!(serving.json("DELETE", "/api/v1/forces/I%200.1", ""), json!([]));
    assert_eq!(serving.json("POST", "/api/v1/mode", r#"{"mode":"stop"}"#)["mode"], "STOP");
    assert_eq!(serving.json("GET", "/api/v1/state", "")["mode"], "STOP");
    assert_eq!(serving.json("POST", "/api/v1/mode", r#"{"mode":"run"}"#)["mode"], "RUN");
    assert_eq!(serving.json("POST", "/api/v1/time", r#"{"pause":true}"#)["paused"], true);
    let before = serving.json("GET", "/api/v1/state", "")["scans"].as_u64();
    assert_eq!(serving.json("POST", "/api/v1/time", r#"{"step":"scan","n":3}"#)["scans"].as_u64(), before.map(|scans| scans + 3));
    assert_eq!(serving.json("POST", "/api/v1/time", r#"{"go":true}"#)["paused"], false);
    let fault = serving.json("POST", "/api/v1/faults", r#"{"name":"tank.level","fault":"stuck=0"}"#);
    assert_eq!(fault["plants"][0]["faults"][0], "tank.level stuck=0", "{fault}");
    for (path, part) in [
        ("/api/v1/blocks", "\"block\":\"OB1\""),
        ("/api/v1/blocks/OB1?view=lad", "\"title\":\"Counts scans\""),
        ("/api/v1/refs?name=MW%2010", "\"address\":\"MW 10\""),
        ("/api/v1/assignments", "\"area\":\"M\""),
        ("/api/v1/structure", "\"OB 1\""),
        ("/api/v1/plants", "\"kind\":\"tank\""),
        ("/api/v1/diagnostics?format=text", "mode change"),
        ("/api/v1/explain/FP", "edge"),
        ("/metrics", "sieben_scans_total"),
        ("/docs/", "<h1"),
        ("/docs/reference/limits", "<table"),
    ] {
        let (status, _, text) = serving.ask("GET", path, "", "");
        assert!(status == 200 && text.contains(part), "{path}: {status} {text:.300}");
    }
    let log = fs::read_to_string(folder.path().join(".sieben/audit.log")).expect("a log");
    let what: Vec<Value> = log.lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON")["what"].clone()).collect();
    assert_eq!(what, ["write", "write", "force", "unforce", "stop", "start", "time", "time", "time", "fault"], "{log}");
    assert!(log.lines().all(|line| line.contains("\"peer\":\"page 127.0.0.1:")), "{log}");
}

#[test]
fn what_is_wrong_is_a_problem_with_its_code() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let other = format!("Host: other.example:{}\r\n", serving.page.port());
    let twice = format!("Host: {0}\r\nHost: {0}\r\n", serving.page);
    for (method, path, head, body, status, code) in [
        ("GET", "/api/v1/nothing", "", "", 404, "P7137"),
        ("GET", "/nothing.js", "", "", 404, "P7137"),
        ("GET", "/api/v1/blocks/FC99", "", "", 404, "P7095"),
        ("PUT", "/api/v1/state", "", "", 405, "P7138"),
        ("POST", "/metrics", "", "", 405, "P7138"),
        ("POST", "/api/v1/mode", "", "{", 400, "P7131"),
        ("POST", "/api/v1/mode", "", "[]", 400, "P7131"),
        ("POST", "/api/v1/mode", "", r#"{"mode":"fly"}"#, 400, "P7091"),
        ("POST", "/api/v1/mode", "", r#"{"mode":"run"}"#, 409, "P7093"),
        ("POST", "/api/v1/forces", "", r#"{"name":"C 0","value":"1","reason":""}"#, 404, "P7003"),
        ("GET", "/api/v1/trace?from=900000&to=900001&channels=MW10", "", "", 404, "P7139"),
        ("GET", "/ws", "", "", 400, "P7131"),
        ("GET", "/api/v1/trace?from=9&to=8&channels=MW10", "", "", 400, "P7131"),
        ("GET", "/", &other, "", 421, "P7135"),
        ("GET", "/", &twice, "", 421, "P7135"),
        ("DELETE", "/api/v1/forces/Nothing", "", "", 404, "P7003"),
        ("GET", "/api/v1/state", "Origin: http://other.example\r\n", "", 403, "P7134"),
        ("POST", "/api/v1/mode", "Origin: null\r\n", r#"{"mode":"stop"}"#, 403, "P7134"),
    ] {
        let (got, head, text) = serving.ask(method, path, head, body);
        let problem: Value = serde_json::from_str(&text).unwrap_or_default();
        assert_eq!((got, problem["code"].as_str()), (status, Some(code)), "{method} {path}: {text}");
        assert!(head.contains("application/problem+json") && head.contains("nosniff"), "{head}");
    }
    let (status, _, _) = serving.ask("POST", "/api/v1/mode", "", &format!("{{\"mode\":\"{}\"}}", "x".repeat(70_000)));
    assert_eq!(status, 413);
    let (_, head, text) = serving.ask("GET", "/", "", "");
    assert!(head.contains("frame-ancestors 'none'") && text.contains("<title>Sieben</title>"), "{head}");
}

#[test]
fn a_page_that_says_anything_is_sent_away_and_others_are_not() {
    let folder = project();
    let serving = Serving::usual(&folder);
    let mut other = serving.page("");
    subscribe(&mut other);
    let deep = format!("{{\"t\":{}", "[".repeat(50_000));
    let long = vec![b' '; 1_000_000];
    for (number, (kind, frame, code)) in [
        (1, deep.as_bytes(), "P7131"),
        (1, b"{\"t\":\"fly\"}".as_slice(), "P7131"),
        (2, b"\xFF\xFE", "P7131"),
        (1, b"\xFF\xFE", "P7131"),
        (1, &vec![b' '; 70_000], "P7130"),
        (1, &long, "P7130"),
    ]
    .into_iter()
    .enumerate()
    {
        let mut page = serving.page("");
        page.frame(kind, frame);
        let bye = page.until(&format!("farewell {number}"), |message| message["t"] == "bye");
        assert_eq!(bye["why"], code, "{number}: {bye}");
        assert_eq!(page.next(), None);
    }
    let mut page = serving.page("");
    (0..100).for_each(|number| page.say(&json!({ "t": "ack", "seq": number })));
    assert_eq!(page.until("a farewell", |message| message["t"] == "bye")["why"], "P7130");
    other.until("the other page is live", |message| message["t"] == "scan" && message["n"].as_u64() > Some(50));
}

#[test]
fn other_computers_need_a_token_and_one_of_the_two_only_looks() {
    let folder = project();
    let refused = folder.run(&["serve", ".", "--s7", "127.0.0.1:0", "--page", "0.0.0.0:7300"]);
    assert_eq!(refused.code, Some(2), "{}", refused.stderr);
    assert!(refused.stderr.contains("P7100") && refused.stderr.contains("--expose page=0.0.0.0:7300"), "{}", refused.stderr);
    let serving = Serving::new(&folder, &["--page", "0.0.0.0:0", "--expose", "page=0.0.0.0:0"]);
    let file = folder.path().join(".sieben/page-tokens");
    assert_eq!(fs::metadata(&file).expect("a file of tokens").permissions().mode() & 0o777, 0o600);
    let text = fs::read_to_string(&file).expect("tokens");
    let token = |word: &str| text.lines().find_map(|line| line.strip_prefix(word)).expect("a token").trim().to_owned();
    let bearer = |word: &str| format!("Authorization: Bearer {}\r\n", token(word));
    let write = r#"{"M 50.0":true}"#;
    for (method, path, head, status) in [
        ("GET", "/", String::new(), 200),
        ("GET", "/api/v1/state", String::new(), 401),
        ("GET", "/metrics", String::new(), 401),
        ("GET", "/ws", String::new(), 401),
        ("GET", "/api/v1/state", "Authorization: Bearer wrong\r\n".to_owned(), 401),
        ("GET", "/api/v1/state", bearer("view"), 200),
        ("PATCH", "/api/v1/tags", bearer("view"), 403),
        ("PATCH", "/api/v1/tags", bearer("program"), 200),
    ] {
        assert_eq!(serving.ask(method, path, &head, if method == "PATCH" { write } else { "" }).0, status, "{method} {path} {head}");
    }
    let mut page = serving.page(&format!("?token={}", token("view")));
    assert_eq!(page.next().expect("a welcome")["role"], "view");
    drop(serving);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o644)).expect("it is ours");
    let refused = folder.run(&["serve", ".", "--s7", "127.0.0.1:0", "--page", "0.0.0.0:0", "--expose", "page=0.0.0.0:0"]);
    assert!(refused.code == Some(2) && refused.stderr.contains("P7140") && refused.stderr.contains("chmod 600"), "{}", refused.stderr);
}

#[test]
fn of_the_diagnostic_buffer_as_many_entries_are_given_as_are_asked_for() {
    let folder = project();
    let serving = Serving::usual(&folder);
    for _ in 0..6 {
        serving.json("POST", "/api/v1/mode", r#"{"mode":"stop"}"#);
        serving.json("POST", "/api/v1/mode", r#"{"mode":"run"}"#);
    }
    let answer = |query: &str| serving.json("GET", &format!("/api/v1/diagnostics{query}"), "");
    let count = |query: &str| answer(query)["entries"].as_array().expect("entries").len();
    let all = count("?n=500");
    assert!(all > 10, "{all}");
    assert_eq!([count(""), count("?n=3"), count("?after=1"), count("?after=1&n=2")], [10, 3, all - 1, 2]);
    let newest = answer("?n=1");
    assert_eq!(newest["entries"][0]["number"], newest["newest"]);
    let (_, _, text) = serving.ask("GET", "/api/v1/diagnostics?format=text", "", "");
    assert_eq!(text.lines().count(), all);
    for query in ["n=0", "n=501", "n=-1", "n=all", "n="] {
        let (status, _, text) = serving.ask("GET", &format!("/api/v1/diagnostics?{query}"), "", "");
        assert!(status == 400 && text.contains("P7131") && text.contains("1 to 500"), "{query}: {status} {text}");
    }
}

#[test]
fn the_end_of_the_run_is_said_to_pages() {
    let folder = project();
    let mut serving = Serving::usual(&folder);
    let mut page = serving.page("");
    subscribe(&mut page);
    page.until("a scan", has_both);
    let killed = Command::new("kill").args(["-INT", &serving.child.id().to_string()]).status().expect("kill exists");
    assert!(killed.success());
    assert_eq!(page.until("a farewell", |message| message["t"] == "bye")["why"], "P7094");
    assert_eq!(page.next(), None);
    assert_eq!(serving.child.wait().expect("it ends").code(), Some(0));
}

/// A panel whose parts lie where the project wants them, beside lamps that it only shows.
#[test]
fn a_panel_is_shown_with_the_addresses_of_its_project() {
    let settings = "[project]\nname = \"panel\"\n\n[[module]]\nkind = \"panel\"\nswitches = -1\nbuttons = 6\nlamps = 8\ndisplay = -1\nmotor_left = -1\n";
    let program = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 6.1;\n= Q 8.3;\n= Q 20.7;\nEND_ORGANIZATION_BLOCK\n";
    let folder = Folder::with(&[("sieben.toml", settings), ("main.awl", program)]);
    let serving = Serving::usual(&folder);
    let head = &serving.json("GET", "/api/v1/plants", "")[0];
    let signals = head["signals"].as_array().expect("signals");
    let address = |name: &str| signals.iter().find(|signal| signal["name"] == name).map(|signal| signal["address"].clone());
    let found = ["thumbwheel", "button_0_1", "button_1_7", "lamp_0_3", "display", "switch_0_0"].map(address);
    let expected = [Some("IW 4"), Some("I 6.1"), Some("I 7.7"), Some("Q 8.3"), None, None].map(|address| address.map(Value::from));
    assert_eq!(found, expected, "{head}");
    assert_eq!((&head["parameters"][0], &head["parameters"][6]), (&json!("switches"), &json!("horn")));
    let mut page = serving.page("");
    page.say(&json!({ "t": "hello", "v": 1, "lang": "en" }));
    page.say(&json!({ "t": "sub", "id": "plant", "what": "plant" }));
    let lit = |message: &Value| message["s"]["plant"][0]["outputs"][0] == 8;
    serving.json("PATCH", "/api/v1/tags", r#"{"I 6.1":true}"#);
    let plant = page.until("the panel with its lamp", lit)["s"]["plant"][0].clone();
    assert_eq!((&plant["input"], &plant["inputs"]), (&json!(4), &json!([0, 0, 2, 0])), "{plant}");
    assert_eq!((&plant["output"], &plant["outputs"]), (&json!(8), &json!([8, 0, 0, 0])), "{plant}");
    assert_eq!(plant["state"], json!([["horn", 1.0, ""], ["motor_right", 0.0, ""]]), "{plant}");
}
