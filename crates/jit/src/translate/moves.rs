//! Inlined copies of bytes, in as few loads and stores as possible.

use cranelift_codegen::ir::types::{I8, I8X16, I16, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Type, Value};

use super::Translator;
use super::memory::{Address, data};

/// Longer moves are left to Rust code, which takes little time for each byte.
pub(super) const MOVED_BYTES_MAX: u32 = 256;

impl Translator<'_> {
    /// Reads bytes that are there, as few pieces as possible.
    pub(super) fn pieces(&mut self, from: Address, bytes: u32) -> Vec<Value> {
        self.pieces_by(from, bytes, |_, _, _| None)
    }

    /// The same where everything that writes local data says so: what is known there is not read.
    pub(super) fn known_pieces(&mut self, from: Address, bytes: u32) -> Vec<Value> {
        self.pieces_by(from, bytes, Self::constant_piece)
    }

    fn pieces_by(&mut self, from: Address, bytes: u32, known: impl Fn(&mut Self, Address, Type) -> Option<Value>) -> Vec<Value> {
        let mut pieces = Vec::new();
        let mut at = 0;
        while at < bytes as i32 {
            let left = bytes as i32 - at;
            let ty = [(16, I8X16), (8, I64), (4, I32), (2, I16)].into_iter().find(|&(size, _)| size <= left).map_or(I8, |(_, ty)| ty);
            let address = Address { offset: from.offset + at, ..from };
            let piece = known(self, address, ty).unwrap_or_else(|| self.b.ins().load(ty, data(), address.base, address.offset));
            pieces.push(piece);
            at += ty.bytes() as i32;
        }
        pieces
    }

    /// What is known to be in local data: to read it would wait for the stores of its parts.
    fn constant_piece(&mut self, Address { base, offset, .. }: Address, ty: Type) -> Option<Value> {
        if base != self.local || !self.options.optimize || self.cold.is_some() {
            return None;
        }
        let bytes = self.constant_bytes(offset, ty.bytes())?;
        if ty.is_vector() {
            let constant = self.b.func.dfg.constants.insert(bytes.into());
            return Some(self.b.ins().vconst(ty, constant));
        }
        Some(self.constant_of_bytes(&bytes, ty))
    }

    /// What a load of these bytes gives.
    pub(super) fn constant_of_bytes(&mut self, bytes: &[u8], ty: Type) -> Value {
        let number = bytes.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte));
        self.b.ins().iconst(ty, number as i64)
    }

    /// Writes pieces one behind the other.
    pub(super) fn write_pieces(&mut self, to: Address, pieces: &[Value]) {
        let mut at = to.offset;
        for &piece in pieces {
            self.b.ins().store(data(), piece, to.base, at);
            at += self.b.func.dfg.value_type(piece).bytes() as i32;
        }
    }
}
