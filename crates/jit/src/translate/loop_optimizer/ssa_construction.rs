//! SSA construction of a loop body: what the statements of an iteration make of the values at its beginning. Forward branches become
//! selects, and inlined blocks are part of the iteration.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use sieben_engine::access::data_registers;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Callee, Inst, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_model::address::Width;

use super::super::bounds_checks::FIRST_BYTE;
use super::super::natural_loops::NaturalLoop;
use super::super::range_analysis::{self, ByteRange, Interval, Ranges};
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::super::{Translator, bit_of};
use super::available_values::AvailableValues;
use super::kernel::{Access, Definition, Effect, Iteration, Kernel, Level, Node, Slot, SlotKind};
use super::path_predicates::{PathPredicate, PathPredicates};

mod bits;
mod called;
mod calls;
mod cases;
mod inner_loops;
mod places;

pub(super) use calls::{Called, Instances};
use inner_loops::InnerIterations;
pub(super) use inner_loops::read_unrolled;
pub(super) use places::{Goes, Reached};

/// Instructions of an iteration that is looked at, with those of the blocks that are part of it.
const INSTRUCTIONS_MAX: usize = 2000;
/// Longer ones are done one by one as they are written.
const INSTRUCTIONS_ALONE_MAX: usize = 640;
/// Instructions that an iteration computes though it may jump over them, where iterations are done side by side.
const CHOSEN_MAX: usize = 500;
/// The same where it is read with the iterations of inner loops one behind the other.
const CHOSEN_UNROLLED_MAX: usize = 1_000;
/// The same where they are done one by one: beyond that, it would be faster to jump.
const CHOSEN_ALONE_MAX: usize = 160;
/// How often a loop in a called block is read to find what it writes.
const READINGS_MAX: usize = 4;
/// What a division by an unknown number counts among them.
const DIVISION: usize = 60;
/// Choices in choices in which a condition is looked for.
const CHOICES_MAX: usize = 6;
/// How far the range of a value is followed back.
pub(super) const DEPTH_MAX: usize = 8;

/// Reads a loop; `None` if an iteration of it does more than a kernel can say.
pub(super) fn read(translator: &mut Translator<'_>, it: &NaturalLoop) -> Option<Kernel> {
    if !it.asks_nothing {
        return None;
    }
    let mut inner = translator.loops.iter().filter(|inner| inner.first > it.first && inner.last <= it.last);
    let inside = inner.next().cloned();
    if inner.next().is_some() {
        return None;
    }
    read_as(translator, it, ConstructionMode { inside, ..ConstructionMode::default() })
}

/// Reads one way through an iteration of a loop: which way each of its jumps goes is a bit of a number, the lowest one that of the first
/// jump, and not set where the jump is made. What has to hold for that is noted with the kernel.
pub(super) fn read_way(translator: &mut Translator<'_>, it: &NaturalLoop, ways: u32) -> Option<Kernel> {
    read_as(translator, it, ConstructionMode { one_way: Some(ways), ..ConstructionMode::default() })
}

/// Reads a loop whose iterations are done one by one: they copy structures as a whole, and of variables at constant distances from each
/// other it is known that they are.
pub(super) fn read_one_by_one(translator: &mut Translator<'_>, it: &NaturalLoop) -> Option<Kernel> {
    let has_loop = translator.loops.iter().any(|inner| inner.first > it.first && inner.last <= it.last);
    if !it.asks_nothing || has_loop {
        return None;
    }
    let kernel = read_as(translator, it, ConstructionMode { whole_copies: true, ..ConstructionMode::default() })?;
    kernel.inner.is_none().then_some(kernel)
}

/// How an iteration is read.
#[derive(Default)]
struct ConstructionMode {
    /// The loop in it.
    inside: Option<NaturalLoop>,
    /// Which way alone.
    one_way: Option<u32>,
    /// Copies are done as a whole, not as numbers.
    whole_copies: bool,
    /// The iterations of inner loops are read one behind the other.
    unrolled: bool,
}

fn read_as(
    translator: &mut Translator<'_>,
    it: &NaturalLoop,
    ConstructionMode { inside, one_way, whole_copies, unrolled }: ConstructionMode,
) -> Option<Kernel> {
    let facts = [Some(it.first), inside.as_ref().map(|inside| inside.first)].map(|first| facts(translator, first));
    let statements_inside = inside.as_ref().map(|inside| (inside.first, inside.last));
    let mut reader = SsaBuilder::new(translator, it.written, facts);
    (reader.inside, reader.reads_tables, reader.one_way) = (inside, !it.calls_nothing, one_way);
    (reader.whole_copies, reader.unrolled) = (whole_copies, unrolled);
    // A block that reaches its instance by AR2 and nothing else counts from there.
    let pointer = reader.translator.current[Register::Ar2 as usize];
    if reader.translator.ranges.is_relative() {
        reader.translator.current[Register::Ar2 as usize] = Some(Val::Const(FIRST_BYTE));
    }
    let outer = reader.iteration((it.first, it.last));
    reader.leave_frames(0);
    reader.translator.current[Register::Ar2 as usize] = pointer;
    reader.kernel.outer = outer?;
    if unrolled && !reader.has_few_iterations_inside() {
        return None;
    }
    reader.choose_pointers()?;
    let mut kernel = reader.kernel;
    kernel.size = reader.translator.layout.size;
    kernel.only_side_by_side = reader.only_side_by_side || reader.chosen > CHOSEN_ALONE_MAX || reader.read > INSTRUCTIONS_ALONE_MAX;
    kernel.shorten_choices();
    kernel.add_at_once();
    kernel.forget_unread();
    kernel.live = !(translator.dead_at(it.first) & translator.dead_at(it.last + 1));
    let live_inside = statements_inside.map_or(!0, |(first, last)| !(translator.dead_at(first) & translator.dead_at(last + 1)));
    kernel.forget_dead(live_inside);
    if one_way.is_none() {
        kernel.look_at_others();
    }
    (kernel.is_apart() && kernel.settles_in_front()).then_some(kernel)
}

