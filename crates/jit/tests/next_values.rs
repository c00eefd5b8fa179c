//! How a loop looks at its next value: a sum that has to stay inside its type is compared with a limit, and an element of a data block that
//! is opened behind a look at its index decides where the program goes on. All is the same on all engines, at both ends of each type.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Machine, Reaction};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout, program, run};

const PROGRAMS: u64 = 250;
const STATEMENTS: u32 = 8;
/// Where the results stand, one byte each.
const RESULTS: u32 = 40;

/// What belongs to a type: the operations, and numbers near its ends.
struct Type {
    width: Width,
    add: Op,
    overflows: Op,
    compares: [Op; 6],
    near: [u64; 8],
}

const TYPES: [Type; 2] = [
    Type {
        width: Width::Word,
        add: Op::AddU16,
        overflows: Op::AddOverflowsI16,
        compares: [Op::LeI16, Op::GeI16, Op::LeI16, Op::GeI16, Op::LtI16, Op::EqI16],
        near: [0, 1, 2, 0x7FFE, 0x7FFF, 0x8000, 0x8001, 0xFFFF],
    },
    Type {
        width: Width::DoubleWord,
        add: Op::AddU32,
        overflows: Op::AddOverflowsI32,
        compares: [Op::LeI32, Op::GeI32, Op::LeI32, Op::GeI32, Op::GtI32, Op::NeI32],
        near: [0, 1, 2, 0x7FFF_FFFE, 0x7FFF_FFFF, 0x8000_0000, 0x8000_0001, 0xFFFF_FFFF],
    },
];

fn at(area: Area, byte: u32) -> Place {
    Place::Fixed { area, position: 8 * byte }
}

/// A number in memory, mostly the first one.
fn number(b: &mut Builder, dice: &mut Dice, ty: &Type) -> Var {
    let byte = dice.of(&[0, 0, 0, 4]);
    b.load(at(Area::BitMemory, byte), ty.width, OnFault::SkipStatement)
}

/// Whether the sum of a number and a step has not turned over, and is not beyond a limit.
fn goes_on(b: &mut Builder, dice: &mut Dice) -> Var {
    let ty = &TYPES[dice.roll(2) as usize];
    let step = b.constant(dice.of(&ty.near));
    let other_step = if dice.roll(6) == 0 { b.constant(dice.of(&ty.near)) } else { step };
    let value = number(b, dice, ty);
    let other = if dice.roll(6) == 0 { number(b, dice, ty) } else { value };
    let overflow = b.compute(ty.overflows, &[value, step]);
    let sum = b.compute(ty.add, &[other, other_step]);
    let limit = if dice.roll(2) == 0 { b.constant(dice.of(&ty.near)) } else { number(b, dice, ty) };
    let (first, second) = if dice.roll(5) == 0 { (limit, sum) } else { (sum, limit) };
    let compared = b.compute(dice.of(&ty.compares), &[first, second]);
    let both = b.compute(Op::AndNot, &[compared, overflow]);
    match dice.roll(4) {
        0 => b.compute(Op::Not, &[both]),
        1 => {
            let one = b.constant(dice.of(&[1, 4]));
            let gated = b.compute(Op::Gate, &[one, compared]);
            let gated = b.compute(Op::Gate, &[gated, overflow]);
            b.compute(Op::IsNonzero, &[gated])
        }
        _ => both,
    }
}

/// A bit of data block 1 behind a look at its index, with the data block opened in between.
fn element(b: &mut Builder, dice: &mut Dice) -> Var {
    let index = b.load(at(Area::BitMemory, dice.of(&[8, 10])), Width::Word, OnFault::SkipStatement);
    let count = b.constant(16);
    let inside = b.compute(Op::Below, &[index, count]);
    b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: index });
    let index = b.compute(Op::Gate, &[index, inside]);
    let block = if dice.roll(2) == 0 { b.constant(1) } else { b.load(at(Area::BitMemory, 12), Width::Word, OnFault::SkipStatement) };
    b.push(Inst::Open { register: DataRegister::Shared, number: block });
    let first = b.constant(0x8400_0000);
    let pointer = b.compute(Op::AddU32, &[first, index]);
    let bit = b.load(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, Width::Bit, OnFault::SkipStatement);
    b.compute(Op::Gate, &[bit, inside])
}

/// Statements that note a condition, or jump over the next one, in a loop.
fn statements(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let turns = b.constant(3);
    b.store(at(Area::Local, 0), Width::Word, turns);
    let head = b.next();
    for index in 0..STATEMENTS {
        b.begin_statement();
        let condition = if dice.roll(3) == 0 { element(b, dice) } else { goes_on(b, dice) };
        if dice.roll(2) == 0 {
            b.store(at(Area::BitMemory, RESULTS + index), Width::Bit, condition);
            continue;
        }
        let condition = if dice.roll(2) == 0 { b.compute(Op::Not, &[condition]) } else { condition };
        let behind = b.next().0 + 1;
        b.push(Inst::Branch { condition, to: Target(behind) });
        if dice.roll(2) == 0 {
            b.push(Inst::Jump { to: Target(behind - 1) });
        }
        b.begin_statement();
        let place = Place::Indirect { area: Area::SharedData, pointer: b.constant(0x8400_0000), offset: 8 * dice.roll(4) as u32 };
        let old = b.load(place, Width::Byte, OnFault::SkipStatement);
        let one = b.constant(1);
        let new = b.compute(Op::AddU32, &[old, one]);
        b.store(at(Area::BitMemory, RESULTS + index), Width::Byte, new);
    }
    b.begin_statement();
    let left = b.load(at(Area::Local, 0), Width::Word, OnFault::SkipStatement);
    let one = b.constant(1);
    let left = b.compute(Op::SubU16, &[left, one]);
    b.store(at(Area::Local, 0), Width::Word, left);
    let again = b.compute(Op::IsNonzero, &[left]);
    b.push(Inst::Branch { condition: again, to: head });
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn looks_at_next_values_are_the_same_on_all_engines() {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    for seed in seeds(PROGRAMS) {
        let body = |b: &mut Builder| statements(b, &mut Dice(seed));
        let program = program(&[(BlockId::ob(1), 40, &body)]);
        let layout = layout(&program);
        let engines = engines(&program, &layout);
        for memory in 0..6 {
            let outcome = |engine: Arc<dyn Engine>| {
                let prepare = |machine: &mut Machine| {
                    let mut dice = Dice(7 * seed + memory);
                    machine.budget = [100, 5, 1][memory as usize % 3];
                    let layout = machine.memory.layout.clone();
                    let near = TYPES[dice.roll(2) as usize].near;
                    let mut write = |at: usize, number: u64, bytes: usize| {
                        let bits = &(number as u32).to_be_bytes()[4 - bytes..];
                        let start = layout.bit_memory.start + at;
                        machine.memory.arena[start..start + bytes].copy_from_slice(bits);
                    };
                    let bytes = if near[3] > 0xFFFF { 4 } else { 2 };
                    for at in [0, 4] {
                        write(at, dice.of(&near), bytes);
                    }
                    for at in [8, 10] {
                        write(at, dice.of(&[0, 3, 15, 16, 0x8000]), 2);
                    }
                    write(12, dice.of(&[1, 1, 1, 9]), 2);
                    let data = layout.data_blocks[&1].clone();
                    machine.memory.arena[data].fill_with(|| dice.roll(256) as u8);
                };
                run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
            };
            let what = || format!("program {seed}, memory {memory}\n{}", program.code[&BlockId::ob(1)].code);
            all_engines_agree(&engines, true, &outcome, &what);
        }
    }
}
