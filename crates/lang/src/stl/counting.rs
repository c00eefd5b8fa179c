//! What coverage counts in a block of STL.

use std::collections::BTreeMap;

use sieben_engine::CodeBlock;
use sieben_engine::machine::Register;

use super::lower::{ResolvedBlock, Statement};
use super::meaning::jumps::list_entries;
use crate::coverage::{Countable, Decision, Label, Look, Outcome, Seen};

/// What of a block can be counted; `code` is its IR.
pub(crate) fn countable(block: &ResolvedBlock, code: &CodeBlock) -> Countable {
    let mut all = Countable::default();
    for ((number, statement), &span) in (0_u32..).zip(&block.statements).zip(&code.spans) {
        // Statements that the compiler adds have no place.
        if span.start == span.end {
            continue;
        }
        all.statements.push((span, Seen::ran(number)));
        let why = statement.instruction.why();
        let Some(look) = why.looks_at() else { continue };
        all.looking.push((number, look));
        let outcomes = match look {
            Look::Entry => entries(block, number),
            Look::Set(Register::Rlo) => bit(number, ["RLO 0", "RLO 1"]),
            // What a jump does by other bits than the RLO is told by what it does.
            _ => bit(number, ["no jump", "jump"]),
        };
        all.decisions.push(Decision { word: "", span, outcomes });
    }
    // An entry of a jump list is never run by itself: the list jumps to where the entry leads.
    let entries = all.decisions.iter().flat_map(|decision| &decision.outcomes);
    let entries: BTreeMap<(u32, u32), &Seen> = entries
        .filter_map(|outcome| match outcome.label {
            Label::Source(span) => Some(((span.start, span.end), &outcome.seen)),
            Label::Word(_) => None,
        })
        .collect();
    for (span, seen) in &mut all.statements {
        seen.with = entries.get(&(span.start, span.end)).and_then(|entry| entry.with.clone());
    }
    all
}

/// A bit that is 0 or 1.
fn bit(number: u32, words: [&'static str; 2]) -> Vec<Outcome> {
    let outcome =
        |(value, word)| Outcome { label: Label::Word(word), seen: Seen { ran: Vec::new(), with: Some((number, value..value + 1)) } };
    (0_u16..).zip(words).map(outcome).collect()
}

/// The entries of a jump list, and what lies beyond them.
fn entries(block: &ResolvedBlock, number: u32) -> Vec<Outcome> {
    let list = list_entries(&block.statements, number as usize);
    let one = |(value, statement): (u16, &Statement)| Outcome {
        label: Label::Source(statement.span()),
        seen: Seen { ran: Vec::new(), with: Some((number, value..value + 1)) },
    };
    let beyond = Seen { ran: Vec::new(), with: Some((number, list.len() as u16..256)) };
    let beyond = Outcome { label: Label::Word("beyond the list"), seen: beyond };
    (0_u16..).zip(list).map(one).chain([beyond]).collect()
}
