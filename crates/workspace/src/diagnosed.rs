//! In which scan each entry of the diagnostic buffer came: the CPU itself keeps the time of day alone.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::gate::Plant;

/// Scans with entries that are kept: no buffer of a CPU has more entries.
const SCANS_MAX: usize = 1_024;

/// Entries that came in or after the same scan.
#[derive(Clone, Copy, Debug)]
struct Came {
    /// The number of the last one.
    up_to: u64,
    scan: u64,
}

/// The scans of the newest entries.
#[derive(Debug, Default)]
pub struct Diagnosed {
    /// The number of the newest entry whose scan is known.
    newest: AtomicU64,
    came: Mutex<VecDeque<Came>>,
}

impl Diagnosed {
    /// What has come since the last call came in this scan, or after it and before the next one.
    pub(crate) fn note(&self, plant: &Plant, scan: u64) {
        self.note_number(plant.cpu.diagnostic_buffer().newest_number(), scan);
    }

    /// Another CPU runs from now on, with a buffer of its own.
    pub(crate) fn reset(&self) {
        self.came.lock().unwrap_or_else(PoisonError::into_inner).clear();
        self.newest.store(0, Ordering::Relaxed);
    }

    fn note_number(&self, up_to: u64, scan: u64) {
        let known = self.newest.swap(up_to, Ordering::Relaxed);
        if known == up_to {
            return;
        }
        let mut came = self.came.lock().unwrap_or_else(PoisonError::into_inner);
        if known > up_to {
            came.clear();
        }
        if came.len() >= SCANS_MAX {
            came.pop_front();
        }
        came.push_back(Came { up_to, scan });
    }

    /// The scan of an entry with this number; `None` if it came before the scans were noted, or is not noted yet.
    pub fn scan(&self, number: u64) -> Option<u64> {
        let came = self.came.lock().unwrap_or_else(PoisonError::into_inner);
        let at = came.partition_point(|came| came.up_to < number);
        // Before the oldest one that is kept there may have been others.
        let is_known = at > 0 || came.len() < SCANS_MAX;
        came.get(at).filter(|_| is_known).map(|came| came.scan)
    }

    /// The number of the newest entry whose scan is noted.
    pub fn newest(&self) -> u64 {
        self.newest.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_entry_has_the_scan_in_which_it_came() {
        let diagnosed = Diagnosed::default();
        for (up_to, scan) in [(0, 0), (3, 0), (3, 1), (4, 7), (9, 8)] {
            diagnosed.note_number(up_to, scan);
        }
        let scans: Vec<Option<u64>> = (1..=10).map(|number| diagnosed.scan(number)).collect();
        assert_eq!(scans, [0, 0, 0, 7, 8, 8, 8, 8, 8].map(Some).into_iter().chain([None]).collect::<Vec<_>>());
        for number in 10..2_000 {
            diagnosed.note_number(number, number);
        }
        assert_eq!(
            (diagnosed.scan(3), diagnosed.scan(1_999), diagnosed.scan(2_000)),
            (None, Some(1_999), None),
            "the oldest are forgotten"
        );
        diagnosed.note_number(2, 5_000);
        assert_eq!((diagnosed.scan(2), diagnosed.newest()), (Some(5_000), 2), "another CPU counts from 0 again");
    }
}
