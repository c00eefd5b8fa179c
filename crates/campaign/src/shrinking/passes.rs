//! The passes, in their order: each tries what makes a case smaller in one way.

use sieben_sim::scenario::changing::Timed;
use sieben_sim::wrap::Fault;

use super::{Case, Freedom, Shrinker};
use crate::disturbed::Replayed;

/// Times that are easy to read, the coarsest first, in microseconds.
const ROUND_US: [u64; 3] = [1_000_000, 100_000, 10_000];
const MILLISECOND_US: u64 = 1_000;
/// How often a span is halved.
const HALVINGS: u32 = 12;
/// The parameter of plants that makes them uncertain.
const NOISE: &str = "noise";

impl Shrinker<'_> {
    pub(super) fn all_passes(&mut self) {
        self.cut();
        self.calm();
        self.recorded();
        self.events();
        self.faults();
        self.parameters();
        self.times();
        self.merge();
    }

    /// What comes after the break goes; what has to hold at the end may be wrong earlier.
    fn cut(&mut self) {
        self.ends_with(self.at.scan + 1);
        for _ in 0..HALVINGS {
            if self.case.scans < 2 || !self.ends_with(self.case.scans / 2) {
                break;
            }
        }
    }

    fn ends_with(&mut self, scans: u64) -> bool {
        let end = scans.max(1).saturating_mul(self.case.cycle_us);
        self.attempt_with(|case| {
            case.scans = scans.max(1);
            case.at.retain(|one| one.time_us < end);
            case.faults.retain(|fault| fault.from_us.is_none_or(|from| from < end));
        })
    }

    /// Without faults, without noise.
    fn calm(&mut self) {
        let quiet = |case: &mut Case| {
            for plant in &mut case.plants {
                plant.parameters.retain(|(name, _)| name != NOISE);
                plant.seed = None;
            }
        };
        let done = self.attempt_with(|case| {
            case.faults.clear();
            quiet(case);
        });
        if !done {
            self.attempt_with(|case| case.faults.clear());
            self.attempt_with(quiet);
        }
    }

    /// What was disturbed comes as it was recorded: all of it, halves of it, smaller and smaller parts, the last first. What is left is
    /// disturbed less.
    fn recorded(&mut self) {
        let all = self.case.replayed.len();
        let mut size = all;
        while size > 0 {
            let mut end = all;
            while end > 0 {
                let start = end.saturating_sub(size);
                self.attempt_with(|case| {
                    case.replayed[start..end].iter_mut().for_each(|one| *one = Replayed::as_recorded(one.recorded.clone()));
                });
                end = start;
            }
            size = if size == 1 { 0 } else { size.div_ceil(2) };
        }
        for index in 0..all {
            self.attempt_with(|case| case.replayed[index].bounce = None);
            self.attempt_with(|case| case.replayed[index].value = case.replayed[index].recorded.value.clone());
            self.attempt_with(|case| case.replayed[index].time_us = case.replayed[index].recorded.time_us);
            self.nearer(index);
        }
    }

    /// A disturbed input comes as near to its time as it may, by whole milliseconds.
    fn nearer(&mut self, index: usize) {
        let Replayed { recorded: Timed { time_us: recorded, .. }, time_us, .. } = self.case.replayed[index];
        let at = |ms: u64| {
            let by = ms * MILLISECOND_US;
            if time_us < recorded { recorded.saturating_sub(by) } else { recorded + by }
        };
        let (mut holds, mut breaks) = (0, time_us.abs_diff(recorded).div_ceil(MILLISECOND_US));
        self.attempt_with(|case| case.replayed[index].time_us = at(breaks));
        while breaks > holds + 1 {
            let middle = holds.midpoint(breaks);
            if self.attempt_with(|case| case.replayed[index].time_us = at(middle)) { breaks = middle } else { holds = middle }
        }
    }

    /// Events go: halves of them, then smaller and smaller parts, the last first.
    fn events(&mut self) {
        let mut size = self.case.at.len().div_ceil(2);
        while size > 0 {
            let mut end = self.case.at.len();
            while end > 0 {
                let start = end.saturating_sub(size);
                self.attempt_with(|case| drop(case.at.drain(start..end)));
                end = start;
            }
            size = if size == 1 { 0 } else { size.div_ceil(2) };
        }
    }

    /// Each fault goes, else it comes later and is shorter.
    fn faults(&mut self) {
        let mut index = self.case.faults.len();
        while index > 0 {
            index -= 1;
            if self.attempt_with(|case| drop(case.faults.remove(index))) {
                continue;
            }
            let break_us = self.at.time_us;
            let span = |fault: &Fault| (fault.from_us.unwrap_or(0), fault.until_us.unwrap_or(u64::MAX).min(break_us));
            for _ in 0..HALVINGS {
                let (from, until) = span(&self.case.faults[index]);
                let middle = from + until.saturating_sub(from) / 2;
                let later = |case: &mut Case| case.faults[index].from_us = Some(middle);
                if until <= from + self.case.cycle_us || !self.attempt_with(later) {
                    break;
                }
            }
            for _ in 0..HALVINGS {
                let (from, until) = span(&self.case.faults[index]);
                let middle = from + until.saturating_sub(from) / 2;
                let shorter = |case: &mut Case| case.faults[index].until_us = Some(middle);
                if until <= from + self.case.cycle_us || !self.attempt_with(shorter) {
                    break;
                }
            }
        }
    }

    /// Each parameter goes, or becomes what is usual, else it has fewer digits.
    fn parameters(&mut self) {
        let mut index = self.case.set.len();
        while index > 0 {
            index -= 1;
            let gone = match self.case.set[index].freedom.clone() {
                Freedom::Fixed => continue,
                Freedom::Optional => self.attempt_with(|case| drop(case.set.remove(index))),
                Freedom::Usual(usual) => self.attempt_with(|case| case.set[index].value = usual),
            };
            if !gone && let Ok(value) = self.case.set[index].value.parse::<f64>() {
                let whole = !self.case.set[index].value.contains('.');
                self.rounder(value, |case, value| case.set[index].value = if whole { format!("{value:.0}") } else { format!("{value:?}") });
            }
        }
        for plant in 0..self.case.plants.len() {
            self.attempt_with(|case| case.plants[plant].seed = None);
            let mut index = self.case.plants[plant].parameters.len();
            while index > 0 {
                index -= 1;
                if !self.attempt_with(|case| drop(case.plants[plant].parameters.remove(index))) {
                    let value = self.case.plants[plant].parameters[index].1;
                    self.rounder(value, |case, value| case.plants[plant].parameters[index].1 = value);
                }
            }
        }
    }

    /// A number with as few digits as will do.
    fn rounder(&mut self, value: f64, put: impl Fn(&mut Case, f64)) {
        for digits in 1..=4 {
            let rounded: Option<f64> = format!("{value:.*e}", digits - 1).parse().ok();
            if rounded.is_some_and(|rounded| self.attempt_with(|case| put(case, rounded))) {
                break;
            }
        }
    }

    /// Gaps between events go, then the times become round.
    fn times(&mut self) {
        for index in 0..self.case.at.len() {
            let before = if index == 0 { 0 } else { self.case.at[index - 1].time_us };
            let time = self.case.at[index].time_us;
            let gap = time - before;
            for by in [gap.saturating_sub(self.case.cycle_us), gap / 2] {
                if by > 0 && self.attempt_with(|case| earlier(case, time, by)) {
                    break;
                }
            }
        }
        for unit in ROUND_US.into_iter().chain([self.case.cycle_us]) {
            let round = |time: u64| (time + unit / 2) / unit.max(1) * unit;
            let all = self.attempt_with(|case| case.at.iter_mut().for_each(|one| one.time_us = round(one.time_us)));
            for index in 0..if all { 0 } else { self.case.at.len() } {
                let time = round(self.case.at[index].time_us);
                let low = if index == 0 { 0 } else { self.case.at[index - 1].time_us };
                let high = self.case.at.get(index + 1).map_or(u64::MAX, |next| next.time_us);
                if (low..=high).contains(&time) {
                    self.attempt_with(|case| case.at[index].time_us = time);
                }
            }
            for index in 0..self.case.faults.len() {
                self.attempt_with(|case| {
                    let Fault { from_us, until_us, .. } = &mut case.faults[index];
                    *from_us = from_us.map(round);
                    *until_us = until_us.map(|until| round(until).max(from_us.unwrap_or(0) + 1));
                });
            }
        }
    }

    /// Two events become one moment.
    fn merge(&mut self) {
        for index in 1..self.case.at.len() {
            let before = self.case.at[index - 1].time_us;
            self.attempt_with(|case| case.at[index].time_us = before);
        }
    }
}

/// All that comes at a time or later comes earlier.
fn earlier(case: &mut Case, from: u64, by: u64) {
    let moved = |time: &mut u64| *time -= if *time >= from { by.min(*time) } else { 0 };
    case.at.iter_mut().for_each(|Timed { time_us, .. }| moved(time_us));
    for Fault { from_us, until_us, .. } in &mut case.faults {
        from_us.iter_mut().for_each(moved);
        until_us.iter_mut().for_each(moved);
    }
}
