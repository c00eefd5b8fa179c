//! Counted loops over arrays whose iterations machine code does at once: whatever they compute, whenever the budget ends and whatever the
//! Host changes then, memory, registers, questions and budget are those of the interpreter.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Entry, Exit, FaultPlace, Layout, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 450;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Bytes of the data block: room for some arrays.
const DATA_BYTES: usize = 640;
/// Where the variables lie in bit memory: not in an array.
const VARIABLES: u32 = 200;

/// Blocks that some loops call.
const FUNCTION: BlockId = BlockId::fc(1);
const FUNCTION_BLOCK: BlockId = BlockId::fb(1);

/// How a loop counts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Counter {
    /// A DINT up to a limit, or down to it.
    Double,
    /// The same as an INT.
    Word,
    /// ACCU 1, as `LOOP` does.
    Looping,
}

/// A program in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    /// The variable with the next number has not been used.
    next: u32,
    /// Whether the loops call blocks.
    calls: bool,
}

/// Part of an iteration.
enum Part {
    Statement,
    /// The first is jumped over if a condition holds; if it is not, the second is.
    Choice(Vec<Part>, Vec<Part>),
}

impl Part {
    fn count(parts: &[Self]) -> u32 {
        let one = |part: &Self| match part {
            Self::Statement => 1,
            Self::Choice(first, second) => 1 + Self::count(first) + if second.is_empty() { 0 } else { 1 + Self::count(second) },
        };
        parts.iter().map(one).sum()
    }
}

#[derive(Clone, Copy)]
struct Variable {
    place: Place,
    width: Width,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    /// A variable of its own, now and then one that others use, or that lies in the arrays.
    fn variable(&mut self, width: Width) -> Variable {
        self.next += 4;
        let position = match self.dice.roll(12) {
            0 if self.dice.roll(3) == 0 => 8 * self.dice.roll(64) as u32,
            1 if self.dice.roll(3) == 0 => 8 * (VARIABLES + 4 * self.dice.roll(6) as u32),
            _ => 8 * (VARIABLES + self.next % 48),
        };
        let area = if self.dice.roll(16) == 0 { Area::SharedData } else { Area::BitMemory };
        let position = if area == Area::SharedData { position % (8 * 500) / 8 * 8 } else { position };
        Variable { place: Place::Fixed { area, position }, width }
    }

    fn get(&mut self, it: Variable) -> Var {
        self.b.load(it.place, it.width, OnFault::SkipStatement)
    }

    fn put(&mut self, it: Variable, value: Var) {
        self.b.store(it.place, it.width, value);
    }

    /// A number that is calculated from an INT as an INT: mostly one that does not leave its type.
    fn calculated(&mut self, number: Var) -> Var {
        let mut number = number;
        for _ in 0..=self.dice.roll(2) {
            let op = self.dice.of(&[Op::AddU16, Op::SubU16, Op::MulU16]);
            let other = self.dice.of(&[0, 1, 1, 2, 3, 3, 16, 32, 1_000, 0x2001, 0x4000, 0x7FF0, 0x8000, 0xFFFE, 0xFFFF]);
            let other = self.b.constant(other);
            let args = if op == Op::SubU16 && self.dice.roll(2) == 0 { [other, number] } else { [number, other] };
            number = self.b.compute(op, &args);
        }
        number
    }

    /// An element of an array, by some of the indexes.
    fn element(&mut self, indexes: &[(Variable, Counter)], width: Width, write: bool) -> Place {
        let area = if self.dice.roll(16) == 0 { Area::BitMemory } else { Area::SharedData };
        // Arrays lie apart most of the time.
        let slot = if write && self.dice.roll(4) != 0 { 2 } else { self.dice.roll(3) };
        let jitter = if self.dice.roll(6) == 0 { 2 * self.dice.roll(40) } else { 0 };
        let offset = match self.dice.roll(24) {
            0 => 0x0100_0000 - 8 * self.dice.roll(40) as u32,
            _ if area == Area::BitMemory => 8 * jitter as u32,
            _ => 8 * (200 * slot + jitter) as u32,
        };
        let mut pointer: Option<Var> = None;
        for (at, &(index, counter)) in indexes.iter().enumerate() {
            if at > 0 && self.dice.roll(3) == 0 {
                continue;
            }
            let mut number = self.get(index);
            if counter == Counter::Word {
                if self.dice.roll(3) == 0 {
                    number = self.calculated(number);
                }
                // A UINT is what it is.
                if self.dice.roll(6) != 0 {
                    number = self.b.compute(Op::Extend16, &[number]);
                }
            }
            let elements = if at == 0 { self.dice.of(&[1, 1, 1, 1, 1, 2, 8]) } else { self.dice.of(&[1, 1, 8]) };
            let step = self.b.constant(u64::from(width.bits()) * elements);
            let part = self.b.compute(Op::MulU32, &[number, step]);
            pointer = Some(match pointer {
                Some(before) => self.b.compute(Op::AddU32, &[before, part]),
                None => part,
            });
        }
        let pointer = match pointer {
            Some(pointer) if self.dice.roll(12) == 0 => {
                let count = self.b.constant(8 * DATA_BYTES as u64 - 64);
                let inside = self.b.compute(Op::Below, &[pointer, count]);
                self.b.compute(Op::Gate, &[pointer, inside])
            }
            Some(pointer) => pointer,
            None => self.b.constant(0),
        };
        Place::Indirect { area, pointer, offset }
    }

