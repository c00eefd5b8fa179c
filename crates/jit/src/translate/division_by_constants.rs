//! Strength reduction of divisions by constants, to a multiplication and a shift: the quotient is the upper part of a product with a number
//! a little greater than the reciprocal. How much greater it may be depends on the range of the dividend, so that one of a small range has
//! a short factor.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};

use super::Translator;
use super::value::Val;
use crate::passes::Pass;

/// The upper part of a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Product {
    pub(super) factor: i64,
    pub(super) shift: u32,
    /// Whether the product has more than 32 bits.
    pub(super) wide: bool,
}

/// The same as the upper 32 bits of a product of two numbers of 32 bits, moved on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Upper {
    pub(super) factor: u32,
    pub(super) shift: u32,
}

/// The number a little greater than the reciprocal, times a power of two, if it is near enough for numbers up to `reach` of either sign.
fn factor(divisor: u32, reach: i128, shift: u32) -> Option<i128> {
    let divisor = i128::from(divisor);
    let factor = (1 << shift) / divisor + 1;
    // With a factor that is e / divisor greater than the exact one, a number n comes out n * e / divisor / 2^shift too great, which
    // must be less than one divisor-th.
    let more = factor * divisor - (1 << shift);
    (more * reach < 1 << shift).then_some(factor)
}

fn reach((least, most): (i64, i64)) -> i128 {
    i128::from(most.max(least.wrapping_neg()).max(1))
}

impl Product {
    /// What gives the quotients of all numbers in a range by a divisor of two or more, where those of negative numbers come out one too
    /// small; `None` if the products have more than 64 bits.
    pub(super) fn of(divisor: u32, range: (i64, i64)) -> Option<Self> {
        let reach = reach(range);
        let (shift, factor) = (0..63).find_map(|shift| Some((shift, factor(divisor, reach, shift)?)))?;
        let product = factor * reach;
        (product <= i128::from(i64::MAX)).then_some(Self {
            factor: factor as i64,
            shift,
            wide: shift > 31 || product > i128::from(i32::MAX),
        })
    }
}

impl Upper {
    /// What gives the quotients of all numbers in a range of at most 32 bits with a sign, on the same terms.
    pub(super) fn of(divisor: u32, range: (i64, i64)) -> Self {
        let reach = reach(range);
        // 31 bits more than the divisor has are enough, with which the factor has 32.
        let upper = (0..32).find_map(|shift| Some(Self { factor: u32::try_from(factor(divisor, reach, 32 + shift)?).ok()?, shift }));
        upper.unwrap_or_else(|| unreachable!("a divisor of 2 or more, and numbers of 32 bits"))
    }
}

/// How to see whether a number of 32 bits with sign is a multiple of another one: the product with the inverse of its odd part modulo 2^32
/// is the exact quotient then, and so one of the numbers around 0 that are as many as there are multiples; any other number has another
/// product.
#[derive(Clone, Copy, Debug)]
struct Multiples {
    inverse: u32,
    /// Added to the product, lets the least of them be 0.
    added: u32,
    /// Powers of two in the divisor, by which the sum is turned to the right.
    twos: u32,
    /// The greatest result.
    limit: u32,
}

impl Multiples {
    /// Those of a divisor of at most 31 bits that is no power of two.
    fn of(divisor: u32) -> Self {
        let twos = divisor.trailing_zeros();
        let odd = divisor >> twos;
        // Right in the lowest three bits, and in twice as many with each step.
        let inverse = (0..4).fold(odd, |inverse, _| inverse.wrapping_mul(2_u32.wrapping_sub(odd.wrapping_mul(inverse))));
        let added = (i32::MAX as u32 / odd) >> twos << twos;
        Self { inverse, added, twos, limit: (2 * added) >> twos }
    }
}

