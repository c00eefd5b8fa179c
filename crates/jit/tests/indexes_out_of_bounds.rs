//! Statements that use the same indexes again and again, each behind a look: where one is outside, the interpreter does the statement and
//! the rest of its iteration, and machine code goes on behind it. Whatever the indexes are, whatever the program does otherwise there and
//! whoever changes memory, the code does what the interpreter does.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, fixed, get, layout_with, program, run_beside};

const PROGRAMS: u64 = 700;
const QUESTIONS_MAX: usize = 60;
/// Elements at the beginning of bit memory, and their bytes.
const ELEMENTS: u64 = 8;
const ELEMENT: u64 = 8;
/// Where the indexes and other numbers lie; the first index counts, the last one is local data.
const INDEXES: [u32; 3] = [100, 102, 104];
const NUMBERS: [u32; 3] = [110, 112, 114];
const LOCAL: Place = Place::Fixed { area: Area::Local, position: 160 };

fn number_of_index(b: &mut Builder, dice: &mut Dice) -> Var {
    let index = match dice.roll(5) {
        0 => b.load(LOCAL, Width::Word, OnFault::SkipStatement),
        _ => get(b, dice.of(&[INDEXES[0], INDEXES[1], INDEXES[1], INDEXES[2]]), Width::Word),
    };
    let number = b.compute(Op::Extend16, &[index]);
    if dice.roll(3) == 0 {
        let one = b.constant(1);
        return b.compute(Op::SubU32, &[number, one]);
    }
    number
}

/// Looks at an index: a pointer to its element, and whether it is inside.
fn looked_at(b: &mut Builder, number: Var, elements: u64) -> (Var, Var) {
    let count = b.constant(elements);
    let inside = b.compute(Op::Below, &[number, count]);
    b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
    let number = b.compute(Op::Gate, &[number, inside]);
    let bits = b.constant(8 * ELEMENT);
    (b.compute(Op::MulU32, &[number, bits]), inside)
}

/// A place in an element behind a look at its index, and whether that is inside.
fn element(b: &mut Builder, dice: &mut Dice, data: bool) -> (Place, Var) {
    if data && dice.roll(2) == 0 {
        let number = b.constant(1);
        b.push(Inst::Open { register: DataRegister::Shared, number });
    }
    let number = number_of_index(b, dice);
    let (pointer, inside) = looked_at(b, number, dice.of(&[ELEMENTS, ELEMENTS, 5]));
    let area = if data { Area::SharedData } else { Area::BitMemory };
    (Place::Indirect { area, pointer, offset: 8 * dice.of(&[0, 0, 2, 4]) }, inside)
}

fn value(b: &mut Builder, dice: &mut Dice, data: bool) -> Var {
    match dice.roll(4) {
        0 => get(b, dice.of(&NUMBERS), Width::Word),
        1 => b.constant(dice.roll(9)),
        _ => {
            let (place, inside) = element(b, dice, data);
            let value = b.load(place, Width::Word, OnFault::SkipStatement);
            b.compute(Op::Gate, &[value, inside])
        }
    }
}

fn some_statement(b: &mut Builder, dice: &mut Dice, (statement, behind): (u32, u32), data: bool) {
    match dice.roll(9) {
        0 => {
            let (index, by) = (dice.of(&INDEXES[1..]), b.constant(dice.of(&[1, 3, 0xFFFF])));
            let before = get(b, index, Width::Word);
            let number = b.compute(Op::AddU16, &[before, by]);
            b.store(fixed(index), Width::Word, number);
        }
        // An index that is made of an element, or kept in local data.
        1 => {
            let number = value(b, dice, data);
            let mask = b.constant(dice.of(&[7, 15]));
            let number = b.compute(Op::AndU32, &[number, mask]);
            let to = if dice.roll(2) == 0 { LOCAL } else { fixed(INDEXES[2]) };
            b.store(to, Width::Word, number);
        }
        2 => {
            let (one, other) = (value(b, dice, data), value(b, dice, data));
            let condition = b.compute(dice.of(&[Op::LtI16, Op::Equal]), &[one, other]);
            let to = statement + 1 + dice.roll(u64::from(1 + behind - statement)) as u32;
            b.push(Inst::Branch { condition, to: Target(to) });
        }
        3 => {
            let number = value(b, dice, data);
            b.store(fixed(dice.of(&NUMBERS)), Width::Word, number);
        }
        4 => b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 0 }),
        // Something is written before a look: the statement cannot begin again.
        5 => {
            let byte = dice.of(&NUMBERS);
            let (before, one) = (get(b, byte, Width::Word), b.constant(1));
            let number = b.compute(Op::AddU16, &[before, one]);
            b.store(fixed(byte), Width::Word, number);
            let (place, inside) = element(b, dice, data);
            let (new, old) = (get(b, byte, Width::Word), b.load(place, Width::Word, OnFault::SkipWrite));
            let chosen = b.compute(Op::Select, &[inside, new, old]);
            b.store(place, Width::Word, chosen);
        }
        _ => {
            let (new, (place, inside)) = (value(b, dice, data), element(b, dice, data));
            let one = b.constant(1);
            let new = b.compute(Op::AddU16, &[new, one]);
            let old = b.load(place, Width::Word, OnFault::SkipWrite);
            let chosen = b.compute(Op::Select, &[inside, new, old]);
            b.store(place, Width::Word, chosen);
        }
    }
}

