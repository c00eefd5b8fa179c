//! Calls of a function block by name that follow one another, with statements between them that may read and write what the calls do:
//! whatever is done side by side, they do on all engines what the interpreter does.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout_with, program, run};

const PROGRAMS: u64 = 200;
const QUESTIONS_MAX: usize = 30;
const MAIN: BlockId = BlockId::fb(1);
const MEMBER: BlockId = BlockId::fb(2);
const OTHER: BlockId = BlockId::fb(3);
/// Numbers and bits of the block that calls: how many, and where they begin, in bytes.
const VARIABLES: u32 = 6;
const NUMBERS: u32 = 0;
const BITS: u32 = 30;
/// Instances of the called block: where they begin, how many there are, and the bytes of one. Those that have fewer lie over one another.
const INSTANCES: u32 = 32;
const COUNT: u32 = 24;
const BYTES: u32 = 24;
const FEWER_BYTES: u32 = 20;
/// Fields of an instance, in bytes: two numbers and a bit that it is handed, and others.
const HANDED: [u32; 2] = [0, 4];
const MANUAL: u32 = 8;
const MODE: u32 = 10;
const OUT: u32 = 12;
const SATURATED: u32 = 16;
const STATE: u32 = 20;
/// A number in bit memory that all of them may reach.
const GLOBAL: u32 = 40;
/// Where local data hold AR2 and a number.
const SAVED: u32 = 0;
const OWN: u32 = 4;

fn of_instance(byte: u32, bit: u32) -> Place {
    Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: 8 * byte + bit }
}

fn local(byte: u32) -> Place {
    Place::Fixed { area: Area::Local, position: 8 * byte }
}

fn global() -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * GLOBAL }
}

/// A block in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    /// How seldom code reaches what belongs to others.
    seldom: u64,
    /// The bytes from one instance to the next.
    bytes: u32,
}