/// Ranges of the variables in memory when an iteration begins.
fn facts(translator: &Translator<'_>, first: Option<u32>) -> Vec<(SlotKind, Interval)> {
    let facts = first.map_or(&[][..], |first| translator.ranges.facts(first));
    let kept = facts.iter().map(|fact| {
        let (base, offset, width) = fact.variable;
        (SlotKind::Memory { base, offset, width, bit: 0 }, fact.range)
    });
    kept.collect()
}

/// What waits while a called block is read.
struct Frame {
    index: usize,
    local_offset: i32,
    ranges: Ranges,
    vals: Vec<Val>,
    instance: Val,
    pointer: Option<Val>,
    given: Vec<Node>,
    passed: Vec<Node>,
    inside: Option<NaturalLoop>,
    facts_inside: Vec<(SlotKind, Interval)>,
}

/// What is read when statements follow one another.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Region {
    /// An iteration of a loop.
    Iteration,
    /// A block that is called.
    Block,
}

/// How much has been read, so that what follows can be read again.
struct Mark {
    nodes: usize,
    slots: usize,
    accesses: usize,
    unsure: usize,
    required: [usize; 2],
    ranges: HashMap<Node, Interval>,
    bounds: BTreeMap<Node, (u32, u32)>,
    met: BTreeSet<Node>,
    read: usize,
    chosen: usize,
}

pub(super) struct SsaBuilder<'t, 'a> {
    translator: &'t mut Translator<'a>,
    /// Registers that the loop changes.
    written: u32,
    /// The loop in the block that is read, or in the iteration.
    inside: Option<NaturalLoop>,
    pub(super) kernel: Kernel,
    numbers: HashMap<Definition, Node>,
    /// What slots hold before the inner loop, while that is read.
    outer: BTreeMap<Slot, Node>,
    /// What slots hold that the iteration has written so far.
    now: BTreeMap<Slot, Node>,
    level: Level,
    /// What the inner loop writes, once that is known.
    written_inside: Option<BTreeSet<Slot>>,
    /// Variables at computed addresses that all iterations of the inner loop share.
    elements: Vec<Access>,
    temporaries: BTreeMap<u8, Node>,
    /// The ways on which the running statement is reached.
    pub(super) ways: PathPredicates,
    /// What is known of memory at computed addresses.
    pub(super) held: AvailableValues,
    /// Callers of the block that is read.
    frames: Vec<Frame>,
    /// Pointers for the block that is called next.
    passed: Vec<Node>,
    /// Pointers that the caller gave.
    given: Vec<Node>,
    /// Ranges of variables when an iteration of the whole loop begins, and one of the inner loop.
    facts: [Vec<(SlotKind, Interval)>; 2],
    /// Variables in local data that are read or written, and when they were written last.
    touched: BTreeMap<Slot, usize>,
    writes: usize,
    /// Ranges that values have in each iteration.
    ranges: HashMap<Node, Interval>,
    /// Conditions that hold in each iteration.
    met: BTreeSet<Node>,
    /// Accesses whose range is known only where they are reached, and whether they are.
    unsure: Vec<(usize, Node)>,
    /// Instructions read so far, and those of them that some iterations jump over.
    read: usize,
    chosen: usize,
    /// What entering blocks takes from the budget in each iteration, and at most.
    blocks: u32,
    blocks_most: u32,
    /// Whether choices by numbers are worth it: not in iterations that do little else, where a jump is as fast as four choices.
    reads_tables: bool,
    only_side_by_side: bool,
    /// Conditions of which one holds at most: those of the ways behind a choice by a number.
    exclusive: Vec<Vec<Node>>,
    /// Which way jumps go that have not been reached yet, if one way alone is read.
    one_way: Option<u32>,
    /// Whether copies are done as a whole.
    pub(super) whole_copies: bool,
    /// Whether inner loops are read iteration by iteration, and how often they have jumped back.
    unrolled: bool,
    jumped_back: usize,
    /// Instructions of iterations of inner loops that most iterations do without.
    repeated: usize,
    /// Ways that no iteration goes: that is looked at before the loop.
    beyond: PathPredicates,
}

impl<'t, 'a> SsaBuilder<'t, 'a> {
    /// Reads iterations that change some registers, with what is known of variables when one begins.
    pub(super) fn new(translator: &'t mut Translator<'a>, written: u32, facts: [Vec<(SlotKind, Interval)>; 2]) -> Self {
        SsaBuilder {
            kernel: Kernel { passes: translator.options.passes, ..Kernel::empty() },
            translator,
            written,
            inside: None,
            numbers: HashMap::new(),
            outer: BTreeMap::new(),
            now: BTreeMap::new(),
            level: Level::Outer,
            written_inside: None,
            elements: Vec::new(),
            temporaries: BTreeMap::new(),
            ways: PathPredicates::always(),
            held: AvailableValues::default(),
            frames: Vec::new(),
            passed: Vec::new(),
            given: Vec::new(),
            facts,
            touched: BTreeMap::new(),
            writes: 0,
            ranges: HashMap::new(),
            met: BTreeSet::new(),
            unsure: Vec::new(),
            read: 0,
            chosen: 0,
            blocks: 0,
            blocks_most: 0,
            reads_tables: true,
            only_side_by_side: false,
            exclusive: Vec::new(),
            one_way: None,
            whole_copies: false,
            unrolled: false,
            jumped_back: 0,
            repeated: 0,
            beyond: PathPredicates::default(),
        }
    }
}

