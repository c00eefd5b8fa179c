//! The language server as a client sees it: each feature by a scripted conversation, and what must not end it.

mod lsp_client;

use std::process::Command;

use lsp_client::{Client, checked, codes, position, slice};
use serde_json::{Value, json};

const SYMBOLS: &str = "symbol;address;type;comment\nStart;I0.0;BOOL;starts the pump\nPump;Q4.0;BOOL;the pump\nDosing;FC1;FC1;doses\n";

const MAIN: &str = "\
ORGANIZATION_BLOCK OB 1
TITLE = the cycle
VAR_TEMP
  count : INT;
END_VAR
BEGIN
NETWORK
TITLE = Pump
// One.
// Two.
      A     \"Start\";
      JC    M001;
      =     \"Pump\";
M001: NOP   0;
NETWORK
TITLE = Dosing
      CALL  FC 1 (
        amount := 3);
      L     #count;
      T     MW 10;
END_ORGANIZATION_BLOCK
";

const DOSING: &str = "\
FUNCTION FC 1 : VOID
VAR_INPUT
  amount : INT; // litres
END_VAR
BEGIN
NETWORK
      L     #amount;
      T     MW 20;
END_FUNCTION
";

fn plant(name: &str) -> Client {
    let files = [("sieben.toml", "[project]\nname = \"plant\"\n"), ("symbols.csv", SYMBOLS), ("main.awl", MAIN), ("dosing.awl", DOSING)];
    let mut client = Client::start(name, &files, &json!({}));
    client.open("main.awl", MAIN);
    client
}

/// The text with a mark before a word.
fn marked(text: &str, word: &str) -> String {
    text.replacen(word, &format!("|{word}"), 1)
}

#[test]
fn what_is_wrong_is_told_as_check_tells_it_and_goes_when_it_is_right() {
    let wrong = MAIN.replace("=     \"Pump\"", "=     \"Pmup\"");
    let files =
        [("sieben.toml", "[project]\nsoruces = []\n"), ("symbols.csv", SYMBOLS), ("main.awl", wrong.as_str()), ("dosing.awl", DOSING)];
    let mut client = Client::start("check", &files, &json!({}));
    client.open("main.awl", &wrong);
    let main = client.diagnostics("main.awl", Some(1));
    let settings = client.diagnostics("sieben.toml", None);
    let mut told: Vec<(String, String, u64)> = Vec::new();
    for (file, list) in [("main.awl", &main), ("sieben.toml", &settings)] {
        told.extend(list.iter().map(|one| {
            (file.to_owned(), one["code"].as_str().unwrap_or_default().to_owned(), one["range"]["start"]["line"].as_u64().unwrap_or(0) + 1)
        }));
    }
    told.sort();
    assert_eq!(told, checked(&client.folder));
    assert!(main.iter().all(|one| one["codeDescription"]["href"].as_str().is_some_and(|href| href.starts_with("sieben:problems/P"))));
    assert_eq!(slice(&wrong, &main[0]["range"]), "\"Pmup\"");
    let at = position(&wrong.replace("\"Pmup\"", "|\"Pmup\""));
    let (line, column) = (at["line"].as_u64().unwrap_or(0), at["character"].as_u64().unwrap_or(0));
    let range = json!({ "start": at, "end": { "line": line, "character": column + 6 } });
    client.change("main.awl", 2, &json!([{ "range": range, "text": "\"Pump\"" }]));
    assert_eq!(client.diagnostics("main.awl", Some(2)), Vec::<Value>::new());
    // A text of another file, and its file on the disk.
    client.open("dosing.awl", &DOSING.replace("#amount", "#amuont"));
    assert_eq!(codes(&client.diagnostics("dosing.awl", Some(1))).len(), 1);
    let uri = client.uri("dosing.awl");
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    assert_eq!(client.diagnostics("dosing.awl", None), Vec::<Value>::new());
    // The settings are open, and right.
    client.open("sieben.toml", "[project]\nname = \"x\"\n");
    assert_eq!(client.diagnostics("sieben.toml", None), Vec::<Value>::new());
    assert_eq!(client.shut_down(), Some(0));
}

