//! Arrays of any length: functions that are handed bounds and a pointer, keep an index in 64 bits from one statement to another, and look
//! whether it is inside. Whatever the bounds are, wherever the array lies and whoever changes memory, machine code does what the
//! interpreter does.

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, count_on, engines, layout_with, program};

const PROGRAMS: u64 = 500;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// In the local data of the caller: the bounds, a number, the pointer, its counter.
const HANDED: [u32; 3] = [0, 32, 64];
const ARRAY: u32 = 8 * 12;
const COUNTER: u32 = 8 * 18;
const ELEMENTS: u32 = 8 * 20;
/// In that of the function: what it took of it, the running index.
const TAKEN: [u32; 3] = [0, 32, 64];
const INDEX: u32 = 8 * 12;
const LOCAL_BYTES: u32 = 64;
/// The index in 64 bits, kept twice, in local data or in bit memory.
const KEPT: [u32; 2] = [8 * 16, 8 * 24];
const DATA_BYTES: usize = 160;
/// Bits of an element, and how it is read.
const KINDS: [(u64, Width); 4] = [(1, Width::Bit), (8, Width::Byte), (16, Width::Word), (32, Width::DoubleWord)];

fn local(position: u32) -> Place {
    Place::Fixed { area: Area::Local, position }
}

