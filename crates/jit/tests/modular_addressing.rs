//! Counted loops over records that read and write an element of an array of their own at an index of their own, as ring buffers in
//! instances of function blocks do: wherever that index leads, and whatever the Host makes of memory and budget, they do on all engines
//! what the interpreter does.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, program, run_beside};

const PROGRAMS: u64 = 250;
const QUESTIONS_MAX: usize = 60;
/// Two arrays of records: where they begin, and bytes of a record.
const ARRAYS: [(u32, u32); 2] = [(32, 32), (560, 34)];
const RECORDS: u32 = 13;
/// Where the variables lie, in bytes: the counter, a sum, and an index of all iterations.
const COUNTER: u32 = 1_040;
const SUM: u32 = 1_044;
const SHARED: u32 = 1_048;
/// The record before that of an iteration, in bits.
const BEHIND: u32 = 0_u32.wrapping_sub(8 * ARRAYS[0].1);
/// The number with which the counter begins.
const FIRST: u32 = 1;

/// Fields of a record: where they lie, in bits.
const FIELDS: &[(u32, Width)] = &[
    (0, Width::DoubleWord),
    (16, Width::Word),
    (32, Width::Byte),
    (32, Width::Byte),
    (64, Width::DoubleWord),
    (64, Width::DoubleWord),
    (64, Width::Word),
    (192, Width::DoubleWord),
    (224, Width::Word),
    (240, Width::Bit),
    (246, Width::Bit),
    (248, Width::Byte),
];
/// Where a record keeps its indexes, in bits.
const INDEXES: [(u32, Width); 3] = [(0, Width::Word), (16, Width::Word), (248, Width::Byte)];

/// An array in a record: where it begins, in bits, its elements, and how many of them are read and written, which may be too many.
#[derive(Clone, Copy)]
struct Ring {
    offset: u32,
    width: Width,
    limit: u64,
}

const RINGS: &[Ring] = &[
    Ring { offset: 96, width: Width::DoubleWord, limit: 3 },
    Ring { offset: 96, width: Width::DoubleWord, limit: 3 },
    Ring { offset: 96, width: Width::Word, limit: 6 },
    // Between two fields that are written.
    Ring { offset: 40, width: Width::Byte, limit: 3 },
    Ring { offset: 40, width: Width::Byte, limit: 3 },
    // Over a byte with bits.
    Ring { offset: 232, width: Width::Byte, limit: 3 },
    // Up to other fields, and to the next record or the one behind it.
    Ring { offset: 96, width: Width::DoubleWord, limit: 5 },
    Ring { offset: 40, width: Width::Byte, limit: 7 },
    Ring { offset: 128, width: Width::DoubleWord, limit: 8 },
    Ring { offset: 0, width: Width::Word, limit: 40 },
];

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// A loop over the records in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    arrays: &'static [(u32, u32)],
    rings: Vec<Ring>,
    fields: Vec<(u32, Width)>,
    indexes: Vec<(u32, Width)>,
    in_order: Option<&'static [Wanted]>,
    /// Whether the counter goes down.
    down: bool,
}

/// What an iteration reads and writes.
#[derive(Clone, Copy)]
enum Wanted {
    Field(u32, Width),
    Element,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn get(&mut self, place: Place, width: Width) -> Var {
        self.b.load(place, width, OnFault::SkipStatement)
    }

    /// Where the record of an iteration begins.
    fn record(&mut self) -> (Var, u32) {
        let (start, record) = self.dice.of(self.arrays);
        let counter = self.get(fixed(COUNTER), Width::DoubleWord);
        let bits = self.b.constant(u64::from(8 * record));
        let pointer = self.b.compute(Op::MulU32, &[counter, bits]);
        (pointer, (8 * start).wrapping_sub(8 * FIRST * record))
    }

    fn at(&mut self, offset: u32) -> Place {
        let (pointer, start) = self.record();
        Place::Indirect { area: Area::BitMemory, pointer, offset: start.wrapping_add(offset) & 0x00FF_FFFF }
    }

