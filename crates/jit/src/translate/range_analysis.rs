//! Value-range analysis of a block, for the values that addresses are computed from: accesses that are proven to be in bounds need no
//! check.
//!
//! What is known at a statement are *facts*: ranges of registers and of variables in memory. They hold on every path through the machine
//! code. A slow path may change memory: after it the facts of the statement where the program goes on are checked, and the interpreter
//! takes over if one does not hold any more.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use rustc_hash::{FxHashMap, FxHashSet};
use sieben_engine::Layout;
use sieben_engine::access::pointed_area;
use sieben_engine::ir::{Code, Inst, Op, Place, TextRoom};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::mod_ref::ModRef;
use super::natural_loops::instructions_beside;
use super::scalar_promotion::Base;
use crate::jit::{Native, jumps_back, loop_heads};

mod access;
mod base_relative;
mod calls;
mod interval;
mod places;
mod statements;

pub(super) use base_relative::{Relative, uses};
pub(super) use interval::{Interval, result};
use interval::{Number, Relation};

/// Blocks with more instructions in loops are not looked at: it takes time that grows faster than they do.
const INSTRUCTIONS_IN_LOOPS_MAX: usize = 6_000;
/// Blocks with more instructions are not looked at either: those outside of loops are passed over a few times.
const INSTRUCTIONS_MAX: usize = 100_000;
/// Variables in memory whose ranges are followed in a block.
const PLACES_MAX: usize = 48;
/// Passes over a loop in which a range that grows stops at the next number where it may: one for each such number, so many for what settles
/// behind it, and these for each loop in it, one of which settles behind the other; but no more than that in all. In passes behind them it
/// grows as far as its type.
const STOPPING_PASSES: usize = 16;
const STOPPING_PASSES_OF_A_LOOP: usize = 6;
/// Passes over a loop in which a range that grows stops at the next number, in all.
const STOPPING_PASSES_MAX: usize = 240;
/// Passes behind those until nothing changes any more; behind them nothing is known.
const GROWING_PASSES: usize = 8;
/// Passes in which what grew too far comes back.
const NARROWING_PASSES: usize = 3;
/// Where a range that grows in a loop stops, beside the constants that the block compares with: the greatest number whose square is a
/// DINT, and the limits of the types.
const STOPS: [i64; 9] = [-0x8000_0000, -0x8000, -1, 0, 46_340, 0x7FFF, 0xFFFF, 0x7FFF_FFFF, 0xFFFF_FFFF];
/// Constants that count for that, those in the loop first.
const CONSTANTS_MAX: usize = 24;

/// Numbers that a block was handed and that count for that, too.
const HANDED_MAX: usize = 4;

/// A variable in memory: where it begins and its width.
pub(super) type MemoryVariable = (Base, i32, Width);

/// Bytes behind a base.
pub(super) type ByteRange = (Base, Range<i64>);

/// Where a text lies that begins inside its area.
#[derive(Clone, Debug)]
pub(super) struct StringPlace {
    /// The bytes that it may have.
    pub(super) bytes: ByteRange,
    /// How many of them are sure to be there, from where it begins: all that it may have, unless it says itself how long it is.
    pub(super) there: u32,
    /// The data block that its pointer names.
    pub(super) block: Option<Range<usize>>,
    /// What it has room for: what the instruction says, or what the text says where that is known.
    pub(super) room: TextRoom,
}

/// A variable in memory and its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fact {
    pub(super) variable: MemoryVariable,
    pub(super) range: Interval,
}

