//! Loops over arrays, under a Host that changes their variables while they run: machine code that looks at no index any more does what
//! the interpreter does.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target, TextAction, TextRoom, Var};
use sieben_engine::{Entry, Exit, FaultPlace, Machine, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, layout, program, run_beside};

/// Programs that are compared.
const PROGRAMS: u64 = 300;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 60;

/// A variable.
#[derive(Clone, Copy)]
struct Variable {
    place: Place,
    width: Width,
}

/// An array of 16 elements or so.
#[derive(Clone, Copy)]
struct Array {
    area: Area,
    first: u32,
    /// Bits from one element to the next.
    step: u32,
    width: Width,
}

/// Bytes that belong to both: the data block has 16.
fn bytes_of(area: Area) -> u32 {
    if area == Area::SharedData { 16 } else { 48 }
}

fn place(dice: &mut Dice, area: Area) -> Place {
    Place::Fixed { area, position: 8 * dice.roll(u64::from(bytes_of(area)) / 2) as u32 }
}

fn variable(dice: &mut Dice) -> Variable {
    let area = dice.of(&[Area::BitMemory, Area::BitMemory, Area::Local, Area::SharedData]);
    Variable { place: place(dice, area), width: dice.of(&[Width::Word, Width::DoubleWord, Width::DoubleWord, Width::Byte]) }
}

fn array(dice: &mut Dice) -> Array {
    let area = dice.of(&[Area::BitMemory, Area::Local, Area::SharedData]);
    let width = dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::DoubleWord]);
    let step = width.bits() * dice.of(&[1, 1, 2, 3]);
    // A constant below the first byte, as an array whose lowest index is not 0 has it.
    let first = if dice.roll(4) == 0 { 0x0100_0000 - 8 * dice.roll(4) as u32 } else { 8 * dice.roll(24) as u32 };
    Array { area, first, step, width }
}

fn get(b: &mut Builder, variable: Variable) -> Var {
    b.load(variable.place, variable.width, OnFault::SkipStatement)
}

/// The index as an address would be computed from it, and whether it passed a gate.
fn element(b: &mut Builder, dice: &mut Dice, array: Array, index: Variable) -> (Place, Option<Var>) {
    // Now and then the same element all the time.
    let mut number = if dice.roll(10) == 0 { b.constant(dice.roll(8)) } else { get(b, index) };
    if index.width == Width::Word && dice.roll(2) == 0 {
        number = b.compute(Op::Extend16, &[number]);
    }
    if dice.roll(4) == 0 {
        let least = b.constant(dice.roll(4));
        number = b.compute(dice.of(&[Op::SubU32, Op::AddU32]), &[number, least]);
    }
    let mut gate = None;
    match dice.roll(7) {
        0 => {
            let count = b.constant(dice.roll(20));
            let inside = b.compute(Op::Below, &[number, count]);
            b.push(Inst::Require { condition: inside, code: 0x22, register: number });
        }
        1 | 2 => {
            let count = b.constant(dice.roll(20));
            let inside = b.compute(Op::Below, &[number, count]);
            if dice.roll(3) != 0 {
                b.push(Inst::Require { condition: inside, code: NOTED | 0x22, register: number });
            }
            number = b.compute(Op::Gate, &[number, inside]);
            gate = Some(inside);
        }
        3 => {
            let mask = b.constant(dice.of(&[7, 15, 31, 0xFF]));
            number = b.compute(Op::AndU32, &[number, mask]);
        }
        4 => {
            let most = b.constant(dice.roll(20));
            let least = b.constant(dice.roll(3));
            number = b.compute(Op::MaxI32, &[number, least]);
            number = b.compute(Op::MinI32, &[number, most]);
        }
        5 => {
            let by = b.constant(1 + dice.roll(20));
            number = b.compute(Op::RemI32, &[number, by]);
        }
        _ => {}
    }
    let step = b.constant(u64::from(array.step));
    let pointer = b.compute(Op::MulU32, &[number, step]);
    (Place::Indirect { area: array.area, pointer, offset: array.first }, gate)
}

