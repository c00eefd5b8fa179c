//! Bytes at addresses known beforehand, along straight code: bits written to one byte become one store, and a byte that was read is
//! not read again. Nothing waits and nothing is remembered where somebody else may look at memory or change it, nor where code meets.

use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_model::address::Width;

use super::Translator;
use super::memory::{Address, Bit, data};
use super::value::Val;

/// Bytes whose new bits wait for their store. More would keep registers that the logic needs.
const WAITING_MAX: usize = 4;
/// Bytes whose value is remembered; a value that nobody reads again costs nothing.
const KNOWN_MAX: usize = 12;

/// What is known of bytes of memory between two places where it must be as the program left it.
#[derive(Debug)]
pub(super) struct Bytes {
    waiting_max: usize,
    waiting: Vec<Waiting>,
    /// Values of bytes in memory, by address, the oldest first. Bits that wait for their store are old here.
    known: Vec<(Value, i32, Value)>,
}

/// Bits of one byte that wait for their store.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    base: Value,
    offset: i32,
    /// The bits that were written.
    mask: u8,
    /// Of them those that are 1 whatever happens.
    ones: u8,
    /// Of them the others, in 32 bits; bits that were not written are 0. `None` = all 0.
    bits: Option<Value>,
}

impl Bytes {
    /// Whether bits of one byte are written with one store.
    pub(super) fn new(joins: bool) -> Self {
        Self { waiting_max: if joins { WAITING_MAX } else { 0 }, waiting: Vec::new(), known: Vec::new() }
    }
}

impl Waiting {
    fn is_at(&self, base: Value, offset: i32) -> bool {
        self.base == base && self.offset == offset
    }
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
            if let Some(value) = self.known_word(address, width) {
                return value;
            }
            self.store_waiting_in(base, offset, width);
            let value = self.read(address, width);
            self.remember_word(address, width, value);
            return value;
        };
        if let Some(waiting) = self.bytes.waiting.iter().find(|waiting| waiting.is_at(base, offset))
            && waiting.mask & 1 << number != 0
        {
            return match waiting.bits {
                _ if waiting.ones & 1 << number != 0 => Val::Const(1),
                Some(bits) => Self::bit_value(bits, number, false),
                None => Val::Const(0),
            };
        }
        let byte = self.byte_at(base, offset);
        Self::bit_value(byte, number, false)
    }

    /// Writes to an address that is known to be there.
    pub(super) fn write_known(&mut self, address: Address, width: Width, value: Val) {
        if self.write_promoted(address, width, value) {
            return;
        }
        self.forget_word(address, width);
        if self.store_touched_at(address, width) {
            self.settle_bytes();
            self.write(address, width, value);
            self.take_touched_at(address, width);
            return;
        }
        let Address { base, offset, bit } = address;
        let (Width::Bit, Bit::Number(number)) = (width, bit) else {
            self.store_waiting_in(base, offset, width);
            let end = offset + width.bytes() as i32;
            self.bytes.known.retain(|&(other, at, _)| other != base || !(offset..end).contains(&at));
            self.write(address, width, value);
            self.remember_word(address, width, value);
            return;
        };
        let value = self.force(value);
        let mut waiting = match self.bytes.waiting.iter().position(|waiting| waiting.is_at(base, offset)) {
            Some(index) => self.bytes.waiting.remove(index),
            None => Waiting { base, offset, mask: 0, ones: 0, bits: None },
        };
        let bit = 1u8 << number;
        if waiting.mask & bit != 0 {
            waiting.ones &= !bit;
            waiting.bits = waiting.bits.map(|bits| self.b.ins().band_imm_u(bits, i64::from(!bit)));
        }
        waiting.mask |= bit;
        match value {
            Val::Const(value) if value & 1 != 0 => waiting.ones |= bit,
            Val::Const(_) => {}
            value => {
                let new = self.bit_at(value, number);
                waiting.bits = Some(match waiting.bits {
                    Some(bits) => self.b.ins().bor(bits, new),
                    None => new,
                });
            }
        }
        self.bytes.waiting.push(waiting);
        if self.bytes.waiting.len() > self.bytes.waiting_max {
            let oldest = self.bytes.waiting.remove(0);
            self.store_bits(oldest);
        }
    }

    /// A byte as it is in memory, in 32 bits.
    fn byte_at(&mut self, base: Value, offset: i32) -> Value {
        if let Some(&(.., byte)) = self.bytes.known.iter().find(|&&(other, at, _)| other == base && at == offset) {
            return byte;
        }
        let byte = self.b.ins().uload8(I32, data(), base, offset);
        self.remember(base, offset, byte);
        byte
    }

    fn remember(&mut self, base: Value, offset: i32, byte: Value) {
        self.bytes.known.retain(|&(other, at, _)| other != base || at != offset);
        if self.bytes.known.len() >= KNOWN_MAX {
            self.bytes.known.remove(0);
        }
        self.bytes.known.push((base, offset, byte));
    }

    fn store_bits(&mut self, Waiting { base, offset, mask, ones, bits }: Waiting) {
        let kept = match mask {
            u8::MAX => None,
            _ => {
                let old = self.byte_at(base, offset);
                Some(if mask == ones { old } else { self.b.ins().band_imm_u(old, i64::from(!mask)) })
            }
        };
        let new = match (kept, bits) {
            (Some(kept), Some(bits)) => self.b.ins().bor(kept, bits),
            (Some(value), None) | (None, Some(value)) => value,
            (None, None) => self.b.ins().iconst(I32, 0),
        };
        let new = if ones == 0 { new } else { self.b.ins().bor_imm_u(new, i64::from(ones)) };
        self.b.ins().istore8(data(), new, base, offset);
        self.remember(base, offset, new);
    }

    fn store_waiting_in(&mut self, base: Value, offset: i32, width: Width) {
        let end = offset + width.bytes() as i32;
        while let Some(index) =
            self.bytes.waiting.iter().position(|waiting| waiting.base == base && (offset..end).contains(&waiting.offset))
        {
            let waiting = self.bytes.waiting.remove(index);
            self.store_bits(waiting);
        }
    }

    /// Stores what waits and forgets what is known: somebody may look at memory or change it from here on, or other code goes on.
    pub(super) fn settle_bytes(&mut self) {
        for waiting in std::mem::take(&mut self.bytes.waiting) {
            self.store_bits(waiting);
        }
        self.bytes.known.clear();
        self.forget_words_behind_block();
    }
}
