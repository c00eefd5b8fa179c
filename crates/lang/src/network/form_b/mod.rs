//! Form B: a diagram on one line, for input, messages and tests.
//!
//! `("Start" | "Pump") /"Stop" #(M 0.0) -> = "Pump"`: a space is AND, `|` in brackets OR, `/` a normally closed contact, `->` the outputs.

mod boxes;
mod parse;
mod pins;
mod print;
mod scan;
mod slips;

pub use parse::parse;
pub use print::print;
