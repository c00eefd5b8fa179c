//! What is asked of one open text alone: its outline, tokens, folds and layout.

use lsp_server::{ErrorCode, ResponseError};
use lsp_types::{Position, Range};
use serde_json::{Value, json};
use sieben_ide::text::folding::FoldKind;
use sieben_ide::text::outline::{Kind, Row};
use sieben_ide::text::{Text, tokens};
use sieben_lang::codesys_files;
use sieben_lang::language::Language;
use sieben_model::mnemonics::Mnemonics;

use super::documents::Document;
use super::positions::{floor, length};
use super::server::Server;
use super::uri::Place;
use super::work::{Answer, refused};
use crate::paths;

/// What is known of a text before it is parsed.
pub(super) struct Known {
    pub(super) name: String,
    pub(super) language: Language,
    pub(super) mnemonics: Option<Mnemonics>,
}

impl Server {
    /// How an open text is read: as its program reads it, else by its name; `None` if it is no source.
    pub(super) fn known(&mut self, place: &Place) -> Option<Known> {
        let document = self.documents.get(place)?;
        if document.is_too_large() {
            return None;
        }
        let name = super::folders::name_alone(place, document).display().to_string();
        let is_source = match place {
            Place::File(path) => super::folders::is_source_alone(path, document) || paths::is_test(path),
            Place::Untitled(_) | Place::Other(_) => true,
        };
        if !is_source {
            return None;
        }
        let text = document.text().clone();
        let settings = self.folders.program_of(place).map(|(program, _)| program.project().settings.clone()).unwrap_or_default();
        Some(Known { language: Language::of(&name, &text, settings.dialect), name, mnemonics: settings.mnemonics })
    }
}

