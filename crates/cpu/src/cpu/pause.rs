//! A watched run that was paused between two statements, and how it goes on as if nothing had happened.

use std::ops::ControlFlow;

use sieben_engine::Tracer;

use super::Cpu;
use super::interrupting::again;
use super::run::{Go, Outcome, Rest};
use super::scan::ScanReport;
use super::stop::Held;
use crate::mode::OperatingMode;
use crate::start_information::StartInformation;

/// A paused run: what it was, and what comes behind it.
#[derive(Clone, Debug)]
pub(super) struct Pause {
    rest: Rest,
    inner: Inner,
    then: Then,
}

/// What was running between two cycles or in place of one.
#[derive(Clone, Debug)]
pub(super) enum Inner {
    /// The organization block that `Then` is about.
    Block,
    /// An interrupt outside the cycle; this class was the last one before it.
    Interrupt(StartInformation),
    /// OB 90 until this timed event, or the end of the time that passes.
    Background { class: StartInformation, next: Option<u64> },
}

/// What comes behind it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Then {
    /// STARTUP is over.
    Startup,
    /// STARTUP on behalf of the program is over, and with it the cycle.
    Reboot,
    /// The time until then passes, and a cycle begins.
    Cycle { until_us: u64 },
    /// OB 1.
    Program,
    /// OB 1 is over.
    AfterProgram,
    /// So are the interrupts behind it.
    EndOfCycle,
    /// The time until then passes.
    Served { until_us: u64 },
    /// What HOLD had suspended is over.
    Held(Held),
}

/// A pause on its way to those who know what comes behind it.
pub(super) type Paused = (Rest, Inner);

impl Cpu {
    /// Whether a tracer has paused the CPU between two statements; [`Self::go_on`] goes on.
    /// Whatever else is asked of it first, but reading and modifying, lets the rest of the scan run without a tracer.
    pub fn is_paused(&self) -> bool {
        self.pause.is_some()
    }

    /// Goes on after a tracer has paused the CPU ([`Tracer::pauses_before`]), in virtual time: the rest of the scan or startup.
    /// It is the same run as without the pause. If nothing was paused, nothing happens.
    pub fn go_on(&mut self, tracer: Option<&mut dyn Tracer>) -> ScanReport {
        let now = match &self.pause {
            Some(Pause { then: Then::Cycle { until_us } | Then::Served { until_us }, .. }) => *until_us,
            _ => self.now_us,
        };
        self.go_on_with(&mut || now, tracer)
    }

    /// As [`Self::go_on`], with a clock (microseconds).
    pub fn go_on_with(&mut self, clock: &mut dyn FnMut() -> u64, mut tracer: Option<&mut dyn Tracer>) -> ScanReport {
        let Some(Pause { rest, inner, then }) = self.pause.take() else { return self.report(false, 0) };
        let outcome = match self.run(Go::On(rest), clock, again(&mut tracer)) {
            Outcome::Paused(rest) => return self.pause((rest, inner), then),
            outcome => outcome,
        };
        match inner {
            Inner::Block => self.after_block(outcome, then, clock, tracer),
            Inner::Interrupt(class) => {
                self.after_interrupt(outcome);
                if self.mode == OperatingMode::Run {
                    self.class = class;
                }
                if let ControlFlow::Break(paused) = self.serve_waiting(clock, &mut tracer) {
                    return self.pause(paused, then);
                }
                let passed = match then {
                    Then::Cycle { until_us } | Then::Served { until_us } => self.pass(until_us, clock, &mut tracer),
                    _ => ControlFlow::Continue(()),
                };
                self.after_time(passed, then, clock, tracer)
            }
            Inner::Background { class, next } => {
                self.after_background(outcome);
                if self.mode == OperatingMode::Run {
                    self.class = class;
                }
                let passed = match then {
                    Then::Cycle { until_us } | Then::Served { until_us } => self.pass_from(next, until_us, clock, &mut tracer),
                    _ => ControlFlow::Continue(()),
                };
                self.after_time(passed, then, clock, tracer)
            }
        }
    }

    /// Notes the pause.
    pub(super) fn pause(&mut self, (rest, inner): Paused, then: Then) -> ScanReport {
        self.pause = Some(Pause { rest, inner, then });
        self.registers = self.machine.registers.clone();
        ScanReport { number: self.cycle.number, executed: true, mode: self.mode, execution_us: 0, safe_points: 0, events_missed: 0 }
    }

    /// The rest of the scan of a pause runs, unwatched.
    pub(super) fn end_pause(&mut self, clock: &mut dyn FnMut() -> u64) {
        if self.pause.is_some() {
            self.go_on_with(clock, None);
        }
    }

    fn after_time(
        &mut self,
        passed: ControlFlow<Paused>,
        then: Then,
        clock: &mut dyn FnMut() -> u64,
        tracer: Option<&mut dyn Tracer>,
    ) -> ScanReport {
        if let ControlFlow::Break(paused) = passed {
            return self.pause(paused, then);
        }
        match then {
            Then::Cycle { until_us } => self.cycle_from(until_us, clock, tracer),
            Then::Served { until_us } => {
                self.advance(until_us);
                self.report(false, 0)
            }
            Then::Program => self.run_program(clock, tracer),
            Then::EndOfCycle => self.end_cycle(clock),
            Then::Startup | Then::Reboot | Then::AfterProgram | Then::Held(_) => self.report(true, 0),
        }
    }

    fn after_block(&mut self, outcome: Outcome, then: Then, clock: &mut dyn FnMut() -> u64, tracer: Option<&mut dyn Tracer>) -> ScanReport {
        match then {
            Then::Startup => {
                self.after_startup(outcome);
                self.report(true, 0)
            }
            Then::Reboot => {
                self.after_startup(outcome);
                self.end_cycle(clock)
            }
            Then::Held(held) => self.after_held(held, outcome, clock, tracer),
            Then::Cycle { .. } | Then::Program | Then::AfterProgram | Then::EndOfCycle | Then::Served { .. } => {
                self.after_cycle(outcome, clock, tracer)
            }
        }
    }
}
