//! Context-independent range summary of a block: its instance, and what it reaches by pointers that its caller wrote to memory, are
//! symbolic bases.
//!
//! What computed addresses reach, counted from such a base, holds wherever the base is, as long as no pointer leads to what addresses are
//! computed from. The caller checks that, where it knows the pointers. An access that fails where the pointer really leads is a slow path,
//! and after each slow path what addresses depend on is compared with memory.

use std::ops::Range;

use sieben_engine::Layout;
use sieben_engine::ir::{Callee, Code, Inst, Op, Place, Var, verify};
use sieben_engine::machine::{CALLS_SHIFT, Register};
use sieben_model::address::{Area, Width};

use super::bounds_checks::FIRST_BYTE;
use super::mod_ref::{ArgumentSource, ModRef, own_local};
use super::pointer_propagation::InstancePointer;
use super::range_analysis::{self, Fact, Interval, Ranges, Surroundings};
use super::scalar_promotion::Base;
use super::strings::NUMBER_SHIFT;
use super::{Find, Translator, natural_loops};
use crate::jit::Native;

/// Pointers of a block that are followed.
const POINTERS_MAX: usize = 12;
/// Bytes of each data block: as many as a pointer can count, and an index of an open array more.
const BLOCK_BYTES: usize = 1 << 18;
/// Where the local data of callers are taken to be, and bytes that each parameter has there.
const CALLERS: i32 = -0x100_0000;
const PARAMETER_BYTES: i32 = 1 << 11;
/// Bytes of local data that a pointer can count.
const CALLER_BYTES: usize = (1 << CALLS_SHIFT) / 8;
/// A pointer to the local data of the caller.
const TO_CALLER: u64 = 0x8700_0000;

/// Where a block finds a pointer: the number of the data block, and the pointer.
pub(super) type Pair = (ArgumentSource, ArgumentSource);

/// The memory of a CPU, with data blocks that no program has.
pub(super) struct SymbolicMemory {
    layout: Layout,
    /// That of the instance, then those of pointers.
    blocks: Vec<u16>,
}

impl SymbolicMemory {
    /// `None` if the program has too many data blocks.
    pub(super) fn new(layout: &Layout) -> Option<Self> {
        let mut layout = layout.clone();
        let blocks: Vec<u16> =
            (1..=u16::MAX).rev().filter(|number| !layout.data_blocks.contains_key(number)).take(1 + POINTERS_MAX).collect();
        let mut start = layout.size;
        for &number in &blocks {
            layout.data_blocks.insert(number, start..start + BLOCK_BYTES);
            start += BLOCK_BYTES;
        }
        (blocks.len() > POINTERS_MAX && i32::try_from(start).is_ok()).then_some(Self { layout, blocks })
    }

    fn first(&self, block: usize) -> i64 {
        self.layout.data_blocks[&self.blocks[block]].start as i64
    }
}

/// What a block reaches.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Reached {
    /// Bits of the instance, from where AR2 points when the block is called.
    Instance(Range<i64>),
    /// Bits behind a pointer.
    Pointed(Pair, Range<i64>),
    /// The block's own local data.
    Own,
}

/// What is known of a block that was looked at alone.
#[derive(Clone, Debug, Default)]
pub(super) struct SymbolicSummary {
    /// For each statement, and for each call, what addresses depend on.
    facts: Vec<Vec<TrackedVariable>>,
    over_calls: Vec<(u32, Vec<TrackedVariable>)>,
    /// The part of the instance that it looks at, in bits from where AR2 points.
    pub(super) instance: Range<i64>,
    /// Other memory that it looks at.
    pub(super) areas: Vec<Area>,
    pub(super) blocks: Vec<u16>,
}

impl SymbolicSummary {
    /// Whether something is known over a call.
    pub(super) fn is_kept(&self, inst: u32) -> bool {
        self.over_calls.iter().any(|&(call, _)| call == inst)
    }
}

/// A variable and its range.
#[derive(Clone, Copy, Debug)]
struct TrackedVariable {
    of: SymbolicBase,
    offset: i32,
    width: Width,
    range: Interval,
}

