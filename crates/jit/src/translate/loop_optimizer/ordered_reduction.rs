//! Ordered reductions in vectorized iterations: a few operations with the loop-carried value are done one lane after the other, as in a sum
//! of REALs, whose result depends on the order, or in a random number made of the last one. All other operations are vectorized.

use std::collections::BTreeSet;

use cranelift_codegen::ir::InstBuilder;
use cranelift_codegen::ir::types::F32X4;
use sieben_model::address::Width;

use super::super::value::Val;
use super::emission::Emitter;
use super::kernel::{Definition, Effect, Kernel, Level, Node, Slot, SlotKind};
use super::loop_carried::Form;
use super::scalar_evolution::{Recurrence, Shape};
use super::vectorization::{Lanes, little};
use crate::passes::Pass;

/// Operations of an iteration that are done in order.
const OPERATIONS_MAX: usize = 16;

/// Slots that iterations hand on in order.
const CELLS_MAX: usize = 64;

/// What is done in the order of the iterations.
#[derive(Clone, Debug, Default)]
pub(super) struct OrderedReduction {
    /// What each iteration needs from the one before.
    pub(super) slots: BTreeSet<Slot>,
    /// Values that are made of that in order: all that the slots become rests on them.
    pub(super) nodes: BTreeSet<Node>,
}

impl Kernel {
    /// The same loop with all in order that an iteration needs from the one before, if that is little.
    pub(super) fn with_order(&self) -> Option<Self> {
        if !self.passes.has(Pass::OrderedReduction) {
            return None;
        }
        let chains = self.carried(Level::Outer).into_iter().filter(|(.., carried)| *carried == Recurrence::Chain);
        let slots: BTreeSet<Slot> = chains.map(|(slot, ..)| slot).collect();
        if slots.is_empty()
            || slots.len() > CELLS_MAX
            || slots.iter().any(|&slot| matches!(self.kept(slot), SlotKind::Budget | SlotKind::Clock))
        {
            return None;
        }
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let mut reached = BTreeSet::new();
        self.all_ends().chain(of_accesses).chain([self.outer.again]).for_each(|node| self.rests(node, &mut reached));
        let masks = self.rest_on_slots(&slots);
        let resting: BTreeSet<Node> = reached.into_iter().filter(|node| masks[node.number() as usize] != 0).collect();
        let by_iteration = self.accesses.iter().map(|access| access.pointer).chain([self.outer.again]);
        if by_iteration.chain(self.all_of_inner()).any(|node| resting.contains(&node)) {
            return None;
        }
        let handed_on = self.handed_on(&slots, &masks, &resting);
        // What a sum is so far has no form: vectorized iterations add up what each of them adds.
        let is_sum = |carried: &Recurrence| matches!(carried, Recurrence::Sum { .. } | Recurrence::MinMax { .. });
        let sums = self.carried(Level::Outer).into_iter().filter(|(.., carried)| is_sum(carried)).map(|(slot, ..)| slot);
        let sums: BTreeSet<Slot> = sums.take(CELLS_MAX).collect();
        let of_sums = self.rest_on_slots(&sums);
        let others: Vec<Node> = resting.iter().copied().filter(|node| of_sums[node.number() as usize] == 0).collect();
        [handed_on, resting].into_iter().find_map(|nodes| self.with_these_in_order(&slots, nodes, &others))
    }

    /// The same loop with these values in order, if all others have a form side by side.
    fn with_these_in_order(&self, slots: &BTreeSet<Slot>, nodes: BTreeSet<Node>, others: &[Node]) -> Option<Self> {
        let computed = nodes.iter().filter(|&&node| matches!(self.what(node), Definition::Compute(..))).count();
        if computed > OPERATIONS_MAX {
            return None;
        }
        let mut kernel = self.clone();
        kernel.in_order = OrderedReduction { slots: slots.clone(), nodes };
        kernel.shapes.borrow_mut().clear();
        let have_forms = others.iter().all(|&node| kernel.shape(node).is_some());
        (have_forms && kernel.has_all_for_order() && kernel.reads_in_time()).then_some(kernel)
    }

