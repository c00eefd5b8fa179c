//! Canonical forms of operations (instruction combining): sums and pointers stay affine, conversions and selects that change nothing leave
//! no trace.

use sieben_engine::ir::Op;

use super::kernel::{Definition, Node};
use super::ssa_construction::{DEPTH_MAX, SsaBuilder};

impl SsaBuilder<'_, '_> {
    /// The result of an operation, in the simplest form.
    pub(super) fn compute(&mut self, op: Op, mut args: [Node; 4]) -> Node {
        let used = op.arity();
        let constants: Option<Vec<u64>> = args[..used].iter().map(|&arg| self.kernel.constant(arg)).collect();
        if let Some(constants) = constants {
            let mut words = [0; 4];
            words[..used].copy_from_slice(&constants);
            return self.constant(op.eval(words));
        }
        if let Some(node) = self.by_power_of_two(op, args) {
            return node;
        }
        if op == Op::Select {
            let (condition, holds) = self.positive(args[0]);
            let (a, b) = if holds { (args[1], args[2]) } else { (args[2], args[1]) };
            args = [condition, a, b, condition];
            if let Some(node) = self.counted_where(condition, a, b) {
                return node;
            }
        }
        if let Some(node) = self.is_one_of_its_arguments(op, args) {
            return node;
        }
        if let Some(node) = self.simpler(op, args) {
            return node;
        }
        let op = match (op, self.kernel.what(args[0])) {
            // The low half of a sum rests on the low halves of its terms.
            (Op::Low16, Definition::Compute(wide, of)) if narrow(wide).is_some() => {
                args = of;
                narrow(wide).unwrap_or(wide)
            }
            (Op::Low32, Definition::Compute(wide @ (Op::AddI32Wide | Op::SubI32Wide | Op::MulI32Wide), of)) => {
                args = of;
                match wide {
                    Op::AddI32Wide => Op::AddU32,
                    Op::SubI32Wide => Op::SubU32,
                    _ => Op::MulU32,
                }
            }
            (Op::AndU64 | Op::OrU64 | Op::XorU64, _) if args[..2].iter().all(|&arg| self.kernel.is_32_bits(arg)) => match op {
                Op::AndU64 => Op::AndU32,
                Op::OrU64 => Op::OrU32,
                _ => Op::XorU32,
            },
            // An INT or a DINT on its way to an LREAL.
            (Op::I64ToF64, Definition::Compute(Op::ExtendI32I64, of)) => {
                args = of;
                Op::I32ToF64
            }
            (Op::I64ToF64, Definition::Compute(Op::ExtendI16I64, of)) => {
                args = [self.compute(Op::Extend16, of); 4];
                Op::I32ToF64
            }
            (Op::I64ToF32, Definition::Compute(Op::ExtendI16I64, of)) => {
                args = [self.compute(Op::Extend16, of); 4];
                Op::I32ToF32
            }
            (Op::F64ToI32, Definition::Compute(Op::F32ToF64, [real, ..]))
                if let Definition::Compute(Op::TruncF32, of) = self.kernel.what(real) =>
            {
                args = [self.compute(Op::F32ToF64, of); 4];
                op
            }
            // What is cut anyway.
            (Op::F64ToI32, Definition::Compute(Op::TruncF64, of)) => {
                args = of;
                op
            }
            // A DINT on its way to a REAL.
            (Op::I64ToF32, Definition::Compute(Op::ExtendI32I64, of)) => {
                args = of;
                Op::I32ToF32
            }
            _ => op,
        };
        if matches!(op, Op::AddU16 | Op::SubU16 | Op::MulU16 | Op::Low16 | Op::Decrement16) {
            for arg in &mut args[..op.arity()] {
                *arg = self.with_low_half(*arg);
            }
            if op == Op::Low16 && self.kernel.is_16_bits(args[0]) {
                return args[0];
            }
        }
        if op == Op::MergeLow16 && self.kernel.is_16_bits(args[0]) {
            return self.compute(Op::Low16, [args[1]; 4]);
        }
        // What does not count shall not make two values of one.
        let (first, rest) = args.split_at_mut(op.arity().max(1));
        rest.fill(first[0]);
        self.node(Definition::Compute(op, args))
    }

    /// A number without sign of 32 bits that is divided by a power of two, or what that leaves over: as numbers of 64 bits, which is how
    /// UDINT and DWORD are divided, it would have no form side by side.
    fn by_power_of_two(&mut self, op: Op, [number, divisor, ..]: [Node; 4]) -> Option<Node> {
        if !matches!(op, Op::DivU64 | Op::RemU64) || !self.kernel.is_32_bits(number) {
            return None;
        }
        let divisor = u32::try_from(self.kernel.constant(divisor)?).ok().filter(|divisor| divisor.is_power_of_two())?;
        let (op, by) = if op == Op::DivU64 { (Op::Shr32, divisor.trailing_zeros()) } else { (Op::AndU32, divisor - 1) };
        let by = self.constant(by.into());
        Some(self.compute(op, [number, by, number, number]))
    }

