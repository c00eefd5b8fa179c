//! Loop versioning: a counted loop has a fast version. When the safe-point budget covers all iterations and every access is in bounds, it
//! runs without safe points and bounds checks, with variables and accumulators in registers of the machine, and vectorized where iterations
//! are independent.
//!
//! Before the loop the number of iterations is computed that can be done so. Where the general version goes on after them, memory,
//! registers and budget are as if it had made them.

use std::borrow::Cow;
use std::collections::BTreeSet;

use cranelift_codegen::ir::InstBuilder;
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::Translator;
use super::natural_loops::NaturalLoop;
use crate::passes::Pass;

mod accesses;
mod available_values;
mod bit_count_idiom;
mod bit_fill_idiom;
mod bit_interleaving;
mod boolean_simplification;
mod branch_on_superword;
mod canonical_forms;
mod emission;
mod gathered_bits;
mod inner_trip_counts;
mod inspector_executor;
mod interleaved_access;
mod kernel;
mod live_in_out;
mod loop_carried;
mod masks;
mod min_max_reduction;
mod modular_addressing;
mod ordered_reduction;
mod path_predicates;
mod predictive_commoning;
mod reassociation;
mod scalar_evolution;
mod select_latency;
pub(super) mod slp_calls;
mod sparse_iterations;
mod ssa_construction;
mod strided_access;
mod structure_copies;
mod structure_fields;
mod trip_count;
mod vector_division;
pub(super) mod vectorization;
mod wide_lanes;

use bit_interleaving::InterleavedBits;
use branch_on_superword::UniformBranch;
use emission::Emitter;
use kernel::{Access, Definition, Kernel, Level, Node, Slot};
use scalar_evolution::{Recurrence, Shape};
pub(super) use sparse_iterations::Idle;
use trip_count::TripCount;

/// Loops of a function of which there are such versions.
const LOOPS_MAX: usize = 100;

/// Iterations of an inner loop whose numbers are looked at one after the other.
const LOOKED_AT_MAX: i64 = 256;

/// Iterations that are done side by side.
const SIDE_BY_SIDE_MAX: u32 = 32;

/// How a loop is written with vectorized iterations, and how many of them at once, the greatest number first.
struct VectorPlan<'p> {
    plan: Cow<'p, LoopPlan>,
    lanes: Vec<u32>,
}

/// How one version of the iterations is written.
struct VersionPlan<'k> {
    /// Vectorized iterations.
    lanes: u32,
    /// Accesses whose bits make whole bytes, if eight iterations are written behind one another.
    gathered: Option<InterleavedBits>,
    /// Those that make whole bytes in iterations behind these ones: single iterations are made up to the first bit of a byte.
    up_to: Option<InterleavedBits>,
    /// How vectorized iterations are done that all go the same way.
    alike: Option<&'k UniformBranch>,
}

impl InnerTripCount {
    /// How many these are as far as that is known when the program is compiled.
    fn known(self) -> i64 {
        match self {
            Self::Constant(iterations) => iterations,
            Self::Counted(_) => 0,
        }
    }
}

impl VersionPlan<'_> {
    fn lanes(lanes: u32) -> Self {
        Self { lanes, gathered: None, up_to: None, alike: None }
    }
}

/// How a loop is written.
#[derive(Clone)]
pub(super) struct LoopPlan {
    kernel: Kernel,
    count: TripCount,
    inner: InnerTripCount,
}

/// How many iterations the inner loop makes in each iteration of the outer one.
#[derive(Clone, Copy)]
enum InnerTripCount {
    /// So many; 0 if there is no such loop.
    Constant(i64),
    /// As many as can be counted before the outer loop.
    Counted(TripCount),
}

impl LoopPlan {
    /// What a slot holds when the inner loop begins.
    fn entry(&self, slot: Slot) -> Node {
        let inner = self.kernel.iteration(Level::Inner);
        inner.entry[&slot]
    }

