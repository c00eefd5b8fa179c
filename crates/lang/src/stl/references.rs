//! What the statements of a block of STL refer to.

use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Interface;
use sieben_model::literal::{Value, any_type_code};
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::extension::{Compared, Extension};
use super::instructions::Instruction;
use super::lower::{ResolvedBlock, Statement};
use super::operands::{Actual, BlockOperand, Call, CallInstance, Operand};
use crate::access::{Direction, Location, NumberOperand};
use crate::references::target::{Extent, Indirect, Memory, Pointer, Reach, Target};
use crate::references::variables::{self, Among, Wanted, among_of};
use crate::references::{CallKind, InstructionWord, Reference, Usage, block_kind, width};

impl From<Instruction> for InstructionWord {
    fn from(instruction: Instruction) -> Self {
        Self { english: instruction.english(), german: instruction.german() }
    }
}

/// The references of one block, statement by statement.
pub(crate) fn references_of(block: &ResolvedBlock) -> Vec<Reference> {
    let mut collector = Collector { block, statement: None, references: Vec::new() };
    for (index, statement) in block.statements.iter().enumerate() {
        collector.statement = Some((index, statement));
        collector.operand(statement);
    }
    collector.references
}

struct Collector<'a> {
    block: &'a ResolvedBlock,
    statement: Option<(usize, &'a Statement)>,
    references: Vec<Reference>,
}

/// Where in a statement something is used.
#[derive(Clone, Copy)]
struct Part<'a> {
    span: Span,
    parameter: Option<&'a str>,
}

