//! Loops that enter small blocks look at the budget once a turn; the interpreter does the turns for which it does not last, and what is left of
//! those in which a statement failed. Whoever is asked sees the same as ever.

use std::cell::RefCell;
use std::sync::Arc;

use dice::Dice;
use noting::{Blocks, all_engines_agree, layout, program, run};
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target};
use sieben_engine::{Engine, Entry, Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

mod dice;
mod noting;

/// Programs that are compared.
const PROGRAMS: u64 = 600;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 80;
/// The function with the loop, which organization block 1 calls, and those that it enters.
const LOOPS: u16 = 5;
const ENTERED: u16 = 4;
const LOCAL_BYTES: u32 = 8;
/// Where loops count.
const INDEX: u32 = 2;
/// What the turn of a loop that is looked at hands over, in a listing: nothing else in cold code has six arguments.
const HANDS_OVER: &str = "(i64, i64, i64, i64, i64, i64) preserve_all";

fn memory(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

fn count(b: &mut Builder, byte: u32) {
    b.begin_statement();
    let (value, one) = (b.load(memory(byte), Width::Word, OnFault::SkipStatement), b.constant(1));
    let next = b.compute(Op::AddU16, &[value, one]);
    b.store(memory(byte), Width::Word, next);
}

fn call(b: &mut Builder, block: BlockId) {
    b.begin_statement();
    b.push(Inst::Call { callee: Callee::Block(block), parameters: 0 });
}

fn open(b: &mut Builder, number: u64) {
    b.begin_statement();
    let number = b.constant(number);
    b.push(Inst::Open { register: DataRegister::Shared, number });
}

/// Writes the index to the open data block, so many bytes for each turn behind one another: beyond the block that fails.
fn write_data(b: &mut Builder, step: u64) {
    b.begin_statement();
    let (index, step) = (b.load(memory(INDEX), Width::Word, OnFault::SkipStatement), b.constant(8 * step));
    let pointer = b.compute(Op::MulU32, &[index, step]);
    b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, Width::Word, index);
}

/// Jumps if a number in bit memory is at most so much.
fn jump(b: &mut Builder, byte: u32, most: u64, to: u32) {
    b.begin_statement();
    let (value, most) = (b.load(memory(byte), Width::Word, OnFault::SkipStatement), b.constant(most));
    let condition = b.compute(Op::LeI16, &[value, most]);
    b.push(Inst::Branch { condition, to: Target(to) });
}

fn begin_count(b: &mut Builder) {
    b.begin_statement();
    let zero = b.constant(0);
    b.store(memory(INDEX), Width::Word, zero);
}

fn end(b: &mut Builder) {
    b.begin_statement();
    b.push(Inst::Return);
}

/// A loop of random statements, left in its middle here and there.
fn loops(b: &mut Builder, dice: &mut Dice) {
    open(b, 1);
    begin_count(b);
    let body = 2 + dice.roll(5) as u32;
    // Behind the body one statement counts, one jumps back, and five follow.
    let (first, last) = (2, 2 + body + 1);
    for statement in first..first + body {
        match dice.roll(8) {
            0..=3 => call(b, BlockId::fc(1 + dice.roll(u64::from(ENTERED)) as u16)),
            4 => write_data(b, dice.of(&[1, 4, 9])),
            5 => count(b, dice.of(&[4, 6])),
            _ => {
                // Over the next statements, to the next turn, behind the loop, further on, or out of the block.
                let to = dice.of(&[statement + 2, statement + 2, last - 1, last + 1, last + 2, last + 3]).max(statement + 1);
                let byte = dice.of(&[INDEX, 4]);
                jump(b, byte, dice.roll(4), to);
            }
        }
    }
    count(b, INDEX);
    jump(b, INDEX, 2 + dice.roll(5), first);
    // What is known of the open data block ends here.
    jump(b, 4, dice.roll(6), last + 3);
    open(b, 2);
    write_data(b, 1);
    call(b, BlockId::fc(1));
    end(b);
}

/// A block that a turn enters.
fn entered(b: &mut Builder, dice: &mut Dice, number: u16) {
    let statements = 1 + dice.roll(3) as u32;
    for statement in 0..statements {
        match dice.roll(7) {
            0 | 1 => count(b, dice.of(&[4, 6, 8])),
            2 => open(b, dice.of(&[1, 2])),
            3 => write_data(b, dice.of(&[2, 5])),
            4 if number < ENTERED => call(b, BlockId::fc(number + 1)),
            _ => jump(b, dice.of(&[INDEX, 4]), dice.roll(4), (statement + 2).min(statements)),
        }
    }
    end(b);
}

/// Changes a few bytes and the budget, lets another organization block run or takes a data block away, and goes on.
fn meddle(machine: &mut Machine, dice: &mut Dice, what: &str, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 2, 3, 5, 8, 12, 20, 40, 1_000]);
    if what.starts_with("SFC") {
        if dice.roll(3) == 0 {
            machine.memory.data_blocks[1] = None;
        }
        return Reaction::Continue;
    }
    if dice.roll(3) == 0 {
        machine.memory.area_mut(Area::BitMemory)[dice.of(&[3, 5, 7])] = dice.roll(5) as u8;
    }
    match dice.roll(12) {
        0 | 1 => Reaction::Enter { block: BlockId::ob(40), start_information: [3; 20] },
        2 if dice.roll(4) == 0 => Reaction::Suspend,
        _ => Reaction::Continue,
    }
}

