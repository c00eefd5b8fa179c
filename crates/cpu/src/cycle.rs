//! How long the cycle takes.

/// Cycle times in microseconds. A cycle lasts from the start of OB 1 to its next start, waiting included:
/// what programs read as OB1_PREV_CYCLE and integrate with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CycleTimes {
    /// The cycle before this one; 0 in the first cycle.
    pub last: u64,
    /// The shortest since the start.
    pub min: u64,
    /// The longest since the start.
    pub max: u64,
    /// The part of the last scan that the CPU worked; 0 in virtual time, where the clock stands still inside a scan.
    pub execution_last: u64,
    /// The longest of those parts since the start.
    pub execution_max: u64,
}

/// Counts scans and measures them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cycle {
    /// Scans that began since the last restart.
    pub(crate) number: u64,
    pub(crate) times: CycleTimes,
    started_us: Option<u64>,
}

impl Cycle {
    /// A cycle begins now.
    pub(crate) fn begin(&mut self, now_us: u64) {
        if let Some(started) = self.started_us {
            let last = now_us.saturating_sub(started);
            self.times.min = if self.number == 1 { last } else { self.times.min.min(last) };
            self.times.max = self.times.max.max(last);
            self.times.last = last;
        }
        self.started_us = Some(now_us);
        self.number += 1;
    }

    /// The program part of the cycle ends now. Returns how long it took.
    pub(crate) fn end(&mut self, now_us: u64) -> u64 {
        let execution = now_us.saturating_sub(self.started_us.unwrap_or(now_us));
        self.times.execution_last = execution;
        self.times.execution_max = self.times.execution_max.max(execution);
        execution
    }
}
