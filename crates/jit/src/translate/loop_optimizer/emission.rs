//! Emission of the fast version of a loop.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::Translator;
use super::super::natural_loops::NaturalLoop;
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::bit_interleaving::{self, InterleavedBits, PackedByte, Place};
use super::branch_on_superword::UniformBranch;
use super::interleaved_access::AccessGroups;
use super::kernel::{Access, Definition, Effect, Kernel, Level, Node, Slot, SlotKind};
use super::loop_carried::LoopCarried;
use super::scalar_evolution::{AddReduction, Affine, Recurrence};
use super::strided_access::Strided;
use super::trip_count::Progress;
use super::vector_division::greatest;
use super::vectorization::Lanes;
use super::{LoopPlan, VersionPlan};

/// What one of the loops has while its iterations are written.
#[derive(Clone, Default)]
pub(super) struct Scope {
    pub(super) values: HashMap<Node, Lanes>,
    /// What slots hold when an iteration begins.
    pub(super) starts: HashMap<Slot, Lanes>,
    /// Addresses that are counted on, by their pointers and offsets.
    pub(super) addresses: HashMap<(Base, Node, u32), Value>,
    /// Bytes of which one bit was read or written, by their addresses and accesses to them: one of each iteration, or vectors of them.
    pub(super) bytes: Vec<(Value, i32, usize, Vec<Value>)>,
    /// Where vectorized iterations have read what lies apart, by the accesses.
    pub(super) sources: Vec<(usize, Strided)>,
}

/// Writes one version of the iterations of a loop.
pub(super) struct Emitter<'t, 'a, 'k> {
    pub(super) t: &'t mut Translator<'a>,
    pub(super) plan: &'k LoopPlan,
    pub(super) kernel: &'k Kernel,
    /// Vectorized iterations.
    pub(super) lanes: u32,
    /// Accesses whose bits make whole bytes, if eight iterations are written behind one another.
    pub(super) gathered: Option<InterleavedBits>,
    /// Those that make whole bytes in iterations behind these ones: single iterations are made up to the first bit of a byte.
    up_to: Option<InterleavedBits>,
    /// How vectorized iterations are done that all go the same way.
    pub(super) alike: Option<&'k UniformBranch>,
    /// Which of these iterations is written, and their bytes so far.
    pub(super) iteration: u32,
    pub(super) pieces: BTreeMap<Place, PackedByte>,
    /// Structures and instances whose fields are read and written together.
    pub(super) records: AccessGroups,
    pub(super) outer: Scope,
    pub(super) inner: Scope,
    /// What was written since the running iterations began.
    pub(super) written: Vec<usize>,
    /// What single iterations of those side by side have made.
    pub(super) in_lanes: HashMap<(Node, u32), Val>,
    /// What slots hold before the loop.
    pub(super) before: HashMap<Slot, Val>,
    sums: HashMap<Slot, Vec<Value>>,
    /// Choices that leave the less or greater of two REALs or LREALs for the next iteration.
    pub(super) extremes: BTreeSet<Node>,
    /// What blocks have taken from the budget that not all iterations enter.
    pub(super) taken: Option<Val>,
    /// How many iterations the inner loop makes in each iteration of the outer one.
    pub(super) inner_iterations: Option<Value>,
    /// How many iterations of the outer loop are made, and where it is.
    progress: Option<(Value, Progress)>,
}

impl<'t, 'a, 'k> Emitter<'t, 'a, 'k> {
    /// Writes iterations, as many as there are and as the budget covers, and goes on where more iterations may follow. Goes to the
    /// statement behind the loop if there are none.
    pub(super) fn write(t: &'t mut Translator<'a>, plan: &'k LoopPlan, it: &NaturalLoop, writes: VersionPlan<'k>) {
        Self::new(t, plan, writes).version(it);
    }

