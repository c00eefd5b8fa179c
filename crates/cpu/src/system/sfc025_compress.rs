//! SFC 25 COMPRESS: closes the gaps that deleted data blocks left.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::data_blocks::for_each_open;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, output, ret_val, sfc};
use crate::created_data_blocks::{room, taken};

pub(super) const ROW: Row = sfc(25, "COMPRESS", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[ret_val(), output("BUSY", DataType::Bool), output("DONE", DataType::Bool)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let mut cursor = call.machine.memory.reserve().start;
    for (base, number) in taken(call.machine) {
        let Some(Some(entry)) = call.machine.memory.data_blocks.get_mut(usize::from(number)) else { continue };
        entry.base = cursor as u32;
        let bytes = entry.length as usize;
        call.machine.memory.arena.copy_within(base..base + bytes, cursor);
        for_each_open(call.machine, |open, base| {
            if open == u64::from(number) {
                *base = cursor as u64;
            }
        });
        cursor += room(bytes as u32);
    }
    // Done within the call.
    call.output(1, Width::Bit, 0)?;
    call.output(2, Width::Bit, 1)?;
    Ok(0)
}
