//! SFC 14 DPRD_DAT: reads inputs of a module that belong together.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(14, "DPRD_DAT", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("LADDR", DataType::Word), ret_val(), output("RECORD", DataType::Any)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let (first, record) = call.record(2, false)?;
    for (byte, at) in (first..).zip(record.clone()) {
        let value = call.host.rack.read_for_program(byte, Width::Byte).unwrap_or_default();
        call.machine.memory.arena[at] = value as u8;
    }
    call.wrote(record);
    Ok(0)
}
