//! The CPU as a running program has it: its clocks, its watchdog, and what system functions reach of it.

use std::sync::atomic::{AtomicBool, Ordering};

use sieben_engine::machine::Frame;
use sieben_engine::{Engine, Machine, Program};
use sieben_model::cpu_type::CpuType;

use crate::clock::{DateAndTime, TimeSource};
use crate::communication::Communication;
use crate::diagnostic_buffer::{DiagnosticBuffer, DiagnosticEntry};
use crate::failed_statements::FailedStatements;
use crate::forcing::Forces;
use crate::interrupts::{Interrupts, Now};
use crate::io::Rack;
use crate::organization_blocks as ob;
use crate::process_image::Images;
use crate::start_information::StartInformation;
use crate::system_state::State;

/// Greatest budget handed out at once: bounds how long a STOP request or the watchdog can go unseen. As machine code that is some tens
/// of microseconds; in real time slower code gets less.
pub const BUDGET_MAX: i64 = 65_536;

/// What a cycle begins with in real time, where nothing is known yet of how long its safe points take.
const BUDGET_FIRST: i64 = 1024;

/// Least budget in real time: below it, asking would take longer than the program between two safe points.
const BUDGET_MIN: i64 = 32;

/// How long a budget may take in real time; after one that takes longer the next one is as much shorter, after one that takes a quarter
/// twice as long.
const BUDGET_US_MAX: u64 = 200;

/// Readings without progress after which a clock is taken to stand still.
const CLOCK_STANDS_STILL: u32 = 1_000_000;

/// Requests from other threads, seen at the next safe point.
#[derive(Debug, Default)]
pub(crate) struct Requests {
    pub(crate) stop: AtomicBool,
    pub(crate) hold: AtomicBool,
    /// Somebody wants to come in: the slice of OB 90 ends.
    pub(crate) visit: AtomicBool,
}

/// The CPU clock inside a scan.
pub(crate) struct Time<'a> {
    pub(crate) source: TimeSource,
    /// Asked in real time only; in virtual time the clock stands still inside a scan.
    pub(crate) clock: &'a mut dyn FnMut() -> u64,
    pub(crate) now_us: u64,
    /// Time of day at `now_us` = 0.
    pub(crate) start: DateAndTime,
}

impl Time<'_> {
    fn date_and_time(&self) -> DateAndTime {
        self.start.plus_us(self.now_us)
    }

    /// In real time, brings both clocks up to now.
    pub(crate) fn read(&mut self, machine: &mut Machine) {
        if self.source == TimeSource::Real {
            let now = (self.clock)().max(self.now_us);
            machine.clock_us = machine.clock_us.saturating_add(now - self.now_us);
            self.now_us = now;
        }
    }
}

/// Monitors how long an organization block runs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watchdog {
    /// STARTUP has no cycle time; in virtual time it is bounded all the same.
    pub(crate) startup: bool,
    pub(crate) started_us: u64,
    pub(crate) limit_us: u64,
    /// Safe points passed since the monitoring began, without those of the budget handed out last.
    passed: i64,
    granted: i64,
    /// In real time: the next budget, what was handed out last (0 if it was taken back), and when.
    pace: i64,
    handed: i64,
    handed_us: u64,
    pub(crate) limit_points: i64,
    /// OB 80 was called in this cycle.
    pub(crate) exceeded: bool,
    /// Safe points of the whole run.
    pub(crate) total: u64,
}

impl Watchdog {
    pub(crate) fn new(startup: bool, started_us: u64, limit_us: u64, limit_points: i64) -> Self {
        Self { startup, started_us, limit_us, limit_points, pace: BUDGET_FIRST, ..Self::default() }
    }

