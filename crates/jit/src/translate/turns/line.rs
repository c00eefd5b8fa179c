//! Which values of a loop grow by the same step in each turn, which cells carry something from turn to turn, and which form a value has
//! when several turns are done side by side.

use std::collections::{BTreeSet, HashMap};

use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::count::is_unsigned;
use super::divide::greatest;
use super::extremes::Extreme;
use super::kernel::{Cell, Kept, Kernel, Level, Node, Step, Turn, What};

/// A value that grows by the same step in each turn, modulo 2 to the power of `bits`; zero-extended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Line {
    pub(super) step: u32,
    pub(super) bits: u32,
}

impl Line {
    pub(super) const SAME: Self = Self { step: 0, bits: 32 };

    pub(super) fn is_same(self) -> bool {
        self.step == 0
    }

    fn halves(step: u32) -> Self {
        Self { step: step & 0xFFFF, bits: 16 }
    }
}

/// What a value is for turns side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// On a line, or the same in all of them.
    Line(Line),
    /// Numbers of 16 bits.
    Halves,
    /// Numbers of 32 bits.
    Words,
    /// REALs.
    Reals,
    /// Numbers of 64 bits.
    Quads,
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

/// How a cell is carried from turn to turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Carried {
    /// On a line.
    Line(Line),
    /// It grows by a value that does not depend on it, and nothing else looks at it: modulo 2 to the power of `bits`.
    Sum { added: Node, bits: u32 },
    /// It keeps the least or the greatest of what it was and a value that does not depend on it, as numbers of so many bits, and nothing
    /// else looks at it.
    Extreme { extreme: Extreme, other: Node, bits: u32 },
    /// Each turn needs what the one before left.
    Chain,
    /// No turn looks at what the one before left.
    Nothing,
}

/// A cell that grows by a value in each turn, modulo 2 to the power of `bits`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum {
    pub(super) of: Cell,
    pub(super) added: Node,
    pub(super) bits: u32,
}

impl Kernel {
    /// The line on which a value lies from turn to turn of a loop.
    pub(super) fn line(&self, node: Node, level: Level) -> Option<Line> {
        let known = self.lines.borrow().get(&(node, level)).copied();
        known.unwrap_or_else(|| {
            let line = self.line_of(node, level);
            self.lines.borrow_mut().insert((node, level), line);
            line
        })
    }

    fn line_of(&self, node: Node, level: Level) -> Option<Line> {
        match self.what(node) {
            What::Constant(_) => Some(Line::SAME),
            What::Start(of, cell) if of == level => self.start_line(level, cell),
            What::Start(Level::Outer, _) => Some(Line::SAME),
            // The inner loop is the same for all turns of the outer one as far as where it begins.
            What::Start(Level::Inner, cell) => {
                self.cell_line(Level::Inner, cell)?;
                self.line(*self.inner.as_ref()?.entry.get(&cell)?, level)
            }
            What::After(_) | What::Read(_) => None,
            What::Compute(op, args) => self.line_of_result(op, args, level),
        }
    }

