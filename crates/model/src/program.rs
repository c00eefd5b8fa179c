//! Data blocks as they are loaded into a CPU.

use crate::block::BlockId;
use crate::types::Structure;
use std::sync::Arc;

/// A data block: its layout and its bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct DataBlock {
    /// Its number, 1 to 65535.
    pub number: u16,
    /// What it is an instance of, or which UDT it has; `None` for a STRUCT of its own.
    pub based_on: Option<BlockId>,
    /// The fields, for names like `DB1.speed`.
    pub structure: Arc<Structure>,
    /// The bytes that the CPU starts with (actual values of the BEGIN section over initial values).
    pub image: Vec<u8>,
    /// READ_ONLY: the program may not write it.
    pub read_only: bool,
    /// NON_RETAIN: reset at a warm restart.
    pub non_retain: bool,
    /// UNLINKED: stays in load memory; opening it is an error.
    pub unlinked: bool,
}
