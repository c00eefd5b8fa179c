//! How long organization blocks run: what SFC 78 tells, and all runs in classes for those outside.

use std::collections::BTreeMap;

use crate::clock::TimeSource;
use crate::histogram::Histogram;

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
    /// Whether time passes while it runs.
    time: TimeSource,
}

/// Run times of all organization blocks.
#[derive(Clone, Debug, Default)]
pub(crate) struct RunTimes {
    last: BTreeMap<u16, LastRun>,
    running: Vec<Running>,
    /// All runs in real time, if that is wanted.
    measured: Option<BTreeMap<u16, Histogram>>,
}

impl RunTimes {
    /// OB `number` starts on top of `depth` blocks.
    #[inline]
    pub(crate) fn begin(&mut self, number: u16, depth: usize, requested_us: u64, (now_us, time): (u64, TimeSource)) {
        self.end(depth, now_us);
        self.running.push(Running { number, depth, requested_us, started_us: now_us, time });
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
            if let Some(measured) = &mut self.measured
                && ended.time == TimeSource::Real
            {
                measured.entry(ended.number).or_default().add(run.run_us);
            }
        }
    }

    /// From now on all runs in real time are counted.
    pub(crate) fn measure(&mut self) {
        self.measured.get_or_insert_default();
    }

    /// Whether they are.
    pub(crate) fn is_measured(&self) -> bool {
        self.measured.is_some()
    }

    /// All runs that were counted, by the number of the block.
    pub(crate) fn measured(&self) -> impl Iterator<Item = (u16, &Histogram)> {
        self.measured.iter().flatten().map(|(&number, times)| (number, times))
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
