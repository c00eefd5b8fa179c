//! What SFC 26 and 27 have in common: the partition of the process image, and what cannot be exchanged.

use std::ops::Range;

use sieben_model::address::Width;

use super::Call;
use super::parameters::Answer;

/// No number of a partition.
const BAD_PARTITION: u16 = 0x8090;
/// The partition has no addresses.
const UNDEFINED: u16 = 0x8091;
/// A module does not answer.
const NO_ACCESS: u16 = 0x80A0;
/// Greatest number of a partition.
const PARTITION_MAX: u32 = 30;

impl Call<'_, '_> {
    /// Checks parameter PART, the first one: only 0, the whole image, has addresses.
    pub(super) fn partition(&mut self) -> Result<(), u16> {
        match self.input(0, Width::Byte)? {
            0 => Ok(()),
            1..=PARTITION_MAX => Err(UNDEFINED),
            _ => Err(BAD_PARTITION),
        }
    }

    /// Writes FLADDR, which stands behind RET_VAL: the first byte that could not be exchanged, or 0.
    pub(super) fn exchanged(&mut self, failed: &[Range<usize>]) -> Answer {
        let first = failed.first().map(|bytes| bytes.start);
        self.output(2, Width::Word, first.unwrap_or(0) as u32)?;
        if first.is_some() { Err(NO_ACCESS) } else { Ok(0) }
    }
}
