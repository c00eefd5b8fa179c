//! SFC 68 X_PUT: writes a variable of a partner on the MPI network.

use sieben_model::types::DataType;

use super::{Parameter, Row, Run, input, mpi_partner, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(68, "X_PUT", PARAMETERS, Run::Value(|call| mpi_partner::job(call, 2, 6, Some((4, false)))));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("CONT", DataType::Bool),
    input("DEST_ID", DataType::Word),
    input("VAR_ADDR", DataType::Any),
    input("SD", DataType::Any),
    ret_val(),
    output("BUSY", DataType::Bool),
];
