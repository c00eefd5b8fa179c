//! Messages over two streams: framing, limits, and threads that never wait for one another.

use std::io::{self, BufRead, Read, Write};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;

use lsp_server::{Message, RequestId};
use serde_json::{Value, json};

use super::work::Finished;

/// Bytes of a message at most: a source of the largest size, with escapes.
const MESSAGE_BYTES_MAX: usize = 160 << 20;
/// Bytes of a line of the header of a message at most.
const HEADER_BYTES_MAX: u64 = 4 << 10;
/// Messages that wait for the server at most: then the client waits.
const WAITING_MAX: usize = 1 << 10;
/// Messages that wait for the client at most: one that does not read is left alone.
const UNREAD_MAX: usize = 1 << 16;
/// Requests that are given up although nothing is known of them at most.
const CANCELLED_MAX: usize = 1 << 10;

/// What comes in.
#[derive(Debug)]
pub(super) enum Event {
    /// A message of the client.
    Message(Message),
    /// Something that is no message: the answer to it, and what was wrong.
    Garbled(Value, String),
    /// Work of another thread is done.
    Finished(Finished),
    /// The client is gone; why, if it did not simply end.
    Gone(Option<String>),
}

/// The requests that the client no longer wants.
#[derive(Clone, Debug, Default)]
pub(super) struct Cancelled {
    ids: Arc<Mutex<Vec<RequestId>>>,
}

impl Cancelled {
    fn ids(&self) -> MutexGuard<'_, Vec<RequestId>> {
        self.ids.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes one. It may not have been read yet, or be answered already.
    pub(super) fn note(&self, id: RequestId) {
        let mut ids = self.ids();
        if ids.len() == CANCELLED_MAX {
            ids.remove(0);
        }
        ids.push(id);
    }

    /// Whether a request is among them; it is forgotten then.
    pub(super) fn take(&self, id: &RequestId) -> bool {
        let mut ids = self.ids();
        let before = ids.len();
        ids.retain(|other| other != id);
        ids.len() < before
    }
}

/// The request that `$/cancelRequest` names.
fn cancelled(message: &Message) -> Option<RequestId> {
    let Message::Notification(notification) = message else { return None };
    if notification.method != "$/cancelRequest" {
        return None;
    }
    serde_json::from_value(notification.params.get("id")?.clone()).ok()
}

/// What goes out. It never waits.
#[derive(Clone, Debug)]
pub(super) struct Outbox {
    lines: Sender<String>,
    unread: Arc<AtomicUsize>,
}

impl Outbox {
    /// A box, and where what is put into it comes out.
    pub(super) fn new() -> (Self, Receiver<String>, Arc<AtomicUsize>) {
        let (lines, out) = channel();
        let unread = Arc::new(AtomicUsize::new(0));
        (Self { lines, unread: Arc::clone(&unread) }, out, unread)
    }

    /// Sends a message.
    pub(super) fn send(&self, message: impl Into<Message>) {
        let mut value = serde_json::to_value(message.into()).unwrap_or_default();
        value["jsonrpc"] = "2.0".into();
        self.send_value(&value);
    }

    /// Sends what is no usual message.
    pub(super) fn send_value(&self, value: &Value) {
        // A client that does not read has nothing of what comes later either.
        if self.unread.fetch_add(1, Ordering::Relaxed) < UNREAD_MAX {
            let _ = self.lines.send(value.to_string());
        } else {
            self.unread.fetch_sub(1, Ordering::Relaxed);
        }
    }
}

/// Starts the thread that reads; it hands on all that it reads, and ends with the stream.
pub(super) fn read(mut input: impl BufRead + Send + 'static, events: SyncSender<Event>, cancelled_ids: Cancelled) -> io::Result<()> {
    let read = move || {
        loop {
            let event = match message(&mut input) {
                Ok(Incoming::Message(message)) => {
                    if let Some(id) = cancelled(&message) {
                        cancelled_ids.note(id);
                        continue;
                    }
                    Event::Message(message)
                }
                Ok(Incoming::Garbled(answer, why)) => Event::Garbled(answer, why),
                Ok(Incoming::End) => Event::Gone(None),
                Err(error) => Event::Gone(Some(error.to_string())),
            };
            let is_last = matches!(event, Event::Gone(_));
            if events.send(event).is_err() || is_last {
                return;
            }
        }
    };
    thread::Builder::new().name("requests".to_owned()).spawn(read).map(drop)
}

