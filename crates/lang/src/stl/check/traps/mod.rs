//! Traps: statements that are allowed and do something else than they seem to. Each warning needs a block in which nothing speaks for the program.

mod condition;
mod input;
mod instance;
mod pointer;
mod relay;
mod save;
mod timer;
mod toggle;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;

use crate::stl::instructions::Instruction;
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::{Actual, Call, CallInstance, Direction, Location, NumberOperand, Operand};

/// Reports the traps of a block whose statements were all understood.
pub(super) fn check(block: &ResolvedBlock, extended: bool, diagnostics: &mut Vec<Diagnostic>) {
    condition::check(block, diagnostics);
    toggle::check(block, diagnostics);
    timer::check(block, diagnostics);
    relay::check(block, diagnostics);
    save::check(block, diagnostics);
    instance::check(block, diagnostics);
    pointer::check(block, diagnostics);
    // Extended programs test themselves: they give their inputs their values.
    if !extended {
        input::check(block, diagnostics);
    }
}

/// A place that a statement uses.
struct Touched<'s> {
    location: &'s Location,
    direction: Direction,
    /// The place holds the address or the number of what is used.
    as_pointer: bool,
}

/// The places that a statement uses, in the order of its operands.
fn touched(statement: &Statement) -> Vec<Touched<'_>> {
    let mut places = Vec::new();
    match &statement.operand {
        Operand::Memory(access) => place(&access.location, statement.instruction.direction().unwrap_or(Direction::Read), &mut places),
        Operand::Timer(number) | Operand::Counter(number) => number_place(number, &mut places),
        Operand::Block(block) => number_place(&block.number, &mut places),
        Operand::Call(call) => actuals(call, &mut places),
        _ => {}
    }
    places
}

fn actuals<'s>(call: &'s Call, places: &mut Vec<Touched<'s>>) {
    for parameter in &call.parameters {
        match &parameter.actual {
            Some(Actual::Memory(access)) => place(&access.location, Direction::of_parameter(parameter.section), places),
            Some(Actual::Complex { location, .. }) => {
                // A pointer goes to the block, whatever it does with it.
                let direction = if parameter.section == Section::Input { Direction::Read } else { Direction::ReadWrite };
                place(location, direction, places);
            }
            Some(Actual::Timer(number) | Actual::Counter(number) | Actual::Block(number)) => number_place(number, places),
            Some(Actual::Constant(_)) | None => {}
        }
    }
}

fn place<'s>(location: &'s Location, direction: Direction, places: &mut Vec<Touched<'s>>) {
    if let Location::MemoryIndirect { pointer, .. } = location {
        places.push(Touched { location: pointer, direction: Direction::Read, as_pointer: true });
    }
    places.push(Touched { location, direction, as_pointer: false });
}

fn number_place<'s>(number: &'s NumberOperand, places: &mut Vec<Touched<'s>>) {
    if let NumberOperand::Indirect(location) = number {
        places.push(Touched { location, direction: Direction::Read, as_pointer: true });
    }
}

/// Whether a statement calls a multi-instance.
fn calls_multi_instance(statement: &Statement) -> bool {
    matches!(&statement.operand, Operand::Call(call) if matches!(call.instance, Some(CallInstance::Multi(_))))
}

/// Whether an instruction loads or stores a value, whatever the RLO is.
fn moves(instruction: Instruction) -> bool {
    matches!(
        instruction,
        Instruction::Load | Instruction::LoadStatusWord | Instruction::LoadDataBlockInfo | Instruction::LoadBcd | Instruction::Transfer
    )
}
