//! SFB 53 WRREC: writes a data record of a module.

use sieben_model::types::DataType;

use super::dpv1::{self, Block};
use super::{Parameter, Row, in_out, input, output, sfb};

pub(super) const ROW: Row = sfb(53, "WRREC", VARIABLES, |call| dpv1::call(call, &BLOCK));

const VARIABLES: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("ID", DataType::DoubleWord),
    input("INDEX", DataType::Int),
    input("LEN", DataType::Int),
    output("DONE", DataType::Bool),
    output("BUSY", DataType::Bool),
    output("ERROR", DataType::Bool),
    output("STATUS", DataType::DoubleWord),
    in_out("RECORD", DataType::Any),
];

const BLOCK: Block = Block { function: 0xDF, record: 16, length: None, reads: false };
