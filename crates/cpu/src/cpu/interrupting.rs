//! Interrupts between two cycles, and what raises them from outside.

use std::ops::ControlFlow;
use std::sync::atomic::Ordering;
use std::time::Duration;

use sieben_engine::Tracer;
use sieben_model::block::BlockId;

use super::Cpu;
use super::pause::{Inner, Paused, Then};
use super::run::{Go, Outcome};
use super::stop::Held;
use crate::clock::{DateAndTime, TimeSource};
use crate::diagnostic_buffer::DiagnosticEntry;
use crate::histogram::Histogram;
use crate::host::Watchdog;
use crate::interrupts::{CyclicInterrupt, Interrupt, Now, Request};
use crate::mode::OperatingMode;
use crate::organization_blocks as ob;
use crate::settings::ImageErrors;

impl Cpu {
    /// An interrupt or asynchronous error happens. Its organization block runs at the next safe point, or before the next scan;
    /// in STOP an error only enters the diagnostic buffer.
    pub fn raise(&mut self, interrupt: Interrupt) {
        let info = interrupt.start_information();
        match self.mode {
            OperatingMode::Stop if ob::is_asynchronous_error(u16::from(info.block)) => {
                self.log(info, None);
            }
            OperatingMode::Stop => {}
            _ => self.interrupts.raise(info, &self.class, self.now_us),
        }
    }

    /// An interrupt or asynchronous error happens at a safe point (a backward jump or a block entry) of the next cycle, counted from 1.
    /// If the cycle has not so many, it never happens.
    pub fn raise_at_safe_point(&mut self, point: u64, interrupt: Interrupt) {
        self.interrupts.schedule(point, interrupt);
    }

    /// Sets a cyclic interrupt, from the next change to RUN on. OB 30 to OB 38 have one.
    pub fn set_cyclic_interrupt(&mut self, number: u16, setting: CyclicInterrupt) {
        self.settings.cyclic.insert(number, setting);
    }

    /// Sets what happens when the process image cannot be exchanged with a module.
    pub fn set_image_errors(&mut self, how: ImageErrors) {
        self.settings.image_errors = how;
    }

    /// Sets where time comes from, from the next scan on; where it came from before.
    pub fn set_time_source(&mut self, source: TimeSource) -> TimeSource {
        std::mem::replace(&mut self.settings.time, source)
    }

    /// From now on all runs of organization blocks in real time are measured, for [`Self::block_times`]; it costs a look at the clock for each.
    pub fn measure_blocks(&mut self) {
        self.interrupts.run_times.measure();
    }

    /// How long the runs of each organization block took, interruptions included; one that has not run is not there.
    pub fn block_times(&self) -> impl Iterator<Item = (BlockId, &Histogram)> {
        self.interrupts.run_times.measured().map(|(number, times)| (BlockId::ob(number), times))
    }

    /// Sets the least cycle time.
    pub fn set_min_cycle(&mut self, time: Duration) {
        self.settings.min_cycle = time;
    }

    /// Sets the time of day that it was when the clock of the CPU began.
    pub fn set_start_of_clock(&mut self, start: DateAndTime) {
        self.settings.date_and_time = start;
        self.load_times.program = start;
    }

    /// When the next timed interrupt comes, in microseconds like the time of a scan; `None` if there is none, or the CPU is not in RUN.
    pub fn next_interrupt_us(&self) -> Option<u64> {
        if self.mode == OperatingMode::Run && !self.interrupts.is_quiet() { self.interrupts.next_us(&self.now()) } else { None }
    }

    /// Runs the interrupts that have come since the last scan, without a scan: for the time in which the CPU waits for the next one.
    pub fn serve_with(&mut self, clock: &mut dyn FnMut() -> u64, tracer: Option<&mut dyn Tracer>) {
        self.end_pause(clock);
        let until_us = clock();
        match self.serve_until(until_us, clock, tracer) {
            ControlFlow::Break(paused) => drop(self.pause(paused, Then::Served { until_us })),
            ControlFlow::Continue(()) => self.advance(until_us),
        }
    }

    pub(super) fn now(&self) -> Now {
        Now { now_us: self.now_us, clock_us: self.machine.clock_us, start: self.settings.date_and_time }
    }

    #[inline]
    pub(super) fn new_watchdog(&self) -> Watchdog {
        Watchdog::new(false, self.now_us, self.watchdog_us(), self.settings.virtual_safe_points)
    }

    /// Runs the interrupts that fall into the time up to `until_us`, each at its own time; in real time, which has passed already, now.
    pub(super) fn serve_until(
        &mut self,
        until_us: u64,
        clock: &mut dyn FnMut() -> u64,
        mut tracer: Option<&mut dyn Tracer>,
    ) -> ControlFlow<Paused> {
        while self.mode == OperatingMode::Run && !self.requests.stop.load(Ordering::Relaxed) {
            // Waiting is not part of the cycle time.
            self.watchdog = self.new_watchdog();
            self.serve_waiting(clock, &mut tracer)?;
            if self.pass_one(until_us, clock, &mut tracer)?.is_none() {
                break;
            }
        }
        ControlFlow::Continue(())
    }

