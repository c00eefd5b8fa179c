//! Counted loops over records in which most of an iteration rests on one condition, made of the number of the iteration or asking for the
//! state of the record: whether it holds in all vectorized iterations, in none, or in some, they do on all engines what the interpreter
//! does.

use sieben_engine::Machine;
use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_from, counted, fixed, get, program};

const PROGRAMS: u64 = 250;
/// Memories from which each program runs.
const MEMORIES: u64 = 12;
/// Records, which begin behind one that no iteration has as its own, and their bytes.
const FIRST: u32 = 64;
const RECORD: u32 = 32;
const RECORDS: u32 = 24;
/// Where the fields lie: REALs, numbers, the state as two numbers, and the byte with bits.
const REALS: [u32; 3] = [0, 8, 20];
const DOUBLES: [u32; 2] = [4, 24];
const HALF_STATE: u32 = 12;
const STATE: u32 = 16;
const BITS: u32 = 14;
/// Variables behind the records.
const COUNTER: u32 = 1_000;
const SCAN: u32 = 1_004;
const COUNTS: [u32; 2] = [1_008, 1_012];
const TOTAL: u32 = 1_016;
const LAST: u32 = 1_020;
const LAST_BIT: u32 = 1_024;
/// REALs that follow one another.
const ROW: u32 = 1_040;

/// What decides.
#[derive(Clone, Copy)]
enum Condition {
    /// Whether the number of the iteration and the scan leave less than the second number when they are divided by the first one.
    Period(u64, u64),
    /// Whether the state, as a number of 16 or of 32 bits, is this one.
    HalfState(u64),
    State(u64),
    /// The same, as it is.
    WholeState(u64),
    /// Whether it is another one.
    OtherState(u64),
    /// A part of a state and a period.
    Both(u64, u64),
}

/// One or more statements of an iteration.
enum Part {
    /// Something is written, as the numbers say.
    Write(u64),
    /// A number becomes the state of the next record.
    NextState,
    If(Condition, bool, Vec<Part>, Vec<Part>),
}

fn writes(dice: &mut Dice, least: u64) -> Vec<Part> {
    (0..least + dice.roll(4)).map(|_| Part::Write(dice.roll(1 << 30))).collect()
}

impl Condition {
    fn random(dice: &mut Dice) -> Self {
        match dice.roll(7) {
            6 => Self::WholeState(dice.of(&[0, 1, 2])),
            0 | 1 => Self::Period(dice.of(&[8, 9, 16, 40, 100]), dice.of(&[1, 4, 8, 20])),
            2 => Self::HalfState(dice.of(&[0, 1, 2])),
            3 => Self::State(dice.of(&[0, 1, 2])),
            4 => Self::OtherState(dice.of(&[0, 1, 2])),
            _ => Self::Both(dice.of(&[16, 40]), dice.of(&[4, 8, 20])),
        }
    }

    fn write(self, b: &mut Builder) -> Var {
        let period = |b: &mut Builder, modulus: u64, limit: u64| {
            let parts = [get(b, COUNTER, Width::DoubleWord), get(b, SCAN, Width::DoubleWord)];
            let sum = b.compute(Op::AddU32, &parts);
            let parts = [sum, b.constant(modulus)];
            let rest = b.compute(Op::RemI32, &parts);
            let parts = [rest, b.constant(limit)];
            b.compute(Op::LtI32, &parts)
        };
        match self {
            Self::Period(modulus, limit) => period(b, modulus, limit),
            Self::HalfState(state) => {
                let parts = [field(b, HALF_STATE, Width::Word), b.constant(state)];
                b.compute(Op::EqI16, &parts)
            }
            Self::State(state) => {
                let parts = [field(b, STATE, Width::DoubleWord), b.constant(state)];
                b.compute(Op::EqI32, &parts)
            }
            Self::WholeState(state) => {
                let parts = [field(b, STATE, Width::DoubleWord), b.constant(state)];
                b.compute(Op::Equal, &parts)
            }
            Self::OtherState(state) => {
                let parts = [field(b, STATE, Width::DoubleWord), b.constant(state)];
                b.compute(Op::NeI32, &parts)
            }
            Self::Both(modulus, limit) => {
                let parts = [period(b, modulus, limit), period(b, 2 * modulus, 2 * limit)];
                b.compute(Op::And, &parts)
            }
        }
    }
}