#[test]
fn one_text_has_an_outline_folds_tokens_and_selections() {
    let mut client = plant("outline");
    let text = json!({ "textDocument": { "uri": client.uri("main.awl") } });
    let outline = client.result("textDocument/documentSymbol", text.clone());
    let names = |rows: &Value| -> Vec<String> {
        rows.as_array()
            .into_iter()
            .flatten()
            .map(|row| format!("{} {}", row["name"].as_str().unwrap_or("-"), row["detail"].as_str().unwrap_or("-")))
            .collect()
    };
    assert_eq!(names(&outline), ["OB 1 the cycle"]);
    assert_eq!(names(&outline[0]["children"]), ["VAR_TEMP ", "Network 1 Pump", "Network 2 Dosing"]);
    assert_eq!(names(&outline[0]["children"][0]["children"]), ["count INT"]);
    assert_eq!(names(&outline[0]["children"][1]["children"]), ["M001 "]);
    let folds = client.result("textDocument/foldingRange", text.clone());
    let shown: Vec<String> = folds
        .as_array()
        .into_iter()
        .flatten()
        .map(|fold| format!("{}-{} {}", fold["startLine"], fold["endLine"], fold["kind"].as_str().unwrap_or("code")))
        .collect();
    for expected in ["0-20 code", "2-4 code", "6-13 region", "8-9 comment", "14-19 region"] {
        assert!(shown.iter().any(|one| one == expected), "{expected}: {shown:?}");
    }
    let tokens = client.result("textDocument/semanticTokens/full", text);
    let (mut line, mut column, mut seen) = (0, 0, Vec::new());
    for token in tokens["data"].as_array().expect("numbers").chunks(5) {
        let number = |index: usize| token[index].as_u64().unwrap_or(0);
        (line, column) = if number(0) == 0 { (line, column + number(1)) } else { (line + number(0), number(1)) };
        let range = json!({ "start": { "line": line, "character": column }, "end": { "line": line, "character": column + number(2) } });
        seen.push((slice(MAIN, &range), number(3)));
    }
    for (word, kind) in [("BEGIN", 1), ("JC", 2), ("M001", 3), ("\"Pump\"", 4), ("#count", 5), ("MW 10", 12), ("// One.", 0), ("3", 9)] {
        assert!(seen.contains(&(word.to_owned(), kind)), "{word}: {seen:?}");
    }
    let uri = client.uri("main.awl");
    let at = position(&marked(MAIN, "#count;"));
    let selections = client.result("textDocument/selectionRange", json!({ "textDocument": { "uri": uri }, "positions": [at] }));
    assert_eq!(slice(MAIN, &selections[0]["range"]), "#count");
    let mut outer = &selections[0];
    while !outer["parent"].is_null() {
        outer = &outer["parent"];
    }
    assert_eq!(slice(MAIN, &outer["range"]), MAIN);
}

#[test]
fn formatting_gives_the_edits_that_fmt_makes() {
    let mut client = plant("format");
    let ugly = "FUNCTION FC 9 : VOID\nBEGIN\nA I 0.0;\n= Q 4.0;\nEND_FUNCTION\n";
    client.open("ugly.awl", ugly);
    let uri = client.uri("ugly.awl");
    let edits = client
        .result("textDocument/formatting", json!({ "textDocument": { "uri": uri }, "options": { "tabSize": 4, "insertSpaces": true } }));
    let edits = edits.as_array().cloned().unwrap_or_default();
    assert!(!edits.is_empty());
    let mut made = ugly.to_owned();
    for edit in edits.iter().rev() {
        let old = slice(&made, &edit["range"]);
        made = made.replacen(&old, edit["newText"].as_str().unwrap_or_default(), 1);
    }
    std::fs::write(client.folder.join("ugly.awl"), ugly).expect("it can be written");
    let output =
        std::process::Command::new(env!("CARGO_BIN_EXE_sieben")).arg("fmt").arg(client.folder.join("ugly.awl")).output().expect("it runs");
    assert_eq!(made, String::from_utf8_lossy(&output.stdout));
    client.open("wrong.awl", "FUNCTION FC 8 : VOID\nBEGIN\n  )(;\n");
    let uri = client.uri("wrong.awl");
    let refused =
        client.ask("textDocument/formatting", json!({ "textDocument": { "uri": uri }, "options": { "tabSize": 4, "insertSpaces": true } }));
    assert_eq!(refused["error"]["code"], -32803, "{refused}");
}

