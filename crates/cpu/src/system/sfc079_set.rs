//! SFC 79 SET: sets a run of output bits.

use super::output_bits::{self, PARAMETERS};
use super::{Row, Run, sfc};

pub(super) const ROW: Row = sfc(79, "SET", PARAMETERS, Run::Value(|call| output_bits::write(call, true)));
