//! Vectorized division of whole numbers by constants, four lanes at a time, as [`super::super::division_by_constants`] does it with one:
//! processors have no such instruction.

use cranelift_codegen::ir::types::I32X4;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::super::division_by_constants::{Product, Upper};
use super::vectorization::{Lanes, little};

/// The upper halves of the products in two vectors.
const UPPER_HALVES: [u8; 16] = [4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31];

/// The greatest number that an operation divides.
pub(super) fn greatest(op: Op) -> Option<u64> {
    match op {
        Op::DivI16 | Op::RemI16 => Some(i16::MAX as u64),
        Op::DivI32 | Op::RemI32 => Some(i32::MAX as u64),
        _ => None,
    }
}

impl Translator<'_> {
    /// Divides numbers of 16 or 32 bits that are known to be in a range.
    pub(super) fn divide_lanes(&mut self, op: Op, number: &Lanes, divisor: u32, range: (i64, i64), lanes: u32) -> Lanes {
        let is_short = matches!(op, Op::DivI16 | Op::RemI16);
        let words = match is_short {
            true => {
                let halves = self.halves(number, lanes);
                self.widened(&halves, true, lanes)
            }
            false => self.words(number, lanes),
        };
        let mut results = Vec::new();
        for word in words {
            let quotient = self.quotients(word, divisor, range);
            results.push(match op {
                Op::DivI16 | Op::DivI32 => quotient,
                _ => {
                    let divisor = self.all_words(divisor);
                    let whole = self.b.ins().imul(quotient, divisor);
                    self.b.ins().isub(word, whole)
                }
            });
        }
        match is_short {
            // What is cut off is the sign only.
            true => Lanes::Halves(results.chunks(2).map(|pair| self.b.ins().snarrow(pair[0], pair[pair.len() - 1])).collect()),
            false => Lanes::Words(results),
        }
    }

    fn quotients(&mut self, numbers: Value, divisor: u32, range: (i64, i64)) -> Value {
        if divisor == 1 {
            return numbers;
        }
        let never_negative = range.0 >= 0;
        if divisor.is_power_of_two() {
            let bits = i64::from(divisor.trailing_zeros());
            if never_negative {
                return self.b.ins().ushr_imm_u(numbers, bits);
            }
            // A quotient is cut towards 0.
            let sign = self.b.ins().sshr_imm_u(numbers, 31);
            let more = self.b.ins().ushr_imm_u(sign, 32 - bits);
            let sum = self.b.ins().iadd(numbers, more);
            return self.b.ins().sshr_imm_u(sum, bits);
        }
        let quotients = match Product::of(divisor, range) {
            Some(Product { factor, shift, wide: false }) => {
                let factor = self.all_words(factor as u32);
                let products = self.b.ins().imul(numbers, factor);
                self.b.ins().sshr_imm_u(products, i64::from(shift))
            }
            _ => {
                let Upper { factor, shift } = Upper::of(divisor, range);
                let is_long = i32::try_from(factor).is_err();
                let factor = self.all_words(factor);
                let [number, factor] = [numbers, factor].map(|of| match never_negative {
                    true => [self.b.ins().uwiden_low(of), self.b.ins().uwiden_high(of)],
                    false => [self.b.ins().swiden_low(of), self.b.ins().swiden_high(of)],
                });
                let [low, high] = [0, 1].map(|at: usize| self.b.ins().imul(number[at], factor[at]));
                let upper = self.shuffled(low, high, UPPER_HALVES);
                let upper = self.b.ins().bitcast(I32X4, little(), upper);
                // A factor with the highest bit was taken for a negative one.
                let upper = if is_long && !never_negative { self.b.ins().iadd(upper, numbers) } else { upper };
                self.b.ins().sshr_imm_u(upper, i64::from(shift))
            }
        };
        if never_negative {
            return quotients;
        }
        let negative = self.b.ins().ushr_imm_u(numbers, 31);
        self.b.ins().iadd(quotients, negative)
    }
}
