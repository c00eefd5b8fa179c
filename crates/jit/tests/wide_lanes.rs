//! Counted loops over arrays of LREAL, LINT, REAL, DINT and INT that convert into one another, and whose inner loops add up in elements of
//! arrays: whatever they compute and whenever the budget ends, machine code does what the interpreter does.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Entry, Exit, FaultPlace, Layout, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

/// Programs that are compared.
const PROGRAMS: u64 = 500;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Bytes of an array, and how many there are.
const ARRAY_BYTES: u32 = 560;
const ARRAYS: u32 = 4;
/// Where the variables lie in bit memory.
const VARIABLES: u32 = 100;

/// What a number is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Lreal,
    Quad,
    Real,
    Double,
    Half,
}

use Kind::{Double, Half, Lreal, Quad, Real};

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, program, run};

impl Kind {
    const ALL: [Self; 7] = [Lreal, Lreal, Lreal, Quad, Real, Double, Half];

    fn width(self) -> Width {
        match self {
            Lreal | Quad => Width::QuadWord,
            Real | Double => Width::DoubleWord,
            Half => Width::Word,
        }
    }

    fn comparisons(self) -> &'static [Op] {
        match self {
            Lreal => &[Op::EqF64, Op::DifferF64, Op::LtF64, Op::LeF64, Op::GtF64, Op::GeF64],
            Quad => &[Op::Equal, Op::Differ, Op::LtI64, Op::LeI64, Op::GtI64, Op::GeI64, Op::Below],
            Real => &[Op::LtF32, Op::GeF32, Op::DifferF32],
            Double => &[Op::LtI32, Op::GeI32, Op::Equal, Op::Below],
            Half => &[Op::LtI16, Op::GeI16],
        }
    }

    fn operations(self) -> &'static [Op] {
        match self {
            Lreal => &[Op::AddF64, Op::SubF64, Op::MulF64, Op::DivF64, Op::MinF64, Op::MaxF64],
            Quad => &[Op::AddU64, Op::SubU64, Op::MulU64, Op::AndU64, Op::OrU64, Op::XorU64, Op::MinI64],
            Real => &[Op::AddF32, Op::SubF32, Op::MulF32, Op::DivF32, Op::MinF32, Op::MaxF32],
            Double => &[Op::AddU32, Op::SubU32, Op::MulU32, Op::XorU32, Op::MinI32],
            Half => &[Op::AddU16, Op::SubU16, Op::MulU16],
        }
    }

    fn of_one(self) -> &'static [Op] {
        match self {
            Lreal => &[Op::NegF64, Op::AbsF64, Op::SqrtF64, Op::RoundF64, Op::CeilF64, Op::FloorF64, Op::TruncF64],
            Quad => &[Op::NotU64, Op::NegI64],
            Real => &[Op::NegF32, Op::AbsF32, Op::RoundF32, Op::CeilF32, Op::FloorF32, Op::TruncF32],
            Double => &[Op::NegI32],
            Half => &[Op::Low16],
        }
    }

    /// How a number of this kind comes from one of another.
    fn conversions(self) -> &'static [(Kind, &'static [Op])] {
        match self {
            Lreal => &[
                (Double, &[Op::I32ToF64]),
                (Double, &[Op::ExtendI32I64, Op::I64ToF64]),
                (Half, &[Op::ExtendI16I64, Op::I64ToF64]),
                (Quad, &[Op::I64ToF64]),
                (Real, &[Op::F32ToF64]),
                (Real, &[Op::F32ToF64, Op::FloorF64]),
            ],
            Quad => &[
                (Double, &[Op::ExtendI32I64]),
                (Double, &[]),
                (Half, &[]),
                (Half, &[Op::ExtendI16I64]),
                (Lreal, &[Op::F64ToI64]),
                (Lreal, &[]),
            ],
            Real => &[(Lreal, &[Op::F64ToF32]), (Double, &[Op::I32ToF32]), (Half, &[Op::ExtendI16I64, Op::I64ToF32])],
            Double => &[
                (Lreal, &[Op::RoundF64, Op::F64ToI32]),
                (Real, &[Op::F32ToF64, Op::RoundF64, Op::F64ToI32]),
                (Real, &[Op::F32ToF64, Op::TruncF64, Op::F64ToI32]),
                (Real, &[Op::F32ToF64, Op::TruncF64, Op::F64ToU16]),
                (Quad, &[Op::Low32]),
                (Half, &[Op::Extend16]),
            ],
            Half => &[(Double, &[Op::Low16]), (Real, &[Op::F32ToF64, Op::CeilF64, Op::F64ToI16]), (Lreal, &[Op::F64ToI16])],
        }
    }
}

