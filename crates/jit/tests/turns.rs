//! Counted loops over arrays whose turns machine code does at once: whatever they compute, whenever the budget ends and whatever the
//! Host changes then, memory, registers, questions and budget are those of the interpreter.

use std::cell::RefCell;
use std::sync::Arc;

use noting::{program, run};
use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Entry, Exit, FaultPlace, Interpreter, Layout, Machine, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

mod noting;

/// Programs that are compared.
const PROGRAMS: u64 = 500;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 40;
/// Bytes of the data block: room for some arrays.
const DATA_BYTES: usize = 640;
/// Where the variables lie in bit memory: not in an array.
const VARIABLES: u32 = 200;

/// Numbers that follow one another in no order.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % sides
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.roll(all.len() as u64) as usize]
    }
}

/// How a loop counts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Counter {
    /// A DINT up to a limit, or down to it.
    Double,
    /// The same as an INT.
    Word,
    /// ACCU 1, as `LOOP` does.
    Looping,
}

/// A program in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    /// The variable with the next number has not been used.
    next: u32,
}

#[derive(Clone, Copy)]
struct Variable {
    place: Place,
    width: Width,
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    /// A variable of its own, now and then one that others use, or that lies in the arrays.
    fn variable(&mut self, width: Width) -> Variable {
        self.next += 4;
        let position = match self.dice.roll(12) {
            0 if self.dice.roll(3) == 0 => 8 * self.dice.roll(64) as u32,
            1 if self.dice.roll(3) == 0 => 8 * (VARIABLES + 4 * self.dice.roll(6) as u32),
            _ => 8 * (VARIABLES + self.next % 48),
        };
        let area = if self.dice.roll(16) == 0 { Area::SharedData } else { Area::BitMemory };
        let position = if area == Area::SharedData { position % (8 * 500) / 8 * 8 } else { position };
        Variable { place: Place::Fixed { area, position }, width }
    }

    fn get(&mut self, it: Variable) -> Var {
        self.b.load(it.place, it.width, OnFault::SkipStatement)
    }

    fn put(&mut self, it: Variable, value: Var) {
        self.b.store(it.place, it.width, value);
    }

    /// An element of an array, by some of the indexes.
    fn element(&mut self, indexes: &[(Variable, Counter)], width: Width, write: bool) -> Place {
        let area = if self.dice.roll(16) == 0 { Area::BitMemory } else { Area::SharedData };
        // Arrays lie apart most of the time.
        let slot = if write && self.dice.roll(4) != 0 { 2 } else { self.dice.roll(3) };
        let jitter = if self.dice.roll(6) == 0 { 2 * self.dice.roll(40) } else { 0 };
        let offset = match self.dice.roll(24) {
            0 => 0x0100_0000 - 8 * self.dice.roll(40) as u32,
            _ if area == Area::BitMemory => 8 * jitter as u32,
            _ => 8 * (200 * slot + jitter) as u32,
        };
        let mut pointer: Option<Var> = None;
        for (at, &(index, counter)) in indexes.iter().enumerate() {
            if at > 0 && self.dice.roll(3) == 0 {
                continue;
            }
            let mut number = self.get(index);
            if counter == Counter::Word {
                number = self.b.compute(Op::Extend16, &[number]);
            }
            let elements = if at == 0 { self.dice.of(&[1, 1, 1, 1, 1, 2, 8]) } else { self.dice.of(&[1, 1, 8]) };
            let step = self.b.constant(u64::from(width.bits()) * elements);
            let part = self.b.compute(Op::MulU32, &[number, step]);
            pointer = Some(match pointer {
                Some(before) => self.b.compute(Op::AddU32, &[before, part]),
                None => part,
            });
        }
        let pointer = match pointer {
            Some(pointer) if self.dice.roll(12) == 0 => {
                let count = self.b.constant(8 * DATA_BYTES as u64 - 64);
                let inside = self.b.compute(Op::Below, &[pointer, count]);
                self.b.compute(Op::Gate, &[pointer, inside])
            }
            Some(pointer) => pointer,
            None => self.b.constant(0),
        };
        Place::Indirect { area, pointer, offset }
    }

