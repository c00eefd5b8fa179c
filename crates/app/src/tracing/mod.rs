//! Traces beside files: where they are kept, what is written of them.

pub(crate) mod file;
pub(crate) mod output;
pub(crate) mod scenario;
