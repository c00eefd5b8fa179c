//! Numbers as constants, and the operations that statements need by themselves.

use sieben_engine::ir::Op;

use crate::st::standard::operators::{Operation, failed_op, op_for};
use crate::st::tree::Scalar;

/// The operation of an integer type.
pub(super) fn op(operation: Operation, scalar: Scalar) -> Op {
    op_for(operation, scalar).unwrap_or_else(|| panic!("{operation:?} of integers is in the table, for {scalar:?} too"))
}

/// Whether a sum does not fit its type.
pub(super) fn add_overflows(scalar: Scalar) -> Op {
    failed_op(Operation::Add, scalar).unwrap_or_else(|| panic!("a sum of {scalar:?} may overflow"))
}

/// The number that the bits of a constant mean.
pub(super) fn number(scalar: Scalar, bits: u64) -> i128 {
    match scalar {
        Scalar::I8 => i128::from(bits as u8 as i8),
        Scalar::I16 => i128::from(bits as u16 as i16),
        Scalar::I32 => i128::from(bits as u32 as i32),
        Scalar::I64 => i128::from(bits as i64),
        _ => i128::from(bits),
    }
}

/// The bits of a number as a variable holds them: zero-extended from the width of the type.
pub(super) fn bits(scalar: Scalar, number: i128) -> u64 {
    match scalar.bits() {
        64 => number as u64,
        width => number as u64 & ((1 << width) - 1),
    }
}

/// Comparisons, each beside the one that is true when it is false.
const OPPOSITES: &[(Op, Op)] = &[
    (Op::Equal, Op::Differ),
    (Op::Below, Op::GeU64),
    (Op::LeU64, Op::GtU64),
    (Op::LtI8, Op::GeI8),
    (Op::LeI8, Op::GtI8),
    (Op::EqI16, Op::NeI16),
    (Op::LtI16, Op::GeI16),
    (Op::LeI16, Op::GtI16),
    (Op::EqI32, Op::NeI32),
    (Op::LtI32, Op::GeI32),
    (Op::LeI32, Op::GtI32),
    (Op::LtI64, Op::GeI64),
    (Op::LeI64, Op::GtI64),
    (Op::EqF32, Op::DifferF32),
    (Op::EqF64, Op::DifferF64),
];

/// The comparison that is true when this one is false.
pub(super) fn opposite(op: Op) -> Option<Op> {
    OPPOSITES.iter().find_map(|&(a, b)| match op {
        _ if op == a => Some(b),
        _ if op == b => Some(a),
        _ => None,
    })
}
