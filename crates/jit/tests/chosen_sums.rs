//! Counted loops in which only some turns add to REALs and LREALs, or not all of them the same: whatever the numbers are, and whether they
//! are numbers at all, the loops do on all engines what the interpreter does.

use sieben_engine::Machine;
use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_from, counted, element_at, fixed, get, program};

const PROGRAMS: u64 = 400;
/// Memories from which each program runs.
const MEMORIES: u64 = 12;
/// Bytes of the array, which lies at the beginning of bit memory, and where flags and variables lie behind it.
const ARRAY_BYTES: u32 = 400;
const FLAGS: u32 = 500;
/// Bytes of a row of flags.
const ROW: u32 = 16;
const COUNTER: u32 = 600;
const SUMS: [u32; 2] = [616, 624];

/// What is added.
struct Kind {
    width: Width,
    add: Op,
    subtract: Op,
    multiply: Op,
    less: Op,
    special: &'static [u64],
}

const REAL: Kind = Kind {
    width: Width::DoubleWord,
    add: Op::AddF32,
    subtract: Op::SubF32,
    multiply: Op::MulF32,
    less: Op::LtF32,
    // Zeros of both signs, the least numbers, infinities, and several that are no number.
    special: &[0, 0x8000_0000, 1, 0x8000_0001, 0x7F80_0000, 0xFF80_0000, 0x7FC0_0000, 0x7F80_0001, 0xFFC1_2345],
};
const LREAL: Kind = Kind {
    width: Width::QuadWord,
    add: Op::AddF64,
    subtract: Op::SubF64,
    multiply: Op::MulF64,
    less: Op::LtF64,
    special: &[0, 1 << 63, 1, (1 << 63) + 1, 0x7FF0 << 48, 0xFFF0 << 48, 0x7FF8 << 48, 0x7FF0_0000_0000_0001, 0xFFF8_1234_5678_9ABC],
};

/// A condition.
#[derive(Clone, Copy)]
enum Condition {
    /// A bit that follows that of the turn before, in one of two rows, behind its first one.
    Flag(u32),
    /// Whether the element is below zero.
    Negative,
    /// Whether a sum is.
    SumNegative(u32),
}

/// One or more statements of a turn.
enum Part {
    Sum { sum: u32, op: Op, turned: bool, scaled: bool },
    If(Condition, Vec<Part>, Vec<Part>),
}

impl Part {
    fn random(dice: &mut Dice, kind: &Kind, depth: u32) -> Self {
        if depth > 0 && dice.roll(5) < 3 {
            let condition = match dice.roll(8) {
                0 => Condition::SumNegative(dice.of(&SUMS)),
                1 | 2 => Condition::Negative,
                _ => Condition::Flag(dice.roll(8) as u32 + dice.of(&[0, 8 * ROW])),
            };
            let yes = Self::some(dice, kind, depth - 1);
            let no = if dice.roll(3) == 0 { Self::some(dice, kind, depth - 1) } else { Vec::new() };
            return Self::If(condition, yes, no);
        }
        let op = match dice.roll(12) {
            0 => kind.multiply,
            1..=3 => kind.subtract,
            _ => kind.add,
        };
        let sum = SUMS[usize::from(dice.roll(5) == 0)];
        Self::Sum { sum, op, turned: dice.roll(3) == 0, scaled: dice.roll(3) == 0 }
    }

    fn some(dice: &mut Dice, kind: &Kind, depth: u32) -> Vec<Self> {
        (0..=dice.roll(2)).map(|_| Self::random(dice, kind, depth)).collect()
    }

    fn statements(&self) -> u32 {
        match self {
            Self::Sum { .. } => 1,
            Self::If(_, yes, no) => 1 + Self::all(yes) + u32::from(!no.is_empty()) + Self::all(no),
        }
    }

    fn all(parts: &[Self]) -> u32 {
        parts.iter().map(Self::statements).sum()
    }

    /// Writes it; what follows begins with the statement that is the result.
    fn write(&self, b: &mut Builder, kind: &Kind, first: u32) -> u32 {
        let behind = first + self.statements();
        b.begin_statement();
        match *self {
            Self::Sum { sum, op, turned, scaled } => {
                let (mut of, before) = (element_at(b, COUNTER, kind.width), get(b, sum, kind.width));
                if scaled {
                    of = b.compute(kind.multiply, &[of, of]);
                }
                let value = b.compute(op, &if turned { [of, before] } else { [before, of] });
                b.store(fixed(sum), kind.width, value);
            }
            Self::If(condition, ref yes, ref no) => {
                let condition = condition.write(b, kind);
                let otherwise = b.compute(Op::Not, &[condition]);
                let jumps = u32::from(!no.is_empty());
                let second = first + 1 + Self::all(yes) + jumps;
                b.push(Inst::Branch { condition: otherwise, to: Target(second) });
                yes.iter().fold(first + 1, |first, part| part.write(b, kind, first));
                if jumps == 1 {
                    b.begin_statement();
                    b.push(Inst::Jump { to: Target(behind) });
                }
                no.iter().fold(second, |first, part| part.write(b, kind, first));
            }
        }
        behind
    }
}

