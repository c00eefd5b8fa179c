//! Statements → typed tree: names, types, conversions, calls, and what is wrong with them.

pub mod names;
