//! Asks a service by its name and writes down what it answers.

use std::fmt::Write as _;

use sieben_ide::editing::completion::completion;
use sieben_ide::editing::definition::{declaration, definition, type_definition};
use sieben_ide::editing::highlight::highlight;
use sieben_ide::editing::hints::hints;
use sieben_ide::editing::hover::hover;
use sieben_ide::editing::linked::linked;
use sieben_ide::editing::references::{Use, references};
use sieben_ide::editing::rename::{prepare, rename};
use sieben_ide::editing::signature::signature;
use sieben_ide::editing::symbols::workspace_symbols;
use sieben_ide::editing::{Bytes, Edit, Place, Position, Snapshot, actions, calls};

fn place(snapshot: &Snapshot, place: &Place) -> String {
    let text = snapshot.text(place.text).expect("the place is in a text");
    let before = text.text.get(..place.range.start).expect("the place begins a character");
    let written = text.text.get(place.range.start..place.range.end).expect("the place ends a character");
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
    let written = if written.contains('\n') { "…" } else { written };
    format!("{}:{line}:{column} {written}", text.name)
}

fn uses(snapshot: &Snapshot, uses: Vec<Use>) -> String {
    let line = |one: &Use| format!("{} {:?} {:?}\n", place(snapshot, &one.place), one.access, one.through);
    uses.iter().map(line).collect()
}

fn edits(snapshot: &Snapshot, edits: &[Edit]) -> String {
    edits.iter().map(|edit| format!("{} → {}\n", place(snapshot, &edit.place), edit.new_text.replace('\n', "⏎"))).collect()
}

/// What a service answers; after its name may stand an argument.
pub(crate) fn answer(snapshot: &Snapshot, mark: Position, question: &str) -> String {
    let (service, argument) = question.split_once(' ').unwrap_or((question, ""));
    let here = |range: Bytes| place(snapshot, &Place { text: mark.text, range });
    let mut out = String::new();
    match service {
        "definition" | "declaration" | "type" => {
            let links = match service {
                "definition" => definition(snapshot, mark),
                "declaration" => declaration(snapshot, mark),
                _ => type_definition(snapshot, mark),
            };
            for link in links {
                let _ = writeln!(out, "{} → {}", here(link.from), place(snapshot, &link.name));
            }
        }
        "references" => out = uses(snapshot, references(snapshot, mark)),
        "highlight" => out = uses(snapshot, highlight(snapshot, mark)),
        "prepare" => match prepare(snapshot, mark) {
            Ok(old) => out = format!("{} `{}`", here(old.range), old.name),
            Err(refusal) => out = format!("refused: {refusal}"),
        },
        "rename" => match rename(snapshot, mark, argument) {
            Ok(all) => out = edits(snapshot, &all),
            Err(refusal) => out = format!("refused: {refusal}"),
        },
        "hover" => {
            if let Some(hover) = hover(snapshot, mark) {
                let _ = writeln!(out, "{}\n{}", here(hover.range), hover.markdown);
            }
        }
        "completion" => {
            let found = completion(snapshot, mark);
            let limit = argument.parse().unwrap_or(12);
            for item in found.items.iter().take(limit) {
                let snippet = if item.snippet { " (snippet)" } else { "" };
                let new_text = item.new_text.replace('\n', "⏎");
                let _ = writeln!(out, "{:?} {} · {} · {} → {new_text}{snippet}", item.kind, item.label, item.detail, here(item.range));
            }
            if found.items.len() > limit {
                let _ = writeln!(out, "and others");
            }
        }
        "signature" => {
            if let Some(found) = signature(snapshot, mark) {
                let _ = writeln!(out, "{}", found.label);
                let active = found.active.and_then(|index| found.parameters.get(index));
                let _ = writeln!(out, "active: {}", active.map_or("none", |one| &found.label[one.label.start..one.label.end]));
            }
        }
        "calls" => {
            if let Some(block) = calls::prepare(snapshot, mark) {
                let _ = writeln!(out, "{} · {} · {}", block.name, block.detail, place(snapshot, &block.place));
                for (word, found) in [("from", calls::incoming(snapshot, &block)), ("to", calls::outgoing(snapshot, &block))] {
                    for call in found {
                        let places: Vec<String> = call.places.iter().map(|one| place(snapshot, one)).collect();
                        let _ = writeln!(out, "{word} {}: {}", call.block.name, places.join(", "));
                    }
                }
            }
        }
        "symbols" => {
            for symbol in workspace_symbols(snapshot, argument, 20) {
                let _ = writeln!(out, "{:?} {} · {} · {}", symbol.kind, symbol.name, symbol.container, place(snapshot, &symbol.place));
            }
        }
        "hints" => {
            let length = snapshot.text(mark.text).map_or(0, |text| text.text.len());
            for hint in hints(snapshot, mark.text, Bytes { start: 0, end: length }) {
                let at = Bytes { start: hint.offset, end: hint.offset };
                let _ = writeln!(out, "{}{:?} {}", here(at), hint.kind, hint.label);
            }
        }
        "linked" => linked(snapshot, mark).into_iter().for_each(|range| _ = writeln!(out, "{}", here(range))),
        "actions" => {
            // The selection begins at the mark and ends after so many lines; without a number it is empty.
            let rest = snapshot.text(mark.text).and_then(|text| text.text.get(mark.offset..)).unwrap_or_default();
            let lines = argument.parse().unwrap_or(0);
            let end = mark.offset + rest.split_inclusive('\n').take(lines).map(str::len).sum::<usize>();
            for action in actions::actions(snapshot, mark.text, Bytes { start: mark.offset, end }) {
                let _ = writeln!(out, "{:?} {}", action.kind, action.title);
                if let Some(reason) = &action.disabled {
                    let _ = writeln!(out, "  disabled: {reason}");
                }
                edits(snapshot, &action.edits).lines().for_each(|line| _ = writeln!(out, "  {line}"));
            }
        }
        other => panic!("there is no service `{other}`"),
    }
    out
}

/// Asks all services.
pub(crate) fn everything(snapshot: &Snapshot, mark: Position) {
    let _ = (definition(snapshot, mark), declaration(snapshot, mark), type_definition(snapshot, mark));
    let _ = (references(snapshot, mark), highlight(snapshot, mark));
    let _ = (prepare(snapshot, mark), rename(snapshot, mark, "Other_name_9"), hover(snapshot, mark));
    let _ = (completion(snapshot, mark), signature(snapshot, mark), linked(snapshot, mark));
    if let Some(block) = calls::prepare(snapshot, mark) {
        let _ = (calls::incoming(snapshot, &block), calls::outgoing(snapshot, &block));
    }
    let _ = workspace_symbols(snapshot, "ab", 10);
    let range = Bytes { start: mark.offset.saturating_sub(20), end: mark.offset.saturating_add(20) };
    let _ = hints(snapshot, mark.text, range);
    let _ = (
        actions::actions(snapshot, mark.text, range),
        actions::actions(snapshot, mark.text, Bytes { start: mark.offset, end: mark.offset }),
    );
}
