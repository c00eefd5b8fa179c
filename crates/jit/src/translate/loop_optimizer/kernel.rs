//! The loop body in SSA form: what one iteration of a counted loop does, as values over those at its beginning.
//!
//! Registers and variables at constant addresses are *slots*; other accesses are in a list, in their order. A loop may hold another one.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

use sieben_engine::ir::Op;
use sieben_engine::machine::Register;
use sieben_model::address::Width;

use super::super::bit_of;
use super::super::scalar_promotion::Base;
use super::modular_addressing::ModularAddress;
use super::ordered_reduction::OrderedReduction;
use super::scalar_evolution::{Affine, Shape};
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

/// A slot, by its number in the kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Slot(u16);

impl Slot {
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
pub(super) enum Definition {
    Constant(u64),
    /// What a slot holds when an iteration begins.
    Start(Level, Slot),
    /// What a slot holds behind the inner loop.
    After(Slot),
    Compute(Op, [Node; 4]),
    /// What an access reads.
    Read(usize),
}

/// What a slot is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SlotKind {
    Register(Register),
    Memory {
        base: Base,
        offset: i32,
        width: Width,
        /// The bit, if it is one.
        bit: u8,
    },
    /// What iterations have taken from the budget for blocks that not all of them enter.
    Budget,
    /// A variable at a computed address that all iterations of the inner loop share, by its number.
    Element {
        number: u16,
        width: Width,
    },
    /// How many numbers were not below their limits, where all of them are looked at.
    Beyond,
    /// The clock in milliseconds, which stands still while nobody is asked.
    Clock,
    /// What the next iteration would read with an access, by its number among them.
    Ahead {
        number: u16,
        width: Width,
    },
}

/// An access by an address that an iteration computes.
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
    /// Whether it does in each iteration, whatever way that goes.
    pub(super) sure: bool,
    /// Where the variable lies behind the byte to which the pointer goes, if that is known in each iteration.
    pub(super) part: Option<PointedPart>,
    /// The same place seen from pointers of which its own is made.
    pub(super) around: Vec<ModularAddress>,
}

/// A part of something to which a pointer goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PointedPart {
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

/// A copy of bytes as a whole, in iterations that are done one after the other.
#[derive(Clone, Debug)]
pub(super) struct StructureCopy {
    /// Where it reads and writes, as accesses to the first byte that are known to stay inside with all of them.
    pub(super) from: Access,
    pub(super) to: Access,
    pub(super) bytes: u32,
    /// The condition under which an iteration makes it, and whether that has to hold; none if each iteration does.
    pub(super) reached: Option<(Node, bool)>,
}

/// One step of an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    Access(usize),
    /// A copy, by its number.
    Copy(usize),
    /// All iterations of the inner loop.
    Inner,
}

/// What an iteration does.
#[derive(Clone, Debug, Default)]
pub(super) struct Iteration {
    pub(super) steps: Vec<Effect>,
    /// Slots that it writes, and what they hold at its end.
    pub(super) ends: BTreeMap<Slot, Node>,
    /// What they hold when the inner loop begins.
    pub(super) entry: BTreeMap<Slot, Node>,
    /// Whether another iteration follows.
    pub(super) again: Node,
    /// What its jump back takes from the budget.
    pub(super) weight: u16,
    /// What blocks take that each iteration enters, and at most.
    pub(super) blocks: u32,
    pub(super) blocks_most: u32,
}