fn place_of(b: &mut Builder, byte: u32, bit: u32, records: i32) -> Place {
    let counter = get(b, COUNTER, Width::DoubleWord);
    let bits = b.constant(u64::from(8 * RECORD));
    let pointer = b.compute(Op::MulU32, &[counter, bits]);
    let offset = (8 * (FIRST + byte) + bit) as i32 + 8 * records * RECORD as i32;
    Place::Indirect { area: Area::BitMemory, pointer, offset: offset as u32 }
}

/// A field of the record of the iteration.
fn field(b: &mut Builder, byte: u32, width: Width) -> Var {
    let place = place_of(b, byte, 0, 0);
    b.load(place, width, OnFault::SkipStatement)
}

fn row(b: &mut Builder) -> Place {
    let counter = get(b, COUNTER, Width::DoubleWord);
    let bits = b.constant(32);
    let pointer = b.compute(Op::MulU32, &[counter, bits]);
    Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * ROW }
}

fn real(b: &mut Builder, dice: &mut Dice, depth: u32) -> Var {
    match dice.roll(if depth == 0 { 4 } else { 10 }) {
        0..=2 => field(b, dice.of(&REALS), Width::DoubleWord),
        3 => match dice.roll(2) {
            0 => {
                let place = row(b);
                b.load(place, Width::DoubleWord, OnFault::SkipStatement)
            }
            _ => b.constant(u64::from(dice.of(&[0.5_f32, 3.0, -1.0, 1e30]).to_bits())),
        },
        _ => {
            let op = dice.of(&[Op::AddF32, Op::SubF32, Op::MulF32, Op::DivF32, Op::MinF32, Op::MaxF32]);
            let parts = [real(b, dice, depth - 1), real(b, dice, depth - 1)];
            b.compute(op, &parts)
        }
    }
}

fn double(b: &mut Builder, dice: &mut Dice, depth: u32) -> Var {
    match dice.roll(if depth == 0 { 4 } else { 9 }) {
        0 | 1 => field(b, dice.of(&DOUBLES), Width::DoubleWord),
        2 => field(b, STATE, Width::DoubleWord),
        3 => b.constant(dice.of(&[1, 7, 100])),
        // A REAL that is cut.
        4 | 5 => {
            let number = real(b, dice, depth - 1);
            let wide = b.compute(Op::F32ToF64, &[number]);
            let whole = b.compute(Op::TruncF64, &[wide]);
            b.compute(Op::F64ToI32, &[whole])
        }
        _ => {
            let op = dice.of(&[Op::AddU32, Op::SubU32, Op::XorU32, Op::MinI32]);
            let parts = [double(b, dice, depth - 1), double(b, dice, depth - 1)];
            b.compute(op, &parts)
        }
    }
}

fn bit(b: &mut Builder, dice: &mut Dice, depth: u32) -> Var {
    match dice.roll(4) {
        0 => {
            let place = place_of(b, BITS, dice.roll(3) as u32, 0);
            b.load(place, Width::Bit, OnFault::SkipStatement)
        }
        1 if depth > 0 => {
            let parts = [bit(b, dice, depth - 1), bit(b, dice, depth - 1)];
            b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &parts)
        }
        2 => {
            let parts = [double(b, dice, 0), double(b, dice, 0)];
            b.compute(dice.of(&[Op::LtI32, Op::GeI32, Op::EqI32, Op::NeI32]), &parts)
        }
        _ => {
            let parts = [real(b, dice, 1), real(b, dice, 1)];
            b.compute(dice.of(&[Op::LtF32, Op::GeF32]), &parts)
        }
    }
}

