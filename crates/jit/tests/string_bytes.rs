//! Text instructions nobody wrote, on STRINGs of a few characters that say anything: machine code works on their characters side by side,
//! and leaves the same bytes, behind the texts too, as the interpreter.

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, TextAction, TextRoom, Var};
use sieben_engine::numbers_in_texts::{NumberForm, NumberKind, Spelling};
use sieben_engine::{Engine, Entry, Interpreter, Machine, Reaction};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{all_engines_agree_from, layout, program, run};

const PROGRAMS: u64 = 500;
/// Memories with which a program runs.
const MEMORIES: u64 = 12;
const STATEMENTS: u64 = 5;
/// Texts lie in so many bytes of bit memory or local data.
const BYTES: u64 = 100;
/// Local data of the block, of which the last ones are those of literals.
const LOCAL: u32 = 160;
const LITERAL: u32 = 120;
/// Bit memory before the texts: results and numbers.
const RESULTS: u32 = 0;
const COUNTER: u32 = 30;
const NUMBERS: u32 = 40;
const TEXTS: u32 = 80;

const KINDS: [NumberKind; 14] = [
    NumberKind::I8,
    NumberKind::I16,
    NumberKind::I32,
    NumberKind::I64,
    NumberKind::U8,
    NumberKind::U16,
    NumberKind::U32,
    NumberKind::U64,
    NumberKind::Bits8,
    NumberKind::Bits16,
    NumberKind::Bits32,
    NumberKind::Bits64,
    NumberKind::F32,
    NumberKind::F64,
];

fn at(area: Area, byte: u32) -> Place {
    Place::Fixed { area, position: 8 * byte }
}

/// Where a text lies and how much room it says that it has.
fn text(b: &mut Builder, dice: &mut Dice) -> (Place, TextRoom) {
    let room = dice.of(&[0, 1, 2, 3, 5, 7, 8, 10, 12, 15, 16, 17, 20, 24, 31, 32, 33, 40, 254]);
    let (area, byte) = match dice.roll(3) {
        0 => (Area::Local, dice.roll(BYTES) as u32),
        _ => (Area::BitMemory, TEXTS + dice.roll(BYTES) as u32),
    };
    // Some lie behind a pointer that is not known.
    if area == Area::BitMemory && dice.roll(8) == 0 {
        let index = b.load(at(Area::BitMemory, NUMBERS), Width::Byte, OnFault::SkipStatement);
        let [few, bits, begin] = [3, 8, 8 * u64::from(byte)].map(|number| b.constant(number));
        let index = b.compute(Op::AndU32, &[index, few]);
        let index = b.compute(Op::MulU32, &[index, bits]);
        let pointer = b.compute(Op::AddU32, &[index, begin]);
        return (Place::Indirect { area, pointer, offset: 0 }, TextRoom::narrow(room));
    }
    (at(area, byte), TextRoom::narrow(room))
}

/// The bytes of a literal in local data.
fn literal(b: &mut Builder, dice: &mut Dice) -> (Place, TextRoom) {
    let count = dice.roll(LOCAL as u64 - LITERAL as u64 - 1) as u32;
    let count = if dice.roll(2) == 0 { count % 10 } else { count };
    let bytes: Vec<u8> = [count as u8; 2].into_iter().chain((0..count).map(|_| character(dice))).collect();
    let mut byte = LITERAL;
    for piece in bytes.chunks(4).flat_map(|piece| if piece.len() == 3 { piece.chunks(2) } else { piece.chunks(4) }) {
        let number = piece.iter().fold(0, |number, &byte| number << 8 | u64::from(byte));
        let number = b.constant(number);
        let width = [Width::Byte, Width::Word, Width::DoubleWord, Width::DoubleWord][piece.len() - 1];
        b.store(at(Area::Local, byte), width, number);
        byte += piece.len() as u32;
    }
    (at(Area::Local, LITERAL), TextRoom::narrow(count as u8))
}

