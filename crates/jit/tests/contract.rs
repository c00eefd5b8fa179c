//! A Host that does what a CPU seldom does sees the same of both engines, and machine code keeps its promises.

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::memory::DataBlockEntry;
use sieben_engine::machine::{Register, Registers};
use sieben_engine::{Entry, Exit, Interpreter, Machine, Reaction, StopReason};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};

use crate::noting::{Answer, Blocks, Outcome, layout, program, run};

const fn sfc(number: u16) -> BlockId {
    BlockId::new(BlockKind::SystemFunction, number)
}

/// Runs a block on both engines; what both did.
fn both_from(
    first: BlockId,
    registers: Option<Registers>,
    blocks: Blocks<'_>,
    prepare: &dyn Fn(&mut Machine),
    answer: Answer<'_>,
) -> Outcome {
    let program = program(blocks);
    let layout = layout(&program);
    let entry = Entry { block: first, start_information: [7; 20], registers: registers.map(Box::new) };
    let expected = run(Interpreter::load(&program, &layout).as_ref(), &layout, &entry, prepare, answer);
    let native = Jit::compiled(&program, &layout, StatusBits::All).expect("machine code");
    let got = run(native.as_ref(), &layout, &entry, prepare, answer);
    got.assert_ends_as(&expected, &|| first.to_string());
    assert_eq!(got, expected);
    got
}

fn both(blocks: Blocks<'_>, answer: Answer<'_>) -> Outcome {
    both_from(BlockId::ob(1), None, blocks, &|_| {}, answer)
}

fn enter(number: u16) -> Reaction {
    Reaction::Enter { block: BlockId::ob(number), start_information: [3; 20] }
}

fn count(builder: &mut Builder, byte: u32) {
    builder.begin_statement();
    let place = Place::Fixed { area: Area::BitMemory, position: 8 * byte };
    let value = builder.load(place, Width::Word, OnFault::SkipStatement);
    let one = builder.constant(1);
    let sum = builder.compute(Op::AddI16Wide, &[value, one]);
    builder.store(place, Width::Word, sum);
}

fn open(builder: &mut Builder, number: u64) {
    builder.begin_statement();
    let number = builder.constant(number);
    builder.push(Inst::Open { register: DataRegister::Shared, number });
}

fn write_data(builder: &mut Builder, value: u64) {
    builder.begin_statement();
    let value = builder.constant(value);
    builder.store(Place::Fixed { area: Area::SharedData, position: 0 }, Width::Word, value);
}

fn call(builder: &mut Builder, block: BlockId) {
    builder.begin_statement();
    builder.push(Inst::Call { callee: Callee::Block(block), parameters: 0 });
}

fn loop_back(builder: &mut Builder, to: u32) {
    builder.begin_statement();
    builder.push(Inst::Jump { to: Target(to) });
}

const STOP: fn() -> Reaction = || Reaction::Stop(StopReason { event: 0x4303, place: None });

#[test]
fn interrupts_nested_without_end_leave_machine_code_in_time() {
    // Far more than there are priority classes, on a thread with the usual stack; a block without local data meets no other limit.
    let outcome = both_from(
        BlockId::ob(1),
        None,
        &[(BlockId::ob(1), 0, &|builder| count(builder, 0)), (BlockId::ob(40), 0, &|builder| count(builder, 2))],
        &|machine| machine.budget = 0,
        &|machine, _, before| {
            machine.budget = 0;
            if before < 2_000 { enter(40) } else { Reaction::Continue }
        },
    );
    assert_eq!(outcome.exit, Exit::Finished);
    assert!(outcome.asked.len() > 2_000, "{} questions", outcome.asked.len());
}

#[test]
fn the_interpreter_takes_over_where_no_safe_point_is() {
    // A system function takes away a data block on which machine code relies.
    let outcome = both(
        &[(BlockId::ob(1), 20, &|builder| {
            open(builder, 1);
            write_data(builder, 5);
            call(builder, sfc(23));
            open(builder, 1);
            write_data(builder, 6);
        })],
        &|machine, what, _| {
            if what == "SFC 23" {
                machine.memory.data_blocks[1] = None;
            }
            Reaction::Continue
        },
    );
    let safe_points = outcome.asked.iter().filter(|what| what.starts_with("safe point")).count();
    assert_eq!(safe_points, 0, "{:?}", outcome.asked);
    assert!(outcome.asked.last().is_some_and(|what| what.contains("Programming")), "{:?}", outcome.asked);
}

