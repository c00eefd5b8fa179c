//! Mod/ref summaries: what an inlined block may write, so that its caller keeps all other available values over the call.
//!
//! A block with a slow path in the middle of a statement has no summary, nor has one whose writes cannot be told: a runtime call between
//! two statements may change memory, and after it the facts of all callers are checked as well.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::ops::Range;
use std::rc::Rc;

use sieben_engine::Layout;
use sieben_engine::access::pointed_area;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Callee, DataRegister, Inst, OnFault, Op, Place, Var};
use sieben_engine::machine::{CALLS_SHIFT, Register};
use sieben_model::address::{Area, Width};

use super::inlining::InlinePlan;
use super::pointer_propagation::InstancePointer;
use super::range_analysis::{self, Interval};
use super::status_liveness::open_blocks;
use super::symbolic_summaries::{self, Reached, Summarizer, SymbolicMemory, SymbolicSummary};
use super::{Find, bit_of};
use crate::jit::Native;
use crate::passes::{Pass, PassSet};

mod strings;

pub(super) use strings::WrittenText;

/// Bits that a pointer may count.
pub(super) const POSITIONS: i64 = 1 << 24;

/// Anything in the instance data block.
const ANYWHERE: Range<i64> = -0x1000_0000..0x1000_0000;

/// What a block may write but its own local data.
#[derive(Clone, Debug, Default)]
pub(super) struct ModRef {
    /// Bits of the instance data block, from where AR2 points when the block is called.
    pub(super) instance: Option<Range<i64>>,
    /// Areas of the CPU.
    pub(super) areas: Vec<Area>,
    /// Data blocks.
    pub(super) blocks: Vec<u16>,
    /// Access through parameters.
    pub(super) given: Vec<ParameterAccess>,
    /// Access through pointers to which parameters or the instance have another pointer, each with the number of a data block: a
    /// structure or an array as VAR_IN_OUT. The block writes to none of them itself.
    pub(super) pointed: Vec<PointerAccess>,
    /// Texts that it writes by pointers.
    pub(super) texts: Vec<WrittenText>,
    /// Each part of the instance that it writes.
    written: Vec<Range<i64>>,
    /// What its computed addresses depend on, if they tell of it.
    pub(super) alone: Option<Rc<SymbolicSummary>>,
}

/// Where a block finds a number that its caller wrote there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ArgumentSource {
    /// In its instance, so many bits behind AR2.
    Instance(u32),
    /// Where a parameter points, and so many bits behind that.
    Given(u16, u32),
}

/// Access through a pointer that the block was given in memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PointerAccess {
    /// The data block that is open then, if the block opened one.
    pub(super) number: Option<ArgumentSource>,
    pub(super) pointer: ArgumentSource,
    /// Bits behind the pointer.
    pub(super) bits: Range<i64>,
    pub(super) writes: bool,
}

impl PointerAccess {
    /// Where the block reads what it needs to know.
    pub(super) fn sources(&self) -> impl Iterator<Item = (ArgumentSource, Width)> {
        self.number.map(|number| (number, Width::Word)).into_iter().chain([(self.pointer, Width::DoubleWord)])
    }
}

/// Access through a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ParameterAccess {
    pub(super) parameter: u16,
    /// Bits behind the pointer.
    pub(super) offset: u32,
    pub(super) width: Width,
    pub(super) writes: bool,
}

/// What a variable of the IR holds.
#[derive(Clone, Copy)]
enum TempValue {
    Constant(u64),
    Parameter(u16),
    /// What was read from there, in so many bits.
    Read(ArgumentSource, Width),
    /// A pointer that was read, and an index more.
    Moved,
    Other,
}

/// The data block that a statement has opened.
#[derive(Clone, Copy)]
enum Opened {
    Number(u16),
    Read(ArgumentSource),
}