    fn line_of_result(&self, op: Op, args: [Node; 4], level: Level) -> Option<Line> {
        let mut lines = [Line::SAME; 4];
        for (line, &arg) in lines.iter_mut().zip(&args[..op.arity()]) {
            *line = self.line(arg, level)?;
        }
        if lines.iter().all(|line| line.is_same()) {
            return Some(Line::SAME);
        }
        let [a, b, ..] = lines;
        let factor = |at: usize| self.constant(args[at]).map(|factor| factor as u32);
        let whole = a.bits == 32 && b.bits == 32;
        match op {
            Op::AddU32 if whole => Some(Line { step: a.step.wrapping_add(b.step), bits: 32 }),
            Op::SubU32 if whole => Some(Line { step: a.step.wrapping_sub(b.step), bits: 32 }),
            Op::MulU32 if whole && b.is_same() => factor(1).map(|factor| Line { step: a.step.wrapping_mul(factor), bits: 32 }),
            Op::MulU32 if whole && a.is_same() => factor(0).map(|factor| Line { step: b.step.wrapping_mul(factor), bits: 32 }),
            Op::Shl32 if whole && b.is_same() => {
                factor(1).filter(|&count| count < 32).map(|count| Line { step: a.step << count, bits: 32 })
            }
            Op::AddU16 => Some(Line::halves(a.step.wrapping_add(b.step))),
            Op::SubU16 => Some(Line::halves(a.step.wrapping_sub(b.step))),
            Op::MulU16 if b.is_same() => factor(1).map(|factor| Line::halves(a.step.wrapping_mul(factor))),
            Op::MulU16 if a.is_same() => factor(0).map(|factor| Line::halves(b.step.wrapping_mul(factor))),
            Op::Low16 | Op::Decrement16 => Some(Line::halves(a.step)),
            Op::Low32 => Some(a),
            // The counter of a loop does not leave its type while turns follow: see `count`.
            Op::Extend16 if self.is_counter(args[0], level) => Some(Line { step: i32::from(a.step as u16 as i16) as u32, bits: 32 }),
            _ => None,
        }
    }

    /// The line on which lies what a cell holds when a turn begins. A counter without sign does not leave its type while turns follow: see
    /// `count`.
    pub(super) fn start_line(&self, level: Level, cell: Cell) -> Option<Line> {
        let line = self.cell_line(level, cell)?;
        let Some((op, [counter, ..])) = self.compared(level) else { return Some(line) };
        let is_counter = level == Level::Outer && is_unsigned(op) && self.turn(level).ends.get(&cell) == Some(&counter);
        let widened = is_counter && line.bits == 16;
        Some(if widened { Line { step: i32::from(line.step as u16 as i16) as u32, bits: 32 } } else { line })
    }

    /// Whether a value is what the cell holds when a turn begins whose end decides, as an INT, whether another turn follows.
    fn is_counter(&self, node: Node, level: Level) -> bool {
        let (What::Start(of, cell), Some((op, [counter, ..]))) = (self.what(node), self.compared(level)) else { return false };
        let counts = matches!(op, Op::LeI16 | Op::LtI16 | Op::GeI16 | Op::GtI16 | Op::Differ | Op::NeI16);
        of == level && counts && self.turn(level).ends.get(&cell) == Some(&counter)
    }

    /// Whether a value is the same in all turns of the outer loop.
    pub(super) fn is_same_in_all_turns(&self, node: Node) -> bool {
        self.line(node, Level::Outer).is_some_and(|line| line.is_same())
    }

    /// Whether all conditions that are looked at in front of the loop are the same in all turns.
    pub(super) fn settles_in_front(&self) -> bool {
        self.settled.iter().all(|&(condition, _)| self.is_same_in_all_turns(condition))
    }

    /// Whether a value is the same in all turns of the inner loop.
    pub(super) fn is_fixed(&self, node: Node, known: &mut HashMap<Node, bool>) -> bool {
        if let Some(&fixed) = known.get(&node) {
            return fixed;
        }
        let fixed = match self.what(node) {
            What::Constant(_) | What::Start(Level::Outer, _) => true,
            What::Start(Level::Inner, _) | What::After(_) => false,
            What::Read(access) => self.accesses[access].level == Level::Outer,
            What::Compute(op, args) => args[..op.arity()].iter().all(|&arg| self.is_fixed(arg, known)),
        };
        known.insert(node, fixed);
        fixed
    }

    /// Whether a value is on a line as a number of 32 bits.
    pub(super) fn is_on_line(&self, node: Node, level: Level) -> bool {
        self.line(node, level).is_some_and(|line| line.bits == 32)
    }