    fn operand(&mut self, indexes: &[(Variable, Counter)], width: Width, others: &[Variable]) -> Var {
        match self.dice.roll(12) {
            0 | 1 => {
                let value = self.dice.of(&[0, 1, 3, 0x7FFF, 0xFFFF, 0x3F80_0000, 0x7FC0_0001, 0xFF80_0000]);
                self.b.constant(value)
            }
            2 => self.get(indexes[0].0),
            3 => {
                let other = self.dice.of(others);
                self.get(other)
            }
            _ => {
                let place = self.element(indexes, width, false);
                self.b.load(place, width, OnFault::SkipStatement)
            }
        }
    }

    /// A statement of a loop.
    fn statement(&mut self, indexes: &[(Variable, Counter)], sum: Variable) {
        self.begin();
        let width = match self.dice.roll(20) {
            0 => Width::Bit,
            1 => Width::Byte,
            2..10 => Width::Word,
            _ => Width::DoubleWord,
        };
        let op = match width {
            Width::Word => self.dice.of(&[Op::AddU16, Op::SubU16, Op::MulU16, Op::AddI16Wide, Op::MulI16Wide, Op::Low16, Op::AndU32]),
            Width::DoubleWord => self.dice.of(&[
                Op::AddU32,
                Op::SubU32,
                Op::MulU32,
                Op::XorU32,
                Op::AddF32,
                Op::MulF32,
                Op::SubF32,
                Op::DivF32,
                Op::Extend16,
                Op::I32ToF32,
                Op::Shl32,
            ]),
            _ => self.dice.of(&[Op::Copy, Op::OrU32]),
        };
        let others = [sum];
        let args = [self.operand(indexes, width, &others), self.operand(indexes, width, &others)];
        let value = self.b.compute(op, &args[..op.arity()]);
        match self.dice.roll(6) {
            0 | 1 => {
                let before = self.get(sum);
                let add = if sum.width == Width::Word {
                    self.dice.of(&[Op::AddU16, Op::MulU16])
                } else {
                    self.dice.of(&[Op::AddU32, Op::AddU32, Op::AddU32, Op::AddF32, Op::SubU32])
                };
                let after = self.b.compute(add, &[before, value]);
                self.put(sum, after);
            }
            2 => {
                let low = self.b.compute(Op::Low32, &[value]);
                let register = self.dice.of(&[Register::Accu2, Register::Ar1, Register::Accu3]);
                self.b.compute_into(register, Op::Copy, &[low]);
            }
            _ => {
                let place = self.element(indexes, width, true);
                self.b.store(place, width, value);
            }
        }
        if self.dice.roll(12) == 0 {
            let register = self.dice.of(&[Register::Rlo, Register::Ov]);
            let flag = self.b.compute(Op::IsNonzero, &[value]);
            self.b.compute_into(register, Op::Copy, &[flag]);
        }
    }

    /// Statements of a loop, some of which are jumped over.
    fn write_parts(&mut self, indexes: &[(Variable, Counter)], sum: Variable, parts: &[Part]) {
        for part in parts {
            match part {
                Part::Statement => self.statement(indexes, sum),
                Part::Choice(first, second) => {
                    self.begin();
                    let condition = self.some_iterations(indexes, sum);
                    let behind = self.statements + Part::count(first) + u32::from(!second.is_empty());
                    self.b.push(Inst::Branch { condition, to: Target(behind) });
                    self.write_parts(indexes, sum, first);
                    if !second.is_empty() {
                        self.begin();
                        let behind = self.statements + Part::count(second);
                        self.b.push(Inst::Jump { to: Target(behind) });
                        self.write_parts(indexes, sum, second);
                    }
                }
            }
        }
    }

