//! Turns that the interpreter does: a loop that enters blocks which become part of it looks at the budget once a turn, so that entering them
//! costs nothing and nothing that is known is lost. If the budget does not last for all of them, or a statement failed, the interpreter does
//! the rest of the turn, asks where the program would have asked, and machine code goes on with the next turn or behind the loop.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{self as clif, InstBuilder, Value};
use sieben_engine::ir::{Callee, Inst};
use sieben_engine::machine::Register;

use super::Translator;
use super::budget::Look;
use super::loops::{Loop, targets};
use crate::ask::Question;
use crate::run::Link;
use crate::turn::span;

/// IR instructions of a turn, with the blocks that it enters: the interpreter takes longer for them than machine code.
const INSTRUCTIONS_MAX: usize = 4_000;

/// A loop whose turns the interpreter does where it must.
#[derive(Clone, Copy, Debug)]
pub(super) struct InterpretedTurn {
    /// The block, and in how many others it is inlined.
    index: usize,
    level: usize,
    first: u32,
    last: u32,
    /// The look at the budget for a turn.
    look: usize,
    /// In front of the loop.
    front: clif::Block,
    /// Where a whole turn is handed over.
    whole: clif::Block,
    /// Behind a turn that the interpreter did.
    done: clif::Block,
}

impl Translator<'_> {
    /// Looks in front of a loop at the budget for its first turn, if its turns enter blocks and nothing that could take long.
    pub(super) fn look_at_turn(&mut self, it: &Loop) {
        if !self.options.optimize || self.cold.is_some() || self.taken != 0 || !self.enters_small_blocks(it) {
            return;
        }
        let Some(front) = self.arrivals.get(&it.first).map(|arrival| arrival.block) else { return };
        let look = self.looks.len();
        self.looks.push(Look::default());
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let limit = self.weight_of_look(look, 0);
        let too_low = self.b.ins().icmp(IntCC::SignedLessThan, budget, limit);
        let (whole, done, head) = (self.cold_block(), self.cold_block(), self.b.create_block());
        self.b.ins().brif(too_low, whole, &[], head, &[]);
        let turn = InterpretedTurn { index: self.index, level: self.outer.len(), first: it.first, last: it.last, look, front, whole, done };
        self.interpreted.push(turn);
        self.hand_over_whole_turn(turn);
        self.go_on_behind_turn(turn);
        self.b.switch_to_block(head);
        self.b.seal_block(head);
        self.look = Some(look);
    }

    /// Whether a loop enters blocks that become part of it, and nothing in it could take long.
    fn enters_small_blocks(&self, it: &Loop) -> bool {
        let code = &self.native().code;
        let statements = || (it.first..=it.last).map(|statement| (statement, code.statement(statement as usize)));
        let called = |inst: &Inst| match inst {
            Inst::Call { callee: Callee::Block(id), .. } => Some((self.find)(*id).map(|code| code as usize)),
            Inst::Call { .. } => Some(None),
            _ => None,
        };
        let small = |callee: Option<usize>| {
            let callee = callee.filter(|&callee| self.inlines(callee) && !self.plans[callee].loops)?;
            self.plans[callee].inlined()
        };
        let calls = statements().flat_map(|(_, insts)| insts).filter_map(called);
        let Some(sizes) = calls.map(small).collect::<Option<Vec<usize>>>() else { return false };
        let own: usize = statements().map(|(_, insts)| insts.len()).sum();
        let begins_again =
            |statement: u32, insts: &[Inst]| insts.iter().flat_map(|inst| targets(code, inst)).all(|to| to > statement || to == it.first);
        !sizes.is_empty()
            && sizes.iter().fold(own, |all, &size| all.saturating_add(size)) <= INSTRUCTIONS_MAX
            && statements().all(|(statement, insts)| begins_again(statement, insts))
    }

    /// Forgets the loops of an inlined block that ends.
    pub(super) fn leave_interpreted_turns(&mut self) {
        let level = self.outer.len();
        self.interpreted.retain(|turn| turn.level < level);
    }

    /// The loop that begins at a statement of the present block, if the budget is looked at once for each of its turns.
    pub(super) fn turn_of(&self, first: u32) -> Option<InterpretedTurn> {
        let here = (self.index, self.outer.len(), first);
        self.interpreted.iter().rev().find(|turn| (turn.index, turn.level, turn.first) == here).copied()
    }

    /// Looks at the budget, behind a way back, for the next turn: it may be used up or not last.
    pub(super) fn look_at_next_turn(&mut self, turn: InterpretedTurn, left: Value, head: clif::Block) {
        let limit = self.weight_of_look(turn.look, 0);
        let too_low = self.b.ins().icmp(IntCC::SignedLessThan, left, limit);
        let (cold, ask) = (self.cold_block(), self.cold_block());
        self.b.ins().brif(too_low, cold, &[], head, &[]);
        self.b.switch_to_block(cold);
        self.b.seal_block(cold);
        let used_up = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, left, 0);
        self.b.ins().brif(used_up, ask, &[], turn.whole, &[]);
        self.ask_at_safe_point(ask, turn.first, turn.front);
    }

    /// Fills the block that hands over a whole turn.
    fn hand_over_whole_turn(&mut self, turn: InterpretedTurn) {
        self.b.switch_to_block(turn.whole);
        let before = self.cold.replace(turn.whole);
        self.spill(self.dirty);
        self.store_promoted();
        let link = self.shown_link();
        self.hand_over(turn, turn.first, link);
        self.cold = before;
    }

    /// Lets the interpreter go on with a statement of the present block up to the end of a turn. Memory is as the program left it.
    fn hand_over(&mut self, turn: InterpretedTurn, statement: u32, link: Value) {
        let home = self.link_of(turn.level);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.first_with_code(statement);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        let first = self.first_with_code_in(turn.index, turn.first);
        let span = self.b.ins().iconst(I64, span(first, turn.last) as i64);
        let answer = self.ask_at_gate(Question::Turn, &[self.run, link, code, statement, span, home]);
        self.b.ins().brif(answer, self.leave, &[], turn.done, &[]);
    }

    /// Address of the link of a block in which the present one is inlined, or of its own.
    fn link_of(&mut self, level: usize) -> Value {
        if level == 0 { self.link } else { self.b.ins().iadd_imm_u(self.link, (level * size_of::<Link>()) as i64) }
    }

    /// Fills the block behind a turn that the interpreter did: in front of the next one, behind the loop, or elsewhere, where the interpreter
    /// goes on.
    fn go_on_behind_turn(&mut self, turn: InterpretedTurn) {
        self.b.switch_to_block(turn.done);
        let before = self.cold.replace(turn.done);
        let kept = (self.current, self.changed, self.dirty, self.taken);
        let statement = self.result();
        let unknown = Register::ALL.iter().filter(|&&register| self.current[register as usize].is_none());
        self.reload(unknown.fold(0, |all, &register| all | super::bit_of(register)));
        // A statement inside of a block that was entered came here with the variables of that block.
        self.changed = u32::MAX;
        self.define_variables(u32::MAX);
        self.take_promoted();
        let [again, elsewhere, behind, nowhere] = [(); 4].map(|()| self.cold_block());
        let first = self.first_with_code(turn.first);
        let begins_again = self.b.ins().icmp_imm_u(IntCC::Equal, statement, i64::from(first));
        self.b.ins().brif(begins_again, again, &[], elsewhere, &[]);
        self.b.switch_to_block(elsewhere);
        self.b.seal_block(elsewhere);
        let end = self.first_with_code(turn.last + 1);
        let is_behind = self.b.ins().icmp_imm_u(IntCC::Equal, statement, i64::from(end));
        self.b.ins().brif(is_behind, behind, &[], nowhere, &[]);
        self.b.switch_to_block(nowhere);
        self.b.seal_block(nowhere);
        let link = self.link_of(turn.level);
        let code = self.b.ins().iconst(I64, self.index as i64);
        self.ask_at_gate(Question::Interpret, &[self.run, link, code, statement]);
        self.b.ins().jump(self.leave, &[]);
        self.b.switch_to_block(again);
        self.b.seal_block(again);
        let front = self.verified(turn.first, turn.front);
        self.b.ins().jump(front, &[]);
        self.write_verifications();
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
        let next = self.edge(end);
        let next = self.verified(end, next);
        self.b.ins().jump(next, &[]);
        self.write_verifications();
        (self.current, self.changed, self.dirty, self.taken) = kept;
        self.cold = before;
    }

    /// Behind a statement that failed in a turn: lets the interpreter do the rest, unless the run is left; whether it does. That costs the
    /// statements that follow nothing of what they know.
    pub(super) fn rest_is_interpreted(&mut self, left: Value) -> bool {
        let contains = |turn: &&InterpretedTurn| {
            let (index, statement) = match self.outer.get(turn.level) {
                Some(outer) => outer.place(),
                None => (self.index, self.statement),
            };
            turn.index == index && (turn.first..=turn.last).contains(&statement)
        };
        let Some(turn) = self.interpreted.iter().rev().find(contains).copied() else { return false };
        let rest = self.cold_block();
        self.b.ins().brif(left, self.leave, &[], rest, &[]);
        self.b.switch_to_block(rest);
        self.b.seal_block(rest);
        let link = self.link_of(self.outer.len());
        self.hand_over(turn, self.statement + 1, link);
        true
    }
}
