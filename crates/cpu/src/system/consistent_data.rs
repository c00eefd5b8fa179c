//! What SFC 14 and 15 have in common: the bytes of a module that belong together.

use std::ops::Range;

use sieben_model::address::Width;

use super::Call;

/// No module has this address.
const NO_MODULE: u16 = 0x8090;
/// The ANY is not one of BYTE.
const NOT_BYTE: u16 = 0x8092;
/// The module has fewer bytes.
const LENGTH: u16 = 0x80B1;
/// The type code of BYTE in an ANY.
const BYTE: u8 = 0x02;

impl Call<'_, '_> {
    /// The first byte of the module, from parameter 0, and the bytes of RECORD in the arena. `output` is whether all its bytes
    /// must be outputs.
    pub(super) fn record(&mut self, index: usize, output: bool) -> Result<(u32, Range<usize>), u16> {
        let first = self.input(0, Width::Word)?;
        let [_, code, ..] = self.passed::<10>(index, !output)?;
        let record = self.any(index, !output)?;
        if code != BYTE {
            return Err(NOT_BYTE);
        }
        for offset in 0..record.len() as u32 {
            let byte = first + offset;
            let rack = &mut *self.host.rack;
            let value = if output { rack.peripheral_output(byte, Width::Byte) } else { rack.read_for_program(byte, Width::Byte) };
            if value.is_none() {
                return Err(if offset == 0 { NO_MODULE } else { LENGTH });
            }
        }
        Ok((first, record))
    }
}
