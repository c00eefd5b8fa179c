//! Scalar promotion: memory variables of a loop live in registers. They are loaded at its entry, stored at its exits and wherever an
//! observer may look, and loaded again where one may have changed them.
//!
//! Which ones are promoted is a matter of cost only. Every access is first asked for here: one to exactly these bytes goes to the register,
//! one that may alias some of them finds memory as the program left it.

use std::collections::{BTreeMap, BTreeSet};
use std::mem::offset_of;
use std::ops::Range;

use cranelift_codegen::ir::types::{F32, F64, I32, I64};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Type, Value};
use cranelift_frontend::Variable;
use sieben_engine::access::data_registers;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Callee, DataRegister, Inst, Op, Place, TextRoom, Var, verify};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use super::congruence::{Congruence, StridedBytes};
use super::memory::{Address, Bit, moved};
use super::natural_loops::NaturalLoop;
use super::range_analysis;
use super::value::Val;
use super::{TRUSTED, Translator};
use crate::jit::loop_heads;
use crate::passes::Pass;
use crate::run::Run;

/// Variables that are kept at the same time and that a loop uses; more would be kept on the stack, which is memory too.
const PROMOTED_MAX: usize = 8;
/// Variables that are kept at the same time, with those that only the loops around use: cold code stores each of them.
const PROMOTED_IN_ALL_MAX: usize = 14;
/// How much more an access counts for each loop around it.
const WEIGHT_OF_A_LOOP: u64 = 8;
/// Loops around an access that make it count more.
const WEIGHED_LOOPS_MAX: usize = 4;

/// How deep calls are followed.
pub(super) const CALLS_MAX: u32 = 3;

/// What an address is counted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Base {
    /// The first byte of the arena.
    Arena,
    /// The same, of some element of an array.
    Spaced(StridedBytes),
    /// The first byte of the local data of the function's outermost block.
    Local,
    /// The run: its budget.
    Run,
    /// An address that is computed.
    Computed(ComputedAddress),
}

/// An address in the arena that is computed, and the bytes where it may lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct ComputedAddress {
    pub(super) address: Value,
    pub(super) least: i64,
    pub(super) most: i64,
    pub(super) spacing: Congruence,
    /// Another such address from which it is counted, if it is.
    pub(super) part_of: Option<Displacement>,
}

/// How many bytes an address lies behind another one: at least, and at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Displacement {
    pub(super) of: Value,
    pub(super) least: i64,
    pub(super) most: i64,
    pub(super) spacing: Congruence,
}

impl Base {
    /// Whether bytes behind this base may be some of those behind another one.
    pub(super) fn may_share(self, bytes: &Range<i64>, other: Self, others: &Range<i64>) -> bool {
        let share = |a: &Range<i64>, b: &Range<i64>| a.start < b.end && b.start < a.end;
        if self == other {
            return share(bytes, others);
        }
        if let (Self::Computed(own), Self::Computed(other)) = (self, other)
            && let Some((own, other)) = own.counted_from_one(&other)
        {
            let is_apart = || StridedBytes::of(own.spacing, bytes).is_apart(&StridedBytes::of(other.spacing, others));
            return share(&own.reach(bytes), &other.reach(others)) && !is_apart();
        }
        match (self.in_arena(bytes), other.in_arena(others)) {
            (Some(own), Some(theirs)) => share(&own, &theirs) && !self.spaced(bytes).is_apart(&other.spaced(others)),
            _ => false,
        }
    }

    /// The area, whichever element of an array there it is.
    pub(super) fn area(self) -> Self {
        if let Self::Spaced(_) = self { Self::Arena } else { self }
    }

    /// Where the bytes begin, whichever element of an array they are in.
    pub(super) fn begin(self) -> Congruence {
        if let Self::Spaced(StridedBytes { begin, .. }) = self { begin } else { Congruence::ANY }
    }

    /// Which bytes of each element of an array in the arena it may be.
    fn spaced(self, bytes: &Range<i64>) -> StridedBytes {
        match self {
            Self::Spaced(spaced) => spaced,
            Self::Computed(ComputedAddress { spacing, .. }) => StridedBytes::of(spacing, bytes),
            Self::Arena | Self::Local | Self::Run => StridedBytes::of(Congruence::exactly(0), bytes),
        }
    }

    /// Where bytes behind it may lie in the arena.
    fn in_arena(self, bytes: &Range<i64>) -> Option<Range<i64>> {
        match self {
            Self::Arena | Self::Spaced(_) => Some(bytes.clone()),
            Self::Computed(ComputedAddress { least, most, .. }) => Some(least + bytes.start..most + bytes.end),
            Self::Local | Self::Run => None,
        }
    }
}

