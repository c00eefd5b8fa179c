//! SFC 33 CAN_DINT: cancels a time-delay interrupt.

use sieben_model::types::DataType;

use super::interrupt_blocks::{DELAYS, NOT_SET};
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(33, "CAN_DINT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("OB_NR", DataType::Int), ret_val()];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let number = call.interrupt_block(DELAYS)?;
    if call.host.interrupts.delays.cancel(number) { Ok(0) } else { Err(NOT_SET) }
}
