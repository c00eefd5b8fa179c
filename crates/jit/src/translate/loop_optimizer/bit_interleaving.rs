//! Interleaving of eight iterations with store merging: iterations that load or store consecutive bits, upwards or downwards, are written
//! eight at a time, and their bits are one byte, which is loaded and stored once. In the scalar version each iteration waits for the byte
//! that the one before has stored.
//!
//! Scalar iterations before them go up to the first one whose bit begins a byte. What an iteration loads that one before it has stored was
//! carried on ([`predictive_commoning`](super::predictive_commoning)); other bits that it loads are ahead of all that were stored, and are
//! in memory as they were.

use std::collections::{BTreeMap, BTreeSet};

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::data;
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::emission::Emitter;
use super::kernel::{Access, Kernel, Level, Node};
use super::vectorization::Lanes;
use crate::passes::Pass;

/// Iterations behind one another: as many as a byte has bits.
pub(super) const ITERATIONS: u32 = 8;
/// Values of an iteration that is written so often.
const VALUES_MAX: usize = 100;

/// How far a bit that an iteration reads may lie ahead of one that it writes.
const AHEAD_MAX: u32 = 1 << 15;
/// The bytes of an area in which two positions so far apart, as numbers of 24 bits, are so, too.
const AREA_MAX: u64 = ((1 << 24) - AHEAD_MAX as u64) / 8;

/// Accesses that go to bits of the same bytes in eight iterations.
#[derive(Clone, Debug)]
pub(super) struct InterleavedBits {
    pieces: BTreeMap<usize, PackedAddress>,
    way: Direction,
}

/// Whether the bit of the next iteration is the next one or the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    Up,
    Down,
}

impl Direction {
    /// How far before one access another one goes, modulo 24 bits.
    pub(super) fn ahead(self, first: &Access, then: &Access) -> u32 {
        let ahead = match self {
            Self::Up => first.offset.wrapping_sub(then.offset),
            Self::Down => then.offset.wrapping_sub(first.offset),
        };
        ahead & 0x00FF_FFFF
    }

    /// The bit of a byte to which the first of eight iterations goes.
    fn first_bit(self) -> u32 {
        self.bit_of(0)
    }

    /// That to which one of them goes.
    fn bit_of(self, iteration: u32) -> u32 {
        match self {
            Self::Up => iteration,
            Self::Down => ITERATIONS - 1 - iteration,
        }
    }
}

/// Where an access goes in the first of eight iterations.
#[derive(Clone, Copy, Debug)]
pub(super) struct PackedAddress {
    /// The byte.
    at: Place,
    /// Its bit.
    bit: u8,
}

/// Where a byte lies: its area, and a pointer with an offset.
pub(super) type Place = ((Base, i32, u64), Node, u32);

/// Two bytes with bits of the iterations behind one another, the second one with those of accesses that begin behind the first bit.
#[derive(Clone, Copy)]
pub(super) struct PackedByte {
    address: Value,
    /// As they were before the iterations, if that is read.
    old: [Option<Value>; 2],
    /// What the iterations have written to the first, if they write.
    new: Option<Value>,
}

impl Kernel {
    /// The accesses of a loop whose bits make whole bytes, if it has such bits.
    pub(super) fn gathered(&self) -> Option<InterleavedBits> {
        if !self.passes.has(Pass::BitInterleaving) {
            return None;
        }
        if self.inner.is_some() || !self.copies.is_empty() {
            return None;
        }
        let mut values = BTreeSet::new();
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        self.all_ends().chain(of_accesses).for_each(|node| self.rests(node, &mut values));
        if values.len() > VALUES_MAX {
            return None;
        }
        let all = self.accesses_in_order();
        let follows = |access: &Access| if access.part.is_none() { self.bits_follow(access) } else { None };
        let follow: Vec<(usize, &Access, Direction)> =
            all.iter().filter_map(|&(number, access)| Some((number, access, follows(access)?))).collect();
        // Nobody looks at the first bit of what is read with another pointer. What is written has to begin with the first bits of bytes; if
        // nothing is, what is read begins so as far as that can be.
        let written = follow.iter().filter(|(_, access, _)| access.value.is_some());
        let leading: BTreeSet<(Node, u32)> = written.map(|(_, access, _)| (access.pointer, access.offset % 8)).collect();
        let &(_, first, way) = follow.first()?;
        let leading = if leading.is_empty() { BTreeSet::from([(first.pointer, first.offset % 8)]) } else { leading };
        let mut pieces = BTreeMap::new();
        for &(number, access, own) in &follow {
            let mut begins = leading.iter().filter(|&&(pointer, _)| pointer == access.pointer).map(|&(_, begins)| begins);
            let Some(first) = begins.next() else { continue };
            if begins.next().is_some() || own != way {
                return None;
            }
            let bit = access.offset.wrapping_sub(first) % 8;
            let offset = access.offset.wrapping_sub(bit + way.first_bit());
            let at = (access.area, access.pointer, offset & 0x00FF_FFFF);
            pieces.insert(number, PackedAddress { at, bit: bit as u8 });
        }
        for (at, &(number, access)) in all.iter().enumerate() {
            for &(other, before) in &all[..at] {
                if access.value.is_none() && before.value.is_none() || ![number, other].iter().any(|number| pieces.contains_key(number)) {
                    continue;
                }
                let reads_what_is_written_then = before.value.is_none() && access.is_same(before);
                let reads_ahead = access.is_bit_ahead_of(before, way) || before.is_bit_ahead_of(access, way);
                if access.may_share(before) && !reads_what_is_written_then && !reads_ahead {
                    return None;
                }
            }
        }
        (!pieces.is_empty()).then_some(InterleavedBits { pieces, way })
    }

