//! Live-range splitting for the address of the arena: a value that lives through a function of thousands of instructions has no register,
//! and is loaded from the stack for each access. So it is loaded once after each merge, and each region in between keeps it in a register.

use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, StackSlotData, StackSlotKind};
use sieben_engine::ir::{Callee, Inst};

use super::Translator;
use crate::passes::Pass;

/// IR instructions from which a function is long.
const LONG_FUNCTION: usize = 400;

impl Translator<'_> {
    /// Puts the address of the arena where a long function takes it from.
    pub(super) fn keep_arena(&mut self) {
        let inlined = |inst: &Inst| match inst {
            Inst::Call { callee: Callee::Block(id), .. } => {
                (self.find)(*id).and_then(|code| self.plans[code as usize].inlined()).unwrap_or(0)
            }
            _ => 0,
        };
        let insts = &self.native().code.insts;
        let length = insts.len() + insts.iter().map(inlined).sum::<usize>();
        if self.options.does(Pass::LiveRangeSplitting) && length >= LONG_FUNCTION {
            let slot = self.b.create_sized_stack_slot(StackSlotData::new(StackSlotKind::ExplicitSlot, 8, 3));
            self.b.ins().stack_store(I64, self.arena, slot, 0);
            self.arena_slot = Some(slot);
        }
    }

    /// Takes the address of the arena again, where ways to a statement meet or a block begins. In a loop it stays as it is.
    pub(super) fn take_arena(&mut self) {
        let Some(slot) = self.arena_slot else { return };
        let statement = self.statement;
        let begins = |first: u32| self.arrivals.get(&first).is_some_and(|it| it.again.is_some());
        let inside = self.loops.iter().any(|it| it.contains(statement) && !(it.first == statement && begins(statement)));
        let around = self.outer.iter().any(|outer| outer.is_in_loop());
        // In the same piece of code it is known.
        let block = self.b.current_block();
        if !inside && !around && self.arena_taken != block {
            self.arena_taken = block;
            self.arena = self.b.ins().stack_load(I64, I64, slot, 0);
        }
    }
}
