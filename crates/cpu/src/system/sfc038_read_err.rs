//! SFC 38 READ_ERR: reads and clears which masked errors happened.

use sieben_model::types::DataType;

use super::error_masks::left_over;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(38, "READ_ERR", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("PRGFLT_QUERY", DataType::DoubleWord),
    input("ACCFLT_QUERY", DataType::DoubleWord),
    ret_val(),
    output("PRGFLT_ESR", DataType::DoubleWord),
    output("ACCFLT_ESR", DataType::DoubleWord),
];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let wanted = call.filters()?;
    let class = call.host.system.class(call.machine);
    let happened = [class.happened[0] & wanted[0], class.happened[1] & wanted[1]];
    for (register, wanted) in class.happened.iter_mut().zip(wanted) {
        *register &= !wanted;
    }
    let masked = class.masked;
    call.filter_results(happened)?;
    // Some are not masked.
    Ok(left_over([wanted[0] & !masked[0], wanted[1] & !masked[1]]))
}