    /// The line of a cell, if it is what the cell held before plus a constant.
    pub(super) fn cell_line(&self, level: Level, cell: Cell) -> Option<Line> {
        let Some(&end) = self.turn(level).ends.get(&cell) else { return Some(Line::SAME) };
        // Nobody knows what it is before it is read.
        if matches!(self.kept(cell), Kept::Ahead { .. }) {
            return None;
        }
        if self.is_start(end, level, cell) {
            return Some(Line::SAME);
        }
        if self.kept(cell).is_wide() {
            return None;
        }
        let What::Compute(op, [a, b, ..]) = self.what(end) else { return None };
        let step =
            |own: Node, other: Node| if self.is_start(own, level, cell) { self.constant(other).map(|step| step as u32) } else { None };
        let low = |node: Node| match self.what(node) {
            What::Compute(Op::Low16, [of, ..]) => of,
            _ => node,
        };
        match op {
            Op::AddU32 => step(a, b).or_else(|| step(b, a)).map(|step| Line { step, bits: 32 }),
            Op::SubU32 => step(a, b).map(|step| Line { step: step.wrapping_neg(), bits: 32 }),
            Op::AddU16 => step(low(a), b).or_else(|| step(low(b), a)).map(Line::halves),
            Op::SubU16 => step(low(a), b).map(|step| Line::halves(step.wrapping_neg())),
            Op::Decrement16 if self.is_start(low(a), level, cell) => Some(Line::halves(u32::MAX)),
            _ => None,
        }
    }

