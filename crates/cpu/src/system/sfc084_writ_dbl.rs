//! SFC 84 WRIT_DBL: copies into a data block in the load memory.

use sieben_model::types::DataType;

use super::{Call, Parameter, Row, Run, input, load_memory, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(84, "WRIT_DBL", PARAMETERS, Run::Value(|call| load_memory::job(call, 84, run)));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("SRCBLK", DataType::Any),
    ret_val(),
    output("BUSY", DataType::Bool),
    output("DSTBLK", DataType::Any),
];

fn run(call: &mut Call<'_, '_>) -> Result<[usize; 2], u16> {
    let source = call.any(1, false)?;
    let destination = call.loaded(4, true)?;
    let lengths = [source.len(), destination.bytes.len()];
    let program = call.host.program;
    let original = || program.data.get(&destination.number).map(|block| block.image.clone()).unwrap_or_default();
    let image = call.host.system.load_memory.entry(destination.number).or_insert_with(original);
    for (at, &byte) in destination.bytes.zip(&call.machine.memory.arena[source]) {
        image[at] = byte;
    }
    Ok(lengths)
}
