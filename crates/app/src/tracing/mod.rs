//! Traces beside files: what is recorded, where it is kept, what is written of it.

pub(crate) mod channels;
pub(crate) mod file;
pub(crate) mod output;
pub(crate) mod scenario;
