//! How often a run comes by each statement, and what they look at then.

use std::collections::HashMap;

use sieben_engine::{Machine, StatementEvent, Tracer};
use sieben_lang::Compiled;
use sieben_lang::coverage::{Look, Seen};
use sieben_model::block::BlockId;

/// A statement of the IR: its block, and its number there.
type Statement = (BlockId, u32);

/// What statements look at, by the statement.
pub type Looking = HashMap<Statement, Look>;

/// The statements of a program that look at something.
pub fn looking(compiled: &Compiled) -> Looking {
    let all = compiled.countable.iter();
    all.flat_map(|(&block, countable)| countable.looking.iter().map(move |&(number, look)| ((block, number), look))).collect()
}

/// How often each statement ran.
#[derive(Clone, Debug, Default)]
pub struct Counts {
    ran: HashMap<Statement, u64>,
    /// The same by what the statement looked at.
    with: HashMap<(Statement, u8), u64>,
}

impl Counts {
    /// How often something came.
    pub(super) fn of(&self, block: BlockId, seen: &Seen) -> u64 {
        let ran = seen.ran.iter().map(|&number| self.ran.get(&(block, number)).copied().unwrap_or(0));
        let values = seen.with.iter().flat_map(|(number, values)| values.clone().map(move |value| (*number, value)));
        let with = values.map(|(number, value)| self.with.get(&((block, number), value as u8)).copied().unwrap_or(0));
        ran.chain(with).fold(0, u64::saturating_add)
    }

    /// Adds what another run counted.
    pub(super) fn add(&mut self, other: Self) {
        for (statement, count) in other.ran {
            more(self.ran.entry(statement).or_default(), count);
        }
        for (statement, count) in other.with {
            more(self.with.entry(statement).or_default(), count);
        }
    }
}

fn more(known: &mut u64, count: u64) {
    *known = known.saturating_add(count);
}

/// Counts a run.
#[derive(Clone, Debug)]
pub struct Counting<'a> {
    looking: &'a Looking,
    /// What was counted so far.
    pub counts: Counts,
}

impl<'a> Counting<'a> {
    /// Nothing was counted yet.
    pub fn new(looking: &'a Looking) -> Self {
        Self { looking, counts: Counts::default() }
    }
}

impl Tracer for Counting<'_> {
    fn statement(&mut self, _machine: &Machine, event: &StatementEvent) {
        let statement = (event.place.block, event.place.statement);
        more(self.counts.ran.entry(statement).or_default(), 1);
        if let Some(value) = self.looking.get(&statement).map(|look| look.value(&event.before)) {
            more(self.counts.with.entry((statement, value)).or_default(), 1);
        }
    }
}
