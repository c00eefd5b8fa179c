//! The web page of a run: one port with the page itself, an interface over HTTP, a WebSocket for what is live, and the book.
#![forbid(unsafe_code)]

use std::sync::{Mutex, MutexGuard, PoisonError};

pub mod access;
mod changes;
mod clients;
mod cpu;
mod forces;
mod http;
mod hub;
pub mod live;
mod moment;
mod past;
mod projects;
mod reference;
mod server;
mod stacks;
mod stepping;

pub use hub::PAGES_MAX;
pub use live::program::word;
pub use projects::{Listed, PROJECT, Projects};
pub use reference::{Reference, View};
pub use server::{MetricsText, Page, Setup, listen};

/// The port of the page, where none is named.
pub const PORT: u16 = 7300;

/// A hash of bytes that is the same in every run: FNV-1a.
fn fnv_1a(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xCBF2_9CE4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3))
}

/// A lock holds plain data: what a thread that panicked has left is still used.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
