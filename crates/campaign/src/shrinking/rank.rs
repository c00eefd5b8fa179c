//! How large a case is: faults first, then events, parameters, the time until it breaks, and digits.

use sieben_sim::trace::Moment;
use std::collections::BTreeSet;

use super::{Case, Freedom};
use crate::disturbed::Replayed;

/// Compared in the order of its fields.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Rank {
    faults: usize,
    events: usize,
    parameters: usize,
    until_us: u64,
    failing_us: u64,
    moved_ms: u64,
    digits: usize,
    scans: u64,
}

impl Rank {
    /// Of a case that breaks there.
    pub(super) fn of(case: &Case, at: Moment) -> Self {
        let unusual = case.set.iter().filter(|set| match &set.freedom {
            Freedom::Fixed => false,
            Freedom::Optional => true,
            Freedom::Usual(usual) => *usual != set.value,
        });
        let of_plants = case.plants.iter().map(|plant| plant.parameters.len() + usize::from(plant.seed.is_some()));
        let failing = case.faults.iter().map(|fault| {
            let until = fault.until_us.unwrap_or(u64::MAX).min(at.time_us);
            until.saturating_sub(fault.from_us.unwrap_or(0))
        });
        Self {
            faults: case.faults.len(),
            events: case.at.len() + case.replayed.iter().map(Replayed::changes).sum::<usize>(),
            parameters: unusual.count() + of_plants.sum::<usize>(),
            until_us: at.time_us,
            failing_us: failing.fold(0, u64::saturating_add),
            moved_ms: case.replayed.iter().map(|one| one.moved_us().div_ceil(1_000)).fold(0, u64::saturating_add),
            digits: digits_of(case),
            scans: case.scans,
        }
    }
}

/// Significant digits of all numbers; a time counts once, however much comes then.
fn digits_of(case: &Case) -> usize {
    let disturbed = case.replayed.iter().filter(|one| one.changes() > 0);
    let times: BTreeSet<u64> = case.at.iter().map(|one| one.time_us).chain(disturbed.map(|one| one.time_us)).collect();
    let of_faults = case.faults.iter().flat_map(|fault| [fault.from_us, fault.until_us]).flatten();
    let in_times: usize = times.into_iter().chain(of_faults).map(|time| digits(&time.to_string())).sum();
    let values = case.set.iter().map(|set| &set.value).chain(case.at.iter().map(|one| &one.value));
    let in_values: usize = values.map(|value| digits(value)).sum();
    let parameters = case.plants.iter().flat_map(|plant| &plant.parameters);
    let in_parameters: usize = parameters.map(|(_, value)| digits(&format!("{value}"))).sum();
    in_times + in_values + in_parameters
}

fn digits(number: &str) -> usize {
    let digits: String = number.chars().filter(char::is_ascii_digit).collect();
    let digits = if number.contains('.') { digits.trim_start_matches('0') } else { digits.trim_matches('0') };
    digits.len()
}