impl Collector<'_> {
    fn add(&mut self, target: Target, usage: Usage, part: Part<'_>) {
        let Some((index, statement)) = self.statement else { return };
        self.references.push(Reference {
            target,
            block: self.block.id,
            network: statement.origin.network(),
            statement: index + 1,
            span: part.span,
            instruction: Some(statement.instruction.into()),
            usage,
            parameter: part.parameter.map(str::to_owned),
        });
    }

    fn call_kind(&self) -> CallKind {
        match self.statement.map(|(_, statement)| statement.instruction) {
            Some(Instruction::CallUnconditional) => CallKind::Unconditional,
            Some(Instruction::CallConditional) => CallKind::Conditional,
            _ => CallKind::Call,
        }
    }

    fn operand(&mut self, statement: &Statement) {
        let part = Part { span: statement.span(), parameter: None };
        let access = Usage::Access(statement.instruction.direction().unwrap_or(Direction::Read));
        match &statement.operand {
            Operand::Extension(extension) => match &**extension {
                Extension::Assert { sides, .. } => sides.iter().for_each(|side| self.compared(side, part)),
                Extension::Sleep(operand) => self.plain_operand(operand, access, part),
                Extension::StatusReset | Extension::Feature { .. } => {}
            },
            operand => self.plain_operand(operand, access, part),
        }
    }

    /// One side of an assertion.
    fn compared(&mut self, side: &Compared, part: Part<'_>) {
        let read = Usage::Access(Direction::Read);
        match side {
            Compared::Number(operand, _) => self.plain_operand(operand, read, part),
            Compared::Bytes(location, bytes) => self.location(location, Extent::Bits(bytes.saturating_mul(8)), read, part),
            Compared::Constant(_) => {}
        }
    }

    fn plain_operand(&mut self, operand: &Operand, access: Usage, part: Part<'_>) {
        match operand {
            Operand::None
            | Operand::Extension(_)
            | Operand::Register(_)
            | Operand::Status(_)
            | Operand::StatusWord
            | Operand::DataBlockInfo(_)
            | Operand::AddressRegister2
            | Operand::Label(_) => {}
            Operand::Memory(memory) => self.location(&memory.location, Extent::Width(memory.width), access, part),
            Operand::Timer(number) => self.number(number, Target::Timer, Reach::Timer, access, part),
            Operand::Counter(number) => self.number(number, Target::Counter, Reach::Counter, access, part),
            Operand::Block(BlockOperand { kind, instance, number }) => {
                let usage = if *kind == BlockKind::DataBlock { Usage::Open } else { Usage::Call(self.call_kind()) };
                let reach = if *instance { Reach::InstanceBlock } else { Reach::Block(*kind) };
                // Number 0 closes the register, it is no block.
                if *number != NumberOperand::Fixed(0) || usage != Usage::Open {
                    self.number(number, |number| Target::Block(BlockId::new(*kind, number)), reach, usage, part);
                }
            }
            Operand::Constant(value) => self.constant(value, Usage::Address, part),
            Operand::ParameterAddress(index) => {
                let target = self.local(Among::Parameter, u32::from(*index), 0, Extent::Unknown);
                self.add(target, Usage::Address, part);
            }
            Operand::Call(call) => self.call(call, part),
        }
    }

    fn call(&mut self, call: &Call, part: Part<'_>) {
        self.add(Target::Block(call.callee), Usage::Call(CallKind::Call), part);
        match call.instance {
            None => {}
            Some(CallInstance::DataBlock(number)) => self.add(Target::Block(BlockId::db(number)), Usage::Instance, part),
            Some(CallInstance::Multi(position)) => {
                let name = variables::name(&self.block.interface, Among::Instance, position, 0, Wanted::Instance(call.callee));
                let target = match name {
                    Some(name) => Target::Local { block: self.block.id, name },
                    None => self.local(Among::Instance, position, 0, Extent::Unknown),
                };
                self.add(target, Usage::Instance, part);
            }
        }
        for parameter in &call.parameters {
            let part = Part { span: parameter.span, parameter: Some(&parameter.name) };
            let access = Usage::Access(Direction::of_parameter(parameter.section));
            match &parameter.actual {
                None => {}
                Some(Actual::Memory(memory)) => self.location(&memory.location, Extent::Width(memory.width), access, part),
                Some(Actual::Constant(value)) => self.constant(value, access, part),
                Some(Actual::Timer(number)) => self.number(number, Target::Timer, Reach::Timer, Usage::Address, part),
                Some(Actual::Counter(number)) => self.number(number, Target::Counter, Reach::Counter, Usage::Address, part),
                Some(Actual::Block(number)) => {
                    let kind = block_kind(&parameter.data_type);
                    let target = |number| Target::Block(BlockId::new(kind, number));
                    self.number(number, target, Reach::Block(kind), Usage::Address, part);
                }
                Some(Actual::Complex { location, data_type }) => {
                    let bits = Extent::Bits(u32::try_from(data_type.bits()).unwrap_or(u32::MAX));
                    let extent = data_type.width().map_or(bits, Extent::Width);
                    self.location(location, extent, access, part);
                }
            }
        }
    }

    fn location(&mut self, location: &Location, extent: Extent, usage: Usage, part: Part<'_>) {
        let target = match location {
            Location::MemoryIndirect { area, pointer } => {
                let target = self.target(pointer, Extent::Width(Width::DoubleWord));
                self.location(pointer, Extent::Width(Width::DoubleWord), Usage::Access(Direction::Read), part);
                Target::Indirect(Indirect { reach: Reach::Memory(Some(*area), width(extent)), pointer: Pointer::In(Box::new(target)) })
            }
            other => self.target(other, extent),
        };
        self.add(target, usage, part);
    }

    /// What a location is; a pointer that it goes through is not looked at.
    fn target(&self, location: &Location, extent: Extent) -> Target {
        let memory = |area, db, position| Target::Memory(Memory { area, db, position, extent });
        match location {
            Location::Fixed { area: Area::Local, position } => self.local(Among::Temporary, *position, 0, extent),
            Location::Fixed { area, position } => memory(*area, None, *position),
            Location::InDataBlock { db, position } | Location::InInstanceBlock { db, position } => {
                memory(Area::SharedData, Some(*db), *position)
            }
            Location::Parameter { index, offset, .. } => self.local(Among::Parameter, u32::from(*index), *offset, extent),
            Location::InstancePointer { position, offset } => self.local(Among::Instance, *position, *offset, extent),
            Location::Instance { position } => self.local(Among::Instance, *position, 0, extent),
            Location::RegisterIndirect { area, register, offset } => {
                Target::Indirect(Indirect { reach: Reach::Memory(*area, width(extent)), pointer: Pointer::register(*register, *offset) })
            }
            Location::MemoryIndirect { area, pointer } => Target::Indirect(Indirect {
                reach: Reach::Memory(Some(*area), width(extent)),
                pointer: Pointer::In(Box::new(self.target(pointer, Extent::Width(Width::DoubleWord)))),
            }),
        }
    }

    /// A variable of the block, by its name or else by its address.
    fn local(&self, among: Among, position: u32, offset: u32, extent: Extent) -> Target {
        let block = self.block.id;
        let name = variables::name(&self.block.interface, among, position, offset, extent.into()).unwrap_or_else(|| {
            let start = position.saturating_add(offset);
            let area = if among == Among::Temporary { Area::Local } else { Area::InstanceData };
            Target::Memory(Memory { area, db: None, position: start, extent }).spell(Default::default())
        });
        Target::Local { block, name }
    }

    fn number(&mut self, number: &NumberOperand, fixed: impl Fn(u16) -> Target, reach: Reach, usage: Usage, part: Part<'_>) {
        let target = match number {
            NumberOperand::Fixed(number) => fixed(*number),
            NumberOperand::Parameter(index) => self.local(Among::Parameter, u32::from(*index), 0, Extent::Unknown),
            NumberOperand::Indirect(location) => {
                let target = self.target(location, Extent::Width(Width::Word));
                if is_parameter(&self.block.interface, self.block.id.kind, location) {
                    target
                } else {
                    self.location(location, Extent::Width(Width::Word), Usage::Access(Direction::Read), part);
                    Target::Indirect(Indirect { reach, pointer: Pointer::In(Box::new(target)) })
                }
            }
        };
        self.add(target, usage, part);
    }

    /// The memory that a pointer constant names, if it names any.
    fn constant(&mut self, value: &Value, usage: Usage, part: Part<'_>) {
        let target = match value {
            Value::Pointer(pointer) => area_of(*pointer).map(|area| pointed(area, 0, *pointer, Extent::Unknown)),
            Value::DataPointer { db, pointer } => area_of(*pointer).map(|area| pointed(area, *db, *pointer, Extent::Unknown)),
            Value::Any(bytes) => any_target(bytes),
            _ => None,
        };
        let Some(target) = target else { return };
        let is_range = matches!(target, Target::Memory(Memory { extent: Extent::Bits(_), .. }));
        let target = match target {
            Target::Memory(Memory { area: Area::Local, position, extent, .. }) => self.local(Among::Temporary, position, 0, extent),
            Target::Memory(Memory { area: Area::InstanceData, db: None, position, extent })
                if self.block.id.kind == BlockKind::FunctionBlock =>
            {
                self.local(Among::Instance, position, 0, extent)
            }
            other => other,
        };
        self.add(target, if is_range { usage } else { Usage::Address }, part);
    }
}

