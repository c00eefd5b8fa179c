//! SFC 40 EN_IRT: takes back SFC 39.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use crate::interrupts::Lock;

use super::interrupt_locks::blocks;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(40, "EN_IRT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("MODE", DataType::Byte), input("OB_NR", DataType::Int), ret_val()];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let mode = call.input(0, Width::Byte)?;
    let blocks = blocks(call, mode)?;
    call.host.interrupts.lock(blocks, Lock::Open);
    Ok(0)
}
