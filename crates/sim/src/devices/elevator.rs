//! An elevator with four floors, a door, buttons on the floors and in the car.

use super::{
    Kind, Process, STEP_US, actuator, button, closed_switch, commanded, is_set, measured, parameter, put_bits, put_word, sensor, switch,
};

/// The row of the elevator in the table of kinds.
pub(super) const KIND: Kind = Kind {
    name: "elevator",
    about: "An elevator with four floors, a motor for both directions with two speeds, a door, and buttons on the floors and in the car.",
    behaviour: "With `up` or `down` alone the car moves with `speed`, without `fast` with a third of it; with none or both the brake holds it at once. It cannot leave the shaft: 30 cm beyond the outer floors it hits the buffer. \
                The switch of a floor is 1 while the car is within 2 cm of it, the switch for slowing down within 40 cm of any floor. \
                The limit switch opens 10 cm beyond the outer floors. The door opens and shuts in `door_time` while it is told to; something in the light barrier stops it from shutting.",
    input_bytes: 6,
    output_bytes: 4,
    signals: &[
        sensor("floor_1", 0, 0, "the car is at floor 1"),
        sensor("floor_2", 0, 1, "the car is at floor 2"),
        sensor("floor_3", 0, 2, "the car is at floor 3"),
        sensor("floor_4", 0, 3, "the car is at floor 4"),
        sensor("near_floor", 0, 4, "the car is within 40 cm of a floor"),
        sensor("limit", 0, 5, "limit switch, normally closed: 0 beyond the outer floors"),
        sensor("door_open", 0, 6, "the door is open"),
        sensor("door_shut", 0, 7, "the door is shut"),
        button("call_1", 1, 0, "button on floor 1"),
        button("call_2", 1, 1, "button on floor 2"),
        button("call_3", 1, 2, "button on floor 3"),
        button("call_4", 1, 3, "button on floor 4"),
        button("car_1", 1, 4, "button in the car for floor 1"),
        button("car_2", 1, 5, "button in the car for floor 2"),
        button("car_3", 1, 6, "button in the car for floor 3"),
        button("car_4", 1, 7, "button in the car for floor 4"),
        closed_switch("emergency", 2, 0, "emergency stop in the car, normally closed: 0 while pressed"),
        switch("barrier", 2, 1, "light barrier of the door, 1 = something is in it"),
        measured("position", 4, "mm", 1.0, "height above floor 1 in millimetres"),
        actuator("up", 0, 0, "motor upwards"),
        actuator("down", 0, 1, "motor downwards"),
        actuator("fast", 0, 2, "full speed"),
        actuator("opening", 0, 3, "the door opens"),
        actuator("shutting", 0, 4, "the door shuts"),
        actuator("lamp_1", 1, 0, "lamp: floor 1 is called"),
        actuator("lamp_2", 1, 1, "lamp: floor 2 is called"),
        actuator("lamp_3", 1, 2, "lamp: floor 3 is called"),
        actuator("lamp_4", 1, 3, "lamp: floor 4 is called"),
        actuator("alarm", 1, 4, "alarm lamp"),
        commanded("display", 2, "BCD", 1.0, "display of the floor in the car"),
    ],
    parameters: &[
        parameter("height", 3.0, (1.0, 7.0), "m", "from one floor to the next"),
        parameter("speed", 1.0, (0.05, 4.0), "m/s", "full speed"),
        parameter("door_time", 2.0, (0.1, 20.0), "s", "how long the door takes to open or shut"),
        parameter("floor", 1.0, (1.0, 4.0), "", "where the car is at the beginning"),
    ],
    arrange: None,
    shown: &[],
    make: |values, _seed| {
        Box::new(Elevator {
            height: values[0],
            speed: values[1],
            door_time: values[2],
            position: values[0] * (values[3].round() - 1.0),
            door: 0.0,
            travelled: 0.0,
            open_travel: 0.0,
            buffer_hits: 0,
            at_buffer: false,
        })
    },
};

const DT: f64 = STEP_US as f64 / 1e6;
/// Floors of the house.
const FLOORS: u8 = 4;
/// How far from a floor its switch is still closed, in metres.
const AT: f64 = 0.02;
const NEAR: f64 = 0.4;
const LIMIT: f64 = 0.1;
const BUFFER: f64 = 0.3;
/// A little more than the rounding of a sum of steps.
const ROUNDING: f64 = 1e-9;

#[derive(Clone)]
struct Elevator {
    height: f64,
    speed: f64,
    door_time: f64,
    /// Metres above floor 1.
    position: f64,
    /// 0 shut to 1 open.
    door: f64,
    travelled: f64,
    /// Metres travelled with a door that was not shut: nobody wants to see more than 0.
    open_travel: f64,
    buffer_hits: u32,
    at_buffer: bool,
}

impl Elevator {
    fn distance(&self, floor: u8) -> f64 {
        (self.position - self.height * f64::from(floor)).abs()
    }
    fn top(&self) -> f64 {
        self.height * f64::from(FLOORS - 1)
    }
}

impl Process for Elevator {
    fn step(&mut self, commands: &[u8], hands: &[u8]) {
        let command = |bit| is_set(commands, 0, bit);
        let speed = if command(2) { self.speed } else { self.speed / 3.0 };
        let way = speed * DT * (f64::from(u8::from(command(0))) - f64::from(u8::from(command(1))));
        let position = (self.position + way).clamp(-BUFFER, self.top() + BUFFER);
        let moved = (position - self.position).abs();
        self.travelled += moved;
        if self.door > ROUNDING {
            self.open_travel += moved;
        }
        self.position = position;
        let at_buffer = position <= -BUFFER || position >= self.top() + BUFFER;
        self.buffer_hits = self.buffer_hits.saturating_add(u32::from(at_buffer && !self.at_buffer));
        self.at_buffer = at_buffer;
        let change = DT / self.door_time;
        match (command(3), command(4)) {
            (true, false) => self.door = (self.door + change).min(1.0),
            (false, true) if !is_set(hands, 2, 1) => self.door = (self.door - change).max(0.0),
            _ => {}
        }
    }
    fn sense(&self, into: &mut [u8]) {
        for floor in 0..FLOORS {
            put_bits(&mut into[0], &[(floor, self.distance(floor) <= AT)]);
        }
        let near = (0..FLOORS).any(|floor| self.distance(floor) <= NEAR);
        let inside = (-LIMIT..=self.top() + LIMIT).contains(&self.position);
        put_bits(&mut into[0], &[(4, near), (5, inside), (6, self.door >= 1.0 - ROUNDING), (7, self.door <= ROUNDING)]);
        put_word(into, 4, self.position * 1000.0);
    }
    fn state(&self) -> Vec<(&'static str, f64, &'static str)> {
        vec![
            ("position", self.position, "m"),
            ("door", self.door * 100.0, "%"),
            ("travelled", self.travelled, "m"),
            ("open_travel", self.open_travel, "m"),
            ("buffer_hits", f64::from(self.buffer_hits), ""),
        ]
    }
    fn copy(&self) -> Box<dyn Process> {
        Box::new(self.clone())
    }
}
