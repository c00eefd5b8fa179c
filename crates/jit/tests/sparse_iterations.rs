//! Loops that do something in few of their iterations, as a bit or a byte of an array tells: whatever these iterations do, whoever looks
//! between them and wherever the arrays end, memory, registers and questions are those of the interpreter.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout_with, program, run, run_beside};

const PROGRAMS: u64 = 200;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 30;
/// An array of bits, a list of what was found, and an array of bytes up to the end of the memory.
const BITS_BYTES: u32 = 200;
const LIST_BYTES: u32 = 400;
const DATA_BYTES: usize = 1400;
const BYTES: u32 = BITS_BYTES + LIST_BYTES;

/// Variables in bit memory.
const COUNTER: u32 = 0;
const LIMIT: u32 = 4;
const FOUND: u32 = 8;
const PREVIOUS: u32 = 12;
const BESIDE: u32 = 16;
const SAME: u32 = 20;
const BIT: u32 = 24;
const INNER: u32 = 28;

/// How a loop counts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Type {
    Dint,
    Int,
    Udint,
    Uint,
}

impl Type {
    fn width(self) -> Width {
        if matches!(self, Self::Dint | Self::Udint) { Width::DoubleWord } else { Width::Word }
    }

    fn add(self) -> Op {
        if self.width() == Width::DoubleWord { Op::AddU32 } else { Op::AddU16 }
    }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

struct Maker {
    /// Where the variables lie.
    area: Area,
    of: Type,
    /// Whether bytes tell what an iteration does, or bits.
    bytes: bool,
    /// The index of the first element.
    low: u64,
    /// An index has to be below it.
    below: Option<u64>,
    /// What was found: in bit memory, or in the midst of the bits.
    found: Place,
    /// Whether a counter of 16 bits counts as a number with sign where it is an index.
    extends: bool,
    /// Whether bytes are looked for in the midst of bytes, which is an error.
    askew: bool,
}

impl Maker {
    /// A variable.
    fn at(&self, byte: u32) -> Place {
        Place::Fixed { area: self.area, position: 8 * byte }
    }

    /// The counter as a number of 32 bits.
    fn number(&self, b: &mut Builder) -> Var {
        let counter = load(b, self.at(COUNTER), self.of.width());
        if self.extends { b.compute(Op::Extend16, &[counter]) } else { counter }
    }

    /// What the present iteration looks at, or another one so many elements ahead.
    fn element(&self, b: &mut Builder, ahead: u64) -> (Place, Option<Var>) {
        let mut index = self.number(b);
        let mut inside = None;
        if let Some(limit) = self.below {
            let limit = b.constant(limit);
            let below = b.compute(Op::Below, &[index, limit]);
            b.push(Inst::Require { condition: below, code: NOTED | 0x22, register: index });
            index = b.compute(Op::Gate, &[index, below]);
            inside = Some(below);
        }
        if ahead != self.low {
            let low = b.constant(self.low.wrapping_sub(ahead) & 0xFFFF_FFFF);
            index = b.compute(Op::SubU32, &[index, low]);
        }
        let mut offset = 0;
        if self.bytes {
            let three = b.constant(3);
            index = b.compute(Op::Shl32, &[index, three]);
            offset = 8 * BYTES + u32::from(self.askew);
        }
        let first = b.constant(0x8400_0000);
        let pointer = b.compute(Op::AddU32, &[first, index]);
        (Place::Indirect { area: Area::SharedData, pointer, offset }, inside)
    }

