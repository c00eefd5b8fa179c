//! Results on standard output, messages on standard error; a reader that goes away is no mistake.

use std::io::{self, IsTerminal, Write};

use sieben_model::problems::Problem;

use crate::failure::Failure;

/// Prints results. A closed pipe (`| head`) ends the program quietly.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => std::process::exit(0),
        Err(error) => Err(Failure::usage(Problem::P6013, format!("the output cannot be written: {error}"))),
    }
}

/// Prints one value as JSON and a line end.
pub(crate) fn print_json(value: &serde_json::Value, indented: bool) -> Result<(), Failure> {
    let mut text = if indented { format!("{value:#}") } else { value.to_string() };
    text.push('\n');
    print(&text)
}

/// Prints messages. Nobody can be told if that fails, so a failure is dropped.
pub(crate) fn message(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Whether messages may be coloured.
pub(crate) fn colour() -> bool {
    let unset = |name: &str| std::env::var_os(name).is_none_or(|value| value.is_empty());
    io::stderr().is_terminal() && unset("NO_COLOR") && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}
