//! Loops as people write them who sort by insertion and search: a counter that each turn moves by one, up or down, in numbers of 16 or 32 bits,
//! records that are compared with what was taken out, with conditions of which a part decides, ways out in the middle, turns that count twice
//! or not at all. Whatever the Host makes of memory and budget, they do on all engines what the interpreter does.

use std::sync::Arc;

use sieben_engine::ir::verify;
use sieben_engine::ir::{Builder, Code, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Machine, Program, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, all_engines_agree_beside, engines, program, run};

const PROGRAMS: u64 = 400;
const QUESTIONS_MAX: usize = 40;
/// Records: where they begin in bit memory, and bytes of each.
const RECORDS: u32 = 64;
const RECORD: u32 = 12;
/// The counters, a number that is compared, one that counts, and bits.
const OUTER: u32 = 0;
const COUNTER: u32 = 4;
const KEY: u32 = 8;
const SUM: u32 = 12;
const BITS: u32 = 16;
const LOCAL_BYTES: u32 = 32;

/// How the inner loop counts.
#[derive(Clone, Copy)]
struct Counting {
    area: Area,
    width: Width,
    down: bool,
    /// Where it ends, and whether that is inside.
    last: u64,
    including: bool,
    /// Whether it counts before it does anything else.
    early: bool,
    /// In which form it is written: a difference, a sum with a negative number.
    negative: bool,
}

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    counting: Counting,
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

    fn count_of(&self, (area, byte): (Area, u32)) -> (Place, Width) {
        (Place::Fixed { area, position: 8 * byte }, self.counting.width)
    }

    /// A counter, as 32 bits.
    fn counter(&mut self, which: (Area, u32)) -> Var {
        let (place, width) = self.count_of(which);
        let value = self.load(place, width);
        if width == Width::Word { self.b.compute(Op::Extend16, &[value]) } else { value }
    }

    fn inner(&self) -> (Area, u32) {
        (self.counting.area, COUNTER)
    }

    /// A field of the record of a counter, or of one so far beside it.
    fn field(&mut self, which: (Area, u32), beside: i32, offset: u32) -> Place {
        let mut index = self.counter(which);
        if beside != 0 {
            let one = self.b.constant(1);
            index = self.b.compute(if beside > 0 { Op::AddU32 } else { Op::SubU32 }, &[index, one]);
        }
        let bits = self.b.constant(u64::from(8 * RECORD));
        let pointer = self.b.compute(Op::MulU32, &[index, bits]);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * (RECORDS + RECORD + offset) }
    }

    fn some_field(&mut self, offset: u32) -> Place {
        let (which, beside) = (self.inner(), self.dice.of(&[0, 0, 1, -1]));
        self.field(which, beside, offset)
    }

    /// Something that holds or not.
    fn compared(&mut self) -> Var {
        match self.dice.roll(8) {
            0 => {
                let position = 8 * BITS + self.dice.roll(4) as u32;
                self.load(Place::Fixed { area: Area::BitMemory, position }, Width::Bit)
            }
            1 => {
                let (counter, limit) = (self.counter(self.inner()), self.b.constant(self.dice.of(&[0, 3, 6, 20])));
                self.b.compute(self.dice.of(&[Op::LtI32, Op::Equal]), &[counter, limit])
            }
            2..=4 => {
                let place = self.some_field(4);
                let (value, key) = (self.load(place, Width::Word), self.load(fixed(KEY), Width::Word));
                self.b.compute(self.dice.of(&[Op::LtI16, Op::GtI16, Op::Equal, Op::EqI16]), &[value, key])
            }
            5 => {
                let place = self.some_field(8);
                self.load(place, Width::Bit)
            }
            _ => {
                let place = self.some_field(0);
                let (value, key) = (self.load(place, Width::DoubleWord), self.b.constant(self.dice.roll(4)));
                self.b.compute(self.dice.of(&[Op::LeI32, Op::GtI32, Op::Equal, Op::NeI32]), &[value, key])
            }
        }
    }

    fn condition(&mut self, depth: u32) -> Var {
        match self.dice.roll(if depth == 0 { 1 } else { 5 }) {
            0 => self.compared(),
            1 => {
                let condition = self.condition(depth - 1);
                self.b.compute(Op::Not, &[condition])
            }
            _ => {
                let args = [self.condition(depth - 1), self.condition(depth - 1)];
                self.b.compute(self.dice.of(&[Op::And, Op::Or, Op::Or, Op::And, Op::AndNot, Op::Xor]), &args)
            }
        }
    }

    /// A branch, with something that may fail in front of it now and then, or that is read behind what decides.
    fn branch(&mut self, to: u32) {
        self.begin();
        if self.dice.roll(8) == 0 {
            let (counter, limit) = (self.counter(self.inner()), self.b.constant(self.dice.of(&[3, 20])));
            let holds = self.b.compute(Op::LtI32, &[counter, limit]);
            self.b.push(Inst::Require { condition: holds, code: 0x22, register: counter });
        }
        let mut condition = self.condition(3);
        if self.dice.roll(8) == 0 {
            // Whether it fails is seen behind a part.
            let (counter, limit) = (self.counter(self.inner()), self.b.constant(self.dice.of(&[3, 20])));
            let holds = self.b.compute(Op::LtI32, &[counter, limit]);
            self.b.push(Inst::Require { condition: holds, code: 0x22, register: counter });
            let other = self.compared();
            condition = self.b.compute(self.dice.of(&[Op::And, Op::Or]), &[condition, other]);
        }
        self.b.push(Inst::Branch { condition, to: Target(to) });
    }

    fn step(&mut self) {
        self.begin();
        let Counting { width, down, negative, .. } = self.counting;
        let (place, _) = self.count_of(self.inner());
        let value = self.load(place, width);
        let (number, op) = match (width, down, negative) {
            (Width::Word, true, true) => (0xFFFF, Op::AddU16),
            (Width::Word, true, false) => (1, Op::SubU16),
            (Width::Word, false, _) => (1, Op::AddU16),
            (_, true, true) => (0xFFFF_FFFF, Op::AddU32),
            (_, true, false) => (1, Op::SubU32),
            (_, false, _) => (1, Op::AddU32),
        };
        let number = self.b.constant(number);
        let next = self.b.compute(op, &[value, number]);
        self.b.store(place, width, next);
    }

    /// Whether the inner loop goes on.
    fn goes_on(&mut self) -> Var {
        let Counting { width, down, last, including, .. } = self.counting;
        let (place, _) = self.count_of(self.inner());
        let (value, last) = (self.load(place, width), self.b.constant(last));
        let op = match (width, down, including) {
            (Width::Word, true, true) => Op::GeI16,
            (Width::Word, true, false) => Op::GtI16,
            (Width::Word, false, true) => Op::LeI16,
            (Width::Word, false, false) => Op::LtI16,
            (_, true, true) => Op::GeI32,
            (_, true, false) => Op::GtI32,
            (_, false, true) => Op::LeI32,
            (_, false, false) => Op::LtI32,
        };
        self.b.compute(op, &[value, last])
    }

    /// One statement that writes something.
    fn writes(&mut self, counts: bool) {
        match self.dice.roll(if counts { 5 } else { 4 }) {
            0 => {
                self.begin();
                let (old, one) = (self.load(fixed(SUM), Width::DoubleWord), self.b.constant(1));
                let sum = self.b.compute(Op::AddU32, &[old, one]);
                self.b.store(fixed(SUM), Width::DoubleWord, sum);
            }
            1 => {
                self.begin();
                let (from, to) = (self.field(self.inner(), -1, 0), self.field(self.inner(), 0, 0));
                self.b.push(Inst::Move { from, to, bytes: RECORD });
            }
            2 => {
                self.begin();
                let (value, place) = (self.load(fixed(KEY), Width::Word), self.some_field(4));
                self.b.store(place, Width::Word, value);
            }
            3 => {
                self.begin();
                let (value, place) = (self.b.constant(self.dice.roll(2)), self.some_field(8));
                self.b.store(place, Width::Bit, value);
            }
            _ => self.step(),
        }
    }

    fn inner_loop(&mut self) {
        // What the loop consists of: statements, a way out, a way to its end, something that is jumped over.
        let parts: Vec<u64> = (0..1 + self.dice.roll(4)).map(|_| self.dice.of(&[0, 0, 1, 1, 1, 2, 3, 3, 4])).collect();
        let counts_twice = self.dice.roll(8) == 0;
        let sizes = [1, 1, 1, 2, 2];
        let size: u32 = parts.iter().map(|&part| sizes[part as usize]).sum();
        let early = self.counting.early;
        let (first, last) = (self.statements + 1, self.statements + 2 + size);
        let (counts, behind) = (if early { last } else { last - 1 }, last + 1);
        self.begin();
        let goes_on = self.goes_on();
        let condition = self.b.compute(Op::Not, &[goes_on]);
        self.b.push(Inst::Branch { condition, to: Target(behind) });
        if early {
            self.step();
        }
        for part in parts {
            match part {
                0 => self.writes(counts_twice),
                1 => self.branch(behind),
                2 => {
                    let to = if self.dice.roll(6) == 0 { last } else { counts };
                    self.branch(to);
                }
                3 => {
                    let to = self.statements + 2;
                    self.branch(to);
                    self.writes(counts_twice);
                }
                _ => {
                    // As a compiler writes EXIT.
                    let to = self.statements + 2;
                    self.branch(to);
                    self.begin();
                    self.b.push(Inst::Jump { to: Target(behind) });
                }
            }
        }
        if !early {
            self.step();
        }
        self.begin();
        let goes_on = self.goes_on();
        if self.dice.roll(3) == 0 {
            let other = self.compared();
            let condition = self.b.compute(self.dice.of(&[Op::And, Op::Or]), &[other, goes_on]);
            self.b.push(Inst::Branch { condition, to: Target(first) });
        } else {
            self.b.push(Inst::Branch { condition: goes_on, to: Target(first) });
        }
    }

    fn main(mut self) {
        let outer = (Area::BitMemory, OUTER);
        self.begin();
        let (place, width) = self.count_of(outer);
        let first = self.b.constant(1);
        self.b.store(place, width, first);
        let again = self.statements;
        self.begin();
        let place = self.field(outer, 0, 4);
        let key = self.load(place, Width::Word);
        self.b.store(fixed(KEY), Width::Word, key);
        self.begin();
        let value = match self.dice.roll(4) {
            0 => self.b.constant(self.dice.of(&[0, 5, 8])),
            _ => self.load(self.count_of(outer).0, width),
        };
        self.b.store(self.count_of(self.inner()).0, width, value);
        self.inner_loop();
        self.begin();
        let (value, place) = (self.load(fixed(KEY), Width::Word), self.field(self.inner(), 0, 4));
        self.b.store(place, Width::Word, value);
        self.begin();
        let (place, width) = self.count_of(outer);
        let (old, one, limit) = (self.load(place, width), self.b.constant(1), self.b.constant(8));
        let word = width == Width::Word;
        let next = self.b.compute(if word { Op::AddU16 } else { Op::AddU32 }, &[old, one]);
        self.b.store(place, width, next);
        let goes_on = self.b.compute(if word { Op::LeI16 } else { Op::LeI32 }, &[next, limit]);
        self.b.push(Inst::Branch { condition: goes_on, to: Target(again) });
        self.begin();
        let (place, width) = self.count_of(self.inner());
        let value = self.load(place, width);
        self.b.store(fixed(20), width, value);
        self.begin();
        self.b.push(Inst::Return);
    }
}