    /// Something in the record of an iteration, seldom in one beside it.
    fn at_or_near(&mut self, offset: u32, far: u64) -> Place {
        let neighbour = if self.dice.roll(far) == 0 { self.dice.of(&[1, -1]) } else { 0_i32 };
        self.at(offset.wrapping_add((neighbour * 8 * self.arrays[0].1 as i32) as u32))
    }

    fn field(&mut self) -> (Place, Width) {
        let (offset, width) = self.dice.of(&self.fields.clone());
        (self.at_or_near(offset, 6), width)
    }

    /// An index: mostly one that the record keeps, sometimes one step further.
    fn index(&mut self) -> Var {
        let (place, width) = match self.dice.roll(12) {
            0 => (fixed(SHARED), Width::Word),
            _ => {
                let (offset, width) = self.dice.of(&self.indexes.clone());
                (self.at(offset), width)
            }
        };
        let mut index = self.get(place, width);
        if self.dice.roll(4) == 0 {
            let (one, most) = (self.b.constant(1), self.b.constant(self.dice.of(&[2, 2, 5, 9])));
            let next = self.b.compute(Op::AddU16, &[index, one]);
            let (too_far, none) = (self.b.compute(Op::GtI16, &[next, most]), self.b.constant(0));
            index = self.b.compute(Op::Select, &[too_far, none, next]);
        }
        if width == Width::Word { self.b.compute(Op::Extend16, &[index]) } else { index }
    }

