//! The web page of a run: one port with the page itself, an interface over HTTP, a WebSocket for what is live, and the book.
#![forbid(unsafe_code)]

pub mod access;
mod clients;
mod forces;
mod http;
mod hub;
pub mod live;
mod past;
mod projects;
mod reference;
mod server;

pub use hub::PAGES_MAX;
pub use projects::{Listed, PROJECT, Projects};
pub use reference::{Reference, View};
pub use server::{MetricsText, Page, Setup, listen};

/// The port of the page, where none is named.
pub const PORT: u16 = 7300;
