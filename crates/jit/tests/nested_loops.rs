//! Loops in loops whose outer iterations are done side by side but for what they do in order behind the inner loop, or whose inner ones
//! could be, and indexes that an iteration chooses and the next one reads by.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Entry, Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout_with, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 700;
/// Those of which the machine code is looked at.
const LISTED: u64 = 300;
/// Bytes of the data block, and of each of the arrays in it.
const DATA_BYTES: usize = 4_000;
const ARRAY_BYTES: u64 = 900;
/// Where the variables lie in bit memory.
const VARIABLES: u32 = 200;
/// Variables by their numbers.
const ROW: u32 = 0;
const COLUMN: u32 = 1;
const SUM: u32 = 2;
const FACTOR: u32 = 3;
const LEFT: u32 = 4;
const BEST: u32 = 5;
const TOP: u32 = 6;

/// What the arrays hold.
#[derive(Clone, Copy, PartialEq)]
enum Elements {
    Halves,
    Words,
    Reals,
}

impl Elements {
    fn width(self) -> Width {
        if self == Self::Halves { Width::Word } else { Width::DoubleWord }
    }

    fn operations(self) -> &'static [Op] {
        match self {
            Self::Halves => &[Op::AddU16, Op::SubU16, Op::MulU16, Op::MaxI16],
            Self::Words => &[Op::AddU32, Op::SubU32, Op::MulU32, Op::XorU32],
            Self::Reals => &[Op::AddF32, Op::SubF32, Op::MulF32],
        }
    }

    fn less(self) -> Op {
        match self {
            Self::Halves => Op::LtI16,
            Self::Words => Op::LtI32,
            Self::Reals => Op::LtF32,
        }
    }
}

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    elements: Elements,
    /// The counter of the inner loop has 16 bits.
    short: bool,
    /// What iterations of the outer loop read follows one another, or is the same.
    rows_lie_side_by_side: bool,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn variable(&self, number: u32) -> (Place, Width) {
        let width = match number {
            COLUMN if self.short => Width::Word,
            ROW | COLUMN | BEST => Width::DoubleWord,
            _ => self.elements.width(),
        };
        (Place::Fixed { area: Area::BitMemory, position: 8 * (VARIABLES + 4 * number) }, width)
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

    /// An element by the row, the column, or both.
    fn element(&mut self, array: u64, kind: u64) -> Place {
        let bits = u64::from(self.elements.width().bits());
        let [row, column] = match kind {
            0 => [0, 1],
            1 => [1, 0],
            2 => [16, 1],
            3 => [1, 8],
            _ => [4, 2],
        };
        let mut pointer = self.b.constant(0);
        for (number, elements) in [(ROW, row), (COLUMN, column)] {
            if elements == 0 {
                continue;
            }
            let mut index = self.get(number);
            if number == COLUMN && self.short {
                index = self.b.compute(Op::Extend16, &[index]);
            }
            let step = self.b.constant(bits * elements);
            let part = self.b.compute(Op::MulU32, &[index, step]);
            pointer = self.b.compute(Op::AddU32, &[pointer, part]);
        }
        // Arrays share bytes now and then.
        let jitter = if self.dice.roll(8) == 0 { 700 + 2 * self.dice.roll(120) } else { 0 };
        Place::Indirect { area: Area::SharedData, pointer, offset: 8 * (ARRAY_BYTES * array + jitter) as u32 }
    }

    fn read(&mut self, array: u64) -> Var {
        let kinds: &[u64] = if self.rows_lie_side_by_side { &[0, 1, 1, 3] } else { &[0, 0, 2, 2, 2, 1, 3, 4] };
        let kind = self.dice.of(kinds);
        let place = self.element(array, kind);
        self.b.load(place, self.elements.width(), OnFault::SkipStatement)
    }

    fn operand(&mut self) -> Var {
        match self.dice.roll(8) {
            0 => self.b.constant(self.dice.of(&[0, 1, 3, 0x7FFF, 0x7FC0_0001])),
            1 => self.get(COLUMN),
            2 | 3 => self.get(FACTOR),
            _ => {
                let array = self.dice.roll(2);
                self.read(array)
            }
        }
    }

    fn operation(&mut self) -> Op {
        self.dice.of(self.elements.operations())
    }

    /// A statement of the inner loop.
    fn inner_statement(&mut self) {
        self.begin();
        let args = [self.operand(), self.operand()];
        let op = self.operation();
        let product = match self.elements {
            Elements::Halves if self.dice.roll(3) == 0 => self.b.compute(Op::MulI16Wide, &args),
            _ => self.b.compute(op, &args),
        };
        match self.dice.roll(8) {
            0..3 => {
                let before = self.get(SUM);
                let op = if self.elements == Elements::Halves { Op::AddU16 } else { self.elements.operations()[0] };
                let after = self.b.compute(op, &[before, product]);
                self.put(SUM, after);
            }
            3 => self.put(LEFT, product),
            4..6 => {
                let kind = self.dice.of(&[0, 0, 2]);
                let place = self.element(2, kind);
                let before = self.b.load(place, self.elements.width(), OnFault::SkipStatement);
                let op = self.operation();
                let after = self.b.compute(op, &[before, product]);
                self.b.store(place, self.elements.width(), after);
            }
            _ => {
                let kind = self.dice.of(&[0, 2, 2]);
                let place = self.element(3, kind);
                self.b.store(place, self.elements.width(), product);
            }
        }
    }

    fn inner(&mut self) {
        for _ in 0..1 + self.dice.roll(2) {
            if self.dice.roll(4) == 0 {
                self.begin();
                let args = [self.operand(), self.operand()];
                let condition = self.b.compute(self.elements.less(), &args);
                self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
            }
            self.inner_statement();
        }
    }

    /// Counts on and jumps back, up to a number.
    fn again(&mut self, number: u32, head: u32, step: u64, most: u64) {
        self.begin();
        let before = self.get(number);
        let step = self.b.constant(step);
        let short = number == COLUMN && self.short;
        let next = self.b.compute(if short { Op::AddU16 } else { Op::AddU32 }, &[before, step]);
        self.put(number, next);
        let most = self.b.constant(most);
        let condition = self.b.compute(if short { Op::LeI16 } else { Op::LeI32 }, &[next, most]);
        self.b.push(Inst::Branch { condition, to: Target(head) });
    }

    fn nest(&mut self) {
        self.begin();
        self.constant_to(ROW, 0);
        let head = self.statements;
        self.begin();
        if self.dice.roll(2) == 0 {
            let place = self.element(0, 1);
            let factor = self.b.load(place, self.elements.width(), OnFault::SkipStatement);
            self.put(FACTOR, factor);
        }
        if self.dice.roll(3) != 0 {
            let value = self.dice.of(&[0, 0, 5, 0x7FC0_0001]);
            self.constant_to(SUM, value);
        }
        let first = self.dice.of(&[0, 0, 0, 1, 3]);
        self.constant_to(COLUMN, first);
        let inner = self.statements;
        self.inner();
        let last = self.dice.of(&[3, 7, 8, 11, 15, 16, 20, 31, 33, 41, 70]);
        let step = self.dice.of(&[1, 1, 1, 1, 1, 2]);
        self.again(COLUMN, inner, step, last);
        if self.dice.roll(3) != 0 {
            self.begin();
            let left = self.dice.of(&[SUM, SUM, LEFT]);
            let value = self.get(left);
            let place = self.element(3, 1);
            self.b.store(place, self.elements.width(), value);
        }
        let rows = self.dice.of(&[0, 1, 5, 12]);
        self.again(ROW, head, 1, rows);
    }

    /// Something that each iteration of the outer loop makes of what the one before left: the greatest or least number so far, or a sum.
    fn in_order(&mut self) {
        self.begin();
        let [top, sum] = [TOP, SUM].map(|number| self.get(number));
        let (top, sum) = if self.dice.roll(2) == 0 { (top, sum) } else { (sum, top) };
        if self.dice.roll(3) == 0 {
            let condition = self.b.compute(self.elements.less(), &[top, sum]);
            self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
            self.begin();
            let sum = self.get(SUM);
            return self.put(TOP, sum);
        }
        let extremes = match self.elements {
            Elements::Halves => [Op::MinI16, Op::MaxI16],
            Elements::Words => [Op::MinI32, Op::MaxI32],
            Elements::Reals => [Op::MinF32, Op::MaxF32],
        };
        let op = if self.dice.roll(2) == 0 { self.dice.of(&extremes) } else { self.operation() };
        let mut value = self.b.compute(op, &[top, sum]);
        if self.dice.roll(4) == 0 {
            let (op, more) = (self.operation(), self.read(1));
            value = self.b.compute(op, &[value, more]);
        }
        self.put(TOP, value);
    }

    /// A loop in a loop, and something that is done in order behind it; now and then the inner loop needs it, too.
    fn nest_in_order(&mut self) {
        self.begin();
        self.constant_to(ROW, 0);
        let head = self.statements;
        self.begin();
        match self.dice.roll(6) {
            0 => {
                let top = self.get(TOP);
                let number = self.dice.of(&[SUM, FACTOR]);
                self.put(number, top);
            }
            _ => {
                let first = self.dice.of(&[0, 0, 5, 0x7FC0_0001]);
                self.constant_to(SUM, first);
            }
        }
        let first = self.dice.of(&[0, 0, 0, 3]);
        self.constant_to(COLUMN, first);
        let inner = self.statements;
        for _ in 0..1 + self.dice.roll(2) {
            self.begin();
            let mut args = [self.operand(), self.operand()];
            if self.dice.roll(12) == 0 {
                args[0] = self.get(TOP);
            }
            let (op, before) = (self.operation(), self.get(SUM));
            let product = self.b.compute(op, &args);
            let after = self.b.compute(self.elements.operations()[0], &[before, product]);
            self.put(SUM, after);
        }
        let last = self.dice.of(&[7, 15, 16, 31]);
        self.again(COLUMN, inner, 1, last);
        for _ in 0..1 + self.dice.roll(2) {
            self.in_order();
        }
        if self.dice.roll(3) != 0 {
            self.begin();
            let left = self.dice.of(&[SUM, SUM, TOP]);
            let value = self.get(left);
            let place = self.element(3, 1);
            self.b.store(place, self.elements.width(), value);
        }
        let rows = self.dice.of(&[3, 8, 31, 40, 69]);
        self.again(ROW, head, 1, rows);
    }

    /// `IF a[row] > a[best] THEN best := row`, or something like it.
    fn search(&mut self) {
        self.begin();
        self.constant_to(ROW, 0);
        let best = self.dice.roll(3);
        self.constant_to(BEST, best);
        let head = self.statements;
        self.begin();
        let bits = u64::from(self.elements.width().bits());
        let [this, best] = [ROW, BEST].map(|number| {
            let index = self.get(number);
            let step = self.b.constant(bits);
            let pointer = self.b.compute(Op::MulU32, &[index, step]);
            self.b.load(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, self.elements.width(), OnFault::SkipStatement)
        });
        let args = if self.dice.roll(2) == 0 { [this, best] } else { [best, this] };
        let condition = self.b.compute(self.elements.less(), &args);
        self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
        self.begin();
        let row = self.get(ROW);
        let most = self.b.constant(self.dice.of(&[1000, 7]));
        let row = self.b.compute(Op::MinI32, &[row, most]);
        self.put(BEST, row);
        if self.dice.roll(3) == 0 {
            self.begin();
            let best = self.get(BEST);
            let value = self.b.compute(Op::Low16, &[best]);
            let place = self.element(3, 1);
            self.b.store(place, self.elements.width(), value);
        }
        let rows = self.dice.of(&[3, 20, 39]);
        self.again(ROW, head, 1, rows);
    }
}

