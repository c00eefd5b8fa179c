//! Bytes that are known when the program is compiled: initial values, literals.

use sieben_engine::ir::{Inst, Place};
use sieben_model::address::{Area, Width};

use super::{Lowering, width_of_bits};
use crate::st::tree::Local;

/// Zeros from this length on are spread by moves instead of being stored one by one.
const SPREAD_BYTES: usize = 64;

impl Lowering<'_> {
    /// Gives a local variable its initial value.
    pub(super) fn initialize(&mut self, local: &Local, initial: &[u8]) {
        let bits = local.data_type.bits();
        if matches!(bits, 1 | 8 | 16 | 32 | 64) {
            let value = initial.iter().take(8).fold(0_u64, |value, &byte| value << 8 | u64::from(byte));
            let value = self.constant(value);
            self.store_local(local.position, width_of_bits(bits as u32), value);
            return;
        }
        self.store_bytes(local.position, initial);
    }

    /// Stores bytes in the local data, beginning at a position in bits.
    pub(super) fn store_bytes(&mut self, position: u32, bytes: &[u8]) {
        let mut at = 0;
        while at < bytes.len() {
            let zeros = bytes[at..].iter().take_while(|&&byte| byte == 0).count();
            if zeros >= SPREAD_BYTES {
                self.spread_zeros(position + 8 * at as u32, zeros as u32);
                at += zeros;
                continue;
            }
            let width = match bytes.len() - at {
                8.. => Width::QuadWord,
                4.. => Width::DoubleWord,
                2.. => Width::Word,
                _ => Width::Byte,
            };
            let end = at + width.bytes() as usize;
            let value = bytes[at..end].iter().fold(0_u64, |value, &byte| value << 8 | u64::from(byte));
            let value = self.constant(value);
            self.store_local(position + 8 * at as u32, width, value);
            at = end;
        }
    }

    /// Clears bytes of the local data: eight by a store, then twice as many with each move.
    fn spread_zeros(&mut self, position: u32, bytes: u32) {
        let zero = self.constant(0);
        self.store_local(position, Width::QuadWord, zero);
        let at = |done: u32| Place::Fixed { area: Area::Local, position: position + 8 * done };
        let mut done = 8;
        while done < bytes {
            let next = done.min(bytes - done);
            self.push(Inst::Move { from: at(0), to: at(done), bytes: next });
            done += next;
        }
    }
}
