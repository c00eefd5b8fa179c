//! Counted loops of which only some iterations call a function block of an array, or divide by a number that nobody knows: whatever the
//! Host makes of memory and budget between iterations, they do on all engines what the interpreter does.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Layout, Machine, Program, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, program, run};

const PROGRAMS: u64 = 200;
const QUESTIONS_MAX: usize = 40;
/// The function block with the loop, and those that it calls.
const LOOPS: u16 = 1;
const CALLED: [u16; 2] = [2, 3];
/// Instances of the array, and bytes of one; what else the data block holds lies behind them.
const INSTANCES: u32 = 6;
const INSTANCE: u32 = 8;
const COUNTER: u32 = 8 * INSTANCES * INSTANCE;
const NUMBERS: u32 = COUNTER + 32;
const FLAGS: u32 = NUMBERS + 64;
const QUOTIENT: u32 = NUMBERS + 96;
const DATA_BYTES: usize = 72;
/// Fields of an instance: where they lie, in bits.
const FIELDS: &[(u32, Width)] = &[(0, Width::DoubleWord), (0, Width::Word), (32, Width::Word), (48, Width::Bit), (49, Width::Bit)];
/// Where the instance of the loop is saved over calls.
const SAVED: Place = Place::Fixed { area: Area::Local, position: 32 };

fn own(offset: u32) -> Place {
    Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

/// The instance of an iteration.
fn instance(b: &mut Builder) -> Var {
    let (counter, limit) = (load(b, own(COUNTER), Width::DoubleWord), b.constant(u64::from(INSTANCES)));
    let inside = b.compute(Op::Below, &[counter, limit]);
    b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: counter });
    let counter = b.compute(Op::Gate, &[counter, inside]);
    let bits = b.constant(u64::from(8 * INSTANCE));
    let by = b.compute(Op::MulU32, &[counter, bits]);
    b.compute(Op::AddU32, &[Register::Ar2.into(), by])
}

/// A variable of the block with the loop, or of the instance of an iteration.
fn variable(b: &mut Builder, dice: &mut Dice, is_loop: bool) -> (Place, Width) {
    if !is_loop {
        let (offset, width) = dice.of(FIELDS);
        return (own(offset), width);
    }
    match dice.roll(8) {
        0..=2 => {
            let (pointer, (offset, width)) = (instance(b), dice.of(FIELDS));
            (Place::Indirect { area: Area::InstanceData, pointer, offset }, width)
        }
        3 | 4 => (own(FLAGS + dice.roll(4) as u32), Width::Bit),
        5 => (Place::Fixed { area: Area::Local, position: dice.of(&[0, 64]) }, Width::DoubleWord),
        _ => (own(NUMBERS + dice.of(&[0, 32])), Width::DoubleWord),
    }
}

fn assignment(b: &mut Builder, dice: &mut Dice, is_loop: bool) {
    let (place, width) = variable(b, dice, is_loop);
    // It often grows by something.
    let (one, one_width) = if dice.roll(2) == 0 { (place, width) } else { variable(b, dice, is_loop) };
    let (other, other_width) = variable(b, dice, is_loop);
    let (one, mut other) = (load(b, one, one_width), load(b, other, other_width));
    if dice.roll(5) == 0 {
        other = b.constant(dice.of(&[0, 1, 0xFFFF_FFFF, 0x8000_0000]));
    }
    let value = match width {
        Width::Bit => b.compute(dice.of(&[Op::Differ, Op::DivFailsI32, Op::DivFailsI16, Op::DivisorIsZero, Op::LtI32]), &[one, other]),
        Width::Word => b.compute(dice.of(&[Op::DivI16, Op::RemI16, Op::AddU16]), &[one, other]),
        _ => b.compute(dice.of(&[Op::DivI32, Op::RemI32, Op::AddU32, Op::AddU32, Op::SubU32]), &[one, other]),
    };
    b.store(place, width, value);
}

/// Calls a function block with the instance of the iteration. Now and then what is saved is no longer where the loop began.
fn call(b: &mut Builder, dice: &mut Dice) {
    let pointer = instance(b);
    let value = load(b, own(NUMBERS), Width::DoubleWord);
    b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 0 }, Width::DoubleWord, value);
    b.store(SAVED, Width::DoubleWord, Register::Ar2);
    b.copy(Register::Ar2, pointer);
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(dice.of(&CALLED))), parameters: 0 });
    let mut saved = load(b, SAVED, Width::DoubleWord);
    if dice.roll(24) == 0 {
        let more = b.constant(16);
        saved = b.compute(Op::AddU32, &[saved, more]);
    }
    b.copy(Register::Ar2, saved);
}