impl ComputedAddress {
    /// How far it and another address lie behind one from which both are counted.
    fn counted_from_one(&self, other: &Self) -> Option<(Displacement, Displacement)> {
        let itself = |it: &Self| Displacement { of: it.address, least: 0, most: 0, spacing: Congruence::exactly(0) };
        let [own, others] = [self, other].map(|it| [Some(itself(it)), it.part_of]);
        let mut pairs = own.into_iter().flatten().flat_map(|own| others.into_iter().flatten().map(move |other| (own, other)));
        pairs.find(|(own, other)| own.of == other.of)
    }
}

impl Displacement {
    /// Where bytes behind the address may lie behind the one from which it is counted.
    fn reach(&self, bytes: &Range<i64>) -> Range<i64> {
        self.least + bytes.start..self.most + bytes.end
    }
}

/// Bytes that a register stands for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Promoted {
    base: Base,
    offset: i32,
    width: Width,
    /// Whether they lie in a data block.
    in_data_block: bool,
    variable: Variable,
    /// The same as a REAL or LREAL, if the loop computes with it.
    real: Option<Variable>,
    /// Whether the loop writes them.
    written: bool,
    /// In how many blocks around it the block lies whose statements hand them on, if nobody needs them between these.
    handed: Option<usize>,
    /// First and last statement of the loop.
    first: u32,
    last: u32,
}

impl Promoted {
    /// What the register stands for as long as the block runs.
    fn in_block(base: Base, offset: i32, width: Width, variable: Variable) -> Self {
        let (first, last) = (0, u32::MAX);
        Self { base, offset, width, in_data_block: false, variable, real: None, written: true, handed: None, first, last }
    }

    fn is_in(&self, statement: u32) -> bool {
        (self.first..=self.last).contains(&statement)
    }

    /// Which bit of the number the bit of a byte is; `None` = it is none of it.
    fn bit_behind(&self, byte: i32, number: u8) -> Option<u8> {
        let behind = byte.checked_sub(self.offset)?;
        let last = self.width.bytes() as i32 - 1;
        let is_here = (0..=last).contains(&behind) && holds_bits(self.width) && self.real.is_none();
        is_here.then(|| 8 * (last - behind) as u8 + number)
    }

    fn overlaps(&self, touched: &AccessSet) -> bool {
        match touched {
            _ if self.base == Base::Run => false,
            AccessSet::Bytes(base, range) => {
                let start = i64::from(self.offset);
                self.base.may_share(&(start..start + i64::from(self.width.bytes())), *base, range)
            }
            AccessSet::DataBlocks => self.in_data_block,
            AccessSet::Anything => true,
        }
    }
}

/// What statements are that are looked at for what they reach.
#[derive(Clone, Copy, PartialEq, Eq)]
enum AccessKind {
    /// Those of the loop itself.
    Loop,
    /// Those of a block that becomes part of it.
    Block,
    /// The same, and all pointers into its instance are counted from where that begins.
    BlockByPointers,
}

/// What an access may touch.
#[derive(Clone, Debug)]
enum AccessSet {
    Bytes(Base, Range<i64>),
    /// Any data block.
    DataBlocks,
    Anything,
}

/// Bytes that may be kept in a register.
struct Candidate {
    width: Width,
    in_data_block: bool,
    written: bool,
    /// Whether nobody needs them between statements.
    handed: bool,
    weight: u64,
    /// Whether the loop computes with it as a REAL or LREAL.
    real: bool,
}

impl Candidate {
    /// Whether bits may be read and written in it, too.
    fn may_hold_bits(&self) -> bool {
        holds_bits(self.width) && !self.real
    }
}

/// Whether bits are found in a register that stands for a number.
fn holds_bits(width: Width) -> bool {
    matches!(width, Width::Byte | Width::Word | Width::DoubleWord)
}

/// Whether an operation works on REALs or LREALs as such; only the cost depends on it.
fn computes_reals(op: Op) -> bool {
    let reals =
        matches!(op, Op::AddF32 | Op::SubF32 | Op::MulF32 | Op::DivF32 | Op::SqrF32 | Op::LtF32 | Op::LeF32 | Op::GtF32 | Op::GeF32);
    let doubles =
        matches!(op, Op::AddF64 | Op::SubF64 | Op::MulF64 | Op::DivF64 | Op::SqrtF64 | Op::LtF64 | Op::LeF64 | Op::GtF64 | Op::GeF64);
    reals || doubles || matches!(op, Op::MinF32 | Op::MaxF32 | Op::MinF64 | Op::MaxF64)
}

