//! Arrays of function blocks called in loops, under a Host that changes memory, time and budget whenever it is asked: machine code that
//! keeps what it knows over such calls, and remembers what it read of an instance, does what the interpreter does.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, TextAction, TextRoom, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Interpreter, Machine, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, begin_with_instance, engines, layout, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 80;
const HANDING_PROGRAMS: u64 = 160;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 60;
/// Function blocks of a program; each may call those behind it.
const BLOCKS: u16 = 4;
/// The function block with the array.
const LOOPS: u16 = BLOCKS + 1;
/// Bytes of the data block with the instances.
const DATA_BYTES: u64 = 60;
/// Where an instance has the number of a data block, and the pointer for which that counts.
const NUMBER: u32 = 8 * 12;
const POINTER: u32 = 8 * 14;
/// Bytes of bit memory that programs use.
const BYTES: u64 = 8;
const LOCAL_BYTES: u32 = 24;
/// Where loops over instances count.
const COUNTERS: [u32; 3] = [54, 56, 40];
/// Where the present instance is saved over calls.
const SAVED: Place = Place::Fixed { area: Area::Local, position: 8 * 20 };

fn width(dice: &mut Dice) -> Width {
    dice.of(&[Width::Bit, Width::Bit, Width::Byte, Width::Word, Width::DoubleWord])
}

/// A variable of the instance, of bit memory, of local data, or behind a parameter.
fn place(b: &mut Builder, dice: &mut Dice, width: Width, own: bool) -> Place {
    let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
    match dice.roll(10) {
        // What the caller has handed on.
        0 if own => {
            let instance = |offset: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset };
            let number = b.load(instance(NUMBER), Width::Word, OnFault::SkipStatement);
            let pointer = b.load(instance(POINTER), Width::DoubleWord, OnFault::SkipStatement);
            b.push(Inst::Open { register: DataRegister::Shared, number });
            Place::Crossing { pointer, offset: 8 * dice.roll(3) as u32 + bit }
        }
        0..=4 => {
            let byte = dice.roll(if own { 8 } else { DATA_BYTES - 3 }) as u32;
            Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 8 * byte + bit }
        }
        5 if own => {
            let pointer = b.temporary();
            b.push(Inst::Parameter { dst: pointer, index: dice.roll(2) as u16 });
            Place::Crossing { pointer, offset: 8 * dice.roll(2) as u32 + bit }
        }
        6 | 7 => Place::Fixed { area: Area::Local, position: 8 * dice.roll(8) as u32 + bit },
        8 if dice.roll(3) == 0 => Place::Fixed { area: Area::SharedData, position: 8 * dice.roll(DATA_BYTES) as u32 + bit },
        _ => Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(BYTES) as u32 + bit },
    }
}

fn read(b: &mut Builder, dice: &mut Dice, width: Width, own: bool) -> Var {
    if width == Width::DoubleWord && dice.roll(6) == 0 {
        return b.intrinsic(Intrinsic::Clock, &[]);
    }
    let place = place(b, dice, width, own);
    b.load(place, width, OnFault::SkipStatement)
}

/// A statement that computes something.
fn assignment(b: &mut Builder, dice: &mut Dice, own: bool) {
    b.begin_statement();
    let width = width(dice);
    let mut value = read(b, dice, width, own);
    for _ in 0..dice.roll(3) {
        let other = if dice.roll(3) == 0 { b.constant(dice.roll(0x1_0000)) } else { read(b, dice, width, own) };
        value = match width {
            Width::Bit => b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[value, other]),
            Width::DoubleWord => b.compute(dice.of(&[Op::AddU32, Op::SubU32, Op::AddF32, Op::MulF32, Op::MaxI32]), &[value, other]),
            _ => b.compute(dice.of(&[Op::AddU32, Op::SubU32, Op::AddU16]), &[value, other]),
        };
    }
    let to = place(b, dice, width, own);
    b.store(to, width, value);
}

/// A statement with two texts, of which most lie in the instance.
fn text(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let action = dice.of(&TextAction::ALL);
    let any = |dice: &mut Dice| match dice.roll(4) {
        0 => (Place::Fixed { area: Area::Local, position: 8 * dice.roll(8) as u32 }, dice.of(&[1, 3, 6])),
        1 => (Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(BYTES) as u32 }, dice.of(&[0, 1, 4])),
        _ => {
            let offset = 8 * dice.roll(8) as u32;
            (Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset }, dice.of(&[1, 4, 6, 16, 21]))
        }
    };
    let ((to, to_most), (from, from_most)) = (any(dice), any(dice));
    let room = |most: u8| TextRoom::narrow(most);
    let to_room = if action == TextAction::Number { TextRoom::NUMBER } else { room(to_most) };
    let first = b.constant(dice.of(&[0, 1, 2, 0x0D00, 0x3F80_0000, 0xFFFF_FFFF]));
    let count = b.constant(dice.of(&[0, 1, 2, 20]));
    let dst = b.temporary();
    b.push(Inst::Text { action, dst, to, to_room, from, from_room: room(from_most), piece: [first, count] });
    b.store(Place::Fixed { area: Area::BitMemory, position: 0 }, Width::Word, dst);
}

