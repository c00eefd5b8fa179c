//! A text with anything in it, asked about anywhere: a target of the fuzzer.

use std::sync::Arc;

use sieben_lang::Options;

use super::{Bytes, Edit, Place, Position, Role, Snapshot, Text, TextId};
use super::{actions, calls, completion, definition, highlight, hints, hover, linked, references, rename, signature, symbols};
use crate::text;

/// What stands beside the text that is fuzzed: symbols and blocks that it may use.
const BESIDE: [(&str, &str, Role); 2] = [
    ("symbols.csv", "symbol,address,type,comment\nMotor,Q 4.0,BOOL,\nPump,FB 9,FB 9,\n", Role::Symbols),
    (
        "blocks.awl",
        "FUNCTION FC 9 : INT\nVAR_INPUT\n a : INT;\nEND_VAR\nBEGIN\nL #a;\nT #RET_VAL;\nEND_FUNCTION\n\
         FUNCTION_BLOCK FB 9\nVAR\n n : INT;\nEND_VAR\nBEGIN\nA \"Motor\";\nJC m1;\nm1: NOP 0;\nEND_FUNCTION_BLOCK\n",
        Role::Source,
    ),
];
/// Endings of the text, of which the first byte of the input chooses one.
const ENDINGS: [&str; 6] = ["awl", "scl", "st", "lad", "fbd", "test.st"];
/// Places that are asked about.
const PLACES: usize = 4;

/// Asks all services about some places of the input.
pub fn fuzz(data: &[u8]) {
    let Some((&first, rest)) = data.split_first() else { return };
    let name = format!("fuzz.{}", ENDINGS[usize::from(first) % ENDINGS.len()]);
    let own = Text { name, text: Arc::from(String::from_utf8_lossy(rest)), role: Role::Source, fixed: None };
    let beside = BESIDE.map(|(name, text, role)| Text { name: name.to_owned(), text: Arc::from(text), role, fixed: None });
    let options = Options { extended: true, ..Options::default() };
    let texts: Vec<Text> = std::iter::once(own).chain(beside).collect();
    let before = Snapshot::new(texts[1..].to_vec(), &options);
    let snapshot = before.changed(texts, &options);
    let id = TextId(0);
    let own = &snapshot.texts()[0];
    let length = own.text.len();
    if let Some(language) = snapshot.language(id) {
        let parsed = text::Text::parse(&own.name, &own.text, language, None);
        parsed.tokens();
        parsed.folds();
        parsed.outline();
    }
    let all = Bytes { start: 0, end: length };
    hints::hints(&snapshot, id, all).iter().for_each(|hint| assert!(hint.offset <= length, "a hint stands in the text"));
    symbols::workspace_symbols(&snapshot, "m", 100);
    let spread = rest.iter().fold(usize::from(first), |hash, &byte| hash.wrapping_mul(31).wrapping_add(usize::from(byte)));
    for place in 0..PLACES {
        let offset = spread.wrapping_add(place.wrapping_mul(length / PLACES + 1)) % (length + 2);
        ask(&snapshot, Position { text: id, offset });
        for action in actions::actions(&snapshot, id, Bytes { start: offset, end: offset }) {
            check_edits(&snapshot, &action.edits);
        }
    }
    for action in actions::actions(&snapshot, id, all) {
        check_edits(&snapshot, &action.edits);
    }
}

fn ask(snapshot: &Snapshot, position: Position) {
    hover::hover(snapshot, position);
    completion::completion(snapshot, position);
    signature::signature(snapshot, position);
    linked::linked(snapshot, position);
    definition::definition(snapshot, position);
    definition::declaration(snapshot, position);
    definition::type_definition(snapshot, position);
    for one in references::references(snapshot, position).iter().chain(&highlight::highlight(snapshot, position)) {
        check(snapshot, &one.place);
    }
    if let Some(block) = calls::prepare(snapshot, position) {
        calls::incoming(snapshot, &block);
        calls::outgoing(snapshot, &block);
    }
    if rename::prepare(snapshot, position).is_ok()
        && let Ok(edits) = rename::rename(snapshot, position, "renamed")
    {
        check_edits(snapshot, &edits);
    }
}

/// A place is part of its text.
fn check(snapshot: &Snapshot, place: &Place) {
    let text = snapshot.text(place.text).expect("a text of the project");
    assert!(text.text.get(place.range.start..place.range.end).is_some(), "{place:?} is a part of {}", text.name);
}

/// Edits are parts of their texts, and no two of them overlap.
fn check_edits(snapshot: &Snapshot, edits: &[Edit]) {
    let mut places: Vec<&Place> = edits.iter().map(|edit| &edit.place).collect();
    places.sort_unstable();
    for place in &places {
        check(snapshot, place);
    }
    for pair in places.windows(2) {
        assert!(pair[0].text != pair[1].text || pair[0].range.end <= pair[1].range.start, "{pair:?} overlap");
    }
}
