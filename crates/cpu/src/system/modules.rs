//! Which module answers at an address, and where it is plugged in: rack 0, the first module in slot 4.

use std::ops::Range;

use sieben_model::address::Width;

use crate::io::{IoModule, Rack};

use super::Call;

/// No module has this address, or IOID is wrong.
pub(super) const NO_MODULE: u16 = 0x8090;
/// The module does not know the data record, or no data records at all.
pub(super) const NO_RECORD: u16 = 0x80B0;

/// The slot of the first module behind power supply, CPU and interface module.
pub(crate) const FIRST_SLOT: u16 = 4;

/// IOID of inputs and of outputs.
pub(super) const IOID_INPUT: u8 = 0x54;
const IOID_OUTPUT: u8 = 0x55;

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

impl<'h> Call<'_, 'h> {
    /// The module that IOID and LADDR name, and whether they name an output; parameter `ioid` is followed by the address.
    pub(super) fn addressed(&mut self, ioid: usize) -> Result<(Plugged<'_>, bool, u32), u16> {
        let area = self.input(ioid, Width::Byte)? as u8;
        let byte = self.input(ioid + 1, Width::Word)?;
        let output = match area {
            IOID_INPUT => false,
            IOID_OUTPUT => true,
            _ => return Err(NO_MODULE),
        };
        let found = at(self.host.rack, byte, output).ok_or(NO_MODULE)?;
        Ok((found, output, byte))
    }
}