impl SsaBuilder<'_, '_> {
    fn iteration(&mut self, (first, last): (u32, u32)) -> Option<Iteration> {
        let mut steps = Vec::new();
        self.held.forget();
        (self.blocks, self.blocks_most) = (0, 0);
        let again = self.statements((first, last), Region::Iteration, &mut steps)?;
        self.write_held(&mut steps);
        self.held.forget();
        self.forget_handed()?;
        let weight = self.translator.native().weight_of_jump((last, first));
        let (blocks, blocks_most) = (self.blocks, self.blocks_most);
        Some(Iteration { steps, ends: std::mem::take(&mut self.now), entry: BTreeMap::new(), again: again?, weight, blocks, blocks_most })
    }

    /// Reads statements that follow one another; the condition under which the last one jumps back to the first.
    fn statements(&mut self, (first, last): (u32, u32), piece: Region, steps: &mut Vec<Effect>) -> Option<Option<Node>> {
        let code = &self.translator.native().code;
        let is_loop = piece == Region::Iteration;
        let mut arriving: BTreeMap<u32, PathPredicates> = BTreeMap::new();
        let mut rounds = InnerIterations::default();
        let mut again = None;
        let mut statement = first;
        while statement <= last {
            if let Some(ways) = arriving.remove(&statement) {
                self.ways.join(ways)?;
                self.join_beyond();
            }
            if self.ways.is_never() {
                statement += 1;
                continue;
            }
            if let Some(written_out) = &self.translator.native().written_out {
                if written_out.more(statement).is_some() {
                    return None;
                }
                if let Some(iterations) = written_out.next_iteration(statement) {
                    self.take(iterations.weight.into())?;
                }
            }
            if self.unrolled {
                rounds.reach(statement, &self.ways);
            }
            if self.level == Level::Outer
                && let Some(inside) = self.inside.clone()
                && inside.first == statement
            {
                if !self.ways.is_always() {
                    return None;
                }
                self.inner(&inside, steps)?;
                statement = inside.last + 1;
                continue;
            }
            self.temporaries.clear();
            let insts = code.statement(statement as usize);
            let before = self.read;
            self.read += insts.len();
            if !self.ways.is_always() {
                self.chosen += insts.len();
            }
            let chosen_max = if self.unrolled { CHOSEN_UNROLLED_MAX } else { CHOSEN_MAX };
            if self.read > INSTRUCTIONS_MAX || self.chosen > chosen_max {
                return None;
            }
            let mut back = None;
            for (at, (index, inst)) in (code.statements[statement as usize]..).zip(insts).enumerate() {
                if self.ways.is_never() {
                    break;
                }
                let is_last = at + 1 == insts.len();
                let is_ahead = |to: u32| to > statement && to <= last;
                match *inst {
                    Inst::Branch { condition, to: Target(to) } if is_last && is_loop && to == first && statement == last => {
                        if !self.ways.is_always() {
                            return None;
                        }
                        again = Some(self.get(condition)?);
                    }
                    // Who leaves the loop does not go on with the iteration.
                    Inst::Branch { condition, to: Target(to) } if self.one_way.is_some() && to > last => {
                        let condition = self.get(condition)?;
                        self.kernel.ways.push((condition, false));
                    }
                    Inst::Branch { condition, to: Target(to) } if is_ahead(to) => {
                        let condition = self.get(condition)?;
                        if self.jumps_over_inner(statement, to) && self.kernel.constant(condition).is_none() {
                            let (condition, holds) = self.positive(condition);
                            self.kernel.settled.push((condition, !holds));
                            continue;
                        }
                        let (taken, other) = self.ways_behind(condition);
                        arriving.entry(to).or_default().join(taken)?;
                        self.ways = other;
                    }
                    Inst::Jump { to: Target(to) } if is_last && is_ahead(to) => {
                        let ways = std::mem::take(&mut self.ways);
                        arriving.entry(to).or_default().join(ways)?;
                    }
                    Inst::JumpTable { index, first: entry, count, otherwise: Target(otherwise) } if is_last && self.reads_tables => {
                        let targets = code.tables.get(entry as usize..(entry + count) as usize)?;
                        if !targets.iter().all(|&Target(to)| is_ahead(to)) || !is_ahead(otherwise) {
                            return None;
                        }
                        self.only_side_by_side = true;
                        let index = self.get(index).filter(|&index| self.kernel.is_32_bits(index))?;
                        for (to, taken) in self.ways_of_table(index, targets, otherwise) {
                            arriving.entry(to).or_default().join(taken)?;
                        }
                        let ways = std::mem::take(&mut self.ways);
                        arriving.entry(otherwise).or_default().join(ways)?;
                    }
                    Inst::Branch { condition, to: Target(to) } if self.unrolled && to <= statement && back.is_none() => {
                        let condition = self.get(condition)?;
                        let (taken, other) = match self.kernel.constant(condition) {
                            Some(value) if value & 1 != 0 => (std::mem::take(&mut self.ways), PathPredicates::default()),
                            Some(_) => (PathPredicates::default(), std::mem::take(&mut self.ways)),
                            None => self.ways_behind(condition),
                        };
                        self.ways = other;
                        back = Some((to, taken));
                    }
                    Inst::Jump { to: Target(to) } if is_last && self.unrolled && to <= statement && back.is_none() => {
                        back = Some((to, std::mem::take(&mut self.ways)));
                    }
                    Inst::Return if is_last && !is_loop && statement == last => {}
                    Inst::Call { callee: Callee::Block(id), parameters } if self.one_way.is_none() => {
                        let called = (self.translator.find)(id)? as usize;
                        self.call(called, usize::from(parameters), steps)?;
                    }
                    _ => self.inst(index, inst, steps)?,
                }
            }
            if rounds.is_unlikely(statement) {
                self.repeated += self.read - before;
            }
            statement += 1;
            match back {
                Some((to, ways)) if rounds.is_over(to, &ways) => self.never(ways)?,
                Some((to, ways)) if !ways.is_never() => {
                    let others = std::mem::replace(&mut self.ways, ways);
                    if !others.is_never() {
                        arriving.entry(statement).or_default().join(others)?;
                    }
                    self.jump_back(&mut rounds, statement - 1, to)?;
                    statement = to;
                }
                _ => {}
            }
        }
        Some(again)
    }