impl Maker<'_> {
    fn instance(&self, number: u32) -> u32 {
        INSTANCES + self.bytes * number
    }

    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn load(&mut self, place: Place, width: Width) -> Var {
        self.b.load(place, width, OnFault::SkipStatement)
    }

    fn constant(&mut self) -> Var {
        self.b.constant(self.dice.of(&[0, 1, 2, 7, 0x3F80_0000, 0x42C8_0000, 0xC2C8_0000]))
    }

    fn of_two(&mut self, a: Var, b: Var) -> Var {
        let op = self.dice.of(&[Op::AddU32, Op::SubU32, Op::XorU32, Op::AddF32, Op::SubF32, Op::MulF32]);
        self.b.compute(op, &[a, b])
    }

    fn condition(&mut self, number: fn(&mut Self) -> Var, bit: Place) -> Var {
        if self.dice.roll(3) == 0 {
            return self.load(bit, Width::Bit);
        }
        let (a, b) = (number(self), number(self));
        self.b.compute(self.dice.of(&[Op::GtF32, Op::LtF32, Op::LtI32, Op::Equal]), &[a, b])
    }

    /// What the called block computes with.
    fn number_of_member(&mut self) -> Var {
        match self.dice.roll(12) {
            0 => self.constant(),
            1 => {
                let mode = self.load(of_instance(MODE, 0), Width::Word);
                self.b.compute(Op::Extend16, &[mode])
            }
            2 if self.dice.roll(self.seldom) == 0 => self.load(global(), Width::DoubleWord),
            3 => self.load(local(OWN), Width::DoubleWord),
            _ => {
                let field = self.dice.of(&[HANDED[0], HANDED[1], OUT, STATE]);
                self.load(of_instance(field, 0), Width::DoubleWord)
            }
        }
    }

    fn statement_of_member(&mut self) {
        self.begin();
        match self.dice.roll(8) {
            0 => {
                let bit = match self.dice.roll(4 * self.seldom) {
                    0 => Register::Br.into(),
                    _ => self.condition(Self::number_of_member, of_instance(MANUAL, 0)),
                };
                self.b.store(of_instance(SATURATED, self.dice.roll(2) as u32), Width::Bit, bit);
            }
            1 => {
                let value = self.number_of_member();
                self.b.store(local(OWN), Width::DoubleWord, value);
            }
            2 => {
                let value = self.number_of_member();
                self.b.store(of_instance(MODE, 0), Width::Word, value);
            }
            3 if self.dice.roll(8 * self.seldom) == 0 => {
                let value = self.number_of_member();
                self.b.store(global(), Width::DoubleWord, value);
            }
            _ => {
                let (a, b) = (self.number_of_member(), self.number_of_member());
                let value = self.of_two(a, b);
                let field = self.dice.of(&[OUT, STATE, STATE, HANDED[1]]);
                self.b.store(of_instance(field, 0), Width::DoubleWord, value);
            }
        }
    }

    fn member(&mut self) {
        self.begin();
        let nothing = self.b.constant(0);
        self.b.store(local(OWN), Width::DoubleWord, nothing);
        for _ in 0..1 + self.dice.roll(4) {
            let jumped_over = self.dice.roll(3) as u32;
            if jumped_over > 0 {
                self.begin();
                let condition = self.condition(Self::number_of_member, of_instance(MANUAL, 0));
                self.b.push(Inst::Branch { condition, to: Target(self.statements + jumped_over) });
            }
            (0..jumped_over.max(1)).for_each(|_| self.statement_of_member());
        }
        self.begin();
        if self.dice.roll(8) == 0 {
            let bit = self.load(of_instance(MANUAL, 0), Width::Bit);
            self.b.copy(Register::Br, bit);
        } else {
            self.b.set(Register::Br, 1);
        }
    }

    /// A field of an instance: mostly of this one, or of one before it, seldom of another one.
    fn field(&mut self, own: u32) -> u32 {
        let number = match self.dice.roll(self.seldom) {
            0 => self.dice.roll(u64::from(COUNT)) as u32,
            _ => own,
        };
        self.instance(number) + self.dice.of(&[OUT, OUT, STATE, HANDED[0]])
    }

    fn number(&mut self, own: u32) -> Var {
        match self.dice.roll(8) {
            0 => self.constant(),
            1 if self.dice.roll(self.seldom) == 0 => self.load(global(), Width::DoubleWord),
            2..=4 => {
                let field = self.field(own);
                self.load(of_instance(field, 0), Width::DoubleWord)
            }
            _ => {
                let variable = NUMBERS + 4 * self.dice.roll(u64::from(VARIABLES)) as u32;
                self.load(of_instance(variable, 0), Width::DoubleWord)
            }
        }
    }

    /// A number that a call is handed.
    fn handed(&mut self, own: u32) -> Var {
        // What statements between the calls seldom write.
        let variable = NUMBERS + 4 * self.dice.roll(2) as u32;
        match self.dice.roll(self.seldom) {
            0 => self.number(own),
            // What an instance before it has made.
            1 if own > 0 && self.dice.roll(4) == 0 => {
                let field = self.instance(own - 1) + OUT;
                self.load(of_instance(field, 0), Width::DoubleWord)
            }
            1..=3 => self.constant(),
            _ => self.load(of_instance(variable, 0), Width::DoubleWord),
        }
    }

    fn call(&mut self, number: u32, callee: BlockId) {
        self.begin();
        let at = self.instance(number);
        for field in HANDED {
            if self.dice.roll(4) != 0 {
                let value = self.handed(number);
                self.b.store(of_instance(at + field, 0), Width::DoubleWord, value);
            }
        }
        if self.dice.roll(3) == 0 {
            let bit = match self.dice.roll(3) {
                0 => self.b.constant(self.dice.of(&[0, 1])),
                // A register is what the statements before it left.
                1 if self.dice.roll(self.seldom) == 0 => Register::Br.into(),
                _ => self.load(of_instance(BITS, 0), Width::Bit),
            };
            self.b.store(of_instance(at + MANUAL, 0), Width::Bit, bit);
        }
        if self.dice.roll(2 * self.seldom) == 0 {
            let value = self.number(number);
            let field = self.field(number);
            let place = if self.dice.roll(4) == 0 { global() } else { of_instance(field, 0) };
            self.b.store(place, Width::DoubleWord, value);
        }
        let ar2 = Var::from(Register::Ar2);
        self.b.store(local(SAVED), Width::DoubleWord, ar2);
        let more = self.b.constant(u64::from(8 * at));
        self.b.compute_into(ar2, Op::AddU32, &[ar2, more]);
        self.b.push(Inst::Call { callee: Callee::Block(callee), parameters: 0 });
        let saved = self.load(local(SAVED), Width::DoubleWord);
        self.b.copy(ar2, saved);
        if self.dice.roll(4) == 0 {
            let out = self.load(of_instance(at + OUT, 0), Width::DoubleWord);
            let variable = self.variable();
            self.b.store(of_instance(variable, 0), Width::DoubleWord, out);
        }
    }

    /// Where a statement between calls writes a number: seldom where heads read.
    fn variable(&mut self) -> u32 {
        let first = if self.dice.roll(2 * self.seldom) == 0 { 0 } else { 2 };
        NUMBERS + 4 * (first + self.dice.roll(u64::from(VARIABLES - first)) as u32)
    }

    fn between(&mut self, own: u32) {
        self.begin();
        if self.dice.roll(self.seldom) == 0 {
            let bit = self.load(of_instance(BITS, 0), Width::Bit);
            self.b.copy(Register::Br, bit);
            return;
        }
        let (a, b) = (self.number(own), self.number(own));
        let value = self.of_two(a, b);
        let place = match self.dice.roll(2 * self.seldom) {
            0 => of_instance(self.field(own), 0),
            1 => global(),
            2 => {
                let bit = if self.dice.roll(2) == 0 { Register::Br.into() } else { self.b.compute(Op::IsNonzero, &[value]) };
                self.b.store(of_instance(BITS, 0), Width::Bit, bit);
                return;
            }
            _ => of_instance(self.variable(), 0),
        };
        self.b.store(place, Width::DoubleWord, value);
    }

    fn main(&mut self) {
        for _ in 0..1 + self.dice.roll(2) {
            let (mut number, step) = (self.dice.roll(3) as u32, self.dice.of(&[1, 1, 1, 1, 2]));
            let last = number + 3 + self.dice.roll(20) as u32;
            if self.dice.roll(4) == 0 {
                self.begin();
                let condition = self.load(of_instance(BITS, 0), Width::Bit);
                self.b.push(Inst::Branch { condition, to: Target(self.statements + self.dice.roll(4) as u32) });
            }
            while number <= last.min(COUNT - 1) {
                let callee = if self.dice.roll(6 * self.seldom) == 0 { OTHER } else { MEMBER };
                self.call(number, callee);
                if self.dice.roll(3) != 0 {
                    let jumped_over = self.dice.roll(3) as u32;
                    if jumped_over > 0 {
                        self.begin();
                        let bit = self.dice.of(&[of_instance(BITS, 0), of_instance(self.instance(number) + SATURATED, 0)]);
                        let condition = self.load(bit, Width::Bit);
                        // Now and then over the next call, too.
                        let more = u32::from(number < last.min(COUNT - 1) && self.dice.roll(2 * self.seldom) == 0);
                        self.b.push(Inst::Branch { condition, to: Target(self.statements + jumped_over + more) });
                    }
                    (0..jumped_over.max(1)).for_each(|_| self.between(number));
                }
                number += if self.dice.roll(2 * self.seldom) == 0 { self.dice.of(&[0, 2 * step]) } else { step };
            }
        }
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 3, 8, 30, 60, 100_000]);
    if dice.roll(2) == 0 {
        machine.memory.area_mut(Area::BitMemory)[GLOBAL as usize + 3] = dice.of(&[0, 1, 2, 7, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn calls_by_name_do_what_the_interpreter_does() {
    let (mut asked, mut finished, mut beside) = (0, 0, 0);
    for seed in seeds(PROGRAMS) {
        let seldom = [4, 12, 60][seed as usize % 3];
        let bytes = if seed % 8 == 0 { FEWER_BYTES } else { BYTES };
        let of = |number: u64| Dice(3 * seed + number);
        let mut program = program(&[
            (BlockId::ob(1), 16, &|b| {
                b.begin_statement();
                let number = b.constant(1);
                b.push(Inst::Open { register: DataRegister::Instance, number });
                b.set(Register::Ar2, 0x8400_0000);
                b.push(Inst::Call { callee: Callee::Block(MAIN), parameters: 0 });
                b.begin_statement();
                b.push(Inst::Return);
            }),
            (MAIN, 16, &|b| Maker { b, dice: of(0), statements: 0, seldom, bytes }.main()),
            (MEMBER, 16, &|b| Maker { b, dice: of(1), statements: 0, seldom, bytes }.member()),
            (OTHER, 16, &|b| Maker { b, dice: of(2), statements: 0, seldom, bytes }.member()),
        ]);
        program.code.values_mut().for_each(|block| block.reads_own_locals = true);
        let layout = layout_with(&program, 1_000);
        let listing = Jit::listing(&program, &layout).expect("machine code");
        beside += usize::from(listing.contains("insertlane") || listing.contains("shuffle"));
        let engines = engines(&program, &layout);
        for round in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 4, 12, 40, 100_000, 100_000, 100_000]);
                let range = layout.data_blocks[&1].clone();
                machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.of(&[0, 1, 2, 0x3F, 0x80, 0x7F, 0xC0, 0xFF]));
                machine.memory.area_mut(Area::BitMemory)[GLOBAL as usize] = dice.of(&[0, 0x3F, 0x42]);
            };
            let outcome = |engine: Arc<dyn Engine>| {
                let dice = RefCell::new(Dice(seed + 2_000_000));
                let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
                let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
                let mut outcome = run(engine.as_ref(), &layout, &entry, &prepare, &answer);
                // Nobody reads what blocks left there that have ended.
                outcome.arena[layout.local.clone()].fill(0);
                outcome
            };
            let what = || format!("{seed} in round {round}\n{}\n{}", program.code[&MAIN].code, program.code[&MEMBER].code);
            let expected = all_engines_agree(&engines, true, &outcome, &what);
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    const { assert!(INSTANCES + COUNT * BYTES <= 1_000) };
    assert!(asked > 170 && finished > 260 && beside > 60, "{asked} questions, {finished} runs to the end, {beside} series");
}
