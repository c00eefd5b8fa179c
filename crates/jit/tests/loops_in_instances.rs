//! Blocks that loop over function blocks in their own instance, and that are called for the elements of an array themselves: what is known
//! of such a block, wherever its instance lies, is what the interpreter finds, whatever a Host does. Some blocks are too long to become
//! part of their callers: those are functions that know that their instance is there.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, begin_with_instance, engines, layout_with, next_iteration, program, run_beside};

/// Programs that are compared.
const PROGRAMS: u64 = 250;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 60;
/// The blocks: one that loops over `MIDDLE`, which loops over `INNER`.
const OUTER: u16 = 1;
const MIDDLE: u16 = 2;
const INNER: u16 = 3;
/// IR instructions of a block that becomes part of none.
const LONG: usize = 1_300;
/// Elements of both arrays, where they begin, and their bytes. Behind the inner ones the instance of the middle block goes on.
const ELEMENTS: u64 = 3;
const MIDDLES: u32 = 8 * 8;
const MIDDLE_BYTES: u64 = 40;
const INNERS: u32 = 8 * 8;
const INNER_BYTES: u64 = 8;
const DATA_BYTES: usize = (MIDDLES / 8) as usize + (ELEMENTS * MIDDLE_BYTES) as usize;
/// Local data: where AR2 is kept.
const SAVED: Place = Place::Fixed { area: Area::Local, position: 8 * 16 };
const LOCAL_BYTES: u32 = 24;

fn own(offset: u32) -> Place {
    Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset }
}

/// An array of instances in that of a block, and the counter of the loop over it.
#[derive(Clone, Copy)]
struct Array {
    counter: Place,
    first: u32,
    bytes: u64,
    callee: u16,
}

/// How far an element lies behind the first one.
fn distance(b: &mut Builder, dice: &mut Dice, array: Array) -> Var {
    let mut number = b.load(array.counter, Width::Word, OnFault::SkipStatement);
    let count = b.constant(if dice.roll(10) == 0 { ELEMENTS + 1 } else { ELEMENTS });
    let inside = b.compute(Op::Below, &[number, count]);
    let noted = if dice.roll(6) == 0 { 0 } else { NOTED };
    b.push(Inst::Require { condition: inside, code: noted | 0x22, register: number });
    if noted != 0 {
        number = b.compute(Op::Gate, &[number, inside]);
    }
    let step = b.constant(8 * array.bytes);
    b.compute(Op::MulU32, &[number, step])
}

/// A place in the instance: a variable, or a field of an element.
fn place(b: &mut Builder, dice: &mut Dice, array: Option<Array>, width: Width) -> Place {
    let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
    match (dice.roll(12), array) {
        (0, _) => Place::Fixed { area: Area::BitMemory, position: 8 * dice.roll(8) as u32 + bit },
        (1, _) => Place::Fixed { area: Area::Local, position: 8 * dice.roll(12) as u32 + bit },
        // From where the data block begins, not the instance.
        (2, _) if dice.roll(4) == 0 => {
            let pointer = b.constant(0x8400_0000 + 8 * dice.roll(3));
            Place::Indirect { area: Area::InstanceData, pointer, offset: 8 * dice.roll(16) as u32 + bit }
        }
        (2..8, Some(array)) => {
            let by = distance(b, dice, array);
            let pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
            let field = dice.roll(array.bytes - u64::from(width.bytes() - 1)) as u32;
            Place::Indirect { area: Area::InstanceData, pointer, offset: array.first + 8 * field + bit }
        }
        (8, Some(array)) => own(array.first + 8 * (dice.roll(ELEMENTS * array.bytes - 4) as u32) + bit),
        _ => own(8 * (2 + dice.roll(if array.is_some() { 4 } else { 3 })) as u32 + bit),
    }
}

/// Reads something, and writes it or something made of it.
fn assigns(b: &mut Builder, dice: &mut Dice, array: Option<Array>) {
    let width = dice.of(&[Width::Bit, Width::Bit, Width::Byte, Width::Word, Width::DoubleWord]);
    let from = place(b, dice, array, width);
    let value = b.load(from, width, OnFault::SkipStatement);
    let other = b.constant(dice.of(&[0, 1, 0x0102_0304]));
    let value = b.compute(if width == Width::Bit { Op::Xor } else { Op::AddU32 }, &[value, other]);
    let to = place(b, dice, array, width);
    b.store(to, width, value);
}

/// Writes to an element, calls it and takes AR2 back: mostly.
fn calls(b: &mut Builder, dice: &mut Dice, array: Array) {
    b.begin_statement();
    for _ in 0..dice.roll(3) {
        assigns(b, dice, Some(array));
    }
    b.store(SAVED, Width::DoubleWord, Register::Ar2);
    let by = match dice.roll(4) {
        0 => b.constant(8 * array.bytes * dice.roll(ELEMENTS)),
        _ => distance(b, dice, array),
    };
    b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
    // Or where the own instance begins, or just before it.
    let first = b.constant(if dice.roll(16) == 0 { dice.of(&[0, 0xFFFF_FFF0, 0xFFFF_FFE8]) } else { u64::from(array.first) });
    b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), first]);
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(array.callee)), parameters: 0 });
    let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
    match dice.roll(16) {
        0 => {}
        2 => b.set(Register::Ar2, 0x8400_0000 + u64::from(MIDDLES) + 8 * MIDDLE_BYTES * dice.roll(ELEMENTS)),
        1 => {
            // What was kept of AR2 is a number like others.
            let other = b.constant(0x8400_0000 + u64::from(MIDDLES) + 8 * MIDDLE_BYTES * dice.roll(ELEMENTS));
            let is_it = b.compute(Op::Equal, &[saved, other]);
            b.copy(Register::Ar2, saved);
            b.store(own(8 * 4), Width::Bit, is_it);
            b.store(Place::Fixed { area: Area::BitMemory, position: 8 * 12 }, Width::DoubleWord, saved);
        }
        _ => b.copy(Register::Ar2, saved),
    }
}