    /// On which of these slots, as bits, each value rests.
    fn rest_on_slots(&self, slots: &BTreeSet<Slot>) -> Vec<u64> {
        let mut masks = vec![0; self.nodes.len()];
        loop {
            let before = masks.clone();
            for at in 0..masks.len() {
                let of = |node: &Node| masks[node.number() as usize];
                let of_inner = |slot: Slot| {
                    let inner = self.inner.as_ref();
                    let ends = inner.and_then(|inner| inner.ends.get(&slot)).map_or(0, of);
                    ends | inner.and_then(|inner| inner.entry.get(&slot)).map_or(0, of)
                };
                masks[at] = match self.nodes[at] {
                    Definition::Constant(_) => 0,
                    Definition::Start(Level::Outer, slot) => slots.iter().position(|&known| known == slot).map_or(0, |at| 1 << at),
                    Definition::Start(Level::Inner, slot) | Definition::After(slot) => of_inner(slot),
                    Definition::Read(access) => of(&self.accesses[access].pointer),
                    Definition::Compute(op, args) => args[..op.arity()].iter().map(of).fold(0, |all, mask| all | mask),
                };
            }
            if masks == before {
                return masks;
            }
        }
    }

    /// What these slots hold when an iteration begins, and what lies on a way from there to what one of them holds when a later iteration
    /// begins, and back to the first. Nothing else that rests on them needs to be made in order.
    fn handed_on(&self, slots: &BTreeSet<Slot>, masks: &[u64], resting: &BTreeSet<Node>) -> BTreeSet<Node> {
        let ends: Vec<Option<Node>> = slots.iter().map(|slot| self.outer.ends.get(slot).copied()).collect();
        // On which slots each of them rests, in however many iterations.
        let mut rests: Vec<u64> = ends.iter().map(|end| end.map_or(0, |end| masks[end.number() as usize])).collect();
        for by in 0..rests.len() {
            for at in 0..rests.len() {
                if rests[at] >> by & 1 != 0 {
                    rests[at] |= rests[by];
                }
            }
        }
        let mut nodes: BTreeSet<Node> = resting.iter().copied().filter(|&node| matches!(self.what(node), Definition::Start(..))).collect();
        for (at, end) in ends.iter().enumerate() {
            let mut on_way = BTreeSet::new();
            end.iter().for_each(|&end| self.rests(end, &mut on_way));
            // What rests on a slot that rests on this one.
            let from = (0..rests.len()).filter(|&from| from == at || rests[from] >> at & 1 != 0).fold(0, |all, from| all | 1_u64 << from);
            nodes.extend(on_way.into_iter().filter(|node| masks[node.number() as usize] & from != 0));
        }
        nodes
    }

    /// Whether what is written in order rests on nothing that is read later in an iteration: the iteration before has not read it yet then.
    fn reads_in_time(&self) -> bool {
        let mut open: BTreeSet<Node> = BTreeSet::new();
        let accesses = self.outer.steps.iter().filter_map(|step| if let Effect::Access(number) = *step { Some(number) } else { None });
        open.extend(accesses.clone().filter(|&number| self.accesses[number].value.is_none()).map(|number| self.read_of(number)));
        for number in accesses {
            let is_early = |value: Node| self.rests_in_order(value).iter().any(|node| open.contains(node));
            match self.accesses[number].value {
                None => _ = open.remove(&self.read_of(number)),
                Some(value) if is_early(value) => return false,
                Some(_) => {}
            }
        }
        true
    }

    /// All values on which one rests in its iteration and, where it is made in order, in those before.
    fn rests_in_order(&self, node: Node) -> BTreeSet<Node> {
        let (mut all, mut slots) = (BTreeSet::new(), self.in_order.slots.clone());
        self.rests(node, &mut all);
        while let Some(&slot) = slots.iter().find(|&&slot| all.iter().any(|&node| self.is_start(node, Level::Outer, slot))) {
            slots.remove(&slot);
            if let Some(&end) = self.outer.ends.get(&slot) {
                self.rests(end, &mut all);
            }
        }
        all
    }