/// What is known of a block.
#[derive(Debug, Default)]
pub(super) struct Ranges {
    /// Accesses by computed addresses that stay inside their areas, by their instructions: the bytes that they may touch.
    inside: FxHashMap<u32, (Base, Range<i64>)>,
    /// Moves of bytes that stay inside their areas: what they may read and what they may write.
    moves: FxHashMap<u32, [(Base, Range<i64>); 2]>,
    /// Text instructions whose texts begin inside their areas: where `from` and `to` lie.
    texts: FxHashMap<u32, [Option<StringPlace>; 2]>,
    /// Conditions that always hold.
    met: FxHashSet<u32>,
    /// Those that are noted where they fail, of which all that follows takes them to hold: the interpreter does the statement where they do
    /// not, and what follows it.
    interpreted: FxHashSet<u32>,
    /// Statements that are reached only behind one that the interpreter has done: nothing was found out about them.
    unreached: FxHashSet<u32>,
    /// Pointers that are the same one call further in.
    passed_on: FxHashSet<u32>,
    /// Ranges of results, of numbers without sign.
    results: FxHashMap<u32, (u32, u32)>,
    /// Numbers that are read and are pointers to bytes of one area, at least and at most: by instruction.
    pointers: FxHashMap<u32, (u32, u32)>,
    /// Areas to which pointers go that are not known beforehand and may name any: by instruction, and whether it is written.
    areas: FxHashMap<(u32, bool), Area>,
    /// Data blocks that pointers name by a number above them: by instruction, and whether it is written.
    named_blocks: FxHashMap<(u32, bool), u16>,
    /// Variables that instructions reach through pointers that name the area.
    pointed: FxHashMap<u32, (Base, i32)>,
    /// For each statement what its code relies on.
    facts: Vec<Vec<Fact>>,
    /// What is known where a block is called.
    at_calls: FxHashMap<u32, Vec<Fact>>,
    /// What the code behind a call relies on while the called block runs, which becomes part of this one, by the call.
    over_calls: FxHashMap<u32, Vec<Fact>>,
    /// Pointers in the instance of the block that is called, by the call: bits behind AR2, where the code behind the call relies on them.
    elements: FxHashMap<u32, Vec<(u32, Width, Interval)>>,
    /// Ranges of AR2 at calls.
    instances: FxHashMap<u32, Interval>,
    /// AR2 at statements that begin with one that is known.
    instances_at: FxHashMap<u32, u64>,
    /// Calls behind which something is known.
    kept: FxHashSet<u32>,
    /// What blocks that are called may write by pointers that they read, by the call.
    by_pointers: FxHashMap<u32, Vec<(ByteRange, bool)>>,
    /// Whether places in the instance are counted from where it begins.
    relative: bool,
    /// Instructions that take the position from AR2, which is somewhere else then than it is said to be.
    positions: FxHashSet<u32>,
    /// Data blocks that are opened by a number in a variable, which are taken to be as they were loaded.
    opened: BTreeSet<u16>,
}

impl Ranges {
    /// Data blocks that are taken to be as they were loaded.
    pub(super) fn opened(&self) -> impl Iterator<Item = u16> {
        self.opened.iter().copied()
    }

    /// Whether places in the instance are counted from where it begins.
    pub(super) fn is_relative(&self) -> bool {
        self.relative
    }

    /// Whether an instruction takes the position from AR2 where places in the instance are counted from where it begins.
    pub(super) fn takes_position(&self, inst: u32) -> bool {
        self.positions.contains(&inst)
    }

    /// The bytes that an access by a computed address may touch, if they are known to lie inside its area.
    pub(super) fn inside(&self, inst: u32) -> Option<(Base, Range<i64>)> {
        self.inside.get(&inst).cloned()
    }

    /// The bytes that a move may read and write, if they are known to lie inside their areas.
    pub(super) fn moved(&self, inst: u32) -> Option<[(Base, Range<i64>); 2]> {
        self.moves.get(&inst).cloned()
    }

    /// Where a text of an instruction lies, `from` or `to`, if it is known to begin inside its area.
    pub(super) fn text(&self, inst: u32, is_to: bool) -> Option<StringPlace> {
        self.texts.get(&inst)?[usize::from(is_to)].clone()
    }

    /// The area to which the pointer of an access goes that may name any.
    pub(super) fn pointed_area(&self, inst: u32, write: bool) -> Option<Area> {
        self.areas.get(&(inst, write)).copied()
    }

    /// The data block that the pointer of a move names, in which all bytes are known to lie.
    pub(super) fn named_block(&self, inst: u32, write: bool) -> Option<u16> {
        self.named_blocks.get(&(inst, write)).copied()
    }

    /// The variable that an access reaches through a pointer that names its area.
    pub(super) fn pointed(&self, inst: u32) -> Option<(Base, i32)> {
        self.pointed.get(&inst).copied()
    }

    /// Whether the condition of an instruction always holds.
    pub(super) fn is_met(&self, inst: u32) -> bool {
        self.met.contains(&inst)
    }

    /// Whether only the interpreter comes to a statement.
    pub(super) fn is_unreached(&self, statement: u32) -> bool {
        self.unreached.contains(&statement)
    }

    /// Whether the interpreter goes on with the statement where the condition of an instruction does not hold.
    pub(super) fn is_interpreted(&self, inst: u32) -> bool {
        self.interpreted.contains(&inst)
    }

    /// Whether a pointer that an instruction passes on leads nowhere near the local data of the caller, and so stays as it is.
    pub(super) fn is_passed_on_as_it_is(&self, inst: u32) -> bool {
        self.passed_on.contains(&inst)
    }

    /// The least and the greatest result of an instruction.
    pub(super) fn result(&self, inst: u32) -> Option<(u32, u32)> {
        self.results.get(&inst).copied()
    }

    /// The least and the greatest pointer that an instruction reads, if all of them lead to bytes of one area.
    pub(super) fn pointer(&self, inst: u32) -> Option<(u32, u32)> {
        self.pointers.get(&inst).copied()
    }

