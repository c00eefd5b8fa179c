//! A run in virtual time, scan by scan, that is asked as the screen asks, and the scenario of an example played on it.

use std::sync::Arc;

use serde_json::{Value, json};
use sieben_cpu::Restart;
use sieben_engine::Interpreter;
use sieben_workspace::control::{CurrentFacts, Facts};
use sieben_workspace::project::Build;
use sieben_workspace::status::Desk;
use sieben_workspace::{Driver, End, Gate, Pace, Plant, Speed, Surroundings, controller};

use super::super::asks::{Asks, Direct};
use super::super::demo;
use super::super::look::Look;
use super::super::state::{Screen, Then};
use crate::examples::Example;
use crate::terminal::Key;

/// Time from one scan to the next.
pub(super) const CYCLE_US: u64 = 10_000;

/// A run whose time stands still but for scans that are asked for.
pub(super) struct Played {
    pub(super) gate: Arc<Gate>,
    pub(super) desk: Arc<Desk>,
    pub(super) asks: Direct,
    pub(super) look: Look,
    pub(super) screen: Screen,
    scans: u64,
}

/// Ends the run after so many scans.
struct Counted(u64);

impl Surroundings for Counted {
    fn before_scan(&mut self, _: &mut Plant) {
        self.0 = self.0.saturating_sub(1);
    }
    fn is_ended(&self) -> bool {
        self.0 == 0
    }
}

impl Played {
    pub(super) fn example(name: &str) -> Self {
        Self::of(&demo::example(name))
    }

    pub(super) fn of(build: &Build) -> Self {
        let cpu = controller::load(build, Interpreter::load, controller::settings(build));
        let facts = Arc::new(CurrentFacts::new(Facts::of(build, cpu.program())));
        let mut pace = Pace::new(Speed::Factor(1.0), CYCLE_US, u64::MAX, 0);
        pace.pause(0);
        let mut plant = Plant::new(cpu, pace);
        plant.stay_in_stop();
        let gate = Arc::new(Gate::new(plant, Box::new(|| 0)));
        let desk = Arc::<Desk>::default();
        assert_eq!(Driver::new(&gate, &desk, &mut Counted(0)).run(Restart::Warm), End::Ended);
        let asks = Direct::new(&gate, &desk, &facts);
        let mut played = Self { gate, desk, asks, look: Look::default(), screen: Screen::default(), scans: 0 };
        played.refresh();
        played
    }

    pub(super) fn ask(&mut self, verb: &str, fields: &Value) -> Value {
        self.asks.ask(verb, fields).expect("the run answers")
    }

    /// So many scans, in this thread.
    pub(super) fn scans(&mut self, scans: u64) {
        if scans > 0 {
            self.gate.enter(|plant| plant.pace.step(scans, 0)).expect("the gate is open");
            assert_eq!(Driver::new(&self.gate, &self.desk, &mut Counted(scans)).go_on(), End::Ended);
            self.scans += scans;
        }
    }

    /// Looks again, with the status of the last scan.
    pub(super) fn refresh(&mut self) {
        let (screen, look) = (&self.screen, &mut self.look);
        look.refresh(&mut self.asks, &screen.names, &screen.formats, screen.block.as_deref()).expect("the run answers");
    }

    /// One scan more, whose status is seen.
    pub(super) fn scan_and_look(&mut self) {
        let before = self.desk.number();
        self.scans(1);
        self.desk.replay(|| self.desk.number() > before);
        self.refresh();
    }

    /// Presses a key.
    pub(super) fn key(&mut self, key: Key) -> Then {
        let then = self.screen.key(key, &self.look, &mut self.asks).expect("the run answers");
        self.refresh();
        then
    }

    /// Plays the scenario of an example for so many milliseconds of the CPU's time.
    pub(super) fn play(&mut self, name: &str, ms: u64) {
        let example = Example::by_name(name).expect("an example");
        let story = format!("{}.scenario", example.name);
        let (_, text) = example.files.iter().find(|(path, _)| *path == story).expect("it has a scenario");
        let end = ms * 1_000 / CYCLE_US;
        for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")) {
            if self.scans >= end {
                return;
            }
            self.line(line, end);
        }
        self.scans(end.saturating_sub(self.scans));
    }

    fn line(&mut self, line: &str, end: u64) {
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        match word {
            "cycle" | "cyclic" => {}
            "set" => self.set(rest),
            "scan" => {
                let scans = rest.trim().parse().unwrap_or(1).min(end - self.scans);
                self.scans(scans);
            }
            "at" => {
                let (time, rest) = rest.split_once(' ').expect("`at TIME …`");
                let ms = crate::duration::duration_argument(time).expect("a time").as_millis() as u64;
                let until = (ms * 1_000 / CYCLE_US).min(end);
                self.scans(until.saturating_sub(self.scans));
                self.set(rest);
            }
            "fault" => drop(self.ask("faults", &json!({ "inject": rest.trim() }))),
            "mend" => drop(self.ask("faults", &json!({ "mend": rest.trim() }))),
            "expect" => self.expect(rest, end),
            other => panic!("a scenario of an example has `{other}`"),
        }
    }

    fn set(&mut self, assignments: &str) {
        for assignment in assignments.split_whitespace() {
            let (name, value) = assignment.split_once('=').expect("NAME=VALUE");
            let answer = self.ask("write", &json!({ "values": { name: value } }));
            assert_eq!(answer["done"], 1, "{assignment}: {answer}");
        }
    }

    /// Scans until what is expected within a time is there.
    fn expect(&mut self, expected: &str, end: u64) {
        let Some((values, _)) = expected.split_once(" within ") else { return };
        let wanted: Vec<(&str, &str)> = values.split_whitespace().filter_map(|value| value.split_once('=')).collect();
        let names: Vec<&str> = wanted.iter().map(|(name, _)| *name).collect();
        while self.scans < end {
            let answer = self.ask("read", &json!({ "items": names }));
            let is_there = answer["items"].as_array().is_some_and(|items| {
                items.iter().zip(&wanted).all(|(item, (_, value))| {
                    let shown = item["value"].as_str().map_or_else(|| item["value"].to_string(), str::to_owned);
                    shown == *value
                        || shown.trim_start_matches("16#").trim_start_matches('0')
                            == value.trim_start_matches("16#").trim_start_matches('0')
                })
            });
            if is_there {
                return;
            }
            self.scans(1);
        }
    }
}