fn memory(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

/// A number of the function in 64 bits.
fn wide(b: &mut Builder, position: u32) -> Var {
    let number = load(b, local(position), Width::DoubleWord);
    b.compute(Op::ExtendI32I64, &[number])
}

/// The number of an element from the first one on, or one that is none; whether it counts.
fn element(b: &mut Builder, dice: &mut Dice, kept: [Place; 2], bits: u64, wrong: Option<bool>) -> (Var, Var) {
    let (index, low, high) = (load(b, kept[0], Width::QuadWord), wide(b, TAKEN[0]), wide(b, TAKEN[1]));
    let above = b.compute(Op::GeI64, &[index, low]);
    let below = b.compute(Op::LeI64, &[index, high]);
    let inside = b.compute(Op::And, &[above, below]);
    let number = b.compute(Op::SubU64, &[index, low]);
    let number = if wrong == Some(true) {
        number
    } else {
        let (mask, outside) = (b.constant(0xFFFF), b.constant(0x4000_0000));
        let masked = b.compute(Op::AndU64, &[index, mask]);
        let none = b.compute(Op::OrU64, &[masked, outside]);
        b.compute(Op::Select, &[inside, number, none])
    };
    b.store(kept[1], Width::QuadWord, number);
    let number = load(b, kept[1], Width::QuadWord);
    let low = b.compute(Op::Low32, &[number]);
    let limit = b.constant(dice.of(&[(1 << 20) / bits, (1 << 20) / bits, 5]));
    let fits = b.compute(Op::Below, &[low, limit]);
    let overflows = b.compute(Op::OverflowsI32, &[number]);
    let counts = match dice.roll(12) {
        0 => b.compute(Op::And, &[fits, inside]),
        1 => b.compute(Op::And, &[inside, fits]),
        2 => b.compute(Op::Or, &[fits, inside]),
        3 => b.compute(Op::AndNot, &[inside, fits]),
        4 => b.compute(Op::Not, &[fits]),
        5 => {
            let other = b.compute(Op::Low32, &[index]);
            let (five, less) = (b.constant(5), b.constant(dice.of(&[1, 100, 100])));
            let other = b.compute(Op::SubU32, &[other, less]);
            b.compute(Op::Below, &[other, five])
        }
        _ => b.compute(Op::AndNot, &[fits, overflows]),
    };
    (b.compute(Op::Gate, &[low, counts]), counts)
}

/// The place of an element.
fn place(b: &mut Builder, dice: &mut Dice, kept: [Place; 2], bits: u64, wrong: Option<bool>) -> (Place, Var) {
    let (number, counts) = element(b, dice, kept, bits, wrong);
    if wrong.is_none() {
        b.push(Inst::Require { condition: counts, code: 35, register: number });
    }
    let step = b.constant(bits);
    let moved = b.compute(Op::MulU32, &[number, step]);
    let parameter = b.temporary();
    b.push(Inst::Parameter { dst: parameter, index: 3 });
    let number = load(b, Place::Crossing { pointer: parameter, offset: 0 }, Width::Word);
    let pointer = load(b, Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord);
    let pointer = b.compute(Op::AddU32, &[pointer, moved]);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    (Place::Crossing { pointer, offset: 0 }, counts)
}

fn function(b: &mut Builder, dice: &mut Dice, (bits, width): (u64, Width)) {
    b.begin_statement();
    for (index, position) in (0..).zip(TAKEN) {
        let parameter = b.temporary();
        b.push(Inst::Parameter { dst: parameter, index });
        let number = load(b, Place::Crossing { pointer: parameter, offset: 0 }, Width::DoubleWord);
        b.store(local(position), Width::DoubleWord, number);
    }
    b.begin_statement();
    let low = load(b, local(TAKEN[0]), Width::DoubleWord);
    let by = if dice.roll(3) == 0 { load(b, local(TAKEN[2]), Width::DoubleWord) } else { b.constant(dice.of(&[0, 0, 1, 0xFFFF_FFFF])) };
    let first = b.compute(Op::AddU32, &[low, by]);
    b.store(local(INDEX), Width::DoubleWord, first);
    let kept = if dice.roll(3) == 0 { KEPT.map(memory) } else { KEPT.map(local) };
    // Mostly nobody is told of an index that does not count, and sometimes it is taken for a number that does.
    let wrong = dice.of(&[None, None, Some(false), Some(false), Some(false), Some(true)]);
    b.begin_statement();
    let index = match dice.roll(4) {
        0 => {
            // Without sign.
            let (index, mask) = (load(b, local(INDEX), Width::DoubleWord), b.constant(0xF));
            b.compute(Op::AndU32, &[index, mask])
        }
        _ => wide(b, INDEX),
    };
    b.store(kept[0], Width::QuadWord, index);
    if dice.roll(3) == 0 {
        // Somebody is asked here.
        b.begin_statement();
        b.store(Place::Fixed { area: Area::InstanceData, position: 8 * 5000 }, Width::Word, index);
    }
    b.begin_statement();
    let (place, counts) = place(b, dice, kept, bits, wrong);
    let old = b.load(place, width, OnFault::SkipWrite);
    let one = b.constant(1);
    let new = match width {
        _ if dice.roll(2) == 0 => one,
        Width::Bit => b.compute(Op::Not, &[old]),
        Width::Byte => b.compute(Op::AddU8, &[old, one]),
        Width::Word => b.compute(Op::AddU16, &[old, one]),
        _ => b.compute(Op::AddU32, &[old, one]),
    };
    let value = b.compute(Op::Select, &[counts, new, old]);
    b.store(place, width, value);
    b.begin_statement();
    let number = load(b, local(INDEX), Width::DoubleWord);
    let step = if dice.roll(3) == 0 { load(b, local(TAKEN[2]), Width::DoubleWord) } else { b.constant(1) };
    let overflows = b.compute(Op::AddOverflowsI32, &[number, step]);
    let next = b.compute(Op::AddU32, &[number, step]);
    b.store(local(INDEX), Width::DoubleWord, next);
    let last = load(b, local(TAKEN[1]), Width::DoubleWord);
    let reaches = b.compute(dice.of(&[Op::LeI32, Op::LtI32]), &[next, last]);
    let again = b.compute(Op::AndNot, &[reaches, overflows]);
    b.push(Inst::Branch { condition: again, to: Target(2) });
    b.begin_statement();
    b.push(Inst::Return);
}

fn caller(b: &mut Builder, dice: &mut Dice, bits: u64) {
    let last = Place::Fixed { area: Area::InstanceData, position: 8 * (DATA_BYTES as u32 - 2) };
    let counter = dice.of(&[local(COUNTER), memory(8 * 40), last]);
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Instance, number });
    let first = b.constant(0);
    b.store(counter, Width::Word, first);
    b.begin_statement();
    let places = [(1, 0x8400_0000), (1, 0x8400_0000), (1, 0x8400_0400), (0, 0x8700_0000 | u64::from(ELEMENTS)), (0, 0x8300_0100)];
    let bad =
        [(0, 0x8700_0000 | u64::from(ARRAY)), (0, 0x8300_0130), (1, 0x8400_04C0), (1, 0x8400_0800), (9, 0x8400_0000), (0, 0x8700_0080)];
    let (number, pointer) = if dice.roll(3) == 0 { dice.of(&bad) } else { dice.of(&places) };
    let low = dice.of(&[0, 0, 1, -3_i32, 7, i32::MAX - 3, i32::MIN]);
    // Some arrays end where the data block ends.
    let left = (8 * DATA_BYTES as u64).saturating_sub(pointer & 0xFFFF) / bits;
    let last = if dice.roll(2) == 0 { left as i32 - 1 } else { dice.of(&[0, 3, 5, 9, 15, 70, 300, 300, 300]) };
    let high = low.wrapping_add(last);
    for (position, number) in HANDED.into_iter().zip([low, high, dice.of(&[1, 2, 3, -1])]) {
        let number = b.constant(u64::from(number as u32));
        b.store(local(position), Width::DoubleWord, number);
    }
    let (number, pointer) = (b.constant(number), b.constant(pointer));
    b.store(local(ARRAY), Width::Word, number);
    b.store(local(ARRAY + 16), Width::DoubleWord, pointer);
    for position in [HANDED[0], HANDED[1], HANDED[2], ARRAY] {
        let pointer = b.constant(0x8700_0000 | u64::from(position));
        b.push(Inst::PassParameter { src: pointer });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 4 });
    b.begin_statement();
    let number = load(b, counter, Width::Word);
    let shift = b.constant(4);
    let bits = b.compute(Op::Shl32, &[number, shift]);
    b.store(Place::Indirect { area: Area::InstanceData, pointer: bits, offset: 8 * 140 }, Width::Word, number);
    b.begin_statement();
    let limit = dice.of(&[3, 7, 9]);
    count_on(b, counter, (dice.of(&[Op::LtI16, Op::Below]), limit), Target(1));
}

fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 40, 400]);
    for _ in 0..dice.of(&[0, 0, 1, 2]) {
        let layout = machine.memory.layout.clone();
        let kept = (KEPT[0] / 8 + dice.of(&[7, 7, 6, 5, 3, 0])) as usize;
        let byte = match dice.roll(4) {
            0 => layout.data_blocks[&1].start + dice.roll(DATA_BYTES as u64) as usize,
            1 | 2 => layout.bit_memory.start + kept,
            _ => layout.bit_memory.start + dice.of(&[40, 41, 32]),
        };
        machine.memory.arena[byte] = dice.of(&[0, 1, 2, 7, 0x84, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn elements_of_arrays_of_any_length_are_the_same_on_all_engines() {
    let mut asked = 0;
    for seed in seeds(PROGRAMS) {
        let kind = KINDS[(seed % 4) as usize];
        let main = move |b: &mut Builder| caller(b, &mut Dice(seed * 10), kind.0);
        let called = move |b: &mut Builder| function(b, &mut Dice(seed * 10 + 1), kind);
        let program = program(&[(BlockId::ob(1), LOCAL_BYTES, &main), (BlockId::fc(1), LOCAL_BYTES, &called)]);
        let layout = layout_with(&program, DATA_BYTES);
        let prepare = |machine: &mut Machine| machine.budget = Dice(seed + 1_000_000).of(&[5, 40, 400, 4000]);
        let listing: String = program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect();
        let dice = || Dice(seed + 2_000_000);
        asked += all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &format!("{seed}\n{listing}")).asked.len();
    }
    assert!(asked > 200, "{asked} questions");
}
