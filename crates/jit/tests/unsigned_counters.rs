//! Loops over arrays that count in numbers without sign, up or down, from and to either end of their type, with limits that may be beyond
//! it: whatever ends them, memory, registers and questions are those of the interpreter.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, layout_with, program, run, run_beside};

const PROGRAMS: u64 = 250;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 30;
/// Three arrays, one behind the other.
const ARRAY_BYTES: u32 = 400;
const DATA_BYTES: usize = 3 * ARRAY_BYTES as usize;

/// The counter, a sum, and limits: in bit memory.
const COUNTER: u32 = 0;
const SUM: u32 = 8;
const LIMIT: u32 = 16;
const BEYOND: u32 = 24;
/// A number that is counted beside the counter, and overflows.
const BESIDE: u32 = 32;

struct Type {
    width: Width,
    operations: [Op; 2],
    most: u64,
}

const TYPES: [Type; 2] = [
    Type { width: Width::Word, operations: [Op::AddU16, Op::SubU16], most: 0xFFFF },
    Type { width: Width::DoubleWord, operations: [Op::AddU32, Op::SubU32], most: 0xFFFF_FFFF },
];

fn at(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

/// A loop in the making.
struct Loop<'t> {
    ty: &'t Type,
    /// The index of the first elements of the arrays.
    low: u64,
}

impl Loop<'_> {
    fn element(&self, b: &mut Builder, dice: &mut Dice, width: Width, array: u32) -> Place {
        let (mut number, low) = match dice.roll(10) {
            0 | 1 => (load(b, at(BESIDE), Width::Word), dice.of(&[0, 0xFFF0])),
            2 => (self.looked_at(b), 0),
            _ => (load(b, at(COUNTER), self.ty.width), self.low),
        };
        if low != 0 {
            let low = b.constant(low);
            number = b.compute(Op::SubU32, &[number, low]);
        }
        let mut bits = width.bits().trailing_zeros();
        bits += u32::from(dice.roll(8) == 0);
        let bits = b.constant(bits.into());
        let offset = b.compute(Op::Shl32, &[number, bits]);
        let first = b.constant(0x8400_0000);
        let pointer = b.compute(Op::AddU32, &[first, offset]);
        let beside = if dice.roll(6) == 0 { 2 } else { 0 };
        Place::Indirect { area: Area::SharedData, pointer, offset: 8 * (ARRAY_BYTES * array + beside) }
    }

    /// A number of 64 bits that is an index of an array, or counts as the first one.
    fn looked_at(&self, b: &mut Builder) -> Var {
        let number = load(b, at(BEYOND), Width::QuadWord);
        let low = b.compute(Op::Low32, &[number]);
        let count = b.constant(50);
        let below = b.compute(Op::Below, &[low, count]);
        let is_beyond = b.compute(Op::OverflowsI32, &[number]);
        let inside = b.compute(Op::AndNot, &[below, is_beyond]);
        b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: low });
        b.compute(Op::Gate, &[low, inside])
    }

    fn statement(&self, b: &mut Builder, dice: &mut Dice) {
        let width = dice.of(&[Width::Word, Width::DoubleWord, Width::DoubleWord]);
        b.begin_statement();
        if dice.roll(6) == 0 {
            let (value, step) = (load(b, at(BESIDE), Width::Word), b.constant(dice.of(&[1, 2, 0xFFFF])));
            let next = b.compute(Op::AddU16, &[value, step]);
            return b.store(at(BESIDE), Width::Word, next);
        }
        let value = match dice.roll(6) {
            0 => load(b, at(COUNTER), self.ty.width),
            1 => {
                let number = load(b, at(COUNTER), self.ty.width);
                let limit = b.constant(dice.of(&[3, 40, self.ty.most - 20]));
                let below = b.compute(dice.of(&[Op::Below, Op::GeU64]), &[number, limit]);
                let other = b.constant(7);
                b.compute(Op::Select, &[below, number, other])
            }
            2 => {
                let number = load(b, at(COUNTER), self.ty.width);
                let factor = b.constant(dice.of(&[3, 0x101]));
                b.compute(Op::MulU32, &[number, factor])
            }
            _ => {
                let array = dice.roll(3) as u32;
                let place = self.element(b, dice, width, array);
                let number = load(b, place, width);
                let more = b.constant(dice.of(&[1, 5]));
                b.compute(if width == Width::Word { Op::AddU16 } else { Op::AddU32 }, &[number, more])
            }
        };
        if dice.roll(3) == 0 {
            let sum = load(b, at(SUM), Width::DoubleWord);
            let sum = b.compute(Op::AddU32, &[sum, value]);
            b.store(at(SUM), Width::DoubleWord, sum);
            return;
        }
        let array = if dice.roll(4) == 0 { dice.roll(3) as u32 } else { 2 };
        let place = self.element(b, dice, width, array);
        b.store(place, width, value);
    }

    /// Counts, and decides about another iteration.
    fn again(&self, b: &mut Builder, dice: &mut Dice, head: Target, (up, limit): (bool, u64)) {
        b.begin_statement();
        let value = load(b, at(COUNTER), self.ty.width);
        let step = dice.of(&[1, 1, 1, 2, 3]);
        let adds = if dice.roll(4) == 0 { !up } else { up };
        let step = b.constant(if adds == up { step } else { step.wrapping_neg() & self.ty.most });
        let next = b.compute(self.ty.operations[usize::from(!adds)], &[value, step]);
        b.store(at(COUNTER), self.ty.width, next);
        let limit = match dice.roll(6) {
            0 => load(b, at(LIMIT), Width::Word),
            1 => load(b, at(LIMIT), Width::DoubleWord),
            2 => load(b, at(BEYOND), Width::QuadWord),
            _ => b.constant(limit),
        };
        let op = if up { dice.of(&[Op::LeU64, Op::Below]) } else { dice.of(&[Op::GeU64, Op::GtU64]) };
        let compared = if dice.roll(12) == 0 { value } else { next };
        let condition = b.compute(op, &[compared, limit]);
        b.push(Inst::Branch { condition, to: head });
    }
}

