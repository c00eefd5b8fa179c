//! The same IR as machine code, made by Cranelift: every block becomes one function of the native instruction set.
//!
//! Only `entry.rs` holds `unsafe`: it makes executable memory out of what the translator wrote and calls it.

mod deoptimization;
mod entry;
mod jit;
mod passes;
mod run;
mod runtime_calls;
mod stack_lifetimes;
mod tiers;
mod translate;
mod unrolling;

pub use jit::{Jit, StatusBits};
pub use passes::{Pass, PassSet};
pub use tiers::{Tier, Tiers};
