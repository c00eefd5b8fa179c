//! A training panel: switches, buttons, a thumbwheel, lamps and a display, whose addresses a project chooses.

use super::{Direction, Kind, Operated, Parameter, Process, Signal, parameter};

/// The row of the panel in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "panel",
    about: "A training panel: toggle switches, push buttons, selectors, a thumbwheel of four decades, lamps, a display of four digits, a horn and lamps of two motors.",
    behaviour: "Nothing goes on in it: what people set is read, what is put out is shown. Each part begins at the byte that its key names; a part with -1 is not there. \
                The panel answers for all bytes from its first part to its last one, also for those between them. \
                The thumbwheel gives four BCD digits; the display shows four, and a dash where a nibble is none. \
                `horn`, `motor_right` and `motor_left` only show an output, `20.7` for Q 20.7, which may belong to another module.",
    input_bytes: 6,
    output_bytes: 14,
    signals: &LISTED,
    parameters: &[
        byte("switches", 0.0, "first byte of 16 toggle switches"),
        byte("buttons", 2.0, "first byte of 16 push buttons"),
        byte("selectors", -1.0, "byte of 8 more toggle switches"),
        byte("thumbwheel", 4.0, "first byte of the word of the thumbwheel"),
        byte("lamps", 4.0, "first byte of 32 lamps"),
        byte("display", 12.0, "first byte of the word of the display"),
        byte("horn", 20.7, "output that the horn shows"),
        byte("motor_right", 20.5, "output that the lamp of the motor to the right shows"),
        byte("motor_left", 20.6, "output that the lamp of the motor to the left shows"),
    ],
    arrange: Some(arrange),
    shown: &["horn", "motor_right", "motor_left"],
    make: |_values, _seed| Box::new(Panel),
};

const fn byte(name: &'static str, usual: f64, about: &'static str) -> Parameter {
    parameter(name, usual, (-1.0, 65_535.0), "", about)
}

/// The value of a key of a part that is not there.
const ABSENT: f64 = -1.0;

macro_rules! eight {
    ($($stem:literal),*) => {
        &[$(concat!($stem, "0"), concat!($stem, "1"), concat!($stem, "2"), concat!($stem, "3"),
            concat!($stem, "4"), concat!($stem, "5"), concat!($stem, "6"), concat!($stem, "7")),*]
    };
}

/// Signals of the panel that lie next to each other.
struct Part {
    /// The key of its address.
    key: &'static str,
    direction: Direction,
    /// Bits in the order of their addresses; one name is a word of BCD digits.
    names: &'static [&'static str],
    about: &'static str,
}

const SWITCH: Direction = Direction::Hand { operated: Operated::Switch, closed: false };
const BUTTON: Direction = Direction::Hand { operated: Operated::Button, closed: false };

const PARTS: [Part; 6] = [
    Part { key: "switches", direction: SWITCH, names: eight!("switch_0_", "switch_1_"), about: "toggle switch" },
    Part { key: "buttons", direction: BUTTON, names: eight!("button_0_", "button_1_"), about: "push button" },
    Part { key: "selectors", direction: SWITCH, names: eight!("selector_"), about: "toggle switch" },
    Part { key: "thumbwheel", direction: SWITCH, names: &["thumbwheel"], about: "thumbwheel of four decades" },
    Part { key: "lamps", direction: Direction::Actuator, names: eight!("lamp_0_", "lamp_1_", "lamp_2_", "lamp_3_"), about: "lamp" },
    Part { key: "display", direction: Direction::Actuator, names: &["display"], about: "display of four decimal digits" },
];

impl Part {
    const fn bytes(&self) -> u32 {
        if self.names.len() == 1 { 2 } else { self.names.len() as u32 / 8 }
    }
    const fn signal(&self, index: usize, first: u32) -> Signal {
        match self.names.len() {
            1 => Signal::word(self.direction, self.names[index], first, "BCD", 1.0, self.about),
            _ => Signal::bit(self.direction, self.names[index], first + index as u32 / 8, (index % 8) as u8, self.about),
        }
    }
    fn usual(&self) -> f64 {
        KIND.parameters.iter().find(|row| row.name == self.key).map_or(ABSENT, |row| row.usual)
    }
}

/// The signals where they usually are: all parts but the selectors.
const LISTED: [Signal; 66] = {
    let firsts = [Some(0), Some(2), None, Some(4), Some(4), Some(12)];
    let mut signals = [PARTS[0].signal(0, 0); 66];
    let (mut part, mut count) = (0, 0);
    while part < PARTS.len() {
        if let Some(first) = firsts[part] {
            let mut index = 0;
            while index < PARTS[part].names.len() {
                signals[count] = PARTS[part].signal(index, first);
                (index, count) = (index + 1, count + 1);
            }
        }
        part += 1;
    }
    signals
};

