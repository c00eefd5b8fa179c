//! A data block that comes from outside in place of one that the program has: whether its values can take the place of the others.

use std::fmt;
use std::sync::Arc;

use sieben_model::block::BlockKind;
use sieben_model::program::DataBlock;
use sieben_model::types::{DataType, Structure};

/// Why the values of a data block are not replaced. Nothing has changed. What is not only values is an online change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReplaceRefused {
    /// There is no such data block.
    NotLoaded(u16),
    /// The program made it at run time: it has no place in the load memory.
    Created(u16),
    /// The two have different lengths, in bytes: what is there, and what came.
    Length(u16, usize, usize),
    /// READ_ONLY, NON_RETAIN and UNLINKED are not the same.
    Attributes(u16),
    /// It is an instance, and the other one has values of other types, or is an instance of another block.
    Structure(u16),
    /// The CPU is in the middle of a scan or startup.
    Running,
}

impl fmt::Display for ReplaceRefused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotLoaded(number) => write!(f, "DB{number} is not loaded"),
            Self::Created(number) => write!(f, "DB{number} was made by the program and has no place in the load memory"),
            Self::Length(number, old, new) => write!(f, "DB{number} has {old} bytes, not {new}"),
            Self::Attributes(number) => write!(f, "READ_ONLY, NON_RETAIN or UNLINKED of DB{number} is not as the program has it"),
            Self::Structure(number) => write!(f, "DB{number} is an instance, and the values are not those of its block"),
            Self::Running => f.write_str("the CPU is in the middle of a scan"),
        }
    }
}

impl std::error::Error for ReplaceRefused {}

/// Whether the values of `new` can take the place of those of `old`. Of a shared data block only its length counts: programs reach its bytes
/// by their addresses. An instance has its values where its block expects them, whatever they are called.
pub(crate) fn judge(old: &DataBlock, new: &DataBlock) -> Result<(), ReplaceRefused> {
    let number = old.number;
    if old.image.len() != new.image.len() {
        return Err(ReplaceRefused::Length(number, old.image.len(), new.image.len()));
    }
    let attributes = |block: &DataBlock| (block.read_only, block.non_retain, block.unlinked);
    if attributes(old) != attributes(new) {
        return Err(ReplaceRefused::Attributes(number));
    }
    let is_instance =
        |block: &DataBlock| block.based_on.is_some_and(|id| matches!(id.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock));
    if (is_instance(old) || is_instance(new)) && (old.based_on != new.based_on || !same_places(&old.structure, &new.structure)) {
        return Err(ReplaceRefused::Structure(number));
    }
    Ok(())
}

/// Whether two structures have values of the same types in the same places.
fn same_places(old: &Arc<Structure>, new: &Arc<Structure>) -> bool {
    let fields = |structure: &Structure| structure.fields.len();
    let same = old.fields.iter().zip(&new.fields).all(|(old, new)| old.offset == new.offset && same_type(&old.data_type, &new.data_type));
    Arc::ptr_eq(old, new) || old.size == new.size && fields(old) == fields(new) && same
}

fn same_type(old: &DataType, new: &DataType) -> bool {
    match (old, new) {
        (DataType::Struct(old), DataType::Struct(new)) => same_places(old, new),
        (DataType::Instance { block: old_block, structure: old }, DataType::Instance { block, structure: new }) => {
            old_block == block && same_places(old, new)
        }
        (DataType::Array { bounds: old_bounds, element: old }, DataType::Array { bounds, element: new }) => {
            old_bounds == bounds && same_type(old, new)
        }
        _ => old == new,
    }
}
