//! Pointers: AR1 that an access overwrites, and parameters where STEP 7 takes only other places.

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::super::flow;
use super::touched;
use crate::stl::instructions::Instruction as I;
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::{AddressRegister, Location, Operand};

/// Reports them.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    overwritten(&block.statements, diagnostics);
    for statement in &block.statements {
        from_parameter(block, statement, diagnostics);
        address_of_parameter(statement, diagnostics);
    }
}

/// What AR1 holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ar1 {
    /// Anything.
    Unknown,
    /// What the program loaded.
    Loaded,
    /// What this statement left there, after the program had loaded it.
    Overwritten(usize),
}

/// AR1 is used after an access to a complex parameter, which goes through it.
fn overwritten(statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) {
    let step = |index: usize, before: &Ar1| {
        let statement = &statements[index];
        match statement.instruction {
            I::LoadAr1 | I::LoadAr1From => Ar1::Loaded,
            I::SwapAr => Ar1::Unknown,
            _ if goes_through_ar1(statement) && *before == Ar1::Loaded => Ar1::Overwritten(index),
            _ => *before,
        }
    };
    let join = |known: &mut Ar1, more: &Ar1| {
        let before = *known;
        if let (Ar1::Overwritten(_), Ar1::Overwritten(_)) = (before, *more) {
            return false;
        }
        *known = if before == *more { before } else { Ar1::Unknown };
        before != *known
    };
    let states = flow::states(statements, Ar1::Unknown, step, join);
    let mut reported = Vec::new();
    for (index, statement) in statements.iter().enumerate() {
        let Some(Ar1::Overwritten(by)) = states[index] else { continue };
        if !uses_ar1(statement) || reported.contains(&by) {
            continue;
        }
        reported.push(by);
        let message =
            "the access to a parameter that is a structure, an array or a string overwrites AR1, which is used again later".to_owned();
        diagnostics.push(Diagnostic::new(Problem::P5025, statements[by].span(), message).related(statement.span(), "used here"));
    }
}

/// Whether a statement reaches its variable through a pointer that the caller gave, for which it loads AR1.
fn goes_through_ar1(statement: &Statement) -> bool {
    let complex = |location: &Location| matches!(location, Location::Parameter { complex: true, .. } | Location::InstancePointer { .. });
    matches!(&statement.operand, Operand::Memory(access) if complex(&access.location))
}

/// Whether a statement uses what AR1 holds.
fn uses_ar1(statement: &Statement) -> bool {
    let indirect = |location: &Location| matches!(location, Location::RegisterIndirect { register: AddressRegister::Ar1, .. });
    matches!(statement.instruction, I::TransferAr1 | I::TransferAr1To | I::AddAr1)
        || touched(statement).iter().any(|one| indirect(one.location))
}

/// A parameter of a function block in the brackets of an indirect address.
fn from_parameter(block: &ResolvedBlock, statement: &Statement, diagnostics: &mut Vec<Diagnostic>) {
    let found = touched(statement).into_iter().filter(|one| one.as_pointer).find_map(|one| parameter_at(&block.interface, one.location));
    if let Some(parameter) = found.filter(|_| block.id.kind == BlockKind::FunctionBlock) {
        let name = &parameter.name;
        let message = format!("`#{name}` is a parameter, and STEP 7 takes none in the brackets of an indirect address");
        diagnostics.push(Diagnostic::new(Problem::P5026, statement.span(), message));
    }
}

/// The parameter of a function block that lies there. One of the types TIMER, COUNTER and BLOCK_x is a number by itself and needs no brackets.
fn parameter_at<'i>(interface: &'i Interface, location: &Location) -> Option<&'i Variable> {
    let Location::Instance { position } = location else { return None };
    let number = |data_type: &DataType| {
        matches!(
            data_type,
            DataType::Timer
                | DataType::Counter
                | DataType::BlockFunction
                | DataType::BlockFunctionBlock
                | DataType::BlockData
                | DataType::BlockSystemData
        )
    };
    let of_caller = |one: &&Variable| matches!(one.section, Section::Input | Section::Output | Section::InOut);
    let parameter = interface.variables.iter().filter(of_caller).find(|one| one.offset == *position)?;
    (!number(&parameter.data_type)).then_some(parameter)
}

/// `LAR1 P##p` with a parameter of a function.
fn address_of_parameter(statement: &Statement, diagnostics: &mut Vec<Diagnostic>) {
    if let (I::LoadAr1From | I::LoadAr2From, Operand::ParameterAddress(_)) = (statement.instruction, &statement.operand) {
        let register = statement.instruction.english();
        let message = format!("STEP 7 does not take the address of a parameter of a function with `{register}`");
        let help = format!("Write `L P##…` with the parameter, then `{register}` without an operand.");
        diagnostics.push(Diagnostic::new(Problem::P5027, statement.span(), message).help(help));
    }
}