    /// Reads the inner loop: once to see what it writes, and once more with what else is known. Where its iterations write variables at
    /// addresses that are the same in all of them, it is read again with these as slots.
    fn inner(&mut self, inside: &NaturalLoop, steps: &mut Vec<Effect>) -> Option<()> {
        // There is only one.
        if self.kernel.inner.is_some() {
            return None;
        }
        let statements = (inside.first, inside.last);
        let held = std::mem::take(&mut self.held);
        let before = self.mark();
        let blocks = (self.blocks, self.blocks_most);
        self.outer = std::mem::take(&mut self.now);
        self.level = Level::Inner;
        let mut written = if self.frames.is_empty() {
            let written: BTreeSet<Slot> = self.iteration(statements)?.ends.into_keys().collect();
            self.read_again(&before);
            written
        } else {
            self.written_in_called(statements, &before)?
        };
        self.written_inside = Some(written.clone());
        let mut iteration = self.iteration(statements)?;
        if iteration.ends.keys().eq(&written) {
            self.elements = self.elements_of(before.accesses);
        }
        if !self.elements.is_empty() {
            self.read_again(&before);
            // It was read once already.
            (self.read, self.chosen) = (before.read, before.chosen);
            for number in 0..self.elements.len() {
                let slot = self.element(number);
                written.insert(slot);
            }
            self.written_inside = Some(written.clone());
            iteration = self.iteration(statements)?;
        }
        self.level = Level::Outer;
        self.now = std::mem::take(&mut self.outer);
        self.held = held;
        (self.blocks, self.blocks_most) = blocks;
        // Each of its iterations takes the same from the budget.
        // What one iteration writes as a variable the next one may read as part of it.
        let shared = |&slot: &Slot| self.touched.keys().any(|&other| self.shares_local(slot, other));
        if iteration.ends.keys().any(shared) {
            return None;
        }
        if !iteration.ends.keys().eq(written.iter()) || iteration.blocks != iteration.blocks_most {
            return None;
        }
        let elements = std::mem::take(&mut self.elements);
        for slot in written {
            let before = match self.kernel.kept(slot) {
                SlotKind::Element { number, .. } => self.take_held(elements[usize::from(number)].clone(), steps),
                _ => self.read_slot(slot),
            };
            iteration.entry.insert(slot, before);
        }
        self.write_held(steps);
        self.held.forget();
        steps.push(Effect::Inner);
        for &slot in iteration.ends.keys() {
            let after = self.node(Definition::After(slot));
            match self.kernel.kept(slot) {
                SlotKind::Element { number, .. } => self.write_at(elements[usize::from(number)].clone(), after, steps),
                _ => drop(self.now.insert(slot, after)),
            }
        }
        self.kernel.inner = Some(iteration);
        Some(())
    }

    /// What the iterations of a loop in a called block write. Pointers that the block was given lie in memory: what no iteration writes is
    /// taken to be what it was before the loop, first of all, then all but what iterations write that are read so, until they write no
    /// other slots.
    fn written_in_called(&mut self, statements: (u32, u32), before: &Mark) -> Option<BTreeSet<Slot>> {
        let mut written = BTreeSet::new();
        for _ in 0..READINGS_MAX {
            self.written_inside = Some(written.clone());
            let ends = self.iteration(statements)?.ends;
            let is_all = ends.keys().eq(&written);
            // Slots that were new in this reading are numbered again in the next one.
            let kept: Vec<SlotKind> = ends.keys().map(|&slot| self.kernel.kept(slot)).collect();
            self.read_anew(before);
            written = kept.into_iter().map(|kept| self.slot(kept)).collect();
            if is_all {
                return Some(written);
            }
        }
        None
    }

    fn mark(&self) -> Mark {
        Mark {
            nodes: self.kernel.nodes.len(),
            slots: self.kernel.slots.len(),
            accesses: self.kernel.accesses.len(),
            unsure: self.unsure.len(),
            required: [self.kernel.required.len(), self.kernel.required_inside.len()],
            ranges: self.ranges.clone(),
            bounds: self.kernel.bounds.clone(),
            met: self.met.clone(),
            read: self.read,
            chosen: self.chosen,
        }
    }

    /// Forgets what a loop did when it was read before: what is read then may be something else.
    fn read_again(&mut self, before: &Mark) {
        self.ranges.clone_from(&before.ranges);
        self.met.clone_from(&before.met);
        self.kernel.bounds.clone_from(&before.bounds);
        self.kernel.accesses.truncate(before.accesses);
        self.kernel.reads.truncate(before.accesses);
        self.kernel.required.truncate(before.required[0]);
        self.kernel.required_inside.truncate(before.required[1]);
        self.unsure.truncate(before.unsure);
    }

    /// The same, with all values and slots.
    fn read_anew(&mut self, before: &Mark) {
        self.read_again(before);
        self.kernel.nodes.truncate(before.nodes);
        self.numbers.retain(|_, node| (node.number() as usize) < before.nodes);
        self.kernel.slots.truncate(before.slots);
        self.touched.retain(|slot, _| slot.number() < before.slots);
        self.temporaries.clear();
        (self.read, self.chosen) = (before.read, before.chosen);
    }

