//! Inner loops that are unrolled while the body is constructed: their trip counts are known then, or are checked before the outer loop.

use std::collections::BTreeMap;

use super::super::super::Translator;
use super::super::super::natural_loops::NaturalLoop;
use super::super::kernel::{Kernel, Level};
use super::super::path_predicates::PathPredicates;
use super::{ConstructionMode, SsaBuilder, read_as};

/// Jumps back of inner loops that are read iteration by iteration.
const JUMPS_BACK_MAX: usize = 48;
/// Those of a loop in one iteration that has more of them or not, as the data say.
const ROUNDS_MAX: u32 = 8;
/// How often it has, mostly.
const LIKELY_ROUNDS: u32 = 2;
/// Of so many instructions one may be in iterations of inner loops that most iterations do without.
const REPEATED_MIN: usize = 4;

/// Reads a loop with the iterations of all loops in it one behind the other: they have few iterations, and how many is known.
pub(in crate::translate::loop_optimizer) fn read_unrolled(translator: &mut Translator<'_>, it: &NaturalLoop) -> Option<Kernel> {
    let may_loop = !it.calls_nothing || translator.loops.iter().any(|inner| inner.first > it.first && inner.last <= it.last);
    if !it.asks_nothing || !may_loop {
        return None;
    }
    read_as(translator, it, ConstructionMode { unrolled: true, ..ConstructionMode::default() })
}

/// How often loops have begun again while statements are read one after the other.
#[derive(Default)]
pub(super) struct InnerIterations {
    /// The ways on which statements were reached that may be the first ones of loops.
    entered: BTreeMap<u32, PathPredicates>,
    /// How often a loop began again on fewer ways than those on which it was entered, by its first statement, and its last statement.
    again: BTreeMap<u32, (u32, u32)>,
}

impl InnerIterations {
    /// Notes how a statement is reached, if no jump back led there.
    pub(super) fn reach(&mut self, statement: u32, ways: &PathPredicates) {
        if !self.again.contains_key(&statement) {
            self.entered.insert(statement, ways.clone());
        }
    }

    /// Whether a loop has begun again so often that nobody knows how often it will.
    pub(super) fn is_over(&self, to: u32, ways: &PathPredicates) -> bool {
        !ways.is_never() && self.again.get(&to).is_some_and(|&(rounds, _)| rounds >= ROUNDS_MAX) && self.entered.get(&to) != Some(ways)
    }

    /// Whether a statement is in a loop that has begun again more often than most loops do of which nobody knows how often that is.
    pub(super) fn is_unlikely(&self, statement: u32) -> bool {
        self.again.iter().any(|(&first, &(rounds, last))| rounds >= LIKELY_ROUNDS && (first..=last).contains(&statement))
    }

    /// Begins a loop again behind a statement. Those in it are entered again.
    pub(super) fn begin(&mut self, (to, statement): (u32, u32), ways: &PathPredicates) {
        let is_known = self.entered.get(&to) == Some(ways);
        let (rounds, last) = self.again.entry(to).or_default();
        (*rounds, *last) = (*rounds + u32::from(!is_known), statement);
        self.again.retain(|&first, _| first <= to);
    }
}

impl SsaBuilder<'_, '_> {
    /// Whether there are loops in the iteration, and most that was read of them is what most iterations do.
    pub(super) fn has_few_iterations_inside(&self) -> bool {
        self.jumped_back > 0 && self.repeated * REPEATED_MIN <= self.read
    }

    /// Goes back to the beginning of an inner loop, which has another iteration.
    pub(super) fn jump_back(&mut self, rounds: &mut InnerIterations, statement: u32, to: u32) -> Option<()> {
        self.jumped_back += 1;
        if self.jumped_back > JUMPS_BACK_MAX {
            return None;
        }
        rounds.begin((to, statement), &self.ways);
        self.take(u32::from(self.translator.native().weight_of_jump((statement, to))))
    }

    /// Takes it that no iteration goes some ways, if that can be looked at before the loop.
    pub(super) fn never(&mut self, ways: PathPredicates) -> Option<()> {
        if ways.is_always() || self.level != Level::Outer {
            return None;
        }
        let [no, yes] = [0, 1].map(|number| self.constant(number));
        let here = std::mem::replace(&mut self.ways, ways.clone());
        let reached = self.chosen(yes, no);
        self.ways = here;
        self.kernel.required.push((reached, 1));
        self.beyond.join(ways)
    }

    /// Where no path comes from, it does not matter what is there: ways on which some iterations go on are fewer then, perhaps.
    pub(super) fn join_beyond(&mut self) {
        if self.beyond.is_never() || self.ways.is_always() {
            return;
        }
        let conditions = |ways: &PathPredicates| ways.each().iter().map(Vec::len).sum::<usize>();
        let mut all = self.ways.clone();
        if all.join(self.beyond.clone()).is_some() && conditions(&all) < conditions(&self.ways) {
            self.ways = all;
        }
    }
}
