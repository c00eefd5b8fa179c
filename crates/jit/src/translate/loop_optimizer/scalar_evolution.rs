//! Scalar evolution: which values of a loop are affine, which slots are loop-carried, and which form a value has in vectorized iterations.

use std::collections::{BTreeSet, HashMap};

use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::kernel::{Definition, Effect, Iteration, Kernel, Level, Node, Slot, SlotKind};
use super::min_max_reduction::MinMax;
use super::trip_count::is_unsigned;
use super::vector_division::greatest;

/// A value that grows by the same step in each iteration, modulo 2 to the power of `bits`; zero-extended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Affine {
    pub(super) step: u32,
    pub(super) bits: u32,
}

impl Affine {
    pub(super) const SAME: Self = Self { step: 0, bits: 32 };

    pub(super) fn is_same(self) -> bool {
        self.step == 0
    }

    fn halves(step: u32) -> Self {
        Self { step: step & 0xFFFF, bits: 16 }
    }
}

/// What a value is for vectorized iterations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// On a line, or the same in all of them.
    Affine(Affine),
    /// Numbers of 16 bits.
    Halves,
    /// Numbers of 32 bits.
    Words,
    /// REALs.
    Reals,
    /// Numbers of 64 bits.
    Wide,
    /// LREALs.
    Lreals,
    /// Bits, each as 32 that are all like it.
    Mask,
}

impl Shape {
    /// That of numbers of so many bits.
    pub(super) fn of_bits(bits: u32) -> Self {
        if bits == 16 { Self::Halves } else { Self::Words }
    }
}

/// How a slot is carried from iteration to iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Recurrence {
    /// On a line.
    Affine(Affine),
    /// It grows by a value that does not depend on it, and nothing else looks at it: modulo 2 to the power of `bits`.
    Sum { added: Node, bits: u32 },
    /// It keeps the least or the greatest of what it was and a value that does not depend on it, as numbers of so many bits, and nothing
    /// else looks at it.
    MinMax { extreme: MinMax, other: Node, bits: u32 },
    /// Each iteration needs what the one before left.
    Chain,
    /// No iteration looks at what the one before left.
    Nothing,
}

/// A slot that grows by a value in each iteration, modulo 2 to the power of `bits`.
#[derive(Clone, Copy, Debug)]
pub(super) struct AddReduction {
    pub(super) of: Slot,
    pub(super) added: Node,
    pub(super) bits: u32,
}

impl Kernel {
    /// The line on which a value lies from iteration to iteration of a loop.
    pub(super) fn line(&self, node: Node, level: Level) -> Option<Affine> {
        let known = self.lines.borrow().get(&(node, level)).copied();
        known.unwrap_or_else(|| {
            let line = self.line_of(node, level);
            self.lines.borrow_mut().insert((node, level), line);
            line
        })
    }

    fn line_of(&self, node: Node, level: Level) -> Option<Affine> {
        match self.what(node) {
            Definition::Constant(_) => Some(Affine::SAME),
            Definition::Start(of, slot) if of == level => self.start_line(level, slot),
            Definition::Start(Level::Outer, _) => Some(Affine::SAME),
            // The inner loop is the same for all iterations of the outer one as far as where it begins.
            Definition::Start(Level::Inner, slot) => {
                self.slot_line(Level::Inner, slot)?;
                self.line(*self.inner.as_ref()?.entry.get(&slot)?, level)
            }
            Definition::After(_) | Definition::Read(_) => None,
            Definition::Compute(op, args) => self.line_of_result(op, args, level),
        }
    }

