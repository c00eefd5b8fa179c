//! Loops of two to nine iterations, which are written out one iteration after the other: with ways out and ways to the next iteration in
//! the middle, statements that fail, counters that iterations change or that somebody else changes, in a block and in one that it calls, in
//! a loop around them or behind one another. Whatever the Host makes of memory and budget, they do on all engines what the interpreter
//! does.

use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, FaultPlace, Layout, Machine, Program, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_beside, engines, program};

const PROGRAMS: u64 = 300;
const QUESTIONS_MAX: usize = 60;
const CALLED: BlockId = BlockId { kind: BlockKind::Function, number: 1 };
/// The counters of the loop around, and of the inner ones; a number that adds up, bits, and an array.
const OUTER: u32 = 0;
const COUNTERS: [u32; 2] = [4, 8];
const SUM: u32 = 12;
const BITS: u32 = 16;
const ARRAY: u32 = 64;
const ELEMENT: u32 = 6;
/// Elements that are there for all that count.
const ELEMENTS: u64 = 20;
const LOCAL_BYTES: u32 = 32;

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    counter: (Place, Width),
}

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn load(&mut self, place: Place, width: Width) -> Var {
        self.b.load(place, width, OnFault::SkipStatement)
    }

    /// The counter of the running loop, as 32 bits.
    fn count(&mut self) -> Var {
        let (place, width) = self.counter;
        let value = self.load(place, width);
        if width == Width::Word { self.b.compute(Op::Extend16, &[value]) } else { value }
    }

    /// A field of the element to which the counter leads.
    fn field(&mut self, offset: u32) -> Place {
        let (index, bits) = (self.count(), self.b.constant(u64::from(8 * ELEMENT)));
        let pointer = self.b.compute(Op::MulU32, &[index, bits]);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * (ARRAY + ELEMENT + offset) }
    }

    /// Something that holds or not.
    fn condition(&mut self) -> Var {
        match self.dice.roll(4) {
            0 => {
                let position = 8 * BITS + self.dice.roll(5) as u32;
                self.load(Place::Fixed { area: Area::BitMemory, position }, Width::Bit)
            }
            1 => {
                let (value, limit) = (self.count(), self.b.constant(self.dice.of(&[1, 2, 3])));
                self.b.compute(self.dice.of(&[Op::LtI32, Op::Equal]), &[value, limit])
            }
            2 => {
                let (place, limit) = (self.field(4), self.b.constant(self.dice.of(&[0, 1, 2])));
                let value = self.load(place, Width::Word);
                self.b.compute(Op::GtI16, &[value, limit])
            }
            _ => {
                let (value, mask) = (self.load(fixed(SUM), Width::DoubleWord), self.b.constant(self.dice.of(&[1, 2, 4])));
                let value = self.b.compute(Op::AndU32, &[value, mask]);
                let zero = self.b.constant(0);
                self.b.compute(Op::Equal, &[value, zero])
            }
        }
    }

    fn branch(&mut self, to: u32) {
        self.begin();
        let condition = self.condition();
        self.b.push(Inst::Branch { condition, to: Target(to) });
    }

    /// Something that fails now and then.
    fn require(&mut self) {
        let (place, limit) = (self.field(4), self.b.constant(3));
        let value = self.load(place, Width::Word);
        let holds = self.b.compute(Op::LtI16, &[value, limit]);
        self.b.push(Inst::Require { condition: holds, code: 0x22, register: value });
    }

    /// One statement that writes something.
    fn writes(&mut self, counts: bool) {
        self.begin();
        match self.dice.roll(if counts { 6 } else { 5 }) {
            0 => {
                let (old, number) = (self.load(fixed(SUM), Width::DoubleWord), self.count());
                let sum = self.b.compute(Op::AddU32, &[old, number]);
                self.b.store(fixed(SUM), Width::DoubleWord, sum);
            }
            1 => {
                let place = self.field(0);
                let (old, number) = (self.load(place, Width::DoubleWord), self.load(fixed(SUM), Width::DoubleWord));
                let value = self.b.compute(Op::XorU32, &[old, number]);
                self.b.store(place, Width::DoubleWord, value);
            }
            2 => {
                self.require();
                let (number, place) = (self.count(), self.field(4));
                self.b.store(place, Width::Word, number);
            }
            3 => {
                let position = 8 * BITS + self.dice.roll(5) as u32;
                let value = self.condition();
                self.b.store(Place::Fixed { area: Area::BitMemory, position }, Width::Bit, value);
            }
            4 => {
                let (value, place) = (self.b.constant(self.dice.roll(4)), self.field(4));
                self.b.store(place, Width::Word, value);
            }
            _ => {
                let ((place, width), number) = (self.counter, self.dice.of(&[0, 1, 2, 5]));
                let value = self.b.constant(number);
                self.b.store(place, width, value);
            }
        }
    }

    /// A loop of few iterations.
    fn few_iterations(&mut self) {
        let (from, iterations) = (self.dice.of(&[0, 1, 1, 2]), self.dice.of(&[2, 3, 4, 5, 5, 6, 7, 8, 9]));
        let step = self.dice.of(&[1, 1, 2]);
        let down = self.dice.roll(4) == 0;
        let last = from + step * (iterations - 1);
        let (first, limit) = if down { (last, from) } else { (from, last) };
        let counts = self.dice.roll(6) == 0;
        let (place, width) = self.counter;
        self.begin();
        let value = self.b.constant(first);
        self.b.store(place, width, value);
        let parts: Vec<u64> = (0..1 + self.dice.roll(4)).map(|_| self.dice.of(&[0, 0, 0, 1, 2, 3, 4])).collect();
        let sizes = [1, 1, 1, 2, 2];
        let size: u32 = parts.iter().map(|&part| sizes[part as usize]).sum();
        let (head, last) = (self.statements, self.statements + size);
        for part in parts {
            match part {
                0 => self.writes(counts),
                1 => self.branch(last + 1),
                2 => self.branch(last),
                3 => {
                    let to = self.statements + 2;
                    self.branch(to);
                    self.writes(counts);
                }
                _ => {
                    let to = self.statements + 2;
                    self.branch(to);
                    self.begin();
                    self.b.push(Inst::Jump { to: Target(last + 1) });
                }
            }
        }
        self.begin();
        if self.dice.roll(5) == 0 {
            self.require();
        }
        let value = self.load(place, width);
        let word = width == Width::Word;
        let number = if down { (step as u32).wrapping_neg() & if word { 0xFFFF } else { !0 } } else { step as u32 };
        let number = self.b.constant(number.into());
        let next = self.b.compute(if word { Op::AddU16 } else { Op::AddU32 }, &[value, number]);
        self.b.store(place, width, next);
        let limit = self.b.constant(limit);
        let op = match (word, down) {
            (true, false) => Op::LeI16,
            (true, true) => Op::GeI16,
            (false, false) => Op::LeI32,
            (false, true) => Op::GeI32,
        };
        let goes_on = self.b.compute(op, &[next, limit]);
        self.b.push(Inst::Branch { condition: goes_on, to: Target(head) });
    }

    fn some_loops(&mut self) {
        for _ in 0..1 + self.dice.roll(3) {
            self.few_iterations();
            if self.dice.roll(2) == 0 {
                self.writes(false);
            }
        }
    }

    fn called(mut self) {
        self.some_loops();
        self.begin();
        self.b.push(Inst::Return);
    }

    fn main(mut self) {
        let inner = self.counter;
        self.counter = (fixed(OUTER), Width::DoubleWord);
        let repeats = self.dice.roll(3) > 0;
        self.begin();
        let zero = self.b.constant(0);
        self.b.store(fixed(OUTER), Width::DoubleWord, zero);
        let again = self.statements;
        self.writes(false);
        self.counter = inner;
        if self.dice.roll(3) > 0 {
            self.some_loops();
        }
        if self.dice.roll(2) == 0 {
            self.begin();
            self.b.push(Inst::Call { callee: Callee::Block(CALLED), parameters: 0 });
        }
        self.begin();
        let (old, one, limit) = (self.load(fixed(OUTER), Width::DoubleWord), self.b.constant(1), self.b.constant(ELEMENTS - 1));
        let next = self.b.compute(Op::AddU32, &[old, one]);
        self.b.store(fixed(OUTER), Width::DoubleWord, next);
        if repeats {
            let goes_on = self.b.compute(Op::LeI32, &[next, limit]);
            self.b.push(Inst::Branch { condition: goes_on, to: Target(again) });
        }
        self.begin();
        self.b.push(Inst::Return);
    }
}

