//! What a run answers, and the line of JSON that it becomes.

use serde_json::{Map, Value as Json, json};
use sieben_cpu::{BlockView, CycleTimes, OperatingMode};
use sieben_engine::machine::Registers;
use sieben_model::block::{BlockId, BlockLanguage};
use sieben_model::value::Value;

use super::facts::{Client, Placed};
use super::listing::Listing;
use super::plants::{PlantFaults, PlantView};
use super::table::Table;
use crate::names::shown_json;
use crate::observed::{Entry as Observation, Event};
use crate::pace::Speed;
use crate::refusal::Refusal;

/// What a run answers.
#[derive(Clone, Debug)]
pub enum Answer {
    /// How it goes.
    State(Box<State>),
    /// Values that belong to one scan.
    Values(Values),
    /// What came of items that were written, forced or no longer forced.
    Done(Done),
    /// Entries of the diagnostic buffer.
    Diagnostics(Diagnostics),
    /// Blocks that are loaded.
    Blocks(Blocks),
    /// What the statements of a block found and left.
    Status(Box<Status>),
    /// The mode after a change.
    Mode(Mode),
    /// The time after a change.
    Time(Time),
    /// The plants with their faults.
    Faults(Vec<PlantFaults>),
    /// The plants at one moment.
    Plants(Vec<PlantView>),
    /// A block as it is listed.
    Listing(Listing),
    /// The assignment table.
    Names(Table),
    /// What changed.
    Changes(Changes),
}

/// How a run goes.
#[derive(Clone, Debug)]
pub struct State {
    /// The name of the project, if it has one.
    pub project: Option<String>,
    /// Where the page of the run is, if it has one.
    pub page: Option<String>,
    /// How many CPUs took the place of the first one.
    pub run: u64,
    /// How many programs took over from the first one.
    pub version: u64,
    /// The CPU type.
    pub cpu: &'static str,
    /// What the CPU does.
    pub mode: OperatingMode,
    /// Why it is in STOP.
    pub stop: Option<Stop>,
    /// Scans since the beginning of the run.
    pub scans: u64,
    /// The time of the CPU since the beginning of the run, in microseconds.
    pub time_us: u64,
    /// The time of day at the last scan.
    pub clock: String,
    /// How long the cycle takes.
    pub cycle: CycleTimes,
    /// How fast time goes.
    pub speed: Speed,
    /// Whether it stands still.
    pub paused: bool,
    /// What is forced, and to what.
    pub forced: Vec<(String, String)>,
    /// How many bits and bytes are forced; the list may be shorter.
    pub forced_count: usize,
    /// How many are connected to the control socket.
    pub connections: usize,
    /// Who is connected to servers.
    pub clients: Vec<Client>,
    /// The number of the newest entry of the diagnostic buffer.
    pub newest_entry: u64,
}

/// Why the CPU is in STOP.
#[derive(Clone, Debug)]
pub struct Stop {
    /// The event of the STOP.
    pub event: u16,
    /// The first cause.
    pub first_event: u16,
    /// The statement that caused it.
    pub place: Option<Placed>,
    /// Cause, place and consequence in words.
    pub text: String,
}

/// Values that belong to one scan.
#[derive(Clone, Debug)]
pub struct Values {
    /// The last scan before them.
    pub scan: u64,
    /// Each item with its value, or why it has none.
    pub items: Vec<(String, Result<Value, Refusal>)>,
}

/// What came of items.
#[derive(Clone, Debug, Default)]
pub struct Done {
    /// The last scan before it; `None` if nothing was done.
    pub scan: Option<u64>,
    /// Each item with what came of it.
    pub items: Vec<(String, Result<(), Refusal>)>,
}

/// Entries of the diagnostic buffer.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    /// The number of the newest entry; 0 if there has been none.
    pub newest: u64,
    /// The entries, oldest first.
    pub entries: Vec<Entry>,
}

/// An entry of the diagnostic buffer.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its running number.
    pub number: u64,
    /// When it happened, as the CPU shows it.
    pub time: String,
    /// Its event.
    pub event: u16,
    /// What happened.
    pub text: String,
    /// The statement that caused it.
    pub place: Option<Placed>,
}

/// What changed.
#[derive(Clone, Debug)]
pub struct Changes {
    /// The number of the newest entry; 0 if there has been none.
    pub newest: u64,
    /// The entries, oldest first.
    pub entries: Vec<Observation>,
}

/// Blocks that are loaded.
#[derive(Clone, Debug)]
pub struct Blocks {
    /// How many there are.
    pub total: usize,
    /// Where the list goes on.
    pub next: Option<usize>,
    /// The blocks, each with the name that people call it by.
    pub blocks: Vec<(BlockView, Option<String>)>,
}

