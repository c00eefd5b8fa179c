//! Loops of word logic and shifts on bytes and words nobody wrote: what machine code knows of the bits of a value, from iteration to
//! iteration and from one operation to the next, never leaves a bit that the interpreter cuts off.

use std::sync::Arc;

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Machine, Reaction};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout, program, run};

const PROGRAMS: u64 = 500;
/// Variables of every width, which share no bytes, in local data or bit memory.
const VARIABLES: [(Area, u32, Width); 7] = [
    (Area::Local, 0, Width::Word),
    (Area::Local, 2, Width::Word),
    (Area::Local, 4, Width::Byte),
    (Area::Local, 8, Width::DoubleWord),
    (Area::BitMemory, 20, Width::Word),
    (Area::BitMemory, 22, Width::Byte),
    (Area::BitMemory, 24, Width::DoubleWord),
];
const COUNTER: Place = Place::Fixed { area: Area::Local, position: 8 * 16 };

fn place(area: Area, byte: u32) -> Place {
    Place::Fixed { area, position: 8 * byte }
}

/// A value of a few operations.
fn value(b: &mut Builder, dice: &mut Dice, depth: u32) -> Var {
    if depth == 0 || dice.roll(4) == 0 {
        return match dice.roll(4) {
            0 => b.constant(dice.of(&[0, 1, 0x80, 0xFF, 0x100, 0xA001, 0xFFFF, 0x0001_0000, 0xFFFF_FFFF])),
            _ => {
                let (area, byte, width) = dice.of(&VARIABLES);
                b.load(place(area, byte), width, OnFault::SkipStatement)
            }
        };
    }
    let first = value(b, dice, depth - 1);
    match dice.roll(10) {
        0..5 => {
            let second = value(b, dice, depth - 1);
            b.compute(
                dice.of(&[Op::AndU64, Op::OrU64, Op::XorU64, Op::AndU32, Op::OrU32, Op::XorU32, Op::AddU16, Op::SubU16]),
                &[first, second],
            )
        }
        5..8 => {
            let count = b.constant(1 + dice.roll(15));
            b.compute(dice.of(&[Op::Shr16, Op::Shl16, Op::Shr32, Op::Shl32, Op::Sar16]), &[first, count])
        }
        8 => {
            let (second, third) = (value(b, dice, depth - 1), value(b, dice, depth - 1));
            let condition = b.compute(Op::IsNonzero, &[third]);
            b.compute(Op::Select, &[condition, first, second])
        }
        _ => b.compute(dice.of(&[Op::Low16, Op::Low8, Op::Extend16, Op::NotU16]), &[first]),
    }
}

/// `FOR` loops, some of them with a jump over an assignment.
fn looping(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let one = b.constant(1);
    b.store(COUNTER, Width::Word, one);
    let head = b.next();
    for _ in 0..1 + dice.roll(3) {
        b.begin_statement();
        if dice.roll(3) == 0 {
            let condition = value(b, dice, 1);
            let condition = b.compute(Op::IsNonzero, &[condition]);
            b.push(Inst::Branch { condition, to: Target(b.next().0 + 1) });
            b.begin_statement();
        }
        let value = value(b, dice, 3);
        let (area, byte, width) = dice.of(&VARIABLES);
        b.store(place(area, byte), width, value);
    }
    b.begin_statement();
    let counter = b.load(COUNTER, Width::Word, OnFault::SkipStatement);
    let one = b.constant(1);
    let next = b.compute(Op::AddU16, &[counter, one]);
    b.store(COUNTER, Width::Word, next);
    let last = b.constant(1 + dice.roll(12));
    let again = b.compute(Op::LeI16, &[next, last]);
    b.push(Inst::Branch { condition: again, to: head });
    // What a wider look sees of the narrow ones.
    for (index, (area, byte, width)) in (0..).zip(VARIABLES) {
        b.begin_statement();
        let value = b.load(place(area, byte), width, OnFault::SkipStatement);
        b.store(place(Area::BitMemory, 40 + 8 * index), Width::QuadWord, value);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn word_logic_in_loops_is_the_same_on_all_engines() {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    for seed in seeds(PROGRAMS) {
        let body = |b: &mut Builder| looping(b, &mut Dice(seed));
        let program = program(&[(BlockId::ob(1), 40, &body)]);
        let layout = layout(&program);
        let engines = engines(&program, &layout);
        for memory in 0..3 {
            let outcome = |engine: Arc<dyn Engine>| {
                let prepare = |machine: &mut Machine| {
                    let mut dice = Dice(3 * seed + memory);
                    machine.budget = [100, 5, 1][memory as usize];
                    let starts = [machine.memory.layout.local.start, machine.memory.layout.bit_memory.start + 20];
                    for start in starts {
                        machine.memory.arena[start..start + 12].fill_with(|| dice.roll(256) as u8);
                    }
                };
                run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
            };
            let what = || format!("program {seed}, memory {memory}\n{}", program.code[&BlockId::ob(1)].code);
            all_engines_agree(&engines, false, &outcome, &what);
        }
    }
}
