//! Fields of elements of arrays, some of them bits that share a byte: those of one element are counted from one address, whatever other
//! elements are written between and whoever changes memory, the code does what the interpreter does.

use std::cell::RefCell;

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, engines, layout_with, program};

const PROGRAMS: u64 = 500;
const QUESTIONS_MAX: usize = 30;
const DATA_BYTES: usize = 200;
/// Where indexes lie in bit memory, in bytes; the first one counts.
const INDEXES: [u32; 3] = [200, 204, 208];
/// Bytes of an element. An index that does not count is masked, so that it is known to be inside.
const ELEMENT: u64 = 8;
const MASK: u64 = 15;
/// Fields: where they lie, in bits. The last ones lie in the next element.
const FIELDS: &[(u32, Width)] = &[
    (0, Width::Bit),
    (1, Width::Bit),
    (2, Width::Bit),
    (9, Width::Bit),
    (0, Width::Byte),
    (8, Width::Word),
    (16, Width::Word),
    (32, Width::DoubleWord),
    (64, Width::Bit),
    (80, Width::Word),
];

/// Where a pointer is kept from one statement to others.
const KEPT: Place = Place::Fixed { area: Area::Local, position: 64 };

fn index(number: usize) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * INDEXES[number] }
}

fn field(b: &mut Builder, number: usize, offset: u32) -> Place {
    let counter = b.load(index(number), Width::Word, OnFault::SkipStatement);
    let wide = b.compute(Op::Extend16, &[counter]);
    let mask = b.constant(MASK);
    // The range of the counter is known.
    let inside = if number == 0 { wide } else { b.compute(Op::AndU32, &[wide, mask]) };
    let bits = b.constant(8 * ELEMENT);
    let pointer = b.compute(Op::MulU32, &[inside, bits]);
    Place::Indirect { area: Area::SharedData, pointer, offset }
}

/// `REPEAT … UNTIL i > last`, with a jump table in it, so that the iterations are not done at once.
fn looping(b: &mut Builder, last: u64, statements: u32, write: &mut dyn FnMut(&mut Builder, u32)) {
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    b.begin_statement();
    let zero = b.constant(0);
    b.store(index(0), Width::Word, zero);
    for statement in 0..statements {
        b.begin_statement();
        write(b, 2 + statement);
    }
    b.begin_statement();
    let counter = b.load(index(0), Width::Word, OnFault::SkipStatement);
    let behind = 3 + statements;
    let first = b.table(&[Target(behind), Target(behind)]);
    b.push(Inst::JumpTable { index: counter, first, count: 2, otherwise: Target(behind) });
    b.begin_statement();
    let counter = b.load(index(0), Width::Word, OnFault::SkipStatement);
    let one = b.constant(1);
    let next = b.compute(Op::AddU16, &[counter, one]);
    b.store(index(0), Width::Word, next);
    let last = b.constant(last);
    let again = b.compute(Op::LeI16, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(2) });
    b.begin_statement();
    b.push(Inst::Return);
}

/// How often bytes are stored by a loop that writes bits of elements: by which index, and where.
fn stores(written: &[(usize, u32)]) -> usize {
    let mut write = |b: &mut Builder, statement: u32| {
        let (number, offset) = written[statement as usize - 2];
        let place = field(b, number, offset);
        let value = b.load(Place::Fixed { area: Area::BitMemory, position: 800 + statement }, Width::Bit, OnFault::SkipStatement);
        b.store(place, Width::Bit, value);
    };
    let write = RefCell::new(&mut write);
    let build = |b: &mut Builder| looping(b, 12, written.len() as u32, *write.borrow_mut());
    let program = program(&[(BlockId::ob(1), 16, &build)]);
    let listing = Jit::listing(&program, &layout_with(&program, DATA_BYTES)).expect("machine code");
    listing.matches("istore8").count()
}

#[test]
fn bits_of_one_byte_of_an_element_are_written_together() {
    assert_eq!(stores(&[(0, 0)]), 1);
    assert_eq!(stores(&[(0, 0), (0, 1), (0, 2)]), 1);
    assert_eq!(stores(&[(0, 0), (0, 9), (0, 1)]), 2);
}

#[test]
fn bits_of_other_elements_are_written_where_the_program_writes_them() {
    // Each may be the same bit as the one before.
    assert_eq!(stores(&[(0, 0), (1, 0), (0, 1)]), 3);
}

