//! SFB 52 RDREC: reads a data record of a module.

use sieben_model::types::DataType;

use super::dpv1::{self, Block};
use super::{Parameter, Row, in_out, input, output, sfb};

pub(super) const ROW: Row = sfb(52, "RDREC", VARIABLES, |call| dpv1::call(call, &BLOCK));

const VARIABLES: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("ID", DataType::DoubleWord),
    input("INDEX", DataType::Int),
    input("MLEN", DataType::Int),
    output("VALID", DataType::Bool),
    output("BUSY", DataType::Bool),
    output("ERROR", DataType::Bool),
    output("STATUS", DataType::DoubleWord),
    output("LEN", DataType::Int),
    in_out("RECORD", DataType::Any),
];

const BLOCK: Block = Block { function: 0xDE, record: 18, length: Some(16), reads: true };