    /// What the code relies on from a statement on.
    pub(super) fn facts(&self, statement: u32) -> &[Fact] {
        self.facts.get(statement as usize).map_or(&[], Vec::as_slice)
    }

    /// What the code relies on behind a call, and so all through the block that is called.
    pub(super) fn facts_over_call(&self, inst: u32) -> &[Fact] {
        self.over_calls.get(&inst).map_or(&[], Vec::as_slice)
    }

    /// Whether what is known before a call is known behind it, but for what the called block writes.
    pub(super) fn is_kept(&self, inst: u32) -> bool {
        self.kept.contains(&inst)
    }

    /// The bytes that a called block reaches by pointers that it reads, and whether it writes them.
    pub(super) fn reached_by_pointers(&self, inst: u32) -> &[(ByteRange, bool)] {
        self.by_pointers.get(&inst).map_or(&[], Vec::as_slice)
    }

    /// Has more compared with memory behind questions: from each statement on, and all through called blocks.
    pub(super) fn rely_on(&mut self, facts: Vec<Vec<Fact>>, over_calls: Vec<(u32, Vec<Fact>)>) {
        self.facts.resize(self.facts.len().max(facts.len()), Vec::new());
        let more = |known: &mut Vec<Fact>, facts: Vec<Fact>| {
            let new: Vec<Fact> = facts.into_iter().filter(|fact| !known.contains(fact)).collect();
            known.extend(new);
        };
        self.facts.iter_mut().zip(facts).for_each(|(known, facts)| more(known, facts));
        over_calls.into_iter().for_each(|(inst, facts)| more(self.over_calls.entry(inst).or_default(), facts));
    }

    /// What is known where a block is called.
    pub(super) fn facts_at_call(&self, inst: u32) -> &[Fact] {
        self.at_calls.get(&inst).map_or(&[], Vec::as_slice)
    }

    /// Numbers in the instance of the block that is called, which nobody writes while it runs: bits behind AR2, width, range.
    pub(super) fn elements(&self, inst: u32) -> &[(u32, Width, Interval)] {
        self.elements.get(&inst).map_or(&[], Vec::as_slice)
    }

    /// The range of AR2 at a call.
    pub(super) fn instance(&self, inst: u32) -> Option<Interval> {
        self.instances.get(&inst).copied()
    }

    /// AR2 at the beginning of a statement.
    pub(super) fn instance_at(&self, statement: u32) -> Option<u64> {
        self.instances_at.get(&statement).copied()
    }
}

/// What a block is known to begin with, and where its data lie.
pub(super) struct Surroundings<'a> {
    pub(super) layout: &'a Layout,
    /// Registers that hold a constant.
    pub(super) registers: [Option<u64>; Register::COUNT],
    /// Parameters, those that are constants.
    pub(super) parameters: Vec<Option<u64>>,
    /// Where the local data begin behind those of the function's outermost block, and how many bytes they are.
    pub(super) local: (i32, u32),
    /// Constants in the local data of the block and of those that called it: offset behind the local data of the function's outermost
    /// block, and width.
    pub(super) words: Vec<(i32, Width, u64)>,
    /// What is known before it.
    pub(super) facts: Vec<Fact>,
    /// The local data of a caller that is in the same function, so many calls further out than the nearest one: where they begin, and
    /// how many bytes they are.
    pub(super) callers: &'a dyn Fn(usize) -> Option<(i32, usize)>,
    /// Whether a data block that is not known beforehand may be protected.
    pub(super) asks_before_writing: bool,
    /// Registers that an instruction may change, over calls.
    pub(super) written: &'a dyn Fn(&Inst) -> u32,
    /// What AR2 is known to hold at a statement, and behind an instruction that writes it.
    pub(super) instance: [&'a dyn Fn(u32) -> Option<u64>; 2],
    /// What a called block may write that becomes part of this one and asks nobody in the middle of a statement.
    pub(super) effects: &'a [Option<ModRef>],
    /// Which block that is.
    pub(super) called: &'a dyn Fn(&Inst) -> Option<usize>,
    /// The instance of the block, if all places are counted from there. AR2 counts as a pointer to its first byte then.
    pub(super) relative: Option<&'a Relative>,
}

/// A value: what is known of it, and which one it is.
#[derive(Clone, Copy, Debug)]
struct AbstractValue {
    range: Interval,
    number: u32,
}

/// How a value came about, as far as a branch may tell something about its arguments.
#[derive(Clone, Copy, Debug)]
enum Origin {
    Comparison(Number, Relation, AbstractValue, AbstractValue),
    Not(u32),
    /// The first holds and the second does not.
    AndNot(u32, u32),
    And(u32, u32),
    Or(u32, u32),
    /// A square.
    Square(AbstractValue),
    /// The lowest so many bits as a number with sign.
    Extended(u32, AbstractValue),
    /// A value and a constant, added in so many bits.
    Sum(u32, AbstractValue, i64),
    Other,
}

