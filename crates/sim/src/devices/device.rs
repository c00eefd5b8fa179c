//! A simulated device as a module: a process, its addresses, and what people do at it.

use std::ops::Range;

use sieben_cpu::IoModule;

use super::panel::output_bit;
use super::{Attention, Direction, Kind, Process, STEP_US, Signal, Terminals};

/// Steps in one go: an hour. Time beyond them does not pass for the plant, so that no jump of the clock can keep a CPU busy.
const STEPS_MAX: u64 = 3_600_000_000 / STEP_US;

/// A device as a project describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct DeviceSettings {
    /// What it is.
    pub kind: &'static Kind,
    /// What the user calls it.
    pub name: String,
    /// First input byte.
    pub input: u32,
    /// First output byte.
    pub output: u32,
    /// Equal seeds give equal plants.
    pub seed: u64,
    /// A value for each row of [`Kind::parameters`].
    pub parameters: Vec<f64>,
}

impl DeviceSettings {
    /// A device of a kind as it usually is, at byte 0.
    pub fn new(kind: &'static Kind) -> Self {
        let parameters = kind.parameters.iter().map(|parameter| parameter.usual).collect();
        Self { kind, name: kind.name.to_owned(), input: 0, output: 0, seed: 1, parameters }
    }
    /// Its terminals, at its addresses.
    ///
    /// # Errors
    /// The parameters do not go together; the message says which.
    pub fn terminals(&self) -> Result<Terminals, String> {
        let mut terminals = self.kind.terminals(&self.parameters)?;
        for (range, first) in [(&mut terminals.inputs, self.input), (&mut terminals.outputs, self.output)] {
            *range = range.start.saturating_add(first)..range.end.saturating_add(first);
        }
        Ok(terminals)
    }
}

/// A simulated device.
pub struct Device {
    settings: DeviceSettings,
    terminals: Terminals,
    process: Box<dyn Process>,
    commands: Vec<u8>,
    /// Input bytes as people have set them, and at the sensors' bits nothing.
    hands: Vec<u8>,
    /// Which input bits belong to people.
    hand_mask: Vec<u8>,
    /// Sensor bits that something from outside holds at a value, and the values.
    held_mask: Vec<u8>,
    held: Vec<u8>,
    rest_us: u64,
    failed: bool,
}

impl Device {
    /// A device at rest.
    pub fn new(settings: DeviceSettings) -> Self {
        let kind = settings.kind;
        // Parameters that do not go together were reported when the project was read.
        let terminals = settings.terminals().unwrap_or_else(|_| DeviceSettings::new(kind).terminals().unwrap_or_else(|_| kind.listed()));
        let inputs = vec![0; terminals.inputs.len()];
        let (mut hands, mut hand_mask) = (inputs.clone(), inputs.clone());
        for signal in terminals.signals.iter() {
            if let Direction::Hand { closed, .. } = signal.direction {
                signal.put(&mut hands, i16::from(closed));
                signal.put(&mut hand_mask, -1);
            }
        }
        let process = (kind.make)(&settings.parameters, settings.seed);
        let commands = vec![0; terminals.outputs.len()];
        Self {
            settings,
            terminals,
            process,
            commands,
            hands,
            hand_mask,
            held_mask: inputs.clone(),
            held: inputs,
            rest_us: 0,
            failed: false,
        }
    }
    /// How it is built.
    pub fn settings(&self) -> &DeviceSettings {
        &self.settings
    }
    /// Its signals; places count from the first byte of [`IoModule::inputs`] or [`IoModule::outputs`].
    pub fn signals(&self) -> &[Signal] {
        &self.terminals.signals
    }
    /// What it shows of outputs that need not be its own, in the form of [`Self::state`], out of all bytes that were put out.
    pub fn shown(&self, outputs: &[u8]) -> Vec<(&'static str, f64, &'static str)> {
        let kind = self.settings.kind;
        let rows = kind.shown.iter().filter_map(|name| {
            let index = kind.parameters.iter().position(|row| row.name == *name)?;
            let (byte, bit) = output_bit(*self.settings.parameters.get(index)?)?;
            let byte = outputs.get(byte as usize).copied().unwrap_or(0);
            Some((*name, f64::from(byte >> bit & 1), ""))
        });
        rows.collect()
    }
    /// What only the plant knows: name, value, unit.
    pub fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        self.process.state()
    }
    /// A value of [`Self::state`].
    pub fn value(&self, name: &str) -> Option<f64> {
        self.state().into_iter().find(|row| row.0 == name).map(|row| row.1)
    }
    /// The world around it does something for it.
    pub fn attend(&mut self, attention: Attention) {
        self.process.attend(attention);
    }
    /// The input bytes as the CPU sees them.
    pub fn input_bytes(&self) -> Vec<u8> {
        let mut bytes = self.hands.clone();
        self.process.sense(&mut bytes);
        for (index, byte) in bytes.iter_mut().enumerate() {
            *byte = *byte & !self.held_mask[index] | self.held[index];
        }
        bytes
    }
}

