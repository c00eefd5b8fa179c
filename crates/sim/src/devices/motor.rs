//! A motor behind contactors for star and delta, with feedback, overload relay, current and speed.

use super::{ANALOG_MAX, Kind, Process, STEP_US, actuator, button, is_set, measured, parameter, put_bits, put_word, sensor};

/// The row of the motor in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "motor",
    about: "A three-phase motor behind a line, a star and a delta contactor, with auxiliary contacts, overload relay, current and speed.",
    behaviour: "A contactor closes 20 ms after its command and opens 15 ms after the end of it. With the speed n from 0 to 1, the strength s of 3 in delta, 1 in star and else 0, and the load m as a part of 1: \
                2 · `run_up` · dn/dt = 2 · s · (1 − n) − m · n² − b, where b is 0.6 · n while nothing drives it, and m too where m is above 1, so that it does not start in star. \
                The current is 7 times rated at rest in delta, a third of it in star, and falls with the speed. The overload relay heats up with the square of the current and trips after `trip` seconds at 6 times rated; \
                it closes again with `reset` when it has cooled to a third. Star and delta closed together under voltage are a short circuit: the fuse blows at once.",
    input_bytes: 6,
    output_bytes: 1,
    signals: &[
        sensor("line_on", 0, 0, "auxiliary contact of the line contactor, 1 = closed"),
        sensor("star_on", 0, 1, "auxiliary contact of the star contactor, 1 = closed"),
        sensor("delta_on", 0, 2, "auxiliary contact of the delta contactor, 1 = closed"),
        sensor("overload", 0, 3, "overload relay, normally closed: 0 = tripped"),
        sensor("turning", 0, 4, "speed monitor, 1 above 80 % of the speed"),
        button("reset", 0, 5, "reset button of the overload relay"),
        measured("current", 2, "%", ANALOG_MAX / 1000.0, "current, 0 to 27648 for 0 to 10 times rated"),
        measured("speed", 4, "%", ANALOG_MAX / 100.0, "speed, 0 to 27648 for 0 to 100 %"),
        actuator("line", 0, 0, "line contactor K1"),
        actuator("star", 0, 1, "star contactor K3"),
        actuator("delta", 0, 2, "delta contactor K2"),
    ],
    parameters: &[
        parameter("run_up", 2.0, (0.1, 60.0), "s", "how long a run-up in delta takes without load, about"),
        parameter("load", 40.0, (0.0, 300.0), "%", "torque of the load at full speed"),
        parameter("trip", 10.0, (0.5, 600.0), "s", "after it the overload relay trips at 6 times the rated current"),
    ],
    arrange: None,
    shown: &[],
    make: |values, _seed| {
        Box::new(Motor {
            run_up: values[0],
            load: values[1] / 100.0,
            trip: values[2],
            contactors: [Contactor::default(); 3],
            speed: 0.0,
            current: 0.0,
            heat: 0.0,
            tripped: false,
            fuse_blown: false,
            starts: 0,
        })
    },
};

const DT: f64 = STEP_US as f64 / 1e6;
/// Steps until a contactor has closed or opened.
const CLOSES: u32 = (20_000 / STEP_US) as u32;
const OPENS: u32 = (15_000 / STEP_US) as u32;
/// The line contactor among the contactors.
const LINE: usize = 0;

#[derive(Clone, Copy, Default)]
struct Contactor {
    closed: bool,
    /// Steps since the command differs from the state.
    moving: u32,
}

impl Contactor {
    fn step(&mut self, command: bool) {
        self.moving = if command == self.closed { 0 } else { self.moving + 1 };
        if self.moving >= if command { CLOSES } else { OPENS } {
            self.closed = command;
            self.moving = 0;
        }
    }
}

#[derive(Clone)]
struct Motor {
    run_up: f64,
    load: f64,
    trip: f64,
    contactors: [Contactor; 3],
    /// 0 to 1.
    speed: f64,
    /// In units of the rated current.
    current: f64,
    /// Of the overload relay; it trips at 1.
    heat: f64,
    tripped: bool,
    fuse_blown: bool,
    starts: u32,
}

impl Process for Motor {
    fn step(&mut self, commands: &[u8], hands: &[u8]) {
        let before = self.contactors[LINE].closed;
        for (index, contactor) in self.contactors.iter_mut().enumerate() {
            contactor.step(is_set(commands, 0, index as u8));
        }
        let [line, star, delta] = self.contactors.map(|contactor| contactor.closed);
        self.starts = self.starts.saturating_add(u32::from(line && !before));
        self.fuse_blown |= line && star && delta;
        let voltage = line && !self.fuse_blown;
        let strength = if voltage && delta {
            3.0
        } else if voltage && star {
            1.0
        } else {
            0.0
        };
        let torque =
            strength * (1.0 - self.speed) * 2.0 - self.load * self.speed * self.speed - if self.load > 1.0 { self.load } else { 0.0 };
        // Friction stops it when nothing drives it.
        let friction = if strength == 0.0 { 0.6 * self.speed } else { 0.0 };
        self.speed = (self.speed + (torque - friction) * DT / (2.0 * self.run_up)).clamp(0.0, 1.0);
        self.current =
            strength / 3.0 * (0.3 + 6.7 * (1.0 - self.speed)) + if strength > 0.0 { self.load * self.speed / strength.sqrt() } else { 0.0 };
        self.heat += (self.current * self.current / 36.0 - 0.2 * self.heat) * DT / self.trip;
        self.tripped |= self.heat >= 1.0;
        if is_set(hands, 0, 5) && self.heat < 0.34 {
            self.tripped = false;
        }
    }
    fn sense(&self, into: &mut [u8]) {
        let [line, star, delta] = self.contactors.map(|contactor| contactor.closed);
        put_bits(&mut into[0], &[(0, line), (1, star), (2, delta), (3, !self.tripped), (4, self.speed > 0.8)]);
        put_word(into, 2, self.current.clamp(0.0, 10.0) * ANALOG_MAX / 10.0);
        put_word(into, 4, self.speed * ANALOG_MAX);
    }
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        vec![
            ("speed", self.speed * 100.0, "%"),
            ("current", self.current * 100.0, "%"),
            ("heat", self.heat * 100.0, "%"),
            ("fuse_blown", f64::from(u8::from(self.fuse_blown)), ""),
            ("starts", f64::from(self.starts), ""),
        ]
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
}