/// Starts the thread that writes; it ends when no box is left, or with the stream, which is the end of the client.
pub(super) fn write(
    mut output: impl Write + Send + 'static,
    out: Receiver<String>,
    unread: Arc<AtomicUsize>,
    events: SyncSender<Event>,
) -> io::Result<thread::JoinHandle<()>> {
    let write = move || {
        for line in out {
            unread.fetch_sub(1, Ordering::Relaxed);
            let written = write!(output, "Content-Length: {}\r\n\r\n{line}", line.len()).and_then(|()| output.flush());
            if written.is_err() {
                let _ = events.send(Event::Gone(None));
                return;
            }
        }
    };
    thread::Builder::new().name("answers".to_owned()).spawn(write)
}

/// A channel for what comes in.
pub(super) fn events() -> (SyncSender<Event>, Receiver<Event>) {
    std::sync::mpsc::sync_channel(WAITING_MAX)
}

/// What was read.
enum Incoming {
    Message(Message),
    Garbled(Value, String),
    End,
}

/// An answer to something that is no request.
fn error(id: Value, code: i32, message: &str) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code, "message": message } })
}

/// Reads the next message; an error means that it is not known where the next one begins.
fn message(input: &mut impl BufRead) -> io::Result<Incoming> {
    let Some(length) = header(input)? else { return Ok(Incoming::End) };
    if length > MESSAGE_BYTES_MAX {
        let why = format!("a message of {length} bytes was left out: {} MiB is the most", MESSAGE_BYTES_MAX >> 20);
        io::copy(&mut input.take(length as u64), &mut io::sink())?;
        return Ok(Incoming::Garbled(error(Value::Null, lsp_server::ErrorCode::InvalidRequest as i32, &why), why));
    }
    let mut body = Vec::new();
    input.take(length as u64).read_to_end(&mut body)?;
    if body.len() < length {
        return Err(io::Error::other("the input ended inside of a message"));
    }
    let value: Value = match serde_json::from_slice(&body) {
        Ok(value) => value,
        Err(wrong) => {
            let why = format!("a message is no JSON: {wrong}");
            return Ok(Incoming::Garbled(error(Value::Null, lsp_server::ErrorCode::ParseError as i32, &why), why));
        }
    };
    let (id, is_request) = (value.get("id").cloned().unwrap_or_default(), value.get("method").is_some());
    match serde_json::from_value(value) {
        Ok(Message::Notification(_)) if !id.is_null() => {
            let why = format!("`{id}` is no id of a request");
            Ok(Incoming::Garbled(error(id, lsp_server::ErrorCode::InvalidRequest as i32, &why), why))
        }
        Ok(message) => Ok(Incoming::Message(message)),
        Err(_) => {
            let why = "a message is neither a request nor a notification nor an answer".to_owned();
            let id = if is_request { id } else { Value::Null };
            Ok(Incoming::Garbled(error(id, lsp_server::ErrorCode::InvalidRequest as i32, &why), why))
        }
    }
}

