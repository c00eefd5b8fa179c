//! Where retentive data is kept: in files beside the project, so that neither a kill nor a power failure loses it.
//!
//! Two files, each with two slots that are written in turn, so that a cut write leaves the other slot:
//!
//! | file | written | survives |
//! |---|---|---|
//! | `retain.bin` | after every scan that changed something, before its outputs are released | the end of the process at any instant |
//! | `retain.bin.synced` | every `retain.sync` by a thread of its own, and brought to the disk | a power failure |
//!
//! One file would not do: between two syncs both its slots are written again, and a power failure could tear both.

mod arguments;
mod disk;
mod lock;
mod record;
mod retention;
mod slots;
mod store;
#[cfg(test)]
mod tests;

pub(crate) use arguments::{RetainArguments, RunTime, restart_argument};
pub(crate) use retention::Retention;
