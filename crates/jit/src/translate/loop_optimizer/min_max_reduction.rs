//! Min/max reductions: slots that keep the least or the greatest of what iterations compute, by a comparison or by MIN and MAX.

use std::collections::BTreeSet;

use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::types::{F32, F64, I16X8, I32, I64};
use cranelift_codegen::ir::{InstBuilder, InstructionData, MemFlagsData, Opcode, Type, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::Translator;
use super::super::value::Val;
use super::kernel::{Definition, Kernel, Level, Node, Slot, SlotKind};
use crate::passes::Pass;

/// Which of two numbers stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MinMax {
    Least,
    Greatest,
}

impl MinMax {
    fn of_less(less: bool) -> Self {
        if less { Self::Least } else { Self::Greatest }
    }
}

impl Kernel {
    /// The integers of which an operation leaves the least or the greatest one, and how many bits they have. Of two that are equal it does
    /// not matter which one stays.
    fn extreme_of_integers(&self, node: Node) -> Option<(MinMax, [Node; 2], u32)> {
        match self.what(node) {
            Definition::Compute(Op::Low16, [of, ..]) => self.extreme_of_integers(of).filter(|&(.., bits)| bits == 16),
            Definition::Compute(op @ (Op::MinI16 | Op::MaxI16), [a, b, ..]) => Some((MinMax::of_less(op == Op::MinI16), [a, b], 16)),
            Definition::Compute(op @ (Op::MinI32 | Op::MaxI32), [a, b, ..]) => Some((MinMax::of_less(op == Op::MinI32), [a, b], 32)),
            Definition::Compute(Op::Select, [condition, a, b, _]) => {
                let Definition::Compute(op, [x, y, ..]) = self.what(condition) else { return None };
                let (less, bits) = match op {
                    Op::LtI16 | Op::LeI16 => (true, 16),
                    Op::GtI16 | Op::GeI16 => (false, 16),
                    Op::LtI32 | Op::LeI32 => (true, 32),
                    Op::GtI32 | Op::GeI32 => (false, 32),
                    _ => return None,
                };
                let same_order = [x, y] == [a, b];
                (same_order || [y, x] == [a, b]).then(|| (MinMax::of_less(less == same_order), [a, b], bits))
            }
            _ => None,
        }
    }

    /// What an iteration of a loop compares a slot with that keeps the least or the greatest number of all iterations, if nothing else
    /// looks at the slot; with its bits.
    pub(super) fn extreme(&self, level: Level, slot: Slot, end: Node) -> Option<(MinMax, Node, u32)> {
        if !self.passes.has(Pass::MinMaxReduction) {
            return None;
        }
        let SlotKind::Memory { width, .. } = self.kept(slot) else { return None };
        let (extreme, [a, b], bits) = self.extreme_of_integers(end)?;
        let fits = matches!((width, bits), (Width::Word, 16) | (Width::DoubleWord, 32));
        if !fits || level == Level::Inner || self.inner.is_some() {
            return None;
        }
        let other = match () {
            () if self.is_start(a, level, slot) => b,
            () if self.is_start(b, level, slot) => a,
            () => return None,
        };
        self.is_only_added(level, slot, other).then_some((extreme, other, bits))
    }

    /// The REALs or LREALs of which a choice leaves the first if that is less or greater than the second, and the second otherwise; with
    /// their type.
    pub(super) fn extreme_of_reals(&self, node: Node) -> Option<(MinMax, [Node; 2], Type)> {
        if !self.passes.has(Pass::MinMaxReduction) {
            return None;
        }
        let Definition::Compute(Op::Select, [condition, a, b, _]) = self.what(node) else { return None };
        let Definition::Compute(op, [x, y, ..]) = self.what(condition) else { return None };
        let (less, ty) = match op {
            Op::LtF32 => (true, F32),
            Op::GtF32 => (false, F32),
            Op::LtF64 => (true, F64),
            Op::GtF64 => (false, F64),
            _ => return None,
        };
        let same_order = [x, y] == [a, b];
        (same_order || [y, x] == [a, b]).then(|| (MinMax::of_less(less == same_order), [a, b], ty))
    }

    /// The choices, one in the other, whose last one leaves the least or the greatest REAL or LREAL in a slot; none if it does not.
    pub(super) fn extremes_of_reals(&self, end: Node, wanted: Type) -> BTreeSet<Node> {
        let mut choices = BTreeSet::new();
        let mut waiting = vec![end];
        while let Some(node) = waiting.pop() {
            if let Some((_, both, ty)) = self.extreme_of_reals(node)
                && ty == wanted
                && choices.insert(node)
            {
                waiting.extend(both);
            }
        }
        choices
    }
}

impl Translator<'_> {
    /// The REAL or LREAL with exactly these bits, whatever they are.
    pub(super) fn exact(&mut self, value: Val, ty: Type) -> Value {
        let bits = if ty == F64 { self.word(value) } else { self.int(value) };
        match self.definition(bits) {
            // They were a REAL.
            Some((_, InstructionData::LoadNoOffset { opcode: Opcode::Bitcast, arg, .. })) if self.b.func.dfg.value_type(arg) == ty => arg,
            _ => self.b.ins().bitcast(ty, MemFlagsData::new(), bits),
        }
    }

    /// What a REAL or an LREAL stands for, with exactly its bits.
    pub(super) fn with_all_bits(&mut self, real: Value) -> Val {
        if self.b.func.dfg.value_type(real) == F64 {
            return Val::Lreal { real, bits: self.b.ins().bitcast(I64, MemFlagsData::new(), real) };
        }
        Val::Real { real, bits: self.b.ins().bitcast(I32, MemFlagsData::new(), real) }
    }

    /// The first of two REALs or LREALs if it is less or greater than the second, and the second otherwise, with exactly its bits.
    pub(super) fn exact_extreme(&mut self, extreme: MinMax, both: [Val; 2], ty: Type) -> Val {
        let [a, b] = both.map(|value| self.exact(value, ty));
        let condition = match extreme {
            MinMax::Least => FloatCC::LessThan,
            MinMax::Greatest => FloatCC::GreaterThan,
        };
        let first = self.is_extreme(condition, [a, b]);
        let real = self.b.ins().select(first, a, b);
        self.with_all_bits(real)
    }

    /// The least or greatest numbers of two vectors.
    pub(super) fn extreme_of_lanes(&mut self, extreme: MinMax, a: Value, b: Value) -> Value {
        match extreme {
            MinMax::Least => self.b.ins().smin(a, b),
            MinMax::Greatest => self.b.ins().smax(a, b),
        }
    }

    /// The least or greatest number in all lanes of some vectors.
    pub(super) fn extreme_in_lanes(&mut self, extreme: MinMax, vectors: &[Value], lanes: u32) -> Value {
        let mut all = vectors[0];
        for &vector in &vectors[1..] {
            all = self.extreme_of_lanes(extreme, all, vector);
        }
        let ty = self.b.func.dfg.value_type(all);
        let mut found = None;
        for lane in 0..ty.lane_count().min(lanes) as u8 {
            let value = self.b.ins().extractlane(all, lane);
            let value = if ty == I16X8 { self.b.ins().sextend(I32, value) } else { value };
            found = Some(match found {
                Some(other) => self.extreme_of_lanes(extreme, other, value),
                None => value,
            });
        }
        found.unwrap_or_else(|| unreachable!("a vector has lanes"))
    }
}
