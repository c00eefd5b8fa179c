//! What is seen of a run: asked for again and again, and kept from look to look.

use std::collections::{BTreeMap, HashMap, VecDeque};
use std::io;

use serde_json::{Value, json};
use sieben_model::format::Format;
use sieben_workspace::control::LINE_BYTES_MAX;
use sieben_workspace::gate::ITEMS_MAX;

use super::asks::{Asks, asked};
use super::rows::{Group, Row, Shown};

/// Rows of inputs, of outputs and of values that are kept: more than anyone moves through, and few enough to be read for each picture.
const GROUP_ROWS_MAX: usize = 500;
/// Rows of a long table that are looked through: inputs and outputs stand first in most, and each part that is asked for takes as long as the whole.
const TABLE_ROWS_MAX: u64 = 4_000;
/// Bytes of names in one request: half of a line that is accepted, so that what is escaped in it fits too.
const NAMES_BYTES_MAX: usize = LINE_BYTES_MAX / 2;
/// Changes that are kept: more than any screen shows.
const CHANGES_MAX: usize = 200;
/// Entries of the diagnostic buffer that are kept: no CPU type has more.
const ENTRIES_MAX: usize = 500;
/// Lines of a block that are listed; of a longer one the first.
const LINES_MAX: usize = 10_000;

/// A statement as a scan left it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Seen {
    pub(crate) sta: bool,
    pub(crate) rlo: bool,
    pub(crate) accu1: u32,
    /// The variable that an assignment wrote.
    pub(crate) value: Option<String>,
}

/// The block that is shown.
#[derive(Clone, Debug, Default)]
pub(crate) struct Program {
    /// `OB 1`, with its name where it has one.
    pub(crate) title: String,
    /// What it is called in requests; empty before it is known.
    pub(crate) block: String,
    /// It is listed as its source.
    pub(crate) is_source: bool,
    /// Its lines, as the answer to `listing` has them.
    pub(crate) lines: Vec<Value>,
    /// What the statements left, by number; those that were not executed are missing.
    pub(crate) seen: BTreeMap<u64, Seen>,
    /// The replay ended as the scan did.
    pub(crate) is_same: bool,
    /// The number of the sample.
    sample: u64,
}

/// What is seen of a run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Look {
    /// The answer to `state`.
    pub(crate) state: Value,
    /// The plants, as the answer to `plants` has them.
    pub(crate) plants: Vec<Value>,
    /// What can be chosen.
    pub(crate) rows: Vec<Row>,
    /// The values of the rows.
    pub(crate) shown: Vec<Shown>,
    /// What changed, the newest last.
    pub(crate) changes: VecDeque<Value>,
    newest_change: u64,
    /// The diagnostic buffer, the newest first.
    pub(crate) entries: VecDeque<Value>,
    newest_entry: u64,
    /// Blocks with statements: what they are called in requests, and how people call them.
    pub(crate) blocks: Vec<(String, String)>,
    pub(crate) program: Program,
    /// Which program the names and blocks are of.
    version: Option<u64>,
}

fn list(answer: &Value, key: &str) -> Vec<Value> {
    answer[key].as_array().cloned().unwrap_or_default()
}

impl Look {
    /// Looks at everything. `names` are what the user wants to see beside the table, `formats` by what a row is called in requests, `block` what is
    /// to be listed.
    ///
    /// # Errors
    /// The run is over, or does not answer.
    pub(crate) fn refresh(
        &mut self,
        asks: &mut dyn Asks,
        names: &[String],
        formats: &HashMap<String, Format>,
        block: Option<&str>,
    ) -> io::Result<()> {
        if let Ok(state) = asked(asks, "state", &json!({}))? {
            self.state = state;
        }
        let version = self.state["version"].as_u64();
        if self.version.is_none() || self.version != version {
            self.version = version;
            self.names(asks, names)?;
            self.blocks(asks)?;
            self.program = Program::default();
        }
        if block.is_some_and(|block| block != self.program.block) || self.program.block.is_empty() {
            self.listing(asks, block)?;
        }
        self.plants = asked(asks, "plants", &json!({}))?.map(|answer| list(&answer, "plants")).unwrap_or_default();
        self.values(asks, formats)?;
        self.changes(asks)?;
        self.entries(asks)?;
        self.status(asks)
    }

