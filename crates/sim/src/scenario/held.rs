//! What a scenario says that always is, held against every scan.

use std::collections::VecDeque;

use super::rules::{Rules, Tolerance, agree};
use crate::names::{Kind, Name, NameError, Sample};
use crate::trace::Moment;

/// A value that is not what it should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// What the scenario calls it.
    pub name: String,
    /// What it is in the program.
    pub place: Name,
    /// The line that says what it should be.
    pub line: usize,
    /// The first scan behind which it was something else.
    pub moment: Moment,
    /// What it should be.
    pub expected: Sample,
    /// What it was.
    pub actual: Sample,
    /// The scan behind which it was that for the first time; `None` if nobody looked.
    pub since: Option<u64>,
    /// A value that is expected did not come, though what came may be right: it is so with `within` scans.
    pub missed: bool,
}

/// A scan that is not decided yet.
#[derive(Clone, Debug)]
struct Undecided {
    moment: Moment,
    line: usize,
    expected: Sample,
    actual: Sample,
    since: u64,
}

/// What is held against every scan, for who looks on.
#[derive(Clone, Copy)]
pub struct Holding<'a>(pub(super) &'a [Held]);

impl Holding<'static> {
    /// Nothing is held.
    pub const NOTHING: Self = Self(&[]);
}

impl Holding<'_> {
    /// What is expected of a name behind this scan.
    pub fn expected(&self, name: &str) -> Option<&Sample> {
        self.0.iter().find(|held| held.text == name).map(|held| &held.expected)
    }
}

/// One name with what is expected of it.
pub(super) struct Held {
    text: String,
    name: Name,
    kind: Kind,
    tolerance: Option<Tolerance>,
    expected: Sample,
    line: usize,
    /// Scans in which it was something else.
    pub(super) differs: u64,
    within: usize,
    /// With `within`: the scans around the one that is decided next, and its place among them.
    window: VecDeque<Undecided>,
    center: usize,
    /// The value behind the last scan, and the scan behind which it was that for the first time.
    last: Sample,
    since: u64,
}

impl Held {
    pub(super) fn new(text: &str, name: Name, rules: &Rules) -> Self {
        Self {
            kind: name.recorded(),
            tolerance: rules.tolerance(text),
            text: text.to_owned(),
            name,
            expected: Sample::Absent,
            line: 0,
            differs: 0,
            within: usize::try_from(rules.within).unwrap_or(usize::MAX),
            window: VecDeque::new(),
            center: 0,
            last: Sample::Absent,
            since: 0,
        }
    }

    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// From the next scan on this is expected; `?` is nothing.
    pub(super) fn expect(&mut self, line: usize, value: &str) -> Result<(), NameError> {
        self.expected = match (&self.kind, value) {
            (_, "?") => Sample::Absent,
            (Kind::Text, text) => Sample::text(text),
            _ => Sample::of(&self.name.expected(value)?),
        };
        self.line = line;
        Ok(())
    }

    pub(super) fn show(&self, sample: &Sample) -> String {
        sample.readable(&self.kind)
    }

    /// Looks at the CPU behind a scan; a scan that is decided by that and is wrong.
    pub(super) fn scanned(&mut self, cpu: &sieben_cpu::Cpu, moment: Moment) -> Option<Difference> {
        if self.within == 0 && self.expected == Sample::Absent {
            return None;
        }
        let actual = self.name.sample(cpu).unwrap_or_default();
        if self.last != actual {
            self.last = actual.clone();
            self.since = moment.scan;
        }
        let since = self.since;
        if self.within == 0 {
            if agree(&self.kind, self.tolerance, &self.expected, &actual) {
                return None;
            }
            self.differs += 1;
            let scan = Undecided { moment, line: self.line, expected: self.expected.clone(), actual, since };
            return Some(self.difference(&scan, false));
        }
        self.window.push_back(Undecided { moment, line: self.line, expected: self.expected.clone(), actual, since });
        if self.window.len() <= self.center + self.within { None } else { self.decide() }
    }

    /// The scans at the end, which nothing follows.
    pub(super) fn finish(&mut self) -> Vec<Difference> {
        let mut differences = Vec::new();
        while self.center < self.window.len() {
            differences.extend(self.decide());
        }
        differences
    }

    /// Decides about the scan at the center: what came has to be expected nearby, and what is expected has to come nearby.
    fn decide(&mut self) -> Option<Difference> {
        let scan = self.window.get(self.center)?.clone();
        let agrees =
            |expected: &Sample, actual: &Sample| *expected == Sample::Absent || agree(&self.kind, self.tolerance, expected, actual);
        let around = || self.window.iter().take(self.center.saturating_add(self.within).saturating_add(1));
        let wanted = around().any(|other| agrees(&other.expected, &scan.actual));
        let came = around().any(|other| agrees(&scan.expected, &other.actual));
        self.center += 1;
        while self.center > self.within {
            self.window.pop_front();
            self.center -= 1;
        }
        if wanted && came {
            return None;
        }
        self.differs += 1;
        Some(self.difference(&scan, wanted))
    }

    fn difference(&self, scan: &Undecided, missed: bool) -> Difference {
        Difference {
            name: self.text.clone(),
            place: self.name.clone(),
            line: scan.line,
            moment: scan.moment,
            expected: scan.expected.clone(),
            actual: scan.actual.clone(),
            since: Some(scan.since),
            missed,
        }
    }
}
