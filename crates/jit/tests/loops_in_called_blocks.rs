//! Loops that call a function with a loop in it, which reaches elements behind pointers that it is given: iterations of both together do on
//! all engines what the interpreter does, wherever the pointers lead and whatever a Host does that is asked.

use std::sync::Arc;

use sieben_engine::fault::NOTED;
use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{CodeBlock, Engine, Entry, FaultPlace, Layout, Machine, Program, Reaction, StopReason};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, all_engines_agree, engines, layout_with, run_beside};

/// Programs that are compared.
const PROGRAMS: u64 = 200;
/// Questions after which the Host stops a run.
const QUESTIONS_MAX: usize = 30;
/// In the local data of the caller: numbers of data blocks and pointers, of two arrays, then an index, and the result.
const ARRAYS: [u32; 2] = [0, 48];
const INDEX: u32 = 96;
const RESULT: u32 = 112;
const CALLER_BYTES: u32 = 24;
/// In that of the function: the counter of its loop, what it adds up, and a number.
const COUNTER: u32 = 0;
const SUM: u32 = 16;
const OWN: u32 = 48;
const FUNCTION_BYTES: u32 = 12;
/// The counter of the caller in bit memory, and results behind it.
const TURN: u32 = 8 * 40;
const LEFT: u32 = 8 * 44;
const DATA_BYTES: usize = 1_600;
/// Elements of a row, bytes of an element, and the first byte of the array that the caller writes.
const ROW: u64 = 8;
const BYTES: u64 = 4;
const RESULTS: u32 = 8 * 1_200;
/// A pointer to the local data of the caller.
const TO_LOCAL: u64 = 0x8700_0000;

fn local(position: u32) -> Place {
    Place::Fixed { area: Area::Local, position }
}

fn memory(position: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position }
}

fn load(b: &mut Builder, place: Place, width: Width) -> Var {
    b.load(place, width, OnFault::SkipStatement)
}

fn parameter(b: &mut Builder, index: u16) -> Var {
    let dst = b.temporary();
    b.push(Inst::Parameter { dst, index });
    dst
}

/// How an index is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Looks {
    No,
    Noted(u64),
    Fails(u64),
}

/// What makes up the loop of the function.
#[derive(Clone, Copy, Debug)]
struct Shape {
    first: u64,
    step: u64,
    last: u64,
    row: Looks,
    column: Looks,
}

impl Shape {
    const PLAIN: Self = Self { first: 0, step: 1, last: 7, row: Looks::Noted(8), column: Looks::No };

    fn random(dice: &mut Dice) -> Self {
        let limits = [6, 8, 8, 8, 16];
        let looks = |dice: &mut Dice| match dice.roll(4) {
            0 => Looks::Fails(dice.of(&limits)),
            1 | 2 => Looks::Noted(dice.of(&limits)),
            _ => Looks::No,
        };
        let column = looks(dice);
        let row = if dice.roll(3) == 0 { looks(dice) } else { Looks::Noted(dice.of(&limits)) };
        Self { first: dice.of(&[0, 0, 0, 1, 3]), step: dice.of(&[1, 1, 1, 2, 4]), last: dice.of(&[1, 5, 7, 7, 7, 9]), row, column }
    }
}

fn index(b: &mut Builder, place: Place, looks: Looks) -> Var {
    let number = load(b, place, Width::Word);
    let number = b.compute(Op::Extend16, &[number]);
    let (Looks::Noted(limit) | Looks::Fails(limit)) = looks else { return number };
    let limit = b.constant(limit);
    let inside = b.compute(Op::Below, &[number, limit]);
    let noted = if matches!(looks, Looks::Noted(_)) { NOTED } else { 0 };
    b.push(Inst::Require { condition: inside, code: noted | 0x22, register: number });
    b.compute(Op::Gate, &[number, inside])
}

