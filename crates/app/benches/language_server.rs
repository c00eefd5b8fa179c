//! What an editor waits for in a large project: `cargo bench -p sieben-app --bench language_server`.
//!
//! A project of 100,000 statements is opened with the real binary over its streams: once as 500 files of two blocks, once with all blocks of
//! STL in one file and all of SCL in another. Measured is from the message to its answer, as an editor meets it.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

#[path = "../tests/lsp_client/mod.rs"]
mod lsp_client;
#[path = "front_end/project.rs"]
mod project;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::time::{Duration, Instant};

use lsp_client::Client;
use serde_json::{Value, json};

/// Keystrokes, and questions of each kind.
const ROUNDS: i32 = 100;
/// A statement of each file of STL, before which something is typed.
const TYPED_AT: &str = "L 4;";
/// What is typed.
const MISTAKE: &str = "L lost;";

/// The project as files: each by itself, or all of a language as one.
fn files(is_joined: bool) -> Vec<(String, String)> {
    let project = project::project();
    let mut symbols = String::from("symbol,address,type,comment\n");
    for symbol in project.symbols.symbols() {
        let _ = writeln!(symbols, "{},{},{},", symbol.name, symbol.address, symbol.data_type);
    }
    let mut files = vec![("sieben.toml".to_owned(), "[project]\nname = \"large\"\n".to_owned()), ("symbols.csv".to_owned(), symbols)];
    let sources = project.sources.iter().map(|(_, file)| (file.name.clone(), file.text.to_string()));
    if !is_joined {
        files.extend(sources);
        return files;
    }
    let (mut stl, mut scl) = (String::new(), String::new());
    for (name, text) in sources {
        if name.ends_with(".scl") { &mut scl } else { &mut stl }.push_str(&text);
    }
    files.extend([("main.awl".to_owned(), stl), ("functions.scl".to_owned(), scl)]);
    files
}

/// A figure: the median, p95 and the longest time.
fn row(what: &str, mut times: Vec<Duration>) {
    times.sort_unstable();
    let at = |percent: usize| times[(times.len() - 1) * percent / 100].as_secs_f64() * 1e3;
    println!("| {what} | {:.1} ms | {:.1} ms | {:.1} ms |", at(50), at(95), at(100));
}

fn timed<R>(work: impl FnOnce() -> R) -> (Duration, R) {
    let begin = Instant::now();
    let result = work();
    (begin.elapsed(), result)
}

/// Where the first `what` of a text begins.
fn place(text: &str, what: &str) -> Value {
    lsp_client::position(&text.replacen(what, "|", 1))
}

/// So many characters after a place.
fn within(place: &Value, characters: usize) -> Value {
    json!({ "line": place["line"], "character": place["character"].as_u64().unwrap_or(0) + characters as u64 })
}

/// The symbol that is used most, with a file that uses it.
fn most_used<'f>(files: &[(&'f str, &'f str)]) -> (String, &'f str) {
    let mut uses: BTreeMap<&str, (usize, &str)> = BTreeMap::new();
    for (file, text) in files.iter().filter(|(file, _)| file.ends_with(".awl") || file.ends_with(".scl")) {
        for rest in text.split("\"signal_").skip(1) {
            let number = rest.split('"').next().unwrap_or_default();
            uses.entry(number).or_insert((0, *file)).0 += 1;
        }
    }
    let (number, (_, file)) = uses.into_iter().max_by_key(|&(_, (count, _))| count).expect("there are symbols");
    (format!("\"signal_{number}\""), file)
}

fn measure(what: &str, is_joined: bool) {
    println!("\n{what}:\n\n| | median | p95 | longest |\n|---|---|---|---|");
    let files = files(is_joined);
    let borrowed: Vec<(&str, &str)> = files.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    let edited = if is_joined { "main.awl" } else { "file_004.awl" };
    let text = borrowed.iter().find(|(name, _)| *name == edited).expect("it is there").1;

    let mut opened = Vec::new();
    let mut client = None;
    for round in 0..5 {
        drop(client.take());
        let mut one = Client::silent(&format!("bench-{is_joined}-{round}"), &borrowed);
        let folder = one.uri("");
        let (took, _) = timed(|| {
            one.ask("initialize", json!({ "processId": null, "rootUri": folder.trim_end_matches('/'), "capabilities": {} }));
            one.tell("initialized", json!({}));
            one.open(edited, text);
            one.diagnostics(edited, Some(1))
        });
        opened.push(took);
        client = Some(one);
    }
    row("from `initialize` to the first diagnostics", opened);

    let mut client = client.expect("one is left");
    let typed_at = place(text, TYPED_AT);
    let mut keystrokes = Vec::new();
    for round in 0..ROUNDS {
        let version = round + 2;
        // A mistake, and the text as it was: each keystroke changes what is wrong.
        let change = match round % 2 {
            0 => json!([{ "range": { "start": typed_at, "end": typed_at }, "text": MISTAKE }]),
            _ => {
                json!([{ "range": { "start": typed_at, "end": within(&typed_at, MISTAKE.len()) }, "text": "" }])
            }
        };
        let (took, found) = timed(|| {
            client.change(edited, version, &change);
            client.diagnostics(edited, Some(version))
        });
        assert_eq!(found.is_empty(), round % 2 == 1, "{found:?}");
        keystrokes.push(took);
    }
    row("from a keystroke to the diagnostics of the file", keystrokes);

    let uri = client.uri(edited);
    let about = |place: &Value| json!({ "textDocument": { "uri": uri }, "position": place });
    let inside = within(&place(text, "\"signal_"), 3);
    for (what, method) in [("completion in a statement", "textDocument/completion"), ("hover", "textDocument/hover")] {
        let times = (0..ROUNDS).map(|_| {
            let (took, answer) = timed(|| client.result(method, about(&inside)));
            assert!(!answer.is_null(), "{method}");
            took
        });
        row(what, times.collect());
    }

    let (symbol, user) = most_used(&borrowed);
    let user_text = borrowed.iter().find(|(name, _)| *name == user).expect("it is there").1;
    let used_at = place(user_text, &symbol);
    client.open(user, user_text);
    let uri = client.uri(user);
    let mut asked = json!({ "textDocument": { "uri": uri }, "position": within(&used_at, 3) });
    asked["newName"] = json!("renamed");
    let (mut renames, mut places) = (Vec::new(), 0);
    for _ in 0..20 {
        let (took, answer) = timed(|| client.result("textDocument/rename", asked.clone()));
        places = answer.to_string().matches("\"newText\"").count();
        renames.push(took);
    }
    row(&format!("rename of a symbol at {places} places"), renames);
    println!("\nMemory of the server: {} MiB at most.", client.memory_kib() / 1024);
}

fn main() {
    measure("500 files of two blocks", false);
    measure("one file for each language", true);
}
