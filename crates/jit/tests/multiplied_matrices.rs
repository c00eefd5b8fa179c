//! Loops in loops as they multiply matrices: how many iterations the inner one has is a variable that is read before it, or it is
//! jumped over, and iterations of the outer one add to the same elements. Whatever the variables are and whoever writes them, memory,
//! registers and questions are those of the interpreter.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, layout_with, program, run_beside};

/// Programs that are compared, and memories with which each of them is.
const PROGRAMS: u64 = 120;
const MEMORIES: u64 = 2;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Bytes of the data block, and of each of the arrays in it.
const DATA_BYTES: usize = 9_800;
const ARRAY_BYTES: u64 = 2_000;
/// Indexes that arrays have.
const ROWS: u64 = 13;
const COLUMNS: u64 = 40;

/// Variables by their numbers: in bit memory, eight bytes each.
const ROW: u32 = 0;
const COLUMN: u32 = 1;
const SUM: u32 = 2;
const FACTOR: u32 = 3;
const LEFT: u32 = 4;
const LAST_ROW: u32 = 5;
const LAST_COLUMN: u32 = 6;
const FIRST_COLUMN: u32 = 7;
const FLAG: u32 = 8;
const COUNTED: u32 = 9;
/// Where the limit of the inner loop is when it has begun.
const LIMIT: u32 = 10;
const VARIABLES: u32 = 11;

/// What the arrays hold.
#[derive(Clone, Copy, PartialEq)]
enum Elements {
    Halves,
    Words,
    Reals,
    Lreals,
}

impl Elements {
    fn width(self) -> Width {
        match self {
            Self::Halves => Width::Word,
            Self::Words | Self::Reals => Width::DoubleWord,
            Self::Lreals => Width::QuadWord,
        }
    }

    fn operations(self) -> &'static [Op] {
        match self {
            Self::Halves => &[Op::AddU16, Op::AddU16, Op::SubU16, Op::MulU16],
            Self::Words => &[Op::AddU32, Op::AddU32, Op::SubU32, Op::MulU32],
            Self::Reals => &[Op::AddF32, Op::AddF32, Op::SubF32, Op::MulF32],
            Self::Lreals => &[Op::AddF64, Op::AddF64, Op::SubF64, Op::MulF64],
        }
    }
}

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    elements: Elements,
    /// Counters have 16 bits.
    short: bool,
    /// Indexes are looked at.
    looks: bool,
    /// The limits of the inner loop lie in the data block, where elements may be.
    in_data: bool,
    /// Iterations of the outer loop add to elements that the column chooses.
    adds: bool,
    /// No index rests on the column, which may count anywhere.
    anywhere: bool,
}

