//! SFB 9 URCV: receives what USEND sends.

use sieben_model::types::DataType;

use super::connection::{self, Block};
use super::{Parameter, Row, in_out, input, output, sfb, stored};

pub(super) const ROW: Row = sfb(9, "URCV", VARIABLES, |call| connection::call(call, &BLOCK));

const VARIABLES: &[Parameter] = &[
    input("EN_R", DataType::Bool),
    input("ID", DataType::Word),
    input("R_ID", DataType::DoubleWord),
    output("NDR", DataType::Bool),
    output("ERROR", DataType::Bool),
    output("STATUS", DataType::Word),
    in_out("RD_1", DataType::Any),
    in_out("RD_2", DataType::Any),
    in_out("RD_3", DataType::Any),
    in_out("RD_4", DataType::Any),
    stored("EN_R_OLD", DataType::Bool),
];

const BLOCK: Block = Block { outputs: 8, remote: &[], local: &[12, 22, 32, 42], receives: true, length: None, edge: 52 };
