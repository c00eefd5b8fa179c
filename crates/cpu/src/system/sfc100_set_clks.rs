//! SFC 100 SET_CLKS: sets the time of day and what is known about the clock.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use crate::clock::DateAndTime;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};
use crate::system_state::ClockStatus;

pub(super) const ROW: Row = sfc(100, "SET_CLKS", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("MODE", DataType::Byte),
    input("PDT", DataType::DateAndTime),
    input("CORR", DataType::Int),
    input("SUMMER", DataType::Bool),
    input("ANN_1", DataType::Bool),
    ret_val(),
];

const BAD_MODE: u16 = 0x8080;
const BAD_DATE_AND_TIME: u16 = 0x8081;
const BAD_CORRECTION: u16 = 0x8082;

/// MODE: the time, what is known about it, or both.
const TIME: u32 = 1;
const STATUS: u32 = 2;
/// Half hours from the base time that there are: from 12 hours behind to 13 hours before.
const CORRECTIONS: std::ops::RangeInclusive<i16> = -24..=26;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let mode = call.input(0, Width::Byte)?;
    if !(TIME..=TIME | STATUS).contains(&mode) {
        return Err(BAD_MODE);
    }
    let wanted =
        if mode & TIME == 0 { None } else { Some(DateAndTime::from_bcd(call.complex_input::<8>(1)?).map_err(|_| BAD_DATE_AND_TIME)?) };
    if mode & STATUS != 0 {
        let correction = call.input(2, Width::Word)? as u16 as i16;
        if !CORRECTIONS.contains(&correction) {
            return Err(BAD_CORRECTION);
        }
        let (summer, announced) = (call.input(3, Width::Bit)? == 1, call.input(4, Width::Bit)? == 1);
        call.host.system.clock = ClockStatus { correction: correction as i8, summer, announced };
    }
    if let Some(wanted) = wanted {
        call.host.read_time(call.machine);
        call.host.set_date_and_time(wanted);
    }
    Ok(0)
}