/// What the statements of a block found and left in one scan.
#[derive(Clone, Debug)]
pub struct Status {
    /// The block.
    pub block: BlockId,
    /// The number of the sample.
    pub sample: u64,
    /// The scan.
    pub scan: u64,
    /// When it began, in microseconds of the CPU's time.
    pub time_us: u64,
    /// Whether the replay ended as the real scan did.
    pub same: bool,
    /// Where the list goes on: a number of a statement, from 1.
    pub next: Option<u64>,
    /// The statements that were executed.
    pub statements: Vec<Statement>,
}

/// A statement in a scan.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Which one.
    pub place: Placed,
    /// How often it was executed.
    pub times: u32,
    /// The registers that it found when it was executed last.
    pub before: Registers,
    /// The registers that it left then.
    pub after: Registers,
    /// The variable that an assignment of ST wrote then.
    pub value: Option<String>,
}

/// The mode after a change.
#[derive(Clone, Copy, Debug)]
pub struct Mode {
    /// What the CPU does.
    pub mode: OperatingMode,
    /// Scans since the beginning of the run.
    pub scans: u64,
}

/// The time after a change.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    /// Whether it stands still.
    pub paused: bool,
    /// How fast it goes.
    pub speed: Speed,
    /// Scans since the beginning of the run.
    pub scans: u64,
    /// The time of the CPU, in microseconds.
    pub time_us: u64,
    /// Scans that are asked for and still to come.
    pub scans_left: u64,
}

/// The line that answers a request, with its end.
pub fn line(id: &Json, answer: &Result<Answer, Refusal>) -> String {
    let mut object = Map::new();
    object.insert("id".to_owned(), id.clone());
    match answer {
        Ok(answer) => object.extend(answer.fields()),
        Err(refusal) => {
            object.insert("error".to_owned(), refusal_json(refusal));
        }
    }
    let mut line = Json::Object(object).to_string();
    line.push('\n');
    line
}

fn refusal_json(refusal: &Refusal) -> Json {
    json!({ "code": refusal.problem.code(), "message": refusal.message })
}

fn milliseconds(us: u64) -> f64 {
    us as f64 / 1000.0
}

fn event(event: u16) -> String {
    format!("16#{event:04X}")
}

impl Answer {
    /// Its fields as JSON.
    pub fn fields(&self) -> Map<String, Json> {
        let json = match self {
            Self::State(state) => state.json(),
            Self::Values(values) => json!({ "scan": values.scan, "items": values.items.iter().map(value_json).collect::<Json>() }),
            Self::Done(done) => {
                let count = done.items.iter().filter(|(_, outcome)| outcome.is_ok() && done.scan.is_some()).count();
                json!({ "scan": done.scan, "done": count, "items": done.items.iter().map(|item| done_json(item, done.scan)).collect::<Json>() })
            }
            Self::Diagnostics(diagnostics) => {
                json!({ "newest": diagnostics.newest, "entries": diagnostics.entries.iter().map(Entry::json).collect::<Json>() })
            }
            Self::Blocks(blocks) => {
                let list = blocks.blocks.iter().map(|(view, name)| block_json(view, name.as_deref())).collect::<Json>();
                json!({ "total": blocks.total, "next": blocks.next, "blocks": list })
            }
            Self::Status(status) => status.json(),
            Self::Mode(Mode { mode, scans }) => json!({ "mode": mode.to_string(), "scans": scans }),
            Self::Time(time) => json!({
                "paused": time.paused, "speed": time.speed.to_string(), "scans": time.scans,
                "time_ms": milliseconds(time.time_us), "scans_left": time.scans_left,
            }),
            Self::Faults(plants) => json!({ "plants": plants.iter().map(PlantFaults::json).collect::<Json>() }),
            Self::Plants(plants) => json!({ "plants": plants.iter().map(PlantView::json).collect::<Json>() }),
            Self::Listing(listing) => listing.json(),
            Self::Names(table) => table.json(),
            Self::Changes(Changes { newest, entries }) => {
                json!({ "newest": newest, "entries": entries.iter().map(change_json).collect::<Json>() })
            }
        };
        match json {
            Json::Object(fields) => fields,
            _ => Map::new(),
        }
    }
}

/// Block, statement, file and line of a place, which may be none.
fn place_fields(object: &mut Json, place: Option<&Placed>) {
    let line = place.and_then(|place| place.line.as_ref());
    object["block"] = json!(place.map(|place| place.block.to_string()));
    object["statement"] = json!(place.map(|place| place.statement));
    object["file"] = json!(line.map(|(file, _)| file));
    object["line"] = json!(line.map(|(_, number)| number));
}

fn client_json(client: &Client) -> Json {
    json!({
        "protocol": client.protocol, "peer": client.peer, "partner": client.partner, "connected_ms": milliseconds(client.for_us),
        "last": client.last, "pdu": client.pdu_bytes, "reads": client.reads, "writes": client.writes,
        "written": client.written.as_ref().map(|last| {
            json!({ "name": last.name, "shown": last.value, "scan": last.scan, "time_ms": milliseconds(last.time_us) })
        }),
    })
}

