//! The status row of every instruction is what the instruction does, in both directions; with the engine that `LOAD` makes.

use std::sync::Arc;

use sieben_engine::machine::{Registers, StatusWord};
use sieben_engine::{Context, Engine, Entry, Exit, Layout, Machine, Program};
use sieben_lang::stl::instructions::{Effect, Instruction, STATUS_COLUMNS};
use sieben_lang::stl::lower::{ResolvedBlock, Statement, lower};
use sieben_lang::stl::operands::{Access, BlockOperand, Call, DataBlockInfo, Location, NumberOperand, Operand, OperandClass, StatusScan};
use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::interface::Interface;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::origin::Origin;
use sieben_model::source::Span;

use super::strict::Strict;

/// Pairs of these stand in ACCU 1 and ACCU 2.
const EDGES: [u32; 16] = [
    0,
    1,
    2,
    0x21,
    0x4040_0000,
    0x0999,
    0x1A,
    0x7FFF,
    0x8000,
    0xFFFF,
    0x7FFF_FFFF,
    0x8000_0000,
    0xFFFF_FFFF,
    0x3F80_0000,
    0x7FC0_0000,
    0xFF7F_FFFF,
];

/// The statement that a label of the samples names: behind the jump and its list.
const LABEL: u32 = 4;

fn memory(width: Width) -> Operand {
    Operand::Memory(Access { width, location: Location::Fixed { area: Area::BitMemory, position: 80 } })
}

/// Operands that show what an instruction can do.
fn samples(instruction: Instruction) -> Vec<Operand> {
    let number = || NumberOperand::Fixed(1);
    let block = |kind, instance| Operand::Block(BlockOperand { kind, instance, number: NumberOperand::Fixed(1) });
    let pointer = || Operand::Constant(Value::Pointer(0x10));
    match instruction.operand() {
        OperandClass::None => vec![Operand::None],
        OperandClass::ScanBit => {
            vec![memory(Width::Bit), Operand::Timer(number()), Operand::Counter(number()), Operand::Status(StatusScan::Overflow)]
        }
        OperandClass::AssignBit => vec![memory(Width::Bit)],
        OperandClass::Load => {
            vec![memory(Width::Word), Operand::Constant(Value::Int(5)), Operand::Timer(number()), Operand::Counter(number())]
        }
        OperandClass::Transfer => vec![memory(Width::Word), memory(Width::DoubleWord)],
        OperandClass::StatusWord => vec![Operand::StatusWord],
        OperandClass::DataBlockInfo => {
            vec![Operand::DataBlockInfo(DataBlockInfo::SharedLength), Operand::DataBlockInfo(DataBlockInfo::InstanceNumber)]
        }
        OperandClass::Timer => vec![Operand::Timer(number())],
        OperandClass::Counter => vec![Operand::Counter(number())],
        OperandClass::TimerOrCounter => vec![Operand::Timer(number()), Operand::Counter(number())],
        OperandClass::PointerSource => vec![memory(Width::DoubleWord), pointer(), Operand::AddressRegister2],
        OperandClass::PointerSourceWithoutAr2 => vec![memory(Width::DoubleWord), pointer()],
        OperandClass::PointerTarget => vec![memory(Width::DoubleWord), Operand::AddressRegister2],
        OperandClass::PointerTargetWithoutAr2 => vec![memory(Width::DoubleWord)],
        OperandClass::OptionalPointerOffset => vec![Operand::None, pointer()],
        OperandClass::ByteConstant => vec![Operand::Constant(Value::Int(200))],
        OperandClass::IntConstant => vec![Operand::Constant(Value::Int(-7))],
        OperandClass::DoubleIntConstant => vec![Operand::Constant(Value::DoubleInt(-7))],
        OperandClass::ShiftCount16 => vec![Operand::None, Operand::Constant(Value::Int(0)), Operand::Constant(Value::Int(3))],
        OperandClass::ShiftCount32 => vec![Operand::None, Operand::Constant(Value::Int(31))],
        OperandClass::OptionalConstant16 => vec![Operand::None, Operand::Constant(Value::Word(0xFF))],
        OperandClass::OptionalConstant32 => vec![Operand::None, Operand::Constant(Value::DoubleWord(0xFF00))],
        OperandClass::Label => vec![Operand::Label(LABEL)],
        OperandClass::CallBlock => vec![block(BlockKind::Function, false)],
        OperandClass::Call => vec![Operand::Call(Box::new(Call { callee: BlockId::fc(1), instance: None, parameters: Vec::new() }))],
        OperandClass::OpenBlock => {
            vec![Operand::Block(BlockOperand { kind: BlockKind::DataBlock, instance: true, number: NumberOperand::Fixed(0) })]
        }
        // The extension words are no instructions of a CPU: they are not among the rows.
        OperandClass::Extension => Vec::new(),
        OperandClass::Zero => vec![Operand::Constant(Value::Int(0))],
        OperandClass::One => vec![Operand::Constant(Value::Int(1))],
    }
}

