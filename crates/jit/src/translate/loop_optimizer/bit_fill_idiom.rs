//! Loop idiom: loops that only set or reset bits of an array with a stride write a byte at a time, or 16 bytes.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I8X16, I32, I64};
use cranelift_codegen::ir::{BlockArg, InstBuilder, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::data;
use super::super::natural_loops::NaturalLoop;
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::kernel::{Definition, Kernel, Level, Node, Slot};
use crate::passes::Pass;

/// Bits that are written with one store.
const BITS_OF_A_VECTOR: i64 = 128;
/// Iterations from which it pays to write whole bytes: at least one is written.
const FILLED_MIN: i64 = 16;
/// Iterations from which it pays to look how many there are.
const CROSSED_MIN: i64 = 3;
/// Iterations from which it pays to go over the bytes once for each bit of a byte.
const PASSES_MIN: i64 = 40;

/// How many bits one lies behind the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stride {
    One,
    Computed(Node),
}

/// What the variable that counts can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct CounterType {
    pub(super) bits: u32,
    pub(super) signed: bool,
}

impl CounterType {
    pub(super) fn most(self) -> i64 {
        if self.signed { (1 << (self.bits - 1)) - 1 } else { (1 << self.bits) - 1 }
    }
}

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FillValue {
    /// Bits, all of them set or not.
    Bits(bool),
    /// Whole bytes.
    Bytes(u8),
}

impl FillValue {
    /// The bits of each of them.
    fn bits(self) -> i64 {
        match self {
            Self::Bits(_) => 1,
            Self::Bytes(_) => 8,
        }
    }
}

/// A loop that writes bits or bytes.
#[derive(Debug)]
pub(super) struct BitFill {
    /// The variable that counts.
    counter: Slot,
    of: CounterType,
    stride: Stride,
    /// The last number with which another iteration is made, or the one behind it.
    limit: Node,
    inclusive: bool,
    pointer: Node,
    offset: u32,
    area: (Base, i32, u64),
    written: FillValue,
    /// What else is the same behind each iteration.
    same: Vec<(Slot, u64)>,
}

/// Bits of an area that are set or not.
type Bit = ((Base, i32, u64), bool);

/// The condition of another iteration of a loop that counts up.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContinueCondition {
    pub(super) counted: Node,
    pub(super) limit: Node,
    pub(super) inclusive: bool,
    pub(super) of: CounterType,
}

/// What a loop does, if it only writes bits.
pub(super) fn read(kernel: &Kernel) -> Option<BitFill> {
    if !kernel.passes.has(Pass::BitFillIdiom) {
        return None;
    }
    let (mut same, mut counted) = (Vec::new(), Vec::new());
    for (&slot, &end) in &kernel.outer.ends {
        match kernel.constant(end) {
            Some(value) => same.push((slot, value)),
            None => counted.push((slot, end)),
        }
    }
    let (&[(counter, end)], None) = (counted.as_slice(), &kernel.inner) else { return None };
    let mut stores = kernel.accesses.iter().filter_map(|access| Some((access, access.value?)));
    let (Some((store, value)), None) = (stores.next(), stores.next()) else { return None };
    // A read that nobody needs may be an error.
    if kernel.accesses.iter().any(|access| access.value.is_none() && !(access.sure && access.inside.is_some())) {
        return None;
    }
    let value = kernel.constant(value)?;
    let written = match store.width {
        Width::Bit => FillValue::Bits(value & 1 != 0),
        Width::Byte => FillValue::Bytes(value as u8),
        _ => return None,
    };
    if kernel.outer.blocks_most != 0 {
        return None;
    }
    let start = |node: Node| kernel.is_start(node, Level::Outer, counter);
    let Definition::Compute(op, [a, b, ..]) = kernel.what(end) else { return None };
    let (own, step) = if start(a) { (a, b) } else { (b, a) };
    if !start(own) || start(step) {
        return None;
    }
    let fits = match op {
        Op::AddU16 => kernel.is_16_bits(own),
        _ => op == Op::AddU32 && kernel.is_32_bits(own),
    };
    let ContinueCondition { counted, limit, inclusive, of } = condition(kernel, kernel.outer.again, own, step)?;
    let unchanged = |node: Node| match kernel.what(node) {
        Definition::Constant(_) => true,
        Definition::Start(Level::Outer, slot) => !kernel.outer.ends.contains_key(&slot),
        _ => false,
    };
    let of_a_type = counted == end && of.bits == if op == Op::AddU16 { 16 } else { 32 };
    if !fits || !of_a_type || !unchanged(limit) || !unchanged(step) || !of.signed && !kernel.is_32_bits(limit) {
        return None;
    }
    // Pointers, and numbers that have to stay below limits, are the counter and something that stays.
    let follows = |node: Node| is_counter_and_more(kernel, node, own, of, &unchanged);
    let points = match written {
        FillValue::Bits(_) => follows(store.pointer),
        FillValue::Bytes(_) => is_eight_times(kernel, store.pointer, &follows, &unchanged),
    };
    if !points || !kernel.required.iter().all(|&(number, _)| follows(number)) {
        return None;
    }
    let stride = match kernel.constant(step) {
        Some(1) => Stride::One,
        _ => Stride::Computed(step),
    };
    let (pointer, offset, area) = (store.pointer, store.offset, store.area);
    Some(BitFill { counter, of, stride, limit, inclusive, pointer, offset, area, written, same })
}

