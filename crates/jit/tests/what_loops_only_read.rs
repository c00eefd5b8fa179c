//! Loops that only read some variables and call functions that write by the pointers they are given: to local data, to these variables, or to
//! others. Behind the loop, and at each question, they are in memory what the interpreter left there.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, fixed, get, layout_with, next_turn, program, run};

const PROGRAMS: u64 = 400;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 30;
/// The function, one that it calls, and a function block.
const OUTER: u16 = 1;
const INNER: u16 = 2;
const BLOCK: u16 = 3;
/// Variables in the data block, and in bit memory, from this byte on.
const VARIABLES: u64 = 4;
const MEMORY: u32 = 16;
/// The counter of the loop, and a sum.
const COUNTER: u32 = 0;
const SUM: u32 = 4;
/// Bytes of local data.
const LOCAL_BYTES: u32 = 32;

fn load(b: &mut Builder, place: Place) -> Var {
    b.load(place, Width::DoubleWord, OnFault::SkipStatement)
}

/// A variable that the loop reads.
fn variable(dice: &mut Dice) -> Place {
    let number = dice.roll(VARIABLES) as u32;
    match dice.roll(3) {
        0 => fixed(MEMORY + 4 * number),
        1 => Place::Fixed { area: Area::InstanceData, position: 32 * number },
        _ => Place::Fixed { area: Area::SharedData, position: 32 * number },
    }
}

/// A pointer that a function is given: into local data, mostly.
fn pointer(b: &mut Builder, dice: &mut Dice) -> Var {
    let bits = 32 * dice.roll(VARIABLES);
    let pointer = match dice.roll(12) {
        0 => 0x8300_0000 + u64::from(8 * MEMORY) + bits,
        1 => 0x8400_0000 + bits,
        2 => 0x8500_0000 + bits,
        _ => 0x8700_0000 + bits,
    };
    b.constant(pointer)
}

/// Makes something of what it reads, and writes it.
fn assigns(b: &mut Builder, from: Place, to: Place) {
    let (value, other) = (load(b, from), b.constant(0x0101));
    let value = b.compute(Op::AddU32, &[value, other]);
    b.store(to, Width::DoubleWord, value);
}

/// A function with two pointers.
fn function(b: &mut Builder, dice: &mut Dice, calls: bool) {
    for _ in 0..1 + dice.roll(2) {
        b.begin_statement();
        let place = |b: &mut Builder, dice: &mut Dice| {
            let dst = b.temporary();
            match dice.roll(3) {
                0 => Place::Fixed { area: Area::Local, position: 32 * dice.roll(4) as u32 },
                index => {
                    // There are two.
                    b.push(Inst::Parameter { dst, index: if dice.roll(24) == 0 { 2 } else { index as u16 - 1 } });
                    Place::Crossing { pointer: dst, offset: 0 }
                }
            }
        };
        let (from, to) = (place(b, dice), place(b, dice));
        assigns(b, from, to);
    }
    if calls {
        b.begin_statement();
        give_and_call(b, dice, INNER);
    }
    b.begin_statement();
    let value = b.constant(3);
    b.store(Place::Fixed { area: Area::Local, position: 64 }, Width::DoubleWord, value);
}

fn give_and_call(b: &mut Builder, dice: &mut Dice, function: u16) {
    for _ in 0..2 {
        let src = pointer(b, dice);
        b.push(Inst::PassParameter { src });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fc(function)), parameters: 2 });
}

/// A function block that writes to its instance, or only to local data.
fn block(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let offset = 32 * dice.roll(4) as u32;
    let own = Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset };
    let local = Place::Fixed { area: Area::Local, position: 0 };
    let (from, to) = if dice.roll(3) == 0 { (own, local) } else { (local, own) };
    let value = load(b, from);
    let zero = b.constant(0);
    let value = b.compute(Op::AndU32, &[value, zero]);
    b.store(to, Width::DoubleWord, value);
}

/// The loop.
fn looping(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    for register in [DataRegister::Instance, DataRegister::Shared] {
        let number = b.constant(1);
        b.push(Inst::Open { register, number });
    }
    b.set(Register::Ar2, 0x8400_0000);
    let zero = b.constant(0);
    b.store(fixed(COUNTER), Width::Word, zero);
    for _ in 0..1 + dice.roll(3) {
        b.begin_statement();
        let (sum, place) = (get(b, SUM, Width::DoubleWord), variable(dice));
        let value = load(b, place);
        let sum = b.compute(Op::AddU32, &[sum, value]);
        b.store(fixed(SUM), Width::DoubleWord, sum);
    }
    if dice.roll(4) == 0 {
        b.begin_statement();
        let (from, to) = (variable(dice), variable(dice));
        assigns(b, from, to);
    }
    b.begin_statement();
    if dice.roll(5) == 0 {
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(BLOCK)), parameters: 0 });
    } else {
        let function = dice.of(&[OUTER, INNER]);
        give_and_call(b, dice, function);
    }
    b.begin_statement();
    next_turn(b, fixed(COUNTER), (Op::LtI16, 5), Target(1));
    b.begin_statement();
    let (from, to) = (variable(dice), fixed(SUM + 4));
    assigns(b, from, to);
}

fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 100]);
    if dice.roll(2) == 0 {
        let range = machine.memory.layout.data_blocks[&1].clone();
        machine.memory.arena[range.start + dice.roll(16) as usize] = dice.roll(256) as u8;
    }
    Reaction::Continue
}

#[test]
fn what_a_loop_only_reads_is_in_memory_what_its_functions_left_there() {
    let mut asked = 0;
    for seed in seeds(PROGRAMS) {
        let of = |number: u64| Dice(10 * seed + number);
        let program = program(&[
            (BlockId::ob(1), LOCAL_BYTES, &|b: &mut Builder| looping(b, &mut of(0))),
            (BlockId::fc(OUTER), LOCAL_BYTES, &|b: &mut Builder| function(b, &mut of(1), true)),
            (BlockId::fc(INNER), LOCAL_BYTES, &|b: &mut Builder| function(b, &mut of(2), false)),
            (BlockId::fb(BLOCK), LOCAL_BYTES, &|b: &mut Builder| block(b, &mut of(3))),
        ]);
        let layout = layout_with(&program, 64);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[3, 1000, 1000]);
            machine.memory.arena.iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let outcome = |engine: Arc<dyn Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
            let mut outcome = run(engine.as_ref(), &layout, &entry, &prepare, &answer);
            // What was in local data of blocks that have ended.
            outcome.arena[layout.local.clone()].fill(0);
            outcome
        };
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        asked += all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", listing())).asked.len();
    }
    assert!(asked > 100, "{asked} questions");
}
