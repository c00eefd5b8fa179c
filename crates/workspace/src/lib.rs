//! A project at work: the run of its CPU, and the way in for everyone who looks and acts from outside.
//!
//! No files, no terminal, no clock, no threads: time comes in as a function, `app` starts the threads that call in here.
#![forbid(unsafe_code)]

pub mod control;
pub mod driver;
pub mod gate;
pub mod pace;
pub mod status;

pub use driver::{Driver, End, Surroundings};
pub use gate::{Closed, Gate, Plant};
pub use pace::{Pace, Speed};
