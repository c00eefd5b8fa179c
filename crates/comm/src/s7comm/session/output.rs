//! What waits to be sent to one client.

use crate::s7comm::wire::cotp::{self, DATA_HEAD, Part};
use crate::s7comm::wire::tpkt;

/// Bytes that may wait for a client; with more than half of it nothing more is read from it.
const OUTPUT_BYTES_MAX: usize = 65_536;
/// A client that takes nothing for so long is given up, in microseconds.
const STALLED_US_MAX: u64 = 10_000_000;

/// Frames that wait to be sent.
#[derive(Debug, Default)]
pub(super) struct Output {
    bytes: Vec<u8>,
    sent: usize,
    /// Since when bytes wait that the client does not take.
    since_us: Option<u64>,
}

impl Output {
    /// What waits.
    pub(super) fn waiting(&self) -> &[u8] {
        self.bytes.get(self.sent..).unwrap_or(&[])
    }

    /// Whether there is so much of it that the client has to wait.
    pub(super) fn is_full(&self) -> bool {
        self.waiting().len() > OUTPUT_BYTES_MAX / 2
    }

    /// So many bytes have gone.
    pub(super) fn sent(&mut self, bytes: usize, now_us: u64) {
        self.sent = self.sent.saturating_add(bytes).min(self.bytes.len());
        if self.sent == self.bytes.len() {
            self.bytes.clear();
            self.sent = 0;
            self.since_us = None;
        } else if bytes > 0 {
            self.since_us = Some(now_us);
        }
    }

    /// When the client is given up.
    pub(super) fn given_up_us(&self) -> Option<u64> {
        self.since_us.map(|since| since.saturating_add(STALLED_US_MAX))
    }

    /// Adds a TPDU that opens or closes the connection.
    pub(super) fn control(&mut self, now_us: u64, write: impl FnOnce(&mut Vec<u8>)) {
        self.begin(now_us);
        tpkt::frame(&mut self.bytes, write);
    }

    /// Adds a message, in fragments if it is longer than a TPDU.
    pub(super) fn message(&mut self, now_us: u64, message: &[u8], tpdu_bytes: usize) {
        self.begin(now_us);
        let mut parts = message.chunks(tpdu_bytes.saturating_sub(DATA_HEAD).max(1)).peekable();
        while let Some(chunk) = parts.next() {
            tpkt::frame(&mut self.bytes, |out| {
                cotp::data_head(out, if parts.peek().is_some() { Part::More } else { Part::Last });
                out.extend_from_slice(chunk);
            });
        }
    }

    fn begin(&mut self, now_us: u64) {
        if self.sent > 0 {
            self.bytes.drain(..self.sent);
            self.sent = 0;
        }
        self.since_us.get_or_insert(now_us);
    }
}
