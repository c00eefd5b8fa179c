//! A zone of the master control relay that is never active: `MCR(` without `MCRA`.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::super::flow;
use crate::stl::instructions::Instruction as I;
use crate::stl::lower::ResolvedBlock;

/// Reports zones in which no path has activated the relay. Each block begins without it, whatever its caller did.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    let statements = &block.statements;
    if !statements.iter().any(|one| one.instruction == I::McrOpen) {
        return;
    }
    let step = |index: usize, active: &bool| match statements[index].instruction {
        I::McrActivate => true,
        I::McrDeactivate => false,
        _ => *active,
    };
    let join = |known: &mut bool, more: &bool| !std::mem::replace(known, *known || *more) && *more;
    let states = flow::states(statements, false, step, join);
    for (index, statement) in statements.iter().enumerate() {
        if statement.instruction != I::McrOpen || states[index] != Some(false) {
            continue;
        }
        let mut depth = 0;
        let inside = statements[index..].iter().take_while(|one| {
            depth += i32::from(one.instruction == I::McrOpen) - i32::from(one.instruction == I::McrClose);
            depth > 0
        });
        if inside.into_iter().all(|one| one.instruction != I::McrActivate) {
            let message = "this zone has no effect: no `MCRA` comes before it in this block".to_owned();
            diagnostics.push(Diagnostic::new(Problem::P5023, statement.span(), message));
        }
    }
}
