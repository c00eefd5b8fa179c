//! A junction of a main road, a side road and a crossing for pedestrians, with lamps, detectors and traffic.

use super::random::Random;
use super::{Kind, Process, STEP_US, actuator, button, is_set, parameter, put_bits, sensor};

/// The row of the junction in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "junction",
    about: "A junction of a main road and a side road with a pedestrian crossing over the main road: lamps, detectors, traffic.",
    behaviour: "Cars come about every `main_gap` and `side_gap` seconds, and wait while their lamp is not green alone; from a queue one starts every 2 s of green. \
                The detector of a road is 1 while a car waits on it. Pedestrians come about every `walk_gap` seconds, press the button, and all walk when their lamp is green. \
                The lamp monitors are 1 while the red lamp is on and draws current. A conflict is every moment in which two ways that cross have green.",
    input_bytes: 1,
    output_bytes: 1,
    signals: &[
        sensor("main_car", 0, 0, "detector of the main road, 1 while a car waits"),
        sensor("side_car", 0, 1, "detector of the side road, 1 while a car waits"),
        sensor("request", 0, 2, "button of the pedestrians, 1 while one of them holds it"),
        button("button", 0, 3, "a second button for pedestrians, pressed by hand"),
        sensor("main_red_lit", 0, 4, "lamp monitor: the red lamp of the main road draws current"),
        sensor("side_red_lit", 0, 5, "lamp monitor: the red lamp of the side road draws current"),
        actuator("main_red", 0, 0, "red lamp of the main road"),
        actuator("main_yellow", 0, 1, "yellow lamp of the main road"),
        actuator("main_green", 0, 2, "green lamp of the main road"),
        actuator("side_red", 0, 3, "red lamp of the side road"),
        actuator("side_yellow", 0, 4, "yellow lamp of the side road"),
        actuator("side_green", 0, 5, "green lamp of the side road"),
        actuator("walk_red", 0, 6, "red lamp of the pedestrians"),
        actuator("walk_green", 0, 7, "green lamp of the pedestrians"),
    ],
    parameters: &[
        parameter("main_gap", 4.0, (0.0, 3600.0), "s", "mean time between two cars on the main road; 0 = none come"),
        parameter("side_gap", 10.0, (0.0, 3600.0), "s", "mean time between two cars on the side road; 0 = none come"),
        parameter("walk_gap", 30.0, (0.0, 3600.0), "s", "mean time between two pedestrians; 0 = none come"),
    ],
    arrange: None,
    shown: &[],
    make: |values, seed| {
        let mut random = Random::new(seed);
        let stream = |gap_s: f64, random: &mut Random| Stream {
            gap_s,
            until_next: if gap_s > 0.0 { random.gap(gap_s).max(1) } else { u64::MAX },
            waiting: 0,
            passed: 0,
            until_start: 0,
            crossing: 0,
        };
        let streams = [stream(values[0], &mut random), stream(values[1], &mut random), stream(values[2], &mut random)];
        Box::new(Junction { streams, lamps: 0, pressing: 0, conflict_steps: 0, random })
    },
};

/// Steps between two cars that start from a queue.
const HEADWAY: u64 = 2_000_000 / STEP_US;
/// How long a pedestrian holds the button.
const PRESS: u64 = 500_000 / STEP_US;
/// Steps that a car of the main road, one of the side road and a pedestrian need to get across.
const CROSSING: [u64; 3] = [HEADWAY, HEADWAY, 2 * HEADWAY];
/// Cars in a queue: the road is no longer.
const QUEUE_MAX: u32 = 200;
const MAIN: usize = 0;
const SIDE: usize = 1;
const WALK: usize = 2;

#[derive(Clone)]
struct Stream {
    gap_s: f64,
    until_next: u64,
    waiting: u32,
    passed: u64,
    /// Steps until the next car of the queue starts.
    until_start: u64,
    /// Steps until those who started last are across.
    crossing: u64,
}

#[derive(Clone)]
struct Junction {
    streams: [Stream; 3],
    lamps: u8,
    /// Steps for which a pedestrian still holds the button.
    pressing: u64,
    conflict_steps: u64,
    random: Random,
}

impl Process for Junction {
    fn step(&mut self, commands: &[u8], _hands: &[u8]) {
        self.lamps = commands[0];
        let lit = |bit| is_set(commands, 0, bit);
        let greens = [lit(2), lit(5), lit(7)];
        // Pedestrians cross the main road, beside the side road.
        self.conflict_steps += u64::from(greens[MAIN] && (greens[SIDE] || greens[WALK]));
        self.pressing = self.pressing.saturating_sub(1);
        for (index, stream) in self.streams.iter_mut().enumerate() {
            stream.until_next = stream.until_next.saturating_sub(1);
            if stream.until_next == 0 && stream.gap_s > 0.0 {
                stream.until_next = self.random.gap(stream.gap_s).max(1);
                stream.waiting = (stream.waiting + 1).min(QUEUE_MAX);
                if index == WALK {
                    self.pressing = PRESS;
                }
            }
            stream.until_start = stream.until_start.saturating_sub(1);
            stream.crossing = stream.crossing.saturating_sub(1);
            let may_go = greens[index] && !(index < WALK && lit(index as u8 * 3));
            if may_go && stream.waiting > 0 && stream.until_start == 0 {
                let going = if index == WALK { stream.waiting } else { 1 };
                stream.waiting -= going;
                stream.passed += u64::from(going);
                stream.until_start = if index == WALK { 0 } else { HEADWAY };
                stream.crossing = CROSSING[index];
            }
        }
    }
    fn sense(&self, into: &mut [u8]) {
        let lit = |bit: u8| self.lamps >> bit & 1 != 0;
        let waits = |index: usize| self.streams[index].waiting > 0;
        put_bits(&mut into[0], &[(0, waits(MAIN)), (1, waits(SIDE)), (2, self.pressing > 0), (4, lit(0)), (5, lit(3))]);
    }
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        let across = |index: usize| match self.streams[index].crossing {
            0 => 0.0,
            left => 100.0 - left as f64 / CROSSING[index] as f64 * 100.0,
        };
        vec![
            ("main_queue", f64::from(self.streams[MAIN].waiting), ""),
            ("side_queue", f64::from(self.streams[SIDE].waiting), ""),
            ("walkers", f64::from(self.streams[WALK].waiting), ""),
            ("main_passed", self.streams[MAIN].passed as f64, ""),
            ("side_passed", self.streams[SIDE].passed as f64, ""),
            ("walk_passed", self.streams[WALK].passed as f64, ""),
            // How far those who started last have come; 0 if they are across.
            ("main_crossing", across(MAIN), "%"),
            ("side_crossing", across(SIDE), "%"),
            ("walk_crossing", across(WALK), "%"),
            ("conflict", self.conflict_steps as f64 * STEP_US as f64 / 1e6, "s"),
        ]
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
}
