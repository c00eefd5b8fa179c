//! The modules: lists 16#xy90, 16#xy91 and 16#xy92.

use super::{SystemStatus, record, words};
use crate::slots::{self, Plugged};

/// Bytes of a record of list 16#xy92: bit n of the first is rack n.
const RACKS: usize = 16;

/// List 16#0090: DP master systems. There are none.
pub(super) fn dp_masters(_: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    Vec::new()
}

/// List 16#0A91: module state of the DP master systems, none.
pub(super) fn dp_masters_of_index_0(status: &SystemStatus<'_>, _index: u16) -> Option<Vec<Vec<u8>>> {
    Some(dp_masters(status))
}

/// Rack and slot, address, type wanted and found (0: as configured), state (0: good), area of the address.
fn state(plugged: &Plugged<'_>) -> Vec<u8> {
    let output = plugged.bytes(false).is_empty();
    let address = u16::try_from(plugged.bytes(output).start).unwrap_or(u16::MAX);
    words(16, &[0, plugged.slot << 8, address, 0, 0, 0, 0, u16::from(output)])
}

/// List 16#0091: the state of all modules.
pub(super) fn all(status: &SystemStatus<'_>) -> Vec<Vec<u8>> {
    slots::plugged(status.rack).map(|plugged| state(&plugged)).collect()
}

/// List 16#0591: the state of all submodules, which are the modules themselves.
pub(super) fn all_of_index_0(status: &SystemStatus<'_>, _index: u16) -> Option<Vec<Vec<u8>>> {
    Some(all(status))
}

/// List 16#0C91: the module at a logical address; bit 15 tells outputs from inputs.
pub(super) fn at_address(status: &SystemStatus<'_>, index: u16) -> Option<Vec<Vec<u8>>> {
    let (address, output) = (u32::from(index & 0x7FFF), index & 0x8000 != 0);
    Some(vec![state(&slots::at(status.rack, address, output)?)])
}

/// List 16#0D91: the modules of a rack; there is rack 0.
pub(super) fn in_rack(status: &SystemStatus<'_>, rack: u16) -> Option<Vec<Vec<u8>>> {
    (rack == 0).then(|| all(status))
}

/// Lists 16#0092 and 16#0292: racks that are configured, and those that are there. Index 0 is the central racks.
pub(super) fn configured_racks(_: &SystemStatus<'_>, index: u16) -> Option<Vec<Vec<u8>>> {
    (index == 0).then(|| vec![record(RACKS, &[&[1]])])
}

/// List 16#0692: racks with a fault.
pub(super) fn faulty_racks(_: &SystemStatus<'_>, index: u16) -> Option<Vec<Vec<u8>>> {
    (index == 0).then(|| vec![record(RACKS, &[])])
}
