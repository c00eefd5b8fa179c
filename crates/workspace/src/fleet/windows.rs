//! Time windows: how many scans every controller does before any of them looks at what the others have sent.

/// The windows of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Windows {
    cycle_us: u64,
    scans: u64,
    /// Scans of a window.
    each: u64,
}

/// Scans of one window: from the first up to, but not including, the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// Which one, counted from 0.
    pub number: u64,
    /// Its first scan.
    pub from: u64,
    /// The first scan after it.
    pub to: u64,
    /// From one scan to the next, in microseconds.
    pub cycle_us: u64,
}

impl Windows {
    /// The windows of so many scans. What is sent in a window arrives `latency_us` later at the earliest, so that a scan which begins less than
    /// that after the first one of the window has nothing of it; without links a window has as many scans as it may: `most`.
    pub fn new(cycle_us: u64, scans: u64, latency_us: Option<u64>, most: u64) -> Self {
        let cycle_us = cycle_us.max(1);
        let each = latency_us.map_or(most, |latency| latency.div_ceil(cycle_us)).clamp(1, most.max(1));
        Self { cycle_us, scans, each }
    }

    /// The window with this number, if there is one.
    pub fn get(&self, number: u64) -> Option<Window> {
        let from = number.checked_mul(self.each).filter(|&from| from < self.scans)?;
        Some(Window { number, from, to: from.saturating_add(self.each).min(self.scans), cycle_us: self.cycle_us })
    }
}

impl Window {
    /// When a scan begins, in microseconds.
    pub fn begin_us(&self, scan: u64) -> u64 {
        scan.saturating_mul(self.cycle_us)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_scan_of_a_window_could_have_a_message_of_the_same_window() {
        for cycle_us in [1, 300, 1000, 10_000] {
            for latency_us in [1000, 1001, 2500, 10_000, 35_000] {
                for scans in [0, 1, 7, 100] {
                    let windows = Windows::new(cycle_us, scans, Some(latency_us), 64);
                    let all: Vec<Window> = (0..).map_while(|number| windows.get(number)).collect();
                    assert!(all.iter().flat_map(|window| window.from..window.to).eq(0..scans), "each scan is in one window");
                    for window in &all {
                        let last = window.begin_us(window.to - 1);
                        assert!(last < window.begin_us(window.from) + latency_us, "{window:?}");
                        assert!(window.to - window.from <= 64);
                    }
                }
            }
        }
    }

    #[test]
    fn windows_are_as_long_as_they_may_be() {
        let first = |latency| Windows::new(10_000, 1000, latency, 64).get(0).map(|window| window.to);
        assert_eq!([None, Some(1000), Some(10_000), Some(10_001), Some(60_000_000)].map(first), [64, 1, 1, 2, 64].map(Some));
        assert_eq!(Windows::new(0, 5, None, 0).get(4).map(|window| window.to), Some(5), "nothing is divided by 0");
        assert_eq!(Windows::new(1, u64::MAX, None, 64).get(u64::MAX), None);
    }
}
