//! SFB 43 PULSEGEN: a manipulated value as pulses of one or two outputs.

use sieben_model::types::DataType;

use super::instance::Instance;
use super::{Call, Initial, Parameter, Row, input, output, preset, sfb, stored};

pub(super) const ROW: Row = sfb(43, "PULSEGEN", VARIABLES, run);

const VARIABLES: &[Parameter] = &[
    input("INV", DataType::Real),
    preset("PER_TM", DataType::Time, Initial::Time(1000)),
    preset("P_B_TM", DataType::Time, Initial::Time(50)),
    preset("RATIOFAC", DataType::Real, Initial::Real(1.0)),
    preset("STEP3_ON", DataType::Bool, Initial::True),
    input("ST2BI_ON", DataType::Bool),
    input("MAN_ON", DataType::Bool),
    input("POS_P_ON", DataType::Bool),
    input("NEG_P_ON", DataType::Bool),
    preset("SYN_ON", DataType::Bool, Initial::True),
    input("COM_RST", DataType::Bool),
    preset("CYCLE", DataType::Time, Initial::Time(10)),
    output("QPOS_P", DataType::Bool),
    output("QNEG_P", DataType::Bool),
    stored("sInvAlt", DataType::Real),
    stored("sElapsed", DataType::Time),
    stored("sPosTime", DataType::Time),
    stored("sNegTime", DataType::Time),
    stored("sRuns", DataType::Bool),
];

const INV: usize = 0;
const PER_TM: usize = 4;
const P_B_TM: usize = 8;
const RATIOFAC: usize = 12;
/// The switches, and their bits; COM_RST is the first bit of the next byte.
const SWITCHES: usize = 16;
const STEP3_ON: u8 = 0;
const ST2BI_ON: u8 = 1;
const MAN_ON: u8 = 2;
const POS_P_ON: u8 = 3;
const NEG_P_ON: u8 = 4;
const SYN_ON: u8 = 5;
const COM_RST: u8 = 6;
const CYCLE: usize = 18;
const OUTPUTS: usize = 22;
const INV_BEFORE: usize = 24;
const ELAPSED: usize = 28;
const POSITIVE_MS: usize = 32;
const NEGATIVE_MS: usize = 36;
/// A period has begun.
const RUNS: usize = 40;
const BYTES: u32 = 42;

fn run(call: &mut Call<'_, '_>) -> bool {
    let Some(mut instance) = Instance::open(call.machine, BYTES) else { return false };
    let (positive, negative) = if instance.bit(SWITCHES, COM_RST) {
        instance.set_bit(RUNS, 0, false);
        (false, false)
    } else if instance.bit(SWITCHES, MAN_ON) {
        instance.set_bit(RUNS, 0, false);
        by_hand(&instance)
    } else {
        pulse(&mut instance)
    };
    instance.set_bit(OUTPUTS, 0, positive);
    instance.set_bit(OUTPUTS, 1, negative);
    true
}

/// The outputs of manual mode: never both; with two steps the negative one is the opposite of the positive one.
fn by_hand(instance: &Instance<'_>) -> (bool, bool) {
    let (positive, negative) = (instance.bit(SWITCHES, POS_P_ON), instance.bit(SWITCHES, NEG_P_ON));
    if instance.bit(SWITCHES, STEP3_ON) { (positive && !negative, negative && !positive) } else { (positive, !positive) }
}

/// The outputs at this point of the period.
fn pulse(instance: &mut Instance<'_>) -> (bool, bool) {
    let period = instance.time(PER_TM).max(1);
    let cycle = instance.time(CYCLE).max(1);
    let inv = instance.real(INV);
    let mut elapsed = instance.time(ELAPSED);
    // A new value begins a new period at once, but not next to the change of periods.
    let changed = inv.to_bits() != instance.real(INV_BEFORE).to_bits();
    let inside = elapsed >= cycle && elapsed < period.saturating_sub(cycle.saturating_mul(2));
    let synchronized = instance.bit(SWITCHES, SYN_ON) && changed && inside;
    if !instance.bit(RUNS, 0) || elapsed < 0 || elapsed >= period || synchronized {
        elapsed = 0;
        let (positive, negative) = durations(instance, inv, period);
        instance.set_time(POSITIVE_MS, positive);
        instance.set_time(NEGATIVE_MS, negative);
        instance.set_bit(RUNS, 0, true);
    }
    instance.set_real(INV_BEFORE, inv);
    instance.set_time(ELAPSED, elapsed.saturating_add(cycle));
    let positive = elapsed < instance.time(POSITIVE_MS);
    let negative = if instance.bit(SWITCHES, STEP3_ON) { elapsed < instance.time(NEGATIVE_MS) } else { !positive };
    (positive, negative)
}

/// How long the positive and the negative pulse of a period last, in milliseconds.
fn durations(instance: &Instance<'_>, inv: f32, period: i32) -> (i32, i32) {
    let whole = |share: f32| {
        // A share outside 0 to 1 is no share; NaN is none at all.
        let wanted = (share.clamp(0.0, 1.0) * period as f32) as i32;
        let shortest = instance.time(P_B_TM);
        if wanted < shortest {
            0
        } else if wanted > period.saturating_sub(shortest) {
            period
        } else {
            wanted
        }
    };
    let share = inv / 100.0;
    if !instance.bit(SWITCHES, STEP3_ON) {
        let share = if instance.bit(SWITCHES, ST2BI_ON) { (share + 1.0) * 0.5 } else { share };
        return (whole(share), 0);
    }
    // A ratio below 1 shortens the negative pulse, one above 1 the positive pulse.
    let ratio = instance.real(RATIOFAC);
    let (positive, negative) = if ratio < 1.0 { (share, -share * ratio) } else { (share / ratio, -share) };
    (whole(positive), whole(negative))
}
