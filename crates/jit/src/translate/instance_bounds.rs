//! Known bits and bounds of AR2: instances at computed addresses, elements of an array of function blocks mostly. Where the code that
//! computes AR2 proves that the instance is inside its data block, the address is computed once for the whole call, and access to the
//! instance is not checked.

use std::ops::Range;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, InstructionData, Opcode, Value, ValueDef};
use sieben_engine::ir::{Callee, Inst, OnFault, Place};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};

use super::bounds_checks::AffineSum;
use super::congruence::Congruence;
use super::inlining::InlineFrame;
use super::memory::{Address, Bit};
use super::range_analysis::{self, Interval, Relative};
use super::scalar_promotion::{Base, ComputedAddress, Displacement};
use super::value::Val;
use super::{OPEN_BLOCKS, Translator};
use crate::passes::Pass;

/// How far the computation of a value is followed back.
const DEPTH_MAX: usize = 12;

/// Where the instance of a block lies, if that is known to be inside its data block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instance {
    /// AR2.
    pointer: Val,
    /// The address from which it is counted, and how many bytes behind that it begins.
    address: Value,
    first: i32,
    /// Bytes that are there, whatever AR2 holds.
    bytes: u64,
    /// The data block: number, base, length.
    block: [u64; 3],
    /// Whether it may be written.
    written: bool,
}

/// What is known of an unsigned number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Bounds {
    least: u64,
    most: u64,
    /// So many low bits are 0.
    zeros: u32,
}

impl Bounds {
    fn constant(value: u64) -> Self {
        Self { least: value, most: value, zeros: value.trailing_zeros() }
    }

    /// A range of AR2.
    fn of(range: Interval) -> Self {
        let (least, most) = range.unsigned(32);
        Self { least: least as u64, most: most as u64, zeros: range.zeros }
    }

    fn reach(&self) -> (u64, std::cmp::Reverse<u32>) {
        (self.most - self.least, std::cmp::Reverse(self.zeros))
    }

    /// What is known where both hold.
    fn and(self, other: Self) -> Self {
        let (least, most) = (self.least.max(other.least), self.most.min(other.most));
        if least > most { self } else { Self { least, most, zeros: self.zeros.max(other.zeros) } }
    }

    fn either(self, other: Self) -> Self {
        Self { least: self.least.min(other.least), most: self.most.max(other.most), zeros: self.zeros.min(other.zeros) }
    }
}

