//! The connections of the server: so many at a time, each with a time in which it has to say what it wants. Where there are too many, the one
//! that has done nothing for the longest time makes room, so that connections that only wait keep no others out.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::net::SocketAddr;
use std::pin::Pin;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll};
use std::time::Duration;

use axum::body::{Body, Bytes, HttpBody};
use axum::http::{HeaderValue, Request, Response, header};
use hyper::body::{Frame, Incoming, SizeHint};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Notify;
use tokio::time::Instant;

use crate::server::Shared;

/// Connections that wait or are answered at a time; WebSockets are counted apart.
const CONNECTIONS_MAX: usize = 128;
/// Time in which the head of a request has to come, from the beginning of the connection or from the last answer on.
const HEAD_WAIT_MAX: Duration = Duration::from_secs(20);
/// Longest head of a request, in bytes.
const HEAD_BYTES_MAX: usize = 64 * 1024;
/// An answer that takes longer than this makes room for others as one does that waits.
const ANSWER_WAIT_MAX: Duration = Duration::from_secs(10);
/// How long nothing is accepted when the system has no room.
const NO_ROOM_WAIT: Duration = Duration::from_millis(100);

/// What a connection does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Does {
    /// It waits for a request.
    Waits,
    /// A request is answered.
    Answers,
    /// It is sent events until it ends: these are counted as pages.
    Streams,
}

/// A connection.
struct Entry {
    does: Does,
    since: Instant,
    /// Ends it.
    end: Arc<Notify>,
}

/// All connections that are neither over nor WebSockets.
#[derive(Default)]
struct Connections {
    table: Mutex<BTreeMap<u64, Entry>>,
}

impl Connections {
    fn table(&self) -> MutexGuard<'_, BTreeMap<u64, Entry>> {
        self.table.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// One more; what ends it. `None` if there is no room, and none can be made.
    fn enter(&self, number: u64, now: Instant) -> Option<Arc<Notify>> {
        let mut table = self.table();
        if table.len() >= CONNECTIONS_MAX {
            let spare = |entry: &Entry| match entry.does {
                Does::Waits => true,
                Does::Answers => now.saturating_duration_since(entry.since) > ANSWER_WAIT_MAX,
                Does::Streams => false,
            };
            let longest = table.iter().filter(|(_, entry)| spare(entry)).min_by_key(|(_, entry)| entry.since).map(|(number, _)| *number)?;
            if let Some(entry) = table.remove(&longest) {
                entry.end.notify_one();
            }
        }
        let end = Arc::new(Notify::new());
        table.insert(number, Entry { does: Does::Waits, since: now, end: Arc::clone(&end) });
        Some(end)
    }

    fn set(&self, number: u64, does: Does) {
        if let Some(entry) = self.table().get_mut(&number) {
            (entry.does, entry.since) = (does, Instant::now());
        }
    }
}

/// A connection waits again when this goes.
struct Answering {
    connections: Arc<Connections>,
    number: u64,
}

impl Drop for Answering {
    fn drop(&mut self) {
        self.connections.set(self.number, Does::Waits);
    }
}

/// The body of an answer; with its end the connection waits again.
struct Counted {
    body: Body,
    _answering: Answering,
}

impl HttpBody for Counted {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        Pin::new(&mut self.body).poll_frame(context)
    }

    fn is_end_stream(&self) -> bool {
        self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        self.body.size_hint()
    }
}

/// Accepts connections, and answers what they ask.
pub(crate) async fn serve(listener: TcpListener, shared: Arc<Shared>) {
    let connections = Arc::new(Connections::default());
    for number in 0.. {
        let (stream, peer) = match listener.accept().await {
            Ok(accepted) => accepted,
            // One that has gone already; or no room for another handle.
            Err(_) => {
                tokio::time::sleep(NO_ROOM_WAIT).await;
                continue;
            }
        };
        let Some(end) = connections.enter(number, Instant::now()) else { continue };
        let (shared, connections) = (Arc::clone(&shared), Arc::clone(&connections));
        tokio::spawn(async move {
            tokio::select! {
                () = answer(stream, peer, shared, (&connections, number)) => {}
                () = end.notified() => {}
            }
            connections.table().remove(&number);
        });
    }
}

/// Answers the requests of a connection until it ends, or becomes a WebSocket.
async fn answer(stream: TcpStream, peer: SocketAddr, shared: Arc<Shared>, (connections, number): (&Arc<Connections>, u64)) {
    // Small messages are to come at once.
    let _ = stream.set_nodelay(true);
    let service = service_fn(|request: Request<Incoming>| {
        let (shared, connections) = (Arc::clone(&shared), Arc::clone(connections));
        async move {
            connections.set(number, Does::Answers);
            let answering = Answering { connections, number };
            let response = super::answer(shared, peer, request.map(Body::new)).await;
            let kind = response.headers().get(header::CONTENT_TYPE).map(HeaderValue::as_bytes);
            if kind == Some(b"text/event-stream") {
                answering.connections.set(number, Does::Streams);
            }
            Ok::<Response<Counted>, Infallible>(response.map(|body| Counted { body, _answering: answering }))
        }
    });
    let mut server = http1::Builder::new();
    server.timer(TokioTimer::new()).header_read_timeout(HEAD_WAIT_MAX).max_buf_size(HEAD_BYTES_MAX);
    // What goes wrong with a connection is a matter of the other side.
    let _ = server.serve_connection(TokioIo::new(stream), service).with_upgrades().await;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_one_that_waits_for_the_longest_time_makes_room() {
        let connections = Connections::default();
        let begin = Instant::now();
        let at = |ms: u64| begin + Duration::from_millis(ms);
        for number in 0..CONNECTIONS_MAX as u64 {
            assert!(connections.enter(number, at(number)).is_some());
        }
        let does = |number: u64, does: Does| connections.table().get_mut(&number).expect("it is there").does = does;
        does(0, Does::Streams);
        does(1, Does::Answers);
        assert!(connections.enter(1_000, at(1_000)).is_some());
        assert!(!connections.table().contains_key(&2), "of those that wait the oldest went");
        assert_eq!(connections.table().len(), CONNECTIONS_MAX);
        let numbers: Vec<u64> = connections.table().keys().copied().collect();
        numbers.iter().skip(1).for_each(|&number| does(number, Does::Answers));
        assert!(connections.enter(1_001, at(2_000)).is_none(), "none can go");
        assert!(connections.enter(1_002, at(11_000)).is_some(), "an answer that takes too long makes room");
        assert!(connections.table().contains_key(&0) && !connections.table().contains_key(&1));
    }
}
