//! Texts behind pointers that a caller hands on, as inputs of functions are: what machine code does with them where it knows the pointer,
//! and where the text says itself how long it is.

use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place, TextAction, TextRoom, Var};
use sieben_engine::{Engine, Entry, Interpreter, Layout, Machine, Program, Reaction};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::noting::{self, Outcome, program, run};

/// The bit memory where the other text of an instruction lies, which has room for six characters.
const OTHER: u32 = 20;
/// What a question about a text looks like in a listing: nothing else that machine code does by itself has six arguments.
const QUESTION: &str = "(i64, i64, i64, i64, i64, i64) -> i64 system_v";

/// Where a pointer comes from that is handed on.
#[derive(Clone, Copy, Debug)]
enum Pointer {
    /// Number of the data block and pointer.
    Known(u64, u64),
    /// The same number, and the pointer in bit memory.
    Read(u64),
    /// Number and pointer, and so many bits of MB 12 count bytes behind it.
    Indexed(u64, u64, u64),
}

/// A data block whose number needs more than a byte.
const FAR: u64 = 300;

/// A layout in which data blocks 1 and 300 have 16 bytes each.
fn layout(program: &Program) -> Layout {
    let mut layout = noting::layout(program);
    layout.data_blocks.insert(FAR as u16, layout.size - 32..layout.size - 16);
    layout
}

fn memory(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// A program whose function does something with the text behind a pointer, read or written, and keeps the result in MW 0.
fn handed_on(pointer: Pointer, action: TextAction, is_target: bool, room: TextRoom) -> Program {
    let caller = |b: &mut Builder| {
        b.begin_statement();
        let (number, pointer) = match pointer {
            Pointer::Known(number, pointer) => (number, b.constant(pointer)),
            Pointer::Indexed(number, pointer, bits) => {
                let index = b.load(memory(12), Width::Byte, OnFault::SkipStatement);
                let [bits, eight, pointer] = [bits, 8, pointer].map(|number| b.constant(number));
                let index = b.compute(Op::AndU32, &[index, bits]);
                let index = b.compute(Op::MulU32, &[index, eight]);
                (number, b.compute(Op::AddU32, &[pointer, index]))
            }
            Pointer::Read(number) => (number, b.load(memory(8), Width::DoubleWord, OnFault::SkipStatement)),
        };
        let number = b.constant(number);
        b.store(Place::Fixed { area: Area::Local, position: 0 }, Width::Word, number);
        b.store(Place::Fixed { area: Area::Local, position: 16 }, Width::DoubleWord, pointer);
        let parameter = b.constant(0x8700_0000);
        b.push(Inst::PassParameter { src: parameter });
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 1 });
        b.begin_statement();
        b.push(Inst::Return);
    };
    let function = |b: &mut Builder| {
        b.begin_statement();
        let parameter = b.temporary();
        b.push(Inst::Parameter { dst: parameter, index: 0 });
        let number = b.load(Place::Crossing { pointer: parameter, offset: 0 }, Width::Word, OnFault::SkipStatement);
        let pointer = b.load(Place::Crossing { pointer: parameter, offset: 16 }, Width::DoubleWord, OnFault::SkipStatement);
        let half = b.constant(32);
        let number = b.compute(Op::Shl64, &[number, half]);
        let pointer = b.compute(Op::OrU64, &[number, pointer]);
        let piece: [Var; 2] = [1, 3].map(|number| b.constant(number));
        let dst = b.temporary();
        let (text, other) = ((Place::Crossing { pointer, offset: 0 }, room), (memory(OTHER), TextRoom::narrow(6)));
        let ((to, to_room), (from, from_room)) = if is_target { (text, other) } else { (other, text) };
        b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece });
        b.store(memory(0), Width::Word, dst);
        b.begin_statement();
        b.push(Inst::Return);
    };
    program(&[(BlockId::ob(1), 48, &caller), (BlockId::fc(1), 16, &function)])
}

/// What is left of a run in which a text has these lengths and the other one is `OTHERS`.
fn outcome(engine: &dyn Engine, layout: &Layout, (block, byte): (u16, usize), lengths: [u8; 2]) -> Outcome {
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let prepare = |machine: &mut Machine| {
        machine.budget = 100;
        machine.memory.area_mut(Area::BitMemory)[OTHER as usize..][..8].copy_from_slice(b"\x06\x06OTHERS");
        machine.memory.area_mut(Area::BitMemory)[12] = 0xF2;
        let area = if block == 0 { 0x8300_0000 } else { 0x8400_0000 };
        machine.memory.area_mut(Area::BitMemory)[8..12].copy_from_slice(&(area + 8 * byte as u32).to_be_bytes());
        let start = match block {
            0 => layout.area(Area::BitMemory).expect("bit memory").start,
            block => layout.data_blocks[&block].start,
        };
        machine.memory.arena[start + byte..][..2].copy_from_slice(&lengths);
        for (at, character) in machine.memory.arena[start + byte + 2..][..4].iter_mut().zip(b"OTEH") {
            *at = *character;
        }
    };
    run(engine, layout, &entry, &prepare, &|_, _, _| Reaction::Continue)
}

fn asks(program: &Program, layout: &Layout) -> bool {
    Jit::listing(program, layout).expect("machine code").contains(QUESTION)
}

