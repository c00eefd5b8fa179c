//! A tank whose level is measured: an inlet that can be switched or throttled, an outlet, three float switches.

use super::random::Random;
use super::{ANALOG_MAX, Kind, Process, STEP_US, actuator, commanded, is_set, measured, opening, parameter, put_bits, put_word, sensor};

/// The row of the tank in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "tank",
    about: "A tank with a measured level, an inlet valve, an outlet valve and three float switches.",
    behaviour: "dV/dt = `inflow` · x − `outflow` · y · √(V / `volume`), by Torricelli. x is 1 while `inlet` is 1, else the opening of `inlet_valve`; y likewise for `outlet`. \
                The valves for `inlet` and `outlet` take 1 s from shut to open. The level reads 0 to 27648 for 0 to 100 %, with waves of at most `waves` per cent. \
                What does not fit in is spilled.",
    input_bytes: 4,
    output_bytes: 4,
    signals: &[
        sensor("low", 0, 0, "float switch at 10 %, 1 while it is under water"),
        sensor("high", 0, 1, "float switch at 90 %, 1 while it is under water"),
        sensor("overflow", 0, 2, "safety float switch at 98 %, normally closed: 0 while it is under water"),
        sensor("inlet_open", 0, 3, "limit switch of the inlet valve, 1 = open"),
        sensor("outlet_open", 0, 4, "limit switch of the outlet valve, 1 = open"),
        measured("level", 2, "%", ANALOG_MAX / 100.0, "level, 0 to 27648 for 0 to 100 %"),
        actuator("inlet", 0, 0, "1 opens the inlet valve"),
        actuator("outlet", 0, 1, "1 opens the outlet valve"),
        commanded("inlet_valve", 2, "%", ANALOG_MAX / 100.0, "opening of the control valve at the inlet, 0 to 27648"),
    ],
    parameters: &[
        parameter("volume", 500.0, (1.0, 100_000.0), "l", "what the tank holds"),
        parameter("inflow", 10.0, (0.0, 1000.0), "l/s", "flow through the open inlet"),
        parameter("outflow", 8.0, (0.0, 1000.0), "l/s", "flow through the open outlet of a full tank"),
        parameter("level", 20.0, (0.0, 100.0), "%", "level at the beginning"),
        parameter("waves", 0.2, (0.0, 10.0), "%", "how far the reading is off at most"),
    ],
    arrange: None,
    shown: &[],
    make: |values, seed| {
        Box::new(Tank {
            volume: values[0],
            inflow: values[1],
            outflow: values[2],
            content: values[0] * values[3] / 100.0,
            waves: values[4],
            wave: 0.0,
            inlet: 0.0,
            outlet: 0.0,
            spilled: 0.0,
            until_wave: WAVE_STEPS,
            random: Random::new(seed),
        })
    },
};

const DT: f64 = STEP_US as f64 / 1e6;
/// A valve moves from shut to open in one second.
const TRAVEL: f64 = DT;
/// The waves change every 100 ms.
const WAVE_STEPS: u64 = 100_000 / STEP_US;

#[derive(Clone)]
struct Tank {
    /// Litres.
    volume: f64,
    /// Litres per second.
    inflow: f64,
    outflow: f64,
    content: f64,
    /// Per cent of the level.
    waves: f64,
    wave: f64,
    /// Openings, 0 to 1.
    inlet: f64,
    outlet: f64,
    spilled: f64,
    until_wave: u64,
    random: Random,
}

impl Tank {
    fn level(&self) -> f64 {
        self.content / self.volume * 100.0
    }
}

/// A valve goes on towards open or shut.
fn travel(opening: f64, open: bool) -> f64 {
    if open { (opening + TRAVEL).min(1.0) } else { (opening - TRAVEL).max(0.0) }
}

impl Process for Tank {
    fn step(&mut self, commands: &[u8], _hands: &[u8]) {
        self.inlet = travel(self.inlet, is_set(commands, 0, 0));
        self.outlet = travel(self.outlet, is_set(commands, 0, 1));
        let inflow = self.inflow * self.inlet.max(opening(commands, 2));
        let outflow = self.outflow * self.outlet * (self.content / self.volume).sqrt();
        let content = self.content + (inflow - outflow) * DT;
        self.spilled += (content - self.volume).max(0.0);
        self.content = content.clamp(0.0, self.volume);
        self.until_wave -= 1;
        if self.until_wave == 0 {
            self.until_wave = WAVE_STEPS;
            self.wave = self.waves * self.random.around_zero();
        }
    }
    fn sense(&self, into: &mut [u8]) {
        let level = self.level();
        let bits =
            [(0, level >= 10.0), (1, level >= 90.0), (2, level < 98.0), (3, self.inlet >= 1.0 - 1e-9), (4, self.outlet >= 1.0 - 1e-9)];
        put_bits(&mut into[0], &bits);
        put_word(into, 2, (level + self.wave).clamp(0.0, 100.0) * ANALOG_MAX / 100.0);
    }
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        vec![
            ("level", self.level(), "%"),
            ("content", self.content, "l"),
            ("spilled", self.spilled, "l"),
            ("inlet", self.inlet * 100.0, "%"),
            ("outlet", self.outlet * 100.0, "%"),
        ]
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
}
