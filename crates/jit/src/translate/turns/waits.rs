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
