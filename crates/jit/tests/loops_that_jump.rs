//! Loops as people write them who sort and search: WHILE and REPEAT with flags, counters of 16 bits that stay inside their type or do not,
//! ways out in the middle, records that are compared, copied and handed to a function, a place that is chosen by what lies there. Whatever
//! the Host makes of memory and budget, they do on all engines what the interpreter does.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Machine, Program, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, program, run_beside};

const PROGRAMS: u64 = 300;
const QUESTIONS_MAX: usize = 30;
/// Records: where they begin in bit memory, bytes of each, and how many there are.
const RECORDS: u32 = 64;
const RECORD: u32 = 12;
const COUNT: u32 = 9;
/// Numbers of 16 bits, numbers of 32 bits and bits: first those in bit memory, then those in local data, each at byte numbers.
const WORDS: [(Area, u32); 5] = [(Area::BitMemory, 0), (Area::BitMemory, 2), (Area::Local, 0), (Area::Local, 2), (Area::Local, 4)];
const DOUBLES: [(Area, u32); 4] = [(Area::BitMemory, 8), (Area::BitMemory, 12), (Area::Local, 8), (Area::Local, 12)];
const BITS: [(Area, u32); 5] =
    [(Area::BitMemory, 8 * 16), (Area::BitMemory, 8 * 16 + 3), (Area::Local, 8 * 16), (Area::Local, 8 * 16 + 1), (Area::Local, 8 * 17)];
/// A record in local data.
const OWN_RECORD: u32 = 20;
/// What is handed to the function: a number, and where a result is put; and how many bytes that is together.
const HANDED: u32 = 36;
const RESULT: u32 = 40;
const HANDED_BYTES: u32 = 8;
const LOCAL_BYTES: u32 = 48;

/// Statements that are still to be written.
#[derive(Debug)]
enum Part {
    Assigns,
    Copies,
    /// Calls the function, and does something by its result.
    Calls,
    /// Chooses the number of a record by what lies there.
    Best,
    If(Vec<Part>, Vec<Part>),
    /// Leaves the loop around it if something holds.
    Exit,
    While(Vec<Part>),
    Repeat(Vec<Part>),
}

fn size(parts: &[Part]) -> u32 {
    let own = |part: &Part| match part {
        Part::Assigns | Part::Copies | Part::Exit => 1,
        Part::Calls | Part::Best => 2,
        Part::If(yes, no) => 2 + size(yes) + size(no),
        Part::While(body) => 2 + size(body),
        Part::Repeat(body) => 1 + size(body),
    };
    parts.iter().map(own).sum()
}

