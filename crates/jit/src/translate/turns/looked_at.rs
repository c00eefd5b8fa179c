//! Numbers that have to be below limits in all turns and lie on no line, such as where an instance of a function block is in a ring buffer
//! of its own. If no turn changes what they are made of before it looks at it, all of them are looked at in front of the loop.

use std::collections::BTreeSet;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I8;
use cranelift_codegen::ir::{BlockArg, InstBuilder, Value};
use sieben_engine::ir::Op;

use super::around::Distance;
use super::in_order::InOrder;
use super::kernel::{Access, Cell, Kept, Kernel, Level, Node, Step, What};
use super::write::Writing;
use super::{InnerTurns, Plan, Writes};
use crate::passes::Pass;

/// Turns side by side in which they are looked at.
const TURNS: u32 = 4;

impl Kernel {
    /// Lets numbers on no line be looked at in front of the loop, if that is possible.
    pub(super) fn look_at_others(&mut self) {
        if !self.passes.has(Pass::InspectorExecutor) {
            return;
        }
        if self.inner.is_some() || !self.copies.is_empty() {
            return;
        }
        let is_other = |&(number, _): &(Node, u32)| !self.is_on_line(number, Level::Outer) && self.is_known_in_front(number);
        let (others, required) = self.required.iter().partition(|required| is_other(required));
        (self.looked_at, self.required) = (others, required);
        for &(number, limit) in &self.looked_at {
            self.bounds.entry(number).or_insert((0, limit - 1));
        }
    }

    /// Whether a number of each turn can be made in front of the loop.
    fn is_known_in_front(&self, number: Node) -> bool {
        let mut all = BTreeSet::new();
        self.rests(number, &mut all);
        all.into_iter().all(|node| match self.what(node) {
            What::Constant(_) | What::Compute(..) => true,
            What::Start(Level::Outer, cell) => self.cell_line(Level::Outer, cell).is_some(),
            What::Read(read) => self.is_read_as_it_was(read),
            What::Start(Level::Inner, _) | What::After(_) => false,
        })
    }

    /// Whether each turn reads what memory held in front of the loop.
    fn is_read_as_it_was(&self, read: usize) -> bool {
        let Some(place) = self.outer.steps.iter().position(|&step| step == Step::Access(read)) else { return false };
        let own = &self.accesses[read];
        let may_change = |(at, step): (usize, &Step)| match *step {
            Step::Access(number) => {
                let other = &self.accesses[number];
                let in_turn = at < place && own.may_meet(other);
                other.value.is_some() && (in_turn || !self.is_apart_in_later_turns(own, other))
            }
            Step::Copy(_) | Step::Inner => true,
        };
        self.counted_on(own, Level::Outer).is_some() && !self.outer.steps.iter().enumerate().any(may_change)
    }

    /// Whether what an access touches is nothing that another one has touched in a turn before.
    fn is_apart_in_later_turns(&self, later: &Access, earlier: &Access) -> bool {
        // One step leads beyond it, and those behind it further.
        let steps_lead_beyond = |Distance { step, ahead, later, earlier }: Distance| {
            step > 0 && step + ahead >= earlier || step < 0 && step + ahead + later <= 0
        };
        !later.may_share(earlier) || self.distances(later, earlier).into_iter().any(steps_lead_beyond)
    }

    /// A loop that looks at these numbers, and the cell in which it counts those that are not below their limits.
    fn looks(&self) -> Option<(Self, Cell)> {
        let mut looks = self.clone();
        let cell = Cell::numbered(u16::try_from(looks.cells.len()).ok()?);
        looks.cells.push(Kept::Beyond);
        let start = looks.add(What::Start(Level::Outer, cell));
        let [none, one] = [0, 1].map(|number| looks.add(What::Constant(number)));
        let mut beyond = none;
        for &(number, limit) in &self.looked_at {
            looks.bounds.remove(&number);
            let limit = looks.add(What::Constant(limit.into()));
            let is_below = looks.add(What::Compute(Op::Below, [number, limit, number, number]));
            let more = looks.add(What::Compute(Op::Select, [is_below, none, one, is_below]));
            beyond = if beyond == none { more } else { looks.add(What::Compute(Op::AddU32, [beyond, more, beyond, beyond])) };
        }
        let count = looks.add(What::Compute(Op::AddU32, [start, beyond, start, start]));
        looks.outer.ends.retain(|&cell, _| self.cell_line(Level::Outer, cell).is_some());
        looks.outer.ends.insert(cell, count);
        (looks.looked_at, looks.required, looks.ways) = (Vec::new(), Vec::new(), Vec::new());
        looks.in_order = InOrder::default();
        // Nothing is written, and read is what these numbers are made of.
        for access in &mut looks.accesses {
            (access.value, access.sure) = (None, true);
        }
        looks.forget_unread();
        looks.lines.borrow_mut().clear();
        looks.shapes.borrow_mut().clear();
        Some((looks, cell))
    }
}

impl Writing<'_, '_, '_> {
    /// Whether numbers on no line are below their limits in so many turns, if a condition holds; whether both is so.
    pub(super) fn look_at_numbers(&mut self, turns: Value, guard: Value) -> Value {
        if self.kernel.looked_at.is_empty() {
            return guard;
        }
        let Some((kernel, cell)) = self.kernel.looks() else { unreachable!("cells have numbers of 16 bits") };
        let plan = Plan { kernel, count: self.plan.count, inner: InnerTurns::Constant(0) };
        let lanes = if self.lanes == TURNS && plan.side_by_side() { TURNS } else { 1 };
        let [look, behind] = [self.t.b.create_block(), self.t.b.create_block()];
        let all_below = self.t.b.append_block_param(behind, I8);
        let no = self.t.b.ins().iconst(I8, 0);
        self.t.b.ins().brif(guard, look, &[], behind, &[BlockArg::Value(no)]);
        self.t.b.switch_to_block(look);
        self.t.b.seal_block(look);
        let mut looking = Writing::new(self.t, &plan, Writes::lanes(lanes));
        looking.before = self.before.clone();
        looking.before.insert(cell, looking.t.cell_before(&plan.kernel, cell));
        looking.turns(Level::Outer, turns);
        let ends = looking.ends(turns);
        let count = ends.into_iter().find(|&(own, _)| own == cell).map(|(_, count)| count).expect("the numbers are counted");
        let count = self.t.int(count);
        let none = self.t.b.ins().icmp_imm_u(IntCC::Equal, count, 0);
        self.t.b.ins().jump(behind, &[BlockArg::Value(none)]);
        self.t.b.switch_to_block(behind);
        self.t.b.seal_block(behind);
        all_below
    }
}
