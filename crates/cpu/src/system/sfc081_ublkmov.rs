//! SFC 81 UBLKMOV: copies an area; no interrupt comes between.

use sieben_model::types::DataType;

use super::parameters::{Answer, Refused};
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(81, "UBLKMOV", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[input("SRCBLK", DataType::Any), ret_val(), output("DSTBLK", DataType::Any)];

/// So many bytes are copied at a time.
const BYTES_MAX: usize = 512;

/// The source is in a data block that is only in the load memory.
const SOURCE_UNLINKED: u16 = 0x8091;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let source = call.any(0, false).map_err(|code| if call.names_unlinked(0) { SOURCE_UNLINKED } else { code })?;
    let destination = call.any(2, true)?;
    let bytes = source.len().min(destination.len());
    if bytes > BYTES_MAX {
        return Err(Refused::LENGTH.of(0));
    }
    call.machine.memory.arena.copy_within(source.start..source.start + bytes, destination.start);
    call.wrote(destination.start..destination.start + bytes);
    Ok(0)
}
