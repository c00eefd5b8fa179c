//! One scan as pages see it: all that any of them wants of it.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use serde_json::{Value as Json, json};
use sieben_cpu::OperatingMode;
use sieben_workspace::status::{Calls, Sample, Statements};

use super::content::Content;
use super::message::{Common, Rows, What};
use super::program::{Known, Said, Speech};
use crate::reference::View;

/// How the run goes at the moment when a scan is shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Head {
    /// The scan that is shown.
    pub scan: u64,
    /// Its time on the CPU, in microseconds.
    pub time_us: u64,
    /// The operating mode.
    pub mode: OperatingMode,
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

/// The mode in the words of the protocol.
pub(crate) fn mode_word(mode: OperatingMode) -> &'static str {
    match mode {
        OperatingMode::Run => "run",
        OperatingMode::Stop => "stop",
        OperatingMode::Startup => "startup",
        OperatingMode::Hold => "hold",
    }
}

/// The statement that has just run, where a scan is shown up to there.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// Its block, as pages call it.
    pub block: String,
    /// Its number in the block, from 0.
    pub index: u32,
    /// Its line; 0 for one that the compiler made.
    pub line: u32,
    /// Why it did what it did.
    pub reason: Arc<Said>,
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
    /// Where in the scan; `None` at its end.
    pub position: Option<Position>,
    /// Statements that are still to come, with what they did in the scan before.
    pub pending: Arc<Statements>,
    /// Reasons of statements.
    pub reasons: HashMap<(Calls, u32), Arc<Said>>,
    /// Values by name.
    pub tags: HashMap<String, Json>,
    /// What the lines of networks carry.
    pub flows: HashMap<(Calls, View, u32), Json>,
    /// What is the same for all pages.
    pub common: BTreeMap<Common, Content>,
}

/// The statement was executed in this scan.
const EXECUTED: u8 = 1;
/// It is still to come: its values are those of the scan before.
const PENDING: u8 = 2;
/// Where in a row the value stands that a statement has written.
const VALUE: usize = 6;

impl Shot {
    /// What a subscription holds at this scan.
    pub fn content(&self, what: &What, speech: Speech) -> Content {
        match what {
            What::Rows(rows) => self.rows(rows, speech),
            What::Tags(names) => {
                Content::Keyed(names.iter().map(|name| (name.clone(), self.tags.get(name).cloned().unwrap_or(Json::Null))).collect())
            }
            What::Flow(flow) => {
                let calls = self.program.calls(&flow.block, flow.instance.as_deref());
                let of = |&network: &u32| {
                    let marks = calls.and_then(|calls| self.flows.get(&(calls, flow.view, network)).cloned());
                    (network.to_string(), marks.unwrap_or(Json::Null))
                };
                Content::Keyed(flow.networks.iter().map(of).collect())
            }
            What::Common(common) => self.common.get(common).cloned().unwrap_or(Content::Whole(Json::Null)),
        }
    }

    /// The same scan while the run goes on: the plant and the lamps are those of the scan, what is forced, who is connected and what is noted are those of now.
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
        let of_the_scan = |common: &Common| matches!(common, Common::Plant | Common::Leds);
        let mut common = newest.common.clone();
        common.retain(|common, _| !of_the_scan(common));
        common.extend(self.common.iter().filter(|(common, _)| of_the_scan(common)).map(|(&common, content)| (common, content.clone())));
        Self { head, common, ..self.clone() }
    }

    /// Whether there is anything of it in this scan: what was asked for after the scan comes with the next one.
    pub fn has(&self, what: &What) -> bool {
        match what {
            What::Rows(rows) => match (self.program.calls(&rows.block, rows.instance.as_deref()), &self.sample) {
                (Some(calls), Some(sample)) => sample.calls.contains(&calls),
                (Some(_), None) => false,
                (None, _) => true,
            },
            What::Tags(names) => names.iter().all(|name| self.tags.contains_key(name)),
            What::Flow(flow) => match self.program.calls(&flow.block, flow.instance.as_deref()) {
                Some(calls) => flow.networks.iter().all(|&network| self.flows.contains_key(&(calls, flow.view, network))),
                None => true,
            },
            What::Common(common) => self.common.contains_key(common),
        }
    }

    /// `[line, executed, stw, accu1, accu2, reason?, value?]` of each statement.
    fn rows(&self, rows: &Rows, speech: Speech) -> Content {
        let calls = self.program.calls(&rows.block, rows.instance.as_deref());
        let Some(calls) = calls else { return Content::Rows(rows.from, Vec::new()) };
        let lines = self.program.lines(calls.block);
        let count = u32::try_from(lines.len()).unwrap_or(u32::MAX);
        let shown = (rows.from..=rows.to).take_while(|&number| number < count);
        let row = |number: u32| {
            let line = lines.get(number as usize).copied().unwrap_or_default();
            let place = (calls, number);
            let done = self.sample.as_ref().and_then(|sample| sample.statements.get(&place)).map(|status| (EXECUTED, status));
            let pending = self.pending.get(&place).map(|status| (PENDING, status));
            let mut row = match done.or(pending) {
                Some((executed, status)) => {
                    let after = &status.after;
                    vec![json!(line), json!(executed), json!(after.status().0), json!(after.accu1 as u32), json!(after.accu2 as u32)]
                }
                None => vec![json!(line), json!(0), json!(0), json!(0), json!(0)],
            };
            if rows.reason == Some(number)
                && let Some(said) = self.reasons.get(&place)
            {
                row.push(json!(said.text(speech)));
            }
            if let Some(value) = done.or(pending).and_then(|(_, status)| status.value.as_ref()) {
                row.resize(VALUE, Json::Null);
                row.push(json!(value));
            }
            Json::Array(row)
        };
        Content::Rows(rows.from, shown.map(row).collect())
    }
}