/// What a variable is counted from.
#[derive(Clone, Copy, Debug)]
enum SymbolicBase {
    Instance,
    Local,
    Arena,
}

/// The look at a block.
pub(super) struct Summarizer<'a> {
    world: &'a SymbolicMemory,
    pairs: Vec<Pair>,
    ranges: Ranges,
}

impl<'a> Summarizer<'a> {
    /// Looks at a block that is given pointers.
    pub(super) fn at(
        world: &'a SymbolicMemory,
        block: &Native,
        pairs: Vec<Pair>,
        pointers: &InstancePointer,
        (effects, find): (&[Option<ModRef>], Find<'_>),
    ) -> Option<Self> {
        // Each number belongs to one pointer.
        let is_shared = |(at, pair): (usize, &Pair)| pairs[..at].iter().any(|other| pair.0 == other.0 || pair.1 == other.1);
        if pairs.len() > POINTERS_MAX || pairs.iter().enumerate().any(is_shared) {
            return None;
        }
        let mut registers = [None; Register::COUNT];
        let own = &world.layout.data_blocks[&world.blocks[0]];
        for (register, value) in [
            (Register::DiNumber, u64::from(world.blocks[0])),
            (Register::DiBase, own.start as u64),
            (Register::DiLength, own.len() as u64),
            (Register::Ar2, FIRST_BYTE),
        ] {
            registers[register as usize] = Some(value);
        }
        let parameters = block.code.insts.iter().filter_map(|inst| match inst {
            Inst::Parameter { index, .. } => Some(1 + u64::from(*index)),
            _ => None,
        });
        let parameters = parameters.max().unwrap_or(0);
        if parameters * PARAMETER_BYTES as u64 > CALLER_BYTES as u64 {
            return None;
        }
        let given = |parameter: u64| Some(TO_CALLER | (parameter * 8 * PARAMETER_BYTES as u64));
        let callers = |calls: usize| (calls == 0).then_some((CALLERS, CALLER_BYTES));
        let mut facts = Vec::new();
        for (at, &(number, pointer)) in pairs.iter().enumerate() {
            let known = [(number, Width::Word, u64::from(world.blocks[1 + at])), (pointer, Width::DoubleWord, FIRST_BYTE)];
            for (source, width, value) in known {
                facts.push(Fact { variable: variable(world, source, width)?, range: Interval::constant(value) });
            }
        }
        let called = |inst: &Inst| match inst {
            Inst::Call { callee: Callee::Block(id), .. } => find(*id).map(|code| code as usize).filter(|&code| effects[code].is_some()),
            _ => None,
        };
        let added = |added: Option<u32>| Some(u64::from((FIRST_BYTE as u32).wrapping_add(added?)));
        let around = Surroundings {
            layout: &world.layout,
            registers,
            parameters: (0..parameters).map(given).collect(),
            local: (0, block.local_size),
            words: Vec::new(),
            facts,
            callers: &callers,
            asks_before_writing: false,
            written: &natural_loops::written,
            instance: [&|statement| added(pointers.at(statement)), &|inst| added(pointers.after(inst))],
            effects,
            called: &called,
            relative: None,
        };
        let ranges = range_analysis::find(block, &around);
        Some(Self { world, pairs, ranges })
    }

    /// What an access by a computed address reaches.
    pub(super) fn reached(&self, inst: u32, width: Width) -> Option<Reached> {
        let bytes = i64::from(width.bytes());
        let exact = || self.ranges.pointed(inst).map(|(base, offset)| (base, i64::from(offset)..i64::from(offset) + bytes));
        self.classify(self.ranges.inside(inst).or_else(exact)?)
    }

    /// What a move reads and writes.
    pub(super) fn moved(&self, inst: u32) -> Option<[Reached; 2]> {
        let [read, write] = self.ranges.moved(inst)?;
        Some([self.classify(read)?, self.classify(write)?])
    }

    /// What a called block reaches by its pointers, and whether it writes there; `None` = anything.
    pub(super) fn by_call(&self, inst: u32) -> Option<Vec<(Reached, bool)>> {
        if !self.ranges.is_kept(inst) {
            return None;
        }
        let reached = self.ranges.reached_by_pointers(inst).iter();
        reached.map(|(bytes, writes)| Some((self.classify(bytes.clone())?, *writes))).collect()
    }

    fn classify(&self, (base, bytes): range_analysis::ByteRange) -> Option<Reached> {
        match base.area() {
            Base::Local if bytes.start >= 0 => Some(Reached::Own),
            Base::Arena => {
                let block = usize::try_from((bytes.start - self.world.first(0)).div_euclid(BLOCK_BYTES as i64)).ok()?;
                let first = (block <= POINTERS_MAX).then(|| self.world.first(block))?;
                let bits = 8 * (bytes.start - first)..8 * (bytes.end - first);
                match block.checked_sub(1) {
                    None => Some(Reached::Instance(bits)),
                    Some(at) => Some(Reached::Pointed(*self.pairs.get(at)?, bits)),
                }
            }
            _ => None,
        }
    }

    /// What addresses depend on, beside the pointers, and what the block looks at.
    pub(super) fn alone(&self, seen: SymbolicSummary, calls: &[u32], statements: u32) -> SymbolicSummary {
        let sources: Vec<_> = (self.pairs.iter())
            .flat_map(|&(number, pointer)| [(number, Width::Word), (pointer, Width::DoubleWord)])
            .filter_map(|(source, width)| variable(self.world, source, width))
            .collect();
        let kept = |facts: &[Fact]| -> Vec<TrackedVariable> {
            let own = facts.iter().filter(|fact| !sources.contains(&fact.variable));
            own.filter_map(|&Fact { variable: (base, offset, width), range }| {
                let first = self.world.first(0);
                let distance = i64::from(offset) - first;
                let (of, offset) = match base {
                    Base::Local if offset >= 0 => (SymbolicBase::Local, offset),
                    Base::Arena if distance < 0 => (SymbolicBase::Arena, offset),
                    Base::Arena if distance < BLOCK_BYTES as i64 => (SymbolicBase::Instance, distance as i32),
                    _ => return None,
                };
                Some(TrackedVariable { of, offset, width, range })
            })
            .collect()
        };
        SymbolicSummary {
            facts: (0..statements).map(|statement| kept(self.ranges.facts(statement))).collect(),
            over_calls: calls
                .iter()
                .filter(|&&inst| self.ranges.is_kept(inst))
                .map(|&inst| (inst, kept(self.ranges.facts_over_call(inst))))
                .collect(),
            ..seen
        }
    }
}

/// Where a block finds a number, as it is looked at.
fn variable(world: &SymbolicMemory, source: ArgumentSource, width: Width) -> Option<(Base, i32, Width)> {
    match source {
        ArgumentSource::Instance(offset) if offset % 8 == 0 && offset < 8 * BLOCK_BYTES as u32 => {
            Some((Base::Arena, i32::try_from(world.first(0)).ok()? + (offset / 8) as i32, width))
        }
        ArgumentSource::Given(parameter, offset) if offset % 8 == 0 && offset < 8 * PARAMETER_BYTES as u32 => {
            Some((Base::Local, CALLERS + i32::from(parameter) * PARAMETER_BYTES + (offset / 8) as i32, width))
        }
        _ => None,
    }
}

/// How callers rely on what was found when a block was looked at alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Reliance {
    /// Nobody does.
    #[default]
    None,
    /// What its addresses depend on is compared behind each question.
    OnFacts,
    /// The interpreter takes over behind each question.
    OnSilence,
}

