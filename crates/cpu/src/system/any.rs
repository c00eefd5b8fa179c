//! ANY parameters: the bytes that they mean.

use std::ops::Range;

use sieben_model::address::Area;

use super::Call;
use super::parameters::{Place, Refused, locate};

/// Bytes of one element of a type by its code in an ANY; `None` = no type that lies in memory.
pub(super) fn element_bytes(code: u8) -> Option<u32> {
    Some(match code {
        // BYTE, CHAR and, counted in bytes, STRING.
        0x02 | 0x03 | 0x13 => 1,
        // WORD, INT, DATE, S5TIME.
        0x04 | 0x05 | 0x09 | 0x0C => 2,
        // DWORD, DINT, REAL, TIME_OF_DAY, TIME.
        0x06 | 0x07 | 0x08 | 0x0A | 0x0B => 4,
        // DATE_AND_TIME.
        0x0E => 8,
        _ => return None,
    })
}

impl Call<'_, '_> {
    /// The arena bytes that an ANY parameter means.
    pub(super) fn any(&self, index: usize, write: bool) -> Result<Range<usize>, u16> {
        let any = self.passed::<10>(index, write)?;
        self.area(any, write).map_err(|refused| refused.of(index))
    }

    /// The arena bytes that an ANY means.
    pub(super) fn area(&self, any: [u8; 10], write: bool) -> Result<Range<usize>, Refused> {
        let [syntax, code, c1, c0, d1, d0, p3, p2, p1, p0] = any;
        if syntax != 0x10 {
            return Err(Refused::AREA.when(write));
        }
        let count = u32::from(u16::from_be_bytes([c1, c0]));
        let pointer = u32::from_be_bytes([p3, p2, p1, p0]);
        let bytes = match (code, element_bytes(code)) {
            // Bits only as whole bytes.
            (0x01, _) if count % 8 == 0 => count / 8,
            (0x01, _) => return Err(Refused::LENGTH.when(write)),
            (_, Some(element)) => count * element,
            _ => return Err(Refused::AREA.when(write)),
        };
        if pointer & 7 != 0 {
            return Err(Refused::BIT.when(write));
        }
        match locate(self.machine, u16::from_be_bytes([d1, d0]), pointer, bytes, write)? {
            Place::Arena(at) => Ok(at..at + bytes as usize),
            // The peripheral, timers and counters are no areas for blocks of data.
            Place::Peripheral(_) => Err(Refused::AREA.when(write)),
        }
    }

    /// Whether an ANY parameter names a data block that is only in the load memory (UNLINKED).
    pub(super) fn names_unlinked(&self, index: usize) -> bool {
        let Ok([_, _, _, _, d1, d0, area, ..]) = self.passed::<10>(index, false) else { return false };
        let number = u16::from_be_bytes([d1, d0]);
        let data = area == Area::SharedData.pointer_code() || area == Area::InstanceData.pointer_code();
        data && self.host.program.data.get(&number).is_some_and(|block| block.unlinked)
    }
}
