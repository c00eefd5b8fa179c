//! What turns write behind a condition and no later turn reads: the local data of blocks that became part of the loop, mostly.
//!
//! Such a variable holds behind the loop what the last of these turns wrote, or what it held in front of it. Carrying it would cost a
//! choice and a register in each turn. Instead, each turn puts such values on the stack, and one that writes these variables has the next
//! turn put its own somewhere else. What is on a line is computed behind the loop from the turn that was the last one.

use std::collections::BTreeSet;

use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, StackSlotData, StackSlotKind, Value};
use cranelift_frontend::Variable;
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::value::Val;
use super::super::{TRUSTED, Translator};
use super::kernel::{Cell, Kept, Kernel, Level, Node, What};
use super::line::Carried;

/// Cells that are left under the same conditions, for which this is cheaper than to carry them.
const CELLS_MIN: usize = 3;
/// Operations in one another of values that are computed behind the loop.
const COMPUTED_MAX: usize = 4;
/// Conditions in one another.
const CONDITIONS_MAX: usize = 4;

/// Cells that the same turns write.
pub(super) struct Left {
    /// Under which conditions, all of which hold or do not.
    pub(super) conditions: Vec<(Node, bool)>,
    /// What these turns leave in them.
    pub(super) cells: Vec<(Cell, Node)>,
    /// Values that wait on the stack.
    pub(super) waiting: Vec<Node>,
    /// Those of them that have 64 bits.
    wide: Vec<bool>,
}

impl Kernel {
    /// The cells of a loop without another one in it that no turn reads before it has written them, by the turns that write them.
    pub(super) fn left(&self) -> Vec<Left> {
        let mut all: Vec<Left> = Vec::new();
        if self.inner.is_some() {
            return all;
        }
        for (cell, end, carried) in self.carried(Level::Outer) {
            // Other registers have forms of their own.
            let is_number =
                matches!(self.kept(cell), Kept::Memory { width: Width::Byte | Width::Word | Width::DoubleWord | Width::QuadWord, .. });
            if carried != Carried::Chain || !is_number {
                continue;
            }
            let Some((conditions, value)) = self.written_where(cell, end) else { continue };
            match all.iter_mut().find(|left| left.conditions == conditions) {
                Some(left) => left.cells.push((cell, value)),
                None => all.push(Left { conditions, cells: vec![(cell, value)], waiting: Vec::new(), wide: Vec::new() }),
            }
        }
        all.retain(|left| left.cells.len() >= CELLS_MIN);
        for left in &mut all {
            let waiting: BTreeSet<Node> = left.cells.iter().map(|&(_, value)| value).collect();
            left.waiting = waiting.into_iter().filter(|&value| self.line(value, Level::Outer).is_none()).collect();
            // What can be computed from the others behind the loop needs not wait, the last value first: it may rest on the others.
            for at in (0..left.waiting.len()).rev() {
                let value = left.waiting.remove(at);
                if !self.follows_from(&left.waiting, value, COMPUTED_MAX) {
                    left.waiting.insert(at, value);
                }
            }
            left.wide = left.waiting.iter().map(|&value| !self.is_32_bits(value)).collect();
        }
        all
    }

    /// Whether a value is computed from others, from constants and from what is on a line, in so many operations in one another.
    fn follows_from(&self, others: &[Node], value: Node, depth: usize) -> bool {
        if others.contains(&value) || self.line(value, Level::Outer).is_some() {
            return true;
        }
        match self.what(value) {
            What::Compute(op, args) => depth > 0 && args[..op.arity()].iter().all(|&arg| self.follows_from(others, arg, depth - 1)),
            _ => false,
        }
    }

    /// The conditions under which a turn writes a cell, and what, if nothing else looks at what the cell held.
    pub(super) fn written_where(&self, cell: Cell, end: Node) -> Option<(Vec<(Node, bool)>, Node)> {
        let mut conditions = Vec::new();
        let mut value = end;
        while let What::Compute(Op::Select, [condition, a, b, _]) = self.what(value) {
            let holds = match (self.is_start(a, Level::Outer, cell), self.is_start(b, Level::Outer, cell)) {
                (false, true) => true,
                (true, false) => false,
                _ => break,
            };
            conditions.push((condition, holds));
            value = if holds { a } else { b };
        }
        if conditions.is_empty() || conditions.len() > CONDITIONS_MAX {
            return None;
        }
        let others = self.outer.ends.iter().filter(|&(&other, _)| other != cell).map(|(_, &end)| end);
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let own = conditions.iter().map(|&(condition, _)| condition).chain([value, self.outer.again]);
        let required = self.required.iter().map(|&(number, _)| number);
        let mut all = others.chain(of_accesses).chain(self.of_copies()).chain(own).chain(required);
        (!all.any(|node| self.rests_on(node, Level::Outer, cell))).then_some((conditions, value))
    }
}

