//! Tasks of the project as a library, so that tests can run them too.
#![forbid(unsafe_code)]
#![allow(clippy::print_stdout)] // A task talks to the person who started it.

pub mod aarch64;
pub mod ablate;
pub mod clients;
mod compatibility;
pub mod functions;
pub mod fuzz;
pub mod generate;
mod grammars;
mod limits;
pub mod markdown;
mod node;
pub mod programs;
pub mod signal_diagrams;
pub mod soak;
pub mod test;
pub mod tidy;
pub mod vscode;
pub mod web;
pub mod workspace;
