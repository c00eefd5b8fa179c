//! SFC 29 CAN_TINT: cancels a time-of-day interrupt.

use sieben_model::types::DataType;

use super::interrupt_blocks::TIMES_OF_DAY;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(29, "CAN_TINT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("OB_NR", DataType::Int), ret_val()];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let number = call.interrupt_block(TIMES_OF_DAY)?;
    call.host.interrupts.times_of_day.cancel(number)?;
    Ok(0)
}