/// An element of an array that the function was given: the place in the row that it was told, or in the row that it counts.
fn element(b: &mut Builder, shape: Shape, array: u16, is_transposed: bool) -> Place {
    let pointer = parameter(b, 2);
    let row = index(b, Place::Crossing { pointer, offset: 0 }, shape.row);
    let column = index(b, local(COUNTER), shape.column);
    let (row, column) = if is_transposed { (column, row) } else { (row, column) };
    let bits = b.constant(8 * ROW * BYTES);
    let row = b.compute(Op::MulU32, &[row, bits]);
    let bits = b.constant(8 * BYTES);
    let column = b.compute(Op::MulU32, &[column, bits]);
    let by = b.compute(Op::AddU32, &[row, column]);
    let given = parameter(b, array);
    let number = load(b, Place::Crossing { pointer: given, offset: 0 }, Width::Word);
    let pointer = load(b, Place::Crossing { pointer: given, offset: 16 }, Width::DoubleWord);
    let pointer = b.compute(Op::AddU32, &[pointer, by]);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    Place::Crossing { pointer, offset: 0 }
}

fn adds_product(b: &mut Builder, shape: Shape) {
    let sum = load(b, local(SUM), Width::DoubleWord);
    let first = element(b, shape, 0, true);
    let first = load(b, first, Width::DoubleWord);
    let second = element(b, shape, 1, true);
    let second = load(b, second, Width::DoubleWord);
    let product = b.compute(Op::MulF32, &[first, second]);
    let sum = b.compute(Op::AddF32, &[sum, product]);
    b.store(local(SUM), Width::DoubleWord, sum);
}

/// A statement of the loop.
fn statement(b: &mut Builder, dice: &mut Dice, shape: Shape) {
    match dice.roll(16) {
        0 => {
            let sum = load(b, local(SUM), Width::DoubleWord);
            let to = element(b, shape, dice.roll(2) as u16, dice.roll(2) == 0);
            b.store(to, Width::DoubleWord, sum);
        }
        1 => {
            let from = element(b, shape, dice.roll(2) as u16, dice.roll(2) == 0);
            let value = load(b, from, Width::DoubleWord);
            b.store(local(OWN), Width::DoubleWord, value);
        }
        // Its own number is read with another width, bit by bit, or written so.
        2 => {
            let (offset, width) = dice.of(&[(0, Width::Word), (16, Width::Word), (3, Width::Bit), (31, Width::Bit), (8, Width::Byte)]);
            let part = load(b, local(OWN + offset), width);
            let sum = load(b, local(SUM), Width::DoubleWord);
            let value = b.compute(Op::AddU32, &[sum, part]);
            b.store(local(SUM), Width::DoubleWord, value);
        }
        3 => {
            let (offset, width) = dice.of(&[(0, Width::Word), (16, Width::Word), (8, Width::Byte)]);
            let value = load(b, local(COUNTER), Width::Word);
            b.store(local(OWN + offset), width, value);
        }
        // Pointers that it was given may be others in the next iteration.
        4 if dice.roll(3) == 0 => {
            let given = parameter(b, dice.roll(2) as u16);
            let pointer = load(b, Place::Crossing { pointer: given, offset: 16 }, Width::DoubleWord);
            let step = b.constant(32);
            let moved = b.compute(Op::AddU32, &[pointer, step]);
            b.store(Place::Crossing { pointer: given, offset: 16 }, Width::DoubleWord, moved);
        }
        5 => {
            let (value, own) = (load(b, local(COUNTER), Width::Word), load(b, memory(LEFT + 32), Width::DoubleWord));
            let value = b.compute(Op::AddU32, &[value, own]);
            b.store(memory(LEFT + 32), Width::DoubleWord, value);
        }
        6 => {
            let (sum, own) = (load(b, local(SUM), Width::DoubleWord), load(b, local(OWN), Width::DoubleWord));
            let sum = b.compute(dice.of(&[Op::AddF32, Op::AddU32, Op::MaxF32]), &[sum, own]);
            b.store(local(SUM), Width::DoubleWord, sum);
        }
        _ => adds_product(b, shape),
    }
}