fn write(b: &mut Builder, mut dice: Dice, inside: bool) {
    let dice = &mut dice;
    let (place, width, value) = match dice.roll(20) {
        0..=8 => (place_of(b, dice.of(&REALS), 0, 0), Width::DoubleWord, real(b, dice, 2)),
        9 => (row(b), Width::DoubleWord, real(b, dice, 2)),
        10 | 11 => (place_of(b, dice.of(&DOUBLES), 0, 0), Width::DoubleWord, double(b, dice, 2)),
        12 | 13 => (place_of(b, BITS, dice.roll(3) as u32, 0), Width::Bit, bit(b, dice, 1)),
        // The state of this record, or of the next one.
        14 => (place_of(b, STATE, 0, dice.of(&[0, 0, 1])), Width::DoubleWord, double(b, dice, 0)),
        15 | 16 => {
            let place = dice.of(&COUNTS);
            let parts = [get(b, place, Width::DoubleWord), double(b, dice, 1)];
            (fixed(place), Width::DoubleWord, b.compute(Op::AddU32, &parts))
        }
        17 if !inside => {
            let parts = [get(b, TOTAL, Width::DoubleWord), real(b, dice, 1)];
            (fixed(TOTAL), Width::DoubleWord, b.compute(Op::AddF32, &parts))
        }
        18 if !inside => (fixed(LAST), Width::DoubleWord, real(b, dice, 1)),
        19 if !inside => (fixed(LAST_BIT), Width::Bit, bit(b, dice, 1)),
        _ => (place_of(b, HALF_STATE, 0, 0), Width::Word, b.constant(dice.of(&[0, 1, 2]))),
    };
    b.store(place, width, value);
}

impl Part {
    fn random(dice: &mut Dice) -> Vec<Self> {
        let mut parts = match dice.roll(6) {
            0 => vec![Self::NextState],
            1..=3 => writes(dice, 0),
            _ => Vec::new(),
        };
        let (yes, mut no) = (writes(dice, 3), writes(dice, 3));
        if dice.roll(3) == 0 {
            no.push(Self::If(Condition::random(dice), false, writes(dice, 1), Vec::new()));
        }
        let condition = Condition::random(dice);
        parts.push(Self::If(condition, dice.roll(2) == 0, yes, no));
        if dice.roll(3) == 0 {
            parts.push(Self::If(condition, false, writes(dice, 1), Vec::new()));
        }
        parts.extend(writes(dice, 0));
        parts
    }

    fn statements(&self) -> u32 {
        match self {
            Self::Write(_) | Self::NextState => 1,
            Self::If(_, _, yes, no) => 1 + Self::all(yes) + u32::from(!no.is_empty()) + Self::all(no),
        }
    }

    fn all(parts: &[Self]) -> u32 {
        parts.iter().map(Self::statements).sum()
    }

    /// Writes it; what follows begins with the statement that is the result.
    fn write(&self, b: &mut Builder, first: u32, inside: bool) -> u32 {
        let behind = first + self.statements();
        b.begin_statement();
        match *self {
            Self::Write(seed) => write(b, Dice(seed), inside),
            Self::NextState => {
                let (place, value) = (place_of(b, STATE, 0, 1), field(b, DOUBLES[0], Width::DoubleWord));
                b.store(place, Width::DoubleWord, value);
            }
            Self::If(condition, turned, ref yes, ref no) => {
                let condition = condition.write(b);
                let otherwise = if turned { condition } else { b.compute(Op::Not, &[condition]) };
                let jumps = u32::from(!no.is_empty());
                let second = first + 1 + Self::all(yes) + jumps;
                b.push(Inst::Branch { condition: otherwise, to: Target(second) });
                yes.iter().fold(first + 1, |first, part| part.write(b, first, true));
                if jumps == 1 {
                    b.begin_statement();
                    b.push(Inst::Jump { to: Target(behind) });
                }
                no.iter().fold(second, |first, part| part.write(b, first, true));
            }
        }
        behind
    }
}

