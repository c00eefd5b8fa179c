//! Serves the control socket of a run: one thread that accepts, one for each client, all of which end with the run.

use std::fmt;
use std::io::{self, ErrorKind, Read, Write};
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use serde_json::Value;
use sieben_model::problems::Problem;
use sieben_workspace::control::{Connection, Control, CurrentFacts, LINE_BYTES_MAX, line, too_long};
use sieben_workspace::status::Desk;
use sieben_workspace::{Gate, Refusal};

use super::place::{self, Bound, NoSocket, Place};

/// Clients at once.
const CONNECTIONS_MAX: usize = 16;
/// How long a client may leave its answers unread.
const UNREAD_MAX: Duration = Duration::from_secs(10);
/// How long one attempt to write waits before it is looked whether the run is over.
const WRITE_WAIT: Duration = Duration::from_millis(200);
/// How long the thread that accepts waits when the system has no room for another connection.
const NO_ROOM_WAIT: Timespec = Timespec { tv_sec: 0, tv_nsec: 100_000_000 };

/// Why a run goes on without a control socket.
#[derive(Debug)]
pub(crate) enum Without {
    /// Another run of the same program has it, at this place.
    Taken(String),
    /// It cannot be made, for this reason.
    Failed(String),
}

impl Without {
    /// The same in a few words.
    pub(crate) fn note(&self) -> &'static str {
        match self {
            Self::Taken(_) => "another demo answers `sieben top`",
            Self::Failed(_) => "no control socket: no `sieben top`",
        }
    }
}

impl fmt::Display for Without {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Taken(place) => {
                writeln!(f, "Another run of this program answers at `{place}`; this one goes on without a control socket.")
            }
            Self::Failed(why) => writeln!(f, "This run goes on without a control socket, so `sieben top` does not see it: {why}."),
        }
    }
}

/// What the threads share.
struct Shared {
    gate: Arc<Gate>,
    desk: Arc<Desk>,
    facts: Arc<CurrentFacts>,
    /// The connected clients, by number, so that the end of the run wakes their threads.
    clients: Mutex<Vec<(u64, UnixStream)>>,
}

/// The control socket of a run, served until this is dropped.
pub(crate) struct Server {
    shared: Arc<Shared>,
    /// Its end wakes the thread that accepts.
    wake: Option<UnixStream>,
    acceptor: Option<JoinHandle<()>>,
    /// The socket goes last.
    _bound: Bound,
}

impl Server {
    /// Begins to serve the run of the program that these paths name. `home` is the folder of its `sieben.toml`.
    ///
    /// # Errors
    /// The run goes on without a socket.
    pub(crate) fn start(
        (paths, home): (&[PathBuf], Option<&Path>),
        gate: &Arc<Gate>,
        desk: &Arc<Desk>,
        facts: &Arc<CurrentFacts>,
    ) -> Result<Self, Without> {
        Self::at(&place::places(paths, home), gate, desk, facts)
    }

    /// Begins to serve the demo.
    ///
    /// # Errors
    /// The demo goes on without a socket.
    pub(crate) fn of_demo(gate: &Arc<Gate>, desk: &Arc<Desk>, facts: &Arc<CurrentFacts>) -> Result<Self, Without> {
        Self::at(&place::of_demo(), gate, desk, facts)
    }

    fn at(places: &[Place], gate: &Arc<Gate>, desk: &Arc<Desk>, facts: &Arc<CurrentFacts>) -> Result<Self, Without> {
        let bound = bind(places)?;
        let shared =
            Arc::new(Shared { gate: Arc::clone(gate), desk: Arc::clone(desk), facts: Arc::clone(facts), clients: Mutex::default() });
        Self::threads(shared, bound).map_err(|error| Without::Failed(error.to_string()))
    }

    fn threads(shared: Arc<Shared>, bound: Bound) -> io::Result<Self> {
        let listener = UnixListener::from(bound.listener.try_clone()?);
        let (wake, woken) = UnixStream::pair()?;
        let (gate, desk) = (Arc::clone(&shared.gate), Arc::clone(&shared.desk));
        // It ends by itself when the run is over.
        std::thread::Builder::new().name("status".to_owned()).spawn(move || desk.replay(|| gate.is_closed()))?;
        let theirs = Arc::clone(&shared);
        let acceptor = std::thread::Builder::new().name("control".to_owned()).spawn(move || theirs.accept(&listener, &woken))?;
        Ok(Self { shared, wake: Some(wake), acceptor: Some(acceptor), _bound: bound })
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        drop(self.wake.take());
        if let Some(acceptor) = self.acceptor.take() {
            // A panic of the thread was reported where it happened.
            let _ = acceptor.join();
        }
        for (_, stream) in self.shared.clients() {
            // One that has gone by itself is as good.
            let _ = stream.shutdown(std::net::Shutdown::Both);
        }
    }
}

/// The first place where the socket can be.
fn bind(places: &[Place]) -> Result<Bound, Without> {
    let mut why = "no path for it is short enough".to_owned();
    for place in places {
        match place.clone().bind() {
            Ok(bound) => return Ok(bound),
            Err(NoSocket::Taken) => return Err(Without::Taken(place::shown(place))),
            Err(NoSocket::Failed(error)) => why = format!("`{}`: {error}", place::shown(place)),
        }
    }
    Err(Without::Failed(why))
}

