//! The dosing plant: a supply tank, a valve, a flow meter and a vessel, with a START and a STOP button.
//!
//! | bit of the first input byte | |
//! |---|---|
//! | 0 | START, 1 while pressed |
//! | 1 | STOP, normally closed: 0 while pressed |
//! | 7 | flow meter, one pulse per litre |
//!
//! Bit 0 of the first output byte is the valve; the word four bytes behind it is the BCD display.

use std::ops::Range;

use sieben_cpu::IoModule;
use sieben_model::bcd;

use super::random::Random;
use super::{Attention, Kind, Process, STEP_US, actuator, button, closed_button, commanded, is_set, parameter, put_bits, sensor};

/// Microlitres in a litre.
const LITRE: u64 = 1_000_000;
/// The flow changes a little every 100 ms.
const NOISE_STEP_US: u64 = 100_000;
/// Steps of noise in one go; time beyond them (more than an hour at once) passes at the nominal flow.
const NOISE_STEPS_MAX: u64 = 36_000;
/// Output bytes: the valve, a gap, and the display word.
const OUTPUT_BYTES: u32 = 6;
/// Where the display word lies in them.
const DISPLAY: usize = 4;

/// A button of the plant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Button {
    /// START, input bit 0.
    Start,
    /// STOP, input bit 1, normally closed.
    Stop,
}

/// How the plant is built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DosingSettings {
    /// What the user calls it.
    pub name: String,
    /// First input byte.
    pub input: u32,
    /// First output byte.
    pub output: u32,
    /// Nominal flow through the open valve in millilitres per second.
    pub flow_ml_per_s: u32,
    /// The flow changes by at most this many per mille.
    pub noise_per_mille: u32,
    /// What the supply tank holds, in litres; it is full at the beginning.
    pub supply_litres: u32,
    /// What the vessel holds, in litres; it is empty at the beginning.
    pub vessel_litres: u32,
    /// Where the noise begins; equal seeds give equal plants.
    pub seed: u64,
}

impl Default for DosingSettings {
    fn default() -> Self {
        Self {
            name: "tank".into(),
            input: 0,
            output: 0,
            flow_ml_per_s: 5000,
            noise_per_mille: 20,
            supply_litres: 1000,
            vessel_litres: 200,
            seed: 1,
        }
    }
}

/// The dosing plant as a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DosingPlant {
    settings: DosingSettings,
    start_pressed: bool,
    stop_pressed: bool,
    outputs: [u8; OUTPUT_BYTES as usize],
    /// All amounts in microlitres.
    delivered: u64,
    supply: u64,
    vessel: u64,
    spilled: u64,
    /// Flow in microlitres per second, with its noise.
    flow: u64,
    /// What the flow did not yet make a whole microlitre, in microlitres × 10⁻⁶.
    rest: u64,
    until_noise_us: u64,
    random: Random,
}

impl DosingPlant {
    /// A plant with a full supply tank and an empty vessel.
    pub fn new(settings: DosingSettings) -> Self {
        let supply = u64::from(settings.supply_litres) * LITRE;
        let flow = u64::from(settings.flow_ml_per_s) * 1000;
        let random = Random::new(settings.seed);
        Self {
            settings,
            start_pressed: false,
            stop_pressed: false,
            outputs: [0; OUTPUT_BYTES as usize],
            delivered: 0,
            supply,
            vessel: 0,
            spilled: 0,
            flow,
            rest: 0,
            until_noise_us: NOISE_STEP_US,
            random,
        }
    }

    /// Presses a button.
    pub fn press(&mut self, button: Button) {
        *self.button(button) = true;
    }
    /// Releases a button.
    pub fn release(&mut self, button: Button) {
        *self.button(button) = false;
    }
    /// Presses a released button and releases a pressed one.
    pub fn toggle(&mut self, button: Button) {
        let pressed = self.button(button);
        *pressed = !*pressed;
    }
    /// Whether a button is pressed.
    pub fn is_pressed(&self, button: Button) -> bool {
        match button {
            Button::Start => self.start_pressed,
            Button::Stop => self.stop_pressed,
        }
    }

