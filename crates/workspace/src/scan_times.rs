//! How long scans took, counted in classes.

/// Upper ends of the classes, in microseconds; longer scans are counted in no class of their own.
pub const CLASSES_US: [u64; 12] = [100, 200, 500, 1_000, 2_000, 5_000, 10_000, 20_000, 50_000, 100_000, 200_000, 500_000];

/// How long scans took, without the pauses between them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ScanTimes {
    /// Scans in each class that are in none before it.
    classes: [u64; CLASSES_US.len()],
    /// All scans that were measured.
    pub count: u64,
    /// How long they took together, in microseconds.
    pub sum_us: u64,
    /// Scans that took longer than their cycle.
    pub overruns: u64,
}

impl ScanTimes {
    /// Counts a scan; a cycle of 0 runs free, and nothing overruns it.
    pub(crate) fn add(&mut self, us: u64, cycle_us: u64) {
        if let Some(class) = self.classes.get_mut(CLASSES_US.partition_point(|&end| end < us)) {
            *class += 1;
        }
        self.count += 1;
        self.sum_us = self.sum_us.saturating_add(us);
        self.overruns += u64::from(cycle_us > 0 && us > cycle_us);
    }

    /// How many scans took as long as each class at most, with its end in microseconds.
    pub fn up_to(&self) -> impl Iterator<Item = (u64, u64)> {
        CLASSES_US.iter().zip(&self.classes).scan(0, |sum, (&end, &count)| {
            *sum += count;
            Some((end, *sum))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_scan_is_counted_once_and_classes_include_those_before() {
        let mut times = ScanTimes::default();
        for us in [0, 100, 101, 10_001, 600_000] {
            times.add(us, 10_000);
        }
        let up_to: Vec<_> = times.up_to().map(|(_, count)| count).collect();
        assert_eq!(up_to, [2, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4]);
        assert_eq!((times.count, times.sum_us, times.overruns), (5, 610_202, 2));
        times.add(1_000_000, 0);
        assert_eq!(times.overruns, 2);
    }
}
