//! What pages see of the CPU itself: its mode, lamps, diagnostic buffer and cycle.

use std::sync::Arc;

use serde_json::{Value as Json, json};
use sieben_cpu::{Cpu, OperatingMode};
use sieben_engine::FaultPlace;
use sieben_workspace::control::answer::Answer;
use sieben_workspace::control::{Control, Request};

use crate::hub::Hub;
use crate::live::content::Content;
use crate::live::program::Known;

impl Hub {
    /// The diagnostic buffer, newest first.
    pub(crate) fn diagnostics(&self, program: &Known) -> Json {
        let mut control = Control::new(Arc::clone(&self.facts));
        let Ok(Answer::Diagnostics(diagnostics)) = control.answer(&self.gate, &self.desk, &Request::Diagnostics { after: 0 }) else {
            return json!([]);
        };
        // What came since the last scan, while time stands still, came after it.
        let newest = self.gate.look(|plant| plant.scans).ok();
        let diagnosed = &self.desk.diagnosed;
        let scan = |number: u64| if number > diagnosed.newest() { newest } else { diagnosed.scan(number) };
        let entry = |entry: &sieben_workspace::control::answer::Entry| {
            let place = entry.place.as_ref().map(|placed| {
                // A number from 1.
                let statement = u32::try_from(placed.statement.saturating_sub(1)).unwrap_or(u32::MAX);
                let line = placed.line.as_ref().map(|&(_, line)| line);
                program.place_json(FaultPlace { block: placed.block, statement }, line)
            });
            let mut object = json!({
                "id": format!("16#{:04X}", entry.event), "number": entry.number, "n": scan(entry.number), "text": entry.text, "detail": "",
                "time": entry.time, "kind": event_kind(entry.event),
            });
            if let Some(place) = place {
                object["place"] = place;
            }
            object
        };
        diagnostics.entries.iter().rev().map(entry).collect()
    }

    /// How long scans took.
    pub(crate) fn cycle(&self) -> Content {
        let Ok((times, scans)) = self.gate.look(|plant| (plant.cpu.cycle_times(), plant.scan_times.clone())) else {
            return Content::Whole(Json::Null);
        };
        let mean = scans.times.sum_us.checked_div(scans.times.count).unwrap_or(0);
        let mut before = 0;
        let mut lower = 0;
        let classes = scans.times.up_to().map(|(end, count)| {
            let class = json!([lower, count - before]);
            (before, lower) = (count, end);
            class
        });
        let mut classes: Vec<Json> = classes.collect();
        classes.push(json!([lower, scans.times.count - before]));
        let values = [
            ("last_us", json!(times.last)),
            ("min_us", json!(times.min)),
            ("max_us", json!(times.max)),
            ("mean_us", json!(mean)),
            ("program_us", json!(times.execution_last)),
            ("overruns", json!(scans.overruns)),
            ("histogram", Json::Array(classes)),
        ];
        Content::Keyed(values.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
    }
}

/// What the lamps of the CPU need beside its mode.
#[derive(Clone, Copy)]
pub(crate) struct Lamps {
    is_forced: bool,
    has_failed: bool,
}

/// What is to be seen of them.
pub(crate) fn lamps(cpu: &Cpu) -> Lamps {
    let has_failed = cpu.failed_statements().count > 0 || cpu.stop_cause().is_some_and(|cause| cause.place.is_some());
    Lamps { is_forced: cpu.forced().bytes().next().is_some(), has_failed }
}

/// The lamps: 0 off, 1 on, 2 flashing.
pub(crate) fn leds(mode: OperatingMode, lamps: Lamps) -> Content {
    let (run, stop) = match mode {
        OperatingMode::Run => (1, 0),
        OperatingMode::Stop => (0, 1),
        OperatingMode::Startup | OperatingMode::Hold => (2, 1),
    };
    let values =
        [("sf", u8::from(lamps.has_failed)), ("bf", 0), ("dc5v", 1), ("frce", u8::from(lamps.is_forced)), ("run", run), ("stop", stop)];
    Content::Keyed(values.into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect())
}

/// What sort of event it is: the first digits are its class.
fn event_kind(event: u16) -> &'static str {
    match event >> 12 {
        0x2 | 0x3 => "error",
        0x4 if event & 0x0F00 == 0x0500 => "error",
        0x4 => "mode",
        0x5..=0x9 => "warning",
        _ => "info",
    }
}
