//! Functions that get texts of their callers through pointers, where each text says itself how much room it has: in local data, where
//! pointers and other texts lie behind it, machine code knows what it says until something else is written there.

use std::sync::Arc;

use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, TextAction, TextRoom, Var};
use sieben_engine::numbers_in_texts::{NumberForm, NumberKind, Spelling};
use sieben_engine::{Engine, Entry, Machine, Reaction};
use sieben_jit::Jit;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree, engines, layout, program, run};

const PROGRAMS: u64 = 120;
/// Local data of the caller, before which its texts lie, and of the function.
const CALLER_LOCAL: u32 = 120;
const OWN_LOCAL: u32 = 60;
/// Where the pointers to texts lie in the local data of the caller: some texts reach that far.
const POINTERS: [u32; 2] = [64, 72];
const CALLS: u32 = 3;
/// Bit memory behind the results.
const SUM: u32 = 40;
const COUNTER: u32 = 50;

fn local(byte: u32) -> Place {
    Place::Fixed { area: Area::Local, position: 8 * byte }
}

fn memory(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// Calls a function some times, with pointers to texts of its own, or anywhere. Some calls are given the pointers of the one before, which
/// a text may have become, and some are in a loop.
fn caller(b: &mut Builder, dice: &mut Dice) {
    let loops = dice.roll(2) == 0;
    let begin = b.next();
    for call in 0..CALLS {
        b.begin_statement();
        for at in POINTERS {
            if call > 0 && dice.roll(2) == 0 {
                continue;
            }
            let begin = dice.of(&[0, 10, 20, 24, 40, 50, 56]);
            let (number, code) = match dice.roll(6) {
                0 => (1, 0x8400_0000),
                1 => (0, 0x8300_0000 + 8 * 60),
                _ => (0, 0x8700_0000),
            };
            if dice.roll(4) > 0 {
                let most = dice.of(&[0, 4, 8, 12, 16, 18, 30]);
                let head = b.constant(most << 8 | dice.roll(most + 2));
                b.store(local(begin), Width::Word, head);
            }
            let [number, pointer] = [number, code + 8 * u64::from(begin)].map(|number| b.constant(number));
            b.store(local(at), Width::Word, number);
            b.store(local(at + 2), Width::DoubleWord, pointer);
        }
        for at in POINTERS {
            let pointer = b.constant(0x8700_0000 + 8 * u64::from(at));
            b.push(Inst::PassParameter { src: pointer });
        }
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 2 });
        b.begin_statement();
        let sum = b.load(memory(SUM), Width::Word, OnFault::SkipStatement);
        let head = b.load(local(POINTERS[0] + 4), Width::Word, OnFault::SkipStatement);
        let sum = b.compute(Op::AddU16, &[sum, head]);
        b.store(memory(SUM), Width::Word, sum);
    }
    if loops {
        b.begin_statement();
        let counter = b.load(memory(COUNTER), Width::Word, OnFault::SkipStatement);
        let one = b.constant(1);
        let counter = b.compute(Op::AddU16, &[counter, one]);
        b.store(memory(COUNTER), Width::Word, counter);
        let last = b.constant(3);
        let condition = b.compute(Op::LtI16, &[counter, last]);
        b.push(Inst::Branch { condition, to: begin });
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// A function between the caller and the other one: it hands on what it was given, or texts of its own.
fn between(b: &mut Builder, dice: &mut Dice) {
    for _ in 0..2 {
        b.begin_statement();
        for (index, at) in (0..).zip(POINTERS) {
            let own = dice.roll(2) == 0;
            let (number, pointer) = match own {
                true => {
                    let head = b.constant(0x0C04);
                    b.store(local(14 * u32::from(index)), Width::Word, head);
                    (b.constant(0), b.constant(0x8700_0000 + 8 * 14 * u64::from(index)))
                }
                false => {
                    let parameter = b.temporary();
                    b.push(Inst::Parameter { dst: parameter, index });
                    let number = b.load(Place::Crossing { pointer: parameter, offset: 0 }, Width::Word, OnFault::SkipStatement);
                    let pointer = b.load(Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord, OnFault::SkipStatement);
                    (number, pointer)
                }
            };
            b.store(local(at), Width::Word, number);
            b.store(local(at + 2), Width::DoubleWord, pointer);
        }
        for at in POINTERS {
            let pointer = b.constant(0x8700_0000 + 8 * u64::from(at));
            b.push(Inst::PassParameter { src: pointer });
        }
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(2)), parameters: 2 });
        b.begin_statement();
        let [to, from] = [0, 1].map(|index| Place::Crossing { pointer: handed_on(b, index), offset: 0 });
        let nothing = b.constant(0);
        let dst = b.temporary();
        let room = TextRoom::narrow(0);
        b.push(Inst::Text { action: TextAction::Assign, dst, to, to_room: room, from, from_room: room, piece: [nothing; 2] });
        b.store(memory(SUM + 4), Width::DoubleWord, dst);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// The pointer of a parameter.
fn handed_on(b: &mut Builder, index: u16) -> Var {
    let parameter = b.temporary();
    b.push(Inst::Parameter { dst: parameter, index });
    let number = b.load(Place::Crossing { pointer: parameter, offset: 0 }, Width::Word, OnFault::SkipStatement);
    let pointer = b.load(Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord, OnFault::SkipStatement);
    let half = b.constant(32);
    let number = b.compute(Op::Shl64, &[number, half]);
    b.compute(Op::OrU64, &[number, pointer])
}

