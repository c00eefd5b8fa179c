//! SFC 31 QRY_TINT: how a time-of-day interrupt stands.

use sieben_model::types::DataType;

use super::interrupt_blocks::TIMES_OF_DAY;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(31, "QRY_TINT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("OB_NR", DataType::Int), ret_val(), output("STATUS", DataType::Word)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let number = call.interrupt_block(TIMES_OF_DAY)?;
    let active = call.host.interrupts.times_of_day.is_active(number);
    call.interrupt_status(number, active)
}
