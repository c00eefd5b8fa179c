//! One assignment under a condition, or one of two to the same variable, or constants in the branches of a CASE, of every width: whatever
//! is written, whether it is entered from elsewhere, and in whatever loop it stands, it does on all engines what the interpreter does.

use sieben_engine::Machine;
use sieben_engine::ir::{Builder, Inst, Op, Place, Target, Var};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree_from, counted, fixed, get, program};

const PROGRAMS: u64 = 500;
/// Memories from which each program runs.
const MEMORIES: u64 = 10;
const COUNTER: u32 = 60;
const WIDTHS: [Width; 5] = [Width::Bit, Width::Byte, Width::Word, Width::DoubleWord, Width::QuadWord];
/// Variables of each width.
const VARIABLES: u32 = 3;

/// One of the variables of a width.
fn variable(width: Width, number: u32) -> Place {
    let first = match width {
        Width::Bit => return Place::Fixed { area: Area::BitMemory, position: 8 * 16 + 3 * number },
        // Some share bytes.
        Width::Byte => 4,
        Width::Word => 2,
        Width::DoubleWord => 20,
        Width::QuadWord => 32,
    };
    fixed(first + width.bytes() * number)
}

/// What an assignment computes.
#[derive(Clone, Copy)]
struct Assigned {
    seed: u64,
}

impl Assigned {
    /// Writes a statement that assigns it.
    fn write(self, b: &mut Builder, (place, width): (Place, Width)) {
        let mut dice = Dice(self.seed);
        let operand = |b: &mut Builder, dice: &mut Dice| match dice.roll(4) {
            0 => b.constant(if width == Width::Bit { dice.roll(2) } else { dice.of(&[0, 1, 2, 7, 0x80, 0xFF]) }),
            1 => get_from(b, (place, width)),
            _ => get_from(b, (variable(width, dice.roll(VARIABLES.into()) as u32), width)),
        };
        b.begin_statement();
        let value = match (width, dice.roll(6)) {
            (_, 0) => operand(b, &mut dice),
            (Width::Bit, 1) => {
                let bit = operand(b, &mut dice);
                b.compute(Op::Not, &[bit])
            }
            (Width::Bit, _) => {
                let [x, y] = [0; 2].map(|_| operand(b, &mut dice));
                b.compute(dice.of(&[Op::And, Op::Or, Op::Xor, Op::AndNot]), &[x, y])
            }
            (Width::Byte, 1) => {
                let [x, one] = [operand(b, &mut dice), b.constant(1)];
                b.compute(dice.of(&[Op::Shl8, Op::Shr8]), &[x, one])
            }
            (Width::DoubleWord, 1) => {
                let [x, y] = [0; 2].map(|_| operand(b, &mut dice));
                b.compute(dice.of(&[Op::AddF32, Op::SubF32, Op::MulF32]), &[x, y])
            }
            (width, _) => {
                let [x, y] = [0; 2].map(|_| operand(b, &mut dice));
                let op = match width {
                    Width::Byte => dice.of(&[Op::AddU8, Op::SubU8, Op::XorU64]),
                    Width::Word => dice.of(&[Op::AddU16, Op::SubU16, Op::MinI16, Op::OrU64]),
                    Width::DoubleWord => dice.of(&[Op::AddU32, Op::SubU32, Op::MaxI32, Op::AndU64]),
                    _ => dice.of(&[Op::AddU64, Op::SubU64, Op::XorU64]),
                };
                b.compute(op, &[x, y])
            }
        };
        b.store(place, width, value);
    }
}

fn get_from(b: &mut Builder, (place, width): (Place, Width)) -> Var {
    b.load(place, width, sieben_engine::ir::OnFault::SkipStatement)
}

/// Something that holds or not.
fn condition(b: &mut Builder, dice: &mut Dice) -> Var {
    let number = dice.roll(VARIABLES.into()) as u32;
    let condition = match dice.roll(4) {
        0 | 1 => get_from(b, (variable(Width::Bit, number), Width::Bit)),
        2 => {
            let (value, limit) = (get_from(b, (variable(Width::Word, number), Width::Word)), b.constant(dice.of(&[0, 1, 300])));
            b.compute(dice.of(&[Op::LtI16, Op::GeI16]), &[value, limit])
        }
        _ => {
            let (value, mask, zero) = (get_from(b, (variable(Width::Byte, number), Width::Byte)), b.constant(0x80), b.constant(0));
            let bit = b.compute(Op::AndU64, &[value, mask]);
            b.compute(Op::Equal, &[bit, zero])
        }
    };
    if dice.roll(3) == 0 { b.compute(Op::Not, &[condition]) } else { condition }
}

