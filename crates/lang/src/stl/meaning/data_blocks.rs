//! Data block registers.

use sieben_engine::ir::{DataRegister, Inst, Op};
use sieben_engine::machine::Register;

use super::WRONG_OPERAND;
use super::load_transfer::into_accumulator;
use crate::calling::registers::REGISTER_PAIRS;
use crate::stl::lower::Lowering;
use crate::stl::operands::{DataBlockInfo, Operand};

/// `OPN`.
pub(crate) fn open(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::Block(block) = operand else { unreachable!("{WRONG_OPERAND}") };
    let register = if block.instance { DataRegister::Instance } else { DataRegister::Shared };
    let number = l.number(&block.number);
    l.b.push(Inst::Open { register, number });
}

/// `CDB`.
pub(crate) fn swap(l: &mut Lowering<'_>) {
    for (shared, instance) in REGISTER_PAIRS {
        let old = l.b.compute(Op::Copy, &[shared.into()]);
        l.b.copy(shared, instance);
        l.b.copy(instance, old);
    }
}

/// `L DBLG`, `L DBNO`, `L DILG`, `L DINO`: 0 if no block is open.
pub(crate) fn load_data_block_info(l: &mut Lowering<'_>, operand: &Operand) {
    let Operand::DataBlockInfo(info) = operand else { unreachable!("{WRONG_OPERAND}") };
    into_accumulator(l, register_of(*info).into());
}

/// The register that `DBLG` and its like name.
pub(crate) fn register_of(info: DataBlockInfo) -> Register {
    match info {
        DataBlockInfo::SharedLength => Register::DbLength,
        DataBlockInfo::SharedNumber => Register::DbNumber,
        DataBlockInfo::InstanceLength => Register::DiLength,
        DataBlockInfo::InstanceNumber => Register::DiNumber,
    }
}
