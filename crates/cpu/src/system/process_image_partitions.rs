//! What SFC 26 and 27 have in common: the partition of the process image.

use sieben_model::address::Width;

use super::Call;

/// No number of a partition.
const BAD_PARTITION: u16 = 0x8090;
/// The partition has no addresses.
const UNDEFINED: u16 = 0x8091;
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
}
