//! Loop-carried values, and in which form each is carried.

use std::collections::BTreeSet;

use cranelift_codegen::ir::types::{F32, F64, I32};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Type, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::super::{Translator, is_bit};
use super::emission::Emitter;
use super::kernel::{Access, Definition, Effect, Level, Node, Slot, SlotKind};
use super::min_max_reduction::MinMax;
use super::scalar_evolution::{Affine, Recurrence, Shape};
use super::vectorization::Lanes;

/// How many values on lines more than slots are counted on.
const COUNTED_MORE: usize = 2;

/// What a loop hands from iteration to iteration, and how.
pub(super) enum LoopCarried {
    Affine(Slot, Affine),
    /// A value on a line that is no slot.
    Counted(Node, Affine),
    /// A sum: its vectors.
    Sum(Slot, Node, Shape),
    /// The least or greatest numbers: their vectors.
    MinMax(Slot, Node, MinMax, Shape),
    Chain(Slot, Node, Form),
    Address(Base, Node, u32, i64),
}

/// How a value is handed on.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Bit,
    /// A bit with anything above it.
    LooseBit,
    Int,
    Real,
    /// 64 bits.
    Quad,
    Lreal,
    /// A REAL or an LREAL of which each bit counts.
    Exact(Type),
    Lanes(Shape),
}