    /// Whether the valve is open.
    pub fn valve_open(&self) -> bool {
        self.outputs[0] & 1 != 0
    }
    /// Whether liquid flows: the valve is open and the supply tank is not empty.
    pub fn flowing(&self) -> bool {
        self.valve_open() && self.supply > 0
    }
    /// The flow meter's signal: it rises with each full litre and falls half a litre later.
    pub fn pulse(&self) -> bool {
        self.delivered >= LITRE && self.delivered % LITRE < LITRE / 2
    }
    /// The flow in litres per second; 0 while nothing flows.
    pub fn flow(&self) -> f64 {
        if self.flowing() { litres(self.flow) } else { 0.0 }
    }
    /// The word on the BCD display.
    pub fn display(&self) -> u16 {
        u16::from_be_bytes([self.outputs[DISPLAY], self.outputs[DISPLAY + 1]])
    }
    /// The number on the BCD display; `None` if a digit is greater than 9.
    pub fn display_number(&self) -> Option<u16> {
        let word = u32::from(self.display());
        bcd::is_decimal(word, 4).then(|| bcd::decode(word, 4) as u16)
    }
    /// Litres that have passed the flow meter since the beginning.
    pub fn litres_delivered(&self) -> f64 {
        litres(self.delivered)
    }
    /// Litres in the supply tank.
    pub fn supply_litres(&self) -> f64 {
        litres(self.supply)
    }
    /// Litres in the vessel.
    pub fn vessel_litres(&self) -> f64 {
        litres(self.vessel)
    }
    /// Litres that found the vessel full.
    pub fn spilled_litres(&self) -> f64 {
        litres(self.spilled)
    }
    /// How the plant is built.
    pub fn settings(&self) -> &DosingSettings {
        &self.settings
    }

    /// Fills the supply tank.
    pub fn refill(&mut self) {
        self.supply = u64::from(self.settings.supply_litres) * LITRE;
    }
    /// Puts an empty vessel in place of the old one.
    pub fn exchange_vessel(&mut self) {
        self.vessel = 0;
    }

    fn button(&mut self, button: Button) -> &mut bool {
        match button {
            Button::Start => &mut self.start_pressed,
            Button::Stop => &mut self.stop_pressed,
        }
    }

    fn input_byte(&self) -> u8 {
        u8::from(self.start_pressed) | u8::from(!self.stop_pressed) << 1 | u8::from(self.pulse()) << 7
    }

    /// Liquid flows for a time at one flow.
    fn pass(&mut self, dt_us: u64) {
        if !self.flowing() {
            return;
        }
        let amount = u128::from(self.flow) * u128::from(dt_us) + u128::from(self.rest);
        self.rest = (amount % 1_000_000) as u64;
        let amount = u64::try_from(amount / 1_000_000).unwrap_or(u64::MAX).min(self.supply);
        self.supply -= amount;
        self.delivered = self.delivered.saturating_add(amount);
        let room = (u64::from(self.settings.vessel_litres) * LITRE).saturating_sub(self.vessel);
        self.vessel += amount.min(room);
        self.spilled = self.spilled.saturating_add(amount.saturating_sub(room));
    }

    /// The next flow: nominal, more or less a little.
    fn change_flow(&mut self) {
        let mixed = self.random.next();
        let nominal = u64::from(self.settings.flow_ml_per_s) * 1000;
        let band = nominal / 1000 * u64::from(self.settings.noise_per_mille.min(1000));
        self.flow = nominal - band + mixed % (2 * band + 1);
    }
}

/// The row of the dosing plant in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "dosing",
    about: "A supply tank, a valve, a flow meter and a vessel, with START and STOP; the plant of `sieben demo`.",
    behaviour: "While the valve is open and the supply is not empty, `flow` litres per second run through the flow meter, more or less up to `noise` per mille, anew every 100 ms. \
                The flow meter rises with each full litre and falls half a litre later. What does not fit into the vessel is spilled.",
    input_bytes: 1,
    output_bytes: OUTPUT_BYTES,
    signals: &[
        button("start", 0, 0, "START button, 1 while pressed"),
        closed_button("stop", 0, 1, "STOP button, normally closed: 0 while pressed"),
        sensor("flow", 0, 7, "flow meter, one pulse per litre"),
        actuator("valve", 0, 0, "1 opens the valve"),
        commanded("display", DISPLAY as u32, "BCD", 1.0, "display of four decimal digits"),
    ],
    parameters: &[
        parameter("flow", 5.0, (0.1, 100.0), "l/s", "nominal flow through the open valve"),
        parameter("noise", 20.0, (0.0, 500.0), "‰", "how much the flow changes at most"),
        parameter("supply", 1000.0, (1.0, 1_000_000.0), "l", "what the supply tank holds at the beginning"),
        parameter("vessel", 200.0, (1.0, 1_000_000.0), "l", "what the vessel holds"),
    ],
    arrange: None,
    shown: &[],
    make: |values, seed| {
        Box::new(DosingPlant::new(DosingSettings {
            flow_ml_per_s: (values[0] * 1000.0) as u32,
            noise_per_mille: values[1] as u32,
            supply_litres: values[2] as u32,
            vessel_litres: values[3] as u32,
            seed,
            ..DosingSettings::default()
        }))
    },
};