    /// Variables that the iterations of the inner loop write at addresses that are the same in all of them, and to which no other access
    /// goes, of the accesses from a number on.
    fn elements_of(&self, first: usize) -> Vec<Access> {
        let accesses = &self.kernel.accesses[first..];
        let mut elements: Vec<Access> = Vec::new();
        for access in accesses.iter().filter(|access| access.value.is_some() && access.width != Width::Bit) {
            let others_are_apart = accesses.iter().all(|other| access.is_same(other) && other.sure || !access.may_meet(other));
            if self.kernel.is_fixed(access.pointer, &mut HashMap::new())
                && others_are_apart
                && !elements.iter().any(|known| known.is_same(access))
            {
                elements.push(Access { level: Level::Outer, value: None, ..access.clone() });
            }
        }
        elements
    }

    fn element(&mut self, number: usize) -> Slot {
        let width = self.elements[number].width;
        self.slot(SlotKind::Element { number: number as u16, width })
    }

    /// The slot of a variable that the iterations of the inner loop share.
    fn element_at(&mut self, access: &Access) -> Option<Slot> {
        if self.level == Level::Outer {
            return None;
        }
        let number = self.elements.iter().position(|element| element.is_same(access))?;
        Some(self.element(number))
    }

    pub(super) fn node(&mut self, what: Definition) -> Node {
        *self.numbers.entry(what).or_insert_with(|| self.kernel.add(what))
    }

    pub(super) fn constant(&mut self, value: u64) -> Node {
        self.node(Definition::Constant(value))
    }

    fn slot(&mut self, kept: SlotKind) -> Slot {
        let slots = &mut self.kernel.slots;
        let at = slots.iter().position(|&known| known == kept).unwrap_or(slots.len());
        if at == slots.len() {
            slots.push(kept);
        }
        Slot::numbered(at as u16)
    }

    /// Notes that a slot is written, if it lies in local data.
    fn written_in_local(&mut self, slot: Slot) {
        if let SlotKind::Memory { base: Base::Local, .. } = self.kernel.kept(slot) {
            self.writes += 1;
            self.touched.insert(slot, self.writes);
        }
    }

    /// Notes that a slot is read, if it lies in local data; `None` if some of its bits were written as those of another one since.
    fn read_in_local(&mut self, slot: Slot) -> Option<()> {
        if let SlotKind::Memory { base: Base::Local, .. } = self.kernel.kept(slot) {
            let written = *self.touched.entry(slot).or_insert(0);
            if self.touched.iter().any(|(&other, &later)| later > written && self.shares_local(slot, other)) {
                return None;
            }
        }
        Some(())
    }

    /// Whether two slots in local data that are not the same have bits in common.
    fn shares_local(&self, slot: Slot, other: Slot) -> bool {
        let [Some((base, bytes, bit)), Some((other_base, others, other_bit))] = [slot, other].map(|slot| self.kernel.kept(slot).bytes())
        else {
            return false;
        };
        let is_local = base == Base::Local && base.may_share(&bytes, other_base, &others);
        slot != other && is_local && (bit.is_none() || other_bit.is_none() || bit == other_bit)
    }

    /// What a slot holds, whatever way led here.
    fn read_slot(&mut self, slot: Slot) -> Node {
        if let Some(&node) = self.now.get(&slot) {
            return node;
        }
        if let SlotKind::Memory { base: Base::Local, offset, width, .. } = self.kernel.kept(slot)
            && let Some(value) = self.translator.constant_word(offset, width)
            && !self.outer.contains_key(&slot)
        {
            // No iteration writes what is known before the loop.
            return self.constant(value);
        }
        let mut level = self.level;
        if level == Level::Inner && !self.is_written_inside(slot) {
            if let Some(&node) = self.outer.get(&slot) {
                return node;
            }
            level = Level::Outer;
        }
        let node = self.node(Definition::Start(level, slot));
        let kept = self.kernel.kept(slot);
        if let Some(&(_, range)) = self.facts[usize::from(level == Level::Inner)].iter().find(|(known, _)| *known == kept) {
            self.ranges.insert(node, range);
        }
        node
    }

    /// What a slot holds on the ways that led here.
    pub(super) fn read_here(&mut self, slot: Slot) -> Option<Node> {
        if let Some(node) = self.made_otherwise(slot) {
            return Some(self.known_here(node));
        }
        self.read_in_local(slot)?;
        let node = self.read_slot(slot);
        Some(self.known_here(node))
    }

    /// Writes a variable; `None` if it lies in local data and where it is not written nobody knows what it is.
    pub(super) fn write_here(&mut self, slot: Slot, value: Node) -> Option<()> {
        if !self.ways.is_always() {
            // Where it is not written it stays what others made of its bits.
            match self.made_otherwise(slot) {
                Some(before) => drop(self.now.insert(slot, before)),
                None => self.read_in_local(slot)?,
            }
        }
        self.written_in_local(slot);
        self.put(slot, value);
        Some(())
    }

    /// The bytes that a copy reads and writes, if they are known to lie inside their areas where it is reached.
    pub(super) fn moved(&self, index: u32) -> Option<[ByteRange; 2]> {
        Some(self.translator.ranges.moved(index)?.map(|(base, bytes)| (base.area(), bytes)))
    }

    /// Writes a slot on the ways that led here.
    fn put(&mut self, slot: Slot, value: Node) {
        let value = if self.ways.is_always() {
            value
        } else {
            let before = self.now_in(slot);
            let chosen = self.chosen(value, before);
            self.without_start(slot, (value, before), chosen)
        };
        self.now.insert(slot, value);
    }

    /// What is chosen between a value and what a slot held before: of a variable to which each branch of a CASE writes nothing uses what it
    /// held when the iteration began, which only a look at choices in choices shows.
    fn without_start(&mut self, slot: Slot, (value, before): (Node, Node), chosen: Node) -> Node {
        let Some(&start) = self.numbers.get(&Definition::Start(self.level, slot)) else { return chosen };
        let needs_start = |this: &Self, node: Node| {
            let mut rests = BTreeSet::new();
            this.kernel.rests(node, &mut rests);
            rests.contains(&start)
        };
        if before == start || !needs_start(self, chosen) {
            return chosen;
        }
        let shortest = self.chosen_within(value, before, CHOICES_MAX);
        if needs_start(self, shortest) { chosen } else { shortest }
    }

