//! Counted loops that compute bits of arrays one after the other: eight iterations make a byte, and iterations that are nothing but logic
//! of bits are made 56 at a time. Whatever bits are read, where they begin and whenever somebody looks, the loops do what the interpreter
//! does.

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, engines, layout_with, program};

/// Programs that are compared.
const PROGRAMS: u64 = 500;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 30;
const DATA_BYTES: usize = 400;
/// Where the variables lie in bit memory, in bytes.
const COUNTER: u32 = 100;
const ADDED: u32 = 104;
const SUM: u32 = 108;
const LAST: u32 = 112;
/// Where arrays of bits begin in the data block, in bits: some of them lie in others.
const ARRAYS: &[u32] = &[0, 0, 256, 512, 768, 264, 259];
/// Where numbers of 16 bits begin.
const NUMBERS: u32 = 1024;

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn get(b: &mut Builder, byte: u32) -> Var {
    b.load(fixed(byte), Width::DoubleWord, OnFault::SkipStatement)
}

/// The bit of an iteration, so many bits behind the beginning of the data block.
fn bit(b: &mut Builder, offset: u32) -> Place {
    let pointer = get(b, COUNTER);
    Place::Indirect { area: Area::SharedData, pointer, offset }
}

fn read(b: &mut Builder, offset: u32) -> Var {
    let place = bit(b, offset);
    b.load(place, Width::Bit, OnFault::SkipStatement)
}

fn write(b: &mut Builder, offset: u32, value: Var) {
    let place = bit(b, offset);
    b.store(place, Width::Bit, value);
}

/// A number that the loop counts with, compared.
fn compared(b: &mut Builder) -> Var {
    let (counter, added) = (get(b, COUNTER), get(b, ADDED));
    let number = b.compute(Op::XorU32, &[counter, added]);
    let five = b.constant(5);
    b.compute(Op::LtI32, &[number, five])
}

/// Whether a loop counts up or down.
#[derive(Clone, Copy)]
enum Counts {
    Up,
    Down,
}

/// `FOR i := first TO last DO`, or with `BY -1`, with the limit in memory if the loop says so.
fn counted(b: &mut Builder, counts: Counts, (first, last): (u64, Option<u64>), iteration: &dyn Fn(&mut Builder)) {
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    b.begin_statement();
    let first = b.constant(first);
    b.store(fixed(COUNTER), Width::DoubleWord, first);
    b.begin_statement();
    iteration(b);
    b.begin_statement();
    let counter = get(b, COUNTER);
    let (step, goes_on) = match counts {
        Counts::Up => (1, Op::LeI32),
        Counts::Down => (0xFFFF_FFFF, Op::GeI32),
    };
    let step = b.constant(step);
    let next = b.compute(Op::AddU32, &[counter, step]);
    b.store(fixed(COUNTER), Width::DoubleWord, next);
    let last = match last {
        Some(last) => b.constant(last),
        None => get(b, LAST),
    };
    let again = b.compute(goes_on, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(2) });
    b.begin_statement();
    b.push(Inst::Return);
}

fn listing(counts: Counts, iteration: &dyn Fn(&mut Builder)) -> String {
    let range = match counts {
        Counts::Up => (0, Some(199)),
        Counts::Down => (199, Some(0)),
    };
    let program = program(&[(BlockId::ob(1), 16, &|b| counted(b, counts, range, iteration))]);
    Jit::listing(&program, &layout_with(&program, DATA_BYTES)).expect("machine code")
}

/// Whether eight iterations are written behind one another: each has the XOR of `compared`.
fn makes_bytes(iteration: &dyn Fn(&mut Builder)) -> bool {
    makes_bytes_counting(Counts::Up, iteration)
}

fn makes_bytes_counting(counts: Counts, iteration: &dyn Fn(&mut Builder)) -> bool {
    listing(counts, iteration).matches("= bxor").count() >= 8
}

/// Whether 56 iterations are made at a time: nothing else stores 64 bits of memory in the order of the processor.
fn makes_words(iteration: &dyn Fn(&mut Builder)) -> bool {
    makes_words_counting(Counts::Up, iteration)
}

fn makes_words_counting(counts: Counts, iteration: &dyn Fn(&mut Builder)) -> bool {
    listing(counts, iteration).lines().any(|line| line.trim_start().starts_with("store notrap little"))
}

fn write_compared(b: &mut Builder) {
    let value = compared(b);
    write(b, 0, value);
}

#[test]
fn bits_that_iterations_compute_are_written_as_bytes() {
    assert!(makes_bytes(&write_compared));
    // With the bit that was there, with one of another array, and two of them.
    assert!(makes_bytes(&|b| {
        let (value, old, other) = (compared(b), read(b, 0), read(b, 256));
        let value = b.compute(Op::And, &[value, old]);
        let value = b.compute(Op::Or, &[value, other]);
        write(b, 0, value);
        b.begin_statement();
        write_compared(b);
        b.begin_statement();
        let value = compared(b);
        write(b, 512, value);
    }));
}