    /// Hands out the next budget. The safe point with the number `until` asks at the latest.
    fn grant(&mut self, time: &Time<'_>, machine: &mut Machine, until: Option<u64>) {
        let left = match time.source {
            TimeSource::Virtual => self.limit_points.saturating_sub(self.passed).max(0),
            TimeSource::Real => self.keep_pace(time.now_us),
        };
        let until = until.map_or(BUDGET_MAX, |point| i64::try_from(point.saturating_sub(self.total + 1)).unwrap_or(BUDGET_MAX));
        self.granted = left.min(BUDGET_MAX).min(until);
        machine.budget = self.granted;
        self.handed = self.granted;
    }

    /// The budget that takes about [`BUDGET_US_MAX`] as the last one went: the interpreter and long loops are asked more often.
    fn keep_pace(&mut self, now_us: u64) -> i64 {
        // What is left of a budget is below 0 where it was used up.
        if self.granted < 0 && self.handed == self.pace {
            let taken_us = now_us.saturating_sub(self.handed_us);
            if taken_us > BUDGET_US_MAX {
                // In proportion: a long budget that turns out to be slow is too long only once.
                let fits = i64::try_from(self.pace.unsigned_abs().saturating_mul(BUDGET_US_MAX) / taken_us).unwrap_or(BUDGET_MIN);
                self.pace = fits.max(BUDGET_MIN);
            } else if taken_us < BUDGET_US_MAX / 4 {
                self.pace = (self.pace * 2).min(BUDGET_MAX);
            }
        }
        self.handed_us = now_us;
        self.pace
    }

    /// Takes the budget back, so that the next safe point asks.
    pub(crate) fn ask_at_once(&mut self, machine: &mut Machine) {
        self.settle(machine);
        self.granted = 0;
        self.handed = 0;
        machine.budget = 0;
    }

    /// Takes back what is left of the budget.
    pub(crate) fn settle(&mut self, machine: &Machine) {
        // The safe point that asks finds the budget below 0; whoever settles again finds nothing new.
        let left = machine.budget.min(self.granted);
        let passed = self.granted - left;
        self.granted = left;
        self.passed = self.passed.saturating_add(passed);
        self.total = self.total.saturating_add(passed as u64);
    }

    /// The monitoring begins again: what comes next has the whole time.
    pub(crate) fn begin_again(&mut self, now_us: u64) {
        self.passed = 0;
        self.started_us = now_us;
    }

    /// What is monitored has taken too long.
    pub(crate) fn expired(&self, time: &Time<'_>) -> bool {
        match time.source {
            TimeSource::Virtual => self.passed > self.limit_points,
            TimeSource::Real => !self.startup && time.now_us.saturating_sub(self.started_us) > self.limit_us,
        }
    }
}

/// How long OB 90 runs in one pause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slice {
    /// So many safe points.
    Points(u64),
    /// Until this time, in microseconds.
    Until(u64),
}

/// The CPU behind a running program.
pub(crate) struct CpuHost<'a> {
    pub(crate) cpu_type: &'static CpuType,
    pub(crate) engine: &'a dyn Engine,
    pub(crate) rack: &'a mut Rack,
    pub(crate) diagnostics: &'a mut DiagnosticBuffer,
    pub(crate) failed_statements: &'a mut FailedStatements,
    /// How many scans have begun.
    pub(crate) scans: u64,
    pub(crate) requests: &'a Requests,
    pub(crate) time: Time<'a>,
    pub(crate) watchdog: &'a mut Watchdog,
    /// Start information of the organization block that the CPU started.
    pub(crate) class: StartInformation,
    /// The error that leads to STOP.
    pub(crate) first: Option<DiagnosticEntry>,
    /// Start information for OB 88: the priority class is aborted, the CPU stays in RUN.
    pub(crate) abort: Option<StartInformation>,
    /// What is loaded.
    pub(crate) program: &'a Program,
    /// What system functions remember.
    pub(crate) system: &'a mut State,
    /// What interrupts the program.
    pub(crate) interrupts: &'a mut Interrupts,
    /// The time of day was set.
    pub(crate) clock_set: bool,
    /// How long OB 90 may run now; `None` when that is over.
    pub(crate) slice: Option<Slice>,
    /// A test runs, outside of the cycle: nothing interrupts it.
    pub(crate) testing: bool,
    pub(crate) images: &'a mut Images,
    /// Bytes of the arena that the last system function has written.
    pub(crate) written: Vec<std::ops::Range<usize>>,
    /// What servers have told.
    pub(crate) communication: &'a Communication,
    pub(crate) forces: Forces,
}

