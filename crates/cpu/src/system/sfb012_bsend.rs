//! SFB 12 BSEND: sends a block of up to 64 KB, part by part.

use sieben_model::types::DataType;

use super::connection::{self, Block};
use super::{Parameter, Row, in_out, input, output, sfb, stored};

pub(super) const ROW: Row = sfb(12, "BSEND", VARIABLES, |call| connection::call(call, &BLOCK));

const VARIABLES: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("R", DataType::Bool),
    input("ID", DataType::Word),
    input("R_ID", DataType::DoubleWord),
    output("DONE", DataType::Bool),
    output("ERROR", DataType::Bool),
    output("STATUS", DataType::Word),
    in_out("SD_1", DataType::Any),
    in_out("LEN", DataType::Word),
    stored("REQ_OLD", DataType::Bool),
];

const BLOCK: Block = Block { outputs: 8, remote: &[], local: &[12], receives: false, length: Some(22), edge: 24 };
