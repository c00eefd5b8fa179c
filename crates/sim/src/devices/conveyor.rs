//! A conveyor belt that runs both ways, with parts on it, light barriers at its ends and a scale.

use super::random::Random;
use super::{Kind, Process, STEP_US, actuator, button, is_set, measured, parameter, put_bits, put_word, sensor};

/// The row of the conveyor in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "conveyor",
    about: "A belt that runs to the right and to the left, with parts on it, three light barriers, a scale and a horn.",
    behaviour: "The belt reaches `speed` in 0.3 s; with both directions commanded it stands. A part of 20 cm is put on at the left end with every rising edge of `put`, and by itself about every `gap` seconds (never with 0) \
                where the left end is free. The light barriers at the left end, in the middle and at the right end see a part over them. Behind the right end a part is delivered, \
                before the left end it falls off. The scale shows the weight of the part at the right end: `weight` grams, more or less up to `spread`.",
    input_bytes: 4,
    output_bytes: 1,
    signals: &[
        sensor("left_end", 0, 0, "light barrier at the left end, 1 = a part is there"),
        sensor("middle", 0, 1, "light barrier in the middle"),
        sensor("right_end", 0, 2, "light barrier at the right end"),
        sensor("running", 0, 3, "speed monitor of the belt, 1 above 80 % of the speed, in either direction"),
        button("put", 0, 4, "a rising edge puts a part on at the left end"),
        measured("weight", 2, "g", 1.0, "weight of the part at the right end in grams, 0 without one"),
        actuator("right", 0, 5, "1 moves the belt to the right"),
        actuator("left", 0, 6, "1 moves the belt to the left"),
        actuator("horn", 0, 7, "1 sounds the horn"),
    ],
    parameters: &[
        parameter("length", 2.0, (0.5, 100.0), "m", "from the left end to the right end"),
        parameter("speed", 0.5, (0.01, 10.0), "m/s", "speed of the belt"),
        parameter("gap", 0.0, (0.0, 3600.0), "s", "mean time between two parts that come by themselves; 0 = none"),
        parameter("weight", 500.0, (1.0, 30_000.0), "g", "mean weight of a part"),
        parameter("spread", 20.0, (0.0, 1000.0), "g", "how much the weight differs at most"),
    ],
    arrange: None,
    shown: &[],
    make: |values, seed| {
        let mut random = Random::new(seed);
        let until_part = if values[2] > 0.0 { random.gap(values[2]) } else { u64::MAX };
        Box::new(Conveyor {
            length: values[0],
            speed: values[1],
            gap: values[2],
            weight: values[3],
            spread: values[4],
            velocity: 0.0,
            parts: Vec::new(),
            put_before: false,
            until_part,
            delivered: 0,
            dropped: 0,
            random,
        })
    },
};

const DT: f64 = STEP_US as f64 / 1e6;
/// Length of a part in metres.
pub const PART: f64 = 0.2;
/// Seconds until the belt has its speed.
const RAMP: f64 = 0.3;
/// Where the middles of the first parts are, from the right: metres from the left end. A belt of 3 m has no more.
pub const PART_PLACES: [&str; 20] = [
    "part_1", "part_2", "part_3", "part_4", "part_5", "part_6", "part_7", "part_8", "part_9", "part_10", "part_11", "part_12", "part_13",
    "part_14", "part_15", "part_16", "part_17", "part_18", "part_19", "part_20",
];
/// Parts on the belt: more than fit next to each other on the longest.
const PARTS_MAX: usize = 1000;

#[derive(Clone)]
struct Part {
    /// Metres from the left end to its middle.
    at: f64,
    grams: f64,
}

#[derive(Clone)]
struct Conveyor {
    length: f64,
    speed: f64,
    gap: f64,
    weight: f64,
    spread: f64,
    /// Metres per second, to the right.
    velocity: f64,
    /// From right to left.
    parts: Vec<Part>,
    put_before: bool,
    until_part: u64,
    delivered: u64,
    dropped: u64,
    random: Random,
}

impl Conveyor {
    fn part_at(&self, place: f64) -> Option<&Part> {
        self.parts.iter().find(|part| (part.at - place).abs() < PART / 2.0)
    }
    fn put(&mut self) {
        let free = self.parts.iter().all(|part| part.at > PART);
        if free && self.parts.len() < PARTS_MAX {
            let grams = self.weight + self.spread * self.random.around_zero();
            self.parts.push(Part { at: 0.0, grams });
        }
    }
}

impl Process for Conveyor {
    fn step(&mut self, commands: &[u8], hands: &[u8]) {
        let wanted = match (is_set(commands, 0, 5), is_set(commands, 0, 6)) {
            (true, false) => self.speed,
            (false, true) => -self.speed,
            _ => 0.0,
        };
        let change = self.speed * DT / RAMP;
        self.velocity += (wanted - self.velocity).clamp(-change, change);
        for part in &mut self.parts {
            part.at += self.velocity * DT;
        }
        let on_belt = self.parts.len();
        self.parts.retain(|part| part.at <= self.length + PART);
        self.delivered += (on_belt - self.parts.len()) as u64;
        let on_belt = self.parts.len();
        self.parts.retain(|part| part.at >= -PART);
        self.dropped += (on_belt - self.parts.len()) as u64;
        let put = is_set(hands, 0, 4);
        if put && !self.put_before {
            self.put();
        }
        self.put_before = put;
        self.until_part = self.until_part.saturating_sub(1);
        if self.until_part == 0 && self.gap > 0.0 {
            self.until_part = self.random.gap(self.gap).max(1);
            self.put();
        }
    }
    fn sense(&self, into: &mut [u8]) {
        let there = |place| self.part_at(place).is_some();
        let running = self.velocity.abs() > 0.8 * self.speed;
        put_bits(&mut into[0], &[(0, there(0.0)), (1, there(self.length / 2.0)), (2, there(self.length)), (3, running)]);
        put_word(into, 2, self.part_at(self.length).map_or(0.0, |part| part.grams));
    }
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        let mut rows = vec![
            ("parts", self.parts.len() as f64, ""),
            ("delivered", self.delivered as f64, ""),
            ("dropped", self.dropped as f64, ""),
            ("velocity", self.velocity, "m/s"),
        ];
        rows.extend(PART_PLACES.into_iter().zip(&self.parts).map(|(name, part)| (name, part.at, "m")));
        rows
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
}