#[test]
fn turns_that_the_interpreter_does_change_nothing_on_any_engine() {
    let (mut asked, mut finished) = (0, 0);
    for seed in 0..PROGRAMS {
        let dice = |number: u16| Dice(seed * 100 + u64::from(number));
        let main = |b: &mut Builder| {
            if seed % 3 == 0 {
                return loops(b, &mut dice(0));
            }
            call(b, BlockId::fc(LOOPS));
            count(b, 8);
            end(b);
        };
        let builders: Vec<_> = (1..=ENTERED).map(|number| move |b: &mut Builder| entered(b, &mut dice(number), number)).collect();
        let function = |b: &mut Builder| loops(b, &mut dice(LOOPS));
        let interrupt = |b: &mut Builder| {
            count(b, 6);
            call(b, BlockId::new(BlockKind::SystemFunction, 23));
            end(b);
        };
        let mut parts = vec![
            (BlockId::ob(1), 20 + LOCAL_BYTES, &main as &dyn Fn(&mut Builder)),
            (BlockId::ob(40), 20, &interrupt),
            (BlockId::fc(LOOPS), LOCAL_BYTES, &function),
        ];
        parts.extend((1..).zip(&builders).map(|(number, build)| (BlockId::fc(number), LOCAL_BYTES, build as &dyn Fn(&mut Builder))));
        let program = program(&parts);
        let mut layout = layout(&program);
        layout.data_blocks.insert(2, layout.size - 48..layout.size - 32);
        let prepare = |machine: &mut Machine| {
            machine.budget = Dice(seed + 1_000_000).of(&[1, 3, 5, 8, 12, 20, 40, 1_000]);
        };
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let outcome = |engine: Arc<dyn Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, what: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), what, asked);
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        let outcome = all_engines_agree((&program, &layout), true, &outcome, &|| format!("seed {seed}\n{}", listing()));
        asked += outcome.asked.len();
        finished += usize::from(outcome.exit == Exit::Finished);
    }
    assert!(asked > 2_000 && finished > 450, "{asked} questions, {finished} runs to the end");
}

/// Whether turns of a loop with such statements are handed over; function 1 counts, function 2 has a loop.
fn hands_over(turn: &dyn Fn(&mut Builder)) -> bool {
    let main = |b: &mut Builder| {
        begin_count(b);
        let first = b.next();
        turn(b);
        count(b, INDEX);
        jump(b, INDEX, 5, first.0);
        end(b);
    };
    let with_a_loop = |b: &mut Builder| {
        count(b, 4);
        jump(b, 4, 9, 0);
        end(b);
    };
    let counts = |b: &mut Builder| {
        count(b, 6);
        end(b);
    };
    let blocks: Blocks<'_> = &[(BlockId::ob(1), 20, &main), (BlockId::fc(1), 0, &counts), (BlockId::fc(2), 0, &with_a_loop)];
    let program = program(blocks);
    Jit::listing(&program, &layout(&program)).expect("machine code").contains(HANDS_OVER)
}

#[test]
fn a_turn_is_handed_over_if_it_enters_small_blocks_and_nothing_that_takes_long() {
    assert!(hands_over(&|b| call(b, BlockId::fc(1))));
    assert!(hands_over(&|b| {
        jump(b, 4, 3, 3);
        call(b, BlockId::fc(1));
        call(b, BlockId::fc(1));
    }));
    // It enters none, or one that asks somebody.
    assert!(!hands_over(&|b| count(b, 4)));
    assert!(!hands_over(&|b| call(b, BlockId::fc(9))));
    assert!(!hands_over(&|b| call(b, BlockId::new(BlockKind::SystemFunction, 23))));
    // There is a loop in the turn, or in the block.
    assert!(!hands_over(&|b| {
        call(b, BlockId::fc(2));
        call(b, BlockId::fc(1));
    }));
    assert!(!hands_over(&|b| {
        count(b, 4);
        jump(b, 4, 9, 2);
        call(b, BlockId::fc(1));
    }));
}
