//! Counted loops that read several bits a few positions apart from each other, and set several bits of a byte, which are put together step
//! by step: the loops do what the interpreter does, wherever the bits lie and whoever writes there.

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, engines, layout_with, program};

/// Programs that are compared.
const PROGRAMS: u64 = 700;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 30;
const DATA_BYTES: usize = 260;
/// Where the variables lie in bit memory, in bytes.
const COUNTER: u32 = 100;
const SUM: u32 = 104;
/// Where arrays of bits begin in the data block, in bits.
const ARRAYS: [u32; 4] = [0, 515, 1024, 1536];
/// How far the bits of one array are apart.
const NEAR: [u32; 10] = [0, 1, 2, 3, 7, 8, 16, 24, 25, 31];
/// How far a bit is from that of the iteration before.
const STEPS: [u64; 4] = [1, 1, 3, 9];
/// The last iteration.
const LAST: u64 = 49;

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn get(b: &mut Builder, byte: u32) -> Var {
    b.load(fixed(byte), Width::DoubleWord, OnFault::SkipStatement)
}

/// A bit of an iteration, so many bits behind the beginning of the data block.
fn bit(b: &mut Builder, step: u64, offset: u32) -> Place {
    let (counter, step) = (get(b, COUNTER), b.constant(step));
    let pointer = b.compute(Op::MulU32, &[counter, step]);
    Place::Indirect { area: Area::SharedData, pointer, offset }
}

fn read(b: &mut Builder, step: u64, offset: u32) -> Var {
    let place = bit(b, step, offset);
    b.load(place, Width::Bit, OnFault::SkipStatement)
}

fn counted(b: &mut Builder, last: u64, iteration: &dyn Fn(&mut Builder)) {
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    b.begin_statement();
    let first = b.constant(0);
    b.store(fixed(COUNTER), Width::DoubleWord, first);
    b.begin_statement();
    iteration(b);
    b.begin_statement();
    let counter = get(b, COUNTER);
    let one = b.constant(1);
    let next = b.compute(Op::AddU32, &[counter, one]);
    b.store(fixed(COUNTER), Width::DoubleWord, next);
    let last = b.constant(last);
    let again = b.compute(Op::LeI32, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(2) });
    b.begin_statement();
    b.push(Inst::Return);
}

/// A byte in which some bits are set to others, as a whole.
fn set_bits(b: &mut Builder, dice: &mut Dice, values: &[Var]) {
    let (counter, eight) = (get(b, COUNTER), b.constant(8));
    let pointer = b.compute(Op::MulU32, &[counter, eight]);
    let place = Place::Indirect { area: Area::SharedData, pointer, offset: 1536 + 8 * dice.roll(2) as u32 };
    let mask = b.constant(dice.of(&[0, 0x80, 0x55, 0xFF]));
    let old = b.load(place, Width::Byte, OnFault::SkipStatement);
    let mut byte = b.compute(Op::AndU32, &[old, mask]);
    for _ in 0..1 + dice.roll(6) {
        let value = match dice.roll(12) {
            0 => b.constant(dice.of(&[0, 1, 3])),
            // More than a bit.
            1 => get(b, COUNTER),
            _ => dice.of(values),
        };
        // Some of them twice, and some behind the byte.
        let to = b.constant(if dice.roll(9) == 0 { dice.of(&[8, 9, 33]) } else { dice.roll(8) });
        let moved = b.compute(Op::Shl32, &[value, to]);
        byte = b.compute(Op::OrU32, &[byte, moved]);
    }
    b.store(place, Width::Byte, byte);
}

/// Some statements of an iteration.
fn some_iteration(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let step = dice.of(&STEPS);
    let arrays: &[u32] = if dice.roll(2) == 0 { &ARRAYS[..1] } else { &ARRAYS[..3] };
    for statement in 0..1 + dice.roll(4) {
        if statement > 0 {
            b.begin_statement();
        }
        let mut values = Vec::new();
        for _ in 0..1 + dice.roll(5) {
            let read = read(b, step, dice.of(arrays) + dice.of(&NEAR));
            let value = match values.last() {
                Some(&other) if dice.roll(3) == 0 => b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[read, other]),
                _ => read,
            };
            values.push(if dice.roll(4) == 0 { b.compute(Op::Not, &[value]) } else { value });
        }
        let last = *values.last().expect("a bit");
        match dice.roll(6) {
            0 => {
                let sum = get(b, SUM);
                let sum = b.compute(Op::AddU32, &[sum, last]);
                b.store(fixed(SUM), Width::DoubleWord, sum);
            }
            // Where it is read in some iterations, or only beside it.
            1 => {
                let place = bit(b, step, dice.of(&[1024, 1100, 1536, 1537, 7]));
                b.store(place, Width::Bit, last);
            }
            _ => set_bits(b, &mut dice, &values),
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
        machine.memory.area_mut(Area::BitMemory)[COUNTER as usize + 3] = dice.of(&[0, 1, 8, 13, 0x7F]);
    }
    Reaction::Continue
}

#[test]
fn bits_near_each_other_are_those_of_the_interpreter() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let last = Dice(seed + 3_000_000).of(&[5, 30, LAST, LAST]);
        let program = program(&[(BlockId::ob(1), 16, &|b| counted(b, last, &|b| some_iteration(b, seed)))]);
        let layout = layout_with(&program, DATA_BYTES);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 40, 70, 1000, 100_000, 100_000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let dice = || Dice(seed + 2_000_000);
        let expected = all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &seed.to_string());
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 230 && finished > 230, "{asked} questions, {finished} runs to the end");
}