impl Maker<'_> {
    fn counts(&self) -> Width {
        if self.short { Width::Word } else { Width::DoubleWord }
    }

    fn variable(&self, number: u32) -> (Place, Width) {
        let width = match number {
            ROW | COLUMN | LAST_ROW | LAST_COLUMN | FIRST_COLUMN | LIMIT => self.counts(),
            FLAG => Width::Bit,
            COUNTED => Width::Word,
            _ => self.elements.width(),
        };
        if number == LAST_COLUMN && self.in_data {
            // Among the elements that are written.
            return (Place::Fixed { area: Area::SharedData, position: 8 * (2 * ARRAY_BYTES as u32 + 60) }, width);
        }
        (Place::Fixed { area: Area::BitMemory, position: 64 * number }, width)
    }

    fn get(&mut self, number: u32) -> Var {
        let (place, width) = self.variable(number);
        self.b.load(place, width, OnFault::SkipStatement)
    }

    fn put(&mut self, number: u32, value: Var) {
        let (place, width) = self.variable(number);
        self.b.store(place, width, value);
    }

    fn constant_to(&mut self, number: u32, value: u64) {
        let value = self.b.constant(value);
        self.put(number, value);
    }

    /// A counter as an index, which is below a limit.
    fn index(&mut self, number: u32, limit: u64) -> Var {
        let mut index = self.get(number);
        if self.short {
            index = self.b.compute(Op::Extend16, &[index]);
        }
        if self.looks { self.looked_at(index, limit) } else { index }
    }

    fn looked_at(&mut self, index: Var, limit: u64) -> Var {
        let limit = self.b.constant(limit);
        let inside = self.b.compute(Op::Below, &[index, limit]);
        self.b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: index });
        self.b.compute(Op::Gate, &[index, inside])
    }

    /// An element by the row, the column, or both.
    fn element(&mut self, array: u64, kind: u64) -> Place {
        let bits = u64::from(self.elements.width().bits());
        // Arrays share bytes now and then, and an element may be the next one.
        let jitter = match self.dice.roll(40) {
            0 => 700 + 2 * self.dice.roll(120),
            1 => bits / 8,
            _ => 0,
        };
        let [row, column] = match kind {
            0 => [0, 1],
            1 => [1, 0],
            2 => [16, 1],
            3 => [1, 4],
            _ => [4, 2],
        };
        let mut pointer = self.b.constant(0);
        for (number, elements, limit) in [(ROW, row, ROWS), (COLUMN, column, COLUMNS)] {
            if elements == 0 {
                continue;
            }
            let index = self.index(number, limit);
            let step = self.b.constant(bits * elements);
            let part = self.b.compute(Op::MulU32, &[index, step]);
            pointer = self.b.compute(Op::AddU32, &[pointer, part]);
        }
        let offset = 8 * (ARRAY_BYTES * array + jitter) as u32;
        if self.looks && self.dice.roll(30) == 0 {
            return self.diagonal(offset);
        }
        Place::Indirect { area: Area::SharedData, pointer, offset }
    }

    /// An element by the sum of both counters.
    fn diagonal(&mut self, offset: u32) -> Place {
        let [mut row, mut column] = [ROW, COLUMN].map(|number| self.get(number));
        if self.short {
            [row, column] = [row, column].map(|number| self.b.compute(Op::Extend16, &[number]));
        }
        let sum = self.b.compute(Op::AddU32, &[row, column]);
        let index = self.looked_at(sum, COLUMNS);
        let bits = self.b.constant(self.elements.width().bits().into());
        let pointer = self.b.compute(Op::MulU32, &[index, bits]);
        Place::Indirect { area: Area::SharedData, pointer, offset }
    }

    fn read(&mut self, array: u64, kinds: &[u64]) -> Var {
        let kind = self.dice.of(kinds);
        let place = self.element(array, kind);
        self.b.load(place, self.elements.width(), OnFault::SkipStatement)
    }

    fn operand(&mut self) -> Var {
        match self.dice.roll(10) {
            0 => self.b.constant(self.dice.of(&[0, 1, 3, 0x7FFF, 0x7FC0_0001])),
            1 => self.get(COLUMN),
            2 => self.get(ROW),
            3..6 => self.get(FACTOR),
            _ if self.anywhere => self.read(0, &[1]),
            // The element that is written, or the next one.
            6 if self.adds && self.dice.roll(3) == 0 => {
                let next = self.dice.of(&[0, 1]) * self.elements.width().bytes();
                let Place::Indirect { area, pointer, offset } = self.element(2, 0) else { unreachable!("it has an index") };
                let place = Place::Indirect { area, pointer, offset: offset + 8 * next };
                self.b.load(place, self.elements.width(), OnFault::SkipStatement)
            }
            _ => {
                let array = self.dice.roll(2);
                self.read(array, if self.adds { &[2, 2, 2, 2, 0, 1, 3, 4] } else { &[3, 3, 3, 3, 0, 0, 1, 2] })
            }
        }
    }

    fn operation(&mut self) -> Op {
        self.dice.of(self.elements.operations())
    }

    /// A statement of the inner loop.
    fn inner_statement(&mut self) {
        self.b.begin_statement();
        if self.dice.roll(16) == 0 {
            return self.count();
        }
        let args = [self.operand(), self.operand()];
        let op = self.operation();
        let product = self.b.compute(op, &args);
        match self.dice.roll(12) {
            0..9 if !self.adds || self.anywhere => {
                let before = self.get(SUM);
                let after = self.b.compute(self.elements.operations()[0], &[before, product]);
                self.put(SUM, after);
            }
            9 => self.put(LEFT, product),
            _ if self.anywhere => self.put(LEFT, product),
            10 if !self.adds || self.dice.roll(3) == 0 => {
                let kind = self.dice.of(&[0, 2, 2]);
                let place = self.element(3, kind);
                self.b.store(place, self.elements.width(), product);
            }
            _ => {
                let kind = self.dice.of(&[0, 0, 0, 0, 0, 0, 2, 1]);
                let array = if self.dice.roll(12) == 0 { 1 } else { 2 };
                let place = self.element(array, kind);
                let before = self.b.load(place, self.elements.width(), OnFault::SkipStatement);
                let op = self.operation();
                let after = self.b.compute(op, &[before, product]);
                let place = if self.dice.roll(16) == 0 { self.element(2, kind) } else { place };
                self.b.store(place, self.elements.width(), after);
            }
        }
    }

    /// Something is counted beside the counters.
    fn count(&mut self) {
        let (before, one) = (self.get(COUNTED), self.b.constant(1));
        let after = self.b.compute(Op::AddU16, &[before, one]);
        self.put(COUNTED, after);
    }

    /// Counts on and jumps back, up to a limit.
    fn again(&mut self, number: u32, head: Target, step: u64, limit: Option<u64>) {
        self.b.begin_statement();
        let before = self.get(number);
        let step = self.b.constant(step);
        let (add, leaves, at_most, below) = match self.short {
            true => (Op::AddU16, Op::AddOverflowsI16, Op::LeI16, Op::LtI16),
            false => (Op::AddU32, Op::AddOverflowsI32, Op::LeI32, Op::LtI32),
        };
        let next = self.b.compute(add, &[before, step]);
        // Another step than that of the counter now and then.
        let other = if self.dice.roll(12) == 0 { self.b.constant(5) } else { step };
        let leaves = self.b.compute(leaves, &[before, other]);
        self.put(number, next);
        let limit = match limit {
            Some(limit) => self.b.constant(limit),
            None => self.get(if number == ROW { LAST_ROW } else { LIMIT }),
        };
        let op = match self.dice.roll(8) {
            0 => below,
            1 | 2 => self.dice.of(&[Op::Differ, Op::Differ, if self.short { Op::NeI16 } else { Op::NeI32 }]),
            _ => at_most,
        };
        // What is compared is the counter of this iteration now and then.
        let compared = if self.dice.roll(16) == 0 { before } else { next };
        let mut condition = self.b.compute(op, &[compared, limit]);
        if self.dice.roll(2) == 0 {
            condition = self.b.compute(Op::AndNot, &[condition, leaves]);
        }
        self.b.push(Inst::Branch { condition, to: head });
    }

    /// What the inner loop begins with; its jump over the inner loop, if there is one, goes to a statement.
    fn begin_inner(&mut self, counted: bool, behind: Target) {
        self.b.begin_statement();
        match self.dice.roll(if self.anywhere { 3 } else { 8 }) {
            0 | 1 => {
                let first = self.dice.of(&[FIRST_COLUMN, ROW]);
                let first = self.get(first);
                self.put(COLUMN, first);
            }
            2 => self.constant_to(COLUMN, 1),
            _ => self.constant_to(COLUMN, 0),
        }
        let mut limit = self.get(LAST_COLUMN);
        if self.dice.roll(2) == 0 {
            let one = self.b.constant(1);
            limit = self.b.compute(if self.short { Op::SubU16 } else { Op::SubU32 }, &[limit, one]);
        }
        self.put(LIMIT, limit);
        let condition = match self.dice.roll(8) {
            0 => self.get(FLAG),
            1 => return,
            2 if !counted => return,
            _ => {
                let args = [self.get(COLUMN), self.get(LIMIT)];
                self.b.compute(if self.short { Op::GtI16 } else { Op::GtI32 }, &args)
            }
        };
        self.b.push(Inst::Branch { condition, to: behind });
    }

    /// Somebody writes what the inner loop is counted by, in an iteration of the outer one.
    fn meddle(&mut self) {
        self.b.begin_statement();
        match self.dice.roll(4) {
            0 => {
                let flag = self.get(FLAG);
                let flag = self.b.compute(Op::Not, &[flag]);
                self.put(FLAG, flag);
            }
            number => {
                let number = [LAST_COLUMN, FIRST_COLUMN, LAST_ROW][number as usize - 1];
                let before = self.get(number);
                let one = self.b.constant(1);
                let after = self.b.compute(if self.short { Op::SubU16 } else { Op::SubU32 }, &[before, one]);
                self.put(number, after);
            }
        }
    }

    fn nest(&mut self) {
        self.b.begin_statement();
        self.constant_to(ROW, 0);
        let head = self.b.next();
        self.b.begin_statement();
        if self.dice.roll(3) != 0 {
            let factor = match self.dice.roll(8) {
                // What the inner loop has left before.
                0 => self.get(COLUMN),
                _ => self.read(0, &[1, 1, 1, 1, 1, 0]),
            };
            self.put(FACTOR, factor);
        }
        if self.dice.roll(3) != 0 {
            self.constant_to(SUM, 0);
        }
        if self.dice.roll(3) == 0 {
            self.b.begin_statement();
            self.count();
        }
        if self.dice.roll(6) == 0 {
            self.meddle();
        }
        let counted = self.dice.roll(4) != 0;
        let statements = 1 + self.dice.roll(2) as u32;
        let behind = Target(self.b.next().0 + 1 + statements + 1);
        self.begin_inner(counted, behind);
        let inner = self.b.next();
        for _ in 0..statements {
            self.inner_statement();
        }
        let step = self.dice.of(&[1, 1, 1, 1, 1, 1, 2, 3]);
        let last = (!counted).then(|| self.dice.of(&[0, 3, 7, 8, 15, 31, 31, 33, 38]));
        self.again(COLUMN, inner, step, last);
        if self.dice.roll(6) == 0 {
            // What the inner loop left goes on.
            self.b.begin_statement();
            match self.dice.roll(4) {
                0 => self.constant_to(COLUMN, 7),
                _ => {
                    let (before, left) = (self.get(COUNTED), self.get(COLUMN));
                    let after = self.b.compute(Op::AddU16, &[before, left]);
                    self.put(COUNTED, after);
                }
            }
        }
        if self.anywhere || self.dice.roll(if self.adds { 6 } else { 2 }) == 0 {
            self.b.begin_statement();
            let left = self.dice.of(&[SUM, SUM, LEFT, COLUMN]);
            let value = self.get(left);
            let place = self.element(3, 1);
            self.b.store(place, self.elements.width(), value);
        }
        if self.dice.roll(12) == 0 {
            self.meddle();
        }
        let rows = self.dice.of(&[None, Some(0), Some(5), Some(12)]);
        self.again(ROW, head, 1, rows);
    }
}