    /// A condition that holds in some iterations.
    fn some_iterations(&mut self, indexes: &[(Variable, Counter)], sum: Variable) -> Var {
        let half = self.dice.roll(4) == 0;
        let width = if half { Width::Word } else { Width::DoubleWord };
        let args = [self.operand(indexes, width, &[sum]), self.operand(indexes, width, &[sum])];
        let op = if half {
            self.dice.of(&[Op::LtI16, Op::GeI16, Op::EqI16, Op::NeI16])
        } else {
            let reals = [Op::LtF32, Op::LeF32, Op::GtF32, Op::GeF32, Op::EqF32, Op::NeF32, Op::DifferF32];
            let doubles = [Op::LtI32, Op::GtI32, Op::EqI32, Op::Differ, Op::Below];
            if self.dice.roll(2) == 0 { self.dice.of(&reals) } else { self.dice.of(&doubles) }
        };
        let condition = self.b.compute(op, &args);
        match self.dice.roll(4) {
            0 => self.b.compute(Op::Not, &[condition]),
            1 => {
                let number = self.get(indexes[0].0);
                let limit = self.dice.of(&[3, 7, 20]);
                let limit = self.b.constant(limit);
                let other = self.b.compute(Op::Below, &[number, limit]);
                let op = self.dice.of(&[Op::And, Op::Or, Op::AndNot, Op::Xor]);
                self.b.compute(op, &[condition, other])
            }
            _ => condition,
        }
    }

    fn parts(&mut self, depth: usize) -> Vec<Part> {
        let count = 1 + self.dice.roll(2);
        let parts = (0..count).map(|_| match self.dice.roll(3) {
            0 if depth > 0 => {
                let first = self.parts(depth - 1);
                let second = if self.dice.roll(2) == 0 { self.parts(depth - 1) } else { Vec::new() };
                Part::Choice(first, second)
            }
            _ => Part::Statement,
        });
        parts.collect()
    }

    /// A loop, with another one in it now and then.
    fn counted(&mut self, around: &[(Variable, Counter)]) {
        let counter = self.dice.of(&[Counter::Double, Counter::Double, Counter::Double, Counter::Word, Counter::Looping]);
        let width = if counter == Counter::Double { Width::DoubleWord } else { Width::Word };
        let index = self.variable(width);
        let sum_width = self.dice.of(&[Width::DoubleWord, Width::DoubleWord, Width::Word]);
        let sum = self.variable(sum_width);
        let up = self.dice.roll(4) != 0;
        let iterations = self.dice.of(&[1, 2, 5, 8, 17, 31, 32, 33, 40, 64]);
        let iterations = if around.is_empty() { iterations } else { self.dice.of(&[1, 3, 8, 9]) };
        let first = if up || counter == Counter::Looping { self.dice.of(&[0, 0, 0, 1, 3]) } else { iterations };
        self.begin();
        if counter == Counter::Looping {
            let count = if self.dice.roll(16) == 0 { 0x1_0000 + iterations } else { iterations };
            let value = self.b.constant(count);
            self.b.compute_into(Register::Accu1, Op::Copy, &[value]);
        } else {
            let value = self.b.constant(first);
            self.put(index, value);
        }
        let mut indexes = vec![(index, counter)];
        indexes.extend_from_slice(around);
        let head = self.statements;
        if counter == Counter::Looping {
            self.begin();
            self.put(index, Register::Accu1.into());
        }
        let parts = self.parts(2);
        self.write_parts(&indexes, sum, &parts);
        if around.is_empty() && self.dice.roll(2) == 0 {
            self.counted(&indexes);
            if self.dice.roll(2) == 0 {
                self.statement(&indexes, sum);
            }
        }
        self.begin();
        let to = Target(head);
        if counter == Counter::Looping {
            let count = self.get(index);
            self.b.compute_into(Register::Accu1, Op::Copy, &[count]);
            let low = self.b.compute(Op::Decrement16, &[count]);
            self.b.compute_into(Register::Accu1, Op::MergeLow16, &[count, low]);
            let condition = self.b.compute(Op::IsNonzero, &[low]);
            self.b.push(Inst::Branch { condition, to });
            return;
        }
        let double = counter == Counter::Double;
        let value = self.get(index);
        let step = self.dice.of(&[1, 1, 1, 2, 3]);
        let step = self.b.constant(if up { step } else { step.wrapping_neg() & if double { 0xFFFF_FFFF } else { 0xFFFF } });
        let next = self.b.compute(if double { Op::AddU32 } else { Op::AddU16 }, &[value, step]);
        self.put(index, next);
        let limit = self.b.constant(if up { first + iterations } else { self.dice.roll(2) });
        let op = match (up, double) {
            (true, true) => self.dice.of(&[Op::LeI32, Op::LtI32]),
            (true, false) => self.dice.of(&[Op::LeI16, Op::LtI16]),
            (false, true) => self.dice.of(&[Op::GeI32, Op::GtI32]),
            (false, false) => self.dice.of(&[Op::GeI16, Op::GtI16]),
        };
        let condition = self.b.compute(op, &[next, limit]);
        self.b.push(Inst::Branch { condition, to });
    }
}

