//! Turns of a loop that branch on a bit and a number that is not the greatest or least one, as counters do, or on two comparisons one of
//! which is that a number is below 0, as timers do: whatever is looked at first, memory is as the interpreter leaves it.

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Layout, Machine, Program};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_from, count_on, fixed, get, layout_with, program};

const PROGRAMS: u64 = 600;
const MEMORIES: u64 = 4;
/// Bytes of a record, and records.
const RECORD: u32 = 20;
const RECORDS: u32 = 6;
/// In bit memory: the number of the record, and bits that a turn hands to the next one.
const COUNTER: u32 = 0;
const HANDED: u32 = 8 * 4;

fn records(program: &Program) -> Layout {
    layout_with(program, (RECORD * RECORDS) as usize)
}

/// A place in the record of the turn.
fn at(b: &mut Builder, position: u32) -> Place {
    let counter = get(b, COUNTER, Width::Word);
    let bits = b.constant(u64::from(8 * RECORD));
    let pointer = b.compute(Op::MulU32, &[counter, bits]);
    Place::Indirect { area: Area::SharedData, pointer, offset: position }
}

fn load(b: &mut Builder, position: u32, width: Width) -> Var {
    let place = at(b, position);
    b.load(place, width, OnFault::SkipStatement)
}

fn store(b: &mut Builder, position: u32, width: Width, value: Var) {
    let place = at(b, position);
    b.store(place, width, value);
}

fn handed(bit: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: HANDED + bit }
}

/// The places of numbers, behind a byte with bits.
fn number(dice: &mut Dice) -> u32 {
    8 * (2 + 4 * dice.roll(4) as u32)
}

fn some_bit(b: &mut Builder, dice: &mut Dice) -> Var {
    let bit = dice.roll(8) as u32;
    let bits = if dice.roll(3) == 0 { b.load(handed(bit), Width::Bit, OnFault::SkipStatement) } else { load(b, bit, Width::Bit) };
    match dice.roll(3) {
        0 => {
            let other = load(b, dice.roll(8) as u32, Width::Bit);
            b.compute(dice.of(&[Op::And, Op::AndNot, Op::Or, Op::Xor]), &[bits, other])
        }
        _ => bits,
    }
}

/// `bit AND number < 32767` and the like, with the number.
fn counts(b: &mut Builder, dice: &mut Dice, place: u32, width: Width) -> Var {
    let bit = some_bit(b, dice);
    let number = load(b, place, width);
    let [greatest, least] = if width == Width::Word { [0x7FFF, 0x8000] } else { [0x7FFF_FFFF, 0x8000_0000] };
    let (narrow, wide, limit) = match dice.roll(5) {
        0 | 1 => (Op::LtI16, Op::LtI32, greatest),
        2 | 3 => (Op::GtI16, Op::GtI32, least),
        _ => (Op::NeI16, Op::NeI32, dice.of(&[greatest, least])),
    };
    let limit = b.constant(if dice.roll(8) == 0 { limit ^ 1 } else { limit });
    let comparison = b.compute(if width == Width::Word { narrow } else { wide }, &[number, limit]);
    let operands = if dice.roll(2) == 0 { [bit, comparison] } else { [comparison, bit] };
    b.compute(if dice.roll(8) == 0 { Op::Or } else { Op::And }, &operands)
}

/// `number >= limit OR number < 0` and the like.
fn ends(b: &mut Builder, dice: &mut Dice, place: u32) -> Var {
    let (number, zero) = (load(b, place, Width::DoubleWord), b.constant(0));
    let limit = match dice.roll(3) {
        0 => b.constant(dice.of(&[0, 1, 3, 0x100, 0xFFFF_FFFF])),
        _ => load(b, self::number(dice), Width::DoubleWord),
    };
    let first = b.compute(dice.of(&[Op::GeI32, Op::GtI32, Op::EqI32, Op::LtI32]), &[number, limit]);
    let below = b.compute(Op::LtI32, &[number, zero]);
    let operands = if dice.roll(2) == 0 { [first, below] } else { [below, first] };
    b.compute(if dice.roll(8) == 0 { Op::And } else { Op::Or }, &operands)
}

