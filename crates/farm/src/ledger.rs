//! What a run knows, and what it is told.

use std::ops::Range;

/// What a campaign is to its workers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Announced {
    /// The identity of the campaign, hexadecimal digits.
    pub campaign: String,
    /// The version of what code means; a worker of another one refuses the campaign.
    pub meaning: u32,
    /// What a worker needs to run any scenario of it.
    pub bundle: Vec<u8>,
}

/// What a result was to the ledger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Came {
    /// It is new, and written down.
    New,
    /// The same bytes had come before.
    Same,
    /// Other bytes had come before: a scenario is not deterministic, or a worker lies.
    Other,
    /// It is no result, or none of these numbers.
    Unreadable,
}

/// What the run knows: the ledger is the truth, the queue is a hint.
pub trait Ledger {
    /// The next range that was never sent; `None` if there is none for now.
    fn next(&mut self) -> Option<Range<u64>>;
    /// What was sent, and has no result.
    fn missing(&mut self) -> Vec<Range<u64>>;
    /// Takes the result of a range, and keeps what it says is new: the server does not.
    ///
    /// The range may be a part of one that was sent, because a worker splits what comes to it for the third time.
    /// What the ledger does not take stays missing, and is sent again.
    fn came(&mut self, range: Range<u64>, result: &[u8]) -> Came;
    /// Whether every result is there.
    fn is_whole(&self) -> bool;
    /// Whether the run is to end as it is.
    fn is_over(&self) -> bool;
}

/// A result that differs from one that came before for the same range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alarm {
    /// The range.
    pub range: Range<u64>,
    /// The worker that sent the second result.
    pub worker: String,
}

/// Most alarms that are kept; all are counted.
pub(crate) const ALARMS_MAX: usize = 100;

/// What a run came to.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Finished {
    /// Results that were new.
    pub results: u64,
    /// Results that came once more, with the same bytes.
    pub duplicates: u64,
    /// Results that differ from those before; the first hundred of them.
    pub alarms: Vec<Alarm>,
    /// How many differ.
    pub differing: u64,
    /// Messages that are no results, or none of this campaign.
    pub unreadable: u64,
    /// Ranges that were sent more than once.
    pub sent_again: u64,
    /// How often the streams of the server were made again after their store was lost.
    pub rebuilt: u32,
    /// Scenarios that were given up because workers died of them.
    pub given_up: u64,
    /// Whether the streams of the campaign were removed from the server.
    pub is_removed: bool,
}
