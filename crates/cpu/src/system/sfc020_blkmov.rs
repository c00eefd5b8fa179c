//! SFC 20 BLKMOV: copies an area.

use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(20, "BLKMOV", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("SRCBLK", DataType::Any), ret_val(), output("DSTBLK", DataType::Any)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let source = call.any(0, false)?;
    let destination = call.any(2, true)?;
    let bytes = source.len().min(destination.len());
    call.machine.memory.arena.copy_within(source.start..source.start + bytes, destination.start);
    call.wrote(destination.start..destination.start + bytes);
    Ok(0)
}
