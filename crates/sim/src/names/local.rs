//! Variables of a block that runs: where they lie depends on who called it.

use sieben_engine::access::{load_file, locate_far};
use sieben_engine::ir::{Place, Var};
use sieben_engine::machine::{Register, Registers};
use sieben_engine::{Machine, Program, access};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Section, Variable};
use sieben_model::types::DataType;

use super::parsing::reach;
use super::{Name, NameError, Target};

/// The block whose variables are called by their names alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scope {
    /// The block.
    pub block: BlockId,
    /// Its variables are written without `#`, and stand before everything else of the same name.
    pub bare: bool,
}

/// A variable of a block, or a part of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Local {
    pub(super) block: BlockId,
    base: Base,
    pub(super) data_type: DataType,
}

/// Where a variable begins. Positions are in bits.
#[derive(Clone, Debug, PartialEq)]
enum Base {
    /// In the local data.
    Temp(u32),
    /// In the instance.
    Instance(u32),
    /// Behind a POINTER in the instance.
    InstancePointer { position: u32, offset: u32 },
    /// Behind the pointer that the caller gave.
    Parameter { index: u16, offset: u32 },
    /// Behind the POINTER that the caller gave a pointer to.
    ParameterPointer { index: u16, offset: u32 },
    /// The number of a timer, counter or block that the caller gave.
    Number(u16),
}

/// Where a variable lies at a moment.
pub(super) enum Spot {
    /// A byte of the arena, and the bit in it.
    Arena(usize, u8),
    /// A number that the caller gave.
    Number(u16),
}

/// A temporary of a register file that holds a pointer.
const POINTER: Var = Var(Register::COUNT as u8);

impl Local {
    /// Reads `name.path[3]` as a variable of a block of the program.
    pub(super) fn parse(block: BlockId, text: &str, program: &Program) -> Result<Self, NameError> {
        let Some(code) = program.code.get(&block) else {
            return Err(NameError::new(format!("the program has no `{block}`, whose `#{text}` is asked for")));
        };
        let (head, rest) = text.split_at(text.find(['.', '[']).unwrap_or(text.len()));
        let Some(variable) = code.interface.variable(head.trim().trim_matches('"')) else {
            if let Some(address) = Self::address(text) {
                return Ok(Self::at(block, address));
            }
            let names: Vec<String> = code.interface.variables.iter().take(8).map(|variable| format!("`#{}`", variable.name)).collect();
            let known = match names.is_empty() {
                true => "no variables".to_owned(),
                false => format!("no `#{head}`; its variables begin with {}", names.join(", ")),
            };
            return Err(NameError::new(format!("`{block}` has {known}")));
        };
        let (offset, data_type) =
            reach(variable.data_type.clone(), rest).map_err(|part| NameError::new(format!("`#{}` has no `{part}`", variable.name)))?;
        let local = Self { block, base: Base::of(block, variable, code.copied_parameters().get(&(variable.offset as u16))), data_type };
        Ok(local.moved(offset))
    }

    /// An address of the local data, `LW 2`.
    pub(super) fn address(text: &str) -> Option<Address> {
        match Operand::parse(text) {
            Some(Operand::Address(address)) if address.area == Area::Local && address.bit < 8 => Some(address),
            _ => None,
        }
    }

    /// What lies at an address of the local data of a block.
    pub(super) fn at(block: BlockId, address: Address) -> Self {
        let data_type = match address.width {
            Width::Bit => DataType::Bool,
            Width::Byte => DataType::Byte,
            Width::Word => DataType::Word,
            Width::DoubleWord => DataType::DoubleWord,
            Width::QuadWord => DataType::LongWord,
        };
        Self { block, base: Base::Temp(address.byte.saturating_mul(8) + u32::from(address.bit)), data_type }
    }

    fn moved(mut self, by: u32) -> Self {
        match &mut self.base {
            Base::Temp(at) | Base::Instance(at) => *at += by,
            Base::InstancePointer { offset, .. } | Base::Parameter { offset, .. } | Base::ParameterPointer { offset, .. } => *offset += by,
            Base::Number(_) => {}
        }
        self
    }