#[test]
fn names_lead_to_what_they_mean_and_are_renamed_everywhere() {
    let mut client = plant("names");
    let definition = client.at("textDocument/definition", "main.awl", &marked(MAIN, "FC 1 ("))["result"].clone();
    assert!(definition[0]["uri"].as_str().is_some_and(|uri| uri.ends_with("/dosing.awl")), "{definition}");
    let uses = client.at("textDocument/references", "main.awl", &marked(MAIN, "Pump\";"))["result"].clone();
    let files: Vec<&str> = uses.as_array().into_iter().flatten().filter_map(|one| one["uri"].as_str()?.rsplit('/').next()).collect();
    assert!(files.contains(&"main.awl") && files.contains(&"symbols.csv"), "{uses}");
    let uri = client.uri("main.awl");
    let at = position(&marked(MAIN, "Pump\";"));
    let prepared = client.result("textDocument/prepareRename", json!({ "textDocument": { "uri": uri }, "position": at }));
    assert_eq!(prepared["placeholder"], "Pump");
    let edit = client.result("textDocument/rename", json!({ "textDocument": { "uri": uri }, "position": at, "newName": "Motor" }));
    let changes = edit["changes"].as_object().cloned().unwrap_or_default();
    assert_eq!(changes.len(), 2, "{edit}");
    let taken = client.ask("textDocument/rename", json!({ "textDocument": { "uri": uri }, "position": at, "newName": "Start" }));
    assert_eq!(taken["error"]["code"], -32803, "{taken}");
    assert!(taken["error"]["message"].as_str().is_some_and(|message| !message.is_empty()));
    let linked = client.at("textDocument/linkedEditingRange", "main.awl", &marked(MAIN, "M001: NOP"))["result"].clone();
    assert_eq!(linked["ranges"].as_array().map(Vec::len), Some(2), "{linked}");
    let symbols = client.result("workspace/symbol", json!({ "query": "pump" }));
    assert_eq!(symbols[0]["name"], "Pump", "{symbols}");
    let calls = client.at("textDocument/prepareCallHierarchy", "main.awl", &marked(MAIN, "FC 1 ("))["result"].clone();
    let callers = client.result("callHierarchy/incomingCalls", json!({ "item": calls[0] }));
    assert_eq!(callers[0]["from"]["name"], "OB 1", "{callers}");
    let highlights = client.at("textDocument/documentHighlight", "main.awl", &marked(MAIN, "M001;"))["result"].clone();
    assert_eq!(highlights.as_array().map(Vec::len), Some(2), "{highlights}");
}

