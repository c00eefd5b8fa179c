//! Counted loops over records that copy parts of records, over one another now and then, and that write a variable on each way of a CASE:
//! whatever the Host makes of memory and budget, they do on all engines what the interpreter does.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_beside, engines, program};

const PROGRAMS: u64 = 250;
const QUESTIONS_MAX: usize = 30;
/// Two arrays of records: where they begin, and bytes of a record.
const ARRAYS: [(u32, u32); 2] = [(32, 32), (560, 36)];
const RECORDS: u32 = 13;
/// Where the variables lie, in bytes: the counter, a sum, and one that each way of a CASE writes.
const COUNTER: u32 = 1_040;
const SUM: u32 = 1_044;
const MODE: u32 = 1_048;
const LEVEL: u32 = 1_052;
/// The number with which the counter begins.
const FIRST: u32 = 1;

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// A loop over the records in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    /// Some bytes of the record of an iteration, or of one beside it.
    fn part(&mut self, bytes: u32, neighbours: &[i32]) -> Place {
        let (start, record) = self.dice.of(&ARRAYS);
        let at = self.dice.roll(u64::from(record - bytes) / 2 + 1) as u32 * 2;
        let counter = self.b.load(fixed(COUNTER), Width::DoubleWord, OnFault::SkipStatement);
        let bits = self.b.constant(u64::from(8 * record));
        let pointer = self.b.compute(Op::MulU32, &[counter, bits]);
        let moved = (self.dice.of(neighbours) - FIRST as i32) * record as i32;
        let offset = (8 * (start as i32 + at as i32 + moved)) as u32 & 0x00FF_FFFF;
        Place::Indirect { area: Area::BitMemory, pointer, offset }
    }

    fn number(&mut self, depth: usize) -> Var {
        match self.dice.roll(if depth == 0 { 4 } else { 7 }) {
            0 => self.b.load(fixed(COUNTER), Width::DoubleWord, OnFault::SkipStatement),
            1 => self.b.load(fixed(LEVEL), Width::DoubleWord, OnFault::SkipStatement),
            2 => self.b.constant(self.dice.of(&[1, 2, 3, 100, 0x3F00_0000])),
            3 => {
                let place = self.part(4, &[0, 0, 0, -1, 1]);
                self.b.load(place, Width::DoubleWord, OnFault::SkipStatement)
            }
            4 => {
                let mode = self.b.load(fixed(MODE), Width::Word, OnFault::SkipStatement);
                self.b.compute(Op::Extend16, &[mode])
            }
            _ => {
                let parts = [self.number(depth - 1), self.number(depth - 1)];
                self.b.compute(self.dice.of(&[Op::AddU32, Op::SubU32, Op::XorU32, Op::AddF32, Op::MulF32]), &parts)
            }
        }
    }

    fn copy(&mut self) {
        self.begin();
        let bytes = self.dice.of(&[1, 2, 3, 4, 6, 7, 8, 12, 16, 20, 20, 28, 31]);
        let (from, to) = (self.part(bytes, &[0, 0, 0, 0, -1, 1]), self.part(bytes, &[0, 0, 0, 0, 0, 1]));
        self.b.push(Inst::Move { from, to, bytes });
    }

    fn field(&mut self) {
        self.begin();
        let value = self.number(2);
        let place = self.part(4, &[0, 0, 0, 0, 0, 1]);
        self.b.store(place, Width::DoubleWord, value);
    }

    fn put(&mut self, place: Place, width: Width) {
        let value = if width == Width::Word { self.b.constant(self.dice.of(&[0, 1, 2, 0x8001])) } else { self.number(1) };
        self.b.store(place, width, value);
    }

    /// A CASE of which mostly each way writes a variable, and some ways more.
    fn case(&mut self) {
        let (place, width) = self.dice.of(&[(MODE, Width::Word), (LEVEL, Width::DoubleWord)]);
        self.begin();
        let number = self.number(1);
        let three = self.b.constant(3);
        let chosen = self.b.compute(Op::AndU32, &[number, three]);
        let ways = 1 + self.dice.roll(3) as u32;
        let labels = ways + self.dice.roll(2) as u32;
        let first = self.statements;
        for label in 0..labels {
            let number = self.b.constant(u64::from(label));
            let condition = self.b.compute(Op::Equal, &[chosen, number]);
            self.b.push(Inst::Branch { condition, to: Target(first + 3 * (label % ways)) });
        }
        // Behind the ways is ELSE.
        let otherwise = first + 3 * ways;
        self.b.push(Inst::Jump { to: Target(otherwise) });
        for _ in 0..ways {
            self.begin();
            self.put(fixed(place), width);
            if self.dice.roll(3) == 0 {
                self.copy()
            } else {
                self.field()
            }
            self.begin();
            self.b.push(Inst::Jump { to: Target(otherwise + 1) });
        }
        self.begin();
        if self.dice.roll(5) != 0 {
            self.put(fixed(place), width);
        }
    }

    fn looping(&mut self) {
        self.begin();
        let first = self.b.constant(u64::from(FIRST));
        self.b.store(fixed(COUNTER), Width::DoubleWord, first);
        for _ in 0..2 + self.dice.roll(3) {
            match self.dice.roll(4) {
                0 => self.field(),
                1 | 2 => self.copy(),
                _ => self.case(),
            }
        }
        self.begin();
        let (sum, more) = (self.b.load(fixed(SUM), Width::DoubleWord, OnFault::SkipStatement), self.number(1));
        let sum = self.b.compute(Op::AddU32, &[sum, more]);
        self.b.store(fixed(SUM), Width::DoubleWord, sum);
        self.begin();
        let counter = self.b.load(fixed(COUNTER), Width::DoubleWord, OnFault::SkipStatement);
        let one = self.b.constant(1);
        let next = self.b.compute(Op::AddU32, &[counter, one]);
        self.b.store(fixed(COUNTER), Width::DoubleWord, next);
        let last = self.dice.of(&[4, 8, 11]);
        let last = self.b.constant(last);
        let again = self.b.compute(Op::LeI32, &[next, last]);
        self.b.push(Inst::Branch { condition: again, to: Target(1) });
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 3, 8, 30, 60, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, MODE, LEVEL, SUM, 40, 570]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 7, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn records_are_copied_as_the_interpreter_does() {
    let (mut asked, mut finished, mut beside) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| Maker { b, dice: Dice(seed), statements: 0 }.looping())]);
        let layout = noting::layout(&program);
        let listing = Jit::listing(&program, &layout).expect("machine code");
        beside += usize::from(listing.contains("insertlane") || listing.contains("shuffle"));
        let engines = engines(&program, &layout);
        for round in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 4, 12, 40, 100_000, 100_000, 100_000]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory.iter_mut().take(1_100).for_each(|byte| *byte = dice.roll(256) as u8);
            };
            let dice = || Dice(seed + 2_000_000);
            let expected = all_engines_agree_beside(&engines, &prepare, &dice, &meddle, &format!("{seed} in round {round}"));
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    const { assert!(ARRAYS[0].0 + ARRAYS[0].1 * RECORDS <= ARRAYS[1].0 && ARRAYS[1].0 + ARRAYS[1].1 * RECORDS <= COUNTER) };
    assert!(asked > 180 && finished > 500 && beside > 90, "{asked} questions, {finished} runs to the end, {beside} loops side by side");
}
