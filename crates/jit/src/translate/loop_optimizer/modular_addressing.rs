//! Modular addressing: variables of an iteration at an index of their own in an array of their own, such as a ring buffer in an instance of
//! a function block. Seen from the base of the instance, they are among bytes that are known, so they alias nothing else.

use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::kernel::{Access, Definition, Kernel, Level, Node};
use super::ssa_construction::{DEPTH_MAX, SsaBuilder};
use crate::passes::Pass;

/// The bits among which a variable may lie, at most.
const BITS_MAX: i128 = 1 << 19;
/// Sums in a pointer that are looked at.
const SUMS_MAX: usize = 4;

/// Where a variable lies, seen from a pointer of which its own is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ModularAddress {
    pub(super) pointer: Node,
    /// The first bit of it behind that pointer, 24 bits.
    pub(super) offset: u32,
    /// All bits among which it lies from there on.
    pub(super) bits: u32,
}

impl ModularAddress {
    /// The place of all bytes with these bits.
    pub(super) fn whole_bytes(self) -> Self {
        Self { offset: self.offset & !7, bits: (self.offset % 8 + self.bits).next_multiple_of(8), ..self }
    }
}

/// Bytes among which an iteration touches memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct ByteWindow {
    /// A pointer on a line.
    pub(super) pointer: Node,
    /// The first byte behind it, and how many they are.
    pub(super) byte: i64,
    pub(super) bytes: i64,
}

/// How two accesses lie to each other in each iteration, in bytes.
pub(super) struct Distance {
    /// How far both are from where they are in the iteration before.
    pub(super) step: i64,
    /// How far the later one is ahead of the earlier one.
    pub(super) ahead: i64,
    /// The bytes that they may touch.
    pub(super) later: i64,
    pub(super) earlier: i64,
}

/// A number of 24 bits of a position as one of bytes.
fn byte(offset: u32) -> i64 {
    i64::from((offset << 8) as i32 >> 11)
}

impl Access {
    /// The place of the variable, seen from all pointers from which it is known.
    fn seen(&self) -> impl Iterator<Item = ModularAddress> {
        let bits = if self.width == Width::Bit { 1 } else { self.width.bytes() * 8 };
        let own = ModularAddress { pointer: self.pointer, offset: self.offset & 0x00FF_FFFF, bits };
        std::iter::once(own).chain(self.around.iter().copied())
    }

    /// Whether another access goes to other bits, as is seen from one pointer.
    pub(super) fn is_beside(&self, other: &Self) -> bool {
        let beside = |a: ModularAddress, b: ModularAddress| {
            // Positions have 24 bits.
            let ahead = b.offset.wrapping_sub(a.offset) & 0x00FF_FFFF;
            let behind = a.offset.wrapping_sub(b.offset) & 0x00FF_FFFF;
            a.pointer == b.pointer && ahead >= a.bits && behind >= b.bits
        };
        self.area == other.area && self.seen().any(|own| other.seen().any(|other| beside(own, other)))
    }
}

impl Kernel {
    /// Bytes among which an access stays, behind pointers on a line.
    pub(super) fn places(&self, access: &Access) -> Vec<ByteWindow> {
        if self.counted_on(access, Level::Outer).is_some() {
            return vec![ByteWindow { pointer: access.pointer, byte: byte(access.offset), bytes: access.width.bytes().into() }];
        }
        let on_line = |around: &&ModularAddress| {
            let line = self.line(around.pointer, Level::Outer);
            access.level == Level::Outer && line.is_some_and(|line| line.bits == 32 && line.step % 8 == 0)
        };
        let places = access.around.iter().filter(on_line).map(|around| ByteWindow {
            pointer: around.pointer,
            byte: byte(around.offset),
            bytes: i64::from((around.offset % 8 + around.bits).div_ceil(8)),
        });
        places.collect()
    }

    /// How two accesses lie to each other, seen from all pointers from which both are known.
    pub(super) fn distances(&self, later: &Access, earlier: &Access) -> Vec<Distance> {
        let mut distances = Vec::new();
        if later.area != earlier.area {
            return distances;
        }
        for own in self.places(later) {
            for other in self.places(earlier).into_iter().filter(|other| other.pointer == own.pointer) {
                let Some(line) = self.line(own.pointer, Level::Outer) else { continue };
                // Positions have 24 bits.
                let ahead = i64::from(((own.byte - other.byte) as i32) << 11 >> 11);
                distances.push(Distance { step: i64::from(line.step as i32) / 8, ahead, later: own.bytes, earlier: other.bytes });
            }
        }
        distances
    }
}

impl SsaBuilder<'_, '_> {
    /// The place of a variable that stays inside its area, seen from pointers of which its own is a sum.
    pub(super) fn around(&mut self, (pointer, offset): (Node, u32), width: Width) -> Vec<ModularAddress> {
        if !self.kernel.passes.has(Pass::ModularAddressing) {
            return Vec::new();
        }
        let bits = if width == Width::Bit { 1 } else { width.bytes() * 8 };
        let mut all = Vec::new();
        self.seen_from_parts(pointer, ModularAddress { pointer, offset, bits }, SUMS_MAX, &mut all);
        all
    }

    fn seen_from_parts(&mut self, pointer: Node, seen: ModularAddress, depth: usize, all: &mut Vec<ModularAddress>) {
        let Definition::Compute(Op::AddU32, [a, b, ..]) = self.kernel.what(pointer) else { return };
        for (part, other) in [(a, b), (b, a)] {
            let [own, range] = [part, other].map(|node| self.range(node, DEPTH_MAX));
            let (least, most) = range.unsigned(24);
            if depth == 0 || own.zeros < 3 || most - least + i128::from(seen.bits) > BITS_MAX {
                continue;
            }
            let (pointer, offset) = self.without_constants(part, seen.offset.wrapping_add(least as u32));
            let around = ModularAddress { pointer, offset, bits: seen.bits + (most - least) as u32 };
            all.push(around);
            self.seen_from_parts(pointer, around, depth - 1, all);
        }
    }
}
