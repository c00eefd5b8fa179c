//! A loop in a loop whose own turns can be done side by side while those around it follow one another: the looks in front of it, what it
//! takes from the budget and what its cells begin with are settled once, in front of the outer loop.

use std::collections::{BTreeSet, HashMap};

use sieben_model::address::Width;

use super::count;
use super::kernel::{Cell, Kept, Kernel, Level, Node, Step, Turn, What};
use super::vector::Lanes;
use super::write::{Scope, Writing};
use super::{InnerTurns, Plan, Writes};

/// Iterations side by side that are unrolled.
const UNROLLED_MAX: u32 = 4;
/// Memory accesses of all iterations that are unrolled.
const UNROLLED_ACCESSES_MAX: usize = 24;

/// How the turns of an inner loop are done side by side.
pub(super) struct Nested {
    /// The inner loop alone.
    plan: Plan,
    lanes: u32,
    /// How many turns it has.
    turns: i64,
    /// What its cells hold when it begins, as values of the outer loop.
    starts: Vec<(Cell, Node)>,
}

impl Plan {
    /// How turns of the inner loop are done side by side, if they can be: all of its accesses are known to stay inside.
    pub(super) fn nested(&self) -> Option<Nested> {
        let InnerTurns::Constant(inner_turns) = self.inner else { return None };
        let (kernel, starts) = self.kernel.inner_alone()?;
        let count = count::condition(&kernel, Level::Outer)?;
        let plan = Self { kernel, count, inner: InnerTurns::Constant(0) };
        if plan.kernel.is_by_four() {
            return None;
        }
        let fits = |&lanes: &u32| i64::from(lanes) <= inner_turns;
        let lanes =
            plan.lanes().into_iter().flat_map(|lanes| [lanes, lanes / 2]).filter(|&lanes| lanes >= plan.least_lanes()).find(fits)?;
        Some(Nested { plan, lanes, starts, turns: inner_turns })
    }
}

impl Kernel {
    /// The inner loop as a loop of its own, and what its cells hold when it begins: what is the same in all of its turns is in cells, too.
    fn inner_alone(&self) -> Option<(Self, Vec<(Cell, Node)>)> {
        let inner = self.inner.as_ref()?;
        let numbers: Vec<usize> =
            inner.steps.iter().map(|step| if let Step::Access(number) = *step { Some(number) } else { None }).collect::<Option<_>>()?;
        let mut kernel = Self { cells: self.cells.clone(), bounds: self.bounds.clone(), size: self.size, ..Self::empty() };
        kernel.nodes = vec![What::Constant(0); self.nodes.len()];
        let mut starts: Vec<(Cell, Node)> = self.carried_into(inner).collect();
        let accesses = numbers.iter().map(|&number| &self.accesses[number]);
        let mut waiting: Vec<Node> = accesses.flat_map(|access| [Some(access.pointer), access.value]).flatten().collect();
        waiting.extend(inner.ends.values());
        waiting.push(inner.again);
        waiting.extend(numbers.iter().map(|&number| self.reads[number]));
        let mut fixed = HashMap::new();
        let mut seen = BTreeSet::new();
        while let Some(node) = waiting.pop() {
            if !seen.insert(node) {
                continue;
            }
            kernel.nodes[node.number() as usize] = match self.what(node) {
                constant @ What::Constant(_) => constant,
                What::Start(Level::Inner, cell) => {
                    let entry = *inner.entry.get(&cell)?;
                    if !starts.iter().any(|&(other, _)| other == cell) {
                        starts.push((cell, entry));
                    }
                    What::Start(Level::Outer, cell)
                }
                What::Read(access) if self.accesses[access].level == Level::Inner => {
                    What::Read(numbers.iter().position(|&number| number == access)?)
                }
                What::After(_) => return None,
                compute @ What::Compute(op, args) if !self.is_fixed(node, &mut fixed) => {
                    waiting.extend(&args[..op.arity()]);
                    compute
                }
                What::Start(Level::Outer, _) | What::Read(_) | What::Compute(..) => {
                    let cell = Cell::numbered(u16::try_from(kernel.cells.len()).ok()?);
                    kernel.cells.push(Kept::Given { width: self.width_of(node) });
                    starts.push((cell, node));
                    What::Start(Level::Outer, cell)
                }
            };
        }
        kernel.accesses = numbers.iter().map(|&number| self.accesses[number].clone()).collect();
        kernel.accesses.iter_mut().for_each(|access| access.level = Level::Outer);
        kernel.reads = numbers.iter().map(|&number| self.reads[number]).collect();
        let steps = (0..numbers.len()).map(Step::Access).collect();
        kernel.outer = Turn { steps, ends: inner.ends.clone(), again: inner.again, ..Turn::default() };
        Some((kernel, starts))
    }

    /// Whether a value is the same in all turns of the inner loop.
    pub(super) fn is_fixed(&self, node: Node, known: &mut HashMap<Node, bool>) -> bool {
        if let Some(&fixed) = known.get(&node) {
            return fixed;
        }
        let fixed = match self.what(node) {
            What::Constant(_) | What::Start(Level::Outer, _) => true,
            What::Start(Level::Inner, _) | What::After(_) => false,
            What::Read(access) => self.accesses[access].level == Level::Outer,
            What::Compute(op, args) => args[..op.arity()].iter().all(|&arg| self.is_fixed(arg, known)),
        };
        known.insert(node, fixed);
        fixed
    }

    /// The width of what a value is.
    pub(super) fn width_of(&self, node: Node) -> Width {
        match () {
            () if self.is_bit(node) => Width::Bit,
            () if self.is_16_bits(node) => Width::Word,
            () if self.is_32_bits(node) => Width::DoubleWord,
            () => Width::QuadWord,
        }
    }
}

impl Writing<'_, '_, '_> {
    /// Writes all turns of the inner loop, as many as possible side by side.
    pub(super) fn inner_side_by_side(&mut self, nested: &Nested) {
        let Nested { plan, lanes, turns, starts } = nested;
        let before = starts.iter().map(|&(cell, node)| (cell, self.first(node, Level::Outer))).collect();
        let rest = turns % i64::from(*lanes);
        let turns = turns - rest;
        let times = u32::try_from(turns / i64::from(*lanes)).unwrap_or(u32::MAX);
        let few = times <= UNROLLED_MAX && plan.kernel.accesses.len() * times as usize <= UNROLLED_ACCESSES_MAX;
        let count = self.t.turns_constant(turns);
        let writes = Writes::lanes(*lanes);
        let mut inner = Writing::new(self.t, plan, writes);
        inner.before = before;
        inner.unrolled = if few { times } else { 1 };
        inner.turns(Level::Outer, count);
        let ends = inner.ends(count);
        self.inner = Scope::default();
        if rest == 0 {
            for (cell, value) in ends {
                let after = (0..).map(Node::numbered).zip(&self.kernel.nodes).filter(|(_, what)| **what == What::After(cell));
                self.outer.values.extend(after.map(|(node, _)| (node, Lanes::One(value))));
            }
        } else {
            self.entered = ends.into_iter().collect();
            let rest = self.t.turns_constant(rest);
            self.turns(Level::Inner, rest);
        }
    }
}
