//! A page without a browser: a WebSocket that says and hears JSON. Tests and the benchmark of pages use it.
#![allow(dead_code)] // Each of them uses a part of it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;

use serde_json::{Value, json};

/// A frame that asks whether the other end is there.
pub(crate) const PING: u8 = 9;

/// A page without a browser.
pub(crate) struct Page {
    stream: BufReader<TcpStream>,
    /// Bytes that were received as frames.
    pub(crate) bytes_in: u64,
}

impl Page {
    pub(crate) fn new(mut stream: TcpStream, path: &str, host: &str) -> Self {
        let head = format!(
            "GET {path} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\
             Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
        );
        stream.write_all(head.as_bytes()).expect("it reads");
        let mut page = Self { stream: BufReader::new(stream), bytes_in: 0 };
        let mut line = String::new();
        while line != "\r\n" {
            line.clear();
            assert!(page.stream.read_line(&mut line).expect("a head") > 0, "the connection ends");
        }
        page
    }

    /// A frame with a mask of zeros.
    pub(crate) fn frame(&mut self, kind: u8, bytes: &[u8]) {
        let mut frame = vec![0x80 | kind];
        match bytes.len() {
            short @ 0..126 => frame.push(0x80 | short as u8),
            middle @ 126..=0xFFFF => {
                frame.push(0x80 | 126);
                frame.extend((middle as u16).to_be_bytes());
            }
            long => {
                frame.push(0x80 | 127);
                frame.extend((long as u64).to_be_bytes());
            }
        }
        frame.extend([0; 4]);
        frame.extend(bytes);
        // One that was sent away reads no more.
        let _ = self.stream.get_mut().write_all(&frame);
    }

    pub(crate) fn say(&mut self, message: &Value) {
        self.frame(1, message.to_string().as_bytes());
    }

    pub(crate) fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let mut bytes = [0; N];
        self.stream.read_exact(&mut bytes).ok().map(|()| bytes)
    }

    /// The next frame: its kind and what it carries; `None` at the end.
    pub(crate) fn next_frame(&mut self) -> Option<(u8, Vec<u8>)> {
        let [kind, length] = self.bytes()?;
        let length = match length & 0x7F {
            126 => usize::from(u16::from_be_bytes(self.bytes()?)),
            127 => u64::from_be_bytes(self.bytes()?) as usize,
            length => usize::from(length),
        };
        let mut payload = vec![0; length];
        self.stream.read_exact(&mut payload).ok()?;
        self.bytes_in += 2 + length as u64;
        Some((kind & 0x0F, payload))
    }

    /// The next message, acknowledged; `None` at the end.
    pub(crate) fn next(&mut self) -> Option<Value> {
        let payload = loop {
            match self.next_frame()? {
                (8, _) => return None,
                (PING, payload) => self.frame(10, &payload),
                (_, payload) => break payload,
            }
        };
        let message: Value = serde_json::from_slice(&payload).expect("JSON");
        if message["t"] == "scan" {
            self.say(&json!({ "t": "ack", "seq": message["seq"] }));
        }
        Some(message)
    }

    /// Messages until one is as wanted.
    pub(crate) fn until(&mut self, what: &str, mut is_wanted: impl FnMut(&Value) -> bool) -> Value {
        let mut last = Value::Null;
        for _ in 0..400 {
            let message = self.next().unwrap_or_else(|| panic!("{what}: the connection has ended"));
            if is_wanted(&message) {
                return message;
            }
            last = message;
        }
        panic!("{what} does not come; the last message is {last}");
    }
}
