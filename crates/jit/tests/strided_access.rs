//! Counted loops over arrays of records with fields of every width: whatever they compute with them, whichever variables only some
//! iterations write, and whatever the Host makes of memory and budget, they do on all engines what the interpreter does.

use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

const PROGRAMS: u64 = 300;
/// One in which a write needs, in order, what others of the vectorized iterations read behind it.
const IN_ORDER: u64 = 1_682;
/// Iterations that call something choose between more than two ways, too.
const FUNCTION: BlockId = BlockId::fc(1);
const QUESTIONS_MAX: usize = 30;
/// Two arrays of records: where they begin, and bytes of a record.
const ARRAYS: [(u32, u32); 2] = [(0, 32), (512, 34)];
/// The same where records of both have as many bytes.
const ALIKE: [(u32, u32); 2] = [(0, 32), (512, 32)];
/// The same where the fields of one lie over those of the next ones.
const OVER_ONE_ANOTHER: [(u32, u32); 2] = [(16, 1), (512, 6)];
/// The same with records of eight bytes, as counters are.
const OF_EIGHT: [(u32, u32); 2] = [(0, 8), (512, 8)];
const RECORDS: u32 = 14;
/// Where the variables lie, in bytes.
const COUNTER: u32 = 1_000;
const NUMBERS: u32 = 1_008;
const FLAGS: u32 = 1_040;
/// Variables that each iteration makes of what the one before has left: one like a sum of REALs, one like a random number, and a bit.
const TOTAL: u32 = NUMBERS + 24;
const SEED: u32 = NUMBERS + 28;
const STATE: u32 = 8 * FLAGS + 12;
/// Bits that follow one another, and variables at addresses that each iteration computes.
const ROW: u32 = 1_048;
const TABLE: u32 = 1_056;

/// What a field holds.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Bit,
    Byte,
    Half,
    Double,
    Real,
    Quad,
    Lreal,
}

use Kind::{Bit, Byte, Double, Half, Lreal, Quad, Real};

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_beside, engines, program};

/// Where the fields lie in a record, in bits.
const FIELDS: &[(u32, Kind)] = &[
    (0, Double),
    (32, Real),
    (64, Half),
    (80, Bit),
    (81, Bit),
    (87, Bit),
    (88, Byte),
    (96, Quad),
    (96, Lreal),
    (128, Double),
    (160, Real),
    (160, Double),
    (176, Half),
    (192, Byte),
    (208, Half),
    (226, Bit),
    (248, Byte),
];

/// The same in a record of eight bytes.
const FIELDS_OF_EIGHT: &[(u32, Kind)] =
    &[(0, Bit), (1, Bit), (2, Bit), (8, Byte), (16, Half), (32, Bit), (33, Bit), (40, Bit), (48, Half), (32, Real), (16, Double)];

impl Kind {
    fn width(self) -> Width {
        match self {
            Bit => Width::Bit,
            Byte => Width::Byte,
            Half => Width::Word,
            Double | Real => Width::DoubleWord,
            Quad | Lreal => Width::QuadWord,
        }
    }

    fn of_two(self) -> &'static [Op] {
        match self {
            Bit => &[Op::And, Op::Or, Op::Xor, Op::AndNot],
            Byte => &[Op::AndU32, Op::OrU32],
            Half => &[Op::AddU16, Op::SubU16, Op::MulU16, Op::DivI16, Op::RemI16],
            Double => &[Op::AddU32, Op::SubU32, Op::MulU32, Op::XorU32, Op::MinI32, Op::DivI32, Op::RemI32, Op::DivU64, Op::RemU64],
            Real => &[Op::AddF32, Op::SubF32, Op::MulF32, Op::DivF32, Op::MinF32, Op::MaxF32],
            Quad => &[Op::AddU64, Op::SubU64, Op::XorU64],
            Lreal => &[Op::AddF64, Op::SubF64, Op::MulF64, Op::DivF64, Op::MaxF64],
        }
    }

    fn comparisons(self) -> &'static [Op] {
        match self {
            Bit => &[Op::Xor],
            Byte | Double => &[Op::LtI32, Op::GeI32, Op::LeI32, Op::LeU64, Op::GtU64, Op::GeU64, Op::Equal, Op::Differ, Op::DivFailsI32],
            Half => &[Op::LtI16, Op::GeI16, Op::LeI16, Op::NeI16, Op::EqI16],
            Real => &[Op::LtF32, Op::GeF32, Op::DifferF32, Op::NeF32],
            Quad => &[Op::LtI64, Op::Equal],
            Lreal => &[Op::LtF64, Op::GeF64, Op::DifferF64],
        }
    }

    /// Conversions to it.
    fn conversions(self) -> &'static [(Kind, Op)] {
        match self {
            Bit => &[(Double, Op::IsNonzero), (Half, Op::IsNonzero)],
            Byte => &[(Half, Op::Low8), (Double, Op::Low8)],
            Half => &[(Double, Op::Low16), (Byte, Op::Low16), (Lreal, Op::F64ToI16)],
            Double => &[(Half, Op::Extend16), (Bit, Op::Copy), (Quad, Op::Low32), (Lreal, Op::F64ToI32)],
            Real => &[(Double, Op::I32ToF32), (Lreal, Op::F64ToF32)],
            Quad => &[(Double, Op::ExtendI32I64)],
            Lreal => &[(Real, Op::F32ToF64), (Double, Op::I32ToF64)],
        }
    }
}

