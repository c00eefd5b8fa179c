//! Bits that networks write one after the other to one piece of memory, each in a byte of the stack for as long as they wait for their
//! store: a network stores its result as it is, and one instruction puts sixteen of them together.
//!
//! Only where straight code writes enough of them: whoever puts them together pays for all that the piece has room for.

use cranelift_codegen::ir::types::{I8X16, I16X8, I32, I64};
use cranelift_codegen::ir::{Endianness, InstBuilder, MemFlagsData, StackSlot, StackSlotData, StackSlotKind, Value};
use sieben_engine::ir::{Inst, Op, Place, Target};
use sieben_model::address::Width;

use super::Translator;
use super::bytes::Piece;
use super::memory::data;
use super::promote::Base;
use super::value::Val;

/// Bits that are put together by one instruction.
const TOGETHER: u32 = 16;
/// Bits of a long piece from which on they wait apart: to put them together takes about as long as to add so many one
/// after the other.
const WRITTEN_MIN: u32 = 10;
/// The same of a byte.
const WRITTEN_MIN_OF_BYTE: u32 = 6;
/// Statements that are looked at to see how many bits they write.
const STATEMENTS_MAX: usize = 128;

impl Translator<'_> {
    /// Whether straight code from the running statement on writes so many bits to a piece, one by one, that they wait apart.
    pub(super) fn are_apart(&mut self, piece: Piece) -> bool {
        if !self.options.optimize || self.cold.is_some() {
            return false;
        }
        let code = &self.native().code;
        let first = self.statement as usize;
        let least = if piece.mask() == u32::MAX { WRITTEN_MIN } else { WRITTEN_MIN_OF_BYTE };
        let mut written = 0u32;
        for statement in first..code.statement_count().min(first + STATEMENTS_MAX) {
            if statement > first && self.arrivals.contains_key(&(statement as u32)) {
                break;
            }
            let insts = code.statement(statement);
            let goes_on = |inst: &Inst| match *inst {
                Inst::Branch { to: Target(to), .. } => to as usize == statement + 2,
                Inst::Jump { .. } | Inst::JumpTable { .. } | Inst::Call { .. } => false,
                _ => true,
            };
            if !insts.iter().all(goes_on) {
                break;
            }
            if !self.copies_with_neighbour(statement as u32)
                && let Some((_, at)) = self.written_in_piece(insts).filter(|&(own, _)| own == piece)
            {
                written |= 1 << at;
                if written.count_ones() >= least {
                    return true;
                }
            }
        }
        false
    }

    /// Whether a statement copies a bit, and the one in front of it or behind it its neighbour in both places: they go there together.
    pub(super) fn copies_with_neighbour(&self, statement: u32) -> bool {
        let Some((from, to)) = self.copied_bit(statement) else { return false };
        let goes_along = |statement: u32| {
            self.copied_bit(statement).is_some_and(|(other_from, other_to)| {
                let further = |one: (Base, i64), other: (Base, i64)| (one.0 == other.0).then(|| one.1 - other.1);
                further(other_from, from).is_some() && further(other_from, from) == further(other_to, to)
            })
        };
        goes_along(statement + 1) || statement > 0 && goes_along(statement - 1)
    }

    /// Where a statement copies a bit from and to, if it does nothing else: bits from the first one of their base, of one number at least.
    fn copied_bit(&self, statement: u32) -> Option<((Base, i64), (Base, i64))> {
        let code = &self.native().code;
        if statement as usize >= code.statement_count() {
            return None;
        }
        let [Inst::Load { place: from, width, .. }, between @ .., Inst::Store { place: to, width: Width::Bit, .. }] =
            code.statement(statement as usize)
        else {
            return None;
        };
        let bit = |place: Place| {
            let (base, offset) = self.constant_address(place, Width::Bit)?;
            Some((base, i64::from(offset) * 8 + i64::from(self.constant_position(place)?.1 % 8)))
        };
        let from = match (width, between) {
            (Width::Bit, []) => bit(*from)?,
            (Width::Bit, _) => return None,
            (width, between) => {
                let (base, offset) = self.constant_address(*from, *width)?;
                (base, i64::from(offset) * 8 + taken_bit(between)?)
            }
        };
        Some((from, bit(*to)?))
    }

    /// Bytes of the stack for the bits of a piece, beside those that are in use.
    pub(super) fn bytes_for_bits(&mut self, used: &[StackSlot]) -> StackSlot {
        if let Some(&slot) = self.slots_for_bits.iter().find(|slot| !used.contains(slot)) {
            return slot;
        }
        let slot = self.b.create_sized_stack_slot(StackSlotData::new(StackSlotKind::ExplicitSlot, u32::BITS, 4));
        self.slots_for_bits.push(slot);
        slot
    }

    /// Puts a bit into its byte; which value stands for it from here on.
    pub(super) fn put_apart(&mut self, slot: StackSlot, at: u8, value: Val) -> Val {
        let value = self.force(value);
        let bit = self.bit(value);
        let byte = self.b.ins().stack_addr(I64, slot, i32::from(at));
        self.b.ins().istore8(data(), bit, byte, 0);
        match value {
            Val::Bit { .. } => value,
            _ => Val::Bit { value: bit, clean: false },
        }
    }

    /// Reads a bit from its byte.
    pub(super) fn bit_apart(&mut self, slot: StackSlot, at: u8) -> Val {
        let byte = self.b.ins().stack_addr(I64, slot, i32::from(at));
        Val::Bit { value: self.b.ins().uload8(I32, data(), byte, 0), clean: false }
    }

    /// Puts bits together that are apart: those of a mask, the others 0.
    pub(super) fn bits_from_apart(&mut self, slot: StackSlot, mask: u32) -> Value {
        let mut together = None;
        for first in [0, TOGETHER] {
            if mask >> first & 0xFFFF == 0 {
                continue;
            }
            let bytes = self.b.ins().stack_load(I64, I16X8, slot, first as i32);
            // The lowest bit of each byte becomes its highest one.
            let moved = self.b.ins().ishl_imm_u(bytes, 7);
            let moved = self.b.ins().bitcast(I8X16, MemFlagsData::new().with_endianness(Endianness::Little), moved);
            let bits = self.b.ins().vhigh_bits(I32, moved);
            let bits = if first == 0 { bits } else { self.b.ins().ishl_imm_u(bits, i64::from(first)) };
            together = Some(match together {
                Some(low) => self.b.ins().bor(low, bits),
                None => bits,
            });
        }
        let together = together.unwrap_or_else(|| self.constant(0));
        if matches!(mask, u32::MAX | 0xFFFF | 0xFFFF_0000) { together } else { self.masked(together, mask) }
    }
}

/// Which bit of a number instructions take, if that is all they do: by its number, or with AND and a comparison.
fn taken_bit(insts: &[Inst]) -> Option<i64> {
    let mut constants = insts.iter().filter_map(|inst| match *inst {
        Inst::Constant { value, .. } => Some(value),
        _ => None,
    });
    let ops: Vec<Op> = insts.iter().filter_map(|inst| if let Inst::Compute { op, .. } = *inst { Some(op) } else { None }).collect();
    match ops[..] {
        [Op::BitOf] => i64::try_from(constants.next()?).ok(),
        [Op::AndU32 | Op::AndU64, Op::Equal | Op::Differ] => {
            constants.find(|value| value.is_power_of_two()).map(|mask| i64::from(mask.trailing_zeros()))
        }
        _ => None,
    }
}