/// A block with a loop over instances in its own.
fn loops(b: &mut Builder, dice: &mut Dice, array: Array, is_long: bool) {
    let Array { counter, .. } = array;
    let mut statements = 1;
    if is_long {
        lengthen(b, 0);
        statements += 2;
    }
    b.begin_statement();
    let first = b.constant(0);
    b.store(counter, Width::Word, first);
    let head = Target(statements);
    for _ in 0..1 + dice.roll(4) {
        match dice.roll(6) {
            0 | 1 => {
                b.begin_statement();
                assigns(b, dice, Some(array));
            }
            2 => {
                b.begin_statement();
                let condition = b.load(own(8 * 4 + dice.roll(4) as u32), Width::Bit, OnFault::SkipStatement);
                b.push(Inst::Branch { condition, to: Target(statements + 2) });
                b.begin_statement();
                assigns(b, dice, Some(array));
                statements += 1;
            }
            _ => calls(b, dice, array),
        }
        statements += 1;
    }
    b.begin_statement();
    next_iteration(b, counter, (Op::LeI16, ELEMENTS - 1), head);
    for _ in 0..dice.roll(3) {
        if dice.roll(2) == 0 {
            calls(b, dice, Array { counter: own(8 * 2), ..array });
        } else {
            b.begin_statement();
            assigns(b, dice, Some(array));
        }
    }
}

fn inner(b: &mut Builder, dice: &mut Dice, is_long: bool) {
    let first = if is_long { 2 } else { 0 };
    if is_long {
        lengthen(b, 0);
    }
    for statement in first..first + 1 + dice.roll(4) as u32 {
        b.begin_statement();
        if dice.roll(5) == 0 {
            let condition = b.load(own(dice.roll(16) as u32), Width::Bit, OnFault::SkipStatement);
            b.push(Inst::Branch { condition, to: Target(statement + 1) });
        } else {
            assigns(b, dice, None);
        }
    }
    b.begin_statement();
    let value = b.load(own(0), Width::Byte, OnFault::SkipStatement);
    b.store(own(8), Width::Byte, value);
    if dice.roll(10) == 0 {
        // It does not leave AR2 as it is.
        let more = b.constant(8 * dice.of(&[1, INNER_BYTES]));
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), more]);
    }
}

/// Makes a block too long to become part of another one, by instructions that are jumped over.
fn lengthen(b: &mut Builder, statements: u32) {
    b.begin_statement();
    b.push(Inst::Jump { to: Target(statements + 2) });
    b.begin_statement();
    let dst = b.constant(0);
    (0..LONG).for_each(|_| b.push(Inst::Constant { dst, value: 0 }));
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
        let range = machine.memory.layout.data_blocks[&1].clone();
        machine.memory.arena[range.start + dice.roll(range.len() as u64) as usize] = dice.of(&[0, 1, 2, 3, 7, 0x80, 0x84, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn blocks_that_loop_over_instances_in_their_own_are_the_same_on_all_engines() {
    let (mut asked, mut silent) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let rolls = |block: u16| Dice(seed * 100 + u64::from(block));
        let outer_array = Array { counter: own(0), first: MIDDLES, bytes: MIDDLE_BYTES, callee: MIDDLE };
        let counter = match seed % 6 {
            0 => Place::Fixed { area: Area::BitMemory, position: 8 * 10 },
            // Where an element lies that is called.
            1 | 2 => own(INNERS + 8 * Dice(seed + 3_000_000).roll(ELEMENTS * INNER_BYTES - 1) as u32),
            _ => own(0),
        };
        let middle_array = Array { counter, first: INNERS, bytes: INNER_BYTES, callee: INNER };
        let is_long = |block: u16| Dice(seed * 100 + 50 + u64::from(block)).roll(3) == 0;
        let program = program(&[
            (BlockId::ob(1), LOCAL_BYTES, &|b: &mut Builder| begin_with_instance(b, OUTER)),
            (BlockId::fb(OUTER), LOCAL_BYTES, &|b: &mut Builder| loops(b, &mut rolls(OUTER), outer_array, is_long(OUTER))),
            (BlockId::fb(MIDDLE), LOCAL_BYTES, &|b: &mut Builder| loops(b, &mut rolls(MIDDLE), middle_array, is_long(MIDDLE))),
            (BlockId::fb(INNER), LOCAL_BYTES, &|b: &mut Builder| inner(b, &mut rolls(INNER), is_long(INNER))),
        ]);
        // The last instance may be there in part.
        let missing = Dice(seed + 4_000_000).of(&[0, 0, 0, 4, 12, 20]);
        let mut layout = layout_with(&program, DATA_BYTES - missing);
        if seed % 16 == 0 {
            layout.read_only.push(1);
        }
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[5, 4000, 4000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let outcome = |engine: Arc<dyn Engine>| {
            let mut outcome = run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
            // What was in local data of blocks that have ended.
            outcome.arena[layout.local.clone()].fill(0);
            outcome
        };
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        let questions = all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", listing())).asked.len();
        asked += questions;
        silent += usize::from(questions == 0);
    }
    assert!(asked > 200 && silent > 25, "{asked} questions, {silent} programs without any");
}