    /// The assignment table: it changes with the program.
    fn names(&mut self, asks: &mut dyn Asks, names: &[String]) -> io::Result<()> {
        self.rows.clear();
        // Many inputs leave room for outputs and values.
        let mut groups: [Vec<Row>; Group::ALL.len()] = Default::default();
        let mut keep = |row: Row| {
            let at = Group::ALL.iter().position(|group| *group == row.group);
            if let Some(rows) = at.and_then(|at| groups.get_mut(at)).filter(|rows| rows.len() < GROUP_ROWS_MAX) {
                rows.push(row);
            }
        };
        let named: Vec<Row> = names.iter().map(|name| Row::named(name)).collect();
        let mut from = Some(0);
        while let Some(first) = from {
            let Ok(answer) = asked(asks, "names", &json!({ "from": first }))? else { break };
            list(&answer, "rows").iter().filter_map(Row::of).for_each(&mut keep);
            from = answer["next"].as_u64().filter(|&next| next > first && next < TABLE_ROWS_MAX);
        }
        self.rows.extend(groups.into_iter().flatten());
        self.rows.extend(named);
        // In the order in which they are gone through; the sort keeps that of the table.
        self.rows.sort_by_key(|row| Group::ALL.iter().position(|group| *group == row.group));
        self.shown = vec![Shown::default(); self.rows.len()];
        Ok(())
    }

    fn blocks(&mut self, asks: &mut dyn Asks) -> io::Result<()> {
        let Ok(answer) = asked(asks, "blocks", &json!({}))? else { return Ok(()) };
        let has_statements = |block: &&Value| {
            let id = block["block"].as_str().unwrap_or_default();
            ["OB", "FC", "FB"].iter().any(|kind| id.starts_with(kind))
        };
        let called = |block: &Value| {
            let id = block["block"].as_str().unwrap_or_default().to_owned();
            let words = [block["name"].as_str(), block["title"].as_str()].into_iter().flatten().find(|text| !text.is_empty());
            let text = words.map_or_else(|| id.clone(), |words| format!("{id}  {words}"));
            (id, text)
        };
        self.blocks = list(&answer, "blocks").iter().filter(has_statements).map(called).collect();
        Ok(())
    }

    /// Lists a block, or the one that a screen begins with.
    fn listing(&mut self, asks: &mut dyn Asks, block: Option<&str>) -> io::Result<()> {
        let mut program = Program { is_same: true, ..Program::default() };
        let mut from = Some(0);
        while let Some(first) = from {
            let fields = block.map_or_else(|| json!({ "from": first }), |block| json!({ "block": block, "from": first }));
            let Ok(answer) = asked(asks, "listing", &fields)? else {
                // It has gone with an online change: the next look begins where a screen begins.
                program.block = block.unwrap_or("-").to_owned();
                break;
            };
            program.block = answer["block"].as_str().unwrap_or_default().to_owned();
            program.title = answer["name"].as_str().map_or_else(|| program.block.clone(), |name| format!("{} {name}", program.block));
            program.is_source = answer["form"] == "source";
            program.lines.extend(list(&answer, "lines"));
            from = answer["next"].as_u64().filter(|_| program.lines.len() < LINES_MAX);
        }
        self.program = program;
        Ok(())
    }

    fn values(&mut self, asks: &mut dyn Asks, formats: &HashMap<String, Format>) -> io::Result<()> {
        let items: Vec<String> = self.rows.iter().map(|row| row.asked(formats.get(&row.item).copied())).collect();
        let mut shown = Vec::with_capacity(items.len());
        for items in requests(&items) {
            let Ok(answer) = asked(asks, "read", &json!({ "items": items }))? else { return Ok(()) };
            let answered = list(&answer, "items");
            let rows = self.rows.iter().skip(shown.len());
            shown.extend(answered.iter().take(items.len()).zip(rows).map(|(item, row)| Shown::of(item, row)).collect::<Vec<_>>());
        }
        self.shown = shown;
        self.shown.resize(self.rows.len(), Shown::default());
        Ok(())
    }