impl CpuHost<'_> {
    /// Hands out the first budget of a run: none if HOLD was asked for, so that the first safe point sees it.
    pub(crate) fn begin(&mut self, machine: &mut Machine) {
        self.grant(machine);
        if self.requests.hold.load(Ordering::Relaxed) {
            self.watchdog.ask_at_once(machine);
        }
    }

    /// Hands out the next budget.
    pub(crate) fn grant(&mut self, machine: &mut Machine) {
        // Safe points with an event are those of the cycle; OB 1 runs on top of nothing.
        let until = match self.slice {
            Some(Slice::Points(points)) => Some(points),
            _ if self.in_cycle() => self.interrupts.next_point(),
            _ => None,
        };
        self.watchdog.grant(&self.time, machine, until);
    }

    /// Whether OB 1 runs, with what interrupts it.
    pub(crate) fn in_cycle(&self) -> bool {
        u16::from(self.class.block) == ob::CYCLE.number
    }

    /// Starts the cycle time monitoring again (SFC 43).
    pub(crate) fn restart_watchdog(&mut self, machine: &mut Machine) {
        self.time.read(machine);
        self.watchdog.settle(machine);
        self.watchdog.begin_again(self.time.now_us);
        self.grant(machine);
    }

    /// Brings the clocks up to now, in real time.
    pub(crate) fn read_time(&mut self, machine: &mut Machine) {
        self.time.read(machine);
    }

    /// The time of day as [`Self::read_time`] saw it.
    pub(crate) fn date_and_time(&self) -> DateAndTime {
        self.time.date_and_time()
    }

    /// Sets the time of day (SFC 0).
    pub(crate) fn set_date_and_time(&mut self, wanted: DateAndTime) {
        self.time.start = wanted.minus_us(self.time.now_us);
        self.clock_set = true;
    }

    /// Lets this many microseconds pass (SFC 47); in virtual time at once.
    pub(crate) fn wait(&mut self, machine: &mut Machine, us: u64) {
        self.time.read(machine);
        let until = self.time.now_us.saturating_add(us);
        if self.time.source == TimeSource::Virtual {
            machine.clock_us = machine.clock_us.saturating_add(until - self.time.now_us);
            self.time.now_us = until;
            return;
        }
        let mut asked = 0;
        while self.time.now_us < until && !self.requests.stop.load(Ordering::Relaxed) {
            let before = self.time.now_us;
            self.time.read(machine);
            asked = if self.time.now_us == before { asked + 1 } else { 0 };
            // A clock that stands still must not hold the CPU for ever.
            if asked > CLOCK_STANDS_STILL {
                break;
            }
        }
    }

    /// Start information of the priority class that is running: that of the innermost organization block that is no synchronous error.
    pub(crate) fn class(&self, machine: &Machine) -> StartInformation {
        let index = machine.frames.iter().rposition(Frame::begins_class);
        index.filter(|&index| index > 0).and_then(|index| self.system.started_at(index)).unwrap_or(self.class)
    }

    /// The point in time as the interrupts see it.
    pub(crate) fn now(&self, machine: &Machine) -> Now {
        Now { now_us: self.time.now_us, clock_us: machine.clock_us, start: self.time.start }
    }

    /// An event happens now.
    pub(crate) fn raise(&mut self, machine: &Machine, info: StartInformation) {
        let active = self.class(machine);
        self.interrupts.raise(info, &active, self.time.now_us);
    }
}