/// What is known of a loop.
#[derive(Clone, Debug)]
pub(super) struct Kernel {
    pub(super) nodes: Vec<Definition>,
    pub(super) slots: Vec<SlotKind>,
    pub(super) accesses: Vec<Access>,
    /// What each access reads, as a value.
    pub(super) reads: Vec<Node>,
    pub(super) copies: Vec<StructureCopy>,
    /// Reads of which each iteration knows what the next one would find.
    pub(super) ahead: Vec<Access>,
    pub(super) outer: Iteration,
    pub(super) inner: Option<Iteration>,
    /// Numbers on lines that have to be below limits in all iterations.
    pub(super) required: Vec<(Node, u32)>,
    /// Conditions of the way through an iteration, and whether they hold on it, if one way alone was read.
    pub(super) ways: Vec<(Node, bool)>,
    /// Other numbers that have to be below limits in all iterations: no iteration changes what they are made of before it looks at it.
    pub(super) inspected: Vec<(Node, u32)>,
    /// Numbers that count in the inner loop and have to be below limits in all of its iterations.
    pub(super) required_inside: Vec<(Node, u32)>,
    /// Conditions that are the same in all iterations, and whether they have to hold.
    pub(super) settled: Vec<(Node, bool)>,
    /// Least and greatest value of numbers that are divided by constants and never negative, and of those that are looked at.
    pub(super) bounds: BTreeMap<Node, (u32, u32)>,
    /// Bytes of the arena.
    pub(super) size: usize,
    /// Whether an iteration computes so much over which it could jump that it is worth it only where several are done at once.
    pub(super) only_side_by_side: bool,
    /// What vectorized iterations do in their order.
    pub(super) in_order: OrderedReduction,
    /// Data blocks that iterations open, which are taken to be as they were loaded.
    pub(super) opened: BTreeSet<u16>,
    /// Registers that somebody needs behind the loop.
    pub(super) live: u32,
    /// Which optimizations are used.
    pub(super) passes: PassSet,
    /// Lines and forms that were looked for.
    pub(super) lines: RefCell<HashMap<(Node, Level), Option<Affine>>>,
    pub(super) shapes: RefCell<HashMap<Node, Option<Shape>>>,
}

/// The size that a number before a loop may have when it is written down, in operations and values.
const SIZE_MAX: u64 = 1_000;

impl Kernel {
    /// The accesses of an iteration in their order, without those of a loop in it.
    pub(super) fn accesses_in_order(&self) -> Vec<(usize, &Access)> {
        let access = |step: &Effect| match *step {
            Effect::Access(number) => Some((number, &self.accesses[number])),
            Effect::Copy(_) | Effect::Inner => None,
        };
        self.outer.steps.iter().filter_map(access).collect()
    }

    pub(super) fn empty() -> Self {
        Self {
            nodes: Vec::new(),
            slots: Vec::new(),
            accesses: Vec::new(),
            reads: Vec::new(),
            copies: Vec::new(),
            ahead: Vec::new(),
            outer: Iteration::default(),
            inner: None,
            required: Vec::new(),
            ways: Vec::new(),
            inspected: Vec::new(),
            required_inside: Vec::new(),
            settled: Vec::new(),
            bounds: BTreeMap::new(),
            size: 0,
            only_side_by_side: false,
            in_order: OrderedReduction::default(),
            opened: BTreeSet::new(),
            live: !0,
            passes: PassSet::default(),
            lines: RefCell::default(),
            shapes: RefCell::default(),
        }
    }

