//! What a small block may write, so that its caller keeps what it knows of all other memory over a call that becomes part of it.
//!
//! Nobody looks at a block here that asks in the middle of a statement, or that writes where this cannot tell: whoever is asked between two
//! statements may change memory, and behind that question the facts of all callers are looked at, too.

use std::collections::BTreeMap;
use std::ops::Range;

use sieben_engine::Layout;
use sieben_engine::access::pointed_area;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Callee, DataRegister, Inst, OnFault, Op, Place, Var};
use sieben_engine::machine::{CALLS_SHIFT, Register};
use sieben_model::address::{Area, Width};

use super::analysis::open_blocks;
use super::inlining::Plan;
use super::instance_pointer::InstancePointer;
use super::ranges::{self, Interval};
use super::{Find, bit_of};
use crate::jit::Native;

mod texts;

pub(super) use texts::WrittenText;

/// Bits that a pointer may count.
pub(super) const POSITIONS: i64 = 1 << 24;

/// Anything in the instance data block.
const ANYWHERE: Range<i64> = -0x1000_0000..0x1000_0000;

/// What a block may write but its own local data.
#[derive(Clone, Debug, Default)]
pub(super) struct Effects {
    /// Bits of the instance data block, from where AR2 points when the block is called.
    pub(super) instance: Option<Range<i64>>,
    /// Areas of the CPU.
    pub(super) areas: Vec<Area>,
    /// Data blocks.
    pub(super) blocks: Vec<u16>,
    /// Access through parameters.
    pub(super) given: Vec<Given>,
    /// Access through pointers to which parameters or the instance have another pointer, each with the number of a data block: a
    /// structure or an array as VAR_IN_OUT. The block writes to none of them itself.
    pub(super) pointed: Vec<Pointed>,
    /// Texts that it writes by pointers.
    pub(super) texts: Vec<WrittenText>,
}

/// Where a block finds a number that its caller wrote there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// In its instance, so many bits behind AR2.
    Instance(u32),
    /// Where a parameter points, and so many bits behind that.
    Given(u16, u32),
}

/// Access through a pointer that the block was given in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pointed {
    /// The data block that is open then, if the block opened one.
    pub(super) number: Option<Source>,
    pub(super) pointer: Source,
    /// Bits behind the pointer.
    pub(super) offset: u32,
    pub(super) width: Width,
    pub(super) writes: bool,
}

impl Pointed {
    /// Where the block reads what it needs to know.
    pub(super) fn sources(&self) -> impl Iterator<Item = (Source, Width)> {
        self.number.map(|number| (number, Width::Word)).into_iter().chain([(self.pointer, Width::DoubleWord)])
    }
}

/// Access through a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Given {
    pub(super) parameter: u16,
    /// Bits behind the pointer.
    pub(super) offset: u32,
    pub(super) width: Width,
    pub(super) writes: bool,
}

/// What a variable of the IR holds.
#[derive(Clone, Copy)]
enum Held {
    Constant(u64),
    Parameter(u16),
    /// What was read from there, in so many bits.
    Read(Source, Width),
    Other,
}

/// The data block that a statement has opened.
#[derive(Clone, Copy)]
enum Opened {
    Number(u16),
    Read(Source),
}

/// A number that a statement computes.
#[derive(Clone, Copy)]
struct Number {
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
struct Numbers {
    known: BTreeMap<u8, Number>,
    made: usize,
}

impl Numbers {
    fn get(&mut self, var: Var, instance: Option<u32>) -> Number {
        if var.register() == Some(Register::Ar2) {
            return self.number(Interval::constant(u64::from(instance.unwrap_or(0))), instance.is_some());
        }
        match self.known.get(&var.0) {
            Some(&number) => number,
            None => self.number(Interval::any(64), false),
        }
    }

    fn number(&mut self, range: Interval, from_instance: bool) -> Number {
        self.made += 1;
        Number { range, from_instance, id: self.made, below: None }
    }

    /// Follows an instruction that writes a variable.
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

