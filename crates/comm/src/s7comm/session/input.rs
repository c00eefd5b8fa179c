//! What has come from one client: whole messages out of a stream of bytes.

use crate::s7comm::wire::cotp::{self, ConnectRequest, Part, Partner, Tpdu};
use crate::s7comm::wire::{Broken, tpkt};

/// Bytes of the fragments of one message together.
const MESSAGE_BYTES_MAX: usize = 65_536;
/// Bytes that may wait to be looked at: a whole frame and what a server reads at a time.
const INPUT_BYTES_MAX: usize = 196_608;
/// How long a frame, or a message in fragments, may take from its first byte on, in microseconds.
const FRAME_US_MAX: u64 = 10_000_000;

/// What has come and was not looked at yet.
#[derive(Debug, Default)]
pub(super) struct Input {
    bytes: Vec<u8>,
    looked_at: usize,
    /// Fragments of a message that is not complete.
    fragments: Option<Vec<u8>>,
    /// Since when something is incomplete.
    since_us: Option<u64>,
    /// Nothing is looked at until there is room for what comes of it.
    pub(super) waits: bool,
}

/// What a client has sent.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Arrived {
    /// It opens the connection.
    Connect { source: u16, confirmed: Vec<u8>, tpdu_bytes: usize, rack_and_slot: Option<(u8, u8)>, partner: Partner },
    /// It closes the connection.
    Disconnect { source: u16 },
    /// A message of S7.
    Message(Vec<u8>),
}

impl Input {
    /// Takes bytes.
    ///
    /// # Errors
    /// So many wait that the server should not have read any more.
    pub(super) fn take(&mut self, bytes: &[u8]) -> Result<(), Broken> {
        self.bytes.drain(..self.looked_at);
        self.looked_at = 0;
        if self.bytes.len().saturating_add(bytes.len()) > INPUT_BYTES_MAX {
            return Err(Broken);
        }
        self.bytes.extend_from_slice(bytes);
        Ok(())
    }

    /// The next thing that has come whole.
    ///
    /// # Errors
    /// What came is not this protocol.
    pub(super) fn next(&mut self, now_us: u64) -> Result<Option<Arrived>, Broken> {
        self.waits = false;
        loop {
            let Some((tpdu, length)) = tpkt::split(self.bytes.get(self.looked_at..).unwrap_or(&[]))? else {
                let incomplete = self.looked_at < self.bytes.len() || self.fragments.is_some();
                self.since_us = if incomplete { Some(self.since_us.unwrap_or(now_us)) } else { None };
                return Ok(None);
            };
            let arrived = match cotp::read(tpdu)? {
                Tpdu::ConnectRequest(request) => Some(connect(&request)),
                Tpdu::DisconnectRequest { source } => Some(Arrived::Disconnect { source }),
                Tpdu::Data { part, payload } => {
                    let so_far = self.fragments.as_ref().map_or(0, Vec::len);
                    if so_far + payload.len() > MESSAGE_BYTES_MAX {
                        return Err(Broken);
                    }
                    match (part, self.fragments.take()) {
                        // Old CPUs confirm like this, and some peers too.
                        (Part::Last, None) if payload.is_empty() => None,
                        (Part::Last, None) => Some(Arrived::Message(payload.to_vec())),
                        (part, fragments) => {
                            let mut fragments = fragments.unwrap_or_default();
                            fragments.extend_from_slice(payload);
                            match part {
                                Part::Last => Some(Arrived::Message(fragments)),
                                Part::More => {
                                    self.fragments = Some(fragments);
                                    self.since_us.get_or_insert(now_us);
                                    None
                                }
                            }
                        }
                    }
                }
            };
            self.looked_at += length;
            if arrived.is_some() {
                self.since_us = None;
                return Ok(arrived);
            }
        }
    }

    /// Nothing is looked at for now: the client cannot be blamed for what is incomplete.
    pub(super) fn wait(&mut self) {
        self.since_us = None;
        self.waits = true;
    }

    /// When the client has had time enough for what it has begun.
    pub(super) fn given_up_us(&self) -> Option<u64> {
        self.since_us.map(|since| since.saturating_add(FRAME_US_MAX))
    }
}

fn connect(request: &ConnectRequest<'_>) -> Arrived {
    let mut confirmed = Vec::new();
    cotp::connect_confirm(&mut confirmed, request);
    Arrived::Connect {
        source: request.source,
        confirmed,
        tpdu_bytes: request.tpdu_bytes(),
        rack_and_slot: request.rack_and_slot(),
        partner: request.partner(),
    }
}