    /// The step of a pointer whose address is counted on from iteration to iteration.
    fn counted_on(&self, access: &Access, level: Level) -> Option<u32> {
        self.kernel.counted_on(access, level)
    }
}

impl Translator<'_> {
    /// Whether a loop, or one around it, is done at once.
    pub(super) fn is_at_once(&self, it: &NaturalLoop) -> bool {
        self.at_once.iter().any(|&(first, last)| first <= it.first && it.last <= last)
    }

    /// Whether the function has as many loops with such versions as it may have.
    fn has_enough_at_once(&self) -> bool {
        self.loops_at_once >= LOOPS_MAX
    }

    fn note_at_once(&mut self, it: &NaturalLoop) {
        self.at_once.push((it.first, it.last));
        self.loops_at_once += 1;
    }

    /// Writes fast versions of a loop, before it. What is given back are iterations that do nothing, if
    /// the loop as it stands passes them: where most of them do nothing, that is faster.
    pub(super) fn iterations_at_once(&mut self, it: &NaturalLoop) -> Option<Idle> {
        self.write_at_once(it).or_else(|| {
            self.write_with_copies(it);
            self.idle_iterations(it)
        })
    }

    /// Writes a loop that copies structures as a whole.
    fn write_with_copies(&mut self, it: &NaturalLoop) {
        if !self.options.does(Pass::LoopVersioning) || self.has_enough_at_once() || self.is_at_once(it) {
            return;
        }
        let Some(plan) = self.one_by_one(it).filter(|plan| !plan.kernel.copies.is_empty()) else { return };
        self.note_at_once(it);
        Emitter::write(self, &plan, it, VersionPlan::lanes(1));
    }

    /// How a loop is written whose iterations are done one by one, hand on what the next one would read, and copy structures as a whole.
    fn one_by_one(&mut self, it: &NaturalLoop) -> Option<LoopPlan> {
        let kernel = ssa_construction::read_one_by_one(self, it)?;
        if kernel.only_side_by_side || !kernel.goes_on() {
            return None;
        }
        if self.keeps_some_of_kernel(&kernel) {
            return None;
        }
        self.pinned.extend(&kernel.opened);
        LoopPlan::of(kernel.with_ahead())
    }

    /// Whether iterations may reach what is kept in a register: a loop around a block that became part of it does not know where the block
    /// reaches by its pointers.
    fn keeps_some_of_kernel(&self, kernel: &Kernel) -> bool {
        let ends = kernel.copies.iter().flat_map(|copied| [&copied.from, &copied.to]);
        kernel.accesses.iter().chain(ends).any(|access| self.keeps_some_of(access.bytes()))
    }

    /// How a loop is written whose inner loops are part of its iterations, iteration by iteration.
    fn unrolled(&mut self, it: &NaturalLoop) -> Option<LoopPlan> {
        let kernel = ssa_construction::read_unrolled(self, it).filter(Kernel::goes_on)?;
        if self.keeps_some_of_kernel(&kernel) {
            return None;
        }
        self.pinned.extend(&kernel.opened);
        LoopPlan::of(kernel)
    }

    /// Whether there is no loop in a loop, or one that is done side by side as such: it has more iterations than are worth writing one by
    /// one.
    fn needs_no_unrolling(&mut self, kernel: Option<&Kernel>, it: &NaturalLoop) -> bool {
        let Some(kernel) = kernel else { return false };
        if kernel.inner.is_none() {
            return true;
        }
        let plan = LoopPlan::of(kernel.clone());
        plan.is_some_and(|plan| plan.side_by_side_or_in_order().is_some()) || self.inner_is_side_by_side(it)
    }

    fn write_at_once(&mut self, it: &NaturalLoop) -> Option<Idle> {
        if !self.options.does(Pass::LoopVersioning) || self.has_enough_at_once() || self.is_at_once(it) {
            return None;
        }
        let kernel = ssa_construction::read(self, it).filter(Kernel::goes_on);
        if !self.needs_no_unrolling(kernel.as_ref(), it)
            && let Some(plan) = self.unrolled(it)
            && let Some(beside) = plan.side_by_side_or_in_order()
        {
            self.note_at_once(it);
            self.write_beside(&beside, it);
            return None;
        }
        let kernel = kernel?;
        if self.keeps_some_of_kernel(&kernel) {
            return None;
        }
        self.pinned.extend(&kernel.opened);
        let filled = if kernel.inspected.is_empty() { bit_fill_idiom::read(&kernel) } else { None };
        if let Some(bits) = &filled {
            self.note_at_once(it);
            self.bits_at_once(&kernel, bits, it);
        }
        let plan = LoopPlan::of(kernel)?;
        if plan.kernel.only_side_by_side {
            if plan.kernel.inner.is_none()
                && let Some(beside) = plan.side_by_side_or_in_order()
            {
                self.note_at_once(it);
                self.write_beside(&beside, it);
            }
            return None;
        }
        if plan.kernel.inner.is_some() && plan.side_by_side_or_in_order().is_none() && self.inner_is_side_by_side(it) {
            return None;
        }
        let sums = bit_count_idiom::read(&plan);
        let one_by_one = sums.is_none() && plan.kernel.inner.is_none() && plan.side_by_side_or_in_order().is_none();
        let idle = if one_by_one { self.idle_iterations(it) } else { None };
        let few = idle.as_ref().map(|idle| self.look_for_idle_iterations(idle));
        self.note_at_once(it);
        if let Some(sums) = sums {
            self.bit_sums_at_once(&plan, &sums, it);
        }
        let ahead = if one_by_one { self.one_by_one(it).filter(|plan| !plan.kernel.ahead.is_empty()) } else { None };
        let plan = ahead.unwrap_or(plan);
        let all_at_once = self.write_side_by_side(&plan, it);
        let has_bits = || plan.kernel.accesses.iter().any(|access| plan.kernel.bits_follow(access).is_some());
        if !all_at_once && filled.is_none() && idle.is_none() && has_bits() {
            let in_pieces = LoopPlan { kernel: plan.kernel.clone().with_bits_ahead(), count: plan.count, inner: plan.inner };
            if let Some(gathered) = in_pieces.kernel.gathered() {
                Emitter::write(self, &in_pieces, it, VersionPlan { up_to: Some(gathered.clone()), ..VersionPlan::lanes(1) });
                Emitter::write(self, &in_pieces, it, VersionPlan { gathered: Some(gathered), ..VersionPlan::lanes(1) });
            }
        }
        Emitter::write(self, &plan, it, VersionPlan::lanes(1));
        if let Some(few) = few {
            self.b.ins().jump(few, &[]);
            self.b.switch_to_block(few);
            self.b.seal_block(few);
        }
        idle
    }

    /// Writes the versions of a loop with vectorized iterations. Whether nothing in them is done in order.
    fn write_side_by_side(&mut self, plan: &LoopPlan, it: &NaturalLoop) -> bool {
        let Some(beside) = plan.side_by_side_or_in_order() else { return false };
        self.write_beside(&beside, it);
        beside.plan.kernel.in_order.nodes.is_empty()
    }

    fn write_beside(&mut self, VectorPlan { plan, lanes }: &VectorPlan<'_>, it: &NaturalLoop) {
        let alike = if lanes[..] == [branch_on_superword::ITERATIONS] { plan.alike() } else { None };
        for &lanes in lanes {
            Emitter::write(self, plan, it, VersionPlan { alike: alike.as_ref(), ..VersionPlan::lanes(lanes) });
        }
    }
}

