//! What the scenarios of a campaign came to, taken together in the order of their numbers.

use crate::draws::mix;
use crate::row::{Row, Verdict};
use crate::spec::{PropertyKind, Spec};

/// Counts and extremes over scenarios.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// How many ended with each verdict, in the order of [`Verdict::ALL`].
    pub verdicts: [u64; Verdict::ALL.len()],
    /// Of each property of the file.
    pub properties: Vec<PropertyTally>,
    /// Of each measure of the file.
    pub measures: Vec<MeasureTally>,
    /// The first scenario that did not pass.
    pub first: Option<Row>,
    /// Scans of all.
    pub scans: u64,
    /// 64 bits over all that came of them: the same wherever and however they were run.
    pub hash: u64,
}

/// What became of a property.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PropertyTally {
    /// Scenarios that it ended.
    pub broken: u64,
    /// The first of them; of what has to be sometimes, the first in which it was.
    pub first: Option<u64>,
    /// Scenarios in which it was, of what has to be sometimes.
    pub came: u64,
}

/// What became of a measure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasureTally {
    /// Scenarios that have it.
    pub count: u64,
    /// The least value and the number of its first scenario.
    pub least: Option<(f64, u64)>,
    /// The greatest.
    pub most: Option<(f64, u64)>,
    /// Their sum.
    pub sum: f64,
}

impl Tally {
    /// Nothing has been run.
    pub fn new(spec: &Spec) -> Self {
        Self {
            properties: vec![PropertyTally::default(); spec.properties.len()],
            measures: vec![MeasureTally::default(); spec.measures.len()],
            ..Self::default()
        }
    }

    /// Takes in the next scenario.
    pub fn add(&mut self, row: &Row) {
        self.verdicts[row.verdict as usize] += 1;
        self.scans += row.scans;
        self.hash = row.parts().fold(self.hash, |hash, part| mix(hash ^ part));
        if row.verdict != Verdict::Pass && self.first.is_none() {
            self.first = Some(row.clone());
        }
        if let Some(property) = row.property.and_then(|index| self.properties.get_mut(index)) {
            property.broken += 1;
            property.first.get_or_insert(row.scenario);
        }
        for (property, _) in self.properties.iter_mut().zip(&row.came).filter(|(_, came)| **came) {
            property.came += 1;
            property.first.get_or_insert(row.scenario);
        }
        for (tally, value) in self.measures.iter_mut().zip(&row.measures) {
            let Some(value) = *value else { continue };
            tally.count += 1;
            tally.sum += value;
            if tally.least.is_none_or(|(least, _)| value < least) {
                tally.least = Some((value, row.scenario));
            }
            if tally.most.is_none_or(|(most, _)| value > most) {
                tally.most = Some((value, row.scenario));
            }
        }
    }

    /// How many ended so.
    pub fn of(&self, verdict: Verdict) -> u64 {
        self.verdicts[verdict as usize]
    }

    /// Scenarios that were run.
    pub fn run(&self) -> u64 {
        self.verdicts.iter().sum()
    }

    /// What had to be sometimes and never was, by their places in the file.
    pub fn never_came<'a>(&'a self, spec: &'a Spec) -> impl Iterator<Item = usize> + 'a {
        let never = |(index, (property, tally)): (usize, (&crate::spec::Property, &PropertyTally))| {
            (property.kind == PropertyKind::Sometimes && tally.came == 0).then_some(index)
        };
        spec.properties.iter().zip(&self.properties).enumerate().filter_map(never)
    }
}