impl State {
    fn json(&self) -> Json {
        let cycle = &self.cycle;
        let forced = self.forced.iter().map(|(name, value)| json!({ "name": name, "shown": value })).collect::<Json>();
        json!({
            "project": self.project, "page": self.page, "run": self.run, "version": self.version, "cpu": self.cpu, "mode": self.mode.to_string(), "stop": self.stop.as_ref().map(Stop::json),
            "scans": self.scans, "time_ms": milliseconds(self.time_us), "clock": self.clock,
            "cycle_ms": { "last": milliseconds(cycle.last), "min": milliseconds(cycle.min), "max": milliseconds(cycle.max) },
            "execution_ms": { "last": milliseconds(cycle.execution_last), "max": milliseconds(cycle.execution_max) },
            "speed": self.speed.to_string(), "paused": self.paused, "forced": forced, "forced_count": self.forced_count,
            "connections": self.connections, "clients": self.clients.iter().map(client_json).collect::<Json>(), "newest_entry": self.newest_entry,
        })
    }
}

impl Stop {
    fn json(&self) -> Json {
        let mut object = json!({ "event": event(self.event), "first_event": event(self.first_event), "text": self.text });
        place_fields(&mut object, self.place.as_ref());
        object
    }
}

impl Entry {
    fn json(&self) -> Json {
        let mut object = json!({ "number": self.number, "time": self.time, "event": event(self.event), "text": self.text });
        place_fields(&mut object, self.place.as_ref());
        object
    }
}

fn value_json((name, value): &(String, Result<Value, Refusal>)) -> Json {
    match value {
        Ok(value) => {
            let shown = value.shown();
            json!({ "name": name, "value": shown_json(&shown), "shown": shown.readable() })
        }
        Err(refusal) => json!({ "name": name, "error": refusal_json(refusal) }),
    }
}

fn done_json((name, outcome): &(String, Result<(), Refusal>), scan: Option<u64>) -> Json {
    match outcome {
        Ok(()) => json!({ "name": name, "done": scan.is_some() }),
        Err(refusal) => json!({ "name": name, "done": false, "error": refusal_json(refusal) }),
    }
}

fn change_json(entry: &Observation) -> Json {
    let mut object = json!({ "number": entry.number, "scan": entry.scan, "time_ms": milliseconds(entry.time_us) });
    match &entry.event {
        Event::Note(text) => object["note"] = json!(text),
        Event::Change { name, address, before, after, comment } => {
            for (key, text) in [("name", name), ("address", address), ("before", before), ("after", after), ("comment", comment)] {
                object[key] = json!(text);
            }
        }
    }
    object
}

/// The word for a language of blocks.
fn language(language: BlockLanguage) -> &'static str {
    match language {
        BlockLanguage::Stl => "STL",
        BlockLanguage::Lad => "LAD",
        BlockLanguage::Fbd => "FBD",
        BlockLanguage::Scl => "SCL",
        BlockLanguage::St => "ST",
        BlockLanguage::Data => "DB",
        BlockLanguage::CreatedData => "DB of the program",
    }
}

fn block_json(view: &BlockView, name: Option<&str>) -> Json {
    let attributes = &view.attributes;
    let (major, minor) = attributes.version;
    json!({
        "block": view.id.to_string(), "name": name, "language": language(attributes.language),
        "title": attributes.title, "author": attributes.author, "family": attributes.family, "header_name": attributes.name,
        "version": format!("{major}.{minor}"), "local_bytes": view.local_bytes, "code_bytes": view.code_bytes, "data_bytes": view.data_bytes,
        "based_on": view.based_on.map(|block| block.to_string()), "loaded": view.loaded.display(),
    })
}

fn registers_json(registers: &Registers) -> Json {
    let word = |bits: u64| format!("16#{:08X}", bits as u32);
    json!({
        "rlo": registers.rlo, "stw": registers.status().to_string(), "accu1": word(registers.accu1), "accu2": word(registers.accu2),
        "accu3": word(registers.accu3), "accu4": word(registers.accu4), "ar1": word(registers.ar1), "ar2": word(registers.ar2),
        "db": registers.db_number, "di": registers.di_number,
    })
}

impl Status {
    fn json(&self) -> Json {
        let statement = |statement: &Statement| {
            let line = statement.place.line.as_ref();
            json!({
                "statement": statement.place.statement, "file": line.map(|(file, _)| file), "line": line.map(|(_, number)| number),
                "times": statement.times, "before": registers_json(&statement.before), "after": registers_json(&statement.after),
                "shown": statement.value,
            })
        };
        json!({
            "block": self.block.to_string(), "sample": self.sample, "scan": self.scan, "time_ms": milliseconds(self.time_us),
            "same": self.same, "next": self.next, "statements": self.statements.iter().map(statement).collect::<Json>(),
        })
    }
}
