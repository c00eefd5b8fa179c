//! Runs unit tests: one on a fresh CPU, in virtual time, word by word.

mod words;
mod writers;

use sieben_cpu::{Asked, Cpu, OperatingMode, Restart, StopCause, TestStep};
use sieben_engine::{FaultPlace, Tracer};
use sieben_model::source::{Sources, Span};
use sieben_model::testing::{Signal, Test, TestPlan};

pub use writers::{Writers, Written};

/// What a test may take.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Time from one scan to the next, in microseconds.
    pub cycle_us: u64,
    /// Virtual time in which a test has to end, in microseconds.
    pub time_us: u64,
    /// Scans in which it has to end.
    pub scans: u64,
}

/// What came of a test.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// What is wrong; `None` = it has passed.
    pub wrong: Option<Wrong>,
    /// Scans that were run.
    pub scans: u64,
    /// Virtual time that passed, in microseconds.
    pub time_us: u64,
    /// Words that asked the CPU for something.
    pub asked: u64,
}

/// What is wrong with a test.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wrong {
    /// In one sentence.
    pub message: String,
    /// What its author says about it.
    pub said: Option<String>,
    /// The word of the test.
    pub span: Option<Span>,
    /// The statement of the program that stopped the CPU.
    pub place: Option<FaultPlace>,
    /// The values of an assertion.
    pub values: Vec<ShownValue>,
    /// The variables that it reads.
    pub signals: Vec<Signal>,
    /// It took longer than it may, or was given up.
    pub endless: bool,
}

/// A value of an assertion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShownValue {
    /// The expression as it is written.
    pub expression: String,
    /// What it is.
    pub value: String,
    /// The word of its type; empty for a number without one.
    pub data_type: String,
}

/// Who watches a test.
pub trait Watcher {
    /// Whether it may go on; asked at every word and every scan.
    fn may_go_on(&mut self) -> bool {
        true
    }
    /// The CPU is about to be started.
    fn before_restart(&mut self) {}
    /// The CPU was started.
    fn restarted(&mut self, cpu: &Cpu) {
        let _ = cpu;
    }
    /// A scan is about to begin: time passes, and inputs are read.
    fn before_scan(&mut self, cpu: &Cpu) {
        let _ = cpu;
    }
    /// A scan has ended.
    fn scanned(&mut self, cpu: &Cpu) {
        let _ = cpu;
    }
    /// Who is told of every statement.
    fn tracer(&mut self) -> Option<&mut dyn Tracer> {
        None
    }
}

/// Runs one test and what comes behind it on a CPU that was just loaded.
pub fn run(test: &Test, plan: &TestPlan, sources: &Sources, cpu: &mut Cpu, limits: Limits, watcher: &mut dyn Watcher) -> Report {
    let mut run =
        Run { plan, sources, cpu, limits, watcher, report: Report::default(), stopped: None, expected_stop: false, own_stop: None };
    run.restart();
    let mut wrong = run.block(test.block).err();
    // A test that was given up has no time left for its end.
    if let Some(teardown) = plan.teardown
        && !wrong.as_ref().is_some_and(|wrong| wrong.endless)
    {
        let behind = run.block(teardown).err();
        wrong = wrong.or(behind);
    }
    if wrong.is_none() {
        wrong = run.unexpected_stop(None).err();
    }
    Report { wrong: wrong.map(|wrong| *wrong), time_us: run.cpu.now_us(), ..run.report }
}

/// A test that runs.
struct Run<'a> {
    plan: &'a TestPlan,
    sources: &'a Sources,
    cpu: &'a mut Cpu,
    limits: Limits,
    watcher: &'a mut dyn Watcher,
    report: Report,
    /// The STOP that nobody has expected yet.
    stopped: Option<StopCause>,
    /// The CPU is in STOP, and the test knows.
    expected_stop: bool,
    /// What `STOP` of the test has led to: no surprise, and yet `EXPECT_STOP` may ask for it.
    own_stop: Option<StopCause>,
}

