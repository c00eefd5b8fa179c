//! One look at the budget serves for an iteration of a loop that enters small blocks, or for statements that follow one another and do; the
//! interpreter does those for which it does not last, and what is left of those in which a statement failed. Whoever is asked sees the same
//! as ever.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target};
use sieben_engine::{Engine, Entry, Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::dice::{Dice, seeds};
use crate::noting::{Blocks, all_engines_agree, engines, layout, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 350;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 80;
/// The function with the loop, which organization block 1 calls, and those that it enters.
const LOOPS: u16 = 5;
const ENTERED: u16 = 4;
const LOCAL_BYTES: u32 = 8;
/// Where loops count.
const INDEX: u32 = 2;
/// What nobody writes.
const UNUSED: u32 = 10;

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

/// Writes the index to the open data block, so many bytes for each iteration behind one another: beyond the block that fails.
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

/// A random statement, from where jumps go to one of these.
fn statement(b: &mut Builder, dice: &mut Dice, targets: &[u32]) {
    match dice.roll(11) {
        0..=4 => call(b, BlockId::fc(1 + dice.roll(u64::from(ENTERED)) as u16)),
        5 => write_data(b, dice.of(&[1, 4, 9])),
        6 => count(b, dice.of(&[4, 6])),
        7 => open(b, dice.of(&[1, 2])),
        // It does nothing, and may be the first one of the loop.
        8 => {
            b.begin_statement();
        }
        _ => {
            let (to, byte) = (dice.of(targets), dice.of(&[INDEX, 4]));
            jump(b, byte, dice.roll(4), to);
        }
    }
}

/// A loop of random statements, left in its middle here and there, with others before it in a block that is a function of its own.
fn loops(b: &mut Builder, dice: &mut Dice, own: bool) {
    open(b, 1);
    begin_count(b);
    let first = 2 + if own { 3 + dice.roll(12) as u32 } else { 0 };
    for number in 2..first {
        statement(b, dice, &[number + 1, number + 2, number + 3, number + 5].map(|to: u32| to.min(first)));
    }
    let body = 2 + dice.roll(5) as u32;
    // Behind the body one statement counts, one jumps back, and five follow.
    let last = first + body + 1;
    for number in first..first + body {
        // Over the next statements, to the next iteration, behind the loop, further on, or out of the block.
        let targets = [number + 2, number + 2, last - 1, last + 1, last + 2, last + 3].map(|to| to.max(number + 1));
        statement(b, dice, &targets);
    }
    count(b, INDEX);
    jump(b, INDEX, 2 + dice.roll(5), first);
    // What is known of the open data block ends here.
    jump(b, 4, dice.roll(6), last + 3);
    open(b, 2);
    write_data(b, 1);
    call(b, BlockId::fc(1));
    if own {
        call_itself_never(b);
    }
    end(b);
}

/// A block that calls itself becomes part of no other one.
fn call_itself_never(b: &mut Builder) {
    let next = b.next().0;
    jump(b, UNUSED, 32_767, next + 2);
    call(b, BlockId::fc(LOOPS));
}

/// A block that an iteration enters.
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
fn what_the_interpreter_does_in_between_changes_nothing_on_any_engine() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let dice = |number: u16| Dice(seed * 100 + u64::from(number));
        let main = |b: &mut Builder| {
            if seed % 3 == 0 {
                return loops(b, &mut dice(0), false);
            }
            call(b, BlockId::fc(LOOPS));
            count(b, 8);
            end(b);
        };
        let builders: Vec<_> = (1..=ENTERED).map(|number| move |b: &mut Builder| entered(b, &mut dice(number), number)).collect();
        let function = |b: &mut Builder| loops(b, &mut dice(LOOPS), seed % 3 == 1);
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
        let outcome = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("seed {seed}\n{}", listing()));
        asked += outcome.asked.len();
        finished += usize::from(outcome.exit == Exit::Finished);
    }
    assert!(asked > 1_200 && finished > 260, "{asked} questions, {finished} runs to the end");
}

