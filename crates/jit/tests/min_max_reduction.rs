//! Counted loops that keep the least and the greatest numbers of arrays, by comparisons and by MIN and MAX: whatever the numbers are and
//! whatever else looks at what is kept, the loops do on all engines what the interpreter does.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Inst, Op, Target};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Interpreter, Machine, Program, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, counted, element_at, fixed, get, program, run};

const PROGRAMS: u64 = 400;
/// Runs of each program.
const RUNS: u64 = 6;
const QUESTIONS_MAX: usize = 30;
/// Bytes of the array, which lies at the beginning of bit memory, and where the variables lie behind it.
const ARRAY_BYTES: u32 = 400;
const COUNTER: u32 = 600;
const WHERE: u32 = 604;
const SUM: u32 = 608;
const KEPT: [u32; 2] = [616, 624];

/// What is compared: the operations that find the lesser of two numbers, and other ones.
struct Kind {
    width: Width,
    compare: &'static [Op],
    one_of_two: &'static [Op],
    add: Op,
    special: &'static [u64],
}

const HALF: Kind = Kind {
    width: Width::Word,
    compare: &[Op::LtI16, Op::LeI16, Op::GtI16, Op::GeI16],
    one_of_two: &[Op::MinI16, Op::MaxI16],
    add: Op::AddU16,
    special: &[0, 1, 0x7FFF, 0x8000, 0xFFFF],
};
const DOUBLE: Kind = Kind {
    width: Width::DoubleWord,
    compare: &[Op::LtI32, Op::LeI32, Op::GtI32, Op::GeI32],
    one_of_two: &[Op::MinI32, Op::MaxI32],
    add: Op::AddU32,
    special: &[0, 1, 0x7FFF_FFFF, 0x8000_0000, 0xFFFF_FFFF, 0x0000_8000],
};
const REAL: Kind = Kind {
    width: Width::DoubleWord,
    compare: &[Op::LtF32, Op::GtF32, Op::LtF32, Op::GtF32, Op::LeF32, Op::GeF32],
    one_of_two: &[Op::MinF32, Op::MaxF32],
    add: Op::AddF32,
    // Zeros of both signs, infinities, and several that are no number.
    special: &[0, 0x8000_0000, 0x7F80_0000, 0xFF80_0000, 0x7FC0_0000, 0x7F80_0001, 0xFFC1_2345, 1, 0x3F80_0000],
};
const LREAL: Kind = Kind {
    width: Width::QuadWord,
    compare: &[Op::LtF64, Op::GtF64, Op::LtF64, Op::GtF64, Op::LeF64, Op::GeF64],
    one_of_two: &[Op::MinF64, Op::MaxF64],
    add: Op::AddF64,
    special: &[0, 1 << 63, 0x7FF0 << 48, 0xFFF0 << 48, 0x7FF8 << 48, 0x7FF0_0000_0000_0001, 0xFFF8_1234_5678_9ABC, 1, 0x3FF0 << 48],
};
const KINDS: [Kind; 4] = [HALF, DOUBLE, REAL, LREAL];

/// `IF element < kept THEN kept := element; …` and its like, by so many statements: `beside` is written under the same condition.
fn keep_by_comparison(b: &mut Builder, statement: u32, (width, op): (Width, Op), kept: u32, turned: bool, beside: bool) -> u32 {
    let behind = statement + 2 + u32::from(beside);
    b.begin_statement();
    let (value, before) = (element_at(b, COUNTER, width), get(b, kept, width));
    let condition = b.compute(op, &if turned { [before, value] } else { [value, before] });
    let otherwise = b.compute(Op::Not, &[condition]);
    b.push(Inst::Branch { condition: otherwise, to: Target(behind) });
    b.begin_statement();
    let value = element_at(b, COUNTER, width);
    b.store(fixed(kept), width, value);
    if beside {
        b.begin_statement();
        let counter = get(b, COUNTER, Width::DoubleWord);
        b.store(fixed(WHERE), Width::DoubleWord, counter);
    }
    behind
}

