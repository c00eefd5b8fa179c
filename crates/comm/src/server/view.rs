//! What a server says about itself: its connections, and what it has counted.

use std::net::SocketAddr;

use crate::s7comm::guard::Function;
use crate::s7comm::session::Requests;
use crate::s7comm::wire::cotp::Partner;

/// What a server says about itself.
#[derive(Clone, Debug, Default)]
pub struct View {
    /// Those who are connected, in the order in which they came.
    pub connections: Vec<ConnectionView>,
    /// What it has counted.
    pub counters: Counters,
}

/// A variable that a client has written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// Its address as it is spelled in STL, `IW 0`; of more than a double word as a pointer, `P#I0.0 BYTE 6`.
    pub address: String,
    /// What was written, the first bytes of it.
    pub bytes: Vec<u8>,
    /// How many scans had ended.
    pub scan: u64,
    /// The time of the CPU in microseconds.
    pub time_us: u64,
}

/// A connection.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConnectionView {
    /// Its number: connections are counted from 1.
    pub number: u64,
    /// Who is on the other side.
    pub peer: SocketAddr,
    /// When it came, in microseconds of the gate's clock.
    pub since_us: u64,
    /// What is on the other side; `None` before it has said so.
    pub partner: Option<Partner>,
    /// What it asked for last.
    pub last: Option<Function>,
    /// How often it has read variables.
    pub reads: u64,
    /// How often it has written variables.
    pub writes: u64,
    /// What it wrote last.
    pub written: Option<Written>,
    /// How long its PDUs are; `None` before the setup.
    pub pdu_bytes: Option<usize>,
    /// When bytes came last, in microseconds of the gate's clock.
    pub heard_us: u64,
    /// Bytes that came.
    pub bytes_in: u64,
    /// Bytes that were sent.
    pub bytes_out: u64,
}

/// What a server has counted since it began.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Connections that were accepted.
    pub connections: u64,
    /// Connections that were refused because of a limit.
    pub refused: u64,
    /// Requests by function.
    pub requests: Requests,
    /// Jobs that were done at the gate.
    pub jobs: u64,
    /// Entries of the gate.
    pub entries: u64,
    /// Bytes that came.
    pub bytes_in: u64,
    /// Bytes that were sent.
    pub bytes_out: u64,
    /// Records of the audit log that were lost.
    pub audit_lost: u64,
    /// Recorded frames that were lost.
    pub frames_lost: u64,
}
