//! Code of unrolled loops: see [`crate::unrolling`].

use cranelift_codegen::ir::InstBuilder;
use cranelift_codegen::ir::types::I64;

use super::{Continuation, Translator};
use crate::runtime_calls::RuntimeCall;

impl Translator<'_> {
    /// Before the first iteration looks at the budget for all of them, and takes from it what going on with the next one takes.
    pub(super) fn begin_iterations(&mut self) {
        let Some(written_out) = &self.native().written_out else { return };
        if let Some(iterations) = written_out.first(self.statement) {
            let all = iterations.weight_of_all();
            if self.options.optimize && self.cold.is_none() && (self.look.is_none() || self.left_of_look() < all) {
                self.look_up_to(iterations.more());
            }
        }
        if let Some(iterations) = written_out.next_iteration(self.statement) {
            self.take_for_iteration(iterations.weight, self.statement);
        }
    }

    /// The safe point between two iterations, before a statement.
    fn take_for_iteration(&mut self, weight: u16, statement: u32) {
        if self.is_looked_at(i64::from(weight)) {
            self.taken += i64::from(weight);
            return;
        }
        let go_on = self.b.create_block();
        self.count_down(weight, statement, go_on, go_on);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.forget_what_was_asked();
    }

    /// Lets the interpreter go on where a loop has more iterations than are written out; whether the running statement is there for that.
    pub(super) fn has_more_iterations(&mut self) -> bool {
        let Some(iterations) = self.native().written_out.as_ref().and_then(|it| it.more(self.statement)) else { return false };
        let more = self.cold_block();
        self.b.ins().jump(more, &[]);
        self.b.switch_to_block(more);
        self.b.seal_block(more);
        self.take_for_iteration(iterations.weight, iterations.first);
        let statement = self.first_named(iterations.first);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        let cold = self.cold_block();
        self.b.ins().jump(cold, &[]);
        self.cold_path(cold, RuntimeCall::Interpret, &[self.link, code, statement], Continuation::Never);
        self.ended = true;
        true
    }
}
