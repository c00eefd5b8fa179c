//! Conversion of whole numbers to STRINGs and back, eight characters in one register (SIMD within a register). Everything else is left to
//! runtime functions.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F32, F64, I8, I32, I64};
use cranelift_codegen::ir::{BlockArg, InstBuilder, MemFlagsData, Type, Value};
use sieben_engine::ir::TextAction;
use sieben_engine::numbers_in_texts::{NumberForm, NumberKind, Spelling};

use super::Translator;
use super::memory::{Address, data};
use super::strings::InBoundsString;
use crate::passes::Pass;

/// Characters that are worked on at once.
const CHARACTERS: u32 = 8;
/// The least number that has no room for a sign before its digits.
const MANY: i64 = 10_000_000;
/// Each byte 1.
const ONES: i64 = 0x0101_0101_0101_0101;
/// Each byte the character of the digit 0.
const ZEROS: i64 = ONES * b'0' as i64;

impl Translator<'_> {
    /// Writes the digits of a whole number; how many characters there are.
    pub(super) fn put_digits(&mut self, action: TextAction, to: &InBoundsString, number: Value) -> Option<Value> {
        if !self.options.passes.has(Pass::StringConversion) {
            return None;
        }
        let room = u32::from(to.room.characters_max);
        if to.most.is_some() || room < CHARACTERS {
            return None;
        }
        let magnitude = if action == TextAction::Unsigned { number } else { self.b.ins().iabs(number) };
        let [few, many, done] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(many);
        let result = self.b.append_block_param(done, I32);
        let is_few = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, magnitude, MANY);
        self.b.ins().brif(is_few, few, &[], many, &[]);
        self.go_on_in(many);
        let count = self.call_for_texts(action, to, to, number);
        self.b.ins().jump(done, &[BlockArg::Value(count)]);
        self.go_on_in(few);
        let digits = self.eight_digits(magnitude);
        // The zeros in front, but not the last digit; where there is a sign, one of them makes room for it.
        let last = self.b.ins().bor_imm_u(digits, 1 << 56);
        let zeros = self.b.ins().ctz(last);
        let zeros = self.b.ins().band_imm_u(zeros, 0x38);
        let [minus, plus] = [b'-', b'+'].map(|sign| i64::from(sign ^ b'0'));
        let (skipped, sign) = match action {
            TextAction::Unsigned => (zeros, None),
            TextAction::SignedAlways => {
                let negative = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, number, 0);
                let [minus, plus] = [minus, plus].map(|sign| self.b.ins().iconst(I64, sign));
                let sign = self.b.ins().select(negative, minus, plus);
                (self.b.ins().iadd_imm_s(zeros, -8), Some(sign))
            }
            _ => {
                let negative = self.b.ins().sshr_imm_u(number, 63);
                let byte = self.b.ins().band_imm_u(negative, 8);
                (self.b.ins().isub(zeros, byte), Some(self.b.ins().band_imm_u(negative, minus)))
            }
        };
        let ascii = self.b.ins().iconst(I64, ZEROS);
        let ascii = self.b.ins().bor(digits, ascii);
        let characters = self.b.ins().ushr(ascii, skipped);
        let characters = match sign {
            Some(sign) => self.b.ins().bxor(characters, sign),
            None => characters,
        };
        // What stands behind them stays.
        let Address { base, offset, .. } = to.address;
        let there = self.b.ins().load(I64, data(), base, offset + to.room.head() as i32);
        let all = self.b.ins().iconst(I64, -1);
        let written = self.b.ins().ushr(all, skipped);
        let behind = self.b.ins().band_not(there, written);
        let characters = self.b.ins().bor(characters, behind);
        self.b.ins().store(data(), characters, base, offset + to.room.head() as i32);
        let skipped = self.b.ins().ushr_imm_u(skipped, 3);
        let skipped = self.b.ins().ireduce(I32, skipped);
        let most = self.constant(CHARACTERS);
        let count = self.b.ins().isub(most, skipped);
        let room = self.constant(room);
        self.store_lengths(to, room, count);
        self.b.ins().jump(done, &[BlockArg::Value(count)]);
        self.go_on_in(done);
        Some(result)
    }

    /// The eight decimal digits of a number below [`MANY`], the highest one in the lowest byte: halves, quarters and digits are divided
    /// side by side, as products with reciprocals that are exact for numbers so small.
    fn eight_digits(&mut self, number: Value) -> Value {
        let upper = self.b.ins().imul_imm_u(number, 109_951_163);
        let upper = self.b.ins().ushr_imm_u(upper, 40);
        let halves = self.split(number, upper, 10_000, 32);
        let upper = self.b.ins().imul_imm_u(halves, 10_486);
        let upper = self.b.ins().ushr_imm_u(upper, 20);
        let upper = self.b.ins().band_imm_u(upper, 0x7F_0000_007F);
        let quarters = self.split(halves, upper, 100, 16);
        let upper = self.b.ins().imul_imm_u(quarters, 103);
        let upper = self.b.ins().ushr_imm_u(upper, 10);
        let upper = self.b.ins().band_imm_u(upper, 0x000F_000F_000F_000F);
        self.split(quarters, upper, 10, 8)
    }

    /// Quotients in the lower half of their places and what remains in the upper one, which begins at a bit.
    fn split(&mut self, numbers: Value, quotients: Value, divisor: i64, bits: i64) -> Value {
        let moved = self.b.ins().ishl_imm_u(numbers, bits);
        let taken = self.b.ins().imul_imm_u(quotients, (divisor << bits) - 1);
        self.b.ins().isub(moved, taken)
    }

    /// Writes the number that at most eight digits spell, or fewer with a sign and, where it becomes a REAL or an LREAL, a point; whether
    /// it is one of its type.
    pub(super) fn number_of_text(&mut self, to: &InBoundsString, from: &InBoundsString, word: u64) -> Option<Value> {
        if !self.options.passes.has(Pass::StringConversion) {
            return None;
        }
        let form = NumberForm::of(word);
        let (least, most) = form.kind.range();
        let [least, most] = [least, most].map(|limit| limit.clamp(i64::MIN.into(), i64::MAX.into()) as i64);
        let real = match form.kind {
            NumberKind::F32 if form.spelling == Spelling::S7 => return None,
            NumberKind::F32 => Some(F32),
            NumberKind::F64 => Some(F64),
            _ => None,
        };
        let fits = least <= 1 - MANY && most >= 10 * MANY;
        let is_limited = form.spelling == Spelling::S7 && !fits;
        // STRNG_I takes no longer texts.
        let longest = if is_limited { 6 } else { CHARACTERS };
        let [shorter, longer, done] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(longer);
        let result = self.b.append_block_param(done, I32);
        let count = self.text_length(from);
        let word = self.characters_at(from, 0..from.characters_there());
        let bytes = self.b.ins().uextend(I64, count);
        let first = self.b.ins().band_imm_u(word, 0xFF);
        let is_minus = self.b.ins().icmp_imm_u(IntCC::Equal, first, i64::from(b'-'));
        let is_plus = self.b.ins().icmp_imm_u(IntCC::Equal, first, i64::from(b'+'));
        let signed = self.b.ins().bor(is_minus, is_plus);
        // A sign is a digit 0 from here on. The last digit is in the highest byte, and below the first one there are more zeros.
        let zeros = self.b.ins().iconst(I64, ZEROS);
        let digits = self.b.ins().bxor(word, zeros);
        let lowest = self.b.ins().iconst(I64, 0xFF);
        let without = self.b.ins().band_not(digits, lowest);
        let digits = self.b.ins().select(signed, without, digits);
        let missing = self.b.ins().ishl_imm_u(bytes, 3);
        let missing = self.b.ins().ineg(missing);
        let digits = self.b.ins().ishl(digits, missing);
        let (digits, point) = match real {
            Some(_) => self.without_point(digits),
            None => (digits, None),
        };
        let more = self.b.ins().iconst(I64, ONES * (0x80 - 10));
        let more = self.b.ins().iadd(digits, more);
        let more = self.b.ins().bor(more, digits);
        let high = self.b.ins().iconst(I64, ONES << 7);
        let others = self.b.ins().band(more, high);
        let are_digits = self.b.ins().icmp_imm_u(IntCC::Equal, others, 0);
        let signed = self.b.ins().uextend(I32, signed);
        let mut least_count = self.b.ins().iadd_imm_u(signed, 1);
        if let Some((is_there, _)) = point {
            let is_there = self.b.ins().uextend(I32, is_there);
            least_count = self.b.ins().iadd(least_count, is_there);
        }
        let above = self.b.ins().isub(count, least_count);
        let most_above = self.constant(longest);
        let most_above = self.b.ins().isub(most_above, least_count);
        let has_length = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, above, most_above);
        let magnitude = self.number_of_eight(digits);
        let negated = self.b.ins().ineg(magnitude);
        let number = self.b.ins().select(is_minus, negated, magnitude);
        let good = if fits {
            self.constant(1)
        } else {
            let above = self.b.ins().iadd_imm_s(number, least.wrapping_neg());
            let good = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, above, most.wrapping_sub(least));
            self.b.ins().uextend(I32, good)
        };
        let mut is_short = self.b.ins().band(are_digits, has_length);
        if is_limited {
            // It becomes the limit that is nearest.
            let good = self.b.ins().ireduce(I8, good);
            is_short = self.b.ins().band(is_short, good);
        }
        self.b.ins().brif(is_short, shorter, &[], longer, &[]);
        self.go_on_in(longer);
        let piece = self.b.ins().iconst(I64, form.word() as i64);
        let answer = self.call_for_texts(TextAction::Number, to, from, piece);
        self.b.ins().jump(done, &[BlockArg::Value(answer)]);
        self.go_on_in(shorter);
        let number = match (real, point) {
            (Some(ty), Some((_, unit))) => self.real_of((magnitude, is_minus), unit, ty),
            _ => number,
        };
        let number = self.b.ins().ishl_imm_u(number, i64::from(64 - form.kind.bits()));
        let number = self.b.ins().bswap(number);
        self.b.ins().store(data(), number, to.address.base, to.address.offset);
        self.b.ins().jump(done, &[BlockArg::Value(good)]);
        self.go_on_in(done);
        Some(result)
    }

    /// Digits, the last one in the highest byte, without a point among them; whether there was one, and the digit 1 where the digit of the
    /// ones was.
    fn without_point(&mut self, digits: Value) -> (Value, Option<(Value, Value)>) {
        let points = self.b.ins().iconst(I64, ONES * i64::from(b'.' ^ b'0'));
        let others = self.b.ins().bxor(digits, points);
        // The lowest byte that is 0 gets its highest bit, and none below it.
        let ones = self.b.ins().iconst(I64, ONES);
        let less = self.b.ins().isub(others, ones);
        let less = self.b.ins().band_not(less, others);
        let high = self.b.ins().iconst(I64, ONES << 7);
        let found = self.b.ins().band(less, high);
        let is_there = self.b.ins().icmp_imm_u(IntCC::NotEqual, found, 0);
        let at = self.b.ins().ctz(found);
        let at = self.b.ins().band_imm_u(at, 0x38);
        let all = self.b.ins().iconst(I64, -1);
        let from_there = self.b.ins().ishl(all, at);
        let behind = self.b.ins().ishl_imm_u(from_there, 8);
        let behind = self.b.ins().band(digits, behind);
        let before = self.b.ins().band_not(digits, from_there);
        let before = self.b.ins().ishl_imm_u(before, 8);
        let without = self.b.ins().bor(before, behind);
        let last = self.b.ins().iconst(I64, 56);
        let at = self.b.ins().select(is_there, at, last);
        let one = self.b.ins().iconst(I64, 1);
        let unit = self.b.ins().ishl(one, at);
        (self.b.ins().select(is_there, without, digits), Some((is_there, unit)))
    }

    /// The bits of a number with digits behind the one that is marked. Both sides of the division are exact, as a REAL too where there is a
    /// point, so that the quotient is the nearest one; without digits behind it, the conversion is.
    fn real_of(&mut self, (magnitude, is_minus): (Value, Value), unit: Value, ty: Type) -> Value {
        let unit = self.number_of_eight(unit);
        let [magnitude, unit] = [magnitude, unit].map(|number| self.b.ins().fcvt_from_sint(ty, number));
        let number = self.b.ins().fdiv(magnitude, unit);
        let zero = if ty == F32 { self.b.ins().f32const(0.0) } else { self.b.ins().f64const(0.0) };
        // So -0 is 0.
        let negated = self.b.ins().fsub(zero, number);
        let number = self.b.ins().select(is_minus, negated, number);
        if ty == F64 {
            return self.b.ins().bitcast(I64, MemFlagsData::new(), number);
        }
        let bits = self.b.ins().bitcast(I32, MemFlagsData::new(), number);
        self.b.ins().uextend(I64, bits)
    }

    /// The number of which the digits are bytes, the highest one in the lowest byte: digits, pairs and fours are put together side by side.
    fn number_of_eight(&mut self, digits: Value) -> Value {
        let pairs = self.b.ins().imul_imm_u(digits, 10 << 8 | 1);
        let pairs = self.b.ins().ushr_imm_u(pairs, 8);
        let pairs = self.b.ins().band_imm_u(pairs, 0x00FF_00FF_00FF_00FF);
        let fours = self.b.ins().imul_imm_u(pairs, 100 << 16 | 1);
        let fours = self.b.ins().ushr_imm_u(fours, 16);
        let fours = self.b.ins().band_imm_u(fours, 0x0000_FFFF_0000_FFFF);
        let all = self.b.ins().imul_imm_u(fours, 10_000 << 32 | 1);
        self.b.ins().ushr_imm_u(all, 32)
    }
}