impl Translator<'_> {
    /// Whether iterations of the loop in a loop can be done side by side, which is then worth more than to do those of both at once.
    fn inner_is_side_by_side(&mut self, it: &NaturalLoop) -> bool {
        let inner = self.loops.iter().find(|inner| inner.first > it.first && inner.last <= it.last).cloned();
        let kernel = inner.and_then(|inner| ssa_construction::read(self, &inner));
        let plan = kernel.filter(|kernel| !kernel.repeats_itself()).and_then(LoopPlan::of);
        plan.is_some_and(|plan| !plan.kernel.is_spread() && !plan.lanes().is_empty())
    }
}

impl LoopPlan {
    /// How a loop is written, if its iterations can be done at once.
    fn of(kernel: Kernel) -> Option<Self> {
        let count = trip_count::condition(&kernel, Level::Outer)?;
        let inner = match &kernel.inner {
            None => InnerTripCount::Constant(0),
            Some(_) => kernel.inner_iterations()?,
        };
        // Only what is affine can be looked at before the loop.
        if !kernel.required.iter().all(|&(number, _)| kernel.is_on_line(number, Level::Outer)) {
            return None;
        }
        let plan = Self { kernel, count, inner };
        plan.can_be_written().then_some(plan)
    }

    /// The same if iterations can be done side by side, with as much in order as needs to be.
    fn side_by_side_or_in_order(&self) -> Option<VectorPlan<'_>> {
        let at_once = VectorPlan { lanes: self.lanes(), plan: Cow::Borrowed(self) };
        if !at_once.lanes.is_empty() {
            return Some(at_once);
        }
        let kernel = self.kernel.with_order()?;
        let in_order = Self { kernel, count: self.count, inner: self.inner };
        let lanes = in_order.lanes();
        (!lanes.is_empty()).then_some(VectorPlan { plan: Cow::Owned(in_order), lanes })
    }

    /// Whether all access is known to stay inside its area, or can be looked at before the loop.
    fn can_be_written(&self) -> bool {
        self.kernel.accesses.iter().all(|access| {
            access.inside.is_some() && access.sure || access.level == Level::Outer && self.counted_on(access, Level::Outer).is_some()
        })
    }

    /// How many iterations are done side by side, the greatest number first.
    fn lanes(&self) -> Vec<u32> {
        let kernel = &self.kernel;
        let least = self.least_lanes();
        if !kernel.passes.has(Pass::Vectorization) || !self.side_by_side() {
            return Vec::new();
        }
        // A vector has half as many numbers of 64 bits.
        let quads = kernel.accesses.iter().any(|access| access.width == Width::QuadWord);
        match kernel.inner {
            Some(_) if quads => vec![16, least],
            Some(_) => vec![SIDE_BY_SIDE_MAX, least],
            // More than four of what lies apart would not stay in registers.
            None if kernel.is_by_four() => vec![4],
            None if quads => vec![least],
            None => vec![2 * least],
        }
    }

    /// The lanes of a vector: there are eight numbers of 16 bits.
    fn least_lanes(&self) -> u32 {
        let kernel = &self.kernel;
        let halves = kernel.accesses.iter().any(|access| access.width == Width::Word) || kernel.computes_halves();
        if halves { 8 } else { 4 }
    }

    /// Whether what an iteration writes in its inner loop lies so far from what it writes there next that iterations beside it write
    /// neither.
    fn iterations_write_apart(&self, access: &Access) -> bool {
        let apart = SIDE_BY_SIDE_MAX * access.width.bytes() * 8;
        access.level == Level::Outer
            || self
                .kernel
                .line(access.pointer, Level::Inner)
                .is_some_and(|line| line.is_same() || line.bits == 32 && (line.step as i32).unsigned_abs() >= apart)
    }

    /// Whether iterations can be done side by side: none needs what another one left, and all values have a form for it.
    fn side_by_side(&self) -> bool {
        let kernel = &self.kernel;
        let fits = |node: Node, wanted: Shape| match (kernel.shape(node), wanted) {
            (Some(Shape::Affine(_) | Shape::Halves), Shape::Halves) => true,
            (Some(Shape::Affine(line)), Shape::Words) => line.bits == 32 || line.is_same(),
            (Some(shape), Shape::Wide) => shape != Shape::Mask,
            (Some(Shape::Affine(line)), _) => line.is_same(),
            (Some(Shape::Halves | Shape::Words | Shape::Reals), Shape::Words) => true,
            (Some(Shape::Words | Shape::Reals), Shape::Reals) => true,
            (Some(Shape::Wide | Shape::Lreals), Shape::Lreals) => true,
            (Some(Shape::Mask), Shape::Mask) => true,
            _ => false,
        };
        for (slot, end, carried) in kernel.carried(Level::Outer) {
            let possible = match carried {
                Recurrence::Affine(_) => true,
                Recurrence::Chain if kernel.in_order.slots.contains(&slot) => true,
                Recurrence::Chain => false,
                Recurrence::Sum { added: other, bits } | Recurrence::MinMax { other, bits, .. } => fits(other, Shape::of_bits(bits)),
                Recurrence::Nothing => kernel.sum_at_start(end).is_some() || kernel.shape(end).is_some(),
            };
            if !possible {
                return false;
            }
        }
        if kernel.inner.is_some() {
            for (slot, end, carried) in kernel.carried(Level::Inner) {
                let possible = match carried {
                    Recurrence::Affine(_) => matches!(kernel.shape(self.entry(slot)), Some(Shape::Affine(_))),
                    Recurrence::Nothing => true,
                    Recurrence::Chain | Recurrence::Sum { .. } | Recurrence::MinMax { .. } => {
                        let shape = kernel.shape_of_inner(slot);
                        shape.is_some() && shape == kernel.shape(end) && shape.is_some_and(|shape| fits(self.entry(slot), shape))
                    }
                };
                if !possible {
                    return false;
                }
            }
        }
        kernel.accesses.iter().enumerate().all(|(number, access)| {
            let form = match access.value {
                None => kernel.shape(kernel.read_of(number)).is_some(),
                Some(value) => {
                    let follows = matches!(kernel.shape(access.pointer), Some(Shape::Affine(line)) if line.bits == 32
                        && line.step == access.width.bytes() * 8);
                    let (is_apart, is_row) = (kernel.apart(access).is_some(), kernel.is_row_of_bits(access));
                    let is_scattered = kernel.is_scattered(access);
                    let form = match access.width {
                        Width::Word => fits(value, Shape::Halves),
                        Width::DoubleWord => fits(value, Shape::Words) || fits(value, Shape::Reals),
                        Width::QuadWord => fits(value, Shape::Wide),
                        Width::Byte => (is_apart || is_scattered) && fits(value, Shape::Words),
                        Width::Bit => (is_apart || is_row) && fits(value, Shape::Mask),
                    };
                    (follows || is_apart || is_row || is_scattered) && form && self.iterations_write_apart(access)
                }
            };
            form && kernel.accesses[..number].iter().all(|other| kernel.are_apart(access, other))
        }) && (!kernel.is_by_four() || kernel.few_are_one_by_one(self.inner.known()))
    }
}

