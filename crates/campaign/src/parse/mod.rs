//! Reads the file of a campaign.

mod drawn;
mod properties;
#[cfg(test)]
mod tests;
mod values;

use std::ops::{Deref, DerefMut};

use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::problems::Problem;
use sieben_model::source::FileId;
use toml::de::{DeTable, DeValue};

use crate::document::{Document, Key, Value, in_order};
use crate::spec::{Exhaustive, Keep, Placed, Replay, Set, Spec, Sweep};

/// Most values of a sweep.
const VALUES_MAX: usize = 1_000_000;

/// Reads the text of a campaign. Without an error there is one.
pub fn parse(text: &str, file: FileId) -> (Option<Spec>, Vec<Diagnostic>) {
    let document = Document::new(text, file, Problem::P7157);
    let mut reader = Reader { document, spec: Spec { samples: 1, ..Spec::default() }, is_full: false };
    if let Some(table) = reader.tables(Problem::P7156) {
        reader.root(table.get_ref());
    }
    let Reader { spec, document, .. } = reader;
    let diagnostics = document.finish();
    let good = diagnostics.iter().all(|diagnostic| diagnostic.problem.severity() != Severity::Error);
    (good.then_some(spec), diagnostics)
}

struct Reader<'t> {
    document: Document<'t>,
    spec: Spec,
    /// That there are too many properties was said.
    is_full: bool,
}

/// What is read is a document.
impl<'t> Deref for Reader<'t> {
    type Target = Document<'t>;
    fn deref(&self) -> &Self::Target {
        &self.document
    }
}

impl DerefMut for Reader<'_> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.document
    }
}

/// The tables of the file with their keys; those in double brackets are lists.
const TABLES: &[(&str, &[&str])] = &[
    ("campaign", &["name", "program", "for", "seed", "samples", "settle", "keep", "replay", "within", "tolerance", "ignore"]),
    ("exhaustive", &["block", "inputs", "state"]),
    ("set", &[]),
    ("sweep", &[]),
    ("draw", &[]),
    ("fault", &["name", "chance", "signal", "fault", "from", "for"]),
    ("disturb", &["time", "bounce", "value"]),
    ("matrix", &["program"]),
    ("swarm", &["faults"]),
    ("never", &["name", "expr"]),
    ("always", &["name", "expr"]),
    ("sometimes", &["name", "expr"]),
    ("response", &["name", "when", "then", "within"]),
    ("finally", &["name", "expr"]),
    ("same", &["name", "expr"]),
    ("measure", &["name", "of", "expr", "unit"]),
];

/// Whether this is the part of a name after its point, and not a word of the table.
fn is_part(part: &Key<'_>, value: &Value<'_>) -> bool {
    !matches!(part.get_ref().as_ref(), "walk") && matches!(value.get_ref(), DeValue::Table(_))
}