/// Fills the records: neighbours have the same state, or some of them.
fn fill(machine: &mut Machine, seed: u64) {
    let mut dice = Dice(seed);
    machine.budget = dice.of(&[1, 20, 100, 1_000, 100_000, 100_000, 100_000]);
    let special = dice.of(&[0, 0, 2, 20]);
    let chance = dice.of(&[0, 1, 10]);
    let mut state = dice.roll(3);
    let memory = machine.memory.area_mut(Area::BitMemory);
    let mut put = |at: u32, value: u64, bytes: usize| {
        memory[at as usize..at as usize + bytes].copy_from_slice(&value.to_be_bytes()[8 - bytes..]);
    };
    let number = |dice: &mut Dice| match dice.roll(40) {
        roll if roll < special => {
            dice.of(&[0, 0x8000_0000, 1, 0x7F80_0000, 0xFF80_0000, 0x7FC0_0000, 0x7F80_0001, 0xFFC1_2345, 0x4F00_0000])
        }
        _ => 0x3F80_0000 + dice.roll(1 << 24) + (dice.roll(2) << 31),
    };
    for record in 0..RECORDS {
        let start = FIRST + record * RECORD;
        if dice.roll(10) < chance {
            state = dice.roll(3);
        }
        REALS.iter().for_each(|&at| put(start + at, number(&mut dice), 4));
        DOUBLES.iter().for_each(|&at| put(start + at, dice.of(&[0, 1, 2, 0xFFFF_FFF0]), 4));
        put(start + HALF_STATE, state, 2);
        put(start + STATE, state + dice.of(&[0, 0, 0, 0, 0, 0, 0, 0, 0, 0x10_0000]), 4);
        put(start + BITS, dice.roll(256), 1);
        put(ROW + 4 * record, number(&mut dice), 4);
    }
    [TOTAL, LAST].iter().for_each(|&at| put(at, number(&mut dice), 4));
    put(SCAN, dice.roll(200), 4);
}

#[test]
fn iterations_that_go_the_same_way_do_what_the_interpreter_does() {
    let (mut silent, mut alike) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed);
        let parts = Part::random(&mut dice);
        let last = dice.of(&[3, 7, 15, 18, u64::from(RECORDS) - 2]);
        let program = program(&[(BlockId::ob(1), 16, &|b| {
            counted(b, COUNTER, last, |b| parts.iter().fold(1, |first, part| part.write(b, first, false)));
        })]);
        let layout = noting::layout(&program);
        alike += usize::from(Jit::listing(&program, &layout).expect("machine code").contains("vall_true"));
        let prepare = |machine: &mut Machine, memory: u64| fill(machine, seed + 1_000_000 + (memory << 32));
        silent += all_engines_agree_from((&program, &layout), MEMORIES, &prepare, &seed.to_string());
    }
    const { assert!(FIRST + RECORD * RECORDS <= COUNTER) };
    assert!(silent > 600 && alike > 60, "{silent} runs in which nobody was asked, {alike} programs with iterations that go the same way");
}

/// Whether iterations that all go the same way are done by themselves, where some parts stand before a condition with REALs on both
/// sides.
fn are_looked_at(mut parts: Vec<Part>, condition: Condition) -> bool {
    let mut reals = (0..).filter(|&seed| Dice(seed).roll(20) <= 8).map(Part::Write);
    let sides = [0, 1].map(|_| reals.by_ref().take(6).collect::<Vec<Part>>());
    let [yes, no] = sides;
    parts.push(Part::If(condition, false, yes, no));
    let program = program(&[(BlockId::ob(1), 16, &|b| {
        counted(b, COUNTER, 18, |b| parts.iter().fold(1, |first, part| part.write(b, first, false)));
    })]);
    let layout = noting::layout(&program);
    all_engines_agree_from((&program, &layout), MEMORIES, &|machine, memory| fill(machine, memory), "");
    Jit::listing(&program, &layout).expect("machine code").contains("vall_true")
}

#[test]
fn a_condition_is_looked_at_first_that_is_foreseen_and_known_by_then() {
    for condition in
        [Condition::Period(16, 4), Condition::State(1), Condition::WholeState(1), Condition::OtherState(1), Condition::Both(16, 8)]
    {
        assert!(are_looked_at(Vec::new(), condition));
    }
    assert!(!are_looked_at(vec![Part::NextState], Condition::WholeState(1)), "the iteration before writes the state");
    assert!(are_looked_at(vec![Part::NextState], Condition::Period(16, 4)));
    assert!(!are_looked_at(Vec::new(), Condition::Period(4, 1)), "each fourth iteration goes another way");
}
