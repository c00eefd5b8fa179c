//! SFC 13 DPNRM_DG: diagnosis of a DP slave. There is no DP master system: no address is that of a slave.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::modules::NO_MODULE;
use super::parameters::{Answer, NO_JOB};
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(13, "DPNRM_DG", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("LADDR", DataType::Word),
    ret_val(),
    output("RECORD", DataType::Any),
    output("BUSY", DataType::Bool),
];

fn run(call: &mut Call<'_, '_>) -> Answer {
    call.output(4, Width::Bit, 0)?;
    if call.input(0, Width::Bit)? == 0 {
        return Ok(NO_JOB);
    }
    call.input(1, Width::Word)?;
    call.byte_area(3, true)?;
    Err(NO_MODULE)
}
