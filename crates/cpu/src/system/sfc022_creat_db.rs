//! SFC 22 CREAT_DB: makes a data block.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::created_data_blocks::{BAD_NUMBER, insert, place, room};
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(22, "CREAT_DB", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("LOW_LIMIT", DataType::Word),
    input("UP_LIMIT", DataType::Word),
    input("COUNT", DataType::Word),
    ret_val(),
    output("DB_NUMBER", DataType::Word),
];

/// The length is 0 or odd.
const BAD_LENGTH: u16 = 0x80A2;
const NO_NUMBER: u16 = 0x80B1;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let low = call.input(0, Width::Word)? as u16;
    let high = call.input(1, Width::Word)? as u16;
    let length = call.input(2, Width::Word)?;
    if low == 0 || low > high || high > call.machine.memory.layout.db_number_max {
        return Err(BAD_NUMBER);
    }
    if length == 0 || !length.is_multiple_of(2) {
        return Err(BAD_LENGTH);
    }
    let program = &call.host.program.data;
    let memory = &call.machine.memory;
    let free = |number: &u16| memory.data_block(u64::from(*number)).is_none() && !program.contains_key(number);
    let number = (low..=high).find(free).ok_or(NO_NUMBER)?;
    let base = place(call.machine, room(length))?;
    // A number that cannot be delivered must not leave a block behind.
    call.output(4, Width::Word, u32::from(number))?;
    insert(call.machine, number, base, length);
    Ok(0)
}
