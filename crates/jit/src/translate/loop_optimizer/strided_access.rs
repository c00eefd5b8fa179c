//! Strided accesses, gathered and scattered: variables of vectorized iterations that are not consecutive, as fields of structures and
//! instances in arrays. They are loaded one by one into lanes, and stored one by one out of them.

use std::collections::BTreeSet;
use std::ops::{Range, RangeInclusive};

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F32, F32X4, F64, F64X2, I8, I8X16, I16, I16X8, I32, I32X4, I64, I64X2};
use cranelift_codegen::ir::{InstBuilder, StackSlotData, StackSlotKind, Type, Value};
use sieben_engine::ir::Op;
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::{Address, data};
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::SIDE_BY_SIDE_MAX;
use super::kernel::{Access, Definition, Kernel, Level, Node};
use super::modular_addressing::Distance;
use super::scalar_evolution::Shape;
use super::vectorization::{Lanes, VECTOR_BYTES, little};

/// Vectorized iterations at most where variables lie apart.
const ITERATIONS_MAX: i64 = 8;
/// Operations and accesses of an iteration for each operation that has no form for vectors.
const OTHERS_MIN: usize = 4;

/// The first 16 bits of each number of 32 bits, turned around.
pub(super) const FIRST_WORDS_TURNED: [u8; 16] = [1, 0, 5, 4, 9, 8, 13, 12, 1, 0, 5, 4, 9, 8, 13, 12];

/// Vectors that are put together at different places on the stack.
const TOGETHER: u32 = 16;

/// How the variables of vectorized iterations lie: the first one, and the bytes to the next one.
#[derive(Clone, Copy)]
pub(super) struct Strided {
    pub(super) first: Address,
    pub(super) step: i32,
    /// Whether no iteration writes it.
    pub(super) only_read: bool,
    /// Whether the running iterations have written nothing of what is read.
    pub(super) untouched: bool,
    /// Whether four bytes may be read at each place: a processor waits for the memory where some of them were just written.
    pub(super) more: bool,
}

impl Strided {
    fn of_lane(self, lane: u32) -> Address {
        Address { offset: self.first.offset + self.step * lane as i32, ..self.first }
    }
}

impl Kernel {
    /// The bytes from where an access goes in one iteration to where it goes in the next, if something lies between.
    pub(super) fn apart(&self, access: &Access) -> Option<i32> {
        if self.inner.is_some() {
            return None;
        }
        let step = self.counted_on(access, Level::Outer)?;
        let follows = access.width != Width::Bit && step == access.width.bytes() * 8;
        (step != 0 && !follows).then_some(step as i32 / 8)
    }

    /// The form of variables that lie apart.
    pub(super) fn shape_of_apart(&self, access: &Access) -> Option<Shape> {
        self.apart(access)?;
        Some(match access.width {
            Width::Bit => Shape::Mask,
            Width::Byte | Width::DoubleWord => Shape::Words,
            Width::Word => Shape::Halves,
            Width::QuadWord => Shape::Wide,
        })
    }

    /// Whether an iteration reads or writes something that lies apart from that of the next iteration.
    pub(super) fn is_spread(&self) -> bool {
        self.accesses.iter().any(|access| self.apart(access).is_some())
    }

    /// Whether what an iteration touches later is not what one of the iterations beside it has touched before, which is done first then.
    /// Both are counted on.
    pub(super) fn iterations_stay_apart(&self, later: &Access, earlier: &Access) -> bool {
        let iterations = if self.inner.is_some() { i64::from(SIDE_BY_SIDE_MAX) } else { ITERATIONS_MAX };
        self.stay_apart(later, earlier, 1..=iterations)
    }

    /// Whether what an access touches is not what another one touches so many iterations later. Both are counted on.
    fn stay_apart(&self, later: &Access, earlier: &Access, iterations: RangeInclusive<i64>) -> bool {
        self.distances(later, earlier).into_iter().any(|Distance { step, ahead, later, earlier }| {
            let is_apart = |iterations: i64| iterations * step + earlier <= ahead || ahead + later <= iterations * step;
            iterations.clone().all(is_apart)
        })
    }

    /// Whether four bytes may be read where an access goes, so near to the end of the arena.
    pub(super) fn has_more(&self, access: &Access) -> bool {
        let (base, bytes) = access.bytes();
        let last = bytes.end - i64::from(access.width.bytes());
        base == Base::Arena && usize::try_from(last + 4).is_ok_and(|end| end <= self.size)
    }

