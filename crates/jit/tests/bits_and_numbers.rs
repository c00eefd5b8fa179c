//! Numbers of which a program writes bits, too, in local data, in bit memory and in elements of an array: `w := 0; w.%X3 := a; y := w;`. In
//! straight code, in iterations that are done at once and in others, and whoever changes memory, the code does what the interpreter does.

use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, all_engines_agree_beside, engines, fixed, get, layout_with, next_iteration, program, run};

const PROGRAMS: u64 = 450;
const QUESTIONS_MAX: usize = 30;
/// Where the loop counts, and the bytes with numbers: of local data, of bit memory, and of elements in bit memory that the counter leads
/// to.
const COUNTER: u32 = 100;
const FIRST: u32 = 8;
const ELEMENT: u64 = 8;
const NUMBERS: [(u32, Width); 5] = [(0, Width::Word), (0, Width::Word), (2, Width::DoubleWord), (6, Width::Byte), (1, Width::Word)];

/// What a loop or straight code has its numbers in.
#[derive(Clone, Copy, PartialEq)]
enum Home {
    Local,
    Memory,
    Elements,
}

/// A place so many bits behind the first byte.
fn place(b: &mut Builder, home: Home, bits: u32) -> Place {
    match home {
        Home::Local => Place::Fixed { area: Area::Local, position: 8 * 20 + bits },
        Home::Memory => Place::Fixed { area: Area::BitMemory, position: 8 * FIRST + bits },
        Home::Elements => {
            let counter = get(b, COUNTER, Width::Word);
            let step = b.constant(8 * ELEMENT);
            let pointer = b.compute(Op::MulU32, &[counter, step]);
            Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * FIRST + bits }
        }
    }
}

fn bit(b: &mut Builder, dice: &mut Dice, home: Home) -> Place {
    let bits = 8 * dice.of(&[0, 1, 1, 2, 4, 5, 6]) + dice.roll(8) as u32;
    place(b, home, bits)
}

fn value(b: &mut Builder, dice: &mut Dice, home: Home) -> Var {
    match dice.roll(5) {
        0 => {
            let place = bit(b, dice, home);
            b.load(place, Width::Bit, OnFault::SkipStatement)
        }
        1 => b.constant(dice.of(&[0, 0, 1, 0xFFFF, 0x1234])),
        2 => get(b, dice.of(&[COUNTER, 200, 204]), Width::Word),
        _ => {
            let (byte, width) = dice.of(&NUMBERS);
            let place = place(b, home, 8 * byte);
            b.load(place, width, OnFault::SkipStatement)
        }
    }
}

fn some_statement(b: &mut Builder, dice: &mut Dice, home: Home, (statement, behind): (u32, u32)) {
    match dice.roll(9) {
        0 => {
            let (one, other) = (value(b, dice, home), value(b, dice, home));
            let condition = b.compute(Op::LtI32, &[one, other]);
            let to = statement + 1 + dice.roll(u64::from(behind - statement)) as u32;
            b.push(Inst::Branch { condition, to: Target(to) });
        }
        1..4 => {
            let (byte, width) = dice.of(&NUMBERS);
            let new = value(b, dice, home);
            let place = place(b, home, 8 * byte);
            b.store(place, width, new);
        }
        4 => {
            let (one, other) = (value(b, dice, home), value(b, dice, home));
            let new = b.compute(dice.of(&[Op::AddU32, Op::XorU32]), &[one, other]);
            b.store(fixed(dice.of(&[200, 204])), Width::DoubleWord, new);
        }
        _ => {
            let (one, other) = (value(b, dice, home), value(b, dice, home));
            let new = b.compute(dice.of(&[Op::LtI32, Op::Equal, Op::LtI16]), &[one, other]);
            let place = bit(b, dice, home);
            b.store(place, Width::Bit, new);
        }
    }
}

/// A function that a loop calls in iterations that are done at once: numbers and bits of them in its local data, some under a condition,
/// and what becomes of a number goes to an array.
fn function(b: &mut Builder, dice: &mut Dice) {
    let statements = 4 + dice.roll(6) as u32;
    let numbers = [(0, Width::Word), (2, Width::DoubleWord), (6, Width::Byte)];
    for (byte, width) in numbers {
        b.begin_statement();
        let zero = b.constant(0);
        let number = place(b, Home::Local, 8 * byte);
        b.store(number, width, zero);
    }
    for statement in 3..3 + statements {
        b.begin_statement();
        let in_array = |b: &mut Builder| {
            let counter = get(b, COUNTER, Width::Word);
            let step = b.constant(16);
            let pointer = b.compute(Op::MulU32, &[counter, step]);
            Place::Indirect { area: Area::SharedData, pointer, offset: 0 }
        };
        let read = in_array(b);
        let element = b.load(read, Width::Word, OnFault::SkipStatement);
        let limit = b.constant(dice.of(&[0x1000, 0x7000]));
        let small = b.compute(Op::LtI16, &[element, limit]);
        let (byte, width) = dice.of(&numbers);
        let number = place(b, Home::Local, 8 * byte);
        match dice.roll(7) {
            0 => b.store(number, width, element),
            1 if statement + 1 < 3 + statements => b.push(Inst::Branch { condition: small, to: Target(statement + 2) }),
            1 | 2 => {
                let place = bit(b, dice, Home::Local);
                let value = b.load(place, Width::Bit, OnFault::SkipStatement);
                let place = bit(b, dice, Home::Local);
                b.store(place, Width::Bit, value);
            }
            3 | 4 => {
                let value = b.load(number, width, OnFault::SkipStatement);
                let to = in_array(b);
                b.store(to, Width::Word, value);
            }
            _ => {
                let place = bit(b, dice, Home::Local);
                b.store(place, Width::Bit, small);
            }
        }
    }
}