fn loops(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let elements = dice.of(&[Elements::Halves, Elements::Words, Elements::Reals, Elements::Lreals]);
    let [short, looks, apart, adds, inside] = [2, 8, 12, 2, 8].map(|sides| dice.roll(sides) != 0);
    let mut maker = Maker { b, dice, elements, short, looks, in_data: !apart, adds, anywhere: !inside };
    maker.b.begin_statement();
    let number = maker.b.constant(1);
    maker.b.push(Inst::Open { register: DataRegister::Shared, number });
    maker.nest();
    maker.b.begin_statement();
    maker.b.push(Inst::Return);
}

/// Puts numbers into the variables by which loops are counted.
fn prepare(machine: &mut Machine, seed: u64, short: bool) {
    let mut dice = Dice(seed);
    machine.budget = dice.of(&[1, 40, 300, 1_000, 100_000, 100_000, 100_000]);
    let layout = machine.memory.layout.clone();
    let data = layout.data_blocks[&1].clone();
    machine.memory.arena[data.clone()].fill_with(|| dice.of(&[0, 0x3F, 0x40, 0x7F, 0x80, 0xFF, 1, 0xC0]));
    let bits = layout.bit_memory.start;
    machine.memory.arena[bits..bits + 8 * VARIABLES as usize].fill_with(|| dice.roll(256) as u8);
    let most: i32 = if short { i16::MAX.into() } else { i32::MAX };
    let numbers = [
        (LAST_ROW, dice.of(&[0, 3, 12, 12, 13, -1])),
        (LAST_COLUMN, dice.of(&[-2, 0, 1, 3, 7, 8, 16, 31, 32, 32, 32, 33, 39, 44, most, most])),
        (FIRST_COLUMN, dice.of(&[0, 0, 1, 2, -1, most - 3, -most - 1])),
        (FLAG, dice.of(&[0, 0, -1])),
    ];
    let mut write = |at: usize, number: i32| match short {
        true => machine.memory.arena[at..at + 2].copy_from_slice(&(number as i16).to_be_bytes()),
        false => machine.memory.arena[at..at + 4].copy_from_slice(&number.to_be_bytes()),
    };
    for (variable, number) in numbers {
        write(bits + 8 * variable as usize, number);
        if variable == LAST_COLUMN {
            write(data.start + 2 * ARRAY_BYTES as usize + 60, number);
        }
    }
}

