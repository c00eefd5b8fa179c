//! Runs with a page, and pages without a browser, as tests begin them.
#![allow(dead_code)] // Not every test file uses all of it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, Command, Stdio};

use serde_json::{Value, json};

use crate::command::{DEADLINE, Folder, sieben};
pub(crate) use socket::Page;

pub(crate) mod socket;

/// A run with a page. It is killed when this goes.
pub(crate) struct Serving {
    pub(crate) child: Child,
    pub(crate) page: SocketAddr,
    /// Where its S7 server is, if it has one.
    pub(crate) s7: Option<SocketAddr>,
}

impl Serving {
    pub(crate) fn new(folder: &Folder, more: &[&str]) -> Self {
        let arguments: Vec<&str> = ["serve", ".", "--json", "--s7", "127.0.0.1:0"].iter().chain(more).copied().collect();
        let mut command = sieben(folder.path(), &arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the binary starts");
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().expect("a pipe")).read_line(&mut line).expect("UTF-8");
        let listening: Value = serde_json::from_str(&line).unwrap_or_else(|error| panic!("{line}: {error}"));
        let page: SocketAddr = listening["listening"]["page"].as_str().expect("a page").parse().expect("an address");
        let s7 = listening["listening"]["s7"].as_str().and_then(|address| address.parse().ok());
        Self { child, page: SocketAddr::from(([127, 0, 0, 1], page.port())), s7 }
    }

    /// A run that is told to have a page, by its message.
    pub(crate) fn of(mut command: Command) -> Self {
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the binary starts");
        let mut messages = BufReader::new(child.stderr.take().expect("a pipe"));
        let mut all = String::new();
        let page = loop {
            let begin = all.len();
            assert!(messages.read_line(&mut all).expect("UTF-8") > 0, "no page: {all}");
            if let Some(rest) = all[begin..].split("http://").nth(1) {
                break rest.split('/').next().and_then(|address| address.parse().ok()).expect("an address");
            }
        };
        // What else it says has a reader, too.
        std::thread::spawn(move || std::io::copy(&mut messages, &mut std::io::sink()));
        Self { child, page, s7: None }
    }

    pub(crate) fn usual(folder: &Folder) -> Self {
        Self::new(folder, &["--page", "127.0.0.1:0"])
    }

    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.page).expect("it listens");
        stream.set_read_timeout(Some(DEADLINE)).expect("a timeout");
        stream
    }

    /// Status, head and body of an answer.
    pub(crate) fn ask(&self, method: &str, path: &str, more: &str, body: &str) -> (u16, String, String) {
        let mut stream = self.connect();
        let host = if more.contains("Host:") { String::new() } else { format!("Host: {}\r\n", self.page) };
        let request = format!("{method} {path} HTTP/1.1\r\n{host}{more}Connection: close\r\nContent-Length: {}\r\n\r\n{body}", body.len());
        stream.write_all(request.as_bytes()).expect("it reads");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer");
        let (head, body) = answer.split_once("\r\n\r\n").expect("a head");
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).expect("a status");
        (status, head.to_owned(), body.to_owned())
    }

    pub(crate) fn json(&self, method: &str, path: &str, body: &str) -> Value {
        let (status, _, text) = self.ask(method, path, "", body);
        assert!(status < 300, "{method} {path}: {status} {text}");
        serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}: {text}"))
    }

    pub(crate) fn page(&self, query: &str) -> Page {
        let mut page = Page::new(self.connect(), &format!("/ws{query}"), &self.page.to_string());
        page.say(&json!({ "t": "hello", "v": 1, "lang": "en", "mnemonics": "en" }));
        page
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
