//! SFC 58 WR_REC: writes a data record of a module.

use sieben_model::types::DataType;

use super::{Parameter, Row, Run, input, output, records, ret_val, sfc};

pub(super) const ROW: Row = sfc(58, "WR_REC", PARAMETERS, Run::Value(|call| records::job(call, 4, 6, true)));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("IOID", DataType::Byte),
    input("LADDR", DataType::Word),
    input("RECNUM", DataType::Byte),
    input("RECORD", DataType::Any),
    ret_val(),
    output("BUSY", DataType::Bool),
];