impl Maker<'_> {
    /// A loop that sets or resets bits, each a step behind the one before, as `FOR` has it whose step is known when it runs.
    fn bits(&mut self) {
        let [index, step] = [(); 2].map(|()| self.variable(Width::DoubleWord));
        let computed = self.dice.roll(3) != 0;
        let by = if computed { self.dice.of(&[1, 2, 3, 5, 7, 8, 13, 64, 0, 0xFFFF_FFFF]) } else { 1 };
        let first = self.dice.of(&[0, 0, 8, 1, 13, 200]);
        self.begin();
        let value = self.b.constant(first);
        self.put(index, value);
        let value = self.b.constant(by);
        self.put(step, value);
        let head = self.statements;
        self.begin();
        let number = self.get(index);
        let pointer = match self.dice.roll(2) {
            0 => number,
            _ => {
                let base = self.b.constant(0x8400_0000);
                self.b.compute(Op::AddU32, &[base, number])
            }
        };
        let value = self.dice.roll(2);
        let value = self.b.constant(value);
        let offset = 8 * self.dice.roll(30) as u32 + self.dice.of(&[0, 0, 3]);
        self.b.store(Place::Indirect { area: Area::SharedData, pointer, offset }, Width::Bit, value);
        self.begin();
        let number = self.get(index);
        let by = if computed { self.get(step) } else { self.b.constant(1) };
        let next = self.b.compute(Op::AddU32, &[number, by]);
        self.put(index, next);
        let limit = self.dice.of(&[31, 255, 300, 2000, 4500, 5200]);
        let limit = self.b.constant(limit);
        let up = self.b.compute(Op::LeI32, &[next, limit]);
        let condition = if computed {
            let overflow = self.b.compute(Op::AddOverflowsI32, &[number, by]);
            let down = self.b.compute(Op::GeI32, &[next, limit]);
            let zero = self.b.constant(0);
            let negative = self.b.compute(Op::LtI32, &[by, zero]);
            let choice = self.b.compute(Op::Select, &[negative, down, up]);
            self.b.compute(Op::AndNot, &[choice, overflow])
        } else {
            up
        };
        self.b.push(Inst::Branch { condition, to: Target(head) });
    }
}

impl Maker<'_> {
    /// A bit of an iteration, or another condition.
    fn condition(&mut self, index: Variable) -> Var {
        let number = self.get(index);
        let bit = |this: &mut Self| {
            let offset = this.dice.of(&[0, 0, 3, 8, 77, 4000, 5119 - 300]);
            let place = Place::Indirect { area: Area::SharedData, pointer: number, offset };
            this.b.load(place, Width::Bit, OnFault::SkipStatement)
        };
        let one = bit(self);
        match self.dice.roll(8) {
            0 => self.b.compute(Op::Not, &[one]),
            1..4 => {
                let other = bit(self);
                let op = self.dice.of(&[Op::And, Op::AndNot, Op::Or, Op::Xor]);
                self.b.compute(op, &[one, other])
            }
            4 => {
                let limit = self.dice.of(&[3, 100, 0xFFFF_FFFF]);
                let limit = self.b.constant(limit);
                let less = self.b.compute(Op::LtI32, &[number, limit]);
                self.b.compute(Op::And, &[one, less])
            }
            _ => one,
        }
    }

    /// A loop that counts bits, or does something else in some of its iterations.
    fn tally(&mut self) {
        let index = self.variable(Width::DoubleWord);
        let first = self.dice.of(&[0, 0, 1, 2, 8, 13]);
        let last = first + self.dice.of(&[0, 40, 55, 56, 62, 63, 64, 65, 111, 112, 119, 120, 300, 300]) as u64;
        self.begin();
        let value = self.b.constant(first);
        self.put(index, value);
        let head = self.statements;
        for _ in 0..1 + self.dice.roll(3) {
            let width = self.dice.of(&[Width::DoubleWord, Width::Word]);
            let sum = self.variable(width);
            self.begin();
            let condition = self.condition(index);
            let negated = self.dice.roll(3) == 0;
            let condition = if negated { condition } else { self.b.compute(Op::Not, &[condition]) };
            self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
            self.begin();
            let before = self.get(sum);
            let number = self.dice.of(&[1, 1, 2, 5, 0x7FFF, 0xFFFF_FFFF]);
            let number = self.b.constant(number);
            let op = match width {
                Width::Word => self.dice.of(&[Op::AddU16, Op::AddU16, Op::AddI16Wide, Op::SubU16]),
                _ => self.dice.of(&[Op::AddU32, Op::AddU32, Op::AddU32, Op::SubU32, Op::XorU32]),
            };
            let after = self.b.compute(op, &[before, number]);
            self.put(sum, after);
        }
        self.begin();
        let number = self.get(index);
        let one = self.b.constant(1);
        let next = self.b.compute(Op::AddU32, &[number, one]);
        self.put(index, next);
        let limit = self.b.constant(last);
        let condition = self.b.compute(Op::LeI32, &[next, limit]);
        self.b.push(Inst::Branch { condition, to: Target(head) });
    }
}

/// What the elements of arrays are.
#[derive(Clone, Copy, PartialEq)]
enum Elements {
    Halves,
    Words,
    Reals,
}