    /// What is left of the time up to `until_us` when nothing waits any more.
    pub(super) fn pass(
        &mut self,
        until_us: u64,
        clock: &mut dyn FnMut() -> u64,
        tracer: &mut Option<&mut dyn Tracer>,
    ) -> ControlFlow<Paused> {
        match self.pass_one(until_us, clock, tracer)? {
            Some(_) => self.serve_until(until_us, clock, again(tracer)),
            None => ControlFlow::Continue(()),
        }
    }

    /// What is left of the time up to `until_us` when OB 90 has run before the timed event `next`.
    pub(super) fn pass_from(
        &mut self,
        next: Option<u64>,
        until_us: u64,
        clock: &mut dyn FnMut() -> u64,
        tracer: &mut Option<&mut dyn Tracer>,
    ) -> ControlFlow<Paused> {
        match self.advance_to(next, until_us) {
            Some(_) => self.serve_until(until_us, clock, again(tracer)),
            None => ControlFlow::Continue(()),
        }
    }

    /// Time passes up to the next timed event before `until_us`, if there is one.
    fn pass_one(
        &mut self,
        until_us: u64,
        clock: &mut dyn FnMut() -> u64,
        tracer: &mut Option<&mut dyn Tracer>,
    ) -> ControlFlow<Paused, Option<u64>> {
        let next = self.next_interrupt_us().filter(|&due| due <= until_us);
        if self.settings.time == TimeSource::Virtual
            && let ControlFlow::Break((rest, class)) = self.background(next.unwrap_or(until_us), clock, tracer)
        {
            return ControlFlow::Break((rest, Inner::Background { class, next }));
        }
        ControlFlow::Continue(self.advance_to(next, until_us))
    }

    fn advance_to(&mut self, next: Option<u64>, until_us: u64) -> Option<u64> {
        match (next, self.settings.time) {
            (Some(due), TimeSource::Virtual) => self.advance(due),
            (Some(_), TimeSource::Real) => self.advance(until_us),
            (None, _) => {}
        }
        next
    }

    /// Whether nothing waits, and nothing comes by itself.
    #[inline]
    fn is_quiet(&self) -> bool {
        self.interrupts.is_quiet() && self.rack.is_quiet()
    }

    /// Whether nothing happens between two cycles but that time passes.
    #[inline]
    pub(super) fn only_waits(&self) -> bool {
        self.is_quiet() && !self.has_background()
    }

    /// Runs everything that waits now, highest priority class first, while no block runs.
    #[inline]
    pub(super) fn serve_waiting(&mut self, clock: &mut dyn FnMut() -> u64, tracer: &mut Option<&mut dyn Tracer>) -> ControlFlow<Paused> {
        if self.is_quiet() { ControlFlow::Continue(()) } else { self.serve_what_waits(clock, tracer) }
    }

    fn serve_what_waits(&mut self, clock: &mut dyn FnMut() -> u64, tracer: &mut Option<&mut dyn Tracer>) -> ControlFlow<Paused> {
        while self.mode == OperatingMode::Run && !self.is_quiet() {
            let now = self.now();
            self.interrupts.gather(&now, &self.machine, &self.class);
            for alarm in self.rack.take_alarms() {
                self.interrupts.raise(alarm.start_information(), &self.class, self.now_us);
            }
            for info in self.interrupts.take_entries() {
                self.log(info, None);
            }
            if let Some((event, info)) = self.interrupts.take_stop() {
                let first = DiagnosticEntry { fields: info, time: self.date_and_time(), place: None };
                self.enter_stop(sieben_engine::StopReason { event, place: None }, Some(first));
                break;
            }
            let Some(Request { info, raised_us }) = self.interrupts.take(0) else { break };
            let class = std::mem::replace(&mut self.class, info);
            self.requested_us = Some(raised_us);
            let entry = self.entry(BlockId::ob(u16::from(info.block)), None);
            match self.run(Go::Enter(entry), clock, again(tracer)) {
                Outcome::Paused(rest) => return ControlFlow::Break((rest, Inner::Interrupt(class))),
                outcome => self.after_interrupt(outcome),
            }
            // In HOLD the interrupt goes on to run, in its own class.
            if self.mode == OperatingMode::Run {
                self.class = class;
            }
        }
        ControlFlow::Continue(())
    }

    pub(super) fn after_interrupt(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Finished | Outcome::Paused(_) => {}
            Outcome::Suspended => self.hold(Held::Interrupt),
            Outcome::Stopped(reason, first) => self.enter_stop(reason, first),
        }
    }
}

/// The same tracer for one more run.
pub(super) fn again<'a>(tracer: &'a mut Option<&mut dyn Tracer>) -> Option<&'a mut dyn Tracer> {
    match tracer {
        Some(tracer) => Some(&mut **tracer),
        None => None,
    }
}