#[test]
fn what_has_no_room_for_its_local_data_fails_at_its_call() {
    let large = |builder: &mut Builder| count(builder, 4);
    let calls = |builder: &mut Builder| {
        count(builder, 0);
        call(builder, BlockId::fc(1));
        count(builder, 2);
    };
    let stops = |_: &mut Machine, what: &str, _: usize| match what {
        "safe point at OB 1 0" => enter(40),
        _ if what.contains("LocalData") => STOP(),
        _ => Reaction::Continue,
    };
    let fc = (BlockId::fc(1), 40_000, &large as &dyn Fn(&mut Builder));
    let started = both(&[(BlockId::ob(1), 20, &calls), fc], &stops);
    let interrupting = both_from(
        BlockId::ob(1),
        None,
        &[(BlockId::ob(1), 20, &|builder| count(builder, 6)), (BlockId::ob(40), 20, &calls), fc],
        &|machine| machine.budget = 0,
        &stops,
    );
    for outcome in [started, interrupting] {
        assert_ne!(outcome.exit, Exit::Finished, "{:?}", outcome.asked);
        assert!(outcome.asked.last().is_some_and(|what| what.contains("LocalData") && what.ends_with("1")), "{:?}", outcome.asked);
    }
}

/// The code of the caller counts on the data block that is open there.
#[test]
fn a_new_data_block_is_open_only_in_the_block_that_opens_it() {
    let calls = |b: &mut Builder| {
        b.begin_statement();
        b.push(Inst::Call { callee: Callee::Block(BlockId::fc(1)), parameters: 0 });
        b.begin_statement();
        b.push(Inst::Return);
    };
    let opens = |b: &mut Builder| {
        b.begin_statement();
        let number = b.load(Place::Fixed { area: Area::BitMemory, position: 0 }, Width::Word, OnFault::SkipStatement);
        b.push(Inst::Open { register: DataRegister::Instance, number });
        b.begin_statement();
        b.push(Inst::Return);
    };
    let makes = |b: &mut Builder| {
        call(b, sfc(22));
        b.begin_statement();
        b.push(Inst::Return);
    };
    let program = program(&[(BlockId::ob(1), 20, &calls), (BlockId::ob(40), 20, &makes), (BlockId::fc(1), 0, &opens)]);
    let layout = layout(&program);
    let entry = Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None };
    let answer = |machine: &mut Machine, what: &str, asked: usize| {
        if what == "SFC 22" {
            let base = machine.memory.layout.data_blocks[&1].start as u32;
            machine.memory.data_blocks.resize(10, None);
            machine.memory.data_blocks[9] = Some(DataBlockEntry { base, length: 16, read_only: true });
            let start = machine.memory.layout.bit_memory.start;
            machine.memory.arena[start + 1] = 9;
        }
        machine.budget = if asked < 8 { 1 } else { 100 };
        if asked < 8 && asked.is_multiple_of(3) { enter(40) } else { Reaction::Continue }
    };
    for status in [StatusBits::All, StatusBits::Needed] {
        let native = Jit::compiled(&program, &layout, status).expect("machine code");
        let ended = run(&*native, &layout, &entry, &|machine| machine.budget = 0, &answer);
        assert_eq!((ended.exit, ended.registers.di_number), (Exit::Finished, 0), "{status:?}");
    }
}

#[test]
fn an_interrupt_right_behind_a_deleted_data_block_misses_it() {
    let outcome = both(
        &[
            (BlockId::ob(1), 20, &|builder| call(builder, sfc(23))),
            (BlockId::ob(40), 20, &|builder| {
                open(builder, 1);
                write_data(builder, 6);
            }),
        ],
        &|machine, what, _| {
            if what != "SFC 23" {
                return Reaction::Continue;
            }
            machine.memory.data_blocks[1] = None;
            enter(40)
        },
    );
    assert!(outcome.asked.iter().any(|what| what.contains("Programming")), "{:?}", outcome.asked);
}

