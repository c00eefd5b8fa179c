//! Loops that do nothing but set or reset bits of an array, each so many after the one before: a byte at a time, or 16 bytes.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I8X16, I32, I64};
use cranelift_codegen::ir::{BlockArg, InstBuilder, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::Translator;
use super::super::loops::Loop;
use super::super::memory::data;
use super::super::promote::Base;
use super::super::value::Val;
use super::kernel::{Cell, Kernel, Level, Node, What};

/// Bits that are written with one store.
const BITS_OF_A_VECTOR: i64 = 128;
/// Turns from which it pays to go over the bytes once for each bit of a byte.
const TURNS_MIN: i64 = 32;

/// How many bits one lies behind the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stride {
    One,
    Computed(Node),
}

/// A loop that writes bits.
#[derive(Debug)]
pub(super) struct Bits {
    /// The variable that counts.
    counter: Cell,
    stride: Stride,
    /// The last number with which another turn is made.
    limit: Node,
    pointer: Node,
    offset: u32,
    area: (Base, i32, u64),
    value: bool,
}

/// What a loop does, if it only writes bits.
pub(super) fn read(kernel: &Kernel) -> Option<Bits> {
    let mut ends = kernel.outer.ends.iter();
    let (Some((&counter, &end)), None, None) = (ends.next(), ends.next(), &kernel.inner) else { return None };
    let mut stores = kernel.accesses.iter().filter_map(|access| Some((access, access.value?)));
    let (Some((store, value)), None) = (stores.next(), stores.next()) else { return None };
    // A read that nobody needs may be an error.
    if kernel.accesses.iter().any(|access| access.value.is_none() && !(access.sure && access.inside.is_some())) {
        return None;
    }
    let value = kernel.constant(value)? & 1 != 0;
    if store.width != Width::Bit || kernel.outer.blocks_most != 0 || !kernel.required.is_empty() {
        return None;
    }
    let start = |node: Node| kernel.is_start(node, Level::Outer, counter);
    let What::Compute(Op::AddU32, [a, b, ..]) = kernel.what(end) else { return None };
    let step = if start(a) { b } else { a };
    if !start(a) && !start(b) || start(step) {
        return None;
    }
    // The pointer is the counter and something that stays.
    let stays = |node: Node| kernel.constant(node).is_some();
    match kernel.what(store.pointer) {
        What::Start(..) if start(store.pointer) => {}
        What::Compute(Op::AddU32, [a, b, ..]) if start(a) && stays(b) || start(b) && stays(a) => {}
        _ => return None,
    }
    let (stride, limit) = match (kernel.constant(step), kernel.what(kernel.outer.again)) {
        (Some(1), What::Compute(Op::LeI32, [of, limit, ..])) if of == end => (Stride::One, limit),
        // What is known of the numbers may have made the condition a short one.
        (None, What::Compute(Op::LeI32, [of, limit, ..])) if of == end => (Stride::Computed(step), limit),
        (None, What::Compute(Op::AndNot, [choice, overflow, ..])) => {
            let What::Compute(Op::AddOverflowsI32, [a, b, ..]) = kernel.what(overflow) else { return None };
            let What::Compute(Op::Select, [down, _, up, _]) = kernel.what(choice) else { return None };
            let What::Compute(Op::LtI32, [of, zero, ..]) = kernel.what(down) else { return None };
            let What::Compute(Op::LeI32, [compared, limit, ..]) = kernel.what(up) else { return None };
            let same = start(a) && b == step && of == step && kernel.constant(zero) == Some(0) && compared == end;
            if !same {
                return None;
            }
            (Stride::Computed(step), limit)
        }
        _ => return None,
    };
    let unchanged = |node: Node| match kernel.what(node) {
        What::Constant(_) => true,
        What::Start(Level::Outer, cell) => !kernel.outer.ends.contains_key(&cell),
        _ => false,
    };
    if !unchanged(limit) || matches!(stride, Stride::Computed(step) if !unchanged(step)) {
        return None;
    }
    Some(Bits { counter, stride, limit, pointer: store.pointer, offset: store.offset, area: store.area, value })
}

