//! The congruence domain: numbers with the same remainder modulo a stride, as positions of one field in the elements of an array. It proves
//! that two fields of a structure do not alias, whichever elements they belong to.

use std::ops::Range;

/// Numbers that leave the same rest when they are divided by a step. With the step 0 there is one, the rest; with 1 they are all numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Congruence {
    step: i64,
    rest: i64,
}

/// Steps beyond this are not worth knowing; one of them is a number of 32 bits.
const STEP_MAX: i64 = 1 << 31;

fn common(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl Congruence {
    /// All numbers.
    pub(super) const ANY: Self = Self { step: 1, rest: 0 };

    /// One number.
    pub(super) fn exactly(number: i64) -> Self {
        Self { step: 0, rest: number }
    }

    /// Numbers that leave a rest when they are divided by a step.
    fn of(step: i64, rest: i64) -> Self {
        match step {
            0 => Self::exactly(rest),
            _ if step > STEP_MAX => Self::ANY,
            _ => Self { step, rest: rest.rem_euclid(step) },
        }
    }

    /// How far they lie from one another, and the least of them that is not negative.
    pub(super) fn parts(self) -> (i64, i64) {
        (self.step, self.rest)
    }

    /// Whether they are more than so far from one another.
    pub(super) fn is_wider_than(self, step: i64) -> bool {
        self.step == 0 || self.step > step
    }

    /// What the numbers of both have in common.
    pub(super) fn joined(self, other: Self) -> Self {
        let Some(distance) = self.rest.checked_sub(other.rest) else { return Self::ANY };
        Self::of(common(common(self.step, other.step), distance.saturating_abs()), self.rest)
    }

    /// Sums of a number of each.
    pub(super) fn plus(self, other: Self) -> Self {
        self.rest.checked_add(other.rest).map_or(Self::ANY, |rest| Self::of(common(self.step, other.step), rest))
    }

    /// The same numbers, times a constant.
    pub(super) fn times(self, factor: i64) -> Self {
        match (self.step.checked_mul(factor.saturating_abs()), self.rest.checked_mul(factor)) {
            (Some(step), Some(rest)) => Self::of(step, rest),
            _ => Self::ANY,
        }
    }

    /// The same numbers, so much further.
    pub(super) fn moved(self, by: i64) -> Self {
        self.plus(Self::exactly(by))
    }

    /// The bytes in which positions of bits lie.
    pub(super) fn in_bytes(self) -> Self {
        if self.step % 8 == 0 { Self::of(self.step / 8, self.rest.div_euclid(8)) } else { Self::ANY }
    }

    /// Whether all of them are among those of another one.
    pub(super) fn is_within(self, other: Self) -> bool {
        match other.step {
            0 => self == other,
            step => self.step % step == 0 && self.rest.checked_sub(other.rest).is_some_and(|distance| distance % step == 0),
        }
    }

    /// Whether bytes that begin at one of them share none with others that begin at one of another one, wherever both are.
    pub(super) fn is_apart(self, bytes: i64, other: Self, others: i64) -> bool {
        let step = common(self.step, other.step);
        let Some(distance) = other.rest.checked_sub(self.rest) else { return false };
        step > 1 && {
            let behind = distance.rem_euclid(step);
            behind >= bytes && step - behind >= others
        }
    }
}

/// Bytes of some element of an array in the arena, the same ones of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct StridedBytes {
    /// Where they begin.
    pub(super) begin: Congruence,
    /// How many they are.
    pub(super) bytes: u32,
}

impl StridedBytes {
    /// The same bytes as some that begin where a spacing says.
    pub(super) fn of(begin: Congruence, bytes: &Range<i64>) -> Self {
        let count = u32::try_from(bytes.end - bytes.start).unwrap_or(u32::MAX);
        Self { begin: begin.moved(bytes.start), bytes: count }
    }

    /// Whether they share no bytes with others wherever both are.
    pub(super) fn is_apart(&self, other: &Self) -> bool {
        self.begin.is_apart(self.bytes.into(), other.begin, other.bytes.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Small spacings, and the first of their numbers on both sides of 0.
    fn all() -> Vec<(Congruence, Vec<i64>)> {
        let one = (-3..4).map(|number| (Congruence::exactly(number), vec![number]));
        let more = (1..8).flat_map(|step| {
            (0..step).map(move |rest| (Congruence::of(step, rest), (-9..9).map(|iteration| iteration * step + rest).collect()))
        });
        one.chain(more).collect()
    }

    fn has(spacing: Congruence, number: i64) -> bool {
        Congruence::exactly(number).is_within(spacing)
    }

    #[test]
    fn what_is_made_of_spacings_has_all_numbers() {
        for (a, numbers) in all() {
            assert!(numbers.iter().all(|&number| has(a, number)));
            for by in [-3, 0, 5] {
                assert!(numbers.iter().all(|&number| has(a.moved(by), number + by) && has(a.times(by), number * by)));
            }
            assert!(numbers.iter().all(|&number| has(a.times(8).moved(3).in_bytes(), number)));
            for (b, others) in all() {
                assert!(numbers.iter().all(|&number| has(a.joined(b), number)));
                assert!(others.iter().all(|&number| has(a.joined(b), number)));
                assert!(numbers.iter().all(|x| others.iter().all(|y| has(a.plus(b), x + y))));
                assert_eq!(a.is_within(b), numbers.iter().all(|&number| has(b, number)), "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn bytes_apart_share_none() {
        let mut apart = 0;
        for (a, numbers) in all() {
            for (b, others) in all() {
                for (bytes, more) in [(1, 1), (2, 1), (1, 3), (2, 2)] {
                    if a.is_apart(bytes, b, more) {
                        apart += 1;
                        assert!(numbers.iter().all(|x| others.iter().all(|y| x + bytes <= *y || y + more <= *x)), "{a:?} {b:?}");
                    }
                }
            }
        }
        assert!(apart > 100, "{apart}");
        // The third and the second word of structures of twelve bytes.
        let field = |first: i64| Congruence::of(12, first);
        assert!(field(4).is_apart(4, field(8), 4) && !field(4).is_apart(5, field(8), 4) && !field(8).is_apart(9, field(4), 4));
    }
}
