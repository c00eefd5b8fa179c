//! Turns that are done one by one and part on a condition. Most conditions become choices, for which a turn computes both sides; where one of
//! the sides has much to do, or is seldom taken, a jump is faster, and each side is written for itself.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use cranelift_codegen::ir::{Block, InstBuilder, Value};
use sieben_engine::ir::Op;

use super::Plan;
use super::alike::DEPTH_MAX;
use super::handed::{Form, Handed};
use super::kernel::{Kernel, Level, Node, Step, What};
use super::left::Progress;
use super::line::{Carried, Line};
use super::vector::Lanes;
use super::write::Writing;

/// Larger turns are not looked at, and not written twice.
const NODES_MAX: usize = 400;
/// Instructions that one of the sides has to save where jumps are likely to be faster than choices.
const SAVED_MIN: u32 = 6;
/// Instructions that one of the sides has to save in other iterations; they are half of all.
const SAVED_MIN_OF_ANY: u32 = 10;

/// How turns part.
pub(super) struct Parted {
    condition: Node,
    /// What has to be read to look at the condition, in its order.
    first: Vec<usize>,
    /// The turns where it holds, and where it does not.
    sides: [Kernel; 2],
}

/// What turns hand on, and where it is among the parameters of their loop.
#[derive(Clone, Copy)]
pub(super) struct HandedOn<'a> {
    pub(super) handed: &'a [Handed],
    pub(super) now: &'a [Value],
    /// Parameters in front of it: the number of turns that are left, if no address tells that.
    pub(super) others: usize,
}

impl Plan {
    /// The condition on which turns part, if that is likely to be faster than choices.
    pub(super) fn parted(&self) -> Option<Parted> {
        let kernel = &self.kernel;
        if !kernel.only_accesses(NODES_MAX) {
            return None;
        }
        let cost = kernel.cost_alone();
        let saved_min = if kernel.is_for_jumps() { SAVED_MIN } else { SAVED_MIN_OF_ANY.max(cost.div_ceil(2)) };
        let found = kernel.chosen_by().into_iter().filter_map(|condition| {
            let first = kernel.first_for(condition)?;
            let sides = [true, false].map(|holds| kernel.side_alone(condition, holds));
            let saved = sides.each_ref().map(|side| cost.saturating_sub(side.cost_alone()));
            let most = saved.into_iter().max().filter(|&saved| saved >= saved_min)?;
            Some(((most, saved.iter().sum::<u32>(), Reverse(condition)), Parted { condition, first, sides }))
        });
        found.max_by_key(|&(key, _)| key).map(|(_, parted)| parted)
    }
}

impl Kernel {
    /// The conditions of choices, as far as they are not the same in all turns.
    fn chosen_by(&self) -> BTreeSet<Node> {
        let mut all = BTreeSet::new();
        for node in self.reached() {
            let Some(mut condition) = self.asked_by(node) else { continue };
            while let What::Compute(Op::Not, [of, ..]) = self.what(condition) {
                condition = of;
            }
            let is_same = self.line(condition, Level::Outer).is_some_and(Line::is_same);
            if self.is_bit(condition) && self.constant(condition).is_none() && !is_same {
                all.insert(condition);
            }
        }
        all
    }

    /// The turns where a condition holds, or does not.
    fn side_alone(&self, condition: Node, holds: bool) -> Self {
        let mut side = self.clone();
        side.assume(condition, holds, DEPTH_MAX);
        side.simplify();
        side
    }

    /// About how many instructions a turn takes.
    fn cost_alone(&self) -> u32 {
        let needed = self.reached();
        let of_nodes = needed.iter().map(|&node| match self.what(node) {
            What::Compute(..) if self.line(node, Level::Outer).is_some() => 0,
            What::Compute(Op::Copy, _) => 0,
            What::Compute(Op::Select, _) => 2,
            What::Compute(..) => 1,
            _ => 0,
        });
        let is_made = |step: &&Step| match **step {
            Step::Access(number) => self.accesses[number].value.is_some() || needed.contains(&self.read_of(number)),
            _ => true,
        };
        of_nodes.sum::<u32>() + 2 * self.outer.steps.iter().filter(is_made).count() as u32
    }
}

