//! Loops that fill and cross out bits and bytes of arrays: with counters of 16 and 32 bits, with and without sign, with steps that are
//! constants or variables, wherever the bits begin and whenever somebody looks.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Entry, Exit, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout_with, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 500;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Bytes of the data block.
const DATA_BYTES: usize = 200;
/// Where the variables lie in bit memory, and in some programs in the array itself.
const VARIABLES: u32 = 200;

/// How a loop counts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Type {
    Dint,
    Int,
    Udint,
    Uint,
}

impl Type {
    fn width(self) -> Width {
        if matches!(self, Self::Dint | Self::Udint) { Width::DoubleWord } else { Width::Word }
    }

    fn add(self) -> Op {
        if self.width() == Width::DoubleWord { Op::AddU32 } else { Op::AddU16 }
    }
}

struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    of: Type,
    /// Counter, step and limit.
    places: [Place; 3],
    /// The limit, if it is a constant.
    limit: Option<u64>,
    /// Whether bytes are written, or bits.
    bytes: bool,
}

impl Maker<'_> {
    fn get(&mut self, variable: usize) -> Var {
        self.b.load(self.places[variable], self.of.width(), OnFault::SkipStatement)
    }

    fn begin_with(&mut self, variable: usize, value: u64) {
        self.b.begin_statement();
        let value = self.b.constant(value);
        self.b.store(self.places[variable], self.of.width(), value);
    }

    /// One bit or byte, where the counter points to.
    fn write(&mut self) {
        let counter = self.get(0);
        let number = if self.of == Type::Int { self.b.compute(Op::Extend16, &[counter]) } else { counter };
        let lower = self.dice.of(&[0, 0, 1, 2, 5]);
        let lower = self.b.constant(lower);
        let mut index = self.b.compute(Op::SubU32, &[number, lower]);
        let looked_at = self.dice.roll(3) != 0;
        let (width, value) = if self.bytes { (Width::Byte, self.dice.of(&[0, 1, 0xAA])) } else { (Width::Bit, self.dice.roll(2)) };
        let value = self.b.constant(value);
        let limit = if self.bytes { self.dice.of(&[100, 190, 199, 200, 201]) } else { self.dice.of(&[100, 800, 1500, 1600, 1600, 1700]) };
        let limit = self.b.constant(limit);
        let inside = self.b.compute(Op::Below, &[index, limit]);
        if looked_at {
            self.b.push(Inst::Require { condition: inside, code: 163, register: number });
            index = self.b.compute(Op::Gate, &[index, inside]);
        }
        if self.bytes {
            let bits = self.dice.of(&[3, 3, 3, 3, 2, 4]);
            let bits = self.b.constant(bits);
            index = self.b.compute(Op::Shl32, &[index, bits]);
        }
        let base = if self.bytes { self.dice.of(&[0, 0, 0, 8, 64, 1]) } else { self.dice.of(&[0, 0, 1, 3, 8, 64]) };
        let base = self.b.constant(base);
        let pointer = self.b.compute(Op::AddU32, &[base, index]);
        let offset = if self.bytes { self.dice.of(&[0, 0, 0, 16, 5]) } else { self.dice.of(&[0, 0, 16, 5]) };
        let place = Place::Indirect { area: Area::SharedData, pointer, offset };
        let written = if looked_at {
            let old = self.b.load(place, width, OnFault::SkipStatement);
            self.b.compute(Op::Select, &[inside, value, old])
        } else {
            value
        };
        self.b.store(place, width, written);
    }

    /// The condition of another iteration.
    fn again(&mut self, before: Var, next: Var, step: Var, careful: bool) -> Var {
        let limit = match self.limit {
            Some(limit) => self.b.constant(limit),
            None => self.get(2),
        };
        let inclusive = self.dice.roll(3) != 0;
        let up = match (self.of, inclusive) {
            (Type::Dint, true) => self.b.compute(Op::LeI32, &[next, limit]),
            (Type::Dint, false) => self.b.compute(Op::LtI32, &[next, limit]),
            (Type::Int, true) => self.b.compute(Op::LeI16, &[next, limit]),
            (Type::Int, false) => self.b.compute(Op::LtI16, &[next, limit]),
            (_, true) if self.dice.roll(2) == 0 => self.b.compute(Op::LeU64, &[next, limit]),
            (_, true) => self.b.compute(Op::GeU64, &[limit, next]),
            (_, false) if self.dice.roll(2) == 0 => self.b.compute(Op::Below, &[next, limit]),
            (_, false) => self.b.compute(Op::GtU64, &[limit, next]),
        };
        let (below, ge, overflows) = match self.of {
            Type::Dint => (Op::LtI32, Op::GeI32, Op::AddOverflowsI32),
            Type::Int => (Op::LtI16, Op::GeI16, Op::AddOverflowsI16),
            _ => return up,
        };
        if !careful {
            return up;
        }
        let overflow = self.b.compute(overflows, &[before, step]);
        let zero = self.b.constant(0);
        let down = self.b.compute(below, &[step, zero]);
        let choice = if self.dice.roll(4) == 0 {
            up
        } else {
            let ge = self.b.compute(ge, &[next, limit]);
            self.b.compute(Op::Select, &[down, ge, up])
        };
        self.b.compute(Op::AndNot, &[choice, overflow])
    }
}