/// Whether a number lies in a parameter of a function block that stands for a timer, counter or block.
fn is_parameter(interface: &Interface, kind: BlockKind, location: &Location) -> bool {
    let Location::Instance { position } = location else { return false };
    let Some((variable, 0)) = variables::variable(interface, among_of(kind), *position) else { return false };
    variable.data_type.is_number()
}

/// The area of an area-crossing pointer.
fn area_of(pointer: u32) -> Option<Area> {
    const AREAS: [Area; 8] = [
        Area::PeripheralInput,
        Area::Input,
        Area::Output,
        Area::BitMemory,
        Area::SharedData,
        Area::InstanceData,
        Area::Local,
        Area::CallerLocal,
    ];
    AREAS.into_iter().find(|area| u32::from(area.pointer_code()) == pointer >> 24)
}

fn pointed(area: Area, db: u16, pointer: u32, extent: Extent) -> Target {
    let db = (db != 0 && matches!(area, Area::SharedData | Area::InstanceData)).then_some(db);
    let area = if db.is_some() { Area::SharedData } else { area };
    Target::Memory(Memory { area, db, position: pointer & 0x7_FFFF, extent })
}

/// The range that an ANY names.
fn any_target(bytes: &[u8; 10]) -> Option<Target> {
    let [_, code, count_high, count_low, db_high, db_low, pointer @ ..] = *bytes;
    let count = u32::from(u16::from_be_bytes([count_high, count_low]));
    let db = u16::from_be_bytes([db_high, db_low]);
    let pointer = u32::from_be_bytes(pointer);
    let data_type = DataType::words().find(|word| any_type_code(word) == Some(code)).and_then(DataType::from_word)?;
    let bits = match data_type {
        DataType::Counter => return Some(Target::Counter(pointer as u16)),
        DataType::Timer => return Some(Target::Timer(pointer as u16)),
        // A block is named by its number, not by a place.
        DataType::BlockFunction | DataType::BlockFunctionBlock | DataType::BlockData | DataType::BlockSystemData => return None,
        _ => u32::try_from(data_type.bits()).ok()?,
    };
    Some(pointed(area_of(pointer)?, db, pointer, Extent::Bits(bits.saturating_mul(count))))
}