fn loops(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let elements = dice.of(&[Elements::Halves, Elements::Words, Elements::Reals]);
    let short = dice.roll(3) == 0;
    let mut maker = Maker { b, dice, statements: 0, elements, short, rows_lie_side_by_side: false };
    maker.begin();
    let number = maker.b.constant(1);
    maker.b.push(Inst::Open { register: DataRegister::Shared, number });
    match maker.dice.roll(8) {
        0 => maker.search(),
        1..3 => {
            maker.rows_lie_side_by_side = true;
            maker.nest_in_order();
        }
        _ => maker.nest(),
    }
    maker.begin();
    maker.b.push(Inst::Return);
}

#[test]
fn iterations_in_iterations_do_what_the_interpreter_does() {
    let (mut asked, mut finished, mut in_order) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| loops(b, seed))]);
        let layout = layout_with(&program, DATA_BYTES);
        if seed < LISTED {
            let listing = Jit::listing(&program, &layout).expect("machine code");
            in_order += usize::from(listing.matches(" extractlane ").count() >= 32);
        }
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 40, 1_000, 100_000, 100_000]);
            machine.memory.area_mut(Area::BitMemory)[..256].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.of(&[0, 0x3F, 0x40, 0x7F, 0x80, 0xFF, 1, 0xC0]));
        };
        let outcome = |engine: Arc<dyn sieben_engine::Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| {
                let mut dice = dice.borrow_mut();
                if asked >= 40 {
                    return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
                }
                machine.budget = dice.of(&[0, 3, 17, 100, 1_000, 100_000]);
                if dice.roll(4) == 0 {
                    machine.memory.area_mut(Area::BitMemory)[VARIABLES as usize + dice.roll(24) as usize] = dice.of(&[0, 1, 7, 0xFF]);
                }
                Reaction::Continue
            };
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("{seed}\n{}", program.code[&block].code));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 350 && finished > 600 && in_order > 10, "{asked} questions, {finished} runs to the end, {in_order} loops in order");
}
