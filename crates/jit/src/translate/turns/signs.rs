//! Numbers on lines that are divided by constants: most of them count from 0 up, which nobody can know who compiles a sum with a variable.
//! That they are never negative is looked at in front of the loop, and a version of it divides them as numbers without sign.

use std::collections::BTreeSet;

use sieben_engine::ir::Op;

use super::kernel::{Kernel, Level, Node, What};

/// Larger loops are not written once more.
const NODES_MAX: usize = 400;

impl Kernel {
    /// The same loop with numbers that are never negative where it divides, if there are any that lie on lines.
    pub(super) fn without_signs(&self) -> Option<Self> {
        if self.inner.is_some() || self.nodes.len() > NODES_MAX {
            return None;
        }
        let mut needed = BTreeSet::new();
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        self.all_ends().chain(of_accesses).for_each(|node| self.rests(node, &mut needed));
        let divided: BTreeSet<(Node, u32)> = needed.into_iter().filter_map(|node| self.divided(node)).collect();
        let divided: Vec<(Node, u32)> = divided.into_iter().filter(|(number, _)| !self.bounds.contains_key(number)).collect();
        if divided.is_empty() {
            return None;
        }
        let mut kernel = self.clone();
        kernel.bounds.extend(divided.iter().map(|&(number, limit)| (number, (0, limit - 1))));
        kernel.required.extend(divided);
        Some(kernel)
    }

    /// The number on a line that a value divides by a constant, and the first one of its type with a sign.
    fn divided(&self, node: Node) -> Option<(Node, u32)> {
        let What::Compute(op, [number, divisor, ..]) = self.what(node) else { return None };
        let bits = match op {
            Op::DivI32 | Op::RemI32 => 32,
            Op::DivI16 | Op::RemI16 => 16,
            _ => return None,
        };
        let limit = 1 << (bits - 1);
        let divisor = self.constant(divisor)?;
        let line = self.line(number, Level::Outer)?;
        // A step back of 16 bits would have to be told from a long one ahead.
        let counts = !line.is_same() && line.bits == bits && (bits == 32 || line.step < limit);
        (counts && (2..u64::from(limit)).contains(&divisor) && self.is_32_bits(number)).then_some((number, limit))
    }
}
