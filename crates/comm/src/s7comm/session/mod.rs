//! The state of one connection, without I/O: bytes come in, bytes go out, time is an argument.

mod events;
mod shared;

use std::net::SocketAddr;
use std::sync::Arc;

use sieben_workspace::gate::Plant;

use super::guard::Rules;
pub use events::{Event, What};
pub use shared::{Requests, Shared};

/// How long a job may take that needs several entries of the gate, in microseconds; then it is refused.
pub const PENDING_US_MAX: u64 = 3_000_000;

/// One connection.
#[derive(Debug)]
pub struct Session {
    rules: Arc<Rules>,
    peer: SocketAddr,
}

impl Session {
    /// A connection that has just been accepted.
    pub fn new(rules: Arc<Rules>, peer: SocketAddr, now_us: u64) -> Self {
        let _ = now_us;
        Self { rules, peer }
    }

    /// Who is on the other side.
    pub fn peer(&self) -> SocketAddr {
        self.peer
    }

    /// Takes bytes that came. Jobs that need the CPU wait for [`Self::serve`], everything else is answered.
    pub fn receive(&mut self, bytes: &[u8], shared: &mut Shared, now_us: u64) {
        let _ = (bytes, shared, now_us, &self.rules);
    }

    /// Whether jobs wait for an entry of the gate.
    pub fn wants_in(&self) -> bool {
        false
    }

    /// Does one job at the cycle control point; whether it was one. Sessions that want in take turns within one entry of the gate.
    pub fn serve(&mut self, plant: &mut Plant, shared: &mut Shared, now_us: u64) -> bool {
        let _ = (plant, shared, now_us);
        false
    }

    /// Bytes that wait to be sent: whole frames, each of which should go out in one piece.
    pub fn output(&self) -> &[u8] {
        &[]
    }

    /// So many bytes of the output have been sent.
    pub fn sent(&mut self, bytes: usize, now_us: u64) {
        let _ = (bytes, now_us);
    }

    /// Whether more bytes may come in: too much output, or too many jobs, and the other side has to wait.
    pub fn reads(&self) -> bool {
        true
    }

    /// When [`Self::tick`] is due, if it is.
    pub fn wake_us(&self) -> Option<u64> {
        None
    }

    /// Looks at the time: deadlines, answers that were held back, jobs that take longer.
    pub fn tick(&mut self, shared: &mut Shared, now_us: u64) {
        let _ = (shared, now_us);
    }

    /// Whether the connection is to be closed, as soon as its output has been sent: in order, never by a reset.
    pub fn is_over(&self) -> bool {
        false
    }
}