fn function(b: &mut Builder, shape: Shape, body: &mut dyn FnMut(&mut Builder, u32) -> u32) {
    b.begin_statement();
    let zero = b.constant(0);
    b.store(local(SUM), Width::DoubleWord, zero);
    b.store(local(OWN), Width::DoubleWord, zero);
    b.begin_statement();
    let first = b.constant(shape.first);
    b.store(local(COUNTER), Width::Word, first);
    body(b, 2);
    b.begin_statement();
    let (counter, step) = (load(b, local(COUNTER), Width::Word), b.constant(shape.step));
    let next = b.compute(Op::AddU16, &[counter, step]);
    b.store(local(COUNTER), Width::Word, next);
    let last = b.constant(shape.last);
    let again = b.compute(Op::LeI16, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(2) });
    b.begin_statement();
    let sum = load(b, local(SUM), Width::DoubleWord);
    let result = parameter(b, 3);
    b.store(Place::Crossing { pointer: result, offset: 0 }, Width::DoubleWord, sum);
}

/// Statements of the loop, of which some are jumped over now and then.
fn random_body(b: &mut Builder, dice: &mut Dice, shape: Shape, mut statements: u32) -> u32 {
    for _ in 0..1 + dice.roll(3) {
        if dice.roll(3) == 0 {
            b.begin_statement();
            let (counter, number) = (load(b, local(COUNTER), Width::Word), b.constant(dice.roll(4)));
            let condition = b.compute(dice.of(&[Op::LtI16, Op::EqI16, Op::GtI16]), &[counter, number]);
            statements += 1;
            b.push(Inst::Branch { condition, to: Target(statements + 1) });
        }
        b.begin_statement();
        statement(b, dice, shape);
        statements += 1;
    }
    statements
}

/// Where the arrays lie that the caller hands on, and in how many iterations.
#[derive(Clone, Copy, Debug)]
struct Handed {
    pointers: [u64; 2],
    first: u64,
    iterations: u64,
    /// How many iterations call, of which the others jump over that.
    calls_from: u64,
}

impl Handed {
    const PLAIN: Self = Self { pointers: [0x8400_0000, 0x8400_0000 + 8 * 512], first: 0, iterations: 8, calls_from: 0 };

    fn random(dice: &mut Dice) -> Self {
        let near_counter = 0x8300_0000 | u64::from(TURN - 32);
        let pointers =
            [0x8400_0000, 0x8400_0000, 0x8400_0000 + 8 * 512, 0x8400_0000 + 8 * 40, 0x8400_0000 + 8 * 1_100, near_counter, TO_LOCAL];
        let pointers = [dice.of(&pointers), dice.of(&pointers)];
        Self { pointers, first: dice.of(&[0, 0, 0, 2]), iterations: dice.of(&[3, 8, 8, 8, 9, 12]), calls_from: dice.of(&[0, 0, 0, 3]) }
    }
}

fn caller(b: &mut Builder, handed: Handed) {
    b.begin_statement();
    for register in [DataRegister::Shared, DataRegister::Instance] {
        let number = b.constant(1);
        b.push(Inst::Open { register, number });
    }
    let first = b.constant(handed.first);
    b.store(memory(TURN), Width::Word, first);
    b.begin_statement();
    let (iteration, least) = (load(b, memory(TURN), Width::Word), b.constant(handed.calls_from));
    let early = b.compute(Op::LtI16, &[iteration, least]);
    if handed.calls_from > 0 {
        b.push(Inst::Branch { condition: early, to: Target(3) });
    }
    b.begin_statement();
    for (array, pointer) in ARRAYS.into_iter().zip(handed.pointers) {
        let (number, pointer) = (b.constant(1), b.constant(pointer));
        b.store(local(array), Width::Word, number);
        b.store(local(array + 16), Width::DoubleWord, pointer);
    }
    let iteration = load(b, memory(TURN), Width::Word);
    b.store(local(INDEX), Width::Word, iteration);
    for position in [ARRAYS[0], ARRAYS[1], INDEX, RESULT] {
        let pointer = b.constant(0x8700_0000 | u64::from(position));
        b.push(Inst::PassParameter { src: pointer });
    }
    b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 4 });
    let result = load(b, local(RESULT), Width::DoubleWord);
    let iteration = load(b, memory(TURN), Width::Word);
    let iteration = b.compute(Op::Extend16, &[iteration]);
    let bits = b.constant(8 * BYTES);
    let pointer = b.compute(Op::MulU32, &[iteration, bits]);
    b.store(Place::Indirect { area: Area::SharedData, pointer, offset: RESULTS }, Width::DoubleWord, result);
    b.begin_statement();
    let (iteration, one) = (load(b, memory(TURN), Width::Word), b.constant(1));
    let next = b.compute(Op::AddU16, &[iteration, one]);
    b.store(memory(TURN), Width::Word, next);
    let last = b.constant(handed.iterations - 1);
    let again = b.compute(Op::LeI16, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(1) });
    b.begin_statement();
    b.push(Inst::Return);
}

