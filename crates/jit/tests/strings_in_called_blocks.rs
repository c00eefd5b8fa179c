//! Loops that call functions which work on texts, those of their caller among them, and texts at computed places of an open data block:
//! variables of the loop stay in registers, and every engine leaves the same memory.

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, TextAction, TextRoom, Var};
use sieben_engine::{Layout, Machine, Program};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_from, layout, program};

const PROGRAMS: u64 = 400;
const MEMORIES: u64 = 4;
/// Bit memory and local data where texts and variables lie among each other.
const TEXTS: u32 = 40;
const BYTES: u64 = 60;
/// Bytes in bit memory that all differ.
const TABLE: u32 = 600;
/// Local data of the caller: the iterations of the loop, pointers that it hands on, and texts behind.
const COUNTER: u32 = 0;
const GIVEN: u32 = 4;
const RESULT: u32 = 12;
const OWN: u32 = 20;
/// A data block of some bytes.
const NUMBER: u16 = 300;
const BLOCK: usize = 90;

fn memory(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn local(byte: u32) -> Place {
    Place::Fixed { area: Area::Local, position: 8 * byte }
}

fn room(dice: &mut Dice) -> TextRoom {
    TextRoom::narrow(dice.of(&[0, 1, 2, 4, 8, 10, 16, 20, 254]))
}

/// An instruction on two texts, of which the first one may be written, and its result in a word.
fn work(b: &mut Builder, dice: &mut Dice, texts: [(Place, TextRoom); 2], result: Place) {
    let action = dice.of(&[
        TextAction::Length,
        TextAction::Assign,
        TextAction::Piece,
        TextAction::Piece,
        TextAction::Append,
        TextAction::Compare,
        TextAction::Find,
        TextAction::Unsigned,
    ]);
    let [(to, to_room), (from, from_room)] = texts;
    let first = b.load(memory(dice.roll(4) as u32), Width::Byte, OnFault::SkipStatement);
    let count = b.constant(dice.of(&[0, 1, 1, 2, 3, 8, 0x7FFF_FFFF]));
    let dst = b.temporary();
    b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece: [first, count] });
    b.store(result, Width::Word, dst);
}

