//! The language server beside others: runs of the program, files in code pages, other servers and projects, texts of any size.
#![cfg(unix)]

mod lsp_client;

use std::process::{Child, Command, Stdio};

use lsp_client::{Client, codes};
use serde_json::{Value, json};

const SYMBOLS: &str = "symbol,address,type,comment\nPump,Q4.0,BOOL,the pump\n";
const COUNTER: &str =
    "ORGANIZATION_BLOCK OB 1\nBEGIN\n      SET;\n      =     \"Pump\";\n      L     7;\n      T     MW 10;\nEND_ORGANIZATION_BLOCK\n";

/// A run of a folder; it is ended when this goes.
struct Run(Child);

impl Run {
    fn of(client: &Client) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sieben"));
        let arguments = ["run", ".", "--no-page", "--cycle", "20ms"];
        command.args(arguments).current_dir(&client.folder).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        Self(command.spawn().expect("the binary starts"))
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn hints(client: &mut Client) -> Vec<String> {
    let uri = client.uri("main.awl");
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let hints = client.result("textDocument/inlayHint", json!({ "textDocument": { "uri": uri }, "range": range }));
    hints.as_array().into_iter().flatten().map(|hint| hint["label"].as_str().unwrap_or_default().to_owned()).collect()
}

#[test]
fn hints_have_the_values_of_a_run_and_are_renewed_when_it_comes_and_goes() {
    let files = [("sieben.toml", "[project]\nname = \"pump\"\n"), ("symbols.csv", SYMBOLS), ("main.awl", COUNTER)];
    let mut client = Client::start("live", &files, &json!({ "workspace": { "inlayHint": { "refreshSupport": true } } }));
    client.open("main.awl", COUNTER);
    assert_eq!(hints(&mut client), ["Q 4.0"], "without a run there are no values");
    let is_refresh = |message: &Value| message["method"] == "workspace/inlayHint/refresh";
    let run = Run::of(&client);
    client.wait("hints are old when the run is there", is_refresh);
    // The first scan may not have come yet.
    while hints(&mut client) != ["Q 4.0 = 1", "= 16#0007 (7)"] {
        client.wait("values are others", is_refresh);
    }
    drop(run);
    client.wait("hints are old when the run is over", is_refresh);
    assert_eq!(hints(&mut client), ["Q 4.0"]);
    assert_eq!(client.shut_down(), Some(0));
}

#[test]
fn a_file_in_a_code_page_is_read_as_it_lies_and_not_changed() {
    let text = "// l\u{E4}uft\nORGANIZATION_BLOCK OB 1\nBEGIN\n      =     \"Pump\";\nEND_ORGANIZATION_BLOCK\n";
    let lossy = text.replace('\u{E4}', "\u{FFFD}");
    let mut client = Client::silent("page", &[("symbols.csv", SYMBOLS)]);
    let on_disk: Vec<u8> = text.chars().map(|character| u8::try_from(u32::from(character)).expect("Windows 1252")).collect();
    std::fs::write(client.folder.join("main.awl"), &on_disk).expect("the file can be written");
    client.hello(&json!({}));
    client.open("main.awl", &lossy);
    let message = client.wait("a message to the user", |message| message["method"] == "window/showMessage");
    assert!(message["params"]["message"].as_str().is_some_and(|text| text.contains("Windows 1252")), "{message}");
    let uri = client.uri("main.awl");
    let position = json!({ "line": 3, "character": 14 });
    let renamed = client.ask("textDocument/rename", json!({ "textDocument": { "uri": uri }, "position": position, "newName": "Other" }));
    assert!(renamed["error"]["message"].as_str().is_some_and(|why| why.contains("wrong encoding")), "{renamed}");
    let options = json!({ "tabSize": 2, "insertSpaces": true });
    let formatted = client.ask("textDocument/formatting", json!({ "textDocument": { "uri": uri }, "options": options }));
    assert!(formatted["error"]["message"].as_str().is_some_and(|why| why.contains("wrong encoding")), "{formatted}");
    // Reopened with its encoding, which editors tell as a change, it is a text as any other.
    let lost = json!({ "start": { "line": 0, "character": 4 }, "end": { "line": 0, "character": 5 } });
    client.change("main.awl", 2, &json!([{ "range": lost, "text": "\u{E4}" }]));
    let renamed = client.result("textDocument/rename", json!({ "textDocument": { "uri": uri }, "position": position, "newName": "Other" }));
    assert!(renamed.to_string().contains("Other"), "{renamed}");
    assert_eq!(client.shut_down(), Some(0));
    assert_eq!(std::fs::read(client.folder.join("main.awl")).ok().as_ref(), Some(&on_disk));
}

#[test]
fn a_text_that_is_too_large_is_said_to_be_and_others_are_looked_at() {
    let mut client = Client::start("large", &[("main.awl", COUNTER)], &json!({}));
    let large = format!("// {}\n", "x".repeat((64 << 20) + 1));
    client.open("large.awl", &large);
    assert_eq!(client.diagnostics("large.awl", Some(1)).len(), 1);
    let uri = client.uri("large.awl");
    client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
    client.open("main.awl", COUNTER);
    assert_eq!(codes(&client.diagnostics("main.awl", Some(1))), ["P3020"]);
    client.change("large.awl", 2, &json!([{ "text": COUNTER }]));
    assert!(!client.diagnostics("large.awl", Some(2)).is_empty(), "now it is looked at: OB 1 is there twice");
    assert_eq!(client.shut_down(), Some(0));
}

#[test]
fn two_servers_and_two_projects_have_each_their_own() {
    let project = |name: &str| format!("[project]\nname = \"{name}\"\n");
    let (one, two) = (project("one"), project("two"));
    let other = "symbol,address,type,comment\nPump,Q5.7,BOOL,another pump\n";
    let files = [
        ("one/sieben.toml", one.as_str()),
        ("one/symbols.csv", SYMBOLS),
        ("one/main.awl", COUNTER),
        ("two/sieben.toml", two.as_str()),
        ("two/symbols.csv", other),
        ("two/main.awl", COUNTER),
    ];
    let mut first = Client::silent("two", &files);
    let folders: Vec<Value> = ["one", "two"].map(|name| json!({ "uri": first.uri(name), "name": name })).to_vec();
    first.result("initialize", json!({ "processId": null, "workspaceFolders": folders, "capabilities": {} }));
    first.tell("initialized", json!({}));
    let pump = |client: &mut Client, path: &str| {
        let uri = client.uri(path);
        let position = json!({ "line": 3, "character": 14 });
        client.result("textDocument/hover", json!({ "textDocument": { "uri": uri }, "position": position })).to_string()
    };
    for path in ["one/main.awl", "two/main.awl"] {
        first.open(path, COUNTER);
    }
    assert!(pump(&mut first, "one/main.awl").contains("Q 4.0") && pump(&mut first, "two/main.awl").contains("Q 5.7"));
    // A second server over the same files: what one of them has open does not matter to the other.
    let mut second = Client::in_folder(&first.folder.join("one"), &json!({}));
    first.change("one/main.awl", 2, &json!([{ "text": "half a " }]));
    assert!(!first.diagnostics("one/main.awl", Some(2)).is_empty());
    second.open("main.awl", COUNTER);
    assert_eq!(codes(&second.diagnostics("main.awl", Some(1))), Vec::<String>::new());
    assert!(pump(&mut first, "two/main.awl").contains("Q 5.7"), "the other project stays as it is");
    assert_eq!((first.shut_down(), second.shut_down()), (Some(0), Some(0)));
}

#[test]
fn what_a_client_spells_or_leaves_out_is_taken_all_the_same() {
    let mut client = Client::start("spelled", &[("Tür a.awl", COUNTER)], &json!({}));
    let uri = format!("file://{}/Tür a.awl", client.folder.display());
    let until = |client: &mut Client, count: usize| {
        let list = |message: &Value| message["params"]["diagnostics"].as_array().map(Vec::len);
        let is_it = |message: &Value| message["method"] == "textDocument/publishDiagnostics" && list(message) == Some(count);
        client.wait(&format!("{count} diagnostics"), is_it);
    };
    client.tell("textDocument/didOpen", json!({ "textDocument": { "uri": uri, "languageId": "awl", "text": COUNTER } }));
    until(&mut client, 1);
    let empty = "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n";
    client.tell("textDocument/didChange", json!({ "textDocument": { "uri": uri }, "contentChanges": [{ "text": empty }] }));
    until(&mut client, 0);
    assert_eq!(client.shut_down(), Some(0));
}

#[test]
fn an_inner_project_has_its_own_symbols_and_files_of_no_watcher_are_read_again() {
    let files = [
        ("sieben.toml", "[project]\nname = \"outer\"\nsources = [\"main.awl\"]\n"),
        ("main.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n"),
        ("in/sieben.toml", "[project]\nname = \"inner\"\n"),
        ("in/symbols.csv", SYMBOLS),
        ("in/main.awl", COUNTER),
    ];
    let mut client = Client::start("inner", &files, &json!({}));
    client.open("in/main.awl", COUNTER);
    assert_eq!(codes(&client.diagnostics("in/main.awl", Some(1))), Vec::<String>::new());
    // A row comes on top of the table, and nothing says so.
    let table = SYMBOLS.replacen('\n', "\nOther,Q5.0,BOOL,\n", 1);
    std::fs::write(client.folder.join("in/symbols.csv"), &table).expect("the file can be written");
    let uri = client.uri("in/main.awl");
    let asked = json!({ "textDocument": { "uri": uri }, "position": { "line": 3, "character": 14 }, "newName": "Drive" });
    let renamed = client.result("textDocument/rename", asked);
    let of_table = &renamed["changes"][client.uri("in/symbols.csv")][0];
    assert_eq!((of_table["range"]["start"]["line"].as_u64(), of_table["newText"].as_str()), (Some(2), Some("Drive")), "{renamed}");
    assert_eq!(client.shut_down(), Some(0));
}

#[test]
fn settings_that_are_not_said_again_stay() {
    let german = "ORGANIZATION_BLOCK OB 1\nBEGIN\n      U     E 0.0;\n      =     A 4.0;\nEND_ORGANIZATION_BLOCK\n";
    let mut client = Client::silent("settings", &[("main.awl", german)]);
    let folder = client.uri("");
    let options = json!({ "mnemonics": "en", "liveValues": false });
    client.result("initialize", json!({ "processId": null, "rootUri": folder, "capabilities": {}, "initializationOptions": options }));
    client.tell("initialized", json!({}));
    client.open("main.awl", german);
    let wrong = codes(&client.diagnostics("main.awl", Some(1)));
    assert!(!wrong.is_empty(), "it is read as international mnemonics");
    client.tell("workspace/didChangeConfiguration", json!({ "settings": {} }));
    client.change("main.awl", 2, &json!([{ "text": format!("{german}\n") }]));
    assert_eq!(codes(&client.diagnostics("main.awl", Some(2))), wrong);
    client.tell("workspace/didChangeConfiguration", json!({ "settings": { "sieben": { "mnemonics": "auto" } } }));
    client.change("main.awl", 3, &json!([{ "text": german }]));
    assert_eq!(codes(&client.diagnostics("main.awl", Some(3))), Vec::<String>::new());
    assert_eq!(client.shut_down(), Some(0));
}