impl Elements {
    fn width(self) -> Width {
        if self == Self::Halves { Width::Word } else { Width::DoubleWord }
    }

    fn operations(self) -> &'static [Op] {
        match self {
            Self::Halves => &[Op::AddU16, Op::SubU16, Op::MulU16, Op::AddI16Wide, Op::MulI16Wide, Op::MinI16, Op::MaxI16, Op::Select],
            Self::Words => &[
                Op::AddU32,
                Op::SubU32,
                Op::MulU32,
                Op::AndU32,
                Op::OrU32,
                Op::XorU32,
                Op::MinI32,
                Op::MaxI32,
                Op::NegI32,
                Op::DivI32,
                Op::RemI32,
                Op::DivU64,
                Op::RemU64,
                Op::Shl32,
                Op::Sar32,
                Op::Select,
            ],
            Self::Reals => {
                &[Op::AddF32, Op::SubF32, Op::MulF32, Op::DivF32, Op::MinF32, Op::MaxF32, Op::NegF32, Op::AbsF32, Op::Select, Op::Copy]
            }
        }
    }

    fn comparisons(self) -> &'static [Op] {
        match self {
            Self::Halves => &[Op::LtI16, Op::GeI16, Op::EqI16, Op::NeI16, Op::LeI16, Op::GtI16],
            Self::Words => &[Op::LtI32, Op::LeI32, Op::GtI32, Op::GeI32, Op::EqI32, Op::Differ, Op::Below, Op::LeU64, Op::GtU64, Op::GeU64],
            Self::Reals => &[Op::LtF32, Op::LeF32, Op::GtF32, Op::GeF32, Op::EqF32, Op::NeF32, Op::DifferF32],
        }
    }
}

