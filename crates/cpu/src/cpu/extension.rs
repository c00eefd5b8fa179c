//! What extended programs can do to the controller itself, and what their assertions leave behind.

use std::ops::ControlFlow;

use sieben_engine::Tracer;
use sieben_model::extension::FailedAssertion;

use super::Cpu;
use super::pause::{Inner, Paused};
use super::run::{Go, Outcome};
use crate::cycle::Cycle;
use crate::host::Watchdog;
use crate::mode::{OperatingMode, Restart};
use crate::organization_blocks as ob;
use crate::start_information::StartInformation;

impl Cpu {
    /// The assertion of an extension word that sent the CPU to STOP.
    pub fn failed_assertion(&self) -> Option<&FailedAssertion> {
        self.system.failed_assertion.as_ref()
    }

    /// `__REBOOT`: the startup organization block again, memory is kept.
    pub(super) fn reboot(&mut self, clock: &mut dyn FnMut() -> u64, tracer: Option<&mut dyn Tracer>) -> ControlFlow<Paused> {
        self.system.reboot = false;
        self.machine.frames.clear();
        self.machine.parameters.clear();
        self.cycle = Cycle::default();
        self.restart = Restart::Warm;
        self.class = StartInformation::startup(self.restart, 0, self.cpu_type.has_ob88);
        self.system.restart(self.machine.clock_us, true, self.class);
        self.interrupts.startup(false);
        self.mode = OperatingMode::Startup;
        self.log(StartInformation { event: 0x4301, ..self.class }, None);
        self.watchdog = Watchdog::new(true, self.now_us, self.watchdog_us(), self.settings.virtual_safe_points);
        let block = ob::startup(self.restart);
        if self.engine.has_block(block) {
            let entry = self.entry(block, None);
            match self.run(Go::Enter(entry), clock, tracer) {
                Outcome::Paused(rest) => return ControlFlow::Break((rest, Inner::Block)),
                outcome => self.after_startup(outcome),
            }
        } else {
            self.after_startup(Outcome::Finished);
        }
        ControlFlow::Continue(())
    }
}