/// A jump over some assignments; how many statements that are.
fn jump(b: &mut Builder, dice: &mut Dice, own: bool, statement: u32) -> u32 {
    b.begin_statement();
    let condition = if dice.roll(2) == 0 {
        read(b, dice, Width::Bit, own)
    } else {
        let (value, limit) = (read(b, dice, Width::Word, own), b.constant(dice.roll(9)));
        b.compute(dice.of(&[Op::LtI16, Op::Equal, Op::GeI16]), &[value, limit])
    };
    let over = 1 + dice.roll(3) as u32;
    b.push(Inst::Branch { condition, to: Target(statement + 1 + over) });
    (0..over).for_each(|_| assignment(b, dice, own));
    1 + over
}

/// A call of a block with at least this number, with pointers to bit memory, local data of the caller, or the data block.
fn call(b: &mut Builder, dice: &mut Dice, first: u16) {
    let number = first + dice.roll(u64::from(BLOCKS + 1 - first)) as u16;
    for _ in 0..2 {
        let code = dice.of(&[0x83, 0x83, 0x87, 0x84, 0x85]);
        let pointer = b.constant((code << 24) | (8 * dice.roll(BYTES)));
        b.push(Inst::PassParameter { src: pointer });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(number)), parameters: 2 });
}

/// The end of a loop: its counter is one more, and the loop goes on at a statement unless the counter is above a limit.
fn count_on(b: &mut Builder, (counter, width): (Place, Width), limit: u64, to: Target) {
    let (value, one) = (b.load(counter, width, OnFault::SkipStatement), b.constant(1));
    let next = b.compute(Op::AddU16, &[value, one]);
    b.store(counter, width, next);
    let limit = b.constant(limit);
    let goes_on = b.compute(Op::LeI16, &[next, limit]);
    b.push(Inst::Branch { condition: goes_on, to });
}

/// A loop of an instance over its own variables, of which some are elements; how many statements that are.
fn own_loop(b: &mut Builder, dice: &mut Dice, first: u32) -> u32 {
    let (at, width) = (8 * dice.roll(8) as u32, dice.of(&[Width::Word, Width::Byte]));
    let index = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: at };
    b.begin_statement();
    let begin = b.constant(0);
    b.store(index, width, begin);
    let mut statements = 1;
    for _ in 0..1 + dice.roll(3) {
        match dice.roll(4) {
            0 => assignment(b, dice, true),
            1 => statements += jump(b, dice, true, first + statements) - 1,
            _ => {
                b.begin_statement();
                let step = dice.of(&[8, 8, 16]);
                let pointer = element(b, dice, (index, width), step);
                let elements = Place::Indirect { area: Area::InstanceData, pointer, offset: 8 * dice.roll(6) as u32 };
                let width = dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::DoubleWord]);
                let (from, to) =
                    if dice.roll(2) == 0 { (elements, place(b, dice, width, true)) } else { (place(b, dice, width, true), elements) };
                let value = b.load(from, width, OnFault::SkipStatement);
                b.store(to, width, value);
            }
        }
        statements += 1;
    }
    b.begin_statement();
    count_on(b, (index, width), dice.of(&[1, 2, 3]), Target(first + 1));
    statements + 1
}

/// A function block.
fn block(b: &mut Builder, dice: &mut Dice, number: u16) {
    let mut statements = 0;
    for _ in 0..1 + dice.roll(5) {
        match dice.roll(7) {
            0 | 1 => statements += jump(b, dice, true, statements),
            3 => statements += own_loop(b, dice, statements),
            4 => {
                text(b, dice);
                statements += 1;
            }
            2 if number < BLOCKS => {
                b.begin_statement();
                b.store(SAVED, Width::DoubleWord, Register::Ar2);
                let by = b.constant(8 * dice.roll(3));
                b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
                call(b, dice, number + 1);
                let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
                b.copy(Register::Ar2, saved);
                statements += 1;
            }
            _ => {
                assignment(b, dice, true);
                statements += 1;
            }
        }
    }
}