impl Run<'_> {
    /// Runs a block of the test file to its end.
    fn block(&mut self, block: sieben_model::block::BlockId) -> Result<(), Box<Wrong>> {
        let mut step = self.cpu.begin_test(block, self.watcher.tracer());
        loop {
            match step {
                TestStep::Finished => return Ok(()),
                TestStep::Running => self.check_limits(None)?,
                TestStep::Asked(asked) => self.asked(&asked)?,
                TestStep::Stopped => return Err(self.stopped_inside()),
            }
            step = self.cpu.go_on_with_test(self.watcher.tracer());
        }
    }

    fn asked(&mut self, asked: &Asked) -> Result<(), Box<Wrong>> {
        self.report.asked += 1;
        let plan = self.plan;
        let Some(call) = plan.words.get(&asked.row) else {
            return Err(Box::new(Wrong { message: "a word of the test is not in its plan".to_owned(), ..Wrong::default() }));
        };
        self.check_limits(Some(call.span))?;
        self.word(call, asked).map_err(|mut wrong| {
            wrong.span = wrong.span.or(Some(call.span));
            wrong.said = wrong.said.take().or_else(|| call.message.clone());
            wrong
        })
    }

    /// A statement of the test, or of a block that it calls, has stopped the CPU.
    fn stopped_inside(&mut self) -> Box<Wrong> {
        let cause = self.cpu.stop_cause().cloned();
        self.expected_stop = true;
        Box::new(Wrong {
            message: format!("the CPU went to STOP: {}", cause.as_ref().map_or("nobody knows why", |cause| cause.text.as_str())),
            place: cause.and_then(|cause| cause.place),
            ..Wrong::default()
        })
    }

    /// Starts the CPU by a warm restart.
    fn restart(&mut self) {
        let now = self.cpu.now_us();
        self.watcher.before_restart();
        self.cpu.restart_with(Restart::Warm, &mut || now, self.watcher.tracer());
        self.watcher.restarted(self.cpu);
        self.expected_stop = false;
        self.own_stop = None;
        self.note_stop();
    }

    /// Notes a STOP that nobody has noted.
    fn note_stop(&mut self) {
        if self.cpu.mode() == OperatingMode::Stop && !self.expected_stop && self.stopped.is_none() {
            self.stopped = self.cpu.stop_cause().cloned();
        }
    }

    /// A STOP that the test has not expected.
    fn unexpected_stop(&mut self, before: Option<&str>) -> Result<(), Box<Wrong>> {
        let Some(cause) = self.stopped.take() else { return Ok(()) };
        self.expected_stop = true;
        let before = before.map_or(String::new(), |word| format!(" before this `{word}`"));
        Err(Box::new(Wrong { message: format!("the CPU went to STOP{before}: {}", cause.text), place: cause.place, ..Wrong::default() }))
    }

    /// One cycle: the first one begins at once, each other one a cycle after the one before, and after time that the test let pass.
    fn scan(&mut self) {
        let wait_us = if self.report.scans == 0 { 0 } else { self.limits.cycle_us };
        let now = self.cpu.now_us().saturating_add(wait_us);
        self.watcher.before_scan(self.cpu);
        match self.watcher.tracer() {
            Some(tracer) => self.cpu.scan_traced(now, tracer),
            None => self.cpu.scan(now),
        };
        self.report.scans += 1;
        self.watcher.scanned(self.cpu);
        self.note_stop();
    }

    /// Whether the test has time left.
    fn check_limits(&mut self, span: Option<Span>) -> Result<(), Box<Wrong>> {
        let message = match () {
            () if self.report.scans > self.limits.scans => format!("the test did not end within {} scans", self.limits.scans),
            () if self.cpu.now_us() > self.limits.time_us => {
                format!("the test did not end within {} s of the CPU's time", self.limits.time_us / 1_000_000)
            }
            () if !self.watcher.may_go_on() => "the test took too long and was given up".to_owned(),
            () => return Ok(()),
        };
        Err(Box::new(Wrong { message, span, endless: true, ..Wrong::default() }))
    }
}
