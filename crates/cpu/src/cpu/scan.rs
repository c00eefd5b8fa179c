//! One cycle: time passes, the cycle control point, OB 1.

use std::ops::ControlFlow;
use std::sync::atomic::Ordering;

use sieben_engine::Tracer;
use sieben_model::address::Area;

use super::Cpu;
use super::interrupting::again;
use super::pause::{Inner, Then};
use super::run::{Go, Outcome};
use super::stop::Held;
use crate::clock::TimeSource;
use crate::clock::clock_memory;
use crate::host::Slice;
use crate::interrupts::Again;
use crate::mode::OperatingMode;
use crate::organization_blocks as ob;
use crate::process_image;
use crate::start_information::StartInformation;

/// What a scan did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScanReport {
    /// The cycle, counted from 1 since the last restart.
    pub number: u64,
    /// Whether the cycle ran; not in STOP and HOLD.
    pub executed: bool,
    /// The mode after the scan.
    pub mode: OperatingMode,
    /// How long the CPU worked, in microseconds; 0 in virtual time.
    pub execution_us: u64,
    /// Safe points that the program passed.
    pub safe_points: u64,
    /// Events of [`Cpu::raise_at_safe_point`] that did not happen because the cycle had not so many safe points.
    pub events_missed: usize,
}

impl Cpu {
    /// One cycle at a point in time, in microseconds of a clock that began at 0; the clock stands still inside the scan.
    /// In STOP and HOLD only time passes.
    pub fn scan(&mut self, now_us: u64) -> ScanReport {
        self.scan_with(&mut || now_us, None)
    }

    /// As [`Self::scan`], with someone who is told of every statement.
    pub fn scan_traced(&mut self, now_us: u64, tracer: &mut dyn Tracer) -> ScanReport {
        self.scan_with(&mut || now_us, Some(tracer))
    }

    /// One cycle with a clock (microseconds), which is asked again inside the scan in real time.
    pub fn scan_with(&mut self, clock: &mut dyn FnMut() -> u64, mut tracer: Option<&mut dyn Tracer>) -> ScanReport {
        self.end_pause(clock);
        if let Some(newer) = self.engine.newer() {
            self.engine = newer;
        }
        let begin_us = clock();
        if !self.only_waits()
            && let ControlFlow::Break(paused) = self.serve_until(begin_us, clock, again(&mut tracer))
        {
            return self.pause(paused, Then::Cycle { until_us: begin_us });
        }
        self.cycle_from(begin_us, clock, tracer)
    }

    /// The cycle, when the time has passed.
    #[inline]
    pub(super) fn cycle_from(&mut self, begin_us: u64, clock: &mut dyn FnMut() -> u64, mut tracer: Option<&mut dyn Tracer>) -> ScanReport {
        self.advance(begin_us);
        // Looked at first: to write what other threads write to takes longer than many a program.
        let stop = &self.requests.stop;
        if self.mode == OperatingMode::Run && stop.load(Ordering::Relaxed) && stop.swap(false, Ordering::Relaxed) {
            self.stop();
        }
        if self.mode != OperatingMode::Run {
            return self.report(false, 0);
        }
        if let Some(stack) = self.interrupted.take() {
            // After a hot restart the rest of the interrupted cycle comes first, without the cycle control point.
            self.put_stack(stack);
            self.watchdog = self.new_watchdog();
            let outcome = self.run(Go::Resume, clock, again(&mut tracer));
            return self.after_cycle(outcome, clock, tracer);
        }
        self.cycle.begin(self.now_us);
        self.cycle_control_point();
        self.watchdog = self.new_watchdog();
        // Modules may have answered to their new outputs.
        if let ControlFlow::Break(paused) = self.serve_waiting(clock, &mut tracer) {
            return self.pause(paused, Then::Program);
        }
        self.run_program(clock, tracer)
    }

    /// OB 1.
    #[inline]
    pub(super) fn run_program(&mut self, clock: &mut dyn FnMut() -> u64, mut tracer: Option<&mut dyn Tracer>) -> ScanReport {
        if self.mode != OperatingMode::Run {
            return self.report(true, 0);
        }
        self.class = StartInformation::cycle(self.restart, self.cycle.number, &self.cycle.times);
        let registers = self.preset.take();
        let outcome = if self.interrupts.is_available(ob::CYCLE.number) {
            let entry = self.entry(ob::CYCLE, registers);
            self.run(Go::Enter(entry), clock, again(&mut tracer))
        } else {
            Outcome::Finished
        };
        self.after_cycle(outcome, clock, tracer)
    }

    /// Goes on after HOLD; in other modes nothing happens.
    pub fn resume(&mut self, now_us: u64) -> ScanReport {
        self.resume_with(&mut || now_us, None)
    }

