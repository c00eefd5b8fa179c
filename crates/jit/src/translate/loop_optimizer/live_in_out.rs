//! Live-in and live-out values of the fast version of a loop, and how the code goes on there.

use cranelift_codegen::ir::{self as clif, InstBuilder, Value};

use super::super::memory::{Address, Bit};
use super::super::natural_loops::NaturalLoop;
use super::super::value::Val;
use super::super::{Translator, is_bit};
use super::kernel::{Kernel, Slot, SlotKind};

impl Translator<'_> {
    /// What a slot holds before the loop.
    pub(super) fn slot_before(&mut self, kernel: &Kernel, slot: Slot) -> Val {
        match kernel.kept(slot) {
            SlotKind::Register(register) => self.register(register),
            SlotKind::Budget | SlotKind::Beyond => Val::Const(0),
            SlotKind::Element { .. } | SlotKind::Ahead { .. } => unreachable!("it is read where the loop is entered"),
            SlotKind::Clock => {
                let now = self.clock_ms();
                Val::Int(self.int(now))
            }
            SlotKind::Memory { base, offset, width, bit } => {
                let base = self.address_of_base(base);
                self.read_known(Address { base, offset, bit: Bit::Number(bit) }, width)
            }
        }
    }

    /// Writes what a slot holds behind the iterations.
    pub(super) fn write_slot(&mut self, kernel: &Kernel, slot: Slot, value: Val) {
        match kernel.kept(slot) {
            SlotKind::Register(register) => {
                let value = if is_bit(register) { self.flag(value) } else { self.word(value) };
                self.b.def_var(self.variables[register as usize], value);
            }
            // It goes into the budget behind the iterations; nothing writes the clock.
            SlotKind::Budget | SlotKind::Beyond | SlotKind::Clock | SlotKind::Element { .. } | SlotKind::Ahead { .. } => {}
            SlotKind::Memory { base, offset, width, bit } => {
                let base = self.address_of_base(base);
                self.write_known(Address { base, offset, bit: Bit::Number(bit) }, width, value);
            }
        }
    }

    /// Fills the block behind the last iteration, which has no way back: so much of the budget is left that has its weight still taken.
    pub(super) fn leave_behind(&mut self, it: &NaturalLoop, leave: clif::Block, left: Value, weight: i64) {
        self.b.switch_to_block(leave);
        self.b.seal_block(leave);
        let left = self.b.ins().iadd_imm_s(left, weight);
        let budget = self.budget();
        self.b.def_var(budget, left);
        let exit = it.last + 1;
        self.leave_loops(exit);
        self.forget_memory();
        let taken = self.taken;
        let next = self.edge(exit);
        self.taken = taken;
        self.b.ins().jump(next, &[]);
    }
}
