//! SFC 39 DIS_IRT: interrupts and asynchronous errors are lost from now on.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use crate::interrupts::Lock;

use super::interrupt_locks::blocks;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(39, "DIS_IRT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("MODE", DataType::Byte), input("OB_NR", DataType::Int), ret_val()];

/// Added to MODE: what is lost does not even enter the diagnostic buffer.
const SILENTLY: u32 = 0x80;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let mode = call.input(0, Width::Byte)?;
    let blocks = blocks(call, mode & !SILENTLY)?;
    let lock = if mode & SILENTLY == 0 { Lock::Lost } else { Lock::LostSilently };
    call.host.interrupts.lock(blocks, lock);
    Ok(0)
}