/// Behind the piece the loop is entered at its first statement, though that does nothing and the interpreter names the one after it.
#[test]
fn a_piece_before_a_loop_that_begins_with_nothing() {
    let function = |b: &mut Builder| {
        open(b, 1);
        begin_count(b);
        call(b, BlockId::fc(1));
        let head = b.begin_statement().0;
        count(b, INDEX);
        call(b, BlockId::fc(1));
        jump(b, INDEX, 9, head);
        // In a long function the address of memory is read again where paths meet.
        (0..150).for_each(|number| count(b, 20 + 2 * number));
        call_itself_never(b);
        end(b);
    };
    let main = |b: &mut Builder| {
        call(b, BlockId::fc(LOOPS));
        end(b);
    };
    let entered = |b: &mut Builder| {
        write_data(b, 1);
        count(b, 6);
        end(b);
    };
    let program =
        program(&[(BlockId::ob(1), 20, &main), (BlockId::fc(LOOPS), LOCAL_BYTES, &function), (BlockId::fc(1), LOCAL_BYTES, &entered)]);
    let layout = layout(&program);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    for budget in 0..40 {
        let outcome = |engine: Arc<dyn Engine>| {
            run(&*engine, &layout, &entry, &|machine| machine.budget = budget, &|machine, _, _| {
                machine.budget = 3;
                Reaction::Continue
            })
        };
        all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("budget {budget}"));
    }
}

