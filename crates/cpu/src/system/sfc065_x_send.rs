//! SFC 65 X_SEND: sends to a partner on the MPI network.

use sieben_model::types::DataType;

use super::{Parameter, Row, Run, input, mpi_partner, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(65, "X_SEND", PARAMETERS, Run::Value(|call| mpi_partner::job(call, 2, 6, Some((4, false)))));

const PARAMETERS: &[Parameter] = &[
    input("REQ", DataType::Bool),
    input("CONT", DataType::Bool),
    input("DEST_ID", DataType::Word),
    input("REQ_ID", DataType::DoubleWord),
    input("SD", DataType::Any),
    ret_val(),
    output("BUSY", DataType::Bool),
];