fn parts(dice: &mut Dice, depth: u32, in_loop: bool) -> Vec<Part> {
    let part = |dice: &mut Dice| match dice.roll(if depth == 0 { 6 } else { 10 }) {
        0 | 1 => Part::Assigns,
        2 => Part::Copies,
        3 => Part::Calls,
        4 => Part::Best,
        5 if in_loop => Part::Exit,
        5 => Part::Assigns,
        6 | 7 => Part::If(parts(dice, depth - 1, in_loop), parts(dice, depth - 1, in_loop)),
        8 => Part::While(parts(dice, depth - 1, true)),
        _ => Part::Repeat(parts(dice, depth - 1, true)),
    };
    (0..1 + dice.roll(3)).map(|_| part(dice)).collect()
}

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

    fn load(&mut self, (area, position): (Area, u32), width: Width) -> Var {
        self.b.load(Place::Fixed { area, position }, width, OnFault::SkipStatement)
    }

    fn word_of(&mut self, (area, byte): (Area, u32)) -> Var {
        self.load((area, 8 * byte), Width::Word)
    }

    fn any_word(&mut self) -> (Area, u32) {
        let all = if self.dice.roll(3) == 0 { &WORDS[..] } else { &WORDS[1..3] };
        self.dice.of(all)
    }

    fn small(&mut self) -> Var {
        let number = self.dice.of(&[0, 1, 1, 2, 3, 8, 9, 100, 0x7FFE, 0x7FFF, 0x8000, 0xFFFD, 0xFFFF, 0xFFFF]);
        self.b.constant(number)
    }

    /// A number of 16 bits.
    fn number(&mut self) -> Var {
        let place = self.any_word();
        match self.dice.roll(6) {
            0 => self.small(),
            1 => self.word_of(place),
            _ => {
                let (word, other) = (self.word_of(place), self.small());
                let args = if self.dice.roll(4) == 0 { [other, word] } else { [word, other] };
                self.b.compute(self.dice.of(&[Op::AddU16, Op::AddU16, Op::SubU16, Op::SubU16, Op::MulU16, Op::DivI16]), &args)
            }
        }
    }

    /// A pointer to the record with a number, which is looked at or not; numbers count from one.
    fn record(&mut self, number: Var) -> Var {
        let number = self.b.compute(Op::Extend16, &[number]);
        let one = self.b.constant(1);
        let mut index = self.b.compute(Op::SubU32, &[number, one]);
        if self.dice.roll(3) == 0 {
            let limit = self.b.constant(u64::from(COUNT));
            let inside = self.b.compute(Op::Below, &[index, limit]);
            self.b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
            index = self.b.compute(Op::Gate, &[index, inside]);
        }
        let (bits, first) = (self.b.constant(u64::from(8 * RECORD)), self.b.constant(u64::from(8 * RECORDS)));
        let bits = self.b.compute(Op::MulU32, &[index, bits]);
        self.b.compute(Op::AddU32, &[bits, first])
    }

    fn field(&mut self) -> Place {
        let word = self.any_word();
        let number = self.word_of(word);
        let pointer = self.record(number);
        Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * self.dice.of(&[0, 4]) }
    }

    /// A number of 32 bits.
    fn double(&mut self) -> Var {
        let place = self.dice.of(&DOUBLES);
        match self.dice.roll(6) {
            0 => self.load((place.0, 8 * place.1), Width::DoubleWord),
            1 => {
                let number = self.number();
                self.b.compute(Op::Extend16, &[number])
            }
            2 => self.b.constant(self.dice.of(&[0, 1, 7, 0x3F80_0000])),
            3 => {
                let at = OWN_RECORD + self.dice.of(&[0, 4]);
                self.load((Area::Local, 8 * at), Width::DoubleWord)
            }
            _ => {
                let place = self.field();
                self.b.load(place, Width::DoubleWord, OnFault::SkipStatement)
            }
        }
    }

    fn condition(&mut self) -> Var {
        match self.dice.roll(7) {
            0 | 1 => {
                let args = [self.number(), self.number()];
                self.b.compute(self.dice.of(&[Op::LtI16, Op::LeI16, Op::GtI16, Op::GeI16, Op::EqI16]), &args)
            }
            2 => {
                let word = self.any_word();
                let args = [self.word_of(word), self.small()];
                self.b.compute(self.dice.of(&[Op::LeI16, Op::GeI16, Op::Below]), &args)
            }
            3 => {
                let args = [self.double(), self.double()];
                self.b.compute(self.dice.of(&[Op::LtI32, Op::GeI32, Op::Equal, Op::LtF32, Op::GeF32, Op::EqF32]), &args)
            }
            4 => {
                let bit = self.dice.of(&BITS);
                self.load(bit, Width::Bit)
            }
            5 => {
                let condition = self.condition();
                self.b.compute(Op::Not, &[condition])
            }
            _ => {
                let args = [self.condition(), self.condition()];
                self.b.compute(self.dice.of(&[Op::And, Op::Or, Op::AndNot]), &args)
            }
        }
    }

    fn assigns(&mut self) {
        self.begin();
        match self.dice.roll(6) {
            0 => {
                let ((area, position), value) = (self.dice.of(&BITS), if self.dice.roll(2) == 0 { self.condition() } else { self.small() });
                self.b.store(Place::Fixed { area, position }, Width::Bit, value);
            }
            1 => {
                let ((area, byte), value) = (self.dice.of(&DOUBLES), self.double());
                self.b.store(Place::Fixed { area, position: 8 * byte }, Width::DoubleWord, value);
            }
            2 => {
                let value = self.double();
                let place = self.field();
                self.b.store(place, Width::DoubleWord, value);
            }
            3 => {
                // A step.
                let (area, byte) = self.any_word();
                let (word, one) = (self.word_of((area, byte)), self.b.constant(1));
                let next = self.b.compute(self.dice.of(&[Op::AddU16, Op::SubU16]), &[word, one]);
                self.b.store(Place::Fixed { area, position: 8 * byte }, Width::Word, next);
            }
            _ => {
                let ((area, byte), value) = (self.any_word(), self.number());
                self.b.store(Place::Fixed { area, position: 8 * byte }, Width::Word, value);
            }
        }
    }

    fn copies(&mut self) {
        self.begin();
        let side = |this: &mut Self| match this.dice.roll(3) {
            0 => Place::Fixed { area: Area::Local, position: 8 * OWN_RECORD },
            _ => {
                let number = this.number();
                let pointer = this.record(number);
                Place::Indirect { area: Area::BitMemory, pointer, offset: 0 }
            }
        };
        let (from, to) = (side(self), side(self));
        self.b.push(Inst::Move { from, to, bytes: self.dice.of(&[RECORD, RECORD, 8, 6]) });
    }

    fn calls(&mut self) {
        self.begin();
        let value = self.number();
        self.b.store(Place::Fixed { area: Area::Local, position: 8 * HANDED }, Width::Word, value);
        let (zero, result) = (self.b.constant(0), Place::Fixed { area: Area::Local, position: 8 * RESULT });
        self.b.store(result, Width::Bit, zero);
        for byte in [HANDED, RESULT] {
            let pointer = self.b.constant(0x8700_0000 | u64::from(8 * byte));
            self.b.push(Inst::PassParameter { src: pointer });
        }
        self.b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 2 });
        let result = self.b.load(result, Width::Bit, OnFault::SkipStatement);
        let negated = self.b.compute(Op::Not, &[result]);
        let condition = if self.dice.roll(2) == 0 { result } else { negated };
        self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
        self.assigns();
    }

    fn best(&mut self) {
        self.begin();
        let (best, other) = (self.any_word(), self.any_word());
        let value = |this: &mut Self, word| {
            let number = this.word_of(word);
            let pointer = this.record(number);
            this.b.load(Place::Indirect { area: Area::BitMemory, pointer, offset: 0 }, Width::DoubleWord, OnFault::SkipStatement)
        };
        let values = [value(self, other), value(self, best)];
        let condition = self.b.compute(self.dice.of(&[Op::LeI32, Op::LeF32]), &values);
        self.b.push(Inst::Branch { condition, to: Target(self.statements + 1) });
        self.begin();
        let value = self.word_of(other);
        self.b.store(Place::Fixed { area: best.0, position: 8 * best.1 }, Width::Word, value);
    }

    /// Writes parts; a way out of the loop around them goes to a statement.
    fn write(&mut self, parts: &[Part], end: u32) {
        for part in parts {
            let first = self.statements;
            match part {
                Part::Assigns => self.assigns(),
                Part::Copies => self.copies(),
                Part::Calls => self.calls(),
                Part::Best => self.best(),
                Part::Exit => {
                    self.begin();
                    let condition = self.condition();
                    self.b.push(Inst::Branch { condition, to: Target(end) });
                }
                Part::If(yes, no) => {
                    let (otherwise, behind) = (first + 2 + size(yes), first + 2 + size(yes) + size(no));
                    self.begin();
                    let condition = self.condition();
                    self.b.push(Inst::Branch { condition, to: Target(otherwise) });
                    self.write(yes, end);
                    self.begin();
                    self.b.push(Inst::Jump { to: Target(behind) });
                    self.write(no, end);
                }
                Part::While(body) => {
                    let behind = first + 2 + size(body);
                    self.begin();
                    let condition = self.condition();
                    self.b.push(Inst::Branch { condition, to: Target(behind) });
                    self.write(body, behind);
                    self.begin();
                    self.b.push(Inst::Jump { to: Target(first) });
                }
                Part::Repeat(body) => {
                    self.write(body, first + 1 + size(body));
                    self.begin();
                    let condition = self.condition();
                    self.b.push(Inst::Branch { condition, to: Target(first) });
                }
            }
        }
    }

    fn main(mut self, all: &[Part]) {
        self.begin();
        for position in (0..8 * HANDED).step_by(32) {
            let value = self.b.constant(self.dice.roll(4));
            self.b.store(Place::Fixed { area: Area::Local, position }, Width::DoubleWord, value);
        }
        for (area, byte) in WORDS {
            let value = self.b.constant(self.dice.of(&[0, 1, 1, 2, 8]));
            self.b.store(Place::Fixed { area, position: 8 * byte }, Width::Word, value);
        }
        let end = self.statements + size(all);
        self.write(all, end);
        // What is in local data is seen.
        for (at, position) in (0..8 * HANDED).step_by(32).enumerate() {
            self.begin();
            let value = self.load((Area::Local, position), Width::DoubleWord);
            self.b.store(Place::Fixed { area: Area::BitMemory, position: 8 * (200 + 4 * at as u32) }, Width::DoubleWord, value);
        }
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// Compares what it is given with a number, one way or the other.
fn function(b: &mut Builder, dice: &mut Dice) {
    let given = |b: &mut Builder, index: u16| {
        let pointer = b.temporary();
        b.push(Inst::Parameter { dst: pointer, index });
        Place::Crossing { pointer, offset: 0 }
    };
    let result = Place::Fixed { area: Area::Local, position: 3 };
    b.begin_statement();
    let first = b.constant(dice.roll(2));
    b.store(result, Width::Bit, first);
    b.begin_statement();
    let limit = dice.of(&[0, 1, 4, 9]);
    let compared = |b: &mut Builder, op: Op| {
        let place = given(b, 0);
        let (number, limit) = (b.load(place, Width::Word, OnFault::SkipStatement), b.constant(limit));
        b.compute(op, &[number, limit])
    };
    let condition = compared(b, dice.of(&[Op::LtI16, Op::GtI16]));
    b.push(Inst::Branch { condition, to: Target(4) });
    b.begin_statement();
    let value = compared(b, Op::EqI16);
    b.store(result, Width::Bit, value);
    b.begin_statement();
    b.push(Inst::Jump { to: Target(5) });
    b.begin_statement();
    let place = Place::Fixed { area: Area::BitMemory, position: 8 * 8 };
    let (sum, one) = (b.load(place, Width::DoubleWord, OnFault::SkipStatement), b.constant(1));
    let sum = b.compute(Op::AddU32, &[sum, one]);
    b.store(place, Width::DoubleWord, sum);
    let bit = b.compute(Op::LowestBit, &[sum]);
    b.store(result, Width::Bit, bit);
    b.begin_statement();
    let value = b.load(result, Width::Bit, OnFault::SkipStatement);
    let place = given(b, 1);
    b.store(place, Width::Bit, value);
    b.begin_statement();
    b.push(Inst::Return);
}

fn random_program(seed: u64) -> Program {
    let all = {
        let mut dice = Dice(seed);
        let mut all = parts(&mut dice, 2, false);
        all.push(Part::While(parts(&mut dice, 2, true)));
        all.push(Part::Repeat(parts(&mut dice, 1, true)));
        all
    };
    let main = |b: &mut Builder| Maker { b, dice: Dice(seed + 500_000), statements: 0 }.main(&all);
    let mut program =
        program(&[(BlockId::ob(1), LOCAL_BYTES, &main), (BlockId::fc(1), 4, &|b: &mut Builder| function(b, &mut Dice(seed + 600_000)))]);
    with_handed(&mut program);
    program
}

/// Says that nobody needs between statements what is handed on.
fn with_handed(program: &mut Program) {
    for block in program.code.values_mut() {
        block.reads_own_locals = true;
    }
    let caller = program.code.get_mut(&BlockId::ob(1)).expect("the caller");
    caller.handed.push(8 * HANDED..8 * (HANDED + HANDED_BYTES));
}

fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    // A fault that is noted changes nothing.
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 3, 8, 30, 200]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[0, 1, 3, 11, 16, 64, 71]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 7, 0x7F, 0xFF]);
    }
    if dice.roll(3) == 0 {
        // A number of 16 bits at an end of its type.
        let place = dice.of(&[0, 2]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place..place + 2].copy_from_slice(&dice.of(&[[0xFF, 0xFF], [0x7F, 0xFF], [0x80, 0]]));
    }
    Reaction::Continue
}