impl Translator<'_> {
    /// Writes turns of a loop that writes bits, as many as there are and as nobody asks about, and goes on where more turns may follow.
    pub(super) fn bits_at_once(&mut self, kernel: &Kernel, bits: &Bits, it: &Loop) {
        self.settle_bytes();
        let weight = i64::from(kernel.outer.weight);
        let counter = self.cell_before(kernel, bits.counter);
        let pointer = match kernel.what(bits.pointer) {
            What::Compute(op, [a, b, ..]) => {
                let mut arg = |node: Node| self.unchanged_before(kernel, node, counter);
                let args = [arg(a), arg(b)];
                self.compute_now(op, &args)
            }
            _ => counter,
        };
        let limit = self.unchanged_before(kernel, bits.limit, counter);
        let step = match bits.stride {
            Stride::One => Val::Const(1),
            Stride::Computed(step) => self.unchanged_before(kernel, step, counter),
        };
        let [first, limit, step] = [counter, limit, step].map(|value| {
            let value = self.int(value);
            self.b.ins().sextend(I64, value)
        });
        let pointer = self.int(pointer);
        let moved = self.b.ins().iadd_imm_u(pointer, i64::from(bits.offset));
        let position = self.b.ins().band_imm_u(moved, 0x00FF_FFFF);
        let position = self.b.ins().uextend(I64, position);
        // A step that is not above 0 makes no turns here.
        let up = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThan, step, 0);
        let one = self.b.ins().iconst(I64, 1);
        let divisor = self.b.ins().select(up, step, one);
        let way = self.b.ins().isub(limit, first);
        let steps = match bits.stride {
            Stride::One => way,
            Stride::Computed(_) => self.b.ins().sdiv(way, divisor),
        };
        let steps = self.b.ins().iadd_imm_s(steps, 1);
        let none = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, way, 0);
        let all = self.b.ins().select(none, one, steps);
        let turns = self.within_budget(all, weight);
        let (turns, least) = match bits.stride {
            Stride::One => (self.b.ins().band_imm_s(turns, -BITS_OF_A_VECTOR), BITS_OF_A_VECTOR),
            Stride::Computed(_) => (turns, TURNS_MIN),
        };
        let enough = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, turns, least);
        let before = self.b.ins().iadd_imm_s(turns, -1);
        let distance = self.b.ins().imul(before, step);
        let last = self.b.ins().iadd(position, distance);
        let inside = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, last, (bits.area.2 * 8) as i64);
        // The counter stays inside its type.
        let end = self.b.ins().iadd(limit, step);
        let fits = self.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, end, i64::from(i32::MAX));
        let mut guard = [up, inside, fits].into_iter().fold(enough, |all, one| self.b.ins().band(all, one));
        if bits.stride == Stride::One {
            let odd = self.b.ins().band_imm_u(position, 7);
            let whole = self.b.ins().icmp_imm_u(IntCC::Equal, odd, 0);
            guard = self.b.ins().band(guard, whole);
        }
        let [enter, go_on, leave] = [self.b.create_block(), self.b.create_block(), self.b.create_block()];
        self.b.ins().brif(guard, enter, &[], go_on, &[]);
        self.b.switch_to_block(enter);
        self.b.seal_block(enter);
        let base = self.address_of_base(bits.area.0);
        match bits.stride {
            Stride::One => self.fill_bits(bits, base, position, turns),
            Stride::Computed(_) => self.stride_bits(bits, base, position, step, turns),
        }
        let way = self.b.ins().imul(turns, step);
        let counted = self.b.ins().iadd(first, way);
        let counted = self.b.ins().ireduce(I32, counted);
        self.write_cell(kernel, bits.counter, Val::Int(counted));
        self.settle_bytes();
        let taken = self.b.ins().imul_imm_s(turns, weight);
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let left = self.b.ins().isub(budget, taken);
        self.b.def_var(variable, left);
        let ended = self.b.ins().icmp(IntCC::Equal, turns, all);
        self.b.ins().brif(ended, leave, &[], go_on, &[]);
        self.leave_behind(it, leave, left, weight);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.forget_memory();
    }

    /// What a cell that no turn changes, or the counter, holds in front of the loop.
    fn unchanged_before(&mut self, kernel: &Kernel, node: Node, counter: Val) -> Val {
        match kernel.what(node) {
            What::Constant(value) => Val::Const(value),
            What::Start(_, cell) if kernel.outer.ends.contains_key(&cell) => counter,
            What::Start(_, cell) => self.cell_before(kernel, cell),
            _ => unreachable!("it was looked at"),
        }
    }

    /// Whole bytes, 16 at a time.
    fn fill_bits(&mut self, bits: &Bits, base: Value, position: Value, turns: Value) {
        let byte = self.b.ins().iconst(I8, if bits.value { 0xFF } else { 0 });
        let vector = self.b.ins().splat(I8X16, byte);
        let first = self.b.ins().ushr_imm_u(position, 3);
        let address = self.b.ins().iadd(base, first);
        let count = self.b.ins().ushr_imm_u(turns, i64::from(BITS_OF_A_VECTOR.trailing_zeros()));
        self.repeat(address, 16, count, |this, address| {
            this.b.ins().store(data(), vector, address, bits.area.1);
        });
    }

    /// Once over the bytes for each of eight bits: behind eight turns the same bit follows, as many bytes later as the step has bits.
    fn stride_bits(&mut self, bits: &Bits, base: Value, position: Value, step: Value, turns: Value) {
        let [head, behind] = [self.b.create_block(), self.b.create_block()];
        let eight = self.b.ins().iconst(I64, 8);
        self.b.ins().jump(head, &[BlockArg::Value(eight), BlockArg::Value(position), BlockArg::Value(turns)]);
        self.b.switch_to_block(head);
        let [passes, position, turns] = [(); 3].map(|()| self.b.append_block_param(head, I64));
        let byte = self.b.ins().ushr_imm_u(position, 3);
        let address = self.b.ins().iadd(base, byte);
        let bit = self.b.ins().band_imm_u(position, 7);
        let bit = self.b.ins().ireduce(I32, bit);
        let one = self.b.ins().iconst(I32, 1);
        let mask = self.b.ins().ishl(one, bit);
        let mask = self.b.ins().ireduce(I8, mask);
        let rest = self.b.ins().bnot(mask);
        let more = self.b.ins().iadd_imm_s(turns, 7);
        let count = self.b.ins().ushr_imm_u(more, 3);
        let write = |this: &mut Self, address: Value| {
            let old = this.b.ins().load(I8, data(), address, bits.area.1);
            let new = if bits.value { this.b.ins().bor(old, mask) } else { this.b.ins().band(old, rest) };
            this.b.ins().store(data(), new, address, bits.area.1);
        };
        // Four bits in each round, and those that are left.
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
        let passes = self.b.ins().iadd_imm_s(passes, -1);
        let position = self.b.ins().iadd(position, step);
        let turns = self.b.ins().iadd_imm_s(turns, -1);
        let arguments = [passes, position, turns].map(BlockArg::Value);
        self.b.ins().brif(passes, head, &arguments, behind, &[]);
        self.b.seal_block(head);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
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

    fn repeat(&mut self, address: Value, step: i64, count: Value, body: impl FnOnce(&mut Self, Value)) {
        let step = self.b.ins().iconst(I64, step);
        self.repeat_by(address, step, count, body);
    }

    /// Does something at so many addresses, at least one.
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
