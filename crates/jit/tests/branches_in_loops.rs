//! Counted loops whose iterations go different ways: with much to do on one of them, places that are written on one only, the greatest
//! number and where it was, and what the last iteration left that went there. Whatever the numbers are, the loops do on all engines what
//! the interpreter does.

use sieben_engine::Machine;
use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_from, counted, fixed, get, program};

const PROGRAMS: u64 = 350;
/// Memories from which each program runs.
const MEMORIES: u64 = 10;
/// Rows of double words at the beginning of bit memory, of so many each, and where bits and variables lie behind them.
const ROWS: u32 = 3;
const ELEMENTS: u32 = 40;
const FLAGS: u32 = 500;
const COUNTER: u32 = 600;
const DOUBLES: [u32; 2] = [616, 620];
/// What no iteration reads: the last one that writes them leaves it.
const LEFT: [u32; 4] = [624, 644, 648, 652];
const REALS: [u32; 2] = [628, 632];
const WORDS: [u32; 2] = [636, 638];
const BITS: [u32; 3] = [8 * 640, 8 * 640 + 1, 8 * 641];

fn element(row: u32, b: &mut Builder) -> Place {
    let counter = get(b, COUNTER, Width::DoubleWord);
    let bits = b.constant(32);
    let pointer = b.compute(Op::MulU32, &[counter, bits]);
    Place::Indirect { area: Area::BitMemory, pointer, offset: 32 * ELEMENTS * row }
}

fn bit(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

/// A number that a statement calculates with.
#[derive(Clone, Copy)]
enum From {
    Element(u32),
    Variable(u32),
    Counter,
    Constant(u64),
}

impl From {
    fn random(dice: &mut Dice) -> Self {
        match dice.roll(8) {
            0..=2 => Self::Element(dice.roll(ROWS.into()) as u32),
            3 | 4 => Self::Variable(dice.of(&DOUBLES)),
            5 => Self::Counter,
            _ => Self::Constant(dice.of(&[0, 1, 3, 0xFFFF_FFFF])),
        }
    }

    fn read(self, b: &mut Builder) -> Var {
        match self {
            Self::Element(row) => {
                let place = element(row, b);
                b.load(place, Width::DoubleWord, OnFault::SkipStatement)
            }
            Self::Variable(byte) => get(b, byte, Width::DoubleWord),
            Self::Counter => get(b, COUNTER, Width::DoubleWord),
            Self::Constant(value) => b.constant(value),
        }
    }
}

#[derive(Clone, Copy)]
enum Condition {
    /// A bit that follows that of the iteration before.
    Flag,
    Bit(u32),
    Compared(Op, From, From),
    Real(u32, u32),
    /// Both, or one of them.
    Joined(Op, [(Op, From, From); 2]),
}

impl Condition {
    fn random(dice: &mut Dice) -> Self {
        let compared = |dice: &mut Dice| (dice.of(&[Op::LtI32, Op::GtI32, Op::EqI32, Op::GeI32]), From::random(dice), From::random(dice));
        match dice.roll(8) {
            0..=2 => Self::Flag,
            3 => Self::Bit(dice.of(&BITS)),
            4 => Self::Real(dice.roll(ROWS.into()) as u32, dice.of(&REALS)),
            5 => Self::Joined(dice.of(&[Op::And, Op::Or]), [compared(dice), compared(dice)]),
            _ => {
                let (op, a, b) = compared(dice);
                Self::Compared(op, a, b)
            }
        }
    }

    fn write(self, b: &mut Builder) -> Var {
        let compared = |(op, first, second): (Op, From, From), b: &mut Builder| {
            let (first, second) = (first.read(b), second.read(b));
            b.compute(op, &[first, second])
        };
        match self {
            Self::Flag => {
                let pointer = get(b, COUNTER, Width::DoubleWord);
                let place = Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * FLAGS };
                b.load(place, Width::Bit, OnFault::SkipStatement)
            }
            Self::Bit(position) => b.load(bit(position), Width::Bit, OnFault::SkipStatement),
            Self::Compared(op, first, second) => compared((op, first, second), b),
            Self::Real(row, variable) => {
                let (of, than) = (From::Element(row).read(b), get(b, variable, Width::DoubleWord));
                b.compute(Op::GtF32, &[of, than])
            }
            Self::Joined(op, [first, second]) => {
                let (first, second) = (compared(first, b), compared(second, b));
                b.compute(op, &[first, second])
            }
        }
    }
}

/// One or more statements of an iteration.
enum Part {
    Keep(u32, From),
    Add(u32, Op, From),
    Word(u32, Op, From),
    Real(u32, Option<Op>, u32),
    Bit(u32, Condition),
    Element(u32, Op, From, From),
    If(Condition, Vec<Part>, Vec<Part>),
}

impl Part {
    fn random(dice: &mut Dice, depth: u32) -> Self {
        if depth > 0 && dice.roll(2) == 0 {
            let condition = Condition::random(dice);
            let yes = Self::some(dice, depth - 1, 4);
            let no = if dice.roll(3) == 0 { Self::some(dice, depth - 1, 2) } else { Vec::new() };
            return Self::If(condition, yes, no);
        }
        let op = dice.of(&[Op::AddU32, Op::AddU32, Op::SubU32, Op::MulU32, Op::XorU64]);
        match dice.roll(12) {
            0..=2 => Self::Keep(dice.of(&DOUBLES), From::random(dice)),
            3 | 4 => Self::Add(dice.of(&DOUBLES), op, From::random(dice)),
            5 => Self::Word(dice.of(&WORDS), dice.of(&[Op::AddU16, Op::SubU16]), From::random(dice)),
            6 => Self::Real(dice.of(&REALS), dice.of(&[None, Some(Op::AddF32), Some(Op::MulF32)]), dice.roll(ROWS.into()) as u32),
            7 => Self::Bit(dice.of(&BITS), Condition::random(dice)),
            _ => Self::Element(dice.roll(ROWS.into()) as u32, op, From::random(dice), From::random(dice)),
        }
    }