    /// Whether an access may go to what another one has written in one of the vectorized iterations, with four bytes instead of its own
    /// if `more` is so.
    pub(super) fn touches(&self, number: usize, more: bool, other: usize) -> bool {
        let [own, other] = [&self.accesses[number], &self.accesses[other]];
        let wide;
        let own = match more {
            true => {
                wide = Access { width: Width::DoubleWord, ..own.clone() };
                &wide
            }
            false => own,
        };
        own.may_share(other) && !self.stay_apart(own, other, -ITERATIONS_MAX..=ITERATIONS_MAX)
    }

    /// Whether no iteration writes what iterations read with an access, and nothing uses it after them: others may have written it then.
    pub(super) fn is_only_read(&self, number: usize) -> bool {
        let mut left = BTreeSet::new();
        self.all_ends().for_each(|end| self.rests(end, &mut left));
        if left.contains(&self.read_of(number)) {
            return false;
        }
        let writes = |&other: &usize| self.accesses[other].value.is_some();
        !(0..self.accesses.len()).filter(writes).any(|other| self.touches(number, false, other))
    }

    /// The form of what an operation makes that is done one by one, if others are worth it.
    pub(super) fn shape_one_by_one(&self, node: Node, op: Op) -> Option<Shape> {
        if op.arity() > 3 || !self.is_spread() && !self.accesses.iter().any(|access| self.is_row_of_bits(access)) {
            return None;
        }
        Some(self.shape_by_width(node))
    }

    /// Whether so few operations are done one by one that it is worth it. Those of an inner loop, of so many iterations, are none of them.
    pub(super) fn few_are_one_by_one(&self, inner_iterations: i64) -> bool {
        let mut reached = BTreeSet::new();
        let of_accesses = self.accesses.iter().flat_map(|access| [Some(access.pointer), access.value]).flatten();
        self.all_ends().chain(of_accesses).for_each(|node| self.rests(node, &mut reached));
        let is_computed = |node: &Node| matches!(self.what(*node), Definition::Compute(..)) && self.line(*node, Level::Outer).is_none();
        let computed: Vec<Node> = reached.into_iter().filter(is_computed).collect();
        let alone = computed.iter().filter(|&&node| self.is_one_by_one(node)).count();
        let gathered = self.accesses.iter().filter(|access| self.is_gathered(access) || self.is_scattered(access)).count();
        let (alone, others) = (alone + gathered, computed.len() - alone + self.accesses.len() - gathered);
        let inside = self.inner.as_ref().map_or(0, |inner| inner.steps.len());
        let others = others.saturating_add(inside.saturating_mul(usize::try_from(inner_iterations).unwrap_or_default()));
        others >= OTHERS_MIN * alone
    }

    /// Whether vectorized iterations do an operation one by one.
    pub(super) fn is_one_by_one(&self, node: Node) -> bool {
        let is_computed = matches!(self.what(node), Definition::Compute(..)) && self.line(node, Level::Outer).is_none();
        let is_in_order = self.in_order.nodes.contains(&node);
        is_computed && (is_in_order || self.shape(node).is_some() && self.vector_shape(node).is_none())
    }
}

