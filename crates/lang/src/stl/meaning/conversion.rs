//! Conversions.

use sieben_engine::ir::{Inst, Op};
use sieben_engine::machine::Register;

use super::accumulators::ACCU1;
use super::integer_math::{set_overflow, status16_wrapped, status32_wrapped};
use crate::stl::lower::Lowering;

/// Software error 16#21: a digit is no BCD digit.
const BCD_ERROR: u8 = 0x21;

/// `NEGI`.
pub(crate) fn negate16(l: &mut Lowering<'_>) {
    let result = l.b.compute(Op::NegI16Wide, &[ACCU1]);
    l.b.compute_into(Register::Accu1, Op::MergeLow16, &[ACCU1, result]);
    status16_wrapped(l, result);
}

/// `NEGD`.
pub(crate) fn negate32(l: &mut Lowering<'_>) {
    let result = l.b.compute(Op::NegI32Wide, &[ACCU1]);
    l.b.compute_into(Register::Accu1, Op::Low32, &[result]);
    status32_wrapped(l, result);
}

/// `INVI`, `INVD`: no status bit.
pub(crate) fn invert(l: &mut Lowering<'_>, mask: u64) {
    let mask = l.b.constant(mask);
    l.b.compute_into(Register::Accu1, Op::XorU32, &[ACCU1, mask]);
}

/// `BTI`, `BTD`: bad digits fail with ACCU 1 unchanged.
pub(crate) fn bcd_to_integer(l: &mut Lowering<'_>, valid: Op, convert: Op, low_word: bool) {
    let valid = l.b.compute(valid, &[ACCU1]);
    let accumulator = l.b.constant(0);
    l.b.push(Inst::Require { condition: valid, code: BCD_ERROR, register: accumulator });
    let result = l.b.compute(convert, &[ACCU1]);
    store(l, result, low_word);
}

/// `ITB`, `DTB`: a number that does not fit leaves ACCU 1 and sets OV and OS.
pub(crate) fn integer_to_bcd(l: &mut Lowering<'_>, overflows: Op, convert: Op, low_word: bool) {
    let overflow = l.b.compute(overflows, &[ACCU1]);
    let result = l.b.compute(convert, &[ACCU1]);
    store(l, result, low_word);
    set_overflow(l, overflow);
}

/// `RND` and its like: a REAL that does not fit leaves ACCU 1 and sets OV and OS.
pub(crate) fn round(l: &mut Lowering<'_>, op: Op) {
    let rounded = l.b.compute(op, &[ACCU1]);
    let overflow = l.b.compute(Op::OverflowsF32I32, &[rounded]);
    l.b.compute_into(Register::Accu1, Op::F32ToI32, &[rounded, ACCU1]);
    set_overflow(l, overflow);
}

fn store(l: &mut Lowering<'_>, result: sieben_engine::ir::Var, low_word: bool) {
    if low_word {
        l.b.compute_into(Register::Accu1, Op::MergeLow16, &[ACCU1, result]);
    } else {
        l.b.copy(Register::Accu1, result);
    }
}
