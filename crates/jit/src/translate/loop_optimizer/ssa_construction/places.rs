//! Operands of instructions: variables at constant addresses, others at addresses that an iteration computes, and the areas in which they
//! are.

use sieben_engine::access::{data_registers, pointed_area};
use sieben_engine::ir::{DataRegister, Op, Place};
use sieben_engine::machine::CALLS_SHIFT;
use sieben_model::address::{Area, Width};

use super::super::super::inlining::way_into;
use super::super::super::memory::moved;
use super::super::super::range_analysis::ByteRange;
use super::super::super::scalar_promotion::Base;
use super::super::kernel::{Access, Definition, Node, PointedPart, Slot, SlotKind};
use super::{DEPTH_MAX, SsaBuilder};

/// Where a place goes.
pub(in super::super) enum Goes {
    /// Into an area: where that begins, and how many bytes it has.
    To { area: (Base, i32, u64), pointer: Node, offset: u32 },
    /// Into the local data of a caller.
    ToCaller { position: u32 },
}

/// What an instruction reaches.
pub(in super::super) enum Reached {
    Slot(Slot),
    Access(Access),
}

impl SsaBuilder<'_, '_> {
    /// The area to which a place goes, and where in it.
    pub(in super::super) fn goes_to(&mut self, place: Place, write: bool) -> Option<Goes> {
        let (area, pointer, offset) = match place {
            Place::Fixed { area, position } => (area, self.constant(0), position),
            Place::Indirect { area, pointer, offset } => (area, self.get(pointer)?, offset),
            Place::Crossing { pointer, offset } => {
                let pointer = self.get(pointer)?;
                let (least, most) = self.range(pointer, DEPTH_MAX).unsigned(32);
                if least >> 24 != most >> 24 {
                    return None;
                }
                match pointed_area(least as u64, write).ok()? {
                    Area::CallerLocal => match self.kernel.constant(pointer) {
                        Some(constant) => return Some(Goes::ToCaller { position: moved(constant, offset) }),
                        None => (Area::CallerLocal, pointer, offset),
                    },
                    Area::PeripheralInput | Area::PeripheralOutput => return None,
                    area => (area, pointer, offset),
                }
            }
        };
        let (mut start, mut length) = match area {
            // Of others than the caller itself, positions are greater.
            Area::CallerLocal => self.caller_local(0).map(|(first, bytes)| (first, bytes as u64))?,
            _ => self.area(area, write)?,
        };
        let mut base = if matches!(area, Area::Local | Area::CallerLocal) { Base::Local } else { Base::Arena };
        if let Place::Indirect { area: Area::InstanceData, .. } = place
            && self.translator.ranges.is_relative()
        {
            let (instance, first, bytes) = self.translator.instance_area()?;
            (base, start, length) = (instance, first, bytes);
        }
        Some(Goes::To { area: (base, start, length), pointer, offset })
    }

    /// What is reached at a place, which is known to lie among some bytes wherever it is reached, perhaps.
    pub(in super::super) fn reach(&mut self, (place, width): (Place, Width), inside: Option<ByteRange>, write: bool) -> Option<Reached> {
        let ((base, start, length), pointer, offset) = match self.goes_to(place, write)? {
            Goes::To { area, pointer, offset } => (area, pointer, offset),
            Goes::ToCaller { position } => return self.in_caller(position, width),
        };
        if let Some(pointer) = self.kernel.constant(pointer) {
            let position = moved(pointer, offset);
            let (byte, bit) = (u64::from(position / 8), (position % 8) as u8);
            if byte + u64::from(width.bytes()) > length || width != Width::Bit && bit != 0 {
                return None;
            }
            let offset = i32::try_from(i64::from(start) + byte as i64).ok()?;
            return Some(Reached::Slot(self.slot(SlotKind::Memory { base, offset, width, bit })));
        }
        let (pointer, offset) = self.without_constants(pointer, offset);
        let area = (base, start, length);
        let always = self.always_inside(area, pointer, offset, width);
        let inside = match inside {
            _ if always.is_some() => always.clone(),
            Some((known, range)) if known == base && i64::from(start) <= range.start && range.end <= i64::from(start) + length as i64 => {
                Some(range)
            }
            _ => None,
        };
        let sure = always.is_some() || self.ways.is_always() && inside.is_some();
        let part = if always.is_some() { self.part_behind(pointer, offset) } else { None };
        let around = if always.is_some() { self.around((pointer, offset), width) } else { Vec::new() };
        let access = Access { level: self.level, area, pointer, offset, width, value: None, inside, sure, part, around };
        Some(match self.element_at(&access) {
            Some(slot) => Reached::Slot(slot),
            None => Reached::Access(access),
        })
    }