/// A number that a statement computes.
#[derive(Clone, Copy)]
pub(super) struct IndexValue {
    range: Interval,
    /// Whether it is counted from what AR2 holds when the block is called.
    from_instance: bool,
    /// Which number it is.
    id: usize,
    /// The number that is below a limit if this one holds.
    below: Option<(usize, u64)>,
}

/// What a statement computes, as far as an index that it looks at leads to an element of an array in the instance.
#[derive(Default)]
pub(super) struct IndexValues {
    known: BTreeMap<u8, IndexValue>,
    made: usize,
    /// AR2, if the statement has moved it by an index.
    moved: Option<IndexValue>,
}

impl IndexValues {
    fn get(&mut self, var: Var, instance: Option<u32>) -> IndexValue {
        if var.register() == Some(Register::Ar2) {
            if let Some(moved) = self.moved {
                return moved;
            }
            return self.number(Interval::constant(u64::from(instance.unwrap_or(0))), instance.is_some());
        }
        match self.known.get(&var.0) {
            Some(&number) => number,
            None => self.number(Interval::any(64), false),
        }
    }

    fn number(&mut self, range: Interval, from_instance: bool) -> IndexValue {
        self.made += 1;
        IndexValue { range, from_instance, id: self.made, below: None }
    }

    /// Follows an instruction that writes a variable, with what is known of AR2 before it and behind it.
    pub(super) fn follow_write(&mut self, (at, inst, dst): (u32, &Inst, Var), instance: &mut Option<u32>, pointers: &InstancePointer) {
        self.follow(inst, dst, *instance);
        if dst == Register::Ar2.into() {
            *instance = pointers.after(at);
            self.follow_instance(*instance);
        }
    }

    fn follow(&mut self, inst: &Inst, dst: Var, instance: Option<u32>) {
        let number = match *inst {
            Inst::Constant { value, .. } => self.number(Interval::constant(value), false),
            Inst::Compute { op: Op::Copy, args, .. } => self.get(args[0], instance),
            Inst::Compute { op, args, .. } if op.arity() <= 3 => {
                let args = args.map(|arg| self.get(arg, instance));
                self.result(op, &args[..op.arity()])
            }
            _ => self.number(Interval::any(64), false),
        };
        self.known.insert(dst.0, number);
    }

    fn result(&mut self, op: Op, args: &[IndexValue]) -> IndexValue {
        let any = Interval::any(64);
        match (op, args) {
            (Op::Below, &[number, limit]) => {
                let below = limit.range.exact().filter(|&limit| limit > 0 && !number.from_instance).map(|limit| (number.id, limit));
                IndexValue { below, ..self.number(any, false) }
            }
            // An index that is outside of its array counts as the first one.
            (Op::Gate, &[number, IndexValue { below: Some((id, limit)), .. }]) if number.id == id => {
                let range = Interval { least: 0, most: i64::try_from(limit - 1).unwrap_or(i64::MAX), ..Interval::any(32) };
                self.number(if limit > 1 << 31 { any } else { range }, false)
            }
            (Op::AddU32, &[a, b]) if a.from_instance != b.from_instance => {
                let (least, most) = range_analysis::result(op, [a.range, b.range, a.range]).unsigned(32);
                let fits = [a, b].iter().all(|number| number.range.unsigned(64).1 < i128::from(POSITIONS));
                let range = Interval { least: least as i64, most: most as i64, ..Interval::any(32) };
                self.number(if fits { range } else { any }, fits)
            }
            _ if args.iter().any(|number| number.from_instance) => self.number(any, false),
            _ => {
                let mut all = [Interval::constant(0); 3];
                all.iter_mut().zip(args).for_each(|(range, number)| *range = number.range);
                self.number(range_analysis::result(op, all), false)
            }
        }
    }

    /// Follows AR2, which is known behind an instruction that wrote it, or has moved by an index.
    fn follow_instance(&mut self, instance: Option<u32>) {
        let written = self.known.remove(&Var::from(Register::Ar2).0);
        self.moved = written.filter(|number| instance.is_none() && number.from_instance);
    }

