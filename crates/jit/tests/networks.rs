//! Networks that write bits of the same bytes one behind the other, and numbers of which a bit decides one bit: whoever looks at memory in
//! between, and whatever else is written there, finds it as the interpreter leaves it.

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_beside, engines, fixed, get, layout, program};

const PROGRAMS: u64 = 300;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 12;
const LOCAL_BYTES: u32 = 32;
const DATA_BYTES: u32 = 16;
/// Where bits, numbers, what the Host saw and the counter of a loop lie in bit memory, in bytes.
const BITS: u32 = 8;
const BITS_BYTES: u32 = 16;
const NUMBERS: u32 = 40;
const SEEN: u32 = 60;
const COUNTER: u32 = 64;

/// Networks of a program, one behind the other.
struct Networks<'a> {
    b: &'a mut Builder,
    dice: Dice,
    area: Area,
    /// Where the next bit is written, and where the next one that is copied is read.
    to: u32,
    from: u32,
    /// The register that holds 0, as a pointer.
    pointer: Option<Var>,
}

impl Networks<'_> {
    /// A bit of an area.
    fn bit(&mut self, area: Area, position: u32) -> Place {
        match area {
            Area::BitMemory => Place::Fixed { area, position: 8 * BITS + position % (8 * BITS_BYTES) },
            Area::Local => Place::Fixed { area, position: position % (8 * LOCAL_BYTES) },
            _ => {
                let pointer = self.pointer.unwrap_or_else(|| self.b.constant(0));
                self.pointer = Some(pointer);
                Place::Indirect { area, pointer, offset: position % (8 * DATA_BYTES) }
            }
        }
    }

    fn some_area(&mut self) -> Area {
        self.dice.of(&[Area::BitMemory, Area::BitMemory, Area::Local, Area::SharedData])
    }

    /// A bit that a network looks at: mostly one that lies near those that are written.
    fn operand(&mut self) -> Var {
        let position = match self.dice.roll(4) {
            0 => self.dice.roll(128) as u32,
            _ => (self.to + 128 - self.dice.roll(40) as u32) % 128,
        };
        let area = if self.dice.roll(4) == 0 { self.some_area() } else { self.area };
        let place = self.bit(area, position);
        self.b.load(place, Width::Bit, OnFault::SkipStatement)
    }

    fn network(&mut self) -> Var {
        let mut value = self.operand();
        for _ in 0..self.dice.roll(5) {
            let mut other = self.operand();
            if self.dice.roll(8) == 0 {
                other = self.b.compute(Op::Not, &[other]);
            }
            let op = self.dice.of(&[Op::And, Op::AndNot, Op::AndNot, Op::Or, Op::Or, Op::Xor]);
            let operands = if self.dice.roll(2) == 0 { [value, other] } else { [other, value] };
            value = self.b.compute(op, &operands);
        }
        match self.dice.roll(12) {
            0 => self.b.compute(Op::Not, &[value]),
            1 => self.b.constant(self.dice.roll(2)),
            2 => {
                let (number, other) = (get(self.b, NUMBERS, Width::Byte), self.b.constant(self.dice.roll(200)));
                self.b.compute(Op::LtI32, &[number, other])
            }
            _ => value,
        }
    }

    fn write(&mut self, value: Var) {
        let place = self.bit(self.area, self.to);
        self.b.store(place, Width::Bit, value);
    }

    /// `number := number OR mask`, or what looks like it.
    fn change_number(&mut self) {
        let width = self.dice.of(&[Width::DoubleWord, Width::DoubleWord, Width::Word, Width::Byte, Width::QuadWord]);
        let place = fixed(NUMBERS + 4 * self.dice.roll(2) as u32);
        let bit = 1u64 << self.dice.roll(u64::from(width.bytes() * 8).min(33));
        let all = u64::MAX >> (64 - 8 * width.bytes());
        let (op, mask) = match self.dice.roll(8) {
            0 => (Op::AndU64, all & !bit),
            1 => (Op::AndU32, u64::from(!(bit as u32))),
            2 => (Op::XorU64, bit),
            3 => (Op::OrU64, bit | 1),
            4 => (Op::AddU32, bit & 0xFFFF_FFFF),
            _ => (Op::OrU64, bit & all),
        };
        // Mostly the number itself.
        let from = if self.dice.roll(6) == 0 { fixed(NUMBERS + 8) } else { place };
        let (old, mask) = (self.b.load(from, width, OnFault::SkipStatement), self.b.constant(mask));
        let new = if self.dice.roll(8) == 0 { mask } else { self.b.compute(op, &[old, mask]) };
        self.b.store(place, width, new);
    }

    fn statement(&mut self) {
        self.pointer = None;
        let here = self.b.begin_statement();
        match self.dice.roll(24) {
            0 => (self.area, self.to) = (self.some_area(), self.dice.roll(128) as u32),
            1 => self.to = self.dice.roll(128) as u32,
            // The same one again, or the one before.
            2 => {}
            3 => self.to += 127,
            _ => self.to += 1,
        }
        self.to %= 128;
        match self.dice.roll(40) {
            0 => {
                let callee = Callee::Block(BlockId::new(BlockKind::SystemFunction, 64));
                self.b.push(Inst::Call { callee, parameters: 0 });
            }
            15 | 16 => {
                let (number, width) = (self.dice.of(&[0, 0, 1, 0x10, 0xFFFF]), self.dice.of(&[Width::DoubleWord, Width::Word]));
                let number = self.b.constant(number);
                self.b.store(fixed(NUMBERS + 4 * self.dice.roll(2) as u32), width, number);
            }
            1 => {
                let byte = fixed(BITS + self.dice.roll(13) as u32);
                let width = self.dice.of(&[Width::Byte, Width::Word, Width::DoubleWord]);
                let number = self.b.load(byte, width, OnFault::SkipStatement);
                self.b.store(fixed(NUMBERS), Width::DoubleWord, number);
            }
            2 => {
                let number = get(self.b, NUMBERS, Width::Byte);
                self.b.store(fixed(BITS + self.dice.roll(16) as u32), Width::Byte, number);
            }
            3..=8 => {
                if self.dice.roll(6) == 0 {
                    self.from = self.dice.roll(128) as u32;
                }
                self.from += 1;
                let area = if self.from & 64 == 0 { Area::BitMemory } else { Area::Local };
                let place = self.bit(area, self.from);
                let bit = self.b.load(place, Width::Bit, OnFault::SkipStatement);
                self.write(bit);
            }
            // Over the next statement, or over one more.
            9..=14 => {
                let mut condition = self.network();
                if self.dice.roll(2) == 0 {
                    condition = self.b.compute(Op::Not, &[condition]);
                }
                let further = if self.dice.roll(8) == 0 { 3 } else { 2 };
                self.b.push(Inst::Branch { condition, to: Target(here.0 + further) });
                self.b.begin_statement();
                self.pointer = None;
                if self.dice.roll(4) == 0 {
                    let value = self.network();
                    self.write(value);
                } else {
                    self.change_number();
                }
                self.b.begin_statement();
                self.pointer = None;
                let value = self.network();
                self.write(value);
            }
            _ => {
                let value = self.network();
                self.write(value);
            }
        }
    }
}

