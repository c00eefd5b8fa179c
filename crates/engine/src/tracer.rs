//! Statement events: what stepping, program status and coverage read; what statements store; and accesses to the local data.

use crate::fault::Place;
use crate::machine::{Machine, Registers};

/// One executed statement.
#[derive(Clone, Debug, PartialEq)]
pub struct StatementEvent {
    /// The statement.
    pub place: Place,
    /// The registers before it.
    pub before: Registers,
    /// The registers after it.
    pub after: Registers,
}

/// Something that happens to the local data. Bytes are counted from the beginning of the area, over all blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LocalAccess {
    /// A block gets local data; the first bytes may be start information.
    Entered {
        /// The first byte.
        first: u32,
        /// How many.
        bytes: u32,
        /// How many of them have a value.
        known: u32,
    },
    /// Bytes are written.
    Written {
        /// The first byte.
        first: u32,
        /// How many.
        bytes: u32,
        /// The bits of each byte.
        mask: u8,
    },
    /// Bytes are read.
    Read {
        /// The first byte.
        first: u32,
        /// How many.
        bytes: u32,
        /// The bits of each byte.
        mask: u8,
    },
}

/// Something that is written, whether its value changes or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stored {
    /// Bytes of the arena.
    Memory {
        /// The first byte.
        first: usize,
        /// How many.
        bytes: usize,
        /// The bits of each byte.
        mask: u8,
    },
    /// Bytes of modules.
    Peripheral {
        /// The first byte.
        first: u32,
        /// How many.
        bytes: u32,
    },
    /// A timer is started, reset or enabled.
    Timer(u16),
    /// A counter counts, is set, reset or enabled.
    Counter(u16),
}

/// Someone who is told of every statement.
pub trait Tracer {
    /// A statement was executed.
    fn statement(&mut self, machine: &Machine, event: &StatementEvent);
    /// Asked before every statement whether the run pauses there ([`crate::Exit::Paused`]); the event of the statement before it has been told,
    /// and the registers of the machine are those of this moment.
    fn pauses_before(&mut self, machine: &Machine, place: Place) -> bool {
        let _ = (machine, place);
        false
    }
    /// The statement that runs, or a system function that it calls, stores something. `S` and `R` store in any case: what they read where
    /// the RLO is 0.
    fn stores(&mut self, machine: &Machine, stored: Stored) {
        let _ = (machine, stored);
    }
    /// A statement does something to the local data. What a system function does there is not told: what it is given counts as written.
    fn local_data(&mut self, machine: &Machine, place: Place, access: LocalAccess) {
        let _ = (machine, place, access);
    }
}
