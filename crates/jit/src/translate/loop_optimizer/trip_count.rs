//! Trip-count analysis: how many iterations a loop makes.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::super::value::Val;
use super::kernel::{Definition, Kernel, Level, Node};
use super::scalar_evolution::Affine;

/// Iterations of an inner loop, which all iterations of the outer one make alike.
pub(super) const INNER_ITERATIONS_MAX: i64 = 1 << 20;

/// The condition under which another iteration follows: a value on a line, compared.
#[derive(Clone, Copy, Debug)]
pub(super) struct TripCount {
    /// What is compared, as it is at the end of an iteration.
    pub(super) counter: Node,
    /// With what; `None` = with 0, as a number without sign that goes down to it.
    pub(super) limit: Option<Node>,
    step: i64,
    bits: u32,
    /// Whether these are numbers with sign.
    signed: bool,
    /// Whether the limit itself is one more iteration.
    inclusive: bool,
    /// Whether nothing but the limit itself ends the loop: it has to lie where the counter goes.
    meets: bool,
}

/// How far a loop is.
#[derive(Clone, Copy)]
pub(super) enum Progress {
    /// So many iterations are left with the running one.
    Left(Value),
    /// An address that is so many bytes further in each iteration, and as it was in the first one.
    Address { now: Value, first: Value, step: i64 },
}

/// What decides about another iteration of a loop, if it can be counted.
pub(super) fn condition(kernel: &Kernel, level: Level) -> Option<TripCount> {
    let (op, [counter, limit, ..]) = kernel.compared(level)?;
    let Affine { step, bits } = kernel.line(counter, level)?;
    let (up, inclusive) = match op {
        Op::IsNonzero if bits == 16 && step == 0xFFFF => {
            return Some(TripCount { counter, limit: None, step: -1, bits, signed: false, inclusive: false, meets: false });
        }
        Op::Differ | Op::NeI16 | Op::NeI32 => (step >> (bits - 1) == 0, false),
        Op::LeI32 | Op::LeI16 | Op::LeU64 => (true, true),
        Op::LtI32 | Op::LtI16 | Op::Below => (true, false),
        Op::GeI32 | Op::GeI16 | Op::GeU64 => (false, true),
        Op::GtI32 | Op::GtI16 | Op::GtU64 => (false, false),
        _ => return None,
    };
    let signed = !is_unsigned(op);
    let meets = matches!(op, Op::Differ | Op::NeI16 | Op::NeI32);
    let fits = match op {
        Op::Differ if bits == 16 => kernel.is_16_bits(counter) && kernel.is_16_bits(limit),
        Op::Differ => kernel.is_32_bits(counter) && kernel.is_32_bits(limit),
        _ if !signed => kernel.is_32_bits(counter) && kernel.is_32_bits(limit),
        Op::LeI16 | Op::LtI16 | Op::GeI16 | Op::GtI16 | Op::NeI16 => bits == 16,
        _ => bits == 32,
    };
    if !fits || !kernel.line(limit, level)?.is_same() {
        return None;
    }
    let step = if bits == 16 { i64::from(step as u16 as i16) } else { i64::from(step as i32) };
    let steps_on = step != 0 && (step > 0) == up && (!meets || step.abs() == 1);
    steps_on.then_some(TripCount { counter, limit: Some(limit), step, bits, signed, inclusive, meets })
}

impl Kernel {
    /// The operation that decides about another iteration, and what it takes. That the counter does not leave its type with the next step
    /// is no part of it: this is looked at for all iterations that are counted.
    pub(super) fn compared(&self, level: Level) -> Option<(Op, [Node; 4])> {
        let Definition::Compute(op, args) = self.what(self.iteration(level).again) else { return None };
        if op != Op::AndNot {
            return Some((op, args));
        }
        let [comparison, leaves, ..] = args.map(|node| self.what(node));
        let Definition::Compute(op, compared) = comparison else { return None };
        self.leaves_its_type(level, leaves, (op, compared[0])).then_some((op, compared))
    }