/// A program in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    /// Counters of the loops, the outermost first.
    counters: Vec<Place>,
    /// Whether iterations of the outer loop hardly depend on one another.
    smooth: bool,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn load(&mut self, place: Place, width: Width) -> Var {
        self.b.load(place, width, OnFault::SkipStatement)
    }

    /// A variable: of each kind there are two, which share no bytes with others, but for one in a while.
    fn variable(&mut self, kind: Kind) -> Place {
        let number = 2 * (kind as u32) + self.dice.roll(2) as u32;
        let shifted = if self.dice.roll(24) == 0 { 4 } else { 0 };
        Place::Fixed { area: Area::BitMemory, position: 8 * (VARIABLES + 8 * number + shifted) }
    }

    /// An element of an array: mostly one that follows the innermost counter, or only the one around it.
    fn element(&mut self, kind: Kind, array: u32, fixed: bool) -> Place {
        let bits = u64::from(kind.width().bits());
        let mut pointer: Option<Var> = None;
        let counters = self.counters.clone();
        let count = if fixed { counters.len() - 1 } else { counters.len() };
        for (depth, &counter) in counters[..count].iter().enumerate().rev() {
            let innermost = depth + 1 == count;
            if !innermost && !fixed && !self.smooth && self.dice.roll(2) == 0 {
                continue;
            }
            let number = self.load(counter, Width::DoubleWord);
            let times = if self.smooth {
                if depth == 0 { 1 } else { 8 }
            } else if innermost {
                self.dice.of(&[1, 1, 1, 1, 2, 5])
            } else {
                self.dice.of(&[1, 5])
            };
            let step = self.b.constant(bits * times);
            let part = self.b.compute(Op::MulU32, &[number, step]);
            pointer = Some(pointer.map_or(part, |before| self.b.compute(Op::AddU32, &[before, part])));
        }
        let pointer = match pointer {
            Some(pointer) => pointer,
            None => self.b.constant(0),
        };
        let jitter = if !self.smooth && self.dice.roll(10) == 0 { 8 * self.dice.roll(30) as u32 } else { 0 };
        Place::Indirect { area: Area::SharedData, pointer, offset: 8 * ARRAY_BYTES * array + jitter }
    }

    fn condition(&mut self) -> Var {
        let kind = self.dice.of(&Kind::ALL);
        let args = [self.value(kind, 0), self.value(kind, 0)];
        let condition = self.b.compute(self.dice.of(kind.comparisons()), &args);
        if self.dice.roll(3) != 0 {
            return condition;
        }
        let kind = self.dice.of(&Kind::ALL);
        let args = [self.value(kind, 0), self.value(kind, 0)];
        let other = self.b.compute(self.dice.of(kind.comparisons()), &args);
        let op = self.dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]);
        self.b.compute(op, &[condition, other])
    }

    fn value(&mut self, kind: Kind, depth: u64) -> Var {
        if depth == 0 {
            return match self.dice.roll(8) {
                0 => {
                    let lreals = [0, 0x3FF0_0000_0000_0000, 0x4059_0000_0000_0000, 0x7FF8_0000_0000_0001, 0x8000_0000_0000_0000];
                    let others = [0, 1, 3, 0x3F80_0000, 0x7FC0_0001, 0xFFFF_FFFF];
                    let value = if kind.width() == Width::QuadWord { self.dice.of(&lreals) } else { self.dice.of(&others) };
                    self.b.constant(if kind == Half { value & 0xFFFF } else { value })
                }
                1 => {
                    let place = self.variable(kind);
                    self.load(place, kind.width())
                }
                2 if kind == Double => {
                    let counter = self.counters[self.counters.len() - 1];
                    self.load(counter, Width::DoubleWord)
                }
                _ => {
                    let array = self.dice.roll(if self.smooth { 2 } else { u64::from(ARRAYS) }) as u32;
                    let place = self.element(kind, array, false);
                    self.load(place, kind.width())
                }
            };
        }
        match self.dice.roll(8) {
            0 | 1 => {
                let (from, ops) = self.dice.of(kind.conversions());
                let value = self.value(from, depth - 1);
                ops.iter().fold(value, |value, &op| self.b.compute(op, &[value]))
            }
            2 => {
                let value = self.value(kind, depth - 1);
                let op = self.dice.of(kind.of_one());
                self.b.compute(op, &[value])
            }
            3 => {
                let condition = self.condition();
                let value = self.value(kind, depth - 1);
                if self.dice.roll(3) == 0 {
                    return self.b.compute(Op::Gate, &[value, condition]);
                }
                let other = self.value(kind, 0);
                self.b.compute(Op::Select, &[condition, value, other])
            }
            _ => {
                let args = [self.value(kind, depth - 1), self.value(kind, 0)];
                let op = self.dice.of(kind.operations());
                self.b.compute(op, &args)
            }
        }
    }

    /// A statement of an iteration.
    fn statement(&mut self) {
        self.begin();
        let kind = self.dice.of(&Kind::ALL);
        let value = self.value(kind, self.dice.0 % 3);
        match self.dice.roll(8) {
            0 if !self.smooth => {
                let place = self.variable(kind);
                self.b.store(place, kind.width(), value);
            }
            // A sum, in a variable or in an element that all iterations of the innermost loop share.
            1..4 if !self.smooth || self.counters.len() > 1 => {
                let place = match self.dice.roll(3) {
                    0 if !self.smooth => self.variable(kind),
                    _ => self.element(kind, 3, true),
                };
                let before = self.load(place, kind.width());
                let op = kind.operations()[self.dice.roll(3) as usize];
                let after = self.b.compute(op, &[before, value]);
                self.b.store(place, kind.width(), after);
            }
            _ => {
                let place = self.element(kind, 2, false);
                self.b.store(place, kind.width(), value);
            }
        }
    }

    fn statements(&mut self) {
        for _ in 0..1 + self.dice.roll(2) {
            if self.dice.roll(4) == 0 {
                self.begin();
                let condition = self.condition();
                self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
            }
            self.statement();
        }
    }

    /// A loop, with another one in it as often as not.
    fn counted(&mut self) {
        let depth = self.counters.len() as u32;
        let counter = Place::Fixed { area: Area::BitMemory, position: 8 * (VARIABLES + 100 + 4 * depth) };
        let inner = depth == 0 && self.dice.roll(2) == 0;
        let iterations = if depth == 0 { self.dice.of(&[1, 4, 7, 8, 9, 16, 20, 25]) } else { self.dice.of(&[1, 2, 4, 5, 9]) };
        self.begin();
        let zero = self.b.constant(0);
        self.b.store(counter, Width::DoubleWord, zero);
        self.counters.push(counter);
        let head = self.statements;
        if !inner || self.dice.roll(2) == 0 {
            self.statements();
        }
        if inner {
            self.counted();
            if self.dice.roll(2) == 0 {
                self.statements();
            }
        }
        self.begin();
        let number = self.load(counter, Width::DoubleWord);
        let one = self.b.constant(1);
        let next = self.b.compute(Op::AddU32, &[number, one]);
        self.b.store(counter, Width::DoubleWord, next);
        let limit = self.b.constant(iterations - 1);
        let condition = self.b.compute(Op::LeI32, &[next, limit]);
        self.b.push(Inst::Branch { condition, to: Target(head) });
        self.counters.pop();
    }
}