    fn operand(&mut self, indexes: &[(Variable, Counter)], width: Width, others: &[Variable]) -> Var {
        match self.dice.roll(6) {
            0 => {
                let value = self.dice.of(&[0, 1, 3, 0x7FFF, 0xFFFF, 0x3F80_0000, 0x7FC0_0001, 0xFF80_0000]);
                self.b.constant(value)
            }
            1 => self.get(indexes[0].0),
            2 => {
                let other = self.dice.of(others);
                self.get(other)
            }
            _ => {
                let place = self.element(indexes, width, false);
                self.b.load(place, width, OnFault::SkipStatement)
            }
        }
    }

    /// A statement of a loop.
    fn statement(&mut self, indexes: &[(Variable, Counter)], sum: Variable) {
        self.begin();
        let width = match self.dice.roll(20) {
            0 => Width::Bit,
            1 => Width::Byte,
            2..10 => Width::Word,
            _ => Width::DoubleWord,
        };
        let op = match width {
            Width::Word => self.dice.of(&[Op::AddU16, Op::SubU16, Op::MulU16, Op::AddI16Wide, Op::MulI16Wide, Op::Low16, Op::AndU32]),
            Width::DoubleWord => self.dice.of(&[
                Op::AddU32,
                Op::SubU32,
                Op::MulU32,
                Op::XorU32,
                Op::AddF32,
                Op::MulF32,
                Op::SubF32,
                Op::DivF32,
                Op::Extend16,
                Op::I32ToF32,
                Op::Shl32,
            ]),
            _ => self.dice.of(&[Op::Copy, Op::OrU32]),
        };
        let others = [sum];
        let args = [self.operand(indexes, width, &others), self.operand(indexes, width, &others)];
        let value = self.b.compute(op, &args[..op.arity()]);
        match self.dice.roll(6) {
            0 | 1 => {
                let before = self.get(sum);
                let add = if sum.width == Width::Word {
                    self.dice.of(&[Op::AddU16, Op::MulU16])
                } else {
                    self.dice.of(&[Op::AddU32, Op::AddF32, Op::SubU32])
                };
                let after = self.b.compute(add, &[before, value]);
                self.put(sum, after);
            }
            2 => {
                let low = self.b.compute(Op::Low32, &[value]);
                let register = self.dice.of(&[Register::Accu2, Register::Ar1, Register::Accu3]);
                self.b.compute_into(register, Op::Copy, &[low]);
            }
            _ => {
                let place = self.element(indexes, width, true);
                self.b.store(place, width, value);
            }
        }
        if self.dice.roll(12) == 0 {
            let register = self.dice.of(&[Register::Rlo, Register::Ov]);
            let flag = self.b.compute(Op::IsNonzero, &[value]);
            self.b.compute_into(register, Op::Copy, &[flag]);
        }
    }

    /// A loop, with another one in it now and then.
    fn counted(&mut self, around: &[(Variable, Counter)]) {
        let counter = self.dice.of(&[Counter::Double, Counter::Double, Counter::Double, Counter::Word, Counter::Looping]);
        let width = if counter == Counter::Double { Width::DoubleWord } else { Width::Word };
        let index = self.variable(width);
        let sum_width = self.dice.of(&[Width::DoubleWord, Width::DoubleWord, Width::Word]);
        let sum = self.variable(sum_width);
        let up = self.dice.roll(4) != 0;
        let turns = self.dice.of(&[1, 2, 5, 8, 17, 31, 32, 33, 40, 64]);
        let turns = if around.is_empty() { turns } else { self.dice.of(&[1, 3, 8, 9]) };
        let first = if up || counter == Counter::Looping { self.dice.of(&[0, 0, 0, 1, 3]) } else { turns };
        self.begin();
        if counter == Counter::Looping {
            let count = if self.dice.roll(16) == 0 { 0x1_0000 + turns } else { turns };
            let value = self.b.constant(count);
            self.b.compute_into(Register::Accu1, Op::Copy, &[value]);
        } else {
            let value = self.b.constant(first);
            self.put(index, value);
        }
        let mut indexes = vec![(index, counter)];
        indexes.extend_from_slice(around);
        let head = self.statements;
        if counter == Counter::Looping {
            self.begin();
            self.put(index, Register::Accu1.into());
        }
        for _ in 0..1 + self.dice.roll(2) {
            self.statement(&indexes, sum);
        }
        if around.is_empty() && self.dice.roll(2) == 0 {
            self.counted(&indexes);
            if self.dice.roll(2) == 0 {
                self.statement(&indexes, sum);
            }
        }
        self.begin();
        let to = Target(head);
        if counter == Counter::Looping {
            let count = self.get(index);
            self.b.compute_into(Register::Accu1, Op::Copy, &[count]);
            let low = self.b.compute(Op::Decrement16, &[count]);
            self.b.compute_into(Register::Accu1, Op::MergeLow16, &[count, low]);
            let condition = self.b.compute(Op::IsNonzero, &[low]);
            self.b.push(Inst::Branch { condition, to });
            return;
        }
        let double = counter == Counter::Double;
        let value = self.get(index);
        let step = self.dice.of(&[1, 1, 1, 2, 3]);
        let step = self.b.constant(if up { step } else { step.wrapping_neg() & if double { 0xFFFF_FFFF } else { 0xFFFF } });
        let next = self.b.compute(if double { Op::AddU32 } else { Op::AddU16 }, &[value, step]);
        self.put(index, next);
        let limit = self.b.constant(if up { first + turns } else { self.dice.roll(2) });
        let op = match (up, double) {
            (true, true) => self.dice.of(&[Op::LeI32, Op::LtI32]),
            (true, false) => self.dice.of(&[Op::LeI16, Op::LtI16]),
            (false, true) => self.dice.of(&[Op::GeI32, Op::GtI32]),
            (false, false) => self.dice.of(&[Op::GeI16, Op::GtI16]),
        };
        let condition = self.b.compute(op, &[next, limit]);
        self.b.push(Inst::Branch { condition, to });
    }
}