    /// Whether each instance has its own.
    pub(super) fn is_in_instance(&self) -> bool {
        matches!(self.base, Base::Instance(_))
    }

    /// Bits of its value.
    pub(super) fn bits(&self) -> u32 {
        u32::try_from(self.data_type.bits()).unwrap_or(u32::MAX)
    }

    /// How it is accessed, if it is a single value of at most 64 bits.
    pub(super) fn width(&self) -> Option<Width> {
        if matches!(self.data_type, DataType::String(_) | DataType::Array { .. } | DataType::Struct(_) | DataType::Instance { .. }) {
            return None;
        }
        Some(match self.bits() {
            1 => Width::Bit,
            8 => Width::Byte,
            16 => Width::Word,
            32 => Width::DoubleWord,
            64 => Width::QuadWord,
            _ => return None,
        })
    }

    /// Where it lies in a machine with these registers; `None` if the block does not run, or if what runs is called by it and hides the
    /// instance.
    pub(super) fn spot(&self, machine: &Machine, registers: &Registers) -> Option<Spot> {
        let index = machine.frames.iter().rposition(|frame| frame.block == self.block)?;
        let frame = &machine.frames[index];
        let newest = index + 1 == machine.frames.len();
        let mut file = load_file(registers);
        let local = |outwards: usize| match index.checked_sub(outwards).and_then(|index| machine.frames.get(index)) {
            Some(frame) => {
                let start = machine.memory.layout.local.start + frame.local_base as usize;
                start..start + frame.local_size as usize
            }
            None => 0..0,
        };
        let given = |index: u16| {
            let at = frame.parameters.checked_add(u32::from(index)).filter(|&at| at < frame.parameters_end)?;
            machine.parameters.get(at as usize).map(|&pointer| u64::from(pointer))
        };
        // Where a POINTER lies that leads on: number of the data block, pointer.
        let behind = |place: Place, file: &mut access::File| -> Option<()> {
            let access::Target::Arena(at, _) = locate_far(machine, file, &local, place, Width::DoubleWord, false).ok()? else {
                return None;
            };
            let bytes = machine.memory.arena.get(at..at + 6)?;
            let number = u64::from(u16::from_be_bytes([bytes[0], bytes[1]]));
            let pointer = u64::from(u32::from_be_bytes([bytes[2], bytes[3], bytes[4], bytes[5]]));
            file[usize::from(POINTER.0)] = number << 32 | pointer;
            Some(())
        };
        let instance = |position: u32| Place::Indirect { area: Area::InstanceData, pointer: Register::Ar2.into(), offset: position };
        let place = match self.base {
            Base::Temp(position) => Place::Fixed { area: Area::Local, position },
            // DI and AR2 are those of the block that runs now.
            Base::Instance(_) | Base::InstancePointer { .. } if !newest => return None,
            Base::Instance(position) => instance(position),
            Base::InstancePointer { position, offset } => {
                behind(instance(position), &mut file)?;
                Place::Crossing { pointer: POINTER, offset }
            }
            Base::Parameter { index, offset } => {
                file[usize::from(POINTER.0)] = given(index)?;
                Place::Crossing { pointer: POINTER, offset }
            }
            Base::ParameterPointer { index, offset } => {
                file[usize::from(POINTER.0)] = given(index)?;
                behind(Place::Crossing { pointer: POINTER, offset: 0 }, &mut file)?;
                Place::Crossing { pointer: POINTER, offset }
            }
            Base::Number(index) => return Some(Spot::Number(given(index)? as u16)),
        };
        match locate_far(machine, &file, &local, place, self.width().unwrap_or(Width::Byte), false).ok()? {
            access::Target::Arena(at, bit) => Some(Spot::Arena(at, bit)),
            access::Target::Peripheral(_) => None,
        }
    }

