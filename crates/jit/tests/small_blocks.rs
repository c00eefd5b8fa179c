//! Small blocks that become part of their callers, under a Host that changes memory, time and budget whenever it is asked: machine code
//! that looks at the budget once for several blocks, and remembers what it has read, does what the interpreter does.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::{Register, Registers, TimerKind};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Interpreter, Machine, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::dice::{Dice, seeds};
use crate::noting::{layout, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 150;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 60;
/// Functions of a program; each calls those behind it.
const FUNCTIONS: u16 = 5;
/// Bytes of bit memory that programs use: few, so that accesses meet.
const BYTES: u64 = 6;
/// Bytes of local data of each block.
const LOCAL_BYTES: u32 = 24;

/// A place in few bytes, mostly there.
fn place(dice: &mut Dice, width: Width) -> Place {
    let area = dice.of(&[Area::BitMemory, Area::BitMemory, Area::Output, Area::Local, Area::SharedData]);
    let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
    let byte = match dice.roll(40) {
        0 if area == Area::SharedData => 15,
        _ => dice.roll(BYTES) as u32,
    };
    Place::Fixed { area, position: 8 * byte + bit }
}

fn width(dice: &mut Dice) -> Width {
    dice.of(&[Width::Bit, Width::Bit, Width::Bit, Width::Byte, Width::Word, Width::DoubleWord])
}

fn read(b: &mut Builder, dice: &mut Dice, width: Width) -> Var {
    let place = place(dice, width);
    b.load(place, width, dice.of(&[OnFault::SkipStatement, OnFault::SkipStatement, OnFault::DeliverZero]))
}

/// A statement that computes something, starts a timer, or opens a data block that may not be there.
fn statement(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    match dice.roll(14) {
        12 => {
            // Often what a register begins with.
            let value = dice.of(&[0, 0, 1, 0x1234]);
            b.set(dice.of(&[Register::Accu1, Register::Accu2, Register::Ar1]), value);
        }
        13 => {
            let value = read(b, dice, Width::Word);
            b.copy(dice.of(&[Register::Accu1, Register::Accu2, Register::Ar1]), value);
        }
        0..=6 => {
            let width = width(dice);
            let mut value = read(b, dice, width);
            for _ in 0..dice.roll(3) {
                let other = if dice.roll(3) == 0 { b.constant(dice.roll(0x1_0000)) } else { read(b, dice, width) };
                value = match width {
                    Width::Bit => b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[value, other]),
                    _ => b.compute(dice.of(&[Op::AddU32, Op::Xor, Op::SubU32]), &[value, other]),
                };
            }
            let to = place(dice, width);
            b.store(to, width, value);
        }
        7..=9 => {
            let number = b.constant(dice.of(&[1, 1, 2]));
            let rlo = read(b, dice, Width::Bit);
            let kind = dice.of(&[
                TimerKind::Pulse,
                TimerKind::ExtendedPulse,
                TimerKind::OnDelay,
                TimerKind::RetentiveOnDelay,
                TimerKind::OffDelay,
            ]);
            // Mostly a time that is over soon, sometimes none that a timer could have.
            let preset = b.constant(dice.of(&[0x0002, 0x0003, 0x1001, 0x000A, 0]));
            b.intrinsic(Intrinsic::TimerStart(kind), &[number, rlo, preset]);
        }
        10 if dice.roll(2) == 0 => {
            let (number, rlo) = (b.constant(dice.of(&[1, 1, 2])), read(b, dice, Width::Bit));
            // Sometimes a counter that is computed, and a count that no counter could have.
            let byte = Place::Fixed { area: Area::BitMemory, position: 0 };
            let computed = b.load(byte, Width::Byte, OnFault::SkipStatement);
            let number = if dice.roll(6) == 0 { computed } else { number };
            let count = b.constant(dice.of(&[3, 3, 0x999, 0xA]));
            let to = place(dice, Width::Word);
            match dice.roll(6) {
                0 => drop(b.intrinsic(Intrinsic::CounterUp, &[number, rlo])),
                1 => drop(b.intrinsic(Intrinsic::CounterDown, &[number, rlo])),
                2 => drop(b.intrinsic(Intrinsic::CounterSet, &[number, rlo, count])),
                3 => drop(b.intrinsic(Intrinsic::CounterReset, &[number, rlo])),
                _ => {
                    let value = b.intrinsic(dice.of(&[Intrinsic::CounterValue, Intrinsic::CounterStatus]), &[number]);
                    b.store(to, Width::Word, value);
                }
            }
        }
        10 => {
            let number = b.constant(dice.of(&[1, 2]));
            let status = b.intrinsic(dice.of(&[Intrinsic::TimerStatus, Intrinsic::TimerStatus, Intrinsic::TimerValue]), &[number]);
            let to = place(dice, Width::Bit);
            b.store(to, Width::Bit, status);
        }
        _ => {
            let number = b.constant(dice.of(&[1, 1, 1, 0, 9]));
            b.push(Inst::Open { register: DataRegister::Shared, number });
        }
    }
}

