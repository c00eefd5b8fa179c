//! Transfer functions of calls: the facts after a call.

use std::ops::Range;

use sieben_engine::access::pointed_area;
use sieben_engine::ir::{Inst, Op};
use sieben_engine::machine::{CALLS_SHIFT, Register};
use sieben_model::address::{Area, Width};

use super::access::of_each_element;
use super::{AbstractValue, Analysis, ByteRange, Element, Interval, State, interval};
use crate::translate::bounds_checks::FIRST_BYTE;
use crate::translate::mod_ref::{ArgumentSource, ModRef, POSITIONS, ParameterAccess, PointerAccess, WrittenText, own_local};
use crate::translate::scalar_promotion::Base;
use crate::translate::symbolic_summaries::SymbolicSummary;

/// Bytes that lie before a bit, if only in part.
fn bytes_before(bit: i64) -> i64 {
    bit.div_euclid(8) + i64::from(bit % 8 != 0)
}

/// Memory to which a pointer leads.
#[derive(Clone, Copy)]
struct Pointee {
    base: Base,
    /// Its first byte, and how many it has.
    start: i64,
    length: i64,
    /// Bits that a pointer counts there.
    positions: i64,
}

impl Pointee {
    /// The bytes to which pointers from one to another lead, with some bits behind them. `None` = a position may overflow, and what is
    /// carried may lead to another area or to another caller.
    fn reached(&self, (least, most): (i128, i128), bits: &Range<i64>) -> Option<Range<i64>> {
        let position = |pointer: i128| pointer as i64 & (self.positions - 1);
        let end = position(most) + bits.end;
        (end <= self.positions).then(|| self.start + (position(least) + bits.start) / 8..self.start + bytes_before(end))
    }

    /// Its base, for those of the bytes that lie behind a pointer.
    fn of_each_element(&self, pointer: &Interval, bits: &Range<i64>) -> Base {
        let first = bits.start.div_euclid(8);
        match u32::try_from(bytes_before(bits.end) - first) {
            Ok(bytes) if pointer.zeros >= 3 => of_each_element(self.base, pointer, self.start + first, bytes),
            _ => self.base,
        }
    }

    /// Those of some bytes that are there: what lies behind them cannot be written.
    fn there(&self, bytes: &Range<i64>) -> Range<i64> {
        bytes.start..bytes.end.min(self.start + self.length)
    }
}