/// How far a loop is.
#[derive(Clone, Copy)]
pub(super) enum Progress {
    /// So many turns are left with the running one.
    Left(Value),
    /// An address that is so many bytes further in each turn, and as it was in the first one.
    Address { now: Value, first: Value, step: i64 },
}

impl Progress {
    /// What tells the running turn from others, and is not 0.
    pub(super) fn mark(self) -> Value {
        match self {
            Self::Left(left) => left,
            Self::Address { now, .. } => now,
        }
    }
}

/// Where the values of such cells wait while turns are made: in two places on the stack. Each turn writes to one of them, and one that
/// writes the cells has the next turn write to the other one.
pub(super) struct Waiting {
    pub(super) left: Left,
    /// The place for the running turn.
    place: Variable,
    /// Bytes of a place, and so far from one to the other: a power of two.
    bytes: u32,
    /// Whether the running turn has been written.
    pub(super) written: bool,
}

impl Waiting {
    /// Where a value waits.
    fn offset(at: usize) -> i32 {
        8 + 8 * at as i32
    }
}

impl Translator<'_> {
    /// Makes room for the values of cells: no turn has written any.
    pub(super) fn begin_left(&mut self, left: Left) -> Waiting {
        let bytes = (Waiting::offset(left.waiting.len()) as u32).next_power_of_two();
        // The first place begins at twice its size, so that one bit of the address tells them apart.
        let slot = self.b.create_sized_stack_slot(StackSlotData::new(StackSlotKind::ExplicitSlot, 4 * bytes, 3));
        let start = self.b.ins().stack_addr(I64, slot, 2 * bytes as i32 - 1);
        let start = self.b.ins().band_imm_s(start, -2 * i64::from(bytes));
        let none = self.b.ins().iconst(I64, 0);
        for place in [0, bytes as i32] {
            // All of it is there, though nobody needs what no turn wrote.
            for at in (0..bytes as i32).step_by(8) {
                self.b.ins().store(TRUSTED, none, start, place + at);
            }
        }
        let place = self.b.declare_var(I64);
        self.b.def_var(place, start);
        Waiting { left, place, bytes, written: false }
    }

    /// Puts down what a turn leaves, and its mark.
    pub(super) fn put_left(&mut self, waiting: &Waiting, conditions: &[Val], values: &[Val], mark: Value) {
        let place = self.b.use_var(waiting.place);
        self.b.ins().store(TRUSTED, mark, place, 0);
        for (at, &value) in values.iter().enumerate() {
            let value = if waiting.left.wide[at] { self.word(value) } else { self.int(value) };
            self.b.ins().store(TRUSTED, value, place, Waiting::offset(at));
        }
        let mut all = None;
        for (&(_, holds), &condition) in waiting.left.conditions.iter().zip(conditions) {
            let condition = self.flag(condition);
            let condition = if holds { condition } else { self.b.ins().bxor_imm_u(condition, 1) };
            all = Some(all.map_or(condition, |all| self.b.ins().band(all, condition)));
        }
        let Some(all) = all else { unreachable!("cells are left under conditions") };
        let far = self.b.ins().ishl_imm_u(all, i64::from(waiting.bytes.trailing_zeros()));
        let far = self.b.ins().uextend(I64, far);
        let next = self.b.ins().bxor(place, far);
        self.b.def_var(waiting.place, next);
    }

    /// The mark of the last turn that wrote the cells; 0 if none did.
    pub(super) fn mark_left(&mut self, waiting: &Waiting) -> Value {
        let place = self.place_left(waiting);
        self.b.ins().load(I64, TRUSTED, place, 0)
    }

    /// What a value was in that turn, if it waits.
    pub(super) fn take_left(&mut self, waiting: &Waiting, value: Node) -> Option<Val> {
        let at = waiting.left.waiting.binary_search(&value).ok()?;
        let place = self.place_left(waiting);
        Some(match waiting.left.wide[at] {
            true => Val::Word(self.b.ins().load(I64, TRUSTED, place, Waiting::offset(at))),
            false => Val::Int(self.b.ins().load(I32, TRUSTED, place, Waiting::offset(at))),
        })
    }

    /// The place that the last turn wrote that wrote the cells.
    fn place_left(&mut self, waiting: &Waiting) -> Value {
        let next = self.b.use_var(waiting.place);
        self.b.ins().bxor_imm_u(next, i64::from(waiting.bytes))
    }

    /// How many turns were made before the one with a mark, of so many.
    pub(super) fn turns_before(&mut self, progress: Progress, mark: Value, turns: Value) -> Value {
        match progress {
            Progress::Left(_) => self.b.ins().isub(turns, mark),
            Progress::Address { first, step, .. } => {
                let way = self.b.ins().isub(mark, first);
                let step = self.b.ins().iconst(I64, step);
                self.b.ins().sdiv(way, step)
            }
        }
    }
}
