//! Counted loops with choices by numbers, one behind the other: what a way of the one wrote is read on the ways of the other one, by the
//! same number or by another one, and they do on all engines what the interpreter does.

use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Machine, Reaction};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, program, run};

const PROGRAMS: u64 = 80;
/// Iterations that call something choose between more than two ways.
const FUNCTION: BlockId = BlockId::fc(1);
/// Where the counter lies, in bytes, and how many iterations there are over records of so many bytes.
const COUNTER: u32 = 1_000;
const ITERATIONS: u64 = 13;
const RECORD: u32 = 16;
/// Numbers by which an iteration chooses, and what it writes, in bytes of a record.
const NUMBERS: [u32; 2] = [0, 2];
const RESULTS: [u32; 2] = [4, 8];
/// Ways of a choice.
const WAYS: u32 = 3;

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

    fn counter(&mut self) -> (Place, Var) {
        let place = Place::Fixed { area: Area::BitMemory, position: 8 * COUNTER };
        (place, self.b.load(place, Width::DoubleWord, OnFault::SkipStatement))
    }

    fn field(&mut self, byte: u32) -> Place {
        let (_, counter) = self.counter();
        let bits = self.b.constant(u64::from(8 * RECORD));
        let pointer = self.b.compute(Op::MulU32, &[counter, bits]);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * byte }
    }

    fn get(&mut self, byte: u32) -> Var {
        let place = self.field(byte);
        let width = if NUMBERS.contains(&byte) { Width::Word } else { Width::DoubleWord };
        self.b.load(place, width, OnFault::SkipStatement)
    }

    /// Writes something that is made of what was written before.
    fn result(&mut self) {
        self.begin();
        let [from, to] = [self.dice.of(&RESULTS), self.dice.of(&RESULTS)];
        let (before, more) = (self.get(from), self.b.constant(self.dice.of(&[1, 10, 100, 1000])));
        let value = self.b.compute(Op::AddU32, &[before, more]);
        let place = self.field(to);
        self.b.store(place, Width::DoubleWord, value);
    }

    /// A choice by one of the numbers, or one of two ways.
    fn choice(&mut self) {
        let is_one_of_two = self.dice.roll(3) == 0;
        if !is_one_of_two && self.dice.roll(3) == 0 {
            // Some iterations jump over all of it.
            self.begin();
            let by = self.dice.of(&NUMBERS);
            let (number, wanted) = (self.get(by), self.b.constant(2));
            let condition = self.b.compute(Op::GtI16, &[number, wanted]);
            self.b.push(Inst::Branch { condition, to: Target(self.statements + 1 + 2 * WAYS) });
        }
        self.begin();
        let number = self.dice.of(&NUMBERS);
        let index = self.get(number);
        let first = self.statements;
        if is_one_of_two {
            let wanted = self.b.constant(self.dice.roll(4));
            let condition = self.b.compute(Op::Equal, &[index, wanted]);
            self.b.push(Inst::Branch { condition, to: Target(first + 1) });
            return self.result();
        }
        let behind = first + 2 * WAYS;
        let of_way = |way: u64| Target(if way < u64::from(WAYS) { first + 2 * way as u32 } else { behind });
        let targets: Vec<Target> =
            (0..self.dice.of(&[3, 4, 11])).map(|label| if label < 3 { of_way(label) } else { of_way(self.dice.roll(6)) }).collect();
        let table = self.b.table(&targets);
        self.b.push(Inst::JumpTable { index, first: table, count: targets.len() as u32, otherwise: Target(behind) });
        for _ in 0..WAYS {
            self.result();
            self.begin();
            self.b.push(Inst::Jump { to: Target(behind) });
        }
    }

    fn looping(&mut self) {
        self.begin();
        let (place, none) = (self.counter().0, self.b.constant(0));
        self.b.store(place, Width::DoubleWord, none);
        self.begin();
        self.b.push(Inst::Call { callee: Callee::Block(FUNCTION), parameters: 0 });
        for _ in 0..2 + self.dice.roll(3) {
            self.choice();
        }
        self.begin();
        let ((place, counter), one, last) = (self.counter(), self.b.constant(1), self.b.constant(ITERATIONS));
        let next = self.b.compute(Op::AddU32, &[counter, one]);
        self.b.store(place, Width::DoubleWord, next);
        let again = self.b.compute(Op::LtI32, &[next, last]);
        self.b.push(Inst::Branch { condition: again, to: Target(1) });
        self.begin();
        self.b.push(Inst::Return);
    }
}

#[test]
fn choices_one_behind_the_other_are_those_of_the_interpreter() {
    let mut beside = 0;
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let nothing = |b: &mut Builder| {
            b.begin_statement();
            b.constant(1);
        };
        let looping = |b: &mut Builder| Maker { b, dice: Dice(seed), statements: 0 }.looping();
        let program = program(&[(block, 16, &looping), (FUNCTION, 0, &nothing)]);
        let layout = noting::layout(&program);
        let listing = Jit::listing(&program, &layout).expect("machine code");
        beside += usize::from(listing.contains("shuffle") || listing.contains("insertlane"));
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = 100_000;
            let memory = machine.memory.area_mut(Area::BitMemory);
            for record in memory.chunks_mut(RECORD as usize).take(ITERATIONS as usize) {
                record.fill(0);
                NUMBERS.iter().for_each(|&number| record[number as usize + 1] = dice.roll(6) as u8);
            }
        };
        let outcome = |engine: Arc<dyn Engine>| run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue);
        all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("{seed}\n{}", program.code[&block].code));
    }
    assert!(beside > PROGRAMS as usize / 2, "{beside} loops side by side");
}
