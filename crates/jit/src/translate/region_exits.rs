//! Region exits: one check of the budget covers a region with inlined blocks, so that entering them costs nothing and no available value is
//! lost. A region is an iteration of a loop, or statements that follow one another. If the budget does not cover it, or a statement failed,
//! the interpreter does the region, or the rest of it, makes its calls of the Host where the program would have made them, and machine code
//! goes on after it.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{self as clif, InstBuilder, Value};
use sieben_engine::ir::{Callee, Inst, Var};
use sieben_engine::machine::Register;

use super::natural_loops::{self, NaturalLoop, targets};
use super::safepoint_coalescing::{BudgetCheck, WEIGHT_MAX};
use super::value::Val;
use super::{Translator, bit_of};
use crate::deoptimization::span;
use crate::passes::Pass;
use crate::run::Link;
use crate::runtime_calls::RuntimeCall;

/// IR instructions of a piece, with the blocks that it enters: the interpreter takes longer for them than machine code.
const INSTRUCTIONS_MAX: usize = 4_000;
/// Instructions of its own that statements which follow one another have. So many are looked at before each of them that enters
/// blocks.
const OWN_MAX: usize = 400;
/// The same where they begin with calls that may be done side by side.
const OWN_MAX_IN_SERIES: usize = 800;

/// What a statement enters.
struct Entered {
    /// IR instructions, with its own.
    instructions: usize,
    /// What that takes from the budget at most.
    weight: i64,
}

/// A piece of code that the interpreter does where it must.
#[derive(Clone, Copy, Debug)]
pub(super) struct RegionExit {
    /// The block, and in how many others it is inlined.
    index: usize,
    level: usize,
    /// First and last statement.
    first: u32,
    last: u32,
    /// The look at the budget.
    pub(super) look: usize,
    /// Before the loop, if it is an iteration.
    front: Option<clif::Block>,
    /// Where the whole piece is handed over.
    whole: clif::Block,
    /// Behind it, if the interpreter did it.
    done: clif::Block,
}