    /// Whether an access goes one bit further in each iteration, and where to.
    pub(super) fn bits_follow(&self, access: &Access) -> Option<Direction> {
        let line = self.line(access.pointer, Level::Outer).filter(|line| access.width == Width::Bit && line.bits == 32)?;
        match line.step as i32 {
            1 => Some(Direction::Up),
            -1 => Some(Direction::Down),
            _ => None,
        }
    }
}

impl Access {
    /// Whether a bit is read that lies ahead of the one that another access writes, whose iterations go there one after the other.
    fn is_bit_ahead_of(&self, other: &Self, way: Direction) -> bool {
        let is_read = self.value.is_none() && other.value.is_some();
        let are_seen_from_one_place =
            (self.area, self.pointer, self.width) == (other.area, other.pointer, Width::Bit) && other.width == Width::Bit;
        let ahead = way.ahead(self, other);
        let (.., bytes) = self.area;
        is_read && are_seen_from_one_place && (1..=AHEAD_MAX).contains(&ahead) && bytes <= AREA_MAX
    }
}

impl InterleavedBits {
    /// Pointers and offsets that lead to first bits of bytes.
    fn bytes(&self) -> BTreeSet<(Node, u32)> {
        self.pieces.values().map(|&PackedAddress { at: (_, pointer, offset), .. }| (pointer, offset % 8)).collect()
    }
}

impl Emitter<'_, '_, '_> {
    /// Whether the first bits of all pieces are the first ones of their bytes.
    pub(super) fn pieces_begin_bytes(&mut self) -> Vec<Value> {
        let begins = self.gathered.as_ref().map(InterleavedBits::bytes).unwrap_or_default();
        let is_first = |(pointer, offset): (Node, u32)| {
            let position = self.position_before(pointer, offset);
            let bit = self.t.b.ins().band_imm_u(position, 7);
            self.t.b.ins().icmp_imm_u(IntCC::Equal, bit, 0)
        };
        begins.into_iter().map(is_first).collect()
    }

    /// As many of some iterations as there are before the one that begins a byte.
    pub(super) fn iterations_up_to_byte(&mut self, pieces: &InterleavedBits, iterations: Value) -> Value {
        let Some((pointer, offset)) = pieces.bytes().pop_first() else { return iterations };
        let position = self.position_before(pointer, offset);
        let left = match pieces.way {
            Direction::Up => self.t.b.ins().ineg(position),
            Direction::Down => position,
        };
        let left = self.t.b.ins().band_imm_u(left, 7);
        let left = self.t.b.ins().uextend(I64, left);
        self.t.b.ins().umin(left, iterations)
    }

    /// Reads or writes a bit of a piece, if an access does; whether it does.
    pub(super) fn access_piece(&mut self, number: usize) -> bool {
        let Some(InterleavedBits { pieces, way }) = &self.gathered else { return false };
        let Some(&PackedAddress { at: (area, pointer, offset), bit }) = pieces.get(&number) else { return false };
        let behind = way.bit_of(self.iteration) as u8 + bit;
        let access = &self.kernel.accesses[number];
        let start = area.1;
        let mut piece = match self.pieces.get(&(area, pointer, offset)) {
            Some(&piece) => piece,
            None => {
                debug_assert_eq!(self.iteration, 0);
                let first = self.first(pointer, Level::Outer);
                let address = self.address(area.0, first, offset);
                PackedByte { address, old: [None; 2], new: None }
            }
        };
        match access.value {
            None => {
                let byte = usize::from(behind / 8);
                let old = piece.old[byte].unwrap_or_else(|| self.t.b.ins().uload8(I32, data(), piece.address, start + byte as i32));
                piece.old[byte] = Some(old);
                let node = self.kernel.read_of(number);
                self.set_value(node, Lanes::One(Translator::bit_value(old, behind % 8, false)));
            }
            Some(value) => {
                let value = self.first(value, Level::Outer);
                let bit = match value {
                    Val::Const(value) => self.t.constant((value as u32 & 1) << behind),
                    value => self.t.bit_at(value, behind),
                };
                piece.new = Some(piece.new.map_or(bit, |bits| self.t.b.ins().bor(bits, bit)));
            }
        }
        self.pieces.insert((area, pointer, offset), piece);
        true
    }

    /// Writes the bytes of all iterations behind one another.
    pub(super) fn store_pieces(&mut self) {
        for (((_, start, _), ..), PackedByte { address, new, .. }) in std::mem::take(&mut self.pieces) {
            if let Some(new) = new {
                self.t.b.ins().istore8(data(), new, address, start);
            }
        }
    }
}