#[test]
fn an_element_at_a_known_index_is_a_variable_like_others() {
    let build = |b: &mut Builder| {
        looping(b, 12, 1, &mut |b, _| {
            let (three, bits) = (b.constant(3), b.constant(8 * ELEMENT));
            let pointer = b.compute(Op::MulU32, &[three, bits]);
            let place = Place::Indirect { area: Area::SharedData, pointer, offset: 16 };
            let value = b.load(place, Width::Word, OnFault::SkipStatement);
            let counter = b.load(index(0), Width::Word, OnFault::SkipStatement);
            let sum = b.compute(Op::AddU16, &[value, counter]);
            b.store(place, Width::Word, sum);
        });
    };
    let program = program(&[(BlockId::ob(1), 16, &build)]);
    let listing = Jit::listing(&program, &layout_with(&program, DATA_BYTES)).expect("machine code");
    // Both are kept in registers: an iteration begins with the jump table behind the sum, and touches no memory.
    let iteration = listing.split("\nblock").find(|block| block.contains("br_table")).expect("an iteration");
    assert!(!iteration.contains("load") && !iteration.contains("store"), "{iteration}");
}

/// How often a loop masks the position of a pointer to an element that one of its statements keeps in local data for the next one, or that
/// the next one computes again.
fn masks(kept: bool) -> usize {
    let build = |b: &mut Builder| {
        looping(b, 12, 2, &mut |b, statement| {
            let Place::Indirect { pointer, .. } = field(b, 0, 0) else { return };
            // The area in a pointer is left aside.
            let area = b.constant(0x8400_0000);
            let mut pointer = b.compute(Op::AddU32, &[pointer, area]);
            if kept && statement == 2 {
                return b.store(KEPT, Width::DoubleWord, pointer);
            }
            if kept {
                pointer = b.load(KEPT, Width::DoubleWord, OnFault::SkipStatement);
            }
            let place = Place::Indirect { area: Area::SharedData, pointer, offset: 16 };
            let value = b.load(index(1), Width::Word, OnFault::SkipStatement);
            b.store(place, Width::Word, value);
        });
    };
    let program = program(&[(BlockId::ob(1), 16, &build)]);
    Jit::listing(&program, &layout_with(&program, DATA_BYTES)).expect("machine code").matches("0x00ff_ffff").count()
}

#[test]
fn a_pointer_that_one_statement_keeps_for_the_next_is_as_good_as_one_that_is_computed_there() {
    assert_eq!((masks(true), masks(false)), (0, 0));
}

/// Some statement of an iteration.
fn some_statement(b: &mut Builder, dice: &mut Dice, statement: u32, statements: u32) {
    let place = |b: &mut Builder, dice: &mut Dice| {
        let number = dice.of(&[0, 0, 0, 1, 2]);
        let (offset, width) = dice.of(FIELDS);
        if dice.roll(6) == 0 {
            let pointer = b.load(KEPT, Width::DoubleWord, OnFault::SkipStatement);
            return (Place::Indirect { area: Area::SharedData, pointer, offset }, width);
        }
        (field(b, number, offset), width)
    };
    let (from, width) = place(b, dice);
    let mut value: Var = b.load(from, width, OnFault::SkipStatement);
    if dice.roll(3) == 0 {
        let (from, width) = place(b, dice);
        let other = b.load(from, width, OnFault::SkipStatement);
        value = b.compute(dice.of(&[Op::XorU32, Op::AddU32, Op::AndU32]), &[value, other]);
    }
    match dice.roll(7) {
        6 => {
            let number = dice.of(&[0, 0, 1]);
            if let Place::Indirect { pointer, .. } = field(b, number, 0) {
                b.store(KEPT, Width::DoubleWord, pointer);
            }
        }
        0 => {
            let condition = b.compute(Op::IsNonzero, &[value]);
            let to = statement + 1 + dice.roll(u64::from(2 + statements - statement)) as u32;
            b.push(Inst::Branch { condition, to: Target(to) });
        }
        1 => b.store(index(1), Width::Word, value),
        _ => {
            let (to, width) = place(b, dice);
            let value = if width == Width::Bit { b.compute(Op::IsNonzero, &[value]) } else { value };
            b.store(to, width, value);
        }
    }
}

fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 1, 2, 3, 8]);
    match dice.roll(3) {
        0 => machine.memory.area_mut(Area::BitMemory)[dice.of(&INDEXES) as usize + 1] = dice.roll(16) as u8,
        1 => {
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range.start + dice.roll(140) as usize] = dice.roll(256) as u8;
        }
        _ => {}
    }
    Reaction::Continue
}

#[test]
fn fields_of_elements_are_what_the_interpreter_makes_of_them() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let build = |b: &mut Builder| {
            let mut dice = Dice(seed);
            let (last, statements) = (dice.of(&[0, 7, 15, 20]), 2 + dice.roll(7) as u32);
            looping(b, last, statements, &mut |b, statement| some_statement(b, &mut dice, statement, statements));
        };
        let program = program(&[(block, 16, &build)]);
        let layout = layout_with(&program, DATA_BYTES);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 1, 2, 5, 20, 1000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            INDEXES.iter().for_each(|&at| machine.memory.area_mut(Area::BitMemory)[at as usize + 1] = dice.roll(16) as u8);
        };
        let dice = || Dice(seed + 2_000_000);
        let expected = all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &seed.to_string());
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 500 && finished > 200, "{asked} questions, {finished} runs to the end");
}
