//! SFB 15 PUT: writes data of the partner.

use sieben_model::types::DataType;

use super::connection::{self, Block};
use super::{Parameter, Row, in_out, input, output, sfb, stored};

pub(super) const ROW: Row = sfb(15, "PUT", VARIABLES, |call| connection::call(call, &BLOCK));

const VARIABLES: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("ID", DataType::Word),
    output("DONE", DataType::Bool),
    output("ERROR", DataType::Bool),
    output("STATUS", DataType::Word),
    in_out("ADDR_1", DataType::Any),
    in_out("ADDR_2", DataType::Any),
    in_out("ADDR_3", DataType::Any),
    in_out("ADDR_4", DataType::Any),
    in_out("SD_1", DataType::Any),
    in_out("SD_2", DataType::Any),
    in_out("SD_3", DataType::Any),
    in_out("SD_4", DataType::Any),
    stored("REQ_OLD", DataType::Bool),
];

const BLOCK: Block = Block { outputs: 4, remote: &[8, 18, 28, 38], local: &[48, 58, 68, 78], receives: false, length: None, edge: 88 };
