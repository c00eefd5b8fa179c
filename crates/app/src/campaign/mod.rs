//! A campaign on the threads of this computer.

pub(crate) mod said;
mod threads;

pub(crate) use threads::{Ended, Orders, run};
