//! What turns side by side still do one after the other: a few operations with what the turn before has left, as in a sum of REALs, whose
//! result depends on the order, or in a random number made of the last one. All else that the turns do is done at once.

use std::collections::BTreeSet;

use cranelift_codegen::ir::InstBuilder;
use cranelift_codegen::ir::types::F32X4;
use sieben_model::address::Width;

use super::super::value::Val;
use super::handed::Form;
use super::kernel::{Cell, Kept, Kernel, Level, Node, Step, What};
use super::line::{Carried, Shape};
use super::vector::{Lanes, little};
use super::write::Writing;

/// Operations of a turn that are done in order.
const OPERATIONS_MAX: usize = 16;

/// What is done in the order of the turns.
#[derive(Clone, Debug, Default)]
pub(super) struct InOrder {
    /// What each turn needs from the one before.
    pub(super) cells: BTreeSet<Cell>,
    /// All values that rest on that.
    pub(super) nodes: BTreeSet<Node>,
}

impl Kernel {
    /// The same loop with all in order that a turn needs from the one before, if that is little.
    pub(super) fn with_order(&self) -> Option<Self> {
        let chains = self.carried(Level::Outer).into_iter().filter(|(.., carried)| *carried == Carried::Chain);
        let cells: BTreeSet<Cell> = chains.filter(|&(cell, end, _)| self.left_beside(cell, end).is_none()).map(|(cell, ..)| cell).collect();
        if cells.is_empty() || cells.iter().any(|&cell| matches!(self.kept(cell), Kept::Budget | Kept::Clock)) {
            return None;
        }
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let mut reached = BTreeSet::new();
        self.all_ends().chain(of_accesses).chain([self.outer.again]).for_each(|node| self.rests(node, &mut reached));
        let rests = |&node: &Node| cells.iter().any(|&cell| self.rests_on(node, Level::Outer, cell));
        let nodes: BTreeSet<Node> = reached.into_iter().filter(rests).collect();
        let computed = nodes.iter().filter(|&&node| matches!(self.what(node), What::Compute(..))).count();
        let by_turn = self.accesses.iter().map(|access| access.pointer).chain([self.outer.again]);
        if computed > OPERATIONS_MAX || by_turn.chain(self.all_of_inner()).any(|node| nodes.contains(&node)) {
            return None;
        }
        let mut kernel = self.clone();
        kernel.in_order = InOrder { cells, nodes };
        kernel.shapes.borrow_mut().clear();
        (kernel.has_all_for_order() && kernel.reads_in_time()).then_some(kernel)
    }

    /// Whether what is written in order rests on nothing that is read later in a turn: the turn before has not read it yet then.
    fn reads_in_time(&self) -> bool {
        let mut open: BTreeSet<Node> = BTreeSet::new();
        let accesses = self.outer.steps.iter().filter_map(|step| if let Step::Access(number) = *step { Some(number) } else { None });
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

    /// All values on which one rests in its turn and, where it is made in order, in those before.
    fn rests_in_order(&self, node: Node) -> BTreeSet<Node> {
        let (mut all, mut cells) = (BTreeSet::new(), self.in_order.cells.clone());
        self.rests(node, &mut all);
        while let Some(&cell) = cells.iter().find(|&&cell| all.iter().any(|&node| self.is_start(node, Level::Outer, cell))) {
            cells.remove(&cell);
            if let Some(&end) = self.outer.ends.get(&cell) {
                self.rests(end, &mut all);
            }
        }
        all
    }

    /// What the turns of the inner loop begin with, compute, and leave behind: they are done side by side as a whole.
    fn all_of_inner(&self) -> Vec<Node> {
        let Some(inner) = &self.inner else { return Vec::new() };
        let written = self.accesses.iter().filter(|access| access.level == Level::Inner).filter_map(|access| access.value);
        inner.entry.values().chain(inner.ends.values()).copied().chain([inner.again]).chain(written).collect()
    }

    /// Whether all else that is done in order takes has a form side by side.
    fn has_all_for_order(&self) -> bool {
        let InOrder { cells, nodes } = &self.in_order;
        let of_nodes = nodes.iter().flat_map(|&node| match self.what(node) {
            What::Compute(op, args) => args[..op.arity()].to_vec(),
            _ => Vec::new(),
        });
        let ends = cells.iter().filter_map(|cell| self.outer.ends.get(cell)).copied();
        ends.chain(of_nodes).all(|node| self.shape(node).is_some())
    }

    /// The form of a value of which each turn makes its own.
    pub(super) fn shape_by_width(&self, node: Node) -> Shape {
        match self.width_of(node) {
            Width::Bit => Shape::Mask,
            Width::Byte | Width::Word => Shape::Halves,
            Width::DoubleWord => Shape::Words,
            Width::QuadWord => Shape::Quads,
        }
    }
}

impl Writing<'_, '_, '_> {
    /// How a cell is handed on from the last of the turns side by side to the first one of the next ones.
    pub(super) fn form_in_order(&self, cell: Cell) -> Form {
        match self.kernel.kept(cell) {
            Kept::Memory { width: Width::Bit, .. } => Form::Bit,
            kept if kept.is_wide() => Form::Quad,
            _ => Form::Int,
        }
    }

    /// What all turns have made of a value, side by side again.
    pub(super) fn made_in_order(&mut self, node: Node) -> Lanes {
        let values: Vec<Val> = (0..self.lanes).map(|lane| self.in_lane(node, lane)).collect();
        self.t.side_by_side(self.kernel.shape_by_width(node), &values)
    }

    /// What one of the turns makes of a value.
    pub(super) fn in_lane(&mut self, node: Node, lane: u32) -> Val {
        if let Some(&value) = self.in_lanes.get(&(node, lane)) {
            return value;
        }
        if !self.kernel.in_order.nodes.contains(&node) {
            let value = self.value(node, Level::Outer);
            return self.number_of_lane(&value, lane);
        }
        let value = match self.kernel.what(node) {
            What::Start(_, cell) => match lane.checked_sub(1) {
                Some(before) => {
                    let end = self.kernel.outer.ends[&cell];
                    self.in_lane(end, before)
                }
                None => match self.start(cell) {
                    Lanes::One(value) => value,
                    _ => unreachable!("it is handed on as one value"),
                },
            },
            What::Compute(op, args) => {
                let own: Vec<Val> = args[..op.arity()].iter().map(|&arg| self.in_lane(arg, lane)).collect();
                self.note_bounds(node, &own);
                self.t.compute_now(op, &own)
            }
            _ => unreachable!("what is in order was looked at"),
        };
        self.in_lanes.insert((node, lane), value);
        value
    }

    /// The value of one of the turns; a number of 32 bits also as a REAL, which an operation with REALs takes.
    fn number_of_lane(&mut self, value: &Lanes, lane: u32) -> Val {
        let Lanes::Words(words) = value else { return self.t.of_lane(value, lane) };
        let Val::Int(bits) = self.t.of_lane(value, lane) else { unreachable!("a number of 32 bits") };
        let reals = self.t.b.ins().bitcast(F32X4, little(), words[(lane / 4) as usize]);
        let real = self.t.b.ins().extractlane(reals, (lane % 4) as u8);
        Val::Real { real, bits }
    }
}
