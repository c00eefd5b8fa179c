//! The plant: simulated devices, their faults, scenarios, traces, unit tests.
#![forbid(unsafe_code)]

pub mod devices;
pub mod duration;
pub mod history;
pub mod names;
pub mod runner;
pub mod scenario;
pub mod timing_diagram;
pub mod trace;
pub mod wrap;
