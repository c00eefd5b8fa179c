//! A scripted client of the language server, over the streams of the real binary.
#![allow(dead_code)] // Tests and the benchmark use a part of it each.

use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use serde_json::{Value, json};

/// How long an answer is waited for.
const DEADLINE: Duration = Duration::from_secs(60);

/// A client with its server and a folder of its own.
pub(crate) struct Client {
    pub(crate) folder: PathBuf,
    /// The folder goes with the client.
    goes: bool,
    child: Child,
    input: Option<ChildStdin>,
    incoming: Receiver<Value>,
    /// What was told and asked while an answer was waited for.
    pub(crate) told: Vec<Value>,
    number: i32,
}

impl Client {
    /// Starts a server in a new folder with these files; the client says that it can do this.
    pub(crate) fn start(name: &str, files: &[(&str, &str)], capabilities: &Value) -> Self {
        let mut client = Self::silent(name, files);
        client.hello(capabilities);
        client
    }

    /// Starts a server in a folder that is there, and stays there.
    pub(crate) fn in_folder(folder: &Path, capabilities: &Value) -> Self {
        let mut client = Self::served(std::fs::canonicalize(folder).expect("it is there"));
        client.hello(capabilities);
        client
    }

    /// Says what the client can do.
    pub(crate) fn hello(&mut self, capabilities: &Value) {
        let folder = self.uri("");
        let answer = self.ask(
            "initialize",
            json!({
                "processId": null, "rootUri": folder.trim_end_matches('/'), "capabilities": capabilities,
            }),
        );
        assert_eq!(answer["result"]["serverInfo"]["name"], "sieben", "{answer}");
        self.tell("initialized", json!({}));
    }