/// Statements of which some are jumped over under a condition, and how many they are with those before them.
fn parts(b: &mut Builder, dice: &mut Dice, is_loop: bool, mut statements: u32) -> u32 {
    for _ in 0..1 + dice.roll(5) {
        let over = dice.roll(3) as u32;
        if over > 0 {
            b.begin_statement();
            // Often a condition that holds in other places, too.
            let flag = if is_loop { own(FLAGS + dice.roll(2) as u32) } else { own(48) };
            let (place, width) = if dice.roll(2) == 0 { (flag, Width::Bit) } else { variable(b, dice, is_loop) };
            let value = load(b, place, width);
            let condition = b.compute(dice.of(&[Op::IsNonzero, Op::IsNonzero, Op::Not]), &[value]);
            b.push(Inst::Branch { condition, to: Target(statements + 1 + over) });
            statements += 1;
        }
        for _ in 0..over.max(1) {
            b.begin_statement();
            if is_loop && dice.roll(3) == 0 {
                call(b, dice)
            } else {
                assignment(b, dice, is_loop)
            }
            statements += 1;
        }
    }
    statements
}

/// A loop over all instances.
fn looping(b: &mut Builder, iteration: &dyn Fn(&mut Builder) -> u32) {
    b.begin_statement();
    let zero = b.constant(0);
    b.store(own(COUNTER), Width::DoubleWord, zero);
    iteration(b);
    b.begin_statement();
    let (counter, one) = (load(b, own(COUNTER), Width::DoubleWord), b.constant(1));
    let next = b.compute(Op::AddU32, &[counter, one]);
    b.store(own(COUNTER), Width::DoubleWord, next);
    let last = b.constant(u64::from(INSTANCES - 1));
    let again = b.compute(Op::LeI32, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(1) });
}

fn begin(b: &mut Builder) {
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Instance, number });
    b.set(Register::Ar2, 0x8400_0000);
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(LOOPS)), parameters: 0 });
}

fn whole(iteration: &dyn Fn(&mut Builder) -> u32, called: [&dyn Fn(&mut Builder); 2]) -> (Program, Layout) {
    let main = |b: &mut Builder| looping(b, iteration);
    let program = program(&[
        (BlockId::ob(1), 4, &begin),
        (BlockId::fb(LOOPS), 12, &main),
        (BlockId::fb(CALLED[0]), 0, called[0]),
        (BlockId::fb(CALLED[1]), 0, called[1]),
    ]);
    let mut layout = noting::layout(&program);
    layout.data_blocks.insert(1, layout.size - DATA_BYTES..layout.size);
    (program, layout)
}

#[test]
fn iterations_that_call_and_divide_now_and_then_do_what_the_interpreter_does() {
    let (mut asked, mut finished, mut at_once) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let of_block = |number: u64| Dice(100 * seed + number);
        let called = |number: u64| {
            move |b: &mut Builder| {
                parts(b, &mut of_block(number), false, 0);
            }
        };
        let (program, layout) = whole(&|b| parts(b, &mut of_block(0), true, 1), [&called(1), &called(2)]);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 2, 3, 5, 8, 12, 1_000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.of(&[0, 0, 0, 1, 5, 0x80, 0xFF, 0xFF]));
        };
        let outcome = |engine: Arc<dyn Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| {
                if asked >= QUESTIONS_MAX {
                    return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
                }
                let dice = &mut *dice.borrow_mut();
                machine.budget = dice.of(&[0, 1, 2, 3, 5, 8, 12, 1_000]);
                let range = machine.memory.layout.data_blocks[&1].clone();
                let byte = range.start + dice.roll(DATA_BYTES as u64) as usize;
                if dice.roll(3) == 0 {
                    machine.memory.arena[byte] = dice.of(&[0, 1, 3, 0x80, 0xFF]);
                }
                Reaction::Continue
            };
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("{seed}\n{}", listing()));
        at_once += usize::from(has_iterations_at_once(&program, &layout));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 150 && finished > 150, "{asked} questions, {finished} runs to the end");
    assert!(at_once > 100, "{at_once} loops that are done at once");
}

/// Whether iterations of a loop are done at once: the budget limits how many.
fn has_iterations_at_once(program: &Program, layout: &Layout) -> bool {
    Jit::listing(program, layout).expect("machine code").contains("smin")
}

