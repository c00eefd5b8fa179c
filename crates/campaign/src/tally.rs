//! What scenarios of a campaign came to, taken together: in whatever parts and order they come, it is the same.

use serde_json::{Value as Json, json};

use crate::draws::mix;
use crate::exact::Sum;
use crate::histogram::Histogram;
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
    /// The least distance of a property to its break, and the number of its first scenario.
    pub margin: Option<(f64, u64)>,
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
    pub sum: Sum,
    /// How often which values came.
    pub histogram: Histogram,
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

    /// Takes a scenario in.
    pub fn add(&mut self, row: &Row) {
        self.verdicts[row.verdict as usize] += 1;
        self.scans += row.scans;
        self.margin = extreme(self.margin, row.margin.map(|margin| (margin, row.scenario)), f64::lt);
        self.hash = self.hash.wrapping_add(row.parts().fold(0, |hash, part| mix(hash ^ part)));
        if let Some(property) = row.property.and_then(|index| self.properties.get_mut(index)) {
            property.broken += 1;
            property.first = earlier(property.first, Some(row.scenario));
        }
        for (property, _) in self.properties.iter_mut().zip(&row.came).filter(|(_, came)| **came) {
            property.came += 1;
            property.first = earlier(property.first, Some(row.scenario));
        }
        for (tally, value) in self.measures.iter_mut().zip(&row.measures) {
            if let Some(value) = *value {
                tally.add(value, row.scenario);
            }
        }
    }

    /// Takes in what other scenarios of the same campaign came to.
    pub fn merge(&mut self, other: &Self) {
        for (count, more) in self.verdicts.iter_mut().zip(other.verdicts) {
            *count += more;
        }
        self.scans += other.scans;
        self.margin = extreme(self.margin, other.margin, f64::lt);
        self.hash = self.hash.wrapping_add(other.hash);
        for (property, more) in self.properties.iter_mut().zip(&other.properties) {
            property.broken += more.broken;
            property.came += more.came;
            property.first = earlier(property.first, more.first);
        }
        for (measure, more) in self.measures.iter_mut().zip(&other.measures) {
            measure.merge(more);
        }
    }

    /// How many ended so.
    pub fn of(&self, verdict: Verdict) -> u64 {
        self.verdicts[verdict as usize]
    }

    /// How many did not pass.
    pub fn failures(&self) -> u64 {
        self.run() - self.of(Verdict::Pass)
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

    /// For files: all of it, exactly.
    pub fn to_json(&self) -> Json {
        let mut json = json!({ "scans": self.scans, "hash": format!("{:016x}", self.hash) });
        json["margin"] = self.margin.map(|(value, _)| value).into();
        json["margin_scenario"] = self.margin.map(|(_, at)| at).into();
        for verdict in Verdict::ALL {
            json[verdict.word()] = self.of(verdict).into();
        }
        json["properties"] = self.properties.iter().map(|of| json!({ "broken": of.broken, "came": of.came, "first": of.first })).collect();
        json["measures"] = self.measures.iter().map(MeasureTally::to_json).collect();
        json
    }

    /// What was written by [`Self::to_json`].
    pub fn from_json(json: &Json) -> Option<Self> {
        let mut tally = Self {
            margin: json["margin"].as_f64().zip(json["margin_scenario"].as_u64()),
            scans: json["scans"].as_u64()?,
            hash: u64::from_str_radix(json["hash"].as_str()?, 16).ok()?,
            properties: json["properties"].as_array()?.iter().map(property).collect::<Option<_>>()?,
            measures: json["measures"].as_array()?.iter().map(MeasureTally::from_json).collect::<Option<_>>()?,
            ..Self::default()
        };
        for verdict in Verdict::ALL {
            tally.verdicts[verdict as usize] = json[verdict.word()].as_u64()?;
        }
        Some(tally)
    }
}

fn earlier(one: Option<u64>, other: Option<u64>) -> Option<u64> {
    one.into_iter().chain(other).min()
}

fn property(json: &Json) -> Option<PropertyTally> {
    Some(PropertyTally { broken: json["broken"].as_u64()?, came: json["came"].as_u64()?, first: json["first"].as_u64() })
}

impl MeasureTally {
    fn add(&mut self, value: f64, scenario: u64) {
        self.count += 1;
        self.sum.add(value);
        self.histogram.add(value);
        self.least = extreme(self.least, Some((value, scenario)), f64::lt);
        self.most = extreme(self.most, Some((value, scenario)), f64::gt);
    }

