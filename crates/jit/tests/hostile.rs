//! Programs built to hurt a compiler become machine code within bounded time and memory, or stay in the interpreter.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use sieben_engine::ir::{Builder, Callee, DataRegister, Inst, OnFault, Op, Place, Target};
use sieben_engine::machine::Register;
use sieben_engine::{CodeBlock, Entry, Interpreter, Layout, Machine, Program, Reaction};
use sieben_jit::{Jit, StatusBits, Tier, Tiers};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;

use crate::noting;

/// Far more than any of them takes, also on a busy machine and without optimization.
const LIMIT: Duration = Duration::from_secs(60);

fn bit(builder: &mut Builder, number: u32) {
    let place = Place::Fixed { area: Area::BitMemory, position: number % 2_000 };
    builder.push(Inst::Load { dst: Register::Sta.into(), place, width: Width::Bit, on_fault: OnFault::SkipStatement });
    let [rlo, sta, fc] = [Register::Rlo, Register::Sta, Register::Fc].map(Into::into);
    builder.compute_into(Register::Rlo, Op::ScanXor, &[rlo, sta, fc]);
    builder.compute_into(Register::Os, Op::Or, &[Register::Os.into(), rlo]);
}

fn program(blocks: u16, build: &dyn Fn(&mut Builder)) -> Program {
    let mut code = BTreeMap::new();
    for number in 1..=blocks {
        let mut builder = Builder::default();
        build(&mut builder);
        let id = if number == 1 { BlockId::ob(1) } else { BlockId::fc(number) };
        code.insert(id, CodeBlock { code: builder.finish(), local_size: 20, ..CodeBlock::default() });
    }
    Program { code, ..Program::default() }
}

fn in_time(name: &str, program: &Program) {
    let layout = Layout::new(&CpuType::ALL[0], program);
    #[allow(clippy::disallowed_methods)] // What is measured is the compiler's time.
    let started = Instant::now();
    let result = Jit::compiled(program, &layout, StatusBits::Needed);
    let time = started.elapsed();
    assert!(time < LIMIT, "{name} took {time:?}");
    if let Err(reason) = result {
        assert!(!reason.is_empty(), "{name} says why it stays in the interpreter");
    }
}

#[test]
fn one_long_network() {
    in_time(
        "100,000 statements",
        &program(1, &|builder| {
            for number in 0..100_000 {
                builder.begin_statement();
                bit(builder, number);
            }
        }),
    );
}

/// What a long block of Structured Text consists of: bits of an instance.
#[test]
fn many_computed_addresses() {
    in_time(
        "12,000 bits at computed addresses",
        &program(1, &|builder| {
            for number in 0..3_000 {
                builder.begin_statement();
                let place = |bit: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: bit % 600 };
                let mut sum = builder.load(place(number), Width::Bit, OnFault::SkipStatement);
                for step in 1..3 {
                    let bit = builder.load(place(number * 7 + step * 50), Width::Bit, OnFault::SkipStatement);
                    sum = builder.compute(Op::Xor, &[sum, bit]);
                }
                builder.store(place(number + 1), Width::Bit, sum);
            }
        }),
    );
}

#[test]
fn values_of_a_long_block_share_their_places_on_the_stack() {
    let place = |bit: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: bit % 120 };
    let program = noting::program(&[(BlockId::ob(1), 20, &|builder| {
        builder.begin_statement();
        let number = builder.constant(1);
        builder.push(Inst::Open { register: DataRegister::Instance, number });
        for number in 0..600 {
            builder.begin_statement();
            let mut sum = builder.load(place(number), Width::Bit, OnFault::SkipStatement);
            for step in 1..4 {
                let bit = builder.load(place(number * 7 + step * 50), Width::Bit, OnFault::SkipStatement);
                sum = builder.compute(Op::Xor, &[sum, bit]);
            }
            builder.store(place(number + 1), Width::Bit, sum);
        }
    })]);
    let layout = noting::layout(&program);
    let tiers = Tiers::load(&program, &layout, StatusBits::All);
    assert_eq!(tiers.compile(Tier::Quick), Ok(()));
    let engines = [tiers.engine(), Interpreter::load(&program, &layout)];
    let [got, expected] = engines.map(|engine| {
        let fill = |machine: &mut Machine| {
            machine.budget = 1 << 20;
            let bytes = machine.memory.arena.iter_mut().rev().take(64);
            (0..).zip(bytes).for_each(|(at, byte)| *byte = (at * 37 + 11) as u8);
        };
        noting::run(&*engine, &layout, &Entry { block: BlockId::ob(1), start_information: [7; 20], registers: None }, &fill, &|_, _, _| {
            Reaction::Continue
        })
    });
    got.assert_ends_as(&expected, &|| "one long block".to_owned());
    assert_eq!(got.registers, expected.registers);
    assert_eq!(got.asked.len(), 0);
}

