//! The same IR as machine code, made by Cranelift: every block becomes one function of the native instruction set.
//!
//! Only `entry.rs` holds `unsafe`: it makes executable memory out of what the translator wrote and calls it.

mod ask;
mod entry;
mod handed;
mod jit;
mod passes;
mod run;
mod tiers;
mod translate;
mod turn;
mod written_out;

pub use jit::{Jit, StatusBits};
pub use passes::{Pass, PassSet};
pub use tiers::{Tier, Tiers};