    /// The bits by which AR2 has moved, from the least to the most.
    pub(super) fn moved_by(&self, instance: Option<u32>) -> Option<(i64, i64)> {
        match (instance, self.moved) {
            (Some(added), _) => Some((i64::from(added as i32), i64::from(added as i32))),
            (None, Some(moved)) => Some(moved.range.unsigned(32)).map(|(least, most)| (least as i64, most as i64)),
            (None, None) => None,
        }
    }

    /// Bits of the instance to which an access goes, from where AR2 points when the block is called.
    pub(super) fn instance_range(&self, pointer: Var, offset: u32, width: Width) -> Option<Range<i64>> {
        let number = self.known.get(&pointer.0).filter(|number| number.from_instance)?;
        let (least, most) = number.range.unsigned(32);
        Some(least as i64 + i64::from(offset)..most as i64 + i64::from(offset) + i64::from(width.bits()))
    }
}

/// Where in the local data of a block a pointer leads that it hands to one which it calls, in bits.
pub(super) fn own_local(pointer: u64) -> Option<u32> {
    let position = pointer as u32 & 0x00FF_FFFF;
    (pointed_area(pointer, false) == Ok(Area::CallerLocal) && position >> CALLS_SHIFT == 0).then_some(position)
}

/// The effects of all blocks that may become part of others; `None` = nothing is told of that block.
pub(super) fn find(
    blocks: &[Native],
    find: Find<'_>,
    (layout, passes): (&Layout, PassSet),
    plans: &[InlinePlan],
    pointers: &[InstancePointer],
) -> Vec<Option<ModRef>> {
    let world = if passes.has(Pass::SymbolicSummaries) { SymbolicMemory::new(layout) } else { None };
    let (looked, found) = (vec![false; blocks.len()], vec![None; blocks.len()]);
    let mut search = Search { blocks, find, layout, plans, pointers, world: world.as_ref(), looked, found };
    (0..blocks.len()).for_each(|index| search.of_block(index));
    search.found
}

struct Search<'a> {
    blocks: &'a [Native],
    find: Find<'a>,
    layout: &'a Layout,
    plans: &'a [InlinePlan],
    pointers: &'a [InstancePointer],
    world: Option<&'a SymbolicMemory>,
    looked: Vec<bool>,
    found: Vec<Option<ModRef>>,
}

