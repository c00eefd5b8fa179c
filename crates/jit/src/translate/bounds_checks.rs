//! Bounds-check elimination: access by computed addresses that are proven to be in bounds, and the facts on which the proofs rest.

use std::ops::Range;

use cranelift_codegen::cursor::{Cursor, FuncCursor};
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{self as clif, InstBuilder, InstructionData, Opcode, Value, ValueDef};
use sieben_engine::access;
use sieben_engine::ir::{Callee, Inst, Place};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::inlining::InlineFrame;
use super::memory::{Address, Bit};
use super::moves::MOVED_BYTES_MAX;
use super::range_analysis::{self, Fact, Interval, Ranges, Relative, Surroundings};
use super::scalar_promotion::Base;
use super::status_liveness::{open_blocks, set_by_calls};
use super::symbolic_summaries::Reliance;
use super::value::Val;
use super::{Translator, natural_loops};
use crate::passes::Pass;
use crate::runtime_calls::RuntimeCall;

/// Values that a computed address may be a sum of.
const TERMS_MAX: usize = 6;
/// How deep the calculation of an address is followed.
const DEPTH_MAX: usize = 12;

/// What is taken apart where an address is a sum.
const SUMS: [Opcode; 5] = [Opcode::Iadd, Opcode::Isub, Opcode::Ishl, Opcode::Imul, Opcode::Iconst];

/// A pointer to the first byte of the instance data block.
pub(super) const FIRST_BYTE: u64 = 0x8400_0000;

/// An address as a sum: of values times constants, and a constant; modulo 2^32.
#[derive(Default)]
pub(super) struct AffineSum {
    pub(super) terms: Vec<(Value, u32)>,
    pub(super) constant: u32,
    /// AR2, if that is not taken apart.
    of_instance: Option<Value>,
}