fn random_program(seed: u64) -> Program {
    let maker = |seed: u64, position: u32| {
        let mut dice = Dice(seed);
        let area = dice.of(&[Area::BitMemory, Area::BitMemory, Area::Local]);
        let width = dice.of(&[Width::Word, Width::Word, Width::DoubleWord]);
        (dice, (Place::Fixed { area, position: 8 * position }, width))
    };
    let main = |b: &mut Builder| {
        let (dice, counter) = maker(seed, COUNTERS[0]);
        Maker { b, dice, statements: 0, counter }.main();
    };
    let called = |b: &mut Builder| {
        let (dice, counter) = maker(seed + 500_000, COUNTERS[1]);
        Maker { b, dice, statements: 0, counter }.called();
    };
    program(&[(BlockId::ob(1), LOCAL_BYTES, &main), (CALLED, LOCAL_BYTES, &called)])
}

/// What somebody makes of the machine who is asked, and sees how much of the budget is left.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    let left = machine.budget;
    machine.memory.area_mut(Area::BitMemory)[250..254].copy_from_slice(&(left as i32).to_be_bytes());
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 20, 100, 1_000]);
    if dice.roll(3) == 0 {
        let counters = [OUTER + 3, COUNTERS[0] + 1, COUNTERS[0] + 3, COUNTERS[1] + 1, COUNTERS[1] + 3];
        let place = dice.of(&counters) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 5]);
    }
    if dice.roll(3) == 0 {
        let place = dice.of(&[BITS, SUM + 3, ARRAY + 11, ARRAY + 17]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 3, 0xFF]);
    }
    Reaction::Continue
}

