//! What one turn of a counted loop does, as values over those with which the turn began.
//!
//! Registers and variables at constant addresses are *cells*; other access is in a list, in its order. A loop may hold another one.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

use sieben_engine::ir::Op;
use sieben_engine::machine::Register;
use sieben_model::address::Width;

use super::super::bit_of;
use super::super::promote::Base;
use super::around::Around;
use super::in_order::InOrder;
use super::line::{Line, Shape};
use crate::passes::PassSet;

/// A value, by its number in the kernel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Node(u32);

impl Node {
    pub(super) fn numbered(number: u32) -> Self {
        Self(number)
    }

    pub(super) fn number(self) -> u32 {
        self.0
    }
}

/// A cell, by its number in the kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Cell(u16);

impl Cell {
    pub(super) fn numbered(number: u16) -> Self {
        Self(number)
    }

    pub(super) fn number(self) -> usize {
        usize::from(self.0)
    }
}

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
    /// What turns have taken from the budget for blocks that not all of them enter.
    Budget,
    /// A variable at a computed address that all turns of the inner loop share, by its number.
    Element {
        number: u16,
        width: Width,
    },
    /// How many numbers were not below their limits, where all of them are looked at.
    Beyond,
    /// The clock in milliseconds, which stands still while nobody is asked.
    Clock,
    /// What the next turn would read with an access, by its number among them.
    Ahead {
        number: u16,
        width: Width,
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
    /// Whether it does in each turn, whatever way that goes.
    pub(super) sure: bool,
    /// Where the variable lies behind the byte to which the pointer goes, if that is known in each turn.
    pub(super) part: Option<Part>,
    /// The same place seen from pointers of which its own is made.
    pub(super) around: Vec<Around>,
}

/// A part of something to which a pointer goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part {
    pub(super) bytes: i32,
    pub(super) bit: u8,
}

impl Access {
    /// The bytes that it may touch.
    pub(super) fn bytes(&self) -> (Base, Range<i64>) {
        let (base, start, length) = self.area;
        (base, self.inside.clone().unwrap_or(i64::from(start)..i64::from(start) + length as i64))
    }

    /// Whether it may go to some of the bytes to which another one may go.
    pub(super) fn may_share(&self, other: &Self) -> bool {
        let ((base, bytes), (other_base, others)) = (self.bytes(), other.bytes());
        base.may_share(&bytes, other_base, &others)
    }
}

/// A copy of bytes as a whole, in turns that are done one after the other.
#[derive(Clone, Debug)]
pub(super) struct Copied {
    /// Where it reads and writes, as accesses to the first byte that are known to stay inside with all of them.
    pub(super) from: Access,
    pub(super) to: Access,
    pub(super) bytes: u32,
    /// The condition under which a turn makes it, and whether that has to hold; none if each turn does.
    pub(super) reached: Option<(Node, bool)>,
}

/// One step of a turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Access(usize),
    /// A copy, by its number.
    Copy(usize),
    /// All turns of the inner loop.
    Inner,
}

/// What a turn does.
#[derive(Clone, Debug, Default)]
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
    /// What blocks take that each turn enters, and at most.
    pub(super) blocks: u32,
    pub(super) blocks_most: u32,
}

