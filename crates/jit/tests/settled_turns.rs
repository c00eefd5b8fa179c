//! Counted loops with conditions that are the same in all turns: whatever they are when the loop begins, and whatever the Host makes of them
//! between turns, the loops do on all engines what the interpreter does.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_beside, engines, program};

const PROGRAMS: u64 = 300;
const QUESTIONS_MAX: usize = 30;
/// Where the variables lie in bit memory, in bytes; the array is in front of them.
const COUNTER: u32 = 200;
const SCANS: u32 = 204;
const FLAGS: u32 = 208;
const SUM: u32 = 212;
/// Bytes of an element of the array.
const ELEMENT: u32 = 10;
/// Fields of an element: where they lie, in bits.
const FIELDS: &[(u32, Width)] =
    &[(0, Width::DoubleWord), (32, Width::Word), (48, Width::Bit), (49, Width::Bit), (56, Width::Byte), (64, Width::Word)];

fn fixed(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

/// A loop over the elements in the making.
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

    fn get(&mut self, place: Place, width: Width) -> Var {
        self.b.load(place, width, OnFault::SkipStatement)
    }

    /// A field of the element of a turn, now and then one of another element.
    fn field(&mut self) -> (Place, Width) {
        let counter = self.get(fixed(8 * COUNTER), Width::DoubleWord);
        let bits = self.b.constant(u64::from(8 * ELEMENT));
        let pointer = self.b.compute(Op::MulU32, &[counter, bits]);
        let (offset, width) = self.dice.of(FIELDS);
        let other = if self.dice.roll(8) == 0 { 8 * ELEMENT } else { 0 };
        (Place::Indirect { area: Area::BitMemory, pointer, offset: offset + other }, width)
    }

    /// A condition, mostly one that no turn changes.
    fn condition(&mut self, depth: usize) -> Var {
        match self.dice.roll(if depth == 0 { 5 } else { 8 }) {
            0 | 1 => {
                let bit = self.dice.roll(3) as u32;
                self.get(fixed(8 * FLAGS + bit), Width::Bit)
            }
            2 | 3 => {
                let scans = self.get(fixed(8 * SCANS), Width::DoubleWord);
                let other = self.dice.of(&[0, 0, 1, 7]);
                let other = self.b.constant(other);
                self.b.compute(self.dice.of(&[Op::Equal, Op::Differ, Op::LtI32]), &[scans, other])
            }
            4 => {
                let (place, width) = self.field();
                let value = self.get(place, width);
                self.b.compute(Op::IsNonzero, &[value])
            }
            5 => {
                let condition = self.condition(depth - 1);
                self.b.compute(Op::Not, &[condition])
            }
            _ => {
                let parts = [self.condition(depth - 1), self.condition(depth - 1)];
                self.b.compute(self.dice.of(&[Op::And, Op::Or, Op::AndNot, Op::Xor]), &parts)
            }
        }
    }

    fn statement(&mut self) {
        self.begin();
        let (place, width) = self.field();
        let value = match self.dice.roll(5) {
            0 => self.b.constant(1),
            1 => {
                let (other, width) = self.field();
                self.get(other, width)
            }
            // As it was.
            2 => self.get(place, width),
            _ => {
                let (other, width) = self.field();
                let value = self.get(other, width);
                let scans = self.get(fixed(8 * SCANS), Width::DoubleWord);
                self.b.compute(self.dice.of(&[Op::AddU32, Op::XorU32, Op::AddF32]), &[value, scans])
            }
        };
        match self.dice.roll(8) {
            0 => {
                let before = self.get(fixed(8 * SUM), Width::DoubleWord);
                let sum = self.b.compute(Op::AddU32, &[before, value]);
                self.b.store(fixed(8 * SUM), Width::DoubleWord, sum);
            }
            // What some turns change is no condition that all of them share.
            1 if self.dice.roll(4) == 0 => self.b.store(fixed(8 * FLAGS + 1), Width::Bit, value),
            _ => self.b.store(place, width, value),
        }
    }

    /// Statements of a turn, some of which are jumped over under a condition.
    fn parts(&mut self, parts: &[Part]) {
        for part in parts {
            let Part::Choice(chosen) = part else {
                self.statement();
                continue;
            };
            self.begin();
            let condition = self.condition(2);
            let behind = self.statements + Part::count(chosen);
            self.b.push(Inst::Branch { condition, to: Target(behind) });
            self.parts(chosen);
        }
    }

    fn some_parts(&mut self, depth: usize) -> Vec<Part> {
        let count = 1 + self.dice.roll(3);
        let one = |_| if depth > 0 && self.dice.roll(3) != 0 { Part::Choice(self.some_parts(depth - 1)) } else { Part::Statement };
        (0..count).map(one).collect()
    }

    fn looping(&mut self) {
        self.begin();
        let zero = self.b.constant(0);
        self.b.store(fixed(8 * COUNTER), Width::DoubleWord, zero);
        let parts = self.some_parts(2);
        self.parts(&parts);
        self.begin();
        let counter = self.get(fixed(8 * COUNTER), Width::DoubleWord);
        let one = self.b.constant(1);
        let next = self.b.compute(Op::AddU32, &[counter, one]);
        self.b.store(fixed(8 * COUNTER), Width::DoubleWord, next);
        let last = self.dice.of(&[0, 6, 13, 17]);
        let last = self.b.constant(last);
        let again = self.b.compute(Op::LeI32, &[next, last]);
        self.b.push(Inst::Branch { condition: again, to: Target(1) });
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// Part of a turn.
enum Part {
    Statement,
    /// What is jumped over if a condition holds.
    Choice(Vec<Part>),
}

impl Part {
    fn count(parts: &[Self]) -> u32 {
        let one = |part: &Self| match part {
            Self::Statement => 1,
            Self::Choice(chosen) => 1 + Self::count(chosen),
        };
        parts.iter().map(one).sum()
    }
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 3, 5, 8, 12, 20, 50, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, SCANS, SCANS + 3, FLAGS, FLAGS, FLAGS, 0, 4, 6]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 0, 1, 2, 7, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn conditions_that_all_turns_share_are_what_they_are() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| Maker { b, dice: Dice(seed), statements: 0 }.looping())]);
        let layout = noting::layout(&program);
        let engines = engines(&program, &layout);
        for flags in [0, 1, 2, 3, 5, 7] {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + flags);
                machine.budget = dice.of(&[1, 2, 4, 7, 12, 20, 40, 100_000, 100_000]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory[..256].iter_mut().for_each(|byte| *byte = dice.of(&[0, 1, 2, 0x3F, 0x80, 0x7F, 0xC0, 0xFF]));
                memory[SCANS as usize..][..4].copy_from_slice(&[0, 0, 0, dice.of(&[0, 0, 1, 7])]);
                memory[FLAGS as usize] = flags as u8;
            };
            let dice = || Dice(seed + 2_000_000);
            let expected = all_engines_agree_beside(&engines, &prepare, &dice, &meddle, &format!("{seed} with {flags}"));
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 1_000 && finished > 1_500, "{asked} questions, {finished} runs to the end");
}