#[test]
fn a_text_whose_pointer_is_known_asks_nobody() {
    let room = TextRoom::narrow(0);
    let actions = [TextAction::Length, TextAction::Assign, TextAction::Piece, TextAction::Append, TextAction::Compare, TextAction::Find];
    let looks = [(7, room), (13, room), (7, TextRoom::narrow(7)), (3, TextRoom::narrow(11))];
    for action in actions {
        for (number, pointer) in [(1, 0x8400_0000_u64), (1, 0x8400_0050), (0, 0x8300_0140), (0, 0x8700_0040)] {
            for room in [room, TextRoom::narrow(4)] {
                let program = handed_on(Pointer::Known(number, pointer), action, false, room);
                assert!(!asks(&program, &layout(&program)), "{action:?} {number} {pointer:X} {room:?}");
            }
        }
        for number in [1, FAR] {
            let program = handed_on(Pointer::Known(number, 0x8400_0050), action, false, room);
            assert!(!asks(&program, &layout(&program)), "{action:?} {number}");
        }
        for (number, (bits, room)) in [1, FAR].into_iter().flat_map(|number| looks.map(|look| (number, look))) {
            let program = handed_on(Pointer::Indexed(number, 0x8400_0000, bits), action, false, room);
            assert!(!asks(&program, &layout(&program)), "{action:?} {number} {bits} {room:?}");
        }
        let here = handed_on(Pointer::Known(1, 0x8400_0000), action, true, room);
        assert!(action == TextAction::Length || !asks(&here, &layout(&here)), "{action:?} as target");
    }
}

#[test]
fn a_text_whose_pointer_is_not_known_asks() {
    let asked = |pointer: Pointer, room: TextRoom| {
        let program = handed_on(pointer, TextAction::Length, false, room);
        asks(&program, &layout(&program))
    };
    let unknown = TextRoom::narrow(0);
    assert!(asked(Pointer::Read(1), unknown), "a pointer in memory");
    assert!(asked(Pointer::Read(1), TextRoom::wide(0)), "a WSTRING behind a pointer in memory");
    assert!(asked(Pointer::Known(7, 0x8400_0000), unknown), "a data block that is not there");
    assert!(asked(Pointer::Known(1, 0x8400_0078), unknown), "a text of which only the first byte is there");
    assert!(asked(Pointer::Known(1, 0x8400_0050), TextRoom::narrow(5)), "a text that is declared longer than what is there");
    assert!(asked(Pointer::Indexed(1, 0x8400_0000, 15), unknown), "an index that may leave nothing of the head");
    assert!(asked(Pointer::Indexed(1, 0x8400_0000, 7), TextRoom::narrow(8)), "one that may leave less than is declared");
    assert!(asked(Pointer::Indexed(7, 0x8400_0000, 1), unknown), "one in a data block that is not there");
    assert!(asked(Pointer::Known(1, 0x8400_0001), unknown), "a text that begins inside a byte");
    assert!(asked(Pointer::Known(0, 0x8708_0000), unknown), "local data of nobody");
    assert!(asked(Pointer::Known(0, 0x8700_0178), unknown), "a text that begins in the last byte of the local data");
    assert!(asked(Pointer::Known(1, 0x8400_0000), TextRoom::wide(0)), "a WSTRING");
    let mut protected = handed_on(Pointer::Known(1, 0x8400_0000), TextAction::Assign, true, unknown);
    let mut read_only = layout(&protected);
    read_only.read_only.push(1);
    assert!(asks(&protected, &read_only), "a data block that may not be written");
    protected = handed_on(Pointer::Known(1, 0x8400_0000), TextAction::Assign, false, unknown);
    assert!(!asks(&protected, &read_only), "it may be read");
}

#[test]
fn texts_that_say_how_long_they_are_end_with_their_area_on_all_engines() {
    let mut faults = 0;
    for action in TextAction::ALL {
        for (pointer, block, byte) in [
            (Pointer::Known(1, 0x8400_0050), 1, 10),
            (Pointer::Read(1), 1, 10),
            (Pointer::Indexed(1, 0x8400_0040, 3), 1, 10),
            (Pointer::Indexed(FAR, 0x8400_0040, 3), FAR as u16, 10),
            // It shares bytes with the other text.
            (Pointer::Known(0, 0x8300_0090), 0, 18),
            // Behind the end of bit memory there is enough of the arena.
            (Pointer::Read(0), 0, 2048 - 6),
            (Pointer::Read(0), 0, 18),
            (Pointer::Read(7), 0, 18),
        ] {
            for is_target in [false, true] {
                let room = if action == TextAction::Number && is_target { TextRoom::NUMBER } else { TextRoom::narrow(0) };
                let program = handed_on(pointer, action, is_target, room);
                let layout = layout(&program);
                let reference = Interpreter::load(&program, &layout);
                let engines =
                    [StatusBits::All, StatusBits::Needed].map(|status| Jit::compiled(&program, &layout, status).expect("machine code"));
                for lengths in [0, 1, 3, 4, 5, 200, 255].iter().flat_map(|&most| [0, 1, 2, 4, 5, 255].map(|length| [most, length])) {
                    let of = |engine: &dyn Engine| outcome(engine, &layout, (block, byte), lengths);
                    let expected = of(reference.as_ref());
                    for engine in &engines {
                        of(engine.as_ref()).assert_ends_as(&expected, &|| format!("{action:?} {pointer:?} {is_target} {lengths:?}"));
                    }
                    faults += expected.asked.len();
                }
            }
        }
    }
    assert!(faults > 100, "{faults}");
}