#[test]
fn a_fix_is_offered_and_all_certain_ones_at_once() {
    let wrong = MAIN.replace("NOP   0", "N0P   0").replace("A     \"Start\"", "A     I O.0");
    let files = [("sieben.toml", ""), ("symbols.csv", SYMBOLS), ("main.awl", wrong.as_str()), ("dosing.awl", DOSING)];
    let mut client = Client::start("fixes", &files, &json!({}));
    client.open("main.awl", &wrong);
    let list = client.diagnostics("main.awl", Some(1));
    assert!(!list.is_empty());
    let uri = client.uri("main.awl");
    let all = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let actions = client
        .result("textDocument/codeAction", json!({ "textDocument": { "uri": uri }, "range": all, "context": { "diagnostics": list } }));
    let kinds: Vec<&str> = actions.as_array().into_iter().flatten().filter_map(|action| action["kind"].as_str()).collect();
    assert!(kinds.contains(&"quickfix"), "{actions}");
    let only = client.result(
        "textDocument/codeAction",
        json!({ "textDocument": { "uri": uri }, "range": all, "context": { "diagnostics": [], "only": ["source"] } }),
    );
    let only = only.as_array().expect("a list");
    assert_eq!(only.iter().map(|action| &action["kind"]).collect::<Vec<_>>(), ["source.fixAll.sieben"], "{only:?}");
    // All of them at once are what `check --fix` does.
    let mut fixed = wrong.clone();
    let mut edits = only[0]["edit"]["changes"][&uri].as_array().expect("edits").clone();
    edits.sort_by_key(|edit| std::cmp::Reverse((edit["range"]["start"]["line"].as_u64(), edit["range"]["start"]["character"].as_u64())));
    for edit in edits {
        fixed = edited(&fixed, &edit["range"], edit["newText"].as_str().expect("a text"));
    }
    let check = Command::new(env!("CARGO_BIN_EXE_sieben")).args(["check", "--fix", "."]).current_dir(&client.folder).output();
    assert!(check.is_ok());
    assert_eq!(std::fs::read_to_string(client.folder.join("main.awl")).ok(), Some(fixed));
    // A client that leaves out the context is answered, too.
    client.result("textDocument/codeAction", json!({ "textDocument": { "uri": uri }, "range": all }));
}

#[test]
fn a_network_is_drawn_and_a_test_is_run() {
    let mut client = plant("commands");
    let uri = client.uri("main.awl");
    let at = position(&marked(MAIN, "=     \"Pump\""));
    let drawn = client.result("workspace/executeCommand", json!({ "command": "sieben.showDiagram", "arguments": [uri, at] }));
    assert!(drawn["svg"].as_str().is_some_and(|svg| svg.starts_with("<svg") || svg.starts_with("<?xml")), "{drawn}");
    assert_eq!(drawn["network"], 1);
    // Its head belongs to a network, too.
    let at = position(&marked(MAIN, "TITLE = Dosing"));
    let drawn = client.result("workspace/executeCommand", json!({ "command": "sieben.showDiagram", "arguments": [uri, at] }));
    assert_eq!(drawn["network"], 2, "{drawn}");
    let head = client.ask("workspace/executeCommand", json!({ "command": "sieben.showDiagram", "arguments": [uri, position("|")] }));
    assert_eq!(head["error"]["code"], -32803, "above the first network there is none: {head}");
    let test = "TEST 'it doses'\n  ASSERT_EQ(1, 1);\nEND_TEST\n\nTEST 'it does not'\n  ASSERT_EQ(1, 2);\nEND_TEST\n";
    std::fs::write(client.folder.join("plant.test.st"), test).expect("it can be written");
    client.open("plant.test.st", test);
    let uri = client.uri("plant.test.st");
    let lenses = client.result("textDocument/codeLens", json!({ "textDocument": { "uri": uri } }));
    let commands: Vec<&Value> = lenses.as_array().into_iter().flatten().map(|lens| &lens["command"]).collect();
    assert_eq!(commands.len(), 3, "{lenses}");
    let arguments = commands.iter().find(|command| command["arguments"][1] == "it doses").map(|command| command["arguments"].clone());
    let run = client.result("workspace/executeCommand", json!({ "command": "sieben.runTest", "arguments": arguments }));
    assert_eq!((&run["passed"], &run["failed"]), (&json!(1), &json!(0)), "{run}");
}

#[test]
fn an_unknown_name_in_a_test_file_is_a_warning_for_the_server_and_for_check() {
    let test = "TEST 'it doses'\n  ASSERT_EQ(\"Pmup\", TRUE);\nEND_TEST\n";
    let files = [("sieben.toml", ""), ("symbols.csv", SYMBOLS), ("main.awl", MAIN), ("dosing.awl", DOSING), ("plant.test.st", test)];
    let mut client = Client::start("test-files", &files, &json!({}));
    let list = client.diagnostics("plant.test.st", None);
    assert!(!list.is_empty() && list.iter().all(|one| one["severity"] == 2), "{list:?}");
    assert_eq!(list[0]["range"]["start"]["line"], 1);
    let checked = checked(&client.folder);
    assert_eq!(checked.first().map(|(file, _, line)| (file.as_str(), *line)), Some(("plant.test.st", 2)), "{checked:?}");
    client.open("plant.test.st", &test.replace("Pmup", "Pump"));
    assert_eq!(client.diagnostics("plant.test.st", None), Vec::<Value>::new());
}

