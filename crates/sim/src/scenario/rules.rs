//! How closely a run has to follow what a scenario says that always is, and what its names are called in this program.

use std::collections::{BTreeMap, BTreeSet};

use crate::names::{Kind, Sample};

/// How far a number may be from the expected one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// By so much, either way.
    Absolute(f64),
    /// By so many percent of the expected value, either way.
    Percent(f64),
}

impl Tolerance {
    /// Reads `0.5` or `2%`.
    ///
    /// # Errors
    /// It is no number that is at least 0.
    pub fn parse(text: &str) -> Result<Self, String> {
        let (number, make): (&str, fn(f64) -> Self) = match text.trim().strip_suffix('%') {
            Some(number) => (number, Self::Percent),
            None => (text.trim(), Self::Absolute),
        };
        let number = number.trim().parse::<f64>().ok().filter(|number| number.is_finite() && *number >= 0.0);
        number.map(make).ok_or_else(|| format!("`{text}` is no tolerance; write a number such as `0.5`, or percent such as `2%`"))
    }

    fn allows(self, expected: f64, actual: f64) -> bool {
        let by = match self {
            Self::Absolute(by) => by,
            Self::Percent(percent) => expected.abs() * percent / 100.0,
        };
        // A decimal such as 0.1 is no binary number: what it should just allow is allowed.
        (expected - actual).abs() <= by * (1.0 + 1e-9)
    }
}

/// The rules of a comparison; without any, every value has to be the same in every scan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rules {
    names: BTreeMap<String, String>,
    tolerances: BTreeMap<String, Tolerance>,
    /// That of every number that has none of its own.
    usual_tolerance: Option<Tolerance>,
    ignored: BTreeSet<String>,
    /// What the scenario expects is not looked at.
    pub expects_nothing: bool,
    /// A value may come so many scans earlier or later.
    pub within: u64,
}

/// A name without what may be written in several ways: quotes, blanks, capital letters.
fn key(name: &str) -> String {
    name.chars().filter(|c| !c.is_whitespace() && *c != '"').flat_map(char::to_lowercase).collect()
}

impl Rules {
    /// What the scenario calls `old` is called `new` in this program. The first of several holds.
    pub fn rename(&mut self, old: &str, new: &str) {
        self.names.entry(key(old)).or_insert_with(|| new.trim().to_owned());
    }

    /// A number may be so far from what is expected; of all names if none is said.
    pub fn tolerate(&mut self, name: Option<&str>, tolerance: Tolerance) {
        match name {
            Some(name) => drop(self.tolerances.insert(key(name), tolerance)),
            None => self.usual_tolerance = Some(tolerance),
        }
    }

    /// A number may be so far from what is expected, where nothing else is said of all numbers.
    pub(super) fn tolerate_usually(&mut self, tolerance: Tolerance) {
        self.usual_tolerance.get_or_insert(tolerance);
    }

    /// This name is not compared.
    pub fn ignore(&mut self, name: &str) {
        self.ignored.insert(key(name));
    }

    /// What a name of the scenario is called here.
    pub fn name<'a>(&'a self, name: &'a str) -> &'a str {
        if self.names.is_empty() {
            return name;
        }
        self.names.get(&key(name)).map_or(name, String::as_str)
    }

    /// The names of these rules, without regard to blanks, quotes and capital letters, that a scenario with these names has not.
    pub fn unknown<'a>(&'a self, names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
        let known: BTreeSet<String> = names.map(key).collect();
        let all = self.names.keys().chain(self.tolerances.keys()).chain(&self.ignored);
        all.filter(|name| !known.contains(*name)).map(String::as_str).collect()
    }

    /// Whether a name is not compared.
    pub fn is_ignored(&self, name: &str) -> bool {
        !self.ignored.is_empty() && self.ignored.contains(&key(name))
    }

    pub(super) fn tolerance(&self, name: &str) -> Option<Tolerance> {
        self.tolerances.get(&key(name)).copied().or(self.usual_tolerance)
    }
}

/// Whether a value is what it should be.
pub(super) fn agree(kind: &Kind, tolerance: Option<Tolerance>, expected: &Sample, actual: &Sample) -> bool {
    if expected == actual {
        return true;
    }
    let real = |sample: &Sample| match (&*kind.meaning(), sample) {
        (Kind::Typed(sieben_model::types::DataType::Real), Sample::Bits(bits)) => Some(f32::from_bits(*bits as u32)),
        _ => None,
    };
    if let (Some(expected), Some(actual)) = (real(expected), real(actual))
        && expected.is_nan()
        && actual.is_nan()
    {
        return true;
    }
    match (tolerance, expected.scale(kind), actual.scale(kind)) {
        (Some(tolerance), Some(expected), Some(actual)) if *kind != Kind::Bit => tolerance.allows(expected, actual),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sieben_model::types::DataType;

    #[test]
    fn names_are_found_however_they_are_written() {
        let mut rules = Rules::default();
        rules.rename("I 0.0", "I 4.0");
        rules.rename("\"Motor on\"", "bMotor");
        rules.ignore("Lamp");
        assert_eq!((rules.name("i0.0"), rules.name("Motor on"), rules.name("I 0.1")), ("I 4.0", "bMotor", "I 0.1"));
        assert!(rules.is_ignored("\"LAMP\"") && !rules.is_ignored("Lam"));
        assert_eq!(rules.unknown(["I0.0", "Lamp"].into_iter()), ["motoron"]);
    }

    #[test]
    fn numbers_may_differ_by_their_tolerance_and_bits_may_not() {
        let bits = Sample::Bits;
        let real = |number: f32| bits(u64::from(number.to_bits()));
        let (real_kind, word) = (Kind::Typed(DataType::Real), Kind::Bits(16));
        let (half, percent) = (Tolerance::parse("0.5").ok(), Tolerance::parse("10 %").ok());
        assert!(agree(&real_kind, half, &real(1.0), &real(1.5)) && !agree(&real_kind, half, &real(1.0), &real(1.6)));
        assert!(agree(&real_kind, percent, &real(-10.0), &real(-9.0)) && !agree(&real_kind, percent, &real(10.0), &real(8.9)));
        assert!(agree(&real_kind, None, &real(f32::NAN), &real(-f32::NAN)) && !agree(&real_kind, None, &real(0.0), &real(-0.0)));
        // A word without a type is a number with its sign, as `L PQW 256` and `>I` see it.
        assert!(agree(&word, half.map(|_| Tolerance::Absolute(2.0)), &bits(0xFFFF), &bits(1)));
        assert!(!agree(&Kind::Bit, Some(Tolerance::Absolute(5.0)), &bits(0), &bits(1)));
        for text in ["", "-1", "nan", "much", "%"] {
            assert!(Tolerance::parse(text).is_err(), "{text}");
        }
    }
}
