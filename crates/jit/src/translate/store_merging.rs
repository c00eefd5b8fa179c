//! Store merging for bits at constant addresses: bits that are written to one packed word along straight code become one store, and a word
//! that was loaded is not loaded again. No store is deferred where an observer may look at memory or where paths merge; no value is
//! available where an observer may have changed it, and after a merge only what is the same value on all paths.
//!
//! A packed word has four bytes if the code accesses bits of more than one of them and nothing else in them, otherwise one byte: a load of
//! four bytes after a store of two of them would have to wait for it.

use std::ops::Range;

use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{Endianness, InstBuilder, InstructionData, MemFlagsData, Opcode, Value};
use cranelift_frontend::Variable;
use rustc_hash::{FxHashMap, FxHashSet};
use sieben_engine::ir::Inst;
use sieben_model::address::Width;

use super::Translator;
use super::address_reuse::AvailableAddresses;
use super::load_elimination::AvailableLoads;
use super::memory::{Address, Bit, data};
use super::memory_to_register::{DeferredStores, LocalValues};
use super::natural_loops::NaturalLoop;
use super::scalar_promotion::Base;
use super::value::Val;

/// Pieces whose new bits wait for their store. More would keep registers that the logic needs.
const WAITING_MAX: usize = 4;
/// Pieces whose value is remembered; a value that is not read again costs nothing.
const KNOWN_MAX: usize = 12;
/// Bits of a piece whose values are remembered by themselves. More would keep registers that the logic needs.
const RECENT: usize = 8;
/// Instructions of a block up to which more than one is: code that is longer waits for itself to be read, not for its results.
const INSTRUCTIONS_MAX: usize = 16_000;
/// Bytes of a long piece.
const LONG: i32 = 4;

/// What is known of bytes of memory between two places where it must be as the program left it.
#[derive(Debug, Default)]
pub(super) struct AvailableBits {
    waiting: Vec<DeferredBits>,
    pub(super) words: DeferredStores,
    /// Values of pieces in memory, the oldest first; `None` = what a variable holds where ways meet. Bits that wait for their store are
    /// old here.
    known: Vec<(PackedWord, Option<Value>)>,
    /// Those variables.
    met: FxHashMap<PackedWord, Variable>,
    /// Numbers at computed addresses.
    pub(super) numbers: AvailableLoads,
    /// Bytes that code looks at bit by bit, and those that it looks at otherwise.
    of_bits: FxHashSet<(Base, i32)>,
    of_others: FxHashSet<(Base, i32)>,
    /// How often the code writes numbers at offsets in the arena.
    writes: FxHashMap<i32, u32>,
    /// Whether the piece that begins at a multiple of four is a long one, as far as that was asked.
    long: FxHashMap<(Base, i32), bool>,
}

impl AvailableBits {
    /// Whether the code writes a number in the arena more than once.
    pub(super) fn is_written_again(&self, offset: i32) -> bool {
        self.writes.get(&offset).is_some_and(|&count| count > 1)
    }
}

/// Bytes that are read and written together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct PackedWord {
    base: Base,
    start: i32,
    bytes: i32,
}

impl PackedWord {
    fn meets(&self, base: Base, bytes: &Range<i32>) -> bool {
        let own = i64::from(self.start)..i64::from(self.start + self.bytes);
        self.base.may_share(&own, base, &(i64::from(bytes.start)..i64::from(bytes.end)))
    }

    /// All its bits.
    pub(super) fn mask(&self) -> u32 {
        if self.bytes == LONG { u32::MAX } else { 0xFF }
    }
}

/// Bits of one piece that wait for their store.
#[derive(Clone, Copy, Debug)]
struct DeferredBits {
    piece: PackedWord,
    /// The bits that were written.
    mask: u32,
    /// Of them those that are 1 whatever happens.
    ones: u32,
    /// Of them the others, in 32 bits; bits that were not written are 0. `None` = all 0.
    bits: Option<Value>,
    /// Bits that were written lately, the last one first: who reads one of them need not wait for those behind it.
    recent: [Option<(u8, Val)>; RECENT],
    /// The ones and the bits without the one that was written last: if it is written again before another one, what put it among the others
    /// is not needed.
    others: (u32, Option<Value>),
}