#[test]
fn lines_of_a_scenario_that_are_not_understood_are_told() {
    let mut client = plant("scenario");
    client.open("plant.scenario", "// fine\nscan 3\nnonsense\n");
    let found = client.diagnostics("plant.scenario", Some(1));
    let lines: Vec<Option<u64>> = found.iter().map(|one| one["range"]["start"]["line"].as_u64()).collect();
    assert_eq!((codes(&found).first().map(String::as_str), lines.last().copied().flatten()), (Some("P6260"), Some(2)), "{found:?}");
    client.change("plant.scenario", 2, &json!([{ "text": "// fine\nscan 3\n" }]));
    assert_eq!(client.diagnostics("plant.scenario", Some(2)), Vec::<Value>::new());
    assert_eq!(client.shut_down(), Some(0));
}

#[test]
fn a_word_is_explained_and_completed() {
    let mut client = plant("words");
    let hover = client.at("textDocument/hover", "main.awl", &marked(MAIN, "Pump\";"))["result"].clone();
    assert!(hover["contents"]["value"].as_str().is_some_and(|text| text.contains("the pump")), "{hover}");
    let hover = client.at("textDocument/hover", "main.awl", &marked(MAIN, "JC    M001"))["result"].clone();
    assert!(hover["contents"]["value"].as_str().is_some_and(|text| text.contains("JC")), "{hover}");
    let completion = client.at("textDocument/completion", "main.awl", &MAIN.replace("=     \"Pump", "=     \"|Pump"))["result"].clone();
    let pump = completion["items"]
        .as_array()
        .into_iter()
        .flatten()
        .find(|item| item["label"].as_str().is_some_and(|label| label.contains("Pump")));
    assert!(pump.is_some_and(|item| item["textEdit"]["newText"].as_str().is_some_and(|text| text.contains("\"Pump\""))), "{completion}");
    let signature = client.at("textDocument/signatureHelp", "main.awl", &marked(MAIN, "amount := 3"))["result"].clone();
    assert!(signature["signatures"][0]["label"].as_str().is_some_and(|label| label.contains("amount : INT")), "{signature}");
    let uri = client.uri("main.awl");
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let hints = client.result("textDocument/inlayHint", json!({ "textDocument": { "uri": uri }, "range": range }));
    assert!(hints.as_array().into_iter().flatten().any(|hint| hint["label"] == "Q 4.0"), "{hints}");
}

#[test]
fn positions_are_counted_as_agreed_in_texts_with_any_line_ends() {
    for (encodings, expected, columns) in
        [(json!(["utf-16", "utf-8"]), "utf-8", 18), (json!(["utf-16"]), "utf-16", 15), (json!(null), "utf-16", 15)]
    {
        let mut client = Client::silent(&format!("columns-{columns}-{expected}-{}", encodings.is_null()), &[]);
        let answer = client.ask("initialize", json!({ "processId": null, "rootUri": null, "workspaceFolders": null, "capabilities": { "general": { "positionEncodings": encodings } } }));
        assert_eq!(answer["result"]["capabilities"]["positionEncoding"], expected);
        client.tell("initialized", json!({}));
        for (path, line_end) in [("a.awl", "\n"), ("b.awl", "\r\n"), ("c.awl", "\r")] {
            let text = ["ORGANIZATION_BLOCK OB 1", "BEGIN", "      A     \"😀ü\"; XYZ 1;", "END_ORGANIZATION_BLOCK", ""].join(line_end);
            client.open(path, &text);
            let list = client.diagnostics(path, Some(1));
            let wanted =
                list.iter().find(|one| one["message"].as_str().is_some_and(|message| message.contains("XYZ"))).cloned().unwrap_or_default();
            let start = &wanted["range"]["start"];
            assert_eq!((&start["line"], &start["character"]), (&json!(2), &json!(columns + 4)), "{path} {expected} {list:?}");
        }
        assert_eq!(client.shut_down(), Some(0));
    }
}

