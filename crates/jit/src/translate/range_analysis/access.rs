//! Transfer functions of accesses: what an access to memory reaches, and the facts after it.

use std::collections::BTreeMap;
use std::ops::Range;

use sieben_engine::access::{data_registers, pointed_area};
use sieben_engine::ir::{DataRegister, OnFault, Op, Place, TextRoom, Var};
use sieben_engine::machine::CALLS_SHIFT;
use sieben_model::address::{Area, Width};

use super::interval::{self, Interval};
use super::{AbstractValue, Analysis, ByteRange, Element, Origin, Reach, Span, State, StringPlace, ValueNumber};
use crate::translate::congruence::StridedBytes;
use crate::translate::inlining::way_into;
use crate::translate::memory::moved;
use crate::translate::scalar_promotion::Base;
use crate::translate::strings::NUMBER_SHIFT;

/// Constants that one after the other are added to a pointer, and that are followed.
const SUMS_MAX: usize = 4;

/// The base of some bytes to which a position behind the start of an area goes: the same ones of each element of an array, if it goes there.
pub(super) fn of_each_element(base: Base, position: &Interval, start: i64, bytes: u32) -> Base {
    let begin = position.distances_unsigned(24).in_bytes().moved(start);
    if base == Base::Arena && begin.is_wider_than(bytes.into()) { Base::Spaced(StridedBytes { begin, bytes }) } else { base }
}

