//! Vectorization: a value of each of several iterations in the lanes of 128-bit vectors.

use cranelift_codegen::ir::condcodes::{CondCode, FloatCC, IntCC};
use cranelift_codegen::ir::types::{F32, F32X4, F64, F64X2, I8X16, I16, I16X8, I32, I32X4, I64, I64X2};
use cranelift_codegen::ir::{ConstantData, Endianness, Immediate, InstBuilder, MemFlagsData, Type, Value};
use sieben_engine::ir::Op;

use super::super::Translator;
use super::super::division_by_constants::factor_f32;
use super::super::memory::data;
use super::super::value::Val;
use super::masks::{is_constant, takes_two};
use super::scalar_evolution::{Affine, Shape};

/// Bytes of a vector.
pub(super) const VECTOR_BYTES: u32 = 16;

/// A value of one iteration, or of several side by side.
#[derive(Clone, Debug)]
pub(super) enum Lanes {
    /// The same in all.
    One(Val),
    /// That of the first one; the others follow on a line.
    Affine(Val, Affine),
    /// Numbers of 16 bits.
    Halves(Vec<Value>),
    /// Numbers of 32 bits.
    Words(Vec<Value>),
    /// REALs. What is no number is written in its one form.
    Reals(Vec<Value>),
    /// Numbers of 64 bits.
    Wide(Vec<Value>),
    /// LREALs. What is no number is written in its one form.
    Lreals(Vec<Value>),
    /// Bits, each as 32 that are all like it.
    Mask(Vec<Value>),
    /// Bits, each as 64 that are all like it.
    LongMask(Vec<Value>),
}

impl Shape {
    /// Its vectors: their type, and how many there are for so many iterations.
    pub(super) fn vectors(self, lanes: u32) -> (Type, u32) {
        match self {
            // Four numbers have half of one.
            Self::Halves => (I16X8, lanes.div_ceil(8)),
            Self::Reals => (F32X4, lanes / 4),
            Self::Wide => (I64X2, lanes / 2),
            Self::Lreals => (F64X2, lanes / 2),
            Self::Words | Self::Mask | Self::Affine(_) => (I32X4, lanes / 4),
        }
    }

    /// Vectors in this form.
    pub(super) fn of(self, vectors: Vec<Value>) -> Lanes {
        match self {
            Self::Halves => Lanes::Halves(vectors),
            Self::Reals => Lanes::Reals(vectors),
            Self::Wide => Lanes::Wide(vectors),
            Self::Lreals => Lanes::Lreals(vectors),
            Self::Mask => Lanes::Mask(vectors),
            Self::Words | Self::Affine(_) => Lanes::Words(vectors),
        }
    }
}

/// The lanes of a vector that is seen as one of others are in the order of the processor.
pub(in super::super) fn little() -> MemFlagsData {
    MemFlagsData::new().with_endianness(Endianness::Little)
}

/// The bytes of a vector with those of each number of so many bytes turned around.
pub(in super::super) fn turned_order(bytes: u8) -> Vec<u8> {
    (0..VECTOR_BYTES as u8).map(|at| at / bytes * bytes + (bytes - 1 - at % bytes)).collect()
}

