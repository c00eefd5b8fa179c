//! Inspector and executor: numbers that have to be below limits in all iterations and are not affine, such as the index of a ring buffer in
//! an instance of a function block. If no iteration changes what they are made of before it uses it, all of them are inspected before the
//! loop.

use std::collections::BTreeSet;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I8;
use cranelift_codegen::ir::{BlockArg, InstBuilder, Value};
use sieben_engine::ir::Op;

use super::emission::Emitter;
use super::kernel::{Access, Definition, Effect, Kernel, Level, Node, Slot, SlotKind};
use super::modular_addressing::Distance;
use super::ordered_reduction::OrderedReduction;
use super::{InnerTripCount, LoopPlan, VersionPlan};
use crate::passes::Pass;

/// Vectorized iterations in which they are looked at.
const ITERATIONS: u32 = 4;

impl Kernel {
    /// Lets numbers on no line be looked at before the loop, if that is possible.
    pub(super) fn look_at_others(&mut self) {
        if !self.passes.has(Pass::InspectorExecutor) {
            return;
        }
        if self.inner.is_some() || !self.copies.is_empty() {
            return;
        }
        let is_other = |&(number, _): &(Node, u32)| !self.is_on_line(number, Level::Outer) && self.is_known_in_front(number);
        let (others, required) = self.required.iter().partition(|required| is_other(required));
        (self.inspected, self.required) = (others, required);
        for &(number, limit) in &self.inspected {
            self.bounds.entry(number).or_insert((0, limit - 1));
        }
    }

    /// Whether a number of each iteration can be made before the loop.
    fn is_known_in_front(&self, number: Node) -> bool {
        let mut all = BTreeSet::new();
        self.rests(number, &mut all);
        all.into_iter().all(|node| match self.what(node) {
            Definition::Constant(_) | Definition::Compute(..) => true,
            Definition::Start(Level::Outer, slot) => self.slot_line(Level::Outer, slot).is_some(),
            Definition::Read(read) => self.is_read_as_it_was(read),
            Definition::Start(Level::Inner, _) | Definition::After(_) => false,
        })
    }

    /// Whether each iteration reads what memory held before the loop.
    fn is_read_as_it_was(&self, read: usize) -> bool {
        let Some(place) = self.outer.steps.iter().position(|&step| step == Effect::Access(read)) else { return false };
        let own = &self.accesses[read];
        let may_change = |(at, step): (usize, &Effect)| match *step {
            Effect::Access(number) => {
                let other = &self.accesses[number];
                let in_iteration = at < place && own.may_meet(other);
                other.value.is_some() && (in_iteration || !self.is_apart_in_later_iterations(own, other))
            }
            Effect::Copy(_) | Effect::Inner => true,
        };
        self.counted_on(own, Level::Outer).is_some() && !self.outer.steps.iter().enumerate().any(may_change)
    }

    /// Whether what an access touches is nothing that another one has touched in an iteration before.
    fn is_apart_in_later_iterations(&self, later: &Access, earlier: &Access) -> bool {
        // One step leads beyond it, and those behind it further.
        let steps_lead_beyond = |Distance { step, ahead, later, earlier }: Distance| {
            step > 0 && step + ahead >= earlier || step < 0 && step + ahead + later <= 0
        };
        !later.may_share(earlier) || self.distances(later, earlier).into_iter().any(steps_lead_beyond)
    }

    /// A loop that looks at these numbers, and the slot in which it counts those that are not below their limits.
    fn looks(&self) -> Option<(Self, Slot)> {
        let mut looks = self.clone();
        let slot = Slot::numbered(u16::try_from(looks.slots.len()).ok()?);
        looks.slots.push(SlotKind::Beyond);
        let start = looks.add(Definition::Start(Level::Outer, slot));
        let [none, one] = [0, 1].map(|number| looks.add(Definition::Constant(number)));
        let mut beyond = none;
        for &(number, limit) in &self.inspected {
            looks.bounds.remove(&number);
            let limit = looks.add(Definition::Constant(limit.into()));
            let is_below = looks.add(Definition::Compute(Op::Below, [number, limit, number, number]));
            let more = looks.add(Definition::Compute(Op::Select, [is_below, none, one, is_below]));
            beyond = if beyond == none { more } else { looks.add(Definition::Compute(Op::AddU32, [beyond, more, beyond, beyond])) };
        }
        let count = looks.add(Definition::Compute(Op::AddU32, [start, beyond, start, start]));
        looks.outer.ends.retain(|&slot, _| self.slot_line(Level::Outer, slot).is_some());
        looks.outer.ends.insert(slot, count);
        (looks.inspected, looks.required, looks.ways) = (Vec::new(), Vec::new(), Vec::new());
        looks.in_order = OrderedReduction::default();
        // Nothing is written, and read is what these numbers are made of.
        for access in &mut looks.accesses {
            (access.value, access.sure) = (None, true);
        }
        looks.forget_unread();
        looks.lines.borrow_mut().clear();
        looks.shapes.borrow_mut().clear();
        Some((looks, slot))
    }
}

impl Emitter<'_, '_, '_> {
    /// Whether numbers on no line are below their limits in so many iterations, if a condition holds; whether both is so.
    pub(super) fn look_at_numbers(&mut self, iterations: Value, guard: Value) -> Value {
        if self.kernel.inspected.is_empty() {
            return guard;
        }
        let Some((kernel, slot)) = self.kernel.looks() else { unreachable!("slots have numbers of 16 bits") };
        let plan = LoopPlan { kernel, count: self.plan.count, inner: InnerTripCount::Constant(0) };
        let lanes = if self.lanes == ITERATIONS && plan.side_by_side() { ITERATIONS } else { 1 };
        let [look, behind] = [self.t.b.create_block(), self.t.b.create_block()];
        let all_below = self.t.b.append_block_param(behind, I8);
        let no = self.t.b.ins().iconst(I8, 0);
        self.t.b.ins().brif(guard, look, &[], behind, &[BlockArg::Value(no)]);
        self.t.b.switch_to_block(look);
        self.t.b.seal_block(look);
        let mut looking = Emitter::new(self.t, &plan, VersionPlan::lanes(lanes));
        looking.before = self.before.clone();
        looking.before.insert(slot, looking.t.slot_before(&plan.kernel, slot));
        looking.iterations(Level::Outer, iterations);
        let ends = looking.ends(iterations);
        let count = ends.into_iter().find(|&(own, _)| own == slot).map(|(_, count)| count).expect("the numbers are counted");
        let count = self.t.int(count);
        let none = self.t.b.ins().icmp_imm_u(IntCC::Equal, count, 0);
        self.t.b.ins().jump(behind, &[BlockArg::Value(none)]);
        self.t.b.switch_to_block(behind);
        self.t.b.seal_block(behind);
        all_below
    }
}
