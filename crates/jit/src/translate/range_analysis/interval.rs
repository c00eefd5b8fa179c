//! The interval domain: ranges of values, and what operations make of them.

use sieben_engine::ir::Op;
use sieben_engine::machine::CALLS_SHIFT;

use crate::translate::congruence::Congruence;
use crate::translate::memory::LOCAL_OF_CALLER;

/// What is known of a value: it is `x` modulo 2 to the power of its bits, for some `x` from `least` to `most`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::translate) struct Interval {
    pub(in crate::translate) least: i64,
    pub(in crate::translate) most: i64,
    /// So many of the lowest bits of `x` are 0.
    pub(in crate::translate) zeros: u32,
    /// 8, 16, 32 or 64; the bits of the value above these are 0.
    pub(in crate::translate) bits: u32,
    /// How far the `x` lie from one another, if they are more than one and fewer than all.
    pub(in crate::translate) spacing: Congruence,
}

/// Positions that lie no farther than this from one another are those of small numbers: what is known of their lowest bits is enough.
const SPACING_MIN: i64 = 8;

/// Beyond this nothing is worth knowing of a value of up to 32 bits.
const FAR: i128 = 1 << 40;

/// How far below 0 a constant counts as negative: a pointer is not.
const NEGATIVE_MAX: i64 = 1 << 20;

impl Interval {
    /// Any value of so many bits.
    pub(in crate::translate) fn any(bits: u32) -> Self {
        match bits {
            64 => Self { least: i64::MIN, most: i64::MAX, zeros: 0, bits, spacing: Congruence::ANY },
            _ => Self { least: 0, most: (1 << bits) - 1, zeros: 0, bits, spacing: Congruence::ANY },
        }
    }

    /// Positions of bytes up to one, counted in bits.
    pub(in crate::translate) fn bytes_up_to(last: u32) -> Self {
        Self { least: 0, most: 8 * i64::from(last), zeros: 3, ..Self::any(32) }
    }

    /// A constant.
    pub(in crate::translate) fn constant(value: u64) -> Self {
        match u32::try_from(value) {
            Ok(value) => Self { least: i64::from(value), most: i64::from(value), zeros: value.trailing_zeros(), ..Self::any(32) },
            Err(_) => Self { least: value as i64, most: value as i64, zeros: value.trailing_zeros().min(32), ..Self::any(64) },
        }
    }

    /// Whether nothing is known but the number of bits.
    pub(super) fn is_any(&self) -> bool {
        self.is_everywhere() && self.zeros == 0 && self.spacing == Congruence::ANY
    }

    /// Whether its numbers are as many as there are values of so many bits, wherever they begin.
    fn is_everywhere(&self) -> bool {
        let any = Self::any(self.bits);
        i128::from(self.most) - i128::from(self.least) >= i128::from(any.most) - i128::from(any.least)
    }

    /// The one value, if there is one.
    pub(in crate::translate) fn exact(&self) -> Option<u64> {
        let mask = if self.bits == 64 { u64::MAX } else { (1 << self.bits) - 1 };
        (self.least == self.most).then_some(self.least as u64 & mask)
    }

    /// Whether a pointer leads nowhere in the local data of the caller.
    pub(in crate::translate) fn leads_elsewhere(&self) -> bool {
        let (least, most) = self.unsigned(32);
        let nearest = i128::from(LOCAL_OF_CALLER);
        most >> CALLS_SHIFT < nearest || least >> CALLS_SHIFT > nearest | 0x1F
    }

    /// The same constant; one a little below 0 as such, since a counter that begins there goes on above 0.
    pub(super) fn near_zero(self) -> Self {
        if !matches!(self.bits, 16 | 32) {
            return self;
        }
        let size = 1_i64 << self.bits;
        let is_negative =
            self.least == self.most && self.least < size && size - self.least <= size >> 2 && size - self.least <= NEGATIVE_MAX;
        if is_negative { Self { least: self.least - size, most: self.most - size, ..self } } else { self }
    }

    /// The numbers of a range of which this was made, if they are still the same ones, and lie so far from one another.
    fn spaced_in(self, range: (i128, i128), spacing: Congruence) -> Self {
        if range == (self.least.into(), self.most.into()) { self.spaced(spacing) } else { self }
    }

