//! A counted loop that makes integers of REALs and LREALs, several vectorized iterations: the ends of the ranges, halves, and what is no
//! number.

use std::sync::Arc;

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::{Entry, Layout, Machine, Reaction, StopReason};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;

use crate::noting::{all_engines_agree, engines, program, run};

const COUNTER: Place = Place::Fixed { area: Area::BitMemory, position: 8 * 1_000 };
/// Where the results begin, behind as many REALs as there are iterations.
const RESULTS: u32 = 512;

const REALS: [f32; 24] = [
    0.0,
    -0.0,
    0.5,
    -0.5,
    1.5,
    -1.5,
    2.5,
    -2.7,
    100.3,
    -0.999,
    32_767.0,
    32_767.6,
    -32_768.5,
    -32_769.0,
    65_535.5,
    65_536.0,
    8_388_607.5,
    2_147_483_520.0,
    2_147_483_648.0,
    -2_147_483_648.0,
    -2_147_483_904.0,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

fn element(b: &mut Builder, offset: u32) -> Place {
    let counter = b.load(COUNTER, Width::DoubleWord, OnFault::SkipStatement);
    let bits = b.constant(32);
    let pointer = b.compute(Op::MulU32, &[counter, bits]);
    Place::Indirect { area: Area::BitMemory, pointer, offset: 8 * offset }
}

/// `FOR i := 0 TO 23 DO r[i] := TO_DINT(a[i]); END_FOR`
fn looping(b: &mut Builder, cut: &dyn Fn(&mut Builder, Var) -> Var) {
    let wide = Width::DoubleWord;
    b.begin_statement();
    let zero = b.constant(0);
    b.store(COUNTER, wide, zero);
    b.begin_statement();
    let from = element(b, 0);
    let real = b.load(from, wide, OnFault::SkipStatement);
    let number = cut(b, real);
    let to = element(b, RESULTS);
    b.store(to, wide, number);
    b.begin_statement();
    let counter = b.load(COUNTER, wide, OnFault::SkipStatement);
    let one = b.constant(1);
    let next = b.compute(Op::AddU32, &[counter, one]);
    b.store(COUNTER, wide, next);
    let limit = b.constant(REALS.len() as u64);
    let condition = b.compute(Op::LtI32, &[next, limit]);
    b.push(Inst::Branch { condition, to: Target(1) });
    b.begin_statement();
    b.push(Inst::Return);
}

#[test]
fn reals_are_cut_as_the_interpreter_cuts_them() {
    let block = BlockId::ob(1);
    let whole = [None, Some(Op::RoundF64), Some(Op::CeilF64), Some(Op::FloorF64), Some(Op::TruncF64)];
    for whole in whole {
        for last in [Op::F64ToI32, Op::F64ToI16, Op::F64ToU16] {
            for of_lreal in [false, true] {
                let cut = |b: &mut Builder, real: Var| {
                    let mut value = b.compute(Op::F32ToF64, &[real]);
                    if of_lreal {
                        let third = b.constant((1.0_f64 / 3.0).to_bits());
                        value = b.compute(Op::AddF64, &[value, third]);
                    }
                    if let Some(whole) = whole {
                        value = b.compute(whole, &[value]);
                    }
                    b.compute(last, &[value])
                };
                let program = program(&[(block, 16, &|b| looping(b, &cut))]);
                let layout = Layout::new(&CpuType::ALL[0], &program);
                let entry = Entry { block, start_information: [7; 20], registers: None };
                let prepare = |machine: &mut Machine| {
                    let memory = machine.memory.area_mut(Area::BitMemory);
                    for (place, real) in memory.chunks_exact_mut(4).zip(REALS) {
                        place.copy_from_slice(&real.to_be_bytes());
                    }
                    machine.budget = 100_000;
                };
                let answer = |_: &mut Machine, _: &str, _: usize| Reaction::Stop(StopReason { event: 0x4562, place: None });
                let outcome = |engine: Arc<dyn sieben_engine::Engine>| run(engine.as_ref(), &layout, &entry, &prepare, &answer);
                all_engines_agree(&engines(&program, &layout), false, &outcome, &|| format!("{whole:?} {last:?} {of_lreal}"));
            }
        }
    }
}