impl Condition {
    fn write(self, b: &mut Builder, kind: &Kind) -> Var {
        let number = match self {
            Self::Flag(first) => {
                let counter = get(b, COUNTER, Width::DoubleWord);
                let place = Place::Indirect { area: Area::BitMemory, pointer: counter, offset: 8 * FLAGS + first };
                return b.load(place, Width::Bit, OnFault::SkipStatement);
            }
            Self::Negative => element_at(b, COUNTER, kind.width),
            Self::SumNegative(sum) => get(b, sum, kind.width),
        };
        let zero = b.constant(0);
        b.compute(kind.less, &[number, zero])
    }
}

/// A loop of some parts.
fn looping(b: &mut Builder, kind: &Kind, last: u64, parts: &[Part]) {
    counted(b, COUNTER, last, |b| parts.iter().fold(1, |first, part| part.write(b, kind, first)));
}

/// Fills the array and the variables with numbers, some of them special.
fn fill(machine: &mut Machine, kind: &Kind, seed: u64) {
    let mut dice = Dice(seed);
    machine.budget = dice.of(&[1, 5, 20, 50, 1000, 100_000]);
    let bytes = kind.width.bytes() as usize;
    let [of_elements, of_sums] = [dice.of(&[0, 1, 2, 40]), dice.of(&[0, 1, 3])];
    let number = |dice: &mut Dice, chance: u64| {
        let value = match dice.roll(40) {
            roll if roll < chance => dice.of(kind.special),
            _ if bytes == 4 => 0x3F80_0000 + dice.roll(1 << 24) + (dice.roll(2) << 31),
            _ => (0x3FF0 << 48) + (dice.roll(1 << 31) << 21) + (dice.roll(2) << 63),
        };
        value.to_be_bytes()[8 - bytes..].to_vec()
    };
    let memory = machine.memory.area_mut(Area::BitMemory);
    for at in (0..ARRAY_BYTES as usize).step_by(bytes) {
        memory[at..at + bytes].copy_from_slice(&number(&mut dice, of_elements));
    }
    for at in SUMS.map(|byte| byte as usize) {
        memory[at..at + bytes].copy_from_slice(&number(&mut dice, 12 * of_sums));
    }
    // A condition holds in all turns, or in none, or in some.
    for row in [FLAGS, FLAGS + ROW] {
        memory[row as usize..(row + ROW) as usize].fill(dice.of(&[0, 0xFF, 0x55, 0x13]));
    }
}

#[test]
fn sums_of_some_turns_are_those_of_the_interpreter() {
    let mut silent = 0;
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed);
        let kind = if dice.roll(4) == 0 { LREAL } else { REAL };
        let parts = Part::some(&mut dice, &kind, 3);
        let elements = u64::from(ARRAY_BYTES / kind.width.bytes());
        let last = dice.of(&[0, 3, 7, 16, 30, elements - 1]);
        let program = program(&[(BlockId::ob(1), 16, &|b| looping(b, &kind, last, &parts))]);
        let prepare = |machine: &mut Machine, memory: u64| fill(machine, &kind, seed + 1_000_000 + (memory << 32));
        silent += all_engines_agree_from((&program, &noting::layout(&program)), MEMORIES, &prepare, &seed.to_string());
    }
    assert!(silent > 1_000, "{silent} runs in which nobody was asked");
}

/// Whether a sum of a loop has to be a number when it begins: nothing else in a loop is written with this comparison.
fn looks_whether_it_is_a_number(parts: &[Part]) -> bool {
    let program = program(&[(BlockId::ob(1), 16, &|b| looping(b, &REAL, 30, parts))]);
    let listing = Jit::listing(&program, &noting::layout(&program)).expect("machine code");
    listing.lines().any(|line| line.contains("fcmp") && line.contains(" ord "))
}

#[test]
fn what_some_turns_add_is_added_in_each_turn() {
    let sum = |op: Op| vec![Part::Sum { sum: SUMS[0], op, turned: false, scaled: false }];
    let flag = Condition::Flag(0);
    assert!(looks_whether_it_is_a_number(&[Part::If(flag, sum(Op::AddF32), Vec::new())]));
    assert!(looks_whether_it_is_a_number(&[Part::If(flag, Vec::new(), sum(Op::SubF32))]));
    let inside = Part::If(Condition::Negative, sum(Op::AddF32), Vec::new());
    assert!(looks_whether_it_is_a_number(&[Part::If(
        flag,
        [sum(Op::AddF32), vec![inside]].into_iter().flatten().collect(),
        sum(Op::AddF32)
    )]));
    let inside = Part::If(Condition::Negative, sum(Op::AddF32), Vec::new());
    assert!(looks_whether_it_is_a_number(&[Part::If(flag, vec![inside], sum(Op::AddF32))]));
    // Each turn adds something.
    assert!(!looks_whether_it_is_a_number(&[Part::If(flag, sum(Op::AddF32), sum(Op::AddF32))]));
    assert!(!looks_whether_it_is_a_number(&[Part::If(flag, sum(Op::AddF32), sum(Op::SubF32))]));
    // What is added depends on the sum.
    assert!(!looks_whether_it_is_a_number(&[Part::If(Condition::SumNegative(SUMS[0]), sum(Op::AddF32), Vec::new())]));
    assert!(!looks_whether_it_is_a_number(&[Part::If(flag, sum(Op::MulF32), Vec::new())]));
}