impl Translator<'_> {
    /// Where the instance of the block that begins now lies, from what AR2 and DI hold.
    pub(super) fn instance_in_range(&mut self, at_call: Option<Interval>) -> Option<Instance> {
        let pointer = self.register(Register::Ar2);
        let value = match pointer {
            Val::Int(value) | Val::Word(value) => value,
            _ => return None,
        };
        let block = self.instance_block()?;
        if let Some(part) = self.part_of_instance(pointer, block) {
            return Some(part);
        }
        let [number, base, length] = block;
        let computed = self.bounds(value, DEPTH_MAX);
        let spacing = at_call.map_or(Congruence::ANY, |range| range.distances_unsigned(24)).in_bytes().moved(base as i64);
        let Bounds { least, most, zeros } = at_call.map(Bounds::of).into_iter().chain(computed).min_by_key(Bounds::reach)?;
        // The area in the pointer does not count.
        if zeros < 3 || least >> 24 != most >> 24 {
            return None;
        }
        let bytes = length.checked_sub((most & 0x00FF_FFFF) / 8).filter(|&bytes| bytes > 0)?;
        let written = !self.layout.read_only.iter().any(|&protected| u64::from(protected) == number);
        let narrow = self.int(pointer);
        let byte = |bits: u64| base as i64 + (bits as i64 & 0x00FF_FFFF) / 8;
        let area = (self.arena, i32::try_from(base).ok()?, length);
        let (address, first) = match self.element(area, narrow, (byte(least)..byte(most), spacing)) {
            Some((computed, first)) => (computed.address, first),
            None => {
                let position = self.word(pointer);
                let position = self.b.ins().band_imm_u(position, 0x00FF_FFFF);
                let position = self.b.ins().ushr_imm_u(position, 3);
                let start = self.b.ins().iadd_imm_u(self.arena, i64::try_from(base).ok()?);
                let address = self.b.ins().iadd(start, position);
                self.computed.insert(address, ComputedAddress { address, least: byte(least), most: byte(most), spacing, part_of: None });
                (address, 0)
            }
        };
        Some(Instance { pointer, address, first, bytes, block, written })
    }

    /// Whether the instance of a block that is called now begins at a byte of its data block, and so many bytes are there.
    pub(super) fn has_instance_inside(&mut self, call: u32, bytes: u32) -> bool {
        let Some([_, _, length]) = self.instance_block() else { return false };
        match self.register(Register::Ar2).constant() {
            Some(pointer) => pointer % 8 == 0 && (pointer & 0x00FF_FFFF) / 8 + u64::from(bytes) <= length,
            None => self.instance_in_range(self.ranges.instance(call)).is_some_and(|it| it.bytes >= u64::from(bytes)),
        }
    }

    /// The instance of the function's outermost block, which is known to begin at a byte of its data block with so many bytes.
    pub(super) fn know_instance_inside(&mut self, bytes: u32) {
        let pointer = self.register(Register::Ar2);
        let Some([_, _, length]) = self.instance_block() else { return };
        let Some(last) = u32::try_from(length).ok().and_then(|length| length.checked_sub(bytes)) else { return };
        self.in_range = self.instance_in_range(Some(Interval::bytes_up_to(last)));
        self.current[Register::Ar2 as usize] = self.in_range.map(|_| pointer);
    }

    /// The instance of the block that begins now, if it lies at a constant place in that of its caller: it is counted from where that
    /// begins, and what is known of the one is known of the other.
    fn part_of_instance(&mut self, pointer: Val, block: [u64; 3]) -> Option<Instance> {
        let own = self.in_range.filter(|own| own.block == block)?;
        let value = self.int(pointer);
        let sum = self.behind_instance(value)?;
        if !sum.terms.is_empty() {
            let (element, first, bytes) = self.part_of_sum(&sum)?;
            return Some(Instance { pointer, address: element.address, first, bytes, ..own });
        }
        let bits = sum.constant;
        let bytes = own.bytes.checked_sub(u64::from(bits / 8)).filter(|&bytes| bits % 8 == 0 && bytes > 0)?;
        let first = own.first.checked_add(i32::try_from(bits / 8).ok()?)?;
        Some(Instance { pointer, first, bytes, ..own })
    }

    /// A part of the instance of the present block that indexes tell, whatever they are: what an address is counted from, how many bytes
    /// behind that it begins, and the bytes that are there.
    pub(super) fn part_of_sum(&mut self, sum: &AffineSum) -> Option<(ComputedAddress, i32, u64)> {
        if !self.options.optimize || self.cold.is_some() || !sum.constant.is_multiple_of(8) {
            return None;
        }
        let (mut least, mut most) = (0_u64, 0_u64);
        for &(value, times) in &sum.terms {
            let range = self.bounds(value, DEPTH_MAX).filter(|_| times.is_multiple_of(8))?;
            least = least.checked_add(range.least.checked_mul(times.into())?)?;
            most = most.checked_add(range.most.checked_mul(times.into())?)?;
        }
        // A constant takes off what the lowest index adds.
        let constant = i64::from((sum.constant << 8) as i32 >> 8);
        let (Base::Computed(instance), first, bytes) = self.instance_area()? else { return None };
        let (lowest, highest) = (least as i64 + constant, i64::try_from(most).ok()? + constant);
        let left = bytes.checked_sub(u64::try_from(highest).ok()? / 8).filter(|&left| lowest >= 0 && left > 0)?;
        let first = first.checked_add((constant / 8) as i32)?;
        if let Some(known) = self.known_part(instance.address, sum) {
            return Some((known, first, left));
        }
        let mut address = instance.address;
        for &(value, times) in &sum.terms {
            let value = self.b.ins().uextend(I64, value);
            // A sum would be made again in each access: two registers that live as long.
            let part = self.b.ins().imul_imm_s(value, -i64::from(times / 8));
            address = self.b.ins().isub(address, part);
        }
        let (least, most) = ((least / 8) as i64, (most / 8) as i64);
        let part = |&(_, times): &(Value, u32)| Congruence::ANY.times(i64::from(times / 8));
        let spacing = sum.terms.iter().map(part).fold(Congruence::exactly(0), Congruence::plus);
        let part_of = Some(Displacement { of: instance.address, least, most, spacing });
        let spacing = instance.spacing.plus(spacing);
        let element = ComputedAddress { address, least: instance.least + least, most: instance.most + most, spacing, part_of };
        self.remember_part(instance.address, sum, element);
        Some((element, first, left))
    }

    /// The address of a variable of the instance that indexes tell, if it is there whatever they are. The open data block may be accessed.
    pub(super) fn indexed_in_instance(&mut self, area: Area, (pointer, offset): (Value, u32), width: Width) -> Option<Address> {
        let own = self.in_range.filter(|_| area == Area::InstanceData)?;
        if self.instance_block() != Some(own.block) || width != Width::Bit && !offset.is_multiple_of(8) {
            return None;
        }
        let mut sum = self.behind_instance(pointer).filter(|sum| !sum.terms.is_empty())?;
        sum.constant = sum.constant.wrapping_add(offset & !7);
        let (element, offset_of_byte, _) = self.part_of_sum(&sum).filter(|&(_, _, left)| left >= u64::from(width.bytes()))?;
        Some(Address { base: element.address, offset: offset_of_byte, bit: Bit::Number((offset % 8) as u8) })
    }

    /// The instance, if the block that begins now reaches it by AR2 and nothing else.
    pub(super) fn relative_instance(&self) -> Option<Relative> {
        let it = self.in_range.filter(|_| self.options.passes.has(Pass::BaseRelative))?;
        let instance = *self.computed.get(&it.address)?;
        let is_bounded = |inst: &Inst| match inst {
            Inst::Call { callee: Callee::Block(id), .. } => (self.find)(*id).is_some_and(|code| {
                let effects = self.effects[code as usize].as_ref();
                effects.is_some_and(|effects| effects.texts.is_empty()) && self.pointers[code as usize].kept
            }),
            _ => false,
        };
        let is_taken_back = |inst| self.pointers[self.index].after(inst).is_some();
        let uses = range_analysis::uses(&self.native().code, &is_bounded, &is_taken_back)?;
        let real = self.outer.last().and_then(InlineFrame::instance).unwrap_or(Interval::any(32));
        Some(Relative { instance, first: i64::from(it.first), bytes: it.bytes as i64, protected: !it.written, real, uses })
    }

    /// AR2, as a block began with it whose instance is in range.
    pub(super) fn instance_pointer(&self) -> Option<Value> {
        match self.in_range?.pointer {
            Val::Int(value) | Val::Word(value) => Some(self.b.func.dfg.resolve_aliases(value)),
            _ => None,
        }
    }

    /// Where the instance begins, and the bytes that are there.
    pub(super) fn instance_area(&self) -> Option<(Base, i32, u64)> {
        let instance = self.in_range?;
        Some((Base::Computed(*self.computed.get(&instance.address)?), instance.first, instance.bytes))
    }

    /// Where the instance of the block that begins now lies. It is known to be there.
    pub(super) fn instance_base(&mut self) -> (Base, i32) {
        if let Some((base, first, _)) = self.instance_area() {
            return (base, first);
        }
        let pointer = self.register(Register::Ar2);
        if let (Some(pointer), Some([_, base, _])) = (pointer.constant(), self.instance_block())
            && let Ok(first) = i32::try_from(base + (pointer & 0x00FF_FFFF) / 8)
        {
            return (Base::Arena, first);
        }
        let (pointer, start) = (self.word(pointer), self.register(Register::DiBase));
        let start = self.word(start);
        let position = self.b.ins().band_imm_u(pointer, 0x00FF_FFFF);
        let byte = self.b.ins().ushr_imm_u(position, 3);
        let start = self.b.ins().iadd(self.arena, start);
        let address = self.b.ins().iadd(start, byte);
        let computed = ComputedAddress { address, least: 0, most: self.layout.size as i64, spacing: Congruence::ANY, part_of: None };
        self.computed.insert(address, computed);
        (Base::Computed(computed), 0)
    }

    /// Number, base and length of the open instance data block, if they are constants.
    fn instance_block(&self) -> Option<[u64; 3]> {
        let mut block = [0; 3];
        for (register, value) in OPEN_BLOCKS[3..].iter().zip(&mut block) {
            *value = self.current[*register as usize].and_then(Val::constant)?;
        }
        Some(block)
    }

    /// Reads or writes a variable of the instance, if the instruction does and the variable is known to be there; whether it was.
    pub(super) fn access_instance(&mut self, index: u32, inst: &Inst) -> bool {
        let (place, width, writes) = match *inst {
            Inst::Load { place, width, on_fault, .. } => (place, width, on_fault == OnFault::SkipWrite),
            Inst::Store { place, width, .. } => (place, width, true),
            _ => return false,
        };
        let Some((base, offset)) = self.instance_address(place, width, writes) else { return false };
        let bit = match place {
            Place::Indirect { offset, .. } => Bit::Number((offset % 8) as u8),
            _ => return false,
        };
        let address = Address { base: self.address_of_base(base), offset, bit };
        match *inst {
            Inst::Load { dst, .. } => {
                let value = self.read_known(address, width);
                self.note_range(index, value);
                self.set(dst, value);
            }
            Inst::Store { src, .. } => {
                let value = self.get(src);
                self.write_known(address, width, value);
            }
            _ => {}
        }
        true
    }

    /// The address of a variable of the instance, without its bit, if the variable is known to be there.
    pub(super) fn instance_address(&self, place: Place, width: Width, writes: bool) -> Option<(Base, i32)> {
        let Place::Indirect { offset, .. } = place else { return None };
        let fits = width == Width::Bit || offset % 8 == 0;
        fits.then(|| self.instance_bytes(place, width.bytes(), writes)).flatten()
    }

    /// The address of so many bytes of the instance, if they are known to be there.
    pub(super) fn instance_bytes(&self, place: Place, bytes: u32, writes: bool) -> Option<(Base, i32)> {
        let Place::Indirect { area: Area::InstanceData, pointer, offset } = place else { return None };
        let instance = self.in_range?;
        let byte = u64::from(offset / 8);
        let there = pointer.register() == Some(Register::Ar2)
            && self.current[Register::Ar2 as usize] == Some(instance.pointer)
            && self.instance_block() == Some(instance.block)
            && (instance.written || !writes)
            && byte + u64::from(bytes) <= instance.bytes;
        let computed = *self.computed.get(&instance.address)?;
        there.then_some((Base::Computed(computed), instance.first.checked_add(i32::try_from(byte).ok()?)?))
    }

    /// The upper byte of a pointer, which names its area, if it is the same for all that the pointer may be.
    pub(super) fn area_code(&self, pointer: Value) -> Option<u64> {
        let Bounds { least, most, .. } = self.bounds(pointer, DEPTH_MAX)?;
        (least >> 24 == most >> 24).then_some(least & 0xFF00_0000)
    }

    /// Whether a pointer leads to no local data of a caller, so that it is the same for blocks that are called.
    pub(super) fn leads_elsewhere(&self, pointer: Value) -> bool {
        let interval =
            |Bounds { least, most, zeros }: Bounds| Interval { least: least as i64, most: most as i64, zeros, ..Interval::any(32) };
        self.bounds(pointer, DEPTH_MAX).is_some_and(|bounds| interval(bounds).leads_elsewhere())
    }

    /// The bytes of an area of so many to which accesses with a pointer go, if all of them are there.
    pub(super) fn bytes_at(&self, length: u64, (pointer, offset): (Value, u32), width: Width) -> Option<Range<i64>> {
        let Bounds { least, most, zeros } = self.bounds(pointer, DEPTH_MAX)?;
        let [first, last] = [least, most].map(|pointer| (pointer & 0x00FF_FFFF) + u64::from(offset));
        let to_bytes = width == Width::Bit || offset.is_multiple_of(8) && zeros.max(self.low_zeros(pointer, DEPTH_MAX)) >= 3;
        let end = last / 8 + u64::from(width.bytes());
        let inside = least >> 24 == most >> 24 && last <= 0x00FF_FFFF && end <= length;
        (inside && to_bytes).then_some((first / 8) as i64..end as i64)
    }

    /// How many of the lowest bits of a value are 0, whatever it is.
    fn low_zeros(&self, value: Value, depth: usize) -> u32 {
        let (Some((_, data)), Some(depth)) = (self.definition(value), depth.checked_sub(1)) else { return 0 };
        match data {
            InstructionData::UnaryImm { opcode: Opcode::Iconst, imm } => imm.bits().trailing_zeros(),
            InstructionData::Binary { opcode: Opcode::Imul, args: [a, b] } => self.low_zeros(a, depth) + self.low_zeros(b, depth),
            InstructionData::Binary { opcode: Opcode::Iadd, args: [a, b] } => self.low_zeros(a, depth).min(self.low_zeros(b, depth)),
            InstructionData::Binary { opcode: Opcode::Ishl, args: [a, b] } => match self.iconst(b) {
                Some(count @ 0..32) => self.low_zeros(a, depth) + count,
                _ => 0,
            },
            _ => 0,
        }
    }

    /// The least and the greatest number without sign that a value of 32 bits may be, from how it is computed.
    pub(super) fn computed_range(&self, value: Value) -> Option<(u32, u32)> {
        let Bounds { least, most, .. } = self.bounds(value, DEPTH_MAX)?;
        Some((u32::try_from(least).ok()?, u32::try_from(most).ok()?))
    }

    /// What is known of a value from how it is computed, or from the statement.
    fn bounds(&self, value: Value, depth: usize) -> Option<Bounds> {
        let noted = self.range_of(Val::Int(value));
        let noted = noted.map(|(least, most)| Bounds { least: u64::from(least), most: u64::from(most), zeros: 0 });
        match (self.computed_bounds(value, depth), noted) {
            (Some(computed), Some(noted)) => Some(computed.and(noted)),
            (computed, noted) => computed.or(noted),
        }
    }

    fn computed_bounds(&self, value: Value, depth: usize) -> Option<Bounds> {
        let dfg = &self.b.func.dfg;
        let depth = depth.checked_sub(1)?;
        let bits = dfg.value_type(value).bits();
        let limit = if bits >= 64 { u64::MAX } else { (1 << bits) - 1 };
        let (inst, data) = self.definition(value)?;
        let below = |bounds: Bounds| (bounds.most <= limit).then_some(bounds);
        match data {
            InstructionData::UnaryImm { opcode: Opcode::Iconst, imm } => Some(Bounds::constant(imm.bits() as u64 & limit)),
            InstructionData::Unary { opcode: Opcode::Uextend, arg } => {
                let any = || Bounds { least: 0, most: u64::MAX >> (64 - dfg.value_type(arg).bits()), zeros: 0 };
                Some(self.bounds(arg, depth).unwrap_or_else(any))
            }
            InstructionData::Unary { opcode: Opcode::Ireduce, arg } => below(self.bounds(arg, depth)?),
            InstructionData::Binary { opcode, args: [a, b] } => {
                let (a, b) = (self.bounds(a, depth), self.bounds(b, depth));
                if opcode == Opcode::Band {
                    let mask = b?.most;
                    let zeros = a.map_or(0, |a| a.zeros).max(b?.zeros);
                    let most = a.map_or(mask, |a| a.most.min(mask));
                    return Some(Bounds { least: 0, most, zeros });
                }
                let (a, b) = (a?, b?);
                match opcode {
                    Opcode::Iadd => below(Bounds {
                        least: a.least.checked_add(b.least)?,
                        most: a.most.checked_add(b.most)?,
                        zeros: a.zeros.min(b.zeros),
                    }),
                    Opcode::Imul => below(Bounds {
                        least: a.least.checked_mul(b.least)?,
                        most: a.most.checked_mul(b.most)?,
                        zeros: a.zeros.saturating_add(b.zeros),
                    }),
                    Opcode::Ishl if b.least == b.most && b.most < 32 => below(Bounds {
                        least: a.least.checked_mul(1 << b.most)?,
                        most: a.most.checked_mul(1 << b.most)?,
                        zeros: a.zeros.saturating_add(b.most as u32),
                    }),
                    _ => None,
                }
            }
            InstructionData::Ternary { opcode: Opcode::Select, .. } => {
                let &[condition, a, b] = dfg.inst_args(inst) else { return None };
                let b = self.bounds(b, depth)?;
                let chosen = match self.most_if(condition, a) {
                    Some(most) => {
                        let a = self.bounds(a, depth).unwrap_or(Bounds { least: 0, most: limit, zeros: 0 });
                        Bounds { least: a.least.min(most), most: a.most.min(most), ..a }
                    }
                    None => self.bounds(a, depth)?,
                };
                Some(chosen.either(b))
            }
            _ => None,
        }
    }

    /// The instruction that computes a value.
    pub(super) fn definition(&self, value: Value) -> Option<(cranelift_codegen::ir::Inst, InstructionData)> {
        let dfg = &self.b.func.dfg;
        match dfg.value_def(dfg.resolve_aliases(value)) {
            ValueDef::Result(inst, 0) => Some((inst, dfg.insts[inst])),
            _ => None,
        }
    }

    /// The greatest number that a value is if a condition holds which compares it with a constant.
    fn most_if(&self, condition: Value, value: Value) -> Option<u64> {
        let (_, data) = self.definition(condition)?;
        match data {
            InstructionData::Unary { opcode: Opcode::Uextend, arg } => self.most_if(arg, value),
            InstructionData::IntCompare { opcode: Opcode::Icmp, args: [a, b], cond } => {
                let same = self.same(a, value);
                let limit = self.bounds(b, 1).filter(|b| b.least == b.most)?.most;
                match cond {
                    IntCC::UnsignedLessThan if same => limit.checked_sub(1),
                    IntCC::UnsignedLessThanOrEqual if same => Some(limit),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Whether two values are the same number: one value, or the low half of one.
    fn same(&self, a: Value, b: Value) -> bool {
        let dfg = &self.b.func.dfg;
        let [a, b] = [a, b].map(|value| dfg.resolve_aliases(value));
        let low_half = |value: Value| match self.definition(value) {
            Some((_, InstructionData::Unary { opcode: Opcode::Ireduce, arg })) => Some(dfg.resolve_aliases(arg)),
            _ => None,
        };
        a == b || low_half(a).is_some_and(|whole| low_half(b) == Some(whole))
    }
}