/// The statements of a block that calls functions with numbers from `first` on.
fn block(b: &mut Builder, dice: &mut Dice, first: u16, length: u64) {
    let mut statements = 0;
    for _ in 0..1 + dice.roll(length) {
        match dice.roll(8) {
            // A jump over one to three of those that follow.
            0 | 1 => {
                b.begin_statement();
                let condition = read(b, dice, Width::Bit);
                let over = 1 + dice.roll(3) as u32;
                b.push(Inst::Branch { condition, to: Target(statements + 1 + over) });
                statements += 1;
                for _ in 0..over {
                    inner(b, dice, first);
                }
                statements += over;
            }
            // A jump over the end of the block.
            3 => {
                b.begin_statement();
                let condition = read(b, dice, Width::Bit);
                b.push(Inst::Branch { condition, to: Target(statements + 2) });
                b.begin_statement();
                b.push(Inst::Return);
                statements += 2;
            }
            // A jump by a table before a loop, into it, or over it.
            2 => {
                b.begin_statement();
                let index = read(b, dice, Width::Byte);
                let three = b.constant(3);
                let index = b.compute(Op::AndU32, &[index, three]);
                let mut target = || Target(statements + 1 + dice.roll(5) as u32);
                let (targets, otherwise) = ([target(), target(), target()], target());
                let table = b.table(&targets);
                b.push(Inst::JumpTable { index, first: table, count: targets.len() as u32, otherwise });
                statements += 1;
                statements += repeat(b, dice, first, statements);
            }
            _ => {
                inner(b, dice, first);
                statements += 1;
            }
        }
    }
    if dice.roll(4) == 0 {
        repeat(b, dice, first, statements);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// A loop of a few iterations around a call, which begins at a statement; how many statements it has.
fn repeat(b: &mut Builder, dice: &mut Dice, first: u16, statement: u32) -> u32 {
    let counter = Place::Fixed { area: Area::Local, position: 8 * 20 };
    b.begin_statement();
    let iterations = b.constant(1 + dice.roll(4));
    b.store(counter, Width::Byte, iterations);
    inner(b, dice, first);
    b.begin_statement();
    let (left, one) = (b.load(counter, Width::Byte, OnFault::SkipStatement), b.constant(1));
    let left = b.compute(Op::SubU32, &[left, one]);
    b.store(counter, Width::Byte, left);
    let goes_on = b.compute(Op::IsNonzero, &[left]);
    b.push(Inst::Branch { condition: goes_on, to: Target(statement + 1) });
    inner(b, dice, first);
    4
}

fn inner(b: &mut Builder, dice: &mut Dice, first: u16) {
    if first <= FUNCTIONS && dice.roll(2) == 0 {
        b.begin_statement();
        let number = first + dice.roll(u64::from(FUNCTIONS - first) + 1) as u16;
        let callee = match dice.roll(12) {
            0 => BlockId::new(BlockKind::SystemFunction, 64),
            _ => BlockId::fc(number),
        };
        b.push(Inst::Call { callee: Callee::Block(callee), parameters: 0 });
    } else {
        statement(b, dice);
    }
}

/// Registers that everybody sees as they are.
fn exact(registers: &Registers) -> [u64; 12] {
    use Register as R;
    let data_blocks = [R::DbNumber, R::DbBase, R::DbLength, R::DiNumber, R::DiBase, R::DiLength];
    let others = [R::Accu1, R::Accu2, R::Ar1, R::Ar2, R::Rlo, R::Br];
    let all: Vec<u64> = others.into_iter().chain(data_blocks).map(|register| registers.get(register)).collect();
    all.try_into().expect("twelve registers")
}

/// Changes a few bytes, the time and the budget, sometimes, and goes on.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 20, 40]);
    machine.clock_us += dice.of(&[0, 0, 10_000, 50_000]);
    for _ in 0..dice.of(&[0, 0, 1, 1, 3]) {
        let value = dice.roll(256) as u8;
        match dice.roll(3) {
            0 => {
                let range = machine.memory.layout.data_blocks[&1].clone();
                machine.memory.arena[range.start + dice.roll(BYTES) as usize] = value;
            }
            1 => machine.memory.area_mut(Area::Output)[dice.roll(BYTES) as usize] = value,
            _ => machine.memory.area_mut(Area::BitMemory)[dice.roll(BYTES) as usize] = value,
        }
    }
    Reaction::Continue
}

#[test]
fn small_blocks_do_the_same_on_all_engines() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let blocks: Vec<_> = (0..=FUNCTIONS).collect();
        let build = |number: u16| {
            move |b: &mut Builder| {
                let length = if number == 0 { 10 } else { 3 };
                block(b, &mut Dice(seed * 100 + u64::from(number)), number + 1, length);
            }
        };
        let builders: Vec<_> = blocks.iter().map(|&number| build(number)).collect();
        let id = |number: u16| if number == 0 { BlockId::ob(1) } else { BlockId::fc(number) };
        let part = |(&number, build)| (id(number), LOCAL_BYTES, build as &dyn Fn(&mut Builder));
        let parts: Vec<_> = blocks.iter().zip(&builders).map(part).collect();
        let program = program(&parts);
        let layout = layout(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.roll(40) as i64;
            machine.memory.area_mut(Area::BitMemory)[..BYTES as usize].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let outcome = |engine: Arc<dyn Engine>| {
            let (dice, seen) = (RefCell::new(Dice(seed + 2_000_000)), RefCell::new(Vec::new()));
            let answer = |machine: &mut Machine, _: &str, asked: usize| {
                let timers: Vec<_> = machine.timers.iter().take(3).cloned().collect();
                let counters: Vec<_> = machine.counters.iter().take(3).cloned().collect();
                let local = machine.memory.layout.local.clone();
                let bytes = machine.memory.arena[local.start..local.start + 6 * LOCAL_BYTES as usize].to_vec();
                let shown = (machine.memory.area(Area::BitMemory)[..8].to_vec(), machine.memory.area(Area::Output)[..8].to_vec());
                seen.borrow_mut().push((machine.budget, exact(&machine.registers), timers, counters, bytes, shown));
                meddle(machine, &mut dice.borrow_mut(), asked)
            };
            let outcome = run(engine.as_ref(), &layout, &entry, &prepare, &answer);
            (outcome, seen.into_inner())
        };
        let (expected, expected_seen) = outcome(Interpreter::load(&program, &layout));
        for status in [StatusBits::All, StatusBits::Needed] {
            let (got, got_seen) = outcome(Jit::compiled(&program, &layout, status).expect("machine code"));
            let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
            assert_eq!(exact(&got.registers), exact(&expected.registers), "{seed} {status:?}\n{}", listing());
            got.assert_ends_as(&expected, &|| format!("{seed} {status:?}\n{}", listing()));
            if let Some(at) = (0..expected_seen.len()).find(|&at| got_seen[at] != expected_seen[at]) {
                panic!(
                    "{seed} {status:?}: question {at}, {}: {:?} and {:?}\n{}",
                    expected.asked[at],
                    got_seen[at],
                    expected_seen[at],
                    listing()
                );
            }
        }
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 500 && finished > 50, "{asked} questions, {finished} runs to the end");
}