    /// Whether an iteration does nothing, where most bits and bytes are 0.
    fn is_idle(&self, b: &mut Builder, dice: &mut Dice) -> Var {
        let (place, inside) = self.element(b, 0);
        let width = if self.bytes { Width::Byte } else { Width::Bit };
        let mut value = load(b, place, width);
        if let Some(inside) = inside
            && dice.roll(2) == 0
        {
            value = b.compute(Op::Gate, &[value, inside]);
        }
        let mut does = if self.bytes {
            let number = b.constant(dice.of(&[0, 0, 0, 0, 1, 7, 200]));
            let op = dice.of(&[Op::Differ, Op::Differ, Op::NeI32, Op::GtI32, Op::GtI16, Op::Equal, Op::LtI32, Op::GeI16, Op::LeI32]);
            b.compute(op, &[value, number])
        } else {
            value
        };
        match dice.roll(6) {
            0 => {
                let bit = load(b, self.at(BIT), Width::Bit);
                does = b.compute(dice.of(&[Op::And, Op::Or, Op::AndNot, Op::Xor]), &[does, bit]);
            }
            1 => {
                let (place, _) = self.element(b, dice.of(&[1, 2, 9]));
                let mut other = load(b, place, width);
                if self.bytes {
                    let number = b.constant(0);
                    other = b.compute(Op::Differ, &[other, number]);
                }
                does = b.compute(dice.of(&[Op::And, Op::Or, Op::AndNot]), &[does, other]);
            }
            _ => {}
        }
        if dice.roll(8) == 0 { does } else { b.compute(Op::Not, &[does]) }
    }