/// What is known of a loop.
#[derive(Clone, Debug)]
pub(super) struct Kernel {
    pub(super) nodes: Vec<What>,
    pub(super) cells: Vec<Kept>,
    pub(super) accesses: Vec<Access>,
    /// What each access reads, as a value.
    pub(super) reads: Vec<Node>,
    pub(super) copies: Vec<Copied>,
    /// Reads of which each turn knows what the next one would find.
    pub(super) ahead: Vec<Access>,
    pub(super) outer: Turn,
    pub(super) inner: Option<Turn>,
    /// Numbers on lines that have to be below limits in all turns.
    pub(super) required: Vec<(Node, u32)>,
    /// Conditions of the way through a turn, and whether they hold on it, if one way alone was read.
    pub(super) ways: Vec<(Node, bool)>,
    /// Other numbers that have to be below limits in all turns: no turn changes what they are made of before it looks at it.
    pub(super) looked_at: Vec<(Node, u32)>,
    /// Numbers that count in the inner loop and have to be below limits in all of its turns.
    pub(super) required_inside: Vec<(Node, u32)>,
    /// Conditions that are the same in all turns, and whether they have to hold.
    pub(super) settled: Vec<(Node, bool)>,
    /// Least and greatest value of numbers that are divided by constants and never negative, and of those that are looked at.
    pub(super) bounds: BTreeMap<Node, (u32, u32)>,
    /// Bytes of the arena.
    pub(super) size: usize,
    /// Whether a turn computes so much over which it could jump that it is worth it only where several are done at once.
    pub(super) only_side_by_side: bool,
    /// What turns side by side do in their order.
    pub(super) in_order: InOrder,
    /// Data blocks that turns open, which are taken to be as they were loaded.
    pub(super) opened: BTreeSet<u16>,
    /// Registers that somebody needs behind the loop.
    pub(super) live: u32,
    /// Which optimizations are used.
    pub(super) passes: PassSet,
    /// Lines and forms that were looked for.
    pub(super) lines: RefCell<HashMap<(Node, Level), Option<Line>>>,
    pub(super) shapes: RefCell<HashMap<Node, Option<Shape>>>,
}

/// The size that a number in front of a loop may have when it is written down, in operations and values.
const SIZE_MAX: u64 = 1_000;

impl Kernel {
    /// The accesses of a turn in their order, without those of a loop in it.
    pub(super) fn accesses_in_order(&self) -> Vec<(usize, &Access)> {
        let access = |step: &Step| match *step {
            Step::Access(number) => Some((number, &self.accesses[number])),
            Step::Copy(_) | Step::Inner => None,
        };
        self.outer.steps.iter().filter_map(access).collect()
    }

    pub(super) fn empty() -> Self {
        Self {
            nodes: Vec::new(),
            cells: Vec::new(),
            accesses: Vec::new(),
            reads: Vec::new(),
            copies: Vec::new(),
            ahead: Vec::new(),
            outer: Turn::default(),
            inner: None,
            required: Vec::new(),
            ways: Vec::new(),
            looked_at: Vec::new(),
            required_inside: Vec::new(),
            settled: Vec::new(),
            bounds: BTreeMap::new(),
            size: 0,
            only_side_by_side: false,
            in_order: InOrder::default(),
            opened: BTreeSet::new(),
            live: !0,
            passes: PassSet::default(),
            lines: RefCell::default(),
            shapes: RefCell::default(),
        }
    }

    /// Leaves out registers that nobody reads any more, so that what they hold keeps nothing from being done.
    pub(super) fn forget_dead(&mut self, live_inside: u32) {
        let cells = &self.cells;
        let is_live = |&Cell(cell): &Cell, live: u32| match cells[usize::from(cell)] {
            Kept::Register(register) => live & bit_of(register) != 0,
            Kept::Memory { .. } | Kept::Element { .. } | Kept::Budget | Kept::Beyond | Kept::Clock | Kept::Ahead { .. } => true,
        };
        self.lines.borrow_mut().clear();
        self.outer.ends.retain(|cell, _| is_live(cell, self.live));
        if let Some(inner) = &mut self.inner {
            inner.ends.retain(|cell, _| is_live(cell, live_inside));
            inner.entry.retain(|cell, _| is_live(cell, live_inside));
        }
    }

