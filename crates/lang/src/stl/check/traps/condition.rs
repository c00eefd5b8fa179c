//! A condition before `L` or `T` that does not guard them: both run whatever the RLO is.

use std::collections::HashSet;

use sieben_engine::machine::Register;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::super::flow;
use super::moves;
use crate::stl::instructions::{Effect, Instruction as I, STATUS_COLUMNS};
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::OperandClass;

/// Reports conditions whose RLO nothing uses, or only another condition after values were stored.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    let statements = &block.statements;
    let Some(used_after) = used_after(statements) else { return };
    let targets = jumped_to(statements);
    let mut index = 0;
    while index < statements.len() {
        // The condition ends where the first value is loaded or stored.
        let guarded = index + 1;
        if !ends_condition(statements, index) || !statements.get(guarded).is_some_and(|next| moves(next.instruction)) {
            index += 1;
            continue;
        }
        let end = (guarded..statements.len()).find(|&at| !keeps_rlo(statements[at].instruction)).unwrap_or(statements.len());
        let straight = !(guarded..=end).any(|at| targets.contains(&at));
        let stores = statements[guarded..end].iter().any(|one| one.instruction == I::Transfer);
        let continued = straight && stores && statements.get(end).is_some_and(|one| begins_condition(one.instruction));
        if straight && (continued || !used_after[index]) {
            let word = statements[guarded].instruction.english();
            let why = match statements.get(end).filter(|_| continued) {
                Some(_) => "the condition before it goes on in the next one, and nothing else uses it",
                None => "nothing uses the condition before it",
            };
            let message = format!("`{word}` runs whatever the RLO is: {why}");
            let condition = statements[index].span();
            let mut diagnostic = Diagnostic::new(Problem::P5021, statements[guarded].span(), message).related(condition, "the condition");
            if let Some(next) = statements.get(end).filter(|_| continued) {
                diagnostic = diagnostic.related(next.span(), "combined with it here");
            }
            diagnostics.push(diagnostic);
        }
        index = end.max(index + 1);
    }
}

/// Whether the condition of a logic string ends with this statement: a scan of a bit, or the end of brackets.
fn ends_condition(statements: &[Statement], index: usize) -> bool {
    matches!(statements[index].instruction, I::And | I::AndNot | I::Or | I::OrNot | I::Xor | I::XorNot | I::CloseBracket)
}

/// Whether a condition may begin with this instruction.
fn begins_condition(instruction: I) -> bool {
    matches!(
        instruction,
        I::And
            | I::AndNot
            | I::Or
            | I::OrNot
            | I::Xor
            | I::XorNot
            | I::AndOpen
            | I::AndNotOpen
            | I::OrOpen
            | I::OrNotOpen
            | I::XorOpen
            | I::XorNotOpen
    )
}

/// Where jumps lead.
fn jumped_to(statements: &[Statement]) -> HashSet<usize> {
    let label = |one: &Statement| match one.operand {
        crate::stl::operands::Operand::Label(target) => Some(target as usize),
        _ => None,
    };
    statements.iter().filter_map(label).collect()
}

fn effect(instruction: I, register: Register) -> Effect {
    let column = STATUS_COLUMNS.iter().position(|&one| one == register);
    column.map_or(Effect::Unaffected, |column| instruction.status()[column])
}

/// Whether an instruction neither reads nor changes the RLO and the first check.
fn keeps_rlo(instruction: I) -> bool {
    effect(instruction, Register::Rlo) == Effect::Unaffected
        && effect(instruction, Register::Fc) == Effect::Unaffected
        && !reads_rlo(instruction)
        && !matches!(instruction.operand(), OperandClass::Label)
}

/// Whether what an instruction does depends on the RLO. Scans of bits do if they are not the first of their logic string.
fn reads_rlo(instruction: I) -> bool {
    match instruction {
        I::SetRlo | I::ClearRlo | I::TransferStatusWord => false,
        I::Not | I::Save | I::LoadStatusWord | I::Call | I::CallUnconditional | I::Extension => true,
        // Comparisons put their result in the place of what was there.
        one if effect(one, Register::Fc) == Effect::SetTo1 && one.operand() == OperandClass::None && one != I::CloseBracket => false,
        I::BlockEnd | I::BlockEndUnconditional | I::JumpIfBr | I::JumpIfNotBr => false,
        one => effect(one, Register::Fc) != Effect::Unaffected || effect(one, Register::Rlo) != Effect::Unaffected,
    }
}

/// Whether something may use the RLO that each statement leaves; `None` if the paths cannot be followed.
fn used_after(statements: &[Statement]) -> Option<Vec<bool>> {
    // Whether a logic string may be under way before each statement: its next scan combines with the RLO.
    let under_way = |index: usize, before: &bool| match effect(statements[index].instruction, Register::Fc) {
        Effect::Unaffected => *before,
        Effect::Cleared => false,
        Effect::SetTo1 | Effect::Written => true,
    };
    let join = |known: &mut bool, more: &bool| !std::mem::replace(known, *known || *more) && *more;
    let strings = flow::states(statements, false, under_way, join);
    let mut live_before = vec![false; statements.len()];
    let mut live_after = vec![false; statements.len()];
    // Backwards until nothing changes: most programs only jump forward and need two rounds.
    for _ in 0..ROUNDS_MAX {
        let mut changed = false;
        for index in (0..statements.len()).rev() {
            let instruction = statements[index].instruction;
            live_after[index] = flow::successors(statements, index).iter().any(|&next| live_before[next]);
            let scan = begins_condition(instruction);
            // Where no path leads, nothing is judged.
            let reads = reads_rlo(instruction) && (!scan || strings[index] != Some(false));
            let before = reads
                || (live_after[index]
                    && (scan || effect(instruction, Register::Rlo) == Effect::Unaffected)
                    && !(scan && strings[index] == Some(false)));
            changed |= before != live_before[index];
            live_before[index] = before;
        }
        if !changed {
            return Some(live_after);
        }
    }
    None
}

/// Rounds over a block until what is used stands still.
const ROUNDS_MAX: usize = 16;
