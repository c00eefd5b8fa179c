//! Ranges of a campaign over NATS JetStream: numbers of scenarios go out, bytes come back.
//!
//! The queue is a hint, the [`Ledger`] of the run is the truth: a message that is lost costs time and nothing else, a result that comes twice is
//! the same bytes. What a scenario is, and what its bytes mean, is known to the caller alone.
#![forbid(unsafe_code)]

mod connection;
mod error;
pub mod fuzz;
mod ledger;
mod message;
mod names;
mod options;
mod probe;
mod ranges;
mod run;
mod server;
mod store;
mod worker;
mod workers;

pub use error::FarmError;
pub use ledger::{Alarm, Announced, Came, Finished, Ledger};
pub use options::Options;
pub use probe::ready;
pub use run::run;
pub use server::Server;
pub use worker::{Done, News, Offer, Opener, Work, WorkerOrders, work};
pub use workers::Workers;