impl Search<'_> {
    /// A block that calls itself is none that becomes part of another one.
    fn of_block(&mut self, index: usize) {
        if !std::mem::replace(&mut self.looked[index], true) && self.plans[index].inlined().is_some() {
            let called: Vec<usize> = self.blocks[index].code.insts.iter().filter_map(|inst| self.called(inst)).collect();
            called.into_iter().for_each(|callee| self.of_block(callee));
            self.found[index] = self.look_at(index);
        }
    }

    fn called(&self, inst: &Inst) -> Option<usize> {
        match inst {
            Inst::Call { callee: Callee::Block(id), .. } => (self.find)(*id).map(|code| code as usize),
            _ => None,
        }
    }

    /// Looks at a block as if it were alone, where an address that it computes tells too little by itself.
    fn look_alone(&self, index: usize) -> Option<Summarizer<'_>> {
        let (block, pointers) = (&self.blocks[index], &self.pointers[index]);
        let called = (self.found.as_slice(), self.find);
        // How long a text is nobody says here.
        let calls_for_texts =
            |inst| self.called(inst).is_some_and(|callee| self.found[callee].as_ref().is_none_or(|it| !it.texts.is_empty()));
        if block.code.insts.iter().any(|inst| matches!(inst, Inst::Text { .. }) || calls_for_texts(inst)) {
            return None;
        }
        let pairs = symbolic_summaries::pairs(&block.code, pointers, called)?;
        Summarizer::at(self.world?, block, pairs, pointers, called)
    }

    fn look_at(&self, index: usize) -> Option<ModRef> {
        let (code, pointers) = (&self.blocks[index].code, &self.pointers[index]);
        let look: OnceCell<Option<Summarizer<'_>>> = OnceCell::new();
        let look_alone = || look.get_or_init(|| self.look_alone(index)).as_ref();
        let mut sees = Sees::default();
        let mut effects = ModRef { texts: self.texts_of(index)?, ..ModRef::default() };
        let mut opens = false;
        for statement in 0..code.statement_count() {
            let mut held: BTreeMap<u8, TempValue> = BTreeMap::new();
            let mut passed: Vec<TempValue> = Vec::new();
            let mut opened: Option<Opened> = None;
            let mut numbers = IndexValues::default();
            let mut instance = pointers.at(statement as u32);
            for (at, inst) in (code.statements[statement]..).zip(code.statement(statement)) {
                let of = |var: Var| held.get(&var.0).copied().unwrap_or(TempValue::Other);
                let mut result = TempValue::Other;
                match *inst {
                    Inst::Constant { value, .. } => result = TempValue::Constant(value),
                    Inst::Compute { op: Op::Copy, args, .. } => result = of(args[0]),
                    Inst::Compute { op: Op::AddU32, args: [a, b, ..], .. }
                        if [a, b].into_iter().any(|var| matches!(of(var), TempValue::Moved | TempValue::Read(_, Width::DoubleWord))) =>
                    {
                        result = TempValue::Moved;
                    }
                    Inst::Parameter { index, .. } => result = TempValue::Parameter(index),
                    Inst::Load { on_fault: OnFault::DeliverZero, place, .. } if !self.is_own(index, place) => return None,
                    Inst::Load { place, width, .. } => match place {
                        Place::Crossing { pointer, .. } if matches!(of(pointer), TempValue::Moved) => {
                            effects.add_reached(look_alone()?.reached(at, width)?, false)?;
                        }
                        Place::Crossing { pointer, offset } => {
                            result = effects.access_through(of(pointer), offset, width, false, opened)?;
                        }
                        Place::Fixed { area, .. } => {
                            self.has(area).then_some(())?;
                            sees.area(area, opened);
                        }
                        Place::Indirect { area, pointer, offset } => {
                            self.has(area).then_some(())?;
                            sees.place((at, width), (area, pointer, offset), instance, opened);
                            if area == Area::InstanceData
                                && pointer.register() == Some(Register::Ar2)
                                && let Some(added) = instance
                            {
                                result = TempValue::Read(ArgumentSource::Instance(added.wrapping_add(offset)), width);
                            }
                        }
                    },
                    Inst::Store { place, width, .. } => match place {
                        Place::Crossing { pointer, .. } if matches!(of(pointer), TempValue::Moved) => {
                            effects.add_reached(look_alone()?.reached(at, width)?, true)?;
                        }
                        Place::Crossing { pointer, offset } => {
                            effects.access_through(of(pointer), offset, width, true, opened)?;
                        }
                        Place::Indirect { area: Area::InstanceData, pointer, offset } => {
                            sees.place((at, width), (Area::InstanceData, pointer, offset), instance, opened);
                            let range = match pointer.register() {
                                Some(Register::Ar2) => Some(instance_range(instance, offset, width)),
                                _ => numbers.instance_range(pointer, offset, width),
                            };
                            let range = range.or_else(|| match look_alone()?.reached(at, width)? {
                                Reached::Instance(bits) => Some(bits),
                                _ => None,
                            });
                            effects.add_instance(&range.unwrap_or(ANYWHERE));
                        }
                        Place::Fixed { area, .. } | Place::Indirect { area, .. } => {
                            sees.area(area, opened);
                            if area == Area::InstanceData {
                                effects.add_instance(&ANYWHERE);
                            }
                            self.write_area(&mut effects, area, opened)?;
                        }
                    },
                    Inst::Move { .. } => {
                        let [read, write] = look_alone()?.moved(at)?;
                        for (reached, writes) in [(read, false), (write, true)] {
                            if let Reached::Instance(bits) = &reached {
                                sees.instance(bits);
                            }
                            effects.add_reached(reached, writes)?;
                        }
                    }
                    Inst::Open { register, .. } if register != DataRegister::Shared => return None,
                    Inst::Open { number, .. } => {
                        opens = true;
                        opened = Some(match of(number) {
                            TempValue::Constant(number) => {
                                let number = (number & 0xFFFF) as u16;
                                if number != 0 && !self.layout.data_blocks.contains_key(&number) {
                                    return None;
                                }
                                Opened::Number(number)
                            }
                            TempValue::Read(source, Width::Word) => Opened::Read(source),
                            _ => return None,
                        });
                    }
                    Inst::PassParameter { src } => passed.push(of(src)),
                    Inst::Call { callee: Callee::Block(id), parameters } => {
                        let callee = (self.find)(id)? as usize;
                        let given = passed.split_off(passed.len().checked_sub(usize::from(parameters))?);
                        let inner = self.found[callee].as_ref()?;
                        effects.add_call(inner, &given, numbers.moved_by(instance))?;
                        if !inner.pointed.is_empty() {
                            for (reached, writes) in look_alone()?.by_call(at)? {
                                effects.add_reached(reached, writes)?;
                            }
                        }
                        sees.call(at, inner, instance);
                        let is_own = |held: &TempValue| matches!(*held, TempValue::Constant(pointer) if pointed_area(pointer, true) == Ok(Area::InstanceData));
                        if given.iter().any(is_own) {
                            effects.written.push(ANYWHERE);
                        }
                        // The registers of data blocks are restored, and AR2 mostly.
                        opened = None;
                        held.clear();
                        numbers = IndexValues::default();
                        if !self.pointers[callee].kept {
                            instance = None;
                        }
                        continue;
                    }
                    Inst::Intrinsic { intrinsic: Intrinsic::Clock, .. }
                    | Inst::Compute { .. }
                    | Inst::Require { .. }
                    | Inst::RequireStack { .. }
                    | Inst::Jump { .. }
                    | Inst::Branch { .. }
                    | Inst::JumpTable { .. }
                    | Inst::Return => {}
                    Inst::Text { action, to: Place::Fixed { area, .. } | Place::Indirect { area, .. }, .. }
                        if action.writes() && area != Area::InstanceData =>
                    {
                        self.write_area(&mut effects, area, opened)?;
                    }
                    Inst::Text { action, to: Place::Indirect { area: Area::InstanceData, pointer, offset }, to_room, .. }
                        if action.writes() =>
                    {
                        let added = instance.filter(|_| pointer.register() == Some(Register::Ar2));
                        let range = bits_behind(added, offset, 8 * strings::bytes_of(to_room));
                        effects.add_instance(&range);
                    }
                    Inst::Text { action, to: Place::Fixed { .. }, .. } if action.writes() => return None,
                    // What it writes by pointers was found before.
                    Inst::Text { .. } => {}
                    Inst::Intrinsic { .. } | Inst::Call { .. } => return None,
                }
                if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
                    // CDB: the instance is another block from here on.
                    if dst.register().is_some_and(|register| open_blocks() & bit_of(register) != 0) {
                        return None;
                    }
                    held.insert(dst.0, result);
                    numbers.follow_write((at, inst, dst), &mut instance, pointers);
                }
            }
        }
        // What a parameter names in a data block is counted from the one that is open. Pointers in memory are what the caller wrote there
        // only if the block does not write there, neither by its parameters.
        let is_written = |(source, width): (ArgumentSource, Width)| match source {
            ArgumentSource::Instance(offset) => {
                let own = i64::from(offset as i32)..i64::from(offset as i32) + i64::from(width.bits());
                effects.written.iter().any(|range| own.start < range.end && range.start < own.end)
            }
            ArgumentSource::Given(..) => false,
        };
        let sources = effects.pointed.iter().flat_map(PointerAccess::sources).chain(effects.texts.iter().flat_map(WrittenText::sources));
        let kept = !{ sources }.any(is_written);
        let is_plain = !opens || effects.given.is_empty() || !effects.pointed.is_empty();
        if let Some(look) = look.get().and_then(Option::as_ref) {
            effects.alone = Some(Rc::new(sees.alone(look, code.statement_count() as u32)?));
        }
        (is_plain && kept).then_some(effects)
    }

    /// Texts that a block writes by pointers.
    fn texts_of(&self, index: usize) -> Option<Vec<WrittenText>> {
        let (block, pointers) = (&self.blocks[index], &self.pointers[index]);
        strings::written(block, pointers, &mut |callee| {
            let Callee::Block(id) = callee else { return None };
            let callee = (self.find)(*id)? as usize;
            Some(self.found[callee].as_ref()?.texts.clone())
        })
    }

    /// Whether a place is in the local data of a block, whatever happens.
    fn is_own(&self, index: usize, place: Place) -> bool {
        matches!(place, Place::Fixed { area: Area::Local, position } if position / 8 + 8 <= self.blocks[index].local_size)
    }

    /// Whether an area is memory.
    fn has(&self, area: Area) -> bool {
        matches!(area, Area::Local | Area::SharedData | Area::InstanceData) || self.layout.area(area).is_some()
    }

    fn write_area(&self, effects: &mut ModRef, area: Area, opened: Option<Opened>) -> Option<()> {
        match area {
            Area::Local => {}
            Area::InstanceData => effects.instance = Some(ANYWHERE),
            Area::SharedData => match opened? {
                Opened::Number(number) => effects.blocks.push(number),
                Opened::Read(_) => return None,
            },
            _ if self.has(area) => effects.areas.push(area),
            _ => return None,
        }
        Some(())
    }
}