impl Analysis<'_> {
    /// Follows a call; whether it cannot fail, because it is known what the block does that becomes part of this one. Variables that the
    /// called block may write are not known behind it, nor any if somebody may be asked in the middle of one of its statements.
    pub(super) fn call(&mut self, index: u32, inst: &Inst, state: &mut State, passed: &mut Vec<AbstractValue>, notes: bool) -> bool {
        let Inst::Call { parameters, .. } = *inst else { return false };
        let given = passed.split_off(passed.len().saturating_sub(usize::from(parameters)));
        let ar2 = state.registers.get(&(Register::Ar2 as u8)).copied();
        if notes && let Some(ar2) = ar2 {
            self.found.instances.insert(index, self.really(ar2.range));
        }
        if notes {
            self.found.at_calls.insert(index, state.facts());
        }
        for variable in std::mem::take(&mut self.given_variables) {
            state.variables.remove(&variable);
        }
        let around = self.around;
        let effects = (around.called)(inst).and_then(|code| around.effects[code].as_ref());
        let elements = effects.and_then(|effects| self.forget_effects(effects, state, &given, ar2, notes.then_some(index)));
        let kept = elements.is_some();
        if !kept {
            state.forget_memory();
        }
        state.elements.clear();
        if let Some(elements) = elements.filter(|elements| notes && !elements.is_empty()) {
            self.found.elements.insert(index, elements);
        }
        let written = (self.around.written)(inst);
        state.registers.retain(|&register, _| written & (1 << register) == 0);
        if notes && kept {
            self.found.kept.insert(index);
            self.found.over_calls.insert(index, state.facts());
        }
        kept
    }

    /// What AR2 really holds where it is said to hold something.
    pub(super) fn really(&self, said: Interval) -> Interval {
        match self.around.relative {
            Some(relative) => {
                let distance = interval::result(Op::SubU32, [said, Interval::constant(FIRST_BYTE), said]);
                interval::result(Op::AddU32, [relative.real, distance, said])
            }
            None => said,
        }
    }

    /// Whether a statement calls a block that reads pointers in its instance.
    pub(super) fn passes_elements(&self, insts: &[Inst]) -> bool {
        let reads_pointers = |effects: &ModRef| {
            let pointers = effects.pointed.iter().map(|pointed| pointed.pointer);
            { pointers }.chain(effects.texts.iter().map(|text| text.pointer)).any(|pointer| matches!(pointer, ArgumentSource::Instance(_)))
        };
        insts.iter().any(|inst| {
            let called = if matches!(inst, Inst::Call { .. }) { (self.around.called)(inst) } else { None };
            called.and_then(|code| self.around.effects[code].as_ref()).is_some_and(reads_pointers)
        })
    }

    /// Forgets what a called block may write; `None` = it may be anything. What is known of the pointers in its instance by which it does.
    fn forget_effects(
        &mut self,
        effects: &ModRef,
        state: &mut State,
        given: &[AbstractValue],
        ar2: Option<AbstractValue>,
        notes: Option<u32>,
    ) -> Option<Vec<(u32, Width, Interval)>> {
        let own = match &effects.alone {
            Some(alone) => self.bytes_alone(alone, state, ar2)?,
            None => Vec::new(),
        };
        let mut before: Vec<(ArgumentSource, Width, AbstractValue)> = Vec::new();
        let texts = effects.texts.iter().flat_map(WrittenText::sources);
        for (source, width) in effects.pointed.iter().flat_map(PointerAccess::sources).chain(texts) {
            before.push((source, width, self.source(state, (source, width), given, ar2)?));
        }
        if let Some(touched) = &effects.instance {
            let (base, bytes) = self.part_of_instance(state, touched, ar2?.range)?;
            // A block does not write to the pointers that it reads.
            let elements = std::mem::take(&mut state.elements);
            state.forget(base, &bytes);
            state.elements = elements;
        }
        for &area in &effects.areas {
            let range = self.around.layout.area(area)?;
            state.forget(Base::Arena, &(range.start as i64..range.end as i64));
        }
        for number in effects.blocks.iter().filter(|&&number| number != 0) {
            let range = self.around.layout.data_blocks.get(number)?;
            state.forget(Base::Arena, &(range.start as i64..range.end as i64));
        }
        let opens = !effects.pointed.is_empty();
        for access in &effects.given {
            let bytes = self.forget_given(access, state, given, opens)?;
            if effects.alone.is_some() && bytes.is_some_and(|(base, _)| base != Base::Local) {
                return None;
            }
        }
        let of = |source: ArgumentSource| before.iter().find(|(other, ..)| *other == source).map(|&(.., known)| known.range);
        for access in &effects.pointed {
            let number = access.number.map(|number| of(number)?.exact());
            let (base, bytes) = self.forget_pointed(access, state, (number.flatten(), of(access.pointer)?), &own)?;
            if let Some(index) = notes {
                self.found.by_pointers.entry(index).or_default().push(((base, bytes), access.writes));
            }
        }
        for text in &effects.texts {
            self.forget_text(text, state, of(text.number)?.exact()?, of(text.pointer)?)?;
        }
        // By none of them it may write to the pointers.
        let mut elements = Vec::new();
        for (source, width, known) in before {
            let now = self.source(state, (source, width), given, ar2)?;
            if now.number != known.number {
                return None;
            }
            let ArgumentSource::Instance(offset) = source else { continue };
            if !elements.contains(&(offset, width, known.range)) {
                elements.push((offset, width, known.range));
            }
        }
        Some(elements)
    }

    /// The bytes of some bits of the instance data block, from where AR2 points: all of that if they may be others.
    fn part_of_instance(&self, state: &State, bits: &Range<i64>, ar2: Interval) -> Option<ByteRange> {
        let (base, start, length, _) = self.area(state, Area::InstanceData)?;
        let (least, most) = ar2.unsigned(24);
        let (first, end) = (least as i64 + bits.start, most as i64 + bits.end);
        let (part_of, first_byte, limit) = match self.around.relative {
            Some(it) => (Base::Computed(it.instance), it.first, 8 * it.bytes),
            None => (base, start, POSITIONS),
        };
        // A position may overflow.
        let anywhere = first < 0 || end > limit;
        Some(if anywhere { (base, start..start + length) } else { (part_of, first_byte + first / 8..first_byte + bytes_before(end)) })
    }

    /// What is known of a number that a called block reads.
    fn source(
        &self,
        state: &State,
        (source, width): (ArgumentSource, Width),
        given: &[AbstractValue],
        ar2: Option<AbstractValue>,
    ) -> Option<AbstractValue> {
        match source {
            ArgumentSource::Instance(offset) => {
                let (base, start, length, _) = self.area(state, Area::InstanceData)?;
                let block = (base, start..start + length);
                let (counted_from, added) = self.counted_from(ar2?);
                let is_it = |element: &&Element| {
                    element.block == block && element.width == width && element.behind(counted_from) == Some(offset.wrapping_add(added))
                };
                let pointer = ar2?.range;
                let end = pointer.unsigned(24).1 as i64 + i64::from(offset) + i64::from(width.bits());
                let inside = pointer.zeros >= 3 && offset % 8 == 0 && end <= 8 * length;
                state.elements.iter().find(is_it).filter(|_| inside).map(|element| element.known)
            }
            ArgumentSource::Given(parameter, offset) => {
                let pointer = given.get(usize::from(parameter))?.range.exact()?;
                let position = i64::from(own_local(pointer)?) + i64::from(offset);
                let (first, bytes) = self.around.local;
                let inside = position % 8 == 0 && position / 8 + i64::from(width.bytes()) <= i64::from(bytes);
                let offset = i32::try_from(i64::from(first) + position / 8).ok()?;
                state.variables.get(&(Base::Local, offset, width)).filter(|_| inside).copied()
            }
        }
    }

    /// The bytes in the arena that a block looks at which was looked at alone, beside those to which pointers lead; `None` = it is not as
    /// if it were alone.
    fn bytes_alone(&self, alone: &SymbolicSummary, state: &State, ar2: Option<AbstractValue>) -> Option<Vec<ByteRange>> {
        let mut all = Vec::new();
        if !alone.instance.is_empty() {
            let (base, start, length, _) = self.area(state, Area::InstanceData)?;
            let (base, start, length) = match self.around.relative {
                Some(it) => (Base::Computed(it.instance), it.first, it.bytes),
                None => (base, start, length),
            };
            let number = state.registers.get(&(Register::DiNumber as u8)).and_then(|known| known.range.exact())?;
            let pointer = ar2?.range;
            let (least, most) = pointer.unsigned(24);
            let (first, end) = (least as i64 + alone.instance.start, most as i64 + alone.instance.end);
            let inside = pointer.zeros >= 3 && first >= 0 && bytes_before(end) <= length;
            if !inside || alone.blocks.iter().any(|&block| u64::from(block) == number) {
                return None;
            }
            all.push((base, start + first / 8..start + bytes_before(end)));
        }
        for &area in &alone.areas {
            let range = self.around.layout.area(area)?;
            all.push((Base::Arena, range.start as i64..range.end as i64));
        }
        for number in alone.blocks.iter().filter(|&&number| number != 0) {
            let range = self.around.layout.data_blocks.get(number)?;
            all.push((Base::Arena, range.start as i64..range.end as i64));
        }
        Some(all)
    }

    /// Forgets what a called block may write by a pointer that it reads; the bytes that it may reach. `None` = it may write what its own
    /// addresses depend on, or anything.
    fn forget_pointed(
        &mut self,
        access: &PointerAccess,
        state: &mut State,
        (number, pointer): (Option<u64>, Interval),
        own: &[ByteRange],
    ) -> Option<ByteRange> {
        let pointee = self.pointee(number, pointer, access.writes)?;
        let bytes = pointee.reached(pointer.unsigned(64), &access.bits)?;
        let there = pointee.there(&bytes);
        let pointee = Pointee { base: pointee.of_each_element(&pointer, &access.bits), ..pointee };
        if access.writes && own.iter().any(|&(base, ref other)| pointee.base.may_share(&there, base, other)) {
            return None;
        }
        if access.writes {
            state.forget(pointee.base, &there);
        }
        Some((pointee.base, bytes))
    }

    /// Forgets a text that a called block may write by a pointer that it reads.
    fn forget_text(&mut self, text: &WrittenText, state: &mut State, number: u64, pointer: Interval) -> Option<()> {
        let pointee = self.pointee(Some(number), pointer, true)?;
        let bits = i64::from(text.offset)..i64::from(text.offset) + 8 * i64::from(text.bytes);
        let bytes = pointee.reached(pointer.unsigned(64), &bits)?;
        state.forget(pointee.base, &pointee.there(&bytes));
        Some(())
    }

    /// Where a pointer leads that a called block reads.
    fn pointee(&mut self, number: Option<u64>, pointer: Interval, writes: bool) -> Option<Pointee> {
        let (least, most) = pointer.unsigned(64);
        if least >> 24 != most >> 24 || least >> 32 != 0 {
            return None;
        }
        let range = match pointed_area(least as u64, writes).ok()? {
            Area::SharedData => {
                let number = u16::try_from(number?).ok().filter(|&number| number != 0)?;
                let range = self.around.layout.data_blocks.get(&number)?.clone();
                self.found.opened.insert(number);
                range
            }
            Area::CallerLocal => return self.local_behind(least, most),
            area @ (Area::Input | Area::Output | Area::BitMemory) => self.around.layout.area(area)?,
            _ => return None,
        };
        Some(Pointee { base: Base::Arena, start: range.start as i64, length: range.len() as i64, positions: POSITIONS })
    }

    /// The local data of this block, or of a caller that is in the same function, to which pointers of a called block lead.
    fn local_behind(&self, least: i128, most: i128) -> Option<Pointee> {
        let calls = |pointer: i128| (pointer & (POSITIONS - 1) as i128) >> CALLS_SHIFT;
        let (start, length) = match calls(least) {
            further if further != calls(most) => return None,
            0 => (self.around.local.0, self.around.local.1 as usize),
            further => (self.around.callers)(further as usize - 1)?,
        };
        Some(Pointee { base: Base::Local, start: i64::from(start), length: length as i64, positions: 1 << CALLS_SHIFT })
    }

    /// Forgets what a called block may write by a pointer that it was given; the bytes.
    fn forget_given(&self, access: &ParameterAccess, state: &mut State, given: &[AbstractValue], opens: bool) -> Option<Option<ByteRange>> {
        let (least, most) = given.get(usize::from(access.parameter)).map_or((0, 0), |known| known.range.unsigned(64));
        if least >> 24 != most >> 24 {
            return None;
        }
        let area = pointed_area(least as u64, access.writes).ok()?;
        match area {
            Area::PeripheralInput | Area::PeripheralOutput => return None,
            // Counted from the data block that is open then.
            Area::SharedData if opens => return None,
            _ if !access.writes => return Some(None),
            _ => {}
        }
        let pointee = match area {
            Area::CallerLocal => self.local_behind(least, most)?,
            _ => {
                let (base, start, length, _) = self.area(state, area)?;
                Pointee { base, start, length, positions: POSITIONS }
            }
        };
        let first = i64::from(access.offset);
        let bytes = pointee.reached((least, most), &(first..first + i64::from(access.width.bits())))?;
        state.forget(pointee.base, &bytes);
        Some(Some((pointee.base, bytes)))
    }
}