impl<'k> Writing<'_, '_, 'k> {
    /// Does a turn that parts. What is handed on to the next one.
    pub(super) fn turn_parted(&mut self, parted: &'k Parted, on: HandedOn<'_>, progress: Progress) -> Vec<Value> {
        parted.first.iter().for_each(|&number| self.access(number, Level::Outer));
        let condition = self.first(parted.condition, Level::Outer);
        let condition = self.t.flag(condition);
        let moment = self.moment();
        let whole = &self.plan.kernel;
        let left = self.left_by_turns();
        let [yes, no, meeting] = [(); 3].map(|()| self.t.b.create_block());
        self.t.b.ins().brif(condition, yes, &[], no, &[]);
        let counted: BTreeSet<Node> =
            on.handed.iter().filter_map(|one| if let Handed::Counted(node, _) = one { Some(*node) } else { None }).collect();
        for (side, block) in parted.sides.iter().zip([yes, no]) {
            self.t.b.switch_to_block(block);
            self.t.b.seal_block(block);
            self.turn_as(side);
            // What conditions were made of is known here.
            let is_read = |kernel: &Kernel, node: Node| matches!(kernel.what(node), What::Read(_));
            self.outer.values.retain(|&node, _| counted.contains(&node) || is_read(whole, node) && is_read(side, node));
            self.outer.bytes.clear();
            self.outer.near_bits.clear();
            self.steps_of_turn(Level::Outer, progress);
            self.meet_parted(meeting, on, &left);
            self.take_up(moment.clone());
            self.waiting.iter_mut().for_each(|one| one.written = false);
        }
        self.turn_as(whole);
        self.t.b.switch_to_block(meeting);
        self.t.b.seal_block(meeting);
        let mut next = self.t.b.block_params(meeting).to_vec();
        let of_left = next.split_off(next.len() - left.len());
        let own = self.owned(on.handed, &next[on.others..]);
        for (one, value) in on.handed.iter().zip(own).chain(left.iter().zip(of_left.into_iter().map(|value| vec![value]))) {
            if let Handed::Chain(cell, end, form) = *one {
                // What a turn computes is the one NaN that the project shows, if it is none.
                let value = if form == Form::Real { Lanes::One(self.t.quiet(value[0])) } else { self.taken(cell, form, value) };
                self.outer.values.insert(end, value);
            }
        }
        next
    }

    /// Writes turns as another version of them says.
    fn turn_as(&mut self, kernel: &'k Kernel) {
        self.kernel = kernel;
        self.records = kernel.records(self.lanes);
        self.near_bits = kernel.near_bits();
        self.chased = kernel.chased();
    }

    /// What the last turn leaves in cells that are not handed on.
    fn left_by_turns(&self) -> Vec<Handed> {
        let kernel = self.kernel;
        let needed = kernel.needed(Level::Outer, &|cell| kernel.cell_line(Level::Outer, cell).is_none());
        let carried = kernel.carried(Level::Outer).into_iter();
        let left = carried
            .filter(|&(cell, end, carried)| carried == Carried::Nothing && !self.is_left(cell) && kernel.line(end, Level::Outer).is_none());
        left.map(|(cell, end, _)| Handed::Chain(cell, end, self.form(Level::Outer, cell, end, &needed))).collect()
    }

    /// Goes where the sides meet, with what turns hand on and leave.
    fn meet_parted(&mut self, meeting: Block, on: HandedOn<'_>, left: &[Handed]) {
        let mut all: Vec<Value> = on.now[..on.others].iter().map(|&turns| self.t.b.ins().iadd_imm_s(turns, -1)).collect();
        let own = self.owned(on.handed, &on.now[on.others..]);
        for (one, own) in on.handed.iter().zip(own) {
            self.next_of(Level::Outer, one, &own, on.now[0], &mut all);
        }
        for one in left {
            if let Handed::Chain(_, end, form) = *one {
                let value = self.value(end, Level::Outer);
                self.in_form(&value, form, &mut all);
            }
        }
        self.go_where_ways_meet(meeting, &all);
    }
}
