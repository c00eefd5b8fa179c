//! The plant: simulated devices, scenarios.
#![forbid(unsafe_code)]

pub mod devices;
pub mod duration;
pub mod names;
pub mod scenario;
