//! How a system block is declared: its parameters, their types, its row.

use sieben_engine::Reaction;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, SystemBlock, Variable};
use sieben_model::literal::Value;
use sieben_model::source::Span;
use sieben_model::types::{DataType, place};

use super::Call;
use super::parameters::Answer;

/// What a system block does.
pub(super) enum Run {
    /// Only its reaction counts; BR stays.
    Reaction(fn(&mut Call<'_, '_>) -> Reaction),
    /// A function with RET_VAL: a value of at least 0 and BR = 1, or an error code and BR = 0.
    Value(fn(&mut Call<'_, '_>) -> Answer),
    /// A function block; the answer is BR.
    Instance(fn(&mut Call<'_, '_>) -> bool),
    /// The CPU cannot do it: a function answers this code, a function block sets ERROR and this STATUS. BR = 0.
    Unavailable(u32),
}

/// The type of a parameter.
pub(super) enum Type {
    Plain(DataType),
    Made(fn() -> DataType),
}

/// What a variable of an instance begins with, where that is not 0.
#[derive(Clone, Copy)]
pub(super) enum Initial {
    True,
    Real(f32),
    /// Milliseconds.
    Time(i32),
}

impl Initial {
    fn value(self) -> Value {
        match self {
            Self::True => Value::Bool(true),
            Self::Real(value) => Value::Real(value),
            Self::Time(ms) => Value::Time(ms),
        }
    }
}

/// One parameter or variable of an instance.
pub(super) struct Parameter {
    pub(super) name: &'static str,
    pub(super) section: Section,
    pub(super) data_type: Type,
    initial: Option<Initial>,
}

const fn declared(name: &'static str, section: Section, data_type: Type) -> Parameter {
    Parameter { name, section, data_type, initial: None }
}

pub(super) const fn input(name: &'static str, data_type: DataType) -> Parameter {
    declared(name, Section::Input, Type::Plain(data_type))
}

/// An input of a function block that begins with a value.
pub(super) const fn preset(name: &'static str, data_type: DataType, initial: Initial) -> Parameter {
    Parameter { name, section: Section::Input, data_type: Type::Plain(data_type), initial: Some(initial) }
}

pub(super) const fn output(name: &'static str, data_type: DataType) -> Parameter {
    declared(name, Section::Output, Type::Plain(data_type))
}

pub(super) const fn in_out(name: &'static str, data_type: DataType) -> Parameter {
    declared(name, Section::InOut, Type::Plain(data_type))
}

pub(super) const fn stored(name: &'static str, data_type: DataType) -> Parameter {
    declared(name, Section::Static, Type::Plain(data_type))
}

/// A variable of an instance that begins with a value.
pub(super) const fn stored_preset(name: &'static str, data_type: DataType, initial: Initial) -> Parameter {
    Parameter { name, section: Section::Static, data_type: Type::Plain(data_type), initial: Some(initial) }
}

/// A parameter or variable whose type has parts: a structure or an array.
pub(super) const fn made(name: &'static str, section: Section, make: fn() -> DataType) -> Parameter {
    declared(name, section, Type::Made(make))
}

/// The result. It is the first output in the declaration of a system function: error codes count parameters so.
pub(super) const fn ret_val() -> Parameter {
    output(RET_VAL, DataType::Int)
}

pub(super) const RET_VAL: &str = "RET_VAL";

/// One row: the block, its name, its parameters, what it does.
pub(super) struct Row {
    pub(super) block: BlockId,
    pub(super) name: &'static str,
    pub(super) parameters: &'static [Parameter],
    pub(super) run: Run,
    /// What has it, if this CPU does not: "CPU 31xC".
    pub(super) only: Option<&'static str>,
}

pub(super) const fn sfc(number: u16, name: &'static str, parameters: &'static [Parameter], run: Run) -> Row {
    Row { block: BlockId::new(BlockKind::SystemFunction, number), name, parameters, run, only: None }
}

pub(super) const fn sfb(number: u16, name: &'static str, parameters: &'static [Parameter], run: fn(&mut Call<'_, '_>) -> bool) -> Row {
    Row { block: BlockId::new(BlockKind::SystemFunctionBlock, number), name, parameters, run: Run::Instance(run), only: None }
}

impl Parameter {
    pub(super) fn data_type(&self) -> DataType {
        match &self.data_type {
            Type::Plain(data_type) => data_type.clone(),
            Type::Made(make) => make(),
        }
    }
}

impl Row {
    pub(super) fn system_block(&self) -> SystemBlock {
        SystemBlock { block: self.block, name: self.name, interface: self.interface(), only: self.only }
    }

    pub(super) fn interface(&self) -> Interface {
        let function = self.block.kind == BlockKind::SystemFunction;
        let mut interface = Interface::default();
        for (index, (parameter, data_type, offset)) in self.laid_out().enumerate() {
            interface.instance_size = ((u64::from(offset) + data_type.bits()).next_multiple_of(16) / 8) as u32;
            interface.variables.push(Variable {
                name: parameter.name.to_owned(),
                section: parameter.section,
                data_type,
                offset: if function { index as u32 } else { offset },
                initial: parameter.initial.map(Initial::value).into_iter().collect(),
                comment: String::new(),
                span: Span::default(),
            });
        }
        if function {
            interface.instance_size = 0;
        }
        interface
    }

    /// Every parameter with its type and its bit in an instance.
    pub(super) fn laid_out(&self) -> impl Iterator<Item = (&Parameter, DataType, u32)> {
        let (mut cursor, mut section) = (0, None);
        self.parameters.iter().map(move |parameter| {
            let data_type = parameter.data_type();
            // Each section of an instance starts at an even byte.
            if section.replace(parameter.section) != Some(parameter.section) {
                cursor = u64::next_multiple_of(cursor, 16);
            }
            let (offset, behind) = place(cursor, &data_type);
            cursor = behind;
            (parameter, data_type, offset as u32)
        })
    }

    pub(super) fn run(&self, call: &mut Call<'_, '_>) -> Reaction {
        match self.run {
            Run::Reaction(run) => return run(call),
            Run::Value(run) => {
                let answer = run(call);
                call.answer(self.parameters, answer);
            }
            Run::Instance(run) => {
                let done = run(call);
                call.machine.registers.br = u64::from(done);
            }
            Run::Unavailable(code) => super::unavailable::run(self, call, code),
        }
        Reaction::Continue
    }
}