/// What is known of memory where code meets.
#[derive(Debug, Default)]
pub(super) struct AvailableMemory {
    bits: Vec<(PackedWord, Option<Value>)>,
    numbers: AvailableLoads,
    words: LocalValues,
    elements: AvailableAddresses,
    /// Timers that were brought up to date.
    timers: Vec<u64>,
    counts: Vec<(u64, Value)>,
    items: [Option<Value>; 2],
}

impl AvailableMemory {
    /// Keeps what is known on another way, too, where both meet: variables hold what is not the same on both.
    pub(super) fn meet(&mut self, other: &Self) {
        self.bits.retain_mut(|(piece, bits)| {
            let other = other.bits.iter().find(|(own, _)| own == piece);
            other.is_some_and(|&(_, other)| {
                *bits = bits.filter(|&bits| Some(bits) == other);
                true
            })
        });
        self.numbers.keep_common(&other.numbers);
        self.words.meet(&other.words);
        self.elements.keep_common(&other.elements);
        self.timers.retain(|timer| other.timers.contains(timer));
        self.counts.retain(|count| other.counts.contains(count));
        for (item, other) in self.items.iter_mut().zip(other.items) {
            *item = item.filter(|&item| Some(item) == other);
        }
    }
}

fn little() -> MemFlagsData {
    data().with_endianness(Endianness::Little)
}

