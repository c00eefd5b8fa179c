//! A project at work: its texts and what comes of them, a session with its run, its tests, and the way in for everyone who looks and acts from
//! outside.
//!
//! No files, no terminal, no clock, no threads: texts come in as bytes, time comes in as a function, an engine as what loads a program; `app`
//! starts the threads that call in here.
#![forbid(unsafe_code)]

pub mod campaign;
pub mod control;
pub mod controller;
pub mod coverage;
pub mod diagnosed;
pub mod driver;
pub mod duration;
pub mod exchange;
pub mod failed;
pub mod finding;
pub mod fleet;
pub mod gate;
mod last_change;
pub mod local_check;
pub mod metrics;
pub mod names;
pub mod observed;
pub mod online_change;
pub mod pace;
pub mod past;
pub mod places;
pub mod project;
pub mod refusal;
pub mod scan_times;
pub mod schedule;
pub mod session;
pub mod settings;
pub mod status;
pub mod testing;
pub mod tracing;
pub mod watch_table;
pub mod xml;

pub use driver::{Driver, End, Surroundings};
pub use gate::{Closed, Gate, Plant};
pub use pace::{Pace, Speed};
pub use refusal::Refusal;
