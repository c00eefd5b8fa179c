//! A campaign on the threads of this computer, and what is kept of it.

pub(crate) mod collected;
pub(crate) mod failing;
#[cfg(feature = "parquet")]
pub(crate) mod files;
pub(crate) mod said;
#[cfg(feature = "parquet")]
mod summary;
mod threads;

pub(crate) use threads::{Ended, Orders, run};
