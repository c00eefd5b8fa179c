//! Turns that write bits which follow one another in memory: eight of them are written behind one another, and their bits are one byte,
//! which is written once. Turns one by one wait for the byte that the one before has written.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::data;
use super::super::value::Val;
use super::kernel::{Access, Kernel, Level};
use super::line::Line;
use super::vector::Lanes;
use super::write::Writing;

/// Turns behind one another: as many as a byte has bits.
pub(super) const TURNS: u32 = 8;
/// Values of a turn that is written so often.
const VALUES_MAX: usize = 100;

/// Accesses that go to bits of the same byte in eight turns, the first of them to bit 0: each with the first one that goes to these bits.
pub(super) type Gathered = BTreeMap<usize, usize>;

/// A byte with bits of the turns behind one another.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    address: Value,
    start: i32,
    /// As it was in front of them, if that is read.
    old: Option<Value>,
    /// What they have written, if they write.
    new: Option<Value>,
}

impl Kernel {
    /// The accesses of a loop whose bits make whole bytes, if it writes such bits.
    pub(super) fn gathered(&self) -> Option<Gathered> {
        if self.inner.is_some() || !self.left().is_empty() {
            return None;
        }
        let mut values = BTreeSet::new();
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        self.all_ends().chain(of_accesses).for_each(|node| self.rests(node, &mut values));
        if values.len() > VALUES_MAX {
            return None;
        }
        let all = self.accesses_in_order();
        let follows = |access: &Access| access.part.is_none() && self.bits_follow(access);
        let written: Vec<&Access> =
            all.iter().map(|&(_, access)| access).filter(|access| access.value.is_some() && follows(access)).collect();
        if written.is_empty() {
            return None;
        }
        // Nobody looks at the first bit of what is only read: it has to be that of something that is written.
        let begins_with = |access: &Access| {
            written.iter().any(|other| other.pointer == access.pointer && (other.offset ^ access.offset).is_multiple_of(8))
        };
        let mut gathered = Gathered::new();
        for &(number, access) in all.iter().filter(|(_, access)| follows(access) && begins_with(access)) {
            let first = gathered.keys().copied().find(|&other| access.goes_where(&self.accesses[other]));
            gathered.insert(number, first.unwrap_or(number));
        }
        for (at, &(number, access)) in all.iter().enumerate() {
            for &(other, before) in &all[..at] {
                if access.value.is_none() && before.value.is_none() || ![number, other].iter().any(|number| gathered.contains_key(number)) {
                    continue;
                }
                let reads_what_is_written_then = before.value.is_none() && access.goes_where(before);
                if access.may_share(before) && !reads_what_is_written_then {
                    return None;
                }
            }
        }
        Some(gathered)
    }

    /// Whether an access goes one bit further in each turn.
    pub(super) fn bits_follow(&self, access: &Access) -> bool {
        access.width == Width::Bit && self.line(access.pointer, Level::Outer) == Some(Line { step: 1, bits: 32 })
    }
}

impl Access {
    /// Whether two accesses go to the same place in each turn.
    pub(super) fn goes_where(&self, other: &Self) -> bool {
        (self.area, self.pointer, self.offset, self.width) == (other.area, other.pointer, other.offset, other.width)
    }
}

impl Writing<'_, '_, '_> {
    /// Whether the first bits of all pieces are the first ones of their bytes.
    pub(super) fn pieces_begin_bytes(&mut self) -> Vec<Value> {
        let first: BTreeSet<usize> = self.gathered.values().copied().collect();
        let mut known = BTreeSet::new();
        let mut conditions = Vec::new();
        for access in first.into_iter().map(|number| &self.kernel.accesses[number]) {
            if known.insert((access.pointer, access.offset % 8)) {
                let position = self.position_before(access.pointer, access.offset);
                let bit = self.t.b.ins().band_imm_u(position, 7);
                conditions.push(self.t.b.ins().icmp_imm_u(IntCC::Equal, bit, 0));
            }
        }
        conditions
    }

    /// Reads or writes a bit of a piece, if an access does; whether it does.
    pub(super) fn access_piece(&mut self, number: usize) -> bool {
        let Some(&first) = self.gathered.get(&number) else { return false };
        let access = &self.kernel.accesses[number];
        let piece = match self.pieces.get(&first) {
            Some(&piece) => piece,
            None => {
                debug_assert_eq!(self.turn, 0);
                let pointer = self.first(access.pointer, Level::Outer);
                let address = self.address(access.area.0, pointer, access.offset);
                Piece { address, start: access.area.1, old: None, new: None }
            }
        };
        let turn = self.turn as u8;
        let piece = match access.value {
            None => {
                let old = piece.old.unwrap_or_else(|| self.t.b.ins().uload8(I32, data(), piece.address, piece.start));
                let node = self.kernel.read_of(number);
                self.set_value(node, Lanes::One(Translator::bit_value(old, turn, false)));
                Piece { old: Some(old), ..piece }
            }
            Some(value) => {
                let value = self.first(value, Level::Outer);
                let bit = match value {
                    Val::Const(value) => self.t.constant((value as u32 & 1) << turn),
                    value => self.t.bit_at(value, turn),
                };
                let new = piece.new.map_or(bit, |bits| self.t.b.ins().bor(bits, bit));
                Piece { new: Some(new), ..piece }
            }
        };
        self.pieces.insert(first, piece);
        true
    }

    /// Writes the bytes of all turns behind one another.
    pub(super) fn store_pieces(&mut self) {
        let pieces: HashMap<usize, Piece> = std::mem::take(&mut self.pieces);
        let mut pieces: Vec<(usize, Piece)> = pieces.into_iter().collect();
        pieces.sort_by_key(|&(first, _)| first);
        for (_, piece) in pieces {
            if let Some(new) = piece.new {
                self.t.b.ins().istore8(data(), new, piece.address, piece.start);
            }
        }
    }
}
