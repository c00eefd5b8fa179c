//! How long organization blocks run: what SFC 78 tells.

use std::collections::BTreeMap;

/// The last complete run of a block, in microseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct LastRun {
    /// From its start to its end, interruptions included.
    pub(crate) run_us: u64,
    /// From the event to its end.
    pub(crate) elapsed_us: u64,
}

/// A block that runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Running {
    pub(crate) number: u16,
    /// Blocks on the stack below it.
    depth: usize,
    /// When the event came, in microseconds.
    pub(crate) requested_us: u64,
    /// When it started.
    pub(crate) started_us: u64,
}

/// Run times of all organization blocks.
#[derive(Clone, Debug, Default)]
pub(crate) struct RunTimes {
    last: BTreeMap<u16, LastRun>,
    running: Vec<Running>,
}

impl RunTimes {
    /// OB `number` starts on top of `depth` blocks.
    #[inline]
    pub(crate) fn begin(&mut self, number: u16, depth: usize, requested_us: u64, now_us: u64) {
        self.end(depth, now_us);
        self.running.push(Running { number, depth, requested_us, started_us: now_us });
    }

    /// Only `depth` blocks are left.
    #[inline]
    pub(crate) fn end(&mut self, depth: usize, now_us: u64) {
        while let Some(ended) = self.running.pop_if(|one| one.depth >= depth) {
            let run = LastRun { run_us: now_us.saturating_sub(ended.started_us), elapsed_us: now_us.saturating_sub(ended.requested_us) };
            match self.last.get_mut(&ended.number) {
                Some(last) => *last = run,
                None => drop(self.last.insert(ended.number, run)),
            }
        }
    }

    /// The innermost block that runs.
    pub(crate) fn innermost(&self) -> Option<Running> {
        self.running.last().copied()
    }

    /// That of OB `number`, if it runs.
    pub(crate) fn running(&self, number: u16) -> Option<Running> {
        self.running.iter().rev().find(|one| one.number == number).copied()
    }

    /// The last complete run of OB `number`.
    pub(crate) fn last(&self, number: u16) -> Option<LastRun> {
        self.last.get(&number).copied()
    }
}
