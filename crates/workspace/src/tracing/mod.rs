//! Traces and recordings of a project as data: what is recorded, and what they run with.

pub mod channels;
pub mod scenario;