#[test]
fn a_data_block_that_was_made_protected_is_not_written() {
    let protect = |machine: &mut Machine| {
        let base = machine.memory.layout.size as u32 - 32;
        machine.memory.data_blocks.resize(10, None);
        machine.memory.data_blocks[9] = Some(DataBlockEntry { base, length: 16, read_only: true });
    };
    let number = Place::Fixed { area: Area::BitMemory, position: 0 };
    let write = |builder: &mut Builder| {
        builder.begin_statement();
        let number = builder.load(number, Width::Word, OnFault::SkipStatement);
        builder.push(Inst::Open { register: DataRegister::Shared, number });
        write_data(builder, 6);
    };
    let number_nine = |machine: &mut Machine| {
        let at = machine.memory.layout.bit_memory.start;
        machine.memory.arena[at + 1] = 9;
    };
    // Made by the program, and there from the beginning.
    let made = both_from(
        BlockId::ob(1),
        None,
        &[(BlockId::ob(1), 20, &|builder| {
            call(builder, sfc(85));
            write(builder);
        })],
        &number_nine,
        &|machine, what, _| {
            if what == "SFC 85" {
                protect(machine);
            }
            Reaction::Continue
        },
    );
    let restored = both_from(
        BlockId::ob(1),
        None,
        &[(BlockId::ob(1), 20, &write)],
        &|machine| {
            number_nine(machine);
            protect(machine);
        },
        &|_, _, _| Reaction::Continue,
    );
    for outcome in [made, restored] {
        assert!(outcome.asked.iter().any(|what| what.contains("48")), "programming error 16#30: {:?}", outcome.asked);
    }
}

#[test]
fn a_run_that_begins_with_a_function_has_no_caller() {
    // The pointer means the local data of the caller; MCRA and the status bits are preset.
    let mut registers = Registers::fresh();
    registers.accu1 = 0x8700_0000;
    registers.set(Register::Os, 1);
    registers.set(Register::Ma, 1);
    let block: &dyn Fn(&mut Builder) = &|builder| {
        builder.begin_statement();
        let place = Place::Crossing { pointer: Register::Accu1.into(), offset: 0 };
        let value = builder.load(place, Width::Word, OnFault::SkipStatement);
        builder.store(Place::Fixed { area: Area::BitMemory, position: 0 }, Width::Word, value);
    };
    let outcome = both_from(BlockId::fc(1), Some(registers), &[(BlockId::fc(1), 20, block)], &|_| {}, &|_, _, _| Reaction::Continue);
    assert!(outcome.asked.iter().any(|what| what.contains("Programming")), "{:?}", outcome.asked);
    // The same as the answer of a Host.
    let entered = both(
        &[
            (BlockId::ob(1), 20, &|builder| call(builder, sfc(1))),
            (BlockId::fc(1), 20, &|builder| {
                builder.begin_statement();
                builder.set(Register::Accu1, 0x8700_0000);
                block(builder);
            }),
        ],
        &|_, what, _| match what {
            "SFC 1" => Reaction::Enter { block: BlockId::fc(1), start_information: [3; 20] },
            _ => Reaction::Continue,
        },
    );
    assert!(entered.asked.iter().any(|what| what.contains("Programming")), "{:?}", entered.asked);
}

#[test]
fn a_jump_table_back_weighs_what_a_jump_back_does() {
    // From statement 64 to an empty statement 0: 64 statements, though the first that does something is nearer.
    let outcome = both(
        &[(BlockId::ob(1), 20, &|builder| {
            builder.begin_statement();
            builder.begin_statement();
            count(builder, 0);
            for _ in 3..64 {
                builder.begin_statement();
                builder.set(Register::Accu1, 1);
            }
            builder.begin_statement();
            let index = builder.constant(0);
            let first = builder.table(&[Target(0)]);
            builder.push(Inst::JumpTable { index, first, count: 1, otherwise: Target(0) });
        })],
        &|machine, _, before| {
            machine.budget = 7;
            if before > 5 { STOP() } else { Reaction::Continue }
        },
    );
    assert_ne!(outcome.exit, Exit::Finished);
}

