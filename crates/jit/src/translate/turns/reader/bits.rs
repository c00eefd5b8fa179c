//! Bits of numbers in local data: `result.%X0 := a;` in a function writes a bit of what was written as a number, and what is read next is
//! the number again. In a turn it is one number all the time.

use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::super::promote::Base;
use super::super::kernel::{Cell, Kept, Node};
use super::Reader;

impl Reader<'_, '_> {
    /// The number in local data of which a bit is part, and which of its bits that is, if the turn knows it and wrote nothing of it otherwise
    /// since.
    fn number_around(&self, bit: Cell) -> Option<(Cell, Node, u32)> {
        let Kept::Memory { base: Base::Local, offset, width: Width::Bit, bit: number } = self.kernel.kept(bit) else { return None };
        self.touched.iter().find_map(|(&cell, &written)| {
            let Kept::Memory { base: Base::Local, offset: first, width: width @ (Width::Byte | Width::Word | Width::DoubleWord), .. } =
                self.kernel.kept(cell)
            else {
                return None;
            };
            let behind = first + width.bytes() as i32 - 1 - offset;
            let is_part = (0..width.bytes() as i32).contains(&behind);
            let value = self.now.get(&cell).copied().filter(|_| is_part)?;
            let is_whole = !self.touched.iter().any(|(&other, &later)| later > written && self.shares_local(cell, other));
            is_whole.then_some((cell, value, 8 * behind as u32 + u32::from(number)))
        })
    }

    /// Writes a bit as one of the number of which it is part; whether it is.
    pub(super) fn write_bit_of_number(&mut self, bit: Cell, value: Node) -> bool {
        let Some((cell, number, at)) = self.number_around(bit) else { return false };
        let Kept::Memory { width, .. } = self.kernel.kept(cell) else { return false };
        let all = (1_u64 << width.bits()) - 1;
        let [one, others, by] = [1, all & !(1 << at), u64::from(at)].map(|number| self.constant(number));
        let is_bit = self.kernel.is_bit(value) || self.kernel.constant(value).is_some_and(|value| value <= 1);
        let set = if is_bit { value } else { self.compute(Op::AndU32, [value, one, one, one]) };
        let moved = if at == 0 { set } else { self.compute(Op::Shl32, [set, by, by, by]) };
        let kept = self.compute(Op::AndU32, [number, others, others, others]);
        let mut new = self.compute(Op::OrU32, [kept, moved, moved, moved]);
        if width == Width::Word {
            new = self.compute(Op::Low16, [new; 4]);
        }
        self.written_in_local(cell);
        self.put(cell, new);
        true
    }

    /// A bit of a number that was written since the bit was written by itself.
    pub(super) fn bit_of_number(&mut self, bit: Cell) -> Option<Node> {
        let (cell, number, at) = self.number_around(bit)?;
        if self.touched.get(&bit) > self.touched.get(&cell) {
            return None;
        }
        let [one, by] = [1, u64::from(at)].map(|number| self.constant(number));
        let moved = if at == 0 { number } else { self.compute(Op::Shr32, [number, by, by, by]) };
        Some(self.compute(Op::AndU32, [moved, one, one, one]))
    }
}