    /// An element of an array of the record.
    fn element(&mut self) -> (Place, Width) {
        let Ring { offset, width, limit } = self.rings[self.dice.roll(self.rings.len() as u64) as usize];
        let index = self.index();
        let limit = self.b.constant(limit);
        let inside = self.b.compute(Op::Below, &[index, limit]);
        self.b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: index });
        let index = self.b.compute(Op::Gate, &[index, inside]);
        let bits = self.b.constant(u64::from(8 * width.bytes()));
        let by = self.b.compute(Op::MulU32, &[index, bits]);
        let (pointer, start) = self.record();
        let pointer = match self.dice.roll(3) {
            0 => self.b.compute(Op::AddU32, &[by, pointer]),
            1 => {
                let more = self.b.constant(64);
                let pointer = self.b.compute(Op::AddU32, &[pointer, more]);
                let pointer = self.b.compute(Op::AddU32, &[pointer, by]);
                self.b.compute(Op::SubU32, &[pointer, more])
            }
            _ => self.b.compute(Op::AddU32, &[pointer, by]),
        };
        (Place::Indirect { area: Area::BitMemory, pointer, offset: start.wrapping_add(offset) & 0x00FF_FFFF }, width)
    }

    fn number(&mut self, depth: usize) -> Var {
        match self.dice.roll(if depth == 0 { 4 } else { 7 }) {
            0 => self.get(fixed(COUNTER), Width::DoubleWord),
            1 => self.b.constant(self.dice.of(&[0, 1, 2, 3, 100, 0xFFFF])),
            2 => {
                let (place, width) = self.field();
                self.get(place, width)
            }
            3 if self.dice.roll(3) == 0 => {
                let (place, width) = self.element();
                self.get(place, width)
            }
            3 => self.b.constant(5),
            _ => {
                let parts = [self.number(depth - 1), self.number(depth - 1)];
                self.b.compute(self.dice.of(&[Op::AddU32, Op::SubU32, Op::XorU32, Op::MinI32]), &parts)
            }
        }
    }

    fn bit(&mut self) -> Var {
        let parts = [self.number(1), self.number(1)];
        self.b.compute(self.dice.of(&[Op::LtI32, Op::Differ, Op::GeI32]), &parts)
    }

    fn statement(&mut self) {
        self.begin();
        let (place, width) = match self.dice.roll(10) {
            0 | 1 => self.element(),
            4 => (fixed(SUM), Width::DoubleWord),
            5 | 6 => return self.next_index(),
            _ => self.field(),
        };
        let mut value = if width == Width::Bit { self.bit() } else { self.number(2) };
        if place == fixed(SUM) {
            let before = self.get(place, width);
            value = self.b.compute(Op::AddU32, &[before, value]);
        }
        self.b.store(place, width, value);
    }

    /// Lets an index of the record go round, or makes another number of it.
    fn next_index(&mut self) {
        let (offset, width) = self.dice.of(&self.indexes.clone());
        let place = if self.dice.roll(6) == 0 { fixed(SHARED) } else { self.at_or_near(offset, 3) };
        let width = if place == fixed(SHARED) { Width::Word } else { width };
        let (index, one, count) = (self.get(place, width), self.b.constant(1), self.b.constant(3));
        let next = self.b.compute(Op::AddU16, &[index, one]);
        let next = match self.dice.roll(4) {
            0 => self.number(1),
            _ => self.b.compute(Op::RemI16, &[next, count]),
        };
        self.b.store(place, width, next);
    }

    /// Fields that are read and written, and elements between them or over them, in this order.
    fn in_order(&mut self, places: &[Wanted]) {
        for &wanted in places {
            self.begin();
            let is_field = !matches!(wanted, Wanted::Element);
            let (place, width) = match wanted {
                Wanted::Field(offset, width) => (self.at(offset), width),
                Wanted::Element => self.element(),
            };
            let more = self.b.constant(3);
            let value = match width {
                Width::Bit => {
                    let counter = self.get(fixed(COUNTER), Width::DoubleWord);
                    let parts = [counter, self.b.constant(6)];
                    self.b.compute(Op::LtI32, &parts)
                }
                _ => {
                    let before = if is_field { place } else { fixed(COUNTER) };
                    let before = self.get(before, if is_field { width } else { Width::DoubleWord });
                    self.b.compute(Op::AddU32, &[before, more])
                }
            };
            self.b.store(place, width, value);
        }
    }

    fn looping(&mut self) {
        self.begin();
        let last = self.dice.of(&[4, 8, 11]);
        let first = self.b.constant(if self.down { last } else { u64::from(FIRST) });
        self.b.store(fixed(COUNTER), Width::DoubleWord, first);
        if let Some(places) = self.in_order {
            self.in_order(places);
            return self.end(last);
        }
        let jumps = self.dice.of(&[1, 1, 3]);
        for _ in 0..3 + self.dice.roll(5) {
            let over = self.dice.roll(jumps) as u32;
            if over > 0 {
                self.begin();
                let condition = self.bit();
                self.b.push(Inst::Branch { condition, to: Target(self.statements + over) });
            }
            (0..over.max(1)).for_each(|_| self.statement());
        }
        self.end(last);
    }

    /// The end of an iteration, and of the loop.
    fn end(&mut self, last: u64) {
        self.begin();
        let counter = self.get(fixed(COUNTER), Width::DoubleWord);
        let one = self.b.constant(1);
        let next = self.b.compute(if self.down { Op::SubU32 } else { Op::AddU32 }, &[counter, one]);
        self.b.store(fixed(COUNTER), Width::DoubleWord, next);
        let last = self.b.constant(if self.down { u64::from(FIRST) } else { last });
        let again = self.b.compute(if self.down { Op::GeI32 } else { Op::LeI32 }, &[next, last]);
        self.b.push(Inst::Branch { condition: again, to: Target(1) });
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    // What is only told changes nothing.
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 3, 8, 30, 60, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, SHARED + 1, SUM, 33, 35, 65, 561, 595]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 7, 0xFF]);
    }
    Reaction::Continue
}

/// Runs a loop in some rounds with all engines: the questions, the runs to the end, and whether it is done side by side.
fn agree(seed: u64, looping: &dyn Fn(&mut Builder)) -> (usize, usize, bool) {
    let block = BlockId::ob(1);
    let program = program(&[(block, 16, looping)]);
    let layout = noting::layout(&program);
    let listing = Jit::listing(&program, &layout).expect("machine code");
    let (mut asked, mut finished) = (0, 0);
    let engines = engines(&program, &layout);
    for round in 0..3 {
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000 + round);
            machine.budget = dice.of(&[1, 12, 40, 100_000, 100_000, 100_000, 100_000]);
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory.iter_mut().take(1_100).for_each(|byte| *byte = dice.roll(256) as u8);
            // Mostly all indexes lead into the arrays, and few of them out of them.
            let limit = dice.of(&[2, 3, 3, 3, 6]);
            for (start, bytes) in ARRAYS {
                for record in 0..RECORDS {
                    for (offset, width) in INDEXES {
                        let at = (start + bytes * record + offset / 8) as usize;
                        let index = dice.roll(limit) as u8;
                        let own = &mut memory[at..at + width.bytes() as usize];
                        own.fill(0);
                        own[width.bytes() as usize - 1] = index;
                    }
                }
            }
            memory[SHARED as usize..SHARED as usize + 2].copy_from_slice(&[0, dice.roll(4) as u8]);
        };
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
        let what = || format!("{seed} in round {round}\n{}", program.code[&block].code);
        let expected = all_engines_agree(&engines, true, &outcome, &what);
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    (asked, finished, listing.contains("extractlane"))
}