    fn result(&mut self, op: Op, args: &[Number]) -> Number {
        let any = Interval::any(64);
        match (op, args) {
            (Op::Below, &[number, limit]) => {
                let below = limit.range.exact().filter(|&limit| limit > 0 && !number.from_instance).map(|limit| (number.id, limit));
                Number { below, ..self.number(any, false) }
            }
            // An index that is outside of its array counts as the first one.
            (Op::Gate, &[number, Number { below: Some((id, limit)), .. }]) if number.id == id => {
                let range = Interval { least: 0, most: i64::try_from(limit - 1).unwrap_or(i64::MAX), zeros: 0, bits: 32 };
                self.number(if limit > 1 << 31 { any } else { range }, false)
            }
            (Op::AddU32, &[a, b]) if a.from_instance != b.from_instance => {
                let (least, most) = ranges::result(op, [a.range, b.range, a.range]).unsigned(32);
                let fits = [a, b].iter().all(|number| number.range.unsigned(64).1 < i128::from(POSITIONS));
                let range = Interval { least: least as i64, most: most as i64, zeros: 0, bits: 32 };
                self.number(if fits { range } else { any }, fits)
            }
            _ if args.iter().any(|number| number.from_instance) => self.number(any, false),
            _ => {
                let mut all = [Interval::constant(0); 3];
                all.iter_mut().zip(args).for_each(|(range, number)| *range = number.range);
                self.number(ranges::result(op, all), false)
            }
        }
    }

    /// Bits of the instance to which an access goes, from where AR2 points when the block is called.
    fn instance_range(&self, pointer: Var, offset: u32, width: Width) -> Option<Range<i64>> {
        let number = self.known.get(&pointer.0).filter(|number| number.from_instance)?;
        let (least, most) = number.range.unsigned(32);
        Some(least as i64 + i64::from(offset)..most as i64 + i64::from(offset) + i64::from(width.bits()))
    }
}

/// The effects of all blocks that may become part of others; `None` = nothing is told of that block.
pub(super) fn find(
    blocks: &[Native],
    find: Find<'_>,
    layout: &Layout,
    plans: &[Plan],
    pointers: &[InstancePointer],
) -> Vec<Option<Effects>> {
    let mut search = Search { blocks, find, layout, plans, pointers, found: vec![None; blocks.len()] };
    (0..blocks.len()).for_each(|index| drop(search.of_block(index)));
    search.found.into_iter().map(Option::flatten).collect()
}

struct Search<'a> {
    blocks: &'a [Native],
    find: Find<'a>,
    layout: &'a Layout,
    plans: &'a [Plan],
    pointers: &'a [InstancePointer],
    found: Vec<Option<Option<Effects>>>,
}

