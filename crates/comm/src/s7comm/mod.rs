//! S7 communication over ISO-on-TCP (RFC 1006): what HMIs, SCADA systems and programming devices speak with an S7-300 or S7-400.
//!
//! `wire` turns bytes into meaning and back, `session` keeps the state of one connection, `answer` does what a job asks for. None of them does I/O;
//! time is an argument.

pub mod answer;
pub mod fuzz;
pub mod guard;
pub mod job;
pub mod session;
pub mod wire;
