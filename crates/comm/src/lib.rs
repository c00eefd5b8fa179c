//! Protocol servers: the way to a running CPU over the network.
#![forbid(unsafe_code)]

pub mod config;