/// The condition under which a loop goes on that counts up by a step, which is above 0, and does not leave its type.
pub(super) fn condition(kernel: &Kernel, node: Node, own: Node, step: Node) -> Option<ContinueCondition> {
    let Definition::Compute(op, [a, b, c, _]) = kernel.what(node) else { return None };
    let made = |counted: Node, limit: Node, inclusive: bool, bits: u32| {
        Some(ContinueCondition { counted, limit, inclusive, of: CounterType { bits, signed: true } })
    };
    let unsigned = |counted: Node, limit: Node, inclusive: bool| {
        let of = CounterType { bits: if kernel.is_16_bits(own) { 16 } else { 32 }, signed: false };
        Some(ContinueCondition { counted, limit, inclusive, of })
    };
    match op {
        Op::LeI32 => made(a, b, true, 32),
        Op::LtI32 => made(a, b, false, 32),
        Op::LeI16 => made(a, b, true, 16),
        Op::LtI16 => made(a, b, false, 16),
        Op::LeU64 => unsigned(a, b, true),
        Op::Below => unsigned(a, b, false),
        Op::GeU64 => unsigned(b, a, true),
        Op::GtU64 => unsigned(b, a, false),
        // A step that is a variable may be below 0, and may lead out of the type.
        Op::AndNot => match kernel.what(b) {
            Definition::Compute(Op::AddOverflowsI32 | Op::AddOverflowsI16, [of, by, ..]) if (of, by) == (own, step) => {
                condition(kernel, a, own, step)
            }
            _ => None,
        },
        Op::Select => match kernel.what(a) {
            Definition::Compute(Op::LtI32 | Op::LtI16, [of, zero, ..]) if of == step && kernel.constant(zero) == Some(0) => {
                condition(kernel, c, own, step)
            }
            _ => None,
        },
        _ => None,
    }
}

/// Whether a number of 32 bits is that which the counter holds and something that no iteration changes.
fn is_counter_and_more(kernel: &Kernel, node: Node, own: Node, of: CounterType, unchanged: &dyn Fn(Node) -> bool) -> bool {
    let is = |node: Node| is_counter_and_more(kernel, node, own, of, unchanged);
    match kernel.what(node) {
        Definition::Compute(Op::Extend16, [counter, ..]) => counter == own && of == CounterType { bits: 16, signed: true },
        Definition::Compute(Op::AddU32, [a, b, ..]) => is(a) && unchanged(b) || is(b) && unchanged(a),
        Definition::Compute(Op::SubU32, [a, b, ..]) => is(a) && unchanged(b),
        _ => node == own && (of.bits == 32 || !of.signed),
    }
}

/// Whether a number is eight times one that follows the counter, and something that stays.
fn is_eight_times(kernel: &Kernel, node: Node, follows: &dyn Fn(Node) -> bool, unchanged: &dyn Fn(Node) -> bool) -> bool {
    let is = |node: Node| is_eight_times(kernel, node, follows, unchanged);
    match kernel.what(node) {
        Definition::Compute(Op::Shl32, [index, count, ..]) => follows(index) && kernel.constant(count) == Some(3),
        Definition::Compute(Op::AddU32, [a, b, ..]) => is(a) && unchanged(b) || is(b) && unchanged(a),
        Definition::Compute(Op::SubU32, [a, b, ..]) => is(a) && unchanged(b),
        _ => false,
    }
}