/// An element of an array, as an address is computed.
fn element(b: &mut Builder, dice: &mut Dice, index: (Place, Width), step: u64) -> Var {
    let mut number = b.load(index.0, index.1, OnFault::SkipStatement);
    if dice.roll(3) != 0 {
        let count = b.constant(dice.of(&[3, 4, 5]));
        let inside = b.compute(Op::Below, &[number, count]);
        let noted = if dice.roll(2) == 0 { NOTED } else { 0 };
        b.push(Inst::Require { condition: inside, code: noted | 0x22, register: number });
        if noted != 0 {
            number = b.compute(Op::Gate, &[number, inside]);
        }
    }
    let step = b.constant(step);
    let pointer = b.compute(Op::MulU32, &[number, step]);
    b.compute(Op::AddU32, &[Register::Ar2.into(), pointer])
}

/// The organization block.
fn begin(b: &mut Builder) {
    begin_with_instance(b, LOOPS);
}

/// Writes a pointer to an instance, with the number of its data block: to a place that is known, or to an element.
fn hand_on(b: &mut Builder, dice: &mut Dice, index: (Place, Width), instance: Var) {
    let place = |offset: u32| Place::Indirect { area: Area::InstanceData, pointer: instance, offset };
    let number = b.constant(dice.of(&[1, 1, 1, 1, 1, 1, 0, 9]));
    let area = dice.of(&[0x84, 0x84, 0x84, 0x84, 0x84, 0x83, 0x87, 0x85]);
    let mut pointer = b.constant((area << 24) | (8 * dice.of(&[0, 4, 12, 14, 38, 40, 44, 50, 52, 53, 55])));
    if dice.roll(3) == 0 {
        let number = b.load(index.0, index.1, OnFault::SkipStatement);
        let step = b.constant(dice.of(&[8, 16, 64]));
        let by = b.compute(Op::MulU32, &[number, step]);
        pointer = b.compute(Op::AddU32, &[pointer, by]);
    }
    b.store(place(NUMBER), Width::Word, number);
    b.store(place(POINTER), Width::DoubleWord, pointer);
}

/// A loop over three instances that are handed pointers, and whose index is used before the call and behind it.
fn hands_on(b: &mut Builder, dice: &mut Dice) {
    let counter = dice.of(&[
        Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 8 * COUNTERS[0] },
        Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 8 * COUNTERS[1] },
        Place::Fixed { area: Area::BitMemory, position: 8 * 5 },
        Place::Fixed { area: Area::Local, position: 8 * 2 },
    ]);
    b.begin_statement();
    let first = b.constant(0);
    b.store(counter, Width::Word, first);
    for _ in 0..1 + dice.roll(2) {
        b.begin_statement();
        // It is known to be that without memory which the called block may write.
        b.set(Register::Ar2, 0x8400_0000);
        let instance = |b: &mut Builder| {
            let (number, count) = (b.load(counter, Width::Word, OnFault::SkipStatement), b.constant(3));
            let inside = b.compute(Op::Below, &[number, count]);
            b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
            let (number, step) = (b.compute(Op::Gate, &[number, inside]), b.constant(8 * 18));
            let by = b.compute(Op::MulU32, &[number, step]);
            b.compute(Op::AddU32, &[Register::Ar2.into(), by])
        };
        let to = instance(b);
        hand_on(b, dice, (counter, Width::Word), to);
        if dice.roll(3) == 0 {
            let (to, width) = (instance(b), dice.of(&[Width::Byte, Width::Word]));
            let value = b.constant(dice.roll(0x100));
            b.store(Place::Indirect { area: Area::InstanceData, pointer: to, offset: 8 * dice.roll(14) as u32 }, width, value);
        }
        let of = instance(b);
        b.copy(Register::Ar2, of);
        call(b, dice, 1);
        if dice.roll(2) == 0 {
            b.begin_statement();
            b.set(Register::Ar2, 0x8400_0000);
            let of = instance(b);
            let value = b.load(counter, Width::Byte, OnFault::SkipStatement);
            b.store(Place::Indirect { area: Area::InstanceData, pointer: of, offset: 8 * dice.roll(12) as u32 }, Width::Byte, value);
        }
    }
    b.begin_statement();
    b.set(Register::Ar2, 0x8400_0000);
    count_on(b, (counter, Width::Word), 2, Target(1));
}

