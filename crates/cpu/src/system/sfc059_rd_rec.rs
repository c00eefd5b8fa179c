//! SFC 59 RD_REC: reads a data record of a module.

use sieben_model::types::DataType;

use super::{Parameter, Row, Run, input, output, records, ret_val, sfc};

pub(super) const ROW: Row = sfc(59, "RD_REC", PARAMETERS, Run::Value(|call| records::job(call, 6, 5, false)));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("IOID", DataType::Byte),
    input("LADDR", DataType::Word),
    input("RECNUM", DataType::Byte),
    ret_val(),
    output("BUSY", DataType::Bool),
    output("RECORD", DataType::Any),
];