fn some_networks(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    b.begin_statement();
    let zero = b.constant(0);
    b.store(fixed(COUNTER), Width::DoubleWord, zero);
    // Local data begin with what nobody knows.
    for byte in (0..LOCAL_BYTES).step_by(4) {
        b.begin_statement();
        let number = get(b, NUMBERS + byte % 8, Width::DoubleWord);
        b.store(Place::Fixed { area: Area::Local, position: 8 * byte }, Width::DoubleWord, number);
    }
    let count = 10 + dice.roll(70);
    let area = dice.of(&[Area::BitMemory, Area::Local, Area::SharedData]);
    let (to, from) = (dice.roll(128) as u32, dice.roll(128) as u32);
    let mut networks = Networks { b, dice, area, to, from, pointer: None };
    (0..count).for_each(|_| networks.statement());
    let loops = networks.dice.roll(2) == 0;
    // Local data end where somebody can look.
    for byte in (0..LOCAL_BYTES).step_by(4) {
        b.begin_statement();
        let number = b.load(Place::Fixed { area: Area::Local, position: 8 * byte }, Width::DoubleWord, OnFault::SkipStatement);
        let old = get(b, SEEN, Width::DoubleWord);
        let (turned, mixed) = (b.constant(5), b.compute(Op::XorU32, &[old, number]));
        let mixed = b.compute(Op::Rol32, &[mixed, turned]);
        b.store(fixed(SEEN), Width::DoubleWord, mixed);
    }
    if loops {
        b.begin_statement();
        let (counter, one, limit) = (get(b, COUNTER, Width::DoubleWord), b.constant(1), b.constant(3));
        let next = b.compute(Op::AddU32, &[counter, one]);
        b.store(fixed(COUNTER), Width::DoubleWord, next);
        let again = b.compute(Op::LtI32, &[next, limit]);
        b.push(Inst::Branch { condition: again, to: Target(2) });
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// Notes the memory that the Host sees, and changes bits of it.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked == QUESTIONS_MAX || dice.roll(30) == 0 {
        return Reaction::Stop(StopReason { event: 0x4562, place: None });
    }
    machine.budget = dice.of(&[0, 1, 3, 100, 100_000]);
    let data = machine.memory.layout.data_blocks[&1].clone();
    let data: Vec<u8> = machine.memory.arena[data].to_vec();
    let memory = machine.memory.area_mut(Area::BitMemory);
    let mut sum = memory[SEEN as usize];
    for &byte in memory[..SEEN as usize].iter().chain(&data) {
        sum = sum.rotate_left(3) ^ byte;
    }
    memory[SEEN as usize] = sum;
    let changed = (BITS + dice.roll(u64::from(BITS_BYTES)) as u32) as usize;
    memory[changed] ^= dice.roll(256) as u8;
    Reaction::Continue
}