/// `kept := MAX(kept, element);`
fn keep_one_of_two(b: &mut Builder, (width, op): (Width, Op), kept: u32, turned: bool) {
    b.begin_statement();
    let (value, before) = (element_at(b, COUNTER, width), get(b, kept, width));
    let value = b.compute(op, &if turned { [before, value] } else { [value, before] });
    b.store(fixed(kept), width, value);
}

/// A loop that keeps one or two numbers.
fn looping(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let Kind { width, compare, one_of_two, add, .. } = KINDS[(seed % 4) as usize];
    let elements = u64::from(ARRAY_BYTES / width.bytes());
    let last = dice.of(&[0, 3, 7, 16, 30, elements - 1]);
    counted(b, COUNTER, last, |b| {
        let mut statement = 1;
        for number in 0..=dice.roll(3) {
            // Both may keep the same, one behind the other.
            let kept = KEPT[if dice.roll(6) == 0 { 0 } else { number as usize % 2 }];
            let turned = dice.roll(2) == 0;
            if dice.roll(3) == 0 {
                keep_one_of_two(b, (width, dice.of(one_of_two)), kept, turned);
                statement += 1;
            } else {
                let beside = dice.roll(6) == 0;
                statement = keep_by_comparison(b, statement, (width, dice.of(compare)), kept, turned, beside);
            }
        }
        // Somebody else looks at what is kept, or writes it.
        let others = dice.roll(6);
        if others < 3 {
            b.begin_statement();
            statement += 1;
            let source = if others == 0 { get(b, KEPT[0], width) } else { element_at(b, COUNTER, width) };
            let sum = get(b, SUM, width);
            let sum = b.compute(add, &[sum, source]);
            b.store(fixed(if dice.roll(8) == 0 { KEPT[1] } else { SUM }), width, sum);
        }
        statement
    });
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 3, 9, 17, 100, 1000, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, KEPT[0], KEPT[0] + 1, KEPT[1], SUM + 2, 0, 6]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 7, 0x7F, 0x80, 0xFF]);
    }
    Reaction::Continue
}

/// Fills the array and the variables with numbers, some of them special.
fn fill(machine: &mut Machine, kind: &Kind, seed: u64) {
    let mut dice = Dice(seed);
    machine.budget = dice.of(&[1, 5, 20, 50, 1000, 100_000]);
    let bytes = kind.width.bytes() as usize;
    let special = dice.roll(3) != 0;
    let mut number = || {
        let value = match dice.roll(4) {
            0 if special => dice.of(kind.special),
            _ if bytes == 2 => dice.roll(1 << 16),
            // REALs between 1 and 4, and their like.
            _ if bytes == 4 => 0x3F80_0000 + dice.roll(1 << 24) + (dice.roll(2) << 31),
            _ => (0x3FF0 << 48) + (dice.roll(1 << 31) << 21) + (dice.roll(2) << 63),
        };
        value.to_be_bytes()[8 - bytes..].to_vec()
    };
    let memory = machine.memory.area_mut(Area::BitMemory);
    for at in (0..ARRAY_BYTES as usize).step_by(bytes).chain([SUM, KEPT[0], KEPT[1]].map(|byte| byte as usize)) {
        memory[at..at + bytes].copy_from_slice(&number());
    }
}

#[test]
fn least_and_greatest_numbers_are_those_of_the_interpreter() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| looping(b, seed))]);
        let layout = noting::layout(&program);
        let engines = [StatusBits::All, StatusBits::Needed].map(|status| Jit::compiled(&program, &layout, status).expect("machine code"));
        let interpreter = Interpreter::load(&program, &layout);
        for number in 0..RUNS {
            let entry = Entry { block, start_information: [7; 20], registers: None };
            let prepare = |machine: &mut Machine| fill(machine, &KINDS[(seed % 4) as usize], seed + 1_000_000 + (number << 32));
            let outcome = |engine: &Arc<dyn Engine>| {
                let dice = RefCell::new(Dice(seed + 2_000_000 + number));
                let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
                run(engine.as_ref(), &layout, &entry, &prepare, &answer)
            };
            let expected = outcome(&interpreter);
            for engine in &engines {
                let engine: Arc<dyn Engine> = engine.clone();
                outcome(&engine).assert_ends_as(&expected, &|| format!("{seed}, run {number}\n{}", program.code[&block].code));
            }
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 500 && finished > 1_000, "{asked} questions, {finished} runs to the end");
}

