//! Functions that reach elements of arrays in the local data of their callers through a pointer that they get: machine code that knows how
//! far the index goes does what the interpreter does, also where the index goes too far, or into the variables of the caller beside the
//! array.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::CALLS_SHIFT;
use sieben_engine::{Entry, Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 350;
/// Local data of the blocks, in bytes: the caller's array begins behind some of its variables.
const LOCAL: u32 = 120;
/// The counter and the sum, in bit memory.
const COUNTER: u32 = 40;
const SUM: u32 = 48;
/// Where a block keeps a counter of its own.
const OWN_COUNTER: u32 = 96;

fn memory(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn local(byte: u32) -> Place {
    Place::Fixed { area: Area::Local, position: 8 * byte }
}

fn call(b: &mut Builder, number: u16, pointer: Var) {
    b.push(Inst::PassParameter { src: pointer });
    b.push(Inst::Call { callee: Callee::Block(BlockId::new(BlockKind::Function, number)), parameters: 1 });
}

/// Fills some local data and calls the function with a pointer into them.
fn caller(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    b.begin_statement();
    for byte in (0..LOCAL).step_by(4) {
        let value = b.constant(dice.roll(1 << 32));
        b.store(local(byte), Width::DoubleWord, value);
    }
    for _ in 0..1 + dice.roll(2) {
        b.begin_statement();
        let first = b.constant(0x8700_0000 + 8 * dice.of(&[0, 4, 10, 60]) + if dice.roll(12) == 0 { 3 } else { 0 });
        call(b, 1, first);
        b.begin_statement();
        let value = b.load(local(4 * dice.roll(20) as u32), Width::DoubleWord, OnFault::SkipStatement);
        b.store(memory(SUM + 4), Width::DoubleWord, value);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// Hands the pointer on, or one into its own local data.
fn between(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    b.begin_statement();
    let pointer = if dice.roll(2) == 0 {
        let given = b.temporary();
        b.push(Inst::Parameter { dst: given, index: 0 });
        let further = b.constant(1 << CALLS_SHIFT);
        b.compute(Op::AddU32, &[given, further])
    } else {
        b.constant(0x8700_0000 + 8 * dice.roll(8))
    };
    call(b, 2, pointer);
    b.begin_statement();
    b.push(Inst::Return);
}

/// Reads and writes elements in a loop.
fn elements(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let width = dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::DoubleWord, Width::DoubleWord]);
    let (counter, counter_width) = if dice.roll(2) == 0 { (memory(COUNTER), Width::DoubleWord) } else { (local(OWN_COUNTER), Width::Word) };
    let begins = dice.of(&[0, 0, 1, 0xFFFC]);
    let offset = if dice.roll(4) == 0 { 8 * dice.roll(12) as u32 } else { 0 };
    b.begin_statement();
    let first = b.constant(begins);
    b.store(counter, counter_width, first);
    let statements = 1 + dice.roll(2);
    for _ in 0..statements {
        b.begin_statement();
        let mut index = b.load(counter, counter_width, OnFault::SkipStatement);
        if counter_width == Width::Word {
            index = b.compute(Op::Extend16, &[index]);
        }
        if begins == 0xFFFC {
            let below = b.constant(if counter_width == Width::Word { 0xFFFF_FFFC } else { 0xFFFC });
            index = b.compute(Op::SubU32, &[index, below]);
        }
        if dice.roll(3) == 0 {
            let limit = b.constant(dice.of(&[7, 20, 30]));
            let below = b.compute(Op::Below, &[index, limit]);
            b.push(Inst::Require { condition: below, code: 162, register: index });
            index = b.compute(Op::Gate, &[index, below]);
        }
        let step = b.constant(u64::from(width.bits()) * dice.of(&[1, 1, 1, 2]));
        let way = b.compute(Op::MulU32, &[index, step]);
        let given = b.temporary();
        b.push(Inst::Parameter { dst: given, index: 0 });
        let pointer = b.compute(Op::AddU32, &[given, way]);
        let place = Place::Crossing { pointer, offset };
        match dice.roll(3) {
            0 => {
                let value = b.load(place, width, OnFault::SkipStatement);
                let sum = b.load(memory(SUM), Width::DoubleWord, OnFault::SkipStatement);
                let sum = b.compute(Op::AddU32, &[sum, value]);
                b.store(memory(SUM), Width::DoubleWord, sum);
            }
            1 => {
                let value = b.load(place, width, OnFault::SkipStatement);
                let one = b.constant(1);
                let value = b.compute(if width == Width::Bit { Op::Xor } else { Op::AddU32 }, &[value, one]);
                b.store(place, width, value);
            }
            _ => b.store(place, width, index),
        }
    }
    b.begin_statement();
    let before = b.load(counter, counter_width, OnFault::SkipStatement);
    let one = b.constant(1);
    let short = counter_width == Width::Word;
    let next = b.compute(if short { Op::AddU16 } else { Op::AddU32 }, &[before, one]);
    b.store(counter, counter_width, next);
    let most = b.constant(match begins {
        0xFFFC if !short => 0xFFFC + dice.roll(12),
        _ => dice.of(&[3, 6, 9, 20, 31]),
    });
    let condition = b.compute(if short { Op::LeI16 } else { Op::LeI32 }, &[next, most]);
    b.push(Inst::Branch { condition, to: Target(1) });
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn elements_of_callers_are_what_the_interpreter_finds() {
    let mut finished = 0;
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let further = seed.is_multiple_of(3);
        let first = move |b: &mut Builder| if further { between(b, seed + 1_000_000) } else { elements(b, seed + 2_000_000) };
        let program = program(&[
            (block, LOCAL, &|b| caller(b, seed)),
            (BlockId::fc(1), LOCAL, &first),
            (BlockId::fc(2), LOCAL, &|b| elements(b, seed + 3_000_000)),
        ]);
        let layout = layout(&program);
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            machine.budget = Dice(seed + 4_000_000).of(&[5, 60, 100_000, 100_000]);
            machine.memory.area_mut(Area::BitMemory)[..64].fill(0);
        };
        let outcome = |engine: Arc<dyn sieben_engine::Engine>| {
            let dice = RefCell::new(Dice(seed + 5_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| {
                let mut dice = dice.borrow_mut();
                if asked >= 60 {
                    return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
                }
                machine.budget = dice.of(&[0, 3, 17, 1_000, 100_000]);
                Reaction::Continue
            };
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("{seed}"));
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(finished > 150, "{finished} runs to the end");
}
