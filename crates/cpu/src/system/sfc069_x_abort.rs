//! SFC 69 X_ABORT: closes the connection to a partner on the MPI network.

use sieben_model::types::DataType;

use super::{Parameter, Row, Run, input, mpi_partner, output, ret_val, sfc};

pub(super) const ROW: Row = sfc(69, "X_ABORT", PARAMETERS, Run::Value(|call| mpi_partner::job(call, 1, 3, None)));

const PARAMETERS: &[Parameter] =
    &[input("REQ", DataType::Bool), input("DEST_ID", DataType::Word), ret_val(), output("BUSY", DataType::Bool)];