    fn line_of_result(&self, op: Op, args: [Node; 4], level: Level) -> Option<Affine> {
        let mut lines = [Affine::SAME; 4];
        for (line, &arg) in lines.iter_mut().zip(&args[..op.arity()]) {
            *line = self.line(arg, level)?;
        }
        if lines.iter().all(|line| line.is_same()) {
            return Some(Affine::SAME);
        }
        let [a, b, ..] = lines;
        let factor = |at: usize| self.constant(args[at]).map(|factor| factor as u32);
        let whole = a.bits == 32 && b.bits == 32;
        match op {
            Op::AddU32 if whole => Some(Affine { step: a.step.wrapping_add(b.step), bits: 32 }),
            Op::SubU32 if whole => Some(Affine { step: a.step.wrapping_sub(b.step), bits: 32 }),
            Op::MulU32 if whole && b.is_same() => factor(1).map(|factor| Affine { step: a.step.wrapping_mul(factor), bits: 32 }),
            Op::MulU32 if whole && a.is_same() => factor(0).map(|factor| Affine { step: b.step.wrapping_mul(factor), bits: 32 }),
            Op::Shl32 if whole && b.is_same() => {
                factor(1).filter(|&count| count < 32).map(|count| Affine { step: a.step << count, bits: 32 })
            }
            Op::AddU16 => Some(Affine::halves(a.step.wrapping_add(b.step))),
            Op::SubU16 => Some(Affine::halves(a.step.wrapping_sub(b.step))),
            Op::MulU16 if b.is_same() => factor(1).map(|factor| Affine::halves(a.step.wrapping_mul(factor))),
            Op::MulU16 if a.is_same() => factor(0).map(|factor| Affine::halves(b.step.wrapping_mul(factor))),
            Op::Low16 | Op::Decrement16 => Some(Affine::halves(a.step)),
            Op::Low32 => Some(a),
            // The counter of a loop does not leave its type while iterations follow: see `count`.
            Op::Extend16 if self.is_counter(args[0], level) => Some(Affine { step: i32::from(a.step as u16 as i16) as u32, bits: 32 }),
            _ => None,
        }
    }

    /// The line on which lies what a slot holds when an iteration begins. A counter without sign does not leave its type while iterations
    /// follow: see `count`.
    pub(super) fn start_line(&self, level: Level, slot: Slot) -> Option<Affine> {
        let line = self.slot_line(level, slot)?;
        let Some((op, [counter, ..])) = self.compared(level) else { return Some(line) };
        let is_counter = level == Level::Outer && is_unsigned(op) && self.iteration(level).ends.get(&slot) == Some(&counter);
        let widened = is_counter && line.bits == 16;
        Some(if widened { Affine { step: i32::from(line.step as u16 as i16) as u32, bits: 32 } } else { line })
    }

    /// Whether a value is what the slot holds when an iteration begins whose end decides, as an INT, whether another iteration follows.
    fn is_counter(&self, node: Node, level: Level) -> bool {
        let (Definition::Start(of, slot), Some((op, [counter, ..]))) = (self.what(node), self.compared(level)) else { return false };
        let counts = matches!(op, Op::LeI16 | Op::LtI16 | Op::GeI16 | Op::GtI16 | Op::Differ | Op::NeI16);
        of == level && counts && self.iteration(level).ends.get(&slot) == Some(&counter)
    }

    /// Whether a value is the same in all iterations of the outer loop.
    pub(super) fn is_same_in_all_iterations(&self, node: Node) -> bool {
        self.line(node, Level::Outer).is_some_and(|line| line.is_same())
    }

    /// Whether all conditions that are looked at before the loop are the same in all iterations.
    pub(super) fn settles_in_front(&self) -> bool {
        self.settled.iter().all(|&(condition, _)| self.is_same_in_all_iterations(condition))
    }

    /// Whether a value is the same in all iterations of the inner loop.
    pub(super) fn is_fixed(&self, node: Node, known: &mut HashMap<Node, bool>) -> bool {
        if let Some(&fixed) = known.get(&node) {
            return fixed;
        }
        let fixed = match self.what(node) {
            Definition::Constant(_) | Definition::Start(Level::Outer, _) => true,
            Definition::Start(Level::Inner, _) | Definition::After(_) => false,
            Definition::Read(access) => self.accesses[access].level == Level::Outer,
            Definition::Compute(op, args) => args[..op.arity()].iter().all(|&arg| self.is_fixed(arg, known)),
        };
        known.insert(node, fixed);
        fixed
    }

