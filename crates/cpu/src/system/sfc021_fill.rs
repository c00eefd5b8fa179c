//! SFC 21 FILL: fills an area with a pattern.

use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(21, "FILL", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("BVAL", DataType::Any), ret_val(), output("BLK", DataType::Any)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let pattern = call.any(0, false)?;
    let block = call.any(2, true)?;
    // The pattern as it was before: it may lie in the block.
    let pattern = call.machine.memory.arena[pattern].to_vec();
    for (byte, &value) in call.machine.memory.arena[block.clone()].iter_mut().zip(pattern.iter().cycle()) {
        *byte = value;
    }
    call.wrote(block);
    Ok(0)
}