impl Translator<'_> {
    /// Notes that a value is 0 if a number of 32 bits with sign is a multiple of a divisor, and only then.
    pub(super) fn note_rest(&mut self, rest: Val, of: Value, divisor: u32) {
        if let Val::Int(rest) = rest
            && (2..=i32::MAX as u32).contains(&divisor)
            && self.options.does(Pass::DivisionByConstants)
        {
            self.rests.insert(rest, (of, divisor));
        }
    }

    /// Whether what remained of a division is 0, or is not, if that is seen without it.
    pub(super) fn compares_rest(&mut self, condition: IntCC, a: Val, b: Val) -> Option<Value> {
        let (IntCC::Equal | IntCC::NotEqual, Val::Int(rest), Val::Const(0)) = (condition, a, b) else { return None };
        let &(of, divisor) = self.rests.get(&rest)?;
        if divisor.is_power_of_two() {
            let rest = self.b.ins().band_imm_u(of, i64::from(divisor) - 1);
            return Some(self.b.ins().icmp_imm_u(condition, rest, 0));
        }
        let Multiples { inverse, added, twos, limit } = Multiples::of(divisor);
        let product = self.b.ins().imul_imm_u(of, i64::from(inverse));
        let sum = self.b.ins().iadd_imm_u(product, i64::from(added));
        let turned = match twos {
            0 => sum,
            _ => {
                let twos = self.constant(twos);
                self.b.ins().rotr(sum, twos)
            }
        };
        let condition = if condition == IntCC::Equal { IntCC::UnsignedLessThanOrEqual } else { IntCC::UnsignedGreaterThan };
        Some(self.b.ins().icmp_imm_u(condition, turned, i64::from(limit)))
    }

    /// The quotient of a number in 32 bits and a constant, cut towards 0, if it is known how to compute it without a division.
    pub(super) fn quotient_by(&mut self, a: Value, divisor: u32, range: (i64, i64)) -> Option<Value> {
        let quotient = self.multiplied(a, divisor, range)?;
        self.divided.insert(quotient);
        Some(quotient)
    }

    fn multiplied(&mut self, a: Value, divisor: u32, range: (i64, i64)) -> Option<Value> {
        let never_negative = range.0 >= 0;
        if !self.options.does(Pass::DivisionByConstants) || divisor < 2 || divisor > i32::MAX as u32 {
            return None;
        }
        if divisor.is_power_of_two() {
            return never_negative.then(|| self.b.ins().ushr_imm_u(a, i64::from(divisor.trailing_zeros())));
        }
        let Product { factor, shift, wide } = Product::of(divisor, range)?;
        let quotient = if wide {
            let a = if never_negative { self.b.ins().uextend(I64, a) } else { self.b.ins().sextend(I64, a) };
            let product = self.b.ins().imul_imm_s(a, factor);
            let quotient = self.b.ins().sshr_imm_u(product, i64::from(shift));
            self.b.ins().ireduce(I32, quotient)
        } else {
            let product = self.b.ins().imul_imm_s(a, factor);
            self.b.ins().sshr_imm_u(product, i64::from(shift))
        };
        if never_negative {
            return Some(quotient);
        }
        let negative = self.b.ins().ushr_imm_u(a, 31);
        Some(self.b.ins().iadd(quotient, negative))
    }

    /// What remains of a number in 32 bits, on the same terms.
    pub(super) fn rest_by(&mut self, a: Value, divisor: u32, range: (i64, i64)) -> Option<Value> {
        if self.options.does(Pass::DivisionByConstants) && divisor.is_power_of_two() && range.0 >= 0 {
            return Some(self.b.ins().band_imm_u(a, i64::from(divisor) - 1));
        }
        let quotient = self.quotient_by(a, divisor, range)?;
        let whole = self.b.ins().imul_imm_u(quotient, i64::from(divisor));
        let rest = self.b.ins().isub(a, whole);
        self.divided.insert(rest);
        Some(rest)
    }

    /// A number with sign in 32 bits, and the range in which it is known to be.
    pub(super) fn in_range(&mut self, bits: u32, value: Val) -> (Value, (i64, i64)) {
        let whole = self.int(value);
        let greatest = (1_i64 << (bits - 1)) - 1;
        match self.bounds.get(&whole) {
            Some(&(least, most)) if i64::from(most) <= greatest => (whole, (i64::from(least), i64::from(most))),
            _ => (self.signed(bits, value), (-greatest - 1, greatest)),
        }
    }
}

/// What a REAL may be multiplied with instead of being divided: the result is the same if both are powers of two.
pub(super) fn factor_f32(divisor: Val) -> Option<Val> {
    let bits = divisor.constant()? as u32;
    let exponent = bits >> 23 & 0xFF;
    let is_power = bits & 0x007F_FFFF == 0 && (1..=253).contains(&exponent);
    is_power.then(|| Val::Const(u64::from(bits & 1 << 31 | (254 - exponent) << 23)))
}

