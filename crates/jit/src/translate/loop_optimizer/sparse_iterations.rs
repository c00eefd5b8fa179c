//! Sparse iterations: a loop that tests a bit or a byte of an array in each iteration does something in few of them, as where primes are
//! left in a sieve or alarms are set. At the beginning of each iteration the bits of many are tested together, and those that would only
//! count are skipped.

use std::collections::HashMap;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I8X16, I32, I64};
use cranelift_codegen::ir::{self as clif, BlockArg, Endianness, InstBuilder, MemFlagsData, Value};
use sieben_engine::ir::{Inst, Op, Target};
use sieben_model::address::Width;

use super::super::Translator;
use super::super::natural_loops::{NaturalLoop, written};
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::bit_fill_idiom::{self, ContinueCondition, CounterType};
use super::kernel::{Access, Definition, Kernel, Level, Node, Slot, SlotKind};
use super::scalar_evolution::Affine;
use super::ssa_construction;
use crate::passes::Pass;

/// Jumps of an iteration whose ways are tried.
const JUMPS_MAX: u32 = 2;

/// Of so many parts of a loop the first iterations are looked at for how many of them do something.
const SAMPLES: i64 = 8;
/// So few iterations do something that it is faster to pass the others than to do all at once.
const FEW: (i64, i64) = (3, 16);

/// What many iterations look at together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SparseTest {
    /// Bits, of which eight bytes hold so many wherever in the first one the first bit is.
    Bits,
    /// Bytes of a vector.
    Bytes,
    /// Eight bytes in a register, each of which has to be a number or another one: that takes half as long as vectors.
    Differing,
}

impl SparseTest {
    /// Iterations that are looked at.
    fn iterations(self) -> i64 {
        match self {
            Self::Bits => 57,
            Self::Bytes => 16,
            Self::Differing => 8,
        }
    }

    /// Positions in so many bytes.
    fn positions(self, bytes: i64) -> i64 {
        match self {
            Self::Bits => 8 * bytes,
            Self::Bytes | Self::Differing => bytes,
        }
    }

    /// Bits that are seen of each of them.
    fn bits(self) -> u32 {
        match self {
            Self::Bits | Self::Bytes => 1,
            Self::Differing => 8,
        }
    }

    /// Bytes that are read for them.
    fn bytes(self) -> i64 {
        match self {
            Self::Bits | Self::Differing => 8,
            Self::Bytes => 16,
        }
    }
}

/// Iterations of a loop that do nothing but count.
pub(in super::super) struct Idle {
    kernel: Kernel,
    looks: SparseTest,
    first: u32,
    /// What the counter holds when an iteration begins, and how long it counts.
    counter: Node,
    again: ContinueCondition,
    /// Slots that such iterations write.
    lines: Vec<(Slot, Affine)>,
    /// Those that hold the same behind each of them.
    same: Vec<(Slot, u64)>,
    /// Where other iterations go on, if their first statement does nothing but look.
    others: Option<u32>,
}

/// Where the first iteration looks: the address, and the number of the bit in the byte that lies there.
type Place = (Value, Value, i32);

