//! The control socket of a run, and `sieben top`: real processes, real sockets.
#![cfg(unix)]

mod command;

use std::fs;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

use command::{DEADLINE, Folder, sieben, until};
use serde_json::{Value, json};

const PROJECT: &str = "[project]\nname = \"pump\"\n\n[[module]]\nkind = \"tank\"\ninput = 256\noutput = 256\n";
const PROGRAM: &str = "
DATA_BLOCK DB 1
STRUCT
 n : INT;
 level : REAL;
 text : STRING [20];
END_STRUCT;
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
BEGIN
L DB1.DBW 0; L 1; +I; T DB1.DBW 0;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
CALL FC 1;
L DB1.DBW 0; T MW 20;
A M 50.0; CC FC 2;
A I 0.0; = Q 0.0;
END_ORGANIZATION_BLOCK
FUNCTION FC 2 : VOID
BEGIN
NETWORK
// NETWORK 7 of the manual
NETWORK
TITLE = The end
NOP 0; // TITLE = none of a NETWORK
CALL SFC 46;
END_FUNCTION
";

/// A run that is asked from outside. It is ended when this goes.
struct Running {
    child: Child,
    socket: PathBuf,
}

/// A folder for sockets of this test alone.
fn runtime(folder: &Folder) -> PathBuf {
    let path = folder.path().join("runtime");
    fs::create_dir_all(&path).expect("the folder is writable");
    path
}

fn start(folder: &Folder, arguments: &[&str]) -> Child {
    let mut command = sieben(folder.path(), arguments);
    command.env("XDG_RUNTIME_DIR", runtime(folder)).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the binary starts")
}

/// Runs to the end, with the same folder for sockets.
fn finished(folder: &Folder, arguments: &[&str]) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = start(folder, arguments).wait_with_output().expect("the binary ends");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (status.code(), text(stdout), text(stderr))
}

/// The sockets below a folder.
fn sockets(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|ending| ending == "sock")).collect()
}

impl Running {
    /// A run whose socket lies in this folder.
    fn in_folder(folder: &Folder, arguments: &[&str], sockets_in: &Path) -> Self {
        let child = start(folder, arguments);
        let socket = until("the run answers", || sockets(sockets_in).into_iter().find(|path| UnixStream::connect(path).is_ok()));
        Self { child, socket }
    }

    /// The run of the project in a folder.
    fn of_project(folder: &Folder, more: &[&str]) -> Self {
        let arguments: Vec<&str> = ["run", "."].iter().chain(more).copied().collect();
        Self::in_folder(folder, &arguments, &folder.path().join(".sieben"))
    }

    fn client(&self) -> Client {
        Client::at(&self.socket)
    }

