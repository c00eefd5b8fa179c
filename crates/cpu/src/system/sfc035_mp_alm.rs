//! SFC 35 MP_ALM: a multicomputing interrupt on all CPUs of the rack. This one is alone in its rack: OB 60 starts here.
//! That it does, and the meaning of the two specific codes, is from memory of the manual (uncertain).

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};
use crate::interrupts::Interrupt;

pub(super) const ROW: Row = sfc(35, "MP_ALM", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("JOB", DataType::Byte), ret_val()];

const BAD_JOB: u16 = 0x8090;
/// OB 60 of the last call has not ended.
const STILL_RUNNING: u16 = 0x80A0;
/// STARTUP, or a CPU type without OB 60.
const WRONG_MODE: u16 = 0x80A1;

/// Jobs that a program may tell OB 60.
const JOBS: std::ops::RangeInclusive<u32> = 1..=15;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let job = call.input(0, Width::Byte)?;
    if !JOBS.contains(&job) {
        return Err(BAD_JOB);
    }
    let interrupts = &call.host.interrupts;
    if interrupts.in_startup() || !call.host.cpu_type.has_organization_block(60) {
        return Err(WRONG_MODE);
    }
    if interrupts.is_busy(60, call.machine) {
        return Err(STILL_RUNNING);
    }
    call.host.raise(call.machine, Interrupt::multicomputing(job as u8).start_information());
    Ok(0)
}
