//! SFC 3 CTRL_RTM: starts or stops a run-time meter.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(3, "CTRL_RTM", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("NR", DataType::Byte), input("S", DataType::Bool), ret_val()];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let start = call.input(1, Width::Bit)? == 1;
    let (meter, now) = call.meter()?;
    meter.stop(now);
    meter.since_us = start.then_some(now);
    Ok(0)
}