    /// A statement of an iteration that does something.
    fn statement(&self, b: &mut Builder, dice: &mut Dice, behind: u32) {
        b.begin_statement();
        match dice.roll(13) {
            12 => {
                let other = b.constant(9);
                b.store(self.at(SAME), Width::Word, other);
            }
            10 => {
                let (found, same) = (load(b, self.found, Width::DoubleWord), load(b, self.at(SAME), Width::Word));
                let sum = b.compute(Op::AddU32, &[found, same]);
                b.store(self.found, Width::DoubleWord, sum);
            }
            9 | 11 => b.push(Inst::Call { callee: Callee::Block(BlockId { kind: BlockKind::Function, number: 1 }), parameters: 0 }),
            0 | 1 => {
                let found = load(b, self.found, Width::DoubleWord);
                let more = b.constant(dice.of(&[1, 1, 3]));
                let sum = b.compute(Op::AddU32, &[found, more]);
                b.store(self.found, Width::DoubleWord, sum);
            }
            2 => {
                let (counter, previous) = (self.number(b), load(b, self.at(PREVIOUS), Width::DoubleWord));
                let gap = b.compute(Op::SubU32, &[counter, previous]);
                let found = load(b, self.found, Width::DoubleWord);
                let sum = b.compute(Op::AddU32, &[found, gap]);
                b.store(self.found, Width::DoubleWord, sum);
                b.store(self.at(PREVIOUS), Width::DoubleWord, counter);
            }
            3 => {
                // What was found is noted in a list.
                let found = load(b, self.found, Width::DoubleWord);
                let limit = b.constant(u64::from(LIST_BYTES) / 4);
                let inside = b.compute(Op::Below, &[found, limit]);
                b.push(Inst::Require { condition: inside, code: NOTED | 0x23, register: found });
                let index = b.compute(Op::Gate, &[found, inside]);
                let five = b.constant(5);
                let offset = b.compute(Op::Shl32, &[index, five]);
                let first = b.constant(0x8400_0000);
                let pointer = b.compute(Op::AddU32, &[first, offset]);
                let value = self.number(b);
                b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 8 * BITS_BYTES }, Width::DoubleWord, value);
            }
            4 | 5 => {
                // An element further ahead is crossed out, or set.
                let (place, _) = self.element(b, dice.of(&[1, 2, 5, 40]));
                let value = b.constant(dice.of(&[0, 0, 1]));
                b.store(place, if self.bytes { Width::Byte } else { Width::Bit }, value);
            }
            6 if dice.roll(3) == 0 => {
                // The iterations that follow look at something else.
                let bit = b.constant(dice.roll(2));
                b.store(self.at(BIT), Width::Bit, bit);
            }
            7 if dice.roll(4) == 0 => {
                let (counter, more) = (load(b, self.at(COUNTER), self.of.width()), b.constant(dice.of(&[1, 7])));
                let next = b.compute(self.of.add(), &[counter, more]);
                b.store(self.at(COUNTER), self.of.width(), next);
            }
            8 if dice.roll(4) == 0 => {
                // It ends the loop.
                let (found, limit) = (load(b, self.found, Width::DoubleWord), b.constant(9));
                let enough = b.compute(Op::GtI32, &[found, limit]);
                b.push(Inst::Branch { condition: enough, to: Target(behind) });
            }
            _ => {
                let (found, mask) = (load(b, self.found, Width::DoubleWord), b.constant(0x55));
                let mixed = b.compute(Op::XorU32, &[found, mask]);
                b.store(self.found, Width::DoubleWord, mixed);
            }
        }
    }

    /// What every iteration does first.
    fn before(&self, b: &mut Builder, what: u64, behind: u32) {
        b.begin_statement();
        match what {
            4 => b.push(Inst::Call { callee: Callee::Block(BlockId { kind: BlockKind::Function, number: 1 }), parameters: 0 }),
            0 => {
                let same = b.constant(5);
                b.store(self.at(SAME), Width::Word, same);
            }
            1 => {
                // It ends the loop.
                let bit = load(b, self.at(BIT), Width::Bit);
                b.push(Inst::Branch { condition: bit, to: Target(behind) });
            }
            2 => {
                let (place, _) = self.element(b, 3);
                let value = b.constant(1);
                b.store(place, if self.bytes { Width::Byte } else { Width::Bit }, value);
            }
            _ => {
                let (number, limit) = (load(b, self.at(BESIDE), Width::Word), b.constant(90));
                let below = b.compute(Op::Below, &[number, limit]);
                b.push(Inst::Require { condition: below, code: NOTED | 0x24, register: number });
            }
        }
    }

    /// Counts, and decides about another iteration.
    fn again(&self, b: &mut Builder, dice: &mut Dice, head: Target, limit: u64) {
        b.begin_statement();
        let (counter, one) = (load(b, self.at(COUNTER), self.of.width()), b.constant(1));
        let next = b.compute(self.of.add(), &[counter, one]);
        b.store(self.at(COUNTER), self.of.width(), next);
        let limit = match dice.roll(2) {
            0 => b.constant(limit),
            // It may be beyond what the counter can be.
            _ if matches!(self.of, Type::Uint | Type::Udint) => load(b, self.at(LIMIT), Width::DoubleWord),
            _ => load(b, self.at(LIMIT), self.of.width()),
        };
        let op = match self.of {
            Type::Dint => dice.of(&[Op::LeI32, Op::LtI32]),
            Type::Int => dice.of(&[Op::LeI16, Op::LtI16]),
            _ => dice.of(&[Op::LeU64, Op::Below]),
        };
        let compared = match dice.roll(12) {
            0 => counter,
            1 => load(b, self.at(BESIDE), Width::Word),
            _ => next,
        };
        let mut condition = b.compute(op, &[compared, limit]);
        let overflows = match self.of {
            Type::Dint => Some(Op::AddOverflowsI32),
            Type::Int => Some(Op::AddOverflowsI16),
            _ => None,
        };
        if let Some(overflows) = overflows.filter(|_| dice.roll(2) == 0) {
            let overflow = b.compute(overflows, &[counter, one]);
            condition = b.compute(Op::AndNot, &[condition, overflow]);
        }
        b.push(Inst::Branch { condition, to: head });
    }

    /// A loop in an iteration that does something: it crosses out elements further ahead.
    fn inner(&self, b: &mut Builder, dice: &mut Dice) {
        b.begin_statement();
        let number = self.number(b);
        b.store(self.at(INNER), Width::DoubleWord, number);
        let head = b.next();
        b.begin_statement();
        let index = load(b, self.at(INNER), Width::DoubleWord);
        let count = b.constant(if self.bytes { DATA_BYTES as u64 - u64::from(BYTES) } else { 8 * u64::from(BITS_BYTES) });
        let inside = b.compute(Op::Below, &[index, count]);
        let mut index = b.compute(Op::Gate, &[index, inside]);
        if self.bytes {
            let three = b.constant(3);
            index = b.compute(Op::Shl32, &[index, three]);
        }
        let first = b.constant(0x8400_0000);
        let pointer = b.compute(Op::AddU32, &[first, index]);
        let value = b.constant(dice.of(&[0, 0, 1]));
        let offset = if self.bytes { 8 * BYTES } else { 0 };
        b.store(Place::Indirect { area: Area::SharedData, pointer, offset }, if self.bytes { Width::Byte } else { Width::Bit }, value);
        b.begin_statement();
        let (inner, step) = (load(b, self.at(INNER), Width::DoubleWord), b.constant(dice.of(&[1, 3, 50])));
        let next = b.compute(Op::AddU32, &[inner, step]);
        b.store(self.at(INNER), Width::DoubleWord, next);
        let limit = b.constant(dice.of(&[60, 300, 500]));
        let condition = b.compute(Op::LtI32, &[next, limit]);
        b.push(Inst::Branch { condition, to: head });
    }
}

