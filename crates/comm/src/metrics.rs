//! The numbers of a run over HTTP, as Prometheus fetches them: one text, one connection at a time.

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
/// How long a client may take for its request, and for the answer.
const CLIENT_WAIT_MAX: Duration = Duration::from_secs(2);
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

fn serve(listener: &TcpListener, shared: &Shared, text: &Text) {
    while !shared.ends.load(Ordering::Acquire) {
        // A signal ends the waiting.
        let _ = poll(&mut [PollFd::new(listener, PollFlags::IN), PollFd::new(&shared.wake, PollFlags::IN)], None);
        match listener.accept() {
            // One that goes away in the middle has its reasons.
            Ok((stream, _)) => drop(answer(stream, text)),
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {}
            Err(_) => drop(poll(&mut [PollFd::new(&shared.wake, PollFlags::IN)], Some(&ERROR_WAIT))),
        }
    }
}

/// Answers one request, and ends the connection in order.
fn answer(mut stream: TcpStream, text: &Text) -> io::Result<()> {
    stream.set_nonblocking(false)?;
    stream.set_write_timeout(Some(CLIENT_WAIT_MAX))?;
    let end = Instant::now() + CLIENT_WAIT_MAX;
    let head = head(&mut stream, end)?;
    let (status, body) = reply(&head, text);
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: text/plain; version=0.0.4; charset=utf-8\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
        body.len()
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body.as_bytes())?;
    stream.shutdown(Shutdown::Write)?;
    // What still comes is read, so that the other side sees an end and no reset.
    let mut rest = [0; 1024];
    while Instant::now() < end && read(&mut stream, &mut rest, end)? > 0 {}
    Ok(())
}

fn read(stream: &mut TcpStream, buffer: &mut [u8], end: Instant) -> io::Result<usize> {
    let left = end.saturating_duration_since(Instant::now()).max(Duration::from_millis(1));
    stream.set_read_timeout(Some(left))?;
    stream.read(buffer)
}

/// Reads a request up to its empty line.
fn head(stream: &mut TcpStream, end: Instant) -> io::Result<Vec<u8>> {
    let (mut head, mut buffer) = (Vec::new(), [0; 1024]);
    while !head.windows(4).any(|bytes| bytes == b"\r\n\r\n") {
        let count = read(stream, &mut buffer, end)?;
        if count == 0 || head.len() + count > REQUEST_BYTES_MAX || Instant::now() >= end {
            return Err(io::ErrorKind::InvalidData.into());
        }
        head.extend_from_slice(buffer.get(..count).unwrap_or_default());
    }
    Ok(head)
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
