//! Examples of reasons: each instruction is run in states that bring out its sentences, and says why.

use std::sync::Arc;

use sieben_engine::machine::{Register, Registers, TimerKind};
use sieben_engine::{
    Context, Engine, Entry, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Reaction, StatementEvent, StopReason, Tracer,
};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

use super::{Language, Moment, Reasons};
use crate::sentences::table::Sentence;
use crate::stl::convert::convert;
use crate::stl::instructions::Instruction;
use crate::stl::operands::OperandClass;
use crate::stl::why::{Number, Why};
use crate::{Compiled, Options, compile};

/// A statement that was run, and what its reason is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// The statement with English and with German mnemonics.
    pub statement: [String; 2],
    /// The reason in English and in German, beginning in lower case and without a full stop.
    pub sentence: [String; 2],
    /// The sentences that it is made of.
    pub forms: Vec<Sentence>,
}

/// Examples of an instruction, each with other sentences than those before; at least one.
pub fn of(instruction: Instruction) -> Vec<Example> {
    let mut examples: Vec<Example> = Vec::new();
    for operand in operands(instruction) {
        let Some(program) = Prepared::new(instruction, operand) else { continue };
        let mut seen: Vec<Vec<Sentence>> = Vec::new();
        for state in states(instruction.why()) {
            let Some(example) = program.run(&state) else { continue };
            if !seen.contains(&example.forms) && !examples.iter().any(|other| other.sentence == example.sentence) {
                seen.push(example.forms.clone());
                examples.push(example);
            }
        }
    }
    examples
}

/// Operands that bring out what an instruction can say.
fn operands(instruction: Instruction) -> &'static [&'static str] {
    match (instruction, instruction.operand()) {
        (Instruction::And, _) => &["I 0.1", "M [AR1,P#1.0]", "T 1", ">0"],
        (Instruction::EdgePositive | Instruction::EdgeNegative, _) => &["M 1.0"],
        (Instruction::OpenBlock, _) => &["DB 10", "DI 10", "DB 0"],
        (_, OperandClass::None) => &[""],
        (_, OperandClass::ScanBit) => &["I 0.1"],
        (_, OperandClass::AssignBit) => &["Q 4.0"],
        (_, OperandClass::Load) => &["MW 10", "DB10.DBW 2", "MW [MD 20]", "5", "T 1", "C 1"],
        (_, OperandClass::Transfer) => &["MW 12"],
        (_, OperandClass::StatusWord) => &["STW"],
        (_, OperandClass::DataBlockInfo) => &["DBNO", "DBLG", "DINO"],
        (_, OperandClass::Timer) => &["T 1"],
        (_, OperandClass::Counter) => &["C 1"],
        (_, OperandClass::TimerOrCounter) => &["T 1", "C 1"],
        (_, OperandClass::PointerSource | OperandClass::PointerSourceWithoutAr2) => &["P#M 10.0", "MD 20"],
        (_, OperandClass::PointerTarget | OperandClass::PointerTargetWithoutAr2) => &["MD 24"],
        (_, OperandClass::OptionalPointerOffset) => &["P#1.0", ""],
        (_, OperandClass::ByteConstant) => &["3"],
        (_, OperandClass::IntConstant) => &["5"],
        (_, OperandClass::DoubleIntConstant) => &["L#5"],
        (_, OperandClass::ShiftCount16 | OperandClass::ShiftCount32) => &["3", ""],
        (_, OperandClass::OptionalConstant16) => &["W#16#F0", ""],
        (_, OperandClass::OptionalConstant32) => &["DW#16#F0F0", ""],
        (_, OperandClass::Label) => &["M001"],
        (_, OperandClass::CallBlock) => &["FC 1"],
        (_, OperandClass::Call) => &["FC 1", "FC 2 (LEVEL := MW 10, FULL := Q 4.0)"],
        (_, OperandClass::OpenBlock) => &["DB 10"],
        (_, OperandClass::Extension) => &[],
        (_, OperandClass::Zero) => &["0"],
        (_, OperandClass::One) => &["1"],
    }
}