/// Statements of the code that is compiled.
fn statements_written(program: &Program, layout: &Layout) -> usize {
    let listing = Jit::listing(program, layout).expect("machine code");
    let ir = listing.split("\nfunction ").next().unwrap_or_default();
    ir.lines().filter(|line| line.strip_suffix(':').is_some_and(|it| it.parse::<u32>().is_ok())).count()
}

#[test]
fn iterations_that_are_written_out_do_what_the_interpreter_does() {
    let (mut asked, mut finished, mut written_out) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let program = random_program(seed);
        let layout = noting::layout(&program);
        let statements: usize = program.code.values().map(|block| block.code.statement_count()).sum();
        written_out += usize::from(statements_written(&program, &layout) > statements);
        let engines = engines(&program, &layout);
        for round in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 3, 9, 40, 400, 100_000]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory.iter_mut().take(230).enumerate().for_each(|(at, byte)| {
                    let counts = at % 4 == 1 || at % 4 == 3 || at >= ARRAY as usize && at % 6 == 5;
                    *byte = if counts { dice.roll(4) as u8 } else { 0 };
                });
            };
            let dice = || Dice(seed + 2_000_000);
            let expected = all_engines_agree_beside(&engines, &prepare, &dice, &meddle, &format!("{seed} in round {round}"));
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(
        asked > 3_000 && finished > 300 && written_out > 180,
        "{asked} questions, {finished} runs to the end, {written_out} written out"
    );
}

/// Statements of the code of a loop that counts iterations; each adds the counter to a variable, or to an element of an array.
fn statements_of(iterations: u64, of_array: bool) -> usize {
    let write = |b: &mut Builder| {
        let counter = (fixed(COUNTERS[0]), Width::DoubleWord);
        let mut maker = Maker { b, dice: Dice(0), statements: 0, counter };
        maker.begin();
        let zero = maker.b.constant(0);
        maker.b.store(counter.0, counter.1, zero);
        maker.begin();
        let place = if of_array { maker.field(0) } else { fixed(SUM) };
        let (old, number) = (maker.load(place, Width::DoubleWord), maker.count());
        let sum = maker.b.compute(Op::AddU32, &[old, number]);
        maker.b.store(place, Width::DoubleWord, sum);
        maker.begin();
        let (old, one, last) = (maker.load(counter.0, counter.1), maker.b.constant(1), maker.b.constant(iterations - 1));
        let next = maker.b.compute(Op::AddU32, &[old, one]);
        maker.b.store(counter.0, counter.1, next);
        let goes_on = maker.b.compute(Op::LeI32, &[next, last]);
        maker.b.push(Inst::Branch { condition: goes_on, to: Target(1) });
    };
    let program = program(&[(BlockId::ob(1), LOCAL_BYTES, &write)]);
    statements_written(&program, &noting::layout(&program))
}

#[test]
fn more_iterations_are_written_out_of_a_loop_that_works_with_variables() {
    let is_written_out = |iterations: u64, of_array: bool| statements_of(iterations, of_array) > 4;
    for iterations in 2..12 {
        assert_eq!(is_written_out(iterations, true), iterations <= 5, "{iterations} overflows an array");
        assert_eq!(is_written_out(iterations, false), iterations <= 8, "{iterations} iterations");
    }
}
