//! What the audit log says about a connection.

use std::net::SocketAddr;

use sieben_cpu::Restart;

use crate::s7comm::job::{BlockName, Job, Reply, Variable};
use crate::s7comm::wire::codes::ItemCode;

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

/// Adds what a job has done, or tried.
pub(super) fn of(peer: SocketAddr, pdu_reference: u16, scan: Option<u64>, job: &Job, reply: &Reply, events: &mut Vec<Event>) {
    let error = match reply {
        Reply::Refused(refusal) => refusal.code(),
        Reply::Already => crate::s7comm::wire::codes::Refusal::CannotPerform.code(),
        _ => 0,
    };
    let mut add = |what, error| events.push(Event { peer, pdu_reference, scan, what, error });
    match job {
        Job::Write(assignments) => {
            let codes = if let Reply::Written(codes) = reply { codes.as_slice() } else { &[] };
            for (index, assignment) in assignments.iter().enumerate() {
                let Ok(assignment) = assignment else { continue };
                let error = match codes.get(index) {
                    Some(ItemCode::Done) => 0,
                    Some(code) => u16::from(code.code()),
                    None => error,
                };
                add(What::Write(assignment.variable, assignment.bytes.clone()), error);
            }
        }
        Job::SetClock(_) => add(What::SetClock, error),
        Job::Stop => add(What::Stop, error),
        Job::Start(restart) => add(What::Start(*restart), error),
        Job::CopyRamToRom => add(What::CopyRamToRom, error),
        Job::Compress => add(What::Compress, error),
        Job::MemoryReset => add(What::MemoryReset, error),
        Job::Upload(name) => add(What::Upload(*name), error),
        Job::Download(download) => add(What::Download(download.name), error),
        Job::Link(names) => names.iter().for_each(|name| add(What::Link(*name), error)),
        Job::Delete(names) => names.iter().for_each(|name| add(What::Delete(*name), error)),
        Job::Read(_) | Job::SystemStatus { .. } | Job::Clock | Job::BlockCounts | Job::BlockList(_) | Job::BlockInfo(_) => {}
    }
}

/// Adds the writes that the rules have refused: `judged` is what is left of `asked`.
pub(super) fn refused_items(peer: SocketAddr, pdu_reference: u16, asked: &Job, judged: &Job, events: &mut Vec<Event>) {
    let (Job::Write(asked), Job::Write(judged)) = (asked, judged) else { return };
    for (asked, judged) in asked.iter().zip(judged) {
        if let (Ok(asked), Err(code)) = (asked, judged) {
            let what = What::Write(asked.variable, asked.bytes.clone());
            events.push(Event { peer, pdu_reference, scan: None, what, error: u16::from(code.code()) });
        }
    }
}