    fn merge(&mut self, other: &Self) {
        self.count += other.count;
        self.sum.merge(&other.sum);
        self.histogram.merge(&other.histogram);
        self.least = extreme(self.least, other.least, f64::lt);
        self.most = extreme(self.most, other.most, f64::gt);
    }

    /// The mean of all values.
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum.value() / self.count as f64)
    }

    fn to_json(&self) -> Json {
        json!({
            "count": self.count,
            "min": self.least.map(|(value, _)| value), "min_scenario": self.least.map(|(_, at)| at),
            "max": self.most.map(|(value, _)| value), "max_scenario": self.most.map(|(_, at)| at),
            "mean": self.mean(), "sum": self.sum.to_json(), "histogram": self.histogram.to_json(),
        })
    }

    fn from_json(json: &Json) -> Option<Self> {
        Some(Self {
            count: json["count"].as_u64()?,
            least: json["min"].as_f64().zip(json["min_scenario"].as_u64()),
            most: json["max"].as_f64().zip(json["max_scenario"].as_u64()),
            sum: Sum::from_json(&json["sum"])?,
            histogram: Histogram::from_json(&json["histogram"])?,
        })
    }
}

/// The more extreme of two values; of equal ones that of the scenario with the lower number.
fn extreme(one: Option<(f64, u64)>, other: Option<(f64, u64)>, beyond: fn(&f64, &f64) -> bool) -> Option<(f64, u64)> {
    match (one, other) {
        (Some(one), Some(other)) => {
            let other_wins = beyond(&other.0, &one.0) || (other.0 == one.0 && other.1 < one.1);
            Some(if other_wins { other } else { one })
        }
        (one, other) => one.or(other),
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::source::{FileId, Span};

    use super::*;
    use crate::spec::{Measure, Of, Placed, Property};

    fn spec() -> Spec {
        let expression = Placed { text: "x".to_owned(), span: Span::new(FileId(0), 0, 1) };
        let property =
            |kind| Property { kind, name: String::new(), span: expression.span, expression: expression.clone(), then: None, within_us: 0 };
        let measure = Measure { name: String::new(), span: expression.span, of: Of::Max, expression: expression.clone(), unit: None };
        Spec {
            properties: vec![property(PropertyKind::Never), property(PropertyKind::Sometimes)],
            measures: vec![measure.clone(), measure],
            ..Spec::default()
        }
    }

    fn row(scenario: u64) -> Row {
        let random = mix(scenario);
        Row {
            scenario,
            seed: random,
            verdict: if random.is_multiple_of(5) { Verdict::Fail } else { Verdict::Pass },
            property: random.is_multiple_of(5).then_some(0),
            at: None,
            scans: random % 100,
            virtual_us: 0,
            margin: random.is_multiple_of(2).then_some((random % 777) as f64 / 3.0 - 5.0),
            trace_hash: random,
            parameters: Vec::new(),
            faults: Vec::new(),
            measures: vec![Some((random % 1000) as f64 / 7.0), random.is_multiple_of(3).then_some(-0.1)],
            came: vec![false, random.is_multiple_of(7)],
            message: None,
        }
    }

    #[test]
    fn parts_in_any_order_make_the_whole_and_files_lose_nothing() {
        let spec = spec();
        let of = |numbers: std::ops::Range<u64>| {
            let mut tally = Tally::new(&spec);
            numbers.for_each(|number| tally.add(&row(number)));
            tally
        };
        let whole = of(0..300);
        for cuts in [[0, 100, 300], [1, 299, 300], [150, 150, 300]] {
            let mut merged = Tally::new(&spec);
            let mut parts = vec![of(0..cuts[0]), of(cuts[0]..cuts[1]), of(cuts[1]..cuts[2])];
            parts.reverse();
            for part in &parts {
                let written = serde_json::to_string(&part.to_json()).expect("it can be written");
                let read = serde_json::from_str(&written).ok().and_then(|json| Tally::from_json(&json));
                assert_eq!(read.as_ref(), Some(part));
                merged.merge(part);
            }
            assert_eq!(merged, whole);
            assert_eq!(merged.to_json(), whole.to_json());
        }
        assert_ne!(of(0..299).hash, whole.hash);
    }
}
