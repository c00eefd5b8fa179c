//! Choices between a bit and another number, in iterations that are done side by side: the other number keeps all of its bits.

use sieben_engine::Machine;
use sieben_engine::ir::{Builder, Op, Place, Var};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::noting::{self, all_engines_agree_from, counted, element_at, get, program};

/// Elements of the array at the beginning of bit memory that iterations look at, and behind it of the one that they write.
const ELEMENTS: u64 = 40;
const WRITTEN: u32 = 8 * 4 * ELEMENTS as u32;
const COUNTER: u32 = 1_000;

fn writes(b: &mut Builder, value: Var) {
    let counter = get(b, COUNTER, Width::DoubleWord);
    let bits = b.constant(32);
    let pointer = b.compute(Op::MulU32, &[counter, bits]);
    b.store(Place::Indirect { area: Area::BitMemory, pointer, offset: WRITTEN }, Width::DoubleWord, value);
}

/// Which of two is the bit, what the other one is, and what is done with the choice.
#[derive(Clone, Copy, Debug)]
struct Case {
    bit_first: bool,
    other: u64,
    op: Op,
}

fn iterations(b: &mut Builder, case: Case) {
    counted(b, COUNTER, ELEMENTS - 1, |b| {
        b.begin_statement();
        let (number, twenty, ten) = (element_at(b, COUNTER, Width::DoubleWord), b.constant(20), b.constant(10));
        let (bit, low) = (b.compute(Op::GtI32, &[number, twenty]), b.compute(Op::LtI32, &[number, ten]));
        let other = b.constant(case.other);
        let choice = if case.bit_first { [low, bit, other] } else { [low, other, bit] };
        let chosen = b.compute(Op::Select, &choice);
        let more = b.constant(2);
        let value = b.compute(case.op, &[chosen, more]);
        writes(b, value);
        2
    });
}

#[test]
fn what_is_chosen_instead_of_a_bit_keeps_its_bits() {
    for (bit_first, other, op) in [false, true]
        .into_iter()
        .flat_map(|bit_first| [0, 1, 5, 0x8000_0004].map(|other| (bit_first, other)))
        .flat_map(|(bit_first, other)| [Op::OrU32, Op::AndU32, Op::Shl32, Op::AddU32, Op::XorU32].map(|op| (bit_first, other, op)))
    {
        let case = Case { bit_first, other, op };
        let build = |b: &mut Builder| iterations(b, case);
        let program = program(&[(BlockId::ob(1), 16, &build)]);
        let prepare = |machine: &mut Machine, memory: u64| {
            machine.budget = 10_000;
            let bytes = machine.memory.area_mut(Area::BitMemory);
            for (element, place) in bytes[..4 * ELEMENTS as usize].chunks_mut(4).enumerate() {
                place.copy_from_slice(&((element as u32 * 7 + memory as u32 * 3) % 31).to_be_bytes());
            }
        };
        let silent = all_engines_agree_from((&program, &noting::layout(&program)), 4, &prepare, &format!("{case:?}"));
        assert_eq!(silent, 4);
    }
}