    /// Whether a value is affine as a number of 32 bits.
    pub(super) fn is_on_line(&self, node: Node, level: Level) -> bool {
        self.line(node, level).is_some_and(|line| line.bits == 32)
    }

    /// The line of a slot, if it is what the slot held before plus a constant.
    pub(super) fn slot_line(&self, level: Level, slot: Slot) -> Option<Affine> {
        let Some(&end) = self.iteration(level).ends.get(&slot) else { return Some(Affine::SAME) };
        // Nobody knows what it is before it is read.
        if matches!(self.kept(slot), SlotKind::Ahead { .. }) {
            return None;
        }
        if self.is_start(end, level, slot) {
            return Some(Affine::SAME);
        }
        if self.kept(slot).is_wide() {
            return None;
        }
        let Definition::Compute(op, [a, b, ..]) = self.what(end) else { return None };
        let step =
            |own: Node, other: Node| if self.is_start(own, level, slot) { self.constant(other).map(|step| step as u32) } else { None };
        let low = |node: Node| match self.what(node) {
            Definition::Compute(Op::Low16, [of, ..]) => of,
            _ => node,
        };
        match op {
            Op::AddU32 => step(a, b).or_else(|| step(b, a)).map(|step| Affine { step, bits: 32 }),
            Op::SubU32 => step(a, b).map(|step| Affine { step: step.wrapping_neg(), bits: 32 }),
            Op::AddU16 => step(low(a), b).or_else(|| step(low(b), a)).map(Affine::halves),
            Op::SubU16 => step(low(a), b).map(|step| Affine::halves(step.wrapping_neg())),
            Op::Decrement16 if self.is_start(low(a), level, slot) => Some(Affine::halves(u32::MAX)),
            _ => None,
        }
    }

    /// Values that an iteration of a loop cannot do without, in no order: what it writes to memory and where, whether another iteration
    /// follows, and what it hands on. Pointers on a line are counted on beside it.
    pub(super) fn needed(&self, level: Level, carried: &dyn Fn(Slot) -> bool) -> BTreeSet<Node> {
        let mut needed = BTreeSet::new();
        let mut waiting = Vec::new();
        for step in &self.iteration(level).steps {
            match step {
                Effect::Access(access) => {
                    let access = &self.accesses[*access];
                    waiting.extend(access.value);
                    if self.counted_on(access, level).is_none() {
                        waiting.push(access.pointer);
                    }
                }
                Effect::Copy(copied) => waiting.extend(self.nodes_of_copy(*copied, level)),
                Effect::Inner => {
                    if let Some(inner) = &self.inner {
                        // With what its slots begin that it does not carry is reached from those at which it looks.
                        waiting.extend(self.carried_into(inner).map(|(_, entry)| entry));
                        let all = |_: Slot| true;
                        waiting.extend(self.needed(Level::Inner, &all));
                        // What addresses in the inner loop begin with.
                        for step in &inner.steps {
                            if let Effect::Access(access) = step {
                                waiting.push(self.accesses[*access].pointer);
                            }
                        }
                    }
                }
            }
        }
        loop {
            while let Some(node) = waiting.pop() {
                if !needed.insert(node) {
                    continue;
                }
                match self.what(node) {
                    Definition::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                    // What the inner loop makes of it may rest on what an iteration of the outer one began with.
                    Definition::After(slot) | Definition::Start(Level::Inner, slot) if level == Level::Outer => {
                        let inner = self.inner.iter();
                        waiting.extend(inner.flat_map(|inner| [inner.ends.get(&slot), inner.entry.get(&slot)]).flatten());
                    }
                    _ => {}
                }
            }
            for (&slot, &end) in &self.iteration(level).ends {
                let start = needed.iter().any(|&node| self.is_start(node, level, slot));
                if start && carried(slot) && !needed.contains(&end) {
                    waiting.push(end);
                }
            }
            if waiting.is_empty() {
                return needed;
            }
        }
    }

