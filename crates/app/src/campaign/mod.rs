//! A campaign on the threads of this computer, and what is kept of it.

pub(crate) mod collected;
pub(crate) mod failing;
#[cfg(feature = "nats")]
pub(crate) mod farmed;
#[cfg(feature = "parquet")]
pub(crate) mod files;
mod parts;
#[cfg(feature = "parquet")]
pub(crate) mod report;
pub(crate) mod said;
#[cfg(feature = "parquet")]
pub(crate) mod summary;
mod threads;

pub(crate) use threads::{Ended, Orders, run};

/// The scenario at which the process aborts, as if it were killed: for tests.
pub(crate) fn abort() -> Option<u64> {
    std::env::var("SIEBEN_CAMPAIGN_ABORT").ok()?.parse().ok()
}
