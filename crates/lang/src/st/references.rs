//! What the statements of a block of ST refer to.

use sieben_model::address::{Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::tree::visit::{self, Use, Visit};
use super::tree::{Argument, Base, Call, Index, Intrinsic, Place, Statement, StatementKind, TextRoom, TypedBlock, Value, ValueKind};
use crate::access::Direction;
use crate::references::target::{Extent, Indirect, Memory, Pointer, Reach, Target};
use crate::references::variables::{self, Among, Wanted};
use crate::references::{Around, CallKind, Reference, Usage, block_kind, width};

const READ: Usage = Usage::Access(Direction::Read);
const WRITE: Usage = Usage::Access(Direction::Write);

/// The references of one block of ST, statement by statement.
pub(crate) fn references_of(id: BlockId, block: &TypedBlock, around: Around<'_>) -> Vec<Reference> {
    let mut collector = Collector { around, id, block, statement: 0, parameter: None, references: Vec::new() };
    visit::statements(&mut collector, &block.body.statements);
    collector.references
}

struct Collector<'a, 'b> {
    around: Around<'a>,
    id: BlockId,
    block: &'b TypedBlock,
    /// How many statements have begun.
    statement: usize,
    /// The parameter whose argument is looked at.
    parameter: Option<String>,
    references: Vec<Reference>,
}

impl Collector<'_, '_> {
    fn add(&mut self, target: Target, usage: Usage, span: Span) {
        let parameter = self.parameter.clone();
        let (block, statement) = (self.id, self.statement);
        self.references.push(Reference { target, block, network: 0, statement, span, instruction: None, usage, parameter });
    }

    /// A function over the timers and counters: the number of the one that it is about is its first argument.
    fn intrinsic(&mut self, intrinsic: Intrinsic, args: &[Value], span: Span, usage: Usage) {
        let target: Option<fn(u16) -> Target> = match intrinsic {
            Intrinsic::TimerStart(_)
            | Intrinsic::TimerReset
            | Intrinsic::TimerEnable
            | Intrinsic::TimerStatus
            | Intrinsic::TimerValue
            | Intrinsic::TimerBcd => Some(Target::Timer),
            Intrinsic::CounterUp
            | Intrinsic::CounterDown
            | Intrinsic::CounterSet
            | Intrinsic::CounterReset
            | Intrinsic::CounterEnable
            | Intrinsic::CounterStatus
            | Intrinsic::CounterValue
            | Intrinsic::CounterBcd => Some(Target::Counter),
            _ => None,
        };
        if let (Some(target), Some(Value { kind: ValueKind::Constant(number), .. })) = (target, args.first())
            && let Ok(number) = u16::try_from(*number)
        {
            self.add(target(number), usage, span);
        }
    }

    /// What a place is; an element with a computed index is all elements. `None` for what the compiler keeps for itself.
    fn target(&self, place: &Place, extent: Extent) -> Option<Target> {
        let whole = elements(&place.indexes, extent);
        let memory = |area, db| {
            // Where it ends is not known: the index is like a pointer.
            if place.indexes.iter().any(|index| index.count == 0)
                && let Some(pointer) = place.indexes.iter().find_map(|index| self.source(&index.value))
            {
                return Target::Indirect(Indirect {
                    reach: Reach::Memory(Some(area), width(extent)),
                    pointer: Pointer::In(Box::new(pointer)),
                });
            }
            Target::Memory(Memory { area, db, position: place.offset, extent: whole })
        };
        Some(match &place.base {
            Base::Area(Area::Local) => self.local(Among::Temporary, place.offset, 0, whole)?,
            Base::Area(area) => memory(*area, None),
            Base::DataBlock(number) => memory(Area::SharedData, Some(*number)),
            Base::Instance => self.local(Among::Instance, place.offset, 0, whole)?,
            Base::Parameter(index) | Base::ComplexParameter(index) => {
                self.local(Among::Parameter, u32::from(*index), place.offset, whole)?
            }
            Base::InstancePointer(position) => self.local(Among::Instance, *position, place.offset, whole)?,
            Base::ComputedDataBlock(value) => {
                let reach = Reach::Memory(Some(Area::SharedData), width(extent));
                Target::Indirect(Indirect { reach, pointer: Pointer::In(Box::new(self.source(value)?)) })
            }
            Base::Reference(value) => {
                let reach = Reach::Memory(None, width(extent));
                Target::Indirect(Indirect { reach, pointer: Pointer::In(Box::new(self.source(value)?)) })
            }
        })
    }

    /// The first variable that a value is computed from.
    fn source(&self, value: &Value) -> Option<Target> {
        match &value.kind {
            ValueKind::Load(place) => self.target(place, scalar_extent(value.scalar.bits())),
            ValueKind::Compute { args, .. } | ValueKind::Checked { args, .. } => args.iter().find_map(|value| self.source(value)),
            ValueKind::After(_, value) => self.source(value),
            _ => None,
        }
    }

    /// A declared variable of the block, as far inside as it has a name.
    fn local(&self, among: Among, position: u32, offset: u32, extent: Extent) -> Option<Target> {
        let interface = &self.block.interface;
        let ways = [extent.into(), Wanted::Elementary, Wanted::Outermost];
        let path = ways.into_iter().find_map(|wanted| variables::name(interface, among, position, offset, wanted));
        let whole = || variables::variable(interface, among, position).map(|(variable, _)| format!("#{}", variable.name));
        Some(Target::Local { block: self.id, name: path.or_else(whole)? })
    }

    fn interface(&self, block: BlockId) -> Option<&Interface> {
        (self.around.interface)(block)
    }

    /// The data block or variable that a call uses.
    fn instance(&self, callee: BlockId, place: &Place) -> Option<Target> {
        let extent = self.interface(callee).map_or(Extent::Unknown, |interface| Extent::Bits(interface.instance_size.saturating_mul(8)));
        if let Base::DataBlock(number) = place.base {
            let data = self.around.data.get(&number);
            if place.offset == 0 && data.is_some_and(|data| data.based_on == Some(callee)) {
                return Some(Target::Block(BlockId::db(number)));
            }
        }
        if place.base == Base::Instance
            && let Some(name) = variables::name(&self.block.interface, Among::Instance, place.offset, 0, Wanted::Instance(callee))
        {
            return Some(Target::Local { block: self.id, name });
        }
        self.target(place, extent)
    }

    /// The parameter that an argument is given to.
    fn formal(&self, callee: BlockId, argument: &Argument) -> Option<&Variable> {
        let position = argument.parameter()?;
        let interface = self.interface(callee)?;
        match callee.kind {
            BlockKind::Function | BlockKind::SystemFunction => interface.parameters().nth(position as usize),
            _ => interface.variables.iter().find(|variable| variable.section != Section::Temp && variable.offset == position),
        }
    }

    /// The number of a timer, a counter or a block as argument.
    fn number(&mut self, value: &Value, data_type: &DataType) {
        let ValueKind::Constant(bits) = value.kind else { return self.value(value) };
        let Ok(number) = u16::try_from(bits) else { return };
        let target = match data_type {
            DataType::Timer => Target::Timer(number),
            DataType::Counter => Target::Counter(number),
            other => Target::Block(BlockId::new(block_kind(other), number)),
        };
        self.add(target, Usage::Address, value.span);
    }
}

impl<'t> Visit<'t> for Collector<'_, '_> {
    fn statement(&mut self, statement: &'t Statement) {
        self.statement += 1;
        self.step(statement);
    }

    fn step(&mut self, statement: &'t Statement) {
        if let StatementKind::Intrinsic { intrinsic, args } = &statement.kind {
            self.intrinsic(*intrinsic, args, statement.span, WRITE);
        }
        visit::statement(self, statement);
    }

    fn value(&mut self, value: &'t Value) {
        match &value.kind {
            ValueKind::Intrinsic { intrinsic, args } => self.intrinsic(*intrinsic, args, value.span, READ),
            ValueKind::NumberParameter(index) => {
                if let Some(target) = self.local(Among::Parameter, u32::from(*index), 0, Extent::Unknown) {
                    self.add(target, READ, value.span);
                }
            }
            _ => {}
        }
        visit::value(self, value);
    }

    fn call(&mut self, call: &'t Call) {
        let outside = self.parameter.take();
        let (callee, instance) = (call.callee.block(), call.callee.instance());
        call.enable.iter().for_each(|value| self.value(value));
        self.add(Target::Block(callee), Usage::Call(CallKind::Call), call.span);
        if let Some(instance) = instance {
            if let Some(target) = self.instance(callee, instance) {
                self.add(target, Usage::Instance, instance.span);
            }
            visit::indexes(self, instance);
        }
        for argument in &call.arguments {
            let (parameter, is_number) = self
                .formal(callee, argument)
                .map_or((None, None), |formal| (Some(formal.name.clone()), formal.data_type.is_number().then(|| formal.data_type.clone())));
            self.parameter = parameter;
            match (argument, is_number) {
                (Argument::Value { value, .. } | Argument::Number { value, .. }, Some(data_type)) => self.number(value, &data_type),
                (argument, _) => self.argument(argument),
            }
        }
        self.parameter = outside;
    }

    /// An access to a place, and what its indexes and pointers read.
    fn place(&mut self, place: &'t Place, how: Use, extent: visit::Extent<'t>) {
        visit::base(self, place);
        visit::indexes(self, place);
        let usage = match how {
            Use::Read => READ,
            Use::Write => WRITE,
            Use::ReadWrite => Usage::Access(Direction::ReadWrite),
            Use::Address => Usage::Address,
            Use::Instance => Usage::Instance,
        };
        if let Some(target) = self.target(place, extent_of(extent)) {
            self.add(target, usage, place.span);
        }
    }
}

fn extent_of(extent: visit::Extent<'_>) -> Extent {
    match extent {
        visit::Extent::Scalar(scalar) => scalar_extent(scalar.bits()),
        visit::Extent::Text(room) => text_extent(room),
        visit::Extent::Bytes(bytes) => Extent::Bits(bytes.saturating_mul(8)),
        visit::Extent::Type(data_type) => type_extent(data_type),
        visit::Extent::Unknown => Extent::Unknown,
    }
}

fn scalar_extent(bits: u32) -> Extent {
    let widths = [Width::Bit, Width::Byte, Width::Word, Width::DoubleWord, Width::QuadWord];
    widths.into_iter().find(|width| width.bits() == bits).map_or(Extent::Bits(bits), Extent::Width)
}

fn type_extent(data_type: &DataType) -> Extent {
    data_type.width().map_or_else(|| Extent::Bits(u32::try_from(data_type.bits()).unwrap_or(u32::MAX)), Extent::Width)
}

/// A text with its two bytes of lengths; where it ends is not known of a parameter.
fn text_extent(room: TextRoom) -> Extent {
    if room.is_unknown() { Extent::Unknown } else { Extent::Bits(room.bytes() * 8) }
}

/// What all elements take that the indexes may choose.
fn elements(indexes: &[Index], extent: Extent) -> Extent {
    if indexes.is_empty() {
        return extent;
    }
    let one = match extent {
        Extent::Width(width) => width.bits(),
        Extent::Bits(bits) => bits,
        Extent::Unknown => return Extent::Unknown,
    };
    let more = indexes.iter().try_fold(0_u64, |bits, index| {
        let steps = index.count.checked_sub(1)?;
        Some(bits.saturating_add(steps.saturating_mul(u64::from(index.step))))
    });
    more.map_or(Extent::Unknown, |more| Extent::Bits(u32::try_from(more.saturating_add(u64::from(one))).unwrap_or(u32::MAX)))
}
