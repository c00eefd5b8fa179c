//! How long scans took, and how many of them were late.

use sieben_cpu::Histogram;

/// How long scans took, without the pauses between them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ScanTimes {
    /// All scans that were measured.
    pub times: Histogram,
    /// Scans that took longer than their cycle.
    pub overruns: u64,
}

impl ScanTimes {
    /// Counts a scan; a cycle of 0 runs free, and nothing overruns it.
    pub(crate) fn add(&mut self, us: u64, cycle_us: u64) {
        self.times.add(us);
        self.overruns += u64::from(cycle_us > 0 && us > cycle_us);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scan_overruns_its_cycle_but_not_a_free_one() {
        let mut times = ScanTimes::default();
        for (us, cycle_us) in [(10_000, 10_000), (10_001, 10_000), (1_000_000, 0)] {
            times.add(us, cycle_us);
        }
        assert_eq!((times.times.count, times.overruns), (3, 1));
    }
}