impl Reader<'_> {
    fn root(&mut self, root: &DeTable<'_>) {
        let names: Vec<&str> = TABLES.iter().map(|(name, _)| *name).collect();
        for (key, value) in in_order(root) {
            let Some(&(table, keys)) = TABLES.iter().find(|(name, _)| name == key.get_ref()) else {
                self.unknown("", key, &names);
                continue;
            };
            let is_list = matches!(table, "fault" | "never" | "always" | "sometimes" | "response" | "finally" | "same" | "measure");
            match value.get_ref() {
                DeValue::Table(inner) if matches!(table, "set" | "sweep" | "draw") => self.named(table, inner),
                DeValue::Table(inner) if !is_list => self.table(table, keys, inner),
                DeValue::Array(items) if is_list => {
                    for item in items {
                        match item.get_ref() {
                            DeValue::Table(inner) => self.item(table, keys, item, inner),
                            _ => self.wrong(item, format!("write `[[{table}]]` on a line of its own, and its keys below")),
                        }
                    }
                }
                _ if is_list => {
                    self.wrong(value, format!("there can be several of these: write `[[{table}]]` in two brackets on a line of its own"))
                }
                _ => self.wrong(value, format!("`{table}` is a table: write `[{table}]` on a line of its own, and its keys below")),
            }
        }
        self.together(root);
    }

    /// A table whose keys are names of the program.
    fn named(&mut self, table: &str, content: &DeTable<'_>) {
        for (key, value) in in_order(content) {
            match (table, value.get_ref()) {
                // `Recipe.gain = …` without quotes is a table `Recipe` to TOML.
                ("sweep" | "draw", DeValue::Table(inner)) if inner.len() == 1 && inner.iter().all(|(part, value)| is_part(part, value)) => {
                    let part = inner.iter().next().map_or("", |(part, _)| part.get_ref());
                    let message = format!("a name with a point stands in quotes: `\"{}.{part}\" = …`", key.get_ref());
                    self.document.wrong_at(self.document.span(key.span()), message);
                }
                ("set", DeValue::Table(_)) => {
                    let message =
                        format!("`{}` has no single value; a name with a point stands in quotes: `\"Recipe.gain\" = 4.0`", key.get_ref());
                    self.document.wrong_at(self.document.span(key.span()), message);
                }
                ("set", _) => {
                    if let Some(set) = self.constant(value) {
                        let name = self.placed(key);
                        self.spec.set.push(Set { name, value: set });
                    }
                }
                ("sweep", _) => self.sweep(key, value),
                _ => self.draw(key, value),
            }
        }
    }

    fn table(&mut self, table: &str, keys: &[&str], content: &DeTable<'_>) {
        for (key, value) in in_order(content) {
            let name: &str = key.get_ref();
            if !keys.contains(&name) {
                self.unknown(table, key, keys);
                continue;
            }
            match (table, name) {
                ("campaign", "name") => self.spec.name = self.string(value, name).map(|placed| placed.text),
                ("campaign", "program") => {
                    let program = self.string(value, name);
                    self.spec.programs.extend(program);
                }
                ("campaign", "for") => self.spec.for_us = self.duration(value, name),
                ("campaign", "seed") => self.spec.seed = self.whole(value, name, 0).unwrap_or(0),
                ("campaign", "samples") => self.spec.samples = self.whole(value, name, 1).unwrap_or(1),
                ("campaign", "settle") => self.spec.settle_us = self.duration(value, name).unwrap_or(0),
                ("campaign", "keep") => self.keep(value),
                ("campaign", "replay") => {
                    let scenario = self.string(value, name);
                    self.spec.replay = scenario.map(|scenario| Replay { scenario, within_us: 0, tolerance: None, ignore: Vec::new() });
                }
                // With the recording, which may stand after them.
                ("campaign", _) => {}
                ("exhaustive", "state") => self.state(value),
                ("exhaustive", "block") => {
                    let block = self.string(value, name);
                    self.exhaustive().block = block;
                }
                ("exhaustive", _) => {
                    let inputs = self.strings(value, name);
                    self.exhaustive().inputs = inputs;
                }
                ("disturb", _) => self.disturb(name, value),
                ("matrix", _) => {
                    let programs = self.strings(value, name);
                    self.spec.programs.extend(programs);
                }
                _ => match value.get_ref() {
                    DeValue::Boolean(faults) => self.spec.swarm_faults = *faults,
                    _ => self.wrong(value, "`faults` is `true` or `false`"),
                },
            }
        }
    }

    /// One of a list.
    fn item(&mut self, table: &str, keys: &[&str], item: &Value<'_>, content: &DeTable<'_>) {
        for (key, _) in in_order(content) {
            if !keys.contains(&key.get_ref().as_ref()) {
                self.unknown(table, key, keys);
            }
        }
        match table {
            "fault" => self.fault(item, content),
            "measure" => self.measure(item, content),
            kind => self.property(kind, item, content),
        }
    }

    fn exhaustive(&mut self) -> &mut Exhaustive {
        self.spec.exhaustive.get_or_insert_with(|| Exhaustive { block: None, inputs: Vec::new() })
    }

    fn keep(&mut self, value: &Value<'_>) {
        self.spec.keep = match value.get_ref() {
            DeValue::String(word) => Keep::from_word(word),
            _ => None,
        };
        if self.spec.keep.is_none() {
            self.wrong(value, "`keep` is `\"all\"` or `\"failures\"`");
        }
    }

    fn state(&mut self, value: &Value<'_>) {
        let message = match value.get_ref() {
            DeValue::String(word) if word == "initial" => return,
            DeValue::String(word) if word == "reachable" => {
                "every reachable state is not there yet: `state = \"initial\"` begins each combination after the start"
            }
            DeValue::String(word) if word == "any" => {
                "every state of the memory bits is not there yet: `state = \"initial\"` begins each combination after the start"
            }
            _ => return self.wrong(value, "`state` is `\"initial\"`: each combination begins after the start"),
        };
        self.document.diagnostics.push(Diagnostic::new(Problem::P7159, self.document.span(value.span()), message));
    }

    /// `{ from = 1.0, to = 8.0, steps = 8 }` or `{ values = [20.0, 40.0] }`, also with `unit`.
    fn sweep(&mut self, key: &Key<'_>, value: &Value<'_>) {
        const HOW: &str = "write `{ from = 1.0, to = 8.0, steps = 8 }` or `{ values = [20, 40, 80] }`";
        let DeValue::Table(inner) = value.get_ref() else {
            return self.wrong(value, format!("`{}` is swept over several values: {HOW}", key.get_ref()));
        };
        let (mut from, mut to, mut steps, mut values, mut unit, mut log) = (None, None, None, None, None, false);
        let before = self.diagnostics.len();
        for (part, value) in in_order(inner) {
            match part.get_ref().as_ref() {
                "from" => from = self.number(value, "from"),
                "to" => to = self.number(value, "to"),
                "steps" => steps = self.whole(value, "steps", 1),
                "values" => values = self.constants(value, "values"),
                "unit" => unit = self.string(value, "unit").map(|placed| placed.text),
                "log" => match value.get_ref() {
                    DeValue::Boolean(is_log) => log = *is_log,
                    _ => self.wrong(value, "`log` is `true` or `false`"),
                },
                _ => self.unknown("sweep", part, &["from", "to", "steps", "values", "unit", "log"]),
            }
        }
        let all = match (from, to, steps, values) {
            (None, None, None, Some(values)) => values,
            (Some(_), Some(_), Some(steps), None) if steps as usize > VALUES_MAX => {
                return self.wrong(value, format!("a sweep has at most {VALUES_MAX} values"));
            }
            (Some(from), Some(to), Some(_), None) if log && (from <= 0.0 || to <= 0.0) => {
                return self.wrong(value, "with `log` both `from` and `to` are greater than 0");
            }
            (Some(from), Some(to), Some(steps), None) => values::steps(from, to, steps, log),
            _ if self.diagnostics.len() > before => return,
            _ => return self.wrong(value, HOW),
        };
        let name = self.placed(key);
        self.spec.sweep.push(Sweep { name, values: all, unit });
    }

    /// What keys of several tables have to do with each other.
    fn together(&mut self, root: &DeTable<'_>) {
        self.replaying(root);
        if self.spec.programs.is_empty() {
            let span = root.iter().map(|(key, _)| key.span()).min_by_key(|span| span.start);
            let span = self.span(span.unwrap_or(0..0));
            self.spec.programs.push(Placed { text: ".".to_owned(), span });
        }
        let both = |table: &str| {
            root.iter().any(|(key, value)| {
                key.get_ref() == table && matches!(value.get_ref(), DeValue::Table(inner) if inner.contains_key("program"))
            })
        };
        if both("campaign") && both("matrix") {
            self.document.wrong_at(self.spec.span(), "programs stand in `[campaign]` or in `[matrix]`, not in both");
        }
        if self.spec.swarm_faults && self.spec.faults.is_empty() {
            self.document.wrong_at(self.spec.span(), "`[swarm]` chooses among faults, and there is none: `[[fault]]`");
        }
        let whole = self.spec.span();
        let keys = self.spec.set.iter().map(|set| &set.name).chain(self.spec.sweep.iter().map(|sweep| &sweep.name));
        let keys: Vec<Placed> = keys.chain(self.spec.draw.iter().map(|draw| &draw.name)).cloned().collect();
        for (index, key) in keys.iter().enumerate() {
            if keys[..index].iter().any(|before| before.text.eq_ignore_ascii_case(&key.text)) {
                self.document
                    .wrong_at(key.span, format!("`{}` has a value already: it stands in one of `[set]`, `[sweep]` and `[draw]`", key.text));
            }
        }
        if let Some(exhaustive) = &self.spec.exhaustive
            && exhaustive.inputs.is_empty()
        {
            self.document.wrong_at(whole, "`[exhaustive]` needs its bits: `inputs = [\"Start\", \"Stop\", \"I 0.0..I 0.7\"]`");
        }
        let judged = !self.spec.properties.is_empty() || !self.spec.measures.is_empty() || self.spec.replay.is_some();
        if self.diagnostics.is_empty() && !judged {
            let message = "nothing is asked of the scenarios";
            let help = "say what must never be: `[[never]]` with `name = \"short circuit\"` and `expr = \"Star AND Delta\"`";
            self.document.diagnostics.push(Diagnostic::new(Problem::P7157, whole, message).help(help));
        }
        if self.spec.programs.len() < 2
            && let Some(same) = self.spec.properties.iter().find(|property| property.kind == crate::spec::PropertyKind::Same)
        {
            self.document.wrong_at(same.span, "`[[same]]` compares programs: `[matrix]` with `program = [\"old\", \"new\"]` names them");
        }
    }

    /// What belongs to a recording.
    fn replaying(&mut self, root: &DeTable<'_>) {
        let campaign = root.iter().find(|(key, _)| key.get_ref() == "campaign").map(|(_, value)| value.get_ref());
        let Some(DeValue::Table(campaign)) = campaign else { return self.without_recording() };
        for (key, value) in in_order(campaign) {
            let name: &str = key.get_ref();
            if !matches!(name, "within" | "tolerance" | "ignore") {
                continue;
            }
            if self.spec.replay.is_none() {
                let message = format!("`{name}` belongs to a recording: `replay = \"plant.scenario\"` names it");
                self.document.wrong_at(self.document.span(key.span()), message);
                continue;
            }
            let (mut within, mut tolerance, mut ignore) = (None, None, None);
            match name {
                "within" => within = self.duration(value, name),
                "tolerance" => tolerance = self.number(value, name),
                _ => ignore = Some(self.strings(value, name)),
            }
            if let Some(replay) = &mut self.spec.replay {
                replay.within_us = within.unwrap_or(replay.within_us);
                replay.tolerance = tolerance.or(replay.tolerance);
                replay.ignore.extend(ignore.into_iter().flatten().map(|placed| placed.text));
            }
        }
        self.without_recording();
        if let (Some(replay), Some(_)) = (&self.spec.replay, self.spec.for_us) {
            self.document.wrong_at(replay.scenario.span, "a recording is as long as it is: leave `for` out");
        }
        if let (Some(replay), Some(_)) = (&self.spec.replay, &self.spec.exhaustive) {
            let message = "a recording has its inputs: `[exhaustive]` has none to go through";
            self.document.diagnostics.push(Diagnostic::new(Problem::P7159, replay.scenario.span, message));
        }
    }

    fn without_recording(&mut self) {
        if self.spec.disturb.is_some() && self.spec.replay.is_none() {
            let span = self.spec.span();
            self.document.wrong_at(span, "`[disturb]` disturbs a recording: `replay = \"plant.scenario\"` in `[campaign]` names it");
        }
    }
}