impl Translator<'_> {
    /// Looks at the ranges of the values of the present block, whose known registers and parameters are current.
    pub(super) fn find_ranges(&mut self) -> Ranges {
        let callers = |calls: usize| self.caller_local(calls);
        let facts = self.outer.last().map_or(Vec::new(), |outer| outer.facts_at_call().copied().collect());
        let relative = self.relative_instance();
        let ranges = self.ranges_of(self.words.constants(), facts, &callers, relative.as_ref());
        self.pinned.extend(ranges.opened());
        ranges
    }

    /// The same for a block whose callers are not those of the running code: what is known where it is called, and where the local data of
    /// its callers lie, the nearest first.
    pub(super) fn find_ranges_of_called(&mut self, facts: Vec<Fact>, callers: &[(i32, usize)]) -> Ranges {
        let ranges = self.ranges_of(Vec::new(), facts, &|calls| callers.get(calls).copied(), None);
        self.pinned.extend(ranges.opened());
        ranges
    }

    fn ranges_of(
        &self,
        words: Vec<(i32, Width, u64)>,
        facts: Vec<Fact>,
        callers: &dyn Fn(usize) -> Option<(i32, usize)>,
        relative: Option<&Relative>,
    ) -> Ranges {
        // Code that has to be there at once is for the time until better code is there.
        if !self.options.optimize && !self.options.exact || !self.options.passes.has(Pass::RangeAnalysis) {
            return Ranges::default();
        }
        let constants = |value: &Option<Val>| value.and_then(Val::constant);
        let mut registers = [None; Register::COUNT];
        for (register, value) in registers.iter_mut().zip(&self.current) {
            *register = constants(value);
        }
        let written = |inst: &Inst| self.written_by_call(inst);
        let becomes_part = self.inlines_all_calls();
        let called = |inst: &Inst| match inst {
            Inst::Call { callee: Callee::Block(id), .. } if becomes_part => (self.find)(*id).map(|code| code as usize),
            _ => None,
        };
        let instance = if relative.is_some() { Some(FIRST_BYTE) } else { self.instance.constant() };
        if relative.is_some() {
            registers[Register::Ar2 as usize] = instance;
        }
        let pointers = &self.pointers[self.index];
        let added = |added: Option<u32>| Some(u64::from((instance? as u32).wrapping_add(added?)));
        let surroundings = Surroundings {
            layout: self.layout,
            registers,
            parameters: self.given.iter().map(|given| given.constant()).collect(),
            local: (self.local_offset, self.native().local_size),
            words,
            facts,
            callers,
            asks_before_writing: self.options.asks_before_writing,
            written: &written,
            instance: [&|statement| added(pointers.at(statement)), &|inst| added(pointers.after(inst))],
            effects: self.effects,
            called: &called,
            relative,
        };
        range_analysis::find(self.native(), &surroundings)
    }

    /// What a load finds, if that is known to be a constant.
    pub(super) fn constant_at(&self, index: u32, place: Place, width: Width) -> Option<u64> {
        let (value, _) = self.ranges.result(index).filter(|(least, most)| least == most)?;
        let in_instance = || self.ranges.is_relative() && self.instance_address(place, width, false).is_some();
        let is_there = self.ranges.pointed(index).is_some() || self.constant_address(place, width).is_some() || in_instance();
        is_there.then_some(u64::from(value))
    }

    /// Registers that are not known any more behind a call.
    fn written_by_call(&self, inst: &Inst) -> u32 {
        let Inst::Call { callee: Callee::Block(id), .. } = inst else { return natural_loops::written(inst) };
        match (self.find)(*id) {
            // A call restores the data block registers.
            Some(code) => (self.summaries[code as usize].written | set_by_calls()) & !open_blocks(),
            None => natural_loops::written(inst),
        }
    }

    /// Notes the range of a value that an instruction has computed.
    pub(super) fn note_range(&mut self, index: u32, value: Val) {
        if let (Val::Int(value), Some(range)) = (value, self.ranges.pointer(index)) {
            self.note_pointer(value, range);
        }
        if let Val::Int(value) = value
            && let Some(range) = self.ranges.result(index)
        {
            self.bounds.insert(value, range);
            if value.as_u32() >= self.newest && self.choice.is_none() {
                self.bounds_of_results.insert(value, range);
            }
        }
    }

    /// Notes that a value is a pointer to a byte, which is a number of its own then: places that are counted from there share it.
    fn note_pointer(&mut self, value: Value, (least, most): (u32, u32)) {
        if !self.options.optimize || self.cold.is_some() {
            return;
        }
        let value = self.b.func.dfg.resolve_aliases(value);
        // What is known to be a sum is taken apart.
        if self.definition(value).is_some_and(|(_, data)| SUMS.contains(&data.opcode())) {
            return;
        }
        let byte = match self.bytes_of_pointers.get(&value) {
            Some(&byte) => byte,
            None => {
                let mut cursor = match self.b.func.dfg.value_def(value) {
                    ValueDef::Result(inst, _) => FuncCursor::new(self.b.func).after_inst(inst),
                    ValueDef::Param(block, _) => FuncCursor::new(self.b.func).at_first_insertion_point(block),
                    ValueDef::Union(..) => return,
                };
                let position = cursor.ins().band_imm_u(value, 0x00FF_FFFF);
                let byte = cursor.ins().ushr_imm_u(position, 3);
                self.bytes_of_pointers.insert(value, byte);
                byte
            }
        };
        self.bounds.insert(byte, ((least & 0x00FF_FFFF) / 8, (most & 0x00FF_FFFF) / 8));
    }

    /// The least and the greatest number without sign that a value may be in the running statement, if its 32 bits are known to be less
    /// than all.
    pub(super) fn range_of(&self, value: Val) -> Option<(u32, u32)> {
        match value {
            Val::Const(value) => u32::try_from(value).ok().map(|value| (value, value)),
            Val::Int(value) => self.bounds.get(&value).or_else(|| self.bounds_of_results.get(&value)).copied(),
            _ => None,
        }
    }

    /// The address of an access that is known to stay inside its area, which begins at a byte behind a base and has so many.
    pub(super) fn address_inside(
        &mut self,
        (base, start, length): (Value, i32, u64),
        pointer: Val,
        offset: u32,
        (width, bytes): (Width, u32),
    ) -> Address {
        let pointer = self.int(pointer);
        if let Some(address) = self.address_in_instance(pointer, offset, (width, bytes)) {
            return address;
        }
        let mut sum = AffineSum { constant: offset, ..AffineSum::default() };
        if self.decompose(pointer, 1, &mut sum, 0)
            && let Some(address) = self.address_of_sum((base, start, length), &mut sum, (width, bytes))
        {
            return address;
        }
        let highest = self.bounds.get(&pointer).and_then(|&(_, most)| most.checked_add(offset));
        let pointer = if offset == 0 { pointer } else { self.b.ins().iadd_imm_u(pointer, i64::from(offset)) };
        let position = match highest {
            Some(highest) if highest <= 0x00FF_FFFF => pointer,
            _ => self.b.ins().band_imm_u(pointer, 0x00FF_FFFF),
        };
        let bit = match width {
            Width::Bit => Bit::Computed(self.b.ins().band_imm_u(position, 7)),
            _ => Bit::Number(0),
        };
        let byte = self.b.ins().ushr_imm_u(position, 3);
        let byte = self.b.ins().uextend(I64, byte);
        Address { base: self.b.ins().iadd(base, byte), offset: start, bit }
    }

    /// The address of a byte to which a pointer goes that is known to stay inside an area, if nothing in its calculation overflows.
    pub(super) fn byte_address(&mut self, area: (Value, i32, u64), pointer: Value) -> Option<Value> {
        let mut sum = AffineSum::default();
        if !self.decompose(pointer, 1, &mut sum, 0) {
            return None;
        }
        let Address { base, offset, .. } = self.address_of_sum(area, &mut sum, (Width::Byte, 1))?;
        Some(self.b.ins().iadd_imm_u(base, i64::from(offset)))
    }

    /// The address of a pointer into the instance of the block, counted from where that begins.
    fn address_in_instance(&mut self, pointer: Value, offset: u32, access: (Width, u32)) -> Option<Address> {
        if !self.ranges.is_relative() {
            return None;
        }
        let own = self.instance_pointer()?;
        let (base, first, bytes) = self.instance_area()?;
        let area = (self.address_of_base(base), first, bytes);
        let mut sum = AffineSum { constant: offset, of_instance: Some(own), ..AffineSum::default() };
        if !self.decompose(pointer, 1, &mut sum, 0) {
            return None;
        }
        let at = sum.terms.iter().position(|&term| term == (own, 1))?;
        sum.terms.remove(at);
        self.address_of_sum(area, &mut sum, access)
    }

    /// What a pointer is more than AR2, as the present block began with it whose instance is in range.
    pub(super) fn behind_instance(&self, pointer: Value) -> Option<AffineSum> {
        let own = self.instance_pointer()?;
        let mut sum = AffineSum { of_instance: Some(own), ..AffineSum::default() };
        if !self.decompose(pointer, 1, &mut sum, 0) {
            return None;
        }
        let at = sum.terms.iter().position(|&term| term == (own, 1))?;
        sum.terms.remove(at);
        sum.terms.retain(|&(_, times)| times != 0);
        Some(sum)
    }

    /// Takes a value apart; whether the sum is short enough.
    pub(super) fn decompose(&self, value: Value, times: u32, sum: &mut AffineSum, depth: usize) -> bool {
        let dfg = &self.b.func.dfg;
        let value = dfg.resolve_aliases(value);
        if sum.of_instance != Some(value)
            && let Some(byte) = self.bytes_of_pointers.get(&value).filter(|byte| self.bounds.contains_key(byte))
        {
            // The area that it names counts for nothing: a position has 24 bits.
            return self.term(*byte, times.wrapping_mul(8), sum);
        }
        let ValueDef::Result(inst, 0) = dfg.value_def(value) else { return self.term(value, times, sum) };
        if depth == DEPTH_MAX
            || sum.of_instance == Some(value)
            || self.divided.contains(&value)
            || self.bounds.contains_key(&value) && !SUMS.contains(&dfg.insts[inst].opcode())
        {
            return self.term(value, times, sum);
        }
        if self.bounds.contains_key(&value)
            && let InstructionData::Binary { opcode: Opcode::Iadd | Opcode::Isub | Opcode::Imul, args } = dfg.insts[inst]
            && args.iter().any(|&arg| self.is_unknown(arg, DEPTH_MAX))
        {
            return self.term(value, times, sum);
        }
        match dfg.insts[inst] {
            InstructionData::Unary { opcode: Opcode::Ireduce, arg } if sum.of_instance == Some(dfg.resolve_aliases(arg)) => {
                self.term(dfg.resolve_aliases(arg), times, sum)
            }
            InstructionData::UnaryImm { opcode: Opcode::Iconst, imm } => {
                sum.constant = sum.constant.wrapping_add((imm.bits() as u32).wrapping_mul(times));
                true
            }
            InstructionData::Binary { opcode: Opcode::Iadd, args: [a, b] } => {
                self.decompose(a, times, sum, depth + 1) && self.decompose(b, times, sum, depth + 1)
            }
            InstructionData::Binary { opcode: Opcode::Isub, args: [a, b] } => {
                self.decompose(a, times, sum, depth + 1) && self.decompose(b, times.wrapping_neg(), sum, depth + 1)
            }
            InstructionData::Binary { opcode: Opcode::Ishl, args: [a, b] } if self.iconst(b).is_some_and(|count| count < 32) => {
                let count = self.iconst(b).unwrap_or(0);
                self.decompose(a, times << count, sum, depth + 1)
            }
            InstructionData::Binary { opcode: Opcode::Imul, args: [a, b] } if self.iconst(b).is_some() => {
                let factor = self.iconst(b).unwrap_or(0);
                self.decompose(a, times.wrapping_mul(factor), sum, depth + 1)
            }
            _ => self.term(value, times, sum),
        }
    }

    /// Whether nothing is known of the range of a value, nor of all that it is made of.
    fn is_unknown(&self, value: Value, depth: usize) -> bool {
        let dfg = &self.b.func.dfg;
        let is_made = || match self.definition(value) {
            Some((_, data)) if depth > 0 && SUMS.contains(&data.opcode()) => {
                data.arguments(&dfg.value_lists).iter().all(|&arg| !self.is_unknown(arg, depth - 1))
            }
            _ => false,
        };
        self.range_of(Val::Int(dfg.resolve_aliases(value))).is_none() && !is_made()
    }

    fn term(&self, value: Value, times: u32, sum: &mut AffineSum) -> bool {
        match sum.terms.iter_mut().find(|(other, _)| *other == value) {
            Some((_, known)) => *known = known.wrapping_add(times),
            None => sum.terms.push((value, times)),
        }
        sum.terms.len() <= TERMS_MAX
    }

    /// The number that a value is, if it is a constant.
    pub(super) fn iconst(&self, value: Value) -> Option<u32> {
        let dfg = &self.b.func.dfg;
        let ValueDef::Result(inst, 0) = dfg.value_def(dfg.resolve_aliases(value)) else { return None };
        match dfg.insts[inst] {
            InstructionData::UnaryImm { opcode: Opcode::Iconst, imm } => u32::try_from(imm.bits() & 0xFFFF_FFFF).ok(),
            _ => None,
        }
    }

    /// The address of a sum in which nothing overflows: its values are added in the form that addresses have in machine code. `None`
    /// if that cannot be shown.
    fn address_of_sum(
        &mut self,
        (base, start, length): (Value, i32, u64),
        sum: &mut AffineSum,
        (width, bytes): (Width, u32),
    ) -> Option<Address> {
        sum.terms.retain(|&(_, times)| times != 0);
        let (mut least, mut most) = (0_u64, 0_u64);
        for &(value, times) in &sum.terms {
            let (low, high) = self.range_of(Val::Int(value)).or_else(|| self.computed_range(value))?;
            least = least.checked_add(u64::from(low) * u64::from(times))?;
            most = most.checked_add(u64::from(high) * u64::from(times))?;
        }
        if most >= 1 << 31 {
            return None;
        }
        // What is taken off the address for the lowest index makes the constant negative.
        let constant = i64::from(sum.constant & 0x00FF_FFFF);
        let constant = [constant, constant - 0x0100_0000].into_iter().find(|constant| {
            let (first, last) = (least as i64 + constant, most as i64 + constant);
            first >= 0 && last / 8 + i64::from(bytes) <= length as i64
        })?;
        let (whole, bits): (Vec<_>, Vec<_>) = sum.terms.iter().copied().partition(|(_, times)| times % 8 == 0);
        let bit_index = match bits[..] {
            [] if constant % 8 == 0 || width == Width::Bit => None,
            [(value, 1)] if width == Width::Bit => Some(value),
            _ => return None,
        };
        let offset = i32::try_from(i64::from(start) + constant.div_euclid(8)).ok()?;
        // What the loop does not change comes first: it is added once, before the loop.
        let mut terms = whole;
        terms.sort_by_key(|(value, _)| !self.fixed.contains(value));
        let mut address = base;
        for (value, times) in terms {
            let value = self.b.ins().uextend(I64, value);
            let bytes = times / 8;
            let part = match bytes {
                1 => value,
                _ if bytes.is_power_of_two() => self.b.ins().ishl_imm_u(value, i64::from(bytes.trailing_zeros())),
                _ => self.b.ins().imul_imm_u(value, i64::from(bytes)),
            };
            address = self.b.ins().iadd(address, part);
        }
        let first_bit = constant.rem_euclid(8);
        let mut bit = Bit::Number(first_bit as u8);
        if let Some(index) = bit_index {
            let index = if first_bit == 0 { index } else { self.b.ins().iadd_imm_u(index, first_bit) };
            bit = Bit::Computed(self.b.ins().band_imm_u(index, 7));
            let byte = self.b.ins().ushr_imm_u(index, 3);
            let byte = self.b.ins().uextend(I64, byte);
            address = self.b.ins().iadd(address, byte);
        }
        Some(Address { base: address, offset, bit })
    }

    /// Reads where an access is known to stay inside its area.
    pub(super) fn read_inside(&mut self, address: Address, touched: &(Base, Range<i64>), width: Width) -> Val {
        self.settle_touched(touched, false);
        self.store_promoted_in(touched);
        self.read(address, width)
    }

    /// Writes where an access is known to stay inside its area.
    pub(super) fn write_inside(&mut self, address: Address, touched: &(Base, Range<i64>), width: Width, value: Val) {
        self.settle_touched(touched, true);
        self.store_promoted_in(touched);
        self.write(address, width, value);
        self.take_promoted_in(touched);
    }

    /// Moves bytes that are known to stay inside their areas, as if through a temporary; whether it could be written.
    pub(super) fn move_inside(&mut self, index: u32, (from, to, bytes): (Place, Place, u32)) -> bool {
        let Some([read, write]) = self.ranges.moved(index) else { return false };
        if bytes > MOVED_BYTES_MAX {
            return false;
        }
        let [from, to] = [(from, &read, false), (to, &write, true)].map(|(place, touched, write)| {
            let element = self.moved_element(place, touched, bytes, write);
            element.or_else(|| self.moved_span(index, place, bytes, write))
        });
        let (Some(from), Some(to)) = (from, to) else { return false };
        let known = self.known_copy(from, bytes);
        let [read, write] = [(read, from), (write, to)].map(|(touched, address)| self.touched_by(touched, address, bytes));
        self.store_promoted_in(&read);
        self.store_promoted_in(&write);
        self.settle_touched(&read, false);
        let pieces = known.unwrap_or_else(|| self.known_pieces(from, bytes));
        self.settle_touched(&write, true);
        self.write_pieces(to, &pieces);
        self.take_promoted_in(&write);
        self.remember_copy(to, bytes, pieces);
        true
    }

    /// What a move touches that begins at an address: these bytes and no others if it is counted from an element.
    fn touched_by(
        &self,
        touched: range_analysis::ByteRange,
        Address { base, offset, .. }: Address,
        bytes: u32,
    ) -> range_analysis::ByteRange {
        match self.known_base(base) {
            base @ Base::Computed(_) => (base, i64::from(offset)..i64::from(offset) + i64::from(bytes)),
            _ => touched,
        }
    }

    /// Where bytes begin that a move reads or writes, if they are part of an element.
    fn moved_element(&mut self, place: Place, touched: &range_analysis::ByteRange, bytes: u32, write: bool) -> Option<Address> {
        let Place::Indirect { area, pointer, offset } = place else { return None };
        let pointer = self.get(pointer);
        let pointer = self.force(pointer);
        if pointer.constant().is_some() || self.ranges.is_relative() {
            return None;
        }
        let area = self.known_area(area, write)?;
        self.field(area, (pointer, offset), (Width::Byte, bytes), touched, write)
    }

    /// Where bytes begin that a move reads or writes, and that are known to lie inside their area.
    fn moved_span(&mut self, index: u32, place: Place, bytes: u32, write: bool) -> Option<Address> {
        let Place::Crossing { pointer, offset } = place else { return self.span(place, bytes, write) };
        let value = self.get(pointer);
        let value = self.force(value);
        if let Some(number) = self.ranges.named_block(index, write) {
            let block = self.layout.data_blocks.get(&number)?;
            let area = (self.arena, i32::try_from(block.start).ok()?, block.len() as u64);
            return match value.constant() {
                Some(pointer) => span_at(area, pointer, offset, bytes),
                None => {
                    let pointer = self.without_number(value);
                    Some(self.address_inside(area, pointer, offset, (Width::Byte, bytes)))
                }
            };
        }
        let area = match value.constant() {
            // The number of a data block is not that of an open one.
            Some(pointer) if pointer >> 32 != 0 => return None,
            Some(pointer) => match access::pointed_area(pointer, write).ok()? {
                Area::CallerLocal => {
                    let (offset, _) = self.way_to_caller(super::memory::moved(pointer, offset), Width::Byte)?;
                    return Some(Address { base: self.local, offset, bit: Bit::Number(0) });
                }
                area => area,
            },
            None => match self.ranges.pointed_area(index, write)? {
                Area::CallerLocal => {
                    let touched = self.ranges.moved(index)?[usize::from(write)].clone();
                    let pointer = self.without_number(value);
                    return self.address_in_caller(&touched, (pointer, offset), (Width::Byte, bytes));
                }
                area => area,
            },
        };
        self.span(Place::Indirect { area, pointer, offset }, bytes, write)
    }

    /// Where bytes begin that are known to lie inside their area.
    pub(super) fn span(&mut self, place: Place, bytes: u32, write: bool) -> Option<Address> {
        let (area, pointer, offset) = match place {
            Place::Fixed { area, position } => (area, Val::Const(0), position),
            Place::Indirect { area, pointer, offset } => (area, self.get(pointer), offset),
            Place::Crossing { .. } => return None,
        };
        let pointer = self.force(pointer);
        let area = self.known_area(area, write)?;
        match pointer.constant() {
            Some(pointer) => span_at(area, pointer, offset, bytes),
            None => Some(self.address_inside(area, pointer, offset, (Width::Byte, bytes))),
        }
    }

    /// A pointer without the number of the data block above it.
    fn without_number(&mut self, pointer: Val) -> Val {
        let word = self.word(pointer);
        let extended = |value: Value| match self.definition(value) {
            Some((_, InstructionData::Unary { opcode: Opcode::Uextend, arg })) if self.b.func.dfg.value_type(arg) == I32 => Some(arg),
            _ => None,
        };
        let low = match self.definition(word) {
            Some((_, InstructionData::Binary { opcode: Opcode::Bor, args: [a, b] })) => {
                let is_number = |value: Value| self.iconst(value) == Some(0);
                [(a, b), (b, a)].into_iter().find_map(|(number, own)| if is_number(number) { extended(own) } else { None })
            }
            _ => None,
        };
        low.map_or(pointer, Val::Int)
    }

    /// What the code relies on from a statement on, if that can have changed while somebody was asked.
    pub(super) fn relies_on_memory(&self, statement: u32) -> bool {
        let over_calls = |outer: &InlineFrame| outer.facts_over_call().next().is_some();
        let knows = !self.ranges.facts(statement).is_empty() || self.outer.iter().any(over_calls);
        knows || self.look.is_some() || self.is_given_up(statement)
    }

    /// Whether nobody may be asked here if machine code is to go on.
    fn needs_silence(&self) -> bool {
        self.reliance == Reliance::OnSilence || self.outer.iter().any(InlineFrame::needs_silence)
    }

    /// Whether machine code does not go on at a statement, whatever memory holds.
    fn is_given_up(&self, statement: u32) -> bool {
        self.needs_silence() || self.ranges.is_unreached(statement)
    }

    /// A block in which memory is compared with what the code relies on from a statement on, before the block where it begins. The
    /// interpreter takes over if it is not so. Called where somebody was asked: all registers are stored.
    pub(super) fn verified(&mut self, statement: u32, next: clif::Block) -> clif::Block {
        if !self.relies_on_memory(statement) {
            return next;
        }
        if let Some(&verify) = self.verifying.get(&next) {
            return verify;
        }
        let verify = self.b.create_block();
        self.b.set_cold_block(verify);
        self.verifying.insert(next, verify);
        self.verify_later.push((verify, statement, next, self.look));
        verify
    }

    /// Writes the comparisons that are still to be written. The block before ended.
    pub(super) fn write_verifications(&mut self) {
        for (verify, statement, next, look) in std::mem::take(&mut self.verify_later) {
            self.b.switch_to_block(verify);
            let before = self.cold.replace(verify);
            let over_calls = self.outer.iter().flat_map(InlineFrame::facts_over_call);
            let facts: Vec<Fact> = self.ranges.facts(statement).iter().chain(over_calls).copied().collect();
            if self.is_given_up(statement) {
                self.give_up_at(statement);
                self.cold = before;
                continue;
            }
            let mut holds: Option<Value> = look.map(|look| self.budget_lasts(look));
            for fact in facts {
                let this = self.holds(fact);
                holds = Some(match holds {
                    Some(holds) => self.b.ins().band(holds, this),
                    None => this,
                });
            }
            let give_up = self.b.create_block();
            self.b.set_cold_block(give_up);
            match holds {
                Some(holds) => self.b.ins().brif(holds, next, &[], give_up, &[]),
                None => self.b.ins().jump(next, &[]),
            };
            self.b.switch_to_block(give_up);
            self.b.seal_block(give_up);
            self.give_up_at(statement);
            self.cold = before;
        }
    }

    /// Hands over to the interpreter at a statement. All that it looks at is in memory.
    pub(super) fn give_up_at(&mut self, statement: u32) {
        let code = self.b.ins().iconst(I64, self.index as i64);
        let statement = self.first_named(statement);
        let statement = self.b.ins().iconst(I64, i64::from(statement));
        let link = self.shown_link();
        let arguments = [self.run, link, code, statement];
        self.ask_at_gate(RuntimeCall::Interpret, &arguments);
        self.b.ins().jump(self.leave, &[]);
    }

    /// Whether a variable in memory is in its range.
    fn holds(&mut self, Fact { variable: (base, offset, width), range }: Fact) -> Value {
        // Other ways come here, too.
        let base = if base == Base::Arena { self.first_arena } else { self.address_of_base(base) };
        let value = self.read(Address { base, offset, bit: Bit::Number(0) }, width);
        let Interval { least, most, zeros, bits, spacing } = range;
        let (value, less) = match width {
            Width::QuadWord => (self.word(value), least.wrapping_neg()),
            _ => (self.int(value), i64::from((least as i32).wrapping_neg())),
        };
        let own = self.b.func.dfg.value_type(value).bits();
        let distance = self.b.ins().iadd_imm_s(value, less);
        let distance = if bits < own { self.b.ins().band_imm_u(distance, (1 << bits) - 1) } else { distance };
        // What reaches over all numbers of so many bits says nothing.
        let reach = most.wrapping_sub(least) as u64;
        let mut holds = match Some(reach).filter(|&reach| own == 64 || reach <= u64::from(u32::MAX)) {
            Some(reach) if own == 64 => {
                let reach = self.b.ins().iconst(I64, reach as i64);
                self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, distance, reach)
            }
            Some(reach) => self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, distance, reach as i64),
            None => self.b.ins().icmp(IntCC::Equal, distance, distance),
        };
        if bits < width.bits() {
            let small = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, value, 1 << bits);
            holds = self.b.ins().band(holds, small);
        }
        if zeros > 0 {
            let low = self.b.ins().band_imm_u(value, (1_i64 << zeros.min(31)) - 1);
            let none = self.b.ins().icmp_imm_u(IntCC::Equal, low, 0);
            holds = self.b.ins().band(holds, none);
        }
        if let (step @ 2.., rest) = spacing.parts() {
            let left = self.b.ins().urem_imm_u(distance, step);
            let first = (i128::from(rest) - i128::from(least)).rem_euclid(step.into());
            let whole = self.b.ins().icmp_imm_u(IntCC::Equal, left, first as i64);
            holds = self.b.ins().band(holds, whole);
        }
        holds
    }
}

/// Where bytes lie behind a pointer that is a constant, if they are in an area: where that begins, and its length.
fn span_at((base, start, length): (Value, i32, u64), pointer: u64, offset: u32, bytes: u32) -> Option<Address> {
    let byte = u64::from(super::memory::moved(pointer, offset) / 8);
    let offset = i32::try_from(i64::from(start) + byte as i64).ok()?;
    (byte + u64::from(bytes) <= length).then_some(Address { base, offset, bit: Bit::Number(0) })
}