/// Counts from somewhere to somewhere by something.
fn one_loop(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let of = dice.of(&[Type::Dint, Type::Int, Type::Udint, Type::Uint]);
    let places = [0, 1, 2].map(|number| {
        let (area, byte) = match dice.roll(16) {
            0 => (Area::SharedData, 4 * dice.roll(48) as u32),
            _ => (Area::BitMemory, VARIABLES + 4 * number),
        };
        Place::Fixed { area, position: 8 * byte }
    });
    let number =
        |dice: &mut Dice, all: &[u64]| dice.of(all).wrapping_add(dice.roll(3)) & if of.width() == Width::Word { 0xFFFF } else { !0 >> 32 };
    let first = number(&mut dice, &[0, 0, 1, 2, 5, 8, 63, 700, 32_000, 65_000, 0xFFFF_FFFC]);
    let step = number(&mut dice, &[0, 1, 1, 2, 3, 7, 15, 100, 32_000, 0xFFFF_FFFE]);
    let last = number(&mut dice, &[14, 40, 100, 190, 197, 700, 1500, 1590, 1600, 1600, 3000, 32_765, 65_533, 0x7FFF_FFFD, 0xFFFF_FFFC]);
    let limit = (dice.roll(2) == 0).then_some(last);
    let bytes = dice.roll(3) == 0;
    let (by_variable, careful) = (dice.roll(2) == 0, dice.roll(2) == 0);
    let by_one = dice.roll(2) == 0;
    let step = if by_one { 1 } else { step };
    let mut maker = Maker { b, dice, of, places, limit, bytes };
    maker.b.begin_statement();
    let number = maker.b.constant(1);
    maker.b.push(Inst::Open { register: DataRegister::Shared, number });
    for (variable, value) in [first, step, last].into_iter().enumerate() {
        maker.begin_with(variable, value);
    }
    let to = Target(4);
    maker.b.begin_statement();
    maker.write();
    if maker.dice.roll(8) == 0 {
        maker.b.begin_statement();
        maker.write();
    }
    maker.b.begin_statement();
    let before = maker.get(0);
    let by = if by_variable { maker.get(1) } else { maker.b.constant(step) };
    let args = if maker.dice.roll(4) == 0 { [by, before] } else { [before, by] };
    let next = maker.b.compute(of.add(), &args);
    maker.b.store(places[0], of.width(), next);
    let careful = careful && by_variable;
    let next = if !careful && maker.dice.roll(2) == 0 {
        maker.b.begin_statement();
        maker.get(0)
    } else {
        next
    };
    let condition = maker.again(before, next, by, careful);
    maker.b.push(Inst::Branch { condition, to });
}

/// Changes a variable, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 3, 17, 33, 40, 100, 400, 1000, 100_000]);
    if dice.roll(4) == 0 {
        let value = dice.of(&[0, 0, 1, 2, 3, 7, 0x7F, 0xFF]);
        machine.memory.area_mut(Area::BitMemory)[VARIABLES as usize + dice.roll(12) as usize] = value;
    }
    Reaction::Continue
}

#[test]
fn bits_and_bytes_that_loops_fill_and_cross_out_are_those_of_the_interpreter() {
    let (mut asked, mut finished, mut changed) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| one_loop(b, seed))]);
        let layout = layout_with(&program, DATA_BYTES);
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 50, 1000, 1000, 100_000]);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let outcome = |engine: Arc<dyn sieben_engine::Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, what: &str, asked: usize| match what.starts_with("safe point") {
                true => meddle(machine, &mut dice.borrow_mut(), asked),
                // Nobody changes anything when an error is noted.
                false => Reaction::Continue,
            };
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let expected = all_engines_agree(&engines(&program, &layout), true, &outcome, &|| format!("{seed}\n{}", program.code[&block].code));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
        changed += usize::from(expected.asked.len() < 3 && expected.exit == Exit::Finished);
    }
    assert!(asked > 400 && finished > 120 && changed > 40, "{asked} questions, {finished} runs to the end, {changed} of them without many");
}