#[test]
fn a_missing_error_block_delivers_zero() {
    let outcome = both(
        &[(BlockId::ob(1), 20, &|builder| {
            builder.begin_statement();
            builder.set(Register::Accu1, 5);
            builder.begin_statement();
            let place = Place::Fixed { area: Area::SharedData, position: 0 };
            builder.push(Inst::Load { dst: Register::Accu1.into(), place, width: Width::Word, on_fault: OnFault::DeliverZero });
        })],
        &|_, what, _| if what.contains("Programming") { enter(121) } else { Reaction::Continue },
    );
    assert_eq!(outcome.registers.accu1, 0);
}

#[test]
fn whoever_stops_in_a_loop_goes_on_in_it() {
    let outcome = both(
        &[(BlockId::ob(1), 20, &|builder| {
            count(builder, 0);
            loop_back(builder, 0);
        })],
        &|_, _, before| if before > 20 { STOP() } else { Reaction::Continue },
    );
    assert_ne!(outcome.exit, Exit::Finished);
}

#[test]
fn quad_words_are_read_and_written_like_narrower_values() {
    use Area::{BitMemory, InstanceData, Local, PeripheralInput, PeripheralOutput, SharedData};
    let fixed = |area, position| Place::Fixed { area, position };
    let pointed = |area, pointer, offset| Place::Indirect { area, pointer, offset };
    let crossing = |pointer: Var, offset| Place::Crossing { pointer, offset };
    let ar2 = Var::from(Register::Ar2);
    let outcome = both_from(
        BlockId::ob(1),
        Some(Registers { ar2: 0x8300_0000 | 800, ..Registers::fresh() }),
        &[(BlockId::ob(1), 32, &|builder| {
            open(builder, 1);
            builder.begin_statement();
            let number = builder.constant(1);
            builder.push(Inst::Open { register: DataRegister::Instance, number });
            // The value moves on from place to place; the last ones do not exist, or are no beginning of a byte.
            let way = [
                fixed(BitMemory, 0),
                fixed(Local, 160),
                fixed(SharedData, 0),
                pointed(BitMemory, ar2, 8),
                crossing(ar2, 80),
                fixed(InstanceData, 64),
                fixed(BitMemory, 200),
                fixed(BitMemory, 8 * (2048 - 7)),
                fixed(SharedData, 72),
                pointed(Local, ar2, 0),
                crossing(ar2, 8 * 2041),
                fixed(BitMemory, 300),
                fixed(PeripheralInput, 0),
                fixed(PeripheralOutput, 0),
            ];
            for (index, &to) in way.iter().enumerate().skip(1) {
                let last_good = way[index.min(7) - 1];
                builder.begin_statement();
                let value = builder.load(last_good, Width::QuadWord, OnFault::SkipStatement);
                builder.store(to, Width::QuadWord, value);
                builder.begin_statement();
                builder.push(Inst::Load { dst: Register::Accu1.into(), place: to, width: Width::QuadWord, on_fault: OnFault::DeliverZero });
                builder.begin_statement();
                builder.store(fixed(BitMemory, 1600 + 64 * index as u32), Width::QuadWord, Register::Accu1);
            }
        })],
        &|machine| {
            let at = machine.memory.layout.bit_memory.start;
            machine.memory.write_wide(at, 0, Width::QuadWord, 0x0123_4567_89AB_CDEF);
            machine.memory.write_wide(at + 500, 0, Width::QuadWord, 0xFFFF_FFFF_0000_0001);
        },
        &|_, _, _| Reaction::Continue,
    );
    let copies = outcome.arena.windows(8).filter(|bytes| *bytes == 0x0123_4567_89AB_CDEF_u64.to_be_bytes()).count();
    assert!(copies >= 12, "{copies} copies");
    assert!(outcome.asked.iter().filter(|what| what.contains("Programming")).count() >= 8, "{:?}", outcome.asked);
}