fn character(dice: &mut Dice) -> u8 {
    match dice.roll(20) {
        0 => dice.roll(256) as u8,
        1..4 => dice.of(b"+- _..#aAe"),
        4..10 => b'1',
        _ => b'0' + dice.roll(10) as u8,
    }
}

/// A number that a piece has, or of which the digits are written.
fn number(b: &mut Builder, dice: &mut Dice, action: TextAction) -> [Var; 2] {
    if action == TextAction::Number {
        let spelling = dice.of(&[Spelling::Literal, Spelling::Beginning, Spelling::S7]);
        let kind = if dice.roll(3) == 0 { NumberKind::I16 } else { dice.of(&KINDS) };
        let form = b.constant(NumberForm { spelling, kind }.word());
        return [form, form];
    }
    [(); 2].map(|()| match dice.roll(6) {
        5 => {
            let some = b.constant(dice.of(&[0, 1, 1, 2, 3, 8, 0xFFFF_FFFF]));
            let condition = b.load(at(Area::BitMemory, NUMBERS + 3), Width::Bit, OnFault::SkipStatement);
            b.compute(Op::Gate, &[some, condition])
        }
        0 => b.load(at(Area::BitMemory, NUMBERS + 8), Width::QuadWord, OnFault::SkipStatement),
        1 => b.constant(dice.of(&[0, 1, 5, 16, 0x7FFF_FFFF, 9_999_999, 10_000_000, u64::MAX, 1 << 63])),
        2 => {
            let wide = b.load(at(Area::BitMemory, NUMBERS), Width::DoubleWord, OnFault::SkipStatement);
            let zero = b.constant(0);
            b.compute(Op::AddI32Wide, &[wide, zero])
        }
        _ => {
            let word = b.load(at(Area::BitMemory, NUMBERS + 2), Width::Byte, OnFault::SkipStatement);
            let most = b.constant(31);
            b.compute(Op::AndU32, &[word, most])
        }
    })
}

