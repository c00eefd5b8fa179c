//! Bits of numbers in local data: `result.%X0 := a;` in a function writes a bit of what was written as a number, and the next load is the
//! number again. In the loop body it is the number with the bits that were written since.

use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::super::scalar_promotion::Base;
use super::super::kernel::{Node, Slot, SlotKind};
use super::SsaBuilder;

impl SsaBuilder<'_, '_> {
    /// Which bit of a number in local data a slot is, if it is one.
    fn place_in_number(&self, bit: Slot, number: Slot) -> Option<u32> {
        let [
            SlotKind::Memory { base: Base::Local, offset, width: Width::Bit, bit: at },
            SlotKind::Memory { base: Base::Local, offset: first, width, .. },
        ] = [bit, number].map(|slot| self.kernel.kept(slot))
        else {
            return None;
        };
        let bytes = width.bytes() as i32;
        let behind = first + bytes - 1 - offset;
        let is_part = matches!(width, Width::Byte | Width::Word | Width::DoubleWord) && (0..bytes).contains(&behind);
        is_part.then(|| 8 * behind as u32 + u32::from(at))
    }

    /// What a slot in local data holds if its bits were written otherwise since it was written itself, and what they are is known.
    pub(super) fn made_otherwise(&mut self, slot: Slot) -> Option<Node> {
        self.bit_of_number(slot).or_else(|| self.number_with_bits(slot))
    }

    /// The number in local data of which a bit is part, if all of it was written since the bit was written by itself, and which one it is.
    fn number_around(&self, bit: Slot) -> Option<(Node, u32)> {
        let own = self.touched.get(&bit).copied().unwrap_or(0);
        self.touched.iter().find_map(|(&slot, &written)| {
            let at = self.place_in_number(bit, slot).filter(|_| written > own)?;
            let number = self.now.get(&slot).copied()?;
            let shares_bit = |other: Slot| other != bit && self.shares_local(bit, other);
            let is_whole = !self.touched.iter().any(|(&other, &later)| later > written && shares_bit(other));
            is_whole.then_some((number, at))
        })
    }

    /// A bit of a number that was written since the bit was written by itself.
    fn bit_of_number(&mut self, bit: Slot) -> Option<Node> {
        let (number, at) = self.number_around(bit)?;
        let [one, by] = [1, u64::from(at)].map(|number| self.constant(number));
        let moved = if at == 0 { number } else { self.compute(Op::Shr32, [number, by, by, by]) };
        Some(self.compute(Op::AndU32, [moved, one, one, one]))
    }

    /// A number in local data of which bits were written since it was written itself.
    fn number_with_bits(&mut self, slot: Slot) -> Option<Node> {
        let SlotKind::Memory { base: Base::Local, width, .. } = self.kernel.kept(slot) else { return None };
        let written = *self.touched.get(&slot)?;
        let later = |(&other, &later): (&Slot, &usize)| (later > written && self.shares_local(slot, other)).then_some(other);
        let later: Vec<Slot> = self.touched.iter().filter_map(later).collect();
        let bits = later.iter().map(|&bit| Some((self.place_in_number(bit, slot)?, *self.now.get(&bit)?)));
        let mut bits: Vec<(u32, Node)> = bits.collect::<Option<_>>()?;
        let mut number = self.now.get(&slot).copied().filter(|_| !bits.is_empty())?;
        bits.sort_unstable();
        let cleared = bits.iter().fold((1_u64 << width.bits()) - 1, |all, &(at, _)| all & !(1 << at));
        let cleared = self.constant(cleared);
        number = self.compute(Op::AndU32, [number, cleared, cleared, cleared]);
        for (at, value) in bits {
            let [one, by] = [1, u64::from(at)].map(|number| self.constant(number));
            let set = if self.kernel.is_bit(value) { value } else { self.compute(Op::AndU32, [value, one, one, one]) };
            let moved = if at == 0 { set } else { self.compute(Op::Shl32, [set, by, by, by]) };
            number = self.compute(Op::OrU32, [number, moved, moved, moved]);
        }
        Some(if width == Width::Word { self.compute(Op::Low16, [number; 4]) } else { number })
    }
}
