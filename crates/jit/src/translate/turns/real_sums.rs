//! What only some turns add to a REAL or LREAL, as something that each turn adds: no turn waits for a choice then, only for a sum.
//!
//! -0.0 is added where nothing was, which leaves every number as it is. What is no number would become the one NaN that the project shows:
//! the sum has to be a number when the loop begins, and it is looked at there. Later it is the result of a sum.

use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::kernel::{Cell, Kept, Kernel, Level, Node, What};
use super::write::Writing;

/// Sums of a turn that follow one another.
const SUMS_MAX: usize = 8;
/// Choices of a turn that are followed.
const CHOICES_MAX: usize = 16;

/// What is added or subtracted.
type Sum = (Op, Node);

/// Sums, one behind the other, with what a cell held when the turn began.
struct Sums {
    sums: Vec<Sum>,
    /// Whether there are choices.
    chosen: bool,
    /// Whether one of them adds nothing on one of its sides.
    may_add_nothing: bool,
}

/// The REAL or LREAL that leaves every other one as it is: -0.0 where it is added, 0.0 where it is subtracted.
fn nothing(op: Op) -> Option<u64> {
    match op {
        Op::AddF32 => Some(0x8000_0000),
        Op::AddF64 => Some(1 << 63),
        Op::SubF32 | Op::SubF64 => Some(0),
        _ => None,
    }
}

impl Kernel {
    /// Writes what cells with REALs and LREALs hold at the end of a turn as sums that each turn makes.
    pub(super) fn add_reals_in_each_turn(&mut self) {
        if self.inner.is_some() {
            return;
        }
        let ends: Vec<(Cell, Node)> = self.outer.ends.iter().map(|(&cell, &end)| (cell, end)).collect();
        for (cell, end) in ends {
            if !matches!(self.kept(cell), Kept::Memory { width: Width::DoubleWord | Width::QuadWord, .. }) {
                continue;
            }
            let before = self.nodes.len();
            let found = self.sums(end, cell, CHOICES_MAX);
            match found {
                Some(Sums { sums, chosen: true, may_add_nothing })
                    if !sums.iter().any(|&(_, of)| self.rests_on(of, Level::Outer, cell)) =>
                {
                    let start = self.add(What::Start(Level::Outer, cell));
                    let sum = sums.into_iter().fold(start, |sum, (op, of)| self.add(What::Compute(op, [sum, of, sum, sum])));
                    self.outer.ends.insert(cell, sum);
                    self.numbers_at_start.extend(may_add_nothing.then_some(cell));
                }
                _ => self.nodes.truncate(before),
            }
        }
    }

    /// The sums that make a value of what a cell held when the turn began.
    fn sums(&mut self, node: Node, cell: Cell, choices: usize) -> Option<Sums> {
        if self.is_start(node, Level::Outer, cell) {
            return Some(Sums { sums: Vec::new(), chosen: false, may_add_nothing: false });
        }
        let What::Compute(op, [a, b, c, _]) = self.what(node) else { return None };
        if nothing(op).is_some() {
            let commutes = matches!(op, Op::AddF32 | Op::AddF64);
            let (mut found, of) = match self.sums(a, cell, choices) {
                Some(found) => (found, b),
                None if commutes => (self.sums(b, cell, choices)?, a),
                None => return None,
            };
            found.sums.push((op, of));
            return (found.sums.len() <= SUMS_MAX).then_some(found);
        }
        if op != Op::Select {
            return None;
        }
        let choices = choices.checked_sub(1)?;
        let [yes, no] = [self.sums(b, cell, choices)?, self.sums(c, cell, choices)?];
        let same = yes.sums.iter().zip(&no.sums).take_while(|(yes, no)| yes == no).count();
        let mut sums = yes.sums[..same].to_vec();
        let mut may_add_nothing = yes.may_add_nothing || no.may_add_nothing;
        for at in same..yes.sums.len().max(no.sums.len()) {
            let sides = [yes.sums.get(at), no.sums.get(at)];
            may_add_nothing |= sides.contains(&None);
            let (op, _) = *sides.into_iter().flatten().next()?;
            if sides.into_iter().flatten().any(|&(other, _)| other != op) {
                return None;
            }
            let [yes, no] = sides.map(|side| side.map(|&(_, of)| of));
            let neutral = nothing(op)?;
            let [yes, no] = [yes, no].map(|of| match of {
                Some(of) => of,
                None => self.add(What::Constant(neutral)),
            });
            let chosen = self.add(What::Compute(Op::Select, [a, yes, no, a]));
            sums.push((op, chosen));
        }
        Some(Sums { sums, chosen: true, may_add_nothing })
    }
}

impl Writing<'_, '_, '_> {
    /// Whether cells hold numbers in front of the loop where that has to be so.
    pub(super) fn are_numbers(&mut self) -> Vec<Value> {
        let cells = self.kernel.numbers_at_start.clone();
        let is_number = |cell: Cell| {
            let value = self.before[&cell];
            let real = if self.kernel.kept(cell).is_wide() { self.t.f64(value) } else { self.t.f32(value) };
            self.t.b.ins().fcmp(FloatCC::Ordered, real, real)
        };
        cells.into_iter().map(is_number).collect()
    }
}