impl Kernel {
    /// Whether its iterations are worth doing at once: they get on, and do not wait for choices of those before them.
    fn goes_on(&self) -> bool {
        !self.repeats_itself() && !self.waits_for_choices()
    }

    /// How many iterations the inner loop makes, if that is the same in all iterations of the outer one and all that is required of these
    /// iterations holds or can be looked at before the loop.
    fn inner_iterations(&self) -> Option<InnerTripCount> {
        let count = trip_count::condition(self, Level::Inner)?;
        let limit = count.limit.map_or(Some(0), |limit| self.constant_at_entry(limit));
        if let (Some(counter), Some(limit)) = (self.constant_at_entry(count.counter), limit) {
            let iterations = count.constant(counter, limit)?;
            let stays_below = self.required_inside.iter().all(|&(number, limit)| self.counts_below(number, limit, iterations));
            return stays_below.then_some(InnerTripCount::Constant(iterations));
        }
        let is_same = |node: Node| self.is_same_in_all_iterations(node);
        let is_counted = is_same(count.counter) && count.limit.is_none_or(is_same);
        let can_be_looked_at = self.required_inside.iter().all(|&(number, _)| self.is_on_line(number, Level::Inner) && is_same(number));
        (is_counted && can_be_looked_at).then_some(InnerTripCount::Counted(count))
    }

