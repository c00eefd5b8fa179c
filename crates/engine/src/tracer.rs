//! Statement events: what stepping, program status and coverage read.

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

/// Someone who is told of every statement.
pub trait Tracer {
    /// A statement was executed.
    fn statement(&mut self, machine: &Machine, event: &StatementEvent);
}
