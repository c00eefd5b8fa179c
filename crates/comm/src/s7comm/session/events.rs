//! What the audit log says about a connection.

use std::net::SocketAddr;

use sieben_cpu::Restart;

use crate::s7comm::job::{BlockName, Variable};

/// Something that was done or tried.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// Who.
    pub peer: SocketAddr,
    /// The reference of the job.
    pub pdu_reference: u16,
    /// How many scans had ended, if it was done at the gate.
    pub scan: Option<u64>,
    /// What.
    pub what: What,
    /// The error code that was answered; 16#0000 if it was done. Of a variable it is the code of the item.
    pub error: u16,
}

/// What was done or tried.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// The connection was set up, with PDUs of so many bytes.
    Setup(u16),
    /// A variable was written.
    Write(Variable, Box<[u8]>),
    /// The clock was set.
    SetClock,
    /// STOP.
    Stop,
    /// A start.
    Start(Restart),
    /// Copy RAM to ROM.
    CopyRamToRom,
    /// Compressing the memory.
    Compress,
    /// Memory reset.
    MemoryReset,
    /// An upload.
    Upload(BlockName),
    /// A download.
    Download(BlockName),
    /// A block was linked.
    Link(BlockName),
    /// A block was deleted.
    Delete(BlockName),
    /// A password was entered.
    Password,
    /// The password was taken back.
    PasswordCleared,
}
