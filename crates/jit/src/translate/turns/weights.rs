//! How many turns the inner loop makes, if only the code in front of the outer one can count them, and what turns take from the budget.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{InstBuilder, Value};

use super::super::value::Val;
use super::InnerTurns;
use super::count::INNER_TURNS_MAX;
use super::kernel::Level;
use super::write::Writing;

impl Writing<'_, '_, '_> {
    /// What each turn takes from the budget, with the way back behind it, and what one takes at most.
    pub(super) fn weights(&mut self) -> [Val; 2] {
        let outer = &self.kernel.outer;
        let alone = [outer.blocks, outer.blocks_most].map(|blocks| i64::from(outer.weight) + i64::from(blocks));
        let Some(inner) = &self.kernel.inner else { return alone.map(|alone| Val::Const(alone as u64)) };
        // Behind the last of its turns it does not jump back.
        let (each, back) = (i64::from(inner.weight) + i64::from(inner.blocks), i64::from(inner.weight));
        match (self.plan.inner, self.inner_turns) {
            (InnerTurns::Constant(turns), _) => alone.map(|alone| Val::Const((alone + each * turns - back) as u64)),
            (InnerTurns::Counted(_), turns) => {
                let turns = turns.unwrap_or_else(|| unreachable!("they are counted in front of the loop"));
                let inside = self.t.b.ins().imul_imm_s(turns, each);
                alone.map(|alone| Val::Word(self.t.b.ins().iadd_imm_s(inside, alone - back)))
            }
        }
    }

    pub(super) fn take_budget(&mut self, turns: Value) -> Value {
        let [weight, _] = self.weights();
        let budget = self.t.budget();
        let budget = self.t.b.use_var(budget);
        let taken = match weight {
            Val::Const(1) => turns,
            Val::Const(weight) => self.t.b.ins().imul_imm_s(turns, weight as i64),
            weight => {
                let weight = self.t.word(weight);
                self.t.b.ins().imul(turns, weight)
            }
        };
        let left = self.t.b.ins().isub(budget, taken);
        let Some(also) = self.taken else { return left };
        let also = self.t.word(also);
        self.t.b.ins().isub(left, also)
    }

    /// Counts the turns of the inner loop, if that can be done in front of the outer one only, and whether all is so that is taken for
    /// granted in them.
    pub(super) fn count_inner_turns(&mut self) -> Option<Value> {
        let InnerTurns::Counted(count) = self.plan.inner else { return None };
        let counter = self.value_before(count.counter);
        let limit = count.limit.map_or(Val::Const(0), |limit| self.value_before(limit));
        let (turns, inside) = self.t.turns(count, counter, limit);
        self.inner_turns = Some(turns);
        let mut all = self.t.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, turns, INNER_TURNS_MAX);
        if let Some(inside) = inside {
            all = self.t.b.ins().band(all, inside);
        }
        for &(number, limit) in &self.kernel.required_inside {
            let stays_below = self.stays_below((number, Level::Inner), limit, turns);
            all = self.t.b.ins().band(all, stays_below);
        }
        Some(all)
    }

    /// The turns of the inner loop in each turn of the outer one, behind `how_many`.
    pub(super) fn all_inner_turns(&mut self) -> Value {
        match (self.plan.inner, self.inner_turns) {
            (InnerTurns::Counted(_), Some(turns)) => turns,
            (InnerTurns::Counted(_), None) => unreachable!("they are counted in front of the loop"),
            (InnerTurns::Constant(turns), _) => self.t.turns_constant(turns),
        }
    }
}