    /// The bytes of a value that is no number.
    pub(super) fn bytes<'m>(&self, machine: &'m Machine, registers: &Registers) -> Option<&'m [u8]> {
        let Spot::Arena(at, _) = self.spot(machine, registers)? else { return None };
        machine.memory.arena.get(at..at.checked_add(usize::try_from(self.data_type.bits().div_ceil(8)).ok()?)?)
    }

    /// The bits of a value that is a number.
    pub(super) fn read(&self, machine: &Machine, registers: &Registers) -> Option<u64> {
        match self.spot(machine, registers)? {
            Spot::Number(number) => Some(u64::from(number)),
            Spot::Arena(at, bit) => {
                let width = self.width()?;
                (at + width.bytes() as usize <= machine.memory.arena.len()).then(|| machine.memory.read_wide(at, bit, width))
            }
        }
    }

    /// What it is called with its block, wherever the run stands.
    pub(super) fn full_text(&self, text: &str) -> String {
        match text.split_once('#') {
            Some((_, path)) => format!("{}.#{path}", self.block),
            None => format!("{}.#{text}", self.block),
        }
    }
}

impl Base {
    fn of(block: BlockId, variable: &Variable, copy: Option<&u32>) -> Self {
        let is_number = matches!(
            variable.data_type,
            DataType::Timer
                | DataType::Counter
                | DataType::BlockFunction
                | DataType::BlockFunctionBlock
                | DataType::BlockData
                | DataType::BlockSystemData
        );
        let index = variable.offset as u16;
        let by_pointer = is_passed_by_pointer(&variable.data_type);
        match (variable.section, block.kind) {
            (Section::Temp, _) => Self::Temp(variable.offset),
            (_, BlockKind::Function) if is_number => Self::Number(index),
            (_, BlockKind::Function) => match copy {
                Some(&position) => Self::Temp(position),
                None if by_pointer => Self::ParameterPointer { index, offset: 0 },
                None => Self::Parameter { index, offset: 0 },
            },
            (Section::InOut, _) if by_pointer => Self::InstancePointer { position: variable.offset, offset: 0 },
            _ => Self::Instance(variable.offset),
        }
    }
}

/// Types whose parameter is a POINTER to the value.
fn is_passed_by_pointer(data_type: &DataType) -> bool {
    !data_type.is_elementary() && !matches!(data_type, DataType::Pointer | DataType::Any)
}

/// Variables of a block, with the single values that they are made of; `values_max` of each at most.
pub fn variables_of(block: BlockId, program: &Program, values_max: usize) -> Vec<(Section, Name, DataType)> {
    let Some(code) = program.code.get(&block) else { return Vec::new() };
    let mut all = Vec::new();
    for variable in &code.interface.variables {
        let mut left = values_max;
        let path = format!("#{}", variable.name);
        parts(&variable.data_type, &path, &mut left, &mut |path, data_type| {
            if let Ok(local) = Local::parse(block, &path[1..], program) {
                all.push((variable.section, Name { text: path.to_owned(), target: Target::Local(local) }, data_type.clone()));
            }
        });
    }
    all
}

/// The single values of a type, each with its path.
fn parts(data_type: &DataType, path: &str, left: &mut usize, say: &mut dyn FnMut(&str, &DataType)) {
    match data_type {
        _ if *left == 0 => {}
        DataType::Struct(structure) | DataType::Instance { structure, .. } => {
            for field in &structure.fields {
                parts(&field.data_type, &format!("{path}.{}", field.name), left, say);
            }
        }
        DataType::Array { bounds, element } => {
            let mut indices: Vec<i32> = bounds.iter().map(|&(low, _)| low).collect();
            while *left > 0 {
                let shown: Vec<String> = indices.iter().map(ToString::to_string).collect();
                parts(element, &format!("{path}[{}]", shown.join(",")), left, say);
                // The next element: the last index counts fastest.
                let Some(dimension) = (0..bounds.len()).rev().find(|&dimension| indices[dimension] < bounds[dimension].1) else { return };
                indices[dimension] += 1;
                for (index, &(low, _)) in indices.iter_mut().zip(bounds).skip(dimension + 1) {
                    *index = low;
                }
            }
        }
        DataType::Void => {}
        _ => {
            *left -= 1;
            say(path, data_type);
        }
    }
}
