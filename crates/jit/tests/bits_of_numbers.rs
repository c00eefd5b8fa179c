//! Bits of numbers that a loop keeps in registers, read and written beside the numbers themselves: whatever else lies in their bytes and
//! whoever changes memory, the code does what the interpreter does.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, engines, fixed, get, layout_with, program};

const PROGRAMS: u64 = 800;
const QUESTIONS_MAX: usize = 30;
/// Where the loop counts, and the bytes of the numbers in bit memory.
const COUNTER: u32 = 100;
const NUMBERS: [(u32, Width); 4] = [(8, Width::DoubleWord), (12, Width::Word), (14, Width::DoubleWord), (20, Width::Byte)];
const FIRST: u32 = 8;
const BYTES: u32 = 16;
/// Numbers that some programs read there, too, in part or across two of them.
const STRANGE: [(u32, Width); 4] = [(9, Width::Word), (11, Width::DoubleWord), (14, Width::Word), (20, Width::Word)];

/// `REPEAT … UNTIL counter > last`, with a jump table in it, so that the iterations are not done at once.
fn looping(b: &mut Builder, last: u64, statements: u32, write: &mut dyn FnMut(&mut Builder, u32)) {
    b.begin_statement();
    let zero = b.constant(0);
    b.store(fixed(COUNTER), Width::Word, zero);
    for statement in 0..statements {
        b.begin_statement();
        write(b, 1 + statement);
    }
    b.begin_statement();
    let counter = get(b, COUNTER, Width::Word);
    let behind = 2 + statements;
    let first = b.table(&[Target(behind), Target(behind)]);
    b.push(Inst::JumpTable { index: counter, first, count: 2, otherwise: Target(behind) });
    b.begin_statement();
    let (counter, one) = (get(b, COUNTER, Width::Word), b.constant(1));
    let next = b.compute(Op::AddU16, &[counter, one]);
    b.store(fixed(COUNTER), Width::Word, next);
    let last = b.constant(last);
    let again = b.compute(Op::LeI16, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(1) });
    b.begin_statement();
    b.push(Inst::Return);
}

fn bit(byte: u32, number: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte + number }
}

fn some_bit(dice: &mut Dice) -> Place {
    let bytes = u64::from(BYTES);
    bit(FIRST + dice.roll(bytes) as u32, dice.roll(8) as u32)
}

fn some_number(dice: &mut Dice, strange: bool) -> (u32, Width) {
    if strange && dice.roll(6) == 0 { dice.of(&STRANGE) } else { dice.of(&NUMBERS) }
}

fn some_statement(b: &mut Builder, dice: &mut Dice, (statement, statements): (u32, u32), strange: bool) {
    let some_value = |b: &mut Builder, dice: &mut Dice| -> Var {
        match dice.roll(4) {
            0 => b.load(some_bit(dice), Width::Bit, OnFault::SkipStatement),
            1 => get(b, COUNTER, Width::Word),
            _ => {
                let (byte, width) = some_number(dice, strange);
                get(b, byte, width)
            }
        }
    };
    let (one, other) = (some_value(b, dice), some_value(b, dice));
    let value = b.compute(dice.of(&[Op::XorU32, Op::AddU32, Op::AndU32]), &[one, other]);
    match dice.roll(6) {
        0 => {
            let condition = b.load(some_bit(dice), Width::Bit, OnFault::SkipStatement);
            let to = statement + 1 + dice.roll(u64::from(1 + statements - statement)) as u32;
            b.push(Inst::Branch { condition, to: Target(to) });
        }
        1 | 2 => {
            let is_set = b.compute(Op::IsNonzero, &[value]);
            b.store(some_bit(dice), Width::Bit, is_set);
        }
        3 => {
            let [one, other] = [(); 2].map(|()| b.load(some_bit(dice), Width::Bit, OnFault::SkipStatement));
            let value = b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[one, other]);
            b.store(some_bit(dice), Width::Bit, value);
        }
        _ => {
            let (byte, width) = some_number(dice, strange);
            b.store(fixed(byte), width, value);
        }
    }
}

fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 1, 2, 3, 8, 50]);
    if dice.roll(2) == 0 {
        let byte = FIRST + dice.roll(u64::from(BYTES)) as u32;
        machine.memory.area_mut(Area::BitMemory)[byte as usize] = dice.roll(256) as u8;
    }
    Reaction::Continue
}

#[test]
fn bits_of_numbers_are_what_the_interpreter_makes_of_them() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let build = |b: &mut Builder| {
            let mut dice = Dice(seed);
            let (last, statements, strange) = (dice.of(&[0, 7, 15]), 1 + dice.roll(7) as u32, dice.roll(2) == 0);
            looping(b, last, statements, &mut |b, statement| some_statement(b, &mut dice, (statement, statements), strange));
        };
        let program = program(&[(BlockId::ob(1), 16, &build)]);
        let layout = layout_with(&program, 16);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 1, 2, 5, 20, 1000]);
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory[FIRST as usize..(FIRST + BYTES) as usize].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let dice = || Dice(seed + 2_000_000);
        let expected = all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &seed.to_string());
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 500 && finished > 200, "{asked} questions, {finished} runs to the end");
}

#[test]
fn a_loop_that_reads_bits_of_a_number_touches_no_memory() {
    let build = |b: &mut Builder| {
        looping(b, 12, 3, &mut |b, statement| match statement {
            1 => {
                let (number, three) = (get(b, 8, Width::DoubleWord), b.constant(3));
                let value = b.compute(Op::MulU32, &[number, three]);
                b.store(fixed(8), Width::DoubleWord, value);
            }
            2 => {
                let value = b.load(bit(10, 7), Width::Bit, OnFault::SkipStatement);
                b.store(bit(8, 1), Width::Bit, value);
            }
            _ => {
                let condition = b.load(bit(11, 0), Width::Bit, OnFault::SkipStatement);
                b.push(Inst::Branch { condition, to: Target(4) });
            }
        });
    };
    let program = program(&[(BlockId::ob(1), 16, &build)]);
    let listing = Jit::listing(&program, &layout_with(&program, 16)).expect("machine code");
    let iteration = listing.split("\nblock").find(|block| block.contains("br_table")).expect("an iteration");
    assert!(!iteration.contains("load") && !iteration.contains("store"), "{iteration}");
}
