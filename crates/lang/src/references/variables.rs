//! Names of variables by where they lie.

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::types::{DataType, Structure};

use super::target::Extent;

/// What is looked for at a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// A value that an instruction reads or writes.
    Elementary,
    /// Something of so many bits.
    Bits(u64),
    /// The largest variable that begins there.
    Outermost,
    /// An instance of this block.
    Instance(BlockId),
}

impl From<Extent> for Wanted {
    fn from(extent: Extent) -> Self {
        match extent {
            Extent::Width(_) => Self::Elementary,
            Extent::Bits(bits) => Self::Bits(u64::from(bits)),
            Extent::Unknown => Self::Outermost,
        }
    }
}

/// The path of the field that begins at this bit: `motor.speed`, `values[3]`. `None` inside an elementary value.
pub(crate) fn field_path(structure: &Structure, position: u64, wanted: Wanted) -> Option<String> {
    let field = structure.fields.iter().rev().find(|field| {
        let start = u64::from(field.offset);
        (start..start + field.data_type.bits().max(1)).contains(&position)
    })?;
    Some(format!("{}{}", field.name, element_path(&field.data_type, position - u64::from(field.offset), wanted)?))
}

/// What stands behind the name of a variable of this type for the element that begins at this bit of it.
fn element_path(data_type: &DataType, position: u64, wanted: Wanted) -> Option<String> {
    let is_this = match wanted {
        Wanted::Elementary => false,
        Wanted::Bits(bits) => data_type.bits() == bits,
        Wanted::Outermost => true,
        Wanted::Instance(wanted) => matches!(data_type, DataType::Instance { block, .. } if *block == wanted),
    };
    if position == 0 && is_this {
        return Some(String::new());
    }
    match data_type {
        DataType::Struct(structure) | DataType::Instance { structure, .. } => {
            field_path(structure, position, wanted).map(|path| format!(".{path}"))
        }
        DataType::Array { bounds, element } => {
            let (mut low, mut high) = (0, data_type.elements());
            // The last element that begins at or before the position.
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                if data_type.element_offset(middle) <= position { low = middle } else { high = middle }
            }
            let inside = element_path(element, position.checked_sub(data_type.element_offset(low))?, wanted)?;
            let mut indices = Vec::with_capacity(bounds.len());
            let mut rest = low;
            for &(first, last) in bounds.iter().rev() {
                let count = u64::try_from(i64::from(last) - i64::from(first) + 1).ok()?.max(1);
                indices.push((i64::from(first) + i64::try_from(rest % count).ok()?).to_string());
                rest /= count;
            }
            indices.reverse();
            Some(format!("[{}]{inside}", indices.join(",")))
        }
        _ => (position == 0).then(String::new),
    }
}

/// Which variables of a block a position is counted among.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Among {
    /// TEMP, by bits of the local data.
    Temporary,
    /// Parameters of a function, by index.
    Parameter,
    /// Parameters and static data of a function block, by bits of the instance.
    Instance,
}

/// The variable that holds a position, and how far inside it the position lies.
pub(crate) fn variable(interface: &Interface, among: Among, position: u32) -> Option<(&Variable, u64)> {
    interface.variables.iter().rev().find_map(|variable| {
        let belongs = match among {
            Among::Temporary => variable.section == Section::Temp,
            Among::Parameter => variable.is_parameter(),
            Among::Instance => variable.section != Section::Temp,
        };
        let length = if among == Among::Parameter { 1 } else { variable.data_type.bits().max(1) };
        let inside = u64::from(position.checked_sub(variable.offset)?);
        (belongs && inside < length).then_some((variable, inside))
    })
}

/// `#name.path` of what begins `offset` bits inside the variable at a position.
pub(crate) fn name(interface: &Interface, among: Among, position: u32, offset: u32, wanted: Wanted) -> Option<String> {
    let (variable, inside) = variable(interface, among, position)?;
    let path = element_path(&variable.data_type, inside + u64::from(offset), wanted)?;
    Some(format!("#{}{path}", variable.name))
}

/// Where the variables of a block of this kind lie that are not temporary.
pub(crate) fn among_of(kind: BlockKind) -> Among {
    if kind == BlockKind::Function { Among::Parameter } else { Among::Instance }
}
