//! Counted loops that divide sums with their variable by constants and write bits of an array: whatever sign the sums have, where they
//! overflow, and whatever the Host changes between iterations, the loops do on all engines what the interpreter does.

use std::cell::RefCell;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_engine::{Entry, Exit, FaultPlace, Interpreter, Machine, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;

use crate::dice::{Dice, seeds};
use crate::noting::{self, program, run};

const PROGRAMS: u64 = 400;
const QUESTIONS_MAX: usize = 30;
/// Where the variables lie in bit memory, in bytes; the array is before them.
const COUNTER: u32 = 200;
const ADDED: u32 = 204;
const SUM: u32 = 208;
const DIVIDED: u32 = 212;
/// Bytes of an element of the array.
const ELEMENT: u32 = 6;

const DIVISORS: &[u64] = &[1, 2, 3, 5, 7, 9, 10, 16, 20, 60, 100, 127, 1000, 0x7FFF, 0x4000_0001, 0x7FFF_FFFF, 0xFFFF_FFFF, 0xFFFD, 0];
const STARTS: &[u32] = &[0, 0, 1, 17, 30_000, 32_760, 0x7FFF_FFF0, 0x8000_0000, 0xFFFF_FFF0, 0xFFFF_FFFF, 0xFFFF_0000, 123_456_789];

fn fixed(byte: u32) -> Place {
    Place::Fixed { area: Area::BitMemory, position: 8 * byte }
}

/// A loop over the elements.
fn looping(b: &mut Builder, seed: u64) {
    let mut dice = Dice(seed);
    let halves = dice.roll(3) == 0;
    let width = if halves { Width::Word } else { Width::DoubleWord };
    let get = |b: &mut Builder, byte: u32, width: Width| b.load(fixed(byte), width, OnFault::SkipStatement);
    b.begin_statement();
    let first = b.constant(dice.roll(3));
    b.store(fixed(COUNTER), width, first);
    b.begin_statement();
    let counter = get(b, COUNTER, width);
    let mut number = counter;
    if dice.roll(2) == 0 {
        let times = b.constant(dice.of(&[2, 3, 16, 0xFFFF_FFFF, 0x1000]));
        number = b.compute(if halves { Op::MulU16 } else { Op::MulU32 }, &[number, times]);
    }
    let added = get(b, ADDED, width);
    if dice.roll(4) != 0 {
        number = b.compute(if halves { Op::AddU16 } else { Op::AddU32 }, &[number, added]);
    }
    let by = b.constant(dice.of(DIVISORS));
    let op = if halves { dice.of(&[Op::DivI16, Op::RemI16]) } else { dice.of(&[Op::DivI32, Op::RemI32]) };
    let mut divided = b.compute(op, &[number, by]);
    if dice.roll(3) == 0 {
        divided = b.compute(op, &[number, added]);
    }
    let five = b.constant(dice.of(&[0, 1, 5]));
    let condition = b.compute(if halves { Op::LtI16 } else { Op::LtI32 }, &[divided, five]);
    let index = if halves { b.compute(Op::Extend16, &[counter]) } else { counter };
    let bits = b.constant(u64::from(8 * ELEMENT));
    let pointer = b.compute(Op::MulU32, &[index, bits]);
    let element = |offset: u32| Place::Indirect { area: Area::BitMemory, pointer, offset };
    let mut bit: Var = condition;
    for _ in 0..=dice.roll(4) {
        let at = element(dice.of(&[0, 0, 1, 7, 8, 15]));
        match dice.roll(4) {
            0 => {
                let before = b.load(at, Width::Bit, OnFault::SkipStatement);
                bit = b.compute(dice.of(&[Op::And, Op::Xor, Op::AndNot, Op::Or]), &[condition, before]);
            }
            1 => {
                let byte = element(dice.of(&[0, 8]));
                if dice.roll(2) == 0 {
                    b.store(byte, Width::Byte, divided);
                } else {
                    divided = b.load(byte, Width::Byte, OnFault::SkipStatement);
                }
            }
            _ => b.store(at, Width::Bit, bit),
        }
    }
    if dice.roll(2) == 0 {
        b.store(element(16), width, divided);
    }
    b.store(fixed(DIVIDED), width, divided);
    if dice.roll(3) == 0 {
        b.push(Inst::Branch { condition, to: Target(3) });
    }
    b.begin_statement();
    let sum = get(b, SUM, width);
    let divided = get(b, DIVIDED, width);
    let more = b.compute(dice.of(&[Op::XorU32, Op::AddU32]), &[sum, divided]);
    b.store(fixed(SUM), width, more);
    b.begin_statement();
    let counter = get(b, COUNTER, width);
    let one = b.constant(1);
    let next = b.compute(if halves { Op::AddU16 } else { Op::AddU32 }, &[counter, one]);
    b.store(fixed(COUNTER), width, next);
    let last = b.constant(dice.of(&[0, 7, 20, 30]));
    let again = b.compute(if halves { Op::LeI16 } else { Op::LeI32 }, &[next, last]);
    b.push(Inst::Branch { condition: again, to: Target(1) });
    b.begin_statement();
    let counter = get(b, COUNTER, width);
    b.compute_into(Register::Accu1, Op::Copy, &[counter]);
    b.begin_statement();
    b.push(Inst::Return);
}

/// Changes a byte, sometimes, and goes on for a while that is long or short.
fn meddle(machine: &mut Machine, dice: &mut Dice, asked: usize) -> Reaction {
    if asked >= QUESTIONS_MAX {
        return Reaction::Stop(StopReason { event: 0x4562, place: None::<FaultPlace> });
    }
    machine.budget = dice.of(&[0, 1, 3, 9, 17, 100, 1000, 100_000]);
    if dice.roll(2) == 0 {
        let place = dice.of(&[COUNTER + 3, ADDED, ADDED + 1, ADDED + 3, SUM + 2, 0, 6]) as usize;
        machine.memory.area_mut(Area::BitMemory)[place] = dice.of(&[0, 1, 7, 0x7F, 0x80, 0xFF]);
    }
    Reaction::Continue
}

#[test]
fn sums_with_the_variable_of_a_loop_are_divided_alike_whatever_their_sign() {
    let (mut asked, mut finished) = (0, 0);
    for seed in seeds(PROGRAMS) {
        let block = BlockId::ob(1);
        let program = program(&[(block, 16, &|b| looping(b, seed))]);
        let layout = noting::layout(&program);
        let engines = [StatusBits::All, StatusBits::Needed].map(|status| Jit::compiled(&program, &layout, status).expect("machine code"));
        let interpreter = Interpreter::load(&program, &layout);
        for (number, &start) in (0..).zip(STARTS) {
            let entry = Entry { block, start_information: [7; 20], registers: None };
            let prepare = |machine: &mut Machine| {
                let mut dice = Dice(seed + 1_000_000 + number);
                machine.budget = dice.of(&[1, 5, 50, 1000, 100_000, 100_000]);
                let memory = machine.memory.area_mut(Area::BitMemory);
                memory[..256].iter_mut().for_each(|byte| *byte = dice.roll(256) as u8);
                let halves = program.code[&block].code.to_string().contains("_i16");
                let start = if halves { start << 16 } else { start };
                memory[ADDED as usize..][..4].copy_from_slice(&start.to_be_bytes());
            };
            let outcome = |engine: &Arc<dyn sieben_engine::Engine>| {
                let dice = RefCell::new(Dice(seed + 2_000_000));
                let answer = |machine: &mut Machine, _: &str, asked: usize| meddle(machine, &mut dice.borrow_mut(), asked);
                run(engine.as_ref(), &layout, &entry, &prepare, &answer)
            };
            let expected = outcome(&interpreter);
            for engine in &engines {
                let engine: Arc<dyn sieben_engine::Engine> = engine.clone();
                outcome(&engine).assert_ends_as(&expected, &|| format!("{seed} from {start:X}\n{}", program.code[&block].code));
            }
            asked += expected.asked.len();
            finished += usize::from(expected.exit == Exit::Finished);
        }
    }
    assert!(asked > 2_000 && finished > 2_000, "{asked} questions, {finished} runs to the end");
}