    /// Whether the running loop is the inner one, and its iterations may write a slot.
    fn is_written_inside(&self, slot: Slot) -> bool {
        self.level == Level::Inner && self.written_inside.as_ref().is_none_or(|written| written.contains(&slot))
    }

    /// What a slot holds, which may be known of a register that the iteration has not written.
    fn now_in(&mut self, slot: Slot) -> Node {
        if let SlotKind::Register(register) = self.kernel.kept(slot) {
            let is_written = [&self.now, &self.outer].iter().any(|written| written.contains_key(&slot));
            // AR2 may be known when an iteration begins though iterations change it.
            let as_it_began =
                !is_written && (self.written & bit_of(register) == 0 || register == Register::Ar2 && !self.is_written_inside(slot));
            if as_it_began && let Some(Val::Const(value)) = self.translator.current[register as usize] {
                return self.constant(value);
            }
        }
        self.read_slot(slot)
    }

    /// A value on the ways that led here, another one on all others.
    pub(super) fn chosen(&mut self, value: Node, other: Node) -> Node {
        self.chosen_within(value, other, 0)
    }

    /// The same with a look at so many choices in choices.
    fn chosen_within(&mut self, value: Node, other: Node, depth: usize) -> Node {
        let ways = self.ways.clone();
        ways.each().iter().fold(other, |other, way| self.on_way(way, value, other, depth))
    }

    fn on_way(&mut self, way: &[(Node, bool)], value: Node, other: Node, depth: usize) -> Node {
        let Some((&(condition, holds), rest)) = way.split_first() else { return value };
        let [here, there] = [holds, !holds].map(|holds| self.known_inside(other, (condition, holds), depth));
        let here = self.on_way(rest, value, here, depth);
        let (a, b) = if holds { (here, there) } else { (there, here) };
        self.compute(Op::Select, [condition, a, b, condition])
    }

    /// A value where a condition is known to hold or not, with what that makes of so many choices in choices.
    fn known_inside(&mut self, node: Node, known: (Node, bool), depth: usize) -> Node {
        let node = self.known(node, &vec![known]);
        match self.kernel.what(node) {
            Definition::Compute(Op::Select, [condition, a, b, _]) if depth > 0 => {
                let [here, there] = [a, b].map(|side| self.known_inside(side, known, depth - 1));
                if (here, there) == (a, b) { node } else { self.compute(Op::Select, [condition, here, there, condition]) }
            }
            _ => node,
        }
    }

    /// A value where some conditions are known to hold or not.
    fn known(&self, mut node: Node, way: &PathPredicate) -> Node {
        let holds = |condition: Node| {
            let (condition, positive) = self.positive(condition);
            let known = way.iter().find(|&&(known, _)| known == condition).map(|&(_, holds)| holds == positive);
            let is_excluded = || way.iter().any(|&(known, holds)| holds && self.excludes(known, condition));
            known.or_else(|| is_excluded().then_some(!positive))
        };
        while let Definition::Compute(op, [a, b, c, _]) = self.kernel.what(node) {
            node = match (op, self.kernel.what(b)) {
                (Op::Select, _) if let Some(holds) = holds(a) => {
                    if holds {
                        b
                    } else {
                        c
                    }
                }
                // It grows by something or by nothing: see `counted_where`.
                (Op::AddU32 | Op::SubU32, Definition::Compute(Op::Gate, [by, condition, ..])) if self.kernel.is_32_bits(a) => {
                    let Some(node) = holds(condition).and_then(|holds| if holds { self.computed(op, a, by) } else { Some(a) }) else {
                        break;
                    };
                    node
                }
                _ => break,
            };
        }
        node
    }

    /// The result of an operation on two values, if that was needed before.
    fn computed(&self, op: Op, a: Node, b: Node) -> Option<Node> {
        let orders = [[a, b, a, a], [b, a, b, b]];
        let possible = if op == Op::AddU32 { &orders[..] } else { &orders[..1] };
        possible.iter().find_map(|&args| self.numbers.get(&Definition::Compute(op, args)).copied())
    }

    /// A value on all ways that led here.
    pub(super) fn known_here(&self, node: Node) -> Node {
        if self.ways.is_always() { node } else { self.known(node, &self.ways.common()) }
    }

    pub(super) fn is_always_reached(&self) -> bool {
        self.ways.is_always()
    }

    /// Whether the running statement is in no inner loop.
    pub(super) fn is_outer(&self) -> bool {
        self.level == Level::Outer
    }

    fn get(&mut self, var: Var) -> Option<Node> {
        let Some(register) = var.register() else { return self.temporaries.get(&var.0).copied() };
        if register == Register::Nesting {
            // The only register of 64 bits.
            return None;
        }
        let slot = self.slot(SlotKind::Register(register));
        let node = self.now_in(slot);
        Some(self.known_here(node))
    }

    fn set(&mut self, var: Var, node: Node) -> Option<()> {
        match var.register() {
            Some(Register::Nesting) => return None,
            Some(register) => {
                let slot = self.slot(SlotKind::Register(register));
                self.put(slot, node);
            }
            None => drop(self.temporaries.insert(var.0, node)),
        }
        Some(())
    }

