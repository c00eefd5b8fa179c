//! What the system functions about modules have in common: the module that IOID and LADDR name.

use sieben_model::address::Width;

use super::Call;
use crate::slots::{Plugged, at};

/// No module has this address, or IOID is wrong.
pub(super) const NO_MODULE: u16 = 0x8090;
/// The module does not know the data record, or no data records at all.
pub(super) const NO_RECORD: u16 = 0x80B0;

/// IOID of inputs and of outputs.
pub(super) const IOID_INPUT: u8 = 0x54;
const IOID_OUTPUT: u8 = 0x55;

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
