//! Structures that are copied into temporaries and from there to other places, as in a swap, with variables of all widths written in
//! between: machine code that keeps in registers what it has copied does what the interpreter does.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_beside, engines, program};

const PROGRAMS: u64 = 700;
const QUESTIONS_MAX: usize = 30;
const LOCAL_BYTES: u32 = 100;
/// Records in an array, where they begin, and bytes of one.
const RECORDS: u32 = 8;
const ARRAY: u32 = 200;
const RECORD: u32 = 28;
/// Where temporaries begin in bit memory and in local data: the second one shares bytes with the first.
const TEMPORARIES: [u32; 3] = [0, 12, 40];
/// Where the counter and a sum lie in bit memory.
const COUNTER: u32 = 120;
const SUM: u32 = 124;

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    /// Bytes that most copies of this program have.
    bytes: u32,
}

fn fixed(area: Area, byte: u32) -> Place {
    Place::Fixed { area, position: 8 * byte }
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn counter(&mut self) -> Var {
        self.b.load(fixed(Area::BitMemory, COUNTER), Width::DoubleWord, OnFault::SkipStatement)
    }

    /// A temporary or a record, and bytes behind its beginning.
    fn place(&mut self, behind: u32) -> Place {
        match self.dice.roll(5) {
            0 | 1 => fixed(Area::BitMemory, self.dice.of(&TEMPORARIES) + behind),
            2 => fixed(Area::Local, self.dice.of(&TEMPORARIES) + behind),
            3 => fixed(Area::BitMemory, ARRAY + RECORD * self.dice.roll(u64::from(RECORDS)) as u32 + behind),
            _ => {
                // Sometimes nobody knows that the index stays inside.
                let mut index = self.counter();
                if self.dice.roll(8) != 0 {
                    let least = self.b.constant(u64::from(RECORDS) - 2);
                    index = self.b.compute(Op::AndU32, &[index, least]);
                }
                let bits = self.b.constant(u64::from(8 * RECORD));
                let pointer = self.b.compute(Op::MulU32, &[index, bits]);
                let next = self.dice.roll(2) as u32;
                Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * (ARRAY + RECORD * next + behind) }
            }
        }
    }

    fn copy(&mut self) {
        let bytes = if self.dice.roll(6) == 0 { self.dice.of(&[1, 4, 7, 16, 27]) } else { self.bytes };
        let [from, to] = [0, 1].map(|_| self.place(0));
        self.b.push(Inst::Move { from, to, bytes });
    }

    fn field(&mut self, write: bool) {
        let width = self.dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::DoubleWord, Width::DoubleWord]);
        let behind = self.dice.roll(u64::from(RECORD - 4)) as u32;
        let mut place = self.place(behind);
        if let (Width::Bit, Place::Fixed { position, .. }) = (width, &mut place) {
            *position += self.dice.roll(8) as u32;
        }
        let sum = fixed(Area::BitMemory, SUM);
        if write {
            let value = if self.dice.roll(3) == 0 { self.b.constant(1) } else { self.counter() };
            self.b.store(place, width, value);
        } else {
            let value = self.b.load(place, width, OnFault::SkipStatement);
            let before = self.b.load(sum, Width::DoubleWord, OnFault::SkipStatement);
            let after = self.b.compute(Op::AddU32, &[before, value]);
            self.b.store(sum, Width::DoubleWord, after);
        }
    }

    fn statement(&mut self) {
        self.begin();
        match self.dice.roll(8) {
            0 => self.field(true),
            1 => self.field(false),
            2 => {
                // On one of the ways on only.
                let counter = self.counter();
                let one = self.b.constant(1);
                let condition = self.b.compute(Op::AndU32, &[counter, one]);
                self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
                self.begin();
                if self.dice.roll(2) == 0 { self.copy() } else { self.field(true) }
            }
            _ => self.copy(),
        }
    }

    fn block(&mut self) {
        self.begin();
        let zero = self.b.constant(0);
        self.b.store(fixed(Area::BitMemory, COUNTER), Width::DoubleWord, zero);
        for _ in 0..self.dice.roll(3) {
            self.statement();
        }
        let head = self.statements;
        for _ in 0..4 + self.dice.roll(6) {
            self.statement();
        }
        self.begin();
        let (counter, one) = (self.counter(), self.b.constant(1));
        let next = self.b.compute(Op::AddU32, &[counter, one]);
        self.b.store(fixed(Area::BitMemory, COUNTER), Width::DoubleWord, next);
        let last = self.b.constant(self.dice.of(&[0, 3, 6]));
        let again = self.b.compute(Op::LeI32, &[next, last]);
        self.b.push(Inst::Branch { condition: again, to: Target(head) });
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 3, 8, 30, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, SUM, 5, 20, 45, ARRAY + 1, ARRAY + RECORD + 3]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 7, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn what_was_copied_is_copied_again_as_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let build = |b: &mut Builder| {
            let mut dice = Dice(seed);
            let bytes = dice.of(&[6, 12, 20, RECORD]);
            Maker { b, dice, statements: 0, bytes }.block();
        };
        let program = program(&[(block, LOCAL_BYTES, &build)]);
        let layout = noting::layout(&program);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 2, 3, 100_000]);
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory.iter_mut().take(500).for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let dice = || Dice(seed + 2_000_000);
        let expected = all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &format!("{seed}"));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 290 && finished > 580, "{asked} questions, {finished} runs to the end");
}

/// A swap through a temporary reads each of the three once.
#[test]
fn a_temporary_is_not_read_again() {
    let block = BlockId::ob(1);
    let swap = |b: &mut Builder| {
        let [a, c] = [ARRAY, ARRAY + RECORD].map(|byte| fixed(Area::BitMemory, byte));
        let temporary = fixed(Area::BitMemory, 0);
        for (from, to) in [(a, temporary), (c, a), (temporary, c)] {
            b.begin_statement();
            b.push(Inst::Move { from, to, bytes: 16 });
        }
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(block, 0, &swap)]);
    let listing = Jit::listing(&program, &noting::layout(&program)).expect("machine code");
    assert_eq!(listing.matches("= load.i8x16").count(), 2, "{listing}");
}
