//! A scenario of a campaign as a case that can be made smaller, and back.

use sieben_campaign::disturbed::timed;
use sieben_campaign::given::Given;
use sieben_campaign::shrinking::{Case, Freedom, SetValue};
use sieben_sim::names::{Name, Setting};
use sieben_sim::scenario::Scenario;
use sieben_sim::scenario::changing::Timed;
use sieben_sim::scenario::made::Parts;

use super::{Campaign, Subject};

impl Subject {
    /// The case of what a scenario is given.
    pub(super) fn case(&self, campaign: &Campaign, given: &Given) -> Result<Case, String> {
        let parts = self.parts(campaign, given)?;
        let fixed = self.set.len();
        let bits = fixed + self.bits.len();
        let freedom = |index: usize| match index {
            index if index < fixed => Freedom::Fixed,
            index if index < bits => Freedom::Usual("0".to_owned()),
            _ => Freedom::Optional,
        };
        let set = |(index, one): (usize, &Setting)| SetValue {
            name: one.name.text().to_owned(),
            value: one.text.clone(),
            freedom: freedom(index),
        };
        let written =
            |(time_us, one): &(u64, Setting)| Timed { time_us: *time_us, name: one.name.text().to_owned(), value: one.text.clone() };
        let mut at: Vec<Timed> = parts.at.iter().map(written).collect();
        at.sort_by_key(|one| one.time_us);
        let replayed = campaign.recording.as_ref().map(|recording| self.replayed(recording, &campaign.spec, given));
        Ok(Case {
            cycle_us: self.cycle_us,
            scans: self.scans,
            plants: if campaign.recording.is_some() { Vec::new() } else { parts.plants },
            set: parts.set.iter().enumerate().map(set).collect(),
            at,
            replayed: replayed.unwrap_or_default(),
            faults: parts.faults,
        })
    }

    /// The scenario of a case.
    pub(super) fn scenario_of(&self, campaign: &Campaign, case: &Case) -> Result<Scenario, String> {
        let setting = |name: &str, value: &str| {
            let name = Name::parse(name, &self.build.project.symbols, &self.build.compiled.program).map_err(|error| error.to_string())?;
            Setting::new(name, value).map_err(|error| error.to_string())
        };
        let set: Vec<Setting> = case.set.iter().map(|one| setting(&one.name, &one.value)).collect::<Result<_, _>>()?;
        if let Some(recording) = &campaign.recording {
            let mut timed = timed(&case.replayed);
            timed.extend(case.at.iter().cloned());
            timed.sort_by_key(|one| one.time_us);
            return Ok(recording.with_timed(set, timed));
        }
        let at = case.at.iter().map(|one| Ok((one.time_us, setting(&one.name, &one.value)?))).collect::<Result<_, String>>()?;
        // A plant of which nothing is said is as in the project.
        let said = case.plants.iter().filter(|plant| plant.seed.is_some() || !plant.parameters.is_empty());
        let plants = said.cloned().collect();
        Ok(Scenario::made(Parts { cycle_us: case.cycle_us, scans: case.scans, plants, set, at, faults: case.faults.clone() }))
    }
}
