//! Functions that write texts into a structure that their caller gave them, behind its beginning and at indexes that are checked: the
//! caller keeps what it knows of memory that they do not reach, and nothing else.

use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, TextAction, TextRoom, Var};
use sieben_engine::{Layout, Machine, Program};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_from, layout, program};

const PROGRAMS: u64 = 700;
const MEMORIES: u64 = 4;
/// The data block of the structure, and its bytes.
const NUMBER: u16 = 300;
const BYTES: u32 = 200;
/// Bit memory: an index, a text to copy, and numbers that tell what was read.
const INDEX: u32 = 0;
const TEXT: u32 = 8;
const RESULTS: u32 = 40;
const TABLE: u32 = 100;

fn memory(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn local(byte: u32) -> Place {
    Place::Fixed { area: Area::Local, position: 8 * byte }
}

fn in_block(byte: u32) -> Place {
    Place::Fixed { area: Area::SharedData, position: 8 * byte }
}

fn data(program: &Program) -> Layout {
    let mut layout = layout(program);
    let end = layout.size;
    layout.data_blocks.insert(NUMBER, end..end + BYTES as usize);
    layout.size = end + BYTES as usize + 64;
    layout
}

/// An index that is checked, in bits: below a limit, or not checked as it should be.
fn index(b: &mut Builder, dice: &mut Dice) -> Var {
    let index = b.load(memory(INDEX + dice.roll(4) as u32), Width::Byte, OnFault::SkipStatement);
    let limit = b.constant(1 + dice.roll(6));
    let other = b.load(memory(INDEX), Width::Byte, OnFault::SkipStatement);
    let below = b.compute(Op::Below, &[if dice.roll(8) == 0 { other } else { index }, limit]);
    let passed = b.compute(Op::Gate, &[index, below]);
    let size = b.constant(8 * dice.of(&[1, 6, 8, 12]));
    b.compute(Op::MulU32, &[passed, size])
}

/// A function that writes texts behind the pointer that its caller wrote to memory.
fn writes(b: &mut Builder, dice: &mut Dice) {
    for _ in 0..1 + dice.roll(3) {
        b.begin_statement();
        let parameter = b.temporary();
        b.push(Inst::Parameter { dst: parameter, index: 0 });
        let number = b.load(Place::Crossing { pointer: parameter, offset: 0 }, Width::Word, OnFault::SkipStatement);
        let mut pointer = b.load(Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord, OnFault::SkipStatement);
        for _ in 0..dice.roll(3) {
            let more = if dice.roll(2) == 0 { index(b, dice) } else { b.constant(8 * dice.of(&[0, 2, 10, 30, 0x1F_FFFC])) };
            pointer = b.compute(Op::AddU32, &if dice.roll(2) == 0 { [pointer, more] } else { [more, pointer] });
        }
        let half = b.constant(32);
        let number = b.compute(Op::Shl64, &[number, half]);
        let pointer = b.compute(Op::OrU64, &[number, pointer]);
        let (first, count) = (b.constant(dice.roll(3)), b.constant(dice.roll(8)));
        let room = TextRoom::narrow(dice.of(&[0, 2, 4, 10, 20]));
        let to = Place::Crossing { pointer, offset: 8 * dice.of(&[0, 0, 4, 12]) };
        let action = dice.of(&[TextAction::Assign, TextAction::Piece, TextAction::Append, TextAction::Unsigned]);
        let dst = b.temporary();
        b.push(Inst::Text { action, dst, to, to_room: room, from: memory(TEXT), from_room: TextRoom::narrow(12), piece: [first, count] });
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// Its caller: numbers that it writes before the call are indexes behind it.
fn caller(b: &mut Builder, dice: &mut Dice) {
    let place = |dice: &mut Dice| match dice.roll(4) {
        0 => local(20 + 2 * dice.roll(4) as u32),
        1 => memory(80 + 2 * dice.roll(4) as u32),
        _ => in_block(2 * dice.roll(60) as u32),
    };
    let places: Vec<Place> = (0..3).map(|_| place(dice)).collect();
    for (round, _) in (0..1 + dice.roll(2)).enumerate() {
        b.begin_statement();
        let number = b.constant(NUMBER.into());
        b.push(Inst::Open { register: sieben_engine::ir::DataRegister::Shared, number });
        for &place in &places {
            let value = b.constant(dice.roll(12));
            b.store(place, Width::Word, value);
        }
        b.begin_statement();
        let number = b.constant(if dice.roll(12) == 0 { 1 } else { NUMBER.into() });
        b.store(local(0), Width::Word, number);
        let pointer = match dice.roll(10) {
            0 => b.load(memory(INDEX + 4), Width::DoubleWord, OnFault::SkipStatement),
            1 => b.constant(0x8700_0000 + 8 * dice.of(&[14, 60])),
            2 => b.constant(0x8300_0000 + 8 * dice.of(&[70, 2000])),
            _ => b.constant(0x8400_0000 + 8 * dice.of(&[0, 10, 60, 150, 190])),
        };
        b.store(local(2), Width::DoubleWord, pointer);
        let parameter = b.constant(0x8700_0000);
        b.push(Inst::PassParameter { src: parameter });
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 1 });
        for (at, &place) in places.iter().enumerate() {
            b.begin_statement();
            let index = b.load(place, Width::Word, OnFault::SkipStatement);
            let few = b.constant(if dice.roll(2) == 0 { 15 } else { 0xFFFF });
            let index = b.compute(Op::AndU32, &[index, few]);
            let limit = b.constant(16);
            let inside = b.compute(Op::Below, &[index, limit]);
            let index = b.compute(Op::Gate, &[index, inside]);
            let bits = b.constant(16);
            let pointer = b.compute(Op::MulU32, &[index, bits]);
            let element = Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * TABLE };
            let value = b.load(element, Width::Word, OnFault::SkipStatement);
            b.store(memory(RESULTS + 2 * (3 * round + at) as u32), Width::Word, value);
        }
    }
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn what_a_function_writes_into_a_structure_is_the_same_on_all_engines() {
    let mut silent = 0;
    for seed in seeds(PROGRAMS) {
        let (outer, inner) = (|b: &mut Builder| caller(b, &mut Dice(2 * seed)), |b: &mut Builder| writes(b, &mut Dice(2 * seed + 1)));
        let program = program(&[(BlockId::ob(1), 100, &outer), (BlockId::fc(1), 16, &inner)]);
        let layout = data(&program);
        let prepare = |machine: &mut Machine, run_of: u64| {
            let mut dice = Dice(seed * MEMORIES + run_of);
            machine.budget = 100;
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory.iter_mut().take(200).for_each(|byte| *byte = dice.roll(12) as u8);
            memory[INDEX as usize + 4..][..4].copy_from_slice(&0x8400_0050_u32.to_be_bytes());
            let start = machine.memory.layout.data_blocks[&NUMBER].start;
            machine.memory.arena[start..][..BYTES as usize].iter_mut().for_each(|byte| *byte = dice.roll(20) as u8);
        };
        silent += all_engines_agree_from((&program, &layout), MEMORIES, &prepare, &format!("program {seed}"));
    }
    assert!(silent > 900, "{silent} runs without a question");
}
