//! Function blocks that were handed pointers and reach elements behind them, by indexes that they look at or count, copy bytes there, and
//! hand the pointers on: what their caller keeps over the call is what the interpreter finds, whatever a Host does that is asked.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, FaultPlace, Layout, Machine, Program, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, begin_with_instance, engines, layout_with, program, run, run_beside};

/// Programs that are compared.
const PROGRAMS: u64 = 80;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 60;
/// Function blocks of a program; each may hand on to those behind it.
const BLOCKS: u16 = 3;
/// The block that calls them in a loop.
const CALLER: u16 = BLOCKS + 1;
/// Instances in the data block: so many, of so many bytes, each with another one in it that begins here.
const INSTANCES: u64 = 3;
const INSTANCE_BYTES: u64 = 48;
const INNER: u64 = 24;
/// Where an instance has the number of a data block, the pointer for which that counts, and what it counts with.
const NUMBER: u32 = 8 * 12;
const POINTER: u32 = 8 * 14;
const COUNTER: u32 = 8 * 18;
/// Behind the instances: the counter of the caller, and what it writes to with that.
const CALLERS_COUNTER: u32 = 8 * 150;
const ELEMENTS: u32 = 8 * 160;
/// Bytes of the data blocks.
const DATA_BYTES: usize = 200;
const OTHER_BYTES: usize = 200;
/// Where instances are saved over calls.
const SAVED: Place = Place::Fixed { area: Area::Local, position: 8 * 8 };
const LOCAL_BYTES: u32 = 16;

fn own(offset: u32) -> Place {
    Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset }
}

/// A pointer and so many times an index, which is looked at, or is not.
fn element(b: &mut Builder, dice: &mut Dice, pointer: Var, (index, count): (Place, u64), step: u64) -> Var {
    let mut number = b.load(index, Width::Word, OnFault::SkipStatement);
    let looks = dice.roll(3);
    if looks != 0 {
        let count = b.constant(count);
        let inside = b.compute(Op::Below, &[number, count]);
        let noted = if looks == 1 { NOTED } else { 0 };
        b.push(Inst::Require { condition: inside, code: noted | 0x22, register: number });
        if noted != 0 {
            number = b.compute(Op::Gate, &[number, inside]);
        }
    }
    let step = b.constant(step);
    let by = b.compute(Op::MulU32, &[number, step]);
    b.compute(Op::AddU32, &[pointer, by])
}

/// The pointer of the instance, behind which its data block is open.
fn opened(b: &mut Builder, dice: &mut Dice, index: (Place, u64)) -> Var {
    let number = b.load(own(NUMBER), Width::Word, OnFault::SkipStatement);
    let mut pointer = b.load(own(POINTER), Width::DoubleWord, OnFault::SkipStatement);
    if dice.roll(4) != 0 {
        let step = dice.of(&[8, 16, 16]);
        pointer = element(b, dice, pointer, index, step);
    }
    b.push(Inst::Open { register: DataRegister::Shared, number });
    pointer
}

/// A variable, or an element behind the pointer.
fn place(b: &mut Builder, dice: &mut Dice, index: (Place, u64), bit: u32) -> Place {
    match dice.roll(8) {
        0..=2 => own(8 * dice.of(&[0, 2, 4, 6, 8]) + bit),
        3 => {
            let pointer = element(b, dice, Register::Ar2.into(), index, 16);
            Place::Indirect { area: Area::InstanceData, pointer, offset: bit }
        }
        _ => {
            let pointer = opened(b, dice, index);
            Place::Crossing { pointer, offset: 8 * dice.of(&[0, 0, 2]) + bit }
        }
    }
}