/// A program in which nobody reads what was left in local data, or somebody may.
fn whole(handed: Handed, forgets: bool, function: &dyn Fn(&mut Builder)) -> (Program, Layout) {
    let main = |b: &mut Builder| caller(b, handed);
    let mut program = noting::program(&[(BlockId::ob(1), CALLER_BYTES, &main), (BlockId::fc(1), FUNCTION_BYTES, function)]);
    if forgets {
        let handed = [ARRAYS[0]..ARRAYS[0] + 48, ARRAYS[1]..ARRAYS[1] + 48, INDEX..INDEX + 16, RESULT..RESULT + 32];
        for (id, block) in &mut program.code {
            *block = CodeBlock { reads_own_locals: true, ..std::mem::take(block) };
            if *id == BlockId::ob(1) {
                block.handed = handed.to_vec();
            }
        }
    }
    let layout = layout_with(&program, DATA_BYTES);
    (program, layout)
}

fn agree(seed: u64, (program, layout): (&Program, &Layout), forgets: bool, what: &str) -> usize {
    let prepare = |machine: &mut Machine| {
        let mut dice = Dice(seed + 1_000_000);
        machine.budget = dice.of(&[1, 40, 1_000, 100_000, 100_000]);
        machine.memory.area_mut(Area::BitMemory)[..128].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
        let range = machine.memory.layout.data_blocks[&1].clone();
        machine.memory.arena[range].iter_mut().for_each(|byte| *byte = dice.of(&[0, 0x3F, 0x40, 0x80, 0xFF, 1, 0xC0]));
    };
    let meddle = |machine: &mut Machine, what: &str, dice: &mut Dice, asked: usize| {
        if asked >= QUESTIONS_MAX {
            return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
        }
        if noting::is_noted(what) {
            return Reaction::Continue;
        }
        machine.budget = dice.of(&[0, 3, 17, 100, 1_000, 100_000]);
        if dice.roll(4) == 0 {
            machine.memory.area_mut(Area::BitMemory)[(TURN / 8 + 1) as usize] = dice.of(&[0, 1, 7, 0xFF]);
        }
        Reaction::Continue
    };
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let outcome = |engine: Arc<dyn Engine>| {
        let mut outcome = run_beside(engine.as_ref(), layout, &entry, &prepare, Dice(seed + 2_000_000), &meddle);
        if forgets {
            outcome.arena[layout.local.clone()].fill(0);
        }
        outcome
    };
    let listing = || program.code.iter().map(|(id, block)| format!("{id}\n{}", block.code)).collect::<String>();
    all_engines_agree(&engines(program, layout), true, &outcome, &|| format!("{what}\n{}", listing())).asked.len()
}

/// Whether iterations of the caller are done side by side, with the loop of the function in them: a sum of REALs follows its order
/// otherwise.
fn are_side_by_side(program: &Program, layout: &Layout) -> bool {
    Jit::listing(program, layout).expect("machine code").contains("f32x4")
}

#[test]
fn loops_in_called_blocks_do_what_the_interpreter_does() {
    let (mut asked, mut beside) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let mut dice = Dice(seed);
        let (shape, mut handed, forgets) = (Shape::random(&mut dice), Handed::random(&mut dice), dice.roll(2) == 0);
        if forgets {
            // What is handed on leads no further than to its end.
            handed.pointers = handed.pointers.map(|pointer| if pointer == TO_LOCAL { 0x8400_0000 } else { pointer });
        }
        let first = dice.roll(1 << 30);
        let body = |b: &mut Builder| {
            let mut dice = Dice(first);
            function(b, shape, &mut |b, statements| random_body(b, &mut dice, shape, statements));
        };
        let (program, layout) = whole(handed, forgets, &body);
        beside += usize::from(are_side_by_side(&program, &layout));
        asked += agree(seed, (&program, &layout), forgets, &format!("{seed} {forgets} {shape:?} {handed:?}"));
    }
    assert!(asked > 250 && beside > 10, "{asked} questions, {beside} programs side by side");
}

