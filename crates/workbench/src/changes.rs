//! What changed, and who did it: the statement that wrote the value, or the client or page that asked for it.

use std::collections::{BTreeMap, VecDeque};
use std::sync::Mutex;

use serde_json::{Value as Json, json};
use sieben_engine::{FaultPlace, Machine, StatementEvent, Stored, Tracer};
use sieben_model::address::Operand;
use sieben_model::mnemonics::Mnemonics;
use sieben_sim::names::{Name, Shown};
use sieben_workspace::control::changes::Change;
use sieben_workspace::control::watched;
use sieben_workspace::observed::{Entry, Event};
use sieben_workspace::past::Viewer;

use crate::hub::Hub;
use crate::live::content::Content;
use crate::live::program::Known;
use crate::lock;

/// Requests that are remembered.
const REQUESTS_MAX: usize = 500;
/// Scans that one look runs again to find who wrote what changed in them.
const SCANS_MAX: usize = 10;

/// A client or page that asked for a value.
struct Asked {
    peer: String,
    /// The name that it used.
    object: String,
    /// The last scan before it.
    scan: u64,
}

/// Knows who changed what.
#[derive(Default)]
pub(crate) struct Authors {
    requests: Mutex<VecDeque<Asked>>,
    found: Mutex<Found>,
}

/// What was found out.
#[derive(Default)]
struct Found {
    viewer: Viewer,
    /// Of each entry what it says of its author.
    of_entries: BTreeMap<u64, Option<(&'static str, Json)>>,
}

impl Authors {
    /// A peer has changed something.
    pub(crate) fn note(&self, peer: &str, changes: &[Change]) {
        let mut requests = lock(&self.requests);
        for change in changes.iter().filter(|change| change.refused.is_none()) {
            let (Some(object), Some(scan)) = (&change.object, change.scan) else { continue };
            if requests.len() >= REQUESTS_MAX {
                requests.pop_front();
            }
            requests.push_back(Asked { peer: peer.to_owned(), object: object.clone(), scan });
        }
    }

    /// The peer that asked for an address in a scan, or just before it.
    fn peer(&self, program: &Known, address: &str, scan: u64) -> Option<String> {
        let spelled = |object: &str| {
            let plain = object.trim().trim_matches('"');
            let operand = Operand::parse(plain).or_else(|| program.facts.symbols.operand(plain));
            operand.map(|operand| operand.spell(Mnemonics::English))
        };
        let requests = lock(&self.requests);
        let near = |asked: &&Asked| asked.scan <= scan && scan <= asked.scan.saturating_add(1);
        let asked = requests.iter().rev().filter(near).find(|asked| spelled(&asked.object).as_deref() == Some(address))?;
        Some(asked.peer.clone())
    }
}

/// A value whose writer is looked for.
struct Sought {
    entry: u64,
    name: Name,
    value: Option<Shown>,
    writer: Option<FaultPlace>,
}

/// Finds the statements that gave values of a scan another content.
struct Writers {
    sought: Vec<Sought>,
    /// Which of them the statement that runs stores.
    stored: Vec<usize>,
    has_begun: bool,
}

impl Tracer for Writers {
    fn pauses_before(&mut self, machine: &Machine, _: FaultPlace) -> bool {
        if !std::mem::replace(&mut self.has_begun, true) {
            for sought in &mut self.sought {
                sought.value = sought.name.shown_in(machine, &machine.registers);
            }
        }
        false
    }

    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        for index in self.stored.drain(..) {
            let Some(sought) = self.sought.get_mut(index) else { continue };
            let now = sought.name.shown_in(machine, &event.after);
            // `S` and `R` store what was there where the RLO is 0.
            if now != sought.value {
                sought.writer = Some(event.place);
                sought.value = now;
            }
        }
    }

    fn stores(&mut self, machine: &Machine, stored: Stored) {
        let is_stored = |(_, sought): &(usize, &Sought)| sought.name.is_stored(machine, &machine.registers, &stored);
        self.stored.extend(self.sought.iter().enumerate().filter(is_stored).map(|(index, _)| index));
    }
}

impl Hub {
    /// What changed, oldest first; values are compared for a while after they were asked for.
    pub(crate) fn changes(&self, program: &Known) -> Content {
        self.desk.observed.look(program.version, || watched(&program.facts), self.gate.now_us());
        let (_, entries) = self.desk.observed.newer_than(0);
        let mut found = lock(&self.authors.found);
        self.find_authors(program, &entries, &mut found);
        let json = |entry: Entry| {
            let mut object = json!({ "n": entry.scan, "t_us": entry.time_us });
            match entry.event {
                Event::Note(text) => object["note"] = text.into(),
                Event::Change { name, address, before, after, .. } => {
                    for (key, text) in [("name", name), ("address", address), ("from", before), ("to", after)] {
                        object[key] = text.into();
                    }
                }
            }
            if let Some(Some((key, author))) = found.of_entries.get(&entry.number) {
                object[*key] = author.clone();
            }
            (entry.number, object)
        };
        Content::Log(entries.into_iter().map(json).collect())
    }

    /// Finds out who changed what is new: a scan with changes is run again once.
    fn find_authors(&self, program: &Known, entries: &[Entry], found: &mut Found) {
        let oldest = entries.first().map_or(0, |entry| entry.number);
        found.of_entries.retain(|&number, _| number >= oldest);
        let mut scans: BTreeMap<u64, Vec<(u64, &str)>> = BTreeMap::new();
        for entry in entries.iter().filter(|entry| !found.of_entries.contains_key(&entry.number)) {
            if let Event::Change { address, .. } = &entry.event {
                scans.entry(entry.scan).or_default().push((entry.number, address));
            }
        }
        for (at, (&scan, changed)) in scans.iter().rev().enumerate() {
            let facts = &program.facts;
            let name = |&(entry, address): &(u64, &str)| {
                let name = Name::parse(address, &facts.symbols, &facts.program).ok()?;
                Some(Sought { entry, name, value: None, writer: None })
            };
            let mut writers = Writers { sought: changed.iter().filter_map(name).collect(), stored: Vec::new(), has_begun: false };
            // What came long before the page was opened has no author.
            if at < SCANS_MAX && found.viewer.traced(self.desk.past(), scan, &mut writers).is_err() {
                writers.sought.clear();
            }
            let by: BTreeMap<u64, FaultPlace> = writers.sought.iter().filter_map(|one| Some((one.entry, one.writer?))).collect();
            for &(number, address) in changed {
                let statement = by.get(&number).map(|&place| {
                    let line = program.lines(place.block).get(place.statement as usize).copied();
                    ("by", program.place_json(place, line))
                });
                let author = statement.or_else(|| self.authors.peer(program, address, scan).map(|peer| ("peer", json!(peer))));
                found.of_entries.insert(number, author);
            }
        }
    }
}
