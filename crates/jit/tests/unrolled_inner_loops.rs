//! Loops that call a function block for each element of an array, in which there are loops of few iterations: over an array in the
//! instance, with choices, with ends before the last iteration, in one another and under conditions, or such that end when the data say so.
//! Beside them iterations hand on numbers in order. On all engines they do what the interpreter does, whatever a Host makes of memory and
//! budget.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, fixed, get, layout_with, next_iteration, program, run_beside};

const PROGRAMS: u64 = 200;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Instances, and bytes of one.
const INSTANCES: u64 = 11;
const BYTES: u64 = 48;
const DATA_BYTES: usize = (INSTANCES * BYTES) as usize;
/// The function block, and a function that it calls in its loops.
const BLOCK: u16 = 1;
/// In an instance: counters of 16 bits, flags, numbers, and an array of so many numbers.
const COUNTERS: [u32; 2] = [0, 16];
const RING: u32 = 32;
const FLAGS: u32 = 48;
const NUMBERS: u32 = 64;
const ARRAY: u32 = 192;
const ELEMENTS: u64 = 6;
/// In bit memory: the counter of the outer loop, numbers that its iterations hand on, and a sum.
const COUNTER: u32 = 0;
const HANDED: [u32; 3] = [8, 12, 24];
const SUM: u32 = 16;