/// Copies bytes between the instance, what was handed to it, and other memory.
fn takes_bytes(b: &mut Builder, dice: &mut Dice) {
    let instance = |offset: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset };
    let end = |b: &mut Builder, dice: &mut Dice| match dice.roll(8) {
        0 => Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(BYTES) as u32 },
        1 => Place::Fixed { area: Area::Local, position: 8 * dice.roll(8) as u32 },
        2..=4 => instance(8 * dice.of(&[0, 1, 2, 4, 6, 7, 12])),
        _ => {
            let number = b.load(instance(NUMBER), Width::Word, OnFault::SkipStatement);
            let pointer = b.load(instance(POINTER), Width::DoubleWord, OnFault::SkipStatement);
            let shift = b.constant(32);
            let high = b.compute(Op::Shl64, &[number, shift]);
            let pointer = b.compute(Op::OrU64, &[high, pointer]);
            Place::Crossing { pointer, offset: 8 * dice.roll(3) as u32 }
        }
    };
    let (from, to) = (end(b, dice), end(b, dice));
    b.push(Inst::Move { from, to, bytes: dice.of(&[2, 3, 4, 6]) });
}

/// A function block that works with what it was handed.
fn takes(b: &mut Builder, dice: &mut Dice) {
    let instance = |offset: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset };
    let mut statement = 0;
    for _ in 0..1 + dice.roll(4) {
        if dice.roll(4) == 0 {
            b.begin_statement();
            let condition = b.load(instance(dice.roll(64) as u32), Width::Bit, OnFault::SkipStatement);
            b.push(Inst::Branch { condition, to: Target(statement + 2) });
            statement += 1;
        }
        b.begin_statement();
        statement += 1;
        if dice.roll(3) == 0 {
            takes_bytes(b, dice);
            continue;
        }
        let width = dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::DoubleWord]);
        let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
        let place = |b: &mut Builder, dice: &mut Dice| match dice.roll(20) {
            0 => instance(8 * dice.of(&[11, 12, 14, 16]) + bit),
            1 => Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(BYTES) as u32 + bit },
            2..=8 => instance(8 * dice.roll(9) as u32 + bit),
            _ => {
                let number = b.load(instance(NUMBER), Width::Word, OnFault::SkipStatement);
                let pointer = b.load(instance(POINTER), Width::DoubleWord, OnFault::SkipStatement);
                b.push(Inst::Open { register: DataRegister::Shared, number });
                Place::Crossing { pointer, offset: 8 * dice.roll(3) as u32 + bit }
            }
        };
        let from = place(b, dice);
        let value = b.load(from, width, OnFault::SkipStatement);
        let other = b.constant(dice.of(&[0, 1, 3]));
        let value = if width == Width::Bit { b.compute(Op::Xor, &[value, other]) } else { b.compute(Op::AddU32, &[value, other]) };
        let to = place(b, dice);
        if dice.roll(4) == 0 {
            // Perhaps where its own pointer goes, or that of another one.
            let position = b.constant(8 * u64::from(dice.of(&COUNTERS)));
            let to = if dice.roll(8) == 0 { instance(POINTER + 16) } else { to };
            b.store(to, Width::Word, position);
        } else {
            b.store(to, width, value);
        }
    }
    // Where the last jump goes.
    b.begin_statement();
    let value = b.load(instance(0), Width::Byte, OnFault::SkipStatement);
    b.store(instance(8), Width::Byte, value);
}

