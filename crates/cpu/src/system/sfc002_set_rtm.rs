//! SFC 2 SET_RTM: sets a run-time meter.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::run_time_meters::{HOUR_US, HOURS_MAX};
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(2, "SET_RTM", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("NR", DataType::Byte), input("PV", DataType::Int), ret_val()];

const NEGATIVE: u16 = 0x8081;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let hours = u64::from(call.input(1, Width::Word)?);
    let (meter, now) = call.meter()?;
    if hours > HOURS_MAX {
        return Err(NEGATIVE);
    }
    meter.shown_us = hours * HOUR_US;
    meter.since_us = meter.since_us.map(|_| now);
    Ok(0)
}
