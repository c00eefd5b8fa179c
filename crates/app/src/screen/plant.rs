//! The dosing tank as the demo uses it: with a flow meter that can fail.

use std::ops::Range;

use sieben_cpu::IoModule;
use sieben_sim::devices::dosing::{DosingPlant, DosingSettings};

/// Bit of the flow meter in the input byte of the tank.
const METER: u8 = 0x80;

/// The tank and the state of its flow meter.
#[derive(Clone, Debug)]
pub(crate) struct DosingTank {
    /// The tank.
    pub(crate) tank: DosingPlant,
    /// The flow meter gives no pulses.
    pub(crate) meter_failed: bool,
}

impl DosingTank {
    /// A full tank, an empty container, a sound flow meter.
    pub(crate) fn new() -> Self {
        let settings = DosingSettings {
            name: "dosing plant".into(),
            flow_ml_per_s: 2500,
            supply_litres: 250,
            vessel_litres: 30,
            ..DosingSettings::default()
        };
        Self { tank: DosingPlant::new(settings), meter_failed: false }
    }
}

impl IoModule for DosingTank {
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        Some(Box::new(self.clone()))
    }
    fn name(&self) -> &str {
        self.tank.name()
    }
    fn inputs(&self) -> Range<u32> {
        self.tank.inputs()
    }
    fn outputs(&self) -> Range<u32> {
        self.tank.outputs()
    }
    fn read(&self, offset: u32, into: &mut [u8]) {
        self.tank.read(offset, into);
        if self.meter_failed {
            into.iter_mut().for_each(|byte| *byte &= !METER);
        }
    }
    fn write(&mut self, offset: u32, from: &[u8]) {
        self.tank.write(offset, from);
    }
    fn advance(&mut self, dt_us: u64) {
        self.tank.advance(dt_us);
    }
}
