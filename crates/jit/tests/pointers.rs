//! Blocks that get pointers to pointers, as parameters that are handed on are: machine code that knows where these lead, or looks into
//! the table of data blocks, does what the interpreter does under a Host that changes memory and takes data blocks away.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, TextAction, TextRoom, Var};
use sieben_engine::{Engine, Entry, Exit, FaultPlace, Interpreter, Machine, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::dice::{Dice, seeds};
use crate::noting::{layout, program, run};

/// Programs that are compared.
const PROGRAMS: u64 = 150;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 60;
/// Functions of a program; each calls those behind it.
const FUNCTIONS: u16 = 3;
/// Bytes of memory that programs use: few, so that accesses meet.
const BYTES: u64 = 8;
/// Local data of a block: two pointers with the numbers of data blocks, a counter for each of two loops, a few bytes.
const LOCAL_BYTES: u32 = 32;
const POINTERS: [u32; 2] = [0, 8];
const COUNTERS: [u32; 2] = [14, 15];
const OTHERS: u32 = 16;

fn local(byte: u32) -> Place {
    Place::Fixed { area: Area::Local, position: 8 * byte }
}

fn width(dice: &mut Dice) -> Width {
    dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::DoubleWord])
}

/// A block that is being written.
struct Block<'a> {
    b: &'a mut Builder,
    dice: Dice,
    number: u16,
    statements: u32,
}

