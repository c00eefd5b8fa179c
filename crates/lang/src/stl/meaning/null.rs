//! Null operations.

/// `NOP 0`, `NOP 1`, `BLD`.
pub(crate) fn nothing() {}
