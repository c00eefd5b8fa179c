//! Loops over arrays of function blocks with other function blocks in them, whose inputs are written and whose outputs are read by the same
//! index: what machine code counts from one element is what the interpreter finds, wherever instances and copies lie and whatever a Host
//! does.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, FaultPlace, Layout, Machine, Program, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, begin_with_instance, engines, layout_with, next_iteration, program, run, run_beside};

/// Programs that are compared.
const PROGRAMS: u64 = 200;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 60;
/// Function blocks of a program; each may call those behind it.
const BLOCKS: u16 = 3;
/// The block that calls them in a loop.
const CALLER: u16 = BLOCKS + 1;
/// Elements of two arrays with the same step: of structures, and of instances behind them, which end where the data block does.
const ELEMENTS: u64 = 3;
const STEP: u64 = 24;
const STRUCTURES: u32 = 8 * 8;
const INSTANCES: u32 = STRUCTURES + 8 * (ELEMENTS * STEP) as u32;
const DATA_BYTES: usize = (INSTANCES / 8) as usize + (ELEMENTS * STEP) as usize;
/// Local data: the index of a call, instances that are saved, and what is copied there.
const INDEX: Place = Place::Fixed { area: Area::Local, position: 8 * 16 };
const SAVED: Place = Place::Fixed { area: Area::Local, position: 8 * 20 };
const LOCAL_BYTES: u32 = 24;

fn own(offset: u32) -> Place {
    Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset }
}

fn width(dice: &mut Dice) -> Width {
    dice.of(&[Width::Bit, Width::Bit, Width::Byte, Width::Word, Width::DoubleWord])
}

/// A number of an element, which is looked at, times the step.
fn distance(b: &mut Builder, dice: &mut Dice, index: (Place, Width)) -> Var {
    let mut number = b.load(index.0, index.1, OnFault::SkipStatement);
    let looks = dice.roll(8);
    if looks != 0 {
        let count = b.constant(ELEMENTS + u64::from(looks == 1));
        let inside = b.compute(Op::Below, &[number, count]);
        let noted = if looks > 3 { NOTED } else { 0 };
        b.push(Inst::Require { condition: inside, code: noted | 0x22, register: number });
        if noted != 0 {
            number = b.compute(Op::Gate, &[number, inside]);
        }
    }
    let step = b.constant(8 * if dice.roll(12) == 0 { 2 * STEP } else { STEP });
    b.compute(Op::MulU32, &[number, step])
}

/// A field of an element: of the two arrays, and of what has the same place in the other data block.
fn field(b: &mut Builder, dice: &mut Dice, index: (Place, Width), (bytes, bit): (u32, u32)) -> Place {
    let by = distance(b, dice, index);
    let field = 8 * dice.roll(STEP - u64::from(bytes - 1)) as u32 + bit;
    let offset = field + dice.of(&[STRUCTURES, INSTANCES, INSTANCES]);
    if dice.roll(6) == 0 {
        let number = b.constant(2);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        return Place::Indirect { area: Area::SharedData, pointer: by, offset };
    }
    let mut pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
    let mut offset = offset;
    if dice.roll(4) == 0 {
        // Counted from the element before it.
        let back = b.constant(0x1_0000_0000 - 8 * STEP);
        pointer = b.compute(Op::AddU32, &[pointer, back]);
        offset += 8 * STEP as u32;
    }
    Place::Indirect { area: Area::InstanceData, pointer, offset }
}

fn place(b: &mut Builder, dice: &mut Dice, index: (Place, Width), width: Width) -> Place {
    let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
    match dice.roll(6) {
        0 => Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(8) as u32 + bit },
        1 => Place::Fixed { area: Area::Local, position: 8 * dice.roll(12) as u32 + bit },
        _ => field(b, dice, index, (width.bytes(), bit)),
    }
}

