//! Superword-level parallelism: calls of one block that follow one another in straight code, each with the next of its instances, as
//! vectorized iterations.

use std::ops::Range;

use cranelift_codegen::ir::InstBuilder;
use cranelift_codegen::ir::types::I64;
use sieben_engine::machine::Register;

use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::super::{OPEN_BLOCKS, Translator, bit_of};
use super::emission::Emitter;
use super::kernel::{Definition, Kernel, Level, SlotKind};
use super::ssa_construction::{Called, Instances, SsaBuilder};
use super::{InnerTripCount, LoopPlan, VersionPlan, trip_count};

/// Vectorized iterations.
pub(in crate::translate) const ITERATIONS: u32 = 4;

/// Some bytes.
pub(in crate::translate) type Bytes = (Base, Range<i64>);

/// What calls of a block with each of its instances do.
pub(in crate::translate) struct Calls {
    plan: LoopPlan,
    instances: Instances,
    /// Registers behind each call.
    pub(in crate::translate) after: Vec<(Register, u64)>,
    /// What a call takes from the budget.
    pub(in crate::translate) weight: i64,
    /// The bytes of the first instance that a call reads or writes.
    pub(in crate::translate) first: Bytes,
    /// What else it reads.
    pub(in crate::translate) reads: Vec<Bytes>,
}

impl Calls {
    /// The bytes of an instance.
    pub(in crate::translate) fn instance(&self, number: u32) -> Bytes {
        let (base, bytes) = &self.first;
        let moved = i64::from(self.instances.step / 8 * number);
        (*base, bytes.start + moved..bytes.end + moved)
    }
}

impl Translator<'_> {
    /// What calls of a block do, if it can be done side by side.
    pub(in crate::translate) fn read_calls(&mut self, called: usize, (first, step, count): (u32, u32, u32)) -> Option<Calls> {
        let instances = Instances { first, step, count };
        let pointer = self.current[Register::Ar2 as usize].take();
        // Code between the calls may change all registers but those of data blocks.
        let changed = OPEN_BLOCKS.iter().fold(!0, |all, &register| all & !bit_of(register));
        let read = SsaBuilder::new(self, changed, [Vec::new(), Vec::new()]).calls(called, instances);
        self.current[Register::Ar2 as usize] = pointer;
        let Called { kernel, after, weight } = read?;
        let reads = kernel.reads_of_others()?;
        let first = kernel.own_bytes(first)?;
        let count = trip_count::condition(&kernel, Level::Outer)?;
        if kernel.repeats_itself() {
            return None;
        }
        self.pinned.extend(&kernel.opened);
        let plan = LoopPlan { kernel, count, inner: InnerTripCount::Constant(0) };
        (plan.lanes() == [ITERATIONS]).then_some(Calls { plan, instances, after, weight, first, reads })
    }

    /// Writes so many of the calls, which nobody looks at.
    pub(in crate::translate) fn call_side_by_side(&mut self, calls: &Calls, count: u32) {
        self.settle_bytes();
        let pointer = self.current[Register::Ar2 as usize].replace(Val::Const(calls.instances.first.into()));
        Emitter::new(self, &calls.plan, VersionPlan::lanes(ITERATIONS)).straight(count);
        self.current[Register::Ar2 as usize] = pointer;
        self.forget_memory();
    }
}

impl Kernel {
    /// What iterations read beside their instances; `None` if that may be something that code around them changes.
    fn reads_of_others(&self) -> Option<Vec<Bytes>> {
        let mut reads = Vec::new();
        for what in &self.nodes {
            let Definition::Start(_, slot) = *what else { continue };
            match self.kept(slot) {
                SlotKind::Register(register) if register == Register::Ar2 || OPEN_BLOCKS.contains(&register) => {}
                SlotKind::Clock => {}
                SlotKind::Memory { base: Base::Arena, offset, width, .. } => {
                    reads.push((Base::Arena, i64::from(offset)..i64::from(offset) + i64::from(width.bytes())));
                }
                _ => return None,
            }
        }
        Some(reads)
    }

    /// The bytes of its instance that the first iteration reads or writes.
    fn own_bytes(&self, first: u32) -> Option<Bytes> {
        let bytes = self.accesses.iter().map(|access| {
            let (base, start, _) = access.area;
            // Positions have 24 bits.
            let position = (first & 0x00FF_FFFF) as i32 + ((access.offset << 8) as i32 >> 8);
            let at = i64::from(start) + i64::from(position >> 3);
            (base == Base::Arena && position >= 0).then_some(at..at + i64::from(access.width.bytes()))
        });
        let bytes = bytes.collect::<Option<Vec<Range<i64>>>>()?;
        let (start, end) = (bytes.iter().map(|bytes| bytes.start).min()?, bytes.iter().map(|bytes| bytes.end).max()?);
        Some((Base::Arena, start..end))
    }
}

impl Emitter<'_, '_, '_> {
    /// Writes so many iterations, which leave nothing but what they have written to memory.
    fn straight(&mut self, iterations: u32) {
        for slot in self.kernel.slots_at_start() {
            let value = self.t.slot_before(self.kernel, slot);
            self.before.insert(slot, value);
        }
        let iterations = self.t.b.ins().iconst(I64, i64::from(iterations));
        self.iterations(Level::Outer, iterations);
        self.t.settle_bytes();
    }
}