impl Translator<'_> {
    /// Looks before a loop at the budget for its first iteration, if its iterations enter blocks and nothing that could take long.
    pub(super) fn look_at_iteration(&mut self, it: &NaturalLoop) {
        if !self.options.does(Pass::RegionExit) || self.cold.is_some() || self.taken != 0 || !self.enters_small_blocks(it) {
            return;
        }
        let front = self.arrivals.get(&it.first).map(|arrival| arrival.block);
        self.look_at_piece((it.first, it.last), front, it.written);
    }

    /// Looks at the budget before a statement that enters blocks, if no look before is for them: for all statements from there up to
    /// one to which each way through them comes.
    pub(super) fn look_at_statements(&mut self) {
        if self.look.is_some() || !self.options.does(Pass::RegionExit) || self.cold.is_some() {
            return;
        }
        if let Some(last) = self.last_of_piece() {
            self.look_up_to(last);
        }
    }

    /// Looks at the budget for all statements from the running one up to another one.
    pub(super) fn look_up_to(&mut self, last: u32) {
        let code = &self.native().code;
        let insts = (self.statement..=last).flat_map(|statement| code.statement(statement as usize));
        let written = insts.fold(0, |all, inst| all | natural_loops::written(inst));
        self.look_at_piece((self.statement, last), None, written);
    }

    fn look_at_piece(&mut self, (first, last): (u32, u32), front: Option<clif::Block>, changed: u32) {
        let look = self.looks.len();
        self.looks.push(BudgetCheck::default());
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let limit = self.weight_of_look(look, self.taken);
        let too_low = self.b.ins().icmp(IntCC::SignedLessThan, budget, limit);
        let (whole, done, head) = (self.cold_block(), self.cold_block(), self.b.create_block());
        self.b.ins().brif(too_low, whole, &[], head, &[]);
        let piece = RegionExit { index: self.index, level: self.outer.len(), first, last, look, front, whole, done };
        // Those that have ended contain no statement that follows.
        self.interpreted.retain(|other| other.level < piece.level || first <= other.last);
        self.interpreted.push(piece);
        self.interpret_from(whole, Some(piece), first);
        self.go_on_behind(piece, changed);
        self.b.switch_to_block(head);
        self.b.seal_block(head);
        self.look = Some(look);
    }

    /// Whether a loop enters blocks that become part of it, or has indexes that are looked at, and nothing in it could take long.
    fn enters_small_blocks(&self, it: &NaturalLoop) -> bool {
        let code = &self.native().code;
        let (mut entered, mut size) = (false, 0_usize);
        for statement in it.first..=it.last {
            let Some(Entered { instructions, weight }) = self.entered(statement) else { return false };
            size = size.saturating_add(instructions);
            entered |= weight > 0 || self.may_be_interpreted(statement);
            let targets = code.statement(statement as usize).iter().flat_map(|inst| targets(code, inst));
            if size > INSTRUCTIONS_MAX || targets.into_iter().any(|to| to <= statement && to != it.first) {
                return false;
            }
        }
        entered
    }

    /// Whether the interpreter does a statement where an index is outside its array.
    fn may_be_interpreted(&self, statement: u32) -> bool {
        let code = &self.native().code;
        let first = code.statements[statement as usize];
        (first..).zip(code.statement(statement as usize)).any(|(index, _)| self.ranges.is_interpreted(index))
    }

    /// The last statement of a piece that begins with the present one: behind it all ways through the piece meet.
    fn last_of_piece(&self) -> Option<u32> {
        let code = &self.native().code;
        let (mut own, mut weight, mut size) = (0, 0, 0_usize);
        let own_max = if self.may_begin_series() { OWN_MAX_IN_SERIES } else { OWN_MAX };
        // Behind the last statement that a jump of the piece goes to, and the end of the piece so far.
        let (mut reached, mut end) = (self.statement, None);
        if self.entered(self.statement)?.weight == 0 {
            return None;
        }
        for statement in self.statement..code.statement_count() as u32 {
            let insts = code.statement(statement as usize);
            let Some(entered) = self.entered(statement) else { break };
            own += 1 + insts.len();
            weight += entered.weight;
            size = size.saturating_add(entered.instructions);
            let farthest = insts.iter().flat_map(|inst| targets(code, inst)).map(|to| if to > statement { to } else { u32::MAX }).max();
            reached = reached.max(farthest.unwrap_or(0));
            let leaves = insts.iter().any(|inst| matches!(inst, Inst::Return)) || reached as usize > code.statement_count();
            let begins_loop = statement > self.statement && self.arrivals.get(&statement).is_some_and(|it| it.backward);
            if own > own_max || weight > WEIGHT_MAX || size > INSTRUCTIONS_MAX || leaves || begins_loop {
                break;
            }
            if reached <= statement + 1 {
                end = Some(statement);
            }
        }
        end
    }

    /// What a statement enters, if all of it becomes part of the present block and has no loops.
    fn entered(&self, statement: u32) -> Option<Entered> {
        let insts = self.native().code.statement(statement as usize);
        insts.iter().try_fold(Entered { instructions: insts.len(), weight: 0 }, |all, inst| {
            let Inst::Call { callee, .. } = inst else { return Some(all) };
            let Callee::Block(id) = callee else { return None };
            let code = (self.find)(*id)? as usize;
            let instructions = self.plans[code].inlined().filter(|_| self.inlines(code) && !self.plans[code].loops)?;
            Some(Entered { instructions: all.instructions.saturating_add(instructions), weight: all.weight + self.plans[code].weight() })
        })
    }

    /// Forgets the pieces of an inlined block that ends.
    pub(super) fn leave_interpreted(&mut self) {
        let level = self.outer.len();
        self.interpreted.retain(|piece| piece.level < level);
    }

    /// The loop that begins at a statement of the present block, if the budget is looked at once for each of its iterations.
    pub(super) fn iteration_of(&self, first: u32) -> Option<RegionExit> {
        let here = (self.index, self.outer.len(), first);
        self.interpreted.iter().rev().find(|piece| piece.front.is_some() && (piece.index, piece.level, piece.first) == here).copied()
    }

    /// Looks at the budget, behind a way back, for the next iteration: it may be used up or not last.
    pub(super) fn look_at_next_iteration(&mut self, iteration: RegionExit, left: Value, head: clif::Block) {
        let limit = self.weight_of_look(iteration.look, 0);
        let too_low = self.b.ins().icmp(IntCC::SignedLessThan, left, limit);
        let (cold, ask) = (self.cold_block(), self.cold_block());
        self.b.ins().brif(too_low, cold, &[], head, &[]);
        self.b.switch_to_block(cold);
        self.b.seal_block(cold);
        let used_up = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, left, 0);
        self.b.ins().brif(used_up, ask, &[], iteration.whole, &[]);
        self.ask_at_safe_point(ask, iteration.first, iteration.front.unwrap_or(head));
    }

    /// Fills a cold block from which the interpreter goes on with a statement of the present block: up to the end of a piece, or for good.
    fn interpret_from(&mut self, cold: clif::Block, piece: Option<RegionExit>, statement: u32) {
        self.b.switch_to_block(cold);
        let before = self.cold.replace(cold);
        self.spill(self.dirty);
        self.store_promoted();
        match piece {
            Some(piece) => {
                let link = self.shown_link();
                self.hand_over(piece, statement, link);
            }
            None => self.give_up_at(statement),
        }
        self.cold = before;
    }

    /// Lets the interpreter go on with a statement of the present block up to the end of a piece. Memory is as the program left it.
    fn hand_over(&mut self, piece: RegionExit, statement: u32, link: Value) {
        let home = self.link_of(piece.level);
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.first_named(statement);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        let first = self.first_named_in(piece.index, piece.first);
        let span = self.b.ins().iconst(I64, span(first, self.blocks[piece.index].named(piece.last)) as i64);
        let answer = self.ask_at_gate(RuntimeCall::Iteration, &[self.run, link, code, statement, span, home]);
        self.b.ins().brif(answer, self.leave, &[], piece.done, &[]);
    }

    /// Address of the link of a block in which the present one is inlined, or of its own.
    fn link_of(&mut self, level: usize) -> Value {
        if level == 0 { self.link } else { self.b.ins().iadd_imm_u(self.link, (level * size_of::<Link>()) as i64) }
    }

    /// Fills the block behind a piece that the interpreter did: before the next iteration, behind the piece, or elsewhere, where the
    /// interpreter goes on. `changed` are the registers that it may have changed.
    fn go_on_behind(&mut self, piece: RegionExit, changed: u32) {
        self.b.switch_to_block(piece.done);
        let before = self.cold.replace(piece.done);
        let kept = (self.current, self.changed, self.dirty, self.taken);
        let statement = self.result();
        // What is no constant may be another value on ways from the middle of the piece.
        let is_kept = |register: Register| {
            let constant = matches!(self.current[register as usize], Some(Val::Const(_)));
            constant && (changed & bit_of(register) == 0 || piece.front.is_some())
        };
        let others = Register::ALL.iter().filter(|&&register| !is_kept(register));
        self.reload(others.fold(0, |all, &register| all | bit_of(register)));
        // A statement inside of a block that was entered came here with the variables of that block.
        self.changed = u32::MAX;
        self.define_variables(u32::MAX);
        self.take_promoted();
        if let Some(front) = piece.front {
            let [again, elsewhere] = [(); 2].map(|()| self.cold_block());
            let first = self.first_named(piece.first);
            let begins_again = self.b.ins().icmp_imm_u(IntCC::Equal, statement, i64::from(first));
            self.b.ins().brif(begins_again, again, &[], elsewhere, &[]);
            self.b.switch_to_block(again);
            self.b.seal_block(again);
            let front = self.verified(piece.first, front);
            self.b.ins().jump(front, &[]);
            self.write_verifications();
            self.b.switch_to_block(elsewhere);
            self.b.seal_block(elsewhere);
        }
        let [behind, nowhere] = [(); 2].map(|()| self.cold_block());
        // What does nothing is passed by the interpreter, and may be the first statement of a loop.
        let end = piece.last + 1;
        let named = self.first_named(end);
        let is_behind = self.b.ins().icmp_imm_u(IntCC::Equal, statement, i64::from(named));
        self.b.ins().brif(is_behind, behind, &[], nowhere, &[]);
        self.b.switch_to_block(nowhere);
        self.b.seal_block(nowhere);
        let link = self.link_of(piece.level);
        let code = self.b.ins().iconst(I64, self.index as i64);
        self.ask_at_gate(RuntimeCall::Interpret, &[self.run, link, code, statement]);
        self.b.ins().jump(self.leave, &[]);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
        let next = self.edge(end);
        let next = self.verified(end, next);
        self.b.ins().jump(next, &[]);
        self.write_verifications();
        (self.current, self.changed, self.dirty, self.taken) = kept;
        self.cold = before;
    }

    /// Lets the interpreter do the running statement, of which nothing is done that it could not do again, and the rest of the piece where
    /// a condition does not hold; all that follows takes it to hold.
    pub(super) fn require_or_interpret(&mut self, condition: Var) {
        let holds = self.get(condition);
        let holds = self.flag(holds);
        let (cold, go_on) = (self.cold_block(), self.b.create_block());
        self.b.ins().brif(holds, go_on, &[], cold, &[]);
        self.interpret_from(cold, self.piece_around(), self.statement);
        self.b.seal_block(cold);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        if condition.register().is_none() {
            self.set(condition, Val::Const(1));
        }
    }

    /// The innermost piece with the running statement.
    fn piece_around(&self) -> Option<RegionExit> {
        let contains = |piece: &&RegionExit| {
            let (index, statement) = match self.outer.get(piece.level) {
                Some(outer) => outer.place(),
                None => (self.index, self.statement),
            };
            piece.index == index && (piece.first..=piece.last).contains(&statement)
        };
        self.interpreted.iter().rev().find(contains).copied()
    }

    /// Behind a statement of a piece that failed: lets the interpreter do the rest, unless the run is left; whether it does. That costs the
    /// statements that follow nothing of what they know.
    pub(super) fn rest_is_interpreted(&mut self, left: Value) -> bool {
        let Some(piece) = self.piece_around() else { return false };
        let rest = self.cold_block();
        self.b.ins().brif(left, self.leave, &[], rest, &[]);
        self.b.switch_to_block(rest);
        self.b.seal_block(rest);
        let link = self.link_of(self.outer.len());
        self.hand_over(piece, self.statement + 1, link);
        true
    }
}