    /// Where a variable lies behind the byte to which a pointer goes, if the pointer goes to one in each iteration.
    pub(in super::super) fn part_behind(&self, pointer: Node, offset: u32) -> Option<PointedPart> {
        let whole = self.range(pointer, DEPTH_MAX);
        // An element may lie before where the pointer goes: positions have 24 bits.
        let (least, most) = whole.unsigned(24);
        let signed = (offset << 8) as i32 >> 8;
        let is_part = whole.zeros >= 3 && least + i128::from(signed) >= 0 && most + i128::from(signed) < 1 << 24;
        is_part.then_some(PointedPart { bytes: signed >> 3, bit: (offset % 8) as u8 })
    }

    /// A pointer and an offset of 24 bits that lead to the same place as others: accesses at the same distance from each other in each
    /// iteration have the same pointer.
    pub(in super::super) fn without_constants(&mut self, mut pointer: Node, mut offset: u32) -> (Node, u32) {
        if self.whole_copies {
            let (pointer, constant) = self.apart_from_constant(pointer, DEPTH_MAX);
            return (pointer, offset.wrapping_add(constant) & 0x00FF_FFFF);
        }
        while let Definition::Compute(op @ (Op::AddU32 | Op::SubU32), [a, b, ..]) = self.kernel.what(pointer) {
            let [x, y] = [a, b].map(|node| self.kernel.constant(node).map(|constant| constant as u32));
            (pointer, offset) = match (op, x, y) {
                (Op::AddU32, Some(constant), _) => (b, offset.wrapping_add(constant)),
                (Op::AddU32, None, Some(constant)) => (a, offset.wrapping_add(constant)),
                (Op::SubU32, _, Some(constant)) => (a, offset.wrapping_sub(constant)),
                _ => break,
            };
        }
        (pointer, offset & 0x00FF_FFFF)
    }

    /// A number of 32 bits as a sum of another one and of a constant, which is taken out of products, too.
    fn apart_from_constant(&mut self, node: Node, depth: usize) -> (Node, u32) {
        let Definition::Compute(op, [a, b, ..]) = self.kernel.what(node) else {
            return match self.kernel.constant(node) {
                Some(constant) => (self.constant(0), constant as u32),
                None => (node, 0),
            };
        };
        if depth == 0 || !matches!(op, Op::AddU32 | Op::SubU32 | Op::MulU32 | Op::Shl32) {
            return (node, 0);
        }
        let (own, constant) = self.apart_from_constant(a, depth - 1);
        let (other, constant) = match (op, self.kernel.constant(b).map(|factor| factor as u32)) {
            (Op::MulU32, Some(factor)) => (b, constant.wrapping_mul(factor)),
            (Op::Shl32, Some(count)) if count < 32 => (b, constant << count),
            (Op::AddU32 | Op::SubU32, _) => {
                let (other, more) = self.apart_from_constant(b, depth - 1);
                (other, if op == Op::AddU32 { constant.wrapping_add(more) } else { constant.wrapping_sub(more) })
            }
            _ => return (node, 0),
        };
        if constant == 0 {
            return (node, 0);
        }
        (self.compute(op, [own, other, own, own]), constant)
    }

    /// First byte and number of bytes of an area; those of a data block as it is open in the iteration.
    fn area(&mut self, area: Area, write: bool) -> Option<(i32, u64)> {
        let register = match area {
            Area::SharedData => DataRegister::Shared,
            Area::InstanceData => DataRegister::Instance,
            _ => return self.translator.known_area(area, write).map(|(_, start, length)| (start, length)),
        };
        let mut open = [0; 3];
        for (value, register) in open.iter_mut().zip(data_registers(register)) {
            let node = self.get(register.into())?;
            *value = self.kernel.constant(node)?;
        }
        let [number, start, length] = open;
        let is_protected = self.translator.layout.read_only.iter().any(|&protected| u64::from(protected) == number);
        (!(write && is_protected)).then_some((i32::try_from(start).ok()?, length))
    }

    /// Where the local data of a caller begin, and how many bytes they have.
    pub(super) fn caller_local(&self, calls: usize) -> Option<(i32, usize)> {
        match self.frames.len().checked_sub(1 + calls) {
            Some(at) => {
                let caller = &self.frames[at];
                Some((caller.local_offset, self.translator.blocks[caller.index].local_size as usize))
            }
            // Behind the callers that are read are those that are written.
            None => self.translator.caller_local(calls.checked_sub(self.frames.len())?),
        }
    }

    /// A variable in the local data of a caller.
    fn in_caller(&mut self, position: u32, width: Width) -> Option<Reached> {
        let caller = self.caller_local((position >> CALLS_SHIFT) as usize)?;
        let (offset, bit) = way_into(position, width, caller)?;
        Some(Reached::Slot(self.slot(SlotKind::Memory { base: Base::Local, offset, width, bit })))
    }
}
