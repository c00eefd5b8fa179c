//! SFC 22 CREAT_DB: makes a data block.

use sieben_model::types::DataType;

use super::{Parameter, Row, Run, input, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(22, "CREAT_DB", PARAMETERS, Run::Value(|call| call.make_data_block(4).map(|_| 0)));

const PARAMETERS: &[Parameter] = &[
    input("LOW_LIMIT", DataType::Word),
    input("UP_LIMIT", DataType::Word),
    input("COUNT", DataType::Word),
    ret_val(),
    output("DB_NUMBER", DataType::Word),
];
