//! OB 90 (S7-400): what the CPU does while it waits for the next cycle.

use std::ops::ControlFlow;
use std::sync::atomic::Ordering;

use sieben_engine::Tracer;

use super::Cpu;
use super::interrupting::again;
use super::run::{Go, Outcome, Rest};
use super::stop::Held;
use crate::clock::TimeSource;
use crate::host::Slice;
use crate::mode::OperatingMode;
use crate::organization_blocks as ob;
use crate::start_information::StartInformation;

/// Safe points that OB 90 gets in one pause in virtual time, where no clock tells how long the pause is.
const SLICE_POINTS: u64 = 1000;

impl Cpu {
    /// Whether OB 90 runs while the CPU waits for the least cycle time.
    pub fn has_background(&self) -> bool {
        self.mode == OperatingMode::Run && !self.settings.min_cycle.is_zero() && self.interrupts.is_available(ob::BACKGROUND.number)
    }

    /// Runs OB 90 in a pause that lasts to `until_us`, from its beginning or from where the last pause ended.
    /// In virtual time it is a limited number of safe points; in real time it starts again and again until the time has come.
    pub(super) fn background(
        &mut self,
        until_us: u64,
        clock: &mut dyn FnMut() -> u64,
        tracer: &mut Option<&mut dyn Tracer>,
    ) -> ControlFlow<(Rest, StartInformation)> {
        if !self.has_background() || until_us <= self.now_us {
            return ControlFlow::Continue(());
        }
        let class = self.class;
        let resumed = self.paused.take().map(|stack| self.put_stack(stack)).is_some();
        if !resumed {
            self.class = StartInformation::background(!self.background_began);
            self.background_began = true;
        }
        let go = if resumed { Go::Resume } else { Go::Enter(self.entry(ob::BACKGROUND, None)) };
        self.watchdog = self.new_watchdog();
        self.slice = Some(match self.settings.time {
            TimeSource::Virtual => Slice::Points(SLICE_POINTS),
            TimeSource::Real => Slice::Until(until_us),
        });
        match self.run(go, clock, again(tracer)) {
            Outcome::Paused(rest) => return ControlFlow::Break((rest, class)),
            outcome => self.after_background(outcome),
        }
        if matches!(self.mode, OperatingMode::Run) {
            self.class = class;
        }
        ControlFlow::Continue(())
    }

    pub(super) fn after_background(&mut self, outcome: Outcome) {
        let ended = self.slice.take().is_none();
        match outcome {
            Outcome::Finished | Outcome::Paused(_) => {}
            Outcome::Suspended if ended => self.paused = self.take_stack(),
            Outcome::Suspended => self.hold(Held::Background),
            Outcome::Stopped(reason, first) => self.enter_stop(reason, first),
        }
    }

    /// Runs OB 90 and interrupts until the clock shows `until_us`, instead of waiting; in real time. Ends sooner if somebody wants to come in
    /// ([`super::StopRequest::let_in`]).
    pub fn background_with(&mut self, until_us: u64, clock: &mut dyn FnMut() -> u64) {
        loop {
            self.serve_with(clock, None);
            if self.now_us >= until_us || !self.has_background() {
                return;
            }
            let next = self.next_interrupt_us().map_or(until_us, |next| next.min(until_us));
            // Without a tracer nothing pauses.
            let _ = self.background(next, clock, &mut None);
            if self.requests.visit.swap(false, Ordering::Relaxed) {
                return;
            }
        }
    }
}