/// What a register holds that stands for a whole number.
fn type_of(width: Width) -> Type {
    if width == Width::QuadWord { I64 } else { I32 }
}

impl Translator<'_> {
    /// What is kept in registers at the running statement.
    fn kept(&self) -> Vec<Promoted> {
        self.promoted.iter().copied().filter(|it| it.is_in(self.statement)).collect()
    }

    /// Chooses what a loop keeps and loads it, before the loop. Registers that it changes are not known here.
    pub(super) fn promote(&mut self, it: &NaturalLoop) {
        if !self.options.passes.has(Pass::ScalarPromotion) {
            return;
        }
        if !it.asks_for_texts || !self.keeps_over_calls(it) {
            return;
        }
        let (candidates, mut used) = self.candidates(it);
        let mut candidates: Vec<_> = candidates.into_iter().collect();
        // A block that becomes part of the loop may write what the loop itself only reads.
        let blocks_write = !it.calls_nothing;
        let order = |candidate: &Candidate| (candidate.handed, std::cmp::Reverse((candidate.written, candidate.weight)));
        candidates.sort_by_key(|(place, candidate)| (order(candidate), *place));
        for ((base, offset), candidate) in candidates {
            if self.kept().len() > PROMOTED_IN_ALL_MAX {
                break;
            }
            if candidate.handed || used < PROMOTED_MAX {
                let in_arena = matches!(base, Base::Arena | Base::Computed(_));
                let written = candidate.written || blocks_write || !it.calls_nothing && !in_arena;
                self.keep(base, offset, &Candidate { written, ..candidate }, it);
                used += usize::from(!candidate.handed);
            }
        }
    }

    /// Keeps the budget in a register as long as the function runs.
    pub(super) fn keep_budget(&mut self) {
        let offset = offset_of!(Run<'_, '_>, budget) as i32;
        let budget = Promoted::in_block(Base::Run, offset, Width::QuadWord, self.b.declare_var(I64));
        self.take(budget);
        self.promoted.push(budget);
    }

    /// What is kept in registers, for an inlined block, in all of which that stays which is kept at its call.
    pub(super) fn keep_in_block(&mut self) -> Vec<Promoted> {
        let kept = self.kept().into_iter().map(|kept| Promoted { first: 0, last: u32::MAX, ..kept }).collect();
        std::mem::replace(&mut self.promoted, kept)
    }

    /// Whether a loop calls only blocks that become part of it and say where they read and write: in their own local data, in their
    /// instance, at the pointers that they are given. Everything else would find the variables of the loop in memory.
    fn keeps_over_calls(&self, it: &NaturalLoop) -> bool {
        let code = &self.native().code;
        let is_known = |(index, inst): (u32, &Inst)| match inst {
            Inst::Call { callee: Callee::Block(id), .. } => !self.reads_pointers(*id) || self.ranges.is_kept(index),
            _ => true,
        };
        (it.first..=it.last).all(|statement| {
            let insts = code.statement(statement as usize);
            self.keeps_over(insts, AccessKind::Loop, CALLS_MAX) && (code.statements[statement as usize]..).zip(insts).all(is_known)
        })
    }

    /// The same for the instructions of a statement, of an inlined block or of the loop itself.
    fn keeps_over(&self, insts: &[Inst], written: AccessKind, depth: u32) -> bool {
        let inlined = written != AccessKind::Loop;
        let (mut given, mut constants) = (BTreeSet::new(), BTreeSet::new());
        let own_instance = self.instance.constant().is_some() || self.ranges.is_relative();
        insts.iter().all(|inst| {
            let is_said = |place: Place| match place {
                Place::Fixed { area, .. } => !matches!(area, Area::SharedData | Area::InstanceData),
                Place::Indirect { area, pointer, .. } => {
                    let is_counted = pointer.register() == Some(Register::Ar2) || written == AccessKind::BlockByPointers;
                    area == Area::InstanceData && is_counted && own_instance
                }
                Place::Crossing { pointer, .. } => given.contains(&pointer.0),
            };
            match *inst {
                // What it reaches by its pointers is known.
                Inst::Call { callee: Callee::Block(id), .. } if !inlined && self.reads_pointers(id) => {
                    (self.find)(id).is_some_and(|called| self.inlines(called as usize))
                }
                Inst::Call { callee: Callee::Block(id), .. } => (self.find)(id).is_some_and(|called| {
                    let block = &self.blocks[called as usize].code;
                    let statements = || (0..block.statement_count()).map(|statement| block.statement(statement));
                    let by_pointers = range_analysis::uses(block, &|_| false, &|_| false).is_some();
                    let written = if by_pointers { AccessKind::BlockByPointers } else { AccessKind::Block };
                    // What texts may reach is stored for each of them: that is not worth while in an inner loop.
                    let repeats_texts = block.insts.iter().any(|inst| matches!(inst, Inst::Text { .. })) && !loop_heads(block).is_empty();
                    depth > 0
                        && !repeats_texts
                        && self.inlines(called as usize)
                        && statements().all(|insts| self.keeps_over(insts, written, depth - 1))
                }),
                Inst::Call { .. } => false,
                Inst::Parameter { dst, .. } => {
                    given.insert(dst.0);
                    true
                }
                Inst::Constant { dst, .. } => {
                    constants.insert(dst.0);
                    true
                }
                Inst::PassParameter { src } => constants.contains(&src.0),
                Inst::Load { place, .. } | Inst::Store { place, .. } if inlined => is_said(place),
                Inst::Intrinsic { intrinsic: Intrinsic::Clock, .. } => true,
                Inst::Move { .. } | Inst::Intrinsic { .. } | Inst::Open { .. } => !inlined,
                _ => true,
            }
        })
    }

    /// Whether a block reads and writes by pointers that its caller wrote to memory.
    fn reads_pointers(&self, id: BlockId) -> bool {
        let effects = (self.find)(id).and_then(|code| self.effects[code as usize].as_ref());
        effects.is_some_and(|effects| !effects.pointed.is_empty())
    }

    fn keep(&mut self, base: Base, offset: i32, candidate: &Candidate, it: &NaturalLoop) {
        let &Candidate { width, in_data_block, written, real, handed, .. } = candidate;
        let real = match width {
            Width::DoubleWord if real => Some(self.b.declare_var(F32)),
            Width::QuadWord if real => Some(self.b.declare_var(F64)),
            _ => None,
        };
        let variable = self.b.declare_var(type_of(width));
        let handed = handed.then_some(self.outer.len());
        let promoted = Promoted { base, offset, width, in_data_block, variable, real, written, handed, first: it.first, last: it.last };
        match handed {
            Some(_) => self.reset(promoted),
            None => self.take(promoted),
        }
        self.promoted.push(promoted);
    }

    /// Forgets what the statement in front handed on, so that it takes no registers any more.
    pub(super) fn forget_what_was_handed(&mut self) {
        let depth = self.outer.len();
        self.kept().into_iter().filter(|it| it.handed == Some(depth)).for_each(|it| self.reset(it));
    }

    /// Lets a register stand for bytes of which nobody needs what they are.
    fn reset(&mut self, promoted: Promoted) {
        let none = self.b.ins().iconst(type_of(promoted.width), 0);
        self.b.def_var(promoted.variable, none);
        if let Some(variable) = promoted.real {
            let real = if promoted.width == Width::QuadWord { self.b.ins().f64const(0.0) } else { self.b.ins().f32const(0.0) };
            self.b.def_var(variable, real);
        }
    }

    /// Bytes that all accesses of a loop that touch them name in the same way; and how many variables it uses that are kept already.
    fn candidates(&mut self, it: &NaturalLoop) -> (BTreeMap<(Base, i32), Candidate>, usize) {
        let code = &self.native().code;
        let [mut candidates, mut bits]: [BTreeMap<(Base, i32), Candidate>; 2] = Default::default();
        let mut others = Vec::new();
        self.temporaries.clear();
        for statement in it.first..=it.last {
            let depth = self.loops.iter().filter(|inner| it.contains(inner.first) && inner.contains(statement)).count();
            let weight = WEIGHT_OF_A_LOOP.pow(depth.min(WEIGHED_LOOPS_MAX) as u32);
            let mut loaded: BTreeMap<u8, (Base, i32)> = BTreeMap::new();
            let mut results = BTreeSet::new();
            for (index, inst) in (code.statements[statement as usize]..).zip(code.statement(statement as usize)) {
                if let Inst::Compute { op, args, .. } = *inst
                    && computes_reals(op)
                {
                    for place in args[..op.arity()].iter().filter_map(|arg| loaded.get(&arg.0)) {
                        candidates.entry(*place).and_modify(|candidate| candidate.real = true);
                    }
                }
                if let Some(dst) = verify::writes(inst) {
                    loaded.remove(&dst.0);
                    results.remove(&dst.0);
                }
                let (place, width, written) = match *inst {
                    Inst::Load { place, width, .. } if self.constant_at(index, place, width).is_some() => continue,
                    Inst::Load { place, width, .. } => (place, width, false),
                    Inst::Store { place, width, .. } => (place, width, true),
                    Inst::Text { action, to, to_room, from, from_room, .. } => {
                        let target = self.touched_text(index, (to, true), to_room);
                        others.extend(if action.writes() { Some(target.unwrap_or(AccessSet::Anything)) } else { target });
                        others.extend(self.touched_text(index, (from, false), from_room));
                        continue;
                    }
                    Inst::Compute { op, dst, .. } => {
                        if computes_reals(op) || matches!(op, Op::I32ToF32 | Op::I32ToF64 | Op::I64ToF64) {
                            results.insert(dst.0);
                        }
                        continue;
                    }
                    Inst::Move { .. } => {
                        match self.ranges.moved(index) {
                            Some(both) => others.extend(both.map(|(base, bytes)| AccessSet::Bytes(base, bytes))),
                            None => others.push(AccessSet::Anything),
                        }
                        continue;
                    }
                    _ => continue,
                };
                let known = self.constant_address(place, width).or_else(|| self.ranges.pointed(index));
                let Some((base, offset)) = known.or_else(|| self.instance_address(place, width, written)) else {
                    others.push(match self.ranges.inside(index) {
                        Some((base, bytes)) => AccessSet::Bytes(base, bytes),
                        None => self.touched(place),
                    });
                    continue;
                };
                let (of_width, width) = match width {
                    Width::Bit => (&mut bits, Width::Byte),
                    width => (&mut candidates, width),
                };
                let in_data_block = self.in_data_block(place);
                let known = of_width.entry((base, offset)).or_insert(Candidate {
                    width,
                    in_data_block,
                    written,
                    handed: false,
                    weight: 0,
                    real: false,
                });
                known.written |= written;
                known.weight += weight;
                match *inst {
                    Inst::Load { width: Width::Bit, .. } => {}
                    Inst::Load { dst, .. } => drop(loaded.insert(dst.0, (base, offset))),
                    Inst::Store { src, .. } => known.real |= results.contains(&src.0),
                    _ => {}
                }
                if known.width != width {
                    let longer = known.width.bytes().max(width.bytes());
                    others.push(AccessSet::Bytes(base, i64::from(offset)..i64::from(offset) + i64::from(longer)));
                }
            }
        }
        for ((base, byte), of_bits) in bits {
            let numbers = candidates.range_mut((base, byte.saturating_sub(7))..=(base, byte)).rev();
            let mut around = numbers.filter(|((_, offset), it)| byte < offset.saturating_add(it.width.bytes() as i32));
            match around.next() {
                Some((_, number)) if number.may_hold_bits() => {
                    number.written |= of_bits.written;
                    number.weight += of_bits.weight;
                }
                Some(_) => others.push(AccessSet::Bytes(base, byte.into()..i64::from(byte) + 1)),
                None => drop(candidates.insert((base, byte), of_bits)),
            }
        }
        let spans: Vec<_> = candidates.iter().map(|(&(base, offset), it)| (base, i64::from(offset), i64::from(it.width.bytes()))).collect();
        let mut before: Option<(Base, Range<i64>)> = None;
        for &(base, start, length) in &spans {
            let mut bytes = start..start + length;
            if let Some((other, known)) = before.filter(|(other, known)| *other == base && known.end > start) {
                bytes = known.start..known.end.max(bytes.end);
                others.push(AccessSet::Bytes(other, bytes.clone()));
            }
            before = Some((base, bytes));
        }
        for &(base, start, length) in spans.iter().filter(|(base, ..)| matches!(base, Base::Computed(_))) {
            let bytes = start..start + length;
            if spans.iter().any(|&(other, first, many)| other != base && base.may_share(&bytes, other, &(first..first + many))) {
                others.push(AccessSet::Bytes(base, bytes));
            }
        }
        let writes = candidates.iter().filter(|(_, candidate)| candidate.written).map(|(&place, _)| place).collect();
        self.writes.insert((self.index, it.first), writes);
        let kept = self.kept();
        let drops_handed = self.options.forgets_locals && !self.options.exact;
        let (block, first) = (&self.blocks[self.index], self.local_offset);
        for (&(base, offset), it) in &mut candidates {
            it.handed = drops_handed && base == Base::Local && block.is_handed(offset - first, it.width.bytes());
        }
        let is_used = |kept: &&Promoted| {
            let is_touched = |&(base, start, length): &(Base, i64, i64)| kept.overlaps(&AccessSet::Bytes(base, start..start + length));
            kept.base != Base::Run && (!it.calls_nothing || spans.iter().any(is_touched))
        };
        let used = kept.iter().filter(is_used).count();
        candidates.retain(|&(base, offset), it| {
            let range = i64::from(offset)..i64::from(offset) + i64::from(it.width.bytes());
            let in_block = Promoted::in_block(base, offset, it.width, Variable::from_u32(0));
            let own = Promoted { in_data_block: it.in_data_block, ..in_block };
            !others.iter().any(|touched| own.overlaps(touched))
                && !kept.iter().any(|kept| kept.overlaps(&AccessSet::Bytes(base, range.clone())))
        });
        (candidates, used)
    }

    /// What a text instruction may touch, if that is known before the loop.
    fn touched_text(&self, index: u32, (place, is_to): (Place, bool), room: TextRoom) -> Option<AccessSet> {
        let (base, bytes) = match (self.constant_address(place, Width::Byte), self.ranges.text(index, is_to)) {
            (_, Some(known)) => known.bytes,
            (Some((base, offset)), None) if !room.is_unknown() => (base, i64::from(offset)..i64::from(offset) + i64::from(room.bytes())),
            _ => return None,
        };
        Some(AccessSet::Bytes(base, bytes))
    }

    fn in_data_block(&self, place: Place) -> bool {
        match place {
            Place::Fixed { area, .. } | Place::Indirect { area, .. } => matches!(area, Area::SharedData | Area::InstanceData),
            Place::Crossing { .. } => true,
        }
    }

    /// Base and length of an open data block, if they are constants.
    fn constant_block(&self, area: Area) -> Option<(u64, u64)> {
        let register = match area {
            Area::SharedData => DataRegister::Shared,
            Area::InstanceData => DataRegister::Instance,
            _ => return None,
        };
        let [_, base, length] = data_registers(register).map(|register| self.current[register as usize].and_then(Val::constant));
        Some((base?, length?))
    }

    /// The area of a place that is known beforehand, and the number of its first bit there.
    pub(super) fn constant_position(&self, place: Place) -> Option<(Area, u32)> {
        match place {
            Place::Fixed { area, position } => Some((area, position)),
            Place::Indirect { area, pointer, offset } => Some((area, moved(self.constant_pointer(pointer)?, offset))),
            Place::Crossing { .. } => None,
        }
    }

    /// The address of a place that is known beforehand, without its bit, if all of it lies inside its area.
    pub(super) fn constant_address(&self, place: Place, width: Width) -> Option<(Base, i32)> {
        let (area, position) = self.constant_position(place)?;
        if width != Width::Bit && position % 8 != 0 {
            return None;
        }
        let (base, start, length) = match area {
            Area::Local => (Base::Local, self.local_offset as u64, u64::from(self.native().local_size)),
            Area::SharedData | Area::InstanceData => {
                let (start, length) = self.constant_block(area)?;
                (Base::Arena, start, length)
            }
            _ => {
                let range = self.layout.area(area)?;
                (Base::Arena, range.start as u64, range.len() as u64)
            }
        };
        let byte = u64::from(position / 8);
        if byte + u64::from(width.bytes()) > length {
            return None;
        }
        Some((base, i32::try_from(start + byte).ok()?))
    }

    fn constant_pointer(&self, pointer: Var) -> Option<u64> {
        self.current[pointer.register()? as usize].and_then(Val::constant)
    }

    /// What an access to a place may touch whose address is not known beforehand.
    fn touched(&self, place: Place) -> AccessSet {
        let (Place::Fixed { area, .. } | Place::Indirect { area, .. }) = place else { return AccessSet::Anything };
        match area {
            Area::Local => {
                let first = i64::from(self.local_offset);
                AccessSet::Bytes(Base::Local, first..first + i64::from(self.native().local_size))
            }
            Area::SharedData | Area::InstanceData => match self.constant_block(area) {
                Some((base, length)) => AccessSet::Bytes(Base::Arena, base as i64..base as i64 + length as i64),
                None => AccessSet::DataBlocks,
            },
            _ => match self.layout.area(area) {
                Some(range) => AccessSet::Bytes(Base::Arena, range.start as i64..range.end as i64),
                None => AccessSet::Anything,
            },
        }
    }

    /// What stands for exactly these bytes, or for the number to which a bit belongs.
    fn promoted_at(&self, address: Address, width: Width) -> Option<Promoted> {
        let base = self.base_of(address)?;
        let here = self.promoted.iter().copied().filter(|it| it.is_in(self.statement) && it.base == base);
        { here }.find(|it| match width {
            Width::Bit => it.bit_behind(address.offset, 0).is_some(),
            width => (it.offset, it.width) == (address.offset, width),
        })
    }

    fn base_of(&self, Address { base, .. }: Address) -> Option<Base> {
        match base {
            base if let Some(&computed) = self.computed.get(&base) => Some(Base::Computed(computed)),
            base if base == self.arena => Some(Base::Arena),
            base if base == self.local => Some(Base::Local),
            _ => None,
        }
    }

    /// The value of an address that a register stands for.
    pub(super) fn read_promoted(&mut self, address: Address, width: Width) -> Option<Val> {
        let promoted = self.promoted_at(address, width)?;
        let value = self.b.use_var(promoted.variable);
        if !self.changes_in_innermost_loop(&promoted) {
            self.fixed.insert(value);
        }
        if let Some(real) = promoted.real {
            let real = self.b.use_var(real);
            return Some(match width {
                Width::QuadWord => Val::Lreal { real, bits: value },
                _ => Val::Real { real, bits: value },
            });
        }
        let first = promoted.bit_behind(address.offset, 0).unwrap_or(0);
        Some(match (width, address.bit) {
            (Width::Bit, Bit::Number(number)) => Self::bit_value(value, first + number, false),
            (Width::Bit, Bit::Computed(number)) => {
                let byte = if first == 0 { value } else { self.b.ins().ushr_imm_u(value, i64::from(first)) };
                Val::Bit { value: self.b.ins().ushr(byte, number), clean: false }
            }
            (Width::QuadWord, _) => Val::Word(value),
            (width, _) => {
                self.narrow.insert(value, width.bytes() * 8);
                Val::Int(value)
            }
        })
    }

    /// Whether the smallest loop around the running statement writes what a register stands for.
    fn changes_in_innermost_loop(&self, promoted: &Promoted) -> bool {
        let innermost = self.loops.iter().filter(|it| it.contains(self.statement)).min_by_key(|it| it.last - it.first);
        innermost.is_none_or(|it| {
            self.writes.get(&(self.index, it.first)).is_none_or(|writes| writes.contains(&(promoted.base, promoted.offset)))
        })
    }

    /// Writes to an address that a register stands for; whether one does.
    pub(super) fn write_promoted(&mut self, address: Address, width: Width, value: Val) -> bool {
        let Some(promoted) = self.promoted_at(address, width) else { return false };
        if let Some(variable) = promoted.real {
            let real = if width == Width::QuadWord { self.f64(value) } else { self.f32(value) };
            self.b.def_var(variable, real);
        }
        let value = match (width, address.bit) {
            (Width::Bit, Bit::Number(number)) => {
                let number = promoted.bit_behind(address.offset, number).unwrap_or(number);
                let old = self.b.use_var(promoted.variable);
                let all = u32::MAX >> (32 - promoted.width.bits());
                let cleared = self.b.ins().band_imm_u(old, i64::from(all & !(1 << number)));
                let bit = self.bit_at(value, number);
                self.b.ins().bor(cleared, bit)
            }
            // A bit whose number is computed is never at an address that is known beforehand.
            (Width::Bit, Bit::Computed(_)) => return false,
            (Width::QuadWord, _) => self.word(value),
            (Width::DoubleWord, _) => self.int(value),
            (width, _) => self.low_bits(value, width),
        };
        self.b.def_var(promoted.variable, value);
        true
    }

    /// The low bits of a value, in 32 bits.
    pub(super) fn low_bits(&mut self, value: Val, width: Width) -> Value {
        let bits = width.bytes() * 8;
        let value = self.int(value);
        if self.narrow.get(&value).is_some_and(|&known| known <= bits) {
            return value;
        }
        let low = self.b.ins().band_imm_u(value, (1 << bits) - 1);
        self.narrow.insert(low, bits);
        low
    }

    /// Stores what an access at an address may touch; whether anything was.
    pub(super) fn store_touched_at(&mut self, address: Address, width: Width) -> bool {
        let Some(base) = self.base_of(address) else { return self.store_overlapping(&AccessSet::Anything) };
        let start = i64::from(address.offset);
        self.store_overlapping(&AccessSet::Bytes(base, start..start + i64::from(width.bytes())))
    }

    /// Takes again what a write at an address may have changed.
    pub(super) fn take_touched_at(&mut self, address: Address, width: Width) {
        let touched = match self.base_of(address) {
            Some(base) => {
                let start = i64::from(address.offset);
                AccessSet::Bytes(base, start..start + i64::from(width.bytes()))
            }
            None => AccessSet::Anything,
        };
        self.take_overlapping(&touched);
    }

    /// Stores what an access to a place may touch.
    pub(super) fn store_touched(&mut self, place: Place) {
        let touched = self.touched(place);
        self.store_overlapping(&touched);
    }

    /// Takes again what a write to a place may have changed.
    pub(super) fn take_touched(&mut self, place: Place) {
        let touched = self.touched(place);
        self.take_overlapping(&touched);
    }

    /// Stores what an access to some of these bytes may touch.
    pub(super) fn store_promoted_in(&mut self, (base, bytes): &(Base, Range<i64>)) {
        self.store_overlapping(&AccessSet::Bytes(*base, bytes.clone()));
    }

    /// Whether an access to some of these bytes may touch what is kept in a register.
    pub(super) fn keeps_some_of(&self, (base, bytes): (Base, Range<i64>)) -> bool {
        let touched = AccessSet::Bytes(base, bytes);
        self.kept().iter().any(|it| it.overlaps(&touched))
    }

    /// Takes again what a write to some of these bytes may have changed.
    pub(super) fn take_promoted_in(&mut self, (base, bytes): &(Base, Range<i64>)) {
        self.take_overlapping(&AccessSet::Bytes(*base, bytes.clone()));
    }

    fn store_overlapping(&mut self, touched: &AccessSet) -> bool {
        let overlapping: Vec<_> = self.kept().into_iter().filter(|it| it.overlaps(touched)).collect();
        overlapping.iter().for_each(|&it| self.give_back(it));
        !overlapping.is_empty()
    }

    fn take_overlapping(&mut self, touched: &AccessSet) {
        self.kept().into_iter().filter(|it| it.overlaps(touched)).for_each(|it| self.take(it));
    }

    /// Stores all that is kept: somebody may look.
    pub(super) fn store_promoted(&mut self) {
        self.kept().into_iter().for_each(|it| self.give_back(it));
    }

    /// Takes all that is kept again: somebody may have changed it.
    pub(super) fn take_promoted(&mut self) {
        self.kept().into_iter().for_each(|it| self.take(it));
        self.take_kept_lengths();
    }

    /// Whether a register stands for memory at the running statement.
    pub(super) fn keeps_memory(&self) -> bool {
        self.promoted.iter().any(|it| it.is_in(self.statement) && it.base != Base::Run)
    }

    /// Whether something is kept here that is not kept at another statement.
    pub(super) fn leaves_loop(&self, to: u32) -> bool {
        self.promoted.iter().any(|it| it.is_in(self.statement) && !it.is_in(to))
    }

    /// Stores what is kept here and not at the statement that follows, but for what only this one hands on.
    pub(super) fn leave_loops(&mut self, to: u32) {
        self.kept().into_iter().filter(|it| !it.is_in(to) && it.handed.is_none()).for_each(|it| self.give_back(it));
    }

    /// The budget.
    pub(super) fn budget(&self) -> Variable {
        let kept = self.promoted.iter().find(|kept| kept.base == Base::Run);
        kept.expect("the budget is kept from the beginning of the function").variable
    }

    /// The budget, where it is stored.
    pub(super) fn load_budget(&mut self) -> Value {
        self.load_run(offset_of!(Run<'_, '_>, budget))
    }

    fn take(&mut self, promoted: Promoted) {
        let value = match promoted.base {
            Base::Run => {
                let budget = self.load_budget();
                if self.taken == 0 { budget } else { self.b.ins().iadd_imm_s(budget, self.taken) }
            }
            base => {
                let value = self.read(self.address(base, promoted.offset), promoted.width);
                if promoted.width == Width::QuadWord { self.word(value) } else { self.int(value) }
            }
        };
        self.b.def_var(promoted.variable, value);
        if let Some(variable) = promoted.real {
            let ty = if promoted.width == Width::QuadWord { F64 } else { F32 };
            let real = self.b.ins().bitcast(ty, MemFlagsData::new(), value);
            self.b.def_var(variable, real);
        }
    }

    fn give_back(&mut self, promoted: Promoted) {
        if !promoted.written {
            return;
        }
        if promoted.base == Base::Run && self.cold.is_none() {
            self.take_from_budget(self.taken);
        }
        let value = self.b.use_var(promoted.variable);
        match promoted.base {
            Base::Run => {
                let left = if self.taken == 0 { value } else { self.b.ins().iadd_imm_s(value, -self.taken) };
                self.b.ins().store(TRUSTED, left, self.run, promoted.offset);
            }
            base => {
                let value = if promoted.width == Width::QuadWord { Val::Word(value) } else { Val::Int(value) };
                let address = self.address(base, promoted.offset);
                if self.cold.is_none() {
                    // A piece around it has what was in memory before.
                    self.forget_bits_in(address, promoted.width);
                }
                self.write(address, promoted.width, value);
            }
        }
    }

    fn address(&self, base: Base, offset: i32) -> Address {
        Address { base: self.address_of_base(base), offset, bit: Bit::Number(0) }
    }
}