    fn some(dice: &mut Dice, depth: u32, most: u64) -> Vec<Self> {
        (0..=dice.roll(most)).map(|_| Self::random(dice, depth)).collect()
    }

    fn statements(&self) -> u32 {
        match self {
            Self::If(_, yes, no) => 1 + Self::all(yes) + u32::from(!no.is_empty()) + Self::all(no),
            _ => 1,
        }
    }

    fn all(parts: &[Self]) -> u32 {
        parts.iter().map(Self::statements).sum()
    }

    /// Writes it; what follows begins with the statement that is the result.
    fn write(&self, b: &mut Builder, first: u32) -> u32 {
        let behind = first + self.statements();
        b.begin_statement();
        match *self {
            Self::Keep(to, from) => {
                let value = from.read(b);
                b.store(fixed(to), Width::DoubleWord, value);
            }
            Self::Add(to, op, from) => {
                let (before, other) = (get(b, to, Width::DoubleWord), from.read(b));
                let value = b.compute(op, &[before, other]);
                b.store(fixed(to), Width::DoubleWord, value);
            }
            Self::Word(to, op, from) => {
                let (before, other) = (get(b, to, Width::Word), from.read(b));
                let value = b.compute(op, &[before, other]);
                b.store(fixed(to), Width::Word, value);
            }
            Self::Real(to, op, row) => {
                let mut value = From::Element(row).read(b);
                if let Some(op) = op {
                    let before = get(b, to, Width::DoubleWord);
                    value = b.compute(op, &[before, value]);
                }
                b.store(fixed(to), Width::DoubleWord, value);
            }
            Self::Bit(to, condition) => {
                let value = condition.write(b);
                b.store(bit(to), Width::Bit, value);
            }
            Self::Element(row, op, one, other) => {
                let (one, other) = (one.read(b), other.read(b));
                let value = b.compute(op, &[one, other]);
                let to = element(row, b);
                b.store(to, Width::DoubleWord, value);
            }
            Self::If(condition, ref yes, ref no) => {
                let condition = condition.write(b);
                let otherwise = b.compute(Op::Not, &[condition]);
                let jumps = u32::from(!no.is_empty());
                let second = first + 1 + Self::all(yes) + jumps;
                b.push(Inst::Branch { condition: otherwise, to: Target(second) });
                yes.iter().fold(first + 1, |first, part| part.write(b, first));
                if jumps == 1 {
                    b.begin_statement();
                    b.push(Inst::Jump { to: Target(behind) });
                }
                no.iter().fold(second, |first, part| part.write(b, first));
            }
        }
        behind
    }
}

fn looping(b: &mut Builder, last: u64, parts: &[Part]) {
    counted(b, COUNTER, last, |b| parts.iter().fold(1, |first, part| part.write(b, first)));
}

/// Fills the rows and the variables, mostly with small numbers.
fn fill(machine: &mut Machine, seed: u64) {
    let mut dice = Dice(seed);
    machine.budget = dice.of(&[1, 5, 20, 50, 1000, 100_000]);
    let memory = machine.memory.area_mut(Area::BitMemory);
    let kinds = dice.of(&[0, 1, 2]);
    for at in (0..700).step_by(4) {
        let value: u64 = match dice.roll(4) + kinds {
            0 | 1 => dice.roll(8),
            2 => dice.roll(200),
            3 => 0x3F80_0000 + dice.roll(1 << 24),
            _ => dice.of(&[0, 0x8000_0000, 0x7FFF_FFFF, 0xFFFF_FFFF, 0x7FC0_0000, 0x8000]),
        };
        memory[at..at + 4].copy_from_slice(&(value as u32).to_be_bytes());
    }
    memory[FLAGS as usize..FLAGS as usize + 16].fill(dice.of(&[0, 0xFF, 0x55, 0x13, 0x80]));
}

#[test]
fn iterations_that_part_do_what_the_interpreter_does() {
    let mut silent = 0;
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed);
        let mut parts = Part::some(&mut dice, 3, 4);
        if dice.roll(2) == 0 {
            let left = LEFT.map(|to| Part::Keep(to, From::random(&mut dice)));
            let at = dice.roll(1 + parts.len() as u64) as usize;
            parts.insert(at, Part::If(Condition::random(&mut dice), left.into(), Vec::new()));
        }
        let last = dice.of(&[0, 3, 7, 16, 30, u64::from(ELEMENTS) - 1]);
        let program = program(&[(BlockId::ob(1), 16, &|b| looping(b, last, &parts))]);
        let prepare = |machine: &mut Machine, memory: u64| fill(machine, seed + 1_000_000 + (memory << 32));
        silent += all_engines_agree_from((&program, &noting::layout(&program)), MEMORIES, &prepare, &seed.to_string());
    }
    assert!(silent > 500, "{silent} runs in which nobody was asked");
}