    /// Leaves out what is read and not needed.
    pub(super) fn forget_unread(&mut self) {
        let mut needed = BTreeSet::new();
        let kept = self.accesses.iter().filter(|access| access.value.is_some() || !access.sure);
        let of_accesses = kept.flat_map(|access| [Some(access.pointer), access.value]).flatten();
        let conditions = [Some(self.outer.again), self.inner.as_ref().map(|inner| inner.again)];
        let mut waiting: Vec<Node> = self.outer.ends.values().copied().chain(self.all_ends()).chain(of_accesses).collect();
        waiting.extend(self.of_copies());
        waiting.extend(conditions.into_iter().flatten());
        // What has to be below a limit is looked at though nobody needs the element.
        waiting.extend(self.required.iter().chain(&self.required_inside).chain(&self.looked_at).map(|&(number, _)| number));
        waiting.extend(self.ways.iter().chain(&self.settled).map(|&(condition, _)| condition));
        while let Some(node) = waiting.pop() {
            if needed.insert(node) {
                match self.what(node) {
                    What::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                    What::Read(access) => waiting.push(self.accesses[access].pointer),
                    _ => {}
                }
            }
        }
        // What may be outside its area is an error though nobody needs it.
        let is_kept = |number: usize| {
            let access = &self.accesses[number];
            access.value.is_some() || !access.sure || needed.contains(&self.reads[number])
        };
        let kept: Vec<usize> = (0..self.accesses.len()).filter(|&access| is_kept(access)).collect();
        let place = |access: usize| kept.binary_search(&access).ok();
        let nodes = self.nodes.iter().map(|&what| match what {
            // Nothing rests on it.
            What::Read(access) => place(access).map_or(What::Constant(0), What::Read),
            what => what,
        });
        let nodes = nodes.collect();
        let step = |step: &Step| match *step {
            Step::Access(access) => place(access).map(Step::Access),
            Step::Copy(_) | Step::Inner => Some(*step),
        };
        let [outer, inner] = [Some(&self.outer), self.inner.as_ref()].map(|turn| {
            let steps = turn.map_or(&[][..], |turn| &turn.steps).iter();
            steps.filter_map(step).collect::<Vec<Step>>()
        });
        let accesses = kept.iter().map(|&access| self.accesses[access].clone()).collect();
        let reads = kept.iter().map(|&access| self.reads[access]).collect();
        (self.nodes, self.accesses, self.reads, self.outer.steps) = (nodes, accesses, reads, outer);
        if let Some(turn) = &mut self.inner {
            turn.steps = inner;
        }
    }

