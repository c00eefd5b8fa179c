//! SFC 0 SET_CLK: sets the time of day.

use sieben_model::types::DataType;

use crate::clock::{DateAndTime, NoDateAndTime};

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(0, "SET_CLK", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("PDT", DataType::DateAndTime), ret_val()];

const BAD_DATE: u16 = 0x8080;
const BAD_TIME: u16 = 0x8081;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let bytes = call.complex_input::<8>(0)?;
    let wanted = DateAndTime::from_bcd(bytes).map_err(|what| match what {
        NoDateAndTime::Date => BAD_DATE,
        NoDateAndTime::Time => BAD_TIME,
    })?;
    call.host.read_time(call.machine);
    call.host.set_date_and_time(wanted);
    Ok(0)
}