fn loops(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    open_data_block(b);
    for _ in 0..1 + dice.roll(2) {
        let ty = &TYPES[dice.roll(2) as usize];
        let up = dice.roll(3) != 0;
        let iterations = dice.of(&[0, 1, 7, 8, 33, 63, 90]);
        let from_end = dice.roll(4) == 0;
        let first = match (up, from_end) {
            (true, false) => dice.of(&[0, 0, 1, 5]),
            (true, true) => ty.most - iterations - dice.of(&[0, 1, 3]),
            (false, false) => iterations + dice.of(&[0, 1, 3]),
            (false, true) => ty.most,
        };
        let limit = if up { (first + iterations).min(ty.most) } else { first.saturating_sub(iterations) };
        let (least, _) = if up { (first, limit) } else { (limit, first) };
        let it = Loop { ty, low: if least > 100 { least } else { 0 } };
        b.begin_statement();
        let begin = b.constant(first);
        b.store(at(COUNTER), ty.width, begin);
        let begin = b.constant(dice.of(&[0, 3, 20, 0xFFFF, 0xFFF0]));
        b.store(at(BESIDE), Width::Word, begin);
        let head = b.next();
        for _ in 0..1 + dice.roll(3) {
            it.statement(b, dice);
        }
        it.again(b, dice, head, (up, limit));
    }
    b.begin_statement();
    b.push(Inst::Return);
}

fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    // Who is told of what is noted changes nothing.
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 3, 40, 100, 1000, 100_000]);
    if dice.roll(8) == 0 {
        let start = machine.memory.layout.bit_memory.start + dice.of(&[COUNTER, SUM, LIMIT]) as usize;
        machine.memory.arena[start + dice.roll(4) as usize] = dice.of(&[0, 0, 1, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn loops_that_count_without_sign_do_the_same_on_all_engines() {
    let mut ended = 0;
    for seed in seeds(PROGRAMS) {
        let body = |b: &mut Builder| loops(b, &mut Dice(seed));
        let program = program(&[(BlockId::ob(1), 8, &body)]);
        let layout = layout_with(&program, DATA_BYTES);
        let engines = engines(&program, &layout);
        for memory in 0..4 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(11 * seed + memory);
                machine.budget = dice.of(&[1, 5, 50, 1000, 1000, 100_000]);
                let layout = machine.memory.layout.clone();
                let data = layout.data_blocks[&1].clone();
                machine.memory.arena[data].fill_with(|| dice.roll(256) as u8);
                let mut write = |at: u32, number: u64| {
                    let start = layout.bit_memory.start + at as usize;
                    machine.memory.arena[start..start + 8].copy_from_slice(&number.to_be_bytes());
                };
                write(LIMIT, dice.of(&[0x0000_0020_0000_0000, 0x0000_0028, 0x0010_0040_0000_0000, 0x40 << 48, u64::MAX]));
                write(BEYOND, dice.of(&[40, 64, 0x1_0000_0020, 0xFFFF_FFFF, u64::MAX]));
            };
            let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
            let outcome =
                |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(3 * seed + memory), &meddle);
            let what = || format!("program {seed}, memory {memory}\n{}", program.code[&BlockId::ob(1)].code);
            let outcome = all_engines_agree(&engines, true, &outcome, &what);
            ended += usize::from(outcome.asked.len() < QUESTIONS_MAX);
        }
    }
    assert!(ended > 300, "only {ended} runs came to their end");
}

/// Opens data block 1.
fn open_data_block(b: &mut Builder) {
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
}

#[test]
fn a_number_that_is_counted_beside_the_counter_iterations_over() {
    let body = |b: &mut Builder| {
        b.begin_statement();
        open_data_block(b);
        let first = b.constant(0);
        b.store(at(COUNTER), Width::Word, first);
        let first = b.constant(0xFFF0);
        b.store(at(BESIDE), Width::Word, first);
        let head = b.next();
        b.begin_statement();
        let (beside, low) = (load(b, at(BESIDE), Width::Word), b.constant(0xFFF0));
        let number = b.compute(Op::SubU32, &[beside, low]);
        let (shift, first) = (b.constant(5), b.constant(0x8400_0000));
        let offset = b.compute(Op::Shl32, &[number, shift]);
        let pointer = b.compute(Op::AddU32, &[first, offset]);
        let value = b.constant(7);
        b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, Width::DoubleWord, value);
        for (number, limit) in [(BESIDE, None), (COUNTER, Some(40))] {
            b.begin_statement();
            let (value, one) = (load(b, at(number), Width::Word), b.constant(1));
            let next = b.compute(Op::AddU16, &[value, one]);
            b.store(at(number), Width::Word, next);
            if let Some(limit) = limit {
                let limit = b.constant(limit);
                let condition = b.compute(Op::Below, &[next, limit]);
                b.push(Inst::Branch { condition, to: head });
            }
        }
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), 8, &body)]);
    let layout = layout_with(&program, DATA_BYTES);
    let prepare = |machine: &mut Machine| machine.budget = 100_000;
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let answer = |machine: &mut Machine, _: &str, _: usize| {
        machine.budget = 100_000;
        Reaction::Continue
    };
    let outcome = |engine: Arc<dyn Engine>| run(engine.as_ref(), &layout, &entry, &prepare, &answer);
    let ended = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| String::from("a number beside the counter"));
    assert_eq!(ended.asked.len(), 24, "iterations outside of the array");
}
