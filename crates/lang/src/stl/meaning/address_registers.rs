//! Address registers.

use sieben_engine::ir::{Inst, OnFault, Op};
use sieben_engine::machine::Register;
use sieben_model::literal::Value;

use super::WRONG_OPERAND;
use super::accumulators::ACCU1;
use super::load_transfer::into_accumulator;
use crate::stl::lower::Lowering;
use crate::stl::operands::Operand;

/// `LAR1 <operand>`, `LAR2 <operand>`.
pub(crate) fn load(l: &mut Lowering<'_>, operand: &Operand, register: Register) {
    match operand {
        Operand::Memory(access) => {
            let value = l.load(access, OnFault::SkipStatement);
            l.b.copy(register, value);
        }
        Operand::Constant(Value::Pointer(pointer)) => l.b.set(register, u64::from(*pointer)),
        Operand::ParameterAddress(index) => l.b.push(Inst::Parameter { dst: register.into(), index: *index }),
        Operand::AddressRegister2 => l.b.copy(register, Register::Ar2),
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

/// `TAR1`, `TAR2` without operand.
pub(crate) fn to_accumulator(l: &mut Lowering<'_>, register: Register) {
    into_accumulator(l, register.into());
}

/// `TAR1 <operand>`, `TAR2 <operand>`.
pub(crate) fn transfer(l: &mut Lowering<'_>, operand: &Operand, register: Register) {
    match operand {
        Operand::Memory(access) => {
            let place = l.place(&access.location);
            l.b.store(place, access.width, register);
        }
        Operand::AddressRegister2 => l.b.copy(Register::Ar2, register),
        _ => unreachable!("{WRONG_OPERAND}"),
    }
}

/// `CAR`.
pub(crate) fn swap(l: &mut Lowering<'_>) {
    let old = l.b.compute(Op::Copy, &[Register::Ar1.into()]);
    l.b.copy(Register::Ar1, Register::Ar2);
    l.b.copy(Register::Ar2, old);
}

/// `+AR1`, `+AR2`.
pub(crate) fn add(l: &mut Lowering<'_>, operand: &Operand, register: Register) {
    let offset = match operand {
        Operand::None => ACCU1,
        Operand::Constant(Value::Pointer(offset)) => l.b.constant(u64::from(*offset)),
        _ => unreachable!("{WRONG_OPERAND}"),
    };
    l.b.compute_into(register, Op::AddPointer, &[register.into(), offset]);
}