/// A statement from which somebody may jump into one of so many behind it; the number of the first of these.
fn enters(b: &mut Builder, dice: &mut Dice, first: u32, statements: u32) -> u32 {
    b.begin_statement();
    let condition = condition(b, dice);
    b.push(Inst::Branch { condition, to: Target(first + 1 + dice.roll(statements.into()) as u32) });
    first + 1
}

/// A CASE with constants in its branches, some of them in a wrong place now and then; the number of the statement behind it.
fn constants(b: &mut Builder, dice: &mut Dice, first: u32) -> u32 {
    let width = dice.of(&WIDTHS);
    let place = variable(width, dice.roll(VARIABLES.into()) as u32);
    let (branches, otherwise) = (1 + dice.roll(5) as u32, dice.roll(3) > 0);
    let statements = 2 * branches - 1 + if otherwise { 2 } else { 0 };
    let first = if dice.roll(6) == 0 { enters(b, dice, first, 2 + statements) } else { first };
    let end = first + 2 + statements;
    b.begin_statement();
    let selector = get_from(b, (variable(Width::Word, dice.roll(VARIABLES.into()) as u32), Width::Word));
    let mask = b.constant(dice.of(&[3, 7, 15, 0xFFFF]));
    let selector = b.compute(Op::AndU64, &[selector, mask]);
    let cases = 1 + dice.roll(14);
    let of_branch = |branch: u32| Target(first + 2 + 2 * branch);
    let targets: Vec<Target> = (0..cases).map(|_| of_branch(dice.roll(branches.into()) as u32)).collect();
    let table = b.table(&targets);
    let behind = if otherwise { of_branch(branches) } else { Target(end) };
    b.push(Inst::JumpTable { index: selector, first: table, count: cases as u32, otherwise: behind });
    b.begin_statement();
    b.push(Inst::Jump { to: Target(end) });
    let most = dice.of(&[2, 4, 200, 400, 30_000, 100_000, 1 << 31]);
    for statement in 0..statements {
        b.begin_statement();
        // Now and then a branch goes on with the next one.
        if statement % 2 == 1 && dice.roll(24) > 0 {
            b.push(Inst::Jump { to: Target(end) });
            continue;
        }
        let constant = if width == Width::Bit { dice.roll(2) } else { dice.roll(most) & (u64::MAX >> (64 - width.bits())) };
        let value = b.constant(constant);
        let elsewhere = dice.roll(20) == 0;
        b.store(if elsewhere { variable(width, dice.roll(VARIABLES.into()) as u32) } else { place }, width, value);
    }
    end
}

/// Assignments under conditions, one behind the other, from a statement on; the number of the one behind them.
fn choices(b: &mut Builder, dice: &mut Dice, mut first: u32) -> u32 {
    for _ in 0..1 + dice.roll(4) {
        if dice.roll(4) == 0 {
            first = constants(b, dice, first);
            continue;
        }
        let width = dice.of(&WIDTHS);
        let place = variable(width, dice.roll(VARIABLES.into()) as u32);
        let [yes, no] = [0; 2].map(|_| Assigned { seed: dice.roll(1 << 30) });
        let two = dice.roll(3) > 0;
        let other = if dice.roll(8) == 0 { variable(width, dice.roll(VARIABLES.into()) as u32) } else { place };
        // Somebody comes to one of the assignments, or to the jump between them, without a look at the condition.
        if two && dice.roll(6) == 0 {
            first = enters(b, dice, first, 4);
        }
        let behind = if dice.roll(16) == 0 { 5 } else { 4 };
        b.begin_statement();
        let condition = condition(b, dice);
        b.push(Inst::Branch { condition, to: Target(first + if two { 3 } else { 2 }) });
        yes.write(b, (place, width));
        if two {
            b.begin_statement();
            b.push(Inst::Jump { to: Target(first + behind) });
            no.write(b, (other, width));
        }
        first += if two { 4 } else { 2 };
    }
    first
}