#[test]
fn bits_of_neighbours_are_handed_on() {
    // A bit that the iteration before has written, and one that another iteration will write.
    for (counts, before, ahead) in [(Counts::Up, 7, [9, 16]), (Counts::Down, 9, [7, 0])] {
        for other in [before, ahead[0], ahead[1]] {
            assert!(makes_bytes_counting(counts, &|b| {
                let (value, before) = (compared(b), read(b, other));
                let value = b.compute(Op::Or, &[value, before]);
                write(b, 8, value);
            }));
        }
    }
    // Bits of two arrays, each of which needs both neighbours of the other one.
    assert!(makes_bytes(&|b| {
        for (target, other) in [(264, 8), (8, 264)] {
            let (left, right, old, value) = (read(b, other - 1), read(b, other + 1), read(b, target), compared(b));
            let both = b.compute(Op::And, &[left, right]);
            let either = b.compute(Op::Or, &[both, old]);
            let value = b.compute(Op::AndNot, &[either, value]);
            write(b, target, value);
            b.begin_statement();
        }
    }));
}

#[test]
fn bits_that_are_only_read_are_read_in_bytes() {
    assert!(makes_bytes(&|b| {
        let (bit, next) = (read(b, 259), read(b, 512));
        let sum = get(b, SUM);
        let value = compared(b);
        let value = b.compute(Op::And, &[value, bit]);
        let value = b.compute(Op::Xor, &[value, next]);
        let sum = b.compute(Op::MulU32, &[sum, sum]);
        let sum = b.compute(Op::AddU32, &[sum, value]);
        b.store(fixed(SUM), Width::DoubleWord, sum);
    }));
}

#[test]
fn bits_that_iterations_read_from_one_another_are_written_one_by_one() {
    // A bit that the iteration before the last one has written.
    assert!(!makes_bytes(&|b| {
        let (value, before) = (compared(b), read(b, 8));
        let value = b.compute(Op::Or, &[value, before]);
        write(b, 10, value);
    }));
    // Two bits of the same array.
    assert!(!makes_bytes(&|b| {
        write_compared(b);
        b.begin_statement();
        let value = compared(b);
        write(b, 1, value);
    }));
    // Another access to the same bytes.
    assert!(!makes_bytes(&|b| {
        write_compared(b);
        b.begin_statement();
        let one = b.constant(1);
        write(b, 3, one);
    }));
    assert!(!makes_bytes(&|b| {
        write_compared(b);
        b.begin_statement();
        let number = get(b, COUNTER);
        let bits = b.constant(8);
        let pointer = b.compute(Op::MulU32, &[number, bits]);
        b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, Width::Byte, number);
    }));
    // Bits of one array upwards and of another one downwards.
    assert!(!makes_bytes(&|b| {
        write_compared(b);
        b.begin_statement();
        let value = compared(b);
        let number = get(b, COUNTER);
        let last = b.constant(199);
        let pointer = b.compute(Op::SubU32, &[last, number]);
        b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 512 }, Width::Bit, value);
    }));
    // Bits that do not follow one another.
    assert!(!makes_bytes(&|b| {
        let value = compared(b);
        let number = get(b, COUNTER);
        let two = b.constant(2);
        let pointer = b.compute(Op::MulU32, &[number, two]);
        b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, Width::Bit, value);
    }));
}

/// Logic of the bits at two offsets, written to a third.
fn logic(b: &mut Builder, [x, y, to]: [u32; 3]) {
    let (x, y) = (read(b, x), read(b, y));
    let value = b.compute(Op::AndNot, &[x, y]);
    write(b, to, value);
}

#[test]
fn logic_of_bits_is_done_56_iterations_at_a_time() {
    assert!(makes_words(&|b| logic(b, [256, 512, 0])));
    // Bits that begin elsewhere in their bytes, and those of the same array that no iteration has written yet.
    assert!(makes_words(&|b| logic(b, [259, 517, 6])));
    assert!(makes_words(&|b| logic(b, [6, 7, 6])));
    // The same downwards.
    assert!(makes_words_counting(Counts::Down, &|b| logic(b, [259, 517, 6])));
    assert!(makes_words_counting(Counts::Down, &|b| logic(b, [8, 7, 8])));
}

#[test]
fn logic_of_bits_that_iterations_have_written_is_done_one_by_one() {
    assert!(!makes_words(&|b| logic(b, [256, 7, 8])));
    assert!(!makes_words_counting(Counts::Down, &|b| logic(b, [256, 8, 7])));
    assert!(!makes_words(&|b| {
        logic(b, [256, 512, 0]);
        b.begin_statement();
        logic(b, [256, 512, 3]);
    }));
    assert!(!makes_words(&|b| {
        let (value, old) = (compared(b), read(b, 0));
        let value = b.compute(Op::Xor, &[value, old]);
        write(b, 0, value);
    }));
}