/// What a block looks at while it runs.
#[derive(Default)]
struct Sees {
    alone: SymbolicSummary,
    /// Access to the instance by computed addresses.
    computed: Vec<(u32, Width)>,
    calls: Vec<u32>,
    /// Whether it looks at something that nobody names.
    unnamed: bool,
}

impl Sees {
    fn instance(&mut self, bits: &Range<i64>) {
        let own = &mut self.alone.instance;
        *own = if own.is_empty() { bits.clone() } else { own.start.min(bits.start)..own.end.max(bits.end) };
    }

    /// A computed address.
    fn place(&mut self, access: (u32, Width), (area, pointer, offset): (Area, Var, u32), instance: Option<u32>, opened: Option<Opened>) {
        match (area, pointer.register(), instance) {
            (Area::InstanceData, Some(Register::Ar2), Some(_)) => self.instance(&instance_range(instance, offset, access.1)),
            (Area::InstanceData, Some(Register::Ar2), None) => self.unnamed = true,
            (Area::InstanceData, ..) => self.computed.push(access),
            _ => self.area(area, opened),
        }
    }

    fn area(&mut self, area: Area, opened: Option<Opened>) {
        match (area, opened) {
            (Area::Local, _) => {}
            (Area::SharedData, Some(Opened::Number(number))) => self.alone.blocks.push(number),
            (Area::SharedData | Area::InstanceData, _) => self.unnamed = true,
            _ => self.alone.areas.push(area),
        }
    }

