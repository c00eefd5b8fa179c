//! SFB 41 CONT_C: a PID controller with a continuous output.

use sieben_model::types::DataType;

use super::controller::{Inputs, to_periphery};
use super::instance::Instance;
use super::{Call, Initial, Parameter, Row, input, output, preset, sfb, stored};

pub(super) const ROW: Row = sfb(41, "CONT_C", VARIABLES, run);

const VARIABLES: &[Parameter] = &[
    input("COM_RST", DataType::Bool),
    preset("MAN_ON", DataType::Bool, Initial::True),
    input("PVPER_ON", DataType::Bool),
    preset("P_SEL", DataType::Bool, Initial::True),
    preset("I_SEL", DataType::Bool, Initial::True),
    input("INT_HOLD", DataType::Bool),
    input("I_ITL_ON", DataType::Bool),
    input("D_SEL", DataType::Bool),
    preset("CYCLE", DataType::Time, Initial::Time(1000)),
    input("SP_INT", DataType::Real),
    input("PV_IN", DataType::Real),
    input("PV_PER", DataType::Word),
    input("MAN", DataType::Real),
    preset("GAIN", DataType::Real, Initial::Real(2.0)),
    preset("TI", DataType::Time, Initial::Time(20_000)),
    preset("TD", DataType::Time, Initial::Time(10_000)),
    preset("TM_LAG", DataType::Time, Initial::Time(2000)),
    input("DEADB_W", DataType::Real),
    preset("LMN_HLM", DataType::Real, Initial::Real(100.0)),
    input("LMN_LLM", DataType::Real),
    preset("PV_FAC", DataType::Real, Initial::Real(1.0)),
    input("PV_OFF", DataType::Real),
    preset("LMN_FAC", DataType::Real, Initial::Real(1.0)),
    input("LMN_OFF", DataType::Real),
    input("I_ITLVAL", DataType::Real),
    input("DISV", DataType::Real),
    output("LMN", DataType::Real),
    output("LMN_PER", DataType::Word),
    output("QLMN_HLM", DataType::Bool),
    output("QLMN_LLM", DataType::Bool),
    output("LMN_P", DataType::Real),
    output("LMN_I", DataType::Real),
    output("LMN_D", DataType::Real),
    output("PV", DataType::Real),
    output("ER", DataType::Real),
    stored("sInvAlt", DataType::Real),
    stored("sIanteilAlt", DataType::Real),
    stored("sRestInt", DataType::Real),
    stored("sRestDif", DataType::Real),
    stored("sRueck", DataType::Real),
    stored("sLmn", DataType::Real),
    stored("sbArwHLmOn", DataType::Bool),
    stored("sbArwLLmOn", DataType::Bool),
];

/// Bits of byte 0.
const COM_RST: u8 = 0;
const MAN_ON: u8 = 1;
const PVPER_ON: u8 = 2;
const P_SEL: u8 = 3;
const I_SEL: u8 = 4;
const INT_HOLD: u8 = 5;
const I_ITL_ON: u8 = 6;
const D_SEL: u8 = 7;
/// Bytes of the other variables.
const CYCLE: usize = 2;
const MAN: usize = 16;
const GAIN: usize = 20;
const TI: usize = 24;
const TD: usize = 28;
const TM_LAG: usize = 32;
const LMN_HLM: usize = 40;
const LMN_LLM: usize = 44;
const LMN_FAC: usize = 56;
const LMN_OFF: usize = 60;
const I_ITLVAL: usize = 64;
const DISV: usize = 68;
const LMN: usize = 72;
const LMN_PER: usize = 76;
const LIMITED: usize = 78;
const LMN_P: usize = 80;
const LMN_I: usize = 84;
const LMN_D: usize = 88;
const PV: usize = 92;
const ER: usize = 96;
const PRODUCT_BEFORE: usize = 100;
const INTEGRAL_BEFORE: usize = 104;
const INTEGRAL_REST: usize = 108;
const DERIVATIVE_REST: usize = 112;
const FEEDBACK: usize = 116;
const MANIPULATED_BEFORE: usize = 120;
const WINDUP: usize = 124;
const BYTES: u32 = 126;

const INPUTS: Inputs = Inputs { periphery: PVPER_ON, setpoint: 6, value: 10, value_periphery: 14, factor: 48, offset: 52, dead_band: 36 };

