//! SSA construction of calls of one block with each of its instances, as iterations of a loop.

use std::collections::BTreeMap;

use sieben_engine::ir::Op;
use sieben_engine::machine::Register;

use super::super::super::range_analysis::Interval;
use super::super::kernel::{Access, Definition, Iteration, Kernel, Level, SlotKind};
use super::SsaBuilder;

impl SsaBuilder<'_, '_> {
    /// Reads iterations that each call a block with the next one of instances which lie at equal distances. `None` if a call does more than
    /// read and write its instance, and registers, which it leaves as it does each time.
    pub(in crate::translate::loop_optimizer) fn calls(
        mut self,
        called: usize,
        Instances { first, step, count }: Instances,
    ) -> Option<Called> {
        let kept = SlotKind::Register(Register::Ar2);
        let slot = self.slot(kept);
        let start = self.node(Definition::Start(Level::Outer, slot));
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
        for (&slot, &end) in &left {
            match self.kernel.kept(slot) {
                // The caller takes it back.
                SlotKind::Register(Register::Ar2) => {}
                SlotKind::Register(register) => after.push((register, self.kernel.constant(end)?)),
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
        kernel.outer = Iteration { steps, ends: BTreeMap::from([(slot, next)]), again, blocks, blocks_most: most, ..Iteration::default() };
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
pub(in crate::translate::loop_optimizer) struct Instances {
    pub(in crate::translate::loop_optimizer) first: u32,
    pub(in crate::translate::loop_optimizer) step: u32,
    pub(in crate::translate::loop_optimizer) count: u32,
}

/// What calls of a block do, one with each of its instances.
pub(in crate::translate::loop_optimizer) struct Called {
    pub(in crate::translate::loop_optimizer) kernel: Kernel,
    /// Registers behind each call.
    pub(in crate::translate::loop_optimizer) after: Vec<(Register, u64)>,
    /// What a call takes from the budget.
    pub(in crate::translate::loop_optimizer) weight: i64,
}
