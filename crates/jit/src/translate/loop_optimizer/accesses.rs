//! Loads and stores of an iteration at computed addresses.

use std::collections::BTreeSet;

use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::{Address, Bit, data};
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::emission::Emitter;
use super::kernel::{Access, Definition, Kernel, Level, Node, PointedPart};
use super::scalar_evolution::Shape;
use super::strided_access::Strided;
use super::vectorization::Lanes;

/// What an access writes if it does not keep what is there.
struct ConditionalStore {
    condition: Node,
    /// Whether the condition says that it is written, and not that it is kept.
    if_not: bool,
    new: Node,
}

impl Kernel {
    /// Whether an access keeps the greater or lesser one of what is there and something else, at a place that no iteration knows of the
    /// next one.
    fn unless_kept(&self, access: &Access, value: Node) -> Option<ConditionalStore> {
        let Definition::Compute(Op::Select, [condition, a, b, _]) = self.what(value) else { return None };
        let was_there = |node: Node| matches!(self.what(node), Definition::Read(number) if self.accesses[number].is_same(access));
        let (old, new, if_not) = if was_there(b) { (b, a, true) } else { (a, b, false) };
        let mut rests = BTreeSet::new();
        self.rests(condition, &mut rests);
        let is_somewhere = self.line(access.pointer, access.level).is_none();
        let is_kept = was_there(old) && access.width != Width::Bit && is_somewhere && rests.contains(&old);
        is_kept.then_some(ConditionalStore { condition, if_not, new })
    }
}