    /// Whether a number that rests on no memory is made of the same parts so often that writing it down would take long: in front of
    /// a loop such numbers are written as often as they occur.
    pub(super) fn repeats_itself(&self) -> bool {
        let mut sizes: Vec<Option<u64>> = Vec::with_capacity(self.nodes.len());
        let known = |sizes: &[Option<u64>], Node(node): Node| sizes.get(node as usize).copied().flatten();
        let size_of = |sizes: &[Option<u64>], node: Node| match self.what(node) {
            // A condition that was made of two behind all others.
            What::Compute(op, args) if node.0 as usize >= sizes.len() => {
                let parts = args[..op.arity()].iter().map(|&arg| known(sizes, arg));
                parts.sum::<Option<u64>>().map(|parts| parts + 1)
            }
            _ => known(sizes, node),
        };
        for what in &self.nodes {
            let size = match *what {
                What::Constant(_) | What::Start(Level::Outer, _) => Some(1),
                What::Start(Level::Inner, cell) => {
                    let entry = self.inner.as_ref().and_then(|inner| inner.entry.get(&cell));
                    Some(1 + entry.and_then(|&entry| size_of(&sizes, entry)).unwrap_or(0))
                }
                What::Compute(op, args) => {
                    let parts = args[..op.arity()].iter().map(|&arg| size_of(&sizes, arg));
                    parts.sum::<Option<u64>>().map(|parts| parts + 1)
                }
                What::After(_) | What::Read(_) => None,
            };
            if size.is_some_and(|size| size > SIZE_MAX) {
                return true;
            }
            sizes.push(size);
        }
        false
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
        let all = starts.chain(self.outer.ends.keys().copied());
        all.filter(|&cell| !matches!(self.kept(cell), Kept::Element { .. } | Kept::Ahead { .. })).collect()
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

impl Kernel {
    /// Whether a cell has 16 bits or fewer.
    pub(super) fn is_word(&self, cell: Cell) -> bool {
        matches!(
            self.kept(cell),
            Kept::Memory { width: Width::Bit | Width::Byte | Width::Word, .. }
                | Kept::Element { width: Width::Bit | Width::Byte | Width::Word, .. }
                | Kept::Ahead { width: Width::Bit | Width::Byte | Width::Word, .. }
        )
    }

    pub(super) fn is_16_bits(&self, node: Node) -> bool {
        self.holds_of_chosen(node, &[Op::Select, Op::Gate], &|what| match what {
            What::Constant(value) => value <= 0xFFFF,
            What::Start(_, cell) | What::After(cell) => self.is_word(cell),
            What::Read(access) => self.accesses[access].width.bytes() <= 2,
            What::Compute(op, _) => {
                let divides = matches!(op, Op::DivI16 | Op::RemI16);
                divides || matches!(op, Op::AddU16 | Op::SubU16 | Op::MulU16 | Op::Low16 | Op::Low8 | Op::Decrement16)
            }
        })
    }

    pub(super) fn is_32_bits(&self, node: Node) -> bool {
        self.holds_of_chosen(node, &[Op::Select, Op::Gate], &|what| match what {
            What::Constant(value) => u32::try_from(value).is_ok(),
            What::Start(_, cell) | What::After(cell) => !self.kept(cell).is_wide(),
            What::Read(access) => self.accesses[access].width != Width::QuadWord,
            What::Compute(op, _) => !op.is_wide(),
        })
    }

    pub(super) fn is_bit(&self, node: Node) -> bool {
        self.holds_of_chosen(node, &[Op::Select], &|what| match what {
            What::Read(access) => self.accesses[access].width == Width::Bit,
            What::Start(_, cell) | What::After(cell) => matches!(self.kept(cell), Kept::Memory { width: Width::Bit, .. }),
            What::Compute(op, _) => {
                let fails = matches!(op, Op::DivFailsI16 | Op::DivFailsI32 | Op::DivFailsI64);
                fails || Self::compares(op) || matches!(op, Op::Not | Op::And | Op::AndNot | Op::Or | Op::Xor | Op::IsNonzero | Op::Below)
            }
            What::Constant(value) => value <= 1,
        })
    }

    /// Whether something holds of all values of which these operations choose one. Each is looked at once, however many choices lead to it.
    fn holds_of_chosen(&self, node: Node, choices: &[Op], holds: &dyn Fn(What) -> bool) -> bool {
        let chosen = |what: What| match what {
            What::Compute(op, [_, a, b, _]) if op == Op::Select && choices.contains(&op) => Some([a, b]),
            What::Compute(op, [a, ..]) if op == Op::Gate && choices.contains(&op) => Some([a, a]),
            _ => None,
        };
        let Some(first) = chosen(self.what(node)) else { return holds(self.what(node)) };
        let (mut seen, mut waiting) = (BTreeSet::from([node]), Vec::from(first));
        while let Some(node) = waiting.pop() {
            let what = self.what(node);
            match chosen(what) {
                _ if !seen.insert(node) => {}
                Some(others) => waiting.extend(others),
                None if !holds(what) => return false,
                None => {}
            }
        }
        true
    }

    /// Whether an operation compares two numbers.
    pub(super) fn compares(op: Op) -> bool {
        use Op as O;
        let reals = matches!(op, O::EqF32 | O::NeF32 | O::LtF32 | O::LeF32 | O::GtF32 | O::GeF32 | O::DifferF32);
        let doubles = matches!(op, O::EqI32 | O::NeI32 | O::LtI32 | O::LeI32 | O::GtI32 | O::GeI32 | O::Equal | O::Differ);
        let lreals = matches!(op, O::EqF64 | O::LtF64 | O::LeF64 | O::GtF64 | O::GeF64 | O::DifferF64);
        let quads = matches!(op, O::LtI64 | O::LeI64 | O::GtI64 | O::GeI64 | O::LeU64 | O::GtU64 | O::GeU64);
        reals || doubles || lreals || quads || matches!(op, O::EqI16 | O::NeI16 | O::LtI16 | O::LeI16 | O::GtI16 | O::GeI16)
    }
}

impl Kernel {
    /// Adds a value.
    pub(super) fn add(&mut self, what: What) -> Node {
        self.nodes.push(what);
        Node::numbered(self.nodes.len() as u32 - 1)
    }

    /// Whether access by computed addresses and cells, and cells among each other, share no bytes that one of them writes.
    pub(super) fn is_apart(&self) -> bool {
        let written = |cell: usize| {
            let cell = Cell(cell as u16);
            self.outer.ends.contains_key(&cell)
        };
        let spans: Vec<_> = self.cells.iter().map(|kept| kept.bytes()).collect();
        for (index, span) in spans.iter().enumerate() {
            let Some((base, bytes, bit)) = span else { continue };
            for (other_index, span) in spans[..index].iter().enumerate() {
                let Some((other_base, other, other_bit)) = span else { continue };
                let meet = base.may_share(bytes, *other_base, other);
                let is_written = written(index) || written(other_index);
                if meet && is_written && (bit.is_none() || other_bit.is_none() || bit == other_bit) {
                    return false;
                }
            }
            let meets = |access: &Access| {
                let (other_base, other) = access.bytes();
                base.may_share(bytes, other_base, &other)
            };
            if self.accesses.iter().any(|access| (access.value.is_some() || written(index)) && meets(access)) {
                return false;
            }
            if self.copies.iter().any(|copied| meets(&copied.to) || written(index) && meets(&copied.from)) {
                return false;
            }
        }
        true
    }
}

impl Kept {
    /// Whether it holds 64 bits.
    pub(super) fn is_wide(self) -> bool {
        let (Self::Memory { width, .. } | Self::Element { width, .. } | Self::Ahead { width, .. }) = self else {
            return false;
        };
        width == Width::QuadWord
    }

    /// The bytes that a cell stands for, and which bit of them.
    pub(super) fn bytes(self) -> Option<(Base, Range<i64>, Option<u8>)> {
        match self {
            Self::Register(_) | Self::Element { .. } | Self::Budget | Self::Beyond | Self::Clock | Self::Ahead { .. } => None,
            Self::Memory { base, offset, width, bit } => {
                let bit = (width == Width::Bit).then_some(bit);
                Some((base, i64::from(offset)..i64::from(offset) + i64::from(width.bytes()), bit))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use sieben_engine::ir::Op;

    use super::{Kernel, Node, What};

    /// Choices between the choice before and itself, a hundred of them behind a number: no one could go all ways through them.
    fn chosen(number: u64, op: Op) -> (Kernel, Node) {
        let mut kernel = Kernel::empty();
        kernel.nodes = vec![What::Constant(0), What::Constant(number)];
        for before in (1..=100).map(Node::numbered) {
            let condition = Node::numbered(0);
            let args = if op == Op::Select { [condition, before, before, before] } else { [before, condition, condition, condition] };
            kernel.nodes.push(What::Compute(op, args));
        }
        (kernel, Node::numbered(101))
    }

    #[test]
    fn each_value_that_choices_choose_is_looked_at_once() {
        for (number, bits) in [(1, 1), (2, 16), (0xFFFF, 16), (0x1_0000, 32), (0xFFFF_FFFF, 32), (0x1_0000_0000, 64)] {
            for op in [Op::Select, Op::Gate] {
                let (kernel, node) = chosen(number, op);
                assert_eq!(kernel.is_32_bits(node), bits <= 32, "{number} {op:?}");
                assert_eq!(kernel.is_16_bits(node), bits <= 16, "{number} {op:?}");
                assert_eq!(kernel.is_bit(node), bits == 1 && op == Op::Select, "{number} {op:?}");
            }
        }
    }
}
