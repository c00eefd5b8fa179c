//! Interprocedural liveness of registers and status bits: calls pass on only what is live, and status bits that are dead are not computed.

use sieben_engine::ir::{Callee, Code, Inst, OnFault, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_model::block::BlockKind;

use super::{AFTER_CALL, Find, OPEN_BLOCKS, bit_of};
use crate::jit::Native;

/// Rounds over a program or a block after which everything counts as needed.
const ROUNDS_MAX: usize = 24;

/// All registers.
pub(super) const ALL: u32 = (1 << Register::COUNT) - 1;

/// Status bits that need not be calculated where no statement reads them.
pub(super) const SPARED: u32 = bit_of(Register::Fc)
    | bit_of(Register::Sta)
    | bit_of(Register::Or)
    | bit_of(Register::Os)
    | bit_of(Register::Ov)
    | bit_of(Register::Cc0)
    | bit_of(Register::Cc1);

/// What a call restores or sets, whatever the block did.
pub(super) fn set_by_calls() -> u32 {
    AFTER_CALL.iter().fold(restored(), |all, &(register, _)| all | bit_of(register))
}

/// What a call restores, whatever the block did.
pub(super) fn restored() -> u32 {
    super::inlining::RESTORED.iter().fold(0, |all, &register| all | bit_of(register))
}

/// The data block registers.
pub(super) fn open_blocks() -> u32 {
    OPEN_BLOCKS.iter().fold(0, |all, &register| all | bit_of(register))
}

/// What is known of a block.
#[derive(Clone, Debug)]
pub(super) struct Summary {
    /// Of [`SPARED`], what is needed at the beginning of each statement.
    pub(super) live: Vec<u32>,
    /// Instructions that only calculate a bit which nobody needs.
    pub(super) needless: Vec<bool>,
    /// Of [`SPARED`], what somebody needs when the block ends.
    pub(super) live_out: u32,
    /// What the block and those that it calls may change for their caller.
    pub(super) written: u32,
}

impl Summary {
    /// What is needed when the block begins.
    pub(super) fn live_in(&self) -> u32 {
        self.live.first().copied().unwrap_or(0)
    }
}

/// Reads and writes of an instruction, as registers.
#[derive(Clone, Copy)]
pub(super) struct Effect {
    pub(super) reads: u32,
    writes: u32,
    /// The statement may count as NOP from here.
    pub(super) fails: bool,
}

/// Summaries of all blocks. With `exact` every status bit is needed everywhere.
pub(super) fn summaries(blocks: &[Native], find: Find<'_>, exact: bool) -> Vec<Summary> {
    let callee = |callee: &Callee| match callee {
        Callee::Block(id) => find(*id).map(|code| code as usize),
        Callee::Number(..) => None,
    };
    let calls_by_number =
        blocks.iter().any(|block| block.code.insts.iter().any(|inst| matches!(inst, Inst::Call { callee: Callee::Number(..), .. })));
    let mut all: Vec<Summary> = blocks
        .iter()
        .map(|block| {
            // A computed call may come from anywhere.
            let everything = exact || calls_by_number && block.id.kind != BlockKind::OrganizationBlock;
            Summary {
                live: vec![if exact { SPARED } else { 0 }; block.code.statement_count()],
                needless: vec![false; block.code.insts.len()],
                live_out: if everything { SPARED } else { 0 },
                written: 0,
            }
        })
        .collect();
    let effects: Vec<Vec<Effect>> = blocks.iter().map(|block| block.code.insts.iter().map(effect).collect()).collect();
    // Sets only grow, so that this ends; mostly after three rounds. A program made to take many is not worth them.
    for _ in 0..ROUNDS_MAX {
        let mut changed = false;
        for (index, block) in blocks.iter().enumerate().rev() {
            changed |= written(&mut all, index, block, &effects[index], &callee);
            if !exact {
                changed |= live(&mut all, index, &block.code, &effects[index], &callee);
            }
        }
        if !changed {
            return all;
        }
    }
    for summary in &mut all {
        summary.live.fill(SPARED);
        summary.needless.fill(false);
        (summary.live_out, summary.written) = (SPARED, ALL);
    }
    all
}

/// Brings what a block writes up to date; whether that changed it.
fn written(all: &mut [Summary], index: usize, block: &Native, effects: &[Effect], callee: &dyn Fn(&Callee) -> Option<usize>) -> bool {
    let mut registers = all[index].written;
    for (inst, effect) in block.code.insts.iter().zip(effects) {
        registers |= effect.writes;
        if let Inst::Call { callee: called, .. } = inst {
            registers |= callee(called).map_or(ALL, |code| all[code].written | set_by_calls());
        }
    }
    std::mem::replace(&mut all[index].written, registers) != registers
}

/// Brings what a block needs up to date; whether that changed anything.
fn live(all: &mut [Summary], index: usize, code: &Code, effects: &[Effect], callee: &dyn Fn(&Callee) -> Option<usize>) -> bool {
    let after_call = AFTER_CALL.iter().fold(0, |all, &(register, _)| all | bit_of(register));
    let mut changed_anything = false;
    for _ in 0..ROUNDS_MAX {
        let mut changed = false;
        let mut needed = all[index].live_out;
        for statement in (0..code.statement_count()).rev() {
            let skipped = all[index].live.get(statement + 1).copied().unwrap_or(all[index].live_out);
            let live_at = |all: &[Summary], Target(to): Target| all[index].live.get(to as usize).copied().unwrap_or(0);
            let first = code.statements[statement] as usize;
            for (at, inst) in code.statement(statement).iter().enumerate().rev() {
                let effect = effects[first + at];
                match inst {
                    Inst::Return => needed = all[index].live_out,
                    Inst::Jump { to } => needed = live_at(all, *to),
                    Inst::Branch { to, .. } => needed |= live_at(all, *to),
                    Inst::JumpTable { first, count, otherwise, .. } => {
                        needed = live_at(all, *otherwise);
                        for &to in &code.tables[*first as usize..(first + count) as usize] {
                            needed |= live_at(all, to);
                        }
                    }
                    Inst::Call { callee: called, .. } => match callee(called) {
                        Some(code) => {
                            let handed_back = needed & !after_call;
                            if all[code].live_out & handed_back != handed_back {
                                all[code].live_out |= handed_back;
                                changed_anything = true;
                            }
                            needed = all[code].live_in() & !after_call;
                        }
                        None => needed = SPARED,
                    },
                    _ => {}
                }
                // What only calculates a bit that nobody needs reads nothing: otherwise OS would keep itself alive in every loop.
                let needless = matches!(inst, Inst::Compute { .. }) && effect.writes & SPARED & !needed != 0;
                all[index].needless[first + at] = needless;
                needed = needed & !effect.writes | if needless { 0 } else { effect.reads & SPARED };
                if effect.fails {
                    needed |= skipped;
                }
            }
            if all[index].live[statement] | needed != all[index].live[statement] {
                all[index].live[statement] |= needed;
                changed = true;
            }
            needed = all[index].live[statement];
        }
        changed_anything |= changed;
        if !changed {
            return changed_anything;
        }
    }
    all[index].live.fill(SPARED);
    all[index].needless.fill(false);
    true
}

pub(super) fn effect(inst: &Inst) -> Effect {
    let register = |var: Var| var.register().map_or(0, bit_of);
    let place = |place: Place| match place {
        Place::Fixed { .. } => 0,
        Place::Indirect { pointer, .. } | Place::Crossing { pointer, .. } => register(pointer),
    };
    let (reads, writes, fails) = match *inst {
        Inst::Constant { dst, .. } | Inst::Parameter { dst, .. } => (0, register(dst), false),
        Inst::Compute { op, dst, args } => (args[..op.arity()].iter().fold(0, |all, &arg| all | register(arg)), register(dst), false),
        Inst::Load { dst, place: from, on_fault, .. } => (place(from), register(dst), on_fault != OnFault::DeliverZero),
        Inst::Store { place: to, src, .. } => (place(to) | register(src), 0, true),
        Inst::Move { from, to, .. } => (place(from) | place(to), 0, true),
        Inst::Text { action, dst, from, to, piece, .. } => {
            let piece = if action.takes_piece() { piece.iter().fold(0, |all, &var| all | register(var)) } else { 0 };
            (place(from) | place(to) | piece, register(dst), true)
        }
        Inst::PassParameter { src } => (register(src), 0, false),
        Inst::Intrinsic { dst, intrinsic, args } => {
            (args[..intrinsic.arity()].iter().fold(0, |all, &arg| all | register(arg)), register(dst), true)
        }
        Inst::Require { condition, register: shown, .. } => (register(condition) | register(shown), 0, true),
        // A hot restart goes on behind the statement that stopped the CPU.
        Inst::RequireStack { condition, .. } => (register(condition), 0, true),
        Inst::Open { number, .. } => (register(number), OPEN_BLOCKS.iter().fold(0, |all, &register| all | bit_of(register)), true),
        Inst::Branch { condition, .. } => (register(condition), 0, false),
        Inst::JumpTable { index, .. } => (register(index), 0, false),
        Inst::Call { callee: Callee::Number(_, number), .. } => (register(number), 0, true),
        Inst::Call { .. } => (0, 0, true),
        Inst::Jump { .. } | Inst::Return => (0, 0, false),
    };
    Effect { reads, writes, fails }
}