    /// As [`Self::resume`], with a clock and someone who watches statements.
    pub fn resume_with(&mut self, clock: &mut dyn FnMut() -> u64, mut tracer: Option<&mut dyn Tracer>) -> ScanReport {
        let held_at = self.now_us;
        self.advance(clock());
        let Some(held) = self.held.take() else { return self.report(false, 0) };
        // Neither timers nor the cycle time count in HOLD.
        self.watchdog.started_us = self.watchdog.started_us.saturating_add(self.now_us - held_at);
        self.log(StartInformation { event: 0x4306, ..self.class }, None);
        self.mode = if held == Held::Startup { OperatingMode::Startup } else { OperatingMode::Run };
        self.interrupts.clock_set(0x3506, &self.now(), Again::of(self.cpu_type), &self.class);
        if held == Held::Background {
            // What interrupted OB 90 ends, and OB 90 waits for the next pause.
            self.slice = Some(Slice::Until(0));
        }
        let outcome = match self.run(Go::Resume, clock, again(&mut tracer)) {
            Outcome::Paused(rest) => return self.pause((rest, Inner::Block), Then::Held(held)),
            outcome => outcome,
        };
        self.after_held(held, outcome, clock, tracer)
    }

    pub(super) fn after_held(
        &mut self,
        held: Held,
        outcome: Outcome,
        clock: &mut dyn FnMut() -> u64,
        tracer: Option<&mut dyn Tracer>,
    ) -> ScanReport {
        match held {
            Held::Startup => {
                self.after_startup(outcome);
                self.report(true, 0)
            }
            Held::Cycle => self.after_cycle(outcome, clock, tracer),
            Held::Interrupt => {
                self.after_interrupt(outcome);
                self.report(true, 0)
            }
            Held::Background => {
                self.after_background(outcome);
                self.report(true, 0)
            }
        }
    }

    /// Time passes: modules go on in every mode, the CPU clock in STARTUP and RUN.
    #[inline]
    pub(super) fn advance(&mut self, now_us: u64) {
        let now = now_us.max(self.now_us);
        if matches!(self.mode, OperatingMode::Startup | OperatingMode::Run) {
            self.machine.clock_us = self.machine.clock_us.saturating_add(now - self.now_us);
        }
        self.now_us = now;
        self.rack.advance(now - self.rack_us);
        self.rack_us = now;
    }

    #[inline]
    pub(super) fn cycle_control_point(&mut self) {
        let forces = !self.forced.is_empty();
        if forces {
            self.forced.put_outputs(&mut self.machine);
            self.images.changed();
        }
        let failures = self.images.exchange(&mut self.machine, &mut self.rack, &mut self.overrides);
        if forces {
            self.forced.put_inputs(&mut self.machine);
            self.images.changed();
        }
        if !(failures.is_empty() && self.image_failures.is_empty()) {
            for error in process_image::errors(self.settings.image_errors, &self.image_failures, &failures) {
                self.interrupts.raise(error, &self.class, self.now_us);
            }
            self.image_failures = failures;
        }
        if let Some(byte) = self.settings.clock_memory_byte
            && let Some(byte) = self.machine.memory.area_mut(Area::BitMemory).get_mut(usize::from(byte))
        {
            *byte = clock_memory(self.machine.clock_us.saturating_sub(self.system.clock_memory_from_us));
        }
    }

    #[inline]
    pub(super) fn after_cycle(
        &mut self,
        outcome: Outcome,
        clock: &mut dyn FnMut() -> u64,
        mut tracer: Option<&mut dyn Tracer>,
    ) -> ScanReport {
        self.registers = self.machine.registers.clone();
        match outcome {
            Outcome::Paused(rest) => return self.pause((rest, Inner::Block), Then::AfterProgram),
            // What came after the last safe point, or was held up until the end.
            Outcome::Finished => {
                self.torn = false;
                if let ControlFlow::Break(paused) = self.serve_waiting(clock, &mut tracer) {
                    return self.pause(paused, Then::EndOfCycle);
                }
            }
            Outcome::Suspended => self.hold(Held::Cycle),
            Outcome::Stopped(..) if self.system.reboot => {
                if let ControlFlow::Break(paused) = self.reboot(clock, tracer) {
                    return self.pause(paused, Then::Reboot);
                }
            }
            Outcome::Stopped(reason, first) => self.enter_stop(reason, first),
        }
        self.end_cycle(clock)
    }

    /// The cycle is over.
    #[inline]
    pub(super) fn end_cycle(&mut self, clock: &mut dyn FnMut() -> u64) -> ScanReport {
        let end = match self.settings.time {
            TimeSource::Virtual => self.now_us,
            TimeSource::Real => clock().max(self.now_us),
        };
        let execution = self.cycle.end(end);
        self.report(true, execution)
    }

    #[inline]
    pub(super) fn report(&mut self, executed: bool, execution_us: u64) -> ScanReport {
        let safe_points = if executed { self.watchdog.total } else { 0 };
        let events_missed = if executed { self.interrupts.drop_scheduled() } else { 0 };
        ScanReport { number: self.cycle.number, executed, mode: self.mode, execution_us, safe_points, events_missed }
    }
}
