//! Loop idiom: loops that count bits of arrays, add the same number for each bit that is set, or write bits that are logic of others, do 56
//! iterations at a time, with so many bits of each array in one register.

use std::collections::{BTreeSet, HashMap};

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{BlockArg, Endianness, InstBuilder, MemFlagsData, Value};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::super::natural_loops::NaturalLoop;
use super::super::value::Val;
use super::LoopPlan;
use super::bit_interleaving::Direction;
use super::kernel::{Access, Definition, Kernel, Level, Node, Slot};
use super::scalar_evolution::{Affine, Recurrence};
use crate::passes::Pass;

/// Iterations at a time: what eight bytes hold at least, wherever in the first one the first bit is.
const BITS: i64 = 56;
/// Iterations that are left where so many are made: the eight bytes that are read then are bytes of the array.
const ITERATIONS_MIN: i64 = 64;

/// A slot to which a number is added in some iterations.
struct ConditionalSum {
    slot: Slot,
    /// The bits of the type.
    bits: u32,
    number: Node,
    /// In which iterations.
    condition: Node,
}

/// What a loop does that only counts and writes bits.
pub(super) struct BitCount {
    sums: Vec<ConditionalSum>,
    lines: Vec<(Slot, Affine)>,
    way: Direction,
}

/// What a loop does, if it only counts bits of arrays and writes others that are logic of them.
pub(super) fn read(plan: &LoopPlan) -> Option<BitCount> {
    let kernel = Some(&plan.kernel).filter(|kernel| kernel.passes.has(Pass::BitCountIdiom))?;
    let way = kernel.bits_follow(kernel.accesses.first()?)?;
    let follows = |access: &Access| {
        let is_logic = access.value.is_none_or(|value| is_bits(kernel, value));
        is_logic && access.inside.is_some() && access.sure && kernel.bits_follow(access) == Some(way)
    };
    let is_more = kernel.inner.is_some() || kernel.outer.blocks_most != 0 || !(kernel.required.is_empty() && kernel.inspected.is_empty());
    if is_more || !kernel.accesses.iter().all(follows) || !bits_are_apart(kernel, way) {
        return None;
    }
    let (mut sums, mut lines) = (Vec::new(), Vec::new());
    for (slot, _, carried) in kernel.carried(Level::Outer) {
        match carried {
            Recurrence::Affine(line) => lines.push((slot, line)),
            Recurrence::Sum { added, bits } => {
                let Definition::Compute(Op::Gate, [number, condition, ..]) = kernel.what(added) else { return None };
                kernel.constant(number)?;
                if !is_bits(kernel, condition) {
                    return None;
                }
                sums.push(ConditionalSum { slot, bits, number, condition });
            }
            Recurrence::MinMax { .. } | Recurrence::Chain | Recurrence::Nothing => return None,
        }
    }
    let writes = kernel.accesses.iter().any(|access| access.value.is_some());
    (writes || !sums.is_empty()).then_some(BitCount { sums, lines, way })
}

/// Whether no iteration reads a bit that this one or one before it has written, nor writes one that another access writes.
fn bits_are_apart(kernel: &Kernel, way: Direction) -> bool {
    let accesses: Vec<&Access> = kernel.accesses_in_order().into_iter().map(|(_, access)| access).collect();
    let written = accesses.iter().enumerate().filter(|(_, access)| access.value.is_some());
    written.into_iter().all(|(at, write)| {
        accesses.iter().enumerate().all(|(other_at, other)| {
            if at == other_at || !write.may_share(other) {
                return true;
            }
            // A bit that lies further ahead is read before a later iteration writes it.
            let ahead = way.ahead(other, write);
            let is_ahead = ahead == 0 && other_at < at || (1..1 << 23).contains(&ahead);
            other.value.is_none() && (other.area, other.pointer) == (write.area, write.pointer) && is_ahead
        })
    })
}

/// Whether a value is one of the bits that an iteration reads, or logic of them.
fn is_bits(kernel: &Kernel, node: Node) -> bool {
    let mut parts = BTreeSet::new();
    kernel.rests(node, &mut parts);
    parts.into_iter().all(|part| match kernel.what(part) {
        Definition::Read(_) => true,
        Definition::Compute(op, _) => matches!(op, Op::Not | Op::And | Op::AndNot | Op::Or | Op::Xor),
        _ => false,
    })
}

