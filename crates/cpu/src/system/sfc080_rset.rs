//! SFC 80 RSET: resets a run of output bits.

use super::output_bits::{self, PARAMETERS};
use super::{Row, Run, sfc};

pub(super) const ROW: Row = sfc(80, "RSET", PARAMETERS, Run::Value(|call| output_bits::write(call, false)));
