//! Copies between elements whose indexes are looked at and noted if they are outside: nothing is copied then, and the next statement follows.
//! Whatever the indexes are and whoever changes memory, the code does what the interpreter does.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Inst, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, fixed, get, layout_with, program, run_beside};

const PROGRAMS: u64 = 600;
const QUESTIONS_MAX: usize = 40;
/// Elements at the beginning of bit memory, and their bytes.
const ELEMENTS: u64 = 10;
const ELEMENT: u64 = 12;
/// Where indexes lie; the first one counts.
const INDEXES: [u32; 3] = [200, 202, 204];

/// A pointer to an element behind a look at its index, and whether that is inside.
fn element(b: &mut Builder, index: u32, crosses: bool) -> (Var, Var) {
    let number = get(b, index, Width::Word);
    let number = b.compute(Op::Extend16, &[number]);
    let count = b.constant(ELEMENTS);
    let inside = b.compute(Op::Below, &[number, count]);
    b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
    let number = b.compute(Op::Gate, &[number, inside]);
    let bits = b.constant(8 * ELEMENT);
    let mut pointer = b.compute(Op::MulU32, &[number, bits]);
    if crosses {
        let area = b.constant(0x8300_0000);
        pointer = b.compute(Op::AddU32, &[pointer, area]);
    }
    (pointer, inside)
}

fn leave_unless(b: &mut Builder, inside: Var, to: u32) {
    let outside = b.compute(Op::Not, &[inside]);
    b.push(Inst::Branch { condition: outside, to: Target(to) });
}

/// `element[i] := element[j]`, a part of them, or a variable instead of one of them; `next` is the statement behind it.
fn copy(b: &mut Builder, dice: &mut Dice, next: u32) {
    let mut late = Vec::new();
    let mut ends = Vec::new();
    let at_once = dice.roll(4) != 0;
    for _ in 0..2 {
        if dice.roll(5) == 0 {
            ends.push(fixed(dice.of(&[130, 150])));
            continue;
        }
        let crosses = dice.roll(3) == 0;
        let (pointer, inside) = element(b, dice.of(&INDEXES), crosses);
        if at_once {
            leave_unless(b, inside, next)
        } else {
            late.push(inside)
        }
        let offset = 8 * dice.of(&[0, 0, 4]);
        ends.push(if crosses { Place::Crossing { pointer, offset } } else { Place::Indirect { area: Area::BitMemory, pointer, offset } });
    }
    late.into_iter().for_each(|inside| leave_unless(b, inside, next));
    b.push(Inst::Move { from: ends[0], to: ends[1], bytes: dice.of(&[3, 6, 8]) });
}

/// `REPEAT … UNTIL index > last`, with a jump table in it, so that the turns are not done at once.
fn looping(b: &mut Builder, last: u64, statements: u32, write: &mut dyn FnMut(&mut Builder, u32)) {
    b.begin_statement();
    let first = b.constant(0xFFFF);
    b.store(fixed(INDEXES[0]), Width::Word, first);
    for statement in 1..=statements {
        b.begin_statement();
        write(b, statement);
    }
    b.begin_statement();
    let counter = get(b, INDEXES[0], Width::Word);
    let behind = 2 + statements;
    let first = b.table(&[Target(behind), Target(behind)]);
    b.push(Inst::JumpTable { index: counter, first, count: 2, otherwise: Target(behind) });
    b.begin_statement();
    let (counter, one) = (get(b, INDEXES[0], Width::Word), b.constant(1));
    let next = b.compute(Op::AddU16, &[counter, one]);
    b.store(fixed(INDEXES[0]), Width::Word, next);
    let last = b.constant(last);
    let again = b.compute(Op::LeI16, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(1) });
    b.begin_statement();
    b.push(Inst::Return);
}

fn some_statement(b: &mut Builder, dice: &mut Dice, statement: u32) {
    match dice.roll(5) {
        0 => {
            let (index, by) = (dice.of(&INDEXES[1..]), b.constant(dice.of(&[1, 3, 0xFFFF])));
            let before = get(b, index, Width::Word);
            let number = b.compute(Op::AddU16, &[before, by]);
            b.store(fixed(index), Width::Word, number);
        }
        1 => {
            let byte = dice.of(&[130, 134, 150]);
            let (value, one) = (get(b, byte, Width::DoubleWord), b.constant(1));
            let value = b.compute(Op::AddU32, &[value, one]);
            b.store(fixed(byte), Width::DoubleWord, value);
        }
        _ => copy(b, dice, statement + 1),
    }
}

/// Changes a byte and the budget, unless a fault is noted: who is told of that changes nothing.
fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 2, 3, 8, 50]);
    match dice.roll(4) {
        0 => machine.memory.area_mut(Area::BitMemory)[dice.of(&INDEXES) as usize + 1] = dice.roll(14) as u8,
        1 => machine.memory.area_mut(Area::BitMemory)[dice.roll(180) as usize] = dice.roll(256) as u8,
        _ => {}
    }
    Reaction::Continue
}

#[test]
fn copies_with_indexes_that_are_looked_at_do_what_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    for seed in seeds(PROGRAMS) {
        let build = |b: &mut Builder| {
            let mut dice = Dice(seed);
            let (last, statements) = (dice.of(&[0, 5, 12]), 1 + dice.roll(6) as u32);
            looping(b, last, statements, &mut |b, statement| some_statement(b, &mut dice, statement));
        };
        let program = program(&[(BlockId::ob(1), 16, &build)]);
        let layout = layout_with(&program, 16);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 2, 5, 20, 1000]);
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory[..180].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            INDEXES.iter().for_each(|&at| memory[at as usize + 1] = dice.roll(14) as u8);
        };
        let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
        let what = || format!("{seed}\n{}", program.code[&BlockId::ob(1)].code);
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &what);
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 500 && finished > 200, "{asked} questions, {finished} runs to the end");
}

#[test]
fn a_copy_behind_two_looks_chooses_no_index() {
    let build = |b: &mut Builder| {
        looping(b, 12, 1, &mut |b, statement| {
            let ends = [INDEXES[1], INDEXES[2]].map(|index| {
                let (pointer, inside) = element(b, index, false);
                leave_unless(b, inside, statement + 1);
                Place::Indirect { area: Area::BitMemory, pointer, offset: 0 }
            });
            b.push(Inst::Move { from: ends[0], to: ends[1], bytes: 12 });
        });
    };
    let program = program(&[(BlockId::ob(1), 16, &build)]);
    let listing = Jit::listing(&program, &layout_with(&program, 16)).expect("machine code");
    let copies = listing.split("\nblock").find(|block| block.contains("load.i64") && block.contains("store") && !block.contains("cold"));
    assert!(copies.is_some_and(|block| !block.contains("select")), "{copies:?}");
}