impl Translator<'_> {
    /// Reads an address that is known to be there.
    pub(super) fn read_known(&mut self, address: Address, width: Width) -> Val {
        if let Some(value) = self.read_promoted(address, width) {
            return value;
        }
        if self.store_touched_at(address, width) {
            // What a register stands for in part is not remembered.
            self.settle_bytes();
            return self.read(address, width);
        }
        let Address { base, offset, bit } = address;
        let (Width::Bit, Bit::Number(number)) = (width, bit) else {
            if let Some(value) = self.word_at(address, width).or_else(|| self.known_number(address, width)) {
                return value;
            }
            let value = match self.number_of_bytes(address, width) {
                Some(value) => value,
                None => {
                    self.store_waiting_in(base, offset, width);
                    self.read(address, width)
                }
            };
            self.remember_word(address, width, value);
            self.remember_number(address, width, value);
            return value;
        };
        let (piece, at) = self.piece_of(base, offset, number);
        self.store_waiting_words_in(piece.base, &(piece.start..piece.start + piece.bytes));
        self.settle_shared(piece, false);
        if let Some(waiting) = self.bytes.waiting.iter().find(|waiting| waiting.piece == piece)
            && waiting.mask & 1 << at != 0
        {
            return match waiting.bits {
                // The only bit that was written.
                Some(value) if waiting.mask == 1 => Val::Bit { value, clean: true },
                _ if let Some((_, value)) = waiting.recent.into_iter().flatten().find(|&(own, _)| own == at) => value,
                _ if waiting.ones & 1 << at != 0 => Val::Const(1),
                Some(bits) => Self::bit_value(bits, at, false),
                None => Val::Const(0),
            };
        }
        let bits = self.bits_at(piece);
        Self::bit_value(bits, at, false)
    }

    /// Writes to an address that is known to be there.
    pub(super) fn write_known(&mut self, address: Address, width: Width, value: Val) {
        if self.write_promoted(address, width, value) {
            return;
        }
        if self.store_touched_at(address, width) {
            self.forget_word(address, width);
            self.settle_bytes();
            self.write(address, width, value);
            self.take_touched_at(address, width);
            return;
        }
        let Address { base, offset, bit } = address;
        let (Width::Bit, Bit::Number(number)) = (width, bit) else {
            self.write_number(address, width, value);
            return;
        };
        self.know_bytes_around(address);
        self.forget_word(address, width);
        let value = match self.force(value) {
            Val::Const(value) => Val::Const(value & 1),
            value @ (Val::Int(_) | Val::Word(_) | Val::Real { .. } | Val::Lreal { .. }) => {
                Val::Bit { value: self.bit(value), clean: false }
            }
            value => value,
        };
        let (piece, at) = self.piece_of(base, offset, number);
        self.store_waiting_words_in(piece.base, &(piece.start..piece.start + piece.bytes));
        self.settle_shared(piece, true);
        let mut waiting = match self.bytes.waiting.iter().position(|waiting| waiting.piece == piece) {
            Some(index) => self.bytes.waiting.remove(index),
            None => DeferredBits { piece, mask: 0, ones: 0, bits: None, recent: [None; RECENT], others: (0, None) },
        };
        let bit = 1u32 << at;
        if waiting.recent[0].is_some_and(|(last, _)| last == at) {
            (waiting.ones, waiting.bits) = waiting.others;
        } else if waiting.mask & bit != 0 {
            waiting.ones &= !bit;
            waiting.bits = waiting.bits.map(|bits| self.masked(bits, !bit & piece.mask()));
        }
        waiting.mask |= bit;
        waiting.others = (waiting.ones, waiting.bits);
        let kept = if self.native().code.insts.len() <= INSTRUCTIONS_MAX { RECENT } else { 1 };
        let same = waiting.recent[..kept].iter().position(|recent| recent.is_none_or(|(own, _)| own == at)).unwrap_or(kept - 1);
        waiting.recent[..=same].rotate_right(1);
        waiting.recent[0] = Some((at, value));
        match value {
            Val::Const(0) => {}
            Val::Const(_) => waiting.ones |= bit,
            value => {
                let (new, others) = self.bits_of_one_number(value, at, waiting.bits);
                if self.is_alone(new, at) && matches!(value, Val::At { .. } | Val::Bit { clean: false, .. }) {
                    waiting.recent[0] = Some((at, Self::bit_value(new, at, false)));
                }
                waiting.bits = Some(match others {
                    Some(bits) => self.b.ins().bor(bits, new),
                    None => new,
                });
            }
        }
        self.bytes.waiting.push(waiting);
        if self.bytes.waiting.len() > WAITING_MAX {
            let oldest = self.bytes.waiting.remove(0);
            self.store_bits(oldest);
        }
    }

    /// A bit at its position, and the others of its piece: those that lie beside it in the number from which they were taken last are taken
    /// from there together with it.
    fn bits_of_one_number(&mut self, value: Val, at: u8, others: Option<Value>) -> (Value, Option<Value>) {
        let new = self.bit_at(value, at);
        let taken = |this: &Self, bits: Value| {
            let (_, InstructionData::Binary { opcode: Opcode::Band, args: [moved, mask] }) = this.definition(bits)? else { return None };
            let (upright, inverted) = match this.definition(moved) {
                Some((_, InstructionData::Unary { opcode: Opcode::Bnot, arg })) => (arg, true),
                _ => (moved, false),
            };
            let (number, by) = match this.definition(upright) {
                Some((_, InstructionData::Binary { opcode: Opcode::Rotr, args: [number, by] })) => (number, this.iconst(by)?),
                _ => (upright, 0),
            };
            Some(((number, by, inverted), moved, this.iconst(mask)?))
        };
        let Some(last) = others else { return (new, None) };
        let (before, last) = match self.definition(last) {
            Some((_, InstructionData::Binary { opcode: Opcode::Bor, args: [before, last] })) => (Some(before), last),
            _ => (None, last),
        };
        if let (Some((source, moved, mask)), Some((other, _, own))) = (taken(self, last), taken(self, new))
            && source == other
        {
            return (self.masked(moved, mask | own), before);
        }
        (new, others)
    }

    /// Notes which bytes the present block looks at bit by bit, and which otherwise.
    pub(super) fn note_bytes(&mut self) {
        for inst in &self.native().code.insts {
            let (Inst::Load { place, width, .. } | Inst::Store { place, width, .. }) = *inst else { continue };
            let Some((base, offset)) = self.constant_address(place, width) else { continue };
            match width {
                Width::Bit => drop(self.bytes.of_bits.insert((base, offset))),
                _ => self.bytes.of_others.extend((offset..offset + width.bytes() as i32).map(|offset| (base, offset))),
            }
            if base == Base::Arena && width != Width::Bit && matches!(inst, Inst::Store { .. }) {
                *self.bytes.writes.entry(offset).or_default() += 1;
            }
        }
    }

    /// The piece with a bit of a byte, and which of its bits that is.
    fn piece_of(&mut self, base: Value, offset: i32, number: u8) -> (PackedWord, u8) {
        let base = self.known_base(base);
        self.piece_at(base, offset, number)
    }

    /// Which bit of its piece some instructions write last, if they write one at an address known beforehand.
    pub(super) fn written_bit(&mut self, insts: &[Inst]) -> Option<u8> {
        let Some(Inst::Store { place, width: Width::Bit, .. }) = insts.last() else { return None };
        let (base, offset) = self.constant_address(*place, Width::Bit)?;
        let (_, position) = self.constant_position(*place)?;
        Some(self.piece_at(base, offset, (position % 8) as u8).1)
    }

    fn piece_at(&mut self, base: Base, offset: i32, number: u8) -> (PackedWord, u8) {
        if let Base::Computed(_) = base {
            return (PackedWord { base, start: offset, bytes: 1 }, number);
        }
        let start = offset & !(LONG - 1);
        let end = if base == Base::Local { self.local_offset + self.native().local_size as i32 } else { self.layout.size as i32 };
        let bytes = &mut self.bytes;
        let long = *bytes.long.entry((base, start)).or_insert_with(|| {
            let all = || (start..start + LONG).map(|offset| (base, offset));
            let of_bits = all().filter(|byte| bytes.of_bits.contains(byte)).count();
            of_bits > 1 && !all().any(|byte| bytes.of_others.contains(&byte)) && start + LONG <= end
        });
        if !long {
            return (PackedWord { base, start: offset, bytes: 1 }, number);
        }
        (PackedWord { base, start, bytes: LONG }, (offset - start) as u8 * 8 + number)
    }

    /// What an address that is known to be there is counted from.
    pub(super) fn known_base(&self, base: Value) -> Base {
        match self.computed.get(&base) {
            Some(&computed) => Base::Computed(computed),
            None if base == self.local => Base::Local,
            None => Base::Arena,
        }
    }

    pub(super) fn address_of_base(&self, base: Base) -> Value {
        match base {
            Base::Local => self.local,
            Base::Computed(computed) => computed.address,
            Base::Arena | Base::Spaced(_) | Base::Run => self.arena,
        }
    }

    /// Stores bits that wait in pieces which may share bytes with this one and are counted from elsewhere, and forgets what may lie there
    /// if it is written.
    fn settle_shared(&mut self, piece: PackedWord, written: bool) {
        if self.computed.is_empty() && self.bytes.numbers.is_empty() {
            return;
        }
        let bytes = piece.start..piece.start + piece.bytes;
        let shares = |other: &PackedWord| other.base != piece.base && other.meets(piece.base, &bytes);
        while let Some(index) = self.bytes.waiting.iter().position(|waiting| shares(&waiting.piece)) {
            let waiting = self.bytes.waiting.remove(index);
            self.store_bits(waiting);
        }
        if written {
            self.bytes.known.retain(|(other, _)| !shares(other));
            self.bytes.numbers.forget(piece.base, &bytes);
        }
    }

    /// A piece as it is in memory, in 32 bits.
    fn bits_at(&mut self, piece: PackedWord) -> Value {
        match self.bytes.known.iter().find(|(known, _)| *known == piece) {
            Some(&(_, Some(bits))) => return bits,
            Some((_, None)) => {
                let bits = self.b.use_var(self.bytes.met[&piece]);
                self.remember(piece, bits);
                return bits;
            }
            None => {}
        }
        let base = self.address_of_base(piece.base);
        let bits = match piece.bytes {
            LONG => self.b.ins().load(I32, little(), base, piece.start),
            _ => self.b.ins().uload8(I32, data(), base, piece.start),
        };
        self.remember(piece, bits);
        bits
    }

    fn remember(&mut self, piece: PackedWord, bits: Value) {
        self.bytes.known.retain(|(known, _)| *known != piece);
        if self.bytes.known.len() >= KNOWN_MAX {
            self.bytes.known.remove(0);
        }
        self.bytes.known.push((piece, Some(bits)));
    }

    /// Lets variables hold pieces that are known, before a place where ways meet.
    pub(super) fn hold_bits(&mut self) {
        let AvailableBits { known, met, .. } = &mut self.bytes;
        for &(piece, bits) in known.iter() {
            let Some(bits) = bits else { continue };
            let variable = *met.entry(piece).or_insert_with(|| self.b.declare_var(I32));
            self.b.def_var(variable, bits);
        }
    }

    /// A number some of whose bytes are known because bits were written there: a processor waits for the memory where a number is read that
    /// was stored in several pieces.
    fn number_of_bytes(&mut self, address: Address, width: Width) -> Option<Val> {
        if !self.options.optimize || self.cold.is_some() || !matches!(width, Width::Word | Width::DoubleWord) {
            return None;
        }
        let base = self.known_base(address.base);
        let bytes = address.offset..address.offset + width.bytes() as i32;
        let is_byte = |piece: &PackedWord| piece.base == base && piece.bytes == 1;
        let mut waits = false;
        for waiting in self.bytes.waiting.iter().filter(|waiting| waiting.piece.meets(base, &bytes)) {
            if !is_byte(&waiting.piece) {
                return None;
            }
            waits = true;
        }
        let known = |at: i32| self.bytes.known.iter().any(|(piece, _)| is_byte(piece) && piece.start == at);
        if !waits && !bytes.clone().all(known) {
            return None;
        }
        self.store_waiting_words_in(base, &bytes);
        let mut number: Option<Value> = None;
        for start in bytes {
            let piece = PackedWord { base, start, bytes: 1 };
            let byte = match self.bytes.waiting.iter().find(|waiting| waiting.piece == piece).copied() {
                Some(waiting) => self.with_waiting_bits(waiting),
                None => self.bits_at(piece),
            };
            number = Some(match number {
                Some(before) => {
                    let before = self.b.ins().ishl_imm_u(before, 8);
                    self.b.ins().bor(before, byte)
                }
                None => byte,
            });
        }
        let number = number?;
        self.narrow.insert(number, width.bytes() * 8);
        Some(Val::Int(number))
    }

    /// Knows the bytes of a number that is known, in which a bit is written.
    fn know_bytes_around(&mut self, address: Address) {
        if !self.options.optimize || self.cold.is_some() {
            return;
        }
        let Some((first, width, value)) = self.number_around(address) else { return };
        let base = self.known_base(address.base);
        let count = width.bytes() as i32;
        for start in first..first + count {
            let (piece, _) = self.piece_at(base, start, 0);
            let is_known = self.bytes.known.iter().any(|(known, _)| *known == piece);
            if piece.bytes != 1 || is_known || self.bytes.waiting.iter().any(|waiting| waiting.piece == piece) {
                continue;
            }
            let behind = 8 * (first + count - 1 - start);
            let byte = match value {
                Val::Const(value) => self.constant((value >> behind) as u32 & 0xFF),
                value => {
                    let value = self.int(value);
                    let moved = if behind == 0 { value } else { self.b.ins().ushr_imm_u(value, i64::from(behind)) };
                    self.b.ins().band_imm_u(moved, 0xFF)
                }
            };
            self.remember(piece, byte);
        }
    }

    fn store_bits(&mut self, waiting: DeferredBits) {
        let new = self.with_waiting_bits(waiting);
        let piece = waiting.piece;
        let base = self.address_of_base(piece.base);
        match piece.bytes {
            LONG => self.b.ins().store(little(), new, base, piece.start),
            _ => self.b.ins().istore8(data(), new, base, piece.start),
        };
        self.remember(piece, new);
    }

    /// A piece with the bits that wait for their store.
    fn with_waiting_bits(&mut self, waiting: DeferredBits) -> Value {
        let DeferredBits { piece, mask, ones, bits, .. } = waiting;
        let others = piece.mask() & !mask & !self.needless_bits(piece);
        let kept = match others {
            0 => None,
            _ => {
                let old = self.bits_at(piece);
                Some(if mask == ones { old } else { self.masked(old, others) })
            }
        };
        let new = match (kept, bits) {
            (Some(kept), Some(bits)) => self.b.ins().bor(kept, bits),
            (Some(value), None) | (None, Some(value)) => value,
            (None, None) => self.constant(0),
        };
        if ones == 0 { new } else { self.b.ins().bor_imm_u(new, i64::from(ones)) }
    }

    /// The bits of a piece that nobody needs: those beside one in local data that stands alone in its byte and that nobody sees.
    fn needless_bits(&self, piece: PackedWord) -> u32 {
        if piece.base != Base::Local || !self.options.forgets_locals || self.options.exact {
            return 0;
        }
        let needless = |byte: i32| {
            let in_block = |(index, first): (usize, i32)| {
                let block = &self.blocks[index];
                let at = u32::try_from(piece.start + byte - first).ok().filter(|&at| at < block.local_size)?;
                block.single_bit_in(at).map(|bit| 0xFF & !(1_u32 << (bit % 8)))
            };
            let callers = self.outer.iter().map(|outer| {
                let (index, .., first) = outer.call();
                (index, first)
            });
            callers.chain([(self.index, self.local_offset)]).find_map(in_block).map_or(0, |bits| bits << (8 * byte))
        };
        (0..piece.bytes).fold(0, |all, byte| all | needless(byte))
    }

    fn store_waiting_in(&mut self, base: Value, offset: i32, width: Width) {
        let (bytes, base) = (offset..offset + width.bytes() as i32, self.known_base(base));
        while let Some(index) = self.bytes.waiting.iter().position(|waiting| waiting.piece.meets(base, &bytes)) {
            let waiting = self.bytes.waiting.remove(index);
            self.store_bits(waiting);
        }
        self.store_waiting_words_in(base, &bytes);
    }

    /// Stores bits that wait and forgets what is known in bytes that are written otherwise.
    pub(super) fn forget_bits_in(&mut self, Address { base, offset, .. }: Address, width: Width) {
        self.store_waiting_in(base, offset, width);
        let (written, base) = (offset..offset + width.bytes() as i32, self.known_base(base));
        self.bytes.known.retain(|(piece, _)| !piece.meets(base, &written));
        self.bytes.numbers.forget(base, &written);
    }

    /// Stores what waits in some bytes that are read or written otherwise, and forgets what is known there if they are written.
    pub(super) fn settle_touched(&mut self, (base, bytes): &(Base, Range<i64>), written: bool) {
        let (Ok(start), Ok(end)) = (i32::try_from(bytes.start), i32::try_from(bytes.end)) else { return self.settle_bytes() };
        let (base, bytes) = (*base, start..end);
        while let Some(index) = self.bytes.waiting.iter().position(|waiting| waiting.piece.meets(base, &bytes)) {
            let waiting = self.bytes.waiting.remove(index);
            self.store_bits(waiting);
        }
        self.store_waiting_words_in(base, &bytes);
        if written {
            self.bytes.known.retain(|(piece, _)| !piece.meets(base, &bytes));
            self.bytes.numbers.forget(base, &bytes);
        }
    }

    /// Whether anything waits.
    pub(super) fn anything_waits(&self) -> bool {
        !self.bytes.waiting.is_empty() || self.words_wait()
    }

    /// Drops what waits for its store in local data of blocks that have ended, if no block of the program can see it there.
    pub(super) fn drop_what_waits_behind(&mut self) {
        if self.options.forgets_locals && !self.options.exact {
            let end = self.local_behind() as i32;
            self.drop_local(|at| at >= end);
            self.forget_words_behind_block();
        }
    }

    /// Drops what waits for its store in local data that nobody needs behind the running statement, if the instructions left in it do not.
    pub(super) fn drop_what_was_handed(&mut self, left: &[Inst]) {
        let ends = left.iter().all(|inst| matches!(inst, Inst::Jump { .. }));
        if self.options.forgets_locals && !self.options.exact && ends && !self.native().handed.is_empty() {
            let (block, first) = (&self.blocks[self.index], self.local_offset);
            self.drop_local(|at| block.is_handed(at - first, 1));
        }
    }

    /// Drops what waits for its store in bytes of local data, and forgets it.
    fn drop_local(&mut self, is_dropped: impl Fn(i32) -> bool) {
        self.bytes.waiting.retain(|waiting| {
            let piece = waiting.piece;
            piece.base != Base::Local || !(piece.start..piece.start + piece.bytes).all(&is_dropped)
        });
        self.drop_words(is_dropped);
    }

    /// Stores what waits: somebody may look at memory from here on, or other code goes on.
    pub(super) fn store_waiting(&mut self) {
        for waiting in std::mem::take(&mut self.bytes.waiting) {
            self.store_bits(waiting);
        }
        self.store_waiting_words();
    }

    /// Stores what waits and forgets what is known: somebody may look at memory or change it.
    pub(super) fn settle_bytes(&mut self) {
        self.store_waiting();
        self.bytes.known.clear();
        self.bytes.numbers.clear();
        self.forget_words_behind_block();
    }

    /// The same, where somebody was asked: time may have gone on, too.
    pub(super) fn forget_what_was_asked(&mut self) {
        self.settle_bytes();
        self.fresh_timers.clear();
        self.counts.clear();
        self.items = [None; 2];
    }

    /// What is known of memory in the running piece of code, in which nothing waits.
    pub(super) fn known_memory(&self) -> AvailableMemory {
        match self.cold {
            None => self.known_memory_here(),
            // Somebody was asked.
            Some(_) => AvailableMemory::default(),
        }
    }

    /// The same, on a way as well on which somebody was asked who changes nothing.
    pub(super) fn known_memory_here(&self) -> AvailableMemory {
        AvailableMemory {
            bits: self.bytes.known.clone(),
            numbers: self.bytes.numbers.clone(),
            words: self.words.clone(),
            elements: self.elements.clone(),
            timers: self.fresh_timers.clone(),
            counts: self.counts.clone(),
            items: self.items,
        }
    }

    /// Knows of memory what was known before a loop and holds in all of its iterations.
    pub(super) fn know_in_loop(&mut self, it: &NaturalLoop, known: AvailableMemory) {
        self.words = self.words_in_loop(it, known.words);
    }

    /// Knows of memory what is known on all ways to a place.
    pub(super) fn know_memory(&mut self, known: AvailableMemory) {
        (self.bytes.known, self.bytes.numbers, self.words) = (known.bits, known.numbers, known.words);
        self.elements = known.elements;
        (self.fresh_timers, self.counts, self.items) = (known.timers, known.counts, known.items);
    }
}
