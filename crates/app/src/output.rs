//! Results on standard output, messages on standard error; a reader that goes away is no mistake.

use std::io::{self, IsTerminal, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};

use sieben_model::problems::Problem;
use sieben_model::visible::{self, visible};

use crate::failure::Failure;

/// Prints results for people to read: names and texts of others in them are shown and never obeyed.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    put(&visible(text))
}

/// Prints what belongs into a file, such as a source: byte by byte, unless a terminal would obey it.
pub(crate) fn print_data(text: &str) -> Result<(), Failure> {
    if io::stdout().is_terminal() { print(text) } else { put(text) }
}

fn put(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    printed(out.write_all(text.as_bytes()).and_then(|()| out.flush()))
}

/// What came of printing. A closed pipe (`| head`) ends the program quietly.
pub(crate) fn printed(result: io::Result<()>) -> Result<(), Failure> {
    match result {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => std::process::exit(0),
        Err(error) => Err(Failure::usage(Problem::P6013, format!("the output cannot be written: {error}"))),
    }
}

/// Prints one value as JSON and a line end.
pub(crate) fn print_json(value: &serde_json::Value, indented: bool) -> Result<(), Failure> {
    put(&json_text(value, indented))
}

/// A value as JSON and a line end; hidden characters are escaped, which means the same to every reader.
fn json_text(value: &serde_json::Value, indented: bool) -> String {
    let mut text = if indented { format!("{value:#}") } else { value.to_string() };
    if visible::hidden(&text).next().is_some() {
        // Outside of strings JSON has no such character but line ends.
        text = text.chars().fold(String::new(), |mut out, character| {
            match visible::is_hidden(character) {
                true => out.push_str(&format!("\\u{:04x}", u32::from(character))),
                false => out.push(character),
            }
            out
        });
    }
    text.push('\n');
    text
}

/// Prints messages. A failure is dropped: there is no other place to report it.
pub(crate) fn message(text: &str) {
    styled(&visible(text));
}

/// Prints messages as one JSON value.
pub(crate) fn message_json(value: &serde_json::Value) {
    styled(&json_text(value, true));
}

/// Messages that wait while a screen has the terminal.
static HELD: Mutex<Option<Vec<String>>> = Mutex::new(None);

/// Messages that wait at most; what comes then is dropped.
const HELD_MAX: usize = 1_000;

fn waiting() -> MutexGuard<'static, Option<Vec<String>>> {
    HELD.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on messages wait: a screen has the terminal.
pub(crate) fn hold() {
    waiting().get_or_insert_default();
}

/// The messages that wait, for the screen to show.
pub(crate) fn held() -> Vec<String> {
    waiting().as_mut().map(std::mem::take).unwrap_or_default()
}

/// The terminal is free again: what still waits is printed.
pub(crate) fn release() {
    for text in waiting().take().unwrap_or_default() {
        styled(&text);
    }
}

/// Prints a message with colours, in which all that others wrote was made visible before. While a screen has the terminal it waits.
pub(crate) fn styled(text: &str) {
    if let Some(held) = waiting().as_mut() {
        if held.len() < HELD_MAX {
            held.push(text.to_owned());
        }
        return;
    }
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Whether messages may be coloured.
pub(crate) fn colour() -> bool {
    let unset = |name: &str| std::env::var_os(name).is_none_or(|value| value.is_empty());
    io::stderr().is_terminal() && waiting().is_none() && unset("NO_COLOR") && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}
