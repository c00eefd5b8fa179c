//! What is asked about names: the services of `ide::editing` in the words of the protocol.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use lsp_server::{ErrorCode, ResponseError};
use lsp_types::{Position, Range};
use serde_json::{Value, json};
use sieben_ide::editing::completion::Kind;
use sieben_ide::editing::references::Access;
use sieben_ide::editing::{self, Bytes, Edit, Snapshot, TextId, calls, definition, hints, references};
use sieben_model::mnemonics::Mnemonics;

use super::diagnostics::uri_of;
use super::live;
use super::positions::{Columns, Lines, length};
use super::server::Server;
use super::uri::{self, Place};
use super::work::{Answer, refused};

/// Names that are listed at most.
const SYMBOLS_MAX: usize = 500;

/// A snapshot with the text that is asked about.
pub(super) struct Asked {
    pub(super) snapshot: Snapshot,
    pub(super) text: TextId,
    columns: Columns,
    /// The place of the text that is asked about: it may have no path.
    place: Place,
    /// Where the lines of texts begin, counted once.
    lines: RefCell<BTreeMap<TextId, Rc<Lines>>>,
}

impl Asked {
    /// The text of a URI among those of its program; `None` if no program has it.
    pub(super) fn of(server: &mut Server, uri: &str) -> Result<Option<Self>, ResponseError> {
        let (place, _) = server.document(uri)?;
        server.renew();
        let columns = server.columns();
        let Some(snapshot) = server.folders.snapshot_of(&place, &server.documents) else { return Ok(None) };
        let source = server.folders.program_of(&place).map(|(program, file)| program.project().texts.program.file(file).name.clone());
        let is_it = |name: &str| match &place {
            Place::File(path) => uri::known(Path::new(name)) == *path,
            Place::Untitled(_) | Place::Other(_) => true,
        };
        // Only a source is found by its name alone; the others are few.
        let text = source.and_then(|name| snapshot.find(&name));
        let text = text.or_else(|| snapshot.texts().iter().position(|text| is_it(&text.name)).map(TextId));
        Ok(text.map(|text| Self::new(snapshot, text, columns, place)))
    }

    fn new(snapshot: Snapshot, text: TextId, columns: Columns, place: Place) -> Self {
        Self { snapshot, text, columns, place, lines: RefCell::default() }
    }

    fn lines(&self, text: TextId) -> Rc<Lines> {
        Rc::clone(self.lines.borrow_mut().entry(text).or_insert_with(|| Rc::new(Lines::of(self.source(text)))))
    }

    fn source(&self, text: TextId) -> &str {
        self.snapshot.text(text).map_or("", |text| &text.text)
    }

    pub(super) fn position(&self, position: Position) -> editing::Position {
        let text = self.source(self.text);
        editing::Position { text: self.text, offset: self.lines(self.text).byte(text, position, self.columns) }
    }

    /// Bytes of the text that is asked about, of a range.
    pub(super) fn bytes(&self, range: Range) -> Bytes {
        let text = self.source(self.text);
        let lines = self.lines(self.text);
        let start = lines.byte(text, range.start, self.columns);
        Bytes { start, end: lines.byte(text, range.end, self.columns).max(start) }
    }

    fn range_in(&self, text: TextId, bytes: Bytes) -> Range {
        let source = self.source(text);
        self.lines(text).range(source, bytes.start, bytes.end, self.columns)
    }

    pub(super) fn range(&self, bytes: Bytes) -> Range {
        self.range_in(self.text, bytes)
    }

    fn place(&self, text: TextId) -> Place {
        if text == self.text {
            return self.place.clone();
        }
        Place::File(uri::known(&PathBuf::from(self.snapshot.text(text).map_or("", |text| text.name.as_str()))))
    }

    fn uri(&self, server: &Server, text: TextId) -> String {
        uri_of(&self.place(text), &server.documents)
    }

    fn location(&self, server: &Server, place: &editing::Place) -> Value {
        json!({ "uri": self.uri(server, place.text), "range": self.range_in(place.text, place.range) })
    }

