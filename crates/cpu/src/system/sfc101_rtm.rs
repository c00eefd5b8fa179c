//! SFC 101 RTM: a run-time meter of 32 bits.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::run_time_meters::HOUR_US;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(101, "RTM", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("NR", DataType::Byte),
    input("MODE", DataType::Byte),
    input("PV", DataType::DoubleInt),
    ret_val(),
    output("CQ", DataType::Bool),
    output("CV", DataType::DoubleInt),
];

const NEGATIVE: u16 = 0x8081;
const OVERFLOW: u16 = 0x8082;
const BAD_MODE: u16 = 0x8091;
/// Greatest value of the meter.
const HOURS_MAX: u64 = i32::MAX as u64;

/// Bit of MODE: the meter begins with PV.
const PRESET: u32 = 4;
/// The rest of MODE: only this, start, stop.
const START: u32 = 1;
const STOP: u32 = 2;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let mode = call.input(1, Width::Byte)?;
    let preset = call.input(2, Width::DoubleWord)?;
    let (meter, now) = call.meter()?;
    if mode > PRESET | STOP || mode & (START | STOP) == START | STOP {
        return Err(BAD_MODE);
    }
    if mode & PRESET != 0 {
        if u64::from(preset) > HOURS_MAX {
            return Err(NEGATIVE);
        }
        meter.shown_us = u64::from(preset) * HOUR_US;
        meter.since_us = meter.since_us.map(|_| now);
    }
    match mode & (START | STOP) {
        START => meter.since_us = meter.since_us.or(Some(now)),
        STOP => meter.stop(now),
        _ => {}
    }
    let hours = meter.now(now) / HOUR_US;
    let over = hours > HOURS_MAX;
    if over {
        meter.stop(now);
    }
    let runs = meter.since_us.is_some();
    call.output(4, Width::Bit, u32::from(runs))?;
    call.output(5, Width::DoubleWord, hours.min(HOURS_MAX) as u32)?;
    if over { Err(OVERFLOW) } else { Ok(0) }
}