/// Does something with a parsed text; an empty list for what is no source.
fn with(server: &mut Server, uri: &str, answer: impl FnOnce(&Server, &Document, &Text<'_>) -> Value) -> Answer {
    let (place, _) = server.document(uri)?;
    let Some(known) = server.known(&place) else { return Ok(Value::Null) };
    let (_, document) = server.document(uri)?;
    let text = Text::parse(&known.name, document.text(), known.language, known.mnemonics);
    Ok(answer(server, document, &text))
}

pub(super) fn outline(server: &mut Server, uri: &str) -> Answer {
    with(server, uri, |server, document, text| text.outline().iter().map(|row| shown(server, document, row)).collect())
}

fn shown(server: &Server, document: &Document, row: &Row) -> Value {
    let kind = match row.kind {
        Kind::Program => 2,
        Kind::Function => 12,
        Kind::FunctionBlock => 5,
        Kind::DataBlock => 19,
        Kind::Type => 23,
        Kind::Section => 3,
        Kind::Variable => 13,
        Kind::Constant => 14,
        Kind::Network => 15,
        Kind::Label => 20,
        Kind::Member => 6,
        Kind::Interface => 11,
        Kind::Namespace => 3,
        Kind::Test => 24,
    };
    let range = |place: (usize, usize)| server.range(document, place.0, place.1);
    let rows: Vec<Value> = row.rows.iter().map(|row| shown(server, document, row)).collect();
    json!({
        "name": if row.name.trim().is_empty() { "?" } else { &row.name }, "detail": row.detail, "kind": kind,
        "range": range(row.whole), "selectionRange": range(row.named), "children": rows,
    })
}

pub(super) fn folds(server: &mut Server, uri: &str) -> Answer {
    with(server, uri, |_, document, text| {
        let lines = document.lines();
        let mut known = Vec::new();
        let mut folds = Vec::new();
        for fold in text.folds() {
            let body = document.text().get(fold.place.0..fold.place.1).unwrap_or_default();
            let first = fold.place.0 + body.len() - body.trim_start().len();
            let last = fold.place.0 + body.trim_end().len();
            let (start, end) = (lines.line_of(first), lines.line_of(last.max(first)));
            if start >= end || known.contains(&(start, end)) {
                continue;
            }
            known.push((start, end));
            let mut shown = json!({ "startLine": start, "endLine": end });
            match fold.kind {
                FoldKind::Comment => shown["kind"] = "comment".into(),
                FoldKind::Network => shown["kind"] = "region".into(),
                FoldKind::Code => {}
            }
            if let Some(text) = fold.shown {
                shown["collapsedText"] = text.into();
            }
            folds.push(shown);
        }
        folds.into()
    })
}

pub(super) fn selections(server: &mut Server, uri: &str, positions: &[Position]) -> Answer {
    with(server, uri, |server, document, text| {
        let one = |position: &Position| {
            let byte = server.byte(document, *position);
            let mut selection = Value::Null;
            for place in text.around(byte).into_iter().rev() {
                let range = server.range(document, place.0, place.1);
                selection = match selection {
                    Value::Null => json!({ "range": range }),
                    parent => json!({ "range": range, "parent": parent }),
                };
            }
            if selection.is_null() { json!({ "range": server.range(document, byte, byte) }) } else { selection }
        };
        positions.iter().map(one).collect()
    })
}

/// Number of the kind of a token in the legend, and its modifiers.
fn legend(kind: tokens::Kind) -> u32 {
    match kind {
        tokens::Kind::Comment => 0,
        tokens::Kind::Keyword => 1,
        tokens::Kind::Instruction => 2,
        tokens::Kind::Label => 3,
        tokens::Kind::Symbol => 4,
        tokens::Kind::Variable => 5,
        tokens::Kind::Parameter => 6,
        tokens::Kind::Type => 7,
        tokens::Kind::Function => 8,
        tokens::Kind::Number => 9,
        tokens::Kind::Characters => 10,
        tokens::Kind::Operator => 11,
        tokens::Kind::Address => 12,
        tokens::Kind::Block => 13,
        tokens::Kind::Status => 14,
        tokens::Kind::Heading => 16,
    }
}

pub(super) fn tokens(server: &mut Server, uri: &str, wanted: Option<Range>) -> Answer {
    let columns = server.columns();
    with(server, uri, |server, document, text| {
        let (from, to) = match wanted {
            Some(range) => (server.byte(document, range.start), server.byte(document, range.end)),
            None => (0, document.text().len()),
        };
        let (source, lines) = (document.text(), document.lines());
        let mut data: Vec<u32> = Vec::new();
        let (mut last_line, mut last_start) = (0, 0);
        for token in text.tokens().iter().filter(|token| token.place.1 > from && token.place.0 < to) {
            // No token goes over the end of a line.
            for line in lines.line_of(token.place.0)..=lines.line_of(token.place.1.saturating_sub(1).max(token.place.0)) {
                let (begin, end) = lines.bytes(source, line);
                let (start, end) = (floor(source, token.place.0.max(begin)), floor(source, token.place.1.min(end)));
                let length = length(source.get(start..end).unwrap_or_default(), columns);
                if length == 0 {
                    continue;
                }
                let position = lines.position(source, start, columns);
                let column = if position.line == last_line { position.character - last_start } else { position.character };
                data.extend([position.line - last_line, column, length, legend(token.kind), u32::from(token.declares)]);
                (last_line, last_start) = (position.line, position.character);
            }
        }
        json!({ "data": data })
    })
}

/// The edits that bring a text into the usual layout: line by line, so that a cursor stays where it is.
pub(super) fn format(server: &mut Server, uri: &str, wanted: Option<Range>) -> Answer {
    let (place, document) = server.document(uri)?;
    if document.is_lossy {
        let message = "this text is open with the wrong encoding: reopen it with its own, and try again";
        return Err(refused(ErrorCode::RequestFailed, message));
    }
    let Some(known) = server.known(&place) else { return Ok(Value::Null) };
    let (_, document) = server.document(uri)?;
    let text = document.text();
    if codesys_files::kind(&known.name, text).is_some() {
        let message = "this file of CODESYS or TwinCAT holds more than the text of a source; it is left alone";
        return Err(refused(ErrorCode::RequestFailed, message));
    }
    let formatted = (known.language.row().format)(text, known.language, known.mnemonics).map_err(|diagnostics| {
        let first = diagnostics.first().map(|diagnostic| diagnostic.message.clone()).unwrap_or_default();
        refused(ErrorCode::RequestFailed, format!("a source with syntax errors is left alone: {first}"))
    })?;
    let edits = edits(text, &formatted);
    let lines = wanted.map(|range| (range.start.line as usize, range.end.line as usize));
    let shown = edits.into_iter().filter(|(start, end, _)| {
        lines.is_none_or(|(first, last)| document.lines().line_of(*start) >= first && document.lines().line_of(*end) <= last + 1)
    });
    Ok(shown.map(|(start, end, new)| json!({ "range": server.range(document, start, end), "newText": new })).collect())
}

/// Lines with their ends.
fn lines(text: &str) -> Vec<&str> {
    text.split_inclusive('\n').collect()
}

/// What is to be replaced to make one text of another: whole lines. Where lines came or went, all between the first and the last that differ.
fn edits(old: &str, new: &str) -> Vec<(usize, usize, String)> {
    let (before, after) = (lines(old), lines(new));
    if before.len() == after.len() {
        let mut edits = Vec::new();
        let mut at = 0;
        for (old, new) in before.iter().zip(&after) {
            if old != new {
                edits.push((at, at + old.len(), (*new).to_owned()));
            }
            at += old.len();
        }
        return edits;
    }
    let head = before.iter().zip(&after).take_while(|(old, new)| old == new).count();
    let rest = before.len().min(after.len()) - head;
    let tail = before.iter().rev().zip(after.iter().rev()).take(rest).take_while(|(old, new)| old == new).count();
    let start: usize = before[..head].iter().map(|line| line.len()).sum();
    let end = old.len() - before[before.len() - tail..].iter().map(|line| line.len()).sum::<usize>();
    vec![(start, end, after[head..after.len() - tail].concat())]
}

/// The tests of a text, each with a lens that runs it.
pub(super) fn lenses(server: &mut Server, uri: &str) -> Answer {
    let given = uri.to_owned();
    with(server, uri, |server, document, text| {
        let tests: Vec<Row> =
            text.outline().into_iter().filter(|row| row.kind == Kind::Test && !row.name.eq("SETUP") && !row.name.eq("TEARDOWN")).collect();
        let lens = |row: &Row| {
            let command = json!({ "title": "Run", "command": "sieben.runTest", "arguments": [given, row.name] });
            json!({ "range": server.range(document, row.named.0, row.named.1), "command": command })
        };
        let all = (!tests.is_empty()).then(|| {
            let command = json!({ "title": "Run all", "command": "sieben.runTest", "arguments": [given] });
            json!({ "range": server.range(document, 0, 0), "command": command })
        });
        all.into_iter().chain(tests.iter().map(lens)).collect()
    })
}

/// Parameters that are not there.
pub(super) fn missing(what: &str) -> ResponseError {
    refused(ErrorCode::InvalidParams, format!("`{what}` is missing or not understood"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_make_one_text_of_the_other() {
        for (old, new) in
            [("", "a\n"), ("a\n", ""), ("a\nb\nc\n", "a\nB\nc\n"), ("a\nb\nc", "a\nc"), ("a\nc\n", "a\nb\nb\nc\n"), ("a\na\n", "a\n")]
        {
            let mut made = old.to_owned();
            for (start, end, text) in edits(old, new).into_iter().rev() {
                made.replace_range(start..end, &text);
            }
            assert_eq!(made, new, "{old:?}");
        }
    }
}