impl Translator<'_> {
    pub(super) fn constant_vector(&mut self, ty: Type, bytes: Vec<u8>) -> Value {
        let constant = self.b.func.dfg.constants.insert(ConstantData::from(bytes));
        self.b.ins().vconst(ty, constant)
    }

    /// The steps of the lanes of one vector.
    fn steps(&mut self, ty: Type, step: u32, number: u32) -> Value {
        let count = ty.lane_count();
        let bytes = (0..count).flat_map(|lane| {
            let value = step.wrapping_mul(number * count + lane);
            value.to_le_bytes().into_iter().take(ty.lane_type().bytes() as usize)
        });
        let bytes = bytes.collect();
        self.constant_vector(ty, bytes)
    }

    /// As numbers of 16 bits.
    pub(super) fn halves(&mut self, value: &Lanes, lanes: u32) -> Vec<Value> {
        let (first, line) = match value {
            Lanes::Halves(vectors) => return vectors.clone(),
            Lanes::Words(vectors) => return self.low_halves(vectors.clone()),
            Lanes::One(first) => (*first, Affine::SAME),
            Lanes::Affine(first, line) => (*first, *line),
            _ => unreachable!("the shapes were looked at"),
        };
        let first = self.int(first);
        let first = self.b.ins().ireduce(I16, first);
        let all = self.b.ins().splat(I16X8, first);
        self.along(all, I16X8, line, lanes)
    }

    /// The low halves of numbers of 32 bits.
    fn low_halves(&mut self, words: Vec<Value>) -> Vec<Value> {
        let low = self.constant_vector(I32X4, 0xFFFF_u32.to_le_bytes().repeat(4));
        let words: Vec<Value> = words.into_iter().map(|word| self.b.ins().band(word, low)).collect();
        words.chunks(2).map(|pair| self.b.ins().unarrow(pair[0], pair[pair.len() - 1])).collect()
    }

    /// As numbers of 32 bits.
    pub(super) fn words(&mut self, value: &Lanes, lanes: u32) -> Vec<Value> {
        let (first, line) = match value {
            Lanes::Words(vectors) => return vectors.clone(),
            Lanes::Halves(vectors) => return self.widened(&vectors.clone(), false, lanes),
            Lanes::One(first) => (*first, Affine::SAME),
            Lanes::Affine(first, line) => (*first, *line),
            // What is no number has one form as bits.
            Lanes::Reals(reals) => return reals.clone().into_iter().map(|real| self.quiet_vector(real)).collect(),
            Lanes::Mask(masks) => return masks.clone().into_iter().map(|mask| self.number_of_mask(mask)).collect(),
            Lanes::LongMask(masks) => {
                let masks = self.short_masks(masks);
                return masks.into_iter().map(|mask| self.b.ins().ushr_imm_u(mask, 31)).collect();
            }
            Lanes::Wide(_) | Lanes::Lreals(_) => unreachable!("the shapes were looked at"),
        };
        let first = self.int(first);
        let all = self.b.ins().splat(I32X4, first);
        self.along(all, I32X4, line, lanes)
    }

    /// As REALs.
    pub(super) fn reals(&mut self, value: &Lanes, lanes: u32) -> Vec<Value> {
        match value {
            Lanes::Reals(vectors) => vectors.clone(),
            Lanes::One(value) => {
                let real = self.f32(*value);
                let all = self.b.ins().splat(F32X4, real);
                vec![all; (lanes / 4) as usize]
            }
            value => {
                let words = self.words(value, lanes);
                words.into_iter().map(|word| self.b.ins().bitcast(F32X4, little(), word)).collect()
            }
        }
    }

    /// As masks.
    pub(super) fn masks(&mut self, value: &Lanes, lanes: u32) -> Vec<Value> {
        let bit = match value {
            Lanes::Mask(vectors) => return vectors.clone(),
            Lanes::LongMask(vectors) => return self.short_masks(vectors),
            Lanes::One(bit) => *bit,
            _ => unreachable!("the shapes were looked at"),
        };
        let flag = self.flag(bit);
        let all = self.b.ins().ineg(flag);
        let all = self.b.ins().splat(I32X4, all);
        vec![all; (lanes / 4) as usize]
    }

    fn along(&mut self, all: Value, ty: Type, line: Affine, lanes: u32) -> Vec<Value> {
        let count = lanes.div_ceil(ty.lane_count());
        if line.is_same() {
            return vec![all; count as usize];
        }
        let one = |number| {
            let steps = self.steps(ty, line.step, number);
            self.b.ins().iadd(all, steps)
        };
        (0..count).map(one).collect()
    }

    pub(super) fn widened(&mut self, halves: &[Value], signed: bool, lanes: u32) -> Vec<Value> {
        let mut words = Vec::new();
        for &half in halves {
            if let Some(known) = self.in_words.get(&half) {
                words.extend(known);
                continue;
            }
            let both = match signed {
                true => [self.b.ins().swiden_low(half), self.b.ins().swiden_high(half)],
                false => [self.b.ins().uwiden_low(half), self.b.ins().uwiden_high(half)],
            };
            words.extend(both);
        }
        words.truncate((lanes / 4) as usize);
        words
    }

    /// The result of an operation in all lanes.
    pub(super) fn compute_lanes(&mut self, op: Op, shape: Shape, args: &[Lanes], lanes: u32) -> Lanes {
        if let Some(result) = self.compute_quads(op, shape, args, lanes) {
            return result;
        }
        if let Some(vectors) = self.choose_lanes(op, shape, args, lanes) {
            return shape.of(vectors);
        }
        let is_number = |arg: &Lanes| matches!(arg, Lanes::One(Val::Const(bits)) if !f32::from_bits(*bits as u32).is_nan());
        let is_number: Vec<bool> = args.iter().map(is_number).collect();
        let pair = |this: &mut Self, of: &mut dyn FnMut(&mut Self, Value, Value) -> Value| -> Vec<Value> {
            let (a, b) = match shape {
                Shape::Halves => (this.halves(&args[0], lanes), this.halves(&args[1], lanes)),
                Shape::Reals => (this.reals(&args[0], lanes), this.reals(&args[1], lanes)),
                _ => (this.words(&args[0], lanes), this.words(&args[1], lanes)),
            };
            a.into_iter().zip(b).map(|(a, b)| of(this, a, b)).collect()
        };
        let vectors = match op {
            Op::AddU16 | Op::AddU32 => pair(self, &mut |this, a, b| this.b.ins().iadd(a, b)),
            Op::SubU16 | Op::SubU32 => pair(self, &mut |this, a, b| this.b.ins().isub(a, b)),
            Op::MulU16 | Op::MulU32 => pair(self, &mut |this, a, b| this.b.ins().imul(a, b)),
            Op::AndU32 => pair(self, &mut |this, a, b| this.b.ins().band(a, b)),
            Op::OrU32 => pair(self, &mut |this, a, b| this.b.ins().bor(a, b)),
            Op::XorU32 => pair(self, &mut |this, a, b| this.b.ins().bxor(a, b)),
            Op::AddF32 => pair(self, &mut |this, a, b| this.b.ins().fadd(a, b)),
            Op::SubF32 => pair(self, &mut |this, a, b| this.b.ins().fsub(a, b)),
            Op::MinI16 | Op::MinI32 => pair(self, &mut |this, a, b| this.b.ins().smin(a, b)),
            Op::MaxI16 | Op::MaxI32 => pair(self, &mut |this, a, b| this.b.ins().smax(a, b)),
            Op::MulF32 => pair(self, &mut |this, a, b| this.b.ins().fmul(a, b)),
            Op::DivF32
                if let Lanes::One(divisor) = args[1]
                    && let Some(factor) = factor_f32(divisor) =>
            {
                return self.compute_lanes(Op::MulF32, shape, &[args[0].clone(), Lanes::One(factor)], lanes);
            }
            Op::DivF32 => pair(self, &mut |this, a, b| this.b.ins().fdiv(a, b)),
            Op::Extend16 if matches!(args[0], Lanes::Affine(..)) => {
                let words = self.words(&args[0], lanes);
                let mut extended = Vec::new();
                for word in words {
                    let moved = self.b.ins().ishl_imm_u(word, 16);
                    extended.push(self.b.ins().sshr_imm_u(moved, 16));
                }
                extended
            }
            Op::Extend16 => {
                let halves = self.halves(&args[0], lanes);
                self.widened(&halves, true, lanes)
            }
            Op::AddI16Wide | Op::SubI16Wide | Op::MulI16Wide => {
                let [a, b] = [0, 1].map(|at: usize| {
                    let halves = self.halves(&args[at], lanes);
                    self.widened(&halves, true, lanes)
                });
                let both = a.into_iter().zip(b);
                let one = |(a, b)| match op {
                    Op::AddI16Wide => self.b.ins().iadd(a, b),
                    Op::SubI16Wide => self.b.ins().isub(a, b),
                    _ => self.b.ins().imul(a, b),
                };
                both.map(one).collect()
            }
            Op::Low16 if let Lanes::Halves(halves) = &args[0] => halves.clone(),
            Op::Low16 => {
                let words = self.words(&args[0], lanes);
                self.low_halves(words)
            }
            Op::I32ToF32 => {
                let words = self.words(&args[0], lanes);
                words.into_iter().map(|word| self.b.ins().fcvt_from_sint(F32X4, word)).collect()
            }
            Op::SqrtF32 | Op::RoundF32 | Op::CeilF32 | Op::FloorF32 | Op::TruncF32 => {
                let reals = self.reals(&args[0], lanes);
                reals.into_iter().map(|real| self.root_or_whole(op, real)).collect()
            }
            Op::MinF32 => pair(self, &mut |this, a, b| this.extreme_vector(FloatCC::LessThan, [a, b], (b, a), is_number[1])),
            Op::MaxF32 => pair(self, &mut |this, a, b| this.extreme_vector(FloatCC::GreaterThan, [b, a], (a, b), is_number[0])),
            Op::NegI32 => {
                let words = self.words(&args[0], lanes);
                words.into_iter().map(|word| self.b.ins().ineg(word)).collect()
            }
            Op::NegF32 | Op::AbsF32 => {
                let words = self.words(&args[0], lanes);
                let sign = self.constant_vector(I32X4, 0x8000_0000_u32.to_le_bytes().repeat(4));
                let one = |word| if op == Op::NegF32 { self.b.ins().bxor(word, sign) } else { self.b.ins().band_not(word, sign) };
                words.into_iter().map(one).collect()
            }
            Op::Shl32 | Op::Shr32 | Op::Sar32 => {
                let Lanes::One(Val::Const(number)) = args[1] else { unreachable!("the shapes were looked at") };
                if let (Op::Shl32, Lanes::Mask(masks), 1..32) = (op, &args[0], number & 0xFF) {
                    let own = self.constant_vector(I32X4, (1_u32 << (number & 0xFF)).to_le_bytes().repeat(4));
                    let masks = masks.clone();
                    return shape.of(masks.into_iter().map(|mask| self.b.ins().band(mask, own)).collect());
                }
                let words = self.words(&args[0], lanes);
                words.into_iter().map(|word| self.shifted(op, word, number)).collect()
            }
            _ => unreachable!("the shapes were looked at"),
        };
        shape.of(vectors)
    }

    /// The roots of some REALs or LREALs, or whole numbers near them.
    pub(super) fn root_or_whole(&mut self, op: Op, real: Value) -> Value {
        match op {
            Op::SqrtF32 | Op::SqrtF64 => self.b.ins().sqrt(real),
            Op::RoundF32 | Op::RoundF64 => self.b.ins().nearest(real),
            Op::CeilF32 | Op::CeilF64 => self.b.ins().ceil(real),
            Op::FloorF32 | Op::FloorF64 => self.b.ins().floor(real),
            _ => self.b.ins().trunc(real),
        }
    }

    /// REALs cut to numbers of 32 bits; the nearest limits outside their range, 0 for what is no number.
    pub(super) fn cut_lanes(&mut self, reals: &Lanes, lanes: u32) -> Lanes {
        let reals = self.reals(reals, lanes);
        Lanes::Words(reals.into_iter().map(|real| self.cut_vector(real)).collect())
    }

    fn cut_vector(&mut self, real: Value) -> Value {
        if cfg!(not(all(target_arch = "x86_64", not(feature = "aarch64")))) {
            return self.b.ins().fcvt_to_sint_sat(I32X4, real);
        }
        // What has no place in 32 bits becomes the least number: right for what is too small, the opposite of the greatest one, or 0.
        let cut = self.b.ins().x86_cvtt2dq(I32X4, real);
        let limit = self.constant_vector(F32X4, 2_147_483_648_f32.to_le_bytes().repeat(4));
        let is_great = self.b.ins().fcmp(FloatCC::GreaterThanOrEqual, real, limit);
        let is_number = self.b.ins().fcmp(FloatCC::Ordered, real, real);
        let limited = self.b.ins().bxor(cut, is_great);
        self.b.ins().band(limited, is_number)
    }

    /// Numbers of 32 bits shifted.
    fn shifted(&mut self, op: Op, word: Value, number: u64) -> Value {
        let count = i64::from(number as u32 & 0xFF);
        match op {
            _ if count == 0 => word,
            Op::Shl32 => self.b.ins().ishl_imm_u(word, count),
            Op::Shr32 => self.b.ins().ushr_imm_u(word, count),
            _ => self.b.ins().sshr_imm_u(word, count),
        }
    }

    /// Comparisons, what is made of them, and choices.
    fn choose_lanes(&mut self, op: Op, shape: Shape, args: &[Lanes], lanes: u32) -> Option<Vec<Value>> {
        use FloatCC as F;
        use IntCC as I;
        let (words, halves, reals) = match op {
            Op::EqI32 | Op::Equal => (Some(I::Equal), None, None),
            Op::NeI32 | Op::Differ => (Some(I::NotEqual), None, None),
            Op::LtI32 => (Some(I::SignedLessThan), None, None),
            Op::LeI32 => (Some(I::SignedLessThanOrEqual), None, None),
            Op::GtI32 => (Some(I::SignedGreaterThan), None, None),
            Op::GeI32 => (Some(I::SignedGreaterThanOrEqual), None, None),
            Op::Below => (Some(I::UnsignedLessThan), None, None),
            Op::LeU64 => (Some(I::UnsignedLessThanOrEqual), None, None),
            Op::GtU64 => (Some(I::UnsignedGreaterThan), None, None),
            Op::GeU64 => (Some(I::UnsignedGreaterThanOrEqual), None, None),
            Op::EqI16 => (None, Some(I::Equal), None),
            Op::NeI16 => (None, Some(I::NotEqual), None),
            Op::LtI16 => (None, Some(I::SignedLessThan), None),
            Op::LeI16 => (None, Some(I::SignedLessThanOrEqual), None),
            Op::GtI16 => (None, Some(I::SignedGreaterThan), None),
            Op::GeI16 => (None, Some(I::SignedGreaterThanOrEqual), None),
            Op::EqF32 => (None, None, Some(F::Equal)),
            Op::LtF32 => (None, None, Some(F::LessThan)),
            Op::LeF32 => (None, None, Some(F::LessThanOrEqual)),
            Op::GtF32 => (None, None, Some(F::GreaterThan)),
            Op::GeF32 => (None, None, Some(F::GreaterThanOrEqual)),
            Op::DifferF32 => (None, None, Some(F::NotEqual)),
            _ => (None, None, None),
        };
        if let Some(condition) = words {
            let [a, b] = [0, 1].map(|at: usize| self.words(&args[at], lanes));
            return Some(a.into_iter().zip(b).map(|(a, b)| self.compared(condition, a, b)).collect());
        }
        if let Some(condition) = halves {
            let [a, b] = [0, 1].map(|at: usize| self.halves(&args[at], lanes));
            let compare = |this: &mut Self, condition: IntCC| {
                let masks: Vec<Value> = a.iter().zip(&b).map(|(&a, &b)| this.b.ins().icmp(condition, a, b)).collect();
                this.widened(&masks, true, lanes)
            };
            let masks = compare(self, condition);
            if takes_two(condition) {
                let opposite = compare(self, condition.complement());
                self.opposites.extend(masks.iter().copied().zip(opposite));
            }
            return Some(masks);
        }
        if let Some(condition) = reals {
            let [a, b] = [0, 1].map(|at: usize| self.reals(&args[at], lanes));
            return Some(a.into_iter().zip(b).map(|(a, b)| self.b.ins().fcmp(condition, a, b)).collect());
        }
        match op {
            // By 0, and the least number by -1.
            Op::DivFailsI32 => {
                let [a, b] = [0, 1].map(|at: usize| self.words(&args[at], lanes));
                let [least, minus_one] = [i32::MIN, -1].map(|number| self.constant_vector(I32X4, number.to_le_bytes().repeat(4)));
                let zero = self.zeros(I32X4);
                let one = |(a, b)| {
                    let by_zero = self.b.ins().icmp(I::Equal, b, zero);
                    let of_least = self.b.ins().icmp(I::Equal, a, least);
                    let by_minus_one = self.b.ins().icmp(I::Equal, b, minus_one);
                    let too_great = self.b.ins().band(of_least, by_minus_one);
                    self.b.ins().bor(by_zero, too_great)
                };
                Some(a.into_iter().zip(b).map(one).collect())
            }
            // One is less than the other: there is no such comparison of vectors.
            Op::NeF32 => {
                let [a, b] = [0, 1].map(|at: usize| self.reals(&args[at], lanes));
                let one = |(a, b)| {
                    let less = self.b.ins().fcmp(F::LessThan, a, b);
                    let more = self.b.ins().fcmp(F::LessThan, b, a);
                    self.b.ins().bor(less, more)
                };
                Some(a.into_iter().zip(b).map(one).collect())
            }
            Op::Not => {
                let masks = self.masks(&args[0], lanes);
                Some(masks.into_iter().map(|mask| self.opposite_of(mask)).collect())
            }
            Op::And | Op::AndNot | Op::Or | Op::Xor => {
                let [a, b] = [0, 1].map(|at: usize| self.masks(&args[at], lanes));
                Some(a.into_iter().zip(b).map(|(a, b)| self.logic_of_masks(op, a, b)).collect())
            }
            Op::Select if shape == Shape::Mask => {
                let masks = self.masks(&args[0], lanes);
                Some(self.chosen_masks(&masks, &args[1], &args[2], lanes))
            }
            Op::Select | Op::Gate => {
                let chosen = self.chosen_numbers(op, shape, args, lanes);
                let is_small = |arg: &Lanes| matches!(arg, Lanes::One(Val::Const(0..0x8000)));
                let numbers = if op == Op::Gate { &args[..1] } else { &args[1..] };
                // Cranelift would not see that they are the same.
                if shape == Shape::Halves && numbers.iter().all(is_small) {
                    let words = self.chosen_numbers(op, Shape::Words, args, lanes);
                    let words = words.chunks(2).map(<[Value]>::to_vec);
                    self.in_words.extend(chosen.iter().copied().zip(words));
                }
                Some(chosen)
            }
            _ => None,
        }
    }

    /// A choice between numbers of 16 or 32 bits, or between one and 0.
    fn chosen_numbers(&mut self, op: Op, shape: Shape, args: &[Lanes], lanes: u32) -> Vec<Value> {
        let vectors = |this: &mut Self, of: &Lanes| match shape {
            Shape::Halves => this.halves(of, lanes),
            _ => this.words(of, lanes),
        };
        if op == Op::Gate {
            let masks = self.masks(&args[1], lanes);
            let values = vectors(self, &args[0]);
            return self.where_masks(values, masks, true, shape);
        }
        let masks = self.masks(&args[0], lanes);
        let (a, b) = (&args[1], &args[2]);
        // What is 0 on one side is cut out by the mask.
        if is_constant(a, 0) || is_constant(b, 0) {
            let (value, holds) = if is_constant(b, 0) { (a, true) } else { (b, false) };
            let values = vectors(self, value);
            return self.where_masks(values, masks, holds, shape);
        }
        let [a, b] = [a, b].map(|of| vectors(self, of));
        let (masks, holds) = self.simplest(masks);
        let masks = self.masks_of_shape(masks, shape);
        let (a, b) = if holds { (a, b) } else { (b, a) };
        a.into_iter().zip(b).zip(masks).map(|((a, b), mask)| self.choice(mask, a, b)).collect()
    }

    /// Iterations the bytes of each number of a vector around.
    pub(super) fn turned(&mut self, vector: Value, bytes: u8) -> Value {
        let mask = turned_order(bytes);
        if let Some((of, known)) = self.shuffled_of(vector)
            && known == mask
        {
            return of;
        }
        let mask: Immediate = self.b.func.dfg.immediates.push(ConstantData::from(mask));
        self.b.ins().shuffle(vector, vector, mask)
    }

    /// Reads numbers that follow one another.
    pub(super) fn read_lanes(&mut self, address: Value, offset: i32, shape: Shape, lanes: u32) -> Lanes {
        let (ty, count) = shape.vectors(lanes);
        let bytes = ty.lane_type().bytes() as u8;
        let one = |number: u32| {
            let offset = offset + (number * VECTOR_BYTES) as i32;
            let vector = if lanes < ty.lane_count() {
                let half = self.b.ins().load(I64, data(), address, offset);
                let half = self.b.ins().scalar_to_vector(I64X2, half);
                self.b.ins().bitcast(I8X16, little(), half)
            } else {
                self.b.ins().load(I8X16, data(), address, offset)
            };
            let vector = self.turned(vector, bytes);
            self.b.ins().bitcast(ty, little(), vector)
        };
        shape.of((0..count).map(one).collect())
    }

    /// Writes numbers of so many bytes that follow one another.
    pub(super) fn write_lanes(&mut self, address: Value, offset: i32, value: &Lanes, bytes: u8, lanes: u32) {
        let vectors = self.vectors_to_write(value, bytes, lanes);
        for (number, vector) in (0..).zip(vectors) {
            let vector = self.b.ins().bitcast(I8X16, little(), vector);
            let vector = self.turned(vector, bytes);
            let offset = offset + number * VECTOR_BYTES as i32;
            if lanes * u32::from(bytes) < VECTOR_BYTES {
                let both = self.b.ins().bitcast(F64X2, little(), vector);
                let half = self.b.ins().extractlane(both, 0);
                self.b.ins().store(data(), half, address, offset);
                continue;
            }
            self.b.ins().store(data(), vector, address, offset);
        }
    }

    /// Numbers of so many bytes as memory gets them, but for the order of their bytes.
    pub(super) fn vectors_to_write(&mut self, value: &Lanes, bytes: u8, lanes: u32) -> Vec<Value> {
        match (bytes, value) {
            (2, value) => self.halves(value, lanes),
            (8, value) => self.quads(value, lanes),
            (_, Lanes::Reals(reals)) => reals.clone().into_iter().map(|real| self.quiet_vector(real)).collect(),
            (_, value) => self.words(value, lanes),
        }
    }

    /// The bits of REALs; what is no number becomes the one NaN that the project shows.
    fn quiet_vector(&mut self, real: Value) -> Value {
        let none = self.b.ins().fcmp(FloatCC::Unordered, real, real);
        let bits = self.b.ins().bitcast(I32X4, little(), real);
        let nan = self.constant_vector(I32X4, f32::NAN.to_bits().to_le_bytes().repeat(4));
        self.b.ins().bitselect(none, nan, bits)
    }

    /// The value of the last iteration.
    pub(super) fn last_lane(&mut self, value: &Lanes, lanes: u32) -> Val {
        match value {
            Lanes::One(value) => *value,
            Lanes::Affine(first, line) => self.further(*first, *line, lanes - 1),
            Lanes::Halves(vectors) => {
                let half = self.b.ins().extractlane(vectors[vectors.len() - 1], (lanes - 1) as u8 % 8);
                Val::Int(self.b.ins().uextend(I32, half))
            }
            Lanes::Words(vectors) => Val::Int(self.b.ins().extractlane(vectors[vectors.len() - 1], 3)),
            Lanes::Mask(vectors) => Val::Bit { value: self.b.ins().extractlane(vectors[vectors.len() - 1], 3), clean: false },
            Lanes::Wide(vectors) => Val::Word(self.b.ins().extractlane(vectors[vectors.len() - 1], 1)),
            Lanes::LongMask(vectors) => {
                let mask = self.b.ins().extractlane(vectors[vectors.len() - 1], 1);
                Val::Bit { value: self.b.ins().ireduce(I32, mask), clean: false }
            }
            Lanes::Lreals(vectors) => {
                let real = self.b.ins().extractlane(vectors[vectors.len() - 1], 1);
                debug_assert_eq!(self.b.func.dfg.value_type(real), F64);
                self.quiet_f64(real)
            }
            Lanes::Reals(vectors) => {
                let real = self.b.ins().extractlane(vectors[vectors.len() - 1], 3);
                debug_assert_eq!(self.b.func.dfg.value_type(real), F32);
                self.quiet(real)
            }
        }
    }

    /// A value so many iterations later.
    pub(super) fn further(&mut self, value: Val, line: Affine, iterations: u32) -> Val {
        let value = self.int(value);
        let sum = self.b.ins().iadd_imm_u(value, i64::from(line.step.wrapping_mul(iterations)));
        self.on_line(sum, line)
    }

    /// A sum on a line, in the form of its values.
    pub(super) fn on_line(&mut self, sum: Value, line: Affine) -> Val {
        if line.bits == 32 {
            return Val::Int(sum);
        }
        let low = self.b.ins().band_imm_u(sum, 0xFFFF);
        self.narrow.insert(low, 16);
        Val::Int(low)
    }

    /// A value so many iterations later, as a number of 64 bits.
    pub(super) fn behind(&mut self, value: Val, line: Affine, iterations: Value) -> Val {
        if line.is_same() {
            return value;
        }
        let iterations = self.b.ins().ireduce(I32, iterations);
        let way = self.b.ins().imul_imm_u(iterations, i64::from(line.step));
        let value = self.int(value);
        let sum = self.b.ins().iadd(value, way);
        self.on_line(sum, line)
    }

    /// The sum of so many lanes of some vectors.
    pub(super) fn sum_of_lanes(&mut self, vectors: &[Value], lanes: u32) -> Value {
        let mut sum = vectors[0];
        for &vector in &vectors[1..] {
            sum = self.b.ins().iadd(sum, vector);
        }
        let ty = self.b.func.dfg.value_type(sum);
        let mut total = None;
        for lane in 0..ty.lane_count().min(lanes) as u8 {
            let value = self.b.ins().extractlane(sum, lane);
            let value = if ty == I16X8 { self.b.ins().uextend(I32, value) } else { value };
            total = Some(match total {
                Some(total) => self.b.ins().iadd(total, value),
                None => value,
            });
        }
        total.unwrap_or_else(|| unreachable!("a vector has lanes"))
    }

    /// A vector of zeros.
    pub(super) fn zeros(&mut self, ty: Type) -> Value {
        self.constant_vector(ty, vec![0; VECTOR_BYTES as usize])
    }

    /// A distance of pointers in bits, as one of bytes in 64 bits.
    pub(super) fn bytes_of_step(step: u32, iterations: u32) -> i64 {
        i64::from(step as i32) / 8 * i64::from(iterations)
    }

    /// A constant number of iterations.
    pub(super) fn iterations_constant(&mut self, iterations: i64) -> Value {
        self.b.ins().iconst(I64, iterations)
    }
}
