//! A heated thing: a first-order lag behind a dead time, with a safety thermostat.

use std::collections::VecDeque;

use super::random::Random;
use super::{ANALOG_MAX, Kind, Process, STEP_US, actuator, commanded, is_set, measured, opening, parameter, put_bits, put_word, sensor};

/// The row of the thermal process in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "thermal",
    about: "Something that is heated and cools down: a first-order lag behind a dead time, with a safety thermostat.",
    behaviour: "`time_constant` · dT/dt = `ambient` + `gain` · u(t − `dead_time`) − T, with the power u from 0 to 1: 1 while `heater` is 1, else `power` / 27648. \
                While `fan` is 1 the heat is lost three times as fast. The sensor counts 0.1 °C and is off by at most `noise`. \
                The safety thermostat opens at `limit` and closes 10 K below.",
    input_bytes: 4,
    output_bytes: 4,
    signals: &[
        measured("temperature", 0, "°C", 10.0, "temperature in 0.1 °C: 235 is 23.5 °C"),
        sensor("thermostat", 2, 0, "safety thermostat, normally closed: 0 above the limit"),
        commanded("power", 0, "%", ANALOG_MAX / 100.0, "heating power, 0 to 27648 for 0 to 100 %"),
        actuator("heater", 2, 0, "1 heats with full power"),
        actuator("fan", 2, 1, "1 cools"),
    ],
    parameters: &[
        parameter("ambient", 20.0, (-40.0, 80.0), "°C", "temperature around, and at the beginning"),
        parameter("gain", 180.0, (1.0, 1000.0), "K", "how much warmer it is at full power in the end"),
        parameter("time_constant", 60.0, (0.1, 3600.0), "s", "after it 63 % of a change are there"),
        parameter("dead_time", 3.0, (0.0, 60.0), "s", "before it nothing of a change is seen"),
        parameter("noise", 0.1, (0.0, 10.0), "K", "how far the reading is off at most"),
        parameter("limit", 150.0, (0.0, 1500.0), "°C", "where the safety thermostat opens"),
    ],
    arrange: None,
    shown: &[],
    make: |values, seed| {
        Box::new(Thermal {
            ambient: values[0],
            gain: values[1],
            time_constant: values[2],
            waiting: VecDeque::from(vec![0.0; (values[3] * 1e6 / SAMPLE_US) as usize]),
            noise: values[4],
            limit: values[5],
            temperature: values[0],
            trend: 0.0,
            reading: values[0],
            power: 0.0,
            sum: 0.0,
            until_sample: SAMPLE_STEPS,
            open: false,
            random: Random::new(seed),
        })
    },
};

const DT: f64 = STEP_US as f64 / 1e6;
/// The dead time is kept in samples of 10 ms: 6,000 for the longest.
const SAMPLE_US: f64 = 10_000.0;
const SAMPLE_STEPS: u64 = 10_000 / STEP_US;

#[derive(Clone)]
struct Thermal {
    ambient: f64,
    gain: f64,
    time_constant: f64,
    /// Power that has not arrived yet, oldest first.
    waiting: VecDeque<f64>,
    noise: f64,
    limit: f64,
    temperature: f64,
    /// Kelvin per second.
    trend: f64,
    reading: f64,
    /// Power that has arrived.
    power: f64,
    /// Power of the sample that is being taken.
    sum: f64,
    until_sample: u64,
    /// The thermostat has opened.
    open: bool,
    random: Random,
}

impl Process for Thermal {
    fn step(&mut self, commands: &[u8], _hands: &[u8]) {
        self.sum += if is_set(commands, 2, 0) { 1.0 } else { opening(commands, 0) };
        self.until_sample -= 1;
        if self.until_sample == 0 {
            self.until_sample = SAMPLE_STEPS;
            self.waiting.push_back(self.sum / SAMPLE_STEPS as f64);
            self.sum = 0.0;
            self.power = self.waiting.pop_front().unwrap_or(0.0);
            self.reading = self.temperature + self.noise * self.random.around_zero();
        }
        let loss = if is_set(commands, 2, 1) { 3.0 } else { 1.0 };
        self.trend = (self.gain * self.power - loss * (self.temperature - self.ambient)) / self.time_constant;
        self.temperature += self.trend * DT;
        self.open = self.temperature > if self.open { self.limit - 10.0 } else { self.limit };
    }
    fn sense(&self, into: &mut [u8]) {
        put_word(into, 0, self.reading * 10.0);
        put_bits(&mut into[2], &[(0, !self.open)]);
    }
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        vec![("temperature", self.temperature, "°C"), ("trend", self.trend, "K/s"), ("power", self.power * 100.0, "%")]
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
}
