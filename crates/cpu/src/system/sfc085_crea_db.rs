//! SFC 85 CREA_DB: makes a data block with attributes.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(85, "CREA_DB", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("LOW_LIMIT", DataType::Word),
    input("UP_LIMIT", DataType::Word),
    input("COUNT", DataType::Word),
    input("ATTRIB", DataType::Byte),
    ret_val(),
    output("DB_NUM", DataType::Word),
];

/// ATTRIB has another bit than these two. UNLINKED is one too: such a block would lie nowhere.
const BAD_ATTRIBUTE: u16 = 0x80A3;
const READ_ONLY: u32 = 0x02;
const NON_RETAIN: u32 = 0x04;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let attributes = call.input(3, Width::Byte)?;
    if attributes & !(READ_ONLY | NON_RETAIN) != 0 {
        return Err(BAD_ATTRIBUTE);
    }
    let number = call.make_data_block(5)?;
    if let Some(Some(entry)) = call.machine.memory.data_blocks.get_mut(usize::from(number)) {
        entry.read_only = attributes & READ_ONLY != 0;
    }
    if attributes & NON_RETAIN != 0 {
        call.host.system.non_retain.insert(number);
    }
    Ok(0)
}