/// Loops over instances.
fn loops(b: &mut Builder, dice: &mut Dice) {
    let mut statements = 0;
    for _ in 0..1 + dice.roll(2) {
        let position = 8 * COUNTERS[dice.roll(3) as usize];
        let place = dice.of(&[
            Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: position },
            Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: position },
            Place::Fixed { area: Area::BitMemory, position: 8 * 5 },
            Place::Fixed { area: Area::Local, position: 8 * 2 },
        ]);
        let index = (place, dice.of(&[Width::Word, Width::DoubleWord, Width::Byte]));
        let step = 8 * dice.of(&[4, 8, 9, 18, 18]);
        b.begin_statement();
        let first = b.constant(dice.roll(2));
        b.store(index.0, index.1, first);
        statements += 1;
        let head = statements;
        for _ in 0..1 + dice.roll(4) {
            match dice.roll(6) {
                0 => assignment(b, dice, false),
                1 => {
                    statements += jump(b, dice, false, statements) - 1;
                }
                2 => {
                    b.begin_statement();
                    let pointer = element(b, dice, index, step);
                    let value =
                        b.load(Place::Indirect { area: Area::InstanceData, pointer, offset: 8 }, Width::Word, OnFault::SkipStatement);
                    b.store(Place::Fixed { area: Area::BitMemory, position: 0 }, Width::Word, value);
                }
                _ => {
                    b.begin_statement();
                    let pointer = element(b, dice, index, step);
                    let offset = 8 * dice.roll(6) as u32;
                    let width = width(dice);
                    let value = read(b, dice, width, false);
                    b.store(Place::Indirect { area: Area::InstanceData, pointer, offset }, width, value);
                    if dice.roll(3) != 0 {
                        hand_on(b, dice, index, pointer);
                    }
                    b.store(SAVED, Width::DoubleWord, Register::Ar2);
                    b.copy(Register::Ar2, pointer);
                    call(b, dice, 1);
                    let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
                    b.copy(Register::Ar2, saved);
                }
            }
            statements += 1;
        }
        b.begin_statement();
        let (value, one) = (b.load(index.0, index.1, OnFault::SkipStatement), b.constant(1));
        let next = b.compute(if index.1 == Width::Word { Op::AddU16 } else { Op::AddU32 }, &[value, one]);
        b.store(index.0, index.1, next);
        let limit = b.constant(dice.of(&[2, 3, 3, 4]));
        let goes_on = b.compute(if index.1 == Width::Word { Op::LeI16 } else { Op::LeI32 }, &[next, limit]);
        b.push(Inst::Branch { condition: goes_on, to: Target(head) });
        statements += 1;
    }
}

/// Changes a few bytes, the time and the budget, sometimes, and goes on.
fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 40]);
    machine.clock_us += dice.of(&[0, 0, 10_000, 50_000]);
    for _ in 0..dice.of(&[0, 0, 1, 1, 3]) {
        let value = dice.of(&[0, 1, 2, 3, 7, 0x80, 0xFF, 0xB0, 0xC0]);
        if dice.roll(3) != 0 {
            let range = machine.memory.layout.data_blocks[&1].clone();
            // Mostly what the loops count with.
            let near = dice.of(&[40, 54, 54, u64::from(NUMBER / 8), u64::from(NUMBER / 8) + 18, u64::from(POINTER / 8)]);
            let byte = if dice.roll(3) == 0 { dice.roll(DATA_BYTES) } else { near + dice.roll(6) };
            machine.memory.arena[range.start + byte as usize] = value;
        } else {
            machine.memory.area_mut(Area::BitMemory)[dice.roll(BYTES) as usize] = value;
        }
    }
    Reaction::Continue
}

#[test]
fn instances_called_in_loops_do_the_same_on_all_engines() {
    compare(PROGRAMS, &|number, seed| {
        Box::new(move |b: &mut Builder| match number {
            0 => begin(b),
            LOOPS => loops(b, &mut Dice(seed * 100)),
            number => block(b, &mut Dice(seed * 100 + u64::from(number)), number),
        })
    });
}

#[test]
fn pointers_that_are_handed_to_instances_lead_to_the_same_places_on_all_engines() {
    compare(HANDING_PROGRAMS, &|number, seed| {
        Box::new(move |b: &mut Builder| match number {
            0 => begin(b),
            LOOPS => hands_on(b, &mut Dice(seed * 100)),
            number => takes(b, &mut Dice(seed * 100 + u64::from(number))),
        })
    });
}

/// Writes a block.
type Build = Box<dyn Fn(&mut Builder)>;

/// Compares what programs do on all engines. `build` writes a block of a program.
fn compare(programs: u64, build: &dyn Fn(u16, u64) -> Build) {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(programs) {
        let blocks: Vec<_> = (0..=LOOPS).collect();
        let builders: Vec<_> = blocks.iter().map(|&number| build(number, seed)).collect();
        let id = |number: u16| if number == 0 { BlockId::ob(1) } else { BlockId::fb(number) };
        let parts: Vec<_> =
            blocks.iter().zip(&builders).map(|(&number, build)| (id(number), LOCAL_BYTES, &**build as &dyn Fn(&mut Builder))).collect();
        let program = program(&parts);
        let mut layout = layout(&program);
        layout.data_blocks.insert(1, layout.size - 64..layout.size - 64 + DATA_BYTES as usize);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[5, 40, 400]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let outcome = |engine: Arc<dyn Engine>| {
            let (dice, seen) = (RefCell::new(Dice(seed + 2_000_000)), RefCell::new(Vec::new()));
            let answer = |machine: &mut Machine, what: &str, asked: usize| {
                let memory = &machine.memory;
                let (local, data) = (memory.layout.local.clone(), memory.layout.data_blocks[&1].clone());
                let local = memory.arena[local.start..local.start + 5 * LOCAL_BYTES as usize].to_vec();
                seen.borrow_mut().push((machine.budget, local, memory.area(Area::BitMemory)[..8].to_vec(), memory.arena[data].to_vec()));
                meddle(machine, what, &mut dice.borrow_mut(), asked)
            };
            let outcome = run(engine.as_ref(), &layout, &entry, &prepare, &answer);
            (outcome, seen.into_inner())
        };
        let (expected, expected_seen) = outcome(Interpreter::load(&program, &layout));
        for status in [StatusBits::All, StatusBits::Needed] {
            let (got, got_seen) = outcome(Jit::compiled(&program, &layout, status).expect("machine code"));
            let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
            assert_eq!(got.asked, expected.asked, "{seed} {status:?}\n{}", listing());
            let differs = (0..expected_seen.len()).find(|&at| got_seen[at] != expected_seen[at]);
            if let Some(at) = differs {
                let (got, expected, what) = (&got_seen[at], &expected_seen[at], &expected.asked[at]);
                panic!("{seed} {status:?}: question {at}, {what}: {got:?} and {expected:?}\n{}", listing());
            }
            got.assert_ends_as(&expected, &|| format!("{seed} {status:?}\n{}", listing()));
        }
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 250 && finished > 10, "{asked} questions, {finished} runs to the end");
}

