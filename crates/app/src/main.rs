//! The command line of Sieben.
#![forbid(unsafe_code)]

fn main() {}