/// What is known at a place of the code.
#[derive(Clone, Debug, Default)]
struct State {
    registers: BTreeMap<u8, AbstractValue>,
    variables: BTreeMap<MemoryVariable, AbstractValue>,
    /// What the running statement stored in the instance of a block that it calls.
    elements: Vec<Element>,
}

/// A number in an instance, and where it is.
#[derive(Clone, Debug)]
struct Element {
    /// The data block, the pointer from which the place is counted, and the bits behind that.
    block: ByteRange,
    pointer: ValueNumber,
    offset: u32,
    width: Width,
    /// The bytes where it may lie.
    bytes: ByteRange,
    known: AbstractValue,
}

/// What an access reaches.
enum Reach {
    /// Exactly this variable.
    Variable(Base, i32),
    /// Some of these bytes, all of them inside the area.
    Inside(Base, Range<i64>),
    /// Some of these bytes, or the access fails.
    Bytes(Base, Range<i64>),
    /// Anything, and the access may fail.
    Anything,
}

impl Reach {
    /// The bytes, if the access does not fail.
    fn bytes(&self, count: u32) -> Option<(Base, Range<i64>)> {
        match self {
            Self::Variable(base, offset) => Some((*base, i64::from(*offset)..i64::from(*offset) + i64::from(count))),
            Self::Inside(base, range) => Some((*base, range.clone())),
            Self::Bytes(..) | Self::Anything => None,
        }
    }
}

/// How much an access touches.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Span {
    Width(Width),
    Bytes(u32),
}

impl Span {
    fn bytes(self) -> u32 {
        match self {
            Self::Width(width) => width.bytes(),
            Self::Bytes(bytes) => bytes,
        }
    }
}

struct Analysis<'a> {
    block: &'a Native,
    code: &'a Code,
    around: &'a Surroundings<'a>,
    /// Places whose ranges matter.
    relevant: FxHashSet<Place>,
    /// Those of them that matter in called blocks alone, and what the running statement has written there.
    given: FxHashSet<Place>,
    given_variables: Vec<MemoryVariable>,
    /// Statements to which a later one jumps back.
    heads: BTreeSet<u32>,
    /// Constants with which the block compares, by the statements that do, and numbers that it was handed: ranges that grow stop there.
    compared: Vec<(u32, i64)>,
    handed_numbers: BTreeSet<i64>,
    origins: Vec<Origin>,
    /// The statements that passes go over.
    part: Range<u32>,
    /// What arrives at each statement from before it.
    arriving: Vec<Option<State>>,
    /// What the running pass brings to statements behind its part.
    leaving: BTreeMap<u32, State>,
    /// What arrived at heads from behind them, in the pass before.
    back: BTreeMap<u32, State>,
    /// What is known at heads in the running pass.
    at_heads: BTreeMap<u32, State>,
    /// Variables that are at a head what they were before the loop, as the running pass sees it.
    unchanged: BTreeMap<u32, BTreeSet<MemoryVariable>>,
    /// Those on which what is known at heads relies.
    taken_as_unchanged: BTreeMap<u32, BTreeSet<MemoryVariable>>,
    /// What is known to hold at heads whatever a pass finds.
    holding: BTreeMap<u32, State>,
    /// What the running statement has computed: the same operation of the same values again is the same value.
    computed: FxHashMap<(Op, [ValueNumber; 3]), u32>,
    /// Whether the running statement calls a block that becomes part of this one and has parameters of whom pointers are in its instance.
    passes_elements: bool,
    found: Ranges,
}

/// What makes values the same ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum ValueNumber {
    Constant(u64),
    Number(u32),
}

impl ValueNumber {
    fn of(known: AbstractValue) -> Self {
        known.range.exact().map_or(Self::Number(known.number), Self::Constant)
    }
}

impl Element {
    /// The bits behind another pointer, if it is known how far that is away.
    fn behind(&self, pointer: ValueNumber) -> Option<u32> {
        match (self.pointer, pointer) {
            (ValueNumber::Constant(own), ValueNumber::Constant(other)) => {
                Some(self.offset.wrapping_add(own as u32).wrapping_sub(other as u32))
            }
            (own, other) => (own == other).then_some(self.offset),
        }
    }

    /// Whether another one, counted from the same place, has none of its bits.
    fn is_apart_from(&self, other: &Self) -> bool {
        let distance = other.behind(self.pointer).map(|offset| i64::from(offset.wrapping_sub(self.offset) as i32));
        self.block == other.block
            && distance.is_some_and(|distance| {
                let apart = distance >= i64::from(self.width.bits()) || -distance >= i64::from(other.width.bits());
                // A position has 24 bits.
                apart && distance.abs() < 1 << 23
            })
    }
}