impl Translator<'_> {
    /// Writes iterations of a loop that writes bits, as many as there are and as the budget covers, and goes on where more iterations may
    /// follow.
    pub(super) fn bits_at_once(&mut self, kernel: &Kernel, bits: &BitFill, it: &NaturalLoop) {
        self.settle_bytes();
        let weight = i64::from(kernel.outer.weight);
        let counter = self.slot_before(kernel, bits.counter);
        let limit = self.value_in_front(kernel, bits.limit);
        let step = match bits.stride {
            Stride::One => Val::Const(1),
            Stride::Computed(step) => self.value_in_front(kernel, step),
        };
        let [first, limit, step] = [counter, limit, step].map(|value| self.number_of(bits.of, value));
        let position = self.position_of_bits(kernel, bits);
        // A step that is not above 0 makes no iterations here.
        let up = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThan, step, 0);
        let one = self.b.ins().iconst(I64, 1);
        let divisor = self.b.ins().select(up, step, one);
        let way = self.b.ins().isub(limit, first);
        let way = if bits.inclusive { way } else { self.b.ins().iadd_imm_s(way, -1) };
        let [enter, go_on, leave] = [self.b.create_block(), self.b.create_block(), self.b.create_block()];
        let steps = match bits.stride {
            Stride::One => way,
            // Where there is a way, both are above 0 and fit into 32 bits, in which a division takes half the time. It is left out where
            // few iterations are left, as behind most of the primes of a sieve.
            Stride::Computed(_) => {
                let least = self.b.ins().imul_imm_s(step, CROSSED_MIN - 1);
                let pays = self.b.ins().icmp(IntCC::SignedGreaterThanOrEqual, way, least);
                let divide = self.b.create_block();
                self.b.ins().brif(pays, divide, &[], go_on, &[]);
                self.go_on_in(divide);
                let [way, divisor] = [way, divisor].map(|number| self.b.ins().ireduce(I32, number));
                let steps = self.b.ins().udiv(way, divisor);
                self.b.ins().uextend(I64, steps)
            }
        };
        let steps = self.b.ins().iadd_imm_s(steps, 1);
        let none = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, way, 0);
        let all = self.b.ins().select(none, one, steps);
        let iterations = self.within_budget(all, Val::Const(weight as u64));
        let least = if bits.stride == Stride::One { FILLED_MIN } else { CROSSED_MIN };
        let enough = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, iterations, least);
        let before = self.b.ins().iadd_imm_s(iterations, -1);
        let distance = self.b.ins().imul(before, step);
        let way = self.b.ins().imul_imm_s(distance, bits.written.bits());
        let last = self.b.ins().iadd(position, way);
        let inside = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, last, (bits.area.2 * 8) as i64);
        // The counter stays inside its type.
        let end = self.b.ins().iadd(limit, step);
        let fits = self.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, end, bits.of.most());
        let mut guard = [up, inside, fits].into_iter().fold(enough, |all, one| self.b.ins().band(all, one));
        if bits.written.bits() != 1 {
            let bit = self.b.ins().band_imm_u(position, 7);
            let is_whole = self.b.ins().icmp_imm_u(IntCC::Equal, bit, 0);
            guard = self.b.ins().band(guard, is_whole);
        }
        for &(number, limit) in &kernel.required {
            let first = self.value_in_front(kernel, number);
            let first = self.int(first);
            let first = self.b.ins().uextend(I64, first);
            let last = self.b.ins().iadd(first, distance);
            let below = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, last, i64::from(limit));
            guard = self.b.ins().band(guard, below);
        }
        self.b.ins().brif(guard, enter, &[], go_on, &[]);
        self.b.switch_to_block(enter);
        self.b.seal_block(enter);
        let base = self.address_of_base(bits.area.0);
        match (bits.written, bits.stride) {
            (FillValue::Bits(value), Stride::One) => self.fill_bits((bits.area, value), base, position, iterations),
            (FillValue::Bits(value), Stride::Computed(_)) => self.cross_out((bits.area, value), base, position, step, iterations),
            (FillValue::Bytes(value), stride) => {
                let byte = self.b.ins().ushr_imm_u(position, 3);
                let address = self.b.ins().iadd(base, byte);
                match stride {
                    Stride::One => self.fill_bytes(address, bits.area.1, value, iterations),
                    Stride::Computed(_) => {
                        let byte = self.b.ins().iconst(I8, i64::from(value));
                        self.four_at_a_time(address, step, iterations, |this, address| {
                            this.b.ins().store(data(), byte, address, bits.area.1);
                        });
                    }
                }
            }
        }
        let way = self.b.ins().imul(iterations, step);
        let counted = self.b.ins().iadd(first, way);
        let counted = self.b.ins().ireduce(I32, counted);
        let counted = if bits.of.bits == 16 { self.b.ins().band_imm_u(counted, 0xFFFF) } else { counted };
        self.write_slot(kernel, bits.counter, Val::Int(counted));
        for &(slot, value) in &bits.same {
            self.write_slot(kernel, slot, Val::Const(value));
        }
        self.settle_bytes();
        let taken = self.b.ins().imul_imm_s(iterations, weight);
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let left = self.b.ins().isub(budget, taken);
        self.b.def_var(variable, left);
        let ended = self.b.ins().icmp(IntCC::Equal, iterations, all);
        self.b.ins().brif(ended, leave, &[], go_on, &[]);
        self.leave_behind(it, leave, left, weight);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.forget_memory();
    }

    /// A number as the loop compares it.
    pub(super) fn number_of(&mut self, of: CounterType, value: Val) -> Value {
        match of {
            CounterType { bits: 16, signed: true } => {
                let value = self.i16(value);
                self.b.ins().sextend(I64, value)
            }
            CounterType { signed, .. } => {
                let value = self.int(value);
                if signed { self.b.ins().sextend(I64, value) } else { self.b.ins().uextend(I64, value) }
            }
        }
    }

    /// Where the bit of the first iteration lies in its area.
    fn position_of_bits(&mut self, kernel: &Kernel, bits: &BitFill) -> Value {
        let pointer = self.value_in_front(kernel, bits.pointer);
        let pointer = self.int(pointer);
        let moved = self.b.ins().iadd_imm_u(pointer, i64::from(bits.offset));
        let position = self.b.ins().band_imm_u(moved, 0x00FF_FFFF);
        self.b.ins().uextend(I64, position)
    }

    /// Part of the first and of the last byte, and between them whole bytes, 16 at a time.
    fn fill_bits(&mut self, (area, value): Bit, base: Value, position: Value, iterations: Value) {
        let last = self.b.ins().iadd(position, iterations);
        let last = self.b.ins().iadd_imm_s(last, -1);
        let [first_byte, last_byte] = [position, last].map(|bit| self.b.ins().ushr_imm_u(bit, 3));
        let [first_bit, last_bit] = [position, last].map(|bit| {
            let bit = self.b.ins().ireduce(I32, bit);
            self.b.ins().band_imm_u(bit, 7)
        });
        let all = self.b.ins().iconst(I32, 0xFF);
        let first_mask = self.b.ins().ishl(all, first_bit);
        let above = self.b.ins().iconst(I32, 7);
        let above = self.b.ins().isub(above, last_bit);
        let last_mask = self.b.ins().ushr(all, above);
        for (byte, mask) in [(first_byte, first_mask), (last_byte, last_mask)] {
            let mask = self.b.ins().ireduce(I8, mask);
            let address = self.b.ins().iadd(base, byte);
            self.put_bits((area, value), address, mask);
        }
        let count = self.b.ins().isub(last_byte, first_byte);
        let count = self.b.ins().iadd_imm_s(count, -1);
        let address = self.b.ins().iadd(base, first_byte);
        let address = self.b.ins().iadd_imm_s(address, 1);
        self.fill_bytes(address, area.1, if value { 0xFF } else { 0 }, count);
    }

    /// Writes a byte to so many that follow one another, 16 at a time.
    fn fill_bytes(&mut self, address: Value, start: i32, value: u8, count: Value) {
        let byte = self.b.ins().iconst(I8, i64::from(value));
        let vector = self.b.ins().splat(I8X16, byte);
        let vectors = self.b.ins().ushr_imm_u(count, i64::from(BITS_OF_A_VECTOR.trailing_zeros()) - 3);
        let bytes = self.b.ins().band_imm_u(count, BITS_OF_A_VECTOR / 8 - 1);
        let way = self.b.ins().isub(count, bytes);
        let behind = self.b.ins().iadd(address, way);
        for (address, size, count, value) in [(address, BITS_OF_A_VECTOR / 8, vectors, vector), (behind, 1, bytes, byte)] {
            let size = self.b.ins().iconst(I64, size);
            self.repeat_if_any(address, size, count, |this, address| {
                this.b.ins().store(data(), value, address, start);
            });
        }
    }

    /// Writes the bits of a byte that a mask shows.
    fn put_bits(&mut self, ((_, start, _), value): Bit, address: Value, mask: Value) {
        let old = self.b.ins().load(I8, data(), address, start);
        let new = if value { self.b.ins().bor(old, mask) } else { self.b.ins().band_not(old, mask) };
        self.b.ins().store(data(), new, address, start);
    }

    /// Bits that lie so far from each other: few one after the other.
    fn cross_out(&mut self, (area, value): Bit, base: Value, position: Value, step: Value, iterations: Value) {
        let [many, few, behind] = [self.b.create_block(), self.b.create_block(), self.b.create_block()];
        let pays = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, iterations, PASSES_MIN);
        self.b.ins().brif(pays, many, &[], few, &[]);
        self.b.switch_to_block(many);
        self.b.seal_block(many);
        self.stride_bits((area, value), base, position, step, iterations);
        self.b.ins().jump(behind, &[]);
        self.b.switch_to_block(few);
        self.b.seal_block(few);
        self.repeat_by(position, step, iterations, |this, position| {
            let byte = this.b.ins().ushr_imm_u(position, 3);
            let address = this.b.ins().iadd(base, byte);
            let mask = this.mask_of(position);
            this.put_bits((area, value), address, mask);
        });
        self.b.ins().jump(behind, &[]);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
    }

    /// The bit of a position, in its byte.
    fn mask_of(&mut self, position: Value) -> Value {
        let bit = self.b.ins().band_imm_u(position, 7);
        let bit = self.b.ins().ireduce(I32, bit);
        let one = self.b.ins().iconst(I32, 1);
        let mask = self.b.ins().ishl(one, bit);
        self.b.ins().ireduce(I8, mask)
    }

    /// Once over the bytes for each of eight bits: behind eight iterations the same bit follows, as many bytes later as the step has bits.
    fn stride_bits(&mut self, (area, value): Bit, base: Value, position: Value, step: Value, iterations: Value) {
        let [head, behind] = [self.b.create_block(), self.b.create_block()];
        let eight = self.b.ins().iconst(I64, 8);
        self.b.ins().jump(head, &[BlockArg::Value(eight), BlockArg::Value(position), BlockArg::Value(iterations)]);
        self.b.switch_to_block(head);
        let [passes, position, iterations] = [(); 3].map(|()| self.b.append_block_param(head, I64));
        let byte = self.b.ins().ushr_imm_u(position, 3);
        let address = self.b.ins().iadd(base, byte);
        let mask = self.mask_of(position);
        let more = self.b.ins().iadd_imm_s(iterations, 7);
        let count = self.b.ins().ushr_imm_u(more, 3);
        self.four_at_a_time(address, step, count, |this, address| this.put_bits((area, value), address, mask));
        let passes = self.b.ins().iadd_imm_s(passes, -1);
        let position = self.b.ins().iadd(position, step);
        let iterations = self.b.ins().iadd_imm_s(iterations, -1);
        let arguments = [passes, position, iterations].map(BlockArg::Value);
        self.b.ins().brif(passes, head, &arguments, behind, &[]);
        self.b.seal_block(head);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
    }

    /// Does something at so many addresses, four in each round, and those that are left.
    fn four_at_a_time(&mut self, address: Value, step: Value, count: Value, write: impl Fn(&mut Self, Value)) {
        let [rounds, left] = [self.b.ins().ushr_imm_u(count, 2), self.b.ins().band_imm_u(count, 3)];
        let [double, four] = [self.b.ins().ishl_imm_u(step, 1), self.b.ins().ishl_imm_u(step, 2)];
        let triple = self.b.ins().iadd(double, step);
        let way = self.b.ins().imul(rounds, four);
        let address_left = self.b.ins().iadd(address, way);
        self.repeat_if_any(address, four, rounds, |this, address| {
            write(this, address);
            for further in [step, double, triple] {
                let address = this.b.ins().iadd(address, further);
                write(this, address);
            }
        });
        self.repeat_if_any(address_left, step, left, |this, address| write(this, address));
    }

    fn repeat_if_any(&mut self, address: Value, step: Value, count: Value, body: impl FnOnce(&mut Self, Value)) {
        let [some, behind] = [self.b.create_block(), self.b.create_block()];
        self.b.ins().brif(count, some, &[], behind, &[]);
        self.b.switch_to_block(some);
        self.b.seal_block(some);
        self.repeat_by(address, step, count, body);
        self.b.ins().jump(behind, &[]);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
    }

    /// Does something at so many addresses or positions, at least one.
    fn repeat_by(&mut self, address: Value, step: Value, count: Value, body: impl FnOnce(&mut Self, Value)) {
        let [head, behind] = [self.b.create_block(), self.b.create_block()];
        self.b.ins().jump(head, &[BlockArg::Value(address), BlockArg::Value(count)]);
        self.b.switch_to_block(head);
        let [address, count] = [(); 2].map(|()| self.b.append_block_param(head, I64));
        body(self, address);
        let address = self.b.ins().iadd(address, step);
        let count = self.b.ins().iadd_imm_s(count, -1);
        self.b.ins().brif(count, head, &[BlockArg::Value(address), BlockArg::Value(count)], behind, &[]);
        self.b.seal_block(head);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
    }
}