/// A function that works on the text that its caller gave it, and on its own.
fn function(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let one = b.constant(0x0101);
    b.store(local(0), Width::Word, one);
    let character = b.constant(u64::from(b'0') + dice.roll(3));
    b.store(local(2), Width::Byte, character);
    for _ in 0..1 + dice.roll(3) {
        b.begin_statement();
        let given = given_text(b);
        let own = |dice: &mut Dice| match dice.roll(3) {
            0 => (local(0), TextRoom::narrow(1)),
            _ => (local(4 + dice.roll(20) as u32), TextRoom::narrow(dice.of(&[1, 4, 12]))),
        };
        let mut texts = [own(dice), (given, TextRoom::narrow(dice.of(&[0, 0, 0, 6])))];
        if dice.roll(3) == 0 {
            texts.swap(0, 1);
        }
        let parameter = b.temporary();
        b.push(Inst::Parameter { dst: parameter, index: 1 });
        work(b, dice, texts, Place::Crossing { pointer: parameter, offset: 0 });
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// The text behind the number and the pointer that the caller wrote to its local data.
fn given_text(b: &mut Builder) -> Place {
    let parameter = b.temporary();
    b.push(Inst::Parameter { dst: parameter, index: 0 });
    let number = b.load(Place::Crossing { pointer: parameter, offset: 0 }, Width::Word, OnFault::SkipStatement);
    let pointer = b.load(Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord, OnFault::SkipStatement);
    let half = b.constant(32);
    let number = b.compute(Op::Shl64, &[number, half]);
    Place::Crossing { pointer: b.compute(Op::OrU64, &[number, pointer]), offset: 0 }
}

/// A pointer in an open data block, mostly to the beginning of a byte.
fn computed(b: &mut Builder, dice: &mut Dice) -> Var {
    let index = b.load(memory(4 + dice.roll(4) as u32), Width::Byte, OnFault::SkipStatement);
    let most = b.constant(dice.of(&[15, 127, 255]));
    let index = b.compute(Op::AndU32, &[index, most]);
    let bits = b.constant(if dice.roll(12) == 0 { 1 } else { 8 });
    b.compute(Op::MulU32, &[index, bits])
}

/// Where a number lies that texts may be written over.
fn variable(dice: &mut Dice) -> Place {
    match dice.roll(3) {
        0 => memory(TEXTS + dice.roll(BYTES) as u32),
        1 => local(OWN + dice.roll(BYTES) as u32),
        _ => Place::Fixed { area: Area::SharedData, position: 8 * dice.roll(BLOCK as u64 - 1) as u32 },
    }
}

/// Reads a number as an index of a table, whose element tells which it was.
fn look_up(b: &mut Builder, place: Place, to: u32) {
    b.begin_statement();
    let index = b.load(place, Width::Word, OnFault::SkipStatement);
    let limit = b.constant(16);
    let inside = b.compute(Op::Below, &[index, limit]);
    let index = b.compute(Op::Gate, &[index, inside]);
    let bits = b.constant(8);
    let pointer = b.compute(Op::MulU32, &[index, bits]);
    let element = b.load(Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * TABLE }, Width::Byte, OnFault::SkipStatement);
    b.store(memory(to), Width::Byte, element);
}

/// A loop of a few iterations with variables among the texts.
fn caller(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let none = b.constant(0);
    b.store(local(COUNTER), Width::Word, none);
    let begin = b.next();
    b.begin_statement();
    if dice.roll(10) > 0 {
        let number = b.constant(if dice.roll(12) == 0 { 7 } else { NUMBER.into() });
        b.push(Inst::Open { register: DataRegister::Shared, number });
    }
    let numbers: Vec<Place> = (0..dice.roll(4)).map(|_| variable(dice)).collect();
    // What is written more than once waits for its store.
    for &place in numbers.iter().chain(numbers.first()) {
        b.begin_statement();
        let number = b.constant(dice.roll(14));
        b.store(place, Width::Word, number);
    }
    for _ in 0..dice.roll(4) {
        b.begin_statement();
        let place = variable(dice);
        let width = dice.of(&[Width::Byte, Width::Word]);
        let value = b.load(place, width, OnFault::SkipStatement);
        let more = b.constant(1 + dice.roll(2));
        let value = b.compute(Op::AddU16, &[value, more]);
        b.store(place, width, value);
    }
    if dice.roll(2) == 0 {
        b.begin_statement();
        let pointer = computed(b, dice);
        let there = match dice.roll(3) {
            0 => (Place::Indirect { area: Area::Local, pointer, offset: 8 * (OWN + dice.of(&[0, 1, 8])) }, room(dice)),
            _ => (Place::Indirect { area: Area::SharedData, pointer, offset: 8 * dice.of(&[0, 4, 60]) }, room(dice)),
        };
        let here = (memory(TEXTS + dice.roll(BYTES) as u32), TextRoom::narrow(dice.of(&[4, 12])));
        let texts = if dice.roll(2) == 0 { [there, here] } else { [here, there] };
        work(b, dice, texts, memory(8));
        for (&place, to) in numbers.iter().zip(24..) {
            look_up(b, place, to);
        }
    }
    b.begin_statement();
    let (number, pointer) = match dice.roll(4) {
        0 => (NUMBER, b.constant(0x8400_0000 + 8 * dice.of(&[0, 10, 80]))),
        1 => {
            let byte = if dice.roll(3) == 0 { dice.of(&[0, 1, 8]) } else { dice.roll(BYTES) };
            (0, b.constant(0x8700_0000 + 8 * (u64::from(OWN) + byte)))
        }
        2 => (NUMBER, b.load(memory(12), Width::DoubleWord, OnFault::SkipStatement)),
        _ => (0, b.constant(0x8300_0000 + 8 * u64::from(TEXTS) + 8 * dice.roll(BYTES))),
    };
    let number = b.constant(number.into());
    b.store(local(GIVEN), Width::Word, number);
    b.store(local(GIVEN + 2), Width::DoubleWord, pointer);
    for byte in [GIVEN, RESULT] {
        let parameter = b.constant(0x8700_0000 + 8 * u64::from(byte));
        b.push(Inst::PassParameter { src: parameter });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 2 });
    for (&place, to) in numbers.iter().zip(28..) {
        look_up(b, place, to);
    }
    b.begin_statement();
    let result = b.load(local(RESULT), Width::Word, OnFault::SkipStatement);
    b.store(memory(20), Width::Word, result);
    let iteration = b.load(local(COUNTER), Width::Word, OnFault::SkipStatement);
    let one = b.constant(1);
    let iteration = b.compute(Op::AddU16, &[iteration, one]);
    b.store(local(COUNTER), Width::Word, iteration);
    let last = b.constant(4);
    let condition = b.compute(Op::LtI16, &[iteration, last]);
    b.push(Inst::Branch { condition, to: begin });
    b.begin_statement();
    b.push(Inst::Return);
}

fn data(program: &Program, read_only: bool) -> Layout {
    let mut layout = layout(program);
    let end = layout.size;
    layout.data_blocks.insert(NUMBER, end..end + BLOCK);
    layout.size = end + BLOCK + 400;
    if read_only {
        layout.read_only.push(NUMBER);
    }
    layout
}

#[test]
fn loops_that_call_functions_of_texts_are_the_same_on_all_engines() {
    let mut silent = 0;
    for seed in seeds(PROGRAMS) {
        let (outer, inner) = (|b: &mut Builder| caller(b, &mut Dice(2 * seed)), |b: &mut Builder| function(b, &mut Dice(2 * seed + 1)));
        let program = program(&[(BlockId::ob(1), 120, &outer), (BlockId::fc(1), 60, &inner)]);
        let layout = data(&program, seed % 16 == 0);
        let prepare = |machine: &mut Machine, run_of: u64| {
            let mut dice = Dice(seed * MEMORIES + run_of);
            machine.budget = 200;
            let most = dice.of(&[3, 9, 20]);
            let byte = |dice: &mut Dice| if dice.roll(3) == 0 { b'0' + dice.roll(3) as u8 } else { dice.roll(most) as u8 };
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory[..4].fill_with(|| dice.roll(4) as u8);
            memory[4..8].fill_with(|| dice.roll(100) as u8);
            memory[12..16].copy_from_slice(&(0x8400_0000 + 8 * dice.roll(100) as u32).to_be_bytes());
            memory[TEXTS as usize..][..2 * BYTES as usize].fill_with(|| byte(&mut dice));
            memory[TABLE as usize..][..16].iter_mut().zip(100..).for_each(|(at, number)| *at = number);
            let start = machine.memory.layout.data_blocks[&NUMBER].start;
            machine.memory.arena[start..][..BLOCK].fill_with(|| byte(&mut dice));
        };
        silent += all_engines_agree_from((&program, &layout), MEMORIES, &prepare, &format!("program {seed}"));
    }
    assert!(silent > 500, "{silent} runs without a question");
}
