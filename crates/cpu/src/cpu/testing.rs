//! Unit tests: a block of the test file runs outside of the cycle, and is put aside while it lets the CPU scan.

use sieben_engine::Tracer;
use sieben_model::address::Area;
use sieben_model::block::BlockId;

use super::Cpu;
use super::interrupting::again;
use super::run::{Go, Outcome};
use crate::host::Watchdog;
use crate::start_information::StartInformation;
use crate::system::testing::result_of;
use crate::system_state::{Asked, Mock};

/// Safe points that a test runs before whoever runs it is asked whether it may go on.
const SLICE_POINTS: i64 = 1_000_000;

/// Safe points that a block which only looks may pass: one that passes more does not end.
const LOOK_POINTS: i64 = 1_000_000;

/// How far a test came.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TestStep {
    /// It ended.
    Finished,
    /// It asks for something, and waits until [`Cpu::go_on_with_test`].
    Asked(Asked),
    /// It has run for long without asking anything.
    Running,
    /// A statement stopped the CPU: see [`Cpu::stop_cause`]. The test cannot go on.
    Stopped,
}

impl Cpu {
    /// Runs a block of a test from its beginning. The mode of the CPU does not matter.
    pub fn begin_test(&mut self, block: BlockId, tracer: Option<&mut dyn Tracer>) -> TestStep {
        if let Some(newer) = self.engine.newer() {
            self.engine = newer;
        }
        self.suspended_test = None;
        let class = self.class;
        self.class = StartInformation::cycle(self.restart, self.cycle.number, &self.cycle.times);
        let entry = self.entry(block, None);
        let step = self.run_test(Go::Enter(entry), tracer);
        self.class = class;
        step
    }

    /// Goes on with the test that was put aside; without one it has finished.
    pub fn go_on_with_test(&mut self, tracer: Option<&mut dyn Tracer>) -> TestStep {
        let Some(stack) = self.suspended_test.take() else { return TestStep::Finished };
        let class = self.class;
        self.put_stack(stack);
        let step = self.run_test(Go::Resume, tracer);
        self.class = class;
        step
    }

    /// Runs a block of a test that only looks, between two scans: no input becomes another one, and nothing is put aside. What it
    /// computes lies in its own data. `false` if a statement of it would stop the CPU, which goes on as if it had not been run.
    pub fn look_with(&mut self, block: BlockId) -> bool {
        self.class = StartInformation::cycle(self.restart, self.cycle.number, &self.cycle.times);
        let entry = self.entry(block, None);
        let now = self.now_us;
        self.watchdog = Watchdog::new(false, now, u64::MAX, LOOK_POINTS);
        self.testing = true;
        let requested = self.requested_us;
        let outcome = self.run(Go::Enter(entry), &mut || now, None);
        self.requested_us = requested;
        self.testing = false;
        let finished = matches!(outcome, Outcome::Finished);
        if !finished {
            self.machine.frames.clear();
            self.machine.parameters.clear();
            self.system.asked = None;
        }
        finished
    }

    fn run_test(&mut self, go: Go, mut tracer: Option<&mut dyn Tracer>) -> TestStep {
        let inputs = self.machine.memory.area(Area::Input).to_vec();
        let now = self.now_us;
        self.images.changed();
        self.watchdog = Watchdog::new(false, now, u64::MAX, SLICE_POINTS);
        self.testing = true;
        let outcome = self.run(go, &mut || now, again(&mut tracer));
        self.testing = false;
        self.hand_over_inputs(&inputs);
        match outcome {
            Outcome::Finished => TestStep::Finished,
            // Nobody pauses a test between two statements: it goes on as if it had asked nothing.
            Outcome::Suspended | Outcome::Paused(_) => {
                self.suspended_test = self.take_stack();
                self.system.asked.take().map_or(TestStep::Running, TestStep::Asked)
            }
            Outcome::Stopped(reason, first) => {
                self.enter_stop(reason, first);
                // A hot restart goes on with a cycle, not with a test.
                self.interrupted = None;
                TestStep::Stopped
            }
        }
    }

    /// Inputs that a test has written stay: the modules have them from now on.
    fn hand_over_inputs(&mut self, before: &[u8]) {
        let after = self.machine.memory.area(Area::Input);
        // Most words of a test come with no new input.
        if before == after {
            return;
        }
        let changed: Vec<(u32, u8, u8)> = (0..)
            .zip(before.iter().zip(after))
            .filter(|(_, (old, new))| old != new)
            .map(|(byte, (old, new))| (byte, old ^ new, *new))
            .collect();
        for (byte, mask, value) in changed {
            if !self.rack.set_input(byte, mask, value) {
                let (known, old) = self.overrides.entry(byte).or_default();
                *known |= mask;
                *old = *old & !mask | value & mask;
            }
        }
    }

    /// Lets time pass without a cycle, in microseconds.
    pub fn let_time_pass(&mut self, us: u64) {
        self.advance(self.now_us.saturating_add(us));
    }

    /// The time of the CPU in microseconds since it was loaded.
    pub fn now_us(&self) -> u64 {
        self.now_us
    }

    /// From now on calls of a block do nothing: those of an instance (data block and first byte), or of a function, which returns the
    /// value.
    pub fn mock(&mut self, block: BlockId, instance: Option<(u16, u32)>, value: u64) {
        let interface = match self.program.code.get(&block) {
            Some(code) => Some(code.interface.clone()),
            None => crate::system::interfaces().into_iter().find(|system| system.block == block).map(|system| system.interface),
        };
        let result = interface.as_ref().filter(|_| instance.is_none()).and_then(result_of);
        let mock = Mock { block, instance, result: result.map(|(index, width)| (index, width, value)), calls: 0 };
        match self.system.mocks.iter_mut().find(|known| known.block == block && known.instance == instance) {
            // The calls of one that is mocked again with another value count on.
            Some(known) => *known = Mock { calls: known.calls, ..mock },
            None => self.system.mocks.push(mock),
        }
    }

    /// How often a mocked block was called; `None` if it is not mocked.
    pub fn mock_calls(&self, block: BlockId, instance: Option<(u16, u32)>) -> Option<u64> {
        self.system.mocks.iter().find(|mock| mock.block == block && mock.instance == instance).map(|mock| mock.calls)
    }
}
