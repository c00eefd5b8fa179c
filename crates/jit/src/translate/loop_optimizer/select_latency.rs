//! Cost of if-converted conditions: both sides are computed, and a select waits for the longer one, even where few iterations take it.

use std::collections::HashMap;

use sieben_engine::ir::Op;

use super::kernel::{Definition, Kernel, Level, Node, Slot};
use super::scalar_evolution::Recurrence;
use super::ssa_construction::divides;

/// Steps of the processor that an iteration has to save at best, for jumps to be worth it: some more than half of what one costs that was
/// not foreseen.
const SAVED_MIN: u32 = 12;

/// Steps of the processor from what a slot held to a value.
#[derive(Clone, Copy)]
struct Latency {
    /// On the shortest way through choices.
    least: u32,
    /// On the longest way.
    most: u32,
}

impl Kernel {
    /// Whether jumps are likely to be faster than choices: each iteration would wait for a long calculation with what the one before left,
    /// over which it might as well jump.
    pub(super) fn waits_for_choices(&self) -> bool {
        let waits =
            |slot: Slot, end: Node| self.wait(end, slot, &mut HashMap::new()).is_some_and(|wait| wait.most >= wait.least + SAVED_MIN);
        self.inner.is_none()
            && self.carried(Level::Outer).into_iter().any(|(slot, end, carried)| carried == Recurrence::Chain && waits(slot, end))
    }

    /// How long a value waits for what a slot holds when an iteration begins; `None` if it does not rest on that.
    fn wait(&self, node: Node, slot: Slot, known: &mut HashMap<Node, Option<Latency>>) -> Option<Latency> {
        if let Some(&wait) = known.get(&node) {
            return wait;
        }
        let wait = match self.what(node) {
            _ if self.is_start(node, Level::Outer, slot) => Some(Latency { least: 0, most: 0 }),
            Definition::Compute(op, args) => {
                let waits = args.map(|arg| self.wait(arg, slot, known));
                let own = &waits[..op.arity()];
                let most = own.iter().flatten().map(|wait| wait.most).max();
                let least = match (op, own) {
                    // The other way waits for nothing.
                    (Op::Select, [None, None, _] | [None, _, None]) => 0,
                    (Op::Select, [None, Some(a), Some(b)]) => a.least.min(b.least),
                    _ => own.iter().flatten().map(|wait| wait.least).max().unwrap_or_default() + steps(op),
                };
                most.map(|most| Latency { least, most: most + steps(op) })
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