    /// Slots that the iterations of the inner loop hand on, and what they hold when it begins.
    fn carried_into(&self, inner: &Iteration) -> impl Iterator<Item = (Slot, Node)> {
        let carried = self.carried(Level::Inner).into_iter().filter(|(.., carried)| *carried != Recurrence::Nothing);
        carried.filter_map(|(slot, ..)| Some((slot, *inner.entry.get(&slot)?)))
    }

    /// How the slots of a loop are carried.
    pub(super) fn carried(&self, level: Level) -> Vec<(Slot, Node, Recurrence)> {
        let iteration = self.iteration(level);
        let needed = self.needed(level, &|slot| self.slot_line(level, slot).is_none());
        let slots = iteration.ends.iter().map(|(&slot, &end)| {
            if let Some(line) = self.slot_line(level, slot) {
                return (slot, end, Recurrence::Affine(line));
            }
            if let Some((added, bits)) = self.sum(level, slot, end) {
                return (slot, end, Recurrence::Sum { added, bits });
            }
            if let Some((extreme, other, bits)) = self.extreme(level, slot, end) {
                return (slot, end, Recurrence::MinMax { extreme, other, bits });
            }
            let inspected = needed.iter().any(|&node| self.is_start(node, level, slot))
                || iteration.ends.values().any(|&end| self.rests_on(end, level, slot));
            (slot, end, if inspected { Recurrence::Chain } else { Recurrence::Nothing })
        });
        slots.collect()
    }

    /// What is added to a slot in each iteration, if nothing else looks at the slot.
    fn sum(&self, level: Level, slot: Slot, end: Node) -> Option<(Node, u32)> {
        let Definition::Compute(op @ (Op::AddU32 | Op::AddU16), [a, b, ..]) = self.what(end) else { return None };
        if self.kept(slot).is_wide() {
            return None;
        }
        let added = match () {
            () if self.is_start(a, level, slot) => b,
            () if self.is_start(b, level, slot) => a,
            () => return None,
        };
        self.is_only_added(level, slot, added).then_some((added, if op == Op::AddU16 { 16 } else { 32 }))
    }

    /// Whether nothing looks at what a slot holds when an iteration begins but what makes of it and of another value what it holds at the
    /// end.
    pub(super) fn is_only_added(&self, level: Level, slot: Slot, added: Node) -> bool {
        let is_left = |other: Slot, end: Node| self.is_start(end, level, slot) && self.is_left_only(level, other);
        let others = self.iteration(level).ends.iter().filter(|&(&other, &end)| other != slot && !is_left(other, end)).map(|(_, &end)| end);
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let entries = self.inner.iter().flat_map(|inner| inner.entry.values().chain(inner.ends.values()).copied());
        let mut all = others.chain(of_accesses).chain(self.of_copies()).chain(entries).chain([added, self.iteration(level).again]);
        !all.any(|node| self.rests_on(node, level, slot))
    }

    /// Whether nothing in the next iteration looks at what an iteration leaves in a slot.
    fn is_left_only(&self, level: Level, slot: Slot) -> bool {
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let iteration = self.iteration(level);
        let mut all = iteration.ends.values().copied().chain(of_accesses).chain(self.of_copies()).chain([iteration.again]);
        self.inner.is_none() && !all.any(|node| self.rests_on(node, level, slot))
    }

    /// The sum that a value is what it was when an iteration begins.
    pub(super) fn sum_at_start(&self, node: Node) -> Option<AddReduction> {
        let Definition::Start(Level::Outer, of) = self.what(node) else { return None };
        let (added, bits) = self.sum(Level::Outer, of, *self.outer.ends.get(&of)?)?;
        self.slot_line(Level::Outer, of).is_none().then_some(AddReduction { of, added, bits })
    }

