//! SFC 66 X_RCV: receives what a partner on the MPI network has sent. Nobody sends.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::{Answer, NO_JOB};
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(66, "X_RCV", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("EN_DT", DataType::Bool),
    ret_val(),
    output("REQ_ID", DataType::DoubleWord),
    output("NDA", DataType::Bool),
    output("RD", DataType::Any),
];

fn run(call: &mut Call<'_, '_>) -> Answer {
    if call.input(0, Width::Bit)? == 1 {
        call.any(4, true)?;
    }
    // The queue is empty, whether data are asked for or only asked about.
    call.output(3, Width::Bit, 0)?;
    Ok(NO_JOB)
}
