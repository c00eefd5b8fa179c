//! Branches on superword condition codes: conditions of vectorized iterations are selects, and each iteration computes both sides; where a
//! condition is uniform, true in all lanes or in none, a shorter version of the iterations does the rest.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::mem::discriminant;

use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, Value};
use rustc_hash::FxHashMap;
use sieben_engine::ir::Op;

use super::super::value::Val;
use super::emission::{Emitter, Scope};
use super::interleaved_access::AccessGroups;
use super::kernel::{Definition, Effect, Kernel, Level, Node, Slot};
use super::loop_carried::{Form, LoopCarried};
use super::ordered_reduction::OrderedReduction;
use super::scalar_evolution::{Recurrence, Shape};
use super::{InnerTripCount, LoopPlan};
use crate::passes::Pass;

/// Vectorized iterations.
pub(super) const ITERATIONS: u32 = 4;
/// Values of an iteration: larger ones are not looked at.
const NODES_MAX: usize = 600;
/// Instructions of all vectorized iterations: larger ones are not written once more.
const COST_MAX: u32 = 500;
/// Conditions that are tried, those first on which most rests.
const CONDITIONS_MAX: usize = 4;
/// How far conditions made of others are followed.
const DEPTH_MAX: usize = 6;
/// Iterations after which a condition at the least is as it was, for several ones to share it.
const PERIOD_MIN: u64 = 8;
/// Instructions that a shorter version has to save, for the look to be worth it: one that was not foreseen costs about as much as 60.
const SAVED_MIN: u32 = 20;
/// Fifths of all that both sides have to save together where iterations ask for states: neighbours often have others.
const OF_STATES_MIN: u32 = 2;

/// How vectorized iterations are done if they all go the same way.
pub(super) struct UniformBranch {
    condition: Node,
    /// What has to be read to look at the condition, in its order.
    first: Vec<usize>,
    sides: [UniformSide; 2],
    /// What the last iteration leaves in slots that are not handed on, as vectors.
    left: Vec<(Slot, Node, Shape)>,
}

/// The iterations where a condition holds in all of them, or in none.
struct UniformSide {
    holds: bool,
    kernel: Kernel,
    /// What is added to slots, handed on, or left in them here.
    ends: BTreeMap<Slot, Node>,
    saved: u32,
}

impl LoopPlan {
    /// The condition whose sides are the shortest if it is the same in all iterations, if that is worth it.
    pub(super) fn alike(&self) -> Option<UniformBranch> {
        if !self.kernel.passes.has(Pass::BranchOnSuperword) {
            return None;
        }
        let kernel = &self.kernel;
        if !kernel.only_accesses(NODES_MAX) {
            return None;
        }
        let left = kernel.left_as_vectors()?;
        let cost = kernel.cost();
        if cost > COST_MAX {
            return None;
        }
        let found = kernel.conditions().into_iter().filter_map(|condition| {
            let first = kernel.first_for(condition)?;
            let sides = [self.side(condition, false, cost)?, self.side(condition, true, cost)?];
            let saved: u32 = sides.iter().map(|side| side.saved).sum();
            let is_worth_it = first.is_empty() || saved * 5 >= cost * OF_STATES_MIN;
            is_worth_it.then(|| (saved, UniformBranch { condition, first, sides, left: left.clone() }))
        });
        found.max_by_key(|(saved, alike)| (*saved, Reverse(alike.condition))).map(|(_, alike)| alike)
    }

    /// The iterations where a condition holds in all of them, or in none.
    fn side(&self, condition: Node, holds: bool, cost: u32) -> Option<UniformSide> {
        let whole = &self.kernel;
        let mut kernel = whole.clone();
        kernel.in_order = OrderedReduction::default();
        kernel.assume(condition, holds, DEPTH_MAX);
        kernel.simplify();
        if !whole.in_order.slots.is_empty() {
            kernel = kernel.with_order()?;
        }
        if kernel.in_order.slots != whole.in_order.slots {
            return None;
        }
        let saved = cost.checked_sub(kernel.cost()).filter(|&saved| saved >= SAVED_MIN)?;
        let ends = kernel.ends_as_in(whole)?;
        let plan = Self { kernel, count: self.count, inner: InnerTripCount::Constant(0) };
        (plan.lanes() == [ITERATIONS]).then_some(UniformSide { holds, kernel: plan.kernel, ends, saved })
    }
}