fn text(b: &mut Builder, dice: &mut Dice) -> (Place, TextRoom) {
    let room = if dice.roll(3) == 0 { dice.of(&[1, 8, 16, 18, 30]) } else { 0 };
    let place = match dice.roll(5) {
        0 => local(dice.of(&[4, 30])),
        index => Place::Crossing { pointer: handed_on(b, (index % 2) as u16), offset: 0 },
    };
    (place, TextRoom::narrow(room))
}

fn function(b: &mut Builder, dice: &mut Dice) {
    b.begin_statement();
    let literal = b.constant(0x0202_2C31);
    b.store(local(4), Width::DoubleWord, literal);
    let texts_only = dice.roll(2) == 0;
    for statement in 0..5 {
        b.begin_statement();
        if !texts_only && dice.roll(4) == 0 {
            // Some of what a text says itself is written otherwise.
            let pointer = handed_on(b, dice.roll(2) as u16);
            let value = b.constant(dice.of(&[0, 3, 9, 17, 40]));
            let width = dice.of(&[Width::Bit, Width::Byte, Width::Word]);
            b.store(Place::Crossing { pointer, offset: 8 * dice.roll(3) as u32 }, width, value);
        }
        let mut actions = TextAction::ALL.to_vec();
        actions.retain(|action| !matches!(action, TextAction::Real | TextAction::LongReal | TextAction::RealS7));
        let action = dice.of(&actions);
        let [(to, to_room), (from, from_room)] = [(); 2].map(|()| text(b, dice));
        let (to_room, first) = match action {
            TextAction::Number => (TextRoom::NUMBER, NumberForm { spelling: Spelling::Literal, kind: NumberKind::I32 }.word()),
            _ => (to_room, dice.of(&[0, 1, 2, 5, 12_345])),
        };
        let piece = [first, dice.of(&[1, 3, 0x7FFF_FFFF])].map(|number| b.constant(number));
        let dst = b.temporary();
        b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece });
        b.store(memory(4 * statement), Width::DoubleWord, dst);
    }
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn texts_of_callers_are_the_same_on_all_engines() {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    for seed in seeds(PROGRAMS) {
        let calls = |b: &mut Builder| caller(b, &mut Dice(seed));
        let body = |b: &mut Builder| function(b, &mut Dice(seed + PROGRAMS));
        let middle = |b: &mut Builder| between(b, &mut Dice(seed + 2 * PROGRAMS));
        // In some programs another function is in between.
        let has_middle = seed % 3 == 0;
        let first = |b: &mut Builder| if has_middle { middle(b) } else { body(b) };
        let blocks = [
            (BlockId::ob(1), CALLER_LOCAL, &calls as &dyn Fn(&mut Builder)),
            (BlockId::fc(1), if has_middle { CALLER_LOCAL } else { OWN_LOCAL }, &first),
            (BlockId::fc(2), OWN_LOCAL, &body),
        ];
        let program = program(&blocks);
        let layout = layout(&program);
        let engines = engines(&program, &layout);
        for memory in 0..3 {
            let outcome = |engine: Arc<dyn Engine>| {
                let prepare = |machine: &mut Machine| {
                    machine.budget = 200;
                    let mut dice = Dice(3 * seed + memory);
                    let starts = [machine.memory.layout.local.start, machine.memory.layout.bit_memory.start, layout.data_blocks[&1].start];
                    for (start, bytes) in starts.into_iter().zip([320, 200, 16]) {
                        for byte in &mut machine.memory.arena[start..start + bytes] {
                            *byte = if dice.roll(2) == 0 { dice.roll(20) as u8 } else { b'0' + dice.roll(4) as u8 };
                        }
                    }
                    machine.memory.area_mut(Area::BitMemory)[COUNTER as usize..][..2].fill(0);
                };
                run(engine.as_ref(), &layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
            };
            let code = &program.code;
            let what = || format!("program {seed}, memory {memory}\n{}\n{}", code[&BlockId::ob(1)].code, code[&BlockId::fc(1)].code);
            all_engines_agree(&engines, false, &outcome, &what);
        }
    }
}

/// A result behind which the pointers lie: where it says how much room it has, writing it leaves the pointers known.
#[test]
fn pointers_behind_a_result_stay_known() {
    let calls = |b: &mut Builder| {
        b.begin_statement();
        let head = b.constant(0x1000);
        b.store(local(0), Width::Word, head);
        for (at, begin) in POINTERS.map(|at| at - 44).into_iter().zip([0, 40]) {
            let [number, pointer] = [0, 0x8700_0000 + 8 * begin].map(|number| b.constant(number));
            b.store(local(at), Width::Word, number);
            b.store(local(at + 2), Width::DoubleWord, pointer);
        }
        for at in POINTERS.map(|at| at - 44) {
            let pointer = b.constant(0x8700_0000 + 8 * u64::from(at));
            b.push(Inst::PassParameter { src: pointer });
        }
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 2 });
        b.begin_statement();
        b.push(Inst::Return);
    };
    let body = |b: &mut Builder| {
        for _ in 0..3 {
            b.begin_statement();
            let [to, from] = [0, 1].map(|index| Place::Crossing { pointer: handed_on(b, index), offset: 0 });
            let [first, count] = [1, 5].map(|number| b.constant(number));
            let dst = b.temporary();
            let room = TextRoom::narrow(0);
            b.push(Inst::Text {
                action: TextAction::Piece,
                dst,
                to,
                to_room: room,
                from,
                from_room: TextRoom::narrow(20),
                piece: [first, count],
            });
        }
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), CALLER_LOCAL, &calls), (BlockId::fc(1), 16, &body)]);
    let listing = Jit::listing(&program, &layout(&program)).expect("machine code");
    assert!(!listing.contains("(i64, i64, i64, i64, i64, i64) -> i64 system_v"), "{listing}");
}