/// Whether those of a loop are that jumps over a statement now and then.
fn is_done_at_once(statement: &dyn Fn(&mut Builder)) -> bool {
    let iteration = |b: &mut Builder| {
        b.begin_statement();
        let condition = load(b, own(FLAGS), Width::Bit);
        b.push(Inst::Branch { condition, to: Target(3) });
        b.begin_statement();
        statement(b);
        b.begin_statement();
        let (pointer, value) = (instance(b), load(b, own(NUMBERS), Width::DoubleWord));
        b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 0 }, Width::DoubleWord, value);
        4
    };
    let counts = |b: &mut Builder| {
        b.begin_statement();
        let (value, one) = (load(b, own(32), Width::Word), b.constant(1));
        let value = b.compute(Op::AddU16, &[value, one]);
        b.store(own(32), Width::Word, value);
    };
    let (program, layout) = whole(&iteration, [&counts, &counts]);
    has_iterations_at_once(&program, &layout)
}

#[test]
fn behind_a_call_that_some_iterations_jump_over_the_instance_of_the_loop_is_known() {
    let calls = |moved: u64| {
        move |b: &mut Builder| {
            b.store(SAVED, Width::DoubleWord, Register::Ar2);
            let pointer = instance(b);
            b.copy(Register::Ar2, pointer);
            b.push(Inst::Call { callee: Callee::Block(BlockId::fb(CALLED[0])), parameters: 0 });
            let (saved, more) = (load(b, SAVED, Width::DoubleWord), b.constant(moved));
            let saved = if moved == 0 { saved } else { b.compute(Op::AddU32, &[saved, more]) };
            b.copy(Register::Ar2, saved);
        }
    };
    assert!(is_done_at_once(&calls(0)));
    assert!(!is_done_at_once(&calls(16)), "the next iteration begins somewhere else");
}

#[test]
fn some_divisions_that_some_iterations_jump_over_are_done_in_all_of_them() {
    let divides = |op: Op, count: u32, to: u32| {
        move |b: &mut Builder| {
            for _ in 0..count {
                let [a, by] = [0, 32].map(|offset| load(b, own(NUMBERS + offset), Width::DoubleWord));
                let result = b.compute(op, &[a, by]);
                b.store(own(to), Width::DoubleWord, result);
            }
        }
    };
    for op in [Op::DivI32, Op::RemI32, Op::DivI16, Op::RemI16, Op::DivFailsI32, Op::DivisorIsZero] {
        assert!(is_done_at_once(&divides(op, 2, QUOTIENT)), "{op:?}");
    }
    assert!(!is_done_at_once(&divides(Op::DivI32, 9, QUOTIENT)), "that takes longer than to jump");
    assert!(!is_done_at_once(&divides(Op::DivI64, 1, QUOTIENT)), "one that takes long itself");
    assert!(is_done_at_once(&divides(Op::DivI32, 1, NUMBERS)), "the next iteration waits, but not for long");
    assert!(!is_done_at_once(&divides(Op::DivI32, 2, NUMBERS)), "the next iteration would wait for what this one had jumped over");
}

#[test]
fn what_grew_under_a_condition_is_read_under_the_same_condition() {
    for op in [Op::AddU32, Op::SubU32] {
        let iteration = |b: &mut Builder| {
            // Statements 1 and 3 jump over those behind them, under the same condition.
            for at in [1, 3] {
                b.begin_statement();
                let condition = load(b, own(FLAGS), Width::Bit);
                b.push(Inst::Branch { condition, to: Target(at + 2) });
                b.begin_statement();
                let (number, counter) = (load(b, own(NUMBERS), Width::DoubleWord), load(b, own(COUNTER), Width::DoubleWord));
                if at == 1 {
                    let value = b.compute(op, &[number, counter]);
                    b.store(own(NUMBERS), Width::DoubleWord, value);
                } else {
                    let pointer = instance(b);
                    b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: 0 }, Width::DoubleWord, number);
                }
            }
            5
        };
        let nothing = |b: &mut Builder| {
            b.begin_statement();
        };
        let (program, layout) = whole(&iteration, [&nothing, &nothing]);
        assert!(has_iterations_at_once(&program, &layout), "{op:?}");
        let engines = engines(&program, &layout);
        for flag in [0, 1] {
            let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
            let prepare = |machine: &mut Machine| {
                machine.budget = 1_000;
                let start = machine.memory.layout.data_blocks[&1].start;
                machine.memory.arena[start + FLAGS as usize / 8] = flag;
            };
            let outcome = |engine: Arc<dyn Engine>| run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue);
            all_engines_agree(&engines, true, &outcome, &|| format!("{op:?} {flag}"));
        }
    }
}
