//! AR2 and the DI register of a function block, through which its parameters and static variables are reached.

use sieben_model::block::BlockKind;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::literal::Value;
use sieben_model::problems::Problem;

use super::super::flow;
use super::{calls_multi_instance, touched};
use crate::stl::instructions::Instruction as I;
use crate::stl::lower::{ResolvedBlock, Statement};
use crate::stl::operands::{BlockOperand, DataBlockInfo, Location, NumberOperand, Operand};

/// The statements that changed AR2 and the DI register for certain; `None`: as they were, or nobody can say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Changed {
    ar2: Option<usize>,
    di: Option<usize>,
}

/// Reports the first access to a parameter or a static variable after AR2 or DI was changed on every path.
pub(super) fn check(block: &ResolvedBlock, diagnostics: &mut Vec<Diagnostic>) {
    if block.id.kind != BlockKind::FunctionBlock {
        return;
    }
    let statements = &block.statements;
    let saves = Saves {
        ar2: statements.iter().any(|one| {
            matches!(one.instruction, I::TransferAr2 | I::TransferAr2To | I::SwapAr) || one.operand == Operand::AddressRegister2
        }),
        di: statements
            .iter()
            .any(|one| one.operand == Operand::DataBlockInfo(DataBlockInfo::InstanceNumber) || one.instruction == I::SwapDataBlocks),
    };
    let step = |index: usize, before: &Changed| after(index, &statements[index], *before, saves);
    let join = |known: &mut Changed, more: &Changed| {
        let before = *known;
        known.ar2 = known.ar2.filter(|_| more.ar2.is_some());
        known.di = known.di.filter(|_| more.di.is_some());
        before != *known
    };
    let states = flow::states(statements, Changed::default(), step, join);
    let mut reported = Vec::new();
    for (index, statement) in statements.iter().enumerate() {
        let Some(cause) = states[index].and_then(|state| state.ar2.or(state.di)) else { continue };
        let through = |location: &Location| matches!(location, Location::Instance { .. } | Location::InstancePointer { .. });
        let uses = calls_multi_instance(statement) || touched(statement).iter().any(|one| through(one.location));
        if !uses || reported.contains(&cause) {
            continue;
        }
        reported.push(cause);
        let register = if states[index].is_some_and(|state| state.ar2.is_some()) { "AR2" } else { "the DI register" };
        let message = format!(
            "this reaches another place than the variable that it names: {register} was changed, and parameters and static variables are found through it"
        );
        diagnostics.push(Diagnostic::new(Problem::P5024, statement.span(), message).related(statements[cause].span(), "changed here"));
    }
}

/// Whether the block keeps the old value of a register anywhere, so that it may put it back.
#[derive(Clone, Copy)]
struct Saves {
    ar2: bool,
    di: bool,
}

fn after(index: usize, statement: &Statement, before: Changed, saves: Saves) -> Changed {
    let (mut changed, here) = (before, Some(index));
    match (statement.instruction, &statement.operand) {
        (I::LoadAr2From, Operand::Constant(Value::Pointer(pointer))) => changed.ar2 = here.filter(|_| pointer & 0x00FF_FFFF != 0),
        // A register that was saved may be put back with this.
        (I::LoadAr2 | I::LoadAr2From | I::AddAr2, _) => changed.ar2 = here.filter(|_| !saves.ar2),
        (I::SwapAr, _) | (I::TransferAr1To, Operand::AddressRegister2) => changed.ar2 = None,
        (I::OpenBlock, Operand::Block(BlockOperand { instance: true, number, .. })) => {
            changed.di = here.filter(|_| matches!(number, NumberOperand::Fixed(_)) || !saves.di);
        }
        (I::SwapDataBlocks, _) => changed.di = None,
        (_, Operand::Memory(access)) if matches!(access.location, Location::InInstanceBlock { .. }) => changed.di = here,
        _ => {}
    }
    changed
}
