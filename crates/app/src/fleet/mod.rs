//! A fleet on the threads of this computer.

pub(crate) mod said;
mod threads;

pub(crate) use threads::{Orders, Ran, run};