impl Search<'_> {
    /// A block that calls itself is none that becomes part of another one.
    fn of_block(&mut self, index: usize) -> Option<Effects> {
        if let Some(found) = &self.found[index] {
            return found.clone();
        }
        let effects = self.plans[index].inlined().and_then(|_| self.look_at(index));
        self.found[index] = Some(effects.clone());
        effects
    }

    fn look_at(&mut self, index: usize) -> Option<Effects> {
        let (code, pointers) = (&self.blocks[index].code, &self.pointers[index]);
        let mut effects = Effects { texts: self.texts_of(index)?, ..Effects::default() };
        let mut opens = false;
        let mut written: Vec<Range<i64>> = Vec::new();
        for statement in 0..code.statement_count() {
            let mut held: BTreeMap<u8, Held> = BTreeMap::new();
            let mut passed: Vec<Held> = Vec::new();
            let mut opened: Option<Opened> = None;
            let mut numbers = Numbers::default();
            let mut instance = pointers.at(statement as u32);
            for (at, inst) in (code.statements[statement]..).zip(code.statement(statement)) {
                let of = |var: Var| held.get(&var.0).copied().unwrap_or(Held::Other);
                let mut result = Held::Other;
                match *inst {
                    Inst::Constant { value, .. } => result = Held::Constant(value),
                    Inst::Compute { op: Op::Copy, args, .. } => result = of(args[0]),
                    Inst::Parameter { index, .. } => result = Held::Parameter(index),
                    Inst::Load { on_fault: OnFault::DeliverZero, place, .. } if !self.is_own(index, place) => return None,
                    Inst::Load { place, width, .. } => match place {
                        Place::Crossing { pointer, offset } => {
                            result = effects.access_through(of(pointer), offset, width, false, opened)?;
                        }
                        Place::Fixed { area, .. } => drop(self.has(area).then_some(())?),
                        Place::Indirect { area, pointer, offset } => {
                            self.has(area).then_some(())?;
                            if area == Area::InstanceData
                                && pointer.register() == Some(Register::Ar2)
                                && let Some(added) = instance
                            {
                                result = Held::Read(Source::Instance(added.wrapping_add(offset)), width);
                            }
                        }
                    },
                    Inst::Store { place, width, .. } => match place {
                        Place::Crossing { pointer, offset } => {
                            effects.access_through(of(pointer), offset, width, true, opened)?;
                        }
                        Place::Indirect { area: Area::InstanceData, pointer, offset } if pointer.register() == Some(Register::Ar2) => {
                            effects.write_instance(instance, offset, width);
                            written.push(instance_range(instance, offset, width));
                        }
                        Place::Indirect { area: Area::InstanceData, pointer, offset }
                            if let Some(range) = numbers.instance_range(pointer, offset, width) =>
                        {
                            effects.add_instance(&range);
                            written.push(range);
                        }
                        Place::Fixed { area, .. } | Place::Indirect { area, .. } => {
                            if area == Area::InstanceData {
                                written.push(ANYWHERE);
                            }
                            self.write_area(&mut effects, area, opened)?;
                        }
                    },
                    Inst::Open { register, .. } if register != DataRegister::Shared => return None,
                    Inst::Open { number, .. } => {
                        opens = true;
                        opened = Some(match of(number) {
                            Held::Constant(number) => {
                                let number = (number & 0xFFFF) as u16;
                                if number != 0 && !self.layout.data_blocks.contains_key(&number) {
                                    return None;
                                }
                                Opened::Number(number)
                            }
                            Held::Read(source, Width::Word) => Opened::Read(source),
                            _ => return None,
                        });
                    }
                    Inst::PassParameter { src } => passed.push(of(src)),
                    Inst::Call { callee: Callee::Block(id), parameters } => {
                        let callee = (self.find)(id)? as usize;
                        let given = passed.split_off(passed.len().checked_sub(usize::from(parameters))?);
                        let inner = self.of_block(callee)?;
                        effects.add_call(&inner, &given, instance)?;
                        let is_own =
                            |held: &Held| matches!(*held, Held::Constant(pointer) if pointed_area(pointer, true) == Ok(Area::InstanceData));
                        if given.iter().any(is_own) {
                            written.push(ANYWHERE);
                        }
                        written.extend(inner.instance.iter().map(|range| match instance {
                            Some(added) => range.start + i64::from(added as i32)..range.end + i64::from(added as i32),
                            None => ANYWHERE,
                        }));
                        // The registers of data blocks are restored, and AR2 mostly.
                        opened = None;
                        held.clear();
                        numbers = Numbers::default();
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
                        let range = bits_behind(added, offset, 8 * texts::bytes_of(to_room));
                        effects.add_instance(&range);
                        written.push(range);
                    }
                    Inst::Text { action, to: Place::Fixed { .. }, .. } if action.writes() => return None,
                    // What it writes by pointers was found before.
                    Inst::Text { .. } => {}
                    Inst::Move { .. } | Inst::Intrinsic { .. } | Inst::Call { .. } => return None,
                }
                if let Some(dst) = sieben_engine::ir::verify::writes(inst) {
                    // CDB: the instance is another block from here on.
                    if dst.register().is_some_and(|register| open_blocks() & bit_of(register) != 0) {
                        return None;
                    }
                    held.insert(dst.0, result);
                    numbers.follow(inst, dst, instance);
                    if dst == Register::Ar2.into() {
                        instance = pointers.after(at);
                    }
                }
            }
        }
        // What a parameter names in a data block is counted from the one that is open. Pointers in memory are what the caller wrote there
        // only if the block does not write there, neither by its parameters.
        let is_written = |(source, width): (Source, Width)| match source {
            Source::Instance(offset) => {
                let own = i64::from(offset as i32)..i64::from(offset as i32) + i64::from(width.bits());
                written.iter().any(|range| own.start < range.end && range.start < own.end)
            }
            Source::Given(..) => false,
        };
        let sources = effects.pointed.iter().flat_map(Pointed::sources).chain(effects.texts.iter().flat_map(WrittenText::sources));
        let kept = !{ sources }.any(is_written);
        let is_plain = !opens || effects.given.is_empty() || !effects.pointed.is_empty();
        (is_plain && kept).then_some(effects)
    }

    /// Texts that a block writes by pointers.
    fn texts_of(&mut self, index: usize) -> Option<Vec<WrittenText>> {
        let (block, pointers) = (&self.blocks[index], &self.pointers[index]);
        texts::written(block, pointers, &mut |callee| {
            let Callee::Block(id) = callee else { return None };
            let callee = (self.find)(*id)? as usize;
            Some(self.of_block(callee)?.texts)
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

    fn write_area(&self, effects: &mut Effects, area: Area, opened: Option<Opened>) -> Option<()> {
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

impl Effects {
    fn write_instance(&mut self, added: Option<u32>, offset: u32, width: Width) {
        self.add_instance(&instance_range(added, offset, width));
    }

    fn add_instance(&mut self, range: &Range<i64>) {
        self.instance = Some(match &self.instance {
            Some(known) => known.start.min(range.start)..known.end.max(range.end),
            None => range.clone(),
        });
    }

    /// Access through a pointer that a parameter or the instance has; what it reads.
    fn access_through(&mut self, pointer: Held, offset: u32, width: Width, writes: bool, opened: Option<Opened>) -> Option<Held> {
        match pointer {
            Held::Parameter(parameter) => {
                let given = Given { parameter, offset, width, writes };
                if !self.given.contains(&given) {
                    self.given.push(given);
                }
                Some(Held::Read(Source::Given(parameter, offset), width))
            }
            Held::Read(pointer, Width::DoubleWord) => {
                let number = match opened {
                    Some(Opened::Read(number)) => Some(number),
                    Some(Opened::Number(_)) => return None,
                    None => None,
                };
                let pointed = Pointed { number, pointer, offset, width, writes };
                if !self.pointed.contains(&pointed) {
                    self.pointed.push(pointed);
                }
                Some(Held::Other)
            }
            _ => None,
        }
    }

    /// Adds what a called block does.
    fn add_call(&mut self, inner: &Self, given: &[Held], added: Option<u32>) -> Option<()> {
        if !inner.pointed.is_empty() {
            return None;
        }
        self.areas.extend(&inner.areas);
        self.blocks.extend(&inner.blocks);
        match (&inner.instance, added) {
            (None, _) => {}
            (Some(range), Some(added)) => {
                let bits = i64::from(added as i32);
                self.add_instance(&(range.start + bits..range.end + bits));
            }
            (Some(_), None) => self.add_instance(&ANYWHERE),
        }
        for access in &inner.given {
            match given.get(usize::from(access.parameter)).copied().unwrap_or(Held::Constant(0)) {
                Held::Constant(pointer) => match pointed_area(pointer, access.writes).ok()? {
                    area @ (Area::Input | Area::Output | Area::BitMemory) if access.writes => self.areas.push(area),
                    Area::Input | Area::Output | Area::BitMemory => {}
                    // Its own local data.
                    Area::CallerLocal if pointer & 0x00FF_FFFF < 1 << CALLS_SHIFT => {}
                    Area::InstanceData if access.writes => self.add_instance(&ANYWHERE),
                    Area::InstanceData | Area::SharedData if !access.writes => {}
                    _ => return None,
                },
                Held::Parameter(_) | Held::Read(..) | Held::Other => return None,
            }
        }
        Some(())
    }
}
