//! What came of a range of scenarios: what all of them came to, and the rows that are kept.

use std::ops::Range;

use crate::row::{Row, Verdict};
use crate::spec::{Keep, Spec};
use crate::tally::Tally;

/// Up to so many scenarios all rows are kept where the file says nothing.
pub const ALL_MAX: u64 = 1_000_000;
/// Rows of scenarios that did not pass, where only those are kept.
pub const FAILURES_MAX: usize = 10_000;

/// Which rows of a campaign with so many scenarios are kept.
pub fn keep(spec: &Spec, scenarios: u64) -> Keep {
    spec.keep.unwrap_or(if scenarios <= ALL_MAX { Keep::All } else { Keep::Failures })
}

/// What came of a range.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The numbers of the scenarios.
    pub range: Range<u64>,
    /// What they came to.
    pub tally: Tally,
    /// Rows that are kept, in the order of their numbers.
    pub rows: Vec<Row>,
}

impl Part {
    /// Of a range that begins at a number and has no scenario yet.
    pub fn new(spec: &Spec, start: u64) -> Self {
        Self { range: start..start, tally: Tally::new(spec), rows: Vec::new() }
    }

    /// Takes the next scenario in.
    pub fn add(&mut self, row: Row, keep: Keep) {
        self.range.end = row.scenario + 1;
        self.tally.add(&row);
        if keep == Keep::All || (row.verdict != Verdict::Pass && self.rows.len() < FAILURES_MAX) {
            self.rows.push(row);
        }
    }

    /// The first scenario that did not pass: its row is always kept.
    pub fn first(&self) -> Option<&Row> {
        self.rows.iter().find(|row| row.verdict != Verdict::Pass)
    }
}
