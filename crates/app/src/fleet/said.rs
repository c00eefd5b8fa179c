//! What is said about a fleet after its run.

use std::fmt::Write as _;
use std::time::Duration;

use serde_json::{Map, Value as Json, json};
use sieben_campaign::identity::hex;
use sieben_workspace::fleet::{Fleet, Row, Summary};
use sieben_workspace::{controller, duration};

use super::Ran;
use crate::campaign::said::several;

/// Rows of controllers in STOP that people are shown; `--json` and `--metrics` have all.
const STOPPED_MAX: usize = 10;

/// A run that has ended.
pub(crate) struct Run<'a> {
    /// The fleet.
    pub(crate) fleet: &'a Fleet,
    /// Its name.
    pub(crate) name: &'a str,
    /// Its file, as it was given.
    pub(crate) file: &'a str,
    /// What its controllers have come to.
    pub(crate) summary: &'a Summary,
    /// How many threads there were.
    pub(crate) threads: usize,
    /// How long it was meant to be, in microseconds of the fleet's time.
    pub(crate) for_us: u64,
    /// How it went.
    pub(crate) ran: Ran,
}

impl Run<'_> {
    /// For people.
    pub(crate) fn text(&self) -> String {
        let Self { summary, ran, .. } = self;
        let seconds = ran.took.as_secs_f64();
        let scans = summary.scans();
        let rate = if seconds > 0.0 { format!(" ({:.0} scans/s)", scans as f64 / seconds) } else { String::new() };
        let controllers = several(summary.rows.len() as u64, "controller");
        let took = duration::show(Duration::from_millis(u64::try_from(ran.took.as_millis()).unwrap_or(u64::MAX)));
        let mut text = format!("{}: {controllers}, {} in {took}{rate}\n", self.name, several(scans, "scan"));
        if ran.interrupted {
            let _ = writeln!(text, "  ended by Ctrl-C before {}", duration::show(Duration::from_micros(self.for_us)));
        }
        let _ = writeln!(text, "  messages      {}", summary.messages());
        let failed: u64 = summary.rows.iter().map(|row| row.failed_statements).sum();
        if failed > 0 {
            let of = summary.rows.iter().filter(|row| row.failed_statements > 0).count();
            let _ = writeln!(text, "  failed        {} in {}", several(failed, "statement"), several(of as u64, "controller"));
        }
        if let Some(row) = summary.longest().filter(|row| row.counts.longest_ns > 0) {
            let _ = writeln!(text, "  longest scan  {} µs, {}", row.counts.longest_ns.div_ceil(1000), row.name());
        }
        if ran.late >= Duration::from_millis(1) {
            let _ = writeln!(text, "  late by       {} ms at most", ran.late.as_millis());
        }
        let _ = writeln!(text, "  memory        {:.1} KiB each", summary.bytes_per_instance() as f64 / 1024.0);
        let _ = writeln!(text, "  state         {}", self.state().unwrap_or_else(|| "of different moments".to_owned()));
        text.push_str(&self.stopped());
        text
    }

    /// Those in STOP.
    fn stopped(&self) -> String {
        let count = self.summary.stopped().count();
        let mut text = if count == 0 { String::new() } else { format!("{} in STOP:\n", several(count as u64, "controller")) };
        for row in self.summary.stopped().take(STOPPED_MAX) {
            let _ = writeln!(text, "  {}  {}", row.name(), why(row));
        }
        if let Some(more) = count.checked_sub(STOPPED_MAX).filter(|&more| more > 0) {
            let _ = writeln!(text, "  … and {more} more; `--json` and `--metrics` have all");
        }
        if let Some(row) = self.summary.stopped().next() {
            let name = row.name();
            let _ = writeln!(text, "`sieben fleet {} --record '{name}' FILE.scenario` writes down what goes into {name},", self.file);
            let program = self.fleet.by_name(&name).map_or("", |number| self.fleet.program_of(number));
            let _ =
                writeln!(text, "`sieben step {program} FILE.scenario` walks through it (`{program}` counts from the folder of the fleet)");
        }
        text
    }

    /// The state of all controllers at one moment.
    fn state(&self) -> Option<String> {
        (!self.ran.torn).then(|| format!("{:016x}", self.summary.state_hash))
    }

    /// For programs.
    pub(crate) fn json(&self) -> Json {
        let Self { summary, ran, .. } = self;
        let outputs: Map<String, Json> = summary.rows.iter().map(|row| (row.name(), hex(&row.outputs).into())).collect();
        let stopped = |row: &Row| {
            let stop = row.stop.as_ref();
            let mut object = stop.and_then(|stop| stop.cause.as_ref()).map_or_else(|| json!({}), controller::stop_json);
            object["controller"] = row.name().into();
            object["scan"] = stop.and_then(|stop| stop.scan).into();
            object["at_us"] = stop.map(|stop| stop.at_us).into();
            object
        };
        json!({
            "name": self.name,
            "instances": summary.rows.len(),
            "scans": summary.scans(),
            "state_hash": self.state(),
            "outputs": outputs,
            "bytes_per_instance": summary.bytes_per_instance(),
            "cycle_us": self.fleet.cycle_us,
            "for_us": self.for_us,
            "threads": self.threads,
            "seconds": ran.took.as_secs_f64(),
            "late_us": u64::try_from(ran.late.as_micros()).unwrap_or(u64::MAX),
            "interrupted": ran.interrupted,
            "messages": summary.messages(),
            "failed_statements": summary.rows.iter().map(|row| row.failed_statements).sum::<u64>(),
            "longest_scan": summary.longest().map(|row| json!({
                "controller": row.name(), "us": row.counts.longest_ns as f64 / 1000.0,
            })),
            "stopped": summary.stopped().map(stopped).collect::<Vec<_>>(),
        })
    }
}

fn why(row: &Row) -> String {
    let Some(stop) = &row.stop else { return String::new() };
    let at = match stop.scan {
        None => "at its start".to_owned(),
        Some(scan) => format!("in scan {scan} at {}", duration::show(Duration::from_micros(stop.at_us))),
    };
    let cause = stop.cause.as_ref().map_or("", |cause| cause.text.as_str());
    format!("{at}: {cause}")
}
