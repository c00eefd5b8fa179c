//! One scan as pages see it: all that any of them wants of it.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use serde_json::{Value as Json, json};
use sieben_lang::reason::Language;
use sieben_model::block::BlockId;
use sieben_workspace::status::Sample;

use super::content::Content;
use super::message::{Common, Rows, What};
use super::program::Known;
use crate::reference::View;

/// How the run goes at the moment when a scan is shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Head {
    /// The scan that is shown.
    pub scan: u64,
    /// Its time on the CPU, in microseconds.
    pub time_us: u64,
    /// The operating mode: `run`, `stop`, `startup`, `hold`.
    pub mode: &'static str,
    /// The oldest scan that can be shown.
    pub oldest: u64,
    /// The newest scan.
    pub newest: u64,
    /// Its time.
    pub newest_us: u64,
    /// Whether time stands still.
    pub paused: bool,
    /// How fast time goes; 0 is as fast as the computer can.
    pub speed: f64,
    /// Whether the replay ended as the real scan did.
    pub same: bool,
    /// Why the CPU is in STOP.
    pub why: Option<String>,
}

/// One scan.
#[derive(Clone)]
pub struct Shot {
    /// How the run goes.
    pub head: Head,
    /// The program that ran.
    pub program: Arc<Known>,
    /// What its statements did; none if no block was looked at.
    pub sample: Option<Arc<Sample>>,
    /// Reasons of statements, in the order of [`Language::ALL`].
    pub reasons: HashMap<(BlockId, u32), [String; 2]>,
    /// Values by name.
    pub tags: HashMap<String, Json>,
    /// What the lines of networks carry.
    pub flows: HashMap<(BlockId, View, u32), Json>,
    /// What is the same for all pages.
    pub common: BTreeMap<Common, Content>,
}

/// The statement was executed in this scan.
const EXECUTED: u8 = 1;

impl Shot {
    /// What a subscription holds at this scan.
    pub fn content(&self, what: &What, language: Language) -> Content {
        match what {
            What::Rows(rows) => self.rows(rows, language),
            What::Tags(names) => {
                Content::Keyed(names.iter().map(|name| (name.clone(), self.tags.get(name).cloned().unwrap_or(Json::Null))).collect())
            }
            What::Flow(flow) => {
                let block = self.program.facts.block(&flow.block);
                let of = |&network: &u32| {
                    let marks = block.and_then(|block| self.flows.get(&(block, flow.view, network)).cloned());
                    (network.to_string(), marks.unwrap_or(Json::Null))
                };
                Content::Keyed(flow.networks.iter().map(of).collect())
            }
            What::Common(common) => self.common.get(common).cloned().unwrap_or(Content::Whole(Json::Null)),
        }
    }

    /// The same scan while the run goes on.
    #[must_use]
    pub fn with_head_of(&self, newest: &Self) -> Self {
        let now = &newest.head;
        let head = Head {
            oldest: now.oldest,
            newest: now.newest,
            newest_us: now.newest_us,
            paused: now.paused,
            speed: now.speed,
            ..self.head.clone()
        };
        Self { head, ..self.clone() }
    }

    /// Whether there is anything of it in this scan: what was asked for after the scan comes with the next one.
    pub fn has(&self, what: &What) -> bool {
        match what {
            What::Rows(rows) => match (self.program.facts.block(&rows.block), &self.sample) {
                (Some(block), Some(sample)) => sample.blocks.contains(&block),
                (Some(_), None) => false,
                (None, _) => true,
            },
            What::Tags(names) => names.iter().all(|name| self.tags.contains_key(name)),
            What::Flow(flow) => match self.program.facts.block(&flow.block) {
                Some(block) => flow.networks.iter().all(|&network| self.flows.contains_key(&(block, flow.view, network))),
                None => true,
            },
            What::Common(common) => self.common.contains_key(common),
        }
    }

    /// `[line, executed, stw, accu1, accu2, reason?]` of each statement.
    fn rows(&self, rows: &Rows, language: Language) -> Content {
        let Some(block) = self.program.facts.block(&rows.block) else { return Content::Rows(rows.from, Vec::new()) };
        let lines = self.program.lines(block);
        let count = u32::try_from(lines.len()).unwrap_or(u32::MAX);
        let shown = (rows.from..=rows.to).take_while(|&number| number < count);
        let row = |number: u32| {
            let line = lines.get(number as usize).copied().unwrap_or_default();
            let status = self.sample.as_ref().and_then(|sample| sample.statements.get(&(block, number)));
            let mut row = match status {
                Some(status) => {
                    let after = &status.after;
                    vec![json!(line), json!(EXECUTED), json!(after.status().0), json!(after.accu1 as u32), json!(after.accu2 as u32)]
                }
                None => vec![json!(line), json!(0), json!(0), json!(0), json!(0)],
            };
            if rows.reason == Some(number)
                && let Some(reasons) = self.reasons.get(&(block, number))
            {
                let at = Language::ALL.iter().position(|&one| one == language).unwrap_or(0);
                row.push(json!(reasons.get(at)));
            }
            Json::Array(row)
        };
        Content::Rows(rows.from, shown.map(row).collect())
    }
}
