//! SFC 67 X_GET: reads a variable of a partner on the MPI network.

use sieben_model::types::DataType;

use super::{Parameter, Row, Run, input, mpi_partner, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(67, "X_GET", PARAMETERS, Run::Value(|call| mpi_partner::job(call, 2, 5, Some((6, true)))));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("CONT", DataType::Bool),
    input("DEST_ID", DataType::Word),
    input("VAR_ADDR", DataType::Any),
    ret_val(),
    output("BUSY", DataType::Bool),
    output("RD", DataType::Any),
];
