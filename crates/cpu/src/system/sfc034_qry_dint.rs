//! SFC 34 QRY_DINT: how a time-delay interrupt stands.

use sieben_model::types::DataType;

use super::interrupt_blocks::DELAYS;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(34, "QRY_DINT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("OB_NR", DataType::Int), ret_val(), output("STATUS", DataType::Word)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let number = call.interrupt_block(DELAYS)?;
    let runs = call.host.interrupts.delays.runs(number);
    call.interrupt_status(number, runs)
}