    fn of((least, most): (i128, i128), zeros: u32, bits: u32) -> Self {
        let any = Self { zeros: zeros.min(32), ..Self::any(bits) };
        // Of the numbers that are the same value, those near 0: what is computed further does not get too far then.
        let iteration =
            if bits < 64 && (most < -(1 << (bits - 1)) || least >= 1 << bits) { least.div_euclid(1 << bits) << bits } else { 0 };
        let (least, most) = (least - iteration, most - iteration);
        if bits < 64 && (least < -FAR || most > FAR || most - least >= 1 << bits) {
            return any;
        }
        match (i64::try_from(least), i64::try_from(most)) {
            (Ok(least), Ok(most)) => Self { least, most, ..any },
            _ => any,
        }
    }

    /// How far its numbers lie from one another, also if there is one.
    fn distances(&self) -> Congruence {
        if self.least == self.most { Congruence::exactly(self.least) } else { self.spacing }
    }

    /// The same numbers, which are known to lie so far from one another.
    pub(super) fn spaced(self, spacing: Congruence) -> Self {
        let tells = self.least != self.most && !self.is_everywhere() && spacing.is_wider_than(SPACING_MIN);
        Self { spacing: if tells { spacing } else { Congruence::ANY }, ..self }
    }

    /// The distances between its lowest bits as numbers without sign.
    pub(in crate::translate) fn distances_unsigned(&self, bits: u32) -> Congruence {
        let ((least, most), (first, last)) = (self.modulo(bits), self.unsigned(bits));
        let moved = first - least;
        match i64::try_from(moved) {
            Ok(by) if self.bits >= bits && most + moved == last => self.distances().moved(by),
            _ => Congruence::ANY,
        }
    }

    /// A pointer to a data block without the number above it, which is the same for all.
    pub(super) fn without_number(self) -> Self {
        let low = |pointer: i64| i64::from(pointer as u32);
        let (least, most) = (low(self.least), low(self.most));
        Self { least, most, zeros: self.zeros, ..Self::any(32) }.spaced(self.distances().moved(least.wrapping_sub(self.least)))
    }

    /// A representative modulo 2 to the power of `bits`.
    fn modulo(&self, bits: u32) -> (i128, i128) {
        if self.bits >= bits { (i128::from(self.least), i128::from(self.most)) } else { self.unsigned(self.bits) }
    }

    /// The lowest bits as a number without sign.
    pub(in crate::translate) fn unsigned(&self, bits: u32) -> (i128, i128) {
        let (least, most) = self.modulo(bits);
        let size = 1_i128 << bits;
        let iteration = least.div_euclid(size);
        if most.div_euclid(size) == iteration { (least - iteration * size, most - iteration * size) } else { (0, size - 1) }
    }

    /// The lowest bits as a number with sign.
    pub(in crate::translate) fn signed(&self, bits: u32) -> (i128, i128) {
        let (least, most) = self.modulo(bits);
        let (size, half) = (1_i128 << bits, 1_i128 << (bits - 1));
        let iteration = (least + half).div_euclid(size);
        if (most + half).div_euclid(size) == iteration { (least - iteration * size, most - iteration * size) } else { (-half, half - 1) }
    }

    /// What is known where either of two values arrives.
    pub(super) fn joined(&self, other: &Self) -> Self {
        let zeros = self.zeros.min(other.zeros);
        if self.bits == other.bits {
            let range = (i128::from(self.least.min(other.least)), i128::from(self.most.max(other.most)));
            return Self::of(range, zeros, self.bits).spaced_in(range, self.distances().joined(other.distances()));
        }
        // The narrower one is a number without sign in the wider form.
        let bits = self.bits.max(other.bits);
        let ((a, b), (c, d)) = (self.modulo(bits), other.modulo(bits));
        Self::of((a.min(c), b.max(d)), zeros, bits)
    }

    /// Whether every value that this one allows is allowed by another one.
    pub(super) fn is_within(&self, other: &Self) -> bool {
        if self.bits > other.bits {
            return false;
        }
        let (least, most) = self.modulo(other.bits);
        let is_spaced = other.spacing == Congruence::ANY || self.bits == other.bits && self.distances().is_within(other.spacing);
        is_spaced
            && self.zeros >= other.zeros
            && (other.is_everywhere() || least >= i128::from(other.least) && most <= i128::from(other.most))
    }

    /// The same value, where it is known to lie in a range as a number with or without sign.
    pub(super) fn limited(&self, number: Number, (least, most): (i128, i128)) -> Self {
        let (own_least, own_most) = number.of(self);
        let range = (own_least.max(least), own_most.min(most));
        // What cannot be is not reached; then anything is right.
        if range.0 > range.1 || number.bits() < self.bits {
            return *self;
        }
        let limited = Self::of(range, self.zeros, self.bits);
        let is_part = limited.least >= self.least && limited.most <= self.most;
        let limited = if is_part { limited.spaced(self.spacing) } else { limited };
        if limited.most.saturating_sub(limited.least) <= self.most.saturating_sub(self.least) { limited } else { *self }
    }
}

