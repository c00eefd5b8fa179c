//! Functions that are given two structures by pointers, copy one to the other or to themselves, and hand both on to others, also from the
//! local data of their callers: what a loop knows over such calls is what the interpreter finds, whatever a Host does that is asked.

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, all_engines_ask_once, count_on, engines, layout_with, program};

const PROGRAMS: u64 = 350;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Functions of a program; each may hand on to those behind it.
const FUNCTIONS: u16 = 4;
/// In the local data of each block: what it hands on, a number of its own, AR2, a counter, elements that pointers lead to.
const HANDED: [u32; 2] = [0, 8 * 8];
const OWN: u32 = 8 * 16;
const SAVED: u32 = 8 * 20;
const COUNTER: u32 = 8 * 24;
const ELEMENTS: u32 = 8 * 28;
const LOCAL_BYTES: u32 = 80;
const RESULT: u32 = 8 * 44;
const DATA_BYTES: usize = 160;
/// Where a pointer of 64 bits has the number of the data block.
const NUMBER_SHIFT: u64 = 32;

fn local(position: u32) -> Place {
    Place::Fixed { area: Area::Local, position }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

/// Data block number and pointer that a function was given.
fn given(b: &mut Builder, index: u16) -> (Var, Var) {
    let parameter = b.temporary();
    b.push(Inst::Parameter { dst: parameter, index });
    let number = load(b, Place::Crossing { pointer: parameter, offset: 0 }, Width::Word);
    let pointer = load(b, Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord);
    (number, pointer)
}

/// Numbers that follow one another in no order, and whether functions do what no compiler writes.
struct Makes {
    dice: Dice,
    wild: bool,
}

impl Makes {
    fn roll(&mut self, sides: u64) -> u64 {
        self.dice.roll(sides)
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        self.dice.of(all)
    }
}

/// Bits to an element, below a limit or any.
fn element(b: &mut Builder, dice: &mut Makes) -> Var {
    let number = load(b, local(OWN), Width::Word);
    let limit = b.constant(4);
    let below = b.compute(Op::Below, &[number, limit]);
    let index = if dice.wild && dice.roll(8) == 0 { number } else { b.compute(Op::Gate, &[number, below]) };
    let step = b.constant(16);
    b.compute(Op::MulU32, &[index, step])
}

/// A pointer of 64 bits, mostly one as programs have it.
fn far(b: &mut Builder, dice: &mut Makes) -> Var {
    let (number, pointer) = given(b, dice.of(&[0, 1]));
    let first = dice.roll(4) == 0;
    let pointer = if first {
        let bits = element(b, dice);
        b.compute(Op::AddU32, &[pointer, bits])
    } else {
        pointer
    };
    let shift = b.constant(if dice.wild { dice.of(&[NUMBER_SHIFT, NUMBER_SHIFT, 33]) } else { NUMBER_SHIFT });
    let high = b.compute(Op::Shl64, &[number, shift]);
    let whole = b.compute(Op::OrU64, &[high, pointer]);
    if first || dice.roll(3) != 0 {
        return whole;
    }
    // The low half alone is moved.
    let bits = element(b, dice);
    let low = b.compute(Op::AddU32, &[whole, bits]);
    let number = b.compute(Op::Shr64, &[whole, shift]);
    let high = b.compute(Op::Shl64, &[number, shift]);
    b.compute(Op::OrU64, &[high, low])
}

fn copies(b: &mut Builder, dice: &mut Makes) {
    b.begin_statement();
    let mut place = |b: &mut Builder| match dice.roll(4) {
        0 => local(dice.of(&[ELEMENTS, ELEMENTS + 64, OWN])),
        _ => Place::Crossing { pointer: far(b, dice), offset: dice.of(&[0, 0, 16, 32]) },
    };
    let (from, to) = (place(b), place(b));
    b.push(Inst::Move { from, to, bytes: dice.of(&[2, 4, 8, 12]) });
}

/// Reads and writes behind a pointer, or what a pointer is as a number.
fn assigns(b: &mut Builder, dice: &mut Makes) {
    b.begin_statement();
    let value = match dice.roll(5) {
        0 => b.constant(dice.roll(7)),
        1 if dice.wild => {
            let (pointer, mask, shift) =
                (far(b, dice), b.constant(dice.of(&[0x30, 0x3_0000_0000])), b.constant(dice.of(&[4, NUMBER_SHIFT])));
            let bits = b.compute(Op::AndU64, &[pointer, mask]);
            b.compute(Op::Shr64, &[bits, shift])
        }
        _ => {
            let (number, pointer) = given(b, dice.of(&[0, 1]));
            b.push(Inst::Open { register: DataRegister::Shared, number });
            load(b, Place::Crossing { pointer, offset: dice.of(&[0, 16, 32]) }, Width::Word)
        }
    };
    match dice.roll(4) {
        0 => b.store(local(OWN), Width::Word, value),
        1 if dice.wild => {
            let (number, _) = given(b, 0);
            let pointer = far(b, dice);
            b.push(Inst::Open { register: DataRegister::Shared, number });
            b.store(Place::Crossing { pointer, offset: 0 }, Width::Word, value);
        }
        _ => {
            let (number, pointer) = given(b, dice.of(&[0, 1]));
            let bits = element(b, dice);
            let pointer = b.compute(Op::AddU32, &[pointer, bits]);
            b.push(Inst::Open { register: DataRegister::Shared, number });
            b.store(Place::Crossing { pointer, offset: dice.of(&[0, 16]) }, Width::Word, value);
        }
    }
}

/// Hands on what was given, in this order or the other, or something of its own.
fn hands_on(b: &mut Builder, dice: &mut Makes, function: u16) {
    b.begin_statement();
    let first = dice.roll(2) as u16;
    for (at, index) in [(HANDED[0], first), (HANDED[1], 1 - first)] {
        let (number, pointer) = if dice.roll(4) == 0 {
            let own = dice.of(&[ELEMENTS, ELEMENTS, HANDED[0], HANDED[1], OWN]);
            (b.constant(0), b.constant(0x8700_0000 | u64::from(own)))
        } else {
            let (number, pointer) = given(b, index);
            (number, b.compute(Op::PassOnPointer, &[pointer]))
        };
        b.store(local(at), Width::Word, number);
        b.store(local(at + 16), Width::DoubleWord, pointer);
    }
    call(b, function);
}

fn call(b: &mut Builder, function: u16) {
    for position in HANDED {
        let pointer = b.constant(0x8700_0000 | u64::from(position));
        b.push(Inst::PassParameter { src: pointer });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fc(function)), parameters: 2 });
}