/// The length of the message that follows; `None` at the end of the input.
fn header(input: &mut impl BufRead) -> io::Result<Option<usize>> {
    let mut length = None;
    let mut is_first = true;
    loop {
        let mut line = Vec::new();
        input.take(HEADER_BYTES_MAX).read_until(b'\n', &mut line)?;
        if line.is_empty() && is_first {
            return Ok(None);
        }
        is_first = false;
        let Some(line) = line.strip_suffix(b"\n") else { return Err(io::Error::other("the header of a message has no end")) };
        let line = String::from_utf8_lossy(line.strip_suffix(b"\r").unwrap_or(line)).into_owned();
        if line.is_empty() {
            break;
        }
        let Some((name, value)) = line.split_once(':') else {
            let shown: String = line.chars().take(60).collect();
            return Err(io::Error::other(format!("`{shown}` is no line of the header of a message")));
        };
        if name.trim().eq_ignore_ascii_case("Content-Length") {
            let value = value.trim().parse::<usize>();
            length = Some(value.map_err(|_| io::Error::other("the length of a message is no number"))?);
        }
    }
    length.map(Some).ok_or_else(|| io::Error::other("the header of a message does not say how long it is"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(input: &[u8]) -> Vec<String> {
        let mut input = io::BufReader::new(input);
        let mut seen = Vec::new();
        loop {
            seen.push(match message(&mut input) {
                Ok(Incoming::Message(Message::Request(request))) => format!("request {} {}", request.id, request.method),
                Ok(Incoming::Message(Message::Notification(notification))) => format!("notification {}", notification.method),
                Ok(Incoming::Message(Message::Response(response))) => format!("response {}", response.id),
                Ok(Incoming::Garbled(answer, _)) => format!("garbled {} {}", answer["id"], answer["error"]["code"]),
                Ok(Incoming::End) => return seen,
                Err(error) => {
                    seen.push(error.to_string());
                    return seen;
                }
            });
        }
    }

    fn framed(bodies: &[&str]) -> Vec<u8> {
        bodies.iter().flat_map(|body| format!("Content-Length: {}\r\n\r\n{body}", body.len()).into_bytes()).collect()
    }

    #[test]
    fn what_is_no_message_is_answered_and_the_next_one_is_read() {
        let bodies = [
            r#"{"id":1,"method":"a"}"#,
            r#"{"method":"b"}"#,
            r#"{"id":"x","result":null}"#,
            "{",
            "[]",
            r#"{"id":99999999999,"method":"c"}"#,
            r#"{"id":1.5,"method":"c"}"#,
            r#"{"id":null,"method":"d"}"#,
            "\u{0}",
        ];
        let expected = [
            "request 1 a",
            "notification b",
            "response \"x\"",
            "garbled null -32700",
            "garbled null -32600",
            "garbled 99999999999 -32600",
            "garbled 1.5 -32600",
            "notification d",
            "garbled null -32700",
        ];
        assert_eq!(all(&framed(&bodies)), expected);
    }

    #[test]
    fn a_header_that_is_none_ends_the_input() {
        for (input, expected) in [
            (&b""[..], None),
            (b"hello\r\n", Some("`hello` is no line of the header of a message")),
            (b"Content-Length: x\r\n\r\n", Some("the length of a message is no number")),
            (b"Content-Type: a\r\n\r\n", Some("the header of a message does not say how long it is")),
            (b"Content-Length: 10\r\n\r\n{}", Some("the input ended inside of a message")),
            (b"Content-Length: 2", Some("the header of a message has no end")),
        ] {
            assert_eq!(all(input).first().map(String::as_str), expected, "{}", String::from_utf8_lossy(input));
        }
        assert_eq!(all(&[b'a'; 5000]), ["the header of a message has no end"]);
        assert_eq!(all(b"content-length:2\nX: y\n\n{}"), ["garbled null -32600"], "lenient where it is clear what is meant");
    }

    #[test]
    fn a_message_that_is_too_large_is_left_out() {
        let length = MESSAGE_BYTES_MAX + 1;
        let head = format!("Content-Length: {length}\r\n\r\n").into_bytes();
        let next = framed(&[r#"{"method":"b"}"#]);
        let mut input = io::BufReader::new(head.as_slice().chain(io::repeat(b' ').take(length as u64)).chain(next.as_slice()));
        assert!(matches!(message(&mut input), Ok(Incoming::Garbled(..))));
        assert!(matches!(message(&mut input), Ok(Incoming::Message(Message::Notification(_)))));
    }

    #[test]
    fn a_request_is_given_up_once() {
        let cancelled = Cancelled::default();
        cancelled.note(RequestId::from(1));
        assert!(!cancelled.take(&RequestId::from("1".to_owned())), "they are not the same");
        assert!(cancelled.take(&RequestId::from(1)) && !cancelled.take(&RequestId::from(1)));
        (0..5000).for_each(|id| cancelled.note(RequestId::from(id)));
        assert_eq!(cancelled.ids().len(), CANCELLED_MAX);
    }
}
