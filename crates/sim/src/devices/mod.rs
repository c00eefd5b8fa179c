//! Simulated devices: one file each, one row each in the table [`Kind::ALL`].

pub mod conveyor;
pub mod device;
pub mod dosing;
pub mod elevator;
pub mod junction;
pub mod motor;
pub mod panel;
pub mod random;
pub mod tank;
pub mod thermal;

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

pub use device::{Device, DeviceSettings};
pub use dosing::{Button, DosingPlant, DosingSettings};

/// Microseconds of one step of a process.
pub const STEP_US: u64 = 1_000;

/// What a CPU sees of an analogue value at the end of its range, as S7 modules have it.
pub const ANALOG_MAX: f64 = 27_648.0;

/// The world behind the terminals of a device. It knows no addresses: bytes count from the first of the device.
pub trait Process: Send + Sync {
    /// One step of [`STEP_US`] passes with these output bytes; `hands` are the input bytes as people and things around have set them.
    fn step(&mut self, commands: &[u8], hands: &[u8]);
    /// Writes what its sensors see; bits that belong to people stay as they are.
    fn sense(&self, into: &mut [u8]);
    /// What only the plant knows: name, value, unit.
    fn state(&self) -> Vec<(&'static str, f64, &'static str)>;
    /// The same process in the same state.
    fn copy(&self) -> Box<dyn Process>;
    /// The world around the plant does something that no terminal has; nothing where there is nothing of the kind.
    fn attend(&mut self, attention: Attention) {
        let _ = attention;
    }
}

/// What the world around a plant does for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attention {
    /// An empty vessel takes the place of the full one.
    ExchangeVessel,
    /// What is used up is filled again.
    Refill,
}

/// Which way a signal goes, seen from the CPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From a sensor to the CPU.
    Sensor,
    /// From people or things around the plant to the CPU: set from outside, the process does not change it.
    Hand {
        /// What people do with it.
        operated: Operated,
        /// The value at the beginning: `true` for what is normally closed.
        closed: bool,
    },
    /// From the CPU to an actuator.
    Actuator,
}

/// How a signal that belongs to people is operated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operated {
    /// Pressed, and it comes back when it is let go.
    Button,
    /// Put, and it stays so.
    Switch,
}

/// Where a signal lies among the bytes of its device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A bit: byte and number.
    Bit(u32, u8),
    /// A word, high byte first.
    Word(u32),
}

/// A terminal of a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Signal {
    /// What faults call it.
    pub name: &'static str,
    /// Which way it goes.
    pub direction: Direction,
    /// Where it lies.
    pub place: Place,
    /// The unit of a word; empty for bits.
    pub unit: &'static str,
    /// What a word counts for one unit.
    pub per_unit: f64,
    /// What it says, in one sentence without a full stop.
    pub about: &'static str,
}

impl Signal {
    const fn bit(direction: Direction, name: &'static str, byte: u32, bit: u8, about: &'static str) -> Self {
        Self { name, direction, place: Place::Bit(byte, bit), unit: "", per_unit: 1.0, about }
    }
    const fn word(direction: Direction, name: &'static str, byte: u32, unit: &'static str, per_unit: f64, about: &'static str) -> Self {
        Self { name, direction, place: Place::Word(byte), unit, per_unit, about }
    }
    /// Whether the CPU reads it.
    pub fn is_input(&self) -> bool {
        self.direction != Direction::Actuator
    }
    /// Its address as English mnemonics write it, in a device whose first byte of this direction is `base`.
    pub fn address(&self, base: u32) -> String {
        let area = if self.is_input() { "I" } else { "Q" };
        match self.place {
            Place::Bit(byte, bit) => format!("{area} {}.{bit}", base.saturating_add(byte)),
            Place::Word(byte) => format!("{area}W {}", base.saturating_add(byte)),
        }
    }
    /// Its value among the bytes of its direction: 0 or 1, or the word with its sign.
    pub fn raw(&self, bytes: &[u8]) -> i16 {
        match self.place {
            Place::Bit(byte, bit) => i16::from(bytes[byte as usize] >> bit & 1),
            Place::Word(byte) => i16::from_be_bytes([bytes[byte as usize], bytes[byte as usize + 1]]),
        }
    }
    /// Puts a value into the bytes of its direction; a bit is 1 for everything but 0.
    pub fn put(&self, bytes: &mut [u8], raw: i16) {
        match self.place {
            Place::Bit(byte, bit) => {
                let byte = &mut bytes[byte as usize];
                *byte = *byte & !(1 << bit) | u8::from(raw != 0) << bit;
            }
            Place::Word(byte) => bytes[byte as usize..byte as usize + 2].copy_from_slice(&raw.to_be_bytes()),
        }
    }
}