fn function(b: &mut Builder, dice: &mut Makes, number: u16) {
    b.begin_statement();
    let first = b.constant(dice.roll(4));
    b.store(local(OWN), Width::Word, first);
    for _ in 0..1 + dice.roll(3) {
        match dice.roll(5) {
            0 => assigns(b, dice),
            1 | 2 if number < FUNCTIONS => hands_on(b, dice, number + 1),
            _ => copies(b, dice),
        }
    }
    b.begin_statement();
    let value = load(b, local(dice.of(&[ELEMENTS, OWN])), Width::Word);
    b.store(Place::Fixed { area: Area::BitMemory, position: RESULT }, Width::Word, value);
}

/// A loop that keeps its counter and AR2 in its local data, and writes to an instance behind the call.
fn caller(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let ar2 = Register::Ar2.into();
    let counter = match dice.roll(2) {
        0 => local(COUNTER),
        _ => Place::Indirect { area: Area::InstanceData, pointer: ar2, offset: 0 },
    };
    for register in [DataRegister::Shared, DataRegister::Instance] {
        let number = b.constant(1);
        b.push(Inst::Open { register, number });
    }
    b.set(Register::Ar2, 0x8400_0000);
    let first = b.constant(0);
    b.store(counter, Width::Word, first);
    let before = 0x8700_0000 | u64::from(dice.of(&[COUNTER, SAVED, SAVED + 32]));
    let own = 0x8700_0000 | u64::from(ELEMENTS);
    let all = [(1, 0x8400_0000), (1, 0x8400_0080), (1, 0x8400_0170), (0, own), (0, own), (0, own + 96), (0, 0x8300_0100)];
    let bad = [
        (0, before - 96),
        (0, before - 32),
        (0, before - 16),
        (0, 0x8700_0000),
        (0, 0x8700_0040),
        (1, 0x84FF_FFF0),
        (1, 0x84FF_FFE0),
        (9, 0x8400_0000),
        (0, 0x8400_0000),
        (0, 0x8407_FFF0),
        (1, own),
        (0, 0x87FF_FFE0),
    ];
    b.begin_statement();
    b.store(local(SAVED), Width::DoubleWord, ar2);
    let added = b.constant(dice.of(&[0, 64, 64]));
    b.push(Inst::Compute { op: Op::AddU32, dst: ar2, args: [ar2, added, added, added] });
    for at in HANDED {
        let (number, pointer) = if dice.roll(3) == 0 { dice.of(&bad) } else { dice.of(&all) };
        let number = b.constant(number);
        b.store(local(at), Width::Word, number);
        let pointer = b.constant(pointer);
        b.store(local(at + 16), Width::DoubleWord, pointer);
    }
    call(b, 1);
    let saved = load(b, local(SAVED), Width::DoubleWord);
    b.push(Inst::Compute { op: Op::Copy, dst: ar2, args: [saved; 4] });
    b.begin_statement();
    let number = load(b, counter, Width::Word);
    let shift = b.constant(4);
    let bits = b.compute(Op::Shl32, &[number, shift]);
    let pointer = b.compute(Op::AddU32, &[ar2, bits]);
    b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 8 * 110 }, Width::Word, number);
    b.begin_statement();
    let one = b.constant(1);
    b.store(Place::Indirect { area: Area::InstanceData, pointer: ar2, offset: 8 * 140 }, Width::Word, one);
    let limit = dice.of(&[3, 7, 9]);
    count_on(b, counter, (dice.of(&[Op::LtI16, Op::Below]), limit), Target(1));
}

fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 40, 400]);
    for _ in 0..dice.of(&[0, 0, 1, 2]) {
        let byte = machine.memory.layout.data_blocks[&1].start + dice.roll(DATA_BYTES as u64) as usize;
        machine.memory.arena[byte] = dice.of(&[0, 1, 2, 7, 0x84, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn structures_that_functions_copy_and_hand_on_are_the_same_on_all_engines() {
    let mut asked = 0;
    for seed in seeds(PROGRAMS) {
        let build = |number: u16| {
            move |b: &mut Builder| {
                let mut dice = Dice(seed * 100 + u64::from(number));
                if number == 0 { caller(b, &mut dice) } else { function(b, &mut Makes { dice, wild: seed % 4 == 0 }, number) }
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
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.of(&[0, 0, 1, 2, 3, 0x84, 0x40]));
        };
        let listing: String = program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect();
        let dice = || Dice(seed + 2_000_000);
        asked += all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &format!("{seed}\n{listing}")).asked.len();
    }
    assert!(asked > 250, "{asked} questions");
}

/// A function copies from where a pointer leads, and uses the pointer, or the number where a pointer has it, as a number to find the
/// counter of its caller.
fn agree_where_it_is_a_number(is_pointer: bool) {
    let function = |b: &mut Builder| {
        b.begin_statement();
        let (number, pointer) = given(b, 0);
        let shift = b.constant(NUMBER_SHIFT);
        let high = b.compute(Op::Shl64, &[number, shift]);
        let whole = b.compute(Op::OrU64, &[high, pointer]);
        b.push(Inst::Move { from: Place::Crossing { pointer: whole, offset: 0 }, to: local(ELEMENTS), bytes: 4 });
        b.begin_statement();
        let (number, pointer) = given(b, 0);
        let shift = b.constant(NUMBER_SHIFT);
        let high = b.compute(Op::Shl64, &[number, shift]);
        let bits = if is_pointer {
            let (whole, mask) = (b.compute(Op::OrU64, &[high, pointer]), b.constant(0x20));
            b.compute(Op::AndU64, &[whole, mask])
        } else {
            let (by, mask) = (b.constant(NUMBER_SHIFT - 5), b.constant(0x20));
            let bits = b.compute(Op::Shr64, &[high, by]);
            b.compute(Op::AndU64, &[bits, mask])
        };
        let pointer = b.compute(Op::AddU32, &[pointer, bits]);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        let value = b.constant(1000);
        b.store(Place::Crossing { pointer, offset: 0 }, Width::Word, value);
    };
    let counter = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 0x40 };
    let main = |b: &mut Builder| {
        b.begin_statement();
        for register in [DataRegister::Shared, DataRegister::Instance] {
            let number = b.constant(1);
            b.push(Inst::Open { register, number });
        }
        b.set(Register::Ar2, 0x8400_0000);
        let first = b.constant(0);
        b.store(counter, Width::Word, first);
        b.begin_statement();
        let (number, pointer) = (b.constant(1), b.constant(0x8400_0020));
        b.store(local(HANDED[0]), Width::Word, number);
        b.store(local(HANDED[0] + 16), Width::DoubleWord, pointer);
        call(b, 1);
        b.begin_statement();
        let (number, shift) = (load(b, counter, Width::Word), b.constant(4));
        let bits = b.compute(Op::Shl32, &[number, shift]);
        let pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), bits]);
        b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 8 * 110 }, Width::Word, number);
        b.begin_statement();
        count_on(b, counter, (Op::Below, 9), Target(1));
    };
    let program = program(&[(BlockId::ob(1), LOCAL_BYTES, &main), (BlockId::fc(1), LOCAL_BYTES, &function)]);
    let layout = layout_with(&program, DATA_BYTES);
    all_engines_ask_once(&program, &layout, "a pointer is a number");
}

#[test]
fn a_pointer_of_64_bits_is_a_number_too() {
    agree_where_it_is_a_number(true);
}

#[test]
fn the_number_above_a_pointer_is_a_number_too() {
    agree_where_it_is_a_number(false);
}