fn statements(b: &mut Builder, dice: &mut Dice) {
    let mut actions = TextAction::ALL.to_vec();
    actions.retain(|action| !matches!(action, TextAction::Real | TextAction::LongReal | TextAction::RealS7));
    // In some programs all of it is a loop of a few iterations.
    let loops = dice.roll(3) == 0;
    let begin = b.next();
    // The text that was written last, if its place is known: mostly it is looked at again.
    let mut last: Option<(Place, TextRoom)> = None;
    for statement in 0..STATEMENTS {
        b.begin_statement();
        if dice.roll(2) == 0 {
            something_else(b, dice, last.map(|(place, _)| place));
        }
        let action = match dice.roll(4) {
            0 => TextAction::Piece,
            1 if last.is_some() => dice.of(&[TextAction::Compare, TextAction::Find]),
            _ => dice.of(&actions),
        };
        let (mut to, mut to_room) = text(b, dice);
        let (mut from, mut from_room) = match last {
            // Some say themselves how much room they have.
            Some((place, _)) if dice.roll(8) == 0 => (place, TextRoom::narrow(0)),
            Some(last) if dice.roll(2) == 0 => last,
            _ if dice.roll(3) == 0 => literal(b, dice),
            _ => text(b, dice),
        };
        if matches!(action, TextAction::Find | TextAction::Compare) && dice.roll(2) == 0 {
            // Characters of a text in a literal.
            ((to, to_room), (from, from_room)) = ((from, from_room), (to, to_room));
        }
        if dice.roll(10) == 0 {
            // A text that becomes a piece of itself, or grows by one.
            (to, to_room) = (from, from_room);
        }
        if action == TextAction::Number {
            to_room = TextRoom::NUMBER;
        }
        let mut piece = number(b, dice, action);
        if action == TextAction::Piece && dice.roll(3) == 0 {
            let some = b.constant(dice.of(&[1, 1, 1, 0xFFFF, 2, 3, 7, 8]));
            piece[1] = b.compute(dice.of(&[Op::Copy, Op::Extend16]), &[some]);
            if dice.roll(3) == 0 {
                let condition = match dice.roll(3) {
                    0 => b.constant(dice.roll(2)),
                    _ => b.load(at(Area::BitMemory, NUMBERS + 3), Width::Bit, OnFault::SkipStatement),
                };
                piece[1] = b.compute(Op::Gate, &[piece[1], condition]);
            }
            if dice.roll(3) == 0 {
                // A number that is known not to be negative.
                let few = b.constant(15);
                piece[0] = b.compute(Op::AndU32, &[piece[0], few]);
            }
        }
        if action == TextAction::Append && (to, to_room) == (from, from_room) && dice.roll(2) == 0 {
            piece[0] = b.constant(0);
        }
        last = matches!((action, to), (TextAction::Assign | TextAction::Piece | TextAction::Append, Place::Fixed { .. }))
            .then_some((to, to_room));
        let dst = b.temporary();
        b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece });
        let result = at(Area::BitMemory, RESULTS + 4 * statement as u32);
        if action == TextAction::Compare && dice.roll(2) == 0 {
            let zero = b.constant(0);
            let compared = if dice.roll(3) == 0 { [zero, dst] } else { [dst, zero] };
            let op = dice.of(&[Op::Equal, Op::Differ, Op::LtI32, Op::LeI32, Op::GtI32, Op::GeI32]);
            let holds = b.compute(op, &compared);
            b.store(result, Width::Bit, holds);
            if dice.roll(6) == 0 {
                // Not only its sign counts.
                let more = b.compute(Op::AddU32, &[dst, zero]);
                b.store(at(Area::BitMemory, RESULTS + 4 * statement as u32), Width::DoubleWord, more);
            }
        } else {
            b.store(result, Width::DoubleWord, dst);
        }
    }
    if loops {
        b.begin_statement();
        let counter = b.load(at(Area::BitMemory, COUNTER), Width::Word, OnFault::SkipStatement);
        let one = b.constant(1);
        let counter = b.compute(Op::AddU16, &[counter, one]);
        b.store(at(Area::BitMemory, COUNTER), Width::Word, counter);
        let last = b.constant(3);
        let condition = b.compute(Op::LtI16, &[counter, last]);
        b.push(Inst::Branch { condition, to: begin });
    }
    b.begin_statement();
    b.push(Inst::Return);
}

/// Reads or writes bits, bytes or words that may be those of a text.
fn something_else(b: &mut Builder, dice: &mut Dice, text: Option<Place>) {
    let width = dice.of(&[Width::Bit, Width::Byte, Width::Word, Width::DoubleWord]);
    let mut place = || {
        let (area, byte) = if dice.roll(2) == 0 { (Area::Local, 0) } else { (Area::BitMemory, TEXTS) };
        let bit = if width == Width::Bit { dice.roll(8) as u32 } else { 0 };
        Place::Fixed { area, position: 8 * (byte + dice.roll(BYTES) as u32) + bit }
    };
    let [from, mut to] = [place(), place()];
    if let Some(Place::Fixed { area, position }) = text
        && dice.roll(3) == 0
    {
        // Its lengths, or its first characters.
        to = Place::Fixed { area, position: position + 8 * dice.roll(4) as u32 };
    }
    let value = match dice.roll(2) {
        0 => b.load(from, width, OnFault::SkipStatement),
        _ => b.constant(dice.roll(1 << 32) & dice.of(&[1, 0x0707_0707, 0xFFFF_FFFF])),
    };
    b.store(to, width, value);
}

