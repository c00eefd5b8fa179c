//! SFC 37 DMSK_FLT: takes back masks of synchronous errors.

use sieben_model::types::DataType;

use super::error_masks::left_over;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(37, "DMSK_FLT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("PRGFLT_RESET_MASK", DataType::DoubleWord),
    input("ACCFLT_RESET_MASK", DataType::DoubleWord),
    ret_val(),
    output("PRGFLT_MASKED", DataType::DoubleWord),
    output("ACCFLT_MASKED", DataType::DoubleWord),
];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let wanted = call.filters()?;
    let class = call.host.system.class(call.machine);
    let before = class.masked;
    for (masked, wanted) in class.masked.iter_mut().zip(wanted) {
        *masked &= !wanted;
    }
    for (happened, wanted) in class.happened.iter_mut().zip(wanted) {
        *happened &= !wanted;
    }
    let masked = class.masked;
    call.filter_results(masked)?;
    // Some were not masked.
    Ok(left_over([wanted[0] & !before[0], wanted[1] & !before[1]]))
}