/// What stands before the statement and behind it, so that the program is whole.
fn around(instruction: Instruction) -> (&'static str, &'static str) {
    match instruction.why() {
        Why::Open(..) => ("", "A I 0.1;\n);\n"),
        Why::Close => ("A(;\nA I 0.1;\n", ""),
        Why::McrOpen => ("MCRA;\n", ")MCR;\nMCRD;\n"),
        Why::McrClose => ("MCR(;\n", ""),
        Why::LoadDataBlockInfo => ("OPN DB 10;\n", ""),
        Why::McrActivate => ("", "MCRD;\n"),
        Why::JumpList => ("", "JU M001;\nJU M002;\n"),
        _ => ("", ""),
    }
}

/// The blocks that the statements need.
const OTHERS: &str = "FUNCTION FC 1 : VOID\nBEGIN\nNOP 0;\nEND_FUNCTION\n\
    FUNCTION FC 2 : VOID\nVAR_INPUT\nLEVEL : INT;\nEND_VAR\nVAR_OUTPUT\nFULL : BOOL;\nEND_VAR\nBEGIN\nSET;\n= #FULL;\nEND_FUNCTION\n\
    DATA_BLOCK DB 10\nSTRUCT\nFIRST : WORD;\nSECOND : WORD := W#16#1234;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

/// The block in which the statement stands, and the index of the statement there.
struct Prepared {
    compiled: [Compiled; 2],
    sources: [Sources; 2],
    engine: Arc<dyn Engine>,
    layout: Arc<Layout>,
    place: FaultPlace,
    /// The statement has no code.
    without_code: bool,
}

impl Prepared {
    fn new(instruction: Instruction, operand: &str) -> Option<Self> {
        let (before, behind) = around(instruction);
        let statement = format!("{} {operand}", instruction.english());
        let code = format!("{before}{statement};\n{behind}M001: NOP 0;\nM002: NOP 1;\n");
        let ends = matches!(instruction.why(), Why::End | Why::EndIfRlo);
        let (main, function, block) = match ends {
            true => ("UC FC 3;\n".to_owned(), format!("{statement};\n"), BlockId::fc(3)),
            false => (code, "NOP 0;\n".to_owned(), BlockId::ob(1)),
        };
        let text = format!(
            "{OTHERS}FUNCTION FC 3 : VOID\nBEGIN\n{function}END_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\n{main}END_ORGANIZATION_BLOCK\n"
        );
        let german = convert(&text, Some(Mnemonics::English), Mnemonics::German).ok()?;
        // Only a CPU with four accumulators has code for these.
        let four = matches!(instruction.why(), Why::Enter | Why::Leave);
        let cpu = if four { CpuType::by_name("416-3")? } else { &CpuType::ALL[0] };
        let compiled = [(text, Mnemonics::English), (german, Mnemonics::German)].map(|(text, mnemonics)| {
            let mut sources = Sources::default();
            sources.add("example.awl", text);
            let options = Options { cpu: Some(cpu), mnemonics: Some(mnemonics), ..Options::default() };
            let compiled = compile(&sources, &SymbolTable::default(), &options);
            (compiled, sources)
        });
        if compiled.iter().any(|(compiled, _)| compiled.has_errors()) {
            return None;
        }
        let [(english, english_sources), (german, german_sources)] = compiled;
        let layout = Arc::new(Layout::new(cpu, &english.program));
        let engine = Interpreter::load(&english.program, &layout);
        let place = FaultPlace { block, statement: before.lines().count() as u32 };
        let without_code = instruction.why() == Why::Nothing;
        Some(Self { compiled: [english, german], sources: [english_sources, german_sources], engine, layout, place, without_code })
    }