#[test]
fn networks_are_those_of_the_interpreter() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let program = program(&[(BlockId::ob(1), LOCAL_BYTES, &|b| some_networks(b, seed))]);
        let layout = layout(&program);
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.of(&[1, 100, 100_000, 100_000]);
            let data = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[data].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            machine.memory.area_mut(Area::BitMemory)[..SEEN as usize].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let dice = || Dice(seed + 2_000_000);
        let expected = all_engines_agree_beside(&engines(&program, &layout), &prepare, &dice, &meddle, &seed.to_string());
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 150 && finished > 150, "{asked} questions, {finished} runs to the end");
}

#[test]
fn a_bit_that_decides_goes_to_its_place_in_a_number() {
    let code = |op: Op, mask: u64| {
        let program = program(&[(BlockId::ob(1), 0, &|b| {
            b.begin_statement();
            let bit = b.load(Place::Fixed { area: Area::BitMemory, position: 3 }, Width::Bit, OnFault::SkipStatement);
            let condition = b.compute(Op::Not, &[bit]);
            b.push(Inst::Branch { condition, to: Target(2) });
            b.begin_statement();
            let (old, mask) = (get(b, NUMBERS, Width::DoubleWord), b.constant(mask));
            let new = b.compute(op, &[old, mask]);
            b.store(fixed(NUMBERS), Width::DoubleWord, new);
            b.begin_statement();
            b.push(Inst::Return);
        })]);
        Jit::listing(&program, &layout(&program)).expect("machine code")
    };
    let chooses = |op: Op, mask: u64| code(op, mask).contains("= select");
    assert!(!chooses(Op::OrU64, 0x10_0000) && !chooses(Op::XorU64, 1) && !chooses(Op::AndU64, 0xFFFF_FFEF));
    assert!(chooses(Op::OrU64, 0x11_0000) && chooses(Op::AndU64, 0x10));
}