/// The pieces that are handed over in a function with such statements, as their first and last statement.
fn pieces(build: &dyn Fn(&mut Builder)) -> Vec<(u64, u64)> {
    let function = |b: &mut Builder| {
        build(b);
        call_itself_never(b);
    };
    let main = |b: &mut Builder| {
        call(b, BlockId::fc(LOOPS));
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
    let blocks: Blocks<'_> =
        &[(BlockId::ob(1), 20, &main), (BlockId::fc(LOOPS), 0, &function), (BlockId::fc(1), 0, &counts), (BlockId::fc(2), 0, &with_a_loop)];
    let program = program(blocks);
    let listing = Jit::listing(&program, &layout(&program)).expect("machine code");
    // Nothing else that answers in memory has six arguments; the last but one is both statements.
    let span = |line: &str| {
        let (arguments, constants) = line.trim_start().strip_prefix("call fn")?.split_once(')')?;
        let &[_, _, _, _, span, _] = arguments.split(", ").collect::<Vec<_>>().as_slice() else { return None };
        let (_, span) = constants.split_once(&format!("{span} = "))?;
        let span = span.split(',').next()?.trim().replace('_', "");
        let span = match span.strip_prefix("0x") {
            Some(digits) => u64::from_str_radix(digits, 16),
            None => span.parse(),
        };
        let span = span.expect("a number");
        Some((span & 0xFFFF_FFFF, span >> 32))
    };
    let mut pieces: Vec<(u64, u64)> = listing.lines().filter_map(span).collect();
    pieces.sort_unstable();
    pieces
}

/// A loop with such an iteration, from statement 1 on.
fn looping(iteration: &dyn Fn(&mut Builder)) -> Vec<(u64, u64)> {
    pieces(&|b: &mut Builder| {
        begin_count(b);
        let first = b.next().0;
        iteration(b);
        count(b, INDEX);
        jump(b, INDEX, 5, first);
    })
}

#[test]
fn a_iteration_is_handed_over_if_it_enters_small_blocks_and_nothing_that_takes_long() {
    assert_eq!(looping(&|b| call(b, BlockId::fc(1))), [(1, 3)]);
    let jumps_over = |b: &mut Builder| {
        jump(b, 4, 3, 3);
        call(b, BlockId::fc(1));
        call(b, BlockId::fc(1));
    };
    assert_eq!(looping(&jumps_over), [(1, 5)]);
    // It enters none, or one that is not there, asks somebody or has a loop.
    assert_eq!(looping(&|b| count(b, 4)), []);
    assert_eq!(looping(&|b| call(b, BlockId::fc(9))), []);
    assert_eq!(looping(&|b| call(b, BlockId::new(BlockKind::SystemFunction, 23))), []);
    assert_eq!(looping(&|b| call(b, BlockId::fc(2))), []);
    // There is a loop in the iteration: what is in none that is smaller is a piece of its own.
    let with_a_loop = |b: &mut Builder| {
        count(b, 4);
        count(b, 4);
        jump(b, 4, 9, 2);
        call(b, BlockId::fc(1));
    };
    assert_eq!(looping(&with_a_loop), [(4, 5)]);
    let calls_one_with_a_loop = |b: &mut Builder| {
        call(b, BlockId::fc(2));
        call(b, BlockId::fc(1));
    };
    assert_eq!(looping(&calls_one_with_a_loop), [(2, 3)]);
}

#[test]
fn statements_that_follow_one_another_are_handed_over_up_to_where_all_ways_meet() {
    let one = |b: &mut Builder| call(b, BlockId::fc(1));
    // The last piece is what stands behind all others: a jump out of the block ends it.
    assert_eq!(pieces(&|b| (0..3).for_each(|_| one(b))), [(0, 2)]);
    let jumps_over = |b: &mut Builder| {
        one(b);
        jump(b, 4, 3, 4);
        one(b);
        one(b);
        count(b, 4);
    };
    assert_eq!(pieces(&jumps_over), [(0, 4)]);
    // A loop, a block that has one, and one that is not there end it.
    let before_a_loop = |b: &mut Builder| {
        one(b);
        count(b, 4);
        count(b, 4);
        jump(b, 4, 3, 2);
    };
    assert_eq!(pieces(&before_a_loop), [(0, 1)]);
    let over_a_loop = |b: &mut Builder| {
        one(b);
        jump(b, 4, 3, 4);
        count(b, 4);
        jump(b, 4, 3, 2);
        one(b);
    };
    assert_eq!(pieces(&over_a_loop), [(0, 0), (4, 4)]);
    for other in [2, 9] {
        let before_another = |b: &mut Builder| {
            one(b);
            call(b, BlockId::fc(other));
            one(b);
        };
        assert_eq!(pieces(&before_another), [(0, 0), (2, 2)]);
    }
    // As many blocks as a look is for, and those behind them.
    assert_eq!(pieces(&|b| (0..40).for_each(|_| one(b))), [(0, 23), (24, 39)]);
}

#[test]
fn a_counter_that_the_program_computes_is_found_in_all_blocks_of_a_piece() {
    let counts_up = |b: &mut Builder| {
        b.begin_statement();
        let number = b.load(memory(UNUSED), Width::Word, OnFault::SkipStatement);
        let rlo = b.constant(1);
        b.intrinsic(Intrinsic::CounterUp, &[number, rlo]);
        end(b);
    };
    let shows = |b: &mut Builder| {
        b.begin_statement();
        let number = b.load(memory(UNUSED), Width::Word, OnFault::SkipStatement);
        let value = b.intrinsic(Intrinsic::CounterValue, &[number]);
        b.store(memory(6), Width::Word, value);
        end(b);
    };
    let function = |b: &mut Builder| {
        (1..=2).for_each(|number| call(b, BlockId::fc(number)));
        call_itself_never(b);
        end(b);
    };
    let main = |b: &mut Builder| {
        (0..2).for_each(|_| call(b, BlockId::fc(LOOPS)));
        end(b);
    };
    let program = program(&[
        (BlockId::ob(1), 20, &main),
        (BlockId::fc(LOOPS), 0, &function),
        (BlockId::fc(1), 0, &counts_up),
        (BlockId::fc(2), 0, &shows),
    ]);
    let layout = layout(&program);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let engines = engines(&program, &layout);
    for number in [0, 3, 200, 0xFFFF_u16] {
        for budget in [1, 100] {
            let outcome = |engine: Arc<dyn Engine>| {
                let prepare = |machine: &mut Machine| {
                    machine.budget = budget;
                    machine.memory.area_mut(Area::BitMemory)[UNUSED as usize..][..2].copy_from_slice(&number.to_be_bytes());
                };
                run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
            };
            all_engines_agree(&engines, true, &outcome, &|| format!("counter {number}"));
        }
    }
}
