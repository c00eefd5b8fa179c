//! The library: how its blocks come into a program, and each against a second model.

mod call;
mod cost;
mod dates;
mod link;
mod numbers;
#[path = "../strict/mod.rs"]
mod strict;
mod strings;
