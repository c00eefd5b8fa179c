//! Functions that branch and become part of their callers: numbers in their local data, and what they were handed, are the ones that the
//! interpreter finds there, on all ways through them and whatever a Host does that is asked meanwhile.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Machine, Program, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout_with, program, run};

const PROGRAMS: u64 = 400;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 30;
/// Functions of a program; each may call those behind it.
const FUNCTIONS: u16 = 2;
/// Numbers of a function that only their constant address reaches; the last one counts.
const OWN: [(u32, Width); 4] = [(0, Width::DoubleWord), (32, Width::DoubleWord), (64, Width::Word), (96, Width::Word)];
/// What a block hands to a function: two numbers and a result.
const HANDED: [u32; 3] = [128, 160, 192];
const LOCAL_BYTES: u32 = 32;
/// In bit memory.
const RESULT: u32 = 8 * 40;
const INDEX: u32 = 8 * 44;
const DATA_BYTES: usize = 40;

fn local(position: u32) -> Place {
    Place::Fixed { area: Area::Local, position }
}

fn memory(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

/// The numbers of a function. Those of the last one, which hands nothing on, lie where the others keep what they hand on.
fn owned(number: u16) -> [(u32, Width); 4] {
    let [first, second, third, last] = OWN;
    if number < FUNCTIONS {
        return OWN;
    }
    [(HANDED[2], first.1), (HANDED[2] + 32, second.1), (HANDED[0] + 16, third.1), (HANDED[1] + 16, last.1)]
}

fn own(b: &mut Builder, dice: &mut Dice, number: u16) -> Var {
    let (position, width) = dice.of(&owned(number));
    load(b, local(position), width)
}

/// What a function was given.
fn given(b: &mut Builder, index: u16) -> Var {
    let pointer = b.temporary();
    b.push(Inst::Parameter { dst: pointer, index });
    load(b, Place::Crossing { pointer, offset: 0 }, Width::DoubleWord)
}

/// Calls a function with two numbers; its result.
fn calls(b: &mut Builder, dice: &mut Dice, function: u16, numbers: [Var; 2]) -> Var {
    let nothing = b.constant(0);
    for (position, value) in HANDED.into_iter().zip([numbers[0], numbers[1], nothing]) {
        b.store(local(position), Width::DoubleWord, value);
    }
    // Sometimes it is called again with the same numbers.
    for _ in 0..dice.of(&[1, 1, 1, 2]) {
        for position in HANDED {
            let pointer = b.constant(0x8700_0000 | u64::from(position));
            b.push(Inst::PassParameter { src: pointer });
        }
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(function)), parameters: 3 });
    }
    let result = load(b, local(HANDED[2]), Width::DoubleWord);
    if dice.roll(4) == 0 {
        let handed = load(b, local(dice.of(&HANDED[..2])), Width::DoubleWord);
        return b.compute(Op::XorU32, &[result, handed]);
    }
    result
}

/// A statement of a function.
fn assigns(b: &mut Builder, dice: &mut Dice, number: u16) {
    b.begin_statement();
    let value = match dice.roll(9) {
        0 => given(b, dice.roll(2) as u16),
        1 => load(b, memory(RESULT), Width::DoubleWord),
        // An element that may lie behind the data block.
        2 => {
            let (index, bits) = (load(b, memory(INDEX), Width::Word), b.constant(16));
            let pointer = b.compute(Op::MulU32, &[index, bits]);
            load(b, Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, Width::Word)
        }
        3 | 4 if number < FUNCTIONS => {
            let numbers = [own(b, dice, number), own(b, dice, number)];
            calls(b, dice, number + 1, numbers)
        }
        5 => b.constant(dice.roll(70_000)),
        _ => own(b, dice, number),
    };
    let other = own(b, dice, number);
    let value = b.compute(dice.of(&[Op::AddU32, Op::XorU32, Op::AndU32]), &[value, other]);
    match dice.roll(6) {
        0 => b.store(memory(RESULT), Width::DoubleWord, value),
        _ => {
            let (position, width) = dice.of(&owned(number)[..3]);
            b.store(local(position), width, value);
        }
    }
}

/// `IF … THEN … ELSE … END_IF`.
fn chooses(b: &mut Builder, dice: &mut Dice, number: u16) {
    let first = b.next().0;
    b.begin_statement();
    let (value, limit) = (own(b, dice, number), b.constant(dice.of(&[1, 100, 0x8000])));
    let condition = b.compute(dice.of(&[Op::LtI32, Op::GtI32, Op::EqI32]), &[value, limit]);
    b.push(Inst::Branch { condition, to: Target(first + 3) });
    assigns(b, dice, number);
    b.begin_statement();
    b.push(Inst::Jump { to: Target(first + 4) });
    assigns(b, dice, number);
}

fn function(b: &mut Builder, dice: &mut Dice, number: u16, writes_first: bool) {
    let owned = owned(number);
    b.begin_statement();
    for (index, (position, width)) in owned[..2].iter().enumerate() {
        let value = given(b, index as u16);
        b.store(local(*position), *width, value);
    }
    if writes_first {
        b.begin_statement();
        for (position, width) in &owned[2..] {
            let value = b.constant(dice.roll(3));
            b.store(local(*position), *width, value);
        }
    }
    let body = b.next().0;
    for _ in 0..1 + dice.roll(3) {
        if dice.roll(3) > 0 {
            chooses(b, dice, number);
        } else {
            assigns(b, dice, number);
        }
    }
    if writes_first && dice.roll(4) == 0 {
        b.begin_statement();
        let (counter, one) = (load(b, local(owned[3].0), Width::Word), b.constant(1));
        let next = b.compute(Op::AddU16, &[counter, one]);
        b.store(local(owned[3].0), Width::Word, next);
        let limit = b.constant(3);
        let again = b.compute(Op::Below, &[next, limit]);
        b.push(Inst::Branch { condition: again, to: Target(body) });
    }
    b.begin_statement();
    let result = own(b, dice, number);
    let pointer = b.temporary();
    b.push(Inst::Parameter { dst: pointer, index: 2 });
    b.store(Place::Crossing { pointer, offset: 0 }, Width::DoubleWord, result);
}

