//! Memory to registers: numbers in local data are values. What was stored there or loaded is not loaded again, and a store that is
//! overwritten before an observer can look is dropped; so is that of other numbers that a block writes more than once.
//!
//! Available values of local data survive runtime calls and calls: only the block, and blocks that get a pointer from it, reach its local
//! data. Other memory may be changed then, and keeping its values until then costs more registers than it saves loads.

use std::ops::Range;

use cranelift_codegen::ir::InstBuilder;
use cranelift_codegen::ir::types::I32;
use sieben_engine::ir::{Callee, Inst, Place};
use sieben_model::address::{Area, Width};

use super::Translator;
use super::inlining::InlineFrame;
use super::memory::{Address, Bit};
use super::natural_loops::NaturalLoop;
use super::scalar_promotion::Base;
use super::value::Val;
use crate::passes::Pass;

/// Numbers that are remembered, the newest ones: more would keep registers that the code needs.
const KNOWN_MAX: usize = 12;
/// Numbers that wait for their store.
const WAITING_MAX: usize = 16;

/// What is known of numbers in local data.
#[derive(Clone, Debug, Default)]
pub(super) struct LocalValues {
    /// Offset behind the local data of the function's outermost block, width, and the value as a load would have it; `None` = what a
    /// variable holds where ways meet. No two overlap.
    known: Vec<(i32, Width, Option<Val>)>,
}

/// Numbers that wait for their store, the oldest first: base, offset, width and value. No two overlap, nor does one overlap a bit that
/// waits.
#[derive(Debug, Default)]
pub(super) struct DeferredStores(Vec<(Base, i32, Width, Val)>);

impl LocalValues {
    /// What is known to be a constant.
    pub(super) fn constants(&self) -> Vec<(i32, Width, u64)> {
        let constants = self.known.iter().filter_map(|&(offset, width, value)| Some((offset, width, value?.constant()?)));
        constants.filter(|&(_, width, _)| width != Width::QuadWord).collect()
    }

    /// Keeps what is known on another way, too, where both meet: a variable holds what is not the same.
    pub(super) fn meet(&mut self, other: &Self) {
        self.known.retain_mut(|(offset, width, value)| {
            let other = other.known.iter().find(|(at, wide, _)| (at, wide) == (&*offset, &*width));
            other.is_some_and(|&(.., other)| {
                *value = value.filter(|&value| Some(value) == other);
                value.is_some() || *width != Width::QuadWord
            })
        });
    }

    /// Forgets everything: anything may have been written.
    pub(super) fn forget_all(&mut self) {
        self.known.clear();
    }
}

