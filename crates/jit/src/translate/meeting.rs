//! Statements with indexes that are looked at and noted if they are outside their arrays: behind each look the statement is written
//! twice, for an index that is inside and, in cold code, for one that is not. Both ways meet at its end, where the hot one has neither
//! chosen an index nor an element.

use std::ops::Range;

use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{self as clif, BlockArg, InstBuilder, Value};
use cranelift_frontend::Variable;
use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Inst, Op, Place, Var};
use sieben_engine::machine::Register;
use sieben_model::address::Width;

use super::bytes::KnownMemory;
use super::loops::written;
use super::value::Val;
use super::{After, Translator, bit_of};
use crate::ask::Question;

/// Instructions behind a look at an index that are written twice at most: each look of a long statement would write all that follows
/// again. Among so many is looked for somebody who needs what a load reads.
const REST_MAX: usize = 96;

/// Where the ways of a statement meet.
pub(super) struct Meeting {
    block: clif::Block,
    /// The last instruction of the statement, behind which they meet, or in front of which, if it is a branch.
    last: u32,
    /// Its condition, then, and whether that is negated: the ways hand on what it was before.
    condition: Option<(Var, bool)>,
    /// Registers whose memory may be older than their value, on ways that are written already.
    dirty: u32,
    /// What was known of memory where the ways parted, and what the budget's variable lacked.
    memory: KnownMemory,
    taken: i64,
    /// Registers of data blocks that the rest of the statement opens, and what they are on all ways.
    opened: u32,
    known: Option<Vec<(Register, Val)>>,
}

/// What is known where ways part in a statement.
struct Parting {
    temporaries: Vec<Option<Val>>,
    current: [Option<Val>; Register::COUNT],
    changed: u32,
    dirty: u32,
    memory: KnownMemory,
}