impl Emitter<'_, '_, '_> {
    /// What a loop hands from iteration to iteration.
    pub(super) fn handed(&mut self, level: Level) -> Vec<LoopCarried> {
        let kernel = self.kernel;
        let carried = kernel.carried(level);
        let mut needed = kernel.needed(level, &|slot| kernel.slot_line(level, slot).is_none());
        // What is left behind the last iteration may rest on what an iteration began with.
        let mut ends: BTreeSet<Node> = BTreeSet::new();
        for (_, end, carried) in &carried {
            match carried {
                Recurrence::Affine(_) if level == Level::Outer => {}
                Recurrence::Sum { added, .. } => kernel.rests(*added, &mut ends),
                _ => kernel.rests(*end, &mut ends),
            }
        }
        if let (Level::Outer, Some(inner)) = (level, &kernel.inner) {
            for &end in inner.ends.values().chain(inner.entry.values()) {
                kernel.rests(end, &mut ends);
            }
        }
        needed.extend(ends);
        let counted = self.counted(level, &carried);
        let mut handed: Vec<LoopCarried> =
            counted.iter().flatten().map(|&node| LoopCarried::Counted(node, kernel.line(node, level).unwrap_or(Affine::SAME))).collect();
        for (slot, end, carried) in carried {
            let inspected = needed.iter().any(|&node| kernel.is_start(node, level, slot));
            match carried {
                Recurrence::Affine(line) if inspected && !line.is_same() && counted.is_none() => {
                    handed.push(LoopCarried::Affine(slot, line))
                }
                Recurrence::Affine(_) | Recurrence::Nothing => {}
                Recurrence::Chain if self.lanes > 1 && kernel.in_order.slots.contains(&slot) => {
                    handed.push(LoopCarried::Chain(slot, end, self.form_in_order(slot)));
                }
                Recurrence::Sum { added, bits } if self.lanes > 1 && level == Level::Outer => {
                    handed.push(LoopCarried::Sum(slot, added, Shape::of_bits(bits)));
                }
                Recurrence::MinMax { extreme, other, bits } if self.lanes > 1 => {
                    handed.push(LoopCarried::MinMax(slot, other, extreme, Shape::of_bits(bits)));
                }
                Recurrence::Sum { .. } | Recurrence::MinMax { .. } | Recurrence::Chain => {
                    let form = self.form(level, slot, end, &needed);
                    if let Form::Exact(ty) = form {
                        self.extremes.extend(kernel.extremes_of_reals(end, ty));
                    }
                    handed.push(LoopCarried::Chain(slot, end, form));
                }
            }
        }
        let step_of = |access: &Access| self.plan.counted_on(access, level);
        let mut known: Vec<(Base, Node, u32)> = Vec::new();
        let ends = kernel.copies.iter().flat_map(|copied| [&copied.from, &copied.to]).filter(|end| kernel.is_counted_end(end, level));
        let of_steps = kernel.iteration(level).steps.iter().filter_map(|step| match *step {
            Effect::Access(access) => Some(&kernel.accesses[access]),
            Effect::Copy(_) | Effect::Inner => None,
        });
        for access in of_steps.chain(ends) {
            if let Some(step) = step_of(access)
                && !known.contains(&access.counted())
            {
                let (base, pointer, offset) = access.counted();
                known.push((base, pointer, offset));
                let iterations = if level == Level::Outer { self.lanes } else { 1 };
                handed.push(LoopCarried::Address(base, pointer, offset, Translator::bytes_of_step(step, iterations)));
            }
        }
        handed
    }

    /// The values on lines with which the others of an iteration are computed, if iterations are made one by one: each is counted on, so
    /// that an iteration does not compute it again.
    fn counted(&self, level: Level, carried: &[(Slot, Node, Recurrence)]) -> Option<BTreeSet<Node>> {
        let kernel = self.kernel;
        if self.lanes > 1 || level == Level::Inner || kernel.inner.is_some() {
            return None;
        }
        let mut waiting: Vec<Node> = Vec::new();
        for access in &kernel.accesses {
            waiting.extend(access.value);
            if self.plan.counted_on(access, level).is_none() {
                waiting.push(access.pointer);
            }
        }
        for step in &kernel.outer.steps {
            if let Effect::Copy(number) = *step {
                waiting.extend(kernel.nodes_of_copy(number, level));
            }
        }
        for &(_, end, carried) in carried {
            match carried {
                Recurrence::Affine(_) => {}
                Recurrence::Sum { added, .. } => waiting.push(added),
                // It is computed behind the loop.
                Recurrence::Nothing if kernel.line(end, level).is_some() => {}
                _ => waiting.push(end),
            }
        }
        let grows = |node: Node| kernel.line(node, level).is_some_and(|line| !line.is_same());
        let mut seen = BTreeSet::new();
        while let Some(node) = waiting.pop() {
            if seen.insert(node)
                && !grows(node)
                && let Definition::Compute(op, args) = kernel.what(node)
            {
                waiting.extend(&args[..op.arity()]);
            }
        }
        let mut counted: BTreeSet<Node> = seen.into_iter().filter(|&node| grows(node)).collect();
        // What one operation makes of another one of them costs as little.
        for node in counted.clone() {
            if let Definition::Compute(op, args) = kernel.what(node)
                && args[..op.arity()].iter().all(|arg| counted.contains(arg) || !grows(*arg))
            {
                counted.remove(&node);
            }
        }
        let slots = carried.iter().filter(|(.., carried)| matches!(carried, Recurrence::Affine(line) if !line.is_same())).count();
        (counted.len() <= slots + COUNTED_MORE).then_some(counted)
    }

    fn form(&self, level: Level, slot: Slot, end: Node, needed: &BTreeSet<Node>) -> Form {
        if self.lanes > 1 {
            return self.kernel.shape(self.kernel.iteration(level).ends[&slot]).map_or(Form::Int, Form::Lanes);
        }
        if let SlotKind::Register(register) = self.kernel.kept(slot)
            && is_bit(register)
        {
            return Form::Bit;
        }
        if matches!(self.kernel.kept(slot), SlotKind::Memory { width: Width::Bit, .. }) {
            return Form::Bit;
        }
        if matches!(self.kernel.kept(slot), SlotKind::Ahead { width: Width::Bit, .. }) {
            return Form::LooseBit;
        }
        let wide = self.kernel.kept(slot).is_wide();
        let real = |op: Op| match wide {
            true => matches!(op, Op::AddF64 | Op::SubF64 | Op::MulF64 | Op::DivF64 | Op::MinF64 | Op::MaxF64),
            false => matches!(op, Op::AddF32 | Op::SubF32 | Op::MulF32 | Op::DivF32 | Op::MinF32 | Op::MaxF32),
        };
        let compares = |op: Op| match wide {
            true => matches!(op, Op::EqF64 | Op::LtF64 | Op::LeF64 | Op::GtF64 | Op::GeF64 | Op::DifferF64),
            false => matches!(op, Op::EqF32 | Op::LtF32 | Op::LeF32 | Op::GtF32 | Op::GeF32 | Op::DifferF32),
        };
        let is_real = matches!(self.kernel.what(end), Definition::Compute(op, _) if real(op));
        let ty = if wide { F64 } else { F32 };
        let extremes = self.kernel.extremes_of_reals(end, ty);
        let others = needed.iter().any(|&node| match self.kernel.what(node) {
            Definition::Compute(op, _) if real(op) || compares(op) || extremes.contains(&node) => false,
            Definition::Compute(op, args) => args[..op.arity()].iter().any(|&arg| self.kernel.is_start(arg, level, slot)),
            _ => false,
        });
        if !extremes.is_empty() && !others {
            return Form::Exact(ty);
        }
        let written = self.kernel.accesses.iter().filter_map(|access| access.value).any(|value| self.kernel.is_start(value, level, slot));
        let handed_on = self.kernel.all_ends().any(|end| self.kernel.is_start(end, level, slot));
        match (is_real && !others && !written && !handed_on, wide) {
            (true, false) => Form::Real,
            (true, true) => Form::Lreal,
            (false, false) => Form::Int,
            (false, true) => Form::Quad,
        }
    }

    pub(super) fn count_of(&self, one: &LoopCarried) -> usize {
        match one {
            LoopCarried::Affine(..) | LoopCarried::Counted(..) | LoopCarried::Address(..) => 1,
            LoopCarried::Sum(.., shape) | LoopCarried::MinMax(.., shape) | LoopCarried::Chain(.., Form::Lanes(shape)) => {
                shape.vectors(self.lanes).1 as usize
            }
            LoopCarried::Chain(..) => 1,
        }
    }

    /// The parameters of each thing that is handed on.
    pub(super) fn owned(&self, handed: &[LoopCarried], parameters: &[Value]) -> Vec<Vec<Value>> {
        let mut at = 0;
        let mut owned = Vec::new();
        for one in handed {
            let count = self.count_of(one);
            owned.push(parameters[at..at + count].to_vec());
            at += count;
        }
        owned
    }

    pub(super) fn first_of(&mut self, level: Level, one: &LoopCarried, all: &mut Vec<Value>) {
        match *one {
            LoopCarried::Affine(slot, _) => {
                let value = match self.entry(level, slot) {
                    Lanes::One(value) | Lanes::Affine(value, _) => value,
                    _ => unreachable!("what begins a line is on one"),
                };
                all.push(self.t.int(value));
            }
            LoopCarried::Counted(node, _) => {
                let value = self.value_before(node);
                all.push(self.t.int(value));
            }
            LoopCarried::Sum(_, _, shape) => {
                let (ty, count) = shape.vectors(self.lanes);
                for _ in 0..count {
                    all.push(self.t.zeros(ty));
                }
            }
            LoopCarried::MinMax(slot, _, _, shape) => {
                let value = self.entry(level, slot);
                self.in_form(&value, Form::Lanes(shape), all);
            }
            LoopCarried::Chain(slot, _, form) => {
                let value = self.entry(level, slot);
                self.in_form(&value, form, all);
            }
            LoopCarried::Address(base, pointer, offset, _) => {
                let value = match level {
                    Level::Outer => self.value_before(pointer),
                    Level::Inner => self.value_at_entry(pointer),
                };
                let address = self.address(base, value, offset);
                all.push(address);
            }
        }
    }

    pub(super) fn in_form(&mut self, value: &Lanes, form: Form, all: &mut Vec<Value>) {
        let one = |value: &Lanes| match value {
            Lanes::One(value) => *value,
            _ => unreachable!("one iteration has one value"),
        };
        match form {
            Form::Bit => all.push(self.t.flag(one(value))),
            Form::LooseBit => all.push(self.t.bit(one(value))),
            Form::Int => all.push(self.t.int(one(value))),
            Form::Real => all.push(self.t.f32(one(value))),
            Form::Quad => all.push(self.t.word(one(value))),
            Form::Lreal => all.push(self.t.f64(one(value))),
            Form::Exact(ty) => all.push(self.t.exact(one(value), ty)),
            Form::Lanes(Shape::Wide) => all.extend(self.t.quads(value, self.lanes)),
            Form::Lanes(Shape::Lreals) => all.extend(self.t.lreals(value, self.lanes)),
            Form::Lanes(Shape::Halves) => all.extend(self.t.halves(value, self.lanes)),
            Form::Lanes(Shape::Reals) => all.extend(self.t.reals(value, self.lanes)),
            Form::Lanes(_) => all.extend(self.t.words(value, self.lanes)),
        }
    }

    /// Takes what was handed on.
    pub(super) fn begin(&mut self, level: Level, handed: &[LoopCarried], parameters: &[Value]) {
        for (one, own) in handed.iter().zip(self.owned(handed, parameters)) {
            match *one {
                LoopCarried::Affine(slot, line) => {
                    let value = Val::Int(own[0]);
                    if line.bits == 16 {
                        self.t.narrow.insert(own[0], 16);
                    }
                    // An inner loop's line is the same for vectorized iterations, or begins on a line of the outer one.
                    let across = match level {
                        Level::Outer => self.kernel.start_line(level, slot).unwrap_or(line),
                        Level::Inner => self.kernel.line(self.plan.entry(slot), Level::Outer).unwrap_or(Affine::SAME),
                    };
                    let value = if self.lanes > 1 && !across.is_same() { Lanes::Affine(value, across) } else { Lanes::One(value) };
                    self.scope(level).starts.insert(slot, value);
                }
                LoopCarried::Counted(node, line) => {
                    if line.bits == 16 {
                        self.t.narrow.insert(own[0], 16);
                    }
                    self.scope(level).values.insert(node, Lanes::One(Val::Int(own[0])));
                }
                LoopCarried::Sum(..) | LoopCarried::MinMax(..) => {}
                LoopCarried::Chain(slot, _, form) => {
                    let value = self.taken(slot, form, own);
                    self.scope(level).starts.insert(slot, value);
                }
                LoopCarried::Address(base, pointer, offset, _) => {
                    self.scope(level).addresses.insert((base, pointer, offset), own[0]);
                }
            }
        }
    }

    /// What was handed on of a slot.
    fn taken(&mut self, slot: Slot, form: Form, own: Vec<Value>) -> Lanes {
        match form {
            Form::Bit => Lanes::One(Val::Bit { value: own[0], clean: true }),
            Form::LooseBit => Lanes::One(Val::Bit { value: own[0], clean: false }),
            Form::Int => {
                // A word that iterations hand on is cut to its bits where it is written.
                let bits = if self.kernel.is_word(slot) { 16 } else { 32 };
                Lanes::One(self.t.know_bits(own[0], bits))
            }
            Form::Quad => Lanes::One(Val::Word(own[0])),
            Form::Lreal => {
                debug_assert_eq!(self.t.b.func.dfg.value_type(own[0]), F64);
                Lanes::One(self.t.quiet_f64(own[0]))
            }
            Form::Real => {
                let bits = self.t.b.ins().bitcast(I32, MemFlagsData::new(), own[0]);
                debug_assert_eq!(self.t.b.func.dfg.value_type(own[0]), F32);
                Lanes::One(Val::Real { real: own[0], bits })
            }
            Form::Exact(_) => Lanes::One(self.t.with_all_bits(own[0])),
            Form::Lanes(shape) => shape.of(own),
        }
    }

    /// What is handed on to the next iteration.
    pub(super) fn next_of(&mut self, level: Level, one: &LoopCarried, own: &[Value], all: &mut Vec<Value>) {
        match *one {
            LoopCarried::Affine(_, line) | LoopCarried::Counted(_, line) => {
                let iterations = if level == Level::Outer { self.lanes } else { 1 };
                let next = self.t.further(Val::Int(own[0]), line, iterations);
                all.push(self.t.int(next));
            }
            LoopCarried::Sum(_, added, Shape::Words) if let Some(factors) = self.kernel.factors_of_halves(added) => {
                let factors = factors.map(|factor| self.value(factor, level));
                let products = self.t.products_in_pairs(&factors, self.lanes);
                let sums = own.iter().enumerate().map(|(at, &sum)| match products.get(at) {
                    Some(&product) => self.t.b.ins().iadd(sum, product),
                    None => sum,
                });
                all.extend(sums);
            }
            LoopCarried::Sum(_, added, shape) => {
                let added = self.value(added, level);
                let mut vectors = Vec::new();
                self.in_form(&added, Form::Lanes(shape), &mut vectors);
                for (&sum, vector) in own.iter().zip(vectors) {
                    all.push(self.t.b.ins().iadd(sum, vector));
                }
            }
            LoopCarried::MinMax(_, other, extreme, shape) => {
                let other = self.value(other, level);
                let mut vectors = Vec::new();
                self.in_form(&other, Form::Lanes(shape), &mut vectors);
                for (&own, vector) in own.iter().zip(vectors) {
                    all.push(self.t.extreme_of_lanes(extreme, own, vector));
                }
            }
            LoopCarried::Chain(slot, end, form) => {
                let value = match self.kernel.in_order.slots.contains(&slot) {
                    true => Lanes::One(self.in_lane(end, self.lanes - 1)),
                    false => self.value(end, level),
                };
                self.in_form(&value, form, all);
            }
            LoopCarried::Address(.., step) => all.push(self.t.b.ins().iadd_imm_s(own[0], step)),
        }
    }
}
