//! The CPU with an engine, which is `LOAD` of the file that includes this one: what both must agree on.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_cpu::{Cpu, OperatingMode, Rack, Restart, Settings, Station};
use sieben_engine::ir::{Builder, Callee, Inst, OnFault, Op, Place};
use sieben_engine::machine::Register;
use sieben_engine::{CodeBlock, Program};
use sieben_model::address::{Area, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;

fn store(builder: &mut Builder, area: Area, byte: u32, value: u64) {
    builder.begin_statement();
    let value = builder.constant(value);
    builder.store(Place::Fixed { area, position: byte * 8 }, Width::Byte, value);
}

fn copy(builder: &mut Builder, from: (Area, u32), to: (Area, u32)) {
    builder.begin_statement();
    let value = builder.load(Place::Fixed { area: from.0, position: from.1 * 8 }, Width::Byte, OnFault::DeliverZero);
    builder.store(Place::Fixed { area: to.0, position: to.1 * 8 }, Width::Byte, value);
}

fn call(builder: &mut Builder, block: BlockId) {
    builder.begin_statement();
    builder.push(Inst::Call { callee: Callee::Block(block), parameters: 0 });
}

const fn sfc(number: u16) -> BlockId {
    BlockId::new(BlockKind::SystemFunction, number)
}

/// Builds the statements of a block.
type Build<'a> = &'a dyn Fn(&mut Builder);

fn cpu(blocks: &[(u16, Build<'_>)]) -> Cpu {
    let code: BTreeMap<BlockId, CodeBlock> = blocks
        .iter()
        .map(|(number, build)| {
            let mut builder = Builder::default();
            build(&mut builder);
            (BlockId::ob(*number), CodeBlock { code: builder.finish(), local_size: 20, ..CodeBlock::default() })
        })
        .collect();
    let program = Arc::new(Program { code, ..Program::default() });
    let cpu_type = CpuType::by_name("315-2PN/DP").expect("a CPU type");
    let settings = Settings { virtual_safe_points: 10_000, ..Settings::default() };
    let mut cpu = Cpu::load(cpu_type, program, super::LOAD, Rack::simulated(cpu_type), settings);
    cpu.restart(Restart::Warm);
    cpu.scan(0);
    cpu
}

fn read(cpu: &Cpu, text: &str) -> u32 {
    cpu.read(&Operand::parse(text).expect("an operand")).expect("a value")
}

/// Mode, event of the STOP, first cause, block and statement (from 1).
fn outcome(cpu: &Cpu) -> Option<(u16, u16, String)> {
    let cause = Cpu::stop_cause(cpu)?;
    let place = cause.place.map_or(String::new(), sieben_cpu::diagnostic_buffer::place_text);
    Some((cause.event, cause.first_event, place))
}

#[test]
fn a_program_sees_inputs_start_information_and_its_errors() {
    let cpu = cpu(&[
        (1, &|builder| {
            copy(builder, (Area::Local, 1), (Area::Output, 0));
            call(builder, BlockId::fc(7));
            store(builder, Area::Output, 1, 5);
            store(builder, Area::PeripheralOutput, 2, 6);
        }),
        (100, &|builder| store(builder, Area::BitMemory, 9, 9)),
        (121, &|builder| copy(builder, (Area::Local, 1), (Area::BitMemory, 0))),
    ]);
    assert_eq!(cpu.mode(), OperatingMode::Run);
    assert_eq!(["QB0", "QB1", "QB2", "PQB2", "MB0", "MB9"].map(|text| read(&cpu, text)), [1, 5, 6, 6, 0x3C, 9]);
    assert_eq!(cpu.diagnostic_buffer().newest().expect("an entry").text(), "the FC is not loaded: FC 7 (OB 1, statement 2)");
}

#[test]
fn a_stop_names_block_and_statement() {
    let cases: [(Build, u16, u16, &str); 5] = [
        (&|builder| call(builder, BlockId::fc(7)), 0x4562, 0x253C, "OB 1, statement 2"),
        (&|builder| call(builder, sfc(46)), 0x457F, 0x457F, "OB 1, statement 2"),
        (&|builder| call(builder, sfc(999)), 0x4562, 0x253D, "OB 1, statement 2"),
        (&|builder| copy(builder, (Area::PeripheralInput, 2048), (Area::BitMemory, 0)), 0x4563, 0x2942, "OB 1, statement 2"),
        (
            &|builder| {
                let to = builder.begin_statement();
                builder.push(Inst::Jump { to });
            },
            0x4568,
            0x3501,
            "OB 1, statement 2",
        ),
    ];
    for (number, (build, event, first, place)) in cases.into_iter().enumerate() {
        let program = |builder: &mut Builder| {
            store(builder, Area::BitMemory, 0, 1);
            build(builder);
        };
        assert_eq!(outcome(&cpu(&[(1, &program)])), Some((event, first, place.to_owned())), "case {number}");
    }
}

#[test]
fn re_trigr_keeps_the_watchdog_quiet_for_ever() {
    let cpu = cpu(&[(1, &|builder| {
        // 25,000 rounds in one scan, far beyond the limit of safe points.
        builder.begin_statement();
        builder.set(Register::Accu1, 25_000);
        let again = builder.begin_statement();
        builder.push(Inst::Call { callee: Callee::Block(sfc(43)), parameters: 0 });
        builder.begin_statement();
        let one = builder.constant(1);
        builder.compute_into(Register::Accu1, Op::SubU32, &[Register::Accu1.into(), one]);
        let rest = builder.compute(Op::NeI32, &[Register::Accu1.into(), one]);
        builder.push(Inst::Branch { condition: rest, to: again });
    })]);
    assert_eq!((cpu.mode(), cpu.registers().accu1), (OperatingMode::Run, 1));
}

#[test]
fn an_endless_loop_of_many_statements_is_stopped_as_soon_as_a_short_one() {
    let cpu = cpu(&[(1, &|builder| {
        let again = builder.begin_statement();
        let one = builder.constant(1);
        builder.compute_into(Register::Accu1, Op::AddU32, &[Register::Accu1.into(), one]);
        for _ in 0..6399 {
            builder.begin_statement();
        }
        builder.begin_statement();
        builder.push(Inst::Jump { to: again });
    })]);
    // 10,000 / (1 + 6400 / 64): entering the block takes as much as one round.
    assert_eq!((cpu.mode(), cpu.registers().accu1), (OperatingMode::Stop, 10_000 / 101));
}
