//! Timers and counters mean the same in the interpreter, asked for by machine code, and as machine code: over a grid of states,
//! inputs and clocks.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::Builder;
use sieben_engine::machine::{Counter, Register, Registers, Timer, TimerKind};
use sieben_engine::{CodeBlock, Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Program, Reaction};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::Width;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;

const KINDS: [TimerKind; 5] =
    [TimerKind::Pulse, TimerKind::ExtendedPulse, TimerKind::OnDelay, TimerKind::RetentiveOnDelay, TimerKind::OffDelay];

/// All of them.
fn intrinsics() -> Vec<Intrinsic> {
    use Intrinsic as I;
    let others = [
        I::TimerReset,
        I::TimerEnable,
        I::TimerStatus,
        I::TimerValue,
        I::TimerBcd,
        I::CounterUp,
        I::CounterDown,
        I::CounterSet,
        I::CounterReset,
        I::CounterEnable,
        I::CounterStatus,
        I::CounterValue,
        I::CounterBcd,
    ];
    KINDS.map(I::TimerStart).into_iter().chain(others).collect()
}

/// Presets: 0, usual ones, the greatest, and digits that there are not.
const WORDS: [u16; 6] = [0, 0x0001, 0x1050, 0x3999, 0xF999, 0x20A0];
/// The timer or counter.
const NUMBER: u16 = 5;
/// One that no CPU has.
const MISSING: u16 = 40_000;
const NOW_US: u64 = 20_000_000_000;

/// A Host that counts what fails and lets the program go on.
#[derive(Default)]
struct Faults(Vec<Fault>);

impl Host for Faults {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, _: FaultPlace) -> Reaction {
        self.0.push(*fault);
        Reaction::Continue
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        None
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        false
    }
    fn safe_point(&mut self, machine: &mut Machine, _: FaultPlace) -> Reaction {
        machine.budget = 1 << 40;
        Reaction::Continue
    }
    fn system_function(&mut self, _: &mut Machine, _: BlockId, _: usize) -> Reaction {
        Reaction::Continue
    }
}

/// How a block gets number, RLO and word: 0 = all from registers; 1 = number and word known; 2 and 3 = the RLO too.
const FORMS: u16 = 4;

/// One organization block for each intrinsic, form and word, its number as [`block`] says.
fn program() -> Program {
    let mut code = BTreeMap::new();
    for (index, intrinsic) in intrinsics().into_iter().enumerate() {
        for form in 0..FORMS {
            for (word_index, &word) in WORDS.iter().enumerate() {
                let mut builder = Builder::default();
                builder.begin_statement();
                let mut arguments = [Register::Accu3.into(), Register::Rlo.into(), Register::Accu2.into()];
                if form > 0 {
                    arguments[0] = builder.constant(u64::from(NUMBER));
                    arguments[2] = builder.constant(u64::from(word));
                }
                if form > 1 {
                    arguments[1] = builder.constant(u64::from(form - 2));
                }
                let result = builder.intrinsic(intrinsic, &arguments[..intrinsic.arity()]);
                builder.copy(Register::Accu1, result);
                code.insert(block(index, form, word_index), CodeBlock { code: builder.finish(), ..CodeBlock::default() });
            }
        }
    }
    Program { code, ..Program::default() }
}

fn block(intrinsic: usize, form: u16, word: usize) -> BlockId {
    BlockId::ob(1 + ((intrinsic as u16 * FORMS) + form) * WORDS.len() as u16 + word as u16)
}

/// States of a timer: whatever its fields can be, in the combinations that a program can bring about and some that it cannot.
fn timers() -> Vec<Timer> {
    let mut timers = Vec::new();
    for kind in KINDS {
        for bits in 0..8_u8 {
            let [running, status, start_edge] = [0, 1, 2].map(|bit| bits >> bit & 1 != 0);
            for (value, base) in [(0, 0), (1, 0), (999, 0), (20, 1), (3, 2), (999, 3), (65_535, 3)] {
                let whole = u64::from(value) * [10_000, 100_000, 1_000_000, 10_000_000][usize::from(base)];
                for gone in [0, 1, whole / 2, whole.saturating_sub(1), whole, whole + 1] {
                    let started_us = NOW_US.saturating_sub(gone);
                    let enable_edge = bits & 1 != 0;
                    timers.push(Timer { kind, running, status, value, base, started_us, start_edge, enable_edge });
                }
            }
        }
    }
    // The clock was set back, or the timer comes from a retentive image of another time.
    timers.push(Timer { running: true, value: 7, started_us: NOW_US + 5, ..Timer::default() });
    timers.push(Timer { running: true, value: 7, started_us: 0, ..Timer::default() });
    timers
}

