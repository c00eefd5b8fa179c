//! SFC 50 RD_LGADR: all logical addresses of a module.

use std::ops::Range;

use sieben_model::address::Width;
use sieben_model::types::DataType;

use super::parameters::Answer;
use super::{Call, Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(50, "RD_LGADR", PARAMETERS, Run::Value(run));

const PARAMETERS: &[Parameter] = &[
    input("IOID", DataType::Byte),
    input("LADDR", DataType::Word),
    ret_val(),
    output("PEADDR", DataType::Any),
    output("PECOUNT", DataType::Int),
    output("PAADDR", DataType::Any),
    output("PACOUNT", DataType::Int),
];

/// The ANY is not one of WORD: PEADDR, PAADDR.
const NOT_WORD: [u16; 2] = [0x80A0, 0x80A1];
/// There is no room for all addresses: PEADDR, PAADDR.
const TOO_SHORT: [u16; 2] = [0x80A2, 0x80A3];
/// The type code of WORD in an ANY.
const WORD: u8 = 0x04;

fn run(call: &mut Call<'_, '_>) -> Answer {
    let (found, ..) = call.addressed(0)?;
    let addresses = [found.bytes(false), found.bytes(true)];
    let mut fields: Vec<Range<usize>> = Vec::new();
    for (index, bytes) in addresses.iter().enumerate() {
        let [_, code, ..] = call.passed::<10>(3 + 2 * index, true)?;
        if code != WORD {
            return Err(NOT_WORD[index]);
        }
        let field = call.any(3 + 2 * index, true)?;
        if field.len() / 2 < bytes.len() {
            return Err(TOO_SHORT[index]);
        }
        fields.push(field);
    }
    for ((index, bytes), field) in addresses.into_iter().enumerate().zip(fields) {
        let count = bytes.len() as u32;
        call.wrote(field.start..field.start + 2 * bytes.len());
        for (address, at) in bytes.zip(field.step_by(2)) {
            call.machine.memory.write_at(at, 0, Width::Word, address);
        }
        call.output(4 + 2 * index, Width::Word, count)?;
    }
    Ok(0)
}