/// Whether iterations are side by side where the loop of the function does one thing; both engines agree whether or not.
fn one(shape: Shape, handed: Handed, forgets: bool, statement: &dyn Fn(&mut Builder)) -> bool {
    let body = |b: &mut Builder| {
        function(b, shape, &mut |b, statements| {
            b.begin_statement();
            statement(b);
            statements + 1
        });
    };
    let (program, layout) = whole(handed, forgets, &body);
    for seed in 0..4 {
        agree(seed, (&program, &layout), forgets, &format!("{forgets} {shape:?} {handed:?}"));
    }
    are_side_by_side(&program, &layout)
}

#[test]
fn iterations_with_a_loop_in_a_called_block_are_done_side_by_side() {
    for forgets in [false, true] {
        let is_beside = |shape: Shape, handed: Handed| one(shape, handed, forgets, &|b| adds_product(b, shape));
        assert!(is_beside(Shape::PLAIN, Handed::PLAIN), "{forgets}");
        let row = |row: Looks| Shape { row, ..Shape::PLAIN };
        let column = |first: u64, step: u64, last: u64, column: Looks| Shape { first, step, last, column, ..Shape::PLAIN };
        for looks in [Looks::Noted(8), Looks::Fails(8), Looks::Noted(6), Looks::Fails(6)] {
            assert!(is_beside(row(looks), Handed::PLAIN), "{looks:?}: some iterations are");
            for (first, step, last) in [(0, 1, 7), (1, 2, 7), (0, 4, 7)] {
                let (Looks::Noted(limit) | Looks::Fails(limit)) = looks else { continue };
                let greatest = first + (last - first) / step * step;
                assert_eq!(is_beside(column(first, step, last, looks), Handed::PLAIN), greatest < limit, "{looks:?} {first} {step} {last}");
            }
        }
        let over = Handed { pointers: [0x8400_0000, 0x8400_0000 + 8 * 1_100], ..Handed::PLAIN };
        assert!(!is_beside(Shape::PLAIN, over), "iterations read what others write");
    }
}

#[test]
fn what_a_block_writes_and_reads_with_another_width_is_no_other_variable() {
    for forgets in [false, true] {
        for (offset, width) in [(0, Width::Word), (16, Width::Word), (31, Width::Bit), (24, Width::Byte)] {
            let part = |b: &mut Builder| {
                let from = element(b, Shape::PLAIN, 0, false);
                let value = load(b, from, Width::DoubleWord);
                b.store(local(OWN), Width::DoubleWord, value);
                let (part, sum) = (load(b, local(OWN + offset), width), load(b, local(SUM), Width::DoubleWord));
                let sum = b.compute(Op::AddU32, &[sum, part]);
                b.store(local(SUM), Width::DoubleWord, sum);
            };
            one(Shape::PLAIN, Handed::PLAIN, forgets, &part);
            // So is what it was given.
            let given = |b: &mut Builder| {
                let pointer = parameter(b, 2);
                let part = load(
                    b,
                    Place::Crossing { pointer, offset: if width == Width::Bit { 15 } else { 8 } },
                    if width == Width::Bit { width } else { Width::Byte },
                );
                let sum = load(b, local(SUM), Width::DoubleWord);
                let sum = b.compute(Op::AddU32, &[sum, part]);
                b.store(local(SUM), Width::DoubleWord, sum);
            };
            one(Shape::PLAIN, Handed::PLAIN, forgets, &given);
        }
    }
}

#[test]
fn pointers_that_iterations_of_the_loop_in_a_block_write_are_followed_as_they_are() {
    for forgets in [false, true] {
        let moves = |b: &mut Builder| {
            adds_product(b, Shape::PLAIN);
            let given = parameter(b, 0);
            let pointer = load(b, Place::Crossing { pointer: given, offset: 16 }, Width::DoubleWord);
            let step = b.constant(32);
            let moved = b.compute(Op::AddU32, &[pointer, step]);
            b.store(Place::Crossing { pointer: given, offset: 16 }, Width::DoubleWord, moved);
        };
        one(Shape::PLAIN, Handed::PLAIN, forgets, &moves);
    }
}