fn own(offset: u32) -> Place {
    Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

/// A block in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    /// Whether its numbers are REALs.
    reals: bool,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    /// The element of the array in the instance whose number is in a variable.
    fn element(&mut self, counter: u32) -> Place {
        let mut number = load(self.b, own(counter), Width::Word);
        number = self.b.compute(Op::Extend16, &[number]);
        let count = self.b.constant(if self.dice.roll(12) == 0 { 3 } else { ELEMENTS });
        let inside = self.b.compute(Op::Below, &[number, count]);
        self.b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
        number = self.b.compute(Op::Gate, &[number, inside]);
        let bits = self.b.constant(32);
        let by = self.b.compute(Op::MulU32, &[number, bits]);
        let pointer = self.b.compute(Op::AddU32, &[Register::Ar2.into(), by]);
        Place::Indirect { area: Area::InstanceData, pointer, offset: ARRAY }
    }

    /// A number: a variable of the instance, or an element of its array.
    fn number(&mut self, counter: Option<u32>) -> Place {
        match (self.dice.roll(3), counter) {
            (0, Some(counter)) => self.element(counter),
            _ => own(NUMBERS + 32 * self.dice.roll(4) as u32),
        }
    }

    fn assigns(&mut self, counter: Option<u32>) {
        self.begin();
        let to = self.number(counter);
        let from = if self.dice.roll(2) == 0 { to } else { self.number(counter) };
        let other = self.number(counter);
        let [one, other] = [from, other].map(|place| load(self.b, place, Width::DoubleWord));
        let ops: &[Op] = if self.reals { &[Op::AddF32, Op::MulF32, Op::SubF32, Op::MaxF32] } else { &[Op::AddU32, Op::XorU32, Op::SubU32] };
        let value = match counter {
            Some(counter) if !self.reals && self.dice.roll(4) == 0 => {
                let number = load(self.b, own(counter), Width::Word);
                self.b.compute(Op::AddU32, &[one, number])
            }
            _ => {
                let op = self.dice.of(ops);
                self.b.compute(op, &[one, other])
            }
        };
        self.b.store(to, Width::DoubleWord, value);
    }

    /// Whether something holds that each instance may answer in its own way.
    fn condition(&mut self, counter: Option<u32>) -> Var {
        if self.dice.roll(2) == 0 {
            return load(self.b, own(FLAGS + self.dice.roll(3) as u32), Width::Bit);
        }
        let [a, b] = [self.number(counter), self.number(counter)].map(|place| load(self.b, place, Width::DoubleWord));
        self.b.compute(if self.reals { Op::LtF32 } else { Op::LtI32 }, &[a, b])
    }

    /// Writes something that needs to know where it ends: that is known when it is written once more.
    fn write_to_end(&mut self, write: impl Fn(&mut Maker<'_>, u32)) {
        let mut first = Maker { b: &mut Builder::default(), dice: Dice(self.dice.0), ..*self };
        write(&mut first, 0);
        let behind = first.statements;
        write(self, behind);
    }

    /// `FOR counter := first TO last DO … END_FOR` with constants, mostly.
    fn loops(&mut self, depth: usize) {
        self.write_to_end(|maker, behind| maker.loops_to(depth, behind));
    }

    fn loops_to(&mut self, depth: usize, behind: u32) {
        let counter = COUNTERS[depth];
        self.begin();
        let first = match self.dice.roll(24) {
            0 => load(self.b, own(RING), Width::Word),
            _ => self.b.constant(self.dice.of(&[0, 0, 1])),
        };
        self.b.store(own(counter), Width::Word, first);
        let head = Target(self.statements);
        for _ in 0..1 + self.dice.roll(3) {
            match self.dice.roll(8) {
                0 if depth == 0 => self.loops(1),
                1 => {
                    self.begin();
                    let condition = self.condition(Some(counter));
                    self.b.push(Inst::Branch { condition, to: Target(behind) });
                }
                2 | 3 => {
                    self.begin();
                    let condition = self.condition(Some(counter));
                    self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
                    self.assigns(Some(counter));
                }
                _ => self.assigns(Some(counter)),
            }
        }
        self.begin();
        let last = 1 + self.dice.roll(if depth == 0 { 6 } else { 2 });
        next_iteration(self.b, own(counter), (Op::LeI16, last), head);
    }

    /// `counter := 0; WHILE number > array[counter] DO counter := counter + 1; … END_WHILE`, or until a number has become small.
    fn searches(&mut self) {
        self.write_to_end(|maker, behind| maker.searches_to(behind));
    }

    fn searches_to(&mut self, behind: u32) {
        let counter = COUNTERS[0];
        self.begin();
        let zero = self.b.constant(0);
        self.b.store(own(counter), Width::Word, zero);
        let counts_down = self.dice.roll(3) == 0;
        let (looks_first, ends_early) = (self.dice.roll(2) == 0, self.dice.roll(4) == 0);
        let head = Target(self.statements);
        if looks_first {
            self.begin();
            let again = self.goes_on(counts_down);
            let leaves = self.b.compute(Op::Not, &[again]);
            self.b.push(Inst::Branch { condition: leaves, to: Target(behind) });
        }
        if ends_early {
            self.begin();
            let condition = self.condition(None);
            self.b.push(Inst::Branch { condition, to: Target(behind) });
        }
        self.begin();
        let (number, one) = (load(self.b, own(counter), Width::Word), self.b.constant(1));
        let next = self.b.compute(Op::AddU16, &[number, one]);
        self.b.store(own(counter), Width::Word, next);
        if counts_down {
            self.begin();
            let (number, less) =
                (load(self.b, own(NUMBERS), Width::DoubleWord), self.b.constant(if self.reals { 0x3F80_0000 } else { 0x1000_0000 }));
            let number = self.b.compute(if self.reals { Op::SubF32 } else { Op::SubU32 }, &[number, less]);
            self.b.store(own(NUMBERS), Width::DoubleWord, number);
        }
        if self.dice.roll(2) == 0 {
            self.assigns(None);
        }
        self.begin();
        if looks_first {
            self.b.push(Inst::Jump { to: head });
        } else {
            let again = self.goes_on(counts_down);
            self.b.push(Inst::Branch { condition: again, to: head });
            if self.dice.roll(2) == 0 {
                self.b.push(Inst::Jump { to: Target(behind) });
            }
        }
        // What it has found.
        self.begin();
        let from = if self.dice.roll(2) == 0 { self.element(counter) } else { own(NUMBERS + 32) };
        let value = load(self.b, from, Width::DoubleWord);
        self.b.store(own(NUMBERS + 32), Width::DoubleWord, value);
    }

    /// Whether such a loop goes on.
    fn goes_on(&mut self, counts_down: bool) -> Var {
        let number = load(self.b, own(NUMBERS), Width::DoubleWord);
        let limit = if counts_down {
            self.b.constant(if self.reals { 0x3F00_0000 } else { 0x0100_0000 })
        } else {
            let element = self.element(COUNTERS[0]);
            load(self.b, element, Width::DoubleWord)
        };
        self.b.compute(if self.reals { Op::GtF32 } else { Op::GtI32 }, &[number, limit])
    }

    /// Writes to the element of a ring and goes on to the next one.
    fn ring(&mut self) {
        self.begin();
        let from = self.number(None);
        let value = load(self.b, from, Width::DoubleWord);
        let to = self.element(RING);
        self.b.store(to, Width::DoubleWord, value);
        self.begin();
        let (number, one) = (load(self.b, own(RING), Width::Word), self.b.constant(1));
        let next = self.b.compute(Op::AddU16, &[number, one]);
        let count = self.b.constant(ELEMENTS);
        let next = self.b.compute(Op::RemI16, &[next, count]);
        self.b.store(own(RING), Width::Word, next);
    }

    /// The function block.
    fn block(mut self) {
        for _ in 0..1 + self.dice.roll(4) {
            match self.dice.roll(8) {
                0 => self.ring(),
                1 => {
                    // A loop that some instances jump over.
                    self.write_to_end(|maker, behind| maker.conditional_loop(behind));
                }
                2 | 3 => self.searches(),
                4..7 => self.loops(0),
                _ => self.assigns(None),
            }
        }
        self.begin();
        let value = load(self.b, own(FLAGS), Width::Bit);
        self.b.store(own(FLAGS + 8), Width::Bit, value);
    }

    fn conditional_loop(&mut self, behind: u32) {
        self.begin();
        let condition = self.condition(None);
        self.b.push(Inst::Branch { condition, to: Target(behind) });
        self.loops(0);
    }

    /// A number that iterations hand on is counted on, by itself, the other one, or what the instance holds.
    fn hand_on(&mut self, instance: u32) {
        self.begin();
        let (to, from) = (self.dice.of(&HANDED), self.dice.of(&HANDED));
        let number = get(self.b, from, Width::DoubleWord);
        let after = match self.dice.roll(4) {
            0 => number,
            1 => {
                let own = self.of_instance(instance);
                self.b.compute(Op::AddU32, &[number, own])
            }
            _ => {
                let (by, more) = (self.b.constant(1103), self.b.constant(12_345));
                let product = self.b.compute(Op::MulU32, &[number, by]);
                let sum = self.b.compute(Op::AddU32, &[product, more]);
                let (op, by) = self.dice.of(&[(Op::Shr32, 16), (Op::DivU64, 65_536), (Op::RemU64, 4_096), (Op::DivU64, 1)]);
                let by = self.b.constant(by);
                self.b.compute(op, &[sum, by])
            }
        };
        self.b.store(fixed(to), Width::DoubleWord, after);
    }

    /// A number in the instance of an iteration.
    fn of_instance(&mut self, instance: u32) -> Var {
        let pointer = get(self.b, instance, Width::DoubleWord);
        let offset = NUMBERS + 32 * self.dice.roll(8) as u32;
        self.b.load(Place::Indirect { area: Area::InstanceData, pointer, offset }, Width::DoubleWord, OnFault::SkipStatement)
    }

    /// The loop over the instances.
    fn all_instances(mut self) {
        const INSTANCE: u32 = 20;
        self.begin();
        let number = self.b.constant(1);
        self.b.push(Inst::Open { register: DataRegister::Instance, number });
        let zero = self.b.constant(0);
        self.b.store(fixed(COUNTER), Width::DoubleWord, zero);
        let head = Target(self.statements);
        self.begin();
        let (counter, bits) = (get(self.b, COUNTER, Width::DoubleWord), self.b.constant(8 * BYTES));
        let by = self.b.compute(Op::MulU32, &[counter, bits]);
        let first = self.b.constant(0x8400_0000);
        let pointer = self.b.compute(Op::AddU32, &[by, first]);
        self.b.store(fixed(INSTANCE), Width::DoubleWord, pointer);
        for _ in 0..self.dice.roll(5) {
            self.hand_on(INSTANCE);
        }
        self.begin();
        let pointer = get(self.b, INSTANCE, Width::DoubleWord);
        for _ in 0..self.dice.roll(3) {
            let handed = self.dice.of(&HANDED);
            let mut value = get(self.b, handed, Width::DoubleWord);
            if self.dice.roll(2) == 0 {
                let counter = get(self.b, COUNTER, Width::DoubleWord);
                value = self.b.compute(Op::XorU32, &[value, counter]);
            }
            let offset = NUMBERS + 32 * self.dice.roll(4) as u32;
            self.b.store(Place::Indirect { area: Area::InstanceData, pointer, offset }, Width::DoubleWord, value);
        }
        self.b.copy(Register::Ar2, pointer);
        self.b.push(Inst::Call { callee: Callee::Block(BlockId::fb(BLOCK)), parameters: 0 });
        for _ in 0..self.dice.roll(3) {
            self.hand_on(INSTANCE);
        }
        self.begin();
        let (sum, own) = (get(self.b, SUM, Width::DoubleWord), self.of_instance(INSTANCE));
        let sum = self.b.compute(if self.reals { Op::AddF32 } else { Op::AddU32 }, &[sum, own]);
        self.b.store(fixed(SUM), Width::DoubleWord, sum);
        self.begin();
        let (counter, one) = (get(self.b, COUNTER, Width::DoubleWord), self.b.constant(1));
        let next = self.b.compute(Op::AddU32, &[counter, one]);
        self.b.store(fixed(COUNTER), Width::DoubleWord, next);
        let last = self.b.constant(INSTANCES - 1);
        let again = self.b.compute(Op::LeI32, &[next, last]);
        self.b.push(Inst::Branch { condition: again, to: head });
        self.b.begin_statement();
        self.b.push(Inst::Return);
    }
}

/// Changes a few bytes and the budget, sometimes, and goes on.
fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 3, 10, 40, 200]);
    for _ in 0..dice.of(&[0, 0, 1, 3]) {
        let range = machine.memory.layout.data_blocks[&1].clone();
        machine.memory.arena[range.start + dice.roll(range.len() as u64) as usize] = dice.of(&[0, 1, 2, 7, 0x80, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn loops_of_few_iterations_in_the_iterations_of_others_do_what_the_interpreter_does() {
    let (mut asked, mut silent, mut beside) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let reals = seed % 3 == 0;
        let main = |b: &mut Builder| Maker { b, dice: Dice(10 * seed), statements: 0, reals }.all_instances();
        let block = |b: &mut Builder| Maker { b, dice: Dice(10 * seed + 1), statements: 0, reals }.block();
        let program = program(&[(BlockId::ob(1), 16, &main), (BlockId::fb(BLOCK), 16, &block)]);
        let layout = layout_with(&program, DATA_BYTES);
        let listing = Jit::listing(&program, &layout).expect("machine code");
        beside += usize::from(listing.contains("i32x4") || listing.contains("f32x4"));
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[5, 60, 600, 600]);
            machine.memory.area_mut(Area::BitMemory).iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            let range = machine.memory.layout.data_blocks[&1].clone();
            for (at, byte) in machine.memory.arena[range].iter_mut().enumerate() {
                let of_ring = (at as u64 % BYTES) as u32 * 8;
                *byte = match of_ring {
                    32 => 0,
                    40 => dice.roll(ELEMENTS) as u8,
                    _ if reals && of_ring >= NUMBERS && of_ring.is_multiple_of(32) => dice.of(&[0x3F, 0x40, 0xC0, 0x7F, 0xFF, 0]),
                    _ => dice.roll(256) as u8,
                };
            }
        };
        let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
        let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
        let questions = all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", listing())).asked.len();
        asked += questions;
        silent += usize::from(questions == 0);
    }
    assert!(asked > 250 && silent > 30 && beside > 50, "{asked} questions, {silent} programs without any, {beside} side by side");
}
