//! A scenario of a campaign that fails, made as small as it fails in the same way.

use sieben_campaign::disturbed::Replayed;
use sieben_campaign::shrinking::shrink;
use sieben_sim::scenario::Scenario;
use sieben_sim::scenario::changing::Timed;

use super::closely::{self, Found};
use super::{Campaign, running};
use crate::duration;

/// The smallest scenario that was found.
pub struct Smaller {
    /// It, with the properties of the campaign.
    pub scenario: Scenario,
    /// How it breaks.
    pub found: Found,
    /// How many cases were run.
    pub runs: u32,
}

impl Campaign {
    /// Makes the scenario of a number smaller until nothing gets smaller any more, or until it is over.
    ///
    /// # Errors
    /// It does not fail, or not on one program alone; the message says so.
    pub fn shrink(&self, number: u64, is_over: &dyn Fn() -> bool) -> Result<Smaller, String> {
        let given = self.given(number);
        for subject in &self.programs {
            let case = subject.case(self, &given)?;
            let look = |scenario: &Scenario, wants_diagram| closely::look(self, subject, scenario, wants_diagram, &|| !is_over());
            let Some(found) = look(&subject.scenario_of(self, &case)?, false) else { continue };
            let mut breaks = |case: &_| Some(look(&subject.scenario_of(self, case).ok()?, false)?.broken);
            let shrunk = shrink(case, found.broken, &mut breaks, is_over);
            let scenario = subject.scenario_of(self, &shrunk.case)?;
            let mut found = closely::look(self, subject, &scenario, true, &|| true).ok_or("it does not fail twice")?;
            if self.recording.is_some() {
                found.reasons.extend(disturbances(&shrunk.case.replayed));
            }
            return Ok(Smaller { scenario: scenario.with_properties(running::properties(&self.spec)), found, runs: shrunk.runs });
        }
        Err(match self.programs.len() {
            1 => format!("scenario {number} does not fail"),
            _ => format!(
                "scenario {number} does not fail on one of the programs alone: what differs between programs cannot be made smaller"
            ),
        })
    }
}

/// What comes otherwise than it was recorded, a line each.
fn disturbances(replayed: &[Replayed]) -> Vec<String> {
    let show = |us: u64| format!("{} ms", duration::milliseconds(us));
    let mut all: Vec<(u64, String)> = Vec::new();
    for one in replayed.iter().filter(|one| one.changes() > 0) {
        let Timed { time_us, name, value } = &one.recorded;
        let mut line = format!("`{}` = {} comes at {}", name.trim_matches('"'), one.value, show(one.time_us));
        if one.moved_us() > 0 {
            line.push_str(&format!(", recorded at {}", show(*time_us)));
        }
        if one.value != *value {
            line.push_str(&format!(", recorded as {value}"));
        }
        if let Some((from, until)) = one.bounce {
            line.push_str(&format!(", and bounces from {} to {}", show(from), show(until)));
        }
        all.push((one.time_us, line));
    }
    all.sort();
    if all.is_empty() {
        return vec!["every input comes as it was recorded".to_owned()];
    }
    all.into_iter().map(|(_, line)| line).collect()
}