impl Kernel {
    /// Whether iterations do nothing but read and write single places, and compute no more values than so many.
    fn only_accesses(&self, nodes_max: usize) -> bool {
        self.inner.is_none()
            && self.copies.is_empty()
            && self.nodes.len() <= nodes_max
            && self.outer.steps.iter().all(|step| matches!(step, Effect::Access(_)))
    }

    /// The condition of a choice.
    fn asked_by(&self, node: Node) -> Option<Node> {
        match self.what(node) {
            Definition::Compute(Op::Select, [condition, ..]) | Definition::Compute(Op::Gate, [_, condition, ..]) => Some(condition),
            _ => None,
        }
    }

    /// What the last iteration leaves in slots that are not handed on, as far as vectorized iterations have it in vectors; `None` if
    /// iterations hand on something for which there is no place.
    fn left_as_vectors(&self) -> Option<Vec<(Slot, Node, Shape)>> {
        let mut left = Vec::new();
        for (slot, end, carried) in self.carried(Level::Outer) {
            match carried {
                Recurrence::Affine(_) | Recurrence::Sum { .. } => {}
                Recurrence::Chain if self.in_order.slots.contains(&slot) => {}
                Recurrence::Nothing => {
                    // What a sum was when the last iteration began is made of what that iteration adds.
                    let (slot, node) = self.sum_at_start(end).map_or((slot, end), |sum| (sum.of, sum.added));
                    match self.shape(node)? {
                        Shape::Affine(_) => {}
                        shape => left.push((slot, node, shape)),
                    }
                }
                Recurrence::Chain | Recurrence::MinMax { .. } => return None,
            }
        }
        Some(left)
    }

    /// The conditions of choices, those first that are asked most.
    fn conditions(&self) -> Vec<Node> {
        let mut asked: BTreeMap<Node, usize> = BTreeMap::new();
        for node in self.reached() {
            let Some(condition) = self.asked_by(node) else { continue };
            let is_mask = self.shape(condition) == Some(Shape::Mask) && self.is_bit(condition);
            if is_mask && !self.in_order.nodes.contains(&condition) && self.is_foreseen(condition) {
                *asked.entry(condition).or_default() += 1;
            }
        }
        let mut conditions: Vec<(usize, Node)> = asked.into_iter().map(|(condition, times)| (times, condition)).collect();
        conditions.sort_unstable_by_key(|&(times, condition)| (Reverse(times), condition));
        conditions.into_iter().take(CONDITIONS_MAX).map(|(_, condition)| condition).collect()
    }

    /// Whether a processor is likely to foresee a condition, and several iterations one after the other to share it: one that is made of
    /// the number of the iteration alone, or the question for a state.
    fn is_foreseen(&self, condition: Node) -> bool {
        let mut parts = BTreeSet::new();
        self.rests(condition, &mut parts);
        if parts.iter().any(|&part| matches!(self.what(part), Definition::Read(_))) {
            let Definition::Compute(op, [a, b, ..]) = self.what(condition) else { return false };
            let compares = matches!(op, Op::EqI16 | Op::EqI32 | Op::Equal | Op::NeI16 | Op::NeI32 | Op::Differ);
            return compares && [a, b].iter().any(|&part| self.constant(part).is_some());
        }
        // Each second or third iteration goes another way.
        let alternates = |&part: &Node| match self.what(part) {
            Definition::Compute(Op::RemI16 | Op::RemI32, [_, by, ..]) => self.constant(by).is_none_or(|by| by < PERIOD_MIN),
            Definition::Compute(Op::AndU32, [_, by, ..]) => self.constant(by).is_some_and(|by| by < PERIOD_MIN - 1),
            _ => false,
        };
        !parts.iter().any(alternates)
    }

    /// All values on which rests what an iteration writes and leaves.
    pub(super) fn reached(&self) -> BTreeSet<Node> {
        let mut reached = BTreeSet::new();
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        self.all_ends().chain(of_accesses).for_each(|node| self.rests(node, &mut reached));
        reached
    }

    /// What is read for a condition, if it can be read before all that iterations write.
    fn first_for(&self, condition: Node) -> Option<Vec<usize>> {
        let mut needed = BTreeSet::new();
        self.reads_behind(condition, &mut BTreeSet::new(), &mut needed);
        let mut written: Vec<usize> = Vec::new();
        let mut first = Vec::new();
        for (number, access) in self.accesses_in_order() {
            if access.value.is_some() {
                written.push(number);
            } else if needed.contains(&number) {
                if written.iter().any(|&other| self.touches(number, true, other)) {
                    return None;
                }
                first.push(number);
            }
        }
        Some(first)
    }

