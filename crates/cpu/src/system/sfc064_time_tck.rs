//! SFC 64 TIME_TCK: the system time in milliseconds.

use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, RET_VAL, Row, Run, output, sfc};

pub(super) const ROW: Row = sfc(64, "TIME_TCK", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[output(RET_VAL, DataType::Time)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    call.host.read_time(call.machine);
    let since = call.machine.clock_us.saturating_sub(call.host.system.restarted_us);
    Ok((since / 1000 % (1 << 31)) as u32)
}