/// Looks at a block. Nothing is known where that would not pay.
pub(super) fn find(block: &Native, around: &Surroundings<'_>) -> Ranges {
    let code = &block.code;
    let count = code.insts.len();
    let is_long = || count > INSTRUCTIONS_IN_LOOPS_MAX && count - instructions_beside(code) > INSTRUCTIONS_IN_LOOPS_MAX;
    if count > INSTRUCTIONS_MAX || is_long() {
        return Ranges::default();
    }
    let (relevant, given) = places::relevant(code);
    let count = code.statement_count() + 1;
    let mut analysis = Analysis {
        block,
        code,
        around,
        relevant,
        given,
        given_variables: Vec::new(),
        heads: loop_heads(code),
        compared: places::compared(code),
        handed_numbers: BTreeSet::new(),
        origins: Vec::new(),
        part: 0..count as u32,
        arriving: vec![None; count],
        leaving: BTreeMap::new(),
        back: BTreeMap::new(),
        at_heads: BTreeMap::new(),
        unchanged: BTreeMap::new(),
        taken_as_unchanged: BTreeMap::new(),
        holding: BTreeMap::new(),
        computed: FxHashMap::default(),
        passes_elements: false,
        found: Ranges::default(),
    };
    analysis.handed_numbers = analysis.handed_numbers();
    let mut found = analysis.run().unwrap_or_default();
    if let Some(relative) = around.relative {
        found.relative = true;
        found.positions.clone_from(&relative.uses.positions);
        // What AR2 is said to hold is no number that anybody calculates with.
        found.results.retain(|index, _| !relative.uses.pointers.contains(index));
        found.instances_at.clear();
    }
    found
}

impl State {
    /// Forgets variables that overlap some bytes.
    fn forget(&mut self, base: Base, bytes: &Range<i64>) {
        self.variables.retain(|&(other, offset, width), _| {
            let start = i64::from(offset);
            !other.may_share(&(start..start + i64::from(width.bytes())), base, bytes)
        });
        self.elements.retain(|element| !element.bytes.0.may_share(&element.bytes.1, base, bytes));
    }

    /// Forgets all variables.
    fn forget_memory(&mut self) {
        self.variables.clear();
        self.elements.clear();
    }

    /// What is known of variables in memory.
    fn facts(&self) -> Vec<Fact> {
        let facts = self.variables.iter().filter(|((.., width), known)| !says_nothing(*width, &known.range));
        facts.map(|(&variable, known)| Fact { variable, range: known.range }).collect()
    }

    fn is_within(&self, other: &Self) -> bool {
        let registers = other
            .registers
            .iter()
            .all(|(register, known)| self.registers.get(register).map_or(Interval::any(64), |own| own.range).is_within(&known.range));
        let variables = other.variables.iter().all(|(variable, known)| {
            says_nothing(variable.2, &known.range) || self.variables.get(variable).is_some_and(|own| own.range.is_within(&known.range))
        });
        registers && variables
    }
}

impl<'a> Analysis<'a> {
    /// Passes over the block until nothing grows, then some that take back what grew too far. Where loops lie in others it is done twice:
    /// what an inner loop counts from has not grown too far the second time. The last pass makes sure that what is known at the beginning
    /// of each statement leads to what is known behind it.
    fn run(mut self) -> Option<Ranges> {
        let best = self.settle()?;
        if self.has_loops_in_loops() {
            let counted = (self.origins.clone(), self.taken_as_unchanged.clone());
            let heads = self.heads.iter().filter_map(|&head| Some((head, best[head as usize].clone()?)));
            self.holding = heads.collect();
            self.back.clear();
            if let Some(better) = self.settle()
                && self.check(&better)
            {
                return Some(self.found);
            }
            self.found = Ranges::default();
            // What is checked counts its values as they were counted when it was found.
            (self.origins, self.taken_as_unchanged) = counted;
        }
        self.check(&best).then_some(self.found)
    }

    /// Numbers to which parameters lead, and those beside them: a loop may end there.
    fn handed_numbers(&self) -> BTreeSet<i64> {
        let number = |pointer: Option<u64>| {
            let pointer = pointer.filter(|&pointer| pointed_area(pointer, false) == Ok(Area::CallerLocal))?;
            [Width::DoubleWord, Width::Word].into_iter().find_map(|width| {
                let byte = self.byte_in_caller(pointer as u32 & 0x00FF_FFFF, width)?;
                let fact = self.around.facts.iter().find(|fact| fact.variable == (Base::Local, byte, width))?;
                let (least, most) = fact.range.signed(width.bits());
                (least == most).then_some(least as i64)
            })
        };
        let numbers: BTreeSet<i64> = self.around.parameters.iter().filter_map(|&pointer| number(pointer)).collect();
        numbers.into_iter().take(HANDED_MAX).flat_map(|number| [number - 1, number, number + 1]).collect()
    }