impl Translator<'_> {
    /// Has compared behind questions what the caller relies on that looked at the present block alone.
    pub(super) fn rely_on_block(&mut self) {
        let Some(outer) = self.outer.last() else { return };
        let (caller, _) = outer.place();
        let of = |code: usize| self.effects[code].as_ref().and_then(|effects| effects.alone.clone());
        self.reliance = outer.reliance_on_called(of(caller).as_deref());
        let Some(alone) = of(self.index).filter(|_| self.reliance == Reliance::OnFacts) else { return };
        let (base, first) = if alone.instance.is_empty() { (Base::Arena, 0) } else { self.instance_base() };
        let local = self.local_offset;
        let fact = |kept: &TrackedVariable| {
            let (base, first) = match kept.of {
                SymbolicBase::Instance => (base, first),
                SymbolicBase::Local => (Base::Local, local),
                SymbolicBase::Arena => (Base::Arena, 0),
            };
            Fact { variable: (base, first + kept.offset, kept.width), range: kept.range }
        };
        let facts = alone.facts.iter().map(|kept| kept.iter().map(fact).collect()).collect();
        let over_calls = alone.over_calls.iter().map(|(inst, kept)| (*inst, kept.iter().map(fact).collect())).collect();
        self.ranges.rely_on(facts, over_calls);
    }
}