#[test]
fn wrong_messages_are_answered_and_end_nothing() {
    let mut client = Client::silent("wrong", &[("main.awl", MAIN)]);
    assert_eq!(client.ask("textDocument/hover", json!({}))["error"]["code"], -32002);
    client.tell("textDocument/didOpen", json!({}));
    let folder = client.uri("");
    client.result("initialize", json!({ "processId": null, "rootUri": folder, "capabilities": {} }));
    client.tell("initialized", json!({}));
    assert_eq!(client.ask("initialize", json!({}))["error"]["code"], -32600);
    assert_eq!(client.ask("textDocument/nothing", json!({}))["error"]["code"], -32601);
    assert_eq!(client.ask("$/nothing", Value::Null)["error"]["code"], -32601);
    assert_eq!(client.ask("textDocument/hover", json!([1]))["error"]["code"], -32602);
    assert_eq!(
        client.ask(
            "textDocument/hover",
            json!({ "textDocument": { "uri": "file:///no/such.awl" }, "position": { "line": 0, "character": 0 } })
        )["error"]["code"],
        -32602
    );
    assert_eq!(client.ask("workspace/executeCommand", json!({ "command": "no" }))["error"]["code"], -32602);
    client.tell("textDocument/didChange", json!({ "textDocument": { "uri": "file:///no/such.awl", "version": 1 }, "contentChanges": [] }));
    client.tell("$/nothing", json!({}));
    client.tell("textDocument/didOpen", json!({ "textDocument": 1 }));
    client.raw(b"Content-Length: 5\r\n\r\n{\"a\":");
    client.wait("the answer to no JSON", |message| message["error"]["code"] == -32700);
    // A request that was given up before it was read.
    client.tell("$/cancelRequest", json!({ "id": 1000 }));
    client.raw(b"Content-Length: 57\r\n\r\n{\"jsonrpc\":\"2.0\",\"id\":1000,\"method\":\"workspace/symbol\"}  ");
    client.wait("the answer to what was given up", |message| message["id"] == 1000 && message["error"]["code"] == -32800);
    client.open("main.awl", MAIN);
    let uri = client.uri("main.awl");
    let far = json!({ "line": 4_000_000_000_u32, "character": 4_000_000_000_u32 });
    for method in
        ["hover", "completion", "definition", "references", "signatureHelp", "documentHighlight", "prepareRename", "linkedEditingRange"]
    {
        client.ask(&format!("textDocument/{method}"), json!({ "textDocument": { "uri": uri }, "position": far }));
    }
    std::fs::remove_file(client.folder.join("main.awl")).expect("it was there");
    client.tell("workspace/didChangeWatchedFiles", json!({ "changes": [{ "uri": uri, "type": 3 }] }));
    client.result("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    for uri in ["untitled:Untitled-1", "git:/a.awl?x", "vscode-notebook-cell:/a#1", "", "file:///%FF"] {
        client.tell("textDocument/didOpen", json!({ "textDocument": { "uri": uri, "languageId": "awl", "version": 1, "text": MAIN } }));
        client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
        client.ask("textDocument/hover", json!({ "textDocument": { "uri": uri }, "position": { "line": 9, "character": 9 } }));
    }
    assert_eq!(client.shut_down(), Some(0));
    let mut other = Client::start("ends", &[], &json!({}));
    assert_eq!(other.end(), Some(1), "the input ended without `shutdown`");
    let mut other = Client::silent("garbage", &[]);
    other.raw(b"hello\r\n\r\n");
    assert_eq!(other.end(), Some(1), "nothing tells where the next message begins");
}