#[test]
fn an_index_that_is_changed_while_an_instance_runs_is_looked_at_again() {
    let index = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 8 * 40 };
    let main = |b: &mut Builder| {
        b.begin_statement();
        let first = b.constant(0);
        b.store(index, Width::Word, first);
        b.begin_statement();
        let number = b.load(index, Width::Word, OnFault::SkipStatement);
        let step = b.constant(64);
        let by = b.compute(Op::MulU32, &[number, step]);
        b.store(SAVED, Width::DoubleWord, Register::Ar2);
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(1)), parameters: 0 });
        let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
        b.copy(Register::Ar2, saved);
        b.begin_statement();
        let number = b.load(index, Width::Word, OnFault::SkipStatement);
        let step = b.constant(64);
        let by = b.compute(Op::MulU32, &[number, step]);
        let pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
        b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 16 }, Width::Word, number);
        b.begin_statement();
        count_on(b, (index, Width::Word), 3, Target(1));
    };
    let counts = |b: &mut Builder| {
        b.begin_statement();
        let own = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 0 };
        let (value, one) = (b.load(own, Width::Word, OnFault::SkipStatement), b.constant(1));
        let next = b.compute(Op::AddU16, &[value, one]);
        b.store(own, Width::Word, next);
    };
    let program = program(&[(BlockId::ob(1), LOCAL_BYTES, &begin), (BlockId::fb(LOOPS), LOCAL_BYTES, &main), (BlockId::fb(1), 0, &counts)]);
    let mut layout = layout(&program);
    layout.data_blocks.insert(1, layout.size - 64..layout.size - 64 + DATA_BYTES as usize);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    // Each question in iteration changes the index to one that is outside, and all others leave it.
    let engines = engines(&program, &layout);
    for which in 0..12 {
        let outcome = |engine: Arc<dyn Engine>| {
            let answer = |machine: &mut Machine, _: &str, asked: usize| {
                // The next safe point asks again, be it that of the loop or of the instance.
                machine.budget = 0;
                let range = machine.memory.layout.data_blocks[&1].clone();
                if asked == which {
                    machine.memory.arena[range.start + 41] = 6;
                }
                Reaction::Continue
            };
            run(engine.as_ref(), &layout, &entry, &|_| {}, &answer)
        };
        all_engines_agree(&engines, false, &outcome, &|| which.to_string());
    }
}