    /// Locations, with the URI of each text made once.
    fn locations<'p>(&self, server: &Server, places: impl Iterator<Item = &'p editing::Place>) -> Vec<Value> {
        let mut known: BTreeMap<TextId, String> = BTreeMap::new();
        let location = |place: &editing::Place| {
            let uri = known.entry(place.text).or_insert_with(|| self.uri(server, place.text));
            json!({ "uri": uri, "range": self.range_in(place.text, place.range) })
        };
        places.map(location).collect()
    }

    /// Edits of any texts.
    pub(super) fn edit(&self, server: &Server, edits: &[Edit]) -> Value {
        let mut of_texts: BTreeMap<TextId, Vec<Value>> = BTreeMap::new();
        let places = self.locations(server, edits.iter().map(|edit| &edit.place));
        for (edit, place) in edits.iter().zip(places) {
            of_texts.entry(edit.place.text).or_default().push(json!({ "range": place["range"], "newText": edit.new_text }));
        }
        let all = of_texts.into_iter().map(|(text, edits)| {
            let version = server.documents.get(&self.place(text)).map(|document| document.version);
            (self.uri(server, text), version, edits)
        });
        workspace_edit(server, all)
    }
}

/// Edits by the URIs of their texts, in the form that the client takes.
pub(super) fn workspace_edit(server: &Server, all: impl Iterator<Item = (String, Option<i32>, Vec<Value>)>) -> Value {
    if server.client.versioned_edits {
        let changes = all.map(|(uri, version, edits)| json!({ "textDocument": { "uri": uri, "version": version }, "edits": edits }));
        return json!({ "documentChanges": changes.collect::<Vec<_>>() });
    }
    let changes: serde_json::Map<String, Value> = all.map(|(uri, _, edits)| (uri, edits.into())).collect();
    json!({ "changes": changes })
}

pub(super) fn hover(server: &mut Server, uri: &str, position: Position) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let hover = editing::hover::hover(&asked.snapshot, asked.position(position));
    Ok(hover.map_or(
        Value::Null,
        |hover| json!({ "contents": { "kind": "markdown", "value": hover.markdown }, "range": asked.range(hover.range) }),
    ))
}

fn kind(kind: Kind) -> u32 {
    match kind {
        Kind::Instruction | Kind::Keyword => 14,
        Kind::Symbol | Kind::Variable | Kind::Parameter => 6,
        Kind::Field => 5,
        Kind::Function => 3,
        Kind::FunctionBlock => 7,
        Kind::DataBlock => 9,
        Kind::Type => 22,
        Kind::Constant => 21,
        Kind::Label => 18,
        Kind::Snippet => 15,
    }
}

pub(super) fn completion(server: &mut Server, uri: &str, position: Position) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let completion = editing::completion::completion(&asked.snapshot, asked.position(position));
    let item = |item: &editing::completion::Item| {
        let is_snippet = item.snippet && server.client.snippets;
        let new = if item.snippet && !is_snippet { without_places(&item.new_text) } else { item.new_text.clone() };
        let mut shown = json!({
            "label": item.label, "kind": kind(item.kind), "detail": item.detail, "sortText": item.sort, "filterText": item.filter,
            "insertTextFormat": if is_snippet { 2 } else { 1 },
            "textEdit": { "range": asked.range(item.range), "newText": new },
        });
        if !item.documentation.is_empty() {
            shown["documentation"] = json!({ "kind": "markdown", "value": item.documentation });
        }
        shown
    };
    let items: Vec<Value> = completion.items.iter().map(item).collect();
    Ok(json!({ "isIncomplete": completion.incomplete, "items": items }))
}

/// A snippet as plain text: `${1:name}` is `name`, `$1` nothing.
fn without_places(snippet: &str) -> String {
    let mut out = String::new();
    let mut rest = snippet;
    while let Some((before, after)) = rest.split_once('$') {
        out.push_str(before);
        rest = match after.strip_prefix('{').and_then(|inner| inner.split_once('}')) {
            Some((place, after)) => {
                out.push_str(place.split_once(':').map_or("", |(_, name)| name));
                after
            }
            None => after.trim_start_matches(|sign: char| sign.is_ascii_digit()),
        };
    }
    out + rest
}

