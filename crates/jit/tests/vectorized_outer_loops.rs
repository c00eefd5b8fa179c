//! Two loops in one another whose outer iterations are done side by side: elements that several iterations write, and numbers of 16 bits.

use std::sync::Arc;

use sieben_engine::ir::{Builder, DataRegister, Inst, OnFault, Op, Place, Target};
use sieben_engine::{Entry, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::noting::{all_engines_agree, engines, layout_with, program, run};

fn counter(number: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * (200 + 4 * number) }
}

/// `FOR i := 0 TO 24 DO FOR j := 0 TO 1 DO a[i + j] := j; ...`
fn loops(b: &mut Builder, middle: &dyn Fn(&mut Builder)) {
    let wide = Width::DoubleWord;
    b.begin_statement();
    let number = b.constant(1);
    b.push(Inst::Open { register: DataRegister::Shared, number });
    for number in 0..2 {
        b.begin_statement();
        let zero = b.constant(0);
        b.store(counter(number), wide, zero);
    }
    b.begin_statement();
    middle(b);
    for (number, last, to) in [(1, 1, 3), (0, 24, 2)] {
        b.begin_statement();
        let value = b.load(counter(number), wide, OnFault::SkipStatement);
        let one = b.constant(1);
        let next = b.compute(Op::AddU32, &[value, one]);
        b.store(counter(number), wide, next);
        let limit = b.constant(last);
        let condition = b.compute(Op::LeI32, &[next, limit]);
        b.push(Inst::Branch { condition, to: Target(to) });
    }
    b.begin_statement();
    b.push(Inst::Return);
}

fn compare(middle: &dyn Fn(&mut Builder)) {
    let block = BlockId::ob(1);
    let program = program(&[(block, 16, &|b| loops(b, middle))]);
    let layout = layout_with(&program, 600);
    let entry = Entry { block, start_information: [7; 20], registers: None };
    let prepare = |machine: &mut Machine| machine.budget = 100_000;
    let answer = |_: &mut Machine, _: &str, _: usize| Reaction::Stop(StopReason { event: 0x4562, place: None });
    let outcome = |engine: Arc<dyn sieben_engine::Engine>| run(engine.as_ref(), &layout, &entry, &prepare, &answer);
    all_engines_agree(&engines(&program, &layout), false, &outcome, &|| String::new());
}

#[test]
fn elements_that_several_iterations_write_hold_what_the_last_one_wrote() {
    compare(&|b| {
        let wide = Width::DoubleWord;
        let [i, j] = [0, 1].map(|number| b.load(counter(number), wide, OnFault::SkipStatement));
        let bits = b.constant(32);
        let [x, y] = [i, j].map(|number| b.compute(Op::MulU32, &[number, bits]));
        let pointer = b.compute(Op::AddU32, &[y, x]);
        b.store(Place::Indirect { area: Area::SharedData, pointer, offset: 0 }, wide, j);
    });
}

#[test]
fn four_iterations_side_by_side_compute_with_numbers_of_16_bits() {
    compare(&|b| {
        let wide = Width::DoubleWord;
        let [i, j] = [0, 1].map(|number| b.load(counter(number), wide, OnFault::SkipStatement));
        let bits = b.constant(32);
        let x = b.compute(Op::MulU32, &[i, bits]);
        let place = Place::Indirect { area: Area::SharedData, pointer: x, offset: 0 };
        let squares = b.compute(Op::MulU16, &[i, i]);
        let seven = b.constant(0x7007);
        let value = b.compute(Op::MulU16, &[squares, seven]);
        let value = b.compute(Op::Extend16, &[value]);
        let value = b.compute(Op::AddU32, &[value, j]);
        b.store(place, wide, value);
    });
}
