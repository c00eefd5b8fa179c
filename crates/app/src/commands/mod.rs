//! The verbs, one file each.

pub(crate) mod assignments;
pub(crate) mod bench;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod demo;
pub(crate) mod exec;
pub(crate) mod explain;
pub(crate) mod fmt;
pub(crate) mod new;
pub(crate) mod record;
pub(crate) mod refs;
pub(crate) mod run;
pub(crate) mod step;
pub(crate) mod structure;
pub(crate) mod symbols;
pub(crate) mod test;
pub(crate) mod trace;
