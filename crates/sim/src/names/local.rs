//! Names of the variables of a block.

use sieben_engine::Program;
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Section, Variable};
use sieben_model::item::{Item, Local, Start};
use sieben_model::types::DataType;

use super::parsing::reach;
use super::{Name, NameError};

/// The block whose variables are called by their names alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scope {
    /// The block.
    pub block: BlockId,
    /// Its variables are written without `#`, and stand before everything else of the same name.
    pub bare: bool,
}

/// Reads `name.path[3]` as a variable of a block of the program.
pub(super) fn parse(block: BlockId, text: &str, program: &Program) -> Result<Local, NameError> {
    let Some(code) = program.code.get(&block) else {
        return Err(NameError::new(format!("the program has no `{block}`, whose `#{text}` is asked for")));
    };
    let (head, rest) = text.split_at(text.find(['.', '[']).unwrap_or(text.len()));
    let Some(variable) = code.interface.variable(head.trim().trim_matches('"')) else {
        if let Some(address) = address(text) {
            return Ok(at(block, address));
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
    let start = start_of(block, variable, code.copied_parameters().get(&(variable.offset as u16)));
    Ok(Local { block, start: start.moved(offset), data_type })
}

/// An address of the local data, `LW 2`.
pub(super) fn address(text: &str) -> Option<Address> {
    match Operand::parse(text) {
        Some(Operand::Address(address)) if address.area == Area::Local && address.bit < 8 => Some(address),
        _ => None,
    }
}

/// What lies at an address of the local data of a block.
pub(super) fn at(block: BlockId, address: Address) -> Local {
    let data_type = match address.width {
        Width::Bit => DataType::Bool,
        Width::Byte => DataType::Byte,
        Width::Word => DataType::Word,
        Width::DoubleWord => DataType::DoubleWord,
        Width::QuadWord => DataType::LongWord,
    };
    Local { block, start: Start::Temp(address.byte.saturating_mul(8).saturating_add(u32::from(address.bit))), data_type }
}

/// Where a variable of a block begins; `copy` is where a function of Structured Text keeps it.
fn start_of(block: BlockId, variable: &Variable, copy: Option<&u32>) -> Start {
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
        (Section::Temp, _) => Start::Temp(variable.offset),
        (_, BlockKind::Function) if is_number => Start::Number(index),
        (_, BlockKind::Function) => match copy {
            Some(&position) => Start::Temp(position),
            None if by_pointer => Start::ParameterPointer { index, offset: 0 },
            None => Start::Parameter { index, offset: 0 },
        },
        (Section::InOut, _) if by_pointer => Start::InstancePointer { position: variable.offset, offset: 0 },
        _ => Start::Instance(variable.offset),
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
            if let Ok(local) = parse(block, &path[1..], program) {
                all.push((
                    variable.section,
                    Name { text: path.to_owned(), item: super::in_calendar(Item::local(local), program) },
                    data_type.clone(),
                ));
            }
        });
    }
    all
}

/// The single values of a type, each with its path.
pub(super) fn parts(data_type: &DataType, path: &str, left: &mut usize, say: &mut dyn FnMut(&str, &DataType)) {
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