    /// Whether a value rests on what a slot holds when an iteration begins.
    pub(super) fn rests_on(&self, node: Node, level: Level, slot: Slot) -> bool {
        let mut seen = BTreeSet::new();
        let mut waiting = vec![node];
        while let Some(node) = waiting.pop() {
            if self.is_start(node, level, slot) {
                return true;
            }
            if seen.insert(node) {
                match self.what(node) {
                    Definition::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                    Definition::After(after) => {
                        if let Some(inner) = &self.inner {
                            waiting.extend(inner.ends.get(&after).into_iter().chain(inner.entry.get(&after)));
                        }
                    }
                    Definition::Start(Level::Inner, start) => {
                        if let Some(inner) = &self.inner {
                            waiting.extend(inner.ends.get(&start).into_iter().chain(inner.entry.get(&start)));
                        }
                    }
                    Definition::Read(access) => waiting.push(self.accesses[access].pointer),
                    Definition::Constant(_) | Definition::Start(Level::Outer, _) => {}
                }
            }
        }
        false
    }

    /// The form of a value when iterations of the outer loop are done side by side; `None` if it has none.
    pub(super) fn shape(&self, node: Node) -> Option<Shape> {
        let known = self.shapes.borrow().get(&node).copied();
        known.unwrap_or_else(|| {
            let shape = self.shape_of(node);
            self.shapes.borrow_mut().insert(node, shape);
            shape
        })
    }

    fn shape_of(&self, node: Node) -> Option<Shape> {
        if let Some(line) = self.line(node, Level::Outer) {
            return Some(Shape::Affine(line));
        }
        if self.in_order.nodes.contains(&node) {
            return Some(self.shape_by_width(node));
        }
        match self.what(node) {
            Definition::Constant(_) => None,
            Definition::Start(Level::Outer, _) => None,
            Definition::Start(Level::Inner, slot) | Definition::After(slot) => self.shape_of_inner(slot),
            Definition::Read(access) => {
                let access = &self.accesses[access];
                let line = match self.shape(access.pointer)? {
                    Shape::Affine(line) if line.bits == 32 => line,
                    _ if self.is_gathered(access) => return Some(self.shape_by_width(node)),
                    _ => return None,
                };
                match access.width {
                    _ if line.is_same() => Some(Shape::Affine(Affine::SAME)),
                    Width::Bit if self.is_row_of_bits(access) => Some(Shape::Mask),
                    Width::Word if line.step == 16 => Some(Shape::Halves),
                    Width::DoubleWord if line.step == 32 => Some(Shape::Words),
                    Width::QuadWord if line.step == 64 => Some(Shape::Wide),
                    _ => self.shape_of_apart(access).or_else(|| self.is_gathered(access).then(|| self.shape_by_width(node))),
                }
            }
            Definition::Compute(op, args) => match args[..op.arity()].iter().all(|&arg| self.shape(arg).is_some()) {
                true => self.vector_shape(node).or_else(|| self.shape_one_by_one(node, op)),
                false => None,
            },
        }
    }

    /// The form of what an operation makes of vectors, if there is such an operation.
    pub(super) fn vector_shape(&self, node: Node) -> Option<Shape> {
        let Definition::Compute(op, args) = self.what(node) else { return None };
        let mut shapes = [Shape::Affine(Affine::SAME); 4];
        for (shape, &arg) in shapes.iter_mut().zip(&args[..op.arity()]) {
            *shape = match self.shape(arg)? {
                Shape::Affine(line) if line.is_same() && !self.is_32_bits(arg) => Shape::Wide,
                shape => shape,
            };
        }
        if op == Op::Select && !self.is_bit(node) {
            // A bit or another number: the bit is one, too.
            shapes[1..3].iter_mut().filter(|shape| **shape == Shape::Mask).for_each(|shape| *shape = Shape::Words);
        }
        let divisor = (op.arity() == 2).then(|| self.constant(args[1])).flatten();
        match op {
            Op::DivI16 | Op::RemI16 | Op::DivI32 | Op::RemI32
                if !divisor.is_some_and(|divisor| greatest(op).is_some_and(|most| (1..=most).contains(&divisor))) =>
            {
                None
            }
            Op::Shl32 | Op::Shr32 | Op::Sar32 if divisor.is_none_or(|count| count & 0xFF >= 32) => None,
            // Only what was a REAL is cut side by side.
            Op::F64ToI32 => {
                let was_real = matches!(self.what(args[0]), Definition::Compute(Op::F32ToF64, _));
                (was_real && shapes[0] == Shape::Lreals).then_some(Shape::Words)
            }
            // A choice between numbers of 16 bits has 16 bits.
            Op::Select if self.is_16_bits(node) && shapes[1..3].iter().all(is_halves) => {
                matches!(shapes[0], Shape::Mask | Shape::Affine(Affine { step: 0, .. })).then_some(Shape::Halves)
            }
            Op::Gate if self.is_16_bits(node) && is_halves(&shapes[0]) => {
                matches!(shapes[1], Shape::Mask | Shape::Affine(Affine { step: 0, .. })).then_some(Shape::Halves)
            }
            _ => shape_of_result(op, &shapes[..op.arity()]),
        }
    }

