//! Scalar values: expressions.

use sieben_engine::fault::lost;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Inst, Op, Target, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::arithmetic::opposite;
use super::{Label, Lowering, arguments, width};
use crate::st::standard::operators::fails_of_division;
use crate::st::tree::{Base, Bounds, Call, Place, Scalar, Text, Value, ValueKind};

/// Temporaries that may hold values before operands are spilled; one operation more never needs the rest.
const IN_USE_MAX: usize = 100;

/// What is lost if `failed` is true of an operation, and which operand says more about it.
fn what_is_lost(op: Op, failed: Op) -> (u8, usize) {
    match failed {
        // The same question is asked of what is no operand of a division.
        _ if fails_of_division(failed) && op != Op::Copy => (lost::QUOTIENT, 1),
        Op::OverflowsF32 | Op::OverflowsF64 => (lost::NO_NUMBER, 0),
        _ if op != Op::Copy => (lost::OVERFLOW, 0),
        _ => (lost::CONVERSION, 0),
    }
}

/// A value that waits for the operands behind it.
enum Held {
    Var(Var),
    Constant(u64),
    Hidden(u32, Width),
}

impl Lowering<'_> {
    /// A value in a temporary, which belongs to the caller; constants and BR too.
    pub(super) fn value(&mut self, value: &Value) -> Var {
        match &value.kind {
            ValueKind::Constant(bits) => self.constant(*bits),
            ValueKind::Load(place) => self.load(place, width(value.scalar)),
            ValueKind::Compute { op, args } => {
                let args = self.values(&args.iter().collect::<Vec<_>>());
                self.compute(*op, &args)
            }
            ValueKind::Checked { op, failed, args } => {
                let args = self.values(&args.iter().collect::<Vec<_>>());
                if self.ok.is_some() || self.body.tells_lost {
                    let lost = self.compute_from(*failed, &args[..failed.arity().min(args.len())]);
                    let (code, shown) = what_is_lost(*op, *failed);
                    self.lost_if(lost, code, args[shown.min(args.len() - 1)]);
                    self.release(lost);
                }
                self.compute(*op, &args[..op.arity().min(args.len())])
            }
            ValueKind::AndThen(a, b) => self.short_circuit(a, b, Op::And, false),
            ValueKind::OrElse(a, b) => self.short_circuit(a, b, Op::Or, true),
            ValueKind::Choose { condition, a, b } => self.choose(condition, a, b, width(value.scalar)),
            ValueKind::Call(call) => self.call_for_scalar(call, value.scalar),
            ValueKind::CompareTexts(a, b) => self.compare_texts(a, b),
            ValueKind::Length(text) => self.text_length(text),
            ValueKind::Ok => match self.ok {
                Some(ok) => self.load_local(ok, Width::Bit),
                None => self.constant(1),
            },
            ValueKind::Eno => self.compute_from(Op::Copy, &[Register::Br.into()]),
            ValueKind::AddressOf(place) => self.address_of(place, false),
            ValueKind::NumberParameter(index) => {
                let number = self.parameter(*index);
                self.compute(Op::Low16, &[number])
            }
            ValueKind::Intrinsic { intrinsic, args } => self.intrinsic(*intrinsic, args),
            ValueKind::After(statements, value) => {
                self.part();
                self.inner_statements(statements);
                self.value(value)
            }
        }
    }

    /// A function over the machine. One with a number (a timer, a counter) is a fault if the CPU does not have it.
    pub(super) fn intrinsic(&mut self, intrinsic: Intrinsic, args: &[Value]) -> Var {
        let args = self.values(&args.iter().collect::<Vec<_>>());
        self.fallible |= intrinsic.arity() > 0;
        for &arg in &args {
            self.release(arg);
        }
        let dst = self.temporary();
        self.push(Inst::Intrinsic { dst, intrinsic, args: arguments(&args) });
        dst
    }

    /// Several values, computed from left to right, all of them in temporaries at the end.
    pub(super) fn values(&mut self, values: &[&Value]) -> Vec<Var> {
        let mut held = Vec::with_capacity(values.len());
        for (index, value) in values.iter().enumerate() {
            if let ValueKind::Constant(bits) = value.kind {
                held.push(Held::Constant(bits));
                continue;
            }
            let var = self.value(value);
            let rest = &values[index + 1..];
            let crowded = self.is_crowded() && rest.iter().any(|value| !is_leaf(value));
            held.push(if crowded || rest.iter().any(|value| self.breaks(value)) {
                let position = self.spill(var, width(value.scalar));
                Held::Hidden(position, width(value.scalar))
            } else {
                Held::Var(var)
            });
        }
        held.into_iter()
            .map(|held| match held {
                Held::Var(var) => var,
                Held::Constant(bits) => self.constant(bits),
                Held::Hidden(position, width) => self.load_local(position, width),
            })
            .collect()
    }

    /// Whether values had better be spilled before more is computed.
    pub(super) fn is_crowded(&self) -> bool {
        self.in_use() > IN_USE_MAX
    }

    /// Puts a value into hidden local data; its position there.
    pub(super) fn spill(&mut self, var: Var, width: Width) -> u32 {
        let position = self.hidden.scalar(width);
        self.store_local(position, width, var);
        position
    }

    /// A value that does not change until the end of the source statement: a constant, or a copy in hidden local data.
    pub(super) fn keep(&mut self, value: &Value) -> Value {
        if matches!(value.kind, ValueKind::Constant(_)) {
            return value.clone();
        }
        let var = self.value(value);
        let position = self.spill(var, width(value.scalar));
        Value { kind: ValueKind::Load(local_place(position, value)), ..value.clone() }
    }

    fn short_circuit(&mut self, a: &Value, b: &Value, both: Op, decided: bool) -> Var {
        if self.is_simple(b) {
            let args = self.values(&[a, b]);
            return self.compute(both, &args);
        }
        let position = self.hidden.scalar(Width::Bit);
        let done = self.label();
        let first = self.value(a);
        self.push(Inst::Store { place: local_bits(position), width: Width::Bit, src: first });
        self.branch_on(first, done, decided);
        self.part();
        let second = self.value(b);
        self.store_local(position, Width::Bit, second);
        self.part();
        self.bind(done);
        self.load_local(position, Width::Bit)
    }

    fn choose(&mut self, condition: &Value, a: &Value, b: &Value, width: Width) -> Var {
        if self.is_simple(a) && self.is_simple(b) {
            let args = self.values(&[condition, a, b]);
            return self.compute(Op::Select, &args);
        }
        let position = self.hidden.scalar(width);
        let [otherwise, done] = [self.label(), self.label()];
        self.branch(condition, otherwise, false);
        self.part();
        let chosen = self.value(a);
        self.store_local(position, width, chosen);
        self.part();
        self.leave_to(done);
        self.bind(otherwise);
        let chosen = self.value(b);
        self.store_local(position, width, chosen);
        self.part();
        self.bind(done);
        self.load_local(position, width)
    }

    /// Goes to the label if the condition has this value; else on, in the same IR statement or a later one.
    pub(super) fn branch(&mut self, condition: &Value, to: Label, when: bool) {
        match &condition.kind {
            ValueKind::Constant(bits) => {
                if (bits & 1 != 0) == when {
                    // What failed before leaves out the rest of its source statement, the jump too.
                    self.part_if_fallible();
                    self.leave_to(to);
                }
            }
            ValueKind::Compute { op: Op::Not, args } if args.len() == 1 => self.branch(&args[0], to, !when),
            ValueKind::AndThen(a, b) => self.branch_short(a, b, to, when, false),
            ValueKind::OrElse(a, b) => self.branch_short(a, b, to, when, true),
            kind => {
                // A comparison that is to be false is one that is true.
                if let ValueKind::Compute { op, args } = kind
                    && !when
                    && let Some(op) = opposite(*op)
                {
                    let args = self.values(&args.iter().collect::<Vec<_>>());
                    let var = self.compute(op, &args);
                    self.branch_on(var, to, true);
                    return self.release(var);
                }
                let var = self.value(condition);
                self.branch_on(var, to, when);
                self.release(var);
            }
        }
    }

    /// `a` decides alone if it is `decided`.
    fn branch_short(&mut self, a: &Value, b: &Value, to: Label, when: bool, decided: bool) {
        if when == decided {
            self.branch(a, to, when);
            self.part_if_fallible();
            self.branch(b, to, when);
        } else {
            let skip = self.label();
            self.branch(a, skip, !when);
            self.part_if_fallible();
            self.branch(b, to, when);
            self.part_if_fallible();
            self.bind(skip);
        }
    }

    fn part_if_fallible(&mut self) {
        if self.fallible {
            self.part();
        }
    }

    /// Goes to the label if a bit has this value; the variable stays.
    pub(super) fn branch_on(&mut self, condition: Var, to: Label, when: bool) {
        let to = Target(to.0);
        if when {
            self.push(Inst::Branch { condition, to });
        } else {
            let opposite = self.compute_from(Op::Not, &[condition]);
            self.push(Inst::Branch { condition: opposite, to });
            self.release(opposite);
        }
    }

    /// Whether computing a value may begin a new IR statement, at which temporaries end.
    pub(super) fn breaks(&self, value: &Value) -> bool {
        match &value.kind {
            ValueKind::Constant(_) | ValueKind::NumberParameter(_) | ValueKind::Ok | ValueKind::Eno => false,
            ValueKind::Load(place) | ValueKind::AddressOf(place) => self.place_breaks(place),
            ValueKind::Compute { args, .. } | ValueKind::Checked { args, .. } | ValueKind::Intrinsic { args, .. } => {
                args.iter().any(|arg| self.breaks(arg))
            }
            ValueKind::AndThen(a, b) | ValueKind::OrElse(a, b) => self.breaks(a) || !self.is_simple(b),
            ValueKind::Choose { condition, a, b } => self.breaks(condition) || !self.is_simple(a) || !self.is_simple(b),
            ValueKind::Call(_) | ValueKind::After(..) => true,
            ValueKind::CompareTexts(a, b) => self.text_breaks(a) || self.text_breaks(b),
            ValueKind::Length(text) => self.text_breaks(text),
        }
    }

    pub(super) fn text_breaks(&self, text: &Text) -> bool {
        match text {
            Text::Constant(_) | Text::WideConstant(_) => false,
            Text::Converted(text) => self.text_breaks(text),
            Text::Place { place, .. } => self.place_breaks(place),
            Text::Character(value) => self.breaks(value),
            Text::Call { .. } | Text::After(..) => true,
        }
    }

    pub(super) fn place_breaks(&self, place: &Place) -> bool {
        let base = match &place.base {
            Base::ComputedDataBlock(value) | Base::Reference(value) => self.breaks(value),
            _ => false,
        };
        base || place.indexes.iter().any(|index| self.breaks(&index.value))
    }

    /// Whether nobody can tell if a value was computed or not: it cannot fail, and nothing else comes of it.
    fn is_simple(&self, value: &Value) -> bool {
        match &value.kind {
            ValueKind::Constant(_) | ValueKind::Ok | ValueKind::Eno => true,
            ValueKind::Load(place) => self.is_simple_place(place),
            ValueKind::Compute { args, .. } => args.iter().all(|arg| self.is_simple(arg)),
            ValueKind::Checked { args, .. } => self.ok.is_none() && !self.body.tells_lost && args.iter().all(|arg| self.is_simple(arg)),
            ValueKind::AndThen(a, b) | ValueKind::OrElse(a, b) => self.is_simple(a) && self.is_simple(b),
            ValueKind::Choose { condition, a, b } => self.is_simple(condition) && self.is_simple(a) && self.is_simple(b),
            _ => false,
        }
    }

    fn is_simple_place(&self, place: &Place) -> bool {
        let base = match &place.base {
            Base::Area(area) => !matches!(area, Area::PeripheralInput | Area::PeripheralOutput),
            Base::DataBlock(_) | Base::Instance | Base::Parameter(_) => true,
            Base::ComplexParameter(_) | Base::InstancePointer(_) | Base::ComputedDataBlock(_) | Base::Reference(_) => false,
        };
        base && place.indexes.iter().all(|index| {
            // An index that is not looked at may lead anywhere.
            let inside = matches!(index.check, Bounds::Clamp) || index.check == Bounds::None && index.count != 0;
            inside && self.is_simple(&index.value)
        })
    }

    fn call_for_scalar(&mut self, call: &Call, scalar: Scalar) -> Var {
        self.call(call);
        match self.result.take() {
            Some(position) => self.load_local(position, width(scalar)),
            None => self.constant(0),
        }
    }
}

/// Whether a value needs one temporary at most.
fn is_leaf(value: &Value) -> bool {
    match &value.kind {
        ValueKind::Constant(_) => true,
        ValueKind::Load(place) => place.indexes.is_empty() && matches!(place.base, Base::Area(_) | Base::Instance | Base::DataBlock(_)),
        _ => false,
    }
}

/// The place of a value in hidden local data.
pub(super) fn local_place(position: u32, value: &Value) -> Place {
    Place { base: Base::Area(Area::Local), offset: position, indexes: Vec::new(), span: value.span }
}

fn local_bits(position: u32) -> sieben_engine::ir::Place {
    sieben_engine::ir::Place::Fixed { area: Area::Local, position }
}