fn statement(instruction: Instruction, operand: Operand) -> Statement {
    Statement { instruction, operand, origin: Origin::Text { span: Span::default(), network: 1 }, stated: None }
}

/// Where an instruction stands when its effect is measured behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Frame {
    /// In OB 1, a list of jumps and a label behind it.
    Main,
    /// In FC 1, measured behind the call: what a block end does.
    Callee,
}

/// A block end in OB 1 has no effect that anyone could see.
fn frames(instruction: Instruction) -> &'static [Frame] {
    match instruction {
        Instruction::BlockEnd | Instruction::BlockEndUnconditional => &[Frame::Callee],
        Instruction::BlockEndConditional => &[Frame::Main, Frame::Callee],
        _ => &[Frame::Main],
    }
}

fn program(instruction: Instruction, operand: &Operand, frame: Frame, cpu: &CpuType) -> Program {
    let nothing = || statement(Instruction::Nop0, Operand::Constant(Value::Int(0)));
    let measured = statement(instruction, operand.clone());
    let (mut main, callee) = match frame {
        Frame::Main => (vec![measured], vec![nothing()]),
        Frame::Callee => {
            (vec![statement(Instruction::CallUnconditional, samples(Instruction::CallUnconditional).remove(0))], vec![measured])
        }
    };
    if instruction == Instruction::JumpList {
        main.extend((0..3).map(|_| statement(Instruction::Jump, Operand::Label(LABEL))));
    }
    main.resize_with(LABEL as usize + 1, nothing);
    let mut program = Program::default();
    for (id, statements) in [(BlockId::ob(1), main), (BlockId::fc(1), callee)] {
        program.code.insert(id, lower(&ResolvedBlock { id, interface: Interface::default(), statements, titles: Vec::new() }, cpu));
    }
    program
}

/// Runs one instruction; `None` if it failed.
fn after(engine: &dyn Engine, machine: &mut Machine, before: &Registers) -> Option<Registers> {
    let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: Some(Box::new(before.clone())) };
    let exit = engine.run(&mut Context { machine, host: &mut Strict, tracer: None }, &entry);
    (exit == Exit::Finished).then(|| machine.registers.clone())
}