/// A statement that reads and writes.
fn assigns(b: &mut Builder, dice: &mut Dice, index: (Place, u64)) {
    b.begin_statement();
    if dice.roll(5) == 0 {
        let (from, to) = (place(b, dice, index, 0), place(b, dice, index, 0));
        return b.push(Inst::Move { from, to, bytes: dice.of(&[2, 3, 4, 6]) });
    }
    let width = dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::Word, Width::DoubleWord]);
    let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
    let from = place(b, dice, index, bit);
    let value = b.load(from, width, OnFault::SkipStatement);
    let other = b.constant(dice.of(&[0, 1, 3]));
    let value = if width == Width::Bit { b.compute(Op::Xor, &[value, other]) } else { b.compute(Op::AddU32, &[value, other]) };
    let to = place(b, dice, index, bit);
    b.store(to, width, value);
}

/// Writes the pointer of the instance, or one to the instance, to that of a block that is called.
fn hands_on(b: &mut Builder, dice: &mut Dice, number: u16, index: (Place, u64)) {
    b.begin_statement();
    let inner = 8 * INNER as u32;
    let (block, pointer) = if dice.roll(4) == 0 {
        let pointer = b.constant(0x8400_0000 + 8 * dice.roll(4));
        let low = b.constant(0x7FFFF);
        let own = b.compute(Op::AndU32, &[Register::Ar2.into(), low]);
        (Register::DiNumber.into(), b.compute(Op::AddU32, &[pointer, own]))
    } else {
        let block = b.load(own(NUMBER), Width::Word, OnFault::SkipStatement);
        let pointer = b.load(own(POINTER), Width::DoubleWord, OnFault::SkipStatement);
        (block, if dice.roll(2) == 0 { pointer } else { element(b, dice, pointer, index, 16) })
    };
    b.store(own(inner + NUMBER), Width::Word, block);
    b.store(own(inner + POINTER), Width::DoubleWord, pointer);
    b.store(SAVED, Width::DoubleWord, Register::Ar2);
    let by = b.constant(u64::from(inner));
    b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(number)), parameters: 0 });
    let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
    b.copy(Register::Ar2, saved);
}

/// A counter is one more, and a loop goes on while it is not above a limit.
fn counts(b: &mut Builder, counter: Place, limit: u64, to: u32) {
    b.begin_statement();
    let (value, one) = (b.load(counter, Width::Word, OnFault::SkipStatement), b.constant(1));
    let next = b.compute(Op::AddU16, &[value, one]);
    b.store(counter, Width::Word, next);
    let limit = b.constant(limit);
    let goes_on = b.compute(Op::LeI16, &[next, limit]);
    b.push(Inst::Branch { condition: goes_on, to: Target(to) });
}

/// A function block.
fn block(b: &mut Builder, dice: &mut Dice, number: u16) {
    let mut statements = 0;
    for _ in 0..1 + dice.roll(3) {
        let counter = if dice.roll(4) == 0 { Place::Fixed { area: Area::Local, position: 16 } } else { own(COUNTER) };
        b.begin_statement();
        let first = b.constant(dice.of(&[0, 0, 1, 5]));
        b.store(counter, Width::Word, first);
        statements += 1;
        let head = statements;
        let index = (counter, dice.of(&[2, 3, 4]));
        for _ in 0..1 + dice.roll(3) {
            if number < BLOCKS && dice.roll(4) == 0 {
                hands_on(b, dice, number + 1, index);
            } else {
                assigns(b, dice, index);
            }
            statements += 1;
        }
        if dice.roll(3) != 0 {
            counts(b, counter, dice.of(&[1, 2, 3]), head);
            statements += 1;
        }
    }
}

/// What is handed to instances.
struct Handed {
    /// How many bits the first one lies behind the beginning of the data block.
    moved: u64,
    block: u64,
    /// The byte to which the pointer goes, and how many bytes farther it goes for each instance that follows.
    byte: u64,
    farther: u64,
    /// A pointer as a parameter.
    parameter: u64,
}

impl Handed {
    fn random(dice: &mut Dice) -> Self {
        Self {
            moved: 8 * dice.of(&[0, 0, 1]) * INSTANCE_BYTES,
            block: dice.of(&[2, 2, 2, 1, 1, 9]),
            byte: dice.of(&[0, 0, 2, 4, 10, 30, 144, 148, 160, 190]),
            farther: dice.of(&[0, 0, 2]),
            parameter: 0,
        }
    }
}

