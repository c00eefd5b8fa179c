//! The registers that a call of a function block changes.

use sieben_engine::machine::Register;

use super::pointers::IN_DATA_BLOCK;

/// The variables of the DB and DI registers, pairwise.
pub(crate) const REGISTER_PAIRS: [(Register, Register); 3] =
    [(Register::DbNumber, Register::DiNumber), (Register::DbBase, Register::DiBase), (Register::DbLength, Register::DiLength)];

/// What AR2 holds in a function block called with its own instance: P#DBX 0.0.
pub(crate) const INSTANCE_START: u64 = IN_DATA_BLOCK as u64;