/// How the bits of a value count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    Signed(u32),
    Unsigned(u32),
}

impl Number {
    pub(super) fn bits(self) -> u32 {
        match self {
            Self::Signed(bits) | Self::Unsigned(bits) => bits,
        }
    }

    pub(super) fn of(self, value: &Interval) -> (i128, i128) {
        match self {
            Self::Signed(bits) => value.signed(bits),
            Self::Unsigned(bits) => value.unsigned(bits),
        }
    }
}

/// How two values are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Relation {
    Less,
    LessEqual,
    Equal,
    Differ,
    GreaterEqual,
    Greater,
}

impl Relation {
    /// What holds if this does not.
    pub(super) fn inverted(self) -> Self {
        match self {
            Self::Less => Self::GreaterEqual,
            Self::LessEqual => Self::Greater,
            Self::Equal => Self::Differ,
            Self::Differ => Self::Equal,
            Self::GreaterEqual => Self::Less,
            Self::Greater => Self::LessEqual,
        }
    }

    /// The same, seen from the other value.
    pub(super) fn mirrored(self) -> Self {
        match self {
            Self::Less => Self::Greater,
            Self::LessEqual => Self::GreaterEqual,
            Self::GreaterEqual => Self::LessEqual,
            Self::Greater => Self::Less,
            same => same,
        }
    }

    /// What a value lies in that has this relation to one in a range.
    pub(super) fn limits(self, (least, most): (i128, i128)) -> (i128, i128) {
        match self {
            Self::Less => (i128::MIN, most - 1),
            Self::LessEqual => (i128::MIN, most),
            Self::Equal => (least, most),
            Self::Differ => (i128::MIN, i128::MAX),
            Self::GreaterEqual => (least, i128::MAX),
            Self::Greater => (least + 1, i128::MAX),
        }
    }

    /// Whether it holds for all values of two ranges.
    pub(super) fn always(self, (a_least, a_most): (i128, i128), (b_least, b_most): (i128, i128)) -> bool {
        match self {
            Self::Less => a_most < b_least,
            Self::LessEqual => a_most <= b_least,
            Self::Equal => a_least == a_most && b_least == b_most && a_least == b_least,
            Self::Differ => a_most < b_least || b_most < a_least,
            Self::GreaterEqual => a_least >= b_most,
            Self::Greater => a_least > b_most,
        }
    }
}

/// What a comparison compares, and how.
#[rustfmt::skip] // A table.
pub(super) fn comparison(op: Op) -> Option<(Number, Relation)> {
    use Number::{Signed, Unsigned};
    use Relation as R;
    Some(match op {
        Op::LtI8 => (Signed(8), R::Less),
        Op::LeI8 => (Signed(8), R::LessEqual),
        Op::GtI8 => (Signed(8), R::Greater),
        Op::GeI8 => (Signed(8), R::GreaterEqual),
        Op::LtI16 => (Signed(16), R::Less),
        Op::LeI16 => (Signed(16), R::LessEqual),
        Op::GtI16 => (Signed(16), R::Greater),
        Op::GeI16 => (Signed(16), R::GreaterEqual),
        Op::EqI16 => (Signed(16), R::Equal),
        Op::NeI16 => (Signed(16), R::Differ),
        Op::LtI32 => (Signed(32), R::Less),
        Op::LeI32 => (Signed(32), R::LessEqual),
        Op::GtI32 => (Signed(32), R::Greater),
        Op::GeI32 => (Signed(32), R::GreaterEqual),
        Op::EqI32 => (Signed(32), R::Equal),
        Op::NeI32 => (Signed(32), R::Differ),
        Op::LtI64 => (Signed(64), R::Less),
        Op::LeI64 => (Signed(64), R::LessEqual),
        Op::GtI64 => (Signed(64), R::Greater),
        Op::GeI64 => (Signed(64), R::GreaterEqual),
        Op::Below => (Unsigned(64), R::Less),
        Op::LeU64 => (Unsigned(64), R::LessEqual),
        Op::GtU64 => (Unsigned(64), R::Greater),
        Op::GeU64 => (Unsigned(64), R::GreaterEqual),
        Op::Equal => (Unsigned(64), R::Equal),
        Op::Differ => (Unsigned(64), R::Differ),
        _ => return None,
    })
}

