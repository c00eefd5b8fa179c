//! What a loop hands from turn to turn, and in which form.

use std::collections::BTreeSet;

use cranelift_codegen::ir::types::{F32, F64, I32};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Type, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::promote::Base;
use super::super::value::Val;
use super::super::{Translator, is_bit};
use super::extremes::Extreme;
use super::kernel::{Access, Cell, Kept, Level, Node, Step, What};
use super::line::{Carried, Line, Shape};
use super::vector::Lanes;
use super::write::Writing;

/// How many values on lines more than cells are counted on.
const COUNTED_MORE: usize = 2;

/// What a loop hands from turn to turn, and how.
pub(super) enum Handed {
    Line(Cell, Line),
    /// A value on a line that is no cell.
    Counted(Node, Line),
    /// A sum: its vectors.
    Sum(Cell, Node, Shape),
    /// The least or greatest numbers: their vectors.
    Extreme(Cell, Node, Extreme, Shape),
    Chain(Cell, Node, Form),
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

impl Writing<'_, '_, '_> {
    /// What a loop hands from turn to turn.
    pub(super) fn handed(&mut self, level: Level) -> Vec<Handed> {
        let kernel = self.kernel;
        let carried = kernel.carried(level);
        let mut needed = kernel.needed(level, &|cell| kernel.cell_line(level, cell).is_none());
        // What is left behind the last turn may rest on what a turn began with.
        let mut ends: BTreeSet<Node> = BTreeSet::new();
        for (_, end, carried) in &carried {
            match carried {
                Carried::Line(_) if level == Level::Outer => {}
                Carried::Sum { added, .. } => kernel.rests(*added, &mut ends),
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
        let mut handed: Vec<Handed> =
            counted.iter().flatten().map(|&node| Handed::Counted(node, kernel.line(node, level).unwrap_or(Line::SAME))).collect();
        for (cell, end, carried) in carried {
            let looked_at = needed.iter().any(|&node| kernel.is_start(node, level, cell));
            match carried {
                Carried::Line(line) if looked_at && !line.is_same() && counted.is_none() => handed.push(Handed::Line(cell, line)),
                Carried::Line(_) | Carried::Nothing => {}
                Carried::Chain if self.lanes > 1 && kernel.in_order.cells.contains(&cell) => {
                    handed.push(Handed::Chain(cell, end, self.form_in_order(cell)));
                }
                Carried::Sum { added, bits } if self.lanes > 1 && level == Level::Outer => {
                    handed.push(Handed::Sum(cell, added, Shape::of_bits(bits)));
                }
                Carried::Extreme { extreme, other, bits } if self.lanes > 1 => {
                    handed.push(Handed::Extreme(cell, other, extreme, Shape::of_bits(bits)));
                }
                Carried::Sum { .. } | Carried::Extreme { .. } | Carried::Chain => {
                    let form = self.form(level, cell, end, &needed);
                    if let Form::Exact(ty) = form {
                        self.extremes.extend(kernel.extremes_of_reals(end, ty));
                    }
                    handed.push(Handed::Chain(cell, end, form));
                }
            }
        }
        let step_of = |access: &Access| self.plan.counted_on(access, level);
        let mut known: Vec<(Base, Node, u32)> = Vec::new();
        let ends = kernel.copies.iter().flat_map(|copied| [&copied.from, &copied.to]).filter(|end| kernel.is_counted_end(end, level));
        let of_steps = kernel.turn(level).steps.iter().filter_map(|step| match *step {
            Step::Access(access) => Some(&kernel.accesses[access]),
            Step::Copy(_) | Step::Inner => None,
        });
        for access in of_steps.chain(ends) {
            if let Some(step) = step_of(access)
                && !known.contains(&access.counted())
            {
                let (base, pointer, offset) = access.counted();
                known.push((base, pointer, offset));
                let turns = if level == Level::Outer { self.lanes } else { 1 };
                handed.push(Handed::Address(base, pointer, offset, Translator::bytes_of_step(step, turns)));
            }
        }
        handed
    }

    /// The values on lines with which the others of a turn are computed, if turns are made one by one: each is counted on, so that a turn
    /// does not compute it anew.
    fn counted(&self, level: Level, carried: &[(Cell, Node, Carried)]) -> Option<BTreeSet<Node>> {
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
            if let Step::Copy(number) = *step {
                waiting.extend(kernel.nodes_of_copy(number, level));
            }
        }
        for &(_, end, carried) in carried {
            match carried {
                Carried::Line(_) => {}
                Carried::Sum { added, .. } => waiting.push(added),
                // It is computed behind the loop.
                Carried::Nothing if kernel.line(end, level).is_some() => {}
                _ => waiting.push(end),
            }
        }
        let grows = |node: Node| kernel.line(node, level).is_some_and(|line| !line.is_same());
        let mut seen = BTreeSet::new();
        while let Some(node) = waiting.pop() {
            if seen.insert(node)
                && !grows(node)
                && let What::Compute(op, args) = kernel.what(node)
            {
                waiting.extend(&args[..op.arity()]);
            }
        }
        let mut counted: BTreeSet<Node> = seen.into_iter().filter(|&node| grows(node)).collect();
        // What one operation makes of another one of them costs as little.
        for node in counted.clone() {
            if let What::Compute(op, args) = kernel.what(node)
                && args[..op.arity()].iter().all(|arg| counted.contains(arg) || !grows(*arg))
            {
                counted.remove(&node);
            }
        }
        let cells = carried.iter().filter(|(.., carried)| matches!(carried, Carried::Line(line) if !line.is_same())).count();
        (counted.len() <= cells + COUNTED_MORE).then_some(counted)
    }

    fn form(&self, level: Level, cell: Cell, end: Node, needed: &BTreeSet<Node>) -> Form {
        if self.lanes > 1 {
            return self.kernel.shape(self.kernel.turn(level).ends[&cell]).map_or(Form::Int, Form::Lanes);
        }
        if let Kept::Register(register) = self.kernel.kept(cell)
            && is_bit(register)
        {
            return Form::Bit;
        }
        if matches!(self.kernel.kept(cell), Kept::Memory { width: Width::Bit, .. }) {
            return Form::Bit;
        }
        if matches!(self.kernel.kept(cell), Kept::Ahead { width: Width::Bit, .. }) {
            return Form::LooseBit;
        }
        let wide = self.kernel.kept(cell).is_wide();
        let real = |op: Op| match wide {
            true => matches!(op, Op::AddF64 | Op::SubF64 | Op::MulF64 | Op::DivF64 | Op::MinF64 | Op::MaxF64),
            false => matches!(op, Op::AddF32 | Op::SubF32 | Op::MulF32 | Op::DivF32 | Op::MinF32 | Op::MaxF32),
        };
        let compares = |op: Op| match wide {
            true => matches!(op, Op::EqF64 | Op::LtF64 | Op::LeF64 | Op::GtF64 | Op::GeF64 | Op::DifferF64),
            false => matches!(op, Op::EqF32 | Op::LtF32 | Op::LeF32 | Op::GtF32 | Op::GeF32 | Op::DifferF32),
        };
        let is_real = matches!(self.kernel.what(end), What::Compute(op, _) if real(op));
        let ty = if wide { F64 } else { F32 };
        let extremes = self.kernel.extremes_of_reals(end, ty);
        let others = needed.iter().any(|&node| match self.kernel.what(node) {
            What::Compute(op, _) if real(op) || compares(op) || extremes.contains(&node) => false,
            What::Compute(op, args) => args[..op.arity()].iter().any(|&arg| self.kernel.is_start(arg, level, cell)),
            _ => false,
        });
        if !extremes.is_empty() && !others {
            return Form::Exact(ty);
        }
        let written = self.kernel.accesses.iter().filter_map(|access| access.value).any(|value| self.kernel.is_start(value, level, cell));
        let handed_on = self.kernel.all_ends().any(|end| self.kernel.is_start(end, level, cell));
        match (is_real && !others && !written && !handed_on, wide) {
            (true, false) => Form::Real,
            (true, true) => Form::Lreal,
            (false, false) => Form::Int,
            (false, true) => Form::Quad,
        }
    }

    pub(super) fn count_of(&self, one: &Handed) -> usize {
        match one {
            Handed::Line(..) | Handed::Counted(..) | Handed::Address(..) => 1,
            Handed::Sum(.., shape) | Handed::Extreme(.., shape) | Handed::Chain(.., Form::Lanes(shape)) => {
                shape.vectors(self.lanes).1 as usize
            }
            Handed::Chain(..) => 1,
        }
    }

    /// The parameters of each thing that is handed on.
    pub(super) fn owned(&self, handed: &[Handed], parameters: &[Value]) -> Vec<Vec<Value>> {
        let mut at = 0;
        let mut owned = Vec::new();
        for one in handed {
            let count = self.count_of(one);
            owned.push(parameters[at..at + count].to_vec());
            at += count;
        }
        owned
    }

    pub(super) fn first_of(&mut self, level: Level, one: &Handed, all: &mut Vec<Value>) {
        match *one {
            Handed::Line(cell, _) => {
                let value = match self.entry(level, cell) {
                    Lanes::One(value) | Lanes::Line(value, _) => value,
                    _ => unreachable!("what begins a line is on one"),
                };
                all.push(self.t.int(value));
            }
            Handed::Counted(node, _) => {
                let value = self.value_before(node);
                all.push(self.t.int(value));
            }
            Handed::Sum(_, _, shape) => {
                let (ty, count) = shape.vectors(self.lanes);
                for _ in 0..count {
                    all.push(self.t.zeros(ty));
                }
            }
            Handed::Extreme(cell, _, _, shape) => {
                let value = self.entry(level, cell);
                self.in_form(&value, Form::Lanes(shape), all);
            }
            Handed::Chain(cell, _, form) => {
                let value = self.entry(level, cell);
                self.in_form(&value, form, all);
            }
            Handed::Address(base, pointer, offset, _) => {
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
            _ => unreachable!("one turn has one value"),
        };
        match form {
            Form::Bit => all.push(self.t.flag(one(value))),
            Form::LooseBit => all.push(self.t.bit(one(value))),
            Form::Int => all.push(self.t.int(one(value))),
            Form::Real => all.push(self.t.f32(one(value))),
            Form::Quad => all.push(self.t.word(one(value))),
            Form::Lreal => all.push(self.t.f64(one(value))),
            Form::Exact(ty) => all.push(self.t.exact(one(value), ty)),
            Form::Lanes(Shape::Quads) => all.extend(self.t.quads(value, self.lanes)),
            Form::Lanes(Shape::Lreals) => all.extend(self.t.lreals(value, self.lanes)),
            Form::Lanes(Shape::Halves) => all.extend(self.t.halves(value, self.lanes)),
            Form::Lanes(Shape::Reals) => all.extend(self.t.reals(value, self.lanes)),
            Form::Lanes(_) => all.extend(self.t.words(value, self.lanes)),
        }
    }

    /// Takes what was handed on.
    pub(super) fn begin(&mut self, level: Level, handed: &[Handed], parameters: &[Value]) {
        for (one, own) in handed.iter().zip(self.owned(handed, parameters)) {
            match *one {
                Handed::Line(cell, line) => {
                    let value = Val::Int(own[0]);
                    if line.bits == 16 {
                        self.t.narrow.insert(own[0], 16);
                    }
                    // An inner loop's line is the same for turns side by side, or begins on a line of the outer one.
                    let across = match level {
                        Level::Outer => self.kernel.start_line(level, cell).unwrap_or(line),
                        Level::Inner => self.kernel.line(self.plan.entry(cell), Level::Outer).unwrap_or(Line::SAME),
                    };
                    let value = if self.lanes > 1 && !across.is_same() { Lanes::Line(value, across) } else { Lanes::One(value) };
                    self.scope(level).starts.insert(cell, value);
                }
                Handed::Counted(node, line) => {
                    if line.bits == 16 {
                        self.t.narrow.insert(own[0], 16);
                    }
                    self.scope(level).values.insert(node, Lanes::One(Val::Int(own[0])));
                }
                Handed::Sum(..) | Handed::Extreme(..) => {}
                Handed::Chain(cell, _, form) => {
                    let value = self.taken(cell, form, own);
                    self.scope(level).starts.insert(cell, value);
                }
                Handed::Address(base, pointer, offset, _) => {
                    self.scope(level).addresses.insert((base, pointer, offset), own[0]);
                }
            }
        }
    }

    /// What was handed on of a cell.
    fn taken(&mut self, cell: Cell, form: Form, own: Vec<Value>) -> Lanes {
        match form {
            Form::Bit => Lanes::One(Val::Bit { value: own[0], clean: true }),
            Form::LooseBit => Lanes::One(Val::Bit { value: own[0], clean: false }),
            Form::Int => {
                // A word that turns hand on is cut to its bits where it is written.
                let bits = if self.kernel.is_word(cell) { 16 } else { 32 };
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

    /// What is handed on to the next turn.
    pub(super) fn next_of(&mut self, level: Level, one: &Handed, own: &[Value], all: &mut Vec<Value>) {
        match *one {
            Handed::Line(_, line) | Handed::Counted(_, line) => {
                let turns = if level == Level::Outer { self.lanes } else { 1 };
                let next = self.t.further(Val::Int(own[0]), line, turns);
                all.push(self.t.int(next));
            }
            Handed::Sum(_, added, Shape::Words) if let Some(factors) = self.kernel.factors_of_halves(added) => {
                let factors = factors.map(|factor| self.value(factor, level));
                let products = self.t.products_in_pairs(&factors, self.lanes);
                let sums = own.iter().enumerate().map(|(at, &sum)| match products.get(at) {
                    Some(&product) => self.t.b.ins().iadd(sum, product),
                    None => sum,
                });
                all.extend(sums);
            }
            Handed::Sum(_, added, shape) => {
                let added = self.value(added, level);
                let mut vectors = Vec::new();
                self.in_form(&added, Form::Lanes(shape), &mut vectors);
                for (&sum, vector) in own.iter().zip(vectors) {
                    all.push(self.t.b.ins().iadd(sum, vector));
                }
            }
            Handed::Extreme(_, other, extreme, shape) => {
                let other = self.value(other, level);
                let mut vectors = Vec::new();
                self.in_form(&other, Form::Lanes(shape), &mut vectors);
                for (&own, vector) in own.iter().zip(vectors) {
                    all.push(self.t.extreme_of_lanes(extreme, own, vector));
                }
            }
            Handed::Chain(cell, end, form) => {
                let value = match self.kernel.in_order.cells.contains(&cell) {
                    true => Lanes::One(self.in_lane(end, self.lanes - 1)),
                    false => self.value(end, level),
                };
                self.in_form(&value, form, all);
            }
            Handed::Address(.., step) => all.push(self.t.b.ins().iadd_imm_s(own[0], step)),
        }
    }
}
