//! Natural loops: statements that are entered at their first one only and jump back to it.

use sieben_engine::access::data_registers;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Callee, Code, Inst, Target, Var};
use sieben_model::block::BlockKind;

use super::bit_of;
use super::status_liveness::{ALL, restored};
use crate::jit::jumps_back;

/// Blocks with more loops get no analysis of them: it takes time that grows with the number of loops times that of jumps.
const LOOPS_MAX: usize = 400;

/// A loop.
#[derive(Clone, Debug)]
pub(super) struct NaturalLoop {
    /// Its first statement, where it is entered and where it begins again.
    pub(super) first: u32,
    /// Its last statement, the last one that jumps back.
    pub(super) last: u32,
    /// Registers that may hold something else behind an iteration than before it.
    pub(super) written: u32,
    /// Registers that its statements may change, though they may be as before behind the iteration.
    pub(super) touched: u32,
    /// Whether its statements call no Rust code.
    pub(super) asks_nothing: bool,
    /// Whether they call none but for texts.
    pub(super) asks_for_texts: bool,
    /// Whether they call no blocks either.
    pub(super) calls_nothing: bool,
}

impl NaturalLoop {
    /// Whether a statement is part of it.
    pub(super) fn contains(&self, statement: u32) -> bool {
        (self.first..=self.last).contains(&statement)
    }
}

/// Statements to which an instruction may jump.
pub(crate) fn targets<'a>(code: &'a Code, inst: &Inst) -> impl Iterator<Item = u32> + use<'a> {
    let (one, table): (Option<Target>, &[Target]) = match *inst {
        Inst::Jump { to } | Inst::Branch { to, .. } => (Some(to), &[]),
        Inst::JumpTable { first, count, otherwise, .. } => {
            (Some(otherwise), code.tables.get(first as usize..(first + count) as usize).unwrap_or(&[]))
        }
        _ => (None, &[]),
    };
    one.into_iter().chain(table.iter().copied()).map(|Target(to)| to)
}

/// The last of some instructions that writes a variable, and its place among them.
pub(crate) fn made_by(insts: &[Inst], var: Var) -> Option<(usize, Inst)> {
    let at = insts.iter().rposition(|inst| sieben_engine::ir::verify::writes(inst) == Some(var))?;
    Some((at, insts[at]))
}

/// How many instructions of a block are between no jump back and where it leads.
pub(super) fn instructions_beside(code: &Code) -> usize {
    let mut ends = vec![0; code.statement_count() + 1];
    for (from, to) in jumps_back(code) {
        ends[to as usize] = ends[to as usize].max(from + 1);
    }
    let mut end = 0;
    let is_beside = |&statement: &usize| {
        end = end.max(ends[statement]);
        statement >= end
    };
    (0..code.statement_count()).filter(is_beside).map(|statement| code.statement(statement).len()).sum()
}

/// Registers that an instruction may change. What a block changes that a call restores is as before behind it.
pub(super) fn written(inst: &Inst) -> u32 {
    let register = |var: Var| var.register().map_or(0, bit_of);
    sieben_engine::ir::verify::writes(inst).map_or(0, register)
        | match inst {
            Inst::Call { callee: Callee::Block(id), .. } if matches!(id.kind, BlockKind::Function | BlockKind::FunctionBlock) => {
                ALL & !restored()
            }
            Inst::Call { .. } => ALL,
            Inst::Open { register, .. } => data_registers(*register).into_iter().fold(0, |all, register| all | bit_of(register)),
            _ => 0,
        }
}

/// The loops of a block; of two that share statements one is part of the other. What is entered in the middle is none.
///
/// Each statement leaves the registers `kept` as they were; it is asked for where there is a loop.
pub(super) fn find(code: &Code, kept: impl FnOnce() -> u32) -> Vec<NaturalLoop> {
    let mut jumps = Vec::new();
    let mut loops: Vec<NaturalLoop> = Vec::new();
    for statement in 0..code.statement_count() as u32 {
        for to in code.statement(statement as usize).iter().flat_map(|inst| targets(code, inst)) {
            jumps.push((statement, to));
            if to > statement {
                continue;
            }
            match loops.iter().position(|known| known.first == to) {
                Some(known) => loops[known].last = statement,
                None if loops.len() == LOOPS_MAX => return Vec::new(),
                None => loops.push(NaturalLoop {
                    first: to,
                    last: statement,
                    written: 0,
                    touched: 0,
                    asks_nothing: true,
                    asks_for_texts: true,
                    calls_nothing: true,
                }),
            }
        }
    }
    loops.retain(|it| !jumps.iter().any(|&(from, to)| !it.contains(from) && it.contains(to) && to != it.first));
    let kept = if loops.is_empty() { 0 } else { kept() };
    for it in &mut loops {
        for inst in (it.first..=it.last).flat_map(|statement| code.statement(statement as usize)) {
            it.touched |= written(inst);
            it.asks_for_texts &= !matches!(inst, Inst::Intrinsic { intrinsic, .. } if *intrinsic != Intrinsic::Clock);
            it.asks_nothing &= it.asks_for_texts && !matches!(inst, Inst::Text { .. });
            it.calls_nothing &= it.asks_nothing && !matches!(inst, Inst::Call { .. });
        }
        it.written = it.touched & !kept;
    }
    loops
}
