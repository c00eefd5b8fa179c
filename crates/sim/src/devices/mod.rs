//! Simulated devices: one file each.

pub mod tank;

pub use tank::{Button, Tank, TankSettings};