#[test]
fn an_element_that_is_the_index_of_others_is_written_on_all_engines() {
    let own = |byte: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 8 * byte };
    let index = Place::Fixed { area: Area::BitMemory, position: 0 };
    let main = |b: &mut Builder| {
        b.begin_statement();
        let first = b.constant(0);
        b.store(index, Width::Word, first);
        b.begin_statement();
        let number = b.load(index, Width::Word, OnFault::SkipStatement);
        let count = b.constant(4);
        let inside = b.compute(Op::Below, &[number, count]);
        b.push(Inst::Require { condition: inside, code: 0x22, register: number });
        let step = b.constant(64);
        let by = b.compute(Op::MulU32, &[number, step]);
        b.store(SAVED, Width::DoubleWord, Register::Ar2);
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(1)), parameters: 0 });
        let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
        b.copy(Register::Ar2, saved);
        b.begin_statement();
        count_on(b, (index, Width::Word), 3, Target(1));
    };
    // Byte 0 is the index of a read; the byte to which byte 2 counts is written in between: this one, another one, one of another instance.
    let counts = |b: &mut Builder| {
        let element = |b: &mut Builder, of: u32| {
            let (number, step) = (b.load(own(of), Width::Byte, OnFault::SkipStatement), b.constant(8));
            let by = b.compute(Op::MulU32, &[number, step]);
            b.compute(Op::AddU32, &[Register::Ar2.into(), by])
        };
        b.begin_statement();
        let one = b.constant(1);
        b.store(own(0), Width::Byte, one);
        b.begin_statement();
        let pointer = element(b, 2);
        let value = b.constant(4);
        b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 0 }, Width::Byte, value);
        b.begin_statement();
        let pointer = element(b, 0);
        let value = b.load(Place::Indirect { area: Area::InstanceData, pointer, offset: 0 }, Width::Byte, OnFault::SkipStatement);
        b.store(own(6), Width::Byte, value);
    };
    let program = program(&[(BlockId::ob(1), LOCAL_BYTES, &begin), (BlockId::fb(LOOPS), LOCAL_BYTES, &main), (BlockId::fb(1), 0, &counts)]);
    let mut layout = layout(&program);
    layout.data_blocks.insert(1, layout.size - 64..layout.size - 64 + DATA_BYTES as usize);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let engines = engines(&program, &layout);
    for element in [0, 1, 5, 6, 8, 14, 40, 200] {
        let outcome = |engine: Arc<dyn Engine>| {
            let prepare = |machine: &mut Machine| {
                machine.budget = 100;
                let range = machine.memory.layout.data_blocks[&1].clone();
                let data = &mut machine.memory.arena[range];
                (0_u8..).zip(data.iter_mut()).for_each(|(at, byte)| *byte = if at % 8 == 2 { element } else { at });
            };
            run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
        };
        all_engines_agree(&engines, false, &outcome, &|| format!("element {element}"));
    }
}

#[test]
fn a_block_that_changes_a_pointer_in_its_instance_writes_where_that_goes_now() {
    let own = |offset: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset };
    let index = own(8 * COUNTERS[0]);
    let element = |b: &mut Builder| {
        let (number, step) = (b.load(index, Width::Word, OnFault::SkipStatement), b.constant(8 * 18));
        let by = b.compute(Op::MulU32, &[number, step]);
        b.compute(Op::AddU32, &[Register::Ar2.into(), by])
    };
    let main = |b: &mut Builder| {
        b.begin_statement();
        let first = b.constant(0);
        b.store(index, Width::Word, first);
        b.begin_statement();
        b.set(Register::Ar2, 0x8400_0000);
        let to = element(b);
        let (number, pointer) = (b.constant(1), b.constant(0x8400_0000));
        b.store(Place::Indirect { area: Area::InstanceData, pointer: to, offset: NUMBER }, Width::Word, number);
        b.store(Place::Indirect { area: Area::InstanceData, pointer: to, offset: POINTER }, Width::DoubleWord, pointer);
        let of = element(b);
        b.copy(Register::Ar2, of);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(1)), parameters: 0 });
        b.begin_statement();
        b.set(Register::Ar2, 0x8400_0000);
        let to = element(b);
        let value = b.load(index, Width::Byte, OnFault::SkipStatement);
        b.store(Place::Indirect { area: Area::InstanceData, pointer: to, offset: 16 }, Width::Byte, value);
        b.begin_statement();
        b.set(Register::Ar2, 0x8400_0000);
        count_on(b, (index, Width::Word), 2, Target(1));
    };
    // The lower half of the pointer, and then 16#7F where it goes: the upper half of the index.
    let changes = |b: &mut Builder| {
        b.begin_statement();
        let position = b.constant(8 * u64::from(COUNTERS[0]));
        b.store(own(POINTER + 16), Width::Word, position);
        b.begin_statement();
        let number = b.load(own(NUMBER), Width::Word, OnFault::SkipStatement);
        let pointer = b.load(own(POINTER), Width::DoubleWord, OnFault::SkipStatement);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        let value = b.constant(0x7F);
        b.store(Place::Crossing { pointer, offset: 0 }, Width::Byte, value);
    };
    let program =
        program(&[(BlockId::ob(1), LOCAL_BYTES, &begin), (BlockId::fb(LOOPS), LOCAL_BYTES, &main), (BlockId::fb(1), 0, &changes)]);
    let mut layout = layout(&program);
    layout.data_blocks.insert(1, layout.size - 64..layout.size - 64 + DATA_BYTES as usize);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let outcome =
        |engine: Arc<dyn Engine>| run(engine.as_ref(), &layout, &entry, &|machine| machine.budget = 100, &|_, _, _| Reaction::Continue);
    all_engines_agree(&engines(&program, &layout), false, &outcome, &|| String::new());
}

