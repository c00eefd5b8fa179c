//! Reads the file of a fleet.

use std::ops::{Deref, DerefMut};

use sieben_campaign::document::{Document, Key, Value, in_order};
use sieben_campaign::spec::Placed;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::nearest::{nearest, one_of};
use sieben_model::problems::Problem;
use sieben_model::source::FileId;
use toml::de::{DeTable, DeValue};

use super::endpoint::{Endpoint, Index};
use super::spec::{CONTROLLERS_MAX, Controllers, LATENCY_US_MAX, LATENCY_US_MIN, LINKS_MAX, Link, Spec};

/// Reads the text of a fleet. Without an error there is one.
pub fn parse(text: &str, file: FileId) -> (Option<Spec>, Vec<Diagnostic>) {
    let mut reader = Reader { document: Document::new(text, file, Problem::P7171), spec: Spec::default(), knows_all: true };
    if let Some(table) = reader.tables(Problem::P7170) {
        reader.root(table.get_ref());
    }
    let Reader { document, spec, .. } = reader;
    let diagnostics = document.finish();
    let good = diagnostics.iter().all(|diagnostic| diagnostic.problem.severity() != Severity::Error);
    (good.then_some(spec), diagnostics)
}

const FLEET: &[&str] = &["name", "cycle", "seed"];
const CONTROLLER: &[&str] = &["name", "count", "program"];
const LINK: &[&str] = &["from", "to", "latency", "kind"];

struct Reader<'t> {
    document: Document<'t>,
    spec: Spec,
    /// Whether all controllers were understood: else a link may mean one that was not.
    knows_all: bool,
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

