//! SFC 49 LGC_GADR: the slot of a logical address.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(49, "LGC_GADR", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("IOID", DataType::Byte),
    input("LADDR", DataType::Word),
    ret_val(),
    output("AREA", DataType::Byte),
    output("RACK", DataType::Word),
    output("SLOT", DataType::Word),
    output("SUBADDR", DataType::Word),
];

/// AREA of the central racks of an S7-400 and of an S7-300.
const CENTRAL_400: u32 = 0;
const CENTRAL_300: u32 = 1;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let (found, output, byte) = call.addressed(0)?;
    let offset = byte - found.bytes(output).start;
    let slot = u32::from(found.slot);
    let area = if call.host.cpu_type.accumulators == 4 { CENTRAL_400 } else { CENTRAL_300 };
    call.output(3, Width::Byte, area)?;
    call.output(4, Width::Word, 0)?;
    call.output(5, Width::Word, slot)?;
    call.output(6, Width::Word, offset)?;
    Ok(0)
}