const fn sensor(name: &'static str, byte: u32, bit: u8, about: &'static str) -> Signal {
    Signal::bit(Direction::Sensor, name, byte, bit, about)
}
const fn button(name: &'static str, byte: u32, bit: u8, about: &'static str) -> Signal {
    Signal::bit(Direction::Hand { operated: Operated::Button, closed: false }, name, byte, bit, about)
}
const fn closed_button(name: &'static str, byte: u32, bit: u8, about: &'static str) -> Signal {
    Signal::bit(Direction::Hand { operated: Operated::Button, closed: true }, name, byte, bit, about)
}
const fn switch(name: &'static str, byte: u32, bit: u8, about: &'static str) -> Signal {
    Signal::bit(Direction::Hand { operated: Operated::Switch, closed: false }, name, byte, bit, about)
}
const fn closed_switch(name: &'static str, byte: u32, bit: u8, about: &'static str) -> Signal {
    Signal::bit(Direction::Hand { operated: Operated::Switch, closed: true }, name, byte, bit, about)
}
const fn actuator(name: &'static str, byte: u32, bit: u8, about: &'static str) -> Signal {
    Signal::bit(Direction::Actuator, name, byte, bit, about)
}
const fn measured(name: &'static str, byte: u32, unit: &'static str, per_unit: f64, about: &'static str) -> Signal {
    Signal::word(Direction::Sensor, name, byte, unit, per_unit, about)
}
const fn commanded(name: &'static str, byte: u32, unit: &'static str, per_unit: f64, about: &'static str) -> Signal {
    Signal::word(Direction::Actuator, name, byte, unit, per_unit, about)
}

/// A number that a project can choose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its key in `sieben.toml`.
    pub name: &'static str,
    /// The value without the key.
    pub usual: f64,
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub most: f64,
    /// Its unit.
    pub unit: &'static str,
    /// What it says.
    pub about: &'static str,
}

const fn parameter(name: &'static str, usual: f64, range: (f64, f64), unit: &'static str, about: &'static str) -> Parameter {
    Parameter { name, usual, least: range.0, most: range.1, unit, about }
}

/// The terminals of one device.
#[derive(Clone, Debug, PartialEq)]
pub struct Terminals {
    /// Bytes that the CPU reads.
    pub inputs: Range<u32>,
    /// Bytes that the CPU writes.
    pub outputs: Range<u32>,
    /// The signals; places count from the first byte of their direction.
    pub signals: Cow<'static, [Signal]>,
}

/// Signals at the addresses that parameters choose, or a message about these.
type Arrange = fn(&[f64]) -> Result<Vec<Signal>, String>;

/// A kind of device.
pub struct Kind {
    /// What `kind` in `sieben.toml` says.
    pub name: &'static str,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// How it behaves: equations and rules, in Markdown.
    pub behaviour: &'static str,
    /// Bytes that the CPU reads.
    pub input_bytes: u32,
    /// Bytes that the CPU writes.
    pub output_bytes: u32,
    /// Its terminals.
    pub signals: &'static [Signal],
    /// What a project can choose.
    pub parameters: &'static [Parameter],
    /// The signals with these parameters, where they choose the addresses; places count from byte 0.
    arrange: Option<Arrange>,
    /// Parameters that name an output bit of whichever module, which the device shows.
    pub shown: &'static [&'static str],
    /// Makes one with these parameters, in the order of the table, and this seed.
    make: fn(&[f64], u64) -> Box<dyn Process>,
}

impl Kind {
    /// All kinds, by name.
    pub const ALL: [&'static Kind; 8] =
        [&conveyor::KIND, &dosing::KIND, &elevator::KIND, &junction::KIND, &motor::KIND, &panel::KIND, &tank::KIND, &thermal::KIND];

    /// The kind of this name.
    pub fn by_name(name: &str) -> Option<&'static Self> {
        Self::ALL.into_iter().find(|kind| kind.name == name)
    }
    /// The terminals of a device of this kind with these parameters, at byte 0.
    ///
    /// # Errors
    /// The parameters do not go together; the message says which.
    pub fn terminals(&self, parameters: &[f64]) -> Result<Terminals, String> {
        let Some(arrange) = self.arrange else { return Ok(self.listed()) };
        let mut signals = arrange(parameters)?;
        let range = |inputs: bool| {
            let places = signals.iter().filter(|signal| signal.is_input() == inputs).map(|signal| match signal.place {
                Place::Bit(byte, _) => byte..byte + 1,
                Place::Word(byte) => byte..byte + 2,
            });
            places.reduce(|all, one| all.start.min(one.start)..all.end.max(one.end)).unwrap_or(0..0)
        };
        let (inputs, outputs) = (range(true), range(false));
        for signal in &mut signals {
            let first = if signal.is_input() { inputs.start } else { outputs.start };
            match &mut signal.place {
                Place::Bit(byte, _) | Place::Word(byte) => *byte -= first,
            }
        }
        Ok(Terminals { inputs, outputs, signals: signals.into() })
    }
    fn listed(&self) -> Terminals {
        Terminals { inputs: 0..self.input_bytes, outputs: 0..self.output_bytes, signals: self.signals.into() }
    }
    /// A signal by its name.
    pub fn signal(&self, name: &str) -> Option<&'static Signal> {
        self.signals.iter().find(|signal| signal.name == name)
    }
}