impl Shared {
    fn clients(&self) -> Vec<(u64, UnixStream)> {
        std::mem::take(&mut *self.clients.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Accepts until the other end of `woken` is gone.
    fn accept(self: &Arc<Self>, listener: &UnixListener, woken: &UnixStream) {
        for number in 0.. {
            let mut waiting = [PollFd::new(listener, PollFlags::IN), PollFd::new(woken, PollFlags::IN)];
            // A signal ends the waiting.
            let _ = poll(&mut waiting, None);
            if !waiting[1].revents().is_empty() {
                return;
            }
            match listener.accept() {
                Ok((stream, _)) => self.welcome(number, stream),
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => {}
                // No room for another handle: what would be tried again at once waits for the end of the run instead, for a moment.
                Err(_) => drop(poll(&mut [PollFd::new(woken, PollFlags::IN)], Some(&NO_ROOM_WAIT))),
            }
        }
    }

    fn welcome(self: &Arc<Self>, number: u64, mut stream: UnixStream) {
        let Some(connection) = self.facts.connect(CONNECTIONS_MAX) else {
            let refusal = Refusal::new(Problem::P7092, format!("{CONNECTIONS_MAX} are connected, which is the most"));
            // A client that does not read it sees the end.
            let _ = stream.set_nonblocking(true).and_then(|()| stream.write_all(line(&Value::Null, &Err(refusal)).as_bytes()));
            return;
        };
        let Ok(theirs) = stream.try_clone() else { return };
        self.clients.lock().unwrap_or_else(PoisonError::into_inner).push((number, theirs));
        let shared = Arc::clone(self);
        let serve = move || {
            shared.serve(&mut stream, &connection);
            shared.clients.lock().unwrap_or_else(PoisonError::into_inner).retain(|(other, _)| *other != number);
        };
        if std::thread::Builder::new().name("client".to_owned()).spawn(serve).is_err() {
            self.clients.lock().unwrap_or_else(PoisonError::into_inner).retain(|(other, _)| *other != number);
        }
    }

    /// Answers the lines of one client until it goes, or the run is over.
    fn serve(&self, stream: &mut UnixStream, _connection: &Connection) {
        if stream.set_nonblocking(false).and_then(|()| stream.set_write_timeout(Some(WRITE_WAIT))).is_err() {
            return;
        }
        let mut control = Control::new(Arc::clone(&self.facts));
        let mut lines = Lines::default();
        while !self.gate.is_closed() {
            let answer = match lines.next(stream) {
                Ok(None) | Err(_) => return,
                Ok(Some(Line::TooLong)) => line(&Value::Null, &Err(too_long())),
                Ok(Some(Line::Whole(request))) if request.iter().all(u8::is_ascii_whitespace) => continue,
                Ok(Some(Line::Whole(request))) => control.answer_line(&self.gate, &self.desk, &request),
            };
            if self.write(stream, answer.as_bytes()).is_err() {
                return;
            }
        }
    }

    /// Writes an answer; a client that takes nothing of it for [`UNREAD_MAX`] is given up.
    fn write(&self, stream: &mut UnixStream, mut bytes: &[u8]) -> io::Result<()> {
        let mut taken = Instant::now();
        while !bytes.is_empty() {
            match stream.write(bytes) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(count) => {
                    bytes = bytes.get(count..).unwrap_or_default();
                    taken = Instant::now();
                }
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted) => {
                    if self.gate.is_closed() || taken.elapsed() >= UNREAD_MAX {
                        return Err(error);
                    }
                }
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

/// A line of a client.
enum Line {
    /// All of it, without its end.
    Whole(Vec<u8>),
    /// It was longer than a request may be, and is left out.
    TooLong,
}

/// Takes lines from a stream; of one that is too long nothing is kept.
#[derive(Default)]
struct Lines {
    /// What came and is no whole line yet.
    rest: Vec<u8>,
    /// The line that comes is too long already.
    skips: bool,
}

impl Lines {
    /// The next line; `None` at the end of the stream, also in the middle of a line.
    fn next(&mut self, stream: &mut impl Read) -> io::Result<Option<Line>> {
        loop {
            if let Some(end) = self.rest.iter().position(|&byte| byte == b'\n') {
                let mut line: Vec<u8> = self.rest.drain(..=end).collect();
                line.pop();
                let is_long = std::mem::take(&mut self.skips) || line.len() > LINE_BYTES_MAX;
                return Ok(Some(if is_long { Line::TooLong } else { Line::Whole(line) }));
            }
            if self.rest.len() > LINE_BYTES_MAX {
                self.rest.clear();
                self.skips = true;
            }
            let mut chunk = [0; 8192];
            match stream.read(&mut chunk) {
                Ok(0) => return Ok(None),
                Ok(count) => self.rest.extend_from_slice(chunk.get(..count).unwrap_or_default()),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_taken_whole_and_long_ones_left_out() {
        let long = "x".repeat(3 * LINE_BYTES_MAX);
        let exact = "y".repeat(LINE_BYTES_MAX);
        let text = format!("a\n\n{long}\n{exact}\n{exact}z\nb\nhalf");
        let mut stream = text.as_bytes();
        let mut lines = Lines::default();
        let mut seen = Vec::new();
        while let Some(line) = lines.next(&mut stream).expect("bytes in memory") {
            seen.push(match line {
                Line::Whole(line) => line.len().to_string(),
                Line::TooLong => "too long".to_owned(),
            });
        }
        assert_eq!(seen, ["1", "0", "too long", "65536", "too long", "1"]);
    }
}