impl Analysis<'_> {
    /// What an access to a place reaches.
    pub(super) fn reach(
        &mut self,
        state: &State,
        temporaries: &BTreeMap<u8, AbstractValue>,
        place: Place,
        span: Span,
        write: bool,
        notes: Option<(u32, bool)>,
    ) -> Reach {
        let (area, position) = match place {
            Place::Fixed { area, position } => (area, Interval::constant(u64::from(position))),
            Place::Indirect { area, pointer, offset } => (area, self.moved(state, temporaries, pointer, offset)),
            Place::Crossing { pointer, offset } => {
                // The area is known if all that the pointer may be is in one.
                let (least, most) = self.get(state, temporaries, pointer).range.unsigned(64);
                if least == most
                    && pointed_area(least as u64, write) == Ok(Area::CallerLocal)
                    && let Some(byte) = self.in_caller(moved(least as u64, offset), span)
                {
                    if let Some((index, _)) = notes {
                        self.found.pointed.insert(index, (Base::Local, byte));
                    }
                    return Reach::Variable(Base::Local, byte);
                }
                if let (true, Span::Bytes(bytes), 1..) = (least >> 24 == most >> 24, span, least >> 32) {
                    // The number of the data block is no part of the sum.
                    let own = self.get(state, temporaries, pointer).range.without_number();
                    let position = interval::result(Op::AddU32, [own, Interval::constant(u64::from(offset)), own]);
                    let Some(reach) = self.far_bytes(least as u64, position, bytes, write) else { return Reach::Anything };
                    if let Some(role) = notes {
                        self.found.named_blocks.insert(role, (least as u64 >> NUMBER_SHIFT) as u16);
                    }
                    return reach;
                }
                let far = least >> 32 != 0 && matches!(span, Span::Bytes(_));
                if !far && least >> 24 == most >> 24 && pointed_area(least as u64, write) == Ok(Area::CallerLocal) {
                    let position = self.moved(state, temporaries, pointer, offset);
                    let Some(bytes) = self.inside_caller(position, span) else { return Reach::Anything };
                    if let Some(role) = notes {
                        self.found.areas.insert(role, Area::CallerLocal);
                    }
                    return Reach::Inside(Base::Local, bytes);
                }
                match pointed_area(least as u64, write) {
                    Ok(area) if least >> 24 == most >> 24 && !far && area != Area::CallerLocal => {
                        if let Some(role) = notes
                            && least != most
                        {
                            self.found.areas.insert(role, area);
                        }
                        (area, self.moved(state, temporaries, pointer, offset))
                    }
                    _ => return Reach::Anything,
                }
            }
        };
        let Some((base, start, length, protected)) = self.area(state, area) else { return Reach::Anything };
        let whole = Reach::Bytes(base, start..start + length);
        let (base, start, length, protected) = match (place, self.around.relative) {
            (Place::Indirect { area: Area::InstanceData, .. }, Some(it)) => (Base::Computed(it.instance), it.first, it.bytes, it.protected),
            _ => (base, start, length, protected),
        };
        let (least, most) = position.unsigned(24);
        let (first, end) = ((least / 8) as i64, (most / 8) as i64 + i64::from(span.bytes()));
        let aligned = span == Span::Width(Width::Bit) || position.zeros >= 3 || position.exact().is_some_and(|position| position % 8 == 0);
        if !aligned || end > length || write && protected {
            return whole;
        }
        match i32::try_from(start + first) {
            Ok(offset) if least == most => {
                let is_computed = match place {
                    Place::Crossing { .. } => true,
                    Place::Indirect { pointer, .. } => pointer.register().is_none(),
                    Place::Fixed { .. } => false,
                };
                if let Some((index, _)) = notes.filter(|_| is_computed) {
                    self.found.pointed.insert(index, (base, offset));
                }
                Reach::Variable(base, offset)
            }
            _ => Reach::Inside(of_each_element(base, &position, start, span.bytes()), start + first..start + end),
        }
    }

    /// Where a pointer to the local data of a caller goes, if that caller is in the same function and all bytes are there.
    fn in_caller(&self, position: u32, span: Span) -> Option<i32> {
        match span {
            Span::Width(width) => self.byte_in_caller(position, width),
            Span::Bytes(bytes) => {
                let distance = bytes.checked_sub(1)?;
                let first = self.byte_in_caller(position, Width::Byte)?;
                let last = self.byte_in_caller(position.checked_add(8 * distance)?, Width::Byte)?;
                (i64::from(last) - i64::from(first) == i64::from(distance)).then_some(first)
            }
        }
    }

    pub(super) fn byte_in_caller(&self, position: u32, width: Width) -> Option<i32> {
        let caller = (self.around.callers)((position >> CALLS_SHIFT) as usize)?;
        way_into(position, width, caller).map(|(byte, _)| byte)
    }

    /// The bytes to which pointers to the local data of a caller go, if that caller is in the same function and all of them are there.
    fn inside_caller(&self, position: Interval, span: Span) -> Option<Range<i64>> {
        let (least, most) = position.unsigned(24);
        if span != Span::Width(Width::Bit) && position.zeros < 3 {
            return None;
        }
        let (least, most) = (u32::try_from(least).ok()? & !7, u32::try_from(most).ok()? & !7);
        let last = most.checked_add(8 * span.bytes().checked_sub(1)?)?;
        let [first, end] = [least, last].map(|position| self.byte_in_caller(position, Width::Byte).map(i64::from));
        let (first, end) = (first?, end? + 1);
        (end - first == i64::from((last - least) / 8) + 1).then_some(first..end)
    }

    /// Bytes of the data block that a pointer names.
    fn far_bytes(&mut self, pointer: u64, position: Interval, bytes: u32, write: bool) -> Option<Reach> {
        let range = self.far_block(pointer, write)?;
        let (least, most) = position.unsigned(24);
        let first = range.start as i64 + (least / 8) as i64;
        let end = range.start as i64 + (most / 8) as i64 + i64::from(bytes);
        let aligned = position.zeros >= 3 || position.exact().is_some_and(|position| position % 8 == 0);
        if !aligned || end > range.end as i64 {
            return None;
        }
        let offset = i32::try_from(first).ok()?;
        let bytes_of_each = || of_each_element(Base::Arena, &position, range.start as i64, bytes);
        Some(if least == most { Reach::Variable(Base::Arena, offset) } else { Reach::Inside(bytes_of_each(), first..end) })
    }

    /// Where the data block lies that a pointer names, which is taken to be as it was loaded.
    fn far_block(&mut self, pointer: u64, write: bool) -> Option<Range<usize>> {
        let number = (pointer >> NUMBER_SHIFT & 0xFFFF) as u16;
        if number == 0 || pointed_area(pointer, write) != Ok(Area::SharedData) || write && self.around.layout.read_only.contains(&number) {
            return None;
        }
        let range = self.around.layout.data_blocks.get(&number)?.clone();
        self.found.opened.insert(number);
        Some(range)
    }

    /// The bytes of a text that begins inside its area. One that says itself how long it is has as many as the area has, at most.
    pub(super) fn text(
        &mut self,
        state: &State,
        temporaries: &BTreeMap<u8, AbstractValue>,
        (place, room): (Place, TextRoom),
        write: bool,
    ) -> Option<StringPlace> {
        let block = match place {
            Place::Crossing { pointer, .. } => {
                let (least, most) = self.get(state, temporaries, pointer).range.unsigned(64);
                if least >> 24 == most >> 24 { self.far_block(least as u64, write) } else { None }
            }
            _ => None,
        };
        if room.is_unknown() && room.wide {
            return None;
        }
        let begins = block.is_some() || !room.is_unknown();
        let mut begin = |there: u32| match self.reach(state, temporaries, place, Span::Bytes(there), write, None) {
            Reach::Inside(..) if !begins => None,
            reach => reach.bytes(there).map(|(base, bytes)| (base.area(), bytes)),
        };
        let (mut there, mut most) = (if room.is_unknown() { room.head() } else { room.bytes() }, room.bytes());
        let mut bytes = begin(there)?;
        while there < most {
            let middle = (there + most).div_ceil(2);
            match begin(middle) {
                Some(found) => (there, bytes) = (middle, found),
                None => most = middle - 1,
            }
        }
        match self.said_room(state, &bytes, there).filter(|_| room.is_unknown()) {
            Some(room) => {
                bytes.1.end = bytes.1.start + i64::from(room.bytes());
                Some(StringPlace { bytes, there: room.bytes(), block, room })
            }
            None => Some(StringPlace { bytes, there, block, room }),
        }
    }

    /// What a STRING says that it has room for, if its first byte is known and so many characters are there.
    pub(super) fn said_room(&self, state: &State, (base, bytes): &ByteRange, there: u32) -> Option<TextRoom> {
        let offset = i32::try_from(bytes.start).ok().filter(|_| bytes.end - bytes.start == i64::from(there))?;
        let exact = |width: Width| state.variables.get(&(*base, offset, width))?.range.exact();
        let most = exact(Width::Byte).or_else(|| Some(exact(Width::Word)? >> 8))?;
        let room = TextRoom::narrow(u8::try_from(most).ok().filter(|&most| most > 0)?);
        (room.bytes() <= there).then_some(room)
    }

    /// A pointer moved by an offset.
    pub(super) fn moved(&mut self, state: &State, temporaries: &BTreeMap<u8, AbstractValue>, pointer: Var, offset: u32) -> Interval {
        let pointer = self.get(state, temporaries, pointer).range;
        interval::result(Op::AddU32, [pointer, Interval::constant(u64::from(offset)), pointer])
    }

    /// Base, first byte and length of an area, and whether it may not be written.
    pub(super) fn area(&self, state: &State, area: Area) -> Option<(Base, i64, i64, bool)> {
        let register = match area {
            Area::SharedData => DataRegister::Shared,
            Area::InstanceData => DataRegister::Instance,
            Area::Local => {
                let (start, length) = self.around.local;
                return Some((Base::Local, i64::from(start), i64::from(length), false));
            }
            _ => {
                let range = self.around.layout.area(area)?;
                return Some((Base::Arena, range.start as i64, range.len() as i64, false));
            }
        };
        let [number, base, length] =
            data_registers(register).map(|register| state.registers.get(&(register as u8)).and_then(|known| known.range.exact()));
        let protected = match number {
            Some(number) => self.around.layout.read_only.iter().any(|&protected| u64::from(protected) == number),
            None => self.around.asks_before_writing,
        };
        Some((Base::Arena, base? as i64, length? as i64, protected))
    }

    pub(super) fn load(
        &mut self,
        state: &mut State,
        temporaries: &BTreeMap<u8, AbstractValue>,
        (place, width): (Place, Width),
        on_fault: OnFault,
        fails: &mut bool,
        notes: Option<u32>,
    ) -> AbstractValue {
        let any = if width == Width::Bit { Interval { most: 1, ..Interval::any(8) } } else { Interval::any(width.bits()) };
        let role = notes.map(|index| (index, false));
        match self.reach(state, temporaries, place, Span::Width(width), on_fault == OnFault::SkipWrite, role) {
            Reach::Variable(base, offset) => {
                let variable = (base, offset, width);
                if let Some(known) = state.variables.get(&variable) {
                    return *known;
                }
                let known = self.value(any);
                // The same variable again is the same value.
                if width != Width::Bit && self.relevant.contains(&place) {
                    state.variables.insert(variable, known);
                }
                return known;
            }
            Reach::Inside(base, range) => {
                if let Some(index) = notes {
                    self.found.inside.insert(index, (base, range));
                }
            }
            Reach::Bytes(..) => *fails = true,
            Reach::Anything => {
                *fails = true;
                // Somebody may be asked in the middle of the statement.
                state.forget_memory();
            }
        }
        if *fails && on_fault == OnFault::DeliverZero {
            state.forget_memory();
        }
        self.value(any)
    }

    /// What is known of the instance of a block that the statement calls, if a store writes there.
    fn element(
        &mut self,
        state: &State,
        pointer: AbstractValue,
        (place, width): (Place, Width),
        reach: &Reach,
        value: AbstractValue,
    ) -> Option<Element> {
        let Place::Indirect { area: Area::InstanceData, offset, .. } = place else { return None };
        let fits = value.range.bits <= width.bits() || value.range.exact().is_some_and(|value| value < 1 << width.bits());
        if !self.passes_elements || !matches!(width, Width::Word | Width::DoubleWord) || !fits {
            return None;
        }
        let bytes = reach.bytes(width.bytes())?;
        let (base, start, length, _) = self.area(state, Area::InstanceData)?;
        let (pointer, added) = self.counted_from(pointer);
        let offset = offset.wrapping_add(added);
        Some(Element { block: (base, start..start + length), pointer, offset, width, bytes, known: value })
    }

    /// What a pointer is counted from, and how many bits are added to that.
    pub(super) fn counted_from(&self, pointer: AbstractValue) -> (ValueNumber, u32) {
        let (mut pointer, mut added) = (pointer, 0_u32);
        for _ in 0..SUMS_MAX {
            match self.origins[pointer.number as usize] {
                Origin::Sum(32, of, constant) if pointer.range.exact().is_none() && of.range.bits <= 32 => {
                    (pointer, added) = (of, added.wrapping_add(constant as u32));
                }
                _ => break,
            }
        }
        (ValueNumber::of(pointer), added)
    }

    pub(super) fn store(
        &mut self,
        state: &mut State,
        reach: Reach,
        (place, width): (Place, Width),
        [pointer, value]: [AbstractValue; 2],
        fails: &mut bool,
        notes: Option<u32>,
    ) {
        let element = self.element(state, pointer, (place, width), &reach, value);
        let before = std::mem::take(&mut state.elements);
        let is_apart = |other: &Element| element.as_ref().is_some_and(|new| new.is_apart_from(other));
        let (apart, others) = before.into_iter().partition(is_apart);
        state.elements = others;
        self.store_at(state, reach, (place, width), value, fails, notes);
        state.elements.extend::<Vec<Element>>(apart);
        state.elements.extend(element);
    }

    fn store_at(
        &mut self,
        state: &mut State,
        reach: Reach,
        (place, width): (Place, Width),
        value: AbstractValue,
        fails: &mut bool,
        notes: Option<u32>,
    ) {
        match reach {
            Reach::Variable(base, offset) => {
                let start = i64::from(offset);
                state.forget(base, &(start..start + i64::from(width.bytes())));
                if width != Width::Bit && self.relevant.contains(&place) {
                    let bits = width.bits();
                    let range = if value.range.bits <= bits {
                        // Memory has no form of its own: what is read again has all bits of the variable.
                        value.range
                    } else {
                        match bits {
                            8 => interval::result(Op::Low8, [value.range; 3]),
                            16 => interval::result(Op::Low16, [value.range; 3]),
                            _ => interval::result(Op::Low32, [value.range; 3]),
                        }
                    };
                    let range = range.near_zero();
                    let stored = if range == value.range { value } else { self.value(range) };
                    state.variables.insert((base, offset, width), stored);
                    if self.given.contains(&place) {
                        self.given_variables.push((base, offset, width));
                    }
                }
            }
            Reach::Inside(base, range) => {
                if let Some(index) = notes {
                    self.found.inside.insert(index, (base, range.clone()));
                }
                state.forget(base, &range);
            }
            Reach::Bytes(base, range) => {
                *fails = true;
                state.forget(base, &range);
            }
            Reach::Anything => {
                *fails = true;
                state.forget_memory();
            }
        }
    }

    /// Opens a data block; whether that is one which the program has: machine code takes it to be there.
    pub(super) fn open(&mut self, state: &mut State, register: DataRegister, number: Option<u64>) -> bool {
        let range = match number.map(|number| number & 0xFFFF) {
            Some(0) => Some((0, 0..0)),
            Some(number) => {
                let known = u16::try_from(number).ok().and_then(|number| self.around.layout.data_blocks.get(&number));
                known.map(|range| (number, range.clone()))
            }
            None => None,
        };
        self.found.opened.extend(range.iter().map(|&(number, _)| number as u16));
        let registers = data_registers(register).map(|register| register as u8);
        for (at, register) in registers.into_iter().enumerate() {
            state.registers.remove(&register);
            if let Some((number, range)) = &range {
                let value = [*number, range.start as u64, range.len() as u64][at];
                let known = self.value(Interval::constant(value));
                state.registers.insert(register, known);
            }
        }
        range.is_some()
    }
}