/// A loop that hands pointers to instances, and uses its counter before calls and behind them.
fn caller(b: &mut Builder, &Handed { moved, block, byte, farther, parameter }: &Handed) {
    b.begin_statement();
    let first = b.constant(0);
    b.store(own(CALLERS_COUNTER), Width::Word, first);
    let instance = |b: &mut Builder| {
        let (number, count) = (b.load(own(CALLERS_COUNTER), Width::Word, OnFault::SkipStatement), b.constant(INSTANCES));
        let inside = b.compute(Op::Below, &[number, count]);
        b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
        let (number, step) = (b.compute(Op::Gate, &[number, inside]), b.constant(8 * INSTANCE_BYTES));
        let by = b.compute(Op::MulU32, &[number, step]);
        b.compute(Op::AddU32, &[Register::Ar2.into(), by])
    };
    b.begin_statement();
    b.set(Register::Ar2, 0x8400_0000);
    let to = instance(b);
    let block = b.constant(block);
    let mut pointer = b.constant(0x8400_0000 | (8 * byte));
    if farther > 0 {
        let (number, step) = (b.load(own(CALLERS_COUNTER), Width::Word, OnFault::SkipStatement), b.constant(8 * farther));
        let by = b.compute(Op::MulU32, &[number, step]);
        pointer = b.compute(Op::AddU32, &[pointer, by]);
    }
    let field = |pointer: Var, offset: u32| Place::Indirect { area: Area::InstanceData, pointer, offset: moved as u32 + offset };
    b.store(field(to, NUMBER), Width::Word, block);
    b.store(field(to, POINTER), Width::DoubleWord, pointer);
    let of = instance(b);
    b.copy(Register::Ar2, of);
    if moved != 0 {
        let by = b.constant(moved);
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
    }
    let parameter = b.constant(parameter);
    b.push(Inst::PassParameter { src: parameter });
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(1)), parameters: 1 });
    b.begin_statement();
    b.set(Register::Ar2, 0x8400_0000);
    let (number, step) = (b.load(own(CALLERS_COUNTER), Width::Word, OnFault::SkipStatement), b.constant(16));
    let by = b.compute(Op::MulU32, &[number, step]);
    let pointer = b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
    b.store(Place::Indirect { area: Area::InstanceData, pointer, offset: ELEMENTS }, Width::Word, number);
    counts(b, own(CALLERS_COUNTER), INSTANCES - 1 - moved.min(1), 1);
}

fn begin(b: &mut Builder) {
    begin_with_instance(b, CALLER);
}

/// Changes a few bytes and the budget, sometimes, and goes on.
fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 40]);
    for _ in 0..dice.of(&[0, 0, 1, 1, 3]) {
        let range = machine.memory.layout.data_blocks[&1].clone();
        // Mostly what is counted with, and pointers.
        let of_instance = dice.roll(2 * INSTANCES) * INNER;
        let near = dice.of(&[18, 18, 12, 14, 16]);
        let byte = match dice.roll(4) {
            0 => dice.roll(DATA_BYTES as u64),
            1 => u64::from(CALLERS_COUNTER / 8) + dice.roll(2),
            _ => of_instance + near + dice.roll(2),
        };
        machine.memory.arena[range.start + byte as usize] = dice.of(&[0, 1, 2, 3, 7, 0x80, 0x84, 0xFF]);
    }
    Reaction::Continue
}

fn layout_of(program: &Program) -> Layout {
    let mut layout = layout_with(program, DATA_BYTES);
    layout.data_blocks.insert(2, layout.size..layout.size + OTHER_BYTES);
    layout.size += OTHER_BYTES;
    layout
}