/// A statement that works on elements, or copies bytes.
fn statement(b: &mut Builder, dice: &mut Dice, index: Variable, sum: Variable) {
    b.begin_statement();
    let from = array(dice);
    match dice.roll(6) {
        5 => text(b, dice, from, index, sum),
        0 | 1 => {
            let (place, gate) = element(b, dice, from, index);
            let mut value = b.load(place, from.width, OnFault::SkipStatement);
            if let Some(gate) = gate {
                value = b.compute(Op::Gate, &[value, gate]);
            }
            let before = get(b, sum);
            let after = b.compute(dice.of(&[Op::AddU32, Op::AddU16, Op::MulU16, Op::AddF32, Op::MulF32, Op::SubF32]), &[before, value]);
            b.store(sum.place, sum.width, after);
        }
        2 => {
            let (from_place, _) = element(b, dice, from, index);
            let to = array(dice);
            let (to_place, _) = element(b, dice, to, index);
            b.push(Inst::Move { from: from_place, to: to_place, bytes: dice.of(&[1, 2, 6, 13, 16, 20]) });
        }
        _ => {
            let (place, gate) = element(b, dice, from, index);
            let mut value = get(b, sum);
            if let Some(gate) = gate {
                let old = b.load(place, from.width, OnFault::SkipWrite);
                value = b.compute(Op::Select, &[gate, value, old]);
            }
            b.store(place, from.width, value);
        }
    }
}

/// Something that is done with texts, which may overlap one another and everything else.
fn text(b: &mut Builder, dice: &mut Dice, from: Array, index: Variable, sum: Variable) {
    let mut any = |b: &mut Builder| {
        let area = dice.of(&[Area::BitMemory, Area::Local, Area::SharedData]);
        match dice.roll(4) {
            0 => {
                let step = 8 * dice.of(&[1, 2, 5]);
                element(b, dice, Array { width: Width::Byte, step, ..from }, index).0
            }
            1 => {
                let number = dice.of(&[0, 1, 2]) << 32;
                let code = if area == Area::SharedData { 0x8400_0000 } else { u64::from(area.pointer_code()) << 24 };
                let pointer = b.constant(number | code | (8 * dice.roll(12)));
                Place::Crossing { pointer, offset: 8 * dice.roll(3) as u32 }
            }
            _ => place(dice, area),
        }
    };
    let (from, to) = (any(b), any(b));
    let first = get(b, sum);
    let small = b.constant(7);
    let first = b.compute(Op::AndU32, &[first, small]);
    let count = b.constant(dice.of(&[0, 1, 3, 20, 0xFFFF_FFFF, 0x7FFF_FFFF]));
    let dst = b.temporary();
    let (action, maxima) = (dice.of(&TextAction::ALL), [0, 1, 4, 6, 12]);
    let mut room = || TextRoom { characters_max: dice.of(&maxima), wide: dice.roll(3) == 0 };
    let (to_room, from_room) = (room(), room());
    let to_room = if action == TextAction::Number { TextRoom::NUMBER } else { to_room };
    b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece: [first, count] });
    b.store(sum.place, sum.width, dst);
}

/// An assignment that is jumped over if a variable is small.
fn assignment(b: &mut Builder, dice: &mut Dice, index: Variable, sum: Variable, statements: &mut u32) {
    let any = |dice: &mut Dice| match dice.roll(3) {
        0 => index,
        1 => sum,
        _ => variable(dice),
    };
    b.begin_statement();
    let value = if dice.roll(2) == 0 {
        get(b, any(dice))
    } else {
        let from = array(dice);
        let (place, gate) = element(b, dice, from, index);
        let value = b.load(place, from.width, OnFault::SkipStatement);
        gate.map_or(value, |gate| b.compute(Op::Gate, &[value, gate]))
    };
    let limit = b.constant(dice.of(&[0, 1, 5, 0x80, 0x4000_0000]));
    let condition = b.compute(dice.of(&[Op::LtI32, Op::Equal, Op::LeI16, Op::LtF32]), &[value, limit]);
    b.push(Inst::Branch { condition, to: Target(*statements + 2) });
    b.begin_statement();
    let to = any(dice);
    let bit = dice.roll(4) == 0;
    let (place, width) = match to.place {
        Place::Fixed { area, position } if bit => (Place::Fixed { area, position: position + dice.roll(8) as u32 }, Width::Bit),
        place => (place, to.width),
    };
    let mut value = get(b, any(dice));
    for _ in 0..dice.roll(3) {
        let other = get(b, any(dice));
        value = b.compute(
            dice.of(&[Op::AddU32, Op::SubU16, Op::AddF32, Op::MulF32, Op::MulU32, Op::And, Op::MinI32, Op::Shl32]),
            &[value, other],
        );
    }
    b.store(place, width, value);
    *statements += 2;
}