    /// A value that grows on one side of a condition only grows by 0 on the other one: so a sum stays a sum.
    fn counted_where(&mut self, condition: Node, a: Node, b: Node) -> Option<Node> {
        let grown = |this: &Self, more: Node, value: Node| match this.kernel.what(more) {
            Definition::Compute(op @ (Op::AddU32 | Op::SubU32), [of, by, ..]) if of == value && this.kernel.is_32_bits(of) => {
                Some((op, by))
            }
            Definition::Compute(op @ Op::AddU32, [by, of, ..]) if of == value && this.kernel.is_32_bits(of) => Some((op, by)),
            Definition::Compute(op @ (Op::AddU16 | Op::SubU16), [of, by, ..]) if of == value && this.kernel.is_16_bits(of) => {
                Some((op, by))
            }
            Definition::Compute(op @ Op::AddU16, [by, of, ..]) if of == value && this.kernel.is_16_bits(of) => Some((op, by)),
            _ => None,
        };
        if a == b {
            return None;
        }
        let (op, value, by, condition) = if let Some((op, by)) = grown(self, a, b) {
            (op, b, by, condition)
        } else {
            let (op, by) = grown(self, b, a)?;
            (op, a, by, self.compute(Op::Not, [condition; 4]))
        };
        let by = self.compute(Op::Gate, [by, condition, by, by]);
        Some(self.compute(op, [value, by, value, value]))
    }

    /// What stays on a line, where the operation itself would hide it; and operations of which there are vectors.
    fn simpler(&mut self, op: Op, [a, b, ..]: [Node; 4]) -> Option<Node> {
        match op {
            Op::PassOnPointer if self.kernel.is_32_bits(a) && self.range(a, DEPTH_MAX).leads_elsewhere() => Some(a),
            // A whole number near a REAL is a REAL.
            Op::RoundF64 | Op::CeilF64 | Op::FloorF64 | Op::TruncF64 => {
                let Definition::Compute(Op::F32ToF64, of) = self.kernel.what(a) else { return None };
                let op = match op {
                    Op::RoundF64 => Op::RoundF32,
                    Op::CeilF64 => Op::CeilF32,
                    Op::FloorF64 => Op::FloorF32,
                    _ => Op::TruncF32,
                };
                let whole = self.compute(op, of);
                Some(self.compute(Op::F32ToF64, [whole; 4]))
            }
            Op::F64ToI16 => Some(self.cut_to(a, i16::MIN.into(), i16::MAX.into())),
            Op::F64ToU16 => Some(self.cut_to(a, 0, u16::MAX.into())),
            // Of a pointer to an instance the area is replaced: its other bits are the same for all that the pointer may be.
            Op::AndU32 => {
                let mask = u32::try_from(self.kernel.constant(b)?).ok()?;
                let (least, most) = self.range(a, DEPTH_MAX).unsigned(32);
                let above = i128::from(!mask);
                if !mask.wrapping_add(1).is_power_of_two() || least & above != most & above || !self.kernel.is_32_bits(a) {
                    return None;
                }
                let above = self.constant((least & above) as u64);
                Some(self.compute(Op::SubU32, [a, above, a, a]))
            }
            Op::AddU32 => {
                let added = self.kernel.constant(b)? as u32;
                let Definition::Compute(Op::SubU32, [of, taken, ..]) = self.kernel.what(a) else { return None };
                let taken = self.kernel.constant(taken)? as u32;
                let added = self.constant(u64::from(added.wrapping_sub(taken)));
                self.kernel.is_32_bits(of).then(|| self.compute(Op::AddU32, [of, added, of, of]))
            }
            // UDINT and UINT are divided as numbers of 64 bits, of which there are no vectors.
            Op::DivU64 | Op::RemU64 => {
                let is_small = |number: Node| self.kernel.is_32_bits(number) && self.range(number, DEPTH_MAX).unsigned(32).1 < 1 << 31;
                self.kernel.constant(b).filter(|&divisor| divisor > 0)?;
                let op = if op == Op::DivU64 { Op::DivI32 } else { Op::RemI32 };
                (is_small(a) && is_small(b)).then(|| self.compute(op, [a, b, a, a]))
            }
            // What is never negative is divided by a power of two as if it had no sign.
            Op::DivI32 | Op::RemI32 => {
                let divisor = self.kernel.constant(b).filter(|&divisor| divisor < 1 << 31)?;
                let (least, most) = self.range(a, DEPTH_MAX).signed(32);
                if least < 0 || !self.kernel.is_32_bits(a) {
                    return None;
                }
                if !divisor.is_power_of_two() {
                    self.kernel.bounds.insert(a, (least as u32, most as u32));
                    return None;
                }
                let (op, by) = if op == Op::DivI32 { (Op::Shr32, divisor.trailing_zeros().into()) } else { (Op::AndU32, divisor - 1) };
                let by = self.constant(by);
                Some(self.compute(op, [a, by, a, a]))
            }
            // A number that stays inside its type is the same in the wider one.
            Op::Extend16 => {
                let Definition::Compute(op @ (Op::AddU16 | Op::SubU16 | Op::MulU16), [a, b, ..]) = self.kernel.what(a) else { return None };
                let (exact, wide): (fn(i128, i128) -> i128, Op) = match op {
                    Op::AddU16 => (|a, b| a + b, Op::AddU32),
                    Op::SubU16 => (|a, b| a - b, Op::SubU32),
                    _ => (|a, b| a * b, Op::MulU32),
                };
                let [x, y] = [a, b].map(|node| self.range(node, DEPTH_MAX).signed(16));
                let stays = [(x.0, y.0), (x.0, y.1), (x.1, y.0), (x.1, y.1)].iter().all(|&(x, y)| i16::try_from(exact(x, y)).is_ok());
                if !stays || ![a, b].iter().all(|&node| self.rests_on_counters(node, DEPTH_MAX)) {
                    return None;
                }
                let [a, b] = [a, b].map(|node| self.compute(Op::Extend16, [node; 4]));
                Some(self.compute(wide, [a, b, a, a]))
            }
            _ => None,
        }
    }