#[test]
fn status_rows_are_true() {
    let mut wrong = Vec::new();
    for &instruction in Instruction::ALL {
        let mut seen = [[false; 2]; 9];
        let opens_bracket = matches!(instruction.english(), "A(" | "AN(" | "O(" | "ON(" | "X(" | "XN(");
        for cpu in ["315-2PN/DP", "416-3"].map(|name| CpuType::by_name(name).expect("a CPU type of the table")) {
            for (operand, &frame) in
                samples(instruction).iter().flat_map(|operand| frames(instruction).iter().map(move |frame| (operand, frame)))
            {
                let program = program(instruction, operand, frame, cpu);
                let layout = Arc::new(Layout::new(cpu, &program));
                let engine = super::LOAD(&program, &layout);
                let mut machine = Machine::new(layout);
                for status in 0..512_u16 {
                    for pair in 0..EDGES.len() * EDGES.len() {
                        // Every pair meets some status words and every status word some pairs.
                        if (pair * 7 + usize::from(status)) % 16 != 0 {
                            continue;
                        }
                        let (a, b) = (EDGES[pair / EDGES.len()], EDGES[pair % EDGES.len()]);
                        let mut before = Registers { accu1: u64::from(a), accu2: u64::from(b), ..Registers::fresh() };
                        before.set_status(StatusWord(status));
                        if frame == Frame::Main && instruction == Instruction::BlockEndConditional && before.rlo == 1 {
                            continue;
                        }
                        before.nesting = if opens_bracket { 0 } else { 0x80 | (pair as u64 & 0x0F) | (pair as u64 % 6) << 4 };
                        before.mcr = 0b11;
                        machine.memory.area_mut(Area::BitMemory)[10] = (pair & 1) as u8;
                        machine.timers[1] = Default::default();
                        machine.timers[1].status = pair & 2 != 0;
                        machine.counters[1].count = (pair & 1) as u16;
                        let Some(after) = after(engine.as_ref(), &mut machine, &before) else { continue };
                        for (column, (&bit, effect)) in STATUS_COLUMNS.iter().zip(instruction.status()).enumerate() {
                            let (was, is) = (before.get(bit), after.get(bit));
                            seen[column][usize::from(is == 1)] = true;
                            let right = match effect {
                                Effect::Unaffected => was == is,
                                Effect::Cleared => is == 0,
                                Effect::SetTo1 => is == 1,
                                Effect::Written => is <= 1,
                            };
                            if !right && wrong.len() < 20 {
                                wrong.push(format!("{instruction:?} on {}: {} became {is}", before.status(), bit.name()));
                            }
                        }
                    }
                }
            }
        }
        for (column, effect) in instruction.status().into_iter().enumerate() {
            if effect == Effect::Written && seen[column] != [true; 2] {
                wrong.push(format!("{instruction:?} writes {} but only one value was seen", STATUS_COLUMNS[column].name()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_code_of_every_instruction_keeps_the_rules_of_the_ir() {
    for &instruction in Instruction::ALL {
        for cpu in CpuType::ALL {
            for (operand, &frame) in
                samples(instruction).iter().flat_map(|operand| frames(instruction).iter().map(move |frame| (operand, frame)))
            {
                for block in program(instruction, operand, frame, cpu).code.values() {
                    assert_eq!(sieben_engine::ir::verify(&block.code), Ok(()), "{instruction:?} {operand:?}\n{}", block.code);
                }
            }
        }
    }
}

#[test]
fn mnemonics_are_found_in_both_languages() {
    for &instruction in Instruction::ALL {
        for mnemonics in [Mnemonics::English, Mnemonics::German] {
            let word = instruction.mnemonic(mnemonics);
            assert!(Instruction::candidates(word, mnemonics).any(|found| found == instruction), "{word}");
            assert!(Instruction::candidates(&word.to_lowercase(), mnemonics).any(|found| found == instruction), "{word} in lower case");
        }
    }
}

#[test]
fn each_operand_selects_one_row_of_its_mnemonic() {
    for &instruction in Instruction::ALL {
        for operand in samples(instruction) {
            for mnemonics in [Mnemonics::English, Mnemonics::German] {
                let word = instruction.mnemonic(mnemonics);
                let rows: Vec<_> = Instruction::candidates(word, mnemonics).filter(|row| row.operand().accepts(&operand)).collect();
                // `LAR1` and `TAR1` have rows with and without operand, which exclude each other.
                assert_eq!(rows, [instruction], "`{word}` with {operand:?}");
            }
        }
    }
}

#[test]
fn every_row_rejects_operands_of_other_kinds() {
    let others = [
        Operand::Memory(Access { width: Width::Bit, location: Location::Fixed { area: Area::Input, position: 0 } }),
        Operand::Memory(Access { width: Width::Word, location: Location::Fixed { area: Area::Output, position: 0 } }),
        Operand::Timer(NumberOperand::Fixed(1)),
        Operand::Label(1),
        Operand::StatusWord,
        Operand::Constant(Value::DateAndTime([0; 8])),
    ];
    for &instruction in Instruction::ALL {
        let accepted = others.iter().filter(|operand| instruction.operand().accepts(operand)).count();
        assert!(accepted < 4, "{instruction:?} accepts {accepted} kinds");
        assert!(!instruction.operand().describe().is_empty());
    }
}
