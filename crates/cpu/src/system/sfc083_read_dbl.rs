//! SFC 83 READ_DBL: copies from a data block in the load memory.

use sieben_model::types::DataType;

use super::{Call, Parameter, Row, Run, input, load_memory, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(83, "READ_DBL", PARAMETERS, Run::Value(|call| load_memory::job(call, 83, run)));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("SRCBLK", DataType::Any),
    ret_val(),
    output("BUSY", DataType::Bool),
    output("DSTBLK", DataType::Any),
];

fn run(call: &mut Call<'_, '_>) -> Result<[usize; 2], u16> {
    let source = call.loaded(1, false)?;
    let destination = call.any(4, true)?;
    let lengths = [source.bytes.len(), destination.len()];
    let changed = call.host.system.load_memory.get(&source.number);
    let image = changed.or(call.host.program.data.get(&source.number).map(|block| &block.image));
    let bytes = image.and_then(|image| image.get(source.bytes)).unwrap_or_default();
    for (at, &byte) in destination.clone().zip(bytes) {
        call.machine.memory.arena[at] = byte;
    }
    call.host.written.push(destination.start..destination.end.min(destination.start + bytes.len()));
    Ok(lengths)
}