impl PartialEq for Kind {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl fmt::Debug for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Whether a bit is 1.
fn is_set(bytes: &[u8], byte: usize, bit: u8) -> bool {
    bytes.get(byte).is_some_and(|value| value >> bit & 1 != 0)
}

/// Puts sensor bits into a byte and leaves the others.
fn put_bits(byte: &mut u8, bits: &[(u8, bool)]) {
    for &(bit, value) in bits {
        *byte = *byte & !(1 << bit) | u8::from(value) << bit;
    }
}

/// A word with its sign at a byte; 0 where there is none.
fn word(bytes: &[u8], byte: usize) -> i16 {
    bytes.get(byte..byte + 2).map_or(0, |pair| i16::from_be_bytes([pair[0], pair[1]]))
}

/// Puts a word, held within its range.
fn put_word(bytes: &mut [u8], byte: usize, value: f64) {
    // Conversion of a float saturates.
    bytes[byte..byte + 2].copy_from_slice(&(value.round() as i16).to_be_bytes());
}

/// The part of its range that an analogue output asks for, 0 to 1.
fn opening(bytes: &[u8], byte: usize) -> f64 {
    (f64::from(word(bytes, byte)) / ANALOG_MAX).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_kinds_fits_together() {
        for kind in Kind::ALL {
            assert_eq!(Kind::by_name(kind.name), Some(kind));
            let mut taken = [Vec::new(), Vec::new()];
            for signal in kind.signals {
                let side = usize::from(signal.is_input());
                let length = if signal.is_input() { kind.input_bytes } else { kind.output_bytes };
                let bits: Vec<u32> = match signal.place {
                    Place::Bit(byte, bit) => vec![byte * 8 + u32::from(bit)],
                    Place::Word(byte) => (byte * 8..byte * 8 + 16).collect(),
                };
                for bit in bits {
                    assert!(bit < length * 8 && !taken[side].contains(&bit), "{} {}", kind.name, signal.name);
                    taken[side].push(bit);
                }
                assert_eq!(kind.signals.iter().filter(|other| other.name == signal.name).count(), 1, "{} {}", kind.name, signal.name);
            }
            for parameter in kind.parameters {
                assert!((parameter.least..=parameter.most).contains(&parameter.usual), "{} {}", kind.name, parameter.name);
            }
        }
        assert!(Kind::ALL.windows(2).all(|pair| pair[0].name < pair[1].name));
    }

    /// A process writes its sensors and nothing else, whatever it is told, and stays finite.
    #[test]
    fn no_process_touches_what_belongs_to_people_or_runs_away() {
        for kind in Kind::ALL {
            for extreme in [false, true] {
                let values: Vec<f64> =
                    kind.parameters.iter().map(|parameter| if extreme { parameter.most } else { parameter.least }).collect();
                let mut process = (kind.make)(&values, 3);
                let mut random = random::Random::new(5);
                let mut hands = vec![0; kind.input_bytes as usize];
                let mut commands = vec![0; kind.output_bytes as usize];
                for step in 0..30_000 {
                    if step % 97 == 0 {
                        commands.iter_mut().chain(&mut hands).for_each(|byte| *byte = random.next() as u8);
                    }
                    process.step(&commands, &hands);
                }
                let mut seen = hands.clone();
                process.sense(&mut seen);
                for signal in kind.signals.iter().filter(|signal| matches!(signal.direction, Direction::Hand { .. })) {
                    assert_eq!(signal.raw(&seen), signal.raw(&hands), "{} {}", kind.name, signal.name);
                }
                for (name, value, _) in process.state() {
                    assert!(value.is_finite(), "{} {name}: {value}", kind.name);
                }
            }
        }
    }
}
