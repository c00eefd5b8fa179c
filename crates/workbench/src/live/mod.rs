//! What pages see of a run, scan by scan: their wishes, what a scan holds for all of them, and what each of them is sent.
//!
//! Nothing here knows a socket or a clock: frames and times come in as arguments.

pub mod client;
pub mod content;
pub mod fuzz;
pub mod message;
pub mod program;
pub mod shot;
pub mod wanted;