/// `FOR counter := 0 TO last DO … END_FOR`, or what is in it by itself.
fn build(b: &mut Builder, dice: &mut Dice) {
    let home = dice.of(&[Home::Local, Home::Local, Home::Memory, Home::Elements]);
    let statements = 2 + dice.roll(9) as u32;
    b.begin_statement();
    let zero = b.constant(0);
    b.store(fixed(COUNTER), Width::Word, zero);
    for statement in 0..statements {
        b.begin_statement();
        some_statement(b, dice, home, (1 + statement, 1 + statements));
    }
    b.begin_statement();
    match dice.roll(3) {
        0 => b.push(Inst::Return),
        which => {
            // With a jump table in it the iterations are not done at once.
            if which == 1 {
                let behind = Target(2 + statements);
                let (index, first) = (get(b, COUNTER, Width::Word), b.table(&[behind, behind]));
                b.push(Inst::JumpTable { index, first, count: 2, otherwise: behind });
                b.begin_statement();
            }
            next_iteration(b, fixed(COUNTER), (Op::LeI16, dice.of(&[3, 7])), Target(1));
            b.begin_statement();
            b.push(Inst::Return);
        }
    }
}

/// Changes a byte and the budget.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 50]);
    if dice.roll(2) == 0 {
        machine.memory.area_mut(Area::BitMemory)[dice.roll(90) as usize] = dice.roll(256) as u8;
    }
    Reaction::Continue
}

#[test]
fn numbers_and_their_bits_in_iterations_are_what_the_interpreter_makes_of_them() {
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed);
        let last = dice.of(&[7, 30]);
        let calls = |b: &mut Builder| {
            b.begin_statement();
            let number = b.constant(1);
            b.push(Inst::Open { register: DataRegister::Shared, number });
            let zero = b.constant(0);
            b.store(fixed(COUNTER), Width::Word, zero);
            b.begin_statement();
            b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 0 });
            b.begin_statement();
            next_iteration(b, fixed(COUNTER), (Op::LeI16, last), Target(1));
            b.begin_statement();
            b.push(Inst::Return);
        };
        let body = |b: &mut Builder| function(b, &mut Dice(seed + 1_000));
        let mut program = program(&[(BlockId::ob(1), 48, &calls), (BlockId::fc(1), 48, &body)]);
        program.code.values_mut().for_each(|block| block.reads_own_locals = true);
        let layout = layout_with(&program, 80);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let engines = engines(&program, &layout);
        for memory in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 * memory);
                machine.budget = 1000;
                let range = machine.memory.layout.data_blocks[&1].clone();
                machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            };
            let outcome = |engine: Arc<dyn Engine>| {
                let mut outcome = run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue);
                // Nobody reads what blocks left there that have ended.
                outcome.arena[layout.local.clone()].fill(0);
                outcome
            };
            let what = || format!("{seed} in memory {memory}\n{}", program.code[&BlockId::fc(1)].code);
            let expected = all_engines_agree(&engines, false, &outcome, &what);
            assert!(expected.asked.is_empty(), "{:?}", expected.asked);
        }
    }
}

#[test]
fn numbers_of_which_bits_are_written_are_what_the_interpreter_makes_of_them() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let program = program(&[(BlockId::ob(1), 48, &|b| build(b, &mut Dice(seed)))]);
        let layout = layout_with(&program, 16);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 2, 20, 1000, 1000]);
            machine.memory.area_mut(Area::BitMemory)[..90].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let dice = || Dice(seed + 2_000_000);
        let expected = all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &seed.to_string());
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 150 && finished > 150, "{asked} questions, {finished} runs to the end");
}

#[test]
fn a_number_of_which_bits_were_just_written_is_not_read_as_a_whole() {
    let build = |b: &mut Builder| {
        b.begin_statement();
        let number = get(b, 40, Width::Word);
        let condition = b.constant(5);
        let set = b.compute(Op::LtI16, &[number, condition]);
        b.store(Place::Fixed { area: Area::BitMemory, position: 8 * 9 + 3 }, Width::Bit, set);
        b.begin_statement();
        let number = get(b, 8, Width::Word);
        b.store(fixed(60), Width::Word, number);
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), 16, &build)]);
    let listing = Jit::listing(&program, &layout_with(&program, 16)).expect("machine code");
    let reads = listing.lines().filter(|line| line.contains("load.i16") || line.contains("uload16")).count();
    assert_eq!(reads, 1, "{listing}");
}
