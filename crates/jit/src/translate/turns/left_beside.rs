//! What turns side by side write behind a condition and no later turn reads. Each lane carries what the last of its turns left, and which
//! turn that was; behind the loop the last one of all lanes is looked for.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I32X4};
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_model::address::Width;

use super::super::Translator;
use super::kernel::{Cell, Kept, Kernel, Level, Node};
use super::line::{Carried, Shape};
use super::vector::Lanes;

/// A cell that some turns write.
#[derive(Clone, Debug)]
pub(super) struct LeftBeside {
    pub(super) cell: Cell,
    /// Under which conditions, all of which hold or do not.
    pub(super) conditions: Vec<(Node, bool)>,
    pub(super) value: Node,
    /// The form in which lanes carry it.
    pub(super) shape: Shape,
}

/// Which turn left something: less than 0, and more for later ones.
const NO_TURN: i32 = i32::MIN;

impl Kernel {
    /// How lanes carry a cell that no turn reads before it has written it.
    pub(super) fn left_beside(&self, cell: Cell, end: Node) -> Option<LeftBeside> {
        let Kept::Memory { width, .. } = self.kept(cell) else { return None };
        if self.inner.is_some() {
            return None;
        }
        let (conditions, value) = self.written_where(cell, end)?;
        let shape = match width {
            Width::Bit => Shape::Mask,
            Width::Byte | Width::DoubleWord => Shape::Words,
            Width::Word => Shape::Halves,
            Width::QuadWord => Shape::Quads,
        };
        Some(LeftBeside { cell, conditions, value, shape })
    }

    /// All cells that lanes carry so, with those that the same turns write behind one another.
    pub(super) fn all_left_beside(&self) -> Vec<LeftBeside> {
        let carried = self.carried(Level::Outer).into_iter().filter(|(.., carried)| *carried == Carried::Chain);
        let mut all: Vec<LeftBeside> = carried.filter_map(|(cell, end, _)| self.left_beside(cell, end)).collect();
        all.sort_by(|a, b| a.conditions.cmp(&b.conditions));
        all
    }
}

impl Translator<'_> {
    /// The mark of lanes of which no turn left anything.
    pub(super) fn no_turns(&mut self, lanes: u32) -> Vec<Value> {
        let none = self.constant_vector(I32X4, NO_TURN.to_le_bytes().repeat(4));
        vec![none; (lanes / 4) as usize]
    }

    /// The marks of the running turns, of which so many are left with the first one of them.
    pub(super) fn marks(&mut self, left: Value, lanes: u32) -> Vec<Value> {
        let left = self.b.ins().ireduce(I32, left);
        let first = self.b.ins().ineg(left);
        let first = self.b.ins().splat(I32X4, first);
        let one = |number: u32| {
            let lanes: Vec<u8> = (4 * number..4 * number + 4).flat_map(u32::to_le_bytes).collect();
            let lanes = self.constant_vector(I32X4, lanes);
            self.b.ins().iadd(first, lanes)
        };
        (0..lanes / 4).map(one).collect()
    }

    /// The lanes in which all of these conditions hold or do not.
    pub(super) fn where_all(&mut self, conditions: &[(Lanes, bool)], lanes: u32) -> Vec<Value> {
        let mut all: Option<Vec<Value>> = None;
        for (condition, holds) in conditions {
            let masks = self.masks(condition, lanes);
            all = Some(match (all, holds) {
                (None, true) => masks,
                (None, false) => masks.into_iter().map(|mask| self.b.ins().bnot(mask)).collect(),
                (Some(all), true) => all.into_iter().zip(masks).map(|(all, mask)| self.b.ins().band(all, mask)).collect(),
                (Some(all), false) => all.into_iter().zip(masks).map(|(all, mask)| self.b.ins().band_not(all, mask)).collect(),
            });
        }
        all.unwrap_or_else(|| unreachable!("cells are left under conditions"))
    }

    /// What lanes hold where a turn has written something else.
    pub(super) fn chosen_in_lanes(&mut self, masks: &[Value], new: &[Value], old: &[Value], shape: Shape) -> Vec<Value> {
        let masks = match shape {
            Shape::Halves => masks.chunks(2).map(|pair| self.b.ins().snarrow(pair[0], pair[pair.len() - 1])).collect(),
            Shape::Quads => masks.iter().flat_map(|&mask| [self.b.ins().swiden_low(mask), self.b.ins().swiden_high(mask)]).collect(),
            _ => masks.to_vec(),
        };
        new.iter().zip(old).zip(masks).map(|((&new, &old), mask)| self.choice(mask, new, old)).collect()
    }

    /// What the last turn of all lanes left that left something, or else what was there before. All are integers of the same type.
    pub(super) fn last_of_lanes(&mut self, marks: &[Value], left: &[Value], before: Value) -> Value {
        let mut last = self.b.ins().iconst(I32, i64::from(NO_TURN));
        let mut value = before;
        for (number, &vector) in left.iter().enumerate() {
            for lane in 0..self.b.func.dfg.value_type(vector).lane_count() {
                let turn = number as u32 * self.b.func.dfg.value_type(vector).lane_count() + lane;
                let Some(&marks) = marks.get((turn / 4) as usize) else { continue };
                let mark = self.b.ins().extractlane(marks, turn as u8 % 4);
                let own = self.b.ins().extractlane(vector, lane as u8);
                let is_later = self.b.ins().icmp(IntCC::SignedGreaterThan, mark, last);
                last = self.b.ins().select(is_later, mark, last);
                value = self.b.ins().select(is_later, own, value);
            }
        }
        value
    }
}