impl Maker<'_> {
    /// Part of an array: the element of an index, or of a row and a column of 8.
    fn at(&mut self, slot: u32, elements: Elements, parts: &[(Variable, u64)]) -> Place {
        let mut pointer: Option<Var> = None;
        for &(index, times) in parts {
            let mut number = self.get(index);
            if index.width == Width::Word {
                number = self.b.compute(Op::Extend16, &[number]);
            }
            let step = self.b.constant(u64::from(elements.width().bits()) * times);
            let part = self.b.compute(Op::MulU32, &[number, step]);
            pointer = Some(pointer.map_or(part, |before| self.b.compute(Op::AddU32, &[before, part])));
        }
        let pointer = pointer.expect("an element has an index");
        Place::Indirect { area: Area::SharedData, pointer, offset: 8 * 200 * slot }
    }

    fn smooth_operand(&mut self, elements: Elements, index: Variable, other: Variable) -> Var {
        match self.dice.roll(8) {
            0 => {
                let value = self.dice.of(&[1, 3, 0x3F80_0000, 0x7FC0_0001, 0xFF80_0000]);
                self.b.constant(value)
            }
            1 if elements != Elements::Reals => self.get(index),
            2 => self.get(other),
            _ => {
                let slot = self.dice.roll(3) as u32;
                let place = self.at(slot, elements, &[(index, 1)]);
                self.b.load(place, elements.width(), OnFault::SkipStatement)
            }
        }
    }

    /// Statements of such a loop, some of which are jumped over.
    fn smooth_parts(&mut self, elements: Elements, variables: [Variable; 3], parts: &[Part]) {
        let [index, other, sum] = variables;
        for part in parts {
            self.begin();
            let Part::Choice(first, second) = part else {
                self.smooth_statement(elements, index, other, sum);
                continue;
            };
            let args = [self.smooth_operand(elements, index, other), self.smooth_operand(elements, index, other)];
            let op = self.dice.of(elements.comparisons());
            let mut condition = self.b.compute(op, &args);
            if self.dice.roll(3) == 0 {
                condition = self.b.compute(Op::Not, &[condition]);
            }
            if self.dice.roll(4) == 0 {
                let args = [self.smooth_operand(elements, index, other), self.smooth_operand(elements, index, other)];
                let also = self.b.compute(op, &args);
                let both = self.dice.of(&[Op::And, Op::Or, Op::AndNot, Op::Xor]);
                condition = self.b.compute(both, &[condition, also]);
            }
            if self.dice.roll(6) == 0 {
                let flag = Place::Fixed { area: Area::BitMemory, position: 8 * 250 + 3 };
                self.b.store(flag, Width::Bit, condition);
            }
            let behind = self.statements + Part::count(first) + u32::from(!second.is_empty());
            self.b.push(Inst::Branch { condition, to: Target(behind) });
            self.smooth_parts(elements, variables, first);
            if !second.is_empty() {
                self.begin();
                let behind = self.statements + Part::count(second);
                self.b.push(Inst::Jump { to: Target(behind) });
                self.smooth_parts(elements, variables, second);
            }
        }
    }

    /// What a function makes of two values, as the caller of a function in Structured Text has it.
    fn result_of_function(&mut self, a: Var, b: Var) -> Var {
        let local = |byte: u32| Place::Fixed { area: Area::Local, position: 8 * byte };
        for (byte, value) in [(24, a), (28, b)] {
            self.b.store(local(byte), Width::DoubleWord, value);
        }
        for byte in [24, 28, 32] {
            let pointer = self.b.constant(0x8700_0000 + 8 * byte);
            self.b.push(Inst::PassParameter { src: pointer });
        }
        self.b.push(Inst::Call { callee: Callee::Block(FUNCTION), parameters: 3 });
        self.b.load(local(32), Width::DoubleWord, OnFault::SkipStatement)
    }

    /// What a function block of an array makes of a value.
    fn result_of_function_block(&mut self, index: Variable, value: Var) -> Var {
        let saved = Place::Fixed { area: Area::Local, position: 8 * 36 };
        let given = Place::Fixed { area: Area::Local, position: 8 * 40 };
        self.b.store(given, Width::DoubleWord, value);
        self.b.store(saved, Width::DoubleWord, Register::Ar2);
        let mut number = self.get(index);
        if index.width == Width::Word {
            number = self.b.compute(Op::Extend16, &[number]);
        }
        let limit = self.b.constant(36);
        let below = self.b.compute(Op::Below, &[number, limit]);
        self.b.push(Inst::Require { condition: below, code: 162, register: number });
        let number = self.b.compute(Op::Gate, &[number, below]);
        let size = self.b.constant(128);
        let way = self.b.compute(Op::MulU32, &[number, size]);
        let first = self.b.constant(0x8500_0000);
        let pointer = self.b.compute(Op::AddU32, &[first, way]);
        let value = self.b.load(given, Width::DoubleWord, OnFault::SkipStatement);
        self.b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 0 }, Width::DoubleWord, value);
        // Where the variable lies that the block gets as a whole: in the open data block of instances, or in another one.
        let block = match self.dice.roll(4) {
            0 => self.b.compute(Op::Copy, &[Register::DiNumber.into()]),
            1 => self.get(index),
            _ => self.b.constant(1),
        };
        self.b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 80 }, Width::Word, block);
        let positions = self.b.constant(0x7FFFF);
        let position = self.b.compute(Op::AndU32, &[pointer, positions]);
        let first = self.dice.of(&[0x8400_0000, 0x8400_0020, 0x8500_0010, 0x8300_0000]);
        let first = self.b.constant(first);
        let element = self.b.compute(Op::AddU32, &[position, first]);
        self.b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 96 }, Width::DoubleWord, element);
        self.b.compute_into(Register::Ar2, Op::Copy, &[pointer]);
        self.b.push(Inst::Call { callee: Callee::Block(FUNCTION_BLOCK), parameters: 0 });
        let result = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 32 };
        let result = self.b.load(result, Width::DoubleWord, OnFault::SkipStatement);
        self.b.store(given, Width::DoubleWord, result);
        let pointer = self.b.load(saved, Width::DoubleWord, OnFault::SkipStatement);
        self.b.compute_into(Register::Ar2, Op::Copy, &[pointer]);
        self.b.load(given, Width::DoubleWord, OnFault::SkipStatement)
    }

    /// A statement of such a loop, which has begun.
    fn smooth_statement(&mut self, elements: Elements, index: Variable, other: Variable, sum: Variable) {
        match self.dice.roll(if self.calls { 4 } else { 1 }) {
            2 if elements.width() == Width::DoubleWord => {
                let args = [self.smooth_operand(elements, index, other), self.smooth_operand(elements, index, other)];
                let value = self.result_of_function(args[0], args[1]);
                let before = self.get(sum);
                let after = self.b.compute(Op::AddU32, &[before, value]);
                return self.put(sum, after);
            }
            3 if elements.width() == Width::DoubleWord => {
                let value = self.smooth_operand(elements, index, other);
                let value = self.result_of_function_block(index, value);
                let place = self.at(2, elements, &[(index, 1)]);
                return self.b.store(place, elements.width(), value);
            }
            _ => {}
        }
        let args = [self.smooth_operand(elements, index, other), self.smooth_operand(elements, index, other)];
        let op = self.dice.of(elements.operations());
        let value = match op {
            Op::DivI32 | Op::RemI32 | Op::DivU64 | Op::RemU64 | Op::Shl32 | Op::Sar32 => {
                let number = self.dice.of(&[1, 2, 3, 8, 31, 64, 0x4000_0000, 0x8000_0000]);
                let number = self.b.constant(number);
                self.b.compute(op, &[args[0], number])
            }
            Op::Select => {
                let which = self.b.compute(self.dice.of(elements.comparisons()), &args);
                let third = self.smooth_operand(elements, index, other);
                self.b.compute(op, &[which, args[0], third])
            }
            _ => self.b.compute(op, &args[..op.arity()]),
        };
        match self.dice.roll(6) {
            0 | 1 if elements != Elements::Reals => {
                let before = self.get(sum);
                let op = if elements == Elements::Halves { Op::AddU16 } else { Op::AddU32 };
                let after = self.b.compute(op, &[before, value]);
                self.put(sum, after);
            }
            2 => self.put(other, value),
            _ => {
                let place = self.at(2, elements, &[(index, 1)]);
                self.b.store(place, elements.width(), value);
            }
        }
    }

    /// A loop whose iterations hardly depend on one another; `inner` = each makes a sum of products.
    fn smooth(&mut self, inner: bool) {
        let elements = self.dice.of(&[Elements::Halves, Elements::Words, Elements::Reals]);
        let width = if self.dice.roll(3) == 0 { Width::Word } else { Width::DoubleWord };
        let [index, column] = [width, Width::DoubleWord].map(|width| self.variable(width));
        let [sum, other] = [(); 2].map(|()| self.variable(elements.width()));
        let iterations = if inner { self.dice.of(&[3, 7, 8, 9, 31, 33]) } else { self.dice.of(&[5, 8, 16, 17, 31, 32, 40, 48]) };
        self.begin();
        let zero = self.b.constant(0);
        self.put(index, zero);
        let head = self.statements;
        if inner {
            self.begin();
            let value = self.dice.of(&[0, 0, 1, 0x7FC0_0001]);
            let value = self.b.constant(value);
            self.put(sum, value);
            let value = self.dice.roll(2);
            let value = self.b.constant(value);
            self.put(column, value);
            let head = self.statements;
            self.begin();
            let (row_of, column_of) = (self.dice.of(&[0, 1]), self.dice.of(&[0, 1, 8]));
            let first = self.at(row_of, elements, &[(column, 1)]);
            let first = self.b.load(first, elements.width(), OnFault::SkipStatement);
            let second = self.at(1, elements, &[(column, column_of), (index, 1)]);
            let second = self.b.load(second, elements.width(), OnFault::SkipStatement);
            let operations = elements.operations();
            let product = self.b.compute(self.dice.of(&operations[..4.min(operations.len())]), &[first, second]);
            let before = self.get(sum);
            let after = self.b.compute(operations[self.dice.roll(3) as usize], &[before, product]);
            self.put(sum, after);
            self.begin();
            let number = self.get(column);
            let one = self.b.constant(1);
            let next = self.b.compute(Op::AddU32, &[number, one]);
            self.put(column, next);
            let limit = self.dice.of(&[0, 1, 3, 4]);
            let limit = self.b.constant(limit);
            let condition = self.b.compute(Op::LeI32, &[next, limit]);
            self.b.push(Inst::Branch { condition, to: Target(head) });
            self.begin();
            let value = self.get(sum);
            let place = self.at(2, elements, &[(index, 1)]);
            self.b.store(place, elements.width(), value);
        } else {
            let parts = self.parts(2);
            self.smooth_parts(elements, [index, other, sum], &parts);
        }
        self.begin();
        let number = self.get(index);
        let one = self.b.constant(1);
        let double = width == Width::DoubleWord;
        let next = self.b.compute(if double { Op::AddU32 } else { Op::AddU16 }, &[number, one]);
        self.put(index, next);
        let limit = self.b.constant(iterations - 1);
        let condition = self.b.compute(if double { Op::LeI32 } else { Op::LeI16 }, &[next, limit]);
        self.b.push(Inst::Branch { condition, to: Target(head) });
    }
}