/// The pointers that a block reads and follows, or hands on; `None` if it does anything else with them.
pub(super) fn pairs(code: &Code, pointers: &InstancePointer, (effects, find): (&[Option<ModRef>], Find<'_>)) -> Option<Vec<Pair>> {
    let mut pairs: Vec<Pair> = Vec::new();
    let mut follows = Follower { code, pointers, effects, find, handed: Vec::new() };
    // What counts as a pointer is known only when all statements have been seen.
    for statement in 0..code.statement_count() as u32 {
        follows.statement(statement, &mut pairs, false)?;
    }
    for statement in 0..code.statement_count() as u32 {
        follows.statement(statement, &mut pairs, true)?;
    }
    Some(pairs)
}

/// What a temporary holds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TempValue {
    Constant(u64),
    Parameter(u16),
    Number(ArgumentSource),
    Pointer(ArgumentSource),
    /// A number where a pointer of 64 bits has it.
    Shifted(ArgumentSource),
    /// A number above a pointer.
    Far(Pair),
}

/// Where a block writes what it hands on: behind AR2, or in its local data.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ArgumentSlot {
    Instance(u32),
    Local(u32),
}

struct Follower<'a> {
    code: &'a Code,
    pointers: &'a InstancePointer,
    effects: &'a [Option<ModRef>],
    find: Find<'a>,
    /// Where pairs are written that are handed on, and their bits.
    handed: Vec<(ArgumentSlot, u32)>,
}