/// An exact result.
type Compute = fn(i128, i128) -> i128;

/// The bits of an operation that adds, subtracts or multiplies modulo a power of two.
fn wrapping(op: Op) -> Option<(Compute, u32)> {
    let add: Compute = |a, b| a + b;
    let subtract: Compute = |a, b| a - b;
    let multiply: Compute = |a, b| a.saturating_mul(b);
    Some(match op {
        Op::AddU8 => (add, 8),
        Op::AddU16 => (add, 16),
        Op::AddU32 => (add, 32),
        Op::AddU64 => (add, 64),
        Op::SubU8 => (subtract, 8),
        Op::SubU16 => (subtract, 16),
        Op::SubU32 => (subtract, 32),
        Op::SubU64 => (subtract, 64),
        Op::MulU8 => (multiply, 8),
        Op::MulU16 => (multiply, 16),
        Op::MulU32 => (multiply, 32),
        Op::MulU64 => (multiply, 64),
        _ => return None,
    })
}

/// What an operation computes from values of which this is known.
pub(in crate::translate) fn result(op: Op, [a, b, c]: [Interval; 3]) -> Interval {
    if let Some((compute, bits)) = wrapping(op) {
        let (first, second) = (a.modulo(bits), b.modulo(bits));
        let spacing = sums(op, a, b).filter(|_| a.bits >= bits && b.bits >= bits).unwrap_or(Congruence::ANY);
        return computed(compute, first, second, zeros_of(op, a, b), bits).spaced_in(corners(compute, first, second), spacing);
    }
    if let Some((number, relation)) = comparison(op) {
        let ranges = (number.of(&a), number.of(&b));
        return match (relation.always(ranges.0, ranges.1), relation.inverted().always(ranges.0, ranges.1)) {
            (true, _) => Interval::constant(1),
            (_, true) => Interval::constant(0),
            _ => flag(),
        };
    }
    if let Some((compute, number)) = overflow(op) {
        let (least, most) = match number {
            Number::Signed(bits) => (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1),
            Number::Unsigned(bits) => (0, (1_i128 << bits) - 1),
        };
        let exact = corners(compute, number.of(&a), number.of(&b));
        return if exact.0 >= least && exact.1 <= most { Interval::constant(0) } else { flag() };
    }
    match op {
        Op::Not | Op::And | Op::AndNot | Op::Or | Op::Xor => logic(op, a, b),
        // The number of a data block above a pointer.
        Op::OrU64 if a.exact().is_some_and(|high| high as u32 == 0) && b.unsigned(64).1 <= i128::from(u32::MAX) => {
            computed(|a, b| a + b, a.unsigned(64), b.unsigned(64), b.zeros.min(32), 64)
        }
        Op::Copy => a,
        Op::OverflowsI16 => outside(a.signed(32), 16),
        Op::OverflowsI32 => outside(a.signed(64), 32),
        Op::Low8 => low(a, 8),
        Op::Low16 => low(a, 16),
        Op::Low32 => low(a, 32),
        Op::Extend16 => Interval::of(a.signed(16), a.zeros, 32),
        Op::ExtendI8I16 => Interval::of(a.signed(8), a.zeros, 16),
        Op::ExtendI8I32 => Interval::of(a.signed(8), a.zeros, 32),
        Op::ExtendI8I64 => Interval::of(a.signed(8), a.zeros, 64),
        Op::ExtendI16I64 => Interval::of(a.signed(16), a.zeros, 64),
        Op::ExtendI32I64 => Interval::of(a.signed(32), a.zeros, 64),
        Op::AddI16Wide => computed(|a, b| a + b, a.signed(16), b.signed(16), a.zeros.min(b.zeros), 32),
        Op::SubI16Wide => computed(|a, b| a - b, a.signed(16), b.signed(16), a.zeros.min(b.zeros), 32),
        Op::MulI16Wide => computed(|a, b| a * b, a.signed(16), b.signed(16), a.zeros + b.zeros, 32),
        Op::AddI32Wide => computed(|a, b| a + b, a.signed(32), b.signed(32), a.zeros.min(b.zeros), 64),
        Op::SubI32Wide => computed(|a, b| a - b, a.signed(32), b.signed(32), a.zeros.min(b.zeros), 64),
        Op::MulI32Wide => computed(|a, b| a * b, a.signed(32), b.signed(32), a.zeros + b.zeros, 64),
        Op::MergeLow16 if a.unsigned(32).1 <= 0xFFFF => Interval::of(b.unsigned(16), b.zeros.min(16), 32),
        Op::MergeLow8 if a.unsigned(32).1 <= 0xFF => Interval::of(b.unsigned(8), b.zeros.min(8), 32),
        Op::MergeLow16 => Interval { zeros: b.zeros.min(16), ..Interval::any(32) },
        Op::Decrement16 => computed(|a, b| a - b, a.modulo(16), (1, 1), 0, 16),
        Op::Shl32 | Op::Shr32 | Op::Sar32 | Op::Shr64 => shifted(op, a, b),
        Op::AndU32 | Op::AndU64 => masked(a, b),
        Op::MinI16 | Op::MaxI16 => extreme(op == Op::MaxI16, Number::Signed(16), a, b),
        Op::MinI32 | Op::MaxI32 => extreme(op == Op::MaxI32, Number::Signed(32), a, b),
        Op::MinI64 | Op::MaxI64 => extreme(op == Op::MaxI64, Number::Signed(64), a, b),
        Op::MinU64 | Op::MaxU64 => extreme(op == Op::MaxU64, Number::Unsigned(64), a, b),
        Op::RemI16 => rest(Number::Signed(16), a, b),
        Op::RemI32 => rest(Number::Signed(32), a, b),
        Op::RemI64 => rest(Number::Signed(64), a, b),
        Op::RemU64 => rest(Number::Unsigned(64), a, b),
        Op::RemI32Wide => Interval { bits: 64, ..rest(Number::Signed(32), a, b) },
        Op::DivI16 => quotient(Number::Signed(16), a, b),
        Op::DivI32 => quotient(Number::Signed(32), a, b),
        Op::DivU64 => quotient(Number::Unsigned(64), a, b),
        Op::Select => b.joined(&c),
        Op::Gate => a.joined(&Interval { bits: a.bits, ..Interval::constant(0) }),
        Op::PassOnPointer => {
            let (least, most) = a.unsigned(32);
            match (least >> CALLS_SHIFT, most >> CALLS_SHIFT) {
                (first, last) if first == last && first == i128::from(LOCAL_OF_CALLER) => {
                    computed(|a, b| a + b, (least, most), (1 << CALLS_SHIFT, 1 << CALLS_SHIFT), a.zeros, 32)
                }
                _ if a.leads_elsewhere() => low(a, 32),
                _ => Interval { zeros: a.zeros.min(CALLS_SHIFT), ..Interval::any(32) },
            }
        }
        Op::AddPointer => {
            let sum = computed(|a, b| a + b, a.unsigned(32), b.signed(16), a.zeros.min(b.zeros), 32);
            // The area stays, and the position overflows inside it.
            let page = |position: i64| position >> 24;
            let (low, high) = a.unsigned(32);
            if page(low as i64) == page(high as i64) && page(sum.least) == page(low as i64) && page(sum.most) == page(low as i64) {
                sum
            } else {
                Interval { zeros: sum.zeros.min(24), ..Interval::any(32) }
            }
        }
        _ => Interval::any(64),
    }
}

