//! Loops in a block that calls instances in other data blocks: the own data block is open again behind each call, or it is not, since a
//! data block is missing, a value was saved from elsewhere or taken back to elsewhere, or a statement ended too soon. What such loops read
//! and write of their own variables is the same on all engines.

use std::sync::Arc;

use sieben_engine::access::data_registers;
use sieben_engine::fault::NOTED;
use sieben_engine::ir::verify::verify;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target};
use sieben_engine::{Engine, Entry, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout, program, run};

const PROGRAMS: u64 = 400;
const OWN: u64 = 1;
const OTHER: u64 = 2;
const SMALL: u64 = 3;
const MISSING: u64 = 9;
const LOOPS: u16 = 1;
const CALLED: u16 = 2;

fn own(byte: u32) -> Place {
    Place::Fixed { area: Area::InstanceData, position: 8 * byte }
}

fn open(b: &mut Builder, number: u64) {
    let number = b.constant(number);
    b.push(Inst::Open { register: DataRegister::Instance, number });
}

/// Adds to a variable of the open instance.
fn adds(b: &mut Builder, byte: u32, value: u64) {
    let old = b.load(own(byte), Width::Word, OnFault::SkipStatement);
    let value = b.constant(value);
    let new = b.compute(Op::AddU16, &[old, value]);
    b.store(own(byte), Width::Word, new);
}

/// What comes between two data blocks and may end the statement, or use the variables of the wrong one.
fn between(b: &mut Builder, dice: &mut Dice, head: Target) {
    match dice.roll(20) {
        0 => adds(b, 2 * dice.roll(8) as u32, 5),
        5 | 9 => {
            let value = b.load(own(2 * dice.roll(8) as u32), Width::Word, OnFault::DeliverZero);
            b.store(Place::Fixed { area: Area::Local, position: 8 * 12 }, Width::Word, value);
        }
        6 => {
            let number = b.constant(dice.of(&[SMALL, MISSING]));
            b.push(Inst::Open { register: DataRegister::Shared, number });
        }
        1 => {
            let condition = b.load(Place::Fixed { area: Area::BitMemory, position: 0 }, Width::Bit, OnFault::SkipStatement);
            b.push(Inst::Require { condition, code: dice.of(&[NOTED | 0x22, 0x22]), register: condition });
        }
        2 => {
            let place = Place::Fixed { area: Area::SharedData, position: 8 * 20 };
            let value = b.load(place, Width::Word, OnFault::SkipStatement);
            b.store(Place::Fixed { area: Area::Local, position: 8 * 8 }, Width::Word, value);
        }
        3 | 7 | 8 => {
            let condition = b.load(Place::Fixed { area: Area::BitMemory, position: 1 }, Width::Bit, OnFault::SkipStatement);
            b.push(Inst::Branch { condition, to: dice.of(&[Target(b.next().0 + 1), head]) });
        }
        4 => {
            let value = b.load(Place::Fixed { area: Area::Local, position: 8 * 4 }, Width::Word, OnFault::SkipStatement);
            b.store(Place::Fixed { area: Area::Local, position: 8 * 10 }, Width::Word, value);
        }
        _ => {}
    }
}

/// A call of an instance in another data block: the shared one keeps the own one over the call.
fn calls(b: &mut Builder, dice: &mut Dice, head: Target) {
    let (own, shared) = (data_registers(DataRegister::Instance), data_registers(DataRegister::Shared));
    let from = if dice.roll(16) == 0 { shared } else { own };
    let saved = from.map(|register| b.compute(Op::Copy, &[register.into()]));
    between(b, dice, head);
    open(b, dice.of(&[OTHER, OTHER, OTHER, OTHER, SMALL, OWN, MISSING, 0]));
    between(b, dice, head);
    if dice.roll(16) != 0 {
        for (register, value) in shared.into_iter().zip(saved) {
            b.copy(register, value);
        }
    }
    if dice.roll(6) != 0 {
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(dice.of(&[CALLED, CALLED, CALLED, CALLED, 77]))), parameters: 0 });
    }
    between(b, dice, head);
    if dice.roll(16) != 0 {
        for (register, kept) in own.into_iter().zip(shared) {
            b.copy(register, kept);
        }
    }
    if dice.roll(3) == 0 {
        adds(b, 2 * dice.roll(8) as u32, 3);
    }
}