/// The number of a statement.
fn number_of(Target(statement): Target) -> u32 {
    statement
}

fn one_loop(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let area = dice.of(&[Area::BitMemory, Area::BitMemory, Area::Local]);
    let at = |byte: u32| Place::Fixed { area, position: 8 * byte };
    let of = dice.of(&[Type::Dint, Type::Int, Type::Udint, Type::Uint]);
    let bytes = dice.roll(2) == 0;
    let elements = if bytes { DATA_BYTES as u64 - u64::from(BYTES) } else { 8 * u64::from(BITS_BYTES) };
    let most = match of {
        Type::Dint => i32::MAX as u64,
        Type::Int => i16::MAX as u64,
        Type::Udint => u64::from(u32::MAX),
        Type::Uint => u64::from(u16::MAX),
    };
    let half = most / 2;
    let ends = if of.width() == Width::DoubleWord { 0xFFFF_FFFF } else { 0xFFFF };
    // From a number below 0, over an end of the type as it is not meant to be, or from somewhere.
    let is_odd = dice.roll(6) == 0;
    let first = match of {
        Type::Int | Type::Dint if is_odd || dice.roll(6) == 0 => ends - 15,
        Type::Uint | Type::Udint if is_odd => half - 20,
        Type::Uint if dice.roll(3) == 0 => most - 70,
        _ => dice.of(&[0, 0, 0, 1, 2, 13, 500, most - 70]),
    };
    let iterations = dice.of(&[3, 60, 130, elements - 13, elements - 2, elements]);
    let limit = match first {
        _ if first > most => (first + iterations) & ends,
        first if dice.roll(12) == 0 => first.saturating_sub(1),
        first => (first + iterations).min(most - dice.roll(3)),
    };
    let extends = (of == Type::Int) != (is_odd && of.width() == Width::Word);
    let negative = if extends && first > 0x7FFF { 0xFFFF_0000 } else { 0 };
    let low = if first > 1000 || dice.roll(4) == 0 { first | negative } else { 0 };
    let below = (low == 0 && dice.roll(2) == 0).then(|| dice.of(&[100, elements, elements - 9]));
    let found = match dice.roll(6) {
        0 => Place::Fixed { area: Area::SharedData, position: 8 * dice.of(&[3, 20]) },
        _ => at(FOUND),
    };
    let askew = bytes && dice.roll(12) == 0;
    let it = Maker { area, of, bytes, low, below, found, extends, askew };
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    let beyond = u64::from(of == Type::Uint && dice.roll(if first == most - 70 { 2 } else { 4 }) == 0) << 16;
    let unsigned = matches!(of, Type::Uint | Type::Udint);
    for (variable, value, width) in
        [(COUNTER, first, of.width()), (LIMIT, limit + beyond, if unsigned { Width::DoubleWord } else { of.width() })]
    {
        b.begin_statement();
        let value = b.constant(value);
        b.store(at(variable), width, value);
    }
    let head = b.next();
    let (simple, inner) = (dice.roll(3) == 0, dice.roll(4) == 0);
    let statements = if simple { 1 } else { 1 + dice.roll(3) as u32 };
    let beside = dice.roll(3) == 0;
    let before = (dice.roll(4) == 0).then(|| dice.roll(5));
    let (twice, same) = (dice.roll(4) == 0, dice.roll(4) == 0);
    let mut next = number_of(head);
    next += u32::from(before.is_some());
    next += u32::from(twice);
    let behind_all = next + 1 + statements + if inner && !simple { 3 } else { 0 };
    let behind_loop = behind_all + u32::from(beside) + u32::from(same) + 1;
    if let Some(before) = before {
        it.before(b, before, behind_loop);
    }
    if twice {
        // The iteration does something for one reason or for another one.
        b.begin_statement();
        let idle = it.is_idle(b, &mut dice);
        let condition = b.compute(Op::Not, &[idle]);
        b.push(Inst::Branch { condition, to: Target(next + 1) });
    }
    b.begin_statement();
    let condition = it.is_idle(b, &mut dice);
    b.push(Inst::Branch { condition, to: Target(behind_all) });
    for _ in 0..statements {
        match simple {
            true => it.statement(b, &mut Dice(0), behind_loop),
            false => it.statement(b, &mut dice, behind_loop),
        }
    }
    if inner && !simple {
        it.inner(b, &mut dice);
    }
    assert_eq!(number_of(b.next()), behind_all);
    if beside {
        b.begin_statement();
        let (number, step) = (load(b, at(BESIDE), Width::Word), b.constant(dice.of(&[1, 3, 0xFFFF])));
        let next = b.compute(Op::AddU16, &[number, step]);
        b.store(at(BESIDE), Width::Word, next);
    }
    if same {
        b.begin_statement();
        let number = b.constant(5);
        b.store(at(SAME), Width::Word, number);
    }
    it.again(b, &mut dice, head, limit);
    b.begin_statement();
    b.push(Inst::Return);
}

