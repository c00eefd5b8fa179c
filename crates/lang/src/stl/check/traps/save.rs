//! SAVE of a diagram as the last coil of a rung: it does not end the string of logic, so that what follows is combined with its line.

use sieben_engine::machine::Register;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use crate::stl::instructions::{Effect, Instruction as I, STATUS_COLUMNS};
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::Operand;

/// Reports each SAVE of a diagram after which a contact goes on with its line.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    let statements = &block.statements;
    for (index, save) in statements.iter().enumerate() {
        if save.instruction != I::Save || save.origin.element().is_none() {
            continue;
        }
        let decides = |one: &&Statement| touches_first_check(one.instruction) || matches!(one.operand, Operand::Label(_));
        let next = statements[index + 1..].iter().find(decides);
        let Some(next) = next.filter(|next| is_check(next.instruction)) else { continue };
        let (own, other) = (save.origin.network(), next.origin.network());
        // The line of SAVE is the tapped one, and the next branch begins with it anyway.
        if own == other && tapped_alone(&statements[..index]).is_some_and(|tap| tap.operand == next.operand) {
            continue;
        }
        let (what, help) = match own == other {
            true => ("the next branch".to_owned(), "Put this branch last, or a coil below SAVE: that ends the line."),
            false => (format!("the logic of network {other}"), "Put a coil below SAVE, that ends the line; or SAVE into the last network."),
        };
        let effect = match next.instruction.english().as_bytes().first() {
            Some(b'A') => "is 0 whenever that line is 0",
            Some(b'O') => "is 1 whenever that line is 1",
            _ => "depends on that line",
        };
        let message = format!("network {own}: SAVE does not end its line, so that {what} is combined with it and {effect}");
        diagnostics.push(Diagnostic::new(Problem::P2412, save.span(), message).related(next.span(), "combined here").help(help));
    }
}

/// The statement before the end that reads a tapped line which is the whole line of a coil.
fn tapped_alone(before: &[Statement]) -> Option<&Statement> {
    match before {
        [.., tap, mark] if mark.instruction == I::Blank && tap.instruction == I::And => Some(tap),
        _ => None,
    }
}

fn touches_first_check(instruction: I) -> bool {
    let column = STATUS_COLUMNS.iter().position(|&register| register == Register::Fc);
    column.is_none_or(|column| instruction.status()[column] != Effect::Unaffected)
}

/// Whether an instruction combines a value with the RLO, or begins to.
fn is_check(instruction: I) -> bool {
    matches!(instruction.english(), "A" | "AN" | "O" | "ON" | "X" | "XN" | "A(" | "AN(" | "O(" | "ON(" | "X(" | "XN(")
}
