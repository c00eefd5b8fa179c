//! What the table says a statement does with its operand is what its code does.

use std::collections::HashSet;

use sieben_engine::intrinsics::Intrinsic;
use sieben_engine::ir::{Inst, Var};
use sieben_engine::machine::Register;
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::operands::{Access, Direction, Location, NumberOperand, Operand, OperandClass};
use sieben_lang::{CheckedBody, Options, compile};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

/// What the instructions of a statement do: a value that only takes part in what is written back is not read.
fn direction(statement: &[Inst]) -> Option<Direction> {
    let mut from_operand: HashSet<Var> = HashSet::new();
    let (mut reads, mut writes) = (false, false);
    let mut take = |dst: Var, from_operand: &mut HashSet<Var>| match dst.register() {
        // STA only repeats the bit that was addressed; what goes on from there counts.
        Some(Register::Sta) | None => {
            from_operand.insert(dst);
        }
        Some(_) => reads = true,
    };
    for inst in statement {
        match *inst {
            Inst::Load { dst, .. } => take(dst, &mut from_operand),
            Inst::Compute { op, dst, args } if args[..op.arity()].iter().any(|arg| from_operand.contains(arg)) => {
                take(dst, &mut from_operand);
            }
            Inst::Store { .. } => writes = true,
            Inst::Intrinsic { dst, intrinsic, .. } => match intrinsic {
                Intrinsic::TimerStatus
                | Intrinsic::TimerValue
                | Intrinsic::TimerBcd
                | Intrinsic::CounterStatus
                | Intrinsic::CounterValue
                | Intrinsic::CounterBcd => take(dst, &mut from_operand),
                _ => writes = true,
            },
            _ => {}
        }
    }
    match (reads, writes) {
        (true, true) => Some(Direction::ReadWrite),
        (true, false) => Some(Direction::Read),
        (false, true) => Some(Direction::Write),
        (false, false) => None,
    }
}

/// Operands that instructions of a class with a direction take.
fn samples(class: OperandClass) -> &'static [&'static str] {
    match class {
        OperandClass::ScanBit => &["M 1.0", "T 1", "C 1"],
        OperandClass::AssignBit => &["M 1.0", "DBX 2.1"],
        OperandClass::Load => &["MB 2", "MW 2", "DBD 4", "T 1", "C 1"],
        OperandClass::Transfer => &["MB 2", "MW 2", "DBD 4"],
        OperandClass::Timer => &["T 1"],
        OperandClass::Counter => &["C 1"],
        OperandClass::TimerOrCounter => &["T 1", "C 1"],
        OperandClass::PointerSource
        | OperandClass::PointerSourceWithoutAr2
        | OperandClass::PointerTarget
        | OperandClass::PointerTargetWithoutAr2 => &["MD 4"],
        _ => &[],
    }
}

#[test]
fn the_direction_of_an_instruction_is_what_its_code_does() {
    let mut failures = Vec::new();
    for &instruction in Instruction::ALL.iter().filter(|instruction| instruction.direction().is_some()) {
        let samples = samples(instruction.operand());
        assert!(!samples.is_empty(), "{} has a direction and no sample", instruction.name());
        for sample in samples {
            let mut sources = Sources::default();
            sources.add("sample.awl", format!("      {} {sample}\n", instruction.english()));
            let options = Options { mnemonics: Some(Mnemonics::English), ..Options::default() };
            let compiled = compile(&sources, &SymbolTable::default(), &options);
            assert!(!compiled.has_errors(), "{} {sample}: {:?}", instruction.english(), compiled.diagnostics);
            let ob1 = BlockId::ob(1);
            let CheckedBody::Stl(block) = &*compiled.bodies[&ob1] else { unreachable!("the source is STL") };
            assert_eq!(block.statements[0].instruction, instruction, "{sample}");
            let does = direction(compiled.program.code[&ob1].code.statement(0));
            if does != instruction.direction() {
                failures.push(format!(
                    "{} {sample}: the table says {:?}, the code does {does:?}",
                    instruction.english(),
                    instruction.direction()
                ));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn an_instruction_without_a_direction_takes_no_variable() {
    let memory = |width| Operand::Memory(Access { width, location: Location::Fixed { area: Area::BitMemory, position: 0 } });
    let variables = [
        memory(Width::Bit),
        memory(Width::Byte),
        memory(Width::Word),
        memory(Width::DoubleWord),
        Operand::Timer(NumberOperand::Fixed(1)),
        Operand::Counter(NumberOperand::Fixed(1)),
    ];
    for &instruction in Instruction::ALL {
        let takes = variables.iter().any(|variable| instruction.operand().accepts(variable));
        assert_eq!(takes, instruction.direction().is_some(), "{}", instruction.name());
    }
}
