//! The sockets of a server, and how they are waited for.

use std::io::{self, ErrorKind, Read, Write};
use std::mem::MaybeUninit;
use std::net::TcpStream;
use std::os::fd::{AsFd, OwnedFd};
use std::time::Duration;

use rustix::event::Timespec;
use rustix::event::epoll::{self, CreateFlags, Event, EventData, EventFlags};
use rustix::io::Errno;
use rustix::net::sockopt;

/// How long a connection is silent before the system asks whether the other side is still there.
const KEEPALIVE_IDLE: Duration = Duration::from_secs(30);
/// How long it waits for an answer before it asks again.
const KEEPALIVE_INTERVAL: Duration = Duration::from_secs(10);
/// How often it asks before the connection counts as lost.
const KEEPALIVE_TRIES: u32 = 3;
/// Sockets that are looked at in one iteration.
const READY_MAX: usize = 128;

/// What waits for sockets.
pub(super) struct Poll {
    epoll: OwnedFd,
}

impl Poll {
    pub(super) fn new() -> io::Result<Self> {
        Ok(Self { epoll: epoll::create(CreateFlags::CLOEXEC)? })
    }

    pub(super) fn add(&self, source: impl AsFd, token: u64, flags: EventFlags) -> io::Result<()> {
        Ok(epoll::add(&self.epoll, source, EventData::new_u64(token), flags)?)
    }

    pub(super) fn modify(&self, source: impl AsFd, token: u64, flags: EventFlags) -> io::Result<()> {
        Ok(epoll::modify(&self.epoll, source, EventData::new_u64(token), flags)?)
    }

    pub(super) fn remove(&self, source: impl AsFd) {
        // What is not there need not be removed.
        let _ = epoll::delete(&self.epoll, source);
    }

    /// Waits for sockets, but not longer than this; which are ready, for what.
    pub(super) fn wait(&self, us_max: Option<u64>, ready: &mut Vec<(u64, EventFlags)>) {
        let timeout = us_max.map(|us| Timespec { tv_sec: (us / 1_000_000) as i64, tv_nsec: (us % 1_000_000 * 1_000) as i64 });
        let mut events = [const { MaybeUninit::<Event>::uninit() }; READY_MAX];
        ready.clear();
        // A signal ends the waiting. Nothing else can go wrong with a handle of our own.
        if let Ok((events, _)) = epoll::wait(&self.epoll, &mut events, timeout.as_ref()) {
            ready.extend(events.iter().map(|event| (event.data.u64(), event.flags)));
        }
    }
}

/// Prepares a socket that has been accepted.
pub(super) fn prepare(stream: &TcpStream) -> io::Result<()> {
    stream.set_nonblocking(true)?;
    stream.set_nodelay(true)?;
    sockopt::set_socket_keepalive(stream, true)?;
    sockopt::set_tcp_keepidle(stream, KEEPALIVE_IDLE)?;
    sockopt::set_tcp_keepintvl(stream, KEEPALIVE_INTERVAL)?;
    Ok(sockopt::set_tcp_keepcnt(stream, KEEPALIVE_TRIES)?)
}

/// What came of reading a socket.
pub(super) enum Input {
    /// So many bytes.
    Bytes(usize),
    /// Nothing now.
    Nothing,
    /// The other side sends nothing any more.
    End,
    /// The connection is gone.
    Gone,
}

/// Reads what a socket has, at most one buffer.
pub(super) fn read(mut stream: &TcpStream, buffer: &mut [u8]) -> Input {
    match stream.read(buffer) {
        Ok(0) => Input::End,
        Ok(count) => Input::Bytes(count),
        Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => Input::Nothing,
        Err(_) => Input::Gone,
    }
}

/// Writes what a socket takes now; how many bytes, or `None` if the connection is gone.
pub(super) fn write(mut stream: &TcpStream, bytes: &[u8]) -> Option<usize> {
    match stream.write(bytes) {
        Ok(count) => Some(count),
        Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => Some(0),
        Err(_) => None,
    }
}

/// Whether the system has no room for another connection at the moment.
pub(super) fn has_no_room(error: &io::Error) -> bool {
    let no_room = [Errno::MFILE, Errno::NFILE, Errno::NOBUFS, Errno::NOMEM];
    Errno::from_io_error(error).is_some_and(|errno| no_room.contains(&errno))
}