impl Translator<'_> {
    /// The number at an address, if it is known.
    pub(super) fn known_word(&self, address: Address, width: Width) -> Option<Val> {
        self.words.known[self.place_of_word(address, width)?].2
    }

    /// The number in local data that lies around a place, if one is known.
    pub(super) fn word_around(&self, is_around: impl Fn(i32, Width) -> bool) -> Option<(i32, Width, Val)> {
        self.words.known.iter().find_map(|&(at, width, value)| Some((at, width, value.filter(|_| is_around(at, width))?)))
    }

    /// Where the number at an address is noted.
    fn place_of_word(&self, address: Address, width: Width) -> Option<usize> {
        let is_it = |&(offset, other, _): &(i32, Width, Option<Val>)| (offset, other) == (address.offset, width);
        self.words.known.iter().position(is_it).filter(|_| address.base == self.local)
    }

    /// The number at an address, if it is known or a variable holds it.
    pub(super) fn word_at(&mut self, address: Address, width: Width) -> Option<Val> {
        let at = self.place_of_word(address, width)?;
        if self.words.known[at].2.is_none() {
            let &variable = self.met.get(&(address.offset, width))?;
            let value = self.b.use_var(variable);
            self.narrow.insert(value, width.bytes() * 8);
            self.words.known[at].2 = Some(Val::Int(value));
        }
        self.words.known[at].2
    }

    /// Lets variables hold what is known of local data, and of bits, before a place where ways meet.
    pub(super) fn hold_what_is_known(&mut self) {
        for (offset, width, value) in self.words.known.clone() {
            let Some(value) = value.filter(|_| width != Width::QuadWord) else { continue };
            let value = match value {
                Val::Const(value) => self.b.ins().iconst(I32, i64::from(value as u32)),
                value => self.int(value),
            };
            let b = &mut self.b;
            let variable = *self.met.entry((offset, width)).or_insert_with(|| b.declare_var(I32));
            b.def_var(variable, value);
        }
        self.hold_bits();
    }

    /// The constant at an offset behind the local data of the function's outermost block, if one is known to be there.
    pub(super) fn constant_word(&self, offset: i32, width: Width) -> Option<u64> {
        let address = Address { base: self.local, offset, bit: Bit::Number(0) };
        self.known_word(address, width)?.constant()
    }

    /// The constants that are known to be at an offset, one behind the other, as bytes.
    pub(super) fn constant_bytes(&self, offset: i32, count: u32) -> Option<Vec<u8>> {
        (offset..offset + count as i32)
            .map(|at| {
                let holds = |&&(first, width, _): &&(i32, Width, Option<Val>)| (first..first + width.bytes() as i32).contains(&at);
                let &(first, width, value) = self.words.known.iter().find(holds)?;
                let behind = first + width.bytes() as i32 - 1 - at;
                Some((value?.constant()? >> (8 * behind)) as u8)
            })
            .collect()
    }

    /// What is still known where a loop begins: constants that none of its iterations writes.
    pub(super) fn words_in_loop(&self, it: &NaturalLoop, mut words: LocalValues) -> LocalValues {
        let end = self.local_behind() as i32;
        words.known.retain(|&(at, width, value)| value.is_some_and(|value| value.constant().is_some()) && at + width.bytes() as i32 <= end);
        let code = &self.native().code;
        for inst in (it.first..=it.last).flat_map(|statement| code.statement(statement as usize)) {
            match *inst {
                Inst::Store { place: Place::Fixed { area: Area::Local, position }, width, .. } => {
                    let first = self.local_offset + (position / 8) as i32;
                    words.known.retain(|&(at, known, _)| at >= first + width.bytes() as i32 || at + known.bytes() as i32 <= first);
                }
                Inst::Store { place: Place::Fixed { .. }, .. } => {}
                Inst::Store { place: Place::Indirect { area, .. }, .. } if area != Area::Local => {}
                Inst::Call { callee: Callee::Block(id), .. } => {
                    let outwards = (self.find)(id).is_none_or(|code| self.pointers[code as usize].writes_outwards);
                    if outwards {
                        return LocalValues::default();
                    }
                }
                Inst::Store { .. } | Inst::Move { .. } | Inst::Text { .. } | Inst::Call { .. } => return LocalValues::default(),
                _ => {}
            }
        }
        words
    }

    /// Remembers what was read or written at an address.
    pub(super) fn remember_word(&mut self, address: Address, width: Width, value: Val) {
        self.forget_word(address, width);
        if width == Width::Bit || !self.options.does(Pass::MemoryToRegister) || address.base != self.local {
            return;
        }
        let value = self.as_read_there(width, value);
        self.know_word(address, width, value);
    }

    /// A number as a load of this width would have it.
    pub(super) fn as_read_there(&mut self, width: Width, value: Val) -> Val {
        let bits = width.bytes() * 8;
        match (self.force(value), width) {
            (Val::Const(value), _) if bits < 64 => Val::Const(value & ((1 << bits) - 1)),
            (Val::Const(value), _) => Val::Const(value),
            (value @ Val::Lreal { .. }, Width::QuadWord) => value,
            (value, Width::QuadWord) => Val::Word(self.word(value)),
            (value @ (Val::Word(_) | Val::Lreal { .. } | Val::Bit { .. } | Val::At { .. }), Width::DoubleWord) => Val::Int(self.int(value)),
            (value, Width::DoubleWord) => value,
            (value, _) => Val::Int(self.low_bits(value, width)),
        }
    }

    fn know_word(&mut self, address: Address, width: Width, value: Val) {
        if self.words.known.len() == KNOWN_MAX {
            self.words.known.remove(0);
        }
        self.words.known.push((address.offset, width, Some(value)));
    }

    /// Writes a number to an address that is known to be there. In local data it waits for its store, and so does what is written more than
    /// once elsewhere.
    pub(super) fn write_number(&mut self, address: Address, width: Width, value: Val) {
        let base = self.known_base(address.base);
        let waits = match base {
            Base::Local => true,
            Base::Arena => self.cold.is_none() && self.bytes.is_written_again(address.offset),
            Base::Run | Base::Spaced(_) | Base::Computed(_) => false,
        };
        if !self.options.does(Pass::MemoryToRegister) || !waits {
            self.forget_bits_in(address, width);
            self.write(address, width, value);
            return self.remember_number(address, width, value);
        }
        let value = self.force(value);
        let known = self.as_read_there(width, value);
        if self.known_word(address, width).or_else(|| self.known_number(address, width)) == Some(known) {
            // It is there already, or waits.
            return;
        }
        self.forget_word(address, width);
        let (start, end) = (address.offset, address.offset + width.bytes() as i32);
        self.bytes.words.0.retain(|&(own, at, width, _)| own != base || at < start || at + width.bytes() as i32 > end);
        self.forget_bits_in(address, width);
        if base == Base::Local {
            self.know_word(address, width, known);
        } else {
            self.remember_number(address, width, value);
        }
        self.bytes.words.0.push((base, address.offset, width, value));
        if self.bytes.words.0.len() > WAITING_MAX {
            let oldest = self.bytes.words.0.remove(0);
            self.store_word_that_waited(oldest);
        }
    }

    fn store_word_that_waited(&mut self, (base, offset, width, value): (Base, i32, Width, Val)) {
        let base = self.address_of_base(base);
        self.write(Address { base, offset, bit: Bit::Number(0) }, width, value);
    }

    /// Whether a number waits for its store.
    pub(super) fn words_wait(&self) -> bool {
        !self.bytes.words.0.is_empty()
    }

    /// Drops numbers in local data that wait and begin at some offsets: memory does not hold what is known of them.
    pub(super) fn drop_words(&mut self, is_dropped: impl Fn(i32) -> bool) {
        let dropped = self.bytes.words.0.extract_if(.., |&mut (base, at, ..)| base == Base::Local && is_dropped(at));
        let bytes = dropped.map(|(base, at, width, _)| (base, i64::from(at)..i64::from(at) + i64::from(width.bytes())));
        bytes.collect::<Vec<_>>().iter().for_each(|bytes| self.forget_words_in(bytes));
    }

    /// Stores numbers that wait.
    pub(super) fn store_waiting_words(&mut self) {
        for waiting in std::mem::take(&mut self.bytes.words.0) {
            self.store_word_that_waited(waiting);
        }
    }

    /// Stores numbers that wait and share bytes with these.
    pub(super) fn store_waiting_words_in(&mut self, base: Base, bytes: &Range<i32>) {
        let bytes = i64::from(bytes.start)..i64::from(bytes.end);
        let meets = |&(own, at, width, _): &(Base, i32, Width, Val)| {
            own.may_share(&(i64::from(at)..i64::from(at) + i64::from(width.bytes())), base, &bytes)
        };
        while let Some(index) = self.bytes.words.0.iter().position(meets) {
            let waiting = self.bytes.words.0.remove(index);
            self.store_word_that_waited(waiting);
        }
    }

    /// Drops what the caller has handed to the running block through its local data and waits for its store there, if the rest of the block
    /// does not read it, nor does the rest of the caller's statement.
    pub(super) fn drop_what_was_taken(&mut self) {
        if !self.words_wait() || !self.options.forgets_locals || self.options.exact {
            return;
        }
        let Some((caller, statement, call, first)) = self.outer.last().map(InlineFrame::call) else { return };
        let (caller, own) = (&self.blocks[caller], &self.native().code);
        // Nothing waits any more where a loop begins that reads it.
        let left = &own.insts[own.statements[self.statement as usize] as usize..];
        let takes_more = |inst: &Inst| match inst {
            Inst::Load { place, .. } => !matches!(place, Place::Fixed { .. } | Place::Indirect { .. }),
            Inst::Move { .. } | Inst::Text { .. } | Inst::Call { .. } | Inst::PassParameter { .. } => true,
            _ => false,
        };
        if caller.handed.is_empty() || left.iter().any(takes_more) {
            return;
        }
        let end = caller.code.statements[statement as usize + 1] as usize;
        let behind = &caller.code.insts[call as usize + 1..end];
        let is_needed = |at: u32| {
            let Some(piece) = caller.handed.iter().find(|piece| piece.contains(&at)) else { return true };
            let bits = piece.start * 8..piece.end * 8;
            behind.iter().any(|inst| match *inst {
                Inst::Load { place: Place::Fixed { area: Area::Local, position }, .. } => bits.contains(&position),
                Inst::Load { place: Place::Fixed { .. }, .. } => false,
                Inst::Load { place: Place::Indirect { area, .. }, .. } => area == Area::Local,
                Inst::Constant { value, .. } => bits.contains(&(value as u32 & 0x00FF_FFFF)),
                Inst::Load { .. } | Inst::Move { .. } | Inst::Text { .. } | Inst::Call { .. } => true,
                _ => false,
            })
        };
        self.drop_words(|at| u32::try_from(at - first).is_ok_and(|at| !is_needed(at)));
    }

    /// Forgets what overlaps an address that is written.
    pub(super) fn forget_word(&mut self, address: Address, width: Width) {
        if address.base == self.local {
            let (offset, end) = (address.offset, address.offset + width.bytes() as i32);
            self.words.known.retain(|&(at, width, _)| at >= end || at + width.bytes() as i32 <= offset);
        }
    }

    /// Forgets what an interrupt or a called block may change: what lies behind the local data of the present block.
    pub(super) fn forget_words_behind_block(&mut self) {
        let end = self.local_behind() as i32;
        self.words.known.retain(|&(at, width, _)| at + width.bytes() as i32 <= end);
    }

    /// Forgets what overlaps some bytes that are written.
    pub(super) fn forget_words_in(&mut self, (base, bytes): &(Base, Range<i64>)) {
        if *base == Base::Local {
            let apart = |at: i32, width: Width| i64::from(at) >= bytes.end || i64::from(at) + i64::from(width.bytes()) <= bytes.start;
            self.words.known.retain(|&(at, width, _)| apart(at, width));
        }
    }

    /// Forgets all memory: anything may have been written.
    pub(super) fn forget_memory(&mut self) {
        self.forget_what_was_asked();
        self.words.forget_all();
        self.elements.clear();
    }

    /// Forgets what an instruction may have written at an address that is not known beforehand.
    pub(super) fn forget_words_behind(&mut self, index: u32, inst: &Inst) {
        let anywhere = match *inst {
            // What is known of the pointer says where.
            Inst::Store { place: Place::Crossing { .. }, .. } if let Some(touched) = self.ranges.inside(index) => {
                self.forget_words_in(&touched);
                false
            }
            Inst::Store { place: Place::Indirect { area: Area::Local, pointer, .. } | Place::Crossing { pointer, .. }, .. } => {
                self.get(pointer).constant().is_none()
            }
            Inst::Move { .. } => match self.ranges.moved(index) {
                Some([_, touched]) => {
                    self.forget_words_in(&touched);
                    false
                }
                None => true,
            },
            _ => false,
        };
        if anywhere {
            self.words.forget_all();
        }
    }
}
