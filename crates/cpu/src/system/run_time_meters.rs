//! What SFC 2, 3 and 4 have in common: the meters.

use sieben_model::address::Width;

use super::Call;
pub(super) use crate::system_state::HOUR_US;
use crate::system_state::Meter;

/// No such meter.
const BAD_NUMBER: u16 = 0x8080;
/// Greatest value of a meter.
pub(super) const HOURS_MAX: u64 = 32_767;

impl Call<'_, '_> {
    /// The meter that parameter NR, the first one, names; and the CPU clock.
    pub(super) fn meter(&mut self) -> Result<(&mut Meter, u64), u16> {
        let number = self.input(0, Width::Byte)?;
        self.host.read_time(self.machine);
        let meter = self.host.system.meters.get_mut(number as usize).ok_or(BAD_NUMBER)?;
        Ok((meter, self.machine.clock_us))
    }
}
