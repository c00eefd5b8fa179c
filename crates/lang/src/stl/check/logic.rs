//! Timers and counters that no logic drives: the RLO of a priority class begins with 0.

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::flow;
use crate::stl::instructions::{Effect, Instruction, STATUS_COLUMNS};
use crate::stl::lower::ResolvedBlock;
use crate::stl::operands::OperandClass;
use sieben_engine::machine::Register;

/// Reports timers and counters in an organization block before which nothing can have changed the RLO.
///
/// Other blocks get the RLO of their caller, which may mean it.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    if block.id.kind != BlockKind::OrganizationBlock {
        return;
    }
    let driven = |instruction: Instruction| matches!(instruction.operand(), OperandClass::Timer | OperandClass::Counter);
    if !block.statements.iter().any(|statement| driven(statement.instruction)) {
        return;
    }
    let step = |index: usize, set: &bool| *set || sets_rlo(block.statements[index].instruction);
    let join = |known: &mut bool, more: &bool| !std::mem::replace(known, *known || *more) && *more;
    let states = flow::states(&block.statements, false, step, join);
    for (statement, state) in block.statements.iter().zip(states) {
        if state == Some(false) && driven(statement.instruction) {
            let message = format!(
                "nothing has set the RLO before `{}`: it is 0 here, and this statement never does anything",
                statement.instruction.english()
            );
            diagnostics.push(Diagnostic::new(Problem::P4023, statement.span(), message));
        }
    }
}

/// Whether the RLO behind an instruction may be another one than before it.
fn sets_rlo(instruction: Instruction) -> bool {
    let called = matches!(instruction, Instruction::Call | Instruction::CallUnconditional);
    let column = STATUS_COLUMNS.iter().position(|&register| register == Register::Rlo);
    called || column.is_some_and(|column| instruction.status()[column] != Effect::Unaffected)
}
