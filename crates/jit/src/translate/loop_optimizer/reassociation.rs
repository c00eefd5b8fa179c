//! Reassociation: what an iteration adds to a variable in several steps, some of them under conditions, as one add reduction; and sums of
//! products.

use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::kernel::{Definition, Kernel, Level, Node, Slot};
use super::scalar_evolution::Shape;
use super::vectorization::Lanes;
use crate::passes::Pass;

/// Steps of an iteration that add to the same variable.
const STEPS_MAX: usize = 16;

/// What was added to what a slot held when the iteration began.
#[derive(Clone, Copy)]
enum Addend {
    Nothing,
    /// A value.
    This(Node),
}

impl Kernel {
    /// Writes what slots hold at the end of an iteration as what they held when it began and one value, where it is a sum in several steps.
    pub(super) fn add_at_once(&mut self) {
        if !self.passes.has(Pass::Reassociation) {
            return;
        }
        if self.inner.is_some() {
            return;
        }
        let ends: Vec<(Slot, Node)> = self.outer.ends.iter().map(|(&slot, &end)| (slot, end)).collect();
        for (slot, end) in ends {
            let (op, narrow) = match self.what(end) {
                _ if self.kept(slot).is_wide() => continue,
                Definition::Compute(Op::AddU16 | Op::SubU16, _) => (Op::AddU16, true),
                Definition::Compute(Op::AddU32 | Op::SubU32, _) => (Op::AddU32, false),
                Definition::Compute(Op::Select, _) => (Op::AddU32, self.is_16_bits(end)),
                _ => continue,
            };
            let op = if narrow { Op::AddU16 } else { op };
            // It is one already, or the slot is affine.
            if let Definition::Compute(Op::AddU16 | Op::AddU32, [a, b, ..]) = self.what(end)
                && [a, b].iter().any(|&node| self.is_start(node, Level::Outer, slot))
            {
                continue;
            }
            let before = self.nodes.len();
            match self.added(end, slot, narrow, STEPS_MAX) {
                Some(Addend::This(added)) if !self.rests_on(added, Level::Outer, slot) => {
                    let start = self.add(Definition::Start(Level::Outer, slot));
                    let sum = self.add(Definition::Compute(op, [start, added, start, start]));
                    self.outer.ends.insert(slot, sum);
                }
                _ => self.nodes.truncate(before),
            }
        }
    }

    /// What was added to what a slot held when the iteration began, if a value is such a sum.
    fn added(&mut self, node: Node, slot: Slot, narrow: bool, steps: usize) -> Option<Addend> {
        if self.is_start(node, Level::Outer, slot) {
            return Some(Addend::Nothing);
        }
        let Definition::Compute(op, [a, b, c, _]) = self.what(node) else { return None };
        let steps = steps.checked_sub(1)?;
        let [add, subtract] = if narrow { [Op::AddU16, Op::SubU16] } else { [Op::AddU32, Op::SubU32] };
        if op == add {
            let (before, more) = match self.added(a, slot, narrow, steps) {
                Some(before) => (before, b),
                None => (self.added(b, slot, narrow, steps)?, a),
            };
            return Some(Addend::This(match before {
                Addend::Nothing => more,
                Addend::This(before) => self.add(Definition::Compute(add, [before, more, before, before])),
            }));
        }
        if op == subtract {
            let before = match self.added(a, slot, narrow, steps)? {
                Addend::Nothing => self.add(Definition::Constant(0)),
                Addend::This(before) => before,
            };
            return Some(Addend::This(self.add(Definition::Compute(subtract, [before, b, before, before]))));
        }
        if op != Op::Select {
            return None;
        }
        let [yes, no] = [self.added(b, slot, narrow, steps)?, self.added(c, slot, narrow, steps)?];
        Some(Addend::This(match (yes, no) {
            (Addend::Nothing, Addend::Nothing) => return Some(Addend::Nothing),
            (Addend::This(yes), Addend::Nothing) => self.add(Definition::Compute(Op::Gate, [yes, a, yes, yes])),
            (yes, no) => {
                let [yes, no] = [yes, no].map(|added| match added {
                    Addend::Nothing => self.add(Definition::Constant(0)),
                    Addend::This(added) => added,
                });
                self.add(Definition::Compute(Op::Select, [a, yes, no, a]))
            }
        }))
    }
}

impl Kernel {
    /// The numbers of 16 bits with signs of which a value is the product, if they have vectors.
    pub(super) fn factors_of_halves(&self, node: Node) -> Option<[Node; 2]> {
        let extended = |node: Node| match self.what(node) {
            Definition::Compute(Op::Extend16, [of, ..]) => Some(of),
            _ => None,
        };
        let factors = match self.what(node) {
            Definition::Compute(Op::MulI16Wide, [a, b, ..]) => [a, b],
            Definition::Compute(Op::MulU32, [a, b, ..]) => [extended(a)?, extended(b)?],
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
