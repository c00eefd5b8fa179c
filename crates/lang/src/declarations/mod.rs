//! From declarations to laid-out types, interfaces and data blocks.

pub(crate) mod data_block;
pub(crate) mod interface;
pub(crate) mod path;
pub(crate) mod types;
pub(crate) mod values;

/// Bytes a data block, structure or instance may have; with it every position in bits fits 32 bits.
pub(crate) const BLOCK_BYTES_MAX: u64 = 65_536;

/// STRUCTs, arrays, UDTs and instances inside one another; STEP 7 allows eight of a kind.
pub(crate) const NESTING_MAX: usize = 16;