impl Clone for Device {
    fn clone(&self) -> Self {
        Self {
            settings: self.settings.clone(),
            terminals: self.terminals.clone(),
            process: self.process.copy(),
            commands: self.commands.clone(),
            hands: self.hands.clone(),
            hand_mask: self.hand_mask.clone(),
            held_mask: self.held_mask.clone(),
            held: self.held.clone(),
            rest_us: self.rest_us,
            failed: self.failed,
        }
    }
}

impl IoModule for Device {
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        Some(Box::new(self.clone()))
    }
    fn name(&self) -> &str {
        &self.settings.name
    }
    fn inputs(&self) -> Range<u32> {
        self.terminals.inputs.clone()
    }
    fn outputs(&self) -> Range<u32> {
        self.terminals.outputs.clone()
    }
    fn read(&self, offset: u32, into: &mut [u8]) {
        let start = offset as usize;
        into.copy_from_slice(&self.input_bytes()[start..start + into.len()]);
    }
    fn write(&mut self, offset: u32, from: &[u8]) {
        let start = offset as usize;
        self.commands[start..start + from.len()].copy_from_slice(from);
    }
    fn advance(&mut self, dt_us: u64) {
        let time = self.rest_us.saturating_add(dt_us);
        self.rest_us = time % STEP_US;
        for _ in 0..(time / STEP_US).min(STEPS_MAX) {
            self.process.step(&self.commands, &self.hands);
        }
    }
    fn answers(&self) -> bool {
        !self.failed
    }
    /// The module fails; the process behind it goes on with the commands that it had.
    fn set_answering(&mut self, answers: bool) -> bool {
        self.failed = !answers;
        true
    }
    /// A bit of a button changes what people do; one of a sensor is held at the value from now on, as if its wire were on a switch.
    fn set_input(&mut self, offset: u32, mask: u8, value: u8) -> bool {
        let at = offset as usize;
        let (by_hand, by_wire) = (mask & self.hand_mask[at], mask & !self.hand_mask[at]);
        self.hands[at] = self.hands[at] & !by_hand | value & by_hand;
        self.held_mask[at] |= by_wire;
        self.held[at] = self.held[at] & !by_wire | value & by_wire;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_seeds_give_equal_plants_however_time_is_cut() {
        for kind in Kind::ALL {
            let run = |seed, cut: u64| {
                let mut device = Device::new(DeviceSettings { seed, ..DeviceSettings::new(kind) });
                device.write(0, &vec![0xFF; device.outputs().len()]);
                for _ in 0..20_000_000 / cut {
                    device.advance(cut);
                }
                (device.input_bytes(), device.state())
            };
            assert_eq!(run(7, 10_000), run(7, 500), "{}", kind.name);
            assert_eq!(run(7, 10_000), run(7, 4_000_000), "{}", kind.name);
        }
    }

    #[test]
    fn a_copy_goes_on_as_the_original() {
        for kind in Kind::ALL {
            let mut device = Device::new(DeviceSettings::new(kind));
            device.write(0, &vec![0x55; device.outputs().len()]);
            device.advance(3_000_500);
            let mut copy = device.clone();
            device.advance(9_999_700);
            copy.advance(9_999_700);
            assert_eq!((device.input_bytes(), device.state()), (copy.input_bytes(), copy.state()), "{}", kind.name);
        }
    }

    #[test]
    fn what_is_set_from_outside_stays() {
        for kind in Kind::ALL {
            for signal in Device::new(DeviceSettings::new(kind)).signals().iter().filter(|signal| signal.is_input()) {
                let mut device = Device::new(DeviceSettings::new(kind));
                let mut mask = vec![0; device.inputs().len()];
                signal.put(&mut mask, -1);
                for value in [mask.clone(), vec![0; mask.len()]] {
                    for (offset, (&mask, &value)) in mask.iter().zip(&value).enumerate() {
                        assert!(device.set_input(offset as u32, mask, value));
                    }
                    device.advance(5_000_000);
                    assert_eq!(signal.raw(&device.input_bytes()), signal.raw(&value), "{} {}", kind.name, signal.name);
                }
            }
        }
    }

    #[test]
    fn no_length_of_time_hangs_a_plant() {
        let mut device = Device::new(DeviceSettings::new(&super::super::tank::KIND));
        device.advance(u64::MAX);
        assert!(device.value("level").is_some_and(f64::is_finite));
    }
}
