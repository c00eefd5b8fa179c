//! A module that cannot be copied, for the tests of what is recorded of such.

use std::ops::Range;

use sieben_cpu::interrupts::ModuleAddress;
use sieben_cpu::{Interrupt, IoModule};

/// Whether the module raises interrupts.
#[derive(Clone, Copy, PartialEq, Eq)]
#[allow(dead_code)] // Each test has modules of one kind.
pub(crate) enum Alarms {
    None,
    /// A hardware interrupt where it was written to more than once since it was asked last.
    AfterWrites,
}

/// Its inputs count what it is told and how time passes.
pub(crate) struct Wild {
    addresses: Range<u32>,
    alarms: Alarms,
    state: u8,
    writes: u32,
}

impl Wild {
    /// A module with these inputs and outputs, whose inputs begin with a value.
    pub(crate) fn new(addresses: Range<u32>, alarms: Alarms, state: u8) -> Self {
        Self { addresses, alarms, state, writes: 0 }
    }
}

impl IoModule for Wild {
    fn name(&self) -> &str {
        "wild"
    }
    fn inputs(&self) -> Range<u32> {
        self.addresses.clone()
    }
    fn outputs(&self) -> Range<u32> {
        self.addresses.clone()
    }
    fn read(&self, _: u32, into: &mut [u8]) {
        into.fill(self.state);
    }
    fn write(&mut self, _: u32, from: &[u8]) {
        self.state = self.state.wrapping_mul(31).wrapping_add(from[0]) | 1;
        self.writes += 1;
    }
    fn advance(&mut self, dt_us: u64) {
        self.state = self.state.wrapping_add(dt_us as u8);
    }
    fn alarms(&mut self) -> Vec<Interrupt> {
        let due = std::mem::take(&mut self.writes) > 1 && self.alarms == Alarms::AfterWrites;
        due.then(|| Interrupt::hardware(0, ModuleAddress::Input(self.addresses.start as u16), 7)).into_iter().collect()
    }
}
