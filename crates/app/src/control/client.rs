//! Asks a run at its control socket.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::os::unix::net::UnixStream;
use std::path::PathBuf;
use std::time::Duration;

use serde_json::{Value, json};
use sieben_model::problems::Problem;

use super::place::{self, DEMO};
use crate::failure::Failure;
use crate::paths::shown;

/// Longest answer, in bytes: far more than any has.
const ANSWER_BYTES_MAX: u64 = 16 << 20;
/// How long an answer is waited for: a run that is stopped in a debugger does not answer.
const ANSWER_WAIT: Duration = Duration::from_secs(5);

/// A connection to a run.
pub(crate) struct Client {
    stream: BufReader<UnixStream>,
    /// The number of the last request.
    number: u64,
}

impl Client {
    /// Connects to the run of the program that these paths name.
    pub(crate) fn connect(paths: &[PathBuf]) -> Result<Self, Failure> {
        let missing = paths.iter().find(|path| !path.exists());
        // The demo has no path; what lies here under its name goes first.
        let is_demo = matches!(paths, [path] if path.as_os_str() == DEMO);
        let mut places = match missing {
            None => place::places(paths, place::home(paths).as_deref()),
            Some(_) if is_demo => Vec::new(),
            Some(missing) => return Err(Failure::usage(Problem::P6001, format!("`{}` does not exist", shown(missing)))),
        };
        if is_demo {
            places.extend(place::of_demo());
        }
        let mut refused = None;
        for place in places {
            match place.connect() {
                Ok(socket) => {
                    let client = Self { stream: BufReader::new(UnixStream::from(socket)), number: 0 };
                    return client.wait_at_most(ANSWER_WAIT).map(|()| client).map_err(|error| silent(&error));
                }
                Err(error) if error.kind() == io::ErrorKind::PermissionDenied => refused = Some((place, error)),
                // No run is there, or a killed one left its socket.
                Err(_) => {}
            }
        }
        let what = match paths {
            [] => "this folder".to_owned(),
            paths => paths.iter().map(|path| format!("`{}`", shown(path))).collect::<Vec<_>>().join(", "),
        };
        Err(match refused {
            Some((place, error)) => Failure::usage(Problem::P7090, format!("`{}` cannot be opened: {error}", place::shown(&place)))
                .help("only the user who started a run can look at it"),
            None if is_demo => Failure::usage(Problem::P7090, "no demo answers").help("start it with `sieben demo` in another terminal"),
            None => {
                let failure = Failure::usage(Problem::P7090, format!("no run of {what} answers"));
                let has_demo = place::of_demo().iter().any(|place| place.connect().is_ok());
                if has_demo { failure.help("the demo runs: `sieben top demo`") } else { failure }
            }
        })
    }

    /// Waits no longer for an answer from now on.
    ///
    /// # Errors
    /// The system refuses it.
    pub(crate) fn wait_at_most(&self, wait: Duration) -> io::Result<()> {
        let stream = self.stream.get_ref();
        stream.set_read_timeout(Some(wait)).and_then(|()| stream.set_write_timeout(Some(wait)))
    }

    /// Asks and waits for the answer. `verb` and `fields` are those of the request.
    ///
    /// # Errors
    /// The run is over, or does not answer.
    pub(crate) fn ask(&mut self, verb: &str, fields: &Value) -> io::Result<Value> {
        self.number += 1;
        let mut request = json!({ "id": self.number, "verb": verb });
        for (key, value) in fields.as_object().into_iter().flatten() {
            request[key] = value.clone();
        }
        let mut line = request.to_string();
        line.push('\n');
        self.stream.get_mut().write_all(line.as_bytes())?;
        let mut answer = Vec::new();
        (&mut self.stream).take(ANSWER_BYTES_MAX).read_until(b'\n', &mut answer)?;
        if answer.last() != Some(&b'\n') {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        serde_json::from_slice(&answer).map_err(io::Error::other)
    }
}

/// A run that does not answer.
pub(crate) fn silent(error: &io::Error) -> Failure {
    let message = match error.kind() {
        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => {
            return Failure::usage(Problem::P7090, format!("the run has not answered for {} seconds", ANSWER_WAIT.as_secs()))
                .help("it may be suspended (Ctrl-Z, a debugger), or the computer is very busy");
        }
        io::ErrorKind::UnexpectedEof | io::ErrorKind::BrokenPipe | io::ErrorKind::ConnectionReset => "the run is over".to_owned(),
        _ => format!("the run does not answer: {error}"),
    };
    Failure::usage(Problem::P7090, message)
}