#[test]
fn loops_that_jump_out_and_choose_do_what_the_interpreter_does() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let program = random_program(seed);
        let layout = noting::layout(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let engines = engines(&program, &layout);
        for round in 0..2 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 4, 40, 400, 400]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory.iter_mut().take(190).for_each(|byte| *byte = dice.roll(4) as u8);
            };
            let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
            let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
            let what = || format!("{seed} in round {round}\n{}", listing());
            let expected = all_engines_agree(&engines, false, &outcome, &what);
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 3_000 && finished > 120, "{asked} questions, {finished} runs to the end");
}

/// A loop that writes a number to each record, before which something is added to that number, or it is made a number up to 10.
fn adds_in_front(b: &mut Builder, adds: bool) {
    let fixed = |byte: u32| Place::Fixed { area: Area::BitMemory, position: 8 * byte };
    let add = |b: &mut Builder, byte: u32, width: Width, op: Op, number: u64| {
        let (old, more) = (b.load(fixed(byte), width, OnFault::SkipStatement), b.constant(number));
        let sum = b.compute(op, &[old, more]);
        b.store(fixed(byte), width, sum);
        sum
    };
    b.begin_statement();
    add(b, 8, Width::DoubleWord, if adds { Op::AddU32 } else { Op::AndU32 }, 10);
    b.begin_statement();
    let one = b.constant(1);
    b.store(fixed(0), Width::Word, one);
    b.begin_statement();
    let (number, index) =
        (b.load(fixed(8), Width::DoubleWord, OnFault::SkipStatement), b.load(fixed(0), Width::Word, OnFault::SkipStatement));
    let (index, bits) = (b.compute(Op::Extend16, &[index]), b.constant(u64::from(8 * RECORD)));
    let pointer = b.compute(Op::MulU32, &[index, bits]);
    // The last records are as far as bit memory goes.
    let pointer = Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * RECORDS };
    b.store(pointer, Width::DoubleWord, number);
    b.begin_statement();
    let next = add(b, 0, Width::Word, Op::AddU16, 1);
    let limit = b.constant(u64::from(COUNT));
    let again = b.compute(Op::LeI16, &[next, limit]);
    b.push(Inst::Branch { condition: again, to: Target(2) });
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn a_number_of_which_nothing_is_known_hides_no_other_range() {
    let comparisons = |adds: bool| {
        let program = program(&[(BlockId::ob(1), 0, &|b: &mut Builder| adds_in_front(b, adds))]);
        Jit::listing(&program, &noting::layout(&program)).expect("machine code").matches("icmp").count()
    };
    // No address is compared with the end of its area.
    assert!(comparisons(true) <= comparisons(false), "{} comparisons, {} of what is known", comparisons(true), comparisons(false));
}