impl Idle {
    fn of(kernel: Kernel, first: u32) -> Option<Self> {
        let is_more = kernel.ways.is_empty() || kernel.accesses.is_empty();
        if is_more || kernel.accesses.iter().any(|access| access.value.is_some()) {
            return None;
        }
        let looks = match kernel.accesses[0].width {
            Width::Bit => SparseTest::Bits,
            _ if kernel.ways.len() == 1 && differs(&kernel, kernel.ways[0]).is_some() => SparseTest::Differing,
            _ => SparseTest::Bytes,
        };
        let (mut lines, mut same, mut counters) = (Vec::new(), Vec::new(), Vec::new());
        for (&slot, &end) in &kernel.outer.ends {
            if kernel.is_start(end, Level::Outer, slot) {
                continue;
            }
            match kernel.constant(end) {
                Some(value) => same.push((slot, value)),
                None => lines.push((slot, kernel.slot_line(Level::Outer, slot)?)),
            }
            counters.extend(counter(&kernel, slot, end));
        }
        let &[(counter, again)] = counters.as_slice() else { return None };
        let step = |node: Node| step(&kernel, node, counter, again.of);
        let follows = |access: &Access| match looks {
            SparseTest::Bits => access.width == Width::Bit && step(access.pointer) == Some(1),
            // An address in the middle of a byte is an error.
            _ => access.width == Width::Byte && access.inside.is_some() && access.sure && step(access.pointer) == Some(8),
        };
        let is_next = |&(number, _): &(Node, u32)| step(number) == Some(1);
        let is_looked_at = |&(condition, _): &(Node, bool)| is_looked_at(&kernel, looks, condition);
        let fits = kernel.accesses.iter().all(follows) && kernel.required.iter().all(is_next) && kernel.ways.iter().all(is_looked_at);
        if !fits || kernel.slots.iter().any(|kept| !matches!(kept, SlotKind::Register(_) | SlotKind::Memory { .. })) {
            return None;
        }
        Some(Self { looks, first, counter, again, lines, same, others: None, kernel })
    }
}

/// What a slot holds when an iteration begins, if it counts one by one and decides whether another iteration follows.
fn counter(kernel: &Kernel, slot: Slot, end: Node) -> Option<(Node, ContinueCondition)> {
    let Definition::Compute(op, [a, b, ..]) = kernel.what(end) else { return None };
    let (own, step) = if kernel.is_start(a, Level::Outer, slot) { (a, b) } else { (b, a) };
    if !kernel.is_start(own, Level::Outer, slot) || kernel.constant(step) != Some(1) {
        return None;
    }
    let again = bit_fill_idiom::condition(kernel, kernel.outer.again, own, step)?;
    let bits = match op {
        Op::AddU16 if kernel.is_16_bits(own) => 16,
        Op::AddU32 if kernel.is_32_bits(own) => 32,
        _ => return None,
    };
    let stays = kernel.line(again.limit, Level::Outer)?.is_same() && kernel.is_32_bits(again.limit);
    (again.counted == end && again.of.bits == bits && stays).then_some((own, again))
}

/// By how much a number of 32 bits grows from iteration to iteration, if that rests on the counter alone, which stays inside its type while
/// iterations follow.
fn step(kernel: &Kernel, node: Node, counter: Node, of: CounterType) -> Option<u32> {
    if kernel.line(node, Level::Outer).is_some_and(Affine::is_same) {
        return Some(0);
    }
    let step = |node: Node| step(kernel, node, counter, of);
    match kernel.what(node) {
        Definition::Compute(Op::Extend16, [number, ..]) => (number == counter && of == CounterType { bits: 16, signed: true }).then_some(1),
        Definition::Compute(Op::AddU32, [a, b, ..]) => Some(step(a)?.wrapping_add(step(b)?)),
        Definition::Compute(Op::SubU32, [a, b, ..]) => Some(step(a)?.wrapping_sub(step(b)?)),
        Definition::Compute(Op::Shl32, [a, count, ..]) => {
            let count = kernel.constant(count).filter(|&count| count < 32)?;
            Some(step(a)? << count)
        }
        _ => (node == counter && (of.bits == 32 || !of.signed)).then_some(1),
    }
}

/// Whether a number is made of the counter and constants.
fn is_plain(kernel: &Kernel, node: Node, counter: Node) -> bool {
    match kernel.what(node) {
        Definition::Constant(_) => true,
        Definition::Compute(op, args) => args[..op.arity()].iter().all(|&arg| is_plain(kernel, arg, counter)),
        _ => node == counter,
    }
}

/// Whether a condition is logic of what iterations look at and of bits that are the same in all of them.
fn is_looked_at(kernel: &Kernel, looks: SparseTest, node: Node) -> bool {
    if kernel.is_bit(node) && kernel.line(node, Level::Outer).is_some_and(Affine::is_same) {
        return true;
    }
    let is = |node: Node| is_looked_at(kernel, looks, node);
    match kernel.what(node) {
        Definition::Read(_) => looks == SparseTest::Bits,
        Definition::Compute(Op::Not, [of, ..]) => is(of),
        Definition::Compute(Op::And | Op::AndNot | Op::Or | Op::Xor, [a, b, ..]) => is(a) && is(b),
        _ => looks != SparseTest::Bits && comparison(kernel, node).is_some(),
    }
}

