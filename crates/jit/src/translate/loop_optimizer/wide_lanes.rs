//! Vectorization with 64-bit lanes: LREAL, LINT, LWORD and their like, two in a vector.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::types::{F32X4, F64X2, I8X16, I32X4, I64X2};
use cranelift_codegen::ir::{ConstantData, Immediate, InstBuilder, Value};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::super::value::Val;
use super::scalar_evolution::Shape;
use super::vectorization::{Lanes, little};

/// The bytes of a vector made of the lower halves of two, of their upper halves, and of every second word of both.
const LOWER: [u8; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23];
const UPPER: [u8; 16] = [8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31];
const EVEN_WORDS: [u8; 16] = [0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27];

impl Translator<'_> {
    /// A vector of these bytes of two of them.
    pub(super) fn shuffled(&mut self, a: Value, b: Value, bytes: [u8; 16]) -> Value {
        let [a, b] = [a, b].map(|vector| self.b.ins().bitcast(I8X16, little(), vector));
        let mask: Immediate = self.b.func.dfg.immediates.push(ConstantData::from(bytes.to_vec()));
        self.b.ins().shuffle(a, b, mask)
    }

    fn as_quads(&mut self, vector: Value) -> Value {
        self.b.ins().bitcast(I64X2, little(), vector)
    }

    fn as_lreals(&mut self, vector: Value) -> Value {
        self.b.ins().bitcast(F64X2, little(), vector)
    }

    /// As numbers of 64 bits.
    pub(super) fn quads(&mut self, value: &Lanes, lanes: u32) -> Vec<Value> {
        let words = match value {
            Lanes::Wide(vectors) => return vectors.clone(),
            Lanes::Lreals(reals) => return reals.clone().into_iter().map(|real| self.quiet_lreals(real)).collect(),
            Lanes::One(one) => {
                let one = self.word(*one);
                let all = self.b.ins().splat(I64X2, one);
                return vec![all; (lanes / 2) as usize];
            }
            Lanes::Affine(_, line) if line.bits == 16 => {
                let low = self.constant_vector(I32X4, 0xFFFF_u32.to_le_bytes().repeat(4));
                let words = self.words(value, lanes);
                words.into_iter().map(|word| self.b.ins().band(word, low)).collect()
            }
            value => self.words(value, lanes),
        };
        words.into_iter().flat_map(|word| [self.b.ins().uwiden_low(word), self.b.ins().uwiden_high(word)]).collect()
    }

    /// As LREALs.
    pub(super) fn lreals(&mut self, value: &Lanes, lanes: u32) -> Vec<Value> {
        match value {
            Lanes::Lreals(vectors) => vectors.clone(),
            Lanes::One(one) => {
                let one = self.f64(*one);
                let all = self.b.ins().splat(F64X2, one);
                vec![all; (lanes / 2) as usize]
            }
            value => {
                let quads = self.quads(value, lanes);
                quads.into_iter().map(|quad| self.as_lreals(quad)).collect()
            }
        }
    }

    /// The bits of LREALs; what is no number becomes the one NaN that the project shows.
    pub(super) fn quiet_lreals(&mut self, real: Value) -> Value {
        let none = self.b.ins().fcmp(FloatCC::Unordered, real, real);
        let bits = self.as_quads(real);
        let nan = self.constant_vector(I64X2, f64::NAN.to_bits().to_le_bytes().repeat(2));
        self.b.ins().bitselect(none, nan, bits)
    }

    /// Masks of 64 bits as those of 32.
    pub(super) fn short_masks(&mut self, masks: &[Value]) -> Vec<Value> {
        let one = |pair: &[Value]| {
            let words = self.shuffled(pair[0], pair[1], EVEN_WORDS);
            self.b.ins().bitcast(I32X4, little(), words)
        };
        masks.chunks(2).map(one).collect()
    }

    fn long_masks(&mut self, value: &Lanes, lanes: u32) -> Vec<Value> {
        match value {
            Lanes::LongMask(vectors) => vectors.clone(),
            Lanes::One(bit) => {
                let flag = self.flag(*bit);
                let flag = self.word(Val::Int(flag));
                let all = self.b.ins().ineg(flag);
                let all = self.b.ins().splat(I64X2, all);
                vec![all; (lanes / 2) as usize]
            }
            value => {
                let masks = self.masks(value, lanes);
                masks.into_iter().flat_map(|mask| [self.b.ins().swiden_low(mask), self.b.ins().swiden_high(mask)]).collect()
            }
        }
    }

    /// The result of an operation with numbers of 64 bits in all lanes; `None` if it has none.
    pub(super) fn compute_quads(&mut self, op: Op, shape: Shape, args: &[Lanes], lanes: u32) -> Option<Lanes> {
        let is_wide = |value: &Lanes| match value {
            Lanes::Wide(_) | Lanes::Lreals(_) => true,
            Lanes::One(Val::Const(value)) => u32::try_from(*value).is_err(),
            Lanes::One(Val::Word(_) | Val::Lazy(_) | Val::Lreal { .. }) => true,
            _ => false,
        };
        let any_wide = args.iter().any(is_wide);
        let two_quads = |this: &mut Self| [0, 1].map(|at: usize| this.quads(&args[at], lanes));
        let two_lreals = |this: &mut Self| [0, 1].map(|at: usize| this.lreals(&args[at], lanes));
        let condition = match op {
            Op::EqF64 => Some(FloatCC::Equal),
            Op::DifferF64 => Some(FloatCC::NotEqual),
            Op::LtF64 => Some(FloatCC::LessThan),
            Op::LeF64 => Some(FloatCC::LessThanOrEqual),
            Op::GtF64 => Some(FloatCC::GreaterThan),
            Op::GeF64 => Some(FloatCC::GreaterThanOrEqual),
            _ => None,
        };
        if let Some(condition) = condition {
            let [a, b] = two_lreals(self);
            return Some(Lanes::LongMask(a.into_iter().zip(b).map(|(a, b)| self.b.ins().fcmp(condition, a, b)).collect()));
        }
        let condition = match op {
            Op::Equal if any_wide => Some(IntCC::Equal),
            Op::Differ if any_wide => Some(IntCC::NotEqual),
            Op::LtI64 => Some(IntCC::SignedLessThan),
            Op::LeI64 => Some(IntCC::SignedLessThanOrEqual),
            Op::GtI64 => Some(IntCC::SignedGreaterThan),
            Op::GeI64 => Some(IntCC::SignedGreaterThanOrEqual),
            _ => None,
        };
        if let Some(condition) = condition {
            let [a, b] = two_quads(self);
            return Some(Lanes::LongMask(a.into_iter().zip(b).map(|(a, b)| self.b.ins().icmp(condition, a, b)).collect()));
        }
        let long = |value: &Lanes| matches!(value, Lanes::LongMask(_) | Lanes::One(_));
        match op {
            Op::Not | Op::And | Op::AndNot | Op::Or | Op::Xor if args.iter().all(long) => {
                let a = self.long_masks(&args[0], lanes);
                if op == Op::Not {
                    return Some(Lanes::LongMask(a.into_iter().map(|mask| self.b.ins().bnot(mask)).collect()));
                }
                let b = self.long_masks(&args[1], lanes);
                let one = |(a, b)| match op {
                    Op::And => self.b.ins().band(a, b),
                    Op::AndNot => self.b.ins().band_not(a, b),
                    Op::Or => self.b.ins().bor(a, b),
                    _ => self.b.ins().bxor(a, b),
                };
                return Some(Lanes::LongMask(a.into_iter().zip(b).map(one).collect()));
            }
            Op::Select if shape == Shape::Wide => {
                let masks = self.long_masks(&args[0], lanes);
                let [a, b] = [1, 2].map(|at: usize| self.quads(&args[at], lanes));
                let both = a.into_iter().zip(b).zip(masks);
                return Some(Lanes::Wide(both.map(|((a, b), mask)| self.choice(mask, a, b)).collect()));
            }
            Op::Gate if shape == Shape::Wide => {
                let (values, masks) = (self.quads(&args[0], lanes), self.long_masks(&args[1], lanes));
                return Some(Lanes::Wide(values.into_iter().zip(masks).map(|(value, mask)| self.b.ins().band(value, mask)).collect()));
            }
            Op::F64ToF32 => {
                let lreals = self.lreals(&args[0], lanes);
                let one = |pair: &[Value]| {
                    let [a, b] = [pair[0], pair[1]].map(|lreal| self.b.ins().fvdemote(lreal));
                    let both = self.shuffled(a, b, LOWER);
                    self.b.ins().bitcast(F32X4, little(), both)
                };
                return Some(Lanes::Reals(lreals.chunks(2).map(one).collect()));
            }
            _ => {}
        }
        match shape {
            Shape::Wide => self.quads_of(op, args, lanes).map(Lanes::Wide),
            Shape::Lreals => self.lreals_of(op, args, lanes).map(Lanes::Lreals),
            _ => None,
        }
    }

    fn quads_of(&mut self, op: Op, args: &[Lanes], lanes: u32) -> Option<Vec<Value>> {
        if op == Op::ExtendI32I64 {
            let words = self.words(&args[0], lanes);
            return Some(words.into_iter().flat_map(|word| [self.b.ins().swiden_low(word), self.b.ins().swiden_high(word)]).collect());
        }
        let a = self.quads(&args[0], lanes);
        if let Op::NotU64 | Op::NegF64 | Op::AbsF64 = op {
            let sign = self.constant_vector(I64X2, (1_u64 << 63).to_le_bytes().repeat(2));
            let one = |quad| match op {
                Op::NotU64 => self.b.ins().bnot(quad),
                Op::NegF64 => self.b.ins().bxor(quad, sign),
                _ => self.b.ins().band_not(quad, sign),
            };
            return Some(a.into_iter().map(one).collect());
        }
        let b = self.quads(args.get(1)?, lanes);
        let both = a.into_iter().zip(b);
        Some(match op {
            Op::AddU64 => both.map(|(a, b)| self.b.ins().iadd(a, b)).collect(),
            Op::SubU64 => both.map(|(a, b)| self.b.ins().isub(a, b)).collect(),
            Op::MulU64 => both.map(|(a, b)| self.b.ins().imul(a, b)).collect(),
            Op::AndU64 => both.map(|(a, b)| self.b.ins().band(a, b)).collect(),
            Op::OrU64 => both.map(|(a, b)| self.b.ins().bor(a, b)).collect(),
            Op::XorU64 => both.map(|(a, b)| self.b.ins().bxor(a, b)).collect(),
            _ => return None,
        })
    }

    fn lreals_of(&mut self, op: Op, args: &[Lanes], lanes: u32) -> Option<Vec<Value>> {
        match op {
            Op::I32ToF64 => {
                let words = self.words(&args[0], lanes);
                let both = |word| {
                    let upper = self.shuffled(word, word, UPPER);
                    let upper = self.b.ins().bitcast(I32X4, little(), upper);
                    [word, upper].map(|word| {
                        let low = self.b.ins().swiden_low(word);
                        self.b.ins().fcvt_from_sint(F64X2, low)
                    })
                };
                return Some(words.into_iter().flat_map(both).collect());
            }
            Op::F32ToF64 => {
                let reals = self.reals(&args[0], lanes);
                let both = |real| {
                    let upper = self.shuffled(real, real, UPPER);
                    let upper = self.b.ins().bitcast(F32X4, little(), upper);
                    [real, upper].map(|real| self.b.ins().fvpromote_low(real))
                };
                return Some(reals.into_iter().flat_map(both).collect());
            }
            Op::SqrtF64 | Op::RoundF64 | Op::CeilF64 | Op::FloorF64 | Op::TruncF64 => {
                let a = self.lreals(&args[0], lanes);
                return Some(a.into_iter().map(|real| self.root_or_whole(op, real)).collect());
            }
            _ => {}
        }
        let [a, b] = [0, 1].map(|at: usize| self.lreals(&args[at], lanes));
        let is_number = args.iter().map(|arg| matches!(arg, Lanes::One(Val::Const(bits)) if !f64::from_bits(*bits).is_nan()));
        let is_number: Vec<bool> = is_number.collect();
        let both = a.into_iter().zip(b);
        Some(match op {
            Op::AddF64 => both.map(|(a, b)| self.b.ins().fadd(a, b)).collect(),
            Op::SubF64 => both.map(|(a, b)| self.b.ins().fsub(a, b)).collect(),
            Op::MulF64 => both.map(|(a, b)| self.b.ins().fmul(a, b)).collect(),
            Op::DivF64 => both.map(|(a, b)| self.b.ins().fdiv(a, b)).collect(),
            Op::MinF64 => both.map(|(a, b)| self.extreme_vector(FloatCC::LessThan, [a, b], (b, a), is_number[1])).collect(),
            Op::MaxF64 => both.map(|(a, b)| self.extreme_vector(FloatCC::GreaterThan, [b, a], (a, b), is_number[0])).collect(),
            _ => return None,
        })
    }

    /// The first of two reals where it is less or greater than the second one, the second one otherwise; where a third one is no number,
    /// a fourth one, unless it is known to be one.
    pub(super) fn extreme_vector(
        &mut self,
        condition: FloatCC,
        [a, b]: [Value; 2],
        (third, fourth): (Value, Value),
        is_number: bool,
    ) -> Value {
        let ty = self.b.func.dfg.value_type(a);
        let first = self.is_extreme(condition, [a, b]);
        let first = self.b.ins().bitcast(ty, little(), first);
        let extreme = self.b.ins().bitselect(first, a, b);
        if is_number {
            return extreme;
        }
        let none = self.b.ins().fcmp(FloatCC::Unordered, third, third);
        let none = self.b.ins().bitcast(ty, little(), none);
        self.b.ins().bitselect(none, fourth, extreme)
    }
}
