//! Counted loops that copy whole records to one another and through temporaries, behind a comparison of neighbours mostly, as sorting does,
//! and that read and write fields of a record and of its neighbours before, between and behind: they do on all engines what the interpreter
//! does.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_beside, engines, program};

const PROGRAMS: u64 = 600;
/// Those of which the machine code is looked at.
const LISTED: u64 = 200;
const QUESTIONS_MAX: usize = 30;
const LOCAL_BYTES: u32 = 64;
/// Records in an array, where they begin in bit memory, and bytes of one.
const RECORDS: u32 = 12;
const ARRAY: u32 = 100;
const RECORD: u32 = 28;
/// Where a temporary begins in bit memory and in local data.
const TEMPORARY: u32 = 8;
/// Where the counter, two sums and a bit lie in bit memory.
const COUNTER: u32 = 60;
const SUMS: [u32; 2] = [64, 68];
const SEEN: u32 = 72;
/// Numbers that some iterations leave there, and that lead to records.
const LEFT: [u32; 3] = [76, 80, 84];
/// Fields of a record that most statements reach: where they lie, and their widths.
const FIELDS: [(u32, Width); 5] =
    [(0, Width::DoubleWord), (0, Width::DoubleWord), (4, Width::Word), (8, Width::DoubleWord), (12, Width::Byte)];

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    /// The counter has 16 bits.
    short: bool,
    /// The loop counts down.
    down: bool,
    compares: Op,
    /// It copies records, not only fields.
    copies: bool,
    /// Many of the fields are bits.
    bits: bool,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn load(&mut self, byte: u32, width: Width) -> Var {
        self.b.load(fixed(byte), width, OnFault::SkipStatement)
    }

    /// The counter of its own width, and the same with 32 bits.
    fn counter(&mut self) -> [Var; 2] {
        let counter = self.load(COUNTER, if self.short { Width::Word } else { Width::DoubleWord });
        let wide = if self.short { self.b.compute(Op::Extend16, &[counter]) } else { counter };
        [counter, wide]
    }

    /// Some bytes of the record of an iteration or of one beside it, counted from the index of either.
    fn record(&mut self, behind: u32) -> Place {
        let neighbour = self.dice.of(&[0, 0, 1, 1, -1]);
        let [counter, mut index] = self.counter();
        let mut moved = neighbour * RECORD as i32;
        if neighbour == 1 && self.dice.roll(3) != 0 {
            let one = self.b.constant(1);
            index = if self.short {
                let next = self.b.compute(Op::AddU16, &[counter, one]);
                self.b.compute(Op::Extend16, &[next])
            } else {
                self.b.compute(Op::AddU32, &[index, one])
            };
            moved = 0;
        }
        let bits = self.b.constant(u64::from(8 * RECORD));
        let pointer = self.b.compute(Op::MulU32, &[index, bits]);
        let offset = 8 * (ARRAY as i32 + behind as i32 + moved);
        Place::Indirect { area: Area::BitMemory, pointer, offset: offset as u32 & 0x00FF_FFFF }
    }

    /// A record to which a number leads.
    fn record_at(&mut self, index: Var, behind: u32) -> Place {
        let bits = self.b.constant(u64::from(8 * RECORD));
        let pointer = self.b.compute(Op::MulU32, &[index, bits]);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * (ARRAY + behind) }
    }

    fn place(&mut self, behind: u32) -> Place {
        match self.dice.roll(9) {
            8 => {
                let left = self.dice.of(&LEFT);
                let (index, most) = (self.load(left, Width::DoubleWord), self.b.constant(7));
                let index = self.b.compute(Op::AndU32, &[index, most]);
                self.record_at(index, behind)
            }
            0 => fixed(TEMPORARY + behind),
            1 => Place::Fixed { area: Area::Local, position: 8 * (TEMPORARY + behind) },
            2 => fixed(ARRAY + RECORD * self.dice.roll(u64::from(RECORDS)) as u32 + behind),
            _ => self.record(behind),
        }
    }

    fn copy_between(&mut self, from: Place, to: Place, bytes: u32) {
        self.b.push(Inst::Move { from, to, bytes });
    }

    fn copy(&mut self) {
        if !self.copies {
            return self.write();
        }
        self.begin();
        let (behind, bytes) = self.dice.of(&[(0, RECORD), (0, RECORD), (0, 20), (4, 12), (2, 8)]);
        let [from, to] = [0, 1].map(|_| self.place(behind));
        self.copy_between(from, to, bytes);
    }

    /// Three statements that exchange the record of an iteration and the next one.
    fn swap(&mut self) {
        let temporary = if self.dice.roll(3) == 0 { Place::Fixed { area: Area::Local, position: 8 * TEMPORARY } } else { fixed(TEMPORARY) };
        self.begin();
        let own = self.record_beside(0);
        self.copy_between(own, temporary, RECORD);
        self.begin();
        let (next, own) = (self.record_beside(1), self.record_beside(0));
        self.copy_between(next, own, RECORD);
        self.begin();
        let next = self.record_beside(1);
        self.copy_between(temporary, next, RECORD);
    }

    /// The record of an iteration, or one so far behind it.
    fn record_beside(&mut self, records: u32) -> Place {
        let [_, index] = self.counter();
        self.record_at(index, records * RECORD)
    }

    fn field(&mut self) -> (Place, Width) {
        if self.dice.roll(8) < if self.bits { 5 } else { 1 } {
            let mut place = self.record(16);
            if let Place::Indirect { offset, .. } = &mut place {
                *offset += self.dice.roll(3) as u32;
            }
            return (place, Width::Bit);
        }
        let (behind, width) = self.dice.of(&FIELDS);
        (if self.dice.roll(6) == 0 { self.place(behind) } else { self.record(behind) }, width)
    }

    fn read(&mut self) -> Var {
        let (place, width) = self.field();
        self.b.load(place, width, OnFault::SkipStatement)
    }

    fn write(&mut self) {
        self.begin();
        let mut value = match self.dice.roll(4) {
            0 => self.b.constant(self.dice.of(&[0, 1, 0x7FFF, 0x3F80_0000])),
            1 => self.counter()[1],
            _ => self.read(),
        };
        if self.dice.roll(2) == 0 {
            let more = self.read();
            value = self.b.compute(self.dice.of(&[Op::AddU32, Op::SubU32, Op::XorU32, Op::AddF32]), &[value, more]);
        }
        let (place, width) = self.field();
        self.b.store(place, width, value);
    }

    /// Three statements that leave numbers.
    fn leave(&mut self) {
        for left in LEFT {
            self.begin();
            let value = if self.dice.roll(2) == 0 { self.counter()[1] } else { self.read() };
            self.b.store(fixed(left), Width::DoubleWord, value);
        }
    }

    fn sum(&mut self) {
        self.begin();
        let sum = self.dice.of(&SUMS);
        let (before, more) = (self.load(sum, Width::DoubleWord), self.read());
        let after = self.b.compute(Op::AddU32, &[before, more]);
        self.b.store(fixed(sum), Width::DoubleWord, after);
    }

    fn statement(&mut self) {
        match self.dice.roll(6) {
            0 => self.sum(),
            1 => {
                self.begin();
                let bit = self.b.constant(1);
                self.b.store(fixed(SEEN), Width::Bit, bit);
            }
            2 | 3 => self.write(),
            _ => self.copy(),
        }
    }

    /// Statements behind a comparison of two fields, which may jump over them.
    fn choice(&mut self) {
        self.begin();
        let (behind, width) = self.dice.of(&FIELDS[..3]);
        let [a, b] = [0, 1].map(|_| {
            let place = self.record(behind);
            let value = self.b.load(place, width, OnFault::SkipStatement);
            if width == Width::Word { self.b.compute(Op::Extend16, &[value]) } else { value }
        });
        let condition = self.b.compute(self.compares, &[a, b]);
        let swaps = self.dice.roll(2) == 0;
        let leaves = self.dice.roll(5) == 0;
        let more = self.dice.roll(3) as u32 + u32::from(!swaps);
        let statements = more + if swaps { 3 } else { 0 } + if leaves { 3 } else { 0 };
        self.b.push(Inst::Branch { condition, to: Target(self.statements + statements) });
        if swaps && self.copies {
            self.swap();
        } else if swaps {
            (0..3).for_each(|_| self.write());
        }
        if leaves {
            self.leave();
        }
        for _ in 0..more {
            self.statement();
        }
    }

    fn body(&mut self) {
        if self.dice.roll(4) == 0 {
            self.statement();
        }
        self.choice();
        if self.dice.roll(3) == 0 {
            self.choice();
        }
        if self.dice.roll(3) == 0 {
            self.statement();
        }
    }

    fn looping(&mut self) {
        let (first, last) = if self.down { (9, self.dice.of(&[1, 1, 4])) } else { (1, self.dice.of(&[1, 5, 10, 10])) };
        let width = if self.short { Width::Word } else { Width::DoubleWord };
        self.begin();
        let first = self.b.constant(first);
        self.b.store(fixed(COUNTER), width, first);
        let head = self.statements;
        self.body();
        self.begin();
        let [counter, _] = self.counter();
        let step = self.b.constant(if self.down { 0xFFFF_FFFF } else { 1 });
        let next = self.b.compute(if self.short { Op::AddU16 } else { Op::AddU32 }, &[counter, step]);
        self.b.store(fixed(COUNTER), width, next);
        let last = self.b.constant(last);
        let again = match (self.down, self.short) {
            (true, true) => Op::GeI16,
            (true, false) => Op::GeI32,
            (false, true) => Op::LeI16,
            (false, false) => Op::LeI32,
        };
        let again = self.b.compute(again, &[next, last]);
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
    machine.budget = dice.of(&[0, 1, 3, 8, 30, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, SUMS[0], TEMPORARY + 1, ARRAY + 1, ARRAY + RECORD + 3, ARRAY + 5 * RECORD]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 7, 0xFF]);
    }
    Reaction::Continue
}