    fn inst(&mut self, index: u32, inst: &Inst, steps: &mut Vec<Effect>) -> Option<()> {
        match *inst {
            Inst::Constant { dst, value } => {
                let node = self.constant(value);
                self.set(dst, node)
            }
            // It is not where it is said to be.
            Inst::Compute { .. } if self.translator.ranges.takes_position(index) => None,
            Inst::Compute { op, dst, args } => {
                let node = match self.translator.ranges.result(index) {
                    Some((least, most)) if least == most => self.constant(u64::from(least)),
                    _ => {
                        let none = self.constant(0);
                        let mut nodes = [none; 4];
                        for (node, &arg) in nodes.iter_mut().zip(&args[..op.arity()]) {
                            *node = self.get(arg)?;
                        }
                        if !self.ways.is_always() {
                            let divisor = (op.arity() == 2).then(|| self.kernel.constant(nodes[1])).flatten();
                            if !is_cheap(op, divisor) {
                                if !divides(op) {
                                    return None;
                                }
                                self.chosen += DIVISION;
                            }
                        }
                        self.compute(op, nodes)
                    }
                };
                self.note_range(index, node);
                self.set(dst, node)
            }
            Inst::Move { from, to, bytes } if self.whole_copies => self.copy_whole(index, (from, to, bytes), steps),
            Inst::Move { from, to, bytes } => {
                // Iteration by iteration, a copy of many bytes at once is faster.
                self.only_side_by_side = true;
                self.copy(index, (from, to, bytes), steps)
            }
            Inst::Load { dst, place, width, .. } => {
                let node = match self.place(index, place, width, false)? {
                    Reached::Slot(slot) => self.read_here(slot)?,
                    Reached::Access(access) => self.read_at(access, steps),
                };
                // The same in every iteration: a pointer that a caller handed on, for one.
                let node = match self.translator.ranges.result(index) {
                    Some((least, most)) if least == most => self.constant(u64::from(least)),
                    _ => node,
                };
                self.note_range(index, node);
                self.set(dst, node)
            }
            Inst::Store { place, width, src } => {
                let value = self.get(src)?;
                let value = self.cut(width, value);
                match self.place(index, place, width, true)? {
                    Reached::Slot(slot) => self.write_here(slot, value)?,
                    Reached::Access(access) => self.write_at(access, value, steps),
                }
                Some(())
            }
            Inst::Parameter { dst, index } if !self.frames.is_empty() => {
                let pointer = match self.given.get(usize::from(index)) {
                    Some(&pointer) => pointer,
                    None => self.constant(0),
                };
                self.set(dst, pointer)
            }
            // The loop is in a block that became part of another one.
            Inst::Parameter { dst, index } if !self.translator.outer.is_empty() => {
                let given = self.translator.given.get(usize::from(index)).map_or(Some(0), |given| given.constant())?;
                let pointer = self.constant(given);
                self.set(dst, pointer)
            }
            Inst::Intrinsic { dst, intrinsic: Intrinsic::Clock, .. } => {
                let slot = self.slot(SlotKind::Clock);
                let now = self.read_slot(slot);
                self.set(dst, now)
            }
            Inst::PassParameter { src } => {
                let pointer = self.get(src)?;
                let pointer = self.cut(Width::DoubleWord, pointer);
                self.passed.push(pointer);
                Some(())
            }
            Inst::Open { register, number } => {
                let number = self.get(number)?;
                let number = self.kernel.constant(number)? & 0xFFFF;
                let range = self.translator.data_block(number)?;
                self.kernel.opened.insert(number as u16);
                for (register, value) in data_registers(register).into_iter().zip([number, range.start as u64, range.len() as u64]) {
                    let value = self.constant(value);
                    self.set(register.into(), value)?;
                }
                Some(())
            }
            Inst::Require { .. } if self.translator.ranges.is_met(index) => Some(()),
            Inst::Require { condition, .. } => {
                let condition = self.get(condition)?;
                self.require(condition)
            }
            _ => None,
        }
    }

    /// Takes a condition to hold in each iteration: that is looked at before the loop, which is possible for numbers on a line.
    fn require(&mut self, condition: Node) -> Option<()> {
        if self.is_true(condition) {
            return Some(());
        }
        if self.unrolled && self.kernel.constant(condition).is_some() {
            // An iteration that comes here goes on elsewhere.
            let ways = std::mem::take(&mut self.ways);
            return self.never(ways);
        }
        let Definition::Compute(Op::Below, [number, limit, ..]) = self.kernel.what(condition) else { return None };
        let limit = u32::try_from(self.kernel.constant(limit)?).ok()?;
        if limit == 0 || !self.kernel.is_32_bits(number) {
            return None;
        }
        // What is the same in all iterations of the inner loop is looked at with the iterations around them.
        if self.level == Level::Outer || self.kernel.is_fixed(number, &mut HashMap::new()) {
            self.kernel.required.push((number, limit));
        } else {
            self.kernel.required_inside.push((number, limit));
        }
        self.met.insert(condition);
        let range = Interval { least: 0, most: i64::from(limit) - 1, ..Interval::any(32) };
        self.ranges.insert(number, range);
        Some(())
    }

    /// Whether a condition holds in each iteration.
    pub(super) fn is_true(&self, condition: Node) -> bool {
        self.met.contains(&condition) || self.kernel.constant(condition).is_some_and(|value| value & 1 != 0)
    }

    /// What a variable of a width holds when a value was written to it.
    fn cut(&mut self, width: Width, value: Node) -> Node {
        let op = match width {
            Width::Bit => {
                let one = self.constant(1);
                return self.compute(Op::And, [value, one, value, value]);
            }
            Width::QuadWord => return value,
            Width::Byte => Op::Low8,
            Width::Word => Op::Low16,
            _ => Op::Low32,
        };
        self.compute(op, [value; 4])
    }

    fn place(&mut self, index: u32, place: Place, width: Width, write: bool) -> Option<Reached> {
        let inside = self.translator.ranges.inside(index).map(|(base, bytes)| (base.area(), bytes));
        self.reach((place, width), inside, write)
    }

    /// Notes what is known of a value in each iteration.
    fn note_range(&mut self, index: u32, node: Node) {
        if let Some((least, most)) = self.translator.ranges.result(index)
            && self.ways.is_always()
            && self.kernel.constant(node).is_none()
        {
            let range = Interval { least: i64::from(least), most: i64::from(most), ..Interval::any(32) };
            self.ranges.entry(node).or_insert(range);
        }
    }

