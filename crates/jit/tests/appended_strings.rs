//! Loops that put characters behind texts, whose lengths registers hold from iteration to iteration: memory has what the interpreter leaves
//! there, whatever else writes the texts, and whoever changes them where somebody is asked.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, TextAction, TextRoom, Var};
use sieben_engine::machine::Machine;
use sieben_engine::{Layout, Reaction};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, engines, layout, program};

const PROGRAMS: u64 = 700;
/// Texts in bit memory and in local data, so many bytes apart: some of those with much room lie over the next one.
const TEXTS: u64 = 3;
const APART: u32 = 12;
const FIRST: u32 = 40;
/// Where numbers lie that indexes and pieces are made of.
const NUMBERS: u64 = 8;

fn memory(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn local(byte: u32) -> Place {
    Place::Fixed { area: Area::Local, position: 8 * byte }
}

/// A text; its place is known, sometimes behind a pointer.
fn text(b: &mut Builder, dice: &mut Dice) -> (Place, TextRoom) {
    let byte = FIRST + APART * dice.roll(TEXTS) as u32;
    let place = match dice.roll(4) {
        0 => local(byte),
        1 => {
            let pointer = b.constant(u64::from(8 * byte));
            Place::Indirect { area: Area::BitMemory, pointer, offset: 0 }
        }
        _ => memory(byte),
    };
    (place, TextRoom::narrow(dice.of(&[10, 10, 10, 10, 4, 16])))
}

fn number(b: &mut Builder, dice: &mut Dice) -> Var {
    match dice.roll(2) {
        0 => b.constant(dice.of(&[0, 1, 1, 2, 30, 0xFFFF_FFFF])),
        _ => b.load(memory(dice.roll(NUMBERS) as u32), Width::Byte, OnFault::SkipStatement),
    }
}

/// One statement of a loop.
fn statement(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    match dice.roll(10) {
        0 => {
            let byte = FIRST + dice.roll(u64::from(APART) * TEXTS) as u32;
            let value = number(b, dice);
            b.store(if dice.roll(3) == 0 { local(byte) } else { memory(byte) }, Width::Byte, value);
        }
        1 => {
            let index = number(b, dice);
            let bits = b.constant(dice.of(&[8, 8, 8 << 12]));
            let pointer = b.compute(Op::MulU32, &[index, bits]);
            let value = number(b, dice);
            b.store(Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * FIRST }, Width::Byte, value);
        }
        kind => {
            let action = match kind {
                2 => TextAction::Assign,
                3 => TextAction::Piece,
                4 => TextAction::Length,
                5 => TextAction::Find,
                _ => TextAction::Append,
            };
            let ((to, to_room), (from, from_room)) = (text(b, dice), text(b, dice));
            let piece = [number(b, dice), number(b, dice)];
            let dst = b.temporary();
            b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece });
            b.store(memory(20 + dice.roll(4) as u32), Width::Byte, dst);
        }
    }
}

/// Counts iterations and begins again, or goes on behind the loop.
fn iteration(b: &mut Builder, (counter, iterations): (u32, u64), begin: Target) {
    b.begin_statement();
    let iteration = b.load(local(counter), Width::Word, OnFault::SkipStatement);
    let one = b.constant(1);
    let iteration = b.compute(Op::AddU16, &[iteration, one]);
    b.store(local(counter), Width::Word, iteration);
    let last = b.constant(iterations);
    let condition = b.compute(Op::LtI16, &[iteration, last]);
    b.push(Inst::Branch { condition, to: begin });
}

fn begin(b: &mut Builder, counter: u32) -> Target {
    b.begin_statement();
    let none = b.constant(0);
    b.store(local(counter), Width::Word, none);
    b.next()
}

/// Loops, some of them in another one, some with a way to the next iteration in the middle.
fn block(b: &mut Builder, dice: &mut Dice) {
    for _ in 0..1 + dice.roll(2) {
        let outer = (dice.roll(3) == 0).then(|| begin(b, 0));
        let inner = begin(b, 2);
        for _ in 0..1 + dice.roll(4) {
            statement(b, dice);
        }
        if dice.roll(3) == 0 {
            iteration(b, (2, 1 + dice.roll(9)), inner);
            statement(b, dice);
        }
        iteration(b, (2, 2 + dice.roll(9)), inner);
        if let Some(outer) = outer {
            statement(b, dice);
            iteration(b, (0, 3), outer);
        }
    }
    b.begin_statement();
    b.push(Inst::Return);
}

fn fill(machine: &mut Machine, dice: &mut Dice) {
    let bytes = machine.memory.area_mut(Area::BitMemory);
    for byte in &mut bytes[..NUMBERS as usize] {
        *byte = dice.of(&[0, 1, 2, 3, 9, 40, 255]);
    }
    for byte in &mut bytes[FIRST as usize..][..(APART as usize + 4) * TEXTS as usize] {
        *byte = if dice.roll(2) == 0 { dice.roll(12) as u8 } else { dice.roll(256) as u8 };
    }
}

#[test]
fn texts_that_grow_in_loops_are_the_same_on_all_engines() {
    let mut asked = 0;
    for seed in seeds(PROGRAMS) {
        let program = program(&[(BlockId::ob(1), 100, &|b: &mut Builder| block(b, &mut Dice(seed)))]);
        let layout: Layout = layout(&program);
        let budget = Dice(seed ^ 0x5EED).of(&[2, 9, 30, 1000]);
        let prepare = |machine: &mut Machine| {
            machine.budget = budget;
            fill(machine, &mut Dice(seed + 1));
        };
        let meddle = |machine: &mut Machine, dice: &mut Dice, _: usize| {
            machine.budget = budget;
            if dice.roll(2) == 0 {
                fill(machine, dice);
            }
            Reaction::Continue
        };
        let ended =
            all_engines_agree_beside(&engines(&program, &layout), &prepare, &|| Dice(seed + 2), &meddle, &format!("program {seed}"));
        asked += ended.asked.len();
    }
    assert!(asked > 1_100, "{asked} questions");
}