    pub(super) fn new(
        t: &'t mut Translator<'a>,
        plan: &'k LoopPlan,
        VersionPlan { lanes, gathered, up_to, alike }: VersionPlan<'k>,
    ) -> Self {
        let kernel = &plan.kernel;
        Emitter {
            t,
            plan,
            kernel,
            lanes,
            gathered,
            up_to,
            alike,
            iteration: 0,
            pieces: BTreeMap::new(),
            records: kernel.records(lanes),
            outer: Scope::default(),
            inner: Scope::default(),
            written: Vec::new(),
            in_lanes: HashMap::new(),
            before: HashMap::new(),
            sums: HashMap::new(),
            extremes: BTreeSet::new(),
            taken: None,
            inner_iterations: None,
            progress: None,
        }
    }

    fn version(&mut self, it: &NaturalLoop) {
        self.t.settle_bytes();
        self.take_before();
        let (iterations, guard, all) = self.how_many();
        let [enter, go_on] = [self.t.b.create_block(), self.t.b.create_block()];
        self.t.b.ins().brif(guard, enter, &[], go_on, &[]);
        self.t.b.switch_to_block(enter);
        self.t.b.seal_block(enter);
        self.read_ahead();
        let done = self.iterations(Level::Outer, iterations);
        debug_assert!(done.is_empty() || self.lanes > 1);
        self.finish(iterations);
        self.leave_whole(it, (iterations, all), go_on);
    }

    /// Takes what slots hold before the loop.
    fn take_before(&mut self) {
        for slot in self.kernel.slots_at_start() {
            let value = self.t.slot_before(self.kernel, slot);
            self.before.insert(slot, value);
        }
    }

    /// Takes iterations from the budget and goes where more iterations may follow, or behind the loop if these were all.
    fn leave_whole(&mut self, it: &NaturalLoop, (iterations, all): (Value, Value), go_on: Block) {
        let weight = i64::from(self.kernel.outer.weight);
        let left = self.take_budget(iterations);
        let budget = self.t.budget();
        let ended = self.t.b.ins().icmp(IntCC::Equal, iterations, all);
        let leave = self.t.b.create_block();
        self.t.b.def_var(budget, left);
        self.t.b.ins().brif(ended, leave, &[], go_on, &[]);
        self.t.leave_behind(it, leave, left, weight);
        self.t.b.switch_to_block(go_on);
        self.t.b.seal_block(go_on);
        self.t.forget_memory();
    }