impl Translator<'_> {
    /// Reads variables that lie apart.
    pub(super) fn read_apart(&mut self, apart: Strided, shape: Shape, width: Width, lanes: u32) -> Lanes {
        if width == Width::Byte {
            let low = self.all_words(0xFF);
            let words = self.bytes_apart(apart, lanes);
            words.iter().for_each(|&word| self.put_together(apart, word));
            return Lanes::Words(words.into_iter().map(|word| self.b.ins().band(word, low)).collect());
        }
        let (ty, count) = shape.vectors(lanes);
        let own = lanes / count;
        let vectors = (0..count).map(|number| {
            let bytes = ty.lane_type().bytes() as u8;
            let iterations = number * own..(number + 1) * own;
            if bytes == 2 && apart.more {
                let vector = self.read_vector(apart, iterations, F32);
                self.put_together(apart, vector);
                return self.shuffled(vector, vector, FIRST_WORDS_TURNED);
            }
            let read = match bytes {
                8 => F64,
                4 => F32,
                _ => I16,
            };
            let vector = self.read_vector(apart, iterations, read);
            self.put_together(apart, vector);
            self.turned(vector, bytes)
        });
        let vectors: Vec<Value> = vectors.collect();
        shape.of(vectors.into_iter().map(|vector| self.b.ins().bitcast(ty, little(), vector)).collect())
    }

    /// Reads what so many iterations from one on need, as bytes of a vector.
    fn read_vector(&mut self, apart: Strided, iterations: Range<u32>, ty: Type) -> Value {
        let numbers: Vec<Value> = iterations.map(|lane| self.read_lane(apart, lane, ty)).collect();
        self.vector_of(&numbers)
    }

    /// Reads what one of the iterations needs: where the vector of it is put together, if nothing has written it, or where it is needed, if
    /// nothing writes it.
    fn read_lane(&mut self, apart: Strided, lane: u32, ty: Type) -> Value {
        let flags = if apart.untouched { data().with_readonly().with_can_move() } else { data() };
        let Address { base, offset, .. } = apart.of_lane(lane);
        self.b.ins().load(ty, flags, base, offset)
    }

    /// Sees to it that numbers become a vector as soon as they are read: Cranelift would keep each of them until the vector is needed.
    pub(super) fn put_together(&mut self, apart: Strided, vector: Value) {
        if apart.only_read {
            return;
        }
        let (slot, number) = *self.together.get_or_insert_with(|| {
            let bytes = StackSlotData::new(StackSlotKind::ExplicitSlot, TOGETHER * VECTOR_BYTES, 4);
            (self.b.create_sized_stack_slot(bytes), 0)
        });
        // What is written twice is written only once, and too late.
        self.together = Some((slot, (number + 1) % TOGETHER));
        self.b.ins().stack_store(I64, vector, slot, (number * VECTOR_BYTES) as i32);
    }

    /// The bytes of a vector that begins with these numbers.
    fn vector_of(&mut self, numbers: &[Value]) -> Value {
        let ty = self.b.func.dfg.value_type(numbers[0]);
        let ty = ty.by(VECTOR_BYTES / ty.bytes()).expect("a vector of them");
        // One step for a number that is read, where to leave the others 0 takes three.
        let mut vector = self.b.ins().splat(ty, numbers[0]);
        for (lane, &number) in (1..).zip(&numbers[1..]) {
            vector = self.b.ins().insertlane(vector, number, lane);
        }
        self.b.ins().bitcast(I8X16, little(), vector)
    }

    /// Bytes that lie apart, each as the lowest one of 32 bits.
    pub(super) fn bytes_apart(&mut self, apart: Strided, lanes: u32) -> Vec<Value> {
        let one = |number: u32| {
            if apart.more {
                let vector = self.read_vector(apart, 4 * number..4 * number + 4, F32);
                return self.b.ins().bitcast(I32X4, little(), vector);
            }
            let numbers = [0, 1, 2, 3].map(|lane| {
                let byte = self.read_lane(apart, 4 * number + lane, I8);
                self.b.ins().uextend(I32, byte)
            });
            let vector = self.vector_of(&numbers);
            self.b.ins().bitcast(I32X4, little(), vector)
        };
        (0..lanes / 4).map(one).collect()
    }

    /// The same number of 32 bits in all lanes.
    pub(super) fn all_words(&mut self, number: u32) -> Value {
        self.constant_vector(I32X4, number.to_le_bytes().repeat(4))
    }

    /// A bit of bytes that lie apart.
    pub(super) fn bits_of_bytes(&mut self, bytes: &[Value], bit: u8) -> Lanes {
        let own = self.all_words(1 << bit);
        let one = |&byte: &Value| {
            let alone = self.b.ins().band(byte, own);
            self.b.ins().icmp(IntCC::Equal, alone, own)
        };
        Lanes::Mask(bytes.iter().map(one).collect())
    }

    /// Bytes that lie apart with another value of one of their bits.
    pub(super) fn with_bits(&mut self, bytes: &[Value], bit: u8, value: &Lanes, lanes: u32) -> Vec<Value> {
        let own = self.all_words(1 << bit);
        let masks = match value {
            Lanes::One(Val::Const(0)) => None,
            value => Some(self.masks(value, lanes)),
        };
        let mut new = Vec::new();
        for (number, &byte) in bytes.iter().enumerate() {
            new.push(match &masks {
                None => self.b.ins().band_not(byte, own),
                Some(masks) => self.with_bit_of_mask(byte, bit, masks[number]),
            });
        }
        new
    }

    /// Writes the lowest byte of each number to bytes that lie apart.
    pub(super) fn write_bytes_apart(&mut self, apart: Strided, words: &[Value]) {
        for (number, &word) in (0..).zip(words) {
            let vector = self.b.ins().bitcast(I8X16, little(), word);
            for lane in 0..4 {
                let byte = self.b.ins().extractlane(vector, 4 * lane as u8);
                let Address { base, offset, .. } = apart.of_lane(4 * number + lane);
                self.b.ins().store(data(), byte, base, offset);
            }
        }
    }

    /// Writes one of the numbers of a vector.
    fn write_lane(&mut self, apart: Strided, lane: u32, vector: Value) {
        let ty = self.b.func.dfg.value_type(vector);
        let Address { base, offset, .. } = apart.of_lane(lane);
        let at = lane % ty.lane_count();
        // The lowest one is written out of the vector in one step as a REAL.
        let (vector, data_type) = match ty {
            I32X4 if at == 0 => (self.b.ins().bitcast(F32X4, little(), vector), F32),
            I64X2 if at == 0 => (self.b.ins().bitcast(F64X2, little(), vector), F64),
            ty => (vector, ty.lane_type()),
        };
        let one = self.b.ins().extractlane(vector, at as u8);
        debug_assert_eq!(self.b.func.dfg.value_type(one), data_type);
        self.b.ins().store(data(), one, base, offset);
    }

    /// Writes variables that lie apart.
    pub(super) fn write_apart(&mut self, apart: Strided, width: Width, value: &Lanes, lanes: u32) {
        if let Lanes::One(value) = *value {
            (0..lanes).for_each(|lane| self.write(apart.of_lane(lane), width, value));
            return;
        }
        if width == Width::Byte {
            let words = self.words(value, lanes);
            self.write_bytes_apart(apart, &words);
            return;
        }
        let bytes = width.bytes() as u8;
        let ty = match bytes {
            2 => I16X8,
            4 => I32X4,
            _ => I64X2,
        };
        for (number, vector) in (0..).zip(self.vectors_to_write(value, bytes, lanes)) {
            let vector = self.b.ins().bitcast(I8X16, little(), vector);
            let vector = self.turned(vector, bytes);
            let vector = self.b.ins().bitcast(ty, little(), vector);
            for lane in 0..ty.lane_count().min(lanes) {
                self.write_lane(apart, number * ty.lane_count() + lane, vector);
            }
        }
    }

    /// The value of one of the vectorized iterations.
    pub(super) fn of_lane(&mut self, value: &Lanes, lane: u32) -> Val {
        let at = |vectors: &[Value], this: &mut Self| {
            let count = this.b.func.dfg.value_type(vectors[0]).lane_count();
            this.b.ins().extractlane(vectors[(lane / count) as usize], (lane % count) as u8)
        };
        match value {
            Lanes::One(value) => *value,
            Lanes::Affine(first, _) if lane == 0 => *first,
            Lanes::Affine(first, line) => self.further(*first, *line, lane),
            Lanes::Halves(vectors) => {
                let half = at(vectors, self);
                let number = self.b.ins().uextend(I32, half);
                self.narrow.insert(number, 16);
                Val::Int(number)
            }
            Lanes::Words(vectors) => Val::Int(at(vectors, self)),
            Lanes::Mask(vectors) => Val::Bit { value: at(vectors, self), clean: false },
            Lanes::LongMask(vectors) => {
                let mask = at(vectors, self);
                Val::Bit { value: self.b.ins().ireduce(I32, mask), clean: false }
            }
            Lanes::Wide(vectors) => Val::Word(at(vectors, self)),
            Lanes::Reals(vectors) => {
                let real = at(vectors, self);
                self.quiet(real)
            }
            Lanes::Lreals(vectors) => {
                let real = at(vectors, self);
                self.quiet_f64(real)
            }
        }
    }

    /// The result of an operation that is done for each iteration alone, on numbers that are known to have these bounds.
    pub(super) fn compute_one_by_one(&mut self, op: Op, shape: Shape, args: &[Lanes], bounds: Option<(u32, u32)>, lanes: u32) -> Lanes {
        let mut results = Vec::new();
        for lane in 0..lanes {
            let own: Vec<Val> = args.iter().map(|arg| self.of_lane(arg, lane)).collect();
            if let (Some(bounds), Some(&Val::Int(number))) = (bounds, own.first()) {
                self.bounds.insert(number, bounds);
            }
            results.push(self.compute_now(op, &own));
        }
        self.side_by_side(shape, &results)
    }

    /// Values of one iteration each in the lanes of vectors.
    pub(super) fn side_by_side(&mut self, shape: Shape, values: &[Val]) -> Lanes {
        let number = |&value: &Val| match shape {
            Shape::Wide => self.word(value),
            Shape::Halves => {
                let number = self.int(value);
                self.b.ins().ireduce(I16, number)
            }
            Shape::Mask => {
                let flag = self.flag(value);
                self.b.ins().ineg(flag)
            }
            _ => self.int(value),
        };
        let numbers: Vec<Value> = values.iter().map(number).collect();
        debug_assert!(shape != Shape::Wide || self.b.func.dfg.value_type(numbers[0]) == I64);
        let (ty, _) = shape.vectors(values.len() as u32);
        let one = |numbers: &[Value]| {
            let vector = self.vector_of(numbers);
            self.b.ins().bitcast(ty, little(), vector)
        };
        shape.of(numbers.chunks(ty.lane_count() as usize).map(one).collect())
    }
}
