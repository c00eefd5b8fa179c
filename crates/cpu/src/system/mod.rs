//! System functions: one file each, one row here.

mod sfc043_re_trigr;
mod sfc046_stp;

use sieben_engine::{Machine, Reaction};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, SystemBlock};

use crate::host::CpuHost;

/// A call: the machine, the CPU behind it, and the first parameter pointer.
pub(crate) struct Call<'a, 'h> {
    pub(crate) machine: &'a mut Machine,
    pub(crate) host: &'a mut CpuHost<'h>,
}

/// One row: number of the SFC, name, parameters, what it does.
struct Row {
    block: BlockId,
    name: &'static str,
    interface: fn() -> Interface,
    run: fn(&mut Call<'_, '_>) -> Reaction,
}

const fn sfc(number: u16, name: &'static str, interface: fn() -> Interface, run: fn(&mut Call<'_, '_>) -> Reaction) -> Row {
    Row { block: BlockId::new(BlockKind::SystemFunction, number), name, interface, run }
}

/// All system functions of the CPU, by number.
const TABLE: &[Row] = &[sfc(43, "RE_TRIGR", Interface::default, sfc043_re_trigr::run), sfc(46, "STP", Interface::default, sfc046_stp::run)];

/// The interfaces of all system functions, for those who compile and complete calls.
pub fn interfaces() -> Vec<SystemBlock> {
    TABLE.iter().map(|row| SystemBlock { block: row.block, name: row.name, interface: (row.interface)() }).collect()
}

/// Whether the CPU has this system function.
pub(crate) fn has(block: BlockId) -> bool {
    TABLE.iter().any(|row| row.block == block)
}

/// Runs a system function; `None` if the CPU does not have it.
pub(crate) fn run(block: BlockId, call: &mut Call<'_, '_>) -> Option<Reaction> {
    TABLE.iter().find(|row| row.block == block).map(|row| (row.run)(call))
}