    /// What the iterations of the inner loop begin with, compute, and leave behind: they are done side by side as a whole.
    fn all_of_inner(&self) -> Vec<Node> {
        let Some(inner) = &self.inner else { return Vec::new() };
        let written = self.accesses.iter().filter(|access| access.level == Level::Inner).filter_map(|access| access.value);
        inner.entry.values().chain(inner.ends.values()).copied().chain([inner.again]).chain(written).collect()
    }

    /// Whether all else that is done in order takes has a form side by side.
    fn has_all_for_order(&self) -> bool {
        let OrderedReduction { slots, nodes } = &self.in_order;
        let of_nodes = nodes.iter().flat_map(|&node| match self.what(node) {
            Definition::Compute(op, args) => args[..op.arity()].to_vec(),
            _ => Vec::new(),
        });
        let ends = slots.iter().filter_map(|slot| self.outer.ends.get(slot)).copied();
        ends.chain(of_nodes).all(|node| self.shape(node).is_some())
    }

    /// The form of a value of which each iteration makes its own.
    pub(super) fn shape_by_width(&self, node: Node) -> Shape {
        match self.width_of(node) {
            Width::Bit => Shape::Mask,
            Width::Byte | Width::Word => Shape::Halves,
            Width::DoubleWord => Shape::Words,
            Width::QuadWord => Shape::Wide,
        }
    }

    /// The width of what a value is.
    fn width_of(&self, node: Node) -> Width {
        match () {
            () if self.is_bit(node) => Width::Bit,
            () if self.is_16_bits(node) => Width::Word,
            () if self.is_32_bits(node) => Width::DoubleWord,
            () => Width::QuadWord,
        }
    }
}

impl Emitter<'_, '_, '_> {
    /// How a slot is handed on from the last of the vectorized iterations to the first one of the next ones.
    pub(super) fn form_in_order(&self, slot: Slot) -> Form {
        match self.kernel.kept(slot) {
            SlotKind::Memory { width: Width::Bit, .. } => Form::Bit,
            kept if kept.is_wide() => Form::Quad,
            _ => Form::Int,
        }
    }

    /// What all iterations have made of a value, side by side again.
    pub(super) fn made_in_order(&mut self, node: Node) -> Lanes {
        let values: Vec<Val> = (0..self.lanes).map(|lane| self.in_lane(node, lane)).collect();
        self.t.side_by_side(self.kernel.shape_by_width(node), &values)
    }

    /// What one of the iterations makes of a value.
    pub(super) fn in_lane(&mut self, node: Node, lane: u32) -> Val {
        if let Some(&value) = self.in_lanes.get(&(node, lane)) {
            return value;
        }
        if !self.kernel.in_order.nodes.contains(&node) {
            let value = self.value(node, Level::Outer);
            return self.number_of_lane(&value, lane);
        }
        let value = match self.kernel.what(node) {
            Definition::Start(_, slot) => match lane.checked_sub(1) {
                Some(before) => {
                    let end = self.kernel.outer.ends[&slot];
                    self.in_lane(end, before)
                }
                None => match self.start(slot) {
                    Lanes::One(value) => value,
                    _ => unreachable!("it is handed on as one value"),
                },
            },
            Definition::Compute(op, args) => {
                let own: Vec<Val> = args[..op.arity()].iter().map(|&arg| self.in_lane(arg, lane)).collect();
                self.note_bounds(node, &own);
                self.t.compute_now(op, &own)
            }
            _ => unreachable!("what is in order was looked at"),
        };
        self.in_lanes.insert((node, lane), value);
        value
    }

    /// The value of one of the iterations; a number of 32 bits also as a REAL, which an operation with REALs takes.
    fn number_of_lane(&mut self, value: &Lanes, lane: u32) -> Val {
        let Lanes::Words(words) = value else { return self.t.of_lane(value, lane) };
        let Val::Int(bits) = self.t.of_lane(value, lane) else { unreachable!("a number of 32 bits") };
        let reals = self.t.b.ins().bitcast(F32X4, little(), words[(lane / 4) as usize]);
        let real = self.t.b.ins().extractlane(reals, (lane % 4) as u8);
        Val::Real { real, bits }
    }
}
