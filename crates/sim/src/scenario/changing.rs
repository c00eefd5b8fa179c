//! A recording with other inputs than it was recorded with.

use super::{Assignment, Assignments, Command, Line, Scenario};
use crate::names::Setting;

/// A value that comes from outside at a time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Timed {
    /// When, in microseconds.
    pub time_us: u64,
    /// The name as it is written.
    pub name: String,
    /// The value as it is written.
    pub value: String,
}

impl Scenario {
    /// All values that its `at` lines bring, in the order of the file.
    pub fn timed(&self) -> Vec<Timed> {
        let of = |line: &Line| match &line.command {
            Command::At(time, values) => {
                values.iter().map(|one| Timed { time_us: *time, name: one.name.clone(), value: one.value.clone() }).collect()
            }
            _ => Vec::new(),
        };
        self.lines.iter().flat_map(of).collect()
    }

    /// The names of its `always` lines, each once.
    pub fn held(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for line in &self.lines {
            if let Command::Always(values) = &line.command {
                let new: Vec<&str> = values.iter().map(|one| one.name.as_str()).filter(|name| !names.contains(name)).collect();
                names.extend(new);
            }
        }
        names
    }

    /// How many scans its lines ask for, without those whose number depends on what happens.
    pub fn scans(&self) -> u64 {
        let of = |line: &Line| match line.command {
            Command::Scan(count) => count,
            Command::ScanAt(_) => 1,
            Command::ScanUntil(end) => end / self.cycle_us().max(1),
            _ => 0,
        };
        self.lines.iter().map(of).fold(0, u64::saturating_add)
    }

    /// The same scenario with these values at their times in the place of those of its `at` lines, and with what is set before the
    /// first scan. All of them stand at its beginning, so that any of them can come at any time.
    #[must_use]
    pub fn with_timed(&self, set: Vec<Setting>, timed: Vec<Timed>) -> Self {
        let mut commands = Vec::new();
        if !set.is_empty() {
            commands.push(Command::Set(set.into_iter().map(Into::into).collect::<Assignments>()));
        }
        let written = |one: Timed| Command::At(one.time_us, vec![Assignment::written(one.name, one.value)]);
        commands.extend(timed.into_iter().map(written));
        let mut lines: Vec<Line> = commands.into_iter().map(|command| Line { number: 0, command }).collect();
        lines.extend(self.lines.iter().filter(|line| !matches!(line.command, Command::At(..))).cloned());
        // As its text has it, so that what is said names the line.
        lines.iter_mut().zip(1..).for_each(|(line, number)| line.number = number);
        Self { lines, ..self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_inputs_are_replaced_and_all_else_stays() {
        let text =
            "cycle 20ms\nstart with I 0.1=1\nalways Q 0.0=0\nscan 5\nat 100ms I 0.0=1 MW 4=5\nscan 2\nat 150ms I 0.0=0\nscan until 1s\n";
        let scenario = Scenario::parse(text).expect("a scenario");
        let timed = scenario.timed();
        assert_eq!(
            timed.iter().map(|one| (one.time_us, one.name.as_str(), one.value.as_str())).collect::<Vec<_>>(),
            [(100_000, "I 0.0", "1"), (100_000, "MW 4", "5"), (150_000, "I 0.0", "0"),]
        );
        assert_eq!((scenario.scans(), scenario.held()), (5 + 2 + 50, vec!["Q 0.0"]));
        let other = scenario.with_timed(Vec::new(), vec![Timed { time_us: 7_000, ..timed[2].clone() }]);
        assert_eq!(
            other.to_string(),
            "cycle 20ms\nstart with I 0.1=1\nat 7ms I 0.0=0\nalways Q 0.0=0\nscan 5\nscan 2\nscan until 1000ms\n"
        );
    }
}