/// Counts in bit memory.
fn called_block(b: &mut Builder) {
    called_block_statement(b);
    b.begin_statement();
    b.push(Inst::Return);
}

fn called_block_statement(b: &mut Builder) {
    b.begin_statement();
    let place = Place::Fixed { area: Area::BitMemory, position: 8 * FOUND };
    let (found, one) = (load(b, place, Width::DoubleWord), b.constant(1));
    let sum = b.compute(Op::AddU32, &[found, one]);
    b.store(place, Width::DoubleWord, sum);
}

/// What the memory is made with.
fn dice_of(seed: u64) -> Dice {
    Dice(seed + 5_000_000)
}

fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    // Who is told of what is noted changes nothing.
    if !what.starts_with("safe point") {
        return Reaction::Continue;
    }
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 3, 20, 58, 64, 100, 1000, 100_000]);
    match dice.roll(8) {
        0 => {
            let start = machine.memory.layout.bit_memory.start + dice.of(&[COUNTER + 3, FOUND + 3, BIT, BESIDE + 1]) as usize;
            machine.memory.arena[start] = dice.of(&[0, 1, 0x20]);
        }
        1 => {
            let start = machine.memory.layout.data_blocks[&1].start;
            machine.memory.arena[start + dice.roll(DATA_BYTES as u64) as usize] = dice.of(&[0, 0, 1, 0x10]);
        }
        _ => {}
    }
    Reaction::Continue
}

#[test]
fn loops_that_seldom_do_something_do_the_same_on_all_engines() {
    let mut ended = 0;
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let called = BlockId { kind: BlockKind::Function, number: 1 };
        let program = program(&[(block, 40, &|b| one_loop(b, seed)), (called, 0, &called_block)]);
        let mut layout = layout_with(&program, DATA_BYTES);
        // Something may lie behind the data.
        layout.size += dice_of(seed).of(&[0, 3, 64]) as usize;
        let engines = engines(&program, &layout);
        for memory in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(11 * seed + memory);
                machine.budget = dice.of(&[1, 50, 1000, 100_000, 100_000]);
                let data = machine.memory.layout.data_blocks[&1].clone();
                // From no iteration that does something to all.
                let seldom = dice.of(&[1, 4, 12, 40, 400]);
                let mut one = || if dice.roll(seldom) == 0 { dice.of(&[1, 7, 8, 0x10, 0x80, 200, 0xFF]) } else { 0 };
                machine.memory.arena[data].fill_with(&mut one);
                let start = machine.memory.layout.bit_memory.start + BIT as usize;
                machine.memory.arena[start] = dice.roll(2) as u8;
            };
            let entry = Entry { block, start_information: [7; 20], registers: None };
            let outcome =
                |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(3 * seed + memory), &meddle);
            let what = || format!("program {seed}, memory {memory}\n{}", program.code[&block].code);
            let outcome = all_engines_agree(&engines, true, &outcome, &what);
            ended += usize::from(outcome.asked.len() < QUESTIONS_MAX);
        }
    }
    assert!(ended > 400, "only {ended} runs came to their end");
}

