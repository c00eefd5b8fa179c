//! The blocks of the CPU itself, laid out like those of a project.

use std::collections::HashMap;

use sieben_model::block::BlockId;
use sieben_model::interface::SystemBlock;

use super::interface::{Declared, lay_out};
use super::types::BlockInterface;

/// The system blocks by their numbers.
pub(crate) type System = HashMap<BlockId, Resident>;

/// A system block.
#[derive(Clone, Debug)]
pub(crate) struct Resident {
    pub(crate) name: &'static str,
    /// What has it, if the CPU does not.
    pub(crate) only: Option<&'static str>,
    pub(crate) interface: BlockInterface,
}

/// Lays out the system blocks. They are the same in every revision of a project.
pub(crate) fn system(blocks: &[SystemBlock]) -> System {
    let resident = |block: &SystemBlock| {
        let declared = block.interface.variables.iter().map(|variable| Declared::from_variable(variable.clone())).collect();
        let interface = lay_out(block.block, declared).expect("the variables of a system block fit a block");
        (block.block, Resident { name: block.name, only: block.only, interface })
    };
    blocks.iter().map(resident).collect()
}