impl Reader<'_> {
    fn root(&mut self, root: &DeTable<'_>) {
        // Links name controllers, which may stand after them.
        let mut links = Vec::new();
        for (key, value) in in_order(root) {
            match (key.get_ref().as_ref(), value.get_ref()) {
                ("fleet", DeValue::Table(inner)) => self.fleet(inner),
                ("fleet", _) => self.wrong(value, "`fleet` is a table: write `[fleet]` on a line of its own, and its keys below"),
                (name @ ("controller" | "link"), DeValue::Array(items)) => {
                    for item in items {
                        match item.get_ref() {
                            DeValue::Table(inner) if name == "link" => links.push((item, inner)),
                            DeValue::Table(inner) => {
                                let before = self.diagnostics.len();
                                self.controllers(item, inner);
                                self.knows_all &= self.diagnostics.len() == before;
                            }
                            _ => self.wrong(item, format!("write `[[{name}]]` on a line of its own, and its keys below")),
                        }
                    }
                }
                (name @ ("controller" | "link"), _) => {
                    self.wrong(value, format!("there can be several of these: write `[[{name}]]` in two brackets on a line of its own"));
                }
                _ => self.unknown("", key, &["fleet", "controller", "link"]),
            }
        }
        links.into_iter().for_each(|(item, inner)| self.link(item, inner));
        if self.spec.controllers.is_empty() && self.diagnostics.is_empty() {
            let span = self.span(0..0);
            let message = "the fleet has no controllers: `[[controller]]` with `name`, `count` and `program`";
            self.wrong_at(span, message);
        }
        if self.spec.links.len() > LINKS_MAX {
            let span = self.spec.links[LINKS_MAX].span;
            self.wrong_at(span, format!("a fleet has at most {LINKS_MAX} links; `station[i]` stands for all stations"));
        }
    }

    fn fleet(&mut self, content: &DeTable<'_>) {
        for (key, value) in in_order(content) {
            match key.get_ref().as_ref() {
                "name" => self.spec.name = self.string(value, "name").map(|placed| placed.text),
                "seed" => self.spec.seed = self.whole(value, "seed", 0).unwrap_or(0),
                "cycle" => match self.duration(value, "cycle") {
                    Some(0) => self.wrong(value, "a cycle takes time: `cycle = \"10ms\"`"),
                    cycle => self.spec.cycle_us = cycle,
                },
                _ => self.unknown("fleet", key, FLEET),
            }
        }
    }

    fn controllers(&mut self, item: &Value<'_>, content: &DeTable<'_>) {
        let (mut name, mut count, mut program) = (None, None, None);
        let before = self.diagnostics.len();
        for (key, value) in in_order(content) {
            match key.get_ref().as_ref() {
                "name" => name = self.controller_name(value),
                "program" => program = self.string(value, "program"),
                "count" => {
                    let whole = self.whole(value, "count", 1);
                    match whole.map(u32::try_from) {
                        Some(Ok(whole)) if whole <= CONTROLLERS_MAX => count = Some(whole),
                        Some(_) => self.wrong(value, format!("a fleet has at most {CONTROLLERS_MAX} controllers")),
                        None => {}
                    }
                }
                _ => self.unknown("controller", key, CONTROLLER),
            }
        }
        let (Some(name), Some(program)) = (name, program) else {
            if self.diagnostics.len() == before {
                self.wrong(item, "controllers have `name` and `program`: `name = \"station\"`, `count = 100`, `program = \"station\"`");
            }
            return;
        };
        if self.spec.controllers.iter().any(|known| known.name.text == name.text) {
            return self.wrong_at(name.span, format!("there are controllers `{}` already: give these another `name`", name.text));
        }
        let controllers = Controllers { name, count, program };
        let all = self.spec.controllers.iter().map(Controllers::len).fold(controllers.len(), u32::saturating_add);
        if all > CONTROLLERS_MAX {
            return self.wrong(item, format!("with these the fleet has {all} controllers; it has at most {CONTROLLERS_MAX}"));
        }
        self.spec.controllers.push(controllers);
    }

    fn controller_name(&mut self, value: &Value<'_>) -> Option<Placed> {
        let name = self.string(value, "name")?;
        let good = name.text.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '-');
        if !good {
            self.wrong_at(name.span, format!("`{}` cannot be the name of controllers: use letters, digits, `-` and `_`", name.text));
        }
        good.then_some(name)
    }

    fn link(&mut self, item: &Value<'_>, content: &DeTable<'_>) {
        let (mut from, mut to, mut latency) = (None, None, None);
        let before = self.diagnostics.len();
        for (key, value) in in_order(content) {
            match key.get_ref().as_ref() {
                "from" => from = self.endpoint(value, "from"),
                "to" => to = self.endpoint(value, "to"),
                "latency" => latency = self.latency(value),
                "kind" => self.kind(key, value),
                _ => self.unknown("link", key, LINK),
            }
        }
        let (Some(from), Some(to), Some(latency_us)) = (from, to, latency) else {
            if self.diagnostics.len() == before && self.knows_all {
                const HOW: &str = "a link has `from`, `to` and `latency`: `from = \"station[i].QB 0\"`, `to = \"station[i+1].IB 0\"`, `latency = \"10ms\"`";
                self.wrong(item, HOW);
            }
            return;
        };
        if self.diagnostics.len() == before {
            let span = self.span(item.span());
            self.spec.links.push(Link { from, to, latency_us, span });
        }
    }

    fn kind(&mut self, key: &Key<'_>, value: &Value<'_>) {
        let message = match value.get_ref() {
            DeValue::String(kind) if kind == "io" => return,
            DeValue::String(kind) if kind == "s7" || kind == "modbus" => {
                format!("links of the kind `{kind}` are not there yet: one without `kind` carries a value from output to input")
            }
            _ => return self.wrong(value, "`kind` is `\"io\"`: from outputs to inputs; it can be left out"),
        };
        let span = self.span(key.span().start..value.span().end);
        self.document.diagnostics.push(Diagnostic::new(Problem::P7173, span, message));
    }

    fn latency(&mut self, value: &Value<'_>) -> Option<u64> {
        let latency = self.duration(value, "latency")?;
        if latency < LATENCY_US_MIN {
            self.wrong(value, "a link takes at least 1 ms: controllers run so long without looking at one another");
            return None;
        }
        if latency > LATENCY_US_MAX {
            self.wrong(value, format!("a link takes at most {} s: what is under way has to be kept", LATENCY_US_MAX / 1_000_000));
            return None;
        }
        Some(latency)
    }

    fn endpoint(&mut self, value: &Value<'_>, key: &str) -> Option<Endpoint> {
        let placed = self.string(value, key)?;
        let endpoint = match Endpoint::parse(&placed) {
            Ok(endpoint) => endpoint,
            Err(message) => {
                self.wrong_at(placed.span, message);
                return None;
            }
        };
        if !self.knows_all {
            return None;
        }
        let Endpoint { controller, index, .. } = &endpoint;
        let all = &self.spec.controllers;
        let told = |message: String| Diagnostic::new(Problem::P7172, controller.span, message);
        let Some(controllers) = all.iter().find(|known| known.name.text == controller.text) else {
            let names = || all.iter().map(|known| known.name.text.as_str());
            let diagnostic = told(format!("there are no controllers `{}`", controller.text));
            let diagnostic = match nearest(&controller.text, names()) {
                Some(near) => diagnostic.help(format!("did you mean `{near}`?")),
                None if all.is_empty() => diagnostic,
                None => diagnostic.help(format!("there are {}", one_of(names()))),
            };
            self.document.diagnostics.push(diagnostic);
            return None;
        };
        let name = &controllers.name.text;
        let message = match (index, controllers.count) {
            (Index::Only, Some(count)) => {
                format!("there are {count} of `{name}`: `{name}[i]` means each of them, `{name}[0]` the first")
            }
            (Index::At(_) | Index::Each(_), None) => format!("there is one `{name}`: write it without brackets, or give it a `count`"),
            (&Index::At(at), Some(count)) if at >= count => {
                format!("there is no `{name}[{at}]`: they are `{name}[0]` to `{name}[{}]`", count - 1)
            }
            _ => return Some(endpoint),
        };
        let diagnostic = told(message);
        self.document.diagnostics.push(diagnostic);
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(text: &str) -> Vec<String> {
        parse(text, FileId(0)).1.into_iter().map(|diagnostic| diagnostic.message).collect()
    }

    const GOOD: &str = "[fleet]\ncycle = \"10ms\"\n[[link]]\nfrom = \"station[i].QB 0\"\nto = \"station[i+1].IB 0\"\nlatency = \"10ms\"\n\
                        [[controller]]\nname = \"station\"\ncount = 10_000\nprogram = \"station\"\n[[controller]]\nname = \"master\"\nprogram = \".\"\n";

    #[test]
    fn a_file_becomes_data_with_its_names_in_place() {
        let (spec, diagnostics) = parse(GOOD, FileId(0));
        assert_eq!(diagnostics, []);
        let spec = spec.expect("a fleet");
        assert_eq!((spec.cycle_us, spec.controllers.len(), spec.links.len()), (Some(10_000), 2, 1));
        assert_eq!((spec.controllers[0].name_of(42), spec.controllers[1].name_of(0)), ("station[42]".to_owned(), "master".to_owned()));
        let link = &spec.links[0];
        assert_eq!((link.from.index, link.to.index, link.latency_us), (Index::Each(0), Index::Each(1), 10_000));
        assert_eq!(&GOOD[link.to.name.span.start as usize..link.to.name.span.end as usize], "IB 0");
    }

    #[test]
    fn each_mistake_is_one_sentence_at_its_place() {
        for (before, after, message) in [
            ("cycle", "cycel", "there is no key `cycel` in `[fleet]`"),
            ("[fleet]", "[flet]", "there is no key `flet`"),
            ("\"10ms\"\n[[link", "\"0s\"\n[[link", "a cycle takes time: `cycle = \"10ms\"`"),
            ("10_000", "100_001", "a fleet has at most 100000 controllers"),
            ("10_000", "100_000", "with these the fleet has 100001 controllers; it has at most 100000"),
            ("10_000", "0", "`count` is a whole number from 1 on: `count = 7`"),
            ("\"master\"", "\"station\"", "there are controllers `station` already: give these another `name`"),
            ("\"master\"", "\"a.b\"", "`a.b` cannot be the name of controllers: use letters, digits, `-` and `_`"),
            (
                "latency = \"10ms\"",
                "latency = \"500us\"",
                "a link takes at least 1 ms: controllers run so long without looking at one another",
            ),
            ("latency = \"10ms\"", "latency = \"2h\"", "a link takes at most 60 s: what is under way has to be kept"),
            ("station[i]", "staton[i]", "there are no controllers `staton`"),
            ("station[i]", "station", "there are 10000 of `station`: `station[i]` means each of them, `station[0]` the first"),
            ("station[i]", "master[i]", "there is one `master`: write it without brackets, or give it a `count`"),
            ("station[i]", "station[10000]", "there is no `station[10000]`: they are `station[0]` to `station[9999]`"),
            ("[[controller]]", "[controller]", "the file is not valid TOML: duplicate key; expected table, found array"),
            (
                "latency",
                "kind = \"s7\"\nlatency",
                "links of the kind `s7` are not there yet: one without `kind` carries a value from output to input",
            ),
            (
                "latency",
                "kind = \"modbus\"\nlatency",
                "links of the kind `modbus` are not there yet: one without `kind` carries a value from output to input",
            ),
            ("latency", "kind = 1\nlatency", "`kind` is `\"io\"`: from outputs to inputs; it can be left out"),
        ] {
            let text = GOOD.replacen(before, after, 1);
            let told = messages(&text);
            if before == "[[controller]]" {
                assert!(told[0].starts_with("the file is not valid TOML"), "{told:?}");
            } else {
                assert_eq!(told, [message], "{text}");
            }
        }
        assert_eq!(messages(""), ["the fleet has no controllers: `[[controller]]` with `name`, `count` and `program`"]);
    }

    #[test]
    fn of_a_million_mistakes_a_hundred_are_told() {
        let text: String = (0..1_000_000).map(|number| format!("a{number} = 1\n")).collect();
        let told = messages(&text);
        assert_eq!(told.len(), 101);
        assert_eq!(told[100], "and 999900 more after this one");
    }
}
