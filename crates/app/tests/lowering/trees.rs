//! Typed trees, written by hand, and both engines to run them.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_engine::ir::{Op, verify};
use sieben_engine::{CodeBlock, Context, Engine, Entry, Exit, Fault, FaultPlace, Host, Interpreter, Layout, Machine, Program, Reaction};
use sieben_jit::{Jit, StatusBits};
use sieben_lang::st::lower::{Known, lower};
use sieben_lang::st::tree::{Base, Body, Bounds, Index, Place, Scalar, Statement, StatementKind, Value, ValueKind};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::program::DataBlock;
use sieben_model::source::Span;
use sieben_model::types::DataType;

pub(crate) fn place(base: Base, offset: u32) -> Place {
    Place { base, offset, indexes: Vec::new(), span: Span::default() }
}

/// Bit memory at a byte.
pub(crate) fn m(byte: u32) -> Place {
    place(Base::Area(Area::BitMemory), byte * 8)
}

/// Local data at a byte.
pub(crate) fn l(byte: u32) -> Place {
    place(Base::Area(Area::Local), byte * 8)
}

/// The instance at a byte.
pub(crate) fn own(byte: u32) -> Place {
    place(Base::Instance, byte * 8)
}

/// A data block at a byte.
pub(crate) fn db(number: u16, byte: u32) -> Place {
    place(Base::DataBlock(number), byte * 8)
}

pub(crate) fn indexed(mut place: Place, index: Value, low: i64, count: u64, step_bytes: u32, check: Bounds) -> Place {
    place.indexes.push(Index { value: index, low, count, step: step_bytes * 8, check });
    place
}

pub(crate) fn value(kind: ValueKind, scalar: Scalar) -> Value {
    Value { kind, scalar, span: Span::default() }
}

pub(crate) fn int(number: i16) -> Value {
    value(ValueKind::Constant(u64::from(number as u16)), Scalar::I16)
}

pub(crate) fn dint(number: i32) -> Value {
    value(ValueKind::Constant(u64::from(number as u32)), Scalar::I32)
}

pub(crate) fn bit(bit: bool) -> Value {
    value(ValueKind::Constant(u64::from(bit)), Scalar::Bool)
}

pub(crate) fn get(place: Place, scalar: Scalar) -> Value {
    value(ValueKind::Load(place), scalar)
}

pub(crate) fn compute(op: Op, scalar: Scalar, args: Vec<Value>) -> Value {
    value(ValueKind::Compute { op, args }, scalar)
}

/// A sum of INTs.
pub(crate) fn add(a: Value, b: Value) -> Value {
    compute(Op::AddU16, Scalar::I16, vec![a, b])
}

pub(crate) fn statement(kind: StatementKind) -> Statement {
    Statement { kind, span: Span::default() }
}

pub(crate) fn assign(target: Place, value: Value) -> Statement {
    statement(StatementKind::Assign { target, value })
}

pub(crate) fn variable(name: &str, section: Section, data_type: DataType, offset: u32) -> Variable {
    Variable { name: name.into(), section, data_type, offset, initial: Vec::new(), comment: String::new(), span: Span::default() }
}

/// A block of a program.
pub(crate) struct Block {
    pub(crate) id: BlockId,
    pub(crate) interface: Interface,
    pub(crate) body: Body,
}

pub(crate) fn block(id: BlockId, statements: Vec<Statement>) -> Block {
    Block { id, interface: Interface { local_size: 64, ..Interface::default() }, body: Body { statements, ..Body::default() } }
}

/// What a run left: faults, bit memory, and data blocks 1 and 2.
#[derive(Debug, PartialEq)]
pub(crate) struct Outcome {
    pub(crate) asked: Vec<String>,
    pub(crate) exit: Exit,
    pub(crate) memory: Vec<u8>,
    pub(crate) data: Vec<Vec<u8>>,
    pub(crate) br: u64,
}

impl Outcome {
    pub(crate) fn read(&self, byte: usize, width: Width) -> u64 {
        self.memory[byte..byte + width.bytes() as usize].iter().fold(0, |all, &byte| all << 8 | u64::from(byte))
    }
    pub(crate) fn int(&self, byte: usize) -> i16 {
        self.read(byte, Width::Word) as i16
    }
}