    fn call(&mut self, at: u32, inner: &ModRef, instance: Option<u32>) {
        self.calls.push(at);
        let Some(alone) = &inner.alone else { return };
        self.alone.areas.extend(&alone.areas);
        self.alone.blocks.extend(&alone.blocks);
        match instance {
            _ if alone.instance.is_empty() => {}
            Some(added) => {
                let added = i64::from(added as i32);
                self.instance(&(alone.instance.start + added..alone.instance.end + added));
            }
            None => self.unnamed = true,
        }
    }

    /// All of it, with what the look found.
    fn alone(mut self, look: &Summarizer<'_>, statements: u32) -> Option<SymbolicSummary> {
        for (inst, width) in std::mem::take(&mut self.computed) {
            if let Some(Reached::Instance(bits)) = look.reached(inst, width) {
                self.instance(&bits);
            }
        }
        self.alone.areas.dedup();
        self.alone.blocks.dedup();
        (!self.unnamed).then(|| look.alone(self.alone, &self.calls, statements))
    }
}

/// Bits of an instance, from where AR2 points when the block is called.
fn instance_range(added: Option<u32>, offset: u32, width: Width) -> Range<i64> {
    bits_behind(added, offset, width.bits())
}

/// So many bits of it.
fn bits_behind(added: Option<u32>, offset: u32, bits: u32) -> Range<i64> {
    match added {
        Some(added) => {
            let first = i64::from(added as i32) + i64::from(offset);
            first..first + i64::from(bits)
        }
        None => ANYWHERE,
    }
}

