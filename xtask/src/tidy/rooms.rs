//! Which room of a crate may use which: the drawings in ARCHITECTURE.md, held against the sources.

mod uses;

use std::collections::{BTreeMap, BTreeSet};

use super::Finding;
use crate::markdown;
use crate::workspace::TextFile;
use uses::Uses;

/// The page with the drawings: blocks of code that begin with three backticks, `rooms` and the crate.
const PAGE: &str = "ARCHITECTURE.md";

/// The word behind the backticks.
const LANGUAGE: &str = "rooms";

/// Crates whose rooms are drawn.
const DRAWN: &[&str] = &["lang", "cpu", "app", "workspace", "farm"];

/// The rooms of a crate as they are drawn, from the top.
///
/// A line is the number of a level and its rooms, two blanks between them: `2  io  process_image → io  (what lies outside)`.
/// A room is a module with all that is in it, `st/check` one inside another. It may use the rooms of all levels below its own, and those beside it
/// to which an arrow leads. What stands in brackets is for the reader.
#[derive(Debug, Default)]
struct Drawing {
    /// The level of each room.
    levels: BTreeMap<String, usize>,
    /// Arrows to neighbours.
    beside: BTreeSet<(String, String)>,
}

impl Drawing {
    /// Reads a drawing; what is wrong in it comes with its line, counted from 0.
    fn read(text: &str) -> (Self, Vec<(usize, String)>) {
        let mut drawing = Self::default();
        let mut wrong = Vec::new();
        let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
        for (index, line) in lines.iter().enumerate() {
            let expected = lines.len() - 1 - index;
            let (number, rooms) = line.trim().split_once(' ').unwrap_or((line, ""));
            if number.parse() != Ok(expected) {
                wrong.push((index, format!("this is level {expected}, counted from the last line, which is 0")));
            }
            let rooms = rooms.split_once('(').map_or(rooms, |(rooms, _)| rooms);
            for room in rooms.split("  ").map(str::trim).filter(|room| !room.is_empty()) {
                let (name, beside) = room.split_once('→').unwrap_or((room, ""));
                let name = name.trim().to_owned();
                drawing.beside.extend(beside.split(',').map(str::trim).filter(|to| !to.is_empty()).map(|to| (name.clone(), to.to_owned())));
                if drawing.levels.insert(name.clone(), expected).is_some() {
                    wrong.push((index, format!("`{name}` is drawn twice")));
                }
            }
        }
        for (from, to) in &drawing.beside {
            let line = drawing.levels.get(from).map_or(0, |level| lines.len() - 1 - level);
            if drawing.levels.get(from) != drawing.levels.get(to) {
                wrong.push((
                    line,
                    format!("`{from} → {to}`: such an arrow leads to a room of the same level; all levels below are free anyway"),
                ));
            } else if drawing.leads(to, from, drawing.beside.len()) {
                wrong.push((line, format!("`{from} → {to}`: the arrows run in a circle")));
            }
        }
        (drawing, wrong)
    }

    /// Whether arrows between neighbours lead from one to the other, over so many others at most.
    fn leads(&self, from: &str, to: &str, steps: usize) -> bool {
        from == to || steps > 0 && self.beside.iter().any(|(one, next)| one == from && self.leads(next, to, steps - 1))
    }

    /// The innermost room around a module or an item.
    fn room(&self, path: &[String]) -> Option<&str> {
        let candidates = (1..=path.len()).rev().map(|length| path[..length].join("/"));
        candidates.into_iter().find_map(|name| self.levels.get_key_value(&name)).map(|(name, _)| name.as_str())
    }

    /// Whether an arrow leads from one room to another, or they are the same.
    fn allows(&self, from: &str, to: &str) -> bool {
        from == to || self.levels[from] > self.levels[to] || self.beside.contains(&(from.to_owned(), to.to_owned()))
    }
}

/// Checks the crates that are drawn.
pub fn check(files: &[TextFile]) -> Vec<Finding> {
    let Some(page) = files.iter().find(|file| file.path == PAGE) else { return Vec::new() };
    let fences = markdown::read(&page.text).fences;
    let mut findings = Vec::new();
    for name in DRAWN {
        let Some(fence) = fences.iter().find(|fence| fence.language == LANGUAGE && fence.name == *name) else {
            findings.push(Finding::file(PAGE, format!("the rooms of `{name}` are not drawn: a block of code `{LANGUAGE} {name}`")));
            continue;
        };
        let (drawing, wrong) = Drawing::read(&fence.text);
        findings.extend(wrong.into_iter().map(|(line, message)| Finding::line(PAGE, fence.line + 1 + line, message)));
        findings.extend(crate_rooms(name, &drawing, files));
    }
    findings
}

