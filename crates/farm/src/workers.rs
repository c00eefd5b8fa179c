//! Who works for a run, by what is heard of them.

use std::collections::HashMap;
use std::time::{Duration, Instant};

/// Most workers that are counted; more of them work, too.
const WORKERS_MAX: usize = 100_000;

/// Beats of silence after which a worker is no longer counted.
const SILENCE: u32 = 10;

/// Who works for a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Workers {
    /// Processes that were heard of in the last ten beats.
    pub alive: usize,
    /// Their threads.
    pub threads: u64,
    /// Whether the server is connected.
    pub is_connected: bool,
    /// Ranges that were sent, and have no result.
    pub under_way: usize,
    /// Results that differ from those before: an alarm.
    pub differing: u64,
}

/// What was heard of each worker.
#[derive(Debug, Default)]
pub(crate) struct Heard {
    workers: HashMap<String, (Instant, u64)>,
}

impl Heard {
    pub(crate) fn hears(&mut self, name: &str, threads: u64, now: Instant) {
        if self.workers.len() < WORKERS_MAX || self.workers.contains_key(name) {
            self.workers.insert(name.to_owned(), (now, threads.min(65_536)));
        }
    }

    /// How many there are now, and their threads.
    pub(crate) fn count(&mut self, beat: Duration, now: Instant) -> (usize, u64) {
        self.workers.retain(|_, (heard, _)| now.duration_since(*heard) <= beat * SILENCE);
        (self.workers.len(), self.workers.values().map(|(_, threads)| threads).sum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_silent_worker_is_not_counted() {
        let (mut heard, begun, beat) = (Heard::default(), Instant::now(), Duration::from_secs(1));
        heard.hears("a", 4, begun);
        heard.hears("b", 2, begun + Duration::from_secs(8));
        assert_eq!(heard.count(beat, begun + Duration::from_secs(9)), (2, 6));
        assert_eq!(heard.count(beat, begun + Duration::from_secs(11)), (1, 2));
    }
}