    /// The range of a value in each iteration.
    pub(super) fn range(&self, node: Node, depth: usize) -> Interval {
        let made = match self.kernel.what(node) {
            Definition::Constant(value) => return Interval::constant(value),
            Definition::Compute(op, args) if depth > 0 && op.arity() <= 3 => {
                let mut ranges = [Interval::constant(0); 3];
                for (range, &arg) in ranges.iter_mut().zip(&args[..op.arity()]) {
                    *range = self.range(arg, depth - 1);
                }
                range_analysis::result(op, ranges)
            }
            _ => Interval::any(64),
        };
        match self.ranges.get(&node) {
            Some(&known) if made.bits != 32 => known,
            Some(known) if made.most - made.least > known.most - known.least => Interval { zeros: made.zeros.max(known.zeros), ..*known },
            _ => made,
        }
    }

    /// The bytes that an access may touch in any iteration, if they are known to lie inside its area.
    fn always_inside(
        &self,
        (_, start, length): (Base, i32, u64),
        pointer: Node,
        offset: u32,
        width: Width,
    ) -> Option<std::ops::Range<i64>> {
        let pointer = self.range(pointer, DEPTH_MAX);
        let position = range_analysis::result(Op::AddU32, [pointer, Interval::constant(u64::from(offset)), pointer]);
        let (least, most) = position.unsigned(24);
        let (first, end) = ((least / 8) as i64, (most / 8) as i64 + i64::from(width.bytes()));
        let aligned = width == Width::Bit || position.zeros >= 3;
        let start = i64::from(start);
        (aligned && end <= length as i64).then_some(start + first..start + end)
    }

    /// What a statement reaches by an address whose range is known only there stays inside on all other ways, too.
    fn choose_pointers(&mut self) -> Option<()> {
        let before: Vec<Node> = self.kernel.accesses.iter().map(|access| access.pointer).collect();
        for (number, reached) in std::mem::take(&mut self.unsure) {
            let access = &self.kernel.accesses[number];
            let Some(inside) = &access.inside else { continue };
            if access.level == Level::Outer && self.kernel.counted_on(access, Level::Outer).is_some() {
                continue;
            }
            // What lies beside it, behind the same pointer, was taken to be apart from it.
            let is_beside = |(other, beside): (usize, &Access)| {
                let same = before[other] == before[number] && (beside.offset, beside.width) != (access.offset, access.width);
                let is_seen = same || beside.around.iter().any(|around| around.pointer == before[number]);
                is_seen && beside.area == access.area && (beside.value.is_some() || access.value.is_some())
            };
            if self.kernel.accesses.iter().enumerate().any(is_beside) {
                return None;
            }
            let (_, start, _) = access.area;
            let (pointer, first) = (access.pointer, (inside.start - i64::from(start)) as u32);
            let other = (first * 8).wrapping_sub(access.offset);
            let other = self.constant(u64::from(other));
            let pointer = self.node(Definition::Compute(Op::Select, [reached, pointer, other, reached]));
            let access = &mut self.kernel.accesses[number];
            (access.pointer, access.sure) = (pointer, true);
        }
        Some(())
    }

    /// Adds an access to the iteration; `reached` tells whether its address is inside its area, if that is not sure.
    pub(super) fn access(&mut self, access: Access, reached: Option<Node>, steps: &mut Vec<Effect>) -> Node {
        let number = self.kernel.accesses.len();
        self.unsure.extend(reached.map(|reached| (number, reached)));
        self.kernel.accesses.push(access);
        let read = self.node(Definition::Read(number));
        self.kernel.reads.push(read);
        steps.push(Effect::Access(number));
        read
    }
}

/// Whether an operation divides: by an unknown number that takes as long as many others.
pub(super) fn divides(op: Op) -> bool {
    matches!(op, Op::DivI16 | Op::DivI32 | Op::RemI16 | Op::RemI32)
}

/// Whether an operation is worth doing though its result may not be needed.
fn is_cheap(op: Op, divisor: Option<u64>) -> bool {
    use Op as O;
    let divides = divides(op) && divisor.is_some_and(|divisor| divisor as i32 > 0);
    let others = matches!(
        op,
        O::AndU64
            | O::OrU64
            | O::XorU64
            | O::Below
            | O::IsNonzero
            | O::DivFailsI16
            | O::DivFailsI32
            | O::DivisorIsZero
            | O::Differ
            | O::Equal
            | O::DivF32
            | O::I32ToF32
            | O::I64ToF32
            | O::ExtendI32I64
            | O::ExtendI16I64
            | O::I32ToF64
            | O::I64ToF64
            | O::NotU64
            | O::AddF64
            | O::SubF64
            | O::MulF64
            | O::DivF64
            | O::NegF64
            | O::AbsF64
            | O::MinF64
            | O::MaxF64
            | O::F32ToF64
            | O::F64ToF32
            | O::F64ToI16
            | O::F64ToU16
            | O::F64ToI32
            | O::RoundF64
            | O::CeilF64
            | O::FloorF64
            | O::TruncF64
            | O::MinF32
            | O::MaxF32
            | O::SqrtF32
            | O::SqrtF64
            | O::RoundF32
            | O::CeilF32
            | O::FloorF32
            | O::TruncF32
            | O::AbsI32
            | O::AbsI16
            | O::AddOverflowsI16
            | O::AddOverflowsI32
            | O::SubOverflowsI16
            | O::SubOverflowsI32
            | O::AddI16Wide
            | O::SubI16Wide
            | O::MulI16Wide
            | O::Sar16
            | O::Sar32
            | O::NotU32
            | O::NotU16
    );
    divides || others || Kernel::compares(op) || super::super::if_conversion::is_cheap(op)
}
