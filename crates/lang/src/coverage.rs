//! What of a block coverage counts: its statements, and its decisions with what can come of each.

use std::ops::Range;

use sieben_engine::machine::{Register, Registers};
use sieben_model::source::Span;

/// What of a block can be counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Countable {
    /// Where each statement of the source is, and how it is known that it ran.
    pub statements: Vec<(Span, Seen)>,
    /// The decisions, in the order of the source.
    pub decisions: Vec<Decision>,
    /// The statements that look at something in the registers, by their number in the IR.
    pub looking: Vec<(u32, Look)>,
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

/// What a statement looks at before it does one thing or another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// Whether this bit is 1.
    Set(Register),
    /// Whether this bit is 0.
    Clear(Register),
    /// Whether CC 1 and CC 0 say this: yes or no for 00, 01, 10 and 11.
    Conditions([bool; 4]),
    /// Whether a loop that counts down in ACCU 1 goes on.
    GoesOn,
    /// Which entry of a list: the low byte of ACCU 1.
    Entry,
}

impl Look {
    /// What it sees in the registers before the statement: 0 or 1, or the entry.
    pub fn value(self, before: &Registers) -> u8 {
        match self {
            Self::Set(register) => u8::from(before.get(register) != 0),
            Self::Clear(register) => u8::from(before.get(register) == 0),
            Self::Conditions(yes) => u8::from(yes[usize::from(before.cc1 != 0) << 1 | usize::from(before.cc0 != 0)]),
            // It counts down first, and 0 becomes 65535.
            Self::GoesOn => u8::from(before.accu1 & 0xFFFF != 1),
            Self::Entry => before.accu1 as u8,
        }
    }
}

impl Countable {
    /// The same for a block that has got a statement of the IR before its first.
    pub(crate) fn moved_by_one(&mut self) {
        let outcomes = self.decisions.iter_mut().flat_map(|decision| &mut decision.outcomes);
        let seen = outcomes.map(|outcome| &mut outcome.seen).chain(self.statements.iter_mut().map(|(_, seen)| seen));
        let looking = self.looking.iter_mut().map(|(number, _)| number);
        seen.flat_map(Seen::numbers).chain(looking).for_each(|number| *number += 1);
    }
}