/// Whether a number is none with sign of so many bits.
fn outside((least, most): (i128, i128), bits: u32) -> Interval {
    let half = 1_i128 << (bits - 1);
    if least >= -half && most < half {
        Interval::constant(0)
    } else if most < -half || least >= half {
        Interval::constant(1)
    } else {
        flag()
    }
}

/// A bit.
fn flag() -> Interval {
    Interval { most: 1, ..Interval::any(32) }
}

/// How far results lie from one another: of sums, differences, and products with a constant.
fn sums(op: Op, a: Interval, b: Interval) -> Option<Congruence> {
    let constant = |it: Interval| (it.least == it.most).then_some(it.least);
    match op {
        Op::AddU32 => Some(a.distances().plus(b.distances())),
        Op::SubU32 => Some(a.distances().plus(b.distances().times(-1))),
        Op::MulU32 => match (constant(a), constant(b)) {
            (Some(a), _) => Some(b.distances().times(a)),
            (None, b) => Some(a.distances().times(b?)),
        },
        _ => None,
    }
}

fn zeros_of(op: Op, a: Interval, b: Interval) -> u32 {
    match op {
        Op::MulU8 | Op::MulU16 | Op::MulU32 | Op::MulU64 => a.zeros + b.zeros,
        _ => a.zeros.min(b.zeros),
    }
}

fn computed(compute: impl Fn(i128, i128) -> i128, a: (i128, i128), b: (i128, i128), zeros: u32, bits: u32) -> Interval {
    Interval::of(corners(compute, a, b), zeros.min(bits), bits)
}

