//! Loads and stores of data memory: constant addresses are offsets, computed ones cost one comparison; what that does not cover, or fails,
//! is a slow path.

use std::mem::offset_of;
use std::ops::Range;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I16, I32, I64};
use cranelift_codegen::ir::{self as clif, BlockArg, InstBuilder, InstructionData, MemFlagsData, Opcode, Type, Value, ValueDef};
use sieben_engine::access;
use sieben_engine::ir::{DataRegister, Inst, OnFault, Place, Var};
use sieben_engine::machine::{CALLS_SHIFT, Register};
use sieben_model::address::{Area, Width};

use super::scalar_promotion::Base;
use super::value::Val;
use super::{Continuation, Translator};
use crate::run::{Link, Run};
use crate::runtime_calls::RuntimeCall;

/// The bits above the address of a pointer to the local data of the caller that no call has passed on.
pub(super) const LOCAL_OF_CALLER: i64 = (Area::CallerLocal.pointer_code() as i64) << (24 - CALLS_SHIFT);

/// Data memory: always there, at any alignment.
pub(super) fn data() -> MemFlagsData {
    MemFlagsData::new().with_notrap()
}

/// A bit of a byte.
#[derive(Clone, Copy)]
pub(super) enum Bit {
    Number(u8),
    /// Its number, 0 to 7, in 32 bits.
    Computed(Value),
}

/// An address: base, offset and bit.
#[derive(Clone, Copy)]
pub(super) struct Address {
    pub(super) base: Value,
    pub(super) offset: i32,
    pub(super) bit: Bit,
}

/// How a place is reached.
enum AddressingMode {
    /// It is there.
    Direct(Address),
    /// It is there, among these bytes.
    Inside(Address, (Base, Range<i64>)),
    /// It is there if the condition holds.
    Checked(Value, Address),
    /// By Rust code.
    Asked,
}