    /// Ends the run as Ctrl-C does; code and messages.
    fn stop(&mut self) -> (Option<i32>, String) {
        signal(&self.child, "-INT");
        let mut text = String::new();
        self.child.stderr.take().expect("a pipe").read_to_string(&mut text).expect("UTF-8");
        (self.child.wait().expect("the binary ends").code(), text)
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn signal(child: &Child, signal: &str) {
    let killed = Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill exists");
    assert!(killed.success());
}

/// Somebody who asks a run.
struct Client(BufReader<UnixStream>);

impl Client {
    fn at(socket: &Path) -> Self {
        let stream = UnixStream::connect(socket).expect("the run answers");
        stream.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        Self(BufReader::new(stream))
    }

    fn send(&mut self, line: &str) {
        self.0.get_mut().write_all(format!("{line}\n").as_bytes()).expect("the run reads");
    }

    fn receive(&mut self) -> Option<Value> {
        let mut line = String::new();
        self.0.read_line(&mut line).ok().filter(|&count| count > 0)?;
        Some(serde_json::from_str(&line).unwrap_or_else(|error| panic!("{error}: {line}")))
    }

    fn try_ask(&mut self, request: Value) -> Option<Value> {
        let mut line = request.to_string();
        line.push('\n');
        self.0.get_mut().write_all(line.as_bytes()).ok()?;
        self.receive()
    }

    #[track_caller]
    fn ask(&mut self, request: Value) -> Value {
        self.try_ask(request).expect("the run answers")
    }

    /// The value of an item.
    fn value(&mut self, item: &str) -> Value {
        let answer = self.ask(json!({ "verb": "read", "items": [item] }));
        answer["items"][0].get("value").cloned().unwrap_or_else(|| answer["items"][0]["error"]["code"].clone())
    }
}

fn project() -> Folder {
    Folder::with(&[("sieben.toml", PROJECT), ("main.awl", PROGRAM)])
}

#[test]
fn every_verb_has_its_answer() {
    let folder = project();
    let mut run = Running::of_project(&folder, &[]);
    let mode = fs::metadata(&run.socket).expect("the socket is there").permissions().mode();
    assert_eq!(mode & 0o777, 0o600, "only its owner can connect");
    let mut client = run.client();

    let state = client.ask(json!({ "id": 1, "verb": "state" }));
    assert_eq!((&state["id"], &state["project"], &state["cpu"]), (&json!(1), &json!("pump"), &json!("315-2PN/DP")));
    assert_eq!(
        (&state["mode"], &state["stop"], &state["speed"], &state["paused"]),
        (&json!("RUN"), &Value::Null, &json!("1x"), &json!(false))
    );
    assert!(state["scans"].as_u64().is_some() && state["cycle_ms"]["last"].as_f64().is_some(), "{state}");
    // Whoever looked for the socket goes.
    until("nobody else is there", || (client.ask(json!({ "verb": "state" }))["connections"] == 1).then_some(()));

    // What is read belongs to one scan.
    for _ in 0..50 {
        let read = client
            .ask(json!({ "id": "x", "verb": "read", "items": ["DB1.n", "MW20", "DB1.level", "DB1.text", "I0.0", "XW1", "DB9.DBW0"] }));
        let items = read["items"].as_array().expect("items");
        assert_eq!(read["id"], "x");
        assert_eq!(items[1]["value"], json!(format!("16#{:04X}", items[0]["value"].as_u64().expect("an INT"))), "{read}");
        assert_eq!((&items[2]["value"], &items[3]["value"], &items[4]["value"]), (&json!(0.0), &json!("''"), &json!(0)), "{read}");
        assert_eq!((&items[5]["error"]["code"], &items[6]["error"]["code"]), (&json!("P7003"), &json!("P7003")), "{read}");
        assert!(items[5].get("value").is_none(), "{read}");
    }

    let written = client.ask(json!({ "verb": "write", "values": { "DB1.level": "1.5", "DB1.text": "'abc'", "I0.0": true, "MW30": 77 } }));
    assert_eq!(written["done"], 4, "{written}");
    assert!(written["scan"].as_u64().is_some(), "{written}");
    assert_eq!((client.value("DB1.level"), client.value("DB1.text"), client.value("MW30")), (json!(1.5), json!("'abc'"), json!("16#004D")));
    // A timer is the count to programs, and the time that it has left to people.
    client.ask(json!({ "verb": "write", "values": { "T5": "S5T#5S" } }));
    let timer = client.ask(json!({ "verb": "read", "items": ["T5"] }));
    assert_eq!((&timer["items"][0]["value"], &timer["items"][0]["shown"]), (&json!(500), &json!("S5T#5S")), "{timer}");
    until("the output follows the input", || (client.value("Q0.0") == 1).then_some(()));
    // One wrong name or value keeps all of it back, whether it is the text or the CPU that refuses it.
    for (wrong, code) in [("XW1", "P7003"), ("DB9.DBW0", "P7003"), ("M 0.0", "P7004"), ("C 1", "P7004")] {
        let refused = client.ask(json!({ "verb": "write", "values": { "MW30": 5, wrong: if wrong == "C 1" { "'abc'" } else { "7" } } }));
        assert_eq!(
            (&refused["scan"], &refused["done"], &refused["items"][1]["error"]["code"]),
            (&Value::Null, &json!(0), &json!(code)),
            "{refused}"
        );
        assert_eq!((&refused["items"][0]["done"], client.value("MW30")), (&json!(false), json!("16#004D")), "{refused}");
    }

    let forced = client.ask(json!({ "verb": "force", "values": { "Q0.3": 1, "QB2": "16#A5", "MW30": 1 } }));
    assert_eq!((&forced["done"], &forced["items"][2]["error"]["code"]), (&json!(2), &json!("P7003")), "{forced}");
    let state = client.ask(json!({ "verb": "state" }));
    assert_eq!(state["forced"], json!([{ "name": "Q 0.3", "shown": "1" }, { "name": "QB 2", "shown": "16#A5" }]));
    until("it is put out", || (client.value("QB2") == "16#A5").then_some(()));
    let unforced = client.ask(json!({ "verb": "unforce", "items": ["Q0.3", "Q0.4", "XX"] }));
    assert_eq!((&unforced["done"], &unforced["items"][1]["error"]["code"]), (&json!(1), &json!("P7003")), "{unforced}");
    client.ask(json!({ "verb": "unforce_all" }));
    assert_eq!(client.ask(json!({ "verb": "state" }))["forced_count"], 0);

    let diagnostics = client.ask(json!({ "verb": "diagnostics" }));
    let newest = diagnostics["newest"].as_u64().expect("a number");
    assert_eq!(diagnostics["entries"].as_array().map(Vec::len), usize::try_from(newest).ok());
    assert_eq!(client.ask(json!({ "verb": "diagnostics", "after": newest }))["entries"], json!([]));

    let blocks = client.ask(json!({ "verb": "blocks" }));
    let names: Vec<&Value> = blocks["blocks"].as_array().expect("blocks").iter().map(|block| &block["block"]).collect();
    assert_eq!((&blocks["total"], &blocks["next"]), (&json!(4), &Value::Null));
    assert!(["OB 1", "FC 1", "FC 2", "DB 1"].iter().all(|block| names.contains(&&json!(block))), "{blocks}");
    assert_eq!(client.ask(json!({ "verb": "blocks", "from": 3 }))["blocks"].as_array().map(Vec::len), Some(1));

    let status = client.ask(json!({ "verb": "status", "block": "FC 1" }));
    let statements = status["statements"].as_array().expect("statements");
    assert_eq!((&status["block"], &status["same"], statements.len()), (&json!("FC 1"), &json!(true), 5), "{status}");
    assert_eq!(
        (&statements[0]["line"], &statements[0]["times"], &statements[1]["after"]["accu1"]),
        (&json!(12), &json!(1), &json!("16#00000001"))
    );
    let newer = client.ask(json!({ "verb": "status", "block": "FC1", "after": status["sample"], "from": 2 }));
    assert!(newer["sample"].as_u64() > status["sample"].as_u64(), "{newer}");
    assert_eq!(newer["statements"][0]["statement"], 2);
    for block in ["FC 9", "DB 1", "nothing"] {
        assert_eq!(client.ask(json!({ "verb": "status", "block": block }))["error"]["code"], "P7095", "{block}");
    }

    let paused = client.ask(json!({ "verb": "time", "time": "pause" }));
    assert_eq!(paused["paused"], true);
    let stepped = client.ask(json!({ "verb": "time", "time": "step", "scans": 3 }));
    assert_eq!(stepped["scans"].as_u64(), paused["scans"].as_u64().map(|scans| scans + 3), "{stepped}");
    assert_eq!(stepped["scans_left"], 0);
    assert_eq!(client.ask(json!({ "verb": "status", "block": "OB 1" }))["error"]["code"], "P7095", "no scan, no status");
    assert_eq!(client.ask(json!({ "verb": "time", "time": "speed", "speed": "max" }))["speed"], "max");
    assert_eq!(client.ask(json!({ "verb": "time", "time": "go" }))["paused"], false);
    let before = client.ask(json!({ "verb": "state" }))["scans"].as_u64();
    until("it is fast", || (client.ask(json!({ "verb": "state" }))["scans"].as_u64() > before.map(|scans| scans + 500)).then_some(()));
    assert_eq!(client.ask(json!({ "verb": "time", "time": "speed", "speed": "1x" }))["speed"], "1x");

    let plants = client.ask(json!({ "verb": "faults" }));
    assert_eq!((&plants["plants"][0]["module"], &plants["plants"][0]["faults"]), (&json!("tank"), &json!([])), "{plants}");
    assert!(plants["plants"][0]["signals"].as_array().is_some_and(|signals| signals.contains(&json!("level"))), "{plants}");
    let injected = client.ask(json!({ "verb": "faults", "inject": "tank.level stuck=5" }));
    assert_eq!(injected["plants"][0]["faults"], json!(["tank.level stuck=5"]));
    assert_eq!(client.ask(json!({ "verb": "faults", "inject": "tank.nothing stuck" }))["error"]["code"], "P6272");
    assert_eq!(client.ask(json!({ "verb": "faults", "mend": "tank.level" }))["plants"][0]["faults"], json!([]));
    assert_eq!(client.ask(json!({ "verb": "faults", "mend": "tank.level" }))["error"]["code"], "P6272");

    for (mode, answer) in [("run", "P7093"), ("mres", "P7093")] {
        assert_eq!(client.ask(json!({ "verb": "mode", "mode": mode }))["error"]["code"], answer, "in RUN");
    }
    assert_eq!(client.ask(json!({ "verb": "mode", "mode": "stop" }))["mode"], "STOP");
    let state = client.ask(json!({ "verb": "state" }));
    assert_eq!((&state["mode"], &state["stop"]["event"]), (&json!("STOP"), &json!("16#4304")));
    assert_eq!(client.ask(json!({ "verb": "mode", "mode": "mres" }))["mode"], "STOP");
    assert_eq!(client.value("DB1.n"), json!(0), "all memory is as after loading");
    for restart in ["warm", "cold", "hot"] {
        assert_eq!(client.ask(json!({ "verb": "mode", "mode": "run", "restart": restart }))["mode"], "RUN", "{restart}");
        until("it scans", || (client.value("DB1.n") != 0).then_some(()));
        client.ask(json!({ "verb": "mode", "mode": "stop" }));
    }
    // Whoever has stopped the CPU may end the run: that is no failure of the program.
    let (code, messages) = run.stop();
    assert_eq!(code, Some(0), "{messages}");
    assert!(!run.socket.exists(), "it goes with the run");
}

#[test]
fn what_the_screen_asks_for_is_there_for_everyone() {
    let folder = project();
    let mut run = Running::of_project(&folder, &[]);
    let mut client = run.client();

    let names = client.ask(json!({ "verb": "names" }));
    let rows = names["rows"].as_array().expect("rows");
    let row = |address: &str| rows.iter().find(|row| row["address"] == address).unwrap_or_else(|| panic!("{address}: {names}"));
    assert_eq!((&names["total"], &names["next"]), (&json!(rows.len()), &Value::Null));
    assert_eq!((&row("I 0.0")["item"], &row("I 0.0")["symbol"], &row("I 0.0")["terminal"]), (&json!("I 0.0"), &json!(""), &Value::Null));
    assert!(rows.iter().any(|row| row["address"] == "MW 20"), "{names}");

    let plants = client.ask(json!({ "verb": "plants" }));
    let tank = &plants["plants"][0];
    assert_eq!(
        (&tank["module"], &tank["kind"], &tank["input"], &tank["output"]),
        (&json!("tank"), &json!("tank"), &json!(256), &json!(256))
    );
    assert_eq!((tank["inputs"].as_str().map(str::len), tank["outputs"].as_str().map(str::len)), (Some(8), Some(8)), "{tank}");
    let signals = tank["signals"].as_array().expect("signals");
    assert!(signals.iter().any(|signal| signal["address"] == "I 256.0" && signal["direction"] == "sensor"), "{tank}");
    assert!(tank["state"].as_array().is_some_and(|state| state.iter().all(|row| row["value"].is_number())), "{tank}");

    // Where OB 1 does more than call it is what a screen begins with.
    let listing = client.ask(json!({ "verb": "listing" }));
    assert_eq!((&listing["block"], &listing["form"], &listing["next"]), (&json!("OB 1"), &json!("statements"), &Value::Null));
    let texts: Vec<&str> = listing["lines"].as_array().expect("lines").iter().filter_map(|line| line["text"].as_str()).collect();
    assert_eq!(texts, ["CALL FC 1", "L DB1.DBW 0", "T MW 20", "A M 50.0", "CC FC 2", "A I 0.0", "= Q 0.0"]);
    assert_eq!(listing["lines"][5]["file"].as_str().map(|file| file.ends_with("main.awl")), Some(true), "{listing}");
    let part = client.ask(json!({ "verb": "listing", "block": "FC 1", "from": 2 }));
    assert_eq!(part["lines"].as_array().map(Vec::len), Some(2), "{part}");
    // Networks are those of the program, whatever its comments say.
    let listing = client.ask(json!({ "verb": "listing", "block": "FC 2" }));
    let lines: Vec<&Value> = listing["lines"].as_array().into_iter().flatten().collect();
    assert_eq!((lines.len(), lines.first()), (3, Some(&&json!({ "network": 2, "title": "The end" }))), "{listing}");
    for block in ["FC 77", "DB 1", "SFC 46"] {
        assert_eq!(client.ask(json!({ "verb": "listing", "block": block }))["error"]["code"], "P7095", "{block}");
    }

    // Changes are seen from the first request on.
    let newest = client.ask(json!({ "verb": "changes" }))["newest"].as_u64().expect("a number");
    let scans = client.ask(json!({ "verb": "state" }))["scans"].as_u64();
    until("a scan compares", || (client.ask(json!({ "verb": "state" }))["scans"].as_u64() > scans.map(|scans| scans + 1)).then_some(()));
    client.ask(json!({ "verb": "write", "values": { "I0.0": 1 } }));
    let change = until("the output changes", || {
        let changes = client.ask(json!({ "verb": "changes", "after": newest }));
        changes["entries"].as_array().into_iter().flatten().find(|entry| entry["address"] == "Q 0.0").cloned()
    });
    assert_eq!((&change["before"], &change["after"], &change["comment"]), (&json!("0"), &json!("1"), &json!("")));
    client.ask(json!({ "verb": "mode", "mode": "stop" }));
    until("the mode is noted", || {
        let changes = client.ask(json!({ "verb": "changes", "after": newest }));
        changes["entries"].as_array().into_iter().flatten().any(|entry| entry["note"] == "CPU in STOP").then_some(())
    });
    client.ask(json!({ "verb": "mode", "mode": "run" }));

    // A status without waiting is there as soon as a scan was recorded, and not again.
    let sample = until("a sample", || {
        let status = client.ask(json!({ "verb": "status", "block": "OB 1", "wait": false }));
        status["statements"].as_array().is_some_and(|statements| !statements.is_empty()).then(|| status["sample"].clone())
    });
    assert!(sample.as_u64().is_some_and(|sample| sample > 0));

    // A button has the other value for so long, in the time of the CPU, and a second press changes nothing.
    client.ask(json!({ "verb": "time", "time": "step" }));
    client.ask(json!({ "verb": "write", "values": { "I0.0": 0, "I0.1": 1 } }));
    let press = json!({ "verb": "press", "items": ["I0.0", "I0.1", "MW20"], "ms": 100 });
    let pressed = client.ask(press.clone());
    assert_eq!((&pressed["done"], &pressed["items"][2]["error"]["code"]), (&json!(2), &json!("P7104")), "{pressed}");
    client.ask(press);
    // Also where another client asks for it by another name.
    run.client().ask(json!({ "verb": "press", "items": ["E0.0", "E 0.1"], "ms": 200 }));
    client.ask(json!({ "verb": "time", "time": "step", "scans": 3 }));
    assert_eq!((client.value("I0.0"), client.value("I0.1")), (json!(1), json!(0)));
    client.ask(json!({ "verb": "time", "time": "step", "scans": 12 }));
    assert_eq!((client.value("I0.0"), client.value("I0.1")), (json!(0), json!(1)));
    run.stop();
}

#[test]
fn a_stop_of_the_program_ends_the_run_and_tells_who_asks() {
    for speed in ["1x", "max"] {
        let folder = project();
        let mut run = Running::of_project(&folder, &["--speed", speed, "--retain", "none"]);
        let (mut client, mut other) = (run.client(), run.client());
        for _ in 0..3 {
            assert_eq!(client.ask(json!({ "verb": "mode", "mode": "stop" }))["mode"], "STOP");
            let scans = client.ask(json!({ "verb": "state" }))["scans"].clone();
            assert_eq!(client.ask(json!({ "verb": "state" }))["scans"], scans, "nothing is scanned");
            assert_eq!(other.ask(json!({ "verb": "mode", "mode": "run" }))["mode"], "RUN");
        }
        // Now the program stops itself.
        client.try_ask(json!({ "verb": "write", "values": { "M50.0": 1 } }));
        while let Some(answer) = other.try_ask(json!({ "verb": "state" })) {
            assert!(answer.get("error").is_none_or(|error| error["code"] == "P7094"), "{answer}");
        }
        assert_eq!(run.child.wait().expect("the binary ends").code(), Some(4), "{speed}");
        assert!(!run.socket.exists());
    }
}

#[test]
fn of_two_runs_the_first_one_answers() {
    let folder = Folder::with(&[("main.awl", PROGRAM)]);
    let place = runtime(&folder).join("sieben");
    let mut first = Running::in_folder(&folder, &["run", "main.awl"], &place);
    assert_eq!(fs::metadata(&place).expect("a folder").permissions().mode() & 0o777, 0o700);
    let (code, _, messages) = finished(&folder, &["run", "main.awl", "--for", "50ms"]);
    assert_eq!(code, Some(0));
    assert_eq!(messages.matches("Another run of this program answers").count(), 1, "{messages}");
    let (code, result, messages) = finished(&folder, &["run", "main.awl", "--for", "50ms", "--json"]);
    assert_eq!((code, messages.as_str()), (Some(0), ""), "{result}");
    assert_eq!(first.client().ask(json!({ "verb": "state" }))["mode"], "RUN", "the socket is still there");
    // Another program has a socket of its own.
    folder.write("other.awl", PROGRAM.as_bytes());
    let (_, _, messages) = finished(&folder, &["run", "other.awl", "--for", "50ms"]);
    assert!(!messages.contains("Another run"), "{messages}");
    assert_eq!(first.stop().0, Some(0));
    assert_eq!(sockets(&place), Vec::<PathBuf>::new());
}

#[test]
fn the_socket_of_a_killed_run_is_replaced() {
    let folder = project();
    let mut clean = Running::of_project(&folder, &["--retain", "none"]);
    assert_eq!(clean.stop().0, Some(0));
    assert!(!folder.path().join(".sieben").exists(), "the folder goes too, for nothing else is in it");
    let mut killed = Running::of_project(&folder, &["--retain", "none"]);
    killed.child.kill().expect("it is there");
    killed.child.wait().expect("it ends");
    assert!(killed.socket.exists(), "nobody has removed it");
    let (code, _, messages) = finished(&folder, &["top"]);
    assert!(code == Some(2) && messages.contains("P7090"), "{messages}");
    let mut run = Running::of_project(&folder, &["--retain", "none"]);
    assert_eq!(run.client().ask(json!({ "verb": "state" }))["mode"], "RUN");
    assert_eq!(run.stop().0, Some(0));
    assert!(!run.socket.exists());
    // What is no socket stays.
    folder.write(".sieben/control.sock", b"precious");
    let (code, _, messages) = finished(&folder, &["run", ".", "--for", "50ms", "--retain", "none"]);
    assert_eq!((code, folder.read(".sieben/control.sock")), (Some(0), b"precious".to_vec()), "{messages}");
}

#[test]
fn where_the_project_cannot_hold_it_the_socket_lies_in_a_folder_of_the_user() {
    let deep = "a".repeat(100);
    for (files, arguments) in [
        (vec![(format!("{deep}/sieben.toml"), PROJECT), (format!("{deep}/main.awl"), PROGRAM)], deep.as_str()),
        (vec![("sieben.toml".to_owned(), PROJECT), ("main.awl".to_owned(), PROGRAM), (".sieben".to_owned(), "no folder")], "."),
    ] {
        let folder = Folder::new();
        files.iter().for_each(|(name, text)| folder.write(name, text.as_bytes()));
        let place = runtime(&folder).join("sieben");
        let mut run = Running::in_folder(&folder, &["run", arguments, "--retain", "none"], &place);
        let name = run.socket.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
        assert!(name.starts_with("sieben-") && name.len() == "sieben-0123456789abcdef.sock".len(), "{name}");
        let (code, json, messages) = finished(&folder, &["top", arguments, "--json"]);
        assert_eq!((code, messages.as_str()), (Some(0), ""));
        assert_eq!(serde_json::from_str::<Value>(&json).expect("JSON")["project"], "pump");
        assert_eq!(run.stop().0, Some(0));
    }
}

#[test]
fn a_folder_that_others_may_use_is_not_taken() {
    let folder = Folder::with(&[("main.awl", PROGRAM)]);
    let (place, temporary) = (runtime(&folder).join("sieben"), folder.path().join("tmp"));
    fs::create_dir_all(&temporary).expect("the folder is writable");
    fs::create_dir(&place).expect("the folder is writable");
    fs::set_permissions(&place, fs::Permissions::from_mode(0o755)).expect("it is ours");
    let mut command = sieben(folder.path(), &["run", "main.awl"]);
    command.env("XDG_RUNTIME_DIR", runtime(&folder)).env("TMPDIR", &temporary).stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().expect("the binary starts");
    let found = until("the run answers", || {
        let own = fs::read_dir(&temporary).ok()?.flatten().next()?.path();
        sockets(&own).into_iter().find(|path| UnixStream::connect(path).is_ok())
    });
    assert!(found.parent().and_then(Path::file_name).is_some_and(|name| name.to_string_lossy().starts_with("sieben-")), "{found:?}");
    assert_eq!(sockets(&place), Vec::<PathBuf>::new());
    signal(&child, "-INT");
    assert_eq!(child.wait().expect("the binary ends").code(), Some(0));
}

#[test]
fn what_comes_in_as_garbage_goes_out_as_an_error() {
    let folder = project();
    let run = Running::of_project(&folder, &[]);
    let mut client = run.client();
    for line in ["garbage", "{}", "[]", "\u{0}", "{\"verb\":\"read\",\"items\":5}", &"[".repeat(60_000), "{\"id\":{},\"verb\":\"state\"}"] {
        client.send(line);
        assert_eq!(client.receive().expect("an answer")["error"]["code"], "P7091", "{line:.40}");
    }
    let million = format!("{{\"verb\":\"read\",\"items\":[{}]}}", vec!["\"MW0\""; 1_000_000].join(","));
    let many = format!("{{\"id\":5,\"verb\":\"read\",\"items\":[{}]}}", vec!["\"MW0\""; 1_001].join(","));
    let large = "{\"verb\":\"read\",\"items\":[\"P#M 0.0 BYTE 65535\",\"P#I 0.0 BYTE 65535\"]}";
    for line in [million.as_str(), &many, large] {
        client.send(line);
        assert_eq!(client.receive().expect("an answer")["error"]["code"], "P7092", "{line:.60}");
    }
    // Bytes that are no text, and half a line of somebody who dies.
    client.0.get_mut().write_all(b"\xff\xfe\n").expect("the run reads");
    assert_eq!(client.receive().expect("an answer")["error"]["code"], "P7091");
    let mut dies = UnixStream::connect(&run.socket).expect("the run answers");
    dies.write_all(b"{\"verb\":\"write\",\"values\":{\"MW30\":").expect("the run reads");
    drop(dies);
    let most = format!("{{\"verb\":\"read\",\"items\":[{}]}}", vec!["\"MW0\""; 1_000].join(","));
    client.send(&most);
    assert_eq!(client.receive().expect("an answer")["items"].as_array().map(Vec::len), Some(1_000));
    assert_eq!(client.ask(json!({ "verb": "state" }))["mode"], "RUN");
    until("those who are gone are not counted", || (client.ask(json!({ "verb": "state" }))["connections"] == 1).then_some(()));
}

#[test]
fn who_never_reads_is_left_and_holds_up_nothing() {
    let folder = project();
    let run = Running::of_project(&folder, &[]);
    let mut silent = UnixStream::connect(&run.socket).expect("the run answers");
    silent.set_nonblocking(true).expect("a socket");
    let request = format!("{{\"verb\":\"read\",\"items\":[{}]}}\n", vec!["\"MW0\""; 500].join(","));
    let mut full = 0;
    until("its buffers are full", || {
        match silent.write(request.as_bytes()) {
            Ok(_) => full = 0,
            Err(error) if error.kind() == ErrorKind::WouldBlock => full += 1,
            Err(error) => panic!("{error}"),
        }
        (full > 50).then_some(())
    });
    let mut client = run.client();
    for _ in 0..20 {
        let before = client.ask(json!({ "verb": "state" }))["scans"].as_u64();
        until("the scans go on", || (client.ask(json!({ "verb": "state" }))["scans"].as_u64() > before).then_some(()));
    }
    until("it is left", || (client.ask(json!({ "verb": "state" }))["connections"] == 1).then_some(()));
}

#[test]
fn the_seventeenth_is_refused() {
    let folder = project();
    let run = Running::of_project(&folder, &[]);
    until("whoever looked for the socket is gone", || (run.client().ask(json!({ "verb": "state" }))["connections"] == 1).then_some(()));
    let mut first = run.client();
    until("nobody else is there", || (first.ask(json!({ "verb": "state" }))["connections"] == 1).then_some(()));
    let mut clients: Vec<Client> = (1..16).map(|_| run.client()).collect();
    for client in &mut clients {
        assert_eq!(client.ask(json!({ "verb": "state" }))["mode"], "RUN");
    }
    assert_eq!(first.ask(json!({ "verb": "state" }))["connections"], 16);
    let mut refused = run.client();
    assert_eq!(refused.receive().expect("a line")["error"]["code"], "P7092");
    assert!(refused.receive().is_none(), "and it is over");
    clients.pop();
    until("another one may come", || {
        let mut next = run.client();
        next.try_ask(json!({ "verb": "state" })).is_some_and(|answer| answer["mode"] == "RUN").then_some(())
    });
}

#[test]
fn an_online_change_gives_names_their_new_meaning() {
    let counting = |fields: &str, db: &str| format!("{db}ORGANIZATION_BLOCK OB 1\nBEGIN\n{fields}\nEND_ORGANIZATION_BLOCK\n");
    let db = |fields: &str| format!("DATA_BLOCK DB 1\nSTRUCT\n {fields}\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
    let body = "L DB1.n; L 1; +I; T DB1.n; T MW 10;";
    let folder = Folder::with(&[("sieben.toml", "[project]\nname = \"change\"\n"), ("main.awl", &counting(body, &db("n : INT;")))]);
    let run = Running::of_project(&folder, &["--watch", "--accept-losses"]);
    let mut client = run.client();
    let same = |client: &mut Client| {
        let read = client.ask(json!({ "verb": "read", "items": ["DB1.n", "MW10"] }));
        let (n, mirror) = (read["items"][0]["value"].as_u64(), read["items"][1]["value"].as_str().map(str::to_owned));
        assert_eq!(n.map(|n| format!("16#{n:04X}")), mirror, "{read}");
    };
    same(&mut client);
    folder.write("main.awl", counting(body, &db("more : DINT; n : INT;")).as_bytes());
    until("the change has come", || (client.value("DB1.more") == 0).then_some(()));
    same(&mut client);
    // The data block goes: its items are an error, the others are not.
    folder.write("main.awl", counting("L 1; T MW 10;", "").as_bytes());
    until("the data block is gone", || (client.value("DB1.n") == "P7003").then_some(()));
    let read = client.ask(json!({ "verb": "read", "items": ["DB1.DBW0", "MW10"] }));
    assert_eq!((&read["items"][0]["error"]["code"], &read["items"][1]["value"]), (&json!("P7003"), &json!("16#0001")), "{read}");
    let written = client.ask(json!({ "verb": "write", "values": { "MW12": 5, "DB1.DBW0": 5 } }));
    assert_eq!((&written["scan"], client.value("MW12")), (&Value::Null, json!("16#0000")), "{written}");
    assert_eq!(client.ask(json!({ "verb": "blocks" }))["total"], 1);
}

#[test]
fn the_demo_is_looked_at_stopped_and_stepped_from_outside() {
    let folder = Folder::with(&[("demo/sieben.toml", PROJECT), ("demo/main.awl", PROGRAM)]);
    let place = runtime(&folder).join("sieben");
    let mut run = Running::in_folder(&folder, &["demo", "--speed", "20x"], &place);
    let mut client = run.client();
    let state = |client: &mut Client| client.ask(json!({ "verb": "state" }));
    let time = |client: &mut Client, fields: Value| {
        let mut request = json!({ "verb": "time" });
        fields.as_object().into_iter().flatten().for_each(|(key, value)| request[key] = value.clone());
        client.ask(request)
    };
    assert_eq!(state(&mut client)["project"], "demo");
    until("the story opens the valve", || (client.value("VALVE") == 1).then_some(()));
    assert_eq!(client.value("Q 0.0"), 1);
    let status = client.ask(json!({ "verb": "status", "block": "OB1" }));
    assert_eq!((&status["same"], status["statements"].as_array().map(Vec::len)), (&json!(true), Some(16)), "{status}");

    assert_eq!(time(&mut client, json!({ "time": "pause" }))["paused"], true);
    let before = time(&mut client, json!({ "time": "step" }));
    let after = time(&mut client, json!({ "time": "step", "scans": 7 }));
    let number = |answer: &Value, key: &str| answer[key].as_f64().unwrap_or_else(|| panic!("{answer}"));
    assert_eq!(number(&after, "scans"), number(&before, "scans") + 7.0);
    assert_eq!(number(&after, "time_ms"), number(&before, "time_ms") + 70.0, "each scan is one cycle");
    client.ask(json!({ "verb": "force", "values": { "VALVE": 0 } }));
    time(&mut client, json!({ "time": "step" }));
    assert_eq!((client.value("VALVE"), &state(&mut client)["forced"][0]["name"]), (json!(0), &json!("Q 0.0")));
    client.ask(json!({ "verb": "unforce_all" }));

    assert_eq!(time(&mut client, json!({ "time": "speed", "speed": "10x" }))["speed"], "10x");
    assert_eq!(time(&mut client, json!({ "time": "go" }))["paused"], false);
    assert_eq!(client.ask(json!({ "verb": "mode", "mode": "stop" }))["mode"], "STOP");
    let stopped = state(&mut client);
    until("the plant lives on", || (number(&state(&mut client), "time_ms") > number(&stopped, "time_ms") + 500.0).then_some(()));
    assert_eq!(state(&mut client)["scans"], stopped["scans"]);
    assert_eq!(client.ask(json!({ "verb": "mode", "mode": "mres" }))["mode"], "STOP");
    assert_eq!(client.ask(json!({ "verb": "mode", "mode": "run" }))["mode"], "RUN");
    until("it scans again", || (number(&state(&mut client), "scans") > number(&stopped, "scans")).then_some(()));

    // Another demo does without the socket, and `top` finds the first one, unless a program of that name runs here.
    let (code, text, messages) = finished(&folder, &["demo", "--speed", "max", "--for", "4s"]);
    assert!(code == Some(0) && text.contains("400 scans in 4.00 s"), "{text}");
    assert_eq!(messages.matches("Another run of this program answers").count(), 1, "{messages}");
    let project = |arguments: &[&str]| {
        let (code, text, messages) = finished(&folder, arguments);
        assert_eq!((code, messages.as_str()), (Some(0), ""));
        serde_json::from_str::<Value>(&text).expect("JSON")
    };
    let look = project(&["top", "demo", "--json", "--show", "LITRES"]);
    assert!(look["project"] == "demo" && look["values"]["LITRES"].is_number(), "{look}");
    let (code, _, messages) = finished(&folder, &["top"]);
    assert!(code == Some(2) && messages.contains("The demo runs: `sieben top demo`"), "{messages}");
    let mut other = Running::in_folder(&folder, &["run", "demo"], &folder.path().join("demo/.sieben"));
    assert_eq!(project(&["top", "demo", "--json"])["project"], "pump");
    assert_eq!(other.stop().0, Some(0));

    assert_eq!(run.stop().0, Some(0));
    assert_eq!(sockets(&place), Vec::<PathBuf>::new());
    let (code, _, messages) = finished(&folder, &["top", "demo"]);
    assert!(code == Some(2) && messages.contains("no demo answers") && messages.contains("`sieben demo`"), "{messages}");
}

#[test]
fn the_socket_of_a_killed_demo_is_replaced() {
    let folder = Folder::new();
    let place = runtime(&folder).join("sieben");
    let mut killed = Running::in_folder(&folder, &["demo"], &place);
    killed.child.kill().expect("it is there");
    killed.child.wait().expect("it ends");
    assert!(killed.socket.exists());
    let mut run = Running::in_folder(&folder, &["demo"], &place);
    assert_eq!((&run.socket, run.client().value("STOP")), (&killed.socket, json!(1)));
    let (code, messages) = run.stop();
    assert_eq!((code, messages.as_str()), (Some(0), ""));
    assert!(!run.socket.exists());
}

#[test]
fn top_looks_once_where_no_terminal_is() {
    let folder = project();
    let (code, text, messages) = finished(&folder, &["top"]);
    assert_eq!((code, text.as_str()), (Some(2), ""));
    assert!(messages.contains("[P7090] Error: no run of this folder answers"), "{messages}");
    let (code, _, messages) = finished(&folder, &["top", "nowhere"]);
    assert!(code == Some(2) && messages.contains("P6001"), "{messages}");
    let (code, _, messages) = finished(&folder, &["top", "--json"]);
    assert_eq!((code, &serde_json::from_str::<Value>(&messages).expect("JSON")[0]["code"]), (Some(2), &json!("P7090")));

    let mut run = Running::of_project(&folder, &[]);
    run.client().ask(json!({ "verb": "write", "values": { "MW30": "W#16#ABCD", "I0.0": 1 } }));
    until("the output follows the input", || (run.client().value("Q0.0") == 1).then_some(()));
    let (code, text, messages) = finished(&folder, &["top", "--show", "MW30,DB1.text", "--show", "I0.0"]);
    assert_eq!((code, messages.as_str()), (Some(0), ""));
    for part in [
        "`pump` on a CPU 315-2PN/DP: RUN, 1x",
        "IB0 to IB3  16#01 16#00",
        "MW30      16#ABCD",
        "DB1.text  ''",
        "I0.0      1",
        "mode change from STARTUP to RUN",
        "OB 1",
    ] {
        assert!(text.contains(part), "{part}:\n{text}");
    }
    let (_, text, _) = finished(&folder, &["top", "sieben.toml", "--json", "--show", "MW30"]);
    let look: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!((&look["mode"], &look["values"]["MW30"], &look["values"]["IB0"]), (&json!("RUN"), &json!("16#ABCD"), &json!("16#01")));
    assert!(look["diagnostic_buffer"].as_array().is_some_and(|entries| entries.len() >= 2), "{look}");
    assert_eq!(look["block_count"], 4);
    let (code, _, messages) = finished(&folder, &["top", "--show", "XW1"]);
    assert!(code == Some(2) && messages.contains("P7003"), "{messages}");
    run.client().ask(json!({ "verb": "mode", "mode": "stop" }));
    let (_, text, _) = finished(&folder, &["top", "."]);
    assert!(text.contains("STOP, 1x\n  STOP by a programming device"), "{text}");
    assert_eq!(run.stop().0, Some(0));
}
