//! Every row of the table of operations means the same in the interpreter, called from machine code, and as machine code.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_engine::ir::{Builder, Op, Var};
use sieben_engine::machine::{Register, Registers};
use sieben_engine::{CodeBlock, Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Program, Reaction};
use sieben_jit::{Jit, StatusBits};
use sieben_model::address::Width;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;

/// Values at which something changes for one of the operations.
const EDGES: &[u64] = &[
    0,
    1,
    2,
    3,
    7,
    8,
    15,
    16,
    17,
    31,
    32,
    33,
    0x66,
    0x7F,
    0x80,
    0x86,
    0xFF,
    0x100,
    0x0999,
    0x099A,
    0x7FFF,
    0x8000,
    0x8999,
    0xFFFF,
    0x1_0000,
    0x0999_9999,
    0x3F80_0000,
    0x4040_0000,
    0x7F7F_FFFF,
    0x7F80_0000,
    0x7FC0_0000,
    0x7FFF_FFFF,
    0x8700_0008,
    0x87F0_0010,
    0x87F8_0000,
    0x8000_0000,
    0x8000_0001,
    0xBF80_0000,
    0xCF00_0000,
    0x4F00_0000,
    0xFF80_0000,
    0xFFFF_8000,
    0xFFFF_FFFF,
    0x1_0000_0000,
    0x8086_0000_0000_0000,
    0x7FFF_FFFF_FFFF_FFFF,
    0xFFFF_FFFF_8000_0000,
    // LREAL: 0.5, 1.5, −2.5, 300.5, −1.0E10, 1.0E300, infinite, no number.
    0x3FE0_0000_0000_0000,
    0x3FF8_0000_0000_0000,
    0xC004_0000_0000_0000,
    0x4072_C800_0000_0000,
    0xC202_A05F_2000_0000,
    0x7E37_E43C_8800_759C,
    0x7FF0_0000_0000_0000,
    0x7FF8_0000_0000_0000,
    0x8000_0000_0000_0000,
    // 2.5, 8388607.5 and no number with its own bits, as REAL and as LREAL; BCD with digits above 9.
    0x4020_0000,
    0x4AFF_FFFF,
    0xBF00_0000,
    0x7F80_0001,
    0xFFC0_0001,
    0x4320_0000_0000_0001,
    0x7FF0_0000_0000_0001,
    0xFFF8_0000_0000_0001,
    0xF123,
    0x90A9,
    0xF765_4321,
    0x0A00_0009,
    9_999_999,
    10_000_000,
    999,
    1_000,
    u64::MAX,
];

/// The arguments of an operation stand in registers that take 64 bits.
const ARGUMENTS: [Register; 4] = [Register::Mcr, Register::DbNumber, Register::DiNumber, Register::Accu4];
/// Its result does, too.
const RESULT: Register = Register::Nesting;

/// Second to fourth arguments that are known when the program is compiled.
const CONSTANTS: [[u64; 3]; 6] = [[1, 0, 1], [0, 1, 0], [16, 0xFFFF_FFFF, 1], [0x8000, 31, 0], [0xFFFF_FFFF, 5, 1], [32, 17, 33]];

/// A Host that nobody asks.
struct Nobody;

impl Host for Nobody {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, _: FaultPlace) -> Reaction {
        unreachable!("{fault:?}")
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

/// OB n computes operation n − 1; OB n + 1000 with constants as the second and following arguments.
fn program(constants: [u64; 3]) -> Program {
    let mut code = BTreeMap::new();
    for (index, &op) in Op::ALL.iter().enumerate() {
        for with_constants in [false, true] {
            let mut builder = Builder::default();
            builder.begin_statement();
            let mut arguments: Vec<Var> = ARGUMENTS[..op.arity()].iter().map(|&register| register.into()).collect();
            if with_constants {
                for (argument, value) in arguments.iter_mut().skip(1).zip(constants) {
                    *argument = builder.constant(value);
                }
            }
            builder.compute_into(RESULT, op, &arguments);
            let number = 1 + index as u16 + if with_constants { 1000 } else { 0 };
            code.insert(BlockId::ob(number), CodeBlock { code: builder.finish(), ..CodeBlock::default() });
        }
    }
    Program { code, ..Program::default() }
}

fn result(engine: &dyn Engine, machine: &mut Machine, block: u16, arguments: [u64; 4]) -> u64 {
    let mut registers = Registers::fresh();
    for (register, value) in ARGUMENTS.into_iter().zip(arguments) {
        registers.set(register, value);
    }
    machine.budget = 1 << 40;
    let entry = Entry { block: BlockId::ob(block), start_information: [0; 20], registers: Some(Box::new(registers)) };
    let exit = engine.run(&mut Context { machine, host: &mut Nobody, tracer: None }, &entry);
    assert_eq!(exit, Exit::Finished);
    machine.registers.get(RESULT)
}

#[test]
fn engines_agree_on_every_operation() {
    let cpu = &CpuType::ALL[0];
    let mut compared = 0;
    let mut wrong = Vec::new();
    for constants in CONSTANTS {
        let program = program(constants);
        let layout = Arc::new(Layout::new(cpu, &program));
        let engines =
            [Jit::compiled(&program, &layout, StatusBits::All).expect("machine code"), Jit::load_without_inlining(&program, &layout)];
        assert!(engines.iter().all(|engine| engine.code_bytes() > 0));
        let interpreter = Interpreter::load(&program, &layout);
        let mut machine = Machine::new(Arc::clone(&layout));
        for (index, &op) in Op::ALL.iter().enumerate() {
            let one = &EDGES[..1];
            let [second, third, fourth] = [1, 2, 3].map(|place| if op.arity() > place { EDGES } else { one });
            // The third and fourth argument are bits, counts or what stays as it was: a few values show all of it.
            let few = |edges: &'static [u64], step: usize| edges.iter().copied().step_by(step);
            for &a in EDGES {
                // The pairs are the same whatever the constants.
                for &b in second.iter().filter(|_| constants == CONSTANTS[0]) {
                    for c in few(third, 7) {
                        for d in few(fourth, 22) {
                            let block = 1 + index as u16;
                            let expected = op.eval([a, b, c, d]);
                            for (number, engine) in engines.iter().chain([&interpreter]).enumerate() {
                                let got = result(engine.as_ref(), &mut machine, block, [a, b, c, d]);
                                if got != expected && wrong.len() < 20 {
                                    wrong.push(format!("{} {a:X} {b:X} {c:X} {d:X}: engine {number} {got:X}, not {expected:X}", op.name()));
                                }
                                compared += 1;
                            }
                        }
                    }
                }
                let expected = op.eval([a, constants[0], constants[1], constants[2]]);
                for (number, engine) in engines.iter().chain([&interpreter]).enumerate() {
                    let got = result(engine.as_ref(), &mut machine, 1001 + index as u16, [a, 0, 0, 0]);
                    if got != expected && wrong.len() < 20 {
                        wrong.push(format!("{} {a:X} with {constants:X?}: engine {number} {got:X}, not {expected:X}", op.name()));
                    }
                    compared += 1;
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(compared > 100_000, "{compared} comparisons");
}
