//! A set of scenario numbers, kept as ranges.

use std::collections::BTreeMap;
use std::ops::Range;

/// A set of scenario numbers, kept as the ranges that were put in and what is left of them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Ranges {
    /// Where each one begins and ends; none overlap.
    by_start: BTreeMap<u64, u64>,
}

impl Ranges {
    /// Puts a range in; of what was there already nothing changes.
    pub(crate) fn insert(&mut self, range: Range<u64>) {
        let mut start = range.start;
        while start < range.end {
            let before = self.by_start.range(..=start).next_back().map(|(_, end)| *end).filter(|end| *end > start);
            match before {
                Some(end) => start = end,
                None => {
                    let end = self.by_start.range(start..range.end).next().map_or(range.end, |(next, _)| *next);
                    self.by_start.insert(start, end);
                    start = end;
                }
            }
        }
    }

    /// Takes a range out.
    pub(crate) fn remove(&mut self, range: &Range<u64>) {
        if range.is_empty() {
            return;
        }
        if let Some((&start, &end)) = self.by_start.range(..range.start).next_back()
            && end > range.start
        {
            self.by_start.insert(start, range.start);
            if end > range.end {
                self.by_start.insert(range.end, end);
            }
        }
        while let Some((&start, &end)) = self.by_start.range(range.clone()).next() {
            self.by_start.remove(&start);
            if end > range.end {
                self.by_start.insert(range.end, end);
            }
        }
    }

    /// How many ranges there are.
    pub(crate) fn len(&self) -> usize {
        self.by_start.len()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.by_start.is_empty()
    }

    /// The ranges in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = Range<u64>> + '_ {
        self.by_start.iter().map(|(&start, &end)| start..end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(ranges: &Ranges) -> Vec<Range<u64>> {
        ranges.iter().collect()
    }

    #[test]
    fn a_set_of_ranges_is_the_set_of_its_numbers() {
        let mut state = 7_u64;
        let mut dice = |sides: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % sides
        };
        for _ in 0..200 {
            let (mut ranges, mut numbers) = (Ranges::default(), std::collections::BTreeSet::new());
            for _ in 0..20 {
                let start = dice(40);
                let range = start..start + dice(12);
                match dice(2) {
                    0 => {
                        ranges.insert(range.clone());
                        numbers.extend(range);
                    }
                    _ => {
                        ranges.remove(&range);
                        numbers.retain(|number| !range.contains(number));
                    }
                }
                assert_eq!(ranges.iter().flatten().collect::<Vec<_>>(), numbers.iter().copied().collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn what_is_taken_out_of_the_middle_leaves_two() {
        let mut ranges = Ranges::default();
        ranges.insert(0..10);
        ranges.remove(&(3..5));
        assert_eq!(of(&ranges), [0..3, 5..10]);
        ranges.insert(0..12);
        assert_eq!(of(&ranges), [0..3, 3..5, 5..10, 10..12]);
        assert_eq!(ranges.len(), 4);
    }
}
