//! Numbers in local data: what was written there or read is not read again.
//!
//! Nothing of it is lost where somebody is asked, nor over calls: nobody but the block, and blocks that get a pointer from it, reaches
//! its local data. Other memory may be changed then, and remembering it until then costs more registers than it spares loads.

use sieben_engine::ir::{Callee, Inst, Place};
use sieben_model::address::{Area, Width};

use super::Translator;
use super::loops::Loop;
use super::memory::{Address, Bit};
use super::value::Val;

/// Numbers that are remembered, the newest ones: more would keep registers that the code needs.
const KNOWN_MAX: usize = 12;

/// What is known of numbers in local data.
#[derive(Clone, Debug, Default)]
pub(super) struct Words {
    /// Offset behind the local data of the function's outermost block, width, and the value as a load would have it. No two overlap.
    known: Vec<(i32, Width, Val)>,
}

impl Words {
    /// What is known to be a constant.
    pub(super) fn constants(&self) -> Vec<(i32, Width, u64)> {
        let constants = self.known.iter().filter_map(|&(offset, width, value)| Some((offset, width, value.constant()?)));
        constants.filter(|&(_, width, _)| width != Width::QuadWord).collect()
    }

    /// Keeps what others know, too.
    pub(super) fn keep_common(&mut self, other: &Self) {
        self.known.retain(|known| other.known.contains(known));
    }

    /// Forgets everything: anything may have been written.
    pub(super) fn forget_all(&mut self) {
        self.known.clear();
    }
}

impl Translator<'_> {
    /// The number at an address, if it is known.
    pub(super) fn known_word(&self, address: Address, width: Width) -> Option<Val> {
        let is_it = |&&(offset, other, _): &&(i32, Width, Val)| (offset, other) == (address.offset, width);
        self.words.known.iter().find(is_it).filter(|_| address.base == self.local).map(|&(.., value)| value)
    }

    /// The constant at an offset behind the local data of the function's outermost block, if one is known to be there.
    pub(super) fn constant_word(&self, offset: i32, width: Width) -> Option<u64> {
        let address = Address { base: self.local, offset, bit: Bit::Number(0) };
        self.known_word(address, width)?.constant()
    }

    /// What is still known where a loop begins: constants that none of its turns writes.
    pub(super) fn words_in_loop(&self, it: &Loop, mut words: Words) -> Words {
        let end = self.local_behind() as i32;
        words.known.retain(|&(at, width, value)| value.constant().is_some() && at + width.bytes() as i32 <= end);
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
                        return Words::default();
                    }
                }
                Inst::Store { .. } | Inst::Move { .. } | Inst::Text { .. } | Inst::Call { .. } => return Words::default(),
                _ => {}
            }
        }
        words
    }

    /// Remembers what was read or written at an address.
    pub(super) fn remember_word(&mut self, address: Address, width: Width, value: Val) {
        self.forget_word(address, width);
        if width == Width::Bit || !self.options.optimize || address.base != self.local {
            return;
        }
        let bits = width.bytes() * 8;
        let value = match (self.force(value), width) {
            (Val::Const(value), _) if bits < 64 => Val::Const(value & ((1 << bits) - 1)),
            (Val::Const(value), _) => Val::Const(value),
            (value, Width::QuadWord) => Val::Word(self.word(value)),
            (value @ (Val::Word(_) | Val::Bit { .. } | Val::At { .. }), Width::DoubleWord) => Val::Int(self.int(value)),
            (value, Width::DoubleWord) => value,
            (value, _) => Val::Int(self.low_bits(value, width)),
        };
        if self.words.known.len() == KNOWN_MAX {
            self.words.known.remove(0);
        }
        self.words.known.push((address.offset, width, value));
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

    /// Forgets all memory: anything may have been written.
    pub(super) fn forget_memory(&mut self) {
        self.forget_what_was_asked();
        self.words.forget_all();
    }

    /// Forgets what an instruction may have written at an address that is not known beforehand.
    pub(super) fn forget_words_behind(&mut self, inst: &Inst) {
        let anywhere = match *inst {
            Inst::Store { place: Place::Indirect { area: Area::Local, pointer, .. } | Place::Crossing { pointer, .. }, .. } => {
                self.get(pointer).constant().is_none()
            }
            Inst::Move { .. } => true,
            _ => false,
        };
        if anywhere {
            self.words.forget_all();
        }
    }
}