    /// Whether vectorized iterations compute with vectors of numbers of 16 bits. Whether another iteration follows is not computed in
    /// them.
    fn computes_halves(&self) -> bool {
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let mut reached = BTreeSet::new();
        self.all_ends().chain(of_accesses).for_each(|node| self.rests(node, &mut reached));
        let adds_halves = |level: Level| {
            let mut carried = self.carried(level).into_iter();
            carried.any(|(.., carried)| matches!(carried, Recurrence::Sum { bits: 16, .. } | Recurrence::MinMax { bits: 16, .. }))
        };
        if adds_halves(Level::Outer) || self.inner.is_some() && adds_halves(Level::Inner) {
            return true;
        }
        let mut computed = reached.into_iter().filter_map(|node| match self.what(node) {
            Definition::Compute(op, _) => Some((op, self.shape(node)?)),
            _ => None,
        });
        computed.any(|(op, shape)| match shape {
            Shape::Halves => true,
            Shape::Affine(_) => false,
            _ => {
                let wide = matches!(op, Op::Extend16 | Op::AddI16Wide | Op::SubI16Wide | Op::MulI16Wide);
                wide || matches!(op, Op::EqI16 | Op::NeI16 | Op::LtI16 | Op::LeI16 | Op::GtI16 | Op::GeI16)
            }
        })
    }