/// Reads something, and writes it or something made of it.
fn assigns(b: &mut Builder, dice: &mut Dice, any: &mut dyn FnMut(&mut Builder, &mut Dice, Width) -> Place) {
    let width = width(dice);
    let from = any(b, dice, width);
    let value = b.load(from, width, OnFault::SkipStatement);
    let other = b.constant(dice.of(&[0, 1, 0x0102_0304]));
    let value = b.compute(if width == Width::Bit { Op::Xor } else { Op::AddU32 }, &[value, other]);
    let to = any(b, dice, width);
    b.store(to, width, value);
}

/// Copies bytes between two elements, or to local data and bit memory.
fn copies(b: &mut Builder, dice: &mut Dice, index: (Place, Width)) {
    let bytes = dice.of(&[2, 3, 6, 8]);
    let mut end = |dice: &mut Dice| match dice.roll(6) {
        0 => Place::Fixed { area: Area::Local, position: 8 * dice.roll(8) as u32 },
        1 => Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(4) as u32 },
        _ => field(b, dice, index, (bytes, 0)),
    };
    let (from, to) = (end(dice), end(dice));
    // What was read or written before it is read again behind it.
    let local = Place::Fixed { area: Area::Local, position: 8 * dice.roll(4) as u32 };
    let looks = dice.roll(2) == 0;
    if looks {
        let value = b.load(local, Width::Word, OnFault::SkipStatement);
        b.store(Place::Fixed { area: Area::BitMemory, position: 0 }, Width::Word, value);
    }
    b.push(Inst::Move { from, to, bytes });
    if looks {
        let value = b.load(local, Width::Word, OnFault::SkipStatement);
        b.store(Place::Fixed { area: Area::BitMemory, position: 8 * 4 }, Width::Word, value);
    }
}

/// Writes inputs of an instance, calls it, and reads from it. Mostly it lies in the own data block.
fn calls_element(b: &mut Builder, dice: &mut Dice, index: (Place, Width)) {
    b.begin_statement();
    let mut index = index;
    if dice.roll(2) == 0 {
        let number = b.load(index.0, index.1, OnFault::SkipStatement);
        b.store(INDEX, Width::DoubleWord, number);
        index = (INDEX, Width::DoubleWord);
    }
    for _ in 0..dice.roll(4) {
        match dice.roll(4) {
            0 => copies(b, dice, index),
            _ => assigns(b, dice, &mut |b, dice, width| place(b, dice, index, width)),
        }
    }
    b.store(SAVED, Width::DoubleWord, Register::Ar2);
    let by = distance(b, dice, index);
    let elsewhere = dice.roll(5) == 0;
    if elsewhere {
        let (number, first) = (b.constant(2), b.constant(0x8400_0000 + u64::from(dice.of(&[0, INSTANCES]))));
        let pointer = b.compute(Op::AddU32, &[first, by]);
        b.push(Inst::Open { register: DataRegister::Instance, number });
        b.copy(Register::Ar2, pointer);
    } else {
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        let first = b.constant(u64::from(INSTANCES));
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), first]);
    }
    let missing = dice.roll(20) == 0;
    let callee = if missing { 99 } else { 1 + dice.roll(2) as u16 };
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(callee)), parameters: 0 });
    let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
    b.copy(Register::Ar2, saved);
    if elsewhere {
        let number = b.constant(1);
        b.push(Inst::Open { register: DataRegister::Instance, number });
    }
}