#[test]
fn elements_behind_pointers_that_are_handed_on_are_the_same_on_all_engines() {
    let mut asked = 0;
    for seed in seeds(PROGRAMS) {
        let build = |number: u16| {
            move |b: &mut Builder| match number {
                0 => begin(b),
                CALLER => caller(b, &Handed::random(&mut Dice(seed * 100))),
                number => block(b, &mut Dice(seed * 100 + u64::from(number)), number),
            }
        };
        let builders: Vec<_> = (0..=CALLER).map(|number| (number, build(number))).collect();
        let id = |number: u16| if number == 0 { BlockId::ob(1) } else { BlockId::fb(number) };
        let parts: Vec<_> = builders.iter().map(|(number, build)| (id(*number), LOCAL_BYTES, build as &dyn Fn(&mut Builder))).collect();
        let program = program(&parts);
        let layout = layout_of(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[5, 40, 400, 4000]);
            for number in [1, 2] {
                let range = machine.memory.layout.data_blocks[&number].clone();
                machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            }
        };
        let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        asked += all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", listing())).asked.len();
    }
    assert!(asked > 200, "{asked} questions");
}

/// What a function block is made of, a closure for each statement, and what it calls.
type Body<'a> = &'a dyn Fn(&mut Builder);

/// Runs blocks 1 and 2 beside the caller. At each question in iteration somebody writes to a byte of data block 1, or not.
fn agree(handed: &Handed, first: Body<'_>, second: Body<'_>, written: Option<(usize, u8)>) {
    let program = program(&[
        (BlockId::ob(1), LOCAL_BYTES, &begin),
        (BlockId::fb(CALLER), LOCAL_BYTES, &|b| caller(b, handed)),
        (BlockId::fb(1), LOCAL_BYTES, first),
        (BlockId::fb(2), LOCAL_BYTES, second),
    ]);
    let layout = layout_of(&program);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let engines = engines(&program, &layout);
    for which in 0..40 {
        let outcome = |engine: Arc<dyn Engine>| {
            let answer = |machine: &mut Machine, _: &str, asked: usize| {
                // Nobody asks any more behind what is written, until it has been used.
                machine.budget = if written.is_some() && asked != which { 0 } else { 1000 };
                if let Some((byte, value)) = written.filter(|_| asked == which) {
                    let start = machine.memory.layout.data_blocks[&1].start;
                    machine.memory.arena[start + byte] = value;
                }
                if asked > 200 { Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> }) } else { Reaction::Continue }
            };
            run(engine.as_ref(), &layout, &entry, &|machine| machine.budget = 1000 * i64::from(written.is_none()), &answer)
        };
        all_engines_agree(&engines, false, &outcome, &|| format!("question {which}"));
    }
}

/// `counter := value`.
fn begins_to_count(b: &mut Builder, value: u64) {
    b.begin_statement();
    let value = b.constant(value);
    b.store(own(COUNTER), Width::Word, value);
}

/// `p[counter] := value`, where nobody looks at the index.
fn writes_element(b: &mut Builder, value: u64) {
    b.begin_statement();
    let number = b.load(own(NUMBER), Width::Word, OnFault::SkipStatement);
    let pointer = b.load(own(POINTER), Width::DoubleWord, OnFault::SkipStatement);
    let (index, step) = (b.load(own(COUNTER), Width::Word, OnFault::SkipStatement), b.constant(16));
    let by = b.compute(Op::MulU32, &[index, step]);
    let pointer = b.compute(Op::AddU32, &[pointer, by]);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    let value = b.constant(value);
    b.store(Place::Crossing { pointer, offset: 0 }, Width::Word, value);
}

/// A call behind which only one who follows AR2 knows what it is.
fn calls(b: &mut Builder) {
    b.begin_statement();
    b.store(SAVED, Width::DoubleWord, Register::Ar2);
    let by = b.constant(8 * INNER);
    b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
    b.push(Inst::Call { callee: Callee::Block(BlockId::fb(2)), parameters: 0 });
    let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
    b.copy(Register::Ar2, saved);
}

fn does_little(b: &mut Builder) {
    b.begin_statement();
    let value = b.constant(1);
    b.store(own(0), Width::Byte, value);
}

/// A pointer to what is no instance, from where an index of 14 goes to the counter of the caller.
const FROM_COUNTER: Handed = Handed { moved: 0, block: 1, byte: CALLERS_COUNTER as u64 / 8 - 28, farther: 0, parameter: 0 };
/// The byte of the last instance's counter, behind all pointers.
const LAST_COUNTER: u64 = (INSTANCES - 1) * INSTANCE_BYTES + COUNTER as u64 / 8;