    /// Adds the reads on which a value rests, and those on which their addresses do, as far as they were not seen before.
    fn reads_behind(&self, node: Node, seen: &mut BTreeSet<Node>, reads: &mut BTreeSet<usize>) {
        let mut waiting = vec![node];
        while let Some(node) = waiting.pop() {
            if !seen.insert(node) {
                continue;
            }
            match self.what(node) {
                Definition::Compute(op, args) => waiting.extend(&args[..op.arity()]),
                Definition::Read(access) => {
                    reads.insert(access);
                    waiting.push(self.accesses[access].pointer);
                }
                // What an iteration begins with in order is what the one before ends with, which is one of those side by side.
                Definition::Start(Level::Outer, slot) if self.in_order.slots.contains(&slot) => waiting.push(self.outer.ends[&slot]),
                _ => {}
            }
        }
    }

    /// About how many instructions four vectorized iterations take.
    fn cost(&self) -> u32 {
        let of_nodes = self.reached().into_iter().map(|node| match self.what(node) {
            Definition::Compute(..) if self.line(node, Level::Outer).is_some() => 0,
            Definition::Compute(..) if self.is_one_by_one(node) => 3 * ITERATIONS,
            Definition::Compute(Op::DivF32 | Op::Select | Op::MinF32 | Op::MaxF32, _) => 3,
            Definition::Compute(..) => 1,
            _ => 0,
        });
        let of_accesses = self.accesses.iter().map(|access| if self.apart(access).is_some() { ITERATIONS + 2 } else { 3 });
        of_nodes.chain(of_accesses).sum()
    }

    /// Makes a condition a constant, with all that is known then.
    fn assume(&mut self, condition: Node, holds: bool, depth: usize) {
        if depth > 0
            && let Definition::Compute(op, [a, b, ..]) = self.what(condition)
        {
            let parts = match (op, holds) {
                (Op::Not, _) => vec![(a, !holds)],
                (Op::And, true) | (Op::Or, false) => vec![(a, holds), (b, holds)],
                (Op::AndNot, true) => vec![(a, true), (b, false)],
                _ => Vec::new(),
            };
            for (part, holds) in parts {
                if self.is_bit(part) && self.constant(part).is_none() {
                    self.assume(part, holds, depth - 1);
                }
            }
            let equal = match op {
                Op::EqI16 | Op::EqI32 | Op::Equal => holds,
                Op::NeI16 | Op::NeI32 | Op::Differ => !holds,
                _ => false,
            };
            // What lies above the bits that are compared is not known.
            let is_whole = |node: Node| match op {
                Op::EqI16 | Op::NeI16 => self.is_16_bits(node),
                Op::EqI32 | Op::NeI32 => self.is_32_bits(node),
                _ => true,
            };
            if equal && is_whole(a) && is_whole(b) {
                match (self.constant(a), self.constant(b)) {
                    (None, Some(number)) => self.replace(a, number),
                    (Some(number), None) => self.replace(b, number),
                    _ => {}
                }
            }
        }
        self.replace(condition, u64::from(holds));
    }

    /// Makes a value a constant; what reads it stays as long as somebody else needs that.
    fn replace(&mut self, node: Node, number: u64) {
        let what = self.what(node);
        self.nodes[node.number() as usize] = Definition::Constant(number);
        if let Definition::Read(access) = what {
            self.reads[access] = self.add(what);
        }
    }

    /// What slots get here, where another version of the iterations does the same with all slots; `None` if it does not.
    fn ends_as_in(&mut self, whole: &Self) -> Option<BTreeMap<Slot, Node>> {
        let mut ends = BTreeMap::new();
        let own = self.carried(Level::Outer);
        let others = whole.carried(Level::Outer);
        if own.len() != others.len() {
            return None;
        }
        for ((slot, end, carried), (other, _, whole)) in own.into_iter().zip(others) {
            let is_same = slot == other && discriminant(&carried) == discriminant(&whole);
            let node = match (carried, whole) {
                (Recurrence::Affine(line), Recurrence::Affine(other)) if line == other => continue,
                (Recurrence::Sum { added, bits }, Recurrence::Sum { bits: other, .. }) if bits == other => added,
                // What is added is the same in all iterations.
                (Recurrence::Affine(line), Recurrence::Sum { bits, .. }) if line.bits == bits || line.is_same() => {
                    self.add(Definition::Constant(u64::from(line.step)))
                }
                (Recurrence::Chain | Recurrence::Nothing, _) if is_same => end,
                _ => return None,
            };
            ends.insert(slot, node);
        }
        Some(ends)
    }

