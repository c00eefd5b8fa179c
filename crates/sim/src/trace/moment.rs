//! Moments of a run, and how every report calls them: scan n, counted from 0, which begins at n times the cycle.

use std::fmt;

/// A moment of a run: a scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Moment {
    /// The number of the scan, from 0 at the beginning of the run.
    pub scan: u64,
    /// When it began, in microseconds of virtual time.
    pub time_us: u64,
}

impl fmt::Display for Moment {
    /// `scan 3 at 30 ms`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "scan {} at {}", self.scan, milliseconds(self.time_us))
    }
}

/// A time in milliseconds, with a fraction only where it needs one: `30 ms`, `0.5 ms`.
pub fn milliseconds(us: u64) -> String {
    match us % 1000 {
        0 => format!("{} ms", us / 1000),
        _ => format!("{} ms", us as f64 / 1000.0),
    }
}

/// A scan by its number; without one it is what runs before the first scan.
pub fn scan_words(scan: Option<u64>) -> String {
    scan.map_or_else(|| "the startup".to_owned(), |scan| format!("scan {scan}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_is_a_scan_counted_from_0_with_its_time() {
        let shown = |scan, time_us| Moment { scan, time_us }.to_string();
        assert_eq!([shown(0, 0), shown(3, 30_000), shown(1, 1_100_500)], ["scan 0 at 0 ms", "scan 3 at 30 ms", "scan 1 at 1100.5 ms"]);
        assert_eq!([scan_words(None), scan_words(Some(0))], ["the startup", "scan 0"]);
    }
}
