//! The simulated plants do what their pages say.

use sieben_cpu::IoModule;
use sieben_sim::devices::{Device, DeviceSettings, Kind};

/// A device with some parameters, the others as usual.
fn device(kind: &str, parameters: &[(&str, f64)]) -> Device {
    let kind = Kind::by_name(kind).expect("a kind");
    let mut settings = DeviceSettings::new(kind);
    for (name, value) in parameters {
        let index = kind.parameters.iter().position(|parameter| parameter.name == *name).expect("a parameter");
        settings.parameters[index] = *value;
    }
    Device::new(settings)
}

fn wait(device: &mut Device, ms: u64) {
    device.advance(ms * 1000);
}

fn value(device: &Device, name: &str) -> f64 {
    device.value(name).unwrap_or_else(|| panic!("no value `{name}`"))
}

/// The value of a signal that the CPU reads.
fn signal(device: &Device, name: &str) -> i16 {
    device.settings().kind.signal(name).unwrap_or_else(|| panic!("no signal `{name}`")).raw(&device.input_bytes())
}

#[test]
fn a_tank_fills_evenly_and_empties_ever_more_slowly() {
    let mut tank = device("tank", &[("volume", 100.0), ("inflow", 5.0), ("outflow", 10.0), ("level", 0.0), ("waves", 0.0)]);
    tank.write(0, &[0, 0, 0x36, 0]);
    wait(&mut tank, 10_000);
    // Half of the control valve: 16#3600 of 27648.
    assert!((value(&tank, "level") - 25.0).abs() < 0.1, "{:?}", tank.state());
    assert_eq!((signal(&tank, "low"), signal(&tank, "high"), signal(&tank, "overflow")), (1, 0, 1));
    tank.write(0, &[1, 0, 0, 0]);
    wait(&mut tank, 20_000);
    assert!(value(&tank, "spilled") > 0.0 && (value(&tank, "level") - 100.0).abs() < 1e-9);
    assert_eq!((signal(&tank, "level"), signal(&tank, "high"), signal(&tank, "overflow")), (27_648, 1, 0));
    tank.write(0, &[2, 0, 0, 0]);
    // By Torricelli √h falls evenly: a full tank of 100 l with 10 l/s is empty after 20 s, and has a quarter after 10 s.
    wait(&mut tank, 10_500);
    assert!((value(&tank, "level") - 25.0).abs() < 1.0, "{:?}", tank.state());
    wait(&mut tank, 12_000);
    assert!(value(&tank, "level") < 0.1, "{:?}", tank.state());
}

#[test]
fn a_heated_thing_is_63_per_cent_there_after_dead_time_and_time_constant() {
    let parameters = [("ambient", 20.0), ("gain", 100.0), ("time_constant", 30.0), ("dead_time", 5.0), ("noise", 0.0), ("limit", 110.0)];
    let mut oven = device("thermal", &parameters);
    oven.write(0, &[0, 0, 1, 0]);
    wait(&mut oven, 4_900);
    assert_eq!(signal(&oven, "temperature"), 200, "nothing is seen within the dead time");
    wait(&mut oven, 30_100);
    assert!((i32::from(signal(&oven, "temperature")) - 832).abs() <= 1, "{:?}", oven.state());
    wait(&mut oven, 300_000);
    assert_eq!((signal(&oven, "temperature"), signal(&oven, "thermostat")), (1200, 0));
    oven.write(0, &[0, 0, 0, 0]);
    wait(&mut oven, 300_000);
    assert_eq!((signal(&oven, "temperature"), signal(&oven, "thermostat")), (200, 1));
}

#[test]
fn a_motor_comes_up_in_star_and_delta_and_blows_its_fuse_in_both() {
    let mut motor = device("motor", &[("run_up", 2.0), ("load", 40.0)]);
    motor.write(0, &[0b011]);
    wait(&mut motor, 19);
    assert_eq!(signal(&motor, "line_on"), 0);
    wait(&mut motor, 1);
    assert_eq!((signal(&motor, "line_on"), signal(&motor, "star_on")), (1, 1));
    let star = value(&motor, "current");
    wait(&mut motor, 8_000);
    assert_eq!(signal(&motor, "turning"), 1);
    motor.write(0, &[0b001]);
    wait(&mut motor, 50);
    motor.write(0, &[0b101]);
    wait(&mut motor, 3_000);
    assert!(value(&motor, "speed") > 90.0 && value(&motor, "fuse_blown") == 0.0, "{:?}", motor.state());

    let mut direct = device("motor", &[]);
    direct.write(0, &[0b101]);
    wait(&mut direct, 20);
    assert!((value(&direct, "current") / star - 3.0).abs() < 0.05, "a start in delta takes three times the current");
    direct.write(0, &[0b111]);
    wait(&mut direct, 20);
    assert_eq!(value(&direct, "fuse_blown"), 1.0);
    wait(&mut direct, 10_000);
    assert!(value(&direct, "speed") < 1.0);
}