/// Each statement of the second half jumps back to a label of its own, the last to the first.
fn loops(labels: u32) -> Program {
    program(1, &|builder| {
        for number in 0..2 * labels {
            builder.begin_statement();
            bit(builder, number);
            if number >= labels {
                builder.push(Inst::Branch { condition: Register::Rlo.into(), to: Target(2 * labels - 1 - number) });
            }
        }
    })
}

#[test]
fn many_labels() {
    in_time("30 loops in one another", &loops(30));
    in_time("900 loops in one another", &loops(900));
    in_time("30,000 loops in one another", &loops(30_000));
}

#[test]
fn many_blocks() {
    in_time(
        "3,000 blocks",
        &program(3_000, &|builder| {
            builder.begin_statement();
            bit(builder, 1);
        }),
    );
}

/// A release build needs milliseconds; here others run beside it, without optimization.
const LOAD_LIMIT: Duration = Duration::from_secs(5);

#[test]
fn the_first_scan_waits_for_no_compiler() {
    let network = program(1, &|builder| {
        for number in 0..100_000 {
            builder.begin_statement();
            bit(builder, number);
        }
    });
    let blocks = program(20_000, &|builder| {
        builder.begin_statement();
        bit(builder, 1);
    });
    for (name, program) in [("one network", network), ("30,000 labels", loops(30_000)), ("20,000 blocks", blocks)] {
        let layout = Layout::new(&CpuType::ALL[0], &program);
        #[allow(clippy::disallowed_methods)] // What is measured is the time until the first scan.
        let started = Instant::now();
        let tiers = Tiers::load(&program, &layout, StatusBits::Needed);
        let time = started.elapsed();
        assert!(time < LOAD_LIMIT, "{name}: loaded after {time:?}");
        assert_eq!(tiers.tier(), Tier::Interpreter);
        assert_eq!(tiers.engine().code_bytes(), 0);
        // What is refused is refused at once, and says why.
        if let Some(reason) = tiers.refusal() {
            assert_eq!(tiers.compile(Tier::Quick), Err(reason.to_owned()), "{name}");
            assert_eq!(tiers.tier(), Tier::Interpreter);
        }
    }
}

#[test]
fn what_is_too_large_says_so() {
    let program = program(1, &|builder| {
        for _ in 0..250_000 {
            builder.begin_statement();
            builder.set(Register::Rlo, 1);
        }
    });
    let layout = Layout::new(&CpuType::ALL[0], &program);
    let refused = Jit::compiled(&program, &layout, StatusBits::All).err().expect("too large");
    assert!(refused.contains("250001 statements"), "{refused}");
    let refused = Jit::compiled(&loops(1_001), &layout, StatusBits::All).err().expect("too many loops");
    assert!(refused.contains("1001 places"), "{refused}");
    assert_eq!(Jit::load(&program, &layout).code_bytes(), 0, "it is interpreted");
}

/// So many blocks that call one another, each with statements that may fail; the first one has so many calls.
fn nested_calls(depth: u16, calls: u32) -> Program {
    let block = |number: u16| {
        let mut builder = Builder::default();
        for statement in 0..20 {
            builder.begin_statement();
            let from = Place::Fixed { area: Area::SharedData, position: 8 * (statement + 20 * u32::from(number)) };
            let byte = builder.load(from, Width::Byte, OnFault::SkipStatement);
            builder.store(Place::Fixed { area: Area::BitMemory, position: 8 * statement }, Width::Byte, byte);
        }
        let calls = match number {
            0 => calls,
            _ => u32::from(number < depth),
        };
        for _ in 0..calls {
            builder.begin_statement();
            let pointer = builder.constant(0x8300_0000);
            builder.push(Inst::PassParameter { src: pointer });
            builder.push(Inst::Call { callee: Callee::Block(BlockId::fc(number + 1)), parameters: 1 });
        }
        let id = if number == 0 { BlockId::ob(1) } else { BlockId::fc(number) };
        (id, CodeBlock { code: builder.finish(), local_size: 20, ..CodeBlock::default() })
    };
    Program { code: (0..=depth).map(block).collect(), ..Program::default() }
}

/// A statement that fails in a block that was inlined six deep shows the activations of all six.
#[test]
fn many_statements_that_fail_in_nested_calls() {
    in_time("200 calls, each six deep", &nested_calls(6, 200));
    in_time("40 calls, each sixteen deep", &nested_calls(16, 40));
    // Few instructions that become many have room for their code.
    let program = nested_calls(6, 10);
    let layout = Layout::new(&CpuType::ALL[0], &program);
    assert!(Jit::compiled(&program, &layout, StatusBits::Needed).is_ok_and(|engine| engine.code_bytes() > 1 << 20));
}