fn answer(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    // Who is told of what is noted changes nothing.
    if noting::is_noted(what) && asked < 10 * QUESTIONS_MAX {
        return Reaction::Continue;
    }
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 3, 17, 100, 1_000, 100_000]);
    if dice.roll(4) == 0 {
        let start = machine.memory.layout.bit_memory.start;
        machine.memory.arena[start + dice.roll(8 * u64::from(VARIABLES)) as usize] = dice.of(&[0, 1, 7, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn loops_that_multiply_matrices_do_what_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| loops(b, seed))]);
        let layout = layout_with(&program, DATA_BYTES);
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let mut dice = Dice(seed);
        let short = [4, 2].map(|sides| dice.roll(sides))[1] != 0;
        let engines = engines(&program, &layout);
        for memory in 0..MEMORIES {
            let prepare = |machine: &mut Machine| prepare(machine, MEMORIES * seed + memory + 1_000_000, short);
            let outcome = |engine: Arc<dyn Engine>| {
                run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(MEMORIES * seed + memory + 2_000_000), &answer)
            };
            let what = || format!("{seed}, memory {memory}\n{}", program.code[&block].code);
            let expected = all_engines_agree(&engines, true, &outcome, &what);
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 200 && finished > 120, "{asked} questions, {finished} runs to the end");
}