    pub(super) fn counted_on(&self, access: &Access, level: Level) -> Option<u32> {
        if access.level != level || access.width == Width::Bit && access.part.is_none() {
            return None;
        }
        self.line(access.pointer, level).filter(|line| line.bits == 32 && line.step % 8 == 0).map(|line| line.step)
    }

    /// Whether two accesses only read, or what iterations touch with the first is not what iterations behind them have touched with the
    /// other one.
    fn are_apart(&self, a: &Access, b: &Access) -> bool {
        if a.value.is_none() && b.value.is_none() {
            return true;
        }
        let ((base, bytes), (other_base, other)) = (a.bytes(), b.bytes());
        if base != other_base || bytes.end <= other.start || other.end <= bytes.start {
            return true;
        }
        self.iterations_stay_apart(a, b) || self.bits_stay_apart(a, b)
    }

    /// Whether a number that counts in the inner loop stays below a limit for so many iterations of it.
    fn counts_below(&self, number: Node, limit: u32, iterations: i64) -> bool {
        iterations <= LOOKED_AT_MAX
            && (0..iterations)
                .all(|iteration| self.constant_in_iteration(number, iteration).is_some_and(|number| number < u64::from(limit)))
    }

    /// A value in an iteration of the inner loop, if it rests on nothing but what is counted there from constants.
    fn constant_in_iteration(&self, node: Node, iteration: i64) -> Option<u64> {
        match self.what(node) {
            Definition::Start(Level::Inner, slot) => {
                let first = self.constant(*self.inner.as_ref()?.entry.get(&slot)?)?;
                if iteration == 0 {
                    return Some(first);
                }
                let line = self.slot_line(Level::Inner, slot)?;
                if line.is_same() {
                    return Some(first);
                }
                let counted = (first as u32).wrapping_add((iteration as u32).wrapping_mul(line.step));
                Some(if line.bits == 16 { u64::from(counted as u16) } else { u64::from(counted) })
            }
            Definition::Compute(op, args) => {
                let mut words = [0; 4];
                for (word, &arg) in words.iter_mut().zip(&args[..op.arity()]) {
                    *word = self.constant_in_iteration(arg, iteration)?;
                }
                Some(Op::eval(op, words))
            }
            _ => self.constant(node),
        }
    }

    /// A value when the inner loop begins, if it is a constant.
    fn constant_at_entry(&self, node: Node) -> Option<u64> {
        self.constant_in_iteration(node, 0)
    }
}