/// `FOR index := … TO last DO … END_FOR`, twice now and then one in the other, and statements behind it.
fn build(b: &mut Builder, dice: &mut Dice) {
    let (inner, outer) = (1 + dice.roll(7) as u32, dice.roll(3) == 0);
    let data = dice.roll(3) == 0;
    let (first, last) = (dice.of(&[0, 0, 1, 0xFFFF]), dice.of(&[3, 7, 8, 12]));
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    b.begin_statement();
    let start = b.constant(first);
    b.store(fixed(INDEXES[0]), Width::Word, start);
    for statement in 0..inner {
        b.begin_statement();
        some_statement(b, dice, (2 + statement, 2 + inner), data);
    }
    b.begin_statement();
    noting::next_iteration(b, fixed(INDEXES[0]), (Op::LeI16, last), Target(2));
    if outer {
        b.begin_statement();
        noting::next_iteration(b, fixed(NUMBERS[0]), (Op::LeI16, 3), Target(1));
    }
    let behind = 3 + inner + u32::from(outer);
    for statement in 0..dice.roll(4) as u32 {
        b.begin_statement();
        some_statement(b, dice, (behind + statement, behind + statement), data);
    }
    b.begin_statement();
    b.push(Inst::Return);
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
        1 => machine.memory.area_mut(Area::BitMemory)[dice.roll(120) as usize] = dice.roll(256) as u8,
        _ => {}
    }
    Reaction::Continue
}

#[test]
fn where_an_index_is_outside_the_rest_is_what_the_interpreter_makes_of_it() {
    let (mut asked, mut silent, mut finished) = (0, 0, 0);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    for seed in seeds(PROGRAMS) {
        let increment = |b: &mut Builder| {
            b.begin_statement();
            let (number, one) = (get(b, NUMBERS[2], Width::Word), b.constant(1));
            let next = b.compute(Op::AddU16, &[number, one]);
            b.store(fixed(NUMBERS[2]), Width::Word, next);
            b.begin_statement();
            b.push(Inst::Return);
        };
        let program = program(&[(BlockId::ob(1), 48, &|b| build(b, &mut Dice(seed))), (BlockId::fc(1), 8, &increment)]);
        let layout = layout_with(&program, 80);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 5, 20, 1000, 1000]);
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory[..120].iter_mut().for_each(|byte| *byte = dice.of(&[0, 0, 1, 2, 5, 7, 8, 200]));
        };
        let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
        let expected =
            all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", program.code[&entry.block].code));
        asked += expected.asked.len();
        silent += usize::from(expected.asked.is_empty());
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 5_000 && silent > 20 && finished > 300, "{asked} questions, {silent} silent runs, {finished} runs to the end");
}

#[test]
fn an_index_is_looked_at_once_in_a_iteration() {
    let build = |b: &mut Builder| {
        noting::counted(b, 120, 50, |b| {
            for _ in 0..4 {
                b.begin_statement();
                let index = get(b, INDEXES[1], Width::Word);
                let number = b.compute(Op::Extend16, &[index]);
                let (pointer, inside) = looked_at(b, number, ELEMENTS);
                let place = Place::Indirect { area: Area::BitMemory, pointer, offset: 0 };
                let (old, one) = (b.load(place, Width::Word, OnFault::SkipStatement), b.constant(3));
                let new = b.compute(Op::MulU16, &[old, one]);
                let kept = b.load(place, Width::Word, OnFault::SkipWrite);
                let chosen = b.compute(Op::Select, &[inside, new, kept]);
                b.store(place, Width::Word, chosen);
            }
            5
        });
    };
    let program = program(&[(BlockId::ob(1), 16, &build)]);
    let listing = Jit::listing(&program, &layout_with(&program, 16)).expect("machine code");
    let looks = listing.lines().filter(|line| line.contains("icmp_imm_u ult") || line.contains("icmp ult")).count();
    // Once in the loop, and once before iterations that nobody looks at.
    assert!(looks <= 3, "{looks}\n{listing}");
}