/// The same of LREALs.
pub(super) fn factor_f64(divisor: Val) -> Option<Val> {
    let bits = divisor.constant()?;
    let exponent = bits >> 52 & 0x7FF;
    let is_power = bits << 12 == 0 && (1..=2045).contains(&exponent);
    is_power.then(|| Val::Const(bits & 1 << 63 | (2046 - exponent) << 52))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of each range the numbers at its ends and around multiples of the divisor, where a quotient that is not exact shows.
    #[test]
    fn products_are_exact() {
        let ranges = [
            (0, 1),
            (0, 199),
            (-200, 200),
            (-32768, 32767),
            (0, 32767),
            (0, i64::from(i32::MAX)),
            (i64::from(i32::MIN), i64::from(i32::MAX)),
        ];
        let divisors =
            (3..2000).chain([9_999, 10_000, 32_767, 32_769, 65_535, 65_537, 1_000_000, 0x2AAA_AAAB, 0x4000_0001, 0x7FFF_FFFE, 0x7FFF_FFFF]);
        for divisor in divisors.filter(|divisor: &u32| !divisor.is_power_of_two()) {
            for (least, most) in ranges {
                let product = Product::of(divisor, (least, most)).expect("numbers of 32 bits");
                let upper = Upper::of(divisor, (least, most));
                let d = i64::from(divisor);
                let multiples = [least / d, least / d + 1, -1, 0, 1, most / d - 1, most / d, most / d / 2];
                let around = multiples.into_iter().flat_map(|times| (-2..=2).map(move |more| times * d + more));
                for number in around.chain([least, least + 1, most - 1, most]).filter(|number| (least..=most).contains(number)) {
                    let whole = number.checked_mul(product.factor).expect("64 bits");
                    assert!(product.wide || i32::try_from(whole).is_ok(), "{number} / {divisor}: {product:?}");
                    assert_eq!((whole >> product.shift) + i64::from(number < 0), number / d, "{number} / {divisor}: {product:?}");
                    let whole = ((i128::from(number) * i128::from(upper.factor)) >> 32) >> upper.shift;
                    assert_eq!(whole as i64 + i64::from(number < 0), number / d, "{number} / {divisor}: {upper:?}");
                }
            }
        }
    }

    #[test]
    fn multiples_are_seen() {
        let divisors = (3..2000).chain([9_999, 10_000, 65_535, 65_537, 0x2AAA_AAAB, 0x3000_0000, 0x6000_0000, 0x7FFF_FFFE, 0x7FFF_FFFF]);
        for divisor in divisors.filter(|divisor: &u32| !divisor.is_power_of_two()) {
            let Multiples { inverse, added, twos, limit } = Multiples::of(divisor);
            let (d, least, most) = (i64::from(divisor), i64::from(i32::MIN), i64::from(i32::MAX));
            let multiples = [least / d, least / d + 1, -2, -1, 0, 1, 2, most / d - 1, most / d, most / d / 2];
            let around = multiples.into_iter().flat_map(|times| (-33..=33).map(move |more| times * d + more));
            for number in around.chain([least, least + 1, most - 1, most]).filter(|number| (least..=most).contains(number)) {
                let is_multiple = (number as u32).wrapping_mul(inverse).wrapping_add(added).rotate_right(twos) <= limit;
                assert_eq!(is_multiple, number % d == 0, "{number}, {divisor}");
            }
        }
    }

    #[test]
    fn a_power_of_two_is_multiplied_instead_of_divided_by() {
        let dividends = [0, 1, 0x007F_FFFF, 0x0080_0000, 0x3F80_0001, 0x4049_0FDB, 0x7F7F_FFFF, 0x7F80_0000, 0x8000_0001, 0xFF7F_FFFF];
        for bits in (0..1 << 9).map(|upper| upper << 23).chain([0x4000_0001, 0x3DCC_CCCD]) {
            let Some(factor) = factor_f32(Val::Const(u64::from(bits))).and_then(Val::constant) else {
                let exponent = bits >> 23 & 0xFF;
                assert!(bits & 0x007F_FFFF != 0 || exponent == 0 || exponent >= 254, "{bits:#X}");
                continue;
            };
            for dividend in dividends.map(f32::from_bits) {
                let [divided, multiplied] = [dividend / f32::from_bits(bits), dividend * f32::from_bits(factor as u32)];
                assert_eq!(divided.to_bits(), multiplied.to_bits(), "{dividend} / {bits:#X}");
            }
        }
        for upper in 0..1_u64 << 12 {
            let Some(factor) = factor_f64(Val::Const(upper << 52)).and_then(Val::constant) else { continue };
            for dividend in dividends.map(|bits| f64::from(f32::from_bits(bits))) {
                let [divided, multiplied] = [dividend / f64::from_bits(upper << 52), dividend * f64::from_bits(factor)];
                assert_eq!(divided.to_bits(), multiplied.to_bits(), "{dividend} / {upper:#X}");
            }
        }
    }
}