    /// Whether a condition holds where the counter that is compared, as a number with or without sign, leaves its type with the step of the
    /// iteration.
    fn leaves_its_type(&self, level: Level, leaves: Definition, (compares, counter): (Op, Node)) -> bool {
        let (Definition::Compute(leaves, [start, step, ..]), Definition::Compute(counts, [own, own_step, ..])) =
            (leaves, self.what(counter))
        else {
            return false;
        };
        let (Definition::Start(of, slot), Some(by)) = (self.what(start), self.constant(step)) else { return false };
        if (start, step) != (own, own_step) || of != level || self.iteration(level).ends.get(&slot) != Some(&counter) {
            return false;
        }
        // A step is counted as a number with sign.
        let bits = if counts == Op::AddU16 || counts == Op::SubU16 { 16 } else { 32 };
        let (by, least) = (by & ((1 << bits) - 1), 1 << (bits - 1));
        match (counts, leaves, is_unsigned(compares)) {
            (Op::AddU16, Op::AddOverflowsI16, false) | (Op::AddU32, Op::AddOverflowsI32, false) => true,
            (Op::SubU16, Op::SubOverflowsI16, false) | (Op::SubU32, Op::SubOverflowsI32, false) => by != least,
            (Op::AddU16, Op::AddOverflowsU16, true) | (Op::AddU32, Op::AddOverflowsU32, true) => by < least,
            (Op::SubU16, Op::SubOverflowsU16, true) | (Op::SubU32, Op::SubOverflowsU32, true) => by < least,
            _ => false,
        }
    }
}

/// Whether an operation that may decide about another iteration compares numbers without sign.
pub(super) fn is_unsigned(op: Op) -> bool {
    matches!(op, Op::LeU64 | Op::Below | Op::GeU64 | Op::GtU64)
}

impl TripCount {
    /// How many iterations follow in all when these are the numbers of the first one.
    fn iterations(self, counter: i64, limit: i64) -> i64 {
        let Some(_) = self.limit else { return counter + 1 };
        let way = if self.step > 0 { limit - counter } else { counter - limit };
        let way = if self.inclusive { way } else { way - 1 };
        if way < 0 { 1 } else { way / self.step.abs() + 2 }
    }

    /// The greatest and the least number of its type.
    fn limits(self) -> (i64, i64) {
        match (self.signed, self.bits) {
            (true, 16) => (i64::from(i16::MIN), i64::from(i16::MAX)),
            (true, _) => (i64::from(i32::MIN), i64::from(i32::MAX)),
            (false, 16) => (0, i64::from(u16::MAX)),
            (false, _) => (0, i64::from(u32::MAX)),
        }
    }

    fn counted(self, counter: u64) -> i64 {
        match (self.signed, self.bits) {
            (true, 16) => i64::from(counter as u16 as i16),
            (true, _) => i64::from(counter as u32 as i32),
            (false, 16) => i64::from(counter as u16),
            (false, _) => i64::from(counter as u32),
        }
    }

    /// The limit, which may be beyond what the counter may become if it has no sign.
    fn limited(self, limit: u64) -> i64 {
        if self.signed { self.counted(limit) } else { i64::from(limit as u32) }
    }

    /// How many iterations a loop makes whose first counter and limit are constants.
    pub(super) fn constant(self, counter: u64, limit: u64) -> Option<i64> {
        let way = (self.limited(limit) - self.counted(counter)) * self.step;
        if self.meets && way < 0 {
            return None;
        }
        let iterations = self.iterations(self.counted(counter), self.limited(limit));
        let last = self.counted(counter) + (iterations - 1) * self.step;
        let (least, most) = self.limits();
        // Nor may the first step overflow: what the counter held before lies on the line, too.
        let first = self.counted(counter) - self.step;
        let inside = self.limit.is_none() || (least..=most).contains(&last) && (least..=most).contains(&first);
        (inside && iterations <= INNER_ITERATIONS_MAX).then_some(iterations)
    }
}

