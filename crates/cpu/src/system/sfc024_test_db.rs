//! SFC 24 TEST_DB: length and write protection of a data block.

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::data_blocks::NOT_THERE;
use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(24, "TEST_DB", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] =
    &[input("DB_NUMBER", DataType::Word), ret_val(), output("DB_LENGTH", DataType::Word), output("WRITE_PROT", DataType::Bool)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let number = call.db_number()?;
    let entry = call.machine.memory.data_block(u64::from(number)).ok_or(NOT_THERE)?;
    call.output(2, Width::Word, entry.length)?;
    call.output(3, Width::Bit, u32::from(entry.read_only))?;
    Ok(0)
}
