//! Blocks that a test may mock ask first whether their statements are left out.

use std::collections::BTreeSet;

use sieben_engine::ir::{Callee, Code, Inst, OnFault, Place, Target, Var};
use sieben_engine::{CodeBlock, Program};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::testing::{MOCKED, TestPlan};

use crate::calling::pointers::CALLER_LOCAL;

/// Lets every block that the words of the plan name ask the CPU before its first statement, in one more statement. It leaves all registers
/// as they are. The blocks that ask are returned.
pub(crate) fn prepare(program: &mut Program, plan: &TestPlan) -> BTreeSet<BlockId> {
    let mut named: BTreeSet<BlockId> = plan.words.values().filter_map(|call| Some(call.mocked.as_ref()?.0)).collect();
    // System functions are asked about where they are called.
    named.retain(|block| program.code.get_mut(block).and_then(ask_first).is_some());
    named
}

fn ask_first(block: &mut CodeBlock) -> Option<()> {
    let end = block.code.statement_count().checked_sub(1)?;
    let (pointer, answer) = Var::temporary(0).zip(Var::temporary(1))?;
    // The answer lies behind the local data of the block.
    let position = block.local_size * 8;
    block.local_size += 2;
    let behind = |target: Target| Target(target.0 + 1);
    let question = [
        Inst::Constant { dst: pointer, value: u64::from(CALLER_LOCAL + position) },
        Inst::PassParameter { src: pointer },
        Inst::Call { callee: Callee::Block(MOCKED), parameters: 1 },
        Inst::Load { dst: answer, place: Place::Fixed { area: Area::Local, position }, width: Width::Byte, on_fault: OnFault::DeliverZero },
        Inst::Branch { condition: answer, to: Target(end as u32 + 1) },
    ];
    let old = std::mem::take(&mut block.code);
    let mut insts = question.to_vec();
    insts.extend(old.insts.into_iter().map(|inst| match inst {
        Inst::Jump { to } => Inst::Jump { to: behind(to) },
        Inst::Branch { condition, to } => Inst::Branch { condition, to: behind(to) },
        Inst::JumpTable { index, first, count, otherwise } => Inst::JumpTable { index, first, count, otherwise: behind(otherwise) },
        other => other,
    }));
    let first = question.len() as u32;
    let statements = [0].into_iter().chain(old.statements.into_iter().map(|at| at + first)).collect();
    block.code = Code { insts, statements, tables: old.tables.into_iter().map(behind).collect() };
    let place = block.spans.first().copied().unwrap_or_default();
    block.spans.insert(0, place);
    Some(())
}