impl ModRef {
    fn add_instance(&mut self, range: &Range<i64>) {
        self.written.push(range.clone());
        self.instance = Some(match &self.instance {
            Some(known) => known.start.min(range.start)..known.end.max(range.end),
            None => range.clone(),
        });
    }

    /// Access through a pointer that a parameter or the instance has; what it reads.
    fn access_through(&mut self, pointer: TempValue, offset: u32, width: Width, writes: bool, opened: Option<Opened>) -> Option<TempValue> {
        match pointer {
            TempValue::Parameter(parameter) => {
                let given = ParameterAccess { parameter, offset, width, writes };
                if !self.given.contains(&given) {
                    self.given.push(given);
                }
                Some(TempValue::Read(ArgumentSource::Given(parameter, offset), width))
            }
            TempValue::Read(pointer, Width::DoubleWord) => {
                let number = match opened {
                    Some(Opened::Read(number)) => Some(number),
                    Some(Opened::Number(_)) => return None,
                    None => None,
                };
                let first = i64::from(offset);
                self.add_pointed(PointerAccess { number, pointer, bits: first..first + i64::from(width.bits()), writes });
                Some(TempValue::Other)
            }
            _ => None,
        }
    }

    fn add_pointed(&mut self, pointed: PointerAccess) {
        if !self.pointed.contains(&pointed) {
            self.pointed.push(pointed);
        }
    }

    /// Access by a computed address, as it was found by a look at the block alone.
    fn add_reached(&mut self, reached: Reached, writes: bool) -> Option<()> {
        match reached {
            Reached::Own => {}
            Reached::Instance(bits) if writes => self.add_instance(&bits),
            Reached::Instance(_) => {}
            Reached::Pointed((number, pointer), bits) => self.add_pointed(PointerAccess { number: Some(number), pointer, bits, writes }),
        }
        Some(())
    }

    /// Adds what a called block does, but for what it reaches by pointers in memory.
    fn add_call(&mut self, inner: &Self, given: &[TempValue], moved_by: Option<(i64, i64)>) -> Option<()> {
        self.areas.extend(&inner.areas);
        self.blocks.extend(&inner.blocks);
        match (&inner.instance, moved_by) {
            (None, _) => {}
            (Some(range), Some((least, most))) => self.add_instance(&(range.start + least..range.end + most)),
            (Some(_), None) => self.add_instance(&ANYWHERE),
        }
        for access in &inner.given {
            match given.get(usize::from(access.parameter)).copied().unwrap_or(TempValue::Constant(0)) {
                TempValue::Constant(pointer) => match pointed_area(pointer, access.writes).ok()? {
                    area @ (Area::Input | Area::Output | Area::BitMemory) if access.writes => self.areas.push(area),
                    Area::Input | Area::Output | Area::BitMemory => {}
                    // Its own local data.
                    Area::CallerLocal if pointer & 0x00FF_FFFF < 1 << CALLS_SHIFT => {}
                    Area::InstanceData if access.writes => self.add_instance(&ANYWHERE),
                    Area::InstanceData | Area::SharedData if !access.writes => {}
                    _ => return None,
                },
                TempValue::Parameter(_) | TempValue::Read(..) | TempValue::Moved | TempValue::Other => return None,
            }
        }
        Some(())
    }
}
