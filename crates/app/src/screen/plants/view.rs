//! What a picture asks a plant: signals by name, state, parameters, faults. Nothing that is missing is an error.

use std::borrow::Cow;

use sieben_sim::devices::{ANALOG_MAX, Place, Signal};

use super::{Moment, PlantLook};
use crate::palette::Lit;

/// A plant at a moment.
pub(super) struct View<'a> {
    plant: &'a PlantLook,
    /// Places count from the first byte of their direction.
    signals: Cow<'static, [Signal]>,
    moment: Moment,
}

impl<'a> View<'a> {
    pub(super) fn new(plant: &'a PlantLook, moment: Moment) -> Self {
        // Parameters that do not go together are those of no plant: the usual ones do as well.
        let signals = plant.kind.terminals(&plant.parameters).map_or(plant.kind.signals.into(), |terminals| terminals.signals);
        Self { plant, signals, moment }
    }
    /// The signals in the order of the table.
    pub(super) fn signals(&self) -> &[Signal] {
        &self.signals
    }
    /// A signal by what faults call it.
    pub(super) fn signal(&self, name: &str) -> Option<&Signal> {
        self.signals().iter().find(|signal| signal.name == name)
    }

    /// Seconds of the CPU's time.
    pub(super) fn seconds(&self) -> f64 {
        self.moment.time_ms as f64 / 1e3
    }
    /// Every half second the other half of a second: what flashes is on or off.
    pub(super) fn flash(&self) -> Lit {
        Lit::when((self.moment.time_ms / 500).is_multiple_of(2))
    }

    /// The value among the bytes: a bit is 0 or 1.
    pub(super) fn raw(&self, signal: &Signal) -> i16 {
        let bytes = if signal.is_input() { &self.plant.inputs } else { &self.plant.outputs };
        let at = |byte: u32| bytes.get(byte as usize).copied().unwrap_or(0);
        match signal.place {
            Place::Bit(byte, bit) => i16::from(at(byte).checked_shr(u32::from(bit)).unwrap_or(0) & 1),
            Place::Word(byte) => i16::from_be_bytes([at(byte), at(byte.saturating_add(1))]),
        }
    }
    /// Whether a bit is 1.
    pub(super) fn is_on(&self, name: &str) -> bool {
        self.word(name) != 0
    }
    pub(super) fn lit(&self, name: &str) -> Lit {
        Lit::when(self.is_on(name))
    }
    pub(super) fn word(&self, name: &str) -> i16 {
        self.signal(name).map_or(0, |signal| self.raw(signal))
    }
    /// The part of its range that an analogue word has, 0 to 1.
    pub(super) fn part(&self, name: &str) -> f64 {
        f64::from(self.word(name)) / ANALOG_MAX
    }
    /// What only the plant knows; 0 where it does not say.
    pub(super) fn state(&self, name: &str) -> f64 {
        self.known(name).unwrap_or(0.0)
    }
    /// What only the plant knows, if it says it.
    pub(super) fn known(&self, name: &str) -> Option<f64> {
        self.plant.state.iter().find(|row| row.0 == name).map(|row| row.1).filter(|value| value.is_finite())
    }
    /// What the project has chosen, or what is usual.
    pub(super) fn parameter(&self, name: &str) -> f64 {
        let rows = self.plant.kind.parameters;
        let chosen = |index| self.plant.parameters.get(index).copied().filter(|value: &f64| value.is_finite());
        rows.iter().position(|row| row.name == name).map_or(0.0, |index| chosen(index).unwrap_or(rows[index].usual))
    }

    /// The address of a signal as English mnemonics write it.
    pub(super) fn address(&self, name: &str) -> String {
        self.signal(name).map(|signal| self.address_of(signal)).unwrap_or_default()
    }
    pub(super) fn address_of(&self, signal: &Signal) -> String {
        signal.address(if signal.is_input() { self.plant.input } else { self.plant.output })
    }
    /// Columns of the longest address.
    pub(super) fn address_width(&self) -> usize {
        self.signals().iter().map(|signal| self.address_of(signal).len()).max().unwrap_or(0)
    }
    /// The symbol at the address of a signal, or what faults call it.
    pub(super) fn label(&self, signal: &Signal) -> &'a str {
        self.plant.symbols.get(&self.address_of(signal)).map_or(signal.name, String::as_str)
    }
    /// Whether a signal has a fault.
    pub(super) fn fails(&self, name: &str) -> bool {
        let signal_of = |fault: &'a String| Some(fault.split_whitespace().next()?.rsplit_once('.')?.1);
        self.plant.faults.iter().any(|fault| signal_of(fault) == Some(name))
    }
    /// The faults, in the words of `--fault`.
    pub(super) fn faults(&self) -> &'a [String] {
        &self.plant.faults
    }
}