impl Follower<'_> {
    /// Finds the pairs of a statement, or makes sure that nothing else is done with those that were found.
    fn statement(&mut self, statement: u32, pairs: &mut Vec<Pair>, looks: bool) -> Option<()> {
        let mut held: Vec<(Var, TempValue)> = Vec::new();
        let mut stored: Vec<(ArgumentSlot, TempValue)> = Vec::new();
        let mut passed: Vec<Option<TempValue>> = Vec::new();
        let mut opened = None;
        let mut instance = self.pointers.at(statement);
        let first = self.code.statements[statement as usize];
        for (at, inst) in (first..).zip(self.code.statement(statement as usize)) {
            let of = |var: Var| held.iter().find(|(other, _)| *other == var).map(|&(_, held)| held);
            let mut result = None;
            let mut followed = None;
            let mut reads_as_such: Vec<Var> = Vec::new();
            match *inst {
                Inst::Constant { value, .. } => result = Some(TempValue::Constant(value)),
                Inst::Parameter { index, .. } => result = Some(TempValue::Parameter(index)),
                Inst::PassParameter { src } => passed.push(of(src)),
                Inst::Compute { op: Op::Copy | Op::PassOnPointer, args, .. } => {
                    result = of(args[0]);
                    reads_as_such.push(args[0]);
                }
                Inst::Compute { op: Op::AddU32, args: [a, b, ..], .. } => {
                    // The number above a pointer is no part of the sum.
                    let of_pointer = |var: Var| match of(var)? {
                        TempValue::Pointer(pointer) | TempValue::Far((_, pointer)) => Some(pointer),
                        _ => None,
                    };
                    match (of_pointer(a), of_pointer(b)) {
                        (Some(pointer), None) | (None, Some(pointer)) => {
                            result = Some(TempValue::Pointer(pointer));
                            reads_as_such.extend([a, b].into_iter().filter(|&var| of_pointer(var).is_some()));
                        }
                        _ => {}
                    }
                }
                Inst::Compute { op: op @ (Op::Shl64 | Op::Shr64 | Op::OrU64), args: [a, b, ..], .. } => {
                    result = joined(op, of(a), of(b));
                    reads_as_such.extend([a, b].into_iter().filter(|_| result.is_some()));
                }
                Inst::Load { place, width, .. } => {
                    let source = match place {
                        Place::Indirect { area: Area::InstanceData, pointer, offset } if pointer.register() == Some(Register::Ar2) => {
                            instance.map(|added| ArgumentSource::Instance(added.wrapping_add(offset)))
                        }
                        Place::Crossing { pointer, offset } => match of(pointer) {
                            Some(TempValue::Parameter(parameter)) => Some(ArgumentSource::Given(parameter, offset)),
                            _ => None,
                        },
                        _ => None,
                    };
                    result = source.and_then(|source| match width {
                        Width::Word => Some(TempValue::Number(source)),
                        Width::DoubleWord => Some(TempValue::Pointer(source)),
                        _ => None,
                    });
                    if looks && self.may_be_handed_on(place, width, instance) {
                        return None;
                    }
                    followed = Some(place);
                }
                Inst::Store { place, src, .. } => {
                    let at = match place {
                        Place::Fixed { area: Area::Local, position } => Some(ArgumentSlot::Local(position)),
                        Place::Indirect { area: Area::InstanceData, pointer, offset } if pointer.register() == Some(Register::Ar2) => {
                            instance.map(|added| ArgumentSlot::Instance(added.wrapping_add(offset)))
                        }
                        _ => None,
                    };
                    if let (Some(at), Some(held)) = (at, of(src)) {
                        stored.push((at, held));
                        reads_as_such.push(src);
                    }
                    followed = Some(place);
                }
                Inst::Open { number, .. } => {
                    opened = of(number);
                    reads_as_such.push(number);
                }
                Inst::Move { from, to, .. } => {
                    for place in [from, to] {
                        match place {
                            Place::Crossing { pointer, .. } if let Some(TempValue::Far(pair)) = of(pointer) => {
                                reads_as_such.push(pointer);
                                add(pairs_if(pairs, !looks), pair);
                            }
                            _ => self.follow(place, &of, opened, pairs_if(pairs, !looks), &mut reads_as_such),
                        }
                    }
                }
                Inst::Call { callee: Callee::Block(id), parameters } => {
                    let effects = (self.find)(id).and_then(|code| self.effects[code as usize].as_ref());
                    let given = passed.split_off(passed.len().saturating_sub(usize::from(parameters)));
                    let handed = |source: ArgumentSource| match source {
                        ArgumentSource::Instance(offset) => instance.map(|added| ArgumentSlot::Instance(added.wrapping_add(offset))),
                        ArgumentSource::Given(parameter, offset) => match given.get(usize::from(parameter)) {
                            Some(Some(TempValue::Constant(pointer))) => {
                                own_local(*pointer).map(|position| ArgumentSlot::Local(position.wrapping_add(offset)))
                            }
                            _ => None,
                        },
                    };
                    for pointed in effects.into_iter().flat_map(|effects| &effects.pointed) {
                        let (Some(number), Some(pointer)) = (pointed.number.and_then(handed), handed(pointed.pointer)) else { continue };
                        let find = |place: ArgumentSlot| stored.iter().rev().find(|(at, _)| *at == place).map(|&(_, held)| held);
                        if let (Some(TempValue::Number(of_number)), Some(TempValue::Pointer(of_pointer))) = (find(number), find(pointer)) {
                            add(pairs_if(pairs, !looks), (of_number, of_pointer));
                            self.handed.extend([(number, Width::Word.bits()), (pointer, Width::DoubleWord.bits())]);
                        }
                        stored.retain(|(at, _)| ![number, pointer].contains(at));
                    }
                    held.clear();
                    opened = None;
                    continue;
                }
                _ => {}
            }
            if let Some(place) = followed {
                self.follow(place, &of, opened, pairs_if(pairs, !looks), &mut reads_as_such);
            }
            if looks && verify::reads(inst).any(|var| of(var).is_some_and(|held| is_in(pairs, held)) && !reads_as_such.contains(&var)) {
                return None;
            }
            if let Some(dst) = verify::writes(inst) {
                held.retain(|(var, _)| *var != dst);
                if dst == Register::Ar2.into() {
                    instance = self.pointers.after(at);
                } else if let Some(result) = result {
                    if dst.register().is_some() && looks && is_in(pairs, result) {
                        return None;
                    }
                    held.push((dst, result));
                }
            }
        }
        (!looks || !stored.iter().any(|&(_, held)| is_in(pairs, held))).then_some(())
    }

    /// Whether a place is one where pointers are written for others: as numbers they are not what they are when the block is looked at.
    fn may_be_handed_on(&self, place: Place, width: Width, instance: Option<u32>) -> bool {
        let shares = |own: u32, bits: u32| own < bits || own.wrapping_neg() < width.bits();
        self.handed.iter().any(|&(handed, bits)| match (place, handed) {
            (Place::Fixed { area: Area::Local, position }, ArgumentSlot::Local(at)) => shares(position.wrapping_sub(at), bits),
            (Place::Indirect { area: Area::Local, .. }, ArgumentSlot::Local(_)) => true,
            (Place::Indirect { area: Area::InstanceData, pointer, offset }, ArgumentSlot::Instance(at)) => {
                let added = instance.filter(|_| pointer.register() == Some(Register::Ar2));
                added.is_some_and(|added| shares(added.wrapping_add(offset).wrapping_sub(at), bits))
            }
            _ => false,
        })
    }

    /// Follows a pointer to what it leads to.
    fn follow(
        &self,
        place: Place,
        of: &dyn Fn(Var) -> Option<TempValue>,
        opened: Option<TempValue>,
        pairs: Option<&mut Vec<Pair>>,
        reads_as_such: &mut Vec<Var>,
    ) {
        let Place::Crossing { pointer, .. } = place else { return };
        reads_as_such.push(pointer);
        if let (Some(TempValue::Number(number)), Some(TempValue::Pointer(pointer))) = (opened, of(pointer)) {
            add(pairs, (number, pointer));
        }
    }
}

