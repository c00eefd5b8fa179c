//! What one turn of a counted loop does, as values over those with which the turn began.
//!
//! Registers and variables at constant addresses are *cells*; other access is in a list, in its order. A loop may hold another one.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

use sieben_engine::interpreter::weight;
use sieben_engine::ir::{Inst, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::super::Translator;
use super::super::bit_of;
use super::super::loops::Loop;
use super::super::memory::moved;
use super::super::promote::Base;
use super::super::value::Val;

/// Instructions of a loop that is looked at.
const INSTRUCTIONS_MAX: usize = 160;

/// A value, by its number in the kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Node(u32);

impl Node {
    /// The first one, for tests.
    #[cfg(test)]
    pub(super) const FIRST: Self = Self(0);
}

/// A cell, by its number in the kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Cell(u16);

/// Which of the loops: the whole one or the one in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Level {
    Outer,
    Inner,
}

/// How a value comes about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum What {
    Constant(u64),
    /// What a cell holds when a turn begins.
    Start(Level, Cell),
    /// What a cell holds behind the inner loop.
    After(Cell),
    Compute(Op, [Node; 4]),
    /// What an access reads.
    Read(usize),
}

/// What a cell is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kept {
    Register(Register),
    Memory {
        base: Base,
        offset: i32,
        width: Width,
        /// The bit, if it is one.
        bit: u8,
    },
}

/// An access by an address that a turn computes.
#[derive(Clone, Debug)]
pub(super) struct Access {
    pub(super) level: Level,
    /// Where the area begins that it goes to, and how many bytes that has.
    pub(super) area: (Base, i32, u64),
    pub(super) pointer: Node,
    pub(super) offset: u32,
    pub(super) width: Width,
    /// What is written, if it writes.
    pub(super) value: Option<Node>,
    /// What it may touch, if it is known to stay inside its area.
    pub(super) inside: Option<Range<i64>>,
}

impl Access {
    /// The bytes that it may touch.
    pub(super) fn bytes(&self) -> (Base, Range<i64>) {
        let (base, start, length) = self.area;
        (base, self.inside.clone().unwrap_or(i64::from(start)..i64::from(start) + length as i64))
    }
}

/// One step of a turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Access(usize),
    /// All turns of the inner loop.
    Inner,
}

/// What a turn does.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    pub(super) steps: Vec<Step>,
    /// Cells that it writes, and what they hold at its end.
    pub(super) ends: BTreeMap<Cell, Node>,
    /// What they hold when the inner loop begins.
    pub(super) entry: BTreeMap<Cell, Node>,
    /// Whether another turn follows.
    pub(super) again: Node,
    /// What its jump back takes from the budget.
    pub(super) weight: u16,
}

/// What is known of a loop.
#[derive(Debug)]
pub(super) struct Kernel {
    nodes: Vec<What>,
    cells: Vec<Kept>,
    pub(super) accesses: Vec<Access>,
    /// What each access reads, as a value.
    reads: Vec<Node>,
    pub(super) outer: Turn,
    pub(super) inner: Option<Turn>,
    /// Registers that somebody needs behind the loop.
    live: u32,
}

impl Kernel {
    /// Leaves out registers that nobody reads any more, so that what they hold keeps nothing from being done.
    fn forget_dead(&mut self, live_inside: u32) {
        let cells = &self.cells;
        let is_live = |&Cell(cell): &Cell, live: u32| match cells[usize::from(cell)] {
            Kept::Register(register) => live & bit_of(register) != 0,
            Kept::Memory { .. } => true,
        };
        self.outer.ends.retain(|cell, _| is_live(cell, self.live));
        if let Some(inner) = &mut self.inner {
            inner.ends.retain(|cell, _| is_live(cell, live_inside));
            inner.entry.retain(|cell, _| is_live(cell, live_inside));
        }
    }

    pub(super) fn what(&self, Node(node): Node) -> What {
        self.nodes[node as usize]
    }

    pub(super) fn kept(&self, Cell(cell): Cell) -> Kept {
        self.cells[usize::from(cell)]
    }