/// A byte that is compared with a constant: the access that reads it, the constant, and how.
fn comparison(kernel: &Kernel, node: Node) -> Option<(usize, u8, IntCC)> {
    let Definition::Compute(op, [byte, other, ..]) = kernel.what(node) else { return None };
    let Definition::Read(access) = kernel.what(byte) else { return None };
    let with = match op {
        Op::IsNonzero => return Some((access, 0, IntCC::NotEqual)),
        Op::Equal | Op::EqI16 | Op::EqI32 => IntCC::Equal,
        Op::Differ | Op::NeI16 | Op::NeI32 => IntCC::NotEqual,
        Op::LtI16 | Op::LtI32 | Op::Below => IntCC::UnsignedLessThan,
        Op::LeI16 | Op::LeI32 | Op::LeU64 => IntCC::UnsignedLessThanOrEqual,
        Op::GtI16 | Op::GtI32 | Op::GtU64 => IntCC::UnsignedGreaterThan,
        Op::GeI16 | Op::GeI32 | Op::GeU64 => IntCC::UnsignedGreaterThanOrEqual,
        _ => return None,
    };
    Some((access, u8::try_from(kernel.constant(other)?).ok()?, with))
}

/// Whether an iteration does nothing where a byte is a number, or where it is not: the access that reads it, the number, and which of them.
fn differs(kernel: &Kernel, (mut condition, mut holds): (Node, bool)) -> Option<(usize, u8, bool)> {
    while let Definition::Compute(Op::Not, [of, ..]) = kernel.what(condition) {
        (condition, holds) = (of, !holds);
    }
    let (access, number, with) = comparison(kernel, condition)?;
    match with {
        IntCC::Equal => Some((access, number, !holds)),
        IntCC::NotEqual => Some((access, number, holds)),
        _ => None,
    }
}

