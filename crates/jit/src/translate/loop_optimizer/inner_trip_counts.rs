//! Trip counts of inner loops, if only the code before the outer one can compute them, and the budget that iterations take.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{InstBuilder, Value};

use super::super::value::Val;
use super::InnerTripCount;
use super::emission::Emitter;
use super::kernel::Level;
use super::trip_count::INNER_ITERATIONS_MAX;

impl Emitter<'_, '_, '_> {
    /// What each iteration takes from the budget, with the way back behind it, and what one takes at most.
    pub(super) fn weights(&mut self) -> [Val; 2] {
        let outer = &self.kernel.outer;
        let alone = [outer.blocks, outer.blocks_most].map(|blocks| i64::from(outer.weight) + i64::from(blocks));
        let Some(inner) = &self.kernel.inner else { return alone.map(|alone| Val::Const(alone as u64)) };
        // Behind the last of its iterations it does not jump back.
        let (each, back) = (i64::from(inner.weight) + i64::from(inner.blocks), i64::from(inner.weight));
        match (self.plan.inner, self.inner_iterations) {
            (InnerTripCount::Constant(iterations), _) => alone.map(|alone| Val::Const((alone + each * iterations - back) as u64)),
            (InnerTripCount::Counted(_), iterations) => {
                let iterations = iterations.unwrap_or_else(|| unreachable!("they are counted in front of the loop"));
                let inside = self.t.b.ins().imul_imm_s(iterations, each);
                alone.map(|alone| Val::Word(self.t.b.ins().iadd_imm_s(inside, alone - back)))
            }
        }
    }

    pub(super) fn take_budget(&mut self, iterations: Value) -> Value {
        let [weight, _] = self.weights();
        let budget = self.t.budget();
        let budget = self.t.b.use_var(budget);
        let taken = match weight {
            Val::Const(1) => iterations,
            Val::Const(weight) => self.t.b.ins().imul_imm_s(iterations, weight as i64),
            weight => {
                let weight = self.t.word(weight);
                self.t.b.ins().imul(iterations, weight)
            }
        };
        let left = self.t.b.ins().isub(budget, taken);
        let Some(also) = self.taken else { return left };
        let also = self.t.word(also);
        self.t.b.ins().isub(left, also)
    }

    /// Counts the iterations of the inner loop, if that can be done before the outer one only, and whether all is so that is taken for
    /// granted in them.
    pub(super) fn count_inner_iterations(&mut self) -> Option<Value> {
        let InnerTripCount::Counted(count) = self.plan.inner else { return None };
        let counter = self.value_before(count.counter);
        let limit = count.limit.map_or(Val::Const(0), |limit| self.value_before(limit));
        let (iterations, inside) = self.t.iterations(count, counter, limit);
        self.inner_iterations = Some(iterations);
        let mut all = self.t.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, iterations, INNER_ITERATIONS_MAX);
        if let Some(inside) = inside {
            all = self.t.b.ins().band(all, inside);
        }
        for &(number, limit) in &self.kernel.required_inside {
            let stays_below = self.stays_below((number, Level::Inner), limit, iterations);
            all = self.t.b.ins().band(all, stays_below);
        }
        Some(all)
    }

    /// The iterations of the inner loop in each iteration of the outer one, behind `how_many`.
    pub(super) fn all_inner_iterations(&mut self) -> Value {
        match (self.plan.inner, self.inner_iterations) {
            (InnerTripCount::Counted(_), Some(iterations)) => iterations,
            (InnerTripCount::Counted(_), None) => unreachable!("they are counted in front of the loop"),
            (InnerTripCount::Constant(iterations), _) => self.t.iterations_constant(iterations),
        }
    }
}