fn counters() -> Vec<Counter> {
    let mut counters = Vec::new();
    for count in [0, 1, 500, 998, 999, 1000, 65_535] {
        for bits in 0..16_u8 {
            let [set_edge, up_edge, down_edge, enable_edge] = [0, 1, 2, 3].map(|bit| bits >> bit & 1 != 0);
            counters.push(Counter { count, set_edge, up_edge, down_edge, enable_edge });
        }
    }
    counters
}

/// What a run leaves: the timer or counter, the result, what failed.
type Left = (Timer, Counter, u64, Vec<Fault>);

fn left(engine: &dyn Engine, machine: &mut Machine, block: BlockId, state: &(Timer, Counter), inputs: (u16, u64, u16)) -> Left {
    let (number, rlo, word) = inputs;
    let at = usize::from(NUMBER);
    (machine.timers[at], machine.counters[at]) = state.clone();
    let registers = Registers { accu1: 77, accu2: u64::from(word) | 0xABCD_0000, accu3: u64::from(number), rlo, ..Registers::fresh() };
    (machine.budget, machine.clock_us) = (1 << 40, NOW_US);
    let entry = Entry { block, start_information: [0; 20], registers: Some(Box::new(registers)) };
    let mut host = Faults::default();
    let exit = engine.run(&mut Context { machine, host: &mut host, tracer: None }, &entry);
    assert_eq!(exit, Exit::Finished);
    (machine.timers[at].clone(), machine.counters[at].clone(), machine.registers.accu1, host.0)
}

#[test]
fn engines_agree_on_every_timer_and_counter() {
    let program = program();
    let layout = Arc::new(Layout::new(&CpuType::ALL[0], &program));
    let engines = [
        Jit::compiled(&program, &layout, StatusBits::All).expect("machine code"),
        Jit::compiled(&program, &layout, StatusBits::Needed).expect("machine code"),
        Jit::load_without_inlining(&program, &layout),
    ];
    assert!(engines.iter().all(|engine| engine.code_bytes() > 0));
    let interpreter = Interpreter::load(&program, &layout);
    let mut machine = Machine::new(Arc::clone(&layout));
    let states: Vec<(Timer, Counter)> = {
        let (timers, counters) = (timers(), counters());
        (0..timers.len().max(counters.len()))
            .map(|index| (timers[index % timers.len()].clone(), counters[index % counters.len()].clone()))
            .collect()
    };
    let (mut compared, mut failed) = (0, 0);
    for (index, intrinsic) in intrinsics().into_iter().enumerate() {
        for form in 0..FORMS {
            // The word of a register does not depend on the block.
            for (word_index, &word) in WORDS.iter().enumerate().take(if intrinsic.arity() > 2 { WORDS.len() } else { 1 }) {
                let block = block(index, form, word_index);
                let numbers: &[u16] = if form == 0 { &[NUMBER, MISSING] } else { &[NUMBER] };
                for &number in numbers {
                    for rlo in [0, 1] {
                        for state in &states {
                            let inputs = (number, rlo, word);
                            let expected = left(interpreter.as_ref(), &mut machine, block, state, inputs);
                            failed += usize::from(!expected.3.is_empty());
                            for (engine_index, engine) in engines.iter().enumerate() {
                                let got = left(engine.as_ref(), &mut machine, block, state, inputs);
                                assert_eq!(got, expected, "engine {engine_index}: {intrinsic:?}, form {form}, {inputs:X?} at {state:?}");
                                compared += 1;
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(compared > 100_000 && failed > 1_000, "{compared} comparisons, {failed} of statements that fail");
}