fn fill(machine: &mut Machine, seed: u64) {
    let mut dice = Dice(seed);
    machine.budget = dice.of(&[1, 5, 20, 1_000, 100_000]);
    let special = dice.of(&[0, 2, 6]);
    for byte in machine.memory.area_mut(Area::BitMemory).iter_mut().take(COUNTER as usize) {
        *byte = if dice.roll(8) < special { dice.of(&[0, 0xFF, 0x7F, 0x80]) } else { dice.roll(256) as u8 };
    }
}

#[test]
fn what_is_chosen_is_what_the_interpreter_writes() {
    let mut silent = 0;
    for seed in seeds(PROGRAMS) {
        let in_loop = seed % 2 == 0;
        let write = |b: &mut Builder| {
            let mut dice = Dice(seed);
            if in_loop {
                counted(b, COUNTER, 1 + dice.roll(12), |b| choices(b, &mut dice, 1));
            } else {
                choices(b, &mut dice, 0);
                b.begin_statement();
                b.push(Inst::Return);
            }
        };
        let program = program(&[(BlockId::ob(1), 16, &write)]);
        let prepare = |machine: &mut Machine, memory: u64| fill(machine, seed + 1_000_000 + (memory << 32));
        silent += all_engines_agree_from((&program, &noting::layout(&program)), MEMORIES, &prepare, &seed.to_string());
    }
    assert!(silent > 1_000, "{silent} runs in which nobody was asked");
}

/// Whether one of two assignments is chosen without a jump.
fn is_chosen([to, other]: [u32; 2], way_in: bool, statement_between: bool) -> bool {
    let write = |b: &mut Builder| {
        if way_in {
            b.begin_statement();
            let bit = get_from(b, (variable(Width::Bit, 1), Width::Bit));
            b.push(Inst::Branch { condition: bit, to: Target(4) });
        }
        let first = u32::from(way_in);
        b.begin_statement();
        let bit = get_from(b, (variable(Width::Bit, 0), Width::Bit));
        b.push(Inst::Branch { condition: bit, to: Target(first + 3 + u32::from(statement_between)) });
        for (number, byte) in [3, 5].into_iter().zip([to, other]) {
            b.begin_statement();
            let (value, added) = (get(b, 40, Width::DoubleWord), b.constant(number));
            let sum = b.compute(Op::AddU32, &[value, added]);
            b.store(fixed(byte), Width::DoubleWord, sum);
            if number == 3 {
                for _ in 0..u32::from(statement_between) {
                    b.begin_statement();
                    b.store(fixed(52), Width::DoubleWord, sum);
                }
                b.begin_statement();
                b.push(Inst::Jump { to: Target(first + 4 + u32::from(statement_between)) });
            }
        }
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), 16, &write)]);
    let listing = Jit::listing(&program, &noting::layout(&program)).expect("machine code");
    listing.lines().any(|line| line.contains(" = select"))
}

#[test]
fn one_of_two_assignments_to_a_variable_is_chosen_without_a_jump() {
    assert!(is_chosen([44, 44], false, false));
    assert!(!is_chosen([44, 48], false, false), "they write two variables");
    assert!(!is_chosen([44, 44], true, false), "the second one is entered from elsewhere");
    assert!(!is_chosen([44, 44], false, true), "there is more than one assignment");
}

#[test]
fn a_table_may_lead_to_the_end_of_a_block() {
    let write = |b: &mut Builder| {
        b.begin_statement();
        let selector = get(b, 40, Width::Byte);
        let table = b.table(&[Target(2), Target(1)]);
        b.push(Inst::JumpTable { index: selector, first: table, count: 2, otherwise: Target(2) });
        b.begin_statement();
        let value = b.constant(7);
        b.store(fixed(44), Width::Byte, value);
    };
    let program = program(&[(BlockId::ob(1), 16, &write)]);
    let prepare = |machine: &mut Machine, memory: u64| machine.memory.area_mut(Area::BitMemory)[40] = memory as u8;
    all_engines_agree_from((&program, &noting::layout(&program)), 4, &prepare, "the end");
}
