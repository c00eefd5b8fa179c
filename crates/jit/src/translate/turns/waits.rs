//! What conditions cost that become choices: both sides are computed then, and a choice waits for the longer one, also where few turns take
//! it.

use std::collections::HashMap;

use sieben_engine::ir::Op;

use super::kernel::{Cell, Kernel, Level, Node, What};
use super::line::Carried;
use super::reader::divides;

/// Steps of the processor that a turn has to save at best, for jumps to be worth it: some more than half of what one costs that was not
/// foreseen.
const SAVED_MIN: u32 = 12;

/// Places that turns write under a condition, from which on jumps are faster: each is read, chosen for and written in all turns.
const WRITTEN_MIN: usize = 2;
/// Choices of which each turn makes one after another, from which on jumps are faster, unless turns wait for what they leave anyway.
const CHOICES_MIN: usize = 5;
/// Steps for which a turn waits with the choice of an extreme, from which on a jump is faster if its place is noted, too: it changes seldom.
const EXTREME_MIN: u32 = 3;

/// Steps of the processor from what a cell held to a value.
#[derive(Clone, Copy)]
struct Wait {
    /// On the shortest way through choices.
    least: u32,
    /// On the longest way.
    most: u32,
}

impl Kernel {
    /// Whether jumps are likely to be faster than choices: each turn would wait for a long calculation with what the one before left, over
    /// which it might as well jump.
    pub(super) fn waits_for_choices(&self) -> bool {
        let waits =
            |cell: Cell, end: Node| self.wait(end, cell, &mut HashMap::new()).is_some_and(|wait| wait.most >= wait.least + SAVED_MIN);
        self.inner.is_none()
            && self.carried(Level::Outer).into_iter().any(|(cell, end, carried)| carried == Carried::Chain && waits(cell, end))
    }

    /// Whether turns that are done one by one are likely to be faster with jumps than with choices because there are so many, or because they
    /// are seldom made.
    pub(super) fn is_for_jumps(&self) -> bool {
        let is_choice = |node: Node| matches!(self.what(node), What::Compute(Op::Select, _));
        let written = self.accesses.iter().filter(|access| access.value.is_some_and(is_choice)).count();
        let waits: Vec<Wait> = (self.carried(Level::Outer).into_iter())
            .filter(|(.., carried)| *carried == Carried::Chain)
            .filter_map(|(cell, end, _)| self.wait(end, cell, &mut HashMap::new()))
            .collect();
        let choices = self.reached().into_iter().filter(|&node| is_choice(node)).count();
        let waits_for_none = waits.iter().all(|wait| wait.least == 0);
        let has_place = waits.iter().any(|wait| wait.least == 0 && wait.most > 0);
        let has_extreme = waits.iter().any(|wait| wait.least >= EXTREME_MIN && wait.least == wait.most);
        written >= WRITTEN_MIN || choices >= CHOICES_MIN && waits_for_none || waits.len() == 2 && has_place && has_extreme
    }

    /// How long a value waits for what a cell holds when a turn begins; `None` if it does not rest on that.
    fn wait(&self, node: Node, cell: Cell, known: &mut HashMap<Node, Option<Wait>>) -> Option<Wait> {
        if let Some(&wait) = known.get(&node) {
            return wait;
        }
        let wait = match self.what(node) {
            _ if self.is_start(node, Level::Outer, cell) => Some(Wait { least: 0, most: 0 }),
            What::Compute(op, args) => {
                let waits = args.map(|arg| self.wait(arg, cell, known));
                let own = &waits[..op.arity()];
                let most = own.iter().flatten().map(|wait| wait.most).max();
                let least = match (op, own) {
                    // The other way waits for nothing.
                    (Op::Select, [None, None, _] | [None, _, None]) => 0,
                    (Op::Select, [None, Some(a), Some(b)]) => a.least.min(b.least),
                    _ => own.iter().flatten().map(|wait| wait.least).max().unwrap_or_default() + steps(op),
                };
                most.map(|most| Wait { least, most: most + steps(op) })
            }
            _ => None,
        };
        known.insert(node, wait);
        wait
    }
}

/// Steps that an operation takes: about as many as on the processors of these years.
fn steps(op: Op) -> u32 {
    match op {
        op if divides(op) => 10,
        Op::DivF32 | Op::DivF64 => 12,
        Op::MulU16 | Op::MulU32 | Op::MulU64 | Op::MulI16Wide | Op::MulI32Wide => 3,
        Op::AddF32 | Op::SubF32 | Op::MulF32 | Op::AddF64 | Op::SubF64 | Op::MulF64 => 4,
        _ => 1,
    }
}
