//! A connection of a server, and one that is being closed.

use std::net::{SocketAddr, TcpStream};

use rustix::event::epoll::EventFlags;

use super::sockets::{self, Input};
use super::view::{ConnectionView, Written};
use crate::recording::frames::Flow;
use crate::s7comm::guard::Function;
use crate::s7comm::session::Session;

/// A connection.
pub(super) struct Connection {
    pub(super) number: u64,
    pub(super) stream: TcpStream,
    pub(super) peer: SocketAddr,
    pub(super) session: Session,
    /// What the socket is waited for.
    pub(super) waits_for: EventFlags,
    /// The other side sends nothing any more.
    pub(super) has_ended: bool,
    /// The connection is lost.
    pub(super) is_gone: bool,
    /// When it came.
    pub(super) since_us: u64,
    /// When bytes came last.
    pub(super) heard_us: u64,
    /// What it asked for last.
    pub(super) last: Option<Function>,
    /// How often it has read and written variables.
    pub(super) reads: u64,
    pub(super) writes: u64,
    /// What it wrote last.
    pub(super) written: Option<Written>,
    pub(super) bytes_in: u64,
    pub(super) bytes_out: u64,
    /// What it is in the recording.
    pub(super) flow: Option<Flow>,
}

impl Connection {
    /// What the socket has to be waited for.
    pub(super) fn wants(&self) -> EventFlags {
        let mut wants = EventFlags::empty();
        if !self.has_ended && !self.session.is_over() && self.session.reads() {
            wants |= EventFlags::IN;
        }
        if !self.session.output().is_empty() {
            wants |= EventFlags::OUT;
        }
        wants
    }

    /// Whether nothing more is to be done but closing it.
    pub(super) fn is_done(&self) -> bool {
        let says_nothing = self.session.output().is_empty();
        let is_over = self.is_gone || says_nothing && (self.session.is_over() || self.has_ended && self.session.is_idle());
        is_over && !self.session.has_begun()
    }

    /// What is said about it.
    pub(super) fn view(&self) -> ConnectionView {
        ConnectionView {
            number: self.number,
            peer: self.peer,
            since_us: self.since_us,
            partner: self.session.partner(),
            last: self.last,
            reads: self.reads,
            writes: self.writes,
            written: self.written.clone(),
            pdu_bytes: self.session.pdu_bytes(),
            heard_us: self.heard_us,
            bytes_in: self.bytes_in,
            bytes_out: self.bytes_out,
        }
    }
}

/// A connection that is being closed: nothing is sent any more, and what still comes is read, so that the other side sees an end and no reset.
pub(super) struct Closing {
    pub(super) stream: TcpStream,
    /// Until when.
    pub(super) until_us: u64,
}

/// Reads of one closing socket in a row.
const READS_MAX: usize = 64;

impl Closing {
    /// Reads what has come; whether it can be closed.
    pub(super) fn drain(&self, buffer: &mut [u8]) -> bool {
        for _ in 0..READS_MAX {
            match sockets::read(&self.stream, buffer) {
                Input::Bytes(_) => {}
                Input::Nothing => return false,
                Input::End | Input::Gone => return true,
            }
        }
        false
    }
}
