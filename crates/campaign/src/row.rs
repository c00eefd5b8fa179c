//! What came of one scenario.

use sieben_sim::trace::Moment;

use crate::spec::Value;

/// How a scenario ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// All properties held.
    Pass,
    /// A property did not hold.
    Fail,
    /// The CPU went to STOP.
    Stop,
    /// It did not end within its limit.
    Limit,
    /// It could not be run or judged.
    Error,
}

impl Verdict {
    /// All of them, each at the place of its number.
    pub const ALL: [Self; 5] = [Self::Pass, Self::Fail, Self::Stop, Self::Limit, Self::Error];

    /// The word of results.
    pub fn word(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fail => "fail",
            Self::Stop => "stop",
            Self::Limit => "limit",
            Self::Error => "error",
        }
    }
}

/// What came of one scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number.
    pub scenario: u64,
    /// Its seed.
    pub seed: u64,
    /// How it ended.
    pub verdict: Verdict,
    /// The property that broke, by its place in the file.
    pub property: Option<usize>,
    /// Where it ended before its time.
    pub at: Option<Moment>,
    /// Scans that were run.
    pub scans: u64,
    /// Virtual time of the last one, in microseconds.
    pub virtual_us: u64,
    /// How near a property came to its break, in the unit of what it compares; below 0 it is broken.
    pub margin: Option<f64>,
    /// 64 bits over the outputs that changed, with their scans.
    pub trace_hash: u64,
    /// What was swept and drawn once, in the order of the file.
    pub parameters: Vec<Value>,
    /// How the signals of plants failed, in the order of the rows of the file: `drift=0.2@61.3s..80s`.
    pub faults: Vec<Option<String>>,
    /// What was measured, in the order of the file.
    pub measures: Vec<Option<f64>>,
    /// Of each property whether it was true at least once, where that is asked.
    pub came: Vec<bool>,
    /// What is to be said about a STOP or an error.
    pub message: Option<String>,
}

impl Row {
    /// What came of it, as numbers.
    pub fn parts(&self) -> impl Iterator<Item = u64> {
        let ended = [self.scenario, self.seed, self.verdict as u64, self.property.map_or(0, |property| property as u64 + 1)];
        let measures = self.measures.iter().map(|measure| measure.map_or(u64::MAX, f64::to_bits));
        ended
            .into_iter()
            .chain([self.scans, self.virtual_us, self.margin.map_or(u64::MAX, f64::to_bits), self.trace_hash])
            .chain(measures)
            .chain(self.came.iter().map(|&came| u64::from(came)))
    }
}