/// A number and a pointer in 64 bits, or one of them taken from there.
fn joined(op: Op, a: Option<TempValue>, b: Option<TempValue>) -> Option<TempValue> {
    match (op, a?, b?) {
        (Op::Shl64, TempValue::Number(number), TempValue::Constant(by)) if by == u64::from(NUMBER_SHIFT) => {
            Some(TempValue::Shifted(number))
        }
        (Op::Shr64, TempValue::Far((number, _)), TempValue::Constant(by)) if by == u64::from(NUMBER_SHIFT) => {
            Some(TempValue::Number(number))
        }
        (Op::OrU64, TempValue::Shifted(number), TempValue::Pointer(pointer)) => Some(TempValue::Far((number, pointer))),
        _ => None,
    }
}

/// Whether a value is a pointer that is followed, or the number that belongs to one.
fn is_in(pairs: &[Pair], held: TempValue) -> bool {
    match held {
        TempValue::Constant(_) | TempValue::Parameter(_) => false,
        TempValue::Number(source) | TempValue::Shifted(source) => pairs.iter().any(|pair| pair.0 == source),
        TempValue::Pointer(source) => pairs.iter().any(|pair| pair.1 == source),
        TempValue::Far((number, pointer)) => pairs.iter().any(|pair| pair.0 == number || pair.1 == pointer),
    }
}

fn pairs_if(pairs: &mut Vec<Pair>, wanted: bool) -> Option<&mut Vec<Pair>> {
    wanted.then_some(pairs)
}

fn add(pairs: Option<&mut Vec<Pair>>, pair: Pair) {
    if let Some(pairs) = pairs
        && !pairs.contains(&pair)
    {
        pairs.push(pair);
    }
}