fn loops(b: &mut Builder, seed: u64) {
    let mut maker = Maker { b, dice: Dice(seed), statements: 0, next: 0, calls: seed.is_multiple_of(3) };
    maker.begin();
    let number = maker.b.constant(1);
    maker.b.push(Inst::Open { register: DataRegister::Shared, number });
    maker.begin();
    let number = maker.b.constant(2);
    maker.b.push(Inst::Open { register: DataRegister::Instance, number });
    for _ in 0..1 + maker.dice.roll(2) {
        match maker.dice.roll(10) {
            0 => maker.bits(),
            8.. => maker.tally(),
            1..5 => {
                let inner = maker.dice.roll(2) == 0;
                maker.smooth(inner);
            }
            _ => maker.counted(&[]),
        }
    }
    maker.begin();
    maker.b.push(Inst::Return);
}

/// A function of two values, or a function block with a value and a sum, whose last statements are jumped over by a condition.
fn called(b: &mut Builder, seed: u64, is_function: bool) {
    let mut dice = Dice(seed);
    let sum = if is_function {
        Place::Fixed { area: Area::Local, position: 0 }
    } else {
        Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 32 }
    };
    let parameter = |b: &mut Builder, index: u16| {
        let pointer = b.temporary();
        b.push(Inst::Parameter { dst: pointer, index });
        Place::Crossing { pointer, offset: 0 }
    };
    let get = |b: &mut Builder, place: Place| b.load(place, Width::DoubleWord, OnFault::SkipStatement);
    b.begin_statement();
    let args = if is_function {
        [0, 1].map(|index| {
            let place = parameter(b, index);
            get(b, place)
        })
    } else {
        let first = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 0 };
        [first, sum].map(|place| get(b, place))
    };
    let mut value = b.compute(dice.of(&[Op::AddU32, Op::SubU32, Op::MulU32, Op::AddF32, Op::XorU32, Op::XorU64]), &args);
    if dice.roll(6) == 0 {
        let now = b.temporary();
        b.push(Inst::Intrinsic { dst: now, intrinsic: Intrinsic::Clock, args: [now; 4] });
        value = b.compute(Op::AddU32, &[value, now]);
    }
    if !is_function && dice.roll(2) == 0 {
        let of_instance = |offset| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset };
        let number = b.load(of_instance(80), Width::Word, OnFault::SkipStatement);
        let pointer = b.load(of_instance(96), Width::DoubleWord, OnFault::SkipStatement);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        let whole = Place::Crossing { pointer, offset: 32 * dice.roll(3) as u32 };
        let other = get(b, whole);
        value = b.compute(Op::XorU32, &[value, other]);
        if dice.roll(2) == 0 {
            b.store(whole, Width::DoubleWord, value);
        }
    }
    b.store(sum, Width::DoubleWord, value);
    b.begin_statement();
    let value = get(b, sum);
    let limit = dice.of(&[0, 100, 0x4000_0000]);
    let limit = b.constant(limit);
    let condition = b.compute(dice.of(&[Op::LtI32, Op::GtI32, Op::LtF32]), &[value, limit]);
    if !is_function {
        let bit = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 67 };
        b.store(bit, Width::Bit, condition);
        // More bits of the same byte, one of which is read.
        for offset in [64, 70].into_iter().take(dice.roll(3) as usize) {
            let other = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset };
            let before = b.load(other, Width::Bit, OnFault::SkipStatement);
            let after = b.compute(Op::Xor, &[before, condition]);
            b.store(other, Width::Bit, after);
        }
    }
    b.push(Inst::Branch { condition, to: Target(3) });
    match dice.roll(3) {
        0 => b.push(Inst::Jump { to: Target(2) }),
        // What is not jumped over in the same statement.
        1 => {
            let value = get(b, sum);
            let value = b.compute(Op::Shl16, &[value, limit]);
            b.store(sum, Width::DoubleWord, value);
        }
        _ => {}
    }
    b.begin_statement();
    let value = get(b, sum);
    let by = b.constant(dice.of(&[4, 16, 3]));
    let value = b.compute(dice.of(&[Op::DivI32, Op::RemI32, Op::AddU32]), &[value, by]);
    b.store(sum, Width::DoubleWord, value);
    if !is_function && dice.roll(2) == 0 {
        let bit = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 65 };
        let set = b.compute(Op::IsNonzero, &[value]);
        b.store(bit, Width::Bit, set);
    }
    b.begin_statement();
    if is_function {
        let value = get(b, sum);
        let place = parameter(b, 2);
        b.store(place, Width::DoubleWord, value);
    }
    let yes = b.constant(1);
    b.compute_into(Register::Br, Op::Copy, &[yes]);
}