/// The block with the loop.
fn caller(b: &mut Builder, dice: &mut Dice) {
    let counter = dice.of(&[own(0), Place::Fixed { area: Area::BitMemory, position: 8 * 10 }]);
    let index = (counter, Width::Word);
    b.begin_statement();
    let first = b.constant(0);
    b.store(counter, Width::Word, first);
    let mut statements = 1;
    for _ in 0..2 + dice.roll(4) {
        match dice.roll(5) {
            0 => {
                b.begin_statement();
                copies(b, dice, index);
            }
            1 => {
                b.begin_statement();
                assigns(b, dice, &mut |b, dice, width| place(b, dice, index, width));
            }
            2 => {
                b.begin_statement();
                let condition = b.load(own(8 * 4 + dice.roll(4) as u32), Width::Bit, OnFault::SkipStatement);
                b.push(Inst::Branch { condition, to: Target(statements + 2) });
                b.begin_statement();
                assigns(b, dice, &mut |b, dice, width| place(b, dice, index, width));
                statements += 1;
            }
            _ => calls_element(b, dice, index),
        }
        statements += 1;
    }
    b.begin_statement();
    next_iteration(b, counter, (Op::LeI16, ELEMENTS - 1), Target(1));
}

/// A number in the instance times a step: mostly it is known to be small, and it may be counted from the element in front.
fn own_distance(b: &mut Builder, dice: &mut Dice) -> Var {
    let index = b.load(own(8 * dice.of(&[1, 2])), Width::Byte, OnFault::SkipStatement);
    let index = match dice.roll(6) {
        0 => index,
        1 => {
            let count = b.constant(dice.of(&[2, 2, 3]));
            let inside = b.compute(Op::Below, &[index, count]);
            b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: index });
            b.compute(Op::Gate, &[index, inside])
        }
        _ => {
            let mask = b.constant(dice.of(&[1, 1, 3, 7]));
            b.compute(Op::AndU32, &[index, mask])
        }
    };
    let step = b.constant(dice.of(&[8, 8, 8, 16, 32, 4]));
    let by = b.compute(Op::MulU32, &[index, step]);
    if dice.roll(3) != 0 {
        return by;
    }
    let back = b.constant(0x1_0000_0000 - dice.of(&[8, 16]));
    b.compute(Op::AddU32, &[by, back])
}

/// A function block: assignments, and calls of blocks that lie in its instance, or somewhere else by the same AR2.
fn block(b: &mut Builder, dice: &mut Dice, number: u16) {
    let mut statement = 0;
    let most = [20, 12, 8][usize::from(number - 1)];
    let mut inside = |b: &mut Builder, dice: &mut Dice, width: Width| {
        let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
        match dice.roll(8) {
            0 => Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(8) as u32 + bit },
            1 => {
                if dice.roll(12) == 0 {
                    let number = b.constant(dice.of(&[1, 2]));
                    b.push(Inst::Open { register: DataRegister::Instance, number });
                }
                let by = own_distance(b, dice);
                let pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
                Place::Indirect { area: Area::InstanceData, pointer, offset: 8 * dice.roll(6) as u32 + bit }
            }
            // From where the data block begins, not the instance.
            2 if dice.roll(4) == 0 => {
                let pointer = b.constant(0x8400_0000 + 8 * dice.roll(3));
                Place::Indirect { area: Area::InstanceData, pointer, offset: 8 * dice.roll(12) as u32 + bit }
            }
            _ => own(8 * dice.roll(most) as u32 + bit),
        }
    };
    for _ in 0..1 + dice.roll(5) {
        if dice.roll(4) == 0 {
            b.begin_statement();
            let condition = b.load(own(dice.roll(32) as u32), Width::Bit, OnFault::SkipStatement);
            b.push(Inst::Branch { condition, to: Target(statement + 2) });
            statement += 1;
        }
        b.begin_statement();
        statement += 1;
        if dice.roll(3) == 0 {
            let end = |b: &mut Builder, dice: &mut Dice| match dice.roll(12) {
                // As a pointer to any area.
                0 => Place::Crossing { pointer: Register::Ar2.into(), offset: 8 * dice.roll(6) as u32 },
                _ => inside(b, dice, Width::Byte),
            };
            let (from, to) = (end(b, dice), end(b, dice));
            b.push(Inst::Move { from, to, bytes: dice.of(&[2, 3, 4, 8, 16]) });
            continue;
        }
        if number == BLOCKS || dice.roll(2) == 0 {
            assigns(b, dice, &mut inside);
            continue;
        }
        for _ in 0..dice.roll(3) {
            assigns(b, dice, &mut inside);
        }
        b.store(SAVED, Width::DoubleWord, Register::Ar2);
        let by = b.constant(dice.of(&[0, 8, 32, 32, 64, 64, 96, 33, 34, 128, 8 * 200, 0x00FF_FFC0]));
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        if dice.roll(2) == 0 {
            let by = own_distance(b, dice);
            b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        }
        let elsewhere = dice.roll(8) == 0;
        if elsewhere {
            let number = b.constant(dice.of(&[1, 2]));
            b.push(Inst::Open { register: DataRegister::Instance, number });
        }
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(number + 1 + dice.roll(u64::from(BLOCKS - number)) as u16)), parameters: 0 });
        let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
        b.copy(Register::Ar2, saved);
        if elsewhere {
            let number = b.constant(1);
            b.push(Inst::Open { register: DataRegister::Instance, number });
        }
    }
    b.begin_statement();
    let value = b.load(own(0), Width::Byte, OnFault::SkipStatement);
    b.store(own(8), Width::Byte, value);
}

