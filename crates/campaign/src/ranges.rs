//! Which scenarios of a campaign there is a result of: ranges that do not overlap.

use std::collections::BTreeMap;
use std::ops::Range;

/// A set of numbers, as ranges.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ranges {
    /// The end of each range by its beginning; none touches the next one.
    ends: BTreeMap<u64, u64>,
}

impl Ranges {
    /// Takes a range in, unless it has a number that is there.
    pub fn insert(&mut self, range: Range<u64>) -> bool {
        if range.is_empty() || self.overlaps(&range) {
            return false;
        }
        let mut range = range;
        if let Some(end) = self.ends.remove(&range.end) {
            range.end = end;
        }
        match self.ends.range_mut(..range.start).next_back() {
            Some((_, end)) if *end == range.start => *end = range.end,
            _ => {
                self.ends.insert(range.start, range.end);
            }
        }
        true
    }

    /// Whether it has a number of a range.
    pub fn overlaps(&self, range: &Range<u64>) -> bool {
        self.ends.range(..range.end).next_back().is_some_and(|(_, &end)| end > range.start)
    }

    /// The ranges, in order.
    pub fn iter(&self) -> impl Iterator<Item = Range<u64>> + '_ {
        self.ends.iter().map(|(&start, &end)| start..end)
    }

    /// What is missing in a range, in order.
    pub fn missing(&self, within: Range<u64>) -> impl Iterator<Item = Range<u64>> + '_ {
        let after = std::iter::once(within.end..within.end);
        let mut next = within.start;
        let there = self.iter().filter({
            let within = within.clone();
            move |range| range.end > within.start && range.start < within.end
        });
        there.chain(after).filter_map(move |range| {
            let gap = next..range.start;
            next = next.max(range.end);
            (!gap.is_empty()).then_some(gap)
        })
    }

    /// How many numbers it has.
    pub fn count(&self) -> u64 {
        self.iter().map(|range| range.end - range.start).sum()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn it_is_a_set_of_numbers(all in prop::collection::vec((0..60_u64, 0..12_u64), 0..30), from in 0..70_u64, len in 0..30_u64) {
            let mut ranges = Ranges::default();
            let mut numbers = BTreeSet::new();
            for (start, len) in all {
                let range = start..start + len;
                let fits = !range.is_empty() && range.clone().all(|number| !numbers.contains(&number));
                prop_assert_eq!(ranges.insert(range.clone()), fits);
                if fits {
                    numbers.extend(range);
                }
            }
            prop_assert_eq!(ranges.count(), numbers.len() as u64);
            prop_assert!(ranges.iter().flatten().eq(numbers.iter().copied()));
            let pairs: Vec<Range<u64>> = ranges.iter().collect();
            prop_assert!(pairs.windows(2).all(|pair| pair[0].end < pair[1].start), "none touches the next one");
            let missing: Vec<u64> = ranges.missing(from..from + len).flatten().collect();
            prop_assert!((from..from + len).filter(|number| !numbers.contains(number)).eq(missing));
        }
    }
}
