//! Reads calls of one block with each of its instances, as turns of a loop.

use std::collections::BTreeMap;

use sieben_engine::ir::Op;
use sieben_engine::machine::Register;

use super::super::super::ranges::Interval;
use super::super::kernel::{Access, Kept, Kernel, Level, Turn, What};
use super::Reader;

impl Reader<'_, '_> {
    /// Reads turns that each call a block with the next one of instances which lie at equal distances. `None` if a call does more than
    /// read and write its instance, and registers, which it leaves as it does each time.
    pub(in crate::translate::turns) fn calls(mut self, called: usize, Instances { first, step, count }: Instances) -> Option<Called> {
        let kept = Kept::Register(Register::Ar2);
        let cell = self.cell(kept);
        let start = self.node(What::Start(Level::Outer, cell));
        let last = first + step * (count - 1);
        let range = Interval { least: first.into(), most: last.into(), zeros: (first | step).trailing_zeros(), ..Interval::any(32) };
        self.ranges.insert(start, range);
        let mut steps = Vec::new();
        self.call(called, 0, &mut steps).or_else(|| {
            self.leave_frames(0);
            None
        })?;
        self.write_held(&mut steps);
        let left = std::mem::take(&mut self.now);
        let mut after = Vec::new();
        for (&cell, &end) in &left {
            match self.kernel.kept(cell) {
                // The caller takes it back.
                Kept::Register(Register::Ar2) => {}
                Kept::Register(register) => after.push((register, self.kernel.constant(end)?)),
                _ => return None,
            }
        }
        let step = self.constant(step.into());
        let next = self.compute(Op::AddU32, [start, step, start, start]);
        let end = self.constant(u64::from(last) + 1);
        let again = self.compute(Op::Below, [next, end, next, next]);
        let (blocks, most) = (self.blocks, self.blocks_most);
        self.choose_pointers()?;
        let mut kernel = self.kernel;
        kernel.outer = Turn { steps, ends: BTreeMap::from([(cell, next)]), again, blocks, blocks_most: most, ..Turn::default() };
        kernel.size = self.translator.layout.size;
        kernel.shorten_choices();
        kernel.forget_unread();
        let is_own = |access: &Access| access.pointer == start && access.sure && access.inside.is_some();
        let is_simple = blocks == most
            && kernel.inner.is_none()
            && kernel.required.is_empty()
            && kernel.accesses.iter().all(is_own)
            && kernel.is_apart();
        is_simple.then_some(Called { kernel, after, weight: blocks.into() })
    }
}

/// Instances of a block that lie at equal distances: pointers to the first one, from each one to the next, and how many they are.
#[derive(Clone, Copy, Debug)]
pub(in crate::translate::turns) struct Instances {
    pub(in crate::translate::turns) first: u32,
    pub(in crate::translate::turns) step: u32,
    pub(in crate::translate::turns) count: u32,
}

/// What calls of a block do, one with each of its instances.
pub(in crate::translate::turns) struct Called {
    pub(in crate::translate::turns) kernel: Kernel,
    /// Registers behind each call.
    pub(in crate::translate::turns) after: Vec<(Register, u64)>,
    /// What a call takes from the budget.
    pub(in crate::translate::turns) weight: i64,
}
