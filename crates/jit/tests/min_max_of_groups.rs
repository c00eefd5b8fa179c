//! Loops that keep the greatest or least number of several groups, in a record of the group to which each iteration belongs: whatever the
//! Host makes of memory and budget, they do on all engines what the interpreter does.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_beside, engines, program};

const PROGRAMS: u64 = 300;
const QUESTIONS_MAX: usize = 40;
const ITERATIONS: u64 = 24;
/// The counter, a sum, and bits; to which group each iteration belongs, its numbers, and the records of the groups.
const COUNTER: u32 = 0;
const SUM: u32 = 4;
const BITS: u32 = 8;
const GROUPS: u32 = 16;
const NUMBERS: u32 = 64;
const RECORDS: u32 = 192;
const RECORD: u32 = 12;

const COMPARED: [(Width, Op); 10] = [
    (Width::DoubleWord, Op::GtI32),
    (Width::DoubleWord, Op::LtI32),
    (Width::DoubleWord, Op::GeI32),
    (Width::DoubleWord, Op::NeI32),
    (Width::DoubleWord, Op::GtF32),
    (Width::DoubleWord, Op::LtF32),
    (Width::Word, Op::GtI16),
    (Width::Word, Op::LtI16),
    (Width::Word, Op::LeI16),
    (Width::Word, Op::EqI16),
];

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
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

    /// Something of the running iteration, of which each has so many bytes.
    fn own(&mut self, start: u32, bytes: u32) -> Place {
        let (counter, bits) = (self.load(fixed(COUNTER), Width::DoubleWord), self.b.constant(u64::from(8 * bytes)));
        let pointer = self.b.compute(Op::MulU32, &[counter, bits]);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * start }
    }

    /// A field of the record of the iteration's group.
    fn field(&mut self, offset: u32) -> Place {
        let place = self.own(GROUPS, 1);
        let (group, mask, bits) = (self.load(place, Width::Byte), self.b.constant(3), self.b.constant(u64::from(8 * RECORD)));
        let group = self.b.compute(Op::AndU32, &[group, mask]);
        let pointer = self.b.compute(Op::MulU32, &[group, bits]);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * (RECORDS + offset) }
    }

    /// `IF number > field THEN field := number; END_IF`, in one of many forms.
    fn keep(&mut self) {
        let ((width, op), offset) = (self.dice.of(&COMPARED), self.dice.of(&[0, 0, 4, 2]));
        let to = self.statements + 2;
        self.begin();
        let (own, field) = (self.own(NUMBERS, 4), self.field(offset));
        let (number, old) = (self.load(own, width), self.load(field, width));
        let args = if self.dice.roll(4) == 0 { [old, number] } else { [number, old] };
        let mut holds = self.b.compute(op, &args);
        if self.dice.roll(5) == 0 {
            let position = 8 * BITS + self.dice.roll(2) as u32;
            let bit = self.load(Place::Fixed { area: Area::BitMemory, position }, Width::Bit);
            holds = self.b.compute(self.dice.of(&[Op::And, Op::Or]), &[holds, bit]);
        }
        let condition = if self.dice.roll(5) == 0 { holds } else { self.b.compute(Op::Not, &[holds]) };
        self.b.push(Inst::Branch { condition, to: Target(to) });
        self.begin();
        let offset = if self.dice.roll(8) == 0 { 0 } else { offset };
        let (own, field) = (self.own(NUMBERS, 4), self.field(offset));
        let number = self.load(own, width);
        self.b.store(field, width, number);
    }

    /// Something else that an iteration does there.
    fn other(&mut self) {
        self.begin();
        let offset = self.dice.of(&[0, 4, 8, 8]);
        let field = self.field(offset);
        let old = self.load(field, Width::DoubleWord);
        if self.dice.roll(2) == 0 {
            let one = self.b.constant(1);
            let value = self.b.compute(Op::AddU32, &[old, one]);
            let field = self.field(8);
            self.b.store(field, Width::DoubleWord, value);
        } else {
            let sum = self.load(fixed(SUM), Width::DoubleWord);
            let sum = self.b.compute(Op::AddU32, &[sum, old]);
            self.b.store(fixed(SUM), Width::DoubleWord, sum);
        }
    }

    fn main(mut self) {
        self.begin();
        let zero = self.b.constant(0);
        self.b.store(fixed(COUNTER), Width::DoubleWord, zero);
        let again = self.statements;
        for _ in 0..1 + self.dice.roll(3) {
            self.keep();
            if self.dice.roll(2) == 0 {
                self.other();
            }
        }
        self.begin();
        let (old, one, limit) = (self.load(fixed(COUNTER), Width::DoubleWord), self.b.constant(1), self.b.constant(ITERATIONS));
        let next = self.b.compute(Op::AddU32, &[old, one]);
        self.b.store(fixed(COUNTER), Width::DoubleWord, next);
        let goes_on = self.b.compute(Op::LtI32, &[next, limit]);
        self.b.push(Inst::Branch { condition: goes_on, to: Target(again) });
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// What somebody makes of the machine who is asked, and sees how much of the budget is left.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    let left = machine.budget;
    machine.memory.area_mut(Area::BitMemory)[250..254].copy_from_slice(&(left as i32).to_be_bytes());
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 5, 20, 100, 1_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, BITS, GROUPS + 3, GROUPS + 9, NUMBERS + 8, RECORDS, RECORDS + 13]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 3, 9, 0x7F, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn the_greatest_and_least_of_groups_are_those_of_the_interpreter() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let main = |b: &mut Builder| Maker { b, dice: Dice(seed), statements: 0 }.main();
        let program = program(&[(BlockId::ob(1), 0, &main)]);
        let layout = noting::layout(&program);
        let engines = engines(&program, &layout);
        for round in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 9, 40, 400, 100_000, 100_000]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                // Few numbers: each is often the same as the one before.
                memory.iter_mut().skip(4).take(244).for_each(|byte| *byte = dice.of(&[0, 0, 1, 2, 3, 0x3F, 0x7F, 0x80, 0xFF]));
            };
            let dice = || Dice(seed + 2_000_000);
            let expected = all_engines_agree_beside(&engines, &prepare, &dice, &meddle, &format!("{seed} in round {round}"));
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 500 && finished > 500, "{asked} questions, {finished} runs to the end");
}