#[test]
fn an_index_behind_a_pointer_that_is_changed_while_its_block_runs_writes_where_it_leads_now() {
    let block = |b: &mut Builder| {
        begins_to_count(b, 0);
        writes_element(b, 0x0505);
        calls(b);
        counts(b, own(COUNTER), 2, 1);
    };
    agree(&FROM_COUNTER, &block, &does_little, Some((COUNTER as usize / 8 + 1, 14)));
}

#[test]
fn a_pointer_to_what_its_block_counts_with_is_no_pointer_to_anything_else() {
    let block = |b: &mut Builder| {
        begins_to_count(b, 0);
        let index = (u64::from(CALLERS_COUNTER) / 8 - LAST_COUNTER) / 2;
        writes_element(b, index);
        writes_element(b, 0x0505);
    };
    agree(&Handed { byte: LAST_COUNTER, ..FROM_COUNTER }, &block, &does_little, None);
}

#[test]
fn a_pointer_that_was_handed_on_and_is_changed_then_leads_where_it_leads_now() {
    let block = |b: &mut Builder| {
        b.begin_statement();
        let inner = 8 * INNER as u32;
        let number = b.load(own(NUMBER), Width::Word, OnFault::SkipStatement);
        let pointer = b.load(own(POINTER), Width::DoubleWord, OnFault::SkipStatement);
        b.store(own(inner + NUMBER), Width::Word, number);
        b.store(own(inner + POINTER), Width::DoubleWord, pointer);
        b.store(SAVED, Width::DoubleWord, Register::Ar2);
        let by = b.constant(u64::from(inner));
        b.compute_into(Register::Ar2, Op::AddU32, &[Register::Ar2.into(), by]);
        b.push(Inst::Call { callee: Callee::Block(BlockId::fb(2)), parameters: 0 });
        let saved = b.load(SAVED, Width::DoubleWord, OnFault::SkipStatement);
        b.copy(Register::Ar2, saved);
    };
    let inner = |b: &mut Builder| {
        begins_to_count(b, 0);
        writes_element(b, 0x0505);
        counts(b, own(COUNTER), 2, 1);
    };
    // The number of the data block where the counter of the caller lies.
    let handed = Handed { byte: u64::from(CALLERS_COUNTER) / 8, block: 2, ..FROM_COUNTER };
    agree(&handed, &block, &inner, Some((INNER as usize + NUMBER as usize / 8 + 1, 1)));
}

#[test]
fn a_pointer_that_is_a_number_too_is_that_number() {
    let block = |b: &mut Builder| {
        b.begin_statement();
        let number = b.load(own(NUMBER), Width::Word, OnFault::SkipStatement);
        let pointer = b.load(own(POINTER), Width::DoubleWord, OnFault::SkipStatement);
        let mask = b.constant(0xF8);
        let by = b.compute(Op::AndU32, &[pointer, mask]);
        let pointer = b.compute(Op::AddU32, &[pointer, by]);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        let value = b.constant(0x0505);
        b.store(Place::Crossing { pointer, offset: 8 * 10 }, Width::Word, value);
    };
    // 16#430 bits, and 16#30 more.
    agree(&Handed { byte: 134, ..FROM_COUNTER }, &block, &does_little, None);
}

#[test]
fn a_parameter_that_leads_to_what_a_block_counts_with_changes_its_index() {
    let block = |b: &mut Builder| {
        begins_to_count(b, 0);
        b.begin_statement();
        let (pointer, value) = (b.temporary(), b.constant(14));
        b.push(Inst::Parameter { dst: pointer, index: 0 });
        b.store(Place::Crossing { pointer, offset: 0 }, Width::Word, value);
        writes_element(b, 0x0505);
    };
    agree(&Handed { parameter: 0x8500_0000 | (8 * LAST_COUNTER), ..FROM_COUNTER }, &block, &does_little, None);
}
