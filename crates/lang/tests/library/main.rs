//! The library: how its blocks come into a program, and each against a second model.

mod call;
mod dates;
mod link;
#[path = "../strict/mod.rs"]
mod strict;
mod strings;