fn begin(b: &mut Builder) {
    begin_with_instance(b, CALLER);
}

/// Changes a few bytes and the budget, sometimes, and goes on.
fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 40]);
    for _ in 0..dice.of(&[0, 0, 1, 1, 3]) {
        let range = machine.memory.layout.data_blocks[&dice.of(&[1, 1, 2])].clone();
        let byte = if dice.roll(3) == 0 { dice.roll(2) } else { dice.roll(DATA_BYTES as u64) };
        machine.memory.arena[range.start + byte as usize] = dice.of(&[0, 1, 2, 3, 7, 0x80, 0x84, 0xFF]);
    }
    Reaction::Continue
}

fn layout_of(program: &Program) -> Layout {
    let mut layout = layout_with(program, DATA_BYTES);
    layout.data_blocks.insert(2, layout.size..layout.size + DATA_BYTES);
    layout.size += DATA_BYTES;
    layout
}

#[test]
fn instances_in_elements_are_the_same_on_all_engines() {
    let (mut asked, mut silent) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let build = |number: u16| {
            move |b: &mut Builder| match number {
                0 => begin(b),
                CALLER => caller(b, &mut Dice(seed * 100)),
                number => block(b, &mut Dice(seed * 100 + u64::from(number)), number),
            }
        };
        let builders: Vec<_> = (0..=CALLER).map(|number| (number, build(number))).collect();
        let id = |number: u16| if number == 0 { BlockId::ob(1) } else { BlockId::fb(number) };
        let parts: Vec<_> = builders.iter().map(|(number, build)| (id(*number), LOCAL_BYTES, build as &dyn Fn(&mut Builder))).collect();
        let program = program(&parts);
        let mut layout = layout_of(&program);
        if seed % 8 == 0 {
            layout.read_only.push(1 + (seed / 8 % 2) as u16);
        }
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[5, 400, 4000]);
            for number in [1, 2] {
                let range = machine.memory.layout.data_blocks[&number].clone();
                machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            }
        };
        let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        let questions = all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", listing())).asked.len();
        asked += questions;
        silent += usize::from(questions == 0);
    }
    assert!(asked > 250 && silent > 25, "{asked} questions, {silent} programs without any");
}

