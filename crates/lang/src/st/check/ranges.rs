//! What is known of the values of expressions: an index that cannot leave its array needs no check.

use sieben_engine::ir::Op;

use super::Checker;
use super::types::bounds;
use crate::st::tree::{Place, Scalar, Value, ValueKind};

/// How deep an expression is looked into.
const DEPTH_MAX: u32 = 16;

/// A variable whose values are known to lie in a range.
pub(super) struct Known {
    /// The variable.
    pub(super) place: Place,
    /// The least and the greatest value.
    pub(super) range: (i128, i128),
}

impl Checker<'_> {
    /// The least and the greatest value that an expression of whole numbers can have.
    pub(super) fn range_of(&self, value: &Value) -> (i128, i128) {
        self.range_inside(value, DEPTH_MAX)
    }

    fn range_inside(&self, value: &Value, depth: u32) -> (i128, i128) {
        let (low, high) = bounds(value.scalar);
        if depth == 0 || matches!(value.scalar, Scalar::F32 | Scalar::F64) {
            return (low, high);
        }
        let inner = |arg: &Value| self.range_inside(arg, depth - 1);
        let range = match &value.kind {
            ValueKind::Constant(word) => {
                let number = signed(*word, value.scalar);
                (number, number)
            }
            ValueKind::Load(place) => match self.known.iter().rev().find(|known| same_place(&known.place, place)) {
                Some(known) => known.range,
                None => (low, high),
            },
            ValueKind::Compute { op, args } | ValueKind::Checked { op, args, .. } => match (op, args.as_slice()) {
                (Op::ExtendI8I16 | Op::ExtendI8I32 | Op::ExtendI8I64 | Op::Extend16 | Op::ExtendI16I64 | Op::ExtendI32I64, [arg])
                | (Op::Copy | Op::Low8 | Op::Low16 | Op::Low32, [arg]) => inner(arg),
                (Op::AddU8 | Op::AddU16 | Op::AddU32 | Op::AddU64, [a, b]) => {
                    let ((a, b), (c, d)) = (inner(a), inner(b));
                    (a + c, b + d)
                }
                (Op::SubU8 | Op::SubU16 | Op::SubU32 | Op::SubU64, [a, b]) => {
                    let ((a, b), (c, d)) = (inner(a), inner(b));
                    (a - d, b - c)
                }
                (Op::AndU32 | Op::AndU64, [a, b]) => {
                    let ((a, b), (c, d)) = (inner(a), inner(b));
                    if a >= 0 && c >= 0 { (0, b.min(d)) } else { (low, high) }
                }
                (Op::RemI8 | Op::RemI16 | Op::RemI32 | Op::RemI64 | Op::RemU64, [a, b]) => {
                    let ((a, b), (c, d)) = (inner(a), inner(b));
                    let most = c.abs().max(d.abs()) - 1;
                    (if a < 0 { -most.max(0) } else { 0 }, if b > 0 { most.max(0).min(b) } else { 0 })
                }
                _ => (low, high),
            },
            _ => (low, high),
        };
        // What leaves the type has wrapped, or is cut.
        if range.0 < low || range.1 > high { (low, high) } else { range }
    }
}

/// The number that a word is.
pub(super) fn signed(word: u64, scalar: Scalar) -> i128 {
    match scalar {
        Scalar::I8 => i128::from(word as i8),
        Scalar::I16 => i128::from(word as i16),
        Scalar::I32 => i128::from(word as i32),
        Scalar::I64 => i128::from(word as i64),
        _ => i128::from(word),
    }
}

/// Whether two places are the same variable; its place in the source does not matter.
pub(super) fn same_place(a: &Place, b: &Place) -> bool {
    a.base == b.base && a.offset == b.offset && a.indexes.is_empty() && b.indexes.is_empty()
}