    /// Leaves out what constants make superfluous.
    fn simplify(&mut self) {
        // Conditions that were made of two stand behind all others.
        for _ in 0..2 {
            self.fold_constants();
            self.shorten_choices();
        }
        self.forget_what_stays();
        self.forget_unread();
        self.lines.borrow_mut().clear();
        self.shapes.borrow_mut().clear();
    }

    fn fold_constants(&mut self) {
        for number in 0..self.nodes.len() {
            let Definition::Compute(op, mut args) = self.nodes[number] else { continue };
            let used = op.arity();
            args[..used].iter_mut().for_each(|arg| *arg = self.without_copies(*arg));
            let constants = args.map(|arg| self.constant(arg));
            let copy = |node: Node| Definition::Compute(Op::Copy, [node; 4]);
            let [first, second, ..] = constants;
            self.nodes[number] = match op {
                _ if constants[..used].iter().all(Option::is_some) => {
                    Definition::Constant(op.eval(constants.map(|constant| constant.unwrap_or(0))))
                }
                Op::Select if let Some(condition) = first => copy(if condition & 1 != 0 { args[1] } else { args[2] }),
                Op::Select if args[1] == args[2] => copy(args[1]),
                Op::Gate if let Some(condition) = second => {
                    if condition & 1 != 0 {
                        copy(args[0])
                    } else {
                        Definition::Constant(0)
                    }
                }
                Op::AddU32 | Op::SubU32 if second == Some(0) && self.is_32_bits(args[0]) => copy(args[0]),
                Op::AddU16 | Op::SubU16 if second == Some(0) && self.is_16_bits(args[0]) => copy(args[0]),
                _ => Definition::Compute(op, args),
            };
        }
    }

    /// What is written as it was read is not written, if nothing wrote there in between.
    fn forget_what_stays(&mut self) {
        let steps: Vec<usize> = self
            .outer
            .steps
            .iter()
            .filter_map(|step| match *step {
                Effect::Access(number) => Some(number),
                Effect::Copy(_) | Effect::Inner => None,
            })
            .collect();
        for (at, &number) in steps.iter().enumerate() {
            let access = &self.accesses[number];
            let Some(Definition::Read(read)) = access.value.map(|value| self.what(value)) else { continue };
            let Some(first) = steps[..at].iter().position(|&step| step == read) else { continue };
            let is_written = |&other: &usize| self.accesses[other].value.is_some() && self.accesses[other].may_meet(access);
            if self.accesses[read].is_same(access) && !steps[first..at].iter().any(is_written) {
                self.accesses[number].value = None;
            }
        }
    }
}

/// What is known where ways part.
#[derive(Clone)]
struct BranchState {
    outer: Scope,
    records: AccessGroups,
    opposites: FxHashMap<Value, Value>,
    in_words: FxHashMap<Value, Vec<Value>>,
}

