//! Text → checked program → IR.
#![forbid(unsafe_code)]

pub mod encoding;
pub mod project;
pub mod stl;
pub mod symbols;

pub use project::{Compiled, Options, SystemBlock, compile};