/// Some statements of an iteration.
fn some_iteration(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let only_logic = dice.roll(3) == 0;
    // Mostly the same arrays again: others make bits that iterations read from one another.
    let arrays: Vec<u32> = match dice.roll(4) {
        0 => ARRAYS.to_vec(),
        1 => vec![0, 256, 512, 257, 517],
        _ => vec![0, 256, 512],
    };
    let target = dice.of(&arrays);
    for statement in 0..=dice.roll(3) {
        if statement > 0 {
            b.begin_statement();
        }
        let mut value = read(b, dice.of(&arrays));
        for _ in 0..dice.roll(4) {
            let other = match dice.roll(if only_logic { 2 } else { 5 }) {
                0 | 1 => {
                    let near = if dice.roll(6) == 0 { 1 } else { 0 };
                    read(b, dice.of(&arrays) + near)
                }
                2 | 3 => compared(b),
                _ => {
                    let number = get(b, COUNTER);
                    let bits = b.constant(16);
                    let pointer = b.compute(Op::MulU32, &[number, bits]);
                    let place = Place::Indirect { area: Area::SharedData, pointer, offset: NUMBERS };
                    let number = b.load(place, Width::Word, OnFault::SkipStatement);
                    let seven = b.constant(7);
                    let rest = b.compute(Op::RemI16, &[number, seven]);
                    b.compute(Op::IsNonzero, &[rest])
                }
            };
            value = b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[value, other]);
        }
        match dice.roll(8) {
            0 => {
                let sum = get(b, SUM);
                let sum = b.compute(Op::AddU32, &[sum, value]);
                b.store(fixed(SUM), Width::DoubleWord, sum);
            }
            1 => {
                let inverted = b.compute(Op::Not, &[value]);
                write(b, target, inverted);
            }
            2 if !only_logic => b.store(fixed(SUM + 1), Width::Byte, value),
            _ => {
                let to = if dice.roll(2) == 0 { target } else { dice.of(&arrays) };
                write(b, to, value);
            }
        }
    }
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 3, 9, 17, 65, 100, 1000, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, ADDED + 3, SUM + 2, LAST + 3]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 8, 13, 0x7F, 0x80]);
    }
    Reaction::Continue
}

/// Statements of an iteration each of which writes an array of its own, mostly, from bits of all of them, and near them.
fn neighbours(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let begins = dice.of(&[16, 16, 17, 23]);
    let arrays: Vec<u32> = [0, 256, 512, 768].map(|array| array + begins).to_vec();
    let first = dice.roll(4);
    for statement in 0..=dice.roll(4) {
        if statement > 0 {
            b.begin_statement();
        }
        let mut value = if dice.roll(2) == 0 { compared(b) } else { read(b, dice.of(&arrays)) };
        for _ in 0..=dice.roll(3) {
            let near = dice.of(&[0, 0, 0, 1, 1, 15, 15, 14, 2, 9, 24, 7]);
            // So many positions further on, or, from 10 on, 16 before that.
            let other = dice.of(&arrays) + near - if near >= 10 { 16 } else { 0 };
            let other = read(b, other);
            value = b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[value, other]);
        }
        match dice.roll(16) {
            0 | 1 => {
                let sum = get(b, SUM);
                let sum = b.compute(Op::AddU32, &[sum, value]);
                b.store(fixed(SUM), Width::DoubleWord, sum);
            }
            2 => write(b, dice.of(&arrays) + dice.of(&[0, 1, 8]), value),
            _ => write(b, arrays[(first + statement) as usize % arrays.len()], value),
        }
    }
}

#[test]
fn bits_that_loops_compute_are_those_of_the_interpreter() {
    compare_loops(PROGRAMS, 0, &some_iteration);
}

#[test]
fn bits_of_neighbours_are_those_of_the_interpreter() {
    compare_loops(2 * PROGRAMS, 10_000, &neighbours);
}

/// Compares loops over iterations that seeds tell, counted up and down.
fn compare_loops(programs: u64, from: u64, iteration: &dyn Fn(&mut Builder, u64)) {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(programs).map(|seed| from + seed) {
        let block = BlockId::ob(1);
        let mut dice = Dice(seed + 3_000_000);
        let first = dice.of(&[0, 0, 0, 1, 3, 8, 13]);
        let last = dice.of(&[Some(5), Some(63), Some(71), Some(127), Some(180), Some(199), None]);
        let (counts, range) = match (dice.roll(3), last) {
            (0, Some(last)) => (Counts::Down, (last, if first == 0 { None } else { Some(first) })),
            _ => (Counts::Up, (first, last)),
        };
        let program = program(&[(block, 16, &|b| counted(b, counts, range, &|b| iteration(b, seed)))]);
        let layout = layout_with(&program, DATA_BYTES);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 40, 70, 1000, 100_000, 100_000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            machine.memory.area_mut(Area::BitMemory)[LAST as usize + 3] = dice.of(&[0, 20, 64, 100, 150, 199]);
        };
        let dice = || Dice(seed + 2_000_000);
        let expected = all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &seed.to_string());
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 300 && finished > 150, "{asked} questions, {finished} runs to the end");
}