fn run(call: &mut Call<'_, '_>) -> bool {
    let Some(mut instance) = Instance::open(call.machine, BYTES) else { return false };
    if instance.bit(0, COM_RST) {
        restart(&mut instance);
    } else {
        control(&mut instance);
    }
    true
}

/// A complete restart: the integral action begins with I_ITLVAL, every output with 0.
fn restart(instance: &mut Instance<'_>) {
    for real in [LMN, LMN_P, LMN_D, PV, ER, PRODUCT_BEFORE, INTEGRAL_REST, DERIVATIVE_REST, FEEDBACK, MANIPULATED_BEFORE] {
        instance.set_real(real, 0.0);
    }
    instance.set_word(LMN_PER, 0);
    instance.set_byte(LIMITED, 0);
    instance.set_byte(WINDUP, 0);
    let initial = instance.real(I_ITLVAL);
    instance.set_real(LMN_I, initial);
    instance.set_real(INTEGRAL_BEFORE, initial);
}

fn control(instance: &mut Instance<'_>) {
    let (value, error) = INPUTS.read(instance);
    let manual = instance.bit(0, MAN_ON);
    // Times that the sampling cannot follow are raised to what it can.
    let cycle = instance.seconds(CYCLE);
    let ti = instance.seconds(TI).max(cycle * 0.5);
    let td = instance.seconds(TD).max(cycle);
    let lag = instance.seconds(TM_LAG).max(cycle * 0.5);
    let product = error * instance.real(GAIN);
    let proportional = if instance.bit(0, P_SEL) { product } else { 0.0 };
    let disturbance = instance.real(DISV);

    let mut integral_rest = 0.0;
    let integral = if !instance.bit(0, I_SEL) {
        0.0
    } else if instance.bit(0, I_ITL_ON) {
        instance.real(I_ITLVAL)
    } else if manual {
        // Follows, so that the change to automatic is without a step.
        instance.real(MANIPULATED_BEFORE) - proportional - disturbance
    } else {
        let mut step = cycle / ti * (product + instance.real(PRODUCT_BEFORE)) * 0.5 + instance.real(INTEGRAL_REST);
        let wound_up = step > 0.0 && instance.bit(WINDUP, 0) || step < 0.0 && instance.bit(WINDUP, 1);
        if wound_up || instance.bit(0, INT_HOLD) {
            step = 0.0;
        }
        let before = instance.real(INTEGRAL_BEFORE);
        let integral = before + step;
        // What rounding lost goes into the next step.
        integral_rest = before - integral + step;
        integral
    };

    let derivative = if instance.bit(0, D_SEL) && !manual {
        let feedback = instance.real(FEEDBACK);
        let derivative = (product - feedback) * (td / (cycle * 0.5 + lag));
        let step = derivative * cycle / td + instance.real(DERIVATIVE_REST);
        let next = feedback + step;
        instance.set_real(FEEDBACK, next);
        instance.set_real(DERIVATIVE_REST, feedback - next + step);
        derivative
    } else {
        instance.set_real(FEEDBACK, product);
        instance.set_real(DERIVATIVE_REST, 0.0);
        0.0
    };

    let wanted = if manual { instance.real(MAN) } else { proportional + integral + derivative + disturbance };
    let (high, low) = (instance.real(LMN_HLM), instance.real(LMN_LLM));
    let (limited, at_high, at_low) = if wanted >= high {
        (high, true, false)
    } else if wanted <= low {
        (low, false, true)
    } else {
        (wanted, false, false)
    };
    let manipulated = limited * instance.real(LMN_FAC) + instance.real(LMN_OFF);

    for (byte, value) in [
        (LMN, manipulated),
        (LMN_P, proportional),
        (LMN_I, integral),
        (LMN_D, derivative),
        (PV, value),
        (ER, error),
        (PRODUCT_BEFORE, product),
        (INTEGRAL_BEFORE, integral),
        (INTEGRAL_REST, integral_rest),
        (MANIPULATED_BEFORE, limited),
    ] {
        instance.set_real(byte, value);
    }
    instance.set_int(LMN_PER, to_periphery(manipulated));
    for byte in [LIMITED, WINDUP] {
        instance.set_bit(byte, 0, at_high);
        instance.set_bit(byte, 1, at_low);
    }
}
