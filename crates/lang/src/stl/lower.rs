//! From resolved statements to IR.

use std::sync::Arc;

use sieben_engine::CodeBlock;
use sieben_engine::ir::{Builder, Inst, OnFault, Op, Place, Target, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::interface::Interface;
use sieben_model::origin::Origin;
use sieben_model::source::Span;

use super::extension::{Compared, Extension};
use super::instructions::Instruction;
use super::operands::{Access, AddressRegister, Location, NumberOperand, Operand};
use super::size::code_bytes;
use crate::declarations::interface::START_INFORMATION_BYTES;
use crate::stl::why::Why;

/// One statement with all names resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Which instruction.
    pub instruction: Instruction,
    /// Its operand.
    pub operand: Operand,
    /// Where it comes from; in a text the whole statement without its label.
    pub origin: Origin,
    /// The statement itself where the source has an element of a diagram: `= L 20.0`.
    pub stated: Option<Arc<str>>,
}

impl Statement {
    /// Its place in the sources, empty if it has none.
    pub fn span(&self) -> Span {
        self.origin.span().unwrap_or_default()
    }
}

/// A code block whose statements are resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct ResolvedBlock {
    /// `FC 1`.
    pub id: BlockId,
    /// Its declarations.
    pub interface: Interface,
    /// Its statements.
    pub statements: Vec<Statement>,
    /// The TITLE of each of its networks, empty where there is none.
    pub titles: Vec<String>,
}

/// The IR of a block for a CPU type.
pub fn lower(block: &ResolvedBlock, cpu: &CpuType) -> CodeBlock {
    lowered(block, cpu, false)
}

/// The same with something to run in every statement, also in `NOP 0`: what nothing is done for cannot be counted.
pub fn lower_counted(block: &ResolvedBlock, cpu: &CpuType) -> CodeBlock {
    lowered(block, cpu, true)
}

fn lowered(block: &ResolvedBlock, cpu: &CpuType, counted: bool) -> CodeBlock {
    let declared = block.interface.local_size.max(if block.id.kind == sieben_model::block::BlockKind::OrganizationBlock {
        START_INFORMATION_BYTES
    } else {
        0
    });
    let addressed = block.statements.iter().map(|statement| local_end(&statement.operand)).max().unwrap_or(0);
    let mut lowering = Lowering {
        b: Builder::default(),
        cpu,
        accumulators: cpu.accumulators,
        uses_mcr: block.statements.iter().any(|statement| statement.instruction == Instruction::McrActivate),
        statements: &block.statements,
        index: 0,
        hidden_base: declared.max(addressed).next_multiple_of(2),
        hidden_used: 0,
        hidden_max: 0,
    };
    for (index, statement) in block.statements.iter().enumerate() {
        lowering.index = index;
        lowering.hidden_used = 0;
        lowering.b.begin_statement();
        statement.instruction.lower(&mut lowering, &statement.operand);
        if counted && statement.instruction.why() == Why::Nothing {
            lowering.b.push(Inst::Jump { to: lowering.b.next() });
        }
    }
    let local_size = (lowering.hidden_base + lowering.hidden_max).next_multiple_of(2);
    let end = block.statements.last().map_or(Span::default(), Statement::span);
    CodeBlock {
        code: lowering.b.finish(),
        interface: block.interface.clone(),
        local_size,
        // A pointer may lead anywhere into the local data.
        private: Vec::new(),
        handed: Vec::new(),
        reads_own_locals: false,
        mc7_bytes: u32::try_from(code_bytes(&block.statements)).ok(),
        spans: block.statements.iter().map(Statement::span).chain([end]).collect(),
    }
}

/// One behind the last local byte that the operand names by a constant address.
fn local_end(operand: &Operand) -> u32 {
    fn location_end(location: &Location, width: Width) -> u32 {
        match location {
            Location::Fixed { area: Area::Local, position } => position / 8 + width.bytes(),
            Location::MemoryIndirect { pointer, .. } => location_end(pointer, Width::DoubleWord),
            _ => 0,
        }
    }
    match operand {
        Operand::Extension(extension) => match &**extension {
            Extension::Assert { sides, .. } => {
                let side = |side: &Compared| match side {
                    Compared::Number(operand, _) => local_end(operand),
                    _ => 0,
                };
                sides.iter().map(side).max().unwrap_or(0)
            }
            Extension::Sleep(operand) => local_end(operand),
            _ => 0,
        },
        Operand::Memory(access) => location_end(&access.location, access.width),
        Operand::Timer(NumberOperand::Indirect(location)) | Operand::Counter(NumberOperand::Indirect(location)) => {
            location_end(location, Width::Word)
        }
        Operand::Block(block) => match &block.number {
            NumberOperand::Indirect(location) => location_end(location, Width::Word),
            _ => 0,
        },
        _ => 0,
    }
}

/// What the meanings write into, and what they know of the block.
pub struct Lowering<'a> {
    /// The IR being built.
    pub(crate) b: Builder,
    /// The CPU type the code is for.
    pub(crate) cpu: &'a CpuType,
    /// Accumulators that the statement works with.
    pub(crate) accumulators: u8,
    /// Whether the block activates the MCR; without that no statement of it can be switched off.
    pub(crate) uses_mcr: bool,
    /// All statements of the block.
    pub(crate) statements: &'a [Statement],
    /// The statement being lowered.
    pub(crate) index: usize,
    hidden_base: u32,
    hidden_used: u32,
    hidden_max: u32,
}

