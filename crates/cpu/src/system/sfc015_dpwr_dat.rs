//! SFC 15 DPWR_DAT: writes outputs of a module that belong together.

use sieben_engine::Host;
use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, ret_val, sfc};

pub(super) const ROW: Row = sfc(15, "DPWR_DAT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("LADDR", DataType::Word), input("RECORD", DataType::Any), ret_val()];

/// A module did not take its value.
const ACCESS: u16 = 0x80A1;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let (first, record) = call.record(1, true)?;
    // As it was before: the process image, where outputs show, may be the source.
    let values = call.machine.memory.arena[record].to_vec();
    let mut all = true;
    for (byte, value) in (first..).zip(values) {
        all &= call.host.peripheral_write(call.machine, byte, Width::Byte, u32::from(value));
    }
    if all { Ok(0) } else { Err(ACCESS) }
}