impl Translator<'_> {
    pub(super) fn load(&mut self, index: u32, dst: Var, place: Place, width: Width, on_fault: OnFault) {
        let way = self.way(index, place, width, on_fault == OnFault::SkipWrite);
        let value = match &way {
            AddressingMode::Direct(address) => Some(self.read_known(*address, width)),
            AddressingMode::Inside(address, touched) => Some(self.read_inside(*address, touched, width)),
            _ => None,
        };
        if let Some(value) = value {
            self.note_range(index, value);
            self.set(dst, value);
            return;
        }
        self.store_waiting();
        if on_fault == OnFault::DeliverZero {
            // Whoever is asked inside a statement sees what it has passed so far.
            self.store_passed();
        }
        let go_on = self.b.create_block();
        // A quad word is the only value of more than 32 bits.
        let wide = width == Width::QuadWord;
        let delivered = self.b.append_block_param(go_on, if wide { I64 } else { I32 });
        let slow = match way {
            AddressingMode::Checked(condition, address) => {
                let [fast, slow] = [self.b.create_block(), self.cold_block()];
                self.b.ins().brif(condition, fast, &[], slow, &[]);
                self.b.switch_to_block(fast);
                self.b.seal_block(fast);
                self.store_touched(place);
                let value = self.read(address, width);
                let value = match width {
                    Width::Bit => self.bit(value),
                    Width::QuadWord => self.word(value),
                    _ => self.int(value),
                };
                self.b.ins().jump(go_on, &[BlockArg::Value(value)]);
                slow
            }
            AddressingMode::Direct(_) | AddressingMode::Inside(..) | AddressingMode::Asked => {
                let slow = self.b.create_block();
                self.b.ins().jump(slow, &[]);
                slow
            }
        };
        self.b.switch_to_block(slow);
        self.b.seal_block(slow);
        let before = self.cold.replace(slow);
        let pointer = self.pointer(place);
        self.store_open_blocks();
        let site = self.site(index);
        let failed = self.ask(RuntimeCall::TryLoad, &[self.link, site, pointer]);
        let value = self.result();
        let value = if wide { value } else { self.b.ins().ireduce(I32, value) };
        let after = if on_fault == OnFault::DeliverZero { Continuation::Deliver(go_on) } else { Continuation::NextStatement };
        self.go_on_behind_question((failed, site), (go_on, &[BlockArg::Value(value)]), after, before);
        let delivered = match width {
            Width::Bit => Val::Bit { value: delivered, clean: false },
            Width::QuadWord => Val::Word(delivered),
            _ => Val::Int(delivered),
        };
        self.set(dst, delivered);
    }

    pub(super) fn store(&mut self, index: u32, place: Place, width: Width, value: Val) {
        let go_on;
        let slow = match self.way(index, place, width, true) {
            AddressingMode::Direct(address) => {
                self.write_known(address, width, value);
                return;
            }
            AddressingMode::Inside(address, touched) => {
                self.write_inside(address, &touched, width, value);
                return;
            }
            AddressingMode::Checked(condition, address) => {
                // Needed on both ways.
                let value = self.force(value);
                go_on = self.b.create_block();
                let [fast, slow] = [self.b.create_block(), self.cold_block()];
                self.b.ins().brif(condition, fast, &[], slow, &[]);
                self.b.switch_to_block(fast);
                self.b.seal_block(fast);
                self.store_touched(place);
                self.write(address, width, value);
                self.take_touched(place);
                self.b.ins().jump(go_on, &[]);
                slow
            }
            AddressingMode::Asked => {
                self.store_waiting();
                go_on = self.b.create_block();
                let slow = self.b.create_block();
                self.b.ins().jump(slow, &[]);
                slow
            }
        };
        self.b.switch_to_block(slow);
        self.b.seal_block(slow);
        let before = self.cold.replace(slow);
        let value = self.word(value);
        let pointer = self.pointer(place);
        self.store_open_blocks();
        let site = self.site(index);
        let failed = self.ask(RuntimeCall::TryStore, &[self.link, site, pointer, value]);
        self.go_on_behind_question((failed, site), (go_on, &[]), Continuation::NextStatement, before);
    }

    /// Goes on at a block, which ends the cold code that asked a question there, unless that has failed at a site.
    pub(super) fn go_on_behind_question(
        &mut self,
        (failed, site): (Value, Value),
        (go_on, arguments): (clif::Block, &[BlockArg]),
        after: Continuation,
        before: Option<clif::Block>,
    ) {
        let cold = self.cold_block();
        self.b.ins().brif(failed, cold, &[], go_on, arguments);
        self.cold_path(cold, RuntimeCall::Failed, &[self.link, site], after);
        self.cold = before;
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.forget_what_was_asked();
    }

    /// How a place is reached.
    fn way(&mut self, index: u32, place: Place, width: Width, write: bool) -> AddressingMode {
        match place {
            Place::Fixed { area, position } => self.way_to_constant(area, position, width, write),
            Place::Indirect { area, pointer, offset } => {
                let pointer = self.get(pointer);
                let pointer = self.force(pointer);
                match pointer.constant() {
                    Some(pointer) => self.way_to_constant(area, moved(pointer, offset), width, write),
                    None => self.way_to_pointer(index, area, (pointer, offset), width, write),
                }
            }
            Place::Crossing { pointer, offset } => {
                let pointer = self.get(pointer);
                let pointer = self.force(pointer);
                let Some(constant) = pointer.constant() else {
                    let bits = self.int(pointer);
                    let known = self.ranges.pointed_area(index, self.is_store(index));
                    let area = known.or_else(|| self.area_code(bits).and_then(|code| access::pointed_area(code, write).ok()));
                    return match area {
                        Some(area @ (Area::SharedData | Area::InstanceData)) => {
                            self.way_to_pointer(index, area, (pointer, offset), width, write)
                        }
                        Some(Area::CallerLocal) if let Some(way) = self.way_inside_caller(index, (pointer, offset), width) => way,
                        _ => self.way_to_any_area(pointer, offset, width, write),
                    };
                };
                let pointer = constant;
                match access::pointed_area(pointer, write) {
                    Ok(Area::CallerLocal) => match self.way_to_caller(moved(pointer, offset), width) {
                        Some((offset, bit)) => AddressingMode::Direct(Address { base: self.local, offset, bit: Bit::Number(bit) }),
                        None => AddressingMode::Asked,
                    },
                    Ok(Area::PeripheralInput | Area::PeripheralOutput) | Err(_) => AddressingMode::Asked,
                    Ok(area) => self.way_to_constant(area, moved(pointer, offset), width, write),
                }
            }
        }
    }

    /// A computed position in the local data of the caller, if that is in this function and the access is known to stay there.
    fn way_inside_caller(&mut self, index: u32, (pointer, offset): (Val, u32), width: Width) -> Option<AddressingMode> {
        let touched = self.ranges.inside(index)?;
        let address = self.address_in_caller(&touched, (pointer, offset), (width, width.bytes()))?;
        Some(AddressingMode::Inside(address, touched))
    }

    /// The address of bytes in the local data of a caller that is in this function, if they are known to lie there.
    pub(super) fn address_in_caller(
        &mut self,
        (base, touched): &(Base, Range<i64>),
        (pointer, offset): (Val, u32),
        access: (Width, u32),
    ) -> Option<Address> {
        let is_there = |&(_, (first, bytes)): &(u32, (i32, usize))| {
            touched.start >= i64::from(first) && touched.end <= i64::from(first) + bytes as i64
        };
        let callers = (0..).map_while(|calls: u32| Some((calls, self.caller_local(calls as usize)?)));
        let (calls, (first, bytes)) = { callers }.find(is_there).filter(|_| *base == Base::Local)?;
        // The pointer counts the calls, too.
        let offset = offset.wrapping_sub(calls << CALLS_SHIFT);
        Some(self.address_inside((self.local, first, bytes as u64), pointer, offset, access))
    }

    fn is_store(&self, index: u32) -> bool {
        matches!(self.native().code.insts[index as usize], Inst::Store { .. })
    }

    /// First byte and number of bytes of an area, if they are known beforehand.
    fn area(&self, area: Area) -> Option<(Value, i32, usize)> {
        match area {
            Area::Local => Some((self.local, self.local_offset, self.native().local_size as usize)),
            _ => {
                let range = self.layout.area(area)?;
                Some((self.arena, i32::try_from(range.start).ok()?, range.len()))
            }
        }
    }

    /// Number, base and length of an open data block, unless it may be protected and is written.
    pub(super) fn open_block(&mut self, area: Area, write: bool) -> Option<(Val, Val)> {
        let register = match area {
            Area::SharedData => DataRegister::Shared,
            Area::InstanceData => DataRegister::Instance,
            _ => return None,
        };
        let [number, base, length] = sieben_engine::access::data_registers(register).map(|register| self.register(register));
        let protected = match number {
            Val::Const(number) => self.layout.read_only.iter().any(|&protected| u64::from(protected) == number),
            _ => self.options.asks_before_writing,
        };
        (!(write && protected)).then_some((base, length))
    }

    /// Whether a place may lie in a data block that is protected.
    pub(super) fn is_protected(&self, place: Place) -> bool {
        let (Place::Fixed { area, .. } | Place::Indirect { area, .. }) = place else { return true };
        let register = match area {
            Area::SharedData => Register::DbNumber,
            Area::InstanceData => Register::DiNumber,
            _ => return false,
        };
        match self.current[register as usize] {
            Some(Val::Const(number)) => self.layout.read_only.iter().any(|&protected| u64::from(protected) == number),
            _ => true,
        }
    }

    /// First byte and number of bytes of an area, or of an open data block that is known beforehand and may be accessed.
    pub(super) fn known_area(&mut self, area: Area, write: bool) -> Option<(Value, i32, u64)> {
        if let Some((base, start, length)) = self.area(area) {
            return Some((base, start, length as u64));
        }
        match self.open_block(area, write)? {
            (Val::Const(base), Val::Const(length)) => Some((self.arena, i32::try_from(base).ok()?, length)),
            _ => None,
        }
    }

    fn way_to_constant(&mut self, area: Area, position: u32, width: Width, write: bool) -> AddressingMode {
        let (byte, bit) = (position / 8, (position % 8) as u8);
        if width != Width::Bit && bit != 0 {
            return AddressingMode::Asked;
        }
        let end = u64::from(byte) + u64::from(width.bytes());
        if let Some((base, start, length)) = self.area(area) {
            return match i32::try_from(i64::from(start) + i64::from(byte)) {
                Ok(offset) if end <= length as u64 => AddressingMode::Direct(Address { base, offset, bit: Bit::Number(bit) }),
                _ => AddressingMode::Asked,
            };
        }
        let Some((base, length)) = self.open_block(area, write) else { return AddressingMode::Asked };
        let Ok(offset) = i32::try_from(byte) else { return AddressingMode::Asked };
        if let (Val::Const(base), Val::Const(length)) = (base, length) {
            return match i32::try_from(base + u64::from(byte)) {
                Ok(offset) if end <= length => AddressingMode::Direct(Address { base: self.arena, offset, bit: Bit::Number(bit) }),
                _ => AddressingMode::Asked,
            };
        }
        let (base, length) = (self.word(base), self.word(length));
        let inside = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThanOrEqual, length, end as i64);
        let base = self.b.ins().iadd(self.arena, base);
        AddressingMode::Checked(inside, Address { base, offset, bit: Bit::Number(bit) })
    }

    fn way_to_pointer(&mut self, index: u32, area: Area, (pointer, offset): (Val, u32), width: Width, write: bool) -> AddressingMode {
        let (base, start, length) = if let Some((base, start, length)) = self.area(area) {
            (base, start, Val::Const(length as u64))
        } else if let Some((base, length)) = self.open_block(area, write) {
            match base {
                Val::Const(base) if i32::try_from(base).is_ok() => (self.arena, base as i32, length),
                base => {
                    let base = self.word(base);
                    (self.b.ins().iadd(self.arena, base), 0, length)
                }
            }
        } else {
            return AddressingMode::Asked;
        };
        let inside = self.ranges.inside(index).or_else(|| {
            let (Val::Const(length), Val::Int(pointer)) = (length, pointer) else { return None };
            let bytes = self.bytes_at(length, (pointer, offset), width).filter(|_| base == self.arena)?;
            Some((Base::Arena, i64::from(start) + bytes.start..i64::from(start) + bytes.end))
        });
        if let (Val::Const(length), Some(touched)) = (length, inside) {
            if let Some(address) = self.field((base, start, length), (pointer, offset), (width, width.bytes()), &touched, write) {
                return AddressingMode::Direct(address);
            }
            return AddressingMode::Inside(self.address_inside((base, start, length), pointer, offset, (width, width.bytes())), touched);
        }
        let bits = self.int(pointer);
        match self.indexed_in_instance(area, (bits, offset), width) {
            Some(address) => AddressingMode::Direct(address),
            None => self.way_in(base, start, length, pointer, offset, width),
        }
    }

    /// A pointer whose area is known only when the program runs: I, Q, M, an open data block, or the local data of the caller.
    fn way_to_any_area(&mut self, pointer: Val, offset: u32, width: Width, write: bool) -> AddressingMode {
        if write && self.options.asks_before_writing {
            return AddressingMode::Asked;
        }
        let bits = self.int(pointer);
        let code = self.b.ins().ushr_imm_u(bits, 24);
        // Most pointers are to data blocks: the machine guesses that.
        let [base, bytes] = [Register::DbBase, Register::DbLength].map(|register| {
            let value = self.register(register);
            self.word(value)
        });
        let (others, behind) = (self.b.create_block(), self.b.create_block());
        let [found_start, found_length] = [(); 2].map(|()| self.b.append_block_param(behind, I64));
        let is_block = self.b.ins().icmp_imm_u(IntCC::Equal, code, i64::from(Area::SharedData.pointer_code()));
        self.b.ins().brif(is_block, behind, &[BlockArg::Value(base), BlockArg::Value(bytes)], others, &[]);
        self.b.switch_to_block(others);
        self.b.seal_block(others);
        let (start, length) = self.area_by_code(bits);
        let is_it = self.b.ins().icmp_imm_u(IntCC::Equal, code, i64::from(Area::InstanceData.pointer_code()));
        let [base, bytes] = [Register::DiBase, Register::DiLength].map(|register| {
            let value = self.register(register);
            self.word(value)
        });
        let start = self.b.ins().select(is_it, base, start);
        let length = self.b.ins().select(is_it, bytes, length);
        let (start, length) = self.or_of_caller(bits, (start, length));
        self.b.ins().jump(behind, &[BlockArg::Value(start), BlockArg::Value(length)]);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
        let (start, length) = (found_start, found_length);
        let base = self.b.ins().iadd(self.arena, start);
        self.way_in(base, 0, Val::Word(length), pointer, offset, width)
    }

    /// First byte and number of bytes of I, Q or M, to which a pointer leads; none if it leads elsewhere. They stand in a table under their
    /// codes, 16#81 to 16#83; it has 16 places, and the code chooses without a branch.
    fn area_by_code(&mut self, bits: Value) -> (Value, Value) {
        let group = self.b.ins().ushr_imm_u(bits, 28);
        let known = self.b.ins().icmp_imm_u(IntCC::Equal, group, 8);
        let code = self.b.ins().ushr_imm_u(bits, 24);
        let index = self.b.ins().band_imm_u(code, 0xF);
        let none = self.b.ins().iconst(I32, 0);
        let index = self.b.ins().select(known, index, none);
        let index = self.b.ins().uextend(I64, index);
        let moved = self.b.ins().ishl_imm_u(index, 4);
        let table = self.load_run(offset_of!(Run<'_, '_>, areas));
        let entry = self.b.ins().iadd(table, moved);
        let trusted = MemFlagsData::trusted();
        (self.b.ins().load(I64, trusted, entry, 0), self.b.ins().load(I64, trusted, entry, 8))
    }

    /// First byte and number of bytes of the local data of the caller, if a pointer leads there, else those of another area. The local data
    /// of the caller end where those of this block begin. A pointer that was passed on further is asked for.
    fn or_of_caller(&mut self, bits: Value, (start, length): (Value, Value)) -> (Value, Value) {
        if !self.called_only() {
            return (start, length);
        }
        let (caller, bytes) = match self.caller_local(0) {
            Some((offset, bytes)) => (self.b.ins().iadd_imm_u(self.local, i64::from(offset)), self.b.ins().iconst(I64, bytes as i64)),
            None => {
                let caller = -(size_of::<Link>() as i32) + offset_of!(Link, local) as i32;
                let caller = self.b.ins().load(I64, MemFlagsData::trusted(), self.link, caller);
                (caller, self.b.ins().isub(self.local, caller))
            }
        };
        let caller = self.b.ins().isub(caller, self.arena);
        let calls = self.b.ins().ushr_imm_u(bits, i64::from(CALLS_SHIFT));
        let is_caller = self.b.ins().icmp_imm_u(IntCC::Equal, calls, LOCAL_OF_CALLER);
        let start = self.b.ins().select(is_caller, caller, start);
        (start, self.b.ins().select(is_caller, bytes, length))
    }

    /// A computed position in an area.
    fn way_in(&mut self, base: Value, start: i32, length: Val, pointer: Val, offset: u32, width: Width) -> AddressingMode {
        let pointer = self.int(pointer);
        let pointer = if offset == 0 { pointer } else { self.b.ins().iadd_imm_u(pointer, i64::from(offset)) };
        let moved = self.b.ins().band_imm_u(pointer, 0x00FF_FFFF);
        // A pointer that is not to the beginning of a byte becomes a large number here, and fails the one comparison.
        let (byte, bit) = match width {
            Width::Bit => {
                let bit = self.b.ins().band_imm_u(moved, 7);
                (self.b.ins().ushr_imm_u(moved, 3), Bit::Computed(bit))
            }
            _ => (self.b.ins().rotr_imm_u(moved, 3), Bit::Number(0)),
        };
        let byte = self.b.ins().uextend(I64, byte);
        let bytes = i64::from(width.bytes());
        let inside = match length {
            Val::Const(length) if length < bytes as u64 => return AddressingMode::Asked,
            Val::Const(length) => self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, byte, length as i64 - bytes),
            length => {
                let length = self.word(length);
                let end = self.b.ins().iadd_imm_u(byte, bytes);
                self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, end, length)
            }
        };
        let base = self.b.ins().iadd(base, byte);
        AddressingMode::Checked(inside, Address { base, offset: start, bit })
    }

    pub(super) fn read(&mut self, Address { base, offset, bit }: Address, width: Width) -> Val {
        match width {
            Width::Bit => {
                let byte = self.b.ins().uload8(I32, data(), base, offset);
                match bit {
                    Bit::Number(0) => Val::Bit { value: byte, clean: false },
                    Bit::Number(bit) => Val::Bit { value: self.b.ins().ushr_imm_u(byte, i64::from(bit)), clean: bit == 7 },
                    Bit::Computed(bit) => Val::Bit { value: self.b.ins().ushr(byte, bit), clean: false },
                }
            }
            Width::Byte => {
                let value = self.b.ins().uload8(I32, data(), base, offset);
                if self.options.optimize {
                    self.narrow.insert(value, 8);
                }
                Val::Int(value)
            }
            Width::Word => {
                let word = self.b.ins().load(I16, data(), base, offset);
                let word = self.b.ins().bswap(word);
                let value = self.b.ins().uextend(I32, word);
                if self.options.optimize {
                    self.narrow.insert(value, 16);
                }
                Val::Int(value)
            }
            Width::DoubleWord => {
                let double = self.b.ins().load(I32, data(), base, offset);
                Val::Int(self.b.ins().bswap(double))
            }
            Width::QuadWord => {
                let quad = self.b.ins().load(I64, data(), base, offset);
                Val::Word(self.b.ins().bswap(quad))
            }
        }
    }

    pub(super) fn write(&mut self, Address { base, offset, bit }: Address, width: Width, value: Val) {
        match width {
            Width::Bit => {
                let old = self.b.ins().uload8(I32, data(), base, offset);
                let new = self.with_bit(old, bit, value);
                self.b.ins().istore8(data(), new, base, offset);
            }
            Width::Byte => {
                let value = self.int(value);
                self.b.ins().istore8(data(), value, base, offset);
            }
            Width::Word => {
                let word = match self.force(value) {
                    Val::Const(value) => self.b.ins().iconst(I16, i64::from((value as u16).swap_bytes())),
                    value => {
                        let value = self.int(value);
                        if self.is_product(value) {
                            let turned = self.b.ins().bswap(value);
                            let word = self.b.ins().ushr_imm_u(turned, 16);
                            self.b.ins().istore16(data(), word, base, offset);
                            return;
                        }
                        self.as_read(value, I16).unwrap_or_else(|| {
                            let word = self.b.ins().ireduce(I16, value);
                            self.b.ins().bswap(word)
                        })
                    }
                };
                self.b.ins().store(data(), word, base, offset);
            }
            Width::DoubleWord => {
                let double = match self.force(value) {
                    Val::Const(value) => self.b.ins().iconst(I32, i64::from((value as u32).swap_bytes())),
                    value => {
                        let value = self.int(value);
                        self.as_read(value, I32).unwrap_or_else(|| self.b.ins().bswap(value))
                    }
                };
                self.b.ins().store(data(), double, base, offset);
            }
            Width::QuadWord => {
                let value = self.word(value);
                let quad = self.b.ins().bswap(value);
                self.b.ins().store(data(), quad, base, offset);
            }
        }
    }

    /// A byte with one of its bits written again.
    pub(super) fn with_bit(&mut self, old: Value, bit: Bit, value: Val) -> Value {
        let value = self.force(value);
        match (value, bit) {
            (Val::Const(value), Bit::Number(bit)) if value & 1 != 0 => self.b.ins().bor_imm_u(old, 1 << bit),
            (Val::Const(_), Bit::Number(bit)) => self.b.ins().band_imm_u(old, i64::from(!(1u8 << bit))),
            (value, Bit::Number(bit)) => {
                let cleared = self.b.ins().band_imm_u(old, i64::from(!(1u8 << bit)));
                let flag = self.flag(value);
                let moved = if bit == 0 { flag } else { self.b.ins().ishl_imm_u(flag, i64::from(bit)) };
                self.b.ins().bor(cleared, moved)
            }
            (value, Bit::Computed(bit)) => {
                let one = self.b.ins().iconst(I32, 1);
                let mask = self.b.ins().ishl(one, bit);
                let cleared = self.b.ins().band_not(old, mask);
                let flag = self.flag(value);
                let moved = self.b.ins().ishl(flag, bit);
                self.b.ins().bor(cleared, moved)
            }
        }
    }

    /// A number in the byte order of memory, if it has just been read from there.
    fn as_read(&self, value: Value, ty: Type) -> Option<Value> {
        let dfg = &self.b.func.dfg;
        let unary = |value: Value, expected: Opcode| match dfg.value_def(dfg.resolve_aliases(value)) {
            ValueDef::Result(inst, 0) => match dfg.insts[inst] {
                InstructionData::Unary { opcode, arg } if opcode == expected => Some(arg),
                _ => None,
            },
            _ => None,
        };
        let value = if ty == I16 { unary(value, Opcode::Uextend)? } else { value };
        unary(value, Opcode::Bswap).filter(|&read| dfg.value_type(read) == ty)
    }

    /// The value of a place's pointer, 0 if it has none.
    pub(super) fn pointer(&mut self, place: Place) -> Value {
        let value = match place {
            Place::Fixed { .. } => Val::Const(0),
            Place::Indirect { pointer, .. } | Place::Crossing { pointer, .. } => self.get(pointer),
        };
        self.word(value)
    }

    /// Stores the data block registers, from which Rust code reads.
    pub(super) fn store_open_blocks(&mut self) {
        let registers = super::OPEN_BLOCKS.iter().fold(0, |all, &register| all | super::bit_of(register)) & self.dirty;
        self.spill(registers);
        if self.cold.is_none() {
            self.dirty &= !registers;
        }
    }
}

/// A pointer moved by an offset, 24 bits.
pub(super) fn moved(pointer: u64, offset: u32) -> u32 {
    ((pointer & 0x00FF_FFFF) + u64::from(offset)) as u32 & 0x00FF_FFFF
}