/// The least and the greatest result. All operations are monotone in each argument, in one direction or the other.
fn corners(compute: impl Fn(i128, i128) -> i128, a: (i128, i128), b: (i128, i128)) -> (i128, i128) {
    let corners = [compute(a.0, b.0), compute(a.0, b.1), compute(a.1, b.0), compute(a.1, b.1)];
    (corners.into_iter().min().unwrap_or(0), corners.into_iter().max().unwrap_or(0))
}

/// Bits: known where both arguments are.
fn logic(op: Op, a: Interval, b: Interval) -> Interval {
    match (a.exact(), b.exact()) {
        (Some(a), Some(b)) => Interval::constant(op.eval([a, b, 0, 0])),
        (Some(a), None) if op == Op::Not => Interval::constant(op.eval([a, 0, 0, 0])),
        _ => flag(),
    }
}

/// What may overflow, and in which numbers.
fn overflow(op: Op) -> Option<(Compute, Number)> {
    use Number::{Signed, Unsigned};
    let add: Compute = |a, b| a + b;
    let subtract: Compute = |a, b| a - b;
    let multiply: Compute = |a, b| a.saturating_mul(b);
    Some(match op {
        Op::AddOverflowsI8 => (add, Signed(8)),
        Op::AddOverflowsI16 => (add, Signed(16)),
        Op::AddOverflowsI32 => (add, Signed(32)),
        Op::AddOverflowsU8 => (add, Unsigned(8)),
        Op::AddOverflowsU16 => (add, Unsigned(16)),
        Op::AddOverflowsU32 => (add, Unsigned(32)),
        Op::SubOverflowsI8 => (subtract, Signed(8)),
        Op::SubOverflowsI16 => (subtract, Signed(16)),
        Op::SubOverflowsI32 => (subtract, Signed(32)),
        Op::SubOverflowsU8 => (subtract, Unsigned(8)),
        Op::SubOverflowsU16 => (subtract, Unsigned(16)),
        Op::SubOverflowsU32 => (subtract, Unsigned(32)),
        Op::MulOverflowsI8 => (multiply, Signed(8)),
        Op::MulOverflowsI16 => (multiply, Signed(16)),
        Op::MulOverflowsI32 => (multiply, Signed(32)),
        Op::MulOverflowsU8 => (multiply, Unsigned(8)),
        Op::MulOverflowsU16 => (multiply, Unsigned(16)),
        Op::MulOverflowsU32 => (multiply, Unsigned(32)),
        Op::AddOverflowsI64 => (add, Signed(64)),
        Op::AddOverflowsU64 => (add, Unsigned(64)),
        Op::SubOverflowsI64 => (subtract, Signed(64)),
        Op::SubOverflowsU64 => (subtract, Unsigned(64)),
        Op::MulOverflowsI64 => (multiply, Signed(64)),
        Op::MulOverflowsU64 => (multiply, Unsigned(64)),
        _ => return None,
    })
}

fn low(a: Interval, bits: u32) -> Interval {
    if a.bits <= bits { a } else { Interval::of(a.modulo(bits), a.zeros.min(bits), bits).spaced_in(a.modulo(bits), a.spacing) }
}

fn shifted(op: Op, a: Interval, count: Interval) -> Interval {
    let bits = if op == Op::Shr64 { 64 } else { 32 };
    let Some(count) = count.exact().map(|count| count as u32 & 0xFF).filter(|&count| count < bits) else { return Interval::any(bits) };
    let right = |(least, most): (i128, i128)| Interval::of((least >> count, most >> count), a.zeros.saturating_sub(count), bits);
    match op {
        Op::Shl32 => {
            let (least, most) = a.modulo(32);
            let range = (least << count, most << count);
            let spacing = if a.bits >= 32 { a.distances().times(1 << count) } else { Congruence::ANY };
            Interval::of(range, a.zeros + count, 32).spaced_in(range, spacing)
        }
        Op::Shr32 => right(a.unsigned(32)),
        // Above a pointer there is the number of a data block.
        Op::Shr64 => right(a.unsigned(64)),
        _ => right(a.signed(32)),
    }
}