    /// Values that a turn of a loop cannot do without, in no order: what it writes to memory and where, whether another turn follows,
    /// and what it hands on. Pointers on a line are counted on beside it.
    pub(super) fn needed(&self, level: Level, carried: &dyn Fn(Cell) -> bool) -> BTreeSet<Node> {
        let mut needed = BTreeSet::new();
        let mut waiting = Vec::new();
        for step in &self.turn(level).steps {
            match step {
                Step::Access(access) => {
                    let access = &self.accesses[*access];
                    waiting.extend(access.value);
                    if self.counted_on(access, level).is_none() {
                        waiting.push(access.pointer);
                    }
                }
                Step::Copy(copied) => waiting.extend(self.nodes_of_copy(*copied, level)),
                Step::Inner => {
                    if let Some(inner) = &self.inner {
                        // With what its cells begin that it does not carry is reached from those at which it looks.
                        waiting.extend(self.carried_into(inner).map(|(_, entry)| entry));
                        let all = |_: Cell| true;
                        waiting.extend(self.needed(Level::Inner, &all));
                        // What addresses in the inner loop begin with.
                        for step in &inner.steps {
                            if let Step::Access(access) = step {
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
                    What::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                    // What the inner loop makes of it may rest on what a turn of the outer one began with.
                    What::After(cell) | What::Start(Level::Inner, cell) if level == Level::Outer => {
                        let inner = self.inner.iter();
                        waiting.extend(inner.flat_map(|inner| [inner.ends.get(&cell), inner.entry.get(&cell)]).flatten());
                    }
                    _ => {}
                }
            }
            for (&cell, &end) in &self.turn(level).ends {
                let start = needed.iter().any(|&node| self.is_start(node, level, cell));
                if start && carried(cell) && !needed.contains(&end) {
                    waiting.push(end);
                }
            }
            if waiting.is_empty() {
                return needed;
            }
        }
    }

    /// Cells that the turns of the inner loop hand on, and what they hold when it begins.
    fn carried_into(&self, inner: &Turn) -> impl Iterator<Item = (Cell, Node)> {
        let carried = self.carried(Level::Inner).into_iter().filter(|(.., carried)| *carried != Carried::Nothing);
        carried.filter_map(|(cell, ..)| Some((cell, *inner.entry.get(&cell)?)))
    }

    /// How the cells of a loop are carried.
    pub(super) fn carried(&self, level: Level) -> Vec<(Cell, Node, Carried)> {
        let turn = self.turn(level);
        let needed = self.needed(level, &|cell| self.cell_line(level, cell).is_none());
        let cells = turn.ends.iter().map(|(&cell, &end)| {
            if let Some(line) = self.cell_line(level, cell) {
                return (cell, end, Carried::Line(line));
            }
            if let Some((added, bits)) = self.sum(level, cell, end) {
                return (cell, end, Carried::Sum { added, bits });
            }
            if let Some((extreme, other, bits)) = self.extreme(level, cell, end) {
                return (cell, end, Carried::Extreme { extreme, other, bits });
            }
            let looked_at = needed.iter().any(|&node| self.is_start(node, level, cell))
                || turn.ends.values().any(|&end| self.rests_on(end, level, cell));
            (cell, end, if looked_at { Carried::Chain } else { Carried::Nothing })
        });
        cells.collect()
    }

    /// What is added to a cell in each turn, if nothing else looks at the cell.
    fn sum(&self, level: Level, cell: Cell, end: Node) -> Option<(Node, u32)> {
        let What::Compute(op @ (Op::AddU32 | Op::AddU16), [a, b, ..]) = self.what(end) else { return None };
        if self.kept(cell).is_wide() {
            return None;
        }
        let added = match () {
            () if self.is_start(a, level, cell) => b,
            () if self.is_start(b, level, cell) => a,
            () => return None,
        };
        self.is_only_added(level, cell, added).then_some((added, if op == Op::AddU16 { 16 } else { 32 }))
    }

    /// Whether nothing looks at what a cell holds when a turn begins but what makes of it and of another value what it holds at the end.
    pub(super) fn is_only_added(&self, level: Level, cell: Cell, added: Node) -> bool {
        let is_left = |other: Cell, end: Node| self.is_start(end, level, cell) && self.is_left_only(level, other);
        let others = self.turn(level).ends.iter().filter(|&(&other, &end)| other != cell && !is_left(other, end)).map(|(_, &end)| end);
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let entries = self.inner.iter().flat_map(|inner| inner.entry.values().chain(inner.ends.values()).copied());
        let mut all = others.chain(of_accesses).chain(self.of_copies()).chain(entries).chain([added, self.turn(level).again]);
        !all.any(|node| self.rests_on(node, level, cell))
    }

    /// Whether nothing in the next turn looks at what a turn leaves in a cell.
    fn is_left_only(&self, level: Level, cell: Cell) -> bool {
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let turn = self.turn(level);
        let mut all = turn.ends.values().copied().chain(of_accesses).chain(self.of_copies()).chain([turn.again]);
        self.inner.is_none() && !all.any(|node| self.rests_on(node, level, cell))
    }

    /// The sum that a value is what it was when a turn begins.
    pub(super) fn sum_at_start(&self, node: Node) -> Option<Sum> {
        let What::Start(Level::Outer, of) = self.what(node) else { return None };
        let (added, bits) = self.sum(Level::Outer, of, *self.outer.ends.get(&of)?)?;
        self.cell_line(Level::Outer, of).is_none().then_some(Sum { of, added, bits })
    }

    /// Whether a value rests on what a cell holds when a turn begins.
    pub(super) fn rests_on(&self, node: Node, level: Level, cell: Cell) -> bool {
        let mut seen = BTreeSet::new();
        let mut waiting = vec![node];
        while let Some(node) = waiting.pop() {
            if self.is_start(node, level, cell) {
                return true;
            }
            if seen.insert(node) {
                match self.what(node) {
                    What::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                    What::After(after) => {
                        if let Some(inner) = &self.inner {
                            waiting.extend(inner.ends.get(&after).into_iter().chain(inner.entry.get(&after)));
                        }
                    }
                    What::Start(Level::Inner, start) => {
                        if let Some(inner) = &self.inner {
                            waiting.extend(inner.ends.get(&start).into_iter().chain(inner.entry.get(&start)));
                        }
                    }
                    What::Read(access) => waiting.push(self.accesses[access].pointer),
                    What::Constant(_) | What::Start(Level::Outer, _) => {}
                }
            }
        }
        false
    }

    /// The form of a value when turns of the outer loop are done side by side; `None` if it has none.
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
            return Some(Shape::Line(line));
        }
        if self.in_order.nodes.contains(&node) {
            return Some(self.shape_by_width(node));
        }
        match self.what(node) {
            What::Constant(_) => None,
            What::Start(Level::Outer, _) => None,
            What::Start(Level::Inner, cell) | What::After(cell) => self.shape_of_inner(cell),
            What::Read(access) => {
                let access = &self.accesses[access];
                let line = match self.shape(access.pointer)? {
                    Shape::Line(line) if line.bits == 32 => line,
                    _ if self.is_gathered(access) => return Some(self.shape_by_width(node)),
                    _ => return None,
                };
                match access.width {
                    _ if line.is_same() => Some(Shape::Line(Line::SAME)),
                    Width::Bit if self.is_row_of_bits(access) => Some(Shape::Mask),
                    Width::Word if line.step == 16 => Some(Shape::Halves),
                    Width::DoubleWord if line.step == 32 => Some(Shape::Words),
                    Width::QuadWord if line.step == 64 => Some(Shape::Quads),
                    _ => self.shape_of_apart(access).or_else(|| self.is_gathered(access).then(|| self.shape_by_width(node))),
                }
            }
            What::Compute(op, args) => match args[..op.arity()].iter().all(|&arg| self.shape(arg).is_some()) {
                true => self.vector_shape(node).or_else(|| self.shape_one_by_one(node, op)),
                false => None,
            },
        }
    }

    /// The form of what an operation makes of vectors, if there is such an operation.
    pub(super) fn vector_shape(&self, node: Node) -> Option<Shape> {
        let What::Compute(op, args) = self.what(node) else { return None };
        let mut shapes = [Shape::Line(Line::SAME); 4];
        for (shape, &arg) in shapes.iter_mut().zip(&args[..op.arity()]) {
            *shape = match self.shape(arg)? {
                Shape::Line(line) if line.is_same() && !self.is_32_bits(arg) => Shape::Quads,
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
                let was_real = matches!(self.what(args[0]), What::Compute(Op::F32ToF64, _));
                (was_real && shapes[0] == Shape::Lreals).then_some(Shape::Words)
            }
            // A choice between numbers of 16 bits has 16 bits.
            Op::Select if self.is_16_bits(node) && shapes[1..3].iter().all(is_halves) => {
                matches!(shapes[0], Shape::Mask | Shape::Line(Line { step: 0, .. })).then_some(Shape::Halves)
            }
            Op::Gate if self.is_16_bits(node) && is_halves(&shapes[0]) => {
                matches!(shapes[1], Shape::Mask | Shape::Line(Line { step: 0, .. })).then_some(Shape::Halves)
            }
            _ => shape_of_result(op, &shapes[..op.arity()]),
        }
    }

    /// The form of a cell that the inner loop carries.
    pub(super) fn shape_of_inner(&self, cell: Cell) -> Option<Shape> {
        let inner = self.inner.as_ref()?;
        let &end = inner.ends.get(&cell)?;
        let &entry = inner.entry.get(&cell)?;
        if self.cell_line(Level::Inner, cell).is_some() {
            return self.shape(entry);
        }
        // What the last operation makes.
        let shape = match self.what(end) {
            What::Compute(Op::AddU16 | Op::SubU16 | Op::MulU16, _) => Shape::Halves,
            What::Compute(Op::AddU32 | Op::SubU32 | Op::MulU32, _) => Shape::Words,
            What::Compute(Op::AddF32 | Op::SubF32 | Op::MulF32, _) => Shape::Reals,
            What::Compute(Op::AddU64 | Op::SubU64 | Op::MulU64, _) => Shape::Quads,
            What::Compute(Op::AddF64 | Op::SubF64 | Op::MulF64, _) => Shape::Lreals,
            _ if self.rests_on(end, Level::Inner, cell) => return None,
            _ => return self.shape(end),
        };
        Some(shape)
    }
}

fn is_halves(shape: &Shape) -> bool {
    matches!(shape, Shape::Line(_) | Shape::Halves)
}

/// The form of a result.
fn shape_of_result(op: Op, args: &[Shape]) -> Option<Shape> {
    use Op as O;
    let same = |shape: &Shape| matches!(shape, Shape::Line(line) if line.is_same());
    let words = |shape: &Shape| match shape {
        Shape::Line(line) => line.bits == 32 || line.is_same(),
        Shape::Halves | Shape::Words | Shape::Reals => true,
        Shape::Mask | Shape::Quads | Shape::Lreals => false,
    };
    let quads = |shape: &Shape| *shape != Shape::Mask;
    let wide = |shape: &Shape| matches!(shape, Shape::Quads | Shape::Lreals);
    let lreals = |shape: &Shape| same(shape) || wide(shape);
    let reals = |shape: &Shape| same(shape) || matches!(shape, Shape::Words | Shape::Reals);
    let masks = |shape: &Shape| same(shape) || *shape == Shape::Mask;
    let all = |fits: &dyn Fn(&Shape) -> bool, shape: Shape| args.iter().all(fits).then_some(shape);
    match op {
        _ if args.iter().all(same) => Some(Shape::Line(Line::SAME)),
        // Only the low halves of what they take count.
        O::AddU16 | O::SubU16 | O::MulU16 => all(&|shape: &Shape| is_halves(shape) || *shape == Shape::Words, Shape::Halves),
        O::MinI16 | O::MaxI16 | O::DivI16 | O::RemI16 => all(&is_halves, Shape::Halves),
        // Bits that make a byte.
        O::AndU32 | O::OrU32 | O::Shl32 if args.contains(&Shape::Mask) => {
            args.iter().all(|shape| words(shape) || *shape == Shape::Mask).then_some(Shape::Words)
        }
        O::AddU32 | O::SubU32 | O::MulU32 | O::AndU32 | O::OrU32 | O::XorU32 | O::MinI32 | O::MaxI32 => all(&words, Shape::Words),
        O::NegI32 | O::NegF32 | O::AbsF32 | O::DivI32 | O::RemI32 | O::Shl32 | O::Shr32 | O::Sar32 => all(&words, Shape::Words),
        O::Extend16 if matches!(args[0], Shape::Halves | Shape::Line(Line { bits: 16, .. })) => Some(Shape::Words),
        O::AddI16Wide | O::SubI16Wide | O::MulI16Wide => all(&is_halves, Shape::Words),
        O::Low16 => all(&words, Shape::Halves),
        O::DivFailsI32 => all(&words, Shape::Mask),
        O::I32ToF32 => all(&words, Shape::Reals),
        O::AddF32 | O::SubF32 | O::MulF32 | O::DivF32 | O::SqrtF32 | O::MinF32 | O::MaxF32 => all(&reals, Shape::Reals),
        O::RoundF32 | O::CeilF32 | O::FloorF32 | O::TruncF32 => all(&reals, Shape::Reals),
        O::AddU64 | O::SubU64 | O::MulU64 | O::AndU64 | O::OrU64 | O::XorU64 => all(&quads, Shape::Quads),
        O::NotU64 => all(&quads, Shape::Quads),
        O::NegF64 | O::AbsF64 => all(&lreals, Shape::Quads),
        O::ExtendI32I64 if words(&args[0]) => Some(Shape::Quads),
        O::I32ToF64 if words(&args[0]) => Some(Shape::Lreals),
        O::F32ToF64 if reals(&args[0]) => Some(Shape::Lreals),
        O::F64ToF32 if lreals(&args[0]) => Some(Shape::Reals),
        O::AddF64 | O::SubF64 | O::MulF64 | O::DivF64 | O::SqrtF64 | O::MinF64 | O::MaxF64 => all(&lreals, Shape::Lreals),
        O::RoundF64 | O::CeilF64 | O::FloorF64 | O::TruncF64 => all(&lreals, Shape::Lreals),
        O::EqF64 | O::LtF64 | O::LeF64 | O::GtF64 | O::GeF64 | O::DifferF64 => all(&lreals, Shape::Mask),
        O::Equal | O::Differ | O::LtI64 | O::LeI64 | O::GtI64 | O::GeI64 if args.iter().any(wide) => all(&quads, Shape::Mask),
        O::LtI64 | O::LeI64 | O::GtI64 | O::GeI64 => None,
        O::Select if masks(&args[0]) && args[1..].iter().any(wide) && args[1..].iter().all(quads) => Some(Shape::Quads),
        O::Gate if wide(&args[0]) && masks(&args[1]) => Some(Shape::Quads),
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
