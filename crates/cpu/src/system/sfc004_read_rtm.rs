//! SFC 4 READ_RTM: reads a run-time meter.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::run_time_meters::{HOUR_US, HOURS_MAX};
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(4, "READ_RTM", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("NR", DataType::Byte), ret_val(), output("CQ", DataType::Bool), output("CV", DataType::Int)];

const OVERFLOW: u16 = 0x8081;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let (meter, now) = call.meter()?;
    let hours = meter.now(now) / HOUR_US;
    let over = hours > HOURS_MAX;
    if over {
        meter.stop(now);
    }
    let runs = meter.since_us.is_some();
    call.output(2, Width::Bit, u32::from(runs))?;
    call.output(3, Width::Word, hours.min(HOURS_MAX) as u32)?;
    if over { Err(OVERFLOW) } else { Ok(0) }
}