#[test]
fn a_motor_that_cannot_turn_trips_its_overload_relay_and_is_reset_when_it_is_cool() {
    let mut motor = device("motor", &[("load", 300.0), ("trip", 5.0)]);
    motor.write(0, &[0b101]);
    wait(&mut motor, 20_000);
    assert_eq!(signal(&motor, "overload"), 0);
    motor.write(0, &[0]);
    motor.set_input(0, 0x20, 0x20);
    wait(&mut motor, 1_000);
    assert_eq!(signal(&motor, "overload"), 0, "still hot");
    wait(&mut motor, 120_000);
    assert_eq!(signal(&motor, "overload"), 1);
}

#[test]
fn a_part_travels_with_the_speed_of_the_belt() {
    let mut belt = device("conveyor", &[("length", 2.0), ("speed", 0.5), ("weight", 300.0), ("spread", 0.0)]);
    belt.set_input(0, 0x10, 0x10);
    wait(&mut belt, 10);
    assert_eq!((signal(&belt, "left_end"), signal(&belt, "right_end")), (1, 0));
    belt.write(0, &[0x20]);
    // Two metres, and half of the ramp.
    wait(&mut belt, 4_150);
    assert_eq!((signal(&belt, "left_end"), signal(&belt, "right_end"), signal(&belt, "weight"), signal(&belt, "running")), (0, 1, 300, 1));
    wait(&mut belt, 1_000);
    assert_eq!((value(&belt, "delivered"), signal(&belt, "weight")), (1.0, 0));
    belt.set_input(0, 0x10, 0);
    wait(&mut belt, 10);
    belt.write(0, &[0x60]);
    wait(&mut belt, 1_000);
    assert_eq!((value(&belt, "velocity"), signal(&belt, "running")), (0.0, 0), "both directions are none");
    belt.set_input(0, 0x10, 0x10);
    belt.write(0, &[0x40]);
    wait(&mut belt, 3_000);
    assert_eq!(value(&belt, "dropped"), 1.0);
}

#[test]
fn cars_wait_for_green_and_enemies_are_counted() {
    let mut junction = device("junction", &[("main_gap", 2.0), ("side_gap", 4.0), ("walk_gap", 0.0)]);
    junction.write(0, &[0b0100_1001]);
    wait(&mut junction, 60_000);
    let (main, side) = (value(&junction, "main_queue"), value(&junction, "side_queue"));
    assert!((20.0..=40.0).contains(&main) && (10.0..=20.0).contains(&side), "{:?}", junction.state());
    assert_eq!((signal(&junction, "main_car"), signal(&junction, "main_red_lit"), value(&junction, "main_passed")), (1, 1, 0.0));
    junction.write(0, &[0b0100_1100]);
    wait(&mut junction, 20_000);
    // A car every two seconds.
    assert_eq!((value(&junction, "main_passed"), value(&junction, "conflict")), (10.0, 0.0));
    junction.write(0, &[0b0110_0100]);
    wait(&mut junction, 1_500);
    assert!((value(&junction, "conflict") - 1.5).abs() < 1e-9);
}

#[test]
fn an_elevator_moves_between_its_switches_and_the_door_obeys_the_barrier() {
    let mut lift = device("elevator", &[]);
    assert_eq!((signal(&lift, "floor_1"), signal(&lift, "door_shut"), signal(&lift, "limit"), signal(&lift, "emergency")), (1, 1, 1, 1));
    lift.write(0, &[0b101, 0, 0, 0]);
    wait(&mut lift, 3_000);
    assert_eq!((signal(&lift, "floor_2"), signal(&lift, "position")), (1, 3000));
    lift.write(0, &[0b001, 0, 0, 0]);
    wait(&mut lift, 3_000);
    assert_eq!(signal(&lift, "position"), 4000, "a third of the speed");
    lift.write(0, &[0b110, 0, 0, 0]);
    wait(&mut lift, 10_000);
    assert_eq!((signal(&lift, "position"), signal(&lift, "limit"), value(&lift, "buffer_hits")), (-300, 0, 1.0));
    lift.write(0, &[0b1000, 0, 0, 0]);
    wait(&mut lift, 2_000);
    assert_eq!(signal(&lift, "door_open"), 1);
    lift.write(0, &[0b1_0000, 0, 0, 0]);
    lift.set_input(2, 2, 2);
    wait(&mut lift, 5_000);
    assert_eq!(signal(&lift, "door_open"), 1, "something is in the light barrier");
    lift.set_input(2, 2, 0);
    wait(&mut lift, 2_000);
    assert_eq!((signal(&lift, "door_shut"), value(&lift, "open_travel")), (1, 0.0));
}

#[test]
fn the_dosing_plant_gives_a_pulse_per_litre() {
    let mut plant = device("dosing", &[("flow", 2.0), ("noise", 0.0)]);
    plant.write(0, &[1, 0, 0, 0, 0, 0]);
    let mut pulses = 0;
    let mut last = 0;
    for _ in 0..1_050 {
        wait(&mut plant, 10);
        pulses += u32::from(signal(&plant, "flow") == 1 && last == 0);
        last = signal(&plant, "flow");
    }
    assert_eq!((pulses, value(&plant, "delivered").round()), (21, 21.0));
}
