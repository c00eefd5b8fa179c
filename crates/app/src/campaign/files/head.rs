//! What a result is of: it decides whether a run may go on with what another one left.

use serde_json::{Value as Json, json};
use sieben_campaign::identity::MEANING;
use sieben_campaign::part;
use sieben_campaign::spec::Keep;
use sieben_workspace::campaign::Campaign;

/// What a ledger or a result is of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Head {
    /// What identifies the campaign.
    pub(crate) campaign: String,
    /// What identifies its programs.
    pub(crate) program: String,
    /// What identifies its file.
    pub(crate) spec: String,
    /// Its seed.
    pub(crate) seed: u64,
    /// What the same code means in the version that ran it.
    pub(crate) meaning: u64,
    /// How many scenarios the campaign has.
    pub(crate) scenarios: u64,
    /// Which rows are kept.
    pub(crate) keep: Keep,
}

impl Head {
    /// Of a campaign.
    pub(crate) fn of(campaign: &Campaign) -> Self {
        let identity = campaign.identity.clone();
        Self {
            campaign: identity.campaign,
            program: identity.program,
            spec: identity.spec,
            seed: identity.seed,
            meaning: MEANING.into(),
            scenarios: campaign.scenarios(),
            keep: part::keep(&campaign.spec, campaign.scenarios()),
        }
    }

    /// For files.
    pub(crate) fn to_json(&self) -> Json {
        json!({
            "campaign": self.campaign, "program": self.program, "spec": self.spec, "seed": self.seed, "meaning": self.meaning,
            "scenarios": self.scenarios, "keep": self.keep.word(),
        })
    }

    /// What was written by [`Self::to_json`].
    pub(crate) fn from_json(json: &Json) -> Option<Self> {
        let text = |key: &str| json[key].as_str().map(str::to_owned);
        Some(Self {
            campaign: text("campaign")?,
            program: text("program")?,
            spec: text("spec")?,
            seed: json["seed"].as_u64()?,
            meaning: json["meaning"].as_u64()?,
            scenarios: json["scenarios"].as_u64()?,
            keep: Keep::from_word(json["keep"].as_str()?)?,
        })
    }

    /// What is not the same in another one, in words; nothing if it is of the same campaign.
    pub(crate) fn differs_from(&self, other: &Self) -> Option<String> {
        if self == other {
            return None;
        }
        let mut all = Vec::new();
        if self.program != other.program {
            all.push("the program".to_owned());
        }
        if self.spec != other.spec {
            all.push("the file of the campaign".to_owned());
        }
        if self.seed != other.seed {
            all.push(format!("the seed ({} there, {} here)", other.seed, self.seed));
        }
        if self.meaning != other.meaning {
            all.push(format!("what this version of Sieben makes of a scenario (meaning {} there, {} here)", other.meaning, self.meaning));
        }
        if all.is_empty() {
            all.push("what it says it is of".to_owned());
        }
        Some(all.join(", "))
    }
}