/// The signals where a project wants them.
fn arrange(values: &[f64]) -> Result<Vec<Signal>, String> {
    let mut signals: Vec<Signal> = Vec::new();
    let mut taken: Vec<(&Part, u32)> = Vec::new();
    for part in &PARTS {
        let index = KIND.parameters.iter().position(|row| row.name == part.key);
        let value = index.and_then(|index| values.get(index).copied()).unwrap_or_else(|| part.usual());
        if value == ABSENT {
            continue;
        }
        if value.fract() != 0.0 || !(0.0..=65_535.0).contains(&value) {
            return Err(format!("`{}` is the number of a byte, or -1 for a panel without: `{0} = {}`", part.key, part.usual().max(0.0)));
        }
        let first = value as u32;
        let input = part.direction != Direction::Actuator;
        for &(other, other_first) in taken.iter().filter(|(other, _)| (other.direction != Direction::Actuator) == input) {
            let both = first.max(other_first);
            if both < (first + part.bytes()).min(other_first + other.bytes()) {
                let area = if input { "IB" } else { "QB" };
                return Err(format!(
                    "`{}` and `{}` of the panel both use {area} {both}: give one of them another byte",
                    other.key, part.key
                ));
            }
        }
        taken.push((part, first));
        signals.extend((0..part.names.len()).map(|index| part.signal(index, first)));
    }
    for name in KIND.shown {
        let value = KIND.parameters.iter().position(|row| row.name == *name).and_then(|index| values.get(index).copied());
        if value.is_some_and(|value| value != ABSENT && output_bit(value).is_none()) {
            return Err(format!("`{name}` is an output bit, or -1 for a panel without: `{name} = 20.7` for Q 20.7"));
        }
    }
    Ok(signals)
}

/// Byte and number of the bit that a number such as 20.7 names.
pub(super) fn output_bit(value: f64) -> Option<(u32, u8)> {
    let tenths = (value * 10.0).round();
    if !(0.0..=655_357.0).contains(&tenths) || (value * 10.0 - tenths).abs() > 1e-6 {
        return None;
    }
    let (byte, bit) = (tenths as u32 / 10, (tenths as u32 % 10) as u8);
    (bit < 8).then_some((byte, bit))
}

#[derive(Clone)]
struct Panel;

impl Process for Panel {
    fn step(&mut self, _commands: &[u8], _hands: &[u8]) {}
    fn sense(&self, _into: &mut [u8]) {}
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        Vec::new()
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Device, DeviceSettings};
    use super::*;
    use sieben_cpu::IoModule;

    fn panel(values: &[(&str, f64)]) -> DeviceSettings {
        let mut settings = DeviceSettings::new(&KIND);
        for (key, value) in values {
            settings.parameters[KIND.parameters.iter().position(|row| row.name == *key).expect("a key")] = *value;
        }
        settings
    }

    #[test]
    fn what_is_listed_is_what_is_usual() {
        let usual: Vec<f64> = KIND.parameters.iter().map(|row| row.usual).collect();
        assert_eq!(arrange(&usual).as_deref(), Ok(&LISTED[..]));
    }

    #[test]
    fn parts_lie_where_the_project_wants_them() {
        let device = Device::new(panel(&[("switches", 8.0), ("buttons", -1.0), ("lamps", 20.0), ("display", 30.0)]));
        assert_eq!((device.inputs(), device.outputs()), (4..10, 20..32));
        let address = |name: &str| {
            let signal = device.signals().iter().find(|signal| signal.name == name)?;
            Some(signal.address(if signal.is_input() { device.inputs().start } else { device.outputs().start }))
        };
        let found = ["switch_0_3", "switch_1_0", "thumbwheel", "lamp_0_0", "lamp_3_7", "display", "button_0_0"].map(address);
        let found: Vec<Option<&str>> = found.iter().map(Option::as_deref).collect();
        assert_eq!(found, [Some("I 8.3"), Some("I 9.0"), Some("IW 4"), Some("Q 20.0"), Some("Q 23.7"), Some("QW 30"), None]);
    }

    #[test]
    fn what_people_set_is_read_and_stays() {
        let mut device = Device::new(panel(&[]));
        for (byte, mask, value) in [(0, 0xFF, 0xA5), (3, 1, 1), (4, 0xFF, 0x12), (5, 0xFF, 0x34)] {
            assert!(device.set_input(byte, mask, value));
        }
        device.advance(1_000_000);
        assert_eq!(device.input_bytes(), [0xA5, 0, 0, 1, 0x12, 0x34]);
    }

    #[test]
    fn every_mistake_has_a_sentence() {
        for (values, expected) in [
            (&[("lamps", 10.0)][..], "`lamps` and `display` of the panel both use QB 12"),
            (&[("selectors", 1.0)], "`switches` and `selectors` of the panel both use IB 1"),
            (&[("switches", 0.5)], "`switches` is the number of a byte, or -1"),
            (&[("horn", 20.8)], "`horn` is an output bit"),
            (&[("motor_left", 20.55)], "`motor_left` is an output bit"),
        ] {
            let error = panel(values).terminals().expect_err(expected);
            assert!(error.contains(expected), "{error}");
        }
    }

    #[test]
    fn the_horn_shows_an_output_of_another_module() {
        let device = Device::new(panel(&[("motor_left", -1.0)]));
        let mut outputs = vec![0; 21];
        outputs[20] = 0x80;
        assert_eq!(device.shown(&outputs), [("horn", 1.0, ""), ("motor_right", 0.0, "")]);
        assert_eq!(device.shown(&[]), [("horn", 0.0, ""), ("motor_right", 0.0, "")]);
    }
}