    /// Starts a server that is not spoken to yet.
    pub(crate) fn silent(name: &str, files: &[(&str, &str)]) -> Self {
        let folder = std::env::temp_dir().join(format!("sieben-lsp-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).expect("the folder can be made");
        for (path, text) in files {
            let path = folder.join(path);
            std::fs::create_dir_all(path.parent().expect("it lies in a folder")).expect("the folder can be made");
            std::fs::write(path, text).expect("the file can be written");
        }
        let folder = std::fs::canonicalize(folder).expect("it is there");
        let mut client = Self::served(folder);
        client.goes = true;
        client
    }

    fn served(folder: PathBuf) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_sieben"))
            .args(["lsp", "--stdio"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the server starts");
        let input = child.stdin.take();
        let mut output = BufReader::new(child.stdout.take().expect("it has an output"));
        let (sender, incoming) = channel();
        std::thread::spawn(move || {
            loop {
                let mut length = 0;
                loop {
                    let mut line = String::new();
                    if output.read_line(&mut line).unwrap_or(0) == 0 {
                        return;
                    }
                    match line.trim().strip_prefix("Content-Length: ") {
                        Some(value) => length = value.parse().expect("a number"),
                        None => break,
                    }
                }
                let mut body = vec![0; length];
                output.read_exact(&mut body).expect("a whole message");
                if sender.send(serde_json::from_slice(&body).expect("JSON")).is_err() {
                    return;
                }
            }
        });
        Self { folder, goes: false, child, input, incoming, told: Vec::new(), number: 0 }
    }

    /// The URI of a file of the folder.
    pub(crate) fn uri(&self, path: &str) -> String {
        format!("file://{}/{path}", self.folder.display())
    }

    pub(crate) fn raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("the input is open");
        input.write_all(bytes).and_then(|()| input.flush()).expect("the server reads");
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    pub(crate) fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request without waiting; its number.
    pub(crate) fn begin(&mut self, method: &str, params: Value) -> i32 {
        self.number += 1;
        self.send(&json!({ "jsonrpc": "2.0", "id": self.number, "method": method, "params": params }));
        self.number
    }

    /// Asks and waits for the whole answer.
    pub(crate) fn ask(&mut self, method: &str, params: Value) -> Value {
        let id = self.begin(method, params);
        self.wait(&format!("the answer to {method}"), |message| message["id"] == id && message.get("method").is_none())
    }

    /// The result of a request that is not refused.
    pub(crate) fn result(&mut self, method: &str, params: Value) -> Value {
        let answer = self.ask(method, params);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    /// Waits for a message; the others are kept.
    pub(crate) fn wait(&mut self, what: &str, is_it: impl Fn(&Value) -> bool) -> Value {
        loop {
            let message = self.incoming.recv_timeout(DEADLINE).unwrap_or_else(|_| panic!("{what} did not come; {:?}", self.told));
            if is_it(&message) {
                return message;
            }
            self.told.push(message);
        }
    }

    /// Opens a text.
    pub(crate) fn open(&mut self, path: &str, text: &str) {
        let uri = self.uri(path);
        let language = path.rsplit('.').next().unwrap_or_default().to_owned();
        self.tell("textDocument/didOpen", json!({ "textDocument": { "uri": uri, "languageId": language, "version": 1, "text": text } }));
    }

    /// Gives an open text another one.
    pub(crate) fn change(&mut self, path: &str, version: i32, changes: &Value) {
        let uri = self.uri(path);
        self.tell("textDocument/didChange", json!({ "textDocument": { "uri": uri, "version": version }, "contentChanges": changes }));
    }

    /// What is said to be wrong with a text of this version.
    pub(crate) fn diagnostics(&mut self, path: &str, version: Option<i32>) -> Vec<Value> {
        let uri = self.uri(path);
        let is_it = |message: &Value| {
            let params = &message["params"];
            message["method"] == "textDocument/publishDiagnostics"
                && params["uri"] == uri
                && version.is_none_or(|version| params["version"] == version)
        };
        let early = self.told.iter().position(is_it).map(|index| self.told.remove(index));
        let message = early.unwrap_or_else(|| self.wait("diagnostics", is_it));
        message["params"]["diagnostics"].as_array().cloned().unwrap_or_default()
    }

    /// Asks about a place: `|` in the text.
    pub(crate) fn at(&mut self, method: &str, path: &str, marked: &str) -> Value {
        let position = position(marked);
        let uri = self.uri(path);
        self.ask(method, json!({ "textDocument": { "uri": uri }, "position": position, "context": { "includeDeclaration": true } }))
    }

    /// The most memory that the server has had, in KiB.
    #[cfg(target_os = "linux")]
    pub(crate) fn memory_kib(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).expect("it runs");
        let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).expect("a figure");
        most.trim().trim_end_matches(" kB").parse().expect("a number")
    }

    /// Ends the input; the exit code.
    pub(crate) fn end(&mut self) -> Option<i32> {
        self.input = None;
        self.child.wait().ok().and_then(|status| status.code())
    }

    /// Ends in order; the exit code.
    pub(crate) fn shut_down(&mut self) -> Option<i32> {
        assert_eq!(self.result("shutdown", Value::Null), Value::Null);
        self.tell("exit", Value::Null);
        self.child.wait().ok().and_then(|status| status.code())
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        if self.goes {
            let _ = std::fs::remove_dir_all(&self.folder);
        }
    }
}

/// The position of `|` in a text, in UTF-16.
pub(crate) fn position(marked: &str) -> Value {
    let before = marked.split('|').next().unwrap_or_default();
    let line = before.matches('\n').count();
    let character = before.rsplit('\n').next().unwrap_or_default().encode_utf16().count();
    json!({ "line": line, "character": character })
}

/// The text of a range of a text whose columns are ASCII.
pub(crate) fn slice(text: &str, range: &Value) -> String {
    let byte = |position: &Value| {
        let line = position["line"].as_u64().unwrap_or(0) as usize;
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        (start + position["character"].as_u64().unwrap_or(0) as usize).min(text.len())
    };
    text.get(byte(&range["start"])..byte(&range["end"])).unwrap_or_default().to_owned()
}

/// The codes of diagnostics.
pub(crate) fn codes(diagnostics: &[Value]) -> Vec<String> {
    diagnostics.iter().map(|one| one["code"].as_str().unwrap_or_default().to_owned()).collect()
}

/// What `sieben check` says about a folder, by the ends of the paths, codes and lines.
pub(crate) fn checked(folder: &Path) -> Vec<(String, String, u64)> {
    let output = Command::new(env!("CARGO_BIN_EXE_sieben")).args(["check", "--json"]).arg(folder).output().expect("it runs");
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let list = json.as_array().or_else(|| json["diagnostics"].as_array()).cloned().unwrap_or_default();
    let row = |one: &Value| {
        let file = one["file"].as_str().unwrap_or_default().rsplit('/').next().unwrap_or_default().to_owned();
        (file, one["code"].as_str().unwrap_or_default().to_owned(), one["line"].as_u64().unwrap_or(1).max(1))
    };
    let mut rows: Vec<_> = list.iter().map(row).collect();
    rows.sort();
    rows
}
