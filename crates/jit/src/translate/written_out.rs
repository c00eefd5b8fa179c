//! Loops whose turns are written out: see [`crate::written_out`].

use cranelift_codegen::ir::InstBuilder;
use cranelift_codegen::ir::types::I64;

use super::{After, Translator};
use crate::ask::Question;

impl Translator<'_> {
    /// In front of the first turn looks at the budget for all of them, and takes from it what going on with the next one takes.
    pub(super) fn begin_turns(&mut self) {
        let Some(written_out) = &self.native().written_out else { return };
        if let Some(turns) = written_out.first(self.statement) {
            let all = turns.weight_of_all();
            if self.options.optimize && self.cold.is_none() && (self.look.is_none() || self.left_of_look() < all) {
                self.look_up_to(turns.more());
            }
        }
        if let Some(turns) = written_out.next_turn(self.statement) {
            self.take_for_turn(turns.weight, self.statement);
        }
    }

    /// The safe point between two turns, in front of a statement.
    fn take_for_turn(&mut self, weight: u16, statement: u32) {
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

    /// Lets the interpreter go on where a loop has more turns than are written out; whether the running statement is there for that.
    pub(super) fn has_more_turns(&mut self) -> bool {
        let Some(turns) = self.native().written_out.as_ref().and_then(|it| it.more(self.statement)) else { return false };
        let more = self.cold_block();
        self.b.ins().jump(more, &[]);
        self.b.switch_to_block(more);
        self.b.seal_block(more);
        self.take_for_turn(turns.weight, turns.first);
        let statement = self.first_named(turns.first);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        let cold = self.cold_block();
        self.b.ins().jump(cold, &[]);
        self.cold_path(cold, Question::Interpret, &[self.link, code, statement], After::Never);
        self.ended = true;
        true
    }
}
