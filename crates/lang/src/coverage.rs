//! What of a block coverage counts: its statements, and its decisions with what can come of each.

use std::collections::BTreeMap;
use std::ops::Range;

use sieben_engine::CodeBlock;
use sieben_engine::machine::Registers;
use sieben_model::source::Span;

use crate::reason::control::jumps;
use crate::reason::why::Why;
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::meaning::jumps::list_entries;

/// What of a block can be counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Countable {
    /// Where each statement of the source is, and how it is known that it ran.
    pub statements: Vec<(Span, Seen)>,
    /// The decisions, in the order of the source.
    pub decisions: Vec<Decision>,
    /// The statements of STL that look at something, by their number in the IR.
    pub looking: Vec<(u32, Why)>,
}

/// A place where a program goes one way or another.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// The word before it in its statement: `IF`, `UNTIL`; empty in STL.
    pub word: &'static str,
    /// What decides: a condition, a selector, a statement of STL.
    pub span: Span,
    /// All that can come of it, at least two.
    pub outcomes: Vec<Outcome>,
}

/// One thing that can come of a decision.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// What it is called.
    pub label: Label,
    /// How it is known that it came.
    pub seen: Seen,
}

/// What an outcome is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Label {
    /// `RLO 0`, `jump`, `TRUE` …
    Word(&'static str),
    /// As the source says: the labels of a branch of CASE, an entry of a jump list.
    Source(Span),
}

/// How it is known that something came.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Seen {
    /// One of these statements of the IR ran.
    pub ran: Vec<u32>,
    /// This one ran, and what it looks at was one of these values.
    pub with: Option<(u32, Range<u16>)>,
}

impl Seen {
    /// A statement of the IR runs.
    pub(crate) fn ran(number: u32) -> Self {
        Self { ran: vec![number], with: None }
    }

    /// All statements of the IR that it is about.
    fn numbers(&mut self) -> impl Iterator<Item = &mut u32> {
        self.ran.iter_mut().chain(self.with.as_mut().map(|(number, _)| number))
    }
}

/// What a statement of STL looks at, if it does one thing or another by it: a bit, or the entry of a jump list.
pub fn looks_at(why: Why, before: &Registers) -> Option<u8> {
    match why {
        Why::Assign
        | Why::Set
        | Why::Reset
        | Why::Rising
        | Why::Falling
        | Why::CallIfRlo
        | Why::EndIfRlo
        | Why::McrOpen
        | Why::Timer(_)
        | Why::TimerReset
        | Why::TimerEnable
        | Why::CounterUp
        | Why::CounterDown
        | Why::CounterSet
        | Why::CounterReset
        | Why::CounterEnable
        | Why::JumpIfRlo
        | Why::JumpIfNotRlo => Some(u8::from(before.rlo != 0)),
        Why::JumpList => Some(before.accu1 as u8),
        _ => jumps(why, before).map(u8::from),
    }
}

impl Countable {
    /// That of a block of STL.
    pub(crate) fn of_stl(block: &ResolvedBlock, code: &CodeBlock) -> Self {
        let mut all = Self::default();
        for ((number, statement), &span) in (0_u32..).zip(&block.statements).zip(&code.spans) {
            // Statements that the compiler adds have no place.
            if span.start == span.end {
                continue;
            }
            all.statements.push((span, Seen::ran(number)));
            let why = statement.instruction.why();
            if looks_at(why, &Registers::default()).is_none() {
                continue;
            }
            all.looking.push((number, why));
            let outcomes = match why {
                Why::JumpList => entries(block, number),
                // What a jump does by other bits than the RLO is told by what it does.
                _ if jumps(why, &Registers::default()).is_some() && !matches!(why, Why::JumpIfRlo | Why::JumpIfNotRlo) => {
                    bit(number, ["no jump", "jump"])
                }
                _ => bit(number, ["RLO 0", "RLO 1"]),
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

    /// The same for a block that has got a statement of the IR before its first.
    pub(crate) fn moved_by_one(&mut self) {
        let outcomes = self.decisions.iter_mut().flat_map(|decision| &mut decision.outcomes);
        let seen = outcomes.map(|outcome| &mut outcome.seen).chain(self.statements.iter_mut().map(|(_, seen)| seen));
        let looking = self.looking.iter_mut().map(|(number, _)| number);
        seen.flat_map(Seen::numbers).chain(looking).for_each(|number| *number += 1);
    }
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
        label: Label::Source(statement.span),
        seen: Seen { ran: Vec::new(), with: Some((number, value..value + 1)) },
    };
    let beyond = Seen { ran: Vec::new(), with: Some((number, list.len() as u16..256)) };
    let beyond = Outcome { label: Label::Word("beyond the list"), seen: beyond };
    (0_u16..).zip(list).map(one).chain([beyond]).collect()
}
