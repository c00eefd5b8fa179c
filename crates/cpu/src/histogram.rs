//! How long something took, counted in classes.

/// Upper ends of the classes, in microseconds; what takes longer is counted in no class of its own.
pub const CLASSES_US: [u64; 12] = [100, 200, 500, 1_000, 2_000, 5_000, 10_000, 20_000, 50_000, 100_000, 200_000, 500_000];

/// How long something took, each time that it was done.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Histogram {
    /// What is in each class and in none before it.
    classes: [u64; CLASSES_US.len()],
    /// How often it was measured.
    pub count: u64,
    /// How long it took all together, in microseconds.
    pub sum_us: u64,
}

impl Histogram {
    /// Counts it once.
    pub fn add(&mut self, us: u64) {
        if let Some(class) = self.classes.get_mut(CLASSES_US.partition_point(|&end| end < us)) {
            *class += 1;
        }
        self.count += 1;
        self.sum_us = self.sum_us.saturating_add(us);
    }

    /// How often it took as long as each class at most, with its end in microseconds.
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
    fn each_time_is_counted_once_and_classes_include_those_before() {
        let mut times = Histogram::default();
        for us in [0, 100, 101, 10_001, 600_000] {
            times.add(us);
        }
        let up_to: Vec<_> = times.up_to().map(|(_, count)| count).collect();
        assert_eq!(up_to, [2, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4]);
        assert_eq!((times.count, times.sum_us), (5, 610_202));
    }
}