impl Lowering<'_> {
    /// Whether the CPU has four accumulators here; `__FEATURE 0` changes it for the statements behind it.
    pub(crate) fn four_accumulators(&self) -> bool {
        self.accumulators == 4
    }

    /// The end of the block.
    pub(crate) fn end(&self) -> Target {
        Target(u32::try_from(self.statements.len()).unwrap_or(u32::MAX))
    }

    /// Room for `bytes` in the hidden local data of this statement, at an even byte; the position in bits.
    pub(crate) fn hidden(&mut self, bytes: u32) -> u32 {
        let at = self.hidden_base + self.hidden_used;
        self.hidden_used += bytes.next_multiple_of(2);
        self.hidden_max = self.hidden_max.max(self.hidden_used);
        at * 8
    }

    /// The place of a location; what must be computed or opened for it is written first.
    pub(crate) fn place(&mut self, location: &Location) -> Place {
        match location {
            Location::Fixed { area, position } => Place::Fixed { area: *area, position: *position },
            Location::InDataBlock { db, position } => {
                let number = self.b.constant(u64::from(*db));
                self.b.push(Inst::Open { register: sieben_engine::ir::DataRegister::Shared, number });
                Place::Fixed { area: Area::SharedData, position: *position }
            }
            Location::InInstanceBlock { db, position } => {
                let number = self.b.constant(u64::from(*db));
                self.b.push(Inst::Open { register: sieben_engine::ir::DataRegister::Instance, number });
                Place::Fixed { area: Area::InstanceData, position: *position }
            }
            Location::MemoryIndirect { area, pointer } => {
                let place = self.place(pointer);
                let pointer = self.b.load(place, Width::DoubleWord, OnFault::SkipStatement);
                Place::Indirect { area: *area, pointer, offset: 0 }
            }
            Location::RegisterIndirect { area, register, offset } => {
                let pointer = address_register(*register);
                match area {
                    Some(area) => Place::Indirect { area: *area, pointer, offset: *offset },
                    None => Place::Crossing { pointer, offset: *offset },
                }
            }
            Location::Parameter { index, offset, complex: false } => {
                let pointer = self.b.temporary();
                self.b.push(Inst::Parameter { dst: pointer, index: *index });
                Place::Crossing { pointer, offset: *offset }
            }
            Location::Parameter { index, offset, complex: true } => {
                let parameter = self.b.temporary();
                self.b.push(Inst::Parameter { dst: parameter, index: *index });
                self.through_pointer(
                    Place::Crossing { pointer: parameter, offset: 0 },
                    Place::Crossing { pointer: parameter, offset: 16 },
                    *offset,
                )
            }
            Location::InstancePointer { position, offset } => {
                let at = |position| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: position };
                self.through_pointer(at(*position), at(*position + 16), *offset)
            }
            Location::Instance { position } => {
                Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: *position }
            }
        }
    }

    /// The place behind a POINTER: opens its data block and takes its address into AR1, as the compiled access of the
    /// real CPU does. The DB register and AR1 are lost.
    fn through_pointer(&mut self, number: Place, pointer: Place, offset: u32) -> Place {
        let number = self.b.load(number, Width::Word, OnFault::SkipStatement);
        let target = self.b.load(pointer, Width::DoubleWord, OnFault::SkipStatement);
        self.b.push(Inst::Open { register: sieben_engine::ir::DataRegister::Shared, number });
        self.b.copy(Register::Ar1, target);
        Place::Crossing { pointer: Register::Ar1.into(), offset }
    }

    /// Loads an access.
    pub(crate) fn load(&mut self, access: &Access, on_fault: OnFault) -> Var {
        let place = self.place(&access.location);
        self.b.load(place, access.width, on_fault)
    }

    /// The number of a timer, counter or block.
    pub(crate) fn number(&mut self, number: &NumberOperand) -> Var {
        match number {
            NumberOperand::Fixed(number) => self.b.constant(u64::from(*number)),
            NumberOperand::Indirect(location) => {
                let place = self.place(location);
                self.b.load(place, Width::Word, OnFault::SkipStatement)
            }
            NumberOperand::Parameter(index) => {
                let dst = self.b.temporary();
                self.b.push(Inst::Parameter { dst, index: *index });
                self.b.compute(Op::Low16, &[dst])
            }
        }
    }

    /// Whether statements take effect here: a variable in a block that uses the MCR, else `None` (always).
    pub(crate) fn mcr_on(&mut self) -> Option<Var> {
        self.uses_mcr.then(|| self.b.compute(Op::McrOn, &[Register::Ma.into(), Register::Mcr.into()]))
    }
}

/// The IR register of AR1 or AR2.
pub(crate) fn address_register(register: AddressRegister) -> Var {
    match register {
        AddressRegister::Ar1 => Register::Ar1.into(),
        AddressRegister::Ar2 => Register::Ar2.into(),
    }
}
