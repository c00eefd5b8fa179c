//! Cells that a turn chooses and that lead to an address in the next one, like the index of the greatest element so far: a choice would make
//! each turn wait for the one before, so a jump makes it, which the machine guesses.

use std::collections::BTreeSet;

use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{BlockArg, InstBuilder};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::super::value::Val;
use super::kernel::{Kernel, Level, Node, What};
use super::line::Carried;

impl Kernel {
    /// Choices of what such cells hold in the next turn.
    pub(super) fn chased(&self) -> BTreeSet<Node> {
        let mut chosen = BTreeSet::new();
        for (cell, end, carried) in self.carried(Level::Outer) {
            let reads = self.accesses.iter().filter(|access| access.value.is_none());
            if carried != Carried::Chain || self.kept(cell).is_wide() || self.is_bit(end) {
                continue;
            }
            if !reads.into_iter().any(|access| self.rests_on(access.pointer, Level::Outer, cell)) {
                continue;
            }
            let mut waiting = vec![end];
            while let Some(node) = waiting.pop() {
                match self.what(node) {
                    What::Compute(Op::Select, [_, a, b, _]) if chosen.insert(node) => waiting.extend([a, b]),
                    What::Compute(Op::Low16 | Op::Low32, [of, ..]) => waiting.push(of),
                    _ => {}
                }
            }
        }
        chosen
    }
}

impl Translator<'_> {
    /// One of two numbers of so many bits, chosen by a jump.
    pub(super) fn chosen_by_jump(&mut self, [condition, a, b]: [Val; 3], bits: u32) -> Val {
        let condition = self.flag(condition);
        let [a, b] = [a, b].map(|value| self.int(value));
        let behind = self.b.create_block();
        let chosen = self.b.append_block_param(behind, I32);
        self.b.ins().brif(condition, behind, &[BlockArg::Value(a)], behind, &[BlockArg::Value(b)]);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
        self.know_bits(chosen, bits)
    }
}