/// A loop over bits from a number on, with statements that an iteration makes whose bit is set and others that each iteration makes.
fn over_bits(b: &mut Builder, from: (u64, u64), some: &[&dyn Fn(&mut Builder)], all: &[&dyn Fn(&mut Builder)]) {
    over_bits_and_note(b, from, &|_| (), some, all);
}

/// The same, and something else is done where each bit is looked at.
fn over_bits_and_note(
    b: &mut Builder,
    (first, below): (u64, u64),
    note: &dyn Fn(&mut Builder),
    some: &[&dyn Fn(&mut Builder)],
    all: &[&dyn Fn(&mut Builder)],
) {
    let at = |byte: u32| Place::Fixed { area: Area::BitMemory, position: 8 * byte };
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    let first = b.constant(first);
    b.store(at(COUNTER), Width::DoubleWord, first);
    let head = b.next();
    b.begin_statement();
    let (index, limit) = (load(b, at(COUNTER), Width::DoubleWord), b.constant(below));
    let inside = b.compute(Op::Below, &[index, limit]);
    b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: index });
    note(b);
    let index = b.compute(Op::Gate, &[index, inside]);
    let bit = load(b, Place::Indirect { area: Area::SharedData, pointer: index, offset: 0 }, Width::Bit);
    let condition = b.compute(Op::Not, &[bit]);
    b.push(Inst::Branch { condition, to: Target(number_of(head) + 1 + some.len() as u32) });
    for statement in some.iter().chain(all) {
        b.begin_statement();
        statement(b);
    }
    b.begin_statement();
    let (counter, one, limit) = (load(b, at(COUNTER), Width::DoubleWord), b.constant(1), b.constant(400));
    let next = b.compute(Op::AddU32, &[counter, one]);
    b.store(at(COUNTER), Width::DoubleWord, next);
    let condition = b.compute(Op::LtI32, &[next, limit]);
    b.push(Inst::Branch { condition, to: head });
    b.begin_statement();
    b.push(Inst::Return);
}

/// Runs a program with bits that are set here and there, and with a budget that is the same behind each question.
fn compare(body: &dyn Fn(&mut Builder), budget: i64, every: usize) {
    let called = BlockId { kind: BlockKind::Function, number: 1 };
    let program = program(&[(BlockId::ob(1), 40, &body), (called, 0, &called_block)]);
    let layout = layout_with(&program, DATA_BYTES);
    let prepare = |machine: &mut Machine| {
        machine.budget = budget;
        let start = machine.memory.layout.data_blocks[&1].start;
        (0..400).step_by(every).for_each(|bit| machine.memory.arena[start + bit / 8] |= 1 << (bit % 8));
    };
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let answer = |machine: &mut Machine, what: &str, asked: usize| {
        if asked > 500 && what.starts_with("safe point") {
            return Reaction::Stop(StopReason { event: 0x4562, place: None });
        }
        if what.starts_with("safe point") {
            machine.budget = budget;
        }
        Reaction::Continue
    };
    let outcome = |engine: Arc<dyn Engine>| run(engine.as_ref(), &layout, &entry, &prepare, &answer);
    let what = || format!("budget {budget}\n{}", program.code[&BlockId::ob(1)].code);
    all_engines_agree(&engines(&program, &layout), true, &outcome, &what);
}

#[test]
fn the_budget_lasts_for_blocks_that_iterations_enter_behind_those_that_were_passed() {
    let call = |b: &mut Builder| {
        b.push(Inst::Call { callee: Callee::Block(BlockId { kind: BlockKind::Function, number: 1 }), parameters: 0 });
    };
    // Such iterations are not done at once.
    let notes = |b: &mut Builder| {
        let found = load(b, Place::Fixed { area: Area::BitMemory, position: 8 * FOUND }, Width::DoubleWord);
        let limit = b.constant(20);
        let inside = b.compute(Op::Below, &[found, limit]);
        b.push(Inst::Require { condition: inside, code: NOTED | 0x23, register: found });
        let (index, five) = (b.compute(Op::Gate, &[found, inside]), b.constant(5));
        let pointer = b.compute(Op::Shl32, &[index, five]);
        b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 8 * BITS_BYTES }, Width::DoubleWord, found);
    };
    for every in [19, 58, 61] {
        for budget in 1..150 {
            compare(&|b| over_bits(b, (1, 400), &[&call, &notes, &call], &[]), budget, every);
        }
    }
}

