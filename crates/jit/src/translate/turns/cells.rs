//! What cells hold in front of a loop whose turns nobody looks at and behind it, and how the code goes on there.

use cranelift_codegen::ir::{self as clif, InstBuilder, Value};

use super::super::loops::Loop;
use super::super::memory::{Address, Bit};
use super::super::value::Val;
use super::super::{Translator, is_bit};
use super::kernel::{Cell, Kept, Kernel};

impl Translator<'_> {
    /// What a cell holds in front of the loop.
    pub(super) fn cell_before(&mut self, kernel: &Kernel, cell: Cell) -> Val {
        match kernel.kept(cell) {
            Kept::Register(register) => self.register(register),
            Kept::Budget | Kept::Beyond => Val::Const(0),
            Kept::Element { .. } | Kept::Ahead { .. } => unreachable!("it is read where the loop is entered"),
            Kept::Clock => {
                let now = self.clock_ms();
                Val::Int(self.int(now))
            }
            Kept::Memory { base, offset, width, bit } => {
                let base = self.address_of_base(base);
                self.read_known(Address { base, offset, bit: Bit::Number(bit) }, width)
            }
        }
    }

    /// Writes what a cell holds behind the turns.
    pub(super) fn write_cell(&mut self, kernel: &Kernel, cell: Cell, value: Val) {
        match kernel.kept(cell) {
            Kept::Register(register) => {
                let value = if is_bit(register) { self.flag(value) } else { self.word(value) };
                self.b.def_var(self.variables[register as usize], value);
            }
            // It goes into the budget behind the turns; nothing writes the clock.
            Kept::Budget | Kept::Beyond | Kept::Clock | Kept::Element { .. } | Kept::Ahead { .. } => {}
            Kept::Memory { base, offset, width, bit } => {
                let base = self.address_of_base(base);
                self.write_known(Address { base, offset, bit: Bit::Number(bit) }, width, value);
            }
        }
    }

    /// Fills the block behind the last turn, which has no way back: so much of the budget is left that has its weight still taken.
    pub(super) fn leave_behind(&mut self, it: &Loop, leave: clif::Block, left: Value, weight: i64) {
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
