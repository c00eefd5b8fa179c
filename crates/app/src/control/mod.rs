//! The control socket of a run: where it lies, who serves it, and who asks there.

pub(crate) mod client;
mod place;
mod server;

pub(crate) use client::Client;
pub(crate) use server::Server;
