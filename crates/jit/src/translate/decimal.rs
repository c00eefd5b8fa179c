//! Instruction selection for BCD numbers: a part of the list of `instruction_selection.rs`, under the same comparison.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I32;
use cranelift_codegen::ir::{InstBuilder, Value};
use sieben_engine::ir::Op;

use super::{Translator, value::Val};

/// Decimal digits of a number with its sign in the highest digit.
#[derive(Clone, Copy)]
struct Digits {
    count: u32,
    /// The bit of the sign.
    sign: u32,
}

const WORD: Digits = Digits { count: 3, sign: 0x8000 };
const DOUBLE_WORD: Digits = Digits { count: 7, sign: 0x8000_0000 };

impl Digits {
    /// The digits without that of the sign.
    fn mask(self) -> i64 {
        (1 << (4 * self.count)) - 1
    }

    /// The greatest number.
    fn most(self) -> i64 {
        10_i64.pow(self.count) - 1
    }
}

impl Translator<'_> {
    /// The operation as machine code, if it has such a form.
    pub(super) fn inline_decimal(&mut self, op: Op, a: Val) -> Option<Val> {
        Some(match op {
            Op::IsBcd16 => self.is_decimal(WORD, a),
            Op::IsBcd32 => self.is_decimal(DOUBLE_WORD, a),
            Op::BcdToI16 => {
                let number = self.number_of_digits(WORD, a);
                Val::Int(self.b.ins().band_imm_u(number, 0xFFFF))
            }
            Op::BcdToI32 => Val::Int(self.number_of_digits(DOUBLE_WORD, a)),
            Op::OverflowsBcd16 => {
                let a = self.i16(a);
                self.exceeds(WORD, a)
            }
            Op::OverflowsBcd32 => {
                let a = self.int(a);
                self.exceeds(DOUBLE_WORD, a)
            }
            Op::I16ToBcd => {
                let a = self.i16(a);
                let number = self.digits_of_number(WORD, a);
                Val::Int(self.b.ins().band_imm_u(number, 0xFFFF))
            }
            _ => return None,
        })
    }

    /// Whether no digit is above 9: with 6 more, such a digit would carry into the next one.
    fn is_decimal(&mut self, digits: Digits, a: Val) -> Val {
        let a = self.int(a);
        let a = self.b.ins().band_imm_u(a, digits.mask());
        let sixes = 0x6666_6666 & digits.mask();
        let more = self.b.ins().iadd_imm_u(a, sixes);
        let carries = self.b.ins().bxor(more, a);
        let carries = self.b.ins().bxor_imm_u(carries, sixes);
        let carries = self.b.ins().band_imm_u(carries, 0x1111_1110 & (digits.mask() << 4));
        let none = self.b.ins().icmp_imm_u(IntCC::Equal, carries, 0);
        Val::Bit { value: self.b.ins().uextend(I32, none), clean: true }
    }

    fn number_of_digits(&mut self, digits: Digits, a: Val) -> Value {
        let a = self.int(a);
        let mut magnitude: Option<Value> = None;
        for digit in (0..digits.count).rev() {
            let one = self.b.ins().ushr_imm_u(a, i64::from(4 * digit));
            let one = self.b.ins().band_imm_u(one, 0xF);
            magnitude = Some(match magnitude {
                Some(before) => {
                    let tens = self.b.ins().imul_imm_u(before, 10);
                    self.b.ins().iadd(tens, one)
                }
                None => one,
            });
        }
        let magnitude = magnitude.unwrap_or(a);
        let negated = self.b.ins().ineg(magnitude);
        let sign = self.b.ins().band_imm_u(a, i64::from(digits.sign));
        self.b.ins().select(sign, negated, magnitude)
    }

    fn magnitude_of(&mut self, a: Value) -> (Value, Value) {
        let negative = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, a, 0);
        let negated = self.b.ins().ineg(a);
        (negative, self.b.ins().select(negative, negated, a))
    }

    fn exceeds(&mut self, digits: Digits, a: Value) -> Val {
        let (_, magnitude) = self.magnitude_of(a);
        let above = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, magnitude, digits.most());
        Val::Bit { value: self.b.ins().uextend(I32, above), clean: true }
    }

    /// A number as decimal digits; as it is if it has more.
    fn digits_of_number(&mut self, digits: Digits, a: Value) -> Value {
        let (negative, magnitude) = self.magnitude_of(a);
        let mut rest = magnitude;
        let mut number: Option<Value> = None;
        for digit in 0..digits.count {
            let tens = self.b.ins().udiv_imm_u(rest, 10);
            let taken = self.b.ins().imul_imm_u(tens, 10);
            let one = self.b.ins().isub(rest, taken);
            let one = self.b.ins().ishl_imm_u(one, i64::from(4 * digit));
            number = Some(number.map_or(one, |before| self.b.ins().bor(before, one)));
            rest = tens;
        }
        let number = number.unwrap_or(a);
        let sign = i64::from(0xF) << (4 * digits.count);
        let signed = self.b.ins().bor_imm_u(number, sign);
        let number = self.b.ins().select(negative, signed, number);
        let above = self.b.ins().icmp_imm_u(IntCC::UnsignedGreaterThan, magnitude, digits.most());
        self.b.ins().select(above, a, number)
    }
}