fn random_program(seed: u64) -> Program {
    let mut dice = Dice(seed);
    let down = dice.roll(2) == 0;
    let counting = Counting {
        area: dice.of(&[Area::BitMemory, Area::BitMemory, Area::Local]),
        width: dice.of(&[Width::Word, Width::Word, Width::DoubleWord]),
        down,
        last: if down { dice.of(&[0, 0, 1]) } else { dice.of(&[8, 9]) },
        including: dice.roll(2) == 0,
        early: dice.roll(4) == 0,
        negative: dice.roll(3) == 0,
    };
    let main = |b: &mut Builder| Maker { b, dice: Dice(seed + 500_000), statements: 0, counting }.main();
    let mut program = program(&[(BlockId::ob(1), LOCAL_BYTES, &main)]);
    program.code.values_mut().for_each(|block| with_few_temporaries(&mut block.code));
    program
}

/// Lets the temporaries of each statement be as few as they can be: each is written again when nobody reads it any more.
fn with_few_temporaries(code: &mut Code) {
    for statement in 0..code.statement_count() {
        let insts = &mut code.insts[code.statements[statement] as usize..code.statements[statement + 1] as usize];
        let mut names: Vec<(Var, usize)> = Vec::new();
        for at in 0..insts.len() {
            let (read, rest): (Vec<Var>, Vec<Inst>) = (verify::reads(&insts[at]).collect(), insts[at + 1..].to_vec());
            let old = names.clone();
            let new = |var: Var| match old.iter().find(|(other, _)| *other == var) {
                Some(&(_, name)) => Var::temporary(name).expect("a temporary"),
                None => var,
            };
            let named = |insts: &[Inst], var: Var| insts.iter().any(|inst| verify::reads(inst).any(|other| other == var));
            names.retain(|(var, _)| !read.contains(var) || named(&rest, *var));
            let written = verify::writes(&insts[at]).filter(|dst| dst.register().is_none());
            let free = (0..).find(|name| names.iter().all(|(_, other)| other != name)).expect("a number");
            let to = |dst: Var| if Some(dst) == written { Var::temporary(free).expect("a temporary") } else { dst };
            match &mut insts[at] {
                Inst::Constant { dst, .. } => *dst = to(*dst),
                Inst::Compute { op, dst, args } => {
                    args[..op.arity()].iter_mut().for_each(|arg| *arg = new(*arg));
                    *dst = to(*dst);
                }
                Inst::Load { dst, place, .. } => {
                    if let Place::Indirect { pointer, .. } = place {
                        *pointer = new(*pointer);
                    }
                    *dst = to(*dst);
                }
                Inst::Store { place, src, .. } => {
                    if let Place::Indirect { pointer, .. } = place {
                        *pointer = new(*pointer);
                    }
                    *src = new(*src);
                }
                Inst::Move { from, to, .. } => {
                    for place in [from, to] {
                        if let Place::Indirect { pointer, .. } = place {
                            *pointer = new(*pointer);
                        }
                    }
                }
                Inst::Require { condition, register, .. } => (*condition, *register) = (new(*condition), new(*register)),
                Inst::Branch { condition, .. } => *condition = new(*condition),
                _ => {}
            }
            names.extend(written.map(|dst| (dst, free)));
        }
    }
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
        let place = dice.of(&[1, 5, 7, 5, 7, 9, 16, 80, 93]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 5, 8, 0x7F, 0xFF]);
    }
    if dice.roll(6) == 0 {
        let place = dice.of(&[OUTER, COUNTER, COUNTER + 2]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place..place + 2].copy_from_slice(&dice.of(&[[0xFF, 0xFF], [0x7F, 0xFF], [0x80, 0]]));
    }
    Reaction::Continue
}

