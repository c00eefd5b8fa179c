//! One look at a run: its state, values, diagnostic buffer and blocks.

use std::collections::VecDeque;
use std::io;

use serde_json::{Map, Value, json};
use sieben_model::problems::Problem;

use crate::control::Client;
use crate::control::client::silent;
use crate::failure::Failure;
use crate::screen::{clock, thousands};

/// Inputs and outputs that are always shown, whatever the program uses.
const BYTES: [&str; 8] = ["IB0", "IB1", "IB2", "IB3", "QB0", "QB1", "QB2", "QB3"];
/// Entries of the diagnostic buffer that are kept: no CPU type has more.
const ENTRIES_MAX: usize = 500;
/// Blocks that are shown by name; of more only their number is.
const BLOCKS_MAX: usize = 1_000;

/// Who looks at a run, with what was seen before.
pub(crate) struct Onlooker {
    client: Client,
    /// Names that the user watches.
    names: Vec<String>,
    /// The diagnostic buffer, newest first.
    entries: VecDeque<Value>,
    /// The number of the newest entry that was seen.
    newest: u64,
    blocks: Vec<String>,
    /// How many blocks there are.
    block_count: u64,
}

/// What is seen at one moment.
#[derive(Clone, Debug, Default)]
pub(crate) struct Look {
    /// The answer to `state`.
    state: Value,
    /// The bytes of [`BYTES`].
    bytes: Vec<(&'static str, Option<u8>)>,
    /// What the user watches: names and values.
    values: Vec<Watched>,
    /// The diagnostic buffer, newest first.
    entries: Vec<Value>,
    /// The blocks.
    blocks: Vec<String>,
    /// How many there are; the list may be shorter.
    block_count: u64,
}

/// A watched name.
#[derive(Clone, Debug)]
struct Watched {
    /// As the user wrote it.
    name: String,
    /// Its value, or why it has none.
    value: Result<Value, String>,
    /// As people read it.
    shown: String,
}

fn items(answer: &Value) -> &[Value] {
    answer["items"].as_array().map_or(&[], Vec::as_slice)
}

impl Onlooker {
    /// A view of these names.
    pub(crate) fn new(client: Client, names: Vec<String>) -> Self {
        Self { client, names, entries: VecDeque::new(), newest: 0, blocks: Vec::new(), block_count: 0 }
    }

    /// Who is asked, and the names.
    pub(crate) fn into_parts(self) -> (Client, Vec<String>) {
        (self.client, self.names)
    }

    /// Says so if one of the names means nothing.
    pub(crate) fn check_names(&mut self) -> Result<(), Failure> {
        let answer = self.client.ask("read", &json!({ "items": self.names })).map_err(|error| silent(&error))?;
        let error = answer.get("error").or_else(|| items(&answer).iter().find_map(|item| item.get("error")));
        match error {
            None => Ok(()),
            Some(error) => {
                let problem = error["code"].as_str().and_then(Problem::from_code).unwrap_or(Problem::P7003);
                Err(Failure::usage(problem, error["message"].as_str().unwrap_or_default()))
            }
        }
    }

    /// Looks at the blocks, which seldom change.
    pub(crate) fn look_at_blocks(&mut self) -> io::Result<()> {
        let answer = self.client.ask("blocks", &json!({}))?;
        let name = |block: &Value| {
            let id = block["block"].as_str().unwrap_or_default();
            block["name"].as_str().map_or_else(|| id.to_owned(), |name| format!("{id} {name}"))
        };
        self.blocks = answer["blocks"].as_array().into_iter().flatten().take(BLOCKS_MAX).map(name).collect();
        self.block_count = answer["total"].as_u64().unwrap_or_default();
        Ok(())
    }

    /// Looks at everything else.
    pub(crate) fn look(&mut self) -> io::Result<Look> {
        let state = self.client.ask("state", &json!({}))?;
        let wanted: Vec<&str> = BYTES.into_iter().chain(self.names.iter().map(String::as_str)).collect();
        let read = self.client.ask("read", &json!({ "items": wanted }))?;
        let byte = |item: &Value| {
            let hex = item["value"].as_str()?.strip_prefix("16#")?;
            u8::from_str_radix(hex, 16).ok()
        };
        let read = items(&read);
        let bytes = BYTES.into_iter().zip(read.iter().map(byte).chain(std::iter::repeat(None))).collect();
        let values = self.names.iter().enumerate().map(|(index, name)| watched(name, read.get(BYTES.len() + index))).collect();
        self.look_at_entries()?;
        Ok(Look {
            state,
            bytes,
            values,
            entries: self.entries.iter().cloned().collect(),
            blocks: self.blocks.clone(),
            block_count: self.block_count,
        })
    }

    fn look_at_entries(&mut self) -> io::Result<()> {
        let answer = self.client.ask("diagnostics", &json!({ "after": self.newest }))?;
        for entry in answer["entries"].as_array().into_iter().flatten() {
            self.entries.push_front(entry.clone());
        }
        self.entries.truncate(ENTRIES_MAX);
        self.newest = answer["newest"].as_u64().unwrap_or(self.newest);
        Ok(())
    }
}

fn watched(name: &str, item: Option<&Value>) -> Watched {
    let error = item.and_then(|item| item["error"]["message"].as_str());
    let value = item.and_then(|item| item.get("value").cloned());
    let shown = item.and_then(|item| item["shown"].as_str()).unwrap_or("-").to_owned();
    Watched { name: name.to_owned(), value: value.ok_or_else(|| error.unwrap_or("no value").to_owned()), shown }
}

/// `10.02 ms`; `-` for 0, which was not measured.
fn milliseconds(value: &Value) -> String {
    value.as_f64().filter(|&ms| ms > 0.0).map_or_else(|| "-".to_owned(), |ms| format!("{ms:.2} ms"))
}

/// `pump.awl:12`, if a line is known.
fn line_text(value: &Value) -> String {
    match (value["file"].as_str(), value["line"].as_u64()) {
        (Some(file), Some(line)) => format!("  {file}:{line}"),
        _ => String::new(),
    }
}

/// An entry of the diagnostic buffer in one line.
fn entry_text(entry: &Value) -> String {
    let word = |key: &str| entry[key].as_str().unwrap_or_default();
    format!("{}  {}  {}{}", word("time"), word("event"), word("text"), line_text(entry))
}

impl Look {
    fn word(&self, key: &str) -> &str {
        self.state[key].as_str().unwrap_or_default()
    }