impl Translator<'_> {
    /// Writes iterations of a loop that counts or writes bits, as many as make whole pieces and as the budget covers.
    pub(super) fn bit_sums_at_once(&mut self, plan: &LoopPlan, sums: &BitCount, it: &NaturalLoop) {
        self.settle_bytes();
        let kernel = &plan.kernel;
        let weight = i64::from(kernel.outer.weight);
        let [counter, limit] =
            [Some(plan.count.counter), plan.count.limit].map(|node| node.map_or(Val::Const(0), |node| self.value_in_front(kernel, node)));
        let (all, inside) = self.iterations(plan.count, counter, limit);
        let iterations = self.within_budget(all, Val::Const(weight as u64));
        let mut guard = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, iterations, ITERATIONS_MIN);
        if let Some(inside) = inside {
            guard = self.b.ins().band(guard, inside);
        }
        let [enter, go_on, leave] = [self.b.create_block(), self.b.create_block(), self.b.create_block()];
        self.b.ins().brif(guard, enter, &[], go_on, &[]);
        self.b.switch_to_block(enter);
        self.b.seal_block(enter);
        let more = self.b.ins().iadd_imm_s(iterations, -ITERATIONS_MIN);
        let more = self.b.ins().udiv_imm_u(more, BITS);
        let pieces = self.b.ins().iadd_imm_s(more, 1);
        let counts = self.pieces_of_bits(kernel, sums, pieces);
        let made = self.b.ins().imul_imm_s(pieces, BITS);
        for &(slot, line) in &sums.lines {
            let before = self.slot_before(kernel, slot);
            let value = self.behind(before, line, made);
            self.write_slot(kernel, slot, value);
        }
        for (sum, count) in sums.sums.iter().zip(counts) {
            let before = self.slot_before(kernel, sum.slot);
            let before = self.int(before);
            let number = kernel.constant(sum.number).unwrap_or_default() as u32;
            let count = self.int(Val::Word(count));
            let added = self.b.ins().imul_imm_u(count, i64::from(number));
            let sum_now = self.b.ins().iadd(before, added);
            let value = self.on_line(sum_now, Affine { step: 0, bits: sum.bits });
            self.write_slot(kernel, sum.slot, value);
        }
        self.settle_bytes();
        let taken = self.b.ins().imul_imm_s(made, weight);
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let left = self.b.ins().isub(budget, taken);
        self.b.def_var(variable, left);
        let ended = self.b.ins().icmp(IntCC::Equal, made, all);
        self.b.ins().brif(ended, leave, &[], go_on, &[]);
        self.leave_behind(it, leave, left, weight);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.forget_memory();
    }

    /// A value of the first iteration that rests on nothing that the loop reads.
    pub(super) fn value_in_front(&mut self, kernel: &Kernel, node: Node) -> Val {
        match kernel.what(node) {
            Definition::Constant(value) => Val::Const(value),
            Definition::Start(_, slot) => self.slot_before(kernel, slot),
            Definition::Compute(op, args) => {
                let args: Vec<Val> = args[..op.arity()].iter().map(|&arg| self.value_in_front(kernel, arg)).collect();
                self.compute_now(op, &args)
            }
            Definition::After(_) | Definition::Read(_) => unreachable!("a value on a line rests on no memory"),
        }
    }

    /// Writes the bits of the iterations of so many pieces; in how many of them each of the conditions holds.
    fn pieces_of_bits(&mut self, kernel: &Kernel, sums: &BitCount, pieces: Value) -> Vec<Value> {
        // The address of eight bytes, the first one or the last one of which has the bit of the first iteration, and the number of the
        // first bit of the piece in them, which stays the same from piece to piece.
        let places: Vec<(Value, Value, i32)> = kernel
            .accesses
            .iter()
            .map(|access| {
                let pointer = self.value_in_front(kernel, access.pointer);
                let pointer = self.int(pointer);
                let moved = self.b.ins().iadd_imm_u(pointer, i64::from(access.offset));
                let position = self.b.ins().band_imm_u(moved, 0x00FF_FFFF);
                let position = self.b.ins().uextend(I64, position);
                let byte = self.b.ins().ushr_imm_u(position, 3);
                let (base, start, _) = access.area;
                let base = self.address_of_base(base);
                let (address, bit) = (self.b.ins().iadd(base, byte), self.b.ins().band_imm_u(position, 7));
                match sums.way {
                    Direction::Up => (address, bit, start),
                    Direction::Down => (address, self.b.ins().iadd_imm_s(bit, 64 - BITS - 7), start - BITS as i32 / 8),
                }
            })
            .collect();
        let [head, behind] = [self.b.create_block(), self.b.create_block()];
        let none = self.b.ins().iconst(I64, 0);
        let mut first = vec![BlockArg::Value(pieces)];
        first.extend(places.iter().map(|&(address, ..)| BlockArg::Value(address)));
        first.extend(sums.sums.iter().map(|_| BlockArg::Value(none)));
        self.b.ins().jump(head, &first);
        self.b.switch_to_block(head);
        let parameters: Vec<Value> = first.iter().map(|_| self.b.append_block_param(head, I64)).collect();
        let (addresses, counts) = parameters[1..].split_at(places.len());
        let little = MemFlagsData::new().with_notrap().with_endianness(Endianness::Little);
        let words: Vec<Value> =
            places.iter().zip(addresses).map(|(&(.., start), &address)| self.b.ins().load(I64, little, address, start)).collect();
        let reads: Vec<Value> = places.iter().zip(&words).map(|(&(_, bit, _), &word)| self.b.ins().ushr(word, bit)).collect();
        let mut known = HashMap::new();
        let mut next = vec![self.b.ins().iadd_imm_s(parameters[0], -1)];
        let step = if sums.way == Direction::Up { BITS / 8 } else { -BITS / 8 };
        next.extend(addresses.iter().map(|&address| self.b.ins().iadd_imm_s(address, step)));
        let counts: Vec<Value> = sums
            .sums
            .iter()
            .zip(counts)
            .map(|(sum, &count)| {
                let bits = self.bits_of(kernel, sum.condition, &reads, &mut known);
                // The bits of this piece alone.
                let piece = self.b.ins().ishl_imm_u(bits, 64 - BITS);
                let ones = self.b.ins().popcnt(piece);
                self.b.ins().iadd(count, ones)
            })
            .collect();
        next.extend(&counts);
        let piece = self.b.ins().iconst(I64, (1 << BITS) - 1);
        for (number, access) in kernel.accesses.iter().enumerate() {
            let Some(value) = access.value else { continue };
            let (_, bit, start) = places[number];
            let bits = self.bits_of(kernel, value, &reads, &mut known);
            let bits = self.b.ins().band(bits, piece);
            let [bits, written] = [bits, piece].map(|bits| self.b.ins().ishl(bits, bit));
            let others = self.b.ins().band_not(words[number], written);
            let new = self.b.ins().bor(others, bits);
            self.b.ins().store(little, new, addresses[number], start);
        }
        let again: Vec<BlockArg> = next.iter().map(|&value| BlockArg::Value(value)).collect();
        self.b.ins().brif(next[0], head, &again, behind, &[]);
        self.b.seal_block(head);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
        counts
    }

    /// A bit in all iterations of a piece.
    fn bits_of(&mut self, kernel: &Kernel, node: Node, reads: &[Value], known: &mut HashMap<Node, Value>) -> Value {
        if let Some(&bits) = known.get(&node) {
            return bits;
        }
        let bits = match kernel.what(node) {
            Definition::Read(access) => reads[access],
            Definition::Compute(Op::Not, [of, ..]) => {
                let of = self.bits_of(kernel, of, reads, known);
                self.b.ins().bnot(of)
            }
            Definition::Compute(op, [a, b, ..]) => {
                let [a, b] = [a, b].map(|of| self.bits_of(kernel, of, reads, known));
                match op {
                    Op::And => self.b.ins().band(a, b),
                    Op::AndNot => self.b.ins().band_not(a, b),
                    Op::Or => self.b.ins().bor(a, b),
                    _ => self.b.ins().bxor(a, b),
                }
            }
            _ => unreachable!("the bits were looked at"),
        };
        known.insert(node, bits);
        bits
    }
}