    /// The ways back: to which statement, and from which one.
    fn ways_back(&self) -> Vec<(u32, u32)> {
        jumps_back(self.code).into_iter().map(|(from, to)| (to, from as u32)).collect()
    }

    /// Whether some way back lies inside another one.
    fn has_loops_in_loops(&self) -> bool {
        let ways = self.ways_back();
        ways.iter().any(|outer| ways.iter().any(|inner| inner.0 > outer.0 && inner.0 <= outer.1))
    }

    /// The statements in parts, each with all of a loop and of those inside it, or with none.
    fn parts(&self) -> Vec<Range<u32>> {
        let mut ways = self.ways_back();
        ways.sort_unstable();
        let (mut parts, mut end): (Vec<Range<u32>>, u32) = (Vec::new(), 0);
        for (to, from) in ways {
            match parts.last_mut() {
                Some(part) if to < end => part.end = part.end.max(from + 1),
                _ => {
                    parts.extend((end < to).then_some(end..to));
                    parts.push(to..from + 1);
                }
            }
            end = end.max(from + 1);
        }
        let count = self.code.statement_count() as u32;
        parts.extend((end < count).then_some(end..count));
        parts
    }

    /// Finds out what is known at each statement: one loop after another, then all together.
    fn settle(&mut self) -> Option<Vec<Option<State>>> {
        self.begin();
        for part in self.parts() {
            self.settle_part(part)?;
        }
        let mut best = Vec::new();
        for _ in 0..NARROWING_PASSES {
            self.begin();
            best = self.pass(None, true);
        }
        best.resize(self.arriving.len(), None);
        Some(best)
    }

    /// Goes over a part until nothing grows any more.
    fn settle_part(&mut self, part: Range<u32>) -> Option<()> {
        let in_front: Vec<(u32, State)> =
            part.clone().filter_map(|statement| Some((statement, self.arriving[statement as usize].take()?))).collect();
        let counted = self.origins.len();
        let heads: Vec<u32> = self.heads.range(part.clone()).copied().collect();
        let place = |head: u32| (head - part.start) as usize;
        self.part = part.clone();
        let mut stops = places::stops(&self.compared, &part);
        stops.extend(&self.handed_numbers);
        let stopping = STOPPING_PASSES + stops.len() + STOPPING_PASSES_OF_A_LOOP * (heads.len().max(1) - 1);
        let stopping = stopping.min(STOPPING_PASSES_MAX);
        let mut before: Option<Vec<Option<State>>> = None;
        for passes in 0.. {
            self.origins.truncate(counted);
            self.leaving.clear();
            for (statement, state) in &in_front {
                self.arriving[*statement as usize] = Some(state.clone());
            }
            let none = BTreeSet::new();
            let states = self.pass(before.as_deref().zip(Some(if passes < stopping { &stops } else { &none })), false);
            let stable = before.as_ref().map_or(heads.is_empty(), |before| {
                heads.iter().all(|&head| match (&states[place(head)], &before[place(head)]) {
                    (Some(now), Some(before)) => now.is_within(before),
                    (None, _) => true,
                    (Some(_), None) => false,
                })
            });
            if stable {
                break;
            }
            if passes + 1 == stopping + GROWING_PASSES {
                return None;
            }
            before = Some(states);
        }
        self.part = 0..self.arriving.len() as u32;
        for (to, state) in std::mem::take(&mut self.leaving) {
            self.arrive(to, &state, None);
        }
        Some(())
    }

    /// Begins before the block.
    fn begin(&mut self) {
        self.part = 0..self.arriving.len() as u32;
        self.origins.clear();
        self.arriving.iter_mut().for_each(|state| *state = None);
        let first = self.beginning();
        self.arrive(0, &first, None);
    }

