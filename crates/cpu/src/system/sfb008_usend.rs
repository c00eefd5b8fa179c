//! SFB 8 USEND: sends without waiting for the partner.

use sieben_model::types::DataType;

use super::connection::{self, Block};
use super::{Parameter, Row, in_out, input, output, sfb, stored};

pub(super) const ROW: Row = sfb(8, "USEND", VARIABLES, |call| connection::call(call, &BLOCK));

const VARIABLES: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("ID", DataType::Word),
    input("R_ID", DataType::DoubleWord),
    output("DONE", DataType::Bool),
    output("ERROR", DataType::Bool),
    output("STATUS", DataType::Word),
    in_out("SD_1", DataType::Any),
    in_out("SD_2", DataType::Any),
    in_out("SD_3", DataType::Any),
    in_out("SD_4", DataType::Any),
    stored("REQ_OLD", DataType::Bool),
];

const BLOCK: Block = Block { outputs: 8, remote: &[], local: &[12, 22, 32, 42], receives: false, length: None, edge: 52 };
