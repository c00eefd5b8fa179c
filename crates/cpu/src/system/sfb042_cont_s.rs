//! SFB 42 CONT_S: a step controller for a motor-driven valve, without position feedback.

use sieben_model::types::DataType;

use super::controller::Inputs;
use super::instance::Instance;
use super::{Call, Initial, Parameter, Row, input, output, preset, sfb, stored, stored_preset};

pub(super) const ROW: Row = sfb(42, "CONT_S", VARIABLES, run);

const VARIABLES: &[Parameter] = &[
    input("COM_RST", DataType::Bool),
    input("LMNR_HS", DataType::Bool),
    input("LMNR_LS", DataType::Bool),
    preset("LMNS_ON", DataType::Bool, Initial::True),
    input("LMNUP", DataType::Bool),
    input("LMNDN", DataType::Bool),
    input("PVPER_ON", DataType::Bool),
    preset("CYCLE", DataType::Time, Initial::Time(1000)),
    input("SP_INT", DataType::Real),
    input("PV_IN", DataType::Real),
    input("PV_PER", DataType::Word),
    preset("GAIN", DataType::Real, Initial::Real(2.0)),
    preset("TI", DataType::Time, Initial::Time(20_000)),
    preset("DEADB_W", DataType::Real, Initial::Real(1.0)),
    preset("PV_FAC", DataType::Real, Initial::Real(1.0)),
    input("PV_OFF", DataType::Real),
    preset("PULSE_TM", DataType::Time, Initial::Time(3000)),
    preset("BREAK_TM", DataType::Time, Initial::Time(3000)),
    preset("MTR_TM", DataType::Time, Initial::Time(30_000)),
    input("DISV", DataType::Real),
    output("QLMNUP", DataType::Bool),
    output("QLMNDN", DataType::Bool),
    output("PV", DataType::Real),
    output("ER", DataType::Real),
    stored("sInt", DataType::Real),
    stored_preset("sSince", DataType::Time, Initial::Time(i32::MAX)),
];

/// Bits of byte 0.
const COM_RST: u8 = 0;
const LMNR_HS: u8 = 1;
const LMNR_LS: u8 = 2;
const LMNS_ON: u8 = 3;
const LMNUP: u8 = 4;
const LMNDN: u8 = 5;
const PVPER_ON: u8 = 6;
/// Bytes of the other variables.
const CYCLE: usize = 2;
const GAIN: usize = 16;
const TI: usize = 20;
const PULSE_TM: usize = 36;
const BREAK_TM: usize = 40;
const MTR_TM: usize = 44;
const DISV: usize = 48;
const OUTPUTS: usize = 52;
const PV: usize = 54;
const ER: usize = 58;
/// Integral action and assumed position of the valve, in one integrator.
const INTEGRATOR: usize = 62;
/// Milliseconds since an output changed.
const SINCE: usize = 66;
const BYTES: u32 = 70;

const INPUTS: Inputs = Inputs { periphery: PVPER_ON, setpoint: 6, value: 10, value_periphery: 14, factor: 28, offset: 32, dead_band: 24 };

/// A pulse is worth its movement only if more than half of it is wanted; the rest keeps the valve from moving to and fro.
const ON_SHARE: f32 = 0.55;
/// The motor stops when less than half of the movement of one cycle is left.
const OFF_SHARE: f32 = 0.5;

/// Which way the motor runs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Motor {
    Stands,
    Up,
    Down,
}

fn run(call: &mut Call<'_, '_>) -> bool {
    let Some(mut instance) = Instance::open(call.machine, BYTES) else { return false };
    let motor = if instance.bit(0, COM_RST) {
        for real in [PV, ER, INTEGRATOR] {
            instance.set_real(real, 0.0);
        }
        instance.set_time(SINCE, i32::MAX);
        Motor::Stands
    } else {
        control(&mut instance)
    };
    instance.set_bit(OUTPUTS, 0, motor == Motor::Up);
    instance.set_bit(OUTPUTS, 1, motor == Motor::Down);
    true
}

fn control(instance: &mut Instance<'_>) -> Motor {
    let (value, error) = INPUTS.read(instance);
    instance.set_real(PV, value);
    instance.set_real(ER, error);
    let before = match (instance.bit(OUTPUTS, 0), instance.bit(OUTPUTS, 1)) {
        (true, _) => Motor::Up,
        (_, true) => Motor::Down,
        _ => Motor::Stands,
    };
    let cycle_ms = instance.time(CYCLE).max(1);
    let since = instance.time(SINCE).saturating_add(cycle_ms);
    let wanted = instance.real(GAIN) * error + instance.real(DISV);
    let (motor, integrator) = if instance.bit(0, LMNS_ON) {
        let motor = match (instance.bit(0, LMNUP), instance.bit(0, LMNDN)) {
            (true, false) => Motor::Up,
            (false, true) => Motor::Down,
            _ => Motor::Stands,
        };
        // Follows, so that the change to automatic is without a step.
        (motor, -wanted)
    } else {
        automatic(instance, before, since, error, wanted)
    };
    // The end of travel stops the motor at once, whatever pulse is running.
    let motor = if instance.bit(0, LMNR_HS) && motor == Motor::Up || instance.bit(0, LMNR_LS) && motor == Motor::Down {
        Motor::Stands
    } else {
        motor
    };
    instance.set_real(INTEGRATOR, integrator);
    instance.set_time(SINCE, if motor == before { since } else { 0 });
    motor
}

/// The motor and the integrator in automatic mode.
fn automatic(instance: &Instance<'_>, before: Motor, since: i32, error: f32, wanted: f32) -> (Motor, f32) {
    let cycle = instance.time(CYCLE).max(1) as f32 / 1000.0;
    let ti = instance.seconds(TI).max(cycle * 0.5);
    // Percent of the travel in one cycle.
    let travel = 100.0 * cycle / instance.seconds(MTR_TM).max(cycle);
    let mut step = cycle / ti * instance.real(GAIN) * error;
    if step > 0.0 && instance.bit(0, LMNR_HS) || step < 0.0 && instance.bit(0, LMNR_LS) {
        step = 0.0;
    }
    let moved = match before {
        Motor::Up => travel,
        Motor::Down => -travel,
        Motor::Stands => 0.0,
    };
    let integrator = instance.real(INTEGRATOR) + step - moved;
    let difference = wanted + integrator;

    let pulse = instance.time(PULSE_TM);
    let pulse_cycles = (instance.seconds(PULSE_TM) / cycle).max(1.0);
    let on = ON_SHARE * travel * pulse_cycles;
    let off = OFF_SHARE * travel;
    let motor = match before {
        Motor::Up if difference > off || since < pulse => Motor::Up,
        Motor::Down if difference < -off || since < pulse => Motor::Down,
        Motor::Stands if since < instance.time(BREAK_TM) => Motor::Stands,
        Motor::Stands if difference >= on => Motor::Up,
        Motor::Stands if difference <= -on => Motor::Down,
        _ => Motor::Stands,
    };
    (motor, integrator)
}