fn layout(program: &sieben_engine::Program) -> Layout {
    let mut layout = noting::layout(program);
    for number in [1, 2] {
        layout.size += DATA_BYTES;
        layout.data_blocks.insert(number, layout.size - DATA_BYTES..layout.size);
    }
    layout
}

/// Changes a few bytes, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 3, 9, 17, 40, 100, 1000, 1000, 100_000]);
    if dice.roll(4) == 0 {
        let value = dice.of(&[0, 1, 2, 7, 0x7F, 0x80, 0xFF]);
        machine.memory.area_mut(Area::BitMemory)[VARIABLES as usize + dice.roll(56) as usize] = value;
    }
    Reaction::Continue
}

#[test]
fn iterations_that_nobody_looks_at_do_what_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[
            (block, 48, &|b| loops(b, seed)),
            (FUNCTION, 4, &|b| called(b, seed + 3_000_000, true)),
            (FUNCTION_BLOCK, 4, &|b| called(b, seed + 4_000_000, false)),
        ]);
        let layout = layout(&program);
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 5, 50, 1000, 1000, 100_000]);
            machine.clock_us = 1_234_567_890;
            machine.memory.area_mut(Area::BitMemory)[..256].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.of(&[0, 0x3F, 0x40, 0x7F, 0x80, 0xFF, 1, 0xC0]));
        };
        let outcome = |engine: Arc<dyn sieben_engine::Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("{seed}\n{}", program.code[&block].code));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 1_500 && finished > 150, "{asked} questions, {finished} runs to the end");
}