struct Noting {
    asked: Vec<String>,
}

impl Host for Noting {
    fn fault(&mut self, _: &mut Machine, fault: &Fault, place: FaultPlace) -> Reaction {
        self.asked.push(format!("{fault:?} in {}", place.block));
        Reaction::Continue
    }
    fn peripheral_read(&mut self, _: &mut Machine, _: u32, _: Width) -> Option<u32> {
        None
    }
    fn peripheral_write(&mut self, _: &mut Machine, _: u32, _: Width, _: u32) -> bool {
        false
    }
    fn safe_point(&mut self, machine: &mut Machine, place: FaultPlace) -> Reaction {
        self.asked.push(format!("safe point in {}", place.block));
        machine.budget = 100;
        if self.asked.len() > 200 {
            return Reaction::Stop(sieben_engine::StopReason { event: 0x4303, place: None });
        }
        Reaction::Continue
    }
    fn system_function(&mut self, _: &mut Machine, block: BlockId, _: usize) -> Reaction {
        self.asked.push(block.to_string());
        Reaction::Continue
    }
}

/// The IR of the blocks; it keeps the rules.
pub(crate) fn compile(blocks: &[Block]) -> Program {
    let interfaces: BTreeMap<BlockId, Arc<Interface>> = blocks.iter().map(|block| (block.id, Arc::new(block.interface.clone()))).collect();
    let known = |id: BlockId| interfaces.get(&id).cloned();
    let mut code: BTreeMap<BlockId, CodeBlock> = BTreeMap::new();
    for block in blocks {
        let known = Known { interface: &known, is_stl: &|_| false };
        let lowered = lower(block.id, &block.interface, &block.body, &known);
        assert_eq!(verify(&lowered.code), Ok(()), "{}\n{}", block.id, lowered.code);
        assert_eq!(lowered.spans.len(), lowered.code.statement_count(), "{}", block.id);
        code.insert(block.id, lowered);
    }
    let data = (1..=2).map(|number| (number, data_block(number))).collect();
    Program { code, data, ..Program::default() }
}

fn data_block(number: u16) -> DataBlock {
    DataBlock {
        number,
        based_on: None,
        structure: Arc::default(),
        image: vec![0; 64],
        read_only: false,
        non_retain: false,
        unlinked: false,
    }
}

/// Runs OB 1 on both engines; what both did.
pub(crate) fn run_with(blocks: &[Block], prepare: &dyn Fn(&mut Machine)) -> Outcome {
    let program = compile(blocks);
    let layout = Layout::new(CpuType::by_name("315-2PN/DP").expect("a CPU type"), &program);
    let run = |engine: &dyn Engine| {
        let mut machine = Machine::new(Arc::new(layout.clone()));
        machine.budget = 100;
        prepare(&mut machine);
        let mut host = Noting { asked: Vec::new() };
        let entry = Entry { block: BlockId::ob(1), start_information: [0; 20], registers: None };
        let exit = engine.run(&mut Context { machine: &mut machine, host: &mut host, tracer: None }, &entry);
        let data = [1, 2].map(|number| {
            let entry = machine.memory.data_block(number).expect("a data block");
            machine.memory.arena[entry.base as usize..(entry.base + entry.length) as usize].to_vec()
        });
        Outcome {
            asked: host.asked,
            exit,
            memory: machine.memory.area(Area::BitMemory).to_vec(),
            data: data.to_vec(),
            br: machine.registers.br,
        }
    };
    let interpreted = run(Interpreter::load(&program, &layout).as_ref());
    let native = run(Jit::compiled(&program, &layout, StatusBits::All).expect("machine code").as_ref());
    assert_eq!(native, interpreted);
    interpreted
}

pub(crate) fn run(blocks: &[Block]) -> Outcome {
    run_with(blocks, &|_| {})
}

/// Runs statements as OB 1.
pub(crate) fn run_statements(statements: Vec<Statement>) -> Outcome {
    run(&[block(BlockId::ob(1), statements)])
}
