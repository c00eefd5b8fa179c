//! What a turn adds to a variable in several steps, some of them under conditions, as one sum; and sums of products.

use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::kernel::{Cell, Kernel, Level, Node, What};
use super::line::Shape;
use super::vector::Lanes;
use crate::passes::Pass;

/// Steps of a turn that add to the same variable.
const STEPS_MAX: usize = 16;

/// What was added to what a cell held when the turn began.
#[derive(Clone, Copy)]
enum Added {
    Nothing,
    /// A value.
    This(Node),
}

impl Kernel {
    /// Writes what cells hold at the end of a turn as what they held when it began and one value, where it is a sum in several steps.
    pub(super) fn add_at_once(&mut self) {
        if !self.passes.has(Pass::Reassociation) {
            return;
        }
        if self.inner.is_some() {
            return;
        }
        let ends: Vec<(Cell, Node)> = self.outer.ends.iter().map(|(&cell, &end)| (cell, end)).collect();
        for (cell, end) in ends {
            let (op, narrow) = match self.what(end) {
                _ if self.kept(cell).is_wide() => continue,
                What::Compute(Op::AddU16 | Op::SubU16, _) => (Op::AddU16, true),
                What::Compute(Op::AddU32 | Op::SubU32, _) => (Op::AddU32, false),
                What::Compute(Op::Select, _) => (Op::AddU32, self.is_16_bits(end)),
                _ => continue,
            };
            let op = if narrow { Op::AddU16 } else { op };
            // It is one already, or the cell is on a line.
            if let What::Compute(Op::AddU16 | Op::AddU32, [a, b, ..]) = self.what(end)
                && [a, b].iter().any(|&node| self.is_start(node, Level::Outer, cell))
            {
                continue;
            }
            let before = self.nodes.len();
            match self.added(end, cell, narrow, STEPS_MAX) {
                Some(Added::This(added)) if !self.rests_on(added, Level::Outer, cell) => {
                    let start = self.add(What::Start(Level::Outer, cell));
                    let sum = self.add(What::Compute(op, [start, added, start, start]));
                    self.outer.ends.insert(cell, sum);
                }
                _ => self.nodes.truncate(before),
            }
        }
    }

    /// What was added to what a cell held when the turn began, if a value is such a sum.
    fn added(&mut self, node: Node, cell: Cell, narrow: bool, steps: usize) -> Option<Added> {
        if self.is_start(node, Level::Outer, cell) {
            return Some(Added::Nothing);
        }
        let What::Compute(op, [a, b, c, _]) = self.what(node) else { return None };
        let steps = steps.checked_sub(1)?;
        let [add, subtract] = if narrow { [Op::AddU16, Op::SubU16] } else { [Op::AddU32, Op::SubU32] };
        if op == add {
            let (before, more) = match self.added(a, cell, narrow, steps) {
                Some(before) => (before, b),
                None => (self.added(b, cell, narrow, steps)?, a),
            };
            return Some(Added::This(match before {
                Added::Nothing => more,
                Added::This(before) => self.add(What::Compute(add, [before, more, before, before])),
            }));
        }
        if op == subtract {
            let before = match self.added(a, cell, narrow, steps)? {
                Added::Nothing => self.add(What::Constant(0)),
                Added::This(before) => before,
            };
            return Some(Added::This(self.add(What::Compute(subtract, [before, b, before, before]))));
        }
        if op != Op::Select {
            return None;
        }
        let [yes, no] = [self.added(b, cell, narrow, steps)?, self.added(c, cell, narrow, steps)?];
        Some(Added::This(match (yes, no) {
            (Added::Nothing, Added::Nothing) => return Some(Added::Nothing),
            (Added::This(yes), Added::Nothing) => self.add(What::Compute(Op::Gate, [yes, a, yes, yes])),
            (yes, no) => {
                let [yes, no] = [yes, no].map(|added| match added {
                    Added::Nothing => self.add(What::Constant(0)),
                    Added::This(added) => added,
                });
                self.add(What::Compute(Op::Select, [a, yes, no, a]))
            }
        }))
    }
}

impl Kernel {
    /// The numbers of 16 bits with signs of which a value is the product, if they have vectors.
    pub(super) fn factors_of_halves(&self, node: Node) -> Option<[Node; 2]> {
        let extended = |node: Node| match self.what(node) {
            What::Compute(Op::Extend16, [of, ..]) => Some(of),
            _ => None,
        };
        let factors = match self.what(node) {
            What::Compute(Op::MulI16Wide, [a, b, ..]) => [a, b],
            What::Compute(Op::MulU32, [a, b, ..]) => [extended(a)?, extended(b)?],
            _ => return None,
        };
        factors.iter().all(|&factor| self.shape(factor) == Some(Shape::Halves)).then_some(factors)
    }
}

impl Translator<'_> {
    /// The products of numbers of 16 bits, each added to the next one: it does not matter which lane of a sum a product goes to.
    pub(super) fn products_in_pairs(&mut self, factors: &[Lanes; 2], lanes: u32) -> Vec<Value> {
        let [a, b] = [0, 1].map(|at: usize| self.halves(&factors[at], lanes));
        let both = a.into_iter().zip(b);
        let products = both.map(|(a, b)| {
            let low = [a, b].map(|vector| self.b.ins().swiden_low(vector));
            let high = [a, b].map(|vector| self.b.ins().swiden_high(vector));
            let [low, high] = [low, high].map(|[a, b]| self.b.ins().imul(a, b));
            self.b.ins().iadd_pairwise(low, high)
        });
        products.collect()
    }
}