fn some_turns(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    b.begin_statement();
    let one = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number: one });
    b.begin_statement();
    let zero = b.constant(0);
    b.store(fixed(COUNTER), Width::Word, zero);
    let first = b.next();
    let branches = 1 + dice.roll(5) as u32;
    for _ in 0..branches {
        let width = dice.of(&[Width::Word, Width::DoubleWord]);
        let place = number(&mut dice);
        b.begin_statement();
        let condition = if dice.roll(2) == 0 { counts(b, &mut dice, place, width) } else { ends(b, &mut dice, place) };
        let condition = if dice.roll(4) == 0 { condition } else { b.compute(Op::Not, &[condition]) };
        // Past statements that count, write bits, and branch themselves.
        let statements = 1 + dice.roll(4) as u32;
        let behind = b.here().0 + 1 + statements;
        b.push(Inst::Branch { condition, to: Target(behind) });
        for _ in 0..statements {
            b.begin_statement();
            match dice.roll(4) {
                0 => {
                    let (old, step) = (load(b, place, width), b.constant(dice.of(&[1, 0xFFFF_FFFF])));
                    let value = b.compute(if width == Width::Word { Op::AddU16 } else { Op::AddU32 }, &[old, step]);
                    store(b, place, width, value);
                }
                1 => {
                    let value = some_bit(b, &mut dice);
                    b.store(handed(dice.roll(8) as u32), Width::Bit, value);
                }
                2 => {
                    let value = some_bit(b, &mut dice);
                    store(b, dice.roll(8) as u32, Width::Bit, value);
                }
                _ => {
                    let condition = some_bit(b, &mut dice);
                    b.push(Inst::Branch { condition, to: Target(behind) });
                }
            }
        }
    }
    count_on(b, fixed(COUNTER), (Op::LtI16, u64::from(RECORDS)), first);
}

#[test]
fn conditions_are_those_of_the_interpreter() {
    for seed in seeds(PROGRAMS) {
        let program = program(&[(BlockId::ob(1), 0, &|b| some_turns(b, seed))]);
        let layout = records(&program);
        let prepare = |machine: &mut Machine, memory: u64| {
            let mut dice = Dice(seed + 1_000_000 * (memory + 1));
            machine.budget = 1000;
            let records = machine.memory.layout.data_blocks[&1].clone();
            for record in machine.memory.arena[records].chunks_mut(RECORD as usize) {
                record[..2].fill_with(|| dice.roll(256) as u8);
                for number in record[2..].chunks_mut(4) {
                    // Many numbers are the greatest or the least one, of either width, or near 0.
                    let bytes = match dice.roll(3) {
                        0 => dice.of(&[0x7FFF_FFFF, 0x8000_0000, 0x8000_7FFF, 0x7FFF_8000, u32::MAX]),
                        1 => dice.roll(4) as u32,
                        _ => dice.roll(1 << 32) as u32,
                    };
                    let length = number.len();
                    number.copy_from_slice(&bytes.to_be_bytes()[..length]);
                }
            }
            machine.memory.area_mut(Area::BitMemory)[4] = dice.roll(256) as u8;
        };
        all_engines_agree_from((&program, &layout), MEMORIES, &prepare, &seed.to_string());
    }
}

#[test]
fn a_counter_that_does_not_count_does_not_look_at_its_limit() {
    let program = program(&[(BlockId::ob(1), 0, &|b| {
        b.begin_statement();
        let one = b.constant(1);
        b.push(Inst::Open { register: DataRegister::Shared, number: one });
        b.begin_statement();
        let zero = b.constant(0);
        b.store(fixed(COUNTER), Width::Word, zero);
        let first = b.next();
        b.begin_statement();
        let bit = load(b, 0, Width::Bit);
        let (number, limit) = (load(b, 16, Width::Word), b.constant(0x7FFF));
        let less = b.compute(Op::LtI16, &[number, limit]);
        let both = b.compute(Op::And, &[bit, less]);
        let stays = b.compute(Op::Not, &[both]);
        let behind = b.here().0 + 3;
        b.push(Inst::Branch { condition: stays, to: Target(behind) });
        b.begin_statement();
        let (old, one) = (load(b, 16, Width::Word), b.constant(1));
        let next = b.compute(Op::AddU16, &[old, one]);
        store(b, 16, Width::Word, next);
        b.begin_statement();
        let (bit, handed_on) = (load(b, 0, Width::Bit), handed(0));
        b.store(handed_on, Width::Bit, bit);
        count_on(b, fixed(COUNTER), (Op::LtI16, u64::from(RECORDS)), first);
    })]);
    let listing = Jit::listing(&program, &records(&program)).expect("machine code");
    let sets = listing.lines().filter(|line| line.trim_start().starts_with("setl")).count();
    assert_eq!(sets, 0, "the comparison with the limit is a branch");
}