impl Translator<'_> {
    /// What iterations of a loop do that do nothing but count, if it has such iterations and they can be told by bits or bytes of arrays.
    pub(in super::super) fn idle_iterations(&mut self, it: &NaturalLoop) -> Option<Idle> {
        if !self.options.does(Pass::SparseIterations) || self.cold.is_some() || self.taken != 0 || self.is_at_once(it) {
            return None;
        }
        // Most conditions jump over something.
        let idle = (0..1 << JUMPS_MAX).find_map(|ways: u32| {
            let kernel = ssa_construction::read_way(self, it, ways).filter(|kernel| !kernel.repeats_itself())?;
            if self.keeps_some_of_kernel(&kernel) {
                return None;
            }
            // Of less jumps than there are bits it is read but once.
            let is_new = ways == 0 || ways.ilog2() < kernel.ways.len() as u32;
            let idle = if is_new { Idle::of(kernel, it.first) } else { None }?;
            let others = if ways == 0 { self.others_go_on(&idle, it) } else { None };
            Some(Idle { others, ..idle })
        })?;
        self.pinned.extend(&idle.kernel.opened);
        Some(idle)
    }

    /// The second statement, if the first one only looks, and jumps over what iterations do that do something.
    fn others_go_on(&self, idle: &Idle, it: &NaturalLoop) -> Option<u32> {
        let code = &self.native().code;
        let [looks @ .., Inst::Branch { to: Target(behind), .. }] = code.statement(it.first as usize) else { return None };
        // What is required is met by an iteration that is seen.
        let only_looks =
            |inst: &Inst| matches!(inst, Inst::Constant { .. } | Inst::Compute { .. } | Inst::Load { .. } | Inst::Require { .. });
        let only_looks = looks.iter().all(only_looks);
        let next = it.first + 1;
        let is_needed = looks.iter().any(|inst| written(inst) & !self.dead_at(next) != 0);
        let is_ahead = (next..=it.last).contains(behind);
        // Else the jump may be that of another statement.
        let has_others = || (*behind..it.last).any(|at| code.statement(at as usize).iter().any(|inst| matches!(inst, Inst::Branch { .. })));
        let is_sure = idle.kernel.required.is_empty() && idle.kernel.accesses.iter().all(|access| access.inside.is_some() && access.sure);
        (only_looks && !is_needed && is_ahead && is_sure && idle.kernel.ways.len() == 1 && !has_others()).then_some(next)
    }

    /// Looks at some iterations all over a loop that can be done at once: where few of them do something, the way goes on in the block that
    /// is given back.
    pub(super) fn look_for_idle_iterations(&mut self, idle: &Idle) -> clif::Block {
        self.settle_bytes();
        let kernel = &idle.kernel;
        let looks = if idle.looks == SparseTest::Bits { SparseTest::Bits } else { SparseTest::Bytes };
        let all = self.iterations_that_follow(idle);
        let first: Vec<Value> = kernel.accesses.iter().map(|access| self.position_of_access(idle, access)).collect();
        let mut guard = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, all, SAMPLES * looks.positions(looks.bytes()));
        for (access, &position) in kernel.accesses.iter().zip(&first) {
            let last = self.b.ins().iadd(position, all);
            let inside = self.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, last, looks.positions(access.area.2 as i64));
            guard = self.b.ins().band(guard, inside);
        }
        let [head, behind, many, few] = [(); 4].map(|()| self.b.create_block());
        let far = self.b.ins().ushr_imm_u(all, i64::from(SAMPLES.trailing_zeros()));
        let [samples, none] = [SAMPLES, 0].map(|number| self.b.ins().iconst(I64, number));
        let parameters: Vec<BlockArg> = [samples, none].iter().chain(&first).map(|&value| BlockArg::Value(value)).collect();
        self.b.ins().brif(guard, head, &parameters, many, &[]);
        let parameters: Vec<Value> = parameters.iter().map(|_| self.b.append_block_param(head, I64)).collect();
        self.b.switch_to_block(head);
        let (left, positions) = (self.b.ins().iadd_imm_s(parameters[0], -1), &parameters[2..]);
        let seen = self.iterations_seen(idle, looks, positions);
        let seen = self.b.ins().ishl_imm_u(seen, 64 - looks.iterations());
        let some = self.b.ins().popcnt(seen);
        let sum = self.b.ins().iadd(parameters[1], some);
        let mut again = vec![BlockArg::Value(left), BlockArg::Value(sum)];
        again.extend(positions.iter().map(|&position| BlockArg::Value(self.b.ins().iadd(position, far))));
        self.b.ins().brif(left, head, &again, behind, &[]);
        self.b.seal_block(head);
        self.b.switch_to_block(behind);
        self.b.seal_block(behind);
        let is_many = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThan, sum, SAMPLES * looks.iterations() * FEW.0 / FEW.1);
        self.b.ins().brif(is_many, many, &[], few, &[]);
        self.b.switch_to_block(many);
        self.b.seal_block(many);
        few
    }

    /// Passes iterations that do nothing but count, as many as are seen to be such from here and as the budget covers.
    pub(in super::super) fn pass_idle_iterations(&mut self, idle: &Idle) {
        debug_assert_eq!(self.taken, 0);
        let (kernel, looks) = (&idle.kernel, idle.looks);
        let known = self.known_memory_here();
        let weight = i64::from(kernel.outer.weight);
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let needed = match self.iteration_of(idle.first) {
            Some(iteration) => self.weight_of_look(iteration.look, looks.iterations() * weight),
            None => self.b.ins().iconst(I64, looks.iterations() * weight),
        };
        let mut guard = self.b.ins().icmp(IntCC::SignedGreaterThanOrEqual, budget, needed);
        let positions: Vec<Value> = kernel.accesses.iter().map(|access| self.position_of_access(idle, access)).collect();
        for (access, &position) in kernel.accesses.iter().zip(&positions) {
            let (base, start, length) = access.area;
            let behind = self.layout.size as i64 - i64::from(start) - length as i64;
            let spare = if base == Base::Arena { behind.clamp(0, looks.bytes()) } else { 0 };
            let last = looks.positions(length as i64 + spare - looks.bytes());
            let inside = self.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, position, last);
            guard = self.b.ins().band(guard, inside);
        }
        let [enter, go_on] = [self.b.create_block(), self.b.create_block()];
        self.b.ins().brif(guard, enter, &[], go_on, &[]);
        self.b.switch_to_block(enter);
        self.b.seal_block(enter);
        let seen = self.iterations_seen(idle, looks, &positions);
        // A jump costs nothing where most iterations do something, and the next one need not wait for what was seen.
        let pass = self.b.create_block();
        let does = self.b.ins().band_imm_u(seen, (1 << looks.bits()) - 1);
        let others = idle.others.map_or(go_on, |others| self.edge(others));
        self.b.ins().brif(does, others, &[], pass, &[]);
        self.b.switch_to_block(pass);
        self.b.seal_block(pass);
        let most = self.most_idle_iterations(idle, &positions);
        let bits = self.b.ins().ctz(seen);
        let iterations_to_next = self.b.ins().ushr_imm_u(bits, i64::from(looks.bits().trailing_zeros()));
        // One that does something is mostly seen: what follows does not wait for how many may be passed.
        let iterations = match idle.others {
            Some(others) => {
                let is_found = self.b.ins().icmp(IntCC::SignedLessThan, iterations_to_next, most);
                let [found, all] = [self.b.create_block(), self.b.create_block()];
                self.b.ins().brif(is_found, found, &[], all, &[]);
                self.b.switch_to_block(found);
                self.b.seal_block(found);
                let in_front = self.known_memory_here();
                self.pass_iterations(idle, iterations_to_next, budget);
                let others = self.edge(others);
                self.b.ins().jump(others, &[]);
                self.b.switch_to_block(all);
                self.b.seal_block(all);
                self.know_memory(in_front);
                most
            }
            None => self.b.ins().smin(iterations_to_next, most),
        };
        self.pass_iterations(idle, iterations, budget);
        self.b.ins().jump(go_on, &[]);
        self.b.switch_to_block(go_on);
        self.b.seal_block(go_on);
        self.know_memory(known);
    }

    /// Passes so many iterations, with the budget that was there before them.
    fn pass_iterations(&mut self, idle: &Idle, iterations: Value, budget: Value) {
        let kernel = &idle.kernel;
        let slots: Vec<(Slot, Val)> = idle.lines.iter().map(|&(slot, _)| (slot, self.slot_before(kernel, slot))).collect();
        for (&(_, line), (slot, before)) in idle.lines.iter().zip(slots) {
            let value = self.behind(before, line, iterations);
            self.write_slot(kernel, slot, value);
        }
        for &(slot, value) in &idle.same {
            let before = self.slot_before(kernel, slot);
            if before.constant() == Some(value) {
                continue;
            }
            let none = self.b.ins().icmp_imm_s(IntCC::Equal, iterations, 0);
            let [before, value] = [before, Val::Const(value)].map(|value| self.word(value));
            let value = self.b.ins().select(none, before, value);
            self.write_slot(kernel, slot, Val::Word(value));
        }
        self.settle_bytes();
        let taken = self.b.ins().imul_imm_s(iterations, i64::from(kernel.outer.weight));
        let left = self.b.ins().isub(budget, taken);
        let variable = self.budget();
        self.b.def_var(variable, left);
    }

    /// Where an access goes in the first iteration: the number of the bit in its area, or of the byte. A number that is beyond the area may
    /// be another one that is.
    fn position_of_access(&mut self, idle: &Idle, access: &Access) -> Value {
        let kernel = &idle.kernel;
        let is_plain = is_plain(kernel, access.pointer, idle.counter);
        let offset = i64::from((access.offset << 8) as i32 >> 8);
        let position = match kernel.what(access.pointer) {
            Definition::Compute(Op::Shl32, [index, count, ..])
                if is_plain && idle.looks != SparseTest::Bits && kernel.constant(count) == Some(3) && offset % 8 == 0 =>
            {
                let index = self.value_in_front(kernel, index);
                let index = self.int(index);
                self.b.ins().iadd_imm_s(index, offset / 8)
            }
            _ => {
                let pointer = self.value_in_front(kernel, access.pointer);
                let pointer = self.int(pointer);
                let moved = self.b.ins().iadd_imm_s(pointer, offset);
                let position = if is_plain { moved } else { self.b.ins().band_imm_u(moved, 0x00FF_FFFF) };
                match idle.looks {
                    SparseTest::Bits => position,
                    SparseTest::Bytes | SparseTest::Differing => self.b.ins().ushr_imm_u(position, 3),
                }
            }
        };
        self.b.ins().uextend(I64, position)
    }

    /// How many iterations may be passed, whatever they look at: another one follows each of them, and all stay inside of what they look
    /// at.
    fn most_idle_iterations(&mut self, idle: &Idle, positions: &[Value]) -> Value {
        let kernel = &idle.kernel;
        let way = self.iterations_that_follow(idle);
        let iterations = self.b.ins().iconst(I64, idle.looks.iterations());
        let mut most = self.b.ins().smin(way, iterations);
        for &(number, limit) in &kernel.required {
            let number = self.value_in_front(kernel, number);
            let number = self.int(number);
            let number = self.b.ins().uextend(I64, number);
            let limit = self.b.ins().iconst(I64, i64::from(limit));
            let below = self.b.ins().isub(limit, number);
            most = self.b.ins().smin(most, below);
        }
        for (access, &position) in kernel.accesses.iter().zip(positions) {
            if access.inside.is_some() && access.sure {
                continue;
            }
            let end = self.b.ins().iconst(I64, idle.looks.positions(access.area.2 as i64));
            let inside = self.b.ins().isub(end, position);
            most = self.b.ins().smin(most, inside);
        }
        let none = self.b.ins().iconst(I64, 0);
        self.b.ins().smax(most, none)
    }

    /// How many iterations are followed by another one.
    fn iterations_that_follow(&mut self, idle: &Idle) -> Value {
        let (kernel, again) = (&idle.kernel, idle.again);
        let [first, limit] = [idle.counter, again.limit].map(|node| {
            let value = self.value_in_front(kernel, node);
            self.number_of(again.of, value)
        });
        // Of a number of 16 bits without sign it may be beyond the type.
        let limit = if again.of.signed || again.of.bits > 16 {
            limit
        } else {
            let most = self.b.ins().iconst(I64, again.of.most());
            self.b.ins().smin(limit, most)
        };
        let way = self.b.ins().isub(limit, first);
        if again.inclusive { way } else { self.b.ins().iadd_imm_s(way, -1) }
    }

    /// What is seen of iterations, the first one in the lowest bits: 0 of those that do nothing.
    fn iterations_seen(&mut self, idle: &Idle, looks: SparseTest, positions: &[Value]) -> Value {
        let kernel = &idle.kernel;
        let places = kernel.accesses.iter().zip(positions).map(|(access, &position)| {
            let byte = match looks {
                SparseTest::Bits => self.b.ins().ushr_imm_u(position, 3),
                SparseTest::Bytes | SparseTest::Differing => position,
            };
            let (base, start, _) = access.area;
            let base = self.address_of_base(base);
            (self.b.ins().iadd(base, byte), self.b.ins().band_imm_u(position, 7), start)
        });
        let places: Vec<Place> = places.collect();
        let little = MemFlagsData::new().with_notrap().with_endianness(Endianness::Little);
        let reads: Vec<Value> = places
            .iter()
            .map(|&(address, bit, start)| match looks {
                SparseTest::Bits => {
                    let word = self.b.ins().load(I64, little, address, start);
                    self.b.ins().ushr(word, bit)
                }
                SparseTest::Bytes => self.b.ins().load(I8X16, little, address, start),
                SparseTest::Differing => self.b.ins().load(I64, little, address, start),
            })
            .collect();
        if looks == SparseTest::Differing {
            let Some((access, number, idle_if_other)) = differs(kernel, kernel.ways[0]) else { unreachable!("conditions were looked at") };
            return self.bytes_that_differ(reads[access], number, idle_if_other);
        }
        let mut seen = HashMap::new();
        let mut all = None;
        for &(condition, holds) in &kernel.ways {
            let met = self.seen_in_iterations((idle, looks), condition, &reads, &mut seen);
            let differs = if holds { self.b.ins().bnot(met) } else { met };
            all = Some(match all {
                Some(all) => self.b.ins().bor(all, differs),
                None => differs,
            });
        }
        let Some(all) = all else { unreachable!("an iteration does nothing under conditions") };
        match looks {
            SparseTest::Bits => all,
            _ => {
                let bits = self.b.ins().vhigh_bits(I32, all);
                self.b.ins().uextend(I64, bits)
            }
        }
    }

    /// Of eight bytes, up to the first one that is a number or that is not, those that are not 0.
    fn bytes_that_differ(&mut self, bytes: Value, number: u8, until_equal: bool) -> Value {
        let differences = match number {
            0 => bytes,
            number => {
                let all = self.b.ins().iconst(I64, i64::from_le_bytes([number; 8]));
                self.b.ins().bxor(bytes, all)
            }
        };
        match until_equal {
            false => differences,
            // The highest bit of the first byte that is 0 is the lowest one that is set.
            true => {
                let ones = self.b.ins().iconst(I64, i64::from_le_bytes([0x01; 8]));
                let less = self.b.ins().isub(differences, ones);
                let less = self.b.ins().band_not(less, differences);
                let highest = self.b.ins().iconst(I64, i64::from_le_bytes([0x80; 8]));
                self.b.ins().band(less, highest)
            }
        }
    }

    /// A condition in all iterations that are looked at: a bit of each, or a byte of eight.
    fn seen_in_iterations(
        &mut self,
        (idle, looks): (&Idle, SparseTest),
        node: Node,
        reads: &[Value],
        seen: &mut HashMap<Node, Value>,
    ) -> Value {
        if let Some(&known) = seen.get(&node) {
            return known;
        }
        let kernel = &idle.kernel;
        let made = match kernel.what(node) {
            _ if kernel.line(node, Level::Outer).is_some_and(Affine::is_same) => {
                let value = self.value_in_front(kernel, node);
                let flag = self.flag(value);
                match looks {
                    SparseTest::Bits => {
                        let flag = self.b.ins().uextend(I64, flag);
                        self.b.ins().ineg(flag)
                    }
                    SparseTest::Bytes | SparseTest::Differing => {
                        let flag = self.b.ins().ineg(flag);
                        let byte = self.b.ins().ireduce(I8, flag);
                        self.b.ins().splat(I8X16, byte)
                    }
                }
            }
            Definition::Read(access) => reads[access],
            Definition::Compute(Op::Not, [of, ..]) => {
                let of = self.seen_in_iterations((idle, looks), of, reads, seen);
                self.b.ins().bnot(of)
            }
            Definition::Compute(op @ (Op::And | Op::AndNot | Op::Or | Op::Xor), [a, b, ..]) => {
                let [a, b] = [a, b].map(|of| self.seen_in_iterations((idle, looks), of, reads, seen));
                match op {
                    Op::And => self.b.ins().band(a, b),
                    Op::AndNot => self.b.ins().band_not(a, b),
                    Op::Or => self.b.ins().bor(a, b),
                    _ => self.b.ins().bxor(a, b),
                }
            }
            _ => {
                let Some((access, constant, with)) = comparison(kernel, node) else { unreachable!("conditions were looked at") };
                let constant = self.b.ins().iconst(I8, i64::from(constant));
                let constant = self.b.ins().splat(I8X16, constant);
                self.b.ins().icmp(with, reads[access], constant)
            }
        };
        seen.insert(node, made);
        made
    }
}