/// Three instances from a bit on. Each calls one that lies so many bits behind it, and as many bytes more as byte 1 says if that is below
/// 3.
fn indexed(first: u64, behind: u64) -> Program {
    let inside = |b: &mut Builder, index: Place, width: Width| {
        let number = b.load(index, width, OnFault::SkipStatement);
        let count = b.constant(3);
        let inside = b.compute(Op::Below, &[number, count]);
        b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
        b.compute(Op::Gate, &[number, inside])
    };
    let calls = |b: &mut Builder, by: Var, more: u64, callee: u16| {
        b.store(SAVED, Width::DoubleWord, Register::Ar2);
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        let more = b.constant(more);
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), more]);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(callee)), parameters: 0 });
        let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
        b.copy(Register::Ar2, saved);
    };
    let counter = Place::Fixed { area: Area::BitMemory, position: 0 };
    let main = |b: &mut Builder| {
        b.begin_statement();
        let zero = b.constant(0);
        b.store(counter, Width::Word, zero);
        b.begin_statement();
        let (number, step) = (inside(b, counter, Width::Word), b.constant(8 * STEP));
        let by = b.compute(Op::MulU32, &[number, step]);
        calls(b, by, first, 1);
        b.begin_statement();
        next_iteration(b, counter, (Op::LeI16, ELEMENTS - 1), Target(1));
    };
    let outer = |b: &mut Builder| {
        b.begin_statement();
        let (number, step) = (inside(b, own(8), Width::Byte), b.constant(8));
        let by = b.compute(Op::MulU32, &[number, step]);
        calls(b, by, behind, 2);
    };
    let inner = |b: &mut Builder| {
        for byte in [0, 2] {
            b.begin_statement();
            let (value, one) = (b.load(own(8 * byte), Width::Byte, OnFault::SkipStatement), b.constant(1));
            let next = b.compute(Op::AddU32, &[value, one]);
            b.store(own(8 * byte), Width::Byte, next);
        }
    };
    program(&[
        (BlockId::ob(1), LOCAL_BYTES, &begin),
        (BlockId::fb(CALLER), LOCAL_BYTES, &main),
        (BlockId::fb(1), LOCAL_BYTES, &outer),
        (BlockId::fb(2), LOCAL_BYTES, &inner),
    ])
}