impl Block<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn load(&mut self, place: Place, width: Width) -> Var {
        let on_fault = self.dice.of(&[OnFault::SkipStatement, OnFault::SkipStatement, OnFault::SkipStatement, OnFault::DeliverZero]);
        self.b.load(place, width, on_fault)
    }

    /// Writes one of the two pointers in the local data: mostly constants.
    fn make_pointer(&mut self) {
        let at = self.dice.of(&POINTERS);
        self.begin();
        let number = match self.dice.roll(8) {
            0 => self.load(Place::Fixed { area: Area::BitMemory, position: 0 }, Width::Word),
            _ => {
                let number = self.dice.of(&[1, 1, 1, 2, 2, 0, 9]);
                self.b.constant(number)
            }
        };
        self.b.store(local(at), Width::Word, number);
        let area = self.dice.of(&[0x84, 0x84, 0x84, 0x84, 0x83, 0x82, 0x85, 0x86, 0x87, 0x88]);
        let byte = match area {
            0x86 | 0x87 => self.dice.roll(24) * 8,
            _ => self.dice.roll(6) * 8,
        };
        let mut pointer = self.b.constant(area << 24 | byte);
        if self.dice.roll(4) == 0 {
            let moved = self.load(Place::Fixed { area: Area::BitMemory, position: 8 }, Width::Byte);
            let mask = self.b.constant(self.dice.of(&[1, 3, 255]));
            let moved = self.b.compute(Op::AndU32, &[moved, mask]);
            let eight = self.b.constant(8);
            let moved = self.b.compute(Op::MulU32, &[moved, eight]);
            pointer = self.b.compute(Op::AddU32, &[pointer, moved]);
        }
        self.b.store(local(at + 2), Width::DoubleWord, pointer);
    }

    /// Where a pointer leads that a parameter points to, or the pointer itself.
    fn target(&mut self, width: Width) -> Place {
        let parameter = self.dice.roll(2) as u16;
        let pointer = self.b.temporary();
        self.b.push(Inst::Parameter { dst: pointer, index: parameter });
        if self.dice.roll(12) == 0 {
            return Place::Crossing { pointer, offset: self.dice.of(&[0, 0, 16, 24]) };
        }
        let number = self.load(Place::Crossing { pointer, offset: 0 }, Width::Word);
        let mut to = self.load(Place::Crossing { pointer, offset: 16 }, Width::DoubleWord);
        if self.dice.roll(3) > 0 {
            let counter = local(self.dice.of(&COUNTERS));
            let mut index = self.load(counter, Width::Byte);
            if self.dice.roll(3) > 0 {
                let mask = self.b.constant(7);
                index = self.b.compute(Op::AndU32, &[index, mask]);
            }
            let step = self.b.constant(if width == Width::Bit { 1 } else { self.dice.of(&[8, 8, 16, 1]) });
            let index = self.b.compute(Op::MulU32, &[index, step]);
            to = self.b.compute(Op::AddU32, &[to, index]);
        }
        self.b.push(Inst::Open { register: DataRegister::Shared, number });
        Place::Crossing { pointer: to, offset: self.dice.of(&[0, 0, 0, 8, 16]) }
    }

    fn statement(&mut self) {
        let width = width(&mut self.dice);
        let own = {
            let bit = if width == Width::Bit { self.dice.roll(8) as u32 } else { 0 };
            let byte = OTHERS + self.dice.roll(8) as u32;
            match self.dice.roll(3) {
                0 => Place::Fixed { area: Area::BitMemory, position: 8 * self.dice.roll(BYTES) as u32 + bit },
                _ => Place::Fixed { area: Area::Local, position: 8 * byte + bit },
            }
        };
        match self.dice.roll(20) {
            0..=1 => self.make_pointer(),
            16..=19 => self.text(),
            // Hands a pointer on, as it is: number and pointer are read and written.
            2 => {
                let at = self.dice.of(&POINTERS);
                self.begin();
                let pointer = self.b.temporary();
                self.b.push(Inst::Parameter { dst: pointer, index: self.dice.roll(2) as u16 });
                let number = self.load(Place::Crossing { pointer, offset: 0 }, Width::Word);
                self.b.store(local(at), Width::Word, number);
                let to = self.load(Place::Crossing { pointer, offset: 16 }, Width::DoubleWord);
                self.b.store(local(at + 2), Width::DoubleWord, to);
            }
            3 => {
                self.begin();
                let from = self.target(Width::Byte);
                let Place::Crossing { pointer, .. } = from else { return };
                let bytes = self.dice.of(&[2, 4, 6]);
                let (from, to) = if self.dice.roll(2) == 0 { (from, own) } else { (own, Place::Crossing { pointer, offset: 0 }) };
                if width != Width::Bit {
                    self.b.push(Inst::Move { from, to, bytes });
                }
            }
            4 => {
                self.begin();
                let number = self.dice.of(&[1, 2, 0, 9]);
                let number = self.b.constant(number);
                let register = self.dice.of(&[DataRegister::Shared, DataRegister::Instance]);
                self.b.push(Inst::Open { register, number });
            }
            5..=8 if self.number < FUNCTIONS => self.call(),
            9..=11 => {
                self.begin();
                let from = self.target(width);
                let value = self.load(from, width);
                self.b.store(own, width, value);
            }
            _ => {
                self.begin();
                let mut value = self.load(own, width);
                if width != Width::Bit {
                    let one = self.b.constant(1);
                    value = self.b.compute(Op::AddU32, &[value, one]);
                }
                let to = self.target(width);
                self.b.store(to, width, value);
            }
        }
    }

    /// Something that is done with texts, of which at least one is behind a pointer that a parameter points to. Some say themselves how
    /// long they are.
    fn text(&mut self) {
        self.begin();
        let far = self.far();
        let other = match self.dice.roll(3) {
            0 => self.far(),
            1 => Place::Fixed { area: Area::BitMemory, position: 8 * self.dice.roll(BYTES) as u32 },
            _ => local(OTHERS + self.dice.roll(8) as u32),
        };
        let (from, to) = if self.dice.roll(2) == 0 { (far, other) } else { (other, far) };
        let action = self.dice.of(&TextAction::ALL);
        let mut room = || TextRoom { characters_max: self.dice.of(&[0, 0, 0, 1, 3, 6]), wide: self.dice.roll(8) == 0 };
        let (to_room, from_room) = (room(), room());
        let to_room = if action == TextAction::Number { TextRoom::NUMBER } else { to_room };
        let piece = [self.dice.of(&[0, 0, 1, 3]), self.dice.of(&[0, 1, 2, 0x7FFF_FFFF])].map(|number| self.b.constant(number));
        let dst = self.b.temporary();
        self.b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece });
        self.b.store(local(OTHERS + 8), Width::Byte, dst);
    }

    /// A text behind the pointer to which a parameter points, with the number of its data block.
    fn far(&mut self) -> Place {
        let pointer = self.b.temporary();
        self.b.push(Inst::Parameter { dst: pointer, index: self.dice.roll(2) as u16 });
        let number = self.load(Place::Crossing { pointer, offset: 0 }, Width::Word);
        let mut to = self.load(Place::Crossing { pointer, offset: 16 }, Width::DoubleWord);
        if self.dice.roll(4) == 0 {
            let (index, eight) = (self.load(local(COUNTERS[0]), Width::Byte), self.b.constant(8));
            let index = self.b.compute(Op::MulU32, &[index, eight]);
            to = self.b.compute(Op::AddU32, &[to, index]);
        }
        let half = self.b.constant(32);
        let number = self.b.compute(Op::Shl64, &[number, half]);
        let pointer = self.b.compute(Op::OrU64, &[number, to]);
        Place::Crossing { pointer, offset: self.dice.of(&[0, 0, 0, 8]) }
    }

    fn call(&mut self) {
        self.begin();
        if self.dice.roll(16) == 0 {
            let callee = Callee::Block(BlockId::new(BlockKind::SystemFunction, 64));
            return self.b.push(Inst::Call { callee, parameters: 0 });
        }
        for _ in 0..2 {
            let parameter = match self.dice.roll(16) {
                0 => 0x8300_0000 + 8 * self.dice.roll(4),
                // Those that this block was given itself, in the local data of its caller.
                1..=4 if self.number > 0 => 0x8708_0000 + 8 * u64::from(self.dice.of(&POINTERS)),
                _ => 0x8700_0000 + 8 * u64::from(self.dice.of(&POINTERS)),
            };
            let src = self.b.constant(parameter);
            self.b.push(Inst::PassParameter { src });
        }
        let number = self.number + 1 + self.dice.roll(u64::from(FUNCTIONS - self.number)) as u16;
        self.b.push(Inst::Call { callee: Callee::Block(BlockId::fc(number)), parameters: 2 });
    }

    /// A loop of a few iterations, with another one in it now and then.
    fn repeat(&mut self, level: usize) {
        let counter = local(COUNTERS[level]);
        self.begin();
        let first = self.b.constant(self.dice.roll(3));
        self.b.store(counter, Width::Byte, first);
        let head = self.statements;
        for _ in 0..1 + self.dice.roll(3) {
            self.statement();
        }
        if level == 0 && self.dice.roll(3) == 0 {
            self.repeat(1);
        }
        self.begin();
        let (now, one) = (self.load(counter, Width::Byte), self.b.constant(1));
        let now = self.b.compute(Op::AddU32, &[now, one]);
        self.b.store(counter, Width::Byte, now);
        self.begin();
        let (now, last) = (self.load(counter, Width::Byte), self.b.constant(self.dice.of(&[2, 4, 7])));
        let goes_on = self.b.compute(Op::Below, &[now, last]);
        self.b.push(Inst::Branch { condition: goes_on, to: Target(head) });
    }

    fn write(mut self) {
        self.make_pointer();
        self.make_pointer();
        for _ in 0..1 + self.dice.roll(3) {
            if self.dice.roll(2) == 0 {
                self.repeat(0)
            } else {
                self.statement()
            }
            if self.number == 0 {
                self.call();
            }
        }
        self.begin();
        self.b.push(Inst::Return);
    }
}