    /// One pass over the part; what is known at the beginning of each of its statements. A range that grew since the pass `before` grows
    /// at once to where it may stay. With `narrows` a variable that a loop does not change is in the loop what it is before it.
    fn pass(&mut self, before: Option<(&[Option<State>], &BTreeSet<i64>)>, narrows: bool) -> Vec<Option<State>> {
        let part = self.part.start..self.part.end.min(self.code.statement_count() as u32);
        let heads: Vec<u32> = self.heads.range(part.clone()).copied().collect();
        let (mut back, mut unchanged) = (BTreeMap::new(), BTreeMap::new());
        for &head in &heads {
            back.extend(self.back.remove_entry(&head));
            unchanged.extend(self.unchanged.remove_entry(&head));
            self.at_heads.remove(&head);
            self.taken_as_unchanged.remove(&head);
        }
        let mut states = vec![None; part.len()];
        for (statement, place) in part.zip(0..) {
            let mut state = self.arriving[statement as usize].take();
            if let Some(again) = back.get(&statement) {
                state = Some(match state {
                    Some(state) => self.joined_at_head(statement, [&state, again], unchanged.get(&statement), narrows),
                    None => self.renumbered(again),
                });
            }
            let is_head = self.heads.contains(&statement);
            if is_head
                && let (Some(now), Some((before, stops))) = (&mut state, before)
                && let Some(before) = &before[place]
            {
                widen(now, before, stops);
            }
            let Some(mut state) = state else { continue };
            if is_head {
                if let Some(holding) = self.holding.get(&statement) {
                    keep_within(&mut state, holding);
                }
                self.at_heads.insert(statement, state.clone());
            }
            states[place] = Some(state.clone());
            self.statement(statement, state, false);
        }
        states
    }

    /// Goes through each statement with what is said to be known there. Whether all that follows is what is said, too; notes what
    /// machine code may rely on.
    fn check(&mut self, states: &[Option<State>]) -> bool {
        self.part = 0..self.arriving.len() as u32;
        self.arriving.iter_mut().for_each(|state| *state = None);
        self.back.clear();
        self.unchanged.clear();
        self.at_heads = self.heads.iter().filter_map(|&head| Some((head, states[head as usize].clone()?))).collect();
        let first = self.beginning();
        self.arrive(0, &first, None);
        for (statement, state) in states.iter().enumerate() {
            let facts = state.as_ref().map_or(Vec::new(), State::facts);
            self.found.facts.push(facts);
            if state.is_none() {
                self.found.unreached.insert(statement as u32);
            }
            if let Some(state) = state
                && statement < self.code.statement_count()
            {
                let ar2 = state.registers.get(&(Register::Ar2 as u8)).and_then(|known| known.range.exact());
                self.found.instances_at.extend(ar2.map(|pointer| (statement as u32, pointer)));
                self.statement(statement as u32, state.clone(), true);
            }
        }
        let arriving: Vec<Option<State>> = self.arriving.iter_mut().map(Option::take).collect();
        let back = std::mem::take(&mut self.back);
        let all = (0_u32..).zip(arriving).filter_map(|(statement, state)| state.map(|state| (statement, state))).chain(back);
        for (statement, state) in all {
            let said = states.get(statement as usize).and_then(Option::as_ref);
            // Behind the last statement nothing follows.
            if statement as usize + 1 < states.len() && !said.is_some_and(|said| state.is_within(said)) {
                return false;
            }
        }
        let unchanged = std::mem::take(&mut self.unchanged);
        let is_so =
            |(head, variables): (&u32, &BTreeSet<MemoryVariable>)| unchanged.get(head).is_none_or(|found| variables.is_subset(found));
        self.taken_as_unchanged.iter().all(is_so)
    }

    /// What is known where the block begins.
    fn beginning(&mut self) -> State {
        let mut state = State::default();
        for (register, value) in (0..).zip(self.around.registers) {
            if let Some(value) = value {
                state.registers.insert(register, self.value(Interval::constant(value)));
            }
        }
        for &Fact { variable, range } in &self.around.facts {
            let known = self.value(range);
            state.variables.insert(variable, known);
        }
        for &(offset, width, value) in &self.around.words {
            state.variables.insert((Base::Local, offset, width), self.value(Interval::constant(value)));
        }
        state
    }

    fn value(&mut self, range: Interval) -> AbstractValue {
        self.value_from(range, Origin::Other)
    }

    fn value_from(&mut self, range: Interval, origin: Origin) -> AbstractValue {
        let number = self.origins.len() as u32;
        self.origins.push(origin);
        AbstractValue { range, number }
    }

    fn renumbered(&mut self, state: &State) -> State {
        let mut state = state.clone();
        let values = state.registers.values_mut().chain(state.variables.values_mut());
        for known in values {
            *known = self.value(known.range);
        }
        state
    }

    /// What is known where two ways meet.
    fn joined(&mut self, a: &State, b: &State) -> State {
        let mut state = State::default();
        let join = |this: &mut Self, a: &AbstractValue, b: &AbstractValue| {
            let range = a.range.joined(&b.range);
            if a.number == b.number { AbstractValue { range, ..*a } } else { this.value(range) }
        };
        for (&register, known) in &a.registers {
            if let Some(other) = b.registers.get(&register) {
                let joined = join(self, known, other);
                state.registers.insert(register, joined);
            }
        }
        for (&variable, known) in &a.variables {
            if let Some(other) = b.variables.get(&variable) {
                let joined = join(self, known, other);
                state.variables.insert(variable, joined);
            }
        }
        state
    }

