//! Bytes of the protocol and what they mean, layer by layer. Every slice is checked: nothing that comes from a network panics here.
//!
//! A group of userdata has a file with `read` (the request as a job, by its subfunction and the bytes after `FF 09` and the length) and `write` (the
//! answer to that job as [`userdata::Content`]); the envelope and the fragments are in `userdata`.

pub mod block_image;
pub mod blocks;
pub mod clock;
pub mod codes;
pub mod cotp;
pub mod header;
pub mod names;
pub mod security;
pub mod services;
pub mod setup;
pub mod system_status;
pub mod tpkt;
pub mod transfer;
pub mod userdata;
pub mod variables;

/// What came is not this protocol, or breaks it so that nothing after it can be read: the connection is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Broken;

/// Whether more pieces of the same thing follow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum More {
    /// It is the last one.
    #[default]
    None,
    /// More follow.
    Follow,
}