    /// The form of a slot that the inner loop carries.
    pub(super) fn shape_of_inner(&self, slot: Slot) -> Option<Shape> {
        let inner = self.inner.as_ref()?;
        let &end = inner.ends.get(&slot)?;
        let &entry = inner.entry.get(&slot)?;
        if self.slot_line(Level::Inner, slot).is_some() {
            return self.shape(entry);
        }
        // What the last operation makes.
        let shape = match self.what(end) {
            Definition::Compute(Op::AddU16 | Op::SubU16 | Op::MulU16, _) => Shape::Halves,
            Definition::Compute(Op::AddU32 | Op::SubU32 | Op::MulU32, _) => Shape::Words,
            Definition::Compute(Op::AddF32 | Op::SubF32 | Op::MulF32, _) => Shape::Reals,
            Definition::Compute(Op::AddU64 | Op::SubU64 | Op::MulU64, _) => Shape::Wide,
            Definition::Compute(Op::AddF64 | Op::SubF64 | Op::MulF64, _) => Shape::Lreals,
            _ if self.rests_on(end, Level::Inner, slot) => return None,
            _ => return self.shape(end),
        };
        Some(shape)
    }
}

fn is_halves(shape: &Shape) -> bool {
    matches!(shape, Shape::Affine(_) | Shape::Halves)
}