fn masked(a: Interval, b: Interval) -> Interval {
    let bits = a.bits.max(b.bits).max(32);
    // Lowest bits whose carry is the same for all numbers: the position in a pointer.
    for (pointer, mask) in [(a, b), (b, a)] {
        let (Some(mask), (least, most)) = (mask.exact().filter(|mask| (1..u64::from(u32::MAX)).contains(mask)), pointer.modulo(bits))
        else {
            continue;
        };
        let size = i128::from(mask) + 1;
        if mask & (mask + 1) == 0 && pointer.bits == bits && least.div_euclid(size) == most.div_euclid(size) {
            let away = least.div_euclid(size) * size;
            let range = (least - away, most - away);
            let spacing = i64::try_from(-away).map_or(Congruence::ANY, |by| pointer.distances().moved(by));
            return Interval::of(range, pointer.zeros, bits).spaced_in(range, spacing);
        }
    }
    let most = a.unsigned(64).1.min(b.unsigned(64).1);
    Interval::of((0, most), a.zeros.max(b.zeros), bits)
}

fn extreme(greater: bool, number: Number, a: Interval, b: Interval) -> Interval {
    let ((a_least, a_most), (b_least, b_most)) = (number.of(&a), number.of(&b));
    let range = if greater { (a_least.max(b_least), a_most.max(b_most)) } else { (a_least.min(b_least), a_most.min(b_most)) };
    Interval::of(range, a.zeros.min(b.zeros), number.bits())
}

fn rest(number: Number, a: Interval, b: Interval) -> Interval {
    let ((a_least, a_most), (b_least, b_most)) = (number.of(&a), number.of(&b));
    let below = b_most.max(-b_least) - 1;
    let range = (if a_least < 0 { a_least.max(-below) } else { 0 }, if a_most > 0 { a_most.min(below) } else { 0 });
    if below < 0 { Interval::constant(0) } else { Interval::of(range, 0, number.bits()) }
}

