//! What all sessions of a server share.

use crate::s7comm::answer::Surroundings;
use crate::s7comm::guard::Function;

use super::Event;
use super::passwords::WrongPasswords;

/// What all sessions of a server share. One thread has it.
#[derive(Debug, Default)]
pub struct Shared {
    /// What the answers need.
    pub around: Surroundings,
    /// What the audit log has to say; the server takes it out after each call.
    pub events: Vec<Event>,
    /// The addresses that wrong passwords came from.
    pub passwords: WrongPasswords,
    /// How often each function was asked for.
    pub requests: Requests,
}

/// How often each function was asked for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Requests {
    counts: [u64; Function::COUNT],
    last: Option<Function>,
}

impl Requests {
    /// Counts a request.
    pub fn count(&mut self, function: Function) {
        if let Some(count) = self.counts.get_mut(function as usize) {
            *count = count.saturating_add(1);
        }
        self.last = Some(function);
    }

    /// How often a function was asked for.
    pub fn of(&self, function: Function) -> u64 {
        self.counts.get(function as usize).copied().unwrap_or(0)
    }

    /// The function that was asked for last, if any was since this was asked.
    pub fn take_last(&mut self) -> Option<Function> {
        self.last.take()
    }
}
