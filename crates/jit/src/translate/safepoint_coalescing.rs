//! Safe-point coalescing: the budget of a function is a variable, and what blocks have taken from it is subtracted later, for several of
//! them in one step.
//!
//! In an organization block one check before a statement covers the blocks that are inlined from there on, so that entering them costs
//! nothing and no available value is lost: their costs are added up, and the interpreter takes over at the statement if the budget does not
//! cover all of them. It makes its calls of the Host where the program would have made them.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::immediates::Imm64;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{self as clif, InstBuilder, InstructionData, Opcode, Value, ValueDef};
use sieben_engine::ir::{Callee, Inst};

use super::natural_loops::targets;
use super::{Continuation, Translator};
use crate::passes::Pass;
use crate::runtime_calls::RuntimeCall;

/// What a look at the budget may be for: less than the least budget of a CPU, so that the interpreter is seldom needed.
pub(super) const WEIGHT_MAX: i64 = 24;

/// A look at the budget before a statement.
#[derive(Debug, Default)]
pub(super) struct BudgetCheck {
    /// What it is for so far.
    weight: i64,
    /// Numbers in the code that follow it: the instruction, and what is added there.
    limits: Vec<(clif::Inst, i64)>,
}

impl Translator<'_> {
    /// Takes so much of what has been taken from the budget from its variable.
    pub(super) fn take_from_budget(&mut self, taken: i64) {
        if taken == 0 {
            return;
        }
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let left = self.b.ins().iadd_imm_s(budget, -taken);
        self.b.def_var(variable, left);
        self.taken -= taken;
    }

    /// Makes the budget's variable lack the same on all ways to a statement.
    pub(super) fn meet_budget(&mut self, statement: u32) {
        let taken = self.taken;
        let there = *self.arrival(statement).taken.get_or_insert(taken);
        self.take_from_budget(taken - there);
    }

    /// Whether the last look at the budget is for a block of this weight, too.
    pub(super) fn is_looked_at(&mut self, weight: i64) -> bool {
        let Some(look) = self.look.map(|index| &mut self.looks[index]) else { return false };
        if look.weight + weight > WEIGHT_MAX {
            self.look = None;
            return false;
        }
        look.weight += weight;
        for &(inst, added) in &look.limits {
            let imm = Imm64::new(look.weight + added);
            self.b.func.dfg.insts[inst] = InstructionData::UnaryImm { opcode: Opcode::Iconst, imm };
        }
        true
    }

    /// For how much more the last look at the budget may be.
    pub(super) fn left_of_look(&self) -> i64 {
        self.look.map_or(0, |look| WEIGHT_MAX - self.looks[look].weight)
    }

    /// The weight that a look is for at the end, and more.
    pub(super) fn weight_of_look(&mut self, index: usize, added: i64) -> Value {
        let limit = self.b.ins().iconst(I64, self.looks[index].weight + added);
        if let ValueDef::Result(inst, _) = self.b.func.dfg.value_def(limit) {
            self.looks[index].limits.push((inst, added));
        }
        limit
    }

    /// Looks at the budget before a statement that enters blocks, if no look before is for them.
    pub(super) fn look_at_budget(&mut self) {
        if self.look.is_some()
            || !self.options.does(Pass::SafepointCoalescing)
            || self.called_only()
            || !self.outer.is_empty()
            || !self.enters_blocks_once()
        {
            return;
        }
        let index = self.looks.len();
        self.looks.push(BudgetCheck::default());
        let limit = self.weight_of_look(index, self.taken);
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let too_low = self.b.ins().icmp(IntCC::SignedLessThan, budget, limit);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.native().named(self.statement);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        self.unless_failed(too_low, RuntimeCall::Interpret, &[self.link, code, statement], Continuation::Never);
        self.look = Some(index);
    }

    /// Whether the function begins with a look at the budget: if its first statement enters blocks.
    pub(super) fn looks_at_the_beginning(&self) -> bool {
        self.options.does(Pass::SafepointCoalescing)
            && !self.called_only()
            && self.outer.is_empty()
            && self.statement == 0
            && self.enters_blocks_once()
    }

    /// The safe point at the beginning of a function of this weight and the look before its first statement, as one comparison.
    pub(super) fn enter_and_look(&mut self, weight: i64) {
        let index = self.looks.len();
        self.looks.push(BudgetCheck::default());
        self.taken += weight;
        let limit = self.weight_of_look(index, self.taken);
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let too_low = self.b.ins().icmp(IntCC::SignedLessThan, budget, limit);
        let (cold, ask, go_on) = (self.cold_block(), self.cold_block(), self.b.create_block());
        self.b.ins().brif(too_low, cold, &[], go_on, &[]);
        self.b.switch_to_block(cold);
        self.b.seal_block(cold);
        let before = self.cold.replace(cold);
        let used_up = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, budget, self.taken);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.b.ins().iconst(I64, 0);
        let interpret = self.b.create_block();
        self.b.set_cold_block(interpret);
        self.b.ins().brif(used_up, ask, &[], interpret, &[]);
        self.cold = before;
        self.cold_path(interpret, RuntimeCall::Interpret, &[self.link, code, statement], Continuation::Never);
        self.look = Some(index);
        self.ask_at_safe_point(ask, 0, go_on);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.forget_what_was_asked();
    }

    /// Whether the running statement is in no loop and calls blocks that become part of it.
    fn enters_blocks_once(&self) -> bool {
        let code = &self.native().code;
        if self.statement as usize >= code.statement_count() {
            return false;
        }
        let becomes_part = |inst: &Inst| match inst {
            Inst::Call { callee: Callee::Block(id), .. } => (self.find)(*id).is_some_and(|code| self.inlines(code as usize)),
            _ => false,
        };
        let jumps_over = |from: usize| {
            code.statement(from).iter().flat_map(|inst| targets(code, inst)).any(|to| to <= self.statement && to as usize <= from)
        };
        code.statement(self.statement as usize).iter().any(becomes_part)
            && !(self.statement as usize..code.statement_count()).any(jumps_over)
    }

    /// Whether the budget, as somebody who was asked left it, lasts for what the look was for.
    pub(super) fn budget_lasts(&mut self, look: usize) -> Value {
        let limit = self.weight_of_look(look, 0);
        let budget = self.load_budget();
        self.b.ins().icmp(IntCC::SignedGreaterThanOrEqual, budget, limit)
    }
}
