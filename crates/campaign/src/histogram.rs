//! How often which values came, in at most 64 buckets whose ends depend on the values alone, not on their order or on how they were divided.

use std::collections::BTreeMap;

use serde_json::{Value as Json, json};

/// Most buckets.
pub const BUCKETS_MAX: usize = 64;
/// Bits of a double: with all of them dropped there is one bucket.
const BITS: u32 = 64;

/// Counts of values. A bucket holds the doubles that share the leading bits; as many of them as leave no more than [`BUCKETS_MAX`] buckets.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Histogram {
    /// Bits that are dropped.
    dropped: u32,
    counts: BTreeMap<u64, u64>,
}

/// A bucket: the least value and the greatest that it can hold, and how many it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bucket {
    /// The least value that it can hold.
    pub least: f64,
    /// The greatest.
    pub most: f64,
    /// How many it holds.
    pub count: u64,
}

/// The bits of a double as a number whose order is that of the values.
fn ordered(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits >> 63 != 0 { !bits } else { bits | 1 << 63 }
}

/// The double of such a number; beyond the infinities are none.
fn value_of(ordered: u64) -> f64 {
    let bits = if ordered >> 63 != 0 { ordered & !(1 << 63) } else { !ordered };
    let value = f64::from_bits(bits);
    match value.is_nan() {
        true if ordered >> 63 != 0 => f64::INFINITY,
        true => f64::NEG_INFINITY,
        false => value,
    }
}

fn without(key: u64, bits: u32) -> u64 {
    key.checked_shr(bits).unwrap_or(0)
}

impl Histogram {
    /// Takes a finite number in; any other is left out.
    pub fn add(&mut self, value: f64) {
        if value.is_finite() {
            // Both zeros are one value.
            let key = ordered(if value == 0.0 { 0.0 } else { value });
            *self.counts.entry(without(key, self.dropped)).or_default() += 1;
            self.coarsen();
        }
    }

    /// Takes the counts of another one in.
    pub fn merge(&mut self, other: &Self) {
        self.drop_to(self.dropped.max(other.dropped));
        for (&key, &count) in &other.counts {
            *self.counts.entry(without(key, self.dropped - other.dropped)).or_default() += count;
        }
        self.coarsen();
    }

    fn coarsen(&mut self) {
        while self.counts.len() > BUCKETS_MAX && self.dropped < BITS {
            self.drop_to(self.dropped + 1);
        }
    }

    fn drop_to(&mut self, dropped: u32) {
        let more = dropped - self.dropped;
        if more > 0 {
            let mut counts = BTreeMap::new();
            for (&key, &count) in &self.counts {
                *counts.entry(without(key, more)).or_default() += count;
            }
            (self.counts, self.dropped) = (counts, dropped);
        }
    }

    /// The buckets that hold a value, in the order of their values.
    pub fn buckets(&self) -> impl Iterator<Item = Bucket> + '_ {
        let dropped = self.dropped;
        self.counts.iter().map(move |(&key, &count)| {
            let least = key.checked_shl(dropped).unwrap_or(0);
            let most = least | 1_u64.checked_shl(dropped).unwrap_or(0).wrapping_sub(1);
            Bucket { least: value_of(least), most: value_of(most), count }
        })
    }

    /// For files.
    pub fn to_json(&self) -> Json {
        let counts: Vec<Json> = self.counts.iter().map(|(key, count)| json!([format!("{key:x}"), count])).collect();
        json!({ "dropped": self.dropped, "counts": counts })
    }

    /// What was written by [`Self::to_json`].
    pub fn from_json(json: &Json) -> Option<Self> {
        let dropped = u32::try_from(json["dropped"].as_u64()?).ok().filter(|&dropped| dropped <= BITS)?;
        let count = |pair: &Json| Some((u64::from_str_radix(pair[0].as_str()?, 16).ok()?, pair[1].as_u64()?));
        let counts: BTreeMap<u64, u64> = json["counts"].as_array()?.iter().map(count).collect::<Option<_>>()?;
        let fits = counts.keys().all(|&key| without(u64::MAX, dropped) >= key);
        (fits && counts.len() <= BUCKETS_MAX).then_some(Self { dropped, counts })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn histogram(values: &[f64]) -> Histogram {
        let mut histogram = Histogram::default();
        values.iter().for_each(|&value| histogram.add(value));
        histogram
    }

    #[test]
    fn few_values_have_a_bucket_each() {
        let buckets: Vec<Bucket> = histogram(&[3.0, -1.5, 0.0, -0.0, 3.0]).buckets().collect();
        let of = |value: f64, count| Bucket { least: value, most: value, count };
        assert_eq!(buckets, [of(-1.5, 1), of(0.0, 2), of(3.0, 2)]);
        assert_eq!(histogram(&[f64::NAN, f64::INFINITY]).buckets().count(), 0);
    }

    #[test]
    fn what_no_histogram_wrote_is_none() {
        for json in [
            json!(null),
            json!({ "dropped": 65, "counts": [] }),
            json!({ "dropped": 60, "counts": [["ffff", 1]] }),
            json!({ "dropped": 0, "counts": [[1, 1]] }),
            json!({ "dropped": 0, "counts": [["x", 1]] }),
        ] {
            assert_eq!(Histogram::from_json(&json), None, "{json}");
        }
    }

    proptest! {
        #[test]
        fn it_does_not_depend_on_how_the_values_are_divided(values in prop::collection::vec(prop_oneof![any::<f64>(), -100.0..100.0, 5.0..5.1], 0..300), cut in 0..300_usize) {
            let whole = histogram(&values);
            let cut = cut.min(values.len());
            let mut parts = histogram(&values[cut..]);
            parts.merge(&histogram(&values[..cut]));
            prop_assert_eq!(&parts, &whole);
            prop_assert_eq!(Histogram::from_json(&whole.to_json()), Some(whole.clone()));
            let finite = values.iter().filter(|value| value.is_finite());
            prop_assert_eq!(whole.buckets().map(|bucket| bucket.count).sum::<u64>(), finite.clone().count() as u64);
            let buckets: Vec<Bucket> = whole.buckets().collect();
            prop_assert!(buckets.len() <= BUCKETS_MAX && buckets.windows(2).all(|pair| pair[0].most <= pair[1].least));
            for value in finite {
                prop_assert!(buckets.iter().any(|bucket| (bucket.least..=bucket.most).contains(value)), "{value} is in none of {buckets:?}");
            }
        }
    }
}