    /// Leaves out registers that nobody reads any more, so that what they hold keeps nothing from being done.
    pub(super) fn forget_dead(&mut self, live_inside: u32) {
        let slots = &self.slots;
        let is_live = |&Slot(slot): &Slot, live: u32| match slots[usize::from(slot)] {
            SlotKind::Register(register) => live & bit_of(register) != 0,
            SlotKind::Memory { .. }
            | SlotKind::Element { .. }
            | SlotKind::Budget
            | SlotKind::Beyond
            | SlotKind::Clock
            | SlotKind::Ahead { .. } => true,
        };
        self.lines.borrow_mut().clear();
        self.outer.ends.retain(|slot, _| is_live(slot, self.live));
        if let Some(inner) = &mut self.inner {
            inner.ends.retain(|slot, _| is_live(slot, live_inside));
            inner.entry.retain(|slot, _| is_live(slot, live_inside));
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
        waiting.extend(self.required.iter().chain(&self.required_inside).chain(&self.inspected).map(|&(number, _)| number));
        waiting.extend(self.ways.iter().chain(&self.settled).map(|&(condition, _)| condition));
        while let Some(node) = waiting.pop() {
            if needed.insert(node) {
                match self.what(node) {
                    Definition::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                    Definition::Read(access) => waiting.push(self.accesses[access].pointer),
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
            Definition::Read(access) => place(access).map_or(Definition::Constant(0), Definition::Read),
            what => what,
        });
        let nodes = nodes.collect();
        let step = |step: &Effect| match *step {
            Effect::Access(access) => place(access).map(Effect::Access),
            Effect::Copy(_) | Effect::Inner => Some(*step),
        };
        let [outer, inner] = [Some(&self.outer), self.inner.as_ref()].map(|iteration| {
            let steps = iteration.map_or(&[][..], |iteration| &iteration.steps).iter();
            steps.filter_map(step).collect::<Vec<Effect>>()
        });
        let accesses = kept.iter().map(|&access| self.accesses[access].clone()).collect();
        let reads = kept.iter().map(|&access| self.reads[access]).collect();
        (self.nodes, self.accesses, self.reads, self.outer.steps) = (nodes, accesses, reads, outer);
        if let Some(iteration) = &mut self.inner {
            iteration.steps = inner;
        }
    }

    /// Whether a number that rests on no memory is made of the same parts so often that writing it down would take long: before
    /// a loop such numbers are written as often as they occur.
    pub(super) fn repeats_itself(&self) -> bool {
        let mut sizes: Vec<Option<u64>> = Vec::with_capacity(self.nodes.len());
        let known = |sizes: &[Option<u64>], Node(node): Node| sizes.get(node as usize).copied().flatten();
        let size_of = |sizes: &[Option<u64>], node: Node| match self.what(node) {
            // A condition that was made of two behind all others.
            Definition::Compute(op, args) if node.0 as usize >= sizes.len() => {
                let parts = args[..op.arity()].iter().map(|&arg| known(sizes, arg));
                parts.sum::<Option<u64>>().map(|parts| parts + 1)
            }
            _ => known(sizes, node),
        };
        for what in &self.nodes {
            let size = match *what {
                Definition::Constant(_) | Definition::Start(Level::Outer, _) => Some(1),
                Definition::Start(Level::Inner, slot) => {
                    let entry = self.inner.as_ref().and_then(|inner| inner.entry.get(&slot));
                    Some(1 + entry.and_then(|&entry| size_of(&sizes, entry)).unwrap_or(0))
                }
                Definition::Compute(op, args) => {
                    let parts = args[..op.arity()].iter().map(|&arg| size_of(&sizes, arg));
                    parts.sum::<Option<u64>>().map(|parts| parts + 1)
                }
                Definition::After(_) | Definition::Read(_) => None,
            };
            if size.is_some_and(|size| size > SIZE_MAX) {
                return true;
            }
            sizes.push(size);
        }
        false
    }

    pub(super) fn what(&self, Node(node): Node) -> Definition {
        self.nodes[node as usize]
    }

    pub(super) fn kept(&self, Slot(slot): Slot) -> SlotKind {
        self.slots[usize::from(slot)]
    }

    pub(super) fn iteration(&self, level: Level) -> &Iteration {
        match (level, &self.inner) {
            (Level::Inner, Some(inner)) => inner,
            _ => &self.outer,
        }
    }

    pub(super) fn constant(&self, node: Node) -> Option<u64> {
        match self.what(node) {
            Definition::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// What an access reads, as a value.
    pub(super) fn read_of(&self, access: usize) -> Node {
        self.reads[access]
    }

    /// Slots with something that the loop may look at when it begins.
    pub(super) fn slots_at_start(&self) -> BTreeSet<Slot> {
        let starts = self.nodes.iter().filter_map(|what| match what {
            Definition::Start(_, slot) => Some(*slot),
            _ => None,
        });
        let all = starts.chain(self.outer.ends.keys().copied());
        all.filter(|&slot| !matches!(self.kept(slot), SlotKind::Element { .. } | SlotKind::Ahead { .. })).collect()
    }

    /// What the slots of both loops hold at the ends of their iterations, and when the inner one begins.
    pub(super) fn all_ends(&self) -> impl Iterator<Item = Node> {
        let inner = self.inner.iter().flat_map(|inner| inner.ends.values().chain(inner.entry.values()));
        self.outer.ends.values().chain(inner).copied()
    }

    /// Adds all values on which one rests in an iteration.
    pub(super) fn rests(&self, node: Node, all: &mut BTreeSet<Node>) {
        if all.insert(node)
            && let Definition::Compute(op, args) = self.what(node)
        {
            args[..op.arity()].iter().for_each(|&arg| self.rests(arg, all));
        }
    }

    /// Whether a value is what a slot holds when an iteration begins.
    pub(super) fn is_start(&self, node: Node, level: Level, slot: Slot) -> bool {
        self.what(node) == Definition::Start(level, slot)
    }
}

impl Kernel {
    /// Whether a slot has 16 bits or fewer.
    pub(super) fn is_word(&self, slot: Slot) -> bool {
        matches!(
            self.kept(slot),
            SlotKind::Memory { width: Width::Bit | Width::Byte | Width::Word, .. }
                | SlotKind::Element { width: Width::Bit | Width::Byte | Width::Word, .. }
                | SlotKind::Ahead { width: Width::Bit | Width::Byte | Width::Word, .. }
        )
    }

    pub(super) fn is_16_bits(&self, node: Node) -> bool {
        self.holds_of_chosen(node, &[Op::Select, Op::Gate], &|what| match what {
            Definition::Constant(value) => value <= 0xFFFF,
            Definition::Start(_, slot) | Definition::After(slot) => self.is_word(slot),
            Definition::Read(access) => self.accesses[access].width.bytes() <= 2,
            Definition::Compute(op, _) => {
                let divides = matches!(op, Op::DivI16 | Op::RemI16);
                divides || matches!(op, Op::AddU16 | Op::SubU16 | Op::MulU16 | Op::Low16 | Op::Low8 | Op::Decrement16)
            }
        })
    }

    pub(super) fn is_32_bits(&self, node: Node) -> bool {
        self.holds_of_chosen(node, &[Op::Select, Op::Gate], &|what| match what {
            Definition::Constant(value) => u32::try_from(value).is_ok(),
            Definition::Start(_, slot) | Definition::After(slot) => !self.kept(slot).is_wide(),
            Definition::Read(access) => self.accesses[access].width != Width::QuadWord,
            Definition::Compute(op, _) => !op.is_wide(),
        })
    }

    pub(super) fn is_bit(&self, node: Node) -> bool {
        self.holds_of_chosen(node, &[Op::Select], &|what| match what {
            Definition::Read(access) => self.accesses[access].width == Width::Bit,
            Definition::Start(_, slot) | Definition::After(slot) => matches!(self.kept(slot), SlotKind::Memory { width: Width::Bit, .. }),
            Definition::Compute(op, _) => {
                let fails = matches!(op, Op::DivFailsI16 | Op::DivFailsI32 | Op::DivFailsI64);
                fails || Self::compares(op) || matches!(op, Op::Not | Op::And | Op::AndNot | Op::Or | Op::Xor | Op::IsNonzero | Op::Below)
            }
            Definition::Constant(value) => value <= 1,
        })
    }

    /// Whether something holds of all values of which these operations choose one. Each is looked at once, however many choices lead to it.
    fn holds_of_chosen(&self, node: Node, choices: &[Op], holds: &dyn Fn(Definition) -> bool) -> bool {
        let chosen = |what: Definition| match what {
            Definition::Compute(op, [_, a, b, _]) if op == Op::Select && choices.contains(&op) => Some([a, b]),
            Definition::Compute(op, [a, ..]) if op == Op::Gate && choices.contains(&op) => Some([a, a]),
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
    pub(super) fn add(&mut self, what: Definition) -> Node {
        self.nodes.push(what);
        Node::numbered(self.nodes.len() as u32 - 1)
    }

    /// Whether access by computed addresses and slots, and slots among each other, share no bytes that one of them writes.
    pub(super) fn is_apart(&self) -> bool {
        let written = |slot: usize| {
            let slot = Slot(slot as u16);
            self.outer.ends.contains_key(&slot)
        };
        let spans: Vec<_> = self.slots.iter().map(|kept| kept.bytes()).collect();
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

impl SlotKind {
    /// Whether it holds 64 bits.
    pub(super) fn is_wide(self) -> bool {
        let (Self::Memory { width, .. } | Self::Element { width, .. } | Self::Ahead { width, .. }) = self else {
            return false;
        };
        width == Width::QuadWord
    }

    /// The bytes that a slot stands for, and which bit of them.
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

    use super::{Definition, Kernel, Node};

    /// Choices between the choice before and itself, a hundred of them behind a number: no one could go all ways through them.
    fn chosen(number: u64, op: Op) -> (Kernel, Node) {
        let mut kernel = Kernel::empty();
        kernel.nodes = vec![Definition::Constant(0), Definition::Constant(number)];
        for before in (1..=100).map(Node::numbered) {
            let condition = Node::numbered(0);
            let args = if op == Op::Select { [condition, before, before, before] } else { [before, condition, condition, condition] };
            kernel.nodes.push(Definition::Compute(op, args));
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