fn caller(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    for _ in 0..2 + dice.roll(3) {
        b.begin_statement();
        let numbers = [load(b, memory(RESULT), Width::DoubleWord), b.constant(dice.roll(300))];
        let function = dice.of(&[1, 1, 2]);
        let result = calls(b, dice, function, numbers);
        let before = load(b, memory(RESULT), Width::DoubleWord);
        let sum = b.compute(Op::AddU32, &[before, result]);
        b.store(memory(RESULT), Width::DoubleWord, sum);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 40, 400]);
    machine.memory.area_mut(Area::BitMemory)[RESULT as usize / 8 + 3] = dice.of(&[0, 1, 2, 99, 0xFF]);
    Reaction::Continue
}

fn declared(program: &mut Program, writes_first: bool) {
    for (id, block) in &mut program.code {
        block.reads_own_locals = writes_first;
        if *id != BlockId::fc(FUNCTIONS) {
            block.handed = HANDED.iter().map(|&position| position..position + 32).collect();
        }
        if *id != BlockId::ob(1) {
            block.private = owned(id.number).to_vec();
        }
    }
}

#[test]
fn numbers_of_functions_that_branch_are_those_of_the_interpreter() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let writes_first = seed % 6 > 0;
        let build = |number: u16| {
            move |b: &mut Builder| {
                let mut dice = Dice(seed * 100 + u64::from(number));
                if number == 0 { caller(b, &mut dice) } else { function(b, &mut dice, number, writes_first) }
            }
        };
        let builders: Vec<_> = (0..=FUNCTIONS).map(|number| (number, build(number))).collect();
        let id = |number: u16| if number == 0 { BlockId::ob(1) } else { BlockId::fc(number) };
        let parts: Vec<_> = builders.iter().map(|(number, build)| (id(*number), LOCAL_BYTES, build as &dyn Fn(&mut Builder))).collect();
        let mut program = program(&parts);
        declared(&mut program, writes_first);
        let layout = layout_with(&program, DATA_BYTES);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[5, 40, 400, 4000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            machine.memory.area_mut(Area::BitMemory)[INDEX as usize / 8 + 1] = dice.of(&[0, 3, 19, 20, 100]);
        };
        let listing: String = program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect();
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let outcome = |engine: Arc<dyn Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
            let mut outcome = run(engine.as_ref(), &layout, &entry, &prepare, &answer);
            // Nobody sees what finished blocks leave in their local data.
            outcome.arena[layout.local.clone()].fill(0);
            outcome
        };
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("{seed}\n{listing}"));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 250 && finished > 250, "{asked} questions, {finished} runs to the end");
}

/// A function with two ways of some statements, called once: stores in the machine code.
fn stores(are_handed: bool) -> usize {
    let mixes = |b: &mut Builder, op: Op| {
        for (to, width) in [OWN[0], OWN[1]] {
            b.begin_statement();
            let [x, y] = [OWN[0], OWN[1]].map(|(position, width)| load(b, local(position), width));
            let value = b.compute(op, &[x, y]);
            let value = b.compute(Op::MulU32, &[value, x]);
            b.store(local(to), width, value);
            b.store(memory(INDEX), Width::DoubleWord, value);
        }
    };
    let function = |b: &mut Builder| {
        b.begin_statement();
        for (index, (position, width)) in OWN[..2].iter().enumerate() {
            let value = given(b, index as u16);
            b.store(local(*position), *width, value);
        }
        b.begin_statement();
        let [x, y] = [OWN[0], OWN[1]].map(|(position, width)| load(b, local(position), width));
        let condition = b.compute(Op::LtI32, &[x, y]);
        b.push(Inst::Branch { condition, to: Target(5) });
        mixes(b, Op::AddU32);
        b.begin_statement();
        b.push(Inst::Jump { to: Target(7) });
        mixes(b, Op::XorU32);
        b.begin_statement();
        let result = load(b, local(OWN[0].0), Width::DoubleWord);
        let pointer = b.temporary();
        b.push(Inst::Parameter { dst: pointer, index: 2 });
        b.store(Place::Crossing { pointer, offset: 0 }, Width::DoubleWord, result);
    };
    let outer = |b: &mut Builder| {
        b.begin_statement();
        let numbers = [load(b, memory(RESULT), Width::DoubleWord), b.constant(100)];
        let result = calls(b, &mut Dice(1), 1, numbers);
        b.store(memory(RESULT), Width::DoubleWord, result);
        b.begin_statement();
        b.push(Inst::Return);
    };
    let mut program = program(&[(BlockId::ob(1), LOCAL_BYTES, &outer), (BlockId::fc(1), LOCAL_BYTES, &function)]);
    declared(&mut program, true);
    for block in program.code.values_mut() {
        if !are_handed {
            block.handed.clear();
        }
    }
    let listing = Jit::listing(&program, &layout_with(&program, DATA_BYTES)).expect("machine code");
    let code = listing.split("OB 1\n").nth(2).unwrap_or_default();
    code.lines().filter(|line| line.trim_start().starts_with("store")).count()
}

#[test]
fn numbers_that_nobody_else_sees_are_not_stored() {
    let [all, handed] = [false, true].map(stores);
    assert!(handed < all, "{handed} and {all} stores");
}