    /// The time of the CPU.
    fn time_text(&self) -> String {
        clock(self.state["time_ms"].as_f64().unwrap_or_default() as u64)
    }

    /// `1x`, `paused, 1x`.
    fn speed_text(&self) -> String {
        let speed = self.word("speed");
        if self.is_paused() { format!("paused, {speed}") } else { speed.to_owned() }
    }

    fn is_paused(&self) -> bool {
        self.state["paused"] == true
    }

    fn scans_text(&self) -> String {
        thousands(self.state["scans"].as_u64().unwrap_or_default())
    }

    /// Why the CPU is in STOP.
    fn stop_text(&self) -> Option<String> {
        let stop = &self.state["stop"];
        Some(format!("{}{}", stop["text"].as_str()?, line_text(stop)))
    }

    /// What is forced, and to what.
    fn forced(&self) -> Vec<String> {
        let forced = self.state["forced"].as_array().into_iter().flatten();
        forced.map(|one| format!("{} = {}", one["name"].as_str().unwrap_or_default(), one["shown"].as_str().unwrap_or_default())).collect()
    }

    /// The clients of servers, a line for each.
    fn clients(&self) -> Vec<String> {
        let line = |client: &Value| {
            let word = |key: &str, otherwise: &'static str| client[key].as_str().unwrap_or(otherwise).to_owned();
            let (protocol, peer, partner) = (word("protocol", ""), word("peer", ""), word("partner", "-"));
            let time = clock(client["connected_ms"].as_f64().unwrap_or_default() as u64);
            format!("{protocol}  {peer:<21}  {partner:<5}  {:<14}  for {time}", word("last", "-"))
        };
        self.state["clients"].as_array().into_iter().flatten().map(line).collect()
    }

    /// The blocks in one text.
    fn blocks_text(&self) -> String {
        let more = self.block_count.saturating_sub(self.blocks.len() as u64);
        let mut text = self.blocks.join(", ");
        if more > 0 {
            text.push_str(&format!(" and {} more", thousands(more)));
        }
        text
    }

    /// All of it as one JSON object.
    pub(crate) fn json(&self) -> Value {
        let mut state = self.state.clone();
        if let Some(fields) = state.as_object_mut() {
            fields.shift_remove("id");
        }
        let value = |one: &Watched| (one.name.clone(), one.value.clone().unwrap_or(Value::Null));
        let byte = |&(name, byte): &(&str, Option<u8>)| (name.to_owned(), byte.map_or(Value::Null, |byte| json!(format!("16#{byte:02X}"))));
        let values: Map<String, Value> = self.bytes.iter().map(byte).chain(self.values.iter().map(value)).collect();
        state["values"] = values.into();
        state["diagnostic_buffer"] = self.entries.clone().into();
        state["blocks"] = self.blocks.clone().into();
        state["block_count"] = self.block_count.into();
        state
    }

    /// All of it as text.
    pub(crate) fn text(&self) -> String {
        let cycle = &self.state["cycle_ms"];
        let project = self.state["project"].as_str().map_or_else(String::new, |name| format!("`{name}` on a "));
        let mut text = format!("{project}CPU {}: {}, {}\n", self.word("cpu"), self.word("mode"), self.speed_text());
        if let Some(stop) = self.stop_text() {
            text.push_str(&format!("  {stop}\n"));
        }
        let (last, min, max) = (milliseconds(&cycle["last"]), milliseconds(&cycle["min"]), milliseconds(&cycle["max"]));
        let scans = if self.state["scans"] == 1 { "scan" } else { "scans" };
        text.push_str(&format!("{} {scans} in {}, cycle {last} (min {min}, max {max})\n", self.scans_text(), self.time_text()));
        let bytes = |area: char| {
            let of_area = self.bytes.iter().filter(|(name, _)| name.starts_with(area));
            of_area.map(|(_, byte)| byte.map_or_else(|| "-".to_owned(), |byte| format!("16#{byte:02X}"))).collect::<Vec<_>>().join(" ")
        };
        text.push_str(&format!("IB0 to IB3  {}\nQB0 to QB3  {}\n", bytes('I'), bytes('Q')));
        let width = self.values.iter().map(|one| one.name.chars().count()).max().unwrap_or_default();
        for Watched { name, value, shown } in &self.values {
            let value = value.as_ref().map_or_else(|error| format!("- ({error})"), |_| shown.clone());
            text.push_str(&format!("{name:<width$}  {value}\n"));
        }
        let forced = self.forced();
        if !forced.is_empty() {
            text.push_str(&format!("Forced: {}\n", forced.join(", ")));
        }
        let clients = self.clients();
        if !clients.is_empty() {
            text.push_str("Clients:\n");
            clients.iter().for_each(|client| text.push_str(&format!("  {client}\n")));
        }
        text.push_str(&format!("Blocks: {}\nDiagnostic buffer, newest first:\n", self.blocks_text()));
        self.entries.iter().for_each(|entry| text.push_str(&format!("  {}\n", entry_text(entry))));
        text
    }
}