fn fixed(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

/// A loop over the records in the making.
struct Maker<'b> {
    b: &'b mut Builder,
    dice: Dice,
    statements: u32,
    arrays: &'static [(u32, u32)],
    fields: &'static [(u32, Kind)],
}

impl Maker<'_> {
    fn begin(&mut self) {
        self.b.begin_statement();
        self.statements += 1;
    }

    fn get(&mut self, place: Place, kind: Kind) -> Var {
        self.b.load(place, kind.width(), OnFault::SkipStatement)
    }

    /// A field of the record of an iteration, now and then one of the record before or behind it.
    fn field(&mut self) -> (Place, Kind) {
        let (start, record) = self.dice.of(self.arrays);
        let (offset, kind) = self.dice.of(self.fields);
        let neighbour = self.dice.of(&[0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 1_i32]);
        let counter = self.get(fixed(8 * COUNTER), Double);
        let bits = self.b.constant(u64::from(8 * record));
        let pointer = self.b.compute(Op::MulU32, &[counter, bits]);
        // The counter begins with 1.
        let offset = (8 * start + offset) as i32 + (neighbour - 1) * 8 * record as i32;
        (Place::Indirect { area: Area::BitMemory, pointer, offset: offset as u32 & 0x00FF_FFFF }, kind)
    }

    /// A bit of the row, that of the iteration or one near to it.
    fn bit_of_row(&mut self) -> Place {
        let counter = self.get(fixed(8 * COUNTER), Double);
        let offset = 8 * ROW + self.dice.of(&[1, 1, 1, 0, 2, 3, 9]);
        Place::Indirect { area: Area::BitMemory, pointer: counter, offset }
    }

    /// A variable at an address that the iteration computes.
    fn of_table(&mut self, kind: Kind) -> Var {
        let number = self.number(Double, 1);
        let (op, limit) = self.dice.of(&[(Op::AndU32, 7), (Op::AndU32, 3)]);
        let limit = self.b.constant(limit);
        let index = self.b.compute(op, &[number, limit]);
        let bits = self.b.constant(if kind == Bit { 3 } else { u64::from(8 * kind.width().bytes()) });
        let pointer = self.b.compute(Op::MulU32, &[index, bits]);
        self.get(Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * TABLE }, kind)
    }

    fn number(&mut self, kind: Kind, depth: usize) -> Var {
        match self.dice.roll(if depth == 0 { 6 } else { 14 }) {
            12 if matches!(kind, Bit | Half | Double) => self.of_table(kind),
            13 => match kind {
                Bit if self.dice.roll(2) == 0 => {
                    let place = self.bit_of_row();
                    self.get(place, Bit)
                }
                Bit => self.get(fixed(STATE), Bit),
                Real => self.get(fixed(8 * TOTAL), Real),
                Double => self.get(fixed(8 * SEED), Double),
                _ => self.constant(kind),
            },
            0..=3 => {
                // Another field often has another kind: those of the same width look at its bits.
                for _ in 0..8 {
                    let (place, found) = self.field();
                    if found.width() == kind.width() {
                        return self.get(place, kind);
                    }
                }
                self.constant(kind)
            }
            4 => self.constant(kind),
            5 if kind == Double => self.get(fixed(8 * COUNTER), Double),
            5 if kind == Bit => {
                let bit = self.dice.roll(3) as u32;
                self.get(fixed(8 * FLAGS + bit), Bit)
            }
            5 => self.constant(kind),
            7 if kind == Bit => {
                let bit = self.number(Bit, depth - 1);
                self.b.compute(Op::Not, &[bit])
            }
            6 | 7 => {
                let (from, op) = self.dice.of(kind.conversions());
                // Mostly a REAL is cut.
                let is_cut = matches!(op, Op::F64ToI16 | Op::F64ToI32) && self.dice.roll(4) != 0;
                let mut value = self.number(if is_cut { Real } else { from }, depth - 1);
                if is_cut {
                    value = self.b.compute(Op::F32ToF64, &[value]);
                    let whole = self.dice.of(&[Op::RoundF64, Op::CeilF64, Op::FloorF64, Op::TruncF64, Op::TruncF64]);
                    value = self.b.compute(whole, &[value]);
                }
                self.b.compute(op, &[value])
            }
            8 if kind == Bit => self.comparison(depth),
            9 if kind == Bit => {
                let (op, parts) = (self.dice.of(kind.of_two()), [self.comparison(depth), self.comparison(depth)]);
                self.b.compute(op, &parts)
            }
            9 if kind == Half => {
                let parts = [self.comparison(depth), self.constant(kind), self.constant(kind)];
                self.b.compute(Op::Select, &parts)
            }
            8 => {
                let parts = [self.number(Bit, depth - 1), self.number(kind, depth - 1), self.number(kind, depth - 1)];
                self.b.compute(Op::Select, &parts)
            }
            _ => {
                let op = self.dice.of(kind.of_two());
                let parts = [self.number(kind, depth - 1), self.number(kind, depth - 1)];
                self.b.compute(op, &parts)
            }
        }
    }

    fn comparison(&mut self, depth: usize) -> Var {
        let of = self.dice.of(&[Byte, Half, Double, Real, Quad, Lreal]);
        let op = self.dice.of(of.comparisons());
        let parts = [self.number(of, depth - 1), self.number(of, depth - 1)];
        self.b.compute(op, &parts)
    }

    fn constant(&mut self, kind: Kind) -> Var {
        let value = match kind {
            Bit => self.dice.of(&[0, 1]),
            Real => u64::from(self.dice.of(&[0.5_f32, 3.0, -1.0]).to_bits()),
            Lreal => self.dice.of(&[0.5_f64, 3.0, -1.0]).to_bits(),
            Half => self.dice.of(&[1, 2, 3, 7, 100, 0x7FFF, 0x8000, 0xFFFF]),
            _ => self.dice.of(&[1, 2, 3, 7, 100, 0x7FFF]),
        };
        self.b.constant(value)
    }

    /// Makes something of what the iteration before has left.
    fn chain(&mut self) {
        let (place, kind) = self.dice.of(&[(8 * TOTAL, Real), (8 * SEED, Double), (STATE, Bit)]);
        let before = self.get(fixed(place), kind);
        let mut value = match self.dice.roll(4) {
            // The next iteration finds what this one has.
            0 => self.number(kind, 2),
            _ => {
                let (more, op) = (self.number(kind, 1), self.dice.of(kind.of_two()));
                self.b.compute(op, &[before, more])
            }
        };
        if kind == Double {
            let (factor, modulus) = (self.b.constant(75), self.b.constant(self.dice.of(&[65_537, 8, 1_000])));
            let product = self.b.compute(Op::MulU32, &[value, factor]);
            value = self.b.compute(Op::RemI32, &[product, modulus]);
        }
        self.b.store(fixed(place), kind.width(), value);
    }

    fn statement(&mut self) {
        self.begin();
        match self.dice.roll(10) {
            8 => self.chain(),
            9 => {
                let value = self.number(Bit, 2);
                let place = self.bit_of_row();
                self.b.store(place, Width::Bit, value);
            }
            0 => {
                let place = fixed(8 * NUMBERS);
                let (before, more) = (self.get(place, Double), self.number(Double, 2));
                let op = self.dice.of(&[Op::AddU32, Op::AddU32, Op::SubU32]);
                let sum = self.b.compute(op, &[before, more]);
                self.b.store(place, Width::DoubleWord, sum);
            }
            // A variable that this iteration writes, which may be read in none before.
            1 | 2 => {
                let kind = self.dice.of(&[Half, Double, Real, Quad, Bit]);
                let value = self.number(kind, 2);
                let place = match kind {
                    Bit => fixed(8 * FLAGS + 7),
                    Half => fixed(8 * NUMBERS + 32),
                    Quad => fixed(8 * NUMBERS + 128),
                    _ => fixed(8 * NUMBERS + 64),
                };
                self.b.store(place, kind.width(), value);
            }
            _ => {
                let (place, kind) = self.field();
                // Bits of one byte are mostly written together, and often the same.
                let together = kind == Bit && self.dice.roll(2) == 0;
                let value = self.number(kind, if together { 2 } else { 3 });
                self.b.store(place, kind.width(), value);
                if together && let Place::Indirect { area, pointer, offset } = place {
                    let other = match self.dice.roll(4) {
                        0 => value,
                        1 => self.b.compute(Op::Not, &[value]),
                        2 => self.constant(Bit),
                        _ => self.comparison(1),
                    };
                    self.b.store(Place::Indirect { area, pointer, offset: offset ^ 1 }, Width::Bit, other);
                }
            }
        }
    }

    /// Statements of an iteration, some of which are jumped over under a condition.
    fn parts(&mut self, parts: &[usize]) {
        for &jumped_over in parts {
            if jumped_over > 0 {
                self.begin();
                let condition = self.number(Bit, 2);
                let behind = self.statements + jumped_over as u32;
                self.b.push(Inst::Branch { condition, to: Target(behind) });
            }
            (0..jumped_over.max(1)).for_each(|_| self.statement());
        }
    }

    /// Some statements, of which a number chooses one or none: several numbers may choose the same one.
    fn choice(&mut self) {
        self.begin();
        let ways = 2 + self.dice.roll(4) as u32;
        let count = ways + self.dice.of(&[0, 0, 1, 4, 7]);
        let kind = self.dice.of(&[Half, Double]);
        let number = self.number(kind, 1);
        let most = self.b.constant(self.dice.of(&[3, 7, 15]));
        let index = self.b.compute(Op::AndU32, &[number, most]);
        let first = self.statements;
        let behind = Target(first + 2 * ways);
        let of_number = |number: u32| if number < ways { number } else { self.dice.roll(u64::from(ways) + 3) as u32 };
        let targets: Vec<u32> = (0..count).map(of_number).collect();
        let targets: Vec<Target> = targets.into_iter().map(|way| if way < ways { Target(first + 2 * way) } else { behind }).collect();
        let table = self.b.table(&targets);
        self.b.push(Inst::JumpTable { index, first: table, count, otherwise: behind });
        for _ in 0..ways {
            self.statement();
            self.begin();
            self.b.push(Inst::Jump { to: behind });
        }
    }

    fn looping(&mut self) {
        self.begin();
        let one = self.b.constant(1);
        self.b.store(fixed(8 * COUNTER), Width::DoubleWord, one);
        let parts: Vec<usize> = (0..2 + self.dice.roll(4)).map(|_| self.dice.roll(3) as usize).collect();
        self.parts(&parts);
        if self.dice.roll(3) == 0 {
            self.begin();
            self.b.push(Inst::Call { callee: Callee::Block(FUNCTION), parameters: 0 });
            self.choice();
        }
        self.begin();
        let counter = self.get(fixed(8 * COUNTER), Double);
        let one = self.b.constant(1);
        let next = self.b.compute(Op::AddU32, &[counter, one]);
        self.b.store(fixed(8 * COUNTER), Width::DoubleWord, next);
        let last = self.dice.of(&[5, 8, 12]);
        let last = self.b.constant(last);
        let again = self.b.compute(Op::LeI32, &[next, last]);
        self.b.push(Inst::Branch { condition: again, to: Target(1) });
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
        let place = dice.of(&[COUNTER + 3, FLAGS, NUMBERS, TOTAL, ROW, TABLE, 0, 4, 34, 530]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 2, 7, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn records_hold_what_the_interpreter_writes() {
    let (mut asked, mut finished, mut beside) = (0, 0, 0);
    for seed in seeds(PROGRAMS).chain([IN_ORDER]) {
        let block = BlockId::ob(1);
        let (arrays, fields): (&[(u32, u32)], _) = match seed % 8 {
            5 => (&OVER_ONE_ANOTHER, FIELDS),
            1 | 3 => (&ALIKE, FIELDS),
            6 | 7 => (&OF_EIGHT, FIELDS_OF_EIGHT),
            _ => (&ARRAYS, FIELDS),
        };
        let program = program(&[
            (block, 16, &|b| Maker { b, dice: Dice(seed), statements: 0, arrays, fields }.looping()),
            (FUNCTION, 0, &|b| {
                b.begin_statement();
                b.constant(1);
            }),
        ]);
        let layout = noting::layout(&program);
        let listing = Jit::listing(&program, &layout).expect("machine code");
        beside += usize::from(listing.contains("insertlane"));
        let engines = engines(&program, &layout);
        for round in 0..3 {
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + round);
                machine.budget = dice.of(&[1, 4, 12, 40, 100_000, 100_000, 100_000]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory.iter_mut().take(1_100).for_each(|byte| *byte = dice.of(&[0, 1, 2, 0x3F, 0x80, 0x7F, 0xC0, 0xFF]));
            };
            let dice = || Dice(seed + 2_000_000);
            let expected = all_engines_agree_beside(&engines, &prepare, &dice, &meddle, &format!("{seed} in round {round}"));
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    const { assert!(ARRAYS[1].0 + ARRAYS[1].1 * RECORDS <= COUNTER) };
    assert!(asked > 300 && finished > 600 && beside > 60, "{asked} questions, {finished} runs to the end, {beside} loops side by side");
}