    /// Runs the program in a state; `None` if the statement was not reached.
    fn run(&self, state: &State) -> Option<Example> {
        let mut machine = Machine::new(Arc::clone(&self.layout));
        for (number, block) in &self.compiled[0].program.data {
            if let Some(entry) = machine.memory.data_block(u64::from(*number)) {
                machine.memory.arena[entry.base as usize..][..block.image.len()].copy_from_slice(&block.image);
            }
        }
        state.prepare(&mut machine);
        let before = machine.clone();
        let mut watch = Watch { place: self.place, seen: None };
        let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: Some(Box::new(state.registers())) };
        self.engine.run(&mut Context { machine: &mut machine, host: &mut Alone, tracer: Some(&mut watch) }, &entry);
        let (event, after) = match watch.seen {
            Some(seen) => seen,
            // What needs no code is no step of the interpreter either.
            None if self.without_code => {
                let event = StatementEvent { place: self.place, before: state.registers(), after: state.registers() };
                (event, before.clone())
            }
            None => return None,
        };
        let symbols = SymbolTable::default();
        // What is before the first statement is before the measured one too, as far as timers and counters go.
        let mut kept = before;
        kept.frames = after.frames.iter().take(1).cloned().collect();
        let moment = Moment { event: &event, before: Some(&kept), after: &after, fault: None };
        let [english, german] = [0, 1].map(|index| Reasons::new(&self.compiled[index], &self.sources[index], &symbols));
        Some(Example {
            statement: [english.statement(self.place), german.statement(self.place)],
            sentence: [english.sentence(&moment, Language::English), german.sentence(&moment, Language::German)],
            forms: english.forms(&moment),
        })
    }
}

/// A state before a statement.
#[derive(Clone, Copy, Debug)]
struct State {
    rlo: u64,
    fc: u64,
    or: u64,
    /// The scanned bit, and the condition codes.
    bit: u64,
    /// The edge memories.
    edge: bool,
    accu1: u32,
    accu2: u32,
    /// How the timer was started.
    timer: TimerKind,
}

/// The states in which an instruction is run, the plainest first.
fn states(why: Why) -> Vec<State> {
    let mut states = Vec::new();
    let timer = if let Why::Timer(kind) = why { kind } else { TimerKind::default() };
    for &(accu2, accu1) in accumulators(why) {
        for (rlo, fc, or) in [(1, 1, 0), (0, 1, 0), (1, 0, 0), (1, 1, 1)] {
            for (bit, edge) in [(1, false), (0, false), (1, true), (0, true)] {
                states.push(State { rlo, fc, or, bit, edge, accu1, accu2, timer });
            }
        }
    }
    states
}

/// ACCU 2 and ACCU 1 of the states.
fn accumulators(why: Why) -> &'static [(u32, u32)] {
    match why {
        Why::Arithmetic(Number::Int, _) | Why::Negate(Number::Int) => {
            &[(12, 5), (2, 0xFFFB), (7, 7), (0x7FFF, 0x7FFF), (5, 0), (0x8000, 0xFFFF), (0, 0x8000)]
        }
        Why::Arithmetic(Number::Double, _) | Why::Negate(Number::Double) => {
            &[(12, 5), (2, 0xFFFF_FFFB), (7, 7), (0x7FFF_FFFF, 0x7FFF_FFFF), (5, 0), (0x8000_0000, 0xFFFF_FFFF), (0, 0x8000_0000)]
        }
        Why::Arithmetic(Number::Real, _) | Why::Compare(Number::Real, _) | Why::Negate(Number::Real) => &[
            (0x4020_0000, 0x3FC0_0000),
            (0x3FC0_0000, 0x4020_0000),
            (0xBFC0_0000, 0x3FC0_0000),
            (0x3FC0_0000, 0x3FC0_0000),
            (0x7F7F_FFFF, 0x7F7F_FFFF),
            (0x7FC0_0000, 0x3F80_0000),
            (0x0080_0000, 0x0080_0001),
            (0x7F7F_FFFF, 0x0080_0000),
        ],
        Why::Function(_) | Why::Absolute | Why::Round(_) => {
            &[(0, 0x3F00_0000), (0, 0xBF00_0000), (0, 0), (0, 0x7F7F_FFFF), (0, 0x4020_0000), (0, 0xC020_0000)]
        }
        Why::Compare(..) => &[(12, 5), (5, 12), (7, 7)],
        Why::FromBcd(_) => &[(0, 0x123), (0, 0x1A3)],
        Why::ToBcd(_) => &[(0, 123), (0, 0x7FFF_7FFF)],
        Why::Enter | Why::Leave => &[(3, 5)],
        Why::Loop => &[(0, 3), (0, 1)],
        Why::JumpList => &[(0, 1), (0, 7)],
        Why::Timer(_) => &[(0, 0x0250), (0, 0)],
        Why::CounterSet => &[(0, 0x0042)],
        Why::LoadPointer(_) => &[(0, 0x8300_0068)],
        _ => &[(3, 5), (0, 0x00F0_1234), (0x7, 0x0F00)],
    }
}

