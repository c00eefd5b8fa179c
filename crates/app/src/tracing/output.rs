//! What is written of a trace: diagrams, dumps, tables.

use std::fmt;
use std::io::{self, Write};
use std::path::Path;

use sieben_model::problems::Problem;
use sieben_sim::trace::{Trace, TraceError};

use crate::failure::Failure;
use crate::{files, output};

/// Text that goes to a writer of bytes; keeps the error that text cannot carry.
struct Text<'a> {
    bytes: &'a mut dyn Write,
    error: Option<io::Error>,
}

impl fmt::Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.bytes.write_all(text.as_bytes()).map_err(|error| {
            self.error = Some(error);
            fmt::Error
        })
    }
}

/// What renders a trace as text.
pub(crate) type Render<'a> = &'a dyn Fn(&Trace, &mut dyn fmt::Write) -> Result<(), TraceError>;

/// Writes what is rendered to a file, as a whole or not at all; `-` is standard output.
pub(crate) fn write(path: &Path, trace: &Trace, render: Render<'_>) -> Result<(), Failure> {
    if path.as_os_str() == "-" {
        return print(trace, render);
    }
    files::write_with(path, &mut |bytes| {
        let mut text = Text { bytes, error: None };
        match render(trace, &mut text) {
            Ok(()) => Ok(()),
            Err(error) => Err(text.error.unwrap_or_else(|| io::Error::other(error))),
        }
    })
}

/// Prints what is rendered, piece by piece.
fn print(trace: &Trace, render: Render<'_>) -> Result<(), Failure> {
    struct Printed {
        waiting: String,
        failure: Option<Failure>,
    }
    impl fmt::Write for Printed {
        fn write_str(&mut self, text: &str) -> fmt::Result {
            self.waiting.push_str(text);
            if self.waiting.len() < 1 << 16 {
                return Ok(());
            }
            output::print_data(&std::mem::take(&mut self.waiting)).map_err(|failure| {
                self.failure = Some(failure);
                fmt::Error
            })
        }
    }
    let mut printed = Printed { waiting: String::new(), failure: None };
    match render(trace, &mut printed) {
        Ok(()) => output::print_data(&printed.waiting),
        Err(error) => Err(printed.failure.unwrap_or_else(|| unreadable(&error))),
    }
}

/// A message about a trace that cannot be written or read on.
pub(crate) fn unwritable(error: &TraceError) -> Failure {
    Failure::usage(Problem::P6013, error.to_string())
}

/// A message about a recording that cannot be read.
pub(crate) fn unreadable(error: &TraceError) -> Failure {
    let problem = if matches!(error, TraceError::Store(_)) { Problem::P6001 } else { Problem::P6262 };
    Failure::usage(problem, error.to_string())
}