    pub(super) fn turn(&self, level: Level) -> &Turn {
        match (level, &self.inner) {
            (Level::Inner, Some(inner)) => inner,
            _ => &self.outer,
        }
    }

    pub(super) fn constant(&self, node: Node) -> Option<u64> {
        match self.what(node) {
            What::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// What an access reads, as a value.
    pub(super) fn read_of(&self, access: usize) -> Node {
        self.reads[access]
    }

    /// Cells with something that the loop may look at when it begins.
    pub(super) fn cells_at_start(&self) -> BTreeSet<Cell> {
        let starts = self.nodes.iter().filter_map(|what| match what {
            What::Start(_, cell) => Some(*cell),
            _ => None,
        });
        starts.chain(self.outer.ends.keys().copied()).collect()
    }

    /// What the cells of both loops hold at the ends of their turns, and when the inner one begins.
    pub(super) fn all_ends(&self) -> impl Iterator<Item = Node> {
        let inner = self.inner.iter().flat_map(|inner| inner.ends.values().chain(inner.entry.values()));
        self.outer.ends.values().chain(inner).copied()
    }

    /// Adds all values on which one rests in a turn.
    pub(super) fn rests(&self, node: Node, all: &mut BTreeSet<Node>) {
        if all.insert(node)
            && let What::Compute(op, args) = self.what(node)
        {
            args[..op.arity()].iter().for_each(|&arg| self.rests(arg, all));
        }
    }

    /// Whether a value is what a cell holds when a turn begins.
    pub(super) fn is_start(&self, node: Node, level: Level, cell: Cell) -> bool {
        self.what(node) == What::Start(level, cell)
    }
}

/// Reads a loop; `None` if a turn of it does more than a kernel can say.
pub(super) fn read(translator: &mut Translator<'_>, it: &Loop) -> Option<Kernel> {
    let code = &translator.native().code;
    let insts: usize = (it.first..=it.last).map(|statement| code.statement(statement as usize).len()).sum();
    if insts > INSTRUCTIONS_MAX || !it.calls_nothing {
        return None;
    }
    let mut inner = translator.loops.iter().filter(|inner| inner.first > it.first && inner.last <= it.last);
    let inside = inner.next().map(|inner| (inner.first, inner.last));
    if inner.next().is_some() {
        return None;
    }
    let mut reader = Reader {
        translator,
        written: it.written,
        inside,
        kernel: Kernel {
            nodes: Vec::new(),
            cells: Vec::new(),
            accesses: Vec::new(),
            reads: Vec::new(),
            outer: Turn { steps: Vec::new(), ends: BTreeMap::new(), entry: BTreeMap::new(), again: Node(0), weight: 0 },
            inner: None,
            live: !0,
        },
        numbers: HashMap::new(),
        outer: BTreeMap::new(),
        now: BTreeMap::new(),
        level: Level::Outer,
        written_inside: None,
        temporaries: BTreeMap::new(),
        choice: None,
    };
    let outer = reader.turn((it.first, it.last))?;
    let mut kernel = reader.kernel;
    kernel.outer = outer;
    kernel.live = !(translator.dead_at(it.first) & translator.dead_at(it.last + 1));
    let live_inside = inside.map_or(!0, |(first, last)| !(translator.dead_at(first) & translator.dead_at(last + 1)));
    kernel.forget_dead(live_inside);
    kernel.is_apart().then_some(kernel)
}

struct Reader<'t, 'a> {
    translator: &'t mut Translator<'a>,
    /// Registers that the loop changes.
    written: u32,
    /// First and last statement of the inner loop.
    inside: Option<(u32, u32)>,
    kernel: Kernel,
    numbers: HashMap<What, Node>,
    /// What cells hold in front of the inner loop, while that is read.
    outer: BTreeMap<Cell, Node>,
    /// What cells hold that the turn has written so far.
    now: BTreeMap<Cell, Node>,
    level: Level,
    /// What the inner loop writes, once that is known.
    written_inside: Option<BTreeSet<Cell>>,
    temporaries: BTreeMap<u8, Node>,
    /// The next value that is written stays away where this holds.
    choice: Option<Node>,
}

impl Reader<'_, '_> {
    fn turn(&mut self, (first, last): (u32, u32)) -> Option<Turn> {
        let code = &self.translator.native().code;
        let mut steps = Vec::new();
        let mut again = None;
        let mut statement = first;
        while statement <= last {
            if self.level == Level::Outer
                && let Some((inner, end)) = self.inside
                && inner == statement
            {
                self.inner((inner, end))?;
                steps.push(Step::Inner);
                statement = end + 1;
                continue;
            }
            self.temporaries.clear();
            let insts = code.statement(statement as usize);
            for (at, (index, inst)) in (code.statements[statement as usize]..).zip(insts).enumerate() {
                match *inst {
                    Inst::Branch { condition, to: Target(to) } if to == first && statement == last && at + 1 == insts.len() => {
                        again = Some(self.get(condition)?);
                    }
                    Inst::Branch { condition, to: Target(to) } if at + 1 == insts.len() && self.jumps_over_one(statement, to, last) => {
                        self.choice = Some(self.get(condition)?);
                    }
                    _ => self.inst(index, inst, &mut steps)?,
                }
            }
            statement += 1;
        }
        let weight = weight((last - first) as usize);
        Some(Turn { steps, ends: std::mem::take(&mut self.now), entry: BTreeMap::new(), again: again?, weight })
    }

    /// Whether a jump at the end of a statement goes over one that can be written as a choice: see `choices`.
    fn jumps_over_one(&self, statement: u32, to: u32, last: u32) -> bool {
        let next = statement + 1;
        to == next + 1 && to <= last && !self.translator.arrivals.contains_key(&next) && self.translator.is_plain(next)
    }

    /// Reads the inner loop: once to see what it writes, and once more with what else is known.
    fn inner(&mut self, statements: (u32, u32)) -> Option<()> {
        let accesses = self.kernel.accesses.len();
        self.outer = std::mem::take(&mut self.now);
        self.level = Level::Inner;
        let written: BTreeSet<Cell> = self.turn(statements)?.ends.into_keys().collect();
        self.kernel.accesses.truncate(accesses);
        self.kernel.reads.truncate(accesses);
        self.written_inside = Some(written.clone());
        let mut turn = self.turn(statements)?;
        self.level = Level::Outer;
        self.now = std::mem::take(&mut self.outer);
        if !turn.ends.keys().eq(written.iter()) {
            return None;
        }
        for cell in written {
            let before = self.read_cell(cell);
            turn.entry.insert(cell, before);
        }
        for &cell in turn.ends.keys() {
            let after = self.node(What::After(cell));
            self.now.insert(cell, after);
        }
        self.kernel.inner = Some(turn);
        Some(())
    }

    fn node(&mut self, what: What) -> Node {
        let next = Node(self.kernel.nodes.len() as u32);
        let node = *self.numbers.entry(what).or_insert(next);
        if node == next {
            self.kernel.nodes.push(what);
        }
        node
    }

    fn constant(&mut self, value: u64) -> Node {
        self.node(What::Constant(value))
    }

    fn cell(&mut self, kept: Kept) -> Cell {
        let cells = &mut self.kernel.cells;
        let at = cells.iter().position(|&known| known == kept).unwrap_or(cells.len());
        if at == cells.len() {
            cells.push(kept);
        }
        Cell(at as u16)
    }

    fn read_cell(&mut self, cell: Cell) -> Node {
        if let Some(&node) = self.now.get(&cell) {
            return node;
        }
        if self.level == Level::Inner && self.written_inside.as_ref().is_some_and(|written| !written.contains(&cell)) {
            return match self.outer.get(&cell) {
                Some(&node) => node,
                None => self.node(What::Start(Level::Outer, cell)),
            };
        }
        self.node(What::Start(self.level, cell))
    }

    fn get(&mut self, var: Var) -> Option<Node> {
        let Some(register) = var.register() else { return self.temporaries.get(&var.0).copied() };
        if self.written & bit_of(register) == 0
            && let Some(Val::Const(value)) = self.translator.current[register as usize]
        {
            return Some(self.constant(value));
        }
        if register == Register::Nesting {
            // The only register of 64 bits.
            return None;
        }
        let cell = self.cell(Kept::Register(register));
        Some(self.read_cell(cell))
    }

    fn set(&mut self, var: Var, node: Node) -> Option<()> {
        match var.register() {
            Some(Register::Nesting) => return None,
            Some(register) => {
                let cell = self.cell(Kept::Register(register));
                self.now.insert(cell, node);
            }
            None => drop(self.temporaries.insert(var.0, node)),
        }
        Some(())
    }

    fn inst(&mut self, index: u32, inst: &Inst, steps: &mut Vec<Step>) -> Option<()> {
        match *inst {
            Inst::Constant { dst, value } => {
                let node = self.constant(value);
                self.set(dst, node)
            }
            Inst::Compute { op, dst, args } => {
                let node = match self.translator.ranges.result(index) {
                    Some((least, most)) if least == most => self.constant(u64::from(least)),
                    _ => {
                        let none = self.constant(0);
                        let mut nodes = [none; 4];
                        for (node, &arg) in nodes.iter_mut().zip(&args[..op.arity()]) {
                            *node = self.get(arg)?;
                        }
                        self.compute(op, nodes)
                    }
                };
                self.set(dst, node)
            }
            Inst::Load { dst, place, width, .. } => {
                let node = match self.place(index, place, width, None)? {
                    Reached::Cell(cell) => self.read_cell(cell),
                    Reached::Access(access) => {
                        steps.push(Step::Access(access));
                        self.node(What::Read(access))
                    }
                };
                self.set(dst, node)
            }
            Inst::Store { place, width, src } => {
                let value = self.get(src)?;
                let value = self.cut(width, value);
                match self.place(index, place, width, Some(value))? {
                    Reached::Cell(cell) => {
                        let value = match self.choice.take() {
                            Some(condition) => {
                                let before = self.read_cell(cell);
                                self.choose(condition, before, value)
                            }
                            None => value,
                        };
                        self.now.insert(cell, value);
                    }
                    Reached::Access(_) if self.choice.is_some() => return None,
                    Reached::Access(access) => steps.push(Step::Access(access)),
                }
                Some(())
            }
            Inst::Require { .. } if self.translator.ranges.is_met(index) => Some(()),
            Inst::Require { condition, .. } => {
                let condition = self.get(condition)?;
                (self.kernel.constant(condition)? & 1 != 0).then_some(())
            }
            _ => None,
        }
    }

    /// What a variable of a width holds when a value was written to it.
    fn cut(&mut self, width: Width, value: Node) -> Node {
        let op = match width {
            Width::Bit => {
                let one = self.constant(1);
                return self.compute(Op::And, [value, one, value, value]);
            }
            Width::Byte => Op::Low8,
            Width::Word => Op::Low16,
            _ => Op::Low32,
        };
        self.compute(op, [value; 4])
    }

    /// What is there already where a condition holds, and else something new: what a number grows by is 0 then.
    fn choose(&mut self, condition: Node, before: Node, new: Node) -> Node {
        if let What::Compute(op @ (Op::AddU32 | Op::AddU16), [a, b, ..]) = self.kernel.what(new)
            && (a == before || b == before)
        {
            let added = if a == before { b } else { a };
            let negated = self.compute(Op::Not, [condition; 4]);
            let added = self.compute(Op::Gate, [added, negated, added, added]);
            return self.compute(op, [before, added, before, before]);
        }
        self.compute(Op::Select, [condition, before, new, condition])
    }

    fn place(&mut self, index: u32, place: Place, width: Width, value: Option<Node>) -> Option<Reached> {
        let (area, pointer, offset) = match place {
            Place::Fixed { area, position } => (area, self.constant(0), position),
            Place::Indirect { area, pointer, offset } => (area, self.get(pointer)?, offset),
            Place::Crossing { .. } => return None,
        };
        if width == Width::QuadWord {
            return None;
        }
        let (value_of_base, start, length) = self.translator.known_area(area, value.is_some())?;
        let base = if area == Area::Local { Base::Local } else { Base::Arena };
        debug_assert!(base == Base::Local || value_of_base == self.translator.arena);
        if let Some(pointer) = self.kernel.constant(pointer) {
            let position = moved(pointer, offset);
            let (byte, bit) = (u64::from(position / 8), (position % 8) as u8);
            if byte + u64::from(width.bytes()) > length || width != Width::Bit && bit != 0 {
                return None;
            }
            let offset = i32::try_from(i64::from(start) + byte as i64).ok()?;
            return Some(Reached::Cell(self.cell(Kept::Memory { base, offset, width, bit })));
        }
        let inside = match self.translator.ranges.inside(index) {
            Some((known, range)) if known == base => Some(range),
            _ => None,
        };
        let access = Access { level: self.level, area: (base, start, length), pointer, offset, width, value, inside };
        let number = self.kernel.accesses.len();
        self.kernel.accesses.push(access);
        let read = self.node(What::Read(number));
        self.kernel.reads.push(read);
        Some(Reached::Access(number))
    }

    /// The result of an operation, in the simplest form.
    fn compute(&mut self, op: Op, mut args: [Node; 4]) -> Node {
        let used = op.arity();
        let constants: Option<Vec<u64>> = args[..used].iter().map(|&arg| self.kernel.constant(arg)).collect();
        if let Some(constants) = constants {
            let mut words = [0; 4];
            words[..used].copy_from_slice(&constants);
            return self.constant(op.eval(words));
        }
        if let Some(node) = self.is_one_of_its_arguments(op, args) {
            return node;
        }
        let op = match (op, self.kernel.what(args[0])) {
            // The low half of a sum rests on the low halves of its terms.
            (Op::Low16, What::Compute(wide, of)) if narrow(wide).is_some() => {
                args = of;
                narrow(wide).unwrap_or(wide)
            }
            (Op::Low32, What::Compute(wide @ (Op::AddI32Wide | Op::SubI32Wide | Op::MulI32Wide), of)) => {
                args = of;
                match wide {
                    Op::AddI32Wide => Op::AddU32,
                    Op::SubI32Wide => Op::SubU32,
                    _ => Op::MulU32,
                }
            }
            _ => op,
        };
        if matches!(op, Op::AddU16 | Op::SubU16 | Op::MulU16 | Op::Low16 | Op::Decrement16) {
            for arg in &mut args[..op.arity()] {
                *arg = self.with_low_half(*arg);
            }
            if op == Op::Low16 && self.is_16_bits(args[0]) {
                return args[0];
            }
        }
        if op == Op::MergeLow16 && self.is_16_bits(args[0]) {
            return self.compute(Op::Low16, [args[1]; 4]);
        }
        // What does not count shall not make two values of one.
        let (first, rest) = args.split_at_mut(op.arity().max(1));
        rest.fill(first[0]);
        self.node(What::Compute(op, args))
    }

    fn is_one_of_its_arguments(&self, op: Op, args: [Node; 4]) -> Option<Node> {
        let constant = |at: usize| self.kernel.constant(args[at]);
        match op {
            Op::Copy => Some(args[0]),
            Op::Low32 if self.is_32_bits(args[0]) => Some(args[0]),
            Op::Low16 if self.is_16_bits(args[0]) => Some(args[0]),
            Op::Gate if constant(1).is_some_and(|condition| condition & 1 != 0) => Some(args[0]),
            Op::Select => constant(0).map(|condition| if condition & 1 != 0 { args[1] } else { args[2] }),
            Op::Not => match self.kernel.what(args[0]) {
                What::Compute(Op::Not, [of, ..]) if self.is_bit(of) => Some(of),
                _ => None,
            },
            Op::And if constant(1) == Some(1) && self.is_bit(args[0]) => Some(args[0]),
            Op::AndNot if constant(1).is_some_and(|other| other & 1 == 0) && self.is_bit(args[0]) => Some(args[0]),
            _ => None,
        }
    }

    /// A value with the same low half.
    fn with_low_half(&self, node: Node) -> Node {
        match self.kernel.what(node) {
            What::Compute(Op::MergeLow16, [_, low, ..]) => self.with_low_half(low),
            What::Compute(Op::Low16 | Op::Extend16, [of, ..]) => self.with_low_half(of),
            _ => node,
        }
    }

    fn is_16_bits(&self, node: Node) -> bool {
        match self.kernel.what(node) {
            What::Constant(value) => value <= 0xFFFF,
            What::Start(_, cell) | What::After(cell) => {
                matches!(self.kernel.kept(cell), Kept::Memory { width: Width::Bit | Width::Byte | Width::Word, .. })
            }
            What::Read(access) => self.kernel.accesses[access].width.bytes() <= 2,
            What::Compute(op, _) => {
                matches!(op, Op::AddU16 | Op::SubU16 | Op::MulU16 | Op::Low16 | Op::Low8 | Op::Decrement16)
            }
        }
    }

    fn is_32_bits(&self, node: Node) -> bool {
        match self.kernel.what(node) {
            What::Constant(value) => u32::try_from(value).is_ok(),
            What::Start(..) | What::After(_) | What::Read(_) => true,
            What::Compute(op, [a, b, c, _]) => match op {
                Op::Gate => self.is_32_bits(a),
                Op::Select => self.is_32_bits(b) && self.is_32_bits(c),
                _ => self.is_16_bits(node) || has_32_bits(op),
            },
        }
    }

    fn is_bit(&self, node: Node) -> bool {
        match self.kernel.what(node) {
            What::Read(access) => self.kernel.accesses[access].width == Width::Bit,
            What::Start(_, cell) | What::After(cell) => matches!(self.kernel.kept(cell), Kept::Memory { width: Width::Bit, .. }),
            What::Compute(op, _) => {
                matches!(op, Op::Not | Op::LeI32 | Op::LtI32 | Op::GeI32 | Op::GtI32 | Op::LeI16 | Op::IsNonzero | Op::Below)
            }
            What::Constant(_) => false,
        }
    }
}

/// What an instruction reaches.
enum Reached {
    Cell(Cell),
    Access(usize),
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

/// Whether the result of an operation has at most 32 bits.
fn has_32_bits(op: Op) -> bool {
    matches!(
        op,
        Op::AddU32
            | Op::SubU32
            | Op::MulU32
            | Op::AddI16Wide
            | Op::SubI16Wide
            | Op::MulI16Wide
            | Op::MergeLow16
            | Op::MergeLow8
            | Op::Extend16
            | Op::Low32
            | Op::AndU32
            | Op::OrU32
            | Op::XorU32
            | Op::Shl32
            | Op::AddF32
            | Op::SubF32
            | Op::MulF32
            | Op::DivF32
            | Op::I32ToF32
            | Op::RemI32
    )
}

impl Kernel {
    /// Whether access by computed addresses and cells, and cells among each other, share no bytes that one of them writes.
    fn is_apart(&self) -> bool {
        let written = |cell: usize| {
            let cell = Cell(cell as u16);
            self.outer.ends.contains_key(&cell)
        };
        let spans: Vec<_> = self.cells.iter().map(|kept| kept.bytes()).collect();
        for (index, span) in spans.iter().enumerate() {
            let Some((base, bytes, bit)) = span else { continue };
            for (other_base, other, other_bit) in spans[..index].iter().flatten() {
                let meet = base == other_base && bytes.start < other.end && other.start < bytes.end;
                if meet && (bit.is_none() || other_bit.is_none() || bit == other_bit) {
                    return false;
                }
            }
            for access in &self.accesses {
                let (other_base, other) = access.bytes();
                let meet = *base == other_base && bytes.start < other.end && other.start < bytes.end;
                if meet && (access.value.is_some() || written(index)) {
                    return false;
                }
            }
        }
        true
    }
}

impl Kept {
    /// The bytes that a cell stands for, and which bit of them.
    fn bytes(self) -> Option<(Base, Range<i64>, Option<u8>)> {
        match self {
            Self::Register(_) => None,
            Self::Memory { base, offset, width, bit } => {
                let bit = (width == Width::Bit).then_some(bit);
                Some((base, i64::from(offset)..i64::from(offset) + i64::from(width.bytes()), bit))
            }
        }
    }
}