impl<'k> Emitter<'_, '_, 'k> {
    /// Does vectorized iterations, with a shorter version of them where they all go the same way. What is handed on to the next ones.
    pub(super) fn iterations_alike(&mut self, alike: &'k UniformBranch, handed: &[LoopCarried], now: &[Value]) -> Vec<Value> {
        alike.first.iter().for_each(|&number| self.access(number, Level::Outer));
        let condition = self.value(alike.condition, Level::Outer);
        let mask = self.t.masks(&condition, self.lanes)[0];
        let moment = self.moment();
        let meeting = self.t.b.create_block();
        let whole = &self.plan.kernel;
        for side in &alike.sides {
            let [own, other] = [self.t.b.create_block(), self.t.b.create_block()];
            if side.holds {
                let all = self.t.b.ins().vall_true(mask);
                self.t.b.ins().brif(all, own, &[], other, &[]);
            } else {
                let any = self.t.b.ins().vany_true(mask);
                self.t.b.ins().brif(any, other, &[], own, &[]);
            }
            self.t.b.switch_to_block(own);
            self.t.b.seal_block(own);
            self.kernel = &side.kernel;
            self.records = side.kernel.records(self.lanes);
            // Accesses have other numbers here, and some values are known.
            self.outer.bytes.clear();
            self.outer.sources.clear();
            let is_read = |kernel: &Kernel, node: Node| matches!(kernel.what(node), Definition::Read(_));
            self.outer.values.retain(|&node, _| is_read(whole, node) && is_read(&side.kernel, node));
            self.steps_of_iteration(Level::Outer);
            self.meet(meeting, alike, Some(side), handed, now);
            self.kernel = whole;
            self.take_up(moment.clone());
            self.t.b.switch_to_block(other);
            self.t.b.seal_block(other);
        }
        self.steps_of_iteration(Level::Outer);
        self.meet(meeting, alike, None, handed, now);
        self.take_up(moment);
        self.t.b.switch_to_block(meeting);
        self.t.b.seal_block(meeting);
        let mut next = self.t.b.block_params(meeting).to_vec();
        let mut at = next.len();
        for &(_, node, shape) in alike.left.iter().rev() {
            at -= shape.vectors(self.lanes).1 as usize;
            self.outer.values.insert(node, shape.of(next.split_off(at)));
        }
        for (one, own) in handed.iter().zip(self.owned(handed, &next[1..])) {
            if let LoopCarried::Chain(slot, end, form) = *one {
                let value = match form {
                    Form::Bit => Val::Bit { value: own[0], clean: true },
                    Form::Quad => Val::Word(own[0]),
                    _ => self.t.know_bits(own[0], if self.kernel.is_word(slot) { 16 } else { 32 }),
                };
                self.in_lanes.insert((end, self.lanes - 1), value);
            }
        }
        next
    }

    /// How it is where ways part.
    fn moment(&self) -> BranchState {
        BranchState {
            outer: self.outer.clone(),
            records: self.records.clone(),
            opposites: self.t.opposites.clone(),
            in_words: self.t.in_words.clone(),
        }
    }

    /// Whether an access reads what was read to look where the iterations go.
    pub(super) fn was_read_first(&self, number: usize) -> bool {
        let is_read = self.kernel.accesses[number].value.is_none();
        self.alike.is_some() && is_read && self.outer.values.contains_key(&self.kernel.read_of(number))
    }

    /// Goes on as it was where the ways parted.
    fn take_up(&mut self, BranchState { outer, records, opposites, in_words }: BranchState) {
        (self.outer, self.records) = (outer, records);
        (self.t.opposites, self.t.in_words) = (opposites, in_words);
        self.written.clear();
        self.in_lanes.clear();
    }

    /// Goes where the ways meet, with what iterations hand on and leave.
    fn meet(&mut self, meeting: Block, alike: &UniformBranch, side: Option<&UniformSide>, handed: &[LoopCarried], now: &[Value]) {
        let end = |slot: Slot, node: Node| side.and_then(|side| side.ends.get(&slot)).copied().unwrap_or(node);
        let mut all = vec![self.t.b.ins().iadd_imm_s(now[0], -i64::from(self.lanes))];
        for (one, own) in handed.iter().zip(self.owned(handed, &now[1..])) {
            match *one {
                LoopCarried::Sum(slot, added, shape) => {
                    self.next_of(Level::Outer, &LoopCarried::Sum(slot, end(slot, added), shape), &own, &mut all);
                }
                LoopCarried::Chain(slot, node, form) => {
                    self.next_of(Level::Outer, &LoopCarried::Chain(slot, end(slot, node), form), &own, &mut all);
                }
                _ => self.next_of(Level::Outer, one, &own, &mut all),
            }
        }
        for &(slot, node, shape) in &alike.left {
            let value = self.value(end(slot, node), Level::Outer);
            match shape {
                Shape::Mask => all.extend(self.t.masks(&value, self.lanes)),
                shape => self.in_form(&value, Form::Lanes(shape), &mut all),
            }
        }
        self.go_where_ways_meet(meeting, &all);
    }

    /// Goes to a block with values, which take its parameters on each way there.
    fn go_where_ways_meet(&mut self, meeting: Block, values: &[Value]) {
        if self.t.b.block_params(meeting).is_empty() {
            for &value in values {
                let ty = self.t.b.func.dfg.value_type(value);
                self.t.b.append_block_param(meeting, ty);
            }
        }
        let arguments: Vec<BlockArg> = values.iter().map(|&value| BlockArg::Value(value)).collect();
        self.t.b.ins().jump(meeting, &arguments);
    }
}