#[test]
fn an_instance_that_an_index_tells_is_looked_at_where_it_may_lie_outside() {
    let back = |bits: u64| 0x1_0000_0000 - bits;
    let last = u64::from(INSTANCES);
    for (first, behind) in [
        (0, 0),
        (0, 64),
        (0, 33),
        (0, back(8)),
        (0, back(16)),
        (0, back(24)),
        (last, 0),
        (last, 8 * (STEP - 5)),
        (last, 8 * (STEP - 4)),
        (last, 8 * STEP),
    ] {
        let program = indexed(first, behind);
        let layout = layout_of(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let engines = engines(&program, &layout);
        for index in [0, 1, 2, 3, 200] {
            let outcome = |engine: Arc<dyn Engine>| {
                let prepare = |machine: &mut Machine| {
                    machine.budget = 1000;
                    let range = machine.memory.layout.data_blocks[&1].clone();
                    machine.memory.arena[range].fill(index);
                };
                run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
            };
            all_engines_agree(&engines, false, &outcome, &|| format!("{first} {behind}, index {index}"));
        }
    }
}

/// What an instance does with the bytes where its data block begins.
#[derive(Clone, Copy, Debug)]
enum Does {
    Writes,
    CopiesThere,
    CopiesFromThere,
    /// Copies from and to where its own pointer leads, as one to any area.
    CopiesAnywhere,
}

/// Three instances behind the counter of a loop, which count in the bytes of an array behind them. They do something with bytes where their
/// data block begins, which are known or told by an index.
fn reaches_absolutely(does: Does, indexed: bool) -> Program {
    let counter = own(0);
    let element = |b: &mut Builder, step: u64| {
        let (number, step) = (b.load(counter, Width::Word, OnFault::SkipStatement), b.constant(step));
        let by = b.compute(Op::MulU32, &[number, step]);
        b.compute(Op::AddU32, &[Register::Ar2.into(), by])
    };
    let main = |b: &mut Builder| {
        b.begin_statement();
        let zero = b.constant(0);
        b.store(counter, Width::Word, zero);
        b.begin_statement();
        let pointer = element(b, 8 * STEP);
        b.store(SAVED, Width::DoubleWord, Register::Ar2);
        let first = b.constant(u64::from(STRUCTURES));
        b.compute_into(Register::Ar2, Op::AddU32, &[pointer, first]);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(1)), parameters: 0 });
        let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
        b.copy(Register::Ar2, saved);
        b.begin_statement();
        let pointer = element(b, 8);
        let value = b.load(counter, Width::Byte, OnFault::SkipStatement);
        b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: INSTANCES }, Width::Byte, value);
        b.begin_statement();
        next_iteration(b, counter, (Op::LeI16, ELEMENTS - 1), Target(1));
    };
    let writes = |b: &mut Builder| {
        b.begin_statement();
        let mut pointer = b.constant(0x8400_0000);
        if indexed {
            let (number, mask) = (b.load(own(8), Width::Byte, OnFault::SkipStatement), b.constant(1));
            let (number, step) = (b.compute(Op::AndU32, &[number, mask]), b.constant(8));
            let by = b.compute(Op::MulU32, &[number, step]);
            pointer = b.compute(Op::AddU32, &[pointer, by]);
        }
        let there = |offset: u32| Place::Indirect { area: Area::InstanceData, pointer, offset };
        let bytes = 2;
        // Known before what follows, and a bit of the first instance that waits for others.
        let value = b.load(own(8 * 6), Width::Word, OnFault::SkipStatement);
        b.store(own(8 * 10), Width::Word, value);
        let bit = b.load(own(8 * 5 + 1), Width::Bit, OnFault::SkipStatement);
        b.store(own(3), Width::Bit, bit);
        match does {
            Does::Writes => {
                let value = b.load(own(8 * 4), Width::Word, OnFault::SkipStatement);
                b.store(there(0), Width::Word, value);
            }
            Does::CopiesThere => b.push(Inst::Move { from: own(8 * 4), to: there(0), bytes }),
            Does::CopiesFromThere => b.push(Inst::Move { from: there(STRUCTURES), to: own(8 * 4), bytes }),
            Does::CopiesAnywhere => {
                let number = b.constant(1);
                b.push(Inst::Open { register: DataRegister::Shared, number });
                let anywhere = |byte: u32| Place::Crossing { pointer: Register::Ar2.into(), offset: 8 * byte };
                b.push(Inst::Move { from: anywhere(4), to: anywhere(6), bytes });
            }
        }
        b.begin_statement();
        let value = b.load(own(8 * 6), Width::Word, OnFault::SkipStatement);
        b.store(own(8 * 8), Width::Word, value);
    };
    program(&[(BlockId::ob(1), LOCAL_BYTES, &begin), (BlockId::fb(CALLER), LOCAL_BYTES, &main), (BlockId::fb(1), LOCAL_BYTES, &writes)])
}

#[test]
fn what_an_instance_does_where_its_data_block_begins_may_be_with_the_counter_of_its_caller() {
    let all = [Does::Writes, Does::CopiesThere, Does::CopiesFromThere, Does::CopiesAnywhere];
    for (does, indexed) in all.into_iter().flat_map(|does| [(does, false), (does, true)]) {
        let program = reaches_absolutely(does, indexed);
        let layout = layout_of(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let engines = engines(&program, &layout);
        for number in [0_u8, 2, 3, 40] {
            let outcome = |engine: Arc<dyn Engine>| {
                let prepare = |machine: &mut Machine| {
                    machine.budget = 100;
                    let range = machine.memory.layout.data_blocks[&1].clone();
                    (0..3).for_each(|at| machine.memory.arena[range.start + 8 + STEP as usize * at + 5] = number);
                };
                let answer = |_: &mut Machine, _: &str, asked: usize| match asked < QUESTIONS_MAX {
                    true => Reaction::Continue,
                    false => Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> }),
                };
                run(engine.as_ref(), &layout, &entry, &prepare, &answer)
            };
            all_engines_agree(&engines, false, &outcome, &|| format!("{does:?}, indexed {indexed}, {number}"));
        }
    }
}
