//! SFC 1 READ_CLK: reads the time of day.

use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(1, "READ_CLK", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[ret_val(), output("CDT", DataType::DateAndTime)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    call.host.read_time(call.machine);
    let now = call.host.date_and_time().to_bcd();
    call.complex_output(1, &now)?;
    Ok(0)
}