impl Translator<'_> {
    fn parting(&self) -> Parting {
        let (current, changed, dirty) = (self.current, self.changed, self.dirty);
        Parting { temporaries: self.temporaries.clone(), current, changed, dirty, memory: self.known_memory() }
    }

    /// Goes on with the other way.
    fn go_back_to(&mut self, Parting { temporaries, current, changed, dirty, memory }: Parting) {
        (self.temporaries, self.current) = (temporaries, current);
        (self.changed, self.dirty) = (changed, dirty);
        self.know_memory(memory);
    }

    /// Looks at an index that is noted, if the rest of its statement can be written twice; whether it was.
    pub(super) fn look_and_part(&mut self, index: u32, condition: Var, shown: Var) -> bool {
        let look = self.get(condition);
        let look = self.force(look);
        if look.constant().is_some() || !self.options.optimize || self.cold.is_some() || !self.can_part(index, condition) {
            return false;
        }
        let code = &self.native().code;
        let end = code.statements.get(self.statement as usize + 1).copied().unwrap_or(code.insts.len() as u32);
        let last = end - 1 - u32::from(self.ends_with_jump(end));
        let negates = |condition: Var| matches!(code.insts[last as usize - 1], Inst::Compute { op: Op::Not, dst, .. } if dst == condition);
        let branch = match code.insts[last as usize] {
            Inst::Branch { condition, .. } => Some((condition, negates(condition))),
            _ => None,
        };
        let holds = self.flag(look);
        let site = self.site(index);
        let shown = self.get(shown);
        let shown = self.word(shown);
        let cold = self.cold_block();
        if self.meeting.is_none() {
            let block = self.b.create_block();
            if branch.is_some() {
                self.b.append_block_param(block, I32);
            }
            let opened = code.insts[index as usize..end as usize].iter().fold(0, |all, inst| all | written(inst));
            let (memory, taken) = (self.known_memory(), self.taken);
            self.meeting = Some(Meeting { block, last, condition: branch, dirty: 0, memory, taken, opened, known: None });
        }
        let held: Vec<(Variable, Value)> = self.held().into_iter().map(|variable| (variable, self.b.use_var(variable))).collect();
        let [inside, outside] = [self.b.create_block(), self.b.create_block()];
        self.b.set_cold_block(outside);
        self.b.ins().brif(holds, inside, &[], cold, &[]);
        let parting = self.parting();
        self.cold_path(cold, Question::Unmet, &[self.link, site, shown], After::At(outside));
        self.b.switch_to_block(outside);
        self.b.seal_block(outside);
        self.cold = Some(outside);
        // Who is told of a fault that is noted changes nothing: what registers of the machine stand for is what it was.
        for (variable, value) in held {
            self.b.def_var(variable, value);
        }
        self.set(condition, Val::Const(0));
        // A copy is left out.
        let left = self.leaving_branch(index + 1..last, condition).flatten();
        let rest = index + 1..left.unwrap_or(if branch.is_some() { last } else { end });
        for index in rest {
            self.inst(index, &code.insts[index as usize]);
        }
        self.go_to_meeting();
        self.cold = None;
        self.go_back_to(parting);
        self.b.switch_to_block(inside);
        self.b.seal_block(inside);
        self.set(condition, Val::Const(1));
        true
    }

    /// Whether the rest of a statement changes nothing but memory, with its last instruction, and which data blocks are open.
    fn can_part(&self, index: u32, condition: Var) -> bool {
        let code = &self.native().code;
        let first = code.statements[self.statement as usize];
        let statement = code.statement(self.statement as usize);
        let jumps = self.ends_with_jump(first + statement.len() as u32);
        let rest = &statement[(index + 1 - first) as usize..statement.len() - usize::from(jumps)];
        let is_own = |dst: Var| dst.register().is_none();
        let Some((last, between)) = rest.split_last() else { return false };
        let (ends, copies) = match *last {
            Inst::Store { width, .. } => (width != Width::QuadWord, false),
            Inst::Move { .. } => (true, true),
            Inst::Branch { .. } => (true, false),
            _ => (false, false),
        };
        let end_of_between = index + 1 + between.len() as u32;
        ends && rest.len() <= REST_MAX
            && is_own(condition)
            && self.choice.is_none()
            && self.leaving_branch(index + 1..end_of_between, condition).is_some_and(|left| left.is_some() == copies)
            && between.iter().all(|inst| match *inst {
                Inst::Constant { dst, .. } | Inst::Compute { dst, .. } | Inst::Load { dst, .. } | Inst::Parameter { dst, .. } => {
                    is_own(dst)
                }
                Inst::Require { code, .. } => code & NOTED != 0,
                Inst::Open { .. } | Inst::Branch { .. } => true,
                _ => false,
            })
    }

    /// The first of some instructions that is a branch, if there is one. `None` = it does something else than to leave the statement where
    /// a condition does not hold that is looked at in front of them.
    fn leaving_branch(&self, mut between: Range<u32>, condition: Var) -> Option<Option<u32>> {
        let insts = &self.native().code.insts;
        let is_branch = |index: &u32| matches!(insts[*index as usize], Inst::Branch { .. });
        let Some(branch) = between.clone().find(is_branch) else { return Some(None) };
        let negates = |inst: &Inst, by: Var| matches!(*inst, Inst::Compute { op: Op::Not, dst, args } if dst == by && args[0] == condition);
        let leaves = match insts[branch as usize - 1..=branch as usize] {
            [ref before, Inst::Branch { condition: by, to }] => {
                between.contains(&(branch - 1)) && negates(before, by) && to.0 == self.statement + 1
            }
            _ => false,
        };
        between.end = branch.saturating_sub(1);
        let stays = || between.clone().all(|index| sieben_engine::ir::verify::writes(&insts[index as usize]) != Some(condition));
        (leaves && stays()).then_some(Some(branch))
    }

    /// Whether the last instruction of a statement, in front of `end`, jumps where the branch in front of it does not.
    fn ends_with_jump(&self, end: u32) -> bool {
        let before = &self.native().code.insts[..end as usize];
        matches!(before, [.., Inst::Branch { .. }, Inst::Jump { .. }])
    }

    /// Ends a way of the running statement.
    fn go_to_meeting(&mut self) {
        let Some(Meeting { block, condition, taken, opened, .. }) = self.meeting else { return };
        let value = condition.map(|(condition, negated)| {
            let value = self.get(condition);
            let value = if negated { self.not(value) } else { value };
            self.flag(value)
        });
        self.define_variables(opened);
        self.store_waiting();
        self.take_from_budget(self.taken - taken);
        let arguments: Vec<BlockArg> = value.into_iter().map(BlockArg::Value).collect();
        self.b.ins().jump(block, &arguments);
        let (dirty, memory) = (self.dirty, self.known_memory_here());
        let of_opened = Register::ALL.iter().filter(|&&register| opened & bit_of(register) != 0);
        let constants = of_opened.filter_map(|&register| {
            let value = self.current[register as usize]?;
            value.constant().map(|_| (register, value))
        });
        let constants: Vec<_> = constants.collect();
        if let Some(meeting) = &mut self.meeting {
            meeting.dirty |= dirty;
            match &mut meeting.known {
                Some(known) => known.retain(|it| constants.contains(it)),
                None => meeting.known = Some(constants),
            }
            // Each way writes where its own index leads.
            meeting.memory.keep_common(&memory);
        }
    }

    /// Leaves a statement in front of its end where a condition holds, if its ways have parted; whether they have.
    pub(super) fn leave_for_meeting(&mut self, index: u32, condition: Val) -> bool {
        if self.meeting.as_ref().is_none_or(|it| index >= it.last) {
            return false;
        }
        if condition.constant().is_some_and(|value| value & 1 == 0) {
            return true;
        }
        let condition = self.flag(condition);
        let [leaving, staying] = [self.b.create_block(), self.b.create_block()];
        self.b.ins().brif(condition, leaving, &[], staying, &[]);
        self.b.switch_to_block(leaving);
        self.b.seal_block(leaving);
        let parting = self.parting();
        self.go_to_meeting();
        self.go_back_to(parting);
        self.b.switch_to_block(staying);
        self.b.seal_block(staying);
        true
    }

    /// Lets the ways of the statement meet, in front of its branch.
    pub(super) fn meet_in_front(&mut self, index: u32) {
        if self.cold.is_none() && self.meeting.as_ref().is_some_and(|it| it.last == index && it.condition.is_some()) {
            self.meet();
        }
    }

    /// Lets the ways of the statement meet, behind what it writes.
    pub(super) fn meet_behind(&mut self, index: u32) {
        if self.cold.is_none() && self.meeting.as_ref().is_some_and(|it| it.last == index && it.condition.is_none()) {
            self.meet();
        }
    }

    fn meet(&mut self) {
        self.go_to_meeting();
        let Some(Meeting { block, condition, dirty, memory, opened, known, .. }) = self.meeting.take() else { return };
        self.know_memory(memory);
        for &register in Register::ALL.iter().filter(|&&register| opened & bit_of(register) != 0) {
            let known = known.iter().flatten().find(|(other, _)| *other == register);
            self.current[register as usize] = known.map(|&(_, value)| value);
        }
        self.b.switch_to_block(block);
        self.b.seal_block(block);
        self.dirty = dirty;
        if let Some((condition, negated)) = condition {
            let value = Val::Bit { value: self.b.block_params(block)[0], clean: true };
            let value = if negated { self.not(value) } else { value };
            self.set(condition, value);
        }
    }

    /// Whether nobody needs what a load reads, because a choice behind a look at an index has been made.
    pub(super) fn is_needless(&mut self, index: u32, dst: Var) -> bool {
        if !self.options.optimize || dst.register().is_some() {
            return false;
        }
        let code = &self.native().code;
        let end = code.statements.get(self.statement as usize + 1).copied().unwrap_or(code.insts.len() as u32);
        let seen = end.min(index + 1 + REST_MAX as u32);
        // What a temporary holds here is not what it holds there, if it is written in between.
        let mut written = vec![dst];
        for inst in &code.insts[index as usize + 1..seen as usize] {
            let needed = match *inst {
                Inst::Compute { op: Op::Select, args: [condition, a, b, _], .. } => {
                    let stays = condition.register().is_none() && !written.contains(&condition);
                    let known = if stays { self.get(condition).constant() } else { None };
                    match known {
                        Some(condition) => dst == if condition & 1 != 0 { a } else { b },
                        None => [condition, a, b].contains(&dst),
                    }
                }
                _ => sieben_engine::ir::verify::reads(inst).any(|var| var == dst),
            };
            if needed {
                return false;
            }
            match sieben_engine::ir::verify::writes(inst) {
                Some(var) if var == dst => return true,
                Some(var) => written.push(var),
                None => {}
            }
        }
        seen == end
    }

    /// Whether an access is known to stay inside its area.
    pub(super) fn is_there(&self, index: u32, place: Place, width: Width) -> bool {
        self.ranges.inside(index).is_some() || self.constant_address(place, width).is_some()
    }
}
