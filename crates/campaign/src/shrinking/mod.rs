//! Makes a scenario that breaks a property smaller, as long as it breaks the same one in the same way.

mod passes;
mod rank;
#[cfg(test)]
mod tests;

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use sieben_sim::scenario::PlantLine;
use sieben_sim::scenario::changing::Timed;
use sieben_sim::trace::Moment;
use sieben_sim::wrap::Fault;

use crate::disturbed::{Replayed, is_in_order};
use rank::Rank;

/// Candidates in a row that bring nothing, after which it ends.
pub const STALL_MAX: u32 = 200;
/// Runs after which it ends.
pub const RUNS_MAX: u32 = 5_000;

/// A scenario as what can be made smaller of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// From one scan to the next, in microseconds.
    pub cycle_us: u64,
    /// How many scans.
    pub scans: u64,
    /// The plants with their seeds and parameters; what is not said is as in the project.
    pub plants: Vec<PlantLine>,
    /// Values before the first scan.
    pub set: Vec<SetValue>,
    /// Values that come from outside, in the order of their times.
    pub at: Vec<Timed>,
    /// The inputs of the recording that it replays, name by name; each of them comes, as it was recorded or disturbed.
    pub replayed: Vec<Replayed>,
    /// How signals of plants fail.
    pub faults: Vec<Fault>,
}

/// A value before the first scan.
#[derive(Clone, Debug, PartialEq)]
pub struct SetValue {
    /// The name as it is written.
    pub name: String,
    /// The value as it is written.
    pub value: String,
    /// What may become of it.
    pub freedom: Freedom,
}

/// What may become of a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Freedom {
    /// It stays: the file of the campaign says so.
    Fixed,
    /// It may go: the program has a value of its own then.
    Optional,
    /// It may become this.
    Usual(String),
}

/// How a case breaks.
#[derive(Clone, Debug, PartialEq)]
pub struct Break {
    /// What has to stay the same: the property, and the statement that wrote what it says last.
    pub signature: Signature,
    /// After which scan.
    pub at: Moment,
}

/// What tells one way to fail from another one.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Signature {
    /// The name of the property, or what else went wrong.
    pub what: String,
    /// The statement that wrote what the property says last: its block and number.
    pub place: Option<String>,
}

/// What became of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Shrunk {
    /// The smallest case that was found.
    pub case: Case,
    /// Where it breaks.
    pub at: Moment,
    /// How many cases were run.
    pub runs: u32,
}

/// Makes a case smaller that breaks so; `breaks` runs one, and `is_over` ends it before its time.
pub fn shrink(case: Case, broken: Break, breaks: &mut dyn FnMut(&Case) -> Option<Break>, is_over: &dyn Fn() -> bool) -> Shrunk {
    let rank = Rank::of(&case, broken.at);
    let Break { signature, at } = broken;
    let mut shrinker = Shrinker { case, at, rank, signature, breaks, is_over, tried: HashSet::new(), runs: 0, stall: 0 };
    loop {
        let before = shrinker.rank.clone();
        shrinker.all_passes();
        if shrinker.rank == before || shrinker.is_done() {
            break;
        }
    }
    Shrunk { case: shrinker.case, at: shrinker.at, runs: shrinker.runs }
}

struct Shrinker<'a> {
    /// The smallest case so far, where it breaks, and its rank.
    case: Case,
    at: Moment,
    rank: Rank,
    signature: Signature,
    breaks: &'a mut dyn FnMut(&Case) -> Option<Break>,
    is_over: &'a dyn Fn() -> bool,
    tried: HashSet<u64>,
    runs: u32,
    stall: u32,
}

impl Shrinker<'_> {
    fn is_done(&self) -> bool {
        self.runs >= RUNS_MAX || self.stall >= STALL_MAX || (self.is_over)()
    }

    /// Runs a candidate; it is taken if it is smaller and breaks in the same way.
    fn attempt(&mut self, candidate: Case) -> bool {
        let mut hasher = DefaultHasher::new();
        format!("{candidate:?}").hash(&mut hasher);
        if self.is_done() || candidate == self.case || !is_in_order(&candidate.replayed) || !self.tried.insert(hasher.finish()) {
            return false;
        }
        self.runs += 1;
        self.stall += 1;
        let Some(broken) = (self.breaks)(&candidate).filter(|broken| broken.signature == self.signature) else { return false };
        let rank = Rank::of(&candidate, broken.at);
        let is_smaller = rank < self.rank;
        if is_smaller {
            (self.case, self.at, self.rank, self.stall) = (candidate, broken.at, rank, 0);
        }
        is_smaller
    }

    /// Runs what a change makes of the case.
    fn attempt_with(&mut self, change: impl FnOnce(&mut Case)) -> bool {
        let mut candidate = self.case.clone();
        change(&mut candidate);
        self.attempt(candidate)
    }
}