/// A loop over three instances that write an element of their own, of so many, by an index that is noted where it is outside; the counter
/// of the loop lies behind the instances.
fn writes_elements(count: u64, noted: bool) -> sieben_engine::Program {
    let own = |byte: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 8 * byte };
    let index = own(COUNTERS[0]);
    let main = |b: &mut Builder| {
        b.begin_statement();
        let first = b.constant(0);
        b.store(index, Width::Word, first);
        b.begin_statement();
        let (number, step) = (b.load(index, Width::Word, OnFault::SkipStatement), b.constant(8 * 18));
        let by = b.compute(Op::MulU32, &[number, step]);
        b.store(SAVED, Width::DoubleWord, Register::Ar2);
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(1)), parameters: 0 });
        let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
        b.copy(Register::Ar2, saved);
        b.begin_statement();
        let (number, step) = (b.load(index, Width::Word, OnFault::SkipStatement), b.constant(8 * 18));
        let by = b.compute(Op::MulU32, &[number, step]);
        let pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
        b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 8 * 16 }, Width::Byte, number);
        b.begin_statement();
        count_on(b, (index, Width::Word), 2, Target(1));
    };
    let writes = |b: &mut Builder| {
        b.begin_statement();
        let (number, limit) = (b.load(own(0), Width::Word, OnFault::SkipStatement), b.constant(count));
        let inside = b.compute(Op::Below, &[number, limit]);
        let mut at = number;
        if noted {
            b.push(Inst::Require { condition: inside, code: NOTED | 0x23, register: number });
            at = b.compute(Op::Gate, &[number, inside]);
        }
        let step = b.constant(16);
        let by = b.compute(Op::MulU32, &[at, step]);
        let pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
        let value = b.constant(1);
        b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 16 }, Width::Word, value);
    };
    program(&[(BlockId::ob(1), LOCAL_BYTES, &begin), (BlockId::fb(LOOPS), LOCAL_BYTES, &main), (BlockId::fb(1), 0, &writes)])
}

fn layout_of_instances(program: &sieben_engine::Program) -> sieben_engine::Layout {
    let mut layout = layout(program);
    layout.data_blocks.insert(1, layout.size - 64..layout.size - 64 + DATA_BYTES as usize);
    layout
}

#[test]
fn an_element_that_a_block_writes_by_an_index_that_is_noted_may_be_the_counter_of_its_caller() {
    // With 8 elements the last one of the last instance ends before the counter, with more it is the counter, or lies behind it.
    for (count, noted) in [(1, true), (8, true), (9, true), (10, true), (28, true), (9, false)] {
        let program = writes_elements(count, noted);
        let layout = layout_of_instances(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let engines = engines(&program, &layout);
        for number in [0, 7, 8, 9, 17, 18, 27, 200] {
            for budget in [3, 100] {
                let outcome = |engine: Arc<dyn Engine>| {
                    let prepare = |machine: &mut Machine| {
                        machine.budget = budget;
                        let range = machine.memory.layout.data_blocks[&1].clone();
                        for instance in 0..3 {
                            machine.memory.arena[range.start + 18 * instance + 1] = number;
                        }
                    };
                    // The counter may never come to its end.
                    let answer = |machine: &mut Machine, what: &str, asked: usize| {
                        if what.starts_with("safe point") {
                            machine.budget = 5;
                        }
                        if asked < 40 {
                            Reaction::Continue
                        } else {
                            Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> })
                        }
                    };
                    run(engine.as_ref(), &layout, &entry, &prepare, &answer)
                };
                all_engines_agree(&engines, false, &outcome, &|| format!("{count} elements, {noted}, element {number}"));
            }
        }
    }
}

#[test]
fn what_a_loop_knows_stays_known_over_a_block_that_writes_an_element_of_its_own() {
    // Where the counter may be one of the elements, it is looked at again behind the call, with a way for an index that is outside.
    let lines = |count: u64| {
        let program = writes_elements(count, true);
        Jit::listing(&program, &layout_of_instances(&program)).expect("machine code").lines().count()
    };
    let [less, more, most] = [lines(8), lines(9), lines(10)];
    assert!(less + 20 < more, "{less} and {more} lines");
    assert!(more.abs_diff(most) < 20, "{more} and {most} lines");
}