fn listing(iteration: &dyn Fn(&mut Builder) -> u32) -> String {
    let program: Program = program(&[(BlockId::ob(1), 16, &|b| counted(b, COUNTER, 30, iteration))]);
    Jit::listing(&program, &noting::layout(&program)).expect("machine code")
}

/// Whether several iterations at once keep the least or the greatest of numbers: nothing else in a loop is written with this operation.
fn is_side_by_side(iteration: &dyn Fn(&mut Builder) -> u32) -> bool {
    listing(iteration).contains("= smax")
}

#[test]
fn several_iterations_at_once_keep_the_greatest_integer() {
    assert!(is_side_by_side(&|b| keep_by_comparison(b, 1, (Width::DoubleWord, Op::GtI32), KEPT[0], false, false)));
    assert!(is_side_by_side(&|b| keep_by_comparison(b, 1, (Width::DoubleWord, Op::LeI32), KEPT[0], true, false)));
    assert!(is_side_by_side(&|b| keep_by_comparison(b, 1, (Width::Word, Op::GeI16), KEPT[0], false, false)));
    for width in [Width::Word, Width::DoubleWord] {
        let op = if width == Width::Word { Op::MaxI16 } else { Op::MaxI32 };
        // This operation is written so one by one, too.
        let iteration = |b: &mut Builder| {
            keep_one_of_two(b, (width, op), KEPT[0], true);
            2
        };
        let lanes = if width == Width::Word { "i16x8" } else { "i32x4" };
        assert!(listing(&iteration).contains(lanes));
    }
}

#[test]
fn iterations_are_made_one_by_one_where_something_else_looks_at_what_is_kept() {
    // The index of the greatest number depends on the order.
    assert!(!is_side_by_side(&|b| keep_by_comparison(b, 1, (Width::DoubleWord, Op::GtI32), KEPT[0], false, true)));
    // A sum of all that was the greatest number once.
    assert!(!is_side_by_side(&|b| {
        keep_by_comparison(b, 1, (Width::DoubleWord, Op::GtI32), KEPT[0], false, false);
        b.begin_statement();
        let (kept, sum) = (get(b, KEPT[0], Width::DoubleWord), get(b, SUM, Width::DoubleWord));
        let sum = b.compute(Op::AddU32, &[kept, sum]);
        b.store(fixed(SUM), Width::DoubleWord, sum);
        4
    }));
    // Only half of the number is compared, or its bits have no sign.
    assert!(!is_side_by_side(&|b| keep_by_comparison(b, 1, (Width::DoubleWord, Op::GtI16), KEPT[0], false, false)));
    assert!(!is_side_by_side(&|b| keep_by_comparison(b, 1, (Width::DoubleWord, Op::Below), KEPT[0], true, false)));
}

#[cfg(target_arch = "x86_64")]
#[test]
fn the_less_or_greater_real_is_one_instruction_where_the_order_of_equal_ones_is_kept() {
    let of = |width: Width, op: Op, turned: bool| listing(&move |b| keep_by_comparison(b, 1, (width, op), KEPT[0], turned, false));
    for (op, turned, instruction) in
        [(Op::LtF32, false, "minss"), (Op::GtF32, true, "minss"), (Op::GtF32, false, "maxss"), (Op::LtF32, true, "maxss")]
    {
        assert!(of(Width::DoubleWord, op, turned).contains(instruction), "{op:?} {turned}");
    }
    for (op, instruction) in [(Op::LtF64, "minsd"), (Op::GtF64, "maxsd")] {
        assert!(of(Width::QuadWord, op, false).contains(instruction), "{op:?}");
    }
    // Of zeros with different signs the last one stays, and what is no number is not the same as with `<`.
    for op in [Op::LeF32, Op::GeF32] {
        let listing = of(Width::DoubleWord, op, false);
        assert!(!listing.contains("minss") && !listing.contains("maxss"), "{op:?}");
    }
}