/// Texts everywhere: lengths that are near to each other, and characters of which some are the same.
fn fill(machine: &mut Machine, dice: &mut Dice) {
    let memory = machine.memory.area_mut(Area::BitMemory);
    let most = dice.of(&[2, 8, 9, 12, 20, 40, 255]);
    let alike = dice.roll(2) == 0;
    let byte = |dice: &mut Dice| match dice.roll(24) {
        0..8 => dice.roll(most) as u8,
        8..23 if alike => b'1',
        _ => character(dice),
    };
    for at in &mut memory[TEXTS as usize..TEXTS as usize + BYTES as usize + 300] {
        *at = byte(dice);
    }
    for byte in &mut memory[NUMBERS as usize..NUMBERS as usize + 8] {
        *byte = dice.roll(256) as u8;
    }
    let number = match dice.roll(3) {
        0 => dice.roll(1 << 30) << (30 + dice.roll(4)),
        _ => {
            let bits = dice.roll(31);
            dice.roll(1 << bits)
        }
    };
    let number = if dice.roll(2) == 0 { number } else { number.wrapping_neg() };
    memory[NUMBERS as usize + 8..][..8].copy_from_slice(&number.to_be_bytes());
    let local = machine.memory.layout.local.clone();
    for at in &mut machine.memory.arena[local][..LOCAL as usize] {
        *at = byte(dice);
    }
}

#[test]
fn short_texts_are_the_same_on_all_engines() {
    for seed in seeds(PROGRAMS) {
        let body = |b: &mut Builder| statements(b, &mut Dice(seed));
        let program = program(&[(BlockId::ob(1), LOCAL, &body)]);
        let layout = layout(&program);
        let prepare = |machine: &mut Machine, memory: u64| {
            machine.budget = 100;
            fill(machine, &mut Dice(seed * MEMORIES + memory));
        };
        all_engines_agree_from((&program, &layout), MEMORIES, &prepare, &format!("program {seed}"));
    }
}

/// Whole numbers around every power of ten, as digits and back.
#[test]
fn digits_of_numbers_are_the_same_on_all_engines() {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let actions = [TextAction::Unsigned, TextAction::Signed, TextAction::SignedAlways];
    let body = |b: &mut Builder| {
        for (index, action) in (0..).zip(actions) {
            b.begin_statement();
            let number = b.load(at(Area::BitMemory, NUMBERS), Width::QuadWord, OnFault::SkipStatement);
            let dst = b.temporary();
            let (place, room) = (at(Area::BitMemory, TEXTS + 30 * index), TextRoom::narrow(24));
            b.push(Inst::Text { action, dst, to: place, to_room: room, from: place, from_room: room, piece: [number, number] });
            b.store(at(Area::BitMemory, RESULTS + 2 * index), Width::Word, dst);
            for (number, kind) in (0..).zip([NumberKind::I16, NumberKind::I32, NumberKind::U16]) {
                b.begin_statement();
                let form = b.constant(NumberForm { spelling: Spelling::Literal, kind }.word());
                let dst = b.temporary();
                let to = at(Area::BitMemory, TEXTS + 100 + 8 * (3 * index + number));
                let (action, to_room) = (TextAction::Number, TextRoom::NUMBER);
                b.push(Inst::Text { action, dst, to, to_room, from: place, from_room: room, piece: [form, form] });
                b.store(at(Area::BitMemory, RESULTS + 8 + 2 * (3 * index + number)), Width::Word, dst);
            }
        }
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), 20, &body)]);
    let layout = layout(&program);
    let engine = Jit::compiled(&program, &layout, StatusBits::Needed).expect("machine code");
    let reference = Interpreter::load(&program, &layout);
    let powers = (0..20).map(|power| 10_u64.pow(power));
    let around =
        powers.flat_map(|power| (1..10).map(move |digit| power.wrapping_mul(digit))).flat_map(|number| [number - 1, number, number + 7]);
    let mut dice = Dice(3);
    let numbers: Vec<u64> = around.chain((0..3000).map(|_| dice.roll(1 << (1 + dice.0 % 28)))).collect();
    for number in numbers.into_iter().flat_map(|number| [number, number.wrapping_neg()]) {
        let prepare = |machine: &mut Machine| {
            machine.budget = 100;
            machine.memory.area_mut(Area::BitMemory)[NUMBERS as usize..][..8].copy_from_slice(&number.to_be_bytes());
            machine.memory.area_mut(Area::BitMemory)[TEXTS as usize..][..90].fill(b'?');
        };
        let of = |engine: &dyn Engine| run(engine, &layout, &entry, &prepare, &|_, _, _| Reaction::Continue);
        of(engine.as_ref()).assert_ends_as(&of(reference.as_ref()), &|| number.to_string());
    }
}

