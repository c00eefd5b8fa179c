//! What each instruction does, by the chapters of the manual.

pub(crate) mod accumulators;
pub(crate) mod address_registers;
pub(crate) mod bit_logic;
pub(crate) mod compare;
pub(crate) mod conversion;
pub(crate) mod counters;
pub(crate) mod data_blocks;
pub(crate) mod extension;
pub(crate) mod integer_math;
pub(crate) mod jumps;
pub(crate) mod load_transfer;
pub(crate) mod logic_control;
pub(crate) mod mcr;
pub(crate) mod null;
pub(crate) mod real_math;
pub(crate) mod shift_rotate;
pub(crate) mod timers;
pub(crate) mod word_logic;

/// A row of the instruction table accepts only operands that its meaning knows.
const WRONG_OPERAND: &str = "the row's operand class accepts only operands that its meaning knows";