/// Changes a few bytes and the budget, takes a data block away or brings it back, and goes on.
fn meddle(machine: &mut Machine, dice: &mut Dice, what: &str, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 2, 5, 10, 20, 40]);
    if what.starts_with("SFC") && dice.roll(2) == 0 {
        let first = machine.memory.data_blocks[1];
        let there = machine.memory.data_blocks[2].is_some();
        machine.memory.data_blocks[2] = if there { None } else { first };
    }
    for _ in 0..dice.of(&[0, 0, 1, 3]) {
        let value = dice.roll(256) as u8;
        let range = machine.memory.layout.data_blocks[&1].clone();
        match dice.roll(2) {
            0 => machine.memory.arena[range.start + dice.roll(BYTES) as usize] = value,
            _ => machine.memory.area_mut(Area::BitMemory)[dice.roll(BYTES) as usize] = value,
        }
    }
    Reaction::Continue
}

#[test]
fn pointers_to_pointers_lead_to_the_same_places_on_all_engines() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let build =
            |number: u16| move |b: &mut Builder| Block { b, dice: Dice(seed * 100 + u64::from(number)), number, statements: 0 }.write();
        let builders: Vec<_> = (0..=FUNCTIONS).map(build).collect();
        let id = |number: u16| if number == 0 { BlockId::ob(1) } else { BlockId::fc(number) };
        let part = |(number, build)| (id(number), LOCAL_BYTES, build as &dyn Fn(&mut Builder));
        let parts: Vec<_> = (0..).zip(&builders).map(part).collect();
        let program = program(&parts);
        let mut layout = layout(&program);
        layout.data_blocks.insert(2, layout.size - 48..layout.size - 32);
        if seed % 4 == 0 {
            layout.read_only.push(2);
        }
        let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.budget = dice.roll(60) as i64;
            machine.memory.area_mut(Area::BitMemory)[2..BYTES as usize].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
            machine.memory.area_mut(Area::BitMemory)[1] = dice.roll(3) as u8;
        };
        let outcome = |engine: Arc<dyn Engine>| {
            let (dice, seen) = (RefCell::new(Dice(seed + 2_000_000)), RefCell::new(Vec::new()));
            let answer = |machine: &mut Machine, what: &str, asked: usize| {
                let r = &machine.registers;
                let open = [r.db_number, r.db_base, r.db_length, r.di_number, r.di_base, r.di_length];
                seen.borrow_mut().push((machine.budget, open, machine.memory.arena.clone()));
                meddle(machine, &mut dice.borrow_mut(), what, asked)
            };
            let outcome = run(engine.as_ref(), &layout, &entry, &prepare, &answer);
            (outcome, seen.into_inner())
        };
        let (expected, expected_seen) = outcome(Interpreter::load(&program, &layout));
        for status in [StatusBits::All, StatusBits::Needed] {
            let (got, got_seen) = outcome(Jit::compiled(&program, &layout, status).expect("machine code"));
            let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
            assert_eq!(got.asked, expected.asked, "{seed} {status:?}\n{}", listing());
            if let Some(at) = (0..expected_seen.len()).find(|&at| got_seen[at] != expected_seen[at]) {
                let bytes = got_seen[at].2.iter().zip(&expected_seen[at].2).position(|(a, b)| a != b);
                let parts = |seen: &(i64, [u64; 6], Vec<u8>)| (seen.0, seen.1);
                let (got, expected_here) = (parts(&got_seen[at]), parts(&expected_seen[at]));
                panic!(
                    "{seed} {status:?}: question {at}, {}: {got:?}, {expected_here:?}, byte {bytes:?}\n{}",
                    expected.asked[at],
                    listing()
                );
            }
            got.assert_ends_as(&expected, &|| format!("{seed} {status:?}\n{}", listing()));
        }
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 500 && finished > 50, "{asked} questions, {finished} runs to the end");
}
