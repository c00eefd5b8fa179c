//! The numbers of a run over HTTP, as Prometheus fetches them: one text, for a few connections at a time.

use std::io::{self, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::os::fd::OwnedFd;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use rustix::event::{EventfdFlags, PollFd, PollFlags, Timespec, poll};

/// Bytes of a request that are read; those of Prometheus have a few hundred.
const REQUEST_BYTES_MAX: usize = 8 * 1024;
/// How long a client may take for its request and for going.
const CLIENT_WAIT_MAX: Duration = Duration::from_secs(2);
/// How long an answer may take that the socket does not take at once.
const WRITE_WAIT_MAX: Duration = Duration::from_millis(100);
/// Clients at a time; one more, and the oldest goes.
const CLIENTS_MAX: usize = 16;
/// How long nothing is accepted after an error.
const ERROR_WAIT: Timespec = Timespec { tv_sec: 0, tv_nsec: 100_000_000 };

/// Makes the text; `None` at the end of the run.
pub type Text = Box<dyn Fn() -> Option<String> + Send>;

/// A server that tells numbers, until this is dropped.
pub struct Metrics {
    address: SocketAddr,
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

struct Shared {
    wake: OwnedFd,
    ends: AtomicBool,
}

impl Metrics {
    /// Serves the text in a thread of its own.
    ///
    /// # Errors
    /// The system has no room for the thread or its handles.
    pub fn start(listener: TcpListener, text: Text) -> io::Result<Self> {
        let address = listener.local_addr()?;
        listener.set_nonblocking(true)?;
        let wake = rustix::event::eventfd(0, EventfdFlags::CLOEXEC | EventfdFlags::NONBLOCK)?;
        let shared = Arc::new(Shared { wake, ends: AtomicBool::default() });
        let theirs = Arc::clone(&shared);
        let thread = std::thread::Builder::new().name("metrics".to_owned()).spawn(move || serve(&listener, &theirs, &text))?;
        Ok(Self { address, shared, thread: Some(thread) })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }
}

impl Drop for Metrics {
    fn drop(&mut self) {
        self.shared.ends.store(true, Ordering::Release);
        // It fails only if the thread has been woken already.
        let _ = rustix::io::write(&self.shared.wake, &1_u64.to_ne_bytes());
        if let Some(thread) = self.thread.take() {
            // A panic of the thread was reported where it happened.
            let _ = thread.join();
        }
    }
}

/// A client: what it has asked so far, and until when it has time.
struct Client {
    stream: TcpStream,
    head: Vec<u8>,
    until: Instant,
    is_answered: bool,
}

/// Whether a client stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Next {
    Stays,
    Goes,
}

fn serve(listener: &TcpListener, shared: &Shared, text: &Text) {
    let mut clients: Vec<Client> = Vec::new();
    while !shared.ends.load(Ordering::Acquire) {
        let ready = wait(listener, shared, &clients);
        let now = Instant::now();
        let mut ready = ready.into_iter();
        clients.retain_mut(|client| match ready.next() {
            Some(true) => client.take(text).is_ok_and(|next| next == Next::Stays),
            _ => now < client.until,
        });
        match listener.accept() {
            Ok((stream, _)) => {
                // Those who only hold a place make room.
                if clients.len() >= CLIENTS_MAX {
                    clients.remove(0);
                }
                // One that goes away in the middle has its reasons.
                clients.extend(Client::new(stream));
            }
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {}
            Err(_) => drop(poll(&mut [PollFd::new(&shared.wake, PollFlags::IN)], Some(&ERROR_WAIT))),
        }
    }
}

/// Waits until something comes or a time is over; which clients have sent something.
fn wait(listener: &TcpListener, shared: &Shared, clients: &[Client]) -> Vec<bool> {
    let until = clients.iter().map(|client| client.until).min();
    let left = until.map(|until| until.saturating_duration_since(Instant::now()) + Duration::from_millis(1));
    let left = left.map(|left| Timespec { tv_sec: left.as_secs() as i64, tv_nsec: left.subsec_nanos().into() });
    let of_clients = clients.iter().map(|client| PollFd::new(&client.stream, PollFlags::IN));
    let mut handles: Vec<PollFd<'_>> = of_clients.collect();
    handles.extend([PollFd::new(listener, PollFlags::IN), PollFd::new(&shared.wake, PollFlags::IN)]);
    // A signal ends the waiting.
    let is_ready = poll(&mut handles, left.as_ref()).is_ok();
    handles.iter().take(clients.len()).map(|handle| is_ready && !handle.revents().is_empty()).collect()
}

impl Client {
    fn new(stream: TcpStream) -> Option<Self> {
        stream.set_nonblocking(true).ok()?;
        Some(Self { stream, head: Vec::new(), until: Instant::now() + CLIENT_WAIT_MAX, is_answered: false })
    }

    /// Takes what has come. After the answer it is only read, so that the other side sees an end and no reset.
    fn take(&mut self, text: &Text) -> io::Result<Next> {
        let mut buffer = [0; 1024];
        let count = match self.stream.read(&mut buffer) {
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => return Ok(Next::Stays),
            count => count?,
        };
        if count == 0 || !self.is_answered && self.head.len() + count > REQUEST_BYTES_MAX {
            return Ok(Next::Goes);
        }
        if !self.is_answered {
            self.head.extend_from_slice(buffer.get(..count).unwrap_or_default());
            if self.head.windows(4).any(|bytes| bytes == b"\r\n\r\n") {
                self.is_answered = true;
                self.answer(text)?;
            }
        }
        Ok(if Instant::now() < self.until { Next::Stays } else { Next::Goes })
    }

    /// Answers, and ends the connection in order.
    fn answer(&mut self, text: &Text) -> io::Result<()> {
        let (status, body) = reply(&self.head, text);
        let head = format!(
            "HTTP/1.1 {status}\r\nContent-Type: text/plain; version=0.0.4; charset=utf-8\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
            body.len()
        );
        // It fits into the buffer of a socket that is new; one that takes less is not waited for long.
        self.stream.set_nonblocking(false)?;
        self.stream.set_write_timeout(Some(WRITE_WAIT_MAX))?;
        self.stream.write_all(&[head, body].concat().into_bytes())?;
        self.stream.set_nonblocking(true)?;
        self.stream.shutdown(Shutdown::Write)
    }
}

/// Status and text for a request.
fn reply(head: &[u8], text: &Text) -> (&'static str, String) {
    let line = head.split(|&byte| byte == b'\r').next().unwrap_or_default();
    let mut words = line.split(|&byte| byte == b' ');
    let path = |word: &[u8]| word.split(|&byte| byte == b'?').next() == Some(b"/metrics");
    match (words.next(), words.next()) {
        (Some(b"GET"), Some(word)) if path(word) => match text() {
            Some(text) => ("200 OK", text),
            None => ("503 Service Unavailable", "the run is over\n".to_owned()),
        },
        (Some(b"GET"), _) => ("404 Not Found", "the numbers of this run are at /metrics\n".to_owned()),
        _ => ("405 Method Not Allowed", "only GET is answered\n".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clients_that_say_nothing_hold_up_neither_others_nor_the_end() {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
        let metrics = Metrics::start(listener, Box::new(|| Some("n 1\n".to_owned()))).expect("a thread");
        let connect = || TcpStream::connect(metrics.address()).expect("it listens");
        let silent: Vec<TcpStream> = (0..2 * CLIENTS_MAX).map(|_| connect()).collect();
        let begin = Instant::now();
        let mut client = connect();
        let mut answer = String::new();
        client.write_all(b"GET /metrics HTTP/1.1\r\n\r\n").and_then(|()| client.read_to_string(&mut answer)).expect("an answer");
        assert!(answer.ends_with("\r\n\r\nn 1\n"), "{answer}");
        drop(metrics);
        assert!(begin.elapsed() < CLIENT_WAIT_MAX / 2, "{:?}", begin.elapsed());
        drop(silent);
    }

    #[test]
    fn only_the_numbers_are_there_to_be_fetched() {
        let text: Text = Box::new(|| Some("n 1\n".to_owned()));
        for (request, status) in [
            ("GET /metrics HTTP/1.1\r\n\r\n", "200 OK"),
            ("GET /metrics?a=b HTTP/1.0\r\n\r\n", "200 OK"),
            ("GET / HTTP/1.1\r\n\r\n", "404 Not Found"),
            ("GET\r\n\r\n", "404 Not Found"),
            ("POST /metrics HTTP/1.1\r\n\r\n", "405 Method Not Allowed"),
            ("", "405 Method Not Allowed"),
        ] {
            assert_eq!(reply(request.as_bytes(), &text).0, status, "{request}");
        }
        assert_eq!(reply(b"GET /metrics HTTP/1.1\r\n\r\n", &(Box::new(|| None) as Text)).0, "503 Service Unavailable");
    }
}