impl Translator<'_> {
    /// How many iterations were made before the running one, of so many.
    pub(super) fn iterations_made(&mut self, progress: Progress, iterations: Value) -> Value {
        match progress {
            Progress::Left(left) => self.b.ins().isub(iterations, left),
            Progress::Address { now, first, step } => {
                let way = self.b.ins().isub(now, first);
                let step = self.b.ins().iconst(I64, step);
                self.b.ins().sdiv(way, step)
            }
        }
    }

    /// Of so many iterations, which take this weight each, those for which the budget lasts.
    pub(super) fn within_budget(&mut self, iterations: Value, weight: Val) -> Value {
        let variable = self.budget();
        let budget = self.b.use_var(variable);
        let possible = match weight {
            Val::Const(1) => budget,
            weight => {
                let none = self.b.ins().iconst(I64, 0);
                let budget = self.b.ins().smax(budget, none);
                match weight {
                    Val::Const(weight) => self.b.ins().udiv_imm_u(budget, weight as i64),
                    weight => {
                        let weight = self.word(weight);
                        self.b.ins().udiv(budget, weight)
                    }
                }
            }
        };
        self.b.ins().smin(iterations, possible)
    }

    /// How many iterations a loop makes, and whether the counter stays inside its type as long.
    pub(super) fn iterations(&mut self, count: TripCount, counter: Val, limit: Val) -> (Value, Option<Value>) {
        let counter = self.counted(count, counter);
        if count.limit.is_none() {
            return (self.b.ins().iadd_imm_s(counter, 1), None);
        }
        let limit = if count.signed {
            self.counted(count, limit)
        } else {
            let limit = self.int(limit);
            self.b.ins().uextend(I64, limit)
        };
        let whole = if count.step > 0 { self.b.ins().isub(limit, counter) } else { self.b.ins().isub(counter, limit) };
        let way = if count.inclusive { whole } else { self.b.ins().iadd_imm_s(whole, -1) };
        let steps = match count.step.unsigned_abs() {
            1 => way,
            step if step.is_power_of_two() => self.b.ins().ushr_imm_u(way, i64::from(step.trailing_zeros())),
            step => self.b.ins().udiv_imm_u(way, step as i64),
        };
        let steps = self.b.ins().iadd_imm_s(steps, 2);
        let none = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, way, 0);
        let one = self.b.ins().iconst(I64, 1);
        let iterations = self.b.ins().select(none, one, steps);
        let before = self.b.ins().iadd_imm_s(iterations, -1);
        let distance = self.b.ins().imul_imm_s(before, count.step);
        let last = self.b.ins().iadd(counter, distance);
        let (least, most) = count.limits();
        // Nor may the first step overflow: what the counter held before lies on the line, too.
        let before = self.b.ins().iadd_imm_s(counter, -count.step);
        let (low, high) = if count.step > 0 { (before, last) } else { (last, before) };
        let low = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, low, least);
        let high = self.b.ins().icmp_imm_s(IntCC::SignedLessThanOrEqual, high, most);
        let inside = self.b.ins().band(low, high);
        if !count.meets {
            return (iterations, Some(inside));
        }
        let ahead = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, whole, 0);
        (iterations, Some(self.b.ins().band(inside, ahead)))
    }

    fn counted(&mut self, count: TripCount, value: Val) -> Value {
        if count.signed {
            let value = if count.bits == 16 { self.i16(value) } else { self.int(value) };
            return self.b.ins().sextend(I64, value);
        }
        let value = self.int(value);
        let value = if count.bits == 16 { self.b.ins().band_imm_u(value, 0xFFFF) } else { value };
        self.b.ins().uextend(I64, value)
    }
}

#[cfg(test)]
mod tests {
    use super::super::kernel::Node;
    use super::*;

    /// Counts by doing.
    fn counted(count: TripCount, mut counter: i64, limit: i64) -> i64 {
        let mut iterations = 1;
        loop {
            let again = match (count.step > 0, count.inclusive) {
                (true, true) => counter <= limit,
                (true, false) => counter < limit,
                (false, true) => counter >= limit,
                (false, false) => counter > limit,
            };
            if !again {
                return iterations;
            }
            (iterations, counter) = (iterations + 1, counter + count.step);
        }
    }

    #[test]
    fn iterations_are_those_that_the_condition_makes() {
        for step in [-7, -2, -1, 1, 2, 3, 8] {
            for inclusive in [false, true] {
                let count = TripCount {
                    counter: Node::numbered(0),
                    limit: Some(Node::numbered(0)),
                    step,
                    bits: 32,
                    signed: true,
                    inclusive,
                    meets: false,
                };
                for counter in -20..20 {
                    for limit in -20..20 {
                        assert_eq!(count.iterations(counter, limit), counted(count, counter, limit), "{count:?} {counter} {limit}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_loop_that_nothing_but_its_limit_ends_is_counted_if_the_limit_lies_ahead() {
        for (bits, step) in [(16, -1), (16, 1), (32, -1), (32, 1)] {
            let (inclusive, meets) = (false, true);
            let node = Node::numbered(0);
            let count = TripCount { counter: node, limit: Some(node), step, bits, signed: true, inclusive, meets };
            for (counter, limit) in (-6..6).flat_map(|counter| (-6..6).map(move |limit| (counter, limit))) {
                let way = (limit - counter) * step;
                let iterations = (way >= 0).then_some(way + 1);
                assert_eq!(count.constant(counter as u64, limit as u64), iterations, "{count:?} {counter} {limit}");
            }
        }
    }
}