#[test]
fn what_each_iteration_writes_is_not_written_where_none_was_passed() {
    let at = |byte: u32| Place::Fixed { area: Area::BitMemory, position: 8 * byte };
    let adds = |b: &mut Builder| {
        let (found, same) = (load(b, at(FOUND), Width::DoubleWord), load(b, at(SAME), Width::Word));
        let sum = b.compute(Op::AddU32, &[found, same]);
        b.store(at(FOUND), Width::DoubleWord, sum);
        b.push(Inst::Call { callee: Callee::Block(BlockId { kind: BlockKind::Function, number: 1 }), parameters: 0 });
    };
    let writes = |b: &mut Builder| {
        let number = b.constant(5);
        b.store(at(SAME), Width::Word, number);
    };
    // Beyond its limit an index counts as 0, which is the only one whose bit is set.
    compare(&|b| over_bits(b, (25, 20), &[&adds], &[&writes]), 100_000, 1000);
    compare(&|b| over_bits(b, (0, 20), &[&adds], &[&writes]), 100_000, 1000);
}

#[test]
fn what_is_noted_where_a_iteration_looks_is_there_where_it_does_something() {
    let at = |byte: u32| Place::Fixed { area: Area::BitMemory, position: 8 * byte };
    let notes = |b: &mut Builder| b.set(Register::Accu1, 5);
    // Such iterations are not done at once.
    let lists = |b: &mut Builder| {
        let (found, more) = (load(b, at(FOUND), Width::DoubleWord), b.constant(1));
        let next = b.compute(Op::AddU32, &[found, more]);
        let limit = b.constant(u64::from(LIST_BYTES) / 4);
        let inside = b.compute(Op::Below, &[next, limit]);
        b.push(Inst::Require { condition: inside, code: NOTED | 0x23, register: next });
        let (index, five) = (b.compute(Op::Gate, &[next, inside]), b.constant(5));
        let pointer = b.compute(Op::Shl32, &[index, five]);
        let list = Place::Indirect { area: Area::SharedData, pointer, offset: 8 * BITS_BYTES };
        let before = load(b, list, Width::DoubleWord);
        let sum = b.compute(Op::AddU32, &[before, Register::Accu1.into()]);
        b.store(list, Width::DoubleWord, sum);
        b.store(at(FOUND), Width::DoubleWord, index);
        b.set(Register::Accu1, 9);
    };
    for every in [1, 2, 19, 58, 390] {
        compare(&|b| over_bits_and_note(b, (1, 400), &notes, &[&lists], &[]), 100_000, every);
    }
}

#[test]
fn a_counter_without_sign_that_has_no_end_iterations_over() {
    let at = |byte: u32| Place::Fixed { area: Area::BitMemory, position: 8 * byte };
    let body = |b: &mut Builder| {
        b.begin_statement();
        let number = b.constant(1);
        b.push(Inst::Open { register: DataRegister::Shared, number });
        let (first, limit) = (b.constant(65_500), b.constant(70_000));
        b.store(at(COUNTER), Width::Word, first);
        b.store(at(LIMIT), Width::DoubleWord, limit);
        let head = b.next();
        b.begin_statement();
        let (counter, low) = (load(b, at(COUNTER), Width::Word), b.constant(65_500));
        let index = b.compute(Op::SubU32, &[counter, low]);
        let bit = load(b, Place::Indirect { area: Area::SharedData, pointer: index, offset: 0 }, Width::Bit);
        let condition = b.compute(Op::Not, &[bit]);
        b.push(Inst::Branch { condition, to: Target(number_of(head) + 2) });
        called_block_statement(b);
        b.begin_statement();
        let (counter, one) = (load(b, at(COUNTER), Width::Word), b.constant(1));
        let next = b.compute(Op::AddU16, &[counter, one]);
        b.store(at(COUNTER), Width::Word, next);
        let limit = load(b, at(LIMIT), Width::DoubleWord);
        let condition = b.compute(Op::LeU64, &[next, limit]);
        b.push(Inst::Branch { condition, to: head });
        b.begin_statement();
        b.push(Inst::Return);
    };
    compare(&body, 1000, 1000);
}