    /// An LREAL cut to a number of 16 bits between two limits.
    fn cut_to(&mut self, real: Node, least: i32, most: i32) -> Node {
        let [least, most] = [least, most].map(|limit| self.constant(u64::from(limit as u32)));
        let whole = self.compute(Op::F64ToI32, [real; 4]);
        let above = self.compute(Op::MaxI32, [whole, least, whole, whole]);
        let inside = self.compute(Op::MinI32, [above, most, above, above]);
        self.compute(Op::Low16, [inside; 4])
    }

    /// Whether a number is made of constants and of what slots held when an iteration began, by operations that keep it on a line.
    fn rests_on_counters(&self, node: Node, depth: usize) -> bool {
        match self.kernel.what(node) {
            Definition::Constant(_) | Definition::Start(..) => true,
            Definition::Compute(op, args) => {
                let keeps =
                    matches!(op, Op::AddU16 | Op::SubU16 | Op::MulU16 | Op::AddU32 | Op::SubU32 | Op::MulU32 | Op::Low16 | Op::Extend16);
                keeps && depth > 0 && args[..op.arity()].iter().all(|&arg| self.rests_on_counters(arg, depth - 1))
            }
            Definition::Read(_) | Definition::After(_) => false,
        }
    }

    fn is_one_of_its_arguments(&self, op: Op, args: [Node; 4]) -> Option<Node> {
        let constant = |at: usize| self.kernel.constant(args[at]);
        match op {
            Op::Copy => Some(args[0]),
            Op::AddU32 | Op::SubU32 if constant(1) == Some(0) && self.kernel.is_32_bits(args[0]) => Some(args[0]),
            Op::AddU32 if constant(0) == Some(0) && self.kernel.is_32_bits(args[1]) => Some(args[1]),
            Op::MulU32 if constant(1) == Some(1) && self.kernel.is_32_bits(args[0]) => Some(args[0]),
            Op::Low32 if self.kernel.is_32_bits(args[0]) => Some(args[0]),
            Op::Low16 if self.kernel.is_16_bits(args[0]) => Some(args[0]),
            Op::Gate if self.is_true(args[1]) => Some(args[0]),
            Op::Select if self.is_true(args[0]) => Some(args[1]),
            Op::Select if args[1] == args[2] => Some(args[1]),
            Op::Select => constant(0).map(|condition| if condition & 1 != 0 { args[1] } else { args[2] }),
            Op::Not => match self.kernel.what(args[0]) {
                Definition::Compute(Op::Not, [of, ..]) if self.kernel.is_bit(of) => Some(of),
                _ => None,
            },
            Op::And if self.is_true(args[1]) && self.kernel.is_bit(args[0]) => Some(args[0]),
            Op::And if self.is_true(args[0]) && self.kernel.is_bit(args[1]) => Some(args[1]),
            Op::AndNot if constant(1).is_some_and(|other| other & 1 == 0) && self.kernel.is_bit(args[0]) => Some(args[0]),
            _ => None,
        }
    }

    /// A value with the same low half.
    fn with_low_half(&self, node: Node) -> Node {
        match self.kernel.what(node) {
            Definition::Compute(Op::MergeLow16, [_, low, ..]) => self.with_low_half(low),
            Definition::Compute(Op::Low16 | Op::Extend16, [of, ..]) => self.with_low_half(of),
            _ => node,
        }
    }
}

/// The operation on halves whose result is the low half of that of one on wider numbers.
fn narrow(op: Op) -> Option<Op> {
    match op {
        Op::AddI16Wide | Op::AddU32 => Some(Op::AddU16),
        Op::SubI16Wide | Op::SubU32 => Some(Op::SubU16),
        Op::MulI16Wide | Op::MulU32 => Some(Op::MulU16),
        _ => None,
    }
}