pub(super) fn signature(server: &mut Server, uri: &str, position: Position) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let Some(signature) = editing::signature::signature(&asked.snapshot, asked.position(position)) else { return Ok(Value::Null) };
    // Places in a label are counted in UTF-16, whatever was agreed on.
    let units = |byte: usize| length(signature.label.get(..byte).unwrap_or(&signature.label), Columns::Utf16);
    let parameters: Vec<Value> = signature
        .parameters
        .iter()
        .map(|one| json!({ "label": [units(one.label.start), units(one.label.end)], "documentation": one.documentation }))
        .collect();
    let mut shown = json!({
        "label": signature.label, "parameters": parameters,
        "documentation": { "kind": "markdown", "value": signature.documentation },
    });
    if let Some(active) = signature.active {
        shown["activeParameter"] = active.into();
    }
    let active = shown.get("activeParameter").cloned();
    let mut answer = json!({ "signatures": [shown], "activeSignature": 0 });
    if let Some(active) = active {
        answer["activeParameter"] = active;
    }
    Ok(answer)
}

type Find = fn(&Snapshot, editing::Position) -> Vec<definition::Link>;

/// Where a name leads to.
pub(super) fn links(server: &mut Server, uri: &str, position: Position, find: Find) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let links = find(&asked.snapshot, asked.position(position));
    if !server.client.links {
        return Ok(links.iter().map(|link| asked.location(server, &link.name)).collect());
    }
    let shown = links.iter().map(|link| {
        json!({
            "originSelectionRange": asked.range(link.from), "targetUri": asked.uri(server, link.name.text),
            "targetRange": asked.range_in(link.whole.text, link.whole.range),
            "targetSelectionRange": asked.range_in(link.name.text, link.name.range),
        })
    });
    Ok(shown.collect())
}

pub(super) fn references(server: &mut Server, uri: &str, position: Position, with_declaration: bool) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let uses = references::references(&asked.snapshot, asked.position(position));
    let wanted = uses.iter().filter(|one| with_declaration || one.access != Access::Definition);
    Ok(asked.locations(server, wanted.map(|one| &one.place)).into())
}

pub(super) fn highlights(server: &mut Server, uri: &str, position: Position) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let uses = editing::highlight::highlight(&asked.snapshot, asked.position(position));
    let kind = |access: Access| match access {
        Access::Write | Access::ReadWrite | Access::Definition => 3,
        Access::Read => 2,
        _ => 1,
    };
    Ok(uses.iter().map(|one| json!({ "range": asked.range(one.place.range), "kind": kind(one.access) })).collect())
}

pub(super) fn prepare_rename(server: &mut Server, uri: &str, position: Position) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let found = editing::rename::prepare(&asked.snapshot, asked.position(position));
    let found = found.map_err(|why| refused(ErrorCode::RequestFailed, why))?;
    Ok(json!({ "range": asked.range(found.range), "placeholder": found.name }))
}

pub(super) fn rename(server: &mut Server, uri: &str, position: Position, new_name: &str) -> Answer {
    if !server.client.watches {
        // It is not known whether files that are not open are still as they were.
        server.folders.read_again();
    }
    let Some(asked) = Asked::of(server, uri)? else {
        return Err(refused(ErrorCode::RequestFailed, "this text is part of no program, so nothing in it can be renamed"));
    };
    let edits = editing::rename::rename(&asked.snapshot, asked.position(position), new_name);
    let edits = edits.map_err(|why| refused(ErrorCode::RequestFailed, why))?;
    Ok(asked.edit(server, &edits))
}

pub(super) fn linked(server: &mut Server, uri: &str, position: Position) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let ranges: Vec<Range> =
        editing::linked::linked(&asked.snapshot, asked.position(position)).into_iter().map(|bytes| asked.range(bytes)).collect();
    Ok(if ranges.is_empty() { Value::Null } else { json!({ "ranges": ranges, "wordPattern": "[\\p{L}_][\\p{L}\\p{N}_]*" }) })
}