/// The form of a result.
fn shape_of_result(op: Op, args: &[Shape]) -> Option<Shape> {
    use Op as O;
    let same = |shape: &Shape| matches!(shape, Shape::Affine(line) if line.is_same());
    let words = |shape: &Shape| match shape {
        Shape::Affine(line) => line.bits == 32 || line.is_same(),
        Shape::Halves | Shape::Words | Shape::Reals => true,
        Shape::Mask | Shape::Wide | Shape::Lreals => false,
    };
    let quads = |shape: &Shape| *shape != Shape::Mask;
    let wide = |shape: &Shape| matches!(shape, Shape::Wide | Shape::Lreals);
    let lreals = |shape: &Shape| same(shape) || wide(shape);
    let reals = |shape: &Shape| same(shape) || matches!(shape, Shape::Words | Shape::Reals);
    let masks = |shape: &Shape| same(shape) || *shape == Shape::Mask;
    let all = |fits: &dyn Fn(&Shape) -> bool, shape: Shape| args.iter().all(fits).then_some(shape);
    match op {
        _ if args.iter().all(same) => Some(Shape::Affine(Affine::SAME)),
        // Only the low halves of what they take count.
        O::AddU16 | O::SubU16 | O::MulU16 => all(&|shape: &Shape| is_halves(shape) || *shape == Shape::Words, Shape::Halves),
        O::MinI16 | O::MaxI16 | O::DivI16 | O::RemI16 => all(&is_halves, Shape::Halves),
        // Bits that make a byte.
        O::AndU32 | O::OrU32 | O::Shl32 if args.contains(&Shape::Mask) => {
            args.iter().all(|shape| words(shape) || *shape == Shape::Mask).then_some(Shape::Words)
        }
        O::AddU32 | O::SubU32 | O::MulU32 | O::AndU32 | O::OrU32 | O::XorU32 | O::MinI32 | O::MaxI32 => all(&words, Shape::Words),
        O::NegI32 | O::NegF32 | O::AbsF32 | O::DivI32 | O::RemI32 | O::Shl32 | O::Shr32 | O::Sar32 => all(&words, Shape::Words),
        O::Extend16 if matches!(args[0], Shape::Halves | Shape::Affine(Affine { bits: 16, .. })) => Some(Shape::Words),
        O::AddI16Wide | O::SubI16Wide | O::MulI16Wide => all(&is_halves, Shape::Words),
        O::Low16 => all(&words, Shape::Halves),
        O::DivFailsI32 => all(&words, Shape::Mask),
        O::I32ToF32 => all(&words, Shape::Reals),
        O::AddF32 | O::SubF32 | O::MulF32 | O::DivF32 | O::SqrtF32 | O::MinF32 | O::MaxF32 => all(&reals, Shape::Reals),
        O::RoundF32 | O::CeilF32 | O::FloorF32 | O::TruncF32 => all(&reals, Shape::Reals),
        O::AddU64 | O::SubU64 | O::MulU64 | O::AndU64 | O::OrU64 | O::XorU64 => all(&quads, Shape::Wide),
        O::NotU64 => all(&quads, Shape::Wide),
        O::NegF64 | O::AbsF64 => all(&lreals, Shape::Wide),
        O::ExtendI32I64 if words(&args[0]) => Some(Shape::Wide),
        O::I32ToF64 if words(&args[0]) => Some(Shape::Lreals),
        O::F32ToF64 if reals(&args[0]) => Some(Shape::Lreals),
        O::F64ToF32 if lreals(&args[0]) => Some(Shape::Reals),
        O::AddF64 | O::SubF64 | O::MulF64 | O::DivF64 | O::SqrtF64 | O::MinF64 | O::MaxF64 => all(&lreals, Shape::Lreals),
        O::RoundF64 | O::CeilF64 | O::FloorF64 | O::TruncF64 => all(&lreals, Shape::Lreals),
        O::EqF64 | O::LtF64 | O::LeF64 | O::GtF64 | O::GeF64 | O::DifferF64 => all(&lreals, Shape::Mask),
        O::Equal | O::Differ | O::LtI64 | O::LeI64 | O::GtI64 | O::GeI64 if args.iter().any(wide) => all(&quads, Shape::Mask),
        O::LtI64 | O::LeI64 | O::GtI64 | O::GeI64 => None,
        O::Select if masks(&args[0]) && args[1..].iter().any(wide) && args[1..].iter().all(quads) => Some(Shape::Wide),
        O::Gate if wide(&args[0]) && masks(&args[1]) => Some(Shape::Wide),
        O::EqI32 | O::NeI32 | O::LtI32 | O::LeI32 | O::GtI32 | O::GeI32 | O::Equal | O::Differ => all(&words, Shape::Mask),
        O::Below | O::LeU64 | O::GtU64 | O::GeU64 => all(&words, Shape::Mask),
        O::EqI16 | O::NeI16 | O::LtI16 | O::LeI16 | O::GtI16 | O::GeI16 => all(&is_halves, Shape::Mask),
        O::EqF32 | O::NeF32 | O::LtF32 | O::LeF32 | O::GtF32 | O::GeF32 | O::DifferF32 => all(&reals, Shape::Mask),
        O::Not | O::And | O::AndNot | O::Or | O::Xor => all(&masks, Shape::Mask),
        O::Select if masks(&args[0]) && args[1..].iter().all(words) => Some(Shape::Words),
        O::Select if args.iter().all(masks) => Some(Shape::Mask),
        O::Gate if words(&args[0]) && masks(&args[1]) => Some(Shape::Words),
        _ => None,
    }
}
