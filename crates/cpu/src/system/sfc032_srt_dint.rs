//! SFC 32 SRT_DINT: starts a time-delay interrupt.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::interrupt_blocks::DELAYS;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(32, "SRT_DINT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("OB_NR", DataType::Int), input("DTIME", DataType::Time), input("SIGN", DataType::Word), ret_val()];

const BAD_DELAY: u16 = 0x8091;

/// Delays in milliseconds.
const DELAY_MS: std::ops::RangeInclusive<u32> = 1..=60_000;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let number = call.interrupt_block(DELAYS)?;
    let delay = call.input(1, Width::DoubleWord)?;
    if !DELAY_MS.contains(&delay) {
        return Err(BAD_DELAY);
    }
    let sign = call.input(2, Width::Word)? as u16;
    call.host.read_time(call.machine);
    call.host.interrupts.delays.start(number, call.machine.clock_us, delay, sign);
    Ok(0)
}