#[test]
fn loops_whose_budget_a_variable_counts_do_what_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let program = random_program(seed);
        let layout = noting::layout(&program);
        let engines = engines(&program, &layout);
        for round in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 4, 12, 40, 400]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory.iter_mut().take(230).enumerate().for_each(|(at, byte)| {
                    let counts = at % 4 == 1 || at % 4 == 3 || at >= 64 && at % 12 == 0;
                    *byte = if counts { dice.roll(4) as u8 } else { 0 };
                });
            };
            let dice = || Dice(seed + 2_000_000);
            let expected = all_engines_agree_beside(&engines, &prepare, &dice, &meddle, &format!("{seed} in round {round}"));
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 2_800 && finished > 170, "{asked} questions, {finished} runs to the end");
}

/// A loop that counts from a number in memory on, past the end of its type.
fn counts_on(b: &mut Builder, (width, op): (Width, Op)) {
    let load = |b: &mut Builder, byte: u32, width: Width| b.load(fixed(byte), width, OnFault::SkipStatement);
    b.begin_statement();
    let (counter, one) = (load(b, COUNTER, width), b.constant(1));
    let next = b.compute(op, &[counter, one]);
    b.store(fixed(COUNTER), width, next);
    // A way out, so that the loop is done turn by turn.
    b.begin_statement();
    let out = b.load(Place::Fixed { area: Area::BitMemory, position: 8 * BITS }, Width::Bit, OnFault::SkipStatement);
    b.push(Inst::Branch { condition: out, to: Target(3) });
    b.begin_statement();
    let (sum, three) = (load(b, SUM, Width::DoubleWord), b.constant(3));
    let sum = b.compute(Op::AddU32, &[sum, three]);
    b.store(fixed(SUM), Width::DoubleWord, sum);
    let limit = b.constant(90);
    let goes_on = b.compute(Op::LtI32, &[sum, limit]);
    b.push(Inst::Branch { condition: goes_on, to: Target(0) });
    // Where the counter led is an address.
    b.begin_statement();
    let (counter, mask) = (load(b, COUNTER, width), b.constant(0xF8));
    let pointer = b.compute(Op::AndU32, &[counter, mask]);
    let value = b.constant(1);
    b.store(Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * RECORDS }, Width::Byte, value);
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn a_counter_that_turns_over_counts_no_budget() {
    for form in [(Width::Word, Op::AddU16), (Width::Word, Op::SubU16), (Width::DoubleWord, Op::AddU32), (Width::DoubleWord, Op::SubU32)] {
        let program = program(&[(BlockId::ob(1), 0, &|b: &mut Builder| counts_on(b, form))]);
        let layout = noting::layout(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let engines = engines(&program, &layout);
        for first in [[0x7F, 0xFF, 0xFF, 0xF8], [0x80, 0, 0, 8], [0x7F, 0xF8, 0, 0], [0x80, 8, 0, 0], [0; 4], [0xFF; 4]] {
            for budget in [3, 20, 400] {
                let prepare = |machine: &mut Machine| {
                    machine.budget = budget;
                    machine.memory.area_mut(Area::BitMemory)[COUNTER as usize..][..4].copy_from_slice(&first);
                };
                let outcome = |engine: Arc<dyn Engine>| {
                    let answer = |machine: &mut Machine, _: &str, asked: usize| {
                        let left = machine.budget;
                        machine.memory.area_mut(Area::BitMemory)[250..254].copy_from_slice(&(left as i32).to_be_bytes());
                        machine.budget = budget + asked as i64;
                        Reaction::Continue
                    };
                    run(engine.as_ref(), &layout, &entry, &prepare, &answer)
                };
                all_engines_agree(&engines, false, &outcome, &|| format!("{form:?} from {first:?}"));
            }
        }
    }
}
