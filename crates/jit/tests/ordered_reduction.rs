//! Counted loops over records with a number that each iteration makes of that of the iteration before, in order, and of what it reads from
//! its record, where it has written that number to some of the same bytes before, or will later: on all engines they do what the
//! interpreter does.

use std::sync::Arc;

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, Machine};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, program, run};

const PROGRAMS: u64 = 300;
/// The records: where they begin, and the bytes of one.
const RECORDS: (u32, u32) = (32, 64);
const COUNT: u32 = 13;
/// The counter and the number that iterations hand on, in bytes.
const COUNTER: u32 = 1_040;
const NUMBER: u32 = 1_044;

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// A loop in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
}

impl Maker<'_> {
    fn get(&mut self, place: Place, width: Width) -> Var {
        self.b.load(place, width, OnFault::SkipStatement)
    }

    /// A field of the record of an iteration, by its first byte.
    fn field(&mut self, byte: u32) -> Place {
        let (counter, bits) = (self.get(fixed(COUNTER), Width::DoubleWord), self.b.constant(u64::from(8 * RECORDS.1)));
        let pointer = self.b.compute(Op::MulU32, &[counter, bits]);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * (RECORDS.0 + byte) }
    }

    /// Something that needs no order.
    fn beside(&mut self, byte: u32) {
        self.b.begin_statement();
        let (from, to) = (self.field(byte), self.field(byte + 4));
        let (before, counter) = (self.get(from, Width::DoubleWord), self.get(fixed(COUNTER), Width::DoubleWord));
        let sum = self.b.compute(Op::AddU32, &[before, counter]);
        let sum = self.b.compute(Op::XorU32, &[sum, before]);
        self.b.store(to, Width::DoubleWord, sum);
    }

    /// The number goes to the record, perhaps after the iteration has counted it on.
    fn put(&mut self) {
        self.b.begin_statement();
        let byte = self.dice.of(&[0, 2, 4, 4, 8]);
        let to = self.field(byte);
        let number = self.get(fixed(NUMBER), Width::DoubleWord);
        let width = self.dice.of(&[Width::DoubleWord, Width::DoubleWord, Width::Word]);
        self.b.store(to, width, number);
    }

    /// The number is counted on by what the record holds, or where a bit of that is set.
    fn count(&mut self) {
        self.b.begin_statement();
        let (byte, width) = self.dice.of(&[
            (0, Width::DoubleWord),
            (4, Width::DoubleWord),
            (4, Width::Word),
            (5, Width::Byte),
            (6, Width::Word),
            (7, Width::Bit),
            (8, Width::Byte),
            (12, Width::DoubleWord),
        ]);
        let from = self.field(byte);
        let own = self.get(from, width);
        let number = self.get(fixed(NUMBER), Width::DoubleWord);
        let (three, one) = (self.b.constant(3), self.b.constant(1));
        let product = self.b.compute(Op::MulU32, &[number, three]);
        let after = match width {
            Width::Bit => {
                let more = self.b.compute(Op::AddU32, &[product, one]);
                self.b.compute(Op::Select, &[own, more, number])
            }
            _ => self.b.compute(Op::AddU32, &[product, own]),
        };
        self.b.store(fixed(NUMBER), Width::DoubleWord, after);
    }

    fn looping(&mut self) {
        self.b.begin_statement();
        let first = self.b.constant(0);
        self.b.store(fixed(COUNTER), Width::DoubleWord, first);
        (0..5).for_each(|number| self.beside(16 + 8 * number));
        for _ in 0..2 + self.dice.roll(2) {
            if self.dice.roll(2) == 0 { self.put() } else { self.count() }
        }
        self.b.begin_statement();
        let (counter, one, count) = (self.get(fixed(COUNTER), Width::DoubleWord), self.b.constant(1), self.b.constant(COUNT.into()));
        let next = self.b.compute(Op::AddU32, &[counter, one]);
        self.b.store(fixed(COUNTER), Width::DoubleWord, next);
        let again = self.b.compute(Op::LtI32, &[next, count]);
        self.b.push(Inst::Branch { condition: again, to: Target(1) });
        self.b.begin_statement();
        self.b.push(Inst::Return);
    }
}

#[test]
fn numbers_made_in_order_are_those_of_the_interpreter() {
    let block = BlockId::ob(1);
    let mut beside = 0;
    for seed in seeds(PROGRAMS) {
        let program = program(&[(block, 16, &|b| Maker { b, dice: Dice(seed) }.looping())]);
        let layout = noting::layout(&program);
        let listing = Jit::listing(&program, &layout).expect("machine code");
        beside += usize::from(listing.contains("extractlane"));
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = 100_000;
            machine.memory.area_mut(Area::BitMemory).iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let outcome = |engine: Arc<dyn Engine>| run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| unreachable!("nothing fails"));
        let what = || format!("{seed}\n{}", program.code[&block].code);
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &what);
        assert_eq!(expected.exit, Exit::Finished, "{seed}");
    }
    const { assert!(RECORDS.0 + RECORDS.1 * COUNT <= COUNTER) };
    assert!(beside > 60, "{beside} loops are done side by side");
}