pub(super) fn inlay_hints(server: &mut Server, uri: &str, range: Range) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let hints = hints::hints(&asked.snapshot, asked.text, asked.bytes(range));
    let names = hints.iter().filter_map(|hint| Some(hint.operand?.spell(Mnemonics::English))).collect();
    let mut values = live::values(server, &asked.place, names).into_iter();
    let shown = hints.iter().filter_map(|hint| {
        let value = hint.operand.and_then(|_| values.next().flatten());
        let label = match (hint.label.as_str(), value) {
            ("", None) => return None,
            (label, None) => label.to_owned(),
            (label, Some(value)) => format!("{label} = {value}").trim_start().to_owned(),
        };
        let position = asked.range(Bytes { start: hint.offset, end: hint.offset }).start;
        let kind = if hint.kind == hints::Kind::Parameter { 2 } else { 1 };
        let left = hint.kind != hints::Kind::Parameter;
        Some(json!({ "position": position, "label": label, "kind": kind, "paddingLeft": left, "paddingRight": !left }))
    });
    Ok(shown.collect())
}

pub(super) fn symbols(server: &mut Server, query: &str) -> Answer {
    server.renew();
    let columns = server.columns();
    let mut all = Vec::new();
    for snapshot in server.folders.snapshots(&server.documents) {
        let asked = Asked::new(snapshot, TextId(usize::MAX), columns, Place::Other(String::new()));
        for symbol in editing::symbols::workspace_symbols(&asked.snapshot, query, SYMBOLS_MAX) {
            let kind = match symbol.kind {
                Kind::Function => 12,
                Kind::FunctionBlock => 5,
                Kind::DataBlock => 19,
                Kind::Type => 23,
                Kind::Field => 8,
                Kind::Constant => 14,
                _ => 13,
            };
            let location = asked.location(server, &symbol.place);
            let shown = json!({ "name": symbol.name, "kind": kind, "containerName": symbol.container, "location": location });
            if all.len() < SYMBOLS_MAX && !all.contains(&shown) {
                all.push(shown);
            }
        }
    }
    Ok(all.into())
}

fn call_item(asked: &Asked, server: &Server, block: &calls::Block) -> Value {
    json!({
        "name": block.name, "kind": 12, "detail": block.detail, "uri": asked.uri(server, block.place.text),
        "range": asked.range_in(block.whole.text, block.whole.range), "selectionRange": asked.range_in(block.place.text, block.place.range),
    })
}

pub(super) fn prepare_calls(server: &mut Server, uri: &str, position: Position) -> Answer {
    let Some(asked) = Asked::of(server, uri)? else { return Ok(Value::Null) };
    let block = calls::prepare(&asked.snapshot, asked.position(position));
    Ok(block.map_or(Value::Null, |block| json!([call_item(&asked, server, &block)])))
}

/// The calls to or from a block that was answered before.
pub(super) fn calls(server: &mut Server, item: &Value, incoming: bool) -> Answer {
    let uri = item.get("uri").and_then(Value::as_str).unwrap_or_default().to_owned();
    let range = item.get("selectionRange").cloned().unwrap_or_default();
    let range: Range = serde_json::from_value(range).map_err(|_| super::reading::missing("item"))?;
    server.renew();
    let place = Place::of(&uri);
    let columns = server.columns();
    let Some(snapshot) = server.folders.snapshot_of(&place, &server.documents) else { return Ok(Value::Null) };
    let is_it = |name: &str| place.path().is_none_or(|path| uri::known(Path::new(name)) == path);
    let Some(text) = snapshot.texts().iter().position(|text| is_it(&text.name)) else { return Ok(Value::Null) };
    let asked = Asked::new(snapshot, TextId(text), columns, place);
    let Some(block) = calls::prepare(&asked.snapshot, asked.position(range.start)) else { return Ok(Value::Null) };
    let found = if incoming { calls::incoming(&asked.snapshot, &block) } else { calls::outgoing(&asked.snapshot, &block) };
    let (other, ranges) = if incoming { ("from", "fromRanges") } else { ("to", "fromRanges") };
    let shown = found.iter().map(|call| {
        let places: Vec<Range> = call.places.iter().map(|place| asked.range_in(place.text, place.range)).collect();
        json!({ other: call_item(&asked, server, &call.block), ranges: places })
    });
    Ok(shown.collect())
}
