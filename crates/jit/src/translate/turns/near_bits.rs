//! Bits that a turn reads a few positions apart from each other, such as `x[i]`, `x[i + 1]` and `x[i + 4]`: they are read in one piece, and
//! each is a bit of it.

use std::collections::{BTreeMap, BTreeSet};

use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::{Address, Bit, data};
use super::super::promote::Base;
use super::kernel::{Access, Kernel, Level, Node, Step};
use super::vector::Lanes;
use super::write::Writing;

/// Bytes of a piece.
const BYTES: i64 = 4;
/// How far a bit may lie behind the first one, which is any of the first byte.
const BEHIND_MAX: u32 = 8 * (BYTES as u32 - 1);
/// The bytes of an area in which two positions that are a few bits apart, as numbers of 24 bits, are so, too.
const AREA_MAX: u64 = (1 << 21) - BYTES as u64;

/// Reads of bits that are read in pieces: each with the one whose bit is the first of the piece, and how far its own lies behind that.
pub(super) type NearBits = BTreeMap<usize, (usize, u8)>;

impl Kernel {
    /// The bits that each turn reads in pieces, if nothing is written where they lie.
    pub(super) fn near_bits(&self) -> NearBits {
        let mut of_pointers: BTreeMap<(Base, i32, Node), BTreeSet<(u32, usize)>> = BTreeMap::new();
        let turns = [Some(&self.outer), self.inner.as_ref()];
        for step in turns.into_iter().flatten().flat_map(|turn| &turn.steps) {
            let Step::Access(number) = *step else { continue };
            let access = &self.accesses[number];
            let (base, start, bytes) = access.area;
            let is_bit = access.value.is_none() && access.width == Width::Bit && access.part.is_none();
            if is_bit && bytes <= AREA_MAX && self.is_only_looked_at(access) {
                of_pointers.entry((base, start, access.pointer)).or_default().insert((access.offset & 0x00FF_FFFF, number));
            }
        }
        let mut near = NearBits::new();
        for reads in of_pointers.into_values() {
            let mut reads: Vec<(u32, usize)> = reads.into_iter().collect();
            while let Some(&(first, begins)) = reads.first() {
                let (together, others): (Vec<_>, Vec<_>) = reads.into_iter().partition(|&(offset, _)| offset - first <= BEHIND_MAX);
                if together.iter().any(|&(offset, _)| offset != first) {
                    near.extend(together.into_iter().map(|(offset, number)| (number, (begins, (offset - first) as u8))));
                }
                reads = others;
            }
        }
        near
    }

    /// Whether a piece that begins with an access can be read, and no turn writes to it: a piece would wait for what was written to one of
    /// its bytes.
    fn is_only_looked_at(&self, access: &Access) -> bool {
        let (base, bytes) = access.bytes();
        let (_, start, length) = access.area;
        let touched = bytes.start..bytes.end - 1 + BYTES;
        let end = if base == Base::Arena { self.size as i64 } else { i64::from(start) + length as i64 };
        let written = self.accesses.iter().filter(|other| other.value.is_some());
        let copied = self.copies.iter().map(|copied| &copied.to);
        let mut all = written.chain(copied).map(Access::bytes);
        touched.end <= end && !all.any(|(other, bytes)| base.may_share(&touched, other, &bytes))
    }
}

impl Writing<'_, '_, '_> {
    /// Reads a bit of a piece, if an access does; whether it does.
    pub(super) fn read_near_bit(&mut self, number: usize, level: Level) -> bool {
        let Some(&(first, behind)) = self.near_bits.get(&number) else { return false };
        let piece = match self.scope(level).near_bits.get(&first) {
            Some(&piece) => piece,
            None => {
                let piece = self.piece_from(first, level);
                self.scope(level).near_bits.insert(first, piece);
                piece
            }
        };
        let node = self.kernel.read_of(number);
        self.scope(level).values.insert(node, Lanes::One(Translator::bit_value(piece, behind, false)));
        true
    }

    /// Four bytes from that with the bit of an access on, moved so that this is the lowest one.
    fn piece_from(&mut self, first: usize, level: Level) -> Value {
        let access = &self.kernel.accesses[first];
        let pointer = self.first(access.pointer, level);
        let Address { base, offset, bit } = self.address_at(access, pointer);
        let piece = self.t.b.ins().load(I32, data(), base, offset);
        match bit {
            Bit::Number(0) => piece,
            Bit::Number(bit) => self.t.b.ins().ushr_imm_u(piece, i64::from(bit)),
            Bit::Computed(bit) => self.t.b.ins().ushr(piece, bit),
        }
    }
}
