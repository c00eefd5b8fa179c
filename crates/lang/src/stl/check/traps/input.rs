//! Statements that write an input: the CPU reads the inputs anew before each scan.

use sieben_model::address::Area;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::touched;
use crate::stl::lower::ResolvedBlock;
use crate::stl::operands::{Direction, Location, Operand};

/// Reports them.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    for statement in &block.statements {
        let call = matches!(statement.operand, Operand::Call(_));
        // A block that may write what it is given need not.
        let writes = |direction: Direction| direction == Direction::Write || (direction == Direction::ReadWrite && !call);
        let written = touched(statement).iter().any(|one| writes(one.direction) && is_input(one.location));
        if written {
            let message = "an input is written: the CPU reads the inputs anew before the next scan".to_owned();
            diagnostics.push(Diagnostic::new(Problem::P5028, statement.span(), message));
        }
    }
}

fn is_input(location: &Location) -> bool {
    match location {
        Location::Fixed { area, .. } | Location::MemoryIndirect { area, .. } | Location::RegisterIndirect { area: Some(area), .. } => {
            *area == Area::Input
        }
        _ => false,
    }
}