fn loops(b: &mut Builder, seed: u64) {
    let mut maker = Maker { b, dice: Dice(seed), statements: 0, next: 0 };
    maker.begin();
    let number = maker.b.constant(1);
    maker.b.push(Inst::Open { register: DataRegister::Shared, number });
    for _ in 0..1 + maker.dice.roll(2) {
        maker.counted(&[]);
    }
    maker.begin();
    maker.b.push(Inst::Return);
}

fn layout(program: &sieben_engine::Program) -> Layout {
    let mut layout = noting::layout(program);
    layout.size += DATA_BYTES;
    layout.data_blocks.insert(1, layout.size - DATA_BYTES..layout.size);
    layout
}

/// Changes a few bytes, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 3, 9, 17, 40, 100, 1000, 1000, 100_000]);
    if dice.roll(4) == 0 {
        let value = dice.of(&[0, 1, 2, 7, 0x7F, 0x80, 0xFF]);
        machine.memory.area_mut(Area::BitMemory)[VARIABLES as usize + dice.roll(56) as usize] = value;
    }
    Reaction::Continue
}

#[test]
fn turns_that_nobody_looks_at_do_what_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    for seed in 0..PROGRAMS {
        let block = BlockId::ob(1);
        let program = program(&[(block, 48, &|b| loops(b, seed))]);
        let layout = layout(&program);
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 5, 50, 1000, 1000, 100_000]);
            machine.memory.area_mut(Area::BitMemory)[..256].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.of(&[0, 0x3F, 0x40, 0x7F, 0x80, 0xFF, 1, 0xC0]));
        };
        let outcome = |engine: Arc<dyn sieben_engine::Engine>| {
            let dice = RefCell::new(Dice(seed + 2_000_000));
            let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
            run(engine.as_ref(), &layout, &entry, &prepare, &answer)
        };
        let expected = outcome(Interpreter::load(&program, &layout));
        for status in [StatusBits::All, StatusBits::Needed] {
            let got = outcome(Jit::compiled(&program, &layout, status).expect("machine code"));
            let code = &program.code[&block].code;
            assert_eq!(got.asked, expected.asked, "{seed} {status:?}\n{code}");
            let differ = got.arena.iter().zip(&expected.arena).position(|(got, expected)| got != expected);
            assert_eq!(differ, None, "{seed} {status:?}: memory differs\n{code}");
            assert_eq!((got.exit, got.budget), (expected.exit.clone(), expected.budget), "{seed} {status:?}\n{code}");
            if status == StatusBits::All {
                assert_eq!(got.registers, expected.registers, "{seed}\n{code}");
            }
        }
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 5_000 && finished > 300, "{asked} questions, {finished} runs to the end");
}
