//! Numbers that text instructions deliver, as indexes: how long a text is, where it has something, how long a piece of it is. An array that
//! is one element too short for them is left, and one that is not is not looked at; whatever the texts say, memory is that of the
//! interpreter.

use sieben_engine::Machine;
use sieben_engine::ir::{Builder, DataRegister, Inst, Op, Place, TextAction, TextRoom};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::Dice;
use crate::noting::{all_engines_agree_from, layout_with, program};

const MEMORIES: u64 = 60;
/// Where the texts lie in bit memory.
const FIRST: u32 = 0;
const SECOND: u32 = 40;
const ACTIONS: [TextAction; 4] = [TextAction::Length, TextAction::Find, TextAction::Piece, TextAction::Append];

fn text(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// Writes the element of an array that the result of a text instruction names.
fn indexed(b: &mut Builder, action: TextAction, rooms: [TextRoom; 2]) {
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    b.begin_statement();
    let [none, all] = [0, 1000].map(|number| b.constant(number));
    let dst = b.constant(0);
    let [(to, to_room), (from, from_room)] = [(text(FIRST), rooms[0]), (text(SECOND), rooms[1])];
    b.push(Inst::Text { action, dst, to, to_room, from, from_room, piece: [none, all] });
    let eight = b.constant(8);
    let pointer = b.compute(Op::MulU32, &[dst, eight]);
    let value = b.constant(0x5A);
    b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, Width::Byte, value);
    b.begin_statement();
    b.push(Inst::Return);
}

/// In how many of the runs with an array of so many bytes nobody was asked.
fn silent_runs(action: TextAction, rooms: [TextRoom; 2], bytes: usize) -> u64 {
    let program = program(&[(BlockId::ob(1), 0, &|b| indexed(b, action, rooms))]);
    let layout = layout_with(&program, bytes);
    let prepare = |machine: &mut Machine, memory: u64| {
        let mut dice = Dice(memory + 1_000_000);
        machine.budget = 1000;
        let memory = machine.memory.area_mut(Area::BitMemory);
        memory[..80].iter_mut().for_each(|byte| *byte = 1 + dice.roll(2) as u8);
        for place in [FIRST, SECOND] {
            let place = place as usize;
            // Lengths of STRINGs and of WSTRINGs.
            let head = [dice.of(&[0, 5, 6, 255]), dice.of(&[0, 1, 4, 5, 255]), 0, dice.of(&[0, 1, 2, 4, 255])];
            memory[place..place + 4].copy_from_slice(&head);
        }
        // Only the fourth or sixth character of the first one is the second text.
        if dice.roll(2) == 0 {
            memory[FIRST as usize + 2..FIRST as usize + 8].copy_from_slice(&[1, 1, 1, 3, 1, 4]);
            memory[SECOND as usize + 1..SECOND as usize + 3].copy_from_slice(&[1, dice.of(&[3, 4])]);
        }
    };
    all_engines_agree_from((&program, &layout), MEMORIES, &prepare, &format!("{action:?} {rooms:?} {bytes}"))
}

#[test]
fn what_text_instructions_deliver_is_in_its_range() {
    for action in ACTIONS {
        for (rooms, most) in [
            ([TextRoom::narrow(4); 2], 4),
            ([TextRoom::narrow(4), TextRoom::narrow(6)], if action == TextAction::Find { 4 } else { 6 }),
            ([TextRoom::narrow(6), TextRoom::narrow(4)], if action == TextAction::Find { 6 } else { 4 }),
            ([TextRoom::narrow(4), TextRoom::narrow(6).unknown()], if action == TextAction::Find { 4 } else { 255 }),
            ([TextRoom::wide(4); 2], 4),
        ] {
            let whole = silent_runs(action, rooms, most + 1);
            let short = silent_runs(action, rooms, most);
            assert_eq!(whole, MEMORIES, "{action:?} {rooms:?}");
            // No memory has the second of two WSTRINGs at the end of the first.
            assert!(short < whole || action == TextAction::Find && rooms[0].wide, "{action:?} {rooms:?}");
        }
    }
}