fn loops(b: &mut Builder, dice: &mut Dice) {
    for _ in 0..1 + dice.roll(2) {
        let (counter, iterations) = (dice.of(&[own(2), own(14), Place::Fixed { area: Area::Local, position: 0 }]), 2 + dice.roll(5));
        b.begin_statement();
        let first = b.constant(0);
        b.store(counter, Width::Word, first);
        let head = b.next();
        for _ in 0..1 + dice.roll(4) {
            b.begin_statement();
            match dice.roll(3) {
                0 => adds(b, 2 * dice.roll(8) as u32, dice.roll(9)),
                _ => calls(b, dice, head),
            }
        }
        b.begin_statement();
        let (old, one, last) = (b.load(counter, Width::Word, OnFault::SkipStatement), b.constant(1), b.constant(iterations));
        let new = b.compute(Op::AddU16, &[old, one]);
        b.store(counter, Width::Word, new);
        let again = b.compute(Op::LtI16, &[new, last]);
        b.push(Inst::Branch { condition: again, to: head });
    }
    b.begin_statement();
    b.push(Inst::Return);
}

fn called(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    adds(b, dice.of(&[0, 2, 6]), 7);
    if dice.roll(4) == 0 {
        b.begin_statement();
        open(b, dice.of(&[OWN, SMALL, MISSING]));
        adds(b, 2, 1);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn loops_that_call_instances_in_other_data_blocks_do_what_the_interpreter_does() {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let mut valid = 0;
    for seed in seeds(PROGRAMS) {
        let begins = |b: &mut Builder| {
            b.begin_statement();
            for (register, number) in [(DataRegister::Instance, OWN), (DataRegister::Shared, SMALL)] {
                let number = b.constant(number);
                b.push(Inst::Open { register, number });
            }
            b.push(Inst::Call { callee: Callee::Block(BlockId::fb(LOOPS)), parameters: 0 });
            b.begin_statement();
            b.push(Inst::Return);
        };
        let (body, inner) = (|b: &mut Builder| loops(b, &mut Dice(seed)), |b: &mut Builder| called(b, &mut Dice(seed + 1000)));
        let program = program(&[(BlockId::ob(1), 40, &begins), (BlockId::fb(LOOPS), 40, &body), (BlockId::fb(CALLED), 0, &inner)]);
        let is_valid = program.code.values().all(|block| verify(&block.code).is_ok());
        if !is_valid {
            continue;
        }
        valid += 1;
        let mut layout = layout(&program);
        for (number, bytes) in [(OTHER as u16, 32), (SMALL as u16, 6)] {
            layout.data_blocks.insert(number, layout.size..layout.size + bytes);
            layout.size += 64;
        }
        let engines = engines(&program, &layout);
        for memory in 0..6 {
            let outcome = |engine: Arc<dyn Engine>| {
                let prepare = |machine: &mut Machine| {
                    let mut dice = Dice(11 * seed + memory);
                    machine.budget = [200, 30, 1][memory as usize % 3];
                    let layout = machine.memory.layout.clone();
                    machine.memory.arena[layout.bit_memory.start] = dice.roll(4) as u8;
                    for data in layout.data_blocks.values() {
                        machine.memory.arena[data.clone()].fill_with(|| dice.roll(4) as u8);
                    }
                };
                run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, asked| {
                    if asked < 60 { Reaction::Continue } else { Reaction::Stop(StopReason { event: 0x4562, place: None }) }
                })
            };
            let what = || format!("program {seed}, memory {memory}\n{}", program.code[&BlockId::fb(LOOPS)].code);
            all_engines_agree(&engines, true, &outcome, &what);
        }
    }
    assert!(valid > PROGRAMS / 4, "{valid} programs were valid");
}