impl Emitter<'_, '_, '_> {
    pub(super) fn access(&mut self, number: usize, level: Level) {
        if self.access_piece(number) {
            return;
        }
        let access = &self.kernel.accesses[number];
        self.settle_records(number, access.value.is_none());
        if self.lanes > 1 && self.kernel.is_row_of_bits(access) {
            return self.access_row_of_bits(number, level);
        }
        if self.lanes > 1 && self.kernel.is_gathered(access) {
            return self.gather(number, level);
        }
        if self.lanes > 1
            && let Some(value) = access.value
            && self.kernel.is_scattered(access)
        {
            return self.scatter(number, value, level);
        }
        let (_, start, _) = access.area;
        let part = access.part.unwrap_or(PointedPart { bytes: 0, bit: 0 });
        let address = match self.scope(level).addresses.get(&access.counted()) {
            Some(&base) => Address { base, offset: start + part.bytes, bit: Bit::Number(part.bit) },
            None => {
                let pointer = self.first(access.pointer, level);
                self.address_at(access, pointer)
            }
        };
        if self.lanes > 1
            && let Some(step) = self.kernel.apart(access)
        {
            let touched = |more| self.written.iter().any(|&other| self.kernel.touches(number, more, other));
            let apart = Strided {
                first: address,
                step,
                only_read: self.kernel.is_only_read(number),
                // What waits to be written may need it later.
                untouched: access.value.is_none() && !touched(false),
                more: self.kernel.has_more(access) && !touched(true),
            };
            self.access_apart(number, apart, level);
            return;
        }
        let shape = self.kernel.shape(self.kernel.read_of(number));
        match access.value {
            None => {
                let value = match shape {
                    Some(shape @ (Shape::Halves | Shape::Words | Shape::Wide)) if self.lanes > 1 => {
                        self.t.read_lanes(address.base, address.offset, shape, self.lanes)
                    }
                    _ => Lanes::One(match (access.width, address.bit) {
                        (Width::Bit, Bit::Number(bit)) => {
                            let byte = self.byte(number, address, level);
                            Translator::bit_value(byte, bit, false)
                        }
                        _ => self.t.read(address, access.width),
                    }),
                };
                let node = self.kernel.read_of(number);
                self.scope(level).values.insert(node, value);
            }
            Some(value) => {
                if self.lanes == 1
                    && let Some(unless) = self.kernel.unless_kept(access, value)
                {
                    return self.write_unless_kept(number, address, unless, level);
                }
                let together = if self.lanes == 1 && access.width == Width::Byte { self.byte_of_bits(value, level) } else { None };
                let value = together.map_or_else(|| self.value(value, level), Lanes::One);
                if self.lanes > 1 {
                    self.t.write_lanes(address.base, address.offset, &value, access.width.bytes() as u8, self.lanes);
                } else if let Lanes::One(value) = value {
                    let new = (access.width == Width::Bit && matches!(address.bit, Bit::Number(_))).then(|| {
                        let old = self.byte(number, address, level);
                        self.t.with_bit(old, address.bit, value)
                    });
                    match new {
                        Some(new) => drop(self.t.b.ins().istore8(data(), new, address.base, address.offset)),
                        None => self.t.write(address, access.width, value),
                    }
                    self.forget_bytes(number, address, level);
                    if let Some(new) = new {
                        self.scope(level).bytes.push((address.base, address.offset, number, vec![new]));
                    }
                }
            }
        }
    }

    /// Writes what takes the place of what was there, and nothing if that is kept. Mostly it is, and who reads there later need not wait
    /// for what would have been chosen.
    fn write_unless_kept(&mut self, number: usize, address: Address, unless: ConditionalStore, level: Level) {
        let condition = self.first(unless.condition, level);
        let value = self.first(unless.new, level);
        let value = self.t.force(value);
        let flag = self.t.flag(condition);
        let [written, behind] = [(); 2].map(|()| self.t.b.create_block());
        let (then, otherwise) = if unless.if_not { (written, behind) } else { (behind, written) };
        self.t.b.ins().brif(flag, then, &[], otherwise, &[]);
        self.t.b.switch_to_block(written);
        self.t.b.seal_block(written);
        self.t.write(address, self.kernel.accesses[number].width, value);
        self.t.b.ins().jump(behind, &[]);
        self.t.b.switch_to_block(behind);
        self.t.b.seal_block(behind);
        self.forget_bytes(number, address, level);
    }

    /// A byte that is another value with some of its bits set again, in an iteration by itself: from the highest bit on, each step moves
    /// those before and adds the next one, which is a single instruction.
    fn byte_of_bits(&mut self, node: Node, level: Level) -> Option<Val> {
        let (rest, bits) = self.kernel.bits_set_in(node)?;
        let (known, computed): (Vec<_>, Vec<_>) = bits.into_iter().partition(|&(_, set)| self.kernel.constant(set).is_some());
        let rest = self.first(rest, level);
        let mut byte = self.t.int(rest);
        let ones = known.iter().filter(|&&(_, set)| self.kernel.constant(set).is_some_and(|set| set & 1 != 0));
        let ones = ones.fold(0, |ones, &(bit, _)| ones | 1 << bit);
        if ones != 0 {
            byte = self.t.b.ins().bor_imm_u(byte, ones);
        }
        let mut made: Option<(Value, u32)> = None;
        for (bit, set) in computed.into_iter().rev() {
            let set = self.first(set, level);
            let flag = self.t.int(set);
            let value = match made {
                Some((higher, above)) => {
                    let moved = self.t.b.ins().ishl_imm_u(higher, i64::from(above - bit));
                    self.t.b.ins().iadd(moved, flag)
                }
                None => flag,
            };
            made = Some((value, bit));
        }
        if let Some((bits, lowest)) = made {
            let moved = self.t.b.ins().ishl_imm_u(bits, i64::from(lowest));
            byte = self.t.b.ins().bor(byte, moved);
        }
        Some(Val::Int(byte))
    }

    /// Where an access goes with a pointer.
    pub(super) fn address_at(&mut self, access: &Access, pointer: Val) -> Address {
        let (base, start, length) = access.area;
        let base = self.base(base);
        self.t.address_inside((base, start, length), pointer, access.offset, (access.width, access.width.bytes()))
    }

    /// The same where the variables of vectorized iterations lie apart.
    fn access_apart(&mut self, number: usize, apart: Strided, level: Level) {
        let access = &self.kernel.accesses[number];
        let node = self.kernel.read_of(number);
        let bit = match apart.first.bit {
            Bit::Number(bit) if access.width == Width::Bit => Some(bit),
            _ => None,
        };
        let Some(value) = access.value else {
            let value = match bit {
                Some(bit) => {
                    let bytes = self.bytes_apart(number, apart, level);
                    bytes.iter().for_each(|&vector| self.t.put_together(apart, vector));
                    self.t.bits_of_bytes(&bytes, bit)
                }
                None => {
                    let shape = self.kernel.shape(node).expect("the shapes were looked at");
                    match self.read_in_rows(number, apart) {
                        Some(column) => self.t.of_column(column, shape, access.width),
                        None => self.t.read_apart(apart, shape, access.width, self.lanes),
                    }
                }
            };
            let scope = self.scope(level);
            scope.values.insert(node, value);
            scope.sources.push((number, apart));
            return;
        };
        let new = match bit {
            Some(bit) => {
                let value = self.value(value, level);
                let bytes = self.bytes_apart(number, apart, level);
                Some(self.t.with_bits(&bytes, bit, &value, self.lanes))
            }
            None => self.column_of_bits(number, value, level).map(|column| vec![column]),
        };
        let written = match &new {
            Some(new) => Lanes::Words(new.clone()),
            None => self.value(value, level),
        };
        if !self.write_in_rows(number, apart, &written, new.is_some()) {
            match &new {
                Some(new) => self.t.write_bytes_apart(apart, new),
                None => self.t.write_apart(apart, access.width, &written, self.lanes),
            }
        }
        self.forget_bytes(number, apart.first, level);
        if let Some(new) = new {
            self.scope(level).bytes.push((apart.first.base, apart.first.offset, number, new));
        }
    }

    /// What a byte that is written was with some of its bits set again, and the bytes behind it that were read with it.
    fn column_of_bits(&mut self, number: usize, node: Node, level: Level) -> Option<Value> {
        let (rest, bits) = self.kernel.bits_set_in(node).filter(|_| self.kernel.accesses[number].width == Width::Byte)?;
        let (read, kept) = match self.kernel.what(rest) {
            Definition::Compute(Op::AndU32, [read, kept, ..]) => (read, self.kernel.constant(kept)?),
            _ => (rest, 0xFF),
        };
        let Definition::Read(_) = self.kernel.what(read) else { return None };
        let Lanes::Words(bytes) = self.value(read, level) else { return None };
        let column = self.column_with(number, *bytes.first()?)?;
        let mut cleared = !kept as u32 & 0xFF;
        let mut ones = 0;
        let mut masks: Vec<(Value, u32)> = Vec::new();
        for (bit, set) in bits {
            cleared |= 1 << bit;
            if let Some(set) = self.kernel.constant(set) {
                ones |= (set as u32 & 1) << bit;
                continue;
            }
            let value = self.value(set, level);
            let mask = match &value {
                Lanes::Mask(_) | Lanes::LongMask(_) => *self.t.masks(&value, self.lanes).first()?,
                _ => return None,
            };
            match masks.iter_mut().find(|(known, _)| *known == mask) {
                Some((_, own)) => *own |= 1 << bit,
                None => masks.push((mask, 1 << bit)),
            }
        }
        Some(self.t.with_bits_of_masks(column, cleared, ones, &masks))
    }

    /// The bytes with the bits to which an access goes in vectorized iterations.
    fn bytes_apart(&mut self, number: usize, apart: Strided, level: Level) -> Vec<Value> {
        let (base, offset) = (apart.first.base, apart.first.offset);
        let known = self.scope(level).bytes.iter().find(|(known, at, ..)| (*known, *at) == (base, offset));
        if let Some((.., bytes)) = known {
            return bytes.clone();
        }
        let bytes = match self.read_in_rows(number, apart) {
            Some(column) => vec![column],
            None => {
                let bytes = self.t.bytes_apart(apart, self.lanes);
                if apart.more {
                    self.note_old(number, bytes[0]);
                }
                bytes
            }
        };
        self.scope(level).bytes.push((base, offset, number, bytes.clone()));
        bytes
    }

    /// The byte with the bit to which an access goes.
    fn byte(&mut self, number: usize, Address { base, offset, .. }: Address, level: Level) -> Value {
        let bytes = &self.scope(level).bytes;
        if let Some((.., byte)) = bytes.iter().find(|(known, at, ..)| (*known, *at) == (base, offset)) {
            return byte[0];
        }
        let byte = self.t.b.ins().uload8(I32, data(), base, offset);
        self.scope(level).bytes.push((base, offset, number, vec![byte]));
        byte
    }

    /// Forgets the bytes that an access may have written.
    pub(super) fn forget_bytes(&mut self, number: usize, Address { base, offset, .. }: Address, level: Level) {
        let accesses = &self.kernel.accesses;
        let written = offset..offset + accesses[number].width.bytes() as i32;
        self.scope(level).bytes.retain(|&(other, at, access, _)| {
            if other == base {
                return !written.contains(&at);
            }
            !accesses[number].may_share(&accesses[access])
        });
    }
}

impl Access {
    /// What its address is counted on with.
    pub(super) fn counted(&self) -> (Base, Node, u32) {
        (self.area.0, self.pointer, if self.part.is_some() { 0 } else { self.offset })
    }
}