    fn changes(&mut self, asks: &mut dyn Asks) -> io::Result<()> {
        let Ok(answer) = asked(asks, "changes", &json!({ "after": self.newest_change }))? else { return Ok(()) };
        self.changes.extend(list(&answer, "entries"));
        let surplus = self.changes.len().saturating_sub(CHANGES_MAX);
        self.changes.drain(..surplus);
        self.newest_change = answer["newest"].as_u64().unwrap_or(self.newest_change);
        Ok(())
    }

    fn entries(&mut self, asks: &mut dyn Asks) -> io::Result<()> {
        let Ok(answer) = asked(asks, "diagnostics", &json!({ "after": self.newest_entry }))? else { return Ok(()) };
        for entry in list(&answer, "entries") {
            self.entries.push_front(entry);
        }
        self.entries.truncate(ENTRIES_MAX);
        self.newest_entry = answer["newest"].as_u64().unwrap_or(self.newest_entry);
        Ok(())
    }

    /// What the statements of the block left in the newest scan that was replayed.
    fn status(&mut self, asks: &mut dyn Asks) -> io::Result<()> {
        if self.program.lines.is_empty() {
            return Ok(());
        }
        // A CPU in STOP executes nothing, also where time stands still with it and no scan comes.
        if self.word("mode") == "STOP" {
            self.program.seen.clear();
        }
        let fields = |from: u64, after: u64, block: &str| json!({ "block": block, "after": after, "from": from, "wait": false });
        let Ok(answer) = asked(asks, "status", &fields(1, self.program.sample, &self.program.block))? else {
            self.program.seen.clear();
            return Ok(());
        };
        let sample = answer["sample"].as_u64().unwrap_or_default();
        if sample == self.program.sample {
            return Ok(());
        }
        let before = std::mem::replace(&mut self.program.sample, sample);
        self.program.is_same = answer["same"] != false;
        self.program.seen.clear();
        let mut part = Some(answer);
        while let Some(answer) = part.take() {
            self.program.seen.extend(answer["statements"].as_array().into_iter().flatten().filter_map(seen));
            if let Some(next) = answer["next"].as_u64() {
                let next = asked(asks, "status", &fields(next, before, &self.program.block))?;
                // A newer sample takes the place of this one with the next look.
                part = next.ok().filter(|answer| answer["sample"].as_u64() == Some(sample));
            }
        }
        Ok(())
    }

    /// A field of the state that is text.
    pub(crate) fn word(&self, key: &str) -> &str {
        self.state[key].as_str().unwrap_or_default()
    }

    /// Which CPU of the run was looked at; `None` before the first look.
    pub(crate) fn run(&self) -> Option<u64> {
        self.state["run"].as_u64()
    }

    /// Whether time stands still.
    pub(crate) fn is_paused(&self) -> bool {
        self.state["paused"] == true
    }

    /// The time of the CPU in milliseconds.
    pub(crate) fn time_ms(&self) -> u64 {
        self.state["time_ms"].as_f64().unwrap_or_default() as u64
    }
}

/// Names in so many parts that each fits into a request.
fn requests(names: &[String]) -> Vec<&[String]> {
    let mut parts = Vec::new();
    let mut rest = names;
    while !rest.is_empty() {
        let mut bytes = 0;
        let fits = |name: &&String| {
            bytes += name.len() + 3;
            bytes <= NAMES_BYTES_MAX
        };
        let count = rest.iter().take(ITEMS_MAX).take_while(fits).count().max(1);
        let (part, others) = rest.split_at(count);
        parts.push(part);
        rest = others;
    }
    parts
}

/// Where STA stands among the nine characters of a status word.
const STA: usize = 6;

/// A statement of the answer to `status`.
fn seen(statement: &Value) -> Option<(u64, Seen)> {
    let after = &statement["after"];
    let hex = |word: &Value| u32::from_str_radix(word.as_str()?.strip_prefix("16#")?, 16).ok();
    let seen = Seen {
        sta: after["stw"].as_str().and_then(|text| text.as_bytes().get(STA)) == Some(&b'1'),
        rlo: after["rlo"].as_u64().is_some_and(|rlo| rlo != 0),
        accu1: hex(&after["accu1"]).unwrap_or_default(),
        value: statement["shown"].as_str().map(str::to_owned),
    };
    Some((statement["statement"].as_u64()?, seen))
}