impl Process for DosingPlant {
    fn step(&mut self, commands: &[u8], hands: &[u8]) {
        self.outputs.copy_from_slice(commands);
        self.start_pressed = is_set(hands, 0, 0);
        self.stop_pressed = !is_set(hands, 0, 1);
        self.advance(STEP_US);
    }
    fn sense(&self, into: &mut [u8]) {
        put_bits(&mut into[0], &[(7, self.pulse())]);
    }
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        vec![
            ("delivered", self.litres_delivered(), "l"),
            ("supply", self.supply_litres(), "l"),
            ("vessel", self.vessel_litres(), "l"),
            ("spilled", self.spilled_litres(), "l"),
            ("flow", self.flow(), "l/s"),
        ]
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
    fn attend(&mut self, attention: Attention) {
        match attention {
            // What was spilled was wiped up with it.
            Attention::ExchangeVessel => (self.vessel, self.spilled) = (0, 0),
            Attention::Refill => self.refill(),
        }
    }
}

fn litres(microlitres: u64) -> f64 {
    microlitres as f64 / LITRE as f64
}

impl IoModule for DosingPlant {
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        Some(Box::new(self.clone()))
    }
    fn name(&self) -> &str {
        &self.settings.name
    }
    fn inputs(&self) -> Range<u32> {
        self.settings.input..self.settings.input.saturating_add(1)
    }
    fn outputs(&self) -> Range<u32> {
        self.settings.output..self.settings.output.saturating_add(OUTPUT_BYTES)
    }
    fn read(&self, _offset: u32, into: &mut [u8]) {
        into.fill(self.input_byte());
    }
    fn write(&mut self, offset: u32, from: &[u8]) {
        let start = offset as usize;
        self.outputs[start..start + from.len()].copy_from_slice(from);
    }
    fn advance(&mut self, dt_us: u64) {
        let mut left = dt_us;
        for _ in 0..NOISE_STEPS_MAX {
            if left < self.until_noise_us {
                break;
            }
            left -= self.until_noise_us;
            self.pass(self.until_noise_us);
            self.until_noise_us = NOISE_STEP_US;
            self.change_flow();
        }
        self.pass(left);
        self.until_noise_us = self.until_noise_us.saturating_sub(left).max(1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plant() -> DosingPlant {
        DosingPlant::new(DosingSettings::default())
    }

    fn input(tank: &DosingPlant) -> u8 {
        let mut byte = [0];
        tank.read(0, &mut byte);
        byte[0]
    }

    #[test]
    fn buttons_show_in_the_input_byte() {
        let mut tank = plant();
        assert_eq!(input(&tank), 0b10, "STOP is normally closed");
        tank.press(Button::Start);
        tank.toggle(Button::Stop);
        assert_eq!(input(&tank), 0b01);
        tank.release(Button::Start);
        tank.toggle(Button::Stop);
        assert_eq!(input(&tank), 0b10);
    }

    #[test]
    fn the_flow_meter_gives_one_pulse_per_litre() {
        let mut tank = plant();
        tank.write(0, &[1]);
        let (mut pulses, mut last) = (0, false);
        while tank.litres_delivered() < 100.25 {
            tank.advance(10_000);
            pulses += u32::from(tank.pulse() && !last);
            last = tank.pulse();
        }
        assert_eq!(pulses, 100);
        assert!((tank.supply_litres() + tank.vessel_litres() - 1000.0).abs() < 1e-6);
        tank.write(0, &[0]);
        let before = tank.clone();
        tank.advance(0);
        assert_eq!(tank, before);
        tank.advance(5_000_000);
        assert!((tank.litres_delivered() - before.litres_delivered()).abs() < 1e-9, "nothing flows through a closed valve");
    }

    #[test]
    fn the_plant_is_the_same_for_the_same_seed_however_time_is_cut() {
        let run = |seed, step: u64| {
            let mut tank = DosingPlant::new(DosingSettings { seed, ..DosingSettings::default() });
            tank.write(0, &[1]);
            for _ in 0..10_000_000 / step {
                tank.advance(step);
            }
            tank.litres_delivered()
        };
        assert!((run(7, 10_000) - run(7, 1_000_000)).abs() < 1e-4);
        assert!((run(7, 10_000) - run(8, 10_000)).abs() > 1e-3);
    }

    #[test]
    fn nothing_comes_from_nothing() {
        let mut tank = plant();
        tank.write(0, &[1]);
        tank.advance(u64::MAX);
        tank.advance(u64::MAX);
        assert_eq!((tank.supply_litres(), tank.vessel_litres(), tank.spilled_litres()), (0.0, 200.0, 800.0));
        assert!(!tank.flowing() && tank.flow() == 0.0);
        tank.refill();
        tank.exchange_vessel();
        assert_eq!((tank.supply_litres(), tank.vessel_litres()), (1000.0, 0.0));
    }

    #[test]
    fn the_display_shows_bcd() {
        let mut tank = plant();
        tank.write(4, &[0x01, 0x42]);
        assert_eq!((tank.display(), tank.display_number()), (0x142, Some(142)));
        tank.write(5, &[0x0F]);
        assert_eq!(tank.display_number(), None);
    }
}