/// Holds the sources of a crate against its drawing.
fn crate_rooms(name: &str, drawing: &Drawing, files: &[TextFile]) -> Vec<Finding> {
    let folder = format!("crates/{name}/src/");
    let sources: Vec<(&TextFile, Vec<String>, Uses)> = files
        .iter()
        .filter_map(|file| {
            let module = module(file.path.strip_prefix(&folder)?)?;
            let uses = uses::read(&file.text, &module);
            Some((file, module, uses))
        })
        .collect();
    let tests: Vec<&Vec<String>> = sources.iter().flat_map(|(_, _, uses)| &uses.tests).collect();
    let is_test = |module: &[String]| tests.iter().any(|test| module.starts_with(test));
    let modules: BTreeSet<&str> = sources.iter().filter_map(|(_, module, _)| module.first()).map(String::as_str).collect();
    // Names that the root of the crate gives to what lies in a room.
    let root = sources.iter().filter(|(_, module, _)| module.is_empty()).flat_map(|(_, _, uses)| &uses.named);
    let given: BTreeMap<&str, &[String]> =
        root.filter_map(|one| Some((one.alias.as_deref().or(one.path.last().map(String::as_str))?, one.path.as_slice()))).collect();
    let mut findings = Vec::new();
    for (file, module, uses) in sources.iter().filter(|(_, module, _)| !module.is_empty() && !is_test(module)) {
        let Some(from) = drawing.room(module) else {
            let message = format!("`{}` has no place in the drawing of `{name}` in {PAGE}; say there what it stands on", module[0]);
            findings.push(Finding::file(&file.path, message));
            continue;
        };
        for one in &uses.named {
            let first = one.path.first().map_or("", String::as_str);
            let path = if modules.contains(first) { &one.path } else { given.get(first).copied().unwrap_or(&one.path) };
            let Some(to) = drawing.room(path) else {
                // A module without a place is found where its file is.
                if !path.first().is_some_and(|first| modules.contains(first.as_str())) {
                    let message = format!(
                        "`{first}` is an item of the root of the crate, which stands above all rooms; hand it down, or give it a room"
                    );
                    findings.push(Finding::line(&file.path, one.line, message));
                }
                continue;
            };
            if !drawing.allows(from, to) {
                let message = format!(
                    "no arrow leads from `{from}` to `{to}` in the drawing of `{name}` in {PAGE}; one of the two lies in the wrong room"
                );
                findings.push(Finding::line(&file.path, one.line, message));
            }
        }
    }
    for room in drawing.levels.keys() {
        let is_there = sources.iter().any(|(_, module, _)| module.join("/") == *room || module.join("/").starts_with(&format!("{room}/")));
        if !is_there {
            findings.push(Finding::file(PAGE, format!("`{room}` is drawn as a room of `{name}`, and there is no such module")));
        }
    }
    findings.sort();
    findings.dedup();
    findings
}

/// The path of the module in a file of `src`; empty for the root of the crate, `None` for what is no source.
fn module(path: &str) -> Option<Vec<String>> {
    let path = path.strip_suffix(".rs")?;
    if matches!(path, "lib" | "main") {
        return Some(Vec::new());
    }
    Some(path.strip_suffix("/mod").unwrap_or(path).split('/').map(str::to_owned).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is found in a crate of these files with this drawing.
    fn found(drawing: &str, files: &[(&str, &str)]) -> Vec<String> {
        let (drawing, wrong) = Drawing::read(drawing);
        assert!(wrong.is_empty(), "{wrong:?}");
        let file = |(path, text): &(&str, &str)| TextFile { path: format!("crates/x/src/{path}"), text: (*text).to_owned() };
        let files: Vec<TextFile> = files.iter().map(file).collect();
        crate_rooms("x", &drawing, &files).iter().map(Finding::to_string).collect()
    }

    const DRAWING: &str = "2  cpu/parts\n1  cpu  io → tape  tape  (what it runs on)\n0  mode\n";
    const ROOT: (&str, &str) = ("lib.rs", "mod cpu;\nmod io;\nmod mode;\nmod tape;\npub use mode::Mode;\n");

    #[test]
    fn an_arrow_that_is_not_drawn_is_found() {
        let files = |io: &'static str| [ROOT, ("cpu.rs", ""), ("cpu/parts.rs", ""), ("tape.rs", ""), ("mode.rs", ""), ("io.rs", io)];
        for (io, arrow) in [
            ("use crate::mode::Mode;\nuse crate::tape::{Tape, self};\nuse crate::Mode;\nuse crate::io::x;", None),
            ("fn f() {\n    crate::cpu::stop();\n}", Some(":2: no arrow leads from `io` to `cpu` ")),
            ("use crate::cpu::parts::Part;", Some(":1: no arrow leads from `io` to `cpu/parts` ")),
            ("use super::cpu;", Some(":1: no arrow leads from `io` to `cpu` ")),
            ("use crate::helper;", Some(":1: `helper` is an item of the root ")),
            ("#[cfg(test)]\nmod tests {\n    use crate::cpu::Cpu;\n}", None),
        ] {
            let found = found(DRAWING, &files(io));
            assert_eq!(found.len(), usize::from(arrow.is_some()), "{io}: {found:?}");
            assert!(arrow.is_none_or(|arrow| found[0].starts_with(&format!("crates/x/src/io.rs{arrow}"))), "{io}: {found:?}");
        }
    }

    #[test]
    fn a_module_without_a_place_and_a_place_without_a_module_are_found() {
        let files = [ROOT, ("cpu.rs", ""), ("cpu/parts.rs", ""), ("tape.rs", ""), ("mode.rs", ""), ("new/mod.rs", ""), ("new/part.rs", "")];
        let found = found(DRAWING, &files);
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found[0].contains("`io` is drawn") && found[1].contains("`new` has no place"), "{found:?}");
    }

    #[test]
    fn a_drawing_that_cannot_be_true_is_found() {
        for (drawing, message) in [
            ("1  a\n1  b", "this is level 0"),
            ("1  a\n0  b  a", "`a` is drawn twice"),
            ("1  a → b\n0  b", "the same level"),
            ("0  a → b  b → c  c → a", "in a circle"),
        ] {
            let (_, wrong) = Drawing::read(drawing);
            assert!(wrong.iter().any(|(_, text)| text.contains(message)), "{drawing}: {wrong:?}");
        }
        assert!(Drawing::read("1  a → b, c  b  c → b\n0  d\n").1.is_empty());
    }
}