/// Whether a loop goes on: a comparison of its variable, also in other forms than the one that it has in memory.
fn goes_on(b: &mut Builder, dice: &mut Dice, index: Variable, next: Var) -> Var {
    let is_word = index.width == Width::Word;
    let limit = b.constant(dice.of(&[3, 7, 11, 15, 30]));
    let extended = if is_word { b.compute(Op::Extend16, &[next]) } else { next };
    match dice.roll(8) {
        0 => {
            let other = if is_word { b.compute(Op::Extend16, &[next]) } else { next };
            let square = b.compute(Op::MulU32, &[extended, other]);
            b.compute(dice.of(&[Op::LeI32, Op::LtI32]), &[square, limit])
        }
        1 => {
            let added = b.constant(1 + dice.roll(3));
            let moved = b.compute(dice.of(&[Op::AddU32, Op::SubU32]), &[extended, added]);
            b.compute(dice.of(&[Op::LeI32, Op::Below]), &[moved, limit])
        }
        2 => b.compute(Op::LtI32, &[extended, limit]),
        3 if is_word => {
            let added = b.constant(1 + dice.roll(3));
            let moved = b.compute(dice.of(&[Op::AddU16, Op::SubU16]), &[next, added]);
            b.compute(Op::LeI16, &[moved, limit])
        }
        _ => b.compute(if is_word { Op::LeI16 } else { Op::LeI32 }, &[next, limit]),
    }
}

/// A loop in the middle of others, counted by a variable of its own, which may begin and count with that of the loop around it.
fn counted(b: &mut Builder, dice: &mut Dice, depth: u32, statements: &mut u32, sum: Variable, around: Option<Variable>) {
    let index = variable(dice);
    b.begin_statement();
    let first = match around.filter(|_| dice.roll(2) == 0) {
        Some(around) => {
            let [a, other] = [(); 2].map(|()| get(b, around));
            b.compute(dice.of(&[Op::MulU16, Op::AddU16, Op::MulU32, Op::AddU32, Op::MinI32]), &[a, other])
        }
        None => b.constant(dice.of(&[0, 0, 1, 2, 5])),
    };
    b.store(index.place, index.width, first);
    *statements += 1;
    let head = *statements;
    for _ in 0..1 + dice.roll(2) {
        statement(b, dice, index, sum);
        *statements += 1;
        if dice.roll(2) == 0 {
            assignment(b, dice, index, sum, statements);
        }
    }
    if depth > 0 && dice.roll(2) == 0 {
        counted(b, dice, depth - 1, statements, sum, Some(index));
    }
    b.begin_statement();
    let value = get(b, index);
    let step = match around.filter(|_| dice.roll(3) == 0) {
        Some(around) => get(b, around),
        None => b.constant(dice.of(&[1, 1, 2, 3])),
    };
    let next = b.compute(if index.width == Width::Word { Op::AddU16 } else { Op::AddU32 }, &[value, step]);
    b.store(index.place, index.width, next);
    let goes_on = goes_on(b, dice, index, next);
    b.push(Inst::Branch { condition: goes_on, to: Target(head) });
    *statements += 1;
}