    /// How many iterations are made here, whether any are, and how many the loop has.
    fn how_many(&mut self) -> (Value, Value, Value) {
        let count = self.plan.count;
        let counter = self.value_before(count.counter);
        let limit = count.limit.map_or(Val::Const(0), |limit| self.value_before(limit));
        let (all, inside) = self.t.iterations(count, counter, limit);
        let inner_inside = self.count_inner_iterations();
        let [_, most] = self.weights();
        let iterations = self.t.within_budget(all, most);
        let iterations = match self.lanes * self.behind_one_another() {
            1 => iterations,
            together => self.t.b.ins().band_imm_s(iterations, -i64::from(together)),
        };
        let iterations = match self.up_to.take() {
            Some(pieces) => self.iterations_up_to_byte(&pieces, iterations),
            None => iterations,
        };
        let mut guard = self.t.b.ins().icmp_imm_s(IntCC::SignedGreaterThan, iterations, 0);
        let mut also = |this: &mut Self, condition: Value| guard = this.t.b.ins().band(guard, condition);
        for inside in [inside, inner_inside].into_iter().flatten() {
            also(self, inside);
        }
        for &slot in self.before.clone().keys() {
            let line = self.kernel.slot_line(Level::Outer, slot);
            if line.is_some_and(|line| line.bits == 16) && matches!(self.kernel.kept(slot), SlotKind::Register(_)) {
                let value = self.before[&slot];
                let value = self.t.int(value);
                let short = self.t.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, value, 0xFFFF);
                also(self, short);
            }
        }
        for access in self.kernel.accesses.iter().filter(|access| !access.sure) {
            let inside = self.stays_inside(access, iterations);
            also(self, inside);
        }
        for begins in self.pieces_begin_bytes() {
            also(self, begins);
        }
        for &(number, limit) in &self.kernel.required {
            let stays_below = self.stays_below((number, Level::Outer), limit, iterations);
            also(self, stays_below);
        }
        for &(condition, holds) in &self.kernel.settled {
            let condition = self.value_before(condition);
            let condition = self.t.flag(condition);
            let is_so = self.t.b.ins().icmp_imm_u(IntCC::Equal, condition, i64::from(holds));
            also(self, is_so);
        }
        let guard = self.look_at_numbers(iterations, guard);
        (iterations, guard, all)
    }

    /// Iterations that are written behind one another.
    fn behind_one_another(&self) -> u32 {
        if self.gathered.is_some() { bit_interleaving::ITERATIONS } else { 1 }
    }

    /// Whether a number on a line of a loop stays below a limit for so many iterations of it.
    pub(super) fn stays_below(&mut self, (number, level): (Node, Level), limit: u32, iterations: Value) -> Value {
        let line = self.kernel.line(number, level).unwrap_or(Affine::SAME);
        let first = self.value_before(number);
        let first = self.t.int(first);
        let first = self.t.b.ins().uextend(I64, first);
        let below = self.t.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, first, i64::from(limit));
        if line.is_same() {
            return below;
        }
        let more = self.t.b.ins().iadd_imm_s(iterations, -1);
        let way = self.t.b.ins().imul_imm_s(more, i64::from(line.step as i32));
        let last = self.t.b.ins().iadd(first, way);
        let last = self.t.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, last, i64::from(limit));
        self.t.b.ins().band(below, last)
    }

    /// Whether an access whose pointer is affine stays inside its area for so many iterations.
    fn stays_inside(&mut self, access: &Access, iterations: Value) -> Value {
        let line = self.kernel.line(access.pointer, Level::Outer).unwrap_or(Affine::SAME);
        let position = self.position_before(access.pointer, access.offset);
        let whole = self.t.b.ins().uextend(I64, position);
        // On the ways that lead to it, it may be known to go to a part of the area.
        let (_, start, length) = access.area;
        let area = 0..length as i64;
        let bytes = access.inside.as_ref().map_or(area, |inside| inside.start - i64::from(start)..inside.end - i64::from(start));
        let first = if bytes.start == 0 { whole } else { self.t.b.ins().iadd_imm_s(whole, -8 * bytes.start) };
        let more = self.t.b.ins().iadd_imm_s(iterations, -1);
        let way = self.t.b.ins().imul_imm_s(more, i64::from(line.step as i32));
        let last = self.t.b.ins().iadd(first, way);
        let (low, high) = if (line.step as i32) < 0 { (last, first) } else { (first, last) };
        let bits = if access.width == Width::Bit { 1 } else { i64::from(access.width.bytes()) * 8 };
        let end = (bytes.end - bytes.start) * 8 - bits;
        let low = self.t.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, low, 0);
        let high = self.t.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, high, end);
        let both = self.t.b.ins().band(low, high);
        if access.width == Width::Bit {
            return both;
        }
        let odd = self.t.b.ins().band_imm_u(position, 7);
        let even = self.t.b.ins().icmp_imm_u(IntCC::Equal, odd, 0);
        self.t.b.ins().band(both, even)
    }

    /// A pointer with its offset, 24 bits, as it is in the first iteration.
    pub(super) fn position_before(&mut self, pointer: Node, offset: u32) -> Value {
        let pointer = self.value_before(pointer);
        self.position(pointer, offset)
    }

    pub(super) fn position(&mut self, pointer: Val, offset: u32) -> Value {
        let pointer = self.t.int(pointer);
        let moved = if offset == 0 { pointer } else { self.t.b.ins().iadd_imm_u(pointer, i64::from(offset)) };
        self.t.b.ins().band_imm_u(moved, 0x00FF_FFFF)
    }

    /// A value as it is in the first iteration of the loop, before it. It rests on no memory that the loop reads.
    pub(super) fn value_before(&mut self, node: Node) -> Val {
        match self.kernel.what(node) {
            Definition::Constant(value) => Val::Const(value),
            Definition::Start(Level::Outer, slot) => self.before[&slot],
            Definition::Start(Level::Inner, slot) => {
                let entry = self.plan.entry(slot);
                self.value_before(entry)
            }
            Definition::Compute(op, args) => {
                let args: Vec<Val> = args[..op.arity()].iter().map(|&arg| self.value_before(arg)).collect();
                self.t.compute_now(op, &args)
            }
            Definition::After(_) | Definition::Read(_) => unreachable!("a value on a line rests on no memory"),
        }
    }

    /// The same for the inner loop, in an iteration of the outer one.
    pub(super) fn value_at_entry(&mut self, node: Node) -> Val {
        if let Definition::Start(Level::Inner, slot) = self.kernel.what(node) {
            let entry = self.plan.entry(slot);
            return self.first(entry, Level::Outer);
        }
        match self.kernel.what(node) {
            Definition::Compute(op, args) => {
                let args: Vec<Val> = args[..op.arity()].iter().map(|&arg| self.value_at_entry(arg)).collect();
                self.t.compute_now(op, &args)
            }
            _ => self.first(node, Level::Outer),
        }
    }

    /// A value of the first of the vectorized iterations.
    pub(super) fn first(&mut self, node: Node, level: Level) -> Val {
        match self.value(node, level) {
            Lanes::One(value) | Lanes::Affine(value, _) => value,
            _ => unreachable!("addresses are on a line"),
        }
    }

    pub(super) fn scope(&mut self, level: Level) -> &mut Scope {
        match level {
            Level::Outer => &mut self.outer,
            Level::Inner => &mut self.inner,
        }
    }

    /// Writes iterations of a loop; the vectors of its sums behind it.
    pub(super) fn iterations(&mut self, level: Level, iterations: Value) -> Vec<Value> {
        let step = if level == Level::Outer { self.lanes } else { 1 };
        let handed = self.handed(level);
        // An address that is counted on tells when the last iteration was made, if it has one.
        let counting = handed.iter().enumerate().find_map(|(at, one)| match *one {
            LoopCarried::Address(.., step) if step != 0 && level == Level::Outer && self.lanes == 1 => Some((at, step)),
            _ => None,
        });
        let mut first = if counting.is_some() { Vec::new() } else { vec![iterations] };
        let others = first.len();
        for one in &handed {
            self.first_of(level, one, &mut first);
        }
        let end = counting.map(|(at, step)| {
            let way = self.t.b.ins().imul_imm_s(iterations, step);
            self.t.b.ins().iadd(first[others + at], way)
        });
        let head = self.t.b.create_block();
        let arguments: Vec<BlockArg> = first.iter().map(|&value| BlockArg::Value(value)).collect();
        self.t.b.ins().jump(head, &arguments);
        self.t.b.switch_to_block(head);
        let parameters: Vec<Value> = first
            .iter()
            .map(|&value| {
                let ty = self.t.b.func.dfg.value_type(value);
                self.t.b.append_block_param(head, ty)
            })
            .collect();
        let together = if level == Level::Outer { self.behind_one_another() } else { 1 };
        self.written.clear();
        self.in_lanes.clear();
        let mut now = parameters;
        for iteration in 0..together {
            self.iteration = iteration;
            if iteration > 0 {
                self.outer = Scope::default();
            }
            let progress = match counting {
                Some((at, step)) => Progress::Address { now: now[others + at], first: first[others + at], step },
                None => Progress::Left(now[0]),
            };
            if level == Level::Outer {
                self.progress = Some((iterations, progress));
                self.t.in_iterations = self.lanes == 1;
            }
            self.begin(level, &handed, &now[others..]);
            let next_of_iteration = match self.alike {
                Some(alike) if level == Level::Outer => Some(self.iterations_alike(alike, &handed, &now)),
                _ => {
                    self.steps_of_iteration(level);
                    None
                }
            };
            if level == Level::Outer {
                self.t.in_iterations = false;
            }
            if let Some(next) = next_of_iteration {
                now = next;
                continue;
            }
            let mut next = match counting {
                Some(_) => Vec::new(),
                None => vec![self.t.b.ins().iadd_imm_s(now[0], -i64::from(step))],
            };
            for (one, own) in handed.iter().zip(self.owned(&handed, &now[others..])) {
                self.next_of(level, one, &own, &mut next);
            }
            now = next;
        }
        if level == Level::Outer {
            self.store_pieces();
        }
        let next = now;
        let again = match (counting, end) {
            (Some((at, _)), Some(end)) => self.t.b.ins().icmp(IntCC::NotEqual, next[others + at], end),
            _ => next[0],
        };
        let behind = self.t.b.create_block();
        let arguments: Vec<BlockArg> = next.iter().map(|&value| BlockArg::Value(value)).collect();
        self.t.b.ins().brif(again, head, &arguments, behind, &[]);
        self.t.b.seal_block(head);
        self.t.b.switch_to_block(behind);
        self.t.b.seal_block(behind);
        let mut all = Vec::new();
        let mut at = others;
        for one in &handed {
            let count = self.count_of(one);
            if let LoopCarried::Sum(slot, ..) | LoopCarried::MinMax(slot, ..) = one {
                self.sums.insert(*slot, next[at..at + count].to_vec());
                all.extend(&next[at..at + count]);
            }
            at += count;
        }
        all
    }

    /// Does what an iteration does, or several of them side by side.
    pub(super) fn steps_of_iteration(&mut self, level: Level) {
        let mut steps = self.kernel.iteration(level).steps.iter().copied().peekable();
        while let Some(step) = steps.next() {
            match step {
                Effect::Copy(first) => {
                    let mut numbers = vec![first];
                    while let Some(&Effect::Copy(next)) = steps.peek()
                        && self.kernel.copies[next].reached == self.kernel.copies[first].reached
                    {
                        numbers.push(next);
                        steps.next();
                    }
                    self.copy_whole(&numbers);
                }
                // It was read to look where the iterations go.
                Effect::Access(access) if self.was_read_first(access) => {}
                Effect::Access(access) => {
                    self.access(access, level);
                    self.written.extend(self.kernel.accesses[access].value.is_some().then_some(access));
                }
                Effect::Inner => {
                    let iterations = self.all_inner_iterations();
                    self.inner = Scope::default();
                    self.iterations(Level::Inner, iterations);
                    self.outer.bytes.clear();
                }
            }
        }
        self.write_records();
    }

    /// What a slot holds before a loop.
    pub(super) fn entry(&mut self, level: Level, slot: Slot) -> Lanes {
        match level {
            Level::Outer => Lanes::One(self.before[&slot]),
            Level::Inner => {
                let entry = self.plan.entry(slot);
                self.value(entry, Level::Outer)
            }
        }
    }

    /// What a slot holds when the first of the running iterations begins.
    pub(super) fn start(&mut self, slot: Slot) -> Lanes {
        match self.outer.starts.get(&slot) {
            Some(value) => value.clone(),
            None => self.entry(Level::Outer, slot),
        }
    }

    /// The address to which a pointer goes, without the first byte of its area.
    pub(super) fn address(&mut self, base: Base, value: Val, offset: u32) -> Value {
        let position = self.position(value, offset);
        let byte = self.t.b.ins().ushr_imm_u(position, 3);
        let byte = self.t.b.ins().uextend(I64, byte);
        let base = self.base(base);
        self.t.b.ins().iadd(base, byte)
    }

    pub(super) fn base(&self, base: Base) -> Value {
        self.t.address_of_base(base)
    }

    /// A value in the running iteration.
    pub(super) fn value(&mut self, node: Node, level: Level) -> Lanes {
        if let Some(value) = self.outer.values.get(&node) {
            return value.clone();
        }
        if level == Level::Inner
            && let Some(value) = self.inner.values.get(&node)
        {
            return value.clone();
        }
        if self.lanes > 1 && self.kernel.in_order.nodes.contains(&node) {
            let value = self.made_in_order(node);
            self.scope(level).values.insert(node, value.clone());
            return value;
        }
        let value = match self.kernel.what(node) {
            Definition::Constant(value) => return Lanes::One(Val::Const(value)),
            Definition::Start(of, slot) => {
                let known = self.scope(of).starts.get(&slot).cloned();
                match known {
                    Some(value) => value,
                    None if of == Level::Outer
                        && self.lanes == 1
                        && let (Some(line), Some((iterations, progress))) = (self.kernel.slot_line(of, slot), self.progress)
                        && !line.is_same() =>
                    {
                        let made = self.t.iterations_made(progress, iterations);
                        Lanes::One(self.t.behind(self.before[&slot], line, made))
                    }
                    None => {
                        let same = self.kernel.slot_line(of, slot).is_some_and(Affine::is_same);
                        assert!(same, "what an iteration begins with is handed on where iterations change it");
                        self.entry(of, slot)
                    }
                }
            }
            Definition::After(slot) => {
                let end = self.kernel.iteration(Level::Inner).ends[&slot];
                self.value(end, Level::Inner)
            }
            Definition::Read(_) => unreachable!("what is read is read in its iteration"),
            Definition::Compute(op, args) => {
                let args: Vec<Lanes> = args[..op.arity()].iter().map(|&arg| self.value(arg, level)).collect();
                self.compute(node, op, &args, level)
            }
        };
        self.scope(level).values.insert(node, value.clone());
        value
    }

    pub(super) fn set_value(&mut self, node: Node, value: Lanes) {
        self.outer.values.insert(node, value);
    }

    fn compute(&mut self, node: Node, op: Op, args: &[Lanes], level: Level) -> Lanes {
        let firsts: Option<Vec<Val>> = args
            .iter()
            .map(|arg| match arg {
                Lanes::One(value) | Lanes::Affine(value, _) => Some(*value),
                _ => None,
            })
            .collect();
        if let Some(firsts) = firsts {
            if args.iter().all(|arg| matches!(arg, Lanes::One(_))) {
                if self.extremes.contains(&node)
                    && let Some((extreme, _, ty)) = self.kernel.extreme_of_reals(node)
                {
                    return Lanes::One(self.t.exact_extreme(extreme, [firsts[1], firsts[2]], ty));
                }
                self.note_bounds(node, &firsts);
                return Lanes::One(self.t.compute_now(op, &firsts));
            }
            if let Some(line) = self.kernel.line(node, Level::Outer) {
                if line.is_same() {
                    return Lanes::One(self.t.compute_now(op, &firsts));
                }
                return Lanes::Affine(self.t.compute_now(op, &firsts), line);
            }
        }
        let shape = self.kernel.shape(node).expect("the shapes were looked at");
        if self.kernel.is_one_by_one(node) {
            let bounds = match self.kernel.what(node) {
                Definition::Compute(_, [number, ..]) => self.kernel.bounds.get(&number).copied(),
                _ => None,
            };
            return self.t.compute_one_by_one(op, shape, args, bounds, self.lanes);
        }
        if let (Some(most), &[ref number, Lanes::One(Val::Const(divisor))]) = (greatest(op), args) {
            let range = self.range_of_divided(node, most);
            return self.t.divide_lanes(op, number, divisor as u32, range, self.lanes);
        }
        if op == Op::F64ToI32
            && let Definition::Compute(_, [lreal, ..]) = self.kernel.what(node)
            && let Definition::Compute(_, [real, ..]) = self.kernel.what(lreal)
        {
            let reals = self.value(real, level);
            return self.t.cut_lanes(&reals, self.lanes);
        }
        self.t.compute_lanes(op, shape, args, self.lanes)
    }

    /// Notes the bounds that are known of the first number that an operation takes in one iteration.
    pub(super) fn note_bounds(&mut self, node: Node, args: &[Val]) {
        if let Definition::Compute(_, [number, ..]) = self.kernel.what(node)
            && let (Some(&bounds), Some(&Val::Int(value))) = (self.kernel.bounds.get(&number), args.first())
        {
            self.t.bounds.insert(value, bounds);
        }
    }

    /// The range of the numbers that an operation divides, which are at most so great.
    fn range_of_divided(&self, node: Node, most: u64) -> (i64, i64) {
        let Definition::Compute(_, [number, ..]) = self.kernel.what(node) else { unreachable!("something divides") };
        if let Some(&(least, most)) = self.kernel.bounds.get(&number) {
            return (least.into(), most.into());
        }
        let most = match self.kernel.what(number) {
            Definition::Compute(Op::Extend16, _) => i16::MAX.into(),
            _ => most as i64,
        };
        (-most - 1, most)
    }

    /// What slots hold behind the iterations.
    pub(super) fn ends(&mut self, iterations: Value) -> Vec<(Slot, Val)> {
        let mut last = Vec::new();
        // What a sum was when the last iteration began.
        let mut before_last: Vec<(Slot, AddReduction)> = Vec::new();
        for (slot, end, carried) in self.kernel.carried(Level::Outer) {
            if matches!(self.kernel.kept(slot), SlotKind::Ahead { .. }) {
                continue;
            }
            let value = match carried {
                Recurrence::Affine(line) => {
                    let before = self.before[&slot];
                    self.t.behind(before, line, iterations)
                }
                Recurrence::Sum { bits, .. } if self.lanes > 1 => {
                    let vectors = self.sums.get(&slot).cloned().unwrap_or_default();
                    let sum = self.t.sum_of_lanes(&vectors, self.lanes);
                    let before = self.before[&slot];
                    let before = self.t.int(before);
                    let sum = self.t.b.ins().iadd(before, sum);
                    self.t.on_line(sum, Affine { step: 0, bits })
                }
                Recurrence::MinMax { extreme, bits, .. } if self.lanes > 1 => {
                    let vectors = self.sums.get(&slot).cloned().unwrap_or_default();
                    let found = self.t.extreme_in_lanes(extreme, &vectors, self.lanes);
                    self.t.on_line(found, Affine { step: 0, bits })
                }
                Recurrence::Nothing
                    if self.lanes > 1
                        && let Some(sum) = self.kernel.sum_at_start(end) =>
                {
                    before_last.push((slot, sum));
                    continue;
                }
                Recurrence::Chain if self.lanes > 1 && self.kernel.in_order.slots.contains(&slot) => self.in_lane(end, self.lanes - 1),
                _ => {
                    let value = self.value(end, Level::Outer);
                    self.t.last_lane(&value, self.lanes)
                }
            };
            last.push((slot, value));
        }
        for (slot, AddReduction { of, added, bits }) in before_last {
            let added = self.value(added, Level::Outer);
            let added = self.t.last_lane(&added, self.lanes);
            let whole = last.iter().find(|(slot, _)| *slot == of).map(|&(_, value)| value);
            let (whole, added) = (self.t.int(whole.expect("a sum is left")), self.t.int(added));
            let before = self.t.b.ins().isub(whole, added);
            last.push((slot, self.t.on_line(before, Affine { step: 0, bits })));
        }
        last
    }

    /// Writes what slots hold behind the iterations.
    fn finish(&mut self, iterations: Value) {
        for (slot, value) in self.ends(iterations) {
            if self.kernel.kept(slot) == SlotKind::Budget {
                self.taken = Some(value);
            }
            self.t.write_slot(self.kernel, slot, value);
        }
        self.t.settle_bytes();
    }
}