#[test]
fn hostile_settings_are_a_diagnostic_of_theirs() {
    for (name, toml) in [("deep", "[".repeat(5_000)), ("binary", "\u{0}\u{1}".repeat(100)), ("keys", "a.".repeat(500) + "b = 1\n")] {
        let mut client = Client::start(&format!("toml-{name}"), &[("sieben.toml", toml.as_str()), ("main.awl", MAIN)], &json!({}));
        client.open("sieben.toml", &toml);
        assert!(!client.diagnostics("sieben.toml", Some(1)).is_empty(), "{name}");
        assert_eq!(client.shut_down(), Some(0));
    }
}

/// The text after a change, as the protocol says it: lines end with LF, CR LF or CR, columns are units of UTF-16.
fn edited(text: &str, range: &Value, new: &str) -> String {
    let byte = |position: &Value| {
        let (line, column) = (position["line"].as_u64().unwrap_or(0), position["character"].as_u64().unwrap_or(0));
        let mut start = 0;
        for _ in 0..line {
            match text[start..].find(['\r', '\n']) {
                Some(end) => start += end + if text[start + end..].starts_with("\r\n") { 2 } else { 1 },
                None => return text.len(),
            }
        }
        let mut units = 0;
        for (at, character) in text[start..].char_indices() {
            units += character.len_utf16() as u64;
            if units > column || matches!(character, '\r' | '\n') {
                return start + at;
            }
        }
        text.len()
    };
    let (start, end) = (byte(&range["start"]), byte(&range["end"]));
    format!("{}{new}{}", &text[..start.min(end)], &text[end.max(start)..])
}

/// What a server says of the text.
fn said_of(client: &mut Client) -> [Value; 4] {
    let uri = client.uri("main.awl");
    let document = json!({ "textDocument": { "uri": uri } });
    let diagnostics = client.result("textDocument/diagnostic", document.clone())["items"].clone();
    let asked = ["documentSymbol", "foldingRange", "semanticTokens/full"];
    let [outline, folds, tokens] = asked.map(|what| client.result(&format!("textDocument/{what}"), document.clone()));
    // A number that only this server has.
    [diagnostics, outline, folds, tokens["data"].clone()]
}

#[test]
fn random_edits_leave_what_a_new_server_knows() {
    /// Edits, times `SIEBEN_TIMES`.
    const EDITS: u64 = 10_000;
    let times = std::env::var("SIEBEN_TIMES").ok().and_then(|times| times.parse().ok()).unwrap_or(1);
    let mut client = plant("edits");
    client.diagnostics("main.awl", Some(1));
    let pieces = [
        "\"",
        "#",
        "A I 0.0;\n",
        "NETWORK\n",
        ";",
        "ü",
        "😀",
        "\r\n",
        "\r",
        "END_ORGANIZATION_BLOCK",
        "M1: ",
        "(*",
        "//",
        "FUNCTION FC 1 : VOID\n",
        "",
    ];
    let mut state = 7_u64;
    let mut random = |bound: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state % bound
    };
    let mut text = MAIN.to_owned();
    for edit in 1..=EDITS * times {
        let (line, character) = (random(24), random(20));
        let (more, further) = (random(2), random(6));
        let range =
            json!({ "start": { "line": line, "character": character }, "end": { "line": line + more, "character": character + further } });
        let piece = pieces[usize::try_from(random(pieces.len() as u64)).unwrap_or(0)];
        let change = match edit % 97 {
            0 => {
                MAIN.clone_into(&mut text);
                json!([{ "text": MAIN }])
            }
            _ => {
                text = edited(&text, &range, piece);
                json!([{ "range": range, "text": piece }])
            }
        };
        client.change("main.awl", i32::try_from(edit + 1).expect("few edits"), &change);
        if edit % 250 == 0 {
            let mut fresh = plant("edits-fresh");
            fresh.change("main.awl", 2, &json!([{ "text": text }]));
            assert_eq!(said_of(&mut client), said_of(&mut fresh), "after {edit} edits: {text}");
        }
    }
    assert_eq!(client.shut_down(), Some(0));
}