fn loops(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    let mut statements = 1;
    for _ in 0..dice.of(&[1, 2, 2, 5]) {
        let sum = variable(dice);
        counted(b, dice, 2, &mut statements, sum, None);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// Changes a few bytes, sometimes, and goes on; not where it is only told of a fault.
fn meddle(machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    if noting::is_noted(what) {
        return Reaction::Continue;
    }
    machine.budget = dice.of(&[0, 1, 1, 2, 5]);
    for _ in 0..dice.of(&[0, 0, 1, 1, 3]) {
        let value = dice.of(&[0, 1, 2, 7, 0x7F, 0x80, 0xFF]);
        if dice.roll(3) == 0 {
            let range = machine.memory.layout.data_blocks[&1].clone();
            machine.memory.arena[range.start + dice.roll(16) as usize] = value;
        } else {
            machine.memory.area_mut(Area::BitMemory)[dice.roll(48) as usize] = value;
        }
    }
    Reaction::Continue
}

#[test]
fn loops_whose_variables_somebody_changes_do_the_same_on_all_engines() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 48, &|b| loops(b, &mut Dice(seed)))]);
        let layout = layout(&program);
        let entry = Entry { block, start_information: [7; 20], registers: None };
        let prepare = |machine: &mut Machine| {
            let mut dice = Dice(seed + 1_000_000);
            machine.memory.area_mut(Area::BitMemory)[..48].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        };
        let outcome = |engine: Arc<dyn sieben_engine::Engine>| {
            run_beside(engine.as_ref(), &layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle)
        };
        let expected =
            all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{seed}\n{}", program.code[&block].code));
        asked += expected.asked.len();
        finished += usize::from(expected.exit == Exit::Finished);
    }
    assert!(asked > 2_500 && finished > 50, "{asked} questions, {finished} runs to the end");
}

/// Loops one after another over texts of two characters, the last of which is the one with this index; others end at the next of some limits.
fn loops_over_texts(b: &mut Builder, loops: u32, limits: &[u64], last: u64) {
    let place = |byte: u32| Place::Fixed { area: Area::BitMemory, position: 8 * byte };
    let mut statements = 0;
    for number in 0..loops {
        b.begin_statement();
        let zero = b.constant(0);
        b.store(place(0), Width::Word, zero);
        b.begin_statement();
        let index = b.load(place(0), Width::Word, OnFault::SkipStatement);
        let index = b.compute(Op::Extend16, &[index]);
        let step = b.constant(32);
        let pointer = b.compute(Op::MulU32, &[index, step]);
        let (to, room) = (Place::Indirect { area: Area::Local, pointer, offset: 16 }, TextRoom::narrow(2));
        let (dst, none) = (b.temporary(), b.constant(0));
        b.push(Inst::Text { action: TextAction::Length, dst, to, to_room: room, from: to, from_room: room, piece: [none; 2] });
        b.begin_statement();
        let index = b.load(place(0), Width::Word, OnFault::SkipStatement);
        let one = b.constant(1);
        let next = b.compute(Op::AddU16, &[index, one]);
        b.store(place(0), Width::Word, next);
        // The last loop goes as far as it is said.
        let most = if number + 1 == loops { last } else { limits[number as usize % limits.len()] };
        let most = b.constant(most);
        let goes_on = b.compute(Op::LeI16, &[next, most]);
        b.push(Inst::Branch { condition: goes_on, to: Target(statements + 1) });
        statements += 3;
    }
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn ranges_are_known_in_each_of_many_loops() {
    // What a question about a text looks like in a listing: it has six arguments.
    let asks = |size: u32, loops: u32, limits: &[u64], last: u64| {
        let program = program(&[(BlockId::ob(1), size, &|b| loops_over_texts(b, loops, limits, last))]);
        Jit::listing(&program, &layout(&program)).expect("machine code").contains("(i64, i64, i64, i64, i64, i64) -> i64 system_v")
    };
    let [few, many]: [Vec<u64>; 2] = [(0..8).collect(), (0..24).map(|limit| 3 * limit).collect()];
    for (size, loops, limits) in [
        (300, 1, &few),
        (300, 4, &few),
        (300, 12, &few),
        (48, 1, &few),
        (48, 4, &few),
        (48, 12, &few),
        (48, 60, &few),
        (300, 25, &many),
        (300, 60, &many),
    ] {
        let most = u64::from(size - 6) / 4;
        assert!(!asks(size, loops, limits, most), "{loops} loops");
        assert!(asks(size, loops, limits, most + 1), "{loops} loops, the last one to a text that is not there");
    }
}
