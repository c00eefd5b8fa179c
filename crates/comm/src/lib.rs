//! Protocol servers (none yet).
#![forbid(unsafe_code)]