/// A loop that hands its counter to the function and counts what that says.
fn hands_its_counter(b: &mut Builder) {
    let local = |byte: u32| Place::Fixed { area: Area::Local, position: 8 * byte };
    let sum = Place::Fixed { area: Area::BitMemory, position: 8 * 12 };
    let (counter, kept) = (local(0), Place::Fixed { area: Area::Local, position: 8 * 16 });
    b.begin_statement();
    let (one, no) = (b.constant(1), b.constant(0));
    b.store(counter, Width::Word, one);
    b.store(kept, Width::Bit, no);
    b.begin_statement();
    let (value, no) = (b.load(counter, Width::Word, OnFault::SkipStatement), b.constant(0));
    b.store(local(HANDED), Width::Word, value);
    b.store(local(RESULT), Width::Bit, no);
    for byte in [HANDED, RESULT] {
        let pointer = b.constant(0x8700_0000 | u64::from(8 * byte));
        b.push(Inst::PassParameter { src: pointer });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 2 });
    let result = b.load(local(RESULT), Width::Bit, OnFault::SkipStatement);
    b.store(kept, Width::Bit, result);
    b.begin_statement();
    let (kept, old) = (b.load(kept, Width::Bit, OnFault::SkipStatement), b.load(sum, Width::DoubleWord, OnFault::SkipStatement));
    let (more, less) = (b.constant(7), b.constant(100));
    let more = b.compute(Op::Select, &[kept, more, less]);
    let new = b.compute(Op::AddU32, &[old, more]);
    b.store(sum, Width::DoubleWord, new);
    b.begin_statement();
    let (old, one, limit) = (b.load(counter, Width::Word, OnFault::SkipStatement), b.constant(1), b.constant(12));
    let next = b.compute(Op::AddU16, &[old, one]);
    b.store(counter, Width::Word, next);
    let again = b.compute(Op::LeI16, &[next, limit]);
    b.push(Inst::Branch { condition: again, to: Target(1) });
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn a_function_finds_what_it_is_handed_in_each_of_its_statements() {
    for seed in 0..40 {
        let mut program = program(&[
            (BlockId::ob(1), LOCAL_BYTES, &hands_its_counter),
            (BlockId::fc(1), 4, &|b: &mut Builder| function(b, &mut Dice(seed))),
        ]);
        with_handed(&mut program);
        let layout = noting::layout(&program);
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| machine.budget = Dice(seed + 100).of(&[1, 5, 400]);
        let outcome = |engine: Arc<dyn Engine>| run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 200), &meddle);
        all_engines_agree(&engines(&program, &layout), false, &outcome, &|| seed.to_string());
    }
}