fn quotient(number: Number, a: Interval, b: Interval) -> Interval {
    let ((a_least, a_most), (b_least, b_most)) = (number.of(&a), number.of(&b));
    // With a positive divisor the quotient is no farther from 0 than what is divided.
    if b_least <= 0 {
        return Interval::any(number.bits());
    }
    let divide = |a: i128, by: i128| a / by;
    let range = if a_least >= 0 {
        (divide(a_least, b_most), divide(a_most, b_least))
    } else {
        (divide(a_least, b_least), divide(a_most.max(0), b_least))
    };
    Interval::of(range, 0, number.bits())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers that follow one another in no order.
    struct Dice(u64);

    impl Dice {
        fn roll(&mut self) -> u64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            self.0 >> 20 ^ self.0 << 30
        }

        /// A range, mostly a short one near a number where something overflows.
        fn interval(&mut self) -> Interval {
            const EDGES: [i64; 11] = [0, 1, 7, 31, 255, 0x7FFF, 0x8000, 0xFFFF, 0x7FFF_FFFF, 0xFFFF_FFFF, 0x3E80_8400_0040];
            let bits = [8, 16, 32, 64][(self.roll() % 4) as usize];
            let zeros = (self.roll() % 5).saturating_sub(1) as u32;
            let edge = EDGES[(self.roll() % 11) as usize] - (self.roll() % 6) as i64;
            let step = 1_i64 << zeros;
            let least = if self.roll().is_multiple_of(3) { -edge } else { edge } / step * step;
            let most = least + (self.roll() % 40) as i64 / step * step;
            let range = Interval { least, most, zeros, ..Interval::any(bits) };
            match self.roll() % 8 {
                0 => Interval::any(bits),
                1..4 => {
                    let step = step * [9, 12, 86][(self.roll() % 3) as usize];
                    let most = least + (self.roll() % 5) as i64 * step + (self.roll() % 3) as i64;
                    Interval { most, ..range }.spaced(Congruence::ANY.times(step).moved(least))
                }
                _ => range,
            }
        }

        /// A value of a range.
        fn value(&mut self, range: &Interval) -> u64 {
            let span = range.most.wrapping_sub(range.least) as u64;
            let step = (1_u64 << range.zeros).max(range.spacing.parts().0 as u64);
            let distance = if span == u64::MAX { self.roll() } else { self.roll() % (span + 1) } / step * step;
            let value = (range.least as u64).wrapping_add(distance);
            if range.bits == 64 { value } else { value & ((1 << range.bits) - 1) }
        }
    }

    fn allows(range: &Interval, value: u64) -> bool {
        if range.bits < 64 && value >> range.bits != 0 {
            return false;
        }
        let mask = if range.bits == 64 { u64::MAX } else { (1 << range.bits) - 1 };
        let distance = value.wrapping_sub(range.least as u64) & mask;
        let zeros = (1_u64 << range.zeros.min(range.bits - 1)) - 1;
        let number = range.least.wrapping_add(distance as i64);
        i128::from(distance) <= i128::from(range.most) - i128::from(range.least)
            && value & zeros == 0
            && Congruence::exactly(number).is_within(range.spacing)
    }

    #[test]
    fn the_number_above_a_pointer_is_no_part_of_its_sum() {
        let pointer = Interval::constant(0x3E80_8400_0020);
        let by = Interval { least: 0, most: 448, zeros: 5, ..Interval::any(32) };
        let sum = result(Op::AddU32, [pointer, by, by]);
        assert_eq!((sum.unsigned(32), sum.bits), ((0x8400_0020, 0x8400_0020 + 448), 32));
        // Nor does where the pointer leads change the number.
        let pointer = Interval { least: 0x3E80_8400_0020, most: 0x3E80_8400_4000, zeros: 5, ..Interval::any(64) };
        let bits = Interval::constant(32);
        assert_eq!(result(Op::Shr64, [pointer, bits, bits]).exact(), Some(0x3E80));
    }

    #[test]
    fn results_of_all_operations_lie_in_their_ranges() {
        let mut dice = Dice(7);
        let (mut told_something, mut told_distances) = (0, 0);
        for &op in Op::ALL {
            for _ in 0..4_000 {
                let ranges = [(); 3].map(|()| dice.interval());
                let values = ranges.map(|range| dice.value(&range));
                assert!(ranges.iter().zip(values).all(|(range, value)| allows(range, value)));
                let range = result(op, ranges);
                let value = op.eval([values[0], values[1], values[2], 0]);
                assert!(allows(&range, value), "{} {values:X?} = {value:X}: {ranges:X?} -> {range:X?}", op.name());
                told_something += usize::from(!range.is_any());
                told_distances += usize::from(range.spacing != Congruence::ANY);
            }
        }
        assert!(told_something > 100_000 && told_distances > 5_000, "{told_something} {told_distances}");
    }

    #[test]
    fn what_a_comparison_tells_is_true() {
        let mut dice = Dice(11);
        for (&op, (number, relation)) in Op::ALL.iter().filter_map(|op| Some((op, comparison(*op)?))) {
            for _ in 0..4_000 {
                let [a, b] = [dice.interval(), dice.interval()];
                let values = [dice.value(&a), dice.value(&b)];
                let holds = op.eval([values[0], values[1], 0, 0]) != 0;
                let relation = if holds { relation } else { relation.inverted() };
                let limited = a.limited(number, relation.limits(number.of(&b)));
                assert!(allows(&limited, values[0]), "{} {values:X?}: {a:X?} {b:X?} -> {limited:X?}", op.name());
                let limited = b.limited(number, relation.mirrored().limits(number.of(&a)));
                assert!(allows(&limited, values[1]), "{} {values:X?}: {a:X?} {b:X?} -> {limited:X?}", op.name());
            }
        }
    }

    #[test]
    fn ranges_of_all_values_are_the_same_wherever_they_begin() {
        let mut dice = Dice(17);
        for bits in [8, 16, 32] {
            let size = 1_i64 << bits;
            for _ in 0..2_000 {
                let (least, lacks) = ((dice.roll() % 400) as i64 - 200, (dice.roll() % 3) as i64);
                let range = Interval { least, most: least + size - 1 - lacks, ..Interval::any(bits) };
                // What it lacks lies just below where it begins.
                let is_all = (least - 4..least + 4).all(|value| allows(&range, (value & (size - 1)) as u64));
                assert_eq!(is_all, lacks == 0);
                assert_eq!((range.is_any(), Interval::any(bits).is_within(&range)), (is_all, is_all), "{range:X?}");
            }
        }
    }

    #[test]
    fn what_is_joined_or_within_allows_the_same_values() {
        let mut dice = Dice(13);
        for _ in 0..400_000 {
            let [a, b] = [dice.interval(), dice.interval()];
            let value = dice.value(&a);
            assert!(allows(&a.joined(&b), value), "{value:X}: {a:X?} {b:X?} {:X?}", a.joined(&b));
            assert!(!a.is_within(&b) || allows(&b, value), "{value:X}: {a:X?} {b:X?}");
            for bits in [8, 16, 32, 64] {
                let mask = u64::MAX >> (64 - bits);
                let low = i128::from(value & mask);
                let (least, most) = a.unsigned(bits);
                assert!((least..=most).contains(&low), "{value:X} {bits}: {a:X?}");
                let signed = i128::from((value << (64 - bits)) as i64 >> (64 - bits));
                let (least, most) = a.signed(bits);
                assert!((least..=most).contains(&signed), "{value:X} {bits}: {a:X?}");
            }
        }
    }
}
