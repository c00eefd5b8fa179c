//! What SFB 3, 4 and 5 have in common: the instance and the time that has run.

use sieben_model::types::DataType;

use super::instance::Instance;
use super::{Call, Parameter, input, output, stored};

/// The variables of all three.
pub(super) const VARIABLES: &[Parameter] = &[
    input("IN", DataType::Bool),
    input("PT", DataType::Time),
    output("Q", DataType::Bool),
    output("ET", DataType::Time),
    stored("STATE", DataType::Byte),
    stored("STIME", DataType::Time),
    stored("ATIME", DataType::Time),
];

const PT: usize = 2;
const Q: usize = 6;
const ET: usize = 8;
const STATE: usize = 12;
const STIME: usize = 14;
const ATIME: usize = 18;
const BYTES: u32 = 22;

/// Bits of STATE: IN of the last call, the time runs, the time has elapsed.
const IN_BEFORE: u8 = 0;
const RUNNING: u8 = 1;
const ELAPSED: u8 = 2;

/// A timer in one call.
pub(super) struct IecTimer<'a> {
    instance: Instance<'a>,
    now: i32,
    preset: i32,
    pub(super) input: bool,
    /// IN of the last call.
    pub(super) before: bool,
    pub(super) running: bool,
    pub(super) elapsed: bool,
    /// Output Q.
    pub(super) q: bool,
    /// Output ET.
    pub(super) et: i32,
}

/// Runs one call of a timer; the answer is BR. PT = 0 resets the timer, a negative PT too, with BR = 0.
pub(super) fn call(call: &mut Call<'_, '_>, step: fn(&mut IecTimer<'_>)) -> bool {
    let Some(instance) = Instance::open(call.machine, BYTES) else { return false };
    let mut timer = IecTimer {
        now: instance.now(),
        preset: instance.time(PT),
        input: instance.bit(0, 0),
        before: instance.bit(STATE, IN_BEFORE),
        running: instance.bit(STATE, RUNNING),
        elapsed: instance.bit(STATE, ELAPSED),
        q: instance.bit(Q, 0),
        et: instance.time(ET),
        instance,
    };
    let reset = timer.preset <= 0;
    if reset {
        (timer.input, timer.running, timer.elapsed, timer.q, timer.et) = (false, false, false, false, 0);
    } else {
        step(&mut timer);
    }
    let IecTimer { instance, now, preset, input, running, elapsed, q, et, .. } = &mut timer;
    instance.set_bit(STATE, IN_BEFORE, *input);
    instance.set_bit(STATE, RUNNING, *running);
    instance.set_bit(STATE, ELAPSED, *elapsed);
    instance.set_bit(Q, 0, *q);
    instance.set_time(ET, *et);
    instance.set_time(ATIME, *now);
    *preset >= 0
}

impl IecTimer<'_> {
    /// The time begins to run.
    pub(super) fn start(&mut self) {
        self.running = true;
        self.elapsed = false;
        self.et = 0;
        self.instance.set_time(STIME, self.now);
    }

    /// Brings ET of a running timer up to now; at PT it has elapsed.
    pub(super) fn update(&mut self) {
        if !self.running {
            return;
        }
        let run = self.now.wrapping_sub(self.instance.time(STIME)) & i32::MAX;
        self.elapsed = run >= self.preset;
        self.running = !self.elapsed;
        self.et = run.min(self.preset);
    }

    /// Stops without having elapsed.
    pub(super) fn stop(&mut self) {
        (self.running, self.elapsed, self.et) = (false, false, 0);
    }
}
