//! Protocol servers: how a running CPU is reached over a network.
#![forbid(unsafe_code)]

pub mod config;
pub mod metrics;
pub mod recording;
pub mod s7comm;
pub mod server;
