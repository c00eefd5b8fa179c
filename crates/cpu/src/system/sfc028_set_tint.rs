//! SFC 28 SET_TINT: sets when a time-of-day interrupt comes.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use crate::clock::DateAndTime;
use crate::interrupts::{Period, Refusal};

use super::interrupt_blocks::{PAST, TIMES_OF_DAY};
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(28, "SET_TINT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] =
    &[input("OB_NR", DataType::Int), input("SDT", DataType::DateAndTime), input("PERIOD", DataType::Word), ret_val()];

const BAD_START: u16 = 0x8091;
const BAD_PERIOD: u16 = 0x8092;

/// The last day that every month has.
const DAY_OF_EVERY_MONTH: u8 = 28;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let number = call.interrupt_block(TIMES_OF_DAY)?;
    let start = DateAndTime::from_bcd(call.complex_input::<8>(1)?).map_err(|_| BAD_START)?;
    let period = Period::from_code(call.input(2, Width::Word)? as u16).ok_or(BAD_PERIOD)?;
    if period == Period::Month && start.day() > DAY_OF_EVERY_MONTH {
        return Err(BAD_START);
    }
    call.host.read_time(call.machine);
    let now = call.host.date_and_time();
    match call.host.interrupts.times_of_day.set(number, start, period, now) {
        Err(Refusal::Past) => Err(PAST),
        Err(Refusal::NotSet) | Ok(()) => Ok(0),
    }
}