fn built(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let short = dice.roll(3) == 0;
    let down = dice.roll(4) == 0;
    let compares = dice.of(&[Op::LeI32, Op::LeI32, Op::GtI32, Op::GtF32, Op::Below]);
    let copies = dice.roll(4) != 0;
    let bits = dice.roll(4) == 0;
    Maker { b, dice, statements: 0, short, down, compares, copies, bits }.looping();
}

#[test]
fn records_are_exchanged_as_the_interpreter_does() {
    let (mut asked, mut finished, mut whole) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, LOCAL_BYTES, &|b| built(b, seed))]);
        let layout = noting::layout(&program);
        if seed < LISTED {
            let listing = Jit::listing(&program, &layout).expect("machine code");
            // The iterations that nobody looks at, and the loop as it stands.
            whole += usize::from(listing.matches("= load.i8x16").count() >= 2);
        }
        let engines = engines(&program, &layout);
        for round in 0..2 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 4, 12, 40, 100_000, 100_000, 100_000]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory.iter_mut().take(500).for_each(|byte| *byte = dice.of(&[0, 0, 1, 2, 0x3F, 0x40, 0x7F, 0x80, 0xC0, 0xFF]));
            };
            let dice = || Dice(seed + 2_000_000);
            let expected = all_engines_agree_beside(&engines, &prepare, &dice, &meddle, &format!("{seed} in round {round}"));
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 200 && finished > 800 && whole > 60, "{asked} questions, {finished} runs to the end, {whole} loops with copies");
}
