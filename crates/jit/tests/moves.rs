//! Copies whose ends are behind pointers that somebody changes: where machine code looks for them itself, it does what the interpreter does
//! with data blocks that are missing or too short, areas of every kind, bytes that overlap, and pointers into the middle of a byte.

use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, count_on, engines, layout_with, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 300;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 80;
/// Pointers with the numbers of their data blocks, in bit memory: so many, of eight bytes each.
const POINTERS: u64 = 6;
/// Bytes of the data blocks, of which the second one is shorter.
const DATA_BYTES: usize = 400;
const OTHER_BYTES: usize = 60;
const LOCAL_BYTES: u32 = 80;
/// Where a block counts its iterations.
const COUNTER: Place = Place::Fixed { area: Area::Local, position: 8 * 76 };

/// Some pointer: mostly one that leads to bytes that are there.
fn pointer(dice: &mut Dice) -> u64 {
    let area = dice.of(&[0x84, 0x84, 0x84, 0x84, 0x84, 0x83, 0x82, 0x81, 0x85, 0x86, 0x87, 0x87, 0x80, 0x00]);
    let byte = match dice.roll(8) {
        0 => dice.of(&[OTHER_BYTES as u64 - 4, DATA_BYTES as u64 - 4, 1 << 19, (1 << 21) - 2]),
        _ => dice.roll(40),
    };
    let bit = if dice.roll(16) == 0 { 3 } else { 0 };
    dice.of(&[1, 1, 1, 2, 2, 0, 9, 700]) << 32 | area << 24 | (8 * byte + bit) & 0x00FF_FFFF
}

fn place(b: &mut Builder, dice: &mut Dice) -> Place {
    let offset = 8 * dice.of(&[0, 0, 0, 1, 6, 20]);
    let moved = |b: &mut Builder, dice: &mut Dice, pointer: Var| {
        if dice.roll(2) == 0 {
            return pointer;
        }
        let index = b.load(COUNTER, Width::Word, OnFault::SkipStatement);
        let step = b.constant(8 * dice.of(&[1, 4, 24]));
        let by = b.compute(Op::MulU32, &[index, step]);
        if dice.roll(3) == 0 {
            return b.compute(Op::AddU64, &[pointer, by]);
        }
        // As Structured Text does it: the number of the data block stays above the sum.
        let (own, half) = (b.compute(Op::AddU32, &[pointer, by]), b.constant(32));
        let number = b.compute(Op::Shr64, &[pointer, half]);
        let number = b.compute(Op::Shl64, &[number, half]);
        b.compute(Op::OrU64, &[number, own])
    };
    match dice.roll(8) {
        0 => Place::Fixed { area: dice.of(&[Area::Local, Area::BitMemory, Area::SharedData, Area::InstanceData]), position: offset },
        1 => {
            let area = dice.of(&[Area::SharedData, Area::InstanceData, Area::InstanceData, Area::BitMemory]);
            Place::Indirect { area, pointer: moved(b, dice, Register::Ar2.into()), offset }
        }
        2 => {
            let known = pointer(dice) & dice.of(&[0xFFFF_FFFF, u64::MAX]);
            let known = b.constant(known);
            Place::Crossing { pointer: moved(b, dice, known), offset }
        }
        _ => {
            let at = Place::Fixed { area: Area::BitMemory, position: 64 * (1 + dice.roll(POINTERS) as u32) };
            let read = b.load(at, Width::QuadWord, OnFault::SkipStatement);
            Place::Crossing { pointer: moved(b, dice, read), offset }
        }
    }
}

fn block(b: &mut Builder, mut dice: Dice, calls: Option<u16>) {
    b.begin_statement();
    let zero = b.constant(0);
    b.store(COUNTER, Width::Word, zero);
    for register in [DataRegister::Shared, DataRegister::Instance] {
        if calls.is_some() || dice.roll(3) == 0 {
            let number = b.constant(dice.of(&[1, 1, 2]));
            b.push(Inst::Open { register, number });
        }
    }
    let statements = 1 + dice.roll(4) as u32;
    for _ in 0..statements {
        b.begin_statement();
        let (from, to) = (place(b, &mut dice), place(b, &mut dice));
        b.push(Inst::Move { from, to, bytes: dice.of(&[1, 2, 3, 7, 8, 11, 16, 24, 44, 65, 256, 257]) });
    }
    if let Some(number) = calls {
        b.begin_statement();
        let pointer = b.constant(0x8400_0000 + 8 * dice.roll(8));
        b.copy(Register::Ar2, pointer);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(number)), parameters: 0 });
    }
    b.begin_statement();
    count_on(b, COUNTER, (Op::LtI16, 3), Target(1));
}

/// Changes a pointer and the budget, and goes on.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[1, 2, 5, 20, 60]);
    if dice.roll(2) == 0 {
        let at = 8 * (1 + dice.roll(POINTERS) as usize);
        let pointer = pointer(dice).to_be_bytes();
        machine.memory.area_mut(Area::BitMemory)[at..at + 8].copy_from_slice(&pointer);
    }
    Reaction::Continue
}

#[test]
fn copies_behind_unknown_pointers_are_the_same_on_all_engines() {
    let (mut faults, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let build = |number: u16| move |b: &mut Builder| block(b, Dice(seed * 10 + u64::from(number)), (number < 2).then_some(number + 1));
        let builders = [build(0), build(1), build(2)];
        let parts = [(BlockId::ob(1), 0), (BlockId::fc(1), 1), (BlockId::fc(2), 2)];
        let parts: Vec<_> = parts.into_iter().map(|(id, at)| (id, LOCAL_BYTES, &builders[at] as &dyn Fn(&mut Builder))).collect();
        let program = program(&parts);
        let mut layout = layout_with(&program, DATA_BYTES);
        layout.size += OTHER_BYTES;
        layout.data_blocks.insert(2, layout.size - OTHER_BYTES..layout.size);
        if seed % 5 == 0 {
            layout.read_only.push(2);
        }
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = 1 + dice.roll(60) as i64;
            machine.memory.arena.iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            for at in 1..=POINTERS as usize {
                let pointer = pointer(&mut dice).to_be_bytes();
                machine.memory.area_mut(Area::BitMemory)[8 * at..8 * at + 8].copy_from_slice(&pointer);
            }
        };
        let outcome = |engine: Arc<dyn Engine>| {
            let dice = std::cell::RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        let expected = all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", listing()));
        faults += expected.asked.iter().filter(|asked| !asked.starts_with("safe")).count();
        finished += usize::from(expected.asked.len() < QUESTIONS_MAX);
    }
    assert!(faults > 1_000 && finished > 100, "{faults} faults, {finished} runs to the end");
}