/// Short texts with digits and points, and some with anything else among them, as REAL and LREAL.
#[test]
fn decimals_in_texts_are_the_same_on_all_engines() {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let forms = [Spelling::Literal, Spelling::Beginning, Spelling::S7]
        .map(|spelling| [NumberKind::F32, NumberKind::F64].map(|kind| (spelling, kind)));
    let body = |b: &mut Builder| {
        for (index, (spelling, kind)) in (0..).zip(forms.into_iter().flatten()) {
            b.begin_statement();
            let form = b.constant(NumberForm { spelling, kind }.word());
            let dst = b.temporary();
            let (to, from) = (at(Area::BitMemory, TEXTS + 20 + 8 * index), at(Area::BitMemory, TEXTS));
            let (action, from_room) = (TextAction::Number, TextRoom::narrow(if index % 2 == 0 { 12 } else { 7 }));
            b.push(Inst::Text { action, dst, to, to_room: TextRoom::NUMBER, from, from_room, piece: [form, form] });
            b.store(at(Area::BitMemory, RESULTS + 2 * index), Width::Word, dst);
        }
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), 20, &body)]);
    let layout = layout(&program);
    let engine = Jit::compiled(&program, &layout, StatusBits::Needed).expect("machine code");
    let reference = Interpreter::load(&program, &layout);
    let mut dice = Dice(11);
    for _ in 0..6000 {
        let count = dice.roll(10) as usize;
        let mut characters: Vec<u8> = (0..count).map(|_| b'0' + dice.roll(10) as u8).collect();
        for (kinds, rolled) in [(&b"."[..], 1), (b"+-", 3), (b".. _e-", 6)] {
            if count > 0 && (kinds == b"." || dice.roll(rolled) == 0) {
                let place = if kinds == b"+-" { 0 } else { dice.roll(count as u64) as usize };
                characters[place] = dice.of(kinds);
            }
        }
        let prepare = |machine: &mut Machine| {
            machine.budget = 100;
            let memory = machine.memory.area_mut(Area::BitMemory);
            memory[TEXTS as usize..][..20].fill(b'.');
            memory[TEXTS as usize..][..2].copy_from_slice(&[12, count as u8]);
            memory[TEXTS as usize + 2..][..count].copy_from_slice(&characters);
        };
        let of = |engine: &dyn Engine| run(engine, &layout, &entry, &prepare, &|_, _, _| Reaction::Continue);
        of(engine.as_ref()).assert_ends_as(&of(reference.as_ref()), &|| String::from_utf8_lossy(&characters).into_owned());
    }
}

