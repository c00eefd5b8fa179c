//! Which module answers at an address, and where it is plugged in: rack 0, the first module in slot 4.

use std::ops::Range;

use crate::io::{IoModule, Rack};

/// The slot of the first module behind power supply, CPU and interface module.
pub(crate) const FIRST_SLOT: u16 = 4;

/// A module where it is plugged in.
pub(crate) struct Plugged<'a> {
    pub(crate) slot: u16,
    pub(crate) module: &'a dyn IoModule,
}

impl Plugged<'_> {
    /// The input or output bytes.
    pub(crate) fn bytes(&self, output: bool) -> Range<u32> {
        if output { self.module.outputs() } else { self.module.inputs() }
    }
}

/// All modules, in the order of their slots.
pub(crate) fn plugged(rack: &Rack) -> impl Iterator<Item = Plugged<'_>> {
    (FIRST_SLOT..).zip(rack.modules()).map(|(slot, module)| Plugged { slot, module })
}

/// The module that answers for a byte. Of two that could, the later one does: the first is the background of all addresses.
pub(crate) fn at(rack: &Rack, byte: u32, output: bool) -> Option<Plugged<'_>> {
    plugged(rack).filter(|plugged| plugged.bytes(output).contains(&byte)).last()
}
