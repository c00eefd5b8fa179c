//! SFC 36 MSK_FLT: masks synchronous errors.

use sieben_model::types::DataType;

use super::error_masks::left_over;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(36, "MSK_FLT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("PRGFLT_SET_MASK", DataType::DoubleWord),
    input("ACCFLT_SET_MASK", DataType::DoubleWord),
    ret_val(),
    output("PRGFLT_MASKED", DataType::DoubleWord),
    output("ACCFLT_MASKED", DataType::DoubleWord),
];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let wanted = call.filters()?;
    let class = call.host.system.class(call.machine);
    let before = class.masked;
    for (masked, wanted) in class.masked.iter_mut().zip(wanted) {
        *masked |= wanted;
    }
    let masked = class.masked;
    call.filter_results(masked)?;
    // Some were masked already.
    Ok(left_over([wanted[0] & before[0], wanted[1] & before[1]]))
}
