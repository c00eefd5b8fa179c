//! What the controllers SFB 41 and 42 have in common: process value, error and dead band.

use super::instance::Instance;

/// A full-scale peripheral value: 100 %.
const FULL_SCALE: f32 = 27_648.0;

/// Where the inputs of a controller lie in its instance.
pub(super) struct Inputs {
    /// Bit of byte 0: the process value comes from the periphery.
    pub(super) periphery: u8,
    pub(super) setpoint: usize,
    pub(super) value: usize,
    pub(super) value_periphery: usize,
    pub(super) factor: usize,
    pub(super) offset: usize,
    pub(super) dead_band: usize,
}

impl Inputs {
    /// Process value and error signal, behind the dead band.
    pub(super) fn read(&self, instance: &Instance<'_>) -> (f32, f32) {
        let value = if instance.bit(0, self.periphery) {
            let percent = f32::from(instance.int(self.value_periphery)) * 100.0 / FULL_SCALE;
            percent * instance.real(self.factor) + instance.real(self.offset)
        } else {
            instance.real(self.value)
        };
        let error = instance.real(self.setpoint) - value;
        let band = instance.real(self.dead_band);
        let error = if error < -band {
            error + band
        } else if error > band {
            error - band
        } else {
            0.0
        };
        (value, error)
    }
}

/// A manipulated value in percent as a peripheral word.
pub(super) fn to_periphery(percent: f32) -> i16 {
    // A cast saturates; NaN becomes 0.
    (percent * FULL_SCALE / 100.0).round_ties_even() as i16
}
