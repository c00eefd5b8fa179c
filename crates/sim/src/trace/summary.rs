//! How much a trace holds: counted while it is written, and again while it is read.

use super::{Moment, Scans};

/// What a trace holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// Scans that were recorded.
    pub scans: u64,
    /// The first of them; all 0 if there is none.
    pub first: Moment,
    /// The last of them.
    pub last: Moment,
    /// The time that every distance of two scans is a multiple of, in microseconds; 0 if time stood still.
    pub step_us: u64,
    /// Whether two scans began at the same time.
    pub stood_still: bool,
    /// How often each channel has changed.
    pub changes: Vec<u64>,
}

impl Summary {
    pub(super) fn new(channels: usize) -> Self {
        let zero = Moment { scan: 0, time_us: 0 };
        Self { scans: 0, first: zero, last: zero, step_us: 0, stood_still: false, changes: vec![0; channels] }
    }

    /// Counts scans that come next.
    pub(super) fn add(&mut self, scans: &Scans<'_>) {
        if self.scans == 0 {
            self.first = scans.first;
        } else {
            self.distance(scans.first.time_us.saturating_sub(self.last.time_us));
            for &channel in scans.changed {
                self.changes[channel] += 1;
            }
        }
        if scans.count > 1 {
            self.distance(scans.step_us);
        }
        self.scans += scans.count;
        self.last = scans.last();
    }

    fn distance(&mut self, us: u64) {
        self.stood_still |= us == 0;
        self.step_us = common_divisor(self.step_us, us);
    }
}

/// The greatest common divisor; that of 0 and a number is the number.
fn common_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