fn loops(b: &mut Builder, seed: u64) {
    let mut maker = Maker { b, dice: Dice(seed), statements: 0, counters: Vec::new(), smooth: !seed.is_multiple_of(3) };
    maker.begin();
    let number = maker.b.constant(1);
    maker.b.push(Inst::Open { register: DataRegister::Shared, number });
    for _ in 0..1 + maker.dice.roll(2) {
        maker.counted();
    }
    maker.begin();
    let done = maker.b.constant(1);
    maker.b.compute_into(Register::Br, Op::Copy, &[done]);
    maker.begin();
    maker.b.push(Inst::Return);
}

#[test]
fn iterations_with_wide_numbers_do_what_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| loops(b, seed))]);
        let mut layout: Layout = noting::layout(&program);
        let bytes = (ARRAYS * ARRAY_BYTES + 300) as usize;
        layout.size += bytes;
        layout.data_blocks.insert(1, layout.size - bytes..layout.size);
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 7, 50, 1000, 1000, 100_000]);
            // Numbers of a usual size, and some that are none.
            let odd = dice.roll(3) == 0;
            let mut fill = |bytes: &mut [u8]| {
                for eight in bytes.chunks_mut(8) {
                    let mut value = f64::from(dice.roll(2000) as f32 / 8.0 - 100.0).to_bits();
                    if odd || dice.roll(12) == 0 {
                        value = u64::from_be_bytes([0; 8].map(|_: u8| dice.of(&[0, 0x3F, 0x7F, 0xF0, 0xFF, 1])));
                    }
                    eight.copy_from_slice(&value.to_be_bytes()[..eight.len()]);
                }
            };
            fill(&mut machine.memory.area_mut(Area::BitMemory)[..256]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            fill(&mut machine.memory.arena[range]);
        };
        let outcome = |engine: Arc<dyn sieben_engine::Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| {
                if asked >= QUESTIONS_MAX {
                    return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
                }
                machine.budget = dice.borrow_mut().of(&[0, 1, 5, 17, 40, 100, 1000, 100_000]);
                Reaction::Continue
            };
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let expected =
            all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", program.code[&block].code));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 200 && finished > 120, "{asked} questions, {finished} runs to the end");
}