#[test]
fn elements_at_own_indexes_are_those_of_the_interpreter() {
    let (mut asked, mut finished, mut beside) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed + 3_000_000);
        // Often one array and little in it, so that nothing else keeps iterations from being done at once.
        let arrays = if seed % 4 == 0 { &ARRAYS[..] } else { &ARRAYS[..1] };
        let rings: Vec<Ring> = (0..1 + seed % 5 / 4).map(|_| dice.of(RINGS)).collect();
        let fields: Vec<(u32, Width)> = (0..dice.of(&[2, 3, 6])).map(|_| dice.of(FIELDS)).collect();
        let indexes: Vec<(u32, Width)> = (0..dice.of(&[1, 1, 3])).map(|_| dice.of(&INDEXES)).collect();
        let looping = |b: &mut Builder| {
            let (rings, fields, indexes) = (rings.clone(), fields.clone(), indexes.clone());
            Maker { b, dice: Dice(seed), statements: 0, arrays, rings, fields, indexes, in_order: None, down: seed % 3 == 0 }.looping();
        };
        let (questions, runs, is_beside) = agree(seed, &looping);
        (asked, finished, beside) = (asked + questions, finished + runs, beside + usize::from(is_beside));
    }
    const { assert!(ARRAYS[0].0 + ARRAYS[0].1 * RECORDS <= ARRAYS[1].0 && ARRAYS[1].0 + ARRAYS[1].1 * RECORDS <= COUNTER) };
    assert!(asked > 160 && finished > 440 && beside > 25, "{asked} questions, {finished} runs to the end, {beside} loops side by side");
}

#[test]
fn fields_beside_such_elements_are_written_together_without_them() {
    use Wanted::{Element, Field};
    let between = Ring { offset: 96, width: Width::Byte, limit: 3 };
    let over_bits = Ring { offset: 232, width: Width::Byte, limit: 3 };
    let fields: [(Ring, (u32, Width), &'static [Wanted]); 4] = [
        (between, (0, Width::Word), &[Field(64, Width::DoubleWord), Element, Field(120, Width::Byte), Field(192, Width::DoubleWord)]),
        (between, (0, Width::Word), &[Field(94, Width::Bit), Element, Field(120, Width::Byte), Field(192, Width::DoubleWord)]),
        // The index of the next iteration, which reads what this one has written.
        (over_bits, (0, Width::Word), &[Field(64, Width::DoubleWord), Field(192, Width::DoubleWord), Element, Field(BEHIND, Width::Word)]),
        (over_bits, (0, Width::Word), &[Field(240, Width::Bit), Element, Field(246, Width::Bit), Field(192, Width::DoubleWord)]),
    ];
    for (seed, (ring, index, places)) in (0..).zip(fields) {
        let down = places.iter().any(|place| matches!(place, Field(BEHIND, _)));
        let looping = |b: &mut Builder| {
            let (rings, fields, indexes) = (vec![ring], vec![(192, Width::DoubleWord)], vec![index]);
            Maker { b, dice: Dice(5), statements: 0, arrays: &ARRAYS[..1], rings, fields, indexes, in_order: Some(places), down }.looping();
        };
        let beside: Vec<bool> = (0..8).map(|round| agree(100 * seed + round, &looping).2).collect();
        assert!(down != beside.contains(&true), "{seed} is not done side by side");
    }
}
