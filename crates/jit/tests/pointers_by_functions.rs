//! Functions that are given a pointer in the local data of their caller, reach elements behind it, and hand it on to others from their own
//! local data: what a loop knows over such calls is what the interpreter finds, whatever a Host does that is asked.

use std::ops::Range;

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, all_engines_ask_once, count_on, engines, layout_with, program};

const PROGRAMS: u64 = 300;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Functions of a program; each may hand on to those behind it.
const FUNCTIONS: u16 = 3;
/// In the local data of each block: what it hands on, a number for the function that it calls, and what it works with.
const HANDED: u32 = 0;
const NUMBER: u32 = 8 * 8;
const OWN: u32 = 8 * 12;
const ELEMENTS: u32 = 8 * 16;
const LOCAL_BYTES: u32 = 80;
/// In bit memory: the counter of the loop, and results.
const COUNTER: u32 = 8 * 40;
const RESULT: u32 = 8 * 44;
const DATA_BYTES: usize = 120;

fn local(position: u32) -> Place {
    Place::Fixed { area: Area::Local, position }
}

fn memory(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

/// A pointer and an element more.
fn moved(b: &mut Builder, dice: &mut Dice, pointer: Var) -> Var {
    let by = match dice.roll(6) {
        0 => return pointer,
        // What was handed on, or kept, as a number.
        2 => {
            let position = dice.of(&[HANDED + 16, OWN]);
            let (number, mask) = (load(b, local(position), Width::DoubleWord), b.constant(0x30));
            b.compute(Op::AndU32, &[number, mask])
        }
        1 => {
            let (number, step) = (load(b, memory(COUNTER), Width::Word), b.constant(dice.of(&[16, 32])));
            b.compute(Op::MulU32, &[number, step])
        }
        _ => b.constant(dice.of(&[16, 32, 64])),
    };
    b.compute(Op::AddU32, &[pointer, by])
}

/// Data block number and pointer that a function was given.
fn given(b: &mut Builder) -> (Var, Var) {
    let parameter = b.temporary();
    b.push(Inst::Parameter { dst: parameter, index: 0 });
    let number = load(b, Place::Crossing { pointer: parameter, offset: 0 }, Width::Word);
    let pointer = load(b, Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord);
    (number, pointer)
}

/// A place that a function reads or writes.
fn place(b: &mut Builder, dice: &mut Dice) -> Place {
    match dice.roll(8) {
        0 => local(OWN),
        1 => memory(RESULT + 8 * dice.of(&[0, 4])),
        _ => {
            let (number, pointer) = given(b);
            let pointer = if dice.roll(3) == 0 { moved(b, dice, pointer) } else { pointer };
            b.push(Inst::Open { register: DataRegister::Shared, number });
            Place::Crossing { pointer, offset: 8 * dice.of(&[0, 0, 2, 4]) }
        }
    }
}

fn assigns(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    if dice.roll(6) == 0 {
        let (_, pointer) = given(b);
        return b.store(local(OWN), Width::DoubleWord, pointer);
    }
    let width = dice.of(&[Width::Word, Width::DoubleWord, Width::DoubleWord]);
    let from = place(b, dice);
    let value = load(b, from, width);
    let other = if dice.roll(4) == 0 {
        let parameter = b.temporary();
        b.push(Inst::Parameter { dst: parameter, index: 1 });
        load(b, Place::Crossing { pointer: parameter, offset: 0 }, Width::Word)
    } else {
        b.constant(dice.of(&[1, 3]))
    };
    let value = b.compute(Op::AddU32, &[value, other]);
    let to = place(b, dice);
    b.store(to, width, value);
}

/// Calls a function with what is handed on, and a number.
fn calls(b: &mut Builder, dice: &mut Dice, function: u16) {
    let number = if dice.roll(3) == 0 { load(b, memory(COUNTER), Width::Word) } else { b.constant(dice.roll(9)) };
    b.store(local(NUMBER), Width::Word, number);
    for position in [HANDED, NUMBER] {
        let pointer = b.constant(0x8700_0000 | u64::from(position));
        b.push(Inst::PassParameter { src: pointer });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fc(function)), parameters: 2 });
}