    /// What is known at the head of a loop. What came from behind it was counted in the pass before: a number that is the same here and
    /// there says nothing, and a variable holds what it held before the loop only if no way back changes it.
    fn joined_at_head(
        &mut self,
        head: u32,
        [in_front, again]: [&State; 2],
        unchanged: Option<&BTreeSet<MemoryVariable>>,
        narrows: bool,
    ) -> State {
        let mut state = State::default();
        let mut taken = BTreeSet::new();
        for (&register, known) in &in_front.registers {
            if let Some(other) = again.registers.get(&register) {
                state.registers.insert(register, self.value(known.range.joined(&other.range)));
            }
        }
        for (variable, known) in &in_front.variables {
            let is_unchanged = unchanged.is_some_and(|variables| variables.contains(variable));
            let joined = match again.variables.get(variable) {
                _ if is_unchanged && narrows => known.range,
                Some(other) => known.range.joined(&other.range),
                None => continue,
            };
            let number = if is_unchanged { known.number } else { self.value(joined).number };
            taken.extend(is_unchanged.then_some(*variable));
            state.variables.insert(*variable, AbstractValue { range: joined, number });
        }
        self.taken_as_unchanged.insert(head, taken);
        state
    }

    /// Forgets what a statement that has ended handed on in local data: nobody needs it any more, so it may not be written there.
    fn forget_handed(&self, state: &mut State) {
        if self.block.handed.is_empty() {
            return;
        }
        let first = self.around.local.0;
        state.variables.retain(|&(base, offset, width), _| base != Base::Local || !self.block.is_handed(offset - first, width.bytes()));
    }

    /// Notes what is known on a way to a statement.
    fn arrive(&mut self, to: u32, state: &State, from: Option<u32>) {
        let mut state = state.clone();
        state.elements.clear();
        self.forget_handed(&mut state);
        if let Some(pointer) = (self.around.instance[0])(to) {
            let known = self.value(Interval::constant(pointer));
            state.registers.insert(Register::Ar2 as u8, known);
        }
        if from.is_some_and(|from| to <= from) {
            let at_head = self.at_heads.get(&to);
            let is_same = |variable: &MemoryVariable| {
                let same = |at_head: &State| Some(at_head.variables.get(variable)?.number == state.variables.get(variable)?.number);
                at_head.and_then(same).unwrap_or(false)
            };
            match self.unchanged.get_mut(&to) {
                Some(variables) => variables.retain(is_same),
                None => {
                    let variables = state.variables.keys().filter(|variable| is_same(variable)).copied().collect();
                    self.unchanged.insert(to, variables);
                }
            }
            let joined = match self.back.get(&to).cloned() {
                Some(before) => self.joined(&before, &state),
                None => state,
            };
            self.back.insert(to, joined);
        } else if !self.part.contains(&to) {
            let joined = match self.leaving.remove(&to) {
                Some(before) => self.joined(&before, &state),
                None => state,
            };
            self.leaving.insert(to, joined);
        } else if let Some(before) = self.arriving.get_mut(to as usize) {
            let joined = match before.take() {
                Some(before) => self.joined(&before, &state),
                None => state,
            };
            self.arriving[to as usize] = Some(joined);
        }
    }
}

/// Whether a range is what every variable of a width is in.
fn says_nothing(width: Width, range: &Interval) -> bool {
    range.bits == width.bits() && range.is_any()
}

/// Takes from ranges what is known not to be in them.
fn keep_within(now: &mut State, holding: &State) {
    for (variable, known) in &mut now.variables {
        if let Some(holding) = holding.variables.get(variable)
            && holding.range.is_within(&known.range)
        {
            known.range = holding.range;
        }
    }
}

/// Lets ranges that grew since the pass before grow to where they may stay.
fn widen(now: &mut State, before: &State, stops: &BTreeSet<i64>) {
    let all = |known: &mut AbstractValue, before: &AbstractValue| {
        let (range, before) = (&mut known.range, &before.range);
        if before.bits != range.bits {
            *range = Interval::any(before.bits.max(range.bits));
            return;
        }
        if range.least < before.least {
            range.least = stops.range(..=range.least).next_back().copied().unwrap_or(i64::MIN >> 20);
        }
        if range.most > before.most {
            range.most = stops.range(range.most..).next().copied().unwrap_or(i64::MAX >> 20);
        }
        if range.bits < 64 && range.most.saturating_sub(range.least) >= 1 << range.bits {
            *range = Interval { zeros: range.zeros, ..Interval::any(range.bits) };
        }
        *range = range.spaced(range.spacing);
    };
    for (register, known) in &mut now.registers {
        before.registers.get(register).into_iter().for_each(|before| all(known, before));
    }
    for (variable, known) in &mut now.variables {
        before.variables.get(variable).into_iter().for_each(|before| all(known, before));
    }
}