impl State {
    fn registers(&self) -> Registers {
        let mut registers = Registers { accu1: u64::from(self.accu1), accu2: u64::from(self.accu2), ..Registers::fresh() };
        for (register, value) in [
            (Register::Rlo, self.rlo),
            (Register::Fc, self.fc),
            (Register::Or, self.or),
            (Register::Cc1, self.bit),
            (Register::Cc0, u64::from(self.edge)),
            (Register::Ov, self.bit),
            (Register::Os, self.bit),
            (Register::Br, self.bit),
            (Register::Ar1, 0x8300_0060),
            (Register::Ar2, 0x8400_0000),
        ] {
            registers.set(register, value);
        }
        registers
    }

    fn prepare(&self, machine: &mut Machine) {
        machine.clock_us = 10_000_000;
        machine.budget = i64::from(u16::MAX);
        machine.memory.area_mut(Area::Input)[0] = (self.bit as u8) << 1;
        let memory = machine.memory.area_mut(Area::BitMemory);
        memory[1] = u8::from(self.edge);
        memory[13] = self.bit as u8;
        memory[10..12].copy_from_slice(&250_u16.to_be_bytes());
        memory[20..24].copy_from_slice(&(10_u32 * 8).to_be_bytes());
        machine.memory.area_mut(Area::Output)[4] = self.bit as u8;
        let timer = &mut machine.timers[1];
        timer.start_edge = self.edge;
        timer.enable_edge = self.edge;
        timer.kind = self.timer;
        timer.value = 250;
        timer.running = self.bit == 1;
        // While an on-delay runs its status is 0.
        timer.status = self.bit == 1 && !matches!(self.timer, TimerKind::OnDelay | TimerKind::RetentiveOnDelay);
        timer.started_us = machine.clock_us;
        let counter = &mut machine.counters[1];
        counter.count = if self.bit == 1 {
            42
        } else if self.or == 1 {
            999
        } else {
            0
        };
        counter.set_edge = self.edge;
        counter.up_edge = self.edge;
        counter.down_edge = self.edge;
        counter.enable_edge = self.edge;
    }
}

/// Keeps the first event of a place with the machine behind it.
struct Watch {
    place: FaultPlace,
    seen: Option<(StatementEvent, Machine)>,
}

impl Tracer for Watch {
    fn statement(&mut self, machine: &Machine, event: &StatementEvent) {
        if self.seen.is_none() && event.place == self.place {
            self.seen = Some((event.clone(), machine.clone()));
        }
    }
}

/// A host without a CPU: every fault is ignored, as if it were masked.
struct Alone;

impl Host for Alone {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        match fault {
            Fault::Abort(_) => Reaction::Stop(StopReason { event: fault.event(), place: Some(place) }),
            _ => Reaction::Continue,
        }
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        Some(0)
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        true
    }
    fn safe_point(&mut self, _: &mut Machine, place: FaultPlace) -> Reaction {
        // A jump backward is no part of any example: whatever comes here has run long enough.
        Reaction::Stop(StopReason { event: 0, place: Some(place) })
    }
    fn system_function(&mut self, _: &mut Machine, _: BlockId, _: usize) -> Reaction {
        Reaction::Continue
    }
}