/// Hands on what the function was given, or something of its own.
fn hands_on(b: &mut Builder, dice: &mut Dice, function: u16) {
    b.begin_statement();
    let (number, pointer) = if dice.roll(5) == 0 {
        (b.constant(0), b.constant(0x8700_0000 | u64::from(ELEMENTS)))
    } else {
        let (number, pointer) = given(b);
        let first = dice.roll(2) == 0;
        let pointer = if first { moved(b, dice, pointer) } else { pointer };
        let passed = b.compute(Op::PassOnPointer, &[pointer]);
        (number, if first { passed } else { moved(b, dice, passed) })
    };
    b.store(local(HANDED), Width::Word, number);
    b.store(local(HANDED + 16), Width::DoubleWord, pointer);
    calls(b, dice, function);
    if dice.roll(8) == 0 {
        // A pointer is a number, too.
        b.begin_statement();
        let (position, width) = dice.of(&[(HANDED + 16, Width::DoubleWord), (HANDED, Width::Word), (HANDED + 32, Width::Word)]);
        let number = load(b, local(position), width);
        let factor = b.constant(dice.of(&[1, 7]));
        let number = b.compute(Op::MulU32, &[number, factor]);
        b.store(memory(RESULT), Width::DoubleWord, number);
    }
}

fn function(b: &mut Builder, dice: &mut Dice, number: u16) {
    for _ in 0..1 + dice.roll(4) {
        if number < FUNCTIONS && dice.roll(2) == 0 {
            hands_on(b, dice, number + 1);
        } else {
            assigns(b, dice);
        }
    }
}

fn caller(b: &mut Builder, dice: &mut Dice) {
    // Some pointers lead to what lies just before the counter.
    let before = 0x8300_0000 | u64::from(COUNTER);
    let own = 0x8700_0000 | u64::from(ELEMENTS);
    let at = [0x8400_0000, 0x8400_0000, 0x8400_0050, 0x8300_0000, own, 0x8700_0000, 0x8600_0000, before - 16, before - 32, before - 48];
    let at = dice.of(&at);
    calls_in_a_loop(b, dice, at, true);
}

/// A loop that hands pointers to a function, and uses its counter behind the call.
fn calls_in_a_loop(b: &mut Builder, dice: &mut Dice, at: u64, moves: bool) {
    b.begin_statement();
    let first = b.constant(0);
    b.store(memory(COUNTER), Width::Word, first);
    for register in [DataRegister::Shared, DataRegister::Instance] {
        let number = b.constant(1);
        b.push(Inst::Open { register, number });
    }
    b.begin_statement();
    let block = b.constant(if moves { dice.of(&[1, 1, 1, 0, 9]) } else { 1 });
    let pointer = b.constant(at);
    let pointer = if !moves || dice.roll(3) == 0 { pointer } else { moved(b, dice, pointer) };
    b.store(local(HANDED), Width::Word, block);
    b.store(local(HANDED + 16), Width::DoubleWord, pointer);
    calls(b, dice, 1);
    b.begin_statement();
    let number = load(b, memory(COUNTER), Width::Word);
    let (shift, first) = (b.constant(4), b.constant(0x8400_0000));
    let bits = b.compute(Op::Shl32, &[number, shift]);
    let pointer = b.compute(Op::AddU32, &[first, bits]);
    b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 8 * 90 }, Width::Word, number);
    b.begin_statement();
    let limit = dice.of(&[3, 7, 9]);
    count_on(b, memory(COUNTER), (dice.of(&[Op::LtI16, Op::Below]), limit), Target(1));
}

fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 40, 400]);
    for _ in 0..dice.of(&[0, 0, 1, 2]) {
        let layout = machine.memory.layout.clone();
        let byte = match dice.roll(3) {
            0 => layout.data_blocks[&1].start + dice.roll(DATA_BYTES as u64) as usize,
            _ => layout.bit_memory.start + dice.of(&[COUNTER / 8 + 1, RESULT / 8, 0, 2]) as usize,
        };
        machine.memory.arena[byte] = dice.of(&[0, 1, 2, 7, 0x84, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn pointers_that_functions_hand_on_lead_to_the_same_on_all_engines() {
    let mut asked = 0;
    for seed in seeds(PROGRAMS) {
        let build = |number: u16| {
            move |b: &mut Builder| {
                let mut dice = Dice(seed * 100 + u64::from(number));
                if number == 0 { caller(b, &mut dice) } else { function(b, &mut dice, number) }
            }
        };
        let builders: Vec<_> = (0..=FUNCTIONS).map(|number| (number, build(number))).collect();
        let id = |number: u16| if number == 0 { BlockId::ob(1) } else { BlockId::fc(number) };
        let parts: Vec<_> = builders.iter().map(|(number, build)| (id(*number), LOCAL_BYTES, build as &dyn Fn(&mut Builder))).collect();
        let program = program(&parts);
        let layout = layout_with(&program, DATA_BYTES);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[5, 40, 400, 4000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let listing: String = program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect();
        let dice = || Dice(seed + 2_000_000);
        asked += all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &format!("{seed}\n{listing}")).asked.len();
    }
    assert!(asked > 250, "{asked} questions");
}

/// A function hands its pointer on, and uses what it handed on, or left in its local data, as a number.
fn agree_where_a_pointer_is_a_number(is_handed_on: bool) {
    let first = |b: &mut Builder| {
        b.begin_statement();
        let (number, pointer) = given(b);
        let passed = b.compute(Op::PassOnPointer, &[pointer]);
        b.store(local(if is_handed_on { HANDED } else { OWN }), Width::Word, number);
        b.store(local(if is_handed_on { HANDED + 16 } else { OWN + 16 }), Width::DoubleWord, passed);
        if is_handed_on {
            calls(b, &mut Dice(1), 2);
        }
        b.begin_statement();
        let mask = b.constant(0x20);
        let kept = load(b, local(if is_handed_on { HANDED + 16 } else { OWN + 16 }), Width::DoubleWord);
        let by = b.compute(Op::AndU32, &[kept, mask]);
        let (number, pointer) = given(b);
        let pointer = b.compute(Op::AddU32, &[pointer, by]);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        let value = b.constant(1000);
        b.store(Place::Crossing { pointer, offset: 0 }, Width::Word, value);
    };
    let second = |b: &mut Builder| {
        b.begin_statement();
        let (number, pointer) = given(b);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        let value = load(b, Place::Crossing { pointer, offset: 0 }, Width::Word);
        b.store(memory(RESULT), Width::Word, value);
    };
    // The pointer leads to what lies before the counter.
    let outer = |b: &mut Builder| calls_in_a_loop(b, &mut Dice(1), 0x8300_0000 | u64::from(COUNTER - 32), false);
    let program =
        program(&[(BlockId::ob(1), LOCAL_BYTES, &outer), (BlockId::fc(1), LOCAL_BYTES, &first), (BlockId::fc(2), LOCAL_BYTES, &second)]);
    let layout = layout_with(&program, DATA_BYTES);
    all_engines_ask_once(&program, &layout, "a pointer is a number");
}

#[test]
fn a_pointer_that_was_handed_on_is_a_number_too() {
    agree_where_a_pointer_is_a_number(true);
}

#[test]
fn a_pointer_that_stays_in_local_data_is_a_number_too() {
    agree_where_a_pointer_is_a_number(false);
}

/// A function is handed a number before a loop that may ask in each iteration: whether the number is compared there with what it was.
fn is_compared_behind_questions(handed: Option<Range<u32>>) -> bool {
    let main = |b: &mut Builder| {
        b.begin_statement();
        let number = b.constant(1445);
        b.store(local(NUMBER), Width::Word, number);
        let pointer = b.constant(0x8700_0000 | u64::from(NUMBER));
        b.push(Inst::PassParameter { src: pointer });
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 1 });
        for _ in 0..2 {
            b.begin_statement();
            let (counter, one) = (load(b, memory(COUNTER), Width::Word), b.constant(1));
            let next = b.compute(Op::AddU16, &[counter, one]);
            b.store(memory(COUNTER), Width::Word, next);
        }
        let (value, limit) = (load(b, memory(COUNTER), Width::Word), b.constant(100));
        let again = b.compute(Op::LtI16, &[value, limit]);
        b.push(Inst::Branch { condition: again, to: Target(1) });
        b.begin_statement();
        b.push(Inst::Return);
    };
    let function = |b: &mut Builder| {
        b.begin_statement();
        let pointer = b.temporary();
        b.push(Inst::Parameter { dst: pointer, index: 0 });
        let number = load(b, Place::Crossing { pointer, offset: 0 }, Width::Word);
        b.store(memory(RESULT), Width::Word, number);
    };
    let mut program = program(&[(BlockId::ob(1), LOCAL_BYTES, &main), (BlockId::fc(1), 0, &function)]);
    for block in program.code.values_mut() {
        block.reads_own_locals = true;
    }
    program.code.get_mut(&BlockId::ob(1)).expect("the caller").handed = handed.into_iter().collect();
    Jit::listing(&program, &layout_with(&program, DATA_BYTES)).expect("machine code").contains("-1445")
}

#[test]
fn what_was_handed_on_is_not_compared_behind_the_statement_that_did_so() {
    assert!(is_compared_behind_questions(None));
    assert!(!is_compared_behind_questions(Some(NUMBER..NUMBER + 16)));
}
