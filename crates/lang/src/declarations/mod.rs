//! From declarations to laid-out types, interfaces and data blocks.

pub(crate) mod data_block;
pub(crate) mod interface;
pub(crate) mod reuse;
pub(crate) mod system;
pub(crate) mod types;
pub(crate) mod values;

/// Bytes a data block, structure or instance may have; with it every position in bits fits 32 bits.
pub(crate) const BLOCK_BYTES_MAX: u64 = 65_536;

/// Steps from a type to the types inside it; STEP 7 allows eight structures inside one another, and a step of each kind counts here.
pub(crate) const NESTING_MAX: usize = 32;
