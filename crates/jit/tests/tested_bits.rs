//! Bits of numbers that programs take out with AND and a comparison, or by their number, and write to bits one behind the other: the word
//! that a bit network works with. Wherever they are taken from and go to, memory is as the interpreter leaves it.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_from, layout, program};

const PROGRAMS: u64 = 400;
const MEMORIES: u64 = 4;
/// Where numbers, bits and sums lie in bit memory, in bytes.
const NUMBERS: &[u32] = &[0, 4, 8];
const BITS: u32 = 40;
const SUMS: &[u32] = &[60, 64];

fn at(byte: u32) -> Place {
    bit_at(8 * byte)
}

fn bit_at(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

/// `(number AND mask) <> other`, or `=`, or the other way round.
fn tested(b: &mut Builder, number: Var, mask: u64, (op, other): (Op, u64)) -> Var {
    let (mask, other) = (b.constant(mask), b.constant(other));
    let bits = b.compute(Op::AndU32, &[number, mask]);
    b.compute(op, &[bits, other])
}

/// A bit of a number, or something that looks like one.
fn some_test(b: &mut Builder, dice: &mut Dice, number: u32, bit: u32) -> Var {
    if dice.roll(4) == 0 {
        let width = dice.of(&[Width::DoubleWord, Width::QuadWord]);
        let number = b.load(at(number), width, OnFault::SkipStatement);
        let bit = b.constant(u64::from(bit) + dice.of(&[0, 0, 32, 64]));
        return b.compute(Op::BitOf, &[number, bit]);
    }
    let number = b.load(at(number), Width::DoubleWord, OnFault::SkipStatement);
    let mask = match dice.roll(8) {
        0 => 3 << bit & 0xFFFF_FFFF,
        1 => 0,
        _ => 1 << bit,
    };
    let other = match dice.roll(8) {
        0 => 1,
        1 => 1 << ((bit + 1) % 32),
        2..=4 => mask,
        _ => 0,
    };
    let op = dice.of(&[Op::Differ, Op::Differ, Op::Equal]);
    tested(b, number, mask, (op, other))
}

fn some_statements(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let (mut number, mut bit, mut to) = (dice.of(NUMBERS), dice.roll(32) as u32, 8 * BITS + dice.roll(40) as u32);
    for statement in 0..6 + dice.roll(30) as u32 {
        b.begin_statement();
        // Mostly the next bit of the same number to the next one of the same word.
        match dice.roll(8) {
            0 => (number, bit) = (dice.of(NUMBERS), dice.roll(32) as u32),
            1 => to = 8 * BITS + dice.roll(64) as u32,
            2 => {}
            _ => (bit, to) = ((bit + 1) % 32, to + 1),
        }
        let mut value = some_test(b, &mut dice, number, bit);
        if dice.roll(4) == 0 {
            let other = b.load(bit_at(8 * BITS + dice.roll(64) as u32), Width::Bit, OnFault::SkipStatement);
            value = b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[value, other]);
        }
        match dice.roll(12) {
            0 => value = b.compute(Op::Not, &[value]),
            1 => {
                let sum = at(dice.of(SUMS));
                let old = b.load(sum, Width::DoubleWord, OnFault::SkipStatement);
                let new = b.compute(Op::AddU32, &[old, value]);
                b.store(sum, Width::DoubleWord, new);
            }
            2 => {
                let sum = at(dice.of(SUMS));
                let old = b.load(sum, Width::DoubleWord, OnFault::SkipStatement);
                let (seven, number) = (b.constant(7), at(number));
                let new = b.compute(Op::AddU32, &[old, seven]);
                let chosen = b.compute(Op::Select, &[value, new, old]);
                b.store(dice.of(&[sum, number]), Width::DoubleWord, chosen);
            }
            3 | 4 => {
                let sum = at(dice.of(SUMS));
                let old = b.load(sum, Width::DoubleWord, OnFault::SkipStatement);
                let weight = b.constant(dice.of(&[1, 2, 16, 0x8000, 0x1_0000, 0x8000_0000, 0, 3]));
                let operands = if dice.roll(2) == 0 { [value, weight] } else { [weight, value] };
                let weighted = b.compute(dice.of(&[Op::MulU32, Op::MulU32, Op::MulU16, Op::MulU64]), &operands);
                let new = b.compute(Op::AddU32, &[old, weighted]);
                b.store(sum, Width::DoubleWord, new);
            }
            // Past the bit.
            5 => b.push(Inst::Branch { condition: value, to: Target(statement + 1) }),
            _ => {}
        }
        b.store(bit_at(to), Width::Bit, value);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn tested_bits_are_those_of_the_interpreter() {
    let mut silent = 0;
    for seed in seeds(PROGRAMS) {
        let program = program(&[(BlockId::ob(1), 0, &|b| some_statements(b, seed))]);
        let layout = layout(&program);
        let prepare = |machine: &mut sieben_engine::Machine, memory: u64| {
            let mut dice = Dice(seed + 1_000_000 * (memory + 1));
            machine.budget = 1000;
            machine.memory.area_mut(Area::BitMemory)[..80].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        silent += all_engines_agree_from((&program, &layout), MEMORIES, &prepare, &seed.to_string());
    }
    assert_eq!(silent, seeds(PROGRAMS).count() as u64 * MEMORIES);
}

/// How often the code of 32 tests turns a number, compares and masks.
fn counts(test: &dyn Fn(&mut Builder, Var, u32) -> Var) -> [usize; 3] {
    let program = program(&[(BlockId::ob(1), 0, &|b| {
        for bit in 0..32 {
            b.begin_statement();
            let number = b.load(at(NUMBERS[0]), Width::DoubleWord, OnFault::SkipStatement);
            let value = test(b, number, bit);
            b.store(bit_at(8 * BITS + bit), Width::Bit, value);
        }
        b.begin_statement();
        b.push(Inst::Return);
    })]);
    let listing = Jit::listing(&program, &layout(&program)).expect("machine code");
    ["rorx", "sete", "and"].map(|op| listing.lines().filter(|line| line.trim_start().starts_with(op)).count())
}

#[test]
fn bits_of_one_number_are_taken_together() {
    for op in [Op::Differ, Op::Equal] {
        // No comparison, and all bits at once.
        let [turned, compared, masked] = counts(&|b, number, bit| {
            let other = if op == Op::Differ { 0 } else { 1 << bit };
            tested(b, number, 1 << bit, (op, other))
        });
        assert_eq!((turned, compared), (0, 0), "{op:?}");
        assert!(masked <= 4, "{op:?}: {masked}");
    }
}
