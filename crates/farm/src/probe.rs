//! Whether a worker could begin: what `--ready` asks.

use std::time::Duration;

use crate::connection::Connection;
use crate::error::FarmError;
use crate::server::Server;

/// Connects, looks for JetStream, and leaves.
pub fn ready(server: &Server) -> Result<(), FarmError> {
    runtime()?.block_on(Connection::open(server, "sieben ready", Duration::ZERO, &|| false)).map(|_| ())
}

/// What drives a connection: the thread that asks, and no other.
pub(crate) fn runtime() -> Result<tokio::runtime::Runtime, FarmError> {
    tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(|error| FarmError::System(error.to_string()))
}