#[test]
fn a_single_character_that_is_written_over_is_read_again() {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    for changed in 0..4 {
        let body = |b: &mut Builder| {
            let [from, to] = [0, 100].map(|byte| at(Area::BitMemory, TEXTS + byte));
            let literal = at(Area::Local, LITERAL);
            let room = TextRoom::narrow(20);
            b.begin_statement();
            let [first, one, dst] = [b.constant(2), b.constant(1), b.temporary()];
            b.push(Inst::Text { action: TextAction::Piece, dst, to, to_room: room, from, from_room: room, piece: [first, one] });
            b.begin_statement();
            let other = b.constant(u64::from(b'X'));
            b.store(at(Area::BitMemory, TEXTS + 100 + changed), Width::Byte, other);
            for (number, action) in [TextAction::Compare, TextAction::Find].into_iter().enumerate() {
                b.begin_statement();
                for (byte, number) in [1, 1, b'c'].into_iter().enumerate() {
                    let number = b.constant(number.into());
                    b.store(at(Area::Local, LITERAL + byte as u32), Width::Byte, number);
                }
                let [piece, dst] = [b.constant(0), b.temporary()];
                b.push(Inst::Text { action, dst, to: literal, to_room: TextRoom::narrow(1), from: to, from_room: room, piece: [piece; 2] });
                b.store(at(Area::BitMemory, RESULTS + 4 * number as u32), Width::DoubleWord, dst);
            }
            b.begin_statement();
            b.push(Inst::Return);
        };
        let program = program(&[(BlockId::ob(1), LOCAL, &body)]);
        let layout = layout(&program);
        let outcome = |engine: &dyn Engine| {
            let prepare = |machine: &mut Machine| {
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory[TEXTS as usize..][..6].copy_from_slice(&[20, 4, b'a', b'b', b'c', b'd']);
            };
            run(engine, &layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
        };
        let expected = outcome(&*Interpreter::load(&program, &layout));
        for status in [StatusBits::All, StatusBits::Needed] {
            let got = outcome(&*Jit::compiled(&program, &layout, status).expect("machine code"));
            got.assert_ends_as(&expected, &|| format!("byte {changed}, {status:?}"));
        }
    }
}

/// Two texts of up to so many characters, the same up to a place, in their order and as far as they are equal.
#[test]
fn long_texts_that_differ_somewhere_have_the_same_order_on_all_engines() {
    const MOST: usize = 60;
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let room = TextRoom::narrow(MOST as u8);
    let body = |b: &mut Builder| {
        let [from, to] = [0, 100].map(|byte| at(Area::BitMemory, TEXTS + byte));
        for (number, op) in (0..).zip([None, Some(Op::Equal), Some(Op::LtI32), Some(Op::GeI32)]) {
            b.begin_statement();
            let [piece, mut result] = [b.constant(0), b.temporary()];
            let action = TextAction::Compare;
            b.push(Inst::Text { action, dst: result, to, to_room: room, from, from_room: room, piece: [piece; 2] });
            if let Some(op) = op {
                let zero = b.constant(0);
                result = b.compute(op, &[result, zero]);
            }
            b.store(at(Area::BitMemory, RESULTS + 4 * number), Width::DoubleWord, result);
        }
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), LOCAL, &body)]);
    let layout = layout(&program);
    let engines = [StatusBits::All, StatusBits::Needed].map(|status| Jit::compiled(&program, &layout, status).expect("machine code"));
    let reference = Interpreter::load(&program, &layout);
    let mut dice = Dice(5);
    for place in 0..4000 {
        let lengths = [(); 2].map(|()| dice.roll(MOST as u64 + 1) as usize);
        let other = if dice.roll(3) == 0 { lengths[0] } else { lengths[1] };
        let lengths = [lengths[0], other];
        let prepare = |machine: &mut Machine| {
            machine.budget = 100;
            let memory = machine.memory.area_mut(Area::BitMemory);
            for (byte, length) in [0, 100].into_iter().zip(lengths) {
                memory[TEXTS as usize + byte..][..2].copy_from_slice(&[MOST as u8, length as u8]);
                for (at, character) in memory[TEXTS as usize + byte + 2..][..MOST].iter_mut().enumerate() {
                    *character = b'a' + (at % 20) as u8;
                }
            }
            // Behind the last place they are the same.
            if place % 80 < MOST {
                memory[TEXTS as usize + 102 + place % 80] = [b'Z', 0xFF][place % 2];
            }
        };
        let of = |engine: &dyn Engine| run(engine, &layout, &entry, &prepare, &|_, _, _| Reaction::Continue);
        let expected = of(reference.as_ref());
        engines.iter().for_each(|engine| of(engine.as_ref()).assert_ends_as(&expected, &|| format!("{lengths:?}, {place}")));
    }
}
