//! SFC 62 CONTROL: the state of the connection of a communication block.

use sieben_model::address::Width;
use sieben_model::block::BlockKind;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(62, "CONTROL", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("EN_R", DataType::Bool),
    input("I_DB", DataType::BlockData),
    input("OFFSET", DataType::Word),
    ret_val(),
    output("ERROR", DataType::Bool),
    output("STATUS", DataType::Word),
    output("I_TYP", DataType::Byte),
    output("I_STATE", DataType::Byte),
    output("I_CONN", DataType::Bool),
    output("I_STATUS", DataType::Word),
];

/// The data block is not loaded or shorter than OFFSET.
const NO_ACCESS: u32 = 10;
/// The data block is no instance of a communication block.
const NO_INSTANCE: u32 = 12;
/// STATUS of a job without a configured connection.
const NO_CONNECTION: u32 = 1;

/// Communication blocks by number, with their codes in I_TYP.
const BLOCKS: &[(u16, u32)] = &[(8, 0x00), (9, 0x01), (12, 0x04), (13, 0x05), (14, 0x06), (15, 0x07)];

fn run(call: &mut Call<'_, '_>) -> Answer {
    let enabled = call.input(0, Width::Bit)? == 1;
    let number = call.block_number(1)?;
    let offset = call.input(2, Width::Word)?;
    let (status, kind) = if enabled { look(call, number, offset) } else { (0, None) };
    call.output(4, Width::Bit, u32::from(status != 0))?;
    call.output(5, Width::Word, status)?;
    if let Some(kind) = kind {
        call.output(6, Width::Byte, kind)?;
        // The job state is "disabled": without a connection nothing has begun.
        call.output(7, Width::Byte, 0)?;
        call.output(8, Width::Bit, 0)?;
        call.output(9, Width::Word, NO_CONNECTION)?;
    }
    Ok(0)
}

/// STATUS, and the code of the block whose instance it is.
fn look(call: &Call<'_, '_>, number: u16, offset: u32) -> (u32, Option<u32>) {
    let Some(entry) = call.machine.memory.data_block(u64::from(number)) else { return (NO_ACCESS, None) };
    if offset >= entry.length {
        return (NO_ACCESS, None);
    }
    let based_on = call.host.program.data.get(&number).and_then(|block| block.based_on);
    let block = based_on.filter(|block| block.kind == BlockKind::SystemFunctionBlock);
    match block.and_then(|block| BLOCKS.iter().find(|row| row.0 == block.number)) {
        Some(&(_, code)) => (0, Some(code)),
        None => (NO_INSTANCE, None),
    }
}
