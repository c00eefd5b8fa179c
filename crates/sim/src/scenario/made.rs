//! Scenarios that code makes: what their files would say.

use std::collections::BTreeMap;

use super::property::PropertyLine;
use super::{Allowed, Assignments, Command, Line, PlantLine, Scenario};
use crate::names::Setting;
use crate::wrap::Fault;

/// What a scenario consists of that code makes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// From one scan to the next, in microseconds.
    pub cycle_us: u64,
    /// How many scans.
    pub scans: u64,
    /// Parameters of plants.
    pub plants: Vec<PlantLine>,
    /// Set before the first scan.
    pub set: Vec<Setting>,
    /// Set at their times, in microseconds.
    pub at: Vec<(u64, Setting)>,
    /// How signals of plants fail.
    pub faults: Vec<Fault>,
}

impl Scenario {
    /// A scenario of these parts.
    pub fn made(parts: Parts) -> Self {
        let Parts { cycle_us, scans, plants, set, at, faults } = parts;
        let mut commands: Vec<Command> = faults.into_iter().map(Command::Fault).collect();
        if !set.is_empty() {
            commands.push(Command::Set(set.into_iter().map(Into::into).collect()));
        }
        let mut times: BTreeMap<u64, Assignments> = BTreeMap::new();
        for (time, setting) in at {
            times.entry(time).or_default().push(setting.into());
        }
        commands.extend(times.into_iter().map(|(time, values)| Command::At(time, values)));
        commands.push(Command::Scan(scans));
        let lines = commands.into_iter().zip(1..).map(|(command, number)| Line { number, command }).collect();
        Self { cycle_us: cycle_us.max(1), plants, lines, ..Self::default() }
    }

    /// The same scenario with these properties in the place of its own.
    #[must_use]
    pub fn with_properties(self, properties: Vec<PropertyLine>) -> Self {
        Self { properties, ..self }
    }

    /// The same scenario, which allows this in the place of what it allowed.
    #[must_use]
    pub fn allowing(self, allowed: Allowed) -> Self {
        Self { allowed, ..self }
    }
}
